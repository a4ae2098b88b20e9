//! What framebuffer objects promise: each rule of completeness, each error, what queries answer, and where pixels go.

mod attachments;
mod blits;
mod completeness;
mod drawing;
mod errors;
mod float_depth;
mod queries;

use crate::gl::enums::*;
use crate::gl::{Context, ContextConfig};

const FB: GLenum = GL_FRAMEBUFFER;
const RB: GLenum = GL_RENDERBUFFER;
const COLOR0: GLenum = GL_COLOR_ATTACHMENT0;

/// A context with a window of 8 x 6.
fn context() -> Context {
    let mut cx = Context::new(ContextConfig::default(), None);
    cx.attach_window(8, 6);
    cx
}

/// A new framebuffer, bound to both targets.
fn framebuffer(cx: &mut Context) -> u32 {
    let name = cx.gen_framebuffers(1)[0];
    cx.bind_framebuffer(FB, name);
    name
}

/// A new renderbuffer with storage.
fn renderbuffer(cx: &mut Context, samples: i32, format: GLenum, width: i32, height: i32) -> u32 {
    let name = cx.gen_renderbuffers(1)[0];
    cx.bind_renderbuffer(RB, name);
    cx.renderbuffer_storage_multisample(RB, samples, format, width, height);
    name
}

/// The same, attached.
fn attach(cx: &mut Context, point: GLenum, samples: i32, format: GLenum, width: i32, height: i32) -> u32 {
    let name = renderbuffer(cx, samples, format, width, height);
    cx.framebuffer_renderbuffer(FB, point, RB, name);
    name
}

/// A new 2D texture with one level, bound.
fn texture(cx: &mut Context, format: GLenum, width: i32, height: i32) -> u32 {
    let name = cx.gen_textures(1)[0];
    cx.bind_texture(GL_TEXTURE_2D, name);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST as i32);
    cx.tex_image_2d(GL_TEXTURE_2D, 0, format as i32, width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE, None);
    name
}

fn status(cx: &mut Context) -> GLenum {
    cx.check_framebuffer_status(FB)
}

/// The error of some commands, no error before.
#[track_caller]
fn error_of(cx: &mut Context, commands: impl FnOnce(&mut Context)) -> GLenum {
    assert_eq!(cx.get_error(), GL_NO_ERROR);
    commands(cx);
    cx.get_error()
}

fn get(cx: &mut Context, pname: GLenum) -> i32 {
    cx.get(pname).and_then(|value| value.as_i32().next()).unwrap_or(-1)
}

/// RGBA of the pixels of the read framebuffer, bottom row first.
#[track_caller]
fn pixels(cx: &mut Context, width: i32, height: i32) -> Vec<[u8; 4]> {
    let mut out = vec![0; (width * height * 4) as usize];
    cx.read_pixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, Some(&mut out));
    assert_eq!(cx.get_error(), GL_NO_ERROR);
    out.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect()
}

/// Clears a part of the draw framebuffer to a colour.
fn fill(cx: &mut Context, [x, y, width, height]: [i32; 4], [r, g, b, a]: [f32; 4]) {
    cx.enable(GL_SCISSOR_TEST);
    cx.scissor(x, y, width, height);
    cx.clear_color(r, g, b, a);
    cx.clear(GL_COLOR_BUFFER_BIT);
    cx.disable(GL_SCISSOR_TEST);
}

const RED: [f32; 4] = [1.0, 0.0, 0.0, 1.0];
const GREEN: [f32; 4] = [0.0, 1.0, 0.0, 1.0];
