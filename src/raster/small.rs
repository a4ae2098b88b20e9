//! Triangles of at most 8 x 8 pixels: coverage of the whole box as 64 bits at once, then eight covered pixels a vector, from
//! whichever rows and tiles they are. A row of a tile would be mostly empty, and each turn of a loop over rows and tiles a guess of the
//! processor's that goes wrong. The same values as [`super::fast`], whose states these are.

use super::fast::{BLEND, DEPTH};
use super::layout::*;
use super::plan::Plan;
use super::simd::{SET_LANES, Simd, eight, eight_mut};
use super::store::{BIN_PIXELS, BinPixels};
use super::tile::{FULL, LocalEdges, rectangle_mask};
use super::{blend, depth_stencil};

/// Whether a triangle is small: not more than eight columns and rows of samples, and nothing but its edges says which are covered.
#[inline(always)]
pub fn fits(plan: &Plan, t: &Triangle) -> bool {
    let stippled = plan.stipple.is_some() && t.flags & triangle_flags::POLYGON != 0;
    // Last minus first: no half borrows from the other.
    let more_than_eight = |span: u32| (span >> 16) - (span & 0xffff) > 7;
    !(stippled || t.flags & triangle_flags::CUT != 0 || more_than_eight(t.columns) || more_than_eight(t.rows))
}

/// The covered pixels of a box: 8 * row + column of each, and after them, to fill a vector, the first of the last eight again.
pub struct Covered {
    /// See above.
    pub at: [u8; 64 + 8],
    /// How many there are.
    pub count: usize,
}

impl Covered {
    /// From a mask of bits 8 * row + column.
    #[inline(always)]
    pub fn new(mask: u64) -> Covered {
        let mut covered = Covered { at: [0; 72], count: 0 };
        for row in 0..8 {
            let bits = (mask >> (8 * row)) as usize & 0xff;
            let columns = u64::from_le_bytes(SET_LANES[bits]);
            let here = columns.wrapping_add(0x0808_0808_0808_0808 * row);
            *eight_mut(&mut covered.at, covered.count) = here.to_le_bytes();
            covered.count += bits.count_ones() as usize;
        }
        let last = covered.count.saturating_sub(1) & !7;
        let again = covered.at[last];
        *eight_mut(&mut covered.at, covered.count) = [again; 8];
        covered
    }
}

/// The first pixel of a small triangle's box, on the surface.
#[inline(always)]
pub fn corner(t: &Triangle) -> [i32; 2] {
    [(t.columns & 0xffff) as i32, (t.rows & 0xffff) as i32]
}

/// The part of a box that lies in the bin, given its first pixel from the bin's; the rest lies in the next bins.
#[inline(always)]
pub fn inside([x, y]: [i32; 2]) -> u64 {
    const LAST: i32 = BIN_SIZE as i32 - 1;
    if (x | y | (LAST - 7 - x) | (LAST - 7 - y)) < 0 { rectangle_mask(x, y, (0, LAST), (0, LAST)) } else { FULL }
}

/// Eight pixels of a box: their places in the bin, and x and y on the surface. `first`: the box's first pixel from the bin's.
#[inline(always)]
pub fn places<S: Simd>(pixels: &[u8; 8], first: [i32; 2], origin: [i32; 2]) -> ([u32; 8], [S::F; 2]) {
    let pixels = S::extend(pixels);
    let seven = S::i(7);
    let x = S::iadd(S::i(first[0]), S::and(pixels, seven));
    let y = S::iadd(S::i(first[1]), S::shr::<3>(pixels));
    let tile = S::or(S::shl::<9>(S::shr::<3>(y)), S::shl::<6>(S::shr::<3>(x)));
    let mut at = [0; 8];
    S::store_u(S::or(tile, S::or(S::shl::<3>(S::and(y, seven)), S::and(x, seven))), &mut at);
    (at, [S::to_f(S::iadd(x, S::i(origin[0]))), S::to_f(S::iadd(y, S::i(origin[1])))])
}

/// Words at eight pixels of a bin.
#[inline(always)]
pub fn gather<S: Simd>(words: &[u32; BIN_PIXELS], at: &[u32; 8]) -> S::I {
    let word = |k: usize| words[at[k] as usize % BIN_PIXELS];
    S::load_u(&[word(0), word(1), word(2), word(3), word(4), word(5), word(6), word(7)])
}

/// The other way. Where a pixel is there twice, so is its word.
#[inline(always)]
pub fn scatter<S: Simd>(v: S::I, words: &mut [u32; BIN_PIXELS], at: &[u32; 8]) {
    let mut values = [0; 8];
    S::store_u(v, &mut values);
    for k in 0..8 {
        words[at[k] as usize % BIN_PIXELS] = values[k];
    }
}

/// Draws a triangle that [`fits`]; false where it covers nothing of the bin.
#[inline(always)]
pub fn draw<S: Simd, const MODE: u32>(plan: &Plan, t: &Triangle, planes: &[[f32; 4]], bin: &mut BinPixels) -> bool {
    let corner = corner(t);
    let place = [corner[0] - bin.origin[0], corner[1] - bin.origin[1]];
    let mask = LocalEdges::<S>::new(t, corner[0], corner[1]).square() & inside(place);
    if mask == 0 {
        return false;
    }
    let covered = Covered::new(mask);
    let k = plan.direct.unwrap_or(0);
    let base = (DEPTH_PLANE_VEC4 + k as u32 * VARYING_PLANE_VEC4) as usize;
    let p: &[[f32; 4]; 3] = planes[base..base + 3].try_into().expect("three");
    let &[head, tail] = planes.first_chunk().expect("planes of depth");
    let perspective = plan.modes[k] == interpolation::PERSPECTIVE && t.flags & triangle_flags::PERSPECTIVE != 0;
    let pixels: &mut [u32; BIN_PIXELS] = bin.color.first_chunk_mut().expect("a bin");
    for first in (0..covered.count).step_by(8) {
        let (at, [x, y]) = places::<S>(eight(&covered.at, first), place, bin.origin);
        let mut pass = S::i(-1);
        if MODE & DEPTH != 0 {
            let words: &mut [u32; BIN_PIXELS] = bin.depth_stencil.first_chunk_mut().expect("a bin");
            let z = S::add(S::fma(y, S::f(head[2]), S::fma(x, S::f(head[1]), S::f(head[0]))), S::f(tail[2]));
            let z = depth_stencil::quantize::<S>(z, plan.depth_range, plan.depth_scale);
            let old = gather::<S>(words, &at);
            let depth_bits = S::i(0xff_ffff);
            pass = S::gt(S::iadd(S::and(old, depth_bits), S::i(plan.depth_bias)), z);
            if S::signs(pass) == 0 {
                continue;
            }
            scatter::<S>(S::select(pass, S::or(S::andnot(depth_bits, old), z), old), words, &at);
        }
        let mut color = [S::f(0.0); 4];
        for c in 0..4 {
            color[c] = S::fma(y, S::f(p[2][c]), S::fma(x, S::f(p[1][c]), S::f(p[0][c])));
        }
        if perspective {
            let w = S::div(S::f(1.0), S::fma(y, S::f(tail[1]), S::fma(x, S::f(tail[0]), S::f(head[3]))));
            for c in &mut color {
                *c = S::mul(*c, w);
            }
        }
        let mut new = blend::quantize4::<S>(color);
        if MODE & (DEPTH | BLEND) != 0 {
            let old = gather::<S>(pixels, &at);
            if MODE & BLEND != 0 {
                new = blend::pack::<S>(blend::over::<S>(blend::unpack::<S>(new), blend::unpack::<S>(old)));
            }
            new = S::select(pass, new, old);
        }
        scatter::<S>(new, pixels, &at);
    }
    true
}
