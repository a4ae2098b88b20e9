//! The CPU executor's image: bins of 64 x 64 pixels one after the other, in each its tiles, in each tile its 64
//! pixels row by row. A row of a tile is one vector, a tile is four cache lines, a bin's pixels belong to one worker.

use super::layout::{BIN_SIZE, TILE_SIZE};
use crate::device::{DepthFormat, Pixels, SurfaceFormat};

/// Pixels in a bin.
pub const BIN_PIXELS: usize = (BIN_SIZE * BIN_SIZE) as usize;
/// Tiles in a bin.
pub const BIN_TILES: usize = ((BIN_SIZE / TILE_SIZE) * (BIN_SIZE / TILE_SIZE)) as usize;

/// Index in its bin of the pixel (x, y) of the bin.
#[inline(always)]
pub fn pixel_index(x: u32, y: u32) -> usize {
    ((y / 8 * 8 + x / 8) * 64 + y % 8 * 8 + x % 8) as usize
}

/// A surface's pixels by bins.
pub struct Store {
    /// Columns and rows of pixels.
    pub size: [u32; 2],
    /// Columns and rows of bins.
    pub bins: [u32; 2],
    /// Storage.
    pub format: SurfaceFormat,
    /// Colour words.
    pub color: Vec<u32>,
    /// Depth and stencil words (empty where the surface has neither).
    pub depth_stencil: Vec<u32>,
}

/// A bin's pixels.
pub struct BinPixels<'a> {
    /// First column and row.
    pub origin: [i32; 2],
    /// Colour words.
    pub color: &'a mut [u32],
    /// Depth and stencil words.
    pub depth_stencil: &'a mut [u32],
}

impl Store {
    /// Zeroed.
    pub fn new(width: u32, height: u32, format: SurfaceFormat) -> Store {
        let bins = [width.div_ceil(BIN_SIZE), height.div_ceil(BIN_SIZE)];
        let pixels = bins[0] as usize * bins[1] as usize * BIN_PIXELS;
        let ds = format.depth != DepthFormat::None || format.stencil;
        Store {
            size: [width, height],
            bins,
            format,
            color: vec![0; pixels * format.color.words()],
            depth_stencil: vec![0; if ds { pixels } else { 0 }],
        }
    }

    /// All bins, row by row.
    pub fn split(&mut self) -> Vec<BinPixels<'_>> {
        let columns = self.bins[0];
        let words = self.format.color.words() * BIN_PIXELS;
        let mut depth = self.depth_stencil.chunks_mut(BIN_PIXELS);
        let bins = self.color.chunks_mut(words).enumerate().map(|(k, color)| BinPixels {
            origin: [(k as u32 % columns * BIN_SIZE) as i32, (k as u32 / columns * BIN_SIZE) as i32],
            color,
            depth_stencil: depth.next().unwrap_or_default(),
        });
        bins.collect()
    }

    /// Calls `f(index in the store, index in rows, count)` for every run of pixels that are neighbours in both.
    fn runs(size: [u32; 2], columns: u32, mut f: impl FnMut(usize, usize, usize)) {
        for y in 0..size[1] {
            for x in (0..size[0]).step_by(TILE_SIZE as usize) {
                let bin = (y / BIN_SIZE * columns + x / BIN_SIZE) as usize;
                let n = (size[0] - x).min(TILE_SIZE) as usize;
                f(bin * BIN_PIXELS + pixel_index(x % BIN_SIZE, y % BIN_SIZE), y as usize * size[0] as usize + x as usize, n);
            }
        }
    }

    /// Copies colour to pixels in rows.
    pub fn read_color(&self, to: &mut Pixels) {
        copy_rows(self, &self.color, &mut to.color, self.format.color.words());
    }

    /// Copies the colour of row `k` of bins to its pixels' rows of bytes.
    pub fn copy_band(&self, k: u32, lines: &mut [&mut [u8]]) {
        let words = self.format.color.words();
        let tile = TILE_SIZE as usize * words;
        for (y, line) in lines.iter_mut().enumerate() {
            let first = (k * self.bins[0]) as usize * BIN_PIXELS + pixel_index(0, y as u32);
            let row = &mut line[..self.size[0] as usize * words * 4];
            for (t, out) in row.chunks_mut(tile * 4).enumerate() {
                let at = (first + t / 8 * BIN_PIXELS + t % 8 * 64) * words;
                match <&mut [u8; 32]>::try_from(&mut *out) {
                    // A copy of known size is one load and one store, not a call.
                    Ok(out) if words == 1 => *out = bytemuck::cast(*self.color[at..].first_chunk::<8>().expect("a row of a tile")),
                    _ => out.copy_from_slice(&bytemuck::cast_slice(&self.color[at..])[..out.len()]),
                }
            }
        }
    }

    /// Copies depth and stencil to pixels in rows.
    pub fn read_depth_stencil(&self, to: &mut Pixels) {
        if !self.depth_stencil.is_empty() {
            copy_rows(self, &self.depth_stencil, &mut to.depth_stencil, 1);
        }
    }

    /// Copies from pixels in rows.
    pub fn write(&mut self, from: &Pixels) {
        let words = self.format.color.words();
        let depth = !self.depth_stencil.is_empty();
        let (color, ds) = (&mut self.color, &mut self.depth_stencil);
        Store::runs(self.size, self.bins[0], |at, row, n| {
            color[at * words..(at + n) * words].copy_from_slice(&from.color[row * words..(row + n) * words]);
            if depth {
                ds[at..at + n].copy_from_slice(&from.depth_stencil[row..row + n]);
            }
        });
    }
}

/// Copies words of a store to rows.
fn copy_rows(store: &Store, from: &[u32], to: &mut [u32], words: usize) {
    if words != 1 {
        return Store::runs(store.size, store.bins[0], |at, row, n| {
            to[row * words..(row + n) * words].copy_from_slice(&from[at * words..(at + n) * words]);
        });
    }
    for (y, row) in to.chunks_exact_mut(store.size[0].max(1) as usize).enumerate() {
        let y = y as u32;
        let line = (y / BIN_SIZE * store.bins[0]) as usize * BIN_PIXELS + pixel_index(0, y % BIN_SIZE);
        let (eights, rest) = row.as_chunks_mut::<8>();
        for (k, eight) in eights.iter_mut().enumerate() {
            let at = line + k / 8 * BIN_PIXELS + k % 8 * 64;
            // A copy of known size is one load and one store, not a call.
            *eight = *from[at..].first_chunk().expect("a row of a tile");
        }
        let k = eights.len();
        let at = line + k / 8 * BIN_PIXELS + k % 8 * 64;
        let n = rest.len();
        rest.copy_from_slice(&from[at.min(from.len() - n)..][..n]);
    }
}
