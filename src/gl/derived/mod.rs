//! The derived state: from what the application has said to what a draw needs. Each part is recomputed only when a
//! group of state that it reads has changed ([`dirty`]).

use std::sync::Arc;

use super::enums::*;
use super::{Context, dirty};
use crate::draw::recorder::{DrawState, Revised};
use crate::draw::texture::TextureBinding;
use crate::program::fixed::{self, FixedProgram, FragmentKey, VertexKey};
use crate::raster::layout::*;

#[cfg(test)]
mod change_tests;
mod keys;
mod pixels;
#[cfg(test)]
mod tests;
mod uniforms;

pub(super) use keys::{light_kind, shines};

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
    /// Numbers of the last changes of the four above.
    revisions: Revisions,
    textures: Vec<TextureBinding>,
    topology: u32,
    /// All vertex outputs are wanted, not only those that the fragment program reads.
    everything: bool,
}

#[derive(Default)]
struct Revisions {
    vertex_uniforms: u64,
    fragment_uniforms: u64,
    raster_state: u64,
    fragment_state: u64,
}

/// Groups that the fragment program's key is made of, the vertex program's, and the values of uniform blocks.
const FRAGMENT_KEY: u32 = dirty::TEXTURE | dirty::FOG | dirty::LIGHTING | dirty::RASTER;
const VERTEX_KEY: u32 = FRAGMENT_KEY | dirty::TRANSFORM;
const UNIFORMS: u32 = VERTEX_KEY | dirty::LIGHT_VALUES;

impl Context {
    /// Computes what a draw of this topology sees and tells the recorder.
    pub(super) fn derive_state(&mut self, topology: u32) {
        if self.dirty & dirty::TEXTURE != 0 {
            self.settle_sampled_textures();
        }
        // Not there after a panic: then nothing is known.
        let (mut boxed, dirty) = self.derived.take().map_or_else(|| (Box::default(), dirty::ALL), |derived| (derived, self.dirty));
        let d: &mut Derived = &mut boxed;
        let everything = self.render_mode != GL_RENDER || self.shading_on_host;
        // Only the vertex key depends on these two.
        let changed = dirty | if d.topology != topology || d.everything != everything { dirty::RASTER } else { 0 };
        (d.topology, d.everything) = (topology, everything);

        self.revision += 1;
        let (revision, revisions) = (self.revision, &mut d.revisions);

        // Values of uniforms that may be out of date: of a new program all.
        let (mut vertex_stale, mut fragment_stale) = (changed, changed);
        if changed & FRAGMENT_KEY != 0 || d.fragment.is_none() {
            let key = self.fragment_key(topology, &mut d.textures);
            if key != d.fragment_key || d.fragment.is_none() {
                d.fragment_key = key;
                d.fragment = Some(fixed::fragment_program(&key));
                fragment_stale = dirty::ALL;
            }
        }
        let fragment = d.fragment.get_or_insert_with(|| fixed::fragment_program(&FragmentKey::default()));
        if changed & VERTEX_KEY != 0 || d.vertex.is_none() {
            let key = self.vertex_key(fragment, topology, everything);
            if key != d.vertex_key || d.vertex.is_none() {
                d.vertex_key = key;
                d.vertex = Some(fixed::vertex_program(&key));
                vertex_stale = dirty::ALL;
            }
        }
        let vertex = d.vertex.get_or_insert_with(|| fixed::vertex_program(&VertexKey::default()));
        if changed & UNIFORMS != 0 {
            let values = uniforms::Values::new(self);
            if values.update(&mut d.vertex_uniforms, &vertex.slots, vertex_stale) {
                revisions.vertex_uniforms = revision;
            }
            if values.update(&mut d.fragment_uniforms, &fragment.slots, fragment_stale) {
                revisions.fragment_uniforms = revision;
            }
        }
        if changed & (dirty::TRANSFORM | dirty::RASTER | dirty::SURFACE) != 0 {
            (d.raster_state, revisions.raster_state) = (None, revision);
        }
        if changed & (dirty::FRAGMENT | dirty::SURFACE) != 0 {
            (d.fragment_state, revisions.fragment_state) = (None, revision);
        }
        let stipple = self.state.polygon.stipple && topology == topology::TRIANGLES;
        let state = DrawState {
            topology,
            vertex_program: &vertex.program,
            fragment_program: &fragment.program,
            vertex_uniforms: Revised { content: &d.vertex_uniforms, revision: revisions.vertex_uniforms },
            fragment_uniforms: Revised { content: &d.fragment_uniforms, revision: revisions.fragment_uniforms },
            raster_state: Revised { content: d.raster_state.get_or_insert_with(|| self.raster_state()), revision: revisions.raster_state },
            fragment_state: Revised {
                content: d.fragment_state.get_or_insert_with(|| self.fragment_state()),
                revision: revisions.fragment_state,
            },
            textures: &d.textures,
            stipple: stipple.then_some(&self.state.polygon_stipple),
            clip_distance_count: u32::from(d.vertex_key.clip_planes),
        };
        self.recorder.set_state(&state);
        self.derived = Some(boxed);
        self.derived_topology = topology;
        self.dirty = 0;
    }
}
