// The spliced vertex program: fetches the attributes that it reads and runs it.

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

// Vertex `index` of the draw with this record.
fn tp_shade(record: u32, index: u32) -> VertexOut {
    let vertex = tp_front_records[record + TP_DRAW_VERTEX_WORD] + index * tp_front_records[record + TP_DRAW_VERTEX_STRIDE];
    var in: VertexIn;
    //#insert FETCH
    return vertex_main(in, tp_front_records[record + TP_DRAW_VERTEX_UNIFORMS]);
}
