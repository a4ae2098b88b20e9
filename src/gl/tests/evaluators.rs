//! Maps as state; what they evaluate to is with the curves.

use super::*;

#[test]
fn maps_read_back_packed() {
    let mut cx = context();
    assert_eq!(cx.get_map(GL_MAP1_VERTEX_4, GL_COEFF), Some(vec![0.0, 0.0, 0.0, 1.0]));
    assert_eq!(cx.get_map(GL_MAP1_COLOR_4, GL_COEFF), Some(vec![1.0; 4]));
    assert_eq!(cx.get_map(GL_MAP2_NORMAL, GL_COEFF), Some(vec![0.0, 0.0, 1.0]));
    assert_eq!(cx.get_map(GL_MAP2_NORMAL, GL_ORDER), Some(vec![1.0, 1.0]));
    assert_eq!(cx.get_map(GL_MAP2_NORMAL, GL_DOMAIN), Some(vec![0.0, 1.0, 0.0, 1.0]));
    let points: Vec<f32> = (0..10).map(|k| k as f32).collect();
    cx.map1(GL_MAP1_VERTEX_3, 2.0, 3.0, 4, 2, &points);
    assert_eq!(cx.get_map(GL_MAP1_VERTEX_3, GL_COEFF), Some(vec![0.0, 1.0, 2.0, 4.0, 5.0, 6.0]));
    assert_eq!(cx.get_map(GL_MAP1_VERTEX_3, GL_ORDER), Some(vec![2.0]));
    assert_eq!(cx.get_map(GL_MAP1_VERTEX_3, GL_DOMAIN), Some(vec![2.0, 3.0]));
    cx.map2(GL_MAP2_INDEX, 0.0, 1.0, 1, 2, 0.0, 1.0, 3, 3, &points);
    assert_eq!(cx.get_map(GL_MAP2_INDEX, GL_COEFF), Some(vec![0.0, 3.0, 6.0, 1.0, 4.0, 7.0]));
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn maps_refuse_what_the_specification_refuses() {
    let mut cx = context();
    let points = [0.0; 256];
    let mut map1 = |target, u1, u2, stride, order| error_of(&mut cx, |cx| cx.map1(target, u1, u2, stride, order, &points));
    assert_eq!(map1(GL_MAP2_VERTEX_3, 0.0, 1.0, 3, 2), GL_INVALID_ENUM);
    assert_eq!(map1(GL_MAP1_VERTEX_3, 1.0, 1.0, 3, 2), GL_INVALID_VALUE);
    assert_eq!(map1(GL_MAP1_VERTEX_3, 0.0, 1.0, 2, 2), GL_INVALID_VALUE);
    assert_eq!(map1(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 0), GL_INVALID_VALUE);
    assert_eq!(map1(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 31), GL_INVALID_VALUE);
    assert_eq!(map1(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 30), GL_NO_ERROR);
    assert_eq!(error_of(&mut cx, |cx| assert!(cx.get_map(GL_MAP1_VERTEX_3, GL_POINTS).is_none())), GL_INVALID_ENUM);
    assert_eq!(error_of(&mut cx, |cx| cx.eval_mesh1(GL_FILL, 0, 1)), GL_INVALID_ENUM);
    assert_eq!(error_of(&mut cx, |cx| cx.eval_mesh2(GL_LINES, 0, 1, 0, 1)), GL_INVALID_ENUM);
    cx.active_texture(GL_TEXTURE1);
    assert_eq!(error_of(&mut cx, |cx| cx.map1(GL_MAP1_VERTEX_3, 0.0, 1.0, 3, 2, &points)), GL_INVALID_OPERATION);
}

#[test]
fn an_endless_mesh_ends_at_once() {
    let mut cx = context();
    cx.enable(GL_MAP1_VERTEX_3);
    cx.enable(GL_MAP2_VERTEX_3);
    assert_eq!(error_of(&mut cx, |cx| cx.eval_mesh1(GL_LINE, i32::MIN, i32::MAX)), GL_OUT_OF_MEMORY);
    assert_eq!(error_of(&mut cx, |cx| cx.eval_mesh2(GL_FILL, i32::MIN, i32::MAX, 0, 1)), GL_OUT_OF_MEMORY);
    assert_eq!(error_of(&mut cx, |cx| cx.eval_mesh2(GL_LINE, 0, -9, i32::MIN, i32::MAX)), GL_OUT_OF_MEMORY);
}

#[test]
fn evaluation_leaves_the_current_values_alone() {
    let mut cx = context();
    cx.enable(GL_MAP1_VERTEX_3);
    cx.enable(GL_MAP1_COLOR_4);
    cx.map1(GL_MAP1_COLOR_4, 0.0, 1.0, 4, 1, &[0.5; 4]);
    cx.begin(GL_POINTS);
    cx.eval_coord1(0.5);
    cx.end();
    assert_eq!(get(&mut cx, GL_CURRENT_COLOR), [1.0; 4]);
}
