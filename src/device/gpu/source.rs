//! Kernel sources: the WGSL files, the constants that come from the Rust records, and what a key leaves out.
//!
//! Lines `//#if FLAG`, `//#else`, `//#endif`, `//#insert NAME`, `//#load NAME BUFFER PLACE` and the words `WORD(NAME, k)` in the
//! shaders are read by [`expand`]; the lines between `//#each $` and `//#end` are repeated for every sample, whose number stands for
//! the `$`. Everything else is plain WGSL.

use std::borrow::Cow;
use std::collections::{HashMap, HashSet};
use std::fmt::Write;
use std::mem::offset_of;

use super::params::{SEGMENT_WORDS, fresh, indirect};
use crate::raster::layout::*;
use crate::raster::vertex::{COORDINATE_RANGE, clip_code};

/// Flags that are on, and texts to insert.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Names of `//#if`.
    pub flags: HashSet<&'static str>,
    /// Texts of `//#insert`.
    pub inserts: HashMap<&'static str, String>,
    /// Samples of a pixel, for `//#each`.
    pub samples: u32,
}

impl Options {
    /// Sets a flag where a condition holds.
    pub fn flag(&mut self, name: &'static str, on: bool) {
        if on {
            self.flags.insert(name);
        }
    }
}

/// A WGSL file.
#[derive(Clone, Copy, PartialEq, Eq)]
pub struct File {
    name: &'static str,
    text: &'static str,
}

impl File {
    /// Its text; with `TEPUI_SHADERS` (a folder), as it stands there now, for work on the kernels.
    fn read(self) -> Cow<'static, str> {
        match std::env::var_os("TEPUI_SHADERS").map(|folder| std::fs::read_to_string(std::path::Path::new(&folder).join(self.name))) {
            Some(Ok(text)) => text.into(),
            Some(Err(e)) => {
                log::error!(target: "tepui::gpu", "TEPUI_SHADERS: {}: {e}", self.name);
                self.text.into()
            }
            None => self.text.into(),
        }
    }
}

/// The WGSL files.
pub mod files {
    #![allow(missing_docs)]
    use super::File;
    pub const COMMON: File = File { name: "common.wgsl", text: include_str!("../../../shaders/common.wgsl") };
    pub const ARITHMETIC: File = File { name: "arithmetic.wgsl", text: include_str!("../../../shaders/arithmetic.wgsl") };
    pub const FRONT: File = File { name: "front.wgsl", text: include_str!("../../../shaders/front.wgsl") };
    pub const VERTEX: File = File { name: "vertex.wgsl", text: include_str!("../../../shaders/vertex.wgsl") };
    pub const SHADE: File = File { name: "shade.wgsl", text: include_str!("../../../shaders/shade.wgsl") };
    pub const SHADED: File = File { name: "shaded.wgsl", text: include_str!("../../../shaders/shaded.wgsl") };
    pub const SCREEN: File = File { name: "screen.wgsl", text: include_str!("../../../shaders/screen.wgsl") };
    pub const PRIMITIVE: File = File { name: "primitive.wgsl", text: include_str!("../../../shaders/primitive.wgsl") };
    pub const CULL: File = File { name: "cull.wgsl", text: include_str!("../../../shaders/cull.wgsl") };
    pub const OFFSETS: File = File { name: "offsets.wgsl", text: include_str!("../../../shaders/offsets.wgsl") };
    pub const SETUP: File = File { name: "setup.wgsl", text: include_str!("../../../shaders/setup.wgsl") };
    pub const INSIDE: File = File { name: "inside.wgsl", text: include_str!("../../../shaders/inside.wgsl") };
    pub const CLIP: File = File { name: "clip.wgsl", text: include_str!("../../../shaders/clip.wgsl") };
    pub const POINT_LINE: File = File { name: "point_line.wgsl", text: include_str!("../../../shaders/point_line.wgsl") };
    pub const CORNER: File = File { name: "corner.wgsl", text: include_str!("../../../shaders/corner.wgsl") };
    pub const POLYGON: File = File { name: "polygon.wgsl", text: include_str!("../../../shaders/polygon.wgsl") };
    pub const VISIBLE: File = File { name: "visible.wgsl", text: include_str!("../../../shaders/visible.wgsl") };
    pub const KEYS: File = File { name: "keys.wgsl", text: include_str!("../../../shaders/keys.wgsl") };
    pub const VISIBLE_SMALL: File = File { name: "visible_small.wgsl", text: include_str!("../../../shaders/visible_small.wgsl") };
    pub const VISIBLE_SET_UP: File = File { name: "visible_set_up.wgsl", text: include_str!("../../../shaders/visible_set_up.wgsl") };
    pub const VISIBLE_CLIP: File = File { name: "visible_clip.wgsl", text: include_str!("../../../shaders/visible_clip.wgsl") };
    pub const VISIBLE_LARGE: File = File { name: "visible_large.wgsl", text: include_str!("../../../shaders/visible_large.wgsl") };
    pub const VISIBLE_END: File = File { name: "visible_end.wgsl", text: include_str!("../../../shaders/visible_end.wgsl") };
    pub const VISIBLE_RESOLVE: File = File { name: "visible_resolve.wgsl", text: include_str!("../../../shaders/visible_resolve.wgsl") };
    pub const BIN: File = File { name: "bin.wgsl", text: include_str!("../../../shaders/bin.wgsl") };
    pub const COUNT: File = File { name: "count.wgsl", text: include_str!("../../../shaders/count.wgsl") };
    pub const SCAN: File = File { name: "scan.wgsl", text: include_str!("../../../shaders/scan.wgsl") };
    pub const EMIT: File = File { name: "emit.wgsl", text: include_str!("../../../shaders/emit.wgsl") };
    pub const IN_BIN: File = File { name: "in_bin.wgsl", text: include_str!("../../../shaders/in_bin.wgsl") };
    pub const TILE: File = File { name: "tile.wgsl", text: include_str!("../../../shaders/tile.wgsl") };
    pub const ACTIVE: File = File { name: "active.wgsl", text: include_str!("../../../shaders/active.wgsl") };
    pub const ROUND: File = File { name: "round.wgsl", text: include_str!("../../../shaders/round.wgsl") };
    pub const CLEAR: File = File { name: "clear.wgsl", text: include_str!("../../../shaders/clear.wgsl") };
    pub const COLOR: File = File { name: "color.wgsl", text: include_str!("../../../shaders/color.wgsl") };
    pub const BLEND: File = File { name: "blend.wgsl", text: include_str!("../../../shaders/blend.wgsl") };
    pub const FRAGMENT_OPS: File = File { name: "fragment_ops.wgsl", text: include_str!("../../../shaders/fragment_ops.wgsl") };
    pub const STATE: File = File { name: "state.wgsl", text: include_str!("../../../shaders/state.wgsl") };
    pub const RESOLVE_STATE: File = File { name: "resolve_state.wgsl", text: include_str!("../../../shaders/resolve_state.wgsl") };
    pub const FINE: File = File { name: "fine.wgsl", text: include_str!("../../../shaders/fine.wgsl") };
    pub const NEXT_BLOCK: File = File { name: "next_block.wgsl", text: include_str!("../../../shaders/next_block.wgsl") };
    pub const NEXT_ENTRY: File = File { name: "next_entry.wgsl", text: include_str!("../../../shaders/next_entry.wgsl") };
    pub const COLUMN: File = File { name: "column.wgsl", text: include_str!("../../../shaders/column.wgsl") };
    pub const COLUMN_START: File = File { name: "column_start.wgsl", text: include_str!("../../../shaders/column_start.wgsl") };
    pub const COLUMN_NEXT: File = File { name: "column_next.wgsl", text: include_str!("../../../shaders/column_next.wgsl") };
    pub const FINE_COLUMN: File = File { name: "fine_column.wgsl", text: include_str!("../../../shaders/fine_column.wgsl") };
    pub const FINE_DEFERRED: File = File { name: "fine_deferred.wgsl", text: include_str!("../../../shaders/fine_deferred.wgsl") };
    pub const EDGES: File = File { name: "edges.wgsl", text: include_str!("../../../shaders/edges.wgsl") };
    pub const ENTRY: File = File { name: "entry.wgsl", text: include_str!("../../../shaders/entry.wgsl") };
    pub const FRAGMENT: File = File { name: "fragment.wgsl", text: include_str!("../../../shaders/fragment.wgsl") };
    pub const SAMPLES: File = File { name: "samples.wgsl", text: include_str!("../../../shaders/samples.wgsl") };
    pub const RESOLVE: File = File { name: "resolve.wgsl", text: include_str!("../../../shaders/resolve.wgsl") };
    pub const TEXTURE: File = File { name: "texture.wgsl", text: include_str!("../../../shaders/texture.wgsl") };

    /// Parts of functions, for `//#include`.
    pub const PARTS: [File; 10] =
        [NEXT_BLOCK, NEXT_ENTRY, COLUMN_START, COLUMN_NEXT, EDGES, ENTRY, FRAGMENT, SAMPLES, STATE, RESOLVE_STATE];
}

/// Reads the `//#` lines of a source.
pub fn expand(file: File, options: &Options, out: &mut String) {
    expand_with(&file.read(), options, &mut Vec::new(), out);
}

/// Replaces `WORD(load, k)`: word `k` of what `//#load` loaded (8 words, or the 12 of a list's entry), the same for all lanes of a
/// workgroup. Where a workgroup is one subgroup of eight lanes, each lane loaded one or two words, which are broadcast; where loads are
/// vectors, it is a component of one; elsewhere it is read where it is wanted.
fn words_of_loads(line: &str, options: &Options, loads: &[(String, String)], out: &mut String) {
    let mut rest = line;
    while let Some(at) = rest.find("WORD(") {
        out.push_str(&rest[..at]);
        let end = at + rest[at..].find(')').expect("WORD( has its )");
        let (name, k) = rest[at + 5..end].split_once(',').expect("WORD(load, k)");
        let (name, k) = (name.trim(), k.trim());
        if options.flags.contains("SUBGROUP8") {
            let k: usize = k.parse().expect("WORD(load, k) has a number");
            let _ = match loads.iter().any(|l| l.0 == name && pairs(&l.1)) {
                true => write!(out, "subgroupBroadcast({name}_{}, {}u)", ["low", "high"][k % 2], k / 2),
                false => write!(out, "subgroupBroadcast({name}, {k}u)"),
            };
        } else if options.flags.contains("VECTORS") {
            let k: usize = k.parse().expect("WORD(load, k) has a number");
            let _ = write!(out, "{name}_{}.{}", k / 4, ["x", "y", "z", "w"][k % 4]);
        } else {
            let buffer = &loads.iter().rev().find(|l| l.0 == name).expect("a //#load before its WORD").1;
            let _ = write!(out, "{buffer}[{name}_at + {k}u]");
        }
        rest = &rest[end + 1..];
    }
    out.push_str(rest);
}

/// Buffers that a subgroup of eight lanes reads two words at a time: there a load costs by lanes, not by words.
fn pairs(buffer: &str) -> bool {
    buffer == "tp_lists"
}

fn expand_with(source: &str, options: &Options, loads: &mut Vec<(String, String)>, out: &mut String) {
    // For each open //#if: whether its text counts.
    let mut open: Vec<bool> = Vec::new();
    let mut lines = source.lines();
    while let Some(line) = lines.next() {
        let mut words = line.split_whitespace();
        match words.next() {
            Some("//#if") => {
                let flag = words.next().unwrap_or_default();
                open.push(options.flags.contains(flag));
            }
            Some("//#else") => {
                let last = open.last_mut().expect("//#else belongs to an //#if");
                *last = !*last;
            }
            Some("//#endif") => {
                open.pop();
            }
            Some("//#load") if open.iter().all(|&o| o) => {
                let (name, buffer) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
                let at = words.collect::<Vec<_>>().join(" ");
                if options.flags.contains("SUBGROUP8") && pairs(buffer) {
                    let _ = writeln!(out, "var {name} = 0lu;\nif (column < 6u) {{ {name} = {buffer}[(({at}) >> 1u) + column]; }}");
                    let _ = writeln!(out, "let {name}_low = u32({name} & 0xfffffffflu);\nlet {name}_high = u32({name} >> 32u);");
                } else if options.flags.contains("SUBGROUP8") {
                    // Words of a draw stay while the draw does.
                    let k = loads.len();
                    let _ = writeln!(out, "if (tp_fresh) {{ tp_kept[{k}] = {buffer}[{at} + column]; }}\nlet {name} = tp_kept[{k}];");
                } else if options.flags.contains("VECTORS") {
                    // What is loaded begins at a multiple of four words; what of it is not used is not loaded.
                    let _ = writeln!(out, "let {name}_0 = {buffer}[({at}) >> 2u];\nlet {name}_1 = {buffer}[(({at}) >> 2u) + 1u];");
                } else {
                    let _ = writeln!(out, "let {name}_at = {at};");
                }
                loads.push((name.to_string(), buffer.to_string()));
            }
            Some("//#each") => {
                // As many as are named, or one for each sample.
                let count = words.nth(1).map_or(options.samples, |n| n.parse().expect("//#each $ has a number or nothing"));
                let mut block = String::new();
                for line in lines.by_ref().take_while(|line| line.trim() != "//#end") {
                    block.push_str(line);
                    block.push('\n');
                }
                if open.iter().all(|&o| o) {
                    (0..count).for_each(|k| expand_with(&block.replace('$', &k.to_string()), options, loads, out));
                }
            }
            Some("//#include") if open.iter().all(|&o| o) => {
                let name = words.next().unwrap_or_default();
                let file = files::PARTS.into_iter().find(|f| f.name.strip_suffix(".wgsl") == Some(name));
                expand_with(&file.expect("//#include names a file").read(), options, loads, out);
            }
            Some("//#insert") if open.iter().all(|&o| o) => {
                let name = words.next().unwrap_or_default();
                let text = options.inserts.get(name).map_or("", |t| t);
                expand_with(text, options, loads, out);
            }
            _ if open.iter().all(|&o| o) => {
                words_of_loads(line, options, loads, out);
                out.push('\n');
            }
            _ => {}
        }
    }
    assert!(open.is_empty(), "every //#if has its //#endif");
}

macro_rules! words {
    ($out:ident, $record:ty, $($name:literal = $field:ident),* $(,)?) => {
        $(let _ = writeln!($out, "const {} = {}u;", $name, offset_of!($record, $field) / 4);)*
    };
}

/// Word offsets and flags of the records, as WGSL constants.
pub fn record_constants() -> String {
    let mut out = String::new();
    let size = |bytes: usize| bytes / 4;
    let _ = writeln!(out, "const TP_TRIANGLE_WORDS = {}u;", size(size_of::<Triangle>()));
    let _ = writeln!(out, "const TP_DRAW_WORDS = {}u;", super::records::DRAW_WORDS);
    let _ = writeln!(out, "const TP_DRAW_RECORD_WORDS = {}u;", super::records::DRAW_RECORD_WORDS);
    let _ = writeln!(out, "const TP_STATE_WORDS = {}u;", size(size_of::<RasterState>()));
    let _ = writeln!(out, "const TP_COORDINATE_MIN = {:?};", COORDINATE_RANGE[0]);
    let _ = writeln!(out, "const TP_COORDINATE_MAX = {:?};", COORDINATE_RANGE[1]);
    let _ = writeln!(out, "const TP_ENTRY_WORDS = {}u;", super::encode::ENTRY_WORDS);
    words!(
        out,
        Triangle,
        "TP_TRIANGLE_DRAW" = draw,
        "TP_TRIANGLE_FLAGS" = flags,
        "TP_TRIANGLE_COLUMNS" = columns,
        "TP_TRIANGLE_ROWS" = rows,
        "TP_TRIANGLE_PLANES" = planes,
        "TP_TRIANGLE_PRIMITIVE" = primitive,
    );
    words!(
        out,
        DrawRecord,
        "TP_DRAW_VERTEX_WORD" = vertex_word,
        "TP_DRAW_VERTEX_STRIDE" = vertex_stride,
        "TP_DRAW_VERTEX_COUNT" = vertex_count,
        "TP_DRAW_TOPOLOGY" = topology,
        "TP_DRAW_ATTRIBUTE_OFFSET" = attribute_offset,
        "TP_DRAW_ATTRIBUTE_SIZE" = attribute_size,
        "TP_DRAW_CONSTANTS" = constants,
        "TP_DRAW_VERTEX_UNIFORMS" = vertex_uniforms,
        "TP_DRAW_RASTER_STATE" = raster_state,
        "TP_DRAW_SHADED_BASE" = shaded_base,
        "TP_DRAW_SHADED_STRIDE" = shaded_stride,
        "TP_DRAW_CLIP_DISTANCES" = clip_distances,
        "TP_DRAW_CLIP_DISTANCE_COUNT" = clip_distance_count,
        "TP_DRAW_POINT_SIZE" = point_size,
        "TP_DRAW_VARYING_COUNT" = varying_count,
        "TP_DRAW_VARYINGS" = varyings,
    );
    words!(
        out,
        RasterState,
        "TP_STATE_FLAGS" = flags,
        "TP_STATE_POLYGON_MODE" = polygon_mode,
        "TP_STATE_VIEWPORT_SCALE" = viewport_scale,
        "TP_STATE_VIEWPORT_TRANSLATE" = viewport_translate,
        "TP_STATE_SCISSOR_MIN" = scissor_min,
        "TP_STATE_SCISSOR_MAX" = scissor_max,
        "TP_STATE_OFFSET_FACTOR" = offset_factor,
        "TP_STATE_OFFSET_UNITS" = offset_units,
        "TP_STATE_LINE_WIDTH" = line_width,
        "TP_STATE_POINT_SIZE" = point_size,
        "TP_STATE_DEPTH_RANGE" = depth_range,
    );
    for (name, value) in [
        ("TP_FRONT", triangle_flags::FRONT),
        ("TP_POLYGON", triangle_flags::POLYGON),
        ("TP_PERSPECTIVE", triangle_flags::PERSPECTIVE),
        ("TP_BOTTOM_UP", triangle_flags::BOTTOM_UP),
        ("TP_CUT", triangle_flags::CUT),
        ("TP_MULTISAMPLE", triangle_flags::MULTISAMPLE),
        ("TP_MULTISAMPLE_STATE", raster_flags::MULTISAMPLE),
        ("TP_NONE", NONE),
        // As columns or rows: the first is greater than the last.
        ("TP_NOWHERE", 0xffff),
        ("TP_POINTS", topology::POINTS),
        ("TP_LINES", topology::LINES),
        ("TP_TRIANGLES", topology::TRIANGLES),
        ("TP_INTERPOLATE_FLAT", interpolation::FLAT),
        ("TP_INTERPOLATE_PERSPECTIVE", interpolation::PERSPECTIVE),
        ("TP_INTERPOLATE_COVERAGE", interpolation::COVERAGE),
        ("TP_CULL_FRONT", raster_flags::CULL_FRONT),
        ("TP_CULL_BACK", raster_flags::CULL_BACK),
        ("TP_FRONT_CCW", raster_flags::FRONT_CCW),
        ("TP_OFFSET_POINT", raster_flags::OFFSET_POINT),
        ("TP_OFFSET_LINE", raster_flags::OFFSET_LINE),
        ("TP_OFFSET_FILL", raster_flags::OFFSET_FILL),
        ("TP_POINT_SMOOTH", raster_flags::POINT_SMOOTH),
        ("TP_LINE_SMOOTH", raster_flags::LINE_SMOOTH),
        ("TP_WINDOW_SPACE", raster_flags::WINDOW_SPACE),
        ("TP_NO_Z_CLIP", raster_flags::NO_Z_CLIP),
        ("TP_FLOAT_DEPTH", raster_flags::FLOAT_DEPTH),
        ("TP_CLIP_RIGHT", clip_code::RIGHT),
        ("TP_CLIP_LEFT", clip_code::LEFT),
        ("TP_CLIP_TOP", clip_code::TOP),
        ("TP_CLIP_BOTTOM", clip_code::BOTTOM),
        ("TP_CLIP_NEAR", clip_code::NEAR),
        ("TP_CLIP_FAR", clip_code::FAR),
        ("TP_CLIP_USER", clip_code::USER),
        ("TP_CLIP_INVALID", clip_code::INVALID),
        ("TP_DEPTH_PLANE_VEC4", DEPTH_PLANE_VEC4),
        ("TP_VARYING_PLANE_VEC4", VARYING_PLANE_VEC4),
        ("TP_SEGMENT_WORDS", SEGMENT_WORDS),
        ("TP_FRESH_COLOR", fresh::COLOR),
        ("TP_FRESH_DEPTH", fresh::DEPTH),
        ("TP_FRESH_CLEARS", fresh::CLEARS),
        ("TP_SETUP_DISPATCH", indirect::SETUP),
        ("TP_CLIP_DISPATCH", indirect::CLIP),
        ("TP_FINE_DISPATCH", indirect::FINE),
        ("TP_FAILED", indirect::FAILED),
        ("TP_SEGMENT_DISPATCH", indirect::SEGMENTS),
        ("TP_DEPTH_TEST_ON", fragment_flags::DEPTH_TEST),
        ("TP_DEPTH_WRITE_ON", fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE),
        ("TP_STENCIL_TEST_ON", fragment_flags::STENCIL_TEST),
        ("TP_ALPHA_TEST_ON", fragment_flags::ALPHA_TEST),
        ("TP_BLEND_ON", fragment_flags::BLEND),
        ("TP_LOGIC_OP_ON", fragment_flags::LOGIC_OP),
        ("TP_ALPHA_TO_COVERAGE_ON", fragment_flags::ALPHA_TO_COVERAGE),
        ("TP_ALPHA_TO_ONE_ON", fragment_flags::ALPHA_TO_ONE),
    ] {
        let _ = writeln!(out, "const {name} = {value}u;");
    }
    out
}
