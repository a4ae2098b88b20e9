//! The recorder: owns the batch under construction, interns what its draws see, and merges consecutive draws of equal
//! state.
//!
//! A draw stays open for more vertices until its state changes. An attribute that changes only from call to call
//! (glColor between two Begin/End pairs) is a constant of the draw; when the next call brings another value, the draw is small
//! and all else is equal, the attribute becomes one of its vertices instead, so that the two calls stay one draw.

use std::sync::Arc;

use super::assembly::{Assembly, Decomposition, Part, PrimitiveType};
use super::{Batch, Clear, Draw, Step};
use crate::program::Program;
use crate::raster::layout::*;

mod run;
mod state;

pub use run::{Run, VertexLayout, slots};
pub use state::{DrawState, Revised};

use run::copy_run;
use state::{Prepared, Tables};

/// Most vertices of a draw that are laid out anew to make a constant an attribute.
const RELAYOUT_LIMIT: u32 = 1024;

/// Turns draws into a batch.
#[derive(Default)]
pub struct Recorder {
    batch: Batch,
    budget: usize,
    /// Layout of the last draw, while it takes vertices.
    open: Option<VertexLayout>,
    prepared: Option<Prepared>,
    /// Primitives before this one are in a step.
    stepped: u32,
    tables: Tables,
    /// Capacity that the last batch needed: vertices, primitives, draws.
    last_sizes: [usize; 3],
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
        self.tables.clear();
        self.last_sizes = [self.batch.vertices.len(), self.batch.primitives.len(), self.batch.draws.len()];
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

    /// Another vertex program for the draws that follow, with the state set before.
    pub fn replace_vertex_program(&mut self, program: &Arc<Program>) {
        self.close_draw();
        if let Some(prepared) = &mut self.prepared {
            prepared.replace_vertex_program(program);
        }
    }

    /// The state has to be set again before the next draw.
    pub fn forget_state(&mut self) {
        self.close_draw();
        self.prepared = None;
    }

    /// Draws a run of vertices in the state set before. Attributes that the run does not have come from `current`.
    pub fn draw_run(&mut self, mode: PrimitiveType, part: Part, decomposition: Decomposition, run: &Run, current: &[[f32; 4]; ATTRIBUTES]) {
        let Some(prepared) = &self.prepared else { return };
        let reads = prepared.vertex_program.attributes;
        let wanted = run.mask & (reads | 1);
        let fits = match &self.open {
            Some(layout) if layout.size == [4; ATTRIBUTES] => {
                let constant = reads & !layout.mask;
                let missing = constant & wanted;
                let differs = |&s: &usize| prepared.constants[s] != current[s];
                let differing = slots(constant & !wanted).filter(differs).fold(0, |mask, s| mask | 1 << s);
                Some(missing | differing)
            }
            _ => None,
        };
        match fits {
            Some(0) => {}
            Some(grow) if self.open_vertices() <= RELAYOUT_LIMIT && run.count <= RELAYOUT_LIMIT => self.relayout(grow),
            _ => self.open_draw(VertexLayout::full(wanted), current),
        }
        let Some(layout) = self.open else { return };
        let base = self.open_vertices();
        let vertices = &mut self.batch.vertices;
        if layout.mask == run.mask {
            vertices.extend_from_slice(run.data.as_flattened());
        } else {
            copy_run(run, layout.mask, current, vertices);
        }
        self.finish_vertices(run.count);
        let draw = (self.batch.draws.len() - 1) as u32;
        let assembly = Assembly { mode, part, decomposition, draw };
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
        let prepared = self.prepared.as_ref()?;
        let reads = prepared.vertex_program.attributes;
        let fits = self.open.as_ref().is_some_and(|open| {
            let sizes_equal = || slots(layout.mask).all(|s| open.size[s] == layout.size[s]);
            open.mask == layout.mask && sizes_equal() && slots(reads & !layout.mask).all(|s| prepared.constants[s] == current[s])
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
        let Some(prepared) = &mut self.prepared else { return };
        let batch = &mut self.batch;
        if batch.draws.is_empty() {
            batch.reuse_memory(self.last_sizes);
        }
        prepared.describe_vertices(layout, current, &mut self.tables, &mut batch.uniforms);
        prepared.record.vertex_word = batch.vertices.len() as u32;
        batch.draws.push(Draw {
            record: prepared.record,
            first_primitive: batch.primitives.len() as u32,
            vertex_program: prepared.vertex_program.clone(),
            fragment_program: prepared.fragment_program.clone(),
        });
        self.open = Some(layout);
    }

    /// Makes the constants in `grow` attributes of the open draw's vertices.
    fn relayout(&mut self, grow: u32) {
        let (Some(layout), Some(prepared), Some(draw)) = (&mut self.open, &self.prepared, self.batch.draws.last_mut()) else { return };
        let record = &mut draw.record;
        let start = record.vertex_word as usize;
        let old = self.batch.vertices.split_off(start);
        let mask = layout.mask | grow;
        let (data, _) = old.as_chunks::<4>();
        let run = Run { mask: layout.mask, data, count: record.vertex_count, edge_flags: None };
        copy_run(&run, mask, &prepared.constants, &mut self.batch.vertices);
        *layout = VertexLayout::full(mask);
        (record.attribute_offset, record.vertex_stride) = layout.offsets();
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
