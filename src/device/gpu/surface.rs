//! A surface whose pixels live on the GPU.

use std::sync::Arc;

use bytemuck::{bytes_of, cast_slice};

use super::adapter::Gpu;
use super::buffers::{Growing, create};
use super::encode::{Action, place_lists, plan};
use super::fill::Fill;
use super::front::HostFront;
use super::kernels::{Kernels, Stage};
use super::params::Params;
use super::profile::Profile;
use super::texture::Heap;
use crate::device::{Pixels, Surface, SurfaceFormat};
use crate::draw::Batch;

/// Distance of two dispatches' parameters, a multiple of every device's alignment.
const PARAMS_STRIDE: usize = 256;

/// Which copy of the pixels is ahead.
#[derive(Clone, Copy, PartialEq)]
enum Newer {
    Same,
    Gpu,
    Host,
}

/// The buffers that a batch is uploaded to and worked on in.
struct Buffers {
    uniforms: Growing,
    records: Growing,
    triangles: Growing,
    planes: Growing,
    lists: Growing,
    params: Growing,
    indirect: wgpu::Buffer,
    /// Words of the list buffer that belong to masks: zero between segments.
    mask_capacity: u32,
}

/// A surface of the GPU executor.
pub struct GpuSurface {
    gpu: &'static Gpu,
    kernels: Arc<Kernels>,
    color: wgpu::Buffer,
    depth: wgpu::Buffer,
    readback: Option<wgpu::Buffer>,
    buffers: Buffers,
    heap: Heap,
    fills: [Fill; 2],
    front: HostFront,
    bind_groups: Option<(u64, wgpu::BindGroup, wgpu::BindGroup)>,
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
        let device = &gpu.device;
        let storage = wgpu::BufferUsages::STORAGE;
        let pixel_usage = storage | wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::COPY_SRC;
        let buffers = Buffers {
            uniforms: Growing::new(device, "uniforms", storage),
            records: Growing::new(device, "records", storage),
            triangles: Growing::new(device, "triangles", storage),
            planes: Growing::new(device, "planes", storage),
            lists: Growing::new(device, "lists", storage),
            params: Growing::new(device, "params", wgpu::BufferUsages::UNIFORM),
            indirect: create(device, "indirect", storage | wgpu::BufferUsages::INDIRECT, 256),
            mask_capacity: 0,
        };
        GpuSurface {
            color: create(device, "colour", pixel_usage, pixels.color.len() as u64 * 4),
            depth: create(device, "depth", pixel_usage, pixels.depth_stencil.len() as u64 * 4),
            gpu,
            kernels,
            readback: None,
            buffers,
            heap: Heap::new(device),
            fills: [Fill::new(device), Fill::new(device)],
            front: HostFront::default(),
            bind_groups: None,
            pixels,
            newer: Newer::Same,
        }
    }

    fn upload_pixels(&mut self) {
        let queue = &self.gpu.queue;
        if !self.pixels.color.is_empty() {
            queue.write_buffer(&self.color, 0, cast_slice(&self.pixels.color));
        }
        if !self.pixels.depth_stencil.is_empty() {
            queue.write_buffer(&self.depth, 0, cast_slice(&self.pixels.depth_stencil));
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
        encoder.copy_buffer_to_buffer(&self.color, 0, readback, 0, color);
        if depth > 0 {
            encoder.copy_buffer_to_buffer(&self.depth, 0, readback, color, depth);
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

    /// Bind groups of the buffers as they are now.
    fn bind(&mut self) {
        let b = &self.buffers;
        let growing = [&b.uniforms, &b.records, &b.triangles, &b.planes, &b.lists, &b.params];
        // Generations only grow, so their sum says whether any did.
        let generation = growing.iter().map(|g| g.generation as u64).sum::<u64>() + self.heap.generation() as u64;
        if self.bind_groups.as_ref().is_some_and(|g| g.0 == generation) {
            return;
        }
        let device = &self.gpu.device;
        let storage = [
            b.uniforms.get(),
            b.records.get(),
            b.triangles.get(),
            b.planes.get(),
            b.lists.get(),
            &self.color,
            &self.depth,
            self.heap.buffer(),
        ];
        let mut entries: Vec<_> =
            storage.iter().enumerate().map(|(k, b)| wgpu::BindGroupEntry { binding: k as u32, resource: b.as_entire_binding() }).collect();
        let size = wgpu::BufferSize::new(size_of::<Params>() as u64);
        let params = wgpu::BufferBinding { buffer: b.params.get(), offset: 0, size };
        entries.push(wgpu::BindGroupEntry { binding: 8, resource: wgpu::BindingResource::Buffer(params) });
        let stages = device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout: &self.kernels.layout, entries: &entries });
        let scan = device.create_bind_group(&wgpu::BindGroupDescriptor {
            label: None,
            layout: &self.kernels.indirect_layout,
            entries: &[wgpu::BindGroupEntry { binding: 0, resource: b.indirect.as_entire_binding() }],
        });
        self.bind_groups = Some((generation, stages, scan));
    }

    fn run(&mut self, batch: &Batch) {
        let size = [self.pixels.width, self.pixels.height];
        if size[0] == 0 || size[1] == 0 {
            return;
        }
        let format = self.pixels.format;
        let t0 = std::time::Instant::now();
        self.front.run(batch, format.top_first);
        let t1 = std::time::Instant::now();
        let Gpu { device, queue, shape, .. } = self.gpu;
        self.heap.prepare(device, queue, &batch.textures);
        let mut plan = plan(batch, &self.front, &mut self.heap, size, format);

        // Offsets and sizes, then the uploads.
        let b = &mut self.buffers;
        let most = plan.mask_words.max(b.mask_capacity);
        let mut list_words = 0;
        for action in &mut plan.actions {
            if let Action::Draw(params, ..) = action {
                list_words = list_words.max(place_lists(params, most) as u64);
            }
        }
        let generation = b.lists.generation;
        b.lists.reserve(device, list_words * 4);
        if most > b.mask_capacity && b.lists.generation == generation {
            // The masks take over words that held lists: a fresh buffer is zero.
            let bytes = b.lists.get().size() + 256;
            b.lists.reserve(device, bytes);
        }
        b.mask_capacity = most;
        b.uniforms.upload(device, queue, cast_slice(&batch.uniforms));
        b.records.upload(device, queue, cast_slice(&plan.records));
        b.triangles.upload(device, queue, cast_slice(&self.front.triangles));
        b.planes.upload(device, queue, cast_slice(&self.front.planes));
        let mut bytes = vec![0u8; plan.actions.len() * PARAMS_STRIDE];
        for (action, to) in plan.actions.iter().zip(bytes.chunks_mut(PARAMS_STRIDE)) {
            let (Action::Clear(params) | Action::Draw(params, ..)) = action;
            to[..size_of::<Params>()].copy_from_slice(bytes_of(params));
        }
        b.params.upload(device, queue, &bytes);
        self.bind();
        let Some((_, stages, scan)) = &self.bind_groups else { return };

        let mut profile = Profile::new(self.gpu);
        let mut mark = |pass: &mut wgpu::ComputePass, name| {
            if let Some(p) = &mut profile {
                p.mark(pass, name);
            }
        };
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let mut first_action = 0;
        if let (Some(Action::Clear(p)), true) = (plan.actions.first(), shape.list_lanes < 64) {
            first_action = clear_by_copy(&mut self.fills, self.gpu, &mut encoder, p, &self.pixels, [&self.color, &self.depth]) as usize;
        }
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            let lanes = |stage_lanes: u32, count: u32| {
                let groups = count.div_ceil(stage_lanes).max(1);
                (groups.min(32768), groups.div_ceil(32768))
            };
            mark(&mut pass, "start");
            for (k, action) in plan.actions.iter().enumerate().skip(first_action) {
                pass.set_bind_group(0, stages, &[(k * PARAMS_STRIDE) as u32]);
                match action {
                    Action::Clear(p) => {
                        pass.set_pipeline(&self.kernels.stage(self.gpu, Stage::Clear(format.color.words() as u32)));
                        let columns = (p.clear_max[0] - p.clear_min[0]) as u32;
                        pass.dispatch_workgroups(columns.div_ceil(shape.list_lanes), (p.clear_max[1] - p.clear_min[1]) as u32, 1);
                        mark(&mut pass, "clear");
                    }
                    Action::Draw(p, key, draw) => {
                        let program = &batch.draws[*draw as usize].fragment_program;
                        let (x, y) = lanes(shape.list_lanes, p.triangle_count);
                        pass.set_pipeline(&self.kernels.stage(self.gpu, Stage::Bin));
                        pass.dispatch_workgroups(x, y, 1);
                        mark(&mut pass, "bin");
                        let (x, y) = lanes(shape.list_lanes, p.bins[0] * p.bins[1] * p.supers);
                        pass.set_pipeline(&self.kernels.stage(self.gpu, Stage::Count));
                        pass.dispatch_workgroups(x, y, 1);
                        mark(&mut pass, "count");
                        pass.set_pipeline(&self.kernels.stage(self.gpu, Stage::Scan));
                        pass.set_bind_group(1, scan, &[]);
                        pass.dispatch_workgroups(1, 1, 1);
                        mark(&mut pass, "scan");
                        pass.set_pipeline(&self.kernels.stage(self.gpu, Stage::Emit));
                        pass.dispatch_workgroups(x, y, 1);
                        mark(&mut pass, "emit");
                        pass.set_pipeline(&self.kernels.stage(self.gpu, Stage::Tile));
                        pass.dispatch_workgroups_indirect(&self.buffers.indirect, 0);
                        mark(&mut pass, "tile");
                        pass.set_pipeline(&self.kernels.stage(self.gpu, Stage::Active));
                        let bins = p.bins[0] * p.bins[1];
                        pass.dispatch_workgroups(bins.min(32768), bins.div_ceil(32768), 1);
                        mark(&mut pass, "active");
                        pass.set_pipeline(&self.kernels.fine(self.gpu, key, program));
                        pass.dispatch_workgroups_indirect(&self.buffers.indirect, 36);
                        mark(&mut pass, "fine");
                    }
                }
            }
        }
        match profile {
            Some(profile) => profile.print(self.gpu, encoder),
            None => {
                queue.submit([encoder.finish()]);
            }
        }
        self.newer = Newer::Gpu;
        if stats_level() > 0 {
            let triangles = self.front.triangles.len();
            let draws = plan.actions.iter().filter(|a| matches!(a, Action::Draw(..))).count();
            eprintln!(
                "tepui: gpu: {triangles} triangles of {} primitives, {} draws, {draws} segments, front end on the host {:.2} ms, encode {:.2} ms",
                batch.primitives.len(),
                batch.draws.len(),
                (t1 - t0).as_secs_f64() * 1e3,
                t1.elapsed().as_secs_f64() * 1e3,
            );
        }
    }
}

/// Clears all of a surface by copies; false where the clear is not of that kind.
fn clear_by_copy(
    fills: &mut [Fill; 2],
    gpu: &Gpu,
    encoder: &mut wgpu::CommandEncoder,
    p: &Params,
    pixels: &Pixels,
    buffers: [&wgpu::Buffer; 2],
) -> bool {
    let words = pixels.format.color.words();
    let used = if pixels.format.stencil { !0 } else { 0xff_ffff };
    let (color, depth) = (p.clear_mask != [0; 4], p.clear_depth_mask != 0);
    let whole = p.clear_min == [0; 2] && p.clear_max == p.size.map(|s| s as i32);
    if !whole || color && p.clear_mask[..words] != [!0; 4][..words] || depth && p.clear_depth_mask & used != used {
        return false;
    }
    for (k, (on, pattern, words)) in
        [(color, &p.clear_color[..words], pixels.color.len()), (depth, std::slice::from_ref(&p.clear_depth), pixels.depth_stencil.len())]
            .into_iter()
            .enumerate()
    {
        if on {
            fills[k].prepare(&gpu.device, &gpu.queue, pattern, words);
            fills[k].copy(encoder, buffers[k], words);
        }
    }
    true
}

impl Surface for GpuSurface {
    fn execute(&mut self, batch: Batch) {
        if self.newer == Newer::Host {
            self.upload_pixels();
        }
        self.run(&batch);
    }

    fn pixels(&mut self) -> &Pixels {
        if self.newer == Newer::Gpu {
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
