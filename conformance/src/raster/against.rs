//! The same calls on several implementations of OpenGL, each in a process of its own, frame by frame in turn: Mesa's OSMesa, Tepui on
//! the CPU and on the kernels, and whatever EGL gives.

use std::collections::HashMap;
use std::path::Path;

use super::bench::Bench;
use super::scenes::Scene;
use super::section::{Plot, Section, Table, progress};
use super::{Case, Options, sizes};
use crate::Error;
use crate::build::{build_library, library_dir};
use crate::runner::Runner;
use crate::timing::quantile;

/// An implementation and its process.
pub struct Implementation {
    /// Its process.
    pub runner: Runner,
    /// What it says of itself.
    pub about: String,
}

/// The values that an implementation gave, frame by frame, by name; or why there are none.
pub type Rounds = Vec<Result<HashMap<String, Vec<f64>>, String>>;

fn library() -> Result<String, Error> {
    if let Ok(path) = std::env::var("TEPUI_LIBRARY") {
        return Ok(std::fs::canonicalize(path)?.display().to_string());
    }
    build_library()?;
    Ok(library_dir().join("libOSMesa.so").display().to_string())
}

/// Renderers that are programs and not hardware.
fn is_software(about: &str) -> bool {
    ["llvmpipe", "softpipe", "swrast", "Software Rasterizer"].iter().any(|name| about.contains(name))
}

/// The implementations that can be asked here; those that cannot are named.
pub fn implementations(options: &Options, output: &Path, cases: &[Case]) -> Result<Vec<Implementation>, Error> {
    if !cases.iter().any(|c| matches!(c, Case::Against | Case::Draws)) {
        return Ok(Vec::new());
    }
    std::fs::create_dir_all(output)?;
    let program = std::env::current_exe()?;
    let tepui = library()?;
    let client = |label: &'static str, library: Option<&str>, environment: &[(&str, &str)]| {
        let library = library.map(|l| vec!["--library".to_owned(), l.to_owned()]).unwrap_or_default();
        let log = output.join(format!("raster-{label}.log"));
        Runner::new(label, &program, environment, log).called_with([vec!["raster-client".to_owned()], library].concat())
    };
    let mut runners = Vec::new();
    if !options.without_reference {
        runners.push(client("osmesa", Some("libOSMesa.so.8"), crate::compare::REFERENCE));
    }
    runners.push(client("cpu", Some(&tepui), &[("TEPUI_DEVICE", "cpu")]));
    runners.push(client("gpu", Some(&tepui), &[("TEPUI_DEVICE", "gpu")]));
    runners.push(client("egl", None, &[]));
    let mut there = Vec::new();
    for mut runner in runners {
        match runner.request("about").map(|lines| lines.join(" ")) {
            Err(why) => println!("LEFT OUT: {}: {why}", runner.label),
            Ok(about) if runner.label == "egl" && is_software(&about) && !options.software_egl => {
                println!("LEFT OUT: egl: {about} is no hardware");
            }
            Ok(about) => there.push(Implementation { runner, about }),
        }
    }
    Ok(there)
}

/// Opens a scene everywhere, draws frames in turn and closes it; what each frame's answer says, but for the first `warm_up` frames.
pub fn rounds(implementations: &mut [Implementation], scene: &str, warm_up: usize, frames: usize) -> Rounds {
    let open = |i: &mut Implementation| i.runner.request(&format!("open {scene}")).map(|_| HashMap::new());
    let mut rounds: Rounds = implementations.iter_mut().map(open).collect();
    for round in 0..warm_up + frames {
        for (implementation, values) in implementations.iter_mut().zip(&mut rounds) {
            let Ok(kept) = values else { continue };
            match implementation.runner.request("frame") {
                Err(why) => *values = Err(why),
                Ok(_) if round < warm_up => {}
                Ok(lines) => {
                    for (name, value) in lines.iter().filter_map(|l| l.split_once(' ')) {
                        kept.entry(name.to_owned()).or_insert_with(Vec::new).extend(value.parse::<f64>());
                    }
                }
            }
        }
    }
    rounds
}

/// The median of a value.
pub fn median(values: &HashMap<String, Vec<f64>>, name: &str) -> Option<f64> {
    let mut values = values.get(name).filter(|v| !v.is_empty())?.clone();
    Some(quantile(&mut values, 0.5))
}

/// Median of the ratios of frames drawn side by side.
fn ratio(of: &HashMap<String, Vec<f64>>, to: &HashMap<String, Vec<f64>>) -> Option<f64> {
    let mut ratios: Vec<f64> = of.get("ms")?.iter().zip(to.get("ms")?).map(|(a, b)| a / b).collect();
    (!ratios.is_empty()).then(|| quantile(&mut ratios, 0.5))
}

/// The pictures of an open scene.
fn pictures(implementations: &mut [Implementation]) -> Vec<Option<Vec<u32>>> {
    let file = std::env::temp_dir().join(format!("tepui-raster-{}.rgba", std::process::id()));
    let picture = |i: &mut Implementation| {
        i.runner.request(&format!("pixels {}", file.display())).ok()?;
        let bytes = std::fs::read(&file).ok()?;
        Some(bytemuck::pod_collect_to_vec(&bytes))
    };
    let pictures = implementations.iter_mut().map(picture).collect();
    let _ = std::fs::remove_file(&file);
    pictures
}

/// Pixels that one alone covers, greatest difference of a component.
fn difference(a: &[u32], b: &[u32]) -> [u32; 2] {
    let coverage = a.iter().zip(b).filter(|(a, b)| (**a == 0) != (**b == 0)).count() as u32;
    let component = |(a, b): (&u32, &u32)| a.to_le_bytes().iter().zip(b.to_le_bytes()).map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0);
    [coverage, a.iter().zip(b).map(component).max().unwrap_or(0) as u32]
}

/// The most that the ratio to OSMesa may be, on a machine without a GPU.
fn most(implementation: &str, scene: &str) -> Option<f64> {
    match implementation {
        "cpu" if !matches!(scene, "S1" | "S4") => Some(0.6),
        "gpu" => Some(3.0),
        _ => None,
    }
}

/// What is drawn: the scenes S at the sizes that were asked for (on a software renderer the smallest of them), T1 to T6 at 1024 x 1024.
fn drawn(options: &Options, hardware: bool) -> Vec<(String, [u32; 2])> {
    let sizes: Vec<_> = sizes(options).into_iter().take(if hardware { 3 } else { 1 }).collect();
    let s = sizes.iter().flat_map(|size| options.scenes.iter().map(|id| (format!("S{id}"), *size)));
    s.chain((1..=6).map(|id| (format!("T{id}"), [1024; 2]))).collect()
}

/// Measures.
pub fn run(options: &Options, benches: &[Bench], implementations: &mut [Implementation]) -> Result<Section, String> {
    let hardware = benches.iter().any(Bench::is_hardware);
    let mut section = Section::new(
        "against",
        "The same calls on other implementations",
        "Whole frames by the clock, clear to glFinish, through each implementation's own OpenGL: client arrays on OSMesa's interface, buffer objects on EGL, where the time \
         on the device is a timer query's. Frames are drawn in turn; the ratio is the median of those of neighbouring frames. Differences are to the first one's \
         picture. T1 to T6 are the scenes of the study of CPU rasterizers, rebuilt. More than one sample a pixel is a multisampled framebuffer object, the resolve included.",
    );
    let heads = ["scene", "size", "samples", "on", "ms", "on device", "by the first", "coverage", "colour"];
    let mut table = Table::new("", &heads);
    let mut plot = Plot::new("Ratio to the first implementation", "its ms a frame", "ratio");
    progress(&table.heads);
    let (warm_up, frames) = if hardware { (3, options.frames) } else { (2, options.frames.min(11)) };
    let scenes = drawn(options, hardware);
    for ((name, size), samples) in scenes.iter().flat_map(|s| options.samples.iter().map(move |n| (s, *n))) {
        Scene::named(name, *size)?;
        let rounds = rounds(implementations, &format!("{name} {} {} {samples}", size[0], size[1]), warm_up, frames);
        let pictures = pictures(implementations);
        for (k, (implementation, values)) in implementations.iter().zip(&rounds).enumerate() {
            let label = implementation.runner.label;
            let names = [name.clone(), format!("{}x{}", size[0], size[1]), samples.to_string(), label.to_owned()];
            let values = match values {
                Ok(values) => values,
                Err(why) => {
                    section.leave_out(format!("{}: {why}", names.join(" ")));
                    continue;
                }
            };
            let number = |v: Option<f64>, digits: usize| v.map_or("-".to_owned(), |v| format!("{v:.digits$}"));
            let first = rounds[0].as_ref().ok().filter(|_| k > 0);
            let ratio = first.and_then(|f| ratio(values, f));
            let differs = pictures[0].as_ref().zip(pictures[k].as_ref()).filter(|_| k > 0).map(|(a, b)| difference(a, b));
            let numbers = [number(median(values, "ms"), 3), number(median(values, "device-ms"), 3), number(ratio, 2)];
            let differences = differs.map_or(["-".into(), "-".into()], |d| d.map(|n| n.to_string()));
            let row = [&names[..], &numbers, &differences].concat();
            progress(&row);
            table.rows.push(row);
            if let (Some(ratio), Some(ms)) = (ratio, first.and_then(|f| median(f, "ms"))) {
                plot.point(&format!("{name}, {label}"), ms, ratio);
                if let Some(most) = most(label, name).filter(|_| !hardware && implementations[0].runner.label == "osmesa") {
                    section.limit(format!("{name} at {}x{}, {samples} samples, {label} by OSMesa", size[0], size[1]), ratio, most);
                }
            }
        }
        for implementation in implementations.iter_mut() {
            let _ = implementation.runner.request("close");
        }
    }
    section.plots = vec![by_implementation(&plot)];
    section.tables.push(table);
    Ok(section)
}

/// One curve an implementation instead of one a scene: the ratio over the scene's time.
fn by_implementation(plot: &Plot) -> Plot {
    let mut out = Plot::new(&plot.title, &plot.x, &plot.y);
    let mut points: Vec<(&str, f64, f64)> = Vec::new();
    for curve in &plot.curves {
        let label = curve.name.rsplit(", ").next().unwrap_or_default();
        points.extend(curve.points.iter().map(|p| (label, p.0, p.1)));
    }
    points.sort_by(|a, b| a.1.total_cmp(&b.1));
    points.into_iter().for_each(|(label, x, y)| out.point(label, x, y));
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn software_renderers_are_known_by_name() {
        assert!(is_software("Mesa/X.org | llvmpipe (LLVM 15.0.6, 256 bits) | 4.5"));
        assert!(!is_software("NVIDIA Corporation | NVIDIA H200/PCIe/SSE2 | 4.6.0"));
    }

    #[test]
    fn differences_are_counted_by_coverage_and_component() {
        assert_eq!(difference(&[0, 0x01020304, 5], &[7, 0x01090304, 5]), [1, 7]);
        assert_eq!(difference(&[1, 2], &[1, 2]), [0, 0]);
    }
}
