//! The values of the uniform blocks of fixed-function programs.

use std::cell::OnceCell;

use glam::{Mat4, Vec3, Vec4};

use crate::gl::enums::*;
use crate::gl::parity::plane_through_osmesas_inverse;
use crate::gl::state::FogState;
use crate::gl::{Context, Parity, dirty, matrix};
use crate::program::fixed::Slot;

/// Computes slots; what several of them share is computed once.
pub(super) struct Values<'a> {
    cx: &'a Context,
    mvp: OnceCell<Mat4>,
    normal: OnceCell<[[f32; 4]; 3]>,
}

impl<'a> Values<'a> {
    pub fn new(cx: &'a Context) -> Values<'a> {
        Values { cx, mvp: OnceCell::new(), normal: OnceCell::new() }
    }

    /// Fills a program's block, and says whether it may have changed. Values of groups that are not in `stale` are kept; the block of
    /// another program is stale altogether.
    pub fn update(&self, block: &mut Vec<[f32; 4]>, slots: &[Slot], stale: u32) -> bool {
        let mut changed = stale == dirty::ALL;
        block.resize(slots.len(), [0.0; 4]);
        for (value, &slot) in block.iter_mut().zip(slots).filter(|(_, slot)| groups(**slot) & stale != 0) {
            *value = self.value(slot);
            changed = true;
        }
        changed
    }

    fn value(&self, slot: Slot) -> [f32; 4] {
        let cx = self.cx;
        let s = &cx.state;
        let light = |i: u8| &s.lighting.lights[i as usize & 7];
        let material = |face: u8| &s.lighting.materials[face as usize & 1];
        let unit = |u: u8| &s.texture.units[u as usize & 7];
        match slot {
            Slot::Mvp(c) => {
                let mvp = self.mvp.get_or_init(|| matrix::multiply(cx.projection.top(), cx.modelview.top()));
                mvp.col(c as usize).to_array()
            }
            Slot::ModelView(c) => cx.modelview.top().col(c as usize).to_array(),
            Slot::NormalRow(r) => self.normal.get_or_init(|| normal_rows(cx.modelview.top()))[r as usize],
            Slot::SceneColor(face) => {
                let m = material(face);
                let sum = |c: usize| m.emission[c] + m.ambient[c] * s.lighting.model_ambient[c];
                [sum(0), sum(1), sum(2), m.diffuse[3]]
            }
            Slot::ModelAmbient => s.lighting.model_ambient,
            Slot::Emission(face) => material(face).emission,
            Slot::MaterialAmbient(face) => material(face).ambient,
            Slot::AmbientProduct(face, i) => product(&light(i).ambient, &material(face).ambient),
            Slot::DiffuseProduct(face, i) => product(&light(i).diffuse, &material(face).diffuse),
            Slot::SpecularProduct(face, i) => product(&light(i).specular, &material(face).specular),
            Slot::LightAmbient(i) => light(i).ambient,
            Slot::LightDiffuse(i) => light(i).diffuse,
            Slot::LightSpecular(i) => light(i).specular,
            Slot::LightPosition(i) => light_position(light(i).position),
            Slot::LightHalf(i) => {
                let to = light_position(light(i).position);
                unit_vector(Vec3::new(to[0], to[1], to[2] + 1.0)).extend(0.0).to_array()
            }
            Slot::LightAttenuation(i) => {
                let [k0, k1, k2] = light(i).attenuation;
                [k0, k1, k2, 0.0]
            }
            Slot::LightSpot(i) => {
                let cosine = (f64::from(light(i).spot_cutoff).to_radians().cos()) as f32;
                unit_vector(light(i).spot_direction).extend(cosine).to_array()
            }
            Slot::LightExponent(i) => [light(i).spot_exponent, 0.0, 0.0, 0.0],
            Slot::Shininess(face) => [material(face).shininess, 0.0, 0.0, 0.0],
            Slot::TextureMatrix(u, c) => cx.texture_matrices.get(u as usize).map_or(Vec4::ZERO, |m| m.top().col(c as usize)).to_array(),
            Slot::ObjectPlane(u, c) => unit(u).texgen[c as usize & 3].object_plane.to_array(),
            Slot::EyePlane(u, c) => unit(u).texgen[c as usize & 3].eye_plane.to_array(),
            Slot::ClipPlane(n) => {
                let enabled = (0..s.transform.clip_enabled.len()).filter(|k| s.transform.clip_enabled[*k]);
                let plane = enabled.skip(n as usize).map(|k| s.transform.clip_planes[k]).next().unwrap_or(Vec4::ZERO);
                match cx.config.parity {
                    Parity::Specification => plane.to_array(),
                    Parity::Osmesa => plane_through_osmesas_inverse(cx.projection.top(), plane).to_array(),
                }
            }
            Slot::PointSize => [s.point.size, s.point.size_min.max(1.0), s.point.size_max.clamp(1.0, 255.0), 0.0],
            Slot::PointAttenuation => [s.point.attenuation[0], s.point.attenuation[1], s.point.attenuation[2], 0.0],
            Slot::FogColor => s.fog.color,
            Slot::FogParameters => fog_parameters(&s.fog),
            Slot::EnvColor(u) => unit(u).env_color,
        }
    }
}

/// The groups of state that a slot's value is made of.
fn groups(slot: Slot) -> u32 {
    match slot {
        Slot::Mvp(_) | Slot::ModelView(_) | Slot::NormalRow(_) | Slot::TextureMatrix(..) => dirty::TRANSFORM,
        Slot::SceneColor(_)
        | Slot::ModelAmbient
        | Slot::Emission(_)
        | Slot::MaterialAmbient(_)
        | Slot::AmbientProduct(..)
        | Slot::DiffuseProduct(..)
        | Slot::SpecularProduct(..)
        | Slot::LightAmbient(_)
        | Slot::LightDiffuse(_)
        | Slot::LightSpecular(_)
        | Slot::LightPosition(_)
        | Slot::LightHalf(_)
        | Slot::LightAttenuation(_)
        | Slot::LightSpot(_)
        | Slot::LightExponent(_)
        | Slot::Shininess(_) => dirty::LIGHTING | dirty::LIGHT_VALUES,
        Slot::ObjectPlane(..) | Slot::EyePlane(..) | Slot::EnvColor(_) => dirty::TEXTURE,
        Slot::ClipPlane(_) => dirty::RASTER | dirty::TRANSFORM,
        Slot::PointSize | Slot::PointAttenuation => dirty::RASTER,
        Slot::FogColor | Slot::FogParameters => dirty::FOG,
    }
}

fn product(a: &[f32; 4], b: &[f32; 4]) -> [f32; 4] {
    std::array::from_fn(|c| a[c] * b[c])
}

/// Length 1, or the zero vector as it is.
fn unit_vector(v: Vec3) -> Vec3 {
    let v = v.as_dvec3();
    let length = v.length();
    if length > 0.0 { (v / length).as_vec3() } else { v.as_vec3() }
}

/// Eye position, or the unit vector towards a light at infinity.
fn light_position(p: Vec4) -> [f32; 4] {
    if p.w != 0.0 { (p / p.w).to_array() } else { unit_vector(p.truncate()).extend(0.0).to_array() }
}

/// Rows of the inverse of the upper left 3 x 3, in f64 so that ill-conditioned matrices light well. w of the first: the factor of
/// GL_RESCALE_NORMAL (2.11.3).
fn normal_rows(modelview: &Mat4) -> [[f32; 4]; 3] {
    let m = modelview.as_dmat4();
    let inverse = glam::DMat3::from_cols(m.x_axis.truncate(), m.y_axis.truncate(), m.z_axis.truncate()).inverse();
    let third = inverse.row(2).length();
    let rescale = if third > 0.0 { 1.0 / third } else { 1.0 };
    let mut rows = [0, 1, 2].map(|r| {
        let row = inverse.row(r);
        // A singular matrix has no normals: zeros instead of NaN.
        if row.is_finite() { row.as_vec3().extend(0.0).to_array() } else { [0.0; 4] }
    });
    rows[0][3] = rescale as f32;
    rows
}

fn fog_parameters(fog: &FogState) -> [f32; 4] {
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
