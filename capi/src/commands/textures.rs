//! Texture images, parameters and objects.

use std::ffi::c_void;

use tepui::gl::Context;
use tepui::gl::enums::*;
use tepui::gl::texture_parameter::tex_parameter_count;

use super::memory::{bytes, bytes_mut, copy, count, put};

/// glTexImage1D
pub unsafe fn glTexImage1D(
    cx: &mut Context,
    target: GLenum,
    level: i32,
    internal_format: i32,
    width: i32,
    border: i32,
    format: GLenum,
    ty: GLenum,
    pixels: *const c_void,
) {
    let length = cx.unpack_bytes(width, 1, 1, format, ty);
    // SAFETY: the contract of this folder.
    let pixels = unsafe { bytes(pixels, length) };
    cx.tex_image_1d(target, level, internal_format, width, border, format, ty, pixels);
}

/// glTexImage2D
pub unsafe fn glTexImage2D(
    cx: &mut Context,
    target: GLenum,
    level: i32,
    internal_format: i32,
    width: i32,
    height: i32,
    border: i32,
    format: GLenum,
    ty: GLenum,
    pixels: *const c_void,
) {
    let length = cx.unpack_bytes(width, height, 1, format, ty);
    // SAFETY: the contract of this folder.
    let pixels = unsafe { bytes(pixels, length) };
    cx.tex_image_2d(target, level, internal_format, width, height, border, format, ty, pixels);
}

/// glTexImage3D
pub unsafe fn glTexImage3D(
    cx: &mut Context,
    target: GLenum,
    level: i32,
    internal_format: i32,
    width: i32,
    height: i32,
    depth: i32,
    border: i32,
    format: GLenum,
    ty: GLenum,
    pixels: *const c_void,
) {
    let length = cx.unpack_bytes_3d(width, height, depth, format, ty);
    // SAFETY: the contract of this folder.
    let pixels = unsafe { bytes(pixels, length) };
    cx.tex_image_3d(target, level, internal_format, width, height, depth, border, format, ty, pixels);
}

/// glTexImage3DEXT: the internal format is an enum there.
pub unsafe fn glTexImage3DEXT(
    cx: &mut Context,
    target: GLenum,
    level: i32,
    internal_format: GLenum,
    width: i32,
    height: i32,
    depth: i32,
    border: i32,
    format: GLenum,
    ty: GLenum,
    pixels: *const c_void,
) {
    // SAFETY: the contract of this folder.
    unsafe { glTexImage3D(cx, target, level, internal_format as i32, width, height, depth, border, format, ty, pixels) }
}

/// glTexSubImage1D
pub unsafe fn glTexSubImage1D(
    cx: &mut Context,
    target: GLenum,
    level: i32,
    x: i32,
    width: i32,
    format: GLenum,
    ty: GLenum,
    pixels: *const c_void,
) {
    let length = cx.unpack_bytes(width, 1, 1, format, ty);
    // SAFETY: the contract of this folder.
    let pixels = unsafe { bytes(pixels, length) };
    cx.tex_sub_image_1d(target, level, x, width, format, ty, pixels);
}

/// glTexSubImage2D
pub unsafe fn glTexSubImage2D(
    cx: &mut Context,
    target: GLenum,
    level: i32,
    x: i32,
    y: i32,
    width: i32,
    height: i32,
    format: GLenum,
    ty: GLenum,
    pixels: *const c_void,
) {
    let length = cx.unpack_bytes(width, height, 1, format, ty);
    // SAFETY: the contract of this folder.
    let pixels = unsafe { bytes(pixels, length) };
    cx.tex_sub_image_2d(target, level, x, y, width, height, format, ty, pixels);
}

/// glTexSubImage3D
pub unsafe fn glTexSubImage3D(
    cx: &mut Context,
    target: GLenum,
    level: i32,
    x: i32,
    y: i32,
    z: i32,
    width: i32,
    height: i32,
    depth: i32,
    format: GLenum,
    ty: GLenum,
    pixels: *const c_void,
) {
    let length = cx.unpack_bytes_3d(width, height, depth, format, ty);
    // SAFETY: the contract of this folder.
    let pixels = unsafe { bytes(pixels, length) };
    cx.tex_sub_image_3d(target, level, x, y, z, width, height, depth, format, ty, pixels);
}

/// glGetTexImage
pub unsafe fn glGetTexImage(cx: &mut Context, target: GLenum, level: i32, format: GLenum, ty: GLenum, pixels: *mut c_void) {
    let length = cx.get_tex_image_bytes(target, level, format, ty);
    // SAFETY: the contract of this folder.
    let pixels = unsafe { bytes_mut(pixels, length) };
    cx.get_tex_image(target, level, format, ty, pixels);
}

/// glTexParameterfv
pub unsafe fn glTexParameterfv(cx: &mut Context, target: GLenum, pname: GLenum, params: *const f32) {
    // SAFETY: the contract of this folder.
    if let Some(v) = unsafe { copy(cx, "glTexParameterfv", params, tex_parameter_count(pname)) } {
        cx.tex_parameterfv(target, pname, &v);
    }
}

/// glTexParameteriv
pub unsafe fn glTexParameteriv(cx: &mut Context, target: GLenum, pname: GLenum, params: *const i32) {
    // SAFETY: the contract of this folder.
    if let Some(v) = unsafe { copy(cx, "glTexParameteriv", params, tex_parameter_count(pname)) } {
        cx.tex_parameteriv(target, pname, &v);
    }
}

/// glGenTextures
pub unsafe fn glGenTextures(cx: &mut Context, n: i32, textures: *mut u32) {
    if n > 0 && textures.is_null() {
        return cx.set_error(GL_INVALID_VALUE, "glGenTextures");
    }
    let names = cx.gen_textures(n);
    // SAFETY: the contract of this folder.
    unsafe { put(cx, "glGenTextures", textures, names) };
}

/// glDeleteTextures
pub unsafe fn glDeleteTextures(cx: &mut Context, n: i32, textures: *const u32) {
    // SAFETY: the contract of this folder.
    if let Some(names) = unsafe { copy(cx, "glDeleteTextures", textures, count(n)) } {
        cx.delete_textures(n, &names);
    }
}

/// glPrioritizeTextures
pub unsafe fn glPrioritizeTextures(cx: &mut Context, n: i32, textures: *const u32, priorities: *const f32) {
    // SAFETY: the contract of this folder.
    let Some(names) = (unsafe { copy(cx, "glPrioritizeTextures", textures, count(n)) }) else { return };
    // SAFETY: the contract of this folder.
    let Some(priorities) = (unsafe { copy(cx, "glPrioritizeTextures", priorities, count(n)) }) else { return };
    cx.prioritize_textures(n, &names, &priorities);
}

/// glAreTexturesResident. All are: nothing is written to `residences` (6.1.14 of the specification, as in 3.8.12).
pub unsafe fn glAreTexturesResident(cx: &mut Context, n: i32, textures: *const u32, _residences: *mut u8) -> u8 {
    // SAFETY: the contract of this folder.
    let Some(names) = (unsafe { copy(cx, "glAreTexturesResident", textures, count(n)) }) else { return 0 };
    cx.are_textures_resident(n, &names).unwrap_or(false) as u8
}
