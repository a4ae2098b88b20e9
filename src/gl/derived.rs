//! The derived state: from what the application has said to what a draw needs. Each part is recomputed only when a
//! group of state that it reads has changed ([`dirty`]).

use std::sync::Arc;

use glam::{Mat4, Vec4};

use super::enums::*;
use super::{Context, dirty};
use crate::draw::recorder::DrawState;
use crate::draw::texture::TextureBinding;
use crate::program::Output;
use crate::program::fixed::{self, FixedProgram, Fog, FogCoord, FragmentKey, Slot, VertexKey};
use crate::raster::layout::*;

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
        let mut d = std::mem::take(&mut self.derived);
        let everything = self.render_mode != GL_RENDER || self.shading_on_host;
        let changed = self.dirty | if d.topology != topology || d.everything != everything { dirty::ALL } else { 0 };
        (d.topology, d.everything) = (topology, everything);

        if changed & (dirty::TEXTURE | dirty::FOG | dirty::LIGHTING) != 0 || d.fragment.is_none() {
            let key = self.fragment_key(&mut d.textures);
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
            let values = self.slot_values();
            d.vertex_uniforms.clear();
            d.vertex_uniforms.extend(vertex.slots.iter().map(|slot| values.value(self, *slot)));
            d.fragment_uniforms.clear();
            d.fragment_uniforms.extend(fragment.slots.iter().map(|slot| values.value(self, *slot)));
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

    fn fragment_key(&self, textures: &mut Vec<TextureBinding>) -> FragmentKey {
        let s = &self.state;
        textures.clear();
        let separate = s.lighting.enabled && s.lighting.color_control == GL_SEPARATE_SPECULAR_COLOR;
        FragmentKey {
            flat: s.lighting.shade_model == GL_FLAT,
            two_side: s.lighting.enabled && s.lighting.two_side,
            color_sum: separate || (s.lighting.color_sum && !s.lighting.enabled),
            fog: match (s.fog.enabled, s.fog.mode) {
                (false, _) => Fog::None,
                (true, GL_LINEAR) => Fog::Linear,
                (true, GL_EXP) => Fog::Exp,
                (true, _) => Fog::Exp2,
            },
            ..FragmentKey::default()
        }
    }

    fn vertex_key(&self, fragment: &FixedProgram, topology: u32, everything: bool) -> VertexKey {
        let s = &self.state;
        let reads = |output: Output| everything || fragment.program.varyings.iter().any(|v| v.front == output);
        let points = topology == topology::POINTS || s.polygon.mode != [GL_FILL; 2];
        VertexKey {
            color: reads(Output::FrontColor),
            secondary: reads(Output::FrontSecondary),
            fog: match (reads(Output::Fog), s.fog.coord_source) {
                (false, _) => FogCoord::None,
                (true, GL_FOG_COORD) => FogCoord::Attribute,
                (true, _) => FogCoord::EyeZ,
            },
            clip_planes: s.transform.clip_enabled.iter().filter(|e| **e).count() as u8,
            point_attenuation: points && s.point.attenuation != [1.0, 0.0, 0.0],
        }
    }

    fn slot_values(&self) -> SlotValues {
        SlotValues { mvp: super::matrix::multiply(self.projection.top(), self.modelview.top()) }
    }
}

/// Values that several slots share.
struct SlotValues {
    mvp: Mat4,
}

impl SlotValues {
    fn value(&self, cx: &Context, slot: Slot) -> [f32; 4] {
        let s = &cx.state;
        match slot {
            Slot::Mvp(c) => self.mvp.col(c as usize).to_array(),
            Slot::ModelView(c) => cx.modelview.top().col(c as usize).to_array(),
            Slot::ClipPlane(n) => {
                let enabled = (0..s.transform.clip_enabled.len()).filter(|k| s.transform.clip_enabled[*k]);
                enabled.skip(n as usize).map(|k| s.transform.clip_planes[k]).next().unwrap_or(Vec4::ZERO).to_array()
            }
            Slot::PointSize => [s.point.size, s.point.size_min.max(1.0), s.point.size_max.max(1.0), 0.0],
            Slot::PointAttenuation => [s.point.attenuation[0], s.point.attenuation[1], s.point.attenuation[2], 0.0],
            Slot::FogColor => s.fog.color,
            Slot::FogParameters => fog_parameters(&s.fog),
            Slot::EnvColor(unit) => s.texture.units[unit as usize].env_color,
            _ => [0.0; 4],
        }
    }
}

fn fog_parameters(fog: &super::state::FogState) -> [f32; 4] {
    let x = match fog.mode {
        GL_LINEAR => {
            let scale = if fog.end == fog.start { 1.0 } else { 1.0 / (fog.end - fog.start) };
            return [-scale, fog.end * scale, 0.0, 0.0];
        }
        GL_EXP => -fog.density * std::f32::consts::LOG2_E,
        _ => fog.density * std::f32::consts::LOG2_E.sqrt(),
    };
    [x, 0.0, 0.0, 0.0]
}
