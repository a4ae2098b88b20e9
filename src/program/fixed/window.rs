//! Vertex programs of window-space rectangles (pixel rectangles, bitmaps): attributes pass through.

use std::collections::HashMap;
use std::fmt::Write;
use std::sync::{Arc, LazyLock, Mutex};

use super::text::Text;
use crate::program::{Interface, Output, Program, Stage};

/// The attribute slot of the coordinates of [`Source::Image`](super::Source::Image).
pub const IMAGE_COORDINATES: u8 = 1;

/// The attribute slot that holds an output's value; None for outputs that rectangles do not have.
fn attribute(output: Output) -> Option<u8> {
    match output {
        Output::FrontColor | Output::BackColor => Some(3),
        Output::FrontSecondary | Output::BackSecondary => Some(4),
        Output::Fog => Some(5),
        Output::TexCoord(unit) => Some(8 + unit),
        Output::Generic(0) => Some(IMAGE_COORDINATES),
        _ => None,
    }
}

/// A vertex program whose position is attribute 0 as it is (raster space), and whose outputs are the attributes of the same
/// meaning. `outputs` must be sorted, so that equal sets are one program.
pub fn window_program(outputs: &[Output]) -> Arc<Program> {
    static CACHE: LazyLock<Mutex<HashMap<Vec<Output>, Arc<Program>>>> = LazyLock::new(Default::default);
    let mut map = CACHE.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
    map.entry(outputs.to_vec()).or_insert_with(|| Arc::new(generate(outputs))).clone()
}

fn generate(outputs: &[Output]) -> Program {
    let mut attributes = 1u32;
    let mut body = String::from("    out.position = in.a0;\n");
    for (k, &output) in outputs.iter().enumerate() {
        let value = match attribute(output) {
            Some(slot) => {
                attributes |= 1 << slot;
                format!("in.a{slot}")
            }
            None => "vec4<f32>(0.0, 0.0, 0.0, 1.0)".into(),
        };
        let _ = writeln!(body, "    out.o{k} = {value};");
    }
    let inputs = (0..16).filter(|a| attributes & 1 << a != 0).map(|a| format!("a{a}: vec4<f32>"));
    let members = std::iter::once("position: vec4<f32>".into()).chain((0..outputs.len()).map(|k| format!("o{k}: vec4<f32>")));
    let wgsl = format!(
        "{}{}fn vertex_main(in: VertexIn, base: u32) -> VertexOut {{\n    var out: VertexOut;\n{body}    return out;\n}}\n",
        Text::structure("VertexIn", inputs),
        Text::structure("VertexOut", members),
    );
    let interface = Interface { attributes, outputs: outputs.to_vec(), ..Interface::default() };
    match Program::new(Stage::Vertex, wgsl, interface) {
        Ok(program) => program,
        Err(e) => unreachable!("a generated vertex program does not validate: {e}"),
    }
}
