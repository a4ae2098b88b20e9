//! Automatic mipmap generation (3.8.8): each level is the box-filtered half of the one above.

use std::sync::Arc;

use super::texture_object::{LevelImage, TextureObject};
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

/// The next smaller level: the mean of 2 x 2 x 2 texels (fewer where a dimension is 1); an odd last row is dropped.
fn half(image: &LevelImage) -> LevelImage {
    let size = image.size.map(|n| (n / 2).max(1));
    let step = image.size.map(|n| if n > 1 { 2 } else { 1 });
    let words = image.format.words();
    let mut texels = Vec::with_capacity(size.iter().map(|&n| n as usize).product::<usize>() * words);
    let at = |x: u32, y: u32, z: u32| ((z * image.size[1] + y) as usize * image.size[0] as usize + x as usize) * words;
    let count = step.iter().product::<u32>();
    for z in 0..size[2] {
        for y in 0..size[1] {
            for x in 0..size[0] {
                let mut sum = [0.0f32; 4];
                for k in 0..count {
                    let (dx, dy, dz) = (k % step[0], k / step[0] % step[1], k / (step[0] * step[1]));
                    let i = at(x * step[0] + dx, y * step[1] + dy, z * step[2] + dz);
                    let c = match image.format.texels() {
                        TexelFormat::Rgba8 => image.texels[i].to_le_bytes().map(f32::from),
                        TexelFormat::Rgba32f => [0, 1, 2, 3].map(|k| f32::from_bits(image.texels[i + k])),
                    };
                    sum = std::array::from_fn(|k| sum[k] + c[k]);
                }
                let mean = sum.map(|s| s / count as f32);
                match image.format.texels() {
                    TexelFormat::Rgba8 => texels.push(u32::from_le_bytes(mean.map(|c| (c + 0.5) as u8))),
                    TexelFormat::Rgba32f => texels.extend(mean.map(f32::to_bits)),
                }
            }
        }
    }
    LevelImage { size, internal_format: image.internal_format, format: image.format, texels: Arc::new(texels) }
}
