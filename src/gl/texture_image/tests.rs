use super::super::ContextConfig;
use super::*;

fn context() -> Context {
    let mut cx = Context::new(ContextConfig::default(), None);
    cx.state.texture.units[0].enabled[TextureKind::D2 as usize] = true;
    cx.bind_texture(GL_TEXTURE_2D, 1);
    cx
}

fn image(cx: &mut Context, level: i32, size: i32, format: GLenum) {
    let pixels = vec![100; (size * size * 4) as usize];
    cx.tex_image_2d(GL_TEXTURE_2D, level, format as i32, size, size, 0, GL_RGBA, GL_UNSIGNED_BYTE, Some(&pixels));
}

#[test]
fn a_texture_is_complete_when_all_levels_fit() {
    let mut cx = context();
    assert!(cx.texture_binding(0).is_none());
    image(&mut cx, 0, 4, GL_RGBA);
    // The initial filter wants mipmaps.
    assert!(cx.texture_binding(0).is_none());
    image(&mut cx, 1, 2, GL_RGBA);
    image(&mut cx, 2, 1, GL_RGB);
    assert!(cx.texture_binding(0).is_none(), "another internal format");
    image(&mut cx, 2, 1, GL_RGBA);
    let (binding, base) = cx.texture_binding(0).expect("complete");
    assert_eq!((binding.image.levels.len(), base), (3, GL_RGBA));
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 1);
    assert_eq!(cx.texture_binding(0).expect("complete").0.image.levels.len(), 2);
    image(&mut cx, 1, 3, GL_RGBA);
    assert!(cx.texture_binding(0).is_none(), "another size");
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR as i32);
    assert_eq!(cx.texture_binding(0).expect("no mipmaps wanted").0.image.levels.len(), 1);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn a_snapshot_is_shared_until_an_image_changes_and_is_never_changed() {
    let mut cx = context();
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
    image(&mut cx, 0, 2, GL_RGBA);
    let first = cx.texture_binding(0).unwrap().0.image;
    assert!(Arc::ptr_eq(&first, &cx.texture_binding(0).unwrap().0.image));
    cx.tex_sub_image_2d(GL_TEXTURE_2D, 0, 1, 1, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Some(&[1, 2, 3, 4]));
    let second = cx.texture_binding(0).unwrap().0.image;
    assert_ne!(first.id, second.id);
    assert_eq!(first.levels[0].texels[3].to_le_bytes(), [100; 4]);
    assert_eq!(second.levels[0].texels[3].to_le_bytes(), [1, 2, 3, 4]);
    assert_eq!(second.levels[0].texels[2].to_le_bytes(), [100; 4]);
}

#[test]
fn generated_mipmaps_make_a_texture_complete() {
    let mut cx = context();
    cx.tex_parameteri(GL_TEXTURE_2D, GL_GENERATE_MIPMAP, 1);
    let pixels: Vec<u8> = [0, 0, 0, 0, 255, 255, 255, 255].repeat(2);
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as i32, 2, 2, 0, GL_RGBA, GL_UNSIGNED_BYTE, Some(&pixels));
    let image = cx.texture_binding(0).expect("complete").0.image;
    assert_eq!(image.levels[1].texels[0].to_le_bytes(), [128; 4]);
}

#[test]
fn borders_are_cut_off() {
    let mut cx = context();
    let pixels: Vec<u8> = (0..16).flat_map(|i| [i, i, i, i]).collect();
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as i32, 4, 4, 1, GL_RGBA, GL_UNSIGNED_BYTE, Some(&pixels));
    let mut out = [0; 16];
    cx.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, Some(&mut out));
    assert_eq!(out, [5, 5, 5, 5, 6, 6, 6, 6, 9, 9, 9, 9, 10, 10, 10, 10]);
    assert_eq!(cx.get_tex_level_parameter(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH), Some(2));
    assert_eq!(cx.get_tex_level_parameter(GL_TEXTURE_2D, 0, GL_TEXTURE_BORDER), Some(0));
}

#[test]
fn proxies_answer_without_data_and_keep_errors_for_bad_arguments() {
    let mut cx = context();
    let width = |cx: &mut Context| cx.get_tex_level_parameter(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_WIDTH).unwrap();
    cx.tex_image_2d(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8 as i32, 64, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, None);
    assert_eq!(width(&mut cx), 64);
    assert_eq!(cx.get_tex_level_parameter(GL_PROXY_TEXTURE_2D, 0, GL_TEXTURE_RED_SIZE), Some(8));
    cx.tex_image_2d(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8 as i32, 32768, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, None);
    assert_eq!(width(&mut cx), 0);
    assert_eq!(cx.get_error(), GL_NO_ERROR);
    cx.tex_image_2d(GL_PROXY_TEXTURE_2D, 0, GL_RGBA8 as i32, -1, 64, 0, GL_RGBA, GL_UNSIGNED_BYTE, None);
    assert_eq!(cx.get_error(), GL_INVALID_VALUE);
}

#[test]
fn errors_are_those_of_the_specification() {
    let mut cx = context();
    let mut image = |target, level, internal: GLenum, width, height, border, format, ty| {
        cx.tex_image_2d(target, level, internal as i32, width, height, border, format, ty, None);
        cx.get_error()
    };
    let (target, byte) = (GL_TEXTURE_2D, GL_UNSIGNED_BYTE);
    assert_eq!(image(GL_TEXTURE_1D, 0, 4, 4, 4, 0, GL_RGBA, byte), GL_INVALID_ENUM);
    assert_eq!(image(target, -1, 4, 4, 4, 0, GL_RGBA, byte), GL_INVALID_VALUE);
    assert_eq!(image(target, 15, 4, 1, 1, 0, GL_RGBA, byte), GL_INVALID_VALUE);
    assert_eq!(image(target, 0, 5, 4, 4, 0, GL_RGBA, byte), GL_INVALID_VALUE);
    assert_eq!(image(target, 0, 4, 16385, 4, 0, GL_RGBA, byte), GL_INVALID_VALUE);
    assert_eq!(image(target, 0, 4, 4, 4, 2, GL_RGBA, byte), GL_INVALID_VALUE);
    assert_eq!(image(target, 0, 4, 4, 4, 0, GL_RGBA8, byte), GL_INVALID_ENUM);
    assert_eq!(image(target, 0, 4, 4, 4, 0, GL_STENCIL_INDEX, byte), GL_INVALID_ENUM);
    assert_eq!(image(target, 0, 4, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE_3_3_2), GL_INVALID_OPERATION);
    assert_eq!(image(target, 0, 4, 4, 4, 0, GL_DEPTH_COMPONENT, byte), GL_INVALID_OPERATION);
    assert_eq!(image(target, 0, 4, 0, 0, 0, GL_RGBA, byte), GL_NO_ERROR);
    cx.tex_image_2d(target, 0, 4, 4, 4, 0, GL_RGBA, byte, None);
    let mut sub = |level, x, width| {
        cx.tex_sub_image_2d(target, level, x, 0, width, 1, GL_RGBA, byte, None);
        cx.get_error()
    };
    assert_eq!(sub(0, 3, 1), GL_NO_ERROR);
    assert_eq!(sub(0, 3, 2), GL_INVALID_VALUE);
    assert_eq!(sub(0, -1, 2), GL_INVALID_VALUE);
    assert_eq!(sub(1, 0, 1), GL_INVALID_OPERATION);
}

#[test]
fn names_bindings_and_deletion() {
    let mut cx = context();
    let names = cx.gen_textures(2);
    assert!(names[0] != names[1] && !names.contains(&0) && !names.contains(&1));
    assert!(!cx.is_texture(names[0]));
    cx.bind_texture(GL_TEXTURE_1D, names[0]);
    assert!(cx.is_texture(names[0]));
    cx.bind_texture(GL_TEXTURE_2D, names[0]);
    assert_eq!(cx.get_error(), GL_INVALID_OPERATION);
    assert_eq!(cx.are_textures_resident(2, &names), None);
    assert_eq!(cx.get_error(), GL_INVALID_VALUE);
    cx.delete_textures(2, &names);
    assert_eq!(cx.state.texture.units[0].bound[TextureKind::D1 as usize], 0);
    assert!(!cx.is_texture(names[0]));
}

#[test]
fn transfer_applies_to_textures() {
    let mut cx = context();
    cx.pixel_transferf(GL_RED_BIAS, 1.0);
    cx.pixel_transferf(GL_GREEN_SCALE, 0.5);
    image(&mut cx, 0, 1, GL_RGBA);
    cx.pixel_transferf(GL_RED_BIAS, 0.0);
    cx.pixel_transferf(GL_GREEN_SCALE, 1.0);
    let mut out = [0; 4];
    cx.get_tex_image(GL_TEXTURE_2D, 0, GL_RGBA, GL_UNSIGNED_BYTE, Some(&mut out));
    assert_eq!(out, [255, 50, 100, 100]);
}
