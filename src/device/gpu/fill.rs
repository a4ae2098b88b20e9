//! Clears of a whole surface as copies: on a software driver a copy runs at the speed of memory, a kernel does not.

use super::buffers::Growing;

/// Words of a fill's buffer: they stay in the processor's cache while they are copied again and again.
const WORDS: usize = 1 << 16;

/// A buffer that holds one pixel over and over.
pub struct Fill {
    buffer: Growing,
    pattern: Vec<u32>,
}

impl Fill {
    /// Nothing yet.
    pub fn new(device: &wgpu::Device) -> Fill {
        Fill { buffer: Growing::new(device, "fill", wgpu::BufferUsages::COPY_SRC), pattern: Vec::new() }
    }

    /// Makes it hold a pattern of 1, 2 or 4 words.
    pub fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, pattern: &[u32]) {
        if self.pattern != pattern {
            let all: Vec<u32> = pattern.iter().copied().cycle().take(WORDS).collect();
            self.buffer.upload(device, queue, bytemuck::cast_slice(&all));
            self.pattern = pattern.to_vec();
        }
    }

    /// Copies it over `words` words of a buffer.
    pub fn copy(&self, encoder: &mut wgpu::CommandEncoder, to: &wgpu::Buffer, words: usize) {
        for first in (0..words).step_by(WORDS) {
            let bytes = WORDS.min(words - first) as u64 * 4;
            encoder.copy_buffer_to_buffer(self.buffer.get(), 0, to, first as u64 * 4, bytes);
        }
    }
}
