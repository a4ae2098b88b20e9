//! Framebuffer objects (ARB_framebuffer_object; section numbers are those of its changes to chapter 4): names, binding, and which
//! buffers are drawn to and read from. They belong to one context; what is attached to them is shared.

use super::enums::*;
use super::object_names::ObjectNames;
use super::renderbuffer::SharedRenderbuffer;
use super::{Context, dirty};

mod attachments;
mod buffers;
mod completeness;
mod image_format;
mod images;
mod queries;
mod read;
mod target;
#[cfg(test)]
mod tests;

pub(crate) use attachments::{Attachment, AttachmentPoint};
pub(crate) use image_format::ImageFormat;
pub(crate) use read::Aspect;
pub(crate) use target::View;

/// GL_MAX_COLOR_ATTACHMENTS
pub const MAX_COLOR_ATTACHMENTS: usize = 8;
/// GL_MAX_DRAW_BUFFERS
pub const MAX_DRAW_BUFFERS: usize = 8;

/// A framebuffer object.
#[derive(Clone)]
pub(crate) struct Framebuffer {
    pub colors: [Option<Attachment>; MAX_COLOR_ATTACHMENTS],
    pub depth: Option<Attachment>,
    pub stencil: Option<Attachment>,
    /// GL_NONE or GL_COLOR_ATTACHMENTi.
    pub draw_buffers: [GLenum; MAX_DRAW_BUFFERS],
    /// The same.
    pub read_buffer: GLenum,
}

impl Default for Framebuffer {
    fn default() -> Framebuffer {
        let mut draw_buffers = [GL_NONE; MAX_DRAW_BUFFERS];
        draw_buffers[0] = GL_COLOR_ATTACHMENT0;
        Framebuffer { colors: Default::default(), depth: None, stencil: None, draw_buffers, read_buffer: GL_COLOR_ATTACHMENT0 }
    }
}

impl Framebuffer {
    /// The attachments that are there.
    pub fn attachments(&self) -> impl Iterator<Item = &Attachment> {
        self.colors.iter().chain([&self.depth, &self.stencil]).flatten()
    }

    /// The attachment that a draw or read buffer names.
    pub fn color_of(&self, buffer: GLenum) -> Option<&Attachment> {
        self.colors.get(buffer.checked_sub(GL_COLOR_ATTACHMENT0)? as usize)?.as_ref()
    }
}

/// What a context knows about framebuffer objects.
#[derive(Default)]
pub(crate) struct FramebufferState {
    objects: ObjectNames<Framebuffer>,
    /// GL_DRAW_FRAMEBUFFER_BINDING; 0 is the window.
    pub draw: u32,
    /// GL_READ_FRAMEBUFFER_BINDING
    pub read: u32,
    /// GL_RENDERBUFFER_BINDING
    pub renderbuffer: Option<(u32, SharedRenderbuffer)>,
    /// Where draws go while `draw` is not 0.
    pub view: View,
}

impl FramebufferState {
    /// The object of a name; `None` for 0 and for what was never bound.
    pub fn get(&self, name: u32) -> Option<&Framebuffer> {
        self.objects.get(name)
    }

    pub fn get_mut(&mut self, name: u32) -> Option<&mut Framebuffer> {
        self.objects.get_mut(name)
    }

    /// The name that a target of glBindFramebuffer and its like stands for.
    pub fn bound(&self, target: GLenum) -> Option<u32> {
        match target {
            GL_FRAMEBUFFER | GL_DRAW_FRAMEBUFFER => Some(self.draw),
            GL_READ_FRAMEBUFFER => Some(self.read),
            _ => None,
        }
    }
}

impl Context {
    /// To be called before what the bound framebuffers are made of changes: what was recorded so far is drawn into what they are now.
    pub(crate) fn framebuffer_changes(&mut self) {
        self.flush_batch();
        self.fbo.view.stale = true;
        self.dirty = dirty::ALL;
    }

    /// glGenFramebuffers: `n` unused names, none after an error.
    pub fn gen_framebuffers(&mut self, n: i32) -> Vec<u32> {
        if self.inside_begin_end() {
            return Vec::new();
        }
        if n < 0 {
            self.set_error(GL_INVALID_VALUE, "glGenFramebuffers");
            return Vec::new();
        }
        (0..n).map(|_| self.fbo.objects.generate()).collect()
    }

    /// glDeleteFramebuffers. `n` is the count as given. Instead of a bound one the window is bound.
    pub fn delete_framebuffers(&mut self, n: i32, names: &[u32]) {
        if self.inside_begin_end() {
            return;
        }
        if n < 0 {
            return self.set_error(GL_INVALID_VALUE, "glDeleteFramebuffers");
        }
        for &name in names.iter().filter(|&&name| name != 0) {
            if self.fbo.draw == name {
                self.bind_framebuffers(Some(0), None);
            }
            if self.fbo.read == name {
                self.bind_framebuffers(None, Some(0));
            }
            self.fbo.objects.remove(name);
        }
    }

    /// glBindFramebuffer: the name must come from glGenFramebuffers.
    pub fn bind_framebuffer(&mut self, target: GLenum, name: u32) {
        self.bind_framebuffer_of(target, name, false);
    }

    /// glBindFramebufferEXT: any name makes an object.
    pub fn bind_framebuffer_ext(&mut self, target: GLenum, name: u32) {
        self.bind_framebuffer_of(target, name, true);
    }

    fn bind_framebuffer_of(&mut self, target: GLenum, name: u32, any_name: bool) {
        if self.inside_begin_end() {
            return;
        }
        let (draw, read) = match target {
            GL_FRAMEBUFFER => (Some(name), Some(name)),
            GL_DRAW_FRAMEBUFFER => (Some(name), None),
            GL_READ_FRAMEBUFFER => (None, Some(name)),
            _ => return self.set_error(GL_INVALID_ENUM, "glBindFramebuffer: target"),
        };
        if name != 0 {
            if !any_name && !self.fbo.objects.is_name(name) {
                return self.set_error(GL_INVALID_OPERATION, "glBindFramebuffer of a name that was not generated");
            }
            self.fbo.objects.bind(name);
        }
        self.bind_framebuffers(draw, read);
    }

    fn bind_framebuffers(&mut self, draw: Option<u32>, read: Option<u32>) {
        if let Some(name) = draw {
            // Also where it was bound before: that is how changes that other contexts made come into effect (appendix D of GL 3.0).
            self.framebuffer_changes();
            self.fbo.draw = name;
        }
        self.fbo.read = read.unwrap_or(self.fbo.read);
    }

    /// glIsFramebuffer: true once the name was bound.
    pub fn is_framebuffer(&mut self, name: u32) -> bool {
        !self.inside_begin_end() && self.fbo.get(name).is_some()
    }
}
