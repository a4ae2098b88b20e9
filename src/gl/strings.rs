//! glGetString (6.1.11): who draws, and what it can do. It names only what works.

use std::ffi::{CStr, CString};

use super::Context;
use super::enums::*;

/// The version of OpenGL that is implemented whole, then the version of Tepui.
pub const VERSION: &CStr = c"1.1 Tepui 0.1.0";

/// Extensions that work, each followed by a space but the last.
pub const EXTENSIONS: &CStr = c"GL_EXT_blend_color GL_EXT_blend_func_separate GL_EXT_blend_minmax GL_EXT_blend_subtract \
GL_EXT_copy_texture GL_EXT_polygon_offset GL_EXT_stencil_wrap GL_EXT_subtexture GL_EXT_texture GL_EXT_texture_object \
GL_EXT_vertex_array GL_ARB_transpose_matrix GL_ARB_window_pos";

impl Context {
    /// glGetString. The text lives as long as the context. `None` after an error.
    pub fn get_string(&mut self, name: GLenum) -> Option<&CStr> {
        if self.inside_begin_end() {
            return None;
        }
        match name {
            GL_VENDOR => Some(c"Tepui"),
            GL_VERSION => Some(VERSION),
            GL_EXTENSIONS => Some(EXTENSIONS),
            GL_RENDERER => {
                if self.renderer.is_none() {
                    let name = format!("Tepui ({})", self.device.name()).replace('\0', " ");
                    self.renderer = CString::new(name).ok();
                }
                Some(self.renderer.as_deref().unwrap_or(c"Tepui"))
            }
            _ => {
                self.set_error(GL_INVALID_ENUM, "glGetString");
                None
            }
        }
    }
}
