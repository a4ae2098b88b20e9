// A lane for each bin and each super block: writes the triangles of the masks, in order, to the bin's list, and leaves
// the masks zero for the next segment.

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
    var at = tp.list_base + tp_lists[tp.bin_base + bin * 2u] * 32u + tp_lists[tp.count_base + index];
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
