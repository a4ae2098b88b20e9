//! Families about textures: large coordinates, textures one texel wide, minification, planes seen at a grazing angle. The oracle filters
//! in f64 by the formulas of 3.8.

use super::common::{Random, cover};
use super::{Case, Family, Score};
use crate::frame::Frame;
use crate::oracle::values::Triangle;
use crate::recording::{Recording, Vertex, View, gl, has};

const SIDE: usize = 256;

/// The families.
pub fn families() -> Vec<Family> {
    vec![
        Family {
            name: "texture_far_nearest",
            about: "NEAREST, coordinates that begin at the severity: single precision has ever fewer bits for the texel. Within 1/256 texel of a border both texels are right.",
            knob: "coordinate",
            severities: &[1.0, 16.0, 256.0, 4096.0, 65536.0, 1e6],
            inside: |_| true,
            make: |severity, seed| vec![filtered("texture_far_nearest", severity, seed, [64, 64], severity, false)],
        },
        Family {
            name: "texture_far_linear",
            about: "The same with LINEAR.",
            knob: "coordinate",
            severities: &[1.0, 16.0, 256.0, 4096.0, 65536.0, 1e6],
            inside: |_| true,
            make: |severity, seed| vec![filtered("texture_far_linear", severity, seed, [64, 64], severity, true)],
        },
        Family {
            name: "texture_thin",
            about: "LINEAR on textures one texel wide or high, up to 2048 long.",
            knob: "length, in texels",
            severities: &[1.0, 2.0, 64.0, 512.0, 2048.0],
            inside: |_| true,
            make: |severity, seed| {
                let n = severity as usize;
                vec![
                    filtered("texture_thin", severity, seed, [1, n], 0.0, true),
                    filtered("texture_thin", severity, seed + 1000, [n, 1], 0.0, true),
                ]
            },
        },
        Family {
            name: "texture_minified",
            about: "Trilinear filtering of levels of one colour each, so that the colour tells the level of detail. Any scale factor between the larger axis and the sum of both is allowed (3.8.8).",
            knob: "texels a pixel",
            severities: &[1.0, 3.0, 10.0, 100.0, 1000.0, 1e6],
            inside: |_| true,
            make: |severity, seed| vec![minified(severity, seed)],
        },
        Family {
            name: "texture_grazing",
            about: "A plane seen from just above it. Derivatives anywhere within a pixel of the sample are allowed.",
            knob: "length : height of the eye",
            severities: &[4.0, 32.0, 256.0, 2048.0],
            inside: |_| true,
            make: |severity, seed| vec![grazing(severity, seed)],
        },
    ]
}

fn parameters(recording: &mut Recording, min: u32, mag: u32) {
    for (pname, value) in
        [(gl::TEXTURE_MIN_FILTER, min), (gl::TEXTURE_MAG_FILTER, mag), (gl::TEXTURE_WRAP_S, gl::REPEAT), (gl::TEXTURE_WRAP_T, gl::REPEAT)]
    {
        recording.call("tex_parameter", &[pname.into(), value.into()], &[]);
    }
    recording.enable(gl::TEXTURE_2D).call("tex_env", &[gl::REPLACE.into()], &[]).count_hits();
}

/// Texels of an image that repeats.
struct Image {
    size: [usize; 2],
    texels: Vec<[u8; 4]>,
}

impl Image {
    fn texel(&self, i: f64, j: f64) -> [f64; 3] {
        let [x, y] = [(i, self.size[0]), (j, self.size[1])].map(|(v, n)| v.rem_euclid(n as f64) as usize);
        let texel = self.texels[y * self.size[0] + x];
        [0, 1, 2].map(|c| f64::from(texel[c]) / 255.0)
    }

    /// The bilinear filter of 3.8.8.
    fn linear(&self, s: f64, t: f64) -> [f64; 3] {
        let (u, v) = (s * self.size[0] as f64 - 0.5, t * self.size[1] as f64 - 0.5);
        let (i, j) = (u.floor(), v.floor());
        let (a, b) = (u - i, v - j);
        let corners = [self.texel(i, j), self.texel(i + 1.0, j), self.texel(i, j + 1.0), self.texel(i + 1.0, j + 1.0)];
        [0, 1, 2].map(|c| (1.0 - b) * ((1.0 - a) * corners[0][c] + a * corners[1][c]) + b * ((1.0 - a) * corners[2][c] + a * corners[3][c]))
    }

    /// The texels that NEAREST may take.
    fn nearest(&self, s: f64, t: f64) -> Vec<[f64; 3]> {
        let (u, v) = (s * self.size[0] as f64, t * self.size[1] as f64);
        let near = |v: f64| [(v - 1.0 / 256.0).floor(), (v + 1.0 / 256.0).floor()];
        near(u).into_iter().flat_map(|i| near(v).map(|j| self.texel(i, j))).collect()
    }
}

/// Two triangles of a rectangle with coordinates at its corners.
fn rectangle([x0, y0, x1, y1]: [f64; 4], coordinates: [[f64; 2]; 4]) -> [Vertex; 6] {
    let places = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
    [0, 1, 2, 0, 2, 3].map(|k| {
        let ([x, y], [s, t]) = (places[k], coordinates[k]);
        Vertex::new(x as f32, y as f32, 0.0).textured(s as f32, t as f32)
    })
}

/// Compares every owned sample with the colours that `right` allows, given as a range a component or as alternatives.
fn judge(frame: &Frame, view: &View, vertices: &[Vertex], allowed: impl Fn(&Triangle, &[Vertex], [f64; 2]) -> Vec<[[f64; 2]; 3]>) -> Score {
    let coverage = cover(view, SIDE, SIDE, vertices, |_, _| true);
    let mut score = Score { counts: coverage.judge(&frame.stencil), ..Score::default() };
    for (pixel, owner) in coverage.owned() {
        if frame.stencil[pixel] != 1 {
            continue;
        }
        let corners = &vertices[owner as usize * 3..][..3];
        let triangle = Triangle::new(view, [corners[0].position, corners[1].position, corners[2].position]);
        let window = [(pixel % SIDE) as f64 + 0.5, (pixel / SIDE) as f64 + 0.5];
        let found = [0, 1, 2].map(|c| f64::from(frame.color[pixel * 4 + c]));
        let distance = |range: &[[f64; 2]; 3]| {
            let off = (0..3).map(|c| (found[c] - found[c].clamp(range[c][0] * 255.0, range[c][1] * 255.0)).abs());
            off.fold(0.0, f64::max)
        };
        let error = allowed(&triangle, corners, window).iter().map(distance).fold(f64::INFINITY, f64::min);
        score.color.add(error, 0.0);
    }
    score
}

fn coordinate(triangle: &Triangle, corners: &[Vertex], window: [f64; 2]) -> [f64; 4] {
    triangle.at(window).mix([corners[0].coordinate, corners[1].coordinate, corners[2].coordinate])
}

/// 16 rectangles whose coordinates begin at `base`, magnified three times.
fn filtered(family: &str, severity: f64, seed: u64, size: [usize; 2], base: f64, linear: bool) -> Case {
    let mut random = Random::new(family, severity, seed);
    let view = View::pixels(SIDE, SIDE);
    let texels = (0..size[0] * size[1])
        .map(|_| {
            let b = random.bits().to_le_bytes();
            [b[0], b[1], b[2], 255]
        })
        .collect();
    let image = Image { size, texels };
    let mut recording = Recording::new(SIDE, SIDE, 24);
    recording.view(&view).texture(0, size[0], size[1], &image.texels);
    let filter = if linear { gl::LINEAR } else { gl::NEAREST };
    parameters(&mut recording, filter, filter);
    let vertices: Vec<Vertex> = (0..16)
        .flat_map(|k| {
            let (x, y) = ((k % 4 * 64) as f64, (k / 4 * 64) as f64);
            let from =
                [0, 1].map(|_| base * random.uniform(0.9, 1.0) * if random.below(2) == 0 { 1.0 } else { -1.0 } + random.uniform(0.0, 1.0));
            let by = [0, 1].map(|_| random.uniform(0.2, 0.4));
            let at = |u: f64, v: f64| [from[0] + u * by[0], from[1] + v * by[1]];
            rectangle([x + 2.0, y + 2.0, x + 62.0, y + 62.0], [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)])
        })
        .collect();
    recording.draw(gl::TRIANGLES, has::COORDINATE, &vertices);
    let judge = move |frame: &Frame| {
        judge(frame, &view, &vertices, |triangle, corners, window| {
            let [s, t, ..] = coordinate(triangle, corners, window);
            let exactly = |color: [f64; 3]| color.map(|c| [c, c]);
            if linear { vec![exactly(image.linear(s, t))] } else { image.nearest(s, t).into_iter().map(exactly).collect() }
        })
    };
    Case { recording, judge: Box::new(judge) }
}

/// Levels of the mipmap that tells the level of detail.
const LEVELS: u32 = 11;

fn levels(recording: &mut Recording) {
    for level in 0..LEVELS {
        let size = 1024 >> level;
        recording.texture(level, size, size, &vec![[level as u8 * 25, 255 - level as u8 * 25, 0, 255]; size * size]);
    }
    parameters(recording, gl::LINEAR_MIPMAP_LINEAR, gl::LINEAR);
}

/// The range of colours for a range of scale factors.
fn level_colors(least: f64, greatest: f64) -> [[f64; 2]; 3] {
    let level = |scale: f64| scale.log2().clamp(0.0, f64::from(LEVELS - 1)) * 25.0 / 255.0;
    let (low, high) = (level(least), level(greatest));
    [[low, high], [1.0 - high, 1.0 - low], [0.0, 0.0]]
}

/// Least and greatest scale factor from derivatives in texels a pixel.
fn scale_factors(dx: [f64; 2], dy: [f64; 2]) -> [f64; 2] {
    let axis = |k: usize| dx[k].abs().max(dy[k].abs());
    [axis(0).max(axis(1)), axis(0) + axis(1)]
}

fn minified(severity: f64, seed: u64) -> Case {
    let mut random = Random::new("texture_minified", severity, seed);
    let view = View::pixels(SIDE, SIDE);
    let mut recording = Recording::new(SIDE, SIDE, 24);
    recording.view(&view);
    levels(&mut recording);
    let mut vertices = Vec::new();
    for k in 0..16 {
        let (x, y) = ((k % 4 * 64) as f64, (k / 4 * 64) as f64);
        // A turn and two scales, up to twelve times as large along one axis.
        let (c, s) = {
            let a = random.uniform(0.0, std::f64::consts::TAU);
            (a.cos(), a.sin())
        };
        let (large, small) = (severity * 60.0 / 1024.0, severity * 60.0 / 1024.0 / random.uniform(1.0, 12.0));
        let at = |u: f64, v: f64| [large * (c * u - s * v), small * (s * u + c * v)];
        vertices.extend(rectangle([x + 2.0, y + 2.0, x + 62.0, y + 62.0], [at(0.0, 0.0), at(1.0, 0.0), at(1.0, 1.0), at(0.0, 1.0)]));
    }
    recording.draw(gl::TRIANGLES, has::COORDINATE, &vertices);
    let judge =
        move |frame: &Frame| judge(frame, &view, &vertices, |triangle, corners, window| vec![detail(triangle, corners, window, 0.0)]);
    Case { recording, judge: Box::new(judge) }
}

/// Colours for every scale factor that derivatives within `around` pixels allow.
fn detail(triangle: &Triangle, corners: &[Vertex], [x, y]: [f64; 2], around: f64) -> [[f64; 2]; 3] {
    let (mut least, mut greatest) = (f64::INFINITY, 0.0f64);
    let h = 0.001;
    for (ox, oy) in [(0.0, 0.0), (-around, -around), (around, -around), (-around, around), (around, around)] {
        let at = |dx: f64, dy: f64| coordinate(triangle, corners, [x + ox + dx, y + oy + dy]);
        let difference = |a: [f64; 4], b: [f64; 4]| [0, 1].map(|k| (b[k] - a[k]) / (2.0 * h) * 1024.0);
        let [low, high] = scale_factors(difference(at(-h, 0.0), at(h, 0.0)), difference(at(0.0, -h), at(0.0, h)));
        (least, greatest) = (least.min(low), greatest.max(high));
    }
    level_colors(least, greatest)
}

fn grazing(severity: f64, seed: u64) -> Case {
    let mut random = Random::new("texture_grazing", severity, seed);
    let view = View::perspective(SIDE, SIDE, 1.0, (severity * 2.0) as f32);
    let mut recording = Recording::new(SIDE, SIDE, 24);
    recording.view(&view);
    levels(&mut recording);
    let tilt = random.uniform(-0.2, 0.2);
    let corner =
        |x: f64, z: f64| Vertex::new(x as f32, (-1.0 + tilt * x / severity) as f32, -z as f32).textured((x / 8.0) as f32, (z / 8.0) as f32);
    let (near, far) = (1.25, severity);
    let [a, b, c, d] = [corner(-near * 0.9, near), corner(near * 0.9, near), corner(far * 0.9, far), corner(-far * 0.9, far)];
    let vertices = vec![a, b, c, a, c, d];
    recording.draw(gl::TRIANGLES, has::COORDINATE, &vertices);
    let judge =
        move |frame: &Frame| judge(frame, &view, &vertices, |triangle, corners, window| vec![detail(triangle, corners, window, 1.0)]);
    Case { recording, judge: Box::new(judge) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn filters_are_those_of_the_specification() {
        let image = Image { size: [2, 1], texels: vec![[0, 0, 0, 255], [255, 255, 255, 255]] };
        assert_eq!(image.linear(0.25, 0.5)[0], 0.0);
        assert_eq!(image.linear(0.5, 0.5)[0], 0.5);
        assert_eq!(image.linear(1e6 + 0.375, 0.5)[0], 0.25);
        assert_eq!(image.nearest(0.3, 0.5)[0][0], 0.0);
        assert!(image.nearest(0.5, 0.5).iter().any(|c| c[0] == 0.0) && image.nearest(0.5, 0.5).iter().any(|c| c[0] == 1.0));
    }

    #[test]
    fn scale_factors_are_bounded_by_the_larger_axis_and_the_sum() {
        assert_eq!(scale_factors([4.0, 0.0], [0.0, 2.0]), [4.0, 6.0]);
        assert_eq!(level_colors(4.0, 8.0)[0], [50.0 / 255.0, 75.0 / 255.0]);
    }
}
