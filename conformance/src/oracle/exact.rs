//! Exact transformation: single-precision numbers are integers times a power of two, and homogeneous coordinates may be scaled by any positive
//! number, so products of matrices and vertices need integers only.

use num_bigint::{BigInt, Sign};

use crate::recording::View;

/// x, y, z, w, one, and the distances from the user clip planes, all times the same positive number: `one` says which.
pub type Homogeneous = Vec<BigInt>;

/// Where the distances from the user clip planes begin in a [`Homogeneous`].
pub const USER: usize = 5;

/// Mantissa and exponent of a finite number.
fn decompose(v: f32) -> (i64, i32) {
    let bits = v.to_bits();
    let (exponent, mantissa) = ((bits >> 23 & 0xff) as i32, i64::from(bits & 0x7f_ffff));
    let (mantissa, exponent) = if exponent == 0 { (mantissa, -149) } else { (mantissa | 0x80_0000, exponent - 150) };
    (if v.is_sign_negative() { -mantissa } else { mantissa }, exponent)
}

/// Integers and the exponent of the power of two that makes them `values`; `None` if one is not finite.
fn integers(values: &[f32]) -> Option<(Vec<BigInt>, i32)> {
    if !values.iter().all(|v| v.is_finite()) {
        return None;
    }
    let lowest = values.iter().filter(|v| **v != 0.0).map(|v| decompose(*v).1).min().unwrap_or(0);
    let integer = |v: &f32| {
        let (mantissa, exponent) = decompose(*v);
        BigInt::from(mantissa) << (exponent.max(lowest) - lowest) as usize
    };
    Some((values.iter().map(integer).collect(), lowest))
}

/// The product of projection and model-view matrix, and the clip planes' rows, ready for vertices.
pub struct Transform {
    /// Rows of coefficients for x, y, z, w and the clip planes' distances of an object position.
    rows: Vec<[BigInt; 4]>,
    /// The first four rows are these integers times two to this power.
    exponent: i32,
    viewport: [f64; 4],
}

impl Transform {
    /// `None` if a matrix or plane is not finite.
    pub fn new(view: &View) -> Option<Transform> {
        let ((p, p_exponent), (m, m_exponent)) = (integers(&view.projection)?, integers(&view.modelview)?);
        let product = |left: &dyn Fn(usize) -> BigInt| -> [BigInt; 4] {
            std::array::from_fn(|column| (0..4).map(|k| left(k) * &m[column * 4 + k]).sum())
        };
        let mut rows: Vec<[BigInt; 4]> = (0..4).map(|row| product(&|k| p[k * 4 + row].clone())).collect();
        for plane in &view.clip_planes {
            // Only the sign and the proportion of distances matter, so the power of two may be dropped.
            let (plane, _) = integers(plane)?;
            rows.push(product(&|k| plane[k].clone()));
        }
        Some(Transform { rows, exponent: p_exponent + m_exponent, viewport: view.viewport.map(f64::from) })
    }

    /// The clip coordinates of a primitive's vertices, and the exponent of the power of two that they are to be multiplied by; `None` if
    /// one is not finite.
    pub fn clip(&self, positions: &[[f32; 4]]) -> Option<(Vec<Homogeneous>, i32)> {
        let (numbers, exponent) = integers(positions.as_flattened())?;
        let vertex = |v: &[BigInt]| {
            let mut all: Homogeneous = self.rows.iter().map(|row| row.iter().zip(v).map(|(a, b)| a * b).sum()).collect();
            all.insert(4, BigInt::from(1));
            all
        };
        Some((numbers.chunks_exact(4).map(vertex).collect(), self.exponent + exponent))
    }

    /// Window coordinates of clip coordinates with a positive w, to the precision of f64.
    pub fn window(&self, v: &Homogeneous) -> [f64; 2] {
        let [x, y, w, h] = self.viewport;
        [x + w * (ratio(&v[0], &v[3]) + 1.0) / 2.0, y + h * (ratio(&v[1], &v[3]) + 1.0) / 2.0]
    }
}

/// The quotient to the precision of f64 (60 bits before rounding), for a denominator that is not zero.
pub fn ratio(numerator: &BigInt, denominator: &BigInt) -> f64 {
    // At least 60 bits of quotient.
    let shift = 60 + denominator.bits() as i64 - numerator.bits() as i64;
    let quotient = if shift >= 0 { (numerator << shift as usize) / denominator } else { numerator / (denominator << (-shift) as usize) };
    let (sign, digits) = quotient.to_u64_digits();
    let magnitude = digits.iter().rev().fold(0.0, |sum, &d| sum * 18446744073709551616.0 + d as f64);
    let scaled = scale(magnitude, -shift);
    if sign == Sign::Minus { -scaled } else { scaled }
}

/// v times two to the power n, without overflow on the way.
pub fn scale(mut v: f64, mut n: i64) -> f64 {
    while n < -1000 {
        (v, n) = (v * 2f64.powi(-1000), n + 1000);
    }
    while n > 1000 {
        (v, n) = (v * 2f64.powi(1000), n - 1000);
    }
    v * 2f64.powi(n as i32)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::recording::IDENTITY;

    #[test]
    fn numbers_of_any_size_decompose_exactly() {
        for v in [0.0f32, -0.0, 1.0, -3.75, 1e30, -1e-30, f32::MAX, f32::MIN_POSITIVE, 1e-45] {
            let (m, e) = decompose(v);
            assert_eq!(m as f64 * 2f64.powi(e), f64::from(v));
        }
    }

    #[test]
    fn ratios_are_right_whatever_the_sizes() {
        let n = |v: i64| BigInt::from(v);
        assert_eq!(ratio(&n(1), &n(3)), 1.0 / 3.0);
        assert_eq!(ratio(&n(-22), &n(7)), -22.0 / 7.0);
        assert_eq!(ratio(&n(0), &n(5)), 0.0);
        assert_eq!(ratio(&(n(1) << 3000usize), &(n(3) << 2990usize)), 1024.0 / 3.0);
        assert_eq!(ratio(&n(1), &(n(1) << 900usize)), 2f64.powi(-900));
    }

    #[test]
    fn cancellation_at_1e30_loses_nothing() {
        // 1e30 + 1 - 1e30 through the matrix: x + y + z.
        let mut view = View::pixels(2, 2);
        view.projection = IDENTITY;
        view.projection[4] = 1.0;
        view.projection[8] = 1.0;
        let transform = Transform::new(&view).unwrap();
        let (clip, exponent) = transform.clip(&[[1e30, 0.5, -1e30, 1.0]]).unwrap();
        assert_eq!(ratio(&clip[0][0], &clip[0][3]), 0.5);
        assert_eq!(scale(ratio(&clip[0][3], &clip[0][4]), exponent.into()), 1.0);
        assert!(transform.clip(&[[f32::NAN, 0.0, 0.0, 1.0]]).is_none());
    }

    #[test]
    fn pixels_map_to_themselves() {
        let transform = Transform::new(&View::pixels(256, 128)).unwrap();
        let (clip, _) = transform.clip(&[[17.25, 99.5, 0.0, 1.0]]).unwrap();
        assert_eq!(transform.window(&clip[0]), [17.25, 99.5]);
    }
}
