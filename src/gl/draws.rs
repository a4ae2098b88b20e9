//! From runs of vertices to the recorder: the state is derived when it changed, and selection and feedback get the assembled
//! primitives instead.

use super::enums::*;
use super::{Context, Parity};
use crate::draw::assembly::{Assembly, Decomposition, Part, PrimitiveType, QuadSplit};
use crate::draw::recorder::Run;
use crate::raster::layout::{ATTRIBUTES, Primitive};

/// Assembled primitives with their vertices, as selection and feedback see them.
pub(crate) struct Assembled<'a> {
    /// `topology::*`
    pub topology: u32,
    /// Vertex numbers count from the run's first vertex.
    pub primitives: &'a [Primitive],
    /// The vertices.
    pub run: &'a Run<'a>,
}

impl Assembled<'_> {
    /// Attribute `slot` of a vertex; `current` are the context's current values.
    #[allow(dead_code)]
    pub fn attribute(&self, slot: usize, vertex: u32, current: &[[f32; 4]; ATTRIBUTES]) -> [f32; 4] {
        self.run.attribute(slot, vertex, current)
    }
}

impl Context {
    /// Attribute slots that a draw of this topology would read now.
    pub(crate) fn wanted_attributes(&mut self, topology: u32) -> u32 {
        if self.render_mode != GL_RENDER {
            return !0;
        }
        self.validate(topology);
        self.recorder.vertex_program().map_or(1, |program| program.attributes | 1)
    }

    /// Draws a run of vertices, or hands it to selection or feedback. `indexed`: from DrawElements or a display list.
    pub(crate) fn submit_run(&mut self, mode: PrimitiveType, part: Part, run: &Run, indexed: bool) {
        if !self.can_draw("drawing") {
            return;
        }
        let decomposition = self.decomposition(indexed);
        if self.render_mode != GL_RENDER {
            let mut primitives = Vec::new();
            Assembly { mode, part, decomposition, draw: 0 }.run(run.count, |i| i, |i| run.edge_flag(i), &mut primitives);
            let assembled = Assembled { topology: mode.topology(), primitives: &primitives, run };
            return self.select_or_feedback(&assembled);
        }
        if self.recorder.is_full() {
            self.flush_batch();
        }
        self.validate(mode.topology());
        self.recorder.draw_run(mode, part, decomposition, run, &self.state.current.attributes);
    }

    /// How polygons are cut into triangles: Mesa's choice, where it depends on the state.
    pub(crate) fn decomposition(&self, indexed: bool) -> Decomposition {
        let polygon = &self.state.polygon;
        let quads = if polygon.stipple || polygon.mode != [GL_FILL; 2] {
            QuadSplit::Decomposed
        } else if indexed || self.state.lighting.shade_model == GL_FLAT {
            QuadSplit::Diagonal13
        } else {
            QuadSplit::Diagonal02
        };
        Decomposition { quads, flagged_strips: self.config.parity == Parity::Osmesa }
    }

    /// Derives what the draws see and tells the recorder, if anything changed.
    #[inline]
    pub(crate) fn validate(&mut self, topology: u32) {
        if self.dirty == 0 && self.recorder.has_state() && self.derived_topology == topology {
            return;
        }
        self.derive_state(topology);
    }
}
