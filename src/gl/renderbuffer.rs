//! Renderbuffers (ARB_framebuffer_object, 4.4.2): names, storage, queries.

use std::sync::{Arc, Mutex, MutexGuard};

use super::Context;
use super::enums::*;
use super::framebuffer_object::ImageFormat;
use super::object_names::ObjectNames;
use crate::device::{Device, SharedPlane, plane, samples};

/// GL_MAX_RENDERBUFFER_SIZE
pub const MAX_RENDERBUFFER_SIZE: i32 = 16384;
/// Most bytes of one renderbuffer; larger ones are refused with GL_OUT_OF_MEMORY.
const MAX_BYTES: u64 = 1 << 30;

/// What glRenderbufferStorage asked for.
#[derive(Clone)]
pub(crate) struct RenderbufferStorage {
    /// Columns and rows.
    pub size: [u32; 2],
    /// As it was given.
    pub internal_format: GLenum,
    /// What it stands for.
    pub format: ImageFormat,
    /// 0 for storage that is not multisampled, else 2, 4, 8 or 16.
    pub samples: u32,
    /// The pixels, once something wanted them.
    plane: Option<SharedPlane>,
}

impl RenderbufferStorage {
    /// The pixels, made when they are first wanted.
    pub fn plane(&mut self, device: &dyn Device) -> SharedPlane {
        self.plane.get_or_insert_with(|| new_plane(device, self.size, self.samples.max(1), self.format)).clone()
    }
}

/// A plane whose missing components have the values that they read as.
pub(crate) fn new_plane(device: &dyn Device, size: [u32; 2], samples: u32, format: ImageFormat) -> SharedPlane {
    let new = device.plane(size, samples, format.plane);
    let blank = format.blank();
    if blank != [0; 2] {
        let words = format.plane.words();
        plane::lock(&new).rows_mut().chunks_exact_mut(words).for_each(|pixel| pixel.copy_from_slice(&blank[..words]));
    }
    new
}

/// A renderbuffer; without storage at first.
#[derive(Default)]
pub struct Renderbuffer {
    pub(crate) storage: Option<RenderbufferStorage>,
}

/// A renderbuffer lives as long as its name or an attachment does.
pub type SharedRenderbuffer = Arc<Mutex<Renderbuffer>>;

/// Locks a renderbuffer; no command leaves one half changed.
pub(crate) fn lock(renderbuffer: &SharedRenderbuffer) -> MutexGuard<'_, Renderbuffer> {
    renderbuffer.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
}

/// The renderbuffers of a share group.
#[derive(Default)]
pub struct RenderbufferTable(ObjectNames<SharedRenderbuffer>);

impl RenderbufferTable {
    /// The renderbuffer of a name that was bound before.
    pub(crate) fn get(&self, name: u32) -> Option<&SharedRenderbuffer> {
        self.0.get(name)
    }
}

impl Context {
    /// glGenRenderbuffers: `n` unused names, none after an error.
    pub fn gen_renderbuffers(&mut self, n: i32) -> Vec<u32> {
        if self.inside_begin_end() {
            return Vec::new();
        }
        if n < 0 {
            self.set_error(GL_INVALID_VALUE, "glGenRenderbuffers");
            return Vec::new();
        }
        let mut shared = self.shared();
        (0..n).map(|_| shared.renderbuffers.0.generate()).collect()
    }

    /// glDeleteRenderbuffers. `n` is the count as given. What is attached to a bound framebuffer is detached; other framebuffers keep the
    /// renderbuffer alive.
    pub fn delete_renderbuffers(&mut self, n: i32, names: &[u32]) {
        if self.inside_begin_end() {
            return;
        }
        if n < 0 {
            return self.set_error(GL_INVALID_VALUE, "glDeleteRenderbuffers");
        }
        for &name in names.iter().filter(|&&name| name != 0) {
            let removed = self.shared().renderbuffers.0.remove(name);
            if self.fbo.renderbuffer.as_ref().is_some_and(|(bound, _)| *bound == name) {
                self.fbo.renderbuffer = None;
            }
            if let Some(object) = removed {
                self.detach_renderbuffer(&object);
            }
        }
    }

    /// glBindRenderbuffer: the name must come from glGenRenderbuffers.
    pub fn bind_renderbuffer(&mut self, target: GLenum, name: u32) {
        self.bind_renderbuffer_of(target, name, false);
    }

    /// glBindRenderbufferEXT: any name makes an object.
    pub fn bind_renderbuffer_ext(&mut self, target: GLenum, name: u32) {
        self.bind_renderbuffer_of(target, name, true);
    }

    fn bind_renderbuffer_of(&mut self, target: GLenum, name: u32, any_name: bool) {
        if self.inside_begin_end() {
            return;
        }
        if target != GL_RENDERBUFFER {
            return self.set_error(GL_INVALID_ENUM, "glBindRenderbuffer: target");
        }
        if name == 0 {
            self.fbo.renderbuffer = None;
            return;
        }
        let mut shared = self.shared();
        let names = &mut shared.renderbuffers.0;
        let object = (any_name || names.is_name(name)).then(|| names.bind(name).clone());
        drop(shared);
        match object {
            Some(object) => self.fbo.renderbuffer = Some((name, object)),
            None => self.set_error(GL_INVALID_OPERATION, "glBindRenderbuffer of a name that was not generated"),
        }
    }

    /// glIsRenderbuffer: true once the name was bound.
    pub fn is_renderbuffer(&mut self, name: u32) -> bool {
        !self.inside_begin_end() && self.shared().renderbuffers.get(name).is_some()
    }

    /// glRenderbufferStorage
    pub fn renderbuffer_storage(&mut self, target: GLenum, internal_format: GLenum, width: i32, height: i32) {
        self.renderbuffer_storage_multisample(target, 0, internal_format, width, height);
    }

    /// glRenderbufferStorageMultisample. The next number of samples that is supported serves.
    pub fn renderbuffer_storage_multisample(&mut self, target: GLenum, samples: i32, internal_format: GLenum, width: i32, height: i32) {
        if self.inside_begin_end() {
            return;
        }
        match self.checked_storage(target, samples, internal_format, [width, height]) {
            Ok((object, storage)) => {
                // What was drawn goes to the old storage.
                self.framebuffer_changes();
                lock(&object).storage = Some(storage);
            }
            Err(error) => self.set_error(error, "glRenderbufferStorage"),
        }
    }

    fn checked_storage(
        &self,
        target: GLenum,
        samples: i32,
        internal_format: GLenum,
        size: [i32; 2],
    ) -> Result<(SharedRenderbuffer, RenderbufferStorage), GLenum> {
        if target != GL_RENDERBUFFER {
            return Err(GL_INVALID_ENUM);
        }
        let format = ImageFormat::of_renderbuffer(internal_format).ok_or(GL_INVALID_ENUM)?;
        if size.iter().any(|n| !(0..=MAX_RENDERBUFFER_SIZE).contains(n)) {
            return Err(GL_INVALID_VALUE);
        }
        let samples = match u32::try_from(samples).map_err(|_| GL_INVALID_VALUE)? {
            0 => 0,
            wish => samples::supported(wish.max(2)).ok_or(GL_INVALID_VALUE)?,
        };
        let (_, object) = self.fbo.renderbuffer.as_ref().ok_or(GL_INVALID_OPERATION)?;
        let size = size.map(|n| n as u32);
        let bytes = u64::from(size[0]) * u64::from(size[1]) * u64::from(samples.max(1)) * format.plane.words() as u64 * 4;
        if bytes > MAX_BYTES {
            return Err(GL_OUT_OF_MEMORY);
        }
        Ok((object.clone(), RenderbufferStorage { size, internal_format, format, samples, plane: None }))
    }

    /// glGetRenderbufferParameteriv; `None` after an error.
    pub fn get_renderbuffer_parameter(&mut self, target: GLenum, pname: GLenum) -> Option<i32> {
        if self.inside_begin_end() {
            return None;
        }
        let value = match &self.fbo.renderbuffer {
            _ if target != GL_RENDERBUFFER => Err(GL_INVALID_ENUM),
            None => Err(GL_INVALID_OPERATION),
            Some((_, object)) => parameter(lock(object).storage.as_ref(), pname).ok_or(GL_INVALID_ENUM),
        };
        value.map_err(|error| self.set_error(error, "glGetRenderbufferParameteriv")).ok()
    }
}

fn parameter(storage: Option<&RenderbufferStorage>, pname: GLenum) -> Option<i32> {
    let size = storage.map_or([0; 2], |s| s.size);
    let bits = storage.map_or([0; 6], |s| s.format.bits);
    Some(match pname {
        GL_RENDERBUFFER_WIDTH => size[0] as i32,
        GL_RENDERBUFFER_HEIGHT => size[1] as i32,
        // The initial format of table 6.23.
        GL_RENDERBUFFER_INTERNAL_FORMAT => storage.map_or(GL_RGBA, |s| s.internal_format) as i32,
        GL_RENDERBUFFER_SAMPLES => storage.map_or(0, |s| s.samples) as i32,
        GL_RENDERBUFFER_RED_SIZE..=GL_RENDERBUFFER_STENCIL_SIZE => i32::from(bits[(pname - GL_RENDERBUFFER_RED_SIZE) as usize]),
        _ => return None,
    })
}
