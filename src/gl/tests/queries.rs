//! Conversions of 6.1.2, limits, strings, errors.

use super::*;
use crate::gl::query::{Kind, Value};

#[test]
fn floats_are_rounded_and_normalised_values_fill_the_integers() {
    let ints = |value: Value| value.as_i32().collect::<Vec<i32>>();
    assert_eq!(ints(Value::floats(&[1.4, 1.5, -1.5, 1e20, f32::NAN])), [1, 2, -2, i32::MAX, 0]);
    assert_eq!(ints(Value::normalized(&[1.0, 0.0, -1.0, 0.5, 2.0])), [i32::MAX, 0, i32::MIN, 0x4000_0000 - 1, i32::MAX]);
    assert_eq!(ints(Value::int(u32::MAX)), [i32::MAX]);
    assert_eq!(ints(Value::bools(&[true, false])), [1, 0]);
}

#[test]
fn everything_but_zero_is_true() {
    let value = Value::new(Kind::Float, [0.0, 0.25, -3.0, -0.0]);
    assert_eq!(value.as_bool().collect::<Vec<u8>>(), [0, 1, 1, 0]);
    assert_eq!(value.len(), 4);
}

#[test]
fn limits_are_what_the_state_machine_holds() {
    let mut cx = context();
    for (pname, value) in [
        (GL_MAX_LIGHTS, 8.0),
        (GL_MAX_CLIP_PLANES, 8.0),
        (GL_MAX_TEXTURE_UNITS, 8.0),
        (GL_MAX_TEXTURE_SIZE, 16384.0),
        (GL_MAX_MODELVIEW_STACK_DEPTH, 32.0),
        (GL_MAX_ATTRIB_STACK_DEPTH, 16.0),
        (GL_MAX_NAME_STACK_DEPTH, 64.0),
        (GL_MAX_EVAL_ORDER, 30.0),
        (GL_SUBPIXEL_BITS, 8.0),
        (GL_RED_BITS, 8.0),
        (GL_DEPTH_BITS, 24.0),
        (GL_STENCIL_BITS, 8.0),
        (GL_RGBA_MODE, 1.0),
        (GL_MODELVIEW_STACK_DEPTH, 1.0),
    ] {
        assert_eq!(get(&mut cx, pname), [value], "{pname:#x}");
    }
    assert_eq!(get(&mut cx, GL_POINT_SIZE_RANGE), [1.0, 255.0]);
    assert_eq!(get(&mut cx, GL_MAX_VIEWPORT_DIMS), [16384.0, 16384.0]);
    assert_eq!(get(&mut cx, GL_VIEWPORT), [0.0, 0.0, 64.0, 48.0]);
}

#[test]
fn matrices_come_by_columns_and_transposed_by_rows() {
    let mut cx = context();
    cx.translate(2.0, 3.0, 4.0);
    assert_eq!(get(&mut cx, GL_MODELVIEW_MATRIX)[12..], [2.0, 3.0, 4.0, 1.0]);
    assert_eq!(get(&mut cx, GL_TRANSPOSE_MODELVIEW_MATRIX)[..4], [1.0, 0.0, 0.0, 2.0]);
}

#[test]
fn an_unknown_name_is_an_invalid_enum() {
    let mut cx = context();
    assert_eq!(error_of(&mut cx, |cx| assert!(cx.get(0xdead).is_none())), GL_INVALID_ENUM);
    assert_eq!(error_of(&mut cx, |cx| assert!(cx.get_string(GL_POINTS).is_none())), GL_INVALID_ENUM);
}

#[test]
fn the_first_error_stays_until_it_is_read() {
    let mut cx = context();
    cx.point_size(-1.0);
    cx.enable(0xdead);
    assert_eq!(cx.get_error(), GL_INVALID_VALUE);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn strings_start_with_a_version_number() {
    let mut cx = context();
    let mut text = |name| cx.get_string(name).map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    assert_eq!(text(GL_VENDOR), "Tepui");
    assert!(text(GL_RENDERER).starts_with("Tepui ("));
    let version = text(GL_VERSION);
    assert!(version.split(' ').next().is_some_and(|v| v.parse::<f32>().is_ok_and(|v| v >= 1.1)), "{version}");
    assert!(text(GL_EXTENSIONS).split_whitespace().all(|name| name.starts_with("GL_")));
}
