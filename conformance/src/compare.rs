//! `compare`: every scene on every implementation.

use std::io::Write;
use std::path::{Path, PathBuf};

use clap::Args;
use serde::Serialize;

use crate::build::{Implementation, build_library, build_runner, root, work_dir};
use crate::expectations::{Device, Expectations, Verdict};
use crate::frame::{Difference, Frame, compare, save_difference};
use crate::runner::{Runner, Scene, TEXT_ONLY};
use crate::timing::{Times, interleave};
use crate::{Devices, Error, report};

/// Options of `compare`.
#[derive(Args)]
pub struct Options {
    /// Only scenes whose name contains this.
    #[arg(long, default_value = "")]
    filter: String,
    /// Which executors.
    #[arg(long, value_enum, default_value = "both")]
    device: Devices,
    /// Frames that are timed; 0 leaves timing out.
    #[arg(long, default_value_t = 5)]
    frames: usize,
    /// Where the report goes.
    #[arg(long)]
    output: Option<PathBuf>,
    /// Compares OSMesa with itself: tests the harness.
    #[arg(long)]
    self_test: bool,
    /// Takes the CPU executor for the reference, where there is no OSMesa: judges the kernels alone.
    #[arg(long)]
    without_reference: bool,
}

/// One implementation's result of one scene.
#[derive(Debug, Serialize)]
pub struct Side {
    /// `cpu` or `gpu`.
    pub device: &'static str,
    /// Against the reference.
    pub against_reference: Result<Difference, String>,
    /// Kernels only: against the CPU executor.
    pub against_cpu: Option<Result<Difference, String>>,
    /// The judgement.
    pub verdict: Verdict,
    /// Times, if they were taken.
    pub times: Option<Result<Times, String>>,
    /// Pictures beside the report: result, difference from the reference.
    pub pictures: Option<[String; 2]>,
}

/// All results of one scene.
#[derive(Debug, Serialize)]
pub struct Row {
    /// Its name.
    pub scene: String,
    /// Its class.
    pub class: String,
    /// What it proves.
    pub proves: String,
    /// The reference's picture beside the report.
    pub picture: Option<String>,
    /// The reference's times.
    pub times: Option<Result<Times, String>>,
    /// Tepui's executors.
    pub sides: Vec<Side>,
    /// The CPU executor with OSMesa's rules, where those depart from the specification.
    pub parity: Option<Side>,
}

/// The environment of the reference.
pub const REFERENCE: &[(&str, &str)] = &[("MESA_GL_VERSION_OVERRIDE", "2.1"), ("MESA_GLSL_VERSION_OVERRIDE", "120")];

/// A runner on Mesa's OSMesa.
pub fn reference_runner() -> Result<Runner, Error> {
    Ok(Runner::new("osmesa", &build_runner(Implementation::Reference)?, REFERENCE, work_dir().join("osmesa.log")))
}

/// A runner on Tepui's executor `device` with more environment.
pub fn tepui_runner(device: &'static str, more: &[(&str, &str)]) -> Result<Runner, Error> {
    let mut environment = vec![("TEPUI_DEVICE", device)];
    environment.extend_from_slice(more);
    Ok(Runner::new(device, &build_runner(Implementation::Tepui)?, &environment, work_dir().join(format!("{device}.log"))))
}

fn draw(runner: &mut Runner, scene: &str) -> Result<Frame, String> {
    let prefix = work_dir().join("frames").join(format!("{}-{scene}", runner.label));
    for suffix in ["color", "depth", "stencil", "text", "meta"] {
        let _ = std::fs::remove_file(prefix.with_extension(suffix));
    }
    runner.request(&format!("run {scene} {}", prefix.display()))?;
    let frame = Frame::read(&prefix);
    for suffix in ["color", "depth", "stencil", "text", "meta"] {
        let _ = std::fs::remove_file(prefix.with_extension(suffix));
    }
    frame
}

/// Writes a result's picture and its difference from the reference's, where there are both.
fn save(frame: &Result<Frame, String>, reference: &Result<Frame, String>, images: &Path, label: &str, scene: &str) -> Option<[String; 2]> {
    let (Ok(frame), Ok(reference)) = (frame, reference) else { return None };
    let [picture, difference] = [format!("{scene}-{label}.png"), format!("{scene}-{label}-difference.png")];
    frame.save(&images.join(&picture)).ok()?;
    save_difference(reference, frame, &images.join(&difference)).ok()?;
    Some([picture, difference].map(|name| format!("images/{name}")))
}

/// How a result differs from another one, or why there is nothing to compare.
fn difference(other: &Result<Frame, String>, frame: &Result<Frame, String>) -> Result<Difference, String> {
    match (other, frame) {
        (Ok(r), Ok(t)) => Ok(compare(r, t)),
        (_, Err(why)) => Err(why.clone()),
        (Err(why), _) => Err(format!("nothing to compare with: {why}")),
    }
}

struct Session {
    reference: Runner,
    tepui: Vec<Runner>,
    /// `TEPUI_PARITY=osmesa`.
    parity: Option<Runner>,
    expectations: Expectations,
    images: PathBuf,
    frames: usize,
}

impl Session {
    fn row(&mut self, scene: &Scene) -> Row {
        let name = &scene.name;
        let reference = draw(&mut self.reference, name);
        let mut row = Row {
            scene: name.clone(),
            class: scene.class.clone(),
            proves: scene.proves.clone(),
            picture: None,
            times: None,
            sides: Vec::new(),
            parity: None,
        };
        if let Ok(frame) = &reference {
            let picture = format!("{name}-osmesa.png");
            row.picture = frame.save(&self.images.join(&picture)).ok().map(|()| format!("images/{picture}"));
        }
        let mut cpu: Option<Result<Frame, String>> = None;
        for runner in &mut self.tepui {
            let frame = draw(runner, name);
            let against_reference = difference(&reference, &frame);
            let against_cpu = (runner.label == "gpu").then(|| cpu.as_ref().map(|cpu| difference(cpu, &frame))).flatten();
            let verdict = match &against_cpu {
                Some(outcome) => self.expectations.judge(name, &scene.class, Device::Gpu, outcome),
                None => self.expectations.judge(name, &scene.class, Device::Cpu, &against_reference),
            };
            let pictures = save(&frame, &reference, &self.images, runner.label, name);
            row.sides.push(Side { device: runner.label, against_reference, against_cpu, verdict, times: None, pictures });
            if cpu.is_none() {
                cpu = Some(frame);
            }
        }
        if let Some(runner) = self.parity.as_mut().filter(|_| self.expectations.departs(name)) {
            let frame = draw(runner, name);
            let against_reference = difference(&reference, &frame);
            let verdict = self.expectations.judge(name, &scene.class, Device::Parity, &against_reference);
            let pictures = save(&frame, &reference, &self.images, runner.label, name);
            row.parity = Some(Side { device: runner.label, against_reference, against_cpu: None, verdict, times: None, pictures });
        }
        if self.frames > 0 && scene.flags & TEXT_ONLY == 0 {
            let mut runners = vec![&mut self.reference];
            runners.extend(self.tepui.iter_mut().zip(&row.sides).filter(|(_, s)| s.against_reference.is_ok()).map(|(r, _)| r));
            let labels: Vec<&str> = runners.iter().map(|r| r.label).collect();
            for (label, times) in labels.into_iter().zip(interleave(name, &mut runners, 1, self.frames)) {
                match row.sides.iter_mut().find(|s| s.device == label) {
                    Some(side) => side.times = Some(times),
                    None => row.times = Some(times),
                }
            }
        }
        row
    }
}

/// One line of progress.
fn line(row: &Row) -> String {
    let mut out = format!("{:<28} {:<6}", row.scene, row.class);
    for side in row.sides.iter().chain(&row.parity) {
        let verdict = match &side.verdict {
            Verdict::Pass => "ok",
            Verdict::Expected(_) => "expected",
            Verdict::Fail(_) => "FAIL",
            Verdict::UnexpectedPass(_) => "UNEXPECTED PASS",
        };
        let ratio =
            side.times.as_ref().and_then(|t| t.as_ref().ok()).and_then(|t| t.ratio).map_or(String::new(), |r| format!(" time {r:.2}"));
        let outcome = side.against_cpu.as_ref().unwrap_or(&side.against_reference);
        let detail = match outcome {
            Err(why) => format!(" {why}"),
            Ok(d) if d.pixels + d.coverage + d.depth_pixels + d.stencil + d.text == 0 => String::new(),
            Ok(d) => format!(
                " {} px max {} flip {:.4} cover {} depth {} max {} stencil {} text {}",
                d.pixels, d.max, d.flip, d.coverage, d.depth_pixels, d.depth_max, d.stencil, d.text
            ),
        };
        out += &format!(" | {} {verdict}{detail}{ratio}", side.device);
    }
    out
}

/// Runs the comparison; true when nothing unexpected happened.
pub fn main(options: &Options) -> Result<bool, Error> {
    let output = options.output.clone().unwrap_or_else(|| root().join("report"));
    let images = output.join("images");
    std::fs::create_dir_all(&images)?;
    std::fs::create_dir_all(work_dir().join("frames"))?;
    let expectations = std::fs::read_to_string(root().join("conformance/expectations.toml"))?;
    let expectations = Expectations::parse(&expectations)?;
    let mut tepui = Vec::new();
    if options.self_test {
        tepui.push(Runner::new("self", &build_runner(Implementation::Reference)?, REFERENCE, work_dir().join("self.log")));
    } else {
        build_library()?;
        tepui.push(tepui_runner("cpu", &[])?);
        if options.device.gpu() {
            tepui.push(tepui_runner("gpu", &[])?);
        }
    }
    let reference = if options.without_reference { tepui_runner("cpu", &[])? } else { reference_runner()? };
    let parity = (options.device.cpu() && !options.self_test && !options.without_reference)
        .then(|| Ok::<_, Error>(tepui_runner("cpu", &[("TEPUI_PARITY", "osmesa")])?.labelled("parity")))
        .transpose()?;
    let mut session = Session { reference, tepui, parity, expectations, images, frames: options.frames };
    let all = session.reference.scenes()?;
    let names: Vec<String> = all.iter().map(|s| s.name.clone()).collect();
    let strangers: Vec<&str> = session.expectations.strangers(&names).collect();
    if !strangers.is_empty() {
        return Err(format!("expectations.toml names scenes that do not exist: {}", strangers.join(", ")).into());
    }
    let chosen: Vec<&Scene> = all.iter().filter(|s| s.name.contains(&options.filter)).collect();
    let mut rows = Vec::new();
    for (i, scene) in chosen.iter().enumerate() {
        let row = session.row(scene);
        println!("[{:>3}/{}] {}", i + 1, chosen.len(), line(&row));
        std::io::stdout().flush()?;
        rows.push(row);
    }
    let mut about = Vec::new();
    for runner in std::iter::once(&mut session.reference).chain(&mut session.tepui) {
        about.push((runner.label, runner.request("about").map_or_else(|why| why, |l| l.join(" "))));
    }
    report::write(&output, &rows, &about)?;
    println!("\nreport: {}", output.join("index.html").display());
    let judged = |side: &&Side| side.device != "cpu" || options.device.cpu() && !options.without_reference;
    let verdicts: Vec<&Side> = rows.iter().flat_map(|r| r.sides.iter().chain(&r.parity)).filter(judged).collect();
    let failed = verdicts.iter().filter(|s| !s.verdict.good()).count();
    println!("conformance: {} passed, {failed} failed", verdicts.len() - failed);
    Ok(failed == 0)
}
