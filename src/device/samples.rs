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

/// A pixel's colour from its samples: their mean, rounded to nearest. Halves go up; in eight bits they go where OSMesa's sum of components
/// from 0 to 1 in single precision takes them. `samples` and `out` hold as many words as the format has.
pub fn mean(format: ColorFormat, samples: &[&[u32]], out: &mut [u32]) {
    let n = samples.len() as u32;
    let fields = |word: usize, shifts: &[(u32, u32)]| {
        shifts.iter().fold(0, |all, &(shift, bits)| {
            let sum: u32 = samples.iter().map(|s| s[word] >> shift & ((1 << bits) - 1)).sum();
            all | ((sum + n / 2) / n) << shift
        })
    };
    match format {
        ColorFormat::Rgba8 | ColorFormat::Rgbx8 => mean_bytes(samples.iter().map(|s| &s[..1]), &mut out[..1]),
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

/// Pixels of a block.
const BLOCK: usize = 64;

/// The same of at most [`BLOCK`] pixels of four bytes, in single precision.
fn mean_bytes<'a>(samples: impl ExactSizeIterator<Item = &'a [u32]>, out: &mut [u32]) {
    /// Sums with it have their integer in the low bits, rounded to nearest even.
    const MAGIC: f32 = (1 << 23) as f32;
    let share = 1.0 / samples.len() as f32;
    let mut sums = [[0.0f32; BLOCK]; 4];
    for sample in samples {
        for (c, sums) in sums.iter_mut().enumerate() {
            for (sum, word) in sums.iter_mut().zip(sample) {
                *sum += (word >> (8 * c) & 255) as i32 as f32 * (1.0 / 255.0);
            }
        }
    }
    let byte = |sum: f32| (sum * share * 255.0 + MAGIC).to_bits() & 255;
    for (k, out) in out.iter_mut().enumerate() {
        *out = byte(sums[0][k]) | byte(sums[1][k]) << 8 | byte(sums[2][k]) << 16 | byte(sums[3][k]) << 24;
    }
}

/// The same of many pixels of four bytes, a slice a sample (2, 4, 8 or 16 of them), two bytes at a time: 16 bits hold the sum of 16 samples.
/// Only where there are halves the order of sums matters.
pub fn means_of_bytes(samples: &[&[u32]], out: &mut [u32]) {
    const ONES: u32 = 0x0001_0001;
    let (low, shift) = (0x00ff_00ff, samples.len().ilog2());
    let half = (samples.len() as u32 / 2) * ONES;
    let rest = (samples.len() as u32 - 1) * ONES;
    // Not zero where the remainder of either half of a word is zero, or perhaps where only its upper neighbour's is.
    let is_half = |sum: u32| (sum & rest).wrapping_sub(ONES) & !(sum & rest) & 0x8000_8000;
    for (block, out) in out.chunks_mut(BLOCK).enumerate() {
        let (mut even, mut odd) = ([half; BLOCK], [half; BLOCK]);
        for sample in samples {
            for (k, word) in sample[block * BLOCK..][..out.len()].iter().enumerate() {
                even[k] += word & low;
                odd[k] += word >> 8 & low;
            }
        }
        let mut halves = 0;
        for (k, out) in out.iter_mut().enumerate() {
            halves |= is_half(even[k]) | is_half(odd[k]);
            *out = even[k] >> shift & low | (odd[k] >> shift & low) << 8;
        }
        if halves != 0 {
            let count = out.len();
            mean_bytes(samples.iter().map(|sample| &sample[block * BLOCK..][..count]), out);
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
    fn halves_go_where_osmesa_takes_them() {
        // Of OSMesa of Mesa 22.3: four samples, and what they become.
        let cases = [
            [14, 144, 72, 236, 117],
            [171, 153, 142, 248, 179],
            [38, 174, 84, 74, 92],
            [135, 86, 35, 178, 108],
            [35, 207, 180, 84, 126],
            [71, 108, 138, 81, 100],
        ];
        for [a, b, c, d, want] in cases {
            let mut out = [0];
            mean(ColorFormat::Rgba8, &[&[a], &[b], &[c], &[d]], &mut out);
            assert_eq!(out, [want], "{a} {b} {c} {d}");
        }
    }

    #[test]
    fn means_round_to_nearest() {
        let mut out = [0];
        for sum in 0..=1020u32 {
            let all = [0, 1, 2, 3].map(|k| (sum + k) / 4);
            mean(ColorFormat::Rgba8, &all.each_ref().map(std::slice::from_ref), &mut out);
            assert!((4 * out[0]).abs_diff(sum) <= 2, "{sum}");
        }
        mean(ColorFormat::Rgb565, &[&[31], &[0], &[31 << 11], &[63 << 5]], &mut out);
        assert_eq!(out, [8 | 16 << 5 | 8 << 11]);
    }
}
