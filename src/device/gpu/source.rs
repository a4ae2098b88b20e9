//! Kernel sources: the WGSL files, the constants that come from the Rust records, and what a key leaves out.
//!
//! Lines `//#if FLAG`, `//#else`, `//#endif` and `//#insert NAME` in the shaders are read by [`expand`]. Everything else is
//! plain WGSL.

use std::collections::{HashMap, HashSet};
use std::fmt::Write;
use std::mem::offset_of;

use crate::raster::layout::*;

/// Flags that are on, and texts to insert.
#[derive(Clone, Debug, Default)]
pub struct Options {
    /// Names of `//#if`.
    pub flags: HashSet<&'static str>,
    /// Texts of `//#insert`.
    pub inserts: HashMap<&'static str, String>,
}

impl Options {
    /// Sets a flag where a condition holds.
    pub fn flag(&mut self, name: &'static str, on: bool) {
        if on {
            self.flags.insert(name);
        }
    }
}

/// The WGSL files.
pub mod files {
    #![allow(missing_docs)]
    pub const COMMON: &str = include_str!("../../../shaders/common.wgsl");
    pub const BIN: &str = include_str!("../../../shaders/bin.wgsl");
    pub const COUNT: &str = include_str!("../../../shaders/count.wgsl");
    pub const SCAN: &str = include_str!("../../../shaders/scan.wgsl");
    pub const EMIT: &str = include_str!("../../../shaders/emit.wgsl");
    pub const TILE: &str = include_str!("../../../shaders/tile.wgsl");
    pub const CLEAR: &str = include_str!("../../../shaders/clear.wgsl");
    pub const COLOR: &str = include_str!("../../../shaders/color.wgsl");
    pub const BLEND: &str = include_str!("../../../shaders/blend.wgsl");
    pub const FRAGMENT_OPS: &str = include_str!("../../../shaders/fragment_ops.wgsl");
    pub const FINE: &str = include_str!("../../../shaders/fine.wgsl");
    pub const TEXTURE: &str = include_str!("../../../shaders/texture.wgsl");
}

/// Reads the `//#` lines of a source.
pub fn expand(source: &str, options: &Options, out: &mut String) {
    // For each open //#if: whether its text counts.
    let mut open: Vec<bool> = Vec::new();
    for line in source.lines() {
        let mut words = line.trim_start().split_whitespace();
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
            Some("//#insert") if open.iter().all(|&o| o) => {
                let name = words.next().unwrap_or_default();
                out.push_str(options.inserts.get(name).map_or("", |t| t));
                out.push('\n');
            }
            _ if open.iter().all(|&o| o) => {
                out.push_str(line);
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
    let _ = writeln!(out, "const TP_DRAW_WORDS = {}u;", size(size_of::<DrawRecord>()));
    let _ = writeln!(out, "const TP_RASTER_WORDS = {}u;", size(size_of::<RasterState>()));
    let _ = writeln!(out, "const TP_FRAGMENT_WORDS = {}u;", size(size_of::<FragmentState>()));
    let _ = writeln!(out, "const TP_STENCIL_WORDS = {}u;", size(size_of::<StencilFace>()));
    words!(
        out,
        Triangle,
        "TP_TRIANGLE_DRAW" = draw,
        "TP_TRIANGLE_FLAGS" = flags,
        "TP_TRIANGLE_COLUMNS" = columns,
        "TP_TRIANGLE_ROWS" = rows,
        "TP_TRIANGLE_PLANES" = planes,
    );
    words!(
        out,
        DrawRecord,
        "TP_DRAW_FRAGMENT_UNIFORMS" = fragment_uniforms,
        "TP_DRAW_RASTER_STATE" = raster_state,
        "TP_DRAW_FRAGMENT_STATE" = fragment_state,
        "TP_DRAW_FIRST_TEXTURE" = first_texture,
    );
    words!(out, RasterState, "TP_RASTER_DEPTH_RANGE" = depth_range, "TP_RASTER_POLYGON_STIPPLE" = polygon_stipple);
    words!(
        out,
        FragmentState,
        "TP_FRAGMENT_FLAGS" = flags,
        "TP_FRAGMENT_DEPTH_FUNC" = depth_func,
        "TP_FRAGMENT_ALPHA_FUNC" = alpha_func,
        "TP_FRAGMENT_ALPHA_REF" = alpha_ref,
        "TP_FRAGMENT_STENCIL" = stencil,
        "TP_FRAGMENT_BLEND_FACTORS" = blend_factors,
        "TP_FRAGMENT_LOGIC_OP" = logic_op,
        "TP_FRAGMENT_COLOR_MASK" = color_mask,
        "TP_FRAGMENT_BLEND_COLOR" = blend_color,
    );
    for (name, value) in [
        ("TP_FRONT", triangle_flags::FRONT),
        ("TP_POLYGON", triangle_flags::POLYGON),
        ("TP_PERSPECTIVE", triangle_flags::PERSPECTIVE),
        ("TP_DEPTH_TEST_ON", fragment_flags::DEPTH_TEST),
        ("TP_DEPTH_WRITE_ON", fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE),
        ("TP_STENCIL_TEST_ON", fragment_flags::STENCIL_TEST),
        ("TP_ALPHA_TEST_ON", fragment_flags::ALPHA_TEST),
        ("TP_BLEND_ON", fragment_flags::BLEND),
        ("TP_LOGIC_OP_ON", fragment_flags::LOGIC_OP),
    ] {
        let _ = writeln!(out, "const {name} = {value}u;");
    }
    out
}
