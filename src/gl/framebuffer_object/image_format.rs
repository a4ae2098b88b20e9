//! What an image that can be attached to a framebuffer object stores.

use crate::device::{ColorFormat, DepthFormat, PlaneFormat};
use crate::gl::enums::*;
use crate::gl::pixel_format::Groups;
use crate::gl::texture_format::InternalFormat;

/// The format of a renderbuffer or of a level of a texture, as a framebuffer sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ImageFormat {
    /// GL_RGBA, GL_RGB, GL_ALPHA, GL_LUMINANCE, GL_LUMINANCE_ALPHA, GL_INTENSITY, GL_DEPTH_COMPONENT, GL_DEPTH_STENCIL or
    /// GL_STENCIL_INDEX.
    pub base: GLenum,
    /// Where its pixels go.
    pub plane: PlaneFormat,
    /// Bits of red, green, blue, alpha, depth and stencil.
    pub bits: [u8; 6],
    /// What reads of a colour keep: a plane may have more.
    kept: InternalFormat,
}

const fn depth_stencil(base: GLenum, depth: DepthFormat, depth_bits: u8, stencil: bool) -> ImageFormat {
    let bits = [0, 0, 0, 0, depth_bits, if stencil { 8 } else { 0 }];
    let kept = InternalFormat { base, bits: [depth_bits, bits[5], 0, 0] };
    ImageFormat { base, plane: PlaneFormat::DepthStencil { depth, stencil }, bits, kept }
}

impl ImageFormat {
    /// Of a renderbuffer; `None` for what cannot be rendered to. All depths have 16 or 24 bits, or 32 in floating point, all stencils 8.
    pub fn of_renderbuffer(internal_format: GLenum) -> Option<ImageFormat> {
        Some(match internal_format {
            GL_STENCIL_INDEX | GL_STENCIL_INDEX1 | GL_STENCIL_INDEX4 | GL_STENCIL_INDEX8 | GL_STENCIL_INDEX16 => {
                depth_stencil(GL_STENCIL_INDEX, DepthFormat::None, 0, true)
            }
            // The numbers 1 to 4 and the compressed formats are for textures alone.
            1..=4 | GL_COMPRESSED_ALPHA..=GL_COMPRESSED_RGBA => return None,
            _ => ImageFormat::of_texture(InternalFormat::from_enum(internal_format)?),
        })
    }

    /// Of a level of a texture. Luminance and intensity are no bits of a framebuffer.
    pub fn of_texture(format: InternalFormat) -> ImageFormat {
        if format.is_depth() {
            return depth_stencil(format.base, format.depth(), format.bits[0], format.base == GL_DEPTH_STENCIL);
        }
        let size = |component| format.size_of(component) as u8;
        let color = if format.bits.iter().any(|&b| b > 8) { ColorFormat::Rgba16 } else { ColorFormat::Rgba8 };
        let bits = [size(GL_TEXTURE_RED_SIZE), size(GL_TEXTURE_GREEN_SIZE), size(GL_TEXTURE_BLUE_SIZE), size(GL_TEXTURE_ALPHA_SIZE), 0, 0];
        ImageFormat { base: format.base, plane: PlaneFormat::Color(color), bits, kept: format }
    }

    /// Colours as a read sees them: with the bits that the format keeps, luminance and intensity in red alone (table 6.1).
    pub fn read(self, groups: Groups) -> Groups {
        let all_kept = self.kept.bits.iter().all(|&b| b == 8 || b == 16);
        if all_kept && matches!(self.base, GL_RGBA | GL_RGB | GL_ALPHA) { groups } else { self.kept.read(&self.kept.store(groups)) }
    }

    /// Words of an Rgba8 plane, whatever was written to the components that the format lacks.
    pub fn expand(self, rows: Vec<u32>) -> Vec<u32> {
        match self.base {
            GL_LUMINANCE | GL_LUMINANCE_ALPHA | GL_INTENSITY => self.kept.store(Groups::Rgba8(rows)),
            _ => rows,
        }
    }

    pub fn is_color(self) -> bool {
        matches!(self.plane, PlaneFormat::Color(_))
    }

    pub fn has_depth(self) -> bool {
        matches!(self.base, GL_DEPTH_COMPONENT | GL_DEPTH_STENCIL)
    }

    pub fn has_float_depth(self) -> bool {
        matches!(self.plane, PlaneFormat::DepthStencil { depth: DepthFormat::F32, .. })
    }

    pub fn has_stencil(self) -> bool {
        matches!(self.base, GL_STENCIL_INDEX | GL_DEPTH_STENCIL)
    }

    /// Bits 0 to 3: the components that drawing changes. What a format lacks keeps the value that it reads as.
    pub fn color_mask(self) -> u32 {
        match self.base {
            GL_RGB | GL_LUMINANCE => 0b0111,
            GL_ALPHA => 0b1000,
            _ => 0b1111,
        }
    }

    /// A pixel of a plane in which nothing was drawn yet, of the components that drawing never changes the value they have for good.
    pub fn blank(self) -> [u32; 2] {
        match self.plane {
            PlaneFormat::Color(ColorFormat::Rgba16) if self.color_mask() == 0b0111 => [0, 0xffff_0000],
            PlaneFormat::Color(_) if self.color_mask() == 0b0111 => [0xff00_0000, 0],
            _ => [0, 0],
        }
    }
}
