//! The front end on the host: the Rust twins of vertex, clip and set-up make triangles and planes, which are then
//! uploaded in the layouts that the set-up kernel would write.

use rayon::prelude::*;

use crate::draw::Batch;
use crate::raster::layout::Triangle;
use crate::raster::runs;
use crate::raster::setup::{Chunk, SetupInput};
use crate::raster::simd::Level;
use crate::raster::vertex::{self, ScreenVertex, VertexWorker};

/// Primitives in a run.
const RUN: u32 = 2048;

/// Memory that is kept from batch to batch, and the result of the last one.
#[derive(Default)]
pub struct HostFront {
    shaded: Vec<[f32; 4]>,
    screen: Vec<ScreenVertex>,
    chunks: Vec<Chunk>,
    /// The line stipple counter, and what it was before the last batch, whose first primitive was `first`.
    stipple_counter: u32,
    counter_before: u32,
    first: u32,
    /// Triangles of all steps, in order.
    pub triangles: Vec<Triangle>,
    /// Chunks of the last batch.
    used: usize,
    /// vec4 of their planes.
    plane_vec4: usize,
    /// For each step of the batch, one past its last triangle.
    pub step_ends: Vec<usize>,
}

impl HostFront {
    /// Sets up a batch.
    pub fn run(&mut self, batch: &Batch, top_first: bool) {
        let screen_base = self.shade(batch);
        let runs = runs::cut(batch, RUN);
        (self.first, self.counter_before) = (runs.first().map_or(0, |run| run.first), self.stipple_counter);
        let HostFront { shaded, screen, chunks, stipple_counter, .. } = self;
        let input = SetupInput { batch, shaded, screen, screen_base: &screen_base, top_first, level: Level::from_environment() };
        runs::each(&runs, chunks, batch, stipple_counter, true, |run, chunk, counter| runs::set_up(run, chunk, &input, counter));
        self.step_ends.clear();
        (self.used, self.plane_vec4) = (runs.len(), 0);
        let chunks = &self.chunks[..runs.len()];
        let count = chunks.iter().map(|chunk| chunk.triangles.len()).sum();
        self.triangles.resize(count, Triangle::default());
        let mut rest = &mut self.triangles[..];
        let mut copies = Vec::with_capacity(chunks.len());
        let (mut next, mut end) = (0, 0);
        for k in 0..batch.steps.len() {
            while next < runs.len() && runs[next].step == k {
                let chunk = &chunks[next];
                let (to, behind) = rest.split_at_mut(chunk.triangles.len());
                copies.push((to, chunk, self.plane_vec4 as u32));
                rest = behind;
                end += chunk.triangles.len();
                self.plane_vec4 += chunk.planes.len();
                next += 1;
            }
            self.step_ends.push(end);
        }
        copies.into_par_iter().for_each(|(to, chunk, base)| {
            to.iter_mut().zip(&chunk.triangles).for_each(|(to, t)| *to = Triangle { planes: t.planes + base, ..*t });
        });
    }

    /// Bytes of the triangles' planes.
    pub fn plane_bytes(&self) -> usize {
        self.plane_vec4 * 16
    }

    /// Writes them, from where the chunks left them: there are too many to be copied twice.
    pub fn write_planes(&self, mut to: wgpu::WriteOnly<[u8]>) {
        let mut at = 0;
        for chunk in &self.chunks[..self.used] {
            let bytes: &[u8] = bytemuck::cast_slice(&chunk.planes);
            to.slice(at..at + bytes.len()).copy_from_slice(bytes);
            at += bytes.len();
        }
    }

    /// Gets ready to set up the last batch again from a primitive on: the stipple counter goes back to where it was there.
    pub fn resume(&mut self, batch: &Batch, top_first: bool, from: u32) {
        if !runs::stippled(batch) || from < self.first {
            return;
        }
        let (screen_base, _) = vertex::bases(batch);
        let HostFront { shaded, screen, .. } = self;
        let input = SetupInput { batch, shaded, screen, screen_base: &screen_base, top_first, level: Level::from_environment() };
        let mut chunk = Chunk::default();
        chunk.stipple_counter = self.counter_before;
        chunk.run(&input, self.first, from);
        self.stipple_counter = chunk.stipple_counter;
    }

    /// Shades all vertices. Returns the first [`ScreenVertex`] of each draw.
    fn shade(&mut self, batch: &Batch) -> Vec<u32> {
        let level = Level::from_environment();
        let (bases, blocks) = vertex::blocks(batch, &mut self.shaded, &mut self.screen);
        blocks.into_par_iter().with_min_len(8).for_each_init(VertexWorker::default, |w, block| w.block(batch, block, level));
        bases
    }
}
