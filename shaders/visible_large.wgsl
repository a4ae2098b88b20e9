// 32 lanes a queued block of 64 x 64 pixels of a large triangle, in as many rounds as it takes: patches of 8 x 4 samples.

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>, @builtin(local_invocation_index) index_in_group: u32) {
//#if SET_UP
    let count = tf.item_capacity;
//#else
    let count = min(atomicLoad(&tp_queue[TP_BLOCKS]), tf.item_capacity);
//#endif
    let lane = vec2<i32>(i32(index_in_group & 7u), i32((index_in_group >> 3u) & 3u));
    for (var item = group.x * (TP_LANES / 32u) + index_in_group / 32u; item < count; item += groups.x * (TP_LANES / 32u)) {
        let at = tf.item_base + item * 3u;
        let index = atomicLoad(&tp_queue[at]);
        let triangle = atomicLoad(&tp_queue[at + 1u]);
        let block = atomicLoad(&tp_queue[at + 2u]);
        var walk: TpWalk;
//#if SET_UP
        tp_walk_triangle(index, &walk);
//#else
        let p = tp_primitive(index);
        var corners = vec3<u32>(0u, 1u, 2u);
        if (triangle > 0u) {
            let fan = tf.fan_base + (atomicLoad(&tp_queue[tf.map_base + index - tf.first_primitive]) + triangle - 1u) * 3u;
            corners = vec3<u32>(atomicLoad(&tp_queue[fan]), atomicLoad(&tp_queue[fan + 1u]), atomicLoad(&tp_queue[fan + 2u]));
        }
        if (!tp_walk(p, index, triangle, tp_corner_at(p, corners.x), tp_corner_at(p, corners.y), tp_corner_at(p, corners.z), &walk)) {
            continue;
        }
//#endif
        let low = walk.low + 64 * vec2<i32>(vec2<u32>(block & 0xffffu, block >> 16u));
        let high = min(walk.high, low + 63);
        let dx = walk.x - walk.x.yzx;
        let dy = walk.y - walk.y.yzx;
        var row = tp_wide_edges(dx, dy, walk.x - low.x * 256, walk.y - low.y * 256) - dy * lane.x + dx * lane.y;
        for (var py = low.y + lane.y; py <= high.y; py += 4) {
            var e = row;
            for (var px = low.x + lane.x; px <= high.x; px += 8) {
                if ((e.x | e.y | e.z) >= 0) {
                    tp_offer(&walk, px, py, tp_fma(f32(px), walk.z.y, walk.z.x));
                }
                e -= dy * 8;
            }
            row += dx * 4;
        }
    }
}
