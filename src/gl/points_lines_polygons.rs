//! State of points, lines and polygons (3.3, 3.4, 3.5), and hints (5.6).

use super::checks::{Params, faces, put};
use super::enums::*;
use super::{Context, dirty};

impl Context {
    /// glPointSize. The size is kept as given; rasterization clamps it.
    pub fn point_size(&mut self, size: f32) {
        if self.compile(move |cx| cx.point_size(size)) || self.inside_begin_end() {
            return;
        }
        if size.is_nan() || size <= 0.0 {
            return self.set_error(GL_INVALID_VALUE, "glPointSize");
        }
        put(&mut self.state.point.size, size, &mut self.dirty, dirty::RASTER);
    }

    /// glPointParameter{if}[v].
    pub fn point_parameter(&mut self, pname: GLenum, params: &[f32]) {
        let given = Params::new(params);
        if self.compile(move |cx| cx.point_parameter(pname, given.as_slice())) || self.inside_begin_end() {
            return;
        }
        let Some(&value) = params.first() else { return };
        let point = &mut self.state.point;
        match pname {
            GL_POINT_SIZE_MIN | GL_POINT_SIZE_MAX | GL_POINT_FADE_THRESHOLD_SIZE => {
                if value.is_nan() || value < 0.0 {
                    return self.set_error(GL_INVALID_VALUE, "glPointParameter");
                }
                let slot = match pname {
                    GL_POINT_SIZE_MIN => &mut point.size_min,
                    GL_POINT_SIZE_MAX => &mut point.size_max,
                    _ => &mut point.fade_threshold,
                };
                put(slot, value, &mut self.dirty, dirty::RASTER);
            }
            GL_POINT_DISTANCE_ATTENUATION => {
                let Some(&attenuation) = params.first_chunk::<3>() else {
                    return self.set_error(GL_INVALID_ENUM, "glPointParameter(GL_POINT_DISTANCE_ATTENUATION)");
                };
                put(&mut point.attenuation, attenuation, &mut self.dirty, dirty::RASTER);
            }
            GL_POINT_SPRITE_COORD_ORIGIN => {
                let origin = value as GLenum;
                if origin != GL_LOWER_LEFT && origin != GL_UPPER_LEFT {
                    return self.set_error(GL_INVALID_VALUE, "glPointParameter(GL_POINT_SPRITE_COORD_ORIGIN)");
                }
                put(&mut point.sprite_origin, origin, &mut self.dirty, dirty::RASTER);
            }
            _ => self.set_error(GL_INVALID_ENUM, "glPointParameter"),
        }
    }

    /// glLineWidth. The width is kept as given; rasterization clamps it.
    pub fn line_width(&mut self, width: f32) {
        if self.compile(move |cx| cx.line_width(width)) || self.inside_begin_end() {
            return;
        }
        if width.is_nan() || width <= 0.0 {
            return self.set_error(GL_INVALID_VALUE, "glLineWidth");
        }
        put(&mut self.state.line.width, width, &mut self.dirty, dirty::RASTER);
    }

    /// glLineStipple. The factor is clamped to 1..256.
    pub fn line_stipple(&mut self, factor: i32, pattern: u16) {
        if self.compile(move |cx| cx.line_stipple(factor, pattern)) || self.inside_begin_end() {
            return;
        }
        put(&mut self.state.line.stipple_factor, factor.clamp(1, 256), &mut self.dirty, dirty::RASTER);
        put(&mut self.state.line.stipple_pattern, pattern, &mut self.dirty, dirty::RASTER);
    }

    /// glCullFace.
    pub fn cull_face(&mut self, mode: GLenum) {
        if self.compile(move |cx| cx.cull_face(mode)) || self.inside_begin_end() {
            return;
        }
        if faces(mode).is_none() {
            return self.set_error(GL_INVALID_ENUM, "glCullFace");
        }
        put(&mut self.state.polygon.cull_mode, mode, &mut self.dirty, dirty::RASTER);
    }

    /// glFrontFace.
    pub fn front_face(&mut self, mode: GLenum) {
        if self.compile(move |cx| cx.front_face(mode)) || self.inside_begin_end() {
            return;
        }
        if mode != GL_CW && mode != GL_CCW {
            return self.set_error(GL_INVALID_ENUM, "glFrontFace");
        }
        put(&mut self.state.polygon.front_face, mode, &mut self.dirty, dirty::RASTER);
    }

    /// glPolygonMode.
    pub fn polygon_mode(&mut self, face: GLenum, mode: GLenum) {
        if self.compile(move |cx| cx.polygon_mode(face, mode)) || self.inside_begin_end() {
            return;
        }
        let (Some(range), GL_POINT | GL_LINE | GL_FILL) = (faces(face), mode) else {
            return self.set_error(GL_INVALID_ENUM, "glPolygonMode");
        };
        for side in range {
            put(&mut self.state.polygon.mode[side], mode, &mut self.dirty, dirty::RASTER);
        }
    }

    /// glPolygonOffset.
    pub fn polygon_offset(&mut self, factor: f32, units: f32) {
        if self.compile(move |cx| cx.polygon_offset(factor, units)) || self.inside_begin_end() {
            return;
        }
        put(&mut self.state.polygon.offset_factor, factor, &mut self.dirty, dirty::RASTER);
        put(&mut self.state.polygon.offset_units, units, &mut self.dirty, dirty::RASTER);
    }

    /// glHint.
    pub fn hint(&mut self, target: GLenum, mode: GLenum) {
        if self.compile(move |cx| cx.hint(target, mode)) || self.inside_begin_end() {
            return;
        }
        let hint = &mut self.state.hint;
        let slot = match target {
            GL_PERSPECTIVE_CORRECTION_HINT => &mut hint.perspective_correction,
            GL_POINT_SMOOTH_HINT => &mut hint.point_smooth,
            GL_LINE_SMOOTH_HINT => &mut hint.line_smooth,
            GL_POLYGON_SMOOTH_HINT => &mut hint.polygon_smooth,
            GL_FOG_HINT => &mut hint.fog,
            GL_GENERATE_MIPMAP_HINT => &mut hint.generate_mipmap,
            GL_TEXTURE_COMPRESSION_HINT => &mut hint.texture_compression,
            GL_FRAGMENT_SHADER_DERIVATIVE_HINT => &mut hint.fragment_derivative,
            _ => return self.set_error(GL_INVALID_ENUM, "glHint"),
        };
        if !matches!(mode, GL_DONT_CARE | GL_FASTEST | GL_NICEST) {
            return self.set_error(GL_INVALID_ENUM, "glHint");
        }
        // A fog hint may choose fog by vertex; all others change nothing here.
        put(slot, mode, &mut self.dirty, dirty::FOG);
    }
}
