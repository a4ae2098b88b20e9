//! What a program can ask and set.

use std::ffi::{CStr, c_char, c_int, c_uint, c_void};

use tepui::device::{DepthFormat, Pixels};

use super::bind::MAX_SIZE;
use super::guard;
use super::handle::{self, Handle};
use crate::current;

const ROW_LENGTH: c_int = 0x10;
const Y_UP: c_int = 0x11;
const WIDTH: c_int = 0x20;
const HEIGHT: c_int = 0x21;
const FORMAT: c_int = 0x22;
const TYPE: c_int = 0x23;
const MAX_WIDTH: c_int = 0x24;
const MAX_HEIGHT: c_int = 0x25;

/// Sets OSMESA_ROW_LENGTH or OSMESA_Y_UP of the current context.
#[unsafe(no_mangle)]
pub extern "C" fn OSMesaPixelStore(pname: c_int, value: c_int) {
    let Some(content) = current::content() else { return };
    // SAFETY: this thread owns it.
    let target = unsafe { &mut (*content).target };
    match pname {
        ROW_LENGTH => target.row_length = value,
        Y_UP => target.y_up = value != 0,
        _ => log::warn!(target: "tepui", "OSMesaPixelStore: unknown name {pname:#x}"),
    }
}

/// Reads a value of the current context; leaves `value` alone where the name is unknown.
///
/// # Safety
/// `value` is NULL or points to an int.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaGetIntegerv(pname: c_int, value: *mut c_int) {
    let Some(content) = current::content() else { return };
    if value.is_null() {
        return;
    }
    // SAFETY: this thread owns it.
    let target = unsafe { &(*content).target };
    let answer = match pname {
        WIDTH => target.width,
        HEIGHT => target.height,
        FORMAT => target.format.to_enum() as c_int,
        TYPE => target.kind as c_int,
        ROW_LENGTH => target.row_length,
        Y_UP => target.y_up as c_int,
        MAX_WIDTH | MAX_HEIGHT => MAX_SIZE,
        _ => {
            log::warn!(target: "tepui", "OSMesaGetIntegerv: unknown name {pname:#x}");
            return;
        }
    };
    // SAFETY: the caller's promise.
    unsafe { *value = answer };
}

/// Writes where there is somewhere to write.
unsafe fn put<T>(to: *mut T, value: T) {
    if !to.is_null() {
        // SAFETY: the caller's promise.
        unsafe { *to = value };
    }
}

/// The program's buffer with its size and format; false before the first binding.
///
/// # Safety
/// The pointers are NULL or point to what they say.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaGetColorBuffer(
    context: Handle,
    width: *mut c_int,
    height: *mut c_int,
    format: *mut c_int,
    buffer: *mut *mut c_void,
) -> u8 {
    let holder = handle::get(context);
    // SAFETY: only plain values are read, and no command may run on the context in another thread.
    let target = holder.as_ref().and_then(|h| unsafe { h.content() }).map(|c| &c.target).filter(|t| t.address != 0);
    let (w, h, f, address) = target.map_or((0, 0, 0, 0), |t| (t.width, t.height, t.format.to_enum() as c_int, t.address));
    // SAFETY: the caller's promise.
    unsafe {
        put(width, w);
        put(height, h);
        put(format, f);
        put(buffer, address as *mut c_void);
    }
    (address != 0) as u8
}

/// Depth as Mesa lays it out: bottom row first, whatever OSMESA_Y_UP says; 2 bytes of a 16-bit buffer, else words with depth in the
/// low 24 bits and stencil above.
pub fn copy_depth(pixels: &Pixels, out: &mut Vec<u8>) {
    out.clear();
    let width = pixels.width as usize;
    // The first sample of each pixel.
    let first = &pixels.depth_stencil[..pixels.depth_stencil.len() / pixels.format.samples as usize];
    for row in first.chunks_exact(width.max(1)).rev() {
        if pixels.format.depth == DepthFormat::D16 {
            row.iter().for_each(|word| out.extend_from_slice(&(*word as u16).to_ne_bytes()));
        } else {
            out.extend_from_slice(bytemuck::cast_slice(row));
        }
    }
}

fn depth_buffer(context: Handle) -> Option<(c_int, c_int, c_int, *mut c_void)> {
    let holder = handle::get(context)?;
    // SAFETY: no command may run on the context in another thread.
    let content = unsafe { holder.content() }?;
    if content.context.config.depth_bits == 0 || content.target.address == 0 {
        return None;
    }
    content.context.flush_batch();
    let pixels = &content.context.window.as_mut()?.pixels();
    // The pointer stays the same from call to call: the copy has one size as long as the surface has.
    copy_depth(pixels, &mut content.target.depth);
    let bytes = if pixels.format.depth == DepthFormat::D16 { 2 } else { 4 };
    Some((pixels.width as c_int, pixels.height as c_int, bytes, content.target.depth.as_mut_ptr().cast()))
}

/// A copy of the depth buffer, renewed by this call and by glFlush and glFinish; false where there is none.
///
/// # Safety
/// The pointers are NULL or point to what they say.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaGetDepthBuffer(
    context: Handle,
    width: *mut c_int,
    height: *mut c_int,
    bytes_per_value: *mut c_int,
    buffer: *mut *mut c_void,
) -> u8 {
    let found = guard("OSMesaGetDepthBuffer", None, || depth_buffer(context));
    let (w, h, bytes, data) = found.unwrap_or((0, 0, 0, std::ptr::null_mut()));
    // SAFETY: the caller's promise.
    unsafe {
        put(width, w);
        put(height, h);
        put(bytes_per_value, bytes);
        put(buffer, data);
    }
    found.is_some() as u8
}

/// Every OSMesa function by name, sorted.
macro_rules! own {
    ($($name:ident in $module:ident),* $(,)?) => {
        fn own(name: &str) -> Option<*const c_void> {
            Some(match name { $(stringify!($name) => super::$module::$name as *const c_void,)* _ => return None })
        }
    };
}
own!(
    OSMesaColorClamp in query, OSMesaCreateContext in create, OSMesaCreateContextAttribs in create, OSMesaCreateContextExt in create,
    OSMesaDestroyContext in create, OSMesaGetColorBuffer in query, OSMesaGetCurrentContext in bind, OSMesaGetDepthBuffer in query,
    OSMesaGetIntegerv in query, OSMesaGetProcAddress in query, OSMesaMakeCurrent in bind, OSMesaPixelStore in query,
    OSMesaPostprocess in query,
);

/// The address of a gl* or OSMesa* function; NULL for what is unknown (Mesa answers with a stub that does nothing).
///
/// # Safety
/// `name` is NULL or a string.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaGetProcAddress(name: *const c_char) -> *const c_void {
    if name.is_null() {
        return std::ptr::null();
    }
    // SAFETY: the caller's promise.
    let name = unsafe { CStr::from_ptr(name) }.to_str().unwrap_or("");
    own(name).or_else(|| crate::table::find(name)).unwrap_or(std::ptr::null())
}

/// Clamping of fragment colours. Buffers of fixed point clamp by themselves, and OpenGL 2.1 clamps always: nothing to do.
#[unsafe(no_mangle)]
pub extern "C" fn OSMesaColorClamp(_enable: u8) {}

/// Mesa's post-processing filters. There are none here; an unknown filter is no error with Mesa either.
///
/// # Safety
/// `filter` is NULL or a string.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn OSMesaPostprocess(_context: Handle, filter: *const c_char, enable: c_uint) {
    if enable != 0 && !filter.is_null() {
        // SAFETY: the caller's promise.
        let filter = unsafe { CStr::from_ptr(filter) }.to_string_lossy();
        log::warn!(target: "tepui", "OSMesaPostprocess: there is no filter {filter}");
    }
}
