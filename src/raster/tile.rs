//! Tile stage: which samples of a tile of 8 x 8 pixels a triangle covers.
//!
//! Edge function i runs from vertex i to the next: `c + dcdy * y - dcdx * x` in 1/65536 square pixels, positive
//! inside. At pixel centres it is a constant plus a multiple of 256, so it is kept divided by 256, rounded down, and
//! a sample is inside where all three are not negative. Within a bin the divided values fit 32 bits, saturated at its middle.

use super::layout::*;
use super::simd::Simd;

/// The three edge functions of a triangle, divided by 256, for whole pixels: inside where `c + a * x + b * y >= 0`.
#[derive(Clone, Copy, Debug)]
pub struct Edges {
    /// At pixel (0, 0).
    pub c: [i64; 3],
    /// What the division left over, in sixteenths.
    pub low: [i32; 3],
    /// Step in x.
    pub a: [i32; 3],
    /// Step in y.
    pub b: [i32; 3],
}

/// The edge functions in a bin, from its first pixel on, an edge a lane (the first three): all values there fit 32 bits.
#[derive(Clone, Copy)]
pub struct LocalEdges<S: Simd> {
    /// At the place.
    c: S::I,
    /// Its next four bits.
    low: S::I,
    /// Step in x.
    a: S::I,
    /// Step in y.
    b: S::I,
    /// From a tile's first sample to its greatest and to its least.
    reach: [S::I; 2],
    /// Of each edge: steps in x to the samples of a row.
    along: [S::I; 3],
    /// Of each edge: step in y.
    down: [S::I; 3],
}

/// Most that an edge function may change from a pixel to the next: the range of coordinates (`COORDINATE_RANGE`), and a line's or point's
/// width of 255 pixels.
pub const LARGEST_STEP: i32 = (49151 + 255) << SUBPIXEL_BITS;

/// What edge functions are saturated to at the middle of a bin.
const SATURATED: i32 = 1 << 30;

/// Nothing within 32 pixels of the middle, samples half a pixel off included, changes its sign by that, and nothing there overflows.
const _: () = assert!(65 * LARGEST_STEP as i64 + 2 < SATURATED as i64 && SATURATED as i64 + 65 * LARGEST_STEP as i64 + 2 < 1 << 31);

/// Each edge's value in all lanes.
const EDGE: [[u8; 8]; 3] = [[0; 8], [1; 8], [2; 8]];

impl Edges {
    /// Of a set-up triangle. `flags` says which way is up.
    #[inline(always)]
    pub fn new(t: &Triangle) -> Edges {
        let bottom_up = t.flags & triangle_flags::BOTTOM_UP != 0;
        let mut edges = Edges { c: [0; 3], low: [0; 3], a: [0; 3], b: [0; 3] };
        for i in 0..3 {
            let j = (i + 1) % 3;
            let (dcdy, dcdx) = (t.x[i] - t.x[j], t.y[i] - t.y[j]);
            let mut c = dcdx as i64 * t.x[i] as i64 - dcdy as i64 * t.y[i] as i64;
            // Left edges are inclusive, and bottom edges as GL sees them.
            let inclusive = dcdx < 0 || dcdx == 0 && (if bottom_up { dcdy > 0 } else { dcdy < 0 });
            c += inclusive as i64;
            (edges.c[i], edges.a[i], edges.b[i]) = ((c - 1) >> SUBPIXEL_BITS, -dcdx, dcdy);
            edges.low[i] = ((c - 1) >> 4) as i32 & 15;
        }
        edges
    }

    /// Whether a square of pixels from (x, y) to (x + side, y + side) may hold a covered centre.
    #[inline(always)]
    pub fn may_touch(&self, x: i32, y: i32, side: i32) -> bool {
        (0..3).all(|i| {
            let (a, b) = (self.a[i] as i64, self.b[i] as i64);
            self.c[i] + a * x as i64 + b * y as i64 + side as i64 * (a.max(0) + b.max(0)) >= 0
        })
    }

    /// The constants relative to pixel (x, y), a bin's first: right modulo 2^32, and right for all pixels of the bin, where the sums fit.
    #[inline(always)]
    fn local(&self, x: i32, y: i32) -> [i32; 3] {
        const HALF: i32 = BIN_SIZE as i32 / 2;
        let mut local = [0; 3];
        for i in 0..3 {
            let (a, b) = (self.a[i], self.b[i]);
            let middle = self.c[i] + a as i64 * (x + HALF) as i64 + b as i64 * (y + HALF) as i64;
            let middle = middle.clamp(-SATURATED as i64, SATURATED as i64) as i32;
            local[i] = middle.wrapping_sub(HALF * a).wrapping_sub(HALF * b);
        }
        local
    }
}

impl<S: Simd> LocalEdges<S> {
    /// The edge functions of a triangle relative to pixel (x, y), by 32-bit arithmetic where the triangle is small and near.
    #[inline(always)]
    pub fn new(t: &Triangle, x: i32, y: i32) -> Self {
        // The vertices are the first six words.
        let words: &[u32; 12] = bytemuck::cast_ref(t);
        let words = S::load_u(words.first_chunk().expect("eight of twelve"));
        let (xi, yi) = (words, S::permute(words, &[3, 4, 5, 3, 3, 3, 3, 3]));
        let (xj, yj) = (S::permute(words, &[1, 2, 0, 0, 0, 0, 0, 0]), S::permute(words, &[4, 5, 3, 3, 3, 3, 3, 3]));
        let (dcdy, dcdx) = (S::isub(xi, xj), S::isub(yi, yj));
        let (a, b) = (S::isub(S::i(0), dcdx), dcdy);
        // Steps of at most 2^14, 64 pixels, and so places of at most 2^15 and a little: products and their differences fit.
        let bias = S::i(1 << 14);
        let beyond = S::andnot(S::i((1 << 15) - 1), S::or(S::iadd(dcdy, bias), S::iadd(dcdx, bias)));
        let (c, low) = if S::signs(S::eq(beyond, S::i(0))) & 7 == 7 {
            let (px, py) = (S::isub(xi, S::i(x << SUBPIXEL_BITS)), S::isub(yi, S::i(y << SUBPIXEL_BITS)));
            let bottom = if t.flags & triangle_flags::BOTTOM_UP != 0 { S::gt(dcdy, S::i(0)) } else { S::gt(S::i(0), dcdy) };
            let inclusive = S::or(S::gt(S::i(0), dcdx), S::and(S::eq(dcdx, S::i(0)), bottom));
            let c = S::isub(S::imul(dcdx, px), S::imul(dcdy, py));
            // One less where the edge is not inclusive.
            let c = S::iadd(c, S::xor(inclusive, S::i(-1)));
            (S::sar::<{ SUBPIXEL_BITS as i32 }>(c), S::and(S::sar::<4>(c), S::i(15)))
        } else {
            let edges = Edges::new(t);
            let load = |[e0, e1, e2]: [i32; 3]| S::load_u(&[e0 as u32, e1 as u32, e2 as u32, 0, 0, 0, 0, 0]);
            (load(edges.local(x, y)), load(edges.low))
        };
        let lanes = S::load_u(&[0, 1, 2, 3, 4, 5, 6, 7]);
        let (zero, seven) = (S::i(0), S::i(7));
        let positive = S::iadd(S::and(S::gt(a, zero), a), S::and(S::gt(b, zero), b));
        let negative = S::iadd(S::and(S::gt(zero, a), a), S::and(S::gt(zero, b), b));
        let mut local =
            LocalEdges { c, low, a, b, reach: [S::imul(positive, seven), S::imul(negative, seven)], along: [zero; 3], down: [zero; 3] };
        for i in 0..3 {
            local.along[i] = S::imul(S::permute(a, &EDGE[i]), lanes);
            local.down[i] = S::permute(b, &EDGE[i]);
        }
        local
    }

    /// Coverage of the 8 x 8 pixels from the place on: bit 8 * y + x. For triangles that are not much larger: no value is saturated.
    #[inline(always)]
    pub fn square(&self) -> u64 {
        let mut values = self.along;
        for i in 0..3 {
            values[i] = S::iadd(values[i], S::permute(self.c, &EDGE[i]));
        }
        let mut mask = 0;
        for row in 0..8 {
            let outside = S::or(S::or(values[0], values[1]), values[2]);
            mask |= ((!S::signs(outside) & 0xff) as u64) << (8 * row);
            for i in 0..3 {
                values[i] = S::iadd(values[i], self.down[i]);
            }
        }
        mask
    }

    /// What the edge functions are more at a sample, by its place from the centre in 1/16 pixel: an edge a lane.
    #[inline(always)]
    pub fn offset(&self, [x, y]: [i32; 2]) -> S::I {
        S::sar::<4>(S::iadd(self.low, S::iadd(S::imul(self.a, S::i(x)), S::imul(self.b, S::i(y)))))
    }

    /// The same of each of up to `N` samples.
    #[inline(always)]
    pub fn offsets<const N: usize>(&self, places: &[[i32; 2]]) -> [[u32; 8]; N] {
        let mut offsets = [[0; 8]; N];
        for (offsets, &place) in offsets.iter_mut().zip(places) {
            S::store_u(self.offset(place), offsets);
        }
        offsets
    }

    /// The edge functions of a sample, by its place from the centre in 1/16 pixel.
    #[inline(always)]
    pub fn sample(&self, place: [i32; 2]) -> Self {
        LocalEdges { c: S::iadd(self.c, self.offset(place)), ..*self }
    }

    /// With a reach that holds for all samples, wherever they lie in their pixels.
    #[inline(always)]
    pub fn of_all_samples(&self) -> Self {
        let zero = S::i(0);
        let size = |v: S::I| S::select(S::gt(zero, v), S::isub(zero, v), v);
        let more = S::iadd(S::sar::<1>(S::iadd(size(self.a), size(self.b))), S::i(1));
        LocalEdges { reach: [S::iadd(self.reach[0], more), S::isub(self.reach[1], more)], ..*self }
    }
}

/// A tile's coverage: bit 8 * y + x.
pub const FULL: u64 = u64::MAX;

/// The edge functions along a row of a tile, stepped from row to row.
pub struct TileRows<S: Simd> {
    values: [S::I; 3],
    steps: [S::I; 3],
    /// All samples of the tile are inside.
    pub full: bool,
}

impl<S: Simd> TileRows<S> {
    /// Samples outside have their sign set; goes on to the next row.
    #[inline(always)]
    pub fn next_row(&mut self) -> S::I {
        let outside = S::or(S::or(self.values[0], self.values[1]), self.values[2]);
        self.step();
        outside
    }

    /// Goes on to the next row.
    #[inline(always)]
    pub fn step(&mut self) {
        for i in 0..3 {
            self.values[i] = S::iadd(self.values[i], self.steps[i]);
        }
    }

    /// Where a sample with such [`LocalEdges::offset`]s is outside, the sign is set; of a tile that is not full.
    #[inline(always)]
    pub fn sample(&self, offsets: &[u32; 8]) -> S::I {
        let mut values = self.values;
        for i in 0..3 {
            values[i] = S::iadd(values[i], S::i(offsets[i] as i32));
        }
        S::or(S::or(values[0], values[1]), values[2])
    }

    /// Coverage of rows `first..=last`, where `first` is the row that it stands at: bit 8 * y + x.
    #[inline(always)]
    pub fn mask(mut self, first: i32, last: i32) -> u64 {
        if self.full {
            return FULL;
        }
        let mut mask = 0;
        for row in first..=last {
            mask |= ((!S::signs(self.next_row()) & 0xff) as u64) << (8 * row);
        }
        mask
    }

    /// The same by sample, for as many as there are masks.
    #[inline(always)]
    pub fn masks(mut self, first: i32, last: i32, offsets: &[[u32; 8]], masks: &mut [u64]) {
        if self.full {
            return masks.fill(FULL);
        }
        masks.fill(0);
        for row in first..=last {
            for (mask, offsets) in masks.iter_mut().zip(offsets) {
                *mask |= ((!S::signs(self.sample(offsets)) & 0xff) as u64) << (8 * row);
            }
            self.step();
        }
    }
}

impl<S: Simd> LocalEdges<S> {
    /// The rows from `first` on of the tile whose first pixel lies so far from the place; `None` where no sample is inside.
    #[inline(always)]
    pub fn rows(&self, [x, y]: [i32; 2], first: i32) -> Option<TileRows<S>> {
        let c = S::iadd(self.c, S::iadd(S::imul(self.a, S::i(x)), S::imul(self.b, S::i(y))));
        if S::signs(S::iadd(c, self.reach[0])) & 7 != 0 {
            return None;
        }
        if S::signs(S::iadd(c, self.reach[1])) & 7 == 0 {
            return Some(TileRows { values: [S::i(0); 3], steps: [S::i(0); 3], full: true });
        }
        let start = S::iadd(c, S::imul(self.b, S::i(first)));
        let mut values = self.along;
        for i in 0..3 {
            values[i] = S::iadd(values[i], S::permute(start, &EDGE[i]));
        }
        Some(TileRows { values, steps: self.down, full: false })
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
