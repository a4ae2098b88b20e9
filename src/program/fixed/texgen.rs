//! Texture coordinates: generation (2.11.4) and the texture matrix.

use super::slots::Slot;
use super::text::Text;

/// How a texture coordinate is generated.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Generate {
    #[default]
    None,
    ObjectLinear,
    EyeLinear,
    SphereMap,
    ReflectionMap,
    NormalMap,
}

/// What happens to the coordinates of a texture unit.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct TexCoordKey {
    /// They are written.
    pub used: bool,
    /// The texture matrix is not the identity.
    pub matrix: bool,
    /// Generation of s, t, r, q.
    pub generate: [Generate; 4],
}

impl TexCoordKey {
    /// Eye coordinates are needed.
    pub fn needs_eye(&self) -> bool {
        self.used && self.generate.iter().any(|g| matches!(g, Generate::EyeLinear | Generate::SphereMap | Generate::ReflectionMap))
    }
    /// The normal is needed.
    pub fn needs_normal(&self) -> bool {
        self.used && self.generate.iter().any(|g| matches!(g, Generate::NormalMap)) || self.needs_reflection()
    }
    /// The reflection vector is needed.
    pub fn needs_reflection(&self) -> bool {
        self.used && self.generate.iter().any(|g| matches!(g, Generate::SphereMap | Generate::ReflectionMap))
    }
    /// The sphere map's coordinates are needed.
    pub fn needs_sphere(&self) -> bool {
        self.used && self.generate.contains(&Generate::SphereMap)
    }
    /// The attribute is read.
    pub fn needs_attribute(&self) -> bool {
        self.used && self.generate.contains(&Generate::None)
    }
}

/// What the units share: the reflection vector and the sphere map.
pub(super) fn shared(t: &mut Text, units: &[TexCoordKey]) {
    if units.iter().any(TexCoordKey::needs_reflection) {
        t.line("let incident = unit(eye.xyz);");
        t.line("let reflected = incident - normal * (2.0 * dot(normal, incident));");
    }
    if units.iter().any(TexCoordKey::needs_sphere) {
        t.line("let outwards = reflected + vec3<f32>(0.0, 0.0, 1.0);");
        t.line("let sphere = reflected.xy * (0.5 * inverse_root(dot(outwards, outwards))) + vec2<f32>(0.5);");
    }
}

/// The expression of a unit's coordinates.
pub(super) fn coordinates(t: &mut Text, unit: u8, key: &TexCoordKey) -> String {
    let attribute = format!("in.a{}", 8 + unit);
    let mut value = attribute.clone();
    if key.generate != [Generate::None; 4] {
        let parts: Vec<String> = key
            .generate
            .iter()
            .enumerate()
            .map(|(c, generate)| {
                let letter = ["x", "y", "z", "w"][c];
                match generate {
                    Generate::None => format!("{attribute}.{letter}"),
                    Generate::ObjectLinear => format!("dot(in.a0, {})", t.slot(Slot::ObjectPlane(unit, c as u8))),
                    Generate::EyeLinear => format!("dot(eye, {})", t.slot(Slot::EyePlane(unit, c as u8))),
                    // Only s and t can be sphere mapped, only s, t and r take the other two: the setter refuses the rest.
                    Generate::SphereMap => format!("sphere.{}", ["x", "y", "y", "y"][c]),
                    Generate::ReflectionMap => format!("reflected.{}", ["x", "y", "z", "z"][c]),
                    Generate::NormalMap => format!("normal.{}", ["x", "y", "z", "z"][c]),
                }
            })
            .collect();
        value = format!("vec4<f32>({})", parts.join(", "));
    }
    if key.matrix {
        t.line(format!("let coord{unit} = {value};"));
        value = t.transform(|c| Slot::TextureMatrix(unit, c), &format!("coord{unit}"));
    }
    value
}
