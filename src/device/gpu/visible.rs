//! The visible path: opaque triangles with a depth test and writes need no lists; samples offer keys, the least one wins and is shaded. Which
//! segments may take it, and its buffers and kernels.

use super::adapter::Shape;
use super::fine::{FineKey, feature};
use super::glue::Planes;
use super::params::FrontParams;
use super::room::Room;
use super::source::{expand, files};
use crate::draw::Batch;
use crate::program::Program;
use crate::raster::layout::*;

/// Fewer triangles are drawn by lists: looking at every pixel of the surface would cost more.
pub const WORTH_IT: u32 = 2048;
/// Words of the queue's counters.
const COUNTERS: u32 = 8;
/// Lanes of the resolving kernel's workgroups.
pub const RESOLVE_LANES: u32 = 256;

/// Whether the fragments of a segment with this key may be drawn in any order, only the nearest being shaded.
pub fn serves(key: &FineKey, program: &Program) -> bool {
    let wanted = feature::DEPTH_TEST | feature::DEPTH_WRITE | feature::COLOR_WRITE | feature::SHADES;
    let allowed = wanted
        | feature::DEPTH_BUFFER
        | feature::PERSPECTIVE
        | feature::MIXED_INTERPOLATION
        | feature::CUT
        | feature::DEPTH_RANGE
        | feature::OFFSET;
    key.features & wanted == wanted
        && key.features & !allowed == 0
        && matches!(key.depth_func, Some(compare::LESS | compare::LEQUAL))
        // A key has room for 24 bits of depth.
        && key.depth_bits <= 24
        && !program.discards
        && !program.writes_depth
}

/// Whether a draw is of filled triangles.
pub fn is_filled(batch: &Batch, draw: usize) -> bool {
    let record = &batch.draws[draw].record;
    record.topology == topology::TRIANGLES && batch.raster_states[record.raster_state as usize].polygon_mode == [topology::TRIANGLES; 2]
}

/// The segment's depth function is LEQUAL, not LESS.
pub fn is_lequal(key: &FineKey) -> bool {
    key.depth_func == Some(compare::LEQUAL)
}

/// Parameters for the primitives of a segment, and the words of the queue that they take.
pub fn params(room: &Room, primitives: std::ops::Range<u32>, base: FrontParams) -> (FrontParams, u32) {
    let count = primitives.end - primitives.start;
    let item_capacity = room.items(count);
    let clipped = room.clipped(count);
    let item_base = COUNTERS;
    let queue_base = item_base + item_capacity * 3;
    let fan_base = queue_base + clipped;
    let fan_capacity = clipped * 2;
    let map_base = fan_base + fan_capacity * 3;
    let params = FrontParams {
        first_primitive: primitives.start,
        primitive_count: count,
        item_base,
        item_capacity,
        queue_base,
        queue_capacity: clipped,
        fan_base,
        fan_capacity,
        map_base,
        pool_capacity: room.pool(count),
        ..base
    };
    (params, map_base + count)
}

/// The text of the kernel that shades what is visible.
pub fn resolve_source(key: &FineKey, shape: Shape, program: &Program, constants: &str) -> String {
    // The depth is in the key.
    let depth = feature::DEPTH_TEST | feature::DEPTH_WRITE | feature::DEPTH_BUFFER;
    let without = FineKey { features: key.features & !depth, depth_func: None, ..key.clone() };
    let shape = Shape { subgroup8: false, ..shape };
    let (mut options, extra) = without.options(shape, program, Planes::Computed);
    options.flag("VISIBLE", true);
    options.flag("RESOLVE", true);
    options.flag("LEQUAL", is_lequal(key));
    let mut source = format!("const TP_LANES = {RESOLVE_LANES}u;\n{extra}{constants}");
    for file in [files::COMMON, files::FRONT, files::VISIBLE, files::ARITHMETIC, files::PRIMITIVE, files::CORNER] {
        expand(file, &options, &mut source);
    }
    without.shading(&options, program, &mut source);
    expand(files::VISIBLE_RESOLVE, &options, &mut source);
    source
}
