//! Families about edges that triangles share: every sample inside the mesh is hit once.

use super::common::Random;
use super::{Case, Family, Score};
use crate::frame::Frame;
use crate::recording::{Recording, Vertex, View, gl, has};

/// Pixels across.
const SIDE: usize = 512;
/// The mesh fills the window but for a border of so many pixels.
const BORDER: usize = 8;
/// Subpixels across of the mesh.
const EXTENT: i64 = ((SIDE - 2 * BORDER) * 256) as i64;

/// The families. Severities are triangles an image.
pub fn families() -> Vec<Family> {
    vec![
        Family {
            name: "mesh_fan",
            about: "A fan around an inner point, its rim on pixel borders. Samples inside are hit exactly once, outside never.",
            knob: "triangles",
            severities: &[8.0, 64.0, 1024.0, 16384.0, 65536.0],
            inside: |_| true,
            make: |severity, seed| {
                let mut random = Random::new("mesh_fan", severity, seed);
                vec![mesh(&fan(&mut random, severity as i64))]
            },
        },
        Family {
            name: "mesh_grid",
            about: "A grid without T-junctions, its inner corners moved at random, off the subpixel grid.",
            knob: "triangles",
            severities: &[8.0, 512.0, 8192.0, 131072.0],
            inside: |_| true,
            make: |severity, seed| {
                let mut random = Random::new("mesh_grid", severity, seed);
                vec![mesh(&grid(&mut random, (severity / 2.0).sqrt() as usize))]
            },
        },
        Family {
            name: "mesh_random",
            about: "A random planar subdivision: points are put into triangles again and again, until most are slivers.",
            knob: "triangles",
            severities: &[8.0, 512.0, 8192.0, 131072.0],
            inside: |_| true,
            make: |severity, seed| {
                let mut random = Random::new("mesh_random", severity, seed);
                vec![mesh(&subdivision(&mut random, severity as usize))]
            },
        },
    ]
}

/// Position in subpixels from the mesh's lower left corner.
type Point = [f64; 2];

fn fan(random: &mut Random, triangles: i64) -> Vec<[Point; 3]> {
    let centre = [0, 1].map(|_| random.uniform(0.3, 0.7) * EXTENT as f64);
    // Corners of the rim in order around the border, the square's own four among them.
    let mut along: Vec<i64> = (0..triangles - 4).map(|_| random.below(4 * EXTENT as u64) as i64).collect();
    along.extend((0..4).map(|k| k * EXTENT));
    along.sort_unstable();
    let rim = |s: i64| {
        let (side, t) = (s / EXTENT, s % EXTENT);
        let [x, y] = [[t, 0], [EXTENT, t], [EXTENT - t, EXTENT], [0, EXTENT - t]][side as usize];
        [x as f64, y as f64]
    };
    (0..along.len()).map(|i| [centre, rim(along[i]), rim(along[(i + 1) % along.len()])]).collect()
}

fn grid(random: &mut Random, cells: usize) -> Vec<[Point; 3]> {
    let cell = EXTENT as f64 / cells as f64;
    let mut place = |i: usize| {
        let move_by = if i == 0 || i == cells { 0.0 } else { random.uniform(-0.24, 0.24) };
        (i as f64 + move_by) * cell
    };
    let corners: Vec<Vec<Point>> = (0..=cells).map(|j| (0..=cells).map(|i| [place(i), place(j)]).collect()).collect();
    let mut turn = Random::new("diagonals", cells as f64, random.bits());
    (0..cells * cells)
        .flat_map(|k| {
            let (i, j) = (k % cells, k / cells);
            let [a, b, c, d] = [corners[j][i], corners[j][i + 1], corners[j + 1][i + 1], corners[j + 1][i]];
            if turn.below(2) == 0 { [[a, b, c], [a, c, d]] } else { [[a, b, d], [d, b, c]] }
        })
        .collect()
}

/// Points are subpixels and strictly inside the triangle that they divide, so that snapping cannot turn a triangle over.
fn subdivision(random: &mut Random, triangles: usize) -> Vec<[Point; 3]> {
    let e = EXTENT;
    let mut mesh = vec![[[0, 0], [e, 0], [e, e]], [[0, 0], [e, e], [0, e]]];
    let area = |[a, b, c]: [[i64; 2]; 3]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    // Triangles that are too thin for another point are met again and again: give up on the count rather than search.
    for _ in 0..triangles * 4 {
        if mesh.len() >= triangles {
            break;
        }
        let k = random.below(mesh.len() as u64) as usize;
        let [a, b, c] = mesh[k];
        let (mut u, mut v) = (random.uniform(0.0, 1.0), random.uniform(0.0, 1.0));
        if u + v > 1.0 {
            (u, v) = (1.0 - u, 1.0 - v);
        }
        let p = [0, 1].map(|k| (a[k] as f64 + u * (b[k] - a[k]) as f64 + v * (c[k] - a[k]) as f64).round() as i64);
        let parts = [[a, b, p], [b, c, p], [c, a, p]];
        if parts.iter().all(|t| area(*t) > 0) {
            mesh[k] = parts[0];
            mesh.extend_from_slice(&parts[1..]);
        }
    }
    mesh.iter().map(|t| t.map(|p| p.map(|v| v as f64))).collect()
}

fn mesh(triangles: &[[Point; 3]]) -> Case {
    let vertices: Vec<Vertex> = triangles
        .iter()
        .flatten()
        .map(|p| {
            let [x, y] = p.map(|v| (BORDER as f64 + v / 256.0) as f32);
            Vertex::new(x, y, 0.0)
        })
        .collect();
    let mut recording = Recording::new(SIDE, SIDE, 24);
    recording.view(&View::pixels(SIDE, SIDE)).count_hits().draw(gl::TRIANGLES, has::POSITION, &vertices);
    Case { recording, judge: Box::new(judge) }
}

fn judge(frame: &Frame) -> Score {
    let mut score = Score::default();
    let inside = BORDER..SIDE - BORDER;
    for (pixel, &hits) in frame.stencil.iter().enumerate() {
        let covered = inside.contains(&(pixel % SIDE)) && inside.contains(&(pixel / SIDE));
        score.counts.samples += 1;
        score.counts.must += u64::from(covered);
        score.counts.wrong += u64::from(hits != u8::from(covered));
        score.holes += u64::from(covered && hits == 0);
        score.doubles += u64::from(covered && hits > 1);
    }
    score.counts.beyond = score.counts.wrong;
    score
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meshes_have_the_area_of_their_square_and_no_triangle_turned_over() {
        let area = |[a, b, c]: &[Point; 3]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let mut random = Random::new("test", 1.0, 1);
        for mesh in [fan(&mut random, 300), grid(&mut random, 20), subdivision(&mut random, 500)] {
            assert!(mesh.iter().all(|t| area(t) >= 0.0));
            let sum: f64 = mesh.iter().map(area).sum::<f64>() / 2.0;
            assert!((sum / (EXTENT * EXTENT) as f64 - 1.0).abs() < 1e-9);
        }
    }
}
