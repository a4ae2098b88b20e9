// A workgroup for each bin that is not empty, a lane for each of its tiles: which of its tiles have any triangle? They are the fine stage's work; their order does
// not matter, since no two tiles share a pixel.

@group(1) @binding(0) var<storage, read_write> tp_indirect: array<atomic<u32>>;

// Room for `count` tiles among the fine stage's work.
fn tp_claim(count: u32) -> u32 {
    let at = atomicAdd(&tp_lists[2], count);
    let fine_group = (at + count - 1u) / TP_TEAMS;
    atomicMax(&tp_indirect[TP_FINE_DISPATCH], min(fine_group + 1u, 32768u));
    atomicMax(&tp_indirect[TP_FINE_DISPATCH + 1u], fine_group / 32768u + 1u);
    return at;
}

// A word of the lists that all lanes want.
fn tp_list(at: u32, tile: u32) -> u32 {
//#if SUBGROUP8
    var word = 0u;
    if ((tile & 7u) == 0u) {
        word = atomicLoad(&tp_lists[at]);
    }
    return subgroupBroadcast(word, 0u);
//#else
    return atomicLoad(&tp_lists[at]);
//#endif
}

@compute @workgroup_size(64)
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) tile: u32) {
    let slot = group.x + group.y * 32768u;
    if (slot >= tp_list(1u, tile)) {
        return;
    }
    let bin = tp_list(tp.active_base + slot, tile);
    let first = tp_list(tp.bin_base + bin * 2u, tile);
    var blocks = (tp_list(tp.bin_base + bin * 2u + 1u, tile) + 31u) / 32u;
//#if ROUNDS
    // Of the first round.
    blocks = min(blocks, TP_ROUND_BLOCKS);
//#endif
    var any_triangle = 0u;
    var block = 0u;
    loop {
        any_triangle = atomicLoad(&tp_lists[tp.tile_base + (first + block) * 64u + tile]);
        continuing {
            block++;
            break if any_triangle != 0u || block >= blocks;
        }
    }
//#if SUBGROUP8
    // One claim for all lanes of a subgroup: where lanes take turns, so do their atomics.
    let found = subgroupBallot(any_triangle != 0u).x;
    var claimed = 0u;
    if ((tile & 7u) == 0u && found != 0u) {
        claimed = tp_claim(countOneBits(found));
    }
    let at = subgroupBroadcast(claimed, 0u) + countOneBits(found & ((1u << (tile & 7u)) - 1u));
    if (any_triangle != 0u) {
        atomicStore(&tp_lists[tp.work_base + at], bin * 64u + tile);
    }
//#else
    if (any_triangle != 0u) {
        let at = tp_claim(1u);
        atomicStore(&tp_lists[tp.work_base + at], bin * 64u + tile);
    }
//#endif
}
