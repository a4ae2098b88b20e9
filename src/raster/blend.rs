//! Colour: quantised, blended and written, eight pixels of a row at a time.
//!
//! Colours of eight bits are kept as two words of 16-bit halves: red with blue, green with alpha. Blending is unorm
//! arithmetic: every product is divided by 255 and rounded on its own, sums and differences saturate.

use super::layout::*;
use super::simd::Simd;

/// Eight colours: (red | blue << 16, green | alpha << 16).
pub type Pairs<I> = (I, I);

/// Spreads packed RGBA8.
#[inline(always)]
pub fn unpack<S: Simd>(c: S::I) -> Pairs<S::I> {
    let low = S::i(0x00ff_00ff);
    (S::and(c, low), S::and(S::shr::<8>(c), low))
}

/// Packs to RGBA8.
#[inline(always)]
pub fn pack<S: Simd>(c: Pairs<S::I>) -> S::I {
    S::or(c.0, S::shl::<8>(c.1))
}

/// A float colour component to eight bits: clamped, times 255, to nearest even.
#[inline(always)]
pub fn quantize<S: Simd>(c: S::F) -> S::I {
    S::round(S::mul(S::clamp(c, S::f(0.0), S::f(1.0)), S::f(255.0)))
}

/// Four columns to packed RGBA8: [`quantize`] of each. What is below 0, and NaN, which rounds to the least integer, is clamped by
/// the packing.
#[inline(always)]
pub fn quantize4<S: Simd>(c: [S::F; 4]) -> S::I {
    let (one, most) = (S::f(1.0), S::f(255.0));
    S::bytes([
        S::round(S::mul(S::at_most(c[0], one), most)),
        S::round(S::mul(S::at_most(c[1], one), most)),
        S::round(S::mul(S::at_most(c[2], one), most)),
        S::round(S::mul(S::at_most(c[3], one), most)),
    ])
}

/// a * b / 255 of 16-bit halves up to 255, as llvmpipe rounds it: (t + (t >> 8) + 128) >> 8, which is one less
/// than the nearest in a few cases.
#[inline(always)]
fn mul255<S: Simd>(a: S::I, b: S::I) -> S::I {
    let t = S::mul16(a, b);
    S::shr16::<8>(S::add16(S::add16(t, S::shr16::<8>(t)), S::i(0x0080_0080)))
}

// Pairwise operations are spelled out: a closure or a function passed by name would not be compiled with the features of the
// SIMD level, and each instruction in it would become a call.

#[inline(always)]
fn mul255_pairs<S: Simd>(a: Pairs<S::I>, b: Pairs<S::I>) -> Pairs<S::I> {
    (mul255::<S>(a.0, b.0), mul255::<S>(a.1, b.1))
}

#[inline(always)]
fn min_pairs<S: Simd>(a: Pairs<S::I>, b: Pairs<S::I>) -> Pairs<S::I> {
    (S::min16(a.0, b.0), S::min16(a.1, b.1))
}

#[inline(always)]
fn max_pairs<S: Simd>(a: Pairs<S::I>, b: Pairs<S::I>) -> Pairs<S::I> {
    (S::max16(a.0, b.0), S::max16(a.1, b.1))
}

/// a - b, at least 0.
#[inline(always)]
fn difference<S: Simd>(a: Pairs<S::I>, b: Pairs<S::I>) -> Pairs<S::I> {
    (S::max16(S::sub16(a.0, b.0), S::i(0)), S::max16(S::sub16(a.1, b.1), S::i(0)))
}

/// a + b, at most 255.
#[inline(always)]
fn sum<S: Simd>(a: Pairs<S::I>, b: Pairs<S::I>) -> Pairs<S::I> {
    let most = S::i(0x00ff_00ff);
    (S::min16(S::add16(a.0, b.0), most), S::min16(S::add16(a.1, b.1), most))
}

/// Alpha in all four components.
#[inline(always)]
fn alpha<S: Simd>(c: Pairs<S::I>) -> Pairs<S::I> {
    let a = S::shr::<16>(c.1);
    let a = S::or(a, S::shl::<16>(a));
    (a, a)
}

#[inline(always)]
fn complement<S: Simd>(c: Pairs<S::I>) -> Pairs<S::I> {
    let most = S::i(0x00ff_00ff);
    (S::sub16(most, c.0), S::sub16(most, c.1))
}

/// `term` times a blend factor.
#[inline(always)]
fn times<S: Simd>(factor: u32, term: Pairs<S::I>, s: Pairs<S::I>, d: Pairs<S::I>, constant: Pairs<S::I>) -> Pairs<S::I> {
    use blend_factor::*;
    let f = match factor {
        ZERO => return (S::i(0), S::i(0)),
        ONE => return term,
        SRC_COLOR => s,
        ONE_MINUS_SRC_COLOR => complement::<S>(s),
        SRC_ALPHA => alpha::<S>(s),
        ONE_MINUS_SRC_ALPHA => complement::<S>(alpha::<S>(s)),
        DST_ALPHA => alpha::<S>(d),
        ONE_MINUS_DST_ALPHA => complement::<S>(alpha::<S>(d)),
        DST_COLOR => d,
        ONE_MINUS_DST_COLOR => complement::<S>(d),
        SRC_ALPHA_SATURATE => {
            let f = min_pairs::<S>(alpha::<S>(s), complement::<S>(alpha::<S>(d)));
            // The factor of alpha is 1.
            (f.0, S::or(S::and(f.1, S::i(0xffff)), S::i(0x00ff_0000)))
        }
        CONSTANT_COLOR => constant,
        ONE_MINUS_CONSTANT_COLOR => complement::<S>(constant),
        CONSTANT_ALPHA => alpha::<S>(constant),
        _ => complement::<S>(alpha::<S>(constant)),
    };
    mul255_pairs::<S>(term, f)
}

#[inline(always)]
fn equation<S: Simd>(state: &FragmentState, k: usize, s: Pairs<S::I>, d: Pairs<S::I>, constant: Pairs<S::I>) -> Pairs<S::I> {
    let eq = state.blend_equations[k];
    match eq {
        blend_equation::MIN => return min_pairs::<S>(s, d),
        blend_equation::MAX => return max_pairs::<S>(s, d),
        _ => {}
    }
    let a = times::<S>(state.blend_factors[2 * k], s, s, d, constant);
    let b = times::<S>(state.blend_factors[2 * k + 1], d, s, d, constant);
    match eq {
        blend_equation::SUBTRACT => difference::<S>(a, b),
        blend_equation::REVERSE_SUBTRACT => difference::<S>(b, a),
        _ => sum::<S>(a, b),
    }
}

/// Whether alpha is blended like the colours.
pub fn uniform(state: &FragmentState) -> bool {
    let f = &state.blend_factors;
    state.blend_equations[0] == state.blend_equations[1] && f[0] == f[2] && f[1] == f[3]
}

/// The blend colour as pairs in every lane.
pub fn constant_pairs(state: &FragmentState) -> (i32, i32) {
    let [r, g, b, a] = state.blend_color.map(|c| (c.clamp(0.0, 1.0) * 255.0).round_ties_even() as i32);
    (r | b << 16, g | a << 16)
}

/// Blends source over destination as the state says.
#[inline(always)]
pub fn blend<S: Simd>(state: &FragmentState, constant: (i32, i32), s: Pairs<S::I>, d: Pairs<S::I>) -> Pairs<S::I> {
    let constant = (S::i(constant.0), S::i(constant.1));
    let color = equation::<S>(state, 0, s, d, constant);
    if uniform(state) {
        return color;
    }
    let a = equation::<S>(state, 1, s, d, constant);
    (color.0, S::or(S::and(color.1, S::i(0xffff)), S::andnot(S::i(0xffff), a.1)))
}

/// SRC_ALPHA, ONE_MINUS_SRC_ALPHA of all four components: [`blend`] without its choices.
#[inline(always)]
pub fn over<S: Simd>(s: Pairs<S::I>, d: Pairs<S::I>) -> Pairs<S::I> {
    let a = S::shr::<16>(s.1);
    let a = S::or(a, S::shl::<16>(a));
    let not = S::sub16(S::i(0x00ff_00ff), a);
    // A product is at most each of its factors, so that the sums are at most a + (255 - a).
    (S::add16(mul255::<S>(s.0, a), mul255::<S>(d.0, not)), S::add16(mul255::<S>(s.1, a), mul255::<S>(d.1, not)))
}

/// A logic op on packed pixels (GL's op minus GL_CLEAR).
#[inline(always)]
pub fn logic_op<S: Simd>(op: u32, s: S::I, d: S::I) -> S::I {
    let ones = S::i(-1);
    match op {
        0 => S::i(0),
        1 => S::and(s, d),
        2 => S::andnot(d, s),
        3 => s,
        4 => S::andnot(s, d),
        5 => d,
        6 => S::xor(s, d),
        7 => S::or(s, d),
        8 => S::xor(S::or(s, d), ones),
        9 => S::xor(S::xor(s, d), ones),
        10 => S::xor(d, ones),
        11 => S::or(s, S::xor(d, ones)),
        12 => S::xor(s, ones),
        13 => S::or(S::xor(s, ones), d),
        14 => S::xor(S::and(s, d), ones),
        _ => ones,
    }
}

/// The bits of a packed RGBA8 pixel that a colour mask lets through.
pub fn mask_bits(color_mask: u32) -> u32 {
    (0..4).filter(|k| color_mask >> k & 1 != 0).map(|k| 0xff << (8 * k)).sum()
}
