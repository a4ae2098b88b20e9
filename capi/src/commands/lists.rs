//! glCallLists: names of ten types.

use std::ffi::c_void;

use tepui::gl::Context;
use tepui::gl::enums::*;

use super::memory::copy;

/// Bytes a name takes.
fn size(ty: GLenum) -> Option<usize> {
    match ty {
        GL_BYTE | GL_UNSIGNED_BYTE => Some(1),
        GL_SHORT | GL_UNSIGNED_SHORT | GL_2_BYTES => Some(2),
        GL_3_BYTES => Some(3),
        GL_INT | GL_UNSIGNED_INT | GL_FLOAT | GL_4_BYTES => Some(4),
        _ => None,
    }
}

/// One name. GL_2_BYTES and its like have the most significant byte first (5.4).
fn name(ty: GLenum, b: &[u8]) -> u32 {
    match (ty, b) {
        (GL_BYTE, &[a]) => a as i8 as u32,
        (GL_SHORT, &[a, b]) => i16::from_ne_bytes([a, b]) as u32,
        (GL_UNSIGNED_SHORT, &[a, b]) => u16::from_ne_bytes([a, b]) as u32,
        (GL_INT | GL_UNSIGNED_INT, &[a, b, c, d]) => u32::from_ne_bytes([a, b, c, d]),
        (GL_FLOAT, &[a, b, c, d]) => f32::from_ne_bytes([a, b, c, d]).floor() as i64 as u32,
        _ => b.iter().fold(0, |n, &b| n << 8 | u32::from(b)),
    }
}

/// glCallLists
pub unsafe fn glCallLists(cx: &mut Context, n: i32, ty: GLenum, lists: *const c_void) {
    let Some(size) = size(ty) else { return cx.set_error(GL_INVALID_ENUM, "glCallLists") };
    let Ok(n) = usize::try_from(n) else { return cx.set_error(GL_INVALID_VALUE, "glCallLists") };
    // SAFETY: the contract of this folder.
    if let Some(bytes) = unsafe { copy(cx, "glCallLists", lists.cast::<u8>(), n * size) } {
        let names: Vec<u32> = bytes.chunks_exact(size).map(|b| name(ty, b)).collect();
        cx.call_lists(&names);
    }
}
