//! The state that an application can set and query (chapter 6 of the OpenGL 2.1 specification, state tables).
//! Values are kept as they were given wherever a query returns them so; clamping is noted where the specification
//! clamps on the way in. Enums stay `GLenum` here: the derived state translates them.

use super::enums::*;
use super::framebuffer_object::MAX_DRAW_BUFFERS;
use glam::{Mat4, Vec3, Vec4};

/// Lights (GL_MAX_LIGHTS).
pub const MAX_LIGHTS: usize = 8;
/// User clip planes (GL_MAX_CLIP_PLANES).
pub const MAX_CLIP_PLANES: usize = 8;
/// Texture units with fixed-function state (GL_MAX_TEXTURE_UNITS).
pub const MAX_TEXTURE_UNITS: usize = 8;
/// Depth of the model-view stack.
pub const MODELVIEW_STACK_DEPTH: usize = 32;
/// Depth of the projection and texture stacks.
pub const PROJECTION_STACK_DEPTH: usize = 32;
/// Depth of the texture stacks.
pub const TEXTURE_STACK_DEPTH: usize = 10;
/// Depth of the server and client attribute stacks.
pub const ATTRIB_STACK_DEPTH: usize = 16;
/// Depth of the name stack.
pub const NAME_STACK_DEPTH: usize = 64;
/// All bits of a stencil buffer: what the stencil masks are at first.
pub const STENCIL_MASK: u32 = 0xff;
/// Nesting of display lists.
pub const MAX_LIST_NESTING: usize = 64;

/// Everything that glPushAttrib can save, by group, and what it cannot.
#[derive(Clone, Debug)]
pub struct State {
    /// Current vertex attributes by slot (`layout::ATTRIBUTES` numbering); colours not clamped.
    pub current: Current,
    /// Points.
    pub point: PointState,
    /// Lines.
    pub line: LineState,
    /// Polygons.
    pub polygon: PolygonState,
    /// Polygon stipple pattern: row 0 is the bottom row, bit 31 the leftmost column.
    pub polygon_stipple: [u32; 32],
    /// Pixel transfer and zoom.
    pub pixel: PixelState,
    /// Lighting and materials.
    pub lighting: LightingState,
    /// Fog.
    pub fog: FogState,
    /// Depth buffer.
    pub depth: DepthState,
    /// Accumulation clear value.
    pub accum_clear: [f32; 4],
    /// Stencil buffer.
    pub stencil: StencilState,
    /// Viewport and depth range.
    pub viewport: ViewportState,
    /// Matrix mode, normalisation, user clip planes.
    pub transform: TransformState,
    /// Per-fragment operations on colour.
    pub color_buffer: ColorBufferState,
    /// Hints.
    pub hint: HintState,
    /// Evaluators' enables and grids.
    pub eval: EvalState,
    /// List base.
    pub list_base: u32,
    /// Scissor.
    pub scissor: ScissorState,
    /// Texture units.
    pub texture: TextureState,
    /// Multisample enables and values.
    pub multisample: MultisampleState,
    /// Client pixel store: pack.
    pub pack: PixelStore,
    /// Client pixel store: unpack.
    pub unpack: PixelStore,
}

/// Current values.
#[derive(Clone, Debug)]
pub struct Current {
    /// By attribute slot.
    pub attributes: [[f32; 4]; 16],
    /// Current index (colour index mode's state, kept for queries).
    pub index: f32,
    /// Edge flag.
    pub edge_flag: bool,
    /// Current raster position and what goes with it.
    pub raster: RasterPos,
}

/// The current raster position (2.13).
#[derive(Clone, Debug)]
pub struct RasterPos {
    /// Window coordinates x, y (y up), z and clip w.
    pub position: [f32; 4],
    /// GL_CURRENT_RASTER_DISTANCE.
    pub distance: f32,
    /// Colour.
    pub color: [f32; 4],
    /// Secondary colour.
    pub secondary_color: [f32; 4],
    /// Texture coordinates by unit.
    pub tex_coords: [[f32; 4]; MAX_TEXTURE_UNITS],
    /// Index.
    pub index: f32,
    /// Valid.
    pub valid: bool,
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct PointState {
    pub size: f32,
    pub smooth: bool,
    /// ARB_point_parameters: least, greatest size, fade threshold, attenuation.
    pub size_min: f32,
    pub size_max: f32,
    pub fade_threshold: f32,
    pub attenuation: [f32; 3],
    pub sprite: bool,
    pub sprite_origin: GLenum,
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct LineState {
    pub width: f32,
    pub smooth: bool,
    pub stipple: bool,
    pub stipple_factor: i32,
    pub stipple_pattern: u16,
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct PolygonState {
    pub cull: bool,
    pub cull_mode: GLenum,
    pub front_face: GLenum,
    pub mode: [GLenum; 2],
    pub smooth: bool,
    pub stipple: bool,
    pub offset_fill: bool,
    pub offset_line: bool,
    pub offset_point: bool,
    pub offset_factor: f32,
    pub offset_units: f32,
}

/// Pixel transfer (3.6.3).
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct PixelState {
    pub map_color: bool,
    pub map_stencil: bool,
    pub index_shift: i32,
    pub index_offset: i32,
    /// RGBA.
    pub scale: [f32; 4],
    pub bias: [f32; 4],
    pub depth_scale: f32,
    pub depth_bias: f32,
    pub zoom: [f32; 2],
    /// GL_PIXEL_MAP_I_TO_I .. A_TO_A, in the order of their enums.
    pub maps: [Vec<f32>; 10],
    pub read_buffer: GLenum,
}

/// A light (2.14.1). Position and direction in eye coordinates.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct Light {
    pub enabled: bool,
    pub ambient: [f32; 4],
    pub diffuse: [f32; 4],
    pub specular: [f32; 4],
    pub position: Vec4,
    pub spot_direction: Vec3,
    pub spot_exponent: f32,
    pub spot_cutoff: f32,
    /// Constant, linear, quadratic.
    pub attenuation: [f32; 3],
}

/// A material, one a face.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct Material {
    pub ambient: [f32; 4],
    pub diffuse: [f32; 4],
    pub specular: [f32; 4],
    pub emission: [f32; 4],
    pub shininess: f32,
    pub color_indexes: [f32; 3],
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct LightingState {
    pub enabled: bool,
    pub lights: [Light; MAX_LIGHTS],
    pub model_ambient: [f32; 4],
    pub local_viewer: bool,
    pub two_side: bool,
    pub color_control: GLenum,
    /// Front, back.
    pub materials: [Material; 2],
    pub color_material: bool,
    pub color_material_face: GLenum,
    pub color_material_mode: GLenum,
    pub shade_model: GLenum,
    /// EXT_secondary_color's GL_COLOR_SUM.
    pub color_sum: bool,
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct FogState {
    pub enabled: bool,
    pub mode: GLenum,
    pub color: [f32; 4],
    pub density: f32,
    pub start: f32,
    pub end: f32,
    pub index: f32,
    pub coord_source: GLenum,
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct DepthState {
    pub test: bool,
    pub func: GLenum,
    pub write: bool,
    pub clear: f64,
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct StencilSide {
    pub func: GLenum,
    /// As given; clamped where it is used and queried.
    pub reference: i32,
    pub value_mask: u32,
    pub write_mask: u32,
    pub fail: GLenum,
    pub depth_fail: GLenum,
    pub depth_pass: GLenum,
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct StencilState {
    pub test: bool,
    /// Front, back.
    pub sides: [StencilSide; 2],
    pub clear: i32,
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct ViewportState {
    pub x: i32,
    pub y: i32,
    pub width: i32,
    pub height: i32,
    pub near: f64,
    pub far: f64,
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct TransformState {
    pub matrix_mode: GLenum,
    pub normalize: bool,
    pub rescale_normal: bool,
    /// In eye coordinates.
    pub clip_planes: [Vec4; MAX_CLIP_PLANES],
    pub clip_enabled: [bool; MAX_CLIP_PLANES],
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct ColorBufferState {
    pub alpha_test: bool,
    pub alpha_func: GLenum,
    pub alpha_ref: f32,
    pub blend: bool,
    /// Source RGB, destination RGB, source alpha, destination alpha.
    pub blend_func: [GLenum; 4],
    /// RGB, alpha.
    pub blend_equation: [GLenum; 2],
    pub blend_color: [f32; 4],
    pub dither: bool,
    pub index_logic_op: bool,
    pub color_logic_op: bool,
    pub logic_op: GLenum,
    /// The window's; framebuffer objects have their own.
    pub draw_buffers: [GLenum; MAX_DRAW_BUFFERS],
    pub color_mask: [bool; 4],
    pub index_mask: u32,
    pub clear_color: [f32; 4],
    pub clear_index: f32,
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct HintState {
    pub perspective_correction: GLenum,
    pub point_smooth: GLenum,
    pub line_smooth: GLenum,
    pub polygon_smooth: GLenum,
    pub fog: GLenum,
    pub generate_mipmap: GLenum,
    pub texture_compression: GLenum,
    pub fragment_derivative: GLenum,
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct EvalState {
    pub auto_normal: bool,
    /// GL_MAP1_COLOR_4 .. GL_MAP1_VERTEX_4, in the order of their enums.
    pub map1: [bool; 9],
    pub map2: [bool; 9],
    pub grid1_divisions: i32,
    pub grid1_domain: [f32; 2],
    pub grid2_divisions: [i32; 2],
    pub grid2_domain: [f32; 4],
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct ScissorState {
    pub test: bool,
    pub x: i32,
    pub y: i32,
    pub width: i32,
    pub height: i32,
}

/// Texture coordinate generation of one coordinate (2.11.4).
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct TexGen {
    pub enabled: bool,
    pub mode: GLenum,
    pub object_plane: Vec4,
    /// Already multiplied by the inverse model-view matrix.
    pub eye_plane: Vec4,
}

/// Texture environment and enables of one unit.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct TextureUnit {
    /// GL_TEXTURE_1D, 2D, 3D, CUBE_MAP.
    pub enabled: [bool; 4],
    /// Names bound to 1D, 2D, 3D, cube map; 0 is the default texture.
    pub bound: [u32; 4],
    pub env_mode: GLenum,
    pub env_color: [f32; 4],
    pub lod_bias: f32,
    pub coord_replace: bool,
    /// ARB_texture_env_combine: RGB, alpha.
    pub combine: [GLenum; 2],
    pub combine_sources: [[GLenum; 3]; 2],
    pub combine_operands: [[GLenum; 3]; 2],
    pub combine_scale: [f32; 2],
    /// S, T, R, Q.
    pub texgen: [TexGen; 4],
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct TextureState {
    pub active: usize,
    pub units: [TextureUnit; MAX_TEXTURE_UNITS],
}

#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct MultisampleState {
    pub enabled: bool,
    pub alpha_to_coverage: bool,
    pub alpha_to_one: bool,
    pub sample_coverage: bool,
    pub coverage_value: f32,
    pub coverage_invert: bool,
}

/// Pixel store (3.6.1, 4.3.2).
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs)]
pub struct PixelStore {
    pub swap_bytes: bool,
    pub lsb_first: bool,
    pub row_length: i32,
    pub image_height: i32,
    pub skip_rows: i32,
    pub skip_pixels: i32,
    pub skip_images: i32,
    pub alignment: i32,
}

/// A matrix stack; the top is the last element, never empty.
#[derive(Clone, Debug)]
pub struct MatrixStack {
    /// From the bottom.
    pub stack: Vec<Mat4>,
    /// Most entries.
    pub limit: usize,
}

impl MatrixStack {
    /// A stack of one identity.
    pub fn new(limit: usize) -> MatrixStack {
        MatrixStack { stack: vec![Mat4::IDENTITY], limit }
    }
    /// The top.
    pub fn top(&self) -> &Mat4 {
        self.stack.last().expect("a matrix stack is never empty")
    }
    /// The top, to change.
    pub fn top_mut(&mut self) -> &mut Mat4 {
        self.stack.last_mut().expect("a matrix stack is never empty")
    }
}

impl Default for Light {
    fn default() -> Light {
        Light {
            enabled: false,
            ambient: [0.0, 0.0, 0.0, 1.0],
            diffuse: [0.0, 0.0, 0.0, 1.0],
            specular: [0.0, 0.0, 0.0, 1.0],
            position: Vec4::new(0.0, 0.0, 1.0, 0.0),
            spot_direction: Vec3::new(0.0, 0.0, -1.0),
            spot_exponent: 0.0,
            spot_cutoff: 180.0,
            attenuation: [1.0, 0.0, 0.0],
        }
    }
}

impl Default for Material {
    fn default() -> Material {
        Material {
            ambient: [0.2, 0.2, 0.2, 1.0],
            diffuse: [0.8, 0.8, 0.8, 1.0],
            specular: [0.0, 0.0, 0.0, 1.0],
            emission: [0.0, 0.0, 0.0, 1.0],
            shininess: 0.0,
            color_indexes: [0.0, 1.0, 1.0],
        }
    }
}

impl Default for StencilSide {
    fn default() -> StencilSide {
        StencilSide {
            func: GL_ALWAYS,
            reference: 0,
            value_mask: STENCIL_MASK,
            write_mask: STENCIL_MASK,
            fail: GL_KEEP,
            depth_fail: GL_KEEP,
            depth_pass: GL_KEEP,
        }
    }
}

impl Default for TextureUnit {
    fn default() -> TextureUnit {
        let gen_plane = |coordinate: usize| {
            let plane = match coordinate {
                0 => Vec4::X,
                1 => Vec4::Y,
                _ => Vec4::ZERO,
            };
            TexGen { enabled: false, mode: GL_EYE_LINEAR, object_plane: plane, eye_plane: plane }
        };
        TextureUnit {
            enabled: [false; 4],
            bound: [0; 4],
            env_mode: GL_MODULATE,
            env_color: [0.0; 4],
            lod_bias: 0.0,
            coord_replace: false,
            combine: [GL_MODULATE; 2],
            combine_sources: [[GL_TEXTURE, GL_PREVIOUS, GL_CONSTANT]; 2],
            combine_operands: [[GL_SRC_COLOR, GL_SRC_COLOR, GL_SRC_ALPHA], [GL_SRC_ALPHA; 3]],
            combine_scale: [1.0; 2],
            texgen: [gen_plane(0), gen_plane(1), gen_plane(2), gen_plane(3)],
        }
    }
}

impl Default for PixelStore {
    fn default() -> PixelStore {
        PixelStore {
            swap_bytes: false,
            lsb_first: false,
            row_length: 0,
            image_height: 0,
            skip_rows: 0,
            skip_pixels: 0,
            skip_images: 0,
            alignment: 4,
        }
    }
}

impl Default for State {
    fn default() -> State {
        let mut attributes = [[0.0, 0.0, 0.0, 1.0]; 16];
        attributes[2] = [0.0, 0.0, 1.0, 1.0];
        attributes[3] = [1.0; 4];
        let mut lights: [Light; MAX_LIGHTS] = Default::default();
        lights[0].diffuse = [1.0; 4];
        lights[0].specular = [1.0; 4];
        State {
            current: Current {
                attributes,
                index: 1.0,
                edge_flag: true,
                raster: RasterPos {
                    position: [0.0, 0.0, 0.0, 1.0],
                    distance: 0.0,
                    color: [1.0; 4],
                    secondary_color: [0.0, 0.0, 0.0, 1.0],
                    tex_coords: [[0.0, 0.0, 0.0, 1.0]; MAX_TEXTURE_UNITS],
                    index: 1.0,
                    valid: true,
                },
            },
            point: PointState {
                size: 1.0,
                smooth: false,
                size_min: 0.0,
                size_max: 255.0,
                fade_threshold: 1.0,
                attenuation: [1.0, 0.0, 0.0],
                sprite: false,
                sprite_origin: GL_UPPER_LEFT,
            },
            line: LineState { width: 1.0, smooth: false, stipple: false, stipple_factor: 1, stipple_pattern: 0xffff },
            polygon: PolygonState {
                cull: false,
                cull_mode: GL_BACK,
                front_face: GL_CCW,
                mode: [GL_FILL; 2],
                smooth: false,
                stipple: false,
                offset_fill: false,
                offset_line: false,
                offset_point: false,
                offset_factor: 0.0,
                offset_units: 0.0,
            },
            polygon_stipple: [!0; 32],
            pixel: PixelState {
                map_color: false,
                map_stencil: false,
                index_shift: 0,
                index_offset: 0,
                scale: [1.0; 4],
                bias: [0.0; 4],
                depth_scale: 1.0,
                depth_bias: 0.0,
                zoom: [1.0; 2],
                maps: std::array::from_fn(|_| vec![0.0]),
                read_buffer: GL_FRONT,
            },
            lighting: LightingState {
                enabled: false,
                lights,
                model_ambient: [0.2, 0.2, 0.2, 1.0],
                local_viewer: false,
                two_side: false,
                color_control: GL_SINGLE_COLOR,
                materials: Default::default(),
                color_material: false,
                color_material_face: GL_FRONT_AND_BACK,
                color_material_mode: GL_AMBIENT_AND_DIFFUSE,
                shade_model: GL_SMOOTH,
                color_sum: false,
            },
            fog: FogState {
                enabled: false,
                mode: GL_EXP,
                color: [0.0; 4],
                density: 1.0,
                start: 0.0,
                end: 1.0,
                index: 0.0,
                coord_source: GL_FRAGMENT_DEPTH,
            },
            depth: DepthState { test: false, func: GL_LESS, write: true, clear: 1.0 },
            accum_clear: [0.0; 4],
            stencil: StencilState { test: false, sides: Default::default(), clear: 0 },
            viewport: ViewportState { x: 0, y: 0, width: 0, height: 0, near: 0.0, far: 1.0 },
            transform: TransformState {
                matrix_mode: GL_MODELVIEW,
                normalize: false,
                rescale_normal: false,
                clip_planes: [Vec4::ZERO; MAX_CLIP_PLANES],
                clip_enabled: [false; MAX_CLIP_PLANES],
            },
            color_buffer: ColorBufferState {
                alpha_test: false,
                alpha_func: GL_ALWAYS,
                alpha_ref: 0.0,
                blend: false,
                blend_func: [GL_ONE, GL_ZERO, GL_ONE, GL_ZERO],
                blend_equation: [GL_FUNC_ADD; 2],
                blend_color: [0.0; 4],
                dither: true,
                index_logic_op: false,
                color_logic_op: false,
                logic_op: GL_COPY,
                draw_buffers: std::array::from_fn(|k| if k == 0 { GL_FRONT } else { GL_NONE }),
                color_mask: [true; 4],
                index_mask: !0,
                clear_color: [0.0; 4],
                clear_index: 0.0,
            },
            hint: HintState {
                perspective_correction: GL_DONT_CARE,
                point_smooth: GL_DONT_CARE,
                line_smooth: GL_DONT_CARE,
                polygon_smooth: GL_DONT_CARE,
                fog: GL_DONT_CARE,
                generate_mipmap: GL_DONT_CARE,
                texture_compression: GL_DONT_CARE,
                fragment_derivative: GL_DONT_CARE,
            },
            eval: EvalState {
                auto_normal: false,
                map1: [false; 9],
                map2: [false; 9],
                grid1_divisions: 1,
                grid1_domain: [0.0, 1.0],
                grid2_divisions: [1, 1],
                grid2_domain: [0.0, 1.0, 0.0, 1.0],
            },
            list_base: 0,
            scissor: ScissorState { test: false, x: 0, y: 0, width: 0, height: 0 },
            texture: TextureState { active: 0, units: Default::default() },
            multisample: MultisampleState {
                enabled: true,
                alpha_to_coverage: false,
                alpha_to_one: false,
                sample_coverage: false,
                coverage_value: 1.0,
                coverage_invert: false,
            },
            pack: PixelStore::default(),
            unpack: PixelStore::default(),
        }
    }
}
