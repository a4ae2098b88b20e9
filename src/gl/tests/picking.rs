//! Selection, feedback and the raster position.

use super::*;
use crate::gl::feedback::Returned;

fn triangle(cx: &mut Context, z: f32) {
    cx.begin(GL_TRIANGLES);
    cx.vertex(-0.5, -0.5, z, 1.0);
    cx.vertex(0.5, -0.5, z, 1.0);
    cx.vertex(0.0, 0.5, z, 1.0);
    cx.end();
}

fn selecting(commands: impl FnOnce(&mut Context)) -> (i32, Vec<u32>) {
    let mut cx = context();
    cx.select_buffer(64, 8);
    cx.render_mode(GL_SELECT);
    commands(&mut cx);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
    match cx.render_mode(GL_RENDER) {
        (hits, Returned::Selection(8, records)) => (hits, records),
        other => panic!("{other:?}"),
    }
}

fn feedback(kind: GLenum, commands: impl FnOnce(&mut Context)) -> (i32, Vec<f32>) {
    let mut cx = context();
    cx.feedback_buffer(256, kind, 8);
    cx.render_mode(GL_FEEDBACK);
    commands(&mut cx);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
    match cx.render_mode(GL_RENDER) {
        (count, Returned::Feedback(8, values)) => (count, values),
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_hit_record_has_names_and_depths() {
    let (hits, records) = selecting(|cx| {
        cx.init_names();
        cx.push_name(7);
        triangle(cx, 0.0);
        triangle(cx, -1.0);
        cx.push_name(9);
        triangle(cx, 1.0);
        cx.load_name(10);
        triangle(cx, 5.0);
    });
    assert_eq!(hits, 2, "the last one is clipped");
    assert_eq!(records, [1, 0, 0x8000_0000, 7, 2, u32::MAX, u32::MAX, 7, 9]);
}

#[test]
fn culled_triangles_are_no_hits_and_raster_positions_are() {
    let (hits, records) = selecting(|cx| {
        cx.enable(GL_CULL_FACE);
        cx.cull_face(GL_FRONT);
        triangle(cx, 0.0);
        cx.init_names();
        cx.push_name(1);
        cx.raster_pos(0.0, 0.0, -1.0, 1.0);
    });
    assert_eq!((hits, records), (1, vec![1, 0, 0, 1]));
}

#[test]
fn a_full_selection_buffer_returns_minus_one() {
    let mut cx = context();
    cx.select_buffer(5, 8);
    cx.render_mode(GL_SELECT);
    cx.push_name(1);
    triangle(&mut cx, 0.0);
    cx.load_name(2);
    triangle(&mut cx, 0.0);
    let (hits, returned) = cx.render_mode(GL_RENDER);
    assert_eq!(hits, -1);
    assert!(matches!(returned, Returned::Selection(8, records) if records.len() == 5));
}

#[test]
fn the_name_stack_has_its_errors_in_selection_mode_only() {
    let mut cx = context();
    assert_eq!(error_of(&mut cx, |cx| cx.pop_name()), GL_NO_ERROR);
    assert_eq!(error_of(&mut cx, |cx| drop(cx.render_mode(GL_SELECT))), GL_INVALID_OPERATION);
    assert_eq!(error_of(&mut cx, |cx| drop(cx.render_mode(GL_POINTS))), GL_INVALID_ENUM);
    assert_eq!(error_of(&mut cx, |cx| cx.select_buffer(-1, 8)), GL_INVALID_VALUE);
    cx.select_buffer(64, 8);
    cx.render_mode(GL_SELECT);
    assert_eq!(error_of(&mut cx, |cx| cx.select_buffer(64, 8)), GL_INVALID_OPERATION);
    assert_eq!(error_of(&mut cx, |cx| cx.load_name(1)), GL_INVALID_OPERATION);
    assert_eq!(error_of(&mut cx, |cx| cx.pop_name()), GL_STACK_UNDERFLOW);
    (0..64).for_each(|name| cx.push_name(name));
    assert_eq!(error_of(&mut cx, |cx| cx.push_name(64)), GL_STACK_OVERFLOW);
    assert_eq!(get(&mut cx, GL_NAME_STACK_DEPTH), [64.0]);
}

#[test]
fn feedback_returns_points_lines_and_tokens() {
    let (count, values) = feedback(GL_2D, |cx| {
        cx.pass_through(42.0);
        cx.begin(GL_POINTS);
        cx.vertex(0.0, 0.0, 0.0, 1.0);
        cx.vertex(2.0, 0.0, 0.0, 1.0);
        cx.end();
        cx.begin(GL_LINE_STRIP);
        cx.vertex(-1.0, -1.0, 0.0, 1.0);
        cx.vertex(1.0, 1.0, 0.0, 1.0);
        cx.vertex(1.0, -1.0, 0.0, 1.0);
        cx.end();
    });
    let token = |t: GLenum| t as f32;
    let expected = [
        token(GL_PASS_THROUGH_TOKEN),
        42.0,
        token(GL_POINT_TOKEN),
        32.0,
        24.0,
        token(GL_LINE_RESET_TOKEN),
        0.0,
        0.0,
        64.0,
        48.0,
        token(GL_LINE_TOKEN),
        64.0,
        48.0,
        64.0,
        0.0,
    ];
    assert_eq!(values, expected);
    assert_eq!(count, expected.len() as i32);
}

#[test]
fn feedback_of_polygons_follows_the_polygon_mode() {
    let sizes = [(GL_2D, 2), (GL_3D, 3), (GL_3D_COLOR, 7), (GL_3D_COLOR_TEXTURE, 11), (GL_4D_COLOR_TEXTURE, 12)];
    for (kind, size) in sizes {
        let (_, filled) = feedback(kind, |cx| triangle(cx, 0.0));
        assert_eq!(filled[..2], [GL_POLYGON_TOKEN as f32, 3.0]);
        assert_eq!(filled.len(), 2 + 3 * size);
    }
    let (_, lines) = feedback(GL_2D, |cx| {
        cx.polygon_mode(GL_FRONT_AND_BACK, GL_LINE);
        triangle(cx, 0.0);
    });
    assert_eq!(lines.len(), 3 * 5);
    let (_, points) = feedback(GL_2D, |cx| {
        cx.polygon_mode(GL_FRONT, GL_POINT);
        triangle(cx, 0.0);
    });
    assert_eq!(points.len(), 3 * 3);
}

#[test]
fn a_full_feedback_buffer_returns_minus_one() {
    let mut cx = context();
    cx.feedback_buffer(4, GL_2D, 8);
    cx.render_mode(GL_FEEDBACK);
    triangle(&mut cx, 0.0);
    let (count, returned) = cx.render_mode(GL_RENDER);
    assert_eq!(count, -1);
    assert!(matches!(returned, Returned::Feedback(8, values) if values.len() == 4));
}

#[test]
fn the_raster_position_is_transformed_and_clipped() {
    let mut cx = context();
    cx.color(0.25, 2.0, 0.0, 1.0);
    cx.translate(0.5, 0.0, 0.0);
    cx.raster_pos(0.0, 0.0, 0.0, 1.0);
    assert_eq!(get(&mut cx, GL_CURRENT_RASTER_POSITION), [48.0, 24.0, 0.5, 1.0]);
    assert_eq!(get(&mut cx, GL_CURRENT_RASTER_COLOR), [0.25, 1.0, 0.0, 1.0]);
    assert_eq!(get(&mut cx, GL_CURRENT_RASTER_POSITION_VALID), [1.0]);
    cx.raster_pos(0.75, 0.0, 0.0, 1.0);
    assert_eq!(get(&mut cx, GL_CURRENT_RASTER_POSITION_VALID), [0.0]);
}
