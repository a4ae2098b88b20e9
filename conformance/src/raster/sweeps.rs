//! Sweeps: the size of triangles, what is done with a fragment, the size of batches, and a frame of very many triangles.

use tepui::draw::Batch;

use super::Options;
use super::batch::batch;
use super::bench::Bench;
use super::frames::input_bytes;
use super::scenes::{SIZES, Scene};
use super::section::{Plot, Section, Table, progress};

/// Areas of figure 5, in pixels.
const AREAS: [f64; 17] =
    [0.5, 1.0, 2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 128.0, 256.0, 512.0, 1024.0, 4096.0, 16384.0, 65536.0, 131072.0, 262144.0];

/// Triangles of an area: many small ones, few large ones.
fn how_many(area: f64, hardware: bool) -> u32 {
    let (pixels, most) = if hardware { (512e6, 2e6) } else { (4e6, 50e3) };
    (pixels / area).clamp(32.0, most) as u32
}

/// CUDARaster's figure 5.
pub fn areas(options: &Options, benches: &[Bench]) -> Result<Section, String> {
    let mut section = Section::new(
        "areas",
        "The size of triangles",
        "Nanoseconds a triangle, by its area in pixels (CUDARaster, figure 5): equal triangles in screen-sized layers at 1024x768, flat, without multisampling, \
         depth test or blending. Seeds 0x5EED1000 + area.",
    );
    let mut table = Table::new("", &["area", "triangles", "on", "ms", "ns/triangle", "Gpix/s"]);
    let mut plot = Plot::new("Time a triangle", "area of a triangle, pixels", "ns a triangle");
    progress(&table.heads);
    for area in AREAS {
        for bench in benches {
            let triangles = how_many(area, bench.is_hardware());
            let scene = Scene::layers(area, triangles, SIZES[0]);
            match bench.measure(&batch(&scene)?, SIZES[0], 1, options.frames, None) {
                Ok(m) => {
                    let ns = m.ms[1] * 1e6 / triangles as f64;
                    plot.point(bench.short(), area, ns);
                    let row = [area.to_string(), triangles.to_string(), bench.short().into()];
                    let row = [&row[..], &[format!("{:.3}", m.ms[1]), format!("{ns:.3}"), format!("{:.2}", area / ns)]].concat();
                    progress(&row);
                    table.rows.push(row);
                }
                Err(why) => section.leave_out(format!("{area} pixels on {}: {why}", bench.short())),
            }
        }
    }
    (section.tables, section.plots) = (vec![table], vec![plot]);
    Ok(section)
}

/// CUDARaster's table 2, on S1 (many small triangles) and S3 (larger ones) at 1024 x 768.
pub fn modes(options: &Options, benches: &[Bench]) -> Result<Section, String> {
    let mut section = Section::new(
        "modes",
        "Rendering and antialiasing modes",
        "Milliseconds of a frame at 1024x768 by what is done with a fragment and by samples (CUDARaster, table 2; there the scenes were SAN MIGUEL and JUAREZ, \
         here S1 and S3).",
    );
    let mut table = Table::new("", &["scene", "mode", "samples", "on", "least", "median", "greatest"]);
    progress(&table.heads);
    for (id, mode) in [1, 3].iter().flat_map(|id| ["depth", "blend", "depth-only"].map(|m| (id, m))) {
        let scene = Scene::named(&format!("S{id}+{mode}"), SIZES[0])?;
        let batch = batch(&scene)?;
        for (bench, samples) in benches.iter().flat_map(|b| [1, 2, 4, 8].map(|s| (b, s))) {
            match bench.measure(&batch, SIZES[0], samples, options.frames, None) {
                Ok(m) => {
                    let row = [format!("S{id}"), mode.to_owned(), samples.to_string(), bench.short().to_owned()];
                    let row = [&row[..], &m.ms.map(|v| format!("{v:.3}"))].concat();
                    progress(&row);
                    table.rows.push(row);
                }
                Err(why) => section.leave_out(format!("S{id} {mode} with {samples} samples on {}: {why}", bench.short())),
            }
        }
    }
    section.tables.push(table);
    Ok(section)
}

/// A scene cut into so many batches of equally many triangles; only the first one clears.
fn cut(scene: &Scene, parts: u32) -> Result<Vec<Batch>, String> {
    let each = (scene.triangles().div_ceil(parts) * 3) as usize;
    let mut batches = Vec::new();
    for (k, indices) in scene.indices.chunks(each).enumerate() {
        let (first, last) = indices.iter().fold((u32::MAX, 0), |(l, h), i| (l.min(*i), h.max(*i)));
        let range = first as usize..last as usize + 1;
        let mut part = Scene::empty(scene.size);
        (part.mode, part.cull) = (scene.mode, scene.cull);
        part.positions = scene.positions[range.clone()].to_vec();
        part.colors = scene.colors[range].to_vec();
        part.indices = indices.iter().map(|i| i - first).collect();
        let mut batch = batch(&part)?;
        if k > 0 {
            batch.steps.remove(0);
        }
        batches.push(batch);
    }
    Ok(batches)
}

/// The same scene in more and more batches (CUDARaster, figure 6).
pub fn batches(options: &Options, benches: &[Bench]) -> Result<Section, String> {
    let mut section = Section::new(
        "batches",
        "The size of batches",
        "S1, S3 and S5 at 1024x768 cut into equal batches (CUDARaster, figure 6). On a device each batch is measured on its own by time stamps and the times are added, \
         so what the host needs between two batches is not in it.",
    );
    let mut table = Table::new("", &["scene", "batches", "triangles each", "on", "ms", "by one batch"]);
    let mut plot = Plot::new("The same frame in more batches", "batches", "ms a frame");
    progress(&table.heads);
    for id in [1, 3, 5] {
        let scene = Scene::new(id, SIZES[0])?;
        for bench in benches {
            let mut one = f64::NAN;
            for parts in [1, 4, 16, 64] {
                match bench.frames_of(&cut(&scene, parts)?, SIZES[0], options.frames.min(7)) {
                    Ok(ms) => {
                        if parts == 1 {
                            one = ms[1];
                        }
                        plot.point(&format!("S{id}, {}", bench.short()), parts as f64, ms[1]);
                        let row = [format!("S{id}"), parts.to_string(), scene.triangles().div_ceil(parts).to_string()];
                        let row = [&row[..], &[bench.short().into(), format!("{:.3}", ms[1]), format!("{:.2}", ms[1] / one)]].concat();
                        progress(&row);
                        table.rows.push(row);
                    }
                    Err(why) => section.leave_out(format!("S{id} in {parts} batches on {}: {why}", bench.short())),
                }
            }
        }
    }
    (section.tables, section.plots) = (vec![table], vec![plot]);
    Ok(section)
}

/// S1 to S6 with less and less memory between the input and the pixels.
pub fn budgets(options: &Options, benches: &[Bench]) -> Result<Section, String> {
    let mut section = Section::new(
        "budgets",
        "Memory against run time",
        "S1 to S6 at 1920x1080 with TEPUI_GPU_BUDGET at a multiple of the input (20 bytes a vertex, 12 a triangle): keys go by bands of rows, primitives and vertices by \
         slices. What clipping makes and what is too small to cut comes on top. On kernels whose front end is the host the budget is not looked at.",
    );
    let mut table = Table::new("", &["scene", "on", "budget by input", "intermediate by input", "MiB", "ms"]);
    let mut plot = Plot::new("Memory against run time", "intermediate memory by input", "ms a frame");
    progress(&table.heads);
    for &id in &options.scenes {
        let scene = Scene::new(id, SIZES[1])?;
        let (batch, input) = (batch(&scene)?, input_bytes(&scene));
        for (bench, budget) in benches.iter().flat_map(|b| [0.75, 1.0, 1.5, 2.0, 4.0, f64::INFINITY].map(|m| (b, m))) {
            let bytes = budget.is_finite().then_some((input * budget) as u64);
            match bench.measure(&batch, SIZES[1], 1, options.frames, bytes) {
                Ok(m) if m.memory.is_empty() => break,
                Ok(m) => {
                    let ratio = m.intermediate() as f64 / input;
                    plot.point(&format!("S{id}, {}", bench.short()), ratio, m.ms[1]);
                    let mib = m.intermediate() as f64 / (1 << 20) as f64;
                    let row = [
                        format!("S{id}"),
                        bench.short().into(),
                        budget.to_string(),
                        format!("{ratio:.2}"),
                        format!("{mib:.3}"),
                        format!("{:.3}", m.ms[1]),
                    ];
                    progress(&row);
                    table.rows.push(row.to_vec());
                }
                Err(why) => section.leave_out(format!("S{id} with {budget} times its input on {}: {why}", bench.short())),
            }
        }
    }
    (section.tables, section.plots) = (vec![table], vec![plot]);
    Ok(section)
}

/// A frame of 50 million triangles within a gibibyte.
pub fn huge(options: &Options, benches: &[Bench]) -> Result<Section, String> {
    let slices = (options.millions * 1_000_000).div_ceil(1 << 20);
    let mut section = Section::new(
        "huge",
        "A frame of very many triangles",
        "Bumpy grids of triangles of 1.5 pixels at 1920x1080, depth LESS, in batches of 2^20 triangles with shared vertices: what a batch holds is the memory that is needed, \
         not what a frame holds. The clock runs from the first batch to the last pixel, uploads included; making the triangles is left out.",
    );
    let mut table = Table::new("", &["on", "triangles", "s by the clock", "Mtri/s", "device MiB", "largest batch MiB", "pixels covered"]);
    progress(&table.heads);
    for bench in benches {
        let row = huge_frame(&mut section, bench, slices)?;
        progress(&row);
        table.rows.push(row);
    }
    section.tables.push(table);
    Ok(section)
}

fn huge_frame(section: &mut Section, bench: &Bench, slices: u32) -> Result<Vec<String>, String> {
    use tepui::device::{Device, Surface, gpu::GpuSurface};
    enum Target {
        Gpu(Box<GpuSurface>),
        Cpu(Box<dyn Surface>),
    }
    let size = SIZES[1];
    let format = super::bench::format(1)?;
    let mut target = match bench {
        Bench::Gpu(gpu, _) => Target::Gpu(Box::new(gpu.gpu_surface(size[0], size[1], format)?)),
        Bench::Cpu(cpu) => Target::Cpu(cpu.surface(size[0], size[1], format)),
    };
    let (mut seconds, mut triangles, mut largest, mut device) = (0.0, 0u64, 0, 0);
    for k in 0..slices {
        let scene = Scene::slice(k, size);
        let mut batch = batch(&scene)?;
        if k > 0 {
            batch.steps.remove(0);
        }
        triangles += scene.triangles() as u64;
        largest = largest.max(batch.vertices.len() * 4 + batch.primitives.len() * 16);
        let start = std::time::Instant::now();
        match &mut target {
            Target::Gpu(surface) => surface.execute(batch),
            Target::Cpu(surface) => surface.execute(batch),
        }
        if k + 1 == slices || k % 4 == 3 {
            // The host keeps a batch until its pixels are wanted; a program that stays within a budget asks now and then.
            match &mut target {
                Target::Gpu(surface) => {
                    device = device.max({
                        surface.pixels();
                        surface.memory().iter().map(|m| m.1).sum()
                    })
                }
                Target::Cpu(surface) => drop(surface.pixels()),
            }
        }
        seconds += start.elapsed().as_secs_f64();
        if k % 8 == 7 {
            println!("   {}: {} of {slices} batches, {seconds:.1} s", bench.short(), k + 1);
        }
    }
    let pixels = match &mut target {
        Target::Gpu(surface) => surface.pixels(),
        Target::Cpu(surface) => surface.pixels(),
    };
    let covered = pixels.color.iter().filter(|c| **c != 0).count();
    let mib = |bytes: u64| bytes as f64 / (1 << 20) as f64;
    if bench.is_hardware() {
        section.limit(format!("{:.0} million triangles: MiB of buffers on the device", triangles as f64 / 1e6), mib(device), 1024.0);
    }
    Ok(vec![
        bench.short().into(),
        triangles.to_string(),
        format!("{seconds:.2}"),
        format!("{:.1}", triangles as f64 / seconds / 1e6),
        if device > 0 { format!("{:.0}", mib(device)) } else { "-".into() },
        format!("{:.0}", mib(largest as u64)),
        covered.to_string(),
    ])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::bench::{Picture, difference, reference};
    use tepui::device::Device;

    #[test]
    fn a_scene_in_batches_is_the_same_picture() {
        let size = [256, 192];
        let scene = Scene::new(4, size).expect("S4");
        let whole = reference(&batch(&scene).expect("a batch"), size).expect("a picture");
        let cpu = tepui::device::cpu::CpuDevice::new();
        let mut surface = cpu.surface(size[0], size[1], crate::raster::bench::format(1).expect("a format"));
        let parts = cut(&scene, 7).expect("batches");
        assert_eq!(parts.len(), 7);
        parts.into_iter().for_each(|b| surface.execute(b));
        assert_eq!(difference(&whole, &Picture::of(&mut *surface)), [0; 4]);
    }
}
