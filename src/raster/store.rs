//! The CPU executor's planes: bins of 64 x 64 pixels one after the other, in each its samples, of each sample its tiles, in each tile its 64
//! pixels row by row. A row of a tile is one vector, a tile is four cache lines, a bin's pixels belong to one worker.

use super::layout::{BIN_SIZE, TILE_SIZE};
use super::simd::prefetch_far;
use crate::device::{PlaneFormat, samples};

/// Pixels in a bin.
pub const BIN_PIXELS: usize = (BIN_SIZE * BIN_SIZE) as usize;
/// Tiles in a bin.
pub const BIN_TILES: usize = ((BIN_SIZE / TILE_SIZE) * (BIN_SIZE / TILE_SIZE)) as usize;

/// Index in its bin of the pixel (x, y) of the bin; sample s of it lies `s * BIN_PIXELS` further.
#[inline(always)]
pub fn pixel_index(x: u32, y: u32) -> usize {
    ((y / 8 * 8 + x / 8) * 64 + y % 8 * 8 + x % 8) as usize
}

/// A plane's pixels by bins.
pub struct Store {
    /// Columns and rows of pixels.
    pub size: [u32; 2],
    /// Columns and rows of bins.
    pub bins: [u32; 2],
    /// Samples a pixel.
    pub samples: usize,
    /// Storage.
    pub format: PlaneFormat,
    words: Vec<u32>,
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

impl BinPixels<'_> {
    /// Asks for a tile of the bin that follows in memory, which most often is drawn next: words from `tile` on.
    #[inline(always)]
    pub fn prefetch_next(&self, tile: usize) {
        for words in [&*self.color, &*self.depth_stencil] {
            let next = words.as_ptr().wrapping_add(words.len() + tile);
            (0..4).for_each(|line| prefetch_far(next.wrapping_add(16 * line)));
        }
    }
}

/// All bins of a colour plane, row by row, each with its part of a depth plane of the same size.
pub fn split<'a>(color: &'a mut Store, depth: Option<&'a mut Store>) -> Vec<BinPixels<'a>> {
    let columns = color.bins[0];
    let words = color.bin_words();
    let mut depth = depth.map(|store| (store.bin_words(), &mut store.words)).map(|(words, all)| all.chunks_mut(words));
    let bins = color.words.chunks_mut(words).enumerate().map(|(k, color)| BinPixels {
        origin: [(k as u32 % columns * BIN_SIZE) as i32, (k as u32 / columns * BIN_SIZE) as i32],
        color,
        depth_stencil: depth.as_mut().and_then(Iterator::next).unwrap_or_default(),
    });
    bins.collect()
}

impl Store {
    /// Zeroed.
    pub fn new(size: [u32; 2], samples: u32, format: PlaneFormat) -> Store {
        let bins = size.map(|n| n.div_ceil(BIN_SIZE));
        let mut store = Store { size, bins, samples: samples as usize, format, words: Vec::new() };
        store.words = vec![0; bins[0] as usize * bins[1] as usize * store.bin_words()];
        store
    }

    /// Words of a bin.
    fn bin_words(&self) -> usize {
        self.samples * BIN_PIXELS * self.format.words()
    }

    /// Calls `f(word in the store, word in rows, count)` for every run of a tile's row, sample by sample.
    fn runs(&self, mut f: impl FnMut(usize, usize, usize)) {
        let words = self.format.words();
        let [width, height] = self.size;
        for (sample, y) in (0..self.samples).flat_map(|s| (0..height).map(move |y| (s, y))) {
            let row = (sample * height as usize + y as usize) * width as usize * words;
            let mut at =
                (y / BIN_SIZE * self.bins[0]) as usize * self.bin_words() + (sample * BIN_PIXELS + pixel_index(0, y % BIN_SIZE)) * words;
            for (k, x) in (0..width).step_by(TILE_SIZE as usize).enumerate() {
                f(at, row + x as usize * words, (width - x).min(TILE_SIZE) as usize * words);
                // The next tile, or the first one of the next bin.
                at += if k % 8 == 7 { self.bin_words() - 7 * 64 * words } else { 64 * words };
            }
        }
    }

    /// Copies all samples to rows: sample by sample.
    pub fn read(&self, rows: &mut [u32]) {
        self.runs(|at, row, n| match <&mut [u32; 8]>::try_from(&mut rows[row..row + n]) {
            // A copy of known size is one load and one store, not a call.
            Ok(eight) => *eight = *self.words[at..].first_chunk().expect("a row of a tile"),
            Err(_) => rows[row..row + n].copy_from_slice(&self.words[at..at + n]),
        });
    }

    /// Copies all samples from rows.
    pub fn write(&mut self, rows: &[u32]) {
        let mut all = std::mem::take(&mut self.words);
        self.runs(|at, row, n| all[at..at + n].copy_from_slice(&rows[row..row + n]));
        self.words = all;
    }

    /// Copies row `k` of bins to its pixels' rows of bytes; of a plane of one sample.
    pub fn copy_band(&self, k: u32, lines: &mut [&mut [u8]]) {
        let first = (k * self.bins[0]) as usize;
        for (column, bin) in self.words.chunks(self.bin_words()).skip(first).take(self.bins[0] as usize).enumerate() {
            copy_bin(bin, self.format, self.size[0], column, lines);
        }
    }

    /// Bins, to be resolved one by one: each of `self` beside its samples in `from`, a plane of the same size and format.
    pub fn resolve_bins<'a>(&'a mut self, from: &'a Store) -> impl Iterator<Item = (&'a mut [u32], &'a [u32])> {
        let (words, samples) = (self.bin_words(), from.bin_words());
        self.words.chunks_mut(words).zip(from.words.chunks(samples))
    }
}

/// Copies a bin of one sample to its part of rows of bytes: those of `width` pixels in a row of bins, of which it is the bin at `column`.
pub fn copy_bin(bin: &[u32], format: PlaneFormat, width: u32, column: usize, lines: &mut [&mut [u8]]) {
    let bytes = format.words() * 4;
    let (first, row) = (column * BIN_SIZE as usize * bytes, TILE_SIZE as usize * bytes);
    let end = (first + BIN_SIZE as usize * bytes).min(width as usize * bytes);
    for (y, line) in lines.iter_mut().enumerate() {
        let at = pixel_index(0, y as u32);
        let rows = bytemuck::cast_slice::<u32, u8>(bin)[at * bytes..].chunks(BIN_PIXELS / BIN_TILES * bytes);
        let line = &mut line[first..end];
        match <&mut [u8; 256]>::try_from(&mut *line) {
            // Copies of known size are loads and stores, not calls.
            Ok(line) if row == 32 => {
                for (out, from) in line.as_chunks_mut::<32>().0.iter_mut().zip(rows) {
                    *out = *from.first_chunk().expect("a row of a tile");
                }
            }
            _ => line.chunks_mut(row).zip(rows).for_each(|(out, from)| out.copy_from_slice(&from[..out.len()])),
        }
    }
}

/// Resolves a bin: each pixel becomes the mean of its samples.
pub fn resolve(format: PlaneFormat, bin: &mut [u32], from: &[u32]) {
    let PlaneFormat::Color(color) = format else { return bin.copy_from_slice(&from[..bin.len()]) };
    let planes: Vec<&[u32]> = from.chunks_exact(bin.len()).collect();
    if color.is_bytes() {
        return samples::means_of_bytes(&planes, bin);
    }
    let words = format.words();
    let mut pixel: Vec<&[u32]> = Vec::with_capacity(planes.len());
    for (k, out) in bin.chunks_exact_mut(words).enumerate() {
        pixel.clear();
        pixel.extend(planes.iter().map(|p| &p[k * words..][..words]));
        samples::mean(color, &pixel, out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::device::{ColorFormat, DepthFormat};

    #[test]
    fn rows_survive_the_store() {
        for (format, samples) in [
            (PlaneFormat::Color(ColorFormat::Rgba8), 1),
            (PlaneFormat::Color(ColorFormat::Rgba16), 4),
            (PlaneFormat::DepthStencil { depth: DepthFormat::D24, stencil: true }, 2),
        ] {
            let mut store = Store::new([150, 70], samples, format);
            let rows: Vec<u32> = (0..150 * 70 * samples * format.words() as u32).collect();
            store.write(&rows);
            let mut back = vec![0; rows.len()];
            store.read(&mut back);
            assert!(rows == back);
        }
    }
}
