//! Slivers under polygon stipple, user clip planes and scissor boxes.

use super::common::{Random, cover, judge_triangles, record_triangles};
use super::geometry::sliver;
use super::{Case, Family};
use crate::frame::Frame;
use crate::oracle::Coverage;
use crate::recording::{Recording, Vertex, View, gl, has};

const SIDE: usize = 256;

/// The families.
pub fn families() -> Vec<Family> {
    vec![
        Family {
            name: "stippled_slivers",
            about: "Slivers under a random polygon stipple and a scissor box: a sample is hit where sliver, stipple and box agree.",
            knob: "length : width",
            severities: &[3.0, 1e2, 1e3, 1e4, 1e6],
            inside: |_| true,
            make: |severity, seed| vec![stippled(severity, seed)],
        },
        Family {
            name: "clipped_slivers",
            about: "Slivers cut by two user clip planes.",
            knob: "length : width",
            severities: &[3.0, 1e2, 1e3, 1e4, 1e6],
            inside: |_| true,
            make: |severity, seed| {
                let mut random = Random::new("clipped_slivers", severity, seed);
                let mut view = View::pixels(SIDE, SIDE);
                for _ in 0..2 {
                    let angle: f64 = random.uniform(0.0, std::f64::consts::TAU);
                    let (a, b) = (angle.cos() as f32, angle.sin() as f32);
                    // Through a place near the middle.
                    let c = -(a * random.uniform(110.0, 146.0) as f32 + b * random.uniform(110.0, 146.0) as f32);
                    view.clip_planes.push([a, b, 0.0, c]);
                }
                let vertices = (0..60).flat_map(|_| sliver(&mut random, 200.0, 200.0 / severity)).collect();
                vec![super::common::triangles(view, SIDE, SIDE, 24, vertices)]
            },
        },
        Family {
            name: "many_hits",
            about: "Large triangles over each other, as many as the severity says, up to where the 8 bit counter ends: every sample is hit as often as it must be.",
            knob: "triangles",
            severities: &[1.0, 16.0, 64.0, 256.0, 400.0],
            inside: |_| true,
            make: |severity, seed| {
                let mut random = Random::new("many_hits", severity, seed);
                let vertices: Vec<Vertex> = (0..severity as usize).flat_map(|_| sliver(&mut random, 160.0, 100.0)).collect();
                let view = View::pixels(SIDE, SIDE);
                let mut recording = Recording::new(SIDE, SIDE, 24);
                recording.view(&view).count_hits().draw(gl::TRIANGLES, has::COLOR, &vertices);
                let judge = move |frame: &Frame| {
                    let coverage: Coverage = cover(&view, SIDE, SIDE, &vertices, |_, _| true);
                    super::Score { counts: coverage.judge(&frame.stencil), ..super::Score::default() }
                };
                vec![Case { recording, judge: Box::new(judge) }]
            },
        },
    ]
}

fn stippled(severity: f64, seed: u64) -> Case {
    let mut random = Random::new("stippled_slivers", severity, seed);
    let view = View::pixels(SIDE, SIDE);
    let rows: Vec<u32> = (0..32).map(|_| random.bits() as u32).collect();
    let scissor = [0, 1].map(|_| (20 + random.below(60)) as usize);
    let vertices: Vec<Vertex> = (0..60).flat_map(|_| sliver(&mut random, 200.0, 200.0 / severity)).collect();
    let [x, y] = scissor.map(|v| v as i64);
    let mut state = Recording::new(SIDE, SIDE, 24);
    state.enable(gl::SCISSOR_TEST).call("scissor", &[x, y, 150, 170], &[]);
    state.enable(gl::POLYGON_STIPPLE).call("polygon_stipple", &rows.iter().map(|r| i64::from(*r)).collect::<Vec<_>>(), &[]);
    let recording = state.then(&record_triangles(&view, SIDE, SIDE, 24, &vertices));
    let judge = move |frame: &Frame| {
        // 3.5.2: bit 31 - x mod 32 of row y mod 32.
        let open = |column: usize, row: usize| {
            let boxed = (scissor[0]..scissor[0] + 150).contains(&column) && (scissor[1]..scissor[1] + 170).contains(&row);
            boxed && rows[row % 32] >> (31 - column % 32) & 1 != 0
        };
        let coverage = cover(&view, SIDE, SIDE, &vertices, open);
        judge_triangles(frame, &coverage, &view, &vertices, 24, |_| true)
    };
    Case { recording, judge: Box::new(judge) }
}
