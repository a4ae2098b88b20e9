//! State → keys of the fixed-function programs: what is enabled and has an effect, nothing else.

use crate::draw::texture::{Sampler, TextureBinding, TextureKind};
use crate::gl::enums::*;
use crate::gl::state::{Light, MAX_TEXTURE_UNITS, Material, TextureUnit};
use crate::gl::{Context, Parity};
use crate::program::Output;
use crate::program::fixed::*;
use crate::raster::layout::topology;

impl Context {
    /// The fragment program's key; the bindings of its texture slots go to `textures`.
    pub(super) fn fragment_key(&self, topology: u32, textures: &mut Vec<TextureBinding>) -> FragmentKey {
        let s = &self.state;
        let mut units = [UnitKey::default(); 8];
        textures.clear();
        for (k, unit) in s.texture.units.iter().enumerate().filter(|(_, u)| u.enabled.contains(&true)) {
            if let Some((binding, base)) = self.texture_binding(k) {
                units[k] = UnitKey {
                    enabled: true,
                    cube: binding.image.kind == TextureKind::Cube,
                    lod: wants_lod(&binding.sampler, binding.image.levels.len()),
                    base: base_format(base),
                    mode: environment(unit),
                };
                textures.push(binding);
            }
        }
        let separate = s.lighting.enabled && s.lighting.color_control == GL_SEPARATE_SPECULAR_COLOR;
        FragmentKey {
            source: Source::Color,
            flat: s.lighting.shade_model == GL_FLAT,
            two_side: s.lighting.enabled && s.lighting.two_side,
            color_sum: separate || (s.lighting.color_sum && !s.lighting.enabled),
            fog: match (s.fog.enabled, s.fog.mode) {
                (false, _) => Fog::None,
                (true, GL_LINEAR) => Fog::Linear,
                (true, GL_EXP) => Fog::Exp,
                (true, _) => Fog::Exp2,
            },
            smooth: self.smooth(topology),
            units,
        }
    }

    /// Which antialiasing a draw needs. A draw of polygons may become points or lines.
    fn smooth(&self, topology: u32) -> Smooth {
        let s = &self.state;
        let becomes = |kind: u32, mode: GLenum| topology == kind || (topology == topology::TRIANGLES && s.polygon.mode.contains(&mode));
        if s.line.smooth && becomes(topology::LINES, GL_LINE) {
            Smooth::Line
        } else if s.point.smooth && becomes(topology::POINTS, GL_POINT) {
            if self.config.parity == Parity::Osmesa { Smooth::Disc } else { Smooth::Point }
        } else {
            Smooth::None
        }
    }

    /// The vertex program's key: what `fragment` reads, or everything that can be asked for.
    pub(super) fn vertex_key(&self, fragment: &FixedProgram, topology: u32, everything: bool) -> VertexKey {
        let s = &self.state;
        let reads = |output: Output| everything || fragment.program.varyings.iter().any(|v| v.front == output);
        let points = topology == topology::POINTS || s.polygon.mode != [GL_FILL; 2];
        let mut units = [TexCoordKey::default(); 8];
        for (k, unit) in units.iter_mut().enumerate().filter(|(k, _)| reads(Output::TexCoord(*k as u8))) {
            *unit = self.tex_coord_key(k);
        }
        let lit = s.lighting.enabled && (reads(Output::FrontColor) || reads(Output::FrontSecondary));
        let normal = lit || units.iter().any(TexCoordKey::needs_normal);
        VertexKey {
            color: reads(Output::FrontColor),
            secondary: reads(Output::FrontSecondary),
            lighting: if lit { self.lighting_key() } else { LightingKey::default() },
            normal: match (normal, s.transform.normalize, s.transform.rescale_normal) {
                (true, true, _) => Normal::Normalize,
                (true, false, true) => Normal::Rescale,
                _ => Normal::Keep,
            },
            units,
            fog: match (reads(Output::Fog), s.fog.coord_source) {
                (false, _) => FogCoord::None,
                (true, GL_FOG_COORD) => FogCoord::Attribute,
                (true, _) => FogCoord::EyeZ,
            },
            eye: everything,
            planes_in_clip_space: self.config.parity == Parity::Osmesa,
            clip_planes: s.transform.clip_enabled.iter().filter(|e| **e).count() as u8,
            point_attenuation: points && s.point.attenuation != [1.0, 0.0, 0.0],
            point_distance_along_z: self.config.parity == Parity::Osmesa,
        }
    }

    fn tex_coord_key(&self, unit: usize) -> TexCoordKey {
        let Some(state) = self.state.texture.units.get(unit).filter(|_| unit < MAX_TEXTURE_UNITS) else { return TexCoordKey::default() };
        let generate = |c: usize| match (state.texgen[c].enabled, state.texgen[c].mode) {
            (false, _) => Generate::None,
            (true, GL_OBJECT_LINEAR) => Generate::ObjectLinear,
            (true, GL_SPHERE_MAP) => Generate::SphereMap,
            (true, GL_REFLECTION_MAP) => Generate::ReflectionMap,
            (true, GL_NORMAL_MAP) => Generate::NormalMap,
            (true, _) => Generate::EyeLinear,
        };
        TexCoordKey {
            used: true,
            matrix: *self.texture_matrices[unit].top() != glam::Mat4::IDENTITY,
            generate: [generate(0), generate(1), generate(2), generate(3)],
        }
    }

    fn lighting_key(&self) -> LightingKey {
        let s = &self.state.lighting;
        let mut key = LightingKey {
            enabled: true,
            lights: [0; 8],
            color_material: [0; 2],
            two_side: s.two_side,
            local_viewer: s.local_viewer,
            separate_specular: s.color_control == GL_SEPARATE_SPECULAR_COLOR,
            specular: false,
        };
        for (bits, light) in key.lights.iter_mut().zip(&s.lights).filter(|(_, l)| l.enabled) {
            *bits = light_kind(light).bits;
        }
        if s.color_material {
            let tracked = match s.color_material_mode {
                GL_EMISSION => tracks::EMISSION,
                GL_AMBIENT => tracks::AMBIENT,
                GL_DIFFUSE => tracks::DIFFUSE,
                GL_SPECULAR => tracks::SPECULAR,
                _ => tracks::AMBIENT | tracks::DIFFUSE,
            };
            let face = |other: GLenum| if s.color_material_face == other { 0 } else { tracked };
            key.color_material = [face(GL_BACK), if s.two_side { face(GL_FRONT) } else { 0 }];
        }
        let faces = if s.two_side { 2 } else { 1 };
        let shines = |face: usize| key.color_material[face] & tracks::SPECULAR != 0 || shines(&s.materials[face]);
        let glints = s.lights.iter().any(|l| l.enabled && light_kind(l).glints);
        key.specular = glints && (0..faces).any(shines);
        if !key.specular {
            // Equal programs for equal work.
            (key.local_viewer, key.separate_specular) = (false, false);
        }
        key
    }
}

/// What a program's key says about a light that is on.
#[derive(PartialEq)]
pub(in crate::gl) struct LightKind {
    bits: u8,
    glints: bool,
}

/// What a key says about a light; its other numbers are in the uniform block.
pub(in crate::gl) fn light_kind(light: &Light) -> LightKind {
    let mut bits = light::ENABLED;
    if light.position.w != 0.0 {
        bits |= light::POSITIONAL;
        if light.attenuation != [1.0, 0.0, 0.0] {
            bits |= light::ATTENUATED;
        }
    }
    if light.spot_cutoff != 180.0 {
        bits |= light::SPOT;
    }
    LightKind { bits, glints: light.specular[..3] != [0.0; 3] }
}

/// What a key says about a material.
pub(in crate::gl) fn shines(material: &Material) -> bool {
    material.specular[..3] != [0.0; 3]
}

/// Whether the result of sampling depends on the level of detail.
fn wants_lod(sampler: &Sampler, levels: usize) -> bool {
    sampler.mag_linear != sampler.min_linear || (sampler.mip_linear.is_some() && levels > 1)
}

fn base_format(format: GLenum) -> Base {
    match format {
        GL_ALPHA => Base::Alpha,
        GL_LUMINANCE | GL_DEPTH_COMPONENT => Base::Luminance,
        GL_LUMINANCE_ALPHA => Base::LuminanceAlpha,
        GL_INTENSITY => Base::Intensity,
        GL_RGB => Base::Rgb,
        _ => Base::Rgba,
    }
}

fn environment(unit: &TextureUnit) -> Mode {
    match unit.env_mode {
        GL_REPLACE => Mode::Replace,
        GL_DECAL => Mode::Decal,
        GL_BLEND => Mode::Blend,
        GL_ADD => Mode::Add,
        GL_COMBINE => Mode::Combine(combine(unit)),
        _ => Mode::Modulate,
    }
}

fn combine(unit: &TextureUnit) -> Combine {
    let function = |f: GLenum| match f {
        GL_REPLACE => Function::Replace,
        GL_ADD => Function::Add,
        GL_ADD_SIGNED => Function::AddSigned,
        GL_INTERPOLATE => Function::Interpolate,
        GL_SUBTRACT => Function::Subtract,
        GL_DOT3_RGB => Function::Dot3Rgb,
        GL_DOT3_RGBA => Function::Dot3Rgba,
        _ => Function::Modulate,
    };
    let source = |s: GLenum| match s {
        GL_CONSTANT => CombineSource::Constant,
        GL_PRIMARY_COLOR => CombineSource::PrimaryColor,
        GL_PREVIOUS => CombineSource::Previous,
        GL_TEXTURE0..=GL_TEXTURE7 => CombineSource::Unit((s - GL_TEXTURE0) as u8),
        _ => CombineSource::Texture,
    };
    let mut c = Combine { functions: unit.combine.map(function), ..Combine::default() };
    for channel in 0..2 {
        for k in 0..c.functions[channel].arity() {
            let operand = unit.combine_operands[channel][k];
            let alpha = matches!(operand, GL_SRC_ALPHA | GL_ONE_MINUS_SRC_ALPHA);
            let minus = matches!(operand, GL_ONE_MINUS_SRC_COLOR | GL_ONE_MINUS_SRC_ALPHA);
            c.arguments[channel][k] = (source(unit.combine_sources[channel][k]), alpha, minus);
        }
        c.shifts[channel] = match unit.combine_scale[channel] {
            2.0 => 1,
            4.0 => 2,
            _ => 0,
        };
    }
    c
}
