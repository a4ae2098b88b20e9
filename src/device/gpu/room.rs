//! How much fits: capacities are guessed from what a batch holds, corrected by what the kernels say of batches that did not fit, and
//! bounded by what the device binds. What does not fit even then is drawn in smaller slices.

use super::params::Status;
use crate::raster::layout::Triangle;

/// Most words of masks.
const MOST_MASK_WORDS: u32 = 8 << 20;
/// Bytes of a block of 32 list entries: indices, records, tile masks.
pub const LIST_BLOCK_BYTES: u64 = (32 * (1 + super::encode::ENTRY_WORDS as u64) + 64) * 4;

/// Capacities of a surface's buffers.
#[derive(Clone, Debug)]
pub struct Room {
    /// Bytes that the next batch may take between its input and its pixels: guesses leave less room where it is little.
    pub available: u64,
    /// Most triangles of a slice, as estimated from its primitives.
    pub slice_triangles: u32,
    /// Most vec4 of planes of a slice, likewise.
    pub slice_planes: u32,
    /// Most blocks of 32 entries in the lists of one segment.
    pub most_list_blocks: u32,
    most_segment_triangles: u32,
    most: Status,
    least: Status,
}

impl Room {
    /// For buffers of at most so many bytes, but of enough for 32 triangles, however large and however clipped, on so many bins.
    pub fn new(bytes: u64, bins: u32) -> Room {
        let words = |each: u64| (bytes / each).min(1 << 28) as u32;
        let most = Status {
            triangles: words(size_of::<Triangle>() as u64),
            planes: words(16),
            pool: words(64).max(1 << 14),
            clipped: words(32).max(1 << 10),
            items: words(48).max(bins.saturating_mul(128)),
            // Masks and counts share the buffer.
            list_blocks: words(LIST_BLOCK_BYTES + LIST_BLOCK_BYTES / 2).max(bins),
            ..Status::default()
        };
        let mut room = Room {
            available: u64::MAX,
            slice_triangles: 0,
            slice_planes: 0,
            most_list_blocks: most.list_blocks,
            most_segment_triangles: u32::MAX,
            most,
            least: Status::default(),
        };
        (room.slice_triangles, room.slice_planes) = (shrink(most.triangles), shrink(most.planes));
        room
    }

    /// Blocks of 32 triangles that a segment may have at most: their masks have a word for each bin.
    pub fn most_blocks(&self, bins: u32) -> u32 {
        (MOST_MASK_WORDS / bins.max(1)).clamp(1, 1 << 20)
    }

    /// Triangles before clipping that a segment may have: an eighth of its blocks is left to what clipping makes.
    pub fn segment_triangles(&self, bins: u32) -> u32 {
        let blocks = self.most_blocks(bins);
        ((blocks - blocks / 8) * 32).min(self.most_segment_triangles)
    }

    /// Blocks for a segment of so many triangles before clipping.
    pub fn segment_blocks(&self, triangles: u32, bins: u32) -> u32 {
        let wanted = triangles.saturating_add(triangles / 8).div_ceil(32) + 4;
        wanted.max(self.least.blocks).min(self.most_blocks(bins))
    }

    /// Triangles of a slice of so many before clipping.
    pub fn triangles(&self, estimate: u32) -> u32 {
        grow(estimate, self.slack(1024, size_of::<Triangle>() as u64)).max(self.least.triangles).min(self.most.triangles)
    }

    /// vec4 of planes likewise.
    pub fn planes(&self, estimate: u32) -> u32 {
        grow(estimate, self.slack(8192, 16)).max(self.least.planes).min(self.most.planes)
    }

    /// Primitives of so many that may be clipped.
    pub fn clipped(&self, primitives: u32) -> u32 {
        (primitives / 32).max(self.slack(1 << 10, 32)).max(self.least.clipped).min(self.most.clipped)
    }

    /// vec4 of the pool for so many primitives.
    pub fn pool(&self, primitives: u32) -> u32 {
        (primitives / 8).max(self.slack(1 << 14, 8)).max(self.least.pool).min(self.most.pool)
    }

    /// Blocks of list entries for so many triangles.
    pub fn lists(&self, triangles: u32, bins: u32) -> u32 {
        (triangles / 16 + bins).max(self.slack(1 << 10, LIST_BLOCK_BYTES)).max(self.least.list_blocks).min(self.most_list_blocks)
    }

    /// Blocks of large triangles of so many.
    pub fn items(&self, primitives: u32) -> u32 {
        ((primitives / 4).min(1 << 18) + self.slack(1 << 14, 12)).max(self.least.items).min(self.most.items)
    }

    /// Room for so many items that may come or not, but for a 32nd of what is available at most.
    fn slack(&self, items: u32, bytes: u64) -> u32 {
        items.min((self.available / 32 / bytes).min(u32::MAX as u64) as u32)
    }

    /// Makes room for what did not fit; cuts slices in half where the device has no more. False where that does not help any more.
    pub fn learn(&mut self, wanted: &Status, bins: u32) -> bool {
        let most_blocks = self.most_blocks(bins);
        let mut smaller = false;
        let mut learn = |least: &mut u32, most: u32, wanted: u32| {
            // A quarter more, so that a scene that grows slowly does not fail each frame.
            *least = (*least).max(wanted.saturating_add(wanted / 4).min(most));
            smaller |= wanted > most;
        };
        learn(&mut self.least.triangles, self.most.triangles, wanted.triangles);
        learn(&mut self.least.planes, self.most.planes, wanted.planes);
        learn(&mut self.least.pool, self.most.pool, wanted.pool);
        learn(&mut self.least.clipped, self.most.clipped, wanted.clipped);
        learn(&mut self.least.items, self.most.items, wanted.items);
        learn(&mut self.least.blocks, most_blocks, wanted.blocks);
        learn(&mut self.least.list_blocks, self.most_list_blocks, wanted.list_blocks);
        if smaller {
            let segment = self.slice_triangles.min(self.most_segment_triangles).min(most_blocks * 32);
            if segment <= 32 {
                return false;
            }
            self.slice_triangles = segment / 2;
            self.slice_planes /= 2;
            self.most_segment_triangles = self.slice_triangles;
        }
        true
    }
}

/// Room for clipping in front of a limit.
fn shrink(most: u32) -> u32 {
    (most - most / 8).saturating_sub(8192).max(64)
}

/// An estimate with room for clipping.
fn grow(estimate: u32, slack: u32) -> u32 {
    estimate.saturating_add(estimate / 8).saturating_add(slack)
}
