//! The fine stage's kernel: a key that says what its segment needs, and the text that holds only that.

use std::fmt::Write;

use super::adapter::Shape;
use super::glue::{Planes, glue};
use super::source::{Options, expand, files};
use super::stage::{round_constant, shape_flags};
use super::texture::{self, TextureClass};
use crate::device::{ColorFormat, DepthFormat, samples};
use crate::program::Program;
use crate::raster::layout::blend_factor::{self, ONE_MINUS_SRC_ALPHA, SRC_ALPHA};
use crate::raster::layout::compare;

/// What a fine kernel contains: bits of [`FineKey::features`].
#[allow(missing_docs)]
pub mod feature {
    /// The surface has depth or stencil, and some draw looks at it.
    pub const DEPTH_BUFFER: u32 = 1;
    pub const DEPTH_TEST: u32 = 1 << 1;
    pub const DEPTH_WRITE: u32 = 1 << 2;
    pub const STENCIL_TEST: u32 = 1 << 3;
    pub const ALPHA_TEST: u32 = 1 << 4;
    pub const BLEND: u32 = 1 << 5;
    pub const LOGIC_OP: u32 = 1 << 6;
    /// Some draw masks colour components.
    pub const COLOR_MASK: u32 = 1 << 7;
    pub const STIPPLE: u32 = 1 << 8;
    /// Some triangle needs the division by w.
    pub const PERSPECTIVE: u32 = 1 << 9;
    /// The program has to run: colour is written, or it may discard.
    pub const SHADES: u32 = 1 << 10;
    /// Colour is written.
    pub const COLOR_WRITE: u32 = 1 << 11;
    /// Draws differ in what is on: their flags are looked at.
    pub const MIXED: u32 = 1 << 12;
    /// Draws differ in the interpolation of varyings, but run the same program: each draw's record says which are perspective.
    pub const MIXED_INTERPOLATION: u32 = 1 << 13;
    /// Some triangle may reach beyond the scissor: its bounds are looked at beside its edges.
    pub const CUT: u32 = 1 << 14;
    /// Some draw leaves samples out.
    pub const DROPS_SAMPLES: u32 = 1 << 15;
    pub const ALPHA_TO_COVERAGE: u32 = 1 << 16;
    pub const ALPHA_TO_ONE: u32 = 1 << 17;
    /// Some draw has a depth range other than 0 to 1.
    pub const DEPTH_RANGE: u32 = 1 << 18;
    /// Some draw has a polygon offset.
    pub const OFFSET: u32 = 1 << 19;
    /// Most triangles fill most rows of their tiles: a column kernel draws all eight.
    pub const TALL: u32 = 1 << 20;
    /// Some draw takes all samples at the centre of the pixel.
    pub const CENTRES: u32 = 1 << 21;
    /// All triangles are of one draw, whose words a subgroup of the resolving kernel loads once.
    pub const ONE_DRAW: u32 = 1 << 22;
    /// Few triangles: there are no lists, each tile looks at all of them.
    pub const DIRECT: u32 = 1 << 23;
}

/// Blending of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BlendKey {
    /// The same in all draws that blend: factors, equations.
    Fixed([u32; 4], [u32; 2]),
    /// Looked up for each triangle.
    Dynamic,
}

/// A fine kernel.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct FineKey {
    /// The fragment program's id.
    pub program: u64,
    /// Colour storage.
    pub color: ColorFormat,
    /// `feature::*`
    pub features: u32,
    /// How it blends.
    pub blend: BlendKey,
    /// Depth function, where all draws that test have the same.
    pub depth_func: Option<u32>,
    /// Bits of depth; 32: floating point.
    pub depth_bits: u32,
    /// What each texture slot needs.
    pub textures: Vec<TextureClass>,
    /// Samples of a pixel.
    pub samples: u32,
}

/// What `shaders/color.wgsl` and `shaders/blend.wgsl` have to know of a format.
pub fn color_flags(options: &mut Options, color: ColorFormat) {
    options.flag(
        match color {
            ColorFormat::Rgba8 => "COLOR_RGBA8",
            ColorFormat::Rgbx8 => "COLOR_RGBX8",
            ColorFormat::Rgb565 => "COLOR_RGB565",
            ColorFormat::Rgba16 => "COLOR_RGBA16",
            ColorFormat::Rgba32f => "COLOR_RGBA32F",
        },
        true,
    );
    options.flag(["COLOR_WORDS_1", "COLOR_WORDS_2", "", "COLOR_WORDS_4"][color.words() - 1], true);
    options.flag("COLOR_UNORM", color != ColorFormat::Rgba32f);
    options.flag("COLOR_8BIT", matches!(color, ColorFormat::Rgba8 | ColorFormat::Rgbx8));
}

impl FineKey {
    /// The text of a fine kernel.
    pub fn source(&self, shape: Shape, program: &Program, constants: &str) -> String {
        let shape = self.shape(shape);
        let (mut options, extra) = self.options(shape, program, Planes::Loaded);
        let deferred = self.is_deferred(shape, program);
        if deferred {
            // Depth comes first, and the rest later.
            let of = |features: u32| glue(program, &FineKey { features: self.features & features, ..self.clone() }, shape, Planes::Loaded);
            let (depth, color) = (of(feature::DEPTH_TEST | feature::OFFSET), of(!feature::DEPTH_TEST));
            options.inserts.insert("DEPTH_PLANES", depth.planes);
            options.inserts.insert("DEPTH", depth.depth);
            options.inserts.insert("PLANES", color.planes);
            options.inserts.insert("SHADE", color.depth + &color.shade);
        }
        let mut source = format!("const TP_LANES = {}u;\nconst TP_TEAMS = {}u;\n{extra}{constants}", shape.fine_lanes, shape.teams());
        for file in [files::COMMON, files::ARITHMETIC] {
            expand(file, &options, &mut source);
        }
        self.shading(&options, program, &mut source);
        if shape.vectors() {
            if self.features & feature::DIRECT != 0 {
                expand(files::IN_BIN, &options, &mut source);
            }
            expand(files::FINE, &options, &mut source);
        } else {
            expand(files::COLUMN, &options, &mut source);
            expand(if deferred { files::FINE_DEFERRED } else { files::FINE_COLUMN }, &options, &mut source);
        }
        source
    }

    /// Whether of a pixel's fragments only the last that passes the depth test is seen, and depth alone decides which that is.
    pub fn is_opaque(&self, program: &Program) -> bool {
        let wanted = feature::DEPTH_TEST | feature::DEPTH_WRITE | feature::COLOR_WRITE | feature::SHADES;
        let allowed = wanted
            | feature::DEPTH_BUFFER
            | feature::PERSPECTIVE
            | feature::MIXED_INTERPOLATION
            | feature::CUT
            | feature::DEPTH_RANGE
            | feature::OFFSET;
        let same_test = self.depth_func.is_some() && self.samples == 1;
        self.features & wanted == wanted && self.features & !allowed == 0 && same_test && !program.discards && !program.writes_depth
    }

    /// Whether the kernel is that of `shaders/fine_deferred.wgsl`.
    fn is_deferred(&self, shape: Shape, program: &Program) -> bool {
        !shape.vectors() && self.features & feature::DEPTH_RANGE == 0 && self.is_opaque(program)
    }

    /// Whether a kernel may have a text for each row of a tile. With textures that would be long; a deferred one shades rows by one text.
    pub fn unrolls(&self, shape: Shape, program: &Program) -> bool {
        !shape.vectors() && self.samples == 1 && self.textures.is_empty() && !self.is_deferred(shape, program)
    }

    /// The shape that serves the key: on a GPU, a lane that holds many samples has room for one pixel only.
    fn shape(&self, shape: Shape) -> Shape {
        let fine_lanes = if self.samples >= 8 && shape.vectors() { 64 } else { shape.fine_lanes };
        Shape { fine_lanes, ..shape }
    }

    /// Appends the per-fragment operations and the program.
    pub fn shading(&self, options: &Options, program: &Program, source: &mut String) {
        for file in [files::COLOR, files::FRAGMENT_OPS, files::BLEND] {
            expand(file, options, source);
        }
        if self.features & feature::SHADES != 0 {
            if !self.textures.is_empty() {
                texture::splice(&self.textures, options, source);
            }
            source.push_str(&program.wgsl);
            source.push('\n');
        }
    }

    /// Flags, texts to insert, and constants.
    pub fn options(&self, shape: Shape, program: &Program, planes: Planes) -> (Options, String) {
        let mut options = Options { samples: self.samples, ..Options::default() };
        options.flag("SAMPLES", self.samples > 1);
        let on = |bit: u32| self.features & bit != 0;
        for (name, bit) in [
            ("DEPTH_BUFFER", feature::DEPTH_BUFFER),
            ("DEPTH_TEST", feature::DEPTH_TEST),
            ("DEPTH_WRITE", feature::DEPTH_WRITE),
            ("STENCIL_TEST", feature::STENCIL_TEST),
            ("ALPHA_TEST", feature::ALPHA_TEST),
            ("BLEND", feature::BLEND),
            ("LOGIC_OP", feature::LOGIC_OP),
            ("COLOR_MASK", feature::COLOR_MASK),
            ("STIPPLE", feature::STIPPLE),
            ("SHADES", feature::SHADES),
            ("COLOR_WRITE", feature::COLOR_WRITE),
            ("STATE_FLAGS", feature::MIXED),
            ("MIXED_INTERPOLATION", feature::MIXED_INTERPOLATION),
            ("CUT", feature::CUT),
            ("DROPS_SAMPLES", feature::DROPS_SAMPLES),
            ("ALPHA_TO_COVERAGE", feature::ALPHA_TO_COVERAGE),
            ("ALPHA_TO_ONE", feature::ALPHA_TO_ONE),
            ("DEPTH_RANGE", feature::DEPTH_RANGE),
            ("OFFSET", feature::OFFSET),
            ("TALL", feature::TALL),
            ("CENTRES", feature::CENTRES),
            ("ONE_DRAW", feature::ONE_DRAW),
            ("DIRECT", feature::DIRECT),
            ("TRIANGLES", feature::DIRECT),
            ("TRIANGLE_VECTORS", feature::DIRECT),
        ] {
            options.flag(name, on(bit));
        }
        // Of one sample: what is only written need not be read before.
        let reads = feature::BLEND | feature::LOGIC_OP | feature::COLOR_MASK;
        options.flag("READS_COLOR", self.features & reads != 0);
        let writes_depth = program.writes_depth && on(feature::SHADES) && on(feature::DEPTH_TEST);
        options.flag("WRITES_DEPTH", writes_depth);
        options.flag("SAMPLE_DEPTH", on(feature::DEPTH_TEST) && !writes_depth);
        // The stencil buffer changes where the depth test fails, but not where the program or the alpha test kills.
        options.flag("NEEDS_KILL_FIRST", on(feature::STENCIL_TEST) && (program.discards || on(feature::ALPHA_TEST)));
        options.flag("TEXTURES", on(feature::SHADES) && !self.textures.is_empty());
        // Pixels whose samples are all nearer than a triangle are passed by, on a GPU: where an `if` saves nothing, the look costs. With eight
        // samples, one branch behind coverage is faster than two.
        let nearer_wins = matches!(self.depth_func, Some(compare::LESS | compare::LEQUAL)) && !on(feature::MIXED);
        let rejects =
            self.samples > 1 && shape.vectors() && nearer_wins && on(feature::DEPTH_TEST) && !writes_depth && !on(feature::STENCIL_TEST);
        options.flag("REJECTS", rejects);
        options.flag("REJECTS_LATE", rejects && self.samples == 8);
        let mut extra = round_constant(shape);
        let float_depth = self.depth_bits == DepthFormat::F32.bits();
        options.flag("FLOAT_DEPTH", float_depth);
        let (scale, mask) = if float_depth { (1, !0) } else { ((1u64 << self.depth_bits) - 1, 0xff_ffffu32) };
        let _ = writeln!(extra, "const TP_DEPTH_SCALE = {scale}.0;\nconst TP_DEPTH_MASK = {mask}u;");
        if let Some(func) = self.depth_func {
            options.flag("DEPTH_FUNC_FIXED", true);
            let _ = writeln!(extra, "const TP_DEPTH_FUNC = {func}u;");
        }
        options.flag("DEPTH_CHANGES", on(feature::DEPTH_BUFFER) && (on(feature::DEPTH_WRITE) || on(feature::STENCIL_TEST)));
        options.flag("SELECTS_ROW", !shape.vectors() && self.samples == 1 && !on(feature::TALL));
        // A workgroup of one subgroup: 64 lanes are two.
        options.flag("BALLOT", on(feature::DIRECT) && shape.subgroup32 && shape.fine_lanes == 32);
        options.flag("PAIRS", shape.subgroup8);
        options.flag("VECTORS", planes == Planes::Loaded && shape.vectors());
        shape_flags(&mut options, shape);
        color_flags(&mut options, self.color);
        let _ = writeln!(extra, "const TP_SAMPLES = {}u;", self.samples);
        for (k, [x, y]) in samples::positions(self.samples).iter().enumerate() {
            let _ = writeln!(extra, "const TP_SAMPLE_X{k} = {x};\nconst TP_SAMPLE_Y{k} = {y};");
        }
        let mut second = on(feature::DROPS_SAMPLES);
        match self.blend {
            _ if !on(feature::BLEND) => {}
            BlendKey::Dynamic => {
                options.flag("BLEND_DYNAMIC", true);
                options.flag("BLEND_CONSTANT", true);
                second = true;
            }
            BlendKey::Fixed(f, e) => {
                let constant = f.iter().any(|&f| f >= blend_factor::CONSTANT_COLOR);
                options.flag("BLEND_CONSTANT", constant);
                second |= constant;
                let eight_bits = self.color == ColorFormat::Rgba8 && !on(feature::MIXED) && !on(feature::LOGIC_OP);
                let over = f == [SRC_ALPHA, ONE_MINUS_SRC_ALPHA, SRC_ALPHA, ONE_MINUS_SRC_ALPHA] && e == [0; 2];
                // In floats where integers are slower, two bytes at a time elsewhere. Some compilers without fused operations drop
                // additions that only round, so that the first is not for them.
                // They take four registers a sample.
                let floats = shape.fuses && self.samples <= 8;
                options.flag("FLOAT_PIXELS", eight_bits && over && floats);
                options.flag("BLEND_ALPHA", eight_bits && over && !floats);
                options.flag("BLEND_UNIFORM", f[0] == f[2] && f[1] == f[3] && e[0] == e[1]);
                let _ = writeln!(extra, "const TP_BLEND_FACTORS = vec4<u32>({}u, {}u, {}u, {}u);", f[0], f[1], f[2], f[3]);
                let _ = writeln!(extra, "const TP_BLEND_EQUATIONS = vec2<u32>({}u, {}u);", e[0], e[1]);
            }
        }
        // The second eight words of a draw's state.
        options.flag("STATE_SECOND", second);
        let glue = glue(program, self, shape, planes);
        options.inserts.insert("TEXTURES", texture::loads(&self.textures));
        options.inserts.insert("PLANES", glue.planes);
        options.inserts.insert("DEPTH", glue.depth);
        options.inserts.insert("SHADE", glue.shade);
        (options, extra)
    }
}
