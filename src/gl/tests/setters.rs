//! One row a setter: what it is at first, what reads back after a legal value, and the error of an illegal one, which
//! changes nothing.

use super::*;

struct Row {
    pname: GLenum,
    default: &'static [f64],
    set: fn(&mut Context),
    value: &'static [f64],
    illegal: Option<(fn(&mut Context), GLenum)>,
}

const fn row(pname: GLenum, default: &'static [f64], set: fn(&mut Context), value: &'static [f64]) -> Row {
    Row { pname, default, set, value, illegal: None }
}

impl Row {
    const fn not(mut self, illegal: fn(&mut Context), error: GLenum) -> Row {
        self.illegal = Some((illegal, error));
        self
    }
}

const WHITE: &[f64] = &[1.0, 1.0, 1.0, 1.0];
const BLACK: &[f64] = &[0.0, 0.0, 0.0, 1.0];
const ZERO4: &[f64] = &[0.0; 4];
const V1: GLenum = GL_INVALID_VALUE;
const EN: GLenum = GL_INVALID_ENUM;
const BAD: GLenum = 0xdead;

/// A one-element slice of an enum.
macro_rules! e {
    ($($name:ident),*) => { &[$($name as f64),*] };
}

const ROWS: &[Row] = &[
    row(GL_POINT_SIZE, &[1.0], |c| c.point_size(300.5), &[300.5]).not(|c| c.point_size(0.0), V1),
    row(GL_POINT_SIZE_MIN, &[0.0], |c| c.point_parameter(GL_POINT_SIZE_MIN, &[2.0]), &[2.0])
        .not(|c| c.point_parameter(GL_POINT_SIZE_MIN, &[-1.0]), V1),
    row(GL_POINT_SIZE_MAX, &[255.0], |c| c.point_parameter(GL_POINT_SIZE_MAX, &[9.0]), &[9.0])
        .not(|c| c.point_parameter(GL_POINT_SIZE_MAX, &[f32::NAN]), V1),
    row(GL_POINT_FADE_THRESHOLD_SIZE, &[1.0], |c| c.point_parameter(GL_POINT_FADE_THRESHOLD_SIZE, &[4.0]), &[4.0])
        .not(|c| c.point_parameter(BAD, &[4.0]), EN),
    row(
        GL_POINT_DISTANCE_ATTENUATION,
        &[1.0, 0.0, 0.0],
        |c| c.point_parameter(GL_POINT_DISTANCE_ATTENUATION, &[0.5, 0.25, 2.0]),
        &[0.5, 0.25, 2.0],
    )
    .not(|c| c.point_parameter(GL_POINT_DISTANCE_ATTENUATION, &[1.0]), EN),
    row(GL_LINE_WIDTH, &[1.0], |c| c.line_width(2.5), &[2.5]).not(|c| c.line_width(-1.0), V1),
    row(GL_LINE_STIPPLE_PATTERN, &[65535.0], |c| c.line_stipple(3, 0x00ff), &[255.0]),
    row(GL_LINE_STIPPLE_REPEAT, &[1.0], |c| c.line_stipple(999, 1), &[256.0]),
    row(GL_LINE_STIPPLE_REPEAT, &[1.0], |c| c.line_stipple(-4, 1), &[1.0]),
    row(GL_CULL_FACE_MODE, e!(GL_BACK), |c| c.cull_face(GL_FRONT_AND_BACK), e!(GL_FRONT_AND_BACK)).not(|c| c.cull_face(GL_LEFT), EN),
    row(GL_FRONT_FACE, e!(GL_CCW), |c| c.front_face(GL_CW), e!(GL_CW)).not(|c| c.front_face(GL_FRONT), EN),
    row(GL_POLYGON_MODE, e!(GL_FILL, GL_FILL), |c| c.polygon_mode(GL_BACK, GL_LINE), e!(GL_FILL, GL_LINE))
        .not(|c| c.polygon_mode(GL_FRONT, GL_LINES), EN),
    row(GL_POLYGON_MODE, e!(GL_FILL, GL_FILL), |c| c.polygon_mode(GL_FRONT_AND_BACK, GL_POINT), e!(GL_POINT, GL_POINT))
        .not(|c| c.polygon_mode(GL_NONE, GL_FILL), EN),
    row(GL_POLYGON_OFFSET_FACTOR, &[0.0], |c| c.polygon_offset(-1.5, 2.0), &[-1.5]),
    row(GL_POLYGON_OFFSET_UNITS, &[0.0], |c| c.polygon_offset(-1.5, 2.0), &[2.0]),
    row(GL_SHADE_MODEL, e!(GL_SMOOTH), |c| c.shade_model(GL_FLAT), e!(GL_FLAT)).not(|c| c.shade_model(GL_FILL), EN),
    row(GL_FOG_HINT, e!(GL_DONT_CARE), |c| c.hint(GL_FOG_HINT, GL_NICEST), e!(GL_NICEST)).not(|c| c.hint(GL_FOG_HINT, GL_FOG), EN),
    row(GL_PERSPECTIVE_CORRECTION_HINT, e!(GL_DONT_CARE), |c| c.hint(GL_PERSPECTIVE_CORRECTION_HINT, GL_FASTEST), e!(GL_FASTEST))
        .not(|c| c.hint(GL_FOG, GL_FASTEST), EN),
    row(GL_POINT_SMOOTH_HINT, e!(GL_DONT_CARE), |c| c.hint(GL_POINT_SMOOTH_HINT, GL_NICEST), e!(GL_NICEST)),
    row(GL_LINE_SMOOTH_HINT, e!(GL_DONT_CARE), |c| c.hint(GL_LINE_SMOOTH_HINT, GL_NICEST), e!(GL_NICEST)),
    row(GL_POLYGON_SMOOTH_HINT, e!(GL_DONT_CARE), |c| c.hint(GL_POLYGON_SMOOTH_HINT, GL_NICEST), e!(GL_NICEST)),
    row(GL_ALPHA_TEST_FUNC, e!(GL_ALWAYS), |c| c.alpha_func(GL_GREATER, 0.5), e!(GL_GREATER)).not(|c| c.alpha_func(GL_ONE, 0.5), EN),
    row(GL_ALPHA_TEST_REF, &[0.0], |c| c.alpha_func(GL_LESS, 7.0), &[1.0]),
    row(GL_STENCIL_FUNC, e!(GL_ALWAYS), |c| c.stencil_func(GL_EQUAL, 3, 15), e!(GL_EQUAL)).not(|c| c.stencil_func(GL_ZERO, 3, 15), EN),
    row(GL_STENCIL_REF, &[0.0], |c| c.stencil_func(GL_EQUAL, 999, 15), &[255.0]),
    row(GL_STENCIL_REF, &[0.0], |c| c.stencil_func(GL_EQUAL, -5, 15), &[0.0]),
    row(GL_STENCIL_VALUE_MASK, &[255.0], |c| c.stencil_func(GL_EQUAL, 3, 15), &[15.0]),
    row(GL_STENCIL_BACK_FUNC, e!(GL_ALWAYS), |c| c.stencil_func_separate(GL_BACK, GL_LESS, 1, 3), e!(GL_LESS))
        .not(|c| c.stencil_func_separate(GL_LEFT, GL_LESS, 1, 3), EN),
    row(GL_STENCIL_BACK_FUNC, e!(GL_ALWAYS), |c| c.stencil_func_separate(GL_FRONT, GL_LESS, 1, 3), e!(GL_ALWAYS)),
    row(GL_STENCIL_BACK_VALUE_MASK, &[255.0], |c| c.stencil_func(GL_EQUAL, 3, 7), &[7.0]),
    row(GL_STENCIL_FAIL, e!(GL_KEEP), |c| c.stencil_op(GL_ZERO, GL_INCR, GL_DECR_WRAP), e!(GL_ZERO))
        .not(|c| c.stencil_op(GL_ONE, GL_KEEP, GL_KEEP), EN),
    row(GL_STENCIL_PASS_DEPTH_FAIL, e!(GL_KEEP), |c| c.stencil_op(GL_ZERO, GL_INCR, GL_DECR_WRAP), e!(GL_INCR))
        .not(|c| c.stencil_op(GL_KEEP, GL_NONE + 1, GL_KEEP), EN),
    row(GL_STENCIL_PASS_DEPTH_PASS, e!(GL_KEEP), |c| c.stencil_op(GL_ZERO, GL_INCR, GL_DECR_WRAP), e!(GL_DECR_WRAP)),
    row(GL_STENCIL_BACK_FAIL, e!(GL_KEEP), |c| c.stencil_op_separate(GL_BACK, GL_INVERT, GL_KEEP, GL_KEEP), e!(GL_INVERT))
        .not(|c| c.stencil_op_separate(GL_ZERO, GL_INVERT, GL_KEEP, GL_KEEP), EN),
    row(GL_STENCIL_WRITEMASK, &[255.0], |c| c.stencil_mask(0xf0), &[240.0]),
    row(GL_STENCIL_BACK_WRITEMASK, &[255.0], |c| c.stencil_mask_separate(GL_BACK, 1), &[1.0])
        .not(|c| c.stencil_mask_separate(GL_NONE, 1), EN),
    row(GL_STENCIL_CLEAR_VALUE, &[0.0], |c| c.clear_stencil(300), &[300.0]),
    row(GL_DEPTH_FUNC, e!(GL_LESS), |c| c.depth_func(GL_GEQUAL), e!(GL_GEQUAL)).not(|c| c.depth_func(GL_NEVER - 1), EN),
    row(GL_DEPTH_WRITEMASK, &[1.0], |c| c.depth_mask(false), &[0.0]),
    row(GL_DEPTH_CLEAR_VALUE, &[1.0], |c| c.clear_depth(-3.0), &[0.0]),
    row(GL_BLEND_SRC, e!(GL_ONE), |c| c.blend_func(GL_SRC_ALPHA_SATURATE, GL_SRC_COLOR), e!(GL_SRC_ALPHA_SATURATE))
        .not(|c| c.blend_func(GL_KEEP, GL_ONE), EN),
    row(GL_BLEND_DST, e!(GL_ZERO), |c| c.blend_func(GL_ONE, GL_ONE_MINUS_CONSTANT_ALPHA), e!(GL_ONE_MINUS_CONSTANT_ALPHA))
        .not(|c| c.blend_func(GL_ONE, GL_SRC_ALPHA_SATURATE), EN),
    row(GL_BLEND_SRC_ALPHA, e!(GL_ONE), |c| c.blend_func_separate(GL_ONE, GL_ZERO, GL_DST_ALPHA, GL_ONE), e!(GL_DST_ALPHA)),
    row(GL_BLEND_DST_ALPHA, e!(GL_ZERO), |c| c.blend_func_separate(GL_ONE, GL_ZERO, GL_DST_ALPHA, GL_ONE), e!(GL_ONE)),
    row(GL_BLEND_EQUATION, e!(GL_FUNC_ADD), |c| c.blend_equation(GL_MAX), e!(GL_MAX)).not(|c| c.blend_equation(GL_ADD), EN),
    row(GL_BLEND_EQUATION_ALPHA, e!(GL_FUNC_ADD), |c| c.blend_equation_separate(GL_MAX, GL_FUNC_SUBTRACT), e!(GL_FUNC_SUBTRACT)),
    row(GL_BLEND_COLOR, ZERO4, |c| c.blend_color(0.5, 2.0, -1.0, 1.0), &[0.5, 1.0, 0.0, 1.0]),
    row(GL_LOGIC_OP_MODE, e!(GL_COPY), |c| c.logic_op(GL_XOR), e!(GL_XOR)).not(|c| c.logic_op(GL_SET + 1), EN),
    row(GL_COLOR_WRITEMASK, WHITE, |c| c.color_mask(true, false, false, true), &[1.0, 0.0, 0.0, 1.0]),
    row(GL_INDEX_WRITEMASK, &[-1.0], |c| c.index_mask(5), &[5.0]),
    row(GL_COLOR_CLEAR_VALUE, ZERO4, |c| c.clear_color(0.25, 1.5, -0.5, 1.0), &[0.25, 1.0, 0.0, 1.0]),
    row(GL_INDEX_CLEAR_VALUE, &[0.0], |c| c.clear_index(7.5), &[7.5]),
    row(GL_ACCUM_CLEAR_VALUE, ZERO4, |c| c.clear_accum(-2.0, 0.5, 3.0, -0.25), &[-1.0, 0.5, 1.0, -0.25]),
    row(GL_SAMPLE_COVERAGE_VALUE, &[1.0], |c| c.sample_coverage(0.5, true), &[0.5]),
    row(GL_SAMPLE_COVERAGE_INVERT, &[0.0], |c| c.sample_coverage(0.5, true), &[1.0]),
    row(GL_FOG_MODE, e!(GL_EXP), |c| c.fog(GL_FOG_MODE, &[GL_LINEAR as f32]), e!(GL_LINEAR))
        .not(|c| c.fog(GL_FOG_MODE, &[GL_NEAREST as f32]), EN),
    row(GL_FOG_COLOR, ZERO4, |c| c.fog(GL_FOG_COLOR, &[0.5, 2.0, 0.0, 1.0]), &[0.5, 1.0, 0.0, 1.0])
        .not(|c| c.fog(GL_FOG_COLOR, &[0.5]), EN),
    row(GL_FOG_DENSITY, &[1.0], |c| c.fog(GL_FOG_DENSITY, &[0.25]), &[0.25]).not(|c| c.fog(GL_FOG_DENSITY, &[-0.25]), V1),
    row(GL_FOG_START, &[0.0], |c| c.fog(GL_FOG_START, &[-3.0]), &[-3.0]).not(|c| c.fog(GL_FOG, &[1.0]), EN),
    row(GL_FOG_END, &[1.0], |c| c.fog(GL_FOG_END, &[9.0]), &[9.0]),
    row(GL_FOG_INDEX, &[0.0], |c| c.fog(GL_FOG_INDEX, &[2.0]), &[2.0]),
    row(GL_FOG_COORD_SRC, e!(GL_FRAGMENT_DEPTH), |c| c.fog(GL_FOG_COORD_SRC, &[GL_FOG_COORD as f32]), e!(GL_FOG_COORD)),
    row(
        GL_LIGHT_MODEL_AMBIENT,
        &[0.2, 0.2, 0.2, 1.0],
        |c| c.light_model(GL_LIGHT_MODEL_AMBIENT, &[3.0, 0.0, -1.0, 0.5]),
        &[3.0, 0.0, -1.0, 0.5],
    )
    .not(|c| c.light_model(GL_LIGHT_MODEL_AMBIENT, &[1.0]), EN),
    row(GL_LIGHT_MODEL_LOCAL_VIEWER, &[0.0], |c| c.light_model(GL_LIGHT_MODEL_LOCAL_VIEWER, &[2.0]), &[1.0]),
    row(GL_LIGHT_MODEL_TWO_SIDE, &[0.0], |c| c.light_model(GL_LIGHT_MODEL_TWO_SIDE, &[1.0]), &[1.0])
        .not(|c| c.light_model(GL_LIGHTING, &[1.0]), EN),
    row(
        GL_LIGHT_MODEL_COLOR_CONTROL,
        e!(GL_SINGLE_COLOR),
        |c| c.light_model(GL_LIGHT_MODEL_COLOR_CONTROL, &[GL_SEPARATE_SPECULAR_COLOR as f32]),
        e!(GL_SEPARATE_SPECULAR_COLOR),
    )
    .not(|c| c.light_model(GL_LIGHT_MODEL_COLOR_CONTROL, &[1.0]), EN),
    row(GL_COLOR_MATERIAL_FACE, e!(GL_FRONT_AND_BACK), |c| c.color_material(GL_FRONT, GL_EMISSION), e!(GL_FRONT))
        .not(|c| c.color_material(GL_LEFT, GL_EMISSION), EN),
    row(GL_COLOR_MATERIAL_PARAMETER, e!(GL_AMBIENT_AND_DIFFUSE), |c| c.color_material(GL_BACK, GL_SPECULAR), e!(GL_SPECULAR))
        .not(|c| c.color_material(GL_FRONT, GL_SHININESS), EN),
    row(GL_MAP1_GRID_SEGMENTS, &[1.0], |c| c.map_grid1(7, -1.0, 2.0), &[7.0]).not(|c| c.map_grid1(0, 0.0, 1.0), V1),
    row(GL_MAP1_GRID_DOMAIN, &[0.0, 1.0], |c| c.map_grid1(7, -1.0, 2.0), &[-1.0, 2.0]),
    row(GL_MAP2_GRID_SEGMENTS, &[1.0, 1.0], |c| c.map_grid2(7, 0.0, 1.0, 3, 0.0, 1.0), &[7.0, 3.0])
        .not(|c| c.map_grid2(7, 0.0, 1.0, -3, 0.0, 1.0), V1),
    row(GL_MAP2_GRID_DOMAIN, &[0.0, 1.0, 0.0, 1.0], |c| c.map_grid2(7, 2.0, 3.0, 3, 4.0, 5.0), &[2.0, 3.0, 4.0, 5.0]),
    row(GL_ACTIVE_TEXTURE, e!(GL_TEXTURE0), |c| c.active_texture(GL_TEXTURE7), e!(GL_TEXTURE7)).not(|c| c.active_texture(GL_TEXTURE8), EN),
    row(GL_CURRENT_COLOR, WHITE, |c| c.color(2.0, -1.0, 0.5, 0.0), &[2.0, -1.0, 0.5, 0.0]),
    row(GL_CURRENT_NORMAL, &[0.0, 0.0, 1.0], |c| c.normal(2.0, -1.0, 0.5), &[2.0, -1.0, 0.5]),
    row(GL_CURRENT_TEXTURE_COORDS, BLACK, |c| c.tex_coord(1.0, 2.0, 3.0, 4.0), &[1.0, 2.0, 3.0, 4.0]),
    row(GL_CURRENT_RASTER_POSITION, BLACK, |c| c.window_pos(3.0, 4.0, 2.0), &[3.0, 4.0, 1.0, 1.0]),
    row(GL_CURRENT_RASTER_COLOR, WHITE, |c| c.window_pos(0.0, 0.0, 0.0), WHITE),
    row(GL_EDGE_FLAG, &[1.0], |c| c.edge_flag(false), &[0.0]),
];

#[test]
fn every_setter_has_its_default_reads_back_and_refuses_what_is_illegal() {
    let mut cx = context();
    for row in ROWS {
        let what = format!("{:#x}", row.pname);
        assert_eq!(get(&mut cx, row.pname), rounded(row.default), "default of {what}");
        (row.set)(&mut cx);
        assert_eq!(get(&mut cx, row.pname), row.value, "{what} after it was set");
        if let Some((illegal, error)) = row.illegal {
            assert_eq!(error_of(&mut cx, illegal), error, "error of {what}");
            assert_eq!(get(&mut cx, row.pname), row.value, "{what} after an error");
        }
        cx.state = Default::default();
    }
}

#[test]
fn no_setter_works_between_begin_and_end() {
    let mut cx = context();
    // Current values are what Begin and End are for.
    let current = [GL_CURRENT_COLOR, GL_CURRENT_NORMAL, GL_CURRENT_TEXTURE_COORDS, GL_EDGE_FLAG];
    for row in ROWS.iter().filter(|row| !current.contains(&row.pname)) {
        cx.begin(GL_POINTS);
        (row.set)(&mut cx);
        cx.end();
        assert_eq!(cx.get_error(), GL_INVALID_OPERATION, "{:#x}", row.pname);
        assert_eq!(get(&mut cx, row.pname), rounded(row.default), "{:#x}", row.pname);
    }
}

#[test]
fn setters_in_a_display_list_act_when_it_is_called() {
    for row in ROWS {
        let mut cx = context();
        cx.new_list(1, GL_COMPILE);
        (row.set)(&mut cx);
        if let Some((illegal, _)) = row.illegal {
            illegal(&mut cx);
        }
        cx.end_list();
        assert_eq!(get(&mut cx, row.pname), rounded(row.default), "{:#x} while compiling", row.pname);
        assert_eq!(error_of(&mut cx, |cx| cx.call_list(1)), row.illegal.map_or(GL_NO_ERROR, |(_, error)| error), "{:#x}", row.pname);
        assert_eq!(get(&mut cx, row.pname), row.value, "{:#x} after the call", row.pname);
    }
}
