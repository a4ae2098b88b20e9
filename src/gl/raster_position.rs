//! The current raster position (2.13).

use glam::Vec4;

use super::Context;
use super::begin_end::slot;
use super::checks::clamp01;
use super::enums::*;
use super::state::MAX_TEXTURE_UNITS;
use crate::draw::recorder::Run;
use crate::program::Output;
use crate::raster::layout::topology;

impl Context {
    /// glRasterPos*: the point goes through the vertex program; if it is clipped, the position becomes invalid.
    pub fn raster_pos(&mut self, x: f32, y: f32, z: f32, w: f32) {
        if self.compile(move |cx| cx.raster_pos(x, y, z, w)) || self.inside_begin_end() {
            return;
        }
        let object = [x, y, z, w];
        let eye = *self.modelview.top() * Vec4::from(object);
        let attributes = self.state.current.attributes;
        let mut color = attributes[slot::COLOR];
        let mut secondary_color = attributes[slot::SECONDARY_COLOR];
        let mut tex_coords = self.transformed_tex_coords(&attributes);
        let run = Run { mask: 1, data: &[object], count: 1, edge_flags: None };
        let shaded = self.shade_on_host(topology::POINTS, &run);
        let (clip, inside) = match &shaded {
            Some(vertices) => {
                let vertex = vertices.shaded(0);
                let output = |output| vertices.index_of(output).map(|k| vertex[k]);
                color = output(Output::FrontColor).unwrap_or(color);
                secondary_color = output(Output::FrontSecondary).unwrap_or(secondary_color);
                for (unit, coords) in tex_coords.iter_mut().enumerate() {
                    *coords = output(Output::TexCoord(unit as u8)).unwrap_or(*coords);
                }
                (vertex[0], vertices.screen[0].code == 0)
            }
            None => {
                let clip = *self.projection.top() * eye;
                (clip.to_array(), clip.x.abs() <= clip.w && clip.y.abs() <= clip.w && clip.z.abs() <= clip.w)
            }
        };
        let valid = inside && clip[3] > 0.0;
        self.state.current.raster.valid = valid;
        if !valid {
            return;
        }
        let [x, y, z] = self.to_window(clip);
        let index = self.state.current.index;
        let distance = if self.state.fog.coord_source == GL_FOG_COORD { attributes[slot::FOG_COORD][0] } else { eye.truncate().length() };
        let raster = &mut self.state.current.raster;
        raster.position = [x, y, z, clip[3]];
        raster.distance = distance;
        raster.color = color.map(clamp01);
        raster.secondary_color = secondary_color.map(clamp01);
        raster.tex_coords = tex_coords;
        raster.index = index;
        self.record_hit(z);
    }

    /// glWindowPos*: window coordinates, no transformation, no clipping. `z` is clamped to [0, 1] and mapped to the depth
    /// range.
    pub fn window_pos(&mut self, x: f32, y: f32, z: f32) {
        if self.compile(move |cx| cx.window_pos(x, y, z)) || self.inside_begin_end() {
            return;
        }
        let (near, far) = (self.state.viewport.near as f32, self.state.viewport.far as f32);
        let z = near + clamp01(z) * (far - near);
        let fog_coord = self.state.fog.coord_source == GL_FOG_COORD;
        let current = &mut self.state.current;
        let attributes = &current.attributes;
        let raster = &mut current.raster;
        raster.position = [x, y, z, 1.0];
        raster.distance = if fog_coord { attributes[slot::FOG_COORD][0] } else { 0.0 };
        raster.color = attributes[slot::COLOR].map(clamp01);
        raster.secondary_color = attributes[slot::SECONDARY_COLOR].map(clamp01);
        raster.tex_coords = std::array::from_fn(|unit| attributes[slot::TEX_COORD0 + unit]);
        raster.index = current.index;
        raster.valid = true;
        self.record_hit(z);
    }

    /// Texture coordinates of a vertex through the texture matrices, without generation.
    pub(crate) fn transformed_tex_coords(&self, attributes: &[[f32; 4]; 16]) -> [[f32; 4]; MAX_TEXTURE_UNITS] {
        std::array::from_fn(|unit| (*self.texture_matrices[unit].top() * Vec4::from(attributes[slot::TEX_COORD0 + unit])).to_array())
    }
}
