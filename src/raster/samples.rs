//! The fine stage on surfaces with several samples a pixel: coverage, depth and stencil by sample, colour once a pixel, at its centre.
//!
//! A bin holds its samples one after the other, so that the routines of one sample serve all of them.

use super::fine::{Row, Scene, Worker, depth, direct_color, queue, row8};
use super::layout::*;
use super::plan::Plan;
use super::simd::{Level, Simd, columns_from};
use super::store::{BIN_PIXELS, BinPixels};
use super::tile::{FULL, LocalEdges};
use super::walk::Walk;
use super::write::{self, Color};
use super::{depth_stencil, fast, fast_samples};
use crate::device::samples::{MAX_SAMPLES, positions};

/// Which of eight pixels in a row, by sample.
type Covered = [u8; MAX_SAMPLES as usize];

/// A row of eight pixels of a bin.
#[derive(Clone, Copy)]
pub struct Place {
    /// Its first pixel in the bin.
    pub pixel: usize,
    /// The same on the surface.
    pub place: [i32; 2],
    /// It is of a front face.
    pub front: bool,
}

fn union(covered: &Covered) -> u32 {
    covered.iter().fold(0, |all, &s| all | s as u32)
}

/// Where planes are evaluated for a sample of eight pixels.
#[inline(always)]
fn sample_place<S: Simd>(plan: &Plan, place: [i32; 2], [x, y]: [i32; 2]) -> (S::F, S::F) {
    (S::add(columns_from::<S>(place[0] as f32 + plan.centre), S::f(x as f32 / 16.0)), S::f(place[1] as f32 + plan.centre + y as f32 / 16.0))
}

/// Walks the tiles of a triangle in a bin.
#[inline(always)]
pub fn tiles<S: Simd>(worker: &mut Worker, scene: &Scene, plan: &Plan, t: &Triangle, planes: &[[f32; 4]], bin: &mut BinPixels) {
    let [ox, oy] = bin.origin;
    let count = scene.format.samples as usize;
    let several = plan.multisampled();
    if several && plan.fast_samples != fast::NONE {
        return match count {
            // Unrolled, a level without the instructions only grows: a sample takes a few hundred of its own.
            4 if S::LEVEL != Level::Scalar => fast_samples::draw::<S, 4>(worker, scene, plan, t, planes, bin),
            _ => fast_samples::draw::<S, { MAX_SAMPLES as usize }>(worker, scene, plan, t, planes, bin),
        };
    }
    let centre = LocalEdges::<S>::new(t, ox, oy);
    let all = if several { centre.of_all_samples() } else { centre };
    // Without multisampling all are the centre.
    let offsets = if several { centre.offsets(positions(scene.format.samples)) } else { [[0; 8]; MAX_SAMPLES as usize] };
    let mut walk = Walk::<S>::new(plan, t, planes, bin, plan.hi_z);
    while let Some(spot) = walk.next(plan, planes, &mut worker.hi_z, bin) {
        let [first, last] = spot.rows;
        let Some(reached) = all.rows(spot.offset(), first) else { continue };
        let allowed = walk.allowed(scene, plan, t, spot);
        let full = reached.full && allowed == FULL;
        let mut masks = [0; MAX_SAMPLES as usize];
        reached.masks(first, last, &offsets, &mut masks[..count]);
        for (s, mask) in masks[..count].iter_mut().enumerate() {
            *mask &= if plan.state.dropped_samples >> s & 1 != 0 { 0 } else { allowed };
        }
        let mut left = masks.iter().fold(0, |all, mask| all | mask);
        worker.tiles[!full as usize] += (left != 0) as u64;
        worker.hi_z.wrote(spot.index(), left.count_ones());
        let [x, y] = spot.place(bin);
        while left != 0 {
            let row = left.trailing_zeros() as i32 / 8;
            left &= !(0xff << (8 * row));
            let pixel = spot.pixel() + row as usize * 8;
            let place = Place { pixel, place: [x, y + row], front: t.flags & triangle_flags::FRONT != 0 };
            row_of_samples::<S>(worker, scene, plan, t, planes, bin, place, masks.map(|mask| (mask >> (8 * row)) as u8));
        }
    }
}

#[inline(always)]
fn row_of_samples<S: Simd>(
    worker: &mut Worker,
    scene: &Scene,
    plan: &Plan,
    t: &Triangle,
    planes: &[[f32; 4]],
    bin: &mut BinPixels,
    place: Place,
    mut covered: Covered,
) {
    if plan.early && plan.tests {
        test::<S>(plan, scene, planes, bin, place, &mut covered, None);
    }
    let mask = union(&covered);
    if mask == 0 {
        return;
    }
    match plan.direct {
        Some(k) => {
            let (x, y) = sample_place::<S>(plan, place.place, [0, 0]);
            let color = direct_color::<S>(scene, plan, t, planes, k, x, y);
            write::<S>(plan, scene, planes, bin, place, covered, color, None);
        }
        None => {
            let Place { pixel, place, .. } = place;
            let row = Row { at: pixel as u32, mask, place, samples: covered, ..Row::default() };
            queue::<S>(worker, scene, t, bin, row);
        }
    }
}

/// Stencil and depth test of each sample; those that fail are taken out. `computed`: the program's depth.
#[inline(always)]
fn test<S: Simd>(
    plan: &Plan,
    scene: &Scene,
    planes: &[[f32; 4]],
    bin: &mut BinPixels,
    place: Place,
    covered: &mut Covered,
    computed: Option<S::I>,
) {
    for (s, &at) in positions(scene.format.samples).iter().enumerate() {
        if covered[s] == 0 {
            continue;
        }
        let z = computed.unwrap_or_else(
            #[inline(always)]
            || {
                let (x, y) = sample_place::<S>(plan, place.place, if plan.multisampled() { at } else { [0, 0] });
                depth::<S>(plan, planes, x, y)
            },
        );
        let words = row8(bin.depth_stencil, s * BIN_PIXELS + place.pixel);
        covered[s] = S::signs(depth_stencil::test::<S>(plan, place.front, z, S::mask(covered[s] as u32), words)) as u8;
    }
}

/// The operations after the colour is known, sample by sample.
#[inline(always)]
pub fn write<S: Simd>(
    plan: &Plan,
    scene: &Scene,
    planes: &[[f32; 4]],
    bin: &mut BinPixels,
    place: Place,
    mut covered: Covered,
    mut color: Color<S>,
    computed: Option<S::I>,
) {
    let state = plan.state;
    let count = scene.format.samples as usize;
    if state.flags & fragment_flags::ALPHA_TO_COVERAGE != 0 {
        let alpha = write::alpha::<S>(scene.format, &color);
        for (s, covered) in covered[..count].iter_mut().enumerate() {
            *covered &= S::signs(S::gt(alpha, S::i((255 * s / count) as i32))) as u8;
        }
    }
    let keep = write::passes_alpha::<S>(plan, scene.format, &color);
    if state.flags & fragment_flags::ALPHA_TO_ONE != 0 {
        color.bytes = S::or(color.bytes, S::i(0xff00_0000u32 as i32));
        color.columns[3] = S::f(1.0);
    }
    if let Some(keep) = keep {
        let keep = S::signs(keep) as u8;
        covered.iter_mut().for_each(|c| *c &= keep);
    }
    if !plan.early && plan.tests {
        test::<S>(plan, scene, planes, bin, place, &mut covered, computed);
    }
    if plan.write_mask == 0 {
        return;
    }
    for (s, &covered) in covered[..count].iter().enumerate() {
        if covered != 0 {
            write::write_color::<S>(plan, scene.format, bin, s * BIN_PIXELS + place.pixel, S::mask(covered as u32), &color);
        }
    }
}
