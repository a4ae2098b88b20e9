//! Scenes S1 to S6: time of the whole frame and by stage, memory, the floor and the picture.

use super::batch::batch;
use super::bench::{Bench, Measure, difference, reference};
use super::scenes::Scene;
use super::section::{Section, Table, progress};
use super::{Options, sizes};

/// Bytes a millisecond that device memory of the baseline's GPU moves (gpu-baseline, section 6): the floor is made of it.
const BYTES_A_MS: f64 = 4.23e9;

/// Most milliseconds on that GPU at 1920 x 1080, scene by scene.
const MOST: [f64; 6] = [0.60, 0.50, 0.38, 0.65, 0.38, 0.45];
/// CUDARaster there at 3840 x 2160 (S4: with depth).
const CUDARASTER_2160: [f64; 6] = [8.286, 2.760, 0.998, 2.167, 1.555, 2.413];

/// 20 bytes a vertex, 12 a triangle.
pub fn input_bytes(scene: &Scene) -> f64 {
    20.0 * scene.positions.len() as f64 + 12.0 * scene.triangles() as f64
}

/// The least time that the baseline's memory allows: the input once, and 4 bytes a pixel.
pub fn floor(scene: &Scene) -> f64 {
    (input_bytes(scene) + 4.0 * scene.size[0] as f64 * scene.size[1] as f64) / BYTES_A_MS
}

/// Most bytes between the input and the pixels, by the input's.
const MEMORY_BY_INPUT: f64 = 2.0;

/// Whether a scene is drawn in its time, in memory too where that was bounded.
fn limits(section: &mut Section, scene: &Scene, id: u32, m: &Measure, bounded: bool) {
    let k = id as usize - 1;
    let [width, height] = scene.size;
    let within = if bounded { ", memory bounded" } else { "" };
    match height {
        1080 => section.limit(format!("S{id} at 1920x1080{within}, ms"), m.ms[1], MOST[k]),
        2160 => section.limit(format!("S{id} at 3840x2160 against CUDARaster{within}, ms"), m.ms[1], CUDARASTER_2160[k]),
        _ => {}
    }
    if bounded {
        let ratio = m.intermediate() as f64 / input_bytes(scene);
        section.limit(format!("S{id} at {width}x{height}{within}: intermediate memory by input"), ratio, MEMORY_BY_INPUT);
    }
}

fn check(section: &mut Section, measure: &Measure, scene: &Scene, id: u32) -> Result<(), String> {
    let Some(pixels) = &measure.pixels else { return Ok(()) };
    let [coverage, _, color, depth] = difference(&reference(&batch(scene)?, scene.size)?, pixels);
    if coverage > 0 || color > 1 || depth > 1 {
        section.wrong(format!(
            "S{id} at {}x{} against the CPU executor: {coverage} pixels of coverage, colour by up to {color}, depth by up to {depth}",
            scene.size[0], scene.size[1]
        ));
    }
    Ok(())
}

fn stage_row(first: &[String], m: &Measure) -> Vec<String> {
    let text = m.stages.iter().map(|(name, ms)| format!("{name} {ms:.3}")).collect::<Vec<_>>().join(", ");
    [first, &[text]].concat()
}

fn memory_row(first: &[String], scene: &Scene, m: &Measure) -> Vec<String> {
    let mib = |bytes: u64| bytes as f64 / (1 << 20) as f64;
    let ratio = m.intermediate() as f64 / input_bytes(scene);
    let large = m.memory.iter().filter(|(_, bytes)| bytes * 20 >= m.intermediate());
    let detail = large.map(|(name, bytes)| format!("{name} {:.3}", mib(*bytes))).collect::<Vec<_>>();
    let numbers = [mib(input_bytes(scene) as u64), mib(m.total()), mib(m.intermediate())].map(|v| format!("{v:.3}"));
    [first, &numbers, &[format!("{ratio:.2}"), detail.join(", ")]].concat()
}

/// Measures.
pub fn run(options: &Options, benches: &[Bench]) -> Result<Section, String> {
    let mut section = Section::new(
        "frames",
        "Scenes S1 to S6",
        "Milliseconds of the whole frame, clear to last pixel, vertices resident: on the kernels by time stamps on the device, on the CPU by the clock. \
         The scenes are the published ones bit for bit, proven by their hashes. The floor is 20 bytes a vertex, 12 a triangle and 4 a pixel at 4.23 TB/s, \
         which is what an H200's memory moves; on another device it is a unit and no more. With memory bounded, TEPUI_GPU_BUDGET is twice the input.",
    );
    let first = ["scene", "size", "samples", "on"];
    let mut times = Table::new("Time", &[&first[..], &["least", "median", "greatest", "Mtri/s", "floor", "by floor", "hash"]].concat());
    let mut stages = Table::new("Time by stage, ms", &[&first[..], &["stages"]].concat());
    let heads = ["input MiB", "all buffers", "intermediate", "intermediate by input", "largest buffers"];
    let mut memory = Table::new("Memory on the device, MiB", &[&first[..], &heads].concat());
    progress(&times.heads);
    for size in sizes(options) {
        for &id in &options.scenes {
            let scene = Scene::new(id, size)?;
            let batch = batch(&scene)?;
            let all = benches.iter().flat_map(|b| options.samples.iter().map(move |s| (b, s)));
            let ways = all.flat_map(|(b, &s)| [false, true].map(|bounded| (b, s, bounded)));
            for (bench, samples, bounded) in ways.filter(|(bench, samples, bounded)| !bounded || bench.is_hardware() && *samples == 1) {
                let on = if bounded { format!("{}, bounded", bench.short()) } else { bench.short().to_owned() };
                let names = [format!("S{id}"), format!("{}x{}", size[0], size[1]), samples.to_string(), on];
                let budget = bounded.then_some((input_bytes(&scene) * MEMORY_BY_INPUT) as u64);
                let m = match bench.measure(&batch, size, samples, options.frames, budget) {
                    Ok(m) => m,
                    Err(why) => {
                        section.leave_out(format!("{}: {why}", names.join(" ")));
                        continue;
                    }
                };
                let floor = floor(&scene);
                let rate = scene.triangles() as f64 / m.ms[1] / 1e3;
                let numbers = [m.ms.map(|v| format!("{v:.3}")).to_vec(), vec![format!("{rate:.0}"), format!("{floor:.4}")]].concat();
                let row = [&names[..], &numbers, &[format!("{:.1}", m.ms[1] / floor), format!("{:016x}", scene.hash())]].concat();
                progress(&row);
                times.rows.push(row);
                if !m.memory.is_empty() {
                    stages.rows.push(stage_row(&names, &m));
                    memory.rows.push(memory_row(&names, &scene, &m));
                }
                if bench.is_hardware() && samples == 1 {
                    limits(&mut section, &scene, id, &m, bounded);
                }
                if bench.is_hardware() && (id, size[1]) == (3, 1080) && matches!(samples, 4 | 8) {
                    section.limit(format!("S3 with {samples} samples, ms"), m.ms[1], if samples == 4 { 0.75 } else { 1.1 });
                }
                if options.check && samples == 1 {
                    check(&mut section, &m, &scene, id)?;
                }
            }
        }
    }
    section.tables = vec![times, stages, memory];
    Ok(section)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::scenes::SIZES;

    #[test]
    fn the_floor_is_the_published_one() {
        for (id, size, published) in [(3, SIZES[0], 0.0024), (3, SIZES[1], 0.0037), (4, SIZES[2], 0.0078), (5, SIZES[1], 0.0105)] {
            let scene = Scene::new(id, size).expect("a scene");
            assert!((floor(&scene) - published).abs() < 0.00006, "S{id}: {}", floor(&scene));
        }
    }
}
