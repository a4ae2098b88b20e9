//! FLIP, the perceptual image difference of Andersson et al. (HPG 2020), for low dynamic range images.
//!
//! Written from the paper's definitions, section by section; the constants are the paper's. Both images are sRGB,
//! 8 bits a component. The result is 0 (no visible difference) to 1 for each pixel, seen at 67 pixels a degree
//! (a 0.7 m wide, 3840 pixel monitor at 0.7 m).

const PIXELS_PER_DEGREE: f32 = 67.020_64;
/// Exponent of the colour difference, and where its lower range ends (section 4.1).
const QC: f32 = 0.7;
const PC: f32 = 0.4;
const PT: f32 = 0.95;
/// Exponent and width in degrees of the feature detectors (section 4.2).
const QF: f32 = 0.5;
const FEATURE_WIDTH: f32 = 0.082;

type Rgb = [f32; 3];

/// Mean FLIP error of two RGBA8 images of `width` columns; alpha is ignored.
pub fn mean_flip(reference: &[u8], test: &[u8], width: usize) -> f64 {
    let height = reference.len() / 4 / width;
    let (r, t) = (to_ycxcz(reference), to_ycxcz(test));
    let features = feature_difference(&r, &t, width, height);
    let (r, t) = (spatial_filter(&r, width, height), spatial_filter(&t, width, height));
    let cmax = max_color_difference();
    let sum: f64 = (0..width * height)
        .map(|i| {
            let color = redistribute(hyab(hunt_lab(r[i]), hunt_lab(t[i])).powf(QC), cmax);
            f64::from(color.powf(1.0 - features[i]))
        })
        .sum();
    sum / (width * height) as f64
}

fn linear(byte: u8) -> f32 {
    let c = f32::from(byte) / 255.0;
    if c <= 0.04045 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) }
}

/// Linear RGB to CIE XYZ relative to the D65 white of RGB (1, 1, 1).
fn xyz(c: Rgb) -> Rgb {
    const M: [Rgb; 3] =
        [[0.412_386_6, 0.357_591_5, 0.180_450_5], [0.212_636_8, 0.715_183, 0.072_180_2], [0.019_330_6, 0.119_197_2, 0.950_372_6]];
    let dot = |m: Rgb| m[0] * c[0] + m[1] * c[1] + m[2] * c[2];
    let white = |m: Rgb| m[0] + m[1] + m[2];
    [dot(M[0]) / white(M[0]), dot(M[1]) / white(M[1]), dot(M[2]) / white(M[2])]
}

/// The inverse of [`xyz`].
fn rgb(c: Rgb) -> Rgb {
    let [x, y, z] = [c[0] * 0.950_428_6, c[1], c[2] * 1.088_900_4];
    [
        3.241_003_2 * x - 1.537_398_9 * y - 0.498_615_9 * z,
        -0.969_224_3 * x + 1.875_93 * y + 0.041_554_2 * z,
        0.055_639_4 * x - 0.204_011_2 * y + 1.057_149 * z,
    ]
}

/// The opponent space in which the eye's contrast sensitivity is applied (section 4.1.1).
fn to_ycxcz(image: &[u8]) -> Vec<Rgb> {
    image
        .chunks_exact(4)
        .map(|p| {
            let [x, y, z] = xyz([linear(p[0]), linear(p[1]), linear(p[2])]);
            [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
        })
        .collect()
}

/// One pass of a one-dimensional kernel with clamped borders over a plane.
fn convolve(plane: &[f32], width: usize, height: usize, kernel: &[f32], vertical: bool) -> Vec<f32> {
    let radius = kernel.len() / 2;
    let mut out = vec![0.0; plane.len()];
    for y in 0..height {
        for x in 0..width {
            let mut sum = 0.0;
            for (k, weight) in kernel.iter().enumerate() {
                let (sx, sy) = if vertical {
                    (x, (y + k).saturating_sub(radius).min(height - 1))
                } else {
                    ((x + k).saturating_sub(radius).min(width - 1), y)
                };
                sum += weight * plane[sy * width + sx];
            }
            out[y * width + x] = sum;
        }
    }
    out
}

fn plane(image: &[Rgb], channel: usize) -> Vec<f32> {
    image.iter().map(|p| p[channel]).collect()
}

/// Contrast sensitivity: a sum of Gaussians a * sqrt(pi / b) * exp(-pi^2 x^2 / b) for each channel, x in degrees.
/// Returns linear RGB, clamped to what a monitor shows.
fn spatial_filter(image: &[Rgb], width: usize, height: usize) -> Vec<Rgb> {
    const GAUSSIANS: [&[(f32, f32)]; 3] = [&[(1.0, 0.0047)], &[(1.0, 0.0053)], &[(34.1, 0.04), (13.5, 0.025)]];
    let pi2 = std::f32::consts::PI * std::f32::consts::PI;
    let radius = (3.0 * (0.04 / (2.0 * pi2)).sqrt() * PIXELS_PER_DEGREE).ceil() as i32;
    let mut filtered = vec![[0.0; 3]; image.len()];
    for (channel, gaussians) in GAUSSIANS.iter().enumerate() {
        let source = plane(image, channel);
        let mut total = 0.0;
        let mut sum = vec![0.0; source.len()];
        for &(a, b) in *gaussians {
            let kernel: Vec<f32> = (-radius..=radius).map(|i| (-pi2 * (i as f32 / PIXELS_PER_DEGREE).powi(2) / b).exp()).collect();
            let mass: f32 = kernel.iter().sum();
            let scale = a * (std::f32::consts::PI / b).sqrt();
            total += scale * mass * mass;
            let once = convolve(&source, width, height, &kernel, false);
            for (s, v) in sum.iter_mut().zip(convolve(&once, width, height, &kernel, true)) {
                *s += scale * v;
            }
        }
        for (f, s) in filtered.iter_mut().zip(sum) {
            f[channel] = s / total;
        }
    }
    filtered
        .into_iter()
        .map(|[l, cx, cz]| {
            let y = (l + 16.0) / 116.0;
            rgb([y + cx / 500.0, y, y - cz / 200.0]).map(|c| c.clamp(0.0, 1.0))
        })
        .collect()
}

/// CIELAB with the Hunt adjustment: colours look less saturated where it is dark.
fn hunt_lab(linear_rgb: Rgb) -> Rgb {
    const DELTA: f32 = 6.0 / 29.0;
    let f = |t: f32| if t > DELTA * DELTA * DELTA { t.cbrt() } else { t / (3.0 * DELTA * DELTA) + 4.0 / 29.0 };
    let [x, y, z] = xyz(linear_rgb).map(f);
    let l = 116.0 * y - 16.0;
    [l, 0.01 * l * 500.0 * (x - y), 0.01 * l * 200.0 * (y - z)]
}

/// The HyAB distance: city block in lightness, Euclidean in chroma.
fn hyab(a: Rgb, b: Rgb) -> f32 {
    (a[0] - b[0]).abs() + (a[1] - b[1]).hypot(a[2] - b[2])
}

/// The largest difference that sRGB allows: green against blue.
fn max_color_difference() -> f32 {
    hyab(hunt_lab([0.0, 1.0, 0.0]), hunt_lab([0.0, 0.0, 1.0])).powf(QC)
}

fn redistribute(difference: f32, cmax: f32) -> f32 {
    let limit = PC * cmax;
    if difference < limit { PT / limit * difference } else { PT + (difference - limit) / (cmax - limit) * (1.0 - PT) }
}

/// Differences of edges and points in the achromatic channel, each pixel 0 to 1 (section 4.2).
fn feature_difference(reference: &[Rgb], test: &[Rgb], width: usize, height: usize) -> Vec<f32> {
    let deviation = 0.5 * FEATURE_WIDTH * PIXELS_PER_DEGREE;
    let radius = (3.0 * deviation).ceil() as i32;
    let gauss = |i: i32| (-(i as f32).powi(2) / (2.0 * deviation * deviation)).exp();
    let smooth = normalized((-radius..=radius).map(gauss).collect());
    let edge = normalized((-radius..=radius).map(|i| -(i as f32) * gauss(i)).collect());
    let point = normalized((-radius..=radius).map(|i| ((i as f32 / deviation).powi(2) - 1.0) * gauss(i)).collect());
    let magnitude = |image: &[Rgb], kernel: &[f32]| -> Vec<f32> {
        let y: Vec<f32> = image.iter().map(|p| (p[0] + 16.0) / 116.0).collect();
        let dx = convolve(&convolve(&y, width, height, kernel, false), width, height, &smooth, true);
        let dy = convolve(&convolve(&y, width, height, kernel, true), width, height, &smooth, false);
        dx.into_iter().zip(dy).map(|(x, y)| x.hypot(y)).collect()
    };
    let edges = magnitude(reference, &edge).into_iter().zip(magnitude(test, &edge));
    let points = magnitude(reference, &point).into_iter().zip(magnitude(test, &point));
    edges
        .zip(points)
        .map(|((re, te), (rp, tp))| ((re - te).abs().max((rp - tp).abs()) / std::f32::consts::SQRT_2).powf(QF).min(1.0))
        .collect()
}

/// Scales positive weights to the sum 1 and negative ones to -1.
fn normalized(kernel: Vec<f32>) -> Vec<f32> {
    let positive: f32 = kernel.iter().filter(|w| **w > 0.0).sum();
    let negative: f32 = -kernel.iter().filter(|w| **w < 0.0).sum::<f32>();
    kernel
        .into_iter()
        .map(|w| {
            if w > 0.0 {
                w / positive
            } else if w < 0.0 {
                w / negative
            } else {
                0.0
            }
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn flat(color: [u8; 4]) -> Vec<u8> {
        color.repeat(64 * 64)
    }

    #[test]
    fn equal_images_do_not_differ() {
        let image: Vec<u8> = (0..64 * 64 * 4).map(|i| (i * 37 % 251) as u8).collect();
        assert_eq!(mean_flip(&image, &image, 64), 0.0);
    }

    #[test]
    fn green_against_blue_is_the_largest_difference() {
        let error = mean_flip(&flat([0, 255, 0, 255]), &flat([0, 0, 255, 255]), 64);
        assert!((error - 1.0).abs() < 1e-3, "{error}");
    }

    #[test]
    fn black_against_white_is_nearly_as_large() {
        // The paper's own implementation gives 0.9655 for flat black against flat white.
        let error = mean_flip(&flat([0, 0, 0, 255]), &flat([255, 255, 255, 255]), 64);
        assert!((0.95..1.0).contains(&error), "{error}");
    }

    #[test]
    fn one_step_of_grey_is_hardly_visible() {
        let error = mean_flip(&flat([128, 128, 128, 255]), &flat([129, 129, 129, 255]), 64);
        assert!(error > 0.0 && error < 0.03, "{error}");
    }
}
