//! Kernel sources: the WGSL files, the constants that come from the Rust records, and what a key leaves out.
//!
//! Lines `//#if FLAG`, `//#else`, `//#endif`, `//#insert NAME`, `//#load NAME BUFFER PLACE` and the words `WORD(NAME, k)` in the
//! shaders are read by [`expand`]. Everything else is plain WGSL.

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
    pub const ACTIVE: &str = include_str!("../../../shaders/active.wgsl");
    pub const CLEAR: &str = include_str!("../../../shaders/clear.wgsl");
    pub const COLOR: &str = include_str!("../../../shaders/color.wgsl");
    pub const BLEND: &str = include_str!("../../../shaders/blend.wgsl");
    pub const FRAGMENT_OPS: &str = include_str!("../../../shaders/fragment_ops.wgsl");
    pub const STATE: &str = include_str!("../../../shaders/state.wgsl");
    pub const FINE: &str = include_str!("../../../shaders/fine.wgsl");
    pub const TEXTURE: &str = include_str!("../../../shaders/texture.wgsl");
}

/// Reads the `//#` lines of a source.
pub fn expand(source: &str, options: &Options, out: &mut String) {
    expand_with(source, options, &mut Vec::new(), out);
}

/// Replaces `WORD(load, k)`: word `k` of what `//#load` loaded, the same for all lanes of a workgroup. Where a workgroup is
/// one subgroup of eight lanes, each lane loaded one word, which is broadcast; elsewhere it is read where it is wanted.
fn words_of_loads(line: &str, options: &Options, loads: &[(String, String)], out: &mut String) {
    let mut rest = line;
    while let Some(at) = rest.find("WORD(") {
        out.push_str(&rest[..at]);
        let end = at + rest[at..].find(')').expect("WORD( has its )");
        let (name, k) = rest[at + 5..end].split_once(',').expect("WORD(load, k)");
        let (name, k) = (name.trim(), k.trim());
        if options.flags.contains("SUBGROUP8") {
            let _ = write!(out, "subgroupBroadcast({name}, {k}u)");
        } else {
            let buffer = &loads.iter().rev().find(|l| l.0 == name).expect("a //#load before its WORD").1;
            let _ = write!(out, "{buffer}[{name}_at + {k}u]");
        }
        rest = &rest[end + 1..];
    }
    out.push_str(rest);
}

fn expand_with(source: &str, options: &Options, loads: &mut Vec<(String, String)>, out: &mut String) {
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
            Some("//#load") if open.iter().all(|&o| o) => {
                let (name, buffer) = (words.next().unwrap_or_default(), words.next().unwrap_or_default());
                let at = words.collect::<Vec<_>>().join(" ");
                if options.flags.contains("SUBGROUP8") {
                    let _ = writeln!(out, "let {name} = {buffer}[{at} + column];");
                } else {
                    let _ = writeln!(out, "let {name}_at = {at};");
                }
                loads.push((name.to_string(), buffer.to_string()));
            }
            Some("//#state") => expand_with(files::STATE, options, loads, out),
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
    let _ = writeln!(out, "const TP_ENTRY_WORDS = {}u;", super::encode::ENTRY_WORDS);
    words!(
        out,
        Triangle,
        "TP_TRIANGLE_DRAW" = draw,
        "TP_TRIANGLE_FLAGS" = flags,
        "TP_TRIANGLE_COLUMNS" = columns,
        "TP_TRIANGLE_ROWS" = rows,
        "TP_TRIANGLE_PLANES" = planes,
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
