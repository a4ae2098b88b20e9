//! The commonest program without the lane executor: a colour times the texel of one texture, from the planes to the product. The
//! same operations as the program's text and the interpolator's, so the same bits; a test compares the two.
//!
//! Fragments wait packed, lane by lane. The level of detail is one for all fragments of a triangle in a quad of 2 x 2 pixels, and is
//! worked out once for them.

use std::marker::PhantomData;

use super::fine::Scene;
use super::layout::*;
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
const COORDINATES: usize = DEPTH_PLANE_VEC4 as usize;
const COLOR: usize = COORDINATES + VARYING_PLANE_VEC4 as usize;

type Block = [[f32; 4]; BLOCK];

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
    w: [[f32; 4]; FRAGMENTS],
    /// Triangles.
    used: usize,
    /// λ of the quads.
    lambdas: [f32; ROOM],
    /// Of the fragments: s, t, λ; x, y and w.
    coord: [[[f32; LANES]; GROUPS]; 3],
    /// See `coord`.
    place: [[[f32; LANES]; GROUPS]; 3],
    texels: [Texels; GROUPS],
}

impl Default for Fragments {
    fn default() -> Self {
        Fragments {
            count: 0,
            at: [0; ROOM],
            bytes: [0; ROOM],
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

    /// Forgets all.
    pub fn clear(&mut self) {
        (self.count, self.quads, self.used) = (0, 0, 0);
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
        let q = self.at(3, place, w);
        [S::div(self.at(0, place, w), q), S::div(self.at(1, place, w), q)]
    }
}

/// Where pixels of a bin are on the surface.
#[inline(always)]
fn places<S: Simd>(at: S::I, origin: [i32; 2]) -> [S::I; 2] {
    let (seven, tile) = (S::i(7), S::i(7 << 3));
    // See `store::pixel_index`: three bits each of the tile's row and column, of the pixel's row and column in it.
    let x = S::or(S::and(S::shr::<3>(at), tile), S::and(at, seven));
    let y = S::or(S::and(S::shr::<6>(at), tile), S::and(S::shr::<3>(at), seven));
    [S::iadd(S::i(origin[0]), x), S::iadd(S::i(origin[1]), y)]
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
    let mut blocks: [&Block; FRAGMENTS] = [&[[0.0; 4]; BLOCK]; FRAGMENTS];
    for ((source, block), w) in f.triangles.iter().zip(&mut blocks).zip(&mut f.w).take(f.used) {
        *block = scene.planes(source.work, source.planes).first_chunk().expect("two varyings");
        *w = if source.perspective { [block[0][3], block[1][0], block[1][1], 0.0] } else { [1.0, 0.0, 0.0, 0.0] };
    }
    if what.lod {
        for first in (0..f.quads).step_by(LANES) {
            S::store(quad_lambdas::<S>(plan, texture, f, &blocks, first, origin), eight_mut(&mut f.lambdas, first));
        }
    }
    // A loop for each part: in one for all, what waits for a division would hold up what waits for nothing.
    let groups = f.count.div_ceil(LANES);
    for g in 0..groups {
        let group = Group::<S>::new(eight(&f.triangle, g * LANES), &blocks);
        let [x, y] = places::<S>(S::load_u(eight(&f.at, g * LANES)), origin);
        let here = [S::to_f(x), S::to_f(y)];
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
        match &mut to {
            Colors::Bytes => {
                let most = S::f(255.0);
                let mut bytes = [S::i(0); 4];
                for k in 0..4 {
                    // As in `blend::quantize4`.
                    bytes[k] = S::round(S::mul(S::at_most(colors[k], S::f(1.0)), most));
                }
                S::store_u(S::bytes_of_twos(bytes), eight_mut(&mut f.bytes, first));
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
    let (x0, y0, x1, y1) = (S::to_f(x), S::to_f(y), S::to_f(S::or(x, one)), S::to_f(S::or(y, one)));
    let here = planes.project([x0, y0], group.over_w(&f.w, [x0, y0]));
    let right = planes.project([x1, y0], group.over_w(&f.w, [x1, y0]));
    let down = planes.project([x0, y1], group.over_w(&f.w, [x0, y1]));
    let across = [S::sub(right[0], here[0]), S::sub(right[1], here[1])];
    let along = [S::sub(down[0], here[0]), S::sub(down[1], here[1])];
    texture.flat_lambda::<S>([across, along])
}

/// Colour times texel: of fragments k and k + 4, four components side by side.
#[inline(always)]
fn product<S: Simd>(plan: &Plan, what: Modulate, group: &Group<S>, [x, y, w]: [&[f32; LANES]; 3], texels: &Texels) -> [S::F; 4] {
    let mode = plan.modes[1];
    let part = |on: bool| if on { !0 } else { 0 };
    let [rgb, alpha] = what.parts.map(part);
    let parts = S::load_u(&[rgb, rgb, rgb, alpha, rgb, rgb, rgb, alpha]);
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
