//! What a scene does not need is left out: what the CPU executor and the kernels built and left out (`TEPUI_STATS=1`), and what each feature
//! costs when it is forced on in a state that changes no pixel.

use std::path::{Path, PathBuf};

use serde::Serialize;

use super::{Options, methods, play};
use crate::Error;
use crate::build::{Implementation, build_runner, work_dir};
use crate::recording::{Recording, Vertex, View, gl, has};
use crate::runner::Runner;
use crate::timing::quantile;

const SIDE: usize = 512;

/// A feature that is forced on: its name and the state that does it.
type Feature = (&'static str, fn(&mut Recording));

const FEATURES: [Feature; 12] = [
    ("nothing", |_| {}),
    ("depth test, ALWAYS", |r| {
        r.enable(gl::DEPTH_TEST).call("depth_func", &[gl::ALWAYS.into()], &[]);
    }),
    ("stencil test, ALWAYS and KEEP", |r| {
        let [always, keep] = [gl::ALWAYS, gl::KEEP].map(i64::from);
        r.enable(gl::STENCIL_TEST).call("stencil", &[always, 0, 255, keep, keep, keep], &[]);
    }),
    ("blending, ONE and ZERO", |r| {
        r.enable(gl::BLEND).call("blend_func", &[gl::ONE.into(), gl::ZERO.into()], &[]);
    }),
    ("blending, by alphas of 1", |r| {
        r.enable(gl::BLEND).call("blend_func", &[gl::SRC_ALPHA.into(), gl::ONE_MINUS_SRC_ALPHA.into()], &[]);
    }),
    ("alpha test, GEQUAL 0", |r| {
        r.enable(gl::ALPHA_TEST).call("alpha_func", &[gl::GEQUAL.into()], &[0.0]);
    }),
    ("logic op COPY", |r| {
        r.enable(gl::COLOR_LOGIC_OP).call("logic_op", &[gl::COPY.into()], &[]);
    }),
    ("fog that begins behind everything", |r| {
        r.enable(gl::FOG).call("fog_mode", &[gl::LINEAR.into()], &[]);
        r.call("fog", &[gl::FOG_START.into()], &[1e6, 0.0, 0.0, 0.0]).call("fog", &[gl::FOG_END.into()], &[2e6, 0.0, 0.0, 0.0]);
    }),
    ("a white texture, MODULATE", |r| {
        for pname in [gl::TEXTURE_MIN_FILTER, gl::TEXTURE_MAG_FILTER] {
            r.call("tex_parameter", &[pname.into(), gl::NEAREST.into()], &[]);
        }
        r.texture(0, 1, 1, &[[255; 4]]).enable(gl::TEXTURE_2D).call("tex_env", &[gl::MODULATE.into()], &[]);
    }),
    ("lighting, ambient white", |r| {
        r.enable(gl::COLOR_MATERIAL).enable(gl::LIGHTING).call("light_model", &[gl::LIGHT_MODEL_AMBIENT.into()], &[1.0; 4]);
    }),
    ("polygon stipple of all ones", |r| {
        r.enable(gl::POLYGON_STIPPLE).call("polygon_stipple", &[-1; 32], &[]);
    }),
    ("a clip plane that cuts nothing", |r| {
        r.call("clip_plane", &[0], &[0.0, 0.0, 0.0, 1.0]).enable(gl::CLIP_PLANE0);
    }),
];

/// One feature on one scene.
#[derive(Clone, Debug, Serialize)]
pub struct Cost {
    /// What is forced on.
    pub feature: &'static str,
    /// Median milliseconds of each method.
    pub milliseconds: Vec<f64>,
    /// The same by the median of the scene without it, drawn in turn with it.
    pub ratios: Vec<f64>,
    /// Pixels that differ from the scene without it, on each method.
    pub changed: Vec<usize>,
    /// What each of Tepui's executors says it built and left out: its name, its lines.
    pub built: Vec<(&'static str, Vec<String>)>,
}

/// A scene with all features.
#[derive(Clone, Debug, Serialize)]
pub struct Table {
    /// The scene.
    pub scene: &'static str,
    /// The methods.
    pub methods: Vec<&'static str>,
    /// Feature by feature, `nothing` first.
    pub costs: Vec<Cost>,
}

/// Coloured triangles, `cells` by `cells` squares of two.
fn mesh(cells: usize) -> Vec<Vertex> {
    let size = SIDE as f32 / cells as f32;
    let corner = |i: usize, j: usize| {
        let shade = |k: usize| ((i * 7 + j * 13 + k * 5) % 17) as f32 / 16.0;
        Vertex::new(i as f32 * size, j as f32 * size, 0.0).colored([shade(0), shade(1), shade(2), 1.0])
    };
    let square = |k: usize| {
        let (i, j) = (k % cells, k / cells);
        [(0, 0), (1, 0), (1, 1), (0, 0), (1, 1), (0, 1)].map(|(di, dj)| corner(i + di, j + dj))
    };
    (0..cells * cells).flat_map(square).collect()
}

/// An executor that says what it builds. Its process goes on from recording to recording, so that kernels are built once.
struct Statistics {
    device: &'static str,
    runner: Runner,
    log: PathBuf,
    /// Bytes of the log that were read.
    read: usize,
}

impl Statistics {
    /// Kernels do all from the vertices on, also where the host's front end is faster: what they leave out is to be seen.
    fn new(binary: &Path, device: &'static str) -> Statistics {
        let log = work_dir().join(format!("precision/statistics-{device}.log"));
        let environment = [("TEPUI_DEVICE", device), ("TEPUI_STATS", "1"), ("TEPUI_GPU_FRONT", "kernels")];
        Statistics { device, runner: Runner::new("statistics", binary, &environment, log.clone()), log, read: 0 }
    }

    /// The lines of a recording's batches, those with numbers of triangles left out.
    fn of(&mut self, recording: &Recording) -> Result<Vec<String>, Error> {
        play(&mut self.runner, recording, 1)?;
        let text = std::fs::read_to_string(&self.log)?;
        let mut lines: Vec<String> = Vec::new();
        for line in text[self.read..].lines().filter_map(|l| l.strip_prefix("tepui:   ")) {
            if !lines.iter().any(|l| l == line) {
                lines.push(line.to_owned());
            }
        }
        self.read = text.len();
        Ok(lines)
    }
}

/// The triangles with a feature forced on.
fn recording(vertices: &[Vertex], state: fn(&mut Recording)) -> Recording {
    let mut recording = Recording::new(SIDE, SIDE, 24);
    recording.view(&View::pixels(SIDE, SIDE));
    state(&mut recording);
    recording.draw(gl::TRIANGLES, has::COLOR, vertices);
    recording
}

/// Measures every feature on a scene of many triangles and on one of few large ones.
pub fn measure(options: &Options) -> Result<Vec<Table>, Error> {
    let binary = build_runner(Implementation::Tepui)?;
    let mut runners = methods(options.device, &[])?;
    let executors = [("cpu", options.device.cpu()), ("gpu", options.device.gpu())].into_iter().filter(|e| e.1);
    let mut executors: Vec<Statistics> = executors.map(|(device, _)| Statistics::new(&binary, device)).collect();
    let [rounds, frames] = if options.full { options.rounds() } else { [1, 2] };
    let mut tables = Vec::new();
    for (scene, vertices) in [("32,768 triangles of 8 pixels", mesh(128)), ("8 triangles of 32,768 pixels", mesh(2))] {
        let mut costs: Vec<Cost> = Vec::new();
        let plain = recording(&vertices, |_| {});
        for (feature, state) in FEATURES {
            let forced = recording(&vertices, state);
            let (mut milliseconds, mut ratios, mut changed) = (Vec::new(), Vec::new(), Vec::new());
            for runner in &mut runners {
                let mut times = [Vec::new(), Vec::new()];
                let mut images = [Vec::new(), Vec::new()];
                // In turn, so that a drift of the machine hits both.
                for _ in 0..rounds {
                    for (k, recording) in [&plain, &forced].into_iter().enumerate() {
                        let (frame, all) = play(runner, recording, frames + 1)?;
                        times[k].extend(&all[1..]);
                        images[k] = frame.color;
                    }
                }
                let [without, with] = times.map(|mut t| quantile(&mut t, 0.5));
                milliseconds.push(with);
                ratios.push(with / without);
                changed.push(images[0].chunks_exact(4).zip(images[1].chunks_exact(4)).filter(|(a, b)| a != b).count());
            }
            println!("  {scene}, {feature}: {milliseconds:.2?} ms, {ratios:.2?} times, {changed:?} pixels changed");
            let built = executors.iter_mut().map(|e| Ok((e.device, e.of(&forced)?)));
            costs.push(Cost { feature, milliseconds, ratios, changed, built: built.collect::<Result<_, Error>>()? });
        }
        tables.push(Table { scene, methods: runners.iter().map(|r| r.label).collect(), costs });
    }
    Ok(tables)
}
