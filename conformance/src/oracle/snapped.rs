//! The snapped rule: 8 subpixel bits, rounded to nearest even, edge functions in integers, left and bottom edges inclusive as GL sees them
//! (y up). What `ARCHITECTURE.md` promises and OSMesa does.

/// Snapped position: 1/256 pixel from the centre of pixel (0, 0).
pub type Snapped = [i128; 2];

/// Snaps a window position; `None` where an error of `slack` pixels would make it uncertain.
pub fn snap(window: [f64; 2], slack: f64) -> Option<Snapped> {
    let axis = |v: f64| {
        let units = (v - 0.5) * 256.0;
        let off = (units - units.floor() - 0.5).abs();
        // 1e-6: the oracle's own rounding.
        (off > slack * 256.0 + 1e-6).then(|| units.round_ties_even() as i128)
    };
    Some([axis(window[0])?, axis(window[1])?])
}

/// Whether the triangle covers the centre of a pixel.
pub fn covers(triangle: &[Snapped; 3], column: i64, row: i64) -> bool {
    let [a, b, c] = *triangle;
    let area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    if area == 0 {
        return false;
    }
    let counter_clockwise = if area > 0 { [a, b, c] } else { [a, c, b] };
    let sample = [i128::from(column) * 256, i128::from(row) * 256];
    (0..3).all(|i| {
        let (p, q) = (counter_clockwise[i], counter_clockwise[(i + 1) % 3]);
        let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
        let edge = dx * (sample[1] - p[1]) - dy * (sample[0] - p[0]);
        // Counter-clockwise, left edges run down and the bottom edge runs to the right.
        let inclusive = dy < 0 || (dy == 0 && dx > 0);
        edge > 0 || (edge == 0 && inclusive)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_square_of_two_triangles_on_pixel_centres_takes_left_and_bottom() {
        // From centre (1,1) to centre (4,4): 3 x 3 samples, those of the left and bottom border among them, each once.
        let corner = |x: i128, y: i128| [x * 256, y * 256];
        let halves = [[corner(1, 1), corner(4, 1), corner(4, 4)], [corner(1, 1), corner(1, 4), corner(4, 4)]];
        for row in 0..6 {
            for column in 0..6 {
                let hits = halves.iter().filter(|t| covers(t, column, row)).count();
                let expected = usize::from((1..4).contains(&column) && (1..4).contains(&row));
                assert_eq!(hits, expected, "{column}, {row}");
            }
        }
    }

    #[test]
    fn winding_does_not_matter_and_no_area_covers_nothing() {
        let t = [[0, 0], [2560, 100], [700, 2000]];
        let turned = [t[1], t[0], t[2]];
        assert!((0..10).all(|y| (0..10).all(|x| covers(&t, x, y) == covers(&turned, x, y))));
        assert!(covers(&t, 3, 2));
        assert!(!covers(&[[0, 0], [256, 256], [512, 512]], 1, 1));
    }

    #[test]
    fn near_a_tie_nothing_is_certain() {
        assert_eq!(snap([0.5 + 1.0 / 256.0, 0.5], 1e-5), Some([1, 0]));
        assert_eq!(snap([0.5 + 1.0 / 512.0, 0.5], 1e-9), None);
        assert_eq!(snap([0.5 + 1.0 / 512.0 + 1e-4, 0.5], 1e-3), None);
        assert_eq!(snap([0.5 + 1.0 / 512.0 + 1e-4, 0.5], 1e-5), Some([1, 0]));
    }
}
