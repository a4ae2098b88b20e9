//! Hand-written shims: commands that take pointers. The generator finds `pub unsafe fn glName(cx, ...)` in this folder and calls it
//! from the exported command. A shim checks pointers, decides how much may be read or written, and calls a method of `Context`.

pub mod flush;
