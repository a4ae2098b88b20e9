//! Vertex arrays (2.8): where they lie and what is in them. Drawing from them is in [`draws`], reading in [`fetch`].

use std::ffi::c_void;

use super::Context;
use super::begin_end::slot;
use super::enums::*;
use super::state::{ATTRIB_STACK_DEPTH, MAX_TEXTURE_UNITS, PixelStore};
use crate::raster::layout::ATTRIBUTES;

mod draws;
mod fetch;

/// Slots that only arrays have: they feed no attribute of a vertex program.
pub(crate) const EDGE_FLAG: usize = 6;
pub(crate) const INDEX: usize = 7;

/// Type of an array's components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum ComponentType {
    Byte,
    UnsignedByte,
    Short,
    UnsignedShort,
    Int,
    UnsignedInt,
    Float,
    Double,
}

impl ComponentType {
    fn from_gl(ty: GLenum) -> Option<ComponentType> {
        Some(match ty {
            GL_BYTE => ComponentType::Byte,
            GL_UNSIGNED_BYTE => ComponentType::UnsignedByte,
            GL_SHORT => ComponentType::Short,
            GL_UNSIGNED_SHORT => ComponentType::UnsignedShort,
            GL_INT => ComponentType::Int,
            GL_UNSIGNED_INT => ComponentType::UnsignedInt,
            GL_FLOAT => ComponentType::Float,
            GL_DOUBLE => ComponentType::Double,
            _ => return None,
        })
    }

    fn to_gl(self) -> GLenum {
        match self {
            ComponentType::Byte => GL_BYTE,
            ComponentType::UnsignedByte => GL_UNSIGNED_BYTE,
            ComponentType::Short => GL_SHORT,
            ComponentType::UnsignedShort => GL_UNSIGNED_SHORT,
            ComponentType::Int => GL_INT,
            ComponentType::UnsignedInt => GL_UNSIGNED_INT,
            ComponentType::Float => GL_FLOAT,
            ComponentType::Double => GL_DOUBLE,
        }
    }

    fn bytes(self) -> usize {
        match self {
            ComponentType::Byte | ComponentType::UnsignedByte => 1,
            ComponentType::Short | ComponentType::UnsignedShort => 2,
            ComponentType::Int | ComponentType::UnsignedInt | ComponentType::Float => 4,
            ComponentType::Double => 8,
        }
    }
}

/// One vertex array.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Array {
    pub enabled: bool,
    /// Components, 1 to 4.
    pub size: u8,
    pub ty: ComponentType,
    /// As it was given; 0 means tightly packed.
    pub stride: i32,
    pub pointer: *const u8,
    /// Integers map to [0, 1] or [-1, 1].
    pub normalized: bool,
}

// SAFETY: the pointer is the client's; it is followed only in draw calls, where the client promises that it is good,
// on whichever thread the context is current then.
unsafe impl Send for Array {}
// SAFETY: as above; a shared array is never followed.
unsafe impl Sync for Array {}

impl Array {
    /// Enabled, and with memory behind it: glInterleavedArrays with NULL makes addresses of a few bytes.
    fn is_live(&self) -> bool {
        self.enabled && self.pointer as usize >= 4096
    }

    /// Bytes from one element to the next.
    fn step(&self) -> usize {
        if self.stride == 0 { self.ty.bytes() * usize::from(self.size) } else { self.stride as usize }
    }
}

/// Client state of the vertex arrays, by attribute slot.
#[derive(Clone, Debug)]
pub(crate) struct Arrays {
    slots: [Array; ATTRIBUTES],
    /// Texture unit of glTexCoordPointer.
    pub active_texture: usize,
    /// Live slots that feed vertex attributes, as a mask.
    attributes: u32,
    /// Components by slot.
    sizes: [u8; ATTRIBUTES],
}

impl Default for Arrays {
    fn default() -> Arrays {
        let array =
            |size| Array { enabled: false, size, ty: ComponentType::Float, stride: 0, pointer: std::ptr::null(), normalized: false };
        let mut slots = [array(4); ATTRIBUTES];
        slots[slot::NORMAL].size = 3;
        slots[slot::SECONDARY_COLOR].size = 3;
        slots[slot::FOG_COORD].size = 1;
        slots[EDGE_FLAG] = Array { ty: ComponentType::UnsignedByte, ..array(1) };
        slots[INDEX].size = 1;
        for slot in [slot::NORMAL, slot::COLOR, slot::SECONDARY_COLOR] {
            slots[slot].normalized = true;
        }
        Arrays { slots, active_texture: 0, attributes: 0, sizes: slots.map(|array| array.size) }
    }
}

impl Arrays {
    /// Changes a slot's array.
    fn change(&mut self, slot: usize, change: impl FnOnce(&mut Array)) {
        change(&mut self.slots[slot]);
        let live = self.slots[slot].is_live() && !matches!(slot, EDGE_FLAG | INDEX);
        self.attributes = self.attributes & !(1 << slot) | u32::from(live) << slot;
        self.sizes[slot] = self.slots[slot].size;
    }

    fn slot_of(&self, array: GLenum) -> Option<usize> {
        Some(match array {
            GL_VERTEX_ARRAY => slot::POSITION,
            GL_NORMAL_ARRAY => slot::NORMAL,
            GL_COLOR_ARRAY => slot::COLOR,
            GL_SECONDARY_COLOR_ARRAY => slot::SECONDARY_COLOR,
            GL_FOG_COORD_ARRAY => slot::FOG_COORD,
            GL_INDEX_ARRAY => INDEX,
            GL_EDGE_FLAG_ARRAY => EDGE_FLAG,
            GL_TEXTURE_COORD_ARRAY => slot::TEX_COORD0 + self.active_texture,
            _ => return None,
        })
    }

    /// glIsEnabled of a client array; `None` if `array` is no array.
    pub fn is_enabled(&self, array: GLenum) -> Option<bool> {
        self.slot_of(array).map(|slot| self.slots[slot].enabled)
    }

    /// glGet of GL_VERTEX_ARRAY_SIZE and its like; `None` if `pname` is none of them.
    pub fn get(&self, pname: GLenum) -> Option<i32> {
        let of = |array: GLenum| self.slot_of(array).map(|slot| &self.slots[slot]);
        let size = |array| of(array).map(|a| i32::from(a.size));
        let ty = |array| of(array).map(|a| a.ty.to_gl() as i32);
        let stride = |array| of(array).map(|a| a.stride);
        match pname {
            GL_VERTEX_ARRAY_SIZE => size(GL_VERTEX_ARRAY),
            GL_VERTEX_ARRAY_TYPE => ty(GL_VERTEX_ARRAY),
            GL_VERTEX_ARRAY_STRIDE => stride(GL_VERTEX_ARRAY),
            GL_NORMAL_ARRAY_TYPE => ty(GL_NORMAL_ARRAY),
            GL_NORMAL_ARRAY_STRIDE => stride(GL_NORMAL_ARRAY),
            GL_COLOR_ARRAY_SIZE => size(GL_COLOR_ARRAY),
            GL_COLOR_ARRAY_TYPE => ty(GL_COLOR_ARRAY),
            GL_COLOR_ARRAY_STRIDE => stride(GL_COLOR_ARRAY),
            GL_SECONDARY_COLOR_ARRAY_SIZE => size(GL_SECONDARY_COLOR_ARRAY),
            GL_SECONDARY_COLOR_ARRAY_TYPE => ty(GL_SECONDARY_COLOR_ARRAY),
            GL_SECONDARY_COLOR_ARRAY_STRIDE => stride(GL_SECONDARY_COLOR_ARRAY),
            GL_FOG_COORD_ARRAY_TYPE => ty(GL_FOG_COORD_ARRAY),
            GL_FOG_COORD_ARRAY_STRIDE => stride(GL_FOG_COORD_ARRAY),
            GL_INDEX_ARRAY_TYPE => ty(GL_INDEX_ARRAY),
            GL_INDEX_ARRAY_STRIDE => stride(GL_INDEX_ARRAY),
            GL_TEXTURE_COORD_ARRAY_SIZE => size(GL_TEXTURE_COORD_ARRAY),
            GL_TEXTURE_COORD_ARRAY_TYPE => ty(GL_TEXTURE_COORD_ARRAY),
            GL_TEXTURE_COORD_ARRAY_STRIDE => stride(GL_TEXTURE_COORD_ARRAY),
            GL_EDGE_FLAG_ARRAY_STRIDE => stride(GL_EDGE_FLAG_ARRAY),
            GL_CLIENT_ACTIVE_TEXTURE => Some(GL_TEXTURE0 as i32 + self.active_texture as i32),
            _ => None,
        }
    }

    /// glGetPointerv of an array; `None` if `pname` is none of theirs.
    pub fn pointer(&self, pname: GLenum) -> Option<*const c_void> {
        let array = match pname {
            GL_VERTEX_ARRAY_POINTER => GL_VERTEX_ARRAY,
            GL_NORMAL_ARRAY_POINTER => GL_NORMAL_ARRAY,
            GL_COLOR_ARRAY_POINTER => GL_COLOR_ARRAY,
            GL_SECONDARY_COLOR_ARRAY_POINTER => GL_SECONDARY_COLOR_ARRAY,
            GL_FOG_COORD_ARRAY_POINTER => GL_FOG_COORD_ARRAY,
            GL_INDEX_ARRAY_POINTER => GL_INDEX_ARRAY,
            GL_TEXTURE_COORD_ARRAY_POINTER => GL_TEXTURE_COORD_ARRAY,
            GL_EDGE_FLAG_ARRAY_POINTER => GL_EDGE_FLAG_ARRAY,
            _ => return None,
        };
        self.slot_of(array).map(|slot| self.slots[slot].pointer.cast())
    }
}

/// What glPushClientAttrib saved.
pub(crate) struct SavedClient {
    stores: Option<(PixelStore, PixelStore)>,
    arrays: Option<Arrays>,
}

/// A format of glInterleavedArrays (table 2.5): components of texture coordinates, colours and their type, normal, vertex.
struct Interleaved {
    texture: u8,
    color: u8,
    color_bytes: bool,
    normal: bool,
    vertex: u8,
}

fn interleaved(format: GLenum) -> Option<Interleaved> {
    let f = |texture, color, color_bytes, normal, vertex| Some(Interleaved { texture, color, color_bytes, normal, vertex });
    match format {
        GL_V2F => f(0, 0, false, false, 2),
        GL_V3F => f(0, 0, false, false, 3),
        GL_C4UB_V2F => f(0, 4, true, false, 2),
        GL_C4UB_V3F => f(0, 4, true, false, 3),
        GL_C3F_V3F => f(0, 3, false, false, 3),
        GL_N3F_V3F => f(0, 0, false, true, 3),
        GL_C4F_N3F_V3F => f(0, 4, false, true, 3),
        GL_T2F_V3F => f(2, 0, false, false, 3),
        GL_T4F_V4F => f(4, 0, false, false, 4),
        GL_T2F_C4UB_V3F => f(2, 4, true, false, 3),
        GL_T2F_C3F_V3F => f(2, 3, false, false, 3),
        GL_T2F_N3F_V3F => f(2, 0, false, true, 3),
        GL_T2F_C4F_N3F_V3F => f(2, 4, false, true, 3),
        GL_T4F_C4F_N3F_V4F => f(4, 4, false, true, 4),
        _ => None,
    }
}

impl Context {
    /// Client state is set at once, never compiled into a list (5.4).
    ///
    /// # Safety
    /// While the array is enabled, draws may read the elements that they name through `pointer`.
    unsafe fn set_array(
        &mut self,
        slot: usize,
        size: i32,
        sizes: &[i32],
        ty: GLenum,
        types: &[GLenum],
        stride: i32,
        pointer: *const c_void,
        what: &str,
    ) {
        if self.inside_begin_end() {
            return;
        }
        if !sizes.contains(&size) || stride < 0 {
            return self.set_error(GL_INVALID_VALUE, what);
        }
        let Some(ty) = ComponentType::from_gl(ty).filter(|_| types.contains(&ty)) else {
            return self.set_error(GL_INVALID_ENUM, what);
        };
        self.arrays.change(slot, |array| {
            (array.size, array.ty, array.stride, array.pointer) = (size as u8, ty, stride, pointer.cast());
        });
    }

    /// glVertexPointer.
    ///
    /// # Safety
    /// While the array is enabled, draws may read the elements that they name through `pointer`.
    pub unsafe fn vertex_pointer(&mut self, size: i32, ty: GLenum, stride: i32, pointer: *const c_void) {
        // SAFETY: passed on.
        unsafe {
            self.set_array(
                slot::POSITION,
                size,
                &[2, 3, 4],
                ty,
                &[GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE],
                stride,
                pointer,
                "glVertexPointer",
            )
        };
    }

    /// glNormalPointer.
    ///
    /// # Safety
    /// While the array is enabled, draws may read the elements that they name through `pointer`.
    pub unsafe fn normal_pointer(&mut self, ty: GLenum, stride: i32, pointer: *const c_void) {
        let types = [GL_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE];
        // SAFETY: passed on.
        unsafe { self.set_array(slot::NORMAL, 3, &[3], ty, &types, stride, pointer, "glNormalPointer") };
    }

    /// glColorPointer.
    ///
    /// # Safety
    /// While the array is enabled, draws may read the elements that they name through `pointer`.
    pub unsafe fn color_pointer(&mut self, size: i32, ty: GLenum, stride: i32, pointer: *const c_void) {
        // SAFETY: passed on.
        unsafe { self.set_array(slot::COLOR, size, &[3, 4], ty, &COLOR_TYPES, stride, pointer, "glColorPointer") };
    }

    /// glSecondaryColorPointer.
    ///
    /// # Safety
    /// While the array is enabled, draws may read the elements that they name through `pointer`.
    pub unsafe fn secondary_color_pointer(&mut self, size: i32, ty: GLenum, stride: i32, pointer: *const c_void) {
        // SAFETY: passed on.
        unsafe { self.set_array(slot::SECONDARY_COLOR, size, &[3], ty, &COLOR_TYPES, stride, pointer, "glSecondaryColorPointer") };
    }

    /// glFogCoordPointer.
    ///
    /// # Safety
    /// While the array is enabled, draws may read the elements that they name through `pointer`.
    pub unsafe fn fog_coord_pointer(&mut self, ty: GLenum, stride: i32, pointer: *const c_void) {
        // SAFETY: passed on.
        unsafe { self.set_array(slot::FOG_COORD, 1, &[1], ty, &[GL_FLOAT, GL_DOUBLE], stride, pointer, "glFogCoordPointer") };
    }

    /// glTexCoordPointer, for the client's active texture unit.
    ///
    /// # Safety
    /// While the array is enabled, draws may read the elements that they name through `pointer`.
    pub unsafe fn tex_coord_pointer(&mut self, size: i32, ty: GLenum, stride: i32, pointer: *const c_void) {
        let slot = slot::TEX_COORD0 + self.arrays.active_texture;
        // SAFETY: passed on.
        unsafe {
            self.set_array(slot, size, &[1, 2, 3, 4], ty, &[GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE], stride, pointer, "glTexCoordPointer")
        };
    }

    /// glIndexPointer.
    ///
    /// # Safety
    /// While the array is enabled, draws may read the elements that they name through `pointer`.
    pub unsafe fn index_pointer(&mut self, ty: GLenum, stride: i32, pointer: *const c_void) {
        let types = [GL_UNSIGNED_BYTE, GL_SHORT, GL_INT, GL_FLOAT, GL_DOUBLE];
        // SAFETY: passed on.
        unsafe { self.set_array(INDEX, 1, &[1], ty, &types, stride, pointer, "glIndexPointer") };
    }

    /// glEdgeFlagPointer.
    ///
    /// # Safety
    /// While the array is enabled, draws may read the elements that they name through `pointer`.
    pub unsafe fn edge_flag_pointer(&mut self, stride: i32, pointer: *const c_void) {
        // SAFETY: passed on.
        unsafe { self.set_array(EDGE_FLAG, 1, &[1], GL_UNSIGNED_BYTE, &[GL_UNSIGNED_BYTE], stride, pointer, "glEdgeFlagPointer") };
    }

    /// glEnableClientState.
    pub fn enable_client_state(&mut self, array: GLenum) {
        self.set_client_state(array, true);
    }

    /// glDisableClientState.
    pub fn disable_client_state(&mut self, array: GLenum) {
        self.set_client_state(array, false);
    }

    fn set_client_state(&mut self, array: GLenum, enabled: bool) {
        if self.inside_begin_end() {
            return;
        }
        match self.arrays.slot_of(array) {
            Some(slot) => self.arrays.change(slot, |array| array.enabled = enabled),
            None => self.set_error(GL_INVALID_ENUM, "glEnableClientState or glDisableClientState: array"),
        }
    }

    /// glClientActiveTexture.
    pub fn client_active_texture(&mut self, texture: GLenum) {
        if self.inside_begin_end() {
            return;
        }
        let unit = texture.wrapping_sub(GL_TEXTURE0) as usize;
        if unit >= MAX_TEXTURE_UNITS {
            return self.set_error(GL_INVALID_ENUM, "glClientActiveTexture: texture");
        }
        self.arrays.active_texture = unit;
    }

    /// glInterleavedArrays.
    ///
    /// # Safety
    /// While the array is enabled, draws may read the elements that they name through `pointer`.
    pub unsafe fn interleaved_arrays(&mut self, format: GLenum, stride: i32, pointer: *const c_void) {
        if self.inside_begin_end() {
            return;
        }
        let Some(layout) = interleaved(format) else {
            return self.set_error(GL_INVALID_ENUM, "glInterleavedArrays: format");
        };
        if stride < 0 {
            return self.set_error(GL_INVALID_VALUE, "glInterleavedArrays: stride");
        }
        let color_bytes = if layout.color_bytes { 4 } else { usize::from(layout.color) * 4 };
        let texture_bytes = usize::from(layout.texture) * 4;
        let normal_bytes = if layout.normal { 12 } else { 0 };
        let tight = texture_bytes + color_bytes + normal_bytes + usize::from(layout.vertex) * 4;
        let stride = if stride == 0 { tight as i32 } else { stride };
        for slot in [slot::SECONDARY_COLOR, slot::FOG_COORD, EDGE_FLAG, INDEX] {
            self.arrays.change(slot, |array| array.enabled = false);
        }
        let coordinates = slot::TEX_COORD0 + self.arrays.active_texture;
        let mut offset = 0;
        let mut place = |slot: usize, size: u8, ty: ComponentType, bytes: usize| {
            self.arrays.change(slot, |array| {
                array.enabled = size > 0;
                if size > 0 {
                    // An address only: nothing is read before a draw call.
                    let pointer = pointer.cast::<u8>().wrapping_add(offset);
                    (array.size, array.ty, array.stride, array.pointer) = (size, ty, stride, pointer);
                }
            });
            offset += bytes;
        };
        place(coordinates, layout.texture, ComponentType::Float, texture_bytes);
        let color_type = if layout.color_bytes { ComponentType::UnsignedByte } else { ComponentType::Float };
        place(slot::COLOR, layout.color, color_type, color_bytes);
        place(slot::NORMAL, if layout.normal { 3 } else { 0 }, ComponentType::Float, normal_bytes);
        place(slot::POSITION, layout.vertex, ComponentType::Float, usize::from(layout.vertex) * 4);
    }

    /// glPushClientAttrib.
    pub fn push_client_attrib(&mut self, mask: u32) {
        if self.inside_begin_end() {
            return;
        }
        if self.client_stack.len() >= ATTRIB_STACK_DEPTH {
            return self.set_error(GL_STACK_OVERFLOW, "glPushClientAttrib");
        }
        let stores = (mask & GL_CLIENT_PIXEL_STORE_BIT != 0).then(|| (self.state.pack.clone(), self.state.unpack.clone()));
        let arrays = (mask & GL_CLIENT_VERTEX_ARRAY_BIT != 0).then(|| self.arrays.clone());
        self.client_stack.push(SavedClient { stores, arrays });
    }

    /// GL_CLIENT_ATTRIB_STACK_DEPTH.
    pub(crate) fn client_attrib_depth(&self) -> u32 {
        self.client_stack.len() as u32
    }

    /// glPopClientAttrib.
    pub fn pop_client_attrib(&mut self) {
        if self.inside_begin_end() {
            return;
        }
        let Some(saved) = self.client_stack.pop() else {
            return self.set_error(GL_STACK_UNDERFLOW, "glPopClientAttrib");
        };
        if let Some((pack, unpack)) = saved.stores {
            (self.state.pack, self.state.unpack) = (pack, unpack);
        }
        if let Some(arrays) = saved.arrays {
            self.arrays = arrays;
        }
    }

    /// glGetPointerv; `None` after an error.
    pub fn get_pointer(&mut self, pname: GLenum) -> Option<*const c_void> {
        let pointer = self.arrays.pointer(pname).or_else(|| self.result_buffer(pname).map(std::ptr::without_provenance));
        if pointer.is_none() {
            self.set_error(GL_INVALID_ENUM, "glGetPointerv: pname");
        }
        pointer
    }

    /// glLockArraysEXT: a hint that arrays stay as they are; nothing follows from it here.
    pub fn lock_arrays_ext(&mut self, first: i32, count: i32) {
        if !self.inside_begin_end() && (first < 0 || count <= 0) {
            self.set_error(GL_INVALID_VALUE, "glLockArraysEXT");
        }
    }

    /// glUnlockArraysEXT.
    pub fn unlock_arrays_ext(&mut self) {
        self.inside_begin_end();
    }
}

const COLOR_TYPES: [GLenum; 8] = [GL_BYTE, GL_UNSIGNED_BYTE, GL_SHORT, GL_UNSIGNED_SHORT, GL_INT, GL_UNSIGNED_INT, GL_FLOAT, GL_DOUBLE];
