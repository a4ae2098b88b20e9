//! The recorder: owns the batch under construction, interns what its draws see, and merges consecutive draws of equal
//! state.
//!
//! A draw stays open for more vertices until its state changes. An attribute that changes only from call to call
//! (glColor between two Begin/End pairs) is a constant of the draw; when the next call brings another value, the draw is small
//! and all else is equal, the attribute becomes one of its vertices instead, so that the two calls stay one draw.

use std::collections::HashMap;
use std::sync::Arc;

use super::assembly::{Assembly, Part, PrimitiveType, QuadSplit};
use super::interner::{Interner, WordHasher, hash_words};
use super::texture::TextureBinding;
use super::{Batch, Clear, Draw, Step};
use crate::program::{Output, Program};
use crate::raster::layout::*;

/// Most vertices of a draw that are laid out anew to make a constant an attribute.
const RELAYOUT_LIMIT: u32 = 1024;

/// The state of a draw, as the state machine derives it.
#[derive(Clone)]
pub struct DrawState<'a> {
    /// `topology::*`
    pub topology: u32,
    /// The vertex program.
    pub vertex_program: &'a Arc<Program>,
    /// The fragment program.
    pub fragment_program: &'a Arc<Program>,
    /// The vertex program's block.
    pub vertex_uniforms: &'a [[f32; 4]],
    /// The fragment program's block.
    pub fragment_uniforms: &'a [[f32; 4]],
    /// Clip to set-up; its `polygon_stipple` is filled in here.
    pub raster_state: RasterState,
    /// Per-fragment operations.
    pub fragment_state: FragmentState,
    /// Texture slots of the fragment program.
    pub textures: &'a [TextureBinding],
    /// Polygon stipple, where it is on.
    pub stipple: Option<&'a [u32; 32]>,
    /// User clip distances that the vertex program writes.
    pub clip_distance_count: u32,
}

/// A run of vertices with four words an attribute, in slot order, attribute 0 (position) always there.
#[derive(Clone, Copy)]
pub struct Run<'a> {
    /// The slots there.
    pub mask: u32,
    /// `count * mask.count_ones()` attributes.
    pub data: &'a [[f32; 4]],
    /// Number of vertices.
    pub count: u32,
    /// Edge flags by vertex; `None`: all true.
    pub edge_flags: Option<&'a [bool]>,
}

impl Run<'_> {
    /// Attribute `slot` of a vertex; from `current` where the run does not have it.
    pub fn attribute(&self, slot: usize, vertex: u32, current: &[[f32; 4]; ATTRIBUTES]) -> [f32; 4] {
        if self.mask & 1 << slot == 0 {
            return current[slot];
        }
        let stride = self.mask.count_ones();
        let rank = (self.mask & ((1 << slot) - 1)).count_ones();
        self.data[(vertex * stride + rank) as usize]
    }

    /// Edge flag of a vertex.
    pub fn edge_flag(&self, vertex: u32) -> bool {
        self.edge_flags.is_none_or(|flags| flags[vertex as usize])
    }
}

/// A vertex layout of a draw: which attributes its vertices have, and how many words of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexLayout {
    /// Slots that vary from vertex to vertex.
    pub mask: u32,
    /// Words of each.
    pub size: [u8; ATTRIBUTES],
}

impl VertexLayout {
    /// Four words of each slot.
    pub fn full(mask: u32) -> VertexLayout {
        VertexLayout { mask, size: [4; ATTRIBUTES] }
    }

    fn offsets(&self) -> ([u32; ATTRIBUTES], u32) {
        let (mut offset, mut stride) = ([NONE; ATTRIBUTES], 0);
        for slot in slots(self.mask) {
            offset[slot] = stride;
            stride += u32::from(self.size[slot]);
        }
        (offset, stride)
    }
}

/// The slots of a mask, in order.
pub fn slots(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let slot = mask.trailing_zeros();
        mask &= mask.wrapping_sub(1);
        (slot < 32).then_some(slot as usize)
    })
}

/// The last draw of the batch, which still takes vertices.
struct Open {
    layout: VertexLayout,
    constants: [[f32; 4]; ATTRIBUTES],
}

/// State of the next draw, interned.
struct Prepared {
    /// Record without what belongs to the vertices.
    record: DrawRecord,
    vertex_program: Arc<Program>,
    fragment_program: Arc<Program>,
}

/// Turns draws into a batch.
#[derive(Default)]
pub struct Recorder {
    batch: Batch,
    budget: usize,
    open: Option<Open>,
    prepared: Option<Prepared>,
    /// Primitives before this one are in a step.
    stepped: u32,
    blocks: Interner,
    raster_states: Interner,
    fragment_states: Interner,
    texture_lists: HashMap<u64, u32, WordHasher>,
    stipples: Interner,
    /// Capacity that the last batch needed: vertices, primitives.
    last_sizes: [usize; 2],
}

impl Recorder {
    /// An empty recorder. `TEPUI_BATCH_BUDGET` (bytes) bounds a batch; the default is 64 MiB.
    pub fn new() -> Recorder {
        let budget = std::env::var("TEPUI_BATCH_BUDGET").ok().and_then(|text| text.trim().parse().ok()).unwrap_or(64 << 20);
        Recorder { budget, ..Recorder::default() }
    }

    /// Another budget, in bytes.
    #[cfg(test)]
    pub(crate) fn set_budget(&mut self, bytes: usize) {
        self.budget = bytes;
    }

    /// The batch so far, if there is anything in it. The state has to be set again before the next draw.
    pub fn take(&mut self) -> Option<Batch> {
        self.close_draw();
        self.close_step();
        if self.batch.steps.is_empty() {
            return None;
        }
        self.prepared = None;
        self.stepped = 0;
        for interner in [&mut self.blocks, &mut self.raster_states, &mut self.fragment_states, &mut self.stipples] {
            interner.clear();
        }
        self.texture_lists.clear();
        self.last_sizes = [self.batch.vertices.len(), self.batch.primitives.len()];
        Some(std::mem::take(&mut self.batch))
    }

    /// Nothing recorded.
    pub fn is_empty(&self) -> bool {
        self.batch.steps.is_empty() && self.batch.primitives.is_empty()
    }

    /// `set_state` was called since the last `take`.
    pub fn has_state(&self) -> bool {
        self.prepared.is_some()
    }

    /// The batch outgrew its budget: take and execute it.
    pub fn is_full(&self) -> bool {
        let batch = &self.batch;
        let shaded = batch.vertices.len() * 4;
        let bytes = (batch.vertices.len() + shaded) * 4
            + batch.primitives.len() * size_of::<Primitive>()
            + batch.uniforms.len() * 16
            + batch.draws.len() * size_of::<Draw>();
        bytes > self.budget || batch.draws.len() >= PRIM_DRAW_MASK as usize
    }

    /// Vertices that a caller may hand over at once without going far beyond the budget.
    pub fn chunk(&self) -> u32 {
        // A vertex costs some 150 bytes with its shaded form and its primitives.
        ((self.budget / 150) as u32).clamp(1 << 10, 1 << 22)
    }

    /// Records a clear.
    pub fn clear(&mut self, clear: Clear) {
        self.close_draw();
        self.close_step();
        self.batch.steps.push(Step::Clear(clear));
    }

    /// Sets the state of the draws that follow.
    pub fn set_state(&mut self, state: &DrawState) {
        let mut raster_state = state.raster_state;
        raster_state.polygon_stipple = match state.stipple {
            Some(rows) => self.stipples.intern(bytemuck::bytes_of(rows), &mut self.batch.polygon_stipples, std::slice::from_ref(rows)),
            None => NONE,
        };
        let batch = &mut self.batch;
        let mut record = DrawRecord {
            vertex_word: 0,
            vertex_stride: 0,
            vertex_count: 0,
            topology: state.topology,
            attribute_offset: [NONE; ATTRIBUTES],
            attribute_size: [0; ATTRIBUTES],
            constants: 0,
            vertex_uniforms: self.blocks.intern_block(state.vertex_uniforms, &mut batch.uniforms),
            fragment_uniforms: self.blocks.intern_block(state.fragment_uniforms, &mut batch.uniforms),
            raster_state: self.raster_states.intern(bytemuck::bytes_of(&raster_state), &mut batch.raster_states, &[raster_state]),
            fragment_state: self.fragment_states.intern(
                bytemuck::bytes_of(&state.fragment_state),
                &mut batch.fragment_states,
                &[state.fragment_state],
            ),
            first_texture: intern_textures(&mut self.texture_lists, &mut batch.textures, state.textures),
            shaded_base: 0,
            shaded_stride: 0,
            clip_distances: NONE,
            clip_distance_count: state.clip_distance_count,
            point_size: NONE,
            varying_count: 0,
            varyings: [0; MAX_VARYINGS],
        };
        link(&mut record, state.vertex_program, state.fragment_program);
        if let Some(prepared) = &self.prepared
            && prepared.record == record
            && prepared.vertex_program.id == state.vertex_program.id
            && prepared.fragment_program.id == state.fragment_program.id
        {
            return;
        }
        self.close_draw();
        self.prepared =
            Some(Prepared { record, vertex_program: state.vertex_program.clone(), fragment_program: state.fragment_program.clone() });
    }

    /// Another vertex program for the draws that follow, with the state set before.
    pub fn replace_vertex_program(&mut self, program: &Arc<Program>) {
        self.close_draw();
        if let Some(prepared) = &mut self.prepared {
            link(&mut prepared.record, program, &prepared.fragment_program);
            prepared.vertex_program = program.clone();
        }
    }

    /// The state has to be set again before the next draw.
    pub fn forget_state(&mut self) {
        self.close_draw();
        self.prepared = None;
    }

    /// Draws a run of vertices in the state set before. Attributes that the run does not have come from `current`.
    pub fn draw_run(&mut self, mode: PrimitiveType, part: Part, split: QuadSplit, run: &Run, current: &[[f32; 4]; ATTRIBUTES]) {
        let Some(reads) = self.prepared.as_ref().map(|prepared| prepared.vertex_program.attributes) else { return };
        let wanted = run.mask & (reads | 1);
        let fits = match &self.open {
            Some(open) if open.layout.size == [4; ATTRIBUTES] => {
                let constant = reads & !open.layout.mask;
                let missing = constant & wanted;
                let differing = slots(constant & !wanted).filter(|&s| open.constants[s] != current[s]).fold(0, |mask, s| mask | 1 << s);
                Some(missing | differing)
            }
            _ => None,
        };
        match fits {
            Some(0) => {}
            Some(grow) if self.open_vertices() <= RELAYOUT_LIMIT && run.count <= RELAYOUT_LIMIT => self.relayout(grow),
            _ => self.open_draw(VertexLayout::full(wanted), current),
        }
        let layout = match &self.open {
            Some(open) => open.layout,
            None => return,
        };
        let base = self.open_vertices();
        let vertices = &mut self.batch.vertices;
        if layout.mask == run.mask {
            vertices.extend_from_slice(run.data.as_flattened());
        } else {
            copy_run(run, layout.mask, current, vertices);
        }
        self.finish_vertices(run.count);
        let draw = (self.batch.draws.len() - 1) as u32;
        let assembly = Assembly { mode, part, split, draw };
        let out = &mut self.batch.primitives;
        match run.edge_flags {
            None => assembly.run(run.count, |i| base + i, |_| true, out),
            Some(flags) => assembly.run(run.count, |i| base + i, |i| flags[i as usize], out),
        }
    }

    /// Makes room for vertices of a layout in the draw that is open, or in a new one. The caller appends the words to the vector that it
    /// gets, then calls [`finish_vertices`](Self::finish_vertices) and pushes primitives through [`primitives`](Self::primitives).
    /// Returns the number of the first vertex.
    pub fn begin_vertices(&mut self, layout: VertexLayout, current: &[[f32; 4]; ATTRIBUTES]) -> Option<(u32, &mut Vec<f32>)> {
        let reads = self.prepared.as_ref()?.vertex_program.attributes;
        let fits = self.open.as_ref().is_some_and(|open| {
            let sizes_equal = || slots(layout.mask).all(|s| open.layout.size[s] == layout.size[s]);
            open.layout.mask == layout.mask && sizes_equal() && slots(reads & !layout.mask).all(|s| open.constants[s] == current[s])
        });
        if !fits {
            self.open_draw(layout, current);
        }
        Some((self.open_vertices(), &mut self.batch.vertices))
    }

    /// Adds vertices, whose words were appended, to the open draw.
    pub fn finish_vertices(&mut self, count: u32) {
        if let Some(draw) = self.batch.draws.last_mut() {
            draw.record.vertex_count += count;
        }
    }

    /// Where primitives go, and the index of the open draw for their records.
    pub fn primitives(&mut self) -> (&mut Vec<Primitive>, u32) {
        (&mut self.batch.primitives, self.batch.draws.len().saturating_sub(1) as u32)
    }

    /// The vertex program of the state set before.
    pub fn vertex_program(&self) -> Option<&Arc<Program>> {
        self.prepared.as_ref().map(|prepared| &prepared.vertex_program)
    }

    fn open_vertices(&self) -> u32 {
        match (&self.open, self.batch.draws.last()) {
            (Some(_), Some(draw)) => draw.record.vertex_count,
            _ => 0,
        }
    }

    fn open_draw(&mut self, layout: VertexLayout, current: &[[f32; 4]; ATTRIBUTES]) {
        self.close_draw();
        let Some(prepared) = &self.prepared else { return };
        if self.batch.primitives.capacity() == 0 {
            self.batch.vertices.reserve(self.last_sizes[0]);
            self.batch.primitives.reserve(self.last_sizes[1]);
        }
        let mut record = prepared.record;
        let (offset, stride) = layout.offsets();
        record.vertex_word = self.batch.vertices.len() as u32;
        record.vertex_stride = stride;
        record.attribute_offset = offset;
        for slot in slots(layout.mask) {
            record.attribute_size[slot] = u32::from(layout.size[slot]);
        }
        let mut constants = [[0.0; 4]; ATTRIBUTES];
        for slot in slots(prepared.vertex_program.attributes & !layout.mask) {
            constants[slot] = current[slot];
        }
        record.constants = self.blocks.intern_block(&constants, &mut self.batch.uniforms);
        self.batch.draws.push(Draw {
            record,
            first_primitive: self.batch.primitives.len() as u32,
            vertex_program: prepared.vertex_program.clone(),
            fragment_program: prepared.fragment_program.clone(),
        });
        self.open = Some(Open { layout, constants });
    }

    /// Makes the constants in `grow` attributes of the open draw's vertices.
    fn relayout(&mut self, grow: u32) {
        let (Some(open), Some(draw)) = (&mut self.open, self.batch.draws.last_mut()) else { return };
        let record = &mut draw.record;
        let start = record.vertex_word as usize;
        let old = self.batch.vertices.split_off(start);
        let mask = open.layout.mask | grow;
        let (data, _) = old.as_chunks::<4>();
        let run = Run { mask: open.layout.mask, data, count: record.vertex_count, edge_flags: None };
        copy_run(&run, mask, &open.constants, &mut self.batch.vertices);
        open.layout = VertexLayout::full(mask);
        (record.attribute_offset, record.vertex_stride) = open.layout.offsets();
        for slot in slots(grow) {
            record.attribute_size[slot] = 4;
        }
    }

    fn close_draw(&mut self) {
        if self.open.take().is_some()
            && let Some(draw) = self.batch.draws.last_mut()
        {
            draw.record.shaded_base = self.batch.shaded_vec4;
            self.batch.shaded_vec4 += draw.record.vertex_count * draw.record.shaded_stride;
        }
    }

    fn close_step(&mut self) {
        let end = self.batch.primitives.len() as u32;
        if end > self.stepped {
            self.batch.steps.push(Step::Primitives { first: self.stepped, end });
            self.stepped = end;
        }
    }
}

/// Where the later stages find what the vertex program writes and the fragment program reads.
fn link(record: &mut DrawRecord, vertex_program: &Program, fragment_program: &Program) {
    let outputs = &vertex_program.outputs;
    let index_of = |output: Output| outputs.iter().position(|&o| o == output).map(|k| k as u32 + 1);
    let wanted = &fragment_program.varyings;
    for (word, varying) in record.varyings.iter_mut().zip(wanted) {
        let front = index_of(varying.front).unwrap_or(0);
        let back = index_of(varying.back).unwrap_or(front);
        *word = front | back << 8 | varying.interpolation << 16;
    }
    record.varying_count = wanted.len().min(MAX_VARYINGS) as u32;
    record.shaded_stride = 1 + outputs.len() as u32;
    record.clip_distances = index_of(Output::ClipDistance(0)).unwrap_or(NONE);
    record.point_size = index_of(Output::PointSize).unwrap_or(NONE);
}

/// Appends a run's vertices in another layout of four words a slot.
fn copy_run(run: &Run, mask: u32, current: &[[f32; 4]; ATTRIBUTES], out: &mut Vec<f32>) {
    let stride = run.mask.count_ones() as usize;
    // Where each attribute of the layout comes from: its rank in the run, or a constant.
    let mut sources = [(usize::MAX, [0.0; 4]); ATTRIBUTES];
    let mut used = 0;
    for slot in slots(mask) {
        let bit = 1 << slot;
        sources[used] =
            if run.mask & bit != 0 { ((run.mask & (bit - 1)).count_ones() as usize, [0.0; 4]) } else { (usize::MAX, current[slot]) };
        used += 1;
    }
    out.reserve(run.count as usize * used * 4);
    for vertex in run.data.chunks_exact(stride.max(1)).take(run.count as usize) {
        for &(rank, constant) in &sources[..used] {
            out.extend_from_slice(vertex.get(rank).unwrap_or(&constant));
        }
    }
}

fn intern_textures(lists: &mut HashMap<u64, u32, WordHasher>, all: &mut Vec<TextureBinding>, wanted: &[TextureBinding]) -> u32 {
    if wanted.is_empty() {
        return 0;
    }
    let mut words = Vec::with_capacity(wanted.len() * 18);
    for binding in wanted {
        let sampler = &binding.sampler;
        words.extend([binding.image.id as u32, (binding.image.id >> 32) as u32]);
        words.extend(sampler.wrap.map(|wrap| wrap as u32));
        words.extend([u32::from(sampler.mag_linear), u32::from(sampler.min_linear), sampler.mip_linear.map_or(2, u32::from)]);
        words.extend(sampler.lod_range.map(f32::to_bits));
        words.push(sampler.lod_bias.to_bits());
        words.extend(sampler.border.map(f32::to_bits));
    }
    let equal = |a: &TextureBinding, b: &TextureBinding| a.image.id == b.image.id && a.sampler == b.sampler;
    let key = hash_words(&words);
    if let Some(&first) = lists.get(&key)
        && all[first as usize..].len() >= wanted.len()
        && all[first as usize..].iter().zip(wanted).all(|(a, b)| equal(a, b))
    {
        return first;
    }
    let first = all.len() as u32;
    all.extend_from_slice(wanted);
    lists.insert(key, first);
    first
}
