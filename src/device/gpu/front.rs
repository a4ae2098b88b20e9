//! The front end's records: draws with the place of their vertices, raster states, blocks of vertices; and slices: primitives that are
//! set up in one go, cut into the groups that workgroups work on.

use std::ops::Range;

use bytemuck::{bytes_of, cast_slice};

use super::adapter::Shape;
use super::budget::Cuts;
use super::params::FrontParams;
use super::records::DRAW_RECORD_WORDS;
use super::room::Room;
use super::stage::{VERTEX_BLOCK, front, group_size, sums_of_a_group};
use crate::draw::{Batch, Draw};
use crate::raster::layout::*;

/// The part of the records that does not depend on slices.
pub struct FrontRecords {
    /// Draws, raster states.
    pub words: Vec<u32>,
    /// Where the raster states begin.
    pub state_base: u32,
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
        FrontRecords { words, state_base }
    }
}

/// Blocks of vertices (draw, first vertex) whose shaded form may lie in a range of vec4: for each program, in order of first use, a draw
/// that runs it and its blocks.
pub fn vertex_blocks(batch: &Batch, shaded: Range<u32>) -> Vec<(usize, Vec<[u32; 2]>)> {
    let mut ids: Vec<u64> = Vec::new();
    let mut programs: Vec<(usize, Vec<[u32; 2]>)> = Vec::new();
    let end = |draw: &Draw| draw.record.shaded_base + draw.record.vertex_count * draw.record.shaded_stride;
    let first_draw = batch.draws.partition_point(|draw| end(draw) <= shaded.start);
    for (k, draw) in batch.draws.iter().enumerate().skip(first_draw) {
        let DrawRecord { shaded_base, shaded_stride, vertex_count, .. } = draw.record;
        if shaded_base >= shaded.end {
            break;
        }
        let id = draw.vertex_program.id;
        // Neighbours mostly share their program.
        let which = ids.iter().rposition(|&i| i == id).unwrap_or_else(|| {
            ids.push(id);
            programs.push((k, Vec::new()));
            ids.len() - 1
        });
        let first = shaded.start.saturating_sub(shaded_base) / shaded_stride;
        let end = (shaded.end - shaded_base).div_ceil(shaded_stride).min(vertex_count);
        programs[which].1.extend((first..end).step_by(VERTEX_BLOCK as usize).map(|first| [k as u32, first]));
    }
    programs
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
    /// vec4 of shaded vertices that it wants, from the first to the last.
    pub shaded: Range<u32>,
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
            shaded: 0..0,
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

    /// How many of a draw's next primitives fit.
    pub fn fits(&mut self, room: &Room, cuts: &Cuts, batch: &Batch, draw: usize, primitives: Range<u32>) -> u32 {
        let [triangles, planes] = self.weigh(batch, draw);
        // An empty slice takes at least one.
        let least = (self.primitives == 0) as u32;
        let each = cuts.bytes(triangles as u64, planes as u64);
        let left = cuts.slice_bytes.saturating_sub(cuts.bytes(self.triangles as u64, self.planes as u64));
        let mut fits = (primitives.end - primitives.start)
            .min(room.slice_triangles.saturating_sub(self.triangles) / triangles)
            .min(room.slice_planes.saturating_sub(self.planes) / planes)
            .min((left / each).min(u32::MAX as u64) as u32);
        if cuts.vertices {
            let mut shaded = self.shaded.clone();
            let fit = |k: &u32| {
                shaded = joined(&shaded, &shaded_range(batch, draw, primitives.start + k));
                (k + 1) as u64 * each + (shaded.end - shaded.start) as u64 * 16 <= left
            };
            fits = (0..fits).take_while(fit).count() as u32;
        }
        fits.max(least)
    }

    /// Takes primitives of a draw in.
    pub fn add(&mut self, cuts: &Cuts, batch: &Batch, draw: usize, primitives: Range<u32>) {
        let [triangles, planes] = self.weigh(batch, draw);
        let count = primitives.end - primitives.start;
        self.triangles += count * triangles;
        self.planes += count * planes;
        self.primitives += count;
        if cuts.vertices {
            self.shaded = primitives.map(|p| shaded_range(batch, draw, p)).fold(self.shaded.clone(), |a, b| joined(&a, &b));
        }
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
    pub fn segment(&mut self, primitives: Range<u32>, blocks: u32) {
        let first = self.groups.len() as u32;
        let end = primitives.end;
        self.groups.extend(primitives.step_by(self.group_size as usize).map(|p| [p, self.group_size.min(end - p)]));
        self.segments.push([first, self.groups.len() as u32, blocks]);
    }

    /// Appends its tables and returns its parameters, but for what depends on the buffers' sizes.
    pub fn finish(&self, room: &Room, base: FrontParams, tables: &mut Vec<u32>, table_base: u32) -> FrontParams {
        let group_base = table_base + tables.len() as u32;
        tables.extend_from_slice(self.groups.as_flattened());
        let segment_base = table_base + tables.len() as u32;
        tables.extend_from_slice(self.segments.as_flattened());
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
            ..base
        }
    }
}

/// The vec4 of shaded vertices that a primitive wants, from the first to the last.
fn shaded_range(batch: &Batch, draw: usize, primitive: u32) -> Range<u32> {
    let record = &batch.draws[draw].record;
    let v = &batch.primitives[primitive as usize].v[..record.topology as usize + 1];
    let at = |v: u32| record.shaded_base + v * record.shaded_stride;
    let (first, last) = v.iter().fold((u32::MAX, 0), |(first, last), &v| (first.min(v), last.max(v)));
    at(first)..at(last + 1)
}

/// From the start of the first to the end of the last of two ranges; the other where one is empty.
fn joined(a: &Range<u32>, b: &Range<u32>) -> Range<u32> {
    match (a.is_empty(), b.is_empty()) {
        (true, _) => b.clone(),
        (_, true) => a.clone(),
        _ => a.start.min(b.start)..a.end.max(b.end),
    }
}
