// A workgroup (SUBGROUP8: a subgroup of one) for each block of 32 list entries: which tiles of the bin does each triangle touch? The masks of tiles
// (64 bits a triangle) are transposed to masks of triangles (32 bits a tile), so that the fine stage walks a tile's
// triangles in order by counting bits: no lists, no sizes to guess. Also writes, entry by entry, what the fine stage wants to
// know of the triangle in this bin (TP_ENTRY_WORDS words): three times c, a and b, the rectangle, planes, draw and flags.

//#if SUBGROUP8
//#else
var<workgroup> tp_tiles: array<vec2<u32>, 32>;
//#endif

// Writes the entry's record for the fine stage and returns the tiles that the triangle touches, bit y * 8 + x, of the bin
// at `origin`. Edge functions are relative to the bin: c + a * x + b * y, inside where none is negative, 32 bits all over it: they are
// saturated at the bin's middle, and c itself is right modulo 2^32.
fn tp_entry(base: u32, at: u32, origin: vec2<i32>) -> vec2<u32> {
    let box_words = tp_triangle_words(base, TP_TRIANGLE_COLUMNS / 2u);
    let columns = box_words.x;
    let rows = box_words.y;
    let left = max(i32(columns & 0xffffu) - origin.x, 0);
    let right = min(i32(columns >> 16u) - origin.x, 63);
    let top = max(i32(rows & 0xffffu) - origin.y, 0);
    let bottom = min(i32(rows >> 16u) - origin.y, 63);
    let x0 = left >> 3u;
    let x1 = right >> 3u;
    let y0 = top >> 3u;
    let y1 = bottom >> 3u;
    let span = ((2u << u32(x1)) - 1u) & ~((1u << u32(x0)) - 1u);
    let corners = tp_corners(base);
    let px = corners.x;
    let py = corners.y;
    let dx = px - px.yzx;
    let dy = py - py.yzx;
    let qx = origin.x * 256 - px;
    let qy = origin.y * 256 - py;
    let mx = qx + 32 * 256;
    let my = qy + 32 * 256;
    let middle = vec3<i32>(
        tp_edge_floor(dx.x, my.x, dy.x, mx.x, tp_edge_bias(dx.x, dy.x), 8u),
        tp_edge_floor(dx.y, my.y, dy.y, mx.y, tp_edge_bias(dx.y, dy.y), 8u),
        tp_edge_floor(dx.z, my.z, dy.z, mx.z, tp_edge_bias(dx.z, dy.z), 8u));
    let a = -dy;
    let b = dx;
    let c = middle - 32 * a - 32 * b;
    for (var k = 0u; k < 3u; k++) {
        tp_lists[at + k] = bitcast<u32>(c[k]);
        tp_lists[at + 3u + k] = bitcast<u32>(a[k]);
        tp_lists[at + 6u + k] = bitcast<u32>(b[k]);
    }
    var box = u32(left) | (u32(right) << 8u) | (u32(top) << 16u) | (u32(bottom) << 24u);
    var planes = tp_triangle_words(base, TP_TRIANGLE_PLANES / 2u).x * 4u;
    let draw_words = tp_triangle_words(base, TP_TRIANGLE_DRAW / 2u);
    var flags = draw_words.y;
    // Each edge function at the corner of a tile where it is greatest.
    var most = c + 7 * (max(a, vec3<i32>(0)) + max(b, vec3<i32>(0)));
//#if SAMPLES
    // Samples lie off the centres: the next four bits of the edge functions decide. They go where bits are free: two in each byte of the
    // rectangle, two below the planes, two above the flags.
    let low = vec3<u32>(
        tp_edge_low(dx.x, qy.x, dy.x, qx.x, tp_edge_bias(dx.x, dy.x)),
        tp_edge_low(dx.y, qy.y, dy.y, qx.y, tp_edge_bias(dx.y, dy.y)),
        tp_edge_low(dx.z, qy.z, dy.z, qx.z, tp_edge_bias(dx.z, dy.z)));
    box |= ((low.x & 3u) << 6u) | ((low.x >> 2u) << 14u) | ((low.y & 3u) << 22u) | ((low.y >> 2u) << 30u);
    planes |= low.z & 3u;
    flags |= (low.z >> 2u) << 6u;
    most += ((abs(a) + abs(b)) >> vec3<u32>(1u)) + 1;
//#endif
    tp_lists[at + 9u] = box;
    tp_lists[at + 10u] = planes;
    tp_lists[at + 11u] = draw_words.x | (flags << 24u);
    let small = x0 == x1 || y0 == y1;
    var mask = vec2<u32>(0u);
    for (var y = 0; y < 8; y++) {
        var row = span;
        if (!small) {
            row = 0u;
            for (var x = x0; x <= x1; x++) {
                let e = most + a * (8 * x) + b * (8 * y);
                row |= select(0u, 1u, (e.x | e.y | e.z) >= 0) << u32(x);
            }
        }
        row = select(0u, row, y >= y0 && y <= y1) << (u32(y & 3) * 8u);
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
