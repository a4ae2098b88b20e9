//! [`super::modulate`] where all fragments that wait are of one triangle, as they are under large ones: its planes are read once, and
//! rows of a tile that are there whole share what does not change from row to row. The same operations in the same order, so the same
//! bits.

use super::layout::interpolation;
use super::modulate::{Block, COLOR, COORDINATES, Colors, Fragments, over_q, parts_mask, place, places, put};
use super::plan::Plan;
use super::simd::{Simd, columns_from, eight};
use super::texture::Prepared;
use crate::program::Modulate;
use crate::program::lanes::LANES;

/// A plane's a0, d/dx and d/dy in all lanes.
type Plane<S> = [<S as Simd>::F; 3];

/// Component c of the three vec4 from `first` on.
#[inline(always)]
fn plane<S: Simd>(block: &Block, first: usize, c: usize) -> Plane<S> {
    [S::f(block[first][c]), S::f(block[first + 1][c]), S::f(block[first + 2][c])]
}

/// Colours of all fragments, which are of the first triangle, in a bin whose first pixel is at `origin`.
#[inline(always)]
pub fn run<S: Simd>(plan: &Plan, what: Modulate, texture: &Prepared, f: &mut Fragments, block: &Block, origin: [i32; 2], to: Colors) {
    // A loop for each part: in one for all, what waits for a division would hold up what waits for nothing.
    let groups = f.groups();
    match plan.modes[0] == interpolation::PERSPECTIVE {
        true => coordinates::<S, true>(plan, f, block, origin),
        false => coordinates::<S, false>(plan, f, block, origin),
    }
    let [s, t, _] = f.coord.each_ref().map(|c| &c[..groups]);
    texture.flat::<S>([s, t], None, &mut f.texels[..groups]);
    match plan.modes[1] == interpolation::PERSPECTIVE {
        true => colors::<S, true>(plan, what, f, block, origin, to),
        false => colors::<S, false>(plan, what, f, block, origin, to),
    }
}

/// Places, and s and t.
#[inline(always)]
fn coordinates<S: Simd, const PERSPECTIVE: bool>(plan: &Plan, f: &mut Fragments, block: &Block, origin: [i32; 2]) {
    let [a0, dx, dy, _] = f.w[0];
    // Of 1/w, s, t and q.
    let planes: [Plane<S>; 4] = [
        [S::f(a0), S::f(dx), S::f(dy)],
        plane::<S>(block, COORDINATES, 0),
        plane::<S>(block, COORDINATES, 1),
        plane::<S>(block, COORDINATES, 3),
    ];
    let (mut column, mut across) = (i32::MIN, [S::f(0.0); 4]);
    for g in 0..f.groups() {
        let at = eight(&f.at, g * LANES);
        let mut values = across;
        let y = if f.is_row(g) {
            let [first, row] = place(at[0], origin);
            if first != column {
                column = first;
                let x = columns_from::<S>(first as f32 + plan.centre);
                for k in 0..4 {
                    across[k] = S::fma(x, planes[k][1], planes[k][0]);
                }
                values = across;
            }
            let y = row as f32 + plan.centre;
            f.place[1][g][0] = y;
            S::f(y)
        } else {
            let [column, row] = places::<S>(S::load_u(at), origin);
            let centre = S::f(plan.centre);
            let (column, row) = (S::add(S::to_f(column), centre), S::add(S::to_f(row), centre));
            for k in 0..4 {
                values[k] = S::fma(column, planes[k][1], planes[k][0]);
            }
            S::store(column, &mut f.place[0][g]);
            S::store(row, &mut f.place[1][g]);
            row
        };
        for k in 0..4 {
            values[k] = S::fma(y, planes[k][2], values[k]);
        }
        let [inv_w, mut s, mut t, mut q] = values;
        let w = S::div(S::f(1.0), inv_w);
        if PERSPECTIVE {
            (s, t, q) = (S::mul(s, w), S::mul(t, w), S::mul(q, w));
        }
        let [s, t] = over_q::<S>([s, t], q);
        S::store(s, &mut f.coord[0][g]);
        S::store(t, &mut f.coord[1][g]);
        S::store(w, &mut f.place[2][g]);
    }
}

/// Colours times texels: of fragments k and k + 4 of a group, four components side by side.
#[inline(always)]
fn colors<S: Simd, const PERSPECTIVE: bool>(
    plan: &Plan,
    what: Modulate,
    f: &mut Fragments,
    block: &Block,
    origin: [i32; 2],
    mut to: Colors,
) {
    let a0 = S::two(&block[COLOR], &block[COLOR]);
    let (mut dx, mut dy) = (S::two(&block[COLOR + 1], &block[COLOR + 1]), S::two(&block[COLOR + 2], &block[COLOR + 2]));
    if plan.modes[1] == interpolation::FLAT {
        // No place is negative, and a negative zero leaves everything as it is.
        (dx, dy) = (S::f(-0.0), S::f(-0.0));
    }
    let (all, parts) = (what.parts == [true; 2], parts_mask::<S>(what.parts));
    let (mut column, mut across) = (i32::MIN, [S::f(0.0); 4]);
    for g in 0..f.groups() {
        let w = S::load(&f.place[2][g]);
        let mut values = across;
        if f.is_row(g) {
            let [first, _] = place(f.at[g * LANES], origin);
            if first != column {
                column = first;
                let x = columns_from::<S>(first as f32 + plan.centre);
                for k in 0..4 {
                    across[k] = S::fma(S::spread(x, k), dx, a0);
                }
                values = across;
            }
            let y = S::f(f.place[1][g][0]);
            for value in &mut values {
                *value = S::fma(y, dy, *value);
            }
        } else {
            let (x, y) = (S::load(&f.place[0][g]), S::load(&f.place[1][g]));
            for k in 0..4 {
                values[k] = S::fma(S::spread(y, k), dy, S::fma(S::spread(x, k), dx, a0));
            }
        }
        let texels = &f.texels[g];
        for k in 0..4 {
            if PERSPECTIVE {
                values[k] = S::mul(values[k], S::spread(w, k));
            }
            let mut texel = S::two(&texels[k], &texels[k + 4]);
            if !all {
                texel = S::from_bits(S::select(parts, S::bits(texel), S::bits(S::f(1.0))));
            }
            values[k] = S::mul(values[k], texel);
        }
        put::<S>(&mut to, &mut f.bytes, g, values);
    }
}
