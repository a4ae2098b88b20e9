//! The operations after a fragment's colour is known, on eight pixels of a row: alpha test, late depth and stencil tests, blending,
//! logic op and the write.

use super::fine::row8;
use super::layout::*;
use super::plan::Plan;
use super::simd::Simd;
use super::store::BinPixels;
use super::{blend, depth_stencil, formats};
use crate::device::{ColorFormat, SurfaceFormat};

/// Eight colours, in the form that the format wants.
pub struct Color<S: Simd> {
    /// Where [`ColorFormat::is_bytes`] holds.
    pub bytes: S::I,
    /// Where it does not.
    pub columns: [S::F; 4],
}

/// The operations after the colour is known.
#[inline(always)]
pub fn write<S: Simd>(
    plan: &Plan,
    format: SurfaceFormat,
    bin: &mut BinPixels,
    pixel: usize,
    front: bool,
    z: S::I,
    mut mask: S::I,
    color: Color<S>,
) {
    if let Some(keep) = passes_alpha::<S>(plan, format, &color) {
        mask = S::and(mask, keep);
    }
    if !plan.early && plan.tests {
        mask = depth_stencil::test::<S>(plan, front, z, mask, row8(bin.depth_stencil, pixel));
    }
    if S::signs(mask) != 0 && plan.write_mask != 0 {
        write_color::<S>(plan, format, bin, pixel, mask, &color);
    }
}

/// Alpha from 0 to 255, in the precision of the colour buffer.
#[inline(always)]
pub fn alpha<S: Simd>(format: SurfaceFormat, color: &Color<S>) -> S::I {
    if format.color.is_bytes() { S::shr::<24>(color.bytes) } else { blend::quantize::<S>(color.columns[3]) }
}

/// Lanes that pass the alpha test; `None` where there is none.
#[inline(always)]
pub fn passes_alpha<S: Simd>(plan: &Plan, format: SurfaceFormat, color: &Color<S>) -> Option<S::I> {
    let state = plan.state;
    if state.flags & fragment_flags::ALPHA_TEST == 0 {
        return None;
    }
    let alpha = alpha::<S>(format, color);
    let reference = blend::quantize::<S>(S::f(state.alpha_ref));
    Some(depth_stencil::compare_lanes::<S>(state.alpha_func, alpha, reference))
}

/// Blending, logic op and the write.
#[inline(always)]
pub fn write_color<S: Simd>(plan: &Plan, format: SurfaceFormat, bin: &mut BinPixels, pixel: usize, mask: S::I, color: &Color<S>) {
    if format.color.is_bytes() {
        return write_bytes::<S>(plan, format, bin, pixel, mask, color.bytes);
    }
    let mut columns = [[0.0; 8]; 4];
    for c in 0..4 {
        S::store(color.columns[c], &mut columns[c]);
    }
    formats::write(plan.state, format.color, bin.color, pixel, S::signs(mask), &columns);
}

/// Blends and writes colours of four bytes.
#[inline(always)]
fn write_bytes<S: Simd>(plan: &Plan, format: SurfaceFormat, bin: &mut BinPixels, pixel: usize, mask: S::I, color: S::I) {
    let state = plan.state;
    let pixels = row8(bin.color, pixel);
    let old = S::load_u(pixels);
    let opaque = S::i(0xff00_0000u32 as i32);
    let mut new = color;
    if state.flags & fragment_flags::BLEND != 0 {
        let d = if format.color == ColorFormat::Rgbx8 { S::or(old, opaque) } else { old };
        new = blend::pack::<S>(blend::blend::<S>(state, plan.constant, blend::unpack::<S>(color), blend::unpack::<S>(d)));
    } else if state.flags & fragment_flags::LOGIC_OP != 0 {
        new = blend::logic_op::<S>(state.logic_op, color, old);
    }
    if format.color == ColorFormat::Rgbx8 {
        new = S::or(new, opaque);
    }
    if plan.write_mask != !0 {
        let m = S::i(plan.write_mask as i32);
        new = S::or(S::and(new, m), S::andnot(m, old));
    }
    S::store_u(S::select(mask, new, old), pixels);
}
