//! A batch is cut so that what lies on the device between its input and its pixels takes no more than a budget: keys go by bands of rows,
//! primitives by slices, and vertices with them where all of them at once would take too much. Every cut costs some dispatches.

use super::room::LIST_BLOCK_BYTES;

/// Most bands of keys: by then lists are faster.
const MOST_BANDS: u32 = 16;
/// What small buffers take that hardly depend on a batch: parameters, dispatches, tables. Each slice beyond a handful adds a kilobyte.
pub const SMALL_BUFFERS: u64 = 8 << 10;
/// Bytes of a slice's lists, whatever they hold, to each bin: a block begun, tiles, counts.
const BIN_BYTES: u64 = LIST_BLOCK_BYTES + 64 * 4 + 16;
/// Bytes of lists to each triangle that lies in a few bins.
const LISTED_BYTES: u64 = 200;
/// Slices of fewer bytes would be drawn triangle by triangle.
const LEAST_SLICE_BYTES: u64 = 64 << 10;

/// What of a batch wants room.
#[derive(Clone, Copy, Debug)]
pub struct Wanted {
    /// Columns and rows of the surface.
    pub size: [u32; 2],
    /// Bins of it.
    pub bins: u32,
    /// Bytes of all shaded vertices.
    pub shaded: u64,
    /// Bytes of the longest queue of the visible path and of its pool, if segments are to be drawn by keys.
    pub queue: Option<u64>,
    /// Other segments there are too.
    pub slices: bool,
    /// Segments of few triangles may do without lists.
    pub direct: bool,
    /// Triangles that follow each other have vertices that lie near each other: where they do not, a slice would want most of them.
    pub coherent: bool,
}

/// How a batch is cut.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuts {
    /// Rows of a band of keys, a multiple of 8 unless it is all; 0: no keys.
    pub key_rows: u32,
    /// Vertices are shaded slice by slice.
    pub vertices: bool,
    /// Segments have few triangles and no lists.
    pub direct_only: bool,
    /// Bytes of a slice: triangles, planes and lists, and vertices where they are its own.
    pub slice_bytes: u64,
}

impl Cuts {
    /// For so many bytes.
    pub fn new(available: u64, wanted: Wanted) -> Cuts {
        let left = available.saturating_sub(wanted.shaded);
        let share = if wanted.slices { left / 2 } else { left };
        let key_rows = wanted.queue.map_or(0, |queue| key_rows(share.saturating_sub(queue), wanted.size));
        let crowded = key_rows == 0 && wanted.shaded > available / 2;
        let vertices = crowded && wanted.coherent;
        let share = if vertices {
            available
        } else if crowded {
            // All vertices at once: more than there is, but few slices.
            available / 2
        } else if key_rows > 0 {
            share
        } else {
            left
        };
        let lists = wanted.bins as u64 * BIN_BYTES;
        let direct_only = wanted.direct && lists > share / 4;
        // A quarter is for what clipping makes.
        let bytes = share / 4 * 3;
        let slice_bytes = if direct_only { bytes } else { bytes.saturating_sub(lists).max(LEAST_SLICE_BYTES) };
        Cuts { key_rows, vertices, direct_only, slice_bytes }
    }

    /// Bytes that triangles and vec4 of their planes take.
    pub fn bytes(&self, triangles: u64, planes: u64) -> u64 {
        // An eighth more, as `Room` guesses.
        let lists = if self.direct_only { 0 } else { LISTED_BYTES };
        triangles * (size_of::<crate::raster::layout::Triangle>() as u64 * 9 / 8 + lists) + planes * 18
    }
}

/// Rows of a band, as many bands as it takes being of one size.
fn key_rows(bytes: u64, [columns, rows]: [u32; 2]) -> u32 {
    let fits = (bytes / (columns as u64 * 8).max(1)).min(rows as u64) as u32;
    if fits == rows {
        return rows;
    }
    let bands = rows.div_ceil((fits / 8 * 8).max(1));
    if bands > MOST_BANDS { 0 } else { rows.div_ceil(bands).next_multiple_of(8) }
}

#[cfg(test)]
mod tests {
    use super::*;

    const HD: Wanted =
        Wanted { size: [1920, 1080], bins: 510, shaded: 9_600_000, queue: Some(1_000_000), slices: false, direct: true, coherent: true };

    #[test]
    fn a_batch_is_whole_where_there_is_room() {
        assert_eq!(Cuts::new(1 << 30, HD).key_rows, 1080);
        let both = Cuts::new(1 << 30, Wanted { slices: true, ..HD });
        assert_eq!((both.key_rows, both.vertices, both.direct_only), (1080, false, false));
        assert!(both.slice_bytes > 300 << 20);
    }

    #[test]
    fn keys_take_what_vertices_leave_in_bands_of_one_size() {
        let rows = Cuts::new(14_400_000, HD).key_rows;
        assert_eq!(rows, 216, "five bands");
        assert!(rows as u64 * 1920 * 8 + HD.shaded + 1_000_000 <= 14_400_000);
        assert_eq!(Cuts::new(11_000_000, HD).key_rows, 0, "more bands than are worth it");
        // The last band may be lower; none is of a few rows.
        for bytes in (200_000..20_000_000).step_by(100_000) {
            let rows = key_rows(bytes, [1920, 1080]);
            assert!(
                rows == 0 || rows == 1080 || (rows.is_multiple_of(8) && rows as u64 * 1920 * 8 <= bytes),
                "{rows} rows in {bytes} bytes"
            );
        }
    }

    #[test]
    fn little_room_cuts_vertices_and_leaves_lists_out() {
        let small = Wanted { shaded: 28_800, queue: None, slices: true, ..HD };
        let cuts = Cuts::new(35_000, small);
        assert_eq!((cuts.key_rows, cuts.vertices, cuts.direct_only), (0, true, true));
        assert!(cuts.slice_bytes < 35_000);
        let scattered = Cuts::new(35_000, Wanted { coherent: false, ..small });
        assert_eq!((scattered.vertices, scattered.slice_bytes), (false, 35_000 / 2 / 4 * 3));
        let cuts = Cuts::new(35_000, Wanted { direct: false, ..small });
        assert_eq!((cuts.direct_only, cuts.slice_bytes), (false, LEAST_SLICE_BYTES));
    }
}
