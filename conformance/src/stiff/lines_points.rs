//! Families about points and lines at their size limits, and lines whose ends are far away.
//!
//! Points are squares of whole pixels (3.3): exact but for places that snapping may move over a border. Lines may deviate from the
//! diamond-exit rule by one pixel (3.4.1), so their judgement leaves a border of one pixel; but in every column of an x-major line
//! (row of a y-major one) just as many fragments lie as the line is wide.

use super::common::Random;
use super::{Case, Family, Score};
use crate::frame::Frame;
use crate::oracle::clip;
use crate::oracle::coverage::HALF_SUBPIXEL;
use crate::oracle::exact::Transform;
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
                (0..16)
                    .map(|_| {
                        let ends = ends(&mut random, 150.0);
                        line(ends, severity as u32)
                    })
                    .collect()
            },
        },
        Family {
            name: "lines_far",
            about: "Lines through the window, their ends at the distance that the severity says.",
            knob: "distance, in pixels",
            severities: &[100.0, 1e3, 8e3, 1e5, 1e7, 1e15, 1e30],
            inside: |severity| severity < 8192.0,
            make: |severity, seed| {
                let mut random = Random::new("lines_far", severity, seed);
                (0..16)
                    .map(|_| {
                        let ends = ends(&mut random, severity);
                        line(ends, 1)
                    })
                    .collect()
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

fn line(ends: [[f32; 4]; 2], width: u32) -> Case {
    let view = View::pixels(SIDE, SIDE);
    let mut recording = Recording::new(SIDE, SIDE, 24);
    let vertices = ends.map(|position| Vertex { position, ..Vertex::new(0.0, 0.0, 0.0) });
    recording.view(&view).count_hits().call("line_width", &[], &[width as f32]).draw(gl::LINES, has::POSITION, &vertices);
    Case { recording, judge: Box::new(move |frame| judge_line(frame, &view, ends, f64::from(width))) }
}

fn judge_line(frame: &Frame, view: &View, ends: [[f32; 4]; 2], width: f64) -> Score {
    let mut score = Score::default();
    // A polygon of two corners, cut like any other.
    let transform = Transform::new(view);
    let left = transform.as_ref().and_then(|t| t.clip(&ends).map(|(clips, _)| clip::polygon(clips).0)).unwrap_or_default();
    let places: Vec<[f64; 2]> = transform.iter().flat_map(|t| left.iter().map(|v| t.window(v))).collect();
    let (mut must, mut may) = (vec![0; SIDE * SIDE], vec![0; SIDE * SIDE]);
    // Its direction decides which axis is the major one; the parts that are left have the same.
    let spread = |k: usize| (f64::from(ends[1][k]) - f64::from(ends[0][k])).abs();
    let (major, minor) = if spread(0) >= spread(1) { (0, 1) } else { (1, 0) };
    let ordered = |a: &&[f64; 2], b: &&[f64; 2]| a[major].total_cmp(&b[major]);
    let (Some(a), Some(b)) = (places.iter().min_by(ordered), places.iter().max_by(ordered)) else {
        tally(frame, &must, &may, &mut score);
        return score;
    };
    let slope = (b[minor] - a[minor]) / (b[major] - a[major]).max(1e-300);
    let mut columns = vec![[0u32; 2]; SIDE];
    for (pixel, &hits) in frame.stencil.iter().enumerate() {
        let at = [(pixel % SIDE) as f64 + 0.5, (pixel / SIDE) as f64 + 0.5];
        let off = (at[minor] - (a[minor] + slope * (at[major] - a[major]))).abs();
        let surely_along = at[major] > a[major] + 1.0 && at[major] < b[major] - 1.0;
        let maybe_along = at[major] >= a[major] - 1.0 && at[major] <= b[major] + 1.0;
        if surely_along && off < width / 2.0 - 1.0 - HALF_SUBPIXEL {
            must[pixel] = 1;
        } else if maybe_along && off <= width / 2.0 + 1.0 + HALF_SUBPIXEL {
            may[pixel] = 1;
        }
        if surely_along {
            columns[at[major] as usize][0] += u32::from(hits);
            columns[at[major] as usize][1] = 1;
        }
    }
    tally(frame, &must, &may, &mut score);
    // As many fragments as the line is wide, unless the border of the window cuts them off.
    let margin = width / 2.0 + 1.0;
    for (column, [hits, along]) in columns.into_iter().enumerate() {
        let middle = a[minor] + slope * (column as f64 + 0.5 - a[major]);
        if along == 1 && middle > margin && middle < SIDE as f64 - margin && hits != width as u32 {
            score.counts.wrong += 1;
            score.counts.beyond += 1;
        }
    }
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
}
