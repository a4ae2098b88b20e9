//! Fragment programs: texturing, colour sum, fog (3.8 to 3.10), and the sources of pixel rectangles and bitmaps.

use std::sync::Arc;

use super::FixedProgram;
use super::environment::{self, Base, Mode};
use super::slots::Slot;
use super::text::Text;
use crate::program::{Input, Interface, Modulate, Output, Program, Shortcut, Stage, Varying};
use crate::raster::layout::interpolation;

/// Fog equation.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Fog {
    #[default]
    None,
    Linear,
    Exp,
    Exp2,
}

/// Antialiasing: what the coverage varying means (3.3.1, 3.4.2).
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Smooth {
    #[default]
    None,
    Point,
    /// A point of OSMesa's: the pixels whose centres lie within the radius, which is one pixel at least, are covered wholly.
    Disc,
    Line,
}

/// Where a fragment's colour starts from.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Source {
    /// The primary colour.
    #[default]
    Color,
    /// A texel of the image in the texture slot after those of the units, at the coordinates in `Output::Generic(0)`.
    Image,
}

/// What a texture unit does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct UnitKey {
    /// It has a texture.
    pub enabled: bool,
    /// A cube map: the coordinates are a direction and not projected.
    pub cube: bool,
    /// The sampler wants a level of detail.
    pub lod: bool,
    /// Base format of the texture.
    pub base: Base,
    /// Environment.
    pub mode: Mode,
}

/// What a fragment program does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct FragmentKey {
    /// Where the colour comes from.
    pub source: Source,
    /// Flat shading.
    pub flat: bool,
    /// Back faces have colours of their own.
    pub two_side: bool,
    /// The secondary colour is added.
    pub color_sum: bool,
    /// Fog.
    pub fog: Fog,
    /// Antialiased points or lines.
    pub smooth: Smooth,
    /// Texture units. The enabled ones take texture slots in their order.
    pub units: [UnitKey; 8],
}

/// A fragment program under construction.
struct Build {
    t: Text,
    inputs: Vec<Input>,
    varyings: Vec<Varying>,
    key: FragmentKey,
}

impl Build {
    /// The expression of a varying.
    fn varying(&mut self, output: Output) -> String {
        let k = self.varying_index(output);
        self.input(Input::Varying(k))
    }

    fn varying_index(&mut self, output: Output) -> u8 {
        if let Some(k) = self.varyings.iter().position(|v| v.front == output) {
            return k as u8;
        }
        let back = match output {
            Output::FrontColor if self.key.two_side => Output::BackColor,
            Output::FrontSecondary if self.key.two_side => Output::BackSecondary,
            other => other,
        };
        let flat = self.key.flat && matches!(output, Output::FrontColor | Output::FrontSecondary);
        let interpolation = match output {
            Output::Coverage => interpolation::COVERAGE,
            _ if flat => interpolation::FLAT,
            _ => interpolation::PERSPECTIVE,
        };
        self.varyings.push(Varying { front: output, back, interpolation });
        self.varyings.len() as u8 - 1
    }

    fn input(&mut self, input: Input) -> String {
        let k = self.inputs.iter().position(|i| *i == input).unwrap_or_else(|| {
            self.inputs.push(input);
            self.inputs.len() - 1
        });
        format!("in.i{k}")
    }
}

/// Writes the program of a key.
pub(super) fn generate(key: &FragmentKey) -> FixedProgram {
    let mut b = Build { t: Text::default(), inputs: Vec::new(), varyings: Vec::new(), key: *key };
    texels(&mut b);
    if key.source == Source::Image {
        let slot = key.units.iter().filter(|u| u.enabled).count();
        let at = b.varying(Output::Generic(0));
        let zero = "vec4<f32>(0.0)";
        b.t.line(format!("let primary = texture_sample({slot}u, vec4<f32>({at}.xy, 0.0, 0.0), {zero}, {zero});"));
        b.t.line("var color = primary;");
    } else if reads_primary(key) {
        let color = b.varying(Output::FrontColor);
        b.t.line(format!("let primary = {color};"));
        b.t.line("var color = primary;");
    } else {
        b.t.line("var color: vec4<f32>;");
    }
    for (unit, u) in key.units.iter().enumerate().filter(|(_, u)| u.enabled) {
        environment::apply(&mut b.t, unit as u8, u.base, &u.mode, |n| key.units.get(n as usize).is_some_and(|u| u.enabled));
    }
    if key.color_sum {
        let secondary = b.varying(Output::FrontSecondary);
        b.t.line(format!("color = vec4<f32>(saturate(color.rgb + {secondary}.rgb), color.a);"));
    }
    fog(&mut b);
    smooth(&mut b);
    b.t.line("out.color = color;");
    finish(b)
}

/// False where the first texture replaces the primary colour and nothing asks for it later.
fn reads_primary(key: &FragmentKey) -> bool {
    let mut enabled = key.units.iter().filter(|u| u.enabled);
    let replaced = enabled.next().is_some_and(|u| u.mode == Mode::Replace && !matches!(u.base, Base::Alpha | Base::Luminance | Base::Rgb));
    !replaced || enabled.any(|u| matches!(u.mode, Mode::Combine(_)))
}

/// Samples the texture of every unit: `texel0` and so on.
fn texels(b: &mut Build) {
    let units = b.key.units;
    for (slot, (unit, key)) in units.iter().enumerate().filter(|(_, u)| u.enabled).enumerate() {
        let k = b.varying_index(Output::TexCoord(unit as u8));
        let project = |c: &str| if key.cube { format!("{c}.xyz") } else { format!("({c}.xyz / {c}.w)") };
        let coord = project(&b.input(Input::Varying(k)));
        let mut gradients = ["vec4<f32>(0.0)".to_string(), "vec4<f32>(0.0)".to_string()];
        if key.lod {
            let [origin, right, down] = [0, 1, 2].map(|p| project(&b.input(Input::Quad(k, p))));
            b.t.line(format!("let origin{unit} = {origin};"));
            gradients = [right, down].map(|p| format!("vec4<f32>({p} - origin{unit}, 0.0)"));
        }
        let [ddx, ddy] = gradients;
        b.t.line(format!("let texel{unit} = texture_sample({slot}u, vec4<f32>({coord}, 0.0), {ddx}, {ddy});"));
    }
}

/// Fog (3.10): C = f C_r + (1 - f) C_f.
fn fog(b: &mut Build) {
    if b.key.fog == Fog::None {
        return;
    }
    let c = format!("{}.x", b.varying(Output::Fog));
    let (p, color) = (b.t.slot(Slot::FogParameters), b.t.slot(Slot::FogColor));
    let factor = match b.key.fog {
        Fog::Linear => format!("{c} * {p}.x + {p}.y"),
        Fog::Exp => format!("exp2({c} * {p}.x)"),
        _ => format!("exp2(-(({c} * {p}.x) * ({c} * {p}.x)))"),
    };
    b.t.line(format!("let fog = saturate({factor});"));
    b.t.line(format!("color = vec4<f32>(mix({color}.rgb, color.rgb, vec3<f32>(fog)), color.a);"));
}

/// Antialiasing: alpha times the part of the pixel that is covered. A line covers a pixel as a box filter sees it.
fn smooth(b: &mut Build) {
    if b.key.smooth == Smooth::None {
        return;
    }
    let c = b.varying(Output::Coverage);
    match b.key.smooth {
        Smooth::Point => b.t.line(format!("let coverage = saturate({c}.y - sqrt({c}.x * {c}.x + {c}.z * {c}.z));")),
        Smooth::Disc => {
            b.t.line(format!("let radius = max({c}.y - 0.5, 1.0);"));
            b.t.line(format!("let coverage = select(0.0, 1.0, {c}.x * {c}.x + {c}.z * {c}.z <= radius * radius);"));
        }
        _ => b.t.line(format!("let coverage = saturate({c}.y - abs({c}.x)) * saturate({c}.w - abs({c}.z));")),
    }
    b.t.line("color.a = color.a * coverage;");
}

/// What may be done instead of running the program.
fn shortcut(key: &FragmentKey) -> Shortcut {
    if key.source != Source::Color || key.color_sum || key.fog != Fog::None || key.smooth != Smooth::None {
        return Shortcut::None;
    }
    let mut enabled = key.units.iter().filter(|u| u.enabled);
    match (enabled.next(), enabled.next()) {
        (None, _) => Shortcut::Varying(0),
        (Some(unit), None) if unit.mode == Mode::Modulate && !unit.cube => {
            Shortcut::Modulate(Modulate { lod: unit.lod, parts: [unit.base.has_color(), unit.base.has_alpha()] })
        }
        _ => Shortcut::None,
    }
}

fn finish(b: Build) -> FixedProgram {
    let inputs = (0..b.inputs.len()).map(|k| format!("i{k}: vec4<f32>"));
    let textures = b.key.units.iter().filter(|u| u.enabled).count() as u32;
    let shortcut = shortcut(&b.key);
    let wgsl = format!(
        "{}{}fn fragment_main(in: FragmentIn, base: u32) -> FragmentOut {{\n    var out: FragmentOut;\n{}    return out;\n}}\n",
        Text::structure("FragmentIn", inputs),
        Text::structure("FragmentOut", ["color: vec4<f32>".to_string()]),
        b.t.body,
    );
    let interface = Interface {
        inputs: b.inputs,
        varyings: b.varyings,
        uniform_vec4: b.t.slots.len() as u32,
        texture_slots: textures + (b.key.source == Source::Image) as u32,
        shortcut,
        ..Interface::default()
    };
    let program = match Program::new(Stage::Fragment, wgsl, interface) {
        Ok(program) => program,
        Err(e) => unreachable!("a generated fragment program does not validate: {e}"),
    };
    FixedProgram { program: Arc::new(program), slots: b.t.slots }
}
