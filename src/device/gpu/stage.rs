//! The kernels that know nothing of fragment programs: what each is made of.

use std::fmt::Write;

use super::adapter::Shape;
use super::fine::color_flags;
use super::source::{File, Options, expand, files};
use crate::device::ColorFormat;
use crate::program::Program;

/// Lanes that work together where a SIMD register holds eight: a set of them is a subgroup.
const TEAM_LANES: u32 = 8;
/// Lanes of the set-up stages on a GPU.
const FRONT_LANES: u32 = 256;
/// Primitives of a lane's run where a workgroup is one SIMD register wide.
const RUN: u32 = 8;
/// Lanes of the visible path's workgroups.
pub const VISIBLE_LANES: u32 = 128;
/// Blocks of large triangles that a workgroup of the visible path draws in a round: a lane sets each up.
pub const LARGE_ITEMS: u32 = 32;
/// Rows that a lane of the clear kernel clears.
pub const CLEAR_ROWS: u32 = 8;
/// Vertices of a block of the vertex stage.
pub const VERTEX_BLOCK: u32 = 64;

/// A kernel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Stage {
    /// How many triangles each primitive makes. See [`front`].
    Cull(u32),
    /// Where they go.
    Offsets,
    /// Primitives inside the view volume.
    Setup(u32),
    /// All others.
    Clip(u32),
    /// Whether pixels have several samples.
    Bin(bool),
    Count,
    Scan,
    Emit,
    /// See `Bin`.
    Tile(bool),
    Active,
    /// To the next part of the lists.
    Round,
    /// Words of a colour pixel.
    Clear(u32),
    /// The samples of pixels with such colours become one.
    Resolve(ColorFormat),
    /// A kernel of the visible path.
    Visible(Visible, Offers),
}

/// The kernels of the visible path that know nothing of fragment programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Visible {
    Small,
    Clip,
    Large,
    End,
}

/// What the keys of a segment are made of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Offers {
    /// The depth function is LEQUAL, not LESS.
    pub lequal: bool,
    /// Bits of depth.
    pub depth_bits: u32,
    /// The host has set up triangles with a polygon offset.
    pub offset: bool,
    /// The vertex program, where no two triangles share a vertex: see `shaders/shaded.wgsl`.
    pub soup: Option<u64>,
}

/// What the kernels of set-up contain.
pub mod front {
    /// Some draw is of points or lines.
    pub const POINTS_AND_LINES: u32 = 1;
    /// Some polygon is drawn by its outline or corners.
    pub const UNFILLED: u32 = 1 << 1;
    /// Some points or lines are antialiased.
    pub const SMOOTH: u32 = 1 << 2;
    /// Some polygon is offset.
    pub const OFFSET: u32 = 1 << 3;
}

impl Stage {
    /// It belongs to the front end: its bindings are those of `shaders/front.wgsl`.
    pub fn is_front(self) -> bool {
        matches!(self, Stage::Cull(_) | Stage::Offsets | Stage::Setup(_) | Stage::Clip(_))
    }

    /// It reads or writes the words of later dispatches.
    pub fn is_indirect(self) -> bool {
        matches!(self, Stage::Offsets | Stage::Scan | Stage::Active | Stage::Round | Stage::Clear(_) | Stage::Visible(Visible::End, ..))
    }

    /// Its text. `soup`: the vertex program, where the stage runs it.
    pub fn source(self, shape: Shape, soup: Option<&Program>, constants: &str) -> String {
        let mut options = Options::default();
        shape_flags(&mut options, shape);
        let wide = shape.vectors();
        let mut lanes = shape.list_lanes;
        // Lanes of a workgroup that is one set of lanes that work together.
        let team = |wide_lanes: u32| if wide { wide_lanes } else { TEAM_LANES };
        let mut extra = String::new();
        let mut features = 0;
        let parts: &[File] = match self {
            Stage::Cull(f) => {
                (features, lanes) = (f, team(FRONT_LANES));
                &[files::SCREEN, files::PRIMITIVE, files::CULL]
            }
            Stage::Setup(f) => {
                (features, lanes) = (f, team(FRONT_LANES));
                &[files::SCREEN, files::PRIMITIVE, files::CORNER, files::POINT_LINE, files::SETUP, files::INSIDE]
            }
            Stage::Clip(f) => {
                features = f;
                &[files::SCREEN, files::PRIMITIVE, files::CORNER, files::POLYGON, files::POINT_LINE, files::SETUP, files::CLIP]
            }
            Stage::Offsets => {
                lanes = team(256);
                &[files::OFFSETS]
            }
            Stage::Bin(samples) => {
                options.flag("ATOMIC_LISTS", true);
                options.flag("SAMPLES", samples);
                &[files::BIN]
            }
            Stage::Count => &[files::COUNT],
            Stage::Scan => {
                lanes = team(256);
                &[files::SCAN]
            }
            Stage::Emit => &[files::EMIT],
            Stage::Tile(samples) => {
                lanes = team(lanes) * shape.teams();
                options.flag("SAMPLES", samples);
                &[files::IN_BIN, files::TILE]
            }
            Stage::Resolve(color) => {
                color_flags(&mut options, color);
                &[files::COLOR, files::RESOLVE]
            }
            Stage::Visible(which, offers) => {
                options.flag("VISIBLE", true);
                options.flag("INT64", true);
                options.flag("SET_UP", shape.host_front);
                options.flag("LEQUAL", offers.lequal);
                let _ = writeln!(extra, "const TP_DEPTH_SCALE = {}.0;", (1u64 << offers.depth_bits) - 1);
                features = if offers.offset { front::OFFSET } else { 0 };
                if which != Visible::Small || !shape.host_front {
                    lanes = VISIBLE_LANES;
                }
                match which {
                    Visible::Small if shape.host_front => &[files::KEYS, files::VISIBLE_SET_UP],
                    Visible::Large if shape.host_front => &[files::KEYS, files::VISIBLE_LARGE],
                    Visible::Small => &[files::SCREEN, files::PRIMITIVE, files::CORNER, files::KEYS, files::VISIBLE_SMALL],
                    Visible::Clip => &[files::SCREEN, files::PRIMITIVE, files::CORNER, files::POLYGON, files::KEYS, files::VISIBLE_CLIP],
                    Visible::Large => &[files::SCREEN, files::PRIMITIVE, files::CORNER, files::KEYS, files::VISIBLE_LARGE],
                    Visible::End => &[files::SCREEN, files::PRIMITIVE, files::CORNER, files::VISIBLE_END],
                }
            }
            Stage::Active => {
                options.flag("ATOMIC_LISTS", true);
                &[files::ACTIVE]
            }
            Stage::Round => {
                lanes = team(lanes);
                &[files::ROUND]
            }
            Stage::Clear(words) => {
                let _ = writeln!(extra, "const TP_COLOR_WORDS = {words}u;\nconst TP_CLEAR_ROWS = {CLEAR_ROWS};");
                &[files::CLEAR]
            }
        };
        options.flag("POINTS_AND_LINES", features & (front::POINTS_AND_LINES | front::UNFILLED) != 0);
        options.flag("UNFILLED", features & front::UNFILLED != 0);
        options.flag("SMOOTH", features & front::SMOOTH != 0);
        options.flag("OFFSET", features & front::OFFSET != 0);
        options.flag("SOUP", soup.is_some());
        options.flag("RUNS", !wide);
        let visible = matches!(self, Stage::Visible(..));
        let set_up = visible && shape.host_front;
        let triangles = matches!(self, Stage::Bin(_) | Stage::Tile(_)) || set_up;
        options.flag("TRIANGLES", triangles);
        // A GPU loads four words as fast as one.
        options.flag("TRIANGLE_VECTORS", triangles && wide && !set_up);
        options.flag("TRIANGLE_PAIRS", triangles && shape.subgroup8 || set_up);
        let _ = writeln!(
            extra,
            "{}const TP_RUN = {RUN}u;\nconst TP_ITEMS = {LARGE_ITEMS}u;\nconst TP_TEAMS = {}u;\nconst TP_FEW_TRIANGLES = {}u;\nconst TP_SUMS = {}u;\nconst TP_EMIT_LANES = {}u;",
            round_constant(shape),
            shape.teams(),
            shape.few_triangles(),
            sums_of_a_group(shape),
            emit_lanes(shape)
        );
        let mut source = format!("const TP_LANES = {lanes}u;\n{extra}{constants}");
        for (file, wanted) in [(files::COMMON, !self.is_front()), (files::FRONT, self.is_front() || visible), (files::VISIBLE, visible)] {
            if wanted {
                expand(file, &options, &mut source);
            }
        }
        expand(files::ARITHMETIC, &options, &mut source);
        if parts.contains(&files::SCREEN) {
            shaded(soup, &mut options, &mut source);
        }
        for part in parts {
            // Points and lines are left out whole where nothing draws them.
            if *part != files::POINT_LINE || options.flags.contains("POINTS_AND_LINES") {
                expand(*part, &options, &mut source);
            }
        }
        source
    }
}

/// Flags that the machine decides.
pub fn shape_flags(options: &mut Options, shape: Shape) {
    options.flag("FMA64", shape.fma64);
    options.flag("FUSES", shape.fuses);
    options.flag("SUBGROUP8", shape.subgroup8);
    options.flag("INT64", shape.int64);
    options.flag("ROUNDS", shape.rounds());
    options.flag("TEXEL_PAIRS", shape.texel_pairs);
}

/// How far a round goes.
pub fn round_constant(shape: Shape) -> String {
    format!("const TP_ROUND_BLOCKS = {}u;\n", shape.round_blocks)
}

/// Primitives of a group: what a workgroup of cull and set-up works on.
pub fn group_size(shape: Shape) -> u32 {
    if shape.vectors() { FRONT_LANES } else { TEAM_LANES * RUN }
}

/// Sums that a group writes.
pub fn sums_of_a_group(shape: Shape) -> u32 {
    if shape.vectors() { 1 } else { TEAM_LANES }
}

/// Lanes of the emit stage for each bin and super block.
pub fn emit_lanes(shape: Shape) -> u32 {
    if shape.vectors() { 32 } else { 1 }
}

/// The text of the vertex stage around a program.
pub fn vertex_source(shape: Shape, program: &Program, constants: &str) -> String {
    let mut options = Options::default();
    shape_flags(&mut options, shape);
    options.flag("VERTEX", true);
    let lanes = shape.list_lanes.min(VERTEX_BLOCK);
    let mut source = format!("const TP_LANES = {lanes}u;\nconst TP_VERTEX_BLOCK = {VERTEX_BLOCK}u;\n{constants}");
    expand(files::FRONT, &options, &mut source);
    expand(files::ARITHMETIC, &options, &mut source);
    shade(program, &mut options, &mut source);
    expand(files::VERTEX, &options, &mut source);
    source
}

/// Appends a vertex program and what runs it.
fn shade(program: &Program, options: &mut Options, source: &mut String) {
    let (mut fetch, mut store, mut outputs) = (String::new(), String::new(), String::new());
    for slot in (0..16).filter(|s| program.attributes & 1 << s != 0) {
        let _ = writeln!(fetch, "in.a{slot} = tp_attribute(record, {slot}u, vertex);");
    }
    for k in 0..program.outputs.len() {
        let _ = writeln!(store, "tp_shaded[at + {}u] = out.o{k};", k + 1);
        let _ = writeln!(outputs, "case {}u: {{ value = out.o{k}; }}", k + 1);
    }
    options.inserts.extend([("FETCH", fetch), ("STORE", store), ("OUTPUTS", outputs)]);
    source.push_str(&program.wgsl);
    source.push('\n');
    expand(files::SHADE, options, source);
}

/// Appends what reads shaded vertices, or shades them where they are wanted.
pub fn shaded(soup: Option<&Program>, options: &mut Options, source: &mut String) {
    if let Some(program) = soup {
        let _ = writeln!(source, "const TP_SHADED_STRIDE = {}u;", program.outputs.len() + 1);
        shade(program, options, source);
    }
    expand(files::SHADED, options, source);
}
