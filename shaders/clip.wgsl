// The clip kernel: a lane a queued primitive: what is left of it is set up at the places that cull counted.

//#if POINTS_AND_LINES
fn tp_clip_line(p: TpPrimitive, index: u32) {
    var t = vec2<f32>(0.0);
    var valid = true;
    for (var planes = p.code_or; planes != 0u; planes &= planes - 1u) {
        let plane = firstTrailingBit(planes);
        let d0 = tp_distance(p, 0u, plane);
        let d1 = tp_distance(p, 1u, plane);
        valid = valid && tp_finite(d0) && tp_finite(d1);
        if (d1 < 0.0) {
            t.y = max(t.y, tp_divide(d1, d1 - d0));
        }
        if (d0 < 0.0) {
            t.x = max(t.x, tp_divide(d0, d0 - d1));
        }
        valid = valid && t.x + t.y < 1.0;
    }
    if (!valid) {
        return;
    }
    var a = 0u;
    var b = 1u;
    if (tp_code(p, 0u) != 0u) {
        a = tp_interpolate(p, 0u, 1u, t.x);
    }
    if (tp_code(p, 1u) != 0u) {
        b = tp_interpolate(p, 1u, 0u, t.y);
    }
    tp_line(p, index, tp_clip_corner(p, a), tp_clip_corner(p, b), true);
}
//#endif

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let entry = id.x + id.y * groups.x * TP_LANES;
    if (entry >= tp_front[tf.queue_base]) {
        return;
    }
    let at = tf.queue_base + 4u + entry * 4u;
    let index = tp_front[at];
    let p = tp_coded_primitive(index);
    tp_next_triangle = tp_front[at + 1u];
    tp_next_planes = tp_front[at + 2u];
    tp_pool = tp_front[at + 3u];
    tp_pooled = 0u;
    tp_provoking = p.shaded.z;
    let end = tp_next_triangle + tp_count(p).x;
    var filled = true;
//#if POINTS_AND_LINES
    if (p.topology == TP_LINES) {
        tp_clip_line(p, index);
        filled = false;
    }
//#endif
    if (filled) {
        let polygon = tp_clip_polygon(p);
        // A fan around the first corner, which comes last.
        let n = polygon.count;
        let centre = tp_clip_corner(p, polygon.corners[0]);
        for (var i = 2u; i < n; i++) {
            let last = i == n - 1u;
            var edges = (polygon.edges >> (i - 1u)) & 1u;
            edges |= select(0u, ((polygon.edges >> i) & 1u) << 1u, last);
            edges |= select(0u, (polygon.edges & 1u) << 2u, i == 2u);
            let a = tp_clip_corner(p, polygon.corners[i - 1u]);
            let b = tp_clip_corner(p, polygon.corners[i]);
            tp_polygon(p, index, a, b, centre, edges);
        }
    }
    loop {
        if (tp_next_triangle >= end) {
            break;
        }
        tp_write_nothing();
    }
}
