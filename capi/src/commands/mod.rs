//! Hand-written shims: commands that take pointers. The generator finds `pub unsafe fn glName(cx, ...)` in this folder and calls it
//! from the exported command (and from the other spellings of the command). A shim decides how much may be read or written,
//! checks pointers for NULL, and calls a method of `Context`.
//!
//! One contract for all of them, which `# Safety` sections would only repeat: `cx` is this thread's current context; a pointer is NULL or
//! points to as many values as the specification of the command says for its other arguments and the pixel store state.
#![allow(clippy::missing_safety_doc)]

pub mod arrays;
pub mod compressed;
pub mod evaluators;
pub mod extensions;
pub mod flush;
pub mod framebuffers;
pub mod get;
pub mod lists;
pub mod matrices;
mod memory;
pub mod parameters;
pub mod pixels;
pub mod selection;
pub mod textures;
