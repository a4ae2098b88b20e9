//! The ways to find a triangle's samples. All look at the same integer edge functions, so that they find the same ones.

use super::Method;
use super::image::{Dest, Flat, Rows, Shared};
use super::shade::Shader;
use crate::raster::layout::*;
use crate::raster::setup::Chunk;
use crate::raster::simd::Simd;
use crate::raster::tile::Edges;

/// What is to be drawn where.
#[derive(Clone, Copy)]
pub struct Job<'a> {
    /// How.
    pub method: Method,
    /// The triangles.
    pub chunks: &'a [Chunk],
    /// Only those in the lists of this bin.
    pub bin: Option<usize>,
    /// Depth LESS.
    pub depth: bool,
    /// First column and row, last column and row.
    pub region: [i32; 4],
}

crate::dispatch! {
    /// On one piece of memory.
    pub fn draw_flat = flat_kernel<'a, 'b>(job: &Job<'a>, dest: &mut Flat<'b>)
}
crate::dispatch! {
    /// On a bin of a linear image.
    pub fn draw_rows = rows_kernel<'a, 'b>(job: &Job<'a>, dest: &mut Rows<'b>)
}
crate::dispatch! {
    /// Beside other threads.
    pub fn draw_shared = shared_kernel<'a, 'b>(job: &Job<'a>, dest: &mut Shared<'b>)
}

#[inline(always)]
fn flat_kernel<S: Simd>(job: &Job, dest: &mut Flat) {
    draw::<S, _>(job, dest);
}

#[inline(always)]
fn rows_kernel<S: Simd>(job: &Job, dest: &mut Rows) {
    draw::<S, _>(job, dest);
}

#[inline(always)]
fn shared_kernel<S: Simd>(job: &Job, dest: &mut Shared) {
    draw::<S, _>(job, dest);
}

/// A triangle's edges and the rectangle in which it is drawn.
struct Part {
    edges: Edges,
    x: [i32; 2],
    y: [i32; 2],
}

impl Part {
    #[inline(always)]
    fn new(t: &Triangle, region: [i32; 4]) -> Part {
        let range = |packed: u32, low: i32, high: i32| [((packed & 0xffff) as i32).max(low), ((packed >> 16) as i32).min(high)];
        Part { edges: Edges::new(t), x: range(t.columns, region[0], region[2]), y: range(t.rows, region[1], region[3]) }
    }

    /// Values of the edge functions at a pixel.
    #[inline(always)]
    fn at(&self, x: i32, y: i32) -> [i64; 3] {
        let mut v = [0; 3];
        for i in 0..3 {
            v[i] = self.edges.c[i] + self.edges.a[i] as i64 * x as i64 + self.edges.b[i] as i64 * y as i64;
        }
        v
    }
}

#[inline(always)]
fn draw<S: Simd, D: Dest>(job: &Job, dest: &mut D) {
    for chunk in job.chunks {
        match job.bin {
            Some(bin) => {
                for &index in chunk.bins.list(bin) {
                    one::<S, D>(job, &chunk.triangles[index as usize], &chunk.planes, dest);
                }
            }
            None => {
                for triangle in &chunk.triangles {
                    one::<S, D>(job, triangle, &chunk.planes, dest);
                }
            }
        }
    }
}

#[inline(always)]
fn one<S: Simd, D: Dest>(job: &Job, triangle: &Triangle, planes: &[[f32; 4]], dest: &mut D) {
    let part = Part::new(triangle, job.region);
    let shader = Shader::new(triangle, planes, job.depth);
    match job.method {
        Method::HalfSpace => half_space(&part, &shader, dest),
        Method::Blocked(4) => blocked::<S, D, 4, false>(&part, &shader, dest),
        Method::Blocked(16) => blocked::<S, D, 16, false>(&part, &shader, dest),
        Method::Blocked(32) => blocked::<S, D, 32, false>(&part, &shader, dest),
        Method::Blocked(_) => blocked::<S, D, 8, false>(&part, &shader, dest),
        Method::Combined => blocked::<S, D, 8, true>(&part, &shader, dest),
        Method::BySize if (part.x[1] - part.x[0] + 1) * (part.y[1] - part.y[0] + 1) <= 16 => half_space(&part, &shader, dest),
        Method::BySize => blocked::<S, D, 8, false>(&part, &shader, dest),
        Method::Scanline => scanline::<S, D>(&part, &shader, dest),
    }
}

#[inline(always)]
fn half_space<D: Dest>(part: &Part, shader: &Shader, dest: &mut D) {
    let mut row = part.at(part.x[0], part.y[0]);
    for y in part.y[0]..=part.y[1] {
        let mut v = row;
        for x in part.x[0]..=part.x[1] {
            if v[0] | v[1] | v[2] >= 0 {
                dest.pixel(shader, x & !7, y, (x & 7) as usize);
            }
            for i in 0..3 {
                v[i] += part.edges.a[i] as i64;
            }
        }
        for i in 0..3 {
            row[i] += part.edges.b[i] as i64;
        }
    }
}

/// Bits of the columns `first..=last` in the group at x.
#[inline(always)]
fn column_mask(x: i32, first: i32, last: i32) -> u32 {
    (0xff << (first - x).clamp(0, 8)) & (0xff >> (7 - (last - x)).clamp(0, 8)) & 0xff
}

#[inline(always)]
fn blocked<S: Simd, D: Dest, const SIDE: i32, const PIXEL_BY_PIXEL: bool>(part: &Part, shader: &Shader, dest: &mut D) {
    let Edges { a, b, .. } = part.edges;
    for top in (part.y[0] / SIDE..=part.y[1] / SIDE).map(|k| k * SIDE) {
        for left in (part.x[0] / SIDE..=part.x[1] / SIDE).map(|k| k * SIDE) {
            let v = part.at(left, top);
            let (mut most, mut least) = (0i64, 0i64);
            for i in 0..3 {
                let (a, b, reach) = (a[i] as i64, b[i] as i64, SIDE as i64 - 1);
                most |= v[i] + reach * (a.max(0) + b.max(0));
                least |= v[i] + reach * (a.min(0) + b.min(0));
            }
            if most < 0 {
                continue;
            }
            let columns = [left.max(part.x[0]), (left + SIDE - 1).min(part.x[1])];
            let rows = [top.max(part.y[0]), (top + SIDE - 1).min(part.y[1])];
            if least >= 0 {
                full_block::<S, D>(shader, columns, rows, dest);
            } else {
                partial_block::<S, D, PIXEL_BY_PIXEL>(part, shader, columns, rows, dest);
            }
        }
    }
}

#[inline(always)]
fn full_block<S: Simd, D: Dest>(shader: &Shader, columns: [i32; 2], rows: [i32; 2], dest: &mut D) {
    for y in rows[0]..=rows[1] {
        for x in (columns[0] / 8..=columns[1] / 8).map(|k| k * 8) {
            dest.row::<S>(shader, x, y, column_mask(x, columns[0], columns[1]));
        }
    }
}

#[inline(always)]
fn partial_block<S: Simd, D: Dest, const PIXEL_BY_PIXEL: bool>(
    part: &Part,
    shader: &Shader,
    columns: [i32; 2],
    rows: [i32; 2],
    dest: &mut D,
) {
    let Edges { a, b, .. } = part.edges;
    for x in (columns[0] / 8..=columns[1] / 8).map(|k| k * 8) {
        let allowed = column_mask(x, columns[0], columns[1]);
        let v = part.at(x, rows[0]);
        let lanes = S::load_u(&[0, 1, 2, 3, 4, 5, 6, 7]);
        let (mut values, mut steps) = ([S::i(0); 3], [S::i(0); 3]);
        for i in 0..3 {
            // Steps are below 2^24: within a block no sample changes its sign by this.
            let start = v[i].clamp(-(1 << 30), 1 << 30) as i32;
            values[i] = S::iadd(S::i(start), S::imul(S::i(a[i]), lanes));
            steps[i] = S::i(b[i]);
        }
        for y in rows[0]..=rows[1] {
            let mut mask = !S::signs(S::or(S::or(values[0], values[1]), values[2])) & allowed;
            for i in 0..3 {
                values[i] = S::iadd(values[i], steps[i]);
            }
            if PIXEL_BY_PIXEL {
                while mask != 0 {
                    dest.pixel(shader, x, y, mask.trailing_zeros() as usize);
                    mask &= mask - 1;
                }
            } else if mask != 0 {
                dest.row::<S>(shader, x, y, mask);
            }
        }
    }
}

/// An edge's crossing with a row, stepped from row to row: quotient and remainder of the edge function by its step in x.
#[derive(Clone, Copy)]
struct Crossing {
    quotient: i64,
    remainder: i64,
    step: [i64; 2],
    divisor: i64,
}

impl Crossing {
    #[inline(always)]
    fn new(value: i64, step: i64, a: i32) -> Crossing {
        // A horizontal edge only has a sign: its quotient is not looked at.
        let divisor = (a as i64).abs().max(1);
        let step = [step.div_euclid(divisor), step.rem_euclid(divisor)];
        Crossing { quotient: value.div_euclid(divisor), remainder: value.rem_euclid(divisor), step, divisor }
    }

    #[inline(always)]
    fn next(&mut self) {
        self.quotient += self.step[0];
        self.remainder += self.step[1];
        if self.remainder >= self.divisor {
            self.remainder -= self.divisor;
            self.quotient += 1;
        }
    }
}

#[inline(always)]
fn scanline<S: Simd, D: Dest>(part: &Part, shader: &Shader, dest: &mut D) {
    let Edges { a, b, .. } = part.edges;
    let v = part.at(0, part.y[0]);
    let mut crossings = [Crossing::new(0, 0, 0); 3];
    for i in 0..3 {
        crossings[i] = Crossing::new(v[i], b[i] as i64, a[i]);
    }
    for y in part.y[0]..=part.y[1] {
        let (mut first, mut last) = (part.x[0] as i64, part.x[1] as i64);
        for i in 0..3 {
            let q = crossings[i].quotient;
            match a[i] {
                // value + a x >= 0: x from -floor(value / a) on.
                1.. => first = first.max(-q),
                0 => last = if q < 0 { -1 } else { last },
                _ => last = last.min(q),
            }
            crossings[i].next();
        }
        if first <= last {
            let columns = [first as i32, last as i32];
            full_block::<S, D>(shader, columns, [y, y], dest);
        }
    }
}
