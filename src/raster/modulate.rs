//! The commonest program without the lane executor: a colour times the texel of one texture. The same operations as the program's
//! text, so the same bits; a test compares the two.

use super::simd::{Level, Simd};
use super::texture;
use crate::draw::texture::TextureBinding;
use crate::program::Modulate;
use crate::program::lanes::{self, Column4, LANES};

/// Colours of the first `groups` groups of fragments.
#[inline(always)]
pub fn run<S: Simd>(what: Modulate, binding: &TextureBinding, inputs: &[Column4], color: &mut Column4, groups: usize) {
    let level = if S::LEVEL == Level::Scalar { lanes::Simd::Scalar } else { lanes::Simd::Avx2 };
    let primary = &inputs[if what.lod { 4 } else { 1 }];
    for g in 0..groups {
        let mut coord = [[0.0; LANES]; 4];
        let at = project::<S>(&inputs[0], g);
        S::store(at[0], &mut coord[0]);
        S::store(at[1], &mut coord[1]);
        let mut gradients = [[[0.0; LANES]; 3]; 2];
        if what.lod {
            let (origin, right, down) = (project::<S>(&inputs[1], g), project::<S>(&inputs[2], g), project::<S>(&inputs[3], g));
            for c in 0..2 {
                S::store(S::sub(right[c], origin[c]), &mut gradients[0][c]);
                S::store(S::sub(down[c], origin[c]), &mut gradients[1][c]);
            }
        }
        let wanted = if what.lod { Some([&gradients[0], &gradients[1]]) } else { None };
        let texel = texture::sample_group(binding, &coord, wanted, level);
        for c in 0..4 {
            let mut value = S::load(&primary[c][g]);
            if what.parts[c / 3] {
                value = S::mul(value, S::load(&texel[c]));
            }
            S::store(value, &mut color[c][g]);
        }
    }
}

/// s and t of a group, divided by q.
#[inline(always)]
fn project<S: Simd>(coord: &Column4, g: usize) -> [S::F; 2] {
    let q = S::load(&coord[3][g]);
    [S::div(S::load(&coord[0][g]), q), S::div(S::load(&coord[1][g]), q)]
}
