//! Formats and types of the program's buffer, and the copy into it.

use tepui::device::{ColorFormat, Pixels};
use tepui::gl::enums::*;

/// Order of the components in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs)]
pub enum Format {
    ColorIndex,
    Rgba,
    Bgra,
    Argb,
    Rgb,
    Bgr,
    Rgb565,
}

impl Format {
    /// From OSMESA_RGBA and the like.
    pub fn from_enum(format: GLenum) -> Option<Format> {
        Some(match format {
            GL_COLOR_INDEX => Format::ColorIndex,
            GL_RGBA => Format::Rgba,
            0x1 => Format::Bgra,
            0x2 => Format::Argb,
            GL_RGB => Format::Rgb,
            0x4 => Format::Bgr,
            0x5 => Format::Rgb565,
            _ => return None,
        })
    }

    /// As OSMESA_FORMAT returns it.
    pub fn to_enum(self) -> GLenum {
        match self {
            Format::ColorIndex => GL_COLOR_INDEX,
            Format::Rgba => GL_RGBA,
            Format::Bgra => 0x1,
            Format::Argb => 0x2,
            Format::Rgb => GL_RGB,
            Format::Bgr => 0x4,
            Format::Rgb565 => 0x5,
        }
    }

    /// Which component (0 red to 3 alpha) lies where.
    fn order(self) -> &'static [usize] {
        match self {
            Format::Rgba => &[0, 1, 2, 3],
            Format::Bgra => &[2, 1, 0, 3],
            Format::Argb => &[3, 0, 1, 2],
            Format::Rgb => &[0, 1, 2],
            Format::Bgr => &[2, 1, 0],
            Format::ColorIndex | Format::Rgb565 => &[],
        }
    }
}

/// How the colour is stored for a format and type; `None` for what is refused.
///
/// Mesa 22 refuses OSMESA_BGR with any type and writes nothing for RGB with GL_UNSIGNED_SHORT; both work here. Mesa writes
/// RGBA in that order, whatever the format, for GL_UNSIGNED_SHORT and GL_FLOAT, and so do we.
pub fn storage(format: Format, kind: GLenum) -> Option<ColorFormat> {
    match (format, kind) {
        (Format::ColorIndex, _) => None,
        (Format::Rgb565, GL_UNSIGNED_SHORT_5_6_5) => Some(ColorFormat::Rgb565),
        (Format::Rgb565, _) => None,
        (Format::Rgb | Format::Bgr, GL_UNSIGNED_BYTE) => Some(ColorFormat::Rgbx8),
        (_, GL_UNSIGNED_BYTE) => Some(ColorFormat::Rgba8),
        (_, GL_UNSIGNED_SHORT) => Some(ColorFormat::Rgba16),
        (_, GL_FLOAT) => Some(ColorFormat::Rgba32f),
        _ => None,
    }
}

/// Bytes a pixel takes in the program's buffer.
pub fn bytes_per_pixel(format: Format, kind: GLenum) -> usize {
    let components = format.order().len();
    match kind {
        GL_UNSIGNED_SHORT_5_6_5 => 2,
        GL_UNSIGNED_BYTE => components,
        GL_UNSIGNED_SHORT => 2 * components,
        _ => 4 * components,
    }
}

/// Converts one row of the surface; `out` has room for it.
pub fn row(pixels: &Pixels, y: usize, format: Format, kind: GLenum, out: &mut [u8]) {
    let words = pixels.format.color.words();
    let width = pixels.width as usize;
    let row = &pixels.color[y * width * words..][..width * words];
    let bytes: &[u8] = bytemuck::cast_slice(row);
    // See `storage`; Mesa takes no BGR, so that nothing but its name says what its order is.
    let straight = if format == Format::Bgr { format.order() } else { &Format::Rgba.order()[..format.order().len()] };
    match kind {
        GL_UNSIGNED_BYTE if format == Format::Rgba => out.copy_from_slice(bytes),
        GL_UNSIGNED_BYTE => permute::<1>(bytes, format.order(), out),
        GL_UNSIGNED_SHORT => permute::<2>(bytes, straight, out),
        GL_FLOAT => permute::<4>(bytes, straight, out),
        _ => {
            // 5-6-5: the surface has red in the low bits, GL_UNSIGNED_SHORT_5_6_5 has it in the high ones.
            for (to, from) in out.chunks_exact_mut(2).zip(row) {
                let (r, g, b) = (from & 31, from >> 5 & 63, from >> 11 & 31);
                to.copy_from_slice(&((r << 11 | g << 5 | b) as u16).to_ne_bytes());
            }
        }
    }
}

/// Picks components of `SIZE` bytes out of pixels of four.
fn permute<const SIZE: usize>(from: &[u8], order: &[usize], out: &mut [u8]) {
    for (to, from) in out.chunks_exact_mut(order.len() * SIZE).zip(from.chunks_exact(4 * SIZE)) {
        for (to, &component) in to.chunks_exact_mut(SIZE).zip(order) {
            to.copy_from_slice(&from[component * SIZE..][..SIZE]);
        }
    }
}
