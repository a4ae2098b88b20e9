//! Blending (4.1.8) and the logical operation (4.1.10).

use super::checks::{clamp01, put};
use super::enums::*;
use super::{Context, dirty};

impl Context {
    /// glBlendFunc.
    pub fn blend_func(&mut self, source: GLenum, destination: GLenum) {
        self.blend_func_separate(source, destination, source, destination);
    }

    /// glBlendFuncSeparate.
    pub fn blend_func_separate(&mut self, source_rgb: GLenum, destination_rgb: GLenum, source_alpha: GLenum, destination_alpha: GLenum) {
        let command = move |cx: &mut Context| cx.blend_func_separate(source_rgb, destination_rgb, source_alpha, destination_alpha);
        if self.compile(command) || self.inside_begin_end() {
            return;
        }
        let sources = [source_rgb, source_alpha].into_iter().all(|f| is_factor(f) || f == GL_SRC_ALPHA_SATURATE);
        let destinations = [destination_rgb, destination_alpha].into_iter().all(is_factor);
        if !sources || !destinations {
            return self.set_error(GL_INVALID_ENUM, "glBlendFunc");
        }
        let factors = [source_rgb, destination_rgb, source_alpha, destination_alpha];
        put(&mut self.state.color_buffer.blend_func, factors, &mut self.dirty, dirty::FRAGMENT);
    }

    /// glBlendEquation.
    pub fn blend_equation(&mut self, mode: GLenum) {
        self.blend_equation_separate(mode, mode);
    }

    /// glBlendEquationSeparate.
    pub fn blend_equation_separate(&mut self, rgb: GLenum, alpha: GLenum) {
        if self.compile(move |cx| cx.blend_equation_separate(rgb, alpha)) || self.inside_begin_end() {
            return;
        }
        let is_equation = |e| matches!(e, GL_FUNC_ADD | GL_FUNC_SUBTRACT | GL_FUNC_REVERSE_SUBTRACT | GL_MIN | GL_MAX);
        if !is_equation(rgb) || !is_equation(alpha) {
            return self.set_error(GL_INVALID_ENUM, "glBlendEquation");
        }
        put(&mut self.state.color_buffer.blend_equation, [rgb, alpha], &mut self.dirty, dirty::FRAGMENT);
    }

    /// glBlendColor. Clamped to [0, 1].
    pub fn blend_color(&mut self, red: f32, green: f32, blue: f32, alpha: f32) {
        if self.compile(move |cx| cx.blend_color(red, green, blue, alpha)) || self.inside_begin_end() {
            return;
        }
        put(&mut self.state.color_buffer.blend_color, [red, green, blue, alpha].map(clamp01), &mut self.dirty, dirty::FRAGMENT);
    }

    /// glLogicOp.
    pub fn logic_op(&mut self, op: GLenum) {
        if self.compile(move |cx| cx.logic_op(op)) || self.inside_begin_end() {
            return;
        }
        if !(GL_CLEAR..=GL_SET).contains(&op) {
            return self.set_error(GL_INVALID_ENUM, "glLogicOp");
        }
        put(&mut self.state.color_buffer.logic_op, op, &mut self.dirty, dirty::FRAGMENT);
    }
}

/// Factors that are legal for source and destination (1.4: colours on both sides).
fn is_factor(factor: GLenum) -> bool {
    matches!(
        factor,
        GL_ZERO | GL_ONE | GL_SRC_COLOR..=GL_ONE_MINUS_DST_COLOR | GL_CONSTANT_COLOR..=GL_ONE_MINUS_CONSTANT_ALPHA
    )
}
