//! The table of GetProcAddress.

use std::ffi::c_void;

use crate::generated::commands::COMMANDS;

/// A command: its name and its address.
pub struct Entry(pub &'static str, pub *const c_void);

// SAFETY: the address of a function; nothing is reached through it here.
unsafe impl Sync for Entry {}

/// The address of a gl* command; `None` for what this library does not export.
pub fn find(name: &str) -> Option<*const c_void> {
    COMMANDS.binary_search_by(|entry| entry.0.cmp(name)).ok().map(|at| COMMANDS[at].1)
}
