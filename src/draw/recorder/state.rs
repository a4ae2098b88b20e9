//! The state of draws: interned, so that a draw's record holds indices and equal states are told by comparing those.

use std::collections::HashMap;
use std::sync::Arc;

use bytemuck::Zeroable;

use super::Recorder;
use super::run::{VertexLayout, slots};
use crate::draw::Batch;
use crate::draw::interner::{Interner, WordHasher, hash_words};
use crate::draw::texture::TextureBinding;
use crate::program::{Output, Program};
use crate::raster::layout::*;

/// A part of a state, and the number of its last change: the recorder does not look at a part whose number it knows. Different
/// contents never have one number, except 0, which is always looked at.
pub struct Revised<'a, T: ?Sized> {
    /// The part.
    pub content: &'a T,
    /// Number of its last change.
    pub revision: u64,
}

impl<'a, T: ?Sized> From<&'a T> for Revised<'a, T> {
    /// A part without a number.
    fn from(content: &'a T) -> Self {
        Revised { content, revision: 0 }
    }
}

/// The state of a draw, as the state machine derives it.
pub struct DrawState<'a> {
    /// `topology::*`
    pub topology: u32,
    /// The vertex program.
    pub vertex_program: &'a Arc<Program>,
    /// The fragment program.
    pub fragment_program: &'a Arc<Program>,
    /// The vertex program's block.
    pub vertex_uniforms: Revised<'a, [[f32; 4]]>,
    /// The fragment program's block.
    pub fragment_uniforms: Revised<'a, [[f32; 4]]>,
    /// Clip to set-up; its `polygon_stipple` is filled in here. Its number tells of changes of `stipple` too.
    pub raster_state: Revised<'a, RasterState>,
    /// Per-fragment operations.
    pub fragment_state: Revised<'a, FragmentState>,
    /// Texture slots of the fragment program.
    pub textures: &'a [TextureBinding],
    /// Polygon stipple, where it is on.
    pub stipple: Option<&'a [u32; 32]>,
    /// User clip distances that the vertex program writes.
    pub clip_distance_count: u32,
}

/// Where a part is in the batch, by its number.
#[derive(Default)]
struct Place {
    revision: u64,
    index: u32,
}

impl Place {
    /// The index of a part: the one that is known, or what `intern` finds.
    fn of<T: ?Sized>(&mut self, part: &Revised<T>, intern: impl FnOnce(&T) -> u32) -> u32 {
        if part.revision == 0 || part.revision != self.revision {
            *self = Place { revision: part.revision, index: intern(part.content) };
        }
        self.index
    }
}

/// The parts of the state that was set last.
#[derive(Default)]
struct LastPlaces {
    vertex_uniforms: Place,
    fragment_uniforms: Place,
    raster_state: Place,
    fragment_state: Place,
}

/// What is in the batch already, by content.
#[derive(Default)]
pub(super) struct Tables {
    last: LastPlaces,
    blocks: Interner,
    raster_states: Interner,
    fragment_states: Interner,
    texture_lists: HashMap<u64, u32, WordHasher>,
    stipples: Interner,
}

/// A state whose parts are in the batch: the words of a draw's record that say where.
#[derive(Clone, Copy, PartialEq)]
struct Places {
    topology: u32,
    vertex_uniforms: u32,
    fragment_uniforms: u32,
    raster_state: u32,
    fragment_state: u32,
    first_texture: u32,
    clip_distance_count: u32,
}

impl Tables {
    /// Forgets all: for another batch.
    pub fn clear(&mut self) {
        for interner in [&mut self.blocks, &mut self.raster_states, &mut self.fragment_states, &mut self.stipples] {
            interner.clear();
        }
        self.texture_lists.clear();
        self.last = LastPlaces::default();
    }

    fn intern(&mut self, state: &DrawState, batch: &mut Batch) -> Places {
        let Tables { last, blocks, raster_states, fragment_states, texture_lists, stipples } = self;
        Places {
            topology: state.topology,
            vertex_uniforms: last.vertex_uniforms.of(&state.vertex_uniforms, |block| blocks.intern(&mut batch.uniforms, block)),
            fragment_uniforms: last.fragment_uniforms.of(&state.fragment_uniforms, |block| blocks.intern(&mut batch.uniforms, block)),
            raster_state: last.raster_state.of(&state.raster_state, |raster_state| {
                let polygon_stipple = state.stipple.map_or(NONE, |rows| stipples.intern(&mut batch.polygon_stipples, &[*rows]));
                raster_states.intern(&mut batch.raster_states, &[RasterState { polygon_stipple, ..*raster_state }])
            }),
            fragment_state: last
                .fragment_state
                .of(&state.fragment_state, |state| fragment_states.intern(&mut batch.fragment_states, std::slice::from_ref(state))),
            first_texture: intern_textures(texture_lists, &mut batch.textures, state.textures),
            clip_distance_count: state.clip_distance_count,
        }
    }
}

impl Places {
    fn put(&self, record: &mut DrawRecord) {
        record.topology = self.topology;
        record.vertex_uniforms = self.vertex_uniforms;
        record.fragment_uniforms = self.fragment_uniforms;
        record.raster_state = self.raster_state;
        record.fragment_state = self.fragment_state;
        record.first_texture = self.first_texture;
        record.clip_distance_count = self.clip_distance_count;
    }
}

/// The next draw: its state is interned, its vertices are those of the draw before until another layout comes.
pub(super) struct Prepared {
    /// Record without the place and the number of the vertices.
    pub record: DrawRecord,
    places: Places,
    /// The vertex program.
    pub vertex_program: Arc<Program>,
    /// The fragment program.
    pub fragment_program: Arc<Program>,
    /// Layout that the record has.
    layout: Option<VertexLayout>,
    /// Values of the attributes that the vertex program reads and the vertices do not have; else zero.
    pub constants: [[f32; 4]; ATTRIBUTES],
    /// Slots of `constants` that are in use, once the block is interned.
    constant_slots: Option<u32>,
}

impl Prepared {
    fn new(places: Places, state: &DrawState) -> Prepared {
        let mut record =
            DrawRecord { attribute_offset: [NONE; ATTRIBUTES], clip_distances: NONE, point_size: NONE, ..DrawRecord::zeroed() };
        places.put(&mut record);
        link(&mut record, state.vertex_program, state.fragment_program);
        Prepared {
            record,
            places,
            vertex_program: state.vertex_program.clone(),
            fragment_program: state.fragment_program.clone(),
            layout: None,
            constants: [[0.0; 4]; ATTRIBUTES],
            constant_slots: None,
        }
    }

    fn runs(&self, state: &DrawState) -> bool {
        self.vertex_program.id == state.vertex_program.id && self.fragment_program.id == state.fragment_program.id
    }

    /// Another vertex program.
    pub fn replace_vertex_program(&mut self, program: &Arc<Program>) {
        link(&mut self.record, program, &self.fragment_program);
        self.vertex_program = program.clone();
    }

    /// Describes the vertices of the next draw; what they do not have comes from `current`.
    pub fn describe_vertices(
        &mut self,
        layout: VertexLayout,
        current: &[[f32; 4]; ATTRIBUTES],
        tables: &mut Tables,
        uniforms: &mut Vec<[f32; 4]>,
    ) {
        if self.layout != Some(layout) {
            self.layout = Some(layout);
            let record = &mut self.record;
            (record.attribute_offset, record.vertex_stride) = layout.offsets();
            record.attribute_size = [0; ATTRIBUTES];
            for slot in slots(layout.mask) {
                record.attribute_size[slot] = u32::from(layout.size[slot]);
            }
        }
        let wanted = self.vertex_program.attributes & !layout.mask;
        // To the bit: -0 is another constant than 0.
        let equal = |slot: usize| self.constants[slot].map(f32::to_bits) == current[slot].map(f32::to_bits);
        if self.constant_slots == Some(wanted) && slots(wanted).all(equal) {
            return;
        }
        self.constant_slots = Some(wanted);
        self.constants = [[0.0; 4]; ATTRIBUTES];
        for slot in slots(wanted) {
            self.constants[slot] = current[slot];
        }
        self.record.constants = tables.blocks.intern(uniforms, &self.constants);
    }
}

impl Recorder {
    /// Sets the state of the draws that follow. The draw that is open stays so only if nothing changed.
    pub fn set_state(&mut self, state: &DrawState) {
        let places = self.tables.intern(state, &mut self.batch);
        let last = self.prepared.as_ref().filter(|prepared| prepared.runs(state));
        if last.is_some_and(|prepared| prepared.places == places) {
            return;
        }
        let same_programs = last.is_some();
        self.close_draw();
        match &mut self.prepared {
            Some(prepared) if same_programs => {
                prepared.places = places;
                places.put(&mut prepared.record);
            }
            prepared => *prepared = Some(Prepared::new(places, state)),
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
