//! glCopyPixels (4.3.3).

use super::Context;
use super::enums::*;
use super::framebuffer::Rect;
use super::framebuffer_object::Aspect;
use super::parity::{Parity, copied_depth};
use super::pixel_format::Groups;

impl Context {
    /// glCopyPixels
    pub fn copy_pixels(&mut self, x: i32, y: i32, width: i32, height: i32, kind: GLenum) {
        if self.compile(move |cx| cx.copy_pixels(x, y, width, height, kind)) || self.inside_begin_end() {
            return;
        }
        let format = match kind {
            GL_COLOR => GL_RGBA,
            GL_DEPTH => GL_DEPTH_COMPONENT,
            GL_STENCIL => GL_STENCIL_INDEX,
            _ => return self.set_error(GL_INVALID_ENUM, "glCopyPixels"),
        };
        if width < 0 || height < 0 {
            return self.set_error(GL_INVALID_VALUE, "glCopyPixels");
        }
        if !self.can_draw("glCopyPixels") {
            return;
        }
        if let Err(error) = self.check_readable(format).and_then(|()| self.check_drawable(format)) {
            return self.set_error(error, "glCopyPixels");
        }
        if !self.state.current.raster.valid {
            return;
        }
        if self.feedback_pixels(GL_COPY_PIXEL_TOKEN) {
            return;
        }
        let rect = Rect::new(x, y, width, height);
        if kind == GL_COLOR {
            // Colours from outside the window are undefined; Mesa takes zeros.
            let Some(groups) = self.read_padded_colors(rect) else { return };
            let groups = self.state.pixel.transferred_colors(groups);
            return self.draw_groups([rect.width(), rect.height()], groups);
        }
        let read = match kind {
            GL_DEPTH => self.read_depths(rect).map(|(inside, depths)| (inside, depths, Vec::new())),
            _ => self.read_stencils(rect).map(|(inside, indices)| (inside, Vec::new(), indices)),
        };
        let Some((inside, depths, indices)) = read else { return };
        if inside.is_empty() {
            return;
        }
        // What lies to the left of and below the window is skipped: the rest lands where it would have.
        let size = [inside.width(), inside.height()];
        let position = self.state.current.raster.position;
        for (k, skipped) in [inside.min[0] - x, inside.min[1] - y].into_iter().enumerate() {
            self.state.current.raster.position[k] = position[k].round() + skipped as f32 * self.state.pixel.zoom[k];
        }
        if kind == GL_DEPTH {
            let depths = match (self.config.parity, self.look_at_pixels(Aspect::Depth, |pixels| pixels.format.depth)) {
                (Parity::Osmesa, Some(format)) => depths.into_iter().map(|z| copied_depth(format, z)).collect(),
                _ => depths,
            };
            self.draw_groups(size, Groups::Depth(depths));
        } else {
            self.draw_stencil(size, indices);
        }
        self.state.current.raster.position = position;
    }
}
