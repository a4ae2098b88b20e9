//! Families about points and lines at their size limits, and lines whose ends are far away.
//!
//! Points are squares of whole pixels (3.3): exact but for places that snapping may move over a border. Lines may deviate from the
//! diamond-exit rule by one pixel (3.4.1), so their judgement leaves a border of one pixel; but in every column of an x-major line
//! (row of a y-major one) just as many fragments lie as the line is wide.

use super::common::Random;
use super::{Case, Family, Score};
use crate::frame::Frame;
use crate::oracle::coverage::HALF_SUBPIXEL;
use crate::oracle::exact::Transform;
use crate::oracle::{bound, clip};
use crate::recording::{Recording, Vertex, View, gl, has};

const SIDE: usize = 512;

/// The families.
pub fn families() -> Vec<Family> {
    vec![
        Family {
            name: "points",
            about: "Points from the least to the greatest size, all over the window and beyond its border (where they vanish with their centre, 2.11).",
            knob: "size, in pixels",
            severities: &[1.0, 2.0, 3.0, 10.0, 64.0, 255.0],
            inside: |_| true,
            make: |severity, seed| vec![points(severity, seed)],
        },
        Family {
            name: "lines_wide",
            about: "Lines of every direction, as wide as the severity says.",
            knob: "width, in pixels",
            severities: &[1.0, 2.0, 3.0, 10.0, 64.0, 255.0],
            inside: |_| true,
            make: |severity, seed| {
                let mut random = Random::new("lines_wide", severity, seed);
                (0..16).map(|_| line(View::pixels(SIDE, SIDE), ends(&mut random, 150.0), severity as u32)).collect()
            },
        },
        Family {
            name: "lines_far",
            about: "Lines whose ends lie at the distance that the severity says. Half of them run through the middle of the window exactly, as numbers and as a transform in single precision; of the others the nearest single-precision ends miss the window the more surely the farther they are.",
            knob: "distance, in pixels",
            severities: &[100.0, 1e3, 8e3, 1e5, 1e7, 1e15, 1e30],
            inside: |severity| severity < 8192.0,
            make: |severity, seed| {
                let mut random = Random::new("lines_far", severity, seed);
                let beside = (0..8).map(|_| line(View::pixels(SIDE, SIDE), ends(&mut random, severity), 1)).collect::<Vec<_>>();
                beside.into_iter().chain((0..8).map(|_| line(centred(), opposite(&mut random, severity), 1))).collect()
            },
        },
    ]
}

/// Both ends of a line about the middle of the window.
fn ends(random: &mut Random, reach: f64) -> [[f32; 4]; 2] {
    let angle = random.uniform(0.0, std::f64::consts::TAU);
    let middle = [0, 1].map(|_| SIDE as f64 / 2.0 + random.uniform(-60.0, 60.0));
    [-1.0, 1.0].map(|side| {
        let along = side * reach * random.uniform(0.7, 1.0);
        [(middle[0] + along * angle.cos()) as f32, (middle[1] + along * angle.sin()) as f32, 0.0, 1.0]
    })
}

fn points(size: f64, seed: u64) -> Case {
    let mut random = Random::new("points", size, seed);
    let view = View::pixels(SIDE, SIDE);
    let count = if size > 100.0 { 8 } else { 60 };
    let vertices: Vec<Vertex> = (0..count)
        .map(|_| {
            let mut c = || random.uniform(-30.0, SIDE as f64 + 30.0) as f32;
            Vertex::new(c(), c(), 0.0)
        })
        .collect();
    let mut recording = Recording::new(SIDE, SIDE, 24);
    recording.view(&view).count_hits().call("point_size", &[], &[size as f32]).draw(gl::POINTS, has::POSITION, &vertices);
    Case { recording, judge: Box::new(move |frame| judge_points(frame, &vertices, size)) }
}

/// First column or row that a point of `size` covers, where it is placed at `v`; two where snapping decides (3.3).
fn first(v: f64, size: f64) -> [f64; 2] {
    // An odd square is centred on the pixel that the place lies in, an even one on the nearest pixel corner.
    let (to, half) = if size as u64 % 2 == 1 { (0.0, (size - 1.0) / 2.0) } else { (0.5, size / 2.0) };
    // The transform's rounding in a window of 512 pixels is a tenth of this margin's.
    let margin = HALF_SUBPIXEL * 1.1;
    [(v - margin + to).floor() - half, (v + margin + to).floor() - half]
}

fn judge_points(frame: &Frame, vertices: &[Vertex], size: f64) -> Score {
    let mut score = Score::default();
    let (mut must, mut may) = (vec![0u32; SIDE * SIDE], vec![0u32; SIDE * SIDE]);
    for vertex in vertices {
        let [x, y] = [0, 1].map(|k| f64::from(vertex.position[k]));
        let side = SIDE as f64;
        // Clipped by their centre; on the border itself rounding decides, and no point lies that near.
        if [x, y].iter().any(|v| *v < 0.0 || *v > side) {
            continue;
        }
        let (columns, rows) = (first(x, size), first(y, size));
        for row in rows[0].max(0.0) as usize..(rows[1] + size).clamp(0.0, side) as usize {
            for column in columns[0].max(0.0) as usize..(columns[1] + size).clamp(0.0, side) as usize {
                let surely = |v: usize, range: [f64; 2]| v as f64 >= range[1] && (v as f64) < range[0] + size;
                let counted = if surely(column, columns) && surely(row, rows) { &mut must } else { &mut may };
                counted[row * SIDE + column] += 1;
            }
        }
    }
    tally(frame, &must, &may, &mut score);
    score
}

/// Counts samples whose hits are not allowed.
fn tally(frame: &Frame, must: &[u32], may: &[u32], score: &mut Score) {
    for ((hits, must), may) in frame.stencil.iter().zip(must).zip(may) {
        score.counts.samples += 1;
        score.counts.must += u64::from(*must > 0);
        score.counts.may += u64::from(*may > 0);
        score.counts.wrong += u64::from(!(*must..=must + may).contains(&u32::from(*hits)));
    }
    score.counts.beyond = score.counts.wrong;
}

/// A view like that of pixels whose origin is the middle of the window.
fn centred() -> View {
    let mut view = View::pixels(SIDE, SIDE);
    view.projection[12] = 0.0;
    view.projection[13] = 0.0;
    view
}

/// Both ends of a line through the origin, exactly: one is the other times a power of two.
fn opposite(random: &mut Random, reach: f64) -> [[f32; 4]; 2] {
    let angle = random.uniform(0.0, std::f64::consts::TAU);
    let [x, y] = [angle.cos(), angle.sin()].map(|d| (d * reach) as f32);
    [[x, y, 0.0, 1.0], [-0.5 * x, -0.5 * y, 0.0, 1.0]]
}

fn line(view: View, ends: [[f32; 4]; 2], width: u32) -> Case {
    let mut recording = Recording::new(SIDE, SIDE, 24);
    let vertices = ends.map(|position| Vertex { position, ..Vertex::new(0.0, 0.0, 0.0) });
    recording.view(&view).count_hits().call("line_width", &[], &[width as f32]).draw(gl::LINES, has::POSITION, &vertices);
    Case { recording, judge: Box::new(move |frame| judge_line(frame, &view, ends, f64::from(width))) }
}

/// What is left of a line after clipping.
struct Segment {
    /// Its ends, in the order of the major axis.
    ends: [[f64; 2]; 2],
    /// Indices of the major and the minor axis.
    axes: [usize; 2],
    /// How far single-precision clipping may be off, in pixels.
    slack: f64,
}

impl Segment {
    fn new(view: &View, ends: [[f32; 4]; 2]) -> Option<Segment> {
        let transform = Transform::new(view)?;
        // A polygon of two corners, cut like any other.
        let (left, cut) = clip::polygon(transform.clip(&ends)?.0);
        let places: Vec<[f64; 2]> = left.iter().map(|v| transform.window(v)).collect();
        // The whole line's direction decides which axis is the major one; a part of it may be too short to tell.
        let spread = |k: usize| (f64::from(ends[1][k]) - f64::from(ends[0][k])).abs();
        let axes = if spread(0) >= spread(1) { [0, 1] } else { [1, 0] };
        let ordered = |a: &&[f64; 2], b: &&[f64; 2]| a[axes[0]].total_cmp(&b[axes[0]]);
        let ends_left = [*places.iter().min_by(ordered)?, *places.iter().max_by(ordered)?];
        // In this family's views w is one everywhere.
        let slack = if cut { bound::clip(view, &ends, 1.0) } else { 0.0 };
        Some(Segment { ends: ends_left, axes, slack })
    }

    /// Samples that must be covered, samples that may be, and columns (rows of a y-major line) with a wrong number of fragments.
    fn judge(&self, frame: &Frame, width: f64, slack: f64) -> (Vec<u32>, Vec<u32>, u64) {
        let ([a, b], [major, minor]) = (self.ends, self.axes);
        let (mut must, mut may) = (vec![0; SIDE * SIDE], vec![0; SIDE * SIDE]);
        let slope = (b[minor] - a[minor]) / (b[major] - a[major]).max(1e-300);
        let mut columns = vec![None; SIDE];
        for (pixel, &hits) in frame.stencil.iter().enumerate() {
            let at = [(pixel % SIDE) as f64 + 0.5, (pixel / SIDE) as f64 + 0.5];
            let off = (at[minor] - (a[minor] + slope * (at[major] - a[major]))).abs();
            let (inner, outer) = (1.0 + slack, 1.0 + slack + HALF_SUBPIXEL);
            let surely_along = at[major] > a[major] + inner && at[major] < b[major] - inner;
            let maybe_along = at[major] >= a[major] - inner && at[major] <= b[major] + inner;
            if surely_along && off < width / 2.0 - outer {
                must[pixel] = 1;
            } else if maybe_along && off <= width / 2.0 + outer {
                may[pixel] = 1;
            }
            if surely_along {
                *columns[at[major] as usize].get_or_insert(0) += u32::from(hits);
            }
        }
        // As many fragments as the line is wide, unless the border of the window cuts them off.
        let margin = width / 2.0 + 1.0 + slack;
        let wrong = columns.into_iter().enumerate().filter(|(column, hits)| {
            let middle = a[minor] + slope * (*column as f64 + 0.5 - a[major]);
            let whole = middle > margin && middle < SIDE as f64 - margin;
            hits.is_some_and(|hits| whole && hits != width as u32)
        });
        (must, may, wrong.count() as u64)
    }
}

fn judge_line(frame: &Frame, view: &View, ends: [[f32; 4]; 2], width: f64) -> Score {
    let mut score = Score::default();
    let Some(segment) = Segment::new(view, ends) else {
        tally(frame, &vec![0; SIDE * SIDE], &vec![0; SIDE * SIDE], &mut score);
        return score;
    };
    let (must, may, columns) = segment.judge(frame, width, 0.0);
    tally(frame, &must, &may, &mut score);
    score.counts.wrong += columns;
    let mut wide = Score::default();
    let (must, may, columns) = segment.judge(frame, width, segment.slack);
    tally(frame, &must, &may, &mut wide);
    score.counts.beyond = wide.counts.wrong + columns;
    score
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn points_are_placed_as_the_specification_says() {
        assert_eq!(first(10.3, 1.0), [10.0, 10.0]);
        assert_eq!(first(10.3, 3.0), [9.0, 9.0]);
        assert_eq!(first(10.3, 2.0), [9.0, 9.0]);
        assert_eq!(first(10.7, 2.0), [10.0, 10.0]);
        assert_eq!(first(10.0, 1.0), [9.0, 10.0]);
    }

    #[test]
    fn a_line_that_lacks_a_pixel_or_lies_elsewhere_is_wrong() {
        let view = View::pixels(SIDE, SIDE);
        let ends = [[10.5, 20.5, 0.0, 1.0], [90.5, 40.5, 0.0, 1.0]];
        let draw = |at: &dyn Fn(usize) -> Option<usize>| {
            let mut stencil = vec![0; SIDE * SIDE];
            for x in 10..90 {
                if let Some(y) = at(x) {
                    stencil[y * SIDE + x] = 1;
                }
            }
            judge_line(&Frame::of_stencil(SIDE, stencil), &view, ends, 1.0).counts.wrong
        };
        let ideal = |x: usize| 20 + (x - 10).div_ceil(4);
        assert_eq!(draw(&|x| Some(ideal(x))), 0);
        assert_eq!(draw(&|x| (x != 50).then(|| ideal(x))), 1, "a gap");
        assert!(draw(&|x| Some(ideal(x) + 3)) > 70, "three pixels above");
    }
}
