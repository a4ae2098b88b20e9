// A workgroup for each block of 32 list entries: which tiles of the bin does each triangle touch? The masks of tiles
// (64 bits a triangle) are transposed to masks of triangles (32 bits a tile), so that the fine stage walks a tile's
// triangles in order by counting bits: no lists, no sizes to guess.

var<workgroup> tp_tiles: array<vec2<u32>, 32>;

// The tiles that a triangle touches, of the bin at `origin`: bit y * 8 + x.
fn tp_tile_mask(base: u32, origin: vec2<i32>) -> vec2<u32> {
    let columns = tp_triangles[base + TP_TRIANGLE_COLUMNS];
    let rows = tp_triangles[base + TP_TRIANGLE_ROWS];
    let x0 = max(i32(columns & 0xffffu) - origin.x, 0) >> 3u;
    let x1 = min(i32(columns >> 16u) - origin.x, 63) >> 3u;
    let y0 = max(i32(rows & 0xffffu) - origin.y, 0) >> 3u;
    let y1 = min(i32(rows >> 16u) - origin.y, 63) >> 3u;
    let span = ((2u << u32(x1)) - 1u) & ~((1u << u32(x0)) - 1u);
    var a: array<i32, 3>;
    var b: array<i32, 3>;
    var c: array<i32, 3>;
    for (var e = 0u; e < 3u; e++) {
        let f = select(e + 1u, 0u, e == 2u);
        let ax = bitcast<i32>(tp_triangles[base + e]);
        let ay = bitcast<i32>(tp_triangles[base + 3u + e]);
        let dx = ax - bitcast<i32>(tp_triangles[base + f]);
        let dy = ay - bitcast<i32>(tp_triangles[base + 3u + f]);
        // At the corner of the first tile where the edge function is greatest; from tile to tile it runs in steps of
        // 8 pixels, 2^11 subpixels.
        let x = origin.x + select(7, 0, dy > 0);
        let y = origin.y + select(0, 7, dx > 0);
        a[e] = -dy;
        b[e] = dx;
        c[e] = tp_edge_floor(dx, y * 256 - ay, dy, x * 256 - ax, tp_edge_bias(dx, dy), 11u);
    }
    var mask = vec2<u32>(0u);
    let small = x0 == x1 || y0 == y1;
    for (var y = 0; y < 8; y++) {
        var row = span;
        if (!small) {
            row = 0u;
            for (var x = x0; x <= x1; x++) {
                let e0 = c[0] + a[0] * x + b[0] * y;
                let e1 = c[1] + a[1] * x + b[1] * y;
                let e2 = c[2] + a[2] * x + b[2] * y;
                row |= select(0u, 1u, (e0 | e1 | e2) >= 0) << u32(x);
            }
        }
        row = select(0u, row, y >= y0 && y <= y1) << (u32(y & 3) * 8u);
        mask |= select(vec2<u32>(0u, row), vec2<u32>(row, 0u), y < 4);
    }
    return mask;
}

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(workgroup_id) group: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>, @builtin(local_invocation_index) lane: u32) {
    let block = group.x + group.y * 32768u;
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
        if (tp_lists[tp.bin_base + middle * 2u] <= block) {
            low = middle;
        } else {
            high = middle - 1u;
        }
    }
    let bin = low;
    let start = tp_lists[tp.bin_base + bin * 2u];
    let count = tp_lists[tp.bin_base + bin * 2u + 1u] - (block - start) * 32u;
    let origin = vec2<i32>(vec2<u32>(bin % tp.bins.x, bin / tp.bins.x) * 64u);
    var entry = lane;
    loop {
        if (entry < 32u) {
            var mask = vec2<u32>(0u);
            if (entry < count) {
                mask = tp_tile_mask(tp_lists[tp.list_base + block * 32u + entry] * TP_TRIANGLE_WORDS, origin);
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
}
