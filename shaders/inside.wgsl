// The set-up kernel: primitives inside the view volume become triangles at the places that cull counted; those that leave it are
// queued for the clip kernel, so that its registers are not paid for by all others. A lane a primitive, or a run of them, as in cull.wgsl.

//#if RUNS
//#else
var<workgroup> tp_sums: array<vec4<u32>, TP_LANES>;
//#endif

fn tp_queue(entry: u32, index: u32, pool: u32) {
    let at = tf.queue_base + 4u + entry * 4u;
    tp_front[at] = index;
    tp_front[at + 1u] = tp_next_triangle;
    tp_front[at + 2u] = tp_next_planes;
    tp_front[at + 3u] = pool;
}

// Sets up primitive `index` at a place.
fn tp_set_up(p: TpPrimitive, index: u32, count: vec4<u32>, place: vec4<u32>) {
    if (count.x == 0u) {
        return;
    }
    tp_next_triangle = place.x;
    tp_next_planes = place.y;
    if (p.code_or != 0u) {
        tp_queue(place.w, index, tf.pool_base + place.z);
        return;
    }
    let end = place.x + count.x;
    let a = tp_corner(p, 0u);
    let b = tp_corner(p, 1u);
    let c = tp_corner(p, 2u);
    // The last vertex provokes.
    tp_provoking = p.shaded.z;
//#if POINTS_AND_LINES
    if (p.topology == TP_POINTS) {
        tp_point(p, index, a, true);
    } else if (p.topology == TP_LINES) {
        tp_line(p, index, a, b, true);
    } else {
        tp_polygon(p, index, a, b, c, p.edges);
    }
    loop {
        if (tp_next_triangle >= end) {
            break;
        }
        tp_write_nothing();
    }
//#else
    tp_polygon(p, index, a, b, c, p.edges);
//#endif
}

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(workgroup_id) workgroup: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let group = workgroup.x + workgroup.y * 32768u;
    if (group >= tf.groups) {
        return;
    }
    let first = tp_front_records[tf.group_base + group * 2u];
    let count = tp_front_records[tf.group_base + group * 2u + 1u];
//#if RUNS
    let at = tf.sums_base + (group * TP_LANES + lane) * 4u;
    var place = vec4<u32>(tp_front[at], tp_front[at + 1u], tp_front[at + 2u], tp_front[at + 3u]);
    var k = lane * TP_RUN;
    loop {
        if (k < count) {
            let p = tp_coded_primitive(first + k);
            let wants = tp_count(p);
            tp_set_up(p, first + k, wants, place);
            place += wants;
        }
        continuing {
            k++;
            break if k >= min(lane * TP_RUN + TP_RUN, count);
        }
    }
//#else
    var p: TpPrimitive;
    var wants = vec4<u32>(0u);
    if (lane < count) {
        p = tp_coded_primitive(first + lane);
        wants = tp_count(p);
    }
    var sum = wants;
    tp_sums[lane] = sum;
    for (var step = 1u; step < TP_LANES; step *= 2u) {
        workgroupBarrier();
        var before = vec4<u32>(0u);
        if (lane >= step) {
            before = tp_sums[lane - step];
        }
        workgroupBarrier();
        sum += before;
        tp_sums[lane] = sum;
    }
    let at = tf.sums_base + group * 4u;
    let place = vec4<u32>(tp_front[at], tp_front[at + 1u], tp_front[at + 2u], tp_front[at + 3u]) + sum - wants;
    tp_set_up(p, first + lane, wants, place);
//#endif
}
