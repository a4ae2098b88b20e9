//! Framebuffer completeness (4.4.4).

use super::{Attachment, Framebuffer};
use crate::gl::Context;
use crate::gl::enums::*;

impl Context {
    /// glCheckFramebufferStatus; 0 after an error.
    pub fn check_framebuffer_status(&mut self, target: GLenum) -> GLenum {
        if self.inside_begin_end() {
            return 0;
        }
        match self.fbo.bound(target) {
            Some(name) => self.framebuffer_status(name),
            None => {
                self.set_error(GL_INVALID_ENUM, "glCheckFramebufferStatus: target");
                0
            }
        }
    }

    /// The status of a framebuffer; the window is complete once there is one.
    pub(crate) fn framebuffer_status(&self, name: u32) -> GLenum {
        match self.fbo.get(name) {
            Some(framebuffer) => self.status_of(framebuffer),
            None if self.window.is_none() => GL_FRAMEBUFFER_UNDEFINED,
            None => GL_FRAMEBUFFER_COMPLETE,
        }
    }

    fn status_of(&self, framebuffer: &Framebuffer) -> GLenum {
        let Framebuffer { colors, depth, stencil, draw_buffers, read_buffer } = framebuffer;
        // 4.4.4.1: each attachment for itself.
        let colors_fit = colors.iter().flatten().all(|a| self.attachment_fits(a, GL_COLOR));
        let depth_fits = depth.as_ref().is_none_or(|a| self.attachment_fits(a, GL_DEPTH));
        let stencil_fits = stencil.as_ref().is_none_or(|a| self.attachment_fits(a, GL_STENCIL));
        if !(colors_fit && depth_fits && stencil_fits) {
            return GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT;
        }
        // 4.4.4.2: all of them together.
        let mut samples = framebuffer.attachments().filter_map(|a| self.attached_image(a)).map(|image| image.samples);
        let Some(first) = samples.next() else { return GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT };
        if samples.any(|n| n != first) {
            return GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE;
        }
        let missing = |buffer: GLenum| buffer != GL_NONE && framebuffer.color_of(buffer).is_none();
        if draw_buffers.iter().any(|&buffer| missing(buffer)) {
            return GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER;
        }
        if missing(*read_buffer) {
            return GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER;
        }
        match (depth, stencil) {
            // A plane holds both.
            (Some(depth), Some(stencil)) if !depth.same_image(stencil) => GL_FRAMEBUFFER_UNSUPPORTED,
            _ => GL_FRAMEBUFFER_COMPLETE,
        }
    }

    /// The image is there, not empty, and of a format that goes to this kind of buffer.
    fn attachment_fits(&self, attachment: &Attachment, kind: GLenum) -> bool {
        self.attached_image(attachment).is_some_and(|image| {
            let format = match kind {
                GL_DEPTH => image.format.has_depth(),
                GL_STENCIL => image.format.has_stencil(),
                _ => image.format.is_color(),
            };
            format && !image.size.contains(&0)
        })
    }
}
