//! The recorder: owns the batch under construction.

use super::Batch;

/// Turns draws into a batch.
#[derive(Default)]
pub struct Recorder {
    batch: Batch,
}

impl Recorder {
    /// An empty recorder.
    pub fn new() -> Recorder {
        Recorder::default()
    }
    /// The batch so far, if there is anything in it.
    pub fn take(&mut self) -> Option<Batch> {
        (!self.batch.steps.is_empty()).then(|| std::mem::take(&mut self.batch))
    }
}
