//! Formats and types of client images: what may be combined, how groups are read and written (3.6.4, 4.3.2).

use super::enums::*;
use super::pixel_store::Layout;
use super::state::PixelStore;

/// Components of a group in a format that is not packed; None: no such format.
pub(crate) fn components(format: GLenum) -> Option<usize> {
    Some(match format {
        GL_COLOR_INDEX | GL_STENCIL_INDEX | GL_DEPTH_COMPONENT | GL_RED | GL_GREEN | GL_BLUE | GL_ALPHA | GL_LUMINANCE => 1,
        GL_LUMINANCE_ALPHA => 2,
        GL_RGB | GL_BGR => 3,
        GL_RGBA | GL_BGRA | GL_ABGR_EXT => 4,
        _ => return None,
    })
}

/// Bytes of an element of a type that holds one component; GL_BITMAP counts as 1.
fn component_bytes(ty: GLenum) -> Option<usize> {
    Some(match ty {
        GL_BITMAP | GL_BYTE | GL_UNSIGNED_BYTE => 1,
        GL_SHORT | GL_UNSIGNED_SHORT => 2,
        GL_INT | GL_UNSIGNED_INT | GL_FLOAT => 4,
        _ => return None,
    })
}

/// A packed type: its bytes and the bits of its components, first component first, with their shifts.
#[derive(Clone, Copy)]
struct Packed {
    bytes: usize,
    /// (shift, bits) of each component in the order of the format.
    fields: [(u32, u32); 4],
    count: usize,
}

fn packed(ty: GLenum) -> Option<Packed> {
    let three = |bytes, fields: [(u32, u32); 3]| Packed { bytes, fields: [fields[0], fields[1], fields[2], (0, 0)], count: 3 };
    let four = |bytes, fields| Packed { bytes, fields, count: 4 };
    Some(match ty {
        GL_UNSIGNED_BYTE_3_3_2 => three(1, [(5, 3), (2, 3), (0, 2)]),
        GL_UNSIGNED_BYTE_2_3_3_REV => three(1, [(0, 3), (3, 3), (6, 2)]),
        GL_UNSIGNED_SHORT_5_6_5 => three(2, [(11, 5), (5, 6), (0, 5)]),
        GL_UNSIGNED_SHORT_5_6_5_REV => three(2, [(0, 5), (5, 6), (11, 5)]),
        GL_UNSIGNED_SHORT_4_4_4_4 => four(2, [(12, 4), (8, 4), (4, 4), (0, 4)]),
        GL_UNSIGNED_SHORT_4_4_4_4_REV => four(2, [(0, 4), (4, 4), (8, 4), (12, 4)]),
        GL_UNSIGNED_SHORT_5_5_5_1 => four(2, [(11, 5), (6, 5), (1, 5), (0, 1)]),
        GL_UNSIGNED_SHORT_1_5_5_5_REV => four(2, [(0, 5), (5, 5), (10, 5), (15, 1)]),
        GL_UNSIGNED_INT_8_8_8_8 => four(4, [(24, 8), (16, 8), (8, 8), (0, 8)]),
        GL_UNSIGNED_INT_8_8_8_8_REV => four(4, [(0, 8), (8, 8), (16, 8), (24, 8)]),
        GL_UNSIGNED_INT_10_10_10_2 => four(4, [(22, 10), (12, 10), (2, 10), (0, 2)]),
        GL_UNSIGNED_INT_2_10_10_10_REV => four(4, [(0, 10), (10, 10), (20, 10), (30, 2)]),
        _ => return None,
    })
}

/// The error that a pair of format and type deserves, if any: an unknown enum, GL_BITMAP with anything but indices,
/// a packed type whose components do not match the format's.
pub(crate) fn check(format: GLenum, ty: GLenum) -> Result<(), GLenum> {
    match (format, ty) {
        (GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8) => return Ok(()),
        (GL_DEPTH_STENCIL, _) => return Err(GL_INVALID_ENUM),
        (_, GL_UNSIGNED_INT_24_8) => return Err(if components(format).is_some() { GL_INVALID_OPERATION } else { GL_INVALID_ENUM }),
        _ => {}
    }
    let n = components(format).ok_or(GL_INVALID_ENUM)?;
    if let Some(packed) = packed(ty) {
        let matches = if packed.count == 3 { format == GL_RGB } else { n == 4 };
        return if matches { Ok(()) } else { Err(GL_INVALID_OPERATION) };
    }
    component_bytes(ty).ok_or(GL_INVALID_ENUM)?;
    if ty == GL_BITMAP && !matches!(format, GL_COLOR_INDEX | GL_STENCIL_INDEX) {
        return Err(GL_INVALID_ENUM);
    }
    Ok(())
}

/// Bytes of a group; None where [`check`] fails. GL_BITMAP answers 1, though a byte holds eight groups.
pub(crate) fn group_bytes(format: GLenum, ty: GLenum) -> Option<usize> {
    check(format, ty).ok()?;
    if format == GL_DEPTH_STENCIL {
        return Some(4);
    }
    match packed(ty) {
        Some(packed) => Some(packed.bytes),
        None => Some(components(format)? * component_bytes(ty)?),
    }
}

/// An image as it came from the client, before pixel transfer: tightly packed, lowest row first.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Groups {
    /// RGBA, red in the low byte: only where the client's components had 8 bits.
    Rgba8(Vec<u32>),
    /// RGBA, not clamped.
    Rgba(Vec<[f32; 4]>),
    /// Colour or stencil indices.
    Index(Vec<u32>),
    /// Depth, not clamped.
    Depth(Vec<f64>),
    /// Depth in the low 24 bits, stencil in the high 8.
    DepthStencil(Vec<u32>),
}

/// An empty vector with room for `count` values; None where there is not that much memory, which would else end the process.
fn room<T>(count: usize) -> Option<Vec<T>> {
    let mut out = Vec::new();
    out.try_reserve_exact(count).ok()?;
    Some(out)
}

/// A client image: its size in groups and the groups.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct ClientImage {
    pub size: [usize; 3],
    pub groups: Groups,
}

impl ClientImage {
    /// Unpacks an image; None where the bytes do not reach or the arguments are not [`check`]ed.
    pub fn unpack(store: &PixelStore, bytes: &[u8], size: [i32; 3], volume: bool, format: GLenum, ty: GLenum) -> Option<ClientImage> {
        let layout = store.layout(size, volume, format, ty)?;
        if layout.end > bytes.len() {
            return None;
        }
        let size = size.map(|n| n as usize);
        let count = size[0].checked_mul(size[1])?.checked_mul(size[2])?;
        let source = Source { bytes, layout, size, swap: if store.swap_bytes { element_bytes(ty)? } else { 1 } };
        let groups = match format {
            GL_COLOR_INDEX | GL_STENCIL_INDEX if ty == GL_BITMAP => {
                let mut out = room(count)?;
                source.rows(|row| out.extend((0..size[0]).map(|x| bit(row, layout.bit + x, store.lsb_first) as u32)));
                Groups::Index(out)
            }
            GL_COLOR_INDEX | GL_STENCIL_INDEX => {
                let mut out = room(count)?;
                source.rows(|row| read_indices(row, ty, &mut out));
                Groups::Index(out)
            }
            GL_DEPTH_STENCIL => {
                let mut out = room(count)?;
                // The client has them the other way round.
                source.rows(|row| out.extend(row.chunks_exact(4).map(|b| u32::from_ne_bytes([b[0], b[1], b[2], b[3]]).rotate_right(8))));
                Groups::DepthStencil(out)
            }
            GL_DEPTH_COMPONENT => {
                let mut out = room(count)?;
                source.rows(|row| read_depths(row, ty, &mut out));
                Groups::Depth(out)
            }
            _ if packed(ty).is_some_and(|p| p.fields.iter().all(|f| f.1 <= 8)) && rgba8_reader(format, ty).is_none() => {
                let mut out = reserve(count)?;
                let packed = packed(ty)?;
                source.rows(|row| read_packed_rgba8(row, format, packed, &mut out));
                Groups::Rgba8(out)
            }
            _ => match rgba8_reader(format, ty) {
                Some(read) => {
                    let mut out = room(count)?;
                    source.rows(|row| read(row, &mut out));
                    Groups::Rgba8(out)
                }
                None => {
                    let mut out = room(count)?;
                    source.rows(|row| read_rgba(row, format, ty, &mut out));
                    Groups::Rgba(out)
                }
            },
        };
        Some(ClientImage { size, groups })
    }
}

/// An empty vector with room for so many, if the memory is there.
fn reserve<T>(count: usize) -> Option<Vec<T>> {
    let mut out = Vec::new();
    out.try_reserve_exact(count).ok()?;
    Some(out)
}

/// Bytes that GL_*_SWAP_BYTES reverses.
fn element_bytes(ty: GLenum) -> Option<usize> {
    packed(ty).map(|p| p.bytes).or_else(|| if ty == GL_UNSIGNED_INT_24_8 { Some(4) } else { component_bytes(ty) })
}

/// Rows of client memory.
struct Source<'a> {
    bytes: &'a [u8],
    layout: Layout,
    size: [usize; 3],
    swap: usize,
}

impl Source<'_> {
    fn rows(&self, mut read: impl FnMut(&[u8])) {
        if self.size.contains(&0) {
            return;
        }
        let mut swapped = Vec::new();
        for z in 0..self.size[2] {
            for y in 0..self.size[1] {
                let at = self.layout.start + z * self.layout.image + y * self.layout.row;
                let row = &self.bytes[at..at + self.layout.row_bytes];
                if self.swap > 1 {
                    swapped.clear();
                    swapped.extend_from_slice(row);
                    swapped.chunks_exact_mut(self.swap).for_each(<[u8]>::reverse);
                    read(&swapped);
                } else {
                    read(row);
                }
            }
        }
    }
}

/// Bit `index` of a bitmap row; the first pixel is the highest bit of a byte unless `lsb_first`.
pub(crate) fn bit(row: &[u8], index: usize, lsb_first: bool) -> bool {
    let shift = if lsb_first { index % 8 } else { 7 - index % 8 };
    row[index / 8] >> shift & 1 != 0
}

/// Elements of a row as the numbers that they are, for indices.
fn read_indices(row: &[u8], ty: GLenum, out: &mut Vec<u32>) {
    let two = |b: &[u8]| u16::from_ne_bytes([b[0], b[1]]);
    let four = |b: &[u8]| u32::from_ne_bytes([b[0], b[1], b[2], b[3]]);
    match ty {
        GL_UNSIGNED_BYTE => out.extend(row.iter().map(|&b| b as u32)),
        GL_BYTE => out.extend(row.iter().map(|&b| b as i8 as u32)),
        GL_UNSIGNED_SHORT => out.extend(row.chunks_exact(2).map(|b| two(b) as u32)),
        GL_SHORT => out.extend(row.chunks_exact(2).map(|b| two(b) as i16 as u32)),
        GL_FLOAT => out.extend(row.chunks_exact(4).map(|b| f32::from_bits(four(b)) as i64 as u32)),
        _ => out.extend(row.chunks_exact(4).map(four)),
    }
}

/// Elements of a row as normalised components. Signed ones are c / (2^(b-1) - 1), clamped at -1, as Mesa and every
/// specification from 4.2 on have it, so that zero stays zero.
fn read_normalized(row: &[u8], ty: GLenum, mut out: impl FnMut(f64)) {
    let two = |b: &[u8]| u16::from_ne_bytes([b[0], b[1]]);
    let four = |b: &[u8]| u32::from_ne_bytes([b[0], b[1], b[2], b[3]]);
    match ty {
        GL_UNSIGNED_BYTE => row.iter().for_each(|&b| out(b as f64 / 255.0)),
        GL_BYTE => row.iter().for_each(|&b| out((b as i8 as f64 / 127.0).max(-1.0))),
        GL_UNSIGNED_SHORT => row.chunks_exact(2).for_each(|b| out(two(b) as f64 / 65535.0)),
        GL_SHORT => row.chunks_exact(2).for_each(|b| out((two(b) as i16 as f64 / 32767.0).max(-1.0))),
        GL_UNSIGNED_INT => row.chunks_exact(4).for_each(|b| out(four(b) as f64 / u32::MAX as f64)),
        GL_INT => row.chunks_exact(4).for_each(|b| out((four(b) as i32 as f64 / i32::MAX as f64).max(-1.0))),
        GL_FLOAT => row.chunks_exact(4).for_each(|b| out(f32::from_bits(four(b)) as f64)),
        _ => {}
    }
}

/// Elements of a row as depths. Those of bytes and shorts are single-precision products, as in Mesa.
fn read_depths(row: &[u8], ty: GLenum, out: &mut Vec<f64>) {
    match ty {
        GL_UNSIGNED_BYTE => out.extend(row.iter().map(|&b| f64::from(f32::from(b) * (1.0 / 255.0)))),
        GL_UNSIGNED_SHORT => {
            out.extend(row.chunks_exact(2).map(|b| f64::from(f32::from(u16::from_ne_bytes([b[0], b[1]])) * (1.0 / 65535.0))))
        }
        _ => read_normalized(row, ty, |v| out.push(v)),
    }
}

/// A component of 1 to 8 bits with 8: its highest bits again below its lowest one, as Mesa widens. That is the nearest value but
/// for a few of 5 and 6 bits, which are one off.
pub(crate) fn widen(value: u32, bits: u32) -> u32 {
    match bits {
        1 => value * 255,
        2 => value * 85,
        3 => value << 5 | value << 2 | value >> 1,
        _ => value << (8 - bits) | value >> (2 * bits - 8),
    }
}

/// RGBA from the components of a format, in their order.
fn expand(format: GLenum, c: &[f32]) -> [f32; 4] {
    match format {
        GL_RED => [c[0], 0.0, 0.0, 1.0],
        GL_GREEN => [0.0, c[0], 0.0, 1.0],
        GL_BLUE => [0.0, 0.0, c[0], 1.0],
        GL_ALPHA => [0.0, 0.0, 0.0, c[0]],
        GL_LUMINANCE => [c[0], c[0], c[0], 1.0],
        GL_LUMINANCE_ALPHA => [c[0], c[0], c[0], c[1]],
        GL_RGB => [c[0], c[1], c[2], 1.0],
        GL_BGR => [c[2], c[1], c[0], 1.0],
        GL_BGRA => [c[2], c[1], c[0], c[3]],
        GL_ABGR_EXT => [c[3], c[2], c[1], c[0]],
        _ => [c[0], c[1], c[2], c[3]],
    }
}

/// The components of a format from RGBA; luminance is the sum of red, green and blue (4.3.2).
fn select(format: GLenum, [r, g, b, a]: [f64; 4]) -> [f64; 4] {
    match format {
        GL_GREEN => [g, 0.0, 0.0, 0.0],
        GL_BLUE => [b, 0.0, 0.0, 0.0],
        GL_ALPHA => [a, 0.0, 0.0, 0.0],
        GL_LUMINANCE => [r + g + b, 0.0, 0.0, 0.0],
        GL_LUMINANCE_ALPHA => [r + g + b, a, 0.0, 0.0],
        GL_BGR | GL_BGRA => [b, g, r, a],
        GL_ABGR_EXT => [a, b, g, r],
        _ => [r, g, b, a],
    }
}

fn read_rgba(row: &[u8], format: GLenum, ty: GLenum, out: &mut Vec<[f32; 4]>) {
    if let Some(packed) = packed(ty) {
        read_packed(row, packed, |word| {
            let field = |(shift, bits): (u32, u32)| {
                let max = (1u32 << bits) - 1;
                if max == 0 { 0.0 } else { (word >> shift & max) as f32 / max as f32 }
            };
            out.push(expand(format, &packed.fields.map(field)));
        });
        return;
    }
    let n = components(format).unwrap_or(1);
    let mut c = [0.0; 4];
    let mut k = 0;
    read_normalized(row, ty, |v| {
        c[k] = v as f32;
        k += 1;
        if k == n {
            out.push(expand(format, &c));
            k = 0;
        }
    });
}

/// The words of packed groups, in the machine's order of bytes.
fn read_packed(row: &[u8], packed: Packed, mut f: impl FnMut(u32)) {
    for group in row.chunks_exact(packed.bytes) {
        f(match *group {
            [a] => a as u32,
            [a, b] => u16::from_ne_bytes([a, b]) as u32,
            [a, b, c, d] => u32::from_ne_bytes([a, b, c, d]),
            _ => 0,
        });
    }
}

/// Groups of a packed type with at most 8 bits a component.
fn read_packed_rgba8(row: &[u8], format: GLenum, packed: Packed, out: &mut Vec<u32>) {
    read_packed(row, packed, |word| {
        let c = packed.fields.map(|(shift, bits)| if bits == 0 { 255 } else { widen(word >> shift & ((1 << bits) - 1), bits) as u8 });
        out.push(u32::from_le_bytes(match format {
            GL_BGRA => [c[2], c[1], c[0], c[3]],
            GL_ABGR_EXT => [c[3], c[2], c[1], c[0]],
            _ => c,
        }));
    });
}

/// A reader straight to RGBA8, for the formats with components of 8 bits.
fn rgba8_reader(format: GLenum, ty: GLenum) -> Option<fn(&[u8], &mut Vec<u32>)> {
    const OPAQUE: u32 = 0xff00_0000;
    let format = match (format, ty) {
        (_, GL_UNSIGNED_BYTE) => format,
        // On a little-endian machine the reversed type has its first component in the first byte.
        (_, GL_UNSIGNED_INT_8_8_8_8_REV) if cfg!(target_endian = "little") => format,
        (GL_RGBA, GL_UNSIGNED_INT_8_8_8_8) if cfg!(target_endian = "little") => GL_ABGR_EXT,
        (GL_ABGR_EXT, GL_UNSIGNED_INT_8_8_8_8) if cfg!(target_endian = "little") => GL_RGBA,
        _ => return None,
    };
    Some(match format {
        GL_RGBA => |row, out| out.extend(row.chunks_exact(4).map(|p| u32::from_le_bytes([p[0], p[1], p[2], p[3]]))),
        GL_BGRA => |row, out| out.extend(row.chunks_exact(4).map(|p| u32::from_le_bytes([p[2], p[1], p[0], p[3]]))),
        GL_ABGR_EXT => |row, out| out.extend(row.chunks_exact(4).map(|p| u32::from_be_bytes([p[0], p[1], p[2], p[3]]))),
        GL_RGB => |row, out| out.extend(row.chunks_exact(3).map(|p| u32::from_le_bytes([p[0], p[1], p[2], 255]))),
        GL_BGR => |row, out| out.extend(row.chunks_exact(3).map(|p| u32::from_le_bytes([p[2], p[1], p[0], 255]))),
        GL_LUMINANCE => |row, out| out.extend(row.iter().map(|&l| (l as u32 * 0x01_0101) | OPAQUE)),
        GL_LUMINANCE_ALPHA => |row, out| out.extend(row.chunks_exact(2).map(|p| (p[0] as u32 * 0x01_0101) | ((p[1] as u32) << 24))),
        GL_ALPHA => |row, out| out.extend(row.iter().map(|&a| (a as u32) << 24)),
        GL_RED => |row, out| out.extend(row.iter().map(|&r| r as u32 | OPAQUE)),
        GL_GREEN => |row, out| out.extend(row.iter().map(|&g| (g as u32) << 8 | OPAQUE)),
        GL_BLUE => |row, out| out.extend(row.iter().map(|&b| (b as u32) << 16 | OPAQUE)),
        _ => return None,
    })
}

/// Rows of client memory, to write; calls `write(y, z, row)`.
fn write_rows(store: &PixelStore, bytes: &mut [u8], layout: Layout, size: [usize; 3], ty: GLenum, mut write: impl FnMut(usize, &mut [u8])) {
    let swap = if store.swap_bytes { element_bytes(ty).unwrap_or(1) } else { 1 };
    if size.contains(&0) {
        return;
    }
    for z in 0..size[2] {
        for y in 0..size[1] {
            let at = layout.start + z * layout.image + y * layout.row;
            let row = &mut bytes[at..at + layout.row_bytes];
            write(z * size[1] + y, row);
            if swap > 1 {
                row.chunks_exact_mut(swap).for_each(<[u8]>::reverse);
            }
        }
    }
}

/// A component in [0, 1] (or [-1, 1] for depth and signed types) as an element of a type.
fn write_normalized(ty: GLenum, value: f64, out: &mut [u8]) {
    match ty {
        GL_UNSIGNED_BYTE => out[0] = (value * 255.0).round_ties_even() as u8,
        GL_BYTE => out[0] = (value * 127.0).round_ties_even() as i8 as u8,
        GL_UNSIGNED_SHORT => out.copy_from_slice(&((value * 65535.0).round_ties_even() as u16).to_ne_bytes()),
        GL_SHORT => out.copy_from_slice(&((value * 32767.0).round_ties_even() as i16).to_ne_bytes()),
        GL_UNSIGNED_INT => out.copy_from_slice(&((value * u32::MAX as f64).round_ties_even() as u32).to_ne_bytes()),
        GL_INT => out.copy_from_slice(&((value * i32::MAX as f64).round_ties_even() as i32).to_ne_bytes()),
        GL_FLOAT => out.copy_from_slice(&(value as f32).to_ne_bytes()),
        _ => {}
    }
}

/// Packs an image of `size` groups into client memory. `bytes` shorter than the layout: nothing is written. Colours
/// must be clamped already where they should be.
pub(crate) fn pack(store: &PixelStore, bytes: &mut [u8], size: [usize; 3], volume: bool, format: GLenum, ty: GLenum, groups: &Groups) {
    let Some(layout) = store.layout(size.map(|n| n as i32), volume, format, ty) else { return };
    if layout.end > bytes.len() {
        return;
    }
    let width = size[0];
    match groups {
        Groups::Rgba8(pixels) => match rgba8_writer(format, ty) {
            Some(write) => write_rows(store, bytes, layout, size, ty, |y, row| write(&pixels[y * width..][..width], row)),
            // In double precision, so that integers of 32 bits come out exact.
            None => write_rows(store, bytes, layout, size, ty, |y, row| {
                let pixels = pixels[y * width..][..width].iter();
                write_rgba(pixels.map(|p| p.to_le_bytes().map(|c| c as f64 / 255.0)), format, ty, row);
            }),
        },
        Groups::Rgba(pixels) => {
            write_rows(store, bytes, layout, size, ty, |y, row| {
                write_rgba(pixels[y * width..][..width].iter().map(|p| p.map(f64::from)), format, ty, row)
            });
        }
        Groups::Index(values) => write_rows(store, bytes, layout, size, ty, |y, row| {
            let values = &values[y * width..][..width];
            match ty {
                GL_BITMAP => write_bits(values, layout.bit, store.lsb_first, row),
                GL_UNSIGNED_BYTE | GL_BYTE => row.iter_mut().zip(values).for_each(|(b, &v)| *b = v as u8),
                GL_UNSIGNED_SHORT | GL_SHORT => {
                    row.chunks_exact_mut(2).zip(values).for_each(|(b, &v)| b.copy_from_slice(&(v as u16).to_ne_bytes()))
                }
                GL_FLOAT => row.chunks_exact_mut(4).zip(values).for_each(|(b, &v)| b.copy_from_slice(&(v as f32).to_ne_bytes())),
                _ => row.chunks_exact_mut(4).zip(values).for_each(|(b, &v)| b.copy_from_slice(&v.to_ne_bytes())),
            }
        }),
        Groups::DepthStencil(words) => write_rows(store, bytes, layout, size, ty, |y, row| {
            row.chunks_exact_mut(4).zip(&words[y * width..][..width]).for_each(|(b, w)| b.copy_from_slice(&w.rotate_left(8).to_ne_bytes()));
        }),
        Groups::Depth(values) => write_rows(store, bytes, layout, size, ty, |y, row| {
            let element = component_bytes(ty).unwrap_or(1);
            row.chunks_exact_mut(element).zip(&values[y * width..][..width]).for_each(|(b, &v)| write_normalized(ty, v, b));
        }),
    }
}

fn write_bits(values: &[u32], first: usize, lsb_first: bool, row: &mut [u8]) {
    for (x, &v) in values.iter().enumerate() {
        let index = first + x;
        let mask = 1u8 << if lsb_first { index % 8 } else { 7 - index % 8 };
        if v & 1 != 0 {
            row[index / 8] |= mask;
        } else {
            row[index / 8] &= !mask;
        }
    }
}

fn write_rgba(pixels: impl Iterator<Item = [f64; 4]>, format: GLenum, ty: GLenum, row: &mut [u8]) {
    if let Some(packed) = packed(ty) {
        for (group, pixel) in row.chunks_exact_mut(packed.bytes).zip(pixels) {
            let c = select(format, pixel);
            let word = packed.fields.iter().zip(c).fold(0u32, |word, (&(shift, bits), c)| {
                let max = (1u32 << bits) - 1;
                word | ((c.clamp(0.0, 1.0) * max as f64).round_ties_even() as u32) << shift
            });
            match packed.bytes {
                1 => group[0] = word as u8,
                2 => group.copy_from_slice(&(word as u16).to_ne_bytes()),
                _ => group.copy_from_slice(&word.to_ne_bytes()),
            }
        }
        return;
    }
    let n = components(format).unwrap_or(1);
    let Some(element) = component_bytes(ty) else { return };
    for (group, pixel) in row.chunks_exact_mut(n * element).zip(pixels) {
        let c = select(format, pixel);
        for (out, c) in group.chunks_exact_mut(element).zip(c) {
            write_normalized(ty, c.clamp(0.0, 1.0), out);
        }
    }
}

/// A writer straight from RGBA8, for the usual formats.
fn rgba8_writer(format: GLenum, ty: GLenum) -> Option<fn(&[u32], &mut [u8])> {
    let format = match (format, ty) {
        (_, GL_UNSIGNED_BYTE) => format,
        (_, GL_UNSIGNED_INT_8_8_8_8_REV) if cfg!(target_endian = "little") => format,
        (GL_RGBA, GL_UNSIGNED_INT_8_8_8_8) if cfg!(target_endian = "little") => GL_ABGR_EXT,
        _ => return None,
    };
    Some(match format {
        GL_RGBA => |pixels, row| row.chunks_exact_mut(4).zip(pixels).for_each(|(b, p)| b.copy_from_slice(&p.to_le_bytes())),
        GL_ABGR_EXT => |pixels, row| row.chunks_exact_mut(4).zip(pixels).for_each(|(b, p)| b.copy_from_slice(&p.to_be_bytes())),
        GL_BGRA => |pixels, row| {
            row.chunks_exact_mut(4).zip(pixels).for_each(|(b, p)| {
                let [r, g, bl, a] = p.to_le_bytes();
                b.copy_from_slice(&[bl, g, r, a]);
            })
        },
        GL_RGB => |pixels, row| row.chunks_exact_mut(3).zip(pixels).for_each(|(b, p)| b.copy_from_slice(&p.to_le_bytes()[..3])),
        GL_BGR => |pixels, row| {
            row.chunks_exact_mut(3).zip(pixels).for_each(|(b, p)| {
                let [r, g, bl, _] = p.to_le_bytes();
                b.copy_from_slice(&[bl, g, r]);
            })
        },
        GL_RED => |pixels, row| row.iter_mut().zip(pixels).for_each(|(b, p)| *b = p.to_le_bytes()[0]),
        GL_GREEN => |pixels, row| row.iter_mut().zip(pixels).for_each(|(b, p)| *b = p.to_le_bytes()[1]),
        GL_BLUE => |pixels, row| row.iter_mut().zip(pixels).for_each(|(b, p)| *b = p.to_le_bytes()[2]),
        GL_ALPHA => |pixels, row| row.iter_mut().zip(pixels).for_each(|(b, p)| *b = p.to_le_bytes()[3]),
        _ => return None,
    })
}

#[cfg(test)]
mod tests;
