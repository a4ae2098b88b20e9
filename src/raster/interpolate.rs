//! What fragment programs read, for fragments that wait in a queue.
//!
//! Small triangles leave two or three fragments in a row of eight pixels, so planes are evaluated fragment by fragment, the four
//! components of a varying at a time; the values become columns, eight fragments a group, and only then are divided by w.

use super::fine::{Row, Scene};
use super::layout::*;
use super::plan::Plan;
use super::simd::{Simd, eight, eight_mut};
use crate::program::Input;
use crate::program::lanes::{Column4, GROUPS, LANES};

/// Fragments in a queue.
const FRAGMENTS: usize = LANES * GROUPS;
/// The same, with room for a row that begins at the last one.
const ROOM: usize = FRAGMENTS + LANES;
/// Places where a varying may be wanted: the fragment, the three points of its quad, and nowhere, for what does not vary. A power of
/// two, so that an index needs no check.
const PLACES: usize = 8;
/// See [`PLACES`].
const NOWHERE: usize = 4;

/// An input that comes from planes.
#[derive(Clone, Copy)]
struct Source {
    /// Which input.
    input: usize,
    /// First of its three vec4 in a triangle's planes.
    planes: usize,
    /// Where it is evaluated.
    place: usize,
    perspective: bool,
}

/// Memory of the stage.
pub struct Interpolator {
    sources: Vec<Source>,
    /// Of each source, the fragments' values.
    values: Vec<[[f32; 4]; ROOM]>,
    /// Pixels of the fragments.
    pixel: [[u32; FRAGMENTS]; 2],
    /// Their triangles' planes of 1/w: a0, d/dx, d/dy; 1, 0, 0 where there is no perspective.
    inv_w: [[f32; FRAGMENTS]; 3],
    /// x and y of the places. What is added nowhere, 0 times -0, is -0, which leaves everything as it is.
    at: [[[f32; ROOM]; 2]; PLACES],
}

impl Default for Interpolator {
    fn default() -> Self {
        Interpolator {
            sources: Vec::new(),
            values: Vec::new(),
            pixel: [[0; FRAGMENTS]; 2],
            inv_w: [[0.0; FRAGMENTS]; 3],
            at: [[[-0.0; ROOM]; 2]; PLACES],
        }
    }
}

impl Interpolator {
    /// Gets ready for a draw.
    pub fn prepare(&mut self, plan: &Plan) {
        self.sources.clear();
        for (input, what) in plan.inputs().iter().enumerate() {
            let (k, place) = match *what {
                Input::Varying(k) => (k, if plan.modes[k as usize] == interpolation::FLAT { NOWHERE } else { 0 }),
                Input::Quad(k, which) => (k, 1 + which as usize % 3),
                _ => continue,
            };
            let perspective = plan.modes[k as usize] == interpolation::PERSPECTIVE;
            let planes = (DEPTH_PLANE_VEC4 + k as u32 * VARYING_PLANE_VEC4) as usize;
            self.sources.push(Source { input, planes, place, perspective });
        }
        if self.values.len() < self.sources.len() {
            self.values.resize(self.sources.len(), [[0.0; 4]; ROOM]);
        }
    }

    /// Fills the columns of a program's inputs for the first `count` fragments, which are those of `rows`.
    #[inline(always)]
    pub fn run<S: Simd>(&mut self, scene: &Scene, plan: &Plan, rows: &[Row], count: usize, columns: &mut [Column4]) {
        let places = self.sources.iter().fold(0, |places, s| places | 1u32 << s.place);
        // A row holds a fragment at least.
        let mut planes_of: [&[[f32; 4]]; FRAGMENTS] = [&[]; FRAGMENTS];
        for (row, planes) in rows.iter().zip(&mut planes_of) {
            *planes = scene.planes(row.work, row.planes);
            let (head, tail) = (planes[0], planes[1]);
            let w = if row.perspective { [head[3], tail[0], tail[1]] } else { [1.0, 0.0, 0.0] };
            each_fragment(row, |lane, x| {
                (self.pixel[0][lane], self.pixel[1][lane]) = (x, row.place[1] as u32);
                (self.inv_w[0][lane], self.inv_w[1][lane], self.inv_w[2][lane]) = (w[0], w[1], w[2]);
            });
        }
        let groups = count.div_ceil(LANES);
        for group in 0..groups {
            let (x, y) = (S::load_u(eight(&self.pixel[0], group * LANES)), S::load_u(eight(&self.pixel[1], group * LANES)));
            let (even_x, even_y, one) = (S::and(x, S::i(!1)), S::and(y, S::i(!1)), S::i(1));
            let at = [[x, y], [even_x, even_y], [S::or(even_x, one), even_y], [even_x, S::or(even_y, one)]];
            for place in 0..at.len() {
                if places >> place & 1 != 0 {
                    S::store(S::add(S::to_f(at[place][0]), S::f(plan.centre)), eight_mut(&mut self.at[place][0], group * LANES));
                    S::store(S::add(S::to_f(at[place][1]), S::f(plan.centre)), eight_mut(&mut self.at[place][1], group * LANES));
                }
            }
        }
        for (source, values) in self.sources.iter().zip(&mut self.values) {
            let [x, y] = &self.at[source.place % PLACES];
            for (row, planes) in rows.iter().zip(&planes_of) {
                let p: &[[f32; 4]; 3] = planes[source.planes..][..3].try_into().expect("three");
                // A row's fragments have one y, and so have the places of a quad.
                let start = row.start as usize % FRAGMENTS;
                let (x, y) = (eight(x, start), y[start]);
                S::planes(p, x, y, (row.end - row.start) as usize, eight_mut(values, start));
            }
        }
        for group in 0..groups {
            // Without closures: only inside a function of the dispatched level do the intrinsics become instructions.
            let mut reciprocal = [S::f(1.0); PLACES];
            for place in 0..NOWHERE {
                if places >> place & 1 != 0 {
                    let [a0, dx, dy] = &self.inv_w;
                    let (a0, dx, dy) =
                        (S::load(eight(a0, group * LANES)), S::load(eight(dx, group * LANES)), S::load(eight(dy, group * LANES)));
                    let [x, y] = &self.at[place];
                    let w = S::fma(S::load(eight(y, group * LANES)), dy, S::fma(S::load(eight(x, group * LANES)), dx, a0));
                    reciprocal[place] = S::div(S::f(1.0), w);
                }
            }
            for (source, values) in self.sources.iter().zip(&self.values) {
                let mut value = S::columns(eight(values, group * LANES).each_ref());
                if source.perspective {
                    let reciprocal = reciprocal[source.place % PLACES];
                    for component in &mut value {
                        *component = S::mul(*component, reciprocal);
                    }
                }
                let column = &mut columns[source.input];
                for component in 0..4 {
                    S::store(value[component], &mut column[component][group]);
                }
            }
        }
        self.window(scene, plan, rows, columns);
    }

    /// The inputs that are no varyings.
    #[inline(always)]
    fn window(&mut self, scene: &Scene, plan: &Plan, rows: &[Row], columns: &mut [Column4]) {
        for (what, column) in plan.inputs().iter().zip(columns) {
            if !matches!(what, Input::Position | Input::Facing) {
                continue;
            }
            for row in rows {
                let planes = scene.planes(row.work, row.planes);
                let (head, tail) = (planes[0], planes[1]);
                let y = row.place[1] as f32 + plan.centre;
                each_fragment(row, |lane, x| {
                    let x = x as f32 + plan.centre;
                    let value = match what {
                        Input::Position => {
                            let z = y.mul_add(head[2], x.mul_add(head[1], head[0])) + tail[2];
                            [x + (0.5 - plan.centre), y + (0.5 - plan.centre), z, y.mul_add(tail[1], x.mul_add(tail[0], head[3]))]
                        }
                        _ => [row.front as u32 as f32, 0.0, 0.0, 0.0],
                    };
                    for (component, column) in value.into_iter().zip(&mut *column) {
                        column.as_flattened_mut()[lane] = component;
                    }
                });
            }
        }
    }
}

/// Calls f with the lane and the column on the surface of each fragment of a row.
#[inline(always)]
fn each_fragment(row: &Row, mut f: impl FnMut(usize, u32)) {
    let mut bits = row.mask;
    let mut lane = row.start as usize;
    while bits != 0 {
        f(lane % FRAGMENTS, row.place[0] as u32 + bits.trailing_zeros());
        bits &= bits - 1;
        lane += 1;
    }
}
