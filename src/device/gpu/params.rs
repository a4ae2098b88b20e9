//! What a dispatch works on: the twin of `TpParams` in `shaders/common.wgsl`.

use bytemuck::{Pod, Zeroable};

/// A dispatch's parameters. Offsets into the list buffer and the record buffer are in words.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct Params {
    /// Columns and rows of the surface.
    pub size: [u32; 2],
    /// Columns and rows of bins.
    pub bins: [u32; 2],
    /// First triangle of the segment.
    pub first_triangle: u32,
    /// Triangles of the segment.
    pub triangle_count: u32,
    /// Blocks of 32 triangles.
    pub blocks: u32,
    /// Super blocks of 1024 triangles.
    pub supers: u32,
    /// Masks of triangles: a word for each bin and block.
    pub mask_base: u32,
    /// Counts, later offsets within the bin's list: a word for each bin and super block.
    pub count_base: u32,
    /// For each bin the first block of its list and its length.
    pub bin_base: u32,
    /// The bins that are not empty.
    pub active_base: u32,
    /// Lists of triangles, in blocks of 32 entries.
    pub list_base: u32,
    /// Masks of entries: 64 words (one a tile) for each block of a list.
    pub tile_base: u32,
    /// Records of entries, `ENTRY_WORDS` each.
    pub entry_base: u32,
    /// Blocks that lists may take.
    pub list_blocks: u32,
    /// Row 0 is GL's top row.
    pub top_first: u32,
    /// Draw records.
    pub draws: u32,
    /// The tiles that have any triangle: bin * 64 + tile.
    pub work_base: u32,
    /// Reserved, zero.
    pub reserved: [u32; 2],
    /// Largest depth value.
    pub depth_max: u32,
    /// Depth and stencil to clear to.
    pub clear_depth: u32,
    /// Bits of depth and stencil that the clear writes.
    pub clear_depth_mask: u32,
    /// First column and row that the clear writes.
    pub clear_min: [i32; 2],
    /// One past the last.
    pub clear_max: [i32; 2],
    /// Colour words to clear to.
    pub clear_color: [u32; 4],
    /// Bits of them that the clear writes.
    pub clear_mask: [u32; 4],
}
