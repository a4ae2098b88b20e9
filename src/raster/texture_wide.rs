//! The fast paths of [`texture`](super::texture) for RGBA8 images whose wrap modes never reach the border, with AVX2: one level, and
//! trilinear filtering with levels lane by lane. The same operations in the same order, so the same bits.

use std::arch::x86_64::*;

use crate::draw::texture::{TextureLevel, Wrap};
use crate::program::lanes::LANES;

type Lanes = [f32; LANES];

/// A wrap mode that stays inside the image.
fn stays_inside(wrap: Wrap, linear: bool) -> bool {
    match wrap {
        Wrap::Repeat | Wrap::ClampToEdge | Wrap::MirroredRepeat => true,
        Wrap::Clamp => !linear,
        Wrap::ClampToBorder => false,
    }
}

/// True where a level can be sampled here: the wrap modes stay inside and the texels are all there.
pub fn serves(level: &TextureLevel, wrap: [Wrap; 2], linear: bool) -> bool {
    wrap.into_iter().all(|w| stays_inside(w, linear)) && is_whole(level)
}

/// All texels of the level are there.
fn is_whole(level: &TextureLevel) -> bool {
    let texels = u64::from(level.width) * u64::from(level.height) * u64::from(level.depth);
    texels > 0 && texels < 1 << 31 && level.texels.len() as u64 >= texels
}

/// Bilinear filtering on the two levels around each lane's λ, blended. `coord` is s, t and what is not looked at. `None` where this
/// cannot be done here.
///
/// # Safety
/// The processor must have AVX2.
#[target_feature(enable = "avx2")]
pub unsafe fn trilinear(levels: &[TextureLevel], wrap: [Wrap; 2], coord: &[Lanes; 4], lambda: &Lanes) -> Option<[Lanes; 4]> {
    let base = levels.first()?;
    let last = levels.len() - 1;
    if !wrap.into_iter().all(|w| stays_inside(w, true)) {
        return None;
    }
    // SAFETY: eight lanes are 32 bytes.
    let (s, t, lambda) =
        unsafe { (_mm256_loadu_ps(coord[0].as_ptr()), _mm256_loadu_ps(coord[1].as_ptr()), _mm256_loadu_ps(lambda.as_ptr())) };
    // Where λ is not above 0, and where it is not a number: the base level. At the last level there is nothing to blend with.
    let minified = _mm256_cmp_ps::<_CMP_GT_OQ>(lambda, _mm256_setzero_ps());
    let floor = _mm256_floor_ps(lambda);
    let last_f = _mm256_set1_ps(last as f32);
    let blended = _mm256_and_ps(minified, _mm256_cmp_ps::<_CMP_LT_OQ>(floor, last_f));
    let blend = _mm256_and_ps(_mm256_sub_ps(lambda, floor), blended);
    let near = _mm256_cvttps_epi32(_mm256_and_ps(_mm256_min_ps(floor, last_f), minified));
    let far = _mm256_min_epi32(_mm256_add_epi32(near, _mm256_set1_epi32(1)), _mm256_set1_epi32(last as i32));
    let mut of = [[0i32; LANES]; 2];
    // SAFETY: as above.
    unsafe {
        _mm256_storeu_si256(of[0].as_mut_ptr().cast(), near);
        _mm256_storeu_si256(of[1].as_mut_ptr().cast(), far);
    }
    let (mut first, mut end) = (last, 0);
    for lane in 0..LANES {
        first = first.min(of[0][lane] as usize);
        end = end.max(of[1][lane] as usize);
    }
    for k in first..=end {
        let level = &levels[k];
        // An image has 32 levels at most: no width has more bits.
        let (width, height) = ((base.width >> (k & 31)).max(1), (base.height >> (k & 31)).max(1));
        if level.width != width || level.height != height || !is_whole(level) {
            return None;
        }
    }
    let size = [base.width as i32, base.height as i32];
    // SAFETY: the levels from `first` to `end`, among which those of all lanes are, were checked just now.
    let mut value = unsafe { bilinear(levels, &of[0], near, size, wrap, s, t) };
    if _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_NEQ_UQ>(blend, _mm256_setzero_ps())) != 0 {
        // SAFETY: as above.
        let far = unsafe { bilinear(levels, &of[1], far, size, wrap, s, t) };
        for c in 0..4 {
            value[c] = lerp(value[c], far[c], blend);
        }
    }
    let mut result = [[0.0; LANES]; 4];
    for c in 0..4 {
        // SAFETY: eight lanes are 32 bytes.
        unsafe { _mm256_storeu_ps(result[c].as_mut_ptr(), value[c]) };
    }
    Some(result)
}

/// The four texels around each lane, on a level of its own, blended. `size` is the base level's.
///
/// # Safety
/// The lanes' levels are there, whole, and as large as the base level's halves. The processor must have AVX2.
#[target_feature(enable = "avx2")]
#[inline]
unsafe fn bilinear(
    levels: &[TextureLevel],
    of: &[i32; LANES],
    level: __m256i,
    size: [i32; 2],
    wrap: [Wrap; 2],
    s: __m256,
    t: __m256,
) -> [__m256; 4] {
    let one = _mm256_set1_epi32(1);
    let w = _mm256_max_epi32(_mm256_srlv_epi32(_mm256_set1_epi32(size[0]), level), one);
    let h = _mm256_max_epi32(_mm256_srlv_epi32(_mm256_set1_epi32(size[1]), level), one);
    let (x0, x1, fx) = linear_axis(s, w, wrap[0]);
    let (y0, y1, fy) = linear_axis(t, h, wrap[1]);
    let (low, high) = (_mm256_mullo_epi32(y0, w), _mm256_mullo_epi32(y1, w));
    let places = [_mm256_add_epi32(low, x0), _mm256_add_epi32(low, x1), _mm256_add_epi32(high, x0), _mm256_add_epi32(high, x1)];
    let mut at = [[0u32; LANES]; 4];
    for k in 0..4 {
        // SAFETY: eight lanes are 32 bytes.
        unsafe { _mm256_storeu_si256(at[k].as_mut_ptr().cast(), places[k]) };
    }
    let mut texels = [std::ptr::null::<u32>(); LANES];
    for lane in 0..LANES {
        // SAFETY: the caller's promise.
        texels[lane] = unsafe { levels.get_unchecked(of[lane] as usize) }.texels.as_ptr();
    }
    // SAFETY: the indices were clamped to the level's size.
    let texel = |k: usize, lane: usize| unsafe { *texels[lane].add(at[k][lane] as usize) as i32 };
    // A load each: gathers are no faster, and slower on some processors.
    let fetch = |k: usize| {
        let [a, b, c, d] = [texel(k, 0), texel(k, 1), texel(k, 2), texel(k, 3)];
        _mm256_setr_epi32(a, b, c, d, texel(k, 4), texel(k, 5), texel(k, 6), texel(k, 7))
    };
    filter([fetch(0), fetch(1), fetch(2), fetch(3)], fx, fy)
}

/// Blends four texels, component by component.
#[target_feature(enable = "avx2")]
#[inline]
fn filter(words: [__m256i; 4], fx: __m256, fy: __m256) -> [__m256; 4] {
    let scale = _mm256_set1_ps(1.0 / 255.0);
    let mut result = [_mm256_setzero_ps(); 4];
    for (c, lanes) in result.iter_mut().enumerate() {
        let [a, b, d, e] = words;
        let (a, b, d, e) = (component(a, c as i32), component(b, c as i32), component(d, c as i32), component(e, c as i32));
        *lanes = _mm256_mul_ps(lerp(lerp(a, b, fx), lerp(d, e, fx), fy), scale);
    }
    result
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
    let (x0, x1, fx) = linear_axis(s, width, wrap[0]);
    let (y0, y1, fy) = linear_axis(t, _mm256_set1_epi32(h), wrap[1]);
    let (low, high) = (_mm256_add_epi32(first, y0), _mm256_add_epi32(first, y1));
    let value = filter([fetch(x0, low), fetch(x1, low), fetch(x0, high), fetch(x1, high)], fx, fy);
    for (lanes, value) in result.iter_mut().zip(value) {
        // SAFETY: as above.
        unsafe { _mm256_storeu_ps(lanes.as_mut_ptr(), value) };
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
fn index(x: __m256, max: __m256) -> __m256i {
    // MAXPS gives its second operand where the first is NaN.
    let x = _mm256_min_ps(_mm256_max_ps(x, _mm256_setzero_ps()), max);
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
    index(_mm256_floor_ps(_mm256_mul_ps(c, n)), _mm256_set1_ps((size - 1) as f32))
}

/// Indices of the two texels around a coordinate, and the weight of the second.
#[target_feature(enable = "avx2")]
#[inline]
fn linear_axis(c: __m256, size: __m256i, wrap: Wrap) -> (__m256i, __m256i, __m256) {
    let (n, half) = (_mm256_cvtepi32_ps(size), _mm256_set1_ps(0.5));
    let last = _mm256_sub_epi32(size, _mm256_set1_epi32(1));
    let most = _mm256_cvtepi32_ps(last);
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
        let negative = _mm256_castps_si256(_mm256_cmp_ps::<_CMP_LT_OQ>(first, _mm256_setzero_ps()));
        let past = _mm256_castps_si256(_mm256_cmp_ps::<_CMP_GE_OQ>(second, n));
        let low = _mm256_blendv_epi8(index(first, most), last, negative);
        let high = _mm256_andnot_si256(past, index(second, most));
        return (low, high, weight);
    }
    (index(first, most), index(second, most), weight)
}
