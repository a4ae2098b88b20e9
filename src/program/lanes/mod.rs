//! The CPU executor of programs: a naga module becomes a lane program, a list of operations over registers of up to
//! 64 lanes, so that the cost of dispatching an operation is spread over a block of vertices or fragments.

mod compile;
mod expression;
mod graph;
mod machine;
pub mod math;
mod op;
mod schedule;
#[cfg(test)]
mod tests;

use super::Program;
use crate::draw::texture::TextureBinding;
pub use compile::Unsupported;
pub use machine::{Machine, Simd, avx2_available, simd};
pub use schedule::LaneProgram;

/// Lanes in a group: one AVX2 register of f32.
pub const LANES: usize = 8;
/// Most groups in one run.
pub const GROUPS: usize = 8;
/// One component over all lanes. Integers and booleans live in the same bits.
pub type Column = [[f32; LANES]; GROUPS];
/// A vec4 over all lanes: x, y, z, w.
pub type Column4 = [Column; 4];
/// A vec4 of zeros.
pub const ZERO4: Column4 = [[[0.0; LANES]; GROUPS]; 4];

/// What a run reads besides its inputs.
#[derive(Clone, Copy)]
pub struct Environment<'a> {
    /// `Batch::uniforms`.
    pub uniforms: &'a [[f32; 4]],
    /// First vec4 of the program's block.
    pub base: u32,
    /// Texture slot 0 and following.
    pub textures: &'a [TextureBinding],
}

/// Results of a fragment program besides its colour.
#[derive(Clone)]
pub struct FragmentResults {
    /// Colour, not clamped.
    pub color: Column4,
    /// Depth, where the program writes it.
    pub depth: Column,
    /// A bit a lane: the fragment lives on. Lanes of groups that did not run are undefined.
    pub keep: [u8; GROUPS],
}

impl Default for FragmentResults {
    fn default() -> FragmentResults {
        FragmentResults { color: ZERO4, depth: [[0.0; LANES]; GROUPS], keep: [0; GROUPS] }
    }
}

/// Compiles a program's module for the [`Machine`].
pub fn compile(program: &Program) -> Result<LaneProgram, Unsupported> {
    let mut compiled = compile::compile(program)?;
    schedule::combine(&mut compiled);
    Ok(schedule::schedule(&compiled))
}
