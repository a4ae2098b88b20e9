//! Fragments of pixel rectangles and bitmaps, recorded as rectangles in window space.

use std::sync::Arc;

use super::Context;
use super::framebuffer::Rect;
use super::pixel_format::Groups;
use super::pixel_rectangle::Placed;
use super::texture_object::unique_image_id;
use crate::draw::assembly::{Part, PrimitiveType, QuadSplit};
use crate::draw::recorder::Run;
use crate::draw::texture::{Sampler, TexelFormat, TextureBinding, TextureImage, TextureKind, TextureLevel, Wrap};
use crate::program::fixed::IMAGE_COORDINATES;
use crate::raster::layout::ATTRIBUTES;

/// Rectangles that are handed to the recorder at once.
const CHUNK: usize = 4096;

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
        let (format, texels) = match groups {
            Groups::Rgba8(p) => (TexelFormat::Rgba8, p),
            Groups::Rgba(p) => (TexelFormat::Rgba32f, p.iter().flat_map(|c| c.map(|c| c.clamp(0.0, 1.0).to_bits())).collect()),
            _ => return,
        };
        let rect = placed.rect;
        let (width, height) = (rect.width() as u32, rect.height() as u32);
        let level = TextureLevel { width, height, depth: 1, texels: Arc::new(texels) };
        let image = Arc::new(TextureImage { id: unique_image_id(), kind: TextureKind::D2, format, levels: vec![level] });
        let sampler = Sampler {
            wrap: [Wrap::ClampToEdge; 3],
            mag_linear: false,
            min_linear: false,
            mip_linear: None,
            lod_range: [-1000.0, 1000.0],
            lod_bias: 0.0,
            border: [0.0; 4],
        };
        let depth = self.state.current.raster.position[2];
        let mut data = Vec::with_capacity(8);
        for (position, s, t) in self.corners(rect, depth) {
            data.extend([position, [s, t, 0.0, 1.0]]);
        }
        self.draw_rectangles(Some(TextureBinding { image, sampler }), 1 << IMAGE_COORDINATES, &data);
    }

    /// Records fragments of the raster colour, each with its depth.
    pub(crate) fn record_depths(&mut self, placed: &Placed, depths: &[f64]) {
        let color = self.state.current.raster.color;
        self.record_rows(placed, depths, |depth| (color, depth as f32));
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
        // Rows of a window surface run downwards.
        let height = self.window_size[1] as f32;
        let (left, right) = (rect.min[0] as f32, rect.max[0] as f32);
        let (bottom, top) = (height - rect.min[1] as f32, height - rect.max[1] as f32);
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
        if self.window.is_none() {
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
        self.recorder.draw_run(PrimitiveType::Quads, Part::default(), QuadSplit::Diagonal02, &run, &current);
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
