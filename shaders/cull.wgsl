// How many triangles does each primitive make? Back faces, faces without area, and those between the samples make none. A
// workgroup a group of primitives, a lane each; where workgroups are one SIMD register wide (RUNS), a lane a run of TP_RUN of them, and
// a sum a lane.

//#if RUNS
//#else
var<workgroup> tp_sums: array<vec4<u32>, TP_LANES>;
//#endif

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(workgroup_id) workgroup: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let group = workgroup.x + workgroup.y * 32768u;
    if (group >= tf.groups) {
        return;
    }
    let first = tp_front_records[tf.group_base + group * 2u];
    let count = tp_front_records[tf.group_base + group * 2u + 1u];
    var sum = vec4<u32>(0u);
//#if RUNS
    var k = lane * TP_RUN;
    loop {
        if (k < count) {
            sum += tp_count(tp_coded_primitive(first + k));
        }
        continuing {
            k++;
            break if k >= min(lane * TP_RUN + TP_RUN, count);
        }
    }
    let at = tf.sums_base + (group * TP_LANES + lane) * 4u;
//#else
    if (lane < count) {
        sum = tp_count(tp_coded_primitive(first + lane));
    }
    tp_sums[lane] = sum;
    for (var half = TP_LANES / 2u; half > 0u; half /= 2u) {
        workgroupBarrier();
        if (lane < half) {
            sum += tp_sums[lane + half];
            tp_sums[lane] = sum;
        }
    }
    if (lane > 0u) {
        return;
    }
    let at = tf.sums_base + group * 4u;
//#endif
    tp_front[at] = sum.x;
    tp_front[at + 1u] = sum.y;
    tp_front[at + 2u] = sum.z;
    tp_front[at + 3u] = sum.w;
}
