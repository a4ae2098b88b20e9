//! Texture environment (3.8.13): the modes of 1.1, the combiner, the unit's bias, point sprites' coordinates.

use super::checks::{Params, clamp01, enum_from, put, vec4};
use super::enable::index_below;
use super::enums::*;
use super::query::{Kind, Value};
use super::state::{MAX_TEXTURE_UNITS, TextureUnit};
use super::{Context, dirty};

impl Context {
    /// glActiveTexture.
    pub fn active_texture(&mut self, texture: GLenum) {
        if self.compile(move |cx| cx.active_texture(texture)) || self.inside_begin_end() {
            return;
        }
        match index_below(texture, GL_TEXTURE0, MAX_TEXTURE_UNITS) {
            Some(unit) => self.state.texture.active = unit,
            None => self.set_error(GL_INVALID_ENUM, "glActiveTexture"),
        }
    }

    /// glTexEnv{if}[v] of the active unit. A slice of one is the scalar form. The colour is clamped to [0, 1].
    pub fn tex_env(&mut self, target: GLenum, pname: GLenum, params: &[f32]) {
        let given = Params::new(params);
        if self.compile(move |cx| cx.tex_env(target, pname, given.as_slice())) || self.inside_begin_end() {
            return;
        }
        let Some(scalar) = params.first().copied() else { return };
        let unit = &mut self.state.texture.units[self.state.texture.active];
        match (target, pname) {
            (GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR) => match vec4(params) {
                Some(color) => put(&mut unit.env_color, color.map(clamp01), &mut self.dirty, dirty::TEXTURE),
                None => self.set_error(GL_INVALID_ENUM, "glTexEnv(GL_TEXTURE_ENV_COLOR)"),
            },
            (GL_TEXTURE_ENV, GL_RGB_SCALE | GL_ALPHA_SCALE) => {
                if ![1.0, 2.0, 4.0].contains(&scalar) {
                    return self.set_error(GL_INVALID_VALUE, "glTexEnv(scale)");
                }
                let slot = &mut unit.combine_scale[(pname == GL_ALPHA_SCALE) as usize];
                put(slot, scalar, &mut self.dirty, dirty::TEXTURE);
            }
            (GL_TEXTURE_ENV, _) => match enum_slot(unit, pname) {
                Some((slot, legal)) if legal(enum_from(scalar)) => put(slot, enum_from(scalar), &mut self.dirty, dirty::TEXTURE),
                _ => self.set_error(GL_INVALID_ENUM, "glTexEnv"),
            },
            (GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS) => put(&mut unit.lod_bias, scalar, &mut self.dirty, dirty::TEXTURE),
            (GL_POINT_SPRITE, GL_COORD_REPLACE) => {
                if scalar != 0.0 && scalar != 1.0 {
                    return self.set_error(GL_INVALID_VALUE, "glTexEnv(GL_COORD_REPLACE)");
                }
                put(&mut unit.coord_replace, scalar != 0.0, &mut self.dirty, dirty::TEXTURE);
            }
            _ => self.set_error(GL_INVALID_ENUM, "glTexEnv"),
        }
    }

    /// glGetTexEnv{if}v: the value in its own type, or nothing after an error.
    pub fn get_tex_env(&mut self, target: GLenum, pname: GLenum) -> Option<Value> {
        if self.inside_begin_end() {
            return None;
        }
        let unit = &mut self.state.texture.units[self.state.texture.active];
        let value = match (target, pname) {
            (GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR) => Some(Value::normalized(&unit.env_color)),
            (GL_TEXTURE_ENV, GL_RGB_SCALE) => Some(Value::floats(&unit.combine_scale[..1])),
            (GL_TEXTURE_ENV, GL_ALPHA_SCALE) => Some(Value::floats(&unit.combine_scale[1..])),
            (GL_TEXTURE_ENV, _) => enum_slot(unit, pname).map(|(slot, _)| Value::new(Kind::Int, [*slot as f64])),
            (GL_TEXTURE_FILTER_CONTROL, GL_TEXTURE_LOD_BIAS) => Some(Value::floats(&[unit.lod_bias])),
            (GL_POINT_SPRITE, GL_COORD_REPLACE) => Some(Value::new(Kind::Bool, [unit.coord_replace as u32 as f64])),
            _ => None,
        };
        self.value_or_error(value, "glGetTexEnv")
    }
}

/// Where a parameter of GL_TEXTURE_ENV whose value is an enum is kept, and which enums it takes.
fn enum_slot(unit: &mut TextureUnit, pname: GLenum) -> Option<(&mut GLenum, fn(GLenum) -> bool)> {
    fn is_mode(v: GLenum) -> bool {
        matches!(v, GL_MODULATE | GL_DECAL | GL_BLEND | GL_REPLACE | GL_ADD | GL_COMBINE)
    }
    fn is_combine_alpha(v: GLenum) -> bool {
        matches!(v, GL_REPLACE | GL_MODULATE | GL_ADD | GL_ADD_SIGNED | GL_INTERPOLATE | GL_SUBTRACT)
    }
    fn is_combine_rgb(v: GLenum) -> bool {
        is_combine_alpha(v) || matches!(v, GL_DOT3_RGB | GL_DOT3_RGBA)
    }
    fn is_source(v: GLenum) -> bool {
        matches!(v, GL_TEXTURE | GL_CONSTANT | GL_PRIMARY_COLOR | GL_PREVIOUS | GL_TEXTURE0..=GL_TEXTURE7)
    }
    fn is_operand_alpha(v: GLenum) -> bool {
        matches!(v, GL_SRC_ALPHA | GL_ONE_MINUS_SRC_ALPHA)
    }
    fn is_operand_rgb(v: GLenum) -> bool {
        is_operand_alpha(v) || matches!(v, GL_SRC_COLOR | GL_ONE_MINUS_SRC_COLOR)
    }
    Some(match pname {
        GL_TEXTURE_ENV_MODE => (&mut unit.env_mode, is_mode),
        GL_COMBINE_RGB => (&mut unit.combine[0], is_combine_rgb),
        GL_COMBINE_ALPHA => (&mut unit.combine[1], is_combine_alpha),
        GL_SRC0_RGB..=GL_SRC2_RGB => (&mut unit.combine_sources[0][(pname - GL_SRC0_RGB) as usize], is_source),
        GL_SRC0_ALPHA..=GL_SRC2_ALPHA => (&mut unit.combine_sources[1][(pname - GL_SRC0_ALPHA) as usize], is_source),
        GL_OPERAND0_RGB..=GL_OPERAND2_RGB => (&mut unit.combine_operands[0][(pname - GL_OPERAND0_RGB) as usize], is_operand_rgb),
        GL_OPERAND0_ALPHA..=GL_OPERAND2_ALPHA => (&mut unit.combine_operands[1][(pname - GL_OPERAND0_ALPHA) as usize], is_operand_alpha),
        _ => return None,
    })
}
