//! The fast path of [`texture`](super::texture): one level of an RGBA8 image whose wrap modes never reach the border, with
//! AVX2 gathers. The same operations in the same order, so the same bits.

use std::arch::x86_64::*;

use crate::draw::texture::{TextureLevel, Wrap};
use crate::program::lanes::LANES;

type Lanes = [f32; LANES];

/// True where a level can be sampled here: the wrap modes stay inside and the texels are all there.
pub fn serves(level: &TextureLevel, wrap: [Wrap; 2], linear: bool) -> bool {
    let inside = |w: Wrap| match w {
        Wrap::Repeat | Wrap::ClampToEdge | Wrap::MirroredRepeat => true,
        Wrap::Clamp => !linear,
        Wrap::ClampToBorder => false,
    };
    let texels = u64::from(level.width) * u64::from(level.height) * u64::from(level.depth);
    wrap.into_iter().all(inside) && texels > 0 && texels < 1 << 31 && level.texels.len() as u64 >= texels
}

/// The texel under each lane, or the four around it blended. `layer` is the cube face.
///
/// # Safety
/// [`serves`] holds, and `layer` is below the level's depth. The processor must have AVX2.
#[target_feature(enable = "avx2")]
pub unsafe fn sample(level: &TextureLevel, wrap: [Wrap; 2], linear: bool, s: &Lanes, t: &Lanes, layer: &[i32; LANES]) -> [Lanes; 4] {
    let (w, h) = (level.width as i32, level.height as i32);
    // SAFETY: eight lanes are 32 bytes.
    let (s, t, z) = unsafe { (_mm256_loadu_ps(s.as_ptr()), _mm256_loadu_ps(t.as_ptr()), _mm256_loadu_si256(layer.as_ptr().cast())) };
    let width = _mm256_set1_epi32(w);
    let first = _mm256_mullo_epi32(z, _mm256_set1_epi32(h));
    let texels: *const i32 = level.texels.as_ptr().cast();
    let fetch = |x: __m256i, row: __m256i| {
        // SAFETY: x is in 0..w, the row in 0..h of a layer below the depth: `serves` checked that such texels exist.
        unsafe { _mm256_i32gather_epi32::<4>(texels, _mm256_add_epi32(_mm256_mullo_epi32(row, width), x)) }
    };
    let scale = _mm256_set1_ps(1.0 / 255.0);
    let mut result = [[0.0; LANES]; 4];
    if !linear {
        let word = fetch(nearest(s, w, wrap[0]), _mm256_add_epi32(first, nearest(t, h, wrap[1])));
        for (c, lanes) in result.iter_mut().enumerate() {
            // SAFETY: as above.
            unsafe { _mm256_storeu_ps(lanes.as_mut_ptr(), _mm256_mul_ps(component(word, c as i32), scale)) };
        }
        return result;
    }
    let (x0, x1, fx) = linear_axis(s, w, wrap[0]);
    let (y0, y1, fy) = linear_axis(t, h, wrap[1]);
    let (low, high) = (_mm256_add_epi32(first, y0), _mm256_add_epi32(first, y1));
    let words = [fetch(x0, low), fetch(x1, low), fetch(x0, high), fetch(x1, high)];
    for (c, lanes) in result.iter_mut().enumerate() {
        let [a, b, d, e] = words.map(|word| component(word, c as i32));
        let value = lerp(lerp(a, b, fx), lerp(d, e, fx), fy);
        // SAFETY: as above.
        unsafe { _mm256_storeu_ps(lanes.as_mut_ptr(), _mm256_mul_ps(value, scale)) };
    }
    result
}

#[target_feature(enable = "avx2")]
#[inline]
fn component(word: __m256i, c: i32) -> __m256 {
    let shifted = _mm256_srl_epi32(word, _mm_cvtsi32_si128(8 * c));
    _mm256_cvtepi32_ps(_mm256_and_si256(shifted, _mm256_set1_epi32(255)))
}

#[target_feature(enable = "avx2")]
#[inline]
fn lerp(a: __m256, b: __m256, t: __m256) -> __m256 {
    _mm256_add_ps(a, _mm256_mul_ps(t, _mm256_sub_ps(b, a)))
}

/// Fraction of a coordinate in its period, mirrored in every other one.
#[target_feature(enable = "avx2")]
#[inline]
fn mirrored(c: __m256) -> __m256 {
    let (half, two, one) = (_mm256_set1_ps(0.5), _mm256_set1_ps(2.0), _mm256_set1_ps(1.0));
    let whole = _mm256_floor_ps(c);
    let odd = _mm256_sub_ps(whole, _mm256_mul_ps(two, _mm256_floor_ps(_mm256_mul_ps(whole, half))));
    let odd = _mm256_cmp_ps::<_CMP_NEQ_UQ>(odd, _mm256_setzero_ps());
    let part = _mm256_sub_ps(c, whole);
    _mm256_blendv_ps(part, _mm256_sub_ps(one, part), odd)
}

/// Clamps to 0..=max and converts; NaN becomes 0.
#[target_feature(enable = "avx2")]
#[inline]
fn index(x: __m256, max: i32) -> __m256i {
    // MAXPS gives its second operand where the first is NaN.
    let x = _mm256_min_ps(_mm256_max_ps(x, _mm256_setzero_ps()), _mm256_set1_ps(max as f32));
    _mm256_cvttps_epi32(x)
}

#[target_feature(enable = "avx2")]
#[inline]
fn nearest(c: __m256, size: i32, wrap: Wrap) -> __m256i {
    let n = _mm256_set1_ps(size as f32);
    let c = match wrap {
        Wrap::Repeat => _mm256_sub_ps(c, _mm256_floor_ps(c)),
        Wrap::MirroredRepeat => mirrored(c),
        _ => c,
    };
    index(_mm256_floor_ps(_mm256_mul_ps(c, n)), size - 1)
}

/// Indices of the two texels around a coordinate, and the weight of the second.
#[target_feature(enable = "avx2")]
#[inline]
fn linear_axis(c: __m256, size: i32, wrap: Wrap) -> (__m256i, __m256i, __m256) {
    let (n, half) = (_mm256_set1_ps(size as f32), _mm256_set1_ps(0.5));
    let edge = |x: __m256| {
        let inner = _mm256_min_ps(_mm256_max_ps(x, half), _mm256_sub_ps(n, half));
        _mm256_sub_ps(inner, half)
    };
    let u = match wrap {
        Wrap::Repeat => _mm256_sub_ps(_mm256_mul_ps(_mm256_sub_ps(c, _mm256_floor_ps(c)), n), half),
        Wrap::MirroredRepeat => edge(_mm256_mul_ps(mirrored(c), n)),
        _ => edge(_mm256_mul_ps(c, n)),
    };
    let floor = _mm256_floor_ps(u);
    let weight = _mm256_sub_ps(u, floor);
    let one = _mm256_set1_ps(1.0);
    let (first, second) = (floor, _mm256_add_ps(floor, one));
    if wrap == Wrap::Repeat {
        // -1 wraps to the last texel, `size` to the first.
        let last = _mm256_set1_epi32(size - 1);
        let negative = _mm256_castps_si256(_mm256_cmp_ps::<_CMP_LT_OQ>(first, _mm256_setzero_ps()));
        let past = _mm256_castps_si256(_mm256_cmp_ps::<_CMP_GE_OQ>(second, n));
        let low = _mm256_blendv_epi8(index(first, size - 1), last, negative);
        let high = _mm256_andnot_si256(past, index(second, size - 1));
        return (low, high, weight);
    }
    (index(first, size - 1), index(second, size - 1), weight)
}
