//! glFlush and glFinish: besides running what was recorded, they write the program's memory.

use tepui::gl::Context;

/// glFlush
///
/// # Safety
/// `cx` is this thread's current context.
pub unsafe fn glFlush(cx: &mut Context) {
    crate::osmesa::bind::flush(cx);
}

/// glFinish
///
/// # Safety
/// `cx` is this thread's current context.
pub unsafe fn glFinish(cx: &mut Context) {
    crate::osmesa::bind::flush(cx);
}
