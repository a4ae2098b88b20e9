//! Runs of primitives, set up side by side. The line stipple counter runs on from line to line, so where any line is stippled the
//! runs follow each other.

use rayon::prelude::*;

use super::layout::raster_flags;
use super::setup::{Chunk, SetupInput};
use crate::draw::{Batch, Step};

/// Primitives of one step that are set up by one worker.
#[derive(Clone, Copy, Debug)]
pub struct Run {
    /// Index of the step.
    pub step: usize,
    /// First primitive.
    pub first: u32,
    /// One past the last.
    pub end: u32,
}

/// Cuts the primitives of a batch into runs of at most `length`.
pub fn cut(batch: &Batch, length: u32) -> Vec<Run> {
    let mut runs = Vec::new();
    for (step, what) in batch.steps.iter().enumerate() {
        if let Step::Primitives { first, end } = *what {
            runs.extend((first..end).step_by(length as usize).map(|first| Run { step, first, end: (first + length).min(end) }));
        }
    }
    runs
}

/// Whether any line of a batch may be stippled.
pub fn stippled(batch: &Batch) -> bool {
    batch.raster_states.iter().any(|s| s.flags & raster_flags::LINE_STIPPLE != 0)
}

/// Sets up every run in a chunk of its own, and calls `then` with it: in parallel on the current thread pool where that is asked
/// for and possible. `counter` is the line stipple counter.
pub fn set_up(
    runs: &[Run],
    chunks: &mut Vec<Chunk>,
    input: &SetupInput,
    counter: &mut u32,
    parallel: bool,
    then: impl Fn(&mut Chunk) + Sync,
) {
    if chunks.len() < runs.len() {
        chunks.resize_with(runs.len(), Chunk::default);
    }
    let one = |(chunk, run): (&mut Chunk, &Run)| {
        chunk.clear();
        chunk.run(input, run.first, run.end);
        then(chunk);
    };
    let pairs = chunks.iter_mut().zip(runs);
    if stippled(input.batch) {
        for (chunk, run) in pairs {
            chunk.stipple_counter = *counter;
            one((&mut *chunk, run));
            *counter = chunk.stipple_counter;
        }
    } else if parallel && runs.len() > 1 {
        chunks[..runs.len()].par_iter_mut().zip(runs).with_max_len(1).for_each(one);
    } else {
        pairs.for_each(one);
    }
}
