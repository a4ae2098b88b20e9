//! The derived state of pixel rectangles and bitmaps: the fragment program and the per-fragment operations of any other draw, but
//! vertices in window space and none of the polygon state.

use super::uniforms;
use crate::draw::recorder::{DrawState, Revised};
use crate::draw::texture::TextureBinding;
use crate::gl::{Context, dirty};
use crate::program::Output;
use crate::program::fixed::{self, Source};
use crate::raster::layout::*;

impl Context {
    /// Tells the recorder the state of rectangles in window space, whose colours come from an image or from the vertices. The
    /// next ordinary draw sets its own again.
    pub(crate) fn set_rectangle_state(&mut self, image: Option<TextureBinding>) {
        let mut textures = Vec::new();
        let mut key = self.fragment_key(topology::TRIANGLES, &mut textures);
        key.smooth = fixed::Smooth::None;
        if let Some(image) = image {
            key.source = Source::Image;
            textures.push(image);
        }
        let fragment = fixed::fragment_program(&key);
        let mut outputs: Vec<Output> = fragment.program.varyings.iter().map(|varying| varying.front).collect();
        outputs.sort_unstable();
        let vertex = fixed::window_program(&outputs);
        let mut uniforms = Vec::new();
        uniforms::Values::new(self).update(&mut uniforms, &fragment.slots, dirty::ALL);
        let raster_state = RasterState {
            flags: raster_flags::WINDOW_SPACE | raster_flags::NO_Z_CLIP | raster_flags::FRONT_CCW,
            polygon_mode: [topology::TRIANGLES; 2],
            offset_factor: 0.0,
            offset_units: 0.0,
            ..self.raster_state()
        };
        let fragment_state = self.fragment_state();
        self.recorder.set_state(&DrawState {
            topology: topology::TRIANGLES,
            vertex_program: &vertex,
            fragment_program: &fragment.program,
            vertex_uniforms: Revised::from(&[][..]),
            fragment_uniforms: Revised::from(&uniforms[..]),
            raster_state: Revised::from(&raster_state),
            fragment_state: Revised::from(&fragment_state),
            textures: &textures,
            stipple: None,
            clip_distance_count: 0,
        });
        // No topology has this number: the next ordinary draw tells the recorder its state again.
        self.derived_topology = !0;
    }
}
