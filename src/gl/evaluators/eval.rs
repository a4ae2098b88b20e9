//! EvalCoord, EvalPoint and EvalMesh.

use super::bezier::Tangents;
use crate::gl::enums::*;
use crate::gl::{Context, Parity};

/// Attribute slots (`layout::ATTRIBUTES`).
const NORMAL: usize = 2;
const COLOR: usize = 3;
const TEX_COORD: usize = 8;
/// Indices of maps.
const MAP_COLOR: usize = 0;
const MAP_NORMAL: usize = 2;
const MAP_TEX_COORDS: std::ops::RangeInclusive<usize> = 3..=6;
const MAP_VERTEX_3: usize = 7;
const MAP_VERTEX_4: usize = 8;
/// Most vertices of one EvalMesh: more is GL_OUT_OF_MEMORY, not a hang.
const MESH_LIMIT: i64 = 1 << 22;

impl Context {
    /// glEvalCoord1{fd}[v].
    pub fn eval_coord1(&mut self, u: f32) {
        if self.compile(move |cx| cx.eval_coord1(u)) {
            return;
        }
        let on = self.state.eval.map1;
        let Some(vertex) = vertex_map(&on) else { return };
        let at = |cx: &Context, map: usize| cx.maps.curves[map].evaluate(u);
        let texture = MAP_TEX_COORDS.rev().find(|&map| on[map]).map(|map| at(self, map));
        let color = on[MAP_COLOR].then(|| at(self, MAP_COLOR));
        let normal = on[MAP_NORMAL].then(|| at(self, MAP_NORMAL));
        let position = at(self, vertex);
        self.evaluated_vertex(color, normal, texture, position);
    }

    /// glEvalCoord2{fd}[v].
    pub fn eval_coord2(&mut self, u: f32, v: f32) {
        if self.compile(move |cx| cx.eval_coord2(u, v)) {
            return;
        }
        let on = self.state.eval.map2;
        let Some(vertex) = vertex_map(&on) else { return };
        let at = |cx: &Context, map: usize| cx.maps.surfaces[map].evaluate(u, v);
        let texture = MAP_TEX_COORDS.rev().find(|&map| on[map]).map(|map| at(self, map));
        let color = on[MAP_COLOR].then(|| at(self, MAP_COLOR));
        let (normal, position) = if self.state.eval.auto_normal {
            let tangents = self.maps.surfaces[vertex].tangents(u, v);
            let [x, y, z, w] = tangents.point;
            let homogeneous = vertex == MAP_VERTEX_4;
            (Some(normal_of(&tangents, homogeneous)), [x, y, z, if homogeneous { w } else { 1.0 }])
        } else {
            (on[MAP_NORMAL].then(|| at(self, MAP_NORMAL)), at(self, vertex))
        };
        self.evaluated_vertex(color, normal, texture, position);
    }

    /// A vertex with evaluated attributes; the current values stay what they were.
    fn evaluated_vertex(&mut self, color: Option<[f32; 4]>, normal: Option<[f32; 4]>, texture: Option<[f32; 4]>, position: [f32; 4]) {
        if !self.immediate.is_inside() {
            return;
        }
        let given = [(COLOR, color), (NORMAL, normal), (TEX_COORD, texture)];
        let before = given.map(|(slot, _)| self.state.current.attributes[slot]);
        for (slot, value) in given {
            if let Some(value) = value {
                self.attribute(slot, value);
            }
        }
        let [x, y, z, w] = position;
        self.vertex(x, y, z, w);
        for ((slot, value), before) in given.into_iter().zip(before) {
            if value.is_some() {
                self.attribute(slot, before);
            }
        }
    }

    /// glEvalPoint1.
    pub fn eval_point1(&mut self, i: i32) {
        if self.compile(move |cx| cx.eval_point1(i)) {
            return;
        }
        let [u1, u2] = self.state.eval.grid1_domain;
        self.eval_coord1(grid(i, self.state.eval.grid1_divisions, u1, u2));
    }

    /// glEvalPoint2.
    pub fn eval_point2(&mut self, i: i32, j: i32) {
        if self.compile(move |cx| cx.eval_point2(i, j)) {
            return;
        }
        let [u1, u2, v1, v2] = self.state.eval.grid2_domain;
        let [un, vn] = self.state.eval.grid2_divisions;
        self.eval_coord2(grid(i, un, u1, u2), grid(j, vn, v1, v2));
    }

    /// glEvalMesh1.
    pub fn eval_mesh1(&mut self, mode: GLenum, i1: i32, i2: i32) {
        if self.compile(move |cx| cx.eval_mesh1(mode, i1, i2)) || self.inside_begin_end() {
            return;
        }
        let primitive = match mode {
            GL_POINT => GL_POINTS,
            GL_LINE => GL_LINE_STRIP,
            _ => return self.set_error(GL_INVALID_ENUM, "glEvalMesh1"),
        };
        if vertex_map(&self.state.eval.map1).is_none() {
            return;
        }
        if i2 as i64 - i1 as i64 > MESH_LIMIT {
            return self.set_error(GL_OUT_OF_MEMORY, "glEvalMesh1");
        }
        let [u1, u2] = self.state.eval.grid1_domain;
        let steps = Steps::new(i1, i2, self.state.eval.grid1_divisions, u1, u2, self.config.parity);
        self.begin(primitive);
        steps.for_each(|u| self.eval_coord1(u));
        self.end();
    }

    /// glEvalMesh2.
    pub fn eval_mesh2(&mut self, mode: GLenum, i1: i32, i2: i32, j1: i32, j2: i32) {
        if self.compile(move |cx| cx.eval_mesh2(mode, i1, i2, j1, j2)) || self.inside_begin_end() {
            return;
        }
        if !matches!(mode, GL_POINT | GL_LINE | GL_FILL) {
            return self.set_error(GL_INVALID_ENUM, "glEvalMesh2");
        }
        if vertex_map(&self.state.eval.map2).is_none() {
            return;
        }
        let size = [i2 as i64 - i1 as i64 + 1, j2 as i64 - j1 as i64 + 1].map(|n| n.max(0));
        if size[0].saturating_mul(size[1]) > MESH_LIMIT || size.into_iter().any(|n| n > MESH_LIMIT) {
            return self.set_error(GL_OUT_OF_MEMORY, "glEvalMesh2");
        }
        let eval = &self.state.eval;
        let ([u1, u2, v1, v2], [un, vn]) = (eval.grid2_domain, eval.grid2_divisions);
        let parity = self.config.parity;
        let (us, vs) = (Steps::new(i1, i2, un, u1, u2, parity), Steps::new(j1, j2, vn, v1, v2, parity));
        match mode {
            GL_POINT => {
                self.begin(GL_POINTS);
                vs.for_each(|v| us.clone().for_each(|u| self.eval_coord2(u, v)));
                self.end();
            }
            GL_LINE => {
                for v in vs.clone() {
                    self.begin(GL_LINE_STRIP);
                    us.clone().for_each(|u| self.eval_coord2(u, v));
                    self.end();
                }
                for u in us {
                    self.begin(GL_LINE_STRIP);
                    vs.clone().for_each(|v| self.eval_coord2(u, v));
                    self.end();
                }
            }
            _ => {
                // Where nobody sees the difference, along the diagonal that OSMesa takes.
                let plain = self.state.lighting.shade_model == GL_SMOOTH && self.state.polygon.mode == [GL_FILL; 2];
                for (v, next) in vs.clone().zip(vs.skip(1)) {
                    self.begin(if plain { GL_TRIANGLE_STRIP } else { GL_QUAD_STRIP });
                    for u in us.clone() {
                        self.eval_coord2(u, v);
                        self.eval_coord2(u, next);
                    }
                    self.end();
                }
            }
        }
    }
}

/// The coordinates of grid points `first..=last` of `n` divisions of a domain.
#[derive(Clone)]
struct Steps {
    next: i64,
    last: i64,
    n: i64,
    value: f32,
    step: f32,
    /// The end of the domain, where it is met exactly.
    end: Option<f32>,
}

impl Steps {
    fn new(first: i32, last: i32, n: i32, u1: f32, u2: f32, parity: Parity) -> Steps {
        let step = (u2 - u1) / n as f32;
        let end = (parity == Parity::Specification).then_some(u2);
        Steps { next: first.into(), last: last.into(), n: n.into(), value: u1 + first as f32 * step, step, end }
    }
}

impl Iterator for Steps {
    type Item = f32;

    /// Adds step after step, as OSMesa does; the end of the domain is met exactly (5.1), unless OSMesa's rules hold.
    fn next(&mut self) -> Option<f32> {
        if self.next > self.last {
            return None;
        }
        let value = self.end.filter(|_| self.next == self.n).unwrap_or(self.value);
        self.next += 1;
        self.value += self.step;
        Some(value)
    }
}

/// The map that makes vertices, if one is on.
fn vertex_map(on: &[bool; 9]) -> Option<usize> {
    [MAP_VERTEX_4, MAP_VERTEX_3].into_iter().find(|&map| on[map])
}

/// Grid coordinate `i` of `n` divisions; both ends are met exactly (5.1).
fn grid(i: i32, n: i32, first: f32, last: f32) -> f32 {
    if i == n { last } else { i as f32 * ((last - first) / n as f32) + first }
}

/// Unit normal of a surface point (GL_AUTO_NORMAL).
fn normal_of(t: &Tangents, homogeneous: bool) -> [f32; 4] {
    let project = |d: &[f32; 4]| -> [f32; 3] {
        if homogeneous {
            // Derivative of x / w up to the factor 1 / w².
            std::array::from_fn(|k| d[k] * t.point[3] - d[3] * t.point[k])
        } else {
            [d[0], d[1], d[2]]
        }
    };
    let (u, v) = (project(&t.du), project(&t.dv));
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let squared = n[0] * n[0] + n[1] * n[1] + n[2] * n[2];
    let scale = if squared > 0.0 { 1.0 / squared.sqrt() } else { 1.0 };
    [n[0] * scale, n[1] * scale, n[2] * scale, 1.0]
}
