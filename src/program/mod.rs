//! Vertex and fragment programs: one representation, two executors.
//!
//! A program is a naga module. The fixed-function generator ([`fixed`]) writes it as WGSL from a compact key; the GPU
//! splices the text into its kernels, the CPU executes the same module over many lanes at once ([`lanes`]).
//!
//! # The conventions of a module
//! ```wgsl
//! @group(0) @binding(0) var<storage, read> uniforms: array<vec4<f32>>;
//! fn texture_sample(slot: u32, coord: vec4<f32>, ddx: vec4<f32>, ddy: vec4<f32>) -> vec4<f32>   // intrinsic
//! fn product(a: vec4<f32>, b: f32) -> vec4<f32>   // intrinsic: a * b, which no compiler joins with a sum that follows
//! fn products(a: vec4<f32>, b: vec4<f32>) -> vec4<f32>   // intrinsic: the same for component by component
//! fn power(a: f32, b: f32) -> f32                 // intrinsic: pow, where a driver's own is too coarse for large exponents
//! fn unit(v: vec3<f32>) -> vec3<f32>              // intrinsic: normalize, likewise
//! fn inverse_root(a: f32) -> f32                  // intrinsic: inverseSqrt, likewise
//! struct VertexIn { a0: vec4<f32>, a3: vec4<f32>, ... }             // the attributes it reads, by slot number
//! struct VertexOut { position: vec4<f32>, o0: vec4<f32>, ... }      // `outputs`, in their order
//! fn vertex_main(in: VertexIn, base: u32) -> VertexOut              // `base`: first vec4 of its uniform block
//! struct FragmentIn { i0: vec4<f32>, i1: vec4<f32>, ... }           // `inputs`, in their order
//! struct FragmentOut { color: vec4<f32>, depth: f32, keep: bool }   // depth only if it writes depth, keep only if it discards
//! fn fragment_main(in: FragmentIn, base: u32) -> FragmentOut
//! ```
//! [`Program::wgsl`] is the text without the intrinsics (whoever splices it provides them) and defines no other name at
//! module scope than those six.

use std::sync::OnceLock;
use std::sync::atomic::{AtomicU64, Ordering};

pub mod fixed;
pub mod lanes;

/// A vec4 that a vertex program hands to the later stages.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum Output {
    FrontColor,
    FrontSecondary,
    BackColor,
    BackSecondary,
    /// Fog coordinate in x.
    Fog,
    TexCoord(u8),
    /// Four user clip distances: 0 to 3, 4 to 7.
    ClipDistance(u8),
    /// Point size in x.
    PointSize,
    /// Eye coordinates.
    Eye,
    /// No output of a program: made by set-up, see `layout::interpolation::COVERAGE`.
    Coverage,
    /// A varying of a GLSL program.
    Generic(u8),
}

/// A vec4 that a fragment program reads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Input {
    /// Raster-space x, y of the pixel centre, z, 1/w.
    Position,
    /// x: 1 for front-facing, else 0.
    Facing,
    /// Varying `k` of [`Program::varyings`].
    Varying(u8),
    /// Varying `k` at a pixel of the 2 x 2 quad that the fragment belongs to: 0 its origin (even x, even y), 1 the
    /// next in x, 2 the next in y. Differences of these are the derivatives; evaluated from the planes, without helper pixels. The coordinates of
    /// a texture that is not a cube map: programs look at their ratios to the fourth component only.
    Quad(u8, u8),
}

/// A varying as a fragment program wants it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Varying {
    /// Which vertex output, on front faces.
    pub front: Output,
    /// Which one on back faces.
    pub back: Output,
    /// `layout::interpolation::*`
    pub interpolation: u32,
}

/// Which stage a program belongs to.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Stage {
    Vertex,
    Fragment,
}

/// What an executor may do instead of running a fragment program, with the same result.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Shortcut {
    /// Nothing: run it.
    #[default]
    None,
    /// The colour is varying `k`, as it is interpolated; nothing is discarded, depth is the interpolated one.
    Varying(u8),
    /// The same, but the colour is a varying times a texel.
    Modulate(Modulate),
}

/// A colour times a texel of slot 0, at s, t and r of varying 0 divided by its q; the level of detail is that of its quad. The
/// colour is varying 1, and there is no other.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Modulate {
    /// The sampler wants a level of detail.
    pub lod: bool,
    /// Red, green and blue are multiplied, alpha is.
    pub parts: [bool; 2],
}

/// A program, ready for both executors.
pub struct Program {
    /// Unique over the process: equal ids are equal programs.
    pub id: u64,
    /// Stage.
    pub stage: Stage,
    /// The text that the kernels splice in.
    pub wgsl: String,
    /// The same, parsed and validated.
    pub module: naga::Module,
    /// What the validator found out about it.
    pub info: naga::valid::ModuleInfo,
    /// Vertex: the attributes read, as a mask of slots.
    pub attributes: u32,
    /// Vertex: what follows the position in a shaded vertex, in this order.
    pub outputs: Vec<Output>,
    /// Fragment: the inputs, in this order.
    pub inputs: Vec<Input>,
    /// Fragment: the varyings, in this order.
    pub varyings: Vec<Varying>,
    /// Fragment: texture slots used.
    pub texture_slots: u32,
    /// Fragment: it writes depth.
    pub writes_depth: bool,
    /// Fragment: it may discard.
    pub discards: bool,
    /// vec4 of its uniform block.
    pub uniform_vec4: u32,
    /// Fragment: what may be done instead of running it.
    pub shortcut: Shortcut,
    lanes: OnceLock<lanes::LaneProgram>,
}

/// What stands before a program's text when naga reads it.
pub const PRELUDE: &str = "@group(0) @binding(0) var<storage, read> uniforms: array<vec4<f32>>;
fn texture_sample(slot: u32, coord: vec4<f32>, ddx: vec4<f32>, ddy: vec4<f32>) -> vec4<f32> { return coord; }
fn product(a: vec4<f32>, b: f32) -> vec4<f32> { return a * b; }
fn products(a: vec4<f32>, b: vec4<f32>) -> vec4<f32> { return a * b; }
fn power(a: f32, b: f32) -> f32 { return pow(a, b); }
fn unit(v: vec3<f32>) -> vec3<f32> { return normalize(v); }
fn inverse_root(a: f32) -> f32 { return inverseSqrt(a); }
";

/// Everything of a program but what is computed from its text.
#[derive(Clone, Debug, Default)]
#[allow(missing_docs)]
pub struct Interface {
    pub attributes: u32,
    pub outputs: Vec<Output>,
    pub inputs: Vec<Input>,
    pub varyings: Vec<Varying>,
    pub texture_slots: u32,
    pub writes_depth: bool,
    pub discards: bool,
    pub uniform_vec4: u32,
    pub shortcut: Shortcut,
}

impl Program {
    /// Parses and validates a text.
    pub fn new(stage: Stage, wgsl: String, interface: Interface) -> Result<Program, String> {
        static NEXT: AtomicU64 = AtomicU64::new(1);
        let source = format!("{PRELUDE}{wgsl}");
        let module = naga::front::wgsl::parse_str(&source).map_err(|e| e.emit_to_string(&source))?;
        let flags = naga::valid::ValidationFlags::all();
        let info = naga::valid::Validator::new(flags, naga::valid::Capabilities::empty())
            .validate(&module)
            .map_err(|e| e.emit_to_string(&source))?;
        let Interface { attributes, outputs, inputs, varyings, texture_slots, writes_depth, discards, uniform_vec4, shortcut } = interface;
        Ok(Program {
            id: NEXT.fetch_add(1, Ordering::Relaxed),
            stage,
            wgsl,
            module,
            info,
            attributes,
            outputs,
            inputs,
            varyings,
            texture_slots,
            writes_depth,
            discards,
            uniform_vec4,
            shortcut,
            lanes: OnceLock::new(),
        })
    }

    /// The program for the CPU, compiled when it is first wanted.
    pub fn lanes(&self) -> &lanes::LaneProgram {
        self.lanes.get_or_init(|| {
            lanes::compile(self).unwrap_or_else(|e| {
                log::error!(target: "tepui::program", "a program that the CPU cannot run: {e:?}");
                lanes::LaneProgram::default()
            })
        })
    }
}
