//! The text between the fine kernel and a fragment program: loads of plane equations, interpolation, the call.

use std::fmt::Write;

use super::adapter::Shape;
use super::fine::{FineKey, feature};
use super::texture::TextureClass;
use crate::draw::texture::TextureKind;
use crate::program::{Input, Program};
use crate::raster::layout::{DEPTH_PLANE_VEC4, VARYING_PLANE_VEC4, interpolation};

/// What to insert into `shaders/fine.wgsl`.
#[derive(Default)]
pub struct Glue {
    /// Loads of the planes' words.
    pub planes: String,
    /// Depth of the pixel.
    pub depth: String,
    /// The call of the program.
    pub shade: String,
}

/// First word of a varying's planes.
fn varying_word(k: u8) -> u32 {
    (DEPTH_PLANE_VEC4 + k as u32 * VARYING_PLANE_VEC4) * 4
}

fn interpolation_of(program: &Program, k: u8) -> u32 {
    program.varyings.get(k as usize).map_or(interpolation::LINEAR, |v| v.interpolation)
}

/// Where the planes come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Planes {
    /// Set-up has written them; all lanes want the same.
    Loaded,
    /// The host has written them; each lane wants others, and loads two words at a time.
    Pairs,
    /// They are worked out from the corners `va`, `vb`, `vc`.
    Computed,
}

/// The text for a program and a key.
pub fn glue(program: &Program, key: &FineKey, shape: Shape, source: Planes) -> Glue {
    let mut glue = Glue::default();
    let on = |bit: u32| key.features & bit != 0;
    let shades = on(feature::SHADES);
    let inputs: &[Input] = if shades { &program.inputs } else { &[] };
    let reads_position = inputs.contains(&Input::Position);
    let needs_z = on(feature::DEPTH_TEST) && !program.writes_depth || reads_position;
    let mixed = on(feature::MIXED_INTERPOLATION);
    let flat = |k: u8| !mixed && interpolation_of(program, k) == interpolation::FLAT;
    let perspective = |k: u8| on(feature::PERSPECTIVE) && (mixed || interpolation_of(program, k) == interpolation::PERSPECTIVE);
    let varyings: Vec<u8> = {
        let mut list: Vec<u8> = inputs
            .iter()
            .filter_map(|i| match *i {
                Input::Varying(k) | Input::Quad(k, _) => Some(k),
                _ => None,
            })
            .collect();
        list.sort_unstable();
        list.dedup();
        list
    };
    let needs_w = reads_position || varyings.iter().any(|&k| perspective(k));

    // Words of planes that are wanted, in order.
    let mut words: Vec<u32> = Vec::new();
    if needs_z {
        words.extend(0..3);
    }
    if needs_w {
        words.extend(3..6);
    }
    let offset = needs_z && on(feature::OFFSET);
    if offset {
        words.push(6);
    }
    for &k in &varyings {
        let n = if flat(k) { 4 } else { 12 };
        words.extend(varying_word(k)..varying_word(k) + n);
    }
    if source == Planes::Computed {
        computed(&mut glue.planes, needs_z, needs_w, &varyings);
    } else if source == Planes::Pairs {
        let mut pairs: Vec<u32> = words.iter().map(|w| w / 2).collect();
        pairs.dedup();
        for pair in pairs {
            let _ = writeln!(glue.planes, "let pp{pair} = tp_planes[(planes >> 1u) + {pair}u];");
        }
        for w in &words {
            let shift = w % 2 * 32;
            let _ = writeln!(glue.planes, "let p{w} = bitcast<f32>(u32((pp{} >> {shift}u) & 0xfffffffflu));", w / 2);
        }
    } else if shape.subgroup8 {
        // Two words a lane, and only what is wanted, because each lane's load takes its time.
        let mut pairs: Vec<u32> = words.iter().map(|w| w / 2).collect();
        pairs.dedup();
        // A lane's distance from the first pair of its group has four bits of a constant.
        let groups: Vec<&[u32]> = pairs.chunk_by(|a, b| a / 16 == b / 16).flat_map(|near| near.chunks(8)).collect();
        for (g, group) in groups.iter().enumerate() {
            let distances = (0..).zip(*group).fold(0u32, |all, (lane, pair)| all | (pair - group[0]) << (lane * 4));
            let (lanes, first) = (group.len(), group[0]);
            let _ = writeln!(
                glue.planes,
                "var pg{g} = 0lu;
if (column < {lanes}u) {{ pg{g} = tp_planes[(planes >> 1u) + {first}u + (({distances}u >> (column * 4u)) & 15u)]; }}
let pg{g}_low = bitcast<f32>(u32(pg{g} & 0xfffffffflu));
let pg{g}_high = bitcast<f32>(u32(pg{g} >> 32u));"
            );
            for w in words.iter().filter(|&w| group.contains(&(w / 2))) {
                let (half, lane) = (["low", "high"][*w as usize % 2], group.partition_point(|pair| *pair < w / 2));
                let _ = writeln!(glue.planes, "let p{w} = subgroupBroadcast(pg{g}_{half}, {lane}u);");
            }
        }
    } else if shape.vectors() {
        let mut vectors: Vec<u32> = words.iter().map(|w| w / 4).collect();
        vectors.dedup();
        for v in vectors {
            let _ = writeln!(glue.planes, "let pv{v} = tp_planes[(planes >> 2u) + {v}u];");
        }
        for w in &words {
            let _ = writeln!(glue.planes, "let p{w} = pv{}.{};", w / 4, ['x', 'y', 'z', 'w'][*w as usize % 4]);
        }
    } else {
        for w in &words {
            let _ = writeln!(glue.planes, "let p{w} = tp_planes[planes + {w}u];");
        }
    }

    // What depends on the column only is worked out once a triangle where a lane has a whole column.
    let hoist = shape.fine_lanes < 64 && source == Planes::Loaded;
    // Values are exact. Derivatives need it only where they choose between levels: a blend of levels forgives a rounding.
    let exact_quads = key.textures.iter().any(TextureClass::chooses);
    let quad_fma = if exact_quads { "tp_fma" } else { "fma" };
    // The division by w falls out of the ratios of homogeneous coordinates, which are all that is wanted of a quad's; directions have none.
    let ratios = !exact_quads && key.textures.iter().all(|t| t.kind != TextureKind::Cube);
    let fma4 = |quad: bool, a: &str, b: String, c: String| {
        if quad && !exact_quads { format!("fma(vec4<f32>({a}), {b}, {c})") } else { format!("tp_fma4({a}, {b}, {c})") }
    };
    // Where a fused sum is worked out in double precision, what does not change from row to row is widened once a triangle.
    let wide = shape.fma64 && hoist;
    {
        let columns = if hoist { &mut glue.planes } else { &mut glue.depth };
        for (wanted, name, first) in [(needs_z, 'z', 0), (needs_w, 'w', 3)] {
            if wanted {
                let _ = writeln!(columns, "let {name}x = tp_fma(x, p{}, p{first});", first + 1);
            }
            if wanted && wide {
                let _ = writeln!(columns, "let {name}x_wide = f64({name}x);\nlet {name}y_wide = f64(p{});", first + 2);
            }
        }
    }
    let along_y = |name: char, plane: u32| {
        if wide { format!("f32(f64(y) * {name}y_wide + {name}x_wide)") } else { format!("tp_fma(y, p{plane}, {name}x)") }
    };
    if needs_z {
        let _ = writeln!(glue.depth, "let z = {}{};", along_y('z', 2), if offset { " + p6" } else { "" });
    }
    if on(feature::DEPTH_TEST) && !program.writes_depth {
        glue.depth.push_str("let depth = tp_quantise(state, z);\n");
    }
    if !shades {
        return glue;
    }
    let vec4 = |first: u32| format!("vec4<f32>(p{}, p{}, p{}, p{})", first, first + 1, first + 2, first + 3);
    let several = key.samples > 1;
    let to_centre = if several { " + to_centre" } else { "" };
    let quad = inputs.iter().any(|i| matches!(i, Input::Quad(..)));
    {
        let columns = if hoist { &mut glue.planes } else { &mut glue.shade };
        if quad {
            let _ = writeln!(columns, "let qx = f32(i32(px & ~1u)){to_centre};\nlet qx1 = qx + 1.0;");
            if needs_w && !ratios {
                let _ = writeln!(columns, "let qwx = {quad_fma}(qx, p4, p3);\nlet qwx1 = {quad_fma}(qx1, p4, p3);");
            }
        }
        for input in inputs {
            let (k, name, x) = match *input {
                Input::Varying(k) => (k, "v", "x"),
                Input::Quad(k, 1) => (k, "q1_", "qx1"),
                Input::Quad(k, 2) => (k, "q2_", "qx"),
                Input::Quad(k, _) => (k, "q0_", "qx"),
                _ => continue,
            };
            let first = varying_word(k);
            let value = if flat(k) { vec4(first) } else { fma4(name != "v", x, vec4(first + 4), vec4(first)) };
            let _ = writeln!(columns, "let {name}{k} = {value};");
            if wide && name == "v" && !flat(k) {
                let _ = writeln!(columns, "let v{k}x_wide = vec4<f64>(v{k});\nlet v{k}y_wide = vec4<f64>({});", vec4(first + 8));
            }
        }
    }
    let shade = &mut glue.shade;
    if needs_w {
        let _ = writeln!(shade, "let w = {};\nlet reciprocal = tp_reciprocal(w);", along_y('w', 5));
    }
    if quad {
        let _ = writeln!(shade, "let qy = f32(py & ~1){to_centre};\nlet qy1 = qy + 1.0;");
        if needs_w && !ratios {
            let _ = writeln!(
                shade,
                "let qr0 = 1.0 / {quad_fma}(qy, p5, qwx);\nlet qr1 = 1.0 / {quad_fma}(qy, p5, qwx1);\nlet qr2 = 1.0 / {quad_fma}(qy1, p5, qwx);"
            );
        }
    }
    let at = |k: u8, column: &str, y: &str, reciprocal: &str| {
        if flat(k) {
            return format!("{column}{k}");
        }
        let value = if wide && column == "v" {
            format!("vec4<f32>(f64({y}) * v{k}y_wide + v{k}x_wide)")
        } else {
            fma4(column != "v", y, vec4(varying_word(k) + 8), format!("{column}{k}"))
        };
        if ratios && column != "v" {
            format!("tp_projected({value})")
        } else if perspective(k) && mixed {
            format!("{value} * select(1.0, {reciprocal}, (modes & {}u) != 0u)", 1 << k)
        } else if perspective(k) {
            format!("{value} * {reciprocal}")
        } else {
            value
        }
    };
    let mut arguments: Vec<String> = Vec::new();
    for (i, input) in inputs.iter().enumerate() {
        let value = match *input {
            Input::Position if several => "vec4<f32>(x + (0.5 - to_centre), y + (0.5 - to_centre), z, w)".to_string(),
            Input::Position => "vec4<f32>(x + 0.5, y + 0.5, z, w)".to_string(),
            Input::Facing => "vec4<f32>(select(0.0, 1.0, (flags & TP_FRONT) != 0u), 0.0, 0.0, 0.0)".to_string(),
            Input::Varying(k) => at(k, "v", "y", "reciprocal"),
            Input::Quad(k, 1) => at(k, "q1_", "qy", "qr1"),
            Input::Quad(k, 2) => at(k, "q2_", "qy1", "qr2"),
            Input::Quad(k, _) => at(k, "q0_", "qy", "qr0"),
        };
        let _ = writeln!(shade, "let in{i} = {value};");
        arguments.push(format!("in{i}"));
    }
    let _ = writeln!(shade, "let result = fragment_main(FragmentIn({}), fragment_uniforms);", arguments.join(", "));
    shade.push_str("color = result.color;\n");
    if program.writes_depth {
        shade.push_str("program_depth = result.depth;\n");
    }
    if program.discards {
        shade.push_str("keep = result.keep;\n");
    }
    glue
}

/// Declares the words of the planes that are wanted, computed from the corners.
fn computed(text: &mut String, needs_z: bool, needs_w: bool, varyings: &[u8]) {
    if needs_z || needs_w {
        text.push_str("let zw = tp_depth_planes(basis, va, vb, vc);\n");
    }
    for (wanted, component, first) in [(needs_z, 'x', 0), (needs_w, 'y', 3)] {
        if wanted {
            for i in 0..3 {
                let _ = writeln!(text, "let p{} = zw[{i}].{component};", first + i);
            }
        }
    }
    if needs_z {
        text.push_str(
            "let p6 = select(0.0, tp_polygon_offset(p.state, va.position, vb.position, vc.position), (p.flags & TP_OFFSET_FILL) != 0u);\n",
        );
    }
    for &k in varyings {
        let _ = writeln!(text, "let planes{k} = tp_varying_planes(p, {k}u, front, basis, va, vb, vc);");
        for word in 0..12 {
            let _ =
                writeln!(text, "let p{} = planes{k}[{}].{};", varying_word(k) + word, word / 4, ['x', 'y', 'z', 'w'][word as usize % 4]);
        }
    }
}
