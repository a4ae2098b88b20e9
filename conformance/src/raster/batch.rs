//! A benchmark scene as a batch, as the recorder would make it of one glDrawElements a draw.

use std::sync::Arc;

use tepui::draw::{Batch, Clear, Draw, Step};
use tepui::program::{Input, Interface, Output, Program, Shortcut, Stage, Varying};
use tepui::raster::layout::*;

use super::scenes::{Change, Mode, Scene};

/// Words of a vertex: position and colour.
const VERTEX_WORDS: u32 = 8;

fn vertex_program() -> Result<Arc<Program>, String> {
    let text = "struct VertexIn { a0: vec4<f32>, a3: vec4<f32> }
struct VertexOut { position: vec4<f32>, o0: vec4<f32> }
fn vertex_main(in: VertexIn, base: u32) -> VertexOut { return VertexOut(in.a0, in.a3); }";
    let interface = Interface { attributes: 1 | 1 << 3, outputs: vec![Output::FrontColor], ..Interface::default() };
    Program::new(Stage::Vertex, text.into(), interface).map(Arc::new)
}

/// The colour, times a tint where draws have one.
fn fragment_program(tinted: bool, interpolation: u32) -> Result<Arc<Program>, String> {
    let text = format!(
        "struct FragmentIn {{ i0: vec4<f32> }}
struct FragmentOut {{ color: vec4<f32> }}
fn fragment_main(in: FragmentIn, base: u32) -> FragmentOut {{ return FragmentOut(in.i0{}); }}",
        if tinted { " * uniforms[base]" } else { "" }
    );
    let color = Varying { front: Output::FrontColor, back: Output::FrontColor, interpolation };
    // As the generator says it of the same program: the CPU executor then has a routine of its own.
    let shortcut = if tinted { Shortcut::None } else { Shortcut::Varying(0) };
    let interface = Interface { inputs: vec![Input::Varying(0)], varyings: vec![color], uniform_vec4: 1, shortcut, ..Interface::default() };
    Program::new(Stage::Fragment, text, interface).map(Arc::new)
}

/// The batch of a scene: a clear, then its draws, each with its tint.
pub fn batch(scene: &Scene) -> Result<Batch, String> {
    let size = scene.size;
    let tinted = scene.change == Change::Tint;
    let smooth = if scene.flat { interpolation::FLAT } else { interpolation::PERSPECTIVE };
    let (vertex_program, fragment_program) = (vertex_program()?, fragment_program(tinted, smooth)?);
    let mut batch = Batch::default();
    for (position, color) in scene.positions.iter().zip(&scene.colors) {
        batch.vertices.extend_from_slice(position);
        batch.vertices.extend(color.to_le_bytes().map(|c| c as f32 / 255.0));
    }
    let half = size.map(|s| s as f32 * 0.5);
    let cull = if scene.cull { raster_flags::CULL_BACK } else { 0 };
    batch.raster_states.push(RasterState {
        flags: raster_flags::FRONT_CCW | cull,
        polygon_mode: [topology::TRIANGLES; 2],
        viewport_scale: [half[0], -half[1], 0.5],
        viewport_translate: [half[0], half[1], 0.5],
        scissor_max: size.map(|s| s as i32),
        line_width: 1.0,
        point_size: 1.0,
        depth_range: [0.0, 1.0],
        polygon_stipple: NONE,
        ..bytemuck::Zeroable::zeroed()
    });
    let depth = if scene.mode.depth() { fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE } else { 0 };
    let blend = if scene.mode == Mode::Blend { fragment_flags::BLEND } else { 0 };
    let (s, d) = (blend_factor::SRC_ALPHA, blend_factor::ONE_MINUS_SRC_ALPHA);
    for flags in [depth | blend, depth | (blend ^ fragment_flags::BLEND)] {
        batch.fragment_states.push(FragmentState {
            flags,
            depth_func: compare::LESS,
            blend_factors: [s, d, s, d],
            color_mask: if scene.mode == Mode::DepthOnly { 0 } else { 15 },
            ..bytemuck::Zeroable::zeroed()
        });
    }
    batch.steps.push(Step::Clear(Clear {
        min: [0; 2],
        max: size.map(|s| s as i32),
        color: [0.0; 4],
        color_mask: 15,
        depth: scene.mode.depth().then_some(1.0),
        stencil: None,
    }));
    let each = scene.triangles() / scene.draws;
    for k in 0..scene.draws {
        let tint = if tinted { 1.0 - (k & 7) as f32 / 16.0 } else { 1.0 };
        batch.uniforms.push([tint, tint, tint, 1.0]);
        let indices = &scene.indices[(k * each * 3) as usize..((k + 1) * each * 3) as usize];
        let first = indices.iter().min().copied().unwrap_or(0);
        let count = indices.iter().max().map_or(0, |last| last + 1 - first);
        let mut record: DrawRecord = bytemuck::Zeroable::zeroed();
        record.vertex_word = first * VERTEX_WORDS;
        record.vertex_stride = VERTEX_WORDS;
        record.vertex_count = count;
        record.topology = topology::TRIANGLES;
        record.attribute_offset = [NONE; ATTRIBUTES];
        for (slot, offset) in [(0, 0), (3, 4)] {
            (record.attribute_offset[slot], record.attribute_size[slot]) = (offset, 4);
        }
        record.fragment_uniforms = k;
        record.fragment_state = if scene.change == Change::Blend { k & 1 } else { 0 };
        record.shaded_base = batch.shaded_vec4;
        record.shaded_stride = 2;
        (record.clip_distances, record.point_size) = (NONE, NONE);
        record.varying_count = 1;
        record.varyings[0] = 1 | 1 << 8 | smooth << 16;
        batch.shaded_vec4 += 2 * count;
        let first_primitive = batch.primitives.len() as u32;
        let flags = k | PRIM_EDGE_01 | PRIM_EDGE_12 | PRIM_EDGE_20;
        batch
            .primitives
            .extend(indices.chunks(3).map(|i| Primitive { v: [i[0] - first, i[1] - first, i[2] - first], draw_and_flags: flags }));
        batch.draws.push(Draw {
            record,
            first_primitive,
            vertex_program: vertex_program.clone(),
            fragment_program: fragment_program.clone(),
        });
    }
    batch.steps.push(Step::Primitives { first: 0, end: batch.primitives.len() as u32 });
    Ok(batch)
}
