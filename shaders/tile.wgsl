// A workgroup (SUBGROUP8: a subgroup of one) for each block of 32 list entries: which tiles of the bin does each triangle touch? The masks of tiles
// (64 bits a triangle) are transposed to masks of triangles (32 bits a tile), so that the fine stage walks a tile's
// triangles in order by counting bits: no lists, no sizes to guess. Also writes, entry by entry, what the fine stage wants to
// know of the triangle in this bin (TP_ENTRY_WORDS words): three times c, a and b, the rectangle, planes, draw and flags.

//#if SUBGROUP8
//#else
var<workgroup> tp_tiles: array<vec2<u32>, 32>;
//#endif

// Writes the entry's record for the fine stage and returns the tiles that the triangle touches, bit y * 8 + x, of the bin
// at `origin`.
fn tp_entry(base: u32, at: u32, origin: vec2<i32>) -> vec2<u32> {
    let box = tp_box_in_bin(base, origin);
    let t = tp_in_bin(base, origin, box);
    for (var k = 0u; k < 3u; k++) {
        tp_lists[at + k] = bitcast<u32>(t.c[k]);
        tp_lists[at + 3u + k] = bitcast<u32>(t.a[k]);
        tp_lists[at + 6u + k] = bitcast<u32>(t.b[k]);
    }
    tp_lists[at + 9u] = t.box;
    tp_lists[at + 10u] = t.planes;
    tp_lists[at + 11u] = t.draw_and_flags;
    let low = box.low >> vec2<u32>(3u);
    let high = box.high >> vec2<u32>(3u);
    let span = ((2u << u32(high.x)) - 1u) & ~((1u << u32(low.x)) - 1u);
    let small = low.x == high.x || low.y == high.y;
    var mask = vec2<u32>(0u);
    for (var y = 0; y < 8; y++) {
        var row = span;
        if (!small) {
            row = 0u;
            for (var x = low.x; x <= high.x; x++) {
                let e = t.most + t.a * (8 * x) + t.b * (8 * y);
                row |= select(0u, 1u, (e.x | e.y | e.z) >= 0) << u32(x);
            }
        }
        row = select(0u, row, y >= low.y && y <= high.y) << (u32(y & 3) * 8u);
        mask |= select(vec2<u32>(0u, row), vec2<u32>(row, 0u), y < 4);
    }
    return mask;
}

// A word of the lists that all lanes want.
fn tp_list(at: u32, lane: u32) -> u32 {
//#if SUBGROUP8
    var word = 0u;
    if (lane == 0u) {
        word = tp_lists[at];
    }
    return subgroupBroadcast(word, 0u);
//#else
    return tp_lists[at];
//#endif
}

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(local_invocation_index) index_in_group: u32) {
//#if SUBGROUP8
    let lane = index_in_group & 7u;
    let block = (group.x + group.y * 32768u) * TP_TEAMS + index_in_group / 8u;
//#else
    let lane = index_in_group;
    let block = group.x + group.y * 32768u;
//#endif
    if (block >= tp_lists[0]) {
        return;
    }
    // The bin whose list holds the block: the last one that starts at or before it.
    var low = 0u;
    var high = tp.bins.x * tp.bins.y - 1u;
    loop {
        if (low >= high) {
            break;
        }
        let middle = (low + high + 1u) / 2u;
        if (tp_list(tp.bin_base + middle * 2u, lane) <= block) {
            low = middle;
        } else {
            high = middle - 1u;
        }
    }
    let bin = low;
    let start = tp_list(tp.bin_base + bin * 2u, lane);
    let count = tp_list(tp.bin_base + bin * 2u + 1u, lane) - (block - start) * 32u;
    let origin = vec2<i32>(vec2<u32>(bin % tp.bins.x, bin / tp.bins.x) * 64u);
//#if SUBGROUP8
    // A subgroup of eight lanes: each hands its masks to all, and each lane keeps its column of tiles. Byte r of a word holds the bits
    // of this round's eight entries for the tile of row r.
    var low_rows = vec4<u32>(0u);
    var high_rows = vec4<u32>(0u);
    var first = 0u;
    loop {
        let entry = first + lane;
        var mask = vec2<u32>(0u);
        if (entry < count) {
            let at = block * 32u + entry;
            mask = tp_entry(tp_lists[tp.list_base + at] * TP_TRIANGLE_WORDS, tp.entry_base + at * TP_ENTRY_WORDS, origin);
        }
        var bits = vec2<u32>(0u);
//#each $ 8
        bits |= ((vec2<u32>(subgroupBroadcast(mask.x, $u), subgroupBroadcast(mask.y, $u)) >> vec2<u32>(lane)) & vec2<u32>(0x01010101u)) << vec2<u32>($u);
//#end
        low_rows |= ((vec4<u32>(bits.x) >> vec4<u32>(0u, 8u, 16u, 24u)) & vec4<u32>(255u)) << vec4<u32>(first);
        high_rows |= ((vec4<u32>(bits.y) >> vec4<u32>(0u, 8u, 16u, 24u)) & vec4<u32>(255u)) << vec4<u32>(first);
        continuing {
            first += 8u;
            break if first >= min(count, 32u);
        }
    }
    let at = tp.tile_base + block * 64u + lane;
    for (var r = 0u; r < 4u; r++) {
        tp_lists[at + r * 8u] = low_rows[r];
        tp_lists[at + 32u + r * 8u] = high_rows[r];
    }
//#else
    var entry = lane;
    loop {
        if (entry < 32u) {
            var mask = vec2<u32>(0u);
            if (entry < count) {
                let at = block * 32u + entry;
                mask = tp_entry(tp_lists[tp.list_base + at] * TP_TRIANGLE_WORDS, tp.entry_base + at * TP_ENTRY_WORDS, origin);
            }
            tp_tiles[entry] = mask;
        }
        continuing {
            entry += TP_LANES;
            break if entry >= 32u;
        }
    }
    workgroupBarrier();
    var tile = lane;
    loop {
        var word = 0u;
        for (var e = 0u; e < 32u; e++) {
            let mask = tp_tiles[e];
            let half = select(mask.y, mask.x, tile < 32u);
            word |= ((half >> (tile & 31u)) & 1u) << e;
        }
        tp_lists[tp.tile_base + block * 64u + tile] = word;
        continuing {
            tile += TP_LANES;
            break if tile >= 64u;
        }
    }
//#endif
}
