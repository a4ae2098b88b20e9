//! Textures as framebuffers draw into them: a plane a layer, beside the texels. Planes are made when a layer is first attached and drawn to.
//! Changes go from plane to texels ([`TextureObject::take_from_planes`]) before somebody looks at the texels, and from texels to planes
//! ([`TextureObject::give_to_planes`]) at once.

use std::sync::Arc;

use super::Context;
use super::framebuffer_object::ImageFormat;
use super::pixel_format::Groups;
use super::texture_format::InternalFormat;
use super::texture_object::{LevelImage, TextureObject};
use crate::device::{ColorFormat, Plane, PlaneFormat, SharedPlane, plane};
use crate::draw::texture::TextureKind;

/// The plane of one layer of a level.
#[derive(Clone)]
struct LayerPlane {
    layer: usize,
    plane: SharedPlane,
    /// The version of the plane that the texels show.
    version: u64,
}

/// The planes of the layers of a level that have one.
#[derive(Clone, Default)]
pub(crate) struct LayerPlanes(Vec<LayerPlane>);

impl std::fmt::Debug for LayerPlanes {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_list().entries(self.0.iter().map(|p| p.layer)).finish()
    }
}

/// Texels of a plane's pixels.
fn texels(format: InternalFormat, plane: &mut Plane) -> Vec<u32> {
    let kind = plane.format;
    let rows = plane.rows();
    match kind {
        PlaneFormat::DepthStencil { .. } => rows.to_vec(),
        PlaneFormat::Color(ColorFormat::Rgba16) => {
            let unorm = |v: u32| (v & 0xffff) as f32 / 65535.0;
            let pixel = |p: &[u32]| [unorm(p[0]), unorm(p[0] >> 16), unorm(p[1]), unorm(p[1] >> 16)];
            format.store(Groups::Rgba(rows.chunks_exact(2).map(pixel).collect()))
        }
        PlaneFormat::Color(_) => format.store(Groups::Rgba8(rows.to_vec())),
    }
}

/// Pixels of a plane from texels.
fn fill(plane: &mut Plane, texels: &[u32]) {
    match plane.format {
        PlaneFormat::Color(ColorFormat::Rgba16) => {
            let unorm = |word: u32| (f32::from_bits(word).clamp(0.0, 1.0) * 65535.0).round_ties_even() as u32;
            for (out, texel) in plane.rows_mut().chunks_exact_mut(2).zip(texels.chunks_exact(4)) {
                (out[0], out[1]) = (unorm(texel[0]) | unorm(texel[1]) << 16, unorm(texel[2]) | unorm(texel[3]) << 16);
            }
        }
        _ => plane.rows_mut().copy_from_slice(texels),
    }
}

impl LevelImage {
    /// Words of a layer.
    fn layer_words(&self) -> usize {
        self.size[0] as usize * self.size[1] as usize * self.format.words()
    }

    /// The plane of a layer, which has to be there.
    fn plane(&mut self, layer: usize, new: impl FnOnce([u32; 2], ImageFormat) -> SharedPlane) -> SharedPlane {
        if let Some(there) = self.planes.0.iter().find(|p| p.layer == layer) {
            return there.plane.clone();
        }
        let made = new([self.size[0], self.size[1]], ImageFormat::of_texture(self.format));
        let words = self.layer_words();
        let version = {
            let mut plane = plane::lock(&made);
            fill(&mut plane, &self.texels[layer * words..(layer + 1) * words]);
            plane.version()
        };
        self.planes.0.push(LayerPlane { layer, plane: made.clone(), version });
        made
    }

    /// Brings the texels up to date; true where that changed some.
    fn take_from_planes(&mut self) -> bool {
        let (words, mut changed) = (self.layer_words(), false);
        for layer in &mut self.planes.0 {
            let mut plane = plane::lock(&layer.plane);
            if std::mem::replace(&mut layer.version, plane.version()) == plane.version() {
                continue;
            }
            let new = texels(self.format, &mut plane);
            // Copies first if a batch still reads the old texels.
            Arc::make_mut(&mut self.texels)[layer.layer * words..(layer.layer + 1) * words].copy_from_slice(&new);
            changed = true;
        }
        changed
    }

    fn give_to_planes(&mut self) {
        let words = self.layer_words();
        for layer in &mut self.planes.0 {
            let mut plane = plane::lock(&layer.plane);
            fill(&mut plane, &self.texels[layer.layer * words..(layer.layer + 1) * words]);
            layer.version = plane.version();
        }
    }
}

impl TextureObject {
    /// The plane of a layer, made by `new` where there is none yet. `None` where there is no such layer.
    pub(crate) fn plane(
        &mut self,
        [face, level, layer]: [usize; 3],
        new: impl FnOnce([u32; 2], ImageFormat) -> SharedPlane,
    ) -> Option<SharedPlane> {
        let image = self.faces.get_mut(face)?.get_mut(level)?.as_mut()?;
        if layer >= image.size[2] as usize {
            return None;
        }
        self.has_planes = true;
        Some(image.plane(layer, new))
    }

    /// Brings the texels of all levels up to date.
    pub(crate) fn take_from_planes(&mut self) {
        let mut changed = false;
        for image in self.faces.iter_mut().flatten().flatten() {
            changed |= image.take_from_planes();
        }
        if changed {
            self.levels_changed();
        }
    }

    /// The texels of a level changed: so do its planes.
    pub(crate) fn give_to_planes(&mut self, face: usize, level: usize) {
        if let Some(Some(image)) = self.faces.get_mut(face).and_then(|levels| levels.get_mut(level)) {
            image.give_to_planes();
        }
    }
}

impl Context {
    /// To be called before the images of the bound texture of a kind are read or changed: what was drawn into them is in their texels then.
    pub(crate) fn settle_texture(&mut self, kind: TextureKind) {
        if self.with_texture(kind, |object| object.has_planes) {
            self.flush_batch();
            self.fbo.view.settle();
            self.with_texture(kind, TextureObject::take_from_planes);
        }
    }

    /// Brings the texels of all textures that may be sampled up to date with what framebuffers drew into them.
    pub(crate) fn settle_sampled_textures(&mut self) {
        let kinds = [TextureKind::D1, TextureKind::D2, TextureKind::D3, TextureKind::Cube];
        for unit in 0..self.state.texture.units.len() {
            for kind in kinds {
                let state = &self.state.texture.units[unit];
                if !state.enabled[kind as usize] {
                    continue;
                }
                let name = state.bound[kind as usize];
                if self.shared().textures.object(kind, name).has_planes {
                    self.fbo.view.settle();
                    self.shared().textures.object(kind, name).take_from_planes();
                }
            }
        }
    }
}
