//! What drawing through a context records, and that the ways to say the same thing give the same picture.

use super::enums::*;
use super::{Context, ContextConfig};
use crate::draw::Step;

fn context() -> Context {
    let mut cx = Context::new(ContextConfig::default(), None);
    cx.attach_window(64, 64);
    cx
}

fn pixels(cx: &mut Context) -> Vec<u32> {
    cx.finish();
    cx.window.as_mut().expect("attached").pixels().color.to_vec()
}

fn quad(cx: &mut Context, x: f32, y: f32) {
    cx.begin(GL_QUADS);
    for (dx, dy) in [(0.0, 0.0), (0.5, 0.0), (0.5, 0.4), (0.0, 0.4)] {
        cx.vertex(x + dx, y + dy, 0.0, 1.0);
    }
    cx.end();
}

/// A ragged picture out of every primitive type.
fn picture(cx: &mut Context) {
    for mode in 0..10 {
        cx.begin(mode);
        for i in 0..23u32 {
            let t = i as f32 / 23.0;
            if i % 3 != 1 {
                cx.color(t, 1.0 - t, mode as f32 / 10.0, 0.5);
            }
            let radius = 0.4 + 0.05 * mode as f32;
            let (sin, cos) = (t * std::f32::consts::TAU).sin_cos();
            cx.vertex(radius * cos - 0.1, radius * sin + 0.05 * (i % 2) as f32, 0.0, 1.0);
        }
        cx.end();
    }
}

#[test]
fn pairs_of_equal_state_are_one_draw() {
    let mut cx = context();
    quad(&mut cx, -0.5, 0.0);
    quad(&mut cx, 0.0, 0.0);
    let batch = cx.recorder.take().unwrap();
    assert_eq!((batch.draws.len(), batch.primitives.len()), (1, 4));
    assert_eq!(batch.steps, [Step::Primitives { first: 0, end: 4 }]);
    assert_eq!(batch.draws[0].record.vertex_stride, 4, "only the position varies");
}

#[test]
fn a_colour_that_changes_between_pairs_becomes_an_attribute() {
    let mut cx = context();
    for i in 0..5 {
        cx.color(i as f32 / 5.0, 0.0, 1.0, 1.0);
        quad(&mut cx, -0.8 + 0.2 * i as f32, 0.0);
    }
    let batch = cx.recorder.take().unwrap();
    assert_eq!(batch.draws.len(), 1);
    let record = &batch.draws[0].record;
    let red = |vertex: usize| {
        batch.vertices[record.vertex_word as usize + vertex * record.vertex_stride as usize + record.attribute_offset[3] as usize]
    };
    assert_eq!([red(0), red(3), red(4), red(19)], [0.0, 0.0, 0.2, 0.8]);
}

#[test]
fn state_between_pairs_makes_a_new_draw_only_if_it_differs() {
    let mut cx = context();
    quad(&mut cx, 0.0, 0.0);
    cx.enable(GL_BLEND);
    cx.disable(GL_BLEND);
    quad(&mut cx, 0.0, 0.0);
    cx.depth_func(GL_ALWAYS);
    cx.enable(GL_DEPTH_TEST);
    quad(&mut cx, 0.0, 0.0);
    cx.disable(GL_DEPTH_TEST);
    cx.depth_func(GL_LESS);
    quad(&mut cx, 0.0, 0.0);
    let batch = cx.recorder.take().unwrap();
    assert_eq!(batch.draws.len(), 3);
    assert_eq!(batch.fragment_states.len(), 2, "equal states are interned");
}

#[test]
fn a_batch_that_is_split_gives_the_same_picture() {
    let mut whole = context();
    picture(&mut whole);
    let mut split = context();
    split.recorder.set_budget(2000);
    picture(&mut split);
    assert!(pixels(&mut whole) == pixels(&mut split));
}

#[test]
fn a_list_draws_what_it_was_given() {
    let mut direct = context();
    direct.shade_model(GL_FLAT);
    picture(&mut direct);
    let mut listed = context();
    listed.shade_model(GL_FLAT);
    listed.new_list(1, GL_COMPILE);
    picture(&mut listed);
    listed.end_list();
    assert!(listed.recorder.is_empty());
    listed.call_list(1);
    assert_eq!(listed.state.current.attributes, direct.state.current.attributes);
    assert!(pixels(&mut direct) == pixels(&mut listed));
}

#[test]
fn vertices_before_the_first_colour_of_a_list_take_the_current_one() {
    let mut cx = context();
    cx.new_list(1, GL_COMPILE);
    cx.begin(GL_LINES);
    cx.vertex(0.0, 0.0, 0.0, 1.0);
    cx.color(0.25, 0.0, 0.0, 1.0);
    cx.vertex(1.0, 0.0, 0.0, 1.0);
    cx.end();
    cx.end_list();
    cx.color(0.75, 0.0, 0.0, 1.0);
    cx.call_list(1);
    let batch = cx.recorder.take().unwrap();
    let record = &batch.draws[0].record;
    let red = |vertex: u32| batch.vertices[(record.vertex_word + vertex * record.vertex_stride + record.attribute_offset[3]) as usize];
    assert_eq!([red(0), red(1)], [0.75, 0.25]);
    assert_eq!(cx.state.current.attributes[3][0], 0.25);
}

#[test]
fn a_list_may_hold_half_a_primitive() {
    let mut cx = context();
    cx.new_list(1, GL_COMPILE);
    cx.color(0.0, 1.0, 0.0, 1.0);
    cx.vertex(0.5, 0.5, 0.0, 1.0);
    cx.end();
    cx.end_list();
    cx.begin(GL_TRIANGLES);
    cx.vertex(-0.5, 0.0, 0.0, 1.0);
    cx.vertex(0.5, 0.0, 0.0, 1.0);
    cx.call_list(1);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
    assert_eq!(cx.recorder.take().unwrap().primitives.len(), 1);
}

#[test]
fn an_error_in_a_list_is_raised_when_it_is_called() {
    let mut cx = context();
    cx.new_list(1, GL_COMPILE);
    cx.begin(77);
    cx.end_list();
    assert_eq!(cx.get_error(), GL_NO_ERROR);
    cx.call_list(1);
    assert_eq!(cx.get_error(), GL_INVALID_ENUM);
}

#[test]
fn a_list_that_calls_itself_ends() {
    let mut cx = context();
    cx.new_list(3, GL_COMPILE);
    cx.translate(1.0, 0.0, 0.0);
    cx.call_list(3);
    cx.end_list();
    cx.call_list(3);
    assert_eq!(cx.modelview.top().w_axis.x, 64.0);
}

#[test]
fn arrays_and_immediate_mode_give_the_same_picture() {
    let mut direct = context();
    let mut arrays = context();
    let vertices: Vec<[f32; 7]> = (0..60u32)
        .map(|i| {
            let t = i as f32 * 0.7;
            [t.sin(), 0.5 * t.cos(), t.fract(), 1.0, t.cos() * 0.9, (t * 1.7).sin() * 0.9, 0.0]
        })
        .collect();
    direct.begin(GL_TRIANGLES);
    for [r, g, b, a, x, y, z] in &vertices {
        direct.color(*r, *g, *b, *a);
        direct.vertex(*x, *y, *z, 1.0);
    }
    direct.end();
    let pointer = vertices.as_ptr().cast::<u8>();
    // SAFETY: the vertices outlive the draws.
    unsafe {
        arrays.color_pointer(4, GL_FLOAT, 28, pointer.cast());
        arrays.vertex_pointer(3, GL_FLOAT, 28, pointer.add(16).cast());
    }
    arrays.enable_client_state(GL_VERTEX_ARRAY);
    arrays.enable_client_state(GL_COLOR_ARRAY);
    let indices: Vec<u16> = (30..60).collect();
    arrays.draw_arrays(GL_TRIANGLES, 0, 30);
    // SAFETY: as many indices as it says.
    unsafe { arrays.draw_elements(GL_TRIANGLES, 30, GL_UNSIGNED_SHORT, indices.as_ptr().cast()) };
    assert_eq!(arrays.get_error(), GL_NO_ERROR);
    assert!(pixels(&mut direct) == pixels(&mut arrays));
}

#[test]
fn indices_of_any_type_record_the_same_draw() {
    let positions: Vec<[f32; 2]> = (0..200).map(|k| [(k as f32).sin(), (k as f32).cos()]).collect();
    let words: Vec<u32> = (0..60).map(|k| 100 + k * 7 % 50).collect();
    let shorts: Vec<u16> = words.iter().map(|&i| i as u16).collect();
    let bytes: Vec<u8> = words.iter().map(|&i| i as u8).collect();
    let unaligned: Vec<u8> = std::iter::once(0).chain(words.iter().flat_map(|i| i.to_ne_bytes())).collect();
    let record = |ty: GLenum, indices: *const u8| {
        let mut cx = context();
        // SAFETY: the arrays hold what is asked for.
        unsafe {
            cx.vertex_pointer(2, GL_FLOAT, 0, positions.as_ptr().cast());
            cx.enable_client_state(GL_VERTEX_ARRAY);
            for mode in 0..10 {
                cx.draw_elements(mode, 60, ty, indices.cast());
            }
        }
        let batch = cx.recorder.take().unwrap();
        (batch.vertices, batch.primitives)
    };
    let expected = record(GL_UNSIGNED_INT, words.as_ptr().cast());
    assert_eq!(expected, record(GL_UNSIGNED_SHORT, shorts.as_ptr().cast()));
    assert_eq!(expected, record(GL_UNSIGNED_BYTE, bytes.as_ptr()));
    assert_eq!(expected, record(GL_UNSIGNED_INT, unaligned[1..].as_ptr()));
    // Each index names the vertex that it named in the array.
    let (vertices, primitives) = expected;
    let first_triangle = primitives[60 + 30 + 60 + 59].v;
    for (k, v) in first_triangle.into_iter().enumerate() {
        let v = v as usize;
        assert_eq!(vertices[2 * v..][..2], positions[words[k] as usize]);
    }
}

#[test]
fn commands_between_begin_and_end_are_errors() {
    let mut cx = context();
    cx.begin(GL_POINTS);
    cx.begin(GL_POINTS);
    cx.clear(GL_COLOR_BUFFER_BIT);
    cx.load_identity();
    cx.end();
    assert_eq!(cx.get_error(), GL_INVALID_OPERATION);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
    assert!(cx.recorder.is_empty());
    cx.end();
    assert_eq!(cx.get_error(), GL_INVALID_OPERATION);
}
