//! Pixel store: how images lie in client memory (3.6.1, 4.3.2).

use super::Context;
use super::enums::*;
use super::pixel_format::group_bytes;
use super::state::PixelStore;

/// Where the groups of an image lie, in bytes from the client's pointer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Layout {
    /// First byte of the first group.
    pub start: usize,
    /// GL_BITMAP only: bits of the first byte of a row to skip.
    pub bit: usize,
    /// Bytes from row to row.
    pub row: usize,
    /// Bytes from image to image.
    pub image: usize,
    /// Bytes that the groups of one row span, without padding.
    pub row_bytes: usize,
    /// One past the last byte that is touched.
    pub end: usize,
}

impl PixelStore {
    /// The layout of an image of `size` (width, height, depth) groups; `volume` says whether the command is a
    /// three-dimensional one, for which image height and skipped images count. None: the format or type is unknown, a
    /// size is negative, or the image would not fit an address space.
    pub(crate) fn layout(&self, size: [i32; 3], volume: bool, format: GLenum, ty: GLenum) -> Option<Layout> {
        let [width, height, depth] = size.map(|n| u64::try_from(n).ok());
        let (width, height, depth) = (width?, height?, depth?);
        let positive = |n: i32| u64::try_from(n).unwrap_or(0);
        let row_groups = if self.row_length > 0 { positive(self.row_length) } else { width };
        let rows = if volume && self.image_height > 0 { positive(self.image_height) } else { height };
        let alignment = positive(self.alignment).max(1);
        let skip = positive(self.skip_pixels);
        let (row, first, bit, row_bytes) = if ty == GL_BITMAP {
            group_bytes(format, ty)?;
            (row_groups.div_ceil(8 * alignment) * alignment, skip / 8, skip % 8, (skip % 8 + width).div_ceil(8))
        } else {
            let group = group_bytes(format, ty)? as u64;
            ((row_groups * group).next_multiple_of(alignment), skip * group, 0, width * group)
        };
        let image = row.checked_mul(rows)?;
        let mut start = positive(self.skip_rows).checked_mul(row)?.checked_add(first)?;
        if volume {
            start = start.checked_add(positive(self.skip_images).checked_mul(image)?)?;
        }
        let end = if width == 0 || height == 0 || depth == 0 {
            0
        } else {
            start.checked_add((depth - 1).checked_mul(image)?)?.checked_add((height - 1).checked_mul(row)?)?.checked_add(row_bytes)?
        };
        let limit = |n: u64| if n <= isize::MAX as u64 { Some(n as usize) } else { None };
        Some(Layout {
            start: limit(start)?,
            bit: bit as usize,
            row: limit(row)?,
            image: limit(image)?,
            row_bytes: limit(row_bytes)?,
            end: limit(end)?,
        })
    }

    /// Sets one parameter; the names of packing and unpacking are folded into those of unpacking.
    fn set(&mut self, pname: GLenum, value: i32) -> Result<(), GLenum> {
        let field = match pname {
            GL_UNPACK_SWAP_BYTES => {
                self.swap_bytes = value != 0;
                return Ok(());
            }
            GL_UNPACK_LSB_FIRST => {
                self.lsb_first = value != 0;
                return Ok(());
            }
            GL_UNPACK_ROW_LENGTH => &mut self.row_length,
            GL_UNPACK_IMAGE_HEIGHT => &mut self.image_height,
            GL_UNPACK_SKIP_ROWS => &mut self.skip_rows,
            GL_UNPACK_SKIP_PIXELS => &mut self.skip_pixels,
            GL_UNPACK_SKIP_IMAGES => &mut self.skip_images,
            GL_UNPACK_ALIGNMENT => {
                if !matches!(value, 1 | 2 | 4 | 8) {
                    return Err(GL_INVALID_VALUE);
                }
                &mut self.alignment
            }
            _ => return Err(GL_INVALID_ENUM),
        };
        if value < 0 {
            return Err(GL_INVALID_VALUE);
        }
        *field = value;
        Ok(())
    }
}

/// The name of the unpack parameter that a pack parameter mirrors, and true; an unpack parameter itself, and false.
fn fold(pname: GLenum) -> (GLenum, bool) {
    match pname {
        GL_PACK_SWAP_BYTES => (GL_UNPACK_SWAP_BYTES, true),
        GL_PACK_LSB_FIRST => (GL_UNPACK_LSB_FIRST, true),
        GL_PACK_ROW_LENGTH => (GL_UNPACK_ROW_LENGTH, true),
        GL_PACK_IMAGE_HEIGHT => (GL_UNPACK_IMAGE_HEIGHT, true),
        GL_PACK_SKIP_ROWS => (GL_UNPACK_SKIP_ROWS, true),
        GL_PACK_SKIP_PIXELS => (GL_UNPACK_SKIP_PIXELS, true),
        GL_PACK_SKIP_IMAGES => (GL_UNPACK_SKIP_IMAGES, true),
        GL_PACK_ALIGNMENT => (GL_UNPACK_ALIGNMENT, true),
        _ => (pname, false),
    }
}

impl Context {
    /// glPixelStorei. Client state: never compiled into a list.
    pub fn pixel_storei(&mut self, pname: GLenum, value: i32) {
        if self.inside_begin_end() {
            return;
        }
        let (name, pack) = fold(pname);
        let store = if pack { &mut self.state.pack } else { &mut self.state.unpack };
        if let Err(error) = store.set(name, value) {
            self.set_error(error, "glPixelStore");
        }
    }

    /// glPixelStoref: booleans are true where not zero, integers are rounded.
    pub fn pixel_storef(&mut self, pname: GLenum, value: f32) {
        let boolean = matches!(fold(pname).0, GL_UNPACK_SWAP_BYTES | GL_UNPACK_LSB_FIRST);
        self.pixel_storei(pname, if boolean { (value != 0.0) as i32 } else { value.round() as i32 });
    }

    /// Bytes from the client's pointer on that an image of at most two dimensions takes under the unpack state. None
    /// where there is no answer (bad format, type or size): the command itself then raises the error.
    pub fn unpack_bytes(&self, width: i32, height: i32, depth: i32, format: GLenum, ty: GLenum) -> Option<usize> {
        Some(self.state.unpack.layout([width, height, depth], false, format, ty)?.end)
    }

    /// The same for commands with a depth (glTexImage3D, glTexSubImage3D), where image height and skipped images count.
    pub fn unpack_bytes_3d(&self, width: i32, height: i32, depth: i32, format: GLenum, ty: GLenum) -> Option<usize> {
        Some(self.state.unpack.layout([width, height, depth], true, format, ty)?.end)
    }

    /// Bytes from the client's pointer on that an image of at most two dimensions takes under the pack state.
    pub fn pack_bytes(&self, width: i32, height: i32, depth: i32, format: GLenum, ty: GLenum) -> Option<usize> {
        Some(self.state.pack.layout([width, height, depth], false, format, ty)?.end)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_aligned_and_skips_add_up() {
        let mut store = PixelStore::default();
        let l = store.layout([3, 2, 1], false, GL_RGB, GL_UNSIGNED_BYTE).unwrap();
        assert_eq!((l.start, l.row, l.end), (0, 12, 21));
        store.row_length = 10;
        store.skip_pixels = 2;
        store.skip_rows = 1;
        store.alignment = 1;
        let l = store.layout([3, 2, 1], false, GL_RGB, GL_UNSIGNED_BYTE).unwrap();
        assert_eq!((l.start, l.row, l.end), (36, 30, 36 + 30 + 9));
        assert_eq!(store.layout([3, 0, 1], false, GL_RGB, GL_UNSIGNED_BYTE).unwrap().end, 0);
    }

    #[test]
    fn bitmaps_are_addressed_by_bits() {
        let store = PixelStore { skip_pixels: 11, alignment: 1, ..PixelStore::default() };
        let l = store.layout([7, 3, 1], false, GL_COLOR_INDEX, GL_BITMAP).unwrap();
        assert_eq!((l.start, l.bit, l.row, l.end), (1, 3, 1, 5));
    }

    #[test]
    fn image_height_and_skipped_images_count_for_volumes_only() {
        let store = PixelStore { image_height: 5, skip_images: 2, ..PixelStore::default() };
        assert_eq!(store.layout([4, 4, 1], false, GL_RGBA, GL_UNSIGNED_BYTE).unwrap().start, 0);
        assert_eq!(store.layout([4, 4, 1], true, GL_RGBA, GL_UNSIGNED_BYTE).unwrap().start, 2 * 5 * 16);
    }

    #[test]
    fn sizes_that_overflow_have_no_layout() {
        let store = PixelStore {
            row_length: i32::MAX,
            skip_rows: i32::MAX,
            image_height: i32::MAX,
            skip_images: i32::MAX,
            ..PixelStore::default()
        };
        assert_eq!(store.layout([i32::MAX, i32::MAX, i32::MAX], true, GL_RGBA, GL_FLOAT), None);
        assert_eq!(store.layout([-1, 1, 1], false, GL_RGBA, GL_FLOAT), None);
        assert_eq!(store.layout([1, 1, 1], false, GL_RGBA, GL_BITMAP), None);
    }

    #[test]
    fn parameters_are_checked() {
        let mut store = PixelStore::default();
        assert_eq!(store.set(GL_UNPACK_ALIGNMENT, 3), Err(GL_INVALID_VALUE));
        assert_eq!(store.set(GL_UNPACK_ROW_LENGTH, -1), Err(GL_INVALID_VALUE));
        assert_eq!(store.set(GL_UNPACK_ROW_LENGTH, 7), Ok(()));
        assert_eq!(store.set(GL_TEXTURE_2D, 7), Err(GL_INVALID_ENUM));
        assert_eq!(store.row_length, 7);
        assert_eq!(fold(GL_PACK_ALIGNMENT), (GL_UNPACK_ALIGNMENT, true));
    }
}
