//! A surface whose pixels live on the GPU.

use std::sync::Arc;

use bytemuck::cast_slice;

use super::adapter::Gpu;
use super::buffers::create;
use super::execute::{Buffers, Executor};
use super::kernels::Kernels;
use super::profile::StageTime;
use crate::device::{Pixels, Surface, SurfaceFormat};
use crate::draw::Batch;

/// Which copy of the pixels is ahead.
#[derive(Clone, Copy, PartialEq)]
enum Newer {
    Same,
    Gpu,
    Host,
}

/// A surface of the GPU executor.
pub struct GpuSurface {
    gpu: &'static Gpu,
    executor: Executor,
    readback: Option<wgpu::Buffer>,
    pixels: Pixels,
    newer: Newer,
}

/// `TEPUI_STATS`: 1 says what a batch held, 2 adds the times of its stages.
pub fn stats_level() -> u32 {
    static LEVEL: std::sync::OnceLock<u32> = std::sync::OnceLock::new();
    *LEVEL.get_or_init(|| std::env::var("TEPUI_STATS").ok().and_then(|v| v.parse().ok()).unwrap_or(0))
}

impl GpuSurface {
    /// Zeroed pixels.
    pub fn new(gpu: &'static Gpu, kernels: Arc<Kernels>, width: u32, height: u32, format: SurfaceFormat) -> GpuSurface {
        let pixels = Pixels::new(width, height, format);
        let executor = Executor::new(gpu, kernels, Buffers::new(gpu, &pixels), [width, height], format);
        GpuSurface { gpu, executor, readback: None, pixels, newer: Newer::Same }
    }

    /// Draws a batch again and again and measures it: see [`Executor::timed`].
    pub fn timed(&mut self, batch: &Batch, frames: usize, stages: bool) -> Vec<Vec<StageTime>> {
        self.newer = Newer::Gpu;
        self.executor.timed(batch, frames, stages)
    }

    /// Bytes of the buffers that grow with a batch, by name.
    pub fn memory(&self) -> Vec<(&'static str, u64)> {
        self.executor.memory()
    }

    fn upload_pixels(&mut self) {
        let queue = &self.gpu.queue;
        if !self.pixels.color.is_empty() {
            queue.write_buffer(&self.executor.buffers.color, 0, cast_slice(&self.pixels.color));
        }
        if !self.pixels.depth_stencil.is_empty() {
            queue.write_buffer(&self.executor.buffers.depth, 0, cast_slice(&self.pixels.depth_stencil));
        }
        self.newer = Newer::Same;
    }

    fn download_pixels(&mut self) {
        self.newer = Newer::Same;
        let (color, depth) = (self.pixels.color.len() as u64 * 4, self.pixels.depth_stencil.len() as u64 * 4);
        if color + depth == 0 {
            return;
        }
        let Gpu { device, queue, .. } = self.gpu;
        let usage = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST;
        let readback = self.readback.get_or_insert_with(|| create(device, "readback", usage, color + depth));
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        encoder.copy_buffer_to_buffer(&self.executor.buffers.color, 0, readback, 0, color);
        if depth > 0 {
            encoder.copy_buffer_to_buffer(&self.executor.buffers.depth, 0, readback, color, depth);
        }
        queue.submit([encoder.finish()]);
        let slice = readback.slice(..color + depth);
        slice.map_async(wgpu::MapMode::Read, |_| {});
        if let Err(e) = device.poll(wgpu::PollType::wait_indefinitely()) {
            log::error!(target: "tepui::gpu", "waiting for the GPU: {e}");
            return;
        }
        match slice.get_mapped_range() {
            Ok(bytes) => {
                let (c, d) = bytes.split_at(color as usize);
                bytemuck::cast_slice_mut::<u32, u8>(&mut self.pixels.color).copy_from_slice(c);
                bytemuck::cast_slice_mut::<u32, u8>(&mut self.pixels.depth_stencil).copy_from_slice(d);
            }
            Err(e) => log::error!(target: "tepui::gpu", "reading pixels back: {e}"),
        }
        readback.unmap();
    }
}

impl Surface for GpuSurface {
    fn execute(&mut self, batch: Batch) {
        if self.pixels.color.is_empty() {
            return;
        }
        if self.newer == Newer::Host {
            self.upload_pixels();
        }
        self.executor.execute(batch);
        self.newer = Newer::Gpu;
    }

    fn pixels(&mut self) -> &Pixels {
        if self.newer == Newer::Gpu {
            self.executor.settle();
            self.download_pixels();
        }
        &self.pixels
    }

    fn pixels_mut(&mut self) -> &mut Pixels {
        self.pixels();
        self.newer = Newer::Host;
        &mut self.pixels
    }
}
