//! Evaluators (5.1): maps, grids, and the coordinates and vertices that come from them.

pub mod bezier;
pub mod eval;

use super::Context;
use super::enable::index_below;
use super::enums::*;
use bezier::{Curve, Surface};

/// Highest order of a map (GL_MAX_EVAL_ORDER).
pub const MAX_EVAL_ORDER: usize = 30;
/// Components of a control point of each target, GL_MAP1_COLOR_4 (or GL_MAP2_COLOR_4) first.
pub(crate) const COMPONENTS: [usize; 9] = [4, 1, 3, 1, 2, 3, 4, 3, 4];

/// The control points of all targets.
pub(crate) struct Maps {
    pub curves: [Curve; 9],
    pub surfaces: [Surface; 9],
}

impl Default for Maps {
    fn default() -> Maps {
        // One control point: the initial value of the attribute.
        let initial = |index: usize| -> Vec<f32> {
            match index {
                0 => vec![1.0; 4],
                1 => vec![1.0],
                2 => vec![0.0, 0.0, 1.0],
                6 | 8 => vec![0.0, 0.0, 0.0, 1.0],
                _ => vec![0.0; COMPONENTS[index]],
            }
        };
        Maps {
            curves: std::array::from_fn(|i| Curve { order: 1, domain: [0.0, 1.0], points: initial(i) }),
            surfaces: std::array::from_fn(|i| Surface { order: [1, 1], domain: [0.0, 1.0, 0.0, 1.0], points: initial(i) }),
        }
    }
}

/// Number of values that glMap1 reads from the application; 0 where its arguments are an error.
pub fn map1_values(target: GLenum, stride: i32, order: i32) -> usize {
    match index_below(target, GL_MAP1_COLOR_4, 9) {
        Some(index) if legal(order, stride, COMPONENTS[index]) => (order as usize - 1) * stride as usize + COMPONENTS[index],
        _ => 0,
    }
}

/// Number of values that glMap2 reads from the application; 0 where its arguments are an error.
pub fn map2_values(target: GLenum, ustride: i32, uorder: i32, vstride: i32, vorder: i32) -> usize {
    match index_below(target, GL_MAP2_COLOR_4, 9) {
        Some(index) if legal(uorder, ustride, COMPONENTS[index]) && legal(vorder, vstride, COMPONENTS[index]) => {
            (uorder as usize - 1) * ustride as usize + (vorder as usize - 1) * vstride as usize + COMPONENTS[index]
        }
        _ => 0,
    }
}

fn legal(order: i32, stride: i32, components: usize) -> bool {
    (1..=MAX_EVAL_ORDER as i32).contains(&order) && stride >= components as i32
}

impl Context {
    /// glMap1{fd}. `points` holds at least [`map1_values`] values; `stride` counts values.
    pub fn map1(&mut self, target: GLenum, u1: f32, u2: f32, stride: i32, order: i32, points: &[f32]) {
        let Some(index) = index_below(target, GL_MAP1_COLOR_4, 9) else {
            return self.map_error(GL_INVALID_ENUM, "glMap1");
        };
        let count = map1_values(target, stride, order);
        if u1 == u2 || count == 0 || points.len() < count {
            return self.map_error(GL_INVALID_VALUE, "glMap1");
        }
        let components = COMPONENTS[index];
        let points = points.chunks(stride as usize).take(order as usize).flat_map(|p| &p[..components]).copied().collect();
        self.set_curve(index, Curve { order: order as usize, domain: [u1, u2], points });
    }

    /// glMap2{fd}. `points` holds at least [`map2_values`] values; strides count values.
    pub fn map2(
        &mut self,
        target: GLenum,
        u1: f32,
        u2: f32,
        ustride: i32,
        uorder: i32,
        v1: f32,
        v2: f32,
        vstride: i32,
        vorder: i32,
        points: &[f32],
    ) {
        let Some(index) = index_below(target, GL_MAP2_COLOR_4, 9) else {
            return self.map_error(GL_INVALID_ENUM, "glMap2");
        };
        let count = map2_values(target, ustride, uorder, vstride, vorder);
        if u1 == u2 || v1 == v2 || count == 0 || points.len() < count {
            return self.map_error(GL_INVALID_VALUE, "glMap2");
        }
        let components = COMPONENTS[index];
        let order = [uorder as usize, vorder as usize];
        let mut packed = Vec::with_capacity(order[0] * order[1] * components);
        for i in 0..order[0] {
            for j in 0..order[1] {
                packed.extend_from_slice(&points[i * ustride as usize + j * vstride as usize..][..components]);
            }
        }
        self.set_surface(index, Surface { order, domain: [u1, u2, v1, v2], points: packed });
    }

    fn map_error(&mut self, error: GLenum, what: &'static str) {
        if self.compile(move |cx| cx.map_error(error, what)) || self.inside_begin_end() {
            return;
        }
        self.set_error(error, what);
    }

    fn set_curve(&mut self, index: usize, curve: Curve) {
        let copy = self.lists.builder.is_some().then(|| curve.clone());
        if let Some(copy) = copy {
            self.compile(move |cx| cx.set_curve(index, copy.clone()));
            return;
        }
        if self.inside_begin_end() || self.other_unit_active("glMap1") {
            return;
        }
        self.maps.curves[index] = curve;
    }

    fn set_surface(&mut self, index: usize, surface: Surface) {
        let copy = self.lists.builder.is_some().then(|| surface.clone());
        if let Some(copy) = copy {
            self.compile(move |cx| cx.set_surface(index, copy.clone()));
            return;
        }
        if self.inside_begin_end() || self.other_unit_active("glMap2") {
            return;
        }
        self.maps.surfaces[index] = surface;
    }

    /// Maps belong to texture unit 0 (2.7 of version 1.3 on).
    fn other_unit_active(&mut self, what: &str) -> bool {
        let other = self.state.texture.active != 0;
        if other {
            self.set_error(GL_INVALID_OPERATION, what);
        }
        other
    }

    /// glMapGrid1{fd}.
    pub fn map_grid1(&mut self, un: i32, u1: f32, u2: f32) {
        if self.compile(move |cx| cx.map_grid1(un, u1, u2)) || self.inside_begin_end() {
            return;
        }
        if un < 1 {
            return self.set_error(GL_INVALID_VALUE, "glMapGrid1");
        }
        self.state.eval.grid1_divisions = un;
        self.state.eval.grid1_domain = [u1, u2];
    }

    /// glMapGrid2{fd}.
    pub fn map_grid2(&mut self, un: i32, u1: f32, u2: f32, vn: i32, v1: f32, v2: f32) {
        if self.compile(move |cx| cx.map_grid2(un, u1, u2, vn, v1, v2)) || self.inside_begin_end() {
            return;
        }
        if un < 1 || vn < 1 {
            return self.set_error(GL_INVALID_VALUE, "glMapGrid2");
        }
        self.state.eval.grid2_divisions = [un, vn];
        self.state.eval.grid2_domain = [u1, u2, v1, v2];
    }

    /// glGetMap{ifd}v: control points, order or domain; nothing after an error. Integers are rounded.
    pub fn get_map(&mut self, target: GLenum, query: GLenum) -> Option<Vec<f32>> {
        if self.inside_begin_end() {
            return None;
        }
        let curve = index_below(target, GL_MAP1_COLOR_4, 9).map(|i| &self.maps.curves[i]);
        let surface = index_below(target, GL_MAP2_COLOR_4, 9).map(|i| &self.maps.surfaces[i]);
        let answer = match (query, curve, surface) {
            (GL_COEFF, Some(curve), _) => Some(curve.points.clone()),
            (GL_COEFF, _, Some(surface)) => Some(surface.points.clone()),
            (GL_ORDER, Some(curve), _) => Some(vec![curve.order as f32]),
            (GL_ORDER, _, Some(surface)) => Some(surface.order.iter().map(|&n| n as f32).collect()),
            (GL_DOMAIN, Some(curve), _) => Some(curve.domain.to_vec()),
            (GL_DOMAIN, _, Some(surface)) => Some(surface.domain.to_vec()),
            _ => None,
        };
        if answer.is_none() {
            self.set_error(GL_INVALID_ENUM, "glGetMap");
        }
        answer
    }
}
