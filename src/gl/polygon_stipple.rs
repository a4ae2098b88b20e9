//! The polygon stipple pattern (3.5.2): a 32 x 32 bitmap under the pixel store modes.

use super::checks::put;
use super::enums::*;
use super::pixel_format::{ClientImage, Groups, pack};
use super::{Context, dirty};

/// Columns and rows of the pattern.
const SIDE: usize = 32;

impl Context {
    /// glPolygonStipple. `bytes`: as many as [`Context::unpack_bytes`] says for a 32 x 32 bitmap; fewer change nothing.
    pub fn polygon_stipple(&mut self, bytes: &[u8]) {
        let image = ClientImage::unpack(&self.state.unpack, bytes, [SIDE as i32, SIDE as i32, 1], false, GL_COLOR_INDEX, GL_BITMAP);
        if let Some(ClientImage { groups: Groups::Index(bits), .. }) = image {
            let row = |y: usize| bits[y * SIDE..][..SIDE].iter().fold(0, |word, &bit| word << 1 | bit);
            self.set_polygon_stipple(std::array::from_fn(row));
        }
    }

    /// Sets the pattern: row 0 the lowest, bit 31 the leftmost column.
    pub(crate) fn set_polygon_stipple(&mut self, rows: [u32; SIDE]) {
        if self.compile(move |cx| cx.set_polygon_stipple(rows)) || self.inside_begin_end() {
            return;
        }
        put(&mut self.state.polygon_stipple, rows, &mut self.dirty, dirty::RASTER);
    }

    /// glGetPolygonStipple. `bytes`: as many as [`Context::pack_bytes`] says for a 32 x 32 bitmap.
    pub fn get_polygon_stipple(&mut self, bytes: &mut [u8]) {
        if self.inside_begin_end() {
            return;
        }
        let bits = self.state.polygon_stipple.iter().flat_map(|&row| (0..SIDE).map(move |x| row >> (SIDE - 1 - x) & 1)).collect();
        pack(&self.state.pack, bytes, [SIDE, SIDE, 1], false, GL_COLOR_INDEX, GL_BITMAP, &Groups::Index(bits));
    }
}
