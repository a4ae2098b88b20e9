//! Texture coordinate generation (2.11.4).

use glam::Vec4;

use super::checks::{Params, enum_from, put, vec4};
use super::clip_plane::plane_through_inverse;
use super::enable::index_below;
use super::enums::*;
use super::query::{Kind, Value};
use super::{Context, dirty};

impl Context {
    /// glTexGen{ifd}[v] of the active unit. A slice of one is the scalar form. Eye planes are kept multiplied by the
    /// inverse model-view matrix.
    pub fn tex_gen(&mut self, coord: GLenum, pname: GLenum, params: &[f32]) {
        let given = Params::new(params);
        if self.compile(move |cx| cx.tex_gen(coord, pname, given.as_slice())) || self.inside_begin_end() {
            return;
        }
        let Some(index) = index_below(coord, GL_S, 4) else {
            return self.set_error(GL_INVALID_ENUM, "glTexGen");
        };
        let modelview = *self.modelview.top();
        let active = self.state.texture.active;
        let texgen = &mut self.state.texture.units[active].texgen[index];
        match (pname, vec4(params)) {
            (GL_TEXTURE_GEN_MODE, _) => {
                let mode = enum_from(params.first().copied().unwrap_or(0.0));
                let legal = match mode {
                    GL_OBJECT_LINEAR | GL_EYE_LINEAR => true,
                    GL_SPHERE_MAP => index < 2,
                    GL_NORMAL_MAP | GL_REFLECTION_MAP => index < 3,
                    _ => false,
                };
                if !legal {
                    return self.set_error(GL_INVALID_ENUM, "glTexGen(GL_TEXTURE_GEN_MODE)");
                }
                put(&mut texgen.mode, mode, &mut self.dirty, dirty::TEXTURE);
            }
            (GL_OBJECT_PLANE, Some(plane)) => put(&mut texgen.object_plane, Vec4::from(plane), &mut self.dirty, dirty::TEXTURE),
            (GL_EYE_PLANE, Some(plane)) => {
                let plane = plane_through_inverse(&modelview, Vec4::from(plane).as_dvec4()).as_vec4();
                put(&mut texgen.eye_plane, plane, &mut self.dirty, dirty::TEXTURE);
            }
            _ => self.set_error(GL_INVALID_ENUM, "glTexGen"),
        }
    }

    /// glGetTexGen{ifd}v: the value in its own type, or nothing after an error.
    pub fn get_tex_gen(&mut self, coord: GLenum, pname: GLenum) -> Option<Value> {
        if self.inside_begin_end() {
            return None;
        }
        let unit = &self.state.texture.units[self.state.texture.active];
        let value = index_below(coord, GL_S, 4).and_then(|index| {
            let texgen = &unit.texgen[index];
            match pname {
                GL_TEXTURE_GEN_MODE => Some(Value::new(Kind::Int, [texgen.mode as f64])),
                GL_OBJECT_PLANE => Some(Value::floats(&texgen.object_plane.to_array())),
                GL_EYE_PLANE => Some(Value::floats(&texgen.eye_plane.to_array())),
                _ => None,
            }
        });
        self.value_or_error(value, "glGetTexGen")
    }
}
