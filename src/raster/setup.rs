//! Set-up stage: a primitive on the screen becomes triangles with a positive area and plane equations.
//!
//! Reads the shaded vertices and their places; writes [`Triangle`]s and planes, in primitive order. The arithmetic of
//! the planes is part of the image: single precision, every operation rounded, in exactly this order.

use super::clip::{ClipVertex, Clipper, possible};
use super::filled;
use super::layout::*;
use super::simd::{Level, Simd};
use super::vertex::ScreenVertex;
use crate::draw::Batch;

/// Planes of `interpolation::COVERAGE` where a pixel is covered or not.
pub const FULL_COVERAGE: [[f32; 4]; 3] = [[0.0, 1.0, 0.0, 1.0], [0.0; 4], [0.0; 4]];

/// Everything that a batch's set-up reads, besides the primitives.
#[derive(Clone, Copy)]
pub struct SetupInput<'a> {
    /// The batch.
    pub batch: &'a Batch,
    /// Shaded vertices.
    pub shaded: &'a [[f32; 4]],
    /// Their places on the screen.
    pub screen: &'a [ScreenVertex],
    /// First [`ScreenVertex`] of each draw.
    pub screen_base: &'a [u32],
    /// Row 0 of the surface is the top row in GL's view.
    pub top_first: bool,
    /// Instructions that set-up is compiled to.
    pub level: Level,
}

/// What set-up makes of a run of primitives.
#[derive(Default)]
pub struct Chunk {
    /// Triangles, in order.
    pub triangles: Vec<Triangle>,
    /// Their planes.
    pub planes: Vec<[f32; 4]>,
    /// Bin lists, see [`super::bin`].
    pub bins: super::bin::BinLists,
    /// Primitives that were culled, were outside, or touched no sample.
    pub dropped: u32,
    /// Primitives that were clipped.
    pub clipped: u32,
    /// Line stipple counter: set before, read after a run where any line is stippled.
    pub stipple_counter: u32,
    clipper: Clipper,
}

/// A vertex as set-up sees it.
#[derive(Clone, Copy)]
pub struct Corner<'a> {
    /// Its place.
    pub screen: ScreenVertex,
    /// Clip position and attributes.
    pub shaded: &'a [[f32; 4]],
}

/// A primitive's surroundings.
#[derive(Clone, Copy)]
pub struct Context<'a> {
    /// The draw.
    pub record: &'a DrawRecord,
    /// Its state.
    pub state: &'a RasterState,
    /// Index of the draw.
    pub draw: u32,
    /// Index of the primitive.
    pub primitive: u32,
    /// Attributes of flat varyings.
    pub provoking: &'a [[f32; 4]],
    /// See [`SetupInput::top_first`].
    pub top_first: bool,
}

crate::dispatch! {
    /// [`Chunk::run`] at a level.
    fn run_at = run_kernel<'a>(chunk: &mut Chunk, input: &SetupInput<'a>, first: u32, end: u32)
}

/// The level chooses the instructions that this and all that is inlined is compiled to; it uses no vectors by name.
#[inline(always)]
#[allow(clippy::extra_unused_type_parameters)]
fn run_kernel<S: Simd>(chunk: &mut Chunk, input: &SetupInput, first: u32, end: u32) {
    let mut clipper = std::mem::take(&mut chunk.clipper);
    for (k, primitive) in input.batch.primitives[first as usize..end as usize].iter().enumerate() {
        chunk.primitive(input, primitive, first + k as u32, &mut clipper);
    }
    chunk.clipper = clipper;
}

impl Chunk {
    /// Empties it, keeping its memory.
    pub fn clear(&mut self) {
        self.triangles.clear();
        self.planes.clear();
        (self.dropped, self.clipped) = (0, 0);
    }

    /// Sets up primitives `first..end` of the batch.
    pub fn run(&mut self, input: &SetupInput, first: u32, end: u32) {
        run_at(input.level, self, input, first, end);
    }

    #[inline(always)]
    fn primitive(&mut self, input: &SetupInput, primitive: &Primitive, index: u32, clipper: &mut Clipper) {
        let draw = primitive.draw_and_flags & PRIM_DRAW_MASK;
        let record = &input.batch.draws[draw as usize].record;
        let state = &input.batch.raster_states[record.raster_state as usize];
        let (stride, base) = (record.shaded_stride as usize, record.shaded_base as usize);
        let screen = &input.screen[input.screen_base[draw as usize] as usize..];
        let corner = |k: usize| {
            let v = primitive.v[k] as usize;
            Corner { screen: screen[v], shaded: &input.shaded[base + v * stride..base + (v + 1) * stride] }
        };
        let before = self.triangles.len();
        if filled::serves(record, state) {
            let [a, b, c] = [primitive.v[0] as usize, primitive.v[1] as usize, primitive.v[2] as usize];
            let places = [&screen[a], &screen[b], &screen[c]];
            if places[0].code | places[1].code | places[2].code == 0 {
                let shaded = &input.shaded[base..];
                let [a, b, c] = [&shaded[a * stride..], &shaded[b * stride..], &shaded[c * stride..]];
                let context = Context { record, state, draw, primitive: index, provoking: c, top_first: input.top_first };
                self.filled(&context, places, [a, b, c]);
                self.dropped += (self.triangles.len() == before) as u32;
                return;
            }
        }
        let edge = |bit: u32| primitive.draw_and_flags & bit != 0;
        if primitive.draw_and_flags & PRIM_RESET_STIPPLE != 0 {
            self.stipple_counter = 0;
        }
        let mut context = Context { record, state, draw, primitive: index, provoking: &[], top_first: input.top_first };
        match record.topology {
            topology::POINTS => {
                let a = corner(0);
                context.provoking = a.shaded;
                if a.screen.code == 0 {
                    self.point(&context, &a, true);
                }
            }
            topology::LINES => {
                let (a, b) = (corner(0), corner(1));
                context.provoking = b.shaded;
                let (or, and) = (a.screen.code | b.screen.code, a.screen.code & b.screen.code);
                if or == 0 {
                    self.stippled_line(&context, &a, &b, true);
                } else if possible(or, and) {
                    self.clipped += 1;
                    clipper.begin(&[(&a.screen, a.shaded, false), (&b.screen, b.shaded, false)]);
                    if clipper.line(or, record, state) {
                        let [a, b] = [0, 1].map(|k| clipped_corner(clipper, clipper.polygon[k], stride));
                        self.stippled_line(&context, &a, &b, true);
                    }
                }
            }
            _ => {
                let (a, b, c) = (corner(0), corner(1), corner(2));
                context.provoking = c.shaded;
                let (or, and) = (a.screen.code | b.screen.code | c.screen.code, a.screen.code & b.screen.code & c.screen.code);
                if or == 0 {
                    self.polygon(&context, &[a, b, c], [edge(PRIM_EDGE_01), edge(PRIM_EDGE_12), edge(PRIM_EDGE_20)]);
                } else if possible(or, and) {
                    self.clipped += 1;
                    clipper.begin(&[
                        (&a.screen, a.shaded, edge(PRIM_EDGE_01)),
                        (&b.screen, b.shaded, edge(PRIM_EDGE_12)),
                        (&c.screen, c.shaded, edge(PRIM_EDGE_20)),
                    ]);
                    if clipper.polygon(or, record, state) {
                        let polygon = &clipper.polygon;
                        let n = polygon.len();
                        for i in 2..n {
                            let corners = [polygon[i - 1], polygon[i], polygon[0]].map(|v| clipped_corner(clipper, v, stride));
                            let edges = [polygon[i - 1].edge, i == n - 1 && polygon[i].edge, i == 2 && polygon[0].edge];
                            self.polygon(&context, &corners, edges);
                        }
                    }
                }
            }
        }
        self.dropped += (self.triangles.len() == before) as u32;
    }

    /// A triangle of a polygon: culled, filled or drawn by its outline or corners.
    #[inline(always)]
    fn polygon(&mut self, context: &Context, v: &[Corner; 3], edges: [bool; 3]) {
        let [x, y] = [0, 1].map(|k| v.map(|c| c.screen.snapped[k] as i64));
        let area = (x[0] - x[1]) * (y[2] - y[0]) - (x[2] - x[0]) * (y[0] - y[1]);
        if area == 0 {
            return;
        }
        // A positive area runs clockwise in rows that go up, counter-clockwise in rows that go down.
        let flags = context.state.flags;
        let ccw_in_gl = (area > 0) == context.top_first;
        let front = ccw_in_gl == (flags & raster_flags::FRONT_CCW != 0);
        if flags & (if front { raster_flags::CULL_FRONT } else { raster_flags::CULL_BACK }) != 0 {
            return;
        }
        match context.state.polygon_mode[!front as usize] {
            topology::TRIANGLES => {
                let v = if area > 0 { *v } else { [v[1], v[0], v[2]] };
                self.triangle(context, &v, front, triangle_flags::POLYGON, flags & raster_flags::OFFSET_FILL != 0);
            }
            topology::LINES => {
                let offset = self.offset(context, v, flags & raster_flags::OFFSET_LINE != 0);
                let v = v.map(|c| offset_corner(c, offset));
                for (edge, a, b) in [(edges[2], 2, 0), (edges[0], 0, 1), (edges[1], 1, 2)] {
                    if edge {
                        self.stippled_line(context, &v[a], &v[b], front);
                    }
                }
            }
            _ => {
                let offset = self.offset(context, v, flags & raster_flags::OFFSET_POINT != 0);
                for k in 0..3 {
                    if edges[k] {
                        self.point(context, &offset_corner(v[k], offset), front);
                    }
                }
            }
        }
    }

    fn offset(&self, context: &Context, v: &[Corner; 3], on: bool) -> f32 {
        if on { polygon_offset(context.state, v.map(|c| c.screen.position)) } else { 0.0 }
    }

    /// A filled triangle with positive area. `v[2]`'s place in the order does not matter to flat varyings.
    #[inline(always)]
    pub fn triangle(&mut self, context: &Context, v: &[Corner; 3], front: bool, mut flags: u32, offset: bool) {
        let [x, y] = [0, 1].map(|k| v.map(|c| c.screen.snapped[k]));
        let Some((columns, rows, cut)) = bounds(x, y, context.state) else { return };
        flags |= cut;
        if v.iter().any(|c| c.screen.inv_w != 1.0) {
            flags |= triangle_flags::PERSPECTIVE;
        }
        flags |= (front as u32 * triangle_flags::FRONT) | (!context.top_first as u32 * triangle_flags::BOTTOM_UP);
        let planes = self.planes.len() as u32;
        let places = v.map(|c| c.screen.position);
        let offset = if offset { polygon_offset(context.state, places) } else { 0.0 };
        let basis = Basis::new(context.state, places);
        let z = basis.plane(places.map(|p| p[2]));
        let w = basis.plane(v.map(|c| c.screen.inv_w));
        self.planes.push([z[0], z[1], z[2], w[0]]);
        self.planes.push([w[1], w[2], offset, 0.0]);
        self.varyings(context, &basis, v, front);
        self.triangles.push(Triangle { x, y, draw: context.draw, flags, columns, rows, planes, primitive: context.primitive });
    }

    /// Appends the planes of the draw's varyings.
    #[inline(always)]
    fn varyings(&mut self, context: &Context, basis: &Basis, v: &[Corner; 3], front: bool) {
        for &varying in &context.record.varyings[..context.record.varying_count as usize] {
            let at = (if front { varying } else { varying >> 8 } & 0xff) as usize;
            match varying >> 16 & 3 {
                interpolation::FLAT => self.planes.extend([context.provoking[at], [0.0; 4], [0.0; 4]]),
                interpolation::PERSPECTIVE => {
                    let mut over_w = [[0.0; 4]; 3];
                    for (to, corner) in over_w.iter_mut().zip(v) {
                        for (to, a) in to.iter_mut().zip(&corner.shaded[at]) {
                            *to = a * corner.screen.inv_w;
                        }
                    }
                    self.planes.extend(basis.plane4(over_w));
                }
                interpolation::COVERAGE => self.planes.extend(FULL_COVERAGE),
                _ => self.planes.extend(basis.plane4(v.map(|c| c.shaded[at]))),
            }
        }
    }
}

fn clipped_corner<'a>(clipper: &'a Clipper, v: ClipVertex, stride: usize) -> Corner<'a> {
    Corner { screen: v.screen, shaded: &clipper.pool[v.at..v.at + stride] }
}

fn offset_corner(mut corner: Corner, offset: f32) -> Corner {
    // Mesa's draw module offsets and clamps the vertices of what it draws by outlines or corners.
    let z = corner.screen.position[2] + offset;
    corner.screen.position[2] = if offset == 0.0 { z } else { z.clamp(0.0, 1.0) };
    corner
}

/// The step of floating-point depths at the farthest vertex (ARB_depth_buffer_float, 3.5.5); zero where there is no normal number that small.
fn float_step(z: [f32; 3]) -> f32 {
    let exponent = z[0].max(z[1]).max(z[2]).to_bits() as i32 & 0x7f80_0000;
    f32::from_bits((exponent - (23 << 23)).max(0) as u32)
}

/// The z offset of a polygon: units + factor * the greatest slope (3.5.5).
pub fn polygon_offset(state: &RasterState, p: [[f32; 3]; 3]) -> f32 {
    let d01 = [0, 1, 2].map(|k| p[0][k] - p[1][k]);
    let d20 = [0, 1, 2].map(|k| p[2][k] - p[0][k]);
    let ooa = 1.0 / (d01[0] * d20[1] - d20[0] * d01[1]);
    let dzdx = ((d01[2] * d20[1] - d20[2] * d01[1]) * ooa).abs();
    let dzdy = ((d20[2] * d01[0] - d01[2] * d20[0]) * ooa).abs();
    let slope = if dzdx > dzdy { dzdx } else { dzdy };
    let mut units = state.offset_units;
    if state.flags & raster_flags::FLOAT_DEPTH != 0 {
        units *= float_step(p.map(|p| p[2]));
    }
    let offset = units + slope * state.offset_factor;
    if offset.is_finite() { offset } else { 0.0 }
}

/// First and last column and row that a sample may lie in, packed, and what it adds to the triangle's flags: [`triangle_flags::CUT`] where
/// the scissor took some away, [`triangle_flags::MULTISAMPLE`]; `None` where there is none.
#[inline(always)]
pub fn bounds(x: [i32; 3], y: [i32; 3], state: &RasterState) -> Option<(u32, u32, u32)> {
    let multisample = state.flags & raster_flags::MULTISAMPLE != 0;
    let reach = if multisample { SAMPLE_REACH } else { [0; 2] };
    let mut cut = 0;
    let mut range = |v: [i32; 3], k: usize| {
        let first = (v[0].min(v[1]).min(v[2]) - reach[1] + 255) >> SUBPIXEL_BITS;
        let last = (v[0].max(v[1]).max(v[2]) + reach[0]) >> SUBPIXEL_BITS;
        let (low, high) = (state.scissor_min[k], state.scissor_max[k] - 1);
        if first < low || last > high {
            cut = triangle_flags::CUT;
        }
        let (first, last) = (first.max(low), last.min(high));
        (first <= last).then_some(first as u32 | (last as u32) << 16)
    };
    let (columns, rows) = (range(x, 0)?, range(y, 1)?);
    Some((columns, rows, cut | if multisample { triangle_flags::MULTISAMPLE } else { 0 }))
}

/// From a pixel's first corner, where its planes begin, to where they are evaluated for its centre: the centre is their beginning, but for
/// multisampled primitives, as OSMesa has it. Sums differ in their last bits.
#[inline(always)]
pub fn to_centre(state: &RasterState) -> f32 {
    if state.flags & raster_flags::MULTISAMPLE != 0 { 0.5 } else { 0.0 }
}

/// What all planes of a triangle share.
pub struct Basis {
    x0c: f32,
    y0c: f32,
    dx01_ooa: f32,
    dy01_ooa: f32,
    dx20_ooa: f32,
    dy20_ooa: f32,
}

impl Basis {
    /// From the unsnapped places.
    #[inline(always)]
    pub fn new(state: &RasterState, p: [[f32; 3]; 3]) -> Basis {
        let origin = 0.5 - to_centre(state);
        let (dx01, dy01) = (p[0][0] - p[1][0], p[0][1] - p[1][1]);
        let (dx20, dy20) = (p[2][0] - p[0][0], p[2][1] - p[0][1]);
        let ooa = 1.0 / (dx01 * dy20 - dx20 * dy01);
        Basis {
            x0c: p[0][0] - origin,
            y0c: p[0][1] - origin,
            dx01_ooa: dx01 * ooa,
            dy01_ooa: dy01 * ooa,
            dx20_ooa: dx20 * ooa,
            dy20_ooa: dy20 * ooa,
        }
    }

    /// a0, d/dx, d/dy of a value given at the corners.
    #[inline(always)]
    pub fn plane(&self, a: [f32; 3]) -> [f32; 3] {
        let (da01, da20) = (a[0] - a[1], a[2] - a[0]);
        let dadx = da01 * self.dy20_ooa - da20 * self.dy01_ooa;
        let dady = da20 * self.dx01_ooa - da01 * self.dx20_ooa;
        [a[0] - (dadx * self.x0c + dady * self.y0c), dadx, dady]
    }

    /// The same for four values.
    #[inline(always)]
    pub fn plane4(&self, a: [[f32; 4]; 3]) -> [[f32; 4]; 3] {
        let mut planes = [[0.0; 4]; 3];
        for c in 0..4 {
            let [a0, dx, dy] = self.plane([a[0][c], a[1][c], a[2][c]]);
            (planes[0][c], planes[1][c], planes[2][c]) = (a0, dx, dy);
        }
        planes
    }
}
