//! Texture images as a batch sees them: immutable snapshots, shared by `Arc`.

use std::sync::Arc;

/// Storage of a texel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum TexelFormat {
    /// One `u32` a texel, red in the low byte. All normalised formats of up to 8 bits a component, expanded to RGBA
    /// by their base format (luminance to R=G=B, absent alpha to 1, absent colours to 0).
    Rgba8,
    /// Four `f32` a texel, as words, expanded likewise.
    Rgba32f,
}

/// One mipmap level.
#[derive(Clone, Debug, PartialEq)]
pub struct TextureLevel {
    /// Width in texels.
    pub width: u32,
    /// Height in texels, 1 for 1D textures.
    pub height: u32,
    /// Depth in texels, 1 for 1D and 2D; 6 faces for cube maps.
    pub depth: u32,
    /// Texels, x fastest, then y, then z; [`TexelFormat`] says how many words each.
    /// Shared with the GL object, which copies before it writes while a batch still holds them.
    pub texels: Arc<Vec<u32>>,
}

/// What kind of texture.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum TextureKind {
    D1,
    D2,
    D3,
    Cube,
}

/// A complete texture: the levels that sampling may reach.
#[derive(Clone, Debug, PartialEq)]
pub struct TextureImage {
    /// Unique over the process and never reused: a device caches its copy by this.
    pub id: u64,
    /// Kind.
    pub kind: TextureKind,
    /// Texel storage.
    pub format: TexelFormat,
    /// Levels from the base level on.
    pub levels: Vec<TextureLevel>,
}

/// Wrap modes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[repr(u32)]
#[allow(missing_docs)]
pub enum Wrap {
    Repeat = 0,
    Clamp = 1,
    ClampToEdge = 2,
    ClampToBorder = 3,
    MirroredRepeat = 4,
}

/// Filtering of a texture unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sampler {
    /// Wrap modes of s, t, r.
    pub wrap: [Wrap; 3],
    /// Magnification: linear, else nearest.
    pub mag_linear: bool,
    /// Minification within a level: linear, else nearest.
    pub min_linear: bool,
    /// Between levels: `None` no mipmaps, `Some(false)` nearest level, `Some(true)` linear.
    pub mip_linear: Option<bool>,
    /// Least and greatest level of detail (GL_TEXTURE_MIN_LOD, MAX_LOD).
    pub lod_range: [f32; 2],
    /// Sum of the texture's and the unit's bias.
    pub lod_bias: f32,
    /// Border colour, expanded by the base format.
    pub border: [f32; 4],
}

impl Sampler {
    /// The nearest texel of the base level, that at the edge beyond it.
    pub const NEAREST: Sampler = Sampler {
        wrap: [Wrap::ClampToEdge; 3],
        mag_linear: false,
        min_linear: false,
        mip_linear: None,
        lod_range: [-1000.0, 1000.0],
        lod_bias: 0.0,
        border: [0.0; 4],
    };
}

/// A texture and how it is sampled.
#[derive(Clone, Debug)]
pub struct TextureBinding {
    /// The image.
    pub image: Arc<TextureImage>,
    /// The sampler.
    pub sampler: Sampler,
}
