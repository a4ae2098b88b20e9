//! Commands of extensions that differ from what they became in a later version.

use tepui::gl::Context;
use tepui::gl::enums::*;

use crate::enter::read;

/// glPolygonOffsetEXT: the bias counts in window depth, not in steps of the depth buffer.
pub unsafe fn glPolygonOffsetEXT(cx: &mut Context, factor: f32, bias: f32) {
    cx.polygon_offset(factor, bias * cx.depth_steps());
}

/// glStencilFuncSeparateATI: one call, two functions.
pub unsafe fn glStencilFuncSeparateATI(cx: &mut Context, front: GLenum, back: GLenum, reference: i32, mask: u32) {
    let is_func = |func| (GL_NEVER..=GL_ALWAYS).contains(&func);
    if !is_func(front) || !is_func(back) {
        return cx.set_error(GL_INVALID_ENUM, "glStencilFuncSeparateATI");
    }
    cx.stencil_func_separate(GL_FRONT, front, reference, mask);
    cx.stencil_func_separate(GL_BACK, back, reference, mask);
}

/// glWindowPos4*MESA: w has no meaning for a position that is not transformed.
macro_rules! window_positions {
    ($($scalar:ident $vector:ident: $t:ty;)*) => { $(
        #[doc = stringify!($scalar)]
        pub unsafe fn $scalar(cx: &mut Context, x: $t, y: $t, z: $t, _w: $t) {
            cx.window_pos(x as f32, y as f32, z as f32);
        }
        #[doc = stringify!($vector)]
        pub unsafe fn $vector(cx: &mut Context, v: *const $t) {
            // SAFETY: the contract of this folder.
            if let Some([x, y, z, _]) = unsafe { read::<$t, 4>(cx, stringify!($vector), v) } {
                cx.window_pos(x as f32, y as f32, z as f32);
            }
        }
    )* };
}

window_positions! {
    glWindowPos4dMESA glWindowPos4dvMESA: f64;
    glWindowPos4fMESA glWindowPos4fvMESA: f32;
    glWindowPos4iMESA glWindowPos4ivMESA: i32;
    glWindowPos4sMESA glWindowPos4svMESA: i16;
}
