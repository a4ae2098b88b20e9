//! Stencil and depth tests on eight pixels of a row.

use super::layout::*;
use super::plan::Plan;
use super::simd::Simd;

/// Compares `a` with `b` by `func` (both below 2^31): lanes where it holds.
#[inline(always)]
pub fn compare_lanes<S: Simd>(func: u32, a: S::I, b: S::I) -> S::I {
    let all = S::i(-1);
    match func {
        compare::NEVER => S::i(0),
        compare::LESS => S::gt(b, a),
        compare::EQUAL => S::eq(a, b),
        compare::LEQUAL => S::xor(S::gt(a, b), all),
        compare::GREATER => S::gt(a, b),
        compare::NOTEQUAL => S::xor(S::eq(a, b), all),
        compare::GEQUAL => S::xor(S::gt(b, a), all),
        _ => all,
    }
}

/// Window z to the integers of a depth buffer.
#[inline(always)]
pub fn quantize<S: Simd>(z: S::F, range: [f32; 2], scale: f32) -> S::I {
    S::round(S::mul(S::clamp(z, S::f(range[0]), S::f(range[1])), S::f(scale)))
}

/// Window z to the word of any depth buffer.
#[inline(always)]
pub fn word<S: Simd>(plan: &Plan, z: S::F) -> S::I {
    if !plan.depth_format.is_float() {
        return quantize::<S>(z, plan.depth_range, plan.depth_scale);
    }
    // Its bits. Numbers below the normal ones become zero, as on a device that has none.
    let bits = S::bits(S::clamp(z, S::f(plan.depth_range[0]), S::f(plan.depth_range[1])));
    S::and(bits, S::gt(bits, S::i(0x7f_ffff)))
}

/// Applies a stencil operation to stencil values 0 to 255.
#[inline(always)]
fn operate<S: Simd>(op: u32, stencil: S::I, reference: S::I) -> S::I {
    let (one, most) = (S::i(1), S::i(255));
    match op {
        stencil_op::ZERO => S::i(0),
        stencil_op::REPLACE => reference,
        stencil_op::INCR => S::iadd(stencil, S::and(S::gt(most, stencil), one)),
        stencil_op::DECR => S::isub(stencil, S::and(S::gt(stencil, S::i(0)), one)),
        stencil_op::INVERT => S::xor(stencil, most),
        stencil_op::INCR_WRAP => S::and(S::iadd(stencil, one), most),
        stencil_op::DECR_WRAP => S::and(S::isub(stencil, one), most),
        _ => stencil,
    }
}

/// Stencil test, depth test and their writes. `z`: words of depth; returns the lanes that pass both.
#[inline(always)]
pub fn test<S: Simd>(plan: &Plan, front: bool, z: S::I, mask: S::I, pixels: &mut [u32; 8]) -> S::I {
    let state = plan.state;
    let depth_bits = S::i(plan.depth_format.mask() as i32);
    let old = S::load_u(pixels);
    let old_z = S::and(old, depth_bits);
    if state.flags & fragment_flags::STENCIL_TEST == 0 {
        if state.flags & fragment_flags::DEPTH_TEST == 0 {
            return mask;
        }
        let pass = S::and(mask, compare_lanes::<S>(state.depth_func, z, old_z));
        if state.flags & fragment_flags::DEPTH_WRITE != 0 {
            let new = S::or(S::andnot(depth_bits, old), z);
            S::store_u(S::select(pass, new, old), pixels);
        }
        return pass;
    }
    let face = &state.stencil[!front as usize];
    let old_s = S::shr::<24>(old);
    let (reference, read) = (S::i(face.reference as i32), S::i(face.read_mask as i32));
    let stencil_pass = compare_lanes::<S>(face.func, S::and(reference, read), S::and(old_s, read));
    let (depth_pass, depth_write) = if state.flags & fragment_flags::DEPTH_TEST != 0 {
        (compare_lanes::<S>(state.depth_func, z, old_z), state.flags & fragment_flags::DEPTH_WRITE != 0)
    } else {
        (S::i(-1), false)
    };
    let on_fail = operate::<S>(face.ops[0], old_s, reference);
    let on_depth_fail = operate::<S>(face.ops[1], old_s, reference);
    let on_pass = operate::<S>(face.ops[2], old_s, reference);
    let new_s = S::select(stencil_pass, S::select(depth_pass, on_pass, on_depth_fail), on_fail);
    let write = S::i(face.write_mask as i32 & 0xff);
    let new_s = S::or(S::and(new_s, write), S::andnot(write, old_s));
    let pass = S::and(S::and(mask, stencil_pass), depth_pass);
    let new_z = if depth_write { S::select(pass, z, old_z) } else { old_z };
    let new = S::or(S::shl::<24>(new_s), new_z);
    S::store_u(S::select(mask, new, old), pixels);
    pass
}
