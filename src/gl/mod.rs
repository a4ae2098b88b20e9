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
    error: GLenum,
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
}
