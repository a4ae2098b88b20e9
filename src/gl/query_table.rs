//! What each name of glGet stands for: the state tables of 6.2 and the limits.

use glam::Mat4;

use super::Context;
use super::enums::*;
use super::query::{Kind, Value};
use super::renderbuffer::MAX_RENDERBUFFER_SIZE;
use super::state::*;
use super::texture_image::MAX_TEXTURE_SIZE;

impl Context {
    /// The value of a state variable in its own type; `None` for a name that is none.
    pub fn query(&mut self, pname: GLenum) -> Option<Value> {
        if let Some(on) = self.capability_value(pname) {
            return Some(Value::bool(on));
        }
        match pname {
            GL_LIST_INDEX => return Some(Value::int(self.list_index())),
            GL_LIST_MODE => return Some(Value::int(self.list_mode())),
            GL_CLIENT_ATTRIB_STACK_DEPTH => return Some(Value::int(self.client_attrib_depth())),
            _ => {}
        }
        if let Some(value) = self.arrays.get(pname) {
            return Some(Value::int(value));
        }
        if let Some(on) = self.arrays.is_enabled(pname) {
            return Some(Value::bool(on));
        }
        self.query_vertex_state(pname)
            .or_else(|| self.query_raster_state(pname))
            .or_else(|| self.query_fragment_state(pname))
            .or_else(|| self.query_pixel_state(pname))
            .or_else(|| self.query_framebuffer(pname))
            .or_else(|| query_limit(pname))
    }

    /// Current values, matrices, lighting, fog, hints, evaluators, stacks.
    fn query_vertex_state(&mut self, pname: GLenum) -> Option<Value> {
        let s = &self.state;
        let attribute = |slot: usize| &s.current.attributes[slot];
        let raster = &s.current.raster;
        let active = s.texture.active;
        let matrix = |m: &Mat4| Value::floats(&m.to_cols_array());
        let transposed = |m: &Mat4| Value::floats(&m.transpose().to_cols_array());
        Some(match pname {
            GL_CURRENT_COLOR => Value::normalized(attribute(3)),
            GL_CURRENT_SECONDARY_COLOR => Value::normalized(attribute(4)),
            GL_CURRENT_INDEX => Value::float(s.current.index),
            GL_CURRENT_NORMAL => Value::normalized(&attribute(2)[..3]),
            GL_CURRENT_TEXTURE_COORDS => Value::floats(attribute(8 + active)),
            GL_CURRENT_FOG_COORD => Value::float(attribute(5)[0]),
            GL_EDGE_FLAG => Value::bool(s.current.edge_flag),
            GL_CURRENT_RASTER_POSITION => Value::floats(&raster.position),
            GL_CURRENT_RASTER_DISTANCE => Value::float(raster.distance),
            GL_CURRENT_RASTER_COLOR => Value::normalized(&raster.color),
            GL_CURRENT_RASTER_SECONDARY_COLOR => Value::normalized(&raster.secondary_color),
            GL_CURRENT_RASTER_INDEX => Value::float(raster.index),
            GL_CURRENT_RASTER_TEXTURE_COORDS => Value::floats(&raster.tex_coords[active]),
            GL_CURRENT_RASTER_POSITION_VALID => Value::bool(raster.valid),
            GL_MATRIX_MODE => Value::int(s.transform.matrix_mode),
            GL_MODELVIEW_MATRIX => matrix(self.modelview.top()),
            GL_PROJECTION_MATRIX => matrix(self.projection.top()),
            GL_TEXTURE_MATRIX => matrix(self.texture_matrices[active].top()),
            GL_TRANSPOSE_MODELVIEW_MATRIX => transposed(self.modelview.top()),
            GL_TRANSPOSE_PROJECTION_MATRIX => transposed(self.projection.top()),
            GL_TRANSPOSE_TEXTURE_MATRIX => transposed(self.texture_matrices[active].top()),
            GL_MODELVIEW_STACK_DEPTH => Value::int(self.modelview.stack.len() as i64),
            GL_PROJECTION_STACK_DEPTH => Value::int(self.projection.stack.len() as i64),
            GL_TEXTURE_STACK_DEPTH => Value::int(self.texture_matrices[active].stack.len() as i64),
            GL_VIEWPORT => Value::ints(&[s.viewport.x, s.viewport.y, s.viewport.width, s.viewport.height]),
            GL_DEPTH_RANGE => Value::new(Kind::Normalized, [s.viewport.near, s.viewport.far]),
            GL_SHADE_MODEL => Value::int(s.lighting.shade_model),
            GL_LIGHT_MODEL_AMBIENT => Value::normalized(&s.lighting.model_ambient),
            GL_LIGHT_MODEL_LOCAL_VIEWER => Value::bool(s.lighting.local_viewer),
            GL_LIGHT_MODEL_TWO_SIDE => Value::bool(s.lighting.two_side),
            GL_LIGHT_MODEL_COLOR_CONTROL => Value::int(s.lighting.color_control),
            GL_COLOR_MATERIAL_FACE => Value::int(s.lighting.color_material_face),
            GL_COLOR_MATERIAL_PARAMETER => Value::int(s.lighting.color_material_mode),
            GL_FOG_MODE => Value::int(s.fog.mode),
            GL_FOG_COLOR => Value::normalized(&s.fog.color),
            GL_FOG_DENSITY => Value::float(s.fog.density),
            GL_FOG_START => Value::float(s.fog.start),
            GL_FOG_END => Value::float(s.fog.end),
            GL_FOG_INDEX => Value::float(s.fog.index),
            GL_FOG_COORD_SRC => Value::int(s.fog.coord_source),
            GL_PERSPECTIVE_CORRECTION_HINT => Value::int(s.hint.perspective_correction),
            GL_POINT_SMOOTH_HINT => Value::int(s.hint.point_smooth),
            GL_LINE_SMOOTH_HINT => Value::int(s.hint.line_smooth),
            GL_POLYGON_SMOOTH_HINT => Value::int(s.hint.polygon_smooth),
            GL_FOG_HINT => Value::int(s.hint.fog),
            GL_GENERATE_MIPMAP_HINT => Value::int(s.hint.generate_mipmap),
            GL_TEXTURE_COMPRESSION_HINT => Value::int(s.hint.texture_compression),
            GL_FRAGMENT_SHADER_DERIVATIVE_HINT => Value::int(s.hint.fragment_derivative),
            GL_MAP1_GRID_DOMAIN => Value::floats(&s.eval.grid1_domain),
            GL_MAP1_GRID_SEGMENTS => Value::int(s.eval.grid1_divisions),
            GL_MAP2_GRID_DOMAIN => Value::floats(&s.eval.grid2_domain),
            GL_MAP2_GRID_SEGMENTS => Value::ints(&s.eval.grid2_divisions),
            GL_LIST_BASE => Value::int(s.list_base),
            GL_ATTRIB_STACK_DEPTH => Value::int(self.attrib_stack.len() as i64),
            GL_LIST_MODE => Value::int(self.list_mode()),
            GL_LIST_INDEX => Value::int(self.list_index()),
            GL_NAME_STACK_DEPTH => Value::int(self.selection.names.len() as i64),
            GL_SELECTION_BUFFER_SIZE => Value::int(self.selection.buffer.map_or(0, |(_, size)| size as i64)),
            GL_FEEDBACK_BUFFER_SIZE => Value::int(self.feedback.buffer.map_or(0, |(_, size, _)| size as i64)),
            GL_FEEDBACK_BUFFER_TYPE => Value::int(self.feedback.buffer.map_or(GL_2D, |(_, _, kind)| kind)),
            GL_RENDER_MODE => Value::int(self.render_mode),
            _ => return None,
        })
    }

    /// Points, lines, polygons, scissor, textures.
    fn query_raster_state(&self, pname: GLenum) -> Option<Value> {
        let s = &self.state;
        let unit = &s.texture.units[s.texture.active];
        Some(match pname {
            GL_POINT_SIZE => Value::float(s.point.size),
            GL_POINT_SIZE_MIN => Value::float(s.point.size_min),
            GL_POINT_SIZE_MAX => Value::float(s.point.size_max),
            GL_POINT_FADE_THRESHOLD_SIZE => Value::float(s.point.fade_threshold),
            GL_POINT_DISTANCE_ATTENUATION => Value::floats(&s.point.attenuation),
            GL_POINT_SPRITE_COORD_ORIGIN => Value::int(s.point.sprite_origin),
            GL_LINE_WIDTH => Value::float(s.line.width),
            GL_LINE_STIPPLE_PATTERN => Value::int(s.line.stipple_pattern),
            GL_LINE_STIPPLE_REPEAT => Value::int(s.line.stipple_factor),
            GL_CULL_FACE_MODE => Value::int(s.polygon.cull_mode),
            GL_FRONT_FACE => Value::int(s.polygon.front_face),
            GL_POLYGON_MODE => Value::ints(&s.polygon.mode.map(|m| m as i32)),
            GL_POLYGON_OFFSET_FACTOR => Value::float(s.polygon.offset_factor),
            GL_POLYGON_OFFSET_UNITS => Value::float(s.polygon.offset_units),
            GL_SCISSOR_BOX => Value::ints(&[s.scissor.x, s.scissor.y, s.scissor.width, s.scissor.height]),
            GL_ACTIVE_TEXTURE => Value::int(GL_TEXTURE0 + s.texture.active as u32),
            GL_TEXTURE_BINDING_1D => Value::int(unit.bound[0]),
            GL_TEXTURE_BINDING_2D => Value::int(unit.bound[1]),
            GL_TEXTURE_BINDING_3D => Value::int(unit.bound[2]),
            GL_TEXTURE_BINDING_CUBE_MAP => Value::int(unit.bound[3]),
            GL_SAMPLE_COVERAGE_VALUE => Value::float(s.multisample.coverage_value),
            GL_SAMPLE_COVERAGE_INVERT => Value::bool(s.multisample.coverage_invert),
            _ => return None,
        })
    }

    /// Per-fragment operations and clear values.
    fn query_fragment_state(&self, pname: GLenum) -> Option<Value> {
        let s = &self.state;
        let color = &s.color_buffer;
        let [front, back] = &s.stencil.sides;
        Some(match pname {
            GL_ALPHA_TEST_FUNC => Value::int(color.alpha_func),
            GL_ALPHA_TEST_REF => Value::normalized(&[color.alpha_ref]),
            GL_BLEND_SRC | GL_BLEND_SRC_RGB => Value::int(color.blend_func[0]),
            GL_BLEND_DST | GL_BLEND_DST_RGB => Value::int(color.blend_func[1]),
            GL_BLEND_SRC_ALPHA => Value::int(color.blend_func[2]),
            GL_BLEND_DST_ALPHA => Value::int(color.blend_func[3]),
            GL_BLEND_EQUATION => Value::int(color.blend_equation[0]),
            GL_BLEND_EQUATION_ALPHA => Value::int(color.blend_equation[1]),
            GL_BLEND_COLOR => Value::normalized(&color.blend_color),
            GL_LOGIC_OP_MODE => Value::int(color.logic_op),
            GL_COLOR_WRITEMASK => Value::bools(&color.color_mask),
            GL_INDEX_WRITEMASK => Value::int(color.index_mask as i32),
            GL_COLOR_CLEAR_VALUE => Value::normalized(&color.clear_color),
            GL_INDEX_CLEAR_VALUE => Value::float(color.clear_index),
            GL_ACCUM_CLEAR_VALUE => Value::normalized(&s.accum_clear),
            GL_DEPTH_FUNC => Value::int(s.depth.func),
            GL_DEPTH_WRITEMASK => Value::bool(s.depth.write),
            GL_DEPTH_CLEAR_VALUE => Value::new(Kind::Normalized, [s.depth.clear]),
            GL_STENCIL_CLEAR_VALUE => Value::int(s.stencil.clear),
            GL_STENCIL_FUNC => Value::int(front.func),
            GL_STENCIL_REF => Value::int(front.reference.clamp(0, 255)),
            GL_STENCIL_VALUE_MASK => Value::int(front.value_mask),
            GL_STENCIL_WRITEMASK => Value::int(front.write_mask),
            GL_STENCIL_FAIL => Value::int(front.fail),
            GL_STENCIL_PASS_DEPTH_FAIL => Value::int(front.depth_fail),
            GL_STENCIL_PASS_DEPTH_PASS => Value::int(front.depth_pass),
            GL_STENCIL_BACK_FUNC => Value::int(back.func),
            GL_STENCIL_BACK_REF => Value::int(back.reference.clamp(0, 255)),
            GL_STENCIL_BACK_VALUE_MASK => Value::int(back.value_mask),
            GL_STENCIL_BACK_WRITEMASK => Value::int(back.write_mask),
            GL_STENCIL_BACK_FAIL => Value::int(back.fail),
            GL_STENCIL_BACK_PASS_DEPTH_FAIL => Value::int(back.depth_fail),
            GL_STENCIL_BACK_PASS_DEPTH_PASS => Value::int(back.depth_pass),
            _ => return None,
        })
    }

    /// Pixel store, transfer and zoom.
    fn query_pixel_state(&self, pname: GLenum) -> Option<Value> {
        let p = &self.state.pixel;
        if let Some(value) = query_store(&self.state.unpack, pname, GL_UNPACK_SWAP_BYTES, GL_UNPACK_SKIP_IMAGES, GL_UNPACK_IMAGE_HEIGHT) {
            return Some(value);
        }
        if let Some(value) = query_store(&self.state.pack, pname, GL_PACK_SWAP_BYTES, GL_PACK_SKIP_IMAGES, GL_PACK_IMAGE_HEIGHT) {
            return Some(value);
        }
        Some(match pname {
            GL_MAP_COLOR => Value::bool(p.map_color),
            GL_MAP_STENCIL => Value::bool(p.map_stencil),
            GL_INDEX_SHIFT => Value::int(p.index_shift),
            GL_INDEX_OFFSET => Value::int(p.index_offset),
            GL_RED_SCALE => Value::float(p.scale[0]),
            GL_GREEN_SCALE => Value::float(p.scale[1]),
            GL_BLUE_SCALE => Value::float(p.scale[2]),
            GL_ALPHA_SCALE => Value::float(p.scale[3]),
            GL_RED_BIAS => Value::float(p.bias[0]),
            GL_GREEN_BIAS => Value::float(p.bias[1]),
            GL_BLUE_BIAS => Value::float(p.bias[2]),
            GL_ALPHA_BIAS => Value::float(p.bias[3]),
            GL_DEPTH_SCALE => Value::float(p.depth_scale),
            GL_DEPTH_BIAS => Value::float(p.depth_bias),
            GL_ZOOM_X => Value::float(p.zoom[0]),
            GL_ZOOM_Y => Value::float(p.zoom[1]),
            GL_PIXEL_MAP_I_TO_I_SIZE..=GL_PIXEL_MAP_A_TO_A_SIZE => {
                Value::int(p.maps[(pname - GL_PIXEL_MAP_I_TO_I_SIZE) as usize].len() as i64)
            }
            _ => return None,
        })
    }
}

/// The names of one pixel store: six in a row from SWAP_BYTES to ALIGNMENT, and the two for three dimensions.
fn query_store(store: &PixelStore, pname: GLenum, swap_bytes: GLenum, skip_images: GLenum, image_height: GLenum) -> Option<Value> {
    if pname == skip_images {
        return Some(Value::int(store.skip_images));
    }
    if pname == image_height {
        return Some(Value::int(store.image_height));
    }
    Some(match pname.checked_sub(swap_bytes)? {
        0 => Value::bool(store.swap_bytes),
        1 => Value::bool(store.lsb_first),
        2 => Value::int(store.row_length),
        3 => Value::int(store.skip_rows),
        4 => Value::int(store.skip_pixels),
        5 => Value::int(store.alignment),
        _ => return None,
    })
}

/// Limits: what does not depend on the context.
fn query_limit(pname: GLenum) -> Option<Value> {
    Some(match pname {
        GL_MAX_LIGHTS => Value::int(MAX_LIGHTS as i64),
        GL_MAX_CLIP_PLANES => Value::int(MAX_CLIP_PLANES as i64),
        GL_MAX_TEXTURE_UNITS | GL_MAX_TEXTURE_COORDS | GL_MAX_TEXTURE_IMAGE_UNITS => Value::int(MAX_TEXTURE_UNITS as i64),
        GL_MAX_COMBINED_TEXTURE_IMAGE_UNITS => Value::int(MAX_TEXTURE_UNITS as i64),
        GL_MAX_MODELVIEW_STACK_DEPTH => Value::int(MODELVIEW_STACK_DEPTH as i64),
        GL_MAX_PROJECTION_STACK_DEPTH => Value::int(PROJECTION_STACK_DEPTH as i64),
        GL_MAX_TEXTURE_STACK_DEPTH => Value::int(TEXTURE_STACK_DEPTH as i64),
        GL_MAX_ATTRIB_STACK_DEPTH | GL_MAX_CLIENT_ATTRIB_STACK_DEPTH => Value::int(ATTRIB_STACK_DEPTH as i64),
        GL_MAX_NAME_STACK_DEPTH => Value::int(NAME_STACK_DEPTH as i64),
        GL_MAX_LIST_NESTING => Value::int(MAX_LIST_NESTING as i64),
        GL_MAX_TEXTURE_SIZE | GL_MAX_CUBE_MAP_TEXTURE_SIZE => Value::int(MAX_TEXTURE_SIZE),
        GL_MAX_RENDERBUFFER_SIZE => Value::int(MAX_RENDERBUFFER_SIZE),
        GL_MAX_3D_TEXTURE_SIZE => Value::int(2048),
        GL_MAX_TEXTURE_LOD_BIAS => Value::float(16.0),
        GL_MAX_VIEWPORT_DIMS => Value::ints(&[16384, 16384]),
        GL_MAX_PIXEL_MAP_TABLE => Value::int(256),
        GL_MAX_EVAL_ORDER => Value::int(30),
        GL_MAX_ELEMENTS_VERTICES | GL_MAX_ELEMENTS_INDICES => Value::int(65536),
        GL_SUBPIXEL_BITS => Value::int(crate::raster::layout::SUBPIXEL_BITS),
        GL_POINT_SIZE_RANGE | GL_ALIASED_POINT_SIZE_RANGE | GL_LINE_WIDTH_RANGE | GL_ALIASED_LINE_WIDTH_RANGE => {
            Value::floats(&[1.0, 255.0])
        }
        GL_POINT_SIZE_GRANULARITY | GL_LINE_WIDTH_GRANULARITY => Value::float(0.1),
        GL_AUX_BUFFERS | GL_INDEX_BITS | GL_INDEX_MODE | GL_STEREO => Value::int(0),
        GL_RGBA_MODE => Value::int(1),
        GL_NUM_COMPRESSED_TEXTURE_FORMATS => Value::int(0),
        GL_COMPRESSED_TEXTURE_FORMATS => Value::ints(&[]),
        _ => return None,
    })
}
