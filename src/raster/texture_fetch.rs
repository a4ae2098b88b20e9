//! Texels by their coordinates, for any image: wrap modes (3.8.7) and fetches, eight lanes at a time.

use super::texture::{Indices, Lanes};
use crate::draw::texture::{TexelFormat, TextureLevel, Wrap};
use crate::program::lanes::{LANES, math};

/// Index of a texel that is the border colour.
const BORDER: i32 = -1;

/// Fraction of a coordinate in its period, mirrored in every other one.
#[inline(always)]
pub fn mirrored(c: f32) -> f32 {
    let whole = c.floor();
    let odd = whole - 2.0 * (whole * 0.5).floor() != 0.0;
    let part = c - whole;
    if odd { 1.0 - part } else { part }
}

/// Index of the nearest texel, or [`BORDER`] (table 3.18 and the wrap modes of 3.8.7).
#[inline(always)]
pub fn nearest(coord: &Lanes, size: i32, wrap: Wrap) -> Indices {
    let n = size as f32;
    match wrap {
        // The fraction of a tiny negative number rounds to 1.
        Wrap::Repeat => coord.map(|c| (((c - c.floor()) * n).floor() as i32).clamp(0, size - 1)),
        Wrap::Clamp | Wrap::ClampToEdge => coord.map(|c| ((c * n).floor() as i32).clamp(0, size - 1)),
        Wrap::ClampToBorder => coord.map(|c| {
            let i = (c * n).floor() as i32;
            if i < 0 || i >= size { BORDER } else { i }
        }),
        Wrap::MirroredRepeat => coord.map(|c| ((mirrored(c) * n).floor() as i32).clamp(0, size - 1)),
    }
}

/// Indices of the two texels around a coordinate, and the weight of the second.
#[inline(always)]
pub fn linear_axis(coord: &Lanes, size: i32, wrap: Wrap) -> ([Indices; 2], Lanes) {
    let n = size as f32;
    let u = match wrap {
        Wrap::Repeat => coord.map(|c| (c - c.floor()) * n - 0.5),
        Wrap::Clamp => coord.map(|c| math::min(math::max(c, 0.0), 1.0) * n - 0.5),
        Wrap::ClampToEdge => coord.map(|c| math::min(math::max(c * n, 0.5), n - 0.5) - 0.5),
        Wrap::ClampToBorder => coord.map(|c| math::min(math::max(c * n, -0.5), n + 0.5) - 0.5),
        Wrap::MirroredRepeat => coord.map(|c| math::min(math::max(mirrored(c) * n, 0.5), n - 0.5) - 0.5),
    };
    let floor = u.map(f32::floor);
    let weight = std::array::from_fn(|i| u[i] - floor[i]);
    let low = floor.map(|f| f as i32);
    let indices = match wrap {
        Wrap::Repeat => {
            [low.map(|i| if i < 0 { size - 1 } else { i.min(size - 1) }), low.map(|i| if i + 1 >= size { 0 } else { (i + 1).max(0) })]
        }
        Wrap::ClampToEdge | Wrap::MirroredRepeat => {
            [low.map(|i| i.clamp(0, size - 1)), low.map(|i| (i.saturating_add(1)).clamp(0, size - 1))]
        }
        Wrap::Clamp | Wrap::ClampToBorder => {
            let or_border = |i: i32| if i < 0 || i >= size { BORDER } else { i };
            [low.map(or_border), low.map(|i| or_border(i.saturating_add(1)))]
        }
    };
    (indices, weight)
}

/// Fetches texels of a level; components of 8 bits count from 0 to 255 until [`Fetch::scaled`].
pub struct Fetch<'a> {
    /// The level.
    pub level: &'a TextureLevel,
    /// Its texels.
    pub format: TexelFormat,
    /// The border colour.
    pub border: &'a [f32; 4],
}

impl Fetch<'_> {
    /// The texels at columns, rows and layers.
    #[inline(always)]
    pub fn texels(&self, x: &Indices, y: &Indices, z: &Indices) -> [Lanes; 4] {
        let (w, h) = (self.level.width as i32, self.level.height as i32);
        let at: [usize; LANES] = std::array::from_fn(|i| ((z[i] * h + y[i]) * w + x[i]).max(0) as usize);
        let mut texel = match self.format {
            TexelFormat::Rgba8 => {
                let words: [u32; LANES] = at.map(|i| self.level.texels.get(i).copied().unwrap_or(0));
                [0, 8, 16, 24].map(|shift| words.map(|word| (word >> shift & 255) as i32 as f32))
            }
            TexelFormat::Rgba32f => {
                [0, 1, 2, 3].map(|c| at.map(|i| f32::from_bits(self.level.texels.get(4 * i + c).copied().unwrap_or(0))))
            }
        };
        let outside = |i: usize| (x[i] | y[i] | z[i]) < 0;
        if (0..LANES).any(outside) {
            let scale = if self.format == TexelFormat::Rgba8 { 255.0 } else { 1.0 };
            for lane in (0..LANES).filter(|&i| outside(i)) {
                for c in 0..4 {
                    texel[c][lane] = self.border[c] * scale;
                }
            }
        }
        texel
    }

    /// To numbers from 0 to 1.
    #[inline(always)]
    pub fn scaled(&self, texel: [Lanes; 4]) -> [Lanes; 4] {
        match self.format {
            TexelFormat::Rgba8 => texel.map(|component| component.map(|v| v * (1.0 / 255.0))),
            TexelFormat::Rgba32f => texel,
        }
    }
}
