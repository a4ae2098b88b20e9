// Per-fragment tests: alpha, stencil, depth, polygon stipple, and the words of a draw's state that they read.

struct TpState {
    flags: u32,
    depth_func: u32,
    depth_range: vec2<f32>,
    alpha_func: u32,
    alpha_ref: f32,
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

fn tp_load_state(draw: u32, column: u32, flags: u32) -> TpState {
    var s: TpState;
    let at = tp.fragment_states + tp_records[draw + TP_DRAW_FRAGMENT_STATE] * TP_FRAGMENT_WORDS;
//#if STATE_FLAGS
    s.flags = tp_records[at + TP_FRAGMENT_FLAGS];
//#else
    // What the kernel contains is on in every draw.
    s.flags = 0xffffffffu;
//#endif
//#if DEPTH_TEST
    s.depth_func = tp_records[at + TP_FRAGMENT_DEPTH_FUNC];
//#endif
//#if ALPHA_TEST
    s.alpha_func = tp_records[at + TP_FRAGMENT_ALPHA_FUNC];
    s.alpha_ref = bitcast<f32>(tp_records[at + TP_FRAGMENT_ALPHA_REF]);
//#endif
//#if STENCIL_TEST
    let face = at + TP_FRAGMENT_STENCIL + select(TP_STENCIL_WORDS, 0u, (flags & TP_FRONT) != 0u);
    s.stencil_func = tp_records[face];
    s.stencil_ref = tp_records[face + 1u];
    s.stencil_read = tp_records[face + 2u];
    s.stencil_write = tp_records[face + 3u];
    s.stencil_ops = vec3<u32>(tp_records[face + 4u], tp_records[face + 5u], tp_records[face + 6u]);
//#endif
//#if BLEND_DYNAMIC
    let f = at + TP_FRAGMENT_BLEND_FACTORS;
    s.factors = vec4<u32>(tp_records[f], tp_records[f + 1u], tp_records[f + 2u], tp_records[f + 3u]);
    s.equations = vec2<u32>(tp_records[f + 4u], tp_records[f + 5u]);
//#endif
//#if BLEND_CONSTANT
    let b = at + TP_FRAGMENT_BLEND_COLOR;
    s.blend_color = vec4<f32>(bitcast<f32>(tp_records[b]), bitcast<f32>(tp_records[b + 1u]), bitcast<f32>(tp_records[b + 2u]), bitcast<f32>(tp_records[b + 3u]));
//#endif
//#if LOGIC_OP
    s.logic_op = tp_records[at + TP_FRAGMENT_LOGIC_OP];
//#endif
//#if COLOR_MASK
    s.color_mask = tp_records[at + TP_FRAGMENT_COLOR_MASK];
//#endif
//#if RASTER_STATE
    let raster = tp.raster_states + tp_records[draw + TP_DRAW_RASTER_STATE] * TP_RASTER_WORDS;
    s.depth_range = vec2<f32>(bitcast<f32>(tp_records[raster + TP_RASTER_DEPTH_RANGE]), bitcast<f32>(tp_records[raster + TP_RASTER_DEPTH_RANGE + 1u]));
    s.stipple = tp_records[raster + TP_RASTER_POLYGON_STIPPLE];
//#endif
    return s;
}

fn tp_alpha_test(s: TpState, a: f32) -> bool {
    // In the precision of an eight-bit colour buffer.
    let v = u32(round(clamp(a, 0.0, 1.0) * 255.0));
    let r = u32(round(clamp(s.alpha_ref, 0.0, 1.0) * 255.0));
    return (s.flags & TP_ALPHA_TEST_ON) == 0u || tp_accepts(s.alpha_func, (v < r), (v == r), (v > r));
}

fn tp_depth_test(s: TpState, fresh: u32, old: u32) -> bool {
    return (s.flags & TP_DEPTH_TEST_ON) == 0u || tp_accepts(s.depth_func, (fresh < old), (fresh == old), (fresh > old));
}

fn tp_quantise(s: TpState, z: f32) -> u32 {
    let clamped = min(max(z, s.depth_range.x), s.depth_range.y);
    return u32(round(clamped * f32(tp.depth_max)));
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
    let word = tp_records[tp.stipples + select(0u, s.stipple, on) * 32u + (row & 31u)];
    return !on || ((word >> (31u - (px & 31u))) & 1u) != 0u;
}
//#endif
