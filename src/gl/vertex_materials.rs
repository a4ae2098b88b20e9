//! glMaterial between Begin and End (2.14.3): the vertices of one primitive are lit with different materials.
//!
//! A draw has one block of uniforms, so such vertices are shaded here, each with the materials of its time, by the vertex
//! program that would have run. What it wrote then passes through a program that only hands it on.

use std::collections::HashMap;
use std::fmt::Write;
use std::sync::Arc;

use super::enums::*;
use super::{Context, begin_end::Immediate};
use crate::draw::assembly::{Part, PrimitiveType};
use crate::draw::recorder::Run;
use crate::program::{Interface, Output, Program, Stage};
use crate::raster::layout::ATTRIBUTES;

/// Shaded vertices of the primitive under construction.
pub(crate) struct ShadedRun {
    /// What follows the position in `data`.
    outputs: Vec<Output>,
    data: Vec<[f32; 4]>,
    edge_flags: Vec<bool>,
}

/// Programs that hand on what was shaded before, by their outputs.
pub(crate) type PassThrough = HashMap<Vec<Output>, Option<Arc<Program>>>;

fn pass_through(outputs: &[Output]) -> Option<Arc<Program>> {
    let mut text = String::from("struct VertexIn { a0: vec4<f32>");
    let count = outputs.len();
    let mut write = |args: std::fmt::Arguments| text.write_fmt(args).unwrap_or_default();
    (0..count).for_each(|k| write(format_args!(", a{}: vec4<f32>", k + 1)));
    write(format_args!(" }}\nstruct VertexOut {{ position: vec4<f32>"));
    (0..count).for_each(|k| write(format_args!(", o{k}: vec4<f32>")));
    write(format_args!(
        " }}\nfn vertex_main(in: VertexIn, base: u32) -> VertexOut {{\n    var out: VertexOut;\n    out.position = in.a0;\n"
    ));
    (0..count).for_each(|k| write(format_args!("    out.o{k} = in.a{};\n", k + 1)));
    write(format_args!("    return out;\n}}\n"));
    let interface = Interface { attributes: (1 << (count + 1)) - 1, outputs: outputs.to_vec(), ..Default::default() };
    Program::new(Stage::Vertex, text, interface).map(Arc::new).map_err(|error| log::error!(target: "tepui::program", "{error}")).ok()
}

impl Context {
    /// A material is about to change between Begin and End: the vertices so far are shaded with the old one.
    #[cold]
    pub(crate) fn shade_before_change(&mut self) {
        let mut immediate = std::mem::take(&mut self.immediate);
        if let Some(mode) = immediate.mode()
            && (self.render_mode != GL_RENDER || !self.shade_pending(mode, &mut immediate))
        {
            // Selection and feedback shade on their own: primitives that are complete keep their materials.
            self.immediate = immediate;
            return self.split_primitive();
        }
        self.immediate = immediate;
    }

    /// Shades the pending vertices; false where that is not possible.
    fn shade_pending(&mut self, mode: PrimitiveType, immediate: &mut Immediate) -> bool {
        if immediate.shaded.is_none() {
            self.validate(mode.topology());
            let Some(program) = self.recorder.vertex_program() else { return false };
            if program.outputs.len() >= ATTRIBUTES {
                return false;
            }
            let outputs = program.outputs.clone();
            immediate.shaded = Some(Box::new(ShadedRun { outputs, data: Vec::new(), edge_flags: Vec::new() }));
        }
        let run = immediate.run();
        let vertices = self.shade_on_host(mode.topology(), &run);
        let edges: Vec<bool> = (0..run.count).map(|i| run.edge_flag(i)).collect();
        if let (Some(vertices), Some(shaded)) = (vertices, &mut immediate.shaded) {
            for (vertex, edge) in edges.into_iter().enumerate() {
                let values = vertices.shaded(vertex);
                shaded.data.push(values[0]);
                shaded.data.extend(shaded.outputs.iter().map(|&output| vertices.index_of(output).map_or([0.0; 4], |k| values[k])));
                shaded.edge_flags.push(edge);
            }
        }
        immediate.keep([None; 3]);
        true
    }

    /// Draws a primitive whose vertices were, up to the pending ones, shaded before.
    pub(super) fn submit_shaded(&mut self, mode: PrimitiveType, part: Part, immediate: &mut Immediate) {
        self.shade_pending(mode, immediate);
        let Some(shaded) = immediate.shaded.take() else { return };
        let program = self.pass_through.entry(shaded.outputs.clone()).or_insert_with_key(|outputs| pass_through(outputs)).clone();
        let Some(program) = program else { return };
        if self.recorder.is_full() {
            self.flush_batch();
        }
        self.validate(mode.topology());
        self.recorder.replace_vertex_program(&program);
        let decomposition = self.decomposition(false);
        let run = Run {
            mask: (1 << (shaded.outputs.len() + 1)) - 1,
            data: &shaded.data,
            count: shaded.edge_flags.len() as u32,
            edge_flags: Some(&shaded.edge_flags),
        };
        self.recorder.draw_run(mode, part, decomposition, &run, &self.state.current.attributes);
        self.recorder.forget_state();
    }
}
