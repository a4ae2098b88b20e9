// One workgroup: where each bin's list starts (in blocks of 32 entries), which bins are not empty, and how many
// workgroups the tile and fine stages get. Counts of a bin's super blocks become offsets within its list.

@group(1) @binding(0) var<storage, read_write> tp_indirect: array<u32>;

var<workgroup> tp_sums: array<vec2<u32>, TP_LANES>;
//#if ROUNDS
var<workgroup> tp_longest: array<u32, TP_LANES>;
//#endif

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(local_invocation_index) lane: u32) {
    let bins = tp.bins.x * tp.bins.y;
    let supers = tp_supers();
    // Counts lie super block by super block, so that neighbouring lanes read neighbouring words.
    for (var bin = lane; bin < bins; bin += TP_LANES) {
        var total = 0u;
        // Eight at a time, so that their loads overlap.
        for (var s = 0u; s < supers; s += 8u) {
            var counts = array<u32, 8>();
            for (var k = 0u; k < 8u; k++) {
                counts[k] = tp_lists[tp.count_base + min(s + k, supers - 1u) * bins + bin];
            }
            for (var k = 0u; k < 8u; k++) {
                if (s + k < supers) {
                    tp_lists[tp.count_base + (s + k) * bins + bin] = total;
                    total += counts[k];
                }
            }
        }
        tp_lists[tp.bin_base + bin * 2u + 1u] = total;
    }
    storageBarrier();
    let share = (bins + TP_LANES - 1u) / TP_LANES;
    let first = min(lane * share, bins);
    let end = min(first + share, bins);
    // This lane's bins: list blocks and bins that are not empty.
    var sum = vec2<u32>(0u);
    var longest = 0u;
    for (var bin = first; bin < end; bin++) {
        let total = tp_lists[tp.bin_base + bin * 2u + 1u];
        let blocks = (total + 31u) / 32u;
        tp_lists[tp.bin_base + bin * 2u] = sum.x;
        sum += vec2<u32>(blocks, select(0u, 1u, total > 0u));
        longest = max(longest, blocks);
    }
    tp_sums[lane] = sum;
//#if ROUNDS
    tp_longest[lane] = longest;
//#endif
    workgroupBarrier();
    var before = vec2<u32>(0u);
    for (var l = 0u; l < lane; l++) {
        before += tp_sums[l];
    }
    let total = before + sum;
    var active_bins = before.y;
    for (var bin = first; bin < end; bin++) {
        let at = tp.bin_base + bin * 2u;
        tp_lists[at] += before.x;
        if (tp_lists[at + 1u] > 0u) {
            tp_lists[tp.active_base + active_bins] = bin;
            active_bins++;
        }
    }
    if (lane == TP_LANES - 1u) {
        // Lists that do not fit are not drawn, nor anything after them: the host draws the rest with more room or in smaller pieces.
        if (total.x > tp.list_blocks && tp_indirect[TP_FAILED] == 0u) {
            tp_indirect[TP_FAILED] = tp.action + 1u;
            tp_indirect[TP_FAILED + 6u] = total.x;
        }
        let failed = tp_indirect[TP_FAILED] != 0u;
        let blocks = select(total.x, 0u, failed);
        let drawn = select(total.y, 0u, failed);
        let groups = (blocks + TP_TEAMS - 1u) / TP_TEAMS;
        tp_indirect[0] = min(groups, 32768u);
        tp_indirect[1] = (groups + 32767u) / 32768u;
        tp_indirect[2] = 1u;
        // The active stage counts the fine stage's workgroups, here and in the third word of the lists, unless they are all tiles.
        let tiles = select(0u, bins * 64u, (tp.fresh & TP_FRESH_CLEARS) != 0u && !failed);
        tp_indirect[TP_FINE_DISPATCH] = min(tiles, 32768u);
        tp_indirect[TP_FINE_DISPATCH + 1u] = max((tiles + 32767u) / 32768u, 1u);
        tp_indirect[TP_FINE_DISPATCH + 2u] = 1u;
        tp_lists[0] = total.x;
        tp_lists[1] = drawn;
        tp_lists[2] = tiles;
//#if ROUNDS
        // The first block of the round, and the blocks of the longest list.
        tp_lists[3] = 0u;
        longest = 0u;
        for (var l = 0u; l < TP_LANES; l++) {
            longest = max(longest, tp_longest[l]);
        }
        tp_lists[4] = longest;
//#endif
    }
}
