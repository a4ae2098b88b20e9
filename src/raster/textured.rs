//! Opaque fragments of one modulated texture, without detours: RGBA8 is written whole, depth is LESS or LEQUAL with writes or not there
//! at all. Depth is tested and written row by row, then fragments wait until there are enough of them; colours go to their pixels one by
//! one, in order. The same values as the general routine of [`super::fine`].

use super::fast::{DEPTH, DepthRow, Tile};
use super::fine::{Plan, Scene, row8};
use super::modulate::{self, Colors, Fragments, Source};
use super::simd::Simd;
use super::store::{BIN_PIXELS, BinPixels};
use super::tile::FULL;

/// Draws the covered pixels of a tile; false where there are none.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
pub fn tile<S: Simd, const MODE: u32>(
    fragments: &mut Fragments,
    scene: &Scene,
    plan: &Plan,
    draw: u32,
    source: Source,
    planes: &[[f32; 4]],
    bin: &mut BinPixels,
    tile: Tile<S>,
) -> bool {
    let Tile { at, place, mut edges, rows: [first, last], allowed } = tile;
    let lod = plan.modulate.is_some_and(|what| what.lod);
    let x = S::add(S::f(place[0] as f32), S::load(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]));
    let depth = DepthRow::<S>::new(planes, x);
    let mut touched = false;
    let mut masks = 0;
    for row in first..=last {
        let mut outside = edges.next();
        if allowed != FULL {
            outside = S::or(outside, S::mask(!(allowed >> (8 * row)) as u32));
        }
        let mut covered = !S::signs(outside) & 0xff;
        if covered != 0 {
            touched = true;
            if MODE & DEPTH != 0 {
                let y = S::f((place[1] + row) as f32);
                outside = depth.test(plan, y, outside, row8(bin.depth_stencil, at + row as usize * 8));
                covered = !S::signs(outside) & 0xff;
            }
        }
        masks |= covered << (8 * (row & 1));
        // Rows of a quad go together.
        if row & 1 == 1 || row == last {
            if masks != 0 {
                fragments.push::<S>(source, (at + (row as usize & !1) * 8) as u32, masks, lod);
                if fragments.crowded() {
                    flush::<S>(fragments, scene, draw, bin);
                }
            }
            masks = 0;
        }
    }
    touched
}

/// Colours and writes what waits.
#[inline(always)]
pub fn flush<S: Simd>(fragments: &mut Fragments, scene: &Scene, draw: u32, bin: &mut BinPixels) {
    if fragments.count != 0 {
        flush_at(S::LEVEL, fragments, scene, draw, bin);
    }
}

crate::dispatch! {
    /// [`flush_kernel`] at a level: one copy of it for all its callers.
    fn flush_at = flush_kernel<'a, 'b>(fragments: &mut Fragments, scene: &Scene<'a>, draw: u32, bin: &mut BinPixels<'b>)
}

#[inline(always)]
fn flush_kernel<S: Simd>(fragments: &mut Fragments, scene: &Scene, draw: u32, bin: &mut BinPixels) {
    let plan = &scene.plans[draw as usize];
    if let (Some(what), Some(binding)) = (plan.modulate, scene.batch.textures.get(plan.record.first_texture as usize)) {
        modulate::run::<S>(scene, plan, what, binding, fragments, bin.origin, Colors::Bytes);
        let pixels: &mut [u32; BIN_PIXELS] = bin.color.first_chunk_mut().expect("a bin");
        for (&at, &color) in fragments.at.iter().zip(&fragments.bytes).take(fragments.count) {
            pixels[at as usize % BIN_PIXELS] = color;
        }
    }
    fragments.clear();
}
