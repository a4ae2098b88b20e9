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

/// Calls `one` with every run, its result's place and the line stipple counter before it: in parallel on the current thread pool where
/// that is asked for and possible. `one` returns the counter after the run.
pub fn each<T: Default + Send>(
    runs: &[Run],
    results: &mut Vec<T>,
    batch: &Batch,
    counter: &mut u32,
    parallel: bool,
    one: impl Fn(&Run, &mut T, u32) -> u32 + Sync,
) {
    if results.len() < runs.len() {
        results.resize_with(runs.len(), T::default);
    }
    let pairs = results.iter_mut().zip(runs);
    let before = *counter;
    if stippled(batch) {
        pairs.for_each(|(result, run)| *counter = one(run, result, *counter));
    } else if parallel && runs.len() > 1 {
        results[..runs.len()].par_iter_mut().zip(runs).with_max_len(1).for_each(|(result, run)| _ = one(run, result, before));
    } else {
        pairs.for_each(|(result, run)| _ = one(run, result, before));
    }
}

/// Sets up a run. Returns the line stipple counter after it.
pub fn set_up(run: &Run, chunk: &mut Chunk, input: &SetupInput, counter: u32) -> u32 {
    chunk.clear();
    chunk.stipple_counter = counter;
    chunk.run(input, run.first, run.end);
    chunk.stipple_counter
}
