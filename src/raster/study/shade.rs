//! Depth and colour of covered pixels, eight at once or one by one, with the bits of [`crate::raster::fast`].

use crate::raster::layout::*;
use crate::raster::simd::Simd;
use crate::raster::{blend, depth_stencil};

/// The greatest value of 24 bits of depth.
const DEPTH_SCALE: f32 = 16_777_215.0;

/// A triangle's planes.
pub struct Shader<'a> {
    head: [f32; 4],
    tail: [f32; 4],
    color: &'a [[f32; 4]; 3],
    perspective: bool,
    depth: bool,
}

impl<'a> Shader<'a> {
    /// Of a triangle whose only varying is its colour.
    #[inline(always)]
    pub fn new(triangle: &Triangle, planes: &'a [[f32; 4]], depth: bool) -> Shader<'a> {
        let planes = &planes[triangle.planes as usize..];
        let color = planes[DEPTH_PLANE_VEC4 as usize..][..VARYING_PLANE_VEC4 as usize].try_into().expect("three");
        Shader { head: planes[0], tail: planes[1], color, perspective: triangle.flags & triangle_flags::PERSPECTIVE != 0, depth }
    }
}

/// Shades the pixels from `place` to the right whose bit is set.
#[inline(always)]
pub fn shade_row<S: Simd>(shader: &Shader, place: [i32; 2], mask: u32, color: &mut [u32; 8], depth: &mut [u32; 8]) {
    let Shader { head, tail, color: p, .. } = shader;
    let mut inside = S::mask(mask);
    let x = S::add(S::f(place[0] as f32), S::load(&[0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0]));
    let y = S::f(place[1] as f32);
    if shader.depth {
        let z = S::fma(y, S::f(head[2]), S::fma(x, S::f(head[1]), S::f(head[0])));
        let z = depth_stencil::quantize::<S>(S::add(z, S::f(tail[2])), [0.0, 1.0], DEPTH_SCALE);
        let old = S::load_u(depth);
        inside = S::and(inside, S::gt(old, z));
        if S::signs(inside) == 0 {
            return;
        }
        S::store_u(S::select(inside, z, old), depth);
    }
    let mut columns = [S::f(0.0); 4];
    for c in 0..4 {
        columns[c] = S::fma(y, S::f(p[2][c]), S::fma(x, S::f(p[1][c]), S::f(p[0][c])));
    }
    if shader.perspective {
        let reciprocal = S::div(S::f(1.0), S::fma(y, S::f(tail[1]), S::fma(x, S::f(tail[0]), S::f(head[3]))));
        for c in &mut columns {
            *c = S::mul(*c, reciprocal);
        }
    }
    let new = blend::quantize4::<S>(columns);
    S::store_u(S::select(inside, new, S::load_u(color)), color);
}

/// Shades one pixel.
#[inline(always)]
pub fn shade_pixel(shader: &Shader, place: [i32; 2], color: &mut u32, depth: &mut u32) {
    let Shader { head, tail, color: p, .. } = shader;
    let [x, y] = place.map(|v| v as f32);
    if shader.depth {
        let z = y.mul_add(head[2], x.mul_add(head[1], head[0])) + tail[2];
        let z = (z.clamp(0.0, 1.0) * DEPTH_SCALE).round_ties_even() as u32;
        if z >= *depth {
            return;
        }
        *depth = z;
    }
    let reciprocal = if shader.perspective { 1.0 / y.mul_add(tail[1], x.mul_add(tail[0], head[3])) } else { 1.0 };
    let mut bytes = [0; 4];
    for c in 0..4 {
        let value = y.mul_add(p[2][c], x.mul_add(p[1][c], p[0][c])) * reciprocal;
        bytes[c] = (value.min(1.0) * 255.0).round_ties_even() as u8;
    }
    *color = u32::from_le_bytes(bytes);
}
