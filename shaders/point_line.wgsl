// Points and lines become rectangles, two triangles that share one set of planes: the twin of src/raster/point_line.rs.

fn tp_in_range(v: f32) -> f32 {
    return select(TP_COORDINATE_MIN, min(v, TP_COORDINATE_MAX), v > TP_COORDINATE_MIN);
}

// The two triangles of a convex quadrilateral in snapped coordinates; the planes were written at tp_next_planes.
fn tp_rectangle(p: TpPrimitive, index: u32, x: vec4<i32>, y: vec4<i32>, flags: u32) {
    for (var half = 0u; half < 2u; half++) {
        var tx = select(x.xzw, x.xyz, half == 0u);
        var ty = select(y.xzw, y.xyz, half == 0u);
        let area = tp_area_sign(tx, ty);
        if (area < 0) {
            tx = tx.yxz;
            ty = ty.yxz;
        }
        let box = tp_bounds(tx, ty, p.state, p.flags);
        if (area != 0 && box.x != TP_NOWHERE) {
            tp_write_triangle(p, index, tx, ty, box.x, box.y, flags | select(0u, TP_CUT, box.z != 0u));
        }
    }
    tp_next_planes += p.plane_stride;
}

// A point: a square of pixels around its place, all values constant.
fn tp_point(p: TpPrimitive, index: u32, a: TpCorner, front: bool) {
    var size = tp_state_float(p.state, TP_STATE_POINT_SIZE);
    let written = tp_front_records[p.record + TP_DRAW_POINT_SIZE];
    if (written != TP_NONE) {
        size = tp_shaded[a.at + written].x;
    }
    // Halves round down.
    let width = select(1, i32(ceil(min(size, 255.0) - 0.5)), size > 1.0);
    let centre = vec2<f32>(tp_in_range(a.position.x), tp_in_range(a.position.y));
    let adjust = vec2<f32>(0.0, select(0.0, 1.0, tf.top_first != 0u));
    let at = vec2<i32>(round(centre * 256.0 - adjust));
    let odd = (at >> vec2<u32>(8u)) - (width - 1) / 2;
    let even = ((at + 128) >> vec2<u32>(8u)) - width / 2;
    let first = select(even, odd, (width & 1) != 0);
    // Between the pixel centres, so that no tie arises.
    var low = first * 256 - 128;
    var high = (first + width) * 256 - 128;
//#if SMOOTH
    let radius = 0.5 * min(max(size, 1.0), 255.0);
    let smooth_point = (p.flags & TP_POINT_SMOOTH) != 0u;
    if (smooth_point) {
        // Every pixel that the circle may touch.
        low = vec2<i32>(tp_snap(centre.x - radius - 0.5), tp_snap(centre.y - radius - 0.5));
        high = vec2<i32>(tp_snap(centre.x + radius + 0.5), tp_snap(centre.y + radius + 0.5));
    }
//#endif
    tp_planes[tp_next_planes] = vec4<f32>(a.position.z, 0.0, 0.0, a.inv_w);
    tp_planes[tp_next_planes + 1u] = vec4<f32>(0.0);
    let count = tp_front_records[p.record + TP_DRAW_VARYING_COUNT];
    for (var k = 0u; k < count; k++) {
        let input = tp_varying(p.record, k, front);
        var planes = tp_constant(tp_shaded[a.at + input.x]);
        if (input.y == TP_INTERPOLATE_FLAT) {
            planes = tp_constant(tp_shaded[tp_provoking + input.x]);
        } else if (input.y == TP_INTERPOLATE_PERSPECTIVE) {
            planes = tp_constant(tp_shaded[a.at + input.x] * a.inv_w);
        } else if (input.y == TP_INTERPOLATE_COVERAGE) {
            planes = tp_full_coverage();
//#if SMOOTH
            if (smooth_point) {
                let from_centre = tp_origin(p.flags) - centre;
                planes = array<vec4<f32>, 3>(
                    vec4<f32>(from_centre.x, radius + 0.5, from_centre.y, 1.0), vec4<f32>(1.0, 0.0, 0.0, 0.0), vec4<f32>(0.0, 0.0, 1.0, 0.0));
            }
//#endif
        }
        tp_write_planes(k, planes);
    }
    let flags = tp_surface_flags(front) | select(0u, TP_PERSPECTIVE, a.inv_w != 1.0);
    tp_rectangle(p, index, vec4<i32>(low.x, high.x, high.x, low.x), vec4<i32>(low.y, low.y, high.y, high.y), flags);
}

// How far the ends of a line move along its major and minor direction: start, then end.
struct TpEnds {
    start: vec2<f32>,
    end: vec2<f32>,
}

fn tp_positive(v: f32) -> bool {
    return v >= 0.0;
}

// The diamond-exit rule (3.4.1) for a line from a to b, given as (major, minor); d is a - b; `y_major` chooses between the rules for ties.
fn tp_ends(a: vec2<f32>, b: vec2<f32>, d: vec2<f32>, y_major: bool) -> TpEnds {
    let slope = tp_divide(d.y, d.x);
    let fa = a - floor(a);
    let fb = b - floor(b);
    let major1 = fa.x - 0.5;
    let minor1 = fa.y - 0.5;
    let major2 = fb.x - 0.5;
    var minor2 = fb.y - 0.5;
    if (minor2 == -0.5 && d.y < 0.0) {
        minor2 = 0.5;
    }
    let crosses1 = fa.y + tp_mul(major1, slope);
    let crosses2 = fb.y + tp_mul(major2, slope);
    var draw_start = abs(major1) + abs(minor1) < 0.5;
    let near_end = abs(major2) + abs(minor2) < 0.5;
    var draw_end = false;
    var starts = false;
    var stops = false;
    if (!y_major) {
        if (!draw_start && tp_positive(major1) != tp_positive(-d.x)) {
            draw_start = tp_positive(-minor1) != tp_positive(d.y) || (crosses1 < 1.0 && crosses1 > 0.0);
        }
        if (!near_end && tp_positive(major2) == tp_positive(-d.x)) {
            draw_end = tp_positive(-minor2) == tp_positive(d.y) || (crosses2 < 1.0 && crosses2 > 0.0);
        }
        starts = tp_positive(-major1) != tp_positive(d.x);
        stops = tp_positive(major2) == tp_positive(-d.x) || major2 == 0.0;
    } else {
        if (!draw_start && tp_positive(-major1) != tp_positive(d.x)) {
            draw_start = tp_positive(minor1) != tp_positive(-d.y) || (crosses1 < 1.0 && crosses1 > 0.0);
        }
        if (!near_end && tp_positive(-major2) == tp_positive(d.x)) {
            draw_end = tp_positive(minor2) == tp_positive(-d.y) || (crosses2 < 1.0 && crosses2 >= 0.0);
        }
        starts = tp_positive(major1) == tp_positive(d.x);
        stops = tp_positive(-major2) == tp_positive(d.x) || major2 == 0.0;
    }
    // Ends move to the border of their pixel: the far one where the line runs up, the near one where it runs down.
    let border = select(0.5, -0.5, d.x < 0.0);
    let by1 = select(0.0, border - major1, starts != draw_start);
    let by2 = select(0.0, border - major2, stops != draw_end);
    return TpEnds(vec2<f32>(by1, tp_mul(by1, slope)), vec2<f32>(by2, tp_mul(by2, slope)));
}

// A plane of four values along a line's major axis only.
fn tp_line_plane(origin: f32, p: vec3<f32>, x_major: bool, stretched: f32, ooa: f32, a: vec4<f32>, b: vec4<f32>) -> array<vec4<f32>, 3> {
    let along = tp_mul4(tp_mul4(a - b, stretched), ooa);
    let dx = select(vec4<f32>(0.0), along, x_major);
    let dy = select(along, vec4<f32>(0.0), x_major);
    return array<vec4<f32>, 3>(a - (tp_mul4(dx, p.x - origin) + tp_mul4(dy, p.y - origin)), dx, dy);
}

// A line: a parallelogram as wide as the line in its minor direction.
fn tp_line(p: TpPrimitive, index: u32, a: TpCorner, b: TpCorner, front: bool) {
    let head = a.position;
    let tail = b.position;
    let d = head.xy - tail.xy;
    let area = tp_mul(d.x, d.x) + tp_mul(d.y, d.y);
    if (!(area > 0.0 && tp_finite(area))) {
        return;
    }
    let width = tp_state_float(p.state, TP_STATE_LINE_WIDTH);
    let half = i32(min(max(width, 1.0), 255.0) + 0.5) * 256 / 2;
    // Along the major axis only, stretched so that it reaches the other end.
    let x_major = abs(d.x) >= abs(d.y);
    let major = select(d.y, d.x, x_major);
    let slope = tp_divide(select(d.x, d.y, x_major), major);
    let stretched = major * (1.0 + tp_mul(slope, slope));
    let ooa = tp_reciprocal(area);
    let origin = tp_origin(p.flags);
    let zw = tp_line_plane(origin, head, x_major, stretched, ooa, vec4<f32>(head.z, a.inv_w, 0.0, 0.0), vec4<f32>(tail.z, b.inv_w, 0.0, 0.0));
    tp_planes[tp_next_planes] = vec4<f32>(zw[0].x, zw[1].x, zw[2].x, zw[0].y);
    tp_planes[tp_next_planes + 1u] = vec4<f32>(zw[1].y, zw[2].y, 0.0, 0.0);
//#if SMOOTH
    // An antialiased line: the rectangle of all pixels that it may touch, and the planes of its coverage (3.4.2).
    let smooth_line = (p.flags & TP_LINE_SMOOTH) != 0u;
    let length = sqrt(tp_mul(-d.x, -d.x) + tp_mul(-d.y, -d.y));
    let u = vec2<f32>(tp_divide(-d.x, length), tp_divide(-d.y, length));
    let middle = 0.5 * (head.xy + tail.xy);
    let across = 0.5 * min(max(width, 1.0), 255.0) + 0.5;
    let along = 0.5 * length + 0.5;
//#endif
    let count = tp_front_records[p.record + TP_DRAW_VARYING_COUNT];
    for (var k = 0u; k < count; k++) {
        let input = tp_varying(p.record, k, front);
        var planes = tp_constant(tp_shaded[tp_provoking + input.x]);
        if (input.y == TP_INTERPOLATE_COVERAGE) {
            planes = tp_full_coverage();
//#if SMOOTH
            if (smooth_line) {
                let q = vec2<f32>(origin) - middle;
                let a0 = tp_mul(q.x, -u.y) + tp_mul(q.y, u.x);
                let b0 = tp_mul(q.x, u.x) + tp_mul(q.y, u.y);
                planes = array<vec4<f32>, 3>(vec4<f32>(a0, across, b0, along), vec4<f32>(-u.y, 0.0, u.x, 0.0), vec4<f32>(u.x, 0.0, u.y, 0.0));
            }
//#endif
        } else if (input.y != TP_INTERPOLATE_FLAT) {
            let perspective = input.y == TP_INTERPOLATE_PERSPECTIVE;
            let va = tp_mul4(tp_shaded[a.at + input.x], select(1.0, a.inv_w, perspective));
            let vb = tp_mul4(tp_shaded[b.at + input.x], select(1.0, b.inv_w, perspective));
            planes = tp_line_plane(origin, head, x_major, stretched, ooa, va, vb);
        }
        tp_write_planes(k, planes);
    }
    let flags = tp_surface_flags(front) | select(0u, TP_PERSPECTIVE, a.inv_w != 1.0 || b.inv_w != 1.0);
    let e = tp_ends(select(head.yx, head.xy, x_major), select(tail.yx, tail.xy, x_major), select(d.yx, d, x_major), !x_major);
    let start = head.xy + select(e.start.yx, e.start, x_major);
    let end = tail.xy + select(e.end.yx, e.end, x_major);
    let x0 = tp_snap(start.x);
    let y0 = tp_snap(start.y);
    let x1 = tp_snap(end.x);
    let y1 = tp_snap(end.y);
    var x = select(vec4<i32>(x0 - half, x0 + half, x1 + half, x1 - half), vec4<i32>(x0, x1, x1, x0), x_major);
    var y = select(vec4<i32>(y0, y0, y1, y1), vec4<i32>(y0 - half, y1 - half, y1 + half, y0 + half), x_major);
//#if SMOOTH
    if (smooth_line) {
        let s = vec4<f32>(-across, -across, across, across);
        let l = vec4<f32>(-along, along, along, -along);
        for (var k = 0u; k < 4u; k++) {
            x[k] = tp_snap(middle.x + tp_mul(l[k], u.x) - tp_mul(s[k], u.y));
            y[k] = tp_snap(middle.y + tp_mul(l[k], u.y) + tp_mul(s[k], u.x));
        }
    }
//#endif
    tp_rectangle(p, index, x, y, flags);
}
