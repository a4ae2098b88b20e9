//! Thousands of blended layers in 8 bits, in every blend mode. The oracle blends with real numbers and rounds to nearest once a layer.

use super::common::{Cells, Random};
use super::{Case, Family};
use crate::recording::{Recording, Vertex, View, gl, has};

/// The family.
pub fn families() -> Vec<Family> {
    vec![Family {
        name: "blend_layers",
        about: "Layers of random colours and alphas in 8 bits, blended in all 110 pairs of factors and the other four equations. The oracle rounds to nearest once a layer; what an implementation rounds more often adds up.",
        knob: "layers",
        severities: &[1.0, 10.0, 100.0, 1000.0, 10000.0],
        inside: |_| true,
        make: |severity, seed| vec![layers(severity as usize, seed)],
    }]
}

const FACTORS: [u32; 11] = [
    gl::ZERO,
    gl::ONE,
    gl::SRC_COLOR,
    gl::ONE_MINUS_SRC_COLOR,
    gl::DST_COLOR,
    gl::ONE_MINUS_DST_COLOR,
    gl::SRC_ALPHA,
    gl::ONE_MINUS_SRC_ALPHA,
    gl::DST_ALPHA,
    gl::ONE_MINUS_DST_ALPHA,
    gl::SRC_ALPHA_SATURATE,
];

/// Equation, source factor, destination factor.
fn modes() -> Vec<[u32; 3]> {
    let factors = FACTORS.into_iter().flat_map(|s| FACTORS[..10].iter().map(move |&d| [gl::FUNC_ADD, s, d]));
    let others = [gl::FUNC_SUBTRACT, gl::FUNC_REVERSE_SUBTRACT, gl::MIN, gl::MAX].map(|e| [e, gl::SRC_ALPHA, gl::ONE]);
    factors.chain(others).collect()
}

/// Table 4.2 of the specification, for component `c`.
fn factor(factor: u32, source: [f64; 4], destination: [f64; 4], c: usize) -> f64 {
    match factor {
        gl::ZERO => 0.0,
        gl::ONE => 1.0,
        gl::SRC_COLOR => source[c],
        gl::ONE_MINUS_SRC_COLOR => 1.0 - source[c],
        gl::DST_COLOR => destination[c],
        gl::ONE_MINUS_DST_COLOR => 1.0 - destination[c],
        gl::SRC_ALPHA => source[3],
        gl::ONE_MINUS_SRC_ALPHA => 1.0 - source[3],
        gl::DST_ALPHA => destination[3],
        gl::ONE_MINUS_DST_ALPHA => 1.0 - destination[3],
        _ if c == 3 => 1.0,
        _ => source[3].min(1.0 - destination[3]),
    }
}

/// One layer, rounded to 8 bits.
fn blend([equation, sf, df]: [u32; 3], source: [f64; 4], destination: [f64; 4]) -> [f64; 4] {
    std::array::from_fn(|c| {
        let (s, d) = (source[c], destination[c]);
        let (weighted_s, weighted_d) = (s * factor(sf, source, destination, c), d * factor(df, source, destination, c));
        let v = match equation {
            gl::MIN => s.min(d),
            gl::MAX => s.max(d),
            gl::FUNC_SUBTRACT => weighted_s - weighted_d,
            gl::FUNC_REVERSE_SUBTRACT => weighted_d - weighted_s,
            _ => weighted_s + weighted_d,
        };
        (v.clamp(0.0, 1.0) * 255.0).round() / 255.0
    })
}

fn layers(layers: usize, seed: u64) -> Case {
    let mut random = Random::new("blend_layers", layers as f64, seed);
    let view = View::pixels(Cells::WINDOW, Cells::WINDOW);
    let mut recording = Recording::new(Cells::WINDOW, Cells::WINDOW, 24);
    let background = [51.0, 102.0, 153.0, 204.0].map(|v: f64| v / 255.0);
    recording.call("clear_color", &[], &background.map(|v| v as f32)).call("clear", &[gl::COLOR_BUFFER_BIT.into()], &[]);
    recording.view(&view).enable(gl::BLEND);
    Cells::begin(&mut recording);
    let mut cells = Cells { colors: Vec::new(), hits: layers.min(255) as u8 };
    for (k, mode) in modes().into_iter().enumerate() {
        let [x, y] = Cells::centre(k);
        let mut value = background;
        let vertices: Vec<Vertex> = (0..layers)
            .map(|_| {
                let color: [f64; 4] = std::array::from_fn(|_| random.below(256) as f64 / 255.0);
                value = blend(mode, color, value);
                Vertex::new(x as f32, y as f32, 0.0).colored(color.map(|v| v as f32))
            })
            .collect();
        let [equation, s, d] = mode.map(i64::from);
        recording.call("blend_equation", &[equation], &[]).call("blend_func", &[s, d], &[]).draw(gl::POINTS, has::COLOR, &vertices);
        cells.colors.push(Some([value[0], value[1], value[2]]));
    }
    Case { recording, judge: Box::new(move |frame| cells.judge(frame)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_common_mode_is_the_textbook_one() {
        let out = blend([gl::FUNC_ADD, gl::SRC_ALPHA, gl::ONE_MINUS_SRC_ALPHA], [1.0, 0.0, 0.2, 0.4], [0.0, 1.0, 0.2, 1.0]);
        assert_eq!(out, [0.4, 0.6, 0.2, (0.76f64 * 255.0).round() / 255.0]);
        let saturate = blend([gl::FUNC_ADD, gl::SRC_ALPHA_SATURATE, gl::ONE], [1.0, 1.0, 1.0, 0.8], [0.0, 0.0, 0.0, 0.6]);
        assert_eq!(saturate, [0.4, 0.4, 0.4, 1.0]);
    }
}
