//! The current raster position (2.13).

use glam::Vec4;

use super::Context;
use super::state::MAX_TEXTURE_UNITS;

impl Context {
    /// glWindowPos*: window coordinates, no transformation, no clipping (2.13). `z` is clamped to [0, 1] and mapped to
    /// the depth range.
    pub fn window_pos(&mut self, x: f32, y: f32, z: f32) {
        if self.compile(move |cx| cx.window_pos(x, y, z)) || self.inside_begin_end() {
            return;
        }
        let (near, far) = (self.state.viewport.near as f32, self.state.viewport.far as f32);
        let current = &mut self.state.current;
        let attributes = &current.attributes;
        let raster = &mut current.raster;
        raster.position = [x, y, near + z.clamp(0.0, 1.0) * (far - near), 1.0];
        raster.distance = attributes[5][0];
        raster.color = attributes[3].map(super::checks::clamp01);
        raster.secondary_color = attributes[4].map(super::checks::clamp01);
        raster.tex_coords = std::array::from_fn(|unit| attributes[8 + unit]);
        raster.index = current.index;
        raster.valid = true;
    }

    /// Texture coordinates of a vertex through the texture matrices, without generation.
    pub(crate) fn transformed_tex_coords(&self, attributes: &[[f32; 4]; 16]) -> [[f32; 4]; MAX_TEXTURE_UNITS] {
        std::array::from_fn(|unit| (*self.texture_matrices[unit].top() * Vec4::from(attributes[8 + unit])).to_array())
    }
}
