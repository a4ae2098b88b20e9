//! How a command enters the library.

use std::any::Any;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::atomic::{AtomicBool, Ordering};

use tepui::gl::Context;
use tepui::gl::enums::*;

use crate::current;

/// What a command returns when there is nothing to return.
pub trait Nothing {
    /// Zero, or a null pointer.
    const NOTHING: Self;
}

macro_rules! nothing {
    ($($t:ty => $v:expr),*) => { $(impl Nothing for $t { const NOTHING: $t = $v; })* };
}
nothing!(() => (), u8 => 0, i32 => 0, u32 => 0);
impl<T> Nothing for *const T {
    const NOTHING: *const T = std::ptr::null();
}
impl<T> Nothing for *mut T {
    const NOTHING: *mut T = std::ptr::null_mut();
}

/// Runs a command on this thread's current context. Without one nothing happens. A panic ends here: it is logged, the context gets
/// GL_OUT_OF_MEMORY, the error after which the specification leaves the state undefined (2.5), and the program goes on.
#[inline(always)]
pub fn enter<R: Nothing>(name: &'static str, command: impl FnOnce(&mut Context) -> R) -> R {
    let Some(content) = current::content() else { return R::NOTHING };
    // SAFETY: this thread owns the content, and no command calls another through the C border.
    let cx = unsafe { &mut (*content).context };
    match catch_unwind(AssertUnwindSafe(|| command(&mut *cx))) {
        Ok(result) => result,
        Err(panic) => {
            panicked(cx, name, panic);
            R::NOTHING
        }
    }
}

#[cold]
fn panicked(cx: &mut Context, name: &str, panic: Box<dyn Any + Send>) {
    log::error!(target: "tepui", "{name} failed inside the library: {}", message(&*panic));
    cx.set_error(GL_OUT_OF_MEMORY, name);
}

/// What a panic said.
pub fn message(panic: &(dyn Any + Send)) -> &str {
    panic.downcast_ref::<&str>().copied().or_else(|| panic.downcast_ref::<String>().map(String::as_str)).unwrap_or("(no message)")
}

/// A command that no code answers yet: GL_INVALID_OPERATION, named once on the log.
#[cold]
pub fn not_built<R: Nothing>(cx: &mut Context, name: &str, said: &AtomicBool) -> R {
    if !said.swap(true, Ordering::Relaxed) {
        log::warn!(target: "tepui", "{name} is not built yet: GL_INVALID_OPERATION");
    }
    cx.set_error(GL_INVALID_OPERATION, name);
    R::NOTHING
}

/// Reads `N` values. NULL records GL_INVALID_VALUE.
///
/// # Safety
/// Unless NULL, `values` points to `N` readable values; they need not be aligned.
#[inline(always)]
pub unsafe fn read<T: Copy, const N: usize>(cx: &mut Context, name: &str, values: *const T) -> Option<[T; N]> {
    if values.is_null() {
        cx.set_error(GL_INVALID_VALUE, name);
        return None;
    }
    // SAFETY: the caller's promise.
    Some(unsafe { values.cast::<[T; N]>().read_unaligned() })
}
