//! Lighting and materials (2.14) and the shade model (2.14.7).
//!
//! While GL_COLOR_MATERIAL is on, the tracked material values follow the current colour. The vertex program reads the
//! colour attribute in their place; the values kept here are brought up to date only when someone can see them.

use glam::{Mat3, Vec3, Vec4};

use super::checks::{Params, enum_from, faces, put, vec4};
use super::derived::{light_kind, shines};
use super::enable::index_below;
use super::enums::*;
use super::query::{Kind, Value};
use super::state::{MAX_LIGHTS, Material};
use super::{Context, dirty};

/// Attribute slot of the primary colour.
const COLOR: usize = 3;

impl Context {
    /// glShadeModel.
    pub fn shade_model(&mut self, mode: GLenum) {
        if self.compile(move |cx| cx.shade_model(mode)) || self.inside_begin_end() {
            return;
        }
        if mode != GL_FLAT && mode != GL_SMOOTH {
            return self.set_error(GL_INVALID_ENUM, "glShadeModel");
        }
        put(&mut self.state.lighting.shade_model, mode, &mut self.dirty, dirty::LIGHTING);
    }

    /// glLight{if}[v]. A slice of one is the scalar form.
    pub fn light(&mut self, light: GLenum, pname: GLenum, params: &[f32]) {
        let given = Params::new(params);
        if self.compile(move |cx| cx.light(light, pname, given.as_slice())) || self.inside_begin_end() {
            return;
        }
        let Some(index) = index_below(light, GL_LIGHT0, MAX_LIGHTS) else {
            return self.set_error(GL_INVALID_ENUM, "glLight");
        };
        let modelview = *self.modelview.top();
        let slot = &mut self.state.lighting.lights[index];
        let kind = light_kind(slot);
        let scalar = params.first().copied().unwrap_or(0.0);
        match (pname, vec4(params)) {
            (GL_AMBIENT, Some(v)) => slot.ambient = v,
            (GL_DIFFUSE, Some(v)) => slot.diffuse = v,
            (GL_SPECULAR, Some(v)) => slot.specular = v,
            (GL_POSITION, Some(v)) => slot.position = modelview * Vec4::from(v),
            (GL_SPOT_DIRECTION, _) if params.len() >= 3 => {
                slot.spot_direction = Mat3::from_mat4(modelview) * Vec3::new(params[0], params[1], params[2]);
            }
            (GL_SPOT_EXPONENT, _) => {
                if !(0.0..=128.0).contains(&scalar) {
                    return self.set_error(GL_INVALID_VALUE, "glLight(GL_SPOT_EXPONENT)");
                }
                slot.spot_exponent = scalar;
            }
            (GL_SPOT_CUTOFF, _) => {
                if !(0.0..=90.0).contains(&scalar) && scalar != 180.0 {
                    return self.set_error(GL_INVALID_VALUE, "glLight(GL_SPOT_CUTOFF)");
                }
                slot.spot_cutoff = scalar;
            }
            (GL_CONSTANT_ATTENUATION..=GL_QUADRATIC_ATTENUATION, _) => {
                if scalar.is_nan() || scalar < 0.0 {
                    return self.set_error(GL_INVALID_VALUE, "glLight(attenuation)");
                }
                slot.attenuation[(pname - GL_CONSTANT_ATTENUATION) as usize] = scalar;
            }
            _ => return self.set_error(GL_INVALID_ENUM, "glLight"),
        }
        self.dirty |= if light_kind(slot) == kind { dirty::LIGHT_VALUES } else { dirty::LIGHTING };
    }

    /// glLightModel{if}[v]. A slice of one is the scalar form.
    pub fn light_model(&mut self, pname: GLenum, params: &[f32]) {
        let given = Params::new(params);
        if self.compile(move |cx| cx.light_model(pname, given.as_slice())) || self.inside_begin_end() {
            return;
        }
        let lighting = &mut self.state.lighting;
        let scalar = params.first().copied().unwrap_or(0.0);
        match (pname, vec4(params)) {
            (GL_LIGHT_MODEL_AMBIENT, Some(v)) => return put(&mut lighting.model_ambient, v, &mut self.dirty, dirty::LIGHT_VALUES),
            (GL_LIGHT_MODEL_LOCAL_VIEWER, _) => lighting.local_viewer = scalar != 0.0,
            (GL_LIGHT_MODEL_TWO_SIDE, _) => lighting.two_side = scalar != 0.0,
            (GL_LIGHT_MODEL_COLOR_CONTROL, _) if matches!(enum_from(scalar), GL_SINGLE_COLOR | GL_SEPARATE_SPECULAR_COLOR) => {
                lighting.color_control = enum_from(scalar);
            }
            _ => return self.set_error(GL_INVALID_ENUM, "glLightModel"),
        }
        self.dirty |= dirty::LIGHTING;
    }

    /// glMaterial{if}[v]. A slice of one is the scalar form. Legal between Begin and End.
    pub fn material(&mut self, face: GLenum, pname: GLenum, params: &[f32]) {
        let given = Params::new(params);
        if self.compile(move |cx| cx.material(face, pname, given.as_slice())) {
            return;
        }
        let Some(range) = faces(face) else {
            return self.set_error(GL_INVALID_ENUM, "glMaterial");
        };
        let Some(scalar) = params.first().copied() else { return };
        let color = vec4(params);
        let legal = match pname {
            GL_AMBIENT | GL_DIFFUSE | GL_SPECULAR | GL_EMISSION | GL_AMBIENT_AND_DIFFUSE => color.is_some(),
            GL_COLOR_INDEXES => params.len() >= 3,
            GL_SHININESS => true,
            _ => false,
        };
        if !legal {
            return self.set_error(GL_INVALID_ENUM, "glMaterial");
        }
        if pname == GL_SHININESS && !(0.0..=128.0).contains(&scalar) {
            return self.set_error(GL_INVALID_VALUE, "glMaterial(GL_SHININESS)");
        }
        let mut changed = self.state.lighting.materials.clone();
        for material in &mut changed[range] {
            match (pname, color) {
                (GL_SHININESS, _) => material.shininess = scalar,
                (GL_COLOR_INDEXES, _) => material.color_indexes = [params[0], params[1], params[2]],
                (_, Some(color)) => colors_of(material, pname).for_each(|slot| *slot = color),
                _ => {}
            }
        }
        if changed != self.state.lighting.materials {
            if self.immediate.is_inside() {
                self.shade_before_change();
            }
            let materials = std::mem::replace(&mut self.state.lighting.materials, changed);
            let same_kind = materials.iter().zip(&self.state.lighting.materials).all(|(old, new)| shines(old) == shines(new));
            self.dirty |= if same_kind { dirty::LIGHT_VALUES } else { dirty::LIGHTING };
        }
    }

    /// glColorMaterial.
    pub fn color_material(&mut self, face: GLenum, mode: GLenum) {
        if self.compile(move |cx| cx.color_material(face, mode)) || self.inside_begin_end() {
            return;
        }
        let is_mode = matches!(mode, GL_AMBIENT | GL_DIFFUSE | GL_SPECULAR | GL_EMISSION | GL_AMBIENT_AND_DIFFUSE);
        if faces(face).is_none() || !is_mode {
            return self.set_error(GL_INVALID_ENUM, "glColorMaterial");
        }
        self.sync_color_material();
        put(&mut self.state.lighting.color_material_face, face, &mut self.dirty, dirty::LIGHTING);
        put(&mut self.state.lighting.color_material_mode, mode, &mut self.dirty, dirty::LIGHTING);
        self.sync_color_material();
    }

    /// While GL_COLOR_MATERIAL is on: copies the current colour into the material values that follow it.
    pub(crate) fn sync_color_material(&mut self) {
        let lighting = &mut self.state.lighting;
        if !lighting.color_material {
            return;
        }
        let color = self.state.current.attributes[COLOR];
        let Some(range) = faces(lighting.color_material_face) else { return };
        for material in &mut lighting.materials[range] {
            for slot in colors_of(material, lighting.color_material_mode) {
                *slot = color;
            }
        }
    }

    /// glGetLight{if}v: the value in its own type, or nothing after an error.
    pub fn get_light(&mut self, light: GLenum, pname: GLenum) -> Option<Value> {
        if self.inside_begin_end() {
            return None;
        }
        let value = index_below(light, GL_LIGHT0, MAX_LIGHTS).and_then(|index| {
            let light = &self.state.lighting.lights[index];
            Some(match pname {
                GL_AMBIENT => Value::normalized(&light.ambient),
                GL_DIFFUSE => Value::normalized(&light.diffuse),
                GL_SPECULAR => Value::normalized(&light.specular),
                GL_POSITION => Value::floats(&light.position.to_array()),
                GL_SPOT_DIRECTION => Value::floats(&light.spot_direction.to_array()),
                GL_SPOT_EXPONENT => Value::floats(&[light.spot_exponent]),
                GL_SPOT_CUTOFF => Value::floats(&[light.spot_cutoff]),
                GL_CONSTANT_ATTENUATION..=GL_QUADRATIC_ATTENUATION => {
                    Value::floats(&[light.attenuation[(pname - GL_CONSTANT_ATTENUATION) as usize]])
                }
                _ => return None,
            })
        });
        self.value_or_error(value, "glGetLight")
    }

    /// glGetMaterial{if}v: the value in its own type, or nothing after an error.
    pub fn get_material(&mut self, face: GLenum, pname: GLenum) -> Option<Value> {
        if self.inside_begin_end() {
            return None;
        }
        self.sync_color_material();
        let side = match face {
            GL_FRONT => Some(0),
            GL_BACK => Some(1),
            _ => None,
        };
        let value = side.and_then(|side| {
            let material = &self.state.lighting.materials[side];
            Some(match pname {
                GL_AMBIENT => Value::normalized(&material.ambient),
                GL_DIFFUSE => Value::normalized(&material.diffuse),
                GL_SPECULAR => Value::normalized(&material.specular),
                GL_EMISSION => Value::normalized(&material.emission),
                GL_SHININESS => Value::floats(&[material.shininess]),
                GL_COLOR_INDEXES => Value::new(Kind::Float, material.color_indexes.iter().map(|&v| v as f64)),
                _ => return None,
            })
        });
        self.value_or_error(value, "glGetMaterial")
    }
}

/// The colours of a material that a parameter name stands for.
fn colors_of(material: &mut Material, pname: GLenum) -> impl Iterator<Item = &mut [f32; 4]> {
    let (first, second) = match pname {
        GL_AMBIENT => (Some(&mut material.ambient), None),
        GL_DIFFUSE => (Some(&mut material.diffuse), None),
        GL_SPECULAR => (Some(&mut material.specular), None),
        GL_EMISSION => (Some(&mut material.emission), None),
        GL_AMBIENT_AND_DIFFUSE => (Some(&mut material.ambient), Some(&mut material.diffuse)),
        _ => (None, None),
    };
    first.into_iter().chain(second)
}
