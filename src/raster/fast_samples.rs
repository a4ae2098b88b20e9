//! The states of [`super::fast`] with several samples a pixel: coverage and depth by sample, the colour once where any passes. The same
//! values as the general routine of [`super::samples`].

use super::fast::{self, BLEND, DEPTH};
use super::fine::{Scene, Worker, row8};
use super::hi_z::{HiZ, Under};
use super::layout::*;
use super::plan::Plan;
use super::simd::{Simd, columns_from, eight};
use super::small::{self, Covered, gather, scatter};
use super::store::{BIN_PIXELS, BinPixels};
use super::tile::{FULL, LocalEdges};
use super::walk::Walk;
use super::{blend, depth_stencil};
use crate::device::samples::positions;

/// Eight pixels of a bin that need not be neighbours, and where they lie on the surface.
struct Eight<S: Simd, const N: usize> {
    at: [u32; 8],
    x: S::F,
    y: S::F,
    /// By sample: signs where it is not covered.
    outside: [S::I; N],
}

/// What the pixels of a triangle share; for `N` samples, or up to so many where that is the most that there can be.
struct Brush<'a, const N: usize> {
    plan: &'a Plan<'a>,
    places: &'static [[i32; 2]],
    planes: &'a [[f32; 4]],
    perspective: bool,
}

/// Draws a triangle in a bin.
#[inline(always)]
pub fn draw<S: Simd, const N: usize>(
    worker: &mut Worker,
    scene: &Scene,
    plan: &Plan,
    t: &Triangle,
    planes: &[[f32; 4]],
    bin: &mut BinPixels,
) {
    let k = plan.direct.unwrap_or(0);
    let perspective = plan.modes[k] == interpolation::PERSPECTIVE && t.flags & triangle_flags::PERSPECTIVE != 0;
    // A number of samples that is known here unrolls the loops.
    let places = positions(if N == 4 { 4 } else { scene.format.samples });
    let brush = Brush::<N> { plan, places: &places[..places.len().min(N)], planes, perspective };
    if small::fits(plan, t) {
        worker.tiles[1] += brush.small::<S>(t, &mut worker.hi_z, bin) as u64;
        return;
    }
    let [ox, oy] = bin.origin;
    let centre = LocalEdges::<S>::new(t, ox, oy);
    let all = centre.of_all_samples();
    let offsets = centre.offsets(brush.places);
    let mut walk = Walk::<S>::new(plan, t, planes, bin, plan.hi_z);
    while let Some(spot) = walk.next(plan, planes, &mut worker.hi_z, bin) {
        let Some(edges) = all.rows(spot.offset(), spot.rows[0]) else { continue };
        let allowed = walk.allowed(scene, plan, t, spot);
        let full = edges.full && allowed == FULL;
        let tile = fast::Tile { at: spot.pixel(), place: spot.place(bin), edges, rows: spot.rows, allowed };
        if let Some(rows) = brush.tile::<S>(tile, &offsets, bin) {
            worker.tiles[!full as usize] += 1;
            worker.hi_z.wrote(spot.index(), rows * TILE_SIZE);
        }
    }
}

impl<const N: usize> Brush<'_, N> {
    /// Draws a triangle that [`small::fits`]; false where it covers nothing of the bin, or lies behind all that is there.
    #[inline(always)]
    fn small<S: Simd>(&self, t: &Triangle, hi_z: &mut HiZ, bin: &mut BinPixels) -> bool {
        let under = Under::new(t, bin.origin);
        if self.plan.hi_z && hi_z.hides::<S>(self.plan, t, self.planes, &under, bin) {
            return false;
        }
        let corner = small::corner(t);
        let place = [corner[0] - bin.origin[0], corner[1] - bin.origin[1]];
        let inside = small::inside(place);
        let centre = LocalEdges::<S>::new(t, corner[0], corner[1]);
        let (mut masks, mut any) = ([0; N], 0);
        for (mask, &place) in masks.iter_mut().zip(self.places) {
            *mask = centre.sample(place).square() & inside;
            any |= *mask;
        }
        if any == 0 {
            return false;
        }
        let covered = Covered::new(any);
        for first in (0..covered.count).step_by(8) {
            let bytes = eight(&covered.at, first);
            let (at, [x, y]) = small::places::<S>(bytes, place, bin.origin);
            let (x, y) = (S::add(x, S::f(self.plan.centre)), S::add(y, S::f(self.plan.centre)));
            let mut pixels = Eight::<S, N> { at, x, y, outside: [S::i(0); N] };
            let packed = u64::from_le_bytes(*bytes);
            let rows = (packed >> 3 & 0x0707_0707_0707_0707).to_le_bytes();
            let columns = (packed & 0x0707_0707_0707_0707).to_le_bytes();
            let bit = S::permute(S::load_u(&[1, 2, 4, 8, 16, 32, 64, 128]), &columns);
            for s in 0..self.places.len() {
                let row = S::permute(S::extend(&masks[s].to_le_bytes()), &rows);
                pixels.outside[s] = S::eq(S::and(row, bit), S::i(0));
            }
            self.eight::<S>(&pixels, bin);
        }
        hi_z.wrote_under(&under, covered.count as u32);
        true
    }

    /// Draws what is covered of a tile, given each sample's offsets of the edges: the rows that were written; `None` where nothing is
    /// covered.
    #[inline(always)]
    fn tile<S: Simd>(&self, tile: fast::Tile<S>, offsets: &[[u32; 8]; N], bin: &mut BinPixels) -> Option<u32> {
        let fast::Tile { at, place, mut edges, rows: [first, last], allowed } = tile;
        let plan = self.plan;
        let &[head, tail] = self.planes.first_chunk().expect("planes of depth");
        let x = columns_from::<S>(place[0] as f32 + plan.centre);
        let mut across = [S::f(0.0); N];
        for (across, &[dx, _]) in across.iter_mut().zip(self.places) {
            *across = S::fma(S::add(x, S::f(dx as f32 / 16.0)), S::f(head[1]), S::f(head[0]));
        }
        let (mut touched, mut written) = (false, 0);
        for row in first..=last {
            let forbidden = if allowed != FULL { S::mask(!(allowed >> (8 * row)) as u32) } else { S::i(0) };
            let mut outside = [forbidden; N];
            let mut all = S::i(-1);
            for s in 0..self.places.len() {
                if !edges.full {
                    outside[s] = S::or(outside[s], edges.sample(&offsets[s]));
                }
                all = S::and(all, outside[s]);
            }
            edges.step();
            if S::signs(all) == 0xff {
                continue;
            }
            touched = true;
            let pixel = at + row as usize * 8;
            let y = (place[1] + row) as f32 + plan.centre;
            if plan.fast_samples & DEPTH != 0 {
                all = S::i(-1);
                for (s, &[_, dy]) in self.places.iter().enumerate() {
                    let z = S::fma(S::f(y + dy as f32 / 16.0), S::f(head[2]), across[s]);
                    let words = row8(bin.depth_stencil, s * BIN_PIXELS + pixel);
                    let (fails, new) = self.test::<S>(z, tail[2], outside[s], S::load_u(words));
                    S::store_u(new, words);
                    outside[s] = fails;
                    all = S::and(all, fails);
                }
                if S::signs(all) == 0xff {
                    continue;
                }
            }
            written += 1;
            let color = self.color::<S>(x, S::f(y));
            for s in 0..self.places.len() {
                let words = row8(bin.color, s * BIN_PIXELS + pixel);
                let old = S::load_u(words);
                S::store_u(S::select(outside[s], old, self.over::<S>(color, old)), words);
            }
        }
        touched.then_some(written)
    }

    /// Draws eight pixels anywhere in a bin.
    #[inline(always)]
    fn eight<S: Simd>(&self, pixels: &Eight<S, N>, bin: &mut BinPixels) {
        let &Eight { ref at, x, y, mut outside } = pixels;
        let plan = self.plan;
        let &[head, tail] = self.planes.first_chunk().expect("planes of depth");
        if plan.fast_samples & DEPTH != 0 {
            let mut all = S::i(-1);
            for (s, &[dx, dy]) in self.places.iter().enumerate() {
                let (x, y) = (S::add(x, S::f(dx as f32 / 16.0)), S::add(y, S::f(dy as f32 / 16.0)));
                let z = S::fma(y, S::f(head[2]), S::fma(x, S::f(head[1]), S::f(head[0])));
                let words = bin.depth_stencil[s * BIN_PIXELS..].first_chunk_mut().expect("a bin");
                let (fails, new) = self.test::<S>(z, tail[2], outside[s], gather::<S>(words, at));
                if S::signs(fails) != 0xff {
                    scatter::<S>(new, words, at);
                }
                outside[s] = fails;
                all = S::and(all, fails);
            }
            if S::signs(all) == 0xff {
                return;
            }
        }
        let color = self.color::<S>(x, y);
        for s in 0..self.places.len() {
            if S::signs(outside[s]) != 0xff {
                let words = bin.color[s * BIN_PIXELS..].first_chunk_mut().expect("a bin");
                let old = gather::<S>(words, at);
                scatter::<S>(S::select(outside[s], old, self.over::<S>(color, old)), words, at);
            }
        }
    }

    /// The depth test: where a sample is outside or fails, as signs, and what is stored then.
    #[inline(always)]
    fn test<S: Simd>(&self, z: S::F, offset: f32, outside: S::I, old: S::I) -> (S::I, S::I) {
        let plan = self.plan;
        let z = depth_stencil::quantize::<S>(S::add(z, S::f(offset)), plan.depth_range, plan.depth_scale);
        let depth_bits = S::i(0xff_ffff);
        // Not less, of integers: greater than what is one less.
        let outside = S::or(outside, S::gt(z, S::iadd(S::and(old, depth_bits), S::i(plan.depth_bias - 1))));
        (outside, S::select(outside, old, S::or(S::andnot(depth_bits, old), z)))
    }

    /// The colour of eight pixels.
    #[inline(always)]
    fn color<S: Simd>(&self, x: S::F, y: S::F) -> S::I {
        let base = (DEPTH_PLANE_VEC4 + self.plan.direct.unwrap_or(0) as u32 * VARYING_PLANE_VEC4) as usize;
        let p: &[[f32; 4]; 3] = self.planes[base..base + 3].try_into().expect("three");
        let mut color = [S::f(0.0); 4];
        for c in 0..4 {
            color[c] = S::fma(y, S::f(p[2][c]), S::fma(x, S::f(p[1][c]), S::f(p[0][c])));
        }
        if self.perspective {
            let (head, tail) = (self.planes[0], self.planes[1]);
            let w = S::div(S::f(1.0), S::fma(y, S::f(tail[1]), S::fma(x, S::f(tail[0]), S::f(head[3]))));
            for c in &mut color {
                *c = S::mul(*c, w);
            }
        }
        blend::quantize4::<S>(color)
    }

    /// What is stored of a colour over what was there.
    #[inline(always)]
    fn over<S: Simd>(&self, color: S::I, old: S::I) -> S::I {
        if self.plan.fast_samples & BLEND == 0 {
            return color;
        }
        blend::pack::<S>(blend::over::<S>(blend::unpack::<S>(color), blend::unpack::<S>(old)))
    }
}
