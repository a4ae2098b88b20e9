//! Bézier curves and surfaces in single precision. The order of operations is a generalised Horner scheme for points and
//! bilinear de Casteljau steps where tangents are wanted, which is what OSMesa computes, so that meshes cover the same
//! pixels.

use super::MAX_EVAL_ORDER;

/// A one-dimensional map.
#[derive(Clone)]
pub(crate) struct Curve {
    /// Number of control points.
    pub order: usize,
    /// u1, u2
    pub domain: [f32; 2],
    /// Control points, tightly packed.
    pub points: Vec<f32>,
}

/// A two-dimensional map.
#[derive(Clone)]
pub(crate) struct Surface {
    /// Control points in u, in v.
    pub order: [usize; 2],
    /// u1, u2, v1, v2
    pub domain: [f32; 4],
    /// Control points, tightly packed, v fastest.
    pub points: Vec<f32>,
}

/// A point and its tangents, up to a positive factor each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Tangents {
    pub point: [f32; 4],
    pub du: [f32; 4],
    pub dv: [f32; 4],
}

impl Curve {
    /// The point at `u`, missing components from (0, 0, 0, 1).
    pub fn evaluate(&self, u: f32) -> [f32; 4] {
        let components = self.points.len() / self.order;
        let t = parameter(u, self.domain[0], self.domain[1]);
        let point = |i: usize| vector(&self.points[i * components..][..components]);
        complete(horner(t, self.order, point), components)
    }
}

impl Surface {
    fn components(&self) -> usize {
        self.points.len() / (self.order[0] * self.order[1])
    }

    fn parameters(&self, u: f32, v: f32) -> (f32, f32) {
        let [u1, u2, v1, v2] = self.domain;
        (parameter(u, u1, u2), parameter(v, v1, v2))
    }

    fn point(&self, i: usize, j: usize) -> [f32; 4] {
        let components = self.components();
        vector(&self.points[(i * self.order[1] + j) * components..][..components])
    }

    /// The point at `(u, v)`, missing components from (0, 0, 0, 1). The direction of lower order is evaluated first.
    pub fn evaluate(&self, u: f32, v: f32) -> [f32; 4] {
        let (u, v) = self.parameters(u, v);
        let [uorder, vorder] = self.order;
        let point = if vorder > uorder {
            horner(v, vorder, |j| horner(u, uorder, |i| self.point(i, j)))
        } else {
            horner(u, uorder, |i| horner(v, vorder, |j| self.point(i, j)))
        };
        complete(point, self.components())
    }

    /// The point at `(u, v)` with both tangents: steps in both directions until one has two points left, then steps in the
    /// other one.
    pub fn tangents(&self, u: f32, v: f32) -> Tangents {
        let (u, v) = self.parameters(u, v);
        // A direction of one point has no extent: the point twice.
        let order = self.order.map(|n| n.max(2));
        let stride = order[1];
        let mut grid: Vec<[f32; 4]> = Vec::with_capacity(order[0] * stride);
        for i in 0..order[0] {
            grid.extend((0..stride).map(|j| self.point(i.min(self.order[0] - 1), j.min(self.order[1] - 1))));
        }
        let [mut rows, mut columns] = order;
        while rows > 2 && columns > 2 {
            for i in 0..rows - 1 {
                for j in 0..columns {
                    grid[i * stride + j] = mix(grid[i * stride + j], grid[(i + 1) * stride + j], u);
                }
                for j in 0..columns - 1 {
                    grid[i * stride + j] = mix(grid[i * stride + j], grid[i * stride + j + 1], v);
                }
            }
            (rows, columns) = (rows - 1, columns - 1);
        }
        let at = |i: usize, j: usize| grid[i * stride + j];
        match (rows, columns) {
            (2, 2) => {
                let [a, b, c, d] = [at(0, 0), at(0, 1), at(1, 0), at(1, 1)];
                Tangents {
                    point: mix(mix(a, b, v), mix(c, d, v), u),
                    du: mix(minus(c, a), minus(d, b), v),
                    dv: mix(minus(b, a), minus(d, c), u),
                }
            }
            (2, _) => {
                let across: Vec<[f32; 4]> = (0..columns).map(|j| minus(at(1, j), at(0, j))).collect();
                let along: Vec<[f32; 4]> = (0..columns).map(|j| mix(at(0, j), at(1, j), u)).collect();
                let [p, q] = casteljau(along, v);
                let [r, s] = casteljau(across, v);
                Tangents { point: mix(p, q, v), du: mix(r, s, v), dv: minus(q, p) }
            }
            _ => {
                let across: Vec<[f32; 4]> = (0..rows).map(|i| minus(at(i, 1), at(i, 0))).collect();
                let along: Vec<[f32; 4]> = (0..rows).map(|i| mix(at(i, 0), at(i, 1), v)).collect();
                let [p, q] = casteljau(along, u);
                let [r, s] = casteljau(across, u);
                Tangents { point: mix(p, q, u), du: minus(q, p), dv: mix(r, s, u) }
            }
        }
    }
}

fn parameter(u: f32, u1: f32, u2: f32) -> f32 {
    (u - u1) * (1.0 / (u2 - u1))
}

fn vector(components: &[f32]) -> [f32; 4] {
    std::array::from_fn(|k| components.get(k).copied().unwrap_or(0.0))
}

fn complete(point: [f32; 4], components: usize) -> [f32; 4] {
    std::array::from_fn(|k| if k < components { point[k] } else { (k == 3) as u8 as f32 })
}

fn mix(a: [f32; 4], b: [f32; 4], t: f32) -> [f32; 4] {
    let s = 1.0 - t;
    std::array::from_fn(|k| s * a[k] + t * b[k])
}

fn minus(a: [f32; 4], b: [f32; 4]) -> [f32; 4] {
    std::array::from_fn(|k| a[k] - b[k])
}

/// De Casteljau's steps until two points are left.
fn casteljau(mut points: Vec<[f32; 4]>, t: f32) -> [[f32; 4]; 2] {
    while points.len() > 2 {
        for i in 0..points.len() - 1 {
            points[i] = mix(points[i], points[i + 1], t);
        }
        points.pop();
    }
    [points[0], points[1]]
}

/// The point at `t` of the curve of `order` control points: the sum of binomial(n, i) t^i (1 - t)^(n - i) p_i, nested in
/// 1 - t.
fn horner(t: f32, order: usize, point: impl Fn(usize) -> [f32; 4]) -> [f32; 4] {
    if order < 2 {
        return point(0);
    }
    let order = order.min(MAX_EVAL_ORDER);
    let s = 1.0 - t;
    let mut binomial = (order - 1) as f32;
    let (first, second) = (point(0), point(1));
    let mut sum: [f32; 4] = std::array::from_fn(|k| s * first[k] + binomial * t * second[k]);
    let mut power = t * t;
    for i in 2..order {
        binomial *= (order - i) as f32;
        binomial *= 1.0 / i as f32;
        let next = point(i);
        for k in 0..4 {
            sum[k] = s * sum[k] + binomial * power * next[k];
        }
        power *= t;
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_curve_runs_through_its_ends_and_the_middle_of_a_parabola() {
        let curve = Curve { order: 3, domain: [2.0, 4.0], points: vec![0.0, 0.0, 1.0, 2.0, 2.0, 0.0] };
        assert_eq!(curve.evaluate(2.0), [0.0, 0.0, 0.0, 1.0]);
        assert_eq!(curve.evaluate(4.0), [2.0, 0.0, 0.0, 1.0]);
        assert_eq!(curve.evaluate(3.0), [1.0, 1.0, 0.0, 1.0]);
    }

    #[test]
    fn a_constant_curve_of_the_highest_order_stays_constant() {
        let curve = Curve { order: MAX_EVAL_ORDER, domain: [0.0, 1.0], points: vec![3.0; MAX_EVAL_ORDER] };
        for u in [0.0, 0.1, 0.5, 0.93, 1.0] {
            let x = curve.evaluate(u)[0];
            assert!((x - 3.0).abs() < 1e-4, "{x} at {u}");
        }
    }

    #[test]
    fn tangents_of_a_bilinear_surface_are_its_edges() {
        let points = vec![0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 2.0, 0.0, 0.0, 2.0, 3.0, 0.0];
        let tangents = Surface { order: [2, 2], domain: [0.0, 1.0, 0.0, 1.0], points }.tangents(0.25, 0.5);
        assert_eq!(tangents.point, [0.5, 1.5, 0.0, 0.0]);
        assert_eq!(tangents.du, [2.0, 0.0, 0.0, 0.0]);
        assert_eq!(tangents.dv, [0.0, 3.0, 0.0, 0.0]);
    }

    #[test]
    fn tangents_meet_differences_of_points_for_all_orders() {
        for order in [[2, 4], [4, 2], [3, 3], [5, 3], [3, 6], [1, 4]] {
            let count = order[0] * order[1];
            let points = (0..count * 3).map(|k| ((k * 7919) % 31) as f32 / 31.0).collect();
            let surface = Surface { order, domain: [0.0, 1.0, 0.0, 1.0], points };
            let t = surface.tangents(0.4, 0.6);
            let h = 1e-2;
            let difference = |a: [f32; 4], b: [f32; 4]| glam::Vec3::from_slice(&minus(b, a)[..3]).normalize_or_zero();
            let du = difference(surface.evaluate(0.4 - h, 0.6), surface.evaluate(0.4 + h, 0.6));
            let dv = difference(surface.evaluate(0.4, 0.6 - h), surface.evaluate(0.4, 0.6 + h));
            let close = |a: [f32; 4], b: glam::Vec3| (glam::Vec3::from_slice(&a[..3]).normalize_or_zero() - b).length() < 1e-2;
            assert!(close(t.du, du) && close(t.dv, dv), "{order:?}: {t:?} {du} {dv}");
            let p = surface.evaluate(0.4, 0.6);
            assert!((0..3).all(|k| (t.point[k] - p[k]).abs() < 1e-5), "{order:?}");
        }
    }
}
