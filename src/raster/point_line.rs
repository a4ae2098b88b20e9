//! Points and lines become rectangles: two triangles that share one set of planes. Which pixels they cover follows
//! llvmpipe: a point is a square of whole pixels; a line is a parallelogram as wide as the line in its minor
//! direction, its ends moved so that the first and last pixel obey the diamond-exit rule (3.4.1).

use super::layout::*;
use super::setup::{Chunk, Context, Corner, FULL_COVERAGE, bounds, to_centre};
use super::vertex::{COORDINATE_RANGE, snap};

fn in_range(v: f32) -> f32 {
    if v > COORDINATE_RANGE[0] { v.min(COORDINATE_RANGE[1]) } else { COORDINATE_RANGE[0] }
}

/// What the ends of a line look like along its major direction.
struct Ends {
    /// How far the ends move: major and minor direction of the start, then of the end.
    start: [f32; 2],
    end: [f32; 2],
}

/// Applies the diamond-exit rule to a line from `a` to `b`, given as (major, minor) coordinates. `d` is `a - b`;
/// `y_major` says which of the two sets of tie rules applies.
fn ends(a: [f32; 2], b: [f32; 2], d: [f32; 2], y_major: bool) -> Ends {
    let slope = d[1] / d[0];
    let fraction = |v: f32| v - v.floor();
    let off = |v: f32| fraction(v) - 0.5;
    let positive = |v: f32| v >= 0.0;
    let [major1, minor1] = a.map(off);
    let [major2, mut minor2] = b.map(off);
    if minor2 == -0.5 && d[1] < 0.0 {
        minor2 = 0.5;
    }
    let crosses = |minor: f32, major: f32| fraction(minor) + major * slope;
    let (draw_start, draw_end, starts, stops);
    if !y_major {
        draw_start = if major1.abs() + minor1.abs() < 0.5 {
            true
        } else if positive(major1) == positive(-d[0]) {
            false
        } else if positive(-minor1) != positive(d[1]) {
            true
        } else {
            let at = crosses(a[1], major1);
            at < 1.0 && at > 0.0
        };
        draw_end = if major2.abs() + minor2.abs() < 0.5 || positive(major2) != positive(-d[0]) {
            false
        } else if positive(-minor2) == positive(d[1]) {
            true
        } else {
            let at = crosses(b[1], major2);
            at < 1.0 && at > 0.0
        };
        starts = positive(-major1) != positive(d[0]);
        stops = positive(major2) == positive(-d[0]) || major2 == 0.0;
    } else {
        draw_start = if major1.abs() + minor1.abs() < 0.5 {
            true
        } else if positive(-major1) == positive(d[0]) {
            false
        } else if positive(minor1) != positive(-d[1]) {
            true
        } else {
            let at = crosses(a[1], major1);
            at < 1.0 && at > 0.0
        };
        draw_end = if major2.abs() + minor2.abs() < 0.5 || positive(-major2) != positive(d[0]) {
            false
        } else if positive(minor2) == positive(-d[1]) {
            true
        } else {
            let at = crosses(b[1], major2);
            (0.0..1.0).contains(&at)
        };
        starts = positive(major1) == positive(d[0]);
        stops = positive(-major2) == positive(d[0]) || major2 == 0.0;
    }
    // Ends move to the border of their pixel: the far one where the line runs up, the near one where it runs down.
    let border = if d[0] < 0.0 { -0.5 } else { 0.5 };
    let moved = |moves: bool, major: f32| {
        let by = if moves { border - major } else { 0.0 };
        [by, by * slope]
    };
    Ends { start: moved(starts != draw_start, major1), end: moved(stops != draw_end, major2) }
}

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
            let Some((columns, rows, cut)) = bounds(x, y, context.state) else { continue };
            let flags = flags | cut;
            self.triangles.push(Triangle { x, y, draw: context.draw, flags, columns, rows, planes, primitive: context.primitive });
        }
    }

    /// A point: a square of pixels around its place, all values constant.
    pub fn point(&mut self, context: &Context, a: &Corner, front: bool) {
        let (record, state) = (context.record, context.state);
        let size = if record.point_size == NONE { state.point_size } else { a.shaded[record.point_size as usize][0] };
        // Halves round down.
        let width = if size > 1.0 { (size.min(255.0) - 0.5).ceil() as i32 } else { 1 };
        let adjust = [0.0, if context.top_first { 1.0 } else { 0.0 }];
        let first = [0, 1].map(|k| {
            let at = (in_range(a.screen.position[k]) * 256.0 - adjust[k]).round_ties_even() as i32;
            if width & 1 != 0 { (at >> SUBPIXEL_BITS) - (width - 1) / 2 } else { ((at + 128) >> SUBPIXEL_BITS) - width / 2 }
        });
        // Between the pixel centres, so that no tie arises.
        let [(x0, x1), (y0, y1)] = first.map(|f| ((f << SUBPIXEL_BITS) - 128, ((f + width) << SUBPIXEL_BITS) - 128));
        let smooth = state.flags & raster_flags::POINT_SMOOTH != 0;
        let radius = 0.5 * size.clamp(1.0, 255.0);
        let centre = [in_range(a.screen.position[0]), in_range(a.screen.position[1])];
        let (x, y) = if smooth {
            // Every pixel that the circle may touch.
            let [(x0, x1), (y0, y1)] = centre.map(|c| (snap(c - radius - 0.5), snap(c + radius + 0.5)));
            ([x0, x1, x1, x0], [y0, y0, y1, y1])
        } else {
            ([x0, x1, x1, x0], [y0, y0, y1, y1])
        };
        let planes = self.planes.len() as u32;
        self.planes.push([a.screen.position[2], 0.0, 0.0, a.screen.inv_w]);
        self.planes.push([0.0; 4]);
        for &varying in &record.varyings[..record.varying_count as usize] {
            let at = (if front { varying } else { varying >> 8 } & 0xff) as usize;
            let value = match varying >> 16 & 3 {
                interpolation::FLAT => context.provoking[at],
                interpolation::PERSPECTIVE => a.shaded[at].map(|v| v * a.screen.inv_w),
                interpolation::COVERAGE => {
                    let origin = 0.5 - to_centre(state);
                    let planes = [[origin - centre[0], radius + 0.5, origin - centre[1], 1.0], [1.0, 0.0, 0.0, 0.0], [0.0, 0.0, 1.0, 0.0]];
                    self.planes.extend(if smooth { planes } else { FULL_COVERAGE });
                    continue;
                }
                _ => a.shaded[at],
            };
            self.planes.extend([value, [0.0; 4], [0.0; 4]]);
        }
        let flags = (front as u32 * triangle_flags::FRONT) | ((a.screen.inv_w != 1.0) as u32 * triangle_flags::PERSPECTIVE);
        self.rectangle(context, x, y, flags, planes);
    }

    /// A line, cut into its "on" segments where it is stippled.
    pub fn stippled_line(&mut self, context: &Context, a: &Corner, b: &Corner, front: bool) {
        let state = context.state;
        if state.flags & raster_flags::LINE_STIPPLE == 0 {
            return self.line(context, a, b, front);
        }
        let (p, q) = (a.screen.position, b.screen.position);
        let length = (p[0] - q[0]).abs().max((p[1] - q[1]).abs());
        if !(length < 65536.0) {
            return;
        }
        let (pattern, factor) = (state.line_stipple & 0xffff, (state.line_stipple >> 16).max(1));
        let steps = length.ceil() as u32;
        let mut start = None;
        for i in 0..=steps {
            let on = i < steps && pattern >> ((self.stipple_counter.wrapping_add(i) / factor) & 15) & 1 != 0;
            match start {
                None if on => start = Some(i),
                Some(from) if !on => {
                    let end = if i < steps { i as f32 / length } else { 1.0 };
                    self.segment(context, a, b, from as f32 / length, end, front);
                    start = None;
                }
                _ => {}
            }
        }
        self.stipple_counter = self.stipple_counter.wrapping_add(steps);
    }

    /// The part of a line between two parameters, everything interpolated on the screen.
    fn segment(&mut self, context: &Context, a: &Corner, b: &Corner, t0: f32, t1: f32, front: bool) {
        let mix = |t: f32, a: f32, b: f32| a + t * (b - a);
        let stride = context.record.shaded_stride as usize;
        let ends = [t0, t1].map(|t| {
            let mut shaded = vec![[0.0; 4]; stride];
            for (k, v) in shaded.iter_mut().enumerate() {
                *v = std::array::from_fn(|c| mix(t, a.shaded[k][c], b.shaded[k][c]));
            }
            let mut screen = a.screen;
            screen.position = std::array::from_fn(|c| mix(t, a.screen.position[c], b.screen.position[c]));
            screen.inv_w = mix(t, a.screen.inv_w, b.screen.inv_w);
            (screen, shaded)
        });
        let corner = |k: usize| Corner { screen: ends[k].0, shaded: &ends[k].1 };
        let first = if t0 > 0.0 { corner(0) } else { *a };
        let last = if t1 < 1.0 { corner(1) } else { *b };
        self.line(context, &first, &last, front);
    }

    /// A line: a parallelogram as wide as the line in its minor direction.
    pub fn line(&mut self, context: &Context, a: &Corner, b: &Corner, front: bool) {
        let (record, state) = (context.record, context.state);
        let (p, q) = (a.screen.position, b.screen.position);
        let (dx, dy) = (p[0] - q[0], p[1] - q[1]);
        let area = dx * dx + dy * dy;
        if !(area > 0.0 && area.is_finite()) {
            return;
        }
        let origin = 0.5 - to_centre(state);
        let half = (state.line_width.clamp(1.0, 255.0) + 0.5) as i32 * 256 / 2;
        let smooth = (state.flags & raster_flags::LINE_SMOOTH != 0).then(|| SmoothLine::new(p, q, state.line_width, origin));
        let planes = self.planes.len() as u32;
        // Along the major axis only, stretched so that it reaches the other end.
        let x_major = dx.abs() >= dy.abs();
        let (major, slope) = if x_major { (dx, dy / dx) } else { (dy, dx / dy) };
        let (stretched, ooa) = (major * (1.0 + slope * slope), 1.0 / area);
        let plane = |a0: f32, a1: f32| {
            let along = (a0 - a1) * stretched * ooa;
            let (ddx, ddy) = if x_major { (along, 0.0) } else { (0.0, along) };
            [a0 - (ddx * (p[0] - origin) + ddy * (p[1] - origin)), ddx, ddy]
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
            if mode == interpolation::COVERAGE {
                self.planes.extend(smooth.as_ref().map_or(FULL_COVERAGE, |s| s.coverage));
                continue;
            }
            let scale = |c: &Corner| if mode == interpolation::PERSPECTIVE { c.screen.inv_w } else { 1.0 };
            let (va, vb) = (a.shaded[at].map(|v| v * scale(a)), b.shaded[at].map(|v| v * scale(b)));
            let columns: [[f32; 3]; 4] = std::array::from_fn(|c| plane(va[c], vb[c]));
            self.planes.extend((0..3).map(|r| std::array::from_fn::<f32, 4, _>(|c| columns[c][r])));
        }
        let perspective = a.screen.inv_w != 1.0 || b.screen.inv_w != 1.0;
        let flags = (front as u32 * triangle_flags::FRONT) | (perspective as u32 * triangle_flags::PERSPECTIVE);
        if let Some(SmoothLine { x, y, .. }) = smooth {
            self.rectangle(context, x, y, flags, planes);
        } else if x_major {
            let e = ends([p[0], p[1]], [q[0], q[1]], [dx, dy], false);
            let [x0, x1] = [p[0] + e.start[0], q[0] + e.end[0]].map(snap);
            let [y0, y1] = [p[1] + e.start[1], q[1] + e.end[1]].map(snap);
            self.rectangle(context, [x0, x1, x1, x0], [y0 - half, y1 - half, y1 + half, y0 + half], flags, planes);
        } else {
            let e = ends([p[1], p[0]], [q[1], q[0]], [dy, dx], true);
            let [x0, x1] = [p[0] + e.start[1], q[0] + e.end[1]].map(snap);
            let [y0, y1] = [p[1] + e.start[0], q[1] + e.end[0]].map(snap);
            self.rectangle(context, [x0 - half, x0 + half, x1 + half, x1 - half], [y0, y0, y1, y1], flags, planes);
        }
    }
}

/// An antialiased line: the rectangle of all pixels that it may touch, and the planes of its coverage (3.4.2).
struct SmoothLine {
    x: [i32; 4],
    y: [i32; 4],
    coverage: [[f32; 4]; 3],
}

impl SmoothLine {
    fn new(p: [f32; 3], q: [f32; 3], width: f32, origin: f32) -> SmoothLine {
        let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
        let length = (dx * dx + dy * dy).sqrt();
        // The unit vector along the line; across it is turned by a quarter.
        let (ux, uy) = (dx / length, dy / length);
        let (middle_x, middle_y) = (0.5 * (p[0] + q[0]), 0.5 * (p[1] + q[1]));
        let (across, along) = (0.5 * width.clamp(1.0, 255.0) + 0.5, 0.5 * length + 0.5);
        let corner = |a: f32, l: f32| [snap(middle_x + l * ux - a * uy), snap(middle_y + l * uy + a * ux)];
        let corners = [corner(-across, -along), corner(-across, along), corner(across, along), corner(across, -along)];
        let at = |gx: f32, gy: f32| (origin - middle_x) * gx + (origin - middle_y) * gy;
        SmoothLine {
            x: corners.map(|c| c[0]),
            y: corners.map(|c| c[1]),
            coverage: [[at(-uy, ux), across, at(ux, uy), along], [-uy, 0.0, ux, 0.0], [ux, 0.0, uy, 0.0]],
        }
    }
}
