//! Small programs with known results.

use super::*;
use crate::program::{Input, Interface, Program, Stage};

/// A fragment program `body` with inputs i0 and i1, run on lanes whose i0.x is the lane's number.
fn run(body: &str, uniforms: &[[f32; 4]], level: Simd) -> FragmentResults {
    let wgsl = format!(
        "struct FragmentIn {{ i0: vec4<f32>, i1: vec4<f32> }}
         struct FragmentOut {{ color: vec4<f32>, keep: bool }}
         fn fragment_main(in: FragmentIn, base: u32) -> FragmentOut {{ var out: FragmentOut; out.keep = true; {body} return out; }}"
    );
    let interface = Interface { inputs: vec![Input::Varying(0), Input::Varying(1)], ..Interface::default() };
    let program = Program::new(Stage::Fragment, wgsl, interface).unwrap();
    compile(&program).unwrap();
    let mut inputs = [ZERO4; 2];
    for g in 0..GROUPS {
        for l in 0..LANES {
            inputs[0][0][g][l] = (g * LANES + l) as f32;
            inputs[1][0][g][l] = 0.37 * l as f32 - 1.0;
            inputs[1][1][g][l] = 1e3 / (1 + g) as f32;
        }
    }
    let mut results = FragmentResults::default();
    let env = Environment { uniforms, base: 1, textures: &[] };
    Machine::with_simd(level).run_fragment(&program, &env, &inputs, &mut results, GROUPS);
    results
}

/// Checks red against a function of the lane's number.
fn expect(body: &str, want: impl Fn(u32) -> f32) {
    for level in [Simd::Scalar, Simd::Avx2] {
        let got = run(body, &[[9.0; 4], [1.0, 2.0, 3.0, 4.0], [5.0, 6.0, 7.0, 8.0]], level);
        for i in 0..(GROUPS * LANES) {
            assert_eq!(got.color[0][i / LANES][i % LANES], want(i as u32), "lane {i}, {body}");
        }
    }
}

#[test]
fn straight_lines_and_uniforms() {
    expect("out.color.x = in.i0.x * uniforms[base].y + uniforms[base + 1u].z;", |i| i as f32 * 2.0 + 7.0);
    expect("out.color = vec4<f32>(dot(vec4<f32>(in.i0.x, 1.0, 2.0, 3.0), uniforms[base]));", |i| i as f32 + 2.0 + 6.0 + 12.0);
}

#[test]
fn uniforms_by_a_computed_index() {
    expect("out.color.x = uniforms[base + (u32(in.i0.x) & 1u)].x;", |i| [1.0, 5.0][i as usize & 1]);
    expect("out.color.x = uniforms[u32(in.i0.x)].x;", |i| [9.0, 1.0, 5.0].get(i as usize).copied().unwrap_or(0.0));
}

#[test]
fn branches_keep_the_lanes_apart() {
    expect("var x = 1.0; if in.i0.x > 30.0 { x = 2.0; if in.i0.x > 40.0 { x += in.i0.x; } } else { x = in.i0.x; } out.color.x = x;", |i| {
        match i {
            0..=30 => i as f32,
            31..=40 => 2.0,
            _ => 2.0 + i as f32,
        }
    });
}

#[test]
fn an_early_return_masks_what_follows() {
    expect("out.color.x = 1.0; if in.i0.x < 5.0 { return out; } out.color.x = 2.0;", |i| if i < 5 { 1.0 } else { 2.0 });
}

#[test]
fn loops_run_as_often_as_each_lane_wants() {
    expect("var n = 0.0; for (var i = 0; i < 10; i++) { n += in.i0.x; } out.color.x = n;", |i| 10.0 * i as f32);
    expect("var n = 0.0; var i = in.i0.x; loop { if i <= 0.0 { break; } n += i; i -= 1.0; } out.color.x = n;", |i| {
        (i * (i + 1) / 2) as f32
    });
    expect(
        "var n = 0; for (var i = 0; i < i32(in.i0.x); i++) { if i % 3 == 1 { continue; } if i > 20 { break; } n += i; } out.color.x = f32(n);",
        |i| (0..i.min(21)).filter(|k| k % 3 != 1).sum::<u32>() as f32,
    );
    // Two variables that trade places each round.
    expect("var a = 1.0; var b = in.i0.x; for (var i = 0.0; i < in.i0.x; i += 1.0) { let t = a; a = b; b = t; } out.color.x = a;", |i| {
        if i % 2 == 0 { 1.0 } else { i as f32 }
    });
}

#[test]
fn nested_loops_and_arrays() {
    expect(
        "var t: array<f32, 4>; for (var i = 0u; i < 4u; i++) { t[i] = f32(i * i); }
         var n = 0.0; for (var i = 0u; i < u32(in.i0.x); i++) { for (var k = i; k < 3u; k++) { n += t[k]; } } out.color.x = n;",
        |i| (0..i).map(|i| (i..3).map(|k| (k * k) as f32).sum::<f32>()).sum(),
    );
    expect("var t = array<f32, 3>(4.0, 5.0, 6.0); t[u32(in.i0.x) % 3u] = 1.0; out.color.x = t[0] * 100.0 + t[1] * 10.0 + t[2];", |i| {
        [156.0, 416.0, 451.0][i as usize % 3]
    });
}

#[test]
fn switches_take_their_case() {
    expect(
        "switch u32(in.i0.x) { case 0u, 3u: { out.color.x = 7.0; } case 1u: { if in.i1.x > -2.0 { break; } out.color.x = 9.0; } default: { out.color.x = 5.0; } }",
        |i| match i {
            0 | 3 => 7.0,
            1 => 0.0,
            _ => 5.0,
        },
    );
}

#[test]
fn discarded_lanes_are_not_kept() {
    let got = run("if in.i0.x < 10.0 { discard; } out.keep = in.i0.x != 12.0;", &[], Simd::Avx2);
    assert_eq!(got.keep, [0, 0b1110_1100, !0, !0, !0, !0, !0, !0]);
}

#[test]
fn every_simd_level_gives_the_same_bits() {
    let body = "let x = in.i1.x; let y = in.i1.y;
        out.color = vec4<f32>(pow(abs(x), y) + exp2(x) * log2(y), sin(y) + cos(x) * tan(x), atan2(x, y) - asin(x) + acos(x) + sqrt(x), fma(x, y, x) + floor(x) % fract(y));
        out.color += normalize(vec4<f32>(x, y, x * y, 1.0)) + inverseSqrt(y) + sign(x) + round(y) + trunc(x) + ceil(y);";
    let (a, b) = (run(body, &[], Simd::Scalar), run(body, &[], Simd::Avx2));
    let bits = |r: &FragmentResults| r.color.map(|c| c.map(|g| g.map(f32::to_bits)));
    assert_eq!(bits(&a), bits(&b));
}
