//! A stand-in for the derived state: position and colour only. room: program replaces this with `derived.rs`.

use std::sync::{Arc, OnceLock};

use super::{Context, matrix};
use crate::draw::recorder::DrawState;
use crate::program::{Input, Interface, Output, Program, Shortcut, Stage, Varying};
use crate::raster::layout::*;

fn programs() -> &'static (Arc<Program>, Arc<Program>) {
    static PROGRAMS: OnceLock<(Arc<Program>, Arc<Program>)> = OnceLock::new();
    PROGRAMS.get_or_init(|| {
        let vertex = "struct VertexIn { a0: vec4<f32>, a3: vec4<f32> }
struct VertexOut { position: vec4<f32>, o0: vec4<f32> }
fn vertex_main(in: VertexIn, base: u32) -> VertexOut {
    var out: VertexOut;
    let p = in.a0;
    out.position = uniforms[base] * p.x + uniforms[base + 1u] * p.y + uniforms[base + 2u] * p.z + uniforms[base + 3u] * p.w;
    out.o0 = clamp(in.a3, vec4<f32>(0.0), vec4<f32>(1.0));
    return out;
}";
        let fragment = "struct FragmentIn { i0: vec4<f32> }
struct FragmentOut { color: vec4<f32> }
fn fragment_main(in: FragmentIn, base: u32) -> FragmentOut {
    var out: FragmentOut;
    out.color = in.i0;
    return out;
}";
        let varying = Varying { front: Output::FrontColor, back: Output::FrontColor, interpolation: interpolation::PERSPECTIVE };
        let v = Interface { attributes: 1 | 1 << 3, outputs: vec![Output::FrontColor], uniform_vec4: 4, ..Default::default() };
        let f =
            Interface { inputs: vec![Input::Varying(0)], varyings: vec![varying], shortcut: Shortcut::Varying(0), ..Default::default() };
        let make = |stage, text: &str, interface| Arc::new(Program::new(stage, text.into(), interface).expect("the stand-in program"));
        (make(Stage::Vertex, vertex, v), make(Stage::Fragment, fragment, f))
    })
}

impl Context {
    pub(crate) fn derive_state(&mut self, topology: u32) {
        let (vertex_program, fragment_program) = programs();
        let mvp = matrix::multiply(self.projection.top(), self.modelview.top());
        let (raster_state, fragment_state) = (self.raster_state(), self.fragment_state());
        self.recorder.set_state(&DrawState {
            topology,
            vertex_program,
            fragment_program,
            vertex_uniforms: &mvp.to_cols_array_2d(),
            fragment_uniforms: &[],
            raster_state,
            fragment_state,
            textures: &[],
            stipple: None,
            clip_distance_count: 0,
        });
        self.derived_topology = topology;
        self.dirty = 0;
    }
}
