//! Texels unpacked for bilinear filtering, where an image is small and used again: a filter's four texels lie in one cache line, as
//! numbers, and what is subtracted in every filter is subtracted once. The same operations in the same order as those of
//! [`super::texture_wide`], so the same bits.

use super::texture::wrap_modes;
#[cfg(target_arch = "x86_64")]
use super::texture::{Lanes, Texels};
#[cfg(target_arch = "x86_64")]
use super::texture_wide::{load, point};
use crate::draw::texture::{Sampler, TexelFormat, TextureImage, TextureKind, TextureLevel, Wrap};
#[cfg(target_arch = "x86_64")]
use crate::program::lanes::LANES;

/// Four texels with components from 0 to 255: of the low row and then of the high one the left texel, and what the right one is more.
#[repr(C, align(64))]
struct Cell([[f32; 4]; 4]);

/// The cells of a level. Column and row k lie between texels k - 1 and k, around the edges of the image: modes that clamp give the
/// texel beyond an edge no weight.
pub struct Cells {
    /// Columns and rows of texels.
    size: [u32; 2],
    cells: Vec<Cell>,
}

/// Most texels of a level that is unpacked, of 64 bytes each: 128 x 128.
const LARGEST: u32 = 1 << 14;

impl Cells {
    /// Of a flat level of RGBA8; `None` where it is too large.
    pub fn new(level: &TextureLevel) -> Option<Cells> {
        let (w, h) = (level.width, level.height);
        let texels = w.checked_mul(h).filter(|n| (1..=LARGEST).contains(n) && level.depth == 1)? as usize;
        let row = |y: u32| &level.texels[(y * w) as usize..][..w as usize];
        let unpack = |word: u32| word.to_le_bytes().map(f32::from);
        let pair = |row: &[u32], x: u32| {
            let (left, right) = (unpack(row[((x + w - 1) % w) as usize]), unpack(row[(x % w) as usize]));
            [left, [0, 1, 2, 3].map(|c| right[c] - left[c])]
        };
        if level.texels.len() < texels {
            return None;
        }
        let cell = |x: u32, y: u32| {
            let [low, high] = [row((y + h - 1) % h), row(y % h)].map(|row| pair(row, x));
            Cell([low[0], low[1], high[0], high[1]])
        };
        let cells = (0..=h).flat_map(|y| (0..=w).map(move |x| (x, y))).map(|(x, y)| cell(x, y)).collect();
        Some(Cells { size: [w, h], cells })
    }

    /// Bytes that it takes.
    pub fn bytes(&self) -> usize {
        size_of_val(&self.cells[..])
    }
}

/// Whether a flat image is filtered linearly on one level, by wrap modes that stay inside, of texels that can be unpacked.
pub fn serves(image: &TextureImage, sampler: &Sampler) -> bool {
    image.format == TexelFormat::Rgba8
        && matches!(image.kind, TextureKind::D1 | TextureKind::D2)
        && (sampler.mag_linear && sampler.min_linear && sampler.mip_linear.is_none())
        && !wrap_modes(image, sampler).iter().any(|w| matches!(w, Wrap::Clamp | Wrap::ClampToBorder))
}

/// Groups of lanes that are filtered together.
#[cfg(target_arch = "x86_64")]
const GROUPS: usize = 16;

#[cfg(target_arch = "x86_64")]
impl Cells {
    /// Bilinear filtering of groups of lanes, with wrap modes that [`serves`] names.
    ///
    /// # Safety
    /// The processor must have AVX2.
    #[target_feature(enable = "avx2")]
    #[inline]
    pub unsafe fn filter(&self, wrap: [Wrap; 2], coord: [&[Lanes]; 2], rows: &mut [Texels]) {
        let rows = rows.chunks_mut(GROUPS);
        for ((s, t), rows) in coord[0].chunks(GROUPS).zip(coord[1].chunks(GROUPS)).zip(rows) {
            // SAFETY: the processor has AVX2.
            unsafe { self.filter_some(wrap, [s, t], rows) };
        }
    }

    /// The same of at most [`GROUPS`]. All places first: what waits for them would hold up the next ones.
    #[target_feature(enable = "avx2")]
    #[inline]
    unsafe fn filter_some(&self, wrap: [Wrap; 2], coord: [&[Lanes]; 2], rows: &mut [Texels]) {
        use std::arch::x86_64::*;
        use std::mem::MaybeUninit;
        let [w, h] = self.size.map(|n| _mm256_set1_ps(n as f32));
        let pitch = self.size[0] as usize + 1;
        let (first, step) = (_mm256_set1_ps(-1.0), _mm256_set1_ps(pitch as f32));
        // Written below for as many groups as are read.
        let mut at = [MaybeUninit::<[i32; LANES]>::uninit(); GROUPS];
        let mut weights = [MaybeUninit::<[Lanes; 2]>::uninit(); GROUPS];
        for ((s, t), (at, weights)) in coord[0].iter().zip(coord[1]).take(rows.len()).zip(at.iter_mut().zip(&mut weights)) {
            let (x, fx) = point(load(s), w, wrap[0]);
            let (y, fy) = point(load(t), h, wrap[1]);
            // From -1 to the last texel, as the wrap modes leave it; a number that is none becomes -1, and its weight stays. Whole
            // numbers below 2^24: their sum is exact.
            let cell = _mm256_add_ps(_mm256_mul_ps(_mm256_max_ps(y, first), step), _mm256_max_ps(x, first));
            // SAFETY: eight lanes are 32 bytes.
            unsafe {
                _mm256_storeu_si256(at.as_mut_ptr().cast(), _mm256_cvttps_epi32(cell));
                _mm256_storeu_ps(weights.as_mut_ptr().cast(), fx);
                _mm256_storeu_ps(weights.as_mut_ptr().cast::<f32>().add(LANES), fy);
            }
        }
        // The cell of column 0 and row 0 of texels; a row and a column of cells lie before it.
        // SAFETY: there are more than so many cells.
        let origin = unsafe { self.cells.as_ptr().add(pitch + 1) };
        let scale = _mm_set1_ps(1.0 / 255.0);
        for (rows, (at, weights)) in rows.iter_mut().zip(at.iter().zip(&weights)) {
            // SAFETY: the groups were written.
            let (at, [fx, fy]) = unsafe { (at.assume_init_ref(), weights.assume_init_ref()) };
            for (lane, row) in rows.iter_mut().enumerate() {
                // SAFETY: column and row are at least -1 and less than the image's, and there are cells for all of these; a cell is 64
                // bytes on a boundary of so many.
                unsafe {
                    let cell = origin.offset(at[lane] as isize).cast::<f32>();
                    let (fx, fy) = (_mm_set1_ps(fx[lane]), _mm_set1_ps(fy[lane]));
                    let low = _mm_add_ps(_mm_load_ps(cell), _mm_mul_ps(fx, _mm_load_ps(cell.add(4))));
                    let high = _mm_add_ps(_mm_load_ps(cell.add(8)), _mm_mul_ps(fx, _mm_load_ps(cell.add(12))));
                    let value = _mm_add_ps(low, _mm_mul_ps(fy, _mm_sub_ps(high, low)));
                    _mm_storeu_ps(row.as_mut_ptr(), _mm_mul_ps(value, scale));
                }
            }
        }
    }
}
