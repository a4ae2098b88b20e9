//! `raster`: the rasterizer alone on scenes S1 to S6: time on the GPU from vertices in a buffer to the last pixel, by stage, memory, and
//! the picture against the CPU executor's.

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use serde::Serialize;
use tepui::device::cpu::CpuDevice;
use tepui::device::gpu::{GpuDevice, StageTime};
use tepui::device::{ColorFormat, DepthFormat, Device, Pixels, Surface, SurfaceFormat};

use crate::Error;

mod batch;
mod scenes;

use scenes::{SIZES, Scene};

/// Options of `raster`.
#[derive(Args)]
pub struct Options {
    /// Which scenes.
    #[arg(long, value_delimiter = ',', default_value = "1,2,3,4,5,6")]
    scenes: Vec<u32>,
    /// Which heights: 768, 1080, 2160.
    #[arg(long, value_delimiter = ',', default_value = "1080")]
    heights: Vec<u32>,
    /// Frames of each; the median is shown.
    #[arg(long, default_value_t = 31)]
    frames: usize,
    /// Compares the picture with the CPU executor's too.
    #[arg(long)]
    check: bool,
    /// Writes all figures to this file (JSON).
    #[arg(long)]
    json: Option<PathBuf>,
}

const FORMAT: SurfaceFormat =
    SurfaceFormat { color: ColorFormat::Rgba8, depth: DepthFormat::D24, stencil: true, top_first: true, samples: 1 };

/// Everything measured of a scene at a size.
#[derive(Debug, Serialize)]
struct Row {
    scene: u32,
    size: [u32; 2],
    triangles: u32,
    /// Milliseconds on the GPU: least, median, greatest.
    ms: [f64; 3],
    /// Median milliseconds by stage, measured in frames of their own.
    stages: Vec<(&'static str, f64)>,
    /// MiB of buffers by name.
    memory: Vec<(&'static str, f64)>,
    /// Against the CPU executor: pixels covered by one alone, pixels of another colour, greatest difference of a component, of depth.
    against_cpu: Option<[u32; 4]>,
}

fn least_median_greatest(mut times: Vec<f64>) -> [f64; 3] {
    times.sort_by(f64::total_cmp);
    match times.len() {
        0 => [f64::NAN; 3],
        n => [times[0], times[n / 2], times[n - 1]],
    }
}

fn medians(frames: &[Vec<StageTime>]) -> Vec<(&'static str, f64)> {
    let Some(first) = frames.first() else { return Vec::new() };
    let of = |name: &str| frames.iter().filter_map(|f| f.iter().find(|t| t.name == name).map(|t| t.ms)).collect();
    first.iter().map(|t| (t.name, least_median_greatest(of(t.name))[1])).collect()
}

fn difference(cpu: &Pixels, gpu: &Pixels) -> [u32; 4] {
    let mut d = [0; 4];
    for (a, b) in cpu.color.iter().zip(gpu.color.iter()) {
        d[0] += ((*a == 0) != (*b == 0)) as u32;
        d[1] += (a != b) as u32;
        for (x, y) in a.to_le_bytes().into_iter().zip(b.to_le_bytes()) {
            d[2] = d[2].max(x.abs_diff(y) as u32);
        }
    }
    for (a, b) in cpu.depth_stencil.iter().zip(gpu.depth_stencil.iter()) {
        d[3] = d[3].max(a.abs_diff(*b));
    }
    d
}

/// Measures; false where a picture is not the CPU executor's.
pub fn main(options: &Options) -> Result<bool, Error> {
    let gpu = GpuDevice::new()?;
    println!("{}", gpu.name());
    println!("ms on the GPU: least, median, greatest of {} frames; vertices resident, clear to last pixel", options.frames);
    let mut rows = Vec::new();
    let mut good = true;
    for size in SIZES.into_iter().filter(|s| options.heights.contains(&s[1])) {
        for &id in &options.scenes {
            let scene = Scene::new(id, size)?;
            let batch = batch::batch(&scene)?;
            let mut surface = gpu.gpu_surface(size[0], size[1], FORMAT);
            let whole = surface.timed(&batch, options.frames, false);
            let ms = least_median_greatest(whole.iter().flatten().map(|t| t.ms).collect());
            let stages = medians(&surface.timed(&batch, 5, true));
            let memory: Vec<_> = surface.memory().into_iter().map(|(name, bytes)| (name, bytes as f64 / (1 << 20) as f64)).collect();
            let against_cpu = options.check.then(|| {
                let mut cpu = CpuDevice::new().surface(size[0], size[1], FORMAT);
                cpu.execute(batch.clone());
                difference(&cpu.pixels(), &surface.pixels())
            });
            println!(
                "S{id} {:>4}x{:<4} {:8.3} {:8.3} {:8.3}  {:7.0} Mtri/s",
                size[0],
                size[1],
                ms[0],
                ms[1],
                ms[2],
                scene.triangles() as f64 / ms[1] / 1e3
            );
            let text: Vec<String> = stages.iter().map(|(name, ms)| format!("{name} {ms:.3}")).collect();
            println!("   {}", text.join(", "));
            let total: f64 = memory.iter().map(|m| m.1).sum();
            let text: Vec<String> = memory.iter().filter(|m| m.1 >= 1.0).map(|(name, mib)| format!("{name} {mib:.0}")).collect();
            println!("   MiB {total:.0}: {}", text.join(", "));
            if let Some([coverage, pixels, most, depth]) = against_cpu {
                println!(
                    "   against the CPU executor: {coverage} pixels of coverage, {pixels} of colour by up to {most}, depth by up to {depth}"
                );
                good &= coverage == 0 && most <= 1 && depth <= 1;
            }
            std::io::stdout().flush()?;
            rows.push(Row { scene: id, size, triangles: scene.triangles(), ms, stages, memory, against_cpu });
        }
    }
    if let Some(path) = &options.json {
        std::fs::write(path, serde_json::to_string_pretty(&rows)?)?;
    }
    Ok(good)
}
