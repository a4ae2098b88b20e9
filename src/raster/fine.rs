//! Fine stage: a bin's work in order: for each triangle its coverage tile by tile, then row by row of eight pixels
//! the depth and stencil test, the colour and the write.
//!
//! Fragments of programs wait in a queue, packed lane by lane, so that one run of the lane executor serves many small
//! triangles; a queue is written out in the order in which it was filled, and before anything else is drawn.

use super::layout::*;
use super::setup::Chunk;
use super::simd::Simd;
use super::store::BinPixels;
use super::tile::{FULL, LocalEdges, rectangle_mask};
use super::{blend, clear, depth_stencil, fast};
use crate::device::{ColorFormat, SurfaceFormat};
use crate::draw::{Batch, Clear};
use crate::program::lanes::{Column, Column4, Environment, FragmentResults, GROUPS, LANES, Machine, ZERO4};
use crate::program::{Input, Program, Shortcut};

/// A piece of a batch, in order.
#[derive(Clone, Copy)]
pub enum Work<'a> {
    /// Clear a rectangle.
    Clear(&'a Clear),
    /// Draw triangles.
    Triangles(&'a Chunk),
}

/// What every bin reads.
pub struct Scene<'a> {
    /// The batch.
    pub batch: &'a Batch,
    /// How each draw is done.
    pub plans: &'a [Plan<'a>],
    /// The work, in order.
    pub work: &'a [Work<'a>],
    /// Storage.
    pub format: SurfaceFormat,
    /// Rows of the surface.
    pub height: u32,
}

/// How a draw's fragments are done: what is needed, decided once a batch.
pub struct Plan<'a> {
    /// The draw's record.
    pub record: &'a DrawRecord,
    /// Per-fragment operations.
    pub state: &'a FragmentState,
    program: &'a Program,
    /// The colour is this varying: no program runs.
    pub direct: Option<usize>,
    /// Depth and stencil are tested before the colour is known.
    pub early: bool,
    /// There is any depth or stencil test.
    pub tests: bool,
    /// Rows of the polygon stipple.
    stipple: Option<&'a [u32; 32]>,
    /// Largest depth value.
    pub depth_scale: f32,
    /// What depth is clamped to.
    pub depth_range: [f32; 2],
    constant: (i32, i32),
    write_mask: u32,
    /// Which routine of [`super::fast`] serves the draw: `fast::*`.
    pub fast: u32,
    /// Added to the stored depth before "less": 1 for LEQUAL.
    pub depth_bias: i32,
    /// Vec4 of a varying's planes that are interpolated: mode by varying.
    pub modes: [u32; MAX_VARYINGS],
}

impl<'a> Plan<'a> {
    /// For draw `index` of a batch on a surface.
    pub fn new(batch: &'a Batch, index: usize, format: SurfaceFormat) -> Plan<'a> {
        let draw = &batch.draws[index];
        let state = &batch.fragment_states[draw.record.fragment_state as usize];
        let raster = &batch.raster_states[draw.record.raster_state as usize];
        let program = &*draw.fragment_program;
        let direct = match program.shortcut {
            Shortcut::Varying(k) if (k as u32) < draw.record.varying_count => Some(k as usize),
            _ => None,
        };
        let mut write_mask = blend::mask_bits(state.color_mask);
        if format.color == ColorFormat::Rgbx8 {
            write_mask |= 0xff00_0000;
        }
        Plan {
            record: &draw.record,
            state,
            program,
            direct,
            early: state.flags & fragment_flags::ALPHA_TEST == 0 && !program.discards && !program.writes_depth,
            tests: state.flags & (fragment_flags::DEPTH_TEST | fragment_flags::STENCIL_TEST) != 0,
            stipple: batch.polygon_stipples.get(raster.polygon_stipple as usize),
            depth_scale: depth_stencil::depth_scale(format.depth),
            depth_range: raster.depth_range,
            constant: blend::constant_pairs(state),
            write_mask,
            fast: fast::choose(state, format, direct.is_some(), write_mask),
            depth_bias: (state.depth_func == compare::LEQUAL) as i32,
            modes: draw.record.varyings.map(|v| v >> 16 & 3),
        }
    }
}

impl Plan<'_> {
    /// What serves the draw, in words.
    pub fn routine(&self) -> &'static str {
        match self.fast {
            fast::DEPTH => "the depth-tested routine (colour passes through, no program)",
            fast::BLEND => "the blending routine (colour passes through, no program, no tests)",
            fast::DEPTH_BLEND => "the depth-tested blending routine (colour passes through, no program)",
            fast::COPY => "the replacing routine (colour passes through, no program, no tests)",
            _ if self.direct.is_some() => "the general routine without a program",
            _ if self.early => "the general routine with early tests and a program",
            _ => "the general routine with a program before the tests",
        }
    }
}

/// A row of eight pixels that waits for its colour.
#[derive(Clone, Copy, Default)]
struct Row {
    /// Its first pixel in the bin.
    at: u32,
    /// Pixels covered (and not yet rejected).
    mask: u32,
    /// Lane of its first covered pixel; the others follow.
    start: u32,
    /// Front-facing.
    front: bool,
    /// Quantised depth.
    z: [u32; 8],
}

/// One worker's memory.
pub struct Worker {
    machine: Machine,
    inputs: Vec<Column4>,
    results: Box<FragmentResults>,
    queue: Box<[Row; LANES * GROUPS]>,
    queued: usize,
    /// Lanes that the queued rows take.
    lanes: usize,
    /// Tiles that were fully and partly covered.
    pub tiles: [u64; 2],
}

impl Default for Worker {
    fn default() -> Self {
        Worker {
            machine: Machine::default(),
            inputs: Vec::new(),
            results: Box::new(FragmentResults { color: ZERO4, depth: [[0.0; LANES]; GROUPS], keep: [0; GROUPS] }),
            queue: Box::new([Row::default(); LANES * GROUPS]),
            queued: 0,
            lanes: 0,
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
    for work in scene.work {
        match work {
            Work::Clear(c) => {
                flush::<S>(worker, scene, current, bin);
                clear::run(c, scene.format, bin);
            }
            Work::Triangles(chunk) => {
                for &t in chunk.bins.list(index) {
                    let t = &chunk.triangles[t as usize];
                    if t.draw != current {
                        flush::<S>(worker, scene, current, bin);
                        current = t.draw;
                        let count = scene.plans[current as usize].program.inputs.len();
                        if worker.inputs.len() < count {
                            worker.inputs.resize(count, ZERO4);
                        }
                    }
                    triangle::<S>(worker, scene, t, &chunk.planes[t.planes as usize..], bin);
                }
            }
        }
    }
    flush::<S>(worker, scene, current, bin);
}

#[inline(always)]
fn triangle<S: Simd>(worker: &mut Worker, scene: &Scene, t: &Triangle, planes: &[[f32; 4]], bin: &mut BinPixels) {
    let plan = &scene.plans[t.draw as usize];
    match plan.fast {
        fast::DEPTH => tiles::<S, { fast::DEPTH }>(worker, scene, plan, t, planes, bin),
        fast::BLEND => tiles::<S, { fast::BLEND }>(worker, scene, plan, t, planes, bin),
        fast::DEPTH_BLEND => tiles::<S, { fast::DEPTH_BLEND }>(worker, scene, plan, t, planes, bin),
        fast::COPY => tiles::<S, { fast::COPY }>(worker, scene, plan, t, planes, bin),
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
    let [ox, oy] = bin.origin;
    let local = LocalEdges::new(t, ox, oy);
    let columns = ((t.columns & 0xffff) as i32 - ox, (t.columns >> 16) as i32 - ox);
    let rows = ((t.rows & 0xffff) as i32 - oy, (t.rows >> 16) as i32 - oy);
    let (tx0, tx1) = (columns.0.max(0) / 8, columns.1.min(63) / 8);
    let (ty0, ty1) = (rows.0.max(0) / 8, rows.1.min(63) / 8);
    for ty in ty0..=ty1 {
        let (first, last) = ((rows.0 - ty * 8).max(0), (rows.1 - ty * 8).min(7));
        for tx in tx0..=tx1 {
            let mut mask = local.coverage::<S>(tx * 8, ty * 8, first, last);
            if mask == 0 {
                continue;
            }
            if t.flags & triangle_flags::CUT != 0 {
                mask &= rectangle_mask(tx * 8, ty * 8, columns, rows);
            }
            if let (Some(stipple), true) = (plan.stipple, t.flags & triangle_flags::POLYGON != 0) {
                mask &= stipple_mask(stipple, scene, ox + tx * 8, oy + ty * 8);
            }
            worker.tiles[(mask != FULL) as usize] += 1;
            let tile = ((ty * 8 + tx) * 64) as usize;
            if MODE != fast::NONE {
                fast::tile::<S, MODE>(plan, t, planes, bin, tile, [ox + tx * 8, oy + ty * 8], mask);
                continue;
            }
            while mask != 0 {
                let row = mask.trailing_zeros() as i32 / 8;
                let bits = (mask >> (8 * row)) as u32 & 0xff;
                mask &= !(0xff << (8 * row));
                let place = [ox + tx * 8, oy + ty * 8 + row];
                row_of_pixels::<S>(worker, scene, plan, t, planes, bin, tile + row as usize * 8, place, bits);
            }
        }
    }
}

fn stipple_mask(stipple: &[u32; 32], scene: &Scene, x: i32, y: i32) -> u64 {
    let mut mask = 0;
    for row in 0..8 {
        let y = y + row;
        let gl_y = if scene.format.top_first { scene.height as i32 - 1 - y } else { y };
        let pattern = stipple[(gl_y & 31) as usize].reverse_bits();
        mask |= ((pattern >> (x & 31) & 0xff) as u64) << (8 * row);
    }
    mask
}

/// Lanes whose bit is set.
#[inline(always)]
pub fn lanes<S: Simd>(bits: u32) -> S::I {
    let which = S::load_u(&[1, 2, 4, 8, 16, 32, 64, 128]);
    S::eq(S::and(S::i(bits as i32), which), which)
}

/// A plane at eight pixels: fma(y, dy, fma(x, dx, a0)).
#[inline(always)]
fn at<S: Simd>(a0: f32, dx: f32, dy: f32, x: S::F, y: S::F) -> S::F {
    S::fma(y, S::f(dy), S::fma(x, S::f(dx), S::f(a0)))
}

/// Eight words from `at` on.
#[inline(always)]
pub fn row8(words: &mut [u32], at: usize) -> &mut [u32; 8] {
    (&mut words[at..at + 8]).try_into().expect("eight words")
}

#[inline(always)]
#[allow(clippy::too_many_arguments)]
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
    let x = S::add(S::f(place[0] as f32), S::load(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]));
    let y = S::f(place[1] as f32);
    let front = t.flags & triangle_flags::FRONT != 0;
    let mut mask = lanes::<S>(bits);
    let mut z = S::i(0);
    let head = (planes[0], planes[1]);
    let z_float = S::add(at::<S>(head.0[0], head.0[1], head.0[2], x, y), S::f(head.1[2]));
    if plan.tests {
        z = depth_stencil::quantize::<S>(z_float, plan.depth_range, plan.depth_scale);
        if plan.early {
            mask = depth_stencil::test::<S>(plan.state, front, z, mask, row8(bin.depth_stencil, pixel));
            if S::signs(mask) == 0 {
                return;
            }
        }
    }
    let inv_w = at::<S>(head.0[3], head.1[0], head.1[1], x, y);
    let reciprocal = if t.flags & triangle_flags::PERSPECTIVE != 0 { S::div(S::f(1.0), inv_w) } else { S::f(1.0) };
    if let Some(k) = plan.direct {
        let color = varying::<S>(plan, planes, t, k, x, y, reciprocal);
        write::<S>(plan, scene.format, bin, pixel, front, z, mask, color);
        return;
    }
    let live = S::signs(mask);
    let start = worker.lanes;
    for (input, column) in plan.program.inputs.iter().zip(&mut worker.inputs) {
        let value = match *input {
            Input::Position => [S::add(x, S::f(0.5)), S::add(y, S::f(0.5)), z_float, inv_w],
            Input::Facing => [S::f(front as u32 as f32), S::f(0.0), S::f(0.0), S::f(0.0)],
            Input::Varying(k) => varying::<S>(plan, planes, t, k as usize, x, y, reciprocal),
            Input::Quad(k, which) => {
                let qx = S::add(S::f(place[0] as f32), S::load(&[0.0, 0.0, 2.0, 2.0, 4.0, 4.0, 6.0, 6.0]));
                let qx = S::add(qx, S::f((which == 1) as u32 as f32));
                let qy = S::f(((place[1] & !1) + (which == 2) as i32) as f32);
                let r = S::div(S::f(1.0), at::<S>(head.0[3], head.1[0], head.1[1], qx, qy));
                varying::<S>(plan, planes, t, k as usize, qx, qy, r)
            }
        };
        for c in 0..4 {
            let to = &mut column[c].as_flattened_mut()[start..start + 8];
            S::store(S::compress(value[c], live), to.try_into().expect("eight"));
        }
    }
    let row = &mut worker.queue[worker.queued];
    (row.at, row.mask, row.start, row.front) = (pixel as u32, live, start as u32, front);
    S::store_u(z, &mut row.z);
    worker.queued += 1;
    worker.lanes += live.count_ones() as usize;
    // The next row stores eight lanes, whatever it covers.
    if worker.lanes > LANES * GROUPS - 8 {
        flush::<S>(worker, scene, t.draw, bin);
    }
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

/// Eight lanes of a column from any lane on.
#[inline(always)]
fn eight(column: &Column, start: usize) -> &[f32; 8] {
    column.as_flattened()[start..start + 8].try_into().expect("eight")
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
    worker.machine.run_fragment(plan.program, &env, &worker.inputs, &mut worker.results, lane_count.div_ceil(LANES));
    let results = &worker.results;
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
            z = depth_stencil::quantize::<S>(
                S::expand(S::load(eight(&results.depth, start)), row.mask),
                plan.depth_range,
                plan.depth_scale,
            );
        }
        let mut color = [S::f(0.0); 4];
        for c in 0..4 {
            color[c] = S::expand(S::load(eight(&results.color[c], start)), row.mask);
        }
        write::<S>(plan, scene.format, bin, row.at as usize, row.front, z, lanes::<S>(bits), color);
    }
}

/// The operations after the colour is known.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
fn write<S: Simd>(
    plan: &Plan,
    format: SurfaceFormat,
    bin: &mut BinPixels,
    pixel: usize,
    front: bool,
    z: S::I,
    mut mask: S::I,
    color: [S::F; 4],
) {
    let state = plan.state;
    if state.flags & fragment_flags::ALPHA_TEST != 0 {
        // In the precision of the colour buffer.
        let reference = blend::quantize::<S>(S::f(state.alpha_ref));
        mask = S::and(mask, depth_stencil::compare_lanes::<S>(state.alpha_func, blend::quantize::<S>(color[3]), reference));
    }
    if !plan.early && plan.tests {
        mask = depth_stencil::test::<S>(state, front, z, mask, row8(bin.depth_stencil, pixel));
    }
    if S::signs(mask) == 0 || plan.write_mask == 0 {
        return;
    }
    if !matches!(format.color, ColorFormat::Rgba8 | ColorFormat::Rgbx8) {
        let mut columns = [[0.0; 8]; 4];
        for c in 0..4 {
            S::store(color[c], &mut columns[c]);
        }
        super::formats::write(state, format.color, bin.color, pixel, S::signs(mask), &columns);
        return;
    }
    let pixels = row8(bin.color, pixel);
    let old = S::load_u(pixels);
    let opaque = S::i(0xff00_0000u32 as i32);
    let new = if state.flags & fragment_flags::BLEND != 0 {
        let d = if format.color == ColorFormat::Rgbx8 { S::or(old, opaque) } else { old };
        blend::pack::<S>(blend::blend::<S>(state, plan.constant, blend::quantize4::<S>(color), blend::unpack::<S>(d)))
    } else {
        let s = blend::pack::<S>(blend::quantize4::<S>(color));
        if state.flags & fragment_flags::LOGIC_OP != 0 { blend::logic_op::<S>(state.logic_op, s, old) } else { s }
    };
    let new = if format.color == ColorFormat::Rgbx8 { S::or(new, opaque) } else { new };
    let new = if plan.write_mask != !0 {
        let m = S::i(plan.write_mask as i32);
        S::or(S::and(new, m), S::andnot(m, old))
    } else {
        new
    };
    S::store_u(S::select(mask, new, old), pixels);
}
