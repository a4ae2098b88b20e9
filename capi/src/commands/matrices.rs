//! Matrices given as 16 values.

use tepui::gl::Context;

use crate::enter::read;

macro_rules! matrices {
    ($($name:ident: $t:ty => $method:ident;)*) => { $(
        #[doc = stringify!($name)]
        pub unsafe fn $name(cx: &mut Context, m: *const $t) {
            // SAFETY: the contract of this folder.
            if let Some(m) = unsafe { read::<$t, 16>(cx, stringify!($name), m) } {
                cx.$method(m.map(|v| v as f32));
            }
        }
    )* };
}

matrices! {
    glLoadMatrixf: f32 => load_matrix;
    glLoadMatrixd: f64 => load_matrix;
    glMultMatrixf: f32 => mult_matrix;
    glMultMatrixd: f64 => mult_matrix;
    glLoadTransposeMatrixf: f32 => load_transpose_matrix;
    glLoadTransposeMatrixd: f64 => load_transpose_matrix;
    glMultTransposeMatrixf: f32 => mult_transpose_matrix;
    glMultTransposeMatrixd: f64 => mult_transpose_matrix;
}
