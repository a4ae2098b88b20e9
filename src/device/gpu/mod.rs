//! Batches through wgpu compute: the kernels in `shaders/`, the twins of [`crate::raster`]'s stages, on the same records.

mod adapter;
mod budget;
mod buffers;
mod clears;
mod encode;
mod execute;
mod fill;
mod fine;
mod front;
mod glue;
mod host_front;
mod kernels;
mod params;
mod profile;
mod records;
mod room;
mod segment;
mod slices;
mod source;
mod stage;
mod stats;
mod surface;
#[cfg(test)]
mod tests;
mod texture;
mod visible;

use std::sync::{Arc, Once, OnceLock};

use super::cpu::CpuDevice;
use super::{Device, PlaneFormat, SharedPlane, Surface, SurfaceFormat, Target};
pub use adapter::{Config, Shape};
use kernels::Kernels;
pub use profile::StageTime;
pub use surface::{GpuPlane, GpuSurface};

/// Bytes of a pixel of the widest format; the keys of the visible path take half of them.
const WIDEST_PIXEL: u64 = 16;

/// A Vulkan device that runs the kernels. Surfaces that are too large for its bindings are drawn by the CPU executor.
pub struct GpuDevice {
    gpu: &'static adapter::Gpu,
    kernels: Arc<Kernels>,
}

/// What draws what a GPU does not hold. Says so once for each reason.
fn cpu(reason: &Once, what: std::fmt::Arguments) -> &'static CpuDevice {
    static CPU: OnceLock<CpuDevice> = OnceLock::new();
    reason.call_once(|| log::warn!(target: "tepui::gpu", "{what}; the CPU draws it"));
    CPU.get_or_init(CpuDevice::new)
}

/// Whether the machine has a real GPU that Vulkan reaches. Next to free where it has none.
pub fn real_gpu_present() -> bool {
    adapter::device_files_present() && adapter::hardware_adapter_present()
}

impl GpuDevice {
    /// Opens the best Vulkan adapter, software ones included.
    pub fn new() -> Result<GpuDevice, String> {
        GpuDevice::with(|_| ())
    }

    /// The same, used in another way than its kind suggests.
    pub fn with(change: impl FnOnce(&mut Config)) -> Result<GpuDevice, String> {
        let gpu = adapter::gpu()?;
        let mut config = gpu.config;
        change(&mut config);
        Ok(GpuDevice { gpu, kernels: Arc::new(Kernels::new(gpu, config)) })
    }

    /// A surface with the GPU's own methods; an error where it is too large for the GPU.
    pub fn gpu_surface(&self, width: u32, height: u32, format: SurfaceFormat) -> Result<GpuSurface, String> {
        if !self.holds([width, height], format.samples) {
            return Err(format!("{width} x {height} pixels of {} samples are too many for {}", format.samples, self.gpu.info.name));
        }
        Ok(GpuSurface::new(self.gpu, self.kernels.clone(), self.target(width, height, format)))
    }

    /// Whether planes of a size fit the GPU's bindings. The same for all formats, so that the planes of a target are of one kind.
    fn holds(&self, size: [u32; 2], samples: u32) -> bool {
        let pixels = size[0] as u64 * size[1] as u64;
        pixels.saturating_mul(samples as u64 * WIDEST_PIXEL) <= self.kernels.config.plane_limit
    }

    /// What draws surfaces that the GPU does not hold.
    fn cpu(&self) -> &CpuDevice {
        static REASON: Once = Once::new();
        cpu(&REASON, format_args!("a surface is too large for {}", self.gpu.info.name))
    }
}

impl Device for GpuDevice {
    fn name(&self) -> String {
        format!("{}, {}, {} lanes", self.gpu.info.name, self.gpu.info.driver_info, self.kernels.config.shape.fine_lanes)
    }

    fn plane(&self, size: [u32; 2], samples: u32, format: PlaneFormat) -> SharedPlane {
        if self.holds(size, samples) { GpuPlane::plane(self.gpu, size, samples, format) } else { self.cpu().plane(size, samples, format) }
    }

    fn surface_on(&self, target: Target) -> Box<dyn Surface> {
        if !self.holds(target.size, target.format.samples) {
            return self.cpu().surface_on(target);
        }
        Box::new(GpuSurface::new(self.gpu, self.kernels.clone(), target))
    }

    fn retarget(&self, surface: &mut Box<dyn Surface>, target: Target) {
        let [before, after] = [surface.target(), &target].map(|t| self.holds(t.size, t.format.samples));
        if before == after {
            return surface.retarget(target);
        }
        surface.settle();
        *surface = self.surface_on(target);
    }
}
