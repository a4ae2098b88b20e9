//! User clip planes (2.12).

use glam::{DMat4, DVec4, Mat4};

use super::enable::index_below;
use super::enums::*;
use super::parity::plane_through_osmesas_inverse;
use super::state::MAX_CLIP_PLANES;
use super::{Context, Parity, dirty};

impl Context {
    /// glClipPlane: the plane is kept in eye coordinates, `equation * inverse(modelview)`.
    pub fn clip_plane(&mut self, plane: GLenum, equation: [f64; 4]) {
        if self.compile(move |cx| cx.clip_plane(plane, equation)) || self.inside_begin_end() {
            return;
        }
        let Some(index) = index_below(plane, GL_CLIP_PLANE0, MAX_CLIP_PLANES) else {
            return self.set_error(GL_INVALID_ENUM, "glClipPlane");
        };
        let (modelview, equation) = (self.modelview.top(), DVec4::from(equation));
        self.state.transform.clip_planes[index] = match self.config.parity {
            Parity::Specification => plane_through_inverse(modelview, equation).as_vec4(),
            Parity::Osmesa => plane_through_osmesas_inverse(modelview, equation.as_vec4()),
        };
        self.dirty |= dirty::RASTER;
    }

    /// glGetClipPlane: in eye coordinates, or nothing after an error.
    pub fn get_clip_plane(&mut self, plane: GLenum) -> Option<[f64; 4]> {
        if self.inside_begin_end() {
            return None;
        }
        let Some(index) = index_below(plane, GL_CLIP_PLANE0, MAX_CLIP_PLANES) else {
            self.set_error(GL_INVALID_ENUM, "glGetClipPlane");
            return None;
        };
        Some(self.state.transform.clip_planes[index].as_dvec4().to_array())
    }
}

/// A plane (a row vector) times the inverse of a matrix. A singular matrix leaves the plane as it is: the
/// specification leaves the result undefined.
pub(crate) fn plane_through_inverse(matrix: &Mat4, plane: DVec4) -> DVec4 {
    let matrix: DMat4 = matrix.as_dmat4();
    let determinant = matrix.determinant();
    if determinant == 0.0 || !determinant.is_finite() {
        return plane;
    }
    matrix.inverse().transpose() * plane
}
