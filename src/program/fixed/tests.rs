//! Random keys make programs that validate and that the CPU can run.

use proptest::prelude::*;

use super::*;
use crate::program::lanes;

fn tex_coord() -> impl Strategy<Value = TexCoordKey> {
    let generate = prop_oneof![
        Just(Generate::None),
        Just(Generate::ObjectLinear),
        Just(Generate::EyeLinear),
        Just(Generate::SphereMap),
        Just(Generate::ReflectionMap),
        Just(Generate::NormalMap),
    ];
    (any::<bool>(), any::<bool>(), proptest::array::uniform4(generate)).prop_map(|(used, matrix, generate)| TexCoordKey {
        used,
        matrix,
        generate,
    })
}

fn lighting() -> impl Strategy<Value = LightingKey> {
    (any::<[bool; 5]>(), proptest::array::uniform8(0u8..16), proptest::array::uniform2(0u8..16)).prop_map(
        |([enabled, two_side, local_viewer, separate_specular, specular], lights, color_material)| LightingKey {
            enabled,
            // Attenuation belongs to positional lights.
            lights: lights.map(|l| if l & light::POSITIONAL == 0 { l & !light::ATTENUATED } else { l }),
            color_material,
            two_side,
            local_viewer,
            separate_specular,
            specular,
        },
    )
}

fn vertex_key() -> impl Strategy<Value = VertexKey> {
    let normal = prop_oneof![Just(Normal::Keep), Just(Normal::Rescale), Just(Normal::Normalize)];
    let fog = prop_oneof![Just(FogCoord::None), Just(FogCoord::EyeZ), Just(FogCoord::Attribute)];
    (any::<[bool; 6]>(), lighting(), normal, proptest::collection::vec(tex_coord(), 8), fog, 0u8..=8).prop_map(
        |(
            [color, secondary, eye, point_attenuation, planes_in_clip_space, point_distance_along_z],
            lighting,
            normal,
            units,
            fog,
            clip_planes,
        )| VertexKey {
            color,
            secondary,
            lighting,
            normal,
            units: std::array::from_fn(|k| units[k]),
            fog,
            eye,
            clip_planes,
            planes_in_clip_space,
            point_attenuation,
            point_distance_along_z,
        },
    )
}

fn combine() -> impl Strategy<Value = Combine> {
    let function = prop_oneof![
        Just(Function::Replace),
        Just(Function::Modulate),
        Just(Function::Add),
        Just(Function::AddSigned),
        Just(Function::Interpolate),
        Just(Function::Subtract),
        Just(Function::Dot3Rgb),
        Just(Function::Dot3Rgba),
    ];
    let source = prop_oneof![
        Just(CombineSource::Texture),
        Just(CombineSource::Constant),
        Just(CombineSource::PrimaryColor),
        Just(CombineSource::Previous),
        (0u8..8).prop_map(CombineSource::Unit),
    ];
    let argument = (source, any::<bool>(), any::<bool>());
    let arguments = proptest::array::uniform2(proptest::array::uniform3(argument));
    (proptest::array::uniform2(function), arguments, proptest::array::uniform2(0u8..3)).prop_map(|(functions, arguments, shifts)| Combine {
        functions,
        arguments,
        shifts,
    })
}

fn unit() -> impl Strategy<Value = UnitKey> {
    let base = prop_oneof![
        Just(Base::Alpha),
        Just(Base::Luminance),
        Just(Base::LuminanceAlpha),
        Just(Base::Intensity),
        Just(Base::Rgb),
        Just(Base::Rgba),
    ];
    let mode = prop_oneof![
        Just(Mode::Replace),
        Just(Mode::Modulate),
        Just(Mode::Decal),
        Just(Mode::Blend),
        Just(Mode::Add),
        combine().prop_map(Mode::Combine),
    ];
    (any::<[bool; 3]>(), base, mode).prop_map(|([enabled, cube, lod], base, mode)| UnitKey { enabled, cube, lod, base, mode })
}

fn fragment_key() -> impl Strategy<Value = FragmentKey> {
    let fog = prop_oneof![Just(Fog::None), Just(Fog::Linear), Just(Fog::Exp), Just(Fog::Exp2)];
    let smooth = prop_oneof![Just(Smooth::None), Just(Smooth::Point), Just(Smooth::Disc), Just(Smooth::Line)];
    (any::<[bool; 3]>(), fog, smooth, proptest::collection::vec(unit(), 8)).prop_map(|([flat, two_side, color_sum], fog, smooth, units)| {
        FragmentKey { flat, two_side, color_sum, fog, smooth, units: std::array::from_fn(|k| units[k]), ..FragmentKey::default() }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(96))]

    #[test]
    fn every_vertex_key_makes_a_program_that_runs(key in vertex_key()) {
        // Generating validates; a text that does not validate panics.
        let fixed = vertex_program(&key);
        prop_assert!(lanes::compile(&fixed.program).is_ok());
        prop_assert_eq!(fixed.slots.len(), fixed.program.uniform_vec4 as usize);
        prop_assert!(std::ptr::eq(&*fixed, &*vertex_program(&key)));
    }

    #[test]
    fn every_fragment_key_makes_a_program_that_runs(key in fragment_key()) {
        let fixed = fragment_program(&key);
        prop_assert!(lanes::compile(&fixed.program).is_ok());
        let enabled = key.units.iter().filter(|u| u.enabled).count();
        prop_assert_eq!(fixed.program.texture_slots as usize, enabled);
    }
}

#[test]
fn a_plain_key_leaves_everything_out() {
    let vertex = vertex_program(&VertexKey { color: true, ..VertexKey::default() });
    assert_eq!(vertex.slots, [0, 1, 2, 3].map(Slot::Mvp));
    assert_eq!(vertex.program.attributes, 1 | 1 << 3);
    let fragment = fragment_program(&FragmentKey::default());
    assert!(fragment.slots.is_empty());
    assert_eq!(fragment.program.shortcut, crate::program::Shortcut::Varying(0));
}
