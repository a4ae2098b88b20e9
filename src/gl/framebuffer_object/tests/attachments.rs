//! Lives of attached objects.

use super::*;

fn type_of(cx: &mut Context, point: GLenum) -> GLenum {
    cx.get_framebuffer_attachment_parameter(FB, point, GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE).unwrap_or(!0) as GLenum
}

#[test]
fn deleting_detaches_from_the_bound_framebuffer() {
    let mut cx = context();
    framebuffer(&mut cx);
    let buffer = attach(&mut cx, GL_DEPTH_STENCIL_ATTACHMENT, 0, GL_DEPTH24_STENCIL8, 4, 4);
    let name = texture(&mut cx, GL_RGBA8, 4, 4);
    cx.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, name, 0);
    cx.delete_renderbuffers(1, &[buffer]);
    cx.delete_textures(1, &[name]);
    assert_eq!([COLOR0, GL_DEPTH_ATTACHMENT, GL_STENCIL_ATTACHMENT].map(|p| type_of(&mut cx, p)), [GL_NONE; 3]);
}

#[test]
fn other_framebuffers_keep_what_was_deleted() {
    let mut cx = context();
    let first = framebuffer(&mut cx);
    let name = texture(&mut cx, GL_RGBA8, 2, 2);
    cx.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, name, 0);
    fill(&mut cx, [0, 0, 2, 2], RED);
    let second = framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 2, 2);
    fill(&mut cx, [0, 0, 2, 2], GREEN);
    let buffer = get(&mut cx, GL_RENDERBUFFER_BINDING) as u32;
    cx.bind_framebuffer(FB, 0);
    cx.delete_textures(1, &[name]);
    cx.delete_renderbuffers(1, &[buffer]);
    assert!(!cx.is_texture(name) && !cx.is_renderbuffer(buffer));
    // The names are free for other objects.
    cx.bind_texture(GL_TEXTURE_3D, name);
    cx.bind_renderbuffer_ext(RB, buffer);
    cx.bind_framebuffer(FB, first);
    assert_eq!((status(&mut cx), pixels(&mut cx, 1, 1)[0]), (GL_FRAMEBUFFER_COMPLETE, [255, 0, 0, 255]));
    fill(&mut cx, [0, 0, 1, 1], GREEN);
    assert_eq!(pixels(&mut cx, 2, 1), [[0, 255, 0, 255], [255, 0, 0, 255]]);
    cx.bind_framebuffer(FB, second);
    assert_eq!((status(&mut cx), pixels(&mut cx, 1, 1)[0]), (GL_FRAMEBUFFER_COMPLETE, [0, 255, 0, 255]));
}

#[test]
fn contexts_share_images_but_not_framebuffers() {
    let mut cx = context();
    let name = framebuffer(&mut cx);
    let buffer = attach(&mut cx, COLOR0, 0, GL_RGBA8, 2, 2);
    fill(&mut cx, [0, 0, 2, 2], RED);
    cx.finish();
    let mut other = Context::new(ContextConfig::default(), Some(&cx));
    other.attach_window(2, 2);
    assert!(!other.is_framebuffer(name) && other.is_renderbuffer(buffer));
    framebuffer(&mut other);
    other.framebuffer_renderbuffer(FB, COLOR0, RB, buffer);
    assert_eq!(pixels(&mut other, 1, 1)[0], [255, 0, 0, 255]);
}

#[test]
fn new_storage_is_new() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 2, 2);
    fill(&mut cx, [0, 0, 2, 2], RED);
    cx.renderbuffer_storage(RB, GL_RGB8, 3, 3);
    assert_eq!(pixels(&mut cx, 3, 3), [[0, 0, 0, 255]; 9]);
    fill(&mut cx, [2, 2, 1, 1], [0.0, 0.0, 1.0, 0.0]);
    assert_eq!(pixels(&mut cx, 3, 3)[8], [0, 0, 255, 255]);
}
