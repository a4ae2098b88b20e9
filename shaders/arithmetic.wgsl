// Arithmetic whose result is the same on every device: wide integers, and floats rounded as the CPU executor rounds them.

//#if INT64
//#else
// Low and high word of a * b, signed.
fn tp_mul64(a: i32, b: i32) -> vec2<u32> {
    let ua = bitcast<u32>(a);
    let ub = bitcast<u32>(b);
    let al = ua & 0xffffu;
    let ah = ua >> 16u;
    let bl = ub & 0xffffu;
    let bh = ub >> 16u;
    let ll = al * bl;
    let m = ah * bl + (ll >> 16u);
    let n = al * bh + (m & 0xffffu);
    var high = ah * bh + (m >> 16u) + (n >> 16u);
    // The unsigned product counts a negative factor 2^32 too often.
    high -= select(0u, ub, a < 0) + select(0u, ua, b < 0);
    return vec2<u32>((n << 16u) | (ll & 0xffffu), high);
}
//#endif

// floor((a*b - c*d - bias) / 2^shift), saturated to +-2^30: an edge function in whole steps of 2^shift subpixels. Steps from pixel to pixel are
// below 2^24 (LARGEST_STEP of src/raster/tile.rs): within 32 pixels nothing changes its sign or overflows by that.
fn tp_edge_floor(a: i32, b: i32, c: i32, d: i32, bias: u32, shift: u32) -> i32 {
//#if INT64
    let e = (i64(a) * i64(b) - i64(c) * i64(d) - i64(bias)) >> shift;
    return i32(clamp(e, i64(-0x40000000), i64(0x40000000)));
//#else
    let p = tp_mul64(a, b);
    let q = tp_mul64(c, d);
    var low = p.x - q.x;
    var high = p.y - q.y - select(0u, 1u, p.x < q.x);
    high -= select(0u, 1u, low < bias);
    low -= bias;
    let h = bitcast<i32>(high);
    let inside = (high << (32u - shift)) | (low >> shift);
    let limit = 1i << (shift - 2u);
    return select(select(bitcast<i32>(inside), 0x40000000, h >= limit), -0x40000000, h < -limit);
//#endif
}

// The integer nearest to x, the even one of two, for 0 <= x < 2^24. Sums run at full speed where conversions do not: adding 2^23 rounds to an
// integer and leaves it in the low bits; from 2^23 on every float is one.
fn tp_round(x: f32) -> u32 {
//#if FUSES
    let small = x < 8388608.0;
    return bitcast<u32>(select(x, x + 8388608.0, small)) - select(0x4a800000u, 0x4b000000u, small);
//#else
    return u32(i32(round(x)));
//#endif
}

// Bits 4 to 7 of a * b - c * d - bias.
fn tp_edge_low(a: i32, b: i32, c: i32, d: i32, bias: u32) -> u32 {
    return ((bitcast<u32>(a * b) - bitcast<u32>(c * d) - bias) >> 4u) & 15u;
}

// a * b + c, rounded once. Mesa's lavapipe splits fma, so there it is worked out in double precision: the product is exact.
fn tp_fma(a: f32, b: f32, c: f32) -> f32 {
//#if FMA64
    return f32(f64(a) * f64(b) + f64(c));
//#else
    return fma(a, b, c);
//#endif
}

fn tp_fma4(a: f32, b: vec4<f32>, c: vec4<f32>) -> vec4<f32> {
//#if FMA64
    return vec4<f32>(tp_fma(a, b.x, c.x), tp_fma(a, b.y, c.y), tp_fma(a, b.z, c.z), tp_fma(a, b.w, c.w));
//#else
    return fma(vec4<f32>(a), b, c);
//#endif
}

// a * b, rounded on its own. WGSL lets a compiler join a product with the sum that follows it, and GPUs' compilers do. Nothing can be
// joined to a sum whose third term it does not know: tp_zero() is -0 and comes from a buffer, so that the product's own zero keeps its sign.
fn tp_mul(a: f32, b: f32) -> f32 {
//#if FUSES
    return fma(a, b, tp_zero());
//#else
    return a * b;
//#endif
}

fn tp_mul4(a: vec4<f32>, b: f32) -> vec4<f32> {
//#if FUSES
    return fma(a, vec4<f32>(b), vec4<f32>(tp_zero()));
//#else
    return a * b;
//#endif
}

// 1 / b, correctly rounded: a GPU's own may be off by a unit or two, which one Newton step with fused remainders mends (Markstein).
fn tp_reciprocal(b: f32) -> f32 {
    let r = 1.0 / b;
//#if FUSES
    let mended = fma(fma(-b, r, 1.0), r, r);
    return select(r, mended, tp_finite(mended));
//#else
    return r;
//#endif
}

// a / b, correctly rounded likewise.
fn tp_divide(a: f32, b: f32) -> f32 {
//#if FUSES
    let r = tp_reciprocal(b);
    let q = tp_mul(a, r);
    let mended = fma(fma(-q, b, a), r, q);
    return select(q, mended, tp_finite(mended));
//#else
    return a / b;
//#endif
}

// Neither infinite nor not a number.
fn tp_finite(v: f32) -> bool {
    return (bitcast<u32>(v) & 0x7f800000u) != 0x7f800000u;
}

fn tp_log2(x: f32) -> f32 {
//#if FMA64
    // As src/program/lanes/math.rs, so that both executors choose the same level.
    let bits = bitcast<i32>(x);
    let e = (bits - 0x3f3504f3) >> 23u;
    let m = f64(bitcast<f32>(bits - (e << 23u)));
    let f = (m - f64(1.0)) / (m + f64(1.0));
    let s = f * f;
    var p = f64(1.0) / f64(15.0);
    p = p * s + f64(1.0) / f64(13.0);
    p = p * s + f64(1.0) / f64(11.0);
    p = p * s + f64(1.0) / f64(9.0);
    p = p * s + f64(1.0) / f64(7.0);
    p = p * s + f64(1.0) / f64(5.0);
    p = p * s + f64(1.0) / f64(3.0);
    p = p * s + f64(1.0);
    let r = f32(f64(e) + f64(2.0) * f * p * f64(1.442695040888963407));
    return select(r, -1e30, x <= 0.0);
//#else
    return select(log2(x), -1e30, x <= 0.0);
//#endif
}

// The intrinsic of programs: pow. Mesa's lavapipe has a logarithm of few digits, which an exponent of 128 multiplies.
fn power(a: f32, b: f32) -> f32 {
//#if FMA64
    return exp2(b * tp_log2(a));
//#else
    return pow(a, b);
//#endif
}

// The intrinsics of programs: normalize and inverseSqrt. Lavapipe's reciprocal square root has twelve digits, its square root all.
fn inverse_root(a: f32) -> f32 {
//#if FMA64
    return 1.0 / sqrt(a);
//#else
    return inverseSqrt(a);
//#endif
}

fn unit(v: vec3<f32>) -> vec3<f32> {
//#if FMA64
    return v * inverse_root(dot(v, v));
//#else
    return normalize(v);
//#endif
}

// The intrinsics of programs: products that no compiler joins with the sums that follow.
fn product(a: vec4<f32>, b: f32) -> vec4<f32> {
    return tp_mul4(a, b);
}

fn products(a: vec4<f32>, b: vec4<f32>) -> vec4<f32> {
//#if FUSES
    return fma(a, b, vec4<f32>(tp_zero()));
//#else
    return a * b;
//#endif
}
