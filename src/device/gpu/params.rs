//! What dispatches work on: the twins of `TpParams` in `shaders/common.wgsl` and `TpFront` in `shaders/front.wgsl`.

use bytemuck::{Pod, Zeroable};

/// Words of a segment's record: first triangle, triangles, blocks of 32, super blocks of 1024; the rest reserved.
pub const SEGMENT_WORDS: u32 = 8;

/// Places (words) in the buffer of indirect dispatches.
pub mod indirect {
    /// The tile stage's workgroups.
    pub const TILE: u32 = 0;
    /// The fine stage's: the tiles that have any triangle are counted in the word before.
    pub const FINE: u32 = 9;
    /// The set-up kernel's.
    pub const SETUP: u32 = 12;
    /// The clip kernel's.
    pub const CLIP: u32 = 16;
    /// What stopped the batch: [`super::Status`].
    pub const FAILED: u32 = 20;
    /// For each segment: the bin stage's workgroups, from the fifth word on those of count, from the ninth on those of emit.
    pub const SEGMENTS: u32 = 32;
    /// Words of a segment.
    pub const SEGMENT_WORDS: u32 = 12;
}

/// What the kernels say of a batch that did not fit its buffers: nothing was drawn from `action` on.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct Status {
    /// One more than the action that failed; 0: all went well.
    pub failed: u32,
    /// Triangles that set-up would have made.
    pub triangles: u32,
    /// vec4 of their planes.
    pub planes: u32,
    /// vec4 of vertices that clipping would have made.
    pub pool: u32,
    /// Primitives to clip.
    pub clipped: u32,
    /// Blocks of 32 triangles of the largest segment.
    pub blocks: u32,
    /// Blocks of 32 entries in the lists of the segment that failed.
    pub list_blocks: u32,
    /// Blocks of large triangles in the visible path.
    pub items: u32,
}

/// A dispatch's parameters. Offsets into the list buffer and the record buffer are in words.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct Params {
    /// Columns and rows of the surface.
    pub size: [u32; 2],
    /// Columns and rows of bins.
    pub bins: [u32; 2],
    /// Masks of triangles: a word for each bin and block.
    pub mask_base: u32,
    /// Counts, later offsets within the bin's list: a word for each super block and bin.
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
    /// The tiles that have any triangle: bin * 64 + tile.
    pub work_base: u32,
    /// Blocks that lists may take.
    pub list_blocks: u32,
    /// Row 0 is GL's top row.
    pub top_first: u32,
    /// Draw records.
    pub draws: u32,
    /// Number of the segment.
    pub segment: u32,
    /// -0, which no compiler of kernels knows: see `tp_mul` in `shaders/arithmetic.wgsl`.
    pub zero: f32,
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
    /// Number of the action, for [`Status::failed`].
    pub action: u32,
    /// 2^23, for sums that round to integers and that no compiler may simplify.
    pub magic: f32,
    /// Samples of a pixel.
    pub samples: u32,
    /// What all pixels of the surface were cleared to just before the segment, and need not be read: `fresh::*`. The values are the clear's.
    pub fresh: u32,
}

/// Bits of [`Params::fresh`].
pub mod fresh {
    /// Colour.
    pub const COLOR: u32 = 1;
    /// Depth and stencil.
    pub const DEPTH: u32 = 2;
    /// The clears of those were left out: the segment writes every pixel.
    pub const CLEARS: u32 = 4;
}

/// Parameters of the front end. Offsets are words of its records, unless said otherwise.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, Pod, Zeroable)]
pub struct FrontParams {
    /// Groups of primitives.
    pub groups: u32,
    /// Their table: first primitive, number of primitives.
    pub group_base: u32,
    /// Segments of the slice.
    pub segments: u32,
    /// Number of its first segment.
    pub first_segment: u32,
    /// The segments: first group, one past the last, blocks of 32 triangles that fit.
    pub segment_base: u32,
    /// Sums of counts, in words of the front buffer.
    pub sums_base: u32,
    /// The queue of primitives to clip, in words of the front buffer: its length, then from the fifth word on 4 words each.
    pub queue_base: u32,
    /// Primitives that the queue holds.
    pub queue_capacity: u32,
    /// Triangles that fit.
    pub triangle_capacity: u32,
    /// vec4 of planes that fit.
    pub plane_capacity: u32,
    /// First vec4 of the pool behind the shaded vertices.
    pub pool_base: u32,
    /// vec4 of the pool.
    pub pool_capacity: u32,
    /// Blocks of vertices: draw, first vertex.
    pub block_base: u32,
    /// Raster states.
    pub state_base: u32,
    /// Bins of the surface.
    pub bins: u32,
    /// Rows of them.
    pub bin_rows: u32,
    /// Lanes of a workgroup of the list stages.
    pub list_lanes: u32,
    /// Row 0 is GL's top row.
    pub top_first: u32,
    /// See [`Params::zero`].
    pub zero: f32,
    /// Number of the action, for [`Status::failed`].
    pub action: u32,
    /// Blocks of vertices of the dispatch.
    pub vertex_blocks: u32,
    /// Visible path: first primitive of the segment.
    pub first_primitive: u32,
    /// Its primitives.
    pub primitive_count: u32,
    /// Blocks of large triangles, in words of the queue: primitive, triangle, block, 3 words each.
    pub item_base: u32,
    /// Blocks that fit.
    pub item_capacity: u32,
    /// Corners of the fans that clipping left, in words of the queue, 3 a triangle.
    pub fan_base: u32,
    /// Triangles of fans that fit.
    pub fan_capacity: u32,
    /// The first triangle of a clipped primitive's fan, in words of the queue, a word a primitive.
    pub map_base: u32,
    /// Where the host has set up: the tiles of 8 x 8 pixels that triangles touch, in words of the queue.
    pub tile_base: u32,
    /// Their number.
    pub tile_count: u32,
    /// First vec4 of the shaded vertices that are there, as the draws count them.
    pub shaded_base: u32,
    /// vec4 that are there.
    pub shaded_count: u32,
    /// Visible path: the first row that has keys.
    pub first_row: u32,
    /// One past the last.
    pub end_row: u32,
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::device::gpu::source::{File, Options, expand, files};

    /// Names and offsets (bytes) of a kernel's structure, as naga lays it out.
    fn members(file: File, name: &str) -> Vec<(String, u32)> {
        let mut options = Options::default();
        options.flag("VISIBLE", true);
        // What the files want from elsewhere.
        let mut source = String::from(
            "const TP_COORDINATE_MIN = 0.0; const TP_COORDINATE_MAX = 1.0; const TP_STATE_VIEWPORT_SCALE = 0u;
            const TP_STATE_VIEWPORT_TRANSLATE = 0u; var<private> tp_front_records: array<u32, 4>; var<private> tp: TpParams;\n",
        );
        if name != "TpParams" {
            source = source.replace("var<private> tp: TpParams;", "");
        }
        expand(file, &options, &mut source);
        let module = naga::front::wgsl::parse_str(&source).unwrap_or_else(|e| panic!("{}", e.emit_to_string(&source)));
        let found = module.types.iter().find(|(_, t)| t.name.as_deref() == Some(name));
        let Some((_, naga::Type { inner: naga::TypeInner::Struct { members, .. }, .. })) = found else { panic!("no structure {name}") };
        members.iter().map(|m| (m.name.clone().unwrap_or_default(), m.offset)).collect()
    }

    macro_rules! offsets {
        ($record:ty, $($field:ident),* $(,)?) => {
            vec![$((stringify!($field).to_string(), std::mem::offset_of!($record, $field) as u32)),*]
        };
    }

    #[test]
    fn kernels_see_the_parameters_where_they_are() {
        let rust = offsets!(
            Params,
            size,
            bins,
            mask_base,
            count_base,
            bin_base,
            active_base,
            list_base,
            tile_base,
            entry_base,
            work_base,
            list_blocks,
            top_first,
            draws,
            segment,
            zero,
            depth_max,
            clear_depth,
            clear_depth_mask,
            clear_min,
            clear_max,
            clear_color,
            clear_mask,
            action,
            magic,
            samples,
            fresh
        );
        assert_eq!(members(files::COMMON, "TpParams"), rust);
    }

    #[test]
    fn kernels_see_the_front_ends_parameters_where_they_are() {
        let rust = offsets!(
            FrontParams,
            groups,
            group_base,
            segments,
            first_segment,
            segment_base,
            sums_base,
            queue_base,
            queue_capacity,
            triangle_capacity,
            plane_capacity,
            pool_base,
            pool_capacity,
            block_base,
            state_base,
            bins,
            bin_rows,
            list_lanes,
            top_first,
            zero,
            action,
            vertex_blocks,
            first_primitive,
            primitive_count,
            item_base,
            item_capacity,
            fan_base,
            fan_capacity,
            map_base,
            tile_base,
            tile_count,
            shaded_base,
            shaded_count,
            first_row,
            end_row
        );
        assert_eq!(members(files::FRONT, "TpFront"), rust);
    }
}
