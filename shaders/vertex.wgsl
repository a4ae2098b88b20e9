// A lane a vertex, a workgroup (or a few rounds of one) a block of TP_VERTEX_BLOCK vertices of one draw: fetches the attributes
// that the spliced program reads, runs it, writes its outputs, and puts the vertex on the screen with its clip code.

fn tp_attribute(record: u32, slot: u32, vertex: u32) -> vec4<f32> {
    let offset = tp_front_records[record + TP_DRAW_ATTRIBUTE_OFFSET + slot];
    if (offset == TP_NONE) {
        return uniforms[tp_front_records[record + TP_DRAW_CONSTANTS] + slot];
    }
    let size = tp_front_records[record + TP_DRAW_ATTRIBUTE_SIZE + slot];
    let at = vertex + offset;
    // Words that are not there are read as the first one and not used.
    let y = tp_vertices[select(at, at + 1u, size > 1u)];
    let z = tp_vertices[select(at, at + 2u, size > 2u)];
    let w = tp_vertices[select(at, at + 3u, size > 3u)];
    return vec4<f32>(tp_vertices[at], select(0.0, y, size > 1u), select(0.0, z, size > 2u), select(1.0, w, size > 3u));
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

// Where a clip position lies on the screen: one division, then fused.
fn tp_to_screen(vertex: u32, p: vec4<f32>, state: u32, user: u32) {
    let flags = tp_front_records[state + TP_STATE_FLAGS];
    var position = p.xyz;
    var inv_w = 1.0;
    var code = user;
    if ((flags & TP_WINDOW_SPACE) == 0u) {
        inv_w = tp_reciprocal(p.w);
        let scale = tp_viewport_scale(state);
        let translate = tp_viewport_translate(state);
        position.x = tp_fma(p.x * inv_w, scale.x, translate.x);
        position.y = tp_fma(p.y * inv_w, scale.y, translate.y);
        position.z = tp_fma(p.z * inv_w, scale.z, translate.z);
        code |= tp_frustum_code(p, flags);
    }
    tp_screen[vertex * 2u] = bitcast<vec4<u32>>(vec4<f32>(position, inv_w));
    tp_screen[vertex * 2u + 1u] = vec4<u32>(bitcast<vec2<u32>>(vec2<i32>(tp_snap(position.x), tp_snap(position.y))), code, 0u);
}

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let block = group.x + group.y * 32768u;
    if (block >= tf.vertex_blocks) {
        return;
    }
    let draw = tp_front_records[tf.block_base + block * 2u];
    let first = tp_front_records[tf.block_base + block * 2u + 1u];
    let record = draw * TP_DRAW_RECORD_WORDS;
    let count = tp_front_records[record + TP_DRAW_VERTEX_COUNT];
    let base = tp_front_records[record + TP_DRAW_VERTEX_UNIFORMS];
    let state = tf.state_base + tp_front_records[record + TP_DRAW_RASTER_STATE] * TP_STATE_WORDS;
    let stride = tp_front_records[record + TP_DRAW_SHADED_STRIDE];
    var index = first + lane;
    loop {
        if (index < count) {
            let vertex = tp_front_records[record + TP_DRAW_VERTEX_WORD] + index * tp_front_records[record + TP_DRAW_VERTEX_STRIDE];
            let at = tp_front_records[record + TP_DRAW_SHADED_BASE] + index * stride;
            var in: VertexIn;
            //#insert FETCH
            let out = vertex_main(in, base);
            tp_shaded[at] = out.position;
            var user = 0u;
            //#insert STORE
            tp_to_screen(tp_front_records[record + TP_DRAW_SCREEN_BASE] + index, out.position, state, user);
        }
        continuing {
            index += TP_LANES;
            break if index >= first + TP_VERTEX_BLOCK;
        }
    }
}
