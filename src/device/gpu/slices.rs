//! The plan of a batch that kernels set up: runs of primitives that one fine kernel can serve go by keys, or in slices that fit the buffers,
//! cut into segments that fit the lists.

use std::ops::Range;

use super::budget::{Cuts, Wanted};
use super::clears::{absorb_clears, clear_params};
use super::encode::{Action, FrontAction, Place, Plan, Planner, bins_of, front_base};
use super::fine::feature;
use super::front::{FrontRecords, Slice, vertex_blocks};
use super::params::{FrontParams, Params, SEGMENT_WORDS};
use super::segment::{Segment, needs};
use super::texture::Heap;
use super::visible;
use crate::draw::Step;

impl Planner<'_> {
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
                    let mut segment = Segment::new(&needs, self.format, draw as u32);
                    // Whether a triangle needs the division by w is not known here.
                    segment.key.features |= feature::PERSPECTIVE;
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

    /// Whether a run is one for keys.
    fn goes_by_keys(&self, run: &Run) -> bool {
        let program = &self.batch.draws[run.segment.draw as usize].fragment_program;
        self.keys_from(run.primitives.len())
            && self.room.slice_triangles >= self.visible_from
            && run.filled
            && visible::serves(&run.segment.key, program)
    }

    /// Whether no two triangles of a run share a vertex, and one short vertex program shades them all.
    fn is_soup(&self, run: &Run) -> bool {
        let program = &self.batch.draws[run.first_draw].vertex_program;
        let draws = self.batch.draws.iter().enumerate().skip(run.first_draw);
        let mut draws = draws.take_while(|(_, draw)| draw.first_primitive < run.primitives.end);
        visible::is_short(program)
            && draws.all(|(k, draw)| {
                let unshared = draw.record.vertex_count as usize >= self.batch.draw_primitives(k).len() * 3;
                unshared && draw.vertex_program.id == program.id && draw.record.shaded_stride as usize == program.outputs.len() + 1
            })
    }

    /// How the budget cuts pieces, and whether vertices are shaded where they are wanted: where all segments go by keys.
    fn cuts(&self, pieces: &[Piece]) -> (Cuts, bool) {
        let runs = || pieces.iter().filter_map(|piece| if let Piece::Run(run) = piece { Some(run) } else { None });
        let queue = |run: &Run| {
            let (params, words) = visible::params(self.room, run.primitives.clone(), FrontParams::default());
            words as u64 * 4 + params.pool_capacity as u64 * 16
        };
        let wanted = Wanted {
            size: self.size,
            bins: bins_of(self.size),
            shaded: self.batch.shaded_vec4 as u64 * 16,
            queue: runs().filter(|run| self.goes_by_keys(run)).map(queue).max(),
            slices: runs().any(|run| !self.goes_by_keys(run)),
            direct: self.shape.vectors() && self.direct_upto > 0,
            coherent: true,
        };
        let whole = Cuts::new(self.room.available, wanted);
        // Worth it where vertices are many for the pixels that are shaded, or where their room would cost cuts.
        let many = self.batch.shaded_vec4 as u64 >= self.soup_from.saturating_mul(self.size[0] as u64 * self.size[1] as u64);
        let cut = whole.key_rows < self.size[1];
        if (many || cut) && wanted.queue.is_some() && !wanted.slices && runs().all(|run| self.is_soup(run)) {
            let cuts = Cuts::new(self.room.available, Wanted { shaded: 0, ..wanted });
            if cuts.key_rows > 0 {
                return (cuts, true);
            }
        }
        if whole.vertices && self.count_slices(&whole) > self.count_slices(&Cuts { vertices: false, ..whole }) * 4 + 16 {
            return (Cuts::new(self.room.available, Wanted { coherent: false, ..wanted }), false);
        }
        (whole, false)
    }

    /// Into how many slices the batch is cut, segments left aside.
    fn count_slices(&self, cuts: &Cuts) -> usize {
        let (mut count, mut slice) = (1, Slice::new(self.shape, 0));
        for draw in 0..self.batch.draws.len() {
            let Range { start: mut at, end } = self.batch.draw_primitives(draw);
            while at < end {
                let fits = slice.fits(self.room, cuts, self.batch, draw, at..end);
                if fits == 0 {
                    (count, slice) = (count + 1, Slice::new(self.shape, 0));
                }
                slice.add(cuts, self.batch, draw, at..at + fits);
                at += fits;
            }
        }
        count
    }

    /// The plan of a batch that kernels set up, and the tables that go behind the front end's records.
    pub fn kernels(&self, heap: &Heap, records: &FrontRecords) -> (Plan, Vec<u32>) {
        let base = self.base();
        let pieces = self.pieces();
        let (cuts, soup) = self.cuts(&pieces);
        let mut plan = Plan { records: self.records(heap), soup, ..Plan::default() };
        let mut slices = Slices { planner: self, cuts, records, open: None, tables: Vec::new() };
        if !cuts.vertices && !soup {
            plan.vertex = slices.vertices(0..self.batch.shaded_vec4);
        }
        for piece in pieces {
            match piece {
                Piece::Clear(step, params) => plan.push(Place { step, primitive: 0 }, Action::Clear(params)),
                Piece::Run(run) if cuts.key_rows > 0 && self.goes_by_keys(&run) => {
                    let (all, most) = (run.primitives.clone(), self.room.slice_triangles.max(1));
                    for first in all.clone().step_by(most as usize) {
                        let primitives = first..all.end.min(first.saturating_add(most));
                        let (front, words) = visible::params(self.room, primitives, slices.front_base(0..self.batch.shaded_vec4));
                        plan.visible(run.step, run.segment.clone(), base, front, cuts.key_rows, words);
                    }
                }
                Piece::Run(run) => slices.add(&mut plan, run),
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
    primitives: Range<u32>,
    /// All of them are filled triangles.
    filled: bool,
}

/// Cuts runs into slices that fit the buffers, and slices into segments that fit the lists.
struct Slices<'a> {
    planner: &'a Planner<'a>,
    cuts: Cuts,
    records: &'a FrontRecords,
    /// The action of the open slice, and the slice.
    open: Option<(usize, Slice)>,
    /// What goes behind the records.
    tables: Vec<u32>,
}

impl Slices<'_> {
    /// What kernels of the front end know of the surface, the records, and the shaded vertices that are there; the pool is behind them.
    fn front_base(&self, shaded: Range<u32>) -> FrontParams {
        let count = shaded.end - shaded.start;
        FrontParams {
            state_base: self.records.state_base,
            shaded_base: shaded.start,
            shaded_count: count,
            pool_base: count,
            ..front_base(&self.planner.base())
        }
    }

    /// Dispatches of the vertex stage for shaded vertices in a range of vec4: a draw that runs the program, and parameters.
    fn vertices(&mut self, shaded: Range<u32>) -> Vec<(usize, FrontParams)> {
        let base = self.front_base(shaded.clone());
        let programs = vertex_blocks(self.planner.batch, shaded);
        let dispatch = |(draw, blocks): (usize, Vec<[u32; 2]>)| {
            let block_base = (self.records.words.len() + self.tables.len()) as u32;
            self.tables.extend_from_slice(blocks.as_flattened());
            (draw, FrontParams { block_base, vertex_blocks: blocks.len() as u32, ..base })
        };
        programs.into_iter().map(dispatch).collect()
    }

    fn add(&mut self, plan: &mut Plan, run: Run) {
        let Planner { batch, room, direct_upto, .. } = *self.planner;
        let cuts = self.cuts;
        let base = self.planner.base();
        let bins = bins_of(self.planner.size);
        let most = if cuts.direct_only { direct_upto } else { room.segment_triangles(bins) };
        let (mut at, mut draw) = (run.primitives.start, run.first_draw);
        while at < run.primitives.end {
            // A segment: as much of the run as the lists and the slice take.
            let place = Place { step: run.step, primitive: at };
            let (_, slice) = self.open.get_or_insert_with(|| {
                // Its parameters are known when it is full.
                plan.push(place, Action::Front(Box::default()));
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
                let fits = slice.fits(room, &cuts, batch, draw, at..at + left.min(end - at));
                if fits == 0 {
                    break;
                }
                slice.add(&cuts, batch, draw, at..at + fits);
                triangles = (triangles + fits * weight).min(most);
                at += fits;
            }
            let full = at < run.primitives.end && slice.fits(room, &cuts, batch, draw, at..at + 1) == 0;
            if at > first {
                let mut segment = run.segment.clone();
                let direct = self.planner.shape.vectors() && triangles <= direct_upto;
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
            let shaded = if self.cuts.vertices { slice.shaded.clone() } else { 0..self.planner.batch.shaded_vec4 };
            let vertex = if self.cuts.vertices { self.vertices(shaded.clone()) } else { Vec::new() };
            let [columns, rows] = self.planner.base().bins;
            let base = FrontParams { action: action as u32, bins: columns * rows, bin_rows: rows, ..self.front_base(shaded) };
            let params = slice.finish(self.planner.room, base, &mut self.tables, self.records.words.len() as u32);
            plan.actions[action].1 = Action::Front(Box::new(FrontAction { params, features: slice.features, vertex }));
        }
    }
}
