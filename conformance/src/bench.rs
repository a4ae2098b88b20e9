//! `bench`: the timing scenes, interleaved, as ratios to OSMesa.

use clap::Args;

use crate::build::build_library;
use crate::compare::{reference_runner, tepui_runner};
use crate::runner::TIMED;
use crate::timing::{Times, interleave};
use crate::{Devices, Error};

/// Options of `bench`.
#[derive(Args)]
pub struct Options {
    /// Which executors.
    #[arg(long, value_enum, default_value = "both")]
    device: Devices,
    /// Only scenes whose name contains this.
    #[arg(long, default_value = "")]
    filter: String,
    /// Timed frames a scene.
    #[arg(long, default_value_t = 31)]
    frames: usize,
    /// Fail unless the CPU executor's ratio is at most this on every scene.
    #[arg(long)]
    cpu_at_most: Option<f64>,
    /// Fail unless the kernels' ratio is at most this on every scene.
    #[arg(long)]
    gpu_at_most: Option<f64>,
}

fn cell(times: &Result<Times, String>) -> String {
    match times {
        Err(why) => format!("{why:>34}"),
        Ok(t) => {
            let ratio = t.ratio.map_or(String::new(), |r| format!("x{r:.2}"));
            format!("{:>9.2} [{:>7.2}, {:>7.2}] {ratio:>6}", t.median, t.quartiles[0], t.quartiles[1])
        }
    }
}

/// Runs the timing scenes; true when the limits that were given hold.
pub fn main(options: &Options) -> Result<bool, Error> {
    build_library()?;
    let mut reference = reference_runner()?;
    let mut tepui = Vec::new();
    if options.device.cpu() {
        tepui.push((tepui_runner("cpu", &[])?, options.cpu_at_most));
    }
    if options.device.gpu() {
        tepui.push((tepui_runner("gpu", &[])?, options.gpu_at_most));
    }
    println!("milliseconds a frame: median [quartiles], and the median ratio to OSMesa's neighbouring frame; {} frames", options.frames);
    let titles: String = tepui.iter().map(|(r, _)| format!(" | {:<35}", format!("Tepui {}", r.label))).collect();
    println!("{:<24} {:<34}{titles}", "scene", "OSMesa");
    let mut good = true;
    for scene in reference.scenes()?.iter().filter(|s| s.flags & TIMED != 0 && s.name.contains(&options.filter)) {
        let mut runners = vec![&mut reference];
        runners.extend(tepui.iter_mut().map(|(r, _)| r));
        let times = interleave(&scene.name, &mut runners, 3, options.frames);
        println!("{:<24} {}", scene.name, times.iter().map(cell).collect::<Vec<_>>().join(" | "));
        for (time, (_, limit)) in times.iter().skip(1).zip(&tepui) {
            let ratio = time.as_ref().ok().and_then(|t| t.ratio).unwrap_or(f64::INFINITY);
            good &= limit.is_none_or(|l| ratio <= l);
        }
    }
    Ok(good)
}
