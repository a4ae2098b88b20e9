//! What a context keeps for the pixel commands besides its state.

use super::accum::AccumBuffer;
use super::texture_image::Proxy;

/// Proxies, accumulation buffer, images of bitmaps.
#[derive(Default)]
pub(crate) struct PixelObjects {
    /// Answers of the proxy targets 1D, 2D, 3D and cube map.
    pub proxies: [Proxy; 4],
    /// The accumulation buffer, once something used it.
    pub accum: Option<AccumBuffer>,
}
