// Bindings and helpers of the stages behind the front end (bin, scan, emit, tile, fine, clear).
//
// All names of the kernels start with `tp_`, so that they never meet a name of a spliced program. Word offsets into
// the records (TP_DRAW_*, TP_TRIANGLE_*, ...) are generated from src/raster/layout.rs.

// What a dispatch works on; the fields are explained in src/device/gpu/params.rs.
struct TpParams {
    size: vec2<u32>,
    bins: vec2<u32>,
    mask_base: u32,
    count_base: u32,
    bin_base: u32,
    active_base: u32,
    list_base: u32,
    tile_base: u32,
    entry_base: u32,
    work_base: u32,
    list_blocks: u32,
    top_first: u32,
    draws: u32,
    segment: u32,
    // -0, see tp_mul.
    zero: f32,
    depth_max: u32,
    clear_depth: u32,
    clear_depth_mask: u32,
    clear_min: vec2<i32>,
    clear_max: vec2<i32>,
    clear_color: vec4<u32>,
    clear_mask: vec4<u32>,
    action: u32,
    // 2^23.
    magic: f32,
    samples: u32,
    fresh: u32,
}

//#if VISIBLE
//#else
@group(0) @binding(0) var<storage, read> uniforms: array<vec4<f32>>;
//#if TRIANGLE_VECTORS
@group(0) @binding(2) var<storage, read> tp_triangles: array<vec4<u32>>;
//#else
//#if TRIANGLE_PAIRS
@group(0) @binding(2) var<storage, read> tp_triangles: array<u64>;
//#else
@group(0) @binding(2) var<storage, read> tp_triangles: array<u32>;
//#endif
//#endif
//#if VECTORS
// A GPU loads four words as fast as one.
@group(0) @binding(1) var<storage, read> tp_records: array<vec4<u32>>;
@group(0) @binding(3) var<storage, read> tp_planes: array<vec4<f32>>;
@group(0) @binding(4) var<storage, read_write> tp_lists: array<vec4<u32>>;
//#else
@group(0) @binding(1) var<storage, read> tp_records: array<u32>;
//#if PAIRS
@group(0) @binding(3) var<storage, read> tp_planes: array<u64>;
//#else
@group(0) @binding(3) var<storage, read> tp_planes: array<f32>;
//#endif
//#if PAIRS
@group(0) @binding(4) var<storage, read_write> tp_lists: array<u64>;
//#else
//#if ATOMIC_LISTS
@group(0) @binding(4) var<storage, read_write> tp_lists: array<atomic<u32>>;
//#else
@group(0) @binding(4) var<storage, read_write> tp_lists: array<u32>;
//#endif
//#endif
//#endif
@group(0) @binding(5) var<storage, read_write> tp_color: array<u32>;
@group(0) @binding(6) var<storage, read_write> tp_depth: array<u32>;
//#if TEXEL_PAIRS
@group(0) @binding(7) var tp_texels: texture_storage_2d<rg32uint, read>;
//#else
@group(0) @binding(7) var<storage, read> tp_texels: array<u32>;
//#endif
// The segments' triangles, TP_SEGMENT_WORDS each: first triangle, triangles, blocks of 32, super blocks of 1024.
@group(0) @binding(8) var<storage, read> tp_segments: array<u32>;
@group(0) @binding(9) var<uniform> tp: TpParams;

fn tp_zero() -> f32 {
    return tp.zero;
}

fn tp_first_triangle() -> u32 {
    return tp_segments[tp.segment * TP_SEGMENT_WORDS];
}

fn tp_triangle_count() -> u32 {
    return tp_segments[tp.segment * TP_SEGMENT_WORDS + 1u];
}

fn tp_blocks() -> u32 {
    return tp_segments[tp.segment * TP_SEGMENT_WORDS + 2u];
}

fn tp_supers() -> u32 {
    return tp_segments[tp.segment * TP_SEGMENT_WORDS + 3u];
}
//#endif

//#if TRIANGLES
// Words 2 k and 2 k + 1 of a triangle.
fn tp_triangle_words(base: u32, k: u32) -> vec2<u32> {
//#if TRIANGLE_VECTORS
    let four = tp_triangles[(base >> 2u) + (k >> 1u)];
    return select(four.zw, four.xy, (k & 1u) == 0u);
//#else
//#if TRIANGLE_PAIRS
    let pair = tp_triangles[(base >> 1u) + k];
    return vec2<u32>(u32(pair & 0xfffffffflu), u32(pair >> 32u));
//#else
    return vec2<u32>(tp_triangles[base + k * 2u], tp_triangles[base + k * 2u + 1u]);
//#endif
//#endif
}

// Its corners: three x and three y.
struct TpCorners {
    x: vec3<i32>,
    y: vec3<i32>,
}

fn tp_corners(base: u32) -> TpCorners {
    let a = bitcast<vec2<i32>>(tp_triangle_words(base, 0u));
    let b = bitcast<vec2<i32>>(tp_triangle_words(base, 1u));
    let c = bitcast<vec2<i32>>(tp_triangle_words(base, 2u));
    return TpCorners(vec3<i32>(a, b.x), vec3<i32>(b.y, c));
}
//#endif

// Edge function i of a triangle: dx * (y - y_i) - dy * (x - x_i), with dx = x_i - x_j, dy = y_i - y_j, j the next vertex;
// positive inside. 0 where samples on the edge itself belong to the triangle, else 1. Left edges do, and of the horizontal ones
// those at the bottom as GL sees it: greatest row of a surface whose top row is first, else least row.
fn tp_edge_bias(dx: i32, dy: i32) -> u32 {
    let bottom = select(dx > 0, dx < 0, tp.top_first != 0u);
    return select(1u, 0u, dy < 0 || (dy == 0 && bottom));
}
