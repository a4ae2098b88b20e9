//! Compressed images: the data is never read, since no compressed format is supported.

use std::ffi::c_void;

use tepui::gl::Context;
use tepui::gl::enums::*;

macro_rules! without_data {
    ($($name:ident($($arg:ident: $t:ty),*) => $method:ident;)*) => { $(
        #[doc = stringify!($name)]
        pub unsafe fn $name(cx: &mut Context, $($arg: $t),*) {
            cx.$method();
        }
    )* };
}

without_data! {
    glCompressedTexImage1D(_target: GLenum, _level: i32, _internalformat: GLenum, _width: i32, _border: i32, _size: i32, _data: *const c_void) => compressed_tex_image;
    glCompressedTexImage2D(_target: GLenum, _level: i32, _internalformat: GLenum, _width: i32, _height: i32, _border: i32, _size: i32, _data: *const c_void) => compressed_tex_image;
    glCompressedTexImage3D(_target: GLenum, _level: i32, _internalformat: GLenum, _width: i32, _height: i32, _depth: i32, _border: i32, _size: i32, _data: *const c_void) => compressed_tex_image;
    glCompressedTexSubImage1D(_target: GLenum, _level: i32, _x: i32, _width: i32, _format: GLenum, _size: i32, _data: *const c_void) => compressed_tex_sub_image;
    glCompressedTexSubImage2D(_target: GLenum, _level: i32, _x: i32, _y: i32, _width: i32, _height: i32, _format: GLenum, _size: i32, _data: *const c_void) => compressed_tex_sub_image;
    glCompressedTexSubImage3D(_target: GLenum, _level: i32, _x: i32, _y: i32, _z: i32, _width: i32, _height: i32, _depth: i32, _format: GLenum, _size: i32, _data: *const c_void) => compressed_tex_sub_image;
    glGetCompressedTexImage(_target: GLenum, _level: i32, _image: *mut c_void) => get_compressed_tex_image;
}
