//! Lighting and texture coordinate generation against a direct evaluation of the specification's equations in f64.

use glam::{DMat3, DVec3, Vec3, Vec4};
use proptest::prelude::*;

use crate::draw::recorder::Run;
use crate::gl::enums::*;
use crate::gl::state::{Light, Material};
use crate::gl::{Context, ContextConfig};
use crate::program::Output;
use crate::raster::layout::topology;

fn context() -> Context {
    Context::new(ContextConfig::default(), None)
}

/// An output of a vertex with position and normal.
fn shade(cx: &mut Context, position: [f32; 4], normal: [f32; 4], color: [f32; 4], output: Output) -> [f32; 4] {
    let data = [position, normal, color];
    let run = Run { mask: 1 | 1 << 2 | 1 << 3, data: &data, count: 1, edge_flags: None };
    let host = cx.shade_on_host(topology::POINTS, &run).expect("a vertex comes out");
    host.shaded(0)[host.index_of(output).expect("the output is written")]
}

/// Equation 2.4 for a face: primary and secondary colour.
fn reference(cx: &Context, eye: DVec3, normal: DVec3, color: [f32; 4], face: usize) -> [[f64; 4]; 2] {
    let s = &cx.state.lighting;
    let d3 = |c: &[f32; 4]| DVec3::new(c[0].into(), c[1].into(), c[2].into());
    let mut m: Material = s.materials[face].clone();
    let tracks_face = s.color_material_face == GL_FRONT_AND_BACK || (s.color_material_face == GL_BACK) == (face == 1);
    if s.color_material && tracks_face {
        match s.color_material_mode {
            GL_AMBIENT => m.ambient = color,
            GL_DIFFUSE => m.diffuse = color,
            GL_SPECULAR => m.specular = color,
            GL_EMISSION => m.emission = color,
            _ => (m.ambient, m.diffuse) = (color, color),
        }
    }
    let normal = if face == 1 { -normal } else { normal };
    let (mut sum, mut shine) = (d3(&m.emission) + d3(&m.ambient) * d3(&s.model_ambient), DVec3::ZERO);
    for light in s.lights.iter().filter(|l| l.enabled) {
        let p = light.position.as_dvec4();
        let to = if p.w == 0.0 { p.truncate() } else { p.truncate() / p.w - eye };
        let vp = to.normalize();
        let k = light.attenuation.map(f64::from);
        let attenuation = if p.w == 0.0 { 1.0 } else { 1.0 / (k[0] + k[1] * to.length() + k[2] * to.length_squared()) };
        let along = (-vp).dot(light.spot_direction.as_dvec3().normalize());
        let spot = match light.spot_cutoff {
            180.0 => 1.0,
            cutoff if along < f64::from(cutoff).to_radians().cos() => 0.0,
            _ => along.max(0.0).powf(light.spot_exponent.into()),
        };
        let view = if s.local_viewer { (-eye).normalize() } else { DVec3::Z };
        let half = (vp + view).normalize();
        let nl = normal.dot(vp).max(0.0);
        let power = if nl > 0.0 { normal.dot(half).max(0.0).powf(m.shininess.into()) } else { 0.0 };
        sum += attenuation * spot * (d3(&m.ambient) * d3(&light.ambient) + nl * d3(&m.diffuse) * d3(&light.diffuse));
        shine += attenuation * spot * power * d3(&m.specular) * d3(&light.specular);
    }
    if s.color_control != GL_SEPARATE_SPECULAR_COLOR {
        (sum, shine) = (sum + shine, DVec3::ZERO);
    }
    let clamp = |v: DVec3, a: f64| v.clamp(DVec3::ZERO, DVec3::ONE).extend(a).to_array();
    [clamp(sum, f64::from(m.diffuse[3]).clamp(0.0, 1.0)), clamp(shine, 1.0)]
}

prop_compose! {
    fn color()(c in proptest::array::uniform4(0.0f32..1.0)) -> [f32; 4] { c }
}

prop_compose! {
    fn a_light()(enabled in any::<bool>(), ambient in color(), diffuse in color(), specular in color(),
        p in proptest::array::uniform3(-3.0f32..3.0), w in prop_oneof![Just(0.0f32), Just(1.0), Just(2.0)],
        d in proptest::array::uniform3(-1.0f32..1.0), cutoff in prop_oneof![Just(180.0f32), 20.0f32..90.0],
        spot_exponent in 0.0f32..20.0, attenuation in prop_oneof![Just([1.0f32, 0.0, 0.0]), Just([0.5, 0.3, 0.1])]) -> Light {
        Light { enabled, ambient, diffuse, specular, position: Vec4::new(p[0], p[1], p[2] + 5.0, w),
            spot_direction: Vec3::new(d[0], d[1], -1.0), spot_exponent, spot_cutoff: cutoff, attenuation }
    }
}

prop_compose! {
    fn a_material()(ambient in color(), diffuse in color(), specular in color(), emission in color(),
        shininess in prop_oneof![Just(0.0f32), 0.0f32..128.0]) -> Material {
        Material { ambient, diffuse, specular, emission: emission.map(|e| e * 0.2), shininess, color_indexes: [0.0; 3] }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn lighting_is_the_equation(lights in proptest::collection::vec(a_light(), 8), front in a_material(), back in a_material(),
        flags in any::<[bool; 4]>(), mode in 0usize..5, face in 0usize..3,
        angle in -180.0f32..180.0, n in proptest::array::uniform3(0.1f32..1.0), color in color()) {
        let mut cx = context();
        let s = &mut cx.state.lighting;
        s.enabled = true;
        for (k, light) in lights.into_iter().enumerate() { s.lights[k] = light; }
        s.materials = [front, back];
        (s.local_viewer, s.two_side, s.color_material) = (flags[0], flags[1], flags[2]);
        s.color_control = if flags[3] { GL_SEPARATE_SPECULAR_COLOR } else { GL_SINGLE_COLOR };
        s.color_material_mode = [GL_AMBIENT, GL_DIFFUSE, GL_SPECULAR, GL_EMISSION, GL_AMBIENT_AND_DIFFUSE][mode];
        s.color_material_face = [GL_FRONT, GL_BACK, GL_FRONT_AND_BACK][face];
        cx.state.transform.normalize = true;
        cx.translate(0.5, -0.25, -3.0);
        cx.rotate(angle, 1.0, 2.0, 3.0);
        cx.scale(1.5, 1.0, 0.5);
        let position = [0.3, 0.2, -0.4, 1.0];
        let m = cx.modelview.top().as_dmat4();
        let eye = (m * Vec4::from(position).as_dvec4()).truncate();
        let upper = DMat3::from_cols(m.x_axis.truncate(), m.y_axis.truncate(), m.z_axis.truncate());
        let normal = (upper.inverse().transpose() * Vec3::from(n).as_dvec3()).normalize();
        let pairs = [(Output::FrontColor, 0, 0), (Output::FrontSecondary, 0, 1), (Output::BackColor, 1, 0), (Output::BackSecondary, 1, 1)];
        for (output, face, which) in pairs.into_iter().take(if flags[1] { 4 } else { 2 }) {
            let got = shade(&mut cx, position, [n[0], n[1], n[2], 1.0], color, output);
            let want = reference(&cx, eye, normal, color, face)[which];
            for c in 0..4 {
                prop_assert!((f64::from(got[c]) - want[c]).abs() < 2e-5, "{output:?} {c}: {got:?} {want:?}");
            }
        }
    }
}

#[test]
fn sphere_map_coordinates_are_the_equation() {
    let mut cx = context();
    for c in 0..2 {
        cx.state.texture.units[0].texgen[c].enabled = true;
        cx.state.texture.units[0].texgen[c].mode = GL_SPHERE_MAP;
    }
    cx.state.transform.normalize = true;
    cx.translate(0.4, 0.3, -2.0);
    let got = shade(&mut cx, [0.1, -0.7, 0.2, 1.0], [0.2, 0.3, 0.9, 1.0], [1.0; 4], Output::TexCoord(0));
    let u = DVec3::new(0.5, -0.4, -1.8).normalize();
    let n = DVec3::new(0.2, 0.3, 0.9).normalize();
    let r = u - 2.0 * n * n.dot(u);
    let m = 2.0 * (r.x * r.x + r.y * r.y + (r.z + 1.0) * (r.z + 1.0)).sqrt();
    for (c, want) in [r.x / m + 0.5, r.y / m + 0.5, 0.0, 1.0].into_iter().enumerate() {
        assert!((f64::from(got[c]) - want).abs() < 1e-6, "{c}: {got:?}");
    }
}

#[test]
fn a_rescaled_normal_undoes_uniform_scaling() {
    let mut cx = context();
    cx.state.lighting.enabled = true;
    cx.state.lighting.lights[0].enabled = true;
    cx.state.lighting.model_ambient = [0.0; 4];
    let normal = [0.0, 0.6, 0.8, 1.0];
    let plain = shade(&mut cx, [0.0, 0.0, 0.0, 1.0], normal, [1.0; 4], Output::FrontColor);
    cx.scale(0.25, 0.25, 0.25);
    cx.state.transform.rescale_normal = true;
    let scaled = shade(&mut cx, [0.0, 0.0, 0.0, 1.0], normal, [1.0; 4], Output::FrontColor);
    assert!((plain[0] - 0.64).abs() < 1e-6 && (scaled[0] - plain[0]).abs() < 1e-6, "{plain:?} {scaled:?}");
}
