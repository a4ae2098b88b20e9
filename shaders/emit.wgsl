// Writes the triangles of the masks, in order, to the bins' lists, and leaves the masks zero for the next segment. A lane for each bin and
// super block (RUNS), or one for each of its 32 blocks.

//#if RUNS
@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = id.x + id.y * groups.x * TP_LANES;
    let supers = tp_supers();
    let blocks = tp_blocks();
    if (index >= tp.bins.x * tp.bins.y * supers) {
        return;
    }
    let first_triangle = tp_first_triangle();
    let fits = tp_lists[0] <= tp.list_blocks;
    let bin = index / supers;
    let super_block = index - bin * supers;
    let first = super_block * 32u;
    let end = min(first + 32u, blocks);
    let base = tp.mask_base + bin * blocks;
    var at = tp.list_base + tp_lists[tp.bin_base + bin * 2u] * 32u + tp_lists[tp.count_base + super_block * tp.bins.x * tp.bins.y + bin];
    var block = first;
    var bits = tp_lists[base + block];
    loop {
        if (bits != 0u) {
            if (fits) {
                tp_lists[at] = first_triangle + block * 32u + countTrailingZeros(bits);
            }
            at++;
            bits &= bits - 1u;
            if (bits == 0u) {
                tp_lists[base + block] = 0u;
            }
        }
        // To the next block that has any.
        loop {
            if (bits != 0u || block >= end) {
                break;
            }
            block++;
            if (block < end) {
                bits = tp_lists[base + block];
            }
        }
        continuing {
            break if bits == 0u;
        }
    }
}
//#else
var<workgroup> tp_counts: array<u32, TP_LANES>;

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let number = id.x + id.y * groups.x * TP_LANES;
    let index = number / 32u;
    let supers = tp_supers();
    let blocks = tp_blocks();
    let bin = index / max(supers, 1u);
    let super_block = index - bin * supers;
    let block = super_block * 32u + (number & 31u);
    let there = index < tp.bins.x * tp.bins.y * supers && block < blocks;
    let mask_at = tp.mask_base + bin * blocks + block;
    var bits = 0u;
    if (there) {
        bits = tp_lists[mask_at];
    }
    tp_counts[lane] = countOneBits(bits);
    workgroupBarrier();
    if (bits == 0u) {
        return;
    }
    tp_lists[mask_at] = 0u;
    if (tp_lists[0] > tp.list_blocks) {
        return;
    }
    var at = tp.list_base + tp_lists[tp.bin_base + bin * 2u] * 32u + tp_lists[tp.count_base + super_block * tp.bins.x * tp.bins.y + bin];
    for (var l = lane & ~31u; l < lane; l++) {
        at += tp_counts[l];
    }
    let first = tp_first_triangle() + block * 32u;
    loop {
        tp_lists[at] = first + countTrailingZeros(bits);
        at++;
        bits &= bits - 1u;
        if (bits == 0u) {
            break;
        }
    }
}
//#endif
