//! Fragments of pixel rectangles and bitmaps, recorded as rectangles in window space.

use super::Context;
use super::framebuffer::Rect;
use super::pixel_format::Groups;
use super::pixel_rectangle::Placed;

impl Context {
    /// Records the rectangles of a bitmap.
    pub(crate) fn record_rectangles(&mut self, _rects: &[Rect]) {}

    /// Records an image, one texel a pixel.
    pub(crate) fn record_image(&mut self, _placed: &Placed, _groups: Groups) {}

    /// Records fragments of the raster colour, each with its depth.
    pub(crate) fn record_depths(&mut self, _placed: &Placed, _depths: &[f64]) {}
}
