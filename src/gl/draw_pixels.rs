//! glDrawPixels (3.6.4, 3.6.5): colours, depths and stencil indices of a client image become fragments.

use std::sync::Arc;

use super::enums::*;
use super::framebuffer::{depth_word, pixel_index, write_color, write_depth_stencil};
use super::framebuffer_object::Aspect;
use super::parity::mapped_as_osmesa;
use super::pixel_format::{ClientImage, Groups, check};
use super::pixel_rectangle::Placed;
use super::{Context, Parity};
use crate::device::{ColorFormat, DepthFormat, Pixels};

impl Context {
    /// glDrawPixels. `pixels`: from the client's pointer on, as [`Context::unpack_bytes`] says.
    pub fn draw_pixels(&mut self, width: i32, height: i32, format: GLenum, ty: GLenum, pixels: Option<&[u8]>) {
        // Nothing is read from the client where nothing is drawn.
        let visible = self.lists.builder.is_some() || self.state.current.raster.valid && self.render_mode == GL_RENDER;
        let image = pixels
            .filter(|_| visible)
            .and_then(|bytes| ClientImage::unpack(&self.state.unpack, bytes, [width, height, 1], false, format, ty))
            .map(Arc::new);
        let kept = image.clone();
        let run = move |cx: &mut Context, image| cx.draw_pixels_unpacked(width, height, format, ty, image);
        if self.compile(move |cx| run(cx, kept.clone())) || self.inside_begin_end() {
            return;
        }
        run(self, image);
    }

    fn draw_pixels_unpacked(&mut self, width: i32, height: i32, format: GLenum, ty: GLenum, image: Option<Arc<ClientImage>>) {
        if !self.can_draw("glDrawPixels") {
            return;
        }
        let checked = if width < 0 || height < 0 { Err(GL_INVALID_VALUE) } else { check(format, ty) };
        if let Err(error) = checked.and_then(|()| self.check_drawable(format)) {
            return self.set_error(error, "glDrawPixels");
        }
        if !self.state.current.raster.valid {
            return;
        }
        if self.feedback_pixels(GL_DRAW_PIXEL_TOKEN) {
            return;
        }
        let Some(image) = image else { return };
        let image = Arc::try_unwrap(image).unwrap_or_else(|shared| (*shared).clone());
        let [width, height, _] = image.size;
        if format == GL_STENCIL_INDEX {
            if let Groups::Index(indices) = image.groups {
                self.draw_stencil([width, height], indices);
            }
            return;
        }
        if let Groups::DepthStencil(words) = image.groups {
            return self.draw_depth_stencil([width, height], words);
        }
        let transfer = &self.state.pixel;
        let groups = match self.config.parity {
            Parity::Osmesa if transfer.map_color => mapped_as_osmesa(transfer, [width, height], image.groups),
            _ => transfer.transferred_colors(image.groups),
        };
        self.draw_groups([width, height], groups);
    }

    /// The error of drawing this kind of pixels: there has to be a buffer for depths and stencil indices.
    pub(crate) fn check_drawable(&self, format: GLenum) -> Result<(), GLenum> {
        let missing = match format {
            GL_STENCIL_INDEX => !self.draw_format().stencil,
            GL_DEPTH_COMPONENT => self.draw_format().depth == DepthFormat::None,
            GL_DEPTH_STENCIL => self.draw_format().depth == DepthFormat::None || !self.draw_format().stencil,
            _ => false,
        };
        if missing { Err(GL_INVALID_OPERATION) } else { Ok(()) }
    }

    /// Draws colours (after transfer) or depths (before) at the raster position.
    pub(crate) fn draw_groups(&mut self, size: [usize; 2], groups: Groups) {
        let Some(groups) = self.record_zoomed(size, groups) else { return };
        let Some(placed) = self.place_rectangle(size) else { return };
        match groups {
            Groups::Depth(depths) => {
                let transfer = &self.state.pixel;
                let depths = placed.resample(&depths, size[0]).into_iter().map(|d| transfer.transfer_depth(d)).collect();
                self.draw_depths(&placed, depths);
            }
            Groups::Rgba8(p) => {
                let p = placed.resample(&p, size[0]);
                self.draw_colors(&placed, Groups::Rgba8(p));
            }
            Groups::Rgba(p) => {
                let p = placed.resample(&p, size[0]);
                self.draw_colors(&placed, Groups::Rgba(p));
            }
            Groups::Index(_) | Groups::DepthStencil(_) => {}
        }
    }

    /// Colours of the placed pixels.
    fn draw_colors(&mut self, placed: &Placed, groups: Groups) {
        if !self.fragments_pass_unchanged() {
            return self.record_image(placed, groups);
        }
        // Nothing happens on the way: the colours go straight into the window.
        self.change_pixels(Aspect::Color, |pixels, mask| write_colors(pixels, placed, &groups, mask));
    }

    /// Depths of the placed pixels: fragments of the raster colour.
    fn draw_depths(&mut self, placed: &Placed, depths: Vec<f64>) {
        let s = &self.state;
        let only_depth = self.color_write_mask() == 0 && !(s.color_buffer.alpha_test || s.stencil.test && self.draw_format().stencil);
        // Without the depth test depths are not written (4.1.5).
        if only_depth && !s.depth.test {
            return;
        }
        if !(only_depth && s.depth.func == GL_ALWAYS) {
            return self.record_depths(placed, &depths);
        }
        if !s.depth.write {
            return;
        }
        self.change_pixels(Aspect::Depth, |pixels, _| {
            let format = pixels.format.depth;
            for (y, row) in (placed.rect.min[1]..).zip(depths.chunks_exact(placed.rect.width())) {
                let first = pixel_index(pixels, placed.rect.min[0], y);
                for (x, depth) in row.iter().enumerate() {
                    // Numbers too small to be normal are zero for fragments.
                    let depth = if *depth < f64::from(f32::MIN_POSITIVE) { 0.0 } else { *depth };
                    let depth = depth_word(format, depth);
                    write_depth_stencil(pixels, first + x, |old| old & !format.mask() | depth);
                }
            }
        });
    }

    /// Depths and stencil indices (before transfer) at the raster position: straight into the buffer, under their write masks
    /// (EXT_packed_depth_stencil).
    pub(crate) fn draw_depth_stencil(&mut self, size: [usize; 2], words: Vec<u32>) {
        let Some(placed) = self.place_rectangle(size) else { return };
        let s = &self.state;
        let mask = (s.stencil.sides[0].write_mask & 0xff) << 24 | if s.depth.write { 0xff_ffff } else { 0 };
        let words: Vec<u32> = placed.resample(&words, size[0]).into_iter().map(|w| s.pixel.transfer_depth_stencil(w)).collect();
        self.change_pixels(Aspect::Depth, |pixels, _| {
            let format = pixels.format.depth;
            for (y, row) in (placed.rect.min[1]..).zip(words.chunks_exact(placed.rect.width())) {
                let first = pixel_index(pixels, placed.rect.min[0], y);
                for (x, word) in row.iter().enumerate() {
                    let depth = depth_word(format, DepthFormat::D24.depth(*word));
                    write_depth_stencil(pixels, first + x, |old| old & !mask | (depth | word & 0xff00_0000) & mask);
                }
            }
        });
    }

    /// Stencil indices (before transfer) at the raster position: straight into the buffer, under its write mask.
    pub(crate) fn draw_stencil(&mut self, size: [usize; 2], indices: Vec<u32>) {
        let Some(placed) = self.place_rectangle(size) else { return };
        let indices = placed.resample(&indices, size[0]);
        let mask = (self.state.stencil.sides[0].write_mask & 0xff) << 24;
        let values: Vec<u32> = indices.into_iter().map(|index| self.state.pixel.transfer_stencil(index) << 24 & mask).collect();
        self.change_pixels(Aspect::Stencil, |pixels, _| {
            for (y, row) in (placed.rect.min[1]..).zip(values.chunks_exact(placed.rect.width())) {
                let first = pixel_index(pixels, placed.rect.min[0], y);
                for (x, stencil) in row.iter().enumerate() {
                    write_depth_stencil(pixels, first + x, |old| old & !mask | stencil);
                }
            }
        });
    }
}

/// Writes colours, components of `mask` only.
fn write_colors(pixels: &mut Pixels, placed: &Placed, groups: &Groups, mask: u32) {
    let width = placed.rect.width();
    for (row, y) in (placed.rect.min[1]..placed.rect.max[1]).enumerate() {
        let first = pixel_index(pixels, placed.rect.min[0], y);
        match groups {
            Groups::Rgba8(p) if mask == 15 && pixels.format.color == ColorFormat::Rgba8 && pixels.format.samples == 1 => {
                pixels.color[first..first + width].copy_from_slice(&p[row * width..(row + 1) * width]);
            }
            Groups::Rgba8(p) => {
                for (x, c) in p[row * width..(row + 1) * width].iter().enumerate() {
                    write_color(pixels, first + x, c.to_le_bytes().map(|c| c as f32 / 255.0), mask);
                }
            }
            Groups::Rgba(p) => {
                for (x, c) in p[row * width..(row + 1) * width].iter().enumerate() {
                    write_color(pixels, first + x, *c, mask);
                }
            }
            _ => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gl::ContextConfig;

    fn context() -> Context {
        let mut cx = Context::new(ContextConfig { accum_bits: 16, ..ContextConfig::default() }, None);
        cx.attach_window(4, 3);
        cx
    }

    fn read(cx: &mut Context, format: GLenum) -> Vec<u8> {
        let mut out = vec![0; cx.pack_bytes(4, 3, 1, format, GL_UNSIGNED_BYTE).unwrap()];
        cx.read_pixels(0, 0, 4, 3, format, GL_UNSIGNED_BYTE, Some(&mut out));
        out
    }

    #[test]
    fn what_is_drawn_is_read_back_bottom_row_first() {
        let mut cx = context();
        cx.window_pos(1.0, 1.0, 0.0);
        cx.draw_pixels(2, 1, GL_LUMINANCE, GL_UNSIGNED_BYTE, Some(&[10, 20]));
        let red = read(&mut cx, GL_RED);
        assert_eq!(red, [0, 0, 0, 0, 0, 10, 20, 0, 0, 0, 0, 0]);
        // Pixels beyond the window leave the client's bytes alone.
        let mut out = [7; 9];
        cx.pixel_storei(GL_PACK_ALIGNMENT, 1);
        cx.read_pixels(-1, 1, 3, 3, GL_RED, GL_UNSIGNED_BYTE, Some(&mut out));
        assert_eq!(out, [7, 0, 10, 7, 0, 0, 7, 7, 7]);
        assert_eq!(cx.get_error(), GL_NO_ERROR);
    }

    #[test]
    fn colour_mask_scissor_and_zoom_apply() {
        let mut cx = context();
        cx.state.color_buffer.color_mask = [true, false, true, true];
        cx.state.scissor = crate::gl::state::ScissorState { test: true, x: 0, y: 0, width: 3, height: 1 };
        cx.pixel_zoom(4.0, 3.0);
        cx.window_pos(0.0, 0.0, 0.0);
        cx.draw_pixels(1, 1, GL_RGB, GL_UNSIGNED_BYTE, Some(&[1, 2, 3]));
        assert_eq!(read(&mut cx, GL_RGB)[..12], [1, 0, 3, 1, 0, 3, 1, 0, 3, 0, 0, 0]);
        assert_eq!(read(&mut cx, GL_RED)[4..], [0; 8]);
    }

    #[test]
    fn stencil_indices_are_masked_and_copied() {
        let mut cx = context();
        cx.state.stencil.sides[0].write_mask = 0x0f;
        cx.window_pos(0.0, 0.0, 0.0);
        cx.draw_pixels(4, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, Some(&[0xff, 1, 2, 3]));
        cx.window_pos(1.0, 2.0, 0.0);
        cx.copy_pixels(-1, 0, 3, 1, GL_STENCIL);
        assert_eq!(read(&mut cx, GL_STENCIL_INDEX), [15, 1, 2, 3, 0, 0, 0, 0, 0, 0, 15, 1]);
    }

    #[test]
    fn depths_are_written_only_with_the_depth_test_on() {
        let mut cx = context();
        cx.state.color_buffer.color_mask = [false; 4];
        cx.state.depth.func = GL_ALWAYS;
        cx.window_pos(0.0, 0.0, 0.0);
        cx.draw_pixels(1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, Some(&[128]));
        assert_eq!(read(&mut cx, GL_DEPTH_COMPONENT)[0], 0);
        cx.state.depth.test = true;
        cx.draw_pixels(1, 1, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, Some(&[128]));
        assert_eq!(read(&mut cx, GL_DEPTH_COMPONENT)[0], 128);
    }

    #[test]
    fn accumulation_averages() {
        let mut cx = context();
        cx.window_pos(0.0, 0.0, 0.0);
        cx.draw_pixels(1, 1, GL_RED, GL_UNSIGNED_BYTE, Some(&[100]));
        cx.accum(GL_LOAD, 0.5);
        cx.draw_pixels(1, 1, GL_RED, GL_UNSIGNED_BYTE, Some(&[200]));
        cx.accum(GL_ACCUM, 0.5);
        cx.accum(GL_RETURN, 1.0);
        assert_eq!(read(&mut cx, GL_RED)[0], 150);
        let mut none = Context::new(ContextConfig::default(), None);
        none.accum(GL_LOAD, 1.0);
        assert_eq!(none.get_error(), GL_INVALID_OPERATION);
    }

    #[test]
    fn errors_name_what_is_missing() {
        let mut cx = Context::new(ContextConfig { depth_bits: 0, stencil_bits: 0, ..ContextConfig::default() }, None);
        cx.attach_window(1, 1);
        cx.draw_pixels(1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, Some(&[0; 4]));
        assert_eq!(cx.get_error(), GL_INVALID_OPERATION);
        cx.copy_pixels(0, 0, 1, 1, GL_STENCIL);
        assert_eq!(cx.get_error(), GL_INVALID_OPERATION);
        cx.read_pixels(0, 0, 1, 1, GL_COLOR_INDEX, GL_UNSIGNED_BYTE, Some(&mut [0]));
        assert_eq!(cx.get_error(), GL_INVALID_OPERATION);
        cx.read_pixels(0, 0, -1, 1, GL_RGBA, GL_UNSIGNED_BYTE, None);
        assert_eq!(cx.get_error(), GL_INVALID_VALUE);
        cx.copy_pixels(0, 0, 1, 1, GL_RGBA);
        assert_eq!(cx.get_error(), GL_INVALID_ENUM);
    }
}
