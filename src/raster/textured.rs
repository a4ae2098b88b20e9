//! Opaque fragments of one modulated texture, without detours: RGBA8 is written whole, depth is LESS or LEQUAL with writes or not there
//! at all. Depth is tested and written row by row, then fragments wait until there are enough of them; colours go to their pixels one by
//! one, in order. The same values as the general routine of [`super::fine`].

use super::fast::{DEPTH, DepthRow, Tile};
use super::fine::{Scene, row8};
use super::modulate::{self, Colors, Fragments, Source};
use super::plan::Plan;
use super::simd::{Simd, columns_from, eight, eight_mut};
use super::store::{BIN_PIXELS, BinPixels};
use super::tile::FULL;
use crate::program::lanes::LANES;

/// Draws the covered pixels of a tile: the rows that were written; `None` where nothing is covered.
#[inline(always)]
pub fn tile<S: Simd, const MODE: u32>(
    fragments: &mut Fragments,
    scene: &Scene,
    plan: &Plan,
    draw: u32,
    source: Source,
    planes: &[[f32; 4]],
    bin: &mut BinPixels,
    tile: Tile<S>,
) -> Option<u32> {
    let Tile { at, place, mut edges, rows: [first, last], allowed } = tile;
    let lod = plan.modulate.is_some_and(|what| what.lod);
    let x = columns_from::<S>(place[0] as f32);
    let depth = DepthRow::<S>::new(planes, x);
    let (mut touched, mut written) = (false, 0);
    // Two rows at a time, those of a quad: neither waits for the other, and rows beyond the triangle's are just not covered.
    let mut row = (first & !1) - 2;
    while row + 2 <= last {
        row += 2;
        let mut outside = [edges.next_row(), edges.next_row()];
        if allowed != FULL {
            for k in 0..2 {
                outside[k] = S::or(outside[k], S::mask(!(allowed >> (8 * row + 8 * k as i32)) as u32));
            }
        }
        if (S::signs(outside[0]) & S::signs(outside[1])) == 0xff {
            continue;
        }
        touched = true;
        let pixel = at + row as usize * 8;
        if MODE & DEPTH != 0 {
            for k in 0..2 {
                let y = S::f((place[1] + row + k as i32) as f32);
                outside[k] = depth.test(plan, y, outside[k], row8(bin.depth_stencil, pixel + 8 * k));
            }
        }
        let masks = !(S::signs(outside[0]) | S::signs(outside[1]) << 8) & 0xffff;
        if masks != 0 {
            written += 2;
            fragments.push::<S>(source, pixel as u32, masks, lod);
            if fragments.crowded() {
                flush::<S>(fragments, scene, draw, bin);
            }
        }
    }
    touched.then_some(written)
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
    if let (Some(what), Some(texture)) = (plan.modulate, scene.texture(plan)) {
        modulate::run::<S>(scene, plan, what, texture, fragments, bin.origin, Colors::Bytes);
        let pixels: &mut [u32; BIN_PIXELS] = bin.color.first_chunk_mut().expect("a bin");
        for first in (0..fragments.count).step_by(LANES) {
            let (at, colors) = (eight(&fragments.at, first), eight(&fragments.bytes, first));
            let count = (fragments.count - first).min(LANES);
            // Neighbours, as most are in large triangles, go together.
            let neighbours = S::iadd(S::i(at[0] as i32), S::load_u(&[0, 1, 2, 3, 4, 5, 6, 7]));
            if fragments.is_row(first / LANES) || count == LANES && S::signs(S::eq(S::load_u(at), neighbours)) == 0xff {
                *eight_mut(pixels, at[0] as usize % BIN_PIXELS) = *colors;
                continue;
            }
            for (&at, &color) in at.iter().zip(colors).take(count) {
                pixels[at as usize % BIN_PIXELS] = color;
            }
        }
    }
    fragments.clear();
}
