//! What a batch held and which routines served it, for `TEPUI_STATS=1`.

use std::fmt::Write;
use std::sync::OnceLock;

use crate::draw::{Batch, Step};
use crate::raster::fine::Work;
use crate::raster::layout::{fragment_flags, raster_flags};
use crate::raster::plan::Plan;

/// Whether statistics are wanted.
pub fn wanted() -> bool {
    static WANTED: OnceLock<bool> = OnceLock::new();
    *WANTED.get_or_init(|| std::env::var("TEPUI_STATS").is_ok_and(|v| v != "0" && !v.is_empty()))
}

/// Prints a batch: what it held, what was built for it, what was left out. `tiles`: fully and partly covered ones.
pub fn print(batch: &Batch, plans: &[Plan], work: &[Work], tiles: [u64; 2], threads: usize) {
    let mut sum = [0usize; 5];
    for work in work {
        if let Work::Triangles(records) = work {
            let c = records.counts;
            let of = [c.triangles, c.planes, c.entries, c.dropped, c.clipped];
            (0..5).for_each(|k| sum[k] += of[k]);
        }
    }
    let [triangles, planes, entries, dropped, clipped] = sum;
    let vertices: u64 = batch.draws.iter().map(|d| d.record.vertex_count as u64).sum();
    let clears = batch.steps.iter().filter(|s| matches!(s, Step::Clear(_))).count();
    let mut text = format!(
        "tepui: batch on {threads} thread{}: {} draws, {clears} clears, {vertices} vertices, {} primitives ({dropped} dropped, {clipped} clipped) -> \
         {triangles} triangles, {} KiB of planes, {entries} bin entries, {} full and {} partly covered tiles\n",
        if threads == 1 { "" } else { "s" },
        batch.draws.len(),
        batch.primitives.len(),
        planes * 16 / 1024,
        tiles[0],
        tiles[1],
    );
    let mut routines: Vec<(&str, usize)> = Vec::new();
    for plan in plans {
        let name = plan.routine();
        match routines.iter_mut().find(|(n, _)| *n == name) {
            Some((_, n)) => *n += 1,
            None => routines.push((name, 1)),
        }
    }
    for (name, n) in routines {
        let _ = writeln!(text, "tepui:   {n} draws by {name}");
    }
    let states = |f: u32| batch.fragment_states.iter().any(|s| s.flags & f != 0);
    let mut out = Vec::new();
    for (flag, what) in [
        (fragment_flags::DEPTH_TEST, "depth test"),
        (fragment_flags::STENCIL_TEST, "stencil"),
        (fragment_flags::BLEND, "blending (colour is not read)"),
        (fragment_flags::ALPHA_TEST, "alpha test"),
        (fragment_flags::LOGIC_OP, "logic op"),
    ] {
        if !states(flag) {
            out.push(what);
        }
    }
    if batch.textures.is_empty() {
        out.push("texture");
    }
    if plans.iter().all(|p| p.direct.is_some()) {
        out.push("fragment programs");
    }
    if !batch.raster_states.iter().any(|s| s.flags & raster_flags::LINE_STIPPLE != 0) {
        out.push("line stipple");
    }
    if clipped == 0 {
        out.push("clipping");
    }
    let _ = write!(text, "tepui:   left out: {}", out.join(", "));
    eprintln!("{text}");
}
