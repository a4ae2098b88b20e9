//! What is attached to a framebuffer object (4.4.2): levels of textures and renderbuffers.

use std::sync::Arc;

use super::{Framebuffer, MAX_COLOR_ATTACHMENTS};
use crate::draw::texture::TextureKind;
use crate::gl::Context;
use crate::gl::enums::*;
use crate::gl::renderbuffer::SharedRenderbuffer;
use crate::gl::texture_image::{ImageTarget, MAX_3D_TEXTURE_SIZE};
use crate::gl::texture_object::TextureHandle;

/// An image that is attached.
#[derive(Clone)]
pub(crate) enum Attachment {
    Renderbuffer { name: u32, object: SharedRenderbuffer },
    Texture(AttachedTexture),
}

/// A layer of a level of a face of a texture.
#[derive(Clone)]
pub(crate) struct AttachedTexture {
    /// GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME
    pub name: u32,
    /// The object, also after its name was deleted.
    pub handle: TextureHandle,
    pub kind: TextureKind,
    pub face: usize,
    pub level: usize,
    /// Of a 3D texture.
    pub layer: usize,
}

impl Attachment {
    /// It is the same image as another one.
    pub fn same_image(&self, other: &Attachment) -> bool {
        match (self, other) {
            (Attachment::Renderbuffer { object: a, .. }, Attachment::Renderbuffer { object: b, .. }) => Arc::ptr_eq(a, b),
            (Attachment::Texture(a), Attachment::Texture(b)) => {
                a.handle == b.handle && (a.face, a.level, a.layer) == (b.face, b.level, b.layer)
            }
            _ => false,
        }
    }
}

/// Where something is attached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum AttachmentPoint {
    Color(usize),
    Depth,
    Stencil,
    DepthStencil,
}

impl AttachmentPoint {
    /// An error for enums that name no point: GL_INVALID_OPERATION where a number is too large, as Mesa has it.
    pub fn from_enum(attachment: GLenum) -> Result<AttachmentPoint, GLenum> {
        match attachment {
            GL_DEPTH_ATTACHMENT => Ok(AttachmentPoint::Depth),
            GL_STENCIL_ATTACHMENT => Ok(AttachmentPoint::Stencil),
            GL_DEPTH_STENCIL_ATTACHMENT => Ok(AttachmentPoint::DepthStencil),
            GL_COLOR_ATTACHMENT0..=GL_COLOR_ATTACHMENT15 => {
                let index = (attachment - GL_COLOR_ATTACHMENT0) as usize;
                if index < MAX_COLOR_ATTACHMENTS { Ok(AttachmentPoint::Color(index)) } else { Err(GL_INVALID_OPERATION) }
            }
            _ => Err(GL_INVALID_ENUM),
        }
    }
}

impl Framebuffer {
    /// Attaches an image, or detaches what is there.
    pub fn attach(&mut self, point: AttachmentPoint, attachment: Option<Attachment>) {
        match point {
            AttachmentPoint::Color(index) => self.colors[index] = attachment,
            AttachmentPoint::Depth => self.depth = attachment,
            AttachmentPoint::Stencil => self.stencil = attachment,
            AttachmentPoint::DepthStencil => {
                self.depth = attachment.clone();
                self.stencil = attachment;
            }
        }
    }

    fn detach(&mut self, is_it: impl Fn(&Attachment) -> bool) {
        for slot in self.colors.iter_mut().chain([&mut self.depth, &mut self.stencil]) {
            if slot.as_ref().is_some_and(&is_it) {
                *slot = None;
            }
        }
    }
}

/// The kind and face of a texture target that a command of so many dimensions attaches.
fn checked_target(target: GLenum, dimensions: usize) -> Option<ImageTarget> {
    ImageTarget::from_enum(target).filter(|t| !t.proxy && t.dimensions() == dimensions)
}

impl Context {
    /// glFramebufferRenderbuffer
    pub fn framebuffer_renderbuffer(&mut self, target: GLenum, attachment: GLenum, renderbuffer_target: GLenum, renderbuffer: u32) {
        if self.inside_begin_end() {
            return;
        }
        let checked = self.checked_point(target, attachment).and_then(|(framebuffer, point)| {
            if renderbuffer_target != GL_RENDERBUFFER {
                return Err(GL_INVALID_ENUM);
            }
            if renderbuffer == 0 {
                return Ok((framebuffer, point, None));
            }
            let object = self.shared().renderbuffers.get(renderbuffer).cloned().ok_or(GL_INVALID_OPERATION)?;
            Ok((framebuffer, point, Some(Attachment::Renderbuffer { name: renderbuffer, object })))
        });
        self.attach_checked(checked, "glFramebufferRenderbuffer");
    }

    /// glFramebufferTexture1D
    pub fn framebuffer_texture_1d(&mut self, target: GLenum, attachment: GLenum, texture_target: GLenum, texture: u32, level: i32) {
        self.framebuffer_texture(1, target, attachment, texture_target, texture, level, 0);
    }

    /// glFramebufferTexture2D
    pub fn framebuffer_texture_2d(&mut self, target: GLenum, attachment: GLenum, texture_target: GLenum, texture: u32, level: i32) {
        self.framebuffer_texture(2, target, attachment, texture_target, texture, level, 0);
    }

    /// glFramebufferTexture3D
    pub fn framebuffer_texture_3d(
        &mut self,
        target: GLenum,
        attachment: GLenum,
        texture_target: GLenum,
        texture: u32,
        level: i32,
        z_offset: i32,
    ) {
        self.framebuffer_texture(3, target, attachment, texture_target, texture, level, z_offset);
    }

    /// glFramebufferTextureLayer: of a 3D texture, as there are no arrays.
    pub fn framebuffer_texture_layer(&mut self, target: GLenum, attachment: GLenum, texture: u32, level: i32, layer: i32) {
        if self.inside_begin_end() {
            return;
        }
        let checked = self.checked_point(target, attachment).and_then(|(framebuffer, point)| {
            if texture == 0 {
                return Ok((framebuffer, point, None));
            }
            let kind = self.shared().textures.kind(texture).ok_or(GL_INVALID_OPERATION)?;
            if kind != TextureKind::D3 {
                return Err(GL_INVALID_OPERATION);
            }
            let image = ImageTarget { kind, face: 0, proxy: false };
            self.checked_texture(image, texture, level, layer).map(|attachment| (framebuffer, point, Some(attachment)))
        });
        self.attach_checked(checked, "glFramebufferTextureLayer");
    }

    fn framebuffer_texture(
        &mut self,
        dimensions: usize,
        target: GLenum,
        attachment: GLenum,
        texture_target: GLenum,
        texture: u32,
        level: i32,
        layer: i32,
    ) {
        if self.inside_begin_end() {
            return;
        }
        let checked = self.checked_point(target, attachment).and_then(|(framebuffer, point)| {
            // Detaching ignores the other arguments.
            if texture == 0 {
                return Ok((framebuffer, point, None));
            }
            let kind = self.shared().textures.kind(texture).ok_or(GL_INVALID_OPERATION)?;
            let is_target = matches!(texture_target, GL_TEXTURE_CUBE_MAP) || ImageTarget::from_enum(texture_target).is_some();
            let image = match checked_target(texture_target, dimensions) {
                Some(image) => image,
                // A target that other commands take.
                None => return Err(if is_target { GL_INVALID_OPERATION } else { GL_INVALID_ENUM }),
            };
            if image.kind != kind {
                return Err(GL_INVALID_OPERATION);
            }
            self.checked_texture(image, texture, level, layer).map(|attachment| (framebuffer, point, Some(attachment)))
        });
        self.attach_checked(checked, "glFramebufferTexture");
    }

    fn checked_texture(&self, image: ImageTarget, texture: u32, level: i32, layer: i32) -> Result<Attachment, GLenum> {
        if level < 0 || level > image.max_size().ilog2() as i32 {
            return Err(GL_INVALID_VALUE);
        }
        if image.kind == TextureKind::D3 && !(0..MAX_3D_TEXTURE_SIZE).contains(&layer) {
            return Err(GL_INVALID_VALUE);
        }
        let handle = self.shared().textures.handle(texture).ok_or(GL_INVALID_OPERATION)?;
        Ok(Attachment::Texture(AttachedTexture {
            name: texture,
            handle,
            kind: image.kind,
            face: image.face,
            level: level as usize,
            layer: layer as usize,
        }))
    }

    /// The bound framebuffer object and the attachment point; the window has none that could be changed.
    fn checked_point(&self, target: GLenum, attachment: GLenum) -> Result<(u32, AttachmentPoint), GLenum> {
        let name = self.fbo.bound(target).ok_or(GL_INVALID_ENUM)?;
        if name == 0 {
            return Err(GL_INVALID_OPERATION);
        }
        Ok((name, AttachmentPoint::from_enum(attachment)?))
    }

    fn attach_checked(&mut self, checked: Result<(u32, AttachmentPoint, Option<Attachment>), GLenum>, what: &str) {
        match checked {
            Ok((framebuffer, point, attachment)) => {
                self.framebuffer_changes();
                if let Some(framebuffer) = self.fbo.get_mut(framebuffer) {
                    framebuffer.attach(point, attachment);
                }
                self.shared().textures.drop_unused();
            }
            Err(error) => self.set_error(error, what),
        }
    }

    /// A renderbuffer was deleted: the bound framebuffers let go of it (4.4.2.2).
    pub(crate) fn detach_renderbuffer(&mut self, renderbuffer: &SharedRenderbuffer) {
        self.detach(|a| matches!(a, Attachment::Renderbuffer { object, .. } if Arc::ptr_eq(object, renderbuffer)));
    }

    /// A texture is about to be deleted: the same.
    pub(crate) fn detach_texture(&mut self, texture: &TextureHandle) {
        self.detach(|a| matches!(a, Attachment::Texture(a) if a.handle == *texture));
    }

    fn detach(&mut self, is_it: impl Fn(&Attachment) -> bool) {
        for name in [self.fbo.draw, self.fbo.read] {
            if self.fbo.get(name).is_some_and(|f| f.attachments().any(&is_it)) {
                self.framebuffer_changes();
                if let Some(framebuffer) = self.fbo.get_mut(name) {
                    framebuffer.detach(&is_it);
                }
            }
        }
    }
}
