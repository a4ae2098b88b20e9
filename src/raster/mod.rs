//! The pipeline: vertex → clip → set-up → bin → tile → fine.
//!
//! Every stage is a pair of the same name, `src/raster/<stage>.rs` and `shaders/<stage>.wgsl`, that reads and
//! writes the records of [`layout`].

pub mod layout;
