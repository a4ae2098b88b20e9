//! The fine stage on surfaces with several samples a pixel: coverage, depth and stencil by sample, colour once a pixel, at its centre.
//!
//! A bin holds its samples one after the other, so that the routines of one sample serve all of them.

use super::fine::{Extent, Row, Scene, Worker, depth, direct_color, queue, row8};
use super::hi_z::Nearest;
use super::layout::*;
use super::plan::Plan;
use super::simd::{Level, Simd};
use super::store::{BIN_PIXELS, BinPixels};
use super::tile::{FULL, LocalEdges};
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
    /// Samples have depths of their own, not the pixel's.
    pub several: bool,
}

fn union(covered: &Covered) -> u32 {
    covered.iter().fold(0, |all, &s| all | s as u32)
}

/// Where planes are evaluated for a sample of eight pixels.
#[inline(always)]
fn sample_place<S: Simd>(plan: &Plan, place: [i32; 2], [x, y]: [i32; 2]) -> (S::F, S::F) {
    let columns = S::add(S::f(place[0] as f32 + plan.centre), S::load(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]));
    (S::add(columns, S::f(x as f32 / 16.0)), S::f(place[1] as f32 + plan.centre + y as f32 / 16.0))
}

/// Walks the tiles of a triangle in a bin.
#[inline(always)]
pub fn tiles<S: Simd>(worker: &mut Worker, scene: &Scene, plan: &Plan, t: &Triangle, planes: &[[f32; 4]], bin: &mut BinPixels) {
    let [ox, oy] = bin.origin;
    let count = scene.format.samples as usize;
    let several = t.flags & triangle_flags::MULTISAMPLE != 0;
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
    let mut offsets = [[0; 8]; MAX_SAMPLES as usize];
    if several {
        for (offsets, &place) in offsets.iter_mut().zip(positions(scene.format.samples)) {
            S::store_u(centre.offset(place), offsets);
        }
    }
    let extent = Extent::new(plan, t, bin);
    let near = Nearest::<S>::new(plan, t, planes, bin.origin);
    for ty in extent.tiles(extent.rows) {
        let (first, last) = extent.rows_of(ty);
        let mut tiles = extent.tile_columns();
        if plan.hi_z {
            tiles = worker.hi_z.visible::<S>(plan, planes, &near, tiles, ty, bin);
        }
        while tiles != 0 {
            let tx = tiles.trailing_zeros() as i32;
            tiles &= tiles - 1;
            let Some(reached) = all.rows(tx * 8, ty * 8, first) else { continue };
            let allowed = extent.allowed(scene, plan, t, tx, ty);
            let full = reached.full && allowed == FULL;
            let mut masks = [0; MAX_SAMPLES as usize];
            reached.masks(first, last, &offsets, &mut masks[..count]);
            for (s, mask) in masks[..count].iter_mut().enumerate() {
                *mask &= if plan.state.dropped_samples >> s & 1 != 0 { 0 } else { allowed };
            }
            let mut left = masks.iter().fold(0, |all, mask| all | mask);
            worker.tiles[!full as usize] += (left != 0) as u64;
            worker.hi_z.wrote((ty * 8 + tx) as usize, left.count_ones());
            while left != 0 {
                let row = left.trailing_zeros() as i32 / 8;
                left &= !(0xff << (8 * row));
                let place = Place {
                    pixel: ((ty * 8 + tx) * 64 + row * 8) as usize,
                    place: [ox + tx * 8, oy + ty * 8 + row],
                    front: t.flags & triangle_flags::FRONT != 0,
                    several,
                };
                row_of_samples::<S>(worker, scene, plan, t, planes, bin, place, masks.map(|mask| (mask >> (8 * row)) as u8));
            }
        }
    }
}

#[inline(always)]
#[allow(clippy::too_many_arguments)]
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
            let Place { pixel, place, several, .. } = place;
            let row = Row { at: pixel as u32, mask, place, samples: covered, several, ..Row::default() };
            queue::<S>(worker, scene, t, bin, row);
        }
    }
}

/// Stencil and depth test of each sample; those that fail are taken out. `computed`: the program's depth.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
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
                let (x, y) = sample_place::<S>(plan, place.place, if place.several { at } else { [0, 0] });
                depth::<S>(plan, planes, x, y)
            },
        );
        let words = row8(bin.depth_stencil, s * BIN_PIXELS + place.pixel);
        covered[s] = S::signs(depth_stencil::test::<S>(plan, place.front, z, S::mask(covered[s] as u32), words)) as u8;
    }
}

/// The operations after the colour is known, sample by sample.
#[inline(always)]
#[allow(clippy::too_many_arguments)]
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
