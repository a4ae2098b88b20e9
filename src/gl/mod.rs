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

pub mod enums;
pub mod state;

use std::sync::{Arc, Mutex};

use crate::device::{Device, Surface};
use enums::*;
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
    /// Objects that contexts share: display lists, textures.
    pub shared: Arc<Mutex<Shared>>,
    /// Where it draws.
    pub device: Arc<dyn Device>,
    /// The window buffer, once the context was made current with one.
    pub window: Option<Box<dyn Surface>>,
    /// Groups of state that changed since the derived state was last computed: `dirty::*`.
    pub dirty: u32,
    error: GLenum,
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
    /// All of them.
    pub const ALL: u32 = !0;
}

/// Objects that contexts of one share group see.
#[derive(Default)]
pub struct Shared {}

impl Context {
    /// Records an error; the first one stays until it is read (2.5).
    pub fn set_error(&mut self, error: GLenum, what: &str) {
        log::debug!(target: "tepui::gl", "{what}: GL error {error:#06x}");
        if self.error == GL_NO_ERROR {
            self.error = error;
        }
    }

    /// Records a command into the display list under construction. True: it was compiled only, the caller returns.
    pub(crate) fn compile(&mut self, _command: impl Fn(&mut Context) + Send + Sync + 'static) -> bool {
        false
    }

    /// True between Begin and End, after recording GL_INVALID_OPERATION.
    pub(crate) fn inside_begin_end(&mut self) -> bool {
        false
    }

    /// Runs what was recorded so far, so that the window's pixels are up to date.
    pub(crate) fn flush_batch(&mut self) {}
}
