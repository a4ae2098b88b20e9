//! The embedded CPU executor: the stages of [`crate::raster`] over the machine's cores.
//!
//! Runs of primitives are set up in parallel, each with bin lists of its own; bins are then drawn in parallel, each
//! walking the runs in order. The result does not depend on the number of threads.

use std::any::Any;
use std::cell::RefCell;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Arc, Mutex, OnceLock};

use rayon::prelude::*;

use super::cpu_textures::Unpacked;
use super::plane::{self, Resolved, Storage};
use super::{Device, Plane, PlaneFormat, SharedPlane, Surface, Target, cpu_stats, lines};
use crate::draw::{Batch, Step, recycle};
use crate::raster::fine::{Scene, Work, Worker, run_bin};
use crate::raster::layout::BIN_SIZE;
use crate::raster::plan::Plan;
use crate::raster::records::Records;
use crate::raster::runs::{self, Run};
use crate::raster::setup::{Chunk, SetupInput};
use crate::raster::simd::Level;
use crate::raster::store::{self, BinPixels, Store};
use crate::raster::texture::Prepared;
use crate::raster::vertex::{self, ScreenVertex, VertexWorker, place};

/// Most and fewest primitives in a run.
const CHUNK: [u32; 2] = [2048, 128];
/// Below this many vertices and primitives the calling thread does the work alone.
const WORTH_SHARING: u64 = 4096;

/// Below this many bytes the calling thread copies alone.
const WORTH_SHARING_COPY: usize = 1 << 18;

thread_local! {
    // A worker's memory stays with its thread. No stage runs inside another, so that a borrow is never taken twice.
    static VERTEX: RefCell<VertexWorker> = RefCell::default();
    static SETUP: RefCell<Chunk> = RefCell::default();
    static FINE: RefCell<Worker> = RefCell::default();
}

/// The CPU.
pub struct CpuDevice {
    shared: Arc<Shared>,
}

/// What the surfaces of a device share.
struct Shared {
    threads: usize,
    level: Level,
    pool: OnceLock<Option<rayon::ThreadPool>>,
    unpacked: Unpacked,
}

impl Shared {
    /// The pool, started when it is first wanted; `None` with one thread.
    fn pool(&self) -> Option<&rayon::ThreadPool> {
        if self.threads < 2 {
            return None;
        }
        self.pool
            .get_or_init(|| rayon::ThreadPoolBuilder::new().num_threads(self.threads).thread_name(|k| format!("tepui-{k}")).build().ok())
            .as_ref()
    }
}

impl Default for CpuDevice {
    fn default() -> Self {
        CpuDevice::new()
    }
}

impl CpuDevice {
    /// As the environment says: `TEPUI_THREADS`, `TEPUI_SIMD`.
    pub fn new() -> CpuDevice {
        let threads = std::env::var("TEPUI_THREADS").ok().and_then(|v| v.parse().ok()).filter(|n| (1..=1024).contains(n));
        let threads = threads.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, |n| n.get()));
        CpuDevice::with(threads, Level::from_environment())
    }

    /// With so many threads at a SIMD level.
    pub fn with(threads: usize, level: Level) -> CpuDevice {
        CpuDevice { shared: Arc::new(Shared { threads, level, pool: OnceLock::new(), unpacked: Unpacked::default() }) }
    }
}

impl Device for CpuDevice {
    fn name(&self) -> String {
        let level = if self.shared.level == Level::Avx2 { "AVX2" } else { "scalar" };
        format!("CPU, {} thread{}, {level}", self.shared.threads, if self.shared.threads == 1 { "" } else { "s" })
    }

    fn plane(&self, size: [u32; 2], samples: u32, format: PlaneFormat) -> SharedPlane {
        new_plane(size, samples, format)
    }

    fn resolve(&self, from: &SharedPlane, to: &SharedPlane) -> bool {
        if Arc::ptr_eq(from, to) {
            return false;
        }
        let [a, b] = [from, to].map(|plane| {
            let plane = plane::lock(plane);
            (plane.size, plane.format, plane.samples)
        });
        let bytes = matches!(a.1, PlaneFormat::Color(color) if color.is_bytes());
        if !bytes || (a.0, a.1) != (b.0, b.1) || a.2 == 1 || b.2 != 1 {
            return false;
        }
        resolve(from, to, self.shared.pool());
        true
    }

    fn surface_on(&self, target: Target) -> Box<dyn Surface> {
        Box::new(CpuSurface::new(self, target))
    }
}

/// Memory that is kept from batch to batch.
#[derive(Default)]
struct Scratch {
    shaded: Vec<[f32; 4]>,
    screen: Vec<ScreenVertex>,
    records: Vec<Records>,
    stipple_counter: u32,
}

/// A surface of the CPU executor.
pub struct CpuSurface {
    shared: Arc<Shared>,
    target: Target,
    resolved: Resolved,
    scratch: Scratch,
}

impl Storage for Store {
    fn read(&mut self, rows: &mut [u32]) {
        Store::read(self, rows);
    }

    fn write(&mut self, rows: &[u32]) {
        Store::write(self, rows);
    }

    fn as_any(&mut self) -> &mut dyn Any {
        self
    }
}

/// Where the rows of a row of bins go in memory.
type Band<'a> = Mutex<&'a mut [&'a mut [u8]]>;

impl CpuSurface {
    /// A surface of a device.
    pub fn new(device: &CpuDevice, target: Target) -> CpuSurface {
        CpuSurface { shared: device.shared.clone(), target, resolved: Resolved::default(), scratch: Scratch::default() }
    }

    /// Runs a batch, with a copy of the colour to memory where that is given.
    fn run(&mut self, batch: Batch, out: Option<&[Band]>) {
        let pixels = self.target.size[0] as u64 * self.target.size[1] as u64;
        let work = batch.shaded_vec4 as u64 + batch.primitives.len() as u64 + pixels / 64;
        let pool = if work > WORTH_SHARING { self.shared.pool() } else { None };
        let screen_base = shade(&batch, &mut self.scratch, self.shared.level, pool);
        draw(&batch, &self.target, &mut self.scratch, &screen_base, &self.shared, pool, out);
        recycle(batch);
    }

    /// Runs a batch whose vertices are shaded already: the stages after the vertex stage.
    pub fn execute_shaded(&mut self, batch: &Batch, shaded: Vec<[f32; 4]>) {
        let mut bases = Vec::new();
        self.scratch.screen.clear();
        for draw in &batch.draws {
            let record = &draw.record;
            let state = &batch.raster_states[record.raster_state as usize];
            bases.push(self.scratch.screen.len() as u32);
            for v in 0..record.vertex_count {
                let at = (record.shaded_base + v * record.shaded_stride) as usize;
                self.scratch.screen.push(place(&shaded[at..at + record.shaded_stride as usize], record, state));
            }
        }
        self.scratch.shaded = shaded;
        let pool = self.shared.pool();
        draw(batch, &self.target, &mut self.scratch, &bases, &self.shared, pool, None);
    }
}

impl Surface for CpuSurface {
    fn target(&self) -> &Target {
        &self.target
    }

    fn retarget(&mut self, target: Target) {
        self.target = target;
        self.resolved = Resolved::default();
    }

    fn execute(&mut self, batch: Batch) {
        self.run(batch, None);
    }

    fn execute_and_copy(&mut self, batch: Batch, out: &mut [u8], stride: usize, bottom_up: bool) {
        if self.target.format.samples > 1 {
            self.execute(batch);
            return self.copy_color(out, stride, bottom_up);
        }
        let mut lines = lines(out, stride, self.target.size[1] as usize, bottom_up);
        let bands: Vec<_> = lines.chunks_mut(BIN_SIZE as usize).map(Mutex::new).collect();
        self.run(batch, Some(&bands));
    }

    fn resolved(&mut self) -> &SharedPlane {
        let Target { size, format, .. } = self.target;
        let pool = self.shared.pool();
        let new = || new_plane(size, 1, PlaneFormat::Color(format.color));
        self.resolved.of(&self.target, new, |from, to| resolve(from, to, pool))
    }

    fn copy_color(&mut self, out: &mut [u8], stride: usize, bottom_up: bool) {
        let shared = self.shared.clone();
        let mut plane = plane::lock(self.resolved());
        let Some(store) = plane.storage::<Store>() else { return };
        let store = &*store;
        let mut lines = lines(out, stride, store.size[1] as usize, bottom_up);
        let band = |(k, lines): (usize, &mut [&mut [u8]])| store.copy_band(k as u32, lines);
        // A band is a row of bins.
        match shared.pool() {
            Some(pool) if lines.len() * stride >= WORTH_SHARING_COPY => {
                pool.install(|| lines.par_chunks_mut(BIN_SIZE as usize).enumerate().for_each(band));
            }
            _ => lines.chunks_mut(BIN_SIZE as usize).enumerate().for_each(band),
        }
    }
}

fn new_plane(size: [u32; 2], samples: u32, format: PlaneFormat) -> SharedPlane {
    Plane::new(size, samples, format, Box::new(Store::new(size, samples, format)))
}

/// Makes every pixel of `to` the mean of its samples in `from`.
fn resolve(from: &SharedPlane, to: &SharedPlane, pool: Option<&rayon::ThreadPool>) {
    let (mut from, mut to) = (plane::lock(from), plane::lock(to));
    let (Some(from), Some(to)) = (from.storage::<Store>(), to.storage_mut::<Store>()) else { return };
    let format = to.format;
    let bins: Vec<_> = to.resolve_bins(from).collect();
    let one = |(bin, samples): (&mut [u32], &[u32])| store::resolve(format, bin, samples);
    match pool {
        Some(pool) if bins.len() > 1 => pool.install(|| bins.into_par_iter().for_each(one)),
        _ => bins.into_iter().for_each(one),
    }
}

/// Shades all vertices of a batch. Returns the first [`ScreenVertex`] of each draw.
fn shade(batch: &Batch, scratch: &mut Scratch, level: Level, pool: Option<&rayon::ThreadPool>) -> Vec<u32> {
    let (bases, blocks) = vertex::blocks(batch, &mut scratch.shaded, &mut scratch.screen);
    match pool {
        Some(pool) if blocks.len() > 4 => pool.install(|| {
            let shade = |block| VERTEX.with_borrow_mut(|w| w.block(batch, block, level));
            blocks.into_par_iter().with_min_len(4).with_max_len(16).for_each(shade);
        }),
        _ => VERTEX.with_borrow_mut(|w| blocks.into_iter().for_each(|block| w.block(batch, block, level))),
    }
    bases
}

/// The stages after the vertex stage. Of a target of one sample a pixel, each bin is copied to `out` when it is drawn: it is in the
/// cache then.
fn draw(
    batch: &Batch,
    target: &Target,
    scratch: &mut Scratch,
    screen_base: &[u32],
    shared: &Shared,
    pool: Option<&rayon::ThreadPool>,
    out: Option<&[Band]>,
) {
    let (format, level) = (target.format, shared.level);
    // Enough runs for all threads to have work until the end.
    let threads = pool.map_or(1, |p| p.current_num_threads());
    let chunk = (batch.primitives.len() as u32 / (4 * threads as u32)).clamp(CHUNK[1], CHUNK[0]);
    let runs = runs::cut(batch, chunk);
    let Scratch { shaded, screen, records, stipple_counter } = scratch;
    let input = SetupInput { batch, shaded, screen, screen_base, top_first: format.top_first, level };
    let bins = target.size.map(|n| n.div_ceil(BIN_SIZE));
    let one = |run: &Run, records: &mut Records, counter: u32| {
        SETUP.with_borrow_mut(|chunk| {
            let counter = runs::set_up(run, chunk, &input, counter);
            chunk.bins.run(&chunk.triangles, bins[0], bins[1]);
            records.gather(batch, chunk);
            counter
        })
    };
    match pool {
        Some(pool) if runs.len() > 1 => pool.install(|| runs::each(&runs, records, batch, stipple_counter, true, one)),
        _ => runs::each(&runs, records, batch, stipple_counter, false, one),
    }
    let mut work = Vec::with_capacity(runs.len() + batch.steps.len());
    let mut next = 0;
    for (k, step) in batch.steps.iter().enumerate() {
        if let Step::Clear(clear) = step {
            work.push(Work::Clear(clear));
        }
        while next < runs.len() && runs[next].step == k {
            work.push(Work::Triangles(&records[next]));
            next += 1;
        }
    }
    let plans: Vec<Plan> = (0..batch.draws.len()).map(|k| Plan::new(batch, k, format)).collect();
    let cells = if level == Level::Avx2 { shared.unpacked.of(batch) } else { Vec::new() };
    let cells_of = |k: usize| cells.get(k).and_then(Option::as_deref);
    let textures: Vec<_> = batch.textures.iter().enumerate().map(|(k, t)| Prepared::new(t, cells_of(k))).collect();
    let scene = Scene { batch, plans: &plans, work: &work, textures: &textures, format, height: target.size[1] };
    let mut color = plane::lock(&target.color);
    let mut depth = target.depth.as_ref().map(plane::lock);
    let Some(color) = color.storage_mut::<Store>() else { return };
    let tiles = [AtomicU64::new(0), AtomicU64::new(0)];
    let columns = bins[0] as usize;
    let bins = store::split(color, depth.as_mut().and_then(|plane| plane.storage_mut::<Store>()));
    let fine = |(k, mut bin): (usize, BinPixels)| {
        FINE.with_borrow_mut(|worker| {
            worker.tiles = [0; 2];
            run_bin(level, worker, &scene, k, &mut bin);
            if let Some(bands) = out {
                let (row, column) = (k / columns, k % columns);
                let mut band = bands[row].lock().unwrap_or_else(|poisoned| poisoned.into_inner());
                store::copy_bin(bin.color, PlaneFormat::Color(format.color), target.size[0], column, &mut band);
            }
            (0..2).for_each(|k| _ = tiles[k].fetch_add(worker.tiles[k], Ordering::Relaxed));
        });
    };
    match pool {
        // One by one: some bins hold most of the work.
        Some(pool) if bins.len() > 1 => pool.install(|| bins.into_par_iter().enumerate().with_max_len(1).for_each(fine)),
        _ => bins.into_iter().enumerate().for_each(fine),
    }
    if cpu_stats::wanted() {
        cpu_stats::print(batch, &plans, &work, tiles.map(AtomicU64::into_inner), threads);
    }
}
