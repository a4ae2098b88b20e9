//! Other ways to rasterize on the CPU, for the harness to measure: what the paper "comparative study of rasterization on the CPU"
//! (`cpu-rasterization`) compares. Not part of the library's default build (feature `study`).
//!
//! What varies is how samples are found ([`Method`]), how pixels lie in memory ([`Layout`]) and where threads part ([`Sort`]). The vertex
//! and set-up stages are the shipped ones, and so are the planes and the arithmetic of depth and colour: every way gives the shipped
//! executor's bits. Only opaque triangles whose colour is an interpolated varying are drawn, with depth LESS or without.

mod image;
mod methods;
mod shade;
#[cfg(test)]
mod tests;

use rayon::prelude::*;

use super::layout::{BIN_SIZE, compare, fragment_flags};
use super::setup::{Chunk, SetupInput};
use super::simd::Level;
use super::vertex::{ScreenVertex, VertexWorker, blocks};
use crate::draw::Batch;
use image::Image;
use methods::Job;

/// How the samples of a triangle are found.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Method {
    /// Every pixel of the bounding rectangle is tested, and shaded on its own.
    HalfSpace,
    /// Blocks of so many pixels a side (4, 8, 16 or 32) are tested first; rows of eight pixels are tested and shaded at once.
    Blocked(u32),
    /// Like blocks of 8, but the pixels of partly covered blocks are shaded one by one.
    Combined,
    /// Bounding rectangles of up to 16 pixels by [`Method::HalfSpace`], others by blocks of 8.
    BySize,
    /// The ends of every row are found, exactly, by stepping along the edges.
    Scanline,
}

/// How pixels lie in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Layout {
    /// Row after row.
    Linear,
    /// Bins of 64 x 64, in them tiles of 8 x 8.
    Tiled,
}

/// Where the work is parted between threads.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Sort {
    /// Not at all: one thread, triangle after triangle.
    None,
    /// By bins of 64 x 64 pixels, each with a list of its triangles.
    Middle,
    /// By triangles; eight neighbouring pixels have a lock.
    Last,
}

/// A way to rasterize.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Way {
    /// See [`Method`].
    pub method: Method,
    /// See [`Layout`].
    pub layout: Layout,
    /// See [`Sort`].
    pub sort: Sort,
}

/// Triangles that a thread takes at once.
const RUN: usize = 256;

/// Threads and memory, kept from frame to frame.
pub struct Study {
    pool: rayon::ThreadPool,
    level: Level,
    shaded: Vec<[f32; 4]>,
    screen: Vec<ScreenVertex>,
    chunks: Vec<Chunk>,
    image: Image,
}

impl Study {
    /// For frames of a size, on so many threads.
    pub fn new(threads: usize, level: Level, size: [u32; 2], way: Way) -> Result<Study, String> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads.max(1)).build().map_err(|e| e.to_string())?;
        let image = Image::new(size, way.layout, way.sort == Sort::Last);
        Ok(Study { pool, level, shaded: Vec::new(), screen: Vec::new(), chunks: Vec::new(), image })
    }

    /// Draws a batch of one state on a cleared image, from the vertices to the last pixel.
    pub fn frame(&mut self, batch: &Batch, way: Way) -> Result<(), String> {
        let depth = depth_tested(batch)?;
        let Study { pool, level, shaded, screen, chunks, image } = self;
        pool.install(|| {
            front(batch, shaded, screen, chunks, image.bins, way.sort == Sort::Middle, *level);
            image.clear();
            let job =
                Job { method: way.method, chunks, bin: None, depth, region: [0, 0, image.size[0] as i32 - 1, image.size[1] as i32 - 1] };
            match way.sort {
                Sort::None => image.whole(|mut dest| methods::draw_flat(*level, &job, &mut dest)),
                Sort::Middle => image.by_bins(|k, dest| {
                    let [x, y] = [k as u32 % image::columns(&job), k as u32 / image::columns(&job)].map(|v| (v * BIN_SIZE) as i32);
                    let last = BIN_SIZE as i32 - 1;
                    let region = [x, y, (x + last).min(job.region[2]), (y + last).min(job.region[3])];
                    let job = Job { bin: Some(k), region, ..job };
                    match dest {
                        image::Bin::Tiled(mut flat) => methods::draw_flat(*level, &job, &mut flat),
                        image::Bin::Linear(mut rows) => methods::draw_rows(*level, &job, &mut rows),
                    }
                }),
                Sort::Last => {
                    let shared = image.shared();
                    chunks.par_iter().with_max_len(1).for_each(|chunk| {
                        let job = Job { chunks: std::slice::from_ref(chunk), ..job };
                        methods::draw_shared(*level, &job, &mut shared.clone());
                    });
                }
            }
        });
        Ok(())
    }

    /// Colour and depth, row by row.
    pub fn pixels(&self) -> [Vec<u32>; 2] {
        self.image.pixels()
    }
}

/// Whether there is a depth test; an error for what the study does not draw.
fn depth_tested(batch: &Batch) -> Result<bool, String> {
    let Some(state) = batch.fragment_states.first().map(|s| s.flags) else { return Err("nothing to draw".into()) };
    let depth = fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE;
    let one_state = batch.draws.iter().all(|d| d.record.fragment_state == 0 && d.record.varying_count == 1);
    let function = batch.fragment_states[0].depth_func;
    match state {
        _ if !one_state => Err("more than one state".into()),
        0 => Ok(false),
        s if s == depth && function == compare::LESS => Ok(true),
        _ => Err("neither depth LESS nor nothing".into()),
    }
}

/// The shipped stages up to set-up, and bin lists where they are wanted.
fn front(
    batch: &Batch,
    shaded: &mut Vec<[f32; 4]>,
    screen: &mut Vec<ScreenVertex>,
    chunks: &mut Vec<Chunk>,
    bins: [u32; 2],
    with_bins: bool,
    level: Level,
) {
    let (screen_base, blocks) = blocks(batch, shaded, screen);
    blocks.into_par_iter().with_min_len(4).for_each_init(VertexWorker::default, |worker, block| worker.block(batch, block, level));
    let input = SetupInput { batch, shaded, screen, screen_base: &screen_base, top_first: true, level };
    let count = batch.primitives.len();
    chunks.resize_with(count.div_ceil(RUN), Chunk::default);
    chunks.par_iter_mut().enumerate().for_each(|(k, chunk)| {
        chunk.clear();
        chunk.run(&input, (k * RUN) as u32, ((k + 1) * RUN).min(count) as u32);
        if with_bins {
            chunk.bins.run(&chunk.triangles, bins[0], bins[1]);
        }
    });
}
