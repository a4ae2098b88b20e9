//! Recordings: GL state and vertices that are made here and played by `play.c`, so that every implementation, and the oracle,
//! are given the same numbers, bit for bit. The format is described in `play.h`.

use std::fmt::Write;

/// The GL enumerants that recordings use, spelled as in gl.h.
#[allow(missing_docs)]
pub mod gl {
    macro_rules! enumerants { ($($name:ident = $value:expr;)*) => { $(pub const $name: u32 = $value;)* } }
    enumerants! {
        POINTS = 0; LINES = 1; TRIANGLES = 4;
        ZERO = 0; ONE = 1; SRC_COLOR = 0x300; ONE_MINUS_SRC_COLOR = 0x301; SRC_ALPHA = 0x302; ONE_MINUS_SRC_ALPHA = 0x303;
        DST_ALPHA = 0x304; ONE_MINUS_DST_ALPHA = 0x305; DST_COLOR = 0x306; ONE_MINUS_DST_COLOR = 0x307; SRC_ALPHA_SATURATE = 0x308;
        FUNC_ADD = 0x8006; MIN = 0x8007; MAX = 0x8008; FUNC_SUBTRACT = 0x800A; FUNC_REVERSE_SUBTRACT = 0x800B;
        LESS = 0x201; LEQUAL = 0x203; ALWAYS = 0x207;
        KEEP = 0x1E00; INCR = 0x1E02; ALPHA_TEST = 0xBC0; COLOR_LOGIC_OP = 0xBF2; COPY = 0x1503; GEQUAL = 0x206; MODULATE = 0x2100;
        COLOR_BUFFER_BIT = 0x4000; DEPTH_BUFFER_BIT = 0x100;
        MODELVIEW = 0x1700; PROJECTION = 0x1701;
        COLOR_MATERIAL = 0xB57; LIGHTING = 0xB50; FOG = 0xB60; DEPTH_TEST = 0xB71; STENCIL_TEST = 0xB90; NORMALIZE = 0xBA1; BLEND = 0xBE2; SCISSOR_TEST = 0xC11;
        TEXTURE_2D = 0xDE1; POLYGON_STIPPLE = 0xB42; POLYGON_OFFSET_FILL = 0x8037; CLIP_PLANE0 = 0x3000;
        LIGHT0 = 0x4000; AMBIENT = 0x1200; DIFFUSE = 0x1201; SPECULAR = 0x1202; POSITION = 0x1203; SPOT_DIRECTION = 0x1204;
        SPOT_EXPONENT = 0x1205; SPOT_CUTOFF = 0x1206; SHININESS = 0x1601; FRONT_AND_BACK = 0x408;
        LIGHT_MODEL_AMBIENT = 0xB53;
        FOG_DENSITY = 0xB62; FOG_START = 0xB63; FOG_END = 0xB64; FOG_COLOR = 0xB66; EXP = 0x800; EXP2 = 0x801; LINEAR = 0x2601;
        REPLACE = 0x1E01; NEAREST = 0x2600;
        LINEAR_MIPMAP_NEAREST = 0x2701; NEAREST_MIPMAP_LINEAR = 0x2702; LINEAR_MIPMAP_LINEAR = 0x2703; NEAREST_MIPMAP_NEAREST = 0x2700;
        TEXTURE_MAG_FILTER = 0x2800; TEXTURE_MIN_FILTER = 0x2801; TEXTURE_WRAP_S = 0x2802; TEXTURE_WRAP_T = 0x2803; REPEAT = 0x2901;
        TEXTURE_FILTER_CONTROL = 0x8500; TEXTURE_LOD_BIAS = 0x8501; AUTO_NORMAL = 0xD80;
    }
}

/// A column-major matrix, as glLoadMatrixf takes it.
pub type Matrix = [f32; 16];

/// The identity.
pub const IDENTITY: Matrix = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0];

/// How object coordinates become window coordinates.
#[derive(Clone, Debug)]
pub struct View {
    /// The projection matrix.
    pub projection: Matrix,
    /// The model-view matrix.
    pub modelview: Matrix,
    /// x, y, width, height.
    pub viewport: [i32; 4],
    /// Coefficients in eye space of the clip planes that are enabled, while the model-view matrix is the identity.
    pub clip_planes: Vec<[f32; 4]>,
}

impl View {
    /// One unit a pixel, origin at the lower left corner, z from -1 to 1 towards the eye: glOrtho(0, w, 0, h, -1, 1).
    pub fn pixels(width: usize, height: usize) -> View {
        let (w, h) = (width as f32, height as f32);
        View {
            projection: [2.0 / w, 0.0, 0.0, 0.0, 0.0, 2.0 / h, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, -1.0, -1.0, 0.0, 1.0],
            modelview: IDENTITY,
            viewport: [0, 0, width as i32, height as i32],
            clip_planes: Vec::new(),
        }
    }

    /// glFrustum(-r, r, -r, r, near, far) with r = near, a right angle across.
    pub fn perspective(width: usize, height: usize, near: f32, far: f32) -> View {
        let (n, f) = (f64::from(near), f64::from(far));
        let (c, d) = ((-(f + n) / (f - n)) as f32, (-2.0 * f * n / (f - n)) as f32);
        let projection = [1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, c, -1.0, 0.0, 0.0, d, 0.0];
        View { projection, ..View::pixels(width, height) }
    }
}

/// A vertex with everything that it may have.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Vertex {
    /// Object coordinates.
    pub position: [f32; 4],
    /// RGBA.
    pub color: [f32; 4],
    /// The normal.
    pub normal: [f32; 3],
    /// s, t, r, q.
    pub coordinate: [f32; 4],
}

impl Vertex {
    /// A white vertex.
    pub fn new(x: f32, y: f32, z: f32) -> Vertex {
        Vertex { position: [x, y, z, 1.0], color: [1.0; 4], normal: [0.0, 0.0, 1.0], coordinate: [0.0, 0.0, 0.0, 1.0] }
    }

    /// The same with another colour.
    pub fn colored(self, color: [f32; 4]) -> Vertex {
        Vertex { color, ..self }
    }

    /// The same with texture coordinates.
    pub fn textured(self, s: f32, t: f32) -> Vertex {
        Vertex { coordinate: [s, t, 0.0, 1.0], ..self }
    }
}

/// What of a vertex is sent: positions always.
#[allow(missing_docs)]
pub mod has {
    pub const POSITION: u32 = 0;
    pub const COLOR: u32 = 1;
    pub const NORMAL: u32 = 2;
    pub const COORDINATE: u32 = 4;
}

/// A recording that is being written.
#[derive(Clone, Debug)]
pub struct Recording {
    /// Columns of the target.
    pub width: usize,
    /// Rows of the target.
    pub height: usize,
    /// Bits of its depth buffer: 16, 24, or 32 for floating point.
    pub depth_bits: u32,
    bytes: Vec<u8>,
}

impl Recording {
    /// An empty recording for a target of this size.
    pub fn new(width: usize, height: usize, depth_bits: u32) -> Recording {
        Recording { width, height, depth_bits, bytes: format!("target {width} {height} {depth_bits}\n").into_bytes() }
    }

    /// A command with its integers first, then its floats.
    pub fn call(&mut self, name: &str, integers: &[i64], floats: &[f32]) -> &mut Recording {
        let mut line = name.to_owned();
        for i in integers {
            let _ = write!(line, " {i}");
        }
        for f in floats {
            let _ = write!(line, " x{:08x}", f.to_bits());
        }
        self.bytes.extend(line.bytes());
        self.bytes.push(b'\n');
        self
    }

    /// glEnable.
    pub fn enable(&mut self, capability: u32) -> &mut Recording {
        self.call("enable", &[capability.into()], &[])
    }

    /// Loads matrices, viewport and clip planes.
    pub fn view(&mut self, view: &View) -> &mut Recording {
        self.call("viewport", &view.viewport.map(i64::from), &[]);
        self.call("matrix", &[gl::PROJECTION.into()], &view.projection);
        self.call("matrix", &[gl::MODELVIEW.into()], &IDENTITY);
        for (k, plane) in view.clip_planes.iter().enumerate() {
            self.call("clip_plane", &[k as i64], plane).enable(gl::CLIP_PLANE0 + k as u32);
        }
        self.call("matrix", &[gl::MODELVIEW.into()], &view.modelview)
    }

    /// Every sample counts in the stencil buffer how often it is hit, whatever its depth.
    pub fn count_hits(&mut self) -> &mut Recording {
        let [always, all, incr] = [gl::ALWAYS, 0xff, gl::INCR].map(i64::from);
        self.enable(gl::STENCIL_TEST).call("stencil", &[always, 0, all, incr, incr, incr], &[])
    }

    /// Draws into a framebuffer object with colour, depth and so many samples a pixel, up to [`Recording::resolve`].
    pub fn multisample(&mut self, samples: usize) -> &mut Recording {
        let (width, height) = (self.width as i64, self.height as i64);
        self.call("multisample", &[samples as i64, width, height], &[])
    }

    /// Blits that framebuffer to the window, which makes a pixel the mean of its samples, and draws into the window again.
    pub fn resolve(&mut self) -> &mut Recording {
        self.call("resolve", &[], &[])
    }

    /// A command whose arguments are followed by raw data.
    pub fn data(&mut self, name: &str, integers: &[i64], data: impl Iterator<Item = u8>) -> &mut Recording {
        self.call(name, integers, &[]);
        // The data begins at a multiple of four: blanks before the end of the line.
        self.bytes.pop();
        while self.bytes.len() % 4 != 3 {
            self.bytes.push(b' ');
        }
        self.bytes.push(b'\n');
        self.bytes.extend(data);
        self
    }

    /// glDrawArrays, or Begin/End with `immediate`.
    pub fn draw_as(&mut self, mode: u32, has: u32, vertices: &[Vertex], immediate: bool) -> &mut Recording {
        let header = [i64::from(mode), i64::from(has), vertices.len() as i64, i64::from(immediate)];
        let floats = vertices.iter().flat_map(|v| {
            let part = |bit: u32, values: &'static [usize]| if has & bit != 0 { values } else { &[] };
            let position = v.position.into_iter();
            let color = part(has::COLOR, &[0, 1, 2, 3]).iter().map(|&k| v.color[k]);
            let normal = part(has::NORMAL, &[0, 1, 2]).iter().map(|&k| v.normal[k]);
            let coordinate = part(has::COORDINATE, &[0, 1, 2, 3]).iter().map(|&k| v.coordinate[k]);
            position.chain(color).chain(normal).chain(coordinate)
        });
        self.data("draw", &header, floats.flat_map(f32::to_le_bytes))
    }

    /// glDrawArrays.
    pub fn draw(&mut self, mode: u32, has: u32, vertices: &[Vertex]) -> &mut Recording {
        self.draw_as(mode, has, vertices, false)
    }

    /// glTexImage2D of an RGBA8 image, bottom row first.
    pub fn texture(&mut self, level: u32, width: usize, height: usize, texels: &[[u8; 4]]) -> &mut Recording {
        assert_eq!(texels.len(), width * height, "an image has as many texels as its size says");
        self.data("texture", &[level.into(), width as i64, height as i64], texels.iter().flatten().copied())
    }

    /// This recording, then the commands of another one for the same target.
    pub fn then(mut self, other: &Recording) -> Recording {
        let header = Recording::new(self.width, self.height, self.depth_bits).bytes.len();
        // Its data keeps its place among multiples of four.
        while self.bytes.len() % 4 != header % 4 {
            self.bytes.insert(self.bytes.len() - 1, b' ');
        }
        self.bytes.extend_from_slice(&other.bytes[header..]);
        self
    }

    /// The file that play.c reads.
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn data_begins_at_a_multiple_of_four() {
        for name in ["a", "ab", "abc", "abcd"] {
            let mut r = Recording::new(1, 1, 24);
            r.data(name, &[1], [7u8; 4].into_iter());
            let at = r.bytes().len() - 4;
            assert_eq!(at % 4, 0);
            assert_eq!(r.bytes()[at - 1], b'\n');
        }
    }

    #[test]
    fn floats_keep_their_bits() {
        let mut r = Recording::new(1, 1, 24);
        r.call("color", &[], &[f32::NAN, -0.0, 1e-45, f32::INFINITY]);
        let text = String::from_utf8(r.bytes().to_vec()).unwrap();
        assert!(text.ends_with("color x7fc00000 x80000000 x00000001 x7f800000\n"), "{text}");
    }
}
