//! The fast paths of [`texture`](super::texture) for RGBA8 images whose wrap modes never reach the border, with AVX2: one level, and
//! trilinear filtering with levels lane by lane. The same operations in the same order, so the same bits.

use std::arch::x86_64::*;

use super::texture::Texels;
use crate::draw::texture::{TextureLevel, Wrap};
use crate::program::lanes::LANES;

type Lanes = [f32; LANES];
type Indices = [u32; LANES];

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

/// An image's levels, each half as large as the one before, all texels there.
pub struct Pyramid<'a> {
    /// Of each level. An image has 32 levels at most: no width has more bits.
    texels: [&'a [u32]; 32],
    /// Columns and rows of the first.
    size: [u32; 2],
    /// The last one.
    last: usize,
    wrap: [Wrap; 2],
}

impl<'a> Pyramid<'a> {
    /// Of levels that can be filtered here.
    pub fn new(levels: &'a [TextureLevel], wrap: [Wrap; 2]) -> Option<Pyramid<'a>> {
        let base = levels.first()?;
        if levels.len() > 32 || !wrap.into_iter().all(|w| stays_inside(w, true)) {
            return None;
        }
        let mut texels: [&[u32]; 32] = [&[]; 32];
        for (k, level) in levels.iter().enumerate() {
            let (width, height) = ((base.width >> k).max(1), (base.height >> k).max(1));
            if level.width != width || level.height != height || !is_whole(level) {
                return None;
            }
            texels[k] = &level.texels;
        }
        Some(Pyramid { texels, size: [base.width, base.height], last: levels.len() - 1, wrap })
    }

    /// Bilinear filtering on the two levels around each lane's λ, blended, of groups of lanes.
    ///
    /// # Safety
    /// The processor must have AVX2.
    #[target_feature(enable = "avx2")]
    #[inline]
    pub unsafe fn trilinear(&self, coord: [&[Lanes]; 2], lambda: &[Lanes], rows: &mut [Texels]) {
        for (g, rows) in rows.iter_mut().enumerate() {
            let (s, t, lambda) = (load(&coord[0][g]), load(&coord[1][g]), load(&lambda[g]));
            // Where λ is not above 0, and where it is not a number: the base level. At the last level there is nothing to blend with.
            let minified = _mm256_cmp_ps::<_CMP_GT_OQ>(lambda, _mm256_setzero_ps());
            let floor = _mm256_floor_ps(lambda);
            let last = _mm256_set1_ps(self.last as f32);
            let blended = _mm256_and_ps(minified, _mm256_cmp_ps::<_CMP_LT_OQ>(floor, last));
            let blend = _mm256_and_ps(_mm256_sub_ps(lambda, floor), blended);
            let level = _mm256_cvttps_epi32(_mm256_and_ps(_mm256_min_ps(floor, last), minified));
            let near = Around::new(self.sizes(level), _mm256_setzero_si256(), self.wrap, [s, t]);
            let near_of = indices(level);
            if _mm256_movemask_ps(_mm256_cmp_ps::<_CMP_NEQ_UQ>(blend, _mm256_setzero_ps())) == 0 {
                for (lane, row) in rows.iter_mut().enumerate() {
                    // SAFETY: the lanes' levels are at most the last, and all were checked.
                    unsafe { _mm_storeu_ps(row.as_mut_ptr(), near.filtered(lane, self.texels[near_of[lane] as usize & 31].as_ptr())) };
                }
                continue;
            }
            let level = _mm256_min_epi32(_mm256_add_epi32(level, _mm256_set1_epi32(1)), _mm256_set1_epi32(self.last as i32));
            let far = Around::new(self.sizes(level), _mm256_setzero_si256(), self.wrap, [s, t]);
            let (far_of, blends) = (indices(level), lanes(blend));
            for (lane, row) in rows.iter_mut().enumerate() {
                // SAFETY: as above.
                unsafe {
                    let low = near.filtered(lane, self.texels[near_of[lane] as usize & 31].as_ptr());
                    let high = far.filtered(lane, self.texels[far_of[lane] as usize & 31].as_ptr());
                    _mm_storeu_ps(row.as_mut_ptr(), lerp(low, high, _mm_set1_ps(blends[lane])));
                }
            }
        }
    }

    /// Columns and rows of eight lanes' levels.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn sizes(&self, level: __m256i) -> [__m256i; 2] {
        let one = _mm256_set1_epi32(1);
        let (w, h) = (_mm256_set1_epi32(self.size[0] as i32), _mm256_set1_epi32(self.size[1] as i32));
        [_mm256_max_epi32(_mm256_srlv_epi32(w, level), one), _mm256_max_epi32(_mm256_srlv_epi32(h, level), one)]
    }
}

/// The four texels around each of eight lanes.
struct Around {
    /// Their indices: low and high in x, at the low y, then at the high one.
    at: [Indices; 4],
    /// Weights of the high ones.
    weight: [Lanes; 2],
}

impl Around {
    /// On levels of these sizes; `first` is the row that counts as row 0.
    #[target_feature(enable = "avx2")]
    #[inline]
    fn new([w, h]: [__m256i; 2], first: __m256i, wrap: [Wrap; 2], [s, t]: [__m256; 2]) -> Around {
        let (x0, x1, fx) = linear_axis(s, w, wrap[0]);
        let (y0, y1, fy) = linear_axis(t, h, wrap[1]);
        let low = _mm256_mullo_epi32(_mm256_add_epi32(first, y0), w);
        let high = _mm256_mullo_epi32(_mm256_add_epi32(first, y1), w);
        let at = [_mm256_add_epi32(low, x0), _mm256_add_epi32(low, x1), _mm256_add_epi32(high, x0), _mm256_add_epi32(high, x1)];
        Around { at: [indices(at[0]), indices(at[1]), indices(at[2]), indices(at[3])], weight: [lanes(fx), lanes(fy)] }
    }

    /// A lane's texels, blended: four components side by side, which costs less than to spread eight lanes' words to columns.
    ///
    /// # Safety
    /// `texels` are those of the lane's level, all there. The processor must have AVX2.
    #[target_feature(enable = "avx2")]
    #[inline]
    unsafe fn filtered(&self, lane: usize, texels: *const u32) -> __m128 {
        // SAFETY: the indices were clamped to the level's size.
        let texel = |k: usize| unsafe { components(*texels.add(self.at[k][lane] as usize)) };
        let (x, y) = (_mm_set1_ps(self.weight[0][lane]), _mm_set1_ps(self.weight[1][lane]));
        let value = lerp(lerp(texel(0), texel(1), x), lerp(texel(2), texel(3), x), y);
        _mm_mul_ps(value, _mm_set1_ps(1.0 / 255.0))
    }
}

/// The texel under each lane, or the four around it blended, of groups of lanes. `layers` are the cube faces, none of a flat image.
///
/// # Safety
/// [`serves`] holds, and layers are below the level's depth. The processor must have AVX2.
#[target_feature(enable = "avx2")]
#[inline]
pub unsafe fn sample(
    level: &TextureLevel,
    wrap: [Wrap; 2],
    linear: bool,
    coord: [&[Lanes]; 2],
    layers: &[[i32; LANES]],
    rows: &mut [Texels],
) {
    let (w, h) = (level.width as i32, level.height as i32);
    let size = [_mm256_set1_epi32(w), _mm256_set1_epi32(h)];
    let texels = level.texels.as_ptr();
    let first = |g: usize| match layers.get(g) {
        // SAFETY: eight lanes are 32 bytes.
        Some(layer) => _mm256_mullo_epi32(unsafe { _mm256_loadu_si256(layer.as_ptr().cast()) }, size[1]),
        None => _mm256_setzero_si256(),
    };
    if linear {
        for (g, rows) in rows.iter_mut().enumerate() {
            let around = Around::new(size, first(g), wrap, [load(&coord[0][g]), load(&coord[1][g])]);
            for (lane, row) in rows.iter_mut().enumerate() {
                // SAFETY: the layer is below the depth, and `serves` checked that the texels exist.
                unsafe { _mm_storeu_ps(row.as_mut_ptr(), around.filtered(lane, texels)) };
            }
        }
        return;
    }
    for (g, rows) in rows.iter_mut().enumerate() {
        let y = _mm256_add_epi32(first(g), nearest(load(&coord[1][g]), h, wrap[1]));
        let at = indices(_mm256_add_epi32(_mm256_mullo_epi32(y, size[0]), nearest(load(&coord[0][g]), w, wrap[0])));
        for (lane, row) in rows.iter_mut().enumerate() {
            // SAFETY: as above, and `nearest` stays below the size.
            unsafe {
                let texel = components(*texels.add(at[lane] as usize));
                _mm_storeu_ps(row.as_mut_ptr(), _mm_mul_ps(texel, _mm_set1_ps(1.0 / 255.0)));
            }
        }
    }
}

#[target_feature(enable = "avx2")]
#[inline]
pub fn load(lanes: &Lanes) -> __m256 {
    // SAFETY: eight lanes are 32 bytes.
    unsafe { _mm256_loadu_ps(lanes.as_ptr()) }
}

/// A texel's components, from 0 to 255.
#[target_feature(enable = "avx2")]
#[inline]
fn components(word: u32) -> __m128 {
    _mm_cvtepi32_ps(_mm_cvtepu8_epi32(_mm_cvtsi32_si128(word as i32)))
}

#[target_feature(enable = "avx2")]
#[inline]
fn indices(v: __m256i) -> Indices {
    let mut indices = [0; LANES];
    // SAFETY: eight lanes are 32 bytes.
    unsafe { _mm256_storeu_si256(indices.as_mut_ptr().cast(), v) };
    indices
}

#[target_feature(enable = "avx2")]
#[inline]
fn lanes(v: __m256) -> Lanes {
    let mut lanes = [0.0; LANES];
    // SAFETY: eight lanes are 32 bytes.
    unsafe { _mm256_storeu_ps(lanes.as_mut_ptr(), v) };
    lanes
}

#[target_feature(enable = "avx2")]
#[inline]
fn lerp(a: __m128, b: __m128, t: __m128) -> __m128 {
    _mm_add_ps(a, _mm_mul_ps(t, _mm_sub_ps(b, a)))
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

/// The texel below a coordinate, as a number, and the weight of the next one. With [`Wrap::Repeat`] it may be -1.
#[target_feature(enable = "avx2")]
#[inline]
pub fn point(c: __m256, n: __m256, wrap: Wrap) -> (__m256, __m256) {
    let half = _mm256_set1_ps(0.5);
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
    (floor, _mm256_sub_ps(u, floor))
}

/// Indices of the two texels around a coordinate, and the weight of the second.
#[target_feature(enable = "avx2")]
#[inline]
fn linear_axis(c: __m256, size: __m256i, wrap: Wrap) -> (__m256i, __m256i, __m256) {
    let n = _mm256_cvtepi32_ps(size);
    let last = _mm256_sub_epi32(size, _mm256_set1_epi32(1));
    let most = _mm256_cvtepi32_ps(last);
    let (first, weight) = point(c, n, wrap);
    let second = _mm256_add_ps(first, _mm256_set1_ps(1.0));
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
