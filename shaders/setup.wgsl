// Set-up: what a corner of a triangle is, and how triangles and their planes are written: the twin of src/raster/setup.rs, in the same
// order of operations. Shared by the set-up kernel (primitives inside the view volume) and the clip kernel (all others).

struct TpCorner {
    position: vec3<f32>,
    inv_w: f32,
    snapped: vec2<i32>,
    // Its first vec4 in tp_shaded.
    at: u32,
}

// What the planes of a triangle share.
struct TpBasis {
    x0c: f32,
    y0c: f32,
    dx01: f32,
    dy01: f32,
    dx20: f32,
    dy20: f32,
}

// Where the next triangle and the next planes go.
var<private> tp_next_triangle: u32;
var<private> tp_next_planes: u32;
// The vertex that flat varyings come from (vec4 in tp_shaded).
var<private> tp_provoking: u32;

fn tp_corner(screen: u32, shaded: u32) -> TpCorner {
    let place = bitcast<vec4<f32>>(tp_screen[screen * 2u]);
    return TpCorner(place.xyz, place.w, bitcast<vec2<i32>>(tp_screen[screen * 2u + 1u].xy), shaded);
}

fn tp_basis(a: vec3<f32>, b: vec3<f32>, c: vec3<f32>) -> TpBasis {
    let d01 = a.xy - b.xy;
    let d20 = c.xy - a.xy;
    let ooa = tp_reciprocal(tp_mul(d01.x, d20.y) - tp_mul(d20.x, d01.y));
    return TpBasis(a.x - 0.5, a.y - 0.5, d01.x * ooa, d01.y * ooa, d20.x * ooa, d20.y * ooa);
}

// a0, d/dx, d/dy of four values given at the corners.
fn tp_plane(t: TpBasis, a: vec4<f32>, b: vec4<f32>, c: vec4<f32>) -> array<vec4<f32>, 3> {
    let da01 = a - b;
    let da20 = c - a;
    let dx = tp_mul4(da01, t.dy20) - tp_mul4(da20, t.dy01);
    let dy = tp_mul4(da20, t.dx01) - tp_mul4(da01, t.dx20);
    return array<vec4<f32>, 3>(a - (tp_mul4(dx, t.x0c) + tp_mul4(dy, t.y0c)), dx, dy);
}

fn tp_write_planes(k: u32, planes: array<vec4<f32>, 3>) {
    let at = tp_next_planes + TP_DEPTH_PLANE_VEC4 + k * TP_VARYING_PLANE_VEC4;
    tp_planes[at] = planes[0];
    tp_planes[at + 1u] = planes[1];
    tp_planes[at + 2u] = planes[2];
}

// vec4 of a varying in a shaded vertex (x), and its interpolation (y).
fn tp_varying(record: u32, k: u32, front: bool) -> vec2<u32> {
    let word = tp_records[record + TP_DRAW_VARYINGS + k];
    return vec2<u32>(select(word >> 8u, word, front) & 0xffu, (word >> 16u) & 3u);
}

fn tp_full_coverage() -> array<vec4<f32>, 3> {
    return array<vec4<f32>, 3>(vec4<f32>(0.0, 1.0, 0.0, 1.0), vec4<f32>(0.0), vec4<f32>(0.0));
}

fn tp_constant(v: vec4<f32>) -> array<vec4<f32>, 3> {
    return array<vec4<f32>, 3>(v, vec4<f32>(0.0), vec4<f32>(0.0));
}

// The z offset of a polygon: units + factor * the greatest slope (3.5.5).
fn tp_polygon_offset(state: u32, a: vec3<f32>, b: vec3<f32>, c: vec3<f32>) -> f32 {
    let d01 = a - b;
    let d20 = c - a;
    let ooa = tp_reciprocal(tp_mul(d01.x, d20.y) - tp_mul(d20.x, d01.y));
    let dzdx = abs((tp_mul(d01.z, d20.y) - tp_mul(d20.z, d01.y)) * ooa);
    let dzdy = abs((tp_mul(d20.z, d01.x) - tp_mul(d01.z, d20.x)) * ooa);
    let slope = select(dzdy, dzdx, dzdx > dzdy);
    let offset = tp_state_float(state, TP_STATE_OFFSET_UNITS) + tp_mul(slope, tp_state_float(state, TP_STATE_OFFSET_FACTOR));
    return select(0.0, offset, tp_finite(offset));
}

fn tp_write_triangle(p: TpPrimitive, index: u32, x: vec3<i32>, y: vec3<i32>, columns: u32, rows: u32, flags: u32) {
    let at = tp_next_triangle * TP_TRIANGLE_WORDS;
    for (var k = 0u; k < 3u; k++) {
        tp_triangles[at + k] = bitcast<u32>(x[k]);
        tp_triangles[at + 3u + k] = bitcast<u32>(y[k]);
    }
    tp_triangles[at + TP_TRIANGLE_DRAW] = p.draw;
    tp_triangles[at + TP_TRIANGLE_FLAGS] = flags;
    tp_triangles[at + TP_TRIANGLE_COLUMNS] = columns;
    tp_triangles[at + TP_TRIANGLE_ROWS] = rows;
    tp_triangles[at + TP_TRIANGLE_PLANES] = tp_next_planes;
    tp_triangles[at + TP_TRIANGLE_PRIMITIVE] = index;
    tp_next_triangle++;
}

// A place that was counted and is not used: binning passes it by.
fn tp_write_nothing() {
    let at = tp_next_triangle * TP_TRIANGLE_WORDS;
    tp_triangles[at + TP_TRIANGLE_COLUMNS] = TP_NOWHERE;
    tp_triangles[at + TP_TRIANGLE_ROWS] = TP_NOWHERE;
    tp_next_triangle++;
}

fn tp_surface_flags(front: bool) -> u32 {
    return select(0u, TP_FRONT, front) | select(TP_BOTTOM_UP, 0u, tf.top_first != 0u);
}

// A filled triangle with positive area.
fn tp_triangle(p: TpPrimitive, index: u32, a: TpCorner, b: TpCorner, c: TpCorner, front: bool) {
    let x = vec3<i32>(a.snapped.x, b.snapped.x, c.snapped.x);
    let y = vec3<i32>(a.snapped.y, b.snapped.y, c.snapped.y);
    let box = tp_bounds(x, y, p.state);
    if (box.x == TP_NOWHERE) {
        return;
    }
    let perspective = a.inv_w != 1.0 || b.inv_w != 1.0 || c.inv_w != 1.0;
    let flags = TP_POLYGON | tp_surface_flags(front) | select(0u, TP_PERSPECTIVE, perspective) | select(0u, TP_CUT, box.z != 0u);
    var offset = 0.0;
//#if OFFSET
    if ((p.flags & TP_OFFSET_FILL) != 0u) {
        offset = tp_polygon_offset(p.state, a.position, b.position, c.position);
    }
//#endif
    let basis = tp_basis(a.position, b.position, c.position);
    let zw = tp_plane(
        basis,
        vec4<f32>(a.position.z, a.inv_w, 0.0, 0.0),
        vec4<f32>(b.position.z, b.inv_w, 0.0, 0.0),
        vec4<f32>(c.position.z, c.inv_w, 0.0, 0.0));
    tp_planes[tp_next_planes] = vec4<f32>(zw[0].x, zw[1].x, zw[2].x, zw[0].y);
    tp_planes[tp_next_planes + 1u] = vec4<f32>(zw[1].y, zw[2].y, offset, 0.0);
    let count = tp_records[p.record + TP_DRAW_VARYING_COUNT];
    for (var k = 0u; k < count; k++) {
        let input = tp_varying(p.record, k, front);
        var planes = tp_constant(tp_shaded[tp_provoking + input.x]);
        if (input.y == TP_INTERPOLATE_COVERAGE) {
            planes = tp_full_coverage();
        } else if (input.y != TP_INTERPOLATE_FLAT) {
            let w = select(vec3<f32>(1.0), vec3<f32>(a.inv_w, b.inv_w, c.inv_w), input.y == TP_INTERPOLATE_PERSPECTIVE);
            planes = tp_plane(
                basis,
                tp_mul4(tp_shaded[a.at + input.x], w.x),
                tp_mul4(tp_shaded[b.at + input.x], w.y),
                tp_mul4(tp_shaded[c.at + input.x], w.z));
        }
        tp_write_planes(k, planes);
    }
    tp_write_triangle(p, index, x, y, box.x, box.y, flags);
    tp_next_planes += p.plane_stride;
}

//#if UNFILLED
// Mesa's draw module offsets and clamps the vertices of what it draws by outlines or corners.
fn tp_offset_corner(corner: TpCorner, offset: f32) -> TpCorner {
    var c = corner;
    let z = c.position.z + offset;
    c.position.z = select(min(max(z, 0.0), 1.0), z, offset == 0.0);
    return c;
}
//#endif

// A triangle of a polygon: culled, filled or drawn by its outline or corners. Edge bit 0 is a to b, bit 1 b to c, bit 2 c to a.
fn tp_polygon(p: TpPrimitive, index: u32, a: TpCorner, b: TpCorner, c: TpCorner, edges: u32) {
    let area = tp_area_sign(vec3<i32>(a.snapped.x, b.snapped.x, c.snapped.x), vec3<i32>(a.snapped.y, b.snapped.y, c.snapped.y));
    let front = tp_is_front(area, p.flags);
    if (area == 0 || tp_is_culled(front, p.flags)) {
        return;
    }
//#if UNFILLED
    let mode = tp_records[p.state + TP_STATE_POLYGON_MODE + select(1u, 0u, front)];
    if (mode != TP_TRIANGLES) {
        let lines = mode == TP_LINES;
        var offset = 0.0;
        if ((p.flags & select(TP_OFFSET_POINT, TP_OFFSET_LINE, lines)) != 0u) {
            offset = tp_polygon_offset(p.state, a.position, b.position, c.position);
        }
        let v = array<TpCorner, 3>(tp_offset_corner(a, offset), tp_offset_corner(b, offset), tp_offset_corner(c, offset));
        if (lines) {
            if ((edges & 4u) != 0u) {
                tp_line(p, index, v[2], v[0], front);
            }
            if ((edges & 1u) != 0u) {
                tp_line(p, index, v[0], v[1], front);
            }
            if ((edges & 2u) != 0u) {
                tp_line(p, index, v[1], v[2], front);
            }
        } else {
            for (var k = 0u; k < 3u; k++) {
                if ((edges & (1u << k)) != 0u) {
                    tp_point(p, index, v[k], front);
                }
            }
        }
        return;
    }
//#endif
    if (area > 0) {
        tp_triangle(p, index, a, b, c, front);
    } else {
        tp_triangle(p, index, b, a, c, front);
    }
}
