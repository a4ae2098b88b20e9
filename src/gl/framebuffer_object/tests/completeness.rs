//! The rules of completeness, one by one.

use super::*;

#[test]
fn the_window_is_complete() {
    let mut cx = context();
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
    let mut without = Context::new(ContextConfig::default(), None);
    assert_eq!(status(&mut without), GL_FRAMEBUFFER_UNDEFINED);
}

#[test]
fn nothing_attached_is_missing() {
    let mut cx = context();
    framebuffer(&mut cx);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
    cx.draw_buffer(GL_NONE);
    cx.read_buffer(GL_NONE);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_MISSING_ATTACHMENT);
}

#[test]
fn one_renderbuffer_is_enough() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
}

#[test]
fn every_colour_format_of_the_era_is_renderable() {
    let formats = [
        GL_R3_G3_B2,
        GL_RGB,
        GL_RGB4,
        GL_RGB5,
        GL_RGB8,
        GL_RGB10,
        GL_RGB12,
        GL_RGB16,
        GL_RGBA,
        GL_RGBA2,
        GL_RGBA4,
        GL_RGB5_A1,
        GL_RGBA8,
        GL_RGB10_A2,
        GL_RGBA12,
        GL_RGBA16,
        GL_ALPHA8,
        GL_LUMINANCE8,
        GL_LUMINANCE8_ALPHA8,
        GL_INTENSITY8,
        GL_LUMINANCE16,
    ];
    let mut cx = context();
    framebuffer(&mut cx);
    for format in formats {
        attach(&mut cx, COLOR0, 0, format, 4, 4);
        assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE, "renderbuffer {format:#x}");
        let name = texture(&mut cx, format, 4, 4);
        cx.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, name, 0);
        assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE, "texture {format:#x}");
        assert_eq!(cx.get_error(), GL_NO_ERROR);
    }
}

#[test]
fn images_have_to_be_there_and_not_empty() {
    let mut cx = context();
    framebuffer(&mut cx);
    let name = attach(&mut cx, COLOR0, 0, GL_RGBA8, 0, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT, "no columns");
    cx.renderbuffer_storage(RB, GL_RGBA8, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
    let bare = cx.gen_renderbuffers(1)[0];
    cx.bind_renderbuffer(RB, bare);
    cx.framebuffer_renderbuffer(FB, COLOR0, RB, bare);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT, "no storage");
    cx.framebuffer_renderbuffer(FB, COLOR0, RB, name);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
    let tex = texture(&mut cx, GL_RGBA8, 4, 4);
    cx.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, tex, 1);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT, "no such level");
    cx.tex_image_2d(GL_TEXTURE_2D, 1, GL_RGBA8 as i32, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, None);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
}

#[test]
fn layers_have_to_be_there() {
    let mut cx = context();
    framebuffer(&mut cx);
    cx.bind_texture(GL_TEXTURE_3D, 77);
    cx.tex_image_3d(GL_TEXTURE_3D, 0, GL_RGBA8 as i32, 4, 4, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, None);
    cx.framebuffer_texture_3d(FB, COLOR0, GL_TEXTURE_3D, 77, 0, 1);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
    cx.framebuffer_texture_layer(FB, COLOR0, 77, 0, 2);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
}

#[test]
fn formats_have_to_suit_the_point() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_DEPTH_COMPONENT24, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT, "depth as colour");
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 4, 4);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_RGBA8, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT, "colour as depth");
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_STENCIL_INDEX8, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT, "stencil as depth");
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_DEPTH_COMPONENT16, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
    cx.framebuffer_renderbuffer(FB, GL_DEPTH_ATTACHMENT, RB, 0);
    attach(&mut cx, GL_STENCIL_ATTACHMENT, 0, GL_DEPTH_COMPONENT16, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT, "depth as stencil");
    attach(&mut cx, GL_STENCIL_ATTACHMENT, 0, GL_STENCIL_INDEX8, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
    attach(&mut cx, GL_DEPTH_STENCIL_ATTACHMENT, 0, GL_DEPTH24_STENCIL8, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
}

#[test]
fn draw_buffers_have_to_be_there() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 4, 4);
    cx.draw_buffers(2, &[COLOR0, GL_COLOR_ATTACHMENT1]);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER);
    cx.draw_buffers(2, &[GL_NONE, COLOR0]);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
}

#[test]
fn the_read_buffer_has_to_be_there() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 4, 4);
    cx.read_buffer(GL_COLOR_ATTACHMENT3);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER);
    cx.read_buffer(GL_NONE);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
}

#[test]
fn depth_alone_is_complete_without_draw_and_read_buffer() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_DEPTH_COMPONENT24, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_DRAW_BUFFER);
    cx.draw_buffer(GL_NONE);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_READ_BUFFER);
    cx.read_buffer(GL_NONE);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
}

#[test]
fn samples_have_to_be_the_same_everywhere() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 4, GL_RGBA8, 4, 4);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 2, GL_DEPTH_COMPONENT24, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 3, GL_DEPTH_COMPONENT24, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE, "three are rounded up to four");
    let name = texture(&mut cx, GL_RGBA8, 4, 4);
    cx.framebuffer_texture_2d(FB, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, name, 0);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_MULTISAMPLE);
}

#[test]
fn depth_and_stencil_of_two_images_are_not_supported() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 4, 4);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_DEPTH_COMPONENT24, 4, 4);
    attach(&mut cx, GL_STENCIL_ATTACHMENT, 0, GL_STENCIL_INDEX8, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_UNSUPPORTED);
    let both = attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_DEPTH24_STENCIL8, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_UNSUPPORTED);
    cx.framebuffer_renderbuffer(FB, GL_STENCIL_ATTACHMENT, RB, both);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
}

#[test]
fn sizes_and_colour_formats_may_differ() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 4, 4);
    attach(&mut cx, GL_COLOR_ATTACHMENT1, 0, GL_RGB16, 8, 2);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_DEPTH_COMPONENT24, 16, 16);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
}

#[test]
fn a_respecified_texture_counts_as_it_is_now() {
    let mut cx = context();
    framebuffer(&mut cx);
    let name = texture(&mut cx, GL_RGBA8, 4, 4);
    cx.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, name, 0);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA8 as i32, 0, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, None);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
}
