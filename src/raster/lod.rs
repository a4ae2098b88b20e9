//! The level of detail of textures (3.8.8): `log2(max(|d/dx|, |d/dy|))` in texels, the ideal function of equation 3.20.

use super::simd::Simd;
use super::texture::{Position, on_face};
use crate::draw::texture::{Sampler, TextureImage, TextureKind, TextureLevel};
use crate::program::lanes::{LANES, math};

type Lanes = [f32; LANES];

/// Levels are blended, and one filter serves magnification and minification.
pub fn runs_on(sampler: &Sampler) -> bool {
    sampler.mip_linear == Some(true) && sampler.mag_linear == sampler.min_linear
}

/// λ of eight lanes on a flat image, from the derivatives of s and t in x and y.
#[inline(always)]
pub fn flat<S: Simd>(kind: TextureKind, sampler: &Sampler, base: &TextureLevel, gradients: [[S::F; 2]; 2]) -> S::F {
    let size = [S::f(base.width as f32), S::f(base.height as f32)];
    let mut squares = [S::f(0.0); 2];
    for (square, [s, t]) in squares.iter_mut().zip(gradients) {
        let s = S::mul(s, size[0]);
        *square = S::mul(s, s);
        if kind != TextureKind::D1 {
            let t = S::mul(t, size[1]);
            *square = S::add(*square, S::mul(t, t));
        }
    }
    of_squares::<S>(sampler, squares)
}

/// λ of eight lanes on any image: `coord` and its derivatives, and where `position` says that this is on the image.
#[inline(always)]
pub fn group<S: Simd>(
    image: &TextureImage,
    sampler: &Sampler,
    base: &TextureLevel,
    coord: &[Lanes; 4],
    gradients: [&[Lanes; 3]; 2],
    position: &Position,
) -> Lanes {
    let size = [base.width as f32, base.height as f32, base.depth as f32];
    let mut squares = [S::f(0.0); 2];
    for (square, gradient) in squares.iter_mut().zip(gradients) {
        // Loops, not `map`: closures for it are compiled for the baseline, outside of the functions of a level.
        let mut lanes = [0.0; LANES];
        match image.kind {
            TextureKind::D1 | TextureKind::D2 => {
                let flat_gradients = gradients.map(|g| [S::load(&g[0]), S::load(&g[1])]);
                S::store(flat::<S>(image.kind, sampler, base, flat_gradients), &mut lanes);
                return lanes;
            }
            TextureKind::D3 => {
                for i in 0..LANES {
                    let d = [gradient[0][i] * size[0], gradient[1][i] * size[1], gradient[2][i] * size[2]];
                    lanes[i] = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
                }
            }
            TextureKind::Cube => {
                for i in 0..LANES {
                    let next = [coord[0][i] + gradient[0][i], coord[1][i] + gradient[1][i], coord[2][i] + gradient[2][i]];
                    let [s, t] = on_face(position.face[i] as usize, next);
                    let d = [(s - position.s[i]) * size[0], (t - position.t[i]) * size[1]];
                    lanes[i] = d[0] * d[0] + d[1] * d[1];
                }
            }
        }
        *square = S::load(&lanes);
    }
    let mut lambda = [0.0; LANES];
    S::store(of_squares::<S>(sampler, squares), &mut lambda);
    lambda
}

/// λ, biased and clamped, from the squares of the lengths of both derivatives, in texels.
#[inline(always)]
fn of_squares<S: Simd>(sampler: &Sampler, [x, y]: [S::F; 2]) -> S::F {
    // The second where either is not a number.
    let rho2 = S::from_bits(S::select(S::lt(y, x), S::bits(x), S::bits(y)));
    // Where the colour runs on from level to level without a jump, the logarithm need not be exact to the last bit.
    let log2 = if runs_on(sampler) {
        log2_near::<S>(rho2)
    } else {
        let mut lanes = [0.0; LANES];
        S::store(rho2, &mut lanes);
        for lane in &mut lanes {
            *lane = math::log2(*lane);
        }
        S::load(&lanes)
    };
    let biased = S::add(S::mul(S::f(0.5), log2), S::f(sampler.lod_bias));
    S::clamp(biased, S::f(sampler.lod_range[0]), S::f(sampler.lod_range[1]))
}

/// log2(x) in single precision, within 3e-7 of the whole: for a level of detail between levels that are blended. Zero is a number of
/// that size too small for any level, infinity one too large.
#[inline(always)]
fn log2_near<S: Simd>(x: S::F) -> S::F {
    // x = m * 2^e with m in [sqrt(1/2), sqrt(2))
    let (bits, one) = (S::bits(x), S::f(1.0));
    let e = S::sar::<23>(S::isub(bits, S::i(0x3f35_04f3)));
    let m = S::from_bits(S::isub(bits, S::shl::<23>(e)));
    let f = S::div(S::sub(m, one), S::add(m, one));
    let s = S::mul(f, f);
    // 2 atanh(f): |f| <= 0.172, the first term left out is 2e-9 of the whole.
    let mut p = S::f(1.0 / 9.0);
    for term in [1.0 / 7.0, 1.0 / 5.0, 1.0 / 3.0, 1.0] {
        p = S::add(S::mul(p, s), S::f(term));
    }
    let r = S::add(S::to_f(e), S::mul(S::mul(S::f(2.0 * std::f32::consts::LOG2_E), f), p));
    let not_a_number = S::gt(S::and(bits, S::i(0x7fff_ffff)), S::i(0x7f80_0000));
    S::from_bits(S::select(not_a_number, bits, S::bits(r)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::simd::Portable;

    #[test]
    fn the_near_logarithm_is_near_the_exact_one() {
        for k in 0..2000 {
            let x = 1.03f32.powi(k - 1000) * (1.0 + k as f32 * 1e-4);
            let (near, exact) = (log2_near::<Portable>([x; 8])[0] as f64, (x as f64).log2());
            assert!((near - exact).abs() <= 3e-7 * exact.abs().max(1.0), "log2_near {x}: {near} {exact}");
        }
        assert!(log2_near::<Portable>([f32::NAN; 8])[0].is_nan());
    }
}
