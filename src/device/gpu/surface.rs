//! A surface whose planes live on the GPU.

use std::any::Any;
use std::sync::{Arc, Once};

use bytemuck::cast_slice;
use rayon::prelude::*;

use super::adapter::Gpu;
use super::buffers::create;
use super::execute::{Buffers, Executor};
use super::kernels::Kernels;
use super::profile::StageTime;
use crate::device::plane::{self, Resolved, Storage};
use crate::device::{Device, Plane, PlaneFormat, SharedPlane, Surface, Target, lines};
use crate::draw::Batch;
use crate::draw::clears::complete_stencil;

/// Rows that a thread copies at least.
const COPIED_ROWS: usize = 256;

/// A plane's pixels on the GPU: rows, sample by sample.
pub struct GpuPlane {
    gpu: &'static Gpu,
    /// The pixels.
    pub buffer: wgpu::Buffer,
    readback: Option<wgpu::Buffer>,
}

impl GpuPlane {
    /// Of zeros.
    pub fn plane(gpu: &'static Gpu, size: [u32; 2], samples: u32, format: PlaneFormat) -> SharedPlane {
        let usage = wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC;
        // Where there is one memory, pixels are read and cleared where they lie.
        let mappable = gpu.device.features().contains(wgpu::Features::MAPPABLE_PRIMARY_BUFFERS);
        let usage = if mappable { usage | wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::MAP_WRITE } else { usage };
        let bytes = size[0] as u64 * size[1] as u64 * samples as u64 * format.words() as u64 * 4;
        let label = if matches!(format, PlaneFormat::Color(_)) { "colour" } else { "depth" };
        let buffer = create(&gpu.device, label, usage, bytes);
        Plane::new(size, samples, format, Box::new(GpuPlane { gpu, buffer, readback: None }))
    }
}

impl GpuPlane {
    /// Shows the pixels to `look`, as bytes, when all that was submitted is done.
    fn look(&mut self, bytes: u64, look: impl FnOnce(&[u8])) {
        if bytes == 0 {
            return;
        }
        let Gpu { device, queue, .. } = self.gpu;
        let source = if self.buffer.usage().contains(wgpu::BufferUsages::MAP_READ) {
            // What is still to be uploaded.
            queue.submit([]);
            &self.buffer
        } else {
            let usage = wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST;
            let readback = self.readback.get_or_insert_with(|| create(device, "readback", usage, bytes));
            let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
            encoder.copy_buffer_to_buffer(&self.buffer, 0, readback, 0, bytes);
            queue.submit([encoder.finish()]);
            readback
        };
        let slice = source.slice(..bytes);
        slice.map_async(wgpu::MapMode::Read, |_| {});
        if let Err(e) = device.poll(wgpu::PollType::wait_indefinitely()) {
            log::error!(target: "tepui::gpu", "waiting for the GPU: {e}");
            return;
        }
        match slice.get_mapped_range() {
            Ok(bytes) => look(&bytes),
            Err(e) => log::error!(target: "tepui::gpu", "reading pixels back: {e}"),
        }
        source.unmap();
    }
}

impl Storage for GpuPlane {
    fn read(&mut self, rows: &mut [u32]) {
        self.look(size_of_val(rows) as u64, |bytes| bytemuck::cast_slice_mut::<u32, u8>(rows).copy_from_slice(bytes));
    }

    fn write(&mut self, rows: &[u32]) {
        if !rows.is_empty() {
            self.gpu.queue.write_buffer(&self.buffer, 0, cast_slice(rows));
        }
    }

    fn as_any(&mut self) -> &mut dyn Any {
        self
    }
}

/// A surface of the GPU executor.
pub struct GpuSurface {
    gpu: &'static Gpu,
    executor: Executor,
    target: Target,
    resolved: Resolved,
}

/// `TEPUI_STATS`: 1 says what a batch held, 2 adds the times of its stages.
pub fn stats_level() -> u32 {
    static LEVEL: std::sync::OnceLock<u32> = std::sync::OnceLock::new();
    *LEVEL.get_or_init(|| std::env::var("TEPUI_STATS").ok().and_then(|v| v.parse().ok()).unwrap_or(0))
}

/// Copies all samples from plane to plane of the same shape, whatever devices they are on.
fn copy_rows(from: &SharedPlane, to: &SharedPlane) {
    plane::lock(to).rows_mut().copy_from_slice(plane::lock(from).rows());
}

/// The buffer of a plane that is about to be drawn into.
fn buffer(plane: &SharedPlane) -> Option<wgpu::Buffer> {
    plane::lock(plane).storage_mut::<GpuPlane>().map(|plane| plane.buffer.clone())
}

impl GpuSurface {
    /// A surface on planes of the GPU.
    pub fn new(gpu: &'static Gpu, kernels: Arc<Kernels>, target: Target) -> GpuSurface {
        let executor = Executor::new(gpu, kernels, Buffers::new(gpu), target.size, target.format);
        GpuSurface { gpu, executor, target, resolved: Resolved::default() }
    }

    /// Binds the target's planes, host changes uploaded; false where there is nothing to draw into.
    fn bind(&mut self) -> bool {
        if self.target.size.contains(&0) {
            return false;
        }
        let Some(color) = buffer(&self.target.color) else { return false };
        let depth = self.target.depth.as_ref().and_then(buffer);
        self.executor.retarget(color, depth, self.target.size, self.target.format);
        true
    }

    /// The same for a batch, whose clears of depth write the stencil that is there, where it is known.
    fn bind_for(&mut self, batch: &mut Batch) -> bool {
        let depth = self.target.depth.clone().filter(|_| self.target.format.stencil);
        // Binding forgets it.
        let known = depth.as_ref().and_then(|plane| plane::lock(plane).uniform_stencil());
        if !self.bind() {
            return false;
        }
        let after = complete_stencil(batch, known, self.target.size);
        if let Some(plane) = &depth {
            plane::lock(plane).set_uniform_stencil(after);
        }
        true
    }

    /// The CPU executor draws a batch, on copies of the planes.
    fn execute_on_cpu(&mut self, batch: Batch) {
        static REASON: Once = Once::new();
        let cpu = super::cpu(&REASON, format_args!("the textures of a batch are too large for {}", self.gpu.info.name));
        let copied = |plane: &SharedPlane| {
            let (size, samples, format) = {
                let plane = plane::lock(plane);
                (plane.size, plane.samples, plane.format)
            };
            let copy = cpu.plane(size, samples, format);
            copy_rows(plane, &copy);
            copy
        };
        let color = copied(&self.target.color);
        let depth = self.target.depth.as_ref().map(copied);
        let mut surface = cpu.surface_on(Target { color: color.clone(), depth: depth.clone(), ..self.target });
        surface.execute(batch);
        surface.settle();
        copy_rows(&color, &self.target.color);
        if let (Some(from), Some(to)) = (&depth, &self.target.depth) {
            copy_rows(from, to);
        }
    }

    /// Draws a batch again and again and measures it: see [`Executor::timed`].
    pub fn timed(&mut self, batch: &Batch, frames: usize, stages: bool) -> Vec<Vec<StageTime>> {
        let mut batch = batch.clone();
        if self.bind_for(&mut batch) { self.executor.timed(&batch, frames, stages) } else { Vec::new() }
    }

    /// Other bytes for what lies between a batch's input and its pixels: see [`Config::budget`](super::Config::budget).
    pub fn set_budget(&mut self, bytes: u64) {
        self.executor.budget = bytes;
    }

    /// Bytes of the buffers that grow with a batch, by name.
    pub fn memory(&self) -> Vec<(&'static str, u64)> {
        self.executor.memory()
    }
}

impl Surface for GpuSurface {
    fn target(&self) -> &Target {
        &self.target
    }

    fn retarget(&mut self, target: Target) {
        self.executor.settle();
        self.target = target;
        self.resolved = Resolved::default();
    }

    fn execute(&mut self, mut batch: Batch) {
        // What is left of the last batch comes before changes from the host.
        self.executor.settle();
        if self.bind_for(&mut batch)
            && let Some(batch) = self.executor.execute(batch)
        {
            self.execute_on_cpu(batch);
        }
    }

    fn settle(&mut self) {
        self.executor.settle();
    }

    fn resolved(&mut self) -> &SharedPlane {
        self.executor.settle();
        let GpuSurface { gpu, executor, target, resolved } = self;
        let Target { size, format, .. } = *target;
        let new = || GpuPlane::plane(gpu, size, 1, PlaneFormat::Color(format.color));
        resolved.of(target, new, |from, to| {
            let from = plane::lock(from).storage::<GpuPlane>().map(|plane| plane.buffer.clone());
            if let (Some(from), Some(to)) = (from, buffer(to)) {
                executor.resolve(&from, &to, size, format);
            }
        })
    }

    /// Straight from the device's memory.
    fn copy_color(&mut self, out: &mut [u8], stride: usize, bottom_up: bool) {
        let mut plane = plane::lock(self.resolved());
        let (height, row_bytes) = (plane.size[1] as usize, plane.size[0] as usize * plane.format.words() * 4);
        let lines = lines(out, stride, height, bottom_up);
        let Some(storage) = plane.storage::<GpuPlane>() else { return };
        storage.look((row_bytes * height) as u64, |bytes| {
            let rows = bytes.par_chunks_exact(row_bytes).with_min_len(COPIED_ROWS);
            lines.into_par_iter().zip(rows).for_each(|(line, row)| line[..row_bytes].copy_from_slice(row));
        });
    }
}
