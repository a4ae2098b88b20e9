//! Commands that set a named parameter from a scalar or a vector: lights, materials, fog, texture environment and generation.

use tepui::gl::Context;
use tepui::gl::enums::*;
use tepui::gl::query::params_from_int;

use super::memory::{copy, put};

/// How many values the vector form of a command reads for a parameter; 0 for a name that no such command knows, so that nothing is
/// read before the error.
fn length(pname: GLenum) -> usize {
    match pname {
        GL_AMBIENT | GL_DIFFUSE | GL_SPECULAR | GL_EMISSION | GL_AMBIENT_AND_DIFFUSE | GL_POSITION => 4,
        GL_LIGHT_MODEL_AMBIENT | GL_FOG_COLOR | GL_TEXTURE_ENV_COLOR | GL_OBJECT_PLANE | GL_EYE_PLANE => 4,
        GL_SPOT_DIRECTION | GL_COLOR_INDEXES | GL_POINT_DISTANCE_ATTENUATION => 3,
        GL_SPOT_EXPONENT | GL_SPOT_CUTOFF | GL_CONSTANT_ATTENUATION | GL_LINEAR_ATTENUATION | GL_QUADRATIC_ATTENUATION => 1,
        GL_SHININESS | GL_LIGHT_MODEL_LOCAL_VIEWER | GL_LIGHT_MODEL_TWO_SIDE | GL_LIGHT_MODEL_COLOR_CONTROL => 1,
        GL_FOG_MODE | GL_FOG_DENSITY | GL_FOG_START | GL_FOG_END | GL_FOG_INDEX | GL_FOG_COORD_SRC => 1,
        GL_TEXTURE_GEN_MODE | GL_TEXTURE_ENV_MODE | GL_TEXTURE_LOD_BIAS | GL_COORD_REPLACE => 1,
        GL_COMBINE_RGB | GL_COMBINE_ALPHA | GL_RGB_SCALE | GL_ALPHA_SCALE => 1,
        GL_SRC0_RGB..=GL_SRC2_RGB | GL_SRC0_ALPHA..=GL_SRC2_ALPHA => 1,
        GL_OPERAND0_RGB..=GL_OPERAND2_RGB | GL_OPERAND0_ALPHA..=GL_OPERAND2_ALPHA => 1,
        GL_POINT_SIZE_MIN | GL_POINT_SIZE_MAX | GL_POINT_FADE_THRESHOLD_SIZE | GL_POINT_SPRITE_COORD_ORIGIN => 1,
        _ => 0,
    }
}

/// The vector of a parameter: at most four values.
struct Vector<T> {
    values: [T; 4],
    count: usize,
}

impl<T> Vector<T> {
    fn as_slice(&self) -> &[T] {
        &self.values[..self.count]
    }
}

/// Reads the vector of a parameter. What is unknown reads as a zero: the method then names the error.
unsafe fn vector<T: Copy + Default>(cx: &mut Context, name: &str, pname: GLenum, params: *const T) -> Option<Vector<T>> {
    let count = length(pname);
    let mut vector = Vector { values: [T::default(); 4], count: count.max(1) };
    if count > 0 && params.is_null() {
        cx.set_error(GL_INVALID_VALUE, name);
        return None;
    }
    for (k, value) in vector.values[..count].iter_mut().enumerate() {
        // SAFETY: the contract of this folder.
        *value = unsafe { params.add(k).read_unaligned() };
    }
    Some(vector)
}

/// `f`, `i`, `fv`, `iv` of one command, and its queries.
macro_rules! commands {
    ($($f:ident $i:ident $fv:ident $iv:ident => $method:ident($($arg:ident),*);)*) => { $(
        #[doc = stringify!($f)]
        pub unsafe fn $f(cx: &mut Context, $($arg: GLenum,)* pname: GLenum, param: f32) {
            cx.$method($($arg,)* pname, &[param]);
        }
        #[doc = stringify!($i)]
        pub unsafe fn $i(cx: &mut Context, $($arg: GLenum,)* pname: GLenum, param: i32) {
            cx.$method($($arg,)* pname, &params_from_int(pname, &[param]));
        }
        #[doc = stringify!($fv)]
        pub unsafe fn $fv(cx: &mut Context, $($arg: GLenum,)* pname: GLenum, params: *const f32) {
            // SAFETY: the contract of this folder.
            if let Some(v) = unsafe { vector(cx, stringify!($fv), pname, params) } {
                cx.$method($($arg,)* pname, v.as_slice());
            }
        }
        #[doc = stringify!($iv)]
        pub unsafe fn $iv(cx: &mut Context, $($arg: GLenum,)* pname: GLenum, params: *const i32) {
            // SAFETY: the contract of this folder.
            if let Some(v) = unsafe { vector(cx, stringify!($iv), pname, params) } {
                cx.$method($($arg,)* pname, &params_from_int(pname, v.as_slice()));
            }
        }
    )* };
}

commands! {
    glLightf glLighti glLightfv glLightiv => light(light);
    glLightModelf glLightModeli glLightModelfv glLightModeliv => light_model();
    glMaterialf glMateriali glMaterialfv glMaterialiv => material(face);
    glFogf glFogi glFogfv glFogiv => fog();
    glTexEnvf glTexEnvi glTexEnvfv glTexEnviv => tex_env(target);
    glTexGenf glTexGeni glTexGenfv glTexGeniv => tex_gen(coord);
    glPointParameterf glPointParameteri glPointParameterfv glPointParameteriv => point_parameter();
}

/// glTexGend
pub unsafe fn glTexGend(cx: &mut Context, coord: GLenum, pname: GLenum, param: f64) {
    cx.tex_gen(coord, pname, &[param as f32]);
}

/// glTexGendv
pub unsafe fn glTexGendv(cx: &mut Context, coord: GLenum, pname: GLenum, params: *const f64) {
    // SAFETY: the contract of this folder.
    if let Some(v) = unsafe { vector(cx, "glTexGendv", pname, params) } {
        cx.tex_gen(coord, pname, &v.values.map(|v| v as f32)[..v.count]);
    }
}

/// glClipPlane
pub unsafe fn glClipPlane(cx: &mut Context, plane: GLenum, equation: *const f64) {
    // SAFETY: the contract of this folder.
    if let Some(v) = unsafe { copy(cx, "glClipPlane", equation, 4) } {
        cx.clip_plane(plane, [v[0], v[1], v[2], v[3]]);
    }
}

/// glGetClipPlane
pub unsafe fn glGetClipPlane(cx: &mut Context, plane: GLenum, equation: *mut f64) {
    if let Some(v) = cx.get_clip_plane(plane) {
        // SAFETY: the contract of this folder.
        unsafe { put(cx, "glGetClipPlane", equation, v) };
    }
}

/// glEdgeFlagv
pub unsafe fn glEdgeFlagv(cx: &mut Context, flag: *const u8) {
    // SAFETY: the contract of this folder.
    if let Some(v) = unsafe { copy(cx, "glEdgeFlagv", flag, 1) } {
        cx.edge_flag(v[0] != 0);
    }
}
