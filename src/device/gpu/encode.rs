//! A batch becomes a plan: its records as words, and steps, each a clear or a segment of triangles that one fine
//! kernel can draw.

use std::collections::HashMap;

use bytemuck::cast_slice;

use super::front::HostFront;
use super::kernels::{BlendKey, FineKey, feature};
use super::params::Params;
use super::records::{DRAW_WORDS, pack_draw};
use super::texture::{Heap, TextureClass};
use crate::device::{ColorFormat, DepthFormat, SurfaceFormat};
use crate::draw::{Batch, Clear, Step};
use crate::raster::layout::*;
use crate::raster::{blend::mask_bits, formats};

/// Words of an entry's record: see `shaders/tile.wgsl`.
pub const ENTRY_WORDS: u32 = 12;
/// Words of the list buffer in front of the masks.
pub const LIST_HEAD: u32 = 16;
/// Most blocks of 32 entries in the lists of one segment: their words fit a binding of 128 MiB beside the rest.
const MOST_LIST_BLOCKS: u64 = 56_000;
/// Most words of masks.
const MOST_MASK_WORDS: u64 = 8 << 20;

/// A step of a plan.
pub enum Action {
    /// Clear; its parameters are complete.
    Clear(Params),
    /// Draw a segment: its parameters but for the list buffer's offsets, its kernel, and the draw that names its program.
    Draw(Params, Box<FineKey>, u32),
}

/// A batch ready for the GPU.
#[derive(Default)]
pub struct Plan {
    /// Draw records, states, texture bindings and stipples as words.
    pub records: Vec<u32>,
    /// What to do, in order.
    pub actions: Vec<Action>,
    /// Words of masks that the largest segment needs.
    pub mask_words: u32,
}

/// What a draw asks of the fine kernel.
#[derive(Clone)]
struct DrawNeeds {
    program: u64,
    features: u32,
    /// Flags of the fragment state that decide between features.
    flags: u32,
    blend: Option<([u32; 4], [u32; 2])>,
    depth_func: u32,
    textures: Vec<TextureClass>,
}

/// The fragment flags of a draw that the surface's buffers can serve.
fn served_flags(batch: &Batch, index: usize, format: SurfaceFormat) -> u32 {
    let mut flags = batch.fragment_states[batch.draws[index].record.fragment_state as usize].flags;
    if format.depth == DepthFormat::None {
        flags &= !(fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE);
    }
    if !format.stencil {
        flags &= !fragment_flags::STENCIL_TEST;
    }
    if format.color == ColorFormat::Rgba32f {
        flags &= !fragment_flags::LOGIC_OP;
    }
    flags
}

fn needs(batch: &Batch, index: usize, format: SurfaceFormat) -> DrawNeeds {
    let draw = &batch.draws[index];
    let state = &batch.fragment_states[draw.record.fragment_state as usize];
    let raster = &batch.raster_states[draw.record.raster_state as usize];
    let program = &*draw.fragment_program;
    let flags = served_flags(batch, index, format);
    let on = |bit: u32| flags & bit != 0;
    let mut features = 0;
    let mut set = |bit: u32, on: bool| features |= if on { bit } else { 0 };
    set(feature::DEPTH_TEST, on(fragment_flags::DEPTH_TEST));
    set(feature::DEPTH_WRITE, on(fragment_flags::DEPTH_TEST) && on(fragment_flags::DEPTH_WRITE));
    set(feature::STENCIL_TEST, on(fragment_flags::STENCIL_TEST));
    set(feature::DEPTH_BUFFER, on(fragment_flags::DEPTH_TEST) || on(fragment_flags::STENCIL_TEST));
    set(feature::ALPHA_TEST, on(fragment_flags::ALPHA_TEST));
    set(feature::STIPPLE, batch.polygon_stipples.len() > raster.polygon_stipple as usize);
    let color = state.color_mask & 15 != 0;
    set(feature::COLOR_WRITE, color);
    set(feature::COLOR_MASK, color && state.color_mask & 15 != 15);
    set(feature::BLEND, color && on(fragment_flags::BLEND));
    set(feature::LOGIC_OP, color && on(fragment_flags::LOGIC_OP));
    set(feature::SHADES, color || on(fragment_flags::ALPHA_TEST) || program.discards || program.writes_depth);
    let shades = color || on(fragment_flags::ALPHA_TEST) || program.discards || program.writes_depth;
    let first = draw.record.first_texture as usize;
    let slots = if shades { program.texture_slots as usize } else { 0 };
    let textures = (first..first + slots).map(|k| batch.textures.get(k).map_or(TextureClass::NONE, TextureClass::new)).collect();
    let blend = (color && on(fragment_flags::BLEND)).then_some((state.blend_factors, state.blend_equations));
    let deciding = fragment_flags::DEPTH_TEST
        | fragment_flags::DEPTH_WRITE
        | fragment_flags::STENCIL_TEST
        | fragment_flags::ALPHA_TEST
        | fragment_flags::BLEND
        | fragment_flags::LOGIC_OP;
    DrawNeeds { program: program.id, features, flags: flags & deciding, blend, depth_func: state.depth_func, textures }
}

/// A segment that grows draw by draw.
struct Segment {
    key: FineKey,
    flags: u32,
    draw: u32,
    first: usize,
    touches: u64,
}

impl Segment {
    fn new(needs: &DrawNeeds, format: SurfaceFormat, draw: u32, first: usize) -> Segment {
        let blend = needs.blend.map_or(BlendKey::Fixed([0; 4], [0; 2]), |(f, e)| BlendKey::Fixed(f, e));
        let key = FineKey {
            program: needs.program,
            color: format.color,
            features: needs.features,
            blend,
            depth_func: Some(needs.depth_func),
            depth_bits: format.depth.bits(),
            textures: needs.textures.clone(),
        };
        Segment { key, flags: needs.flags, draw, first, touches: 0 }
    }

    /// Takes a draw in, if one kernel can serve it too.
    fn admit(&mut self, needs: &DrawNeeds, batch: &Batch, draw: u32) -> bool {
        let shades = feature::SHADES;
        let (ours, theirs) = (&batch.draws[self.draw as usize].fragment_program, &batch.draws[draw as usize].fragment_program);
        let same = ours.id == theirs.id;
        // Flat and smooth shading run the same text over the same inputs.
        if !same && (ours.inputs != theirs.inputs || ours.varyings.len() != theirs.varyings.len() || ours.wgsl != theirs.wgsl) {
            return false;
        }
        if self.key.textures != needs.textures || (self.key.features ^ needs.features) & shades != 0 {
            return false;
        }
        if !same {
            self.key.features |= feature::MIXED_INTERPOLATION;
        }
        if needs.flags != self.flags {
            self.key.features |= feature::MIXED;
        }
        // Colours that some draws do not write at all: their mask says so.
        if (self.key.features ^ needs.features) & feature::COLOR_WRITE != 0 {
            self.key.features |= feature::COLOR_MASK;
        }
        if needs.features & feature::DEPTH_TEST != 0 {
            if self.key.features & feature::DEPTH_TEST == 0 {
                self.key.depth_func = Some(needs.depth_func);
            } else if self.key.depth_func != Some(needs.depth_func) {
                self.key.depth_func = None;
            }
        }
        if let Some((f, e)) = needs.blend {
            if self.key.features & feature::BLEND == 0 {
                self.key.blend = BlendKey::Fixed(f, e);
            } else if self.key.blend != BlendKey::Fixed(f, e) {
                self.key.blend = BlendKey::Dynamic;
            }
        }
        self.key.features |= needs.features;
        true
    }
}

/// A clear as parameters; `None` where it writes nothing.
fn clear_params(clear: &Clear, mut params: Params, format: SurfaceFormat) -> Option<Params> {
    for k in 0..2 {
        params.clear_min[k] = clear.min[k].max(0);
        params.clear_max[k] = clear.max[k].min(params.size[k] as i32);
        if params.clear_min[k] >= params.clear_max[k] {
            return None;
        }
    }
    if clear.color_mask & 15 != 0 {
        let words = format.color.words();
        formats::pack(format.color, clear.color, &mut params.clear_color[..words]);
        formats::mask(format.color, mask_bits(clear.color_mask), &mut params.clear_mask[..words]);
    }
    if let (Some(depth), true) = (clear.depth, format.depth != DepthFormat::None) {
        params.clear_depth |= (depth.clamp(0.0, 1.0) * ((1u32 << format.depth.bits()) - 1) as f64) as u32;
        params.clear_depth_mask |= 0xff_ffff;
    }
    if let (Some((stencil, writes)), true) = (clear.stencil, format.stencil) {
        params.clear_depth |= ((stencil & writes) as u32) << 24;
        params.clear_depth_mask |= (writes as u32) << 24;
    }
    (params.clear_mask != [0; 4] || params.clear_depth_mask != 0).then_some(params)
}

fn align4(words: &mut Vec<u32>) -> u32 {
    words.resize(words.len().next_multiple_of(4), 0);
    words.len() as u32
}

/// Makes the plan of a batch whose front end has run.
pub fn plan(batch: &Batch, front: &HostFront, heap: &mut Heap, size: [u32; 2], format: SurfaceFormat) -> Plan {
    let mut plan = Plan::default();
    let base = Params {
        size,
        bins: size.map(|s| s.div_ceil(BIN_SIZE)),
        top_first: format.top_first as u32,
        depth_max: ((1u64 << format.depth.bits()) - 1) as u32,
        ..Params::default()
    };
    let words = &mut plan.records;
    words.resize(batch.draws.len() * DRAW_WORDS, 0);
    let stipples = align4(words);
    words.extend_from_slice(cast_slice(&batch.polygon_stipples));
    let textures = align4(words);
    heap.records(&batch.textures, words);
    for index in 0..batch.draws.len() {
        let flags = served_flags(batch, index, format);
        words[index * DRAW_WORDS..][..DRAW_WORDS].copy_from_slice(&pack_draw(batch, index, flags, stipples, textures));
    }

    let bins = base.bins[0] as u64 * base.bins[1] as u64;
    let most_triangles = (MOST_MASK_WORDS / bins.max(1)).max(32) as usize * 32;
    let mut known: HashMap<u32, DrawNeeds> = HashMap::new();
    let mut start = 0;
    let mut segment: Option<Segment> = None;
    let mut current = NONE;
    for (step, &end) in batch.steps.iter().zip(&front.step_ends) {
        if let Step::Clear(clear) = step {
            if let Some(s) = segment.take() {
                finish(&mut plan, s, start, base, bins);
            }
            current = NONE;
            plan.actions.extend(clear_params(clear, base, format).map(Action::Clear));
            continue;
        }
        for index in start..end {
            let t = &front.triangles[index];
            let span = |v: u32| ((v >> 16) / BIN_SIZE - (v & 0xffff) / BIN_SIZE + 1) as u64;
            let touches = span(t.columns) * span(t.rows);
            let full =
                segment.as_ref().is_some_and(|s| index - s.first >= most_triangles || (s.touches + touches) / 32 + bins > MOST_LIST_BLOCKS);
            if t.draw != current || full {
                current = t.draw;
                let needs = known.entry(current).or_insert_with(|| needs(batch, current as usize, format));
                let admitted = !full && segment.as_mut().is_some_and(|s| s.admit(needs, batch, current));
                if !admitted {
                    if let Some(s) = segment.take() {
                        finish(&mut plan, s, index, base, bins);
                    }
                    segment = Some(Segment::new(needs, format, current, index));
                }
            }
            if let Some(s) = &mut segment {
                s.touches += touches;
                if t.flags & triangle_flags::PERSPECTIVE != 0 {
                    s.key.features |= feature::PERSPECTIVE;
                }
            }
        }
        start = end;
    }
    if let Some(s) = segment {
        finish(&mut plan, s, start, base, bins);
    }
    plan
}

fn finish(plan: &mut Plan, mut segment: Segment, end: usize, base: Params, bins: u64) {
    if segment.key.features & feature::DEPTH_TEST == 0 {
        segment.key.depth_func = None;
    }
    let mut params = base;
    params.first_triangle = segment.first as u32;
    params.triangle_count = (end - segment.first) as u32;
    params.blocks = params.triangle_count.div_ceil(32);
    params.supers = params.blocks.div_ceil(32);
    params.list_blocks = (segment.touches / 32 + bins) as u32;
    plan.mask_words = plan.mask_words.max((bins * params.blocks as u64) as u32);
    plan.actions.push(Action::Draw(params, Box::new(segment.key), segment.draw));
}

/// Fills in a segment's offsets into the list buffer, behind `mask_capacity` words of masks. Returns the words it needs.
pub fn place_lists(params: &mut Params, mask_capacity: u32) -> u32 {
    let bins = params.bins[0] * params.bins[1];
    params.mask_base = LIST_HEAD;
    params.count_base = LIST_HEAD + mask_capacity;
    params.bin_base = params.count_base + bins * params.supers;
    params.active_base = params.bin_base + bins * 2;
    params.work_base = params.active_base + bins;
    params.list_base = params.work_base + bins * 64;
    params.tile_base = params.list_base + params.list_blocks * 32;
    params.entry_base = params.tile_base + params.list_blocks * 64;
    params.entry_base + params.list_blocks * 32 * ENTRY_WORDS
}
