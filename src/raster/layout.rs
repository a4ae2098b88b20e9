//! The records that the stages exchange. Every record is plain words (`u32`, `i32`, `f32`), so that the Rust stages
//! and the WGSL kernels share one layout: the kernels' word offsets are generated from these.
//!
//! Raster space is the space of the surface's rows: x to the right, y with the row index, pixel centres at half
//! integers. A window surface is stored top row first, so GL's y axis is flipped by the viewport transform; a
//! framebuffer object is stored bottom row first and is not flipped.

use bytemuck::{Pod, Zeroable};

/// Subpixel bits of a snapped coordinate (GL_SUBPIXEL_BITS).
pub const SUBPIXEL_BITS: u32 = 8;
/// Side of a bin in pixels.
pub const BIN_SIZE: u32 = 64;
/// Side of a tile in pixels: one coverage mask of 64 bits.
pub const TILE_SIZE: u32 = 8;
/// Vertex attribute slots, in the numbering of NV_vertex_program: 0 position, 2 normal, 3 colour, 4 secondary
/// colour, 5 fog coordinate, 6 edge flag, 8 to 15 texture coordinate sets.
pub const ATTRIBUTES: usize = 16;
/// Most varyings (vec4) that a fragment program reads.
pub const MAX_VARYINGS: usize = 16;
/// "Not there", for offsets and indices.
pub const NONE: u32 = u32::MAX;

/// One primitive after assembly: up to three vertices, relative to the first vertex of its draw. Points use `v[0]`,
/// lines `v[0], v[1]`. The last vertex used is the provoking one.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
pub struct Primitive {
    /// Vertex numbers, counted from the draw's first vertex.
    pub v: [u32; 3],
    /// Bits 0 to 23: index into the batch's draws; above: `PRIM_*` flags.
    pub draw_and_flags: u32,
}
/// Mask of the draw index in [`Primitive::draw_and_flags`].
pub const PRIM_DRAW_MASK: u32 = 0x00ff_ffff;
/// The edge v0 → v1 is a boundary edge (edge flag); v1 → v2 and v2 → v0 are the next two bits.
pub const PRIM_EDGE_01: u32 = 1 << 24;
/// The edge v1 → v2 is a boundary edge.
pub const PRIM_EDGE_12: u32 = 1 << 25;
/// The edge v2 → v0 is a boundary edge.
pub const PRIM_EDGE_20: u32 = 1 << 26;
/// The line stipple counter restarts at this primitive (first line of a Begin, each line of GL_LINES, each polygon).
pub const PRIM_RESET_STIPPLE: u32 = 1 << 27;

/// Topology of a draw after assembly, `DrawRecord::topology`.
pub mod topology {
    /// `v[0]`
    pub const POINTS: u32 = 0;
    /// `v[0], v[1]`
    pub const LINES: u32 = 1;
    /// all three
    pub const TRIANGLES: u32 = 2;
}

/// What a draw needs to know, in words: where its vertices lie, how they are transformed, which states apply.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct DrawRecord {
    /// First word of the draw's first vertex in `Batch::vertices`.
    pub vertex_word: u32,
    /// Words from one vertex to the next.
    pub vertex_stride: u32,
    /// Number of vertices.
    pub vertex_count: u32,
    /// `topology::*`
    pub topology: u32,
    /// Word offset in the vertex of each attribute, [`NONE`] where the attribute is constant.
    pub attribute_offset: [u32; ATTRIBUTES],
    /// Components stored (1 to 4) of each attribute; the rest reads as (0, 0, 0, 1).
    pub attribute_size: [u32; ATTRIBUTES],
    /// Index in `Batch::uniforms` of 16 vec4: the values of the constant attributes.
    pub constants: u32,
    /// Index in `Batch::uniforms` of the vertex program's block.
    pub vertex_uniforms: u32,
    /// Index in `Batch::uniforms` of the fragment program's block.
    pub fragment_uniforms: u32,
    /// Index into `Batch::raster_states`.
    pub raster_state: u32,
    /// Index into `Batch::fragment_states`.
    pub fragment_state: u32,
    /// First texture binding of the draw in `Batch::textures`; unit slot `k` of the fragment program is `first_texture + k`.
    pub first_texture: u32,
    /// First vec4 of the draw's shaded vertices in the vertex stage's output.
    pub shaded_base: u32,
    /// vec4 per shaded vertex: the clip position, then the vertex program's outputs in their order.
    pub shaded_stride: u32,
    /// vec4 index in a shaded vertex of the first clip distances (4 a vec4), [`NONE`] without user clip planes.
    pub clip_distances: u32,
    /// Number of user clip distances (0 to 8).
    pub clip_distance_count: u32,
    /// vec4 index in a shaded vertex of the point size (in x), [`NONE`] where the size is the state's.
    pub point_size: u32,
    /// Varyings that the fragment program reads (0 to 16).
    pub varying_count: u32,
    /// For each varying: bits 0-7 the vec4 index in a shaded vertex, bits 8-15 the one for back faces (the same
    /// where there is no two-sided lighting), bits 16-17 `interpolation::*`.
    pub varyings: [u32; MAX_VARYINGS],
}

/// How a varying runs over a primitive.
pub mod interpolation {
    /// Constant, from the provoking vertex.
    pub const FLAT: u32 = 0;
    /// Linear in clip space: a/w and 1/w are linear on the screen.
    pub const PERSPECTIVE: u32 = 1;
    /// Linear on the screen.
    pub const LINEAR: u32 = 2;
    /// Made by set-up, linear on the screen: how much of a pixel an antialiased point or line covers. Of a line: distance across
    /// from its middle, half its width plus one half, distance along, half its length plus one half. Of a point: distance in x,
    /// radius plus one half, distance in y. (0, 1, 0, 1), full coverage, of everything else.
    pub const COVERAGE: u32 = 3;
}

/// State of the stages from clipping to set-up.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct RasterState {
    /// `raster_flags::*`
    pub flags: u32,
    /// Polygon mode of front and of back faces: `topology::POINTS`, `LINES` or `TRIANGLES` (filled).
    pub polygon_mode: [u32; 2],
    /// Low 16 bits: line stipple pattern; high 16: factor (1 to 256).
    pub line_stipple: u32,
    /// Window x, y, z = ndc * scale + translate, in raster space (fused multiply-add).
    pub viewport_scale: [f32; 3],
    /// See `viewport_scale`.
    pub viewport_translate: [f32; 3],
    /// First column and row that may be written (scissor and surface).
    pub scissor_min: [i32; 2],
    /// One past the last column and row that may be written.
    pub scissor_max: [i32; 2],
    /// Polygon offset factor.
    pub offset_factor: f32,
    /// Polygon offset units, times the smallest resolvable depth difference: in window z.
    pub offset_units: f32,
    /// Line width in pixels.
    pub line_width: f32,
    /// Point size in pixels, where the vertex program does not write it.
    pub point_size: f32,
    /// Least and greatest of the depth range: the interval that depth is clamped to.
    pub depth_range: [f32; 2],
    /// Index into `Batch::polygon_stipples` of the 32 rows, [`NONE`] when off. Row 0 belongs to GL window row 0.
    pub polygon_stipple: u32,
    /// Reserved, zero.
    pub reserved: u32,
}

/// Flags of [`RasterState`].
pub mod raster_flags {
    /// Front faces are not drawn.
    pub const CULL_FRONT: u32 = 1;
    /// Back faces are not drawn.
    pub const CULL_BACK: u32 = 1 << 1;
    /// Front faces are counter-clockwise in GL's window space (y up).
    pub const FRONT_CCW: u32 = 1 << 2;
    /// Polygon offset applies to points.
    pub const OFFSET_POINT: u32 = 1 << 3;
    /// Polygon offset applies to lines.
    pub const OFFSET_LINE: u32 = 1 << 4;
    /// Polygon offset applies to filled polygons.
    pub const OFFSET_FILL: u32 = 1 << 5;
    /// Antialiased points.
    pub const POINT_SMOOTH: u32 = 1 << 6;
    /// Antialiased lines.
    pub const LINE_SMOOTH: u32 = 1 << 7;
    /// Line stipple is on.
    pub const LINE_STIPPLE: u32 = 1 << 8;
    /// Rectangle in raster space, not transformed or clipped: vertices are window coordinates (pixel paths).
    pub const WINDOW_SPACE: u32 = 1 << 9;
    /// Near and far planes do not clip (ARB_depth_clamp; pixel rectangles).
    pub const NO_Z_CLIP: u32 = 1 << 10;
    /// Each sample of a pixel is covered on its own; otherwise all are where the pixel's centre is. Only on surfaces with several samples.
    pub const MULTISAMPLE: u32 = 1 << 11;
    /// Units of polygon offset are steps of floating-point depths, which depend on the polygon.
    pub const FLOAT_DEPTH: u32 = 1 << 12;
}

/// State of the per-fragment operations.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct FragmentState {
    /// `fragment_flags::*`
    pub flags: u32,
    /// `compare::*`
    pub depth_func: u32,
    /// `compare::*`
    pub alpha_func: u32,
    /// Reference of the alpha test.
    pub alpha_ref: f32,
    /// Front and back stencil state.
    pub stencil: [StencilFace; 2],
    /// `blend_factor::*`: source RGB, destination RGB, source alpha, destination alpha.
    pub blend_factors: [u32; 4],
    /// `blend_equation::*` for RGB and alpha.
    pub blend_equations: [u32; 2],
    /// `logic_op`: GL's op minus GL_CLEAR (0 to 15).
    pub logic_op: u32,
    /// Bits 0 to 3: red, green, blue, alpha may be written.
    pub color_mask: u32,
    /// Constant blend colour.
    pub blend_color: [f32; 4],
    /// Samples that are never written (the sample coverage): a bit each.
    pub dropped_samples: u32,
}

/// Stencil state of one face.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct StencilFace {
    /// `compare::*`
    pub func: u32,
    /// Reference value, 0 to 255.
    pub reference: u32,
    /// Mask of the comparison.
    pub read_mask: u32,
    /// Mask of the writes.
    pub write_mask: u32,
    /// `stencil_op::*` when the stencil test fails, when the depth test fails, when both pass.
    pub ops: [u32; 3],
    /// Reserved, zero.
    pub reserved: u32,
}

/// Flags of [`FragmentState`].
pub mod fragment_flags {
    /// Depth test on (and a depth buffer there).
    pub const DEPTH_TEST: u32 = 1;
    /// Depth is written where the test passes.
    pub const DEPTH_WRITE: u32 = 1 << 1;
    /// Stencil test on (and a stencil buffer there).
    pub const STENCIL_TEST: u32 = 1 << 2;
    /// Alpha test on.
    pub const ALPHA_TEST: u32 = 1 << 3;
    /// Blending on.
    pub const BLEND: u32 = 1 << 4;
    /// Logic op on (blending is then off).
    pub const LOGIC_OP: u32 = 1 << 5;
    /// Of n samples, sample k is covered only where alpha is greater than k / n.
    pub const ALPHA_TO_COVERAGE: u32 = 1 << 6;
    /// Alpha counts as 1 after that.
    pub const ALPHA_TO_ONE: u32 = 1 << 7;
}

/// Comparison functions: GL's function minus GL_NEVER.
#[allow(missing_docs)]
pub mod compare {
    pub const NEVER: u32 = 0;
    pub const LESS: u32 = 1;
    pub const EQUAL: u32 = 2;
    pub const LEQUAL: u32 = 3;
    pub const GREATER: u32 = 4;
    pub const NOTEQUAL: u32 = 5;
    pub const GEQUAL: u32 = 6;
    pub const ALWAYS: u32 = 7;
}

/// Stencil operations.
#[allow(missing_docs)]
pub mod stencil_op {
    pub const KEEP: u32 = 0;
    pub const ZERO: u32 = 1;
    pub const REPLACE: u32 = 2;
    pub const INCR: u32 = 3;
    pub const DECR: u32 = 4;
    pub const INVERT: u32 = 5;
    pub const INCR_WRAP: u32 = 6;
    pub const DECR_WRAP: u32 = 7;
}

/// Blend factors.
#[allow(missing_docs)]
pub mod blend_factor {
    pub const ZERO: u32 = 0;
    pub const ONE: u32 = 1;
    pub const SRC_COLOR: u32 = 2;
    pub const ONE_MINUS_SRC_COLOR: u32 = 3;
    pub const SRC_ALPHA: u32 = 4;
    pub const ONE_MINUS_SRC_ALPHA: u32 = 5;
    pub const DST_ALPHA: u32 = 6;
    pub const ONE_MINUS_DST_ALPHA: u32 = 7;
    pub const DST_COLOR: u32 = 8;
    pub const ONE_MINUS_DST_COLOR: u32 = 9;
    pub const SRC_ALPHA_SATURATE: u32 = 10;
    pub const CONSTANT_COLOR: u32 = 11;
    pub const ONE_MINUS_CONSTANT_COLOR: u32 = 12;
    pub const CONSTANT_ALPHA: u32 = 13;
    pub const ONE_MINUS_CONSTANT_ALPHA: u32 = 14;
}

/// Blend equations.
#[allow(missing_docs)]
pub mod blend_equation {
    pub const ADD: u32 = 0;
    pub const SUBTRACT: u32 = 1;
    pub const REVERSE_SUBTRACT: u32 = 2;
    pub const MIN: u32 = 3;
    pub const MAX: u32 = 4;
}

/// A set-up triangle: what binning and the fine stage read. Points and lines arrive as triangles too (a rectangle
/// is two triangles that share a diagonal and one set of planes).
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Pod, Zeroable)]
pub struct Triangle {
    /// Snapped x of the vertices, in 1/256 pixel, relative to the centre of pixel 0; the area is positive.
    pub x: [i32; 3],
    /// Snapped y likewise.
    pub y: [i32; 3],
    /// Index of the draw.
    pub draw: u32,
    /// `triangle_flags::*`
    pub flags: u32,
    /// First and last column that a sample may lie in, inclusive, scissor applied: low and high 16 bits.
    pub columns: u32,
    /// First and last row, likewise.
    pub rows: u32,
    /// Index (vec4) into the planes: first the plane of (z, 1/w), then 3 vec4 (a0, d/dx, d/dy) a varying.
    pub planes: u32,
    /// Index of the primitive that it came from: the order.
    pub primitive: u32,
}

/// Flags of [`Triangle`].
pub mod triangle_flags {
    /// Front-facing.
    pub const FRONT: u32 = 1;
    /// From a polygon: the polygon stipple applies.
    pub const POLYGON: u32 = 1 << 1;
    /// 1/w is not 1 all over the triangle: perspective varyings need the division.
    pub const PERSPECTIVE: u32 = 1 << 2;
    /// Row 0 of the surface is GL's bottom row: decides which horizontal edges are inclusive.
    pub const BOTTOM_UP: u32 = 1 << 3;
    /// The scissor cuts its bounds: coverage has to be looked at against `columns` and `rows`.
    pub const CUT: u32 = 1 << 4;
    /// Each sample of a pixel is covered on its own.
    pub const MULTISAMPLE: u32 = 1 << 5;
}

/// Subpixels from a pixel's centre to the furthest place of a sample: up or left, down or right. See [`crate::device::samples`].
pub const SAMPLE_REACH: [i32; 2] = [128, 112];

/// Planes at the head of a triangle's block: z and 1/w at any pixel, `a0 + dx * x + dy * y` with x, y the integer
/// pixel coordinates, evaluated `fma(y, dy, fma(x, dx, a0))`. 2 vec4.
#[repr(C)]
#[derive(Clone, Copy, Debug, Default, PartialEq, Pod, Zeroable)]
pub struct DepthPlane {
    /// z: a0, d/dx, d/dy
    pub z: [f32; 3],
    /// 1/w: a0
    pub w0: f32,
    /// 1/w: d/dx, d/dy
    pub dw: [f32; 2],
    /// Polygon offset: added to z after the interpolation, as one more rounded sum.
    pub offset: f32,
    /// Reserved, zero.
    pub reserved: f32,
}
/// vec4 that a [`DepthPlane`] takes.
pub const DEPTH_PLANE_VEC4: u32 = 2;
/// vec4 that one varying's planes take.
pub const VARYING_PLANE_VEC4: u32 = 3;
