//! The server attribute stack (6.1.14): which state belongs to which group is in the state tables of 6.2.

use super::checks::put;
use super::enums::*;
use super::framebuffer_object::MAX_DRAW_BUFFERS;
use super::state::*;
use super::texture_object::{TextureObject, TextureTable};
use super::{Context, dirty};
use crate::draw::texture::TextureKind;

/// In the order of `TextureUnit::bound`.
const KINDS: [TextureKind; 4] = [TextureKind::D1, TextureKind::D2, TextureKind::D3, TextureKind::Cube];

/// State that one PushAttrib saved, by group.
enum Group {
    Current(Box<Current>),
    /// With the units' GL_COORD_REPLACE, which belongs to the points.
    Point(PointState, [bool; MAX_TEXTURE_UNITS]),
    Line(LineState),
    Polygon(PolygonState),
    PolygonStipple(Box<[u32; 32]>),
    /// Without the pixel maps, which belong to no group; with the read buffer of the framebuffer object that was bound.
    Pixel(Box<PixelState>, Option<(u32, GLenum)>),
    Lighting(Box<LightingState>),
    /// With GL_COLOR_SUM, which belongs to the fog.
    Fog(FogState, bool),
    Depth(DepthState),
    AccumClear([f32; 4]),
    Stencil(StencilState),
    Viewport(ViewportState),
    Transform(Box<TransformState>),
    Enables(Box<Enables>),
    /// With the draw buffers of the framebuffer object that was bound.
    ColorBuffer(Box<ColorBufferState>, Option<(u32, [GLenum; MAX_DRAW_BUFFERS])>),
    Hint(HintState),
    Eval(Box<EvalState>),
    ListBase(u32),
    /// With the parameters of the textures that were bound (3.8.4, 6.1.14).
    Texture(Box<TextureState>, Vec<(TextureKind, u32, TextureObject)>),
    Scissor(ScissorState),
    Multisample(MultisampleState),
}

/// All capabilities: those of the context and, a unit each, those of the texture units.
struct Enables {
    context: Vec<bool>,
    units: [[bool; UNIT_CAPABILITIES.len()]; MAX_TEXTURE_UNITS],
}

/// What one PushAttrib saved.
pub(crate) struct SavedAttributes {
    groups: Vec<Group>,
}

/// Capabilities of a texture unit.
const UNIT_CAPABILITIES: [GLenum; 8] = [
    GL_TEXTURE_1D,
    GL_TEXTURE_2D,
    GL_TEXTURE_3D,
    GL_TEXTURE_CUBE_MAP,
    GL_TEXTURE_GEN_S,
    GL_TEXTURE_GEN_T,
    GL_TEXTURE_GEN_R,
    GL_TEXTURE_GEN_Q,
];

/// Capabilities that a context has once, besides lights, clip planes and maps.
const CONTEXT_CAPABILITIES: [GLenum; 28] = [
    GL_ALPHA_TEST,
    GL_AUTO_NORMAL,
    GL_BLEND,
    GL_COLOR_LOGIC_OP,
    GL_COLOR_MATERIAL,
    GL_COLOR_SUM,
    GL_CULL_FACE,
    GL_DEPTH_TEST,
    GL_DITHER,
    GL_FOG,
    GL_INDEX_LOGIC_OP,
    GL_LIGHTING,
    GL_LINE_SMOOTH,
    GL_LINE_STIPPLE,
    GL_MULTISAMPLE,
    GL_NORMALIZE,
    GL_POINT_SMOOTH,
    GL_POINT_SPRITE,
    GL_POLYGON_OFFSET_FILL,
    GL_POLYGON_OFFSET_LINE,
    GL_POLYGON_OFFSET_POINT,
    GL_POLYGON_SMOOTH,
    GL_POLYGON_STIPPLE,
    GL_RESCALE_NORMAL,
    GL_SAMPLE_ALPHA_TO_COVERAGE,
    GL_SAMPLE_ALPHA_TO_ONE,
    GL_SAMPLE_COVERAGE,
    GL_SCISSOR_TEST,
];

/// Every capability that a context has once, in a fixed order.
fn context_capabilities() -> impl Iterator<Item = GLenum> {
    CONTEXT_CAPABILITIES
        .into_iter()
        .chain([GL_STENCIL_TEST])
        .chain((0..MAX_LIGHTS as u32).map(|i| GL_LIGHT0 + i))
        .chain((0..MAX_CLIP_PLANES as u32).map(|i| GL_CLIP_PLANE0 + i))
        .chain(GL_MAP1_COLOR_4..=GL_MAP1_VERTEX_4)
        .chain(GL_MAP2_COLOR_4..=GL_MAP2_VERTEX_4)
}

impl Context {
    /// glPushAttrib. Bits that name no group are ignored.
    pub fn push_attrib(&mut self, mask: GLenum) {
        if self.compile(move |cx| cx.push_attrib(mask)) || self.inside_begin_end() {
            return;
        }
        if self.attrib_stack.len() >= ATTRIB_STACK_DEPTH {
            return self.set_error(GL_STACK_OVERFLOW, "glPushAttrib");
        }
        self.sync_color_material();
        let groups = GROUP_BITS.iter().filter(|&&bit| mask & bit != 0).map(|&bit| self.save_group(bit)).collect();
        self.attrib_stack.push(SavedAttributes { groups });
    }

    /// glPopAttrib.
    pub fn pop_attrib(&mut self) {
        if self.compile(|cx| cx.pop_attrib()) || self.inside_begin_end() {
            return;
        }
        let Some(saved) = self.attrib_stack.pop() else {
            return self.set_error(GL_STACK_UNDERFLOW, "glPopAttrib");
        };
        self.sync_color_material();
        for group in saved.groups {
            self.restore_group(group);
        }
        self.sync_color_material();
    }

    fn save_group(&mut self, bit: GLenum) -> Group {
        let s = &self.state;
        match bit {
            GL_CURRENT_BIT => Group::Current(Box::new(s.current.clone())),
            GL_POINT_BIT => Group::Point(s.point.clone(), std::array::from_fn(|unit| s.texture.units[unit].coord_replace)),
            GL_LINE_BIT => Group::Line(s.line.clone()),
            GL_POLYGON_BIT => Group::Polygon(s.polygon.clone()),
            GL_POLYGON_STIPPLE_BIT => Group::PolygonStipple(Box::new(s.polygon_stipple)),
            GL_PIXEL_MODE_BIT => {
                let read = self.fbo.get(self.fbo.read).map(|f| (self.fbo.read, f.read_buffer));
                Group::Pixel(Box::new(PixelState { maps: Default::default(), ..s.pixel }), read)
            }
            GL_LIGHTING_BIT => Group::Lighting(Box::new(s.lighting.clone())),
            GL_FOG_BIT => Group::Fog(s.fog.clone(), s.lighting.color_sum),
            GL_DEPTH_BUFFER_BIT => Group::Depth(s.depth.clone()),
            GL_ACCUM_BUFFER_BIT => Group::AccumClear(s.accum_clear),
            GL_STENCIL_BUFFER_BIT => Group::Stencil(s.stencil.clone()),
            GL_VIEWPORT_BIT => Group::Viewport(s.viewport.clone()),
            GL_TRANSFORM_BIT => Group::Transform(Box::new(s.transform.clone())),
            GL_COLOR_BUFFER_BIT => {
                let draw = self.fbo.get(self.fbo.draw).map(|f| (self.fbo.draw, f.draw_buffers));
                Group::ColorBuffer(Box::new(s.color_buffer.clone()), draw)
            }
            GL_HINT_BIT => Group::Hint(s.hint.clone()),
            GL_EVAL_BIT => Group::Eval(Box::new(s.eval.clone())),
            GL_LIST_BIT => Group::ListBase(s.list_base),
            GL_TEXTURE_BIT => Group::Texture(Box::new(s.texture.clone()), self.bound_textures()),
            GL_SCISSOR_BIT => Group::Scissor(s.scissor.clone()),
            GL_MULTISAMPLE_BIT => Group::Multisample(s.multisample.clone()),
            _ => Group::Enables(Box::new(self.save_enables())),
        }
    }

    fn restore_group(&mut self, group: Group) {
        let s = &mut self.state;
        self.dirty |= match group {
            Group::Current(saved) => {
                s.current = *saved;
                dirty::LIGHTING
            }
            Group::Point(saved, coord_replace) => {
                s.point = saved;
                for (unit, coord_replace) in s.texture.units.iter_mut().zip(coord_replace) {
                    unit.coord_replace = coord_replace;
                }
                dirty::RASTER | dirty::TEXTURE
            }
            Group::Line(saved) => {
                s.line = saved;
                dirty::RASTER
            }
            Group::Polygon(saved) => {
                s.polygon = saved;
                dirty::RASTER
            }
            Group::PolygonStipple(saved) => {
                s.polygon_stipple = *saved;
                dirty::RASTER
            }
            Group::Pixel(saved, read) => {
                let maps = std::mem::take(&mut s.pixel.maps);
                let read_buffer = if read.is_some() { s.pixel.read_buffer } else { saved.read_buffer };
                s.pixel = PixelState { maps, read_buffer, ..*saved };
                if let Some((_, buffer)) = read.filter(|(name, _)| *name == self.fbo.read) {
                    self.read_buffer(buffer);
                }
                0
            }
            Group::Lighting(saved) => {
                let color_sum = s.lighting.color_sum;
                s.lighting = LightingState { color_sum, ..*saved };
                dirty::LIGHTING
            }
            Group::Fog(saved, color_sum) => {
                s.fog = saved;
                s.lighting.color_sum = color_sum;
                dirty::FOG | dirty::LIGHTING
            }
            Group::Depth(saved) => {
                s.depth = saved;
                dirty::FRAGMENT
            }
            Group::AccumClear(saved) => {
                s.accum_clear = saved;
                0
            }
            Group::Stencil(saved) => {
                s.stencil = saved;
                dirty::FRAGMENT
            }
            Group::Viewport(saved) => {
                s.viewport = saved;
                dirty::TRANSFORM
            }
            Group::Transform(saved) => {
                s.transform = *saved;
                dirty::TRANSFORM | dirty::LIGHTING | dirty::RASTER
            }
            Group::Enables(saved) => return self.restore_enables(&saved),
            Group::ColorBuffer(saved, draw) => {
                let draw_buffers = if draw.is_some() { s.color_buffer.draw_buffers } else { saved.draw_buffers };
                s.color_buffer = ColorBufferState { draw_buffers, ..*saved };
                if let Some((_, buffers)) = draw.filter(|(name, _)| *name == self.fbo.draw) {
                    self.set_draw_buffers(&buffers);
                }
                dirty::FRAGMENT
            }
            Group::Hint(saved) => {
                s.hint = saved;
                dirty::FOG
            }
            Group::Eval(saved) => {
                s.eval = *saved;
                0
            }
            Group::ListBase(saved) => {
                s.list_base = saved;
                0
            }
            Group::Texture(saved, objects) => {
                let mut shared = self.shared.lock().unwrap_or_else(|poisoned| poisoned.into_inner());
                restore_textures(&mut shared.textures, &objects);
                let coord_replace: [bool; MAX_TEXTURE_UNITS] = std::array::from_fn(|unit| s.texture.units[unit].coord_replace);
                s.texture = *saved;
                for (unit, coord_replace) in s.texture.units.iter_mut().zip(coord_replace) {
                    unit.coord_replace = coord_replace;
                }
                dirty::TEXTURE
            }
            Group::Scissor(saved) => {
                s.scissor = saved;
                dirty::RASTER
            }
            Group::Multisample(saved) => {
                s.multisample = saved;
                dirty::FRAGMENT | dirty::RASTER
            }
        };
    }

    /// The parameters of every texture that some unit has bound.
    fn bound_textures(&self) -> Vec<(TextureKind, u32, TextureObject)> {
        let mut shared = self.shared();
        let mut saved: Vec<(TextureKind, u32, TextureObject)> = Vec::new();
        for unit in &self.state.texture.units {
            for (kind, &name) in KINDS.into_iter().zip(&unit.bound) {
                if saved.iter().any(|(k, n, _)| *k == kind && *n == name) {
                    continue;
                }
                if let Some(object) = shared.textures.existing(kind, name) {
                    saved.push((kind, name, object.parameters()));
                }
            }
        }
        saved
    }

    fn save_enables(&mut self) -> Enables {
        let context = context_capabilities().map(|cap| self.capability_value(cap) == Some(true)).collect();
        let active = self.state.texture.active;
        let units = std::array::from_fn(|unit| {
            self.state.texture.active = unit;
            UNIT_CAPABILITIES.map(|cap| self.capability_value(cap) == Some(true))
        });
        self.state.texture.active = active;
        Enables { context, units }
    }

    fn restore_enables(&mut self, saved: &Enables) {
        for (cap, &on) in context_capabilities().zip(&saved.context) {
            self.restore_capability(cap, on);
        }
        let active = self.state.texture.active;
        for (unit, values) in saved.units.iter().enumerate() {
            self.state.texture.active = unit;
            for (cap, &on) in UNIT_CAPABILITIES.into_iter().zip(values) {
                self.restore_capability(cap, on);
            }
        }
        self.state.texture.active = active;
    }

    fn restore_capability(&mut self, cap: GLenum, on: bool) {
        let mut changed = 0;
        if let Some((slot, group)) = self.capability(cap) {
            put(slot, on, &mut changed, group);
        }
        self.dirty |= changed;
    }
}

/// Gives textures their saved parameters back. One that was deleted since is skipped.
fn restore_textures(textures: &mut TextureTable, saved: &[(TextureKind, u32, TextureObject)]) {
    for (kind, name, parameters) in saved {
        if let Some(object) = textures.existing(*kind, *name) {
            object.restore_parameters(parameters);
        }
    }
}

/// The bits of glPushAttrib, one a group. GL_ENABLE_BIT comes last: it repeats what other groups restore.
const GROUP_BITS: [GLenum; 21] = [
    GL_CURRENT_BIT,
    GL_POINT_BIT,
    GL_LINE_BIT,
    GL_POLYGON_BIT,
    GL_POLYGON_STIPPLE_BIT,
    GL_PIXEL_MODE_BIT,
    GL_LIGHTING_BIT,
    GL_FOG_BIT,
    GL_DEPTH_BUFFER_BIT,
    GL_ACCUM_BUFFER_BIT,
    GL_STENCIL_BUFFER_BIT,
    GL_VIEWPORT_BIT,
    GL_TRANSFORM_BIT,
    GL_COLOR_BUFFER_BIT,
    GL_HINT_BIT,
    GL_EVAL_BIT,
    GL_LIST_BIT,
    GL_TEXTURE_BIT,
    GL_SCISSOR_BIT,
    GL_MULTISAMPLE_BIT,
    GL_ENABLE_BIT,
];
