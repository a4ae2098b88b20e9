//! Reading and writing the program's memory.

use tepui::gl::Context;
use tepui::gl::enums::GL_INVALID_VALUE;

/// Reads `count` values, which need not be aligned. NULL (with a count) records GL_INVALID_VALUE.
///
/// # Safety
/// Unless NULL, `from` points to `count` readable values.
pub unsafe fn copy<T: Copy>(cx: &mut Context, name: &str, from: *const T, count: usize) -> Option<Vec<T>> {
    if count == 0 {
        return Some(Vec::new());
    }
    if from.is_null() {
        cx.set_error(GL_INVALID_VALUE, name);
        return None;
    }
    // SAFETY: the caller's promise.
    Some((0..count).map(|i| unsafe { from.add(i).read_unaligned() }).collect())
}

/// Writes values. NULL records GL_INVALID_VALUE, if there is something to write.
///
/// # Safety
/// Unless NULL, there is room for the values at `to`.
pub unsafe fn put<T>(cx: &mut Context, name: &str, to: *mut T, values: impl IntoIterator<Item = T>) {
    for (i, value) in values.into_iter().enumerate() {
        if to.is_null() {
            return cx.set_error(GL_INVALID_VALUE, name);
        }
        // SAFETY: the caller's promise.
        unsafe { to.add(i).write_unaligned(value) };
    }
}

/// Pixels to read: `None` for NULL and for what has no size.
///
/// # Safety
/// Unless NULL, `from` points to as many bytes as `bytes` says.
pub unsafe fn bytes<'a, T>(from: *const T, bytes: Option<usize>) -> Option<&'a [u8]> {
    let length = bytes.filter(|n| *n <= isize::MAX as usize)?;
    // SAFETY: the caller's promise.
    (!from.is_null()).then(|| unsafe { std::slice::from_raw_parts(from.cast(), length) })
}

/// Pixels to write.
///
/// # Safety
/// As for `bytes`, to write.
pub unsafe fn bytes_mut<'a, T>(to: *mut T, bytes: Option<usize>) -> Option<&'a mut [u8]> {
    let length = bytes.filter(|n| *n <= isize::MAX as usize)?;
    // SAFETY: the caller's promise.
    (!to.is_null()).then(|| unsafe { std::slice::from_raw_parts_mut(to.cast(), length) })
}

/// A count as given, where it is not negative.
pub fn count(n: i32) -> usize {
    usize::try_from(n).unwrap_or(0)
}
