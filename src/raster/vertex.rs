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
    /// Zero: a vertex is two vec4.
    pub reserved: u32,
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
    let mut code = ((x > w) as u32 * clip_code::RIGHT)
        | ((x + w < 0.0) as u32 * clip_code::LEFT)
        | ((y > w) as u32 * clip_code::TOP)
        | ((y + w < 0.0) as u32 * clip_code::BOTTOM);
    if raster_flags_ & raster_flags::NO_Z_CLIP == 0 {
        code |= ((z + w < 0.0) as u32 * clip_code::NEAR) | ((z > w) as u32 * clip_code::FAR);
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
        return ScreenVertex { position: [p[0], p[1], p[2]], inv_w: 1.0, snapped: [snap(p[0]), snap(p[1])], code: 0, reserved: 0 };
    }
    let inv_w = 1.0 / p[3];
    let at = |k: usize| (p[k] * inv_w).mul_add(state.viewport_scale[k], state.viewport_translate[k]);
    let position = [at(0), at(1), at(2)];
    ScreenVertex { position, inv_w, snapped: [snap(position[0]), snap(position[1])], code: frustum_code(p, state.flags), reserved: 0 }
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
            inputs: vec![ZERO4; ATTRIBUTES].try_into().expect("its own length"),
            outputs: Vec::new(),
            machine: Machine::default(),
        }
    }
}

crate::dispatch! {
    /// Reads attribute `slot` of `count` vertices from `first` on into columns.
    fn fetch = fetch_kernel(batch: &Batch, record: &DrawRecord, slot: usize, first: usize, count: usize, column: &mut Column4)
}

#[inline(always)]
fn fetch_kernel<S: Simd>(batch: &Batch, record: &DrawRecord, slot: usize, first: usize, count: usize, column: &mut Column4) {
    let offset = record.attribute_offset[slot];
    if offset == NONE {
        let value = batch.uniforms[record.constants as usize + slot];
        for (component, column) in column.iter_mut().enumerate() {
            *column = [[value[component]; LANES]; GROUPS];
        }
        return;
    }
    let (size, stride) = (record.attribute_size[slot] as usize, record.vertex_stride as usize);
    let start = record.vertex_word as usize + first * stride + offset as usize;
    let mut done = 0;
    if size >= 3 {
        // Eight vertices at a time, four words of each, as far as there are so many.
        while done + LANES <= count && start + (done + LANES - 1) * stride + 4 <= batch.vertices.len() {
            let from = &batch.vertices[start + done * stride..];
            let mut rows = [&[0.0; 4]; LANES];
            for (k, row) in rows.iter_mut().enumerate() {
                *row = from[k * stride..].first_chunk().expect("four words");
            }
            let columns = S::columns(rows);
            for component in 0..size.min(4) {
                S::store(columns[component], &mut column[component][done / LANES]);
            }
            done += LANES;
        }
    }
    for (component, column) in column.iter_mut().enumerate() {
        let lanes = column.as_flattened_mut();
        if component >= size {
            lanes.fill(if component == 3 { 1.0 } else { 0.0 });
            continue;
        }
        let mut word = start + done * stride + component;
        for lane in &mut lanes[done..count] {
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
                fetch(level, batch, record, slot, first, count, &mut self.inputs[slot]);
            }
        }
        let stride = record.shaded_stride as usize;
        self.outputs.resize(stride.max(1 + program.outputs.len()), ZERO4);
        let env = Environment { uniforms: &batch.uniforms, base: record.vertex_uniforms, textures: &[] };
        self.machine.run_vertex(program, &env, &self.inputs, &mut self.outputs, count.div_ceil(LANES));
        let state = &batch.raster_states[record.raster_state as usize];
        write(level, &self.outputs[..stride], record, state, shaded, screen);
    }
}

crate::dispatch! {
    /// Writes a program's outputs, vertex by vertex, and puts the vertices on the screen.
    fn write = write_kernel(columns: &[Column4], record: &DrawRecord, state: &RasterState, shaded: &mut [[f32; 4]], screen: &mut [ScreenVertex])
}

#[inline(always)]
fn write_kernel<S: Simd>(
    columns: &[Column4],
    record: &DrawRecord,
    state: &RasterState,
    shaded: &mut [[f32; 4]],
    screen: &mut [ScreenVertex],
) {
    let stride = columns.len();
    for (group, (shaded, screen)) in shaded.chunks_mut(LANES * stride).zip(screen.chunks_mut(LANES)).enumerate() {
        for (k, c) in columns.iter().enumerate() {
            let rows = S::rows([S::load(&c[0][group]), S::load(&c[1][group]), S::load(&c[2][group]), S::load(&c[3][group])]);
            for (to, row) in shaded[k..].iter_mut().step_by(stride).zip(rows) {
                *to = row;
            }
        }
        if state.flags & raster_flags::WINDOW_SPACE != 0 || record.clip_distances != NONE {
            for (to, vertex) in screen.iter_mut().zip(shaded.chunks_exact(stride)) {
                *to = place(vertex, record, state);
            }
        } else {
            let p = &columns[0];
            let placed = to_screen_wide::<S>([&p[0][group], &p[1][group], &p[2][group], &p[3][group]], state);
            for (to, placed) in screen.iter_mut().zip(placed) {
                *to = placed;
            }
        }
    }
}

/// [`to_screen`] of eight vertices, given by columns, that are not in window space.
#[inline(always)]
fn to_screen_wide<S: Simd>(p: [&[f32; 8]; 4], state: &RasterState) -> [ScreenVertex; 8] {
    let [x, y, z, w] = [S::load(p[0]), S::load(p[1]), S::load(p[2]), S::load(p[3])];
    let inv_w = S::div(S::f(1.0), w);
    let (scale, translate) = (&state.viewport_scale, &state.viewport_translate);
    let sx = S::fma(S::mul(x, inv_w), S::f(scale[0]), S::f(translate[0]));
    let sy = S::fma(S::mul(y, inv_w), S::f(scale[1]), S::f(translate[1]));
    let sz = S::fma(S::mul(z, inv_w), S::f(scale[2]), S::f(translate[2]));
    let (low, high) = (S::f(COORDINATE_RANGE[0]), S::f(COORDINATE_RANGE[1]));
    let (half, subpixels) = (S::f(0.5), S::f(256.0));
    let snapped_x = S::round(S::mul(S::sub(S::clamp(sx, low, high), half), subpixels));
    let snapped_y = S::round(S::mul(S::sub(S::clamp(sy, low, high), half), subpixels));
    // As in `frustum_code`.
    let zero = S::f(0.0);
    let mut code = S::and(S::lt(w, x), S::i(clip_code::RIGHT as i32));
    code = S::or(code, S::and(S::lt(S::add(x, w), zero), S::i(clip_code::LEFT as i32)));
    code = S::or(code, S::and(S::lt(w, y), S::i(clip_code::TOP as i32)));
    code = S::or(code, S::and(S::lt(S::add(y, w), zero), S::i(clip_code::BOTTOM as i32)));
    if state.flags & raster_flags::NO_Z_CLIP == 0 {
        code = S::or(code, S::and(S::lt(S::add(z, w), zero), S::i(clip_code::NEAR as i32)));
        code = S::or(code, S::and(S::lt(w, z), S::i(clip_code::FAR as i32)));
    }
    let exponent = S::i(0x7f80_0000);
    let sum = S::bits(S::add(S::add(S::add(x, y), z), w));
    let any = S::or(S::or(S::bits(x), S::bits(y)), S::or(S::bits(z), S::bits(w)));
    let invalid = S::or(S::eq(S::and(sum, exponent), exponent), S::eq(S::shl::<1>(any), S::i(0)));
    code = S::or(code, S::and(invalid, S::i(clip_code::INVALID as i32)));
    let places = S::rows([sx, sy, sz, inv_w]);
    let others = S::rows([S::from_bits(snapped_x), S::from_bits(snapped_y), S::from_bits(code), S::from_bits(S::i(0))]);
    let mut placed = [ScreenVertex::default(); 8];
    for k in 0..8 {
        let [sx, sy, code, reserved] = bytemuck::cast::<[f32; 4], [u32; 4]>(others[k]);
        let [x, y, z, inv_w] = places[k];
        placed[k] = ScreenVertex { position: [x, y, z], inv_w, snapped: [sx as i32, sy as i32], code, reserved };
    }
    placed
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

#[cfg(test)]
mod tests {
    use super::*;
    use bytemuck::Zeroable;

    #[test]
    fn eight_vertices_are_placed_as_one() {
        let odd = [0.0, -0.0, 1.0, -1.0, 0.37, -2.5, 1e-42, 1e30, -1e30, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, 3.0e38];
        let mut columns = [ZERO4];
        let mut state = 1u32;
        let mut odd_one = || {
            state = state.wrapping_mul(747796405).wrapping_add(2891336453);
            odd[(state >> 16) as usize % odd.len()]
        };
        for flags in [0, raster_flags::NO_Z_CLIP, raster_flags::WINDOW_SPACE] {
            let raster =
                RasterState { flags, viewport_scale: [100.0, -75.0, 0.5], viewport_translate: [100.5, 75.0, 0.5], ..Zeroable::zeroed() };
            let record = DrawRecord { clip_distances: NONE, shaded_stride: 1, ..Zeroable::zeroed() };
            for _ in 0..50 {
                columns[0].as_flattened_mut().as_flattened_mut().iter_mut().for_each(|v| *v = odd_one());
                for level in [Level::Scalar, Level::best()] {
                    let count = BLOCK - 3;
                    let (mut shaded, mut screen) = (vec![[0.0; 4]; count], vec![ScreenVertex::default(); count]);
                    write(level, &columns, &record, &raster, &mut shaded, &mut screen);
                    for (v, placed) in shaded.iter().zip(&screen) {
                        let bits = |s: &ScreenVertex| (s.position.map(f32::to_bits), s.inv_w.to_bits(), s.snapped, s.code);
                        let nan = |s: &ScreenVertex| s.position.iter().any(|p| p.is_nan());
                        let alone = to_screen(*v, &raster);
                        // Which NaN it is does not matter.
                        assert!(
                            bits(&alone) == bits(placed) || nan(&alone) && nan(placed) && alone.code == placed.code,
                            "{v:?}: {alone:?}, {placed:?}"
                        );
                    }
                }
            }
        }
    }
}
