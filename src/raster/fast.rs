//! The commonest fragments, without detours: the colour is a varying, RGBA8 is written whole, depth is LESS or LEQUAL
//! with writes or not there at all, blending is SRC_ALPHA, ONE_MINUS_SRC_ALPHA or off. The same values as the general
//! routine of [`super::fine`]; what does not change within a tile is computed once.

use super::fine::row8;
use super::layout::*;
use super::plan::Plan;
use super::simd::{Simd, columns_from};
use super::store::BinPixels;
use super::tile::{FULL, TileRows};
use super::{blend, depth_stencil};
use crate::device::{ColorFormat, SurfaceFormat};

/// The general routine.
pub const NONE: u32 = 0;
/// Depth test and write, colour replaced.
pub const DEPTH: u32 = 1;
/// No test, colour blended.
pub const BLEND: u32 = 2;
/// Depth test and write, colour blended.
pub const DEPTH_BLEND: u32 = DEPTH | BLEND;
/// No test, colour replaced.
pub const COPY: u32 = 4;
/// Flag: the colour is a varying times a texel.
pub const TEXTURE: u32 = 8;
/// See [`super::textured`].
pub const TEXTURED_DEPTH: u32 = TEXTURE | DEPTH;
/// See [`super::textured`].
pub const TEXTURED_COPY: u32 = TEXTURE | COPY;

/// Which routine serves a state. `direct`: the colour is a varying; `modulate`: that times a texel.
pub fn choose(state: &FragmentState, format: SurfaceFormat, [direct, modulate]: [bool; 2], write_mask: u32) -> u32 {
    // By name: a glob import would hide this module's `BLEND`.
    use fragment_flags::{ALPHA_TEST, DEPTH_TEST, DEPTH_WRITE, LOGIC_OP, STENCIL_TEST};
    if !(direct || modulate)
        || format.color != ColorFormat::Rgba8
        || write_mask != !0
        || state.flags & (STENCIL_TEST | ALPHA_TEST | LOGIC_OP) != 0
    {
        return NONE;
    }
    let mut mode = 0;
    if state.flags & DEPTH_TEST != 0 {
        if format.depth.is_float() || !matches!(state.depth_func, compare::LESS | compare::LEQUAL) || state.flags & DEPTH_WRITE == 0 {
            return NONE;
        }
        mode |= DEPTH;
    }
    if state.flags & fragment_flags::BLEND != 0 {
        let (s, d) = (blend_factor::SRC_ALPHA, blend_factor::ONE_MINUS_SRC_ALPHA);
        if state.blend_factors != [s, d, s, d] || state.blend_equations != [blend_equation::ADD; 2] {
            return NONE;
        }
        mode |= BLEND;
    }
    if mode == 0 {
        mode = COPY;
    }
    match (direct, mode) {
        (true, _) => mode,
        (false, DEPTH | COPY) => mode | TEXTURE,
        (false, _) => NONE,
    }
}

/// A tile under a triangle.
pub struct Tile<S: Simd> {
    /// Its first pixel in the bin.
    pub at: usize,
    /// Its first pixel on the surface.
    pub place: [i32; 2],
    /// The edge functions from row `first` on.
    pub edges: TileRows<S>,
    /// First and last row that samples may lie in.
    pub rows: [i32; 2],
    /// Samples that may be drawn at all: the scissor and the polygon stipple.
    pub allowed: u64,
}

/// Depth along rows.
pub struct DepthRow<'a, S: Simd> {
    /// At row 0 of the surface.
    across: S::F,
    /// Planes of depth.
    head: &'a [[f32; 4]; 2],
}

impl<'a, S: Simd> DepthRow<'a, S> {
    /// Of a triangle with such planes, at columns x.
    #[inline(always)]
    pub fn new(planes: &'a [[f32; 4]], x: S::F) -> Self {
        let head: &[[f32; 4]; 2] = planes.first_chunk().expect("planes of depth");
        DepthRow { across: S::fma(x, S::f(head[0][1]), S::f(head[0][0])), head }
    }

    /// Tests row y and writes what passes. Returns what is outside or fails, as signs.
    #[inline(always)]
    pub fn test(&self, plan: &Plan, y: S::F, outside: S::I, words: &mut [u32; 8]) -> S::I {
        let z = S::add(S::fma(y, S::f(self.head[0][2]), self.across), S::f(self.head[1][2]));
        let z = depth_stencil::quantize::<S>(z, plan.depth_range, plan.depth_scale);
        let old = S::load_u(words);
        let old_z = S::and(old, S::i(0xff_ffff));
        // Not less, of integers: greater than what is one less.
        let outside = S::or(outside, S::gt(z, S::iadd(old_z, S::i(plan.depth_bias - 1))));
        S::store_u(S::select(outside, old, S::or(S::andnot(S::i(0xff_ffff), old), z)), words);
        outside
    }
}

/// What colours a tile's rows.
struct Colors<'a, S: Simd> {
    /// Planes of the colour, at row 0 of the surface and by row.
    across: [S::F; 4],
    down: &'a [f32; 4],
    perspective: bool,
}

impl<S: Simd> Colors<'_, S> {
    /// Writes a row's pixels that are not `outside`.
    #[inline(always)]
    fn write<const MODE: u32>(&self, y: S::F, reciprocal: S::F, outside: S::I, pixels: &mut [u32; 8]) {
        let mut color = self.across;
        for c in 0..4 {
            color[c] = S::fma(y, S::f(self.down[c]), color[c]);
        }
        if self.perspective {
            for c in &mut color {
                *c = S::mul(*c, reciprocal);
            }
        }
        let old = S::load_u(pixels);
        let mut new = blend::quantize4::<S>(color);
        if MODE & BLEND != 0 {
            new = blend::pack::<S>(blend::over::<S>(blend::unpack::<S>(new), blend::unpack::<S>(old)));
        }
        S::store_u(S::select(outside, old, new), pixels);
    }
}

/// w along a row, from the plane of 1/w.
#[inline(always)]
fn over_w<S: Simd>(row: i32, down: f32, across: S::F) -> S::F {
    S::div(S::f(1.0), S::fma(S::f(row as f32), S::f(down), across))
}

/// Draws the covered pixels of a tile: the rows that were written; `None` where nothing is covered.
#[inline(always)]
pub fn tile<S: Simd, const MODE: u32>(plan: &Plan, t: &Triangle, planes: &[[f32; 4]], bin: &mut BinPixels, tile: Tile<S>) -> Option<u32> {
    let Tile { at, place, mut edges, rows: [first, last], allowed } = tile;
    let k = plan.direct.unwrap_or(0);
    let base = (DEPTH_PLANE_VEC4 + k as u32 * VARYING_PLANE_VEC4) as usize;
    let p: &[[f32; 4]; 3] = planes[base..base + 3].try_into().expect("three");
    let (head, tail) = (planes[0], planes[1]);
    let x = columns_from::<S>(place[0] as f32);
    let depth = DepthRow::<S>::new(planes, x);
    let wx = S::fma(x, S::f(tail[0]), S::f(head[3]));
    let perspective = plan.modes[k] == interpolation::PERSPECTIVE && t.flags & triangle_flags::PERSPECTIVE != 0;
    let mut colors = Colors::<S> { across: [S::f(0.0); 4], down: &p[2], perspective };
    for c in 0..4 {
        colors.across[c] = S::fma(x, S::f(p[1][c]), S::f(p[0][c]));
    }
    let (mut touched, mut written) = (false, 0);
    // Without a test every row is written, and 1/w is asked for a row ahead: a division takes longer than the processor looks ahead
    // past a row's other work.
    let ahead = perspective && MODE & DEPTH == 0;
    let mut next = if ahead { over_w::<S>(place[1] + first, tail[1], wx) } else { S::f(1.0) };
    for row in first..=last {
        let mut reciprocal = next;
        if ahead {
            next = over_w::<S>(place[1] + row + 1, tail[1], wx);
        }
        // Only signs count in a mask: they are what `select` and `signs` look at.
        let mut outside = edges.next_row();
        if allowed != FULL {
            outside = S::or(outside, S::mask(!(allowed >> (8 * row)) as u32));
        }
        if S::signs(outside) == 0xff {
            continue;
        }
        touched = true;
        let pixel = at + row as usize * 8;
        let y = S::f((place[1] + row) as f32);
        if MODE & DEPTH != 0 {
            outside = depth.test(plan, y, outside, row8(bin.depth_stencil, pixel));
            if S::signs(outside) == 0xff {
                continue;
            }
        }
        if perspective && !ahead {
            reciprocal = over_w::<S>(place[1] + row, tail[1], wx);
        }
        written += 1;
        colors.write::<MODE>(y, reciprocal, outside, row8(bin.color, pixel));
    }
    touched.then_some(written)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::device::DepthFormat;
    use bytemuck::Zeroable;

    #[test]
    fn every_routine_serves_its_state() {
        let format = SurfaceFormat { color: ColorFormat::Rgba8, depth: DepthFormat::D24, stencil: true, top_first: true, samples: 1 };
        let plain = FragmentState { color_mask: 15, ..FragmentState::zeroed() };
        let depth = fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE;
        let (s, d) = (blend_factor::SRC_ALPHA, blend_factor::ONE_MINUS_SRC_ALPHA);
        for (flags, routine) in [
            (0, COPY),
            (depth, DEPTH),
            (fragment_flags::BLEND, BLEND),
            (depth | fragment_flags::BLEND, DEPTH_BLEND),
            (fragment_flags::LOGIC_OP, NONE),
        ] {
            let state = FragmentState { flags, depth_func: compare::LESS, blend_factors: [s, d, s, d], ..plain };
            assert_eq!(choose(&state, format, [true, false], !0), routine, "flags {flags:#x}");
            assert_eq!(choose(&state, format, [false; 2], !0), NONE);
            let textured = if matches!(routine, DEPTH | COPY) { routine | TEXTURE } else { NONE };
            assert_eq!(choose(&state, format, [false, true], !0), textured, "flags {flags:#x}");
        }
    }
}
