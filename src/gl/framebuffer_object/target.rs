//! Where draws go: the window, or the images of the bound framebuffer object.

use std::sync::Arc;

use super::{Framebuffer, ImageFormat};
use crate::device::plane::{self, Rows};
use crate::device::{ColorFormat, DepthFormat, Device, Pixels, PlaneFormat, SharedPlane, Surface, SurfaceFormat, Target};
use crate::draw::Batch;
use crate::gl::enums::*;
use crate::gl::framebuffer_object::Aspect;
use crate::gl::{Context, dirty};

/// The images of the draw framebuffer, as they were when it was last looked at.
pub(crate) struct View {
    /// What it is made of may have changed since.
    pub stale: bool,
    /// Something can be drawn; so it is with the window.
    complete: bool,
    /// The part that all images have.
    size: [u32; 2],
    /// Depth and stencil are there only where they are attached.
    format: SurfaceFormat,
    /// Of each draw buffer that is not GL_NONE.
    colors: Vec<(SharedPlane, ImageFormat)>,
    depth: Option<SharedPlane>,
    surface: Option<Box<dyn Surface>>,
    /// What takes the colours where there is no draw buffer.
    nowhere: Option<SharedPlane>,
}

impl Default for View {
    fn default() -> View {
        View {
            stale: true,
            complete: false,
            size: [0; 2],
            format: NO_BUFFERS,
            colors: Vec::new(),
            depth: None,
            surface: None,
            nowhere: None,
        }
    }
}

const NO_BUFFERS: SurfaceFormat =
    SurfaceFormat { color: ColorFormat::Rgba8, depth: DepthFormat::None, stencil: false, top_first: false, samples: 1 };

impl View {
    /// The components that drawing changes in some draw buffer.
    fn color_mask(&self) -> u32 {
        self.colors.iter().fold(0, |mask, (_, format)| mask | format.color_mask())
    }

    /// Waits until all that was drawn is in the planes.
    pub fn settle(&mut self) {
        if let Some(surface) = &mut self.surface {
            surface.settle();
        }
    }

    /// Draws a batch. There is one colour plane at a time: for each further draw buffer all is drawn once more, on the same depth and
    /// stencil as the first time.
    pub fn execute(&mut self, device: &dyn Device, batch: Batch) {
        let depth = self.depth.clone();
        let before = (self.colors.len() > 1).then(|| depth.as_ref().map(|d| plane::lock(d).rows().to_vec())).flatten();
        let mask = self.color_mask();
        let colors = self.colors.clone();
        let Some(((last, last_format), others)) = colors.split_last() else {
            let (size, samples) = (self.size, self.format.samples);
            let fits = self.nowhere.take().filter(|p| {
                let plane = plane::lock(p);
                plane.size == size && plane.samples == samples
            });
            let nowhere = fits.unwrap_or_else(|| device.plane(size, samples, PlaneFormat::Color(ColorFormat::Rgba8)));
            self.nowhere = Some(nowhere.clone());
            return self.draw(device, &nowhere, batch);
        };
        for (color, format) in others {
            self.draw(device, color, batch.clone());
            self.settle();
            if let (Some(depth), Some(before)) = (&depth, &before) {
                plane::lock(depth).rows_mut().copy_from_slice(before);
            }
            restore_missing(color, *format, mask);
        }
        self.draw(device, last, batch);
        if mask != last_format.color_mask() {
            self.settle();
            restore_missing(last, *last_format, mask);
        }
    }

    fn draw(&mut self, device: &dyn Device, color: &SharedPlane, batch: Batch) {
        // Planes that are larger than the part that all have are drawn through copies.
        let color_cut = cut(device, color, self.size);
        let depth_cut = self.depth.as_ref().and_then(|depth| cut(device, depth, self.size));
        let depth = depth_cut.as_ref().or(self.depth.as_ref());
        let target = Target::new(color_cut.as_ref().unwrap_or(color).clone(), depth.cloned(), false);
        let surface = match &mut self.surface {
            Some(surface) => {
                if !same_planes(surface.target(), &target) {
                    device.retarget(surface, target);
                }
                surface
            }
            none => none.insert(device.surface_on(target)),
        };
        surface.execute(batch);
        if color_cut.is_some() || depth_cut.is_some() {
            surface.settle();
        }
        if let Some(cut) = color_cut {
            copy_common(&cut, color);
        }
        if let (Some(cut), Some(depth)) = (depth_cut, &self.depth) {
            copy_common(&cut, depth);
        }
    }
}

fn same_planes(a: &Target, b: &Target) -> bool {
    let same_depth = match (&a.depth, &b.depth) {
        (Some(a), Some(b)) => Arc::ptr_eq(a, b),
        (None, None) => true,
        _ => false,
    };
    Arc::ptr_eq(&a.color, &b.color) && same_depth && a.size == b.size
}

/// A copy of the first columns and rows of a plane; `None` where that is all of it.
fn cut(device: &dyn Device, from: &SharedPlane, size: [u32; 2]) -> Option<SharedPlane> {
    let (whole, samples, format) = {
        let plane = plane::lock(from);
        (plane.size, plane.samples, plane.format)
    };
    (whole != size).then(|| {
        let part = device.plane(size, samples, format);
        copy_common(from, &part);
        part
    })
}

/// Copies the columns and rows that two planes of one format have in common.
fn copy_common(from: &SharedPlane, to: &SharedPlane) {
    let (mut from, mut to) = (plane::lock(from), plane::lock(to));
    let (samples, words) = (to.samples.min(from.samples) as usize, to.format.words());
    let [from_size, to_size] = [from.size, to.size].map(|size| size.map(|n| n as usize));
    let (width, height) = (from_size[0].min(to_size[0]), from_size[1].min(to_size[1]));
    let (source, out) = (from.rows(), to.rows_mut());
    for sample in 0..samples {
        for y in 0..height {
            let a = (sample * from_size[1] + y) * from_size[0] * words;
            let b = (sample * to_size[1] + y) * to_size[0] * words;
            out[b..b + width * words].copy_from_slice(&source[a..a + width * words]);
        }
    }
}

/// A draw buffer was drawn to with another one that has components which it lacks: gives those their values back.
fn restore_missing(color: &SharedPlane, format: ImageFormat, mask: u32) {
    let missing = mask & !format.color_mask();
    if missing == 0 {
        return;
    }
    let mut plane = plane::lock(color);
    let wide = plane.format == PlaneFormat::Color(ColorFormat::Rgba16);
    let blank = format.blank();
    let words = plane.format.words();
    let bits = |word: usize| match (wide, word) {
        (true, word) => (0..2).filter(|k| missing >> (2 * word + k) & 1 != 0).fold(0, |all, k| all | 0xffffu32 << (16 * k)),
        (false, _) => (0..4).filter(|k| missing >> k & 1 != 0).fold(0, |all, k| all | 0xffu32 << (8 * k)),
    };
    for pixel in plane.rows_mut().chunks_exact_mut(words) {
        for (k, word) in pixel.iter_mut().enumerate() {
            *word = *word & !bits(k) | blank[k.min(1)] & bits(k);
        }
    }
}

/// The pixels of one plane, bottom row first.
pub(super) fn pixels_of(plane: &SharedPlane) -> Pixels<'_> {
    let mut plane = plane::lock(plane);
    // Brings the rows up to date.
    plane.rows();
    let ([width, height], samples) = (plane.size, plane.samples);
    let format = SurfaceFormat { samples, ..NO_BUFFERS };
    match plane.format {
        PlaneFormat::Color(color) => {
            Pixels { width, height, format: SurfaceFormat { color, ..format }, color: Rows::Of(plane), depth_stencil: Rows::Nothing }
        }
        PlaneFormat::DepthStencil { depth, stencil } => Pixels {
            width,
            height,
            format: SurfaceFormat { depth, stencil, ..format },
            color: Rows::Nothing,
            depth_stencil: Rows::Of(plane),
        },
    }
}

impl Context {
    /// True where the draw framebuffer is complete; else GL_INVALID_FRAMEBUFFER_OPERATION is recorded.
    #[inline]
    pub(crate) fn can_draw(&mut self, what: &str) -> bool {
        if !self.looks_complete() {
            self.set_error(GL_INVALID_FRAMEBUFFER_OPERATION, what);
        }
        self.fbo.view.complete
    }

    /// The same without the error.
    #[inline]
    pub(crate) fn looks_complete(&mut self) -> bool {
        if self.fbo.view.stale {
            self.look_at_framebuffer();
        }
        self.fbo.view.complete
    }

    #[cold]
    fn look_at_framebuffer(&mut self) {
        self.fbo.view.settle();
        let name = self.fbo.draw;
        let complete = name == 0 || self.framebuffer_status(name) == GL_FRAMEBUFFER_COMPLETE;
        let (mut colors, mut depth_plane) = (Vec::new(), None);
        let (mut size, mut format) = ([u32::MAX; 2], NO_BUFFERS);
        if let Some(framebuffer) = self.fbo.get(name).filter(|_| complete) {
            for image in framebuffer.attachments().filter_map(|a| self.attached_image(a)) {
                size = [size[0].min(image.size[0]), size[1].min(image.size[1])];
                format.samples = image.samples.max(1);
            }
            let Framebuffer { depth, stencil, draw_buffers, .. } = framebuffer;
            for attachment in draw_buffers.iter().filter_map(|&buffer| framebuffer.color_of(buffer)) {
                if let (Some(plane), Some(image)) = (self.attached_plane(attachment), self.attached_image(attachment)) {
                    colors.push((plane, image.format));
                }
            }
            if let Some((PlaneFormat::Color(color), _)) = colors.first().map(|(_, image)| (image.plane, ())) {
                format.color = color;
            }
            depth_plane = depth.as_ref().or(stencil.as_ref()).and_then(|a| self.attached_plane(a));
            if let Some(PlaneFormat::DepthStencil { depth: stored, .. }) = depth_plane.as_ref().map(|p| plane::lock(p).format) {
                format.depth = if depth.is_some() { stored } else { DepthFormat::None };
                format.stencil = stencil.is_some();
            }
        }
        // Where there is no image, there is no place to draw to.
        let size = size.map(|n| if n == u32::MAX { 0 } else { n });
        let view = &mut self.fbo.view;
        (view.stale, view.complete, view.size, view.format) = (false, complete, size, format);
        (view.colors, view.depth) = (colors, depth_plane);
        self.dirty = dirty::ALL;
    }

    /// Columns and rows that can be drawn to.
    pub(crate) fn draw_size(&self) -> [u32; 2] {
        if self.fbo.draw == 0 { self.window_size } else { self.fbo.view.size }
    }

    /// What is drawn to: depth and stencil only where they can be used.
    pub(crate) fn draw_format(&self) -> SurfaceFormat {
        if self.fbo.draw == 0 { self.config.surface_format() } else { self.fbo.view.format }
    }

    /// There is something to draw to.
    pub(crate) fn has_draw_surface(&self) -> bool {
        self.fbo.draw != 0 || self.window.is_some()
    }

    /// Some draw buffer is there.
    pub(crate) fn draws_color(&self) -> bool {
        match self.fbo.get(self.fbo.draw) {
            Some(_) => !self.fbo.view.colors.is_empty(),
            None => self.state.color_buffer.draw_buffers.iter().any(|&buffer| buffer != GL_NONE),
        }
    }

    /// Bits 0 to 3: red, green, blue, alpha reach the draw buffers.
    pub(crate) fn color_write_mask(&self) -> u32 {
        if !self.draws_color() {
            return 0;
        }
        let wanted = self.state.color_buffer.color_mask.iter().enumerate().fold(0, |mask, (k, &on)| mask | (on as u32) << k);
        if self.fbo.draw == 0 { wanted } else { wanted & self.fbo.view.color_mask() }
    }

    /// GL_SAMPLES of what is drawn to.
    pub(crate) fn draw_samples(&self) -> u32 {
        let samples = self.draw_format().samples;
        if samples > 1 { samples } else { 0 }
    }

    /// Resolves all of what is read into all of what is drawn to, framebuffer objects of RGBA8 and one size; false where that is not
    /// what there is, or the device leaves it to the caller.
    pub(crate) fn resolve_on_device(&mut self) -> bool {
        self.flush_batch();
        self.fbo.view.settle();
        let Some((from, format)) = self.read_plane() else { return false };
        let View { colors, size, .. } = &self.fbo.view;
        let plain = format.base == GL_RGBA && format.bits[..4] == [8; 4] && plane::lock(&from).size == *size;
        match &colors[..] {
            [(to, same)] if self.fbo.draw != 0 && plain && *same == format => self.device.resolve(&from, to),
            _ => false,
        }
    }

    /// Runs `f` on the pixels that are drawn to, with the mask of the components that may change: once for each draw buffer, or for
    /// depth and stencil.
    pub(crate) fn change_pixels(&mut self, aspect: Aspect, mut f: impl FnMut(&mut Pixels, u32)) {
        let mask = self.color_write_mask();
        self.change_all_pixels(aspect, |pixels, there| f(pixels, there & mask));
    }

    /// The same whatever the colour mask says: with the mask of the components that are there.
    pub(crate) fn change_all_pixels(&mut self, aspect: Aspect, mut f: impl FnMut(&mut Pixels, u32)) {
        self.flush_batch();
        if self.fbo.draw == 0 {
            self.window_changed = true;
            if let Some(window) = &mut self.window {
                f(&mut window.pixels(), 0b1111);
            }
            return;
        }
        self.fbo.view.settle();
        if aspect == Aspect::Color {
            for (plane, format) in &self.fbo.view.colors {
                f(&mut pixels_of(plane), format.color_mask());
            }
        } else if let Some(depth) = &self.fbo.view.depth {
            f(&mut pixels_of(depth), 0);
        }
    }
}
