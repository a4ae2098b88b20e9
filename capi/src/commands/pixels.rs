//! Pixel rectangles, stipple patterns and pixel maps.

use std::ffi::c_void;

use tepui::gl::Context;
use tepui::gl::enums::*;

use super::memory::{bytes, bytes_mut, copy, count, put};

/// glReadPixels
pub unsafe fn glReadPixels(cx: &mut Context, x: i32, y: i32, width: i32, height: i32, format: GLenum, ty: GLenum, pixels: *mut c_void) {
    let length = cx.pack_bytes(width, height, 1, format, ty);
    // SAFETY: the contract of this folder.
    cx.read_pixels(x, y, width, height, format, ty, unsafe { bytes_mut(pixels, length) });
}

/// Side of a polygon stipple pattern.
const SIDE: i32 = 32;

/// glPolygonStipple
pub unsafe fn glPolygonStipple(cx: &mut Context, mask: *const u8) {
    let length = cx.unpack_bytes(SIDE, SIDE, 1, GL_COLOR_INDEX, GL_BITMAP);
    // SAFETY: the contract of this folder.
    match unsafe { bytes(mask, length) } {
        Some(mask) => cx.polygon_stipple(mask),
        None => cx.set_error(GL_INVALID_VALUE, "glPolygonStipple"),
    }
}

/// glGetPolygonStipple
pub unsafe fn glGetPolygonStipple(cx: &mut Context, mask: *mut u8) {
    let length = cx.pack_bytes(SIDE, SIDE, 1, GL_COLOR_INDEX, GL_BITMAP);
    // SAFETY: the contract of this folder.
    match unsafe { bytes_mut(mask, length) } {
        Some(mask) => cx.get_polygon_stipple(mask),
        None => cx.set_error(GL_INVALID_VALUE, "glGetPolygonStipple"),
    }
}

/// Largest table of a pixel map that is worth reading: a longer one is an error (GL_MAX_PIXEL_MAP_TABLE is 256 with Mesa too).
const MOST: usize = 1 << 16;

macro_rules! pixel_maps {
    ($($set:ident $get:ident: $t:ty => $method:ident $query:ident;)*) => { $(
        #[doc = stringify!($set)]
        pub unsafe fn $set(cx: &mut Context, map: GLenum, size: i32, values: *const $t) {
            let length = if count(size) > MOST { 0 } else { count(size) };
            // SAFETY: the contract of this folder.
            if let Some(values) = unsafe { copy(cx, stringify!($set), values, length) } {
                cx.$method(map, size, &values);
            }
        }
        #[doc = stringify!($get)]
        pub unsafe fn $get(cx: &mut Context, map: GLenum, values: *mut $t) {
            let table = cx.$query(map);
            // SAFETY: the contract of this folder.
            unsafe { put(cx, stringify!($get), values, table) };
        }
    )* };
}

pixel_maps! {
    glPixelMapfv glGetPixelMapfv: f32 => pixel_mapfv get_pixel_mapfv;
    glPixelMapuiv glGetPixelMapuiv: u32 => pixel_mapuiv get_pixel_mapuiv;
    glPixelMapusv glGetPixelMapusv: u16 => pixel_mapusv get_pixel_mapusv;
}

/// glDrawPixels
pub unsafe fn glDrawPixels(cx: &mut Context, width: i32, height: i32, format: GLenum, ty: GLenum, pixels: *const c_void) {
    let length = cx.unpack_bytes(width, height, 1, format, ty);
    // SAFETY: the contract of this folder.
    cx.draw_pixels(width, height, format, ty, unsafe { bytes(pixels, length) });
}

/// glBitmap
pub unsafe fn glBitmap(
    cx: &mut Context,
    width: i32,
    height: i32,
    x_origin: f32,
    y_origin: f32,
    x_move: f32,
    y_move: f32,
    bitmap: *const u8,
) {
    let length = cx.unpack_bytes(width, height, 1, GL_COLOR_INDEX, GL_BITMAP);
    // SAFETY: the contract of this folder.
    cx.bitmap(width, height, x_origin, y_origin, x_move, y_move, unsafe { bytes(bitmap, length) });
}
