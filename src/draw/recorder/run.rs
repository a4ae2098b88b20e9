//! Vertices on their way into a batch: runs of them, and how a draw lays them out.

use crate::raster::layout::{ATTRIBUTES, NONE};

/// A run of vertices with four words an attribute, in slot order, attribute 0 (position) always there.
#[derive(Clone, Copy)]
pub struct Run<'a> {
    /// The slots there.
    pub mask: u32,
    /// `count * mask.count_ones()` attributes.
    pub data: &'a [[f32; 4]],
    /// Number of vertices.
    pub count: u32,
    /// Edge flags by vertex; `None`: all true.
    pub edge_flags: Option<&'a [bool]>,
}

impl Run<'_> {
    /// Attribute `slot` of a vertex; from `current` where the run does not have it.
    pub fn attribute(&self, slot: usize, vertex: u32, current: &[[f32; 4]; ATTRIBUTES]) -> [f32; 4] {
        if self.mask & 1 << slot == 0 {
            return current[slot];
        }
        let stride = self.mask.count_ones();
        let rank = (self.mask & ((1 << slot) - 1)).count_ones();
        self.data[(vertex * stride + rank) as usize]
    }

    /// Edge flag of a vertex.
    pub fn edge_flag(&self, vertex: u32) -> bool {
        self.edge_flags.is_none_or(|flags| flags[vertex as usize])
    }
}

/// A vertex layout of a draw: which attributes its vertices have, and how many words of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct VertexLayout {
    /// Slots that vary from vertex to vertex.
    pub mask: u32,
    /// Words of each.
    pub size: [u8; ATTRIBUTES],
}

impl VertexLayout {
    /// Four words of each slot.
    pub fn full(mask: u32) -> VertexLayout {
        VertexLayout { mask, size: [4; ATTRIBUTES] }
    }

    pub(super) fn offsets(&self) -> ([u32; ATTRIBUTES], u32) {
        let (mut offset, mut stride) = ([NONE; ATTRIBUTES], 0);
        for slot in slots(self.mask) {
            offset[slot] = stride;
            stride += u32::from(self.size[slot]);
        }
        (offset, stride)
    }
}

/// The slots of a mask, in order.
pub fn slots(mut mask: u32) -> impl Iterator<Item = usize> {
    std::iter::from_fn(move || {
        let slot = mask.trailing_zeros();
        mask &= mask.wrapping_sub(1);
        (slot < 32).then_some(slot as usize)
    })
}

/// Appends a run's vertices in another layout of four words a slot.
pub(super) fn copy_run(run: &Run, mask: u32, current: &[[f32; 4]; ATTRIBUTES], out: &mut Vec<f32>) {
    let stride = run.mask.count_ones() as usize;
    // Where each attribute of the layout comes from: its rank in the run, or a constant.
    let mut sources = [(usize::MAX, [0.0; 4]); ATTRIBUTES];
    let mut used = 0;
    for slot in slots(mask) {
        let bit = 1 << slot;
        sources[used] =
            if run.mask & bit != 0 { ((run.mask & (bit - 1)).count_ones() as usize, [0.0; 4]) } else { (usize::MAX, current[slot]) };
        used += 1;
    }
    out.reserve(run.count as usize * used * 4);
    for vertex in run.data.chunks_exact(stride.max(1)).take(run.count as usize) {
        for &(rank, constant) in &sources[..used] {
            out.extend_from_slice(vertex.get(rank).unwrap_or(&constant));
        }
    }
}
