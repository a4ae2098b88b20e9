//! Clears of rectangles, done by bins in the order of the batch.

use super::blend::mask_bits;
use super::formats;
use super::layout::BIN_SIZE;
use super::store::{BIN_PIXELS, BinPixels, pixel_index};
use crate::device::{DepthFormat, SurfaceFormat};
use crate::draw::Clear;

/// The part of a clear that lies in a bin. Returns whether that is all of it.
pub fn run(clear: &Clear, format: SurfaceFormat, bin: &mut BinPixels) -> bool {
    let side = BIN_SIZE as i32;
    let span = |k: usize| (clear.min[k] - bin.origin[k]).clamp(0, side)..(clear.max[k] - bin.origin[k]).clamp(0, side);
    let (columns, rows) = (span(0), span(1));
    if columns.is_empty() || rows.is_empty() {
        return false;
    }
    let whole = columns.len() == side as usize && rows.len() == side as usize;
    // Calls f for each run of pixels that are neighbours in the store.
    let samples = format.samples as usize;
    let runs = |f: &mut dyn FnMut(std::ops::Range<usize>)| {
        if whole {
            return f(0..samples * BIN_PIXELS);
        }
        for (sample, y) in (0..samples).flat_map(|s| rows.clone().map(move |y| (s, y))) {
            let mut x = columns.start;
            while x < columns.end {
                let end = (x / 8 * 8 + 8).min(columns.end);
                let at = sample * BIN_PIXELS + pixel_index(x as u32, y as u32);
                f(at..at + (end - x) as usize);
                x = end;
            }
        }
    };
    if clear.color_mask & 15 != 0 {
        let words = format.color.words();
        let (mut value, mut mask) = ([0; 4], [0; 4]);
        formats::pack(format.color, clear.color, &mut value[..words]);
        formats::mask(format.color, mask_bits(clear.color_mask), &mut mask[..words]);
        let color = &mut *bin.color;
        runs(&mut |range| {
            let range = range.start * words..range.end * words;
            if words == 1 && mask[0] == !0 {
                color[range].fill(value[0]);
            } else {
                for (k, word) in color[range].iter_mut().enumerate() {
                    *word = value[k % words] & mask[k % words] | *word & !mask[k % words];
                }
            }
        });
    }
    let (mut value, mut mask) = (0, 0);
    if let (Some(depth), true) = (clear.depth, format.depth != DepthFormat::None) {
        value |= format.depth.word(depth);
        mask |= format.depth.mask();
    }
    if let (Some((stencil, writes)), true) = (clear.stencil, format.stencil) {
        value |= ((stencil & writes) as u32) << 24;
        mask |= (writes as u32) << 24;
    }
    if mask != 0 {
        let words = &mut *bin.depth_stencil;
        let all = mask == !0 || mask == 0xff_ffff && !format.stencil;
        runs(&mut |range| {
            if all {
                words[range].fill(value);
            } else {
                words[range].iter_mut().for_each(|w| *w = value | *w & !mask);
            }
        });
    }
    whole
}
