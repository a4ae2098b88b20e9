// One workgroup: sums of counts become places, each segment learns where its triangles lie, and later dispatches their sizes. What does
// not fit its buffer stops the batch (TP_FAILED): nothing is drawn from there on, and the host draws the rest with more room or in
// smaller pieces.

@group(1) @binding(0) var<storage, read_write> tp_indirect: array<u32>;

var<workgroup> tp_totals: array<vec4<u32>, TP_LANES>;
var<workgroup> tp_total: vec4<u32>;
var<workgroup> tp_most_blocks: atomic<u32>;
var<workgroup> tp_stopped: u32;

// First triangle of a segment, and one past its last.
fn tp_range(s: u32) -> vec2<u32> {
    let groups = vec2<u32>(tp_front_records[tf.segment_base + s * 3u], tp_front_records[tf.segment_base + s * 3u + 1u]);
    return vec2<u32>(tp_front[tf.sums_base + groups.x * TP_SUMS * 4u], tp_front[tf.sums_base + groups.y * TP_SUMS * 4u]);
}

fn tp_sum(at: u32) -> vec4<u32> {
    return vec4<u32>(tp_front[at], tp_front[at + 1u], tp_front[at + 2u], tp_front[at + 3u]);
}

// Workgroups for `count` lanes of a list stage, as the three words of an indirect dispatch.
fn tp_dispatch(at: u32, count: u32) {
    let groups = (count + tf.list_lanes - 1u) / tf.list_lanes;
    tp_indirect[at] = min(groups, 32768u);
    tp_indirect[at + 1u] = (groups + 32767u) / 32768u;
    tp_indirect[at + 2u] = 1u;
}

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(local_invocation_index) lane: u32) {
    let sums = tf.groups * TP_SUMS;
    let share = (sums + TP_LANES - 1u) / TP_LANES;
    let first = min(lane * share, sums);
    let end = min(first + share, sums);
    var total = vec4<u32>(0u);
    for (var k = first; k < end; k++) {
        let at = tf.sums_base + k * 4u;
        let sum = tp_sum(at);
        tp_front[at] = total.x;
        tp_front[at + 1u] = total.y;
        tp_front[at + 2u] = total.z;
        tp_front[at + 3u] = total.w;
        total += sum;
    }
    tp_totals[lane] = total;
    if (lane == 0u) {
        atomicStore(&tp_most_blocks, 0u);
    }
    workgroupBarrier();
    var before = vec4<u32>(0u);
    for (var l = 0u; l < lane; l++) {
        before += tp_totals[l];
    }
    for (var k = first; k < end; k++) {
        let at = tf.sums_base + k * 4u;
        tp_front[at] += before.x;
        tp_front[at + 1u] += before.y;
        tp_front[at + 2u] += before.z;
        tp_front[at + 3u] += before.w;
    }
    if (lane == TP_LANES - 1u) {
        // One more at the end, for the last segment.
        tp_front[tf.sums_base + sums * 4u] = before.x + total.x;
        tp_total = before + total;
    }
    storageBarrier();
    workgroupBarrier();
    for (var s = lane; s < tf.segments; s += TP_LANES) {
        let range = tp_range(s);
        let blocks = (range.y - range.x + 31u) / 32u;
        if (blocks > tp_front_records[tf.segment_base + s * 3u + 2u]) {
            atomicMax(&tp_most_blocks, blocks);
        }
    }
    workgroupBarrier();
    if (lane == 0u) {
        let all = tp_total;
        let most = atomicLoad(&tp_most_blocks);
        let fits = all.x <= tf.triangle_capacity && all.y <= tf.plane_capacity && all.z <= tf.pool_capacity && all.w <= tf.queue_capacity;
        if (tp_indirect[TP_FAILED] == 0u && !(fits && most == 0u)) {
            tp_indirect[TP_FAILED] = tf.action + 1u;
            tp_indirect[TP_FAILED + 1u] = all.x;
            tp_indirect[TP_FAILED + 2u] = all.y;
            tp_indirect[TP_FAILED + 3u] = all.z;
            tp_indirect[TP_FAILED + 4u] = all.w;
            tp_indirect[TP_FAILED + 5u] = most;
        }
        tp_stopped = tp_indirect[TP_FAILED];
        let groups = select(tf.groups, 0u, tp_stopped != 0u);
        tp_indirect[TP_SETUP_DISPATCH] = min(groups, 32768u);
        tp_indirect[TP_SETUP_DISPATCH + 1u] = (groups + 32767u) / 32768u;
        tp_indirect[TP_SETUP_DISPATCH + 2u] = 1u;
        let queued = select(all.w, 0u, tp_stopped != 0u);
        tp_dispatch(TP_CLIP_DISPATCH, queued);
        tp_front[tf.queue_base] = queued;
    }
    workgroupBarrier();
    let stopped = tp_stopped != 0u;
    for (var s = lane; s < tf.segments; s += TP_LANES) {
        let at = (tf.first_segment + s) * TP_SEGMENT_WORDS;
        let range = tp_range(s);
        let count = select(range.y - range.x, 0u, stopped);
        let blocks = (count + 31u) / 32u;
        let supers = (blocks + 31u) / 32u;
        tp_front[at] = range.x;
        tp_front[at + 1u] = count;
        tp_front[at + 2u] = blocks;
        tp_front[at + 3u] = supers;
        let dispatch = TP_SEGMENT_DISPATCH + (tf.first_segment + s) * 8u;
        tp_dispatch(dispatch, count * select(1u, tf.bin_rows, count < TP_FEW_TRIANGLES));
        tp_dispatch(dispatch + 4u, tf.bins * supers);
    }
}
