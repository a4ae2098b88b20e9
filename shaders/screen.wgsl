// Shaded vertices on the screen: window coordinates and clip codes, worked out where they are wanted. A vertex is wanted some six times, and
// that is cheaper than to keep 32 more bytes of each.

// A vertex on the screen.
struct TpCorner {
    position: vec3<f32>,
    inv_w: f32,
    snapped: vec2<i32>,
    // Its first vec4 among the shaded vertices.
    at: u32,
}

fn tp_frustum_code(p: vec4<f32>, flags: u32) -> u32 {
    var code = select(0u, TP_CLIP_RIGHT, p.x > p.w) | select(0u, TP_CLIP_LEFT, p.x + p.w < 0.0);
    code |= select(0u, TP_CLIP_TOP, p.y > p.w) | select(0u, TP_CLIP_BOTTOM, p.y + p.w < 0.0);
    if ((flags & TP_NO_Z_CLIP) == 0u) {
        code |= select(0u, TP_CLIP_NEAR, p.z + p.w < 0.0) | select(0u, TP_CLIP_FAR, p.z > p.w);
    }
    // The sum is finite where all four are, but for overflow, which draws nothing either.
    let sum = p.x + p.y + p.z + p.w;
    let all_zero = p.w == 0.0 && p.x == 0.0 && p.y == 0.0 && p.z == 0.0;
    return select(code, code | TP_CLIP_INVALID, !tp_finite(sum) || all_zero);
}

// Four user clip distances, the first of them number `first` of `count`.
fn tp_user_code(distances: vec4<f32>, first: u32, count: u32) -> u32 {
    var code = 0u;
    for (var k = 0u; k < 4u; k++) {
        code |= select(0u, TP_CLIP_USER << (first + k), first + k < count && distances[k] < 0.0);
    }
    return code;
}

// Inside the frustum, and far from what overflows: without a clip code, unless the user's planes give it one.
fn tp_is_inside(p: vec4<f32>) -> bool {
    return abs(p.x) <= p.w && abs(p.y) <= p.w && abs(p.z) <= p.w && p.w > 0.0 && p.w < 1e37;
}

// The clip code of the vertex at `at` of the shaded ones, whose clip position is p: the frustum's planes and the user's that it lies behind.
fn tp_clip_code(p: vec4<f32>, at: u32, record: u32, flags: u32) -> u32 {
    var code = 0u;
    let count = tp_front_records[record + TP_DRAW_CLIP_DISTANCE_COUNT];
    let distances = at + tp_front_records[record + TP_DRAW_CLIP_DISTANCES];
    for (var first = 0u; first < count; first += 4u) {
        code |= tp_user_code(tp_read(record, distances + first / 4u), first, count);
    }
    if ((flags & TP_WINDOW_SPACE) == 0u) {
        code |= tp_frustum_code(p, flags);
    }
    return code;
}

// Where clip position p lies on the screen: one division, then fused.
fn tp_on_screen(p: vec4<f32>, at: u32, state: u32, flags: u32) -> TpCorner {
    var position = p.xyz;
    var inv_w = 1.0;
    if ((flags & TP_WINDOW_SPACE) == 0u) {
        inv_w = tp_reciprocal(p.w);
        let scale = tp_viewport_scale(state);
        let translate = tp_viewport_translate(state);
        position.x = tp_fma(p.x * inv_w, scale.x, translate.x);
        position.y = tp_fma(p.y * inv_w, scale.y, translate.y);
        position.z = tp_fma(p.z * inv_w, scale.z, translate.z);
    }
    return TpCorner(position, inv_w, vec2<i32>(tp_snap(position.x), tp_snap(position.y)), at);
}
