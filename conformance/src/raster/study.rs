//! The study of CPU rasterizers: its scenes T1 to T6, and S2, S3 and S5, on the shipped executor and on the ways that it was chosen from.

use std::time::Instant;

use tepui::device::cpu::CpuDevice;
use tepui::device::{Device, Surface};
use tepui::draw::Batch;
use tepui::raster::simd::Level;
use tepui::raster::study::{Layout, Method, Sort, Study, Way};

use super::Options;
use super::bench::{format, least_median_greatest};
use super::capture::batches;
use super::scenes::Scene;
use super::section::{Plot, Section, Table, progress};

const SIZE: [u32; 2] = [1024, 1024];
const SCENES: [&str; 9] = ["T1", "T2", "T3", "T4", "T5", "T6", "S2", "S3", "S5"];

/// What is measured: a name, a way, and what it is compared for.
fn ways() -> Vec<(&'static str, Way)> {
    let way = |name, method, layout, sort| (name, Way { method, layout, sort });
    use Layout::{Linear, Tiled};
    use Method::{Blocked, BySize, Combined, HalfSpace, Scanline};
    vec![
        way("half-space", HalfSpace, Linear, Sort::None),
        way("blocks of 4", Blocked(4), Linear, Sort::None),
        way("blocks of 8", Blocked(8), Linear, Sort::None),
        way("blocks of 16", Blocked(16), Linear, Sort::None),
        way("blocks of 32", Blocked(32), Linear, Sort::None),
        way("combined", Combined, Linear, Sort::None),
        way("by size", BySize, Linear, Sort::None),
        way("scan-line", Scanline, Linear, Sort::None),
        way("blocks of 8, tiled", Blocked(8), Tiled, Sort::None),
        way("scan-line, tiled", Scanline, Tiled, Sort::None),
        way("blocks of 8, bins", Blocked(8), Linear, Sort::Middle),
        way("blocks of 8, bins, tiled", Blocked(8), Tiled, Sort::Middle),
        way("half-space, bins, tiled", HalfSpace, Tiled, Sort::Middle),
        way("by size, bins, tiled", BySize, Tiled, Sort::Middle),
        way("scan-line, bins, tiled", Scanline, Tiled, Sort::Middle),
        way("blocks of 8, locks", Blocked(8), Linear, Sort::Last),
        way("blocks of 8, locks, tiled", Blocked(8), Tiled, Sort::Last),
        way("scan-line, locks, tiled", Scanline, Tiled, Sort::Last),
    ]
}

/// Ways measured on more than one thread: those that part.
fn threads_of(way: &Way, most: usize) -> Vec<usize> {
    if way.sort == Sort::None {
        return vec![1];
    }
    let mut threads: Vec<usize> = std::iter::successors(Some(1), |n| Some(n * 2)).take_while(|n| *n < most).collect();
    threads.push(most);
    threads
}

/// The scene as the GL state machine records it, without texture: the study has none.
fn untextured(name: &str) -> Result<Batch, String> {
    let mut scene = Scene::named(name, SIZE)?;
    scene.coordinates.clear();
    let mut batches = batches(&scene);
    match batches.pop() {
        Some(batch) if batches.is_empty() => Ok(batch),
        // The recorder has cut it at its budget: the batch that is made by hand is whole.
        _ => super::batch::batch(&scene),
    }
}

enum Runner {
    Shipped(Box<dyn Surface>),
    Way(Box<Study>, Way),
}

impl Runner {
    fn frame(&mut self, batch: &Batch) -> Result<f64, String> {
        let copy = if let Runner::Shipped(_) = self { batch.clone() } else { Batch::default() };
        let start = Instant::now();
        match self {
            Runner::Shipped(surface) => surface.execute(copy),
            Runner::Way(study, way) => study.frame(batch, *way)?,
        }
        Ok(start.elapsed().as_secs_f64() * 1e3)
    }

    fn covered(&mut self) -> Vec<bool> {
        match self {
            Runner::Shipped(surface) => surface.pixels().color.iter().map(|c| *c != 0).collect(),
            Runner::Way(study, _) => study.pixels()[0].iter().map(|c| *c != 0).collect(),
        }
    }
}

/// All that is measured of a scene: name, threads, runner; the shipped executor first.
fn runners(most: usize) -> Result<Vec<(&'static str, usize, Runner)>, String> {
    let mut runners = Vec::new();
    for threads in threads_of(&Way { method: Method::Scanline, layout: Layout::Tiled, sort: Sort::Middle }, most) {
        let surface = CpuDevice::with(threads, Level::best()).surface(SIZE[0], SIZE[1], format(1)?);
        runners.push(("shipped", threads, Runner::Shipped(surface)));
    }
    for (name, way) in ways() {
        for threads in threads_of(&way, most) {
            let study = Study::new(threads, Level::best(), SIZE, way)?;
            runners.push((name, threads, Runner::Way(Box::new(study), way)));
        }
    }
    Ok(runners)
}

/// Measures.
pub fn run(options: &Options) -> Result<Section, String> {
    let most = std::thread::available_parallelism().map_or(1, usize::from);
    let mut section = Section::new(
        "study",
        "Ways to rasterize on the CPU",
        "Milliseconds of a frame at 1024x1024, from vertices in memory to the last pixel, clear included, all ways in turn frame by frame. The scenes are those of the study of CPU \
         rasterizers, rebuilt, without their textures, and S2, S3 and S5. All ways share the shipped vertex and set-up stages and the arithmetic of pixels (eight at once with AVX2); \
         coverage is compared with the shipped executor's. No sort: one thread, one triangle after the other. Bins: sort-middle, lists of 64x64 bins. Locks: sort-last, \
         a lock for eight pixels. By size: half-space for bounding rectangles up to 16 pixels, else blocks. Combined: rows of eight in full blocks, pixels one by one in others.",
    );
    let heads: Vec<&str> = ["way", "threads"].into_iter().chain(SCENES).collect();
    let mut table = Table::new("Milliseconds a frame, median", &heads);
    let mut best = Table::new("What wins", &["scene", "on one thread", "ms", "shipped by it", "on all threads", "ms", "shipped by it"]);
    let mut plot = Plot::new("Threads, geometric mean over the scenes", "threads", "ms a frame");
    let mut all: Vec<Vec<f64>> = Vec::new();
    let mut names: Vec<(&'static str, usize)> = Vec::new();
    for scene in SCENES {
        let batch = untextured(scene)?;
        let mut runners = runners(most)?;
        let mut times = vec![Vec::new(); runners.len()];
        for round in 0..=options.frames.min(15) {
            for ((_, _, runner), times) in runners.iter_mut().zip(&mut times) {
                let ms = runner.frame(&batch)?;
                times.extend((round > 0).then_some(ms));
            }
        }
        let expected = runners[0].2.covered();
        for (name, threads, runner) in &mut runners {
            let wrong = runner.covered().iter().zip(&expected).filter(|(a, b)| a != b).count();
            if wrong > 0 {
                section.wrong(format!("{scene}, {name} on {threads} threads: {wrong} pixels of coverage"));
            }
        }
        let medians: Vec<f64> = times.into_iter().map(|t| least_median_greatest(t)[1]).collect();
        names = runners.iter().map(|r| (r.0, r.1)).collect();
        let row = winners(scene, &names, &medians, most);
        progress(&row);
        best.rows.push(row);
        all.push(medians);
    }
    for (k, (name, threads)) in names.iter().enumerate() {
        let column: Vec<f64> = all.iter().map(|m| m[k]).collect();
        let mean = (column.iter().map(|v| v.ln()).sum::<f64>() / column.len() as f64).exp();
        plot.point(name, *threads as f64, mean);
        let row = [(*name).to_owned(), threads.to_string()].into_iter().chain(column.iter().map(|v| format!("{v:.2}"))).collect();
        table.rows.push(row);
    }
    plot.curves.retain(|c| c.points.len() > 1);
    section.plots = vec![by_scene(&names, &all), plot];
    section.tables = vec![best, table];
    Ok(section)
}

/// The fastest way but the shipped one on one thread and on all, and the shipped executor's time by its.
fn winners(scene: &str, names: &[(&'static str, usize)], medians: &[f64], most: usize) -> Vec<String> {
    let mut row = vec![scene.to_owned()];
    for threads in [1, most] {
        let of = |shipped: bool| {
            let those = names.iter().zip(medians).filter(move |((n, t), _)| *t == threads && (*n == "shipped") == shipped);
            those.min_by(|a, b| a.1.total_cmp(b.1))
        };
        if let (Some((_, shipped)), Some(((name, _), ms))) = (of(true), of(false)) {
            row.extend([(*name).to_owned(), format!("{ms:.2}"), format!("{:.2}", shipped / ms)]);
        }
    }
    row
}

/// Each way on one thread against the shipped executor on one thread, scene by scene in the order of [`SCENES`].
fn by_scene(names: &[(&'static str, usize)], all: &[Vec<f64>]) -> Plot {
    let x = format!("scene: {}", SCENES.iter().enumerate().map(|(k, s)| format!("{} {s}", k + 1)).collect::<Vec<_>>().join(", "));
    let mut plot = Plot::new("One thread: time by the shipped executor's", &x, "ratio");
    let shown = [
        "half-space",
        "blocks of 4",
        "blocks of 8",
        "blocks of 16",
        "by size",
        "scan-line",
        "blocks of 8, tiled",
        "blocks of 8, bins, tiled",
        "blocks of 8, locks, tiled",
    ];
    for (k, medians) in all.iter().enumerate() {
        for ((name, threads), ms) in names.iter().zip(medians) {
            if *threads == 1 && shown.contains(name) {
                plot.point(name, (k + 1) as f64, ms / medians[0]);
            }
        }
    }
    plot
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_scene_is_covered_alike_by_every_way() {
        for scene in ["T1", "T3", "T5"] {
            let batch = untextured(scene).expect("a batch");
            let mut runners = runners(2).expect("threads");
            let covered: Vec<Vec<bool>> = (runners.iter_mut())
                .map(|(_, _, runner)| {
                    runner.frame(&batch).expect("a frame");
                    runner.covered()
                })
                .collect();
            assert!(covered[0].iter().filter(|c| **c).count() > 100_000, "{scene} is on the screen");
            for (k, c) in covered.iter().enumerate() {
                assert!(*c == covered[0], "{scene}, {} on {} threads", runners[k].0, runners[k].1);
            }
        }
    }

    #[test]
    fn the_winner_is_the_least_and_not_the_shipped_one() {
        let names = [("shipped", 1), ("a", 1), ("b", 1), ("shipped", 2), ("a", 2)];
        let row = winners("T1", &names, &[1.0, 4.0, 2.0, 3.0, 1.5], 2);
        assert_eq!(row, ["T1", "b", "2.00", "0.50", "a", "1.50", "2.00"]);
    }
}
