// Set-up: triangles and their planes are written: the twin of src/raster/setup.rs. Shared by the set-up kernel (primitives inside the view
// volume) and the clip kernel (all others).

// Where the next triangle and the next planes go.
var<private> tp_next_triangle: u32;
var<private> tp_next_planes: u32;

fn tp_write_planes(k: u32, planes: array<vec4<f32>, 3>) {
    let at = tp_next_planes + TP_DEPTH_PLANE_VEC4 + k * TP_VARYING_PLANE_VEC4;
    tp_planes[at] = planes[0];
    tp_planes[at + 1u] = planes[1];
    tp_planes[at + 2u] = planes[2];
}

fn tp_write_triangle(p: TpPrimitive, index: u32, x: vec3<i32>, y: vec3<i32>, columns: u32, rows: u32, flags: u32) {
    let at = tp_next_triangle * TP_TRIANGLE_WORDS;
    for (var k = 0u; k < 3u; k++) {
        tp_triangles[at + k] = bitcast<u32>(x[k]);
        tp_triangles[at + 3u + k] = bitcast<u32>(y[k]);
    }
    tp_triangles[at + TP_TRIANGLE_DRAW] = p.draw;
    tp_triangles[at + TP_TRIANGLE_FLAGS] = flags | select(0u, TP_MULTISAMPLE, (p.flags & TP_MULTISAMPLE_STATE) != 0u);
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
    let box = tp_bounds(x, y, p.state, p.flags);
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
    let basis = tp_basis(tp_origin(p.flags), a.position, b.position, c.position);
    let zw = tp_depth_planes(basis, a, b, c);
    tp_planes[tp_next_planes] = vec4<f32>(zw[0].x, zw[1].x, zw[2].x, zw[0].y);
    tp_planes[tp_next_planes + 1u] = vec4<f32>(zw[1].y, zw[2].y, offset, 0.0);
    let count = tp_front_records[p.record + TP_DRAW_VARYING_COUNT];
    for (var k = 0u; k < count; k++) {
        tp_write_planes(k, tp_varying_planes(p, k, front, basis, a, b, c));
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
    let mode = tp_front_records[p.state + TP_STATE_POLYGON_MODE + select(1u, 0u, front)];
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
