//! Times of the stages on the device.

use super::adapter::Gpu;
use super::buffers::create;

/// Most time stamps of a batch.
const MOST: u32 = 1024;

/// How long a stage took.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StageTime {
    /// Its name.
    pub name: &'static str,
    /// Milliseconds on the device, all its dispatches together.
    pub ms: f64,
}

/// Time stamps between the dispatches of a batch.
pub struct Profile {
    set: wgpu::QuerySet,
    names: Vec<&'static str>,
    stages: bool,
}

impl Profile {
    /// `None` where the device has no time stamps in passes. Without `stages` there are two only, named "start" and "end".
    pub fn new(gpu: &Gpu, stages: bool) -> Option<Profile> {
        if !gpu.device.features().contains(wgpu::Features::TIMESTAMP_QUERY_INSIDE_PASSES) {
            return None;
        }
        let descriptor = wgpu::QuerySetDescriptor { label: None, ty: wgpu::QueryType::Timestamp, count: MOST };
        Some(Profile { set: gpu.device.create_query_set(&descriptor), names: Vec::new(), stages })
    }

    /// A time stamp: what came before it was `name`.
    pub fn mark(&mut self, pass: &mut wgpu::ComputePass, name: &'static str) {
        if self.names.len() < MOST as usize && (self.stages || matches!(name, "start" | "end")) {
            pass.write_timestamp(&self.set, self.names.len() as u32);
            self.names.push(name);
        }
    }

    /// Submits the commands, waits, and adds up the times of each stage.
    pub fn finish(self, gpu: &Gpu, mut encoder: wgpu::CommandEncoder) -> Vec<StageTime> {
        let bytes = self.names.len() as u64 * 8;
        let resolved = create(&gpu.device, "resolved", wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC, bytes);
        let mapped = create(&gpu.device, "mapped", wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST, bytes);
        encoder.resolve_query_set(&self.set, 0..self.names.len() as u32, &resolved, 0);
        encoder.copy_buffer_to_buffer(&resolved, 0, &mapped, 0, bytes);
        gpu.queue.submit([encoder.finish()]);
        mapped.slice(..).map_async(wgpu::MapMode::Read, |_| {});
        let _ = gpu.device.poll(wgpu::PollType::wait_indefinitely());
        let Ok(view) = mapped.slice(..bytes).get_mapped_range() else { return Vec::new() };
        let times: Vec<u64> = bytemuck::pod_collect_to_vec(&view);
        let period = gpu.queue.get_timestamp_period() as f64 * 1e-6;
        let mut sums: Vec<StageTime> = Vec::new();
        for (k, &name) in self.names.iter().enumerate().skip(1) {
            let ms = times[k].saturating_sub(times[k - 1]) as f64 * period;
            match sums.iter_mut().find(|s| s.name == name) {
                Some(s) => s.ms += ms,
                None => sums.push(StageTime { name, ms }),
            }
        }
        sums
    }
}
