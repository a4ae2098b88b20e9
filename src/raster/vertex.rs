//! Vertex stage: attributes become columns, the vertex program runs over 64 vertices at a time, its outputs are
//! written as rows, and every vertex gets its place on the screen and its clip code.
//!
//! Reads `Batch::{vertices, draws, uniforms, raster_states}`; writes the shaded vertices (`DrawRecord::shaded_base`,
//! `shaded_stride`) and one [`ScreenVertex`] a vertex.

use crate::draw::{Batch, Draw};
use crate::program::lanes::{Column4, Environment, GROUPS, LANES, Machine, ZERO4};
use crate::raster::layout::*;
use crate::raster::simd::{Level, Simd};

/// Vertices in one run of the vertex program.
pub const BLOCK: usize = LANES * GROUPS;

/// A vertex on the screen.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ScreenVertex {
    /// Raster-space x, y, z.
    pub position: [f32; 3],
    /// 1 / w of the clip position.
    pub inv_w: f32,
    /// Snapped x, y: 1/256 pixel from the centre of pixel 0.
    pub snapped: [i32; 2],
    /// `clip_code::*`; the vertex may be drawn as it is where it is zero.
    pub code: u32,
}

/// Bits of [`ScreenVertex::code`], in the order in which the planes clip.
#[allow(missing_docs)]
pub mod clip_code {
    pub const RIGHT: u32 = 1;
    pub const LEFT: u32 = 1 << 1;
    pub const TOP: u32 = 1 << 2;
    pub const BOTTOM: u32 = 1 << 3;
    pub const NEAR: u32 = 1 << 4;
    pub const FAR: u32 = 1 << 5;
    /// User planes 0 to 7 are this bit and the next seven.
    pub const USER: u32 = 1 << 6;
    /// A coordinate is not a number: the vertex draws nothing.
    pub const INVALID: u32 = 1 << 31;
}

/// Window coordinates that a snapped vertex may have: every viewport that shows anything of a surface of 16384 pixels lies inside, and edge
/// functions of anything inside fit the fine stage's words (see [`super::tile::LARGEST_STEP`]).
pub const COORDINATE_RANGE: [f32; 2] = [-16384.0, 32767.0];

/// Snaps a window coordinate: round to nearest even of (v - 0.5) * 256.
#[inline(always)]
pub fn snap(v: f32) -> i32 {
    let v = if v > COORDINATE_RANGE[0] { v } else { COORDINATE_RANGE[0] };
    let v = if v < COORDINATE_RANGE[1] { v } else { COORDINATE_RANGE[1] };
    ((v - 0.5) * 256.0).round_ties_even() as i32
}

/// The clip code of a clip position.
#[inline(always)]
pub fn frustum_code(p: [f32; 4], raster_flags_: u32) -> u32 {
    let [x, y, z, w] = p;
    let mut code = (x > w) as u32 * clip_code::RIGHT
        | (x + w < 0.0) as u32 * clip_code::LEFT
        | (y > w) as u32 * clip_code::TOP
        | (y + w < 0.0) as u32 * clip_code::BOTTOM;
    if raster_flags_ & raster_flags::NO_Z_CLIP == 0 {
        code |= (z + w < 0.0) as u32 * clip_code::NEAR | (z > w) as u32 * clip_code::FAR;
    }
    // The sum is finite where all four are, but for overflow, which draws nothing either.
    if !(x + y + z + w).is_finite() || w == 0.0 && x == 0.0 && y == 0.0 && z == 0.0 {
        code |= clip_code::INVALID;
    }
    code
}

/// Puts a clip position on the screen with the arithmetic of the vertex path: one division, then fused.
#[inline(always)]
pub fn to_screen(p: [f32; 4], state: &RasterState) -> ScreenVertex {
    if state.flags & raster_flags::WINDOW_SPACE != 0 {
        return ScreenVertex { position: [p[0], p[1], p[2]], inv_w: 1.0, snapped: [snap(p[0]), snap(p[1])], code: 0 };
    }
    let inv_w = 1.0 / p[3];
    let at = |k: usize| (p[k] * inv_w).mul_add(state.viewport_scale[k], state.viewport_translate[k]);
    let position = [at(0), at(1), at(2)];
    ScreenVertex { position, inv_w, snapped: [snap(position[0]), snap(position[1])], code: frustum_code(p, state.flags) }
}

/// Columns of one worker.
pub struct VertexWorker {
    inputs: Box<[Column4; ATTRIBUTES]>,
    outputs: Vec<Column4>,
    machine: Machine,
}

impl Default for VertexWorker {
    fn default() -> Self {
        VertexWorker {
            inputs: vec![ZERO4; ATTRIBUTES].try_into().ok().expect("its own length"),
            outputs: Vec::new(),
            machine: Machine::default(),
        }
    }
}

/// Reads attribute `slot` of `count` vertices from `first` on into columns.
fn fetch(batch: &Batch, record: &DrawRecord, slot: usize, first: usize, count: usize, column: &mut Column4) {
    let offset = record.attribute_offset[slot];
    if offset == NONE {
        let value = batch.uniforms[record.constants as usize + slot];
        for (component, column) in column.iter_mut().enumerate() {
            *column = [[value[component]; LANES]; GROUPS];
        }
        return;
    }
    let (size, stride) = (record.attribute_size[slot] as usize, record.vertex_stride as usize);
    for (component, column) in column.iter_mut().enumerate() {
        let lanes = column.as_flattened_mut();
        if component >= size {
            lanes.fill(if component == 3 { 1.0 } else { 0.0 });
            continue;
        }
        let mut word = record.vertex_word as usize + first * stride + offset as usize + component;
        for lane in &mut lanes[..count] {
            *lane = batch.vertices[word];
            word += stride;
        }
    }
}

impl VertexWorker {
    /// Shades a block.
    pub fn block(&mut self, batch: &Batch, block: VertexBlock, level: Level) {
        self.run(batch, block.draw, block.first, block.shaded, block.screen, level);
    }

    /// Shades vertices `first..first + screen.len()` of a draw, at most [`BLOCK`]. `shaded` is their part of the output.
    pub fn run(&mut self, batch: &Batch, draw: &Draw, first: usize, shaded: &mut [[f32; 4]], screen: &mut [ScreenVertex], level: Level) {
        let record = &draw.record;
        let program = &*draw.vertex_program;
        let count = screen.len();
        for slot in 0..ATTRIBUTES {
            if program.attributes >> slot & 1 != 0 {
                fetch(batch, record, slot, first, count, &mut self.inputs[slot]);
            }
        }
        let stride = record.shaded_stride as usize;
        self.outputs.resize(stride.max(1 + program.outputs.len()), ZERO4);
        let env = Environment { uniforms: &batch.uniforms, base: record.vertex_uniforms, textures: &[] };
        self.machine.run_vertex(program, &env, &self.inputs, &mut self.outputs, count.div_ceil(LANES));
        for (k, column) in self.outputs[..stride].iter().enumerate() {
            let [x, y, z, w] = column.each_ref().map(|c| c.as_flattened());
            for (v, to) in shaded[k..].iter_mut().step_by(stride).take(count).enumerate() {
                *to = [x[v], y[v], z[v], w[v]];
            }
        }
        let state = &batch.raster_states[record.raster_state as usize];
        place_all(level, shaded, record, state, screen);
    }
}

crate::dispatch! {
    /// Puts shaded vertices on the screen.
    fn place_all = place_kernel(shaded: &[[f32; 4]], record: &DrawRecord, state: &RasterState, screen: &mut [ScreenVertex])
}

/// At the level of AVX2 and FMA, rounding and fused products are instructions, not calls.
#[inline(always)]
#[allow(clippy::extra_unused_type_parameters)]
fn place_kernel<S: Simd>(shaded: &[[f32; 4]], record: &DrawRecord, state: &RasterState, screen: &mut [ScreenVertex]) {
    for (vertex, to) in shaded.chunks_exact(record.shaded_stride as usize).zip(screen) {
        *to = place(vertex, record, state);
    }
}

/// Puts a shaded vertex on the screen, user clip planes looked at.
#[inline(always)]
pub fn place(vertex: &[[f32; 4]], record: &DrawRecord, state: &RasterState) -> ScreenVertex {
    let mut placed = to_screen(vertex[0], state);
    if record.clip_distances != NONE {
        for k in 0..record.clip_distance_count as usize {
            if vertex[record.clip_distances as usize + k / 4][k % 4] < 0.0 {
                placed.code |= clip_code::USER << k;
            }
        }
    }
    placed
}

/// Vertices of one draw that one worker shades, and where they go.
pub struct VertexBlock<'a> {
    draw: &'a Draw,
    first: usize,
    shaded: &'a mut [[f32; 4]],
    screen: &'a mut [ScreenVertex],
}

/// The first [`ScreenVertex`] of each draw, and how many there are.
pub fn bases(batch: &Batch) -> (Vec<u32>, usize) {
    let mut bases = Vec::with_capacity(batch.draws.len());
    let mut vertices = 0;
    for draw in &batch.draws {
        bases.push(vertices as u32);
        vertices += draw.record.vertex_count as usize;
    }
    (bases, vertices)
}

/// Sizes the outputs of the vertex stage for a batch and cuts them into blocks of at most [`BLOCK`] vertices. Returns the first
/// [`ScreenVertex`] of each draw, and the blocks.
pub fn blocks<'a>(batch: &'a Batch, shaded: &'a mut Vec<[f32; 4]>, screen: &'a mut Vec<ScreenVertex>) -> (Vec<u32>, Vec<VertexBlock<'a>>) {
    let (bases, vertices) = bases(batch);
    shaded.resize(batch.shaded_vec4 as usize, [0.0; 4]);
    screen.resize(vertices, ScreenVertex::default());
    // Cut the outputs into blocks: each is written by one worker.
    let (mut shaded, mut screen) = (&mut shaded[..], &mut screen[..]);
    let mut at = 0;
    let mut blocks = Vec::with_capacity(vertices / BLOCK + batch.draws.len());
    for draw in &batch.draws {
        let record = &draw.record;
        assert!(record.shaded_base as usize >= at, "shaded vertices lie in the order of the draws");
        shaded = &mut shaded[record.shaded_base as usize - at..];
        let mut first = 0;
        while first < record.vertex_count as usize {
            let count = (record.vertex_count as usize - first).min(BLOCK);
            let (s, rest) = shaded.split_at_mut(count * record.shaded_stride as usize);
            let (p, screen_rest) = screen.split_at_mut(count);
            (shaded, screen) = (rest, screen_rest);
            blocks.push(VertexBlock { draw, first, shaded: s, screen: p });
            first += count;
        }
        at = record.shaded_base as usize + record.vertex_count as usize * record.shaded_stride as usize;
    }
    (bases, blocks)
}
