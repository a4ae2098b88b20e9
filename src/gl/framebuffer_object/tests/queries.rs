//! What queries answer.

use super::*;

fn parameter(cx: &mut Context, attachment: GLenum, pname: GLenum) -> Result<i32, GLenum> {
    match cx.get_framebuffer_attachment_parameter(FB, attachment, pname) {
        Some(value) => Ok(value),
        None => Err(cx.get_error()),
    }
}

const TYPE: GLenum = GL_FRAMEBUFFER_ATTACHMENT_OBJECT_TYPE;
const NAME: GLenum = GL_FRAMEBUFFER_ATTACHMENT_OBJECT_NAME;
const LEVEL: GLenum = GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LEVEL;
const FACE: GLenum = GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_CUBE_MAP_FACE;
const LAYER: GLenum = GL_FRAMEBUFFER_ATTACHMENT_TEXTURE_LAYER;

#[test]
fn bindings_and_limits() {
    let mut cx = context();
    let name = framebuffer(&mut cx);
    let other = cx.gen_framebuffers(1)[0];
    assert!(cx.is_framebuffer(name) && !cx.is_framebuffer(other) && !cx.is_framebuffer(0));
    cx.bind_framebuffer(GL_READ_FRAMEBUFFER, other);
    assert_eq!(get(&mut cx, GL_FRAMEBUFFER_BINDING), name as i32);
    assert_eq!(get(&mut cx, GL_DRAW_FRAMEBUFFER_BINDING), name as i32);
    assert_eq!(get(&mut cx, GL_READ_FRAMEBUFFER_BINDING), other as i32);
    cx.delete_framebuffers(1, &[name]);
    assert_eq!(get(&mut cx, GL_DRAW_FRAMEBUFFER_BINDING), 0);
    assert_eq!(get(&mut cx, GL_READ_FRAMEBUFFER_BINDING), other as i32);
    let buffer = renderbuffer(&mut cx, 0, GL_RGB, 1, 1);
    assert_eq!(get(&mut cx, GL_RENDERBUFFER_BINDING), buffer as i32);
    cx.delete_renderbuffers(1, &[buffer]);
    assert_eq!(get(&mut cx, GL_RENDERBUFFER_BINDING), 0);
    for (pname, value) in [(GL_MAX_COLOR_ATTACHMENTS, 8), (GL_MAX_DRAW_BUFFERS, 8), (GL_MAX_SAMPLES, 16), (GL_MAX_RENDERBUFFER_SIZE, 16384)]
    {
        assert_eq!(get(&mut cx, pname), value, "{pname:#x}");
    }
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn renderbuffer_parameters() {
    let mut cx = context();
    cx.bind_renderbuffer_ext(RB, 5);
    let all = |cx: &mut Context| {
        [
            GL_RENDERBUFFER_WIDTH,
            GL_RENDERBUFFER_HEIGHT,
            GL_RENDERBUFFER_INTERNAL_FORMAT,
            GL_RENDERBUFFER_SAMPLES,
            GL_RENDERBUFFER_RED_SIZE,
            GL_RENDERBUFFER_ALPHA_SIZE,
            GL_RENDERBUFFER_DEPTH_SIZE,
            GL_RENDERBUFFER_STENCIL_SIZE,
        ]
        .map(|pname| cx.get_renderbuffer_parameter(RB, pname).unwrap())
    };
    assert_eq!(all(&mut cx), [0, 0, GL_RGBA as i32, 0, 0, 0, 0, 0]);
    cx.renderbuffer_storage_multisample(RB, 5, GL_RGB5, 3, 7);
    assert_eq!(all(&mut cx), [3, 7, GL_RGB5 as i32, 8, 5, 0, 0, 0]);
    cx.renderbuffer_storage(RB, GL_RGB10_A2, 3, 7);
    assert_eq!(all(&mut cx), [3, 7, GL_RGB10_A2 as i32, 0, 10, 2, 0, 0]);
    cx.renderbuffer_storage(RB, GL_DEPTH_STENCIL, 3, 7);
    assert_eq!(all(&mut cx), [3, 7, GL_DEPTH_STENCIL as i32, 0, 0, 0, 24, 8]);
    cx.renderbuffer_storage_multisample(RB, 1, GL_DEPTH_COMPONENT16, 3, 7);
    assert_eq!(all(&mut cx), [3, 7, GL_DEPTH_COMPONENT16 as i32, 2, 0, 0, 16, 0]);
    cx.renderbuffer_storage(RB, GL_STENCIL_INDEX1, 3, 7);
    assert_eq!(all(&mut cx), [3, 7, GL_STENCIL_INDEX1 as i32, 0, 0, 0, 0, 8]);
}

#[test]
fn attachment_parameters_of_a_framebuffer() {
    let mut cx = context();
    framebuffer(&mut cx);
    assert_eq!(parameter(&mut cx, COLOR0, TYPE), Ok(0));
    assert_eq!(parameter(&mut cx, COLOR0, NAME), Ok(0));
    assert_eq!(parameter(&mut cx, COLOR0, LEVEL), Err(GL_INVALID_OPERATION));
    assert_eq!(parameter(&mut cx, COLOR0, GL_RGBA), Err(GL_INVALID_ENUM));
    assert_eq!(parameter(&mut cx, GL_FRONT_LEFT, TYPE), Err(GL_INVALID_ENUM));
    assert_eq!(parameter(&mut cx, COLOR0 + 8, TYPE), Err(GL_INVALID_OPERATION));
    let buffer = attach(&mut cx, COLOR0, 0, GL_RGB8, 4, 4);
    assert_eq!(parameter(&mut cx, COLOR0, TYPE), Ok(GL_RENDERBUFFER as i32));
    assert_eq!(parameter(&mut cx, COLOR0, NAME), Ok(buffer as i32));
    assert_eq!(parameter(&mut cx, COLOR0, LEVEL), Err(GL_INVALID_ENUM));
    assert_eq!(parameter(&mut cx, COLOR0, FACE), Err(GL_INVALID_ENUM));
    assert_eq!(parameter(&mut cx, COLOR0, GL_FRAMEBUFFER_ATTACHMENT_BLUE_SIZE), Ok(8));
    assert_eq!(parameter(&mut cx, COLOR0, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE), Ok(0));
    assert_eq!(parameter(&mut cx, COLOR0, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE), Ok(GL_UNSIGNED_NORMALIZED as i32));
    assert_eq!(parameter(&mut cx, COLOR0, GL_FRAMEBUFFER_ATTACHMENT_COLOR_ENCODING), Ok(GL_LINEAR as i32));
    cx.bind_texture(GL_TEXTURE_CUBE_MAP, 14);
    cx.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 14, 3);
    assert_eq!(parameter(&mut cx, COLOR0, TYPE), Ok(GL_TEXTURE as i32));
    assert_eq!(parameter(&mut cx, COLOR0, NAME), Ok(14));
    assert_eq!(parameter(&mut cx, COLOR0, LEVEL), Ok(3));
    assert_eq!(parameter(&mut cx, COLOR0, FACE), Ok(GL_TEXTURE_CUBE_MAP_NEGATIVE_Y as i32));
    cx.bind_texture(GL_TEXTURE_3D, 15);
    cx.framebuffer_texture_3d(FB, COLOR0, GL_TEXTURE_3D, 15, 0, 9);
    assert_eq!(parameter(&mut cx, COLOR0, LAYER), Ok(9));
    assert_eq!(parameter(&mut cx, COLOR0, FACE), Ok(0));
    let both = attach(&mut cx, GL_DEPTH_STENCIL_ATTACHMENT, 0, GL_DEPTH24_STENCIL8, 4, 4);
    assert_eq!(parameter(&mut cx, GL_DEPTH_STENCIL_ATTACHMENT, NAME), Ok(both as i32));
    assert_eq!(parameter(&mut cx, GL_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_STENCIL_SIZE), Ok(8));
    assert_eq!(parameter(&mut cx, GL_DEPTH_STENCIL_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE), Err(GL_INVALID_OPERATION));
    cx.framebuffer_renderbuffer(FB, GL_STENCIL_ATTACHMENT, RB, 0);
    assert_eq!(parameter(&mut cx, GL_DEPTH_STENCIL_ATTACHMENT, NAME), Err(GL_INVALID_OPERATION));
    assert_eq!(parameter(&mut cx, GL_DEPTH_ATTACHMENT, NAME), Ok(both as i32));
}

#[test]
fn attachment_parameters_of_the_window() {
    let mut cx = context();
    assert_eq!(parameter(&mut cx, GL_FRONT_LEFT, TYPE), Ok(GL_FRAMEBUFFER_DEFAULT as i32));
    assert_eq!(parameter(&mut cx, GL_FRONT_RIGHT, TYPE), Ok(0));
    assert_eq!(parameter(&mut cx, GL_FRONT_LEFT, GL_FRAMEBUFFER_ATTACHMENT_ALPHA_SIZE), Ok(8));
    assert_eq!(parameter(&mut cx, GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE), Ok(24));
    assert_eq!(parameter(&mut cx, GL_DEPTH, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE), Ok(0));
    assert_eq!(parameter(&mut cx, GL_STENCIL, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE), Ok(GL_INDEX as i32));
    assert_eq!(parameter(&mut cx, COLOR0, TYPE), Err(GL_INVALID_OPERATION));
    assert_eq!(parameter(&mut cx, GL_RGBA, TYPE), Err(GL_INVALID_ENUM));
    assert_eq!(parameter(&mut cx, GL_FRONT_RIGHT, GL_FRAMEBUFFER_ATTACHMENT_RED_SIZE), Err(GL_INVALID_OPERATION));
    assert!(cx.get_framebuffer_attachment_parameter(RB, GL_FRONT_LEFT, TYPE).is_none());
    assert_eq!(cx.get_error(), GL_INVALID_ENUM);
}

#[test]
fn bits_and_samples_are_those_of_the_bound_framebuffer() {
    let mut cx = context();
    let bits = |cx: &mut Context| {
        [GL_RED_BITS, GL_ALPHA_BITS, GL_DEPTH_BITS, GL_STENCIL_BITS, GL_SAMPLE_BUFFERS, GL_SAMPLES].map(|pname| get(cx, pname))
    };
    assert_eq!(bits(&mut cx), [8, 8, 24, 8, 0, 0]);
    framebuffer(&mut cx);
    assert_eq!(bits(&mut cx), [0; 6]);
    attach(&mut cx, COLOR0, 3, GL_RGB16, 4, 4);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 4, GL_DEPTH_COMPONENT16, 4, 4);
    assert_eq!(bits(&mut cx), [16, 0, 16, 0, 1, 4]);
    cx.bind_framebuffer(FB, 0);
    assert_eq!(bits(&mut cx), [8, 8, 24, 8, 0, 0]);
}

#[test]
fn draw_and_read_buffers_belong_to_each_framebuffer() {
    let mut cx = context();
    framebuffer(&mut cx);
    assert_eq!([GL_DRAW_BUFFER, GL_DRAW_BUFFER0, GL_DRAW_BUFFER1].map(|p| get(&mut cx, p) as u32), [COLOR0, COLOR0, GL_NONE]);
    assert_eq!(get(&mut cx, GL_READ_BUFFER) as u32, COLOR0);
    cx.draw_buffers(3, &[GL_NONE, COLOR0 + 2, COLOR0 + 1]);
    cx.read_buffer(COLOR0 + 5);
    assert_eq!([GL_DRAW_BUFFER0, GL_DRAW_BUFFER1, GL_DRAW_BUFFER2].map(|p| get(&mut cx, p) as u32), [GL_NONE, COLOR0 + 2, COLOR0 + 1]);
    assert_eq!(get(&mut cx, GL_READ_BUFFER) as u32, COLOR0 + 5);
    cx.push_attrib(GL_COLOR_BUFFER_BIT | GL_PIXEL_MODE_BIT);
    cx.draw_buffer(COLOR0);
    cx.read_buffer(COLOR0);
    cx.pop_attrib();
    assert_eq!(get(&mut cx, GL_DRAW_BUFFER1) as u32, COLOR0 + 2);
    assert_eq!(get(&mut cx, GL_READ_BUFFER) as u32, COLOR0 + 5);
    cx.bind_framebuffer(FB, 0);
    assert_eq!([GL_DRAW_BUFFER, GL_READ_BUFFER].map(|p| get(&mut cx, p) as u32), [GL_FRONT, GL_FRONT]);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}
