//! Tile stage: which samples of a tile of 8 x 8 pixels a triangle covers.
//!
//! Edge function i runs from vertex i to the next: `c + dcdy * y - dcdx * x` in 1/65536 square pixels, positive
//! inside. At pixel centres it is a constant plus a multiple of 256, so it is kept divided by 256, rounded down, and
//! a sample is inside where all three are not negative. Within a bin the divided values fit 32 bits.

use super::layout::*;

/// The three edge functions of a triangle, divided by 256, for whole pixels: inside where `c + a * x + b * y >= 0`.
#[derive(Clone, Copy, Debug)]
pub struct Edges {
    /// At pixel (0, 0).
    pub c: [i64; 3],
    /// Step in x.
    pub a: [i32; 3],
    /// Step in y.
    pub b: [i32; 3],
}

/// The edge functions near one place: everything fits 32 bits for offsets up to 63 pixels.
#[derive(Clone, Copy, Debug)]
pub struct LocalEdges {
    /// At the place.
    pub c: [i32; 3],
    /// Step in x.
    pub a: [i32; 3],
    /// Step in y.
    pub b: [i32; 3],
}

impl Edges {
    /// Of a set-up triangle. `flags` says which way is up.
    #[inline(always)]
    pub fn new(t: &Triangle) -> Edges {
        let bottom_up = t.flags & triangle_flags::BOTTOM_UP != 0;
        let mut edges = Edges { c: [0; 3], a: [0; 3], b: [0; 3] };
        for i in 0..3 {
            let j = (i + 1) % 3;
            let (dcdy, dcdx) = (t.x[i] - t.x[j], t.y[i] - t.y[j]);
            let mut c = dcdx as i64 * t.x[i] as i64 - dcdy as i64 * t.y[i] as i64;
            // Left edges are inclusive, and bottom edges as GL sees them.
            let inclusive = dcdx < 0 || dcdx == 0 && (if bottom_up { dcdy > 0 } else { dcdy < 0 });
            c += inclusive as i64;
            (edges.c[i], edges.a[i], edges.b[i]) = ((c - 1) >> SUBPIXEL_BITS, -dcdx, dcdy);
        }
        edges
    }

    /// Whether a square of pixels from (x, y) to (x + side, y + side) may hold a covered sample.
    #[inline(always)]
    pub fn may_touch(&self, x: i32, y: i32, side: i32) -> bool {
        (0..3).all(|i| {
            let (a, b) = (self.a[i] as i64, self.b[i] as i64);
            self.c[i] + a * x as i64 + b * y as i64 + side as i64 * (a.max(0) + b.max(0)) >= 0
        })
    }

    /// Relative to pixel (x, y).
    #[inline(always)]
    pub fn local(&self, x: i32, y: i32) -> LocalEdges {
        let mut local = LocalEdges { c: [0; 3], a: self.a, b: self.b };
        for i in 0..3 {
            let c = self.c[i] + self.a[i] as i64 * x as i64 + self.b[i] as i64 * y as i64;
            // Steps are at most 2^23, so that no sample within 63 pixels changes its sign by this.
            local.c[i] = c.clamp(-(1 << 30), 1 << 30) as i32;
        }
        local
    }
}

impl LocalEdges {
    /// The edge functions of a triangle relative to pixel (x, y), by 32-bit arithmetic where the triangle is small and near.
    #[inline(always)]
    pub fn new(t: &Triangle, x: i32, y: i32) -> LocalEdges {
        let bottom_up = t.flags & triangle_flags::BOTTOM_UP != 0;
        let mut local = LocalEdges { c: [0; 3], a: [0; 3], b: [0; 3] };
        let mut wide = 0;
        for i in 0..3 {
            let j = (i + 1) % 3;
            let (dcdy, dcdx) = (t.x[i] - t.x[j], t.y[i] - t.y[j]);
            // Steps below 2^12 and places below 2^15: products and their differences fit.
            wide |= (dcdy + 2048) as u32 | (dcdx + 2048) as u32;
            let (px, py) = (t.x[i] - (x << SUBPIXEL_BITS), t.y[i] - (y << SUBPIXEL_BITS));
            let inclusive = dcdx < 0 || dcdx == 0 && (if bottom_up { dcdy > 0 } else { dcdy < 0 });
            let c = dcdx.wrapping_mul(px).wrapping_sub(dcdy.wrapping_mul(py)).wrapping_add(inclusive as i32 - 1);
            (local.c[i], local.a[i], local.b[i]) = (c >> SUBPIXEL_BITS, -dcdx, dcdy);
        }
        if wide < 4096 { local } else { Edges::new(t).local(x, y) }
    }
}

/// A tile's coverage: bit 8 * y + x.
pub const FULL: u64 = u64::MAX;

impl LocalEdges {
    /// Coverage of rows `first..=last` of the tile whose first pixel lies `(x, y)` from the place.
    #[inline(always)]
    pub fn coverage<S: super::simd::Simd>(&self, x: i32, y: i32, first: i32, last: i32) -> u64 {
        let lanes = S::load_u(&[0, 1, 2, 3, 4, 5, 6, 7]);
        let mut rows = [S::i(0); 3];
        let mut full = true;
        for i in 0..3 {
            let (a, b) = (self.a[i], self.b[i]);
            let c = self.c[i] + a * x + b * y;
            if c + 7 * (a.max(0) + b.max(0)) < 0 {
                return 0;
            }
            full &= c + 7 * (a.min(0) + b.min(0)) >= 0;
            rows[i] = S::i(c.wrapping_add(b.wrapping_mul(first)));
        }
        if full {
            return FULL;
        }
        for i in 0..3 {
            let a = S::i(self.a[i]);
            // a * lane by adding the bits' multiples.
            let bit = |n: i32| S::gt(S::and(lanes, S::i(n)), S::i(0));
            let a2 = S::shl::<1>(a);
            let a4 = S::shl::<2>(a);
            rows[i] = S::iadd(rows[i], S::and(bit(1), a));
            rows[i] = S::iadd(rows[i], S::and(bit(2), a2));
            rows[i] = S::iadd(rows[i], S::and(bit(4), a4));
        }
        let mut mask = 0u64;
        for row in first..=last {
            let outside = S::signs(S::or(S::or(rows[0], rows[1]), rows[2]));
            mask |= ((!outside & 0xff) as u64) << (8 * row);
            for i in 0..3 {
                rows[i] = S::iadd(rows[i], S::i(self.b[i]));
            }
        }
        mask
    }
}

/// The part of a tile at (x, y) that lies within columns and rows, both inclusive.
#[inline(always)]
pub fn rectangle_mask(x: i32, y: i32, columns: (i32, i32), rows: (i32, i32)) -> u64 {
    let span = |first: i32, last: i32| (0xffu32 << first.clamp(0, 8)) & (0xff >> (7 - last).clamp(0, 8)) & 0xff;
    let row_bits = span(columns.0 - x, columns.1 - x) as u64;
    let (r0, r1) = ((rows.0 - y).max(0), (rows.1 - y).min(7));
    if r0 > r1 {
        return 0;
    }
    let which = (FULL << (8 * r0)) & (FULL >> (8 * (7 - r1)));
    row_bits.wrapping_mul(0x0101_0101_0101_0101) & which
}
