//! What families share: random numbers, the judgement of coloured triangles, cells of constant colour.

use std::cell::OnceCell;

use crate::frame::Frame;
use crate::oracle::Coverage;
use crate::oracle::coverage::Placed;
use crate::oracle::exact::Transform;
use crate::oracle::values::{Triangle, ValueError};
use crate::recording::{Recording, Vertex, View, gl, has};

use super::{Case, Score};

/// The same numbers everywhere: splitmix64, as in scene.c.
pub struct Random(u64);

impl Random {
    /// A stream for a family's name, severity and seed.
    pub fn new(family: &str, severity: f64, seed: u64) -> Random {
        let name = family.bytes().fold(0xcbf2_9ce4_8422_2325u64, |h, b| (h ^ u64::from(b)).wrapping_mul(0x100_0000_01b3));
        Random(name ^ severity.to_bits().rotate_left(17) ^ seed.wrapping_mul(0x9E37_79B9_7F4A_7C15))
    }

    /// 64 bits.
    pub fn bits(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let z = (self.0 ^ self.0 >> 30).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        let z = (z ^ z >> 27).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ z >> 31
    }

    /// Uniform, 24 bits.
    pub fn uniform(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * ((self.bits() >> 40) as f64 / 16777216.0)
    }

    /// 0 to n - 1.
    pub fn below(&mut self, n: u64) -> u64 {
        self.bits() % n
    }

    /// A colour, opaque.
    pub fn color(&mut self) -> [f32; 4] {
        [self.uniform(0.0, 1.0) as f32, self.uniform(0.0, 1.0) as f32, self.uniform(0.0, 1.0) as f32, 1.0]
    }
}

/// Adds an error of each colour component of pixel `pixel`: `right` is clamped to 0 to 1.
pub fn compare_color(frame: &Frame, pixel: usize, right: &[f64], error: &mut ValueError) {
    for (k, right) in right.iter().enumerate() {
        error.add(f64::from(frame.color[pixel * 4 + k]), right.clamp(0.0, 1.0) * 255.0);
    }
}

/// A depth that was read and the right one in units in the last place of the buffer; of floating point, in that of the right one.
fn in_units(found: u32, right: f64, depth_bits: u32) -> [f64; 2] {
    if depth_bits == 32 {
        let unit = 2f64.powi(right.max(f32::MIN_POSITIVE.into()).log2().floor() as i32 - 23);
        return [f64::from(f32::from_bits(found)) / unit, right / unit];
    }
    [found.into(), right * f64::from((1u32 << depth_bits) - 1)]
}

/// Judges a triangle list with smooth colours, drawn with the depth function ALWAYS while samples count their hits. Values are compared
/// in triangles that are `healthy`.
pub fn judge_triangles(
    frame: &Frame,
    coverage: &Coverage,
    view: &View,
    vertices: &[Vertex],
    depth_bits: u32,
    healthy: impl Fn(u32) -> bool,
) -> Score {
    let mut score = Score { counts: coverage.judge(&frame.stencil), ..Score::default() };
    let triangles: Vec<Triangle> =
        vertices.chunks_exact(3).map(|t| Triangle::new(view, [t[0].position, t[1].position, t[2].position])).collect();
    for (pixel, owner) in coverage.owned() {
        if frame.stencil[pixel] != 1 || !healthy(owner) {
            continue;
        }
        let weights = triangles[owner as usize].at([(pixel % frame.width) as f64 + 0.5, (pixel / frame.width) as f64 + 0.5]);
        let corners = &vertices[owner as usize * 3..][..3];
        let [found, right] = in_units(frame.depth[pixel], weights.depth.clamp(0.0, 1.0), depth_bits);
        score.depth.add(found, right);
        compare_color(frame, pixel, &weights.mix([corners[0].color, corners[1].color, corners[2].color])[..3], &mut score.color);
    }
    score
}

/// A recording of such a triangle list.
pub fn record_triangles(view: &View, width: usize, height: usize, depth_bits: u32, vertices: &[Vertex]) -> Recording {
    let mut recording = Recording::new(width, height, depth_bits);
    recording.view(view).count_hits().enable(gl::DEPTH_TEST).call("depth_func", &[gl::ALWAYS.into()], &[]);
    recording.draw(gl::TRIANGLES, has::COLOR, vertices);
    recording
}

/// Coverage of a triangle list, with a mask.
pub fn cover(view: &View, width: usize, height: usize, vertices: &[Vertex], mask: impl Fn(usize, usize) -> bool) -> Coverage {
    let mut coverage = Coverage::new(width, height);
    let transform = Transform::new(view);
    for t in vertices.chunks_exact(3) {
        let positions = [t[0].position, t[1].position, t[2].position];
        let placed = transform.as_ref().and_then(|transform| Placed::triangle(view, transform, positions));
        coverage.add(placed.as_ref(), &mask);
    }
    coverage
}

/// The case of a triangle list.
pub fn triangles(view: View, width: usize, height: usize, depth_bits: u32, vertices: Vec<Vertex>) -> Case {
    let recording = record_triangles(&view, width, height, depth_bits, &vertices);
    // The same for every implementation.
    let coverage = OnceCell::new();
    let judge = move |frame: &Frame| {
        let coverage = coverage.get_or_init(|| cover(&view, width, height, &vertices, |_, _| true));
        judge_triangles(frame, coverage, &view, &vertices, depth_bits, |_| true)
    };
    Case { recording, judge: Box::new(judge) }
}

/// Cells of a window, drawn as points of [`Cells::SIZE`] pixels, each with a colour that the oracle knows.
pub struct Cells {
    /// The colour of each, in order; `None` where it is not defined.
    pub colors: Vec<Option<[f64; 3]>>,
    /// How often each is drawn.
    pub hits: u8,
}

impl Cells {
    /// Pixels across of a cell's point.
    pub const SIZE: usize = 6;
    /// Pixels across of a cell.
    const PITCH: usize = 8;
    /// Cells in a row.
    const COLUMNS: usize = 16;

    /// The window's side.
    pub const WINDOW: usize = Cells::PITCH * Cells::COLUMNS;

    /// Window coordinates of the centre of cell `k`; an even point's square is placed from it.
    pub fn centre(k: usize) -> [f64; 2] {
        [k % Cells::COLUMNS, k / Cells::COLUMNS].map(|c| (c * Cells::PITCH + Cells::PITCH / 2) as f64)
    }

    /// As many as fit.
    pub const ALL: usize = Cells::COLUMNS * Cells::COLUMNS;

    /// The state that the points need.
    pub fn begin(recording: &mut Recording) {
        recording.call("point_size", &[], &[Cells::SIZE as f32]).count_hits();
    }

    /// Judges the image: every point where it should be, in its colour.
    pub fn judge(&self, frame: &Frame) -> Score {
        let mut score = Score::default();
        score.counts.samples = frame.stencil.len() as u64;
        let half = Cells::SIZE / 2;
        let mut expected = vec![0u8; frame.stencil.len()];
        for (k, color) in self.colors.iter().enumerate() {
            let [x, y] = Cells::centre(k).map(|v| v as usize);
            for row in y - half..y + half {
                for column in x - half..x + half {
                    let pixel = row * frame.width + column;
                    expected[pixel] = self.hits;
                    if let Some(color) = color {
                        compare_color(frame, pixel, color, &mut score.color);
                    }
                }
            }
        }
        score.counts.must = expected.iter().filter(|e| **e > 0).count() as u64;
        score.counts.wrong = expected.iter().zip(&frame.stencil).filter(|(e, s)| e != s).count() as u64;
        score.counts.beyond = score.counts.wrong;
        score
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn units_of_floating_point_are_those_of_the_right_depth() {
        let error = |found: f32, right: f64| {
            let [found, right] = in_units(found.to_bits(), right, 32);
            found - right
        };
        assert_eq!(error(0.5, 0.5), 0.0);
        assert_eq!(error(f32::from_bits(0.75f32.to_bits() + 3), 0.75), 3.0);
        assert_eq!(error(f32::from_bits(1e-3f32.to_bits() - 2), 1e-3f32.into()), -2.0);
        assert_eq!(in_units(0xff_ffff, 0.5, 24), [16777215.0, 8388607.5]);
    }
}
