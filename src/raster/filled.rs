//! Set-up of the commonest primitive without detours: a filled triangle that leaves no plane of the view volume. The same records as
//! [`Chunk::triangle`] makes.

use super::layout::*;
use super::setup::{Basis, Chunk, Context, FULL_COVERAGE, bounds, polygon_offset};
use super::vertex::ScreenVertex;

/// Whether a state's polygons may be set up here.
pub fn serves(record: &DrawRecord, state: &RasterState) -> bool {
    record.topology == topology::TRIANGLES && state.polygon_mode == [topology::TRIANGLES; 2]
}

impl Chunk {
    /// A triangle by its places and its shaded vertices, as they come: culled and made positive here.
    #[inline(always)]
    pub fn filled(&mut self, context: &Context, [a, b, c]: [&ScreenVertex; 3], [sa, sb, sc]: [&[[f32; 4]]; 3]) {
        let (dx, dy) = (a.snapped[0] as i64 - b.snapped[0] as i64, a.snapped[1] as i64 - b.snapped[1] as i64);
        let (ex, ey) = (c.snapped[0] as i64 - a.snapped[0] as i64, c.snapped[1] as i64 - a.snapped[1] as i64);
        let area = dx * ey - ex * dy;
        let flags = context.state.flags;
        let front = ((area > 0) == context.top_first) == (flags & raster_flags::FRONT_CCW != 0);
        if area == 0 || flags & (if front { raster_flags::CULL_FRONT } else { raster_flags::CULL_BACK }) != 0 {
            return;
        }
        // Which way round is a coin's toss: selections, not a branch.
        let positive = area > 0;
        let (a, b, sa, sb) = if positive { (a, b, sa, sb) } else { (b, a, sb, sa) };
        let (x, y) = ([a.snapped[0], b.snapped[0], c.snapped[0]], [a.snapped[1], b.snapped[1], c.snapped[1]]);
        let Some((columns, rows, cut)) = bounds(x, y, context.state) else { return };
        let perspective = a.inv_w != 1.0 || b.inv_w != 1.0 || c.inv_w != 1.0;
        let flag = |on: bool, flag: u32| if on { flag } else { 0 };
        let offset =
            if flags & raster_flags::OFFSET_FILL != 0 { polygon_offset(context.state, [a.position, b.position, c.position]) } else { 0.0 };
        let basis = Basis::new(context.state, [a.position, b.position, c.position]);
        let planes = self.planes.len() as u32;
        // Depth and 1/w side by side.
        let side = |v: &ScreenVertex| [v.position[2], v.inv_w, 0.0, 0.0];
        let [p0, px, py] = basis.plane4([side(a), side(b), side(c)]);
        self.planes.extend_from_slice(&[[p0[0], px[0], py[0], p0[1]], [px[1], py[1], offset, 0.0]]);
        let record = context.record;
        for &varying in &record.varyings[..record.varying_count as usize] {
            let at = (if front { varying } else { varying >> 8 } & 0xff) as usize;
            let planes = match varying >> 16 & 3 {
                interpolation::FLAT => [context.provoking[at], [0.0; 4], [0.0; 4]],
                interpolation::PERSPECTIVE => basis.plane4([times(&sa[at], a.inv_w), times(&sb[at], b.inv_w), times(&sc[at], c.inv_w)]),
                interpolation::COVERAGE => FULL_COVERAGE,
                _ => basis.plane4([sa[at], sb[at], sc[at]]),
            };
            self.planes.extend_from_slice(&planes);
        }
        let flags = triangle_flags::POLYGON
            | cut
            | flag(perspective, triangle_flags::PERSPECTIVE)
            | flag(front, triangle_flags::FRONT)
            | flag(!context.top_first, triangle_flags::BOTTOM_UP);
        self.triangles.push(Triangle { x, y, draw: context.draw, flags, columns, rows, planes, primitive: context.primitive });
    }
}

#[inline(always)]
fn times(v: &[f32; 4], by: f32) -> [f32; 4] {
    [v[0] * by, v[1] * by, v[2] * by, v[3] * by]
}
