//! The front end on the host: the Rust twins of vertex, clip and set-up make triangles and planes, which are then
//! uploaded in the layouts that the set-up kernel would write.

use rayon::prelude::*;

use crate::draw::{Batch, Step};
use crate::raster::layout::Triangle;
use crate::raster::setup::{Chunk, SetupInput};
use crate::raster::vertex::{self, ScreenVertex, VertexWorker};

/// Primitives in a run.
const RUN: u32 = 2048;

/// Memory that is kept from batch to batch, and the result of the last one.
#[derive(Default)]
pub struct HostFront {
    shaded: Vec<[f32; 4]>,
    screen: Vec<ScreenVertex>,
    chunks: Vec<Chunk>,
    /// Triangles of all steps, in order.
    pub triangles: Vec<Triangle>,
    /// Their planes.
    pub planes: Vec<[f32; 4]>,
    /// For each step of the batch, one past its last triangle.
    pub step_ends: Vec<usize>,
}

impl HostFront {
    /// Sets up a batch.
    pub fn run(&mut self, batch: &Batch, top_first: bool) {
        let screen_base = self.shade(batch);
        let runs: Vec<(usize, u32, u32)> = (batch.steps.iter().enumerate())
            .flat_map(|(k, step)| {
                let (first, end) = if let Step::Primitives { first, end } = *step { (first, end) } else { (0, 0) };
                (first..end).step_by(RUN as usize).map(move |f| (k, f, (f + RUN).min(end)))
            })
            .collect();
        if self.chunks.len() < runs.len() {
            self.chunks.resize_with(runs.len(), Chunk::default);
        }
        let input = SetupInput { batch, shaded: &self.shaded, screen: &self.screen, screen_base: &screen_base, top_first };
        let chunks = &mut self.chunks[..runs.len()];
        let set_up = |(chunk, &(_, first, end)): (&mut Chunk, &(usize, u32, u32))| {
            chunk.clear();
            chunk.run(&input, first, end);
        };
        if runs.len() > 1 {
            chunks.par_iter_mut().zip(&runs).for_each(set_up);
        } else {
            chunks.iter_mut().zip(&runs).for_each(set_up);
        }
        self.triangles.clear();
        self.planes.clear();
        self.step_ends.clear();
        let mut next = 0;
        for k in 0..batch.steps.len() {
            while next < runs.len() && runs[next].0 == k {
                let base = self.planes.len() as u32;
                self.triangles.extend(chunks[next].triangles.iter().map(|t| Triangle { planes: t.planes + base, ..*t }));
                self.planes.extend_from_slice(&chunks[next].planes);
                next += 1;
            }
            self.step_ends.push(self.triangles.len());
        }
    }

    /// Shades all vertices. Returns the first [`ScreenVertex`] of each draw.
    fn shade(&mut self, batch: &Batch) -> Vec<u32> {
        let (bases, blocks) = vertex::blocks(batch, &mut self.shaded, &mut self.screen);
        blocks.into_par_iter().with_min_len(8).for_each_init(VertexWorker::default, |w, block| w.block(batch, block));
        bases
    }
}
