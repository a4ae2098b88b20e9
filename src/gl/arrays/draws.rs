//! Drawing from vertex arrays: ArrayElement, DrawArrays, DrawElements and their kin (2.8).
//!
//! The elements that a draw uses are read once, straight into the batch. Indexed primitives refer to them where their indices lie
//! close together; scattered indices are gathered.

use std::ffi::c_void;

use super::fetch::{Elements, element, fetch, places};
use super::{Array, EDGE_FLAG, INDEX};
use crate::draw::assembly::{Assembly, Part, PrimitiveType, carry};
use crate::draw::recorder::{Run, VertexLayout, slots};
use crate::gl::Context;
use crate::gl::enums::*;
use crate::gl::list::PackedRun;

/// Most words of indices whose memory is kept from draw to draw.
const KEPT_INDICES: usize = 1 << 20;

/// # Safety
/// `count` indices of type `T` must be readable at `indices`, aligned or not.
unsafe fn widen<T: Copy + Into<u32>>(indices: *const c_void, count: usize, out: &mut Vec<u32>) -> &[u32] {
    out.clear();
    // SAFETY: the caller's promise.
    out.extend((0..count).map(|i| -> u32 { unsafe { indices.cast::<T>().add(i).read_unaligned() }.into() }));
    out
}

/// Indices into elements that are read from the arrays: index `i` names element `list[i] - first` of them.
#[derive(Clone, Copy)]
struct Indices<'a> {
    list: &'a [u32],
    first: u32,
}

impl Indices<'_> {
    #[inline(always)]
    fn element(&self, i: u32) -> u32 {
        self.list[i as usize].wrapping_sub(self.first)
    }
}

impl Context {
    /// glArrayElement.
    pub fn array_element(&mut self, index: i32) {
        let Ok(index) = u32::try_from(index) else {
            return self.set_error(GL_INVALID_VALUE, "glArrayElement: index");
        };
        let arrays = self.arrays.slots;
        let live = |array: &Array| array.is_live();
        for (slot, array) in arrays.iter().enumerate().skip(1).filter(|(_, array)| live(array)) {
            // SAFETY: the client promises that the element is there.
            let value = unsafe { element(array, index) };
            match slot {
                EDGE_FLAG => self.edge_flag(value[0] != 0.0),
                INDEX => self.index(value[0]),
                _ => self.attribute(slot, value),
            }
        }
        if live(&arrays[0]) {
            // SAFETY: as above.
            let [x, y, z, w] = unsafe { element(&arrays[0], index) };
            self.vertex(x, y, z, w);
        }
    }

    /// glDrawArrays.
    pub fn draw_arrays(&mut self, mode: GLenum, first: i32, count: i32) {
        if self.inside_begin_end() {
            return;
        }
        let Some(mode) = PrimitiveType::from_gl(mode) else {
            return self.set_error(GL_INVALID_ENUM, "glDrawArrays: mode");
        };
        let (Ok(first), Ok(count)) = (u32::try_from(first), u32::try_from(count)) else {
            return self.set_error(GL_INVALID_VALUE, "glDrawArrays: first or count");
        };
        if self.arrays.attributes & 1 == 0 || count == 0 {
            return;
        }
        if count <= self.recorder.chunk() {
            self.draw_elements_of(mode, Part::default(), Elements::Range { first, count }, None);
        } else {
            self.draw_in_chunks(mode, count, |k| first + k, false);
        }
    }

    /// glDrawElements.
    ///
    /// # Safety
    /// `count` indices of the type must be readable at `indices`.
    pub unsafe fn draw_elements(&mut self, mode: GLenum, count: i32, ty: GLenum, indices: *const c_void) {
        if self.inside_begin_end() {
            return;
        }
        let Some(mode) = PrimitiveType::from_gl(mode) else {
            return self.set_error(GL_INVALID_ENUM, "glDrawElements: mode");
        };
        let Ok(count) = usize::try_from(count) else {
            return self.set_error(GL_INVALID_VALUE, "glDrawElements: count");
        };
        if !matches!(ty, GL_UNSIGNED_BYTE | GL_UNSIGNED_SHORT | GL_UNSIGNED_INT) {
            return self.set_error(GL_INVALID_ENUM, "glDrawElements: type");
        }
        if self.arrays.attributes & 1 == 0 || indices.is_null() || count == 0 {
            return;
        }
        let mut widened = std::mem::take(&mut self.indices);
        // SAFETY: the caller's promise; the indices stay as they are until this returns.
        let list = unsafe {
            match ty {
                GL_UNSIGNED_BYTE => widen::<u8>(indices, count, &mut widened),
                GL_UNSIGNED_SHORT => widen::<u16>(indices, count, &mut widened),
                _ if indices.cast::<u32>().is_aligned() => std::slice::from_raw_parts(indices.cast(), count),
                _ => widen::<u32>(indices, count, &mut widened),
            }
        };
        if count as u64 <= u64::from(self.recorder.chunk()) {
            self.draw_indices(mode, Part::default(), list);
        } else {
            self.draw_in_chunks(mode, count as u32, |k| list[k as usize], true);
        }
        if widened.capacity() <= KEPT_INDICES {
            self.indices = widened;
        }
    }

    /// glDrawRangeElements: the range is a hint that nothing here needs.
    ///
    /// # Safety
    /// As for [`draw_elements`](Self::draw_elements).
    pub unsafe fn draw_range_elements(&mut self, mode: GLenum, start: u32, end: u32, count: i32, ty: GLenum, indices: *const c_void) {
        if end < start {
            return self.set_error(GL_INVALID_VALUE, "glDrawRangeElements: end before start");
        }
        // SAFETY: the caller's promise.
        unsafe { self.draw_elements(mode, count, ty, indices) };
    }

    /// A draw that is too long for one batch, in parts.
    fn draw_in_chunks(&mut self, mode: PrimitiveType, count: u32, index: impl Fn(u32) -> u32, indexed: bool) {
        let chunk = self.recorder.chunk();
        let (mut run, mut next, mut continued) = (Vec::new(), 0, false);
        while next < count {
            let end = count.min(next + chunk);
            run.extend((next..end).map(&index));
            next = end;
            let continues = next < count;
            let (now, carried) = if continues { carry(mode, run.len() as u32) } else { (run.len() as u32, [None; 3]) };
            let part = Part { continued, continues };
            if indexed {
                self.draw_indices(mode, part, &run[..now as usize]);
            } else {
                self.draw_elements_of(mode, part, Elements::List(&run[..now as usize]), None);
            }
            run = carried.into_iter().flatten().map(|i| run[i as usize]).collect();
            continued = true;
        }
    }

    fn draw_indices(&mut self, mode: PrimitiveType, part: Part, indices: &[u32]) {
        if indices.is_empty() {
            return;
        }
        let (least, greatest) = indices.iter().fold((u32::MAX, 0), |(least, greatest), &i| (i.min(least), i.max(greatest)));
        let range = u64::from(greatest - least) + 1;
        if range <= 2 * indices.len() as u64 {
            let elements = Elements::Range { first: least, count: range as u32 };
            return self.draw_elements_of(mode, part, elements, Some(Indices { list: indices, first: least }));
        }
        // Scattered: each element that is used, once.
        let mut used = indices.to_vec();
        used.sort_unstable();
        used.dedup();
        let local: Vec<u32> = indices.iter().map(|i| used.binary_search(i).unwrap_or(0) as u32).collect();
        self.draw_elements_of(mode, part, Elements::List(&used), Some(Indices { list: &local, first: 0 }));
    }

    /// Draws elements of the arrays, in their order or as `indices` (into the elements) say.
    fn draw_elements_of(&mut self, mode: PrimitiveType, part: Part, elements: Elements, indices: Option<Indices>) {
        if self.lists.builder.is_some() || self.render_mode != GL_RENDER {
            return self.draw_gathered(mode, part, elements, indices);
        }
        if !self.can_draw("drawing") {
            return;
        }
        if self.recorder.is_full() {
            self.flush_batch();
        }
        self.validate(mode.topology());
        let decomposition = self.decomposition(indices.is_some());
        let edge_flags = self.array_edge_flags(elements);
        let Some(program) = self.recorder.vertex_program() else { return };
        let mask = self.arrays.attributes & (program.attributes | 1);
        let layout = VertexLayout { mask, size: self.arrays.sizes };
        let Some((base, vertices)) = self.recorder.begin_vertices(layout, &self.state.current.attributes) else { return };
        let stride: usize = slots(mask).map(|slot| usize::from(layout.size[slot])).sum();
        let count = elements.count();
        let words = stride * count as usize;
        vertices.reserve(words);
        let mut offset = 0;
        for slot in slots(mask) {
            let array = &self.arrays.slots[slot];
            assert_eq!(layout.size[slot], array.size, "a layout has the sizes of its arrays");
            // SAFETY: the client promises that the elements are there.
            unsafe { fetch(array, elements, &mut vertices.spare_capacity_mut()[..words], offset, stride) };
            offset += usize::from(array.size);
        }
        // SAFETY: of every vertex each slot's array has written as many words as the layout has there.
        unsafe { vertices.set_len(vertices.len() + words) };
        self.recorder.finish_vertices(count);
        let (out, draw) = self.recorder.primitives();
        let assembly = Assembly { mode, part, decomposition, draw };
        match (indices, &edge_flags) {
            (Some(indices), None) if mode == PrimitiveType::Triangles => {
                assembly.listed_triangles(indices.list, base.wrapping_sub(indices.first), out);
            }
            (None, None) => assembly.run(count, |i| base + i, |_| true, out),
            (Some(indices), None) => assembly.run(indices.list.len() as u32, |i| base + indices.element(i), |_| true, out),
            (None, Some(flags)) => assembly.run(count, |i| base + i, |i| flags[i as usize], out),
            (Some(indices), Some(flags)) => {
                let edge = |i| flags[indices.element(i) as usize];
                assembly.run(indices.list.len() as u32, |i| base + indices.element(i), edge, out);
            }
        }
    }

    /// Edge flags of elements, where they are not all true.
    fn array_edge_flags(&self, elements: Elements) -> Option<Vec<bool>> {
        let array = &self.arrays.slots[EDGE_FLAG];
        if !array.is_live() {
            return (!self.state.current.edge_flag).then(|| vec![false; elements.count() as usize]);
        }
        let mut values = vec![0.0; elements.count() as usize];
        // SAFETY: the client promises that the elements are there.
        unsafe { fetch(array, elements, places(&mut values), 0, 1) };
        Some(values.into_iter().map(|value| value != 0.0).collect())
    }

    /// The slow way: the vertices as a run, for selection, feedback and display lists.
    fn draw_gathered(&mut self, mode: PrimitiveType, part: Part, elements: Elements, indices: Option<Indices>) {
        let mask = self.arrays.attributes;
        let stride = mask.count_ones() as usize;
        let count = elements.count() as usize;
        let mut data = vec![[0.0, 0.0, 0.0, 1.0]; count * stride];
        for (rank, slot) in slots(mask).enumerate() {
            // SAFETY: the client promises that the elements are there.
            unsafe { fetch(&self.arrays.slots[slot], elements, places(data.as_flattened_mut()), rank * 4, stride * 4) };
        }
        let mut edge_flags = self.array_edge_flags(elements);
        let mut count = count as u32;
        if let Some(indices) = indices {
            count = indices.list.len() as u32;
            let elements = (0..count).map(|i| indices.element(i) as usize);
            data = elements.clone().flat_map(|k| data[k * stride..][..stride].iter().copied()).collect();
            edge_flags = edge_flags.map(|flags| elements.map(|k| flags[k]).collect());
        }
        if self.lists.builder.is_some() {
            let has_edges = self.arrays.slots[EDGE_FLAG].enabled;
            let packed = PackedRun {
                mode,
                part,
                mask,
                count,
                edge_flags: edge_flags.clone().filter(|_| has_edges),
                leading: Vec::new(),
                leading_edges: if has_edges { 0 } else { count },
                finals: Vec::new(),
                final_edge: None,
                data: data.clone(),
            };
            let command = |cx: &mut Context| {
                cx.submit_run(mode, part, &Run { mask, data: &data, count, edge_flags: edge_flags.as_deref() }, true);
            };
            return self.compile_run(packed, command);
        }
        self.submit_run(mode, part, &Run { mask, data: &data, count, edge_flags: edge_flags.as_deref() }, indices.is_some());
    }
}

impl Context {
    /// glMultiDrawArrays.
    pub fn multi_draw_arrays(&mut self, mode: GLenum, first: &[i32], count: &[i32]) {
        for (&first, &count) in first.iter().zip(count) {
            self.draw_arrays(mode, first, count);
        }
    }
}
