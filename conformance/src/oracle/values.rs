//! What a sample's depth and attributes are, in f64, from the clip coordinates of the program's own vertices: homogeneous edge functions, so
//! that no clipping is needed and nothing depends on the order of operations of an implementation (3.5.1, 3.6.1).

use serde::Serialize;

use crate::recording::View;

/// A triangle, ready to be evaluated.
pub struct Triangle {
    clip: [[f64; 4]; 3],
    viewport: [f64; 4],
}

/// What a sample is made of.
#[derive(Clone, Copy, Debug)]
pub struct Weights {
    /// Perspective-correct weights of the vertices; their sum is 1.
    pub of: [f64; 3],
    /// Window z for the depth range 0 to 1, not clamped.
    pub depth: f64,
}

/// Clip coordinates of an object position, in f64.
pub fn clip_position(view: &View, position: [f32; 4]) -> [f64; 4] {
    multiply(&view.projection, multiply(&view.modelview, position.map(f64::from)))
}

/// Matrix times vector, in f64.
pub fn multiply(matrix: &[f32; 16], v: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|row| (0..4).map(|k| f64::from(matrix[k * 4 + row]) * v[k]).sum())
}

impl Triangle {
    /// From object positions.
    pub fn new(view: &View, positions: [[f32; 4]; 3]) -> Triangle {
        Triangle { clip: positions.map(|p| clip_position(view, p)), viewport: view.viewport.map(f64::from) }
    }

    /// At a window position. Meaningless where the triangle has no area.
    pub fn at(&self, window: [f64; 2]) -> Weights {
        let ndc = [0, 1].map(|k| (window[k] - self.viewport[k]) / self.viewport[2 + k] * 2.0 - 1.0);
        let moved = self.clip.map(|c| [c[0] - ndc[0] * c[3], c[1] - ndc[1] * c[3]]);
        let edge = |i: usize, j: usize| moved[i][0] * moved[j][1] - moved[j][0] * moved[i][1];
        let edges = [edge(1, 2), edge(2, 0), edge(0, 1)];
        let sum: f64 = edges.iter().sum();
        let of = edges.map(|e| e / sum);
        let at = |k: usize| of.iter().zip(&self.clip).map(|(w, c)| w * c[k]).sum::<f64>();
        Weights { of, depth: at(2) / at(3) * 0.5 + 0.5 }
    }
}

impl Weights {
    /// Interpolates a value that the vertices have.
    pub fn mix<const N: usize>(&self, values: [[f32; N]; 3]) -> [f64; N] {
        std::array::from_fn(|c| (0..3).map(|k| self.of[k] * f64::from(values[k][c])).sum())
    }
}

/// Errors of values: largest and mean.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
pub struct ValueError {
    /// Values that were compared.
    pub count: u64,
    /// Largest error.
    pub max: f64,
    /// Sum of all errors.
    pub sum: f64,
}

impl ValueError {
    /// Adds one value: what was found, what is right.
    pub fn add(&mut self, found: f64, right: f64) {
        let error = (found - right).abs();
        self.count += 1;
        self.max = if error.is_nan() { f64::INFINITY } else { self.max.max(error) };
        self.sum += error;
    }

    /// Adds another image's errors.
    pub fn merge(&mut self, other: &ValueError) {
        self.count += other.count;
        self.max = self.max.max(other.max);
        self.sum += other.sum;
    }

    /// Mean error.
    pub fn mean(&self) -> f64 {
        self.sum / self.count.max(1) as f64
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn weights_at_corners_and_middle() {
        let view = View::pixels(64, 64);
        let p = [[4.0, 4.0, -1.0, 1.0], [40.0, 4.0, 1.0, 1.0], [4.0, 60.0, 0.0, 1.0]];
        let t = Triangle::new(&view, p);
        let corner = t.at([40.0, 4.0]);
        assert!((corner.of[1] - 1.0).abs() < 1e-14 && corner.depth.abs() < 1e-14, "z = 1 is nearest in this view");
        let middle = t.at([16.0, (4.0 + 4.0 + 60.0) / 3.0]);
        assert!(middle.of.iter().all(|w| (w - 1.0 / 3.0).abs() < 1e-14));
        assert!((middle.mix([[0.0f32], [3.0], [6.0]])[0] - 3.0).abs() < 1e-13);
    }

    #[test]
    fn interpolation_is_perspective_correct() {
        // An edge from depth 1 to depth 3 whose ends are seen at the left and right border: the middle of the screen lies at a quarter.
        let view = View::perspective(64, 64, 0.5, 10.0);
        let t = Triangle::new(&view, [[-1.0, 0.0, -1.0, 1.0], [3.0, 0.0, -3.0, 1.0], [0.0, 1.0, -1.0, 1.0]]);
        let middle = t.at([32.0, 32.0]);
        assert!((middle.of[1] - 0.25).abs() < 1e-14 && middle.of[2].abs() < 1e-14);
    }

    #[test]
    fn errors_add_up() {
        let mut e = ValueError::default();
        e.add(1.0, 1.5);
        e.add(2.0, 1.0);
        assert_eq!((e.max, e.mean(), e.count), (1.0, 0.75, 2));
        e.add(f64::NAN, 1.0);
        assert_eq!(e.max, f64::INFINITY);
    }
}
