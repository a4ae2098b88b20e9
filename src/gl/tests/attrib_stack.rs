//! PushAttrib and PopAttrib.

use super::*;

/// A bit, something in its group to change, and the name under which that is seen.
const GROUPS: &[(GLenum, fn(&mut Context), GLenum)] = &[
    (GL_CURRENT_BIT, |c| c.color(0.5, 0.5, 0.5, 0.5), GL_CURRENT_COLOR),
    (GL_CURRENT_BIT, |c| c.window_pos(9.0, 9.0, 0.0), GL_CURRENT_RASTER_POSITION),
    (GL_CURRENT_BIT, |c| c.edge_flag(false), GL_EDGE_FLAG),
    (GL_POINT_BIT, |c| c.point_size(3.0), GL_POINT_SIZE),
    (GL_POINT_BIT | GL_ENABLE_BIT, |c| c.enable(GL_POINT_SMOOTH), GL_POINT_SMOOTH),
    (GL_LINE_BIT, |c| c.line_stipple(3, 3), GL_LINE_STIPPLE_PATTERN),
    (GL_LINE_BIT | GL_ENABLE_BIT, |c| c.enable(GL_LINE_STIPPLE), GL_LINE_STIPPLE),
    (GL_POLYGON_BIT, |c| c.polygon_mode(GL_FRONT, GL_LINE), GL_POLYGON_MODE),
    (GL_POLYGON_BIT | GL_ENABLE_BIT, |c| c.enable(GL_CULL_FACE), GL_CULL_FACE),
    (GL_POLYGON_BIT | GL_ENABLE_BIT, |c| c.enable(GL_POLYGON_STIPPLE), GL_POLYGON_STIPPLE),
    (GL_POLYGON_BIT | GL_ENABLE_BIT, |c| c.enable(GL_POLYGON_OFFSET_LINE), GL_POLYGON_OFFSET_LINE),
    (GL_PIXEL_MODE_BIT, |c| c.pixel_transferf(GL_RED_SCALE, 2.0), GL_RED_SCALE),
    (GL_PIXEL_MODE_BIT, |c| c.pixel_zoom(2.0, 3.0), GL_ZOOM_Y),
    (GL_LIGHTING_BIT, |c| c.shade_model(GL_FLAT), GL_SHADE_MODEL),
    (GL_LIGHTING_BIT, |c| c.light_model(GL_LIGHT_MODEL_TWO_SIDE, &[1.0]), GL_LIGHT_MODEL_TWO_SIDE),
    (GL_LIGHTING_BIT | GL_ENABLE_BIT, |c| c.enable(GL_LIGHT3), GL_LIGHT3),
    (GL_LIGHTING_BIT | GL_ENABLE_BIT, |c| c.enable(GL_COLOR_MATERIAL), GL_COLOR_MATERIAL),
    (GL_FOG_BIT, |c| c.fog(GL_FOG_DENSITY, &[3.0]), GL_FOG_DENSITY),
    (GL_FOG_BIT | GL_ENABLE_BIT, |c| c.enable(GL_FOG), GL_FOG),
    (GL_FOG_BIT | GL_ENABLE_BIT, |c| c.enable(GL_COLOR_SUM), GL_COLOR_SUM),
    (GL_DEPTH_BUFFER_BIT, |c| c.depth_func(GL_ALWAYS), GL_DEPTH_FUNC),
    (GL_DEPTH_BUFFER_BIT | GL_ENABLE_BIT, |c| c.enable(GL_DEPTH_TEST), GL_DEPTH_TEST),
    (GL_ACCUM_BUFFER_BIT, |c| c.clear_accum(1.0, 1.0, 1.0, 1.0), GL_ACCUM_CLEAR_VALUE),
    (GL_STENCIL_BUFFER_BIT, |c| c.stencil_func(GL_LESS, 1, 1), GL_STENCIL_BACK_FUNC),
    (GL_STENCIL_BUFFER_BIT | GL_ENABLE_BIT, |c| c.enable(GL_STENCIL_TEST), GL_STENCIL_TEST),
    (GL_VIEWPORT_BIT, |c| c.viewport(1, 2, 3, 4), GL_VIEWPORT),
    (GL_VIEWPORT_BIT, |c| c.depth_range(0.25, 0.5), GL_DEPTH_RANGE),
    (GL_TRANSFORM_BIT, |c| c.matrix_mode(GL_TEXTURE), GL_MATRIX_MODE),
    (GL_TRANSFORM_BIT | GL_ENABLE_BIT, |c| c.enable(GL_CLIP_PLANE0 + 5), GL_CLIP_PLANE0 + 5),
    (GL_TRANSFORM_BIT | GL_ENABLE_BIT, |c| c.enable(GL_NORMALIZE), GL_NORMALIZE),
    (GL_COLOR_BUFFER_BIT, |c| c.clear_color(1.0, 0.0, 0.0, 0.0), GL_COLOR_CLEAR_VALUE),
    (GL_COLOR_BUFFER_BIT, |c| c.color_mask(false, false, false, false), GL_COLOR_WRITEMASK),
    (GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT, |c| c.enable(GL_BLEND), GL_BLEND),
    (GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT, |c| c.disable(GL_DITHER), GL_DITHER),
    (GL_COLOR_BUFFER_BIT | GL_ENABLE_BIT, |c| c.enable(GL_COLOR_LOGIC_OP), GL_COLOR_LOGIC_OP),
    (GL_HINT_BIT, |c| c.hint(GL_FOG_HINT, GL_NICEST), GL_FOG_HINT),
    (GL_EVAL_BIT, |c| c.map_grid1(5, 0.0, 1.0), GL_MAP1_GRID_SEGMENTS),
    (GL_EVAL_BIT | GL_ENABLE_BIT, |c| c.enable(GL_MAP2_VERTEX_3), GL_MAP2_VERTEX_3),
    (GL_EVAL_BIT | GL_ENABLE_BIT, |c| c.enable(GL_AUTO_NORMAL), GL_AUTO_NORMAL),
    (GL_LIST_BIT, |c| c.list_base(7), GL_LIST_BASE),
    (GL_TEXTURE_BIT, |c| c.active_texture(GL_TEXTURE2), GL_ACTIVE_TEXTURE),
    (GL_TEXTURE_BIT, |c| c.bind_texture(GL_TEXTURE_2D, 5), GL_TEXTURE_BINDING_2D),
    (GL_TEXTURE_BIT | GL_ENABLE_BIT, |c| c.enable(GL_TEXTURE_2D), GL_TEXTURE_2D),
    (GL_TEXTURE_BIT | GL_ENABLE_BIT, |c| c.enable(GL_TEXTURE_GEN_Q), GL_TEXTURE_GEN_Q),
    (GL_SCISSOR_BIT, |c| c.scissor(1, 2, 3, 4), GL_SCISSOR_BOX),
    (GL_SCISSOR_BIT | GL_ENABLE_BIT, |c| c.enable(GL_SCISSOR_TEST), GL_SCISSOR_TEST),
    (GL_MULTISAMPLE_BIT, |c| c.sample_coverage(0.5, true), GL_SAMPLE_COVERAGE_VALUE),
    (GL_MULTISAMPLE_BIT | GL_ENABLE_BIT, |c| c.disable(GL_MULTISAMPLE), GL_MULTISAMPLE),
];

#[test]
fn a_group_is_restored_by_its_own_bits_and_no_others() {
    for &(bits, change, pname) in GROUPS {
        let mut cx = context();
        let before = get(&mut cx, pname);
        for bit in (0..32).map(|k| 1 << k).filter(|bit| bits & bit != 0).chain([GL_ALL_ATTRIB_BITS]) {
            cx.push_attrib(bit);
            change(&mut cx);
            assert_ne!(get(&mut cx, pname), before, "{pname:#x} changes");
            cx.pop_attrib();
            assert_eq!(get(&mut cx, pname), before, "{pname:#x} comes back with {bit:#x}");
        }
        cx.push_attrib(!bits);
        change(&mut cx);
        let after = get(&mut cx, pname);
        cx.pop_attrib();
        assert_eq!(get(&mut cx, pname), after, "{pname:#x} stays without {bits:#x}");
    }
}

#[test]
fn the_stack_overflows_and_underflows() {
    let mut cx = context();
    assert_eq!(error_of(&mut cx, |cx| cx.pop_attrib()), GL_STACK_UNDERFLOW);
    for depth in 0..16 {
        assert_eq!(get(&mut cx, GL_ATTRIB_STACK_DEPTH), [depth as f64]);
        assert_eq!(error_of(&mut cx, |cx| cx.push_attrib(GL_LINE_BIT)), GL_NO_ERROR);
    }
    assert_eq!(error_of(&mut cx, |cx| cx.push_attrib(GL_LINE_BIT)), GL_STACK_OVERFLOW);
    for _ in 0..16 {
        assert_eq!(error_of(&mut cx, |cx| cx.pop_attrib()), GL_NO_ERROR);
    }
    assert_eq!(error_of(&mut cx, |cx| cx.pop_attrib()), GL_STACK_UNDERFLOW);
}

#[test]
fn an_inner_pop_leaves_the_outer_one_its_groups() {
    let mut cx = context();
    cx.push_attrib(GL_ALL_ATTRIB_BITS);
    cx.line_width(5.0);
    cx.push_attrib(GL_POINT_BIT);
    cx.line_width(7.0);
    cx.pop_attrib();
    assert_eq!(get(&mut cx, GL_LINE_WIDTH), [7.0]);
    cx.pop_attrib();
    assert_eq!(get(&mut cx, GL_LINE_WIDTH), [1.0]);
}

#[test]
fn texture_parameters_of_bound_textures_are_in_the_texture_group() {
    let mut cx = context();
    cx.bind_texture(GL_TEXTURE_2D, 4);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP as i32);
    cx.push_attrib(GL_TEXTURE_BIT);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_REPEAT as i32);
    cx.bind_texture(GL_TEXTURE_2D, 5);
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE as i32);
    cx.pop_attrib();
    assert_eq!(get(&mut cx, GL_TEXTURE_BINDING_2D), [4.0]);
    assert_eq!(cx.get_tex_parameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S), [GL_CLAMP as i32]);
    cx.bind_texture(GL_TEXTURE_2D, 5);
    assert_eq!(cx.get_tex_parameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S), [GL_CLAMP_TO_EDGE as i32], "it was not bound at the push");
}

#[test]
fn a_material_that_follows_the_colour_comes_back() {
    let mut cx = context();
    cx.push_attrib(GL_LIGHTING_BIT);
    cx.enable(GL_COLOR_MATERIAL);
    cx.color(0.5, 0.0, 0.0, 1.0);
    cx.pop_attrib();
    let diffuse = cx.get_material(GL_FRONT, GL_DIFFUSE).map(|v| v.as_f32().collect::<Vec<f32>>());
    assert_eq!(diffuse, Some(vec![0.8, 0.8, 0.8, 1.0]));
}
