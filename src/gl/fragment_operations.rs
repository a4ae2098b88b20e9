//! Per-fragment operations (4.1) and the fine control of buffer updates (4.2.2), with the clear values (4.2.3).

use super::checks::{clamp01, clamp01_f64, faces, is_compare_func, put};
use super::enums::*;
use super::{Context, dirty};

impl Context {
    /// glAlphaFunc. The reference is clamped to [0, 1].
    pub fn alpha_func(&mut self, func: GLenum, reference: f32) {
        if self.compile(move |cx| cx.alpha_func(func, reference)) || self.inside_begin_end() {
            return;
        }
        if !is_compare_func(func) {
            return self.set_error(GL_INVALID_ENUM, "glAlphaFunc");
        }
        let color = &mut self.state.color_buffer;
        put(&mut color.alpha_func, func, &mut self.dirty, dirty::FRAGMENT);
        put(&mut color.alpha_ref, clamp01(reference), &mut self.dirty, dirty::FRAGMENT);
    }

    /// glStencilFunc: both faces.
    pub fn stencil_func(&mut self, func: GLenum, reference: i32, mask: u32) {
        self.stencil_func_separate(GL_FRONT_AND_BACK, func, reference, mask);
    }

    /// glStencilFuncSeparate.
    pub fn stencil_func_separate(&mut self, face: GLenum, func: GLenum, reference: i32, mask: u32) {
        if self.compile(move |cx| cx.stencil_func_separate(face, func, reference, mask)) || self.inside_begin_end() {
            return;
        }
        let (Some(range), true) = (faces(face), is_compare_func(func)) else {
            return self.set_error(GL_INVALID_ENUM, "glStencilFunc");
        };
        for side in &mut self.state.stencil.sides[range] {
            put(&mut side.func, func, &mut self.dirty, dirty::FRAGMENT);
            put(&mut side.reference, reference, &mut self.dirty, dirty::FRAGMENT);
            put(&mut side.value_mask, mask, &mut self.dirty, dirty::FRAGMENT);
        }
    }

    /// glStencilOp: both faces.
    pub fn stencil_op(&mut self, fail: GLenum, depth_fail: GLenum, depth_pass: GLenum) {
        self.stencil_op_separate(GL_FRONT_AND_BACK, fail, depth_fail, depth_pass);
    }

    /// glStencilOpSeparate.
    pub fn stencil_op_separate(&mut self, face: GLenum, fail: GLenum, depth_fail: GLenum, depth_pass: GLenum) {
        if self.compile(move |cx| cx.stencil_op_separate(face, fail, depth_fail, depth_pass)) || self.inside_begin_end() {
            return;
        }
        let is_op = |op| matches!(op, GL_KEEP | GL_ZERO | GL_REPLACE | GL_INCR | GL_DECR | GL_INVERT | GL_INCR_WRAP | GL_DECR_WRAP);
        let (Some(range), true) = (faces(face), [fail, depth_fail, depth_pass].into_iter().all(is_op)) else {
            return self.set_error(GL_INVALID_ENUM, "glStencilOp");
        };
        for side in &mut self.state.stencil.sides[range] {
            put(&mut side.fail, fail, &mut self.dirty, dirty::FRAGMENT);
            put(&mut side.depth_fail, depth_fail, &mut self.dirty, dirty::FRAGMENT);
            put(&mut side.depth_pass, depth_pass, &mut self.dirty, dirty::FRAGMENT);
        }
    }

    /// glStencilMask: both faces.
    pub fn stencil_mask(&mut self, mask: u32) {
        self.stencil_mask_separate(GL_FRONT_AND_BACK, mask);
    }

    /// glStencilMaskSeparate.
    pub fn stencil_mask_separate(&mut self, face: GLenum, mask: u32) {
        if self.compile(move |cx| cx.stencil_mask_separate(face, mask)) || self.inside_begin_end() {
            return;
        }
        let Some(range) = faces(face) else {
            return self.set_error(GL_INVALID_ENUM, "glStencilMaskSeparate");
        };
        for side in &mut self.state.stencil.sides[range] {
            put(&mut side.write_mask, mask, &mut self.dirty, dirty::FRAGMENT);
        }
    }

    /// glDepthFunc.
    pub fn depth_func(&mut self, func: GLenum) {
        if self.compile(move |cx| cx.depth_func(func)) || self.inside_begin_end() {
            return;
        }
        if !is_compare_func(func) {
            return self.set_error(GL_INVALID_ENUM, "glDepthFunc");
        }
        put(&mut self.state.depth.func, func, &mut self.dirty, dirty::FRAGMENT);
    }

    /// glDepthMask.
    pub fn depth_mask(&mut self, flag: bool) {
        if self.compile(move |cx| cx.depth_mask(flag)) || self.inside_begin_end() {
            return;
        }
        put(&mut self.state.depth.write, flag, &mut self.dirty, dirty::FRAGMENT);
    }

    /// glColorMask.
    pub fn color_mask(&mut self, red: bool, green: bool, blue: bool, alpha: bool) {
        if self.compile(move |cx| cx.color_mask(red, green, blue, alpha)) || self.inside_begin_end() {
            return;
        }
        put(&mut self.state.color_buffer.color_mask, [red, green, blue, alpha], &mut self.dirty, dirty::FRAGMENT);
    }

    /// glIndexMask: state only, there are no colour-index buffers.
    pub fn index_mask(&mut self, mask: u32) {
        if self.compile(move |cx| cx.index_mask(mask)) || self.inside_begin_end() {
            return;
        }
        self.state.color_buffer.index_mask = mask;
    }

    /// glClearColor. Clamped to [0, 1].
    pub fn clear_color(&mut self, red: f32, green: f32, blue: f32, alpha: f32) {
        if self.compile(move |cx| cx.clear_color(red, green, blue, alpha)) || self.inside_begin_end() {
            return;
        }
        self.state.color_buffer.clear_color = [red, green, blue, alpha].map(clamp01);
    }

    /// glClearIndex: state only.
    pub fn clear_index(&mut self, index: f32) {
        if self.compile(move |cx| cx.clear_index(index)) || self.inside_begin_end() {
            return;
        }
        self.state.color_buffer.clear_index = index;
    }

    /// glClearDepth. Clamped to [0, 1].
    pub fn clear_depth(&mut self, depth: f64) {
        if self.compile(move |cx| cx.clear_depth(depth)) || self.inside_begin_end() {
            return;
        }
        self.state.depth.clear = clamp01_f64(depth);
    }

    /// glClearStencil. Masked to the buffer's bits only when it is used.
    pub fn clear_stencil(&mut self, s: i32) {
        if self.compile(move |cx| cx.clear_stencil(s)) || self.inside_begin_end() {
            return;
        }
        self.state.stencil.clear = s;
    }

    /// glClearAccum. Clamped to [-1, 1].
    pub fn clear_accum(&mut self, red: f32, green: f32, blue: f32, alpha: f32) {
        if self.compile(move |cx| cx.clear_accum(red, green, blue, alpha)) || self.inside_begin_end() {
            return;
        }
        self.state.accum_clear = [red, green, blue, alpha].map(|v| v.max(-1.0).min(1.0));
    }

    /// glSampleCoverage. Clamped to [0, 1].
    pub fn sample_coverage(&mut self, value: f32, invert: bool) {
        if self.compile(move |cx| cx.sample_coverage(value, invert)) || self.inside_begin_end() {
            return;
        }
        put(&mut self.state.multisample.coverage_value, clamp01(value), &mut self.dirty, dirty::FRAGMENT);
        put(&mut self.state.multisample.coverage_invert, invert, &mut self.dirty, dirty::FRAGMENT);
    }
}
