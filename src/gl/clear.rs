//! The whole framebuffer: clearing, viewport, depth range, scissor, and the commands that make results visible (2.11.1, 4.1.2, 4.2.3,
//! 5.5, 5.6).

use super::enums::*;
use super::{Context, dirty};
use crate::device::DepthFormat;
use crate::draw::Clear;

impl Context {
    /// glClear.
    pub fn clear(&mut self, mask: u32) {
        if self.compile(move |cx| cx.clear(mask)) || self.inside_begin_end() {
            return;
        }
        if mask & !(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT | GL_ACCUM_BUFFER_BIT) != 0 {
            return self.set_error(GL_INVALID_VALUE, "glClear: mask");
        }
        if !self.can_draw("glClear") || self.render_mode != GL_RENDER || !self.has_draw_surface() {
            return;
        }
        let (min, max) = self.drawable_rectangle();
        if min[0] >= max[0] || min[1] >= max[1] {
            return;
        }
        let state = &self.state;
        let color = &state.color_buffer;
        let format = self.draw_format();
        let color_mask = if mask & GL_COLOR_BUFFER_BIT != 0 { self.color_write_mask() } else { 0 };
        let has_depth = format.depth != DepthFormat::None;
        let depth = (mask & GL_DEPTH_BUFFER_BIT != 0 && state.depth.write && has_depth).then_some(state.depth.clear);
        let stencil = (mask & GL_STENCIL_BUFFER_BIT != 0 && format.stencil)
            .then(|| (state.stencil.clear as u8, state.stencil.sides[0].write_mask as u8));
        if color_mask != 0 || depth.is_some() || stencil.is_some() {
            self.recorder.clear(Clear { min, max, color: color.clear_color, color_mask, depth, stencil });
        }
        if mask & GL_ACCUM_BUFFER_BIT != 0 {
            self.clear_accum_buffer();
        }
    }

    /// glViewport.
    pub fn viewport(&mut self, x: i32, y: i32, width: i32, height: i32) {
        if self.compile(move |cx| cx.viewport(x, y, width, height)) || self.inside_begin_end() {
            return;
        }
        if width < 0 || height < 0 {
            return self.set_error(GL_INVALID_VALUE, "glViewport: size");
        }
        let viewport = &mut self.state.viewport;
        (viewport.x, viewport.y) = (x, y);
        (viewport.width, viewport.height) = (width.min(MAX_VIEWPORT), height.min(MAX_VIEWPORT));
        self.dirty |= dirty::TRANSFORM;
    }

    /// glDepthRange.
    pub fn depth_range(&mut self, near: f64, far: f64) {
        if self.compile(move |cx| cx.depth_range(near, far)) || self.inside_begin_end() {
            return;
        }
        (self.state.viewport.near, self.state.viewport.far) = (near.clamp(0.0, 1.0), far.clamp(0.0, 1.0));
        self.dirty |= dirty::TRANSFORM;
    }

    /// glScissor.
    pub fn scissor(&mut self, x: i32, y: i32, width: i32, height: i32) {
        if self.compile(move |cx| cx.scissor(x, y, width, height)) || self.inside_begin_end() {
            return;
        }
        if width < 0 || height < 0 {
            return self.set_error(GL_INVALID_VALUE, "glScissor: size");
        }
        let scissor = &mut self.state.scissor;
        (scissor.x, scissor.y, scissor.width, scissor.height) = (x, y, width, height);
        self.dirty |= dirty::RASTER;
    }

    /// glFlush and glFinish, which are not compiled into lists but executed at once (5.4), are allowed: not between Begin and End, where this
    /// records the error.
    pub fn may_flush(&mut self) -> bool {
        !self.inside_begin_end()
    }

    /// Runs what was recorded so far, and makes a copy of the window's colour to memory ([`Surface::copy_color`](crate::device::Surface::copy_color)), if
    /// something was drawn since the last one.
    pub fn flush_and_copy(&mut self, out: &mut [u8], stride: usize, bottom_up: bool) {
        if self.fbo.draw == 0
            && let Some(window) = &mut self.window
            && let Some(batch) = self.recorder.take()
        {
            self.window_changed = false;
            return window.execute_and_copy(batch, out, stride, bottom_up);
        }
        self.flush_batch();
        if let (Some(window), true) = (&mut self.window, std::mem::take(&mut self.window_changed)) {
            window.copy_color(out, stride, bottom_up);
        }
    }

    /// glFinish.
    pub fn finish(&mut self) {
        if self.inside_begin_end() {
            return;
        }
        self.flush_batch();
        self.fbo.view.settle();
        if let Some(window) = &mut self.window {
            window.settle();
        }
    }
}

/// GL_MAX_VIEWPORT_DIMS.
const MAX_VIEWPORT: i32 = 16384;
