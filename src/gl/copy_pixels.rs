//! glCopyPixels (4.3.3).

use super::Context;
use super::enums::*;
use super::framebuffer::{Rect, bounds, read_color, read_depth, read_stencil};
use super::pixel_format::Groups;

impl Context {
    /// glCopyPixels. Pixels outside the window are not copied (their values are undefined).
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
        if let Err(error) = self.check_readable(format).and_then(|()| self.check_drawable(format)) {
            return self.set_error(error, "glCopyPixels");
        }
        if !self.state.current.raster.valid {
            return;
        }
        if self.feedback_pixels(GL_COPY_PIXEL_TOKEN) {
            return;
        }
        self.flush_batch();
        let Some(window) = self.window.as_mut() else { return };
        let pixels = window.pixels();
        let inside = Rect::new(x, y, width, height).and(bounds(pixels));
        if inside.is_empty() {
            return;
        }
        let groups = match kind {
            GL_DEPTH => Groups::Depth(read_depth(pixels, inside)),
            GL_STENCIL => Groups::Index(read_stencil(pixels, inside)),
            _ => read_color(pixels, inside),
        };
        // What lies to the left of and below the window is skipped: the rest lands where it would have.
        let skipped = [inside.min[0] - x, inside.min[1] - y];
        let position = self.state.current.raster.position;
        for k in 0..2 {
            self.state.current.raster.position[k] = position[k].round() + skipped[k] as f32 * self.state.pixel.zoom[k];
        }
        let size = [inside.width(), inside.height()];
        match groups {
            Groups::Index(indices) => self.draw_stencil(size, indices),
            groups => {
                let groups = self.state.pixel.transferred_colors(groups);
                self.draw_groups(size, groups);
            }
        }
        self.state.current.raster.position = position;
    }
}
