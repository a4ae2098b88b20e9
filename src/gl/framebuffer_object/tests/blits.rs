//! glBlitFramebuffer: its errors, and its way through windows and images.

use super::*;

const COLOR: u32 = GL_COLOR_BUFFER_BIT;
const DEPTH: u32 = GL_DEPTH_BUFFER_BIT;
const STENCIL: u32 = GL_STENCIL_BUFFER_BIT;

#[track_caller]
fn blit(cx: &mut Context, from: [i32; 4], to: [i32; 4], mask: u32, filter: GLenum) -> GLenum {
    error_of(cx, |c| c.blit_framebuffer(from[0], from[1], from[2], from[3], to[0], to[1], to[2], to[3], mask, filter))
}

/// A framebuffer to read from with so many samples, one to draw to with others; colour and depth of 4 x 4.
fn pair(cx: &mut Context, samples: [i32; 2]) -> [u32; 2] {
    let names = samples.map(|samples| {
        let name = framebuffer(cx);
        attach(cx, COLOR0, samples, GL_RGBA8, 4, 4);
        attach(cx, GL_DEPTH_STENCIL_ATTACHMENT, samples, GL_DEPTH24_STENCIL8, 4, 4);
        name
    });
    cx.bind_framebuffer(GL_READ_FRAMEBUFFER, names[0]);
    names
}

const ALL: [i32; 4] = [0, 0, 4, 4];

#[test]
fn arguments() {
    let mut cx = context();
    pair(&mut cx, [0, 0]);
    assert_eq!(blit(&mut cx, ALL, ALL, COLOR | 1, GL_NEAREST), GL_INVALID_VALUE);
    assert_eq!(blit(&mut cx, ALL, ALL, GL_ACCUM_BUFFER_BIT, GL_NEAREST), GL_INVALID_VALUE);
    assert_eq!(blit(&mut cx, ALL, ALL, COLOR, GL_LINEAR_MIPMAP_LINEAR), GL_INVALID_ENUM);
    assert_eq!(blit(&mut cx, ALL, ALL, COLOR | DEPTH, GL_LINEAR), GL_INVALID_OPERATION);
    assert_eq!(blit(&mut cx, ALL, ALL, STENCIL, GL_LINEAR), GL_INVALID_OPERATION);
    assert_eq!(blit(&mut cx, ALL, ALL, 0, GL_LINEAR), GL_NO_ERROR);
    assert_eq!(blit(&mut cx, ALL, [0, 0, 9, 9], COLOR, GL_LINEAR), GL_NO_ERROR);
    assert_eq!(blit(&mut cx, ALL, ALL, COLOR | DEPTH | STENCIL, GL_NEAREST), GL_NO_ERROR);
    let far = [i32::MIN, i32::MIN, i32::MAX, i32::MAX];
    assert_eq!(blit(&mut cx, far, far, COLOR | DEPTH | STENCIL, GL_NEAREST), GL_NO_ERROR);
}

#[test]
fn samples_have_to_fit() {
    let mut cx = context();
    pair(&mut cx, [4, 2]);
    assert_eq!(blit(&mut cx, ALL, ALL, COLOR, GL_NEAREST), GL_INVALID_OPERATION);
    pair(&mut cx, [4, 4]);
    assert_eq!(blit(&mut cx, ALL, ALL, COLOR, GL_NEAREST), GL_NO_ERROR);
    assert_eq!(blit(&mut cx, ALL, [0, 0, 4, 3], COLOR, GL_NEAREST), GL_INVALID_OPERATION);
    pair(&mut cx, [4, 0]);
    assert_eq!(blit(&mut cx, ALL, [0, 0, 8, 4], COLOR, GL_NEAREST), GL_INVALID_OPERATION);
    assert_eq!(blit(&mut cx, ALL, [4, 0, 0, 4], COLOR | DEPTH, GL_NEAREST), GL_NO_ERROR);
    pair(&mut cx, [0, 4]);
    assert_eq!(blit(&mut cx, [0, 0, 2, 2], ALL, COLOR, GL_NEAREST), GL_INVALID_OPERATION);
    assert_eq!(blit(&mut cx, ALL, ALL, COLOR, GL_NEAREST), GL_NO_ERROR);
}

#[test]
fn depths_have_to_be_of_one_format() {
    let mut cx = context();
    pair(&mut cx, [0, 0]);
    attach(&mut cx, GL_STENCIL_ATTACHMENT, 0, GL_RGBA8, 0, 0);
    cx.framebuffer_renderbuffer(GL_DRAW_FRAMEBUFFER, GL_STENCIL_ATTACHMENT, RB, 0);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_DEPTH_COMPONENT16, 4, 4);
    assert_eq!(blit(&mut cx, ALL, ALL, COLOR | DEPTH, GL_NEAREST), GL_INVALID_OPERATION);
    // A buffer that one side lacks is left out.
    assert_eq!(blit(&mut cx, ALL, ALL, COLOR | STENCIL, GL_NEAREST), GL_NO_ERROR);
    cx.framebuffer_renderbuffer(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, RB, 0);
    assert_eq!(blit(&mut cx, ALL, ALL, COLOR | DEPTH, GL_NEAREST), GL_NO_ERROR);
}

#[test]
fn the_window_is_read_and_written_the_right_way_up() {
    let mut cx = context();
    let name = framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 2, 2);
    fill(&mut cx, [0, 0, 2, 2], RED);
    fill(&mut cx, [1, 1, 1, 1], GREEN);
    let (r, g, o) = ([255, 0, 0, 255], [0, 255, 0, 255], [0; 4]);
    cx.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
    assert_eq!(blit(&mut cx, [0, 0, 2, 2], [0, 0, 2, 2], COLOR, GL_NEAREST), GL_NO_ERROR);
    cx.bind_framebuffer(FB, 0);
    assert_eq!(pixels(&mut cx, 3, 3), [r, r, o, r, g, o, o, o, o]);
    // Onto itself, upside down; the scissor cuts.
    cx.enable(GL_SCISSOR_TEST);
    cx.scissor(0, 2, 8, 3);
    assert_eq!(blit(&mut cx, [0, 0, 2, 2], [0, 5, 2, 1], COLOR, GL_NEAREST), GL_NO_ERROR);
    assert_eq!(pixels(&mut cx, 2, 6), [r, r, r, g, r, g, r, r, r, r, o, o]);
    cx.disable(GL_SCISSOR_TEST);
    cx.bind_framebuffer(GL_DRAW_FRAMEBUFFER, name);
    assert_eq!(blit(&mut cx, [0, 1, 2, 3], [0, 0, 2, 2], COLOR, GL_NEAREST), GL_NO_ERROR);
    cx.bind_framebuffer(FB, name);
    assert_eq!(pixels(&mut cx, 2, 2), [r, g, r, g]);
}

#[test]
fn neither_mask_applies() {
    let mut cx = context();
    let [from, to] = pair(&mut cx, [0, 0]);
    cx.bind_framebuffer(FB, from);
    cx.clear_stencil(7);
    cx.clear(STENCIL);
    fill(&mut cx, [0, 0, 4, 4], RED);
    cx.bind_framebuffer(GL_DRAW_FRAMEBUFFER, to);
    cx.color_mask(false, false, false, false);
    cx.stencil_mask(0);
    cx.depth_mask(false);
    assert_eq!(blit(&mut cx, ALL, ALL, COLOR | STENCIL | DEPTH, GL_NEAREST), GL_NO_ERROR);
    cx.bind_framebuffer(FB, to);
    assert_eq!(pixels(&mut cx, 1, 1)[0], [255, 0, 0, 255]);
    let mut stencil = [0];
    cx.read_pixels(3, 3, 1, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, Some(&mut stencil));
    assert_eq!(stencil, [7]);
}

#[test]
fn it_is_compiled_into_lists() {
    let mut cx = context();
    let [from, to] = pair(&mut cx, [0, 0]);
    cx.new_list(9, GL_COMPILE);
    cx.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, COLOR, GL_NEAREST);
    cx.end_list();
    cx.bind_framebuffer(FB, from);
    fill(&mut cx, [0, 0, 4, 4], GREEN);
    cx.bind_framebuffer(GL_DRAW_FRAMEBUFFER, to);
    cx.call_list(9);
    cx.bind_framebuffer(FB, to);
    assert_eq!(pixels(&mut cx, 1, 1)[0], [0, 255, 0, 255]);
}
