//! Begin and End, and the commands between them (2.6, 2.7).
//!
//! Each attribute command writes the current value. Between Begin and End it also writes the template of the next vertex, if the
//! vertex program reads the attribute; glVertex appends the template to the run. So only attributes that were given between
//! Begin and End, and that somebody reads, cost anything per vertex.

use super::Context;
use super::enums::*;
use super::vertex_materials::ShadedRun;
use crate::draw::assembly::{Part, PrimitiveType, carry};
use crate::draw::recorder::{Run, slots};
use crate::raster::layout::ATTRIBUTES;

/// Attribute slots.
#[allow(missing_docs)]
pub mod slot {
    pub const POSITION: usize = 0;
    pub const NORMAL: usize = 2;
    pub const COLOR: usize = 3;
    pub const SECONDARY_COLOR: usize = 4;
    pub const FOG_COORD: usize = 5;
    pub const TEX_COORD0: usize = 8;
}

/// Vertices of a run before it is handed on, so that it stays in the cache. A multiple of 12: no primitive is cut.
const RUN_LIMIT: u32 = 6 * 1024;

/// The primitive under construction: vertices since Begin, or since the last hand-over.
pub(crate) struct Immediate {
    mode: Option<PrimitiveType>,
    /// Slots worth storing per vertex, while inside Begin and End; else none.
    wanted: u32,
    /// Slots that the vertices have; bit 0 always.
    mask: u32,
    /// Place in the template of each slot in `mask`.
    rank: [u8; ATTRIBUTES],
    /// Attributes a vertex.
    stride: usize,
    template: [[f32; 4]; ATTRIBUTES],
    data: Vec<[f32; 4]>,
    count: u32,
    /// By vertex, from the first false one on.
    edge_flags: Option<Vec<bool>>,
    continued: bool,
    /// Vertices before those in `data`, where a material changed since Begin.
    pub(super) shaded: Option<Box<ShadedRun>>,
}

impl Default for Immediate {
    fn default() -> Immediate {
        Immediate {
            mode: None,
            wanted: 0,
            mask: 1,
            rank: [0; ATTRIBUTES],
            stride: 1,
            template: [[0.0; 4]; ATTRIBUTES],
            data: Vec::new(),
            count: 0,
            edge_flags: None,
            continued: false,
            shaded: None,
        }
    }
}

impl Immediate {
    /// Between Begin and End.
    #[inline]
    pub fn is_inside(&self) -> bool {
        self.mode.is_some()
    }

    /// The primitive type, between Begin and End.
    pub(super) fn mode(&self) -> Option<PrimitiveType> {
        self.mode
    }

    /// Starts a primitive. Attributes that the last one had stay in the layout, as their calls will likely come again.
    pub(super) fn begin(&mut self, mode: PrimitiveType, wanted: u32, current: &[[f32; 4]; ATTRIBUTES], edge_flag: bool) {
        self.mode = Some(mode);
        self.wanted = wanted & !1;
        self.continued = false;
        self.count = 0;
        self.data.clear();
        self.edge_flags = (!edge_flag).then(Vec::new);
        self.set_mask(self.mask & wanted | 1);
        for slot in slots(self.mask & !1) {
            self.template[self.rank[slot] as usize] = current[slot];
        }
    }

    fn set_mask(&mut self, mask: u32) {
        if mask == self.mask {
            return;
        }
        self.mask = mask;
        self.stride = mask.count_ones() as usize;
        for (rank, slot) in slots(mask).enumerate() {
            self.rank[slot] = rank as u8;
        }
    }

    /// Stores an attribute for the vertices that follow; `old` was its value for those before.
    #[inline]
    pub(super) fn attribute(&mut self, slot: usize, value: [f32; 4], old: [f32; 4]) {
        if self.wanted & 1 << slot == 0 {
            return;
        }
        if self.mask & 1 << slot == 0 {
            self.grow(slot, old);
        }
        self.template[self.rank[slot] as usize] = value;
    }

    /// A new slot: the vertices so far and the template get it.
    #[cold]
    fn grow(&mut self, slot: usize, old: [f32; 4]) {
        let at = (self.mask & ((1 << slot) - 1)).count_ones() as usize;
        let stride = self.stride;
        if self.count > 0 {
            let mut data = Vec::with_capacity(self.data.capacity() / stride * (stride + 1));
            for vertex in self.data.chunks_exact(stride) {
                data.extend_from_slice(&vertex[..at]);
                data.push(old);
                data.extend_from_slice(&vertex[at..]);
            }
            self.data = data;
        }
        self.template.copy_within(at..stride, at + 1);
        self.set_mask(self.mask | 1 << slot);
    }

    #[inline]
    pub(super) fn vertex(&mut self, position: [f32; 4], edge_flag: bool) {
        self.template[0] = position;
        let t = &self.template;
        // Known lengths compile to a few stores.
        match self.stride {
            1 => self.data.push(t[0]),
            2 => self.data.extend_from_slice(&[t[0], t[1]]),
            3 => self.data.extend_from_slice(&[t[0], t[1], t[2]]),
            4 => self.data.extend_from_slice(&[t[0], t[1], t[2], t[3]]),
            n => self.data.extend_from_slice(&t[..n]),
        }
        self.count += 1;
        if let Some(flags) = &mut self.edge_flags {
            flags.push(edge_flag);
        }
    }

    pub(super) fn run(&self) -> Run<'_> {
        Run { mask: self.mask, data: &self.data, count: self.count, edge_flags: self.edge_flags.as_deref() }
    }

    /// The values of the stored slots after the last vertex.
    pub(super) fn finals(&self) -> Vec<(usize, [f32; 4])> {
        slots(self.mask & !1).map(|slot| (slot, self.template[self.rank[slot] as usize])).collect()
    }

    /// The vertices.
    pub(super) fn into_data(self) -> Vec<[f32; 4]> {
        self.data
    }

    /// From here on the edge flags are stored by vertex.
    pub(super) fn start_edge_flags(&mut self) {
        let count = self.count as usize;
        self.edge_flags.get_or_insert_with(|| vec![true; count]);
    }

    /// Keeps the vertices that the next run needs, drops the rest.
    pub(super) fn keep(&mut self, carried: [Option<u32>; 3]) {
        let stride = self.stride;
        let mut kept = 0;
        for vertex in carried.into_iter().flatten().map(|i| i as usize) {
            self.data.copy_within(vertex * stride..(vertex + 1) * stride, kept * stride);
            if let Some(flags) = &mut self.edge_flags {
                flags[kept] = flags[vertex];
            }
            kept += 1;
        }
        self.data.truncate(kept * stride);
        if let Some(flags) = &mut self.edge_flags {
            flags.truncate(kept);
        }
        self.count = kept as u32;
    }
}

impl Context {
    /// glBegin.
    pub fn begin(&mut self, mode: GLenum) {
        if self.lists.builder.is_some() {
            return self.compile_begin(mode);
        }
        if self.inside_begin_end() {
            return;
        }
        let Some(mode) = PrimitiveType::from_gl(mode) else {
            return self.set_error(GL_INVALID_ENUM, "glBegin: mode");
        };
        if !self.can_draw("glBegin") {
            return;
        }
        let wanted = self.wanted_attributes(mode.topology());
        let current = &self.state.current;
        self.immediate.begin(mode, wanted, &current.attributes, current.edge_flag);
    }

    /// glEnd.
    pub fn end(&mut self) {
        if self.lists.builder.is_some() {
            return self.compile_end();
        }
        let mut immediate = std::mem::take(&mut self.immediate);
        let Some(mode) = immediate.mode.take() else {
            self.immediate = immediate;
            return self.set_error(GL_INVALID_OPERATION, "glEnd without glBegin");
        };
        immediate.wanted = 0;
        let part = Part { continued: immediate.continued, continues: false };
        if immediate.shaded.is_some() {
            self.submit_shaded(mode, part, &mut immediate);
        } else if immediate.count > 0 {
            self.submit_run(mode, part, &immediate.run(), false);
        }
        self.immediate = immediate;
    }

    /// Hands on what was collected, between Begin and End: the run is long. Primitives that are complete keep the state they were
    /// given in.
    #[cold]
    pub(crate) fn split_primitive(&mut self) {
        let mut immediate = std::mem::take(&mut self.immediate);
        if immediate.shaded.is_some() {
            // Shaded vertices wait for their End.
            self.immediate = immediate;
            return self.shade_before_change();
        }
        if let Some(mode) = immediate.mode {
            let (count, carried) = carry(mode, immediate.count);
            let part = Part { continued: immediate.continued, continues: true };
            let run = immediate.run();
            self.submit_run(mode, part, &Run { count, ..run }, false);
            immediate.continued |= count > 0;
            immediate.keep(carried);
        }
        self.immediate = immediate;
    }

    /// glVertex*.
    #[inline]
    pub fn vertex(&mut self, x: f32, y: f32, z: f32, w: f32) {
        if self.lists.builder.is_some() {
            return self.compile_vertex([x, y, z, w]);
        }
        if !self.immediate.is_inside() {
            return;
        }
        self.immediate.vertex([x, y, z, w], self.state.current.edge_flag);
        if self.immediate.count >= RUN_LIMIT {
            self.split_primitive();
        }
    }

    /// Sets the current value of an attribute slot.
    #[inline]
    pub(crate) fn attribute(&mut self, slot: usize, value: [f32; 4]) {
        if self.lists.builder.is_some() {
            return self.compile_attribute(slot, value);
        }
        let current = &mut self.state.current.attributes[slot];
        let old = std::mem::replace(current, value);
        self.immediate.attribute(slot, value, old);
    }

    /// glColor*.
    #[inline]
    pub fn color(&mut self, r: f32, g: f32, b: f32, a: f32) {
        self.attribute(slot::COLOR, [r, g, b, a]);
    }

    /// glSecondaryColor*.
    #[inline]
    pub fn secondary_color(&mut self, r: f32, g: f32, b: f32) {
        self.attribute(slot::SECONDARY_COLOR, [r, g, b, 1.0]);
    }

    /// glNormal*.
    #[inline]
    pub fn normal(&mut self, x: f32, y: f32, z: f32) {
        self.attribute(slot::NORMAL, [x, y, z, 1.0]);
    }

    /// glTexCoord*.
    #[inline]
    pub fn tex_coord(&mut self, s: f32, t: f32, r: f32, q: f32) {
        self.attribute(slot::TEX_COORD0, [s, t, r, q]);
    }

    /// glMultiTexCoord*.
    #[inline]
    pub fn multi_tex_coord(&mut self, texture: GLenum, s: f32, t: f32, r: f32, q: f32) {
        // A texture that does not exist is undefined (2.7); nothing is set.
        let unit = texture.wrapping_sub(GL_TEXTURE0) as usize;
        if unit < super::state::MAX_TEXTURE_UNITS {
            self.attribute(slot::TEX_COORD0 + unit, [s, t, r, q]);
        }
    }

    /// glFogCoord*.
    #[inline]
    pub fn fog_coord(&mut self, coord: f32) {
        self.attribute(slot::FOG_COORD, [coord, 0.0, 0.0, 1.0]);
    }

    /// glIndex*.
    pub fn index(&mut self, index: f32) {
        if self.compile(move |cx| cx.index(index)) {
            return;
        }
        self.state.current.index = index;
    }

    /// glEdgeFlag*.
    pub fn edge_flag(&mut self, flag: bool) {
        if self.lists.builder.is_some() {
            return self.compile_edge_flag(flag);
        }
        self.state.current.edge_flag = flag;
        if !flag && self.immediate.is_inside() {
            self.immediate.start_edge_flags();
        }
    }

    /// glRect* (2.10).
    pub fn rect(&mut self, x1: f32, y1: f32, x2: f32, y2: f32) {
        if self.compile(move |cx| cx.rect(x1, y1, x2, y2)) {
            return;
        }
        if self.inside_begin_end() {
            return;
        }
        self.begin(GL_QUADS);
        self.vertex(x1, y1, 0.0, 1.0);
        self.vertex(x2, y1, 0.0, 1.0);
        self.vertex(x2, y2, 0.0, 1.0);
        self.vertex(x1, y2, 0.0, 1.0);
        self.end();
    }
}
