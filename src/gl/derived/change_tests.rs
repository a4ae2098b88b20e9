//! What is kept of the derived state from draw to draw is what deriving all of it anew would give.

use proptest::prelude::*;

use crate::draw::{Batch, Draw};
use crate::gl::enums::*;
use crate::gl::{Context, ContextConfig, dirty};
use crate::raster::layout::DrawRecord;

/// A command between draws: which one, with which of its parameters, to which value.
type Change = (u8, u8, u8);

const CAPABILITIES: [GLenum; 22] = [
    GL_LIGHTING,
    GL_LIGHT0,
    GL_LIGHT1,
    GL_COLOR_MATERIAL,
    GL_COLOR_SUM,
    GL_NORMALIZE,
    GL_RESCALE_NORMAL,
    GL_FOG,
    GL_BLEND,
    GL_DEPTH_TEST,
    GL_STENCIL_TEST,
    GL_ALPHA_TEST,
    GL_COLOR_LOGIC_OP,
    GL_CULL_FACE,
    GL_SCISSOR_TEST,
    GL_POLYGON_STIPPLE,
    GL_LINE_STIPPLE,
    GL_CLIP_PLANE0,
    GL_CLIP_PLANE3,
    GL_TEXTURE_2D,
    GL_TEXTURE_GEN_S,
    GL_TEXTURE_GEN_T,
];

/// Few values, zero and one among them, so that the same ones come again.
fn number(value: u8) -> f32 {
    [0.0, 1.0, 0.5, 0.25, 2.0][value as usize % 5]
}

fn pick<T: Copy>(of: &[T], which: u8) -> T {
    of[which as usize % of.len()]
}

fn change(cx: &mut Context, (command, which, value): Change) {
    let v = number(value);
    let vector = [v, 0.5, number(value / 5), number(which)];
    let light = GL_LIGHT0 + u32::from(which & 1);
    match command % 24 {
        0..=3 if value & 1 == 0 => cx.enable(pick(&CAPABILITIES, which)),
        0..=3 => cx.disable(pick(&CAPABILITIES, which)),
        4 | 5 => cx.light_model(GL_LIGHT_MODEL_AMBIENT, &vector),
        6 => cx.light_model(pick(&[GL_LIGHT_MODEL_LOCAL_VIEWER, GL_LIGHT_MODEL_TWO_SIDE], which), &[v]),
        7 => cx.light(light, pick(&[GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_POSITION, GL_SPOT_DIRECTION], which / 2), &vector),
        8 => cx.light(light, pick(&[GL_SPOT_EXPONENT, GL_CONSTANT_ATTENUATION, GL_LINEAR_ATTENUATION], which / 2), &[v]),
        9 => cx.light(light, GL_SPOT_CUTOFF, &[if which & 2 == 0 { 180.0 } else { 30.0 + v }]),
        10 => {
            let face = pick(&[GL_FRONT, GL_BACK, GL_FRONT_AND_BACK], value);
            cx.material(face, pick(&[GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_SHININESS], which), &vector);
        }
        11 => cx.color_material(pick(&[GL_FRONT, GL_BACK, GL_FRONT_AND_BACK], value), pick(&[GL_SPECULAR, GL_AMBIENT, GL_EMISSION], which)),
        12 => cx.color(vector[0], vector[1], vector[2], vector[3]),
        13 => cx.translate(v, 0.25, 0.0),
        14 => {
            cx.matrix_mode(pick(&[GL_MODELVIEW, GL_PROJECTION, GL_TEXTURE], which));
            cx.load_identity();
            cx.scale(1.0, 1.0 + v, 1.0);
            cx.matrix_mode(GL_MODELVIEW);
        }
        15 => cx.fog(pick(&[GL_FOG_COLOR, GL_FOG_DENSITY, GL_FOG_START, GL_FOG_END], which), &vector),
        16 => cx.clip_plane(GL_CLIP_PLANE0 + u32::from(which & 3), vector.map(f64::from)),
        17 => cx.tex_env(GL_TEXTURE_ENV, GL_TEXTURE_ENV_COLOR, &vector),
        18 => cx.tex_gen(GL_S + u32::from(which & 1), pick(&[GL_OBJECT_PLANE, GL_EYE_PLANE], which / 2), &vector),
        19 => cx.viewport(0, 0, 32 + i32::from(value & 1), 32),
        20 => cx.point_size(1.0 + v),
        21 => cx.push_attrib(pick(&[GL_LIGHTING_BIT, GL_ENABLE_BIT, GL_TRANSFORM_BIT, GL_ALL_ATTRIB_BITS], which)),
        22 => cx.pop_attrib(),
        // Shades a vertex on the host, with a recorder of its own; draws a rectangle with a state of its own.
        _ if which & 1 == 0 => cx.raster_pos(v, 0.5, 0.0, 1.0),
        _ => cx.draw_pixels(1, 1, GL_RGBA, GL_UNSIGNED_BYTE, Some(&[value; 4])),
    }
}

fn context() -> Context {
    let mut cx = Context::new(ContextConfig::default(), None);
    cx.attach_window(64, 64);
    let texels = [0x80u8; 4 * 4 * 4];
    cx.tex_image_2d(GL_TEXTURE_2D, 0, GL_RGBA as i32, 4, 4, 0, GL_RGBA, GL_UNSIGNED_BYTE, Some(&texels));
    cx.tex_parameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST as i32);
    cx
}

/// Two triangles from arrays, or a primitive between Begin and End.
fn draw(cx: &mut Context, shape: u8) {
    const CORNERS: [[f32; 3]; 4] = [[-0.5, -0.5, 0.0], [0.5, -0.5, 0.1], [0.5, 0.5, 0.2], [-0.5, 0.5, 0.3]];
    const INDICES: [u8; 6] = [0, 1, 2, 0, 2, 3];
    if shape & 1 == 0 {
        // SAFETY: the vertices and indices are constants.
        unsafe {
            cx.vertex_pointer(3, GL_FLOAT, 0, CORNERS.as_ptr().cast());
            cx.enable_client_state(GL_VERTEX_ARRAY);
            cx.draw_elements(GL_TRIANGLES, 6, GL_UNSIGNED_BYTE, INDICES.as_ptr().cast());
        }
    } else {
        cx.begin(pick(&[GL_POINTS, GL_LINES, GL_TRIANGLES, GL_QUADS], shape / 2));
        CORNERS.iter().for_each(|[x, y, z]| cx.vertex(*x, *y, *z, 1.0));
        cx.end();
    }
}

/// All that a batch says, as bytes; images by their number.
fn content(batch: &Batch) -> (Vec<(u64, u64, u32, Vec<u8>)>, [Vec<u8>; 6], usize) {
    let draw = |d: &Draw| (d.vertex_program.id, d.fragment_program.id, d.first_primitive, bytemuck::bytes_of(&d.record).to_vec());
    let tables = [
        bytemuck::cast_slice(&batch.vertices).to_vec(),
        bytemuck::cast_slice(&batch.primitives).to_vec(),
        bytemuck::cast_slice(&batch.uniforms).to_vec(),
        bytemuck::cast_slice(&batch.raster_states).to_vec(),
        bytemuck::cast_slice(&batch.fragment_states).to_vec(),
        bytemuck::cast_slice(&batch.polygon_stipples).to_vec(),
    ];
    (batch.draws.iter().map(draw).collect(), tables, batch.textures.len())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(256))]

    #[test]
    fn what_is_kept_is_what_would_be_derived_anew(
        draws in proptest::collection::vec((proptest::collection::vec(any::<Change>(), 0..4), any::<u8>()), 1..40),
    ) {
        let (mut keeping, mut forgetting) = (context(), context());
        for (changes, shape) in draws {
            for cx in [&mut keeping, &mut forgetting] {
                changes.iter().for_each(|&c| change(cx, c));
                if cx.state.lighting.color_material {
                    // Values that follow the colour are brought up to date now and then. They are in the block, but nothing reads them.
                    cx.sync_color_material();
                    cx.dirty |= dirty::LIGHT_VALUES;
                }
            }
            draw(&mut keeping, shape);
            (forgetting.derived, forgetting.dirty) = (Some(Box::default()), dirty::ALL);
            draw(&mut forgetting, shape);
        }
        let [kept, derived] = [keeping, forgetting].map(|mut cx| content(&cx.recorder.take().unwrap_or_default()));
        prop_assert!(kept == derived);
    }
}

#[test]
fn a_state_that_is_switched_to_and_fro_is_recorded_once() {
    let mut cx = context();
    for k in 0..100 {
        if k & 1 == 0 {
            cx.enable(GL_BLEND)
        } else {
            cx.disable(GL_BLEND)
        }
        draw(&mut cx, 0);
    }
    let batch = cx.recorder.take().expect("draws");
    assert_eq!((batch.draws.len(), batch.fragment_states.len(), batch.raster_states.len()), (100, 2, 1));
    for pair in batch.draws.windows(3) {
        let place = |k: usize| DrawRecord { vertex_word: 0, shaded_base: 0, ..pair[k].record };
        assert_eq!(place(0), place(2));
        assert_ne!(pair[0].record.fragment_state, pair[1].record.fragment_state);
    }
}

#[test]
fn a_tint_changes_the_uniforms_of_a_draw_and_nothing_else() {
    let mut cx = context();
    cx.enable(GL_LIGHTING);
    for k in 0..64 {
        cx.light_model(GL_LIGHT_MODEL_AMBIENT, &[(k % 8) as f32 / 8.0, 0.0, 0.0, 1.0]);
        draw(&mut cx, 0);
    }
    let batch = cx.recorder.take().expect("draws");
    let record = |k: usize| DrawRecord { vertex_word: 0, shaded_base: 0, ..batch.draws[k].record };
    assert_eq!(batch.draws.len(), 64);
    for k in 0..56 {
        assert_eq!(record(k), record(k + 8), "equal blocks are one");
        let other = record(k + 1);
        assert_ne!(record(k).vertex_uniforms, other.vertex_uniforms);
        assert_eq!(record(k), DrawRecord { vertex_uniforms: record(k).vertex_uniforms, ..other });
    }
}
