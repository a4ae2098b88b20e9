//! glBitmap (3.7): the set bits of a bitmap become fragments of the current raster position's colour.
//!
//! A bitmap becomes rectangles of set bits, so that text needs no images: all glyphs of one colour are one draw.

use std::sync::Arc;

use super::Context;
use super::enums::*;
use super::framebuffer::Rect;
use super::pixel_format::{ClientImage, Groups};

impl Context {
    /// glBitmap. `pixels`: from the client's pointer on, as [`Context::unpack_bytes`] says for GL_COLOR_INDEX, GL_BITMAP;
    /// None for NULL: the raster position moves nevertheless.
    pub fn bitmap(&mut self, width: i32, height: i32, x_origin: f32, y_origin: f32, x_move: f32, y_move: f32, pixels: Option<&[u8]>) {
        let visible = self.lists.builder.is_some() || self.state.current.raster.valid && self.render_mode == GL_RENDER;
        let image = pixels
            .filter(|_| visible)
            .and_then(|bytes| ClientImage::unpack(&self.state.unpack, bytes, [width, height, 1], false, GL_COLOR_INDEX, GL_BITMAP))
            .map(|image| Arc::new(rectangles(&image)));
        let kept = image.clone();
        let run = move |cx: &mut Context, image: Option<Arc<Vec<Rect>>>| {
            cx.bitmap_unpacked([width, height], [x_origin, y_origin], [x_move, y_move], image.as_deref().map_or(&[], Vec::as_slice));
        };
        if self.compile(move |cx| run(cx, kept.clone())) || self.inside_begin_end() {
            return;
        }
        run(self, image);
    }

    fn bitmap_unpacked(&mut self, size: [i32; 2], origin: [f32; 2], advance: [f32; 2], set: &[Rect]) {
        if size[0] < 0 || size[1] < 0 {
            return self.set_error(GL_INVALID_VALUE, "glBitmap");
        }
        if !self.can_draw("glBitmap") {
            return;
        }
        if !self.state.current.raster.valid {
            return;
        }
        if !self.feedback_pixels(GL_BITMAP_TOKEN) && !set.is_empty() {
            let position = self.state.current.raster.position;
            // The lower left corner is floored; the small addend makes 9.99999 ten, as in Mesa.
            let corner = [0, 1].map(|k| (position[k] + 0.0001 - origin[k]).floor() as i32);
            let visible = self.scissored_window();
            let move_by = |r: &Rect| Rect {
                min: [r.min[0].saturating_add(corner[0]), r.min[1].saturating_add(corner[1])],
                max: [r.max[0].saturating_add(corner[0]), r.max[1].saturating_add(corner[1])],
            };
            let rects: Vec<Rect> = set.iter().map(|r| move_by(r).and(visible)).filter(|r| !r.is_empty()).collect();
            self.record_rectangles(&rects);
        }
        for k in 0..2 {
            self.state.current.raster.position[k] += advance[k];
        }
    }
}

/// The set bits as rectangles: runs of a row, merged with equal runs of the rows above.
fn rectangles(image: &ClientImage) -> Vec<Rect> {
    let Groups::Index(bits) = &image.groups else { return Vec::new() };
    let [width, height, _] = image.size;
    let mut done = Vec::new();
    // Rectangles that end at the row before, from left to right.
    let mut open: Vec<Rect> = Vec::new();
    for y in 0..height {
        let row = &bits[y * width..(y + 1) * width];
        let mut next = Vec::new();
        let mut candidates = std::mem::take(&mut open).into_iter().peekable();
        let mut x = 0;
        while x < width {
            if row[x] == 0 {
                x += 1;
                continue;
            }
            let start = x;
            while x < width && row[x] != 0 {
                x += 1;
            }
            while let Some(rect) = candidates.next_if(|r| r.min[0] < start as i32) {
                done.push(rect);
            }
            match candidates.next_if(|r| r.min[0] == start as i32 && r.max[0] == x as i32) {
                Some(rect) => next.push(Rect { min: rect.min, max: [rect.max[0], y as i32 + 1] }),
                None => next.push(Rect { min: [start as i32, y as i32], max: [x as i32, y as i32 + 1] }),
            }
        }
        done.extend(candidates);
        open = next;
    }
    done.extend(open);
    done
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rectangles_cover_every_set_bit_once() {
        let mut seed = 12345u32;
        for (width, height) in [(1, 1), (7, 5), (8, 13), (33, 20)] {
            let bits: Vec<u32> = (0..width * height)
                .map(|_| {
                    seed = seed.wrapping_mul(1664525).wrapping_add(1013904223);
                    (seed >> 30 != 0) as u32
                })
                .collect();
            let image = ClientImage { size: [width, height, 1], groups: Groups::Index(bits.clone()) };
            let mut hits = vec![0; width * height];
            for rect in rectangles(&image) {
                for y in rect.min[1]..rect.max[1] {
                    for x in rect.min[0]..rect.max[0] {
                        hits[y as usize * width + x as usize] += 1;
                    }
                }
            }
            assert_eq!(hits, bits);
        }
    }

    #[test]
    fn equal_rows_merge() {
        let image = ClientImage { size: [4, 3, 1], groups: Groups::Index(vec![0, 1, 1, 0, 0, 1, 1, 0, 1, 1, 1, 0]) };
        assert_eq!(rectangles(&image).len(), 2);
    }
}
