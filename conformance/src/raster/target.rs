//! Somewhere to draw without a window: OSMesa's buffer, or a framebuffer object on EGL.

use std::ffi::c_void;
use std::ptr::{null, null_mut};
use std::rc::Rc;

use super::gl::number::*;
use super::gl::{Egl, EglPlatforms, Framebuffers, Gl, OsMesa, open, proc_address, symbol};

/// What finds a function by its name.
pub type Find = Box<dyn Fn(&str) -> *const c_void>;

/// An implementation of OpenGL that was opened.
pub struct Driver {
    /// What finds its functions.
    pub find: Find,
    osmesa: Option<Rc<OsMesa>>,
}

/// Where a scene is drawn.
pub struct Target {
    /// Columns and rows.
    pub size: [u32; 2],
    /// Samples a pixel.
    pub samples: u32,
    /// OSMesa's context and the pixels that it has a pointer to.
    context: Option<(Rc<OsMesa>, *mut c_void, Vec<u32>)>,
    /// Framebuffer objects to draw in and to resolve into.
    objects: Option<(Framebuffers, [u32; 2])>,
}

impl Driver {
    /// A library with the OSMesa interface.
    pub fn osmesa(path: &str) -> Result<Driver, String> {
        let library = open(path)?;
        let osmesa = OsMesa::load(&|name| symbol(library, name))?;
        let find = osmesa.find;
        let find = move |name: &str| {
            let address = symbol(library, name);
            if address.is_null() { proc_address(find, name) } else { address }
        };
        Ok(Driver { find: Box::new(find), osmesa: Some(Rc::new(osmesa)) })
    }

    /// EGL on the first device that has OpenGL, with a context that stays current.
    pub fn egl() -> Result<Driver, String> {
        let library = open("libEGL.so.1")?;
        let egl = Egl::load(&|name| symbol(library, name))?;
        let platforms = EglPlatforms::load(&|name| proc_address(egl.find, name))?;
        let display = egl_displays(&platforms).into_iter().find(|d| current(&egl, *d));
        display.ok_or("no EGL display has an OpenGL context without a surface")?;
        let gl = ["libOpenGL.so.0", "libGL.so.1"].into_iter().find_map(|name| open(name).ok());
        let find = move |name: &str| {
            let address = gl.map_or(null(), |gl| symbol(gl, name));
            if address.is_null() { proc_address(egl.find, name) } else { address }
        };
        Ok(Driver { find: Box::new(find), osmesa: None })
    }

    /// It is EGL: there may be a device with memory and a clock of its own.
    pub fn is_egl(&self) -> bool {
        self.osmesa.is_none()
    }

    /// A target of a size; makes a context current where there is none yet.
    pub fn target(&self, size: [u32; 2], samples: u32) -> Result<Target, String> {
        let context = self.osmesa.as_ref().map(|osmesa| osmesa_context(osmesa, size)).transpose()?;
        let mut target = Target { size, samples, context, objects: None };
        if samples == 1 && self.osmesa.is_some() {
            return Ok(target);
        }
        target.objects = Some(self.objects(size, samples)?);
        Ok(target)
    }

    fn objects(&self, size: [u32; 2], samples: u32) -> Result<(Framebuffers, [u32; 2]), String> {
        let gl = Gl::load(&*self.find)?;
        let fb = Framebuffers::load(&*self.find)?;
        let most = gl.integer(MAX_SAMPLES);
        if samples as i32 > most.max(1) {
            return Err(format!("at most {most} samples a pixel"));
        }
        let mut names = [0; 2];
        for (name, samples) in names.iter_mut().zip([samples, 1]) {
            *name = framebuffer(&fb, size, samples)?;
        }
        // SAFETY: a context is current.
        unsafe { (fb.bind)(FRAMEBUFFER, names[0]) };
        let got = gl.integer(SAMPLES).max(1) as u32;
        if got != samples { Err(format!("{got} samples a pixel instead of {samples}")) } else { Ok((fb, names)) }
    }
}

fn osmesa_context(osmesa: &Rc<OsMesa>, size: [u32; 2]) -> Result<(Rc<OsMesa>, *mut c_void, Vec<u32>), String> {
    let mut buffer = vec![0u32; size[0] as usize * size[1] as usize];
    // SAFETY: the buffer lives as long as the context, see `Target`; no other context of this process is current.
    unsafe {
        let context = (osmesa.create)(RGBA, 24, 8, 0, null_mut());
        if context.is_null() {
            return Err("OSMesa made no context".into());
        }
        let made = (osmesa.make_current)(context, buffer.as_mut_ptr().cast(), UNSIGNED_BYTE, size[0] as i32, size[1] as i32);
        if made != 0 { Ok((osmesa.clone(), context, buffer)) } else { Err("OSMesaMakeCurrent failed".into()) }
    }
}

/// A complete framebuffer object with colour, depth and stencil, bound.
fn framebuffer(fb: &Framebuffers, size: [u32; 2], samples: u32) -> Result<u32, String> {
    let (mut name, mut buffers) = (0, [0; 2]);
    // SAFETY: a context is current; the names are as many as asked for.
    let status = unsafe {
        (fb.generate)(1, &mut name);
        if name == 0 {
            return Err("no framebuffer objects".into());
        }
        (fb.bind)(FRAMEBUFFER, name);
        (fb.generate_buffers)(2, buffers.as_mut_ptr());
        for (buffer, (format, point)) in buffers.into_iter().zip([(RGBA8, COLOR_ATTACHMENT0), (DEPTH24_STENCIL8, DEPTH_STENCIL_ATTACHMENT)])
        {
            (fb.bind_buffer)(RENDERBUFFER, buffer);
            (fb.storage)(RENDERBUFFER, if samples > 1 { samples as i32 } else { 0 }, format, size[0] as i32, size[1] as i32);
            (fb.attach)(FRAMEBUFFER, point, RENDERBUFFER, buffer);
        }
        (fb.status)(FRAMEBUFFER)
    };
    if status == FRAMEBUFFER_COMPLETE { Ok(name) } else { Err(format!("a framebuffer object is incomplete ({status:#x})")) }
}

fn egl_displays(platforms: &EglPlatforms) -> Vec<*mut c_void> {
    let (mut devices, mut count) = ([null_mut(); 16], 0);
    // SAFETY: room for as many devices as is said.
    unsafe {
        (platforms.devices)(16, devices.as_mut_ptr(), &mut count);
        let mut displays: Vec<_> =
            devices[..count.clamp(0, 16) as usize].iter().map(|d| (platforms.display)(EGL_PLATFORM_DEVICE, *d, null())).collect();
        displays.push((platforms.display)(EGL_PLATFORM_SURFACELESS, null_mut(), null()));
        displays.retain(|d| !d.is_null());
        displays
    }
}

/// Makes an OpenGL context of a display current, without a surface.
fn current(egl: &Egl, display: *mut c_void) -> bool {
    let wanted = [EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE].map(|n| n as i32);
    let (mut config, mut count) = (null_mut(), 0);
    // SAFETY: the display comes from EGL, lists end with EGL_NONE.
    unsafe {
        if (egl.initialize)(display, null_mut(), null_mut()) == 0 || (egl.bind_api)(EGL_OPENGL_API) == 0 {
            return false;
        }
        (egl.choose_config)(display, wanted.as_ptr(), &mut config, 1, &mut count);
        let context = (egl.create_context)(display, if count > 0 { config } else { null_mut() }, null_mut(), null());
        !context.is_null() && (egl.make_current)(display, null_mut(), null_mut(), context) != 0
    }
}

impl Drop for Target {
    fn drop(&mut self) {
        if let Some((osmesa, context, _)) = &self.context {
            // SAFETY: the context is this target's own and goes before its pixels do.
            unsafe {
                (osmesa.make_current)(null_mut(), null_mut(), 0, 0, 0);
                (osmesa.destroy)(*context);
            }
        }
    }
}

impl Target {
    /// Resolves, where there is more than one sample a pixel.
    pub fn resolve(&self) {
        let Some((fb, [from, to])) = &self.objects else { return };
        let [w, h] = self.size.map(|s| s as i32);
        if self.samples > 1 {
            // SAFETY: a context is current, and both objects are complete.
            unsafe {
                (fb.bind)(READ_FRAMEBUFFER, *from);
                (fb.bind)(DRAW_FRAMEBUFFER, *to);
                (fb.blit)(0, 0, w, h, 0, 0, w, h, COLOR_BUFFER_BIT, NEAREST);
                (fb.bind)(FRAMEBUFFER, *from);
            }
        }
    }

    /// RGBA8, bottom row first.
    pub fn pixels(&self, gl: &Gl) -> Vec<u32> {
        let mut pixels = vec![0u32; self.size[0] as usize * self.size[1] as usize];
        // SAFETY: a context is current; the memory holds all pixels.
        unsafe {
            if let (Some((fb, names)), true) = (&self.objects, self.samples > 1) {
                (fb.bind)(FRAMEBUFFER, names[1]);
            }
            (gl.read_pixels)(0, 0, self.size[0] as i32, self.size[1] as i32, RGBA, UNSIGNED_BYTE, pixels.as_mut_ptr().cast());
            if let Some((fb, names)) = &self.objects {
                (fb.bind)(FRAMEBUFFER, names[0]);
            }
        }
        pixels
    }
}
