// A triangle in a bin of 64 x 64 pixels, as the fine stage wants to know it: the tile stage writes it to lists; a fine stage without
// lists works it out.

// The part of the bin at `origin` that a triangle's rectangle covers, both ends included; low lies above high where it covers none.
struct TpBoxInBin {
    low: vec2<i32>,
    high: vec2<i32>,
}

struct TpInBin {
    // Edge functions relative to the bin: c + a * x + b * y, inside where none is negative, 32 bits all over it: they are saturated at the
    // bin's middle, and c itself is right modulo 2^32.
    c: vec3<i32>,
    a: vec3<i32>,
    b: vec3<i32>,
    // The rectangle, a byte each: first and last column, first and last row. Words of the planes. The draw below the flags.
    box: u32,
    planes: u32,
    draw_and_flags: u32,
    // Each edge function at the corner of the bin's first tile where it is greatest.
    most: vec3<i32>,
}

fn tp_box_in_bin(base: u32, origin: vec2<i32>) -> TpBoxInBin {
    let words = bitcast<vec2<i32>>(tp_triangle_words(base, TP_TRIANGLE_COLUMNS / 2u));
    let low = max((words & vec2<i32>(0xffff)) - origin, vec2<i32>(0));
    let high = min(vec2<i32>(bitcast<vec2<u32>>(words) >> vec2<u32>(16u)) - origin, vec2<i32>(63));
    return TpBoxInBin(low, high);
}

fn tp_in_bin(base: u32, origin: vec2<i32>, box: TpBoxInBin) -> TpInBin {
    var t: TpInBin;
    let corners = tp_corners(base);
    let dx = corners.x - corners.x.yzx;
    let dy = corners.y - corners.y.yzx;
    let qx = origin.x * 256 - corners.x;
    let qy = origin.y * 256 - corners.y;
    let mx = qx + 32 * 256;
    let my = qy + 32 * 256;
    let middle = vec3<i32>(
        tp_edge_floor(dx.x, my.x, dy.x, mx.x, tp_edge_bias(dx.x, dy.x), 8u),
        tp_edge_floor(dx.y, my.y, dy.y, mx.y, tp_edge_bias(dx.y, dy.y), 8u),
        tp_edge_floor(dx.z, my.z, dy.z, mx.z, tp_edge_bias(dx.z, dy.z), 8u));
    t.a = -dy;
    t.b = dx;
    t.c = middle - 32 * t.a - 32 * t.b;
    t.box = u32(box.low.x) | (u32(box.high.x) << 8u) | (u32(box.low.y) << 16u) | (u32(box.high.y) << 24u);
    t.planes = tp_triangle_words(base, TP_TRIANGLE_PLANES / 2u).x * 4u;
    let draw_words = tp_triangle_words(base, TP_TRIANGLE_DRAW / 2u);
    var flags = draw_words.y;
    t.most = t.c + 7 * (max(t.a, vec3<i32>(0)) + max(t.b, vec3<i32>(0)));
//#if SAMPLES
    // Samples lie off the centres: the next four bits of the edge functions decide. They go where bits are free: two in each byte of the
    // rectangle, two below the planes, two above the flags.
    let bits = vec3<u32>(
        tp_edge_low(dx.x, qy.x, dy.x, qx.x, tp_edge_bias(dx.x, dy.x)),
        tp_edge_low(dx.y, qy.y, dy.y, qx.y, tp_edge_bias(dx.y, dy.y)),
        tp_edge_low(dx.z, qy.z, dy.z, qx.z, tp_edge_bias(dx.z, dy.z)));
    t.box |= ((bits.x & 3u) << 6u) | ((bits.x >> 2u) << 14u) | ((bits.y & 3u) << 22u) | ((bits.y >> 2u) << 30u);
    t.planes |= bits.z & 3u;
    flags |= (bits.z >> 2u) << 6u;
    t.most += ((abs(t.a) + abs(t.b)) >> vec3<u32>(1u)) + 1;
//#endif
    t.draw_and_flags = draw_words.x | (flags << 24u);
    return t;
}
