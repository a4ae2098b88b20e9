//! Error against run time: for every setting that trades one for the other, a point with the error against a converged reference and the time of
//! a frame, on OSMesa and on Tepui's executors. Drawn as work-precision diagrams.

mod leaving_out;
mod page;
mod plot;
mod samples;
mod scenes;

use std::io::Write;
use std::path::PathBuf;

use clap::Args;
use serde::Serialize;

use crate::build::{build_library, root, work_dir};
use crate::compare::{reference_runner, tepui_runner};
use crate::flip::mean_flip;
use crate::frame::Frame;
use crate::recording::Recording;
use crate::runner::Runner;
use crate::timing::quantile;
use crate::{Devices, Error};

/// Options of `precision`.
#[derive(Args)]
pub struct Options {
    /// Every setting instead of every second one, more frames timed.
    #[arg(long)]
    full: bool,
    /// Only scenes whose name contains this; the table of what is left out is called leaving_out.
    #[arg(long, default_value = "")]
    filter: String,
    /// Which executors.
    #[arg(long, value_enum, default_value = "both")]
    device: Devices,
    /// Where the report goes.
    #[arg(long)]
    output: Option<PathBuf>,
}

impl Options {
    /// The command that gives the same errors.
    pub fn command(&self) -> String {
        let full = if self.full { " --full" } else { "" };
        format!("cargo run --release -p tepui-conformance -- precision{full}")
    }

    /// Rounds in which every method draws in turn, each in a new context, and frames of each.
    fn rounds(&self) -> [usize; 2] {
        if self.full { [5, 8] } else { [2, 1] }
    }
}

/// One value of a scene's setting.
pub struct Setting {
    /// Its value, in words.
    pub name: String,
    /// What is drawn.
    pub recording: Recording,
    /// Environment of Tepui's processes.
    pub environment: Vec<(&'static str, String)>,
}

/// The image that every setting should have given.
pub enum Reference {
    /// Worked out by the oracle: RGBA8, bottom row first.
    Pixels(Vec<u8>),
    /// What OSMesa draws with far more effort than any setting.
    Drawn(Recording),
}

/// What Tepui's errors must do from setting to setting.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Course {
    /// Anything.
    Free,
    /// Fall.
    Falls,
    /// Stay as they are, to the last digit.
    Stays,
}

impl Course {
    /// In words.
    fn demand(self) -> &'static str {
        match self {
            Course::Free => "",
            Course::Falls => "the RMS error falls from setting to setting",
            Course::Stays => "the errors are the same with every setting",
        }
    }
}

/// Something to look at with one setting that trades.
pub struct Scene {
    /// Its name.
    pub name: &'static str,
    /// What it shows, and what the reference is.
    pub about: &'static str,
    /// What is set.
    pub knob: &'static str,
    /// The reference.
    pub reference: Reference,
    /// From cheap to dear.
    pub settings: Vec<Setting>,
    /// What is demanded of the errors.
    pub course: Course,
}

/// Times and errors of one method with one setting.
#[derive(Clone, Debug, Serialize)]
pub struct Point {
    /// Its value, in words.
    pub setting: String,
    /// Root of the mean squared difference of a colour component, in 1/255.
    pub rms: f64,
    /// Largest difference of a colour component, in 1/255.
    pub max: u8,
    /// Mean FLIP error.
    pub flip: f64,
    /// Milliseconds a frame: lower quartile, median, upper quartile.
    pub milliseconds: [f64; 3],
    /// Why there is nothing, if it failed.
    pub failure: Option<String>,
    /// What the implementation does not have, if it does not claim to.
    pub missing: Option<String>,
}

impl Point {
    /// There are errors and times.
    fn drawn(&self) -> bool {
        self.failure.is_none() && self.missing.is_none()
    }
}

/// A curve.
#[derive(Clone, Debug, Serialize)]
pub struct Curve {
    /// `osmesa`, `scalar`, `cpu` or `gpu`.
    pub method: &'static str,
    /// In the order of the settings.
    pub points: Vec<Point>,
    /// Whether the errors go as they must, where that is demanded.
    pub course: Option<bool>,
}

impl Curve {
    /// Compares neighbours.
    fn judge(&mut self, course: Course) {
        let goes =
            |by: fn(&Point, &Point) -> bool| self.points.iter().all(Point::drawn) && self.points.windows(2).all(|p| by(&p[0], &p[1]));
        self.course = match course {
            _ if self.method == "osmesa" => None,
            Course::Free => None,
            Course::Falls => Some(goes(|before, after| after.rms < before.rms)),
            Course::Stays => Some(goes(|before, after| (before.rms, before.max, before.flip) == (after.rms, after.max, after.flip))),
        };
    }
}

/// A diagram.
#[derive(Clone, Debug, Serialize)]
pub struct Diagram {
    /// The scene.
    pub scene: &'static str,
    /// What it shows.
    pub about: &'static str,
    /// What is set.
    pub knob: &'static str,
    /// What is demanded of Tepui's errors, in words.
    pub demand: &'static str,
    /// A curve a method.
    pub curves: Vec<Curve>,
}

/// How `play.c` begins to say what an implementation does not have.
const NOT_THERE: &str = "not there: ";

/// RMS, maximum and FLIP of the colours.
fn errors(reference: &[u8], frame: &Frame) -> (f64, u8, f64) {
    let colors = || reference.chunks_exact(4).zip(frame.color.chunks_exact(4)).flat_map(|(r, t)| (0..3).map(|c| r[c].abs_diff(t[c])));
    let squares: f64 = colors().map(|d| f64::from(d).powi(2)).sum();
    let count = (reference.len() / 4 * 3) as f64;
    ((squares / count).sqrt(), colors().max().unwrap_or(0), mean_flip(reference, &frame.color, frame.width))
}

/// Plays a recording; the image and the milliseconds of each frame.
fn play(runner: &mut Runner, recording: &Recording, frames: usize) -> Result<(Frame, Vec<f64>), String> {
    let folder = work_dir().join("precision");
    let (path, prefix) = (folder.join("recording"), folder.join(runner.label));
    std::fs::write(&path, recording.bytes()).map_err(|e| format!("{}: {e}", path.display()))?;
    let lines = runner.request(&format!("play {frames} {} {}", path.display(), prefix.display()))?;
    let times = lines.iter().filter_map(|l| l.strip_prefix("ms ")?.parse().ok()).collect();
    Ok((Frame::read(&prefix)?, times))
}

/// The methods: OSMesa, the CPU executor without and with vectors, the kernels.
fn methods(devices: Devices, environment: &[(&'static str, String)]) -> Result<Vec<Runner>, Error> {
    let more: Vec<(&str, &str)> = environment.iter().map(|(k, v)| (*k, v.as_str())).collect();
    let mut runners = vec![reference_runner()?];
    if devices.cpu() {
        let mut scalar = tepui_runner("cpu", &more)?.with(&[("TEPUI_SIMD", "scalar")]);
        scalar.label = "scalar";
        runners.extend([scalar, tepui_runner("cpu", &more)?]);
    }
    if devices.gpu() {
        runners.push(tepui_runner("gpu", &more)?);
    }
    Ok(runners)
}

/// One setting on every method.
fn measure(runners: &mut [Runner], setting: &Setting, reference: &[u8], [rounds, frames]: [usize; 2]) -> Vec<Point> {
    let mut times: Vec<Vec<f64>> = vec![Vec::new(); runners.len()];
    let mut found: Vec<Result<(f64, u8, f64), String>> = vec![Err("not drawn".into()); runners.len()];
    for _ in 0..rounds {
        for (k, runner) in runners.iter_mut().enumerate() {
            let errors = play(runner, &setting.recording, frames + 1).map(|(frame, all)| {
                // The first frame of a context builds what is built once.
                times[k].extend(&all[1..]);
                errors(reference, &frame)
            });
            found[k] = match (&found[k], errors) {
                (Ok(before), Ok(now)) if *before != now => Err(format!("other errors than the round before: {before:?}, {now:?}")),
                (_, now) => now,
            };
        }
    }
    let point = |((found, mut times), runner): ((Result<(f64, u8, f64), String>, Vec<f64>), &Runner)| {
        let failure = found.as_ref().err().cloned();
        // What OSMesa never had is no failure of this comparison.
        let (missing, failure) = match failure {
            Some(why) if runner.label == "osmesa" && why.starts_with(NOT_THERE) => (Some(why), None),
            failure => (None, failure),
        };
        let (rms, max, flip) = found.unwrap_or((f64::NAN, 0, f64::NAN));
        let quartile = |times: &mut Vec<f64>, q: f64| if times.is_empty() { f64::NAN } else { quantile(times, q) };
        let milliseconds = [0.25, 0.5, 0.75].map(|q| quartile(&mut times, q));
        Point { setting: setting.name.clone(), rms, max, flip, milliseconds, failure, missing }
    };
    found.into_iter().zip(times).zip(&*runners).map(point).collect()
}

fn diagram(options: &Options, scene: &Scene) -> Result<Diagram, Error> {
    let mut runners = methods(options.device, &[])?;
    let reference = match &scene.reference {
        Reference::Pixels(pixels) => pixels.clone(),
        Reference::Drawn(recording) => play(&mut runners[0], recording, 1)?.0.color,
    };
    let mut curves: Vec<Curve> = runners.iter().map(|r| Curve { method: r.label, points: Vec::new(), course: None }).collect();
    for setting in scene.settings.iter().step_by(if options.full { 1 } else { 2 }) {
        if !setting.environment.is_empty() {
            runners = methods(options.device, &setting.environment)?;
        }
        for (curve, point) in curves.iter_mut().zip(measure(&mut runners, setting, &reference, options.rounds())) {
            let [low, median, high] = point.milliseconds;
            let failure = point.failure.as_deref().or(point.missing.as_deref()).unwrap_or("");
            println!(
                "  {:<24} {:<8} rms {:>7.3} max {:>3} flip {:.4}  {median:>8.2} ms ({low:.2} - {high:.2}) {failure}",
                setting.name, curve.method, point.rms, point.max, point.flip
            );
            curve.points.push(point);
        }
    }
    for curve in &mut curves {
        curve.judge(scene.course);
        if let Some(holds) = curve.course {
            println!("  {:<8} {}: {}", curve.method, scene.course.demand(), if holds { "yes" } else { "NO" });
        }
    }
    Ok(Diagram { scene: scene.name, about: scene.about, knob: scene.knob, demand: scene.course.demand(), curves })
}

/// Runs it; true when every method drew everything, the same in every round, errors went as they must, and neutral state changed nothing.
pub fn main(options: &Options) -> Result<bool, Error> {
    let output = options.output.clone().unwrap_or_else(|| root().join("report"));
    std::fs::create_dir_all(&output)?;
    std::fs::create_dir_all(work_dir().join("precision"))?;
    build_library()?;
    let scenes: Vec<Scene> = scenes::all().into_iter().filter(|s| s.name.contains(&options.filter)).collect();
    let mut diagrams = Vec::new();
    for (i, scene) in scenes.iter().enumerate() {
        println!("[{}/{}] {}", i + 1, scenes.len(), scene.name);
        std::io::stdout().flush()?;
        diagrams.push(diagram(options, scene)?);
    }
    let mut tables = Vec::new();
    if "leaving_out".contains(&options.filter) {
        println!("leaving out");
        tables = leaving_out::measure(options)?;
    }
    let mut about = Vec::new();
    for runner in &mut methods(options.device, &[])? {
        about.push((runner.label, runner.request("about").map_or_else(|why| why, |l| l.join(" "))));
    }
    page::write(&output, options, &about, &diagrams, &tables)?;
    println!("\nreport: {}", output.join("precision.html").display());
    let points = || diagrams.iter().flat_map(|d| &d.curves).flat_map(|c| &c.points);
    // A feature that is forced on in a neutral state changes nothing on Tepui.
    let costs = || {
        tables.iter().flat_map(|t| t.costs.iter().map(move |c| t.methods.iter().zip(&c.changed).all(|(m, n)| *m == "osmesa" || *n == 0)))
    };
    let courses = || diagrams.iter().flat_map(|d| &d.curves).filter_map(|c| c.course);
    let missing = points().filter(|p| p.missing.is_some()).count();
    let failed = points().filter(|p| p.failure.is_some()).count()
        + [costs().filter(|same| !same).count(), courses().filter(|c| !c).count()].iter().sum::<usize>();
    println!("precision: {} passed, {failed} failed", points().count() - missing + costs().count() + courses().count() - failed);
    Ok(failed == 0)
}
