//! Clears of a whole surface as copies: on a software driver a copy runs at the speed of memory, a kernel does not.

use super::buffers::Growing;

/// A buffer that holds one pixel over and over.
pub struct Fill {
    buffer: Growing,
    pattern: Vec<u32>,
    words: usize,
}

impl Fill {
    /// Nothing yet.
    pub fn new(device: &wgpu::Device) -> Fill {
        Fill { buffer: Growing::new(device, "fill", wgpu::BufferUsages::COPY_SRC), pattern: Vec::new(), words: 0 }
    }

    /// Makes it hold `words` words of a pattern.
    pub fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, pattern: &[u32], words: usize) {
        if self.pattern != pattern || self.words < words {
            let all: Vec<u32> = pattern.iter().copied().cycle().take(words).collect();
            self.buffer.upload(device, queue, bytemuck::cast_slice(&all));
            self.pattern = pattern.to_vec();
            self.words = words;
        }
    }

    /// Copies it over a buffer.
    pub fn copy(&self, encoder: &mut wgpu::CommandEncoder, to: &wgpu::Buffer, words: usize) {
        encoder.copy_buffer_to_buffer(self.buffer.get(), 0, to, 0, words as u64 * 4);
    }
}
