// Shaded vertices, as their draws lay them out: clip position, then what the program wrote. Behind them the pool: vertices that clipping makes.
//
// Where no two triangles share a vertex (SOUP), none is kept: whoever wants one shades it. Places stay the same, but only the pool is there.

//#if SOUP
// vec4 `at` of a draw's vertices or of the pool.
fn tp_read(record: u32, at: u32) -> vec4<f32> {
    if (at >= tf.shaded_count) {
        return tp_shaded[at - tf.shaded_count];
    }
    let place = at - tp_front_records[record + TP_DRAW_SHADED_BASE];
    let vertex = place / TP_SHADED_STRIDE;
    let out = tp_shade(record, vertex);
    var value = out.position;
    switch (place - vertex * TP_SHADED_STRIDE) {
        //#insert OUTPUTS
        default: {}
    }
    return value;
}

fn tp_position(record: u32, vertex: u32, at: u32) -> vec4<f32> {
    return tp_shade(record, vertex).position;
}

fn tp_write_pool(at: u32, v: vec4<f32>) {
    tp_shaded[at - tf.shaded_count] = v;
}
//#else
// vec4 `at` of a draw's vertices or of the pool.
fn tp_read(record: u32, at: u32) -> vec4<f32> {
    return tp_shaded[at];
}

// The clip position of vertex `vertex`, whose first vec4 is `at`.
fn tp_position(record: u32, vertex: u32, at: u32) -> vec4<f32> {
    return tp_shaded[at];
}

fn tp_write_pool(at: u32, v: vec4<f32>) {
    tp_shaded[at] = v;
}
//#endif
