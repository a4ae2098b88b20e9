//! Texture parameters and the queries of textures (3.8.4, 6.1.3).

use super::enums::*;
use super::texture_image::ImageTarget;
use super::texture_object::{TextureObject, kind_of};
use super::{Context, dirty};
use crate::draw::texture::TextureKind;

/// Values that a parameter of a texture has.
pub fn tex_parameter_count(pname: GLenum) -> usize {
    if pname == GL_TEXTURE_BORDER_COLOR { 4 } else { 1 }
}

/// A parameter's value: enums and levels exact, the rest as floats.
#[derive(Clone, Copy)]
enum Value {
    Int([i32; 4]),
    Float([f32; 4]),
}

impl Value {
    fn int(self) -> i32 {
        match self {
            Value::Int(v) => v[0],
            Value::Float(v) => v[0].round() as i32,
        }
    }
    fn float(self) -> f32 {
        match self {
            Value::Int(v) => v[0] as f32,
            Value::Float(v) => v[0],
        }
    }
    fn color(self) -> [f32; 4] {
        match self {
            Value::Int(v) => v.map(|c| ((2.0 * c as f64 + 1.0) / u32::MAX as f64) as f32),
            Value::Float(v) => v,
        }
    }
}

impl TextureObject {
    fn set_parameter(&mut self, pname: GLenum, value: Value) -> Result<(), GLenum> {
        let choose = |allowed: &[GLenum]| Some(value.int() as GLenum).filter(|v| allowed.contains(v)).ok_or(GL_INVALID_ENUM);
        match pname {
            GL_TEXTURE_MIN_FILTER => {
                self.min_filter = choose(&[
                    GL_NEAREST,
                    GL_LINEAR,
                    GL_NEAREST_MIPMAP_NEAREST,
                    GL_LINEAR_MIPMAP_NEAREST,
                    GL_NEAREST_MIPMAP_LINEAR,
                    GL_LINEAR_MIPMAP_LINEAR,
                ])?
            }
            GL_TEXTURE_MAG_FILTER => self.mag_filter = choose(&[GL_NEAREST, GL_LINEAR])?,
            GL_TEXTURE_WRAP_S | GL_TEXTURE_WRAP_T | GL_TEXTURE_WRAP_R => {
                let mode = choose(&[GL_REPEAT, GL_CLAMP, GL_CLAMP_TO_EDGE, GL_CLAMP_TO_BORDER, GL_MIRRORED_REPEAT])?;
                self.wrap[match pname {
                    GL_TEXTURE_WRAP_S => 0,
                    GL_TEXTURE_WRAP_T => 1,
                    _ => 2,
                }] = mode;
            }
            GL_TEXTURE_BORDER_COLOR => self.border_color = value.color().map(|c| c.clamp(0.0, 1.0)),
            GL_TEXTURE_PRIORITY => self.priority = value.float().clamp(0.0, 1.0),
            GL_TEXTURE_MIN_LOD => self.min_lod = value.float(),
            GL_TEXTURE_MAX_LOD => self.max_lod = value.float(),
            GL_TEXTURE_LOD_BIAS => self.lod_bias = value.float(),
            GL_TEXTURE_BASE_LEVEL | GL_TEXTURE_MAX_LEVEL => {
                let level = Some(value.int()).filter(|&l| l >= 0).ok_or(GL_INVALID_VALUE)?;
                if pname == GL_TEXTURE_BASE_LEVEL {
                    self.base_level = level;
                } else {
                    self.max_level = level;
                }
                self.levels_changed();
            }
            GL_GENERATE_MIPMAP => self.generate_mipmap = value.int() != 0,
            GL_DEPTH_TEXTURE_MODE => {
                self.depth_mode = choose(&[GL_LUMINANCE, GL_INTENSITY, GL_ALPHA])?;
                // What is sampled holds depths as the mode says.
                self.levels_changed();
            }
            GL_TEXTURE_COMPARE_MODE => self.compare_mode = choose(&[GL_NONE, GL_COMPARE_R_TO_TEXTURE])?,
            GL_TEXTURE_COMPARE_FUNC => {
                self.compare_func = choose(&[GL_LEQUAL, GL_GEQUAL, GL_LESS, GL_GREATER, GL_EQUAL, GL_NOTEQUAL, GL_ALWAYS, GL_NEVER])?
            }
            _ => return Err(GL_INVALID_ENUM),
        }
        Ok(())
    }

    fn parameter(&self, pname: GLenum) -> Option<Value> {
        let one = |v: GLenum| Value::Int([v as i32, 0, 0, 0]);
        let float = |v: f32| Value::Float([v, 0.0, 0.0, 0.0]);
        Some(match pname {
            GL_TEXTURE_MIN_FILTER => one(self.min_filter),
            GL_TEXTURE_MAG_FILTER => one(self.mag_filter),
            GL_TEXTURE_WRAP_S => one(self.wrap[0]),
            GL_TEXTURE_WRAP_T => one(self.wrap[1]),
            GL_TEXTURE_WRAP_R => one(self.wrap[2]),
            GL_TEXTURE_BORDER_COLOR => Value::Float(self.border_color),
            GL_TEXTURE_PRIORITY => float(self.priority),
            GL_TEXTURE_RESIDENT => one(1),
            GL_TEXTURE_MIN_LOD => float(self.min_lod),
            GL_TEXTURE_MAX_LOD => float(self.max_lod),
            GL_TEXTURE_LOD_BIAS => float(self.lod_bias),
            GL_TEXTURE_BASE_LEVEL => one(self.base_level as GLenum),
            GL_TEXTURE_MAX_LEVEL => one(self.max_level as GLenum),
            GL_GENERATE_MIPMAP => one(self.generate_mipmap as GLenum),
            GL_DEPTH_TEXTURE_MODE => one(self.depth_mode),
            GL_TEXTURE_COMPARE_MODE => one(self.compare_mode),
            GL_TEXTURE_COMPARE_FUNC => one(self.compare_func),
            _ => return None,
        })
    }
}

impl Context {
    /// glTexParameterf
    pub fn tex_parameterf(&mut self, target: GLenum, pname: GLenum, value: f32) {
        self.tex_parameter(target, pname, Value::Float([value, 0.0, 0.0, 0.0]), false);
    }

    /// glTexParameteri
    pub fn tex_parameteri(&mut self, target: GLenum, pname: GLenum, value: i32) {
        self.tex_parameter(target, pname, Value::Int([value, 0, 0, 0]), false);
    }

    /// glTexParameterfv: `values` holds [`tex_parameter_count`] values.
    pub fn tex_parameterfv(&mut self, target: GLenum, pname: GLenum, values: &[f32]) {
        self.tex_parameter(target, pname, Value::Float(std::array::from_fn(|k| values.get(k).copied().unwrap_or(0.0))), true);
    }

    /// glTexParameteriv
    pub fn tex_parameteriv(&mut self, target: GLenum, pname: GLenum, values: &[i32]) {
        self.tex_parameter(target, pname, Value::Int(std::array::from_fn(|k| values.get(k).copied().unwrap_or(0))), true);
    }

    fn tex_parameter(&mut self, target: GLenum, pname: GLenum, value: Value, vector: bool) {
        if self.compile(move |cx| cx.tex_parameter(target, pname, value, vector)) || self.inside_begin_end() {
            return;
        }
        let Some(kind) = kind_of(target) else { return self.set_error(GL_INVALID_ENUM, "glTexParameter") };
        if !vector && tex_parameter_count(pname) > 1 {
            return self.set_error(GL_INVALID_ENUM, "glTexParameter of a vector by a scalar");
        }
        match self.with_texture(kind, |object| object.set_parameter(pname, value)) {
            Ok(()) => self.dirty |= dirty::TEXTURE,
            Err(error) => self.set_error(error, "glTexParameter"),
        }
    }

    fn get_tex_parameter(&mut self, target: GLenum, pname: GLenum) -> Option<Value> {
        if self.inside_begin_end() {
            return None;
        }
        let value = kind_of(target).and_then(|kind| self.with_texture(kind, |object| object.parameter(pname)));
        if value.is_none() {
            self.set_error(GL_INVALID_ENUM, "glGetTexParameter");
        }
        value
    }

    /// glGetTexParameterfv: the values, none after an error.
    pub fn get_tex_parameterfv(&mut self, target: GLenum, pname: GLenum) -> Vec<f32> {
        match self.get_tex_parameter(target, pname) {
            Some(Value::Int(v)) => vec![v[0] as f32],
            Some(Value::Float(v)) => v[..tex_parameter_count(pname)].to_vec(),
            None => Vec::new(),
        }
    }

    /// glGetTexParameteriv: colours and priorities as fractions of the integer range, other floats rounded.
    pub fn get_tex_parameteriv(&mut self, target: GLenum, pname: GLenum) -> Vec<i32> {
        let fraction = matches!(pname, GL_TEXTURE_BORDER_COLOR | GL_TEXTURE_PRIORITY);
        match self.get_tex_parameter(target, pname) {
            Some(Value::Int(v)) => vec![v[0]],
            Some(Value::Float(v)) => {
                let convert = |&f: &f32| if fraction { (f as f64 * i32::MAX as f64).round() as i32 } else { f.round() as i32 };
                v[..tex_parameter_count(pname)].iter().map(convert).collect()
            }
            None => Vec::new(),
        }
    }

    /// glGetTexLevelParameteriv (and fv: the values are integers). None after an error.
    pub fn get_tex_level_parameter(&mut self, target: GLenum, level: i32, pname: GLenum) -> Option<i32> {
        if self.inside_begin_end() {
            return None;
        }
        match self.level_parameter(target, level, pname) {
            Ok(value) => Some(value),
            Err(error) => {
                self.set_error(error, "glGetTexLevelParameter");
                None
            }
        }
    }

    fn level_parameter(&self, target: GLenum, level: i32, pname: GLenum) -> Result<i32, GLenum> {
        let target_enum = target;
        let target = ImageTarget::from_enum(target).ok_or(GL_INVALID_ENUM)?;
        let dimensions = match target.kind {
            TextureKind::D1 => 1,
            TextureKind::D3 => 3,
            _ => 2,
        };
        ImageTarget::checked(target_enum, level, dimensions, true)?;
        let (size, border, internal_format, format) = if target.proxy {
            let proxy = self.pixel_objects.proxies[target.kind as usize];
            (proxy.size, proxy.border, proxy.internal_format, proxy.format)
        } else {
            self.with_texture(target.kind, |object| match object.image(target.face, level as usize) {
                Some(image) => (image.size.map(|n| n as i32), 0, image.internal_format, Some(image.format)),
                None => ([0; 3], 0, 0, None),
            })
        };
        Ok(match pname {
            GL_TEXTURE_WIDTH => size[0],
            GL_TEXTURE_HEIGHT => size[1],
            GL_TEXTURE_DEPTH => size[2],
            GL_TEXTURE_BORDER => border,
            // The initial internal format is 1 (table 6.19).
            GL_TEXTURE_INTERNAL_FORMAT => internal_format.max(1) as i32,
            GL_TEXTURE_RED_SIZE | GL_TEXTURE_GREEN_SIZE | GL_TEXTURE_BLUE_SIZE | GL_TEXTURE_ALPHA_SIZE => {
                format.map_or(0, |f| f.size_of(pname))
            }
            GL_TEXTURE_LUMINANCE_SIZE | GL_TEXTURE_INTENSITY_SIZE => format.map_or(0, |f| f.size_of(pname)),
            GL_TEXTURE_DEPTH_SIZE | GL_TEXTURE_STENCIL_SIZE => format.map_or(0, |f| f.size_of(pname)),
            GL_TEXTURE_RED_TYPE_ARB..=GL_TEXTURE_DEPTH_TYPE_ARB => {
                // Of red, green, blue, alpha, luminance, intensity and depth.
                const SIZES: [GLenum; 7] = [
                    GL_TEXTURE_RED_SIZE,
                    GL_TEXTURE_GREEN_SIZE,
                    GL_TEXTURE_BLUE_SIZE,
                    GL_TEXTURE_ALPHA_SIZE,
                    GL_TEXTURE_LUMINANCE_SIZE,
                    GL_TEXTURE_INTENSITY_SIZE,
                    GL_TEXTURE_DEPTH_SIZE,
                ];
                let size = format.map_or(0, |f| f.size_of(SIZES[(pname - GL_TEXTURE_RED_TYPE_ARB) as usize]));
                if size > 0 { GL_UNSIGNED_NORMALIZED as i32 } else { GL_NONE as i32 }
            }
            GL_TEXTURE_COMPRESSED => 0,
            _ => return Err(GL_INVALID_ENUM),
        })
    }
}
