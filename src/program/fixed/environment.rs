//! Texture environments (3.8.13): from the colour so far and a texel to the next colour.

use super::slots::Slot;
use super::text::Text;

/// Base format of a texture, as tables 3.21 to 3.23 distinguish them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Base {
    Alpha,
    Luminance,
    LuminanceAlpha,
    Intensity,
    Rgb,
    #[default]
    Rgba,
}

impl Base {
    /// Red, green and blue of a texel count.
    pub fn has_color(self) -> bool {
        self != Base::Alpha
    }

    /// Alpha of a texel counts.
    pub fn has_alpha(self) -> bool {
        !matches!(self, Base::Luminance | Base::Rgb)
    }
}

/// GL_TEXTURE_ENV_MODE.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Mode {
    Replace,
    #[default]
    Modulate,
    Decal,
    Blend,
    Add,
    Combine(Combine),
}

/// GL_COMBINE_RGB or GL_COMBINE_ALPHA.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Function {
    Replace,
    #[default]
    Modulate,
    Add,
    AddSigned,
    Interpolate,
    Subtract,
    Dot3Rgb,
    Dot3Rgba,
}

/// GL_SRCn_RGB and so on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum CombineSource {
    #[default]
    Texture,
    Constant,
    PrimaryColor,
    Previous,
    /// The texel of a given unit (ARB_texture_env_crossbar).
    Unit(u8),
}

/// An argument: (source, alpha instead of colour, one minus).
pub type Argument = (CombineSource, bool, bool);

/// GL_COMBINE's parameters.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Combine {
    /// Functions of RGB and of alpha.
    pub functions: [Function; 2],
    /// Arguments of each. Those that a function does not use are equal in all keys.
    pub arguments: [[Argument; 3]; 2],
    /// Scales as shifts: 1, 2, 4.
    pub shifts: [u8; 2],
}

impl Function {
    /// Arguments used.
    pub fn arity(self) -> usize {
        match self {
            Function::Replace => 1,
            Function::Interpolate => 3,
            _ => 2,
        }
    }
}

/// Appends the statement that changes `color` by texel `texel{unit}`. `texel_of` tells if a unit has a texel.
pub(super) fn apply(t: &mut Text, unit: u8, base: Base, mode: &Mode, texel_of: impl Fn(u8) -> bool) {
    let tex = format!("texel{unit}");
    // Texels are expanded: absent alpha is 1, luminance and intensity are in all colours. What remains is which parts count.
    let (has_color, has_alpha) = (base.has_color(), base.has_alpha());
    let (rgb, alpha) = match mode {
        Mode::Replace => (
            if has_color { format!("{tex}.rgb") } else { "color.rgb".into() },
            if has_alpha { format!("{tex}.a") } else { "color.a".into() },
        ),
        Mode::Modulate => (
            if has_color { format!("color.rgb * {tex}.rgb") } else { "color.rgb".into() },
            if has_alpha { format!("color.a * {tex}.a") } else { "color.a".into() },
        ),
        // Defined for RGB and RGBA only; the others keep the colour.
        Mode::Decal => (
            match base {
                Base::Rgb => format!("{tex}.rgb"),
                Base::Rgba => format!("mix(color.rgb, {tex}.rgb, vec3<f32>({tex}.a))"),
                _ => "color.rgb".into(),
            },
            "color.a".into(),
        ),
        Mode::Blend => {
            let constant = t.slot(Slot::EnvColor(unit));
            let rgb = if has_color { format!("mix(color.rgb, {constant}.rgb, {tex}.rgb)") } else { "color.rgb".into() };
            let alpha = match base {
                Base::Intensity => format!("mix(color.a, {constant}.a, {tex}.a)"),
                _ if has_alpha => format!("color.a * {tex}.a"),
                _ => "color.a".into(),
            };
            (rgb, alpha)
        }
        Mode::Add => (
            if has_color { format!("saturate(color.rgb + {tex}.rgb)") } else { "color.rgb".into() },
            match base {
                Base::Intensity => format!("saturate(color.a + {tex}.a)"),
                _ if has_alpha => format!("color.a * {tex}.a"),
                _ => "color.a".into(),
            },
        ),
        Mode::Combine(c) => return combine(t, unit, c, texel_of),
    };
    t.line(format!("color = vec4<f32>({rgb}, {alpha});"));
}

fn combine(t: &mut Text, unit: u8, c: &Combine, texel_of: impl Fn(u8) -> bool) {
    let mut source = |s: CombineSource| match s {
        CombineSource::Texture => format!("texel{unit}"),
        CombineSource::Constant => t.slot(Slot::EnvColor(unit)),
        CombineSource::PrimaryColor => "primary".into(),
        CombineSource::Previous => "color".into(),
        CombineSource::Unit(n) if texel_of(n) => format!("texel{n}"),
        // A unit without a texture has no texel; the result is undefined, white is harmless.
        CombineSource::Unit(_) => "vec4<f32>(1.0)".into(),
    };
    let mut argument = |(s, alpha, minus): Argument, channel: usize| {
        let value = source(s);
        let part = match (channel, alpha) {
            (0, false) => format!("{value}.rgb"),
            (0, true) => format!("vec3<f32>({value}.a)"),
            _ => format!("{value}.a"),
        };
        match (minus, channel) {
            (false, _) => part,
            (true, 0) => format!("(vec3<f32>(1.0) - {part})"),
            (true, _) => format!("(1.0 - {part})"),
        }
    };
    let mut results = [String::new(), String::new()];
    for channel in 0..2 {
        let [a, b, d] = [0, 1, 2].map(|k| argument(c.arguments[channel][k], channel));
        let half = if channel == 0 { "vec3<f32>(0.5)" } else { "0.5" };
        let dot = || format!("(4.0 * dot({a} - vec3<f32>(0.5), {b} - vec3<f32>(0.5)))");
        let value = match c.functions[channel] {
            Function::Replace => a.clone(),
            Function::Modulate => format!("{a} * {b}"),
            Function::Add => format!("{a} + {b}"),
            Function::AddSigned => format!("({a} + {b}) - {half}"),
            Function::Interpolate => format!("mix({b}, {a}, {d})"),
            Function::Subtract => format!("{a} - {b}"),
            Function::Dot3Rgb | Function::Dot3Rgba if channel == 0 => format!("vec3<f32>{}", dot()),
            // Alpha has no dot product of its own.
            Function::Dot3Rgb | Function::Dot3Rgba => a.clone(),
        };
        let scale = [1.0, 2.0, 4.0][c.shifts[channel] as usize % 3];
        results[channel] = format!("saturate(({value}) * {scale:?})");
    }
    if c.functions[0] == Function::Dot3Rgba {
        t.line(format!("color = ({}).rgbr;", results[0]));
    } else {
        t.line(format!("color = vec4<f32>({}, {});", results[0], results[1]));
    }
}
