//! The executors in this process, measured on batches: the kernels by time stamps on the device, the CPU executor by the clock.

use std::time::Instant;

use tepui::device::cpu::CpuDevice;
use tepui::device::gpu::{GpuDevice, StageTime, real_gpu_present};
use tepui::device::{ColorFormat, DepthFormat, Device, Surface, SurfaceFormat, samples};
use tepui::draw::Batch;
use tepui::raster::layout::raster_flags;

/// Buffers of the device that hold what came in; all others are intermediate.
const INPUT: [&str; 3] = ["uniforms", "vertices", "primitives"];

/// An executor.
pub enum Bench {
    /// The kernels; whether on hardware.
    Gpu(GpuDevice, bool),
    /// The CPU executor.
    Cpu(CpuDevice),
}

/// What was measured of a batch.
pub struct Measure {
    /// Milliseconds: least, median, greatest.
    pub ms: [f64; 3],
    /// Median milliseconds by stage, in frames of their own; empty on the CPU.
    pub stages: Vec<(&'static str, f64)>,
    /// Bytes of buffers by name; empty on the CPU.
    pub memory: Vec<(&'static str, u64)>,
    /// What the last frame that was measured has drawn.
    pub pixels: Option<Picture>,
}

impl Measure {
    /// Bytes of the buffers between the input and the pixels.
    pub fn intermediate(&self) -> u64 {
        self.memory.iter().filter(|m| !INPUT.contains(&m.0)).map(|m| m.1).sum()
    }

    /// Bytes of all buffers.
    pub fn total(&self) -> u64 {
        self.memory.iter().map(|m| m.1).sum()
    }
}

/// The format of a surface with so many samples a pixel; an error where there is none.
pub fn format(samples: u32) -> Result<SurfaceFormat, String> {
    match samples::supported(samples) {
        Some(n) if n == samples => {
            Ok(SurfaceFormat { color: ColorFormat::Rgba8, depth: DepthFormat::D24, stencil: true, top_first: true, samples })
        }
        _ => Err(format!("surfaces have no {samples} samples a pixel")),
    }
}

/// A batch for a surface with so many samples.
fn with_samples(batch: &Batch, samples: u32) -> Batch {
    let mut batch = batch.clone();
    if samples > 1 {
        batch.raster_states.iter_mut().for_each(|state| state.flags |= raster_flags::MULTISAMPLE);
    }
    batch
}

/// What a surface of one sample a pixel holds.
pub struct Picture {
    color: Vec<u32>,
    depth_stencil: Vec<u32>,
}

impl Picture {
    /// A copy.
    pub fn of(surface: &mut dyn Surface) -> Picture {
        let pixels = surface.pixels();
        Picture { color: pixels.color.to_vec(), depth_stencil: pixels.depth_stencil.to_vec() }
    }
}

/// Least, median and greatest.
pub fn least_median_greatest(mut times: Vec<f64>) -> [f64; 3] {
    times.sort_by(f64::total_cmp);
    match times.len() {
        0 => [f64::NAN; 3],
        n => [times[0], times[n / 2], times[n - 1]],
    }
}

/// Milliseconds of frames. A batch that the device cannot hold in one piece takes no time at all when it is timed as one: that is no
/// measurement.
fn frame_times(frames: &[Vec<StageTime>]) -> Result<[f64; 3], String> {
    if frames.is_empty() {
        return Err("the device has no time stamps".into());
    }
    let ms = least_median_greatest(frames.iter().map(|f| f.iter().map(|t| t.ms).sum()).collect());
    if ms[0] > 0.0 {
        Ok(ms)
    } else {
        Err("the time stamps say that nothing was drawn: the batch does not fit this device in one piece".into())
    }
}

fn medians(frames: &[Vec<StageTime>]) -> Vec<(&'static str, f64)> {
    let Some(first) = frames.first() else { return Vec::new() };
    let of = |name: &str| frames.iter().filter_map(|f| f.iter().find(|t| t.name == name).map(|t| t.ms)).collect();
    first.iter().map(|t| (t.name, least_median_greatest(of(t.name))[1])).collect()
}

impl Bench {
    /// Those to measure: the kernels on hardware alone, or the CPU executor beside the kernels on whatever Vulkan there is.
    pub fn all(with_cpu: bool) -> Vec<Bench> {
        let real = real_gpu_present();
        let mut benches = Vec::new();
        if with_cpu || !real {
            benches.push(Bench::Cpu(CpuDevice::new()));
        }
        match GpuDevice::new() {
            Ok(gpu) => benches.push(Bench::Gpu(gpu, real)),
            Err(why) => println!("LEFT OUT: the kernels: {why}"),
        }
        benches
    }

    /// The device, as it calls itself.
    pub fn name(&self) -> String {
        match self {
            Bench::Gpu(gpu, _) => gpu.name(),
            Bench::Cpu(cpu) => cpu.name(),
        }
    }

    /// In tables and plots.
    pub fn short(&self) -> &'static str {
        match self {
            Bench::Gpu(_, true) => "GPU",
            Bench::Gpu(..) => "kernels",
            Bench::Cpu(_) => "CPU",
        }
    }

    /// On a GPU that is one.
    pub fn is_hardware(&self) -> bool {
        matches!(self, Bench::Gpu(_, true))
    }

    /// Draws a batch again and again. Vertices are where the device wants them before the time starts. `budget`: bytes on the device between
    /// the input and the pixels, if not as always.
    pub fn measure(&self, batch: &Batch, size: [u32; 2], samples: u32, frames: usize, budget: Option<u64>) -> Result<Measure, String> {
        let format = format(samples)?;
        let batch = &with_samples(batch, samples);
        match self {
            Bench::Gpu(gpu, _) => {
                let mut surface = gpu.gpu_surface(size[0], size[1], format)?;
                budget.into_iter().for_each(|bytes| surface.set_budget(bytes));
                let whole = surface.timed(batch, frames, false);
                let ms = frame_times(&whole)?;
                let stages = medians(&surface.timed(batch, frames.clamp(1, 5), true));
                let (memory, pixels) = (surface.memory(), Some(Picture::of(&mut surface)));
                Ok(Measure { ms, stages, memory, pixels })
            }
            Bench::Cpu(cpu) => {
                let mut surface = cpu.surface(size[0], size[1], format);
                surface.execute(batch.clone());
                let times = (0..frames).map(|_| {
                    let batch = batch.clone();
                    let start = Instant::now();
                    surface.execute(batch);
                    start.elapsed().as_secs_f64() * 1e3
                });
                let ms = least_median_greatest(times.collect());
                Ok(Measure { ms, stages: Vec::new(), memory: Vec::new(), pixels: None })
            }
        }
    }

    /// Draws a frame that is cut into batches, round after round; the milliseconds of a frame. Time on the device, or by the clock.
    pub fn frames_of(&self, batches: &[Batch], size: [u32; 2], frames: usize) -> Result<[f64; 3], String> {
        let format = format(1)?;
        match self {
            Bench::Gpu(gpu, _) => {
                // Each batch is measured on its own: between two batches of a frame the device does nothing that a time stamp sees.
                let mut sum = [0.0; 3];
                let mut surface = gpu.gpu_surface(size[0], size[1], format)?;
                for batch in batches {
                    let ms = frame_times(&surface.timed(batch, frames, false))?;
                    (0..3).for_each(|k| sum[k] += ms[k]);
                }
                Ok(sum)
            }
            Bench::Cpu(cpu) => {
                let mut surface = cpu.surface(size[0], size[1], format);
                let times = (0..=frames).map(|_| {
                    let batches = batches.to_vec();
                    let start = Instant::now();
                    batches.into_iter().for_each(|b| surface.execute(b));
                    start.elapsed().as_secs_f64() * 1e3
                });
                Ok(least_median_greatest(times.skip(1).collect()))
            }
        }
    }
}

/// The CPU executor's picture, to compare with.
pub fn reference(batch: &Batch, size: [u32; 2]) -> Result<Picture, String> {
    let mut surface = CpuDevice::new().surface(size[0], size[1], format(1)?);
    surface.execute(batch.clone());
    Ok(Picture::of(&mut *surface))
}

/// Pixels covered by one alone, pixels of another colour, greatest difference of a component, of depth.
pub fn difference(a: &Picture, b: &Picture) -> [u32; 4] {
    let mut d = [0; 4];
    for (a, b) in a.color.iter().zip(&b.color) {
        d[0] += ((*a == 0) != (*b == 0)) as u32;
        d[1] += (a != b) as u32;
        for (x, y) in a.to_le_bytes().into_iter().zip(b.to_le_bytes()) {
            d[2] = d[2].max(x.abs_diff(y) as u32);
        }
    }
    for (a, b) in a.depth_stencil.iter().zip(&b.depth_stencil) {
        d[3] = d[3].max(a.abs_diff(*b));
    }
    d
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn frames_that_take_no_time_are_no_measurement() {
        let frame = |ms| vec![StageTime { name: "end", ms }];
        assert!(frame_times(&[]).is_err());
        assert!(frame_times(&[frame(0.0), frame(1.0)]).is_err());
        assert_eq!(frame_times(&[frame(3.0), frame(1.0), frame(2.0)]), Ok([1.0, 2.0, 3.0]));
    }
}
