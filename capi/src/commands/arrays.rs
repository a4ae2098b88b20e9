//! Vertex arrays: pointers that stay with the client, and indices.

use std::ffi::c_void;

use tepui::gl::Context;
use tepui::gl::enums::*;

use super::memory::{copy, count};

/// glVertexPointer
pub unsafe fn glVertexPointer(cx: &mut Context, size: i32, ty: GLenum, stride: i32, pointer: *const c_void) {
    // SAFETY: the contract of this folder, here and below.
    unsafe { cx.vertex_pointer(size, ty, stride, pointer) }
}

/// glVertexPointerEXT
pub unsafe fn glVertexPointerEXT(cx: &mut Context, size: i32, ty: GLenum, stride: i32, _count: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.vertex_pointer(size, ty, stride, pointer) }
}

/// glNormalPointer
pub unsafe fn glNormalPointer(cx: &mut Context, ty: GLenum, stride: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.normal_pointer(ty, stride, pointer) }
}

/// glNormalPointerEXT
pub unsafe fn glNormalPointerEXT(cx: &mut Context, ty: GLenum, stride: i32, _count: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.normal_pointer(ty, stride, pointer) }
}

/// glColorPointer
pub unsafe fn glColorPointer(cx: &mut Context, size: i32, ty: GLenum, stride: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.color_pointer(size, ty, stride, pointer) }
}

/// glColorPointerEXT
pub unsafe fn glColorPointerEXT(cx: &mut Context, size: i32, ty: GLenum, stride: i32, _count: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.color_pointer(size, ty, stride, pointer) }
}

/// glSecondaryColorPointer
pub unsafe fn glSecondaryColorPointer(cx: &mut Context, size: i32, ty: GLenum, stride: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.secondary_color_pointer(size, ty, stride, pointer) }
}

/// glFogCoordPointer
pub unsafe fn glFogCoordPointer(cx: &mut Context, ty: GLenum, stride: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.fog_coord_pointer(ty, stride, pointer) }
}

/// glIndexPointer
pub unsafe fn glIndexPointer(cx: &mut Context, ty: GLenum, stride: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.index_pointer(ty, stride, pointer) }
}

/// glIndexPointerEXT
pub unsafe fn glIndexPointerEXT(cx: &mut Context, ty: GLenum, stride: i32, _count: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.index_pointer(ty, stride, pointer) }
}

/// glTexCoordPointer
pub unsafe fn glTexCoordPointer(cx: &mut Context, size: i32, ty: GLenum, stride: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.tex_coord_pointer(size, ty, stride, pointer) }
}

/// glTexCoordPointerEXT
pub unsafe fn glTexCoordPointerEXT(cx: &mut Context, size: i32, ty: GLenum, stride: i32, _count: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.tex_coord_pointer(size, ty, stride, pointer) }
}

/// glEdgeFlagPointer
pub unsafe fn glEdgeFlagPointer(cx: &mut Context, stride: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.edge_flag_pointer(stride, pointer) }
}

/// glEdgeFlagPointerEXT
pub unsafe fn glEdgeFlagPointerEXT(cx: &mut Context, stride: i32, _count: i32, pointer: *const u8) {
    // SAFETY: see above.
    unsafe { cx.edge_flag_pointer(stride, pointer.cast()) }
}

/// glInterleavedArrays
pub unsafe fn glInterleavedArrays(cx: &mut Context, format: GLenum, stride: i32, pointer: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.interleaved_arrays(format, stride, pointer) }
}

/// glGetPointerv
pub unsafe fn glGetPointerv(cx: &mut Context, pname: GLenum, params: *mut *mut c_void) {
    let Some(pointer) = cx.get_pointer(pname) else { return };
    if params.is_null() {
        return cx.set_error(GL_INVALID_VALUE, "glGetPointerv");
    }
    // SAFETY: not NULL, so there is room for one pointer.
    unsafe { params.write_unaligned(pointer.cast_mut()) };
}

/// glDrawElements
pub unsafe fn glDrawElements(cx: &mut Context, mode: GLenum, count: i32, ty: GLenum, indices: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.draw_elements(mode, count, ty, indices) }
}

/// glDrawRangeElements
pub unsafe fn glDrawRangeElements(cx: &mut Context, mode: GLenum, start: u32, end: u32, count: i32, ty: GLenum, indices: *const c_void) {
    // SAFETY: see above.
    unsafe { cx.draw_range_elements(mode, start, end, count, ty, indices) }
}

/// glMultiDrawArrays
pub unsafe fn glMultiDrawArrays(cx: &mut Context, mode: GLenum, first: *const i32, counts: *const i32, draws: i32) {
    if draws < 0 {
        return cx.set_error(GL_INVALID_VALUE, "glMultiDrawArrays");
    }
    // SAFETY: see above.
    let (first, counts) =
        unsafe { (copy(cx, "glMultiDrawArrays", first, count(draws)), copy(cx, "glMultiDrawArrays", counts, count(draws))) };
    if let (Some(first), Some(counts)) = (first, counts) {
        cx.multi_draw_arrays(mode, &first, &counts);
    }
}

/// glMultiDrawElements
pub unsafe fn glMultiDrawElements(
    cx: &mut Context,
    mode: GLenum,
    counts: *const i32,
    ty: GLenum,
    indices: *const *const c_void,
    draws: i32,
) {
    if draws < 0 {
        return cx.set_error(GL_INVALID_VALUE, "glMultiDrawElements");
    }
    // SAFETY: see above.
    let (counts, indices) =
        unsafe { (copy(cx, "glMultiDrawElements", counts, count(draws)), copy(cx, "glMultiDrawElements", indices, count(draws))) };
    if let (Some(counts), Some(indices)) = (counts, indices) {
        for (count, indices) in counts.into_iter().zip(indices) {
            // SAFETY: see above.
            unsafe { cx.draw_elements(mode, count, ty, indices) };
        }
    }
}
