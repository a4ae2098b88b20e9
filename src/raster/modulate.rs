//! The commonest program without the lane executor: a colour times the texel of one texture, from the planes to the product. The
//! same operations as the program's text and the interpolator's, so the same bits; a test compares the two.
//!
//! Fragments wait packed, lane by lane. The level of detail is one for all fragments of a triangle in a quad of 2 x 2 pixels, and is
//! worked out once for them.

use std::marker::PhantomData;

use super::fine::Scene;
use super::layout::*;
use super::modulate_one;
use super::plan::Plan;
use super::simd::{Simd, eight, eight_mut};
use super::texture::{Prepared, Texels};
use crate::program::Modulate;
use crate::program::lanes::{Column4, LANES};

/// Fragments that may wait. A power of two, so that an index needs no check; a triangle's number fits a byte.
pub const FRAGMENTS: usize = 128;
/// The same by groups of lanes.
const GROUPS: usize = FRAGMENTS / LANES;
/// The same, with room for eight that begin at the last one.
const ROOM: usize = FRAGMENTS + LANES;
/// vec4 of a triangle with two varyings: depth, coordinates, colour.
const BLOCK: usize = (DEPTH_PLANE_VEC4 + 2 * VARYING_PLANE_VEC4) as usize;
/// First plane of the coordinates, and of the colour.
pub const COORDINATES: usize = DEPTH_PLANE_VEC4 as usize;
pub const COLOR: usize = COORDINATES + VARYING_PLANE_VEC4 as usize;

/// A triangle's planes.
pub type Block = [[f32; 4]; BLOCK];

/// A triangle that fragments are of.
#[derive(Clone, Copy, Default, PartialEq)]
pub struct Source {
    /// Index of its work.
    pub work: u32,
    /// First of its planes.
    pub planes: u32,
    /// [`triangle_flags::PERSPECTIVE`]
    pub perspective: bool,
}

/// Fragments that wait for their colour, and their quads.
pub struct Fragments {
    /// Fragments.
    pub count: usize,
    /// Of each, its pixel in the bin.
    pub at: [u32; ROOM],
    /// Of each, its colour, when that is known.
    pub bytes: [u32; ROOM],
    /// Bit by group of lanes: it is a whole row of a tile.
    rows: u32,
    /// Of each, its triangle's place in `triangles`.
    triangle: [u8; ROOM],
    /// Of each, its quad, where a level of detail is wanted.
    quad: [u32; ROOM],
    quads: usize,
    /// Of each quad, its first pixel in the bin.
    quad_at: [u32; ROOM],
    /// Of each quad, its triangle.
    quad_triangle: [u8; ROOM],
    /// Triangles that have fragments.
    triangles: [Source; FRAGMENTS],
    /// Planes of 1/w of these: a0, d/dx, d/dy.
    pub w: [[f32; 4]; FRAGMENTS],
    /// Triangles.
    used: usize,
    /// λ of the quads.
    lambdas: [f32; ROOM],
    /// Of the fragments: s, t, λ; x, y and w.
    pub coord: [[[f32; LANES]; GROUPS]; 3],
    /// See `coord`.
    pub place: [[[f32; LANES]; GROUPS]; 3],
    pub texels: [Texels; GROUPS],
}

impl Default for Fragments {
    fn default() -> Self {
        Fragments {
            count: 0,
            at: [0; ROOM],
            bytes: [0; ROOM],
            rows: 0,
            triangle: [0; ROOM],
            quad: [0; ROOM],
            quads: 0,
            quad_at: [0; ROOM],
            quad_triangle: [0; ROOM],
            triangles: [Source::default(); FRAGMENTS],
            w: [[0.0; 4]; FRAGMENTS],
            used: 0,
            lambdas: [0.0; ROOM],
            coord: [[[0.0; LANES]; GROUPS]; 3],
            place: [[[0.0; LANES]; GROUPS]; 3],
            texels: [[[0.0; 4]; LANES]; GROUPS],
        }
    }
}

impl Fragments {
    /// Whether two more rows of eight pixels may not fit.
    pub fn crowded(&self) -> bool {
        self.count > FRAGMENTS - 2 * LANES
    }

    /// Groups of lanes.
    #[inline(always)]
    pub fn groups(&self) -> usize {
        self.count.div_ceil(LANES).min(GROUPS)
    }

    /// A group is a whole row of a tile.
    #[inline(always)]
    pub fn is_row(&self, group: usize) -> bool {
        self.rows >> group & 1 != 0
    }

    /// Forgets all.
    pub fn clear(&mut self) {
        (self.count, self.quads, self.used, self.rows) = (0, 0, 0, 0);
    }

    /// Lets fragments of two rows wait: `at` is the first pixel of the first row, which is an even one, the bytes of
    /// `masks` say which pixels they are.
    #[inline(always)]
    pub fn push<S: Simd>(&mut self, source: Source, at: u32, masks: u32, lod: bool) {
        if self.used == 0 || self.triangles[(self.used - 1) % FRAGMENTS] != source {
            self.triangles[self.used % FRAGMENTS] = source;
            self.used += 1;
        }
        let triangle = [(self.used - 1) as u8; LANES];
        let mut quad = S::i(0);
        if lod {
            let covered = masks | masks >> 8;
            let even = (covered | covered >> 1) & 0x55;
            S::store_u(S::iadd(S::set_lanes(even), S::i(at as i32)), eight_mut(&mut self.quad_at, self.quads));
            *eight_mut(&mut self.quad_triangle, self.quads) = triangle;
            quad = S::iadd(S::shr::<1>(S::ranks(3 * even)), S::i(self.quads as i32));
            self.quads += even.count_ones() as usize;
        }
        for k in 0..2 {
            let mask = masks >> (8 * k) & 0xff;
            S::store_u(S::iadd(S::set_lanes(mask), S::i(at as i32 + 8 * k)), eight_mut(&mut self.at, self.count));
            *eight_mut(&mut self.triangle, self.count) = triangle;
            if lod {
                S::store_u(S::pack(quad, mask), eight_mut(&mut self.quad, self.count));
            }
            self.rows |= u32::from(mask == 0xff && self.count.is_multiple_of(LANES)) << (self.count / LANES);
            self.count += mask.count_ones() as usize;
        }
    }
}

/// Triangles of eight lanes.
struct Group<'a, S: Simd> {
    blocks: [&'a Block; LANES],
    /// It is one triangle: large ones fill groups.
    same: bool,
    /// Their places among the triangles.
    of: [usize; LANES],
    level: PhantomData<S>,
}

impl<'a, S: Simd> Group<'a, S> {
    #[inline(always)]
    fn new(triangles: &[u8; LANES], blocks: &[&'a Block; FRAGMENTS]) -> Self {
        let of = triangles.map(|t| t as usize % FRAGMENTS);
        let [a, b, c, d, e, f, g, h] = of;
        Group {
            blocks: [blocks[a], blocks[b], blocks[c], blocks[d], blocks[e], blocks[f], blocks[g], blocks[h]],
            same: *triangles == [triangles[0]; LANES],
            of,
            level: PhantomData,
        }
    }

    /// A vec4 of the blocks.
    #[inline(always)]
    fn columns(&self, k: usize) -> [S::F; 4] {
        let [a, b, c, d, e, f, g, h] = self.blocks;
        if self.same {
            return [S::f(a[k][0]), S::f(a[k][1]), S::f(a[k][2]), S::f(a[k][3])];
        }
        S::columns([&a[k], &b[k], &c[k], &d[k], &e[k], &f[k], &g[k], &h[k]])
    }

    /// w at a place, by the triangles' planes of 1/w.
    #[inline(always)]
    fn over_w(&self, planes: &[[f32; 4]; FRAGMENTS], [x, y]: [S::F; 2]) -> S::F {
        let [a, b, c, d, e, f, g, h] = self.of;
        let [a0, dx, dy, _] = S::columns([&planes[a], &planes[b], &planes[c], &planes[d], &planes[e], &planes[f], &planes[g], &planes[h]]);
        S::div(S::f(1.0), S::fma(y, dy, S::fma(x, dx, a0)))
    }
}

/// Planes of the texture coordinates of eight lanes: a0, d/dx and d/dy of four components.
struct Coordinates<S: Simd> {
    of: [[S::F; 4]; 3],
    /// Divided by w after the interpolation.
    perspective: bool,
}

impl<S: Simd> Coordinates<S> {
    #[inline(always)]
    fn new(group: &Group<S>, mode: u32) -> Self {
        let of = [group.columns(COORDINATES), group.columns(COORDINATES + 1), group.columns(COORDINATES + 2)];
        Coordinates { of, perspective: mode == interpolation::PERSPECTIVE }
    }

    #[inline(always)]
    fn at(&self, c: usize, [x, y]: [S::F; 2], w: S::F) -> S::F {
        let value = S::fma(y, self.of[2][c], S::fma(x, self.of[1][c], self.of[0][c]));
        if self.perspective { S::mul(value, w) } else { value }
    }

    /// s and t, divided by q.
    #[inline(always)]
    fn project(&self, place: [S::F; 2], w: S::F) -> [S::F; 2] {
        over_q::<S>([self.at(0, place, w), self.at(1, place, w)], self.at(3, place, w))
    }
}

/// s and t divided by q. Where the program gave no q, it is 1/w times w: 1, or 1 - 2^-24, which is the number below. A quotient by that is
/// `s * (1 + 2^-24 + 2^-48 + ...)`, more than half and less than one and a half units in the last place from s. A product and a sum that
/// are rounded once give the same with `2^-24 + 2^-47`, and leave s, infinite or not, with 2^-60: no division.
#[inline(always)]
pub fn over_q<S: Simd>([s, t]: [S::F; 2], q: S::F) -> [S::F; 2] {
    const BELOW: f32 = 1.0 - f32::EPSILON / 2.0;
    const TINY: f32 = 1.0 / (1u64 << 60) as f32;
    let others = S::andnot(S::i(1), S::isub(S::bits(q), S::i(BELOW.to_bits() as i32)));
    if S::signs(S::eq(others, S::i(0))) != 0xff {
        return [S::div(s, q), S::div(t, q)];
    }
    let more = S::fma(S::sub(S::f(1.0), q), S::f(1.0 + f32::EPSILON), S::f(TINY));
    [S::fma(s, more, s), S::fma(t, more, t)]
}

/// Where pixels of a bin are on the surface.
#[inline(always)]
pub fn places<S: Simd>(at: S::I, origin: [i32; 2]) -> [S::I; 2] {
    let (seven, tile) = (S::i(7), S::i(7 << 3));
    // See `store::pixel_index`: three bits each of the tile's row and column, of the pixel's row and column in it.
    let x = S::or(S::and(S::shr::<3>(at), tile), S::and(at, seven));
    let y = S::or(S::and(S::shr::<6>(at), tile), S::and(S::shr::<3>(at), seven));
    [S::iadd(S::i(origin[0]), x), S::iadd(S::i(origin[1]), y)]
}

/// The same of one pixel.
#[inline(always)]
pub fn place(at: u32, origin: [i32; 2]) -> [i32; 2] {
    let at = at as i32;
    [origin[0] + (at >> 3 & 7 << 3 | at & 7), origin[1] + (at >> 6 & 7 << 3 | at >> 3 & 7)]
}

/// Where colours go.
pub enum Colors<'a> {
    /// To `Fragments::bytes`.
    Bytes,
    /// As they are.
    Columns(&'a mut Column4),
}

/// Colours of all fragments of a bin whose first pixel is at `origin`.
#[inline(always)]
pub fn run<S: Simd>(scene: &Scene, plan: &Plan, what: Modulate, texture: &Prepared, f: &mut Fragments, origin: [i32; 2], mut to: Colors) {
    if f.used == 1 && !what.lod {
        let source = f.triangles[0];
        let block = scene.planes(source.work, source.planes).first_chunk().expect("two varyings");
        f.w[0] = inverse_w(source, block);
        return modulate_one::run::<S>(plan, what, texture, f, block, origin, to);
    }
    let mut blocks: [&Block; FRAGMENTS] = [&[[0.0; 4]; BLOCK]; FRAGMENTS];
    for ((source, block), w) in f.triangles.iter().zip(&mut blocks).zip(&mut f.w).take(f.used) {
        *block = scene.planes(source.work, source.planes).first_chunk().expect("two varyings");
        *w = inverse_w(*source, block);
    }
    if what.lod {
        for first in (0..f.quads).step_by(LANES) {
            S::store(quad_lambdas::<S>(plan, texture, f, &blocks, first, origin), eight_mut(&mut f.lambdas, first));
        }
    }
    // A loop for each part: in one for all, what waits for a division would hold up what waits for nothing.
    let groups = f.groups();
    for g in 0..groups {
        let group = Group::<S>::new(eight(&f.triangle, g * LANES), &blocks);
        let [x, y] = places::<S>(S::load_u(eight(&f.at, g * LANES)), origin);
        let here = [S::add(S::to_f(x), S::f(plan.centre)), S::add(S::to_f(y), S::f(plan.centre))];
        let w = group.over_w(&f.w, here);
        let [s, t] = Coordinates::new(&group, plan.modes[0]).project(here, w);
        S::store(s, &mut f.coord[0][g]);
        S::store(t, &mut f.coord[1][g]);
        S::store(here[0], &mut f.place[0][g]);
        S::store(here[1], &mut f.place[1][g]);
        S::store(w, &mut f.place[2][g]);
        if what.lod {
            for (lambda, quad) in f.coord[2][g].iter_mut().zip(eight(&f.quad, g * LANES)) {
                *lambda = f.lambdas[*quad as usize % FRAGMENTS];
            }
        }
    }
    let [s, t, lambda] = f.coord.each_ref().map(|c| &c[..groups]);
    texture.flat::<S>([s, t], what.lod.then_some(lambda), &mut f.texels[..groups]);
    for g in 0..groups {
        let first = g * LANES;
        let group = Group::<S>::new(eight(&f.triangle, first), &blocks);
        let colors = product::<S>(plan, what, &group, f.place.each_ref().map(|p| &p[g]), &f.texels[g]);
        put::<S>(&mut to, &mut f.bytes, g, colors);
    }
}

/// Puts a group's colours, of fragments k and k + 4 side by side, where they go.
#[inline(always)]
pub fn put<S: Simd>(to: &mut Colors, bytes: &mut [u32; ROOM], g: usize, colors: [S::F; 4]) {
    match to {
        Colors::Bytes => {
            let most = S::f(255.0);
            let mut wide = [S::i(0); 4];
            for k in 0..4 {
                // As in `blend::quantize4`.
                wide[k] = S::round(S::mul(S::at_most(colors[k], S::f(1.0)), most));
            }
            S::store_u(S::bytes_of_twos(wide), eight_mut(bytes, g * LANES));
        }
        Colors::Columns(columns) => {
            let mut pixels = [[0.0; LANES]; 4];
            for k in 0..4 {
                S::store(colors[k], &mut pixels[k]);
            }
            for lane in 0..LANES {
                for c in 0..4 {
                    columns[c][g][lane] = pixels[lane % 4][lane / 4 * 4 + c];
                }
            }
        }
    }
}

/// The plane of a triangle's 1/w.
#[inline(always)]
fn inverse_w(source: Source, block: &Block) -> [f32; 4] {
    if source.perspective { [block[0][3], block[1][0], block[1][1], 0.0] } else { [1.0, 0.0, 0.0, 0.0] }
}

/// λ of eight quads.
#[inline(always)]
fn quad_lambdas<S: Simd>(
    plan: &Plan,
    texture: &Prepared,
    f: &Fragments,
    blocks: &[&Block; FRAGMENTS],
    first: usize,
    origin: [i32; 2],
) -> S::F {
    let group = Group::<S>::new(eight(&f.quad_triangle, first), blocks);
    let planes = Coordinates::new(&group, plan.modes[0]);
    // The quad's first pixel, the next in x, the next in y.
    let ([x, y], one) = (places::<S>(S::load_u(eight(&f.quad_at, first)), origin), S::i(1));
    let centre = S::f(plan.centre);
    let (x0, y0) = (S::add(S::to_f(x), centre), S::add(S::to_f(y), centre));
    let (x1, y1) = (S::add(S::to_f(S::or(x, one)), centre), S::add(S::to_f(S::or(y, one)), centre));
    let here = planes.project([x0, y0], group.over_w(&f.w, [x0, y0]));
    let right = planes.project([x1, y0], group.over_w(&f.w, [x1, y0]));
    let down = planes.project([x0, y1], group.over_w(&f.w, [x0, y1]));
    let across = [S::sub(right[0], here[0]), S::sub(right[1], here[1])];
    let along = [S::sub(down[0], here[0]), S::sub(down[1], here[1])];
    texture.flat_lambda::<S>([across, along])
}

/// The components that a texel is a factor of: rgb and alpha, of two fragments side by side.
#[inline(always)]
pub fn parts_mask<S: Simd>([rgb, alpha]: [bool; 2]) -> S::I {
    let (rgb, alpha) = (if rgb { !0 } else { 0 }, if alpha { !0 } else { 0 });
    S::load_u(&[rgb, rgb, rgb, alpha, rgb, rgb, rgb, alpha])
}

/// Colour times texel: of fragments k and k + 4, four components side by side.
#[inline(always)]
fn product<S: Simd>(plan: &Plan, what: Modulate, group: &Group<S>, [x, y, w]: [&[f32; LANES]; 3], texels: &Texels) -> [S::F; 4] {
    let mode = plan.modes[1];
    let parts = parts_mask::<S>(what.parts);
    let (mut colors, mut planes) = ([S::f(0.0); 4], [S::f(0.0); 3]);
    for (k, color) in colors.iter_mut().enumerate() {
        if k == 0 || !group.same {
            let (a, b) = (group.blocks[k], group.blocks[k + 4]);
            planes = [S::two(&a[COLOR], &b[COLOR]), S::two(&a[COLOR + 1], &b[COLOR + 1]), S::two(&a[COLOR + 2], &b[COLOR + 2])];
        }
        let mut value = planes[0];
        if mode != interpolation::FLAT {
            let (x, y) = (S::halves(x[k], x[k + 4]), S::halves(y[k], y[k + 4]));
            value = S::fma(y, planes[2], S::fma(x, planes[1], value));
        }
        if mode == interpolation::PERSPECTIVE {
            value = S::mul(value, S::halves(w[k], w[k + 4]));
        }
        let texel = S::bits(S::two(&texels[k], &texels[k + 4]));
        *color = S::mul(value, S::from_bits(S::select(parts, texel, S::bits(S::f(1.0)))));
    }
    colors
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::simd::Portable;

    #[test]
    fn a_quotient_by_1_or_the_number_below_needs_no_division() {
        let below = 1.0 - f32::EPSILON / 2.0;
        // Every mantissa's ends, exponents from the denormal numbers to infinity, and what is none.
        for high in 0..1u32 << 13 {
            for low in [0, 1, 2, 3, 0x3ffff, 0x40000, 0x7fffe, 0x7ffff] {
                let s = f32::from_bits(high << 19 | low);
                for q in [1.0, below] {
                    let [got, _] = over_q::<Portable>([[s; 8], [0.0; 8]], [q; 8]);
                    let want = s / q;
                    assert!(got[0].to_bits() == want.to_bits() || got[0].is_nan() && want.is_nan(), "{s:e} / {q}: {} {want}", got[0]);
                }
            }
        }
    }

    #[test]
    fn w_times_its_inverse_is_1_or_the_number_below() {
        for k in 0..1u32 << 23 {
            let v = f32::from_bits(0x3f80_0000 | k);
            let q = v * (1.0 / v);
            assert!(q == 1.0 || q == 1.0 - f32::EPSILON / 2.0);
        }
    }
}
