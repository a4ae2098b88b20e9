//! The same triangles in more and more draws: time on the device of the batches that the GL state machine makes of them, and the
//! processor's time for a call.

use super::Options;
use super::against::{Implementation, median, rounds};
use super::bench::{Bench, Measure};
use super::capture::batches;
use super::client::calls;
use super::named::DRAWN;
use super::scenes::{Change, SIZES, Scene};
use super::section::{Plot, Section, Table, progress};

/// Numbers of draws.
const DRAWS: [u32; 5] = [1, 10, 100, 1000, 10_000];
/// Most milliseconds on the device, most microseconds a call, for 10,000 draws with a change each.
const MOST: [f64; 2] = [3.0, 0.3];

fn on_device(bench: &Bench, scene: &Scene, frames: usize) -> Result<Measure, String> {
    match &batches(scene)[..] {
        [batch] => bench.measure(batch, scene.size, 1, frames, None),
        more => {
            let ms = bench.frames_of(more, scene.size, frames)?;
            Ok(Measure { ms, stages: Vec::new(), memory: Vec::new(), pixels: None })
        }
    }
}

/// Measures.
pub fn run(options: &Options, benches: &[Bench], implementations: &mut [Implementation]) -> Result<Section, String> {
    let hardware = benches.iter().any(Bench::is_hardware);
    let mut section = Section::new(
        "draws",
        "Draw calls",
        &format!(
            "{DRAWN} triangles of 10 pixels at 1024x768 in more and more draws, without a change of state between them, with a tint each (glLightModelfv) and with blending \
             switched each time. First: the batches that the GL state machine makes of the calls, by time stamps on the device (the CPU executor by the clock). Second: the \
             calls through each implementation's own library, after three frames: processor time a call while they are recorded (the copy of client arrays included), and \
             the whole frame to glFinish."
        ),
    );
    let mut device = Table::new("On the device", &["draws", "change", "on", "least", "median", "greatest"]);
    let mut host = Table::new("Through the library", &["draws", "change", "on", "us a call", "ms a frame", "ms on device"]);
    let mut device_plot = Plot::new("Time on the device", "draws", "ms a frame");
    let mut host_plot = Plot::new("Processor time of a call", "draws", "us a call");
    for (change, name) in [(Change::None, "none"), (Change::Tint, "tint"), (Change::Blend, "blend")] {
        // A software Vulkan driver needs a second a frame.
        for draws in DRAWS.into_iter().filter(|n| hardware || matches!(n, 1 | 100 | 10_000)) {
            let scene = Scene::many_draws(draws, change, SIZES[0])?;
            let limited = draws == 10_000 && change != Change::None;
            for bench in benches {
                match on_device(bench, &scene, options.frames) {
                    Ok(m) => {
                        let row = [draws.to_string(), name.into(), bench.short().into()];
                        let row = [&row[..], &m.ms.map(|v| format!("{v:.3}"))].concat();
                        progress(&row);
                        device.rows.push(row);
                        device_plot.point(&format!("{name}, {}", bench.short()), draws as f64, m.ms[1]);
                        if limited && bench.is_hardware() {
                            section.limit(format!("{draws} draws, {name}: ms on the device"), m.ms[1], MOST[0]);
                        }
                    }
                    Err(why) => section.leave_out(format!("{draws} draws, {name}, on {}: {why}", bench.short())),
                }
            }
            let frames = options.frames.min(if hardware { 31 } else { 7 });
            let values = rounds(implementations, &format!("draws/{draws}/{name} 1024 768 1"), 3, frames);
            for (implementation, values) in implementations.iter_mut().zip(values) {
                let label = implementation.runner.label;
                let _ = implementation.runner.request("close");
                match values {
                    Ok(values) => {
                        let microseconds = median(&values, "call-ns").map(|ns| ns * 1e-3);
                        let number = |v: Option<f64>| v.map_or("-".to_owned(), |v| format!("{v:.3}"));
                        let row = [draws.to_string(), name.into(), label.into()];
                        let numbers = [microseconds, median(&values, "ms"), median(&values, "device-ms")].map(number);
                        let row = [&row[..], &numbers].concat();
                        progress(&row);
                        host.rows.push(row);
                        host_plot.point(&format!("{name}, {label}"), draws as f64, microseconds.unwrap_or(0.0));
                        if limited && label == if hardware { "gpu" } else { "cpu" } {
                            let what = format!("{} calls, {name}, {label}: us of processor time a call", calls(&scene));
                            section.limit(what, microseconds.unwrap_or(f64::NAN), MOST[1]);
                        }
                    }
                    Err(why) => section.leave_out(format!("{draws} draws, {name}, through {label}: {why}")),
                }
            }
        }
    }
    section.tables = vec![device, host];
    section.plots = vec![device_plot, host_plot];
    Ok(section)
}
