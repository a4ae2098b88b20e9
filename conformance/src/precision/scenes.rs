//! The scenes and their settings. Every setting that Tepui has today and that trades accuracy for time is in one of them.

use super::{Course, Reference, Scene, Setting, samples};
use crate::oracle::values::Triangle;
use crate::recording::{Recording, Vertex, View, gl, has};

const SIDE: usize = 256;

/// All scenes.
pub fn all() -> Vec<Scene> {
    let [star, blades] = samples::scenes();
    vec![star, blades, filters(), bias(), density(), batches()]
}

/// Texels across of the texture.
const TEXTURE: usize = 256;

/// A checker whose cells are eight texels, with gradients: what aliases.
fn texels(size: usize) -> Vec<[u8; 4]> {
    let texel = |k: usize| {
        let (x, y) = (k % size, k / size);
        let on = (x / 8 + y / 8) % 2 == 1;
        [if on { 230 } else { 40 }, (255 * x / size) as u8, (255 * y / size) as u8, 255]
    };
    (0..size * size).map(texel).collect()
}

/// The next level of a mipmap: the mean of each two by two texels, in whole numbers, rounded.
fn half(texels: &[[u8; 4]], size: usize) -> Vec<[u8; 4]> {
    let at = |x: usize, y: usize, c: usize| u32::from(texels[y * size + x][c]);
    let mean =
        |x: usize, y: usize| [0, 1, 2, 3].map(|c| ((at(x, y, c) + at(x + 1, y, c) + at(x, y + 1, c) + at(x + 1, y + 1, c) + 2) / 4) as u8);
    (0..size / 2).flat_map(|y| (0..size / 2).map(move |x| (x, y))).map(|(x, y)| mean(2 * x, 2 * y)).collect()
}

fn floor_view() -> View {
    View::perspective(SIDE, SIDE, 1.0, 100.0)
}

/// A floor and, above the horizon, a ceiling, out to a distance of 60.
fn floor() -> Vec<Vertex> {
    let corner = |x: f32, y: f32, z: f32| Vertex::new(x, y, -z).textured(x / 4.0, z / 4.0);
    let side = |y: f32| {
        let [a, b, c, d] = [corner(-60.0, y, 1.0), corner(60.0, y, 1.0), corner(60.0, y, 60.0), corner(-60.0, y, 60.0)];
        [a, b, c, a, c, d]
    };
    [side(-0.9), side(0.9)].concat()
}

/// The floor with 256 samples a pixel, each the exact bilinear filter of the finest level.
fn floor_reference() -> Vec<u8> {
    let (view, vertices, image) = (floor_view(), floor(), texels(TEXTURE));
    let triangles: Vec<(Triangle, [[f32; 4]; 3])> = vertices
        .chunks_exact(3)
        .map(|t| (Triangle::new(&view, [t[0].position, t[1].position, t[2].position]), [t[0].coordinate, t[1].coordinate, t[2].coordinate]))
        .collect();
    let texel = |i: f64, j: f64| image[j.rem_euclid(TEXTURE as f64) as usize * TEXTURE + i.rem_euclid(TEXTURE as f64) as usize];
    let sample = |window: [f64; 2]| -> [f64; 3] {
        for (triangle, coordinates) in &triangles {
            let weights = triangle.at(window);
            // Where all are positive and the depth is within the range, the triangle is in front of the eye and covers the sample.
            if weights.of.iter().all(|w| *w >= 0.0) && (0.0..=1.0).contains(&weights.depth) {
                let [s, t, ..] = weights.mix(*coordinates);
                let (u, v) = (s * TEXTURE as f64 - 0.5, t * TEXTURE as f64 - 0.5);
                let (i, j) = (u.floor(), v.floor());
                let (a, b) = (u - i, v - j);
                let corners = [texel(i, j), texel(i + 1.0, j), texel(i, j + 1.0), texel(i + 1.0, j + 1.0)];
                return [0, 1, 2].map(|c| {
                    let [p, q, r, s] = corners.map(|t| f64::from(t[c]));
                    (1.0 - b) * ((1.0 - a) * p + a * q) + b * ((1.0 - a) * r + a * s)
                });
            }
        }
        [0.0; 3]
    };
    let mut pixels = Vec::with_capacity(SIDE * SIDE * 4);
    for pixel in 0..SIDE * SIDE {
        let mut sum = [0.0; 3];
        for k in 0..256 {
            let at = [(pixel % SIDE) as f64 + (f64::from(k % 16) + 0.5) / 16.0, (pixel / SIDE) as f64 + (f64::from(k / 16) + 0.5) / 16.0];
            for (sum, color) in sum.iter_mut().zip(sample(at)) {
                *sum += color;
            }
        }
        pixels.extend(sum.map(|s| (s / 256.0).round() as u8));
        pixels.push(255);
    }
    pixels
}

fn floor_recording(min: u32, bias: f32) -> Recording {
    let mut recording = Recording::new(SIDE, SIDE, 24);
    recording.call("clear_color", &[], &[0.0, 0.0, 0.0, 1.0]).call("clear", &[gl::COLOR_BUFFER_BIT.into()], &[]).view(&floor_view());
    let (mut level, mut size, mut image) = (0, TEXTURE, texels(TEXTURE));
    loop {
        recording.texture(level, size, size, &image);
        if size == 1 {
            break;
        }
        image = half(&image, size);
        (level, size) = (level + 1, size / 2);
    }
    let mag = if min == gl::NEAREST { gl::NEAREST } else { gl::LINEAR };
    for (pname, value) in
        [(gl::TEXTURE_MIN_FILTER, min), (gl::TEXTURE_MAG_FILTER, mag), (gl::TEXTURE_WRAP_S, gl::REPEAT), (gl::TEXTURE_WRAP_T, gl::REPEAT)]
    {
        recording.call("tex_parameter", &[pname.into(), value.into()], &[]);
    }
    recording.call("tex_env_f", &[gl::TEXTURE_FILTER_CONTROL.into(), gl::TEXTURE_LOD_BIAS.into()], &[bias]);
    recording.enable(gl::TEXTURE_2D).call("tex_env", &[gl::REPLACE.into()], &[]).draw(gl::TRIANGLES, has::COORDINATE, &floor());
    recording
}

fn filters() -> Scene {
    let modes = [
        ("NEAREST", gl::NEAREST),
        ("LINEAR", gl::LINEAR),
        ("NEAREST_MIPMAP_NEAREST", gl::NEAREST_MIPMAP_NEAREST),
        ("LINEAR_MIPMAP_NEAREST", gl::LINEAR_MIPMAP_NEAREST),
        ("NEAREST_MIPMAP_LINEAR", gl::NEAREST_MIPMAP_LINEAR),
        ("LINEAR_MIPMAP_LINEAR", gl::LINEAR_MIPMAP_LINEAR),
    ];
    let setting = |(name, min): (&str, u32)| Setting { name: name.into(), recording: floor_recording(min, 0.0), environment: Vec::new() };
    Scene {
        name: "texture_filter",
        about: "A floor and a ceiling out to the horizon. Reference: 256 samples a pixel of the exact bilinear filter, in f64. A filter that reads few texels aliases; one with mipmaps blurs at grazing angles.",
        knob: "minification filter",
        reference: Reference::Pixels(floor_reference()),
        settings: modes.into_iter().map(setting).collect(),
        course: Course::Free,
    }
}

fn bias() -> Scene {
    let setting = |bias: f32| Setting {
        name: format!("{bias:+}"),
        recording: floor_recording(gl::LINEAR_MIPMAP_LINEAR, bias),
        environment: Vec::new(),
    };
    Scene {
        name: "mipmap_bias",
        about: "The same floor with LINEAR_MIPMAP_LINEAR and GL_TEXTURE_LOD_BIAS: below zero aliases, above zero blurs.",
        knob: "level-of-detail bias",
        reference: Reference::Pixels(floor_reference()),
        settings: [-4.0, -2.0, -1.0, -0.5, 0.0, 0.5, 1.0, 2.0].map(setting).into(),
        course: Course::Free,
    }
}

fn surface_recording(density: i64) -> Recording {
    let mut view = View::perspective(SIDE, SIDE, 1.0, 10.0);
    // Three away from the eye, tilted towards it.
    view.modelview = [1.0, 0.0, 0.0, 0.0, 0.0, 0.5, -0.8660254, 0.0, 0.0, 0.8660254, 0.5, 0.0, 0.0, 0.0, -3.0, 1.0];
    let mut recording = Recording::new(SIDE, SIDE, 24);
    recording.call("clear_color", &[], &[0.0, 0.0, 0.0, 1.0]).call("clear", &[gl::COLOR_BUFFER_BIT.into()], &[]);
    // A bump and a dip of a bicubic patch.
    let heights = [0.0, 0.0, 0.0, 0.0, 0.0, 4.0, -3.0, 0.0, 0.0, -3.0, 4.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let points = (0..16usize).flat_map(|k| [(k % 4) as f32 * 1.2 - 1.8, (k / 4) as f32 * 1.2 - 1.8, heights[k]]);
    recording.view(&view).data("surface", &[4], points.flat_map(f32::to_le_bytes));
    recording.enable(gl::DEPTH_TEST).enable(gl::LIGHTING).enable(gl::LIGHT0).enable(gl::AUTO_NORMAL).enable(gl::NORMALIZE);
    recording.call("material", &[gl::FRONT_AND_BACK.into(), gl::SPECULAR.into()], &[0.6; 4]);
    recording.call("material", &[gl::FRONT_AND_BACK.into(), gl::SHININESS.into()], &[30.0, 0.0, 0.0, 0.0]);
    recording.call("grid", &[density], &[]);
    recording
}

fn density() -> Scene {
    let setting = |n: i64| Setting { name: format!("{n} x {n}"), recording: surface_recording(n), environment: Vec::new() };
    Scene {
        name: "tessellation",
        about: "A lit bicubic patch of glMap2f and glEvalMesh2. Reference: OSMesa with 1024 x 1024 quads; Tepui's own error there is the distance between the two.",
        knob: "quads of the evaluator mesh",
        reference: Reference::Drawn(surface_recording(1024)),
        settings: [2, 4, 8, 16, 32, 64, 128, 256].map(setting).into(),
        course: Course::Free,
    }
}

fn batches() -> Scene {
    let setting = |bytes: usize| Setting {
        name: format!("{bytes}"),
        recording: surface_recording(96),
        environment: vec![("TEPUI_BATCH_BUDGET", bytes.to_string())],
    };
    Scene {
        name: "batch_budget",
        about: "The patch with 96 x 96 quads, TEPUI_BATCH_BUDGET from 4 KiB to 64 MiB: the error must not change, the time does. OSMesa does not read it: its points show the spread of the machine. Reference: as for tessellation.",
        knob: "bytes of a batch",
        reference: Reference::Drawn(surface_recording(1024)),
        settings: [4096, 65536, 1 << 20, 64 << 20].map(setting).into(),
        course: Course::Stays,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_level_is_the_mean_of_the_one_below() {
        let level = half(&[[0, 0, 0, 0], [4, 0, 0, 0], [8, 0, 0, 0], [9, 255, 0, 0]], 2);
        assert_eq!(level, [[5, 64, 0, 0]]);
    }

    #[test]
    fn the_reference_is_a_picture_of_floor_and_ceiling() {
        let pixels = floor_reference();
        let red = |x: usize, y: usize| pixels[(y * SIDE + x) * 4];
        // Cells near the eye (row 14; the near plane is at 13) are resolved, those at the horizon are grey (the mean of 40 and 230), and beyond the floor is nothing.
        assert!((0..SIDE).any(|x| red(x, 14) > 220) && (0..SIDE).any(|x| red(x, 14) < 50));
        assert_eq!(red(128, 128), 0);
        let near_horizon: f64 = (0..SIDE).map(|x| f64::from(red(x, 122))).sum::<f64>() / SIDE as f64;
        assert!((near_horizon - 135.0).abs() < 15.0, "{near_horizon}");
    }
}
