//! Samples a pixel: scenes of edges and of thin triangles, without textures, against 256 samples a pixel.

use super::{Course, Reference, Scene, Setting};
use crate::oracle::supersampled;
use crate::recording::{Recording, Vertex, View, gl, has};

const SIDE: usize = 256;

/// Samples that there are.
const SAMPLES: [usize; 5] = [1, 2, 4, 8, 16];

/// A triangle of one colour.
type Flat = ([[f32; 4]; 3], [u8; 3]);

/// The scenes.
pub fn scenes() -> [Scene; 2] {
    [
        scene(
            "samples_star",
            "48 spokes around a point and two edges that are nearly level and nearly upright, in flat colours. Reference: 256 samples a pixel, exactly transformed and clipped. \
             What is drawn goes to a framebuffer object and is resolved by a blit, both in the time; one sample is drawn into the window. OSMesa has 1 and 4 samples.",
            View::pixels(SIDE, SIDE),
            &star(),
            false,
        ),
        scene(
            "samples_blades",
            "2,240 upright thin triangles on a perspective grid, the farthest a third of a pixel wide, drawn from the nearest on with a depth test. Reference and times as above.",
            View::perspective(SIDE, SIDE, 1.0, 100.0),
            &blades(),
            true,
        ),
    ]
}

fn scene(name: &'static str, about: &'static str, view: View, triangles: &[Flat], depth_test: bool) -> Scene {
    let setting = |samples: usize| Setting {
        name: format!("{samples}"),
        recording: recording(&view, triangles, depth_test, samples),
        environment: Vec::new(),
    };
    Scene {
        name,
        about,
        knob: "samples a pixel",
        reference: Reference::Pixels(supersampled::draw(&view, [SIDE; 2], [0; 3], triangles)),
        settings: SAMPLES.map(setting).into(),
        course: Course::Falls,
    }
}

/// The triangles of the reference, where each lies over those before. With a depth test they are drawn the other way round.
fn recording(view: &View, triangles: &[Flat], depth_test: bool, samples: usize) -> Recording {
    let mut recording = Recording::new(SIDE, SIDE, 24);
    if samples > 1 {
        recording.multisample(samples);
    }
    recording.call("clear_color", &[], &[0.0, 0.0, 0.0, 1.0]);
    recording.call("clear", &[i64::from(gl::COLOR_BUFFER_BIT | gl::DEPTH_BUFFER_BIT)], &[]).view(view);
    if depth_test {
        recording.enable(gl::DEPTH_TEST);
    }
    let mut order: Vec<&Flat> = triangles.iter().collect();
    if depth_test {
        order.reverse();
    }
    let vertices: Vec<Vertex> = order
        .into_iter()
        .flat_map(|(positions, color)| {
            let [r, g, b] = color.map(|c| f32::from(c) / 255.0);
            positions.map(|p| Vertex { position: p, ..Vertex::new(0.0, 0.0, 0.0).colored([r, g, b, 1.0]) })
        })
        .collect();
    recording.draw(gl::TRIANGLES, has::COLOR, &vertices);
    if samples > 1 {
        recording.resolve();
    }
    recording
}

fn star() -> Vec<Flat> {
    const SPOKES: u32 = 48;
    let centre = [127.3, 128.6];
    let mut triangles: Vec<Flat> = (0..SPOKES)
        .map(|k| {
            let corner = |turn: f64| {
                let angle = (f64::from(k) + turn) / f64::from(SPOKES) * std::f64::consts::TAU;
                [(centre[0] + 104.0 * angle.cos()) as f32, (centre[1] + 104.0 * angle.sin()) as f32, 0.0, 1.0]
            };
            let color = if k % 3 == 0 { [255, 190, 60] } else { [240; 3] };
            ([[centre[0] as f32, centre[1] as f32, 0.0, 1.0], corner(0.1), corner(0.6)], color)
        })
        .collect();
    let corner = |x: f32, y: f32| [x, y, 0.0, 1.0];
    let (top, side) = (256.0, 256.0);
    for [a, b, c, d] in [
        [corner(0.0, 240.3), corner(side, 246.9), corner(side, top), corner(0.0, top)],
        [corner(239.7, 0.0), corner(side, 0.0), corner(side, 240.0), corner(246.2, 240.0)],
    ] {
        triangles.extend([([a, b, c], [90, 160, 250]), ([a, c, d], [90, 160, 250])]);
    }
    triangles
}

/// From the farthest to the nearest, no two at the same depth, so that each lies over those before.
fn blades() -> Vec<Flat> {
    const ROWS: u32 = 40;
    const BLADES: u32 = 56;
    (0..ROWS)
        .flat_map(|row| {
            let near = -3.0 - 1.5 * (ROWS - 1 - row) as f32;
            (0..BLADES).map(move |k| {
                // Rows are as wide as the window at their distance; each is moved a little against the next, and turned a little.
                let z = near - 0.5 + 0.5 * k as f32 / BLADES as f32;
                let x = (k as f32 + 0.37 * (row % 5) as f32) / BLADES as f32 * 2.0 - 1.0;
                let (x, width, height) = (x * z.abs(), 0.16, 1.6 + 0.4 * ((k * 7 + row * 3) % 5) as f32);
                let lean = 0.1 * ((k * 5 + row * 11) % 7) as f32 - 0.3;
                let color = [[70, 200, 90], [230, 220, 120], [60, 140, 70]][(k + row) as usize % 3];
                ([[x, -3.0, z, 1.0], [x + width, -3.0, z, 1.0], [x + lean, height - 3.0, z, 1.0]], color)
            })
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_references_are_pictures_of_what_is_drawn() {
        for scene in scenes() {
            let Reference::Pixels(pixels) = &scene.reference else { panic!("{} is worked out", scene.name) };
            let dark = pixels.chunks_exact(4).filter(|p| p[..3] == [0; 3]).count();
            let mixed = pixels.chunks_exact(4).filter(|p| (1..60).contains(&p[0])).count();
            assert!(dark > SIDE * SIDE / 10 && mixed > SIDE * SIDE / 100, "{}: {dark} dark, {mixed} mixed", scene.name);
        }
    }
}
