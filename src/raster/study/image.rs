//! Pixels in memory: linear or tiled, as a whole, by bins, or with locks.

use std::sync::{Mutex, PoisonError};

use rayon::prelude::*;

use super::shade::{Shader, shade_pixel, shade_row};
use super::{Layout, methods::Job};
use crate::raster::layout::BIN_SIZE;
use crate::raster::simd::Simd;
use crate::raster::store::{BIN_PIXELS, pixel_index};

/// Depth of a cleared pixel.
const FAR: u32 = 0xff_ffff;

/// Eight neighbouring pixels, the first at a multiple of eight: colour and depth.
#[derive(Clone, Copy)]
pub struct Group {
    color: [u32; 8],
    depth: [u32; 8],
}

/// Somewhere to draw: shades pixels of the group at (x, y), x a multiple of eight.
pub trait Dest {
    /// Those whose bit is set, at once.
    fn row<S: Simd>(&mut self, shader: &Shader, x: i32, y: i32, mask: u32);
    /// One of them.
    fn pixel(&mut self, shader: &Shader, x: i32, y: i32, lane: usize);
}

/// An image.
pub struct Image {
    /// Columns and rows of pixels.
    pub size: [u32; 2],
    /// Columns and rows of bins; memory holds whole bins.
    pub bins: [u32; 2],
    layout: Layout,
    color: Vec<u32>,
    depth: Vec<u32>,
    /// Instead of the two where groups are locked one by one.
    groups: Vec<Mutex<Group>>,
}

/// Pixels in one piece of memory.
pub struct Flat<'a> {
    color: &'a mut [u32],
    depth: &'a mut [u32],
    layout: Layout,
    /// Bins in a row of it.
    columns: u32,
    origin: [i32; 2],
}

/// A bin of a linear image: 64 pieces of rows.
pub struct Rows<'a> {
    color: Vec<&'a mut [u32]>,
    depth: Vec<&'a mut [u32]>,
    origin: [i32; 2],
}

/// Pixels that threads share.
#[derive(Clone)]
pub struct Shared<'a> {
    groups: &'a [Mutex<Group>],
    layout: Layout,
    columns: u32,
}

/// A bin of an image.
pub enum Bin<'a> {
    /// Of a tiled one.
    Tiled(Flat<'a>),
    /// Of a linear one.
    Linear(Rows<'a>),
}

/// Columns of bins of a job on a whole image.
pub fn columns(job: &Job) -> u32 {
    (job.region[2] as u32 + 1).div_ceil(BIN_SIZE)
}

#[inline(always)]
fn index(layout: Layout, columns: u32, x: u32, y: u32) -> usize {
    match layout {
        Layout::Linear => (y * columns * BIN_SIZE + x) as usize,
        Layout::Tiled => (y / BIN_SIZE * columns + x / BIN_SIZE) as usize * BIN_PIXELS + pixel_index(x % BIN_SIZE, y % BIN_SIZE),
    }
}

#[inline(always)]
fn eight(words: &mut [u32], at: usize) -> &mut [u32; 8] {
    (&mut words[at..at + 8]).try_into().expect("eight words")
}

impl Image {
    /// With `locked`, groups have locks.
    pub fn new(size: [u32; 2], layout: Layout, locked: bool) -> Image {
        let bins = size.map(|s| s.div_ceil(BIN_SIZE));
        let pixels = (bins[0] * bins[1]) as usize * BIN_PIXELS;
        let empty = Group { color: [0; 8], depth: [FAR; 8] };
        let own = if locked { 0 } else { pixels };
        let groups = (0..pixels / 8 * locked as usize).map(|_| Mutex::new(empty)).collect();
        Image { size, bins, layout, color: vec![0; own], depth: vec![FAR; own], groups }
    }

    /// Nothing drawn, everything far.
    pub fn clear(&mut self) {
        let empty = Group { color: [0; 8], depth: [FAR; 8] };
        self.color.par_chunks_mut(BIN_PIXELS).for_each(|c| c.fill(0));
        self.depth.par_chunks_mut(BIN_PIXELS).for_each(|d| d.fill(FAR));
        self.groups.par_iter_mut().with_min_len(512).for_each(|g| *g.get_mut().unwrap_or_else(PoisonError::into_inner) = empty);
    }

    /// Draws on all of it.
    pub fn whole(&mut self, draw: impl FnOnce(Flat)) {
        let Image { bins, layout, color, depth, .. } = self;
        draw(Flat { color, depth, layout: *layout, columns: bins[0], origin: [0; 2] });
    }

    /// Draws on all bins, on any thread.
    pub fn by_bins(&mut self, draw: impl Fn(usize, Bin) + Sync) {
        let columns = self.bins[0] as usize;
        let place = |k: usize| [k % columns, k / columns].map(|v| (v * BIN_SIZE as usize) as i32);
        let mut bins: Vec<Bin> = match self.layout {
            Layout::Tiled => (self.color.chunks_mut(BIN_PIXELS).zip(self.depth.chunks_mut(BIN_PIXELS)).enumerate())
                .map(|(k, (color, depth))| Bin::Tiled(Flat { color, depth, layout: Layout::Tiled, columns: 1, origin: place(k) }))
                .collect(),
            Layout::Linear => {
                let (color, depth) = (pieces(&mut self.color, columns), pieces(&mut self.depth, columns));
                let both = color.into_iter().zip(depth).enumerate();
                both.map(|(k, (color, depth))| Bin::Linear(Rows { color, depth, origin: place(k) })).collect()
            }
        };
        bins.par_drain(..).enumerate().with_max_len(1).for_each(|(k, bin)| draw(k, bin));
    }

    /// For all threads.
    pub fn shared(&self) -> Shared<'_> {
        Shared { groups: &self.groups, layout: self.layout, columns: self.bins[0] }
    }

    /// Colour and depth, row by row.
    pub fn pixels(&self) -> [Vec<u32>; 2] {
        let places = (0..self.size[1]).flat_map(|y| (0..self.size[0]).map(move |x| (x, y)));
        let at = |(x, y)| {
            let k = index(self.layout, self.bins[0], x, y);
            if self.groups.is_empty() {
                return (self.color[k], self.depth[k]);
            }
            let group = self.groups[k / 8].lock().unwrap_or_else(PoisonError::into_inner);
            (group.color[k % 8], group.depth[k % 8])
        };
        let (color, depth) = places.map(at).unzip();
        [color, depth]
    }
}

/// A linear image's memory by bins: 64 pieces of 64 words each.
fn pieces(words: &mut [u32], columns: usize) -> Vec<Vec<&mut [u32]>> {
    let mut bins = Vec::new();
    for band in words.chunks_mut(columns * BIN_PIXELS) {
        let first = bins.len();
        bins.resize_with(first + columns, || Vec::with_capacity(BIN_SIZE as usize));
        for (k, piece) in band.chunks_mut(BIN_SIZE as usize).enumerate() {
            bins[first + k % columns].push(piece);
        }
    }
    bins
}

impl Flat<'_> {
    #[inline(always)]
    fn group(&mut self, x: i32, y: i32) -> (&mut [u32; 8], &mut [u32; 8]) {
        let k = index(self.layout, self.columns, (x - self.origin[0]) as u32, (y - self.origin[1]) as u32);
        (eight(self.color, k), eight(self.depth, k))
    }
}

impl Rows<'_> {
    #[inline(always)]
    fn group(&mut self, x: i32, y: i32) -> (&mut [u32; 8], &mut [u32; 8]) {
        let (row, at) = ((y - self.origin[1]) as usize, (x - self.origin[0]) as usize);
        (eight(self.color[row], at), eight(self.depth[row], at))
    }
}

impl Dest for Flat<'_> {
    #[inline(always)]
    fn row<S: Simd>(&mut self, shader: &Shader, x: i32, y: i32, mask: u32) {
        let (color, depth) = self.group(x, y);
        shade_row::<S>(shader, [x, y], mask, color, depth);
    }

    #[inline(always)]
    fn pixel(&mut self, shader: &Shader, x: i32, y: i32, lane: usize) {
        let (color, depth) = self.group(x, y);
        shade_pixel(shader, [x + lane as i32, y], &mut color[lane], &mut depth[lane]);
    }
}

impl Dest for Rows<'_> {
    #[inline(always)]
    fn row<S: Simd>(&mut self, shader: &Shader, x: i32, y: i32, mask: u32) {
        let (color, depth) = self.group(x, y);
        shade_row::<S>(shader, [x, y], mask, color, depth);
    }

    #[inline(always)]
    fn pixel(&mut self, shader: &Shader, x: i32, y: i32, lane: usize) {
        let (color, depth) = self.group(x, y);
        shade_pixel(shader, [x + lane as i32, y], &mut color[lane], &mut depth[lane]);
    }
}

impl Shared<'_> {
    #[inline(always)]
    fn lock(&self, x: i32, y: i32) -> std::sync::MutexGuard<'_, Group> {
        let k = index(self.layout, self.columns, x as u32, y as u32) / 8;
        self.groups[k].lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl Dest for Shared<'_> {
    #[inline(always)]
    fn row<S: Simd>(&mut self, shader: &Shader, x: i32, y: i32, mask: u32) {
        let group = &mut *self.lock(x, y);
        shade_row::<S>(shader, [x, y], mask, &mut group.color, &mut group.depth);
    }

    #[inline(always)]
    fn pixel(&mut self, shader: &Shader, x: i32, y: i32, lane: usize) {
        let group = &mut *self.lock(x, y);
        shade_pixel(shader, [x + lane as i32, y], &mut group.color[lane], &mut group.depth[lane]);
    }
}
