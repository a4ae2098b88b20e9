//! The derived state: from what the application has said to what a draw needs. Each part is recomputed only when a
//! group of state that it reads has changed ([`dirty`]).

use std::sync::Arc;

use super::enums::*;
use super::{Context, dirty};
use crate::draw::recorder::DrawState;
use crate::draw::texture::TextureBinding;
use crate::program::fixed::{self, FixedProgram, FragmentKey, VertexKey};
use crate::raster::layout::*;

mod keys;
mod pixels;
#[cfg(test)]
mod tests;
mod uniforms;

/// The parts of the derived state, kept from draw to draw.
#[derive(Default)]
pub(crate) struct Derived {
    fragment_key: FragmentKey,
    vertex_key: VertexKey,
    vertex: Option<Arc<FixedProgram>>,
    fragment: Option<Arc<FixedProgram>>,
    vertex_uniforms: Vec<[f32; 4]>,
    fragment_uniforms: Vec<[f32; 4]>,
    raster_state: Option<RasterState>,
    fragment_state: Option<FragmentState>,
    textures: Vec<TextureBinding>,
    topology: u32,
    /// All vertex outputs are wanted, not only those that the fragment program reads.
    everything: bool,
}

impl Context {
    /// Computes what a draw of this topology sees and tells the recorder.
    pub(super) fn derive_state(&mut self, topology: u32) {
        if self.dirty & dirty::TEXTURE != 0 {
            self.settle_sampled_textures();
        }
        let mut d = std::mem::take(&mut self.derived);
        let everything = self.render_mode != GL_RENDER || self.shading_on_host;
        // Only the vertex key depends on these two.
        let changed = self.dirty | if d.topology != topology || d.everything != everything { dirty::RASTER } else { 0 };
        (d.topology, d.everything) = (topology, everything);

        if changed & (dirty::TEXTURE | dirty::FOG | dirty::LIGHTING | dirty::RASTER) != 0 || d.fragment.is_none() {
            let key = self.fragment_key(topology, &mut d.textures);
            if key != d.fragment_key || d.fragment.is_none() {
                d.fragment_key = key;
                d.fragment = Some(fixed::fragment_program(&key));
            }
        }
        let fragment = d.fragment.get_or_insert_with(|| fixed::fragment_program(&FragmentKey::default())).clone();
        if changed & (dirty::TEXTURE | dirty::FOG | dirty::LIGHTING | dirty::TRANSFORM | dirty::RASTER) != 0 || d.vertex.is_none() {
            let key = self.vertex_key(&fragment, topology, everything);
            if key != d.vertex_key || d.vertex.is_none() {
                d.vertex_key = key;
                d.vertex = Some(fixed::vertex_program(&key));
            }
        }
        let vertex = d.vertex.get_or_insert_with(|| fixed::vertex_program(&VertexKey::default())).clone();
        if changed & !dirty::FRAGMENT != 0 {
            let values = uniforms::Values::new(self);
            d.vertex_uniforms.clear();
            d.vertex_uniforms.extend(vertex.slots.iter().map(|slot| values.value(*slot)));
            d.fragment_uniforms.clear();
            d.fragment_uniforms.extend(fragment.slots.iter().map(|slot| values.value(*slot)));
        }
        let raster_state = match d.raster_state {
            Some(state) if changed & (dirty::TRANSFORM | dirty::RASTER | dirty::SURFACE) == 0 => state,
            _ => self.raster_state(),
        };
        let fragment_state = match d.fragment_state {
            Some(state) if changed & (dirty::FRAGMENT | dirty::SURFACE) == 0 => state,
            _ => self.fragment_state(),
        };
        (d.raster_state, d.fragment_state) = (Some(raster_state), Some(fragment_state));

        let stipple = self.state.polygon.stipple && topology == topology::TRIANGLES;
        self.recorder.set_state(&DrawState {
            topology,
            vertex_program: &vertex.program,
            fragment_program: &fragment.program,
            vertex_uniforms: &d.vertex_uniforms,
            fragment_uniforms: &d.fragment_uniforms,
            raster_state,
            fragment_state,
            textures: &d.textures,
            stipple: stipple.then_some(&self.state.polygon_stipple),
            clip_distance_count: u32::from(d.vertex_key.clip_planes),
        });
        self.derived = d;
        self.derived_topology = topology;
        self.dirty = 0;
    }
}
