// A lane a primitive of the segment: inside the view volume it is drawn or queued in blocks; what has to be clipped is queued.

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let k = id.x + id.y * groups.x * TP_LANES;
    if (k >= tf.primitive_count) {
        return;
    }
    let index = tf.first_primitive + k;
    let p = tp_primitive(index);
    if (p.code_or != 0u) {
        if ((p.code_or & TP_CLIP_INVALID) == 0u && p.code_and == 0u) {
            let entry = atomicAdd(&tp_queue[TP_TO_CLIP], 1u);
            if (entry < tf.queue_capacity) {
                atomicStore(&tp_queue[tf.queue_base + entry], index);
            }
        }
        return;
    }
    let a = tp_corner(p.screen.x, p.shaded.x);
    let b = tp_corner(p.screen.y, p.shaded.y);
    let c = tp_corner(p.screen.z, p.shaded.z);
    tp_offer_triangle(p, index, 0u, a, b, c);
}
