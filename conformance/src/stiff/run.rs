//! `stiff`: every family at every severity on every implementation, judged by the oracle.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args;
use serde::Serialize;

use super::expect::{Exceptions, Judged, Peer};
use super::{Case, Family, Score, families, page};
use crate::build::{build_library, root, work_dir};
use crate::compare::{reference_runner, tepui_runner};
use crate::expectations::Verdict;
use crate::frame::Frame;
use crate::runner::Runner;
use crate::{Devices, Error};

/// How long one image may take before it counts as hung.
const PATIENCE: Duration = Duration::from_secs(60);

/// Frames of an image: the first is judged and builds what is built once, the faster one is the time.
const FRAMES: usize = 2;

/// Address space of a runner: what wants more has no bound.
const MEMORY_MIB: &str = "12288";

/// Triangles that a family of meshes draws in the full form, all three together more than 10^7. Fans are slow on kernels, because all of
/// their triangles meet in one tile.
fn mesh_triangles(family: &str) -> Option<f64> {
    match family {
        "mesh_fan" => Some(1.2e6),
        "mesh_grid" | "mesh_random" => Some(4.5e6),
        _ => None,
    }
}

/// Options of `stiff`.
#[derive(Args)]
pub struct Options {
    /// Eight seeds instead of one, 10^7 triangles in meshes.
    #[arg(long)]
    full: bool,
    /// The first seed.
    #[arg(long, default_value_t = 1)]
    seed: u64,
    /// Only families whose name contains this.
    #[arg(long, default_value = "")]
    filter: String,
    /// Which executors.
    #[arg(long, value_enum, default_value = "both")]
    device: Devices,
    /// Leaves OSMesa out, for machines that do not have it: coverage is judged by the oracle as always, values of the kernels also by the CPU
    /// executor's, which is then always drawn.
    #[arg(long, alias = "without-osmesa")]
    without_reference: bool,
    /// Where the report goes.
    #[arg(long)]
    output: Option<PathBuf>,
    /// Keeps the recordings and the images of cases with wrong samples beside the report.
    #[arg(long)]
    keep: bool,
}

impl Options {
    fn seeds(&self) -> u64 {
        if self.full { 8 } else { 1 }
    }

    /// OSMesa was there.
    pub fn has_reference(&self) -> bool {
        !self.without_reference
    }

    /// The command that gives the same numbers.
    pub fn command(&self) -> String {
        let form = if self.full { " --full" } else { "" };
        let filter = if self.filter.is_empty() { String::new() } else { format!(" --filter {}", self.filter) };
        let without = if self.without_reference { " --without-reference" } else { "" };
        format!("cargo run --release -p tepui-conformance -- stiff{form} --seed {}{filter}{without}", self.seed)
    }

    /// In words.
    pub fn form(&self) -> &'static str {
        if self.full { "full" } else { "short" }
    }

    /// Seeds of a severity: the largest meshes are drawn until there are enough triangles.
    fn rounds(&self, family: &Family, severity: f64) -> u64 {
        match mesh_triangles(family.name) {
            Some(triangles) if self.full && family.severities.last() == Some(&severity) => (triangles / severity).ceil() as u64,
            _ => self.seeds(),
        }
    }
}

/// One implementation at one severity.
#[derive(Clone, Debug, Serialize)]
pub struct Outcome {
    /// `osmesa`, `cpu` or `gpu`.
    pub implementation: &'static str,
    /// What the oracle says.
    pub score: Score,
    /// Crashes, hangs, errors.
    pub failures: Vec<String>,
    /// Milliseconds for all images of the severity, the fastest frame of each.
    pub milliseconds: f64,
    /// Peak memory of the process so far, in MiB.
    pub mebibytes: u64,
    /// Tepui only.
    pub verdict: Option<Verdict>,
    /// Values are off by more than a unit, and without OSMesa nothing says whether they may be.
    pub open: bool,
}

/// All implementations at one severity.
#[derive(Clone, Debug, Serialize)]
pub struct Step {
    /// The knob.
    pub severity: f64,
    /// Everything lies inside the guard band.
    pub inside: bool,
    /// Images.
    pub images: usize,
    /// In the order of the runners.
    pub outcomes: Vec<Outcome>,
}

/// One family's results.
#[derive(Clone, Debug, Serialize)]
pub struct FamilyResult {
    /// Its name.
    pub family: &'static str,
    /// What is hard about it.
    pub about: &'static str,
    /// What the severity is.
    pub knob: &'static str,
    /// Severity by severity.
    pub steps: Vec<Step>,
}

/// What one runner made of one case.
fn play(runner: &mut Runner, recording: &Path) -> Result<(Frame, f64, u64), String> {
    let prefix = work_dir().join("stiff").join(runner.label);
    let lines = runner.request(&format!("play {FRAMES} {} {}", recording.display(), prefix.display()))?;
    let numbers = |key: &str| lines.iter().filter_map(|l| l.strip_prefix(key)?.parse::<f64>().ok()).collect::<Vec<f64>>();
    let fastest = numbers("ms ").into_iter().fold(f64::INFINITY, f64::min);
    let memory = numbers("kib ").first().map_or(0, |kib| (*kib / 1024.0) as u64);
    let frame = Frame::read(&prefix)?;
    if frame.error != "GL_NO_ERROR" {
        return Err(format!("the GL recorded {}", frame.error));
    }
    Ok((frame, fastest, memory))
}

struct Session<'a> {
    options: &'a Options,
    runners: Vec<Runner>,
    /// What each runner's implementation says of itself.
    about: Vec<(&'static str, String)>,
    exceptions: Exceptions,
    output: PathBuf,
}

impl Session<'_> {
    fn case(&mut self, name: &str, case: &Case, outcomes: &mut [Outcome]) -> Result<(), Error> {
        let path = work_dir().join("stiff/recording");
        std::fs::write(&path, case.recording.bytes())?;
        for (runner, outcome) in self.runners.iter_mut().zip(outcomes) {
            match play(runner, &path) {
                Ok((frame, milliseconds, mebibytes)) => {
                    let score = (case.judge)(&frame);
                    if self.options.keep && score.counts.wrong + score.counts.off_rule > 0 {
                        let kept = self.output.join("stiff-cases");
                        std::fs::create_dir_all(&kept)?;
                        std::fs::copy(&path, kept.join(format!("{name}.recording")))?;
                        frame.save(&kept.join(format!("{name}-{}.png", runner.label)))?;
                    }
                    outcome.score.merge(&score);
                    outcome.milliseconds += milliseconds;
                    outcome.mebibytes = outcome.mebibytes.max(mebibytes);
                }
                Err(why) => outcome.failures.push(format!("{name}: {why}")),
            }
        }
        Ok(())
    }

    fn step(&mut self, family: &Family, severity: f64) -> Result<Step, Error> {
        let blank = |runner: &Runner| Outcome {
            implementation: runner.label,
            score: Score::default(),
            failures: Vec::new(),
            milliseconds: 0.0,
            mebibytes: 0,
            verdict: None,
            open: false,
        };
        let mut outcomes: Vec<Outcome> = self.runners.iter().map(blank).collect();
        let mut images = 0;
        for round in 0..self.options.rounds(family, severity) {
            let seed = self.options.seed + round;
            for (k, case) in (family.make)(severity, seed).iter().enumerate() {
                self.case(&format!("{}-{severity:e}-{seed}-{k}", family.name), case, &mut outcomes)?;
                images += 1;
            }
        }
        let of = |name: &str| outcomes.iter().find(|o| o.implementation == name && o.failures.is_empty()).map(|o| o.score);
        let (osmesa, cpu) = (of("osmesa"), of("cpu"));
        for (outcome, (_, renderer)) in outcomes.iter_mut().zip(&self.about).filter(|(o, _)| o.implementation != "osmesa") {
            let peer = match (self.options.without_reference, outcome.implementation) {
                (false, _) => Peer::Osmesa(osmesa.as_ref()),
                (true, "cpu") => Peer::Nobody,
                (true, _) => Peer::Cpu(cpu.as_ref()),
            };
            let judged = Judged {
                family: family.name,
                severity,
                device: outcome.implementation,
                renderer,
                full: self.options.full,
                score: &outcome.score,
                peer,
                failures: &outcome.failures,
            };
            outcome.open = self.exceptions.leaves_open(&judged);
            outcome.verdict = Some(self.exceptions.judge(&judged));
        }
        Ok(Step { severity, inside: (family.inside)(severity), images, outcomes })
    }
}

/// One line of progress.
fn line(family: &str, step: &Step) -> String {
    let mut out = format!("{family:<20} {:>9.3e}", step.severity);
    for o in &step.outcomes {
        let mark = match &o.verdict {
            None | Some(Verdict::Pass) => "",
            Some(Verdict::Expected(_)) => " expected",
            Some(Verdict::Fail(_)) => " FAIL",
            Some(Verdict::UnexpectedPass(_)) => " UNEXPECTED PASS",
        };
        let open = if o.open { " (values not judged)" } else { "" };
        let c = &o.score.counts;
        let failures = if o.failures.is_empty() { String::new() } else { format!(" {} failed ({})", o.failures.len(), o.failures[0]) };
        out += &format!(
            " | {}{mark}{open} wrong {} beyond {} off {} colour {:.2} depth {:.2} {:.1} ms{failures}",
            o.implementation, c.wrong, c.beyond, c.off_rule, o.score.color.max, o.score.depth.max, o.milliseconds
        );
    }
    out
}

/// Runs it; true when nothing unexpected happened.
pub fn main(options: &Options) -> Result<bool, Error> {
    let output = options.output.clone().unwrap_or_else(|| root().join("report"));
    std::fs::create_dir_all(&output)?;
    std::fs::create_dir_all(work_dir().join("stiff"))?;
    let exceptions = Exceptions::parse(&std::fs::read_to_string(root().join("conformance/stiff.toml"))?)?;
    let all = families();
    let strangers = exceptions.strangers(|name, s| all.iter().any(|f| f.name == name && f.severities.contains(&s)));
    if !strangers.is_empty() {
        return Err(format!("stiff.toml has entries for what does not exist: {}", strangers.join(", ")).into());
    }
    build_library()?;
    let memory = [("RUNNER_MEMORY_MIB", MEMORY_MIB)];
    let mut runners = Vec::new();
    if !options.without_reference {
        runners.push(reference_runner()?.with(&memory));
    }
    if options.device.cpu() || options.without_reference {
        runners.push(tepui_runner("cpu", &memory)?);
    }
    if options.device.gpu() {
        runners.push(tepui_runner("gpu", &memory)?);
    }
    let mut runners: Vec<Runner> = runners.into_iter().map(|r| r.patient(PATIENCE)).collect();
    let about = runners.iter_mut().map(|r| (r.label, r.request("about").map_or_else(|why| why, |l| l.join(" ")))).collect();
    let mut session = Session { options, runners, about, exceptions, output };
    let chosen: Vec<&Family> = all.iter().filter(|f| f.name.contains(&options.filter)).collect();
    let mut results = Vec::new();
    for (i, family) in chosen.iter().enumerate() {
        let mut steps = Vec::new();
        for &severity in family.severities {
            let step = session.step(family, severity)?;
            println!("[{:>2}/{}] {}", i + 1, chosen.len(), line(family.name, &step));
            std::io::stdout().flush()?;
            steps.push(step);
        }
        results.push(FamilyResult { family: family.name, about: family.about, knob: family.knob, steps });
    }
    page::write(&session.output, options, &session.about, &results)?;
    println!("\nreport: {}", session.output.join("stiff.html").display());
    let verdicts: Vec<&Verdict> =
        results.iter().flat_map(|r| &r.steps).flat_map(|s| &s.outcomes).filter_map(|o| o.verdict.as_ref()).collect();
    let failed = verdicts.iter().filter(|v| !v.good()).count();
    let open = results.iter().flat_map(|r| &r.steps).flat_map(|s| &s.outcomes).filter(|o| o.open).count();
    if open > 0 {
        println!("without OSMesa the values of {open} severities were not judged, only their coverage");
    }
    println!("stiff: {} passed, {failed} failed", verdicts.len() - failed);
    Ok(failed == 0)
}
