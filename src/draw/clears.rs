//! Clears that leave the stencil buffer alone although all of it holds one value: most programs have such a buffer without using it.

use super::{Batch, Clear, Step};
use crate::raster::layout::fragment_flags;

/// Makes clears of depth write the stencil values that are there anyhow, so that they write whole words and nothing has to be read.
/// `known` is what every pixel's stencil is before the batch, if that is known; returns the same for after it.
pub fn complete_stencil(batch: &mut Batch, known: Option<u8>, size: [u32; 2]) -> Option<u8> {
    let writes = |face: &crate::raster::layout::StencilFace| face.write_mask & 0xff != 0;
    let draws_write = batch.fragment_states.iter().any(|s| s.flags & fragment_flags::STENCIL_TEST != 0 && s.stencil.iter().any(writes));
    batch.steps.iter_mut().fold(known, |known, step| match step {
        Step::Clear(clear) => complete(clear, known, size),
        Step::Primitives { .. } => known.filter(|_| !draws_write),
    })
}

fn complete(clear: &mut Clear, known: Option<u8>, size: [u32; 2]) -> Option<u8> {
    let Some((value, mask)) = clear.stencil else {
        if clear.depth.is_some() {
            clear.stencil = known.map(|value| (value, 0xff));
        }
        return known;
    };
    let whole = clear.min.iter().all(|&v| v <= 0) && (0..2).all(|k| clear.max[k] >= size[k] as i32);
    let after = match (mask, known) {
        (0xff, _) => Some(value),
        (_, known) => known.map(|old| old & !mask | value & mask),
    };
    if let Some(after) = after {
        clear.stencil = Some((after, 0xff));
    }
    if whole || after == known { after } else { None }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::raster::layout::{FragmentState, StencilFace};
    use bytemuck::Zeroable;

    const SIZE: [u32; 2] = [8, 8];

    fn clear(depth: bool, stencil: Option<(u8, u8)>, whole: bool) -> Step {
        let max = if whole { [8, 8] } else { [4, 8] };
        Step::Clear(Clear { min: [0, 0], max, color: [0.0; 4], color_mask: 0, depth: depth.then_some(1.0), stencil })
    }

    /// What the clears write, and what is known afterwards.
    fn completed(steps: Vec<Step>, write_mask: u32, known: Option<u8>) -> (Vec<Option<(u8, u8)>>, Option<u8>) {
        let face = StencilFace { write_mask, ..StencilFace::zeroed() };
        let state = FragmentState { flags: fragment_flags::STENCIL_TEST, stencil: [face; 2], ..FragmentState::zeroed() };
        let mut batch = Batch { steps, fragment_states: vec![state], ..Batch::default() };
        let after = complete_stencil(&mut batch, known, SIZE);
        let clears = batch.steps.iter().filter_map(|s| if let Step::Clear(c) = s { Some(c.stencil) } else { None });
        (clears.collect(), after)
    }

    #[test]
    fn a_clear_of_depth_writes_the_stencil_that_is_there() {
        let draw = Step::Primitives { first: 0, end: 1 };
        assert_eq!(completed(vec![clear(true, None, false)], 0, Some(3)), (vec![Some((3, 0xff))], Some(3)));
        assert_eq!(completed(vec![clear(true, None, true)], 0, None), (vec![None], None));
        assert_eq!(completed(vec![clear(false, None, true)], 0, Some(3)), (vec![None], Some(3)));
        assert_eq!(completed(vec![draw, clear(true, None, true)], 0, Some(3)), (vec![Some((3, 0xff))], Some(3)));
        assert_eq!(completed(vec![draw, clear(true, None, true)], 1, Some(3)), (vec![None], None));
    }

    #[test]
    fn clears_of_stencil_make_it_known() {
        assert_eq!(completed(vec![clear(true, Some((5, 0xff)), true)], 0, None), (vec![Some((5, 0xff))], Some(5)));
        assert_eq!(completed(vec![clear(true, Some((5, 0xff)), false)], 0, Some(3)), (vec![Some((5, 0xff))], None));
        assert_eq!(completed(vec![clear(true, Some((5, 0xff)), false)], 0, Some(5)), (vec![Some((5, 0xff))], Some(5)));
        assert_eq!(completed(vec![clear(true, Some((0xff, 0x0f)), true)], 0, Some(0x30)), (vec![Some((0x3f, 0xff))], Some(0x3f)));
        assert_eq!(completed(vec![clear(true, Some((5, 0x0f)), true)], 0, None), (vec![Some((5, 0x0f))], None));
    }
}
