//! Where pixels go.

use std::sync::Arc;

use super::*;
use crate::device::Device;
use crate::device::cpu::CpuDevice;
use crate::device::gpu::GpuDevice;

/// A rectangle in normalised coordinates.
fn rectangle(cx: &mut Context, [x0, y0, x1, y1]: [f32; 4], [r, g, b, a]: [f32; 4]) {
    cx.color(r, g, b, a);
    cx.rect(x0, y0, x1, y1);
}

fn level(cx: &mut Context, target: GLenum, level: i32, texels: usize) -> Vec<[u8; 4]> {
    let mut out = vec![0; texels * 4];
    cx.get_tex_image(target, level, GL_RGBA, GL_UNSIGNED_BYTE, Some(&mut out));
    out.chunks_exact(4).map(|p| [p[0], p[1], p[2], p[3]]).collect()
}

const R: [u8; 4] = [255, 0, 0, 255];
const G: [u8; 4] = [0, 255, 0, 255];
const O: [u8; 4] = [0; 4];

#[test]
fn row_zero_is_the_bottom_row() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 2, 3);
    cx.viewport(0, 0, 2, 3);
    rectangle(&mut cx, [-1.0, -1.0, 0.0, -1.0 / 3.0], RED);
    assert_eq!(pixels(&mut cx, 2, 3), [R, O, O, O, O, O]);
    cx.enable(GL_SCISSOR_TEST);
    cx.scissor(1, 1, 1, 1);
    rectangle(&mut cx, [-1.0, -1.0, 1.0, 1.0], GREEN);
    cx.disable(GL_SCISSOR_TEST);
    assert_eq!(pixels(&mut cx, 2, 3), [R, O, O, G, O, O]);
    // Pixel rectangles and bitmaps, straight and through the rasterizer.
    cx.window_pos(0.0, 2.0, 0.0);
    cx.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Some(&[1, 2, 3, 4]));
    cx.enable(GL_BLEND);
    cx.window_pos(1.0, 2.0, 0.0);
    cx.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Some(&[5, 6, 7, 8]));
    cx.window_pos(1.0, 0.0, 0.0);
    cx.pixel_zoom(1.0, 0.5);
    cx.draw_pixels(1, 2, GL_RGBA, GL_UNSIGNED_BYTE, Some(&[9, 9, 9, 9, 9, 9, 9, 9]));
    cx.disable(GL_BLEND);
    assert_eq!(pixels(&mut cx, 2, 3), [R, [9; 4], O, G, [1, 2, 3, 4], [5, 6, 7, 8]]);
    // The window is as it was, and still top first inside.
    cx.bind_framebuffer(FB, 0);
    assert_eq!(pixels(&mut cx, 8, 6), [O; 48]);
    fill(&mut cx, [0, 5, 1, 1], RED);
    assert_eq!(pixels(&mut cx, 1, 6), [O, O, O, O, O, R]);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn the_front_face_stays_the_front_face() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 2, 2);
    cx.viewport(0, 0, 2, 2);
    cx.enable(GL_CULL_FACE);
    rectangle(&mut cx, [-1.0, -1.0, 1.0, 1.0], RED);
    assert_eq!(pixels(&mut cx, 2, 2), [R; 4]);
    cx.cull_face(GL_FRONT);
    rectangle(&mut cx, [-1.0, -1.0, 1.0, 1.0], GREEN);
    assert_eq!(pixels(&mut cx, 2, 2), [R; 4]);
}

#[test]
fn depth_and_stencil_are_tested_where_they_are_attached() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 2, 1);
    let both = renderbuffer(&mut cx, 0, GL_DEPTH24_STENCIL8, 2, 1);
    cx.framebuffer_renderbuffer(FB, GL_DEPTH_STENCIL_ATTACHMENT, RB, both);
    cx.viewport(0, 0, 2, 1);
    cx.clear_depth(0.5);
    cx.clear_stencil(3);
    cx.clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    cx.enable(GL_DEPTH_TEST);
    cx.depth_func(GL_GREATER);
    // The rectangle is at depth 0.5: not greater.
    rectangle(&mut cx, [-1.0, -1.0, 1.0, 1.0], RED);
    assert_eq!(pixels(&mut cx, 2, 1), [O, O]);
    cx.depth_func(GL_EQUAL);
    cx.enable(GL_STENCIL_TEST);
    cx.stencil_func(GL_NOTEQUAL, 3, 255);
    rectangle(&mut cx, [-1.0, -1.0, 1.0, 1.0], RED);
    assert_eq!(pixels(&mut cx, 2, 1), [O, O]);
    // Without the stencil attachment there is no stencil test.
    cx.framebuffer_renderbuffer(FB, GL_STENCIL_ATTACHMENT, RB, 0);
    rectangle(&mut cx, [-1.0, -1.0, 0.0, 1.0], RED);
    assert_eq!(pixels(&mut cx, 2, 1), [R, O]);
    // Nor a depth test without depth; the image keeps both.
    cx.framebuffer_renderbuffer(FB, GL_DEPTH_ATTACHMENT, RB, 0);
    cx.depth_func(GL_NEVER);
    rectangle(&mut cx, [0.0, -1.0, 1.0, 1.0], RED);
    assert_eq!(pixels(&mut cx, 2, 1), [R, R]);
    cx.framebuffer_renderbuffer(FB, GL_DEPTH_STENCIL_ATTACHMENT, RB, both);
    let mut stencil = [0; 2];
    cx.pixel_storei(GL_PACK_ALIGNMENT, 1);
    cx.read_pixels(0, 0, 2, 1, GL_STENCIL_INDEX, GL_UNSIGNED_BYTE, Some(&mut stencil));
    assert_eq!((stencil, cx.get_error()), ([3, 3], GL_NO_ERROR));
}

#[test]
fn what_a_texture_was_drawn_to_is_sampled_read_and_copied() {
    let mut cx = context();
    let name = texture(&mut cx, GL_RGBA8, 2, 2);
    framebuffer(&mut cx);
    cx.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, name, 0);
    fill(&mut cx, [0, 0, 2, 1], RED);
    fill(&mut cx, [0, 1, 1, 1], GREEN);
    assert_eq!(level(&mut cx, GL_TEXTURE_2D, 0, 4), [R, R, G, O]);
    cx.bind_framebuffer(FB, 0);
    cx.viewport(0, 0, 2, 2);
    cx.enable(GL_TEXTURE_2D);
    cx.tex_envf_replace();
    let draw = |cx: &mut Context| {
        cx.begin(GL_QUADS);
        for (x, y) in [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0), (0.0, 1.0)] {
            cx.tex_coord(x, y, 0.0, 1.0);
            cx.vertex(x * 2.0 - 1.0, y * 2.0 - 1.0, 0.0, 1.0);
        }
        cx.end();
    };
    draw(&mut cx);
    assert_eq!(pixels(&mut cx, 2, 2), [R, R, G, O]);
    // Drawn again, sampled again.
    let fbo = 1;
    cx.bind_framebuffer(FB, fbo);
    fill(&mut cx, [1, 0, 1, 1], GREEN);
    cx.bind_framebuffer(FB, 0);
    draw(&mut cx);
    assert_eq!(pixels(&mut cx, 2, 2), [R, G, G, O]);
    // A sub-image goes to the attached image.
    cx.tex_sub_image_2d(GL_TEXTURE_2D, 0, 1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Some(&[1, 2, 3, 4]));
    cx.bind_framebuffer(FB, fbo);
    assert_eq!(pixels(&mut cx, 2, 2), [R, G, G, [1, 2, 3, 4]]);
    cx.bind_framebuffer(GL_DRAW_FRAMEBUFFER, 0);
    cx.disable(GL_TEXTURE_2D);
    cx.window_pos(4.0, 4.0, 0.0);
    cx.copy_pixels(0, 0, 2, 2, GL_COLOR);
    cx.copy_tex_sub_image_2d(GL_TEXTURE_2D, 0, 0, 0, 1, 1, 1, 1);
    assert_eq!(level(&mut cx, GL_TEXTURE_2D, 0, 4)[0], [1, 2, 3, 4]);
    cx.bind_framebuffer(GL_READ_FRAMEBUFFER, 0);
    assert_eq!(pixels(&mut cx, 8, 6)[8 * 5 + 5], [1, 2, 3, 4]);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

trait Replace {
    fn tex_envf_replace(&mut self);
}

impl Replace for Context {
    fn tex_envf_replace(&mut self) {
        self.tex_env(GL_TEXTURE_ENV, GL_TEXTURE_ENV_MODE, &[GL_REPLACE as f32]);
    }
}

#[test]
fn faces_levels_and_layers_are_images_of_their_own() {
    let mut cx = context();
    framebuffer(&mut cx);
    cx.bind_texture(GL_TEXTURE_CUBE_MAP, 21);
    for face in 0..6 {
        cx.tex_image_2d(GL_TEXTURE_CUBE_MAP_POSITIVE_X + face, 0, GL_RGBA8 as i32, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, None);
    }
    cx.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 21, 0);
    fill(&mut cx, [0, 0, 1, 1], RED);
    assert_eq!(level(&mut cx, GL_TEXTURE_CUBE_MAP_NEGATIVE_Y, 0, 1), [R]);
    assert_eq!(level(&mut cx, GL_TEXTURE_CUBE_MAP_POSITIVE_Y, 0, 1), [O]);
    cx.bind_texture(GL_TEXTURE_3D, 22);
    cx.tex_image_3d(GL_TEXTURE_3D, 0, GL_RGBA8 as i32, 1, 1, 3, 0, GL_RGBA, GL_UNSIGNED_BYTE, None);
    cx.framebuffer_texture_3d(FB, COLOR0, GL_TEXTURE_3D, 22, 0, 1);
    fill(&mut cx, [0, 0, 1, 1], GREEN);
    cx.framebuffer_texture_layer(FB, COLOR0, 22, 0, 2);
    fill(&mut cx, [0, 0, 1, 1], RED);
    assert_eq!(level(&mut cx, GL_TEXTURE_3D, 0, 3), [O, G, R]);
    cx.bind_texture(GL_TEXTURE_1D, 23);
    cx.tex_image_1d(GL_TEXTURE_1D, 0, GL_RGBA8 as i32, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, None);
    cx.tex_image_1d(GL_TEXTURE_1D, 1, GL_RGBA8 as i32, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, None);
    cx.framebuffer_texture_1d(FB, COLOR0, GL_TEXTURE_1D, 23, 1);
    fill(&mut cx, [1, 0, 9, 9], GREEN);
    assert_eq!(level(&mut cx, GL_TEXTURE_1D, 1, 2), [O, G]);
    assert_eq!(level(&mut cx, GL_TEXTURE_1D, 0, 4), [O; 4]);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn formats_keep_what_they_keep() {
    let mut cx = context();
    framebuffer(&mut cx);
    let color = [0.2, 0.4, 0.6, 0.8];
    for (format, texel, read) in [
        (GL_RGBA8, [51, 102, 153, 204], [51, 102, 153, 204]),
        (GL_RGB8, [51, 102, 153, 255], [51, 102, 153, 255]),
        (GL_RGBA4, [51, 102, 153, 204], [51, 102, 153, 204]),
        (GL_RGBA16, [51, 102, 153, 204], [51, 102, 153, 204]),
        (GL_RGB16, [51, 102, 153, 255], [51, 102, 153, 255]),
        (GL_ALPHA8, [0, 0, 0, 204], [0, 0, 0, 204]),
        // Luminance is read in red alone.
        (GL_LUMINANCE8, [51, 0, 0, 255], [51, 0, 0, 255]),
        (GL_LUMINANCE8_ALPHA8, [51, 0, 0, 204], [51, 0, 0, 204]),
        (GL_INTENSITY8, [51, 0, 0, 255], [51, 0, 0, 255]),
        // As OSMesa's.
        (GL_RGB5, [49, 99, 156, 255], [49, 99, 156, 255]),
        (GL_R3_G3_B2, [36, 109, 170, 255], [36, 109, 170, 255]),
        (GL_RGB10_A2, [51, 102, 153, 170], [51, 102, 153, 170]),
    ] {
        let name = texture(&mut cx, format, 1, 1);
        cx.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, name, 0);
        fill(&mut cx, [0, 0, 1, 1], color);
        assert_eq!(pixels(&mut cx, 1, 1)[0], read, "{format:#x}");
        assert_eq!(level(&mut cx, GL_TEXTURE_2D, 0, 1)[0], texel, "{format:#x}");
    }
}

#[test]
fn every_draw_buffer_gets_the_colour_and_depth_counts_once() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 2, 2);
    attach(&mut cx, COLOR0 + 1, 0, GL_RGB8, 2, 2);
    attach(&mut cx, COLOR0 + 2, 0, GL_RGBA16, 2, 2);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_DEPTH_COMPONENT24, 2, 2);
    cx.clear(GL_DEPTH_BUFFER_BIT);
    cx.draw_buffers(2, &[COLOR0 + 1, COLOR0 + 2]);
    cx.viewport(0, 0, 2, 2);
    cx.enable(GL_DEPTH_TEST);
    rectangle(&mut cx, [-1.0, -1.0, 0.0, 1.0], [1.0, 0.0, 0.0, 0.0]);
    // As deep: fails against the first one, in every buffer.
    rectangle(&mut cx, [-1.0, -1.0, 0.0, 1.0], [0.0, 1.0, 0.0, 0.0]);
    assert_eq!(pixels(&mut cx, 2, 2), [O; 4]);
    cx.read_buffer(COLOR0 + 1);
    assert_eq!(pixels(&mut cx, 2, 1), [R, [0, 0, 0, 255]]);
    cx.read_buffer(COLOR0 + 2);
    assert_eq!(pixels(&mut cx, 2, 1), [[255, 0, 0, 0], O]);
    // Pixel rectangles too.
    cx.disable(GL_DEPTH_TEST);
    cx.window_pos(1.0, 0.0, 0.0);
    cx.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Some(&[1, 2, 3, 4]));
    assert_eq!(pixels(&mut cx, 2, 1)[1], [1, 2, 3, 4]);
    cx.read_buffer(COLOR0 + 1);
    assert_eq!(pixels(&mut cx, 2, 1)[1], [1, 2, 3, 255]);
}

#[test]
fn depth_alone_can_be_drawn_to() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_DEPTH_COMPONENT24, 2, 1);
    cx.draw_buffer(GL_NONE);
    cx.read_buffer(GL_NONE);
    cx.viewport(0, 0, 2, 1);
    cx.clear(GL_DEPTH_BUFFER_BIT);
    cx.enable(GL_DEPTH_TEST);
    rectangle(&mut cx, [-1.0, -1.0, 0.0, 1.0], RED);
    let mut out = [0; 8];
    cx.read_pixels(0, 0, 2, 1, GL_DEPTH_COMPONENT, GL_FLOAT, Some(&mut out));
    let depths = [0, 4].map(|k| f32::from_ne_bytes([out[k], out[k + 1], out[k + 2], out[k + 3]]));
    assert!((depths[0] - 0.5).abs() < 1e-6 && depths[1] == 1.0, "{depths:?}");
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn the_smallest_image_limits_the_drawing() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 3, 1);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 0, GL_DEPTH_COMPONENT24, 2, 3);
    cx.clear(GL_DEPTH_BUFFER_BIT);
    cx.enable(GL_DEPTH_TEST);
    cx.viewport(0, 0, 3, 1);
    rectangle(&mut cx, [-1.0, -1.0, 1.0, 1.0], RED);
    assert_eq!(pixels(&mut cx, 3, 1), [R, R, O]);
    fill(&mut cx, [0, 0, 9, 9], GREEN);
    assert_eq!(pixels(&mut cx, 3, 1), [G, G, O]);
}

#[test]
fn mipmaps_are_made_of_what_was_drawn() {
    let mut cx = context();
    framebuffer(&mut cx);
    let name = texture(&mut cx, GL_RGBA8, 4, 2);
    cx.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, name, 0);
    fill(&mut cx, [0, 0, 2, 2], RED);
    cx.generate_mipmap(GL_TEXTURE_2D);
    assert_eq!(level(&mut cx, GL_TEXTURE_2D, 1, 2), [R, O]);
    assert_eq!(level(&mut cx, GL_TEXTURE_2D, 2, 1), [[128, 0, 0, 128]]);
    cx.framebuffer_texture_2d(FB, COLOR0, GL_TEXTURE_2D, name, 1);
    fill(&mut cx, [0, 0, 2, 2], GREEN);
    assert_eq!(level(&mut cx, GL_TEXTURE_2D, 1, 2), [G, G]);
    cx.generate_mipmap(GL_TEXTURE_2D);
    assert_eq!(pixels(&mut cx, 2, 1), [R, O], "the attached level was made anew");
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn samples_are_resolved_by_a_blit() {
    let mut cx = context();
    let many = framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 4, GL_RGBA8, 4, 4);
    attach(&mut cx, GL_DEPTH_ATTACHMENT, 4, GL_DEPTH_COMPONENT24, 4, 4);
    cx.viewport(0, 0, 4, 4);
    cx.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    // Three and a half columns.
    rectangle(&mut cx, [-1.0, -1.0, 0.75, 1.0], RED);
    let one = framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 4, 4);
    cx.bind_framebuffer(GL_READ_FRAMEBUFFER, many);
    cx.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    cx.bind_framebuffer(FB, one);
    assert_eq!(pixels(&mut cx, 4, 1), [R, R, R, [128, 0, 0, 128]]);
    // Without multisampling the pixel's centre decides; it lies on the right edge.
    cx.bind_framebuffer(FB, many);
    cx.disable(GL_MULTISAMPLE);
    cx.clear(GL_COLOR_BUFFER_BIT);
    rectangle(&mut cx, [-1.0, -1.0, 0.75, 1.0], RED);
    cx.bind_framebuffer(GL_DRAW_FRAMEBUFFER, one);
    cx.blit_framebuffer(0, 0, 4, 4, 0, 0, 4, 4, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    cx.bind_framebuffer(FB, one);
    assert_eq!(pixels(&mut cx, 4, 1)[2], R);
    assert!(pixels(&mut cx, 4, 1)[3] == O || pixels(&mut cx, 4, 1)[3] == R);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn depth_textures_are_drawn_to_sampled_and_read() {
    let mut cx = context();
    framebuffer(&mut cx);
    attach(&mut cx, COLOR0, 0, GL_RGBA8, 2, 1);
    let name = texture(&mut cx, GL_RGBA8, 2, 1);
    for (format, bits, stencil) in [(GL_DEPTH_COMPONENT16, 16, 0), (GL_DEPTH_COMPONENT24, 24, 0), (GL_DEPTH24_STENCIL8, 24, 8)] {
        let (client, ty) = if stencil > 0 { (GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8) } else { (GL_DEPTH_COMPONENT, GL_FLOAT) };
        cx.tex_image_2d(GL_TEXTURE_2D, 0, format as i32, 2, 1, 0, client, ty, None);
        assert_eq!(cx.get_tex_level_parameter(GL_TEXTURE_2D, 0, GL_TEXTURE_DEPTH_SIZE), Some(bits));
        assert_eq!(cx.get_tex_level_parameter(GL_TEXTURE_2D, 0, GL_TEXTURE_STENCIL_SIZE), Some(stencil));
        let point = if stencil > 0 { GL_DEPTH_STENCIL_ATTACHMENT } else { GL_DEPTH_ATTACHMENT };
        cx.framebuffer_texture_2d(FB, point, GL_TEXTURE_2D, name, 0);
        assert_eq!(status(&mut cx), GL_FRAMEBUFFER_COMPLETE);
        cx.clear_depth(0.25);
        cx.clear_stencil(9);
        cx.clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
        let mut out = [0; 8];
        cx.get_tex_image(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, Some(&mut out));
        let depth = f32::from_ne_bytes([out[4], out[5], out[6], out[7]]);
        assert!((depth - 0.25).abs() < 1e-4, "{depth}");
        if stencil > 0 {
            cx.get_tex_image(GL_TEXTURE_2D, 0, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, Some(&mut out));
            assert_eq!(out[0], 9);
        }
        cx.framebuffer_texture_2d(FB, point, GL_TEXTURE_2D, 0, 0);
        cx.bind_framebuffer(FB, 0);
        cx.enable(GL_TEXTURE_2D);
        cx.tex_envf_replace();
        cx.viewport(0, 0, 2, 1);
        for (mode, color) in [(GL_LUMINANCE, [64, 64, 64, 255]), (GL_INTENSITY, [64; 4]), (GL_ALPHA, [255, 0, 0, 64])] {
            cx.tex_parameteri(GL_TEXTURE_2D, GL_DEPTH_TEXTURE_MODE, mode as i32);
            rectangle(&mut cx, [-1.0, -1.0, 1.0, 1.0], RED);
            assert_eq!(pixels(&mut cx, 1, 1)[0], color, "{format:#x} {mode:#x}");
        }
        cx.disable(GL_TEXTURE_2D);
        // Copied from the window.
        cx.clear_depth(0.75);
        cx.clear(GL_DEPTH_BUFFER_BIT);
        cx.copy_tex_image_2d(GL_TEXTURE_2D, 0, format, 0, 0, 2, 1, 0);
        cx.get_tex_image(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_UNSIGNED_BYTE, Some(&mut out));
        assert_eq!((out[0], out[1]), (191, 191));
        cx.bind_framebuffer(FB, 1);
    }
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn depth_with_stencil_is_read_and_drawn_as_one() {
    let mut cx = context();
    cx.clear_stencil(5);
    cx.clear_depth(1.0);
    cx.clear(GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    let mut out = [0; 4];
    let read = |cx: &mut Context, x, out: &mut [u8; 4]| {
        cx.read_pixels(x, 0, 1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, Some(out));
        u32::from_ne_bytes(*out)
    };
    assert_eq!(read(&mut cx, 0, &mut out), 0xffff_ff05);
    cx.window_pos(1.0, 0.0, 0.0);
    cx.draw_pixels(1, 1, GL_DEPTH_STENCIL, GL_UNSIGNED_INT_24_8, Some(&0x1234_5678u32.to_ne_bytes()));
    assert_eq!(read(&mut cx, 1, &mut out), 0x1234_5678);
    assert_eq!(error_of(&mut cx, |c| c.read_pixels(0, 0, 1, 1, GL_DEPTH_STENCIL, GL_FLOAT, None)), GL_INVALID_ENUM);
    assert_eq!(error_of(&mut cx, |c| c.read_pixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_INT_24_8, None)), GL_INVALID_OPERATION);
}

#[test]
fn images_too_large_for_the_gpu_are_drawn_by_the_cpu() {
    // Room for 64 x 64 pixels, or for 32 x 32 of four samples.
    let Ok(gpu) = GpuDevice::with(|config| config.plane_limit = 64 * 64 * 16) else { return };
    let devices: [Arc<dyn Device>; 2] = [Arc::new(CpuDevice::new()), Arc::new(gpu)];
    let [cpu, gpu] = devices.map(|device| {
        let mut cx = context();
        cx.device = device;
        let [resolved, drawn] = [framebuffer(&mut cx), framebuffer(&mut cx)];
        let sizes = [[64, 64], [65, 64], [32, 32], [100, 3]];
        let mut pictures = Vec::new();
        // From one kind to the other and back, and each again.
        for (k, &[w, h]) in sizes.iter().chain(&sizes).enumerate() {
            for samples in [0, 4] {
                attach(&mut cx, COLOR0, samples, GL_RGBA8, w, h);
                let depth = renderbuffer(&mut cx, samples, GL_DEPTH24_STENCIL8, w, h);
                cx.framebuffer_renderbuffer(FB, GL_DEPTH_STENCIL_ATTACHMENT, RB, depth);
                cx.viewport(0, 0, w, h);
                cx.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
                cx.enable(GL_DEPTH_TEST);
                cx.color(0.1 * k as f32, 1.0, 0.5, 1.0);
                cx.begin(GL_TRIANGLES);
                for [x, y, z] in [[-0.9, -0.8, 0.3], [0.7, -0.2, -0.5], [-0.1, 0.9, 0.9]] {
                    cx.vertex(x, y, z, 1.0);
                }
                cx.end();
                rectangle(&mut cx, [-0.5, -0.5, 0.9, 0.2], RED);
                if samples == 0 {
                    pictures.push(pixels(&mut cx, w, h));
                    continue;
                }
                // Resolved into an image of one sample, which may be of the other kind.
                cx.bind_framebuffer(FB, resolved);
                attach(&mut cx, COLOR0, 0, GL_RGBA8, w, h);
                cx.bind_framebuffer(GL_READ_FRAMEBUFFER, drawn);
                cx.blit_framebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT, GL_NEAREST);
                cx.bind_framebuffer(FB, resolved);
                pictures.push(pixels(&mut cx, w, h));
                cx.bind_framebuffer(FB, drawn);
            }
        }
        assert_eq!(cx.get_error(), GL_NO_ERROR);
        pictures
    });
    assert!(cpu.iter().all(|picture| picture.iter().any(|p| *p != O)));
    assert_eq!(cpu, gpu);
}
