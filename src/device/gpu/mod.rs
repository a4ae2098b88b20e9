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
mod surface;
#[cfg(test)]
mod tests;
mod texture;

use std::sync::Arc;

use super::{Device, Surface, SurfaceFormat};
use kernels::Kernels;

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
        let gpu = adapter::gpu()?;
        Ok(GpuDevice { gpu, kernels: Arc::new(Kernels::new(gpu)) })
    }
}

impl Device for GpuDevice {
    fn name(&self) -> String {
        format!("{}, {}, {} lanes", self.gpu.info.name, self.gpu.info.driver_info, self.gpu.shape.fine_lanes)
    }

    fn surface(&self, width: u32, height: u32, format: SurfaceFormat) -> Box<dyn Surface> {
        Box::new(surface::GpuSurface::new(self.gpu, self.kernels.clone(), width, height, format))
    }
}
