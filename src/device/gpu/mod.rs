//! Batches through wgpu compute: the kernels in `shaders/`, the twins of [`crate::raster`]'s stages, on the same records.

mod adapter;
mod buffers;
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
mod source;
mod stage;
mod stats;
mod surface;
#[cfg(test)]
mod tests;
mod texture;
mod visible;

use std::sync::Arc;

use super::{Device, PlaneFormat, SharedPlane, Surface, SurfaceFormat, Target};
pub use adapter::{Config, Shape};
use kernels::Kernels;
pub use profile::StageTime;
pub use surface::{GpuPlane, GpuSurface};

/// A Vulkan device that runs the kernels.
pub struct GpuDevice {
    gpu: &'static adapter::Gpu,
    kernels: Arc<Kernels>,
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

    /// A surface with the GPU's own methods.
    pub fn gpu_surface(&self, width: u32, height: u32, format: SurfaceFormat) -> GpuSurface {
        GpuSurface::new(self.gpu, self.kernels.clone(), self.target(width, height, format))
    }
}

impl Device for GpuDevice {
    fn name(&self) -> String {
        format!("{}, {}, {} lanes", self.gpu.info.name, self.gpu.info.driver_info, self.kernels.config.shape.fine_lanes)
    }

    fn plane(&self, size: [u32; 2], samples: u32, format: PlaneFormat) -> SharedPlane {
        GpuPlane::plane(self.gpu, size, samples, format)
    }

    fn surface_on(&self, target: Target) -> Box<dyn Surface> {
        Box::new(GpuSurface::new(self.gpu, self.kernels.clone(), target))
    }
}
