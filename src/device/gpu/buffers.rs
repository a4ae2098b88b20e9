//! GPU buffers that grow.

/// A buffer that grows to what is asked for. What it held is lost when it grows; a new one holds zeros.
pub struct Growing {
    label: &'static str,
    usage: wgpu::BufferUsages,
    buffer: wgpu::Buffer,
    /// Counts replacements, so that bind groups know when they are stale.
    pub generation: u32,
}

impl Growing {
    /// A small buffer.
    pub fn new(device: &wgpu::Device, label: &'static str, usage: wgpu::BufferUsages) -> Growing {
        let usage = usage | wgpu::BufferUsages::COPY_DST;
        Growing { label, usage, buffer: create(device, label, usage, 0), generation: 0 }
    }

    /// At least `bytes` large.
    pub fn reserve(&mut self, device: &wgpu::Device, bytes: u64) {
        if self.buffer.size() < bytes {
            // A quarter more than before, so that a scene that grows does not replace the buffer each time; but no more than a binding may hold.
            let most = device.limits().max_storage_buffer_binding_size;
            let before = self.buffer.size();
            let size = bytes.max((before + before / 4).min(most)).next_multiple_of(256);
            self.buffer = create(device, self.label, self.usage, size);
            self.generation += 1;
        }
    }

    /// Writes words from the start; grows as needed, with some words of slack behind them.
    pub fn upload(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, bytes: &[u8]) {
        self.fill(device, queue, bytes.len(), |mut to| to.copy_from_slice(bytes));
    }

    /// The same of `size` bytes that `write` writes. A buffer that can be mapped is written in place, when the device has done with it.
    pub fn fill(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, size: usize, write: impl FnOnce(wgpu::WriteOnly<[u8]>)) {
        self.reserve(device, size as u64 + 256);
        let Some(bytes) = wgpu::BufferSize::new(size as u64) else { return };
        if !self.usage.contains(wgpu::BufferUsages::MAP_WRITE) {
            if let Some(mut view) = queue.write_buffer_with(&self.buffer, 0, bytes) {
                write(view.slice(..));
            }
            return;
        }
        write_mapped(device, &self.buffer, size as u64, write);
    }

    /// What it is called.
    pub fn label(&self) -> &'static str {
        self.label
    }

    /// The buffer.
    pub fn get(&self) -> &wgpu::Buffer {
        &self.buffer
    }
}

/// Writes the first bytes of a buffer in place, when the device has done with it.
pub fn write_mapped(device: &wgpu::Device, buffer: &wgpu::Buffer, bytes: u64, write: impl FnOnce(wgpu::WriteOnly<[u8]>)) {
    let place = buffer.slice(..bytes);
    place.map_async(wgpu::MapMode::Write, |_| {});
    if let Err(e) = device.poll(wgpu::PollType::wait_indefinitely()) {
        log::error!(target: "tepui::gpu", "waiting for the GPU: {e}");
    }
    match place.get_mapped_range_mut() {
        Ok(mut view) => write(view.slice(..)),
        Err(e) => log::error!(target: "tepui::gpu", "writing a buffer: {e}"),
    }
    buffer.unmap();
}

/// A buffer of zeros.
pub fn create(device: &wgpu::Device, label: &str, usage: wgpu::BufferUsages, size: u64) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor { label: Some(label), size: size.max(256), usage, mapped_at_creation: false })
}
