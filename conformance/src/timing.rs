//! Times of one scene on several implementations, interleaved frame by frame so that a drift of the machine hits all.

use serde::Serialize;

use crate::runner::Runner;

/// Times of one implementation.
#[derive(Clone, Debug, Serialize)]
pub struct Times {
    /// Median milliseconds a frame.
    pub median: f64,
    /// Quartiles.
    pub quartiles: [f64; 2],
    /// Median of this frame's time by the reference's frame beside it, when this is not the reference.
    pub ratio: Option<f64>,
}

/// The value below which a share `q` of the values lies.
pub fn quantile(values: &mut [f64], q: f64) -> f64 {
    values.sort_by(f64::total_cmp);
    values[((values.len() - 1) as f64 * q).round() as usize]
}

/// Times `frames` frames after `warmup`; the first runner is the reference. Each runner's outcome on its own.
pub fn interleave(scene: &str, runners: &mut [&mut Runner], warmup: usize, frames: usize) -> Vec<Result<Times, String>> {
    let mut samples: Vec<Result<Vec<f64>, String>> =
        runners.iter_mut().map(|r| r.request(&format!("open {scene}")).map(|_| Vec::new())).collect();
    for round in 0..warmup + frames {
        for (runner, sample) in runners.iter_mut().zip(&mut samples) {
            let Ok(times) = sample else { continue };
            match runner.frame() {
                Ok(ms) if round >= warmup => times.push(ms),
                Ok(_) => {}
                Err(why) => *sample = Err(why),
            }
        }
    }
    for (runner, sample) in runners.iter_mut().zip(&samples) {
        if sample.is_ok() {
            let _ = runner.request("close");
        }
    }
    let reference = samples.first().and_then(|s| s.as_ref().ok()).cloned();
    samples
        .into_iter()
        .enumerate()
        .map(|(i, sample)| {
            let mut times = sample?;
            if times.is_empty() {
                return Err("no frames".into());
            }
            let mut ratios: Vec<f64> = reference.iter().flatten().zip(&times).map(|(r, t)| t / r).collect();
            let ratio = (i > 0 && !ratios.is_empty()).then(|| quantile(&mut ratios, 0.5));
            let quartiles = [quantile(&mut times, 0.25), quantile(&mut times, 0.75)];
            Ok(Times { median: quantile(&mut times, 0.5), quartiles, ratio })
        })
        .collect()
}
