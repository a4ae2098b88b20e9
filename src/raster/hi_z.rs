//! Hierarchical depth: of each tile of a bin the farthest depth, so that what lies behind all of a tile is left out before its coverage is
//! known.
//!
//! The nearest depth of a triangle in a rectangle of samples is that of a corner, to the last bit: no rounding turns an order round, so
//! neither products nor sums nor clamping nor the conversion to integers do. What is not a number becomes the nearest depth of all. So a
//! tile is left out only where every sample's own test would fail.

use super::fine::depth;
use super::layout::*;
use super::plan::Plan;
use super::simd::{Simd, eight};
use super::store::{BIN_PIXELS, BIN_TILES, BinPixels};

/// Bits of depth in a word; floating-point depths are not kept.
const DEPTH_BITS: u32 = 0xff_ffff;
/// Fractions of a pixel's size that [`HiZ::written`] counts: a box of up to four tiles counts each pixel in each of these.
const SHARES: u32 = 4;
/// Pixels written in a tile after which it is looked at again, at some tenth of what drawing them took.
const STALE: u32 = 32 * SHARES;
/// From a pixel's centre to its border: no sample lies further.
const REACH: f32 = SAMPLE_REACH[0] as f32 / (1 << SUBPIXEL_BITS) as f32;

/// The farthest depths of a bin.
pub struct HiZ {
    /// No sample of the tile is farther.
    far: [u32; BIN_TILES],
    /// Pixels written since the tile was looked at, in [`SHARES`].
    written: [u32; BIN_TILES],
}

impl Default for HiZ {
    fn default() -> Self {
        HiZ { far: [DEPTH_BITS; BIN_TILES], written: [STALE; BIN_TILES] }
    }
}

/// Where a triangle's depth is least in a bin: a column of samples by column of tiles, and what the row follows from.
pub struct Nearest<S: Simd> {
    x: S::F,
    /// See [`Plan::centre`].
    centre: f32,
    /// Row 0 of the bin on the surface.
    origin: i32,
    /// First and last row of samples, on the surface.
    rows: [i32; 2],
    /// Depth grows with the rows.
    down: bool,
}

/// The end of a span of pixels where something with such a slope is least, if all of the end's pixel counts.
#[inline(always)]
fn least(slope: f32, first: f32, last: f32) -> f32 {
    if slope < 0.0 { last + REACH } else { first - REACH }
}

/// First and last, from 16 bits each.
#[inline(always)]
fn span(packed: u32) -> [i32; 2] {
    [(packed & 0xffff) as i32, (packed >> 16) as i32]
}

impl<S: Simd> Nearest<S> {
    /// Of a triangle in a bin at `origin`.
    #[inline(always)]
    pub fn new(plan: &Plan, t: &Triangle, planes: &[[f32; 4]], origin: [i32; 2]) -> Self {
        let slope = planes[0][1];
        let [first, last] = span(t.columns);
        let tiles =
            S::add(S::f(origin[0] as f32 + if slope < 0.0 { 7.0 } else { 0.0 }), S::load(&[0.0, 8.0, 16.0, 24.0, 32.0, 40.0, 48.0, 56.0]));
        let x = S::add(S::clamp(tiles, S::f(first as f32), S::f(last as f32)), S::f(least(slope, plan.centre, plan.centre)));
        Nearest { x, centre: plan.centre, origin: origin[1], rows: span(t.rows), down: planes[0][2] >= 0.0 }
    }

    /// The least depths of a row of tiles, those that the triangle's columns and rows reach.
    #[inline(always)]
    fn row(&self, plan: &Plan, planes: &[[f32; 4]], ty: i32) -> S::I {
        let first = self.origin + ty * 8;
        let (first, last) = (first.max(self.rows[0]), (first + 7).min(self.rows[1]));
        let y = self.centre + if self.down { first as f32 - REACH } else { last as f32 + REACH };
        depth::<S>(plan, planes, self.x, S::f(y))
    }
}

/// The tiles of a bin under a small triangle's box: those under its corners, of which some may be the same.
pub struct Under([usize; 4]);

impl Under {
    /// Of a triangle of at most 8 x 8 pixels that reaches into the bin at `origin`.
    #[inline(always)]
    pub fn new(t: &Triangle, origin: [i32; 2]) -> Under {
        const LAST: i32 = BIN_SIZE as i32 - 1;
        let tiles = |packed: u32, origin: i32| span(packed).map(|v| (v - origin).clamp(0, LAST) as usize / 8);
        let ([x0, x1], [y0, y1]) = (tiles(t.columns, origin[0]), tiles(t.rows, origin[1]));
        Under([y0 * 8 + x0, y0 * 8 + x1, y1 * 8 + x0, y1 * 8 + x1])
    }
}

impl HiZ {
    /// Nothing is known of the bin's depths.
    pub fn forget(&mut self) {
        *self = HiZ::default();
    }

    /// All depths of the bin are this.
    pub fn cleared(&mut self, depth: u32) {
        *self = HiZ { far: [depth; BIN_TILES], written: [0; BIN_TILES] };
    }

    /// Pixels were written in a tile. A count that nobody asks for may wrap: the tile is then looked at later.
    #[inline(always)]
    pub fn wrote(&mut self, tile: usize, pixels: u32) {
        let written = &mut self.written[tile % BIN_TILES];
        *written = written.wrapping_add(pixels * SHARES);
    }

    /// The same under a small triangle.
    #[inline(always)]
    pub fn wrote_under(&mut self, under: &Under, pixels: u32) {
        for tile in under.0 {
            let written = &mut self.written[tile % BIN_TILES];
            *written = written.wrapping_add(pixels);
        }
    }

    /// Of the tiles of row `ty` that a triangle reaches, a bit each, those in which it need not lie behind everything.
    #[inline(always)]
    pub fn visible<S: Simd>(&mut self, plan: &Plan, planes: &[[f32; 4]], near: &Nearest<S>, reached: u32, ty: i32, bin: &BinPixels) -> u32 {
        let z = near.row(plan, planes, ty);
        let tiles = self.before::<S>(plan, z, ty) & reached;
        let written = S::load_u(eight(&self.written, ty as usize * 8));
        let stale = S::signs(S::gt(written, S::i(STALE as i32 - 1))) & tiles;
        if stale == 0 {
            return tiles;
        }
        look_at(S::LEVEL, self, bin, ty as usize, stale);
        self.before::<S>(plan, z, ty) & reached
    }

    /// The tiles of a row, a bit each, whose farthest depth passes against such a one.
    #[inline(always)]
    fn before<S: Simd>(&self, plan: &Plan, z: S::I, ty: i32) -> u32 {
        let far = S::load_u(eight(&self.far, ty as usize * 8));
        S::signs(S::gt(S::iadd(far, S::i(plan.depth_bias)), z))
    }

    /// A small triangle lies behind everything under its box.
    #[inline(always)]
    pub fn hides<S: Simd>(&mut self, plan: &Plan, t: &Triangle, planes: &[[f32; 4]], under: &Under, bin: &BinPixels) -> bool {
        let end = |slope: f32, packed: u32| {
            let [first, last] = span(packed);
            least(slope, first as f32, last as f32) + plan.centre
        };
        let z = depth::<S>(plan, planes, S::f(end(planes[0][1], t.columns)), S::f(end(planes[0][2], t.rows)));
        let behind = |of: &[u32; BIN_TILES]| under.0.iter().fold(0, |most, &tile| most.max(of[tile % BIN_TILES]));
        if S::signs(S::gt(S::i(behind(&self.far) as i32 + plan.depth_bias), z)) == 0 {
            return true;
        }
        if behind(&self.written) < STALE {
            return false;
        }
        for tile in under.0 {
            if self.written[tile % BIN_TILES] >= STALE {
                look_at(S::LEVEL, self, bin, tile / 8, 1 << (tile % 8));
            }
        }
        S::signs(S::gt(S::i(behind(&self.far) as i32 + plan.depth_bias), z)) == 0
    }
}

crate::dispatch! {
    /// Finds the farthest depths of some tiles of a row, a bit each: one copy of it for all its callers.
    fn look_at = look_at_kernel<'a>(hi_z: &mut HiZ, bin: &BinPixels<'a>, ty: usize, tiles: u32)
}

#[inline(always)]
fn look_at_kernel<S: Simd>(hi_z: &mut HiZ, bin: &BinPixels, ty: usize, mut tiles: u32) {
    while tiles != 0 {
        let tile = ty * 8 + tiles.trailing_zeros() as usize;
        tiles &= tiles - 1;
        let mut far = S::i(0);
        for sample in bin.depth_stencil.chunks_exact(BIN_PIXELS) {
            let rows: &[u32; 64] = sample[tile * 64..].first_chunk().expect("a tile");
            for row in rows.as_chunks::<8>().0 {
                far = S::imax(far, S::and(S::load_u(row), S::i(DEPTH_BITS as i32)));
            }
        }
        let mut lanes = [0; 8];
        S::store_u(far, &mut lanes);
        hi_z.far[tile] = lanes.iter().fold(0, |most, &lane| most.max(lane));
        hi_z.written[tile] = 0;
    }
}
