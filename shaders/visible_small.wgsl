// A lane a primitive of the segment: inside the view volume it is drawn or queued in blocks; what has to be clipped is queued.

// Blocks that the workgroup queues, and where: one claim of the queue for all its lanes.
var<workgroup> tp_wanted: atomic<u32>;
var<workgroup> tp_place: u32;

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let k = id.x + id.y * groups.x * TP_LANES;
    let index = tf.first_primitive + k;
    var walk: TpWalk;
    var blocks = vec2<u32>(0u);
    var draws = false;
    if (k < tf.primitive_count) {
        let p = tp_coded_primitive(index);
        if (p.code_or == 0u) {
            let a = tp_corner(p, 0u);
            let b = tp_corner(p, 1u);
            let c = tp_corner(p, 2u);
            draws = tp_walk(p, index, 0u, a, b, c, &walk);
        } else if ((p.code_or & TP_CLIP_INVALID) == 0u && p.code_and == 0u) {
            let entry = atomicAdd(&tp_queue[TP_TO_CLIP], 1u);
            if (entry < tf.queue_capacity) {
                atomicStore(&tp_queue[tf.queue_base + entry], index);
            }
        }
    }
    if (draws) {
        blocks = tp_blocks_of(&walk);
    }
    if (lane == 0u) {
        atomicStore(&tp_wanted, 0u);
    }
    workgroupBarrier();
    var before = 0u;
    if (blocks.x > 0u) {
        before = atomicAdd(&tp_wanted, blocks.x * blocks.y);
    }
    workgroupBarrier();
    if (lane == 0u) {
        let wanted = atomicLoad(&tp_wanted);
        if (wanted > 0u) {
            tp_place = atomicAdd(&tp_queue[TP_BLOCKS], wanted);
        }
    }
    workgroupBarrier();
    if (blocks.x > 0u) {
        tp_queue_blocks(tp_place + before, blocks, index, 0u);
    } else if (draws) {
        tp_offer_samples(&walk);
    }
}
