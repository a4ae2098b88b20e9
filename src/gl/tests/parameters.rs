//! Lights, materials, texture environment and generation, clip planes: setters with a target.

use super::*;
use crate::gl::query::{Value, params_from_int};

fn floats(value: Option<Value>) -> Vec<f32> {
    value.map_or(Vec::new(), |value| value.as_f32().collect())
}

#[test]
fn lights_have_the_defaults_of_the_state_table() {
    let mut cx = context();
    for light in GL_LIGHT0..=GL_LIGHT7 {
        let first = (light == GL_LIGHT0) as u8 as f32;
        assert_eq!(floats(cx.get_light(light, GL_AMBIENT)), [0.0, 0.0, 0.0, 1.0]);
        assert_eq!(floats(cx.get_light(light, GL_DIFFUSE)), [first, first, first, 1.0]);
        assert_eq!(floats(cx.get_light(light, GL_SPECULAR)), [first, first, first, 1.0]);
        assert_eq!(floats(cx.get_light(light, GL_POSITION)), [0.0, 0.0, 1.0, 0.0]);
        assert_eq!(floats(cx.get_light(light, GL_SPOT_DIRECTION)), [0.0, 0.0, -1.0]);
        assert_eq!(floats(cx.get_light(light, GL_SPOT_EXPONENT)), [0.0]);
        assert_eq!(floats(cx.get_light(light, GL_SPOT_CUTOFF)), [180.0]);
        assert_eq!(floats(cx.get_light(light, GL_CONSTANT_ATTENUATION)), [1.0]);
        assert_eq!(floats(cx.get_light(light, GL_QUADRATIC_ATTENUATION)), [0.0]);
    }
}

#[test]
fn light_position_and_direction_are_kept_in_eye_coordinates() {
    let mut cx = context();
    cx.translate(1.0, 2.0, 3.0);
    cx.scale(2.0, 2.0, 2.0);
    cx.light(GL_LIGHT3, GL_POSITION, &[1.0, 1.0, 1.0, 1.0]);
    cx.light(GL_LIGHT3, GL_SPOT_DIRECTION, &[0.0, 1.0, 0.0]);
    cx.load_identity();
    assert_eq!(floats(cx.get_light(GL_LIGHT3, GL_POSITION)), [3.0, 4.0, 5.0, 1.0]);
    assert_eq!(floats(cx.get_light(GL_LIGHT3, GL_SPOT_DIRECTION)), [0.0, 2.0, 0.0]);
}

#[test]
fn lights_refuse_what_the_specification_refuses() {
    let mut cx = context();
    let mut error = |light: GLenum, pname: GLenum, params: &[f32]| error_of(&mut cx, |cx| cx.light(light, pname, params));
    assert_eq!(error(GL_LIGHT0 + 8, GL_AMBIENT, &[0.0; 4]), GL_INVALID_ENUM);
    assert_eq!(error(GL_LIGHT0, GL_SHININESS, &[0.0]), GL_INVALID_ENUM);
    assert_eq!(error(GL_LIGHT0, GL_POSITION, &[0.0]), GL_INVALID_ENUM);
    assert_eq!(error(GL_LIGHT0, GL_SPOT_EXPONENT, &[128.5]), GL_INVALID_VALUE);
    assert_eq!(error(GL_LIGHT0, GL_SPOT_CUTOFF, &[91.0]), GL_INVALID_VALUE);
    assert_eq!(error(GL_LIGHT0, GL_SPOT_CUTOFF, &[180.0]), GL_NO_ERROR);
    assert_eq!(error(GL_LIGHT0, GL_LINEAR_ATTENUATION, &[-1.0]), GL_INVALID_VALUE);
    assert_eq!(error_of(&mut cx, |cx| assert!(cx.get_light(GL_LIGHT0, GL_SHININESS).is_none())), GL_INVALID_ENUM);
}

#[test]
fn materials_set_one_face_or_both() {
    let mut cx = context();
    cx.material(GL_FRONT_AND_BACK, GL_AMBIENT_AND_DIFFUSE, &[0.1, 0.2, 0.3, 0.4]);
    cx.material(GL_BACK, GL_DIFFUSE, &[1.0, 0.0, 0.0, 1.0]);
    cx.material(GL_FRONT, GL_SHININESS, &[64.0]);
    assert_eq!(floats(cx.get_material(GL_FRONT, GL_DIFFUSE)), [0.1, 0.2, 0.3, 0.4]);
    assert_eq!(floats(cx.get_material(GL_BACK, GL_AMBIENT)), [0.1, 0.2, 0.3, 0.4]);
    assert_eq!(floats(cx.get_material(GL_BACK, GL_DIFFUSE)), [1.0, 0.0, 0.0, 1.0]);
    assert_eq!(floats(cx.get_material(GL_FRONT, GL_SHININESS)), [64.0]);
    assert_eq!(floats(cx.get_material(GL_BACK, GL_SHININESS)), [0.0]);
    assert_eq!(floats(cx.get_material(GL_FRONT, GL_COLOR_INDEXES)), [0.0, 1.0, 1.0]);
    assert_eq!(error_of(&mut cx, |cx| cx.material(GL_FRONT, GL_SHININESS, &[129.0])), GL_INVALID_VALUE);
    assert_eq!(error_of(&mut cx, |cx| cx.material(GL_FRONT, GL_DIFFUSE, &[1.0])), GL_INVALID_ENUM);
    assert_eq!(error_of(&mut cx, |cx| cx.material(GL_NONE, GL_DIFFUSE, &[1.0; 4])), GL_INVALID_ENUM);
    assert_eq!(error_of(&mut cx, |cx| assert!(cx.get_material(GL_FRONT_AND_BACK, GL_DIFFUSE).is_none())), GL_INVALID_ENUM);
}

#[test]
fn a_tracked_material_follows_the_colour_until_tracking_ends() {
    let mut cx = context();
    cx.color_material(GL_FRONT, GL_DIFFUSE);
    cx.color(1.0, 0.0, 0.0, 1.0);
    cx.enable(GL_COLOR_MATERIAL);
    assert_eq!(floats(cx.get_material(GL_FRONT, GL_DIFFUSE)), [1.0, 0.0, 0.0, 1.0]);
    cx.color(0.0, 1.0, 0.0, 1.0);
    cx.material(GL_FRONT, GL_DIFFUSE, &[0.5; 4]);
    assert_eq!(floats(cx.get_material(GL_FRONT, GL_DIFFUSE)), [0.0, 1.0, 0.0, 1.0], "glMaterial has no effect on it");
    cx.disable(GL_COLOR_MATERIAL);
    cx.color(0.0, 0.0, 1.0, 1.0);
    assert_eq!(floats(cx.get_material(GL_FRONT, GL_DIFFUSE)), [0.0, 1.0, 0.0, 1.0]);
    assert_eq!(floats(cx.get_material(GL_BACK, GL_DIFFUSE)), [0.8, 0.8, 0.8, 1.0]);
}

#[test]
fn a_parameter_that_tracking_leaves_keeps_its_last_colour() {
    let mut cx = context();
    cx.enable(GL_COLOR_MATERIAL);
    cx.color(0.25, 0.5, 0.75, 1.0);
    cx.color_material(GL_FRONT_AND_BACK, GL_SPECULAR);
    cx.color(1.0, 1.0, 0.0, 1.0);
    assert_eq!(floats(cx.get_material(GL_BACK, GL_AMBIENT)), [0.25, 0.5, 0.75, 1.0]);
    assert_eq!(floats(cx.get_material(GL_BACK, GL_SPECULAR)), [1.0, 1.0, 0.0, 1.0]);
}

#[test]
fn clip_planes_go_through_the_inverse_model_view_matrix() {
    let mut cx = context();
    assert_eq!(cx.get_clip_plane(GL_CLIP_PLANE0), Some([0.0; 4]));
    cx.translate(5.0, 0.0, 0.0);
    cx.clip_plane(GL_CLIP_PLANE0 + 2, [1.0, 0.0, 0.0, 0.0]);
    cx.load_identity();
    assert_eq!(cx.get_clip_plane(GL_CLIP_PLANE0 + 2), Some([1.0, 0.0, 0.0, -5.0]));
    assert_eq!(error_of(&mut cx, |cx| cx.clip_plane(GL_CLIP_PLANE0 + 8, [0.0; 4])), GL_INVALID_ENUM);
    assert_eq!(error_of(&mut cx, |cx| assert!(cx.get_clip_plane(GL_CLIP_PLANE0 + 8).is_none())), GL_INVALID_ENUM);
}

#[test]
fn texture_generation_keeps_planes_and_refuses_modes_that_a_coordinate_lacks() {
    let mut cx = context();
    assert_eq!(floats(cx.get_tex_gen(GL_S, GL_OBJECT_PLANE)), [1.0, 0.0, 0.0, 0.0]);
    assert_eq!(floats(cx.get_tex_gen(GL_T, GL_EYE_PLANE)), [0.0, 1.0, 0.0, 0.0]);
    assert_eq!(floats(cx.get_tex_gen(GL_Q, GL_EYE_PLANE)), [0.0; 4]);
    assert_eq!(floats(cx.get_tex_gen(GL_R, GL_TEXTURE_GEN_MODE)), [GL_EYE_LINEAR as f32]);
    cx.scale(2.0, 1.0, 1.0);
    cx.tex_gen(GL_S, GL_EYE_PLANE, &[1.0, 2.0, 3.0, 4.0]);
    cx.tex_gen(GL_S, GL_OBJECT_PLANE, &[1.0, 2.0, 3.0, 4.0]);
    cx.tex_gen(GL_S, GL_TEXTURE_GEN_MODE, &[GL_SPHERE_MAP as f32]);
    assert_eq!(floats(cx.get_tex_gen(GL_S, GL_EYE_PLANE)), [0.5, 2.0, 3.0, 4.0]);
    assert_eq!(floats(cx.get_tex_gen(GL_S, GL_OBJECT_PLANE)), [1.0, 2.0, 3.0, 4.0]);
    assert_eq!(floats(cx.get_tex_gen(GL_S, GL_TEXTURE_GEN_MODE)), [GL_SPHERE_MAP as f32]);
    let mode = |coord, mode: GLenum| move |cx: &mut Context| cx.tex_gen(coord, GL_TEXTURE_GEN_MODE, &[mode as f32]);
    assert_eq!(error_of(&mut cx, mode(GL_R, GL_SPHERE_MAP)), GL_INVALID_ENUM);
    assert_eq!(error_of(&mut cx, mode(GL_R, GL_REFLECTION_MAP)), GL_NO_ERROR);
    assert_eq!(error_of(&mut cx, mode(GL_Q, GL_NORMAL_MAP)), GL_INVALID_ENUM);
    assert_eq!(error_of(&mut cx, |cx| cx.tex_gen(GL_S, GL_OBJECT_PLANE, &[1.0])), GL_INVALID_ENUM);
    assert_eq!(error_of(&mut cx, |cx| cx.tex_gen(GL_Q + 1, GL_OBJECT_PLANE, &[1.0; 4])), GL_INVALID_ENUM);
}

#[test]
fn texture_environment_has_its_defaults_reads_back_and_refuses() {
    const ROWS: &[(GLenum, f32, f32, f32, GLenum)] = &[
        (GL_TEXTURE_ENV_MODE, GL_MODULATE as f32, GL_COMBINE as f32, GL_NEAREST as f32, GL_INVALID_ENUM),
        (GL_COMBINE_RGB, GL_MODULATE as f32, GL_DOT3_RGBA as f32, GL_DECAL as f32, GL_INVALID_ENUM),
        (GL_COMBINE_ALPHA, GL_MODULATE as f32, GL_SUBTRACT as f32, GL_DOT3_RGB as f32, GL_INVALID_ENUM),
        (GL_SRC0_RGB, GL_TEXTURE as f32, GL_TEXTURE3 as f32, GL_TEXTURE8 as f32, GL_INVALID_ENUM),
        (GL_SRC1_RGB, GL_PREVIOUS as f32, GL_CONSTANT as f32, GL_COLOR as f32, GL_INVALID_ENUM),
        (GL_SRC2_ALPHA, GL_CONSTANT as f32, GL_PRIMARY_COLOR as f32, GL_COLOR as f32, GL_INVALID_ENUM),
        (GL_OPERAND0_RGB, GL_SRC_COLOR as f32, GL_ONE_MINUS_SRC_ALPHA as f32, GL_ONE as f32, GL_INVALID_ENUM),
        (GL_OPERAND2_RGB, GL_SRC_ALPHA as f32, GL_SRC_COLOR as f32, GL_ONE as f32, GL_INVALID_ENUM),
        (GL_OPERAND1_ALPHA, GL_SRC_ALPHA as f32, GL_ONE_MINUS_SRC_ALPHA as f32, GL_SRC_COLOR as f32, GL_INVALID_ENUM),
        (GL_RGB_SCALE, 1.0, 4.0, 3.0, GL_INVALID_VALUE),
        (GL_ALPHA_SCALE, 1.0, 2.0, 0.0, GL_INVALID_VALUE),
    ];
    let mut cx = context();
    for &(pname, default, legal, illegal, error) in ROWS {
        assert_eq!(floats(cx.get_tex_env(GL_TEXTURE_ENV, pname)), [default], "{pname:#x}");
        cx.tex_env(GL_TEXTURE_ENV, pname, &[legal]);
        assert_eq!(error_of(&mut cx, |cx| cx.tex_env(GL_TEXTURE_ENV, pname, &[illegal])), error, "{pname:#x}");
        assert_eq!(floats(cx.get_tex_env(GL_TEXTURE_ENV, pname)), [legal], "{pname:#x}");
    }
    cx.tex_env(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &[0.5, 2.0, -1.0, 1.0]);
    assert_eq!(floats(cx.get_tex_env(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR)), [0.5, 1.0, 0.0, 1.0]);
    cx.active_texture(GL_TEXTURE1);
    assert_eq!(floats(cx.get_tex_env(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR)), [0.0; 4]);
    assert_eq!(error_of(&mut cx, |cx| cx.tex_env(GL_TEXTURE, GL_TEXTURE_ENV_MODE, &[GL_DECAL as f32])), GL_INVALID_ENUM);
}

#[test]
fn integer_colours_are_scaled_and_other_integers_are_not() {
    assert_eq!(params_from_int(GL_AMBIENT, &[i32::MAX, i32::MIN, 0, i32::MAX]), [1.0, -1.0, (1.0 / u32::MAX as f64) as f32, 1.0]);
    assert_eq!(params_from_int(GL_POSITION, &[1, -2, 3, 1]), [1.0, -2.0, 3.0, 1.0]);
    assert_eq!(params_from_int(GL_FOG_MODE, &[GL_EXP2 as i32]), [GL_EXP2 as f32]);
}

#[test]
fn the_polygon_stipple_follows_the_pixel_store() {
    let mut cx = context();
    let mut pattern = [0u8; 128];
    pattern[0] = 0x80;
    pattern[127] = 0x01;
    cx.polygon_stipple(&pattern);
    assert_eq!((cx.state.polygon_stipple[0], cx.state.polygon_stipple[31]), (0x8000_0000, 1));
    let mut back = [0xffu8; 128];
    cx.get_polygon_stipple(&mut back);
    assert_eq!(back, pattern);
    cx.pixel_storei(GL_UNPACK_LSB_FIRST, 1);
    cx.polygon_stipple(&pattern);
    assert_eq!((cx.state.polygon_stipple[0], cx.state.polygon_stipple[31]), (0x0100_0000, 0x80));
}
