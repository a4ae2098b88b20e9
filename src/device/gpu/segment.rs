//! Segments: runs of primitives whose draws one fine kernel can serve, however their states differ.

use super::fine::{BlendKey, FineKey, feature};
use super::texture::TextureClass;
use crate::device::{ColorFormat, DepthFormat, SurfaceFormat};
use crate::draw::Batch;
use crate::raster::layout::*;

/// What a draw asks of the fine kernel.
#[derive(Clone)]
pub struct DrawNeeds {
    program: u64,
    features: u32,
    /// Flags of the fragment state that decide between features.
    flags: u32,
    blend: Option<([u32; 4], [u32; 2])>,
    depth_func: u32,
    textures: Vec<TextureClass>,
}

/// The fragment flags of a draw that the surface's buffers can serve.
pub fn served_flags(batch: &Batch, index: usize, format: SurfaceFormat) -> u32 {
    let mut flags = batch.fragment_states[batch.draws[index].record.fragment_state as usize].flags;
    if format.depth == DepthFormat::None {
        flags &= !(fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE);
    }
    if !format.stencil {
        flags &= !fragment_flags::STENCIL_TEST;
    }
    if format.color == ColorFormat::Rgba32f {
        flags &= !fragment_flags::LOGIC_OP;
    }
    if format.samples == 1 {
        flags &= !(fragment_flags::ALPHA_TO_COVERAGE | fragment_flags::ALPHA_TO_ONE);
    }
    flags
}

/// Whether no triangle of a draw reaches beyond the scissor: filled polygons are clipped to the viewport, and that lies inside.
fn stays_inside(batch: &Batch, index: usize) -> bool {
    let record = &batch.draws[index].record;
    let state = &batch.raster_states[record.raster_state as usize];
    let viewport_inside = (0..2).all(|k| {
        let (middle, half) = (state.viewport_translate[k], state.viewport_scale[k].abs());
        middle - half >= state.scissor_min[k] as f32 && middle + half <= state.scissor_max[k] as f32
    });
    let filled = record.topology == topology::TRIANGLES && state.polygon_mode == [topology::TRIANGLES; 2];
    filled && viewport_inside && state.flags & raster_flags::WINDOW_SPACE == 0
}

/// What draw `index` asks for on a surface.
pub fn needs(batch: &Batch, index: usize, format: SurfaceFormat) -> DrawNeeds {
    let draw = &batch.draws[index];
    let state = &batch.fragment_states[draw.record.fragment_state as usize];
    let raster = &batch.raster_states[draw.record.raster_state as usize];
    let program = &*draw.fragment_program;
    let flags = served_flags(batch, index, format);
    let on = |bit: u32| flags & bit != 0;
    let mut features = 0;
    let mut set = |bit: u32, on: bool| features |= if on { bit } else { 0 };
    set(feature::DEPTH_TEST, on(fragment_flags::DEPTH_TEST));
    set(feature::DEPTH_WRITE, on(fragment_flags::DEPTH_TEST) && on(fragment_flags::DEPTH_WRITE));
    set(feature::STENCIL_TEST, on(fragment_flags::STENCIL_TEST));
    set(feature::DEPTH_BUFFER, on(fragment_flags::DEPTH_TEST) || on(fragment_flags::STENCIL_TEST));
    set(feature::ALPHA_TEST, on(fragment_flags::ALPHA_TEST));
    // One of 16 samples lies on the border of its pixel, where a triangle that ends at the border of the surface may cover it.
    set(feature::CUT, format.samples == 16 || !stays_inside(batch, index));
    set(feature::DEPTH_RANGE, raster.depth_range != [0.0, 1.0]);
    let offsets = raster_flags::OFFSET_POINT | raster_flags::OFFSET_LINE | raster_flags::OFFSET_FILL;
    set(feature::OFFSET, raster.flags & offsets != 0);
    let several = format.samples > 1;
    set(feature::DROPS_SAMPLES, several && state.dropped_samples != 0);
    set(feature::CENTRES, several && raster.flags & raster_flags::MULTISAMPLE == 0);
    set(feature::ALPHA_TO_COVERAGE, on(fragment_flags::ALPHA_TO_COVERAGE));
    set(feature::ALPHA_TO_ONE, on(fragment_flags::ALPHA_TO_ONE));
    set(feature::STIPPLE, batch.polygon_stipples.len() > raster.polygon_stipple as usize);
    let color = state.color_mask & 15 != 0;
    set(feature::COLOR_WRITE, color);
    set(feature::COLOR_MASK, color && state.color_mask & 15 != 15);
    set(feature::BLEND, color && on(fragment_flags::BLEND));
    set(feature::LOGIC_OP, color && on(fragment_flags::LOGIC_OP));
    let reads_alpha = on(fragment_flags::ALPHA_TEST) || on(fragment_flags::ALPHA_TO_COVERAGE);
    let shades = color || reads_alpha || program.discards || program.writes_depth;
    set(feature::SHADES, shades);
    let first = draw.record.first_texture as usize;
    let slots = if shades { program.texture_slots as usize } else { 0 };
    let textures = (first..first + slots).map(|k| batch.textures.get(k).map_or(TextureClass::NONE, TextureClass::new)).collect();
    let blend = (color && on(fragment_flags::BLEND)).then_some((state.blend_factors, state.blend_equations));
    let deciding = fragment_flags::DEPTH_TEST
        | fragment_flags::DEPTH_WRITE
        | fragment_flags::STENCIL_TEST
        | fragment_flags::ALPHA_TEST
        | fragment_flags::BLEND
        | fragment_flags::LOGIC_OP
        | fragment_flags::ALPHA_TO_COVERAGE
        | fragment_flags::ALPHA_TO_ONE;
    DrawNeeds { program: program.id, features, flags: flags & deciding, blend, depth_func: state.depth_func, textures }
}

/// A segment that grows draw by draw.
#[derive(Clone)]
pub struct Segment {
    /// Its kernel.
    pub key: FineKey,
    flags: u32,
    /// The draw that names its program.
    pub draw: u32,
}

impl Segment {
    /// For a first draw.
    pub fn new(needs: &DrawNeeds, format: SurfaceFormat, draw: u32) -> Segment {
        let blend = needs.blend.map_or(BlendKey::Fixed([0; 4], [0; 2]), |(f, e)| BlendKey::Fixed(f, e));
        let key = FineKey {
            program: needs.program,
            color: format.color,
            features: needs.features,
            blend,
            depth_func: Some(needs.depth_func),
            depth_bits: format.depth.bits(),
            textures: needs.textures.clone(),
            samples: format.samples,
        };
        Segment { key, flags: needs.flags, draw }
    }

    /// Takes a draw in, if one kernel can serve it too.
    pub fn admit(&mut self, needs: &DrawNeeds, batch: &Batch, draw: u32) -> bool {
        let shades = feature::SHADES;
        let (ours, theirs) = (&batch.draws[self.draw as usize].fragment_program, &batch.draws[draw as usize].fragment_program);
        let same = ours.id == theirs.id;
        // Flat and smooth shading run the same text over the same inputs.
        if !same && (ours.inputs != theirs.inputs || ours.varyings.len() != theirs.varyings.len() || ours.wgsl != theirs.wgsl) {
            return false;
        }
        if self.key.textures != needs.textures || (self.key.features ^ needs.features) & shades != 0 {
            return false;
        }
        if !same {
            self.key.features |= feature::MIXED_INTERPOLATION;
        }
        if needs.flags != self.flags {
            self.key.features |= feature::MIXED;
        }
        // Colours that some draws do not write at all: their mask says so.
        if (self.key.features ^ needs.features) & feature::COLOR_WRITE != 0 {
            self.key.features |= feature::COLOR_MASK;
        }
        if needs.features & feature::DEPTH_TEST != 0 {
            if self.key.features & feature::DEPTH_TEST == 0 {
                self.key.depth_func = Some(needs.depth_func);
            } else if self.key.depth_func != Some(needs.depth_func) {
                self.key.depth_func = None;
            }
        }
        if let Some((f, e)) = needs.blend {
            if self.key.features & feature::BLEND == 0 {
                self.key.blend = BlendKey::Fixed(f, e);
            } else if self.key.blend != BlendKey::Fixed(f, e) {
                self.key.blend = BlendKey::Dynamic;
            }
        }
        self.key.features |= needs.features;
        true
    }

    /// The kernel's key, when no more draws come.
    pub fn finish(mut self) -> FineKey {
        if self.key.features & feature::DEPTH_TEST == 0 {
            self.key.depth_func = None;
        }
        self.key
    }
}
