//! The front end's records: draws with the place of their vertices, raster states, blocks of vertices; and slices: primitives that are
//! set up in one go, cut into the groups that workgroups work on.

use bytemuck::{bytes_of, cast_slice};

use super::adapter::Shape;
use super::params::{FrontParams, Params};
use super::records::DRAW_RECORD_WORDS;
use super::room::Room;
use super::stage::{VERTEX_BLOCK, front, group_size, sums_of_a_group};
use crate::draw::Batch;
use crate::raster::layout::*;

/// The part of the records that does not depend on slices.
pub struct FrontRecords {
    /// Draws, raster states, blocks of vertices.
    pub words: Vec<u32>,
    /// Where the raster states begin.
    pub state_base: u32,
    /// For each vertex program: the first draw that runs it, the first word of its blocks, and their number.
    pub programs: Vec<(usize, u32, u32)>,
}

impl FrontRecords {
    /// Of a batch.
    pub fn new(batch: &Batch) -> FrontRecords {
        let mut words = Vec::with_capacity(batch.draws.len() * DRAW_RECORD_WORDS);
        for draw in &batch.draws {
            words.extend_from_slice(cast_slice(bytes_of(&draw.record)));
        }
        let state_base = words.len() as u32;
        words.extend_from_slice(cast_slice(&batch.raster_states));
        // Draws by program, in order of first use.
        let mut ids: Vec<u64> = Vec::new();
        let mut programs: Vec<(usize, Vec<[u32; 2]>)> = Vec::new();
        for (k, draw) in batch.draws.iter().enumerate() {
            let id = draw.vertex_program.id;
            // Neighbours mostly share their program.
            let which = ids.iter().rposition(|&i| i == id).unwrap_or_else(|| {
                ids.push(id);
                programs.push((k, Vec::new()));
                ids.len() - 1
            });
            programs[which].1.extend((0..draw.record.vertex_count).step_by(VERTEX_BLOCK as usize).map(|first| [k as u32, first]));
        }
        let programs = programs
            .into_iter()
            .map(|(draw, blocks)| {
                let base = words.len() as u32;
                words.extend_from_slice(blocks.as_flattened());
                (draw, base, blocks.len() as u32)
            })
            .collect();
        FrontRecords { words, state_base, programs }
    }
}

/// Primitives that are set up in one go, in segments.
pub struct Slice {
    group_size: u32,
    sums: u32,
    first_segment: u32,
    groups: Vec<[u32; 2]>,
    segments: Vec<[u32; 3]>,
    /// Estimates: triangles, vec4 of planes.
    triangles: u32,
    planes: u32,
    primitives: u32,
    /// `stage::front::*` of its draws.
    pub features: u32,
    // The last draw that was weighed, and what its primitives take: triangles, planes.
    weighed: (usize, [u32; 2]),
}

impl Slice {
    /// Empty; `first_segment` is the number of its first segment.
    pub fn new(shape: Shape, first_segment: u32) -> Slice {
        Slice {
            group_size: group_size(shape),
            sums: sums_of_a_group(shape),
            first_segment,
            groups: Vec::new(),
            segments: Vec::new(),
            triangles: 0,
            planes: 0,
            primitives: 0,
            features: 0,
            weighed: (usize::MAX, [1, 2]),
        }
    }

    fn weigh(&mut self, batch: &Batch, draw: usize) -> [u32; 2] {
        if self.weighed.0 != draw {
            let record = &batch.draws[draw].record;
            let state = &batch.raster_states[record.raster_state as usize];
            let stride = DEPTH_PLANE_VEC4 + record.varying_count * VARYING_PLANE_VEC4;
            let unfilled = state.polygon_mode != [topology::TRIANGLES; 2];
            let (triangles, planes) = match record.topology {
                topology::TRIANGLES if unfilled => (6, 3 * stride),
                topology::TRIANGLES => (1, stride),
                _ => (2, stride),
            };
            self.weighed = (draw, [triangles, planes]);
        }
        self.weighed.1
    }

    /// Triangles that a primitive of a draw makes, clipping left aside.
    pub fn weight(&mut self, batch: &Batch, draw: usize) -> u32 {
        self.weigh(batch, draw)[0]
    }

    /// How many more primitives of a draw fit.
    pub fn fits(&mut self, room: &Room, batch: &Batch, draw: usize) -> u32 {
        let [triangles, planes] = self.weigh(batch, draw);
        let left =
            (room.slice_triangles.saturating_sub(self.triangles) / triangles).min(room.slice_planes.saturating_sub(self.planes) / planes);
        // An empty slice takes at least one.
        if self.primitives == 0 { left.max(1) } else { left }
    }

    /// Takes primitives of a draw in.
    pub fn add(&mut self, batch: &Batch, draw: usize, primitives: u32) {
        let [triangles, planes] = self.weigh(batch, draw);
        self.triangles += primitives * triangles;
        self.planes += primitives * planes;
        self.primitives += primitives;
        let record = &batch.draws[draw].record;
        let state = &batch.raster_states[record.raster_state as usize];
        let mut set = |bit: u32, on: bool| self.features |= if on { bit } else { 0 };
        let filled = state.polygon_mode == [topology::TRIANGLES; 2];
        let polygons = record.topology == topology::TRIANGLES;
        set(front::POINTS_AND_LINES, !polygons);
        set(front::UNFILLED, polygons && !filled);
        let smooth = raster_flags::POINT_SMOOTH | raster_flags::LINE_SMOOTH;
        set(front::SMOOTH, (!polygons || !filled) && state.flags & smooth != 0);
        let offset = raster_flags::OFFSET_FILL | raster_flags::OFFSET_LINE | raster_flags::OFFSET_POINT;
        set(front::OFFSET, polygons && state.flags & offset != 0);
    }

    /// Ends a segment, which may have so many blocks of 32 triangles.
    pub fn segment(&mut self, primitives: std::ops::Range<u32>, blocks: u32) {
        let first = self.groups.len() as u32;
        let end = primitives.end;
        self.groups.extend(primitives.step_by(self.group_size as usize).map(|p| [p, self.group_size.min(end - p)]));
        self.segments.push([first, self.groups.len() as u32, blocks]);
    }

    /// Appends its tables and returns its parameters, but for what depends on the buffers' sizes.
    pub fn finish(&self, room: &Room, base: Params, tables: &mut Vec<u32>, table_base: u32, action: u32) -> FrontParams {
        let group_base = table_base + tables.len() as u32;
        tables.extend_from_slice(self.groups.as_flattened());
        let segment_base = table_base + tables.len() as u32;
        tables.extend_from_slice(self.segments.as_flattened());
        let bins = base.bins[0] * base.bins[1];
        let queue_capacity = room.clipped(self.primitives);
        FrontParams {
            groups: self.groups.len() as u32,
            group_base,
            segments: self.segments.len() as u32,
            first_segment: self.first_segment,
            segment_base,
            // Counted from the end of the segments' records; made absolute with the buffers.
            sums_base: 0,
            queue_base: (self.groups.len() as u32 * self.sums + 1) * 4,
            queue_capacity,
            triangle_capacity: room.triangles(self.triangles),
            plane_capacity: room.planes(self.planes),
            pool_capacity: room.pool(self.primitives),
            bins,
            bin_rows: base.bins[1],
            top_first: base.top_first,
            zero: base.zero,
            action,
            ..FrontParams::default()
        }
    }
}
