// A lane a pixel, 8 x 8 of them side by side: the fragment whose key won is tested against what was there, shaded and written. Leaves the
// keys as the next segment wants them. Where the batch was stopped nothing is written.

@group(1) @binding(0) var<storage, read_write> tp_indirect: array<u32>;

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
//#if SET_UP
    // Of those that any triangle touches.
    let number = (group.x + group.y * 32768u) * (TP_LANES / 64u) + lane / 64u;
    let tile = tp_queue[tf.tile_base + min(number, tf.tile_count - 1u)];
//#else
    let tile = (group.x + group.y * 32768u) * (TP_LANES / 64u) + lane / 64u;
//#endif
//#if ONE_DRAW
    // As long as all lanes are there: each loads a word of the draw's states, for its subgroup.
    let column = lane & 7u;
    let draw = tp.draws;
    const tp_fresh = true;
    var tp_kept: array<u32, 32>;
    //#include resolve_state
//#endif
    let columns = (tp.size.x + 7u) / 8u;
    let px = (tile % columns) * 8u + (lane & 7u);
    let row = u32(tf.first_row) + (tile / columns) * 8u + ((lane >> 3u) & 7u);
//#if SET_UP
    let beyond = number >= tf.tile_count;
//#else
    const beyond = false;
//#endif
    if (beyond || px >= tp.size.x || row >= u32(tf.end_row)) {
        return;
    }
    let py = i32(row);
    let at = row * tp.size.x + px;
    let key_at = at - u32(tf.first_row) * tp.size.x;
//#if SET_UP
    let both = tp_keys[key_at];
    let key = vec2<u32>(u32(both & 0xfffffffflu), u32(both >> 32u));
//#else
    let key = tp_keys[key_at];
//#endif
    let offered = (key.x & key.y) != 0xffffffffu;
//#if SET_UP
    // Only tiles that triangles touch are here: no clear is left to the segment.
    const clears = false;
//#else
    // The clear before the segment may be the segment's to do.
    let clears = (tp.fresh & TP_FRESH_CLEARS) != 0u;
//#endif
    if (!offered && !clears) {
        return;
    }
    if (offered) {
//#if SET_UP
        tp_keys[key_at] = ~0lu;
//#else
        tp_keys[key_at] = vec2<u32>(0xffffffffu);
//#endif
    }
    let old_depth = tp_first_depth(at, tp.fresh);
    let depth = key.y >> 8u;
//#if LEQUAL
    let order = ~key;
    let passes = depth <= (old_depth & 0xffffffu);
//#else
    let order = key;
    let passes = depth < (old_depth & 0xffffffu);
//#endif
//#if SET_UP
    // What the host has set up always fits.
//#else
    if (tp_indirect[TP_FAILED] != 0u) {
        return;
    }
//#endif
    if (!offered || !passes) {
        if (clears && (tp.fresh & TP_FRESH_COLOR) != 0u) {
            tp_store_pixel(at, tp_pixel_of(tp.clear_color));
        }
        if (clears && (tp.fresh & TP_FRESH_DEPTH) != 0u) {
            tp_depth[at] = tp.clear_depth;
        }
        return;
    }
    tp_depth[at] = (old_depth & 0xff000000u) | depth;
    let index = ((order.y & 0xffu) << 24u) | (order.x >> 8u);
//#if SET_UP
    let base = index * TP_TRIANGLE_WORDS;
    let flags = tp_triangle_words(base, TP_TRIANGLE_DRAW / 2u).y;
//#if ONE_DRAW
//#else
    let draw = tp.draws + tp_triangle_words(base, TP_TRIANGLE_DRAW / 2u).x * TP_DRAW_WORDS;
//#endif
    let planes = tp_triangle_words(base, TP_TRIANGLE_PLANES / 2u).x * 4u;
//#else
    let triangle = order.x & 0xffu;
    let p = tp_primitive(index);
    var corners = vec3<u32>(0u, 1u, 2u);
    if (triangle > 0u) {
        let fan = tf.fan_base + (tp_queue[tf.map_base + index - tf.first_primitive] + triangle - 1u) * 3u;
        corners = vec3<u32>(tp_queue[fan], tp_queue[fan + 1u], tp_queue[fan + 2u]);
    }
    let corner_a = tp_corner_at(p, corners.x);
    let corner_b = tp_corner_at(p, corners.y);
    let vc = tp_corner_at(p, corners.z);
    let area = tp_area_sign(
        vec3<i32>(corner_a.snapped.x, corner_b.snapped.x, vc.snapped.x), vec3<i32>(corner_a.snapped.y, corner_b.snapped.y, vc.snapped.y));
    let front = tp_is_front(area, p.flags);
    var va = corner_a;
    var vb = corner_b;
    if (area < 0) {
        va = corner_b;
        vb = corner_a;
    }
    tp_provoking = p.shaded.z;
    let flags = select(0u, TP_FRONT, front);
    let basis = tp_basis(0.5, va.position, vb.position, vc.position);
    let draw = tp.draws + p.draw * TP_DRAW_WORDS;
//#endif
    //#insert PLANES
//#if ONE_DRAW
//#else
    //#include resolve_state
//#endif
    let x = f32(i32(px));
    let y = f32(py);
    var color = vec4<f32>(0.0);
    //#insert DEPTH
    //#insert SHADE
    tp_store_pixel(at, tp_merge(state, tp_first_pixel(at, tp.fresh), color));
}
