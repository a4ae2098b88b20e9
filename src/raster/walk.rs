//! The tiles of a bin that a triangle may be seen in, one after the other, and what of each may be drawn at all.

use super::fine::Scene;
use super::hi_z::{HiZ, Nearest};
use super::layout::*;
use super::plan::Plan;
use super::simd::Simd;
use super::store::BinPixels;
use super::tile::{FULL, rectangle_mask};

/// The part of a bin that a triangle's samples may lie in.
struct Extent {
    origin: [i32; 2],
    /// First and last column and row, from the bin's first.
    columns: (i32, i32),
    /// See `columns`.
    rows: (i32, i32),
    /// Not all pixels that are covered may be drawn.
    limited: bool,
}

impl Extent {
    /// Of a triangle in a bin.
    #[inline(always)]
    fn new(plan: &Plan, t: &Triangle, bin: &BinPixels) -> Extent {
        let stippled = plan.stipple.is_some() && t.flags & triangle_flags::POLYGON != 0;
        let within = |span: u32, first: i32| ((span & 0xffff) as i32 - first, (span >> 16) as i32 - first);
        Extent {
            origin: bin.origin,
            columns: within(t.columns, bin.origin[0]),
            rows: within(t.rows, bin.origin[1]),
            limited: stippled || t.flags & triangle_flags::CUT != 0,
        }
    }

    /// The tiles that columns or rows lie in.
    #[inline(always)]
    fn tiles(&self, (first, last): (i32, i32)) -> std::ops::Range<i32> {
        // Shifts: a last one before the first tile is none.
        first.max(0) >> 3..(last.min(63) >> 3) + 1
    }

    /// The tiles of a row that the columns lie in, a bit each.
    #[inline(always)]
    fn tile_columns(&self) -> u32 {
        let tiles = self.tiles(self.columns);
        (0xff >> (8 - tiles.end)) & (0xff << tiles.start)
    }

    /// The pixels of a tile that may be drawn at all: the scissor and the polygon stipple.
    #[inline(always)]
    fn allowed(&self, scene: &Scene, plan: &Plan, t: &Triangle, [tx, ty]: [i32; 2]) -> u64 {
        let mut allowed = FULL;
        if !self.limited {
            return allowed;
        }
        if t.flags & triangle_flags::CUT != 0 {
            allowed &= rectangle_mask(tx * 8, ty * 8, self.columns, self.rows);
        }
        if let (Some(stipple), true) = (plan.stipple, t.flags & triangle_flags::POLYGON != 0) {
            allowed &= stipple_mask(stipple, scene, self.origin[0] + tx * 8, self.origin[1] + ty * 8);
        }
        allowed
    }
}

/// The polygon stipple on a tile whose first pixel is (x, y).
fn stipple_mask(stipple: &[u32; 32], scene: &Scene, x: i32, y: i32) -> u64 {
    let mut mask = 0;
    for row in 0..8 {
        let y = y + row;
        let gl_y = if scene.format.top_first { scene.height as i32 - 1 - y } else { y };
        let pattern = stipple[(gl_y & 31) as usize].reverse_bits();
        mask |= ((pattern >> (x & 31) & 0xff) as u64) << (8 * row);
    }
    mask
}

/// A tile of a bin, and the rows of it that samples of a triangle may lie in.
#[derive(Clone, Copy)]
pub struct Spot {
    /// Column and row among the bin's tiles.
    tile: [i32; 2],
    /// First and last row.
    pub rows: [i32; 2],
}

impl Spot {
    /// Its number in the bin.
    #[inline(always)]
    pub fn index(self) -> usize {
        (self.tile[1] * 8 + self.tile[0]) as usize
    }

    /// Its first pixel in the bin.
    #[inline(always)]
    pub fn pixel(self) -> usize {
        self.index() * 64
    }

    /// Its first column and row, from the bin's first.
    #[inline(always)]
    pub fn offset(self) -> [i32; 2] {
        self.tile.map(|n| n * 8)
    }

    /// The same on the surface.
    #[inline(always)]
    pub fn place(self, bin: &BinPixels) -> [i32; 2] {
        let [x, y] = self.offset();
        [bin.origin[0] + x, bin.origin[1] + y]
    }
}

/// Goes over the tiles of a triangle in a bin, row by row, without those that hierarchical depth hides.
pub struct Walk<S: Simd> {
    extent: Extent,
    near: Option<Nearest<S>>,
    /// The row of tiles, and one past the last.
    row: i32,
    end: i32,
    /// First and last row of samples in the row of tiles.
    rows: [i32; 2],
    /// Tiles of the row that are still to come, a bit each.
    left: u32,
}

impl<S: Simd> Walk<S> {
    /// Of a triangle; `looks`: hierarchical depth is asked.
    #[inline(always)]
    pub fn new(plan: &Plan, t: &Triangle, planes: &[[f32; 4]], bin: &BinPixels, looks: bool) -> Self {
        let extent = Extent::new(plan, t, bin);
        let near = if looks { Some(Nearest::new(plan, t, planes, bin.origin)) } else { None };
        let rows = extent.tiles(extent.rows);
        Walk { extent, near, row: rows.start - 1, end: rows.end, rows: [0; 2], left: 0 }
    }

    /// The next tile.
    #[inline(always)]
    pub fn next(&mut self, plan: &Plan, planes: &[[f32; 4]], hi_z: &mut HiZ, bin: &BinPixels) -> Option<Spot> {
        while self.left == 0 {
            self.row += 1;
            if self.row >= self.end {
                return None;
            }
            let (first, last) = self.extent.rows;
            self.rows = [(first - self.row * 8).max(0), (last - self.row * 8).min(7)];
            self.left = self.extent.tile_columns();
            if let Some(near) = &self.near {
                self.left = hi_z.visible::<S>(plan, planes, near, self.left, self.row, bin);
            }
        }
        let column = self.left.trailing_zeros() as i32;
        self.left &= self.left - 1;
        Some(Spot { tile: [column, self.row], rows: self.rows })
    }

    /// The pixels of a tile that may be drawn at all: the scissor and the polygon stipple.
    #[inline(always)]
    pub fn allowed(&self, scene: &Scene, plan: &Plan, t: &Triangle, spot: Spot) -> u64 {
        self.extent.allowed(scene, plan, t, spot.tile)
    }
}
