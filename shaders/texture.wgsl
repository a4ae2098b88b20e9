// Texture sampling (3.8.7, 3.8.8): the twin of src/raster/texture.rs. Kind, format, wrap modes and filters of a slot are
// constants of the kernel, so that only what the slot needs is left after inlining.

// A slot's binding: words of its record, the same for all pixels of a triangle.
struct TpTexture {
    // Room for the base level; each level halves the size of the one before.
    room: u32,
    // Halvings of the room from level to level: 1 or 2.
    halvings: u32,
    last: u32,
    lod_range: vec2<f32>,
    lod_bias: f32,
    // The base level.
    offset: u32,
    size: vec3<i32>,
    border: vec4<f32>,
}

// What is constant about a slot: kind 1 to 3 dimensions or 4 for cube maps; wrap modes numbered as in
// src/draw/texture.rs; mip 0 none, 1 nearest, 2 linear.
struct TpClass {
    kind: u32,
    floats: bool,
    wrap: vec3<u32>,
    mag_linear: bool,
    min_linear: bool,
    mip: u32,
}

struct TpAxis {
    low: i32,
    high: i32,
    weight: f32,
}

// Fraction of a coordinate in its period, mirrored in every other one.
fn tp_mirrored(c: f32) -> f32 {
    let whole = floor(c);
    let odd = whole - 2.0 * floor(whole * 0.5) != 0.0;
    let part = c - whole;
    return select(part, 1.0 - part, odd);
}

// Index of the nearest texel, -1 for the border.
fn tp_nearest(c: f32, size: i32, wrap: u32) -> i32 {
    let n = f32(size);
    var u = c * n;
    if (wrap == 0u) {
        u = (c - floor(c)) * n;
    }
    if (wrap == 4u) {
        u = tp_mirrored(c) * n;
    }
    let i = i32(floor(u));
    if (wrap == 3u) {
        return select(i, -1, i < 0 || i >= size);
    }
    return clamp(i, 0, size - 1);
}

// Indices of the two texels around a coordinate, and the weight of the second.
fn tp_linear(c: f32, size: i32, wrap: u32) -> TpAxis {
    let n = f32(size);
    var u = 0.0;
    if (wrap == 0u) {
        u = (c - floor(c)) * n - 0.5;
    }
    if (wrap == 1u) {
        u = min(max(c, 0.0), 1.0) * n - 0.5;
    }
    if (wrap == 2u) {
        u = min(max(c * n, 0.5), n - 0.5) - 0.5;
    }
    if (wrap == 3u) {
        u = min(max(c * n, -0.5), n + 0.5) - 0.5;
    }
    if (wrap == 4u) {
        u = min(max(tp_mirrored(c) * n, 0.5), n - 0.5) - 0.5;
    }
    let whole = floor(u);
    let i = i32(whole);
    let j = i + 1;
    var a: TpAxis;
    a.weight = u - whole;
    if (wrap == 0u) {
        // What is not a number is less than 0 in both.
        a.low = select(i, size - 1, i < 0);
        a.high = select(0, j, u32(j) < u32(size));
    } else if (wrap == 1u || wrap == 3u) {
        a.low = select(i, -1, i < 0 || i >= size);
        a.high = select(j, -1, j < 0 || j >= size);
    } else {
        a.low = clamp(i, 0, size - 1);
        a.high = clamp(j, 0, size - 1);
    }
    return a;
}

// Some index may be -1.
fn tp_may_leave(c: TpClass) -> bool {
    return any(c.wrap == vec3<u32>(1u)) || any(c.wrap == vec3<u32>(3u));
}

// A texel's number within its level; of one beyond the border that of some texel.
fn tp_number(c: TpClass, size: vec3<i32>, x: i32, y: i32, z: i32) -> u32 {
    let at = (z * size.y + y) * size.x + x;
    if (tp_may_leave(c)) {
        return u32(max(at, 0));
    }
    return u32(at);
}

fn tp_bytes(w: u32) -> vec4<f32> {
    return vec4<f32>(vec4<i32>(i32(w & 255u), i32((w >> 8u) & 255u), i32((w >> 16u) & 255u), i32(w >> 24u)));
}

// A texel, or the border.
fn tp_or_border(t: TpTexture, c: TpClass, v: vec4<f32>, x: i32, y: i32, z: i32) -> vec4<f32> {
    if (tp_may_leave(c)) {
        return select(v, t.border * select(255.0, 1.0, c.floats), (x | y | z) < 0);
    }
    return v;
}

//#if TEXEL_PAIRS
// Two words of the image of texels, whose rows follow each other.
fn tp_texel_pair(at: u32) -> vec2<u32> {
    return textureLoad(tp_texels, vec2<u32>(at & 4095u, at >> 12u)).xy;
}
//#endif

// A texel; components of 8 bits count from 0 to 255.
fn tp_texel(t: TpTexture, c: TpClass, offset: u32, size: vec3<i32>, x: i32, y: i32, z: i32) -> vec4<f32> {
    let at = tp_number(c, size, x, y, z);
    var v: vec4<f32>;
    if (c.floats) {
//#if TEXEL_PAIRS
        let w = (offset >> 1u) + at * 2u;
        v = bitcast<vec4<f32>>(vec4<u32>(tp_texel_pair(w), tp_texel_pair(w + 1u)));
//#else
        let w = offset + at * 4u;
        v = bitcast<vec4<f32>>(vec4<u32>(tp_texels[w], tp_texels[w + 1u], tp_texels[w + 2u], tp_texels[w + 3u]));
//#endif
    } else {
//#if TEXEL_PAIRS
        v = tp_bytes(tp_texel_pair((offset >> 1u) + at).x);
//#else
        v = tp_bytes(tp_texels[offset + at]);
//#endif
    }
    return tp_or_border(t, c, v, x, y, z);
}

// The two texels of a row around a coordinate, mixed.
fn tp_row(t: TpTexture, c: TpClass, offset: u32, size: vec3<i32>, x: TpAxis, y: i32, z: i32) -> vec4<f32> {
//#if TEXEL_PAIRS
    if (!c.floats) {
        let first = max(x.low, 0);
        let pair = tp_texel_pair((offset >> 1u) + tp_number(c, size, first, y, z));
        let low = pair.x;
        var high = pair.y;
        // The neighbour is that of a texture that repeats.
        if (c.wrap.x != 0u) {
            high = select(high, low, x.high == first);
        }
        return tp_lerp(tp_or_border(t, c, tp_bytes(low), x.low, y, z), tp_or_border(t, c, tp_bytes(high), x.high, y, z), x.weight);
    }
//#endif
    return tp_lerp(tp_texel(t, c, offset, size, x.low, y, z), tp_texel(t, c, offset, size, x.high, y, z), x.weight);
}

fn tp_lerp(a: vec4<f32>, b: vec4<f32>, t: f32) -> vec4<f32> {
    return a + t * (b - a);
}

fn tp_bilinear(t: TpTexture, c: TpClass, offset: u32, size: vec3<i32>, x: TpAxis, y: TpAxis, z: i32) -> vec4<f32> {
    return tp_lerp(tp_row(t, c, offset, size, x, y.low, z), tp_row(t, c, offset, size, x, y.high, z), y.weight);
}

// One level with one filter; `p` is s, t, r, and the face of a cube map.
fn tp_level(t: TpTexture, c: TpClass, offset: u32, size: vec3<i32>, linear: bool, p: vec4<f32>) -> vec4<f32> {
    let scale = select(1.0 / 255.0, 1.0, c.floats);
    let face = i32(p.w);
    if (!linear) {
        let x = tp_nearest(p.x, size.x, c.wrap.x);
        var y = 0;
        if (c.kind != 1u) {
            y = tp_nearest(p.y, size.y, c.wrap.y);
        }
        var z = face;
        if (c.kind == 3u) {
            z = tp_nearest(p.z, size.z, c.wrap.z);
        }
        return tp_texel(t, c, offset, size, x, y, z) * scale;
    }
    let x = tp_linear(p.x, size.x, c.wrap.x);
    if (c.kind == 1u) {
        return tp_row(t, c, offset, size, x, 0, 0) * scale;
    }
    let y = tp_linear(p.y, size.y, c.wrap.y);
    if (c.kind != 3u) {
        return tp_bilinear(t, c, offset, size, x, y, face) * scale;
    }
    let z = tp_linear(p.z, size.z, c.wrap.z);
    return tp_lerp(tp_bilinear(t, c, offset, size, x, y, z.low), tp_bilinear(t, c, offset, size, x, y, z.high), z.weight) * scale;
}

// The coordinates of a direction on a face of a cube map (table 3.19).
fn tp_on_face(face: i32, d: vec3<f32>) -> vec2<f32> {
    var v = vec3<f32>(-d.z, -d.y, d.x);
    v = select(v, vec3<f32>(d.z, -d.y, d.x), face == 1);
    v = select(v, vec3<f32>(d.x, d.z, d.y), face == 2);
    v = select(v, vec3<f32>(d.x, -d.z, d.y), face == 3);
    v = select(v, vec3<f32>(d.x, -d.y, d.z), face == 4);
    v = select(v, vec3<f32>(-d.x, -d.y, d.z), face == 5);
    return 0.5 * (v.xy / abs(v.z) + 1.0);
}

fn tp_major_face(d: vec3<f32>) -> i32 {
    let a = abs(d);
    let x = a.x >= a.y && a.x >= a.z;
    let y = a.y >= a.z;
    let base = select(select(4, 2, y), 0, x);
    return base + select(0, 1, select(select(d.z, d.y, y), d.x, x) < 0.0);
}

fn tp_level_size(t: TpTexture, c: TpClass, level: u32) -> vec3<i32> {
    let size = max(t.size >> vec3<u32>(level), vec3<i32>(1));
    return vec3<i32>(size.xy, select(size.z, 6, c.kind == 4u));
}

// log2, off by 2^-15 at most; of 0 and less -127 or less.
fn tp_short_log2(x: f32) -> f32 {
//#if FMA64
    let bits = bitcast<i32>(x);
    let m = bitcast<f32>((bits & 0x7fffff) | 0x3f800000) - 1.0;
    let p = ((((0.04514766 * m - 0.19357217) * m + 0.41560295) * m - 0.70909536) * m + 1.44191692) * m;
    return f32((bits >> 23u) - 127) + p;
//#else
    return select(log2(x), -1e30, x <= 0.0);
//#endif
}

// A homogeneous coordinate as its ratios to q.
fn tp_projected(c: vec4<f32>) -> vec4<f32> {
    return vec4<f32>(c.xyz * (1.0 / c.w), 1.0);
}

// Where a level lies in tp_texels: what the rooms before it add up to, which is (4 room - (4 room >> 2 level)) / 3 where each is a quarter of the
// one before. The quotient is exact, so that the product with 1/3 modulo 2^32 is it.
fn tp_level_offset(t: TpTexture, level: u32) -> u32 {
    let all = t.room << t.halvings;
    let sum = all - (all >> (t.halvings * level));
    return t.offset + select(sum, sum * 0xaaaaaaabu, t.halvings == 2u);
}

fn tp_sample(t: TpTexture, c: TpClass, coord: vec4<f32>, ddx: vec4<f32>, ddy: vec4<f32>) -> vec4<f32> {
    var p = vec4<f32>(coord.xyz, 0.0);
    if (c.kind == 4u) {
        let face = tp_major_face(coord.xyz);
        p = vec4<f32>(tp_on_face(face, coord.xyz), 0.0, f32(face));
    }
    if (c.mip == 0u && c.mag_linear == c.min_linear) {
        return tp_level(t, c, t.offset, t.size, c.mag_linear, p);
    }
    // The level of detail (3.8.8).
    var n = vec3<f32>(t.size);
    if (c.kind == 1u) {
        n = vec3<f32>(n.x, 0.0, 0.0);
    }
    if (c.kind == 2u) {
        n.z = 0.0;
    }
    var dx = ddx.xyz * n;
    var dy = ddy.xyz * n;
    if (c.kind == 4u) {
        dx = vec3<f32>((tp_on_face(i32(p.w), coord.xyz + ddx.xyz) - p.xy) * n.xy, 0.0);
        dy = vec3<f32>((tp_on_face(i32(p.w), coord.xyz + ddy.xyz) - p.xy) * n.xy, 0.0);
    }
    let rho2 = max(dx.x * dx.x + dx.y * dx.y + dx.z * dx.z, dy.x * dy.x + dy.y * dy.y + dy.z * dy.z);
    // Where levels are blended, a short logarithm is good enough.
    var log2_rho2 = 0.0;
    if (c.mip == 2u && c.mag_linear == c.min_linear) {
        log2_rho2 = tp_short_log2(rho2);
    } else {
        log2_rho2 = tp_log2(rho2);
    }
    let lambda = min(max(0.5 * log2_rho2 + t.lod_bias, t.lod_range.x), t.lod_range.y);
    var switch_over = 0.0;
    if (c.mag_linear && !c.min_linear && c.mip != 0u) {
        switch_over = 0.5;
    }
    let minified = lambda > switch_over;
    if (c.mip == 0u) {
        return select(tp_level(t, c, t.offset, t.size, c.mag_linear, p), tp_level(t, c, t.offset, t.size, c.min_linear, p), minified);
    }
    var whole = floor(lambda);
    if (c.mip == 1u) {
        whole = select(ceil(lambda + 0.5) - 1.0, 0.0, lambda <= 0.5);
    }
    let level = select(0u, min(u32(max(whole, 0.0)), t.last), minified);
    let size = tp_level_size(t, c, level);
    var v = tp_level(t, c, tp_level_offset(t, level), size, c.min_linear, p);
    if (c.mip == 2u) {
        let next = min(level + 1u, t.last);
        let blend = select(0.0, lambda - whole, minified && level < t.last);
        // Where one level is enough the other is not looked at.
        if (blend > 0.0) {
            v = tp_lerp(v, tp_level(t, c, tp_level_offset(t, next), tp_level_size(t, c, next), c.min_linear, p), blend);
        }
    }
    if (c.mag_linear != c.min_linear) {
        v = select(tp_level(t, c, t.offset, t.size, c.mag_linear, p), v, minified);
    }
    return v;
}
