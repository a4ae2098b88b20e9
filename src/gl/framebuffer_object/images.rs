//! From attachments to images and their pixels.

use super::{Attachment, ImageFormat};
use crate::device::SharedPlane;
use crate::gl::Context;
use crate::gl::renderbuffer::{self, new_plane};

/// What is to be known about an attached image.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct AttachedImage {
    pub size: [u32; 2],
    pub format: ImageFormat,
    /// 0 for images that are not multisampled.
    pub samples: u32,
}

impl Context {
    /// The image behind an attachment. `None` where there is none: a level or layer that is not there, no storage.
    pub(super) fn attached_image(&self, attachment: &Attachment) -> Option<AttachedImage> {
        match attachment {
            Attachment::Renderbuffer { object, .. } => {
                let renderbuffer = renderbuffer::lock(object);
                let storage = renderbuffer.storage.as_ref()?;
                Some(AttachedImage { size: storage.size, format: storage.format, samples: storage.samples })
            }
            Attachment::Texture(at) => {
                let mut shared = self.shared();
                let image = shared.textures.of_handle(at.name, &at.handle)?.image(at.face, at.level)?;
                let [width, height, depth] = image.size;
                let format = ImageFormat::of_texture(image.format);
                (at.layer < depth as usize).then_some(AttachedImage { size: [width, height], format, samples: 0 })
            }
        }
    }

    /// The pixels behind an attachment, made when they are first wanted.
    pub(super) fn attached_plane(&self, attachment: &Attachment) -> Option<SharedPlane> {
        let device = &*self.device;
        match attachment {
            Attachment::Renderbuffer { object, .. } => Some(renderbuffer::lock(object).storage.as_mut()?.plane(device)),
            Attachment::Texture(at) => {
                let mut shared = self.shared();
                let object = shared.textures.of_handle(at.name, &at.handle)?;
                object.plane([at.face, at.level, at.layer], |size, format| new_plane(device, size, 1, format))
            }
        }
    }
}
