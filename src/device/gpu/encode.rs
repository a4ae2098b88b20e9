//! A batch becomes a plan: its records as words, and actions in order, each a clear, a slice of primitives to set up, or a segment of
//! triangles that one fine kernel can draw.

use std::collections::HashMap;

use bytemuck::cast_slice;

use super::adapter::Shape;
use super::clears::{absorb_clears, clear_params};
use super::fine::{FineKey, feature};
use super::front::Slice;
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
    /// Cull, set up and clip the primitives of the segments that follow; its parameters, and what the kernels contain (`stage::front`).
    Front(FrontParams, u32),
    /// Draw a segment by lists.
    Draw(Box<DrawAction>),
    /// Draw a segment by keys.
    Visible(Box<VisibleAction>),
}

/// A segment to draw by keys: see `shaders/visible.wgsl`.
pub struct VisibleAction {
    /// Parameters of the surface.
    pub params: Params,
    /// Parameters of its primitives.
    pub front: FrontParams,
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
}

impl Plan {
    fn push(&mut self, place: Place, action: Action) {
        self.actions.push((place, action));
    }

    fn draw(&mut self, place: Place, segment: Segment, mut params: Params, triangles: Option<u32>, blocks: u32, list_blocks: u32) {
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
        let draw = segment.draw;
        self.push(place, Action::Visible(Box::new(VisibleAction { params, front, key: segment.finish(), draw })));
    }

    fn visible(&mut self, step: usize, segment: Segment, primitives: std::ops::Range<u32>, mut params: Params, room: &Room) {
        params.action = self.actions.len() as u32;
        let place = Place { step, primitive: primitives.start };
        let (front, words) = visible::params(room, primitives, front_base(&params));
        self.queue_words = self.queue_words.max(words);
        let draw = segment.draw;
        self.push(place, Action::Visible(Box::new(VisibleAction { params, front, key: segment.finish(), draw })));
    }
}

/// What the kernels of keys know of the surface.
fn front_base(params: &Params) -> FrontParams {
    FrontParams { top_first: params.top_first, zero: params.zero, ..FrontParams::default() }
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
}

impl Planner<'_> {
    /// Whether a segment of so many triangles is one for keys, if its state is.
    fn keys_from(&self, triangles: usize) -> bool {
        self.shape.keys64 && self.format.samples == 1 && triangles as u64 >= self.visible_from as u64
    }

    fn base(&self) -> Params {
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
    fn records(&self, heap: &Heap) -> Vec<u32> {
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

    /// The batch's clears, and its primitives as runs that one fine kernel can serve.
    fn pieces(&self) -> Vec<Piece> {
        let (batch, base) = (self.batch, self.base());
        let mut pieces = Vec::new();
        let mut draw = 0;
        for (step, what) in batch.steps.iter().enumerate() {
            let (first, end) = match *what {
                Step::Primitives { first, end } => (first, end),
                Step::Clear(ref clear) => {
                    pieces.extend(clear_params(clear, base, self.format).map(|params| Piece::Clear(step, params)));
                    continue;
                }
            };
            let mut open: Option<Run> = None;
            while draw < batch.draws.len() && batch.draw_primitives(draw).end <= first {
                draw += 1;
            }
            while draw < batch.draws.len() && batch.draw_primitives(draw).start < end {
                let range = batch.draw_primitives(draw);
                let primitives = range.start.max(first)..range.end.min(end);
                let needs = needs(batch, draw, self.format);
                let filled = visible::is_filled(batch, draw);
                if !open.as_mut().is_some_and(|run| run.filled == filled && run.segment.admit(&needs, batch, draw as u32)) {
                    pieces.extend(open.take().map(Piece::Run));
                    let segment = Segment::new(&needs, self.format, draw as u32);
                    open = Some(Run { step, first_draw: draw, segment, primitives: primitives.clone(), filled });
                }
                if let Some(run) = &mut open {
                    run.primitives.end = primitives.end;
                }
                if range.end > end {
                    break;
                }
                draw += 1;
            }
            pieces.extend(open.take().map(Piece::Run));
        }
        pieces
    }

    /// The plan of a batch that kernels set up, and the slices' tables, which go behind `table_base` words of the front end's records.
    pub fn kernels(&self, heap: &Heap, table_base: u32) -> (Plan, Vec<u32>) {
        let base = self.base();
        let mut plan = Plan { records: self.records(heap), ..Plan::default() };
        let mut slices = Slices { planner: self, open: None, tables: Vec::new(), table_base };
        for piece in self.pieces() {
            match piece {
                Piece::Clear(step, params) => plan.push(Place { step, primitive: 0 }, Action::Clear(params)),
                Piece::Run(mut run) => {
                    // Whether a triangle needs the division by w is not known here.
                    run.segment.key.features |= feature::PERSPECTIVE;
                    let program = &self.batch.draws[run.segment.draw as usize].fragment_program;
                    if self.keys_from(run.primitives.len())
                        && self.room.slice_triangles >= self.visible_from
                        && run.filled
                        && visible::serves(&run.segment.key, program)
                    {
                        let (all, most) = (run.primitives.clone(), self.room.slice_triangles.max(1));
                        for first in all.clone().step_by(most as usize) {
                            let primitives = first..all.end.min(first.saturating_add(most));
                            plan.visible(run.step, run.segment.clone(), primitives, base, self.room);
                        }
                    } else {
                        slices.add(&mut plan, run);
                    }
                }
            }
        }
        slices.close(&mut plan);
        absorb_clears(&mut plan.actions, self.format, self.shape.vectors());
        (plan, slices.tables)
    }
}

/// A part of a batch.
enum Piece {
    /// A clear in a step.
    Clear(usize, Params),
    /// Primitives.
    Run(Run),
}

/// Primitives of a step that one fine kernel can serve.
struct Run {
    step: usize,
    first_draw: usize,
    segment: Segment,
    primitives: std::ops::Range<u32>,
    /// All of them are filled triangles.
    filled: bool,
}

/// Cuts runs into slices that fit the buffers, and slices into segments that fit the lists.
struct Slices<'a> {
    planner: &'a Planner<'a>,
    /// The action of the open slice, and the slice.
    open: Option<(usize, Slice)>,
    tables: Vec<u32>,
    table_base: u32,
}

impl Slices<'_> {
    fn add(&mut self, plan: &mut Plan, run: Run) {
        let Planner { batch, room, .. } = *self.planner;
        let base = self.planner.base();
        let bins = base.bins[0] * base.bins[1];
        let most = room.segment_triangles(bins);
        let (mut at, mut draw) = (run.primitives.start, run.first_draw);
        while at < run.primitives.end {
            // A segment: as much of the run as the lists and the slice take.
            let place = Place { step: run.step, primitive: at };
            let (_, slice) = self.open.get_or_insert_with(|| {
                // Its parameters are known when it is full.
                plan.push(place, Action::Front(FrontParams::default(), 0));
                (plan.actions.len() - 1, Slice::new(self.planner.shape, plan.segments.len() as u32 / SEGMENT_WORDS))
            });
            let (first, mut triangles) = (at, 0);
            while at < run.primitives.end {
                let end = batch.draw_primitives(draw).end.min(run.primitives.end);
                if end <= at {
                    draw += 1;
                    continue;
                }
                let weight = slice.weight(batch, draw);
                // A segment takes at least one primitive, whatever it weighs.
                let left = if at == first { ((most - triangles) / weight).max(1) } else { (most - triangles) / weight };
                let fits = left.min(slice.fits(room, batch, draw)).min(end - at);
                if fits == 0 {
                    break;
                }
                slice.add(batch, draw, fits);
                triangles = (triangles + fits * weight).min(most);
                at += fits;
            }
            let full = at < run.primitives.end && slice.fits(room, batch, draw) == 0;
            if at > first {
                let mut segment = run.segment.clone();
                let direct = self.planner.shape.vectors() && triangles <= self.planner.direct_upto;
                let (blocks, list_blocks) = if direct {
                    segment.key.features |= feature::DIRECT;
                    // Nothing grows with them.
                    (u32::MAX, 0)
                } else {
                    (room.segment_blocks(triangles, bins), room.lists(triangles, bins))
                };
                slice.segment(first..at, blocks);
                plan.draw(place, segment, base, None, blocks, list_blocks);
            }
            if full {
                self.close(plan);
            }
        }
    }

    fn close(&mut self, plan: &mut Plan) {
        if let Some((action, slice)) = self.open.take() {
            let params = slice.finish(self.planner.room, self.planner.base(), &mut self.tables, self.table_base, action as u32);
            plan.actions[action].1 = Action::Front(params, slice.features);
        }
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
