//! Families about depth: ranges that leave the buffer few units, and layers in one plane.

use std::collections::HashMap;

use super::common::{Random, cover, triangles};
use super::{Case, Family, Score};
use crate::frame::Frame;
use crate::recording::{Recording, Vertex, View, gl, has};

const SIDE: usize = 256;

/// The families.
pub fn families() -> Vec<Family> {
    vec![
        Family {
            name: "depth_range_24",
            about: "30 triangles whose corners lie between the near and the far plane, evenly in the logarithm; 24 bits of depth. Depth and perspective-correct colour.",
            knob: "far : near",
            severities: &[1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7],
            inside: |_| true,
            make: |severity, seed| vec![range(severity, seed, 24)],
        },
        Family {
            name: "depth_range_16",
            about: "The same with 16 bits of depth.",
            knob: "far : near",
            severities: &[1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7],
            inside: |_| true,
            make: |severity, seed| vec![range(severity, seed, 16)],
        },
        Family {
            name: "depth_range_32f",
            about: "The same with 32 bits of floating-point depth, in a framebuffer object; coverage is the window's. Units are the last place of the exact depth, so that small depths, near the eye, count most.",
            knob: "far : near",
            severities: &[1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7],
            inside: |_| true,
            make: |severity, seed| vec![range(severity, seed, 32)],
        },
        Family {
            name: "coplanar_same",
            about: "Twelve layers of the same four triangles, depth function LEQUAL: the last layer is seen everywhere, however steep the plane.",
            knob: "slope, depth units a pixel",
            severities: &[0.0, 1.0, 256.0, 16384.0, 60000.0],
            inside: |_| true,
            make: |severity, seed| vec![layers(severity, seed, 24, false)],
        },
        Family {
            name: "coplanar_offset",
            about: "Twelve layers of one plane, each cut into triangles at another point, glPolygonOffset(-k, -4k), depth function LESS: the layer that its offset moves farthest, the last one, is seen everywhere.",
            knob: "slope, depth units a pixel",
            severities: &[0.0, 1.0, 256.0, 4096.0],
            inside: |_| true,
            make: |severity, seed| vec![layers(severity, seed, 24, true)],
        },
        Family {
            name: "coplanar_offset_32f",
            about: "The same with 32 bits of floating-point depth, where a unit of glPolygonOffset is the last place of the polygon's greatest depth: 2^-24 here, or half of that, so that it need not be the last layer that is moved farthest.",
            knob: "slope, 2^-24 a pixel",
            severities: &[0.0, 1.0, 256.0, 4096.0],
            inside: |_| true,
            make: |severity, seed| vec![layers(severity, seed, 32, true)],
        },
    ]
}

fn range(severity: f64, seed: u64, depth_bits: u32) -> Case {
    let mut random = Random::new("depth_range", severity, seed);
    let (near, far) = (1.0f64, severity);
    let view = View::perspective(SIDE, SIDE, near as f32, far as f32);
    let vertices = (0..90)
        .map(|_| {
            // Kept off the planes by a tenth of a percent, so that rounding clips nothing.
            let z = near * (far / near).powf(random.uniform(0.001, 0.999)) as f32 as f64;
            let (x, y) = (random.uniform(-0.95, 0.95) * z, random.uniform(-0.95, 0.95) * z);
            Vertex::new(x as f32, y as f32, -z as f32).colored(random.color())
        })
        .collect();
    triangles(view, SIDE, SIDE, depth_bits, vertices)
}

const LAYERS: usize = 12;

/// What a layer's triangles are moved by (3.5.5): the slope times the layer, and four units times it. A unit is one for all triangles where
/// depth is an integer, and the last place of a triangle's greatest depth where it is a floating-point number.
struct LayerOffsets {
    /// For each triangle the least and the greatest offset, where it is not certain which power of two its greatest depth reaches; and its
    /// unit, the greater one.
    triangles: Vec<([f64; 2], f64)>,
    /// The triangle that owns a pixel.
    owners: HashMap<usize, u32>,
}

impl LayerOffsets {
    fn new(layer: f64, list: &[Vertex], owned: impl Iterator<Item = (usize, u32)>, steepness: f64, depth_bits: u32) -> LayerOffsets {
        let triangles = list.chunks_exact(3).map(|t| {
            let greatest = t.iter().map(|v| (1.0 - v.position[2] as f64) / 2.0).fold(0.0, f64::max);
            // Rounded once or twice on its way to the window.
            let units = [-1.0, 1.0].map(|side| match depth_bits {
                32 => 2f64.powf((greatest * (1.0 + side * 2f64.powi(-22))).log2().floor() - 23.0),
                _ => 2f64.powi(-24),
            });
            let offset = |unit: f64| -layer * (steepness + 4.0 * unit);
            ([offset(units[1]), offset(units[0])], units[1])
        });
        LayerOffsets { triangles: triangles.collect(), owners: owned.collect() }
    }

    /// The least and the greatest offset at a pixel, and the greatest unit.
    fn at(&self, pixel: usize) -> ([f64; 2], f64) {
        match self.owners.get(&pixel) {
            Some(&owner) => self.triangles[owner as usize],
            // On an edge between triangles: any of them.
            None => self.triangles.iter().fold(([f64::INFINITY, f64::NEG_INFINITY], 0.0), |([low, high], unit), &([l, h], u)| {
                ([low.min(l), high.max(h)], f64::max(unit, u))
            }),
        }
    }

    /// Whether it may lie before another layer: offsets that differ by less than two units, half of what lies between neighbouring layers,
    /// may be rounded to either order.
    fn may_hide(&self, other: &LayerOffsets, pixel: usize) -> bool {
        let (([low, _], ours), ([_, high], theirs)) = (self.at(pixel), other.at(pixel));
        low < high + 2.0 * ours.max(theirs)
    }
}

fn layers(slope: f64, seed: u64, depth_bits: u32, offset: bool) -> Case {
    let mut random = Random::new("coplanar", slope, seed);
    let view = View::pixels(SIDE, SIDE);
    // Object z for a depth in units of 2^-24: the view maps -1..1 to 1..0. The plane runs along x; offsets move it towards the eye.
    let angle: f64 = random.uniform(0.0, 1.57);
    let z = |x: f64, y: f64| (1.0 - 2.0 * (0.5 + slope * ((x - 128.0) * angle.cos() + (y - 128.0) * angle.sin()) / 16777216.0)) as f32;
    let mut recording = Recording::new(SIDE, SIDE, depth_bits);
    recording.view(&view).count_hits().enable(gl::DEPTH_TEST);
    recording.call("depth_func", &[if offset { gl::LESS } else { gl::LEQUAL }.into()], &[]);
    if offset {
        recording.enable(gl::POLYGON_OFFSET_FILL);
    }
    let corners = [[16.0, 16.0], [240.0, 16.0], [240.0, 240.0], [16.0, 240.0]];
    let mut middle = [128.0, 128.0];
    let mut drawn = Vec::new();
    for layer in 0..LAYERS {
        if offset || layer == 0 {
            middle = [0, 1].map(|_| random.uniform(60.0, 200.0));
        }
        // The exact depths of a plane are not single-precision numbers: corners are rounded to them, as a program's are.
        let vertex = |[x, y]: [f64; 2]| Vertex::new(x as f32, y as f32, z(x, y));
        let list = (0..4).flat_map(|k| [corners[k], corners[(k + 1) % 4], middle].map(vertex)).collect::<Vec<_>>();
        recording.call("polygon_offset", &[], &[-(layer as f32), -4.0 * layer as f32]);
        recording.call("color", &[], &[layer as f32 / 255.0, 0.0, 1.0, 1.0]).draw(gl::TRIANGLES, has::POSITION, &list);
        drawn.push(list);
    }
    // The plane's slope as 3.5.5 has it: the greater of both.
    let steepness = slope * angle.cos().max(angle.sin()) / 16777216.0;
    let judge = move |frame: &Frame| {
        let cover = |list: &Vec<Vertex>| cover(&view, SIDE, SIDE, list, |_, _| true);
        let mut score = Score::default();
        score.counts.samples = frame.stencil.len() as u64;
        let offsets = offset.then(|| {
            let layers = drawn.iter().enumerate();
            layers.map(|(k, list)| LayerOffsets::new(k as f64, list, cover(list).owned(), steepness, depth_bits)).collect::<Vec<_>>()
        });
        for (pixel, _) in cover(&drawn[LAYERS - 1]).owned() {
            score.counts.must += 1;
            let seen = frame.color[pixel * 4] as usize;
            let right = match &offsets {
                None => seen == LAYERS - 1,
                Some(layers) => layers.get(seen).is_some_and(|s| layers.iter().all(|other| s.may_hide(other, pixel))),
            };
            score.counts.wrong += u64::from(!right);
        }
        score.counts.beyond = score.counts.wrong;
        score
    };
    Case { recording, judge: Box::new(judge) }
}
