//! How a draw's fragments are done on the CPU, decided once a batch.

use super::layout::*;
use super::setup::to_centre;
use super::{blend, fast};
use crate::device::{ColorFormat, DepthFormat, SurfaceFormat};
use crate::draw::Batch;
use crate::draw::texture::{TextureBinding, TextureKind};
use crate::program::{Input, Modulate, Program, Shortcut};

/// What is needed of a draw's state.
pub struct Plan<'a> {
    /// The draw's record.
    pub record: &'a DrawRecord,
    /// Per-fragment operations.
    pub state: &'a FragmentState,
    /// The fragment program.
    pub program: &'a Program,
    /// The colour is this varying: no program runs.
    pub direct: Option<usize>,
    /// The colour is a varying times a texel: no program runs.
    pub modulate: Option<Modulate>,
    /// Depth and stencil are tested before the colour is known.
    pub early: bool,
    /// There is any depth or stencil test.
    pub tests: bool,
    /// Rows of the polygon stipple.
    pub stipple: Option<&'a [u32; 32]>,
    /// Storage of depth.
    pub depth_format: DepthFormat,
    /// Largest depth value.
    pub depth_scale: f32,
    /// What depth is clamped to.
    pub depth_range: [f32; 2],
    /// The blend colour, as pairs.
    pub constant: (i32, i32),
    /// Bits of a packed pixel that are written.
    pub write_mask: u32,
    /// Which routine of [`super::fast`] serves the draw: `fast::*`.
    pub fast: u32,
    /// The same of [`super::fast_samples`], on surfaces with several samples a pixel.
    pub fast_samples: u32,
    /// Added to the stored depth before "less": 1 for LEQUAL.
    pub depth_bias: i32,
    /// What is farther than the stored depths leaves no trace: [`super::hi_z`] may leave it out.
    pub hi_z: bool,
    /// Added to a pixel's column and row where planes are evaluated for its centre: see [`to_centre`].
    pub centre: f32,
    /// Depths may become farther.
    pub farther: bool,
    /// Vec4 of a varying's planes that are interpolated: mode by varying.
    pub modes: [u32; MAX_VARYINGS],
}

impl<'a> Plan<'a> {
    /// For draw `index` of a batch on a surface.
    pub fn new(batch: &'a Batch, index: usize, format: SurfaceFormat) -> Plan<'a> {
        let draw = &batch.draws[index];
        let state = &batch.fragment_states[draw.record.fragment_state as usize];
        let raster = &batch.raster_states[draw.record.raster_state as usize];
        let program = &*draw.fragment_program;
        let direct = match program.shortcut {
            Shortcut::Varying(k) if (k as u32) < draw.record.varying_count => Some(k as usize),
            _ => None,
        };
        let flat_image = |t: &TextureBinding| matches!(t.image.kind, TextureKind::D1 | TextureKind::D2);
        let modulate = match program.shortcut {
            Shortcut::Modulate(what) if batch.textures.get(draw.record.first_texture as usize).is_some_and(flat_image) => Some(what),
            _ => None,
        };
        let mut write_mask = blend::mask_bits(state.color_mask);
        if format.color == ColorFormat::Rgbx8 {
            write_mask |= 0xff00_0000;
        }
        let routine = fast::choose(state, format, [direct.is_some(), modulate.is_some()], write_mask);
        let tested = state.flags & fragment_flags::DEPTH_TEST != 0;
        let nearer = matches!(state.depth_func, compare::LESS | compare::LEQUAL);
        let keeps = nearer || matches!(state.depth_func, compare::NEVER | compare::EQUAL);
        // With samples only what needs no texture, and a triangle's coverage by its edges alone.
        let by_sample = fragment_flags::ALPHA_TO_COVERAGE | fragment_flags::ALPHA_TO_ONE;
        let samples_serve = routine & fast::TEXTURE == 0 && state.flags & by_sample == 0 && state.dropped_samples == 0;
        let (fast, fast_samples) = match format.samples {
            1 => (routine, fast::NONE),
            _ => (fast::NONE, if samples_serve { routine } else { fast::NONE }),
        };
        Plan {
            record: &draw.record,
            state,
            program,
            direct,
            modulate,
            early: state.flags & (fragment_flags::ALPHA_TEST | fragment_flags::ALPHA_TO_COVERAGE) == 0
                && !program.discards
                && !program.writes_depth,
            tests: state.flags & (fragment_flags::DEPTH_TEST | fragment_flags::STENCIL_TEST) != 0,
            stipple: batch.polygon_stipples.get(raster.polygon_stipple as usize),
            depth_format: format.depth,
            depth_scale: format.depth.most() as f32,
            depth_range: raster.depth_range,
            constant: blend::constant_pairs(state),
            write_mask,
            fast,
            fast_samples,
            depth_bias: (state.depth_func == compare::LEQUAL) as i32,
            hi_z: tested && nearer && state.flags & fragment_flags::STENCIL_TEST == 0 && !format.depth.is_float() && !program.writes_depth,
            centre: to_centre(raster),
            farther: tested && state.flags & fragment_flags::DEPTH_WRITE != 0 && !keeps,
            modes: draw.record.varyings.map(|v| v >> 16 & 3),
        }
    }
}

impl Plan<'_> {
    /// Samples have coverage and depths of their own, not the pixel's.
    #[inline(always)]
    pub fn multisampled(&self) -> bool {
        self.centre != 0.0
    }

    /// What the program reads.
    pub fn inputs(&self) -> &[Input] {
        &self.program.inputs
    }

    /// What serves the draw, in words.
    pub fn routine(&self) -> &'static str {
        match self.fast {
            fast::DEPTH => "the depth-tested routine (colour passes through, no program)",
            fast::BLEND => "the blending routine (colour passes through, no program, no tests)",
            fast::DEPTH_BLEND => "the depth-tested blending routine (colour passes through, no program)",
            fast::COPY => "the replacing routine (colour passes through, no program, no tests)",
            f if f & fast::TEXTURE != 0 => "the routine of one texture (no program)",
            _ if self.fast_samples != fast::NONE => "the routine of several samples (colour passes through, no program)",
            _ if self.direct.is_some() => "the general routine without a program",
            _ if self.modulate.is_some() => "the general routine with one texture (no program)",
            _ if self.early => "the general routine with early tests and a program",
            _ => "the general routine with a program before the tests",
        }
    }
}
