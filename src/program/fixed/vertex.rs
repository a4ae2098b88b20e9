//! Vertex programs: position, colours, texture coordinates, fog coordinate, clip distances and point size (2.11 to 2.14).

use std::sync::Arc;

use super::FixedProgram;
use super::lighting::{self, LightingKey};
use super::slots::Slot;
use super::texgen::{self, TexCoordKey};
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

/// What happens to the transformed normal, where it is needed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Normal {
    #[default]
    Keep,
    Rescale,
    Normalize,
}

/// What a vertex program does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct VertexKey {
    /// Writes the primary colours.
    pub color: bool,
    /// Writes the secondary colours.
    pub secondary: bool,
    /// Lighting.
    pub lighting: LightingKey,
    /// What happens to the transformed normal.
    pub normal: Normal,
    /// Texture coordinates by unit.
    pub units: [TexCoordKey; 8],
    /// Fog coordinate.
    pub fog: FogCoord,
    /// Writes the eye coordinates.
    pub eye: bool,
    /// User clip distances.
    pub clip_planes: u8,
    /// Those take clip coordinates instead of eye coordinates.
    pub planes_in_clip_space: bool,
    /// Distance attenuation of the point size.
    pub point_attenuation: bool,
    /// Its distance is that along z, instead of that from the eye.
    pub point_distance_along_z: bool,
}

/// Writes the program of a key.
pub(super) fn generate(key: &VertexKey) -> FixedProgram {
    let mut t = Text::default();
    let mut attributes = 1;
    let mut outputs = Vec::new();
    let position = t.transform(Slot::Mvp, "in.a0");
    t.line(format!("out.position = {position};"));
    let lit = key.lighting.enabled && (key.color || key.secondary);
    let generates = |needs: fn(&TexCoordKey) -> bool| key.units.iter().any(needs);
    let eye = key.clip_planes > 0 && !key.planes_in_clip_space
        || key.point_attenuation
        || key.fog == FogCoord::EyeZ
        || lit && key.lighting.needs_eye()
        || generates(TexCoordKey::needs_eye)
        || key.eye;
    if eye {
        let eye = t.transform(Slot::ModelView, "in.a0");
        t.line(format!("let eye = {eye};"));
    }
    if lit || generates(TexCoordKey::needs_normal) {
        attributes |= 1 << 2;
        let [x, y, z] = [0, 1, 2].map(|r| t.slot(Slot::NormalRow(r)));
        let normal = format!("({x}.xyz * in.a2.x + {y}.xyz * in.a2.y) + {z}.xyz * in.a2.z");
        t.line(match key.normal {
            Normal::Keep => format!("let normal = {normal};"),
            Normal::Rescale => format!("let normal = ({normal}) * {x}.w;"),
            Normal::Normalize => format!("let normal = unit({normal});"),
        });
    }
    if lit {
        lighting::generate(&mut t, &key.lighting);
        if key.lighting.color_material != [0; 2] {
            attributes |= 1 << 3;
        }
        if key.color {
            write(&mut t, &mut outputs, Output::FrontColor, "front_color");
            if key.lighting.two_side {
                write(&mut t, &mut outputs, Output::BackColor, "back_color");
            }
        }
        if key.secondary {
            write(&mut t, &mut outputs, Output::FrontSecondary, "front_specular");
            if key.lighting.two_side {
                write(&mut t, &mut outputs, Output::BackSecondary, "back_specular");
            }
        }
    } else {
        if key.color {
            attributes |= 1 << 3;
            write(&mut t, &mut outputs, Output::FrontColor, "saturate(in.a3)");
        }
        if key.secondary {
            attributes |= 1 << 4;
            write(&mut t, &mut outputs, Output::FrontSecondary, "saturate(in.a4)");
        }
    }
    texgen::shared(&mut t, &key.units);
    for (unit, coord) in key.units.iter().enumerate().filter(|(_, c)| c.used) {
        if coord.needs_attribute() {
            attributes |= 1 << (8 + unit);
        }
        let value = texgen::coordinates(&mut t, unit as u8, coord);
        write(&mut t, &mut outputs, Output::TexCoord(unit as u8), &value);
    }
    if key.eye {
        write(&mut t, &mut outputs, Output::Eye, "eye");
    }
    match key.fog {
        FogCoord::None => {}
        FogCoord::EyeZ => write(&mut t, &mut outputs, Output::Fog, "vec4<f32>(abs(eye.z), 0.0, 0.0, 1.0)"),
        FogCoord::Attribute => {
            attributes |= 1 << 5;
            write(&mut t, &mut outputs, Output::Fog, "vec4<f32>(in.a5.x, 0.0, 0.0, 1.0)");
        }
    }
    let place = if key.planes_in_clip_space { "out.position" } else { "eye" };
    for group in 0..key.clip_planes.div_ceil(4) {
        let mut distances = Vec::new();
        for i in group * 4..group * 4 + 4 {
            if i >= key.clip_planes {
                distances.push("0.0".into());
                continue;
            }
            // Where a plane cuts decides between pixels: its terms are rounded as on the CPU.
            let plane = t.slot(Slot::ClipPlane(i));
            t.line(format!("let terms{i} = products({plane}, {place});"));
            distances.push(format!("((terms{i}.x + terms{i}.y) + terms{i}.z) + terms{i}.w"));
        }
        write(&mut t, &mut outputs, Output::ClipDistance(group), &format!("vec4<f32>({})", distances.join(", ")));
    }
    if key.point_attenuation {
        let (size, factors) = (t.slot(Slot::PointSize), t.slot(Slot::PointAttenuation));
        t.line(if key.point_distance_along_z { "let distance = abs(eye.z);" } else { "let distance = length(eye.xyz);" });
        t.line(format!("let attenuation = ({factors}.x + {factors}.y * distance) + {factors}.z * (distance * distance);"));
        let value = format!("vec4<f32>(clamp({size}.x * inverse_root(attenuation), {size}.y, {size}.z), 0.0, 0.0, 1.0)");
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
