//! Fragments of pixel rectangles and bitmaps, recorded as rectangles in window space.

use std::sync::Arc;

use super::Context;
use super::framebuffer::{Rect, depth_word};
use super::pixel_format::Groups;
use super::pixel_rectangle::Placed;
use super::texture_object::unique_image_id;
use crate::draw::assembly::{Decomposition, Part, PrimitiveType};
use crate::draw::recorder::Run;
use crate::draw::texture::{Sampler, TexelFormat, TextureBinding, TextureImage, TextureKind, TextureLevel};
use crate::program::fixed::IMAGE_COORDINATES;
use crate::raster::layout::ATTRIBUTES;

/// Rectangles that are handed to the recorder at once.
const CHUNK: usize = 4096;

/// Window coordinates that a zoomed quad may have; the rasterizer takes no more.
const LARGEST_QUAD: f32 = 8000.0;
/// Largest width and height of an image in a texture slot.
const LARGEST_IMAGE: usize = 16384;

/// An image for a texture slot: nearest texels.
fn image_binding(size: [usize; 2], groups: Groups) -> Option<TextureBinding> {
    let (format, texels) = match groups {
        Groups::Rgba8(p) => (TexelFormat::Rgba8, p),
        Groups::Rgba(p) => (TexelFormat::Rgba32f, p.iter().flat_map(|c| c.map(|c| c.clamp(0.0, 1.0).to_bits())).collect()),
        _ => return None,
    };
    let [width, height] = size.map(|n| n as u32);
    let level = TextureLevel { width, height, depth: 1, texels: Arc::new(texels) };
    let image = Arc::new(TextureImage { id: unique_image_id(), kind: TextureKind::D2, format, levels: vec![level] });
    Some(TextureBinding { image, sampler: Sampler::NEAREST })
}

/// Fragments of one colour and depth.
#[derive(Clone, Copy)]
struct Patch {
    rect: Rect,
    color: [f32; 4],
    depth: f32,
}

/// The runs of equal values of a row: first column, one past the last, the value.
fn runs<T: Copy + PartialEq>(row: &[T]) -> impl Iterator<Item = (i32, i32, T)> + '_ {
    let mut start = 0;
    row.chunk_by(|a, b| a == b).map(move |run| {
        let first = start;
        start += run.len() as i32;
        (first, start, run[0])
    })
}

impl Context {
    /// Records the rectangles of a bitmap, cut to the window.
    pub(crate) fn record_rectangles(&mut self, rects: &[Rect]) {
        let raster = &self.state.current.raster;
        let (color, depth) = (raster.color, raster.position[2]);
        self.record_patches(rects.iter().map(|&rect| Patch { rect, color, depth }));
    }

    /// Records colours, one a pixel: an image on one rectangle, texels and pixels of the same size.
    pub(crate) fn record_image(&mut self, placed: &Placed, groups: Groups) {
        let rect = placed.rect;
        let Some(image) = image_binding([rect.width(), rect.height()], groups) else { return };
        let depth = self.state.current.raster.position[2];
        self.record_quad(image, self.corners(rect, depth));
    }

    /// Records colours with a zoom other than 1 and -1 as one quad, so that the rasterizer decides at every edge between two groups
    /// as Mesa's does. Hands the groups back where that is not for them: depths, and rectangles too large for it.
    pub(crate) fn record_zoomed(&mut self, size: [usize; 2], groups: Groups) -> Option<Groups> {
        let zoom = self.state.pixel.zoom;
        if !matches!(groups, Groups::Rgba8(_) | Groups::Rgba(_)) || zoom.iter().all(|z| z.abs() == 1.0) {
            return Some(groups);
        }
        let position = self.state.current.raster.position;
        let window = self.draw_size().map(|n| n as f32);
        let up = if self.draw_format().top_first { -0.5 } else { 0.5 };
        let low = [position[0].round(), position[1].round()];
        let high = [0, 1].map(|k| low[k] + size[k] as f32 * zoom[k]);
        let fits = low.iter().chain(&high).all(|c| c.abs() < LARGEST_QUAD) && size.iter().all(|&n| (1..=LARGEST_IMAGE).contains(&n));
        if !fits {
            return Some(groups);
        }
        // Through clip coordinates and the viewport, with Mesa's roundings; rows of a window surface run downwards, of others upwards.
        let x = |x: f32| (x / window[0] * 2.0 - 1.0).mul_add(window[0] * 0.5, window[0] * 0.5);
        let y = |y: f32| (y / window[1] * 2.0 - 1.0).mul_add(window[1] * up, window[1] * 0.5);
        let corners = [(low[0], low[1], 0.0, 0.0), (high[0], low[1], 1.0, 0.0), (high[0], high[1], 1.0, 1.0), (low[0], high[1], 0.0, 1.0)];
        if let Some(image) = image_binding(size, groups) {
            self.record_quad(image, corners.map(|(u, v, s, t)| ([x(u), y(v), position[2], 1.0], s, t)));
        }
        None
    }

    fn record_quad(&mut self, image: TextureBinding, corners: [([f32; 4], f32, f32); 4]) {
        let mut data = Vec::with_capacity(8);
        for (position, s, t) in corners {
            data.extend([position, [s, t, 0.0, 1.0]]);
        }
        self.draw_rectangles(Some(image), 1 << IMAGE_COORDINATES, &data);
    }

    /// Records fragments of the raster colour, each with its depth.
    pub(crate) fn record_depths(&mut self, placed: &Placed, depths: &[f64]) {
        let color = self.state.current.raster.color;
        // In the buffer's steps, so that the fragment's depth comes to the same one.
        let format = self.draw_format().depth;
        self.record_rows(placed, depths, |depth| (color, format.depth(depth_word(format, depth)) as f32));
    }

    fn record_rows<T: Copy + PartialEq>(&mut self, placed: &Placed, values: &[T], fragment: impl Fn(T) -> ([f32; 4], f32)) {
        let rect = placed.rect;
        let rows = values.chunks_exact(rect.width()).zip(rect.min[1]..);
        self.record_patches(rows.flat_map(|(row, y)| {
            let fragment = &fragment;
            runs(row).map(move |(first, end, value)| {
                let (color, depth) = fragment(value);
                Patch { rect: Rect { min: [rect.min[0] + first, y], max: [rect.min[0] + end, y + 1] }, color, depth }
            })
        }));
    }

    /// Corners of a rectangle in raster space, with s and t of a texture that covers it.
    fn corners(&self, rect: Rect, depth: f32) -> [([f32; 4], f32, f32); 4] {
        let height = self.draw_size()[1] as f32;
        // Rows of a window surface run downwards.
        let row = |y: i32| if self.draw_format().top_first { height - y as f32 } else { y as f32 };
        let (left, right) = (rect.min[0] as f32, rect.max[0] as f32);
        let (bottom, top) = (row(rect.min[1]), row(rect.max[1]));
        [(left, bottom, 0.0, 0.0), (right, bottom, 1.0, 0.0), (right, top, 1.0, 1.0), (left, top, 0.0, 1.0)]
            .map(|(x, y, s, t)| ([x, y, depth, 1.0], s, t))
    }

    fn record_patches(&mut self, patches: impl Iterator<Item = Patch>) {
        let mut data: Vec<[f32; 4]> = Vec::new();
        let mut patches = patches.peekable();
        while patches.peek().is_some() {
            data.clear();
            for Patch { rect, color, depth } in patches.by_ref().take(CHUNK) {
                for (position, ..) in self.corners(rect, depth) {
                    data.extend([position, color]);
                }
            }
            self.draw_rectangles(None, 1 << 3, &data);
        }
    }

    /// Draws rectangles; `data` holds the position and the attribute of `slot` (a mask) of their corners. All else comes from the
    /// raster position.
    fn draw_rectangles(&mut self, image: Option<TextureBinding>, slot: u32, data: &[[f32; 4]]) {
        if !self.has_draw_surface() {
            return;
        }
        let raster = &self.state.current.raster;
        let mut current = [[0.0, 0.0, 0.0, 1.0]; ATTRIBUTES];
        current[3] = raster.color;
        current[4] = raster.secondary_color;
        current[5] = [raster.distance, 0.0, 0.0, 1.0];
        current[8..8 + raster.tex_coords.len()].copy_from_slice(&raster.tex_coords);
        if self.recorder.is_full() {
            self.flush_batch();
        }
        self.set_rectangle_state(image);
        let run = Run { mask: 1 | slot, data, count: (data.len() / 2) as u32, edge_flags: None };
        self.recorder.draw_run(PrimitiveType::Quads, Part::default(), Decomposition::default(), &run, &current);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_cut_into_runs_of_equal_values() {
        assert_eq!(runs(&[1, 1, 2, 1]).collect::<Vec<_>>(), [(0, 2, 1), (2, 3, 2), (3, 4, 1)]);
        assert_eq!(runs::<u8>(&[]).count(), 0);
    }
}
