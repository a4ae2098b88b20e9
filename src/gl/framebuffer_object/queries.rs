//! Queries of framebuffers (6.1): attachments, bindings, what the bound buffers store.

use super::{Attachment, AttachmentPoint, Framebuffer, MAX_COLOR_ATTACHMENTS, MAX_DRAW_BUFFERS};
use crate::device::samples::MAX_SAMPLES;
use crate::device::{ColorFormat, DepthFormat};
use crate::draw::texture::TextureKind;
use crate::gl::Context;
use crate::gl::enums::*;
use crate::gl::query::Value;

/// The bits of an attachment's image: those of the parts that `point` names.
fn size_of(pname: GLenum, bits: [u8; 6]) -> i32 {
    i32::from(bits[(pname - GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE) as usize])
}

impl Framebuffer {
    /// What is attached at a point. An error where depth and stencil are asked for at once and differ.
    fn at(&self, point: AttachmentPoint) -> Result<Option<&Attachment>, GLenum> {
        match point {
            AttachmentPoint::Color(index) => Ok(self.colors[index].as_ref()),
            AttachmentPoint::Depth => Ok(self.depth.as_ref()),
            AttachmentPoint::Stencil => Ok(self.stencil.as_ref()),
            AttachmentPoint::DepthStencil => match (&self.depth, &self.stencil) {
                (None, None) => Ok(None),
                (Some(depth), Some(stencil)) if depth.same_image(stencil) => Ok(Some(depth)),
                _ => Err(GL_INVALID_OPERATION),
            },
        }
    }
}

impl Context {
    /// glGetFramebufferAttachmentParameteriv; `None` after an error.
    pub fn get_framebuffer_attachment_parameter(&mut self, target: GLenum, attachment: GLenum, pname: GLenum) -> Option<i32> {
        if self.inside_begin_end() {
            return None;
        }
        let value = match self.fbo.bound(target) {
            None => Err(GL_INVALID_ENUM),
            Some(0) => self.window_parameter(attachment, pname),
            Some(name) => self.attachment_parameter(name, attachment, pname),
        };
        value.map_err(|error| self.set_error(error, "glGetFramebufferAttachmentParameteriv")).ok()
    }

    fn attachment_parameter(&self, name: u32, attachment: GLenum, pname: GLenum) -> Result<i32, GLenum> {
        let framebuffer = self.fbo.get(name).ok_or(GL_INVALID_OPERATION)?;
        let point = AttachmentPoint::from_enum(attachment)?;
        let Some(attached) = framebuffer.at(point)? else {
            return match pname {
                GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE => Ok(GL_NONE as i32),
                GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME => Ok(0),
                _ if is_parameter(pname) => Err(GL_INVALID_OPERATION),
                _ => Err(GL_INVALID_ENUM),
            };
        };
        let texture = match attached {
            Attachment::Texture(texture) => Some(texture),
            Attachment::Renderbuffer { .. } => None,
        };
        let value = match (pname, attached) {
            (GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE, _) => texture.map_or(GL_RENDERBUFFER, |_| GL_TEXTURE),
            (GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, Attachment::Renderbuffer { name, .. }) => *name,
            (GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME, Attachment::Texture(texture)) => texture.name,
            (GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL, _) => texture.ok_or(GL_INVALID_ENUM)?.level as u32,
            (GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER, _) => texture.ok_or(GL_INVALID_ENUM)?.layer as u32,
            (GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE, _) => {
                let texture = texture.ok_or(GL_INVALID_ENUM)?;
                if texture.kind == TextureKind::Cube { GL_TEXTURE_CUBE_MAP_POSITIVE_X + texture.face as u32 } else { 0 }
            }
            (GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE..=GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE, _) => {
                return Ok(size_of(pname, self.attached_image(attached).map_or([0; 6], |image| image.format.bits)));
            }
            (GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE, _) => match point {
                AttachmentPoint::DepthStencil => return Err(GL_INVALID_OPERATION),
                AttachmentPoint::Stencil => GL_INDEX,
                _ if self.attached_image(attached).is_some_and(|image| image.format.has_float_depth()) => GL_FLOAT,
                _ => GL_UNSIGNED_NORMALIZED,
            },
            (GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING, _) => GL_LINEAR,
            _ => return Err(GL_INVALID_ENUM),
        };
        Ok(value as i32)
    }

    /// The window's buffers have names of their own.
    fn window_parameter(&self, attachment: GLenum, pname: GLenum) -> Result<i32, GLenum> {
        let bits = self.buffer_bits();
        let there = match attachment {
            GL_FRONT_LEFT | GL_BACK_LEFT => true,
            GL_FRONT_RIGHT | GL_BACK_RIGHT | GL_AUX0..=GL_AUX3 => false,
            GL_DEPTH => bits[4] > 0,
            GL_STENCIL => bits[5] > 0,
            _ if AttachmentPoint::from_enum(attachment).is_ok() => return Err(GL_INVALID_OPERATION),
            _ => return Err(GL_INVALID_ENUM),
        };
        // Depth and stencil are one image.
        let mask = if matches!(attachment, GL_DEPTH | GL_STENCIL) { 0b110000 } else { 0b1111 };
        let value = match pname {
            GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE => {
                if there {
                    GL_FRAMEBUFFER_DEFAULT
                } else {
                    GL_NONE
                }
            }
            GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME => 0,
            _ if !is_parameter(pname) => return Err(GL_INVALID_ENUM),
            _ if !there => return Err(GL_INVALID_OPERATION),
            GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE..=GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE => {
                return Ok(size_of(pname, std::array::from_fn(|k| if mask >> k & 1 != 0 { bits[k] } else { 0 })));
            }
            GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE if attachment == GL_STENCIL => GL_INDEX,
            GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE => GL_UNSIGNED_NORMALIZED,
            GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING => GL_LINEAR,
            _ => return Err(GL_INVALID_ENUM),
        };
        Ok(value as i32)
    }

    /// Bits of red, green, blue, alpha, depth and stencil of the window.
    fn buffer_bits(&self) -> [u8; 6] {
        let [r, g, b, a] = match self.config.color {
            ColorFormat::Rgba8 => [8, 8, 8, 8],
            ColorFormat::Rgbx8 => [8, 8, 8, 0],
            ColorFormat::Rgb565 => [5, 6, 5, 0],
            ColorFormat::Rgba16 => [16; 4],
            ColorFormat::Rgba32f => [32; 4],
        };
        [r, g, b, a, self.config.depth_bits as u8, self.config.stencil_bits as u8]
    }

    /// The same of the draw framebuffer, with its samples. Of an incomplete one nothing is known.
    fn draw_bits(&self) -> ([u8; 6], u32) {
        let Some(framebuffer) = self.fbo.get(self.fbo.draw) else { return (self.buffer_bits(), self.window_samples()) };
        if self.framebuffer_status(self.fbo.draw) != GL_FRAMEBUFFER_COMPLETE {
            return ([0; 6], 0);
        }
        let image = |attachment: Option<&Attachment>| attachment.and_then(|a| self.attached_image(a));
        let color = image(framebuffer.draw_buffers.iter().find_map(|&buffer| framebuffer.color_of(buffer)));
        let color = color.or_else(|| image(framebuffer.colors.iter().flatten().next())).map_or([0; 6], |i| i.format.bits);
        let depth = image(framebuffer.depth.as_ref()).map_or(0, |i| i.format.bits[4]);
        let stencil = image(framebuffer.stencil.as_ref()).map_or(0, |i| i.format.bits[5]);
        let samples = framebuffer.attachments().find_map(|a| self.attached_image(a)).map_or(0, |i| i.samples);
        ([color[0], color[1], color[2], color[3], depth, stencil], samples)
    }

    /// GL_SAMPLES of the window.
    pub(crate) fn window_samples(&self) -> u32 {
        if self.config.samples > 1 { self.config.samples } else { 0 }
    }

    /// Draw buffer `index` of the draw framebuffer.
    fn draw_buffer_name(&self, index: usize) -> GLenum {
        self.fbo.get(self.fbo.draw).map_or(self.state.color_buffer.draw_buffers, |f| f.draw_buffers)[index]
    }

    /// What glGet says about framebuffers.
    pub(crate) fn query_framebuffer(&self, pname: GLenum) -> Option<Value> {
        let window = self.fbo.draw == 0;
        Some(match pname {
            GL_DRAW_FRAMEBUFFER_BINDING => Value::int(self.fbo.draw),
            GL_READ_FRAMEBUFFER_BINDING => Value::int(self.fbo.read),
            GL_RENDERBUFFER_BINDING => Value::int(self.fbo.renderbuffer.as_ref().map_or(0, |(name, _)| *name)),
            GL_MAX_COLOR_ATTACHMENTS => Value::int(MAX_COLOR_ATTACHMENTS as i64),
            GL_MAX_DRAW_BUFFERS => Value::int(MAX_DRAW_BUFFERS as i64),
            GL_MAX_SAMPLES => Value::int(MAX_SAMPLES),
            GL_DRAW_BUFFER => Value::int(self.draw_buffer_name(0)),
            GL_DRAW_BUFFER0..=GL_DRAW_BUFFER7 => Value::int(self.draw_buffer_name((pname - GL_DRAW_BUFFER0) as usize)),
            GL_READ_BUFFER => Value::int(self.fbo.get(self.fbo.read).map_or(self.state.pixel.read_buffer, |f| f.read_buffer)),
            GL_RED_BITS..=GL_STENCIL_BITS => Value::int(self.draw_bits().0[(pname - GL_RED_BITS) as usize]),
            GL_SAMPLES => Value::int(self.draw_bits().1),
            GL_SAMPLE_BUFFERS => Value::int(u32::from(self.draw_bits().1 > 0)),
            GL_ACCUM_RED_BITS..=GL_ACCUM_ALPHA_BITS => Value::int(if window { self.config.accum_bits } else { 0 }),
            GL_DOUBLEBUFFER => Value::bool(false),
            _ => return None,
        })
    }

    /// Steps of the depth buffer that is drawn to.
    pub fn depth_steps(&self) -> f32 {
        if self.draw_format().depth == DepthFormat::D16 { 65535.0 } else { 16777215.0 }
    }
}

/// A name that glGetFramebufferAttachmentParameteriv knows.
fn is_parameter(pname: GLenum) -> bool {
    matches!(
        pname,
        GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE..=GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER
            | GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING..=GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE
    )
}
