//! Texture sampling, the intrinsic `texture_sample` of programs.

use crate::draw::texture::TextureBinding;
use crate::program::lanes::{LANES, Simd};

/// Samples one group of lanes: `coord` is s, t, r and an unused fourth; `gradients` the derivatives of s, t, r in x and y
/// of the raster, absent where no level of detail is wanted.
pub fn sample_group(
    _binding: &TextureBinding,
    _coord: &[[f32; LANES]; 4],
    _gradients: Option<[&[[f32; LANES]; 3]; 2]>,
    _level: Simd,
) -> [[f32; LANES]; 4] {
    [[1.0; LANES]; 4]
}
