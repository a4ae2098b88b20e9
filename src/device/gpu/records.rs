//! The states of a draw as the fine stage reads them: everything that it may want in a few words side by side, so that
//! a group of lanes loads them at once (`shaders/state.wgsl`).

use super::texture::BINDING_WORDS;
use crate::draw::Batch;
use crate::raster::layout::*;

/// Words of a draw's record in the front end: a [`DrawRecord`].
pub const DRAW_RECORD_WORDS: usize = size_of::<DrawRecord>() / 4;

/// Words of a draw's record in the fine stage.
pub const DRAW_WORDS: usize = 32;

/// Packs a draw. `flags` are the fragment flags that the surface can serve; `stipples` and `textures` are the places of these
/// tables in the record buffer.
pub fn pack_draw(batch: &Batch, index: usize, flags: u32, stipples: u32, textures: u32) -> [u32; DRAW_WORDS] {
    let record = &batch.draws[index].record;
    let state = &batch.fragment_states[record.fragment_state as usize];
    let raster = &batch.raster_states[record.raster_state as usize];
    let mut words = [0; DRAW_WORDS];
    words[0] = record.fragment_uniforms;
    words[1] = textures + record.first_texture * BINDING_WORDS as u32;
    let perspective = record.varyings.iter().take(record.varying_count as usize).enumerate();
    let perspective = perspective.fold(0, |m, (k, v)| m | ((v >> 16 & 3 == interpolation::PERSPECTIVE) as u32) << k);
    words[2] = flags | perspective << 16;
    words[3] = state.depth_func | state.alpha_func << 8 | state.logic_op << 16 | (state.color_mask & 15) << 24;
    words[4] = raster.depth_range[0].to_bits();
    words[5] = raster.depth_range[1].to_bits();
    words[6] = (state.alpha_ref.clamp(0.0, 1.0) * 255.0).round_ties_even() as u32;
    words[7] = if batch.polygon_stipples.len() > raster.polygon_stipple as usize { stipples + raster.polygon_stipple * 32 } else { NONE };
    let f = state.blend_factors;
    words[8] = f[0] | f[1] << 8 | f[2] << 16 | f[3] << 24;
    words[9] = state.blend_equations[0] | state.blend_equations[1] << 8;
    for c in 0..4 {
        words[10 + c] = state.blend_color[c].to_bits();
    }
    words[14] = state.dropped_samples;
    for (face, to) in state.stencil.iter().zip(words[16..].chunks_mut(8)) {
        to[..7].copy_from_slice(&[face.func, face.reference, face.read_mask, face.write_mask & 255, face.ops[0], face.ops[1], face.ops[2]]);
    }
    words
}
