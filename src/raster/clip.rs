//! Clip stage: a primitive that leaves the view volume is cut, plane after plane, as Mesa's draw module does it: without
//! a guard band, a new vertex interpolated from the end of the edge that is nearer to the plane, `a + t * (b - a)` in clip
//! space with unfused arithmetic, and the polygon drawn as a fan. Bit for bit the depth of OSMesa (measured against it).

use super::layout::*;
use super::vertex::{ScreenVertex, clip_code, snap};

/// A vertex on its way through clipping: where it lies on the screen, and its vec4 in the pool.
#[derive(Clone, Copy, Debug)]
pub struct ClipVertex {
    /// Screen position; for a new vertex valid once clipping is through.
    pub screen: ScreenVertex,
    /// Its clip position and attributes start here in [`Clipper::pool`].
    pub at: usize,
    /// The edge from this vertex to the next is a boundary edge.
    pub edge: bool,
}

/// Vertices made while clipping one primitive.
#[derive(Default)]
pub struct Clipper {
    /// Shaded vertices, `stride` vec4 each: the primitive's own first.
    pub pool: Vec<[f32; 4]>,
    /// The polygon.
    pub polygon: Vec<ClipVertex>,
    next: Vec<ClipVertex>,
}

/// The view volume's planes in the order of their code bits.
const PLANES: [[f32; 4]; 6] =
    [[-1.0, 0.0, 0.0, 1.0], [1.0, 0.0, 0.0, 1.0], [0.0, -1.0, 0.0, 1.0], [0.0, 1.0, 0.0, 1.0], [0.0, 0.0, 1.0, 1.0], [0.0, 0.0, -1.0, 1.0]];

/// Signed distance of a vertex from plane `k`.
fn distance(vertex: &[[f32; 4]], k: usize, record: &DrawRecord) -> f32 {
    if k < 6 {
        let (p, n) = (vertex[0], PLANES[k]);
        p[0] * n[0] + p[1] * n[1] + p[2] * n[2] + p[3] * n[3]
    } else {
        vertex[record.clip_distances as usize + (k - 6) / 4][(k - 6) % 4]
    }
}

/// Puts a new vertex on the screen: with unfused arithmetic, as the clipper does.
pub fn to_screen_unfused(p: [f32; 4], state: &RasterState) -> ScreenVertex {
    let inv_w = 1.0 / p[3];
    let at = |k: usize| p[k] * inv_w * state.viewport_scale[k] + state.viewport_translate[k];
    let position = [at(0), at(1), at(2)];
    ScreenVertex { position, inv_w, snapped: [snap(position[0]), snap(position[1])], code: 0, reserved: 0 }
}

impl Clipper {
    /// Starts a primitive with its vertices.
    pub fn begin(&mut self, vertices: &[(&ScreenVertex, &[[f32; 4]], bool)]) {
        self.pool.clear();
        self.polygon.clear();
        for (screen, shaded, edge) in vertices {
            self.polygon.push(ClipVertex { screen: **screen, at: self.pool.len(), edge: *edge });
            self.pool.extend_from_slice(shaded);
        }
    }

    /// Appends `a + t * (b - a)` to the pool.
    fn interpolate(&mut self, a: ClipVertex, b: ClipVertex, t: f32, stride: usize, state: &RasterState) -> ClipVertex {
        let at = self.pool.len();
        for k in 0..stride {
            let (a, b) = (self.pool[a.at + k], self.pool[b.at + k]);
            self.pool.push(std::array::from_fn(|c| a[c] + t * (b[c] - a[c])));
        }
        ClipVertex { screen: to_screen_unfused(self.pool[at], state), at, edge: false }
    }

    /// Clips the polygon by the planes of `code`. False: nothing is left.
    pub fn polygon(&mut self, code: u32, record: &DrawRecord, state: &RasterState) -> bool {
        let stride = record.shaded_stride as usize;
        for plane in 0..14 {
            if code >> plane & 1 == 0 {
                continue;
            }
            let n = self.polygon.len();
            if n < 3 {
                return false;
            }
            self.next.clear();
            let mut prev = self.polygon[0];
            let mut d_prev = distance(&self.pool[prev.at..], plane, record);
            if !d_prev.is_finite() {
                return false;
            }
            for i in 1..=n {
                let vertex = self.polygon[i % n];
                let d = distance(&self.pool[vertex.at..], plane, record);
                if !d.is_finite() {
                    return false;
                }
                if d_prev >= 0.0 {
                    self.next.push(prev);
                }
                if (d_prev >= 0.0) != (d >= 0.0) {
                    let mut new = if d.abs() < d_prev.abs() || (d.abs() == d_prev.abs() && d >= 0.0) {
                        self.interpolate(vertex, prev, d / (d - d_prev), stride, state)
                    } else {
                        self.interpolate(prev, vertex, d_prev / (d_prev - d), stride, state)
                    };
                    // Going out: the edge along the plane is a boundary for user planes, not for the frustum's.
                    new.edge = if d < 0.0 { plane >= 6 } else { prev.edge };
                    self.next.push(new);
                }
                prev = vertex;
                d_prev = d;
            }
            std::mem::swap(&mut self.polygon, &mut self.next);
        }
        self.polygon.len() >= 3
    }

    /// Clips the line in `polygon` by the planes of `code`. False: nothing is left.
    pub fn line(&mut self, code: u32, record: &DrawRecord, state: &RasterState) -> bool {
        let (v0, v1) = (self.polygon[0], self.polygon[1]);
        let (mut t0, mut t1) = (0.0f32, 0.0f32);
        for plane in 0..14 {
            if code >> plane & 1 == 0 {
                continue;
            }
            let d0 = distance(&self.pool[v0.at..], plane, record);
            let d1 = distance(&self.pool[v1.at..], plane, record);
            if !d0.is_finite() || !d1.is_finite() {
                return false;
            }
            if d1 < 0.0 {
                t1 = t1.max(d1 / (d1 - d0));
            }
            if d0 < 0.0 {
                t0 = t0.max(d0 / (d0 - d1));
            }
            if t0 + t1 >= 1.0 {
                return false;
            }
        }
        let stride = record.shaded_stride as usize;
        if v0.screen.code != 0 {
            self.polygon[0] = self.interpolate(v0, v1, t0, stride, state);
        }
        if v1.screen.code != 0 {
            self.polygon[1] = self.interpolate(v1, v0, t1, stride, state);
        }
        true
    }
}

/// Whether a primitive with these codes can be drawn at all: none of its vertices is invalid, not all are outside one plane.
pub fn possible(or: u32, and: u32) -> bool {
    or & clip_code::INVALID == 0 && and == 0
}
