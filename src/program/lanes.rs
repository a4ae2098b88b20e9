//! The CPU executor of programs: a naga module becomes a lane program, a list of operations over registers of up to
//! 64 lanes, so that the cost of dispatching an operation is spread over a block of vertices or fragments.

use super::Program;
use crate::draw::texture::TextureBinding;

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

/// Registers, kept from run to run. One a thread.
#[derive(Default)]
pub struct Machine {}

impl Machine {
    /// Runs a vertex program over `groups` groups. `inputs[i]` is attribute slot `i` (only those that the program
    /// reads need to be filled); `outputs[0]` becomes the clip position, `outputs[1 + k]` is `program.outputs[k]`.
    pub fn run_vertex(
        &mut self,
        _program: &Program,
        _env: &Environment,
        _inputs: &[Column4; 16],
        _outputs: &mut [Column4],
        _groups: usize,
    ) {
        unimplemented!("the lane executor")
    }

    /// Runs a fragment program over `groups` groups. `inputs[k]` is `program.inputs[k]`.
    pub fn run_fragment(
        &mut self,
        _program: &Program,
        _env: &Environment,
        _inputs: &[Column4],
        _results: &mut FragmentResults,
        _groups: usize,
    ) {
        unimplemented!("the lane executor")
    }
}
