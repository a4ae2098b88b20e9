//! The visible path: opaque triangles with a depth test and writes need no lists; samples offer keys, the least one wins and is shaded. Which
//! segments may take it, and its buffers and kernels.

use super::adapter::Shape;
use super::fine::{FineKey, feature};
use super::glue::Planes;
use super::params::FrontParams;
use super::room::Room;
use super::source::{expand, files};
use super::stage::shaded;
use crate::draw::Batch;
use crate::program::Program;
use crate::raster::layout::*;

/// Fewer triangles are drawn by lists: looking at every pixel of the surface would cost more.
pub const WORTH_IT: u32 = 2048;
/// Most pixels of the tiles that they touch for each triangle that the host has set up: the resolving kernel looks at all of them.
pub const WORTH_IT_AREA: u64 = 32;
/// Most pixels, on average, of the rectangles of such triangles: an atomic minimum costs more than a register, and lists shade
/// a pixel once too (`shaders/fine_deferred.wgsl`).
pub const WORTH_IT_PIXELS: u64 = 48;
/// Words of the queue's counters.
const COUNTERS: u32 = 8;
/// Most samples of a triangle that a lane looks at by itself, in how many columns or rows, and the length of its edges in 1/256 pixel:
/// `shaders/keys.wgsl`.
const SMALL: u32 = 512;
const SMALL_SIDE: u32 = 64;
const NEAR: u32 = 0x4000;
/// Lanes of the resolving kernel's workgroups.
pub const RESOLVE_LANES: u32 = 256;

/// Whether the fragments of a segment with this key may be drawn in any order, only the nearest being shaded.
pub fn serves(key: &FineKey, program: &Program) -> bool {
    // A key has room for 24 bits of depth.
    key.is_opaque(program) && matches!(key.depth_func, Some(compare::LESS | compare::LEQUAL)) && key.depth_bits <= 24
}

/// Most expressions of a vertex program that runs for each pixel that is seen: a transform and some attributes that pass through.
const SHORT: usize = 112;

/// Expressions of a program's text.
fn length(program: &Program) -> usize {
    program.module.functions.iter().map(|(_, f)| f.expressions.len()).sum()
}

/// Whether running a vertex program again costs little more than reading what it wrote.
pub fn is_short(program: &Program) -> bool {
    length(program) <= SHORT
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

/// The same of triangles that the host has set up. Their kernels leave the depth range out.
pub fn serves_set_up(key: &FineKey, program: &Program) -> bool {
    key.features & feature::DEPTH_RANGE == 0 && serves(key, program)
}

/// Columns and rows of the rectangle of a triangle.
pub fn extent(t: &Triangle) -> [u32; 2] {
    [t.columns, t.rows].map(|v| (v >> 16) - (v & 0xffff) + 1)
}

/// The tiles of 8 x 8 pixels, row by row on a surface of `columns` tiles a row and `rows` rows of them, that triangles' rectangles touch.
pub fn touched(triangles: &[Triangle], [columns, rows]: [u32; 2]) -> Vec<u32> {
    let mut touched = vec![false; columns as usize * rows as usize];
    for t in triangles {
        let [x, y] = [t.columns, t.rows].map(|v| (v & 0xffff) / 8..=(v >> 16) / 8);
        for row in y {
            touched[(row * columns + x.start()) as usize..=(row * columns + x.end()) as usize].fill(true);
        }
    }
    touched.into_iter().zip(0..).filter(|t| t.0).map(|t| t.1).collect()
}

/// Parameters for the triangles of a segment that the host has set up. Queues the blocks of the large ones and the tiles that they touch:
/// `items` holds what the queue will.
pub fn set_up(triangles: &[Triangle], tiles: &[u32], first: usize, items: &mut Vec<u32>, base: FrontParams) -> FrontParams {
    if items.is_empty() {
        items.resize(COUNTERS as usize, 0);
    }
    let item_base = items.len() as u32;
    for (t, k) in triangles.iter().zip(first as u32..) {
        let [width, height] = extent(t);
        let near = |v: [i32; 3]| (0..3).all(|i| v[i].abs_diff(v[(i + 1) % 3]) < NEAR);
        if width <= SMALL_SIDE && height <= SMALL_SIDE && width * height <= SMALL && near(t.x) && near(t.y) {
            continue;
        }
        for row in 0..height.div_ceil(64) {
            items.extend((0..width.div_ceil(64)).flat_map(|column| [k, 0, column | row << 16]));
        }
    }
    let tile_base = items.len() as u32;
    items.extend_from_slice(tiles);
    FrontParams {
        first_primitive: first as u32,
        primitive_count: triangles.len() as u32,
        item_base,
        item_capacity: (tile_base - item_base) / 3,
        tile_base,
        tile_count: tiles.len() as u32,
        ..base
    }
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
pub fn resolve_source(key: &FineKey, shape: Shape, program: &Program, soup: Option<&Program>, constants: &str) -> String {
    // The depth is in the key.
    let depth = feature::DEPTH_TEST | feature::DEPTH_WRITE | feature::DEPTH_BUFFER;
    let without = FineKey { features: key.features & !depth, depth_func: None, ..key.clone() };
    let shape = Shape { subgroup8: false, ..shape };
    let planes = if shape.host_front { Planes::Pairs } else { Planes::Computed };
    let (mut options, extra) = without.options(shape, program, planes);
    options.flag("SET_UP", shape.host_front);
    options.flag("SUBGROUP8", key.features & feature::ONE_DRAW != 0);
    options.flag("TRIANGLES", shape.host_front);
    options.flag("TRIANGLE_PAIRS", shape.host_front);
    options.flag("VISIBLE", true);
    options.flag("INT64", true);
    options.flag("RESOLVE", true);
    options.flag("SOUP", soup.is_some());
    options.flag("LEQUAL", is_lequal(key));
    let mut source = format!("const TP_LANES = {RESOLVE_LANES}u;\n{extra}{constants}");
    for file in [files::COMMON, files::FRONT, files::VISIBLE, files::ARITHMETIC] {
        expand(file, &options, &mut source);
    }
    if !shape.host_front {
        shaded(soup, &mut options, &mut source);
        for file in [files::SCREEN, files::PRIMITIVE, files::CORNER] {
            expand(file, &options, &mut source);
        }
    }
    without.shading(&options, program, &mut source);
    expand(files::VISIBLE_RESOLVE, &options, &mut source);
    source
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::fixed::{self, LightingKey, TexCoordKey, VertexKey};

    fn triangle(columns: [u32; 2], rows: [u32; 2], reach: i32) -> Triangle {
        let packed = |v: [u32; 2]| v[0] | v[1] << 16;
        Triangle { x: [0, reach, 0], y: [0, 0, 256], columns: packed(columns), rows: packed(rows), ..Triangle::default() }
    }

    #[test]
    fn programs_that_pass_attributes_through_are_short_and_lighting_is_not() {
        let colored = VertexKey { color: true, ..VertexKey::default() };
        let unit = TexCoordKey { used: true, ..TexCoordKey::default() };
        let mut textured = colored;
        textured.units[..2].fill(unit);
        let lit =
            VertexKey { lighting: LightingKey { enabled: true, lights: [1, 0, 0, 0, 0, 0, 0, 0], ..LightingKey::default() }, ..colored };
        for (key, short) in [(colored, true), (textured, true), (lit, false)] {
            let program = &fixed::vertex_program(&key).program;
            assert_eq!(is_short(program), short, "{} expressions", length(program));
        }
    }

    #[test]
    fn triangles_that_a_lane_cannot_draw_are_queued_in_blocks() {
        let all = [
            triangle([3, 10], [5, 12], 8 * 256),
            // 101 x 70 pixels: two blocks of two.
            triangle([20, 120], [0, 69], 100 * 256),
            // The scissor left a pixel, but its edges are long.
            triangle([7, 7], [9, 9], NEAR as i32),
            // 32 x 16 samples are as many as a lane looks at, 32 x 17 are not.
            triangle([0, 31], [0, 15], 31 * 256),
            triangle([0, 31], [0, 16], 31 * 256),
        ];
        let mut items = Vec::new();
        let tiles = touched(&all, [16, 9]);
        let params = set_up(&all, &tiles, 100, &mut items, FrontParams::default());
        assert_eq!((params.first_primitive, params.primitive_count, params.item_base, params.item_capacity), (100, 5, COUNTERS, 6));
        let queued: Vec<_> = items[COUNTERS as usize..params.tile_base as usize].chunks(3).map(|i| (i[0], i[2])).collect();
        assert_eq!(queued, [(101, 0), (101, 1), (101, 1 << 16), (101, 1 | 1 << 16), (102, 0), (104, 0)]);
        assert_eq!(items[params.tile_base as usize..], tiles);
        assert_eq!(params.tile_count as usize, tiles.len());
    }

    #[test]
    fn tiles_are_touched_by_rectangles() {
        // Columns 7 and 8 are of two tiles, rows 15 and 16 too; the second lies inside the first, the third at the surface's end.
        let all = [triangle([7, 8], [15, 16], 256), triangle([8, 9], [16, 17], 256), triangle([31, 31], [39, 39], 256)];
        assert_eq!(touched(&all, [4, 5]), [4, 5, 8, 9, 19]);
    }
}
