// A lane a vertex, a workgroup (or a few rounds of one) a block of TP_VERTEX_BLOCK vertices of one draw: fetches the attributes
// that the spliced program reads, runs it and writes its outputs.

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
    let stride = tp_front_records[record + TP_DRAW_SHADED_STRIDE];
    var index = first + lane;
    loop {
        if (index < count) {
            let vertex = tp_front_records[record + TP_DRAW_VERTEX_WORD] + index * tp_front_records[record + TP_DRAW_VERTEX_STRIDE];
            // Those that another part of the batch wants lie outside; in front of the first the difference wraps around.
            let at = tp_front_records[record + TP_DRAW_SHADED_BASE] + index * stride - tf.shaded_base;
            if (at < tf.shaded_count) {
                var in: VertexIn;
                //#insert FETCH
                let out = vertex_main(in, base);
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
