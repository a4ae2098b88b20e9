//! Automatic mipmap generation (3.8.8): each level is the box-filtered half of the one above.

use std::sync::Arc;

use super::enums::*;
use super::pixel_format::Groups;
use super::texture_object::{LevelImage, TextureObject, kind_of};
use super::texture_planes::LayerPlanes;
use super::{Context, dirty};
use crate::draw::texture::TexelFormat;

impl TextureObject {
    /// After a change of an image: with GL_GENERATE_MIPMAP on, a change of the base level makes all levels below it.
    pub(crate) fn generate_mipmaps_after(&mut self, face: usize, level: usize) {
        if self.generate_mipmap && level as i64 == self.base_level as i64 {
            self.generate_mipmaps(face);
        }
    }

    /// Makes the levels from the base level + 1 to the last one of a face.
    pub(crate) fn generate_mipmaps(&mut self, face: usize) {
        let Ok(base) = usize::try_from(self.base_level) else { return };
        let mut level = base;
        while let Some(image) = self.image(face, level) {
            if image.size.iter().all(|&n| n <= 1) || level as i64 >= self.max_level as i64 || image.size.contains(&0) {
                break;
            }
            let half = half(image);
            level += 1;
            self.set_image(face, level, half);
        }
    }
}

impl Context {
    /// glGenerateMipmap (ARB_framebuffer_object, 3.8.8): makes the levels below the base level of the texture that is bound to a target.
    pub fn generate_mipmap(&mut self, target: GLenum) {
        if self.inside_begin_end() {
            return;
        }
        let Some(kind) = kind_of(target) else { return self.set_error(GL_INVALID_ENUM, "glGenerateMipmap: target") };
        self.settle_texture(kind);
        if !self.with_texture(kind, |object| object.has_base()) {
            return self.set_error(GL_INVALID_OPERATION, "glGenerateMipmap without a base level, or of a cube map whose faces differ");
        }
        if self.fbo.draw != 0 {
            // A smaller level may be attached.
            self.framebuffer_changes();
        }
        self.with_texture(kind, |object| (0..object.faces.len()).for_each(|face| object.generate_mipmaps(face)));
        self.dirty |= dirty::TEXTURE;
    }
}

/// Where a texel of the smaller level lies on one axis of the larger one: two texels and the weight of the second.
fn taps(size: u32, half: u32) -> Vec<([usize; 2], f32)> {
    let last = size as usize - 1;
    (0..half)
        .map(|i| {
            let at = ((i as f32 + 0.5) * (size as f32 / half as f32) - 0.5).max(0.0);
            ([at as usize, (at as usize + 1).min(last)], at.fract())
        })
        .collect()
}

/// The same of depths; stencil values are those of the first texel.
fn half_depth(image: &LevelImage, size: [u32; 3], [xs, ys]: [&[([usize; 2], f32)]; 2]) -> LevelImage {
    let width = image.size[0] as usize;
    let stored = image.format.depth();
    let number = |word: u32| if stored.is_float() { f32::from_bits(word).into() } else { f64::from(word & stored.mask()) };
    let word = |mean: f64| if stored.is_float() { (mean as f32).to_bits() } else { mean.round() as u32 };
    let depth = |x: usize, y: usize| number(image.texels[y * width + x]);
    let mix = |a: f64, b: f64, t: f32| a + (b - a) * f64::from(t);
    let mut texels = Vec::with_capacity(xs.len() * ys.len());
    for &([y0, y1], ty) in ys {
        for &([x0, x1], tx) in xs {
            let mean = mix(mix(depth(x0, y0), depth(x1, y0), tx), mix(depth(x0, y1), depth(x1, y1), tx), ty);
            texels.push(word(mean) | image.texels[y0 * width + x0] & !stored.mask());
        }
    }
    let (internal_format, format) = (image.internal_format, image.format);
    LevelImage { size, internal_format, format, texels: Arc::new(texels), planes: LayerPlanes::default() }
}

/// The next smaller level: linear filtering at the centres of its texels, which is the mean of 2 x 2 x 2 where sizes are
/// even, and what Mesa does where they are odd.
fn half(image: &LevelImage) -> LevelImage {
    let size = image.size.map(|n| (n / 2).max(1));
    let words = image.format.words();
    let [xs, ys, zs] = [0, 1, 2].map(|k| taps(image.size[k], size[k]));
    let [width, height] = [image.size[0] as usize, image.size[1] as usize];
    let texel = |x: usize, y: usize, z: usize| -> [f32; 4] {
        let i = ((z * height + y) * width + x) * words;
        match image.format.texels() {
            TexelFormat::Rgba8 => image.texels[i].to_le_bytes().map(f32::from),
            TexelFormat::Rgba32f => [0, 1, 2, 3].map(|k| f32::from_bits(image.texels[i + k])),
        }
    };
    if image.format.is_depth() {
        return half_depth(image, size, [&xs, &ys]);
    }
    let mix = |a: [f32; 4], b: [f32; 4], t: f32| -> [f32; 4] { std::array::from_fn(|k| a[k] + (b[k] - a[k]) * t) };
    let mut pixels = Vec::with_capacity(xs.len() * ys.len() * zs.len());
    for &([z0, z1], tz) in &zs {
        for &([y0, y1], ty) in &ys {
            for &([x0, x1], tx) in &xs {
                let row = |y, z| mix(texel(x0, y, z), texel(x1, y, z), tx);
                let plane = |z| if ty == 0.0 { row(y0, z) } else { mix(row(y0, z), row(y1, z), ty) };
                pixels.push(if tz == 0.0 { plane(z0) } else { mix(plane(z0), plane(z1), tz) });
            }
        }
    }
    let texels = match image.format.texels() {
        TexelFormat::Rgba8 => {
            let rounded = pixels.iter().map(|c| u32::from_le_bytes(c.map(|c| (c + 0.5) as u8))).collect();
            image.format.store(Groups::Rgba8(rounded))
        }
        TexelFormat::Rgba32f => pixels.iter().flat_map(|c| c.map(f32::to_bits)).collect(),
    };
    LevelImage {
        size,
        internal_format: image.internal_format,
        format: image.format,
        texels: Arc::new(texels),
        planes: LayerPlanes::default(),
    }
}
