// A lane a triangle that the host has set up. Those of many samples or long edges are left to visible_large.wgsl: the host has queued their blocks.

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let k = id.x + id.y * groups.x * TP_LANES;
    if (k >= tf.primitive_count) {
        return;
    }
    var walk: TpWalk;
    tp_walk_triangle(tf.first_primitive + k, &walk);
    if (tp_blocks_of(&walk).x == 0u && tp_reach(&walk) < TP_NEAR) {
        tp_offer_samples(&walk);
    }
}
