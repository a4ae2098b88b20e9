//! Bin stage: which triangles each bin of 64 x 64 pixels has to look at: count, scan, emit, in primitive order.

use super::layout::*;
use super::tile::Edges;

/// The lists of all bins, one after the other.
#[derive(Default)]
pub struct BinLists {
    /// Where each bin's list begins; one more at the end.
    pub offsets: Vec<u32>,
    /// Triangle indices.
    pub entries: Vec<u32>,
    cursor: Vec<u32>,
    touched: Vec<(u32, u32)>,
}

impl BinLists {
    /// The list of a bin.
    pub fn list(&self, bin: usize) -> &[u32] {
        &self.entries[self.offsets[bin] as usize..self.offsets[bin + 1] as usize]
    }

    /// Makes the lists for a grid of `columns` x `rows` bins.
    pub fn run(&mut self, triangles: &[Triangle], columns: u32, rows: u32) {
        let bins = (columns * rows) as usize;
        self.cursor.clear();
        self.cursor.resize(bins + 1, 0);
        self.touched.clear();
        for (index, t) in triangles.iter().enumerate() {
            let (x0, x1) = ((t.columns & 0xffff) / BIN_SIZE, (t.columns >> 16) / BIN_SIZE);
            let (y0, y1) = ((t.rows & 0xffff) / BIN_SIZE, (t.rows >> 16) / BIN_SIZE);
            let mut touch = |x: u32, y: u32| {
                let bin = y * columns + x;
                self.cursor[bin as usize] += 1;
                self.touched.push((bin, index as u32));
            };
            if x1 - x0 + y1 - y0 <= 1 {
                for y in y0..=y1 {
                    for x in x0..=x1 {
                        touch(x, y);
                    }
                }
            } else {
                let edges = Edges::new(t);
                // Samples lie within half a pixel of the centres.
                let margin = (t.flags & triangle_flags::MULTISAMPLE != 0) as i32;
                for y in y0..=y1 {
                    for x in x0..=x1 {
                        if edges.may_touch((x * BIN_SIZE) as i32 - margin, (y * BIN_SIZE) as i32 - margin, BIN_SIZE as i32 - 1 + 2 * margin)
                        {
                            touch(x, y);
                        }
                    }
                }
            }
        }
        self.offsets.clear();
        let mut sum = 0;
        for c in &mut self.cursor {
            self.offsets.push(sum);
            sum += std::mem::replace(c, sum);
        }
        self.entries.clear();
        self.entries.resize(sum as usize, 0);
        for &(bin, index) in &self.touched {
            let at = &mut self.cursor[bin as usize];
            self.entries[*at as usize] = index;
            *at += 1;
        }
    }
}
