//! Copies from the window into textures (3.8.2).

use super::Context;
use super::enums::*;
use super::framebuffer::Rect;
use super::pixel_format::Groups;
use super::read_pixels::pad;
use super::texture_format::InternalFormat;
use super::texture_image::{ImageSpec, ImageTarget};

/// The format of pixels that a texture of a base format is copied from.
fn readable(base: GLenum) -> GLenum {
    if matches!(base, GL_DEPTH_COMPONENT | GL_DEPTH_STENCIL) { base } else { GL_RGBA }
}

impl Context {
    /// What a texture of a base format takes from a rectangle of the framebuffer, after transfer; zero outside.
    fn read_for_texture(&mut self, base: GLenum, rect: Rect) -> Groups {
        match base {
            GL_DEPTH_COMPONENT => {
                let read = self.read_depths(rect).unwrap_or((rect.and(Rect::new(0, 0, 0, 0)), Vec::new()));
                self.state.pixel.transferred_depths(Groups::Depth(pad(read.1, read.0, rect, 0.0)))
            }
            GL_DEPTH_STENCIL => {
                let read = self.read_depths_and_stencils(rect).unwrap_or((rect.and(Rect::new(0, 0, 0, 0)), Vec::new()));
                self.state.pixel.transferred_depths(Groups::DepthStencil(pad(read.1, read.0, rect, 0)))
            }
            _ => self.read_transferred_colors(rect),
        }
    }

    /// glCopyTexImage1D
    pub fn copy_tex_image_1d(&mut self, target: GLenum, level: i32, internal_format: GLenum, x: i32, y: i32, width: i32, border: i32) {
        if self.compile(move |cx| cx.copy_tex_image_1d(target, level, internal_format, x, y, width, border)) || self.inside_begin_end() {
            return;
        }
        self.copy_tex_image(1, target, level, internal_format, [x, y], [width, 1, 1], border);
    }

    /// glCopyTexImage2D
    pub fn copy_tex_image_2d(
        &mut self,
        target: GLenum,
        level: i32,
        internal_format: GLenum,
        x: i32,
        y: i32,
        width: i32,
        height: i32,
        border: i32,
    ) {
        if self.compile(move |cx| cx.copy_tex_image_2d(target, level, internal_format, x, y, width, height, border))
            || self.inside_begin_end()
        {
            return;
        }
        self.copy_tex_image(2, target, level, internal_format, [x, y], [width, height, 1], border);
    }

    fn copy_tex_image(
        &mut self,
        dimensions: usize,
        target: GLenum,
        level: i32,
        internal_format: GLenum,
        at: [i32; 2],
        size: [i32; 3],
        border: i32,
    ) {
        let spec = ImageTarget::checked(target, level, dimensions, false).and_then(|target| {
            // The numbers 1 to 4 are for glTexImage alone.
            if internal_format <= 4 {
                return Err(GL_INVALID_ENUM);
            }
            InternalFormat::from_enum(internal_format).ok_or(GL_INVALID_ENUM)?;
            let spec = ImageSpec::checked(target, level, internal_format, size, border)?;
            spec.supported()?;
            self.check_readable(readable(spec.format.base))?;
            Ok(spec)
        });
        match spec {
            Ok(spec) => {
                let groups = self.read_for_texture(spec.format.base, Rect::new(at[0], at[1], size[0], size[1]));
                let texels = spec.store(groups);
                self.set_texture_level(&spec, texels);
            }
            Err(error) => self.set_error(error, "glCopyTexImage"),
        }
    }

    /// glCopyTexSubImage1D
    pub fn copy_tex_sub_image_1d(&mut self, target: GLenum, level: i32, x_offset: i32, x: i32, y: i32, width: i32) {
        if self.compile(move |cx| cx.copy_tex_sub_image_1d(target, level, x_offset, x, y, width)) || self.inside_begin_end() {
            return;
        }
        self.copy_tex_sub_image(1, target, level, [x_offset, 0, 0], [x, y], [width, 1, 1]);
    }

    /// glCopyTexSubImage2D
    pub fn copy_tex_sub_image_2d(
        &mut self,
        target: GLenum,
        level: i32,
        x_offset: i32,
        y_offset: i32,
        x: i32,
        y: i32,
        width: i32,
        height: i32,
    ) {
        if self.compile(move |cx| cx.copy_tex_sub_image_2d(target, level, x_offset, y_offset, x, y, width, height))
            || self.inside_begin_end()
        {
            return;
        }
        self.copy_tex_sub_image(2, target, level, [x_offset, y_offset, 0], [x, y], [width, height, 1]);
    }

    /// glCopyTexSubImage3D
    pub fn copy_tex_sub_image_3d(
        &mut self,
        target: GLenum,
        level: i32,
        x_offset: i32,
        y_offset: i32,
        z_offset: i32,
        x: i32,
        y: i32,
        width: i32,
        height: i32,
    ) {
        if self.compile(move |cx| cx.copy_tex_sub_image_3d(target, level, x_offset, y_offset, z_offset, x, y, width, height))
            || self.inside_begin_end()
        {
            return;
        }
        self.copy_tex_sub_image(3, target, level, [x_offset, y_offset, z_offset], [x, y], [width, height, 1]);
    }

    fn copy_tex_sub_image(&mut self, dimensions: usize, target: GLenum, level: i32, offset: [i32; 3], at: [i32; 2], size: [i32; 3]) {
        let checked = self.check_sub_image(dimensions, target, level, offset, size).and_then(|image| {
            let base = self.base_format_of(image, level);
            self.check_readable(readable(base)).map(|()| base)
        });
        let done = checked.and_then(|base| {
            let groups = self.read_for_texture(base, Rect::new(at[0], at[1], size[0], size[1]));
            self.write_sub_image(dimensions, target, level, offset, size, Some(groups))
        });
        if let Err(error) = done {
            self.set_error(error, "glCopyTexSubImage");
        }
    }
}
