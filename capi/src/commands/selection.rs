//! Selection and feedback: the program's buffers are written when it leaves the mode.

use tepui::gl::Context;
use tepui::gl::enums::*;
use tepui::gl::feedback::Returned;

use super::memory::put;

/// glSelectBuffer
pub unsafe fn glSelectBuffer(cx: &mut Context, size: i32, buffer: *mut u32) {
    if size > 0 && buffer.is_null() {
        return cx.set_error(GL_INVALID_VALUE, "glSelectBuffer");
    }
    cx.select_buffer(size, buffer as usize);
}

/// glFeedbackBuffer
pub unsafe fn glFeedbackBuffer(cx: &mut Context, size: i32, ty: GLenum, buffer: *mut f32) {
    if size > 0 && buffer.is_null() {
        return cx.set_error(GL_INVALID_VALUE, "glFeedbackBuffer");
    }
    cx.feedback_buffer(size, ty, buffer as usize);
}

/// glRenderMode
pub unsafe fn glRenderMode(cx: &mut Context, mode: GLenum) -> i32 {
    let (count, returned) = cx.render_mode(mode);
    match returned {
        Returned::Nothing => {}
        // SAFETY: as many values as glSelectBuffer or glFeedbackBuffer said that there is room for, at the address given there.
        Returned::Selection(address, records) => unsafe { put(cx, "glRenderMode", address as *mut u32, records) },
        // SAFETY: as above.
        Returned::Feedback(address, values) => unsafe { put(cx, "glRenderMode", address as *mut f32, values) },
    }
    count
}
