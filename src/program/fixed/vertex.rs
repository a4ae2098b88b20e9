//! Vertex programs: position, colours, texture coordinates, fog coordinate, clip distances and point size (2.11 to 2.14).

use std::sync::Arc;

use super::FixedProgram;
use super::slots::Slot;
use super::text::Text;
use crate::program::{Interface, Output, Program, Stage};

/// Where the fog coordinate comes from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum FogCoord {
    /// Not wanted.
    #[default]
    None,
    /// Distance of the eye plane, |z|.
    EyeZ,
    /// The fog coordinate attribute.
    Attribute,
}

/// What a vertex program does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct VertexKey {
    /// Writes the front colour.
    pub color: bool,
    /// Writes the secondary colour.
    pub secondary: bool,
    /// Fog coordinate.
    pub fog: FogCoord,
    /// User clip distances.
    pub clip_planes: u8,
    /// Distance attenuation of the point size.
    pub point_attenuation: bool,
}

/// Writes the program of a key.
pub(super) fn generate(key: &VertexKey) -> FixedProgram {
    let mut t = Text::default();
    let mut attributes = 1;
    let mut outputs = Vec::new();
    let position = t.transform(Slot::Mvp, "in.a0");
    t.line(format!("out.position = {position};"));
    if key.clip_planes > 0 || key.point_attenuation || key.fog == FogCoord::EyeZ {
        let eye = t.transform(Slot::ModelView, "in.a0");
        t.line(format!("let eye = {eye};"));
    }
    if key.color {
        attributes |= 1 << 3;
        write(&mut t, &mut outputs, Output::FrontColor, "saturate(in.a3)");
    }
    if key.secondary {
        attributes |= 1 << 4;
        write(&mut t, &mut outputs, Output::FrontSecondary, "saturate(in.a4)");
    }
    match key.fog {
        FogCoord::None => {}
        FogCoord::EyeZ => write(&mut t, &mut outputs, Output::Fog, "vec4<f32>(abs(eye.z), 0.0, 0.0, 1.0)"),
        FogCoord::Attribute => {
            attributes |= 1 << 5;
            write(&mut t, &mut outputs, Output::Fog, "vec4<f32>(in.a5.x, 0.0, 0.0, 1.0)");
        }
    }
    for group in 0..key.clip_planes.div_ceil(4) {
        let distances: Vec<String> = (group * 4..group * 4 + 4)
            .map(|i| if i < key.clip_planes { format!("dot({}, eye)", t.slot(Slot::ClipPlane(i))) } else { "0.0".into() })
            .collect();
        write(&mut t, &mut outputs, Output::ClipDistance(group), &format!("vec4<f32>({})", distances.join(", ")));
    }
    if key.point_attenuation {
        let (size, factors) = (t.slot(Slot::PointSize), t.slot(Slot::PointAttenuation));
        t.line("let distance = length(eye.xyz);");
        t.line(format!("let attenuation = ({factors}.x + {factors}.y * distance) + {factors}.z * (distance * distance);"));
        let value = format!("vec4<f32>(clamp({size}.x * inverseSqrt(attenuation), {size}.y, {size}.z), 0.0, 0.0, 1.0)");
        write(&mut t, &mut outputs, Output::PointSize, &value);
    }
    finish(t, attributes, outputs)
}

/// Assigns an output.
fn write(t: &mut Text, outputs: &mut Vec<Output>, output: Output, value: &str) {
    t.line(format!("out.o{} = {value};", outputs.len()));
    outputs.push(output);
}

fn finish(t: Text, attributes: u32, outputs: Vec<Output>) -> FixedProgram {
    let inputs = (0..16).filter(|a| attributes & 1 << a != 0).map(|a| format!("a{a}: vec4<f32>"));
    let members = std::iter::once("position: vec4<f32>".into()).chain((0..outputs.len()).map(|k| format!("o{k}: vec4<f32>")));
    let wgsl = format!(
        "{}{}fn vertex_main(in: VertexIn, base: u32) -> VertexOut {{\n    var out: VertexOut;\n{}    return out;\n}}\n",
        Text::structure("VertexIn", inputs),
        Text::structure("VertexOut", members),
        t.body,
    );
    let interface = Interface { attributes, outputs, uniform_vec4: t.slots.len() as u32, ..Interface::default() };
    let program = match Program::new(Stage::Vertex, wgsl, interface) {
        Ok(program) => program,
        Err(e) => unreachable!("a generated vertex program does not validate: {e}"),
    };
    FixedProgram { program: Arc::new(program), slots: t.slots }
}
