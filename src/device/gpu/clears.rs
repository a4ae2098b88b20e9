//! Clears in plans: their parameters, and which of them the segment behind them does.

use super::encode::{Action, Place};
use super::params::{Params, fresh};
use crate::device::{DepthFormat, SurfaceFormat};
use crate::draw::Clear;
use crate::raster::{blend::mask_bits, formats};

/// A clear as parameters; `None` where it writes nothing.
pub fn clear_params(clear: &Clear, mut params: Params, format: SurfaceFormat) -> Option<Params> {
    for k in 0..2 {
        params.clear_min[k] = clear.min[k].max(0);
        params.clear_max[k] = clear.max[k].min(params.size[k] as i32);
        if params.clear_min[k] >= params.clear_max[k] {
            return None;
        }
    }
    if clear.color_mask & 15 != 0 {
        let words = format.color.words();
        formats::pack(format.color, clear.color, &mut params.clear_color[..words]);
        formats::mask(format.color, mask_bits(clear.color_mask), &mut params.clear_mask[..words]);
    }
    if let (Some(depth), true) = (clear.depth, format.depth != DepthFormat::None) {
        params.clear_depth |= format.depth.word(depth);
        params.clear_depth_mask |= format.depth.mask();
    }
    if let (Some((stencil, writes)), true) = (clear.stencil, format.stencil) {
        params.clear_depth |= ((stencil & writes) as u32) << 24;
        params.clear_depth_mask |= (writes as u32) << 24;
    }
    (params.clear_mask != [0; 4] || params.clear_depth_mask != 0).then_some(params)
}

/// What a clear writes, colour and depth: `None` nothing, true all words of every pixel.
pub fn writes_whole(clear: &Params, format: SurfaceFormat) -> [Option<bool>; 2] {
    let all = clear.clear_min == [0; 2] && clear.clear_max == clear.size.map(|s| s as i32);
    let used = if format.stencil { u32::MAX } else { format.depth.mask() };
    let color = clear.clear_mask[..format.color.words()].iter().all(|&m| m == u32::MAX);
    let depth = clear.clear_depth_mask & used == used;
    [(clear.clear_mask != [0; 4]).then_some(all && color), (clear.clear_depth_mask != 0).then_some(all && depth)]
}

/// Tells the first segment behind clears of the whole surface what they left. Where `absorbs`, such a segment writes every pixel anyway and
/// does the clears itself: should it fail, the batch goes on at the first of them.
pub fn absorb_clears(actions: &mut [(Place, Action)], format: SurfaceFormat, absorbs: bool) {
    let mut known = Params::default();
    // Clears since the last segment, as long as all of them are whole.
    let mut whole_clears: Vec<usize> = Vec::new();
    for k in 0..actions.len() {
        let params = match &mut actions[k].1 {
            Action::Clear(clear) => {
                let [color, depth] = writes_whole(clear, format);
                if let Some(whole) = color {
                    known.fresh = known.fresh & !fresh::COLOR | if whole { fresh::COLOR } else { 0 };
                    known.clear_color = clear.clear_color;
                }
                if let Some(whole) = depth {
                    known.fresh = known.fresh & !fresh::DEPTH | if whole { fresh::DEPTH } else { 0 };
                    known.clear_depth = clear.clear_depth;
                }
                if ![color, depth].contains(&Some(false)) {
                    whole_clears.push(k);
                } else {
                    whole_clears.clear();
                }
                continue;
            }
            Action::Draw(draw) => &mut draw.params,
            Action::Visible(visible) => &mut visible.params,
            Action::Front(..) | Action::Absorbed => continue,
        };
        (params.fresh, params.clear_color, params.clear_depth) = (known.fresh, known.clear_color, known.clear_depth);
        known.fresh = 0;
        if let (Some(&first), true) = (whole_clears.first(), absorbs) {
            params.fresh |= fresh::CLEARS;
            let place = actions[first].0;
            actions[first..=k].iter_mut().for_each(|action| action.0 = place);
            whole_clears.iter().for_each(|&clear| actions[clear].1 = Action::Absorbed);
        }
        whole_clears.clear();
    }
}

#[cfg(test)]
mod tests {
    use super::super::encode::DrawAction;
    use super::super::fine::{BlendKey, FineKey};
    use super::*;
    use crate::device::ColorFormat;

    const FORMAT: SurfaceFormat =
        SurfaceFormat { color: ColorFormat::Rgba8, depth: DepthFormat::D24, stencil: true, top_first: true, samples: 1 };

    fn clear(step: usize, change: impl FnOnce(&mut Clear)) -> (Place, Action) {
        let mut clear = Clear { min: [0; 2], max: [64; 2], color: [1.0; 4], color_mask: 15, depth: Some(1.0), stencil: Some((3, 0xff)) };
        change(&mut clear);
        let params = clear_params(&clear, Params { size: [64; 2], ..Params::default() }, FORMAT).expect("it writes something");
        (Place { step, primitive: 0 }, Action::Clear(params))
    }

    fn draw(step: usize, primitive: u32) -> (Place, Action) {
        let key = FineKey {
            program: 0,
            color: FORMAT.color,
            features: 0,
            blend: BlendKey::Fixed([0; 4], [0; 2]),
            depth_func: None,
            depth_bits: 24,
            textures: Vec::new(),
            samples: 1,
        };
        let params = Params::default();
        (Place { step, primitive }, Action::Draw(Box::new(DrawAction { params, key, draw: 0, triangles: None, blocks: 1 })))
    }

    /// By action: `c` a clear that stays, `a` one that is absorbed, and of segments what they know and whether they clear.
    fn plan(mut actions: Vec<(Place, Action)>, absorbs: bool) -> (String, Vec<Place>) {
        absorb_clears(&mut actions, FORMAT, absorbs);
        let text = |action: &Action| match action {
            Action::Clear(_) => "c ".to_string(),
            Action::Absorbed => "a ".to_string(),
            Action::Draw(draw) => {
                let on = |bit: u32, letter| if draw.params.fresh & bit != 0 { letter } else { "" };
                format!("[{}{}{}] ", on(fresh::COLOR, "C"), on(fresh::DEPTH, "D"), on(fresh::CLEARS, "!"))
            }
            _ => unreachable!("no such action here"),
        };
        (actions.iter().map(|(_, action)| text(action)).collect(), actions.iter().map(|(place, _)| *place).collect())
    }

    fn depth_alone(clear: &mut Clear) {
        (clear.color_mask, clear.stencil) = (0, None);
    }

    #[test]
    fn a_segment_does_the_clears_of_all_pixels_in_front_of_it() {
        let all = |_: &mut Clear| ();
        let color = |c: &mut Clear| (c.depth, c.stencil) = (None, None);
        let corner = |c: &mut Clear| c.max = [63, 64];
        let red = |c: &mut Clear| c.color_mask = 1;
        for (actions, expected) in [
            (vec![clear(0, all), draw(1, 0), draw(1, 9)], "a [CD!] [] "),
            (vec![clear(0, color), clear(1, |c| c.color_mask = 0), draw(2, 0)], "a a [CD!] "),
            // Depth without the stencil beside it, a channel alone, a corner: words are not written whole.
            (vec![clear(0, depth_alone), draw(1, 0)], "c [] "),
            (vec![clear(0, red), draw(1, 0)], "c [D] "),
            (vec![clear(0, corner), draw(1, 0)], "c [] "),
            // What stays cannot be done behind what is absorbed.
            (vec![clear(0, all), clear(1, corner), draw(2, 0)], "c c [] "),
            (vec![clear(0, corner), clear(1, all), draw(2, 0)], "c a [CD!] "),
            (vec![draw(0, 0), clear(1, color), draw(2, 7), clear(3, all)], "[] a [C!] c "),
        ] {
            assert_eq!(plan(actions, true).0, expected);
        }
        assert_eq!(plan(vec![clear(0, all), draw(1, 0)], false).0, "c [CD] ", "where segments do not write every pixel");
    }

    #[test]
    fn a_segment_that_fails_goes_on_at_its_clears() {
        let (_, places) = plan(vec![draw(0, 0), clear(1, |_| ()), clear(2, |_| ()), draw(3, 5)], true);
        let at = |step, primitive| Place { step, primitive };
        assert_eq!(places, [at(0, 0), at(1, 0), at(1, 0), at(1, 0)]);
    }
}
