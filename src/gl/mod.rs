//! The state machine: one file a chapter of the OpenGL 2.1 specification.
//!
//! A [`Context`] is an owned object; which one is current on a thread is the C border's business. Each GL command is
//! a method of the same name in snake case (`glDepthFunc` → [`Context::depth_func`]); families that differ only in
//! the type of their arguments (`glColor3ub`, `glColor4fv`, ...) share one method. The generated C shims call these
//! methods; where a command takes pointers, a hand-written shim in `capi/src/commands/` turns them into slices first.
//!
//! A method that display lists compile starts with
//! ```ignore
//! if self.compile(move |cx| cx.depth_func(func)) { return; }
//! ```
//! and one that is not allowed between Begin and End with `if self.inside_begin_end() { return; }` (which sets the error).

pub mod accum;
pub mod arrays;
pub mod attrib_stack;
pub mod begin_end;
pub mod bitmap;
pub mod blending;
pub mod blit;
pub(crate) mod blit_pixels;
pub(crate) mod checks;
pub mod clear;
pub mod clip_plane;
pub mod compressed_texture;
pub mod copy_pixels;
pub mod copy_texture;
mod derived;
pub(crate) mod derived_states;
pub mod draw_pixels;
#[cfg(test)]
mod draw_tests;
pub mod draws;
pub mod enable;
pub mod enums;
pub mod evaluators;
pub mod feedback;
pub mod fog;
pub mod fragment_operations;
pub(crate) mod framebuffer;
pub(crate) mod framebuffer_object;
pub(crate) mod host_vertices;
pub mod lighting;
pub mod list;
pub mod list_names;
pub mod matrix;
pub mod mipmap;
mod object_names;
mod parity;
pub mod pixel_format;
pub mod pixel_objects;
pub(crate) mod pixel_record;
pub(crate) mod pixel_rectangle;
pub mod pixel_store;
pub mod pixel_transfer;
pub mod points_lines_polygons;
pub mod polygon_stipple;
#[cfg(test)]
mod property_tests;
pub mod query;
pub mod query_table;
pub mod raster_position;
pub mod read_pixels;
pub mod renderbuffer;
pub mod selection;
pub mod state;
pub mod strings;
#[cfg(test)]
mod tests;
pub mod texenv;
pub mod texgen;
pub mod texture_format;
pub mod texture_image;
pub mod texture_object;
pub mod texture_parameter;
pub(crate) mod texture_planes;
pub(crate) mod vertex_materials;

use std::sync::{Arc, Mutex, MutexGuard};

use crate::device::{ColorFormat, DepthFormat, Device, Surface, SurfaceFormat};
use crate::draw::recorder::Recorder;
use begin_end::Immediate;
use enums::*;
pub use parity::Parity;
use state::{MatrixStack, State};

/// A GL context.
pub struct Context {
    /// What the application can set and query.
    pub state: State,
    /// Model-view, projection and, a unit each, texture matrices.
    pub modelview: MatrixStack,
    /// Projection matrices.
    pub projection: MatrixStack,
    /// Texture matrices by unit.
    pub texture_matrices: Vec<MatrixStack>,
    /// Objects that contexts share: display lists, textures, renderbuffers.
    pub shared: Arc<Mutex<Shared>>,
    /// Where it draws.
    pub device: Arc<dyn Device>,
    /// The window buffer, once the context was made current with one.
    pub window: Option<Box<dyn Surface>>,
    /// Width and height of the window buffer, zero without one. What is drawn to may be a framebuffer object of another size: see
    /// `draw_size`.
    pub window_size: [u32; 2],
    /// What the context was made for.
    pub config: ContextConfig,
    /// GL_RENDER, GL_SELECT or GL_FEEDBACK.
    pub render_mode: GLenum,
    /// Groups of state that changed since the derived state was last computed: `dirty::*`.
    pub dirty: u32,
    /// The batch under construction.
    pub recorder: Recorder,
    pub(crate) derived_topology: u32,
    pub(crate) arrays: arrays::Arrays,
    /// Memory for the indices of a draw, where they have to be widened.
    indices: Vec<u32>,
    client_stack: Vec<arrays::SavedClient>,
    /// `None` while it is being computed.
    pub(crate) derived: Option<Box<derived::Derived>>,
    /// Number of the last derivation.
    revision: u64,
    /// The next derivation is for vertices shaded on the host: all outputs are wanted.
    pub(crate) shading_on_host: bool,
    pub(crate) immediate: Immediate,
    pass_through: vertex_materials::PassThrough,
    pub(crate) lists: list::ListState,
    maps: evaluators::Maps,
    selection: selection::Selection,
    feedback: feedback::Feedback,
    /// What shades vertices on the host, once it was needed.
    host_shader: Option<Box<host_vertices::HostShader>>,
    attrib_stack: Vec<attrib_stack::SavedAttributes>,
    /// Framebuffer objects and what is bound.
    pub(crate) fbo: framebuffer_object::FramebufferState,
    /// GL_RENDERER, once asked for.
    renderer: Option<std::ffi::CString>,
    pub(crate) pixel_objects: pixel_objects::PixelObjects,
    /// The window's pixels changed since they were last handed out ([`flush_batch`](Self::flush_batch) sets it, and so must who
    /// writes to the surface directly).
    pub window_changed: bool,
    error: GLenum,
}

/// What a context's window buffers store.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ContextConfig {
    /// Colour storage.
    pub color: ColorFormat,
    /// Bits of depth: 0, 16, else 24.
    pub depth_bits: u32,
    /// Bits of stencil: 0, else 8.
    pub stencil_bits: u32,
    /// Bits of accumulation a component: 0, else 16.
    pub accum_bits: u32,
    /// Samples of a pixel: 1, 2, 4, 8 or 16.
    pub samples: u32,
    /// Whose rule holds where Mesa's OSMesa departs from the specification.
    pub parity: Parity,
}

impl Default for ContextConfig {
    fn default() -> ContextConfig {
        ContextConfig {
            color: ColorFormat::Rgba8,
            depth_bits: 24,
            stencil_bits: 8,
            accum_bits: 0,
            samples: 1,
            parity: Parity::Specification,
        }
    }
}

impl ContextConfig {
    /// Storage of a window surface.
    pub fn surface_format(&self) -> SurfaceFormat {
        let depth = match self.depth_bits {
            0 => DepthFormat::None,
            1..=16 => DepthFormat::D16,
            _ => DepthFormat::D24,
        };
        SurfaceFormat { color: self.color, depth, stencil: self.stencil_bits > 0, top_first: true, samples: self.samples }
    }
}

/// Bits of [`Context::dirty`]. A setter marks its group; [`derived`](self) recomputes what depends on it.
pub mod dirty {
    /// Any matrix, viewport, depth range.
    pub const TRANSFORM: u32 = 1;
    /// Lights, materials, light model, normalisation, colour material, shade model.
    pub const LIGHTING: u32 = 1 << 1;
    /// Texture objects, environment, texgen, enables.
    pub const TEXTURE: u32 = 1 << 2;
    /// Fog.
    pub const FOG: u32 = 1 << 3;
    /// Points, lines, polygons, clip planes, scissor, stipples.
    pub const RASTER: u32 = 1 << 4;
    /// Alpha test to colour mask.
    pub const FRAGMENT: u32 = 1 << 5;
    /// The surface or its size.
    pub const SURFACE: u32 = 1 << 6;
    /// Numbers of lights, materials and the light model that are in a uniform block and decide nothing else: no program changes with
    /// them.
    pub const LIGHT_VALUES: u32 = 1 << 7;
    /// All of them.
    pub const ALL: u32 = !0;
}

/// Objects that contexts of one share group see.
#[derive(Default)]
pub struct Shared {
    /// Display lists.
    pub lists: list_names::Lists,
    /// Textures.
    pub textures: texture_object::TextureTable,
    /// Renderbuffers.
    pub renderbuffers: renderbuffer::RenderbufferTable,
}

impl Context {
    /// A context in the initial state of the specification. Objects are shared with `share`, if given.
    pub fn new(config: ContextConfig, share: Option<&Context>) -> Context {
        let device = match share {
            Some(other) => other.device.clone(),
            None => crate::device::choose(),
        };
        Context {
            state: State::default(),
            modelview: MatrixStack::new(state::MODELVIEW_STACK_DEPTH),
            projection: MatrixStack::new(state::PROJECTION_STACK_DEPTH),
            texture_matrices: (0..state::MAX_TEXTURE_UNITS).map(|_| MatrixStack::new(state::TEXTURE_STACK_DEPTH)).collect(),
            shared: share.map_or_else(Default::default, |other| other.shared.clone()),
            device,
            window: None,
            window_size: [0, 0],
            config,
            render_mode: GL_RENDER,
            dirty: dirty::ALL,
            recorder: Recorder::new(),
            derived_topology: !0,
            arrays: arrays::Arrays::default(),
            indices: Vec::new(),
            client_stack: Vec::new(),
            derived: Some(Box::default()),
            revision: 0,
            shading_on_host: false,
            immediate: Immediate::default(),
            pass_through: Default::default(),
            lists: list::ListState::default(),
            maps: evaluators::Maps::default(),
            selection: selection::Selection::default(),
            feedback: feedback::Feedback::default(),
            host_shader: None,
            attrib_stack: Vec::new(),
            fbo: Default::default(),
            renderer: None,
            pixel_objects: Default::default(),
            window_changed: false,
            error: GL_NO_ERROR,
        }
    }

    /// Gives the context a window buffer of this size. The first one sets viewport and scissor to it (2.11.1, 4.1.2); another
    /// size makes a new, zeroed surface and keeps all state; the same size keeps the surface.
    pub fn attach_window(&mut self, width: u32, height: u32) {
        let first = self.window.is_none();
        if first {
            let (w, h) = (width as i32, height as i32);
            let (viewport, scissor) = (&mut self.state.viewport, &mut self.state.scissor);
            (viewport.x, viewport.y, viewport.width, viewport.height) = (0, 0, w, h);
            (scissor.x, scissor.y, scissor.width, scissor.height) = (0, 0, w, h);
        }
        if first || self.window_size != [width, height] {
            self.flush_batch();
            self.window = Some(self.device.surface(width, height, self.config.surface_format()));
            self.window_size = [width, height];
            self.dirty = dirty::ALL;
        }
    }

    /// Records an error; the first one stays until it is read (2.5).
    pub fn set_error(&mut self, error: GLenum, what: &str) {
        log::debug!(target: "tepui::gl", "{what}: GL error {error:#06x}");
        if self.error == GL_NO_ERROR {
            self.error = error;
        }
    }

    /// glGetError: the first error since the last call.
    pub fn get_error(&mut self) -> GLenum {
        if self.inside_begin_end() {
            return 0;
        }
        std::mem::replace(&mut self.error, GL_NO_ERROR)
    }

    /// The objects of the share group, locked.
    pub fn shared(&self) -> MutexGuard<'_, Shared> {
        self.shared.lock().unwrap_or_else(|poisoned| poisoned.into_inner())
    }

    /// True between Begin and End, after recording GL_INVALID_OPERATION.
    #[inline]
    pub(crate) fn inside_begin_end(&mut self) -> bool {
        if self.immediate.is_inside() {
            self.set_error(GL_INVALID_OPERATION, "a command that is not allowed between glBegin and glEnd");
            return true;
        }
        false
    }

    /// Runs what was recorded so far, so that the window's pixels are up to date.
    pub fn flush_batch(&mut self) {
        let Some(batch) = self.recorder.take() else { return };
        if self.fbo.draw != 0 {
            return self.fbo.view.execute(&*self.device, batch);
        }
        if let Some(window) = &mut self.window {
            window.execute(batch);
            self.window_changed = true;
        }
    }
}
