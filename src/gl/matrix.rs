//! Matrices (2.11.2).
//!
//! The formulas and the order of their operations are Mesa's: products are ((a0 b0 + a1 b1) + a2 b2) + a3 b3 in f32, not
//! fused, and f64 arguments become f32 first, so that transformed vertices are equal to the bit.

use glam::{Mat4, Vec4};

use super::enums::*;
use super::state::MatrixStack;
use super::{Context, dirty};

/// a * b.
pub(crate) fn multiply(a: &Mat4, b: &Mat4) -> Mat4 {
    let column = |c: Vec4| ((a.x_axis * c.x + a.y_axis * c.y) + a.z_axis * c.z) + a.w_axis * c.w;
    Mat4::from_cols(column(b.x_axis), column(b.y_axis), column(b.z_axis), column(b.w_axis))
}

/// The matrix of glRotate; `None` where the axis is too short to be one.
fn rotation(angle: f32, x: f32, y: f32, z: f32) -> Option<Mat4> {
    let radians = (f64::from(angle) * std::f64::consts::PI / 180.0) as f32;
    let (s, c) = (radians.sin(), radians.cos());
    let mut m = Mat4::IDENTITY;
    // About one axis the other elements are exact.
    if x == 0.0 && y == 0.0 && z != 0.0 {
        let s = if z < 0.0 { -s } else { s };
        m.x_axis = Vec4::new(c, s, 0.0, 0.0);
        m.y_axis = Vec4::new(-s, c, 0.0, 0.0);
    } else if x == 0.0 && y != 0.0 && z == 0.0 {
        let s = if y < 0.0 { -s } else { s };
        m.x_axis = Vec4::new(c, 0.0, -s, 0.0);
        m.z_axis = Vec4::new(s, 0.0, c, 0.0);
    } else if x != 0.0 && y == 0.0 && z == 0.0 {
        let s = if x < 0.0 { -s } else { s };
        m.y_axis = Vec4::new(0.0, c, s, 0.0);
        m.z_axis = Vec4::new(0.0, -s, c, 0.0);
    } else {
        let length = (x * x + y * y + z * z).sqrt();
        if length <= 1.0e-4 {
            return None;
        }
        let (x, y, z) = (x / length, y / length, z / length);
        let (xs, ys, zs) = (x * s, y * s, z * s);
        let (xy, yz, zx) = (x * y, y * z, z * x);
        let t = 1.0 - c;
        m.x_axis = Vec4::new(t * (x * x) + c, t * xy + zs, t * zx - ys, 0.0);
        m.y_axis = Vec4::new(t * xy - zs, t * (y * y) + c, t * yz + xs, 0.0);
        m.z_axis = Vec4::new(t * zx + ys, t * yz - xs, t * (z * z) + c, 0.0);
    }
    Some(m)
}

impl Context {
    /// glMatrixMode.
    pub fn matrix_mode(&mut self, mode: GLenum) {
        if self.compile(move |cx| cx.matrix_mode(mode)) || self.inside_begin_end() {
            return;
        }
        if !matches!(mode, GL_MODELVIEW | GL_PROJECTION | GL_TEXTURE) {
            // GL_COLOR belongs to ARB_imaging, which is not offered.
            return self.set_error(GL_INVALID_ENUM, "glMatrixMode: mode");
        }
        self.state.transform.matrix_mode = mode;
    }

    /// The stack that matrix commands work on.
    fn matrix_stack(&mut self) -> &mut MatrixStack {
        match self.state.transform.matrix_mode {
            GL_PROJECTION => &mut self.projection,
            GL_TEXTURE => &mut self.texture_matrices[self.state.texture.active],
            _ => &mut self.modelview,
        }
    }

    fn change_matrix(&mut self, change: impl FnOnce(&mut Mat4)) {
        change(self.matrix_stack().top_mut());
        self.dirty |= dirty::TRANSFORM;
    }

    /// glPushMatrix.
    pub fn push_matrix(&mut self) {
        if self.compile(|cx| cx.push_matrix()) || self.inside_begin_end() {
            return;
        }
        let stack = self.matrix_stack();
        if stack.stack.len() >= stack.limit {
            return self.set_error(GL_STACK_OVERFLOW, "glPushMatrix");
        }
        let top = *stack.top();
        stack.stack.push(top);
    }

    /// glPopMatrix.
    pub fn pop_matrix(&mut self) {
        if self.compile(|cx| cx.pop_matrix()) || self.inside_begin_end() {
            return;
        }
        let stack = self.matrix_stack();
        if stack.stack.len() == 1 {
            return self.set_error(GL_STACK_UNDERFLOW, "glPopMatrix");
        }
        let old = stack.stack.pop();
        if old.as_ref() != Some(stack.top()) {
            self.dirty |= dirty::TRANSFORM;
        }
    }

    /// glLoadIdentity.
    pub fn load_identity(&mut self) {
        if self.compile(|cx| cx.load_identity()) || self.inside_begin_end() {
            return;
        }
        self.change_matrix(|top| *top = Mat4::IDENTITY);
    }

    /// glLoadMatrix*: column-major.
    pub fn load_matrix(&mut self, m: [f32; 16]) {
        if self.compile(move |cx| cx.load_matrix(m)) || self.inside_begin_end() {
            return;
        }
        self.change_matrix(|top| *top = Mat4::from_cols_array(&m));
    }

    /// glLoadTransposeMatrix*: row-major.
    pub fn load_transpose_matrix(&mut self, m: [f32; 16]) {
        self.load_matrix(Mat4::from_cols_array(&m).transpose().to_cols_array());
    }

    /// glMultMatrix*: column-major.
    pub fn mult_matrix(&mut self, m: [f32; 16]) {
        if self.compile(move |cx| cx.mult_matrix(m)) || self.inside_begin_end() {
            return;
        }
        self.change_matrix(|top| *top = multiply(top, &Mat4::from_cols_array(&m)));
    }

    /// glMultTransposeMatrix*: row-major.
    pub fn mult_transpose_matrix(&mut self, m: [f32; 16]) {
        self.mult_matrix(Mat4::from_cols_array(&m).transpose().to_cols_array());
    }

    /// glRotate*: degrees about an axis.
    pub fn rotate(&mut self, angle: f32, x: f32, y: f32, z: f32) {
        if self.compile(move |cx| cx.rotate(angle, x, y, z)) || self.inside_begin_end() {
            return;
        }
        if angle != 0.0
            && let Some(m) = rotation(angle, x, y, z)
        {
            self.change_matrix(|top| *top = multiply(top, &m));
        }
    }

    /// glScale*.
    pub fn scale(&mut self, x: f32, y: f32, z: f32) {
        if self.compile(move |cx| cx.scale(x, y, z)) || self.inside_begin_end() {
            return;
        }
        self.change_matrix(|top| {
            top.x_axis *= x;
            top.y_axis *= y;
            top.z_axis *= z;
        });
    }

    /// glTranslate*.
    pub fn translate(&mut self, x: f32, y: f32, z: f32) {
        if self.compile(move |cx| cx.translate(x, y, z)) || self.inside_begin_end() {
            return;
        }
        self.change_matrix(|top| top.w_axis = ((top.x_axis * x + top.y_axis * y) + top.z_axis * z) + top.w_axis);
    }

    /// glFrustum.
    pub fn frustum(&mut self, left: f64, right: f64, bottom: f64, top: f64, near: f64, far: f64) {
        if self.compile(move |cx| cx.frustum(left, right, bottom, top, near, far)) || self.inside_begin_end() {
            return;
        }
        let [l, r, b, t, n, f] = [left, right, bottom, top, near, far].map(|value| value as f32);
        if near <= 0.0 || far <= 0.0 || near == far || left == right || top == bottom {
            return self.set_error(GL_INVALID_VALUE, "glFrustum");
        }
        let m = Mat4::from_cols(
            Vec4::new((2.0 * n) / (r - l), 0.0, 0.0, 0.0),
            Vec4::new(0.0, (2.0 * n) / (t - b), 0.0, 0.0),
            Vec4::new((r + l) / (r - l), (t + b) / (t - b), -(f + n) / (f - n), -1.0),
            Vec4::new(0.0, 0.0, -(2.0 * f * n) / (f - n), 0.0),
        );
        self.change_matrix(|matrix| *matrix = multiply(matrix, &m));
    }

    /// glOrtho.
    pub fn ortho(&mut self, left: f64, right: f64, bottom: f64, top: f64, near: f64, far: f64) {
        if self.compile(move |cx| cx.ortho(left, right, bottom, top, near, far)) || self.inside_begin_end() {
            return;
        }
        let [l, r, b, t, n, f] = [left, right, bottom, top, near, far].map(|value| value as f32);
        if near == far || left == right || top == bottom {
            return self.set_error(GL_INVALID_VALUE, "glOrtho");
        }
        let m = Mat4::from_cols(
            Vec4::new(2.0 / (r - l), 0.0, 0.0, 0.0),
            Vec4::new(0.0, 2.0 / (t - b), 0.0, 0.0),
            Vec4::new(0.0, 0.0, -2.0 / (f - n), 0.0),
            Vec4::new(-(r + l) / (r - l), -(t + b) / (t - b), -(f + n) / (f - n), 1.0),
        );
        self.change_matrix(|matrix| *matrix = multiply(matrix, &m));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gl::ContextConfig;

    #[test]
    fn a_rotation_about_an_axis_is_exact_elsewhere() {
        let m = rotation(90.0, 0.0, 0.0, 2.0).unwrap();
        assert_eq!(m.z_axis, Vec4::Z);
        assert_eq!((m.x_axis.y, m.y_axis.x), (1.0, -1.0));
        assert!(rotation(30.0, 1e-5, 1e-5, 0.0).is_none());
    }

    #[test]
    fn general_and_single_axis_rotations_agree() {
        let single = rotation(33.0, 0.0, -1.0, 0.0).unwrap();
        let general = rotation(33.0, 1e-9, -1.0, 1e-9).unwrap();
        assert!(single.abs_diff_eq(general, 1e-6));
    }

    #[test]
    fn stacks_do_not_overflow() {
        let mut cx = Context::new(ContextConfig::default(), None);
        cx.pop_matrix();
        assert_eq!(cx.get_error(), GL_STACK_UNDERFLOW);
        for _ in 0..31 {
            cx.push_matrix();
        }
        assert_eq!(cx.get_error(), GL_NO_ERROR);
        cx.push_matrix();
        assert_eq!(cx.get_error(), GL_STACK_OVERFLOW);
    }

    #[test]
    fn a_frustum_needs_planes_in_front() {
        let mut cx = Context::new(ContextConfig::default(), None);
        cx.frustum(-1.0, 1.0, -1.0, 1.0, 0.0, 10.0);
        assert_eq!(cx.get_error(), GL_INVALID_VALUE);
        assert_eq!(*cx.modelview.top(), Mat4::IDENTITY);
    }
}
