//! Internal formats of textures: base format, precision, and how texels are stored (3.8.1).
//!
//! What each format keeps was measured on OSMesa: 4-bit luminance, alpha and intensity are kept with 8 bits,
//! GL_RGBA2 and GL_RGB4 with 4, GL_RGB5 with 5 each, 12-bit formats with 16.

use super::enums::*;
use super::framebuffer::depth_word;
use super::pixel_format::{Groups, widen};
use crate::device::DepthFormat;
use crate::draw::texture::TexelFormat;

/// An internal format.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct InternalFormat {
    /// GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_RGB, GL_RGBA, GL_DEPTH_COMPONENT or GL_DEPTH_STENCIL.
    pub base: GLenum,
    /// Bits kept of red, green, blue, alpha; luminance and intensity have red's. Of depth and stencil instead.
    pub bits: [u8; 4],
}

impl InternalFormat {
    /// The format of an enum (or of 1 to 4); None where GL 2.1 has none.
    pub fn from_enum(format: GLenum) -> Option<InternalFormat> {
        let (base, bits) = match format {
            1 | GL_LUMINANCE | GL_LUMINANCE4 | GL_LUMINANCE8 | GL_COMPRESSED_LUMINANCE => (GL_LUMINANCE, [8; 4]),
            GL_LUMINANCE12 | GL_LUMINANCE16 => (GL_LUMINANCE, [16; 4]),
            2 | GL_LUMINANCE_ALPHA | GL_LUMINANCE6_ALPHA2 | GL_LUMINANCE8_ALPHA8 | GL_COMPRESSED_LUMINANCE_ALPHA => {
                (GL_LUMINANCE_ALPHA, [8; 4])
            }
            GL_LUMINANCE4_ALPHA4 => (GL_LUMINANCE_ALPHA, [4; 4]),
            GL_LUMINANCE12_ALPHA4 | GL_LUMINANCE12_ALPHA12 | GL_LUMINANCE16_ALPHA16 => (GL_LUMINANCE_ALPHA, [16; 4]),
            GL_ALPHA | GL_ALPHA4 | GL_ALPHA8 | GL_COMPRESSED_ALPHA => (GL_ALPHA, [8; 4]),
            GL_ALPHA12 | GL_ALPHA16 => (GL_ALPHA, [16; 4]),
            GL_INTENSITY | GL_INTENSITY4 | GL_INTENSITY8 | GL_COMPRESSED_INTENSITY => (GL_INTENSITY, [8; 4]),
            GL_INTENSITY12 | GL_INTENSITY16 => (GL_INTENSITY, [16; 4]),
            3 | GL_RGB | GL_RGB8 | GL_COMPRESSED_RGB => (GL_RGB, [8; 4]),
            GL_R3_G3_B2 => (GL_RGB, [3, 3, 2, 0]),
            GL_RGB4 => (GL_RGB, [4; 4]),
            GL_RGB5 => (GL_RGB, [5; 4]),
            GL_RGB10 => (GL_RGB, [10; 4]),
            GL_RGB12 | GL_RGB16 => (GL_RGB, [16; 4]),
            4 | GL_RGBA | GL_RGBA8 | GL_COMPRESSED_RGBA => (GL_RGBA, [8; 4]),
            GL_RGBA2 | GL_RGBA4 => (GL_RGBA, [4; 4]),
            GL_RGB5_A1 => (GL_RGBA, [5, 5, 5, 1]),
            GL_RGB10_A2 => (GL_RGBA, [10, 10, 10, 2]),
            GL_RGBA12 | GL_RGBA16 => (GL_RGBA, [16; 4]),
            GL_DEPTH_COMPONENT16 => (GL_DEPTH_COMPONENT, [16, 0, 0, 0]),
            GL_DEPTH_COMPONENT | GL_DEPTH_COMPONENT24 | GL_DEPTH_COMPONENT32 => (GL_DEPTH_COMPONENT, [24, 0, 0, 0]),
            GL_DEPTH_COMPONENT32F => (GL_DEPTH_COMPONENT, [32, 0, 0, 0]),
            GL_DEPTH_STENCIL | GL_DEPTH24_STENCIL8 => (GL_DEPTH_STENCIL, [24, 8, 0, 0]),
            _ => return None,
        };
        Some(InternalFormat { base, bits })
    }

    /// Depth, perhaps with stencil, is kept, a word a texel: as planes hold it.
    pub fn is_depth(self) -> bool {
        matches!(self.base, GL_DEPTH_COMPONENT | GL_DEPTH_STENCIL)
    }

    /// How texels are sampled; those of colours are kept so as well.
    pub fn texels(self) -> TexelFormat {
        if self.bits.iter().all(|&b| b <= 8) { TexelFormat::Rgba8 } else { TexelFormat::Rgba32f }
    }

    /// Words a texel.
    pub fn words(self) -> usize {
        match self.texels() {
            _ if self.is_depth() => 1,
            TexelFormat::Rgba8 => 1,
            TexelFormat::Rgba32f => 4,
        }
    }

    /// GL_TEXTURE_*_SIZE
    pub fn size_of(self, component: GLenum) -> i32 {
        let [r, g, b, a] = self.bits.map(i32::from);
        let has = |bases: &[GLenum], bits| if bases.contains(&self.base) { bits } else { 0 };
        match component {
            GL_TEXTURE_RED_SIZE => has(&[GL_RGB, GL_RGBA], r),
            GL_TEXTURE_GREEN_SIZE => has(&[GL_RGB, GL_RGBA], g),
            GL_TEXTURE_BLUE_SIZE => has(&[GL_RGB, GL_RGBA], b),
            GL_TEXTURE_ALPHA_SIZE => has(&[GL_ALPHA, GL_LUMINANCE_ALPHA, GL_RGBA], a),
            GL_TEXTURE_LUMINANCE_SIZE => has(&[GL_LUMINANCE, GL_LUMINANCE_ALPHA], r),
            GL_TEXTURE_INTENSITY_SIZE => has(&[GL_INTENSITY], r),
            GL_TEXTURE_DEPTH_SIZE => has(&[GL_DEPTH_COMPONENT, GL_DEPTH_STENCIL], r),
            GL_TEXTURE_STENCIL_SIZE => has(&[GL_DEPTH_STENCIL], g),
            _ => 0,
        }
    }

    /// Texels of transferred colours, expanded by the base format and with no more precision than the format keeps.
    pub fn store(self, groups: Groups) -> Vec<u32> {
        match (groups, self.texels()) {
            (Groups::Depth(depths), _) => depths.into_iter().map(|d| depth_word(self.depth(), d)).collect(),
            (Groups::DepthStencil(words), _) if self.base == GL_DEPTH_STENCIL => words,
            (Groups::DepthStencil(words), _) => words.into_iter().map(|w| depth_word(self.depth(), DepthFormat::D24.depth(w))).collect(),
            (Groups::Rgba8(pixels), TexelFormat::Rgba8) => self.store_rgba8(pixels),
            (Groups::Rgba(pixels), TexelFormat::Rgba8) => self.store_rgba8(pixels.iter().map(|p| to_rgba8(*p)).collect()),
            (Groups::Rgba8(pixels), TexelFormat::Rgba32f) => {
                pixels.iter().flat_map(|p| self.store_float(p.to_le_bytes().map(|c| c as f32 / 255.0))).collect()
            }
            (Groups::Rgba(pixels), TexelFormat::Rgba32f) => pixels.iter().flat_map(|p| self.store_float(*p)).collect(),
            _ => Vec::new(),
        }
    }

    /// How depths are kept.
    pub fn depth(self) -> DepthFormat {
        match self.bits[0] {
            16 => DepthFormat::D16,
            32 => DepthFormat::F32,
            _ => DepthFormat::D24,
        }
    }

    /// Texels as they are sampled: depth as luminance, intensity or alpha (GL_DEPTH_TEXTURE_MODE).
    pub fn sampled(self, texels: &[u32], depth_mode: GLenum) -> Vec<u32> {
        let format = InternalFormat { base: depth_mode, bits: self.bits };
        texels
            .iter()
            .flat_map(|texel| {
                let depth = self.depth().depth(*texel) as f32;
                format.expand([depth, depth, depth, depth]).map(f32::to_bits)
            })
            .collect()
    }

    fn store_rgba8(self, mut pixels: Vec<u32>) -> Vec<u32> {
        if self.bits.iter().any(|&b| b < 8) {
            for pixel in &mut pixels {
                let mut c = pixel.to_le_bytes();
                for (c, &bits) in c.iter_mut().zip(&self.bits) {
                    if bits > 0 {
                        *c = widen((*c as u32 * ((1 << bits) - 1) + 127) / 255, bits as u32) as u8;
                    }
                }
                *pixel = u32::from_le_bytes(c);
            }
        }
        const OPAQUE: u32 = 0xff00_0000;
        match self.base {
            GL_ALPHA => pixels.iter_mut().for_each(|p| *p &= OPAQUE),
            GL_LUMINANCE => pixels.iter_mut().for_each(|p| *p = ((*p & 255) * 0x01_0101) | OPAQUE),
            GL_LUMINANCE_ALPHA => pixels.iter_mut().for_each(|p| *p = ((*p & 255) * 0x01_0101) | *p & OPAQUE),
            GL_INTENSITY => pixels.iter_mut().for_each(|p| *p = (*p & 255) * 0x0101_0101),
            GL_RGB => pixels.iter_mut().for_each(|p| *p |= OPAQUE),
            _ => {}
        }
        pixels
    }

    fn store_float(self, mut c: [f32; 4]) -> [u32; 4] {
        for (c, &bits) in c.iter_mut().zip(&self.bits) {
            let max = ((1u32 << bits) - 1) as f32;
            *c = (c.clamp(0.0, 1.0) * max).round_ties_even() / max;
        }
        self.expand(c).map(f32::to_bits)
    }

    /// A colour as a texture of this base format gives it.
    pub fn expand(self, [r, g, b, a]: [f32; 4]) -> [f32; 4] {
        match self.base {
            GL_ALPHA => [0.0, 0.0, 0.0, a],
            GL_LUMINANCE => [r, r, r, 1.0],
            GL_LUMINANCE_ALPHA => [r, r, r, a],
            GL_INTENSITY => [r; 4],
            GL_RGB => [r, g, b, 1.0],
            _ => [r, g, b, a],
        }
    }

    /// Texels as glGetTexImage sees them: luminance and intensity in red alone (table 6.1).
    pub fn read(self, texels: &[u32]) -> Groups {
        if self.is_depth() {
            return match self.base {
                GL_DEPTH_STENCIL => Groups::DepthStencil(texels.to_vec()),
                _ => Groups::Depth(texels.iter().map(|&t| self.depth().depth(t)).collect()),
            };
        }
        let red_only = matches!(self.base, GL_LUMINANCE | GL_LUMINANCE_ALPHA | GL_INTENSITY);
        match self.texels() {
            TexelFormat::Rgba8 if self.base == GL_INTENSITY => Groups::Rgba8(texels.iter().map(|p| p & 255 | 0xff00_0000).collect()),
            TexelFormat::Rgba8 if red_only => Groups::Rgba8(texels.iter().map(|p| p & 0xff00_00ff).collect()),
            TexelFormat::Rgba8 => Groups::Rgba8(texels.to_vec()),
            TexelFormat::Rgba32f => {
                let pixel = |p: &[u32]| {
                    let [r, g, b, a] = [0, 1, 2, 3].map(|k| f32::from_bits(p[k]));
                    match self.base {
                        GL_INTENSITY => [r, 0.0, 0.0, 1.0],
                        _ if red_only => [r, 0.0, 0.0, a],
                        _ => [r, g, b, a],
                    }
                };
                Groups::Rgba(texels.chunks_exact(4).map(pixel).collect())
            }
        }
    }
}

/// A colour, clamped and rounded to 8 bits a component.
pub(crate) fn to_rgba8(c: [f32; 4]) -> u32 {
    u32::from_le_bytes(c.map(|c| (c.clamp(0.0, 1.0) * 255.0).round_ties_even() as u8))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stored(format: GLenum, pixel: u32) -> u32 {
        InternalFormat::from_enum(format).unwrap().store(Groups::Rgba8(vec![pixel]))[0]
    }

    #[test]
    fn base_formats_expand_to_rgba() {
        let pixel = u32::from_le_bytes([10, 20, 30, 40]);
        assert_eq!(stored(GL_ALPHA, pixel).to_le_bytes(), [0, 0, 0, 40]);
        assert_eq!(stored(GL_LUMINANCE, pixel).to_le_bytes(), [10, 10, 10, 255]);
        assert_eq!(stored(GL_LUMINANCE_ALPHA, pixel).to_le_bytes(), [10, 10, 10, 40]);
        assert_eq!(stored(GL_INTENSITY, pixel).to_le_bytes(), [10; 4]);
        assert_eq!(stored(3, pixel).to_le_bytes(), [10, 20, 30, 255]);
        assert_eq!(stored(4, pixel).to_le_bytes(), [10, 20, 30, 40]);
    }

    #[test]
    fn low_precision_formats_keep_what_osmesa_keeps() {
        let pixel = u32::from_le_bytes([100; 4]);
        assert_eq!(stored(GL_R3_G3_B2, pixel).to_le_bytes(), [109, 109, 85, 255]);
        assert_eq!(stored(GL_RGB4, pixel).to_le_bytes(), [102, 102, 102, 255]);
        assert_eq!(stored(GL_RGB5, pixel).to_le_bytes(), [99, 99, 99, 255]);
        assert_eq!(stored(GL_RGB5_A1, pixel).to_le_bytes(), [99, 99, 99, 0]);
        assert_eq!(stored(GL_RGBA2, pixel).to_le_bytes(), [102; 4]);
        assert_eq!(stored(GL_LUMINANCE4_ALPHA4, pixel).to_le_bytes(), [102; 4]);
        assert_eq!(stored(GL_LUMINANCE4, pixel).to_le_bytes(), [100, 100, 100, 255]);
    }

    #[test]
    fn sixteen_bit_formats_keep_sixteen_bits() {
        let format = InternalFormat::from_enum(GL_LUMINANCE16).unwrap();
        let texels = format.store(Groups::Rgba(vec![[1000.0 / 65535.0, 0.0, 0.0, 0.0]]));
        assert_eq!(
            texels.iter().map(|&t| f32::from_bits(t)).collect::<Vec<_>>(),
            [1000.0 / 65535.0, 1000.0 / 65535.0, 1000.0 / 65535.0, 1.0]
        );
        assert_eq!(format.read(&texels), Groups::Rgba(vec![[1000.0 / 65535.0, 0.0, 0.0, 1.0]]));
    }
}
