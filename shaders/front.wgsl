// Bindings of the front end: vertex, cull, offsets, set-up, clip. It turns primitives into set-up triangles in primitive order.
//
// cull counts what each primitive will make; offsets adds the counts up, so that every primitive knows its place; set-up and clip
// write there. Nothing is sorted and no place is claimed by an atomic: the same input fills the same words.

// What the front end works on; the fields are explained in src/device/gpu/params.rs.
struct TpFront {
    groups: u32,
    group_base: u32,
    segments: u32,
    first_segment: u32,
    segment_base: u32,
    sums_base: u32,
    queue_base: u32,
    queue_capacity: u32,
    triangle_capacity: u32,
    plane_capacity: u32,
    pool_base: u32,
    pool_capacity: u32,
    block_base: u32,
    state_base: u32,
    bins: u32,
    bin_rows: u32,
    list_lanes: u32,
    top_first: u32,
    // -0, see tp_mul.
    zero: f32,
    action: u32,
    vertex_blocks: u32,
    first_primitive: u32,
    primitive_count: u32,
    item_base: u32,
    item_capacity: u32,
    fan_base: u32,
    fan_capacity: u32,
    map_base: u32,
    tile_base: u32,
    tile_count: u32,
    shaded_base: u32,
    shaded_count: u32,
    first_row: i32,
    end_row: i32,
}

//#if VISIBLE
//#else
//#if VERTEX
@group(0) @binding(0) var<storage, read> uniforms: array<vec4<f32>>;
@group(0) @binding(1) var<storage, read> tp_vertices: array<f32>;
//#endif
// {v0, v1, v2, draw and flags} each.
@group(0) @binding(2) var<storage, read> tp_primitives: array<vec4<u32>>;
// Draws, raster states, blocks of vertices, groups of primitives.
@group(0) @binding(3) var<storage, read> tp_front_records: array<u32>;
// Shaded vertices as their draws lay them out; behind them the pool: vertices that clipping makes.
@group(0) @binding(4) var<storage, read_write> tp_shaded: array<vec4<f32>>;
@group(0) @binding(5) var<storage, read_write> tp_triangles: array<u32>;
@group(0) @binding(6) var<storage, read_write> tp_planes: array<vec4<f32>>;
// Segments (TP_SEGMENT_WORDS each), sums of counts, the queue of primitives to clip.
@group(0) @binding(7) var<storage, read_write> tp_front: array<u32>;
@group(0) @binding(8) var<uniform> tf: TpFront;

fn tp_zero() -> f32 {
    return tf.zero;
}
//#endif

//#if SET_UP
//#else
// A window coordinate in 1/256 pixel from the centre of pixel 0, rounded to the nearest (even).
fn tp_snap(v: f32) -> i32 {
    let low = select(TP_COORDINATE_MIN, v, v > TP_COORDINATE_MIN);
    let high = select(TP_COORDINATE_MAX, low, low < TP_COORDINATE_MAX);
    return i32(round((high - 0.5) * 256.0));
}

fn tp_state_float(state: u32, word: u32) -> f32 {
    return bitcast<f32>(tp_front_records[state + word]);
}

fn tp_viewport_scale(state: u32) -> vec3<f32> {
    let at = state + TP_STATE_VIEWPORT_SCALE;
    return bitcast<vec3<f32>>(vec3<u32>(tp_front_records[at], tp_front_records[at + 1u], tp_front_records[at + 2u]));
}

fn tp_viewport_translate(state: u32) -> vec3<f32> {
    let at = state + TP_STATE_VIEWPORT_TRANSLATE;
    return bitcast<vec3<f32>>(vec3<u32>(tp_front_records[at], tp_front_records[at + 1u], tp_front_records[at + 2u]));
}
//#endif
