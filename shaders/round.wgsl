// One workgroup: what the fine stage goes through next, TP_ROUND_BLOCKS blocks further on in the bins' lists. The tiles of bins whose lists reach so
// far are its work; whether they have a triangle there it sees itself.

@group(1) @binding(0) var<storage, read_write> tp_indirect: array<u32>;

var<workgroup> tp_tiles: atomic<u32>;

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(local_invocation_index) lane: u32) {
    if (lane == 0u) {
        atomicStore(&tp_tiles, 0u);
    }
    workgroupBarrier();
    let start = tp_lists[3] + TP_ROUND_BLOCKS;
    let bins = select(0u, tp_lists[1], start < tp_lists[4]);
    var slot = lane;
    loop {
        if (slot >= bins) {
            break;
        }
        let bin = tp_lists[tp.active_base + slot];
        if (tp_lists[tp.bin_base + bin * 2u + 1u] > start * 32u) {
            let at = tp.work_base + atomicAdd(&tp_tiles, 64u);
            for (var tile = 0u; tile < 64u; tile++) {
                tp_lists[at + tile] = bin * 64u + tile;
            }
        }
        slot += TP_LANES;
    }
    workgroupBarrier();
    if (lane == 0u) {
        let tiles = atomicLoad(&tp_tiles);
        tp_lists[2] = tiles;
        tp_lists[3] = start;
        let groups = (tiles + TP_TEAMS - 1u) / TP_TEAMS;
        tp_indirect[TP_FINE_DISPATCH] = min(groups, 32768u);
        tp_indirect[TP_FINE_DISPATCH + 1u] = (groups + 32767u) / 32768u;
    }
}
