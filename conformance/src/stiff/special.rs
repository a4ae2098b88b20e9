//! NaN, infinity, denormals and negative zero in every attribute: the triangles beside the poisoned ones are as they would be without.

use super::common::{Random, cover, judge_triangles};
use super::{Case, Family};
use crate::frame::Frame;
use crate::recording::{Recording, Vertex, View, gl, has};

const SIDE: usize = 256;
/// Pixels across of a triangle's cell.
const CELL: usize = 32;

/// The family.
pub fn families() -> Vec<Family> {
    vec![Family {
        name: "special_values",
        about: "Every other cell of a chessboard holds a triangle with a poisoned position, colour, normal or texture coordinate, one attribute an image; lighting, fog and textures are on where they read it. Judged are depth and colour of the other cells, and coverage: of everything where the poison is finite, else of the other cells.",
        knob: "0 none, 1 -0, 2 denormal, 3 largest, 4 infinite, 5 NaN",
        severities: &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0],
        inside: |severity| severity != LARGEST,
        make: |severity, seed| (0..8).map(|attribute| poisoned(severity, seed, attribute)).collect(),
    }]
}

/// The last severity whose values are finite.
const LARGEST: f64 = 3.0;

fn poison(severity: f64, random: &mut Random) -> Option<f32> {
    let value = [None, Some(-0.0), Some(1e-42), Some(f32::MAX), Some(f32::INFINITY), Some(f32::NAN)][severity as usize];
    value.map(|v| if random.below(2) == 0 { v } else { -v })
}

/// `attribute`: position x, y, z, w; colour; normal; texture coordinates; all of them. The odd ones are sent by Begin/End.
fn poisoned(severity: f64, seed: u64, attribute: u64) -> Case {
    let mut random = Random::new("special_values", attribute as f64, seed);
    let view = View::pixels(SIDE, SIDE);
    let (mut all, mut good) = (Vec::new(), Vec::new());
    for k in 0..(SIDE / CELL).pow(2) {
        let (column, row) = (k % (SIDE / CELL), k / (SIDE / CELL));
        let mut triangle = [[2.0, 2.0], [29.0, 6.0], [11.0, 29.0]].map(|[x, y]| {
            let mut place = |corner: usize, v: f64| ((corner * CELL) as f64 + v + random.uniform(-1.5, 1.5)) as f32;
            let (x, y) = (place(column, x), place(row, y));
            Vertex::new(x, y, random.uniform(-1.0, 1.0) as f32).colored(random.color())
        });
        if (column + row) % 2 == 0 {
            good.extend(triangle);
        } else if let Some(value) = poison(severity, &mut random) {
            let corner = &mut triangle[random.below(3) as usize];
            let component = random.below(3) as usize;
            if attribute < 4 || attribute == 7 {
                corner.position[if attribute == 7 { component } else { attribute as usize }] = value;
            }
            if attribute == 4 || attribute == 7 {
                corner.color[component] = value;
            }
            if attribute == 5 || attribute == 7 {
                corner.normal[component] = value;
            }
            if attribute == 6 || attribute == 7 {
                corner.coordinate[component] = value;
            }
        }
        all.extend(triangle);
    }
    let mut recording = Recording::new(SIDE, SIDE, 24);
    recording.view(&view).count_hits().enable(gl::DEPTH_TEST).call("depth_func", &[gl::ALWAYS.into()], &[]);
    if attribute >= 5 {
        // Lighting and texturing read the poison and leave the other cells' colours as they are: the light is ambient, the texture white.
        recording.texture(0, 2, 2, &[[255; 4]; 4]).enable(gl::TEXTURE_2D);
        for pname in [gl::TEXTURE_MIN_FILTER, gl::TEXTURE_MAG_FILTER] {
            recording.call("tex_parameter", &[pname.into(), gl::NEAREST.into()], &[]);
        }
    }
    let lit = attribute == 5 || attribute == 7;
    if lit {
        recording.enable(gl::COLOR_MATERIAL).enable(gl::LIGHTING).enable(gl::LIGHT0).enable(gl::NORMALIZE);
        recording.call("light_model", &[gl::LIGHT_MODEL_AMBIENT.into()], &[1.0; 4]);
        recording.call("light", &[gl::LIGHT0.into(), gl::DIFFUSE.into()], &[0.0; 4]);
        recording.call("light", &[gl::LIGHT0.into(), gl::SPECULAR.into()], &[0.0; 4]);
    }
    recording.draw_as(gl::TRIANGLES, has::COLOR | has::NORMAL | has::COORDINATE, &all, attribute % 2 == 1);
    // A poisoned triangle that is finite is judged like any other, and may reach anywhere; one that is not must not be seen beside its cell.
    let finite = severity <= LARGEST;
    let ours = |column: usize, row: usize| (column / CELL + row / CELL).is_multiple_of(2);
    let judge = move |frame: &Frame| {
        if finite {
            let coverage = cover(&view, SIDE, SIDE, &all, |_, _| true);
            let healthy = |triangle: u32| ours(triangle as usize % (SIDE / CELL) * CELL, triangle as usize / (SIDE / CELL) * CELL);
            return judge_triangles(frame, &coverage, &view, &all, 24, healthy);
        }
        let coverage = cover(&view, SIDE, SIDE, &good, ours);
        let mut seen = frame.clone();
        for (pixel, hits) in seen.stencil.iter_mut().enumerate() {
            if !ours(pixel % SIDE, pixel / SIDE) {
                *hits = 0;
            }
        }
        judge_triangles(&seen, &coverage, &view, &good, 24, |_| true)
    };
    Case { recording, judge: Box::new(judge) }
}
