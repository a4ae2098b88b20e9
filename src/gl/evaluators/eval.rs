//! EvalCoord, EvalPoint and EvalMesh.

use super::bezier::Tangents;
use crate::gl::Context;
use crate::gl::enums::*;

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
        let normal = if self.state.eval.auto_normal {
            Some(normal_of(&self.maps.surfaces[vertex].tangents(u, v), vertex == MAP_VERTEX_4))
        } else {
            on[MAP_NORMAL].then(|| at(self, MAP_NORMAL))
        };
        let position = at(self, vertex);
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
        self.begin(primitive);
        for i in i1..=i2 {
            self.eval_point1(i);
        }
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
        match mode {
            GL_POINT => {
                self.begin(GL_POINTS);
                for j in j1..=j2 {
                    for i in i1..=i2 {
                        self.eval_point2(i, j);
                    }
                }
                self.end();
            }
            GL_LINE => {
                for j in j1..=j2 {
                    self.begin(GL_LINE_STRIP);
                    (i1..=i2).for_each(|i| self.eval_point2(i, j));
                    self.end();
                }
                for i in i1..=i2 {
                    self.begin(GL_LINE_STRIP);
                    (j1..=j2).for_each(|j| self.eval_point2(i, j));
                    self.end();
                }
            }
            _ => {
                for j in j1..j2 {
                    self.begin(GL_QUAD_STRIP);
                    for i in i1..=i2 {
                        self.eval_point2(i, j);
                        self.eval_point2(i, j + 1);
                    }
                    self.end();
                }
            }
        }
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
    let project = |d: &[f64; 4]| -> [f64; 3] {
        if homogeneous {
            // Derivative of x / w up to the factor 1 / w².
            std::array::from_fn(|i| d[i] * t.point[3] - t.point[i] * d[3])
        } else {
            [d[0], d[1], d[2]]
        }
    };
    let (u, v) = (glam::DVec3::from(project(&t.du)), glam::DVec3::from(project(&t.dv)));
    let normal = u.cross(v).normalize_or_zero().as_vec3();
    [normal.x, normal.y, normal.z, 1.0]
}
