//! GL_DEPTH_COMPONENT32F (ARB_depth_buffer_float): what is kept are numbers, not steps.

use super::*;

/// A framebuffer of 4 x 4 with colour and floating-point depth, cleared to 1.
fn float_framebuffer(samples: i32) -> (Context, u32) {
    let mut cx = context();
    let name = framebuffer(&mut cx);
    attach(&mut cx, COLOR0, samples, GL_RGBA8, 4, 4);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, samples, GL_DEPTH_COMPONENT32F, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
    cx.viewport(0, 0, 4, 4);
    cx.clear(GL_DEPTH_BUFFER_BIT);
    cx.enable(GL_DEPTH_TEST);
    cx.depth_func(GL_ALWAYS);
    (cx, name)
}

fn depths(cx: &mut Context, x: i32, count: i32) -> Vec<f32> {
    let mut out = vec![0; count as usize * 4];
    cx.read_pixels(x, 0, count, 1, GL_DEPTH_COMPONENT, GL_FLOAT, Some(&mut out));
    assert_eq!(cx.get_error(), GL_NO_ERROR);
    out.chunks_exact(4).map(|b| f32::from_ne_bytes([b[0], b[1], b[2], b[3]])).collect()
}

fn rectangle_at(cx: &mut Context, z: f32) {
    cx.begin(GL_QUADS);
    for [x, y] in [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]] {
        cx.vertex(x, y, z, 1.0);
    }
    cx.end();
}

#[test]
fn its_size_and_type_are_told() {
    let (mut cx, _) = float_framebuffer(0);
    assert_eq!(get(&mut cx, GL_DEPTH_BITS), 32);
    assert_eq!(get(&mut cx, GL_STENCIL_BITS), 0);
    let of = |cx: &mut Context, pname| cx.get_framebuffer_attachment_parameter(FB, GL_DEPTH_ATTACHMENT, pname);
    assert_eq!(of(&mut cx, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE), Some(32));
    assert_eq!(of(&mut cx, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE), Some(GL_FLOAT as i32));
    assert_eq!(cx.get_renderbuffer_parameter(RB, GL_RENDERBUFFER_DEPTH_SIZE), Some(32));
    assert_eq!(cx.get_renderbuffer_parameter(RB, GL_RENDERBUFFER_INTERNAL_FORMAT), Some(GL_DEPTH_COMPONENT32F as i32));
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_DEPTH_COMPONENT24, 4, 4);
    assert_eq!(of(&mut cx, GL_FRAMEBUFFER_ATTACHMENT_COMPONENT_TYPE), Some(GL_UNSIGNED_NORMALIZED as i32));
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn there_is_no_stencil_beside_it() {
    let (mut cx, _) = float_framebuffer(0);
    let name = renderbuffer(&mut cx, 0, GL_DEPTH_COMPONENT32F, 4, 4);
    cx.framebuffer_renderbuffer(FB, GL_STENCIL_ATTACHMENT, RB, name);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_INCOMPLETE_ATTACHMENT);
    attach(&mut cx, GL_STENCIL_ATTACHMENT, 0, GL_STENCIL_INDEX8, 4, 4);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_UNSUPPORTED);
    assert_eq!(error_of(&mut cx, |c| c.renderbuffer_storage(RB, GL_DEPTH32F_STENCIL8, 4, 4)), GL_INVALID_ENUM);
    let image = |c: &mut Context| {
        c.tex_image_2d(GL_TEXTURE_2D, 0, GL_DEPTH32F_STENCIL8 as i32, 4, 4, 0, GL_DEPTH_COMPONENT, GL_FLOAT, None);
    };
    assert_eq!(error_of(&mut cx, image), GL_INVALID_VALUE);
    let extensions = cx.get_string(GL_EXTENSIONS).unwrap().to_str().unwrap().to_owned();
    assert!(!extensions.contains("depth_buffer_float"), "it promises GL_DEPTH32F_STENCIL8");
}

#[test]
fn clears_keep_every_number_between_0_and_1() {
    let (mut cx, _) = float_framebuffer(0);
    for (wish, kept) in [(0.1, 0.1), (1e-30, 1e-30), (1e-40, 1e-40), (2.0, 1.0), (-1.0, 0.0)] {
        cx.clear_depth(wish);
        cx.clear(GL_DEPTH_BUFFER_BIT);
        assert_eq!(depths(&mut cx, 0, 4), [kept; 4]);
    }
}

#[test]
fn depths_that_24_bits_take_for_one_are_told_apart() {
    let (mut cx, _) = float_framebuffer(0);
    cx.depth_func(GL_LESS);
    cx.depth_range(0.0, 1e-6);
    cx.color(1.0, 0.0, 0.0, 1.0);
    rectangle_at(&mut cx, 0.0);
    cx.color(0.0, 1.0, 0.0, 1.0);
    rectangle_at(&mut cx, -0.001);
    cx.color(0.0, 0.0, 1.0, 1.0);
    rectangle_at(&mut cx, -0.0005);
    assert_eq!(pixels(&mut cx, 1, 1), [[0, 255, 0, 255]]);
    let depth = depths(&mut cx, 0, 1)[0];
    assert!((depth - 0.4995e-6).abs() < 1e-12, "{depth}");
}

#[test]
fn a_unit_of_polygon_offset_is_the_step_of_the_farthest_depth() {
    let (mut cx, _) = float_framebuffer(0);
    cx.enable(GL_POLYGON_OFFSET_FILL);
    for z in [-0.9999999f32, 0.0, 0.1, 0.5, 0.999999] {
        cx.polygon_offset(0.0, 0.0);
        rectangle_at(&mut cx, z);
        let flat = depths(&mut cx, 0, 1)[0];
        cx.polygon_offset(0.0, 3.0);
        rectangle_at(&mut cx, z);
        assert_eq!(depths(&mut cx, 0, 1)[0].to_bits(), flat.to_bits() + 3, "{z}");
    }
    // Clamped, and never below zero.
    cx.polygon_offset(0.0, 1.0);
    rectangle_at(&mut cx, 1.0);
    assert_eq!(depths(&mut cx, 0, 1), [1.0]);
    cx.polygon_offset(0.0, -1.0);
    rectangle_at(&mut cx, -1.0);
    assert_eq!(depths(&mut cx, 0, 1)[0].to_bits(), 0);
}

#[test]
fn depths_are_drawn_copied_and_blitted_as_they_are() {
    let (mut cx, first) = float_framebuffer(0);
    let drawn = [0.1f32, 1.5, -0.5, 1e-40];
    let kept = [0.1f32, 1.0, 0.0, 0.0];
    let bytes: Vec<u8> = drawn.iter().flat_map(|d| d.to_ne_bytes()).collect();
    // Straight into the buffer, then as fragments.
    for (mask, func) in [(false, GL_ALWAYS), (true, GL_ALWAYS), (true, GL_LEQUAL)] {
        cx.color_mask(mask, mask, mask, mask);
        cx.depth_func(func);
        cx.clear_depth(1.0);
        cx.clear(GL_DEPTH_BUFFER_BIT);
        cx.window_pos(0.0, 0.0, 0.0);
        cx.draw_pixels(4, 1, GL_DEPTH_COMPONENT, GL_FLOAT, Some(&bytes));
        assert_eq!(depths(&mut cx, 0, 4), kept, "{mask} {func:#x}");
    }
    cx.depth_func(GL_ALWAYS);
    cx.window_pos(2.0, 0.0, 0.0);
    cx.copy_pixels(0, 0, 2, 1, GL_DEPTH);
    assert_eq!(depths(&mut cx, 0, 4), [0.1, 1.0, 0.1, 1.0]);
    let second = framebuffer(&mut cx);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_DEPTH_COMPONENT32F, 4, 4);
    cx.draw_buffer(GL_NONE);
    cx.read_buffer(GL_NONE);
    cx.bind_framebuffer(GL_READ_FRAMEBUFFER, first);
    cx.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    cx.bind_framebuffer(FB, second);
    assert_eq!(depths(&mut cx, 0, 4), [0.1, 1.0, 0.1, 1.0]);
    cx.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
    let blit = |c: &mut Context| c.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    assert_eq!(error_of(&mut cx, blit), GL_INVALID_OPERATION, "to 24 bits");
}

#[test]
fn textures_hold_them_too() {
    let (mut cx, _) = float_framebuffer(0);
    let name = texture(&mut cx, GL_RGBA8, 2, 2);
    let texels = |cx: &mut Context, level, count: usize| {
        let mut out = vec![0; count * 4];
        cx.get_tex_image(GL_TEXTURE_2D, level, GL_DEPTH_COMPONENT, GL_FLOAT, Some(&mut out));
        out.chunks_exact(4).map(|b| f32::from_ne_bytes([b[0], b[1], b[2], b[3]])).collect::<Vec<_>>()
    };
    let bytes: Vec<u8> = [0.1f32, 2.0, -1.0, 3e-30].iter().flat_map(|d| d.to_ne_bytes()).collect();
    let format = GL_DEPTH_COMPONENT32F;
    cx.tex_image_2d(GL_TEXTURE_2D, 0, format as i32, 2, 2, 0, GL_DEPTH_COMPONENT, GL_FLOAT, Some(&bytes));
    assert_eq!(texels(&mut cx, 0, 4), [0.1, 1.0, 0.0, 3e-30]);
    assert_eq!(cx.get_tex_level_parameter(GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_SIZE), Some(32));
    cx.generate_mipmap(GL_TEXTURE_2D);
    assert_eq!(texels(&mut cx, 1, 1), [0.275]);
    // Drawn to and read.
    cx.framebuffer_texture_2d(FB, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, name, 0);
    assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
    assert_eq!(depths(&mut cx, 0, 2), [0.1, 1.0], "what the texture held");
    cx.clear_depth(1e-20);
    cx.clear(GL_DEPTH_BUFFER_BIT);
    assert_eq!(texels(&mut cx, 0, 4), [1e-20; 4]);
    // Copied from the framebuffer, and sampled.
    cx.clear_depth(0.25);
    cx.clear(GL_DEPTH_BUFFER_BIT);
    texture(&mut cx, GL_RGBA8, 2, 2);
    cx.copy_tex_image_2d(GL_TEXTURE_2D, 0, format, 0, 0, 2, 2, 0);
    assert_eq!(texels(&mut cx, 0, 4), [0.25; 4]);
    cx.bind_framebuffer(FB, 0);
    cx.viewport(0, 0, 2, 2);
    cx.disable(GL_DEPTH_TEST);
    cx.enable(GL_TEXTURE_2D);
    cx.tex_env(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &[GL_REPLACE as f32]);
    rectangle_at(&mut cx, 0.0);
    assert_eq!(pixels(&mut cx, 1, 1), [[64, 64, 64, 255]]);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn samples_have_depths_of_their_own() {
    let (mut cx, many) = float_framebuffer(4);
    cx.begin(GL_TRIANGLES);
    for [x, y, z] in [[-1.0, -1.0, -1.0], [3.0, -1.0, 1.0], [-1.0, 3.0, -1.0]] {
        cx.vertex(x, y, z, 1.0);
    }
    cx.end();
    let one = framebuffer(&mut cx);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_DEPTH_COMPONENT32F, 4, 4);
    cx.draw_buffer(GL_NONE);
    cx.read_buffer(GL_NONE);
    cx.bind_framebuffer(GL_READ_FRAMEBUFFER, many);
    cx.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_DEPTH_BUFFER_BIT, GL_NEAREST);
    cx.bind_framebuffer(FB, one);
    // The first sample lies 1/8 pixel left of the centre.
    assert_eq!(depths(&mut cx, 0, 4), [0.375, 1.375, 2.375, 3.375].map(|x| x / 8.0));
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}
