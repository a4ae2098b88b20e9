//! Reading and writing the mapped pixels of a surface, in GL's coordinates (row 0 at the bottom).

use super::pixel_format::{Groups, widen};
use super::texture_format::to_rgba8;
use crate::device::{ColorFormat, DepthFormat, Pixels};

/// A rectangle of pixels: first column and row, one past the last ones.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Rect {
    pub min: [i32; 2],
    pub max: [i32; 2],
}

impl Rect {
    /// From a corner and a size, without overflow.
    pub fn new(x: i32, y: i32, width: i32, height: i32) -> Rect {
        Rect { min: [x, y], max: [x.saturating_add(width.max(0)), y.saturating_add(height.max(0))] }
    }

    /// The part of it that another one has too; empty ones have a size of zero.
    pub fn and(self, other: Rect) -> Rect {
        let min = [self.min[0].max(other.min[0]), self.min[1].max(other.min[1])];
        let max = [self.max[0].min(other.max[0]).max(min[0]), self.max[1].min(other.max[1]).max(min[1])];
        Rect { min, max }
    }

    pub fn width(self) -> usize {
        (self.max[0] - self.min[0]).max(0) as usize
    }

    pub fn height(self) -> usize {
        (self.max[1] - self.min[1]).max(0) as usize
    }

    pub fn is_empty(self) -> bool {
        self.width() == 0 || self.height() == 0
    }
}

/// The whole surface.
pub(crate) fn bounds(pixels: &Pixels) -> Rect {
    Rect { min: [0, 0], max: [pixels.width as i32, pixels.height as i32] }
}

/// Index of the first pixel of a rectangle's row; `y` counts from GL's bottom. Inside the surface.
pub(crate) fn pixel_index(pixels: &Pixels, x: i32, y: i32) -> usize {
    let row = if pixels.format.top_first { pixels.height as i32 - 1 - y } else { y };
    row as usize * pixels.width as usize + x as usize
}

fn rows(pixels: &Pixels, rect: Rect, mut f: impl FnMut(usize)) {
    // A rectangle that is empty in x only still counts rows.
    let last = if rect.is_empty() { rect.min[1] } else { rect.max[1] };
    for y in rect.min[1]..last {
        f(pixel_index(pixels, rect.min[0], y));
    }
}

/// Colours of a rectangle inside the surface, bottom row first.
pub(crate) fn read_color(pixels: &Pixels, rect: Rect) -> Groups {
    let (width, count) = (rect.width(), rect.width() * rect.height());
    let words = pixels.format.color.words();
    let mut small = Vec::new();
    let mut large = Vec::new();
    match pixels.format.color {
        ColorFormat::Rgba8 | ColorFormat::Rgbx8 | ColorFormat::Rgb565 => small.reserve(count),
        _ => large.reserve(count),
    }
    rows(pixels, rect, |first| {
        let row = &pixels.color[first * words..(first + width) * words];
        match pixels.format.color {
            ColorFormat::Rgba8 => small.extend_from_slice(row),
            ColorFormat::Rgbx8 => small.extend(row.iter().map(|p| p | 0xff00_0000)),
            ColorFormat::Rgb565 => small.extend(row.iter().map(|p| {
                let (r, g, b) = (widen(p & 31, 5), widen(p >> 5 & 63, 6), widen(p >> 11 & 31, 5));
                r | g << 8 | b << 16 | 0xff00_0000
            })),
            ColorFormat::Rgba16 => large.extend(row.chunks_exact(2).map(|p| {
                let unorm = |v: u32| (v & 0xffff) as f32 / 65535.0;
                [unorm(p[0]), unorm(p[0] >> 16), unorm(p[1]), unorm(p[1] >> 16)]
            })),
            ColorFormat::Rgba32f => large.extend(row.chunks_exact(4).map(|p| [0, 1, 2, 3].map(|k| f32::from_bits(p[k])))),
        }
    });
    if large.is_empty() { Groups::Rgba8(small) } else { Groups::Rgba(large) }
}

/// Writes one colour to all samples of a pixel, components of `mask` (bits 0 to 3: RGBA) only; `index` counts pixels.
pub(crate) fn write_color(pixels: &mut Pixels, index: usize, color: [f32; 4], mask: u32) {
    let format = pixels.format.color;
    for sample in pixels.samples() {
        put_color(format, &mut pixels.color[(sample + index) * format.words()..], color, mask);
    }
}

/// Puts components of `mask` (bits 0 to 3: RGBA) of a colour into a pixel's words, rounded to nearest.
pub(crate) fn put_color(format: ColorFormat, out: &mut [u32], color: [f32; 4], mask: u32) {
    let select = |mask: u32, bits: [u32; 4]| (0..4).filter(|k| mask >> k & 1 != 0).fold(0, |m, k| m | bits[k as usize]);
    let blend = |old: &mut u32, new: u32, bits: u32| *old = *old & !bits | new & bits;
    let unorm = |c: f32, max: f32| (c.clamp(0.0, 1.0) * max).round_ties_even() as u32;
    match format {
        ColorFormat::Rgba8 | ColorFormat::Rgbx8 => {
            blend(&mut out[0], to_rgba8(color), select(mask, [0xff, 0xff00, 0xff_0000, 0xff00_0000]))
        }
        ColorFormat::Rgb565 => {
            let new = unorm(color[0], 31.0) | unorm(color[1], 63.0) << 5 | unorm(color[2], 31.0) << 11;
            blend(&mut out[0], new, select(mask, [0x1f, 0x7e0, 0xf800, 0]));
        }
        ColorFormat::Rgba16 => {
            for k in 0..4 {
                let shift = 16 * (k as u32 & 1);
                if mask >> k & 1 != 0 {
                    blend(&mut out[k / 2], unorm(color[k], 65535.0) << shift, 0xffff << shift);
                }
            }
        }
        ColorFormat::Rgba32f => (0..4).filter(|k| mask >> k & 1 != 0).for_each(|k| out[k] = color[k].to_bits()),
    }
}

/// Depths of a rectangle inside the surface, in [0, 1].
pub(crate) fn read_depth(pixels: &Pixels, rect: Rect) -> Vec<f64> {
    let format = pixels.format.depth;
    let mut out = Vec::with_capacity(rect.width() * rect.height());
    rows(pixels, rect, |first| out.extend(pixels.depth_stencil[first..first + rect.width()].iter().map(|&word| format.depth(word))));
    out
}

/// The bits of a depth, from 0 to 1, in a buffer. What a client gave in single precision (floats, bytes and shorts) is rounded as Mesa does it, in
/// single precision; depths of 32-bit integers and of copies are exact.
pub(crate) fn depth_word(format: DepthFormat, depth: f64) -> u32 {
    let (single, most) = (depth as f32, format.most());
    let exact = format.is_float() || f64::from(single) != depth;
    if exact { format.word(depth) } else { (single * most as f32).round_ties_even() as u32 }
}

/// Changes the depth and stencil words of all samples of a pixel; `index` counts pixels.
pub(crate) fn write_depth_stencil(pixels: &mut Pixels, index: usize, f: impl Fn(u32) -> u32) {
    for sample in pixels.samples() {
        if let Some(word) = pixels.depth_stencil.get_mut(sample + index) {
            *word = f(*word);
        }
    }
}

/// Stencil values of a rectangle inside the surface.
pub(crate) fn read_stencil(pixels: &Pixels, rect: Rect) -> Vec<u32> {
    let mut out = Vec::with_capacity(rect.width() * rect.height());
    rows(pixels, rect, |first| out.extend(pixels.depth_stencil[first..first + rect.width()].iter().map(|d| d >> 24)));
    out
}
