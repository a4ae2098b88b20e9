//! The commonest fragments, without detours: the colour is a varying, RGBA8 is written whole, depth is LESS or LEQUAL
//! with writes or not there at all, blending is SRC_ALPHA, ONE_MINUS_SRC_ALPHA or off. The same values as the general
//! routine of [`super::fine`]; what does not change within a tile is computed once.

use super::fine::{Plan, lanes, row8};
use super::layout::*;
use super::simd::Simd;
use super::store::BinPixels;
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

/// Which routine serves a state. `direct`: the colour is a varying.
pub fn choose(state: &FragmentState, format: SurfaceFormat, direct: bool, write_mask: u32) -> u32 {
    // By name: a glob import would hide this module's `BLEND`.
    use fragment_flags::{ALPHA_TEST, DEPTH_TEST, DEPTH_WRITE, LOGIC_OP, STENCIL_TEST};
    if !direct || format.color != ColorFormat::Rgba8 || write_mask != !0 || state.flags & (STENCIL_TEST | ALPHA_TEST | LOGIC_OP) != 0 {
        return NONE;
    }
    let mut mode = 0;
    if state.flags & DEPTH_TEST != 0 {
        if !matches!(state.depth_func, compare::LESS | compare::LEQUAL) || state.flags & DEPTH_WRITE == 0 {
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
    if mode == 0 { COPY } else { mode }
}

/// The covered pixels of a tile whose first pixel is `at` in the bin and `place` on the surface.
#[inline(always)]
pub fn tile<S: Simd, const MODE: u32>(
    plan: &Plan,
    t: &Triangle,
    planes: &[[f32; 4]],
    bin: &mut BinPixels,
    at: usize,
    place: [i32; 2],
    mut mask: u64,
) {
    let k = plan.direct.unwrap_or(0);
    let base = (DEPTH_PLANE_VEC4 + k as u32 * VARYING_PLANE_VEC4) as usize;
    let p: &[[f32; 4]; 3] = planes[base..base + 3].try_into().expect("three");
    let (head, tail) = (planes[0], planes[1]);
    let perspective = plan.modes[k] == interpolation::PERSPECTIVE && t.flags & triangle_flags::PERSPECTIVE != 0;
    let x = S::add(S::f(place[0] as f32), S::load(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]));
    let zx = S::fma(x, S::f(head[1]), S::f(head[0]));
    let wx = S::fma(x, S::f(tail[0]), S::f(head[3]));
    let mut cx = [S::f(0.0); 4];
    for c in 0..4 {
        cx[c] = S::fma(x, S::f(p[1][c]), S::f(p[0][c]));
    }
    while mask != 0 {
        let row = mask.trailing_zeros() / 8;
        let bits = (mask >> (8 * row)) as u32 & 0xff;
        mask &= !(0xff << (8 * row));
        let pixel = at + row as usize * 8;
        let y = S::f((place[1] + row as i32) as f32);
        let mut live = lanes::<S>(bits);
        if MODE & DEPTH != 0 {
            let z = S::add(S::fma(y, S::f(head[2]), zx), S::f(tail[2]));
            let z = depth_stencil::quantize::<S>(z, plan.depth_range, plan.depth_scale);
            let words = row8(bin.depth_stencil, pixel);
            let old = S::load_u(words);
            let old_z = S::and(old, S::i(0xff_ffff));
            live = S::and(live, S::gt(S::iadd(old_z, S::i(plan.depth_bias)), z));
            if S::signs(live) == 0 {
                continue;
            }
            S::store_u(S::select(live, S::or(S::andnot(S::i(0xff_ffff), old), z), old), words);
        }
        let mut color = cx;
        for c in 0..4 {
            color[c] = S::fma(y, S::f(p[2][c]), color[c]);
        }
        if perspective {
            let reciprocal = S::div(S::f(1.0), S::fma(y, S::f(tail[1]), wx));
            for c in &mut color {
                *c = S::mul(*c, reciprocal);
            }
        }
        let words = row8(bin.color, pixel);
        let old = S::load_u(words);
        let s = blend::quantize4::<S>(color);
        let new = if MODE & BLEND != 0 { blend::over::<S>(s, blend::unpack::<S>(old)) } else { s };
        S::store_u(S::select(live, blend::pack::<S>(new), old), words);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::device::DepthFormat;
    use bytemuck::Zeroable;

    #[test]
    fn every_routine_serves_its_state() {
        let format = SurfaceFormat { color: ColorFormat::Rgba8, depth: DepthFormat::D24, stencil: true, top_first: true };
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
            assert_eq!(choose(&state, format, true, !0), routine, "flags {flags:#x}");
            assert_eq!(choose(&state, format, false, !0), NONE);
        }
    }
}
