//! Points and lines become rectangles: two triangles that share one set of planes.

use super::layout::*;
use super::setup::{Chunk, Context, Corner, bounds};
use super::vertex::snap;

impl Chunk {
    /// Appends the two triangles of a convex quadrilateral in snapped coordinates, one set of planes before them.
    fn rectangle(&mut self, context: &Context, x: [i32; 4], y: [i32; 4], mut flags: u32, planes: u32) {
        flags |= !context.top_first as u32 * triangle_flags::BOTTOM_UP;
        for k in [[0, 1, 2], [0, 2, 3]] {
            let (mut x, mut y) = (k.map(|k: usize| x[k]), k.map(|k: usize| y[k]));
            let area = (x[0] - x[1]) as i64 * (y[2] - y[0]) as i64 - (x[2] - x[0]) as i64 * (y[0] - y[1]) as i64;
            if area == 0 {
                continue;
            }
            if area < 0 {
                x.swap(0, 1);
                y.swap(0, 1);
            }
            let Some((columns, rows)) = bounds(x, y, context.state) else { continue };
            self.triangles.push(Triangle { x, y, draw: context.draw, flags, columns, rows, planes, primitive: context.primitive });
        }
    }

    /// A point: a square around its place, all values constant.
    pub fn point(&mut self, context: &Context, a: &Corner, front: bool) {
        let (record, state) = (context.record, context.state);
        let size = if record.point_size == NONE { state.point_size } else { a.shaded[record.point_size as usize][0] };
        let size = size.clamp(1.0, 255.0);
        let half = (size * 0.5 * 256.0) as i32;
        let [cx, cy] = [a.screen.position[0], a.screen.position[1]].map(snap);
        let (x0, x1, y0, y1) = (cx - half, cx + half, cy - half, cy + half);
        let planes = self.planes.len() as u32;
        self.planes.push([a.screen.position[2], 0.0, 0.0, a.screen.inv_w]);
        self.planes.push([0.0; 4]);
        for &varying in &record.varyings[..record.varying_count as usize] {
            let at = (if front { varying } else { varying >> 8 } & 0xff) as usize;
            let value = match varying >> 16 & 3 {
                interpolation::PERSPECTIVE => a.shaded[at].map(|v| v * a.screen.inv_w),
                _ => a.shaded[at],
            };
            self.planes.extend([value, [0.0; 4], [0.0; 4]]);
        }
        let flags = front as u32 * triangle_flags::FRONT | (a.screen.inv_w != 1.0) as u32 * triangle_flags::PERSPECTIVE;
        self.rectangle(context, [x0, x1, x1, x0], [y0, y0, y1, y1], flags, planes);
    }

    /// A line: a parallelogram as wide as the line in its minor direction.
    pub fn line(&mut self, context: &Context, a: &Corner, b: &Corner, front: bool) {
        let (record, state) = (context.record, context.state);
        let (p, q) = (a.screen.position, b.screen.position);
        let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
        if dx == 0.0 && dy == 0.0 {
            return;
        }
        let half = (state.line_width.clamp(1.0, 255.0) * 0.5 * 256.0) as i32;
        let [x0, x1, y0, y1] = [p[0], q[0], p[1], q[1]].map(snap);
        let planes = self.planes.len() as u32;
        // Along the line only: the gradient is parallel to it.
        let ool = 1.0 / (dx * dx + dy * dy);
        let plane = |a0: f32, a1: f32| {
            let d = (a1 - a0) * ool;
            let (ddx, ddy) = (d * dx, d * dy);
            [a0 - (ddx * (p[0] - 0.5) + ddy * (p[1] - 0.5)), ddx, ddy]
        };
        let (z, w) = (plane(p[2], q[2]), plane(a.screen.inv_w, b.screen.inv_w));
        self.planes.push([z[0], z[1], z[2], w[0]]);
        self.planes.push([w[1], w[2], 0.0, 0.0]);
        for &varying in &record.varyings[..record.varying_count as usize] {
            let at = (if front { varying } else { varying >> 8 } & 0xff) as usize;
            let mode = varying >> 16 & 3;
            if mode == interpolation::FLAT {
                self.planes.extend([context.provoking[at], [0.0; 4], [0.0; 4]]);
                continue;
            }
            let scale = |c: &Corner| if mode == interpolation::PERSPECTIVE { c.screen.inv_w } else { 1.0 };
            let (va, vb) = (a.shaded[at].map(|v| v * scale(a)), b.shaded[at].map(|v| v * scale(b)));
            let columns: [[f32; 3]; 4] = std::array::from_fn(|c| plane(va[c], vb[c]));
            self.planes.extend((0..3).map(|r| std::array::from_fn::<f32, 4, _>(|c| columns[c][r])));
        }
        let perspective = a.screen.inv_w != 1.0 || b.screen.inv_w != 1.0;
        let flags = front as u32 * triangle_flags::FRONT | perspective as u32 * triangle_flags::PERSPECTIVE;
        if dx.abs() >= dy.abs() {
            self.rectangle(context, [x0, x1, x1, x0], [y0 - half, y1 - half, y1 + half, y0 + half], flags, planes);
        } else {
            self.rectangle(context, [x0 - half, x0 + half, x1 + half, x1 - half], [y0, y0, y1, y1], flags, planes);
        }
    }
}
