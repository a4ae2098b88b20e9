// The planes through a triangle's corners: the arithmetic of src/raster/setup.rs, in the same order of operations.

// What the planes of a triangle share.
struct TpBasis {
    x0c: f32,
    y0c: f32,
    dx01: f32,
    dy01: f32,
    dx20: f32,
    dy20: f32,
}

// The vertex that flat varyings come from (its first vec4).
var<private> tp_provoking: u32;

// Where planes begin in a pixel: at its centre, but for multisampled primitives at its first corner (setup.rs, to_centre).
fn tp_origin(state_flags: u32) -> f32 {
    return select(0.5, 0.0, (state_flags & TP_MULTISAMPLE_STATE) != 0u);
}

fn tp_basis(origin: f32, a: vec3<f32>, b: vec3<f32>, c: vec3<f32>) -> TpBasis {
    let d01 = a.xy - b.xy;
    let d20 = c.xy - a.xy;
    let ooa = tp_reciprocal(tp_mul(d01.x, d20.y) - tp_mul(d20.x, d01.y));
    return TpBasis(a.x - origin, a.y - origin, d01.x * ooa, d01.y * ooa, d20.x * ooa, d20.y * ooa);
}

// a0, d/dx, d/dy of four values given at the corners.
fn tp_plane(t: TpBasis, a: vec4<f32>, b: vec4<f32>, c: vec4<f32>) -> array<vec4<f32>, 3> {
    let da01 = a - b;
    let da20 = c - a;
    let dx = tp_mul4(da01, t.dy20) - tp_mul4(da20, t.dy01);
    let dy = tp_mul4(da20, t.dx01) - tp_mul4(da01, t.dx20);
    return array<vec4<f32>, 3>(a - (tp_mul4(dx, t.x0c) + tp_mul4(dy, t.y0c)), dx, dy);
}

// vec4 of a varying in a shaded vertex (x), and its interpolation (y).
fn tp_varying(record: u32, k: u32, front: bool) -> vec2<u32> {
    let word = tp_front_records[record + TP_DRAW_VARYINGS + k];
    return vec2<u32>(select(word >> 8u, word, front) & 0xffu, (word >> 16u) & 3u);
}

fn tp_full_coverage() -> array<vec4<f32>, 3> {
    return array<vec4<f32>, 3>(vec4<f32>(0.0, 1.0, 0.0, 1.0), vec4<f32>(0.0), vec4<f32>(0.0));
}

fn tp_constant(v: vec4<f32>) -> array<vec4<f32>, 3> {
    return array<vec4<f32>, 3>(v, vec4<f32>(0.0), vec4<f32>(0.0));
}

// The step of floating-point depths at the farthest vertex (ARB_depth_buffer_float, 3.5.5); zero where there is no normal number that small.
fn tp_float_step(z: vec3<f32>) -> f32 {
    let exponent = bitcast<i32>(max(z.x, max(z.y, z.z))) & 0x7f800000;
    return bitcast<f32>(max(exponent - (23 << 23u), 0));
}

// The z offset of a polygon: units + factor * the greatest slope (3.5.5).
fn tp_polygon_offset(state: u32, a: vec3<f32>, b: vec3<f32>, c: vec3<f32>) -> f32 {
    let d01 = a - b;
    let d20 = c - a;
    let ooa = tp_reciprocal(tp_mul(d01.x, d20.y) - tp_mul(d20.x, d01.y));
    let dzdx = abs((tp_mul(d01.z, d20.y) - tp_mul(d20.z, d01.y)) * ooa);
    let dzdy = abs((tp_mul(d20.z, d01.x) - tp_mul(d01.z, d20.x)) * ooa);
    let slope = select(dzdy, dzdx, dzdx > dzdy);
    var units = tp_state_float(state, TP_STATE_OFFSET_UNITS);
    if ((tp_front_records[state + TP_STATE_FLAGS] & TP_FLOAT_DEPTH) != 0u) {
        units = tp_mul(units, tp_float_step(vec3<f32>(a.z, b.z, c.z)));
    }
    let offset = units + tp_mul(slope, tp_state_float(state, TP_STATE_OFFSET_FACTOR));
    return select(0.0, offset, tp_finite(offset));
}

// z and 1/w, in x and y.
fn tp_depth_planes(t: TpBasis, a: TpCorner, b: TpCorner, c: TpCorner) -> array<vec4<f32>, 3> {
    return tp_plane(
        t,
        vec4<f32>(a.position.z, a.inv_w, 0.0, 0.0),
        vec4<f32>(b.position.z, b.inv_w, 0.0, 0.0),
        vec4<f32>(c.position.z, c.inv_w, 0.0, 0.0));
}

// The planes of varying k of a filled triangle.
fn tp_varying_planes(p: TpPrimitive, k: u32, front: bool, basis: TpBasis, a: TpCorner, b: TpCorner, c: TpCorner) -> array<vec4<f32>, 3> {
    let input = tp_varying(p.record, k, front);
    var planes = tp_constant(tp_read(p.record, tp_provoking + input.x));
    if (input.y == TP_INTERPOLATE_COVERAGE) {
        planes = tp_full_coverage();
    } else if (input.y != TP_INTERPOLATE_FLAT) {
        let w = select(vec3<f32>(1.0), vec3<f32>(a.inv_w, b.inv_w, c.inv_w), input.y == TP_INTERPOLATE_PERSPECTIVE);
        planes = tp_plane(
            basis,
            tp_mul4(tp_read(p.record, a.at + input.x), w.x),
            tp_mul4(tp_read(p.record, b.at + input.x), w.y),
            tp_mul4(tp_read(p.record, c.at + input.x), w.z));
    }
    return planes;
}
