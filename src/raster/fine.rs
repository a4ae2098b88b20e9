//! Fine stage: a bin's work in order: for each triangle its coverage tile by tile, then row by row of eight pixels
//! the depth and stencil test, the colour and the write ([`super::write`]).
//!
//! Fragments of programs wait in a queue, packed lane by lane, so that one run of the lane executor serves many small
//! triangles; a queue is written out in the order in which it was filled, and before anything else is drawn.

use super::hi_z::HiZ;
use super::interpolate::Interpolator;
use super::layout::*;
use super::modulate::{Colors, Fragments, Source};
use super::plan::Plan;
use super::records::{self, Records, TRIANGLE_VEC4};
use super::simd::{Simd, columns_from, eight, prefetch};
use super::store::BinPixels;
use super::texture::Prepared;
use super::tile::{FULL, LocalEdges};
use super::walk::Walk;
use super::write::{Color, write};
use super::{blend, clear, depth_stencil, fast, modulate, samples, small, textured};
use crate::device::SurfaceFormat;
use crate::device::samples::MAX_SAMPLES;
use crate::draw::{Batch, Clear};
use crate::program::lanes::{Column4, Environment, FragmentResults, GROUPS, LANES, Machine, ZERO4};

/// A piece of a batch, in order.
#[derive(Clone, Copy)]
pub enum Work<'a> {
    /// Clear a rectangle.
    Clear(&'a Clear),
    /// Draw triangles.
    Triangles(&'a Records),
}

/// What every bin reads.
pub struct Scene<'a> {
    /// The batch.
    pub batch: &'a Batch,
    /// How each draw is done.
    pub plans: &'a [Plan<'a>],
    /// The work, in order.
    pub work: &'a [Work<'a>],
    /// The batch's textures.
    pub textures: &'a [Prepared<'a>],
    /// Storage.
    pub format: SurfaceFormat,
    /// Rows of the surface.
    pub height: u32,
}

/// A row of eight pixels that waits for its colour.
#[derive(Clone, Copy, Default)]
pub struct Row {
    /// Its first pixel in the bin.
    pub at: u32,
    /// Pixels covered (and not yet rejected).
    pub mask: u32,
    /// Lane of its first covered pixel; the others follow, up to `end`.
    pub start: u32,
    /// See `start`.
    pub end: u32,
    /// Its first pixel on the surface.
    pub place: [i32; 2],
    /// Index of the work that its triangle belongs to.
    pub work: u32,
    /// First of the triangle's planes.
    pub planes: u32,
    /// Front-facing.
    pub front: bool,
    /// [`triangle_flags::PERSPECTIVE`]
    pub perspective: bool,
    /// Words of depth; of samples it is worked out when it is wanted.
    pub z: [u32; 8],
    /// Pixels of which each sample is covered, on a surface with samples.
    pub samples: [u8; MAX_SAMPLES as usize],
}

impl<'a> Scene<'a> {
    /// The first texture of a draw.
    #[inline(always)]
    pub fn texture(&self, plan: &Plan) -> Option<&'a Prepared<'a>> {
        self.textures.get(plan.record.first_texture as usize)
    }

    /// The planes of a triangle of a work, by its first.
    #[inline(always)]
    pub fn planes(&self, work: u32, first: u32) -> &[[f32; 4]] {
        match self.work[work as usize] {
            Work::Triangles(records) => records.planes(first),
            Work::Clear(_) => &[],
        }
    }
}

/// One worker's memory.
pub struct Worker {
    machine: Machine,
    interpolator: Interpolator,
    /// Index of the work that is done.
    work: u32,
    inputs: Vec<Column4>,
    results: Box<FragmentResults>,
    /// Colours of the fragments, where they are bytes.
    bytes: [u32; LANES * GROUPS],
    queue: Box<[Row; LANES * GROUPS]>,
    queued: usize,
    /// Lanes that the queued rows take.
    lanes: usize,
    /// Fragments of one modulated texture.
    fragments: Box<Fragments>,
    /// The farthest depths of the bin.
    pub hi_z: HiZ,
    /// Tiles that were fully and partly covered; a small triangle is one of these.
    pub tiles: [u64; 2],
}

impl Default for Worker {
    fn default() -> Self {
        Worker {
            machine: Machine::default(),
            interpolator: Interpolator::default(),
            work: 0,
            inputs: Vec::new(),
            results: Box::new(FragmentResults { color: ZERO4, depth: [[0.0; LANES]; GROUPS], keep: [0; GROUPS] }),
            bytes: [0; LANES * GROUPS],
            queue: Box::new([Row::default(); LANES * GROUPS]),
            queued: 0,
            lanes: 0,
            fragments: Box::default(),
            hi_z: HiZ::default(),
            tiles: [0; 2],
        }
    }
}

crate::dispatch! {
    /// Does all the work of a bin.
    pub fn run_bin = bin_kernel<'a, 'b>(worker: &mut Worker, scene: &Scene<'a>, index: usize, bin: &mut BinPixels<'b>)
}

#[inline(always)]
fn bin_kernel<S: Simd>(worker: &mut Worker, scene: &Scene, index: usize, bin: &mut BinPixels) {
    let mut current = NONE;
    worker.hi_z.forget();
    for (index_of_work, work) in scene.work.iter().enumerate() {
        worker.work = index_of_work as u32;
        match work {
            Work::Clear(c) => {
                flush::<S>(worker, scene, current, bin);
                let whole = clear::run(c, scene.format, bin);
                match c.depth {
                    Some(depth) if whole && !scene.format.depth.is_float() => worker.hi_z.cleared(scene.format.depth.word(depth)),
                    Some(_) => worker.hi_z.forget(),
                    None => {}
                }
            }
            Work::Triangles(records) => {
                if let Some(Work::Triangles(later)) = scene.work.get(index_of_work + 4) {
                    later.prefetch_list(index);
                }
                if let Some(Work::Triangles(next)) = scene.work.get(index_of_work + 1) {
                    prefetch_records(next.list(index));
                }
                let mut list = records.list(index);
                while !list.is_empty() {
                    if let Some(soon) = list.get(AHEAD) {
                        prefetch(soon);
                    }
                    let t = records::triangle(list);
                    if t.draw != current {
                        flush::<S>(worker, scene, current, bin);
                        current = t.draw;
                        let plan = &scene.plans[current as usize];
                        if plan.farther {
                            worker.hi_z.forget();
                        }
                        if plan.direct.is_none() && plan.modulate.is_none() {
                            worker.interpolator.prepare(plan);
                        }
                        let count = plan.inputs().len();
                        if worker.inputs.len() < count {
                            worker.inputs.resize(count, ZERO4);
                        }
                    }
                    let (this, rest) = list.split_at(records::size(scene.plans[current as usize].record));
                    triangle::<S>(worker, scene, t, &this[TRIANGLE_VEC4..], bin);
                    list = rest;
                }
            }
        }
    }
    flush::<S>(worker, scene, current, bin);
}

/// vec4 from a record to what is asked for meanwhile: some four triangles of one varying.
const AHEAD: usize = 32;

/// Asks for the first records of a list.
#[inline(always)]
fn prefetch_records(list: &[[f32; 4]]) {
    list.iter().step_by(4).take(AHEAD / 4).for_each(prefetch);
}

#[inline(always)]
fn triangle<S: Simd>(worker: &mut Worker, scene: &Scene, t: &Triangle, planes: &[[f32; 4]], bin: &mut BinPixels) {
    let plan = &scene.plans[t.draw as usize];
    if scene.format.samples > 1 {
        return samples::tiles::<S>(worker, scene, plan, t, planes, bin);
    }
    match plan.fast {
        fast::DEPTH => tiles::<S, { fast::DEPTH }>(worker, scene, plan, t, planes, bin),
        fast::BLEND => tiles::<S, { fast::BLEND }>(worker, scene, plan, t, planes, bin),
        fast::DEPTH_BLEND => tiles::<S, { fast::DEPTH_BLEND }>(worker, scene, plan, t, planes, bin),
        fast::COPY => tiles::<S, { fast::COPY }>(worker, scene, plan, t, planes, bin),
        fast::TEXTURED_DEPTH => tiles::<S, { fast::TEXTURED_DEPTH }>(worker, scene, plan, t, planes, bin),
        fast::TEXTURED_COPY => tiles::<S, { fast::TEXTURED_COPY }>(worker, scene, plan, t, planes, bin),
        _ => tiles::<S, { fast::NONE }>(worker, scene, plan, t, planes, bin),
    }
}

/// Walks the tiles of a triangle in a bin; `MODE` is the plan's `fast`.
#[inline(always)]
fn tiles<S: Simd, const MODE: u32>(
    worker: &mut Worker,
    scene: &Scene,
    plan: &Plan,
    t: &Triangle,
    planes: &[[f32; 4]],
    bin: &mut BinPixels,
) {
    if MODE != fast::NONE && MODE & fast::TEXTURE == 0 && small::fits(plan, t) {
        worker.tiles[1] += small::draw::<S, MODE>(plan, t, planes, bin) as u64;
        return;
    }
    let [ox, oy] = bin.origin;
    let local = LocalEdges::<S>::new(t, ox, oy);
    let source = Source { work: worker.work, planes: t.planes, perspective: t.flags & triangle_flags::PERSPECTIVE != 0 };
    // Textured meshes hide little of themselves: with one sample a pixel only their large triangles are worth the look.
    let large = |span: u32| (span >> 16) - (span & 0xffff) >= 4 * TILE_SIZE;
    let worth = MODE == fast::NONE || MODE & fast::DEPTH != 0 && (MODE & fast::TEXTURE == 0 || large(t.columns) && large(t.rows));
    let mut walk = Walk::<S>::new(plan, t, planes, bin, worth && plan.hi_z);
    while let Some(spot) = walk.next(plan, planes, &mut worker.hi_z, bin) {
        let [first, last] = spot.rows;
        // Rows of a quad go together where there is a texture.
        let from = if MODE & fast::TEXTURE != 0 { first & !1 } else { first };
        let Some(edges) = local.rows(spot.offset(), from) else { continue };
        let allowed = walk.allowed(scene, plan, t, spot);
        let full = edges.full && allowed == FULL;
        if full {
            bin.prefetch_next(spot.pixel());
        }
        if MODE != fast::NONE {
            let tile = fast::Tile { at: spot.pixel(), place: spot.place(bin), edges, rows: spot.rows, allowed };
            let written = if MODE & fast::TEXTURE != 0 {
                textured::tile::<S, MODE>(&mut worker.fragments, scene, plan, t.draw, source, planes, bin, tile)
            } else {
                fast::tile::<S, MODE>(plan, t, planes, bin, tile)
            };
            if let Some(rows) = written {
                worker.tiles[!full as usize] += 1;
                worker.hi_z.wrote(spot.index(), rows * TILE_SIZE);
            }
            continue;
        }
        let mut mask = edges.mask(first, last) & allowed;
        worker.tiles[!full as usize] += (mask != 0) as u64;
        worker.hi_z.wrote(spot.index(), mask.count_ones());
        let [x, y] = spot.place(bin);
        while mask != 0 {
            let row = mask.trailing_zeros() as i32 / 8;
            let bits = (mask >> (8 * row)) as u32 & 0xff;
            mask &= !(0xff << (8 * row));
            row_of_pixels::<S>(worker, scene, plan, t, planes, bin, spot.pixel() + row as usize * 8, [x, y + row], bits);
        }
    }
}

/// A plane at eight pixels: fma(y, dy, fma(x, dx, a0)).
#[inline(always)]
pub fn at<S: Simd>(a0: f32, dx: f32, dy: f32, x: S::F, y: S::F) -> S::F {
    S::fma(y, S::f(dy), S::fma(x, S::f(dx), S::f(a0)))
}

/// The words of depth of a triangle at eight places.
#[inline(always)]
pub fn depth<S: Simd>(plan: &Plan, planes: &[[f32; 4]], x: S::F, y: S::F) -> S::I {
    let (head, tail) = (planes[0], planes[1]);
    let z = S::add(at::<S>(head[0], head[1], head[2], x, y), S::f(tail[2]));
    depth_stencil::word::<S>(plan, z)
}

/// Eight words from `at` on.
#[inline(always)]
pub fn row8(words: &mut [u32], at: usize) -> &mut [u32; 8] {
    (&mut words[at..at + 8]).try_into().expect("eight words")
}

#[inline(always)]
fn row_of_pixels<S: Simd>(
    worker: &mut Worker,
    scene: &Scene,
    plan: &Plan,
    t: &Triangle,
    planes: &[[f32; 4]],
    bin: &mut BinPixels,
    pixel: usize,
    place: [i32; 2],
    bits: u32,
) {
    let x = columns_from::<S>(place[0] as f32);
    let y = S::f(place[1] as f32);
    let front = t.flags & triangle_flags::FRONT != 0;
    let mut mask = S::mask(bits);
    let mut z = S::i(0);
    if plan.tests {
        z = depth::<S>(plan, planes, x, y);
        if plan.early {
            mask = depth_stencil::test::<S>(plan, front, z, mask, row8(bin.depth_stencil, pixel));
            if S::signs(mask) == 0 {
                return;
            }
        }
    }
    if let Some(k) = plan.direct {
        let color = direct_color::<S>(scene, plan, t, planes, k, x, y);
        write::<S>(plan, scene.format, bin, pixel, front, z, mask, color);
        return;
    }
    let mut row = Row { at: pixel as u32, mask: S::signs(mask), place, ..Row::default() };
    S::store_u(z, &mut row.z);
    queue::<S>(worker, scene, t, bin, row);
}

/// Lets a row wait for its colour. `row` says which pixels it has.
#[inline(always)]
pub fn queue<S: Simd>(worker: &mut Worker, scene: &Scene, t: &Triangle, bin: &mut BinPixels, row: Row) {
    let perspective = t.flags & triangle_flags::PERSPECTIVE != 0;
    let (start, end) = (worker.lanes as u32, worker.lanes as u32 + row.mask.count_ones());
    let front = t.flags & triangle_flags::FRONT != 0;
    worker.queue[worker.queued] = Row { start, end, work: worker.work, planes: t.planes, front, perspective, ..row };
    worker.queued += 1;
    worker.lanes = end as usize;
    // The next row may hold eight fragments.
    if worker.lanes > LANES * GROUPS - 8 {
        flush::<S>(worker, scene, t.draw, bin);
    }
}

/// The colour of eight pixels, where it is a varying.
#[inline(always)]
pub fn direct_color<S: Simd>(scene: &Scene, plan: &Plan, t: &Triangle, planes: &[[f32; 4]], k: usize, x: S::F, y: S::F) -> Color<S> {
    let mut reciprocal = S::f(1.0);
    if t.flags & triangle_flags::PERSPECTIVE != 0 {
        reciprocal = S::div(reciprocal, at::<S>(planes[0][3], planes[1][0], planes[1][1], x, y));
    }
    let columns = varying::<S>(plan, planes, t, k, x, y, reciprocal);
    Color { bytes: if scene.format.color.is_bytes() { blend::quantize4::<S>(columns) } else { S::i(0) }, columns }
}

/// Varying `k` at eight pixels.
#[inline(always)]
fn varying<S: Simd>(plan: &Plan, planes: &[[f32; 4]], t: &Triangle, k: usize, x: S::F, y: S::F, reciprocal: S::F) -> [S::F; 4] {
    let base = (DEPTH_PLANE_VEC4 + k as u32 * VARYING_PLANE_VEC4) as usize;
    let p: &[[f32; 4]; 3] = planes[base..base + 3].try_into().expect("three");
    if plan.modes[k] == interpolation::FLAT {
        return [S::f(p[0][0]), S::f(p[0][1]), S::f(p[0][2]), S::f(p[0][3])];
    }
    let mut value = [S::f(0.0); 4];
    for c in 0..4 {
        value[c] = at::<S>(p[0][c], p[1][c], p[2][c], x, y);
    }
    if plan.modes[k] == interpolation::PERSPECTIVE && t.flags & triangle_flags::PERSPECTIVE != 0 {
        for v in &mut value {
            *v = S::mul(*v, reciprocal);
        }
    }
    value
}

/// The low bits of `dense`, in order, at the places of the set bits of `mask`.
#[inline(always)]
fn spread(mut dense: u64, mask: u32) -> u32 {
    let (mut left, mut bits) = (mask, 0);
    while left != 0 {
        bits |= (left & left.wrapping_neg()) * (dense & 1) as u32;
        left &= left - 1;
        dense >>= 1;
    }
    bits
}

crate::dispatch! {
    /// [`flush_kernel`] at a level: one copy of it for all its callers.
    fn flush_at = flush_kernel<'a, 'b>(worker: &mut Worker, scene: &Scene<'a>, draw: u32, bin: &mut BinPixels<'b>)
}

/// Runs and writes what is queued.
#[inline(always)]
fn flush<S: Simd>(worker: &mut Worker, scene: &Scene, draw: u32, bin: &mut BinPixels) {
    textured::flush::<S>(&mut worker.fragments, scene, draw, bin);
    if worker.queued != 0 {
        flush_at(S::LEVEL, worker, scene, draw, bin);
    }
}

/// Runs the queued fragments' program and writes them, in order. Inlined, as all that is generic over `S`: only inside a function
/// of the dispatched level do the intrinsics become instructions, and closures for `map` are not inside.
#[inline(always)]
fn flush_kernel<S: Simd>(worker: &mut Worker, scene: &Scene, draw: u32, bin: &mut BinPixels) {
    let count = std::mem::take(&mut worker.queued);
    let lane_count = std::mem::take(&mut worker.lanes);
    if count == 0 {
        return;
    }
    let plan = &scene.plans[draw as usize];
    let first = (plan.record.first_texture as usize).min(scene.batch.textures.len());
    let env =
        Environment { uniforms: &scene.batch.uniforms, base: plan.record.fragment_uniforms, textures: &scene.batch.textures[first..] };
    let rows = &worker.queue[..count];
    let groups = lane_count.div_ceil(LANES);
    match (plan.modulate, scene.texture(plan)) {
        (Some(what), Some(texture)) => {
            let fragments = &mut worker.fragments;
            for row in rows {
                let source = Source { work: row.work, planes: row.planes, perspective: row.perspective };
                fragments.push::<S>(source, row.at & !8, row.mask << (row.at & 8), what.lod);
            }
            let color = Colors::Columns(&mut worker.results.color);
            modulate::run::<S>(scene, plan, what, texture, fragments, bin.origin, color);
            fragments.clear();
        }
        _ => {
            worker.interpolator.run::<S>(scene, plan, rows, lane_count, &mut worker.inputs);
            worker.machine.run_fragment(plan.program, &env, &worker.inputs, &mut worker.results, groups);
        }
    }
    let results = &worker.results;
    if scene.format.color.is_bytes() {
        // While they are packed: rows of small triangles are mostly empty.
        for group in 0..groups {
            let [r, g, b, a] = &results.color;
            let color = [S::load(&r[group]), S::load(&g[group]), S::load(&b[group]), S::load(&a[group])];
            let bytes = &mut worker.bytes[group * LANES..][..LANES];
            S::store_u(blend::quantize4::<S>(color), bytes.try_into().expect("eight"));
        }
    }
    let keep = u64::from_le_bytes(results.keep);
    for row in &worker.queue[..count] {
        let start = row.start as usize;
        let mut bits = row.mask;
        if plan.program.discards {
            bits = spread(keep >> start, bits);
        }
        if bits == 0 {
            continue;
        }
        let mut z = S::load_u(&row.z);
        if plan.program.writes_depth && plan.tests {
            let depths = S::load(eight(results.depth.as_flattened(), start));
            z = depth_stencil::word::<S>(plan, S::from_bits(S::expand(S::bits(depths), row.mask)));
        }
        let pixel = row.at as usize;
        let mut color = Color { bytes: S::i(0), columns: [S::f(0.0); 4] };
        if scene.format.color.is_bytes() {
            color.bytes = S::expand(S::load_u(eight(&worker.bytes, start)), row.mask);
        } else {
            for c in 0..4 {
                let column = S::load(eight(results.color[c].as_flattened(), start));
                color.columns[c] = S::from_bits(S::expand(S::bits(column), row.mask));
            }
        }
        if scene.format.samples > 1 {
            let place = samples::Place { pixel, place: row.place, front: row.front };
            let computed = plan.program.writes_depth.then_some(z);
            let covered = row.samples.map(|s| s & bits as u8);
            samples::write::<S>(plan, scene, scene.planes(row.work, row.planes), bin, place, covered, color, computed);
        } else {
            write::<S>(plan, scene.format, bin, pixel, row.front, z, S::mask(bits), color);
        }
    }
}
