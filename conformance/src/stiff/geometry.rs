//! Families about where triangles lie: thin, tiny, huge, far away, behind the eye, on ties, in small and large viewports.

use super::common::{Random, triangles};
use super::{Case, Family};
use crate::recording::{Vertex, View};

const SIDE: usize = 256;

/// The families.
pub fn families() -> Vec<Family> {
    vec![
        Family {
            name: "slivers",
            about: "60 triangles 200 pixels long in random directions, their width down to 200 / 10^6 pixels. Coverage, depth and colour.",
            knob: "length : width",
            severities: &[3.0, 1e2, 1e3, 1e4, 1e5, 1e6],
            inside: |_| true,
            make: |severity, seed| {
                let mut random = Random::new("slivers", severity, seed);
                let vertices = (0..60).flat_map(|_| sliver(&mut random, 200.0, 200.0 / severity)).collect();
                vec![triangles(View::pixels(SIDE, SIDE), SIDE, SIDE, 24, vertices)]
            },
        },
        Family {
            name: "subpixel",
            about: "4,000 triangles down to a sixteenth of a subpixel, half of them around pixel centres. Few samples must be covered; what is covered must be allowed.",
            knob: "triangles a pixel's side",
            severities: &[1.0, 4.0, 16.0, 64.0, 256.0, 1024.0, 4096.0],
            inside: |_| true,
            make: |severity, seed| {
                let mut random = Random::new("subpixel", severity, seed);
                let vertices = (0..4000).flat_map(|i| tiny(&mut random, 1.0 / severity, i % 2 == 0)).collect();
                vec![triangles(View::pixels(SIDE, SIDE), SIDE, SIDE, 24, vertices)]
            },
        },
        Family {
            name: "ties",
            about: "A hundred triangles whose corners lie on a grid of the subpixels, at last on pixel centres and pixel borders only: samples lie on edges and corners. Judged by the snapped rule.",
            knob: "grid, in subpixels",
            severities: &[1.0, 8.0, 32.0, 64.0, 128.0],
            inside: |_| true,
            make: |severity, seed| {
                let mut random = Random::new("ties", severity, seed);
                let mut corner = || (random.below((SIDE as f64 * 256.0 / severity) as u64) as f64 * severity / 256.0) as f32;
                let mut vertices: Vec<Vertex> = (0..300).map(|_| Vertex::new(corner(), corner(), 0.0)).collect();
                color(&mut vertices, &mut Random::new("ties", severity, seed + 1));
                vec![triangles(View::pixels(SIDE, SIDE), SIDE, SIDE, 24, vertices)]
            },
        },
        Family {
            name: "guard_band",
            about: "One triangle an image, its corners up to 8,192 pixels around the window: at 1 inside it, then over the whole guard band.",
            knob: "reach, in windows",
            severities: &[0.5, 2.0, 8.0, 16.0, 32.0],
            inside: |_| true,
            make: |severity, seed| far(severity * SIDE as f64, "guard_band", severity, seed),
        },
        Family {
            name: "far_vertices",
            about: "One triangle an image, its corners far outside every range: single precision has no bits left for the window.",
            knob: "distance, in pixels",
            severities: &[1e4, 1e5, 1e6, 1e8, 1e10, 1e20, 1e30],
            inside: |_| false,
            make: |severity, seed| far(severity, "far_vertices", severity, seed),
        },
        Family {
            name: "w_through_zero",
            about: "The eye stands inside the geometry: a corner in front, one behind, one near the plane of the eye; the near plane follows it.",
            knob: "1 / distance from the eye's plane",
            severities: &[1.0, 10.0, 1e3, 1e5, 1e7],
            inside: |_| false,
            make: |severity, seed| {
                let mut random = Random::new("w_through_zero", severity, seed);
                (0..12).map(|_| through_the_eye(&mut random, severity)).collect()
            },
        },
        Family {
            name: "homogeneous_scale",
            about: "Positions multiplied by a power of two, w with them: nothing changes on the screen.",
            knob: "scale",
            severities: &[1.0, 1048576.0, 1.0995e12, 1.2089e24, 9.5e-7, 9.1e-13, 8.3e-25, 7.5e-37],
            inside: |_| true,
            make: |severity, seed| {
                let mut random = Random::new("homogeneous_scale", 1.0, seed);
                let scale = 2f32.powi(severity.log2().round() as i32);
                let mut vertices: Vec<Vertex> = (0..20).flat_map(|_| sliver(&mut random, 150.0, 40.0)).collect();
                for v in &mut vertices {
                    v.position = v.position.map(|c| c * scale);
                }
                vec![triangles(View::pixels(SIDE, SIDE), SIDE, SIDE, 24, vertices)]
            },
        },
        Family {
            name: "viewports",
            about: "Viewports of 1 x 1 to 16384 x 16384, seen through a window at their lower left, their middle and their upper right; and windows as long as the viewport.",
            knob: "viewport, in pixels",
            severities: &[1.0, 2.0, 16.0, 256.0, 4096.0, 16384.0],
            inside: |_| true,
            make: viewports,
        },
    ]
}

/// Random colours, whatever the positions.
fn color(vertices: &mut [Vertex], random: &mut Random) {
    for v in vertices {
        v.color = random.color();
    }
}

/// A triangle of a length and width inside the window, in a random direction.
pub fn sliver(random: &mut Random, length: f64, width: f64) -> [Vertex; 3] {
    let (c, s) = {
        let a = random.uniform(0.0, std::f64::consts::TAU);
        (a.cos(), a.sin())
    };
    let (x, y) = (random.uniform(105.0, 151.0), random.uniform(105.0, 151.0));
    [(-0.5, 0.0), (0.5, random.uniform(-0.5, 0.5)), (random.uniform(-0.4, 0.4), 1.0)].map(|(along, across)| {
        let (l, w) = (along * length, across * width);
        Vertex::new((x + l * c - w * s) as f32, (y + l * s + w * c) as f32, random.uniform(-1.0, 1.0) as f32).colored(random.color())
    })
}

fn tiny(random: &mut Random, size: f64, at_centre: bool) -> [Vertex; 3] {
    let place = |random: &mut Random| {
        let v = random.uniform(2.0, 254.0);
        if at_centre { v.floor() + 0.5 } else { v }
    };
    let (x, y) = (place(random), place(random));
    [0; 3].map(|_| {
        let mut near = |v: f64| (v + random.uniform(-size, size)) as f32;
        let (x, y) = (near(x), near(y));
        Vertex::new(x, y, random.uniform(-1.0, 1.0) as f32).colored(random.color())
    })
}

/// Twelve images, one triangle each, its corners about `reach` pixels from the window's middle, every third with one corner in the window.
fn far(reach: f64, family: &str, severity: f64, seed: u64) -> Vec<Case> {
    let mut random = Random::new(family, severity, seed);
    let middle = SIDE as f64 / 2.0;
    (0..12)
        .map(|i| {
            let turn = random.uniform(0.0, std::f64::consts::TAU);
            let vertices = (0..3).map(|k| {
                let angle = turn + f64::from(k) * 2.1 + random.uniform(-0.9, 0.9);
                let distance = if i % 3 == 0 && k == 0 { random.uniform(0.0, 100.0) } else { reach * random.uniform(0.6, 1.0) };
                let [x, y] = [angle.cos(), angle.sin()].map(|d| (middle + d * distance) as f32);
                Vertex::new(x, y, random.uniform(-1.0, 1.0) as f32).colored(random.color())
            });
            triangles(View::pixels(SIDE, SIDE), SIDE, SIDE, 24, vertices.collect())
        })
        .collect()
}

fn through_the_eye(random: &mut Random, severity: f64) -> Case {
    let distance = 1.0 / severity;
    let view = View::perspective(SIDE, SIDE, (0.1 * distance) as f32, 100.0);
    let z = [-random.uniform(1.0, 20.0), random.uniform(-1.0, 1.0) * distance, random.uniform(0.5, 20.0)];
    let vertices = z.map(|z| {
        let (x, y) = (random.uniform(-3.0, 3.0), random.uniform(-3.0, 3.0));
        Vertex::new(x as f32, y as f32, z as f32).colored(random.color())
    });
    triangles(view, SIDE, SIDE, 24, vertices.to_vec())
}

fn viewports(severity: f64, seed: u64) -> Vec<Case> {
    let mut random = Random::new("viewports", severity, seed);
    let size = severity as usize;
    let seen = size.min(SIDE);
    let mut cases = Vec::new();
    let rest = (size - seen) as i32;
    let mut case = |offset: [i32; 2], width: usize, height: usize| {
        // The triangles cross what is seen; their corners lie anywhere in the viewport.
        let vertices: Vec<Vertex> = (0..8)
            .flat_map(|_| {
                let through =
                    [f64::from(-offset[0]) + random.uniform(0.0, width as f64), f64::from(-offset[1]) + random.uniform(0.0, height as f64)];
                let far = [random.uniform(0.0, severity), random.uniform(0.0, severity)];
                let other = [random.uniform(0.0, severity), random.uniform(0.0, severity)];
                [through, far, other]
                    .map(|[x, y]| Vertex::new(x as f32, y as f32, random.uniform(-1.0, 1.0) as f32).colored(random.color()))
            })
            .collect();
        let view = View { viewport: [offset[0], offset[1], size as i32, size as i32], ..View::pixels(size, size) };
        cases.push(triangles(view, width, height, 24, vertices));
    };
    for offset in [0, -rest / 2, -rest] {
        case([offset, offset], seen, seen);
    }
    if size > SIDE {
        case([0, -rest / 2], size, 32);
        case([-rest / 2, 0], 32, size);
    }
    cases
}
