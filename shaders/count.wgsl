// A lane for each bin and each super block (1024 triangles): how many triangles of it touch the bin?

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let index = id.x + id.y * groups.x * TP_LANES;
    let supers = tp_supers();
    let blocks = tp_blocks();
    if (index >= tp.bins.x * tp.bins.y * supers) {
        return;
    }
    let bin = index / supers;
    let super_block = index - bin * supers;
    let first = super_block * 32u;
    let end = min(first + 32u, blocks);
    let base = tp.mask_base + bin * blocks;
    var count = 0u;
    var block = first;
    loop {
        count += countOneBits(tp_lists[base + block]);
        continuing {
            block++;
            break if block >= end;
        }
    }
    tp_lists[tp.count_base + super_block * tp.bins.x * tp.bins.y + bin] = count;
}
