//! `TEPUI_PARITY=specification|osmesa`: whose rule holds where Mesa's OSMesa departs from the specification in a way that pictures show.
//!
//! The specification's by default. Whoever has pictures of OSMesa to compare with can have OSMesa's instead:
//! - glDrawPixels with GL_MAP_COLOR: Mesa's shader looks blue and alpha up in the image instead of the maps ([`mapped_as_osmesa`]);
//! - GL_POINT_SMOOTH: a disc of whole pixels ([`Smooth::Disc`](crate::program::fixed::Smooth));
//! - edge flags count in strips and fans too ([`Assembly`](crate::draw::assembly::Assembly));
//! - the size of points is attenuated by the distance along z, not by that from the eye;
//! - glCopyPixels carries depths through single precision ([`copied_depth`]);
//! - glEvalMesh adds up steps and does not meet the end of the domain exactly;
//! - user clip planes are taken to clip space, where distances lose precision when far / near is large
//!   ([`clip_plane`](super::clip_plane)).

use glam::{Mat4, Vec4};

use super::framebuffer::depth_word;
use super::pixel_format::Groups;
use super::pixel_transfer::R_TO_R;
use super::state::PixelState;
use crate::device::DepthFormat;

/// Whose rule holds.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Parity {
    /// The specification's.
    #[default]
    Specification,
    /// That of Mesa's OSMesa.
    Osmesa,
}

impl Parity {
    /// What `TEPUI_PARITY` asks for.
    pub fn from_environment() -> Parity {
        match std::env::var("TEPUI_PARITY").as_deref() {
            Ok("osmesa") => Parity::Osmesa,
            Ok("specification" | "") | Err(_) => Parity::Specification,
            Ok(other) => {
                log::warn!("TEPUI_PARITY={other}: neither specification nor osmesa; the specification's rules hold");
                Parity::Specification
            }
        }
    }
}

/// An image after scale, bias and maps as Mesa's shader has it: maps are tables of 256 entries that are read without rounding, and
/// blue and alpha are red and green of the image itself, at (blue, alpha).
pub(super) fn mapped_as_osmesa(state: &PixelState, size: [usize; 2], groups: Groups) -> Groups {
    const TABLE: usize = 256;
    let source: Vec<[f32; 4]> = match groups {
        Groups::Rgba8(pixels) => pixels.iter().map(|p| p.to_le_bytes().map(|c| f32::from(c) / 255.0)).collect(),
        Groups::Rgba(pixels) => pixels,
        other => return state.transferred_colors(other),
    };
    let texel = |v: f32, count: usize| ((v * count as f32).max(0.0) as usize).min(count - 1);
    let mapped = source.iter().map(|pixel| {
        let [r, g, b, a] = std::array::from_fn(|k| pixel[k] * state.scale[k] + state.bias[k]);
        let map = |k: usize, v: f32| {
            let map = &state.maps[R_TO_R + k];
            map[texel(v, TABLE) * map.len() / TABLE]
        };
        let [b, a, ..] = source[texel(a, size[1]) * size[0] + texel(b, size[0])];
        [map(0, r), map(1, g), b, a]
    });
    Groups::Rgba(mapped.collect())
}

/// A depth that glCopyPixels carries. With 24 bits OSMesa's shaders take it from a texture in single precision, twice: into a
/// texture of its own, and into the window.
pub(super) fn copied_depth(format: DepthFormat, depth: f64) -> f64 {
    const MAX: f32 = ((1 << 24) - 1) as f32;
    if format != DepthFormat::D24 {
        return depth;
    }
    let carry = |z: f32| (z * (1.0 / MAX) * MAX).round_ties_even();
    f64::from(carry(carry(depth_word(format, depth) as f32))) / f64::from(MAX)
}

/// A plane (a row vector) times the inverse of a matrix, in Mesa's single precision and order.
pub(super) fn plane_through_osmesas_inverse(matrix: &Mat4, plane: Vec4) -> Vec4 {
    let inverse = if is_rigid(matrix) { rigid_inverse(matrix) } else { gauss_jordan(matrix) };
    Vec4::from_array(std::array::from_fn(|k| {
        let column = inverse.col(k);
        ((plane.x * column.x + plane.y * column.y) + plane.z * column.z) + plane.w * column.w
    }))
}

/// A rotation and a translation.
fn is_rigid(m: &Mat4) -> bool {
    let near = |a: f32, b: f32| (a - b).abs() < 1e-6;
    let [x, y, z] = [m.x_axis, m.y_axis, m.z_axis];
    m.row(3) == Vec4::W
        && [x, y, z].iter().all(|axis| near(axis.length_squared(), 1.0))
        && [x.dot(y), y.dot(z), z.dot(x)].iter().all(|&cosine| near(cosine, 0.0))
}

fn rigid_inverse(m: &Mat4) -> Mat4 {
    let rotation = Mat4::from_mat3(glam::Mat3::from_mat4(*m).transpose());
    let t = m.w_axis;
    let back = |row: Vec4| -((t.x * row.x + t.y * row.y) + t.z * row.z);
    Mat4 { w_axis: Vec4::new(back(rotation.row(0)), back(rotation.row(1)), back(rotation.row(2)), 1.0), ..rotation }
}

/// By elimination with rows exchanged; the matrix itself where it is singular.
fn gauss_jordan(m: &Mat4) -> Mat4 {
    let mut left: [Vec4; 4] = std::array::from_fn(|r| m.row(r));
    let mut right = [Vec4::X, Vec4::Y, Vec4::Z, Vec4::W];
    for k in 0..4 {
        for r in (k + 1..4).rev() {
            if left[r][k].abs() > left[r - 1][k].abs() {
                left.swap(r, r - 1);
                right.swap(r, r - 1);
            }
        }
        if left[k][k] == 0.0 {
            return *m;
        }
        for r in k + 1..4 {
            let factor = left[r][k] / left[k][k];
            left[r] -= factor * left[k];
            right[r] -= factor * right[k];
        }
    }
    for k in (0..4).rev() {
        right[k] *= 1.0 / left[k][k];
        for r in 0..k {
            right[r] -= right[k] * left[r][k];
        }
    }
    Mat4::from_cols(right[0], right[1], right[2], right[3]).transpose()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blue_and_alpha_come_from_the_image() {
        let mut state = crate::gl::state::State::default().pixel;
        state.map_color = true;
        state.maps[R_TO_R] = vec![0.25, 0.75];
        state.maps[R_TO_R + 1] = vec![0.5];
        // Blue and alpha as OSMesa of Mesa 22.3 has them: of a row of six, blue chooses the pixel.
        let image = [[10, 20, 30, 40], [200, 20, 30, 40], [10, 200, 30, 40], [10, 20, 200, 40], [128, 64, 32, 16], [0, 0, 255, 255]];
        let groups = Groups::Rgba8(image.map(u32::from_le_bytes).to_vec());
        let Groups::Rgba(mapped) = mapped_as_osmesa(&state, [6, 1], groups) else { panic!("colours") };
        let bytes: Vec<[u8; 4]> = mapped.iter().map(|p| p.map(|v| (v * 255.0).round() as u8)).collect();
        assert_eq!(bytes[0], [64, 128, 10, 20]);
        assert_eq!(bytes[1], [191, 128, 10, 20]);
        assert_eq!(bytes[3], [64, 128, 128, 64]);
        assert_eq!(bytes[5], [64, 128, 0, 0]);
    }

    #[test]
    fn depths_are_copied_as_osmesa_copies_them() {
        let copied = |word: u32| depth_word(DepthFormat::D24, copied_depth(DepthFormat::D24, DepthFormat::D24.depth(word)));
        // Of OSMesa of Mesa 22.3.
        let pairs = [
            (0, 0),
            (0x50_0001, 0x50_0001),
            (0x60_0000, 0x60_0000),
            (0x60_0001, 0x60_0002),
            (0xbf_ffff, 0xbf_ffff),
            (0xff_7fff, 0xff_8001),
        ];
        for (from, to) in pairs {
            assert_eq!(copied(from), to, "{from:#x}");
        }
        assert_eq!(copied_depth(DepthFormat::F32, 0.7), 0.7);
    }

    #[test]
    fn both_inverses_invert() {
        let rigid = Mat4::from_rotation_translation(glam::Quat::from_rotation_x(0.3), glam::Vec3::new(1.0, 2.0, -5.0));
        assert!(is_rigid(&rigid) && !is_rigid(&(rigid * Mat4::from_scale(glam::Vec3::splat(2.0)))));
        assert!((rigid * rigid_inverse(&rigid)).abs_diff_eq(Mat4::IDENTITY, 1e-6));
        // The zero at the top left asks for an exchange of rows.
        let general = Mat4::from_cols_array(&[0.0, 2.0, 0.0, 1.0, 1.0, 0.0, 3.0, 0.0, 0.0, 1.0, -1.1, -1.0, 0.5, 0.0, -2.1, 0.0]);
        assert!((general * gauss_jordan(&general)).abs_diff_eq(Mat4::IDENTITY, 1e-5));
        assert_eq!(gauss_jordan(&Mat4::ZERO), Mat4::ZERO);
    }
}
