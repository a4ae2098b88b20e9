// A workgroup for each bin that is not empty: which of its tiles have any triangle? They are the fine stage's work; their order does
// not matter, since no two tiles share a pixel.

@group(1) @binding(0) var<storage, read_write> tp_indirect: array<atomic<u32>>;

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let slot = group.x + group.y * 32768u;
    if (slot >= atomicLoad(&tp_lists[1])) {
        return;
    }
    let bin = atomicLoad(&tp_lists[tp.active_base + slot]);
    let first = atomicLoad(&tp_lists[tp.bin_base + bin * 2u]);
    var blocks = (atomicLoad(&tp_lists[tp.bin_base + bin * 2u + 1u]) + 31u) / 32u;
//#if ROUNDS
    // Of the first round.
    blocks = min(blocks, TP_ROUND_BLOCKS);
//#endif
    var tile = lane;
    loop {
        var any_triangle = 0u;
        var block = 0u;
        loop {
            any_triangle = atomicLoad(&tp_lists[tp.tile_base + (first + block) * 64u + tile]);
            continuing {
                block++;
                break if any_triangle != 0u || block >= blocks;
            }
        }
        if (any_triangle != 0u) {
            let at = atomicAdd(&tp_lists[2], 1u);
            atomicStore(&tp_lists[tp.work_base + at], bin * 64u + tile);
            atomicMax(&tp_indirect[TP_FINE_DISPATCH], min(at + 1u, 32768u));
            atomicMax(&tp_indirect[TP_FINE_DISPATCH + 1u], at / 32768u + 1u);
        }
        continuing {
            tile += TP_LANES;
            break if tile >= 64u;
        }
    }
}
