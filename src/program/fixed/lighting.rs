//! Lighting (2.14.1 to 2.14.3): only the lights, terms and faces of the key.

use super::slots::Slot;
use super::text::Text;

/// Bits of an enabled light in [`LightingKey::lights`].
#[allow(missing_docs)]
pub mod light {
    pub const ENABLED: u8 = 1;
    /// At a point, not at infinity.
    pub const POSITIONAL: u8 = 2;
    /// Attenuation is not (1, 0, 0); positional lights only.
    pub const ATTENUATED: u8 = 4;
    /// Spot cutoff is not 180.
    pub const SPOT: u8 = 8;
}

/// Bits of the material properties that follow the current colour, [`LightingKey::color_material`].
#[allow(missing_docs)]
pub mod tracks {
    pub const AMBIENT: u8 = 1;
    pub const DIFFUSE: u8 = 2;
    pub const SPECULAR: u8 = 4;
    pub const EMISSION: u8 = 8;
}

/// What lighting does.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct LightingKey {
    /// Lighting is on.
    pub enabled: bool,
    /// `light::*` of each light.
    pub lights: [u8; 8],
    /// `tracks::*` of front and back.
    pub color_material: [u8; 2],
    /// Back faces are lit with their own material and the opposite normal.
    pub two_side: bool,
    /// The viewer is at the eye's origin, not infinitely far.
    pub local_viewer: bool,
    /// Specular light goes to the secondary colour.
    pub separate_specular: bool,
    /// Some specular term is not black.
    pub specular: bool,
}

impl LightingKey {
    /// Eye coordinates are needed.
    pub fn needs_eye(&self) -> bool {
        self.enabled && (self.lights.iter().any(|l| l & light::POSITIONAL != 0) || self.specular && self.local_viewer)
    }

    fn faces(&self) -> u8 {
        if self.two_side { 2 } else { 1 }
    }
}

/// Writes the statements that define `front_color`, `front_specular` and, two-sided, `back_color`, `back_specular` (vec4),
/// from `normal` (and `eye`).
pub(super) fn generate(t: &mut Text, key: &LightingKey) {
    for face in 0..key.faces() {
        let (name, scene) = (prefix(face), t.slot(Slot::SceneColor(face)));
        let tracked = key.color_material[face as usize];
        let base = if tracked & (tracks::AMBIENT | tracks::EMISSION) == 0 {
            format!("{scene}.rgb")
        } else {
            let emission =
                if tracked & tracks::EMISSION != 0 { "in.a3.rgb".into() } else { format!("{}.rgb", t.slot(Slot::Emission(face))) };
            let ambient =
                if tracked & tracks::AMBIENT != 0 { "in.a3.rgb".into() } else { format!("{}.rgb", t.slot(Slot::MaterialAmbient(face))) };
            format!("{emission} + {ambient} * {}.rgb", t.slot(Slot::ModelAmbient))
        };
        t.line(format!("var {name}_sum = {base};"));
        if key.specular {
            t.line(format!("var {name}_shine = vec3<f32>(0.0);"));
        }
    }
    if key.specular && key.local_viewer {
        t.line("let viewer = unit(-eye.xyz);");
    }
    for (i, bits) in key.lights.iter().enumerate().filter(|(_, bits)| **bits & light::ENABLED != 0) {
        one_light(t, key, i as u8, *bits);
    }
    for face in 0..key.faces() {
        let (name, scene) = (prefix(face), t.slot(Slot::SceneColor(face)));
        let alpha = if key.color_material[face as usize] & tracks::DIFFUSE != 0 { "in.a3.a".into() } else { format!("{scene}.a") };
        let (sum, specular) = match (key.specular, key.separate_specular) {
            (false, _) => (format!("{name}_sum"), "vec3<f32>(0.0)".into()),
            (true, false) => (format!("{name}_sum + {name}_shine"), "vec3<f32>(0.0)".into()),
            (true, true) => (format!("{name}_sum"), format!("{name}_shine")),
        };
        t.line(format!("let {name}_color = saturate(vec4<f32>({sum}, {alpha}));"));
        t.line(format!("let {name}_specular = saturate(vec4<f32>({specular}, 1.0));"));
    }
}

fn prefix(face: u8) -> &'static str {
    if face == 0 { "front" } else { "back" }
}

fn one_light(t: &mut Text, key: &LightingKey, i: u8, bits: u8) {
    let position = t.slot(Slot::LightPosition(i));
    // vp: the unit vector from the vertex to the light.
    if bits & light::POSITIONAL != 0 {
        t.line(format!("let to{i} = {position}.xyz - eye.xyz;"));
        t.line(format!("let square{i} = dot(to{i}, to{i});"));
        t.line(format!("let inverse{i} = inverse_root(square{i});"));
        t.line(format!("let vp{i} = to{i} * inverse{i};"));
    } else {
        t.line(format!("let vp{i} = {position}.xyz;"));
    }
    let mut factor = None;
    if bits & light::ATTENUATED != 0 {
        let k = t.slot(Slot::LightAttenuation(i));
        t.line(format!("var factor{i} = 1.0 / (({k}.x + {k}.y * (square{i} * inverse{i})) + {k}.z * square{i});"));
        factor = Some(format!("factor{i}"));
    }
    if bits & light::SPOT != 0 {
        let (spot, exponent) = (t.slot(Slot::LightSpot(i)), t.slot(Slot::LightExponent(i)));
        t.line(format!("let along{i} = -dot(vp{i}, {spot}.xyz);"));
        let cone = format!("select(0.0, power(max(along{i}, 0.0), {exponent}.x), along{i} >= {spot}.w)");
        if factor.is_some() {
            t.line(format!("factor{i} *= {cone};"));
        } else {
            t.line(format!("let factor{i} = {cone};"));
            factor = Some(format!("factor{i}"));
        }
    }
    t.line(format!("let nl{i} = dot(normal, vp{i});"));
    if key.specular {
        if key.local_viewer {
            t.line(format!("let half{i} = unit(vp{i} + viewer);"));
        } else if bits & light::POSITIONAL != 0 {
            t.line(format!("let half{i} = unit(vp{i} + vec3<f32>(0.0, 0.0, 1.0));"));
        } else {
            let half = t.slot(Slot::LightHalf(i));
            t.line(format!("let half{i} = {half}.xyz;"));
        }
        t.line(format!("let nh{i} = dot(normal, half{i});"));
    }
    for face in 0..key.faces() {
        let (name, sign) = (prefix(face), if face == 0 { "" } else { "-" });
        let tracked = key.color_material[face as usize];
        let mut product = |bit: u8, light: Slot, product: Slot| {
            if tracked & bit != 0 { format!("(in.a3.rgb * {}.rgb)", t.slot(light)) } else { format!("{}.rgb", t.slot(product)) }
        };
        let ambient = product(tracks::AMBIENT, Slot::LightAmbient(i), Slot::AmbientProduct(face, i));
        let diffuse = product(tracks::DIFFUSE, Slot::LightDiffuse(i), Slot::DiffuseProduct(face, i));
        let lit = format!("({ambient} + max({sign}nl{i}, 0.0) * {diffuse})");
        match &factor {
            Some(f) => t.line(format!("{name}_sum += {f} * {lit};")),
            None => t.line(format!("{name}_sum += {lit};")),
        }
        if key.specular {
            let specular = if tracked & tracks::SPECULAR != 0 {
                format!("(in.a3.rgb * {}.rgb)", t.slot(Slot::LightSpecular(i)))
            } else {
                format!("{}.rgb", t.slot(Slot::SpecularProduct(face, i)))
            };
            let shininess = t.slot(Slot::Shininess(face));
            let power = format!("select(0.0, power(max({sign}nh{i}, 0.0), {shininess}.x), {sign}nl{i} > 0.0)");
            match &factor {
                Some(f) => t.line(format!("{name}_shine += ({f} * {power}) * {specular};")),
                None => t.line(format!("{name}_shine += {power} * {specular};")),
            }
        }
    }
}
