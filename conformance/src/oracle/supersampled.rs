//! An image with 256 samples a pixel: exactly transformed and clipped triangles of one colour each, every sample inside or outside of them,
//! a pixel the mean of its samples. Nothing is snapped.

use super::coverage::Placed;
use super::exact::Transform;
use crate::recording::View;

/// Samples a pixel.
const SAMPLES: usize = 256;

/// Where sample `k` of a pixel lies: Hammersley's points, moved to the middle of their cells. No two share a column or a row, so that an edge
/// that is nearly upright or level is met by 256 steps and not by the 16 of a square grid.
fn place(k: usize) -> [f64; 2] {
    let steps = SAMPLES as f64;
    [(k as f64 + 0.5) / steps, (f64::from((k as u8).reverse_bits()) + 0.5) / steps]
}

/// A line `a x + b y + c`, not negative on the side where the polygon lies.
type Line = [f64; 3];

fn at([a, b, c]: Line, [x, y]: [f64; 2]) -> f64 {
    a * x + b * y + c
}

/// The lines of a convex polygon's edges; none where it has no area.
fn lines(polygon: &[[f64; 2]]) -> Vec<Line> {
    let edges = || polygon.iter().zip(polygon.iter().cycle().skip(1));
    let area: f64 = edges().map(|(p, q)| p[0] * q[1] - q[0] * p[1]).sum();
    if area == 0.0 {
        return Vec::new();
    }
    let side = area.signum();
    edges()
        .map(|(p, q)| {
            let [a, b] = [side * (p[1] - q[1]), side * (q[0] - p[0])];
            [a, b, -(a * p[0] + b * p[1])]
        })
        .collect()
}

/// Draws triangles one over the other, over a background, and returns RGBA8, bottom row first.
pub fn draw(view: &View, [width, height]: [usize; 2], background: [u8; 3], triangles: &[([[f32; 4]; 3], [u8; 3])]) -> Vec<u8> {
    let places: Vec<[f64; 2]> = (0..SAMPLES).map(place).collect();
    let mut samples = vec![background; width * height * SAMPLES];
    let Some(transform) = Transform::new(view) else { return Vec::new() };
    for (positions, color) in triangles {
        let Some(Placed { polygon, .. }) = Placed::triangle(view, &transform, *positions) else { continue };
        let lines = lines(&polygon);
        let span = |k: usize, size: usize| {
            let (low, high) = polygon.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[k]), h.max(p[k])));
            low.floor().clamp(0.0, size as f64) as usize..high.ceil().clamp(0.0, size as f64) as usize
        };
        for row in span(1, height) {
            for column in span(0, width) {
                let [x, y] = [column as f64, row as f64];
                // Over the pixel, a line's value differs from its middle's by at most this.
                let far = |[a, b, _]: Line| 0.5 * (a.abs() + b.abs());
                let middle = |l: &Line| at(*l, [x + 0.5, y + 0.5]);
                if lines.is_empty() || lines.iter().any(|l| middle(l) < -far(*l)) {
                    continue;
                }
                let pixel = &mut samples[(row * width + column) * SAMPLES..][..SAMPLES];
                for (sample, [dx, dy]) in pixel.iter_mut().zip(&places) {
                    if lines.iter().all(|l| at(*l, [x + dx, y + dy]) >= 0.0) {
                        *sample = *color;
                    }
                }
            }
        }
    }
    let mean = |pixel: &[[u8; 3]], c: usize| {
        let sum: u32 = pixel.iter().map(|s| u32::from(s[c])).sum();
        ((sum + SAMPLES as u32 / 2) / SAMPLES as u32) as u8
    };
    samples.chunks_exact(SAMPLES).flat_map(|p| [mean(p, 0), mean(p, 1), mean(p, 2), 255]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn no_two_samples_share_a_column_or_a_row() {
        for k in [0, 1] {
            let mut cells: Vec<u32> = (0..SAMPLES).map(|s| (place(s)[k] * 256.0).floor() as u32).collect();
            cells.sort_unstable();
            assert!(cells.into_iter().eq(0..256));
        }
    }

    #[test]
    fn a_pixel_is_as_bright_as_the_part_of_it_that_is_covered() {
        let view = View::pixels(4, 4);
        let corner = |x: f32, y: f32| [x, y, 0.0, 1.0];
        // The left of x = 1.25; then over it, below the diagonal of pixel (3, 0).
        let left = [corner(1.25, -50.0), corner(1.25, 50.0), corner(-50.0, 0.0)];
        let half = [corner(3.0, 0.0), corner(4.0, 1.0), corner(4.0, 0.0)];
        let image = draw(&view, [4, 4], [0; 3], &[(left, [200, 0, 0]), (half, [0, 100, 0])]);
        let pixel = |x: usize, y: usize| &image[(y * 4 + x) * 4..][..4];
        assert_eq!(pixel(0, 2), [200, 0, 0, 255]);
        assert_eq!(pixel(1, 2), [50, 0, 0, 255]);
        assert_eq!(pixel(2, 2), [0, 0, 0, 255]);
        // 120 samples below the diagonal, and 16 on it, which are inside.
        assert_eq!(pixel(3, 0), [0, 53, 0, 255]);
    }
}
