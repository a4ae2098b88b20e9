//! Making contexts current, and when the program's memory is written.
//!
//! Mesa writes it at glFlush, at glFinish and when another context (or none) becomes current, if something was drawn since it last
//! did; not at glReadPixels. The same here. Rebinding to another buffer of the same size keeps what was drawn.

use std::ffi::{c_int, c_void};
use std::sync::Arc;

use tepui::gl::Context;
use tepui::gl::enums::*;

use super::format::{Format, bytes_per_pixel, row, storage};
use super::guard;
use super::handle::{self, Handle};
use crate::current::{self, Content};

/// Largest width and height, as OSMESA_MAX_WIDTH and OSMESA_MAX_HEIGHT return them.
pub const MAX_SIZE: c_int = 16384;

/// Runs what was recorded and copies the window's pixels into the program's buffer, if something was drawn since the last time.
pub fn present(content: &mut Content) {
    let Content { context, target } = content;
    let width = target.width as usize;
    let row_length = if target.row_length > 0 { target.row_length as usize } else { width };
    let plain = target.depth.is_empty() && target.format == Format::Rgba && target.kind == GL_UNSIGNED_BYTE;
    if target.address != 0 && plain && row_length >= width {
        let length = (target.height as usize - 1) * row_length + width;
        // SAFETY: the program promised a buffer of `height` rows of `row_length` pixels (the last one of `width`).
        let out = unsafe { std::slice::from_raw_parts_mut(target.address as *mut u8, length * 4) };
        return context.flush_and_copy(out, row_length * 4, target.y_up);
    }
    context.flush_batch();
    if target.address == 0 || !std::mem::take(&mut context.window_changed) {
        return;
    }
    let Some(window) = &mut context.window else { return };
    let pixels = &if target.depth.is_empty() { window.color_pixels() } else { window.pixels() };
    let (width, height) = (pixels.width as usize, pixels.height as usize);
    let bytes = bytes_per_pixel(target.format, target.kind);
    // A negative row length would leave the buffer; Mesa crashes.
    let stride = if target.row_length > 0 { target.row_length as usize } else { width } * bytes;
    for y in 0..height {
        let line = if target.y_up { height - 1 - y } else { y };
        // SAFETY: the program promised a buffer of `height` rows of `stride` bytes (the last one of `width` pixels).
        let out = unsafe { std::slice::from_raw_parts_mut((target.address as *mut u8).add(line * stride), width * bytes) };
        row(pixels, y, target.format, target.kind, out);
    }
    if !target.depth.is_empty() {
        super::query::copy_depth(pixels, &mut target.depth);
    }
}

/// glFlush and glFinish write the program's memory.
pub fn flush(cx: &mut Context) {
    // Between Begin and End this is an error, and the batch stays as it is.
    if !cx.may_flush() {
        return;
    }
    if let Some(content) = current::content() {
        // SAFETY: `cx` is this content's context and is not used any more.
        present(unsafe { &mut *content });
    }
}

fn release() {
    if let Some(content) = current::content() {
        // SAFETY: this thread owns the content (or its owner is at rest, which GL demands).
        present(unsafe { &mut *content });
    }
    current::set(None);
}

fn make_current(context: Handle, buffer: *mut c_void, kind: GLenum, width: c_int, height: c_int) -> bool {
    if context.is_null() && buffer.is_null() {
        release();
        return true;
    }
    let Some(holder) = handle::get(context) else { return false };
    if buffer.is_null() || width < 1 || height < 1 || width > MAX_SIZE || height > MAX_SIZE {
        return false;
    }
    let old = current::holder();
    let same = old.as_ref().is_some_and(|old| Arc::ptr_eq(old, &holder));
    // SAFETY: no other thread may be inside a command on a context that is made current.
    let Some(content) = (unsafe { holder.content() }) else { return false };
    let Some(color) = storage(content.target.format, kind) else {
        log::warn!(target: "tepui", "OSMesaMakeCurrent: unsupported format and type");
        return false;
    };
    if !same {
        release();
    } else if content.target.address != buffer as usize || content.target.width != width || content.target.height != height {
        present(content);
    }
    let Content { context, target } = content;
    if context.config.color != color {
        context.config.color = color;
        // Forces a new surface of the new format.
        context.window_size = [0, 0];
    }
    context.attach_window(width as u32, height as u32);
    if (target.width, target.height) != (width, height) {
        target.depth = Vec::new();
    }
    (target.kind, target.address, target.width, target.height) = (kind, buffer as usize, width, height);
    current::set(Some(holder));
    true
}

/// Makes a context current on this thread, drawing for a buffer; with NULL and NULL, none.
///
/// # Safety
/// The buffer is as large as width, height, format, type and row length imply, until the context is bound elsewhere.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaMakeCurrent(context: Handle, buffer: *mut c_void, kind: GLenum, width: c_int, height: c_int) -> u8 {
    guard("OSMesaMakeCurrent", false, || make_current(context, buffer, kind, width, height)) as u8
}

/// This thread's current context.
#[unsafe(no_mangle)]
pub extern "C" fn OSMesaGetCurrentContext() -> Handle {
    current::holder().map_or(std::ptr::null_mut(), |holder| handle::of(&holder))
}
