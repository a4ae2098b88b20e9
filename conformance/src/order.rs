//! `order`: the same deep stack of blended triangles gives the same bits on every run, with any number of threads and any SIMD level.

use clap::Args;

use crate::Error;
use crate::build::{build_library, work_dir};
use crate::compare::{reference_runner, tepui_runner};
use crate::runner::Runner;

/// Options of `order`.
#[derive(Args)]
pub struct Options {
    /// Runs in all, spread over the settings.
    #[arg(long, default_value_t = 100)]
    runs: usize,
    /// The scene.
    #[arg(long, default_value = "blend_10000_triangles")]
    scene: String,
}

fn pixels(runner: &mut Runner, scene: &str) -> Result<Vec<u8>, Error> {
    let prefix = work_dir().join("frames").join(format!("order-{}", runner.label));
    runner.request(&format!("run {scene} {}", prefix.display()))?;
    let mut bits = std::fs::read(prefix.with_extension("color"))?;
    bits.extend(std::fs::read(prefix.with_extension("depth"))?);
    Ok(bits)
}

/// Runs it; true when all bits are equal, OSMesa's among them.
pub fn main(options: &Options) -> Result<bool, Error> {
    build_library()?;
    std::fs::create_dir_all(work_dir().join("frames"))?;
    let expected = pixels(&mut reference_runner()?, &options.scene)?;
    let settings: Vec<(&str, &str)> = ["1", "2", "7"].iter().flat_map(|t| ["scalar", "avx2"].map(|s| (*t, s))).collect();
    let mut different = 0;
    for (i, (threads, simd)) in settings.iter().enumerate() {
        let runs = options.runs / settings.len() + usize::from(i < options.runs % settings.len());
        let mut runner = tepui_runner("cpu", &[("TEPUI_THREADS", threads), ("TEPUI_SIMD", simd)])?;
        let mut bad = 0;
        for _ in 0..runs {
            bad += usize::from(pixels(&mut runner, &options.scene)? != expected);
        }
        println!("{threads} threads, {simd:<6}: {runs} runs, {bad} differ from OSMesa");
        different += bad;
    }
    println!("order: {} runs, {different} differ", options.runs);
    Ok(different == 0)
}
