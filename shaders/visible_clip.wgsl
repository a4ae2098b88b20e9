// A lane a queued primitive, in as many rounds as it takes: cuts it, keeps the fan that is left, and queues its triangles as large ones:
// one lane after the other has enough to do.

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let count = min(atomicLoad(&tp_queue[TP_TO_CLIP]), tf.queue_capacity);
    for (var entry = id.x; entry < count; entry += groups.x * TP_LANES) {
        let index = atomicLoad(&tp_queue[tf.queue_base + entry]);
        let p = tp_coded_primitive(index);
        // Each plane makes at most two vertices.
        let wanted = 2u * countOneBits(p.code_or) * (p.shaded_stride + 1u);
        let pool = atomicAdd(&tp_queue[TP_POOLED], wanted);
        if (pool + wanted > tf.pool_capacity) {
            continue;
        }
        tp_pool = tf.pool_base + pool;
        tp_pooled = 0u;
        let polygon = tp_clip_polygon(p);
        if (polygon.count < 3u) {
            continue;
        }
        let triangles = polygon.count - 2u;
        let fan = atomicAdd(&tp_queue[TP_FANS], triangles);
        if (fan + triangles > tf.fan_capacity) {
            continue;
        }
        atomicStore(&tp_queue[tf.map_base + index - tf.first_primitive], fan);
        // A fan around the first corner, which comes last.
        let centre = tp_reference(p, polygon.corners[0]);
        for (var i = 0u; i < triangles; i++) {
            let a = tp_reference(p, polygon.corners[i + 1u]);
            let b = tp_reference(p, polygon.corners[i + 2u]);
            let at = tf.fan_base + (fan + i) * 3u;
            atomicStore(&tp_queue[at], a);
            atomicStore(&tp_queue[at + 1u], b);
            atomicStore(&tp_queue[at + 2u], centre);
            var walk: TpWalk;
            if (tp_walk(p, index, i + 1u, tp_corner_at(p, a), tp_corner_at(p, b), tp_corner_at(p, centre), &walk)) {
                let blocks = tp_blocks(&walk);
                tp_queue_blocks(atomicAdd(&tp_queue[TP_BLOCKS], blocks.x * blocks.y), blocks, index, i + 1u);
            }
        }
    }
}

fn tp_reference(p: TpPrimitive, corner: u32) -> u32 {
    return select(tp_vertex_at(p, corner) + 3u, corner, corner < 3u);
}
