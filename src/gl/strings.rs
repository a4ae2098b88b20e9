//! glGetString (6.1.11): who draws, and what it can do. It names only what works.

use std::ffi::{CStr, CString};

use super::Context;
use super::enums::*;

/// The version of OpenGL that is implemented whole, then the version of Tepui. Of 1.4 the comparison of shadows is missing.
pub const VERSION: &CStr = c"1.3 Tepui 0.1.0";

/// Extensions that work; what 1.4 made core is named one by one.
pub const EXTENSIONS: &CStr = c"GL_ARB_depth_texture GL_ARB_draw_buffers GL_ARB_framebuffer_object \
GL_ARB_multisample GL_ARB_multitexture GL_ARB_point_parameters GL_ARB_texture_border_clamp \
GL_ARB_texture_compression GL_ARB_texture_cube_map GL_ARB_texture_env_add GL_ARB_texture_env_combine \
GL_ARB_texture_env_crossbar GL_ARB_texture_env_dot3 GL_ARB_texture_mirrored_repeat GL_ARB_transpose_matrix GL_ARB_window_pos \
GL_EXT_abgr GL_EXT_bgra GL_EXT_blend_color GL_EXT_blend_equation_separate GL_EXT_blend_func_separate GL_EXT_blend_minmax \
GL_EXT_blend_subtract GL_EXT_compiled_vertex_array GL_EXT_copy_texture GL_EXT_draw_range_elements GL_EXT_fog_coord \
GL_EXT_framebuffer_blit GL_EXT_framebuffer_multisample GL_EXT_framebuffer_object GL_EXT_packed_depth_stencil \
GL_EXT_multi_draw_arrays GL_EXT_packed_pixels GL_EXT_point_parameters GL_EXT_polygon_offset GL_EXT_rescale_normal \
GL_EXT_secondary_color GL_EXT_separate_specular_color GL_EXT_stencil_wrap GL_EXT_subtexture GL_EXT_texture GL_EXT_texture3D \
GL_EXT_texture_cube_map GL_EXT_texture_edge_clamp GL_EXT_texture_env_add GL_EXT_texture_env_combine GL_EXT_texture_env_dot3 \
GL_EXT_texture_lod_bias GL_EXT_texture_object GL_EXT_vertex_array GL_MESA_window_pos GL_SGIS_generate_mipmap \
GL_SGIS_texture_border_clamp GL_SGIS_texture_edge_clamp GL_SGIS_texture_lod";

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
