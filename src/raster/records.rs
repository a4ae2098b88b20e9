//! The triangles of a run in the order in which the bins read them: each bin's one after the other, each followed by its planes.
//!
//! A triangle of a few pixels takes less time to draw than one access to memory, so the fine stage must not jump from a list to triangles
//! and on to planes. A triangle in several bins is there several times.

use super::layout::*;
use super::setup::Chunk;
use super::simd::prefetch;
use crate::draw::Batch;

/// vec4 of a [`Triangle`].
pub const TRIANGLE_VEC4: usize = size_of::<Triangle>() / 16;

/// The records of a run: written after its set-up, read by the fine stage.
#[derive(Default)]
pub struct Records {
    /// A [`Triangle`], its planes, the next triangle, and so on.
    words: Vec<[f32; 4]>,
    /// Where each bin's records begin in `words`; one more at the end.
    offsets: Vec<u32>,
    /// What set-up counted.
    pub counts: Counts,
}

/// What was made of a run of primitives.
#[derive(Clone, Copy, Default)]
pub struct Counts {
    /// Triangles.
    pub triangles: usize,
    /// Their planes, in vec4.
    pub planes: usize,
    /// Places in bins.
    pub entries: usize,
    /// See [`Chunk::dropped`].
    pub dropped: usize,
    /// See [`Chunk::clipped`].
    pub clipped: usize,
}

/// vec4 of a draw's record: the triangle, depth, its varyings.
#[inline(always)]
pub fn size(draw: &DrawRecord) -> usize {
    TRIANGLE_VEC4 + (DEPTH_PLANE_VEC4 + draw.varying_count * VARYING_PLANE_VEC4) as usize
}

/// The triangle that records begin with.
#[inline(always)]
pub fn triangle(records: &[[f32; 4]]) -> &Triangle {
    bytemuck::cast_ref::<[[f32; 4]; TRIANGLE_VEC4], _>(records.first_chunk().expect("a triangle"))
}

impl Records {
    /// Copies a chunk whose bin lists are made.
    pub fn gather(&mut self, batch: &Batch, chunk: &Chunk) {
        let lists = &chunk.bins;
        self.offsets.clear();
        // Only what is read is written: memory of earlier batches may be longer.
        let most = lists.entries.len() * batch.draws.iter().map(|d| size(&d.record)).max().unwrap_or(0);
        if self.words.len() < most {
            self.words.resize(most, [0.0; 4]);
        }
        let mut at = 0;
        for bin in 0..lists.offsets.len().saturating_sub(1) {
            self.offsets.push(at as u32);
            for &index in lists.list(bin) {
                let t = &chunk.triangles[index as usize];
                let size = size(&batch.draws[t.draw as usize].record);
                let to = &mut self.words[at..at + size];
                let planes = (at + TRIANGLE_VEC4) as u32;
                let head: [[f32; 4]; TRIANGLE_VEC4] = bytemuck::cast(Triangle { planes, ..*t });
                to[..TRIANGLE_VEC4].copy_from_slice(&head);
                let planes = &chunk.planes[t.planes as usize..];
                for (to, plane) in to[TRIANGLE_VEC4..].iter_mut().zip(planes) {
                    *to = *plane;
                }
                at += size;
            }
        }
        self.offsets.push(at as u32);
        self.counts = Counts {
            triangles: chunk.triangles.len(),
            planes: chunk.planes.len(),
            entries: lists.entries.len(),
            dropped: chunk.dropped as usize,
            clipped: chunk.clipped as usize,
        };
    }

    /// A bin's records.
    #[inline(always)]
    pub fn list(&self, bin: usize) -> &[[f32; 4]] {
        &self.words[self.offsets[bin] as usize..self.offsets[bin + 1] as usize]
    }

    /// Asks for the place of a bin's records.
    #[inline(always)]
    pub fn prefetch_list(&self, bin: usize) {
        self.offsets.get(bin).into_iter().for_each(prefetch);
    }

    /// The planes of a triangle, by [`Triangle::planes`].
    #[inline(always)]
    pub fn planes(&self, first: u32) -> &[[f32; 4]] {
        &self.words[first as usize..]
    }
}
