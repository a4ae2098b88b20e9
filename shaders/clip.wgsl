// A lane a queued primitive: cuts it by the planes that it crosses, one after the other, as src/raster/clip.rs does, and sets up what is
// left. New vertices go to the primitive's part of the pool: their shaded vec4, then window x, y, z and 1/w.

// A polygon of up to 17 corners. A corner is one of the primitive's vertices (0 to 2) or a vertex of the pool (from 3 on).
struct TpPolygon {
    count: u32,
    corners: array<u32, 18>,
    // Bit k: the edge from corner k to the next is a boundary edge.
    edges: u32,
}

var<private> tp_pool: u32;
var<private> tp_pooled: u32;

fn tp_vertex_at(p: TpPrimitive, corner: u32) -> u32 {
    return select(tp_pool + (corner - 3u) * (p.shaded_stride + 1u), p.shaded[min(corner, 2u)], corner < 3u);
}

// Signed distance of a vertex from plane k: the frustum's in the order of the clip codes, then the user's.
fn tp_distance(p: TpPrimitive, corner: u32, k: u32) -> f32 {
    let at = tp_vertex_at(p, corner);
    if (k >= 6u) {
        return tp_shaded[at + tp_records[p.record + TP_DRAW_CLIP_DISTANCES] + (k - 6u) / 4u][(k - 6u) & 3u];
    }
    let v = tp_shaded[at];
    let axis = v[k >> 1u];
    // Right, top and (last) far have the minus sign: bits 0, 2 and 5.
    return select(axis, -axis, ((0x25u >> k) & 1u) != 0u) + v.w;
}

// Appends a + t * (b - a) to the pool and puts it on the screen, unfused as the clipper does.
fn tp_interpolate(p: TpPrimitive, a: u32, b: u32, t: f32) -> u32 {
    let source = tp_vertex_at(p, a);
    let goal = tp_vertex_at(p, b);
    let at = tp_pool + tp_pooled * (p.shaded_stride + 1u);
    for (var k = 0u; k < p.shaded_stride; k++) {
        let v = tp_shaded[source + k];
        tp_shaded[at + k] = v + tp_mul4(tp_shaded[goal + k] - v, t);
    }
    let position = tp_shaded[at];
    let inv_w = tp_reciprocal(position.w);
    let scale = tp_viewport_scale(p.state);
    let translate = tp_viewport_translate(p.state);
    let ndc = position.xyz * inv_w;
    let window = vec3<f32>(tp_mul(ndc.x, scale.x), tp_mul(ndc.y, scale.y), tp_mul(ndc.z, scale.z)) + translate;
    tp_shaded[at + p.shaded_stride] = vec4<f32>(window, inv_w);
    tp_pooled++;
    return tp_pooled + 2u;
}

fn tp_clip_corner(p: TpPrimitive, corner: u32) -> TpCorner {
    if (corner < 3u) {
        return tp_corner(p.screen[corner], p.shaded[corner]);
    }
    let at = tp_vertex_at(p, corner);
    let place = tp_shaded[at + p.shaded_stride];
    return TpCorner(place.xyz, place.w, vec2<i32>(tp_snap(place.x), tp_snap(place.y)), at);
}

// What is left of a triangle; no corners where nothing is.
fn tp_clip_polygon(p: TpPrimitive) -> TpPolygon {
    var polygon: TpPolygon;
    polygon.count = 3u;
    polygon.corners[1] = 1u;
    polygon.corners[2] = 2u;
    polygon.edges = p.edges;
    for (var plane = 0u; plane < 14u; plane++) {
        if (((p.code_or >> plane) & 1u) == 0u) {
            continue;
        }
        var next: TpPolygon;
        var previous = polygon.corners[0];
        var previous_edge = polygon.edges & 1u;
        var d_previous = tp_distance(p, previous, plane);
        var valid = polygon.count >= 3u && tp_finite(d_previous);
        for (var i = 1u; i <= polygon.count; i++) {
            let k = select(i, 0u, i == polygon.count);
            let corner = polygon.corners[k];
            let d = tp_distance(p, corner, plane);
            valid = valid && tp_finite(d);
            if (d_previous >= 0.0) {
                next.corners[next.count] = previous;
                next.edges |= previous_edge << next.count;
                next.count++;
            }
            if ((d_previous >= 0.0) != (d >= 0.0)) {
                var made = 0u;
                // From the end that is nearer to the plane.
                if (abs(d) < abs(d_previous) || (abs(d) == abs(d_previous) && d >= 0.0)) {
                    made = tp_interpolate(p, corner, previous, tp_divide(d, d - d_previous));
                } else {
                    made = tp_interpolate(p, previous, corner, tp_divide(d_previous, d_previous - d));
                }
                // Going out: the edge along the plane is a boundary for user planes, not for the frustum's.
                let edge = select(previous_edge, select(0u, 1u, plane >= 6u), d < 0.0);
                next.corners[next.count] = made;
                next.edges |= edge << next.count;
                next.count++;
            }
            previous = corner;
            previous_edge = (polygon.edges >> k) & 1u;
            d_previous = d;
        }
        polygon = next;
        if (!valid) {
            polygon.count = 0u;
        }
    }
    return polygon;
}

//#if POINTS_AND_LINES
fn tp_clip_line(p: TpPrimitive, index: u32) {
    var t = vec2<f32>(0.0);
    var valid = true;
    for (var plane = 0u; plane < 14u; plane++) {
        if (((p.code_or >> plane) & 1u) != 0u) {
            let d0 = tp_distance(p, 0u, plane);
            let d1 = tp_distance(p, 1u, plane);
            valid = valid && tp_finite(d0) && tp_finite(d1);
            if (d1 < 0.0) {
                t.y = max(t.y, tp_divide(d1, d1 - d0));
            }
            if (d0 < 0.0) {
                t.x = max(t.x, tp_divide(d0, d0 - d1));
            }
            valid = valid && t.x + t.y < 1.0;
        }
    }
    if (!valid) {
        return;
    }
    var a = 0u;
    var b = 1u;
    if (tp_screen[p.screen.x * 2u + 1u].z != 0u) {
        a = tp_interpolate(p, 0u, 1u, t.x);
    }
    if (tp_screen[p.screen.y * 2u + 1u].z != 0u) {
        b = tp_interpolate(p, 1u, 0u, t.y);
    }
    tp_line(p, index, tp_clip_corner(p, a), tp_clip_corner(p, b), true);
}
//#endif

@compute @workgroup_size(TP_LANES)
fn tp_main(@builtin(global_invocation_id) id: vec3<u32>, @builtin(num_workgroups) groups: vec3<u32>) {
    let entry = id.x + id.y * groups.x * TP_LANES;
    if (entry >= tp_front[tf.queue_base]) {
        return;
    }
    let at = tf.queue_base + 4u + entry * 4u;
    let index = tp_front[at];
    let p = tp_primitive(index);
    tp_next_triangle = tp_front[at + 1u];
    tp_next_planes = tp_front[at + 2u];
    tp_pool = tp_front[at + 3u];
    tp_pooled = 0u;
    tp_provoking = p.shaded.z;
    let end = tp_next_triangle + tp_count(p).x;
    var filled = true;
//#if POINTS_AND_LINES
    if (p.topology == TP_LINES) {
        tp_clip_line(p, index);
        filled = false;
    }
//#endif
    if (filled) {
        let polygon = tp_clip_polygon(p);
        // A fan around the first corner, which comes last.
        let n = polygon.count;
        let centre = tp_clip_corner(p, polygon.corners[0]);
        for (var i = 2u; i < n; i++) {
            let last = i == n - 1u;
            var edges = (polygon.edges >> (i - 1u)) & 1u;
            edges |= select(0u, ((polygon.edges >> i) & 1u) << 1u, last);
            edges |= select(0u, (polygon.edges & 1u) << 2u, i == 2u);
            let a = tp_clip_corner(p, polygon.corners[i - 1u]);
            let b = tp_clip_corner(p, polygon.corners[i]);
            tp_polygon(p, index, a, b, centre, edges);
        }
    }
    loop {
        if (tp_next_triangle >= end) {
            break;
        }
        tp_write_nothing();
    }
}
