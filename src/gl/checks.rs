//! What setters share: storing a value with its dirty group, and the sets of enums that several commands accept.

use super::enums::*;

/// Stores a value and marks its group if that changed anything. NaN counts as a change.
pub(crate) fn put<T: PartialEq>(slot: &mut T, value: T, dirty: &mut u32, group: u32) {
    if *slot != value {
        *slot = value;
        *dirty |= group;
    }
}

/// GL_NEVER to GL_ALWAYS.
pub(crate) fn is_compare_func(func: GLenum) -> bool {
    (GL_NEVER..=GL_ALWAYS).contains(&func)
}

/// GL_FRONT, GL_BACK, GL_FRONT_AND_BACK as indices into a front-and-back pair.
pub(crate) fn faces(face: GLenum) -> Option<std::ops::Range<usize>> {
    match face {
        GL_FRONT => Some(0..1),
        GL_BACK => Some(1..2),
        GL_FRONT_AND_BACK => Some(0..2),
        _ => None,
    }
}

/// Clamps to [0, 1]; NaN becomes 0.
pub(crate) fn clamp01(v: f32) -> f32 {
    v.max(0.0).min(1.0)
}

/// Clamps to [0, 1]; NaN becomes 0.
pub(crate) fn clamp01_f64(v: f64) -> f64 {
    v.max(0.0).min(1.0)
}

/// The first four of a vector parameter.
pub(crate) fn vec4(params: &[f32]) -> Option<[f32; 4]> {
    params.get(..4)?.try_into().ok()
}

/// An enum that came as a float.
pub(crate) fn enum_from(param: f32) -> GLenum {
    param as GLenum
}

/// A copy of a command's parameters (at most four), for a display list to keep.
#[derive(Clone, Copy)]
pub(crate) struct Params {
    count: usize,
    values: [f32; 4],
}

impl Params {
    pub fn new(params: &[f32]) -> Params {
        let mut copy = Params { count: params.len().min(4), values: [0.0; 4] };
        copy.values[..copy.count].copy_from_slice(&params[..copy.count]);
        copy
    }

    pub fn as_slice(&self) -> &[f32] {
        &self.values[..self.count]
    }
}
