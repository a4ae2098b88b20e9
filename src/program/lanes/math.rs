//! Elementary functions of one lane: the same bits on every SIMD level, because they are made of IEEE additions,
//! multiplications, divisions and bit operations only. They compute in f64 and round once, so that the error is a
//! little over half an ulp of f32.

#![allow(clippy::excessive_precision)]

/// `x < y ? x : y`, which is what MINPS does: the second where either is NaN.
#[inline(always)]
pub fn min(x: f32, y: f32) -> f32 {
    if x < y { x } else { y }
}

/// `x > y ? x : y`: the second where either is NaN.
#[inline(always)]
pub fn max(x: f32, y: f32) -> f32 {
    if x > y { x } else { y }
}

/// 2^52 + 2^51: adding and subtracting it rounds a small f64 to an integer, ties to even.
const ROUND: f64 = 6755399441055744.0;

/// 2^x for any f64; saturates to 0 and infinity where f32 does.
#[inline(always)]
fn exp2_wide(x: f64) -> f64 {
    // Beyond these f32 is 0 or infinite anyway. The comparisons keep NaN.
    let x = if x < -200.0 { -200.0 } else { x };
    let x = if x > 200.0 { 200.0 } else { x };
    let shifted = x + ROUND;
    let k = shifted - ROUND;
    let r = (x - k) * std::f64::consts::LN_2;
    // Taylor series of e^r, |r| <= ln(2)/2: the first term left out is 3e-12.
    let p = 1.0 / 362880.0;
    let p = p * r + 1.0 / 40320.0;
    let p = p * r + 1.0 / 5040.0;
    let p = p * r + 1.0 / 720.0;
    let p = p * r + 1.0 / 120.0;
    let p = p * r + 1.0 / 24.0;
    let p = p * r + 1.0 / 6.0;
    let p = p * r + 0.5;
    let p = p * r + 1.0;
    let p = p * r + 1.0;
    // The low bits of `shifted` hold k: it goes to the exponent.
    p * f64::from_bits((shifted.to_bits().wrapping_add(1023)) << 52)
}

/// log2(x) of a positive finite f64 that came from an f32.
#[inline(always)]
fn log2_wide(x: f64) -> f64 {
    // x = m * 2^e with m in [sqrt(1/2), sqrt(2))
    let high = (x.to_bits() >> 32) as u32 as i32;
    let e = (high - 0x3fe6_a09e) >> 20;
    let m = f64::from_bits(x.to_bits().wrapping_sub((e as i64 as u64) << 52));
    let f = (m - 1.0) / (m + 1.0);
    let s = f * f;
    // 2 atanh(f): |f| <= 0.172, the first term left out is 4e-13 of the whole.
    let p = 1.0 / 15.0;
    let p = p * s + 1.0 / 13.0;
    let p = p * s + 1.0 / 11.0;
    let p = p * s + 1.0 / 9.0;
    let p = p * s + 1.0 / 7.0;
    let p = p * s + 1.0 / 5.0;
    let p = p * s + 1.0 / 3.0;
    let p = p * s + 1.0;
    let ln = 2.0 * f * p;
    e as f64 + ln * std::f64::consts::LOG2_E
}

/// log2 of any f32 as f64: -inf at 0, NaN below, inf at inf.
#[inline(always)]
fn log2_any(x: f32) -> f64 {
    let r = log2_wide(x as f64);
    let r = if x == 0.0 { f64::NEG_INFINITY } else { r };
    let r = if x < 0.0 { f64::NAN } else { r };
    let r = if x == f32::INFINITY { f64::INFINITY } else { r };
    if x.is_nan() { f64::NAN } else { r }
}

/// 2^x
#[inline(always)]
pub fn exp2(x: f32) -> f32 {
    exp2_wide(x as f64) as f32
}

/// log2(x)
#[inline(always)]
pub fn log2(x: f32) -> f32 {
    log2_any(x) as f32
}

/// e^x
#[inline(always)]
pub fn exp(x: f32) -> f32 {
    exp2_wide(x as f64 * std::f64::consts::LOG2_E) as f32
}

/// ln(x)
#[inline(always)]
pub fn log(x: f32) -> f32 {
    (log2_any(x) * std::f64::consts::LN_2) as f32
}

/// x^y for x >= 0; 0^0 is 1.
#[inline(always)]
pub fn pow(x: f32, y: f32) -> f32 {
    let r = exp2_wide(y as f64 * log2_any(x)) as f32;
    if y == 0.0 { 1.0 } else { r }
}

/// Sine (`quarter` 0) or cosine (`quarter` 1): the argument less a multiple of pi/2, then one of two polynomials.
#[inline(always)]
fn sine(x: f32, quarter: u64) -> f32 {
    const PIO2_HIGH: f64 = 1.57079632673412561417;
    const PIO2_LOW: f64 = 6.07710050650619224932e-11;
    let x = x as f64;
    let shifted = x * std::f64::consts::FRAC_2_PI + ROUND;
    let k = shifted - ROUND;
    let quadrant = shifted.to_bits().wrapping_add(quarter);
    let r = (x - k * PIO2_HIGH) - k * PIO2_LOW;
    let s = r * r;
    let p = -1.0 / 39916800.0;
    let p = p * s + 1.0 / 362880.0;
    let p = p * s - 1.0 / 5040.0;
    let p = p * s + 1.0 / 120.0;
    let p = p * s - 1.0 / 6.0;
    let sin = r + r * s * p;
    let p = 1.0 / 479001600.0;
    let p = p * s - 1.0 / 3628800.0;
    let p = p * s + 1.0 / 40320.0;
    let p = p * s - 1.0 / 720.0;
    let p = p * s + 1.0 / 24.0;
    let p = p * s - 0.5;
    let cos = 1.0 + s * p;
    let value = if quadrant & 1 != 0 { cos } else { sin };
    let value = if quadrant & 2 != 0 { -value } else { value };
    // Past 2^40 there is no phase left in the f32 that anyone could mean.
    let value = if x.abs() < 1.1e12 { value } else { 0.0 };
    if x.is_finite() { value as f32 } else { f32::NAN }
}

/// Sine
#[inline(always)]
pub fn sin(x: f32) -> f32 {
    sine(x, 0)
}

/// Cosine
#[inline(always)]
pub fn cos(x: f32) -> f32 {
    sine(x, 1)
}

/// Tangent
#[inline(always)]
pub fn tan(x: f32) -> f32 {
    sine(x, 0) / sine(x, 1)
}

/// atan of x in [0, 1]
#[inline(always)]
fn atan_unit(x: f64) -> f64 {
    // atan(x) = pi/8 + atan((x - t) / (1 + x t)), t = tan(pi/8): the rest is at most t.
    const T: f64 = 0.41421356237309504880;
    let y = (x - T) / (1.0 + x * T);
    let s = y * y;
    let mut p = 1.0 / 25.0;
    let mut k = 23;
    while k >= 1 {
        p = 1.0 / k as f64 - p * s;
        k -= 2;
    }
    std::f64::consts::FRAC_PI_8 + y * p
}

/// Angle of the point (x, y), y first as in C.
#[inline(always)]
pub fn atan2(y: f32, x: f32) -> f32 {
    let (ax, ay) = (x.abs() as f64, y.abs() as f64);
    let (small, large) = if ay < ax { (ay, ax) } else { (ax, ay) };
    let ratio = if large == 0.0 { 0.0 } else { small / large };
    let ratio = if small == f64::INFINITY { 1.0 } else { ratio };
    // The series is off by an ulp of pi/8 at 0: say 0 there.
    let a = if ratio == 0.0 { 0.0 } else { atan_unit(ratio) };
    let a = if ay < ax { a } else { std::f64::consts::FRAC_PI_2 - a };
    let a = if large == 0.0 { 0.0 } else { a };
    let a = if x.is_sign_negative() { std::f64::consts::PI - a } else { a };
    let a = if y.is_sign_negative() { -a } else { a };
    if x.is_nan() || y.is_nan() { f32::NAN } else { a as f32 }
}

/// Arc tangent
#[inline(always)]
pub fn atan(x: f32) -> f32 {
    atan2(x, 1.0)
}

/// Arc sine
#[inline(always)]
pub fn asin(x: f32) -> f32 {
    // (1 - x)(1 + x) is exact enough in f64; the quotient's angle needs no series of its own.
    let c = ((1.0 - x as f64) * (1.0 + x as f64)).sqrt();
    if x.abs() > 1.0 { f32::NAN } else { atan2(x, c as f32) }
}

/// Arc cosine
#[inline(always)]
pub fn acos(x: f32) -> f32 {
    let s = ((1.0 - x as f64) * (1.0 + x as f64)).sqrt();
    if x.abs() > 1.0 { f32::NAN } else { atan2(s as f32, x) }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Distance in ulps of f32 from an f64 reference.
    fn ulps(got: f32, want: f64) -> f64 {
        let w = want as f32;
        if got == w || (got.is_nan() && w.is_nan()) {
            return 0.0;
        }
        let ulp = (f32::from_bits(w.abs().to_bits() + 1) - w.abs()) as f64;
        (got as f64 - want).abs() / ulp
    }

    fn samples() -> impl Iterator<Item = f32> {
        (0..20000u32).map(|i| {
            let h = i.wrapping_mul(2654435761);
            (h as f32 / u32::MAX as f32 - 0.5) * 64.0
        })
    }

    #[test]
    fn elementary_functions_are_within_one_ulp() {
        for x in samples() {
            assert!(ulps(exp2(x), (x as f64).exp2()) < 0.51, "exp2 {x}");
            assert!(ulps(exp(x), (x as f64).exp()) < 0.51, "exp {x}");
            assert!(ulps(log2(x.abs()), (x.abs() as f64).log2()) < 0.51, "log2 {x}");
            assert!(ulps(log(x.abs()), (x.abs() as f64).ln()) < 0.51, "log {x}");
            assert!(ulps(sin(x), (x as f64).sin()) < 0.6, "sin {x} {} {}", sin(x), (x as f64).sin());
            assert!(ulps(cos(x), (x as f64).cos()) < 0.6, "cos {x} {} {}", cos(x), (x as f64).cos());
            assert!(ulps(atan(x), (x as f64).atan()) < 0.6, "atan {x}");
            let u = x / 32.0;
            assert!(ulps(asin(u), (u as f64).asin()) < 1.5, "asin {u}");
            assert!((acos(u) as f64 - (u as f64).acos()).abs() < 3e-7, "acos {u}");
            for y in [0.5f32, 2.0, 20.0, 128.0] {
                assert!(ulps(pow(u.abs(), y), (u.abs() as f64).powf(y as f64)) < 0.51, "pow {u} {y}");
            }
        }
    }

    #[test]
    fn edges_follow_ieee() {
        assert_eq!(exp2(-f32::INFINITY), 0.0);
        assert_eq!(exp2(f32::INFINITY), f32::INFINITY);
        assert_eq!(exp2(-149.0), f32::from_bits(1));
        assert!(exp2(f32::NAN).is_nan());
        assert_eq!(log2(0.0), f32::NEG_INFINITY);
        assert!(log2(-1.0).is_nan());
        assert_eq!(log2(f32::from_bits(1)), -149.0);
        assert_eq!(log2(f32::INFINITY), f32::INFINITY);
        assert_eq!(pow(0.0, 0.0), 1.0);
        assert_eq!(pow(0.0, 3.0), 0.0);
        assert_eq!(pow(1.0, 1e30), 1.0);
        assert!(sin(f32::INFINITY).is_nan());
        assert_eq!(atan2(0.0, -1.0), std::f32::consts::PI);
        assert_eq!(atan2(-0.0, 1.0).to_bits(), (-0.0f32).to_bits());
    }
}
