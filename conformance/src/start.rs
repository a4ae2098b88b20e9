//! `start`: from process start to the first frame, interleaved with OSMesa.

use std::process::Stdio;
use std::time::Instant;

use clap::Args;

use crate::Error;
use crate::build::build_library;
use crate::compare::{reference_runner, tepui_runner};
use crate::runner::Runner;

/// Options of `start`.
#[derive(Args)]
pub struct Options {
    /// Process starts of each.
    #[arg(long, default_value_t = 21)]
    runs: usize,
}

fn once(runner: &Runner) -> Result<f64, Error> {
    let start = Instant::now();
    let status = runner.command().arg("--first-frame").stderr(Stdio::null()).status()?;
    let elapsed = start.elapsed().as_secs_f64() * 1e3;
    if status.success() { Ok(elapsed) } else { Err(format!("{}: the first frame was not drawn ({status})", runner.label).into()) }
}

/// Times it; true when the CPU executor is no later than OSMesa.
pub fn main(options: &Options) -> Result<bool, Error> {
    build_library()?;
    let runners = [reference_runner()?, tepui_runner("cpu", &[])?, tepui_runner("auto", &[])?];
    let mut times: Vec<Vec<f64>> = vec![Vec::new(); runners.len()];
    for _ in 0..options.runs + 1 {
        for (runner, times) in runners.iter().zip(&mut times) {
            times.push(once(runner)?);
        }
    }
    let mut medians = Vec::new();
    for (runner, mut times) in runners.iter().zip(times) {
        times.remove(0);
        times.sort_by(f64::total_cmp);
        let median = times[times.len() / 2];
        println!(
            "{:<8} {median:>8.1} ms [{:.1}, {:.1}], {} process starts",
            runner.label,
            times[times.len() / 4],
            times[times.len() * 3 / 4],
            times.len()
        );
        medians.push(median);
    }
    println!("ratio to OSMesa: cpu {:.2}, auto {:.2}", medians[1] / medians[0], medians[2] / medians[0]);
    Ok(medians[1] <= medians[0])
}
