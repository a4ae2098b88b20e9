// A lane a vertex, a workgroup (or a few rounds of one) a block of TP_VERTEX_BLOCK vertices of one draw: runs the spliced
// program and writes its outputs.

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
    let stride = tp_front_records[record + TP_DRAW_SHADED_STRIDE];
    var index = first + lane;
    loop {
        if (index < count) {
            // Those that another part of the batch wants lie outside; in front of the first the difference wraps around.
            let at = tp_front_records[record + TP_DRAW_SHADED_BASE] + index * stride - tf.shaded_base;
            if (at < tf.shaded_count) {
                let out = tp_shade(record, index);
                tp_shaded[at] = out.position;
                //#insert STORE
            }
        }
        continuing {
            index += TP_LANES;
            break if index >= first + TP_VERTEX_BLOCK;
        }
    }
}
