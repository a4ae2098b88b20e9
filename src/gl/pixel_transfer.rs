//! Pixel transfer (3.6.3): scale, bias, shift, offset and maps on the way between client memory and the GL.

use super::Context;
use super::enums::*;
use super::framebuffer::depth_word;
use super::pixel_format::{ClientImage, Groups};
use super::state::PixelState;
use crate::device::DepthFormat;

/// Largest pixel map (GL_MAX_PIXEL_MAP_TABLE).
pub const MAX_PIXEL_MAP_TABLE: usize = 256;

const S_TO_S: usize = (GL_PIXEL_MAP_S_TO_S - GL_PIXEL_MAP_I_TO_I) as usize;
const I_TO_R: usize = (GL_PIXEL_MAP_I_TO_R - GL_PIXEL_MAP_I_TO_I) as usize;
pub(super) const R_TO_R: usize = (GL_PIXEL_MAP_R_TO_R - GL_PIXEL_MAP_I_TO_I) as usize;

fn map_slot(map: GLenum) -> Option<usize> {
    (GL_PIXEL_MAP_I_TO_I..=GL_PIXEL_MAP_A_TO_A).contains(&map).then(|| (map - GL_PIXEL_MAP_I_TO_I) as usize)
}

/// The entry of a map for an index: maps of indices have power-of-two sizes, higher bits fall away.
fn look_up(map: &[f32], index: u32) -> f32 {
    map[index as usize & (map.len() - 1)]
}

impl PixelState {
    /// Colours go through unchanged.
    pub(crate) fn color_is_identity(&self) -> bool {
        !self.map_color && self.scale == [1.0; 4] && self.bias == [0.0; 4]
    }

    /// Transfers colours; the results are not clamped unless a map was used.
    pub(crate) fn transfer_colors(&self, pixels: &mut [[f32; 4]]) {
        if self.color_is_identity() {
            return;
        }
        for pixel in pixels {
            for k in 0..4 {
                pixel[k] = pixel[k] * self.scale[k] + self.bias[k];
                if self.map_color {
                    let map = &self.maps[R_TO_R + k];
                    pixel[k] = map[(pixel[k].clamp(0.0, 1.0) * (map.len() - 1) as f32).round() as usize];
                }
            }
        }
    }

    /// Shifts and offsets an index.
    pub(crate) fn shift_index(&self, index: u32) -> u32 {
        let shift = self.index_shift;
        let shifted = if shift >= 0 { index.checked_shl(shift as u32) } else { index.checked_shr(shift.unsigned_abs()) };
        shifted.unwrap_or(0).wrapping_add(self.index_offset as u32)
    }

    /// Transfers a stencil index.
    pub(crate) fn transfer_stencil(&self, index: u32) -> u32 {
        let index = self.shift_index(index);
        if self.map_stencil { look_up(&self.maps[S_TO_S], index) as u32 } else { index }
    }

    /// Transfers a depth value, clamped.
    pub(crate) fn transfer_depth(&self, depth: f64) -> f64 {
        if self.depth_scale == 1.0 && self.depth_bias == 0.0 {
            return depth.clamp(0.0, 1.0);
        }
        f64::from(depth as f32 * self.depth_scale + self.depth_bias).clamp(0.0, 1.0)
    }

    /// Transfers depth and stencil in one word.
    pub(crate) fn transfer_depth_stencil(&self, word: u32) -> u32 {
        let depth = depth_word(DepthFormat::D24, self.transfer_depth(DepthFormat::D24.depth(word)));
        depth | self.transfer_stencil(word >> 24) << 24
    }

    /// Depths, or depths with stencils, as a texture takes them.
    pub(crate) fn transferred_depths(&self, groups: Groups) -> Groups {
        match groups {
            Groups::Depth(depths) => Groups::Depth(depths.into_iter().map(|d| self.transfer_depth(d)).collect()),
            Groups::DepthStencil(words) => Groups::DepthStencil(words.into_iter().map(|w| self.transfer_depth_stencil(w)).collect()),
            other => other,
        }
    }

    /// Colours of colour indices: always through the I_TO_R ... I_TO_A maps, as RGBA is wanted.
    fn colors_of_indices(&self, indices: &[u32]) -> Vec<[f32; 4]> {
        let color = |&index: &u32| std::array::from_fn(|k| look_up(&self.maps[I_TO_R + k], self.shift_index(index)));
        indices.iter().map(color).collect()
    }

    /// A client image of colours or colour indices after transfer: [`Groups::Rgba8`] or [`Groups::Rgba`].
    pub(crate) fn transferred_colors(&self, groups: Groups) -> Groups {
        match groups {
            Groups::Rgba8(pixels) if self.color_is_identity() => Groups::Rgba8(pixels),
            Groups::Rgba8(pixels) => {
                let mut floats: Vec<[f32; 4]> = pixels.iter().map(|p| p.to_le_bytes().map(|c| c as f32 * (1.0 / 255.0))).collect();
                self.transfer_colors(&mut floats);
                Groups::Rgba(floats)
            }
            Groups::Rgba(mut pixels) => {
                self.transfer_colors(&mut pixels);
                Groups::Rgba(pixels)
            }
            Groups::Index(indices) => Groups::Rgba(self.colors_of_indices(&indices)),
            Groups::Depth(depths) => Groups::Depth(depths),
            Groups::DepthStencil(words) => Groups::DepthStencil(words),
        }
    }
}

impl ClientImage {
    /// The image's colours after transfer.
    pub(crate) fn into_colors(self, transfer: &PixelState) -> Groups {
        transfer.transferred_colors(self.groups)
    }

    /// What a texture takes: colours or depths.
    pub(crate) fn into_texture(self, transfer: &PixelState) -> Groups {
        transfer.transferred_depths(self.into_colors(transfer))
    }
}

impl Context {
    /// glPixelTransferf; glPixelTransferi shares it (integers are exact).
    pub fn pixel_transferf(&mut self, pname: GLenum, value: f32) {
        if self.compile(move |cx| cx.pixel_transferf(pname, value)) || self.inside_begin_end() {
            return;
        }
        let pixel = &mut self.state.pixel;
        match pname {
            GL_MAP_COLOR => pixel.map_color = value != 0.0,
            GL_MAP_STENCIL => pixel.map_stencil = value != 0.0,
            GL_INDEX_SHIFT => pixel.index_shift = value.round() as i32,
            GL_INDEX_OFFSET => pixel.index_offset = value.round() as i32,
            GL_RED_SCALE => pixel.scale[0] = value,
            GL_GREEN_SCALE => pixel.scale[1] = value,
            GL_BLUE_SCALE => pixel.scale[2] = value,
            GL_ALPHA_SCALE => pixel.scale[3] = value,
            GL_RED_BIAS => pixel.bias[0] = value,
            GL_GREEN_BIAS => pixel.bias[1] = value,
            GL_BLUE_BIAS => pixel.bias[2] = value,
            GL_ALPHA_BIAS => pixel.bias[3] = value,
            GL_DEPTH_SCALE => pixel.depth_scale = value,
            GL_DEPTH_BIAS => pixel.depth_bias = value,
            _ => self.set_error(GL_INVALID_ENUM, "glPixelTransfer"),
        }
    }

    /// glPixelTransferi
    pub fn pixel_transferi(&mut self, pname: GLenum, value: i32) {
        if matches!(pname, GL_INDEX_SHIFT | GL_INDEX_OFFSET) {
            if self.compile(move |cx| cx.pixel_transferi(pname, value)) || self.inside_begin_end() {
                return;
            }
            if pname == GL_INDEX_SHIFT {
                self.state.pixel.index_shift = value;
            } else {
                self.state.pixel.index_offset = value;
            }
        } else {
            self.pixel_transferf(pname, value as f32);
        }
    }

    /// glPixelZoom
    pub fn pixel_zoom(&mut self, x: f32, y: f32) {
        if self.compile(move |cx| cx.pixel_zoom(x, y)) || self.inside_begin_end() {
            return;
        }
        self.state.pixel.zoom = [x, y];
    }

    /// glPixelMapfv. `values` holds at least `size` values unless the size is wrong.
    pub fn pixel_mapfv(&mut self, map: GLenum, size: i32, values: &[f32]) {
        let values: Vec<f32> = values.iter().take(size.clamp(0, MAX_PIXEL_MAP_TABLE as i32 + 1) as usize).copied().collect();
        self.pixel_map(map, size, values);
    }

    /// glPixelMapuiv
    pub fn pixel_mapuiv(&mut self, map: GLenum, size: i32, values: &[u32]) {
        let scale = if is_index_map(map) { 1.0 } else { 1.0 / u32::MAX as f64 };
        let values = values.iter().take(MAX_PIXEL_MAP_TABLE + 1).map(|&v| (v as f64 * scale) as f32).collect();
        self.pixel_map(map, size, values);
    }

    /// glPixelMapusv
    pub fn pixel_mapusv(&mut self, map: GLenum, size: i32, values: &[u16]) {
        let scale = if is_index_map(map) { 1.0 } else { 1.0 / u16::MAX as f64 };
        let values = values.iter().take(MAX_PIXEL_MAP_TABLE + 1).map(|&v| (v as f64 * scale) as f32).collect();
        self.pixel_map(map, size, values);
    }

    fn pixel_map(&mut self, map: GLenum, size: i32, mut values: Vec<f32>) {
        let copy = if self.lists.builder.is_some() { values.clone() } else { Vec::new() };
        if self.compile(move |cx| cx.pixel_map(map, size, copy.clone())) || self.inside_begin_end() {
            return;
        }
        let Some(slot) = map_slot(map) else { return self.set_error(GL_INVALID_ENUM, "glPixelMap") };
        let too_large = size < 1 || size > MAX_PIXEL_MAP_TABLE as i32 || values.len() < size as usize;
        if too_large || slot < R_TO_R && !(size as u32).is_power_of_two() {
            return self.set_error(GL_INVALID_VALUE, "glPixelMap");
        }
        values.truncate(size as usize);
        // Indices stay as they are, colours are clamped on the way in; NaN counts as zero.
        if slot >= I_TO_R {
            values.iter_mut().for_each(|v| *v = if v.is_nan() { 0.0 } else { v.clamp(0.0, 1.0) });
        }
        self.state.pixel.maps[slot] = values;
    }

    /// glGetPixelMapfv: the map's values, none after an error.
    pub fn get_pixel_mapfv(&mut self, map: GLenum) -> Vec<f32> {
        if self.inside_begin_end() {
            return Vec::new();
        }
        match map_slot(map) {
            Some(slot) => self.state.pixel.maps[slot].clone(),
            None => {
                self.set_error(GL_INVALID_ENUM, "glGetPixelMap");
                Vec::new()
            }
        }
    }

    /// glGetPixelMapuiv
    pub fn get_pixel_mapuiv(&mut self, map: GLenum) -> Vec<u32> {
        let scale = if is_index_map(map) { 1.0 } else { u32::MAX as f64 };
        self.get_pixel_mapfv(map).iter().map(|&v| (v as f64 * scale).round() as u32).collect()
    }

    /// glGetPixelMapusv
    pub fn get_pixel_mapusv(&mut self, map: GLenum) -> Vec<u16> {
        let scale = if is_index_map(map) { 1.0 } else { u16::MAX as f64 };
        self.get_pixel_mapfv(map).iter().map(|&v| (v as f64 * scale).round() as u16).collect()
    }
}

/// The map's entries are indices, not colours.
fn is_index_map(map: GLenum) -> bool {
    matches!(map, GL_PIXEL_MAP_I_TO_I | GL_PIXEL_MAP_S_TO_S)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gl::ContextConfig;

    fn context() -> Context {
        Context::new(ContextConfig::default(), None)
    }

    #[test]
    fn maps_are_checked_clamped_and_read_back_in_every_type() {
        let mut cx = context();
        cx.pixel_mapfv(GL_PIXEL_MAP_R_TO_R, 3, &[-1.0, 0.5, 2.0]);
        assert_eq!(cx.get_pixel_mapfv(GL_PIXEL_MAP_R_TO_R), [0.0, 0.5, 1.0]);
        assert_eq!(cx.get_pixel_mapusv(GL_PIXEL_MAP_R_TO_R), [0, 32768, 65535]);
        cx.pixel_mapusv(GL_PIXEL_MAP_S_TO_S, 2, &[7, 300]);
        assert_eq!(cx.get_pixel_mapuiv(GL_PIXEL_MAP_S_TO_S), [7, 300]);
        assert_eq!(cx.get_error(), GL_NO_ERROR);
        cx.pixel_mapfv(GL_PIXEL_MAP_I_TO_R, 3, &[0.0; 3]);
        assert_eq!(cx.get_error(), GL_INVALID_VALUE);
        cx.pixel_mapfv(GL_PIXEL_MAP_R_TO_R, 0, &[]);
        assert_eq!(cx.get_error(), GL_INVALID_VALUE);
        cx.pixel_mapfv(GL_TEXTURE_2D, 1, &[0.0]);
        assert_eq!(cx.get_error(), GL_INVALID_ENUM);
    }

    #[test]
    fn colours_are_scaled_biased_and_mapped_in_this_order() {
        let mut cx = context();
        cx.pixel_transferf(GL_RED_SCALE, 0.5);
        cx.pixel_transferf(GL_RED_BIAS, 0.5);
        cx.pixel_transferi(GL_MAP_COLOR, 1);
        cx.pixel_mapfv(GL_PIXEL_MAP_R_TO_R, 2, &[0.25, 0.75]);
        let mut pixels = [[0.0, 0.4, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0]];
        cx.state.pixel.transfer_colors(&mut pixels);
        assert_eq!([pixels[0][0], pixels[1][0]], [0.75, 0.75]);
        assert_eq!(pixels[0][1], 0.0);
    }

    #[test]
    fn indices_are_shifted_then_offset() {
        let mut cx = context();
        cx.pixel_transferi(GL_INDEX_SHIFT, 2);
        cx.pixel_transferi(GL_INDEX_OFFSET, -1);
        assert_eq!(cx.state.pixel.shift_index(3), 11);
        cx.pixel_transferi(GL_INDEX_SHIFT, -40);
        cx.pixel_transferi(GL_INDEX_OFFSET, 5);
        assert_eq!(cx.state.pixel.shift_index(3), 5);
    }
}
