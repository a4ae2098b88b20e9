//! Every exported command. Generated from the Khronos registry by `capi/generator`; do not edit.
//!
//! Safety, for every `unsafe` below: a C caller passes pointers as the OpenGL specification demands; what a command does with them
//! is written at the shim that it calls.
#![allow(clippy::all, non_snake_case, unused_variables, unused_imports, unused_braces)]

use std::ffi::{c_char, c_void};
use std::sync::atomic::AtomicBool;

use crate::commands;
use crate::enter::{enter, not_built, read};
use crate::normalized;
use crate::table::Entry;

#[unsafe(no_mangle)]
pub unsafe extern "C" fn glAccum(op: u32, value: f32) {
    enter("glAccum", |cx| cx.accum(op, value))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glActiveStencilFaceEXT(face: u32) {
    enter("glActiveStencilFaceEXT", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glActiveStencilFaceEXT", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glActiveTexture(texture: u32) {
    enter("glActiveTexture", |cx| cx.active_texture(texture))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glActiveTextureARB(texture: u32) {
    enter("glActiveTextureARB", |cx| cx.active_texture(texture))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glAlphaFunc(func: u32, ref_: f32) {
    enter("glAlphaFunc", |cx| cx.alpha_func(func, ref_))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glAreTexturesResident(n: i32, textures: *const u32, residences: *mut u8) -> u8 {
    enter("glAreTexturesResident", |cx| unsafe { commands::textures::glAreTexturesResident(cx, n, textures, residences) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glAreTexturesResidentEXT(n: i32, textures: *const u32, residences: *mut u8) -> u8 {
    enter("glAreTexturesResidentEXT", |cx| unsafe { commands::textures::glAreTexturesResident(cx, n, textures, residences) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glArrayElement(i: i32) {
    enter("glArrayElement", |cx| cx.array_element(i))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glArrayElementEXT(i: i32) {
    enter("glArrayElementEXT", |cx| cx.array_element(i))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glAttachObjectARB(containerObj: u32, obj: u32) {
    enter("glAttachObjectARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glAttachObjectARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glAttachShader(program: u32, shader: u32) {
    enter("glAttachShader", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glAttachShader", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBegin(mode: u32) {
    enter("glBegin", |cx| cx.begin(mode))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBeginQuery(target: u32, id: u32) {
    enter("glBeginQuery", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glBeginQuery", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBeginQueryARB(target: u32, id: u32) {
    enter("glBeginQueryARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glBeginQueryARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBindAttribLocation(program: u32, index: u32, name: *const c_char) {
    enter("glBindAttribLocation", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glBindAttribLocation", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBindAttribLocationARB(programObj: u32, index: u32, name: *const c_char) {
    enter("glBindAttribLocationARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glBindAttribLocationARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBindBuffer(target: u32, buffer: u32) {
    enter("glBindBuffer", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glBindBuffer", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBindBufferARB(target: u32, buffer: u32) {
    enter("glBindBufferARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glBindBufferARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBindFramebuffer(target: u32, framebuffer: u32) {
    enter("glBindFramebuffer", |cx| cx.bind_framebuffer(target, framebuffer))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBindFramebufferEXT(target: u32, framebuffer: u32) {
    enter("glBindFramebufferEXT", |cx| cx.bind_framebuffer_ext(target, framebuffer))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBindProgramARB(target: u32, program: u32) {
    enter("glBindProgramARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glBindProgramARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBindRenderbuffer(target: u32, renderbuffer: u32) {
    enter("glBindRenderbuffer", |cx| cx.bind_renderbuffer(target, renderbuffer))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBindRenderbufferEXT(target: u32, renderbuffer: u32) {
    enter("glBindRenderbufferEXT", |cx| cx.bind_renderbuffer_ext(target, renderbuffer))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBindTexture(target: u32, texture: u32) {
    enter("glBindTexture", |cx| cx.bind_texture(target, texture))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBindTextureEXT(target: u32, texture: u32) {
    enter("glBindTextureEXT", |cx| cx.bind_texture(target, texture))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBitmap(width: i32, height: i32, xorig: f32, yorig: f32, xmove: f32, ymove: f32, bitmap: *const u8) {
    enter("glBitmap", |cx| unsafe { commands::pixels::glBitmap(cx, width, height, xorig, yorig, xmove, ymove, bitmap) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBlendColor(red: f32, green: f32, blue: f32, alpha: f32) {
    enter("glBlendColor", |cx| cx.blend_color(red, green, blue, alpha))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBlendColorEXT(red: f32, green: f32, blue: f32, alpha: f32) {
    enter("glBlendColorEXT", |cx| cx.blend_color(red, green, blue, alpha))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBlendEquation(mode: u32) {
    enter("glBlendEquation", |cx| cx.blend_equation(mode))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBlendEquationEXT(mode: u32) {
    enter("glBlendEquationEXT", |cx| cx.blend_equation(mode))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBlendEquationSeparate(modeRGB: u32, modeAlpha: u32) {
    enter("glBlendEquationSeparate", |cx| cx.blend_equation_separate(modeRGB, modeAlpha))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBlendEquationSeparateEXT(modeRGB: u32, modeAlpha: u32) {
    enter("glBlendEquationSeparateEXT", |cx| cx.blend_equation_separate(modeRGB, modeAlpha))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBlendFunc(sfactor: u32, dfactor: u32) {
    enter("glBlendFunc", |cx| cx.blend_func(sfactor, dfactor))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBlendFuncSeparate(sfactorRGB: u32, dfactorRGB: u32, sfactorAlpha: u32, dfactorAlpha: u32) {
    enter("glBlendFuncSeparate", |cx| cx.blend_func_separate(sfactorRGB, dfactorRGB, sfactorAlpha, dfactorAlpha))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBlendFuncSeparateEXT(sfactorRGB: u32, dfactorRGB: u32, sfactorAlpha: u32, dfactorAlpha: u32) {
    enter("glBlendFuncSeparateEXT", |cx| cx.blend_func_separate(sfactorRGB, dfactorRGB, sfactorAlpha, dfactorAlpha))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBlendFuncSeparateINGR(sfactorRGB: u32, dfactorRGB: u32, sfactorAlpha: u32, dfactorAlpha: u32) {
    enter("glBlendFuncSeparateINGR", |cx| cx.blend_func_separate(sfactorRGB, dfactorRGB, sfactorAlpha, dfactorAlpha))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBlitFramebuffer(srcX0: i32, srcY0: i32, srcX1: i32, srcY1: i32, dstX0: i32, dstY0: i32, dstX1: i32, dstY1: i32, mask: u32, filter: u32) {
    enter("glBlitFramebuffer", |cx| cx.blit_framebuffer(srcX0, srcY0, srcX1, srcY1, dstX0, dstY0, dstX1, dstY1, mask, filter))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBlitFramebufferEXT(srcX0: i32, srcY0: i32, srcX1: i32, srcY1: i32, dstX0: i32, dstY0: i32, dstX1: i32, dstY1: i32, mask: u32, filter: u32) {
    enter("glBlitFramebufferEXT", |cx| cx.blit_framebuffer(srcX0, srcY0, srcX1, srcY1, dstX0, dstY0, dstX1, dstY1, mask, filter))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBufferData(target: u32, size: isize, data: *const c_void, usage: u32) {
    enter("glBufferData", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glBufferData", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBufferDataARB(target: u32, size: isize, data: *const c_void, usage: u32) {
    enter("glBufferDataARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glBufferDataARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBufferSubData(target: u32, offset: isize, size: isize, data: *const c_void) {
    enter("glBufferSubData", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glBufferSubData", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glBufferSubDataARB(target: u32, offset: isize, size: isize, data: *const c_void) {
    enter("glBufferSubDataARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glBufferSubDataARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCallList(list: u32) {
    enter("glCallList", |cx| cx.call_list(list))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCallLists(n: i32, type_: u32, lists: *const c_void) {
    enter("glCallLists", |cx| unsafe { commands::lists::glCallLists(cx, n, type_, lists) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCheckFramebufferStatus(target: u32) -> u32 {
    enter("glCheckFramebufferStatus", |cx| cx.check_framebuffer_status(target))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCheckFramebufferStatusEXT(target: u32) -> u32 {
    enter("glCheckFramebufferStatusEXT", |cx| cx.check_framebuffer_status(target))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glClampColorARB(target: u32, clamp: u32) {
    enter("glClampColorARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glClampColorARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glClear(mask: u32) {
    enter("glClear", |cx| cx.clear(mask))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glClearAccum(red: f32, green: f32, blue: f32, alpha: f32) {
    enter("glClearAccum", |cx| cx.clear_accum(red, green, blue, alpha))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glClearColor(red: f32, green: f32, blue: f32, alpha: f32) {
    enter("glClearColor", |cx| cx.clear_color(red, green, blue, alpha))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glClearDepth(depth: f64) {
    enter("glClearDepth", |cx| cx.clear_depth(depth))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glClearIndex(c: f32) {
    enter("glClearIndex", |cx| cx.clear_index(c))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glClearStencil(s: i32) {
    enter("glClearStencil", |cx| cx.clear_stencil(s))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glClientActiveTexture(texture: u32) {
    enter("glClientActiveTexture", |cx| cx.client_active_texture(texture))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glClientActiveTextureARB(texture: u32) {
    enter("glClientActiveTextureARB", |cx| cx.client_active_texture(texture))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glClipPlane(plane: u32, equation: *const f64) {
    enter("glClipPlane", |cx| unsafe { commands::parameters::glClipPlane(cx, plane, equation) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3b(red: i8, green: i8, blue: i8) {
    enter("glColor3b", |cx| cx.color(normalized::i8(red), normalized::i8(green), normalized::i8(blue), 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3bv(v: *const i8) {
    enter("glColor3bv", |cx| { let Some(v) = (unsafe { read::<i8, 3>(cx, "glColor3bv", v) }) else { return }; cx.color(normalized::i8(v[0]), normalized::i8(v[1]), normalized::i8(v[2]), 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3d(red: f64, green: f64, blue: f64) {
    enter("glColor3d", |cx| cx.color(red as f32, green as f32, blue as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3dv(v: *const f64) {
    enter("glColor3dv", |cx| { let Some(v) = (unsafe { read::<f64, 3>(cx, "glColor3dv", v) }) else { return }; cx.color(v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3f(red: f32, green: f32, blue: f32) {
    enter("glColor3f", |cx| cx.color(red, green, blue, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3fv(v: *const f32) {
    enter("glColor3fv", |cx| { let Some(v) = (unsafe { read::<f32, 3>(cx, "glColor3fv", v) }) else { return }; cx.color(v[0], v[1], v[2], 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3i(red: i32, green: i32, blue: i32) {
    enter("glColor3i", |cx| cx.color(normalized::i32(red), normalized::i32(green), normalized::i32(blue), 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3iv(v: *const i32) {
    enter("glColor3iv", |cx| { let Some(v) = (unsafe { read::<i32, 3>(cx, "glColor3iv", v) }) else { return }; cx.color(normalized::i32(v[0]), normalized::i32(v[1]), normalized::i32(v[2]), 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3s(red: i16, green: i16, blue: i16) {
    enter("glColor3s", |cx| cx.color(normalized::i16(red), normalized::i16(green), normalized::i16(blue), 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3sv(v: *const i16) {
    enter("glColor3sv", |cx| { let Some(v) = (unsafe { read::<i16, 3>(cx, "glColor3sv", v) }) else { return }; cx.color(normalized::i16(v[0]), normalized::i16(v[1]), normalized::i16(v[2]), 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3ub(red: u8, green: u8, blue: u8) {
    enter("glColor3ub", |cx| cx.color(normalized::u8(red), normalized::u8(green), normalized::u8(blue), 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3ubv(v: *const u8) {
    enter("glColor3ubv", |cx| { let Some(v) = (unsafe { read::<u8, 3>(cx, "glColor3ubv", v) }) else { return }; cx.color(normalized::u8(v[0]), normalized::u8(v[1]), normalized::u8(v[2]), 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3ui(red: u32, green: u32, blue: u32) {
    enter("glColor3ui", |cx| cx.color(normalized::u32(red), normalized::u32(green), normalized::u32(blue), 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3uiv(v: *const u32) {
    enter("glColor3uiv", |cx| { let Some(v) = (unsafe { read::<u32, 3>(cx, "glColor3uiv", v) }) else { return }; cx.color(normalized::u32(v[0]), normalized::u32(v[1]), normalized::u32(v[2]), 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3us(red: u16, green: u16, blue: u16) {
    enter("glColor3us", |cx| cx.color(normalized::u16(red), normalized::u16(green), normalized::u16(blue), 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor3usv(v: *const u16) {
    enter("glColor3usv", |cx| { let Some(v) = (unsafe { read::<u16, 3>(cx, "glColor3usv", v) }) else { return }; cx.color(normalized::u16(v[0]), normalized::u16(v[1]), normalized::u16(v[2]), 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4b(red: i8, green: i8, blue: i8, alpha: i8) {
    enter("glColor4b", |cx| cx.color(normalized::i8(red), normalized::i8(green), normalized::i8(blue), normalized::i8(alpha)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4bv(v: *const i8) {
    enter("glColor4bv", |cx| { let Some(v) = (unsafe { read::<i8, 4>(cx, "glColor4bv", v) }) else { return }; cx.color(normalized::i8(v[0]), normalized::i8(v[1]), normalized::i8(v[2]), normalized::i8(v[3])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4d(red: f64, green: f64, blue: f64, alpha: f64) {
    enter("glColor4d", |cx| cx.color(red as f32, green as f32, blue as f32, alpha as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4dv(v: *const f64) {
    enter("glColor4dv", |cx| { let Some(v) = (unsafe { read::<f64, 4>(cx, "glColor4dv", v) }) else { return }; cx.color(v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4f(red: f32, green: f32, blue: f32, alpha: f32) {
    enter("glColor4f", |cx| cx.color(red, green, blue, alpha))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4fv(v: *const f32) {
    enter("glColor4fv", |cx| { let Some(v) = (unsafe { read::<f32, 4>(cx, "glColor4fv", v) }) else { return }; cx.color(v[0], v[1], v[2], v[3]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4i(red: i32, green: i32, blue: i32, alpha: i32) {
    enter("glColor4i", |cx| cx.color(normalized::i32(red), normalized::i32(green), normalized::i32(blue), normalized::i32(alpha)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4iv(v: *const i32) {
    enter("glColor4iv", |cx| { let Some(v) = (unsafe { read::<i32, 4>(cx, "glColor4iv", v) }) else { return }; cx.color(normalized::i32(v[0]), normalized::i32(v[1]), normalized::i32(v[2]), normalized::i32(v[3])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4s(red: i16, green: i16, blue: i16, alpha: i16) {
    enter("glColor4s", |cx| cx.color(normalized::i16(red), normalized::i16(green), normalized::i16(blue), normalized::i16(alpha)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4sv(v: *const i16) {
    enter("glColor4sv", |cx| { let Some(v) = (unsafe { read::<i16, 4>(cx, "glColor4sv", v) }) else { return }; cx.color(normalized::i16(v[0]), normalized::i16(v[1]), normalized::i16(v[2]), normalized::i16(v[3])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4ub(red: u8, green: u8, blue: u8, alpha: u8) {
    enter("glColor4ub", |cx| cx.color(normalized::u8(red), normalized::u8(green), normalized::u8(blue), normalized::u8(alpha)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4ubv(v: *const u8) {
    enter("glColor4ubv", |cx| { let Some(v) = (unsafe { read::<u8, 4>(cx, "glColor4ubv", v) }) else { return }; cx.color(normalized::u8(v[0]), normalized::u8(v[1]), normalized::u8(v[2]), normalized::u8(v[3])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4ui(red: u32, green: u32, blue: u32, alpha: u32) {
    enter("glColor4ui", |cx| cx.color(normalized::u32(red), normalized::u32(green), normalized::u32(blue), normalized::u32(alpha)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4uiv(v: *const u32) {
    enter("glColor4uiv", |cx| { let Some(v) = (unsafe { read::<u32, 4>(cx, "glColor4uiv", v) }) else { return }; cx.color(normalized::u32(v[0]), normalized::u32(v[1]), normalized::u32(v[2]), normalized::u32(v[3])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4us(red: u16, green: u16, blue: u16, alpha: u16) {
    enter("glColor4us", |cx| cx.color(normalized::u16(red), normalized::u16(green), normalized::u16(blue), normalized::u16(alpha)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColor4usv(v: *const u16) {
    enter("glColor4usv", |cx| { let Some(v) = (unsafe { read::<u16, 4>(cx, "glColor4usv", v) }) else { return }; cx.color(normalized::u16(v[0]), normalized::u16(v[1]), normalized::u16(v[2]), normalized::u16(v[3])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColorMask(red: u8, green: u8, blue: u8, alpha: u8) {
    enter("glColorMask", |cx| cx.color_mask(red != 0, green != 0, blue != 0, alpha != 0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColorMaterial(face: u32, mode: u32) {
    enter("glColorMaterial", |cx| cx.color_material(face, mode))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColorPointer(size: i32, type_: u32, stride: i32, pointer: *const c_void) {
    enter("glColorPointer", |cx| unsafe { commands::arrays::glColorPointer(cx, size, type_, stride, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColorPointerEXT(size: i32, type_: u32, stride: i32, count: i32, pointer: *const c_void) {
    enter("glColorPointerEXT", |cx| unsafe { commands::arrays::glColorPointerEXT(cx, size, type_, stride, count, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColorSubTable(target: u32, start: i32, count: i32, format: u32, type_: u32, data: *const c_void) {
    enter("glColorSubTable", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glColorSubTable", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColorTable(target: u32, internalformat: u32, width: i32, format: u32, type_: u32, table: *const c_void) {
    enter("glColorTable", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glColorTable", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColorTableParameterfv(target: u32, pname: u32, params: *const f32) {
    enter("glColorTableParameterfv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glColorTableParameterfv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glColorTableParameteriv(target: u32, pname: u32, params: *const i32) {
    enter("glColorTableParameteriv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glColorTableParameteriv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompileShader(shader: u32) {
    enter("glCompileShader", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glCompileShader", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompileShaderARB(shaderObj: u32) {
    enter("glCompileShaderARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glCompileShaderARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompressedTexImage1D(target: u32, level: i32, internalformat: u32, width: i32, border: i32, imageSize: i32, data: *const c_void) {
    enter("glCompressedTexImage1D", |cx| unsafe { commands::compressed::glCompressedTexImage1D(cx, target, level, internalformat, width, border, imageSize, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompressedTexImage1DARB(target: u32, level: i32, internalformat: u32, width: i32, border: i32, imageSize: i32, data: *const c_void) {
    enter("glCompressedTexImage1DARB", |cx| unsafe { commands::compressed::glCompressedTexImage1D(cx, target, level, internalformat, width, border, imageSize, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompressedTexImage2D(target: u32, level: i32, internalformat: u32, width: i32, height: i32, border: i32, imageSize: i32, data: *const c_void) {
    enter("glCompressedTexImage2D", |cx| unsafe { commands::compressed::glCompressedTexImage2D(cx, target, level, internalformat, width, height, border, imageSize, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompressedTexImage2DARB(target: u32, level: i32, internalformat: u32, width: i32, height: i32, border: i32, imageSize: i32, data: *const c_void) {
    enter("glCompressedTexImage2DARB", |cx| unsafe { commands::compressed::glCompressedTexImage2D(cx, target, level, internalformat, width, height, border, imageSize, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompressedTexImage3D(target: u32, level: i32, internalformat: u32, width: i32, height: i32, depth: i32, border: i32, imageSize: i32, data: *const c_void) {
    enter("glCompressedTexImage3D", |cx| unsafe { commands::compressed::glCompressedTexImage3D(cx, target, level, internalformat, width, height, depth, border, imageSize, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompressedTexImage3DARB(target: u32, level: i32, internalformat: u32, width: i32, height: i32, depth: i32, border: i32, imageSize: i32, data: *const c_void) {
    enter("glCompressedTexImage3DARB", |cx| unsafe { commands::compressed::glCompressedTexImage3D(cx, target, level, internalformat, width, height, depth, border, imageSize, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompressedTexSubImage1D(target: u32, level: i32, xoffset: i32, width: i32, format: u32, imageSize: i32, data: *const c_void) {
    enter("glCompressedTexSubImage1D", |cx| unsafe { commands::compressed::glCompressedTexSubImage1D(cx, target, level, xoffset, width, format, imageSize, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompressedTexSubImage1DARB(target: u32, level: i32, xoffset: i32, width: i32, format: u32, imageSize: i32, data: *const c_void) {
    enter("glCompressedTexSubImage1DARB", |cx| unsafe { commands::compressed::glCompressedTexSubImage1D(cx, target, level, xoffset, width, format, imageSize, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompressedTexSubImage2D(target: u32, level: i32, xoffset: i32, yoffset: i32, width: i32, height: i32, format: u32, imageSize: i32, data: *const c_void) {
    enter("glCompressedTexSubImage2D", |cx| unsafe { commands::compressed::glCompressedTexSubImage2D(cx, target, level, xoffset, yoffset, width, height, format, imageSize, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompressedTexSubImage2DARB(target: u32, level: i32, xoffset: i32, yoffset: i32, width: i32, height: i32, format: u32, imageSize: i32, data: *const c_void) {
    enter("glCompressedTexSubImage2DARB", |cx| unsafe { commands::compressed::glCompressedTexSubImage2D(cx, target, level, xoffset, yoffset, width, height, format, imageSize, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompressedTexSubImage3D(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: u32, imageSize: i32, data: *const c_void) {
    enter("glCompressedTexSubImage3D", |cx| unsafe { commands::compressed::glCompressedTexSubImage3D(cx, target, level, xoffset, yoffset, zoffset, width, height, depth, format, imageSize, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCompressedTexSubImage3DARB(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: u32, imageSize: i32, data: *const c_void) {
    enter("glCompressedTexSubImage3DARB", |cx| unsafe { commands::compressed::glCompressedTexSubImage3D(cx, target, level, xoffset, yoffset, zoffset, width, height, depth, format, imageSize, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glConvolutionFilter1D(target: u32, internalformat: u32, width: i32, format: u32, type_: u32, image: *const c_void) {
    enter("glConvolutionFilter1D", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glConvolutionFilter1D", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glConvolutionFilter2D(target: u32, internalformat: u32, width: i32, height: i32, format: u32, type_: u32, image: *const c_void) {
    enter("glConvolutionFilter2D", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glConvolutionFilter2D", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glConvolutionParameterf(target: u32, pname: u32, params: f32) {
    enter("glConvolutionParameterf", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glConvolutionParameterf", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glConvolutionParameterfv(target: u32, pname: u32, params: *const f32) {
    enter("glConvolutionParameterfv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glConvolutionParameterfv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glConvolutionParameteri(target: u32, pname: u32, params: i32) {
    enter("glConvolutionParameteri", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glConvolutionParameteri", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glConvolutionParameteriv(target: u32, pname: u32, params: *const i32) {
    enter("glConvolutionParameteriv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glConvolutionParameteriv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyColorSubTable(target: u32, start: i32, x: i32, y: i32, width: i32) {
    enter("glCopyColorSubTable", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glCopyColorSubTable", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyColorTable(target: u32, internalformat: u32, x: i32, y: i32, width: i32) {
    enter("glCopyColorTable", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glCopyColorTable", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyConvolutionFilter1D(target: u32, internalformat: u32, x: i32, y: i32, width: i32) {
    enter("glCopyConvolutionFilter1D", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glCopyConvolutionFilter1D", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyConvolutionFilter2D(target: u32, internalformat: u32, x: i32, y: i32, width: i32, height: i32) {
    enter("glCopyConvolutionFilter2D", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glCopyConvolutionFilter2D", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyPixels(x: i32, y: i32, width: i32, height: i32, type_: u32) {
    enter("glCopyPixels", |cx| cx.copy_pixels(x, y, width, height, type_))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyTexImage1D(target: u32, level: i32, internalformat: u32, x: i32, y: i32, width: i32, border: i32) {
    enter("glCopyTexImage1D", |cx| cx.copy_tex_image_1d(target, level, internalformat, x, y, width, border))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyTexImage1DEXT(target: u32, level: i32, internalformat: u32, x: i32, y: i32, width: i32, border: i32) {
    enter("glCopyTexImage1DEXT", |cx| cx.copy_tex_image_1d(target, level, internalformat, x, y, width, border))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyTexImage2D(target: u32, level: i32, internalformat: u32, x: i32, y: i32, width: i32, height: i32, border: i32) {
    enter("glCopyTexImage2D", |cx| cx.copy_tex_image_2d(target, level, internalformat, x, y, width, height, border))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyTexImage2DEXT(target: u32, level: i32, internalformat: u32, x: i32, y: i32, width: i32, height: i32, border: i32) {
    enter("glCopyTexImage2DEXT", |cx| cx.copy_tex_image_2d(target, level, internalformat, x, y, width, height, border))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyTexSubImage1D(target: u32, level: i32, xoffset: i32, x: i32, y: i32, width: i32) {
    enter("glCopyTexSubImage1D", |cx| cx.copy_tex_sub_image_1d(target, level, xoffset, x, y, width))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyTexSubImage1DEXT(target: u32, level: i32, xoffset: i32, x: i32, y: i32, width: i32) {
    enter("glCopyTexSubImage1DEXT", |cx| cx.copy_tex_sub_image_1d(target, level, xoffset, x, y, width))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyTexSubImage2D(target: u32, level: i32, xoffset: i32, yoffset: i32, x: i32, y: i32, width: i32, height: i32) {
    enter("glCopyTexSubImage2D", |cx| cx.copy_tex_sub_image_2d(target, level, xoffset, yoffset, x, y, width, height))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyTexSubImage2DEXT(target: u32, level: i32, xoffset: i32, yoffset: i32, x: i32, y: i32, width: i32, height: i32) {
    enter("glCopyTexSubImage2DEXT", |cx| cx.copy_tex_sub_image_2d(target, level, xoffset, yoffset, x, y, width, height))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyTexSubImage3D(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, x: i32, y: i32, width: i32, height: i32) {
    enter("glCopyTexSubImage3D", |cx| cx.copy_tex_sub_image_3d(target, level, xoffset, yoffset, zoffset, x, y, width, height))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCopyTexSubImage3DEXT(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, x: i32, y: i32, width: i32, height: i32) {
    enter("glCopyTexSubImage3DEXT", |cx| cx.copy_tex_sub_image_3d(target, level, xoffset, yoffset, zoffset, x, y, width, height))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCreateProgram() -> u32 {
    enter("glCreateProgram", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glCreateProgram", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCreateProgramObjectARB() -> u32 {
    enter("glCreateProgramObjectARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glCreateProgramObjectARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCreateShader(type_: u32) -> u32 {
    enter("glCreateShader", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glCreateShader", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCreateShaderObjectARB(shaderType: u32) -> u32 {
    enter("glCreateShaderObjectARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glCreateShaderObjectARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glCullFace(mode: u32) {
    enter("glCullFace", |cx| cx.cull_face(mode))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteBuffers(n: i32, buffers: *const u32) {
    enter("glDeleteBuffers", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glDeleteBuffers", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteBuffersARB(n: i32, buffers: *const u32) {
    enter("glDeleteBuffersARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glDeleteBuffersARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteFramebuffers(n: i32, framebuffers: *const u32) {
    enter("glDeleteFramebuffers", |cx| unsafe { commands::framebuffers::glDeleteFramebuffers(cx, n, framebuffers) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteFramebuffersEXT(n: i32, framebuffers: *const u32) {
    enter("glDeleteFramebuffersEXT", |cx| unsafe { commands::framebuffers::glDeleteFramebuffers(cx, n, framebuffers) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteLists(list: u32, range: i32) {
    enter("glDeleteLists", |cx| cx.delete_lists(list, range))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteObjectARB(obj: u32) {
    enter("glDeleteObjectARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glDeleteObjectARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteProgram(program: u32) {
    enter("glDeleteProgram", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glDeleteProgram", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteProgramsARB(n: i32, programs: *const u32) {
    enter("glDeleteProgramsARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glDeleteProgramsARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteQueries(n: i32, ids: *const u32) {
    enter("glDeleteQueries", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glDeleteQueries", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteQueriesARB(n: i32, ids: *const u32) {
    enter("glDeleteQueriesARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glDeleteQueriesARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteRenderbuffers(n: i32, renderbuffers: *const u32) {
    enter("glDeleteRenderbuffers", |cx| unsafe { commands::framebuffers::glDeleteRenderbuffers(cx, n, renderbuffers) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteRenderbuffersEXT(n: i32, renderbuffers: *const u32) {
    enter("glDeleteRenderbuffersEXT", |cx| unsafe { commands::framebuffers::glDeleteRenderbuffers(cx, n, renderbuffers) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteShader(shader: u32) {
    enter("glDeleteShader", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glDeleteShader", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteTextures(n: i32, textures: *const u32) {
    enter("glDeleteTextures", |cx| unsafe { commands::textures::glDeleteTextures(cx, n, textures) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDeleteTexturesEXT(n: i32, textures: *const u32) {
    enter("glDeleteTexturesEXT", |cx| unsafe { commands::textures::glDeleteTextures(cx, n, textures) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDepthFunc(func: u32) {
    enter("glDepthFunc", |cx| cx.depth_func(func))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDepthMask(flag: u8) {
    enter("glDepthMask", |cx| cx.depth_mask(flag != 0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDepthRange(n: f64, f: f64) {
    enter("glDepthRange", |cx| cx.depth_range(n, f))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDetachObjectARB(containerObj: u32, attachedObj: u32) {
    enter("glDetachObjectARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glDetachObjectARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDetachShader(program: u32, shader: u32) {
    enter("glDetachShader", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glDetachShader", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDisable(cap: u32) {
    enter("glDisable", |cx| cx.disable(cap))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDisableClientState(array: u32) {
    enter("glDisableClientState", |cx| cx.disable_client_state(array))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDisableVertexAttribArray(index: u32) {
    enter("glDisableVertexAttribArray", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glDisableVertexAttribArray", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDisableVertexAttribArrayARB(index: u32) {
    enter("glDisableVertexAttribArrayARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glDisableVertexAttribArrayARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDrawArrays(mode: u32, first: i32, count: i32) {
    enter("glDrawArrays", |cx| cx.draw_arrays(mode, first, count))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDrawArraysEXT(mode: u32, first: i32, count: i32) {
    enter("glDrawArraysEXT", |cx| cx.draw_arrays(mode, first, count))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDrawBuffer(buf: u32) {
    enter("glDrawBuffer", |cx| cx.draw_buffer(buf))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDrawBuffers(n: i32, bufs: *const u32) {
    enter("glDrawBuffers", |cx| unsafe { commands::framebuffers::glDrawBuffers(cx, n, bufs) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDrawBuffersARB(n: i32, bufs: *const u32) {
    enter("glDrawBuffersARB", |cx| unsafe { commands::framebuffers::glDrawBuffers(cx, n, bufs) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDrawElements(mode: u32, count: i32, type_: u32, indices: *const c_void) {
    enter("glDrawElements", |cx| unsafe { commands::arrays::glDrawElements(cx, mode, count, type_, indices) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDrawPixels(width: i32, height: i32, format: u32, type_: u32, pixels: *const c_void) {
    enter("glDrawPixels", |cx| unsafe { commands::pixels::glDrawPixels(cx, width, height, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDrawRangeElements(mode: u32, start: u32, end: u32, count: i32, type_: u32, indices: *const c_void) {
    enter("glDrawRangeElements", |cx| unsafe { commands::arrays::glDrawRangeElements(cx, mode, start, end, count, type_, indices) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glDrawRangeElementsEXT(mode: u32, start: u32, end: u32, count: i32, type_: u32, indices: *const c_void) {
    enter("glDrawRangeElementsEXT", |cx| unsafe { commands::arrays::glDrawRangeElements(cx, mode, start, end, count, type_, indices) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEdgeFlag(flag: u8) {
    enter("glEdgeFlag", |cx| cx.edge_flag(flag != 0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEdgeFlagPointer(stride: i32, pointer: *const c_void) {
    enter("glEdgeFlagPointer", |cx| unsafe { commands::arrays::glEdgeFlagPointer(cx, stride, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEdgeFlagPointerEXT(stride: i32, count: i32, pointer: *const u8) {
    enter("glEdgeFlagPointerEXT", |cx| unsafe { commands::arrays::glEdgeFlagPointerEXT(cx, stride, count, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEdgeFlagv(flag: *const u8) {
    enter("glEdgeFlagv", |cx| unsafe { commands::parameters::glEdgeFlagv(cx, flag) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEnable(cap: u32) {
    enter("glEnable", |cx| cx.enable(cap))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEnableClientState(array: u32) {
    enter("glEnableClientState", |cx| cx.enable_client_state(array))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEnableVertexAttribArray(index: u32) {
    enter("glEnableVertexAttribArray", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glEnableVertexAttribArray", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEnableVertexAttribArrayARB(index: u32) {
    enter("glEnableVertexAttribArrayARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glEnableVertexAttribArrayARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEnd() {
    enter("glEnd", |cx| cx.end())
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEndList() {
    enter("glEndList", |cx| cx.end_list())
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEndQuery(target: u32) {
    enter("glEndQuery", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glEndQuery", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEndQueryARB(target: u32) {
    enter("glEndQueryARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glEndQueryARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEvalCoord1d(u: f64) {
    enter("glEvalCoord1d", |cx| cx.eval_coord1(u as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEvalCoord1dv(u: *const f64) {
    enter("glEvalCoord1dv", |cx| { let Some(u) = (unsafe { read::<f64, 1>(cx, "glEvalCoord1dv", u) }) else { return }; cx.eval_coord1(u[0] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEvalCoord1f(u: f32) {
    enter("glEvalCoord1f", |cx| cx.eval_coord1(u))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEvalCoord1fv(u: *const f32) {
    enter("glEvalCoord1fv", |cx| { let Some(u) = (unsafe { read::<f32, 1>(cx, "glEvalCoord1fv", u) }) else { return }; cx.eval_coord1(u[0]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEvalCoord2d(u: f64, v: f64) {
    enter("glEvalCoord2d", |cx| cx.eval_coord2(u as f32, v as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEvalCoord2dv(u: *const f64) {
    enter("glEvalCoord2dv", |cx| { let Some(u) = (unsafe { read::<f64, 2>(cx, "glEvalCoord2dv", u) }) else { return }; cx.eval_coord2(u[0] as f32, u[1] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEvalCoord2f(u: f32, v: f32) {
    enter("glEvalCoord2f", |cx| cx.eval_coord2(u, v))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEvalCoord2fv(u: *const f32) {
    enter("glEvalCoord2fv", |cx| { let Some(u) = (unsafe { read::<f32, 2>(cx, "glEvalCoord2fv", u) }) else { return }; cx.eval_coord2(u[0], u[1]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEvalMesh1(mode: u32, i1: i32, i2: i32) {
    enter("glEvalMesh1", |cx| cx.eval_mesh1(mode, i1, i2))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEvalMesh2(mode: u32, i1: i32, i2: i32, j1: i32, j2: i32) {
    enter("glEvalMesh2", |cx| cx.eval_mesh2(mode, i1, i2, j1, j2))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEvalPoint1(i: i32) {
    enter("glEvalPoint1", |cx| cx.eval_point1(i))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glEvalPoint2(i: i32, j: i32) {
    enter("glEvalPoint2", |cx| cx.eval_point2(i, j))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFeedbackBuffer(size: i32, type_: u32, buffer: *mut f32) {
    enter("glFeedbackBuffer", |cx| unsafe { commands::selection::glFeedbackBuffer(cx, size, type_, buffer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFinish() {
    enter("glFinish", |cx| unsafe { commands::flush::glFinish(cx) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFlush() {
    enter("glFlush", |cx| unsafe { commands::flush::glFlush(cx) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogCoordPointer(type_: u32, stride: i32, pointer: *const c_void) {
    enter("glFogCoordPointer", |cx| unsafe { commands::arrays::glFogCoordPointer(cx, type_, stride, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogCoordPointerEXT(type_: u32, stride: i32, pointer: *const c_void) {
    enter("glFogCoordPointerEXT", |cx| unsafe { commands::arrays::glFogCoordPointer(cx, type_, stride, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogCoordd(coord: f64) {
    enter("glFogCoordd", |cx| cx.fog_coord(coord as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogCoorddEXT(coord: f64) {
    enter("glFogCoorddEXT", |cx| cx.fog_coord(coord as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogCoorddv(coord: *const f64) {
    enter("glFogCoorddv", |cx| { let Some(coord) = (unsafe { read::<f64, 1>(cx, "glFogCoorddv", coord) }) else { return }; cx.fog_coord(coord[0] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogCoorddvEXT(coord: *const f64) {
    enter("glFogCoorddvEXT", |cx| { let Some(coord) = (unsafe { read::<f64, 1>(cx, "glFogCoorddvEXT", coord) }) else { return }; cx.fog_coord(coord[0] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogCoordf(coord: f32) {
    enter("glFogCoordf", |cx| cx.fog_coord(coord))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogCoordfEXT(coord: f32) {
    enter("glFogCoordfEXT", |cx| cx.fog_coord(coord))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogCoordfv(coord: *const f32) {
    enter("glFogCoordfv", |cx| { let Some(coord) = (unsafe { read::<f32, 1>(cx, "glFogCoordfv", coord) }) else { return }; cx.fog_coord(coord[0]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogCoordfvEXT(coord: *const f32) {
    enter("glFogCoordfvEXT", |cx| { let Some(coord) = (unsafe { read::<f32, 1>(cx, "glFogCoordfvEXT", coord) }) else { return }; cx.fog_coord(coord[0]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogf(pname: u32, param: f32) {
    enter("glFogf", |cx| unsafe { commands::parameters::glFogf(cx, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogfv(pname: u32, params: *const f32) {
    enter("glFogfv", |cx| unsafe { commands::parameters::glFogfv(cx, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogi(pname: u32, param: i32) {
    enter("glFogi", |cx| unsafe { commands::parameters::glFogi(cx, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFogiv(pname: u32, params: *const i32) {
    enter("glFogiv", |cx| unsafe { commands::parameters::glFogiv(cx, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFramebufferRenderbuffer(target: u32, attachment: u32, renderbuffertarget: u32, renderbuffer: u32) {
    enter("glFramebufferRenderbuffer", |cx| cx.framebuffer_renderbuffer(target, attachment, renderbuffertarget, renderbuffer))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFramebufferRenderbufferEXT(target: u32, attachment: u32, renderbuffertarget: u32, renderbuffer: u32) {
    enter("glFramebufferRenderbufferEXT", |cx| cx.framebuffer_renderbuffer(target, attachment, renderbuffertarget, renderbuffer))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFramebufferTexture1D(target: u32, attachment: u32, textarget: u32, texture: u32, level: i32) {
    enter("glFramebufferTexture1D", |cx| cx.framebuffer_texture_1d(target, attachment, textarget, texture, level))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFramebufferTexture1DEXT(target: u32, attachment: u32, textarget: u32, texture: u32, level: i32) {
    enter("glFramebufferTexture1DEXT", |cx| cx.framebuffer_texture_1d(target, attachment, textarget, texture, level))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFramebufferTexture2D(target: u32, attachment: u32, textarget: u32, texture: u32, level: i32) {
    enter("glFramebufferTexture2D", |cx| cx.framebuffer_texture_2d(target, attachment, textarget, texture, level))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFramebufferTexture2DEXT(target: u32, attachment: u32, textarget: u32, texture: u32, level: i32) {
    enter("glFramebufferTexture2DEXT", |cx| cx.framebuffer_texture_2d(target, attachment, textarget, texture, level))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFramebufferTexture3D(target: u32, attachment: u32, textarget: u32, texture: u32, level: i32, zoffset: i32) {
    enter("glFramebufferTexture3D", |cx| cx.framebuffer_texture_3d(target, attachment, textarget, texture, level, zoffset))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFramebufferTexture3DEXT(target: u32, attachment: u32, textarget: u32, texture: u32, level: i32, zoffset: i32) {
    enter("glFramebufferTexture3DEXT", |cx| cx.framebuffer_texture_3d(target, attachment, textarget, texture, level, zoffset))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFramebufferTextureLayer(target: u32, attachment: u32, texture: u32, level: i32, layer: i32) {
    enter("glFramebufferTextureLayer", |cx| cx.framebuffer_texture_layer(target, attachment, texture, level, layer))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFrontFace(mode: u32) {
    enter("glFrontFace", |cx| cx.front_face(mode))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glFrustum(left: f64, right: f64, bottom: f64, top: f64, zNear: f64, zFar: f64) {
    enter("glFrustum", |cx| cx.frustum(left, right, bottom, top, zNear, zFar))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenBuffers(n: i32, buffers: *mut u32) {
    enter("glGenBuffers", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGenBuffers", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenBuffersARB(n: i32, buffers: *mut u32) {
    enter("glGenBuffersARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGenBuffersARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenFramebuffers(n: i32, framebuffers: *mut u32) {
    enter("glGenFramebuffers", |cx| unsafe { commands::framebuffers::glGenFramebuffers(cx, n, framebuffers) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenFramebuffersEXT(n: i32, framebuffers: *mut u32) {
    enter("glGenFramebuffersEXT", |cx| unsafe { commands::framebuffers::glGenFramebuffers(cx, n, framebuffers) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenLists(range: i32) -> u32 {
    enter("glGenLists", |cx| cx.gen_lists(range))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenProgramsARB(n: i32, programs: *mut u32) {
    enter("glGenProgramsARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGenProgramsARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenQueries(n: i32, ids: *mut u32) {
    enter("glGenQueries", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGenQueries", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenQueriesARB(n: i32, ids: *mut u32) {
    enter("glGenQueriesARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGenQueriesARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenRenderbuffers(n: i32, renderbuffers: *mut u32) {
    enter("glGenRenderbuffers", |cx| unsafe { commands::framebuffers::glGenRenderbuffers(cx, n, renderbuffers) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenRenderbuffersEXT(n: i32, renderbuffers: *mut u32) {
    enter("glGenRenderbuffersEXT", |cx| unsafe { commands::framebuffers::glGenRenderbuffers(cx, n, renderbuffers) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenTextures(n: i32, textures: *mut u32) {
    enter("glGenTextures", |cx| unsafe { commands::textures::glGenTextures(cx, n, textures) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenTexturesEXT(n: i32, textures: *mut u32) {
    enter("glGenTexturesEXT", |cx| unsafe { commands::textures::glGenTextures(cx, n, textures) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenerateMipmap(target: u32) {
    enter("glGenerateMipmap", |cx| cx.generate_mipmap(target))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGenerateMipmapEXT(target: u32) {
    enter("glGenerateMipmapEXT", |cx| cx.generate_mipmap(target))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetActiveAttrib(program: u32, index: u32, bufSize: i32, length: *mut i32, size: *mut i32, type_: *mut u32, name: *mut c_char) {
    enter("glGetActiveAttrib", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetActiveAttrib", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetActiveAttribARB(programObj: u32, index: u32, maxLength: i32, length: *mut i32, size: *mut i32, type_: *mut u32, name: *mut c_char) {
    enter("glGetActiveAttribARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetActiveAttribARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetActiveUniform(program: u32, index: u32, bufSize: i32, length: *mut i32, size: *mut i32, type_: *mut u32, name: *mut c_char) {
    enter("glGetActiveUniform", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetActiveUniform", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetActiveUniformARB(programObj: u32, index: u32, maxLength: i32, length: *mut i32, size: *mut i32, type_: *mut u32, name: *mut c_char) {
    enter("glGetActiveUniformARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetActiveUniformARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetAttachedObjectsARB(containerObj: u32, maxCount: i32, count: *mut i32, obj: *mut u32) {
    enter("glGetAttachedObjectsARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetAttachedObjectsARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetAttachedShaders(program: u32, maxCount: i32, count: *mut i32, shaders: *mut u32) {
    enter("glGetAttachedShaders", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetAttachedShaders", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetAttribLocation(program: u32, name: *const c_char) -> i32 {
    enter("glGetAttribLocation", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetAttribLocation", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetAttribLocationARB(programObj: u32, name: *const c_char) -> i32 {
    enter("glGetAttribLocationARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetAttribLocationARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetBooleanv(pname: u32, data: *mut u8) {
    enter("glGetBooleanv", |cx| unsafe { commands::get::glGetBooleanv(cx, pname, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetBufferParameteriv(target: u32, pname: u32, params: *mut i32) {
    enter("glGetBufferParameteriv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetBufferParameteriv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetBufferParameterivARB(target: u32, pname: u32, params: *mut i32) {
    enter("glGetBufferParameterivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetBufferParameterivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetBufferPointerv(target: u32, pname: u32, params: *mut *mut c_void) {
    enter("glGetBufferPointerv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetBufferPointerv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetBufferPointervARB(target: u32, pname: u32, params: *mut *mut c_void) {
    enter("glGetBufferPointervARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetBufferPointervARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetBufferSubData(target: u32, offset: isize, size: isize, data: *mut c_void) {
    enter("glGetBufferSubData", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetBufferSubData", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetBufferSubDataARB(target: u32, offset: isize, size: isize, data: *mut c_void) {
    enter("glGetBufferSubDataARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetBufferSubDataARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetClipPlane(plane: u32, equation: *mut f64) {
    enter("glGetClipPlane", |cx| unsafe { commands::parameters::glGetClipPlane(cx, plane, equation) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetColorTable(target: u32, format: u32, type_: u32, table: *mut c_void) {
    enter("glGetColorTable", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetColorTable", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetColorTableParameterfv(target: u32, pname: u32, params: *mut f32) {
    enter("glGetColorTableParameterfv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetColorTableParameterfv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetColorTableParameteriv(target: u32, pname: u32, params: *mut i32) {
    enter("glGetColorTableParameteriv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetColorTableParameteriv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetCompressedTexImage(target: u32, level: i32, img: *mut c_void) {
    enter("glGetCompressedTexImage", |cx| unsafe { commands::compressed::glGetCompressedTexImage(cx, target, level, img) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetCompressedTexImageARB(target: u32, level: i32, img: *mut c_void) {
    enter("glGetCompressedTexImageARB", |cx| unsafe { commands::compressed::glGetCompressedTexImage(cx, target, level, img) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetConvolutionFilter(target: u32, format: u32, type_: u32, image: *mut c_void) {
    enter("glGetConvolutionFilter", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetConvolutionFilter", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetConvolutionParameterfv(target: u32, pname: u32, params: *mut f32) {
    enter("glGetConvolutionParameterfv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetConvolutionParameterfv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetConvolutionParameteriv(target: u32, pname: u32, params: *mut i32) {
    enter("glGetConvolutionParameteriv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetConvolutionParameteriv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetDoublev(pname: u32, data: *mut f64) {
    enter("glGetDoublev", |cx| unsafe { commands::get::glGetDoublev(cx, pname, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetError() -> u32 {
    enter("glGetError", |cx| cx.get_error())
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetFloatv(pname: u32, data: *mut f32) {
    enter("glGetFloatv", |cx| unsafe { commands::get::glGetFloatv(cx, pname, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetFramebufferAttachmentParameteriv(target: u32, attachment: u32, pname: u32, params: *mut i32) {
    enter("glGetFramebufferAttachmentParameteriv", |cx| unsafe { commands::framebuffers::glGetFramebufferAttachmentParameteriv(cx, target, attachment, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetFramebufferAttachmentParameterivEXT(target: u32, attachment: u32, pname: u32, params: *mut i32) {
    enter("glGetFramebufferAttachmentParameterivEXT", |cx| unsafe { commands::framebuffers::glGetFramebufferAttachmentParameteriv(cx, target, attachment, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetHandleARB(pname: u32) -> u32 {
    enter("glGetHandleARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetHandleARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetHistogram(target: u32, reset: u8, format: u32, type_: u32, values: *mut c_void) {
    enter("glGetHistogram", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetHistogram", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetHistogramParameterfv(target: u32, pname: u32, params: *mut f32) {
    enter("glGetHistogramParameterfv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetHistogramParameterfv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetHistogramParameteriv(target: u32, pname: u32, params: *mut i32) {
    enter("glGetHistogramParameteriv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetHistogramParameteriv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetInfoLogARB(obj: u32, maxLength: i32, length: *mut i32, infoLog: *mut c_char) {
    enter("glGetInfoLogARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetInfoLogARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetIntegerv(pname: u32, data: *mut i32) {
    enter("glGetIntegerv", |cx| unsafe { commands::get::glGetIntegerv(cx, pname, data) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetLightfv(light: u32, pname: u32, params: *mut f32) {
    enter("glGetLightfv", |cx| unsafe { commands::get::glGetLightfv(cx, light, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetLightiv(light: u32, pname: u32, params: *mut i32) {
    enter("glGetLightiv", |cx| unsafe { commands::get::glGetLightiv(cx, light, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetMapdv(target: u32, query: u32, v: *mut f64) {
    enter("glGetMapdv", |cx| unsafe { commands::evaluators::glGetMapdv(cx, target, query, v) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetMapfv(target: u32, query: u32, v: *mut f32) {
    enter("glGetMapfv", |cx| unsafe { commands::evaluators::glGetMapfv(cx, target, query, v) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetMapiv(target: u32, query: u32, v: *mut i32) {
    enter("glGetMapiv", |cx| unsafe { commands::evaluators::glGetMapiv(cx, target, query, v) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetMaterialfv(face: u32, pname: u32, params: *mut f32) {
    enter("glGetMaterialfv", |cx| unsafe { commands::get::glGetMaterialfv(cx, face, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetMaterialiv(face: u32, pname: u32, params: *mut i32) {
    enter("glGetMaterialiv", |cx| unsafe { commands::get::glGetMaterialiv(cx, face, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetMinmax(target: u32, reset: u8, format: u32, type_: u32, values: *mut c_void) {
    enter("glGetMinmax", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetMinmax", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetMinmaxParameterfv(target: u32, pname: u32, params: *mut f32) {
    enter("glGetMinmaxParameterfv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetMinmaxParameterfv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetMinmaxParameteriv(target: u32, pname: u32, params: *mut i32) {
    enter("glGetMinmaxParameteriv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetMinmaxParameteriv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetObjectParameterfvARB(obj: u32, pname: u32, params: *mut f32) {
    enter("glGetObjectParameterfvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetObjectParameterfvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetObjectParameterivARB(obj: u32, pname: u32, params: *mut i32) {
    enter("glGetObjectParameterivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetObjectParameterivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetPixelMapfv(map: u32, values: *mut f32) {
    enter("glGetPixelMapfv", |cx| unsafe { commands::pixels::glGetPixelMapfv(cx, map, values) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetPixelMapuiv(map: u32, values: *mut u32) {
    enter("glGetPixelMapuiv", |cx| unsafe { commands::pixels::glGetPixelMapuiv(cx, map, values) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetPixelMapusv(map: u32, values: *mut u16) {
    enter("glGetPixelMapusv", |cx| unsafe { commands::pixels::glGetPixelMapusv(cx, map, values) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetPointerv(pname: u32, params: *mut *mut c_void) {
    enter("glGetPointerv", |cx| unsafe { commands::arrays::glGetPointerv(cx, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetPointervEXT(pname: u32, params: *mut *mut c_void) {
    enter("glGetPointervEXT", |cx| unsafe { commands::arrays::glGetPointerv(cx, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetPolygonStipple(mask: *mut u8) {
    enter("glGetPolygonStipple", |cx| unsafe { commands::pixels::glGetPolygonStipple(cx, mask) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetProgramEnvParameterdvARB(target: u32, index: u32, params: *mut f64) {
    enter("glGetProgramEnvParameterdvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetProgramEnvParameterdvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetProgramEnvParameterfvARB(target: u32, index: u32, params: *mut f32) {
    enter("glGetProgramEnvParameterfvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetProgramEnvParameterfvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetProgramInfoLog(program: u32, bufSize: i32, length: *mut i32, infoLog: *mut c_char) {
    enter("glGetProgramInfoLog", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetProgramInfoLog", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetProgramLocalParameterdvARB(target: u32, index: u32, params: *mut f64) {
    enter("glGetProgramLocalParameterdvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetProgramLocalParameterdvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetProgramLocalParameterfvARB(target: u32, index: u32, params: *mut f32) {
    enter("glGetProgramLocalParameterfvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetProgramLocalParameterfvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetProgramStringARB(target: u32, pname: u32, string: *mut c_void) {
    enter("glGetProgramStringARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetProgramStringARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetProgramiv(program: u32, pname: u32, params: *mut i32) {
    enter("glGetProgramiv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetProgramiv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetProgramivARB(target: u32, pname: u32, params: *mut i32) {
    enter("glGetProgramivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetProgramivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetQueryObjectiv(id: u32, pname: u32, params: *mut i32) {
    enter("glGetQueryObjectiv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetQueryObjectiv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetQueryObjectivARB(id: u32, pname: u32, params: *mut i32) {
    enter("glGetQueryObjectivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetQueryObjectivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetQueryObjectuiv(id: u32, pname: u32, params: *mut u32) {
    enter("glGetQueryObjectuiv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetQueryObjectuiv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetQueryObjectuivARB(id: u32, pname: u32, params: *mut u32) {
    enter("glGetQueryObjectuivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetQueryObjectuivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetQueryiv(target: u32, pname: u32, params: *mut i32) {
    enter("glGetQueryiv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetQueryiv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetQueryivARB(target: u32, pname: u32, params: *mut i32) {
    enter("glGetQueryivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetQueryivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetRenderbufferParameteriv(target: u32, pname: u32, params: *mut i32) {
    enter("glGetRenderbufferParameteriv", |cx| unsafe { commands::framebuffers::glGetRenderbufferParameteriv(cx, target, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetRenderbufferParameterivEXT(target: u32, pname: u32, params: *mut i32) {
    enter("glGetRenderbufferParameterivEXT", |cx| unsafe { commands::framebuffers::glGetRenderbufferParameteriv(cx, target, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetSeparableFilter(target: u32, format: u32, type_: u32, row: *mut c_void, column: *mut c_void, span: *mut c_void) {
    enter("glGetSeparableFilter", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetSeparableFilter", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetShaderInfoLog(shader: u32, bufSize: i32, length: *mut i32, infoLog: *mut c_char) {
    enter("glGetShaderInfoLog", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetShaderInfoLog", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetShaderSource(shader: u32, bufSize: i32, length: *mut i32, source: *mut c_char) {
    enter("glGetShaderSource", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetShaderSource", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetShaderSourceARB(obj: u32, maxLength: i32, length: *mut i32, source: *mut c_char) {
    enter("glGetShaderSourceARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetShaderSourceARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetShaderiv(shader: u32, pname: u32, params: *mut i32) {
    enter("glGetShaderiv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetShaderiv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetString(name: u32) -> *const u8 {
    enter("glGetString", |cx| unsafe { commands::get::glGetString(cx, name) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetTexEnvfv(target: u32, pname: u32, params: *mut f32) {
    enter("glGetTexEnvfv", |cx| unsafe { commands::get::glGetTexEnvfv(cx, target, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetTexEnviv(target: u32, pname: u32, params: *mut i32) {
    enter("glGetTexEnviv", |cx| unsafe { commands::get::glGetTexEnviv(cx, target, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetTexGendv(coord: u32, pname: u32, params: *mut f64) {
    enter("glGetTexGendv", |cx| unsafe { commands::get::glGetTexGendv(cx, coord, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetTexGenfv(coord: u32, pname: u32, params: *mut f32) {
    enter("glGetTexGenfv", |cx| unsafe { commands::get::glGetTexGenfv(cx, coord, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetTexGeniv(coord: u32, pname: u32, params: *mut i32) {
    enter("glGetTexGeniv", |cx| unsafe { commands::get::glGetTexGeniv(cx, coord, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetTexImage(target: u32, level: i32, format: u32, type_: u32, pixels: *mut c_void) {
    enter("glGetTexImage", |cx| unsafe { commands::textures::glGetTexImage(cx, target, level, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetTexLevelParameterfv(target: u32, level: i32, pname: u32, params: *mut f32) {
    enter("glGetTexLevelParameterfv", |cx| unsafe { commands::get::glGetTexLevelParameterfv(cx, target, level, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetTexLevelParameteriv(target: u32, level: i32, pname: u32, params: *mut i32) {
    enter("glGetTexLevelParameteriv", |cx| unsafe { commands::get::glGetTexLevelParameteriv(cx, target, level, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetTexParameterfv(target: u32, pname: u32, params: *mut f32) {
    enter("glGetTexParameterfv", |cx| unsafe { commands::get::glGetTexParameterfv(cx, target, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetTexParameteriv(target: u32, pname: u32, params: *mut i32) {
    enter("glGetTexParameteriv", |cx| unsafe { commands::get::glGetTexParameteriv(cx, target, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetUniformLocation(program: u32, name: *const c_char) -> i32 {
    enter("glGetUniformLocation", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetUniformLocation", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetUniformLocationARB(programObj: u32, name: *const c_char) -> i32 {
    enter("glGetUniformLocationARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetUniformLocationARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetUniformfv(program: u32, location: i32, params: *mut f32) {
    enter("glGetUniformfv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetUniformfv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetUniformfvARB(programObj: u32, location: i32, params: *mut f32) {
    enter("glGetUniformfvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetUniformfvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetUniformiv(program: u32, location: i32, params: *mut i32) {
    enter("glGetUniformiv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetUniformiv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetUniformivARB(programObj: u32, location: i32, params: *mut i32) {
    enter("glGetUniformivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetUniformivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetVertexAttribPointerv(index: u32, pname: u32, pointer: *mut *mut c_void) {
    enter("glGetVertexAttribPointerv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetVertexAttribPointerv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetVertexAttribPointervARB(index: u32, pname: u32, pointer: *mut *mut c_void) {
    enter("glGetVertexAttribPointervARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetVertexAttribPointervARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetVertexAttribdv(index: u32, pname: u32, params: *mut f64) {
    enter("glGetVertexAttribdv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetVertexAttribdv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetVertexAttribdvARB(index: u32, pname: u32, params: *mut f64) {
    enter("glGetVertexAttribdvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetVertexAttribdvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetVertexAttribfv(index: u32, pname: u32, params: *mut f32) {
    enter("glGetVertexAttribfv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetVertexAttribfv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetVertexAttribfvARB(index: u32, pname: u32, params: *mut f32) {
    enter("glGetVertexAttribfvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetVertexAttribfvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetVertexAttribiv(index: u32, pname: u32, params: *mut i32) {
    enter("glGetVertexAttribiv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetVertexAttribiv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glGetVertexAttribivARB(index: u32, pname: u32, params: *mut i32) {
    enter("glGetVertexAttribivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glGetVertexAttribivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glHint(target: u32, mode: u32) {
    enter("glHint", |cx| cx.hint(target, mode))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glHistogram(target: u32, width: i32, internalformat: u32, sink: u8) {
    enter("glHistogram", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glHistogram", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexMask(mask: u32) {
    enter("glIndexMask", |cx| cx.index_mask(mask))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexPointer(type_: u32, stride: i32, pointer: *const c_void) {
    enter("glIndexPointer", |cx| unsafe { commands::arrays::glIndexPointer(cx, type_, stride, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexPointerEXT(type_: u32, stride: i32, count: i32, pointer: *const c_void) {
    enter("glIndexPointerEXT", |cx| unsafe { commands::arrays::glIndexPointerEXT(cx, type_, stride, count, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexd(c: f64) {
    enter("glIndexd", |cx| cx.index(c as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexdv(c: *const f64) {
    enter("glIndexdv", |cx| { let Some(c) = (unsafe { read::<f64, 1>(cx, "glIndexdv", c) }) else { return }; cx.index(c[0] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexf(c: f32) {
    enter("glIndexf", |cx| cx.index(c))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexfv(c: *const f32) {
    enter("glIndexfv", |cx| { let Some(c) = (unsafe { read::<f32, 1>(cx, "glIndexfv", c) }) else { return }; cx.index(c[0]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexi(c: i32) {
    enter("glIndexi", |cx| cx.index(c as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexiv(c: *const i32) {
    enter("glIndexiv", |cx| { let Some(c) = (unsafe { read::<i32, 1>(cx, "glIndexiv", c) }) else { return }; cx.index(c[0] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexs(c: i16) {
    enter("glIndexs", |cx| cx.index(c as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexsv(c: *const i16) {
    enter("glIndexsv", |cx| { let Some(c) = (unsafe { read::<i16, 1>(cx, "glIndexsv", c) }) else { return }; cx.index(c[0] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexub(c: u8) {
    enter("glIndexub", |cx| cx.index(c as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIndexubv(c: *const u8) {
    enter("glIndexubv", |cx| { let Some(c) = (unsafe { read::<u8, 1>(cx, "glIndexubv", c) }) else { return }; cx.index(c[0] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glInitNames() {
    enter("glInitNames", |cx| cx.init_names())
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glInterleavedArrays(format: u32, stride: i32, pointer: *const c_void) {
    enter("glInterleavedArrays", |cx| unsafe { commands::arrays::glInterleavedArrays(cx, format, stride, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsBuffer(buffer: u32) -> u8 {
    enter("glIsBuffer", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glIsBuffer", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsBufferARB(buffer: u32) -> u8 {
    enter("glIsBufferARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glIsBufferARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsEnabled(cap: u32) -> u8 {
    enter("glIsEnabled", |cx| cx.is_enabled(cap) as u8)
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsFramebuffer(framebuffer: u32) -> u8 {
    enter("glIsFramebuffer", |cx| cx.is_framebuffer(framebuffer) as u8)
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsFramebufferEXT(framebuffer: u32) -> u8 {
    enter("glIsFramebufferEXT", |cx| cx.is_framebuffer(framebuffer) as u8)
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsList(list: u32) -> u8 {
    enter("glIsList", |cx| cx.is_list(list) as u8)
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsProgram(program: u32) -> u8 {
    enter("glIsProgram", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glIsProgram", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsProgramARB(program: u32) -> u8 {
    enter("glIsProgramARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glIsProgramARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsQuery(id: u32) -> u8 {
    enter("glIsQuery", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glIsQuery", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsQueryARB(id: u32) -> u8 {
    enter("glIsQueryARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glIsQueryARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsRenderbuffer(renderbuffer: u32) -> u8 {
    enter("glIsRenderbuffer", |cx| cx.is_renderbuffer(renderbuffer) as u8)
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsRenderbufferEXT(renderbuffer: u32) -> u8 {
    enter("glIsRenderbufferEXT", |cx| cx.is_renderbuffer(renderbuffer) as u8)
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsShader(shader: u32) -> u8 {
    enter("glIsShader", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glIsShader", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsTexture(texture: u32) -> u8 {
    enter("glIsTexture", |cx| cx.is_texture(texture) as u8)
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glIsTextureEXT(texture: u32) -> u8 {
    enter("glIsTextureEXT", |cx| cx.is_texture(texture) as u8)
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLightModelf(pname: u32, param: f32) {
    enter("glLightModelf", |cx| unsafe { commands::parameters::glLightModelf(cx, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLightModelfv(pname: u32, params: *const f32) {
    enter("glLightModelfv", |cx| unsafe { commands::parameters::glLightModelfv(cx, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLightModeli(pname: u32, param: i32) {
    enter("glLightModeli", |cx| unsafe { commands::parameters::glLightModeli(cx, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLightModeliv(pname: u32, params: *const i32) {
    enter("glLightModeliv", |cx| unsafe { commands::parameters::glLightModeliv(cx, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLightf(light: u32, pname: u32, param: f32) {
    enter("glLightf", |cx| unsafe { commands::parameters::glLightf(cx, light, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLightfv(light: u32, pname: u32, params: *const f32) {
    enter("glLightfv", |cx| unsafe { commands::parameters::glLightfv(cx, light, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLighti(light: u32, pname: u32, param: i32) {
    enter("glLighti", |cx| unsafe { commands::parameters::glLighti(cx, light, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLightiv(light: u32, pname: u32, params: *const i32) {
    enter("glLightiv", |cx| unsafe { commands::parameters::glLightiv(cx, light, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLineStipple(factor: i32, pattern: u16) {
    enter("glLineStipple", |cx| cx.line_stipple(factor, pattern))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLineWidth(width: f32) {
    enter("glLineWidth", |cx| cx.line_width(width))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLinkProgram(program: u32) {
    enter("glLinkProgram", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glLinkProgram", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLinkProgramARB(programObj: u32) {
    enter("glLinkProgramARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glLinkProgramARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glListBase(base: u32) {
    enter("glListBase", |cx| cx.list_base(base))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLoadIdentity() {
    enter("glLoadIdentity", |cx| cx.load_identity())
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLoadMatrixd(m: *const f64) {
    enter("glLoadMatrixd", |cx| unsafe { commands::matrices::glLoadMatrixd(cx, m) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLoadMatrixf(m: *const f32) {
    enter("glLoadMatrixf", |cx| unsafe { commands::matrices::glLoadMatrixf(cx, m) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLoadName(name: u32) {
    enter("glLoadName", |cx| cx.load_name(name))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLoadTransposeMatrixd(m: *const f64) {
    enter("glLoadTransposeMatrixd", |cx| unsafe { commands::matrices::glLoadTransposeMatrixd(cx, m) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLoadTransposeMatrixdARB(m: *const f64) {
    enter("glLoadTransposeMatrixdARB", |cx| unsafe { commands::matrices::glLoadTransposeMatrixd(cx, m) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLoadTransposeMatrixf(m: *const f32) {
    enter("glLoadTransposeMatrixf", |cx| unsafe { commands::matrices::glLoadTransposeMatrixf(cx, m) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLoadTransposeMatrixfARB(m: *const f32) {
    enter("glLoadTransposeMatrixfARB", |cx| unsafe { commands::matrices::glLoadTransposeMatrixf(cx, m) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLockArraysEXT(first: i32, count: i32) {
    enter("glLockArraysEXT", |cx| cx.lock_arrays_ext(first, count))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glLogicOp(opcode: u32) {
    enter("glLogicOp", |cx| cx.logic_op(opcode))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMap1d(target: u32, u1: f64, u2: f64, stride: i32, order: i32, points: *const f64) {
    enter("glMap1d", |cx| unsafe { commands::evaluators::glMap1d(cx, target, u1, u2, stride, order, points) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMap1f(target: u32, u1: f32, u2: f32, stride: i32, order: i32, points: *const f32) {
    enter("glMap1f", |cx| unsafe { commands::evaluators::glMap1f(cx, target, u1, u2, stride, order, points) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMap2d(target: u32, u1: f64, u2: f64, ustride: i32, uorder: i32, v1: f64, v2: f64, vstride: i32, vorder: i32, points: *const f64) {
    enter("glMap2d", |cx| unsafe { commands::evaluators::glMap2d(cx, target, u1, u2, ustride, uorder, v1, v2, vstride, vorder, points) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMap2f(target: u32, u1: f32, u2: f32, ustride: i32, uorder: i32, v1: f32, v2: f32, vstride: i32, vorder: i32, points: *const f32) {
    enter("glMap2f", |cx| unsafe { commands::evaluators::glMap2f(cx, target, u1, u2, ustride, uorder, v1, v2, vstride, vorder, points) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMapBuffer(target: u32, access: u32) -> *mut c_void {
    enter("glMapBuffer", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glMapBuffer", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMapBufferARB(target: u32, access: u32) -> *mut c_void {
    enter("glMapBufferARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glMapBufferARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMapGrid1d(un: i32, u1: f64, u2: f64) {
    enter("glMapGrid1d", |cx| cx.map_grid1(un, u1 as f32, u2 as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMapGrid1f(un: i32, u1: f32, u2: f32) {
    enter("glMapGrid1f", |cx| cx.map_grid1(un, u1, u2))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMapGrid2d(un: i32, u1: f64, u2: f64, vn: i32, v1: f64, v2: f64) {
    enter("glMapGrid2d", |cx| cx.map_grid2(un, u1 as f32, u2 as f32, vn, v1 as f32, v2 as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMapGrid2f(un: i32, u1: f32, u2: f32, vn: i32, v1: f32, v2: f32) {
    enter("glMapGrid2f", |cx| cx.map_grid2(un, u1, u2, vn, v1, v2))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMaterialf(face: u32, pname: u32, param: f32) {
    enter("glMaterialf", |cx| unsafe { commands::parameters::glMaterialf(cx, face, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMaterialfv(face: u32, pname: u32, params: *const f32) {
    enter("glMaterialfv", |cx| unsafe { commands::parameters::glMaterialfv(cx, face, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMateriali(face: u32, pname: u32, param: i32) {
    enter("glMateriali", |cx| unsafe { commands::parameters::glMateriali(cx, face, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMaterialiv(face: u32, pname: u32, params: *const i32) {
    enter("glMaterialiv", |cx| unsafe { commands::parameters::glMaterialiv(cx, face, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMatrixMode(mode: u32) {
    enter("glMatrixMode", |cx| cx.matrix_mode(mode))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMinmax(target: u32, internalformat: u32, sink: u8) {
    enter("glMinmax", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glMinmax", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultMatrixd(m: *const f64) {
    enter("glMultMatrixd", |cx| unsafe { commands::matrices::glMultMatrixd(cx, m) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultMatrixf(m: *const f32) {
    enter("glMultMatrixf", |cx| unsafe { commands::matrices::glMultMatrixf(cx, m) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultTransposeMatrixd(m: *const f64) {
    enter("glMultTransposeMatrixd", |cx| unsafe { commands::matrices::glMultTransposeMatrixd(cx, m) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultTransposeMatrixdARB(m: *const f64) {
    enter("glMultTransposeMatrixdARB", |cx| unsafe { commands::matrices::glMultTransposeMatrixd(cx, m) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultTransposeMatrixf(m: *const f32) {
    enter("glMultTransposeMatrixf", |cx| unsafe { commands::matrices::glMultTransposeMatrixf(cx, m) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultTransposeMatrixfARB(m: *const f32) {
    enter("glMultTransposeMatrixfARB", |cx| unsafe { commands::matrices::glMultTransposeMatrixf(cx, m) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiDrawArrays(mode: u32, first: *const i32, count: *const i32, drawcount: i32) {
    enter("glMultiDrawArrays", |cx| unsafe { commands::arrays::glMultiDrawArrays(cx, mode, first, count, drawcount) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiDrawArraysEXT(mode: u32, first: *const i32, count: *const i32, primcount: i32) {
    enter("glMultiDrawArraysEXT", |cx| unsafe { commands::arrays::glMultiDrawArrays(cx, mode, first, count, primcount) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiDrawElements(mode: u32, count: *const i32, type_: u32, indices: *const *const c_void, drawcount: i32) {
    enter("glMultiDrawElements", |cx| unsafe { commands::arrays::glMultiDrawElements(cx, mode, count, type_, indices, drawcount) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiDrawElementsEXT(mode: u32, count: *const i32, type_: u32, indices: *const *const c_void, primcount: i32) {
    enter("glMultiDrawElementsEXT", |cx| unsafe { commands::arrays::glMultiDrawElements(cx, mode, count, type_, indices, primcount) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1d(target: u32, s: f64) {
    enter("glMultiTexCoord1d", |cx| cx.multi_tex_coord(target, s as f32, 0.0, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1dARB(target: u32, s: f64) {
    enter("glMultiTexCoord1dARB", |cx| cx.multi_tex_coord(target, s as f32, 0.0, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1dv(target: u32, v: *const f64) {
    enter("glMultiTexCoord1dv", |cx| { let Some(v) = (unsafe { read::<f64, 1>(cx, "glMultiTexCoord1dv", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, 0.0, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1dvARB(target: u32, v: *const f64) {
    enter("glMultiTexCoord1dvARB", |cx| { let Some(v) = (unsafe { read::<f64, 1>(cx, "glMultiTexCoord1dvARB", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, 0.0, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1f(target: u32, s: f32) {
    enter("glMultiTexCoord1f", |cx| cx.multi_tex_coord(target, s, 0.0, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1fARB(target: u32, s: f32) {
    enter("glMultiTexCoord1fARB", |cx| cx.multi_tex_coord(target, s, 0.0, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1fv(target: u32, v: *const f32) {
    enter("glMultiTexCoord1fv", |cx| { let Some(v) = (unsafe { read::<f32, 1>(cx, "glMultiTexCoord1fv", v) }) else { return }; cx.multi_tex_coord(target, v[0], 0.0, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1fvARB(target: u32, v: *const f32) {
    enter("glMultiTexCoord1fvARB", |cx| { let Some(v) = (unsafe { read::<f32, 1>(cx, "glMultiTexCoord1fvARB", v) }) else { return }; cx.multi_tex_coord(target, v[0], 0.0, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1i(target: u32, s: i32) {
    enter("glMultiTexCoord1i", |cx| cx.multi_tex_coord(target, s as f32, 0.0, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1iARB(target: u32, s: i32) {
    enter("glMultiTexCoord1iARB", |cx| cx.multi_tex_coord(target, s as f32, 0.0, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1iv(target: u32, v: *const i32) {
    enter("glMultiTexCoord1iv", |cx| { let Some(v) = (unsafe { read::<i32, 1>(cx, "glMultiTexCoord1iv", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, 0.0, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1ivARB(target: u32, v: *const i32) {
    enter("glMultiTexCoord1ivARB", |cx| { let Some(v) = (unsafe { read::<i32, 1>(cx, "glMultiTexCoord1ivARB", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, 0.0, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1s(target: u32, s: i16) {
    enter("glMultiTexCoord1s", |cx| cx.multi_tex_coord(target, s as f32, 0.0, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1sARB(target: u32, s: i16) {
    enter("glMultiTexCoord1sARB", |cx| cx.multi_tex_coord(target, s as f32, 0.0, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1sv(target: u32, v: *const i16) {
    enter("glMultiTexCoord1sv", |cx| { let Some(v) = (unsafe { read::<i16, 1>(cx, "glMultiTexCoord1sv", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, 0.0, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord1svARB(target: u32, v: *const i16) {
    enter("glMultiTexCoord1svARB", |cx| { let Some(v) = (unsafe { read::<i16, 1>(cx, "glMultiTexCoord1svARB", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, 0.0, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2d(target: u32, s: f64, t: f64) {
    enter("glMultiTexCoord2d", |cx| cx.multi_tex_coord(target, s as f32, t as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2dARB(target: u32, s: f64, t: f64) {
    enter("glMultiTexCoord2dARB", |cx| cx.multi_tex_coord(target, s as f32, t as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2dv(target: u32, v: *const f64) {
    enter("glMultiTexCoord2dv", |cx| { let Some(v) = (unsafe { read::<f64, 2>(cx, "glMultiTexCoord2dv", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2dvARB(target: u32, v: *const f64) {
    enter("glMultiTexCoord2dvARB", |cx| { let Some(v) = (unsafe { read::<f64, 2>(cx, "glMultiTexCoord2dvARB", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2f(target: u32, s: f32, t: f32) {
    enter("glMultiTexCoord2f", |cx| cx.multi_tex_coord(target, s, t, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2fARB(target: u32, s: f32, t: f32) {
    enter("glMultiTexCoord2fARB", |cx| cx.multi_tex_coord(target, s, t, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2fv(target: u32, v: *const f32) {
    enter("glMultiTexCoord2fv", |cx| { let Some(v) = (unsafe { read::<f32, 2>(cx, "glMultiTexCoord2fv", v) }) else { return }; cx.multi_tex_coord(target, v[0], v[1], 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2fvARB(target: u32, v: *const f32) {
    enter("glMultiTexCoord2fvARB", |cx| { let Some(v) = (unsafe { read::<f32, 2>(cx, "glMultiTexCoord2fvARB", v) }) else { return }; cx.multi_tex_coord(target, v[0], v[1], 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2i(target: u32, s: i32, t: i32) {
    enter("glMultiTexCoord2i", |cx| cx.multi_tex_coord(target, s as f32, t as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2iARB(target: u32, s: i32, t: i32) {
    enter("glMultiTexCoord2iARB", |cx| cx.multi_tex_coord(target, s as f32, t as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2iv(target: u32, v: *const i32) {
    enter("glMultiTexCoord2iv", |cx| { let Some(v) = (unsafe { read::<i32, 2>(cx, "glMultiTexCoord2iv", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2ivARB(target: u32, v: *const i32) {
    enter("glMultiTexCoord2ivARB", |cx| { let Some(v) = (unsafe { read::<i32, 2>(cx, "glMultiTexCoord2ivARB", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2s(target: u32, s: i16, t: i16) {
    enter("glMultiTexCoord2s", |cx| cx.multi_tex_coord(target, s as f32, t as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2sARB(target: u32, s: i16, t: i16) {
    enter("glMultiTexCoord2sARB", |cx| cx.multi_tex_coord(target, s as f32, t as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2sv(target: u32, v: *const i16) {
    enter("glMultiTexCoord2sv", |cx| { let Some(v) = (unsafe { read::<i16, 2>(cx, "glMultiTexCoord2sv", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord2svARB(target: u32, v: *const i16) {
    enter("glMultiTexCoord2svARB", |cx| { let Some(v) = (unsafe { read::<i16, 2>(cx, "glMultiTexCoord2svARB", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3d(target: u32, s: f64, t: f64, r: f64) {
    enter("glMultiTexCoord3d", |cx| cx.multi_tex_coord(target, s as f32, t as f32, r as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3dARB(target: u32, s: f64, t: f64, r: f64) {
    enter("glMultiTexCoord3dARB", |cx| cx.multi_tex_coord(target, s as f32, t as f32, r as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3dv(target: u32, v: *const f64) {
    enter("glMultiTexCoord3dv", |cx| { let Some(v) = (unsafe { read::<f64, 3>(cx, "glMultiTexCoord3dv", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3dvARB(target: u32, v: *const f64) {
    enter("glMultiTexCoord3dvARB", |cx| { let Some(v) = (unsafe { read::<f64, 3>(cx, "glMultiTexCoord3dvARB", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3f(target: u32, s: f32, t: f32, r: f32) {
    enter("glMultiTexCoord3f", |cx| cx.multi_tex_coord(target, s, t, r, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3fARB(target: u32, s: f32, t: f32, r: f32) {
    enter("glMultiTexCoord3fARB", |cx| cx.multi_tex_coord(target, s, t, r, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3fv(target: u32, v: *const f32) {
    enter("glMultiTexCoord3fv", |cx| { let Some(v) = (unsafe { read::<f32, 3>(cx, "glMultiTexCoord3fv", v) }) else { return }; cx.multi_tex_coord(target, v[0], v[1], v[2], 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3fvARB(target: u32, v: *const f32) {
    enter("glMultiTexCoord3fvARB", |cx| { let Some(v) = (unsafe { read::<f32, 3>(cx, "glMultiTexCoord3fvARB", v) }) else { return }; cx.multi_tex_coord(target, v[0], v[1], v[2], 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3i(target: u32, s: i32, t: i32, r: i32) {
    enter("glMultiTexCoord3i", |cx| cx.multi_tex_coord(target, s as f32, t as f32, r as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3iARB(target: u32, s: i32, t: i32, r: i32) {
    enter("glMultiTexCoord3iARB", |cx| cx.multi_tex_coord(target, s as f32, t as f32, r as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3iv(target: u32, v: *const i32) {
    enter("glMultiTexCoord3iv", |cx| { let Some(v) = (unsafe { read::<i32, 3>(cx, "glMultiTexCoord3iv", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3ivARB(target: u32, v: *const i32) {
    enter("glMultiTexCoord3ivARB", |cx| { let Some(v) = (unsafe { read::<i32, 3>(cx, "glMultiTexCoord3ivARB", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3s(target: u32, s: i16, t: i16, r: i16) {
    enter("glMultiTexCoord3s", |cx| cx.multi_tex_coord(target, s as f32, t as f32, r as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3sARB(target: u32, s: i16, t: i16, r: i16) {
    enter("glMultiTexCoord3sARB", |cx| cx.multi_tex_coord(target, s as f32, t as f32, r as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3sv(target: u32, v: *const i16) {
    enter("glMultiTexCoord3sv", |cx| { let Some(v) = (unsafe { read::<i16, 3>(cx, "glMultiTexCoord3sv", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord3svARB(target: u32, v: *const i16) {
    enter("glMultiTexCoord3svARB", |cx| { let Some(v) = (unsafe { read::<i16, 3>(cx, "glMultiTexCoord3svARB", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4d(target: u32, s: f64, t: f64, r: f64, q: f64) {
    enter("glMultiTexCoord4d", |cx| cx.multi_tex_coord(target, s as f32, t as f32, r as f32, q as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4dARB(target: u32, s: f64, t: f64, r: f64, q: f64) {
    enter("glMultiTexCoord4dARB", |cx| cx.multi_tex_coord(target, s as f32, t as f32, r as f32, q as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4dv(target: u32, v: *const f64) {
    enter("glMultiTexCoord4dv", |cx| { let Some(v) = (unsafe { read::<f64, 4>(cx, "glMultiTexCoord4dv", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4dvARB(target: u32, v: *const f64) {
    enter("glMultiTexCoord4dvARB", |cx| { let Some(v) = (unsafe { read::<f64, 4>(cx, "glMultiTexCoord4dvARB", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4f(target: u32, s: f32, t: f32, r: f32, q: f32) {
    enter("glMultiTexCoord4f", |cx| cx.multi_tex_coord(target, s, t, r, q))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4fARB(target: u32, s: f32, t: f32, r: f32, q: f32) {
    enter("glMultiTexCoord4fARB", |cx| cx.multi_tex_coord(target, s, t, r, q))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4fv(target: u32, v: *const f32) {
    enter("glMultiTexCoord4fv", |cx| { let Some(v) = (unsafe { read::<f32, 4>(cx, "glMultiTexCoord4fv", v) }) else { return }; cx.multi_tex_coord(target, v[0], v[1], v[2], v[3]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4fvARB(target: u32, v: *const f32) {
    enter("glMultiTexCoord4fvARB", |cx| { let Some(v) = (unsafe { read::<f32, 4>(cx, "glMultiTexCoord4fvARB", v) }) else { return }; cx.multi_tex_coord(target, v[0], v[1], v[2], v[3]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4i(target: u32, s: i32, t: i32, r: i32, q: i32) {
    enter("glMultiTexCoord4i", |cx| cx.multi_tex_coord(target, s as f32, t as f32, r as f32, q as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4iARB(target: u32, s: i32, t: i32, r: i32, q: i32) {
    enter("glMultiTexCoord4iARB", |cx| cx.multi_tex_coord(target, s as f32, t as f32, r as f32, q as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4iv(target: u32, v: *const i32) {
    enter("glMultiTexCoord4iv", |cx| { let Some(v) = (unsafe { read::<i32, 4>(cx, "glMultiTexCoord4iv", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4ivARB(target: u32, v: *const i32) {
    enter("glMultiTexCoord4ivARB", |cx| { let Some(v) = (unsafe { read::<i32, 4>(cx, "glMultiTexCoord4ivARB", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4s(target: u32, s: i16, t: i16, r: i16, q: i16) {
    enter("glMultiTexCoord4s", |cx| cx.multi_tex_coord(target, s as f32, t as f32, r as f32, q as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4sARB(target: u32, s: i16, t: i16, r: i16, q: i16) {
    enter("glMultiTexCoord4sARB", |cx| cx.multi_tex_coord(target, s as f32, t as f32, r as f32, q as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4sv(target: u32, v: *const i16) {
    enter("glMultiTexCoord4sv", |cx| { let Some(v) = (unsafe { read::<i16, 4>(cx, "glMultiTexCoord4sv", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glMultiTexCoord4svARB(target: u32, v: *const i16) {
    enter("glMultiTexCoord4svARB", |cx| { let Some(v) = (unsafe { read::<i16, 4>(cx, "glMultiTexCoord4svARB", v) }) else { return }; cx.multi_tex_coord(target, v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNewList(list: u32, mode: u32) {
    enter("glNewList", |cx| cx.new_list(list, mode))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNormal3b(nx: i8, ny: i8, nz: i8) {
    enter("glNormal3b", |cx| cx.normal(normalized::i8(nx), normalized::i8(ny), normalized::i8(nz)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNormal3bv(v: *const i8) {
    enter("glNormal3bv", |cx| { let Some(v) = (unsafe { read::<i8, 3>(cx, "glNormal3bv", v) }) else { return }; cx.normal(normalized::i8(v[0]), normalized::i8(v[1]), normalized::i8(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNormal3d(nx: f64, ny: f64, nz: f64) {
    enter("glNormal3d", |cx| cx.normal(nx as f32, ny as f32, nz as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNormal3dv(v: *const f64) {
    enter("glNormal3dv", |cx| { let Some(v) = (unsafe { read::<f64, 3>(cx, "glNormal3dv", v) }) else { return }; cx.normal(v[0] as f32, v[1] as f32, v[2] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNormal3f(nx: f32, ny: f32, nz: f32) {
    enter("glNormal3f", |cx| cx.normal(nx, ny, nz))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNormal3fv(v: *const f32) {
    enter("glNormal3fv", |cx| { let Some(v) = (unsafe { read::<f32, 3>(cx, "glNormal3fv", v) }) else { return }; cx.normal(v[0], v[1], v[2]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNormal3i(nx: i32, ny: i32, nz: i32) {
    enter("glNormal3i", |cx| cx.normal(normalized::i32(nx), normalized::i32(ny), normalized::i32(nz)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNormal3iv(v: *const i32) {
    enter("glNormal3iv", |cx| { let Some(v) = (unsafe { read::<i32, 3>(cx, "glNormal3iv", v) }) else { return }; cx.normal(normalized::i32(v[0]), normalized::i32(v[1]), normalized::i32(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNormal3s(nx: i16, ny: i16, nz: i16) {
    enter("glNormal3s", |cx| cx.normal(normalized::i16(nx), normalized::i16(ny), normalized::i16(nz)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNormal3sv(v: *const i16) {
    enter("glNormal3sv", |cx| { let Some(v) = (unsafe { read::<i16, 3>(cx, "glNormal3sv", v) }) else { return }; cx.normal(normalized::i16(v[0]), normalized::i16(v[1]), normalized::i16(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNormalPointer(type_: u32, stride: i32, pointer: *const c_void) {
    enter("glNormalPointer", |cx| unsafe { commands::arrays::glNormalPointer(cx, type_, stride, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glNormalPointerEXT(type_: u32, stride: i32, count: i32, pointer: *const c_void) {
    enter("glNormalPointerEXT", |cx| unsafe { commands::arrays::glNormalPointerEXT(cx, type_, stride, count, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glOrtho(left: f64, right: f64, bottom: f64, top: f64, zNear: f64, zFar: f64) {
    enter("glOrtho", |cx| cx.ortho(left, right, bottom, top, zNear, zFar))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPassThrough(token: f32) {
    enter("glPassThrough", |cx| cx.pass_through(token))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPixelMapfv(map: u32, mapsize: i32, values: *const f32) {
    enter("glPixelMapfv", |cx| unsafe { commands::pixels::glPixelMapfv(cx, map, mapsize, values) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPixelMapuiv(map: u32, mapsize: i32, values: *const u32) {
    enter("glPixelMapuiv", |cx| unsafe { commands::pixels::glPixelMapuiv(cx, map, mapsize, values) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPixelMapusv(map: u32, mapsize: i32, values: *const u16) {
    enter("glPixelMapusv", |cx| unsafe { commands::pixels::glPixelMapusv(cx, map, mapsize, values) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPixelStoref(pname: u32, param: f32) {
    enter("glPixelStoref", |cx| cx.pixel_storef(pname, param))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPixelStorei(pname: u32, param: i32) {
    enter("glPixelStorei", |cx| cx.pixel_storei(pname, param))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPixelTransferf(pname: u32, param: f32) {
    enter("glPixelTransferf", |cx| cx.pixel_transferf(pname, param))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPixelTransferi(pname: u32, param: i32) {
    enter("glPixelTransferi", |cx| cx.pixel_transferi(pname, param))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPixelZoom(xfactor: f32, yfactor: f32) {
    enter("glPixelZoom", |cx| cx.pixel_zoom(xfactor, yfactor))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPointParameterf(pname: u32, param: f32) {
    enter("glPointParameterf", |cx| unsafe { commands::parameters::glPointParameterf(cx, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPointParameterfARB(pname: u32, param: f32) {
    enter("glPointParameterfARB", |cx| unsafe { commands::parameters::glPointParameterf(cx, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPointParameterfEXT(pname: u32, param: f32) {
    enter("glPointParameterfEXT", |cx| unsafe { commands::parameters::glPointParameterf(cx, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPointParameterfv(pname: u32, params: *const f32) {
    enter("glPointParameterfv", |cx| unsafe { commands::parameters::glPointParameterfv(cx, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPointParameterfvARB(pname: u32, params: *const f32) {
    enter("glPointParameterfvARB", |cx| unsafe { commands::parameters::glPointParameterfv(cx, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPointParameterfvEXT(pname: u32, params: *const f32) {
    enter("glPointParameterfvEXT", |cx| unsafe { commands::parameters::glPointParameterfv(cx, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPointParameteri(pname: u32, param: i32) {
    enter("glPointParameteri", |cx| unsafe { commands::parameters::glPointParameteri(cx, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPointParameteriv(pname: u32, params: *const i32) {
    enter("glPointParameteriv", |cx| unsafe { commands::parameters::glPointParameteriv(cx, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPointSize(size: f32) {
    enter("glPointSize", |cx| cx.point_size(size))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPolygonMode(face: u32, mode: u32) {
    enter("glPolygonMode", |cx| cx.polygon_mode(face, mode))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPolygonOffset(factor: f32, units: f32) {
    enter("glPolygonOffset", |cx| cx.polygon_offset(factor, units))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPolygonOffsetEXT(factor: f32, bias: f32) {
    enter("glPolygonOffsetEXT", |cx| unsafe { commands::extensions::glPolygonOffsetEXT(cx, factor, bias) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPolygonStipple(mask: *const u8) {
    enter("glPolygonStipple", |cx| unsafe { commands::pixels::glPolygonStipple(cx, mask) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPopAttrib() {
    enter("glPopAttrib", |cx| cx.pop_attrib())
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPopClientAttrib() {
    enter("glPopClientAttrib", |cx| cx.pop_client_attrib())
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPopMatrix() {
    enter("glPopMatrix", |cx| cx.pop_matrix())
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPopName() {
    enter("glPopName", |cx| cx.pop_name())
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPrioritizeTextures(n: i32, textures: *const u32, priorities: *const f32) {
    enter("glPrioritizeTextures", |cx| unsafe { commands::textures::glPrioritizeTextures(cx, n, textures, priorities) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPrioritizeTexturesEXT(n: i32, textures: *const u32, priorities: *const f32) {
    enter("glPrioritizeTexturesEXT", |cx| unsafe { commands::textures::glPrioritizeTextures(cx, n, textures, priorities) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glProgramEnvParameter4dARB(target: u32, index: u32, x: f64, y: f64, z: f64, w: f64) {
    enter("glProgramEnvParameter4dARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glProgramEnvParameter4dARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glProgramEnvParameter4dvARB(target: u32, index: u32, params: *const f64) {
    enter("glProgramEnvParameter4dvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glProgramEnvParameter4dvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glProgramEnvParameter4fARB(target: u32, index: u32, x: f32, y: f32, z: f32, w: f32) {
    enter("glProgramEnvParameter4fARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glProgramEnvParameter4fARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glProgramEnvParameter4fvARB(target: u32, index: u32, params: *const f32) {
    enter("glProgramEnvParameter4fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glProgramEnvParameter4fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glProgramEnvParameters4fvEXT(target: u32, index: u32, count: i32, params: *const f32) {
    enter("glProgramEnvParameters4fvEXT", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glProgramEnvParameters4fvEXT", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glProgramLocalParameter4dARB(target: u32, index: u32, x: f64, y: f64, z: f64, w: f64) {
    enter("glProgramLocalParameter4dARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glProgramLocalParameter4dARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glProgramLocalParameter4dvARB(target: u32, index: u32, params: *const f64) {
    enter("glProgramLocalParameter4dvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glProgramLocalParameter4dvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glProgramLocalParameter4fARB(target: u32, index: u32, x: f32, y: f32, z: f32, w: f32) {
    enter("glProgramLocalParameter4fARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glProgramLocalParameter4fARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glProgramLocalParameter4fvARB(target: u32, index: u32, params: *const f32) {
    enter("glProgramLocalParameter4fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glProgramLocalParameter4fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glProgramLocalParameters4fvEXT(target: u32, index: u32, count: i32, params: *const f32) {
    enter("glProgramLocalParameters4fvEXT", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glProgramLocalParameters4fvEXT", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glProgramStringARB(target: u32, format: u32, len: i32, string: *const c_void) {
    enter("glProgramStringARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glProgramStringARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPushAttrib(mask: u32) {
    enter("glPushAttrib", |cx| cx.push_attrib(mask))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPushClientAttrib(mask: u32) {
    enter("glPushClientAttrib", |cx| cx.push_client_attrib(mask))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPushMatrix() {
    enter("glPushMatrix", |cx| cx.push_matrix())
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glPushName(name: u32) {
    enter("glPushName", |cx| cx.push_name(name))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos2d(x: f64, y: f64) {
    enter("glRasterPos2d", |cx| cx.raster_pos(x as f32, y as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos2dv(v: *const f64) {
    enter("glRasterPos2dv", |cx| { let Some(v) = (unsafe { read::<f64, 2>(cx, "glRasterPos2dv", v) }) else { return }; cx.raster_pos(v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos2f(x: f32, y: f32) {
    enter("glRasterPos2f", |cx| cx.raster_pos(x, y, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos2fv(v: *const f32) {
    enter("glRasterPos2fv", |cx| { let Some(v) = (unsafe { read::<f32, 2>(cx, "glRasterPos2fv", v) }) else { return }; cx.raster_pos(v[0], v[1], 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos2i(x: i32, y: i32) {
    enter("glRasterPos2i", |cx| cx.raster_pos(x as f32, y as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos2iv(v: *const i32) {
    enter("glRasterPos2iv", |cx| { let Some(v) = (unsafe { read::<i32, 2>(cx, "glRasterPos2iv", v) }) else { return }; cx.raster_pos(v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos2s(x: i16, y: i16) {
    enter("glRasterPos2s", |cx| cx.raster_pos(x as f32, y as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos2sv(v: *const i16) {
    enter("glRasterPos2sv", |cx| { let Some(v) = (unsafe { read::<i16, 2>(cx, "glRasterPos2sv", v) }) else { return }; cx.raster_pos(v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos3d(x: f64, y: f64, z: f64) {
    enter("glRasterPos3d", |cx| cx.raster_pos(x as f32, y as f32, z as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos3dv(v: *const f64) {
    enter("glRasterPos3dv", |cx| { let Some(v) = (unsafe { read::<f64, 3>(cx, "glRasterPos3dv", v) }) else { return }; cx.raster_pos(v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos3f(x: f32, y: f32, z: f32) {
    enter("glRasterPos3f", |cx| cx.raster_pos(x, y, z, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos3fv(v: *const f32) {
    enter("glRasterPos3fv", |cx| { let Some(v) = (unsafe { read::<f32, 3>(cx, "glRasterPos3fv", v) }) else { return }; cx.raster_pos(v[0], v[1], v[2], 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos3i(x: i32, y: i32, z: i32) {
    enter("glRasterPos3i", |cx| cx.raster_pos(x as f32, y as f32, z as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos3iv(v: *const i32) {
    enter("glRasterPos3iv", |cx| { let Some(v) = (unsafe { read::<i32, 3>(cx, "glRasterPos3iv", v) }) else { return }; cx.raster_pos(v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos3s(x: i16, y: i16, z: i16) {
    enter("glRasterPos3s", |cx| cx.raster_pos(x as f32, y as f32, z as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos3sv(v: *const i16) {
    enter("glRasterPos3sv", |cx| { let Some(v) = (unsafe { read::<i16, 3>(cx, "glRasterPos3sv", v) }) else { return }; cx.raster_pos(v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos4d(x: f64, y: f64, z: f64, w: f64) {
    enter("glRasterPos4d", |cx| cx.raster_pos(x as f32, y as f32, z as f32, w as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos4dv(v: *const f64) {
    enter("glRasterPos4dv", |cx| { let Some(v) = (unsafe { read::<f64, 4>(cx, "glRasterPos4dv", v) }) else { return }; cx.raster_pos(v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos4f(x: f32, y: f32, z: f32, w: f32) {
    enter("glRasterPos4f", |cx| cx.raster_pos(x, y, z, w))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos4fv(v: *const f32) {
    enter("glRasterPos4fv", |cx| { let Some(v) = (unsafe { read::<f32, 4>(cx, "glRasterPos4fv", v) }) else { return }; cx.raster_pos(v[0], v[1], v[2], v[3]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos4i(x: i32, y: i32, z: i32, w: i32) {
    enter("glRasterPos4i", |cx| cx.raster_pos(x as f32, y as f32, z as f32, w as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos4iv(v: *const i32) {
    enter("glRasterPos4iv", |cx| { let Some(v) = (unsafe { read::<i32, 4>(cx, "glRasterPos4iv", v) }) else { return }; cx.raster_pos(v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos4s(x: i16, y: i16, z: i16, w: i16) {
    enter("glRasterPos4s", |cx| cx.raster_pos(x as f32, y as f32, z as f32, w as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRasterPos4sv(v: *const i16) {
    enter("glRasterPos4sv", |cx| { let Some(v) = (unsafe { read::<i16, 4>(cx, "glRasterPos4sv", v) }) else { return }; cx.raster_pos(v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glReadBuffer(src: u32) {
    enter("glReadBuffer", |cx| cx.read_buffer(src))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glReadPixels(x: i32, y: i32, width: i32, height: i32, format: u32, type_: u32, pixels: *mut c_void) {
    enter("glReadPixels", |cx| unsafe { commands::pixels::glReadPixels(cx, x, y, width, height, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRectd(x1: f64, y1: f64, x2: f64, y2: f64) {
    enter("glRectd", |cx| cx.rect(x1 as f32, y1 as f32, x2 as f32, y2 as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRectdv(v1: *const f64, v2: *const f64) {
    enter("glRectdv", |cx| { let Some(v1) = (unsafe { read::<f64, 2>(cx, "glRectdv", v1) }) else { return }; let Some(v2) = (unsafe { read::<f64, 2>(cx, "glRectdv", v2) }) else { return }; cx.rect(v1[0] as f32, v1[1] as f32, v2[0] as f32, v2[1] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRectf(x1: f32, y1: f32, x2: f32, y2: f32) {
    enter("glRectf", |cx| cx.rect(x1, y1, x2, y2))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRectfv(v1: *const f32, v2: *const f32) {
    enter("glRectfv", |cx| { let Some(v1) = (unsafe { read::<f32, 2>(cx, "glRectfv", v1) }) else { return }; let Some(v2) = (unsafe { read::<f32, 2>(cx, "glRectfv", v2) }) else { return }; cx.rect(v1[0], v1[1], v2[0], v2[1]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRecti(x1: i32, y1: i32, x2: i32, y2: i32) {
    enter("glRecti", |cx| cx.rect(x1 as f32, y1 as f32, x2 as f32, y2 as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRectiv(v1: *const i32, v2: *const i32) {
    enter("glRectiv", |cx| { let Some(v1) = (unsafe { read::<i32, 2>(cx, "glRectiv", v1) }) else { return }; let Some(v2) = (unsafe { read::<i32, 2>(cx, "glRectiv", v2) }) else { return }; cx.rect(v1[0] as f32, v1[1] as f32, v2[0] as f32, v2[1] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRects(x1: i16, y1: i16, x2: i16, y2: i16) {
    enter("glRects", |cx| cx.rect(x1 as f32, y1 as f32, x2 as f32, y2 as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRectsv(v1: *const i16, v2: *const i16) {
    enter("glRectsv", |cx| { let Some(v1) = (unsafe { read::<i16, 2>(cx, "glRectsv", v1) }) else { return }; let Some(v2) = (unsafe { read::<i16, 2>(cx, "glRectsv", v2) }) else { return }; cx.rect(v1[0] as f32, v1[1] as f32, v2[0] as f32, v2[1] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRenderMode(mode: u32) -> i32 {
    enter("glRenderMode", |cx| unsafe { commands::selection::glRenderMode(cx, mode) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRenderbufferStorage(target: u32, internalformat: u32, width: i32, height: i32) {
    enter("glRenderbufferStorage", |cx| cx.renderbuffer_storage(target, internalformat, width, height))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRenderbufferStorageEXT(target: u32, internalformat: u32, width: i32, height: i32) {
    enter("glRenderbufferStorageEXT", |cx| cx.renderbuffer_storage(target, internalformat, width, height))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRenderbufferStorageMultisample(target: u32, samples: i32, internalformat: u32, width: i32, height: i32) {
    enter("glRenderbufferStorageMultisample", |cx| cx.renderbuffer_storage_multisample(target, samples, internalformat, width, height))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRenderbufferStorageMultisampleEXT(target: u32, samples: i32, internalformat: u32, width: i32, height: i32) {
    enter("glRenderbufferStorageMultisampleEXT", |cx| cx.renderbuffer_storage_multisample(target, samples, internalformat, width, height))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glResetHistogram(target: u32) {
    enter("glResetHistogram", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glResetHistogram", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glResetMinmax(target: u32) {
    enter("glResetMinmax", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glResetMinmax", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRotated(angle: f64, x: f64, y: f64, z: f64) {
    enter("glRotated", |cx| cx.rotate(angle as f32, x as f32, y as f32, z as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glRotatef(angle: f32, x: f32, y: f32, z: f32) {
    enter("glRotatef", |cx| cx.rotate(angle, x, y, z))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSampleCoverage(value: f32, invert: u8) {
    enter("glSampleCoverage", |cx| cx.sample_coverage(value, invert != 0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSampleCoverageARB(value: f32, invert: u8) {
    enter("glSampleCoverageARB", |cx| cx.sample_coverage(value, invert != 0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glScaled(x: f64, y: f64, z: f64) {
    enter("glScaled", |cx| cx.scale(x as f32, y as f32, z as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glScalef(x: f32, y: f32, z: f32) {
    enter("glScalef", |cx| cx.scale(x, y, z))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glScissor(x: i32, y: i32, width: i32, height: i32) {
    enter("glScissor", |cx| cx.scissor(x, y, width, height))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3b(red: i8, green: i8, blue: i8) {
    enter("glSecondaryColor3b", |cx| cx.secondary_color(normalized::i8(red), normalized::i8(green), normalized::i8(blue)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3bEXT(red: i8, green: i8, blue: i8) {
    enter("glSecondaryColor3bEXT", |cx| cx.secondary_color(normalized::i8(red), normalized::i8(green), normalized::i8(blue)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3bv(v: *const i8) {
    enter("glSecondaryColor3bv", |cx| { let Some(v) = (unsafe { read::<i8, 3>(cx, "glSecondaryColor3bv", v) }) else { return }; cx.secondary_color(normalized::i8(v[0]), normalized::i8(v[1]), normalized::i8(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3bvEXT(v: *const i8) {
    enter("glSecondaryColor3bvEXT", |cx| { let Some(v) = (unsafe { read::<i8, 3>(cx, "glSecondaryColor3bvEXT", v) }) else { return }; cx.secondary_color(normalized::i8(v[0]), normalized::i8(v[1]), normalized::i8(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3d(red: f64, green: f64, blue: f64) {
    enter("glSecondaryColor3d", |cx| cx.secondary_color(red as f32, green as f32, blue as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3dEXT(red: f64, green: f64, blue: f64) {
    enter("glSecondaryColor3dEXT", |cx| cx.secondary_color(red as f32, green as f32, blue as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3dv(v: *const f64) {
    enter("glSecondaryColor3dv", |cx| { let Some(v) = (unsafe { read::<f64, 3>(cx, "glSecondaryColor3dv", v) }) else { return }; cx.secondary_color(v[0] as f32, v[1] as f32, v[2] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3dvEXT(v: *const f64) {
    enter("glSecondaryColor3dvEXT", |cx| { let Some(v) = (unsafe { read::<f64, 3>(cx, "glSecondaryColor3dvEXT", v) }) else { return }; cx.secondary_color(v[0] as f32, v[1] as f32, v[2] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3f(red: f32, green: f32, blue: f32) {
    enter("glSecondaryColor3f", |cx| cx.secondary_color(red, green, blue))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3fEXT(red: f32, green: f32, blue: f32) {
    enter("glSecondaryColor3fEXT", |cx| cx.secondary_color(red, green, blue))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3fv(v: *const f32) {
    enter("glSecondaryColor3fv", |cx| { let Some(v) = (unsafe { read::<f32, 3>(cx, "glSecondaryColor3fv", v) }) else { return }; cx.secondary_color(v[0], v[1], v[2]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3fvEXT(v: *const f32) {
    enter("glSecondaryColor3fvEXT", |cx| { let Some(v) = (unsafe { read::<f32, 3>(cx, "glSecondaryColor3fvEXT", v) }) else { return }; cx.secondary_color(v[0], v[1], v[2]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3i(red: i32, green: i32, blue: i32) {
    enter("glSecondaryColor3i", |cx| cx.secondary_color(normalized::i32(red), normalized::i32(green), normalized::i32(blue)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3iEXT(red: i32, green: i32, blue: i32) {
    enter("glSecondaryColor3iEXT", |cx| cx.secondary_color(normalized::i32(red), normalized::i32(green), normalized::i32(blue)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3iv(v: *const i32) {
    enter("glSecondaryColor3iv", |cx| { let Some(v) = (unsafe { read::<i32, 3>(cx, "glSecondaryColor3iv", v) }) else { return }; cx.secondary_color(normalized::i32(v[0]), normalized::i32(v[1]), normalized::i32(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3ivEXT(v: *const i32) {
    enter("glSecondaryColor3ivEXT", |cx| { let Some(v) = (unsafe { read::<i32, 3>(cx, "glSecondaryColor3ivEXT", v) }) else { return }; cx.secondary_color(normalized::i32(v[0]), normalized::i32(v[1]), normalized::i32(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3s(red: i16, green: i16, blue: i16) {
    enter("glSecondaryColor3s", |cx| cx.secondary_color(normalized::i16(red), normalized::i16(green), normalized::i16(blue)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3sEXT(red: i16, green: i16, blue: i16) {
    enter("glSecondaryColor3sEXT", |cx| cx.secondary_color(normalized::i16(red), normalized::i16(green), normalized::i16(blue)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3sv(v: *const i16) {
    enter("glSecondaryColor3sv", |cx| { let Some(v) = (unsafe { read::<i16, 3>(cx, "glSecondaryColor3sv", v) }) else { return }; cx.secondary_color(normalized::i16(v[0]), normalized::i16(v[1]), normalized::i16(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3svEXT(v: *const i16) {
    enter("glSecondaryColor3svEXT", |cx| { let Some(v) = (unsafe { read::<i16, 3>(cx, "glSecondaryColor3svEXT", v) }) else { return }; cx.secondary_color(normalized::i16(v[0]), normalized::i16(v[1]), normalized::i16(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3ub(red: u8, green: u8, blue: u8) {
    enter("glSecondaryColor3ub", |cx| cx.secondary_color(normalized::u8(red), normalized::u8(green), normalized::u8(blue)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3ubEXT(red: u8, green: u8, blue: u8) {
    enter("glSecondaryColor3ubEXT", |cx| cx.secondary_color(normalized::u8(red), normalized::u8(green), normalized::u8(blue)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3ubv(v: *const u8) {
    enter("glSecondaryColor3ubv", |cx| { let Some(v) = (unsafe { read::<u8, 3>(cx, "glSecondaryColor3ubv", v) }) else { return }; cx.secondary_color(normalized::u8(v[0]), normalized::u8(v[1]), normalized::u8(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3ubvEXT(v: *const u8) {
    enter("glSecondaryColor3ubvEXT", |cx| { let Some(v) = (unsafe { read::<u8, 3>(cx, "glSecondaryColor3ubvEXT", v) }) else { return }; cx.secondary_color(normalized::u8(v[0]), normalized::u8(v[1]), normalized::u8(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3ui(red: u32, green: u32, blue: u32) {
    enter("glSecondaryColor3ui", |cx| cx.secondary_color(normalized::u32(red), normalized::u32(green), normalized::u32(blue)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3uiEXT(red: u32, green: u32, blue: u32) {
    enter("glSecondaryColor3uiEXT", |cx| cx.secondary_color(normalized::u32(red), normalized::u32(green), normalized::u32(blue)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3uiv(v: *const u32) {
    enter("glSecondaryColor3uiv", |cx| { let Some(v) = (unsafe { read::<u32, 3>(cx, "glSecondaryColor3uiv", v) }) else { return }; cx.secondary_color(normalized::u32(v[0]), normalized::u32(v[1]), normalized::u32(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3uivEXT(v: *const u32) {
    enter("glSecondaryColor3uivEXT", |cx| { let Some(v) = (unsafe { read::<u32, 3>(cx, "glSecondaryColor3uivEXT", v) }) else { return }; cx.secondary_color(normalized::u32(v[0]), normalized::u32(v[1]), normalized::u32(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3us(red: u16, green: u16, blue: u16) {
    enter("glSecondaryColor3us", |cx| cx.secondary_color(normalized::u16(red), normalized::u16(green), normalized::u16(blue)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3usEXT(red: u16, green: u16, blue: u16) {
    enter("glSecondaryColor3usEXT", |cx| cx.secondary_color(normalized::u16(red), normalized::u16(green), normalized::u16(blue)))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3usv(v: *const u16) {
    enter("glSecondaryColor3usv", |cx| { let Some(v) = (unsafe { read::<u16, 3>(cx, "glSecondaryColor3usv", v) }) else { return }; cx.secondary_color(normalized::u16(v[0]), normalized::u16(v[1]), normalized::u16(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColor3usvEXT(v: *const u16) {
    enter("glSecondaryColor3usvEXT", |cx| { let Some(v) = (unsafe { read::<u16, 3>(cx, "glSecondaryColor3usvEXT", v) }) else { return }; cx.secondary_color(normalized::u16(v[0]), normalized::u16(v[1]), normalized::u16(v[2])) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColorPointer(size: i32, type_: u32, stride: i32, pointer: *const c_void) {
    enter("glSecondaryColorPointer", |cx| unsafe { commands::arrays::glSecondaryColorPointer(cx, size, type_, stride, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSecondaryColorPointerEXT(size: i32, type_: u32, stride: i32, pointer: *const c_void) {
    enter("glSecondaryColorPointerEXT", |cx| unsafe { commands::arrays::glSecondaryColorPointer(cx, size, type_, stride, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSelectBuffer(size: i32, buffer: *mut u32) {
    enter("glSelectBuffer", |cx| unsafe { commands::selection::glSelectBuffer(cx, size, buffer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glSeparableFilter2D(target: u32, internalformat: u32, width: i32, height: i32, format: u32, type_: u32, row: *const c_void, column: *const c_void) {
    enter("glSeparableFilter2D", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glSeparableFilter2D", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glShadeModel(mode: u32) {
    enter("glShadeModel", |cx| cx.shade_model(mode))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glShaderSource(shader: u32, count: i32, string: *const *const c_char, length: *const i32) {
    enter("glShaderSource", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glShaderSource", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glShaderSourceARB(shaderObj: u32, count: i32, string: *const *const c_char, length: *const i32) {
    enter("glShaderSourceARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glShaderSourceARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glStencilFunc(func: u32, ref_: i32, mask: u32) {
    enter("glStencilFunc", |cx| cx.stencil_func(func, ref_, mask))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glStencilFuncSeparate(face: u32, func: u32, ref_: i32, mask: u32) {
    enter("glStencilFuncSeparate", |cx| cx.stencil_func_separate(face, func, ref_, mask))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glStencilFuncSeparateATI(frontfunc: u32, backfunc: u32, ref_: i32, mask: u32) {
    enter("glStencilFuncSeparateATI", |cx| unsafe { commands::extensions::glStencilFuncSeparateATI(cx, frontfunc, backfunc, ref_, mask) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glStencilMask(mask: u32) {
    enter("glStencilMask", |cx| cx.stencil_mask(mask))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glStencilMaskSeparate(face: u32, mask: u32) {
    enter("glStencilMaskSeparate", |cx| cx.stencil_mask_separate(face, mask))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glStencilOp(fail: u32, zfail: u32, zpass: u32) {
    enter("glStencilOp", |cx| cx.stencil_op(fail, zfail, zpass))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glStencilOpSeparate(face: u32, sfail: u32, dpfail: u32, dppass: u32) {
    enter("glStencilOpSeparate", |cx| cx.stencil_op_separate(face, sfail, dpfail, dppass))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glStencilOpSeparateATI(face: u32, sfail: u32, dpfail: u32, dppass: u32) {
    enter("glStencilOpSeparateATI", |cx| cx.stencil_op_separate(face, sfail, dpfail, dppass))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord1d(s: f64) {
    enter("glTexCoord1d", |cx| cx.tex_coord(s as f32, 0.0, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord1dv(v: *const f64) {
    enter("glTexCoord1dv", |cx| { let Some(v) = (unsafe { read::<f64, 1>(cx, "glTexCoord1dv", v) }) else { return }; cx.tex_coord(v[0] as f32, 0.0, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord1f(s: f32) {
    enter("glTexCoord1f", |cx| cx.tex_coord(s, 0.0, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord1fv(v: *const f32) {
    enter("glTexCoord1fv", |cx| { let Some(v) = (unsafe { read::<f32, 1>(cx, "glTexCoord1fv", v) }) else { return }; cx.tex_coord(v[0], 0.0, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord1i(s: i32) {
    enter("glTexCoord1i", |cx| cx.tex_coord(s as f32, 0.0, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord1iv(v: *const i32) {
    enter("glTexCoord1iv", |cx| { let Some(v) = (unsafe { read::<i32, 1>(cx, "glTexCoord1iv", v) }) else { return }; cx.tex_coord(v[0] as f32, 0.0, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord1s(s: i16) {
    enter("glTexCoord1s", |cx| cx.tex_coord(s as f32, 0.0, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord1sv(v: *const i16) {
    enter("glTexCoord1sv", |cx| { let Some(v) = (unsafe { read::<i16, 1>(cx, "glTexCoord1sv", v) }) else { return }; cx.tex_coord(v[0] as f32, 0.0, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord2d(s: f64, t: f64) {
    enter("glTexCoord2d", |cx| cx.tex_coord(s as f32, t as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord2dv(v: *const f64) {
    enter("glTexCoord2dv", |cx| { let Some(v) = (unsafe { read::<f64, 2>(cx, "glTexCoord2dv", v) }) else { return }; cx.tex_coord(v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord2f(s: f32, t: f32) {
    enter("glTexCoord2f", |cx| cx.tex_coord(s, t, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord2fv(v: *const f32) {
    enter("glTexCoord2fv", |cx| { let Some(v) = (unsafe { read::<f32, 2>(cx, "glTexCoord2fv", v) }) else { return }; cx.tex_coord(v[0], v[1], 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord2i(s: i32, t: i32) {
    enter("glTexCoord2i", |cx| cx.tex_coord(s as f32, t as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord2iv(v: *const i32) {
    enter("glTexCoord2iv", |cx| { let Some(v) = (unsafe { read::<i32, 2>(cx, "glTexCoord2iv", v) }) else { return }; cx.tex_coord(v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord2s(s: i16, t: i16) {
    enter("glTexCoord2s", |cx| cx.tex_coord(s as f32, t as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord2sv(v: *const i16) {
    enter("glTexCoord2sv", |cx| { let Some(v) = (unsafe { read::<i16, 2>(cx, "glTexCoord2sv", v) }) else { return }; cx.tex_coord(v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord3d(s: f64, t: f64, r: f64) {
    enter("glTexCoord3d", |cx| cx.tex_coord(s as f32, t as f32, r as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord3dv(v: *const f64) {
    enter("glTexCoord3dv", |cx| { let Some(v) = (unsafe { read::<f64, 3>(cx, "glTexCoord3dv", v) }) else { return }; cx.tex_coord(v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord3f(s: f32, t: f32, r: f32) {
    enter("glTexCoord3f", |cx| cx.tex_coord(s, t, r, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord3fv(v: *const f32) {
    enter("glTexCoord3fv", |cx| { let Some(v) = (unsafe { read::<f32, 3>(cx, "glTexCoord3fv", v) }) else { return }; cx.tex_coord(v[0], v[1], v[2], 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord3i(s: i32, t: i32, r: i32) {
    enter("glTexCoord3i", |cx| cx.tex_coord(s as f32, t as f32, r as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord3iv(v: *const i32) {
    enter("glTexCoord3iv", |cx| { let Some(v) = (unsafe { read::<i32, 3>(cx, "glTexCoord3iv", v) }) else { return }; cx.tex_coord(v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord3s(s: i16, t: i16, r: i16) {
    enter("glTexCoord3s", |cx| cx.tex_coord(s as f32, t as f32, r as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord3sv(v: *const i16) {
    enter("glTexCoord3sv", |cx| { let Some(v) = (unsafe { read::<i16, 3>(cx, "glTexCoord3sv", v) }) else { return }; cx.tex_coord(v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord4d(s: f64, t: f64, r: f64, q: f64) {
    enter("glTexCoord4d", |cx| cx.tex_coord(s as f32, t as f32, r as f32, q as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord4dv(v: *const f64) {
    enter("glTexCoord4dv", |cx| { let Some(v) = (unsafe { read::<f64, 4>(cx, "glTexCoord4dv", v) }) else { return }; cx.tex_coord(v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord4f(s: f32, t: f32, r: f32, q: f32) {
    enter("glTexCoord4f", |cx| cx.tex_coord(s, t, r, q))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord4fv(v: *const f32) {
    enter("glTexCoord4fv", |cx| { let Some(v) = (unsafe { read::<f32, 4>(cx, "glTexCoord4fv", v) }) else { return }; cx.tex_coord(v[0], v[1], v[2], v[3]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord4i(s: i32, t: i32, r: i32, q: i32) {
    enter("glTexCoord4i", |cx| cx.tex_coord(s as f32, t as f32, r as f32, q as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord4iv(v: *const i32) {
    enter("glTexCoord4iv", |cx| { let Some(v) = (unsafe { read::<i32, 4>(cx, "glTexCoord4iv", v) }) else { return }; cx.tex_coord(v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord4s(s: i16, t: i16, r: i16, q: i16) {
    enter("glTexCoord4s", |cx| cx.tex_coord(s as f32, t as f32, r as f32, q as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoord4sv(v: *const i16) {
    enter("glTexCoord4sv", |cx| { let Some(v) = (unsafe { read::<i16, 4>(cx, "glTexCoord4sv", v) }) else { return }; cx.tex_coord(v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoordPointer(size: i32, type_: u32, stride: i32, pointer: *const c_void) {
    enter("glTexCoordPointer", |cx| unsafe { commands::arrays::glTexCoordPointer(cx, size, type_, stride, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexCoordPointerEXT(size: i32, type_: u32, stride: i32, count: i32, pointer: *const c_void) {
    enter("glTexCoordPointerEXT", |cx| unsafe { commands::arrays::glTexCoordPointerEXT(cx, size, type_, stride, count, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexEnvf(target: u32, pname: u32, param: f32) {
    enter("glTexEnvf", |cx| unsafe { commands::parameters::glTexEnvf(cx, target, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexEnvfv(target: u32, pname: u32, params: *const f32) {
    enter("glTexEnvfv", |cx| unsafe { commands::parameters::glTexEnvfv(cx, target, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexEnvi(target: u32, pname: u32, param: i32) {
    enter("glTexEnvi", |cx| unsafe { commands::parameters::glTexEnvi(cx, target, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexEnviv(target: u32, pname: u32, params: *const i32) {
    enter("glTexEnviv", |cx| unsafe { commands::parameters::glTexEnviv(cx, target, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexGend(coord: u32, pname: u32, param: f64) {
    enter("glTexGend", |cx| unsafe { commands::parameters::glTexGend(cx, coord, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexGendv(coord: u32, pname: u32, params: *const f64) {
    enter("glTexGendv", |cx| unsafe { commands::parameters::glTexGendv(cx, coord, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexGenf(coord: u32, pname: u32, param: f32) {
    enter("glTexGenf", |cx| unsafe { commands::parameters::glTexGenf(cx, coord, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexGenfv(coord: u32, pname: u32, params: *const f32) {
    enter("glTexGenfv", |cx| unsafe { commands::parameters::glTexGenfv(cx, coord, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexGeni(coord: u32, pname: u32, param: i32) {
    enter("glTexGeni", |cx| unsafe { commands::parameters::glTexGeni(cx, coord, pname, param) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexGeniv(coord: u32, pname: u32, params: *const i32) {
    enter("glTexGeniv", |cx| unsafe { commands::parameters::glTexGeniv(cx, coord, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexImage1D(target: u32, level: i32, internalformat: i32, width: i32, border: i32, format: u32, type_: u32, pixels: *const c_void) {
    enter("glTexImage1D", |cx| unsafe { commands::textures::glTexImage1D(cx, target, level, internalformat, width, border, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexImage2D(target: u32, level: i32, internalformat: i32, width: i32, height: i32, border: i32, format: u32, type_: u32, pixels: *const c_void) {
    enter("glTexImage2D", |cx| unsafe { commands::textures::glTexImage2D(cx, target, level, internalformat, width, height, border, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexImage3D(target: u32, level: i32, internalformat: i32, width: i32, height: i32, depth: i32, border: i32, format: u32, type_: u32, pixels: *const c_void) {
    enter("glTexImage3D", |cx| unsafe { commands::textures::glTexImage3D(cx, target, level, internalformat, width, height, depth, border, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexImage3DEXT(target: u32, level: i32, internalformat: u32, width: i32, height: i32, depth: i32, border: i32, format: u32, type_: u32, pixels: *const c_void) {
    enter("glTexImage3DEXT", |cx| unsafe { commands::textures::glTexImage3DEXT(cx, target, level, internalformat, width, height, depth, border, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexParameterf(target: u32, pname: u32, param: f32) {
    enter("glTexParameterf", |cx| cx.tex_parameterf(target, pname, param))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexParameterfv(target: u32, pname: u32, params: *const f32) {
    enter("glTexParameterfv", |cx| unsafe { commands::textures::glTexParameterfv(cx, target, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexParameteri(target: u32, pname: u32, param: i32) {
    enter("glTexParameteri", |cx| cx.tex_parameteri(target, pname, param))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexParameteriv(target: u32, pname: u32, params: *const i32) {
    enter("glTexParameteriv", |cx| unsafe { commands::textures::glTexParameteriv(cx, target, pname, params) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexSubImage1D(target: u32, level: i32, xoffset: i32, width: i32, format: u32, type_: u32, pixels: *const c_void) {
    enter("glTexSubImage1D", |cx| unsafe { commands::textures::glTexSubImage1D(cx, target, level, xoffset, width, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexSubImage1DEXT(target: u32, level: i32, xoffset: i32, width: i32, format: u32, type_: u32, pixels: *const c_void) {
    enter("glTexSubImage1DEXT", |cx| unsafe { commands::textures::glTexSubImage1D(cx, target, level, xoffset, width, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexSubImage2D(target: u32, level: i32, xoffset: i32, yoffset: i32, width: i32, height: i32, format: u32, type_: u32, pixels: *const c_void) {
    enter("glTexSubImage2D", |cx| unsafe { commands::textures::glTexSubImage2D(cx, target, level, xoffset, yoffset, width, height, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexSubImage2DEXT(target: u32, level: i32, xoffset: i32, yoffset: i32, width: i32, height: i32, format: u32, type_: u32, pixels: *const c_void) {
    enter("glTexSubImage2DEXT", |cx| unsafe { commands::textures::glTexSubImage2D(cx, target, level, xoffset, yoffset, width, height, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexSubImage3D(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: u32, type_: u32, pixels: *const c_void) {
    enter("glTexSubImage3D", |cx| unsafe { commands::textures::glTexSubImage3D(cx, target, level, xoffset, yoffset, zoffset, width, height, depth, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTexSubImage3DEXT(target: u32, level: i32, xoffset: i32, yoffset: i32, zoffset: i32, width: i32, height: i32, depth: i32, format: u32, type_: u32, pixels: *const c_void) {
    enter("glTexSubImage3DEXT", |cx| unsafe { commands::textures::glTexSubImage3D(cx, target, level, xoffset, yoffset, zoffset, width, height, depth, format, type_, pixels) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTranslated(x: f64, y: f64, z: f64) {
    enter("glTranslated", |cx| cx.translate(x as f32, y as f32, z as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glTranslatef(x: f32, y: f32, z: f32) {
    enter("glTranslatef", |cx| cx.translate(x, y, z))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform1f(location: i32, v0: f32) {
    enter("glUniform1f", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform1f", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform1fARB(location: i32, v0: f32) {
    enter("glUniform1fARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform1fARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform1fv(location: i32, count: i32, value: *const f32) {
    enter("glUniform1fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform1fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform1fvARB(location: i32, count: i32, value: *const f32) {
    enter("glUniform1fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform1fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform1i(location: i32, v0: i32) {
    enter("glUniform1i", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform1i", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform1iARB(location: i32, v0: i32) {
    enter("glUniform1iARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform1iARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform1iv(location: i32, count: i32, value: *const i32) {
    enter("glUniform1iv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform1iv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform1ivARB(location: i32, count: i32, value: *const i32) {
    enter("glUniform1ivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform1ivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform2f(location: i32, v0: f32, v1: f32) {
    enter("glUniform2f", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform2f", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform2fARB(location: i32, v0: f32, v1: f32) {
    enter("glUniform2fARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform2fARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform2fv(location: i32, count: i32, value: *const f32) {
    enter("glUniform2fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform2fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform2fvARB(location: i32, count: i32, value: *const f32) {
    enter("glUniform2fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform2fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform2i(location: i32, v0: i32, v1: i32) {
    enter("glUniform2i", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform2i", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform2iARB(location: i32, v0: i32, v1: i32) {
    enter("glUniform2iARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform2iARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform2iv(location: i32, count: i32, value: *const i32) {
    enter("glUniform2iv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform2iv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform2ivARB(location: i32, count: i32, value: *const i32) {
    enter("glUniform2ivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform2ivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform3f(location: i32, v0: f32, v1: f32, v2: f32) {
    enter("glUniform3f", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform3f", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform3fARB(location: i32, v0: f32, v1: f32, v2: f32) {
    enter("glUniform3fARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform3fARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform3fv(location: i32, count: i32, value: *const f32) {
    enter("glUniform3fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform3fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform3fvARB(location: i32, count: i32, value: *const f32) {
    enter("glUniform3fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform3fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform3i(location: i32, v0: i32, v1: i32, v2: i32) {
    enter("glUniform3i", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform3i", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform3iARB(location: i32, v0: i32, v1: i32, v2: i32) {
    enter("glUniform3iARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform3iARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform3iv(location: i32, count: i32, value: *const i32) {
    enter("glUniform3iv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform3iv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform3ivARB(location: i32, count: i32, value: *const i32) {
    enter("glUniform3ivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform3ivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform4f(location: i32, v0: f32, v1: f32, v2: f32, v3: f32) {
    enter("glUniform4f", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform4f", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform4fARB(location: i32, v0: f32, v1: f32, v2: f32, v3: f32) {
    enter("glUniform4fARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform4fARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform4fv(location: i32, count: i32, value: *const f32) {
    enter("glUniform4fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform4fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform4fvARB(location: i32, count: i32, value: *const f32) {
    enter("glUniform4fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform4fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform4i(location: i32, v0: i32, v1: i32, v2: i32, v3: i32) {
    enter("glUniform4i", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform4i", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform4iARB(location: i32, v0: i32, v1: i32, v2: i32, v3: i32) {
    enter("glUniform4iARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform4iARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform4iv(location: i32, count: i32, value: *const i32) {
    enter("glUniform4iv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform4iv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniform4ivARB(location: i32, count: i32, value: *const i32) {
    enter("glUniform4ivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniform4ivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniformMatrix2fv(location: i32, count: i32, transpose: u8, value: *const f32) {
    enter("glUniformMatrix2fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniformMatrix2fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniformMatrix2fvARB(location: i32, count: i32, transpose: u8, value: *const f32) {
    enter("glUniformMatrix2fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniformMatrix2fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniformMatrix2x3fv(location: i32, count: i32, transpose: u8, value: *const f32) {
    enter("glUniformMatrix2x3fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniformMatrix2x3fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniformMatrix2x4fv(location: i32, count: i32, transpose: u8, value: *const f32) {
    enter("glUniformMatrix2x4fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniformMatrix2x4fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniformMatrix3fv(location: i32, count: i32, transpose: u8, value: *const f32) {
    enter("glUniformMatrix3fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniformMatrix3fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniformMatrix3fvARB(location: i32, count: i32, transpose: u8, value: *const f32) {
    enter("glUniformMatrix3fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniformMatrix3fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniformMatrix3x2fv(location: i32, count: i32, transpose: u8, value: *const f32) {
    enter("glUniformMatrix3x2fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniformMatrix3x2fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniformMatrix3x4fv(location: i32, count: i32, transpose: u8, value: *const f32) {
    enter("glUniformMatrix3x4fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniformMatrix3x4fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniformMatrix4fv(location: i32, count: i32, transpose: u8, value: *const f32) {
    enter("glUniformMatrix4fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniformMatrix4fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniformMatrix4fvARB(location: i32, count: i32, transpose: u8, value: *const f32) {
    enter("glUniformMatrix4fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniformMatrix4fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniformMatrix4x2fv(location: i32, count: i32, transpose: u8, value: *const f32) {
    enter("glUniformMatrix4x2fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniformMatrix4x2fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUniformMatrix4x3fv(location: i32, count: i32, transpose: u8, value: *const f32) {
    enter("glUniformMatrix4x3fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUniformMatrix4x3fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUnlockArraysEXT() {
    enter("glUnlockArraysEXT", |cx| cx.unlock_arrays_ext())
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUnmapBuffer(target: u32) -> u8 {
    enter("glUnmapBuffer", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUnmapBuffer", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUnmapBufferARB(target: u32) -> u8 {
    enter("glUnmapBufferARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUnmapBufferARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUseProgram(program: u32) {
    enter("glUseProgram", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUseProgram", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glUseProgramObjectARB(programObj: u32) {
    enter("glUseProgramObjectARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glUseProgramObjectARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glValidateProgram(program: u32) {
    enter("glValidateProgram", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glValidateProgram", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glValidateProgramARB(programObj: u32) {
    enter("glValidateProgramARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glValidateProgramARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex2d(x: f64, y: f64) {
    enter("glVertex2d", |cx| cx.vertex(x as f32, y as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex2dv(v: *const f64) {
    enter("glVertex2dv", |cx| { let Some(v) = (unsafe { read::<f64, 2>(cx, "glVertex2dv", v) }) else { return }; cx.vertex(v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex2f(x: f32, y: f32) {
    enter("glVertex2f", |cx| cx.vertex(x, y, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex2fv(v: *const f32) {
    enter("glVertex2fv", |cx| { let Some(v) = (unsafe { read::<f32, 2>(cx, "glVertex2fv", v) }) else { return }; cx.vertex(v[0], v[1], 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex2i(x: i32, y: i32) {
    enter("glVertex2i", |cx| cx.vertex(x as f32, y as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex2iv(v: *const i32) {
    enter("glVertex2iv", |cx| { let Some(v) = (unsafe { read::<i32, 2>(cx, "glVertex2iv", v) }) else { return }; cx.vertex(v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex2s(x: i16, y: i16) {
    enter("glVertex2s", |cx| cx.vertex(x as f32, y as f32, 0.0, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex2sv(v: *const i16) {
    enter("glVertex2sv", |cx| { let Some(v) = (unsafe { read::<i16, 2>(cx, "glVertex2sv", v) }) else { return }; cx.vertex(v[0] as f32, v[1] as f32, 0.0, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex3d(x: f64, y: f64, z: f64) {
    enter("glVertex3d", |cx| cx.vertex(x as f32, y as f32, z as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex3dv(v: *const f64) {
    enter("glVertex3dv", |cx| { let Some(v) = (unsafe { read::<f64, 3>(cx, "glVertex3dv", v) }) else { return }; cx.vertex(v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex3f(x: f32, y: f32, z: f32) {
    enter("glVertex3f", |cx| cx.vertex(x, y, z, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex3fv(v: *const f32) {
    enter("glVertex3fv", |cx| { let Some(v) = (unsafe { read::<f32, 3>(cx, "glVertex3fv", v) }) else { return }; cx.vertex(v[0], v[1], v[2], 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex3i(x: i32, y: i32, z: i32) {
    enter("glVertex3i", |cx| cx.vertex(x as f32, y as f32, z as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex3iv(v: *const i32) {
    enter("glVertex3iv", |cx| { let Some(v) = (unsafe { read::<i32, 3>(cx, "glVertex3iv", v) }) else { return }; cx.vertex(v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex3s(x: i16, y: i16, z: i16) {
    enter("glVertex3s", |cx| cx.vertex(x as f32, y as f32, z as f32, 1.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex3sv(v: *const i16) {
    enter("glVertex3sv", |cx| { let Some(v) = (unsafe { read::<i16, 3>(cx, "glVertex3sv", v) }) else { return }; cx.vertex(v[0] as f32, v[1] as f32, v[2] as f32, 1.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex4d(x: f64, y: f64, z: f64, w: f64) {
    enter("glVertex4d", |cx| cx.vertex(x as f32, y as f32, z as f32, w as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex4dv(v: *const f64) {
    enter("glVertex4dv", |cx| { let Some(v) = (unsafe { read::<f64, 4>(cx, "glVertex4dv", v) }) else { return }; cx.vertex(v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex4f(x: f32, y: f32, z: f32, w: f32) {
    enter("glVertex4f", |cx| cx.vertex(x, y, z, w))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex4fv(v: *const f32) {
    enter("glVertex4fv", |cx| { let Some(v) = (unsafe { read::<f32, 4>(cx, "glVertex4fv", v) }) else { return }; cx.vertex(v[0], v[1], v[2], v[3]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex4i(x: i32, y: i32, z: i32, w: i32) {
    enter("glVertex4i", |cx| cx.vertex(x as f32, y as f32, z as f32, w as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex4iv(v: *const i32) {
    enter("glVertex4iv", |cx| { let Some(v) = (unsafe { read::<i32, 4>(cx, "glVertex4iv", v) }) else { return }; cx.vertex(v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex4s(x: i16, y: i16, z: i16, w: i16) {
    enter("glVertex4s", |cx| cx.vertex(x as f32, y as f32, z as f32, w as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertex4sv(v: *const i16) {
    enter("glVertex4sv", |cx| { let Some(v) = (unsafe { read::<i16, 4>(cx, "glVertex4sv", v) }) else { return }; cx.vertex(v[0] as f32, v[1] as f32, v[2] as f32, v[3] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib1d(index: u32, x: f64) {
    enter("glVertexAttrib1d", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib1d", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib1dARB(index: u32, x: f64) {
    enter("glVertexAttrib1dARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib1dARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib1dv(index: u32, v: *const f64) {
    enter("glVertexAttrib1dv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib1dv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib1dvARB(index: u32, v: *const f64) {
    enter("glVertexAttrib1dvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib1dvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib1f(index: u32, x: f32) {
    enter("glVertexAttrib1f", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib1f", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib1fARB(index: u32, x: f32) {
    enter("glVertexAttrib1fARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib1fARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib1fv(index: u32, v: *const f32) {
    enter("glVertexAttrib1fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib1fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib1fvARB(index: u32, v: *const f32) {
    enter("glVertexAttrib1fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib1fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib1s(index: u32, x: i16) {
    enter("glVertexAttrib1s", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib1s", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib1sARB(index: u32, x: i16) {
    enter("glVertexAttrib1sARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib1sARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib1sv(index: u32, v: *const i16) {
    enter("glVertexAttrib1sv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib1sv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib1svARB(index: u32, v: *const i16) {
    enter("glVertexAttrib1svARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib1svARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib2d(index: u32, x: f64, y: f64) {
    enter("glVertexAttrib2d", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib2d", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib2dARB(index: u32, x: f64, y: f64) {
    enter("glVertexAttrib2dARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib2dARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib2dv(index: u32, v: *const f64) {
    enter("glVertexAttrib2dv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib2dv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib2dvARB(index: u32, v: *const f64) {
    enter("glVertexAttrib2dvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib2dvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib2f(index: u32, x: f32, y: f32) {
    enter("glVertexAttrib2f", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib2f", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib2fARB(index: u32, x: f32, y: f32) {
    enter("glVertexAttrib2fARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib2fARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib2fv(index: u32, v: *const f32) {
    enter("glVertexAttrib2fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib2fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib2fvARB(index: u32, v: *const f32) {
    enter("glVertexAttrib2fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib2fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib2s(index: u32, x: i16, y: i16) {
    enter("glVertexAttrib2s", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib2s", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib2sARB(index: u32, x: i16, y: i16) {
    enter("glVertexAttrib2sARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib2sARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib2sv(index: u32, v: *const i16) {
    enter("glVertexAttrib2sv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib2sv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib2svARB(index: u32, v: *const i16) {
    enter("glVertexAttrib2svARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib2svARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib3d(index: u32, x: f64, y: f64, z: f64) {
    enter("glVertexAttrib3d", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib3d", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib3dARB(index: u32, x: f64, y: f64, z: f64) {
    enter("glVertexAttrib3dARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib3dARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib3dv(index: u32, v: *const f64) {
    enter("glVertexAttrib3dv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib3dv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib3dvARB(index: u32, v: *const f64) {
    enter("glVertexAttrib3dvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib3dvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib3f(index: u32, x: f32, y: f32, z: f32) {
    enter("glVertexAttrib3f", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib3f", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib3fARB(index: u32, x: f32, y: f32, z: f32) {
    enter("glVertexAttrib3fARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib3fARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib3fv(index: u32, v: *const f32) {
    enter("glVertexAttrib3fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib3fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib3fvARB(index: u32, v: *const f32) {
    enter("glVertexAttrib3fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib3fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib3s(index: u32, x: i16, y: i16, z: i16) {
    enter("glVertexAttrib3s", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib3s", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib3sARB(index: u32, x: i16, y: i16, z: i16) {
    enter("glVertexAttrib3sARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib3sARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib3sv(index: u32, v: *const i16) {
    enter("glVertexAttrib3sv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib3sv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib3svARB(index: u32, v: *const i16) {
    enter("glVertexAttrib3svARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib3svARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4Nbv(index: u32, v: *const i8) {
    enter("glVertexAttrib4Nbv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4Nbv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4NbvARB(index: u32, v: *const i8) {
    enter("glVertexAttrib4NbvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4NbvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4Niv(index: u32, v: *const i32) {
    enter("glVertexAttrib4Niv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4Niv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4NivARB(index: u32, v: *const i32) {
    enter("glVertexAttrib4NivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4NivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4Nsv(index: u32, v: *const i16) {
    enter("glVertexAttrib4Nsv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4Nsv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4NsvARB(index: u32, v: *const i16) {
    enter("glVertexAttrib4NsvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4NsvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4Nub(index: u32, x: u8, y: u8, z: u8, w: u8) {
    enter("glVertexAttrib4Nub", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4Nub", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4NubARB(index: u32, x: u8, y: u8, z: u8, w: u8) {
    enter("glVertexAttrib4NubARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4NubARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4Nubv(index: u32, v: *const u8) {
    enter("glVertexAttrib4Nubv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4Nubv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4NubvARB(index: u32, v: *const u8) {
    enter("glVertexAttrib4NubvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4NubvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4Nuiv(index: u32, v: *const u32) {
    enter("glVertexAttrib4Nuiv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4Nuiv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4NuivARB(index: u32, v: *const u32) {
    enter("glVertexAttrib4NuivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4NuivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4Nusv(index: u32, v: *const u16) {
    enter("glVertexAttrib4Nusv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4Nusv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4NusvARB(index: u32, v: *const u16) {
    enter("glVertexAttrib4NusvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4NusvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4bv(index: u32, v: *const i8) {
    enter("glVertexAttrib4bv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4bv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4bvARB(index: u32, v: *const i8) {
    enter("glVertexAttrib4bvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4bvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4d(index: u32, x: f64, y: f64, z: f64, w: f64) {
    enter("glVertexAttrib4d", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4d", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4dARB(index: u32, x: f64, y: f64, z: f64, w: f64) {
    enter("glVertexAttrib4dARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4dARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4dv(index: u32, v: *const f64) {
    enter("glVertexAttrib4dv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4dv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4dvARB(index: u32, v: *const f64) {
    enter("glVertexAttrib4dvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4dvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4f(index: u32, x: f32, y: f32, z: f32, w: f32) {
    enter("glVertexAttrib4f", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4f", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4fARB(index: u32, x: f32, y: f32, z: f32, w: f32) {
    enter("glVertexAttrib4fARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4fARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4fv(index: u32, v: *const f32) {
    enter("glVertexAttrib4fv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4fv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4fvARB(index: u32, v: *const f32) {
    enter("glVertexAttrib4fvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4fvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4iv(index: u32, v: *const i32) {
    enter("glVertexAttrib4iv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4iv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4ivARB(index: u32, v: *const i32) {
    enter("glVertexAttrib4ivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4ivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4s(index: u32, x: i16, y: i16, z: i16, w: i16) {
    enter("glVertexAttrib4s", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4s", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4sARB(index: u32, x: i16, y: i16, z: i16, w: i16) {
    enter("glVertexAttrib4sARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4sARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4sv(index: u32, v: *const i16) {
    enter("glVertexAttrib4sv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4sv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4svARB(index: u32, v: *const i16) {
    enter("glVertexAttrib4svARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4svARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4ubv(index: u32, v: *const u8) {
    enter("glVertexAttrib4ubv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4ubv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4ubvARB(index: u32, v: *const u8) {
    enter("glVertexAttrib4ubvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4ubvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4uiv(index: u32, v: *const u32) {
    enter("glVertexAttrib4uiv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4uiv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4uivARB(index: u32, v: *const u32) {
    enter("glVertexAttrib4uivARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4uivARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4usv(index: u32, v: *const u16) {
    enter("glVertexAttrib4usv", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4usv", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttrib4usvARB(index: u32, v: *const u16) {
    enter("glVertexAttrib4usvARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttrib4usvARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttribPointer(index: u32, size: i32, type_: u32, normalized: u8, stride: i32, pointer: *const c_void) {
    enter("glVertexAttribPointer", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttribPointer", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexAttribPointerARB(index: u32, size: i32, type_: u32, normalized: u8, stride: i32, pointer: *const c_void) {
    enter("glVertexAttribPointerARB", |cx| { static SAID: AtomicBool = AtomicBool::new(false); not_built(cx, "glVertexAttribPointerARB", &SAID) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexPointer(size: i32, type_: u32, stride: i32, pointer: *const c_void) {
    enter("glVertexPointer", |cx| unsafe { commands::arrays::glVertexPointer(cx, size, type_, stride, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glVertexPointerEXT(size: i32, type_: u32, stride: i32, count: i32, pointer: *const c_void) {
    enter("glVertexPointerEXT", |cx| unsafe { commands::arrays::glVertexPointerEXT(cx, size, type_, stride, count, pointer) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glViewport(x: i32, y: i32, width: i32, height: i32) {
    enter("glViewport", |cx| cx.viewport(x, y, width, height))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2d(x: f64, y: f64) {
    enter("glWindowPos2d", |cx| cx.window_pos(x as f32, y as f32, 0.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2dARB(x: f64, y: f64) {
    enter("glWindowPos2dARB", |cx| cx.window_pos(x as f32, y as f32, 0.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2dMESA(x: f64, y: f64) {
    enter("glWindowPos2dMESA", |cx| cx.window_pos(x as f32, y as f32, 0.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2dv(v: *const f64) {
    enter("glWindowPos2dv", |cx| { let Some(v) = (unsafe { read::<f64, 2>(cx, "glWindowPos2dv", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, 0.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2dvARB(v: *const f64) {
    enter("glWindowPos2dvARB", |cx| { let Some(v) = (unsafe { read::<f64, 2>(cx, "glWindowPos2dvARB", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, 0.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2dvMESA(v: *const f64) {
    enter("glWindowPos2dvMESA", |cx| { let Some(v) = (unsafe { read::<f64, 2>(cx, "glWindowPos2dvMESA", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, 0.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2f(x: f32, y: f32) {
    enter("glWindowPos2f", |cx| cx.window_pos(x, y, 0.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2fARB(x: f32, y: f32) {
    enter("glWindowPos2fARB", |cx| cx.window_pos(x, y, 0.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2fMESA(x: f32, y: f32) {
    enter("glWindowPos2fMESA", |cx| cx.window_pos(x, y, 0.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2fv(v: *const f32) {
    enter("glWindowPos2fv", |cx| { let Some(v) = (unsafe { read::<f32, 2>(cx, "glWindowPos2fv", v) }) else { return }; cx.window_pos(v[0], v[1], 0.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2fvARB(v: *const f32) {
    enter("glWindowPos2fvARB", |cx| { let Some(v) = (unsafe { read::<f32, 2>(cx, "glWindowPos2fvARB", v) }) else { return }; cx.window_pos(v[0], v[1], 0.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2fvMESA(v: *const f32) {
    enter("glWindowPos2fvMESA", |cx| { let Some(v) = (unsafe { read::<f32, 2>(cx, "glWindowPos2fvMESA", v) }) else { return }; cx.window_pos(v[0], v[1], 0.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2i(x: i32, y: i32) {
    enter("glWindowPos2i", |cx| cx.window_pos(x as f32, y as f32, 0.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2iARB(x: i32, y: i32) {
    enter("glWindowPos2iARB", |cx| cx.window_pos(x as f32, y as f32, 0.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2iMESA(x: i32, y: i32) {
    enter("glWindowPos2iMESA", |cx| cx.window_pos(x as f32, y as f32, 0.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2iv(v: *const i32) {
    enter("glWindowPos2iv", |cx| { let Some(v) = (unsafe { read::<i32, 2>(cx, "glWindowPos2iv", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, 0.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2ivARB(v: *const i32) {
    enter("glWindowPos2ivARB", |cx| { let Some(v) = (unsafe { read::<i32, 2>(cx, "glWindowPos2ivARB", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, 0.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2ivMESA(v: *const i32) {
    enter("glWindowPos2ivMESA", |cx| { let Some(v) = (unsafe { read::<i32, 2>(cx, "glWindowPos2ivMESA", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, 0.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2s(x: i16, y: i16) {
    enter("glWindowPos2s", |cx| cx.window_pos(x as f32, y as f32, 0.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2sARB(x: i16, y: i16) {
    enter("glWindowPos2sARB", |cx| cx.window_pos(x as f32, y as f32, 0.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2sMESA(x: i16, y: i16) {
    enter("glWindowPos2sMESA", |cx| cx.window_pos(x as f32, y as f32, 0.0))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2sv(v: *const i16) {
    enter("glWindowPos2sv", |cx| { let Some(v) = (unsafe { read::<i16, 2>(cx, "glWindowPos2sv", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, 0.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2svARB(v: *const i16) {
    enter("glWindowPos2svARB", |cx| { let Some(v) = (unsafe { read::<i16, 2>(cx, "glWindowPos2svARB", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, 0.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos2svMESA(v: *const i16) {
    enter("glWindowPos2svMESA", |cx| { let Some(v) = (unsafe { read::<i16, 2>(cx, "glWindowPos2svMESA", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, 0.0) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3d(x: f64, y: f64, z: f64) {
    enter("glWindowPos3d", |cx| cx.window_pos(x as f32, y as f32, z as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3dARB(x: f64, y: f64, z: f64) {
    enter("glWindowPos3dARB", |cx| cx.window_pos(x as f32, y as f32, z as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3dMESA(x: f64, y: f64, z: f64) {
    enter("glWindowPos3dMESA", |cx| cx.window_pos(x as f32, y as f32, z as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3dv(v: *const f64) {
    enter("glWindowPos3dv", |cx| { let Some(v) = (unsafe { read::<f64, 3>(cx, "glWindowPos3dv", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, v[2] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3dvARB(v: *const f64) {
    enter("glWindowPos3dvARB", |cx| { let Some(v) = (unsafe { read::<f64, 3>(cx, "glWindowPos3dvARB", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, v[2] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3dvMESA(v: *const f64) {
    enter("glWindowPos3dvMESA", |cx| { let Some(v) = (unsafe { read::<f64, 3>(cx, "glWindowPos3dvMESA", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, v[2] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3f(x: f32, y: f32, z: f32) {
    enter("glWindowPos3f", |cx| cx.window_pos(x, y, z))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3fARB(x: f32, y: f32, z: f32) {
    enter("glWindowPos3fARB", |cx| cx.window_pos(x, y, z))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3fMESA(x: f32, y: f32, z: f32) {
    enter("glWindowPos3fMESA", |cx| cx.window_pos(x, y, z))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3fv(v: *const f32) {
    enter("glWindowPos3fv", |cx| { let Some(v) = (unsafe { read::<f32, 3>(cx, "glWindowPos3fv", v) }) else { return }; cx.window_pos(v[0], v[1], v[2]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3fvARB(v: *const f32) {
    enter("glWindowPos3fvARB", |cx| { let Some(v) = (unsafe { read::<f32, 3>(cx, "glWindowPos3fvARB", v) }) else { return }; cx.window_pos(v[0], v[1], v[2]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3fvMESA(v: *const f32) {
    enter("glWindowPos3fvMESA", |cx| { let Some(v) = (unsafe { read::<f32, 3>(cx, "glWindowPos3fvMESA", v) }) else { return }; cx.window_pos(v[0], v[1], v[2]) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3i(x: i32, y: i32, z: i32) {
    enter("glWindowPos3i", |cx| cx.window_pos(x as f32, y as f32, z as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3iARB(x: i32, y: i32, z: i32) {
    enter("glWindowPos3iARB", |cx| cx.window_pos(x as f32, y as f32, z as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3iMESA(x: i32, y: i32, z: i32) {
    enter("glWindowPos3iMESA", |cx| cx.window_pos(x as f32, y as f32, z as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3iv(v: *const i32) {
    enter("glWindowPos3iv", |cx| { let Some(v) = (unsafe { read::<i32, 3>(cx, "glWindowPos3iv", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, v[2] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3ivARB(v: *const i32) {
    enter("glWindowPos3ivARB", |cx| { let Some(v) = (unsafe { read::<i32, 3>(cx, "glWindowPos3ivARB", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, v[2] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3ivMESA(v: *const i32) {
    enter("glWindowPos3ivMESA", |cx| { let Some(v) = (unsafe { read::<i32, 3>(cx, "glWindowPos3ivMESA", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, v[2] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3s(x: i16, y: i16, z: i16) {
    enter("glWindowPos3s", |cx| cx.window_pos(x as f32, y as f32, z as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3sARB(x: i16, y: i16, z: i16) {
    enter("glWindowPos3sARB", |cx| cx.window_pos(x as f32, y as f32, z as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3sMESA(x: i16, y: i16, z: i16) {
    enter("glWindowPos3sMESA", |cx| cx.window_pos(x as f32, y as f32, z as f32))
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3sv(v: *const i16) {
    enter("glWindowPos3sv", |cx| { let Some(v) = (unsafe { read::<i16, 3>(cx, "glWindowPos3sv", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, v[2] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3svARB(v: *const i16) {
    enter("glWindowPos3svARB", |cx| { let Some(v) = (unsafe { read::<i16, 3>(cx, "glWindowPos3svARB", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, v[2] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos3svMESA(v: *const i16) {
    enter("glWindowPos3svMESA", |cx| { let Some(v) = (unsafe { read::<i16, 3>(cx, "glWindowPos3svMESA", v) }) else { return }; cx.window_pos(v[0] as f32, v[1] as f32, v[2] as f32) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos4dMESA(x: f64, y: f64, z: f64, w: f64) {
    enter("glWindowPos4dMESA", |cx| unsafe { commands::extensions::glWindowPos4dMESA(cx, x, y, z, w) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos4dvMESA(v: *const f64) {
    enter("glWindowPos4dvMESA", |cx| unsafe { commands::extensions::glWindowPos4dvMESA(cx, v) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos4fMESA(x: f32, y: f32, z: f32, w: f32) {
    enter("glWindowPos4fMESA", |cx| unsafe { commands::extensions::glWindowPos4fMESA(cx, x, y, z, w) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos4fvMESA(v: *const f32) {
    enter("glWindowPos4fvMESA", |cx| unsafe { commands::extensions::glWindowPos4fvMESA(cx, v) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos4iMESA(x: i32, y: i32, z: i32, w: i32) {
    enter("glWindowPos4iMESA", |cx| unsafe { commands::extensions::glWindowPos4iMESA(cx, x, y, z, w) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos4ivMESA(v: *const i32) {
    enter("glWindowPos4ivMESA", |cx| unsafe { commands::extensions::glWindowPos4ivMESA(cx, v) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos4sMESA(x: i16, y: i16, z: i16, w: i16) {
    enter("glWindowPos4sMESA", |cx| unsafe { commands::extensions::glWindowPos4sMESA(cx, x, y, z, w) })
}
#[unsafe(no_mangle)]
pub unsafe extern "C" fn glWindowPos4svMESA(v: *const i16) {
    enter("glWindowPos4svMESA", |cx| unsafe { commands::extensions::glWindowPos4svMESA(cx, v) })
}

/// Every command by name, sorted.
pub static COMMANDS: [Entry; 899] = [
    Entry("glAccum", glAccum as *const c_void),
    Entry("glActiveStencilFaceEXT", glActiveStencilFaceEXT as *const c_void),
    Entry("glActiveTexture", glActiveTexture as *const c_void),
    Entry("glActiveTextureARB", glActiveTextureARB as *const c_void),
    Entry("glAlphaFunc", glAlphaFunc as *const c_void),
    Entry("glAreTexturesResident", glAreTexturesResident as *const c_void),
    Entry("glAreTexturesResidentEXT", glAreTexturesResidentEXT as *const c_void),
    Entry("glArrayElement", glArrayElement as *const c_void),
    Entry("glArrayElementEXT", glArrayElementEXT as *const c_void),
    Entry("glAttachObjectARB", glAttachObjectARB as *const c_void),
    Entry("glAttachShader", glAttachShader as *const c_void),
    Entry("glBegin", glBegin as *const c_void),
    Entry("glBeginQuery", glBeginQuery as *const c_void),
    Entry("glBeginQueryARB", glBeginQueryARB as *const c_void),
    Entry("glBindAttribLocation", glBindAttribLocation as *const c_void),
    Entry("glBindAttribLocationARB", glBindAttribLocationARB as *const c_void),
    Entry("glBindBuffer", glBindBuffer as *const c_void),
    Entry("glBindBufferARB", glBindBufferARB as *const c_void),
    Entry("glBindFramebuffer", glBindFramebuffer as *const c_void),
    Entry("glBindFramebufferEXT", glBindFramebufferEXT as *const c_void),
    Entry("glBindProgramARB", glBindProgramARB as *const c_void),
    Entry("glBindRenderbuffer", glBindRenderbuffer as *const c_void),
    Entry("glBindRenderbufferEXT", glBindRenderbufferEXT as *const c_void),
    Entry("glBindTexture", glBindTexture as *const c_void),
    Entry("glBindTextureEXT", glBindTextureEXT as *const c_void),
    Entry("glBitmap", glBitmap as *const c_void),
    Entry("glBlendColor", glBlendColor as *const c_void),
    Entry("glBlendColorEXT", glBlendColorEXT as *const c_void),
    Entry("glBlendEquation", glBlendEquation as *const c_void),
    Entry("glBlendEquationEXT", glBlendEquationEXT as *const c_void),
    Entry("glBlendEquationSeparate", glBlendEquationSeparate as *const c_void),
    Entry("glBlendEquationSeparateEXT", glBlendEquationSeparateEXT as *const c_void),
    Entry("glBlendFunc", glBlendFunc as *const c_void),
    Entry("glBlendFuncSeparate", glBlendFuncSeparate as *const c_void),
    Entry("glBlendFuncSeparateEXT", glBlendFuncSeparateEXT as *const c_void),
    Entry("glBlendFuncSeparateINGR", glBlendFuncSeparateINGR as *const c_void),
    Entry("glBlitFramebuffer", glBlitFramebuffer as *const c_void),
    Entry("glBlitFramebufferEXT", glBlitFramebufferEXT as *const c_void),
    Entry("glBufferData", glBufferData as *const c_void),
    Entry("glBufferDataARB", glBufferDataARB as *const c_void),
    Entry("glBufferSubData", glBufferSubData as *const c_void),
    Entry("glBufferSubDataARB", glBufferSubDataARB as *const c_void),
    Entry("glCallList", glCallList as *const c_void),
    Entry("glCallLists", glCallLists as *const c_void),
    Entry("glCheckFramebufferStatus", glCheckFramebufferStatus as *const c_void),
    Entry("glCheckFramebufferStatusEXT", glCheckFramebufferStatusEXT as *const c_void),
    Entry("glClampColorARB", glClampColorARB as *const c_void),
    Entry("glClear", glClear as *const c_void),
    Entry("glClearAccum", glClearAccum as *const c_void),
    Entry("glClearColor", glClearColor as *const c_void),
    Entry("glClearDepth", glClearDepth as *const c_void),
    Entry("glClearIndex", glClearIndex as *const c_void),
    Entry("glClearStencil", glClearStencil as *const c_void),
    Entry("glClientActiveTexture", glClientActiveTexture as *const c_void),
    Entry("glClientActiveTextureARB", glClientActiveTextureARB as *const c_void),
    Entry("glClipPlane", glClipPlane as *const c_void),
    Entry("glColor3b", glColor3b as *const c_void),
    Entry("glColor3bv", glColor3bv as *const c_void),
    Entry("glColor3d", glColor3d as *const c_void),
    Entry("glColor3dv", glColor3dv as *const c_void),
    Entry("glColor3f", glColor3f as *const c_void),
    Entry("glColor3fv", glColor3fv as *const c_void),
    Entry("glColor3i", glColor3i as *const c_void),
    Entry("glColor3iv", glColor3iv as *const c_void),
    Entry("glColor3s", glColor3s as *const c_void),
    Entry("glColor3sv", glColor3sv as *const c_void),
    Entry("glColor3ub", glColor3ub as *const c_void),
    Entry("glColor3ubv", glColor3ubv as *const c_void),
    Entry("glColor3ui", glColor3ui as *const c_void),
    Entry("glColor3uiv", glColor3uiv as *const c_void),
    Entry("glColor3us", glColor3us as *const c_void),
    Entry("glColor3usv", glColor3usv as *const c_void),
    Entry("glColor4b", glColor4b as *const c_void),
    Entry("glColor4bv", glColor4bv as *const c_void),
    Entry("glColor4d", glColor4d as *const c_void),
    Entry("glColor4dv", glColor4dv as *const c_void),
    Entry("glColor4f", glColor4f as *const c_void),
    Entry("glColor4fv", glColor4fv as *const c_void),
    Entry("glColor4i", glColor4i as *const c_void),
    Entry("glColor4iv", glColor4iv as *const c_void),
    Entry("glColor4s", glColor4s as *const c_void),
    Entry("glColor4sv", glColor4sv as *const c_void),
    Entry("glColor4ub", glColor4ub as *const c_void),
    Entry("glColor4ubv", glColor4ubv as *const c_void),
    Entry("glColor4ui", glColor4ui as *const c_void),
    Entry("glColor4uiv", glColor4uiv as *const c_void),
    Entry("glColor4us", glColor4us as *const c_void),
    Entry("glColor4usv", glColor4usv as *const c_void),
    Entry("glColorMask", glColorMask as *const c_void),
    Entry("glColorMaterial", glColorMaterial as *const c_void),
    Entry("glColorPointer", glColorPointer as *const c_void),
    Entry("glColorPointerEXT", glColorPointerEXT as *const c_void),
    Entry("glColorSubTable", glColorSubTable as *const c_void),
    Entry("glColorTable", glColorTable as *const c_void),
    Entry("glColorTableParameterfv", glColorTableParameterfv as *const c_void),
    Entry("glColorTableParameteriv", glColorTableParameteriv as *const c_void),
    Entry("glCompileShader", glCompileShader as *const c_void),
    Entry("glCompileShaderARB", glCompileShaderARB as *const c_void),
    Entry("glCompressedTexImage1D", glCompressedTexImage1D as *const c_void),
    Entry("glCompressedTexImage1DARB", glCompressedTexImage1DARB as *const c_void),
    Entry("glCompressedTexImage2D", glCompressedTexImage2D as *const c_void),
    Entry("glCompressedTexImage2DARB", glCompressedTexImage2DARB as *const c_void),
    Entry("glCompressedTexImage3D", glCompressedTexImage3D as *const c_void),
    Entry("glCompressedTexImage3DARB", glCompressedTexImage3DARB as *const c_void),
    Entry("glCompressedTexSubImage1D", glCompressedTexSubImage1D as *const c_void),
    Entry("glCompressedTexSubImage1DARB", glCompressedTexSubImage1DARB as *const c_void),
    Entry("glCompressedTexSubImage2D", glCompressedTexSubImage2D as *const c_void),
    Entry("glCompressedTexSubImage2DARB", glCompressedTexSubImage2DARB as *const c_void),
    Entry("glCompressedTexSubImage3D", glCompressedTexSubImage3D as *const c_void),
    Entry("glCompressedTexSubImage3DARB", glCompressedTexSubImage3DARB as *const c_void),
    Entry("glConvolutionFilter1D", glConvolutionFilter1D as *const c_void),
    Entry("glConvolutionFilter2D", glConvolutionFilter2D as *const c_void),
    Entry("glConvolutionParameterf", glConvolutionParameterf as *const c_void),
    Entry("glConvolutionParameterfv", glConvolutionParameterfv as *const c_void),
    Entry("glConvolutionParameteri", glConvolutionParameteri as *const c_void),
    Entry("glConvolutionParameteriv", glConvolutionParameteriv as *const c_void),
    Entry("glCopyColorSubTable", glCopyColorSubTable as *const c_void),
    Entry("glCopyColorTable", glCopyColorTable as *const c_void),
    Entry("glCopyConvolutionFilter1D", glCopyConvolutionFilter1D as *const c_void),
    Entry("glCopyConvolutionFilter2D", glCopyConvolutionFilter2D as *const c_void),
    Entry("glCopyPixels", glCopyPixels as *const c_void),
    Entry("glCopyTexImage1D", glCopyTexImage1D as *const c_void),
    Entry("glCopyTexImage1DEXT", glCopyTexImage1DEXT as *const c_void),
    Entry("glCopyTexImage2D", glCopyTexImage2D as *const c_void),
    Entry("glCopyTexImage2DEXT", glCopyTexImage2DEXT as *const c_void),
    Entry("glCopyTexSubImage1D", glCopyTexSubImage1D as *const c_void),
    Entry("glCopyTexSubImage1DEXT", glCopyTexSubImage1DEXT as *const c_void),
    Entry("glCopyTexSubImage2D", glCopyTexSubImage2D as *const c_void),
    Entry("glCopyTexSubImage2DEXT", glCopyTexSubImage2DEXT as *const c_void),
    Entry("glCopyTexSubImage3D", glCopyTexSubImage3D as *const c_void),
    Entry("glCopyTexSubImage3DEXT", glCopyTexSubImage3DEXT as *const c_void),
    Entry("glCreateProgram", glCreateProgram as *const c_void),
    Entry("glCreateProgramObjectARB", glCreateProgramObjectARB as *const c_void),
    Entry("glCreateShader", glCreateShader as *const c_void),
    Entry("glCreateShaderObjectARB", glCreateShaderObjectARB as *const c_void),
    Entry("glCullFace", glCullFace as *const c_void),
    Entry("glDeleteBuffers", glDeleteBuffers as *const c_void),
    Entry("glDeleteBuffersARB", glDeleteBuffersARB as *const c_void),
    Entry("glDeleteFramebuffers", glDeleteFramebuffers as *const c_void),
    Entry("glDeleteFramebuffersEXT", glDeleteFramebuffersEXT as *const c_void),
    Entry("glDeleteLists", glDeleteLists as *const c_void),
    Entry("glDeleteObjectARB", glDeleteObjectARB as *const c_void),
    Entry("glDeleteProgram", glDeleteProgram as *const c_void),
    Entry("glDeleteProgramsARB", glDeleteProgramsARB as *const c_void),
    Entry("glDeleteQueries", glDeleteQueries as *const c_void),
    Entry("glDeleteQueriesARB", glDeleteQueriesARB as *const c_void),
    Entry("glDeleteRenderbuffers", glDeleteRenderbuffers as *const c_void),
    Entry("glDeleteRenderbuffersEXT", glDeleteRenderbuffersEXT as *const c_void),
    Entry("glDeleteShader", glDeleteShader as *const c_void),
    Entry("glDeleteTextures", glDeleteTextures as *const c_void),
    Entry("glDeleteTexturesEXT", glDeleteTexturesEXT as *const c_void),
    Entry("glDepthFunc", glDepthFunc as *const c_void),
    Entry("glDepthMask", glDepthMask as *const c_void),
    Entry("glDepthRange", glDepthRange as *const c_void),
    Entry("glDetachObjectARB", glDetachObjectARB as *const c_void),
    Entry("glDetachShader", glDetachShader as *const c_void),
    Entry("glDisable", glDisable as *const c_void),
    Entry("glDisableClientState", glDisableClientState as *const c_void),
    Entry("glDisableVertexAttribArray", glDisableVertexAttribArray as *const c_void),
    Entry("glDisableVertexAttribArrayARB", glDisableVertexAttribArrayARB as *const c_void),
    Entry("glDrawArrays", glDrawArrays as *const c_void),
    Entry("glDrawArraysEXT", glDrawArraysEXT as *const c_void),
    Entry("glDrawBuffer", glDrawBuffer as *const c_void),
    Entry("glDrawBuffers", glDrawBuffers as *const c_void),
    Entry("glDrawBuffersARB", glDrawBuffersARB as *const c_void),
    Entry("glDrawElements", glDrawElements as *const c_void),
    Entry("glDrawPixels", glDrawPixels as *const c_void),
    Entry("glDrawRangeElements", glDrawRangeElements as *const c_void),
    Entry("glDrawRangeElementsEXT", glDrawRangeElementsEXT as *const c_void),
    Entry("glEdgeFlag", glEdgeFlag as *const c_void),
    Entry("glEdgeFlagPointer", glEdgeFlagPointer as *const c_void),
    Entry("glEdgeFlagPointerEXT", glEdgeFlagPointerEXT as *const c_void),
    Entry("glEdgeFlagv", glEdgeFlagv as *const c_void),
    Entry("glEnable", glEnable as *const c_void),
    Entry("glEnableClientState", glEnableClientState as *const c_void),
    Entry("glEnableVertexAttribArray", glEnableVertexAttribArray as *const c_void),
    Entry("glEnableVertexAttribArrayARB", glEnableVertexAttribArrayARB as *const c_void),
    Entry("glEnd", glEnd as *const c_void),
    Entry("glEndList", glEndList as *const c_void),
    Entry("glEndQuery", glEndQuery as *const c_void),
    Entry("glEndQueryARB", glEndQueryARB as *const c_void),
    Entry("glEvalCoord1d", glEvalCoord1d as *const c_void),
    Entry("glEvalCoord1dv", glEvalCoord1dv as *const c_void),
    Entry("glEvalCoord1f", glEvalCoord1f as *const c_void),
    Entry("glEvalCoord1fv", glEvalCoord1fv as *const c_void),
    Entry("glEvalCoord2d", glEvalCoord2d as *const c_void),
    Entry("glEvalCoord2dv", glEvalCoord2dv as *const c_void),
    Entry("glEvalCoord2f", glEvalCoord2f as *const c_void),
    Entry("glEvalCoord2fv", glEvalCoord2fv as *const c_void),
    Entry("glEvalMesh1", glEvalMesh1 as *const c_void),
    Entry("glEvalMesh2", glEvalMesh2 as *const c_void),
    Entry("glEvalPoint1", glEvalPoint1 as *const c_void),
    Entry("glEvalPoint2", glEvalPoint2 as *const c_void),
    Entry("glFeedbackBuffer", glFeedbackBuffer as *const c_void),
    Entry("glFinish", glFinish as *const c_void),
    Entry("glFlush", glFlush as *const c_void),
    Entry("glFogCoordPointer", glFogCoordPointer as *const c_void),
    Entry("glFogCoordPointerEXT", glFogCoordPointerEXT as *const c_void),
    Entry("glFogCoordd", glFogCoordd as *const c_void),
    Entry("glFogCoorddEXT", glFogCoorddEXT as *const c_void),
    Entry("glFogCoorddv", glFogCoorddv as *const c_void),
    Entry("glFogCoorddvEXT", glFogCoorddvEXT as *const c_void),
    Entry("glFogCoordf", glFogCoordf as *const c_void),
    Entry("glFogCoordfEXT", glFogCoordfEXT as *const c_void),
    Entry("glFogCoordfv", glFogCoordfv as *const c_void),
    Entry("glFogCoordfvEXT", glFogCoordfvEXT as *const c_void),
    Entry("glFogf", glFogf as *const c_void),
    Entry("glFogfv", glFogfv as *const c_void),
    Entry("glFogi", glFogi as *const c_void),
    Entry("glFogiv", glFogiv as *const c_void),
    Entry("glFramebufferRenderbuffer", glFramebufferRenderbuffer as *const c_void),
    Entry("glFramebufferRenderbufferEXT", glFramebufferRenderbufferEXT as *const c_void),
    Entry("glFramebufferTexture1D", glFramebufferTexture1D as *const c_void),
    Entry("glFramebufferTexture1DEXT", glFramebufferTexture1DEXT as *const c_void),
    Entry("glFramebufferTexture2D", glFramebufferTexture2D as *const c_void),
    Entry("glFramebufferTexture2DEXT", glFramebufferTexture2DEXT as *const c_void),
    Entry("glFramebufferTexture3D", glFramebufferTexture3D as *const c_void),
    Entry("glFramebufferTexture3DEXT", glFramebufferTexture3DEXT as *const c_void),
    Entry("glFramebufferTextureLayer", glFramebufferTextureLayer as *const c_void),
    Entry("glFrontFace", glFrontFace as *const c_void),
    Entry("glFrustum", glFrustum as *const c_void),
    Entry("glGenBuffers", glGenBuffers as *const c_void),
    Entry("glGenBuffersARB", glGenBuffersARB as *const c_void),
    Entry("glGenFramebuffers", glGenFramebuffers as *const c_void),
    Entry("glGenFramebuffersEXT", glGenFramebuffersEXT as *const c_void),
    Entry("glGenLists", glGenLists as *const c_void),
    Entry("glGenProgramsARB", glGenProgramsARB as *const c_void),
    Entry("glGenQueries", glGenQueries as *const c_void),
    Entry("glGenQueriesARB", glGenQueriesARB as *const c_void),
    Entry("glGenRenderbuffers", glGenRenderbuffers as *const c_void),
    Entry("glGenRenderbuffersEXT", glGenRenderbuffersEXT as *const c_void),
    Entry("glGenTextures", glGenTextures as *const c_void),
    Entry("glGenTexturesEXT", glGenTexturesEXT as *const c_void),
    Entry("glGenerateMipmap", glGenerateMipmap as *const c_void),
    Entry("glGenerateMipmapEXT", glGenerateMipmapEXT as *const c_void),
    Entry("glGetActiveAttrib", glGetActiveAttrib as *const c_void),
    Entry("glGetActiveAttribARB", glGetActiveAttribARB as *const c_void),
    Entry("glGetActiveUniform", glGetActiveUniform as *const c_void),
    Entry("glGetActiveUniformARB", glGetActiveUniformARB as *const c_void),
    Entry("glGetAttachedObjectsARB", glGetAttachedObjectsARB as *const c_void),
    Entry("glGetAttachedShaders", glGetAttachedShaders as *const c_void),
    Entry("glGetAttribLocation", glGetAttribLocation as *const c_void),
    Entry("glGetAttribLocationARB", glGetAttribLocationARB as *const c_void),
    Entry("glGetBooleanv", glGetBooleanv as *const c_void),
    Entry("glGetBufferParameteriv", glGetBufferParameteriv as *const c_void),
    Entry("glGetBufferParameterivARB", glGetBufferParameterivARB as *const c_void),
    Entry("glGetBufferPointerv", glGetBufferPointerv as *const c_void),
    Entry("glGetBufferPointervARB", glGetBufferPointervARB as *const c_void),
    Entry("glGetBufferSubData", glGetBufferSubData as *const c_void),
    Entry("glGetBufferSubDataARB", glGetBufferSubDataARB as *const c_void),
    Entry("glGetClipPlane", glGetClipPlane as *const c_void),
    Entry("glGetColorTable", glGetColorTable as *const c_void),
    Entry("glGetColorTableParameterfv", glGetColorTableParameterfv as *const c_void),
    Entry("glGetColorTableParameteriv", glGetColorTableParameteriv as *const c_void),
    Entry("glGetCompressedTexImage", glGetCompressedTexImage as *const c_void),
    Entry("glGetCompressedTexImageARB", glGetCompressedTexImageARB as *const c_void),
    Entry("glGetConvolutionFilter", glGetConvolutionFilter as *const c_void),
    Entry("glGetConvolutionParameterfv", glGetConvolutionParameterfv as *const c_void),
    Entry("glGetConvolutionParameteriv", glGetConvolutionParameteriv as *const c_void),
    Entry("glGetDoublev", glGetDoublev as *const c_void),
    Entry("glGetError", glGetError as *const c_void),
    Entry("glGetFloatv", glGetFloatv as *const c_void),
    Entry("glGetFramebufferAttachmentParameteriv", glGetFramebufferAttachmentParameteriv as *const c_void),
    Entry("glGetFramebufferAttachmentParameterivEXT", glGetFramebufferAttachmentParameterivEXT as *const c_void),
    Entry("glGetHandleARB", glGetHandleARB as *const c_void),
    Entry("glGetHistogram", glGetHistogram as *const c_void),
    Entry("glGetHistogramParameterfv", glGetHistogramParameterfv as *const c_void),
    Entry("glGetHistogramParameteriv", glGetHistogramParameteriv as *const c_void),
    Entry("glGetInfoLogARB", glGetInfoLogARB as *const c_void),
    Entry("glGetIntegerv", glGetIntegerv as *const c_void),
    Entry("glGetLightfv", glGetLightfv as *const c_void),
    Entry("glGetLightiv", glGetLightiv as *const c_void),
    Entry("glGetMapdv", glGetMapdv as *const c_void),
    Entry("glGetMapfv", glGetMapfv as *const c_void),
    Entry("glGetMapiv", glGetMapiv as *const c_void),
    Entry("glGetMaterialfv", glGetMaterialfv as *const c_void),
    Entry("glGetMaterialiv", glGetMaterialiv as *const c_void),
    Entry("glGetMinmax", glGetMinmax as *const c_void),
    Entry("glGetMinmaxParameterfv", glGetMinmaxParameterfv as *const c_void),
    Entry("glGetMinmaxParameteriv", glGetMinmaxParameteriv as *const c_void),
    Entry("glGetObjectParameterfvARB", glGetObjectParameterfvARB as *const c_void),
    Entry("glGetObjectParameterivARB", glGetObjectParameterivARB as *const c_void),
    Entry("glGetPixelMapfv", glGetPixelMapfv as *const c_void),
    Entry("glGetPixelMapuiv", glGetPixelMapuiv as *const c_void),
    Entry("glGetPixelMapusv", glGetPixelMapusv as *const c_void),
    Entry("glGetPointerv", glGetPointerv as *const c_void),
    Entry("glGetPointervEXT", glGetPointervEXT as *const c_void),
    Entry("glGetPolygonStipple", glGetPolygonStipple as *const c_void),
    Entry("glGetProgramEnvParameterdvARB", glGetProgramEnvParameterdvARB as *const c_void),
    Entry("glGetProgramEnvParameterfvARB", glGetProgramEnvParameterfvARB as *const c_void),
    Entry("glGetProgramInfoLog", glGetProgramInfoLog as *const c_void),
    Entry("glGetProgramLocalParameterdvARB", glGetProgramLocalParameterdvARB as *const c_void),
    Entry("glGetProgramLocalParameterfvARB", glGetProgramLocalParameterfvARB as *const c_void),
    Entry("glGetProgramStringARB", glGetProgramStringARB as *const c_void),
    Entry("glGetProgramiv", glGetProgramiv as *const c_void),
    Entry("glGetProgramivARB", glGetProgramivARB as *const c_void),
    Entry("glGetQueryObjectiv", glGetQueryObjectiv as *const c_void),
    Entry("glGetQueryObjectivARB", glGetQueryObjectivARB as *const c_void),
    Entry("glGetQueryObjectuiv", glGetQueryObjectuiv as *const c_void),
    Entry("glGetQueryObjectuivARB", glGetQueryObjectuivARB as *const c_void),
    Entry("glGetQueryiv", glGetQueryiv as *const c_void),
    Entry("glGetQueryivARB", glGetQueryivARB as *const c_void),
    Entry("glGetRenderbufferParameteriv", glGetRenderbufferParameteriv as *const c_void),
    Entry("glGetRenderbufferParameterivEXT", glGetRenderbufferParameterivEXT as *const c_void),
    Entry("glGetSeparableFilter", glGetSeparableFilter as *const c_void),
    Entry("glGetShaderInfoLog", glGetShaderInfoLog as *const c_void),
    Entry("glGetShaderSource", glGetShaderSource as *const c_void),
    Entry("glGetShaderSourceARB", glGetShaderSourceARB as *const c_void),
    Entry("glGetShaderiv", glGetShaderiv as *const c_void),
    Entry("glGetString", glGetString as *const c_void),
    Entry("glGetTexEnvfv", glGetTexEnvfv as *const c_void),
    Entry("glGetTexEnviv", glGetTexEnviv as *const c_void),
    Entry("glGetTexGendv", glGetTexGendv as *const c_void),
    Entry("glGetTexGenfv", glGetTexGenfv as *const c_void),
    Entry("glGetTexGeniv", glGetTexGeniv as *const c_void),
    Entry("glGetTexImage", glGetTexImage as *const c_void),
    Entry("glGetTexLevelParameterfv", glGetTexLevelParameterfv as *const c_void),
    Entry("glGetTexLevelParameteriv", glGetTexLevelParameteriv as *const c_void),
    Entry("glGetTexParameterfv", glGetTexParameterfv as *const c_void),
    Entry("glGetTexParameteriv", glGetTexParameteriv as *const c_void),
    Entry("glGetUniformLocation", glGetUniformLocation as *const c_void),
    Entry("glGetUniformLocationARB", glGetUniformLocationARB as *const c_void),
    Entry("glGetUniformfv", glGetUniformfv as *const c_void),
    Entry("glGetUniformfvARB", glGetUniformfvARB as *const c_void),
    Entry("glGetUniformiv", glGetUniformiv as *const c_void),
    Entry("glGetUniformivARB", glGetUniformivARB as *const c_void),
    Entry("glGetVertexAttribPointerv", glGetVertexAttribPointerv as *const c_void),
    Entry("glGetVertexAttribPointervARB", glGetVertexAttribPointervARB as *const c_void),
    Entry("glGetVertexAttribdv", glGetVertexAttribdv as *const c_void),
    Entry("glGetVertexAttribdvARB", glGetVertexAttribdvARB as *const c_void),
    Entry("glGetVertexAttribfv", glGetVertexAttribfv as *const c_void),
    Entry("glGetVertexAttribfvARB", glGetVertexAttribfvARB as *const c_void),
    Entry("glGetVertexAttribiv", glGetVertexAttribiv as *const c_void),
    Entry("glGetVertexAttribivARB", glGetVertexAttribivARB as *const c_void),
    Entry("glHint", glHint as *const c_void),
    Entry("glHistogram", glHistogram as *const c_void),
    Entry("glIndexMask", glIndexMask as *const c_void),
    Entry("glIndexPointer", glIndexPointer as *const c_void),
    Entry("glIndexPointerEXT", glIndexPointerEXT as *const c_void),
    Entry("glIndexd", glIndexd as *const c_void),
    Entry("glIndexdv", glIndexdv as *const c_void),
    Entry("glIndexf", glIndexf as *const c_void),
    Entry("glIndexfv", glIndexfv as *const c_void),
    Entry("glIndexi", glIndexi as *const c_void),
    Entry("glIndexiv", glIndexiv as *const c_void),
    Entry("glIndexs", glIndexs as *const c_void),
    Entry("glIndexsv", glIndexsv as *const c_void),
    Entry("glIndexub", glIndexub as *const c_void),
    Entry("glIndexubv", glIndexubv as *const c_void),
    Entry("glInitNames", glInitNames as *const c_void),
    Entry("glInterleavedArrays", glInterleavedArrays as *const c_void),
    Entry("glIsBuffer", glIsBuffer as *const c_void),
    Entry("glIsBufferARB", glIsBufferARB as *const c_void),
    Entry("glIsEnabled", glIsEnabled as *const c_void),
    Entry("glIsFramebuffer", glIsFramebuffer as *const c_void),
    Entry("glIsFramebufferEXT", glIsFramebufferEXT as *const c_void),
    Entry("glIsList", glIsList as *const c_void),
    Entry("glIsProgram", glIsProgram as *const c_void),
    Entry("glIsProgramARB", glIsProgramARB as *const c_void),
    Entry("glIsQuery", glIsQuery as *const c_void),
    Entry("glIsQueryARB", glIsQueryARB as *const c_void),
    Entry("glIsRenderbuffer", glIsRenderbuffer as *const c_void),
    Entry("glIsRenderbufferEXT", glIsRenderbufferEXT as *const c_void),
    Entry("glIsShader", glIsShader as *const c_void),
    Entry("glIsTexture", glIsTexture as *const c_void),
    Entry("glIsTextureEXT", glIsTextureEXT as *const c_void),
    Entry("glLightModelf", glLightModelf as *const c_void),
    Entry("glLightModelfv", glLightModelfv as *const c_void),
    Entry("glLightModeli", glLightModeli as *const c_void),
    Entry("glLightModeliv", glLightModeliv as *const c_void),
    Entry("glLightf", glLightf as *const c_void),
    Entry("glLightfv", glLightfv as *const c_void),
    Entry("glLighti", glLighti as *const c_void),
    Entry("glLightiv", glLightiv as *const c_void),
    Entry("glLineStipple", glLineStipple as *const c_void),
    Entry("glLineWidth", glLineWidth as *const c_void),
    Entry("glLinkProgram", glLinkProgram as *const c_void),
    Entry("glLinkProgramARB", glLinkProgramARB as *const c_void),
    Entry("glListBase", glListBase as *const c_void),
    Entry("glLoadIdentity", glLoadIdentity as *const c_void),
    Entry("glLoadMatrixd", glLoadMatrixd as *const c_void),
    Entry("glLoadMatrixf", glLoadMatrixf as *const c_void),
    Entry("glLoadName", glLoadName as *const c_void),
    Entry("glLoadTransposeMatrixd", glLoadTransposeMatrixd as *const c_void),
    Entry("glLoadTransposeMatrixdARB", glLoadTransposeMatrixdARB as *const c_void),
    Entry("glLoadTransposeMatrixf", glLoadTransposeMatrixf as *const c_void),
    Entry("glLoadTransposeMatrixfARB", glLoadTransposeMatrixfARB as *const c_void),
    Entry("glLockArraysEXT", glLockArraysEXT as *const c_void),
    Entry("glLogicOp", glLogicOp as *const c_void),
    Entry("glMap1d", glMap1d as *const c_void),
    Entry("glMap1f", glMap1f as *const c_void),
    Entry("glMap2d", glMap2d as *const c_void),
    Entry("glMap2f", glMap2f as *const c_void),
    Entry("glMapBuffer", glMapBuffer as *const c_void),
    Entry("glMapBufferARB", glMapBufferARB as *const c_void),
    Entry("glMapGrid1d", glMapGrid1d as *const c_void),
    Entry("glMapGrid1f", glMapGrid1f as *const c_void),
    Entry("glMapGrid2d", glMapGrid2d as *const c_void),
    Entry("glMapGrid2f", glMapGrid2f as *const c_void),
    Entry("glMaterialf", glMaterialf as *const c_void),
    Entry("glMaterialfv", glMaterialfv as *const c_void),
    Entry("glMateriali", glMateriali as *const c_void),
    Entry("glMaterialiv", glMaterialiv as *const c_void),
    Entry("glMatrixMode", glMatrixMode as *const c_void),
    Entry("glMinmax", glMinmax as *const c_void),
    Entry("glMultMatrixd", glMultMatrixd as *const c_void),
    Entry("glMultMatrixf", glMultMatrixf as *const c_void),
    Entry("glMultTransposeMatrixd", glMultTransposeMatrixd as *const c_void),
    Entry("glMultTransposeMatrixdARB", glMultTransposeMatrixdARB as *const c_void),
    Entry("glMultTransposeMatrixf", glMultTransposeMatrixf as *const c_void),
    Entry("glMultTransposeMatrixfARB", glMultTransposeMatrixfARB as *const c_void),
    Entry("glMultiDrawArrays", glMultiDrawArrays as *const c_void),
    Entry("glMultiDrawArraysEXT", glMultiDrawArraysEXT as *const c_void),
    Entry("glMultiDrawElements", glMultiDrawElements as *const c_void),
    Entry("glMultiDrawElementsEXT", glMultiDrawElementsEXT as *const c_void),
    Entry("glMultiTexCoord1d", glMultiTexCoord1d as *const c_void),
    Entry("glMultiTexCoord1dARB", glMultiTexCoord1dARB as *const c_void),
    Entry("glMultiTexCoord1dv", glMultiTexCoord1dv as *const c_void),
    Entry("glMultiTexCoord1dvARB", glMultiTexCoord1dvARB as *const c_void),
    Entry("glMultiTexCoord1f", glMultiTexCoord1f as *const c_void),
    Entry("glMultiTexCoord1fARB", glMultiTexCoord1fARB as *const c_void),
    Entry("glMultiTexCoord1fv", glMultiTexCoord1fv as *const c_void),
    Entry("glMultiTexCoord1fvARB", glMultiTexCoord1fvARB as *const c_void),
    Entry("glMultiTexCoord1i", glMultiTexCoord1i as *const c_void),
    Entry("glMultiTexCoord1iARB", glMultiTexCoord1iARB as *const c_void),
    Entry("glMultiTexCoord1iv", glMultiTexCoord1iv as *const c_void),
    Entry("glMultiTexCoord1ivARB", glMultiTexCoord1ivARB as *const c_void),
    Entry("glMultiTexCoord1s", glMultiTexCoord1s as *const c_void),
    Entry("glMultiTexCoord1sARB", glMultiTexCoord1sARB as *const c_void),
    Entry("glMultiTexCoord1sv", glMultiTexCoord1sv as *const c_void),
    Entry("glMultiTexCoord1svARB", glMultiTexCoord1svARB as *const c_void),
    Entry("glMultiTexCoord2d", glMultiTexCoord2d as *const c_void),
    Entry("glMultiTexCoord2dARB", glMultiTexCoord2dARB as *const c_void),
    Entry("glMultiTexCoord2dv", glMultiTexCoord2dv as *const c_void),
    Entry("glMultiTexCoord2dvARB", glMultiTexCoord2dvARB as *const c_void),
    Entry("glMultiTexCoord2f", glMultiTexCoord2f as *const c_void),
    Entry("glMultiTexCoord2fARB", glMultiTexCoord2fARB as *const c_void),
    Entry("glMultiTexCoord2fv", glMultiTexCoord2fv as *const c_void),
    Entry("glMultiTexCoord2fvARB", glMultiTexCoord2fvARB as *const c_void),
    Entry("glMultiTexCoord2i", glMultiTexCoord2i as *const c_void),
    Entry("glMultiTexCoord2iARB", glMultiTexCoord2iARB as *const c_void),
    Entry("glMultiTexCoord2iv", glMultiTexCoord2iv as *const c_void),
    Entry("glMultiTexCoord2ivARB", glMultiTexCoord2ivARB as *const c_void),
    Entry("glMultiTexCoord2s", glMultiTexCoord2s as *const c_void),
    Entry("glMultiTexCoord2sARB", glMultiTexCoord2sARB as *const c_void),
    Entry("glMultiTexCoord2sv", glMultiTexCoord2sv as *const c_void),
    Entry("glMultiTexCoord2svARB", glMultiTexCoord2svARB as *const c_void),
    Entry("glMultiTexCoord3d", glMultiTexCoord3d as *const c_void),
    Entry("glMultiTexCoord3dARB", glMultiTexCoord3dARB as *const c_void),
    Entry("glMultiTexCoord3dv", glMultiTexCoord3dv as *const c_void),
    Entry("glMultiTexCoord3dvARB", glMultiTexCoord3dvARB as *const c_void),
    Entry("glMultiTexCoord3f", glMultiTexCoord3f as *const c_void),
    Entry("glMultiTexCoord3fARB", glMultiTexCoord3fARB as *const c_void),
    Entry("glMultiTexCoord3fv", glMultiTexCoord3fv as *const c_void),
    Entry("glMultiTexCoord3fvARB", glMultiTexCoord3fvARB as *const c_void),
    Entry("glMultiTexCoord3i", glMultiTexCoord3i as *const c_void),
    Entry("glMultiTexCoord3iARB", glMultiTexCoord3iARB as *const c_void),
    Entry("glMultiTexCoord3iv", glMultiTexCoord3iv as *const c_void),
    Entry("glMultiTexCoord3ivARB", glMultiTexCoord3ivARB as *const c_void),
    Entry("glMultiTexCoord3s", glMultiTexCoord3s as *const c_void),
    Entry("glMultiTexCoord3sARB", glMultiTexCoord3sARB as *const c_void),
    Entry("glMultiTexCoord3sv", glMultiTexCoord3sv as *const c_void),
    Entry("glMultiTexCoord3svARB", glMultiTexCoord3svARB as *const c_void),
    Entry("glMultiTexCoord4d", glMultiTexCoord4d as *const c_void),
    Entry("glMultiTexCoord4dARB", glMultiTexCoord4dARB as *const c_void),
    Entry("glMultiTexCoord4dv", glMultiTexCoord4dv as *const c_void),
    Entry("glMultiTexCoord4dvARB", glMultiTexCoord4dvARB as *const c_void),
    Entry("glMultiTexCoord4f", glMultiTexCoord4f as *const c_void),
    Entry("glMultiTexCoord4fARB", glMultiTexCoord4fARB as *const c_void),
    Entry("glMultiTexCoord4fv", glMultiTexCoord4fv as *const c_void),
    Entry("glMultiTexCoord4fvARB", glMultiTexCoord4fvARB as *const c_void),
    Entry("glMultiTexCoord4i", glMultiTexCoord4i as *const c_void),
    Entry("glMultiTexCoord4iARB", glMultiTexCoord4iARB as *const c_void),
    Entry("glMultiTexCoord4iv", glMultiTexCoord4iv as *const c_void),
    Entry("glMultiTexCoord4ivARB", glMultiTexCoord4ivARB as *const c_void),
    Entry("glMultiTexCoord4s", glMultiTexCoord4s as *const c_void),
    Entry("glMultiTexCoord4sARB", glMultiTexCoord4sARB as *const c_void),
    Entry("glMultiTexCoord4sv", glMultiTexCoord4sv as *const c_void),
    Entry("glMultiTexCoord4svARB", glMultiTexCoord4svARB as *const c_void),
    Entry("glNewList", glNewList as *const c_void),
    Entry("glNormal3b", glNormal3b as *const c_void),
    Entry("glNormal3bv", glNormal3bv as *const c_void),
    Entry("glNormal3d", glNormal3d as *const c_void),
    Entry("glNormal3dv", glNormal3dv as *const c_void),
    Entry("glNormal3f", glNormal3f as *const c_void),
    Entry("glNormal3fv", glNormal3fv as *const c_void),
    Entry("glNormal3i", glNormal3i as *const c_void),
    Entry("glNormal3iv", glNormal3iv as *const c_void),
    Entry("glNormal3s", glNormal3s as *const c_void),
    Entry("glNormal3sv", glNormal3sv as *const c_void),
    Entry("glNormalPointer", glNormalPointer as *const c_void),
    Entry("glNormalPointerEXT", glNormalPointerEXT as *const c_void),
    Entry("glOrtho", glOrtho as *const c_void),
    Entry("glPassThrough", glPassThrough as *const c_void),
    Entry("glPixelMapfv", glPixelMapfv as *const c_void),
    Entry("glPixelMapuiv", glPixelMapuiv as *const c_void),
    Entry("glPixelMapusv", glPixelMapusv as *const c_void),
    Entry("glPixelStoref", glPixelStoref as *const c_void),
    Entry("glPixelStorei", glPixelStorei as *const c_void),
    Entry("glPixelTransferf", glPixelTransferf as *const c_void),
    Entry("glPixelTransferi", glPixelTransferi as *const c_void),
    Entry("glPixelZoom", glPixelZoom as *const c_void),
    Entry("glPointParameterf", glPointParameterf as *const c_void),
    Entry("glPointParameterfARB", glPointParameterfARB as *const c_void),
    Entry("glPointParameterfEXT", glPointParameterfEXT as *const c_void),
    Entry("glPointParameterfv", glPointParameterfv as *const c_void),
    Entry("glPointParameterfvARB", glPointParameterfvARB as *const c_void),
    Entry("glPointParameterfvEXT", glPointParameterfvEXT as *const c_void),
    Entry("glPointParameteri", glPointParameteri as *const c_void),
    Entry("glPointParameteriv", glPointParameteriv as *const c_void),
    Entry("glPointSize", glPointSize as *const c_void),
    Entry("glPolygonMode", glPolygonMode as *const c_void),
    Entry("glPolygonOffset", glPolygonOffset as *const c_void),
    Entry("glPolygonOffsetEXT", glPolygonOffsetEXT as *const c_void),
    Entry("glPolygonStipple", glPolygonStipple as *const c_void),
    Entry("glPopAttrib", glPopAttrib as *const c_void),
    Entry("glPopClientAttrib", glPopClientAttrib as *const c_void),
    Entry("glPopMatrix", glPopMatrix as *const c_void),
    Entry("glPopName", glPopName as *const c_void),
    Entry("glPrioritizeTextures", glPrioritizeTextures as *const c_void),
    Entry("glPrioritizeTexturesEXT", glPrioritizeTexturesEXT as *const c_void),
    Entry("glProgramEnvParameter4dARB", glProgramEnvParameter4dARB as *const c_void),
    Entry("glProgramEnvParameter4dvARB", glProgramEnvParameter4dvARB as *const c_void),
    Entry("glProgramEnvParameter4fARB", glProgramEnvParameter4fARB as *const c_void),
    Entry("glProgramEnvParameter4fvARB", glProgramEnvParameter4fvARB as *const c_void),
    Entry("glProgramEnvParameters4fvEXT", glProgramEnvParameters4fvEXT as *const c_void),
    Entry("glProgramLocalParameter4dARB", glProgramLocalParameter4dARB as *const c_void),
    Entry("glProgramLocalParameter4dvARB", glProgramLocalParameter4dvARB as *const c_void),
    Entry("glProgramLocalParameter4fARB", glProgramLocalParameter4fARB as *const c_void),
    Entry("glProgramLocalParameter4fvARB", glProgramLocalParameter4fvARB as *const c_void),
    Entry("glProgramLocalParameters4fvEXT", glProgramLocalParameters4fvEXT as *const c_void),
    Entry("glProgramStringARB", glProgramStringARB as *const c_void),
    Entry("glPushAttrib", glPushAttrib as *const c_void),
    Entry("glPushClientAttrib", glPushClientAttrib as *const c_void),
    Entry("glPushMatrix", glPushMatrix as *const c_void),
    Entry("glPushName", glPushName as *const c_void),
    Entry("glRasterPos2d", glRasterPos2d as *const c_void),
    Entry("glRasterPos2dv", glRasterPos2dv as *const c_void),
    Entry("glRasterPos2f", glRasterPos2f as *const c_void),
    Entry("glRasterPos2fv", glRasterPos2fv as *const c_void),
    Entry("glRasterPos2i", glRasterPos2i as *const c_void),
    Entry("glRasterPos2iv", glRasterPos2iv as *const c_void),
    Entry("glRasterPos2s", glRasterPos2s as *const c_void),
    Entry("glRasterPos2sv", glRasterPos2sv as *const c_void),
    Entry("glRasterPos3d", glRasterPos3d as *const c_void),
    Entry("glRasterPos3dv", glRasterPos3dv as *const c_void),
    Entry("glRasterPos3f", glRasterPos3f as *const c_void),
    Entry("glRasterPos3fv", glRasterPos3fv as *const c_void),
    Entry("glRasterPos3i", glRasterPos3i as *const c_void),
    Entry("glRasterPos3iv", glRasterPos3iv as *const c_void),
    Entry("glRasterPos3s", glRasterPos3s as *const c_void),
    Entry("glRasterPos3sv", glRasterPos3sv as *const c_void),
    Entry("glRasterPos4d", glRasterPos4d as *const c_void),
    Entry("glRasterPos4dv", glRasterPos4dv as *const c_void),
    Entry("glRasterPos4f", glRasterPos4f as *const c_void),
    Entry("glRasterPos4fv", glRasterPos4fv as *const c_void),
    Entry("glRasterPos4i", glRasterPos4i as *const c_void),
    Entry("glRasterPos4iv", glRasterPos4iv as *const c_void),
    Entry("glRasterPos4s", glRasterPos4s as *const c_void),
    Entry("glRasterPos4sv", glRasterPos4sv as *const c_void),
    Entry("glReadBuffer", glReadBuffer as *const c_void),
    Entry("glReadPixels", glReadPixels as *const c_void),
    Entry("glRectd", glRectd as *const c_void),
    Entry("glRectdv", glRectdv as *const c_void),
    Entry("glRectf", glRectf as *const c_void),
    Entry("glRectfv", glRectfv as *const c_void),
    Entry("glRecti", glRecti as *const c_void),
    Entry("glRectiv", glRectiv as *const c_void),
    Entry("glRects", glRects as *const c_void),
    Entry("glRectsv", glRectsv as *const c_void),
    Entry("glRenderMode", glRenderMode as *const c_void),
    Entry("glRenderbufferStorage", glRenderbufferStorage as *const c_void),
    Entry("glRenderbufferStorageEXT", glRenderbufferStorageEXT as *const c_void),
    Entry("glRenderbufferStorageMultisample", glRenderbufferStorageMultisample as *const c_void),
    Entry("glRenderbufferStorageMultisampleEXT", glRenderbufferStorageMultisampleEXT as *const c_void),
    Entry("glResetHistogram", glResetHistogram as *const c_void),
    Entry("glResetMinmax", glResetMinmax as *const c_void),
    Entry("glRotated", glRotated as *const c_void),
    Entry("glRotatef", glRotatef as *const c_void),
    Entry("glSampleCoverage", glSampleCoverage as *const c_void),
    Entry("glSampleCoverageARB", glSampleCoverageARB as *const c_void),
    Entry("glScaled", glScaled as *const c_void),
    Entry("glScalef", glScalef as *const c_void),
    Entry("glScissor", glScissor as *const c_void),
    Entry("glSecondaryColor3b", glSecondaryColor3b as *const c_void),
    Entry("glSecondaryColor3bEXT", glSecondaryColor3bEXT as *const c_void),
    Entry("glSecondaryColor3bv", glSecondaryColor3bv as *const c_void),
    Entry("glSecondaryColor3bvEXT", glSecondaryColor3bvEXT as *const c_void),
    Entry("glSecondaryColor3d", glSecondaryColor3d as *const c_void),
    Entry("glSecondaryColor3dEXT", glSecondaryColor3dEXT as *const c_void),
    Entry("glSecondaryColor3dv", glSecondaryColor3dv as *const c_void),
    Entry("glSecondaryColor3dvEXT", glSecondaryColor3dvEXT as *const c_void),
    Entry("glSecondaryColor3f", glSecondaryColor3f as *const c_void),
    Entry("glSecondaryColor3fEXT", glSecondaryColor3fEXT as *const c_void),
    Entry("glSecondaryColor3fv", glSecondaryColor3fv as *const c_void),
    Entry("glSecondaryColor3fvEXT", glSecondaryColor3fvEXT as *const c_void),
    Entry("glSecondaryColor3i", glSecondaryColor3i as *const c_void),
    Entry("glSecondaryColor3iEXT", glSecondaryColor3iEXT as *const c_void),
    Entry("glSecondaryColor3iv", glSecondaryColor3iv as *const c_void),
    Entry("glSecondaryColor3ivEXT", glSecondaryColor3ivEXT as *const c_void),
    Entry("glSecondaryColor3s", glSecondaryColor3s as *const c_void),
    Entry("glSecondaryColor3sEXT", glSecondaryColor3sEXT as *const c_void),
    Entry("glSecondaryColor3sv", glSecondaryColor3sv as *const c_void),
    Entry("glSecondaryColor3svEXT", glSecondaryColor3svEXT as *const c_void),
    Entry("glSecondaryColor3ub", glSecondaryColor3ub as *const c_void),
    Entry("glSecondaryColor3ubEXT", glSecondaryColor3ubEXT as *const c_void),
    Entry("glSecondaryColor3ubv", glSecondaryColor3ubv as *const c_void),
    Entry("glSecondaryColor3ubvEXT", glSecondaryColor3ubvEXT as *const c_void),
    Entry("glSecondaryColor3ui", glSecondaryColor3ui as *const c_void),
    Entry("glSecondaryColor3uiEXT", glSecondaryColor3uiEXT as *const c_void),
    Entry("glSecondaryColor3uiv", glSecondaryColor3uiv as *const c_void),
    Entry("glSecondaryColor3uivEXT", glSecondaryColor3uivEXT as *const c_void),
    Entry("glSecondaryColor3us", glSecondaryColor3us as *const c_void),
    Entry("glSecondaryColor3usEXT", glSecondaryColor3usEXT as *const c_void),
    Entry("glSecondaryColor3usv", glSecondaryColor3usv as *const c_void),
    Entry("glSecondaryColor3usvEXT", glSecondaryColor3usvEXT as *const c_void),
    Entry("glSecondaryColorPointer", glSecondaryColorPointer as *const c_void),
    Entry("glSecondaryColorPointerEXT", glSecondaryColorPointerEXT as *const c_void),
    Entry("glSelectBuffer", glSelectBuffer as *const c_void),
    Entry("glSeparableFilter2D", glSeparableFilter2D as *const c_void),
    Entry("glShadeModel", glShadeModel as *const c_void),
    Entry("glShaderSource", glShaderSource as *const c_void),
    Entry("glShaderSourceARB", glShaderSourceARB as *const c_void),
    Entry("glStencilFunc", glStencilFunc as *const c_void),
    Entry("glStencilFuncSeparate", glStencilFuncSeparate as *const c_void),
    Entry("glStencilFuncSeparateATI", glStencilFuncSeparateATI as *const c_void),
    Entry("glStencilMask", glStencilMask as *const c_void),
    Entry("glStencilMaskSeparate", glStencilMaskSeparate as *const c_void),
    Entry("glStencilOp", glStencilOp as *const c_void),
    Entry("glStencilOpSeparate", glStencilOpSeparate as *const c_void),
    Entry("glStencilOpSeparateATI", glStencilOpSeparateATI as *const c_void),
    Entry("glTexCoord1d", glTexCoord1d as *const c_void),
    Entry("glTexCoord1dv", glTexCoord1dv as *const c_void),
    Entry("glTexCoord1f", glTexCoord1f as *const c_void),
    Entry("glTexCoord1fv", glTexCoord1fv as *const c_void),
    Entry("glTexCoord1i", glTexCoord1i as *const c_void),
    Entry("glTexCoord1iv", glTexCoord1iv as *const c_void),
    Entry("glTexCoord1s", glTexCoord1s as *const c_void),
    Entry("glTexCoord1sv", glTexCoord1sv as *const c_void),
    Entry("glTexCoord2d", glTexCoord2d as *const c_void),
    Entry("glTexCoord2dv", glTexCoord2dv as *const c_void),
    Entry("glTexCoord2f", glTexCoord2f as *const c_void),
    Entry("glTexCoord2fv", glTexCoord2fv as *const c_void),
    Entry("glTexCoord2i", glTexCoord2i as *const c_void),
    Entry("glTexCoord2iv", glTexCoord2iv as *const c_void),
    Entry("glTexCoord2s", glTexCoord2s as *const c_void),
    Entry("glTexCoord2sv", glTexCoord2sv as *const c_void),
    Entry("glTexCoord3d", glTexCoord3d as *const c_void),
    Entry("glTexCoord3dv", glTexCoord3dv as *const c_void),
    Entry("glTexCoord3f", glTexCoord3f as *const c_void),
    Entry("glTexCoord3fv", glTexCoord3fv as *const c_void),
    Entry("glTexCoord3i", glTexCoord3i as *const c_void),
    Entry("glTexCoord3iv", glTexCoord3iv as *const c_void),
    Entry("glTexCoord3s", glTexCoord3s as *const c_void),
    Entry("glTexCoord3sv", glTexCoord3sv as *const c_void),
    Entry("glTexCoord4d", glTexCoord4d as *const c_void),
    Entry("glTexCoord4dv", glTexCoord4dv as *const c_void),
    Entry("glTexCoord4f", glTexCoord4f as *const c_void),
    Entry("glTexCoord4fv", glTexCoord4fv as *const c_void),
    Entry("glTexCoord4i", glTexCoord4i as *const c_void),
    Entry("glTexCoord4iv", glTexCoord4iv as *const c_void),
    Entry("glTexCoord4s", glTexCoord4s as *const c_void),
    Entry("glTexCoord4sv", glTexCoord4sv as *const c_void),
    Entry("glTexCoordPointer", glTexCoordPointer as *const c_void),
    Entry("glTexCoordPointerEXT", glTexCoordPointerEXT as *const c_void),
    Entry("glTexEnvf", glTexEnvf as *const c_void),
    Entry("glTexEnvfv", glTexEnvfv as *const c_void),
    Entry("glTexEnvi", glTexEnvi as *const c_void),
    Entry("glTexEnviv", glTexEnviv as *const c_void),
    Entry("glTexGend", glTexGend as *const c_void),
    Entry("glTexGendv", glTexGendv as *const c_void),
    Entry("glTexGenf", glTexGenf as *const c_void),
    Entry("glTexGenfv", glTexGenfv as *const c_void),
    Entry("glTexGeni", glTexGeni as *const c_void),
    Entry("glTexGeniv", glTexGeniv as *const c_void),
    Entry("glTexImage1D", glTexImage1D as *const c_void),
    Entry("glTexImage2D", glTexImage2D as *const c_void),
    Entry("glTexImage3D", glTexImage3D as *const c_void),
    Entry("glTexImage3DEXT", glTexImage3DEXT as *const c_void),
    Entry("glTexParameterf", glTexParameterf as *const c_void),
    Entry("glTexParameterfv", glTexParameterfv as *const c_void),
    Entry("glTexParameteri", glTexParameteri as *const c_void),
    Entry("glTexParameteriv", glTexParameteriv as *const c_void),
    Entry("glTexSubImage1D", glTexSubImage1D as *const c_void),
    Entry("glTexSubImage1DEXT", glTexSubImage1DEXT as *const c_void),
    Entry("glTexSubImage2D", glTexSubImage2D as *const c_void),
    Entry("glTexSubImage2DEXT", glTexSubImage2DEXT as *const c_void),
    Entry("glTexSubImage3D", glTexSubImage3D as *const c_void),
    Entry("glTexSubImage3DEXT", glTexSubImage3DEXT as *const c_void),
    Entry("glTranslated", glTranslated as *const c_void),
    Entry("glTranslatef", glTranslatef as *const c_void),
    Entry("glUniform1f", glUniform1f as *const c_void),
    Entry("glUniform1fARB", glUniform1fARB as *const c_void),
    Entry("glUniform1fv", glUniform1fv as *const c_void),
    Entry("glUniform1fvARB", glUniform1fvARB as *const c_void),
    Entry("glUniform1i", glUniform1i as *const c_void),
    Entry("glUniform1iARB", glUniform1iARB as *const c_void),
    Entry("glUniform1iv", glUniform1iv as *const c_void),
    Entry("glUniform1ivARB", glUniform1ivARB as *const c_void),
    Entry("glUniform2f", glUniform2f as *const c_void),
    Entry("glUniform2fARB", glUniform2fARB as *const c_void),
    Entry("glUniform2fv", glUniform2fv as *const c_void),
    Entry("glUniform2fvARB", glUniform2fvARB as *const c_void),
    Entry("glUniform2i", glUniform2i as *const c_void),
    Entry("glUniform2iARB", glUniform2iARB as *const c_void),
    Entry("glUniform2iv", glUniform2iv as *const c_void),
    Entry("glUniform2ivARB", glUniform2ivARB as *const c_void),
    Entry("glUniform3f", glUniform3f as *const c_void),
    Entry("glUniform3fARB", glUniform3fARB as *const c_void),
    Entry("glUniform3fv", glUniform3fv as *const c_void),
    Entry("glUniform3fvARB", glUniform3fvARB as *const c_void),
    Entry("glUniform3i", glUniform3i as *const c_void),
    Entry("glUniform3iARB", glUniform3iARB as *const c_void),
    Entry("glUniform3iv", glUniform3iv as *const c_void),
    Entry("glUniform3ivARB", glUniform3ivARB as *const c_void),
    Entry("glUniform4f", glUniform4f as *const c_void),
    Entry("glUniform4fARB", glUniform4fARB as *const c_void),
    Entry("glUniform4fv", glUniform4fv as *const c_void),
    Entry("glUniform4fvARB", glUniform4fvARB as *const c_void),
    Entry("glUniform4i", glUniform4i as *const c_void),
    Entry("glUniform4iARB", glUniform4iARB as *const c_void),
    Entry("glUniform4iv", glUniform4iv as *const c_void),
    Entry("glUniform4ivARB", glUniform4ivARB as *const c_void),
    Entry("glUniformMatrix2fv", glUniformMatrix2fv as *const c_void),
    Entry("glUniformMatrix2fvARB", glUniformMatrix2fvARB as *const c_void),
    Entry("glUniformMatrix2x3fv", glUniformMatrix2x3fv as *const c_void),
    Entry("glUniformMatrix2x4fv", glUniformMatrix2x4fv as *const c_void),
    Entry("glUniformMatrix3fv", glUniformMatrix3fv as *const c_void),
    Entry("glUniformMatrix3fvARB", glUniformMatrix3fvARB as *const c_void),
    Entry("glUniformMatrix3x2fv", glUniformMatrix3x2fv as *const c_void),
    Entry("glUniformMatrix3x4fv", glUniformMatrix3x4fv as *const c_void),
    Entry("glUniformMatrix4fv", glUniformMatrix4fv as *const c_void),
    Entry("glUniformMatrix4fvARB", glUniformMatrix4fvARB as *const c_void),
    Entry("glUniformMatrix4x2fv", glUniformMatrix4x2fv as *const c_void),
    Entry("glUniformMatrix4x3fv", glUniformMatrix4x3fv as *const c_void),
    Entry("glUnlockArraysEXT", glUnlockArraysEXT as *const c_void),
    Entry("glUnmapBuffer", glUnmapBuffer as *const c_void),
    Entry("glUnmapBufferARB", glUnmapBufferARB as *const c_void),
    Entry("glUseProgram", glUseProgram as *const c_void),
    Entry("glUseProgramObjectARB", glUseProgramObjectARB as *const c_void),
    Entry("glValidateProgram", glValidateProgram as *const c_void),
    Entry("glValidateProgramARB", glValidateProgramARB as *const c_void),
    Entry("glVertex2d", glVertex2d as *const c_void),
    Entry("glVertex2dv", glVertex2dv as *const c_void),
    Entry("glVertex2f", glVertex2f as *const c_void),
    Entry("glVertex2fv", glVertex2fv as *const c_void),
    Entry("glVertex2i", glVertex2i as *const c_void),
    Entry("glVertex2iv", glVertex2iv as *const c_void),
    Entry("glVertex2s", glVertex2s as *const c_void),
    Entry("glVertex2sv", glVertex2sv as *const c_void),
    Entry("glVertex3d", glVertex3d as *const c_void),
    Entry("glVertex3dv", glVertex3dv as *const c_void),
    Entry("glVertex3f", glVertex3f as *const c_void),
    Entry("glVertex3fv", glVertex3fv as *const c_void),
    Entry("glVertex3i", glVertex3i as *const c_void),
    Entry("glVertex3iv", glVertex3iv as *const c_void),
    Entry("glVertex3s", glVertex3s as *const c_void),
    Entry("glVertex3sv", glVertex3sv as *const c_void),
    Entry("glVertex4d", glVertex4d as *const c_void),
    Entry("glVertex4dv", glVertex4dv as *const c_void),
    Entry("glVertex4f", glVertex4f as *const c_void),
    Entry("glVertex4fv", glVertex4fv as *const c_void),
    Entry("glVertex4i", glVertex4i as *const c_void),
    Entry("glVertex4iv", glVertex4iv as *const c_void),
    Entry("glVertex4s", glVertex4s as *const c_void),
    Entry("glVertex4sv", glVertex4sv as *const c_void),
    Entry("glVertexAttrib1d", glVertexAttrib1d as *const c_void),
    Entry("glVertexAttrib1dARB", glVertexAttrib1dARB as *const c_void),
    Entry("glVertexAttrib1dv", glVertexAttrib1dv as *const c_void),
    Entry("glVertexAttrib1dvARB", glVertexAttrib1dvARB as *const c_void),
    Entry("glVertexAttrib1f", glVertexAttrib1f as *const c_void),
    Entry("glVertexAttrib1fARB", glVertexAttrib1fARB as *const c_void),
    Entry("glVertexAttrib1fv", glVertexAttrib1fv as *const c_void),
    Entry("glVertexAttrib1fvARB", glVertexAttrib1fvARB as *const c_void),
    Entry("glVertexAttrib1s", glVertexAttrib1s as *const c_void),
    Entry("glVertexAttrib1sARB", glVertexAttrib1sARB as *const c_void),
    Entry("glVertexAttrib1sv", glVertexAttrib1sv as *const c_void),
    Entry("glVertexAttrib1svARB", glVertexAttrib1svARB as *const c_void),
    Entry("glVertexAttrib2d", glVertexAttrib2d as *const c_void),
    Entry("glVertexAttrib2dARB", glVertexAttrib2dARB as *const c_void),
    Entry("glVertexAttrib2dv", glVertexAttrib2dv as *const c_void),
    Entry("glVertexAttrib2dvARB", glVertexAttrib2dvARB as *const c_void),
    Entry("glVertexAttrib2f", glVertexAttrib2f as *const c_void),
    Entry("glVertexAttrib2fARB", glVertexAttrib2fARB as *const c_void),
    Entry("glVertexAttrib2fv", glVertexAttrib2fv as *const c_void),
    Entry("glVertexAttrib2fvARB", glVertexAttrib2fvARB as *const c_void),
    Entry("glVertexAttrib2s", glVertexAttrib2s as *const c_void),
    Entry("glVertexAttrib2sARB", glVertexAttrib2sARB as *const c_void),
    Entry("glVertexAttrib2sv", glVertexAttrib2sv as *const c_void),
    Entry("glVertexAttrib2svARB", glVertexAttrib2svARB as *const c_void),
    Entry("glVertexAttrib3d", glVertexAttrib3d as *const c_void),
    Entry("glVertexAttrib3dARB", glVertexAttrib3dARB as *const c_void),
    Entry("glVertexAttrib3dv", glVertexAttrib3dv as *const c_void),
    Entry("glVertexAttrib3dvARB", glVertexAttrib3dvARB as *const c_void),
    Entry("glVertexAttrib3f", glVertexAttrib3f as *const c_void),
    Entry("glVertexAttrib3fARB", glVertexAttrib3fARB as *const c_void),
    Entry("glVertexAttrib3fv", glVertexAttrib3fv as *const c_void),
    Entry("glVertexAttrib3fvARB", glVertexAttrib3fvARB as *const c_void),
    Entry("glVertexAttrib3s", glVertexAttrib3s as *const c_void),
    Entry("glVertexAttrib3sARB", glVertexAttrib3sARB as *const c_void),
    Entry("glVertexAttrib3sv", glVertexAttrib3sv as *const c_void),
    Entry("glVertexAttrib3svARB", glVertexAttrib3svARB as *const c_void),
    Entry("glVertexAttrib4Nbv", glVertexAttrib4Nbv as *const c_void),
    Entry("glVertexAttrib4NbvARB", glVertexAttrib4NbvARB as *const c_void),
    Entry("glVertexAttrib4Niv", glVertexAttrib4Niv as *const c_void),
    Entry("glVertexAttrib4NivARB", glVertexAttrib4NivARB as *const c_void),
    Entry("glVertexAttrib4Nsv", glVertexAttrib4Nsv as *const c_void),
    Entry("glVertexAttrib4NsvARB", glVertexAttrib4NsvARB as *const c_void),
    Entry("glVertexAttrib4Nub", glVertexAttrib4Nub as *const c_void),
    Entry("glVertexAttrib4NubARB", glVertexAttrib4NubARB as *const c_void),
    Entry("glVertexAttrib4Nubv", glVertexAttrib4Nubv as *const c_void),
    Entry("glVertexAttrib4NubvARB", glVertexAttrib4NubvARB as *const c_void),
    Entry("glVertexAttrib4Nuiv", glVertexAttrib4Nuiv as *const c_void),
    Entry("glVertexAttrib4NuivARB", glVertexAttrib4NuivARB as *const c_void),
    Entry("glVertexAttrib4Nusv", glVertexAttrib4Nusv as *const c_void),
    Entry("glVertexAttrib4NusvARB", glVertexAttrib4NusvARB as *const c_void),
    Entry("glVertexAttrib4bv", glVertexAttrib4bv as *const c_void),
    Entry("glVertexAttrib4bvARB", glVertexAttrib4bvARB as *const c_void),
    Entry("glVertexAttrib4d", glVertexAttrib4d as *const c_void),
    Entry("glVertexAttrib4dARB", glVertexAttrib4dARB as *const c_void),
    Entry("glVertexAttrib4dv", glVertexAttrib4dv as *const c_void),
    Entry("glVertexAttrib4dvARB", glVertexAttrib4dvARB as *const c_void),
    Entry("glVertexAttrib4f", glVertexAttrib4f as *const c_void),
    Entry("glVertexAttrib4fARB", glVertexAttrib4fARB as *const c_void),
    Entry("glVertexAttrib4fv", glVertexAttrib4fv as *const c_void),
    Entry("glVertexAttrib4fvARB", glVertexAttrib4fvARB as *const c_void),
    Entry("glVertexAttrib4iv", glVertexAttrib4iv as *const c_void),
    Entry("glVertexAttrib4ivARB", glVertexAttrib4ivARB as *const c_void),
    Entry("glVertexAttrib4s", glVertexAttrib4s as *const c_void),
    Entry("glVertexAttrib4sARB", glVertexAttrib4sARB as *const c_void),
    Entry("glVertexAttrib4sv", glVertexAttrib4sv as *const c_void),
    Entry("glVertexAttrib4svARB", glVertexAttrib4svARB as *const c_void),
    Entry("glVertexAttrib4ubv", glVertexAttrib4ubv as *const c_void),
    Entry("glVertexAttrib4ubvARB", glVertexAttrib4ubvARB as *const c_void),
    Entry("glVertexAttrib4uiv", glVertexAttrib4uiv as *const c_void),
    Entry("glVertexAttrib4uivARB", glVertexAttrib4uivARB as *const c_void),
    Entry("glVertexAttrib4usv", glVertexAttrib4usv as *const c_void),
    Entry("glVertexAttrib4usvARB", glVertexAttrib4usvARB as *const c_void),
    Entry("glVertexAttribPointer", glVertexAttribPointer as *const c_void),
    Entry("glVertexAttribPointerARB", glVertexAttribPointerARB as *const c_void),
    Entry("glVertexPointer", glVertexPointer as *const c_void),
    Entry("glVertexPointerEXT", glVertexPointerEXT as *const c_void),
    Entry("glViewport", glViewport as *const c_void),
    Entry("glWindowPos2d", glWindowPos2d as *const c_void),
    Entry("glWindowPos2dARB", glWindowPos2dARB as *const c_void),
    Entry("glWindowPos2dMESA", glWindowPos2dMESA as *const c_void),
    Entry("glWindowPos2dv", glWindowPos2dv as *const c_void),
    Entry("glWindowPos2dvARB", glWindowPos2dvARB as *const c_void),
    Entry("glWindowPos2dvMESA", glWindowPos2dvMESA as *const c_void),
    Entry("glWindowPos2f", glWindowPos2f as *const c_void),
    Entry("glWindowPos2fARB", glWindowPos2fARB as *const c_void),
    Entry("glWindowPos2fMESA", glWindowPos2fMESA as *const c_void),
    Entry("glWindowPos2fv", glWindowPos2fv as *const c_void),
    Entry("glWindowPos2fvARB", glWindowPos2fvARB as *const c_void),
    Entry("glWindowPos2fvMESA", glWindowPos2fvMESA as *const c_void),
    Entry("glWindowPos2i", glWindowPos2i as *const c_void),
    Entry("glWindowPos2iARB", glWindowPos2iARB as *const c_void),
    Entry("glWindowPos2iMESA", glWindowPos2iMESA as *const c_void),
    Entry("glWindowPos2iv", glWindowPos2iv as *const c_void),
    Entry("glWindowPos2ivARB", glWindowPos2ivARB as *const c_void),
    Entry("glWindowPos2ivMESA", glWindowPos2ivMESA as *const c_void),
    Entry("glWindowPos2s", glWindowPos2s as *const c_void),
    Entry("glWindowPos2sARB", glWindowPos2sARB as *const c_void),
    Entry("glWindowPos2sMESA", glWindowPos2sMESA as *const c_void),
    Entry("glWindowPos2sv", glWindowPos2sv as *const c_void),
    Entry("glWindowPos2svARB", glWindowPos2svARB as *const c_void),
    Entry("glWindowPos2svMESA", glWindowPos2svMESA as *const c_void),
    Entry("glWindowPos3d", glWindowPos3d as *const c_void),
    Entry("glWindowPos3dARB", glWindowPos3dARB as *const c_void),
    Entry("glWindowPos3dMESA", glWindowPos3dMESA as *const c_void),
    Entry("glWindowPos3dv", glWindowPos3dv as *const c_void),
    Entry("glWindowPos3dvARB", glWindowPos3dvARB as *const c_void),
    Entry("glWindowPos3dvMESA", glWindowPos3dvMESA as *const c_void),
    Entry("glWindowPos3f", glWindowPos3f as *const c_void),
    Entry("glWindowPos3fARB", glWindowPos3fARB as *const c_void),
    Entry("glWindowPos3fMESA", glWindowPos3fMESA as *const c_void),
    Entry("glWindowPos3fv", glWindowPos3fv as *const c_void),
    Entry("glWindowPos3fvARB", glWindowPos3fvARB as *const c_void),
    Entry("glWindowPos3fvMESA", glWindowPos3fvMESA as *const c_void),
    Entry("glWindowPos3i", glWindowPos3i as *const c_void),
    Entry("glWindowPos3iARB", glWindowPos3iARB as *const c_void),
    Entry("glWindowPos3iMESA", glWindowPos3iMESA as *const c_void),
    Entry("glWindowPos3iv", glWindowPos3iv as *const c_void),
    Entry("glWindowPos3ivARB", glWindowPos3ivARB as *const c_void),
    Entry("glWindowPos3ivMESA", glWindowPos3ivMESA as *const c_void),
    Entry("glWindowPos3s", glWindowPos3s as *const c_void),
    Entry("glWindowPos3sARB", glWindowPos3sARB as *const c_void),
    Entry("glWindowPos3sMESA", glWindowPos3sMESA as *const c_void),
    Entry("glWindowPos3sv", glWindowPos3sv as *const c_void),
    Entry("glWindowPos3svARB", glWindowPos3svARB as *const c_void),
    Entry("glWindowPos3svMESA", glWindowPos3svMESA as *const c_void),
    Entry("glWindowPos4dMESA", glWindowPos4dMESA as *const c_void),
    Entry("glWindowPos4dvMESA", glWindowPos4dvMESA as *const c_void),
    Entry("glWindowPos4fMESA", glWindowPos4fMESA as *const c_void),
    Entry("glWindowPos4fvMESA", glWindowPos4fvMESA as *const c_void),
    Entry("glWindowPos4iMESA", glWindowPos4iMESA as *const c_void),
    Entry("glWindowPos4ivMESA", glWindowPos4ivMESA as *const c_void),
    Entry("glWindowPos4sMESA", glWindowPos4sMESA as *const c_void),
    Entry("glWindowPos4svMESA", glWindowPos4svMESA as *const c_void),
];
