//! Vertices shaded on the host, for what needs their results at once: the raster position, selection, feedback. The same
//! vertex program runs as for drawing; a recorder of its own takes the derived state.

use super::Context;
use crate::draw::assembly::{Decomposition, Part, PrimitiveType};
use crate::draw::recorder::{Recorder, Run};
use crate::program::Output;
use crate::raster::layout::{DrawRecord, RasterState};
use crate::raster::simd::Level;
use crate::raster::vertex::{BLOCK, ScreenVertex, VertexWorker};

/// What shading on the host needs between runs.
pub(crate) struct HostShader {
    recorder: Recorder,
    worker: VertexWorker,
}

impl Default for HostShader {
    fn default() -> HostShader {
        HostShader { recorder: Recorder::new(), worker: VertexWorker::default() }
    }
}

/// Shaded vertices.
pub(crate) struct HostVertices {
    /// Where things are in a shaded vertex.
    pub record: DrawRecord,
    /// Viewport, culling.
    pub raster_state: RasterState,
    outputs: Vec<Output>,
    shaded: Vec<[f32; 4]>,
    /// Codes and raster-space positions.
    pub screen: Vec<ScreenVertex>,
}

impl HostVertices {
    /// Clip position and outputs of a vertex.
    pub fn shaded(&self, vertex: usize) -> &[[f32; 4]] {
        let stride = self.record.shaded_stride as usize;
        &self.shaded[vertex * stride..][..stride]
    }

    /// Where an output is in a shaded vertex, if the program writes it.
    pub fn index_of(&self, output: Output) -> Option<usize> {
        self.outputs.iter().position(|&o| o == output).map(|k| k + 1)
    }
}

impl Context {
    /// Runs the vertex program that drawing with this topology would run. `None` where nothing would be drawn.
    pub(crate) fn shade_on_host(&mut self, topology: u32, run: &Run) -> Option<HostVertices> {
        if run.count == 0 {
            return None;
        }
        let mut host = self.host_shader.take().unwrap_or_default();
        let dirty = self.dirty;
        // What the host's recorder was told last may be out of date.
        let derived_topology = std::mem::replace(&mut self.derived_topology, !0);
        std::mem::swap(&mut self.recorder, &mut host.recorder);
        self.shading_on_host = true;
        self.validate(topology);
        self.shading_on_host = false;
        self.recorder.draw_run(PrimitiveType::Points, Part::default(), Decomposition::default(), run, &self.state.current.attributes);
        let batch = self.recorder.take();
        std::mem::swap(&mut self.recorder, &mut host.recorder);
        // What was derived belongs to the other recorder.
        self.dirty |= dirty;
        self.derived_topology = derived_topology;
        let vertices = batch.and_then(|batch| {
            let draw = batch.draws.first()?;
            let (stride, count) = (draw.record.shaded_stride as usize, run.count as usize);
            let mut shaded = vec![[0.0; 4]; stride * count];
            let mut screen = vec![ScreenVertex::default(); count];
            for first in (0..count).step_by(BLOCK) {
                let end = count.min(first + BLOCK);
                host.worker.run(&batch, draw, first, &mut shaded[first * stride..end * stride], &mut screen[first..end], Level::best());
            }
            let raster_state = *batch.raster_states.get(draw.record.raster_state as usize)?;
            Some(HostVertices { record: draw.record, raster_state, outputs: draw.vertex_program.outputs.clone(), shaded, screen })
        });
        self.host_shader = Some(host);
        vertices
    }

    /// Window coordinates (y up) of a clip position: x, y, z.
    pub(crate) fn to_window(&self, clip: [f32; 4]) -> [f32; 3] {
        let viewport = &self.state.viewport;
        let [x, y, z] = [0, 1, 2].map(|k| clip[k] / clip[3]);
        let (half_width, half_height) = (viewport.width as f32 * 0.5, viewport.height as f32 * 0.5);
        let (near, far) = (viewport.near as f32, viewport.far as f32);
        [
            x * half_width + (viewport.x as f32 + half_width),
            y * half_height + (viewport.y as f32 + half_height),
            z * ((far - near) * 0.5) + (far + near) * 0.5,
        ]
    }
}
