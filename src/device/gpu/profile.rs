//! Times of the stages on the device, for `TEPUI_STATS=2`.

use super::adapter::Gpu;
use super::buffers::create;

/// Most time stamps of a batch.
const MOST: u32 = 512;

/// Time stamps between the dispatches of a batch.
pub struct Profile {
    set: wgpu::QuerySet,
    names: Vec<&'static str>,
}

impl Profile {
    /// `None` where it is not asked for or the device has no time stamps in passes.
    pub fn new(gpu: &Gpu) -> Option<Profile> {
        if super::surface::stats_level() < 2 || !gpu.device.features().contains(wgpu::Features::TIMESTAMP_QUERY_INSIDE_PASSES) {
            return None;
        }
        let descriptor = wgpu::QuerySetDescriptor { label: None, ty: wgpu::QueryType::Timestamp, count: MOST };
        Some(Profile { set: gpu.device.create_query_set(&descriptor), names: Vec::new() })
    }

    /// A time stamp: what came before it was `name`.
    pub fn mark(&mut self, pass: &mut wgpu::ComputePass, name: &'static str) {
        if self.names.len() < MOST as usize {
            pass.write_timestamp(&self.set, self.names.len() as u32);
            self.names.push(name);
        }
    }

    /// Waits and prints, stages of one name added up.
    pub fn print(self, gpu: &Gpu, mut encoder: wgpu::CommandEncoder) {
        let bytes = self.names.len() as u64 * 8;
        let resolved = create(&gpu.device, "resolved", wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC, bytes);
        let mapped = create(&gpu.device, "mapped", wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST, bytes);
        encoder.resolve_query_set(&self.set, 0..self.names.len() as u32, &resolved, 0);
        encoder.copy_buffer_to_buffer(&resolved, 0, &mapped, 0, bytes);
        gpu.queue.submit([encoder.finish()]);
        mapped.slice(..).map_async(wgpu::MapMode::Read, |_| {});
        let _ = gpu.device.poll(wgpu::PollType::wait_indefinitely());
        let Ok(view) = mapped.slice(..bytes).get_mapped_range() else { return };
        let times: Vec<u64> = bytemuck::pod_collect_to_vec(&view);
        let period = gpu.queue.get_timestamp_period() as f64 * 1e-6;
        let mut sums: Vec<(&str, f64)> = Vec::new();
        for (k, name) in self.names.iter().enumerate().skip(1) {
            let ms = times[k].saturating_sub(times[k - 1]) as f64 * period;
            match sums.iter_mut().find(|s| s.0 == *name) {
                Some(s) => s.1 += ms,
                None => sums.push((name, ms)),
            }
        }
        let text: Vec<String> = sums.iter().map(|(name, ms)| format!("{name} {ms:.3}")).collect();
        eprintln!("tepui: gpu: ms: {}", text.join(", "));
    }
}
