// What the fine stages have in common whose lanes are a column of a tile each.

const TP_ROWS = 8;

//#if SUBGROUP8
// What was loaded of a draw, and of which one.
var<private> tp_kept: array<u32, 32>;
var<private> tp_kept_key: u32 = 0xffffffffu;
//#endif

// Two words of the lists that all lanes want, the first of them at an even place.
fn tp_list_pair(at: u32, lane: u32) -> vec2<u32> {
//#if SUBGROUP8
    var pair = 0lu;
    if (lane == 0u) {
        pair = tp_lists[at >> 1u];
    }
    return vec2<u32>(subgroupBroadcast(u32(pair & 0xfffffffflu), 0u), subgroupBroadcast(u32(pair >> 32u), 0u));
//#else
    return vec2<u32>(tp_lists[at], tp_lists[at + 1u]);
//#endif
}

// A word of the lists that all lanes want.
fn tp_list(at: u32, lane: u32) -> u32 {
//#if SUBGROUP8
    let pair = tp_list_pair(at & ~1u, lane);
    return select(pair.x, pair.y, (at & 1u) != 0u);
//#else
    return tp_lists[at];
//#endif
}
