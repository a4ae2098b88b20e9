//! Runs batches: uploads, dispatches in one pass, and a second look at batches that did not fit their buffers.

use std::sync::Arc;

use bytemuck::{bytes_of, cast_slice};

use super::adapter::Gpu;
use super::budget::SMALL_BUFFERS;
use super::buffers::{Growing, create};
use super::clears::writes_whole;
use super::encode::{Action, DrawAction, Place, Plan, Planner, VisibleAction, bins_of, place_lists};
use super::fill::fill;
use super::fine::feature;
use super::front::FrontRecords;
use super::host_front::HostFront;
use super::kernels::{Kernels, TEXELS};
use super::params::{FrontParams, Params, SEGMENT_WORDS, Status, fresh, indirect};
use super::profile::{Profile, StageTime};
use super::records::DRAW_WORDS;
use super::room::Room;
use super::stage::{CLEAR_ROWS, LARGE_ITEMS, Offers, Stage, VISIBLE_LANES, Visible, emit_lanes};
use super::stats;
use super::surface::stats_level;
use super::texture::Heap;
use super::visible;
use crate::device::SurfaceFormat;
use crate::draw::{Batch, Step, recycle};
use crate::raster::runs;

/// Distance of two blocks of parameters, a multiple of every device's alignment.
const PARAMS_STRIDE: usize = 256;

/// Workgroups of the visible path's clip kernel and of its kernel for large triangles: enough to fill the largest GPUs.
const CLIP_GROUPS: u32 = 256;
const LARGE_GROUPS: u32 = 4096;

/// How long a measurement draws before it counts.
const WARM_UP: std::time::Duration = std::time::Duration::from_millis(300);

/// The buffers that a batch is uploaded to and worked on in.
pub struct Buffers {
    /// The pixels' colour.
    pub color: wgpu::Buffer,
    /// The pixels' depth and stencil.
    pub depth: wgpu::Buffer,
    /// What stands for them where there are none.
    no_depth: wgpu::Buffer,
    uniforms: Growing,
    vertices: Growing,
    primitives: Growing,
    front_records: Growing,
    shaded: Growing,
    records: Growing,
    triangles: Growing,
    planes: Growing,
    front: Growing,
    lists: Growing,
    params: Growing,
    indirect: Growing,
    /// The visible path's keys, made when they are first wanted, and its queue.
    keys: Option<Keys>,
    queue: Growing,
    status: wgpu::Buffer,
    /// Words of the list buffer that belong to masks: zero between segments.
    mask_capacity: u32,
}

impl Buffers {
    /// Small ones, but for the pixels.
    pub fn new(gpu: &Gpu) -> Buffers {
        let device = &gpu.device;
        let storage = wgpu::BufferUsages::STORAGE;
        let growing = |label| Growing::new(device, label, storage);
        // What a host that sets up writes most of.
        let mappable = device.features().contains(wgpu::Features::MAPPABLE_PRIMARY_BUFFERS);
        let filled = |label| Growing::new(device, label, if mappable { storage | wgpu::BufferUsages::MAP_WRITE } else { storage });
        let indirect = storage | wgpu::BufferUsages::INDIRECT | wgpu::BufferUsages::COPY_SRC;
        Buffers {
            color: create(device, "no colour", storage, 0),
            depth: create(device, "no depth", storage, 0),
            no_depth: create(device, "no depth", storage, 0),
            uniforms: growing("uniforms"),
            vertices: growing("vertices"),
            primitives: growing("primitives"),
            front_records: growing("front records"),
            shaded: growing("shaded"),
            records: growing("records"),
            triangles: filled("triangles"),
            planes: filled("planes"),
            front: growing("front"),
            lists: growing("lists"),
            params: Growing::new(device, "params", wgpu::BufferUsages::UNIFORM),
            indirect: Growing::new(device, "dispatches", indirect),
            keys: None,
            queue: growing("queue"),
            status: create(device, "status", wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST, size_of::<Status>() as u64),
            mask_capacity: 0,
        }
    }
}

/// Bind groups: the front end's, the later stages', the dispatches'.
struct Bound {
    generation: u64,
    front: wgpu::BindGroup,
    stages: wgpu::BindGroup,
    visible: Option<wgpu::BindGroup>,
    indirect: wgpu::BindGroup,
}

/// A batch on its way: kept until it is known that all of it was drawn.
struct Pending {
    batch: Batch,
    places: Vec<Place>,
}

/// Runs batches on the pixels of a surface.
pub struct Executor {
    gpu: &'static Gpu,
    kernels: Arc<Kernels>,
    /// The pixels, and everything else on the device.
    pub buffers: Buffers,
    size: [u32; 2],
    format: SurfaceFormat,
    room: Room,
    /// Most bytes of all that lies between a batch's input and its pixels, as far as cutting it helps.
    pub budget: u64,
    heap: Heap,
    host_front: HostFront,
    bound: Option<Bound>,
    pending: Option<Pending>,
}

/// The visible path's keys.
struct Keys {
    buffer: wgpu::Buffer,
    /// Rows that it has room for.
    rows: u32,
    generation: u32,
}

/// A batch's uploads and dispatches, ready to be encoded.
struct Prepared {
    plan: Plan,
    /// The host has set it up.
    on_host: bool,
}

impl Executor {
    /// For a surface.
    pub fn new(gpu: &'static Gpu, kernels: Arc<Kernels>, buffers: Buffers, size: [u32; 2], format: SurfaceFormat) -> Executor {
        let device = &gpu.device;
        Executor {
            gpu,
            buffers,
            size,
            format,
            room: Room::new(kernels.config.buffer_limit, bins_of(size)),
            budget: kernels.config.budget,
            heap: Heap::new(device, kernels.config.shape),
            kernels,
            host_front: HostFront::default(),
            bound: None,
            pending: None,
        }
    }

    /// Draws into other buffers, or the same ones, from now on. Nothing may be left of the batch before.
    pub fn retarget(&mut self, color: wgpu::Buffer, depth: Option<wgpu::Buffer>, size: [u32; 2], format: SurfaceFormat) {
        let depth = depth.unwrap_or_else(|| self.buffers.no_depth.clone());
        if (size, format.samples) != (self.size, self.format.samples) {
            self.room = Room::new(self.kernels.config.buffer_limit, bins_of(size));
            self.buffers.keys = None;
            self.bound = None;
        }
        if color != self.buffers.color || depth != self.buffers.depth {
            self.bound = None;
        }
        (self.buffers.color, self.buffers.depth) = (color, depth);
        (self.size, self.format) = (size, format);
    }

    /// Runs a batch, after what is left of the one before. Returns one whose textures the device does not hold.
    pub fn execute(&mut self, batch: Batch) -> Option<Batch> {
        self.settle();
        let Gpu { device, queue, .. } = self.gpu;
        if !self.heap.prepare(device, queue, &batch.textures, self.kernels.config.texel_limit) {
            return Some(batch);
        }
        self.run(batch);
        None
    }

    /// Waits until all that was executed is drawn, batches that did not fit included.
    pub fn settle(&mut self) {
        while let Some(Pending { mut batch, places }) = self.pending.take() {
            let Some(status) = self.status() else { return };
            let Some(&place) = places.get((status.failed as usize).wrapping_sub(1)) else { return recycle(batch) };
            log::debug!(target: "tepui::gpu", "a batch did not fit: {status:?}; the rest is drawn with more room or in smaller pieces");
            if !self.room.learn(&status, bins_of(self.size)) {
                log::error!(target: "tepui::gpu", "a batch does not fit the GPU's buffers even in the smallest pieces; the rest of it is not drawn: {status:?}");
                return;
            }
            batch.steps = rest(&batch.steps, place);
            if let Some(from) = batch.steps.iter().find_map(|s| if let Step::Primitives { first, .. } = s { Some(*first) } else { None }) {
                self.host_front.resume(&batch, self.format.top_first, from);
            }
            self.run(batch);
        }
    }

    fn status(&self) -> Option<Status> {
        let slice = self.buffers.status.slice(..);
        slice.map_async(wgpu::MapMode::Read, |_| {});
        if let Err(e) = self.gpu.device.poll(wgpu::PollType::wait_indefinitely()) {
            log::error!(target: "tepui::gpu", "waiting for the GPU: {e}");
            return None;
        }
        let status = match slice.get_mapped_range() {
            Ok(bytes) => Some(bytemuck::pod_read_unaligned(&bytes[..size_of::<Status>()])),
            Err(e) => {
                log::error!(target: "tepui::gpu", "reading a batch's status: {e}");
                None
            }
        };
        self.buffers.status.unmap();
        status
    }

    /// Bind groups of the buffers as they are now.
    fn bind(&mut self) {
        let b = &self.buffers;
        let growing = [
            &b.uniforms,
            &b.vertices,
            &b.primitives,
            &b.front_records,
            &b.shaded,
            &b.records,
            &b.triangles,
            &b.planes,
            &b.front,
            &b.lists,
            &b.params,
            &b.indirect,
            &b.queue,
        ];
        // Generations only grow, so their sum says whether any did.
        let more = self.heap.generation() as u64 + b.keys.as_ref().map_or(0, |keys| keys.generation as u64);
        let generation = growing.iter().map(|g| g.generation as u64).sum::<u64>() + more;
        if self.bound.as_ref().is_some_and(|g| g.generation == generation) {
            return;
        }
        let front = [&b.uniforms, &b.vertices, &b.primitives, &b.front_records, &b.shaded, &b.triangles, &b.planes, &b.front];
        let sizes = [size_of::<Params>() as u64, size_of::<FrontParams>() as u64];
        let visible = b.keys.as_ref().map(|keys| {
            // What primitives are to the kernels of the front end, triangles are that the host has set up.
            let on_host = self.kernels.config.shape.host_front;
            let [first, second] = if on_host { [&b.triangles, &b.planes] } else { [&b.primitives, &b.front_records] };
            let [uniforms, first, second, shaded, records, queue, vertices] =
                [&b.uniforms, first, second, &b.shaded, &b.records, &b.queue, &b.vertices].map(|g| g.get());
            let all = [uniforms, first, second, shaded, records, &b.color, &b.depth, &keys.buffer, queue, vertices];
            self.group(&self.kernels.visible_layout, &with_texels(&all, &self.heap), &sizes)
        });
        self.bound = Some(Bound {
            generation,
            visible,
            front: self.group(&self.kernels.front_layout, &front.map(|g| g.get().as_entire_binding()), &sizes[1..]),
            stages: self.stages_group(&b.color, &b.depth),
            indirect: self.group(&self.kernels.indirect_layout, &[b.indirect.get().as_entire_binding()], &[]),
        });
    }

    /// A bind group of what kernels work on, and parameters of these sizes.
    fn group(&self, layout: &wgpu::BindGroupLayout, storage: &[wgpu::BindingResource], params: &[u64]) -> wgpu::BindGroup {
        let storage = storage.iter().cloned();
        let params = params.iter().map(|&size| {
            let buffer = self.buffers.params.get();
            wgpu::BindingResource::Buffer(wgpu::BufferBinding { buffer, offset: 0, size: wgpu::BufferSize::new(size) })
        });
        let entries: Vec<_> =
            storage.chain(params).enumerate().map(|(k, resource)| wgpu::BindGroupEntry { binding: k as u32, resource }).collect();
        self.gpu.device.create_bind_group(&wgpu::BindGroupDescriptor { label: None, layout, entries: &entries })
    }

    /// What the stages behind the front end read and write.
    fn stages_group(&self, color: &wgpu::Buffer, depth: &wgpu::Buffer) -> wgpu::BindGroup {
        let b = &self.buffers;
        let [uniforms, records, triangles, planes, lists, segments] =
            [&b.uniforms, &b.records, &b.triangles, &b.planes, &b.lists, &b.front].map(|g| g.get());
        let stages = [uniforms, records, triangles, planes, lists, color, depth, segments];
        self.group(&self.kernels.layout, &with_texels(&stages, &self.heap), &[size_of::<Params>() as u64])
    }

    fn planner<'a>(&'a self, batch: &'a Batch) -> Planner<'a> {
        let config = self.kernels.config;
        Planner {
            batch,
            size: self.size,
            format: self.format,
            shape: config.shape,
            room: &self.room,
            visible_from: config.visible_from,
            visible_pixels: config.visible_pixels,
            visible_area: config.visible_area,
            direct_upto: config.direct_upto,
            soup_from: config.soup_from,
        }
    }

    /// Sets a batch up on the host and uploads the triangles.
    fn prepare_host(&mut self, batch: &Batch) -> Prepared {
        let Gpu { device, queue, .. } = self.gpu;
        self.host_front.run(batch, self.format.top_first);
        let plan = self.planner(batch).host(&self.host_front, &self.heap);
        let b = &mut self.buffers;
        b.triangles.upload(device, queue, cast_slice(&self.host_front.triangles));
        b.planes.fill(device, queue, self.host_front.plane_bytes(), |to| self.host_front.write_planes(to));
        b.front.upload(device, queue, cast_slice(&plan.segments));
        if !plan.queue.is_empty() {
            b.queue.upload(device, queue, cast_slice(&plan.queue));
        }
        self.upload_params(plan, true)
    }

    /// Uploads what the kernels of the front end read.
    fn prepare_kernels(&mut self, batch: &Batch) -> Prepared {
        let Gpu { device, queue, .. } = self.gpu;
        let mut records = FrontRecords::new(batch);
        let tables_and_records = (records.words.len() + batch.draws.len() * DRAW_WORDS) as u64 * 4 + SMALL_BUFFERS;
        self.room.available = self.budget.saturating_sub(tables_and_records);
        let (mut plan, tables) = self.planner(batch).kernels(&self.heap, &records);
        records.words.extend_from_slice(&tables);
        let segments = (plan.segments.len() as u32).next_multiple_of(4);
        let [mut front_words, mut triangles, mut planes, mut shaded] = [segments as u64 + 4, 0, 0, 0];
        // Where whoever wants a vertex shades it only the pool is there.
        let kept = |params: &FrontParams| if plan.soup { 0 } else { params.shaded_count as u64 };
        let shaded_vec4 = |params: &FrontParams| kept(params) + params.pool_capacity as u64;
        for (_, action) in &mut plan.actions {
            if let Action::Visible(action) = action {
                shaded = action.bands.iter().map(shaded_vec4).fold(shaded, u64::max);
            }
            if let Action::Front(action) = action {
                let params = &mut action.params;
                params.sums_base = segments;
                params.queue_base += segments;
                params.list_lanes = self.kernels.config.shape.list_lanes;
                front_words = front_words.max(params.queue_base as u64 + 4 + params.queue_capacity as u64 * 4);
                triangles = triangles.max(params.triangle_capacity as u64);
                planes = planes.max(params.plane_capacity as u64);
                shaded = shaded.max(shaded_vec4(params));
            }
        }
        let b = &mut self.buffers;
        b.vertices.upload(device, queue, cast_slice(&batch.vertices));
        b.primitives.upload(device, queue, cast_slice(&batch.primitives));
        b.front_records.upload(device, queue, cast_slice(&records.words));
        b.shaded.reserve(device, shaded * 16);
        b.triangles.reserve(device, triangles * size_of::<crate::raster::layout::Triangle>() as u64);
        b.planes.reserve(device, planes * 16);
        b.front.reserve(device, front_words * 4);
        b.queue.reserve(device, plan.queue_words as u64 * 4);
        self.upload_params(plan, false)
    }

    /// Places lists and parameters and uploads what is left.
    fn upload_params(&mut self, mut plan: Plan, on_host: bool) -> Prepared {
        let Gpu { device, queue, .. } = self.gpu;
        let b = &mut self.buffers;
        if b.keys.as_ref().map_or(0, |keys| keys.rows) < plan.key_rows {
            b.keys = Some(Keys::new(self.gpu, self.size[0], plan.key_rows, b.keys.take()));
        }
        let most = plan.mask_words.max(b.mask_capacity);
        let mut list_words = 0;
        for (_, action) in &mut plan.actions {
            if let Action::Draw(draw) = action
                && !draw.is_direct()
            {
                list_words = list_words.max(place_lists(draw, most) as u64);
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
        b.records.upload(device, queue, cast_slice(&plan.records));
        let segments = plan.segments.len() as u64 / SEGMENT_WORDS as u64;
        b.indirect.reserve(device, (indirect::SEGMENTS as u64 + segments * indirect::SEGMENT_WORDS as u64) * 4);
        let mut blocks: Vec<&[u8]> = Vec::new();
        blocks.extend(plan.vertex.iter().map(|(_, params)| bytes_of(params)));
        for (_, action) in &plan.actions {
            match action {
                Action::Clear(params) => blocks.push(bytes_of(params)),
                Action::Absorbed => {}
                Action::Draw(draw) => blocks.push(bytes_of(&draw.params)),
                Action::Front(front) => {
                    blocks.extend(front.vertex.iter().map(|(_, params)| bytes_of(params)));
                    blocks.push(bytes_of(&front.params));
                }
                Action::Visible(visible) => {
                    blocks.push(bytes_of(&visible.params));
                    blocks.extend(visible.bands.iter().map(bytes_of));
                }
            }
        }
        let mut bytes = vec![0u8; blocks.len() * PARAMS_STRIDE];
        for (block, to) in blocks.into_iter().zip(bytes.chunks_mut(PARAMS_STRIDE)) {
            to[..block.len()].copy_from_slice(block);
        }
        b.params.upload(device, queue, &bytes);
        Prepared { plan, on_host }
    }

    /// Uploads a batch and decides what to dispatch.
    fn prepare(&mut self, batch: &Batch) -> Prepared {
        let Gpu { device, queue, .. } = self.gpu;
        self.buffers.uniforms.upload(device, queue, cast_slice(&batch.uniforms));
        // The stipple counter runs from line to line, which the kernels' front end cannot follow.
        let prepared = if self.kernels.config.shape.host_front || runs::stippled(batch) {
            self.prepare_host(batch)
        } else {
            self.prepare_kernels(batch)
        };
        self.bind();
        prepared
    }

    /// Writes a prepared batch's commands.
    fn encode(&mut self, batch: &Batch, prepared: &Prepared, profile: &mut Option<Profile>) -> wgpu::CommandEncoder {
        let mut encoder = self.gpu.device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        let Some(bound) = &self.bound else { return encoder };
        let b = &self.buffers;
        let status = size_of::<Status>() as u64;
        encoder.clear_buffer(b.indirect.get(), indirect::FAILED as u64 * 4, Some(status));
        let mut first_action = 0;
        if let (Some((_, Action::Clear(p))), true) = (prepared.plan.actions.first(), !self.kernels.config.shape.vectors()) {
            first_action = clear_by_host(self.gpu, p, self.format, [&b.color, &b.depth]) as usize;
        }
        {
            let pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            let mut dispatcher = Dispatcher { gpu: self.gpu, kernels: &self.kernels, bound, indirect: b.indirect.get(), pass, profile };
            dispatcher.mark("start");
            dispatcher.actions(batch, &prepared.plan, first_action, self.format);
            dispatcher.mark("end");
        }
        encoder.copy_buffer_to_buffer(b.indirect.get(), indirect::FAILED as u64 * 4, &b.status, 0, status);
        encoder
    }

    fn run(&mut self, batch: Batch) {
        let start = std::time::Instant::now();
        let prepared = self.prepare(&batch);
        let mut profile = if stats_level() < 2 { None } else { Profile::new(self.gpu, true) };
        let encoder = self.encode(&batch, &prepared, &mut profile);
        match profile {
            Some(profile) => {
                let times: Vec<String> = profile.finish(self.gpu, encoder).iter().map(|t| format!("{} {:.3}", t.name, t.ms)).collect();
                eprintln!("tepui: gpu: ms: {}", times.join(", "));
            }
            None => {
                self.gpu.queue.submit([encoder.finish()]);
            }
        }
        if stats_level() > 0 {
            let host = prepared.on_host.then_some(self.host_front.triangles.len());
            stats::print(&batch, &prepared.plan, host, start.elapsed());
        }
        if prepared.on_host {
            recycle(batch);
        } else {
            let places = prepared.plan.actions.iter().map(|a| a.0).collect();
            self.pending = Some(Pending { batch, places });
        }
    }

    /// Makes every pixel of `to` the mean of its samples in `from`.
    pub fn resolve(&mut self, from: &wgpu::Buffer, to: &wgpu::Buffer, size: [u32; 2], format: SurfaceFormat) {
        let Gpu { device, queue, .. } = self.gpu;
        let params = Params { size, samples: format.samples, zero: -0.0, ..Params::default() };
        self.buffers.params.upload(device, queue, bytes_of(&params));
        let bound = self.stages_group(from, to);
        let mut encoder = device.create_command_encoder(&wgpu::CommandEncoderDescriptor::default());
        {
            let mut pass = encoder.begin_compute_pass(&wgpu::ComputePassDescriptor::default());
            pass.set_pipeline(&self.kernels.stage(self.gpu, Stage::Resolve(format.color)));
            pass.set_bind_group(0, &bound, &[0]);
            let (x, y) = grid((size[0] * size[1]).div_ceil(self.kernels.config.shape.list_lanes));
            pass.dispatch_workgroups(x, y, 1);
        }
        queue.submit([encoder.finish()]);
    }

    /// Draws a batch `frames` times, uploaded once, and returns the times of its stages on the device, frame by frame; only one time
    /// named "end", for all of them, where `stages` is false. Empty where the device has no time stamps.
    pub fn timed(&mut self, batch: &Batch, frames: usize, stages: bool) -> Vec<Vec<StageTime>> {
        // Once as always: buffers find their sizes, pipelines are built.
        if self.execute(batch.clone()).is_some() {
            return Vec::new();
        }
        self.settle();
        let prepared = self.prepare(batch);
        let mut times = Vec::new();
        // A GPU that idled clocks up first.
        let start = std::time::Instant::now();
        while start.elapsed() < WARM_UP {
            let mut profile = Profile::new(self.gpu, false);
            let encoder = self.encode(batch, &prepared, &mut profile);
            let Some(profile) = profile else { return times };
            profile.finish(self.gpu, encoder);
        }
        for _ in 0..frames {
            let mut profile = Profile::new(self.gpu, stages);
            let encoder = self.encode(batch, &prepared, &mut profile);
            let Some(profile) = profile else { break };
            times.push(profile.finish(self.gpu, encoder));
        }
        times
    }

    /// Bytes of the buffers that grow with a batch, by name.
    pub fn memory(&self) -> Vec<(&'static str, u64)> {
        let b = &self.buffers;
        let growing = [&b.uniforms, &b.vertices, &b.primitives, &b.front_records, &b.records, &b.shaded, &b.triangles, &b.planes];
        let growing =
            growing.into_iter().chain([&b.front, &b.lists, &b.params, &b.indirect, &b.queue]).map(|g| (g.label(), g.get().size()));
        growing.chain(b.keys.as_ref().map(|keys| ("keys", keys.buffer.size()))).collect()
    }
}

/// Bindings of buffers, and of the texels among them.
fn with_texels<'a>(buffers: &[&'a wgpu::Buffer], heap: &'a Heap) -> Vec<wgpu::BindingResource<'a>> {
    let mut all: Vec<_> = buffers.iter().map(|b| b.as_entire_binding()).collect();
    all.insert(TEXELS as usize, heap.resource());
    all
}

impl Keys {
    /// All ones, in place of others.
    fn new(gpu: &Gpu, columns: u32, rows: u32, before: Option<Keys>) -> Keys {
        let bytes = columns as usize * rows as usize * 8;
        let buffer = create(&gpu.device, "keys", wgpu::BufferUsages::STORAGE | wgpu::BufferUsages::COPY_DST, bytes as u64);
        gpu.queue.write_buffer(&buffer, 0, &vec![0xff; bytes]);
        Keys { buffer, rows, generation: before.map_or(1, |keys| keys.generation + 1) }
    }
}

/// Where the next block of parameters lies.
fn next(params: &mut impl Iterator<Item = u32>) -> [u32; 1] {
    [params.next().unwrap_or_default()]
}

/// The steps from a place on.
fn rest(steps: &[Step], place: Place) -> Vec<Step> {
    let mut steps = steps[place.step..].to_vec();
    if let Some(Step::Primitives { first, .. }) = steps.first_mut() {
        *first = place.primitive;
    }
    steps
}

/// Workgroups in two dimensions, as the kernels number them.
fn grid(groups: u32) -> (u32, u32) {
    (groups.clamp(1, 32768), groups.div_ceil(32768).max(1))
}

/// Writes dispatches into a pass.
struct Dispatcher<'a> {
    gpu: &'static Gpu,
    kernels: &'a Kernels,
    bound: &'a Bound,
    indirect: &'a wgpu::Buffer,
    pass: wgpu::ComputePass<'a>,
    profile: &'a mut Option<Profile>,
}

impl Dispatcher<'_> {
    /// A time stamp: what came before it was `name`.
    fn mark(&mut self, name: &'static str) {
        if let Some(p) = self.profile {
            p.mark(&mut self.pass, name);
        }
    }

    fn stage(&mut self, stage: Stage) {
        self.pass.set_pipeline(&self.kernels.stage(self.gpu, stage));
    }

    fn direct(&mut self, groups: u32, name: &'static str) {
        let (x, y) = grid(groups);
        self.pass.dispatch_workgroups(x, y, 1);
        self.mark(name);
    }

    /// Sizes from word `word` of the dispatches' buffer.
    fn indirect(&mut self, word: u32, name: &'static str) {
        self.pass.dispatch_workgroups_indirect(self.indirect, word as u64 * 4);
        self.mark(name);
    }

    /// All actions but the first `skip`. Their parameters lie one behind the other, as `Executor::upload_params` has put them.
    fn actions(&mut self, batch: &Batch, plan: &Plan, skip: usize, format: SurfaceFormat) {
        self.pass.set_bind_group(1, &self.bound.indirect, &[]);
        let mut params = (0..).step_by(PARAMS_STRIDE);
        self.vertex(batch, &plan.vertex, &mut params);
        for (k, (_, action)) in plan.actions.iter().enumerate() {
            match action {
                Action::Clear(p) => {
                    self.pass.set_bind_group(0, &self.bound.stages, &next(&mut params));
                    if k < skip {
                        continue;
                    }
                    self.stage(Stage::Clear(format.color.words() as u32));
                    let columns = (p.clear_max[0] - p.clear_min[0]) as u32;
                    let columns = columns.div_ceil(self.kernels.config.shape.list_lanes);
                    let rows = (p.clear_max[1] - p.clear_min[1]) as u32;
                    self.pass.dispatch_workgroups(columns, rows.div_ceil(CLEAR_ROWS), 1);
                    self.mark("clear");
                }
                Action::Absorbed => {}
                Action::Front(front) => {
                    self.vertex(batch, &front.vertex, &mut params);
                    self.pass.set_bind_group(0, &self.bound.front, &next(&mut params));
                    self.stage(Stage::Cull(front.features));
                    self.direct(front.params.groups, "cull");
                    self.stage(Stage::Offsets);
                    self.direct(1, "offsets");
                    self.stage(Stage::Setup(front.features));
                    self.indirect(indirect::SETUP, "set-up");
                    self.stage(Stage::Clip(front.features));
                    self.indirect(indirect::CLIP, "clip");
                }
                Action::Draw(draw) => {
                    self.pass.set_bind_group(0, &self.bound.stages, &next(&mut params));
                    self.draw(batch, draw);
                }
                Action::Visible(action) => {
                    let [surface] = next(&mut params);
                    for band in &action.bands {
                        let [band_params] = next(&mut params);
                        self.pass.set_bind_group(0, self.bound.visible.as_ref(), &[surface, band_params]);
                        self.visible(batch, action, band, plan.soup);
                    }
                }
            }
        }
    }

    /// The vertex stage for each program.
    fn vertex(&mut self, batch: &Batch, programs: &[(usize, FrontParams)], params: &mut impl Iterator<Item = u32>) {
        for (draw, p) in programs {
            self.pass.set_bind_group(0, &self.bound.front, &next(params));
            self.pass.set_pipeline(&self.kernels.vertex(self.gpu, &batch.draws[*draw].vertex_program));
            self.direct(p.vertex_blocks, "vertex");
        }
    }

    /// A band of rows of a segment by keys. `soup`: see [`Plan::soup`].
    fn visible(&mut self, batch: &Batch, action: &VisibleAction, band: &FrontParams, soup: bool) {
        let p = &action.params;
        let shape = self.kernels.config.shape;
        let offset = shape.host_front && action.key.features & feature::OFFSET != 0;
        let draw = &batch.draws[action.draw as usize];
        let soup = soup.then_some(&*draw.vertex_program);
        let (lequal, depth_bits) = (visible::is_lequal(&action.key), action.key.depth_bits);
        let offers = Offers { lequal, depth_bits, offset, soup: soup.map(|program| program.id) };
        let (gpu, kernels) = (self.gpu, self.kernels);
        let stage = |which| kernels.stage_with(gpu, Stage::Visible(which, offers), soup);
        self.pass.set_pipeline(&stage(Visible::Small));
        if shape.host_front {
            self.direct(band.primitive_count.div_ceil(shape.list_lanes), "small");
            if band.item_capacity > 0 {
                self.pass.set_pipeline(&stage(Visible::Large));
                self.direct(band.item_capacity.div_ceil(LARGE_ITEMS).min(LARGE_GROUPS), "large");
            }
        } else {
            self.direct(band.primitive_count.div_ceil(VISIBLE_LANES), "small");
            // Rounds over queues whose length the host does not know.
            self.pass.set_pipeline(&stage(Visible::Clip));
            self.direct(CLIP_GROUPS, "clip");
            self.pass.set_pipeline(&stage(Visible::Large));
            self.direct(LARGE_GROUPS, "large");
            self.pass.set_pipeline(&stage(Visible::End));
            self.direct(1, "end of keys");
        }
        self.pass.set_pipeline(&kernels.resolve(gpu, &action.key, &draw.fragment_program, soup));
        let all = p.size[0].div_ceil(8) * (band.end_row - band.first_row).div_ceil(8);
        let tiles = if shape.host_front { band.tile_count } else { all };
        self.direct(tiles.div_ceil(visible::RESOLVE_LANES / 64), "resolve");
    }

    fn draw(&mut self, batch: &Batch, action: &DrawAction) {
        let p = &action.params;
        let bins = p.bins[0] * p.bins[1];
        let fine = self.kernels.fine(self.gpu, &action.key, &batch.draws[action.draw as usize].fragment_program);
        if action.is_direct() {
            self.pass.set_pipeline(&fine);
            return self.direct(bins * 64, "fine");
        }
        let lanes = self.kernels.config.shape.list_lanes;
        let dispatch = indirect::SEGMENTS + p.segment * indirect::SEGMENT_WORDS;
        let supers = bins * action.blocks.div_ceil(32);
        let sized = |s: &mut Self, lanes_wanted: u32, word: u32, name| match action.triangles {
            Some(_) => s.direct(lanes_wanted.div_ceil(lanes), name),
            None => s.indirect(dispatch + word, name),
        };
        let several = p.samples > 1;
        self.stage(Stage::Bin(several));
        let triangles = action.triangles.unwrap_or(0);
        sized(self, triangles * if triangles < self.kernels.config.shape.few_triangles() { p.bins[1] } else { 1 }, 0, "bin");
        self.stage(Stage::Count);
        sized(self, supers, 4, "count");
        self.stage(Stage::Scan);
        self.direct(1, "scan");
        self.stage(Stage::Emit);
        sized(self, supers * emit_lanes(self.kernels.config.shape), 8, "emit");
        self.stage(Stage::Tile(several));
        self.indirect(indirect::TILE, "tile");
        if p.fresh & fresh::CLEARS == 0 {
            self.stage(Stage::Active);
            self.direct(bins, "active");
        }
        self.pass.set_pipeline(&fine);
        self.indirect(indirect::FINE, "fine");
        let shape = self.kernels.config.shape;
        let rounds = if shape.rounds() { action.blocks.div_ceil(shape.round_blocks) } else { 1 };
        for _ in 1..rounds {
            self.stage(Stage::Round);
            self.direct(1, "round");
            self.pass.set_pipeline(&fine);
            self.indirect(indirect::FINE, "fine");
        }
    }
}

/// Clears all of a surface from the host; false where the clear is not of that kind or the host cannot.
fn clear_by_host(gpu: &Gpu, p: &Params, format: SurfaceFormat, [color, depth]: [&wgpu::Buffer; 2]) -> bool {
    let whole = writes_whole(p, format);
    let patterns = [(color, &p.clear_color[..format.color.words()]), (depth, std::slice::from_ref(&p.clear_depth))];
    let wanted = whole.into_iter().zip(patterns).filter_map(|(whole, (buffer, pattern))| whole.map(|whole| (whole, buffer, pattern)));
    if !wanted.clone().all(|(whole, buffer, _)| whole && buffer.usage().contains(wgpu::BufferUsages::MAP_WRITE)) {
        return false;
    }
    wanted.for_each(|(_, buffer, pattern)| fill(gpu, buffer, pattern));
    true
}
