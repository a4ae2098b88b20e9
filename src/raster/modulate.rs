//! The commonest program without the lane executor: a colour times the texel of one texture, from the planes to the product. The
//! same operations as the program's text and the interpolator's, so the same bits; a test compares the two.

use super::fine::{Plan, Row, Scene};
use super::layout::*;
use super::simd::{Level, Simd, eight, eight_mut};
use super::texture;
use crate::draw::texture::TextureBinding;
use crate::program::Modulate;
use crate::program::lanes::{self, Column4, GROUPS, LANES};

/// Lanes of a queue, with room for eight that begin at the last one.
const ROOM: usize = LANES * GROUPS + LANES;
/// vec4 of a triangle with two varyings: depth, coordinates, colour.
const BLOCK: usize = (DEPTH_PLANE_VEC4 + 2 * VARYING_PLANE_VEC4) as usize;
/// First plane of the coordinates, and of the colour.
const COORDINATES: usize = DEPTH_PLANE_VEC4 as usize;
const COLOR: usize = COORDINATES + VARYING_PLANE_VEC4 as usize;

/// Planes of a varying, in eight lanes each: a0, d/dx and d/dy of four components.
struct Planes<S: Simd> {
    of: [[S::F; 4]; 3],
    /// Divided by w after the interpolation.
    perspective: bool,
}

impl<S: Simd> Planes<S> {
    #[inline(always)]
    fn new(blocks: &[&[[f32; 4]; BLOCK]; LANES], first: usize, mode: u32) -> Self {
        // Large triangles fill groups: their planes are the same in all lanes.
        let same = blocks.iter().all(|block| std::ptr::eq(*block, blocks[0]));
        let mut of = [[S::f(0.0); 4]; 3];
        for (k, columns) in of.iter_mut().enumerate() {
            if same {
                for c in 0..4 {
                    columns[c] = S::f(blocks[0][first + k][c]);
                }
            } else {
                let [a, b, c, d, e, f, g, h] = blocks;
                let at = first + k;
                *columns = S::columns([&a[at], &b[at], &c[at], &d[at], &e[at], &f[at], &g[at], &h[at]]);
            }
        }
        Planes { of, perspective: mode == interpolation::PERSPECTIVE }
    }

    #[inline(always)]
    fn at(&self, c: usize, [x, y]: [S::F; 2], reciprocal: S::F) -> S::F {
        let value = S::fma(y, self.of[2][c], S::fma(x, self.of[1][c], self.of[0][c]));
        if self.perspective { S::mul(value, reciprocal) } else { value }
    }

    /// s and t, divided by q.
    #[inline(always)]
    fn project(&self, place: [S::F; 2], reciprocal: S::F) -> [S::F; 2] {
        let q = self.at(3, place, reciprocal);
        [S::div(self.at(0, place, reciprocal), q), S::div(self.at(1, place, reciprocal), q)]
    }
}

/// Colours of the first `count` fragments, which are those of `rows`.
#[inline(always)]
pub fn run<S: Simd>(what: Modulate, scene: &Scene, plan: &Plan, binding: &TextureBinding, rows: &[Row], count: usize, color: &mut Column4) {
    let level = if S::LEVEL == Level::Scalar { lanes::Simd::Scalar } else { lanes::Simd::Avx2 };
    let (mut blocks, mut pixel, mut inv_w) = ([&[[0.0; 4]; BLOCK]; ROOM], [[0; ROOM]; 2], [[0.0; ROOM]; 3]);
    for row in rows {
        let block: &[[f32; 4]; BLOCK] = scene.planes(row).first_chunk().expect("two varyings");
        // Eight lanes at a time: what lies beyond the row's fragments is the next row's to overwrite.
        let start = row.start as usize % (LANES * GROUPS);
        blocks[start..start + LANES].fill(block);
        let x = S::iadd(S::i(row.place[0]), S::set_lanes(row.mask));
        S::store_u(x, eight_mut(&mut pixel[0], start));
        S::store_u(S::i(row.place[1]), eight_mut(&mut pixel[1], start));
        let w = if row.perspective { [block[0][3], block[1][0], block[1][1]] } else { [1.0, 0.0, 0.0] };
        for k in 0..3 {
            S::store(S::f(w[k]), eight_mut(&mut inv_w[k], start));
        }
    }
    for g in 0..count.div_ceil(LANES) {
        let first = g * LANES;
        let (x, y) = (S::load_u(eight(&pixel[0], first)), S::load_u(eight(&pixel[1], first)));
        let w = [S::load(eight(&inv_w[0], first)), S::load(eight(&inv_w[1], first)), S::load(eight(&inv_w[2], first))];
        let blocks = eight(&blocks, first);
        let here = [S::to_f(x), S::to_f(y)];
        let reciprocal = over_w::<S>(&w, here);
        let planes = Planes::<S>::new(blocks, COORDINATES, plan.modes[0]);
        let mut coord = [[0.0; LANES]; 4];
        let at = planes.project(here, reciprocal);
        S::store(at[0], &mut coord[0]);
        S::store(at[1], &mut coord[1]);
        let mut gradients = [[[0.0; LANES]; 3]; 2];
        if what.lod {
            // The quad's first pixel, the next in x, the next in y.
            let (even_x, even_y, one) = (S::and(x, S::i(!1)), S::and(y, S::i(!1)), S::i(1));
            let (x0, y0) = (S::to_f(even_x), S::to_f(even_y));
            let (x1, y1) = (S::to_f(S::or(even_x, one)), S::to_f(S::or(even_y, one)));
            let origin = planes.project([x0, y0], over_w::<S>(&w, [x0, y0]));
            let right = planes.project([x1, y0], over_w::<S>(&w, [x1, y0]));
            let down = planes.project([x0, y1], over_w::<S>(&w, [x0, y1]));
            for c in 0..2 {
                S::store(S::sub(right[c], origin[c]), &mut gradients[0][c]);
                S::store(S::sub(down[c], origin[c]), &mut gradients[1][c]);
            }
        }
        let wanted = if what.lod { Some([&gradients[0], &gradients[1]]) } else { None };
        let texel = texture::sample_group(binding, &coord, wanted, level);
        let planes = Planes::<S>::new(blocks, COLOR, plan.modes[1]);
        // What does not vary is taken where nothing is added to it: 0 times -0 is -0.
        let place = if plan.modes[1] == interpolation::FLAT { [S::f(-0.0); 2] } else { here };
        for c in 0..4 {
            let mut value = planes.at(c, place, reciprocal);
            if what.parts[c / 3] {
                value = S::mul(value, S::load(&texel[c]));
            }
            S::store(value, &mut color[c][g]);
        }
    }
}

/// w of eight fragments at a place.
#[inline(always)]
fn over_w<S: Simd>([a0, dx, dy]: &[S::F; 3], [x, y]: [S::F; 2]) -> S::F {
    S::div(S::f(1.0), S::fma(y, *dy, S::fma(x, *dx, *a0)))
}
