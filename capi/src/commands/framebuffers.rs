//! Framebuffer objects and renderbuffers: the commands that take pointers.

use tepui::gl::Context;
use tepui::gl::enums::*;

use super::memory::{copy, count, put};

/// A command that makes names and one that frees them.
macro_rules! names {
    ($($generate:ident $delete:ident => $make:ident $free:ident;)*) => { $(
        #[doc = stringify!($generate)]
        pub unsafe fn $generate(cx: &mut Context, n: i32, names: *mut u32) {
            if n > 0 && names.is_null() {
                return cx.set_error(GL_INVALID_VALUE, stringify!($generate));
            }
            let made = cx.$make(n);
            // SAFETY: the contract of this folder.
            unsafe { put(cx, stringify!($generate), names, made) };
        }
        #[doc = stringify!($delete)]
        pub unsafe fn $delete(cx: &mut Context, n: i32, names: *const u32) {
            // SAFETY: the contract of this folder.
            if let Some(names) = unsafe { copy(cx, stringify!($delete), names, count(n)) } {
                cx.$free(n, &names);
            }
        }
    )* };
}

names! {
    glGenFramebuffers glDeleteFramebuffers => gen_framebuffers delete_framebuffers;
    glGenRenderbuffers glDeleteRenderbuffers => gen_renderbuffers delete_renderbuffers;
}

/// glGetRenderbufferParameteriv
pub unsafe fn glGetRenderbufferParameteriv(cx: &mut Context, target: GLenum, pname: GLenum, params: *mut i32) {
    if let Some(value) = cx.get_renderbuffer_parameter(target, pname) {
        // SAFETY: the contract of this folder.
        unsafe { put(cx, "glGetRenderbufferParameteriv", params, [value]) };
    }
}

/// glGetFramebufferAttachmentParameteriv
pub unsafe fn glGetFramebufferAttachmentParameteriv(cx: &mut Context, target: GLenum, attachment: GLenum, pname: GLenum, params: *mut i32) {
    if let Some(value) = cx.get_framebuffer_attachment_parameter(target, attachment, pname) {
        // SAFETY: the contract of this folder.
        unsafe { put(cx, "glGetFramebufferAttachmentParameteriv", params, [value]) };
    }
}

/// glDrawBuffers. More names than there can be are not read.
pub unsafe fn glDrawBuffers(cx: &mut Context, n: i32, buffers: *const u32) {
    // SAFETY: the contract of this folder.
    if let Some(buffers) = unsafe { copy(cx, "glDrawBuffers", buffers, count(n.min(16))) } {
        cx.draw_buffers(n, &buffers);
    }
}
