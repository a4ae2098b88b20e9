//! Clears of a whole surface by the host: where it shares its memory with the device, its threads write at the speed of memory, a kernel does not.

use bytemuck::cast_slice;
use rayon::prelude::*;
use wgpu::WriteOnly;

use super::adapter::Gpu;
use super::buffers::write_mapped;

/// Bytes that a thread writes at a time: few enough that what is copied stays in its cache.
const BLOCK: usize = 1 << 16;

/// Fills a buffer that can be mapped with a pattern of 1, 2 or 4 words, when the device has done with it.
pub fn fill(gpu: &Gpu, buffer: &wgpu::Buffer, pattern: &[u32]) {
    let block: Vec<u32> = pattern.iter().copied().cycle().take(BLOCK / 4).collect();
    let block: &[u8] = cast_slice(&block);
    // What is still to be uploaded comes before it.
    gpu.queue.submit([]);
    write_mapped(&gpu.device, buffer, buffer.size(), |to| {
        let (blocks, mut rest) = to.into_chunks::<BLOCK>();
        let blocks: Vec<_> = blocks.into_iter().collect();
        blocks.into_par_iter().for_each(|to| WriteOnly::<[u8]>::from(to).copy_from_slice(block));
        rest.copy_from_slice(&block[..rest.len()]);
    });
}
