// Per-fragment tests: alpha, stencil, depth, polygon stipple, and the words of a draw's state that they read.

// A word of the records.
fn tp_record(at: u32) -> u32 {
//#if VECTORS
    return tp_records[at >> 2u][at & 3u];
//#else
    return tp_records[at];
//#endif
}

struct TpState {
    flags: u32,
    depth_func: u32,
    depth_range: vec2<f32>,
    alpha_func: u32,
    alpha_ref: u32,
    stencil_func: u32,
    stencil_ref: u32,
    stencil_read: u32,
    stencil_write: u32,
    stencil_ops: vec3<u32>,
    factors: vec4<u32>,
    equations: vec2<u32>,
    logic_op: u32,
    color_mask: u32,
    blend_color: vec4<f32>,
    stipple: u32,
}

// Every function is a mask of what it accepts: 1 less, 2 equal, 4 greater.
fn tp_accepts(func: u32, less: bool, equal: bool, greater: bool) -> bool {
    return (func & (select(0u, 1u, less) | select(0u, 2u, equal) | select(0u, 4u, greater))) != 0u;
}

fn tp_alpha_test(s: TpState, a: f32) -> bool {
    // In the precision of an eight-bit colour buffer.
    let v = bitcast<u32>(tp_mul(min(max(a, 0.0), 1.0), 255.0) + 8388608.0) & 255u;
    let r = s.alpha_ref;
    return (s.flags & TP_ALPHA_TEST_ON) == 0u || tp_accepts(s.alpha_func, (v < r), (v == r), (v > r));
}

fn tp_depth_test(s: TpState, fresh: u32, old: u32) -> bool {
    return (s.flags & TP_DEPTH_TEST_ON) == 0u || tp_accepts(s.depth_func, (fresh < old), (fresh == old), (fresh > old));
}

fn tp_quantise(s: TpState, z: f32) -> u32 {
//#if DEPTH_RANGE
    let clamped = min(max(z, s.depth_range.x), s.depth_range.y);
//#else
    let clamped = saturate(z);
//#endif
//#if FLOAT_DEPTH
    // Its bits. Numbers below the normal ones become zero, as on a device that has none.
    let bits = bitcast<i32>(clamped);
    return u32(select(0, bits, bits >= 0x800000));
//#else
    return tp_round(tp_mul(clamped, TP_DEPTH_SCALE));
//#endif
}

fn tp_stencil_test(s: TpState, old: u32) -> bool {
    let r = s.stencil_ref & s.stencil_read;
    let v = old & s.stencil_read;
    return (s.flags & TP_STENCIL_TEST_ON) == 0u || tp_accepts(s.stencil_func, (r < v), (r == v), (r > v));
}

fn tp_stencil_update(s: TpState, old: u32, stencil_pass: bool, depth_pass: bool) -> u32 {
    let op = select(select(s.stencil_ops.x, s.stencil_ops.y, stencil_pass), s.stencil_ops.z, stencil_pass && depth_pass);
    var v = old;
    v = select(v, 0u, op == 1u);
    v = select(v, s.stencil_ref, op == 2u);
    v = select(v, min(old + 1u, 255u), op == 3u);
    v = select(v, max(old, 1u) - 1u, op == 4u);
    v = select(v, ~old & 255u, op == 5u);
    v = select(v, (old + 1u) & 255u, op == 6u);
    v = select(v, (old - 1u) & 255u, op == 7u);
    v = (v & s.stencil_write) | (old & ~s.stencil_write);
    return select(v, old, (s.flags & TP_STENCIL_TEST_ON) == 0u);
}

//#if STIPPLE
fn tp_stipple(s: TpState, flags: u32, px: u32, py: u32) -> bool {
    let on = (flags & TP_POLYGON) != 0u && s.stipple != 0xffffffffu;
    let row = select(py, tp.size.y - 1u - py, tp.top_first != 0u);
    let word = tp_record(select(0u, s.stipple, on) + (row & 31u));
    return !on || ((word >> (31u - (px & 31u))) & 1u) != 0u;
}
//#endif

// A pixel and a depth word before the segment's first fragment; `fresh` says what a clear has just written, which is not read back.
fn tp_first_pixel(at: u32, fresh: u32) -> TpPixel {
    var p = tp_pixel_of(tp.clear_color);
    if ((fresh & TP_FRESH_COLOR) == 0u) {
        p = tp_load_pixel(at);
    }
    return p;
}

fn tp_first_depth(at: u32, fresh: u32) -> u32 {
    var word = tp.clear_depth;
    if ((fresh & TP_FRESH_DEPTH) == 0u) {
        word = tp_depth[at];
    }
    return word;
}
