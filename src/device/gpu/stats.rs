//! What a batch's kernels were built of and what was left out of them, for `TEPUI_STATS=1`: the twin of the CPU executor's.

use std::fmt::Write;

use super::encode::{Action, Plan};
use super::fine::{BlendKey, FineKey, feature};
use super::stage::front;
use crate::draw::Batch;

/// Names of what a fine kernel may contain.
const FINE: [(u32, &str); 21] = [
    (feature::SHADES, "a fragment program"),
    (feature::COLOR_WRITE, "colour"),
    (feature::DEPTH_TEST, "depth test"),
    (feature::DEPTH_WRITE, "depth writes"),
    (feature::STENCIL_TEST, "stencil"),
    (feature::BLEND, "blending"),
    (feature::ALPHA_TEST, "alpha test"),
    (feature::LOGIC_OP, "logic op"),
    (feature::COLOR_MASK, "colour masks"),
    (feature::STIPPLE, "polygon stipple"),
    (feature::PERSPECTIVE, "division by w"),
    (feature::CUT, "the scissor's bounds"),
    (feature::DEPTH_RANGE, "depth range"),
    (feature::OFFSET, "polygon offset"),
    (feature::MIXED, "flags by draw"),
    (feature::MIXED_INTERPOLATION, "interpolation by draw"),
    (feature::DROPS_SAMPLES, "sample masks"),
    (feature::ALPHA_TO_COVERAGE, "alpha to coverage"),
    (feature::ALPHA_TO_ONE, "alpha to one"),
    (feature::TALL, "unrolled rows"),
    (feature::CENTRES, "samples at centres"),
];

/// Names of what the kernels of set-up may contain.
const FRONT: [(u32, &str); 4] = [
    (front::POINTS_AND_LINES, "set-up of points and lines"),
    (front::UNFILLED, "set-up of outlines and corners"),
    (front::SMOOTH, "set-up of smooth points and lines"),
    (front::OFFSET, "set-up of polygon offset"),
];

fn named(names: &[(u32, &'static str)], bits: u32) -> Vec<&'static str> {
    names.iter().filter(|n| bits & n.0 != 0).map(|n| n.1).collect()
}

/// What a fine kernel contains.
fn contents(key: &FineKey) -> String {
    let mut parts: Vec<String> = named(&FINE, key.features).into_iter().map(String::from).collect();
    if !key.textures.is_empty() {
        parts.push(format!("{} texture{}", key.textures.len(), if key.textures.len() == 1 { "" } else { "s" }));
    }
    if key.samples > 1 {
        parts.push(format!("{} samples", key.samples));
    }
    if key.features & feature::BLEND != 0 && key.blend == BlendKey::Dynamic {
        parts.push("blending by draw".into());
    }
    parts.join(", ")
}

/// Prints a batch: what it held, what was built for it, what was left out. `host`: triangles, where the host has set them up.
pub fn print(batch: &Batch, plan: &Plan, host: Option<usize>, time: std::time::Duration) {
    let count = |which: fn(&Action) -> bool| plan.actions.iter().filter(|a| which(&a.1)).count();
    let draws = count(|a| matches!(a, Action::Draw(_)));
    let lists = count(|a| matches!(a, Action::Draw(draw) if !draw.is_direct()));
    let [keys, slices] = [count(|a| matches!(a, Action::Visible(_))), count(|a| matches!(a, Action::Front(..)))];
    let set_up = match host {
        Some(triangles) => format!("{triangles} triangles set up by the host"),
        None => {
            let own = plan.actions.iter().any(|a| matches!(&a.1, Action::Front(front) if !front.vertex.is_empty()));
            format!("{slices} slices set up by kernels{}", if own { " with their own vertices" } else { "" })
        }
    };
    let mut text = format!(
        "tepui: gpu: {} primitives, {} draws, {set_up}, {} segments, {} clears, {} of them by segments, encoded in {:.2} ms\n",
        batch.primitives.len(),
        batch.draws.len(),
        draws + keys,
        count(|a| matches!(a, Action::Clear(_) | Action::Absorbed)),
        count(|a| matches!(a, Action::Absorbed)),
        time.as_secs_f64() * 1e3,
    );
    let (mut fine, mut front_end, mut textures, mut samples) = (0, 0, false, false);
    let mut kernels: Vec<(&FineKey, String, usize)> = Vec::new();
    for (_, action) in &plan.actions {
        let (key, way) = match action {
            Action::Draw(draw) => (&draw.key, String::from(if draw.is_direct() { "tiles alone" } else { "lists" })),
            Action::Visible(visible) => {
                let bands = if visible.bands.len() > 1 { format!(" in {} bands of rows", visible.bands.len()) } else { String::new() };
                let soup = if plan.soup { ", vertices where they are wanted" } else { "" };
                (&visible.key, format!("keys{bands}{soup}"))
            }
            Action::Front(front) => {
                front_end |= front.features;
                continue;
            }
            Action::Clear(_) | Action::Absorbed => continue,
        };
        fine |= key.features;
        textures |= !key.textures.is_empty();
        samples |= key.samples > 1;
        match kernels.iter_mut().find(|k| k.0 == key && k.1 == way) {
            Some((.., n)) => *n += 1,
            None => kernels.push((key, way, 1)),
        }
    }
    for (key, way, n) in kernels {
        let _ = writeln!(text, "tepui:   {n} segment{} by {way}: {}", if n == 1 { "" } else { "s" }, contents(key));
    }
    let mut out = named(&FINE, !fine);
    if fine & (feature::DEPTH_BUFFER | feature::DEPTH_WRITE) == 0 {
        out.push("reading depth and stencil");
    }
    if !textures {
        out.push("textures");
    }
    if !samples {
        out.push("several samples");
    }
    if keys == 0 {
        out.push("keys");
    }
    if lists == 0 {
        out.push("lists (bin, count, scan, emit, tile)");
    }
    if host.is_some() {
        out.push("kernels of the front end");
    } else if slices > 0 {
        out.extend(named(&FRONT, !front_end));
    } else {
        out.push("cull, offsets, set-up");
    }
    let _ = write!(text, "tepui:   left out: {}", out.join(", "));
    eprintln!("{text}");
}
