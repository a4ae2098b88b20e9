//! Which samples must, may and must not be covered, and how often: any number of triangles in one image whose stencil buffer counts hits.

use serde::Serialize;

use super::exact::{Transform, ratio, scale};
use super::{bound, clip, snapped};
use crate::recording::View;

/// Half a subpixel, in pixels.
pub const HALF_SUBPIXEL: f64 = 1.0 / 512.0;

/// What f64 may have done to the oracle's own window coordinates, in pixels.
const OWN_ROUNDING: f64 = 1e-9;

/// A sample's relation to one primitive.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Coverage3 {
    /// Covered by any correct implementation.
    Must,
    /// So near to an edge that snapping decides.
    May,
    /// Covered by none.
    MustNot,
}

/// Whether the segment passes within `band` of the sample, in the maximum norm.
fn near(a: [f64; 2], b: [f64; 2], s: [f64; 2], band: f64) -> bool {
    let within = |k: usize| s[k] >= a[k].min(b[k]) - band && s[k] <= a[k].max(b[k]) + band;
    let d = [b[0] - a[0], b[1] - a[1]];
    let cross = d[0] * (s[1] - a[1]) - d[1] * (s[0] - a[0]);
    within(0) && within(1) && cross.abs() <= band * (d[0].abs() + d[1].abs())
}

/// Judges a sample against a convex polygon.
pub fn classify(polygon: &[[f64; 2]], sample: [f64; 2], band: f64) -> Coverage3 {
    let n = polygon.len();
    let edges = || (0..n).map(|i| (polygon[i], polygon[(i + 1) % n]));
    if edges().any(|(a, b)| near(a, b, sample, band)) {
        return Coverage3::May;
    }
    let side = |(a, b): ([f64; 2], [f64; 2])| (b[0] - a[0]) * (sample[1] - a[1]) - (b[1] - a[1]) * (sample[0] - a[0]);
    let (mut left, mut right) = (false, false);
    for edge in edges() {
        let s = side(edge);
        left |= s > 0.0;
        right |= s < 0.0;
    }
    if left != right { Coverage3::Must } else { Coverage3::MustNot }
}

/// A primitive on the screen.
#[derive(Clone, Debug)]
pub struct Placed {
    /// What is left of it after clipping.
    pub polygon: Vec<[f64; 2]>,
    /// Half a subpixel and the rounding of its transform, in pixels.
    pub band: f64,
    /// The band where single-precision clipping is allowed for as well.
    pub wide: f64,
    /// Its snapped corners, where they are certain and nothing was clipped.
    pub snapped: Option<[snapped::Snapped; 3]>,
}

impl Placed {
    /// Places a triangle; `None` where a coordinate is not finite or nothing of it is inside.
    pub fn triangle(view: &View, transform: &Transform, positions: [[f32; 4]; 3]) -> Option<Placed> {
        let (clips, exponent) = transform.clip(&positions)?;
        let (left, cut) = clip::polygon(clips);
        let polygon: Vec<[f64; 2]> = left.iter().map(|v| transform.window(v)).collect();
        if polygon.is_empty() {
            return None;
        }
        if !cut {
            let slack = positions.iter().map(|p| bound::transform(view, *p)).fold(0.0, f64::max);
            let band = HALF_SUBPIXEL + slack + OWN_ROUNDING;
            return Some(Placed { snapped: certain(&polygon, slack), polygon, band, wide: band });
        }
        let largest = polygon.iter().flatten().fold(0.0f64, |m, v| m.max(v.abs()));
        let band = HALF_SUBPIXEL + bound::rounding(largest) + OWN_ROUNDING;
        let least_w = left.iter().map(|v| scale(ratio(&v[3], &v[4]), exponent.into())).fold(f64::INFINITY, f64::min);
        let wide = band + bound::clip(view, &positions, least_w);
        Some(Placed { polygon, band, wide, snapped: None })
    }

    /// First and last column (k = 0) or row (k = 1) whose samples may lie within the wide band, inside an image of `size`.
    fn range(&self, k: usize, size: usize) -> std::ops::Range<usize> {
        let (low, high) = self.polygon.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[k]), h.max(p[k])));
        let wide = self.wide.min(65536.0);
        let first = (low - wide - 0.5).ceil().clamp(0.0, size as f64);
        let last = (high + wide - 0.5).floor().clamp(-1.0, size as f64 - 1.0);
        first as usize..((last + 1.0) as usize).max(first as usize)
    }
}

fn certain(polygon: &[[f64; 2]], slack: f64) -> Option<[snapped::Snapped; 3]> {
    let corners: Vec<_> = polygon.iter().map(|p| snapped::snap(*p, slack)).collect::<Option<_>>()?;
    corners.try_into().ok()
}

/// What is known about the hits of one sample.
#[derive(Clone, Copy, Debug, Default)]
struct Sample {
    must: u32,
    may: u32,
    /// The same with the wide band.
    must_wide: u32,
    may_wide: u32,
    /// Hits by the snapped rule, unless a primitive's is uncertain here.
    rule: u32,
    uncertain: bool,
    /// The primitive, if just one must cover it and no other may.
    owner: u32,
}

/// Counts of samples. Sums of several images are sums of their counts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Counts {
    /// Samples of the image.
    pub samples: u64,
    /// Samples that some primitive must cover.
    pub must: u64,
    /// Samples that some primitive may cover or not.
    pub may: u64,
    /// Hit too often or not often enough.
    pub wrong: u64,
    /// Of these, those that rounding in single-precision clipping does not explain.
    pub beyond: u64,
    /// Allowed, but not what the snapped rule says.
    pub off_rule: u64,
}

/// What an image whose stencil buffer counts hits must look like.
pub struct Coverage {
    width: usize,
    samples: Vec<Sample>,
    primitives: u32,
}

impl Coverage {
    /// For an image of this size, nothing drawn.
    pub fn new(width: usize, height: usize) -> Coverage {
        Coverage { width, samples: vec![Sample::default(); width * height], primitives: 0 }
    }

    /// Adds a primitive that may be hidden from some samples by `mask` (scissor, stipple). Returns its number.
    pub fn add(&mut self, placed: Option<&Placed>, mask: impl Fn(usize, usize) -> bool) -> u32 {
        let number = self.primitives;
        self.primitives += 1;
        let Some(placed) = placed else { return number };
        let height = self.samples.len() / self.width;
        for row in placed.range(1, height) {
            for column in placed.range(0, self.width) {
                if !mask(column, row) {
                    continue;
                }
                let at = [column as f64 + 0.5, row as f64 + 0.5];
                let sample = &mut self.samples[row * self.width + column];
                let narrow = classify(&placed.polygon, at, placed.band);
                let wide = if placed.wide == placed.band { narrow } else { classify(&placed.polygon, at, placed.wide) };
                if narrow == Coverage3::Must && sample.must == 0 {
                    sample.owner = number;
                }
                sample.must += u32::from(narrow == Coverage3::Must);
                sample.may += u32::from(narrow == Coverage3::May);
                sample.must_wide += u32::from(wide == Coverage3::Must);
                sample.may_wide += u32::from(wide == Coverage3::May);
                match (&placed.snapped, narrow) {
                    (Some(corners), _) => sample.rule += u32::from(snapped::covers(corners, column as i64, row as i64)),
                    (None, Coverage3::May) => sample.uncertain = true,
                    (None, narrow) => sample.rule += u32::from(narrow == Coverage3::Must),
                }
            }
        }
        number
    }

    /// Judges hit counts, bottom row first.
    pub fn judge(&self, hits: &[u8]) -> Counts {
        let mut counts = Counts { samples: self.samples.len() as u64, ..Counts::default() };
        for (sample, &hits) in self.samples.iter().zip(hits) {
            let hits = u32::from(hits);
            // The stencil buffer counts to 255.
            let allowed = |must: u32, may: u32| (must.min(255)..=(must + may).min(255)).contains(&hits);
            let right = allowed(sample.must, sample.may);
            counts.must += u64::from(sample.must > 0);
            counts.may += u64::from(sample.may > 0);
            counts.wrong += u64::from(!right);
            counts.beyond += u64::from(!right && !allowed(sample.must_wide, sample.may_wide));
            counts.off_rule += u64::from(right && !sample.uncertain && hits != sample.rule.min(255));
        }
        counts
    }

    /// Samples that exactly one primitive must cover and no other may: index of the pixel, number of the primitive.
    pub fn owned(&self) -> impl Iterator<Item = (usize, u32)> {
        self.samples.iter().enumerate().filter(|(_, s)| s.must == 1 && s.may == 0).map(|(i, s)| (i, s.owner))
    }

    /// The image that this implementation-independent judgement would accept with every doubtful sample left out.
    #[cfg(test)]
    fn least(&self) -> Vec<u8> {
        self.samples.iter().map(|s| s.must.min(255) as u8).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn placed(positions: [[f32; 2]; 3]) -> Placed {
        let view = View::pixels(64, 64);
        let transform = Transform::new(&view).unwrap();
        Placed::triangle(&view, &transform, positions.map(|[x, y]| [x, y, 0.0, 1.0])).unwrap()
    }

    #[test]
    fn a_known_triangle_is_judged_sample_by_sample() {
        // Right-angled, legs of 4 pixels along pixel borders: samples (i + 0.5, j + 0.5) with i + j + 1 < 4 lie inside;
        // those with i + j + 1 = 4 lie on the long side.
        let t = placed([[0.0, 0.0], [4.0, 0.0], [0.0, 4.0]]);
        for i in 0..6 {
            for j in 0..6 {
                let expected = match i + j + 1 {
                    0..4 => Coverage3::Must,
                    4 if i < 4 && j < 4 => Coverage3::May,
                    _ => Coverage3::MustNot,
                };
                assert_eq!(classify(&t.polygon, [i as f64 + 0.5, j as f64 + 0.5], t.band), expected, "{i}, {j}");
            }
        }
    }

    #[test]
    fn no_snapping_within_half_a_subpixel_contradicts_the_judgement() {
        // Brute force: every corner moved to any of 9 places within half a subpixel, the triangle then judged by the snapped
        // rule in finer units.
        let moved = |v: f64, by: i128| ((v - 0.5) * 512.0).round() as i128 * 2 + by;
        let mut seen = [0; 3];
        for case in 0..40u32 {
            let f = |k: u32| (f64::from((case * 7919 + k * 104729) % 4096) / 512.0) as f32;
            let p = [[f(1), f(2)], [f(3), f(4)], [f(5), f(6)]];
            let t = placed(p);
            for row in 0..9 {
                for column in 0..9 {
                    let judged = classify(&t.polygon, [column as f64 + 0.5, row as f64 + 0.5], t.band);
                    seen[judged as usize] += 1;
                    if judged == Coverage3::May {
                        continue;
                    }
                    for shift in 0..729 {
                        let by = |k: i128| (shift / 3i128.pow(k as u32) % 3 - 1) * 2;
                        // Units of 1/1024 pixel, scaled to the rule's 1/256 by asking for pixel positions four times as far.
                        let corner =
                            |i: usize| [moved(f64::from(p[i][0]), by(2 * i as i128)), moved(f64::from(p[i][1]), by(2 * i as i128 + 1))];
                        let covers = snapped::covers(&[corner(0), corner(1), corner(2)], column * 4, row * 4);
                        assert_eq!(covers, judged == Coverage3::Must, "case {case}, {column}, {row}");
                    }
                }
            }
        }
        assert!(seen.iter().all(|n| *n > 0), "{seen:?}");
    }

    #[test]
    fn wrong_images_are_found_and_right_ones_are_not() {
        let mut coverage = Coverage::new(64, 64);
        let p = [[3.0, 3.0], [40.3, 5.1], [20.7, 50.2]];
        coverage.add(Some(&placed(p)), |_, _| true);
        let mut image = coverage.least();
        assert_eq!(coverage.judge(&image).wrong, 0);
        image[20 * 64 + 20] += 1;
        image[63] += 1;
        let counts = coverage.judge(&image);
        assert_eq!((counts.wrong, counts.beyond), (2, 2));
        // A double hit where only one primitive is.
        assert!(coverage.owned().any(|(i, owner)| i == 20 * 64 + 20 && owner == 0));
    }

    #[test]
    fn clipped_primitives_are_judged_by_what_is_left() {
        // A triangle that contains the whole window: all of its samples must be covered, wherever its corners lie.
        for far in [100.0f32, 1e6, 1e30] {
            let mut coverage = Coverage::new(16, 16);
            let view = View::pixels(16, 16);
            let corners = [[-far, -far, 0.0, 1.0], [3.0 * far, -far, 0.0, 1.0], [-far, 3.0 * far, 0.0, 1.0]];
            let placed = Placed::triangle(&view, &Transform::new(&view).unwrap(), corners);
            coverage.add(placed.as_ref(), |_, _| true);
            assert_eq!(coverage.judge(&[1; 256]).wrong, 0);
            assert_eq!(coverage.judge(&[0; 256]).wrong, 256);
        }
    }

    #[test]
    fn on_grid_corners_leave_nothing_open_to_the_rule() {
        let mut coverage = Coverage::new(8, 8);
        coverage.add(Some(&placed([[0.5, 0.5], [4.5, 0.5], [0.5, 4.5]])), |_, _| true);
        let right: Vec<u8> = (0..64).map(|i| u8::from(i % 8 + i / 8 < 4)).collect();
        assert_eq!(coverage.judge(&right), Counts { samples: 64, must: 3, may: 12, ..Counts::default() });
        let mut other = right.clone();
        other[0] = 0;
        assert_eq!(coverage.judge(&other).off_rule, 1);
    }
}
