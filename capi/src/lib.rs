//! The C ABI: `libOSMesa.so.8`.
//!
//! - [`osmesa`]: the 13 OSMesa functions;
//! - `generated::commands`: every gl* command, written by `capi/generator` from the Khronos registry;
//! - [`commands`]: hand-written shims for what takes pointers;
//! - [`current`]: which context is current on which thread;
//! - [`enter`]: how a command enters the library: no context, panics, errors.
#![warn(missing_docs)]
// The library is called OSMesa, and C functions are spelled as C spells them.
#![allow(non_snake_case)]

pub mod commands;
pub mod current;
pub mod enter;
#[rustfmt::skip]
#[allow(missing_docs)]
pub mod generated {
    //! Written by `capi/generator`.
    pub mod commands;
}
pub mod logging;
pub mod normalized;
pub mod osmesa;
pub mod table;
