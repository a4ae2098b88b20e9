//! What single-precision arithmetic may do to a position, in pixels: bounds of the textbook kind (a sum of n products is off by at most
//! n units of 2^-24 of the sum of the products' magnitudes). They widen the band in which a sample may be covered or not.

use crate::recording::View;

/// Half an ulp of 1 in single precision.
const U: f64 = 1.0 / 16777216.0;

/// Clip coordinates in f64, and a bound on the error of each in single precision.
fn clip_with_error(view: &View, position: [f32; 4]) -> [[f64; 2]; 4] {
    std::array::from_fn(|row| {
        let (mut value, mut magnitude) = (0.0, 0.0);
        for k in 0..4 {
            for column in 0..4 {
                let p = f64::from(view.projection[k * 4 + row]) * f64::from(view.modelview[column * 4 + k]) * f64::from(position[column]);
                value += p;
                magnitude += p.abs();
            }
        }
        // Four products for the product of the matrices, four for the vertex, and one more for second-order terms.
        [value, 9.0 * U * magnitude]
    })
}

/// How far the transform in single precision may move the vertex, in pixels, the larger of x and y.
pub fn transform(view: &View, position: [f32; 4]) -> f64 {
    let clip = clip_with_error(view, position);
    let [w, w_error] = clip[3];
    let axis = |k: usize| {
        let half = f64::from(view.viewport[2 + k]) / 2.0;
        let middle = f64::from(view.viewport[k]) + half;
        let ndc = clip[k][0] / w;
        half * (clip[k][1] + ndc.abs() * w_error) / w.abs() + 3.0 * U * ((half * ndc).abs() + middle.abs())
    };
    axis(0).max(axis(1))
}

/// How far rounding moves window coordinates of this size, whatever computed them.
pub fn rounding(largest: f64) -> f64 {
    16.0 * U * largest
}

/// How far a new vertex that clipping makes in single precision may be from its place, in pixels. `least_w` is the least w
/// of what is left: the new vertex is off by some units of the largest products on the edge that was cut, divided by it.
pub fn clip(view: &View, positions: &[[f32; 4]], least_w: f64) -> f64 {
    // The bound on errors is nine units of the products' magnitude; t and a + t * (b - a) add their own.
    let errors = positions.iter().flat_map(|p| clip_with_error(view, *p)).map(|[_, error]| error);
    let half = f64::from(view.viewport[2].max(view.viewport[3])) / 2.0;
    half * 3.0 * errors.fold(0.0, f64::max) / least_w
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::oracle::exact::Transform;

    #[test]
    fn the_bound_holds_for_a_transform_in_single_precision_and_is_small() {
        let mut view = View::perspective(256, 256, 0.5, 100.0);
        view.modelview[12] = 0.7;
        let exact = Transform::new(&view).unwrap();
        for i in 0..500 {
            let t = i as f32;
            let position = [t.sin() * 3.0, t.cos() * 2.0, -4.0 - (0.1 * t).sin() * 3.0, 1.0];
            let eye = [position[0] + view.modelview[12], position[1], position[2], 1.0];
            let clip: [f32; 4] = std::array::from_fn(|r| (0..4).map(|c| view.projection[c * 4 + r] * eye[c]).sum());
            let window = [0, 1].map(|k| f64::from(clip[k] / clip[3] * 128.0 + 128.0));
            let right = exact.window(&exact.clip(&[position]).unwrap().0[0]);
            let bound = transform(&view, position);
            assert!((window[0] - right[0]).abs() <= bound && (window[1] - right[1]).abs() <= bound);
            assert!(bound < 1.0 / 1024.0);
        }
    }
}
