// A primitive as cull, set-up and clip see it, and how many triangles it makes at most.

struct TpPrimitive {
    draw: u32,
    // Words of its record and of its raster state.
    record: u32,
    state: u32,
    flags: u32,
    topology: u32,
    // Edge flags: bit 0 the edge from vertex 0 to 1, and so on.
    edges: u32,
    // Its vertices' first vec4 among the shaded ones, and what is there: their clip positions.
    shaded: vec3<u32>,
    positions: array<vec4<f32>, 3>,
    // Clip codes, joined and common, where they are asked for.
    code_or: u32,
    code_and: u32,
    // vec4 of a triangle's planes, of a shaded vertex.
    plane_stride: u32,
    shaded_stride: u32,
}

fn tp_primitive(index: u32) -> TpPrimitive {
    var p: TpPrimitive;
    let words = tp_primitives[index];
    p.draw = words.w & 0xffffffu;
    p.edges = (words.w >> 24u) & 7u;
    p.record = p.draw * TP_DRAW_RECORD_WORDS;
    p.state = tf.state_base + tp_front_records[p.record + TP_DRAW_RASTER_STATE] * TP_STATE_WORDS;
    p.flags = tp_front_records[p.state + TP_STATE_FLAGS];
    p.topology = tp_front_records[p.record + TP_DRAW_TOPOLOGY];
    p.plane_stride = TP_DEPTH_PLANE_VEC4 + TP_VARYING_PLANE_VEC4 * tp_front_records[p.record + TP_DRAW_VARYING_COUNT];
    p.shaded_stride = tp_front_records[p.record + TP_DRAW_SHADED_STRIDE];
    // Vertices that the topology has not repeat the last one.
    var v = words.xyz;
    if (p.topology == TP_POINTS) {
        v = v.xxx;
    }
    if (p.topology == TP_LINES) {
        v = v.xyy;
    }
    p.shaded = tp_front_records[p.record + TP_DRAW_SHADED_BASE] + v * p.shaded_stride - tf.shaded_base;
    p.positions = array<vec4<f32>, 3>(
        tp_position(p.record, v.x, p.shaded.x), tp_position(p.record, v.y, p.shaded.y), tp_position(p.record, v.z, p.shaded.z));
    return p;
}

// The same with its clip codes.
fn tp_coded_primitive(index: u32) -> TpPrimitive {
    var p = tp_primitive(index);
    let inside = tp_is_inside(p.positions[0]) && tp_is_inside(p.positions[1]) && tp_is_inside(p.positions[2]);
    if (!inside || tp_front_records[p.record + TP_DRAW_CLIP_DISTANCE_COUNT] > 0u) {
        let codes = vec3<u32>(tp_code(p, 0u), tp_code(p, 1u), tp_code(p, 2u));
        p.code_or = codes.x | codes.y | codes.z;
        p.code_and = codes.x & codes.y & codes.z;
    }
    return p;
}

// The clip code of a primitive's vertex.
fn tp_code(p: TpPrimitive, vertex: u32) -> u32 {
    return tp_clip_code(p.positions[vertex], p.shaded[vertex], p.record, p.flags);
}

// A primitive's vertex on the screen.
fn tp_corner(p: TpPrimitive, vertex: u32) -> TpCorner {
    return tp_on_screen(p.positions[vertex], p.shaded[vertex], p.state, p.flags);
}

// A vertex that clipping made, at `at`: its place on the screen is behind it.
fn tp_pool_corner(p: TpPrimitive, at: u32) -> TpCorner {
    let place = tp_read(p.record, at + p.shaded_stride);
    return TpCorner(place.xyz, place.w, vec2<i32>(tp_snap(place.x), tp_snap(place.y)), at);
}

// Twice the area with the sign that decides the face: -1, 0, 1. Positive is counter-clockwise in rows that run down.
fn tp_area_sign(x: vec3<i32>, y: vec3<i32>) -> i32 {
//#if INT64
    let area = i64(x.x - x.y) * i64(y.z - y.x) - i64(x.z - x.x) * i64(y.x - y.y);
    return select(select(1, 0, area == 0), -1, area < 0);
//#else
    let a = tp_mul64(x.x - x.y, y.z - y.x);
    let b = tp_mul64(x.z - x.x, y.x - y.y);
    let low = a.x - b.x;
    let high = bitcast<i32>(a.y - b.y - select(0u, 1u, a.x < b.x));
    return select(select(1, 0, (high | bitcast<i32>(low)) == 0), -1, high < 0);
//#endif
}

fn tp_is_front(area: i32, flags: u32) -> bool {
    let ccw = (area > 0) == (tf.top_first != 0u);
    return ccw == ((flags & TP_FRONT_CCW) != 0u);
}

fn tp_is_culled(front: bool, flags: u32) -> bool {
    return (flags & select(TP_CULL_BACK, TP_CULL_FRONT, front)) != 0u;
}

// First and last column and row that a sample may lie in, packed, scissor applied; 1 in z where the scissor took some away;
// columns TP_NOWHERE where no sample is left.
fn tp_bounds(x: vec3<i32>, y: vec3<i32>, state: u32, flags: u32) -> vec3<u32> {
    // Samples lie up to 128 subpixels before the centre and up to 112 behind it.
    let multisample = (flags & TP_MULTISAMPLE_STATE) != 0u;
    let before = select(0, 128, multisample);
    let behind = select(0, 112, multisample);
    let low = bitcast<vec2<i32>>(vec2<u32>(tp_front_records[state + TP_STATE_SCISSOR_MIN], tp_front_records[state + TP_STATE_SCISSOR_MIN + 1u]));
    let high = bitcast<vec2<i32>>(vec2<u32>(tp_front_records[state + TP_STATE_SCISSOR_MAX], tp_front_records[state + TP_STATE_SCISSOR_MAX + 1u])) - 1;
    let first = (vec2<i32>(min(min(x.x, x.y), x.z), min(min(y.x, y.y), y.z)) + (255 - behind)) >> vec2<u32>(8u);
    let last = (vec2<i32>(max(max(x.x, x.y), x.z), max(max(y.x, y.y), y.z)) + before) >> vec2<u32>(8u);
    let least = max(first, low);
    let most = min(last, high);
    let cut = any(first < low) || any(last > high);
    let packed = bitcast<vec2<u32>>(least | (most << vec2<u32>(16u)));
    let empty = any(least > most);
    return vec3<u32>(select(packed.x, TP_NOWHERE, empty), packed.y, select(0u, 1u, cut));
}

// What a primitive takes at most: triangles, vec4 of planes, vec4 of the pool, entries of the clip queue.
fn tp_count(p: TpPrimitive) -> vec4<u32> {
    if (p.code_or == 0u) {
        if (p.topology != TP_TRIANGLES) {
            return vec4<u32>(2u, p.plane_stride, 0u, 0u);
        }
        let a = tp_corner(p, 0u).snapped;
        let b = tp_corner(p, 1u).snapped;
        let c = tp_corner(p, 2u).snapped;
        let x = vec3<i32>(a.x, b.x, c.x);
        let y = vec3<i32>(a.y, b.y, c.y);
        let area = tp_area_sign(x, y);
        let front = tp_is_front(area, p.flags);
        if (area == 0 || tp_is_culled(front, p.flags)) {
            return vec4<u32>(0u);
        }
//#if UNFILLED
        if (tp_front_records[p.state + TP_STATE_POLYGON_MODE + select(1u, 0u, front)] != TP_TRIANGLES) {
            let edges = countOneBits(p.edges);
            return vec4<u32>(2u * edges, edges * p.plane_stride, 0u, 0u);
        }
//#endif
        return select(vec4<u32>(1u, p.plane_stride, 0u, 0u), vec4<u32>(0u), tp_bounds(x, y, p.state, p.flags).x == TP_NOWHERE);
    }
    if ((p.code_or & TP_CLIP_INVALID) != 0u || p.code_and != 0u || p.topology == TP_POINTS) {
        return vec4<u32>(0u);
    }
    if (p.topology == TP_LINES) {
        return vec4<u32>(2u, p.plane_stride, 2u * (p.shaded_stride + 1u), 1u);
    }
    // Each plane adds a vertex to the polygon, and makes two.
    let planes = countOneBits(p.code_or);
    var triangles = 1u + planes;
//#if UNFILLED
    if ((tp_front_records[p.state + TP_STATE_POLYGON_MODE] & tp_front_records[p.state + TP_STATE_POLYGON_MODE + 1u] & TP_TRIANGLES) == 0u) {
        triangles = 2u * (3u + planes);
    }
//#endif
    return vec4<u32>(triangles, triangles * p.plane_stride, 2u * planes * (p.shaded_stride + 1u), 1u);
}
