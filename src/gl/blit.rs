//! glBlitFramebuffer (ARB_framebuffer_object, 4.3.3): which buffers are copied where, and what is refused. Neither the colour mask nor any
//! other per-fragment operation but the scissor applies.

use super::Context;
use super::blit_pixels::{Corners, View, Work, blit};
use super::enums::*;
use super::framebuffer::Rect;
use super::framebuffer_object::Aspect;
use crate::device::{DepthFormat, Pixels, SurfaceFormat};

/// A copy of the buffer that is read, bottom row first or last.
struct Source {
    format: SurfaceFormat,
    size: [u32; 2],
    rows: Vec<u32>,
}

/// Corners in the rows of a buffer: those of a window surface run downwards.
fn in_rows([x0, y0, x1, y1]: Corners, height: u32, top_first: bool) -> Corners {
    if !top_first {
        return [x0, y0, x1, y1];
    }
    let flip = |y: i32| (i64::from(height) - i64::from(y)).clamp(i32::MIN.into(), i32::MAX.into()) as i32;
    [x0, flip(y0), x1, flip(y1)]
}

fn span(a: i32, b: i32) -> u32 {
    a.abs_diff(b)
}

impl Context {
    /// glBlitFramebuffer
    pub fn blit_framebuffer(
        &mut self,
        source_x0: i32,
        source_y0: i32,
        source_x1: i32,
        source_y1: i32,
        x0: i32,
        y0: i32,
        x1: i32,
        y1: i32,
        mask: u32,
        filter: GLenum,
    ) {
        let run = move |cx: &mut Context| {
            cx.blit_rectangles([source_x0, source_y0, source_x1, source_y1], [x0, y0, x1, y1], mask, filter);
        };
        if self.compile(run) || self.inside_begin_end() {
            return;
        }
        run(self);
    }

    fn blit_rectangles(&mut self, source: Corners, target: Corners, mask: u32, filter: GLenum) {
        let aspects = match self.check_blit(source, target, mask, filter) {
            Ok(aspects) => aspects,
            Err(error) => return self.set_error(error, "glBlitFramebuffer"),
        };
        for aspect in aspects {
            self.blit_buffer(aspect, source, target, filter == GL_LINEAR);
        }
    }

    /// What is to be copied: of the buffers in the mask those that both framebuffers have.
    fn check_blit(&mut self, source: Corners, target: Corners, mask: u32, filter: GLenum) -> Result<Vec<Aspect>, GLenum> {
        if mask & !(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT) != 0 {
            return Err(GL_INVALID_VALUE);
        }
        if !matches!(filter, GL_NEAREST | GL_LINEAR) {
            return Err(GL_INVALID_ENUM);
        }
        if filter == GL_LINEAR && mask & (GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT) != 0 {
            return Err(GL_INVALID_OPERATION);
        }
        let readable = self.fbo.read == 0 || self.framebuffer_status(self.fbo.read) == GL_FRAMEBUFFER_COMPLETE;
        if !readable || !self.looks_complete() {
            return Err(GL_INVALID_FRAMEBUFFER_OPERATION);
        }
        let (from, to) = (self.read_samples(), self.draw_samples());
        if from > 0 && to > 0 && from != to {
            return Err(GL_INVALID_OPERATION);
        }
        let same_size = (0..2).all(|k| span(source[k], source[k + 2]) == span(target[k], target[k + 2]));
        if (from > 0 || to > 0) && !same_size {
            return Err(GL_INVALID_OPERATION);
        }
        let mut aspects = Vec::new();
        let draw = self.draw_format();
        if mask & GL_COLOR_BUFFER_BIT != 0 && self.can_read(Aspect::Color) && self.draws_color() {
            aspects.push(Aspect::Color);
        }
        if mask & GL_DEPTH_BUFFER_BIT != 0 && self.can_read(Aspect::Depth) && draw.depth != DepthFormat::None {
            if self.read_depth_format() != draw.depth {
                return Err(GL_INVALID_OPERATION);
            }
            aspects.push(Aspect::Depth);
        }
        if mask & GL_STENCIL_BUFFER_BIT != 0 && self.can_read(Aspect::Stencil) && draw.stencil {
            aspects.push(Aspect::Stencil);
        }
        Ok(aspects)
    }

    fn blit_buffer(&mut self, aspect: Aspect, source: Corners, target: Corners, linear: bool) {
        let [width, height] = self.draw_size();
        let clip = self.scissored_window().and(Rect::new(0, 0, width as i32, height as i32));
        let whole = [0, 0, width as i32, height as i32];
        if aspect == Aspect::Color
            && [source, target, [clip.min[0], clip.min[1], clip.max[0], clip.max[1]]] == [whole; 3]
            && self.resolve_on_device()
        {
            return;
        }
        let copy = |pixels: &Pixels| Source {
            format: pixels.format,
            size: [pixels.width, pixels.height],
            rows: if aspect == Aspect::Color { pixels.color.to_vec() } else { pixels.depth_stencil.to_vec() },
        };
        let Some(mut from) = self.look_at_samples(aspect, copy) else { return };
        if aspect == Aspect::Color {
            from.rows = self.expand_colors(from.format.color, from.rows);
        }
        let source = in_rows(source, from.size[1], from.format.top_first);
        self.change_all_pixels(aspect, |pixels, mask| {
            let SurfaceFormat { color, depth, top_first, samples, .. } = pixels.format;
            let (work, words, rows) = match aspect {
                Aspect::Color => (Work::Color { from: from.format.color, to: color, linear }, color.words(), &mut *pixels.color),
                Aspect::Depth => (Work::Words { mask: depth.mask() }, 1, &mut *pixels.depth_stencil),
                Aspect::Stencil => (Work::Words { mask: 0xff00_0000 }, 1, &mut *pixels.depth_stencil),
            };
            let from_words = if aspect == Aspect::Color { from.format.color.words() } else { 1 };
            let view = View {
                width: from.size[0] as usize,
                height: from.size[1] as usize,
                samples: from.format.samples as usize,
                words: from_words,
                rows: &from.rows[..],
            };
            let mut to = View { width: pixels.width as usize, height: pixels.height as usize, samples: samples as usize, words, rows };
            let target = in_rows(target, pixels.height, top_first);
            let [left, a, right, b] = in_rows([clip.min[0], clip.min[1], clip.max[0], clip.max[1]], pixels.height, top_first);
            blit(&view, &mut to, source, target, [left, a.min(b), right, a.max(b)], work, mask);
        });
    }
}
