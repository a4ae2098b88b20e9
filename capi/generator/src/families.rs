//! Commands that differ from one method only in the number and type of their arguments (2.7 of the specification).

/// A family: `glColor` + `3` + `ub` + `v`.
pub struct Family {
    /// The command's name up to the number.
    pub prefix: &'static str,
    /// The method that takes all of them.
    pub method: &'static str,
    /// Arguments before the values, passed as they are.
    pub lead: usize,
    /// What the values that were not given read as.
    pub fill: &'static [f32],
    /// Numbers of values that a name may give; a single one may be left out of the name.
    pub counts: &'static [usize],
    /// Integers are mapped to [0, 1] or [-1, 1] (table 2.9).
    pub normalized: bool,
}

const COORDINATE: &[f32] = &[0.0, 0.0, 0.0, 1.0];

const fn family(
    prefix: &'static str,
    method: &'static str,
    lead: usize,
    fill: &'static [f32],
    counts: &'static [usize],
    normalized: bool,
) -> Family {
    Family { prefix, method, lead, fill, counts, normalized }
}

/// All families. A longer prefix comes before a shorter one that it starts with.
pub const FAMILIES: &[Family] = &[
    family("glVertexAttrib", "vertex_attrib", 1, COORDINATE, &[1, 2, 3, 4], false),
    family("glVertex", "vertex", 0, COORDINATE, &[2, 3, 4], false),
    family("glColor", "color", 0, &[1.0; 4], &[3, 4], true),
    family("glSecondaryColor", "secondary_color", 0, &[0.0; 3], &[3], true),
    family("glNormal", "normal", 0, &[0.0; 3], &[3], true),
    family("glTexCoord", "tex_coord", 0, COORDINATE, &[1, 2, 3, 4], false),
    family("glMultiTexCoord", "multi_tex_coord", 1, COORDINATE, &[1, 2, 3, 4], false),
    family("glFogCoord", "fog_coord", 0, &[0.0], &[1], false),
    family("glIndex", "index", 0, &[0.0], &[1], false),
    family("glRasterPos", "raster_pos", 0, COORDINATE, &[2, 3, 4], false),
    family("glWindowPos", "window_pos", 0, &[0.0; 3], &[2, 3], false),
    family("glRect", "rect", 0, &[0.0; 4], &[4], false),
    family("glEvalCoord1", "eval_coord1", 0, &[0.0], &[1], false),
    family("glEvalCoord2", "eval_coord2", 0, &[0.0; 2], &[2], false),
    family("glTranslate", "translate", 0, &[0.0; 3], &[3], false),
    family("glScale", "scale", 0, &[0.0; 3], &[3], false),
    family("glRotate", "rotate", 0, &[0.0; 4], &[4], false),
];

/// A member of a family, taken apart.
pub struct Member {
    /// Its family.
    pub family: &'static Family,
    /// Values that the caller gives.
    pub count: usize,
    /// Integers are normalised.
    pub normalized: bool,
    /// Letters of the type: `ub`, `f`...
    pub letters: String,
    /// Passed through a pointer.
    pub vector: bool,
}

/// Takes a name apart; `None` if it belongs to no family.
pub fn member(name: &str) -> Option<Member> {
    let name = ["ARB", "EXT", "MESA", "NV"].iter().find_map(|s| name.strip_suffix(s)).unwrap_or(name);
    for family in FAMILIES {
        let Some(rest) = name.strip_prefix(family.prefix) else { continue };
        let (count, rest) = match rest.chars().next().and_then(|c| c.to_digit(10)) {
            Some(digit) => (digit as usize, &rest[1..]),
            None => (*family.counts.last()?, rest),
        };
        if !family.counts.contains(&count) {
            continue;
        }
        let (normalized, rest) = match rest.strip_prefix('N') {
            Some(rest) if family.method == "vertex_attrib" => (true, rest),
            _ => (family.normalized, rest),
        };
        let (letters, vector) = match rest.strip_suffix('v') {
            Some(letters) => (letters, true),
            None => (rest, false),
        };
        if ["b", "s", "i", "ub", "us", "ui", "f", "d"].contains(&letters) {
            return Some(Member { family, count, normalized, letters: letters.to_string(), vector });
        }
    }
    None
}

/// Rust type of a family's letters.
pub fn letter_type(letters: &str) -> &'static str {
    match letters {
        "b" => "i8",
        "s" => "i16",
        "i" => "i32",
        "ub" => "u8",
        "us" => "u16",
        "ui" => "u32",
        "d" => "f64",
        _ => "f32",
    }
}

/// One value as `f32`.
pub fn value(text: &str, letters: &str, normalized: bool) -> String {
    match letters {
        "f" => text.to_string(),
        "d" => format!("{text} as f32"),
        _ if normalized => format!("normalized::{}({text})", letter_type(letters)),
        _ => format!("{text} as f32"),
    }
}
