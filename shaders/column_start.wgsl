// A subgroup's tile, and the first triangle of its list.
let lane = index_in_group & 7u;
let slot = (group.x + group.y * 32768u) * TP_TEAMS + index_in_group / 8u;
// Tiles to draw, and the first block of the round.
let work_and_start = tp_list_pair(2u, lane);
if (slot >= work_and_start.x) {
    return;
}
// Of the parameters once: each look costs.
let size = tp.size;
let bins_x = tp.bins.x;
let entry_base = tp.entry_base;
let draws = tp.draws;
var fresh = tp.fresh;
let work = tp_list(tp.work_base + slot, lane);
let bin = work >> 6u;
let tile = work & 63u;
// A division of integers would take turns. There are at most 2^16 bins, so that this quotient is exact.
let bin_y = u32((f32(bin) + 0.5) / f32(bins_x));
let origin = vec2<u32>((bin - bin_y * bins_x) * 64u + (tile & 7u) * 8u, bin_y * 64u + (tile >> 3u) * 8u);
let list = tp_list_pair(tp.bin_base + bin * 2u, lane);
let first_block = list.x;
var blocks = (list.y + 31u) / 32u;
var start = 0u;
//#if ROUNDS
// A part of the list: the driver ends a workgroup's loops, all together, after some ten thousand iterations.
start = work_and_start.y;
blocks = min(blocks, start + TP_ROUND_BLOCKS);
fresh = select(0u, fresh, start == 0u);
//#endif
let masks = tp.tile_base + first_block * 64u + tile;
// The first triangle.
var block = start;
var bits = 0u;
loop {
    bits = tp_list(masks + block * 64u, lane);
    continuing {
        block++;
        break if bits != 0u || block >= blocks;
    }
}
if (bits == 0u) {
    return;
}

let column = lane;
let px = origin.x + column;
let column_x = f32(i32(px));
let local_x = i32((tile & 7u) * 8u + column);
let local_top = i32((tile >> 3u) * 8u);
var entry = first_block * 32u + (block - 1u) * 32u + countTrailingZeros(bits);
var more = true;
