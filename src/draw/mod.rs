//! Draw calls become a [`Batch`]: vertices, primitives and interned states, in the order of the calls.
//!
//! Nothing here knows a GL object. A batch owns (or shares by `Arc`) all that it reads, so a later change to a GL
//! object never forces it to run early.

use std::cell::RefCell;
use std::sync::Arc;

use crate::program::Program;
use crate::raster::layout::{DrawRecord, FragmentState, Primitive, RasterState};

pub mod assembly;
pub mod clears;
pub(crate) mod interner;
pub mod recorder;
pub mod texture;

use texture::TextureBinding;

/// A draw: its record and the programs that it runs.
#[derive(Clone)]
pub struct Draw {
    /// Everything that is words.
    pub record: DrawRecord,
    /// Its first primitive; it has all up to the next draw's.
    pub first_primitive: u32,
    /// The vertex program.
    pub vertex_program: Arc<Program>,
    /// The fragment program.
    pub fragment_program: Arc<Program>,
}

/// A clear of a rectangle of the surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clear {
    /// First column and row (raster space, scissor applied).
    pub min: [i32; 2],
    /// One past the last column and row.
    pub max: [i32; 2],
    /// Clear colour, and the mask of the components that are written (bits 0 to 3: RGBA; 0 leaves the colour).
    pub color: [f32; 4],
    /// See `color`.
    pub color_mask: u32,
    /// Depth to write, if any.
    pub depth: Option<f64>,
    /// Stencil value and write mask, if any.
    pub stencil: Option<(u8, u8)>,
}

/// A step of a batch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// A clear.
    Clear(Clear),
    /// Primitives `first..end` of the batch.
    Primitives {
        /// First primitive.
        first: u32,
        /// One past the last primitive.
        end: u32,
    },
}

/// Work for a device: many draws and clears on one surface, in order.
#[derive(Clone, Default)]
pub struct Batch {
    /// Vertex attributes as the draws' layouts say, f32 words.
    pub vertices: Vec<f32>,
    /// Assembled primitives, in order.
    pub primitives: Vec<Primitive>,
    /// The draws.
    pub draws: Vec<Draw>,
    /// Blocks of vec4: program uniforms and constant attributes.
    pub uniforms: Vec<[f32; 4]>,
    /// Interned states.
    pub raster_states: Vec<RasterState>,
    /// Interned states.
    pub fragment_states: Vec<FragmentState>,
    /// Texture bindings of the draws.
    pub textures: Vec<TextureBinding>,
    /// Polygon stipple patterns, 32 rows each, bit 31 the leftmost column.
    pub polygon_stipples: Vec<[u32; 32]>,
    /// The order of it all.
    pub steps: Vec<Step>,
    /// vec4 of shaded vertices that the vertex stage will write.
    pub shaded_vec4: u32,
}

impl Batch {
    /// The primitives of a draw.
    pub fn draw_primitives(&self, draw: usize) -> std::ops::Range<u32> {
        let end = self.draws.get(draw + 1).map_or(self.primitives.len() as u32, |next| next.first_primitive);
        self.draws[draw].first_primitive..end
    }
}

/// Most bytes of an executed batch that are kept.
const SPARE_LIMIT: usize = 24 << 20;

/// Vectors of a batch that grow with its draws.
#[derive(Default)]
struct Memory {
    vertices: Vec<f32>,
    primitives: Vec<Primitive>,
    draws: Vec<Draw>,
}

thread_local! {
    static SPARE: RefCell<Memory> = const { RefCell::new(Memory { vertices: Vec::new(), primitives: Vec::new(), draws: Vec::new() }) };
}

/// Keeps the memory of an executed batch for the next one of this thread: fresh memory of its size costs a page fault every 4 KiB.
pub fn recycle(batch: Batch) {
    let Batch { mut vertices, mut primitives, mut draws, .. } = batch;
    let bytes = vertices.capacity() * 4 + primitives.capacity() * size_of::<Primitive>() + draws.capacity() * size_of::<Draw>();
    if bytes <= SPARE_LIMIT {
        vertices.clear();
        primitives.clear();
        draws.clear();
        SPARE.set(Memory { vertices, primitives, draws });
    }
}

impl Batch {
    /// Takes the memory of a batch before, before the first draw; with room for so many vertex words, primitives and draws.
    fn reuse_memory(&mut self, sizes: [usize; 3]) {
        let Memory { mut vertices, mut primitives, mut draws } = SPARE.take();
        vertices.reserve(sizes[0]);
        primitives.reserve(sizes[1]);
        draws.reserve(sizes[2]);
        (self.vertices, self.primitives, self.draws) = (vertices, primitives, draws);
    }
}
