//! Where samples lie in a pixel, and how many make one.

use super::ColorFormat;

/// Most samples a pixel (GL_MAX_SAMPLES).
pub const MAX_SAMPLES: u32 = 16;

/// Offsets of the samples from the pixel's centre, in 1/16 pixel, x and y with the rows of the surface: the standard positions of Direct3D.
#[inline]
pub const fn positions(samples: u32) -> &'static [[i32; 2]] {
    match samples {
        2 => &[[4, 4], [-4, -4]],
        4 => &[[-2, -6], [6, -2], [-6, 2], [2, 6]],
        8 => &[[1, -3], [-1, 3], [5, 1], [-3, -5], [-5, 5], [-7, -1], [3, 7], [7, -7]],
        16 => &[
            [1, 1],
            [-1, -3],
            [-3, 2],
            [4, -1],
            [-5, -2],
            [2, 5],
            [5, 3],
            [3, -5],
            [-2, 6],
            [0, -7],
            [-4, -6],
            [-6, 4],
            [-8, 0],
            [7, -4],
            [6, 7],
            [-7, -8],
        ],
        _ => &[[0, 0]],
    }
}

/// The number of samples that serves a wish for at least so many: 1, 2, 4, 8 or 16; `None` beyond.
pub fn supported(wish: u32) -> Option<u32> {
    (wish <= MAX_SAMPLES).then(|| wish.max(1).next_power_of_two())
}

/// A pixel's colour from its samples: their mean, rounded to nearest, halves up. `samples` and `out` hold as many words as the format has.
pub fn mean(format: ColorFormat, samples: &[&[u32]], out: &mut [u32]) {
    let n = samples.len() as u32;
    let fields = |word: usize, shifts: &[(u32, u32)]| {
        shifts.iter().fold(0, |all, &(shift, bits)| {
            let sum: u32 = samples.iter().map(|s| s[word] >> shift & ((1 << bits) - 1)).sum();
            all | ((sum + n / 2) / n) << shift
        })
    };
    match format {
        ColorFormat::Rgba8 | ColorFormat::Rgbx8 => out[0] = fields(0, &[(0, 8), (8, 8), (16, 8), (24, 8)]),
        ColorFormat::Rgb565 => out[0] = fields(0, &[(0, 5), (5, 6), (11, 5)]),
        ColorFormat::Rgba16 => (0..2).for_each(|k| out[k] = fields(k, &[(0, 16), (16, 16)])),
        ColorFormat::Rgba32f => {
            for (k, out) in out.iter_mut().enumerate() {
                let sum: f32 = samples.iter().map(|s| f32::from_bits(s[k])).sum();
                *out = (sum / n as f32).to_bits();
            }
        }
    }
}

/// The same of many pixels of four bytes, a slice a sample (2, 4, 8 or 16 of them), two bytes at a time: 16 bits hold the sum of 16 samples.
pub fn means_of_bytes(samples: &[&[u32]], out: &mut [u32]) {
    let (low, shift) = (0x00ff_00ff, samples.len().ilog2());
    let half = (samples.len() as u32 / 2) * 0x0001_0001;
    for (block, out) in out.chunks_mut(64).enumerate() {
        let (mut even, mut odd) = ([half; 64], [half; 64]);
        for sample in samples {
            for (k, word) in sample[block * 64..][..out.len()].iter().enumerate() {
                even[k] += word & low;
                odd[k] += word >> 8 & low;
            }
        }
        for (k, out) in out.iter_mut().enumerate() {
            *out = even[k] >> shift & low | (odd[k] >> shift & low) << 8;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn positions_are_distinct_and_have_the_standard_sums() {
        for samples in [1, 2, 4, 8, 16] {
            let all = positions(samples);
            assert_eq!(all.len(), samples as usize);
            let mut sorted = all.to_vec();
            sorted.sort();
            sorted.dedup();
            assert_eq!(sorted.len(), all.len());
            // Every column and every row of the grid holds at most one sample.
            for axis in 0..2 {
                let mut places: Vec<_> = all.iter().map(|p| p[axis]).collect();
                places.sort();
                places.dedup();
                assert_eq!(places.len(), all.len());
            }
        }
    }

    #[test]
    fn wishes_are_rounded_up() {
        assert_eq!([0, 1, 2, 3, 5, 9, 16].map(supported), [1, 1, 2, 4, 8, 16, 16].map(Some));
        assert_eq!(supported(17), None);
    }

    #[test]
    fn both_ways_to_average_agree() {
        for count in [2, 4, 8, 16] {
            let planes: Vec<Vec<u32>> = (0..count).map(|s| (0..100u32).map(|k| (k * 16 + s).wrapping_mul(0x9e37_79b9)).collect()).collect();
            let slices: Vec<&[u32]> = planes.iter().map(|p| &p[..]).collect();
            let mut out = [0; 100];
            means_of_bytes(&slices, &mut out);
            for (k, &out) in out.iter().enumerate() {
                let pixel: Vec<&[u32]> = slices.iter().map(|p| &p[k..k + 1]).collect();
                let mut one = [0];
                mean(ColorFormat::Rgba8, &pixel, &mut one);
                assert_eq!(out, one[0]);
            }
        }
    }

    #[test]
    fn means_round_to_nearest() {
        let mut out = [0];
        mean(ColorFormat::Rgba8, &[&[0xff00_0001], &[0xff00_0002]], &mut out);
        assert_eq!(out, [0xff00_0002]);
        mean(ColorFormat::Rgb565, &[&[31], &[0], &[31 << 11], &[63 << 5]], &mut out);
        assert_eq!(out, [8 | 16 << 5 | 8 << 11]);
    }
}
