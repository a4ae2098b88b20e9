//! The pixel work of glBlitFramebuffer: rectangles of one view copied to another, flipped, scaled, resolved.

use super::framebuffer::put_color;
use crate::device::{ColorFormat, samples};
use crate::raster::formats::unpack;

/// Rows of words, sample by sample: sample s of pixel (x, y) begins at `((s * height + y) * width + x) * words`.
pub(crate) struct View<T> {
    pub width: usize,
    pub height: usize,
    pub samples: usize,
    /// Words of a sample.
    pub words: usize,
    pub rows: T,
}

impl<T> View<T> {
    fn index(&self, sample: usize, x: usize, y: usize) -> usize {
        ((sample * self.height + y) * self.width + x) * self.words
    }
}

/// Two corners as glBlitFramebuffer takes them: x0, y0, x1, y1.
pub(crate) type Corners = [i32; 4];

/// What happens to the samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Work {
    /// Colours of this format: filtered, averaged.
    Color { from: ColorFormat, to: ColorFormat, linear: bool },
    /// Words, of which the bits of the mask are copied as they are.
    Words { mask: u32 },
}

/// The source coordinate at the centre of a pixel, along one axis; outside of the source nothing is copied.
struct Axis {
    first: i32,
    end: i32,
    /// `source = offset + (pixel + 1/2) * scale`
    offset: f64,
    scale: f64,
}

impl Axis {
    /// The pixels from `to[0]` to `to[1]` (in either order) that lie in `clip`, and where they come from.
    fn new(from: [i32; 2], to: [i32; 2], clip: [i32; 2]) -> Axis {
        let (low, high) = (to[0].min(to[1]), to[0].max(to[1]));
        let scale = (f64::from(from[1]) - f64::from(from[0])) / (f64::from(to[1]) - f64::from(to[0]));
        let offset = f64::from(from[0]) - f64::from(to[0]) * scale;
        let (first, end) = (low.max(clip[0]), high.min(clip[1]));
        Axis { first, end: end.max(first), offset, scale }
    }

    fn source(&self, pixel: i32) -> f64 {
        self.offset + (f64::from(pixel) + 0.5) * self.scale
    }

    /// Pixels whose source lies within `size`, with the source's index for each.
    fn nearest(&self, size: usize) -> Vec<(usize, usize)> {
        let inside = |pixel: i32| {
            let at = self.source(pixel).floor();
            (at >= 0.0 && at < size as f64).then_some((pixel as usize, at as usize))
        };
        (self.first..self.end).filter_map(inside).collect()
    }

    /// The same for linear filtering: two indices, clamped to the source, and the weight of the second.
    fn linear(&self, size: usize) -> Vec<(usize, [usize; 2], f32)> {
        let inside = |pixel: i32| {
            let at = self.source(pixel);
            if !(at >= 0.0 && at < size as f64) {
                return None;
            }
            let (at, last) = (at - 0.5, size as f64 - 1.0);
            let indices = [at.floor(), at.floor() + 1.0].map(|i| i.clamp(0.0, last) as usize);
            Some((pixel as usize, indices, (at - at.floor()) as f32))
        };
        (self.first..self.end).filter_map(inside).collect()
    }
}

/// Copies `from`'s rectangle to `to`'s. `clip`: the columns and rows of the destination that may change (x0, y0, x1, y1), inside of
/// it; `mask`: the colour components that do (bits 0 to 3: RGBA). With several samples on both sides samples are copied one by one;
/// with several in the source alone a colour becomes their mean, anything else the first.
pub(crate) fn blit(from: &View<&[u32]>, to: &mut View<&mut [u32]>, source: Corners, target: Corners, clip: Corners, work: Work, mask: u32) {
    let [x, y] = [0, 1].map(|k| Axis::new([source[k], source[k + 2]], [target[k], target[k + 2]], [clip[k], clip[k + 2]]));
    if source[0] == source[2] || source[1] == source[3] || target[0] == target[2] || target[1] == target[3] {
        return;
    }
    match work {
        Work::Color { from: format, to: format_to, linear: true } if from.samples == 1 => {
            let columns = x.linear(from.width);
            for (row, [y0, y1], t) in y.linear(from.height) {
                for &(column, [x0, x1], s) in &columns {
                    let read = |x, y| unpack(format, &from.rows[from.index(0, x, y)..]);
                    let mix = |a: [f32; 4], b: [f32; 4], t: f32| -> [f32; 4] { std::array::from_fn(|k| a[k] + (b[k] - a[k]) * t) };
                    let color = mix(mix(read(x0, y0), read(x1, y0), s), mix(read(x0, y1), read(x1, y1), s), t);
                    for sample in 0..to.samples {
                        let at = to.index(sample, column, row);
                        put_color(format_to, &mut to.rows[at..], color, mask);
                    }
                }
            }
        }
        _ => {
            let columns = x.nearest(from.width);
            let run = straight(&columns);
            let mut mean = vec![0; from.words];
            for (row, from_row) in y.nearest(from.height) {
                // Whole rows, where nothing is scaled, flipped or converted.
                match (run, work) {
                    (Some([to_first, from_first, count]), Work::Color { from: a, to: b, .. }) if a == b && mask == 15 => {
                        if from.samples > 1 && to.samples == 1 && a.is_bytes() {
                            let first = |s| from.index(s, from_first, from_row);
                            let all: Vec<&[u32]> = (0..from.samples).map(|s| &from.rows[first(s)..first(s) + count]).collect();
                            let at = to.index(0, to_first, row);
                            samples::means_of_bytes(&all, &mut to.rows[at..at + count]);
                            continue;
                        }
                        if from.samples == 1 || from.samples == to.samples {
                            for sample in 0..to.samples {
                                let (at, words) = (to.index(sample, to_first, row), count * to.words);
                                let first = from.index(sample.min(from.samples - 1), from_first, from_row);
                                to.rows[at..at + words].copy_from_slice(&from.rows[first..first + words]);
                            }
                            continue;
                        }
                    }
                    _ => {}
                }
                for &(column, from_column) in &columns {
                    let resolves = from.samples > 1 && to.samples == 1 && matches!(work, Work::Color { .. });
                    if let (true, Work::Color { from: format, .. }) = (resolves, work) {
                        let all: Vec<&[u32]> = (0..from.samples).map(|s| &from.rows[from.index(s, from_column, from_row)..]).collect();
                        samples::mean(format, &all, &mut mean);
                    }
                    for sample in 0..to.samples {
                        let other = if from.samples > 1 { sample } else { 0 };
                        let pixel = if resolves { &mean[..] } else { &from.rows[from.index(other, from_column, from_row)..] };
                        let at = to.index(sample, column, row);
                        copy(pixel, &mut to.rows[at..], work, mask);
                    }
                }
            }
        }
    }
}

/// First pixel, first source pixel and their number, where pixels and sources run side by side.
fn straight(columns: &[(usize, usize)]) -> Option<[usize; 3]> {
    let &(first, from) = columns.first()?;
    let side_by_side = columns.iter().enumerate().all(|(k, &at)| at == (first + k, from + k));
    side_by_side.then_some([first, from, columns.len()])
}

/// One sample.
fn copy(from: &[u32], to: &mut [u32], work: Work, mask: u32) {
    match work {
        Work::Words { mask } => to[0] = to[0] & !mask | from[0] & mask,
        Work::Color { from: a, to: b, .. } if a == b && mask == 15 => to[..a.words()].copy_from_slice(&from[..a.words()]),
        Work::Color { from: a, to: b, .. } => put_color(b, to, unpack(a, from), mask),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const NEAREST: Work = Work::Color { from: ColorFormat::Rgba8, to: ColorFormat::Rgba8, linear: false };
    const LINEAR: Work = Work::Color { from: ColorFormat::Rgba8, to: ColorFormat::Rgba8, linear: true };

    /// Blits a source of so many columns into zeros, and returns those.
    fn run(from: &[u32], width: usize, source: Corners, size: [usize; 2], target: Corners, clip: Option<Corners>, work: Work) -> Vec<u32> {
        let mut out = vec![0; size[0] * size[1]];
        let from = View { width, height: from.len() / width, samples: 1, words: 1, rows: from };
        let mut to = View { width: size[0], height: size[1], samples: 1, words: 1, rows: &mut out[..] };
        let clip = clip.unwrap_or([0, 0, size[0] as i32, size[1] as i32]);
        blit(&from, &mut to, source, target, clip, work, 15);
        out
    }

    #[test]
    fn equal_rectangles_are_copied() {
        assert_eq!(run(&[1, 2, 3, 4], 2, [0, 0, 2, 2], [3, 2], [1, 0, 3, 2], None, NEAREST), [0, 1, 2, 0, 3, 4]);
    }

    #[test]
    fn either_rectangle_may_be_flipped_on_either_axis() {
        let from = [1, 2, 3, 4];
        assert_eq!(run(&from, 2, [2, 0, 0, 2], [2, 2], [0, 0, 2, 2], None, NEAREST), [2, 1, 4, 3]);
        assert_eq!(run(&from, 2, [0, 0, 2, 2], [2, 2], [0, 2, 2, 0], None, NEAREST), [3, 4, 1, 2]);
        assert_eq!(run(&from, 2, [2, 2, 0, 0], [2, 2], [2, 2, 0, 0], None, NEAREST), from);
    }

    #[test]
    fn nearest_repeats_and_drops() {
        assert_eq!(run(&[1, 2], 2, [0, 0, 2, 1], [4, 1], [0, 0, 4, 1], None, NEAREST), [1, 1, 2, 2]);
        assert_eq!(run(&[1, 2, 3, 4], 4, [0, 0, 4, 1], [2, 1], [0, 0, 2, 1], None, NEAREST), [2, 4]);
        assert_eq!(run(&[1, 2, 3, 4], 4, [4, 0, 0, 1], [2, 1], [0, 0, 2, 1], None, NEAREST), [4, 2]);
    }

    #[test]
    fn what_lies_outside_of_the_source_is_not_written() {
        assert_eq!(run(&[1, 2], 2, [-1, 0, 3, 1], [4, 1], [0, 0, 4, 1], None, NEAREST), [0, 1, 2, 0]);
        // With scaling, the pixels inside come from where they would come from anyway.
        assert_eq!(run(&[1, 2], 2, [-2, 0, 2, 1], [8, 1], [0, 0, 8, 1], None, NEAREST), [0, 0, 0, 0, 1, 1, 2, 2]);
        assert_eq!(run(&[1, 2], 2, [5, 0, 9, 1], [4, 1], [0, 0, 4, 1], None, NEAREST), [0; 4]);
    }

    #[test]
    fn the_clip_cuts_and_does_not_move() {
        assert_eq!(run(&[1, 2, 3, 4], 4, [0, 0, 4, 1], [4, 1], [0, 0, 4, 1], Some([1, 0, 3, 1]), NEAREST), [0, 2, 3, 0]);
        assert_eq!(run(&[1, 2, 3, 4], 4, [0, 0, 4, 1], [2, 1], [-2, 0, 2, 1], None, NEAREST), [3, 4]);
        let far = [i32::MIN, i32::MIN, i32::MAX, i32::MAX];
        assert_eq!(run(&[1, 2, 3, 4], 2, far, [2, 2], far, None, NEAREST), [1, 2, 3, 4]);
    }

    #[test]
    fn linear_filters_between_centres_and_clamps_at_the_edge() {
        assert_eq!(run(&[0, 200], 2, [0, 0, 2, 1], [4, 1], [0, 0, 4, 1], None, LINEAR), [0, 50, 150, 200]);
        assert_eq!(run(&[0, 100, 200, 100], 2, [0, 0, 2, 2], [1, 1], [0, 0, 1, 1], None, LINEAR), [100]);
    }

    #[test]
    fn empty_rectangles_do_nothing() {
        assert_eq!(run(&[1], 1, [0, 0, 0, 1], [1, 1], [0, 0, 1, 1], None, NEAREST), [0]);
        assert_eq!(run(&[1], 1, [0, 0, 1, 1], [1, 1], [1, 0, 1, 1], None, LINEAR), [0]);
    }

    fn samples(from: &[u32], from_samples: usize, to_samples: usize, work: Work) -> Vec<u32> {
        let pixels = from.len() / from_samples;
        let mut out = vec![0; pixels * to_samples];
        let from = View { width: pixels, height: 1, samples: from_samples, words: 1, rows: from };
        let mut to = View { width: pixels, height: 1, samples: to_samples, words: 1, rows: &mut out[..] };
        let all = [0, 0, pixels as i32, 1];
        blit(&from, &mut to, all, all, all, work, 15);
        out
    }

    #[test]
    fn samples_resolve_to_their_mean_or_the_first() {
        // Two pixels of four samples.
        let from = [10, 1, 20, 1, 30, 1, 41, 1];
        assert_eq!(samples(&from, 4, 1, NEAREST), [25, 1]);
        assert_eq!(samples(&from, 4, 1, LINEAR), [25, 1]);
        assert_eq!(samples(&from, 4, 1, Work::Words { mask: !0 }), [10, 1]);
    }

    #[test]
    fn samples_are_copied_one_by_one_and_single_ones_spread() {
        assert_eq!(samples(&[1, 2, 3, 4], 2, 2, NEAREST), [1, 2, 3, 4]);
        assert_eq!(samples(&[1, 2], 1, 2, NEAREST), [1, 2, 1, 2]);
    }

    #[test]
    fn depth_and_stencil_are_parts_of_a_word() {
        assert_eq!(samples(&[0x1234_5678], 1, 1, Work::Words { mask: 0xff_ffff }), [0x34_5678]);
        assert_eq!(samples(&[0x1234_5678], 1, 1, Work::Words { mask: 0xff00_0000 }), [0x1200_0000]);
    }

    #[test]
    fn formats_are_converted_and_masked() {
        let mut out = [0, 0xffff_0000];
        let from = View { width: 1, height: 1, samples: 1, words: 1, rows: &[0x8040_20ff][..] };
        let mut to = View { width: 1, height: 1, samples: 1, words: 2, rows: &mut out[..] };
        let work = Work::Color { from: ColorFormat::Rgba8, to: ColorFormat::Rgba16, linear: false };
        blit(&from, &mut to, [0, 0, 1, 1], [0, 0, 1, 1], [0, 0, 1, 1], work, 0b0111);
        assert_eq!(out, [0x2020_ffff, 0xffff_4040]);
    }
}
