//! Tepui: an OpenGL driver whose rasterizer is compute.
//!
//! Data goes down once, through one module after the other:
//!
//! - [`gl`]: the state machine, what the application has said so far;
//! - [`draw`]: draw calls become a [`draw::Batch`], vertices and interned states in order;
//! - [`program`]: vertex and fragment programs, one representation with two executors;
//! - [`raster`]: the pipeline, vertex → clip → set-up → bin → tile → fine;
//! - [`device`]: where it runs, the embedded CPU executor or wgpu compute.
//!
//! The C ABI on top of it lives in the crate `tepui-capi`.
#![warn(missing_docs)]

pub mod device;
pub mod draw;
pub mod gl;
pub mod program;
pub mod raster;
