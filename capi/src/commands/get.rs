//! Queries that write through a pointer.

use std::ffi::CStr;

use tepui::gl::Context;
use tepui::gl::enums::*;

use super::memory::put;

/// A query that answers with a `Value`: its exported forms, each with the conversion that it wants.
macro_rules! queries {
    ($($name:ident: $t:ty, $as:ident => $method:ident($($arg:ident),*);)*) => { $(
        #[doc = stringify!($name)]
        pub unsafe fn $name(cx: &mut Context, $($arg: GLenum,)* pname: GLenum, params: *mut $t) {
            if let Some(value) = cx.$method($($arg,)* pname) {
                // SAFETY: the contract of this folder.
                unsafe { put(cx, stringify!($name), params, value.$as()) };
            }
        }
    )* };
}

queries! {
    glGetBooleanv: u8, as_bool => get();
    glGetIntegerv: i32, as_i32 => get();
    glGetFloatv: f32, as_f32 => get();
    glGetDoublev: f64, as_f64 => get();
    glGetLightfv: f32, as_f32 => get_light(light);
    glGetLightiv: i32, as_i32 => get_light(light);
    glGetMaterialfv: f32, as_f32 => get_material(face);
    glGetMaterialiv: i32, as_i32 => get_material(face);
    glGetTexEnvfv: f32, as_f32 => get_tex_env(target);
    glGetTexEnviv: i32, as_i32 => get_tex_env(target);
    glGetTexGenfv: f32, as_f32 => get_tex_gen(coord);
    glGetTexGeniv: i32, as_i32 => get_tex_gen(coord);
    glGetTexGendv: f64, as_f64 => get_tex_gen(coord);
}

/// glGetString
pub unsafe fn glGetString(cx: &mut Context, name: GLenum) -> *const u8 {
    cx.get_string(name).map_or(std::ptr::null(), CStr::as_ptr).cast()
}

/// glGetTexParameterfv
pub unsafe fn glGetTexParameterfv(cx: &mut Context, target: GLenum, pname: GLenum, params: *mut f32) {
    let values = cx.get_tex_parameterfv(target, pname);
    // SAFETY: the contract of this folder.
    unsafe { put(cx, "glGetTexParameterfv", params, values) };
}

/// glGetTexParameteriv
pub unsafe fn glGetTexParameteriv(cx: &mut Context, target: GLenum, pname: GLenum, params: *mut i32) {
    let values = cx.get_tex_parameteriv(target, pname);
    // SAFETY: the contract of this folder.
    unsafe { put(cx, "glGetTexParameteriv", params, values) };
}

/// glGetTexLevelParameterfv
pub unsafe fn glGetTexLevelParameterfv(cx: &mut Context, target: GLenum, level: i32, pname: GLenum, params: *mut f32) {
    if let Some(value) = cx.get_tex_level_parameter(target, level, pname) {
        // SAFETY: the contract of this folder.
        unsafe { put(cx, "glGetTexLevelParameterfv", params, [value as f32]) };
    }
}

/// glGetTexLevelParameteriv
pub unsafe fn glGetTexLevelParameteriv(cx: &mut Context, target: GLenum, level: i32, pname: GLenum, params: *mut i32) {
    if let Some(value) = cx.get_tex_level_parameter(target, level, pname) {
        // SAFETY: the contract of this folder.
        unsafe { put(cx, "glGetTexLevelParameteriv", params, [value]) };
    }
}
