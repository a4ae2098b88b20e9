// A lane a triangle (or a triangle and a row of bins): which bins of 64 x 64 pixels does it touch? A bit a triangle is set in the bin's mask of its block
// (32 triangles). Reads triangles, writes masks (zero before; emit leaves them zero).

fn tp_outside(corners: TpCorners, corner: vec2<i32>) -> bool {
    // The box of samples corner .. corner + 63 lies outside one edge.
    var outside = false;
    for (var e = 0u; e < 3u; e++) {
        let f = select(e + 1u, 0u, e == 2u);
        let ax = corners.x[e];
        let ay = corners.y[e];
        let dx = ax - corners.x[f];
        let dy = ay - corners.y[f];
        // The corner where the edge function is greatest.
//#if SAMPLES
        // Samples lie within half a pixel of the centres.
        let x = corner.x + select(64, -1, dy > 0);
        let y = corner.y + select(-1, 64, dx > 0);
//#else
        let x = corner.x + select(63, 0, dy > 0);
        let y = corner.y + select(0, 63, dx > 0);
//#endif
        let c = tp_edge_floor(dx, y * 256 - ay, dy, x * 256 - ax, tp_edge_bias(dx, dy), 8u);
        outside = outside || c < 0;
    }
    return outside;
}

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    // Few triangles are mostly large ones: they get a lane for each row of bins.
    let count = tp_triangle_count();
    let lanes = select(1u, tp.bins.y, count < TP_FEW_TRIANGLES);
    let number = id.x + id.y * groups.x * TP_LANES;
    let index = number / lanes;
    if (index >= count) {
        return;
    }
    let base = (tp_first_triangle() + index) * TP_TRIANGLE_WORDS;
    let box = tp_triangle_words(base, TP_TRIANGLE_COLUMNS / 2u);
    let columns = box.x;
    let rows = box.y;
    let x0 = (columns & 0xffffu) >> 6u;
    let x1 = columns >> 22u;
    let row = number % lanes;
    let y0 = max((rows & 0xffffu) >> 6u, row);
    let y1 = select(rows >> 22u, min(rows >> 22u, row), lanes > 1u);
    if (x1 < x0 || y1 < y0) {
        return;
    }
    let bit = 1u << (index & 31u);
    let blocks = tp_blocks();
    // Boxes of up to 2 x 2 bins touch nearly all of them: the test would cost more than it saves.
    let test = (x1 - x0 + 1u) * (y1 - y0 + 1u) > 4u;
    var corners: TpCorners;
    if (test) {
        corners = tp_corners(base);
    }
    var x = x0;
    var y = y0;
    loop {
        var skip = false;
        if (test) {
            skip = tp_outside(corners, vec2<i32>(i32(x * 64u), i32(y * 64u)));
        }
        if (!skip) {
            atomicOr(&tp_lists[tp.mask_base + (y * tp.bins.x + x) * blocks + (index >> 5u)], bit);
        }
        continuing {
            let wrap = x == x1;
            x = select(x + 1u, x0, wrap);
            y = select(y, y + 1u, wrap);
            break if y > y1;
        }
    }
}
