//! The pipeline: vertex → clip → set-up → bin → tile → fine.
//!
//! Every stage is a pair of the same name, `src/raster/<stage>.rs` and `shaders/<stage>.wgsl`, that reads and
//! writes the records of [`layout`].

pub mod bin;
pub mod blend;
pub mod cells;
pub mod clear;
pub mod clip;
pub mod depth_stencil;
pub mod fast;
mod fast_samples;
mod filled;
pub mod fine;
pub mod formats;
mod hi_z;
mod interpolate;
pub mod layout;
mod lod;
mod modulate;
mod modulate_one;
pub mod plan;
mod point_line;
pub mod records;
pub mod runs;
pub mod samples;
pub mod setup;
pub mod simd;
#[cfg(target_arch = "x86_64")]
mod simd_avx2;
mod small;
pub mod store;
#[cfg(feature = "study")]
pub mod study;
pub mod texture;
mod texture_fetch;
#[cfg(target_arch = "x86_64")]
mod texture_wide;
mod textured;
pub mod tile;
pub mod vertex;
mod walk;
mod write;

#[cfg(test)]
mod tests;
