// A triangle that leaves the view volume is cut by the planes that it crosses, one after the other: the twin of src/raster/clip.rs. New
// vertices go to the primitive's part of the pool: their shaded vec4, then window x, y, z and 1/w.

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
        return tp_read(p.record, at + tp_front_records[p.record + TP_DRAW_CLIP_DISTANCES] + (k - 6u) / 4u)[(k - 6u) & 3u];
    }
    let v = tp_read(p.record, at);
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
        let v = tp_read(p.record, source + k);
        tp_write_pool(at + k, v + tp_mul4(tp_read(p.record, goal + k) - v, t));
    }
    let position = tp_read(p.record, at);
    let inv_w = tp_reciprocal(position.w);
    let scale = tp_viewport_scale(p.state);
    let translate = tp_viewport_translate(p.state);
    let ndc = position.xyz * inv_w;
    let window = vec3<f32>(tp_mul(ndc.x, scale.x), tp_mul(ndc.y, scale.y), tp_mul(ndc.z, scale.z)) + translate;
    tp_write_pool(at + p.shaded_stride, vec4<f32>(window, inv_w));
    tp_pooled++;
    return tp_pooled + 2u;
}

fn tp_clip_corner(p: TpPrimitive, corner: u32) -> TpCorner {
    if (corner < 3u) {
        return tp_corner(p, corner);
    }
    return tp_pool_corner(p, tp_vertex_at(p, corner));
}

// What is left of a triangle; no corners where nothing is.
fn tp_clip_polygon(p: TpPrimitive) -> TpPolygon {
    var polygon: TpPolygon;
    polygon.count = 3u;
    polygon.corners[1] = 1u;
    polygon.corners[2] = 2u;
    polygon.edges = p.edges;
    for (var planes = p.code_or; planes != 0u; planes &= planes - 1u) {
        let plane = firstTrailingBit(planes);
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
