//! The states of [`super::fast`] with several samples a pixel: coverage and depth by sample, the colour once where any passes. The same
//! values as the general routine of [`super::samples`].

use super::fast::{BLEND, DEPTH};
use super::layout::*;
use super::plan::Plan;
use super::simd::{Simd, eight};
use super::small::{self, Covered, gather, scatter};
use super::store::{BIN_PIXELS, BinPixels};
use super::tile::LocalEdges;
use super::{blend, depth_stencil, fine::row8};
use crate::device::samples::{MAX_SAMPLES, positions};

/// Coverage of 8 x 8 pixels by sample: bit 8 * y + x.
pub type Masks = [u64; MAX_SAMPLES as usize];

/// Eight pixels of a bin, and where they lie on the surface.
struct Eight<S: Simd> {
    at: [u32; 8],
    x: S::F,
    y: S::F,
    /// By sample, as signs.
    covered: [S::I; MAX_SAMPLES as usize],
}

/// What the pixels of a triangle share.
pub struct Brush<'a> {
    plan: &'a Plan<'a>,
    samples: u32,
    planes: &'a [[f32; 4]],
    perspective: bool,
}

impl<'a> Brush<'a> {
    /// Of a triangle, on a surface with so many samples a pixel.
    #[inline(always)]
    pub fn new(plan: &'a Plan<'a>, t: &Triangle, planes: &'a [[f32; 4]], samples: u32) -> Brush<'a> {
        let k = plan.direct.unwrap_or(0);
        let perspective = plan.modes[k] == interpolation::PERSPECTIVE && t.flags & triangle_flags::PERSPECTIVE != 0;
        Brush { plan, samples, planes, perspective }
    }

    /// Draws a triangle that [`small::fits`]; false where it covers nothing of the bin.
    #[inline(always)]
    pub fn small<S: Simd>(&self, t: &Triangle, bin: &mut BinPixels) -> bool {
        let corner = small::corner(t);
        let place = [corner[0] - bin.origin[0], corner[1] - bin.origin[1]];
        let inside = small::inside(place);
        let centre = LocalEdges::<S>::new(t, corner[0], corner[1]);
        let (mut masks, mut any) = ([0; MAX_SAMPLES as usize], 0);
        for (mask, &at) in masks.iter_mut().zip(positions(self.samples)) {
            *mask = centre.sample(at).square() & inside;
            any |= *mask;
        }
        if any == 0 {
            return false;
        }
        let covered = Covered::new(any);
        for first in (0..covered.count).step_by(8) {
            let bytes = eight(&covered.at, first);
            let (at, [x, y]) = small::places::<S>(bytes, place, bin.origin);
            let mut pixels = Eight::<S> { at, x, y, covered: [S::i(0); MAX_SAMPLES as usize] };
            let packed = u64::from_le_bytes(*bytes);
            let rows = (packed >> 3 & 0x0707_0707_0707_0707).to_le_bytes();
            let columns = (packed & 0x0707_0707_0707_0707).to_le_bytes();
            let bit = S::permute(S::load_u(&[1, 2, 4, 8, 16, 32, 64, 128]), &columns);
            for s in 0..self.samples as usize {
                let row = S::permute(S::extend(&masks[s].to_le_bytes()), &rows);
                pixels.covered[s] = S::eq(S::and(row, bit), bit);
            }
            self.eight::<S, true>(&pixels, bin);
        }
        true
    }

    /// Draws what is covered of a tile whose first pixel is `at` in the bin and lies at `place` on the surface.
    #[inline(always)]
    pub fn tile<S: Simd>(&self, at: usize, place: [i32; 2], masks: &Masks, bin: &mut BinPixels) {
        let mut left = masks.iter().fold(0, |all, mask| all | mask);
        let x = S::add(S::f(place[0] as f32), S::load(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]));
        while left != 0 {
            let row = left.trailing_zeros() / 8;
            left &= !(0xff << (8 * row));
            let y = S::f((place[1] + row as i32) as f32);
            let mut pixels = Eight::<S> { at: [at as u32 + 8 * row; 8], x, y, covered: [S::i(0); MAX_SAMPLES as usize] };
            for s in 0..self.samples as usize {
                pixels.covered[s] = S::mask((masks[s] >> (8 * row)) as u32);
            }
            self.eight::<S, false>(&pixels, bin);
        }
    }

    /// Draws eight pixels: `APART` or in a row.
    #[inline(always)]
    fn eight<S: Simd, const APART: bool>(&self, pixels: &Eight<S>, bin: &mut BinPixels) {
        let Eight { at, x, y, covered } = pixels;
        let (x, y) = (*x, *y);
        let plan = self.plan;
        let &[head, tail] = self.planes.first_chunk().expect("planes of depth");
        let mut pass = *covered;
        let mut any = 0;
        for (s, &[dx, dy]) in positions(self.samples).iter().enumerate() {
            if plan.fast_samples & DEPTH != 0 && S::signs(pass[s]) != 0 {
                let (x, y) = (S::add(x, S::f(dx as f32 / 16.0)), S::add(y, S::f(dy as f32 / 16.0)));
                let z = S::add(S::fma(y, S::f(head[2]), S::fma(x, S::f(head[1]), S::f(head[0]))), S::f(tail[2]));
                let z = depth_stencil::quantize::<S>(z, plan.depth_range, plan.depth_scale);
                let words = &mut bin.depth_stencil[s * BIN_PIXELS..];
                let old = load::<S, APART>(words, at);
                let depth_bits = S::i(0xff_ffff);
                pass[s] = S::and(pass[s], S::gt(S::iadd(S::and(old, depth_bits), S::i(plan.depth_bias)), z));
                if S::signs(pass[s]) != 0 {
                    store::<S, APART>(S::select(pass[s], S::or(S::andnot(depth_bits, old), z), old), words, at);
                }
            }
            any |= S::signs(pass[s]);
        }
        if any == 0 {
            return;
        }
        let base = (DEPTH_PLANE_VEC4 + plan.direct.unwrap_or(0) as u32 * VARYING_PLANE_VEC4) as usize;
        let p: &[[f32; 4]; 3] = self.planes[base..base + 3].try_into().expect("three");
        let mut color = [S::f(0.0); 4];
        for c in 0..4 {
            color[c] = S::fma(y, S::f(p[2][c]), S::fma(x, S::f(p[1][c]), S::f(p[0][c])));
        }
        if self.perspective {
            let w = S::div(S::f(1.0), S::fma(y, S::f(tail[1]), S::fma(x, S::f(tail[0]), S::f(head[3]))));
            for c in &mut color {
                *c = S::mul(*c, w);
            }
        }
        let new = blend::quantize4::<S>(color);
        for s in 0..self.samples as usize {
            if S::signs(pass[s]) != 0 {
                let words = &mut bin.color[s * BIN_PIXELS..];
                let old = load::<S, APART>(words, at);
                let mut new = new;
                if plan.fast_samples & BLEND != 0 {
                    new = blend::pack::<S>(blend::over::<S>(blend::unpack::<S>(new), blend::unpack::<S>(old)));
                }
                store::<S, APART>(S::select(pass[s], new, old), words, at);
            }
        }
    }
}

/// A sample's words at eight pixels: `APART`, or in a row from the first on.
#[inline(always)]
fn load<S: Simd, const APART: bool>(words: &mut [u32], at: &[u32; 8]) -> S::I {
    if APART { gather::<S>(words.first_chunk().expect("a bin"), at) } else { S::load_u(row8(words, at[0] as usize)) }
}

/// The other way.
#[inline(always)]
fn store<S: Simd, const APART: bool>(v: S::I, words: &mut [u32], at: &[u32; 8]) {
    if APART { scatter::<S>(v, words.first_chunk_mut().expect("a bin"), at) } else { S::store_u(v, row8(words, at[0] as usize)) }
}
