//! Capabilities.

use super::*;

const ON_AT_FIRST: [GLenum; 2] = [GL_DITHER, GL_MULTISAMPLE];

fn all() -> impl Iterator<Item = GLenum> {
    [
        GL_ALPHA_TEST,
        GL_AUTO_NORMAL,
        GL_BLEND,
        GL_COLOR_LOGIC_OP,
        GL_COLOR_MATERIAL,
        GL_COLOR_SUM,
        GL_CULL_FACE,
        GL_DEPTH_TEST,
        GL_DITHER,
        GL_FOG,
        GL_INDEX_LOGIC_OP,
        GL_LIGHTING,
        GL_LINE_SMOOTH,
        GL_LINE_STIPPLE,
        GL_MULTISAMPLE,
        GL_NORMALIZE,
        GL_POINT_SMOOTH,
        GL_POINT_SPRITE,
        GL_POLYGON_OFFSET_FILL,
        GL_POLYGON_OFFSET_LINE,
        GL_POLYGON_OFFSET_POINT,
        GL_POLYGON_SMOOTH,
        GL_POLYGON_STIPPLE,
        GL_RESCALE_NORMAL,
        GL_SAMPLE_ALPHA_TO_COVERAGE,
        GL_SAMPLE_ALPHA_TO_ONE,
        GL_SAMPLE_COVERAGE,
        GL_SCISSOR_TEST,
        GL_STENCIL_TEST,
        GL_TEXTURE_1D,
        GL_TEXTURE_2D,
        GL_TEXTURE_3D,
        GL_TEXTURE_CUBE_MAP,
    ]
    .into_iter()
    .chain(GL_TEXTURE_GEN_S..=GL_TEXTURE_GEN_Q)
    .chain(GL_LIGHT0..=GL_LIGHT7)
    .chain(GL_CLIP_PLANE0..GL_CLIP_PLANE0 + 8)
    .chain(GL_MAP1_COLOR_4..=GL_MAP1_VERTEX_4)
    .chain(GL_MAP2_COLOR_4..=GL_MAP2_VERTEX_4)
}

#[test]
fn each_capability_is_its_own() {
    let mut cx = context();
    for cap in all() {
        let at_first = ON_AT_FIRST.contains(&cap);
        assert_eq!(cx.is_enabled(cap), at_first, "{cap:#x}");
        if at_first {
            cx.disable(cap)
        } else {
            cx.enable(cap)
        }
        for other in all() {
            assert_eq!(cx.is_enabled(other), ON_AT_FIRST.contains(&other) != (other == cap), "{other:#x} after {cap:#x}");
        }
        assert_eq!(get(&mut cx, cap), [!at_first as u8 as f64]);
        if at_first { cx.enable(cap) } else { cx.disable(cap) }
    }
    assert_eq!(cx.get_error(), GL_NO_ERROR);
}

#[test]
fn what_is_no_capability_is_an_invalid_enum() {
    let mut cx = context();
    for cap in [0, GL_POINTS + 1, GL_LIGHT0 + 8, GL_CLIP_PLANE0 + 8, GL_MAP1_VERTEX_4 + 1, GL_VIEWPORT, !0] {
        assert_eq!(error_of(&mut cx, |cx| cx.enable(cap)), GL_INVALID_ENUM);
        assert_eq!(error_of(&mut cx, |cx| cx.disable(cap)), GL_INVALID_ENUM);
        assert_eq!(error_of(&mut cx, |cx| assert!(!cx.is_enabled(cap))), GL_INVALID_ENUM);
    }
}

#[test]
fn texture_enables_belong_to_the_active_unit() {
    let mut cx = context();
    cx.active_texture(GL_TEXTURE3);
    cx.enable(GL_TEXTURE_2D);
    cx.enable(GL_TEXTURE_GEN_T);
    cx.active_texture(GL_TEXTURE0);
    assert!(!cx.is_enabled(GL_TEXTURE_2D) && !cx.is_enabled(GL_TEXTURE_GEN_T));
    cx.active_texture(GL_TEXTURE3);
    assert!(cx.is_enabled(GL_TEXTURE_2D) && cx.is_enabled(GL_TEXTURE_GEN_T));
}
