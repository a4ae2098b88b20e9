// Colour: quantised, blended or combined by a logic op, masked. Eight bits a component: unorm arithmetic, every product
// divided by 255 and rounded on its own as llvmpipe rounds it, sums and differences saturate (src/raster/blend.rs); others: src/raster/formats.rs.

//#if FLOAT_PIXELS
// SRC_ALPHA, ONE_MINUS_SRC_ALPHA into eight bits. A product t of two components becomes (t + (t >> 8) + 128) >> 8, which is t * 257 / 65536
// rounded to the nearest; no product of two bytes lies half way. Every intermediate value fits the 24 bits of a float, and adding 2^23 rounds.
fn tp_merge(state: TpState, old: TpPixel, color: vec4<f32>) -> TpPixel {
    const per_byte = 257.0 / 65536.0;
    // tp.magic is 2^23, which no compiler knows: (x + 2^23) - 2^23 would be x to some.
    let s = (tp_mul4(saturate(color), 255.0) + tp.magic) - 8388608.0;
    let sum = fma(old, vec4<f32>((255.0 - s.w) * per_byte), fma(s, vec4<f32>(s.w * per_byte), vec4<f32>(tp.magic)));
//#if COLOR_MASK
    let m = vec4<bool>((state.color_mask & 1u) != 0u, (state.color_mask & 2u) != 0u, (state.color_mask & 4u) != 0u, (state.color_mask & 8u) != 0u);
    return select(old, sum - 8388608.0, m);
//#else
    return sum - 8388608.0;
//#endif
}
//#else

//#if COLOR_8BIT
// Adding 2^23 rounds to the nearest (even) integer and leaves it in the low bits.
fn tp_quantise_color(c: vec4<f32>) -> vec4<u32> {
    return bitcast<vec4<u32>>(tp_mul4(min(max(c, vec4<f32>(0.0)), vec4<f32>(1.0)), 255.0) + 8388608.0) & vec4<u32>(255u);
}

// Red with blue, green with alpha, in halves of a word.
fn tp_quantise_pairs(c: vec4<f32>) -> vec2<u32> {
    let v = bitcast<vec4<u32>>(tp_mul4(min(max(c, vec4<f32>(0.0)), vec4<f32>(1.0)), 255.0) + 8388608.0);
    return vec2<u32>((v.x & 255u) | ((v.z & 255u) << 16u), (v.y & 255u) | ((v.w & 255u) << 16u));
}

// SRC_ALPHA, ONE_MINUS_SRC_ALPHA, two components at a time: the sum never exceeds 255.
fn tp_blend_alpha(s: vec2<u32>, d: u32) -> u32 {
    let a = s.y >> 16u;
    let b = 255u - a;
    let low = vec2<u32>(0x00ff00ffu);
    let sa = s * a;
    let db = vec2<u32>(d & 0x00ff00ffu, (d >> 8u) & 0x00ff00ffu) * b;
    let x = ((sa + ((sa >> vec2<u32>(8u)) & low) + 0x00800080u) >> vec2<u32>(8u)) & low;
    let y = ((db + ((db >> vec2<u32>(8u)) & low) + 0x00800080u) >> vec2<u32>(8u)) & low;
    let v = x + y;
    return v.x | (v.y << 8u);
}

//#if BLEND
fn tp_mul_unorm(a: vec4<u32>, b: vec4<u32>) -> vec4<u32> {
    let t = a * b;
    return (t + (t >> vec4<u32>(8u)) + 128u) >> vec4<u32>(8u);
}

// A term times its blend factor; `f` is known when the kernel is built, unless draws of the segment differ.
fn tp_factor(f: u32, s: vec4<u32>, d: vec4<u32>, constant: vec4<u32>) -> vec4<u32> {
    var v = vec4<u32>(0u);
    switch f {
        case 1u: { v = TP_COLOR_MAX; }
        case 2u: { v = s; }
        case 3u: { v = TP_COLOR_MAX - s; }
        case 4u: { v = s.wwww; }
        case 5u: { v = TP_COLOR_MAX - s.wwww; }
        case 6u: { v = d.wwww; }
        case 7u: { v = TP_COLOR_MAX - d.wwww; }
        case 8u: { v = d; }
        case 9u: { v = TP_COLOR_MAX - d; }
        case 10u: { v = vec4<u32>(min(s.www, TP_COLOR_MAX.www - d.www), TP_COLOR_MAX.w); }
        case 11u: { v = constant; }
        case 12u: { v = TP_COLOR_MAX - constant; }
        case 13u: { v = constant.wwww; }
        case 14u: { v = TP_COLOR_MAX - constant.wwww; }
        default: {}
    }
    return v;
}

fn tp_equation(eq: u32, fs: u32, fd: u32, s: vec4<u32>, d: vec4<u32>, constant: vec4<u32>) -> vec4<u32> {
    let a = tp_mul_unorm(s, tp_factor(fs, s, d, constant));
    let b = tp_mul_unorm(d, tp_factor(fd, s, d, constant));
    var v = min(a + b, TP_COLOR_MAX);
    switch eq {
        case 1u: { v = max(a, b) - b; }
        case 2u: { v = max(a, b) - a; }
        case 3u: { v = min(s, d); }
        case 4u: { v = max(s, d); }
        default: {}
    }
    return v;
}

fn tp_blend(state: TpState, s: vec4<u32>, d: vec4<u32>) -> vec4<u32> {
//#if BLEND_CONSTANT
    let constant = tp_quantise_color(state.blend_color);
//#else
    let constant = vec4<u32>(0u);
//#endif
//#if BLEND_DYNAMIC
    let factors = state.factors;
    let equations = state.equations;
//#else
    const factors = TP_BLEND_FACTORS;
    const equations = TP_BLEND_EQUATIONS;
//#endif
    let color = tp_equation(equations.x, factors.x, factors.y, s, d, constant);
//#if BLEND_UNIFORM
    return color;
//#else
    let alpha = tp_equation(equations.y, factors.z, factors.w, s, d, constant);
    return vec4<u32>(color.xyz, alpha.w);
//#endif
}
//#endif

fn tp_merge(state: TpState, old: TpPixel, color: vec4<f32>) -> TpPixel {
//#if BLEND_ALPHA
    return tp_masked(state, old, tp_blend_alpha(tp_quantise_pairs(color), old));
//#else
    var s = tp_quantise_color(color);
//#if BLEND
    let d = tp_unpack(old);
//#if STATE_FLAGS
    s = select(s, tp_blend(state, s, d), (state.flags & TP_BLEND_ON) != 0u);
//#else
    s = tp_blend(state, s, d);
//#endif
//#endif
    return tp_masked(state, old, tp_pack(s));
//#endif
}
//#endif

// The other formats blend in floats.
//#if COLOR_8BIT
//#else
fn tp_factor(f: u32, s: vec4<f32>, d: vec4<f32>, constant: vec4<f32>) -> vec4<f32> {
    var v = vec4<f32>(0.0);
    switch f {
        case 1u: { v = vec4<f32>(1.0); }
        case 2u: { v = s; }
        case 3u: { v = 1.0 - s; }
        case 4u: { v = s.wwww; }
        case 5u: { v = 1.0 - s.wwww; }
        case 6u: { v = d.wwww; }
        case 7u: { v = 1.0 - d.wwww; }
        case 8u: { v = d; }
        case 9u: { v = 1.0 - d; }
        case 10u: { v = vec4<f32>(vec3<f32>(min(s.w, 1.0 - d.w)), 1.0); }
        case 11u: { v = constant; }
        case 12u: { v = 1.0 - constant; }
        case 13u: { v = constant.wwww; }
        case 14u: { v = 1.0 - constant.wwww; }
        default: {}
    }
    return v;
}

fn tp_equation(eq: u32, fs: u32, fd: u32, s: vec4<f32>, d: vec4<f32>, constant: vec4<f32>) -> vec4<f32> {
    let a = s * tp_factor(fs, s, d, constant);
    let b = d * tp_factor(fd, s, d, constant);
    var v = a + b;
    switch eq {
        case 1u: { v = a - b; }
        case 2u: { v = b - a; }
        case 3u: { v = min(s, d); }
        case 4u: { v = max(s, d); }
        default: {}
    }
    return v;
}

fn tp_merge(state: TpState, old: TpPixel, color: vec4<f32>) -> TpPixel {
//#if COLOR_UNORM
    var s = clamp(color, vec4<f32>(0.0), vec4<f32>(1.0));
//#else
    var s = color;
//#endif
//#if BLEND
//#if COLOR_UNORM
    let d = vec4<f32>(tp_unpack(old)) / TP_COLOR_SCALE;
//#else
    let d = bitcast<vec4<f32>>(old);
//#endif
//#if BLEND_DYNAMIC
    let factors = state.factors;
    let equations = state.equations;
//#else
    const factors = TP_BLEND_FACTORS;
    const equations = TP_BLEND_EQUATIONS;
//#endif
//#if BLEND_CONSTANT
    let constant = state.blend_color;
//#else
    let constant = vec4<f32>(0.0);
//#endif
    let rgb = tp_equation(equations.x, factors.x, factors.y, s, d, constant);
    let alpha = tp_equation(equations.y, factors.z, factors.w, s, d, constant);
    let blended = vec4<f32>(rgb.xyz, alpha.w);
//#if STATE_FLAGS
    s = select(s, blended, (state.flags & TP_BLEND_ON) != 0u);
//#else
    s = blended;
//#endif
//#endif
//#if COLOR_UNORM
    return tp_masked(state, old, tp_pack(vec4<u32>(vec4<i32>(round(clamp(s, vec4<f32>(0.0), vec4<f32>(1.0)) * TP_COLOR_SCALE)))));
//#else
    return tp_masked(state, old, bitcast<vec4<u32>>(s));
//#endif
}
//#endif

// Logic op and colour mask.
fn tp_masked(state: TpState, old: TpPixel, new_pixel: TpPixel) -> TpPixel {
    var n = new_pixel;
//#if LOGIC_OP
//#if COLOR_UNORM
    let s = n;
    var v = n;
    switch state.logic_op {
        case 0u: { v = s & ~s; }
        case 1u: { v = s & old; }
        case 2u: { v = s & ~old; }
        case 4u: { v = ~s & old; }
        case 5u: { v = old; }
        case 6u: { v = s ^ old; }
        case 7u: { v = s | old; }
        case 8u: { v = ~(s | old); }
        case 9u: { v = ~(s ^ old); }
        case 10u: { v = ~old; }
        case 11u: { v = s | ~old; }
        case 12u: { v = ~s; }
        case 13u: { v = ~s | old; }
        case 14u: { v = ~(s & old); }
        case 15u: { v = s | ~s; }
        default: {}
    }
    n = select(n, tp_pack(tp_unpack(v)), (state.flags & TP_LOGIC_OP_ON) != 0u);
//#endif
//#endif
//#if COLOR_MASK
    let m = vec4<bool>((state.color_mask & 1u) != 0u, (state.color_mask & 2u) != 0u, (state.color_mask & 4u) != 0u, (state.color_mask & 8u) != 0u);
    n = tp_pack(select(tp_unpack(old), tp_unpack(n), m));
//#endif
    return n;
}
//#endif
