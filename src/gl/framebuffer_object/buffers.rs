//! Which buffers are drawn to and read from (4.2.1, 4.3.2): a state of each framebuffer. The window's is part of the attribute stack's groups.

use super::{MAX_COLOR_ATTACHMENTS, MAX_DRAW_BUFFERS};
use crate::gl::enums::*;
use crate::gl::{Context, dirty};

/// The error of a colour buffer that a framebuffer object does not have.
fn check_attachment(buffer: GLenum) -> Result<(), GLenum> {
    match buffer {
        GL_NONE => Ok(()),
        GL_COLOR_ATTACHMENT0..=GL_COLOR_ATTACHMENT15 if buffer < GL_COLOR_ATTACHMENT0 + MAX_COLOR_ATTACHMENTS as u32 => Ok(()),
        GL_COLOR_ATTACHMENT0..=GL_COLOR_ATTACHMENT15 => Err(GL_INVALID_OPERATION),
        GL_FRONT_LEFT..=GL_AUX3 => Err(GL_INVALID_OPERATION),
        _ => Err(GL_INVALID_ENUM),
    }
}

/// The same for the window, which has one colour buffer, called front and back at once.
fn check_window(buffer: GLenum) -> Result<(), GLenum> {
    match buffer {
        GL_NONE | GL_FRONT | GL_BACK | GL_LEFT | GL_FRONT_LEFT | GL_BACK_LEFT | GL_FRONT_AND_BACK => Ok(()),
        GL_RIGHT | GL_FRONT_RIGHT | GL_BACK_RIGHT | GL_AUX0..=GL_AUX3 => Err(GL_INVALID_OPERATION),
        GL_COLOR_ATTACHMENT0..=GL_COLOR_ATTACHMENT15 => Err(GL_INVALID_OPERATION),
        _ => Err(GL_INVALID_ENUM),
    }
}

impl Context {
    /// glDrawBuffer
    pub fn draw_buffer(&mut self, buffer: GLenum) {
        if self.compile(move |cx| cx.draw_buffer(buffer)) || self.inside_begin_end() {
            return;
        }
        let checked = if self.fbo.draw == 0 { check_window(buffer) } else { check_attachment(buffer) };
        match checked {
            Ok(()) => self.set_draw_buffers(&[buffer]),
            Err(error) => self.set_error(error, "glDrawBuffer"),
        }
    }

    /// glDrawBuffers. `n` is the count as given, `buffers` what is there.
    pub fn draw_buffers(&mut self, n: i32, buffers: &[GLenum]) {
        if self.lists.builder.is_some() {
            let kept = buffers.to_vec();
            self.compile(move |cx| cx.draw_buffers(n, &kept));
            return;
        }
        if self.inside_begin_end() {
            return;
        }
        if !(0..=MAX_DRAW_BUFFERS as i32).contains(&n) {
            return self.set_error(GL_INVALID_VALUE, "glDrawBuffers: n");
        }
        let window = self.fbo.draw == 0;
        let check = |buffer: GLenum| match buffer {
            // Names of several buffers at once are for glDrawBuffer alone (table 4.5).
            GL_FRONT | GL_BACK | GL_LEFT | GL_RIGHT | GL_FRONT_AND_BACK => Err(GL_INVALID_ENUM),
            _ if window => check_window(buffer),
            _ => check_attachment(buffer),
        };
        let twice = (1..buffers.len()).any(|k| buffers[k] != GL_NONE && buffers[..k].contains(&buffers[k]));
        let checked = buffers.iter().try_for_each(|&buffer| check(buffer)).and(if twice { Err(GL_INVALID_OPERATION) } else { Ok(()) });
        match checked {
            Ok(()) => self.set_draw_buffers(buffers),
            Err(error) => self.set_error(error, "glDrawBuffers"),
        }
    }

    /// The draw buffers of the draw framebuffer; those that are not given are GL_NONE.
    pub(crate) fn set_draw_buffers(&mut self, buffers: &[GLenum]) {
        let all = std::array::from_fn(|k| buffers.get(k).copied().unwrap_or(GL_NONE));
        if self.fbo.draw != 0 {
            self.framebuffer_changes();
        }
        match self.fbo.get_mut(self.fbo.draw) {
            Some(framebuffer) => framebuffer.draw_buffers = all,
            None => self.state.color_buffer.draw_buffers = all,
        }
        self.dirty |= dirty::FRAGMENT;
    }

    /// glReadBuffer
    pub fn read_buffer(&mut self, buffer: GLenum) {
        if self.compile(move |cx| cx.read_buffer(buffer)) || self.inside_begin_end() {
            return;
        }
        let checked = match buffer {
            _ if self.fbo.read != 0 => check_attachment(buffer),
            GL_FRONT_AND_BACK => Err(GL_INVALID_ENUM),
            _ => check_window(buffer),
        };
        if let Err(error) = checked {
            return self.set_error(error, "glReadBuffer");
        }
        match self.fbo.get_mut(self.fbo.read) {
            Some(framebuffer) => {
                framebuffer.read_buffer = buffer;
                // It counts for completeness.
                self.fbo.view.stale = true;
            }
            None => self.state.pixel.read_buffer = buffer,
        }
    }
}
