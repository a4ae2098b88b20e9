//! The six scenes of the rasterizer's benchmark, S1 to S6: the same bits on every machine, proven by a hash.
//!
//! Everything is computed in f64 with + - * / and square roots alone. Window space has y up, vertices are clip positions.

/// A scene.
pub struct Scene {
    /// Columns and rows that it was made for.
    pub size: [u32; 2],
    /// Clip positions.
    pub positions: Vec<[f32; 4]>,
    /// RGBA8, red in the low byte.
    pub colors: Vec<u32>,
    /// Three a triangle.
    pub indices: Vec<u32>,
    /// Draws, of equally many triangles.
    pub draws: u32,
    /// Back faces are culled.
    pub cull: bool,
    /// What is done with a fragment.
    pub mode: Mode,
    /// What changes from draw to draw.
    pub change: Change,
    /// One colour a triangle, its last vertex's; otherwise interpolated with perspective.
    pub flat: bool,
    /// Texture coordinates by vertex; empty without a texture.
    pub coordinates: Vec<[f32; 2]>,
}

/// What is done with a fragment.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mode {
    /// Depth LESS, written.
    Depth,
    /// SRC_ALPHA, ONE_MINUS_SRC_ALPHA without a depth test.
    Blend,
    /// Depth LESS, written; no colour.
    DepthOnly,
    /// Neither depth nor blending.
    Plain,
}

impl Mode {
    /// All, with the name of each.
    pub const ALL: [(Mode, &str); 4] =
        [(Mode::Depth, "depth"), (Mode::Blend, "blend"), (Mode::DepthOnly, "depth-only"), (Mode::Plain, "plain")];

    /// The depth buffer is used.
    pub fn depth(self) -> bool {
        matches!(self, Mode::Depth | Mode::DepthOnly)
    }
}

/// What changes from draw to draw.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Change {
    /// Nothing.
    None,
    /// A tint, 1 - (draw & 7) / 16, times the colours.
    Tint,
    /// Blending is switched on and off.
    Blend,
}

impl Change {
    /// All, with the name of each.
    pub const ALL: [(Change, &str); 3] = [(Change::None, "none"), (Change::Tint, "tint"), (Change::Blend, "blend")];
}

/// Sizes that the hashes are known for.
pub const SIZES: [[u32; 2]; 3] = [[1024, 768], [1920, 1080], [3840, 2160]];

/// FNV-1a hashes by scene and size.
const HASHES: [[u64; 3]; 6] = [
    [0x7369bc46dbd43637, 0xfdb5df603a95f407, 0x9ce3de02a2a5714a],
    [0x0512ab3385ef8326, 0x5ebb3ce6a958718c, 0x7e0e7102c0f3ab65],
    [0xb13bcdf72c02cecd, 0x6621c17f91e29a26, 0xfd43245a945f5eb9],
    [0x3ba8152ee27d735f, 0x3ba8152ee27d735f, 0x3ba8152ee27d735f],
    [0x4df2fe0312f4b139, 0xa541512708964286, 0xc556c0e41a18ea48],
    [0xcb789354c640f384, 0x19bed6d4c05aae0a, 0xc2f1c44d2e820cce],
];

/// splitmix64.
pub(super) struct Random(pub u64);

impl Random {
    fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_add(0x9E3779B97F4A7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58476D1CE4E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D049BB133111EB);
        ((z ^ (z >> 31)) >> 32) as u32
    }

    pub fn unit(&mut self) -> f64 {
        (self.bits() >> 8) as f64 * (1.0 / 16777216.0)
    }

    pub fn range(&mut self, a: f64, b: f64) -> f64 {
        let t = self.unit();
        a + (b - a) * t
    }

    pub fn color(&mut self) -> u32 {
        let r = self.bits();
        let a = 64 + (r >> 24) % 128;
        (r & 0xff_ffff) | (a << 24)
    }

    /// About normal: the sum of twelve.
    pub fn normal(&mut self) -> f64 {
        (0..12).fold(0.0, |s, _| s + self.unit()) - 6.0
    }

    /// A point of the unit disc.
    pub fn disc(&mut self) -> [f64; 2] {
        loop {
            let x = self.range(-1.0, 1.0);
            let y = self.range(-1.0, 1.0);
            if x * x + y * y <= 1.0 {
                return [x, y];
            }
        }
    }
}

/// e^x as a power of two and twelve terms of its series.
fn exp(x: f64) -> f64 {
    let y = x * std::f64::consts::LOG2_E;
    let k = y.floor();
    let f = (y - k) * std::f64::consts::LN_2;
    let (mut t, mut s) = (1.0, 1.0);
    for i in 1..=12 {
        t = t * f / i as f64;
        s += t;
    }
    // Exact: a power of two.
    s * 2f64.powi(k as i32)
}

impl Scene {
    /// Nothing yet: one draw with depth LESS.
    pub(super) fn empty(size: [u32; 2]) -> Scene {
        Scene {
            size,
            positions: Vec::new(),
            colors: Vec::new(),
            indices: Vec::new(),
            draws: 1,
            cull: false,
            mode: Mode::Depth,
            change: Change::None,
            flat: false,
            coordinates: Vec::new(),
        }
    }

    /// Makes scene `id` for a size; an error where its hash is not the known one.
    pub fn new(id: u32, size: [u32; 2]) -> Result<Scene, String> {
        let mut scene = Scene::empty(size);
        (scene.draws, scene.cull) = (if id == 6 { 500 } else { 1 }, id == 5);
        scene.mode = if id == 4 { Mode::Blend } else { Mode::Depth };
        scene.change = if id == 6 { Change::Tint } else { Change::None };
        let mut random = Random(0x5EED0000 + id as u64);
        match id {
            1 => scene.patches(&mut random, 512, 64, 1.7320508075688772),
            2 => (0..1_000_000).for_each(|_| scene.soup(&mut random, 10.0)),
            3 => (0..100_000).for_each(|_| scene.soup(&mut random, 200.0)),
            4 => (0..300).for_each(|_| scene.large(&mut random)),
            5 => (0..500_000).for_each(|_| {
                let area = (10.0 * exp(1.5 * random.normal())).clamp(0.25, 50000.0);
                scene.soup(&mut random, area);
            }),
            6 => scene.patches(&mut random, 500, 32, 4.47213595499958),
            _ => return Err(format!("there is no scene S{id}: S1 to S6")),
        }
        let (hash, known) = (scene.hash(), SIZES.iter().position(|s| *s == size).map(|k| HASHES[id as usize - 1][k]));
        match known {
            Some(known) if known != hash => Err(format!("S{id} at {}x{}: hash {hash:016x}, not {known:016x}", size[0], size[1])),
            _ => Ok(scene),
        }
    }

    /// Triangles.
    pub fn triangles(&self) -> u32 {
        self.indices.len() as u32 / 3
    }

    pub(super) fn put(&mut self, x: f64, y: f64, z: f64, w: f64, color: u32) {
        let ndc = [x * 2.0 / self.size[0] as f64 - 1.0, y * 2.0 / self.size[1] as f64 - 1.0];
        self.positions.push([(ndc[0] * w) as f32, (ndc[1] * w) as f32, (z * w) as f32, w as f32]);
        self.colors.push(color);
    }

    pub(super) fn own_vertices(&mut self) {
        let first = self.positions.len() as u32 - 3;
        self.indices.extend(first..first + 3);
    }

    /// A triangle of an exact area at a random place.
    pub(super) fn soup(&mut self, random: &mut Random, area: f64) {
        let (cx, cy) = (random.range(0.0, self.size[0] as f64), random.range(0.0, self.size[1] as f64));
        let base = random.range(-0.9, 0.9);
        let (d, twice) = loop {
            let d = [random.disc(), random.disc(), random.disc()];
            let twice = (d[1][0] - d[0][0]) * (d[2][1] - d[0][1]) - (d[1][1] - d[0][1]) * (d[2][0] - d[0][0]);
            if twice.abs() >= 0.4 {
                break (d, twice);
            }
        };
        let scale = (area / (twice.abs() * 0.5)).sqrt();
        for [dx, dy] in d {
            let z = base + random.range(-0.05, 0.05);
            let w = random.range(1.0, 4.0);
            let color = random.color();
            self.put(cx + scale * dx, cy + scale * dy, z, w, color);
        }
        self.own_vertices();
    }

    /// A triangle of at least a seventh of the screen.
    fn large(&mut self, random: &mut Random) {
        let [width, height] = self.size.map(f64::from);
        let (x, y) = loop {
            let (mut x, mut y) = ([0.0; 3], [0.0; 3]);
            for k in 0..3 {
                x[k] = random.range(0.0, width);
                y[k] = random.range(0.0, height);
            }
            let twice: f64 = (x[1] - x[0]) * (y[2] - y[0]) - (y[1] - y[0]) * (x[2] - x[0]);
            if twice.abs() >= 2.0 * width * height / 7.0 {
                break (x, y);
            }
        };
        let base = random.range(-0.9, 0.9);
        for k in 0..3 {
            let w = random.range(1.0, 4.0);
            let color = random.color();
            self.put(x[k], y[k], base, w, color);
        }
        self.own_vertices();
    }

    /// Bumpy grids of n x n cells with edges of `edge` pixels, turned at random, all on the screen.
    pub(super) fn patches(&mut self, random: &mut Random, count: u32, n: u32, edge: f64) {
        let [width, height] = self.size.map(f64::from);
        // The published scenes' own digits, on which their hashes depend.
        #[allow(clippy::approx_constant)]
        let (side, margin) = (n as f64, edge * n as f64 * 0.70710678 + 2.0);
        for _ in 0..count {
            let (cx, cy) = (random.range(margin, width - margin), random.range(margin, height - margin));
            let (base, w0) = (random.range(-0.9, 0.8), random.range(1.0, 3.0));
            let [rx, ry] = loop {
                let [x, y] = random.disc();
                if x * x + y * y >= 0.01 {
                    let length = (x * x + y * y).sqrt();
                    break [x / length, y / length];
                }
            };
            let first = self.positions.len() as u32;
            for j in 0..=n {
                for i in 0..=n {
                    let (u, v) = (i as f64 / side, j as f64 / side);
                    let lx = (u - 0.5) * side * edge + random.range(-0.15, 0.15) * edge;
                    let ly = (v - 0.5) * side * edge + random.range(-0.15, 0.15) * edge;
                    let z = base + 0.1 * (16.0 * u * (1.0 - u) * v * (1.0 - v)) + random.range(-0.002, 0.002);
                    let w = w0 + u + 0.5 * v;
                    let color = random.color();
                    self.put(cx + rx * lx - ry * ly, cy + ry * lx + rx * ly, z, w, color);
                }
            }
            for j in 0..n {
                for i in 0..n {
                    let a = first + j * (n + 1) + i;
                    let (b, c) = (a + 1, a + n + 1);
                    let d = c + 1;
                    self.indices.extend([a, b, d, a, d, c]);
                }
            }
        }
    }

    /// FNV-1a over the words of positions, colours and indices.
    pub fn hash(&self) -> u64 {
        let positions = self.positions.iter().flatten().map(|v| v.to_bits());
        let words = positions.chain(self.colors.iter().copied()).chain(self.indices.iter().copied());
        words.fold(0xCBF29CE484222325, |h, w| (h ^ w as u64).wrapping_mul(0x100000001B3))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_are_the_same_bits_as_the_published_ones() {
        for id in 3..=5 {
            for size in SIZES {
                assert_eq!(Scene::new(id, size).err(), None);
            }
        }
    }

    #[test]
    fn another_scene_has_another_hash() {
        let mut scene = Scene::new(4, SIZES[0]).expect("S4");
        let before = scene.hash();
        scene.positions[7][2] += 1e-6;
        assert_ne!(scene.hash(), before);
    }
}
