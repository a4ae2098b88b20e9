// Samples offer keys: small triangles in the lane that sets them up, large ones are queued in blocks of 64 x 64 pixels.

// Most samples that a lane looks at by itself, in how many columns or rows. Where lanes take turns at memory a large triangle gains nothing by many
// lanes, each of which has to set out.
//#if SET_UP
const TP_SMALL = 512;
//#else
const TP_SMALL = 64;
//#endif
const TP_SMALL_SIDE = 64;

// What a lane knows of a triangle while it walks its samples.
struct TpWalk {
    // First and last column and row.
    low: vec2<i32>,
    high: vec2<i32>,
    // z: a0, d/dx, d/dy, and the polygon offset.
    z: vec4<f32>,
    depth_range: vec2<f32>,
    // The lower 40 bits of its keys.
    order: u64,
    x: vec3<i32>,
    y: vec3<i32>,
}

//#if SET_UP
// Triangle `index` of those that the host has set up.
fn tp_walk_triangle(index: u32, walk: ptr<function, TpWalk>) {
    let base = index * TP_TRIANGLE_WORDS;
    let box = tp_triangle_words(base, TP_TRIANGLE_COLUMNS / 2u);
    let corners = tp_corners(base);
    let planes = tp_triangle_words(base, TP_TRIANGLE_PLANES / 2u).x * 2u;
    let first = tp_planes[planes];
    let second = tp_planes[planes + 1u];
    var offset = 0.0;
//#if OFFSET
    offset = bitcast<f32>(u32(tp_planes[planes + 3u] & 0xfffffffflu));
//#endif
    let order = u64(index) << 8u;
    (*walk).low = vec2<i32>(vec2<u32>(box.x & 0xffffu, box.y & 0xffffu));
    (*walk).high = vec2<i32>(vec2<u32>(box.x >> 16u, box.y >> 16u));
    (*walk).z = vec4<f32>(
        bitcast<f32>(u32(first & 0xfffffffflu)), bitcast<f32>(u32(first >> 32u)), bitcast<f32>(u32(second & 0xfffffffflu)), offset);
    (*walk).depth_range = vec2<f32>(0.0, 1.0);
//#if LEQUAL
    (*walk).order = order ^ 0xfffffffffflu;
//#else
    (*walk).order = order;
//#endif
    (*walk).x = corners.x;
    (*walk).y = corners.y;
}
//#else
// False: it has no sample to draw.
fn tp_walk(p: TpPrimitive, index: u32, triangle: u32, a: TpCorner, b: TpCorner, c: TpCorner, walk: ptr<function, TpWalk>) -> bool {
    var x = vec3<i32>(a.snapped.x, b.snapped.x, c.snapped.x);
    var y = vec3<i32>(a.snapped.y, b.snapped.y, c.snapped.y);
    let area = tp_area_sign(x, y);
    if (area == 0 || tp_is_culled(tp_is_front(area, p.flags), p.flags)) {
        return false;
    }
    let box = tp_bounds(x, y, p.state, p.flags);
    let low = vec2<i32>(i32(box.x & 0xffffu), max(i32(box.y & 0xffffu), tf.first_row));
    let high = vec2<i32>(i32(box.x >> 16u), min(i32(box.y >> 16u), tf.end_row - 1));
    if (box.x == TP_NOWHERE || low.y > high.y) {
        return false;
    }
    // Vertices 0 and 1 change places where the area is negative.
    var first = a.position;
    var second = b.position;
    if (area < 0) {
        x = x.yxz;
        y = y.yxz;
        first = b.position;
        second = a.position;
    }
    let t = tp_basis(0.5, first, second, c.position);
    let d01 = first.z - second.z;
    let d20 = c.position.z - first.z;
    let dx = tp_mul(d01, t.dy20) - tp_mul(d20, t.dy01);
    let dy = tp_mul(d20, t.dx01) - tp_mul(d01, t.dx20);
    let z0 = first.z - (tp_mul(dx, t.x0c) + tp_mul(dy, t.y0c));
    var offset = 0.0;
    if ((p.flags & TP_OFFSET_FILL) != 0u) {
        offset = tp_polygon_offset(p.state, first, second, c.position);
    }
    (*walk).low = low;
    (*walk).high = high;
    (*walk).z = vec4<f32>(z0, dx, dy, offset);
    (*walk).depth_range = vec2<f32>(tp_state_float(p.state, TP_STATE_DEPTH_RANGE), tp_state_float(p.state, TP_STATE_DEPTH_RANGE + 1u));
    let order = (u64(index) << 8u) | u64(triangle);
//#if LEQUAL
    (*walk).order = order ^ 0xfffffffffflu;
//#else
    (*walk).order = order;
//#endif
    (*walk).x = x;
    (*walk).y = y;
    return true;
}
//#endif

// A covered sample offers its key. zx: the z plane at its column.
fn tp_offer(walk: ptr<function, TpWalk>, px: i32, py: i32, zx: f32) {
    let z = tp_fma(f32(py), (*walk).z.z, zx) + (*walk).z.w;
    let clamped = min(max(z, (*walk).depth_range.x), (*walk).depth_range.y);
    let depth = tp_round(tp_mul(clamped, TP_DEPTH_SCALE));
    atomicMin(&tp_keys[u32(py - tf.first_row) * tp.size.x + u32(px)], (u64(depth) << 40u) | (*walk).order);
}

// tp_edge_bias of the three edges.
fn tp_edge_biases(dx: vec3<i32>, dy: vec3<i32>) -> vec3<i32> {
    return vec3<i32>(vec3<u32>(tp_edge_bias(dx.x, dy.x), tp_edge_bias(dx.y, dy.y), tp_edge_bias(dx.z, dy.z)));
}

// Blocks of 64 x 64 pixels that a triangle's rectangle is cut into.
fn tp_blocks(walk: ptr<function, TpWalk>) -> vec2<u32> {
    return vec2<u32>(((*walk).high - (*walk).low + 64) >> vec2<u32>(6u));
}

// Those that a triangle is to be queued in; 0: a lane draws it by itself.
fn tp_blocks_of(walk: ptr<function, TpWalk>) -> vec2<u32> {
    let extent = (*walk).high - (*walk).low + 1;
    let small = extent.x <= TP_SMALL_SIDE && extent.y <= TP_SMALL_SIDE && extent.x * extent.y <= TP_SMALL;
    return select(tp_blocks(walk), vec2<u32>(0u), small);
}

//#if SET_UP
//#else
// Queues a triangle's blocks at a place of the queue.
fn tp_queue_blocks(first: u32, blocks: vec2<u32>, index: u32, triangle: u32) {
    let count = blocks.x * blocks.y;
    for (var k = 0u; k < count && first + k < tf.item_capacity; k++) {
        let at = tf.item_base + (first + k) * 3u;
        atomicStore(&tp_queue[at], index);
        atomicStore(&tp_queue[at + 1u], triangle);
        atomicStore(&tp_queue[at + 2u], (k % blocks.x) | ((k / blocks.x) << 16u));
    }
}
//#endif

// Edges shorter than this: near the first sample everything fits 32 bits.
const TP_NEAR = 0x4000;

// At least the longest edge along either axis, rounded up to where its highest bit is.
fn tp_reach(walk: ptr<function, TpWalk>) -> i32 {
    let dx = abs((*walk).x - (*walk).x.yzx);
    let dy = abs((*walk).y - (*walk).y.yzx);
    return dx.x | dx.y | dx.z | dy.x | dy.y | dy.z;
}

// A small triangle's samples offer their keys.
fn tp_offer_samples(walk: ptr<function, TpWalk>) {
    let low = (*walk).low;
    let extent = (*walk).high - low + 1;
    let dx = (*walk).x - (*walk).x.yzx;
    let dy = (*walk).y - (*walk).y.yzx;
    let qx = (*walk).x - low.x * 256;
    let qy = (*walk).y - low.y * 256;
//#if SET_UP
    let first = (dy * qx - dx * qy - tp_edge_biases(dx, dy)) >> vec3<u32>(8u);
//#else
    // The scissor may have left little of a large triangle.
    var first: vec3<i32>;
    if (tp_reach(walk) < TP_NEAR) {
        first = (dy * qx - dx * qy - tp_edge_biases(dx, dy)) >> vec3<u32>(8u);
    } else {
        first = tp_wide_edges(dx, dy, qx, qy);
    }
//#endif
//#if SET_UP
    // One loop, so that lanes with narrow triangles and lanes with low ones take as long as their samples are many.
    var e = first;
    var px = low.x;
    var py = low.y;
    loop {
        if ((e.x | e.y | e.z) >= 0) {
            tp_offer(walk, px, py, tp_fma(f32(px), (*walk).z.y, (*walk).z.x));
        }
        continuing {
            let wraps = px == (*walk).high.x;
            e += select(-dy, dx + dy * (extent.x - 1), wraps);
            py += select(0, 1, wraps);
            px = select(px + 1, low.x, wraps);
            break if py > (*walk).high.y;
        }
    }
//#else
    for (var row = 0; row < extent.y; row++) {
        var e = first + dx * row;
        let py = low.y + row;
        for (var column = 0; column < extent.x; column++) {
            if ((e.x | e.y | e.z) >= 0) {
                let px = low.x + column;
                tp_offer(walk, px, py, tp_fma(f32(px), (*walk).z.y, (*walk).z.x));
            }
            e -= dy;
        }
    }
//#endif
}

// The edge functions at the first of 64 x 64 pixels, in whole steps, saturated at their middle: right modulo 2^32, and right for all of them.
fn tp_wide_edges(dx: vec3<i32>, dy: vec3<i32>, qx: vec3<i32>, qy: vec3<i32>) -> vec3<i32> {
    let bias = tp_edge_biases(dx, dy);
    let mx = qx - 32 * 256;
    let my = qy - 32 * 256;
    var middle: vec3<i32>;
    for (var k = 0u; k < 3u; k++) {
        let e = (i64(dy[k]) * i64(mx[k]) - i64(dx[k]) * i64(my[k]) - i64(bias[k])) >> 8u;
        middle[k] = i32(clamp(e, i64(-0x40000000), i64(0x40000000)));
    }
    return middle + 32 * dy - 32 * dx;
}
