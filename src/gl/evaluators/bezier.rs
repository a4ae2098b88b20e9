//! Bézier curves and surfaces: Bernstein polynomials by stable recurrence, sums in double precision.

use super::MAX_EVAL_ORDER;

/// Bernstein weights of one parameter.
type Weights = [f64; MAX_EVAL_ORDER];

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

/// A point and its derivatives with respect to the map's own parameters in [0, 1].
pub(crate) struct Tangents {
    pub point: [f64; 4],
    pub du: [f64; 4],
    pub dv: [f64; 4],
}

impl Curve {
    /// The point at `u`, missing components from (0, 0, 0, 1).
    pub fn evaluate(&self, u: f32) -> [f32; 4] {
        let weights = bernstein(parameter(u, self.domain[0], self.domain[1]), self.order);
        let components = self.points.len() / self.order;
        let mut sum = [0.0; 4];
        for (weight, point) in weights.iter().zip(self.points.chunks_exact(components)) {
            accumulate(&mut sum, *weight, point);
        }
        complete(sum, components)
    }
}

impl Surface {
    fn components(&self) -> usize {
        self.points.len() / (self.order[0] * self.order[1])
    }

    fn sum(&self, u: &Weights, v: &Weights) -> [f64; 4] {
        let components = self.components();
        let mut sum = [0.0; 4];
        for (row, u) in self.points.chunks_exact(self.order[1] * components).zip(u) {
            for (point, v) in row.chunks_exact(components).zip(v) {
                accumulate(&mut sum, u * v, point);
            }
        }
        sum
    }

    fn parameters(&self, u: f32, v: f32) -> (f64, f64) {
        let [u1, u2, v1, v2] = self.domain;
        (parameter(u, u1, u2), parameter(v, v1, v2))
    }

    /// The point at `(u, v)`, missing components from (0, 0, 0, 1).
    pub fn evaluate(&self, u: f32, v: f32) -> [f32; 4] {
        let (u, v) = self.parameters(u, v);
        complete(self.sum(&bernstein(u, self.order[0]), &bernstein(v, self.order[1])), self.components())
    }

    /// The point at `(u, v)` with both tangents.
    pub fn tangents(&self, u: f32, v: f32) -> Tangents {
        let (u, v) = self.parameters(u, v);
        let (bu, bv) = (bernstein(u, self.order[0]), bernstein(v, self.order[1]));
        let (du, dv) = (derivative(u, self.order[0]), derivative(v, self.order[1]));
        Tangents { point: self.sum(&bu, &bv), du: self.sum(&du, &bv), dv: self.sum(&bu, &dv) }
    }
}

fn parameter(u: f32, u1: f32, u2: f32) -> f64 {
    (u as f64 - u1 as f64) / (u2 as f64 - u1 as f64)
}

fn accumulate(sum: &mut [f64; 4], weight: f64, point: &[f32]) {
    for (sum, &coordinate) in sum.iter_mut().zip(point) {
        *sum += weight * coordinate as f64;
    }
}

fn complete(sum: [f64; 4], components: usize) -> [f32; 4] {
    std::array::from_fn(|i| if i < components { sum[i] as f32 } else { (i == 3) as u8 as f32 })
}

/// The `order` Bernstein polynomials of degree `order - 1` at `t`.
fn bernstein(t: f64, order: usize) -> Weights {
    let mut weights = [0.0; MAX_EVAL_ORDER];
    weights[0] = 1.0;
    for degree in 1..order {
        for i in (0..=degree).rev() {
            let left = if i > 0 { weights[i - 1] } else { 0.0 };
            weights[i] = t * left + (1.0 - t) * weights[i];
        }
    }
    weights
}

/// Their derivatives: `n (B[i-1, n-1] - B[i, n-1])`.
fn derivative(t: f64, order: usize) -> Weights {
    let mut weights = [0.0; MAX_EVAL_ORDER];
    if order < 2 {
        return weights;
    }
    let degree = order - 1;
    let lower = bernstein(t, degree);
    for i in 0..order {
        let left = if i > 0 { lower[i - 1] } else { 0.0 };
        let right = if i < degree { lower[i] } else { 0.0 };
        weights[i] = degree as f64 * (left - right);
    }
    weights
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
    fn weights_of_the_highest_order_sum_to_one() {
        for t in [0.0, 0.1, 0.5, 0.93, 1.0] {
            let sum: f64 = bernstein(t, MAX_EVAL_ORDER).iter().sum();
            assert!((sum - 1.0).abs() < 1e-14, "{sum}");
            let slope: f64 = derivative(t, MAX_EVAL_ORDER).iter().sum();
            assert!(slope.abs() < 1e-12, "{slope}");
        }
    }

    #[test]
    fn tangents_of_a_bilinear_surface_are_its_edges() {
        let surface = Surface {
            order: [2, 2],
            domain: [0.0, 1.0, 0.0, 1.0],
            points: vec![0.0, 0.0, 0.0, 0.0, 3.0, 0.0, 2.0, 0.0, 0.0, 2.0, 3.0, 0.0],
        };
        let tangents = surface.tangents(0.25, 0.5);
        assert_eq!(tangents.point, [0.5, 1.5, 0.0, 0.0]);
        assert_eq!(tangents.du, [2.0, 0.0, 0.0, 0.0]);
        assert_eq!(tangents.dv, [0.0, 3.0, 0.0, 0.0]);
    }
}
