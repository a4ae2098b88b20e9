//! A batch becomes a plan: its records as words, and actions in order, each a clear, a slice of primitives to set up, or a segment of
//! triangles that one fine kernel can draw.

use std::collections::HashMap;

use bytemuck::cast_slice;

use super::adapter::Shape;
use super::clears::{absorb_clears, clear_params};
use super::fine::{FineKey, feature};
use super::host_front::HostFront;
use super::params::{FrontParams, Params, SEGMENT_WORDS};
use super::records::{DRAW_WORDS, pack_draw};
use super::room::Room;
use super::segment::{DrawNeeds, Segment, needs, served_flags};
use super::texture::Heap;
use super::visible;
use crate::device::SurfaceFormat;
use crate::draw::{Batch, Step};
use crate::raster::layout::*;

/// Words of an entry's record: see `shaders/tile.wgsl`.
pub const ENTRY_WORDS: u32 = 12;
/// Words of the list buffer in front of the masks.
pub const LIST_HEAD: u32 = 16;

/// What to do.
pub enum Action {
    /// Clear; its parameters are complete.
    Clear(Params),
    /// A clear of all pixels that the segment behind it does.
    Absorbed,
    /// Cull, set up and clip the primitives of the segments that follow.
    Front(Box<FrontAction>),
    /// Draw a segment by lists.
    Draw(Box<DrawAction>),
    /// Draw a segment by keys.
    Visible(Box<VisibleAction>),
}

/// A slice of primitives to set up.
#[derive(Default)]
pub struct FrontAction {
    /// Parameters.
    pub params: FrontParams,
    /// What the kernels contain: `stage::front::*`.
    pub features: u32,
    /// Where vertices are shaded slice by slice, what shades its own: see [`Plan::vertex`].
    pub vertex: Vec<(usize, FrontParams)>,
}

/// A segment to draw by keys: see `shaders/visible.wgsl`.
pub struct VisibleAction {
    /// Parameters of the surface.
    pub params: Params,
    /// Parameters of its primitives, for each band of rows that has keys in its turn.
    pub bands: Vec<FrontParams>,
    /// What shades it.
    pub key: FineKey,
    /// The draw that names its program.
    pub draw: u32,
}

/// A segment to draw.
pub struct DrawAction {
    /// Parameters but for the list buffer's offsets.
    pub params: Params,
    /// Its kernel.
    pub key: FineKey,
    /// The draw that names its program.
    pub draw: u32,
    /// Triangles, where the host has set them up: the list stages' sizes are known.
    pub triangles: Option<u32>,
    /// Blocks of 32 triangles that it may have.
    pub blocks: u32,
}

impl DrawAction {
    /// It has no lists.
    pub fn is_direct(&self) -> bool {
        self.key.features & feature::DIRECT != 0
    }
}

/// Where in the batch an action begins: step and primitive. A batch that stopped there goes on there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Place {
    /// Index of the step.
    pub step: usize,
    /// Index of the primitive.
    pub primitive: u32,
}

/// A batch ready for the GPU.
#[derive(Default)]
pub struct Plan {
    /// Draw records, states, texture bindings and stipples as words: what the fine stage reads.
    pub records: Vec<u32>,
    /// Records of the segments whose triangles the host has set up; as many words for the others.
    pub segments: Vec<u32>,
    /// What to do, in order.
    pub actions: Vec<(Place, Action)>,
    /// Words of masks that the largest segment needs.
    pub mask_words: u32,
    /// Words of the visible path's queue that the largest segment needs.
    pub queue_words: u32,
    /// The queue, where the host fills it.
    pub queue: Vec<u32>,
    /// What shades all vertices: for each program a draw that runs it, and parameters. Empty where slices shade their own.
    pub vertex: Vec<(usize, FrontParams)>,
    /// Most rows that have keys at a time.
    pub key_rows: u32,
    /// No two triangles share a vertex, and none is kept: see `shaders/shaded.wgsl`.
    pub soup: bool,
}

impl Plan {
    /// Appends an action.
    pub fn push(&mut self, place: Place, action: Action) {
        self.actions.push((place, action));
    }

    /// Appends a segment by lists, or by tiles alone.
    pub fn draw(&mut self, place: Place, segment: Segment, mut params: Params, triangles: Option<u32>, blocks: u32, list_blocks: u32) {
        let bins = params.bins[0] * params.bins[1];
        params.segment = self.segments.len() as u32 / SEGMENT_WORDS;
        params.action = self.actions.len() as u32;
        params.list_blocks = list_blocks;
        let mut words = [0; SEGMENT_WORDS as usize];
        if let Some(n) = triangles {
            words[1..4].copy_from_slice(&[n, blocks, blocks.div_ceil(32)]);
        }
        self.segments.extend(words);
        if segment.key.features & feature::DIRECT == 0 {
            self.mask_words = self.mask_words.max(bins * blocks);
        }
        let draw = segment.draw;
        self.push(place, Action::Draw(Box::new(DrawAction { params, key: segment.finish(), draw, triangles, blocks })));
    }

    fn set_up_visible(&mut self, place: Place, segment: Segment, triangles: &[Triangle], tiles: &[u32], first: usize, mut params: Params) {
        params.action = self.actions.len() as u32;
        if segment.key.features & feature::ONE_DRAW != 0 {
            params.draws += segment.draw * DRAW_WORDS as u32;
        }
        let front = visible::set_up(triangles, tiles, first, &mut self.queue, front_base(&params));
        self.key_rows = params.size[1];
        let draw = segment.draw;
        self.push(place, Action::Visible(Box::new(VisibleAction { params, bands: vec![front], key: segment.finish(), draw })));
    }

    /// A segment by keys, in bands of rows. It takes so many words of the queue.
    pub fn visible(&mut self, step: usize, segment: Segment, mut params: Params, front: FrontParams, rows: u32, queue_words: u32) {
        params.action = self.actions.len() as u32;
        let place = Place { step, primitive: front.first_primitive };
        self.queue_words = self.queue_words.max(queue_words);
        self.key_rows = self.key_rows.max(rows);
        let all = params.size[1];
        let bands =
            (0..all).step_by(rows as usize).map(|row| FrontParams { first_row: row, end_row: all.min(row + rows), ..front }).collect();
        let draw = segment.draw;
        self.push(place, Action::Visible(Box::new(VisibleAction { params, bands, key: segment.finish(), draw })));
    }
}

/// Bins of a surface.
pub fn bins_of(size: [u32; 2]) -> u32 {
    size.map(|s| s.div_ceil(BIN_SIZE)).iter().product()
}

/// What kernels of the front end know of the surface.
pub fn front_base(params: &Params) -> FrontParams {
    FrontParams { top_first: params.top_first, zero: params.zero, end_row: params.size[1], ..FrontParams::default() }
}

fn align4(words: &mut Vec<u32>) -> u32 {
    words.resize(words.len().next_multiple_of(4), 0);
    words.len() as u32
}

/// Rows from which on a triangle is tall: it fills most rows of most of its tiles.
const TALL_ROWS: u32 = 16;

/// A segment of triangles that the host has set up, while it grows.
struct OpenSegment {
    segment: Segment,
    /// Its first triangle.
    first: usize,
    /// Bins that its triangles may touch.
    touches: u64,
    /// Tiles that its triangles may touch; those of tall triangles.
    tiles: [u64; 2],
    /// Pixels of its triangles' rectangles.
    pixels: u64,
}

/// What all plans of a surface share.
pub struct Planner<'a> {
    /// The batch.
    pub batch: &'a Batch,
    /// Columns and rows.
    pub size: [u32; 2],
    /// Storage.
    pub format: SurfaceFormat,
    /// Kernel shape.
    pub shape: Shape,
    /// What fits.
    pub room: &'a Room,
    /// Triangles from which on a segment is drawn by keys where it may.
    pub visible_from: u32,
    /// Most pixels of the rectangles of such triangles, on average, where the host knows them.
    pub visible_pixels: u64,
    /// Most pixels of the tiles that they touch for each of them.
    pub visible_area: u64,
    /// Triangles up to which a segment needs no lists.
    pub direct_upto: u32,
    /// vec4 of shaded vertices to each pixel of the surface from which on those that no two triangles share are shaded where they are wanted.
    pub soup_from: u64,
}

impl Planner<'_> {
    /// Whether a segment of so many triangles is one for keys, if its state is.
    pub fn keys_from(&self, triangles: usize) -> bool {
        self.shape.keys64 && self.format.samples == 1 && triangles as u64 >= self.visible_from as u64
    }

    /// Parameters that all actions share.
    pub fn base(&self) -> Params {
        Params {
            size: self.size,
            bins: self.size.map(|s| s.div_ceil(BIN_SIZE)),
            top_first: self.format.top_first as u32,
            depth_max: ((1u64 << self.format.depth.bits()) - 1) as u32,
            zero: -0.0,
            magic: 8388608.0,
            samples: self.format.samples,
            ..Params::default()
        }
    }

    /// The records of draws, textures and stipples.
    pub fn records(&self, heap: &Heap) -> Vec<u32> {
        let batch = self.batch;
        let mut words = vec![0; batch.draws.len() * DRAW_WORDS];
        let stipples = align4(&mut words);
        words.extend_from_slice(cast_slice(&batch.polygon_stipples));
        let textures = align4(&mut words);
        heap.records(&batch.textures, &mut words);
        for index in 0..batch.draws.len() {
            let flags = served_flags(batch, index, self.format);
            words[index * DRAW_WORDS..][..DRAW_WORDS].copy_from_slice(&pack_draw(batch, index, flags, stipples, textures));
        }
        words
    }

    /// The plan of a batch that the host has set up.
    pub fn host(&self, front: &HostFront, heap: &Heap) -> Plan {
        let (batch, format, base) = (self.batch, self.format, self.base());
        let mut plan = Plan { records: self.records(heap), ..Plan::default() };
        let bins = base.bins[0] as u64 * base.bins[1] as u64;
        let most_triangles = self.room.most_blocks(bins as u32) as usize * 32;
        let mut known: HashMap<u32, DrawNeeds> = HashMap::new();
        let mut start = 0;
        for (k, (step, &end)) in batch.steps.iter().zip(&front.step_ends).enumerate() {
            if let Step::Clear(clear) = step {
                let place = Place { step: k, primitive: 0 };
                plan.actions.extend(clear_params(clear, base, format).map(|p| (place, Action::Clear(p))));
                continue;
            }
            let mut open: Option<OpenSegment> = None;
            let mut current = NONE;
            let close = |plan: &mut Plan, open: &mut Option<OpenSegment>, end: usize| {
                let Some(OpenSegment { mut segment, first, touches, tiles: [all, tall], pixels }) = open.take() else { return };
                let place = Place { step: k, primitive: front.triangles[first].primitive };
                let triangles = &front.triangles[first..end];
                let program = &batch.draws[segment.draw as usize].fragment_program;
                let count = triangles.len() as u64;
                let small = pixels <= self.visible_pixels.saturating_mul(count);
                if self.keys_from(triangles.len()) && self.shape.host_front && small && visible::serves_set_up(&segment.key, program) {
                    let tiles = visible::touched(triangles, self.size.map(|s| s.div_ceil(8)));
                    if tiles.len() as u64 * 64 <= self.visible_area.saturating_mul(count) {
                        let one = self.shape.subgroup8 && triangles.iter().all(|t| t.draw == segment.draw);
                        segment.key.features |= if one { feature::ONE_DRAW } else { 0 };
                        return plan.set_up_visible(place, segment, triangles, &tiles, first, base);
                    }
                }
                if segment.key.unrolls(self.shape, program) && tall * 2 >= all {
                    segment.key.features |= feature::TALL;
                }
                let (count, record) = ((end - first) as u32, plan.segments.len());
                plan.draw(place, segment, base, Some(count), count.div_ceil(32), (touches / 32 + bins) as u32);
                plan.segments[record] = first as u32;
            };
            for index in start..end {
                let t = &front.triangles[index];
                let span = |v: u32| ((v >> 16) / BIN_SIZE - (v & 0xffff) / BIN_SIZE + 1) as u64;
                let touched = span(t.columns) * span(t.rows);
                let full = open.as_ref().is_some_and(|OpenSegment { first, touches, .. }| {
                    index - first >= most_triangles || (touches + touched) / 32 + bins > self.room.most_list_blocks as u64
                });
                if t.draw != current || full {
                    current = t.draw;
                    let needs = known.entry(current).or_insert_with(|| needs(batch, current as usize, format));
                    if full || !open.as_mut().is_some_and(|open| open.segment.admit(needs, batch, current)) {
                        close(&mut plan, &mut open, index);
                        open = Some(OpenSegment {
                            segment: Segment::new(needs, format, current),
                            first: index,
                            touches: 0,
                            tiles: [0; 2],
                            pixels: 0,
                        });
                    }
                }
                if let Some(OpenSegment { segment, touches, tiles, pixels, .. }) = &mut open {
                    *touches += touched;
                    let [width, height] = visible::extent(t);
                    *pixels += width as u64 * height as u64;
                    let across = (t.columns >> 16) / 8 - (t.columns & 0xffff) / 8 + 1;
                    let visits = across as u64 * height.div_ceil(8) as u64;
                    tiles[0] += visits;
                    tiles[1] += if height >= TALL_ROWS { visits } else { 0 };
                    if t.flags & triangle_flags::PERSPECTIVE != 0 {
                        segment.key.features |= feature::PERSPECTIVE;
                    }
                }
            }
            close(&mut plan, &mut open, end);
            start = end;
        }
        absorb_clears(&mut plan.actions, format, false);
        plan
    }
}

/// Fills in a segment's offsets into the list buffer, behind `mask_capacity` words of masks. Returns the words it needs.
pub fn place_lists(action: &mut DrawAction, mask_capacity: u32) -> u32 {
    let (params, supers) = (&mut action.params, action.blocks.div_ceil(32));
    let bins = params.bins[0] * params.bins[1];
    params.mask_base = LIST_HEAD;
    params.count_base = LIST_HEAD + mask_capacity;
    // The fine stage loads a list's two words as one.
    params.bin_base = (params.count_base + bins * supers).next_multiple_of(2);
    params.active_base = params.bin_base + bins * 2;
    params.work_base = params.active_base + bins;
    params.list_base = params.work_base + bins * 64;
    params.tile_base = params.list_base + params.list_blocks * 32;
    // The fine stage loads entries four words at a time.
    params.entry_base = (params.tile_base + params.list_blocks * 64).next_multiple_of(4);
    params.entry_base + params.list_blocks * 32 * ENTRY_WORDS
}
