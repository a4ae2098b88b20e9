// Bindings and helpers of the stages behind the front end (bin, scan, emit, tile, fine, clear).
//
// All names of the kernels start with `tp_`, so that they never meet a name of a spliced program. Word offsets into
// the records (TP_DRAW_*, TP_TRIANGLE_*, ...) are generated from src/raster/layout.rs.

// What a dispatch works on; the fields are explained in src/device/gpu/params.rs.
struct TpParams {
    size: vec2<u32>,
    bins: vec2<u32>,
    first_triangle: u32,
    triangle_count: u32,
    blocks: u32,
    supers: u32,
    mask_base: u32,
    count_base: u32,
    bin_base: u32,
    active_base: u32,
    list_base: u32,
    tile_base: u32,
    entry_base: u32,
    list_blocks: u32,
    top_first: u32,
    draws: u32,
    work_base: u32,
    reserved1: u32,
    reserved2: u32,
    depth_max: u32,
    clear_depth: u32,
    clear_depth_mask: u32,
    clear_min: vec2<i32>,
    clear_max: vec2<i32>,
    clear_color: vec4<u32>,
    clear_mask: vec4<u32>,
}

@group(0) @binding(0) var<storage, read> uniforms: array<vec4<f32>>;
@group(0) @binding(1) var<storage, read> tp_records: array<u32>;
@group(0) @binding(2) var<storage, read> tp_triangles: array<u32>;
@group(0) @binding(3) var<storage, read> tp_planes: array<f32>;
//#if ATOMIC_LISTS
@group(0) @binding(4) var<storage, read_write> tp_lists: array<atomic<u32>>;
//#else
@group(0) @binding(4) var<storage, read_write> tp_lists: array<u32>;
//#endif
@group(0) @binding(5) var<storage, read_write> tp_color: array<u32>;
@group(0) @binding(6) var<storage, read_write> tp_depth: array<u32>;
@group(0) @binding(7) var<storage, read> tp_texels: array<u32>;
@group(0) @binding(8) var<uniform> tp: TpParams;

// Low and high word of a * b, signed.
fn tp_mul64(a: i32, b: i32) -> vec2<u32> {
    let ua = bitcast<u32>(a);
    let ub = bitcast<u32>(b);
    let al = ua & 0xffffu;
    let ah = ua >> 16u;
    let bl = ub & 0xffffu;
    let bh = ub >> 16u;
    let ll = al * bl;
    let m = ah * bl + (ll >> 16u);
    let n = al * bh + (m & 0xffffu);
    var high = ah * bh + (m >> 16u) + (n >> 16u);
    // The unsigned product counts a negative factor 2^32 too often.
    high -= select(0u, ub, a < 0) + select(0u, ua, b < 0);
    return vec2<u32>((n << 16u) | (ll & 0xffffu), high);
}

// floor((a*b - c*d - bias) / 2^shift), saturated to +-2^30: an edge function in whole steps of 2^shift subpixels.
fn tp_edge_floor(a: i32, b: i32, c: i32, d: i32, bias: u32, shift: u32) -> i32 {
    let p = tp_mul64(a, b);
    let q = tp_mul64(c, d);
    var low = p.x - q.x;
    var high = p.y - q.y - select(0u, 1u, p.x < q.x);
    high -= select(0u, 1u, low < bias);
    low -= bias;
    let h = bitcast<i32>(high);
    let inside = (high << (32u - shift)) | (low >> shift);
    let limit = 1i << (shift - 2u);
    return select(select(bitcast<i32>(inside), 0x40000000, h >= limit), -0x40000000, h < -limit);
}

// Edge function i of a triangle: dx * (y - y_i) - dy * (x - x_i), with dx = x_i - x_j, dy = y_i - y_j, j the next vertex;
// positive inside. 0 where samples on the edge itself belong to the triangle, else 1. Left edges do, and of the horizontal ones
// those at the bottom as GL sees it: greatest row of a surface whose top row is first, else least row.
fn tp_edge_bias(dx: i32, dy: i32) -> u32 {
    let bottom = select(dx > 0, dx < 0, tp.top_first != 0u);
    return select(1u, 0u, dy < 0 || (dy == 0 && bottom));
}

// a * b + c, rounded once. Mesa's lavapipe splits fma, so there it is worked out in double precision: the product is exact.
fn tp_fma(a: f32, b: f32, c: f32) -> f32 {
//#if FMA64
    return f32(f64(a) * f64(b) + f64(c));
//#else
    return fma(a, b, c);
//#endif
}

fn tp_fma4(a: f32, b: vec4<f32>, c: vec4<f32>) -> vec4<f32> {
//#if FMA64
    return vec4<f32>(tp_fma(a, b.x, c.x), tp_fma(a, b.y, c.y), tp_fma(a, b.z, c.z), tp_fma(a, b.w, c.w));
//#else
    return fma(vec4<f32>(a), b, c);
//#endif
}
