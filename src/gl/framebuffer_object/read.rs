//! Where reads come from: the window, or an image of the bound framebuffer object.

use super::target::pixels_of;
use super::{Attachment, Framebuffer, ImageFormat};
use crate::device::{ColorFormat, DepthFormat, Pixels, PlaneFormat, SharedPlane};
use crate::gl::Context;
use crate::gl::enums::*;
use crate::gl::framebuffer::{Rect, bounds, read_color};
use crate::gl::pixel_format::Groups;

/// Colour, depth or stencil.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Aspect {
    Color,
    Depth,
    Stencil,
}

impl Framebuffer {
    /// What reads of a kind of pixels come from.
    pub(super) fn source(&self, aspect: Aspect) -> Option<&Attachment> {
        match aspect {
            Aspect::Color => self.color_of(self.read_buffer),
            Aspect::Depth => self.depth.as_ref(),
            Aspect::Stencil => self.stencil.as_ref(),
        }
    }
}

impl Context {
    /// Runs `f` on the pixels that reads of this kind come from. `None` where there are none.
    pub(crate) fn look_at_pixels<R>(&mut self, aspect: Aspect, f: impl FnOnce(&Pixels) -> R) -> Option<R> {
        if self.fbo.read != 0 || aspect != Aspect::Color {
            return self.look_at_samples(aspect, f);
        }
        self.flush_batch();
        Some(f(&self.window.as_mut()?.color_pixels()))
    }

    /// The same with all samples of a multisampled window.
    pub(crate) fn look_at_samples<R>(&mut self, aspect: Aspect, f: impl FnOnce(&Pixels) -> R) -> Option<R> {
        self.flush_batch();
        let Some(framebuffer) = self.fbo.get(self.fbo.read) else {
            return Some(f(&self.window.as_mut()?.pixels()));
        };
        let plane = framebuffer.source(aspect).and_then(|a| self.attached_plane(a))?;
        self.fbo.view.settle();
        let pixels = pixels_of(&plane);
        Some(f(&pixels))
    }

    /// The colours that are read of a framebuffer object, and their format.
    pub(super) fn read_plane(&self) -> Option<(SharedPlane, ImageFormat)> {
        let source = self.fbo.get(self.fbo.read)?.source(Aspect::Color)?;
        Some((self.attached_plane(source)?, self.read_format()?))
    }

    /// The part of a rectangle that can be read, and its colours before transfer. `None` without a buffer.
    pub(crate) fn read_colors(&mut self, rect: Rect) -> Option<(Rect, Groups)> {
        let format = self.read_format();
        let (inside, groups) = self.look_at_pixels(Aspect::Color, |pixels| {
            let inside = rect.and(bounds(pixels));
            (inside, read_color(pixels, inside))
        })?;
        let groups = match format {
            Some(format) => format.read(groups),
            None => groups,
        };
        Some((inside, groups))
    }

    /// GL_SAMPLES of what is read from.
    pub(crate) fn read_samples(&self) -> u32 {
        let Some(framebuffer) = self.fbo.get(self.fbo.read) else { return self.window_samples() };
        framebuffer.attachments().find_map(|a| self.attached_image(a)).map_or(0, |image| image.samples)
    }

    /// There is a buffer to read this from.
    pub(crate) fn can_read(&self, aspect: Aspect) -> bool {
        let window = self.config.surface_format();
        match (self.fbo.get(self.fbo.read), aspect) {
            (Some(framebuffer), _) => framebuffer.source(aspect).is_some(),
            (None, Aspect::Color) => self.state.pixel.read_buffer != GL_NONE,
            (None, Aspect::Depth) => window.depth != DepthFormat::None,
            (None, Aspect::Stencil) => window.stencil,
        }
    }

    /// How depths are stored that are read.
    pub(crate) fn read_depth_format(&self) -> DepthFormat {
        let Some(framebuffer) = self.fbo.get(self.fbo.read) else { return self.config.surface_format().depth };
        match framebuffer.source(Aspect::Depth).and_then(|a| self.attached_image(a)).map(|image| image.format.plane) {
            Some(PlaneFormat::DepthStencil { depth, .. }) => depth,
            _ => DepthFormat::None,
        }
    }

    /// Words of the colours that are read, whatever was written to the components that their format lacks.
    pub(crate) fn expand_colors(&self, color: ColorFormat, rows: Vec<u32>) -> Vec<u32> {
        match self.read_format() {
            Some(format) if color == ColorFormat::Rgba8 => format.expand(rows),
            _ => rows,
        }
    }

    /// The format of the colours that are read; `None` for the window's.
    fn read_format(&self) -> Option<ImageFormat> {
        let source = self.fbo.get(self.fbo.read)?.source(Aspect::Color)?;
        Some(self.attached_image(source)?.format)
    }

    /// The error of reading this kind of pixels (4.3.2): from an incomplete framebuffer, from one with several samples a pixel, from
    /// a buffer that is not there.
    pub(crate) fn check_readable(&self, format: GLenum) -> Result<(), GLenum> {
        if self.fbo.read != 0 && self.framebuffer_status(self.fbo.read) != GL_FRAMEBUFFER_COMPLETE {
            return Err(GL_INVALID_FRAMEBUFFER_OPERATION);
        }
        let there = match format {
            // There is no colour index buffer.
            GL_COLOR_INDEX => false,
            GL_STENCIL_INDEX => self.can_read(Aspect::Stencil),
            GL_DEPTH_COMPONENT => self.can_read(Aspect::Depth),
            GL_DEPTH_STENCIL => self.can_read(Aspect::Depth) && self.can_read(Aspect::Stencil),
            _ => self.can_read(Aspect::Color),
        };
        // The window's samples are resolved for whoever reads it.
        if there && (self.fbo.read == 0 || self.read_samples() == 0) { Ok(()) } else { Err(GL_INVALID_OPERATION) }
    }
}
