//! Errors, one by one.

use super::*;

type Commands = fn(&mut Context);

#[track_caller]
fn check(cx: &mut Context, rows: &[(Commands, GLenum)]) {
    for (k, &(commands, error)) in rows.iter().enumerate() {
        assert_eq!(error_of(cx, commands), error, "row {k}");
    }
}

#[test]
fn names() {
    let mut cx = context();
    check(
        &mut cx,
        &[
            (|c| drop(c.gen_framebuffers(-1)), GL_INVALID_VALUE),
            (|c| c.delete_framebuffers(-1, &[]), GL_INVALID_VALUE),
            (|c| drop(c.gen_renderbuffers(-1)), GL_INVALID_VALUE),
            (|c| c.delete_renderbuffers(-1, &[]), GL_INVALID_VALUE),
            (|c| c.bind_framebuffer(GL_TEXTURE_2D, 0), GL_INVALID_ENUM),
            (|c| c.bind_framebuffer(FB, 99), GL_INVALID_OPERATION),
            (|c| c.bind_framebuffer_ext(FB, 99), GL_NO_ERROR),
            (|c| c.bind_renderbuffer(FB, 0), GL_INVALID_ENUM),
            (|c| c.bind_renderbuffer(RB, 99), GL_INVALID_OPERATION),
            (|c| c.bind_renderbuffer_ext(RB, 99), GL_NO_ERROR),
            (|c| c.delete_framebuffers(2, &[0, 1234]), GL_NO_ERROR),
            (|c| c.delete_renderbuffers(2, &[0, 1234]), GL_NO_ERROR),
        ],
    );
    assert!(cx.is_framebuffer(99) && cx.is_renderbuffer(99));
}

#[test]
fn storage() {
    let mut cx = context();
    check(&mut cx, &[(|c| c.renderbuffer_storage(RB, GL_RGBA8, 4, 4), GL_INVALID_OPERATION)]);
    cx.bind_renderbuffer_ext(RB, 1);
    check(
        &mut cx,
        &[
            (|c| c.renderbuffer_storage(FB, GL_RGBA8, 4, 4), GL_INVALID_ENUM),
            (|c| c.renderbuffer_storage(RB, 4, 4, 4), GL_INVALID_ENUM),
            (|c| c.renderbuffer_storage(RB, GL_COMPRESSED_RGB, 4, 4), GL_INVALID_ENUM),
            (|c| c.renderbuffer_storage(RB, GL_FLOAT, 4, 4), GL_INVALID_ENUM),
            (|c| c.renderbuffer_storage(RB, GL_RGBA8, -1, 4), GL_INVALID_VALUE),
            (|c| c.renderbuffer_storage(RB, GL_RGBA8, 4, -1), GL_INVALID_VALUE),
            (|c| c.renderbuffer_storage(RB, GL_RGBA8, 16385, 4), GL_INVALID_VALUE),
            (|c| c.renderbuffer_storage_multisample(RB, -1, GL_RGBA8, 4, 4), GL_INVALID_VALUE),
            (|c| c.renderbuffer_storage_multisample(RB, 17, GL_RGBA8, 4, 4), GL_INVALID_VALUE),
            (|c| c.renderbuffer_storage_multisample(RB, 16, GL_RGBA16, 16384, 16384), GL_OUT_OF_MEMORY),
            (|c| c.renderbuffer_storage_multisample(RB, 16, GL_RGBA8, 16384, 4), GL_NO_ERROR),
        ],
    );
    check(
        &mut cx,
        &[
            (|c| _ = c.get_renderbuffer_parameter(FB, GL_RENDERBUFFER_WIDTH), GL_INVALID_ENUM),
            (|c| _ = c.get_renderbuffer_parameter(RB, GL_TEXTURE_WIDTH), GL_INVALID_ENUM),
            (|c| c.bind_renderbuffer(RB, 0), GL_NO_ERROR),
            (|c| _ = c.get_renderbuffer_parameter(RB, GL_RENDERBUFFER_WIDTH), GL_INVALID_OPERATION),
        ],
    );
}

#[test]
fn attaching() {
    let mut cx = context();
    check(
        &mut cx,
        &[
            (|c| c.framebuffer_renderbuffer(FB, COLOR0, RB, 0), GL_INVALID_OPERATION),
            (|c| c.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, 0, 0), GL_INVALID_OPERATION),
        ],
    );
    framebuffer(&mut cx);
    cx.bind_renderbuffer_ext(RB, 1);
    cx.bind_texture(GL_TEXTURE_1D, 11);
    cx.bind_texture(GL_TEXTURE_2D, 12);
    cx.bind_texture(GL_TEXTURE_3D, 13);
    cx.bind_texture(GL_TEXTURE_CUBE_MAP, 14);
    check(
        &mut cx,
        &[
            (|c| c.framebuffer_renderbuffer(RB, COLOR0, RB, 1), GL_INVALID_ENUM),
            (|c| c.framebuffer_renderbuffer(FB, GL_FRONT_LEFT, RB, 1), GL_INVALID_ENUM),
            (|c| c.framebuffer_renderbuffer(FB, COLOR0 + 8, RB, 1), GL_INVALID_OPERATION),
            (|c| c.framebuffer_renderbuffer(FB, COLOR0, FB, 1), GL_INVALID_ENUM),
            (|c| c.framebuffer_renderbuffer(FB, COLOR0, RB, 2), GL_INVALID_OPERATION),
            (|c| c.framebuffer_renderbuffer(GL_READ_FRAMEBUFFER, COLOR0 + 7, RB, 1), GL_NO_ERROR),
            (|c| c.framebuffer_texture_2d(RB, COLOR0, GL_TEXTURE_2D, 12, 0), GL_INVALID_ENUM),
            (|c| c.framebuffer_texture_2d(FB, GL_DEPTH, GL_TEXTURE_2D, 12, 0), GL_INVALID_ENUM),
            (|c| c.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, 99, 0), GL_INVALID_OPERATION),
            (|c| c.framebuffer_texture_2d(FB, COLOR0, GL_RGBA, 12, 0), GL_INVALID_ENUM),
            (|c| c.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, 14, 0), GL_INVALID_OPERATION),
            (|c| c.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_CUBE_MAP, 14, 0), GL_INVALID_OPERATION),
            (|c| c.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_1D, 11, 0), GL_INVALID_OPERATION),
            (|c| c.framebuffer_texture_1d(FB, COLOR0, GL_TEXTURE_2D, 12, 0), GL_INVALID_OPERATION),
            (|c| c.framebuffer_texture_3d(FB, COLOR0, GL_TEXTURE_2D, 12, 0, 0), GL_INVALID_OPERATION),
            (|c| c.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, 12, -1), GL_INVALID_VALUE),
            (|c| c.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, 12, 15), GL_INVALID_VALUE),
            (|c| c.framebuffer_texture_3d(FB, COLOR0, GL_TEXTURE_3D, 13, 0, -1), GL_INVALID_VALUE),
            (|c| c.framebuffer_texture_3d(FB, COLOR0, GL_TEXTURE_3D, 13, 0, 2048), GL_INVALID_VALUE),
            (|c| c.framebuffer_texture_layer(FB, COLOR0, 12, 0, 0), GL_INVALID_OPERATION),
            (|c| c.framebuffer_texture_layer(FB, COLOR0, 13, 0, -1), GL_INVALID_VALUE),
            (|c| c.framebuffer_texture_layer(FB, COLOR0, 13, 12, 0), GL_INVALID_VALUE),
            (|c| c.framebuffer_texture_1d(FB, COLOR0, GL_TEXTURE_1D, 11, 0), GL_NO_ERROR),
            (|c| c.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_CUBE_MAP_NEGATIVE_Z, 14, 0), GL_NO_ERROR),
            (|c| c.framebuffer_texture_layer(FB, COLOR0, 13, 0, 0), GL_NO_ERROR),
            (|c| c.framebuffer_texture_2d(FB, COLOR0, 0, 0, -1), GL_NO_ERROR),
        ],
    );
}

#[test]
fn buffers() {
    let mut cx = context();
    check(
        &mut cx,
        &[
            (|c| c.draw_buffer(COLOR0), GL_INVALID_OPERATION),
            (|c| c.read_buffer(COLOR0), GL_INVALID_OPERATION),
            (|c| c.draw_buffers(1, &[GL_BACK_LEFT]), GL_NO_ERROR),
            (|c| c.draw_buffers(1, &[GL_FRONT]), GL_INVALID_ENUM),
            (|c| c.draw_buffers(1, &[GL_FRONT_RIGHT]), GL_INVALID_OPERATION),
            (|c| c.draw_buffers(1, &[COLOR0]), GL_INVALID_OPERATION),
            (|c| c.draw_buffer(GL_FRONT), GL_NO_ERROR),
        ],
    );
    framebuffer(&mut cx);
    check(
        &mut cx,
        &[
            (|c| c.draw_buffer(GL_FRONT), GL_INVALID_OPERATION),
            (|c| c.draw_buffer(GL_BACK), GL_INVALID_OPERATION),
            (|c| c.draw_buffer(COLOR0 + 8), GL_INVALID_OPERATION),
            (|c| c.draw_buffer(GL_RGBA), GL_INVALID_ENUM),
            (|c| c.draw_buffer(COLOR0 + 7), GL_NO_ERROR),
            (|c| c.read_buffer(GL_FRONT), GL_INVALID_OPERATION),
            (|c| c.read_buffer(COLOR0 + 8), GL_INVALID_OPERATION),
            (|c| c.read_buffer(GL_RGBA), GL_INVALID_ENUM),
            (|c| c.read_buffer(GL_NONE), GL_NO_ERROR),
            (|c| c.draw_buffers(-1, &[]), GL_INVALID_VALUE),
            (|c| c.draw_buffers(9, &[GL_NONE; 9]), GL_INVALID_VALUE),
            (|c| c.draw_buffers(1, &[GL_RGBA]), GL_INVALID_ENUM),
            (|c| c.draw_buffers(1, &[GL_BACK]), GL_INVALID_ENUM),
            (|c| c.draw_buffers(1, &[GL_BACK_LEFT]), GL_INVALID_OPERATION),
            (|c| c.draw_buffers(1, &[COLOR0 + 8]), GL_INVALID_OPERATION),
            (|c| c.draw_buffers(2, &[COLOR0, COLOR0]), GL_INVALID_OPERATION),
            (|c| c.draw_buffers(3, &[GL_NONE, COLOR0, GL_NONE]), GL_NO_ERROR),
        ],
    );
}

#[test]
fn an_incomplete_framebuffer_cannot_be_drawn_to_nor_read() {
    let mut cx = context();
    framebuffer(&mut cx);
    let wrong = GL_INVALID_FRAMEBUFFER_OPERATION;
    static VERTEX: [f32; 2] = [0.0; 2];
    // SAFETY: one vertex is there for as long as the program runs.
    unsafe { cx.vertex_pointer(2, GL_FLOAT, 0, VERTEX.as_ptr().cast()) };
    cx.enable_client_state(GL_VERTEX_ARRAY);
    check(
        &mut cx,
        &[
            (|c| c.begin(GL_POINTS), wrong),
            (|c| c.rect(0.0, 0.0, 1.0, 1.0), wrong),
            (|c| c.clear(GL_COLOR_BUFFER_BIT), wrong),
            (|c| c.clear(0), wrong),
            (|c| c.draw_arrays(GL_POINTS, 0, 1), wrong),
            (|c| c.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, None), wrong),
            (|c| c.bitmap(1, 1, 0.0, 0.0, 0.0, 0.0, None), wrong),
            (|c| c.copy_pixels(0, 0, 1, 1, GL_COLOR), wrong),
            (|c| c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Some(&mut [0; 4])), wrong),
            (|c| c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 1, 1, 0), wrong),
            (|c| c.blit_framebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST), wrong),
            (|c| c.finish(), GL_NO_ERROR),
        ],
    );
    // Only the side that is used counts.
    cx.bind_framebuffer(GL_READ_FRAMEBUFFER, 0);
    check(&mut cx, &[(|c| c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Some(&mut [0; 4])), GL_NO_ERROR)]);
}

#[test]
fn a_multisampled_framebuffer_cannot_be_read() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 4, GL_RGBA8, 4, 4);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 4, GL_DEPTH_COMPONENT24, 4, 4);
    check(
        &mut cx,
        &[
            (|c| c.clear(GL_COLOR_BUFFER_BIT), GL_NO_ERROR),
            (|c| c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Some(&mut [0; 4])), GL_INVALID_OPERATION),
            (|c| c.read_pixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, Some(&mut [0; 4])), GL_INVALID_OPERATION),
            (|c| c.copy_pixels(0, 0, 1, 1, GL_COLOR), GL_INVALID_OPERATION),
            (|c| c.copy_tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA, 0, 0, 1, 1, 0), GL_INVALID_OPERATION),
        ],
    );
}

#[test]
fn buffers_that_are_not_there_cannot_be_read() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 4, 4);
    check(
        &mut cx,
        &[
            (|c| c.read_pixels(0, 0, 1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, Some(&mut [0; 4])), GL_INVALID_OPERATION),
            (|c| c.read_pixels(0, 0, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, Some(&mut [0])), GL_INVALID_OPERATION),
            (|c| c.draw_pixels(1, 1, GL_DEPTH_COMPONENT, GL_FLOAT, None), GL_INVALID_OPERATION),
            (|c| c.read_buffer(GL_NONE), GL_NO_ERROR),
            (|c| c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Some(&mut [0; 4])), GL_INVALID_OPERATION),
            (|c| c.accum(GL_LOAD, 1.0), GL_INVALID_OPERATION),
        ],
    );
}

#[test]
fn status_and_mipmaps() {
    let mut cx = context();
    check(
        &mut cx,
        &[
            (|c| _ = c.check_framebuffer_status(RB), GL_INVALID_ENUM),
            (|c| c.generate_mipmap(GL_TEXTURE_CUBE_MAP_POSITIVE_X), GL_INVALID_ENUM),
            (|c| c.generate_mipmap(GL_TEXTURE_CUBE_MAP), GL_INVALID_OPERATION),
            (|c| c.generate_mipmap(GL_TEXTURE_2D), GL_INVALID_OPERATION),
            (|c| c.tex_image_2d(GL_TEXTURE_2D, 0, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, None), GL_NO_ERROR),
            (|c| c.generate_mipmap(GL_TEXTURE_2D), GL_NO_ERROR),
        ],
    );
}

#[test]
fn none_of_it_between_begin_and_end() {
    let mut cx = context();
    let name = framebuffer(&mut cx);
    cx.bind_framebuffer(FB, 0);
    cx.begin(GL_POINTS);
    cx.bind_framebuffer(FB, name);
    cx.blit_framebuffer(0, 0, 1, 1, 0, 0, 1, 1, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    assert!(!cx.is_framebuffer(name));
    cx.end();
    assert_eq!(cx.get_error(), GL_INVALID_OPERATION);
    assert_eq!(get(&mut cx, GL_DRAW_FRAMEBUFFER_BINDING), 0);
}
