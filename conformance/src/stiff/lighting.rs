//! Families about lighting and fog: cells of one colour each, which the formulas of 2.14 and 3.10 give in f64.

use super::common::{Cells, Random};
use super::{Case, Family};
use crate::recording::{IDENTITY, Matrix, Recording, Vertex, View, gl, has};

/// The families.
pub fn families() -> Vec<Family> {
    vec![
        Family {
            name: "light_singular",
            about: "Diffuse light under model-view matrices that are sheared, mirrored and nearly singular, GL_NORMALIZE on: the normal matrix is what suffers.",
            knob: "condition of the matrix",
            severities: &[1.0, 1e2, 1e4, 1e6, 1e10, 1e20],
            inside: |_| true,
            make: |severity, seed| (0..4).map(|k| singular(severity, seed, k)).collect(),
        },
        Family {
            name: "light_specular",
            about: "Specular exponents up to 128: the highlight's value, from its middle to where it vanishes.",
            knob: "exponent",
            severities: &[0.0, 1.0, 10.0, 50.0, 127.5, 128.0],
            inside: |_| true,
            make: |severity, seed| vec![specular(severity, seed)],
        },
        Family {
            name: "light_spot",
            about: "Vertices on both sides of a spot's cone, ever nearer to it, exponents 0 to 128. Where the cosines differ by less than 2^-22 both sides are right.",
            knob: "1 / degrees from the cone",
            severities: &[0.1, 1.0, 1e2, 1e3, 1e4, 1e5],
            inside: |_| true,
            make: |severity, seed| vec![spot(severity, seed)],
        },
        Family {
            name: "fog",
            about: "All three fog modes, densities from the reciprocal of the severity to itself, ramps as short as its reciprocal.",
            knob: "extremeness",
            severities: &[1.0, 10.0, 1e3, 1e5, 1e7, 1e10],
            inside: |_| true,
            make: |severity, seed| vec![fog(severity, seed)],
        },
    ]
}

/// State that all lit cells share. The light's position is given in eye space.
fn begin(recording: &mut Recording) {
    let front = [gl::FRONT_AND_BACK, gl::AMBIENT].map(i64::from);
    recording.call("matrix", &[gl::MODELVIEW.into()], &IDENTITY).enable(gl::LIGHTING).enable(gl::LIGHT0);
    recording.call("light_model", &[gl::LIGHT_MODEL_AMBIENT.into()], &[0.0; 4]).call("material", &front, &[0.0; 4]);
    Cells::begin(recording);
}

fn light(recording: &mut Recording, pname: u32, value: [f32; 4]) {
    recording.call("light", &[gl::LIGHT0.into(), pname.into()], &value);
}

fn material(recording: &mut Recording, pname: u32, value: [f32; 4]) {
    recording.call("material", &[gl::FRONT_AND_BACK.into(), pname.into()], &value);
}

fn unit(random: &mut Random) -> [f64; 3] {
    let (z, a) = (random.uniform(-1.0, 1.0), random.uniform(0.0, std::f64::consts::TAU));
    let r = (1.0 - z * z).sqrt();
    [r * a.cos(), r * a.sin(), z]
}

/// The transposed inverse of the upper three columns and rows, times its determinant's size, applied to a normal and normalised.
fn eye_normal(m: &Matrix, n: [f64; 3]) -> [f64; 3] {
    let at = |row: usize, column: usize| f64::from(m[column * 4 + row]);
    let cofactor = |r: usize, c: usize| {
        let (r1, r2, c1, c2) = ((r + 1) % 3, (r + 2) % 3, (c + 1) % 3, (c + 2) % 3);
        at(r1, c1) * at(r2, c2) - at(r1, c2) * at(r2, c1)
    };
    let determinant: f64 = (0..3).map(|c| at(0, c) * cofactor(0, c)).sum();
    let v: [f64; 3] = std::array::from_fn(|r| (0..3).map(|c| cofactor(r, c) * n[c]).sum::<f64>() * determinant.signum());
    let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
    v.map(|x| x / length)
}

fn singular(severity: f64, seed: u64, mirror: usize) -> Case {
    let mut random = Random::new("light_singular", severity, seed * 4 + mirror as u64);
    let sign = |bit: usize| if mirror >> bit & 1 != 0 { -1.0f32 } else { 1.0 };
    let mut view = View::pixels(Cells::WINDOW, Cells::WINDOW);
    // Positions have z = 0, so that the third column moves none of them.
    view.modelview[0] = sign(0);
    view.modelview[5] = sign(1);
    view.modelview[8] = random.uniform(-1.0, 1.0) as f32;
    view.modelview[9] = random.uniform(-1.0, 1.0) as f32;
    view.modelview[10] = (1.0 / severity) as f32;
    let direction = unit(&mut random).map(|v| v as f32);
    let length = direction.iter().map(|v| f64::from(*v).powi(2)).sum::<f64>().sqrt();
    let mut recording = Recording::new(Cells::WINDOW, Cells::WINDOW, 24);
    begin(&mut recording);
    light(&mut recording, gl::POSITION, [direction[0], direction[1], direction[2], 0.0]);
    material(&mut recording, gl::DIFFUSE, [1.0, 0.75, 0.5, 1.0]);
    recording.enable(gl::NORMALIZE).view(&view);
    let mut cells = Cells { colors: Vec::new(), hits: 1 };
    let mut vertices = Vec::new();
    for k in 0..Cells::ALL {
        let [x, y] = Cells::centre(k);
        let normal = unit(&mut random).map(|v| v as f32);
        vertices.push(Vertex { normal, ..Vertex::new(x as f32 * sign(0), y as f32 * sign(1), 0.0) });
        let n = eye_normal(&view.modelview, normal.map(f64::from));
        let cosine = (0..3).map(|c| n[c] * f64::from(direction[c]) / length).sum::<f64>().max(0.0);
        cells.colors.push(Some([1.0, 0.75, 0.5].map(|d| d * cosine)));
    }
    recording.draw(gl::POINTS, has::NORMAL, &vertices);
    Case { recording, judge: Box::new(move |frame| cells.judge(frame)) }
}

fn specular(exponent: f64, seed: u64) -> Case {
    let mut random = Random::new("light_specular", exponent, seed);
    let view = View::pixels(Cells::WINDOW, Cells::WINDOW);
    let mut recording = Recording::new(Cells::WINDOW, Cells::WINDOW, 24);
    begin(&mut recording);
    light(&mut recording, gl::POSITION, [0.0, 0.0, 1.0, 0.0]);
    material(&mut recording, gl::DIFFUSE, [0.0, 0.0, 0.0, 1.0]);
    material(&mut recording, gl::SPECULAR, [1.0, 0.75, 0.5, 1.0]);
    material(&mut recording, gl::SHININESS, [exponent as f32, 0.0, 0.0, 0.0]);
    recording.view(&view);
    let mut cells = Cells { colors: Vec::new(), hits: 1 };
    let mut vertices = Vec::new();
    for k in 0..Cells::ALL {
        let [x, y] = Cells::centre(k);
        // Light and viewer lie along z, and so does the half vector; the normal is taken as it is given.
        let z = random.uniform(1e-6, 1.0).powf(1.0 / exponent.max(0.5)) as f32;
        let normal = [(1.0 - z * z).max(0.0).sqrt(), 0.0, z];
        vertices.push(Vertex { normal, ..Vertex::new(x as f32, y as f32, 0.0) });
        let highlight = f64::from(z).powf(f64::from(exponent as f32));
        cells.colors.push(Some([1.0, 0.75, 0.5].map(|s| s * highlight)));
    }
    recording.draw(gl::POINTS, has::NORMAL, &vertices);
    Case { recording, judge: Box::new(move |frame| cells.judge(frame)) }
}

fn spot(severity: f64, seed: u64) -> Case {
    let mut random = Random::new("light_spot", severity, seed);
    let view = View::pixels(Cells::WINDOW, Cells::WINDOW);
    let mut recording = Recording::new(Cells::WINDOW, Cells::WINDOW, 24);
    begin(&mut recording);
    material(&mut recording, gl::DIFFUSE, [1.0, 0.75, 0.5, 1.0]);
    light(&mut recording, gl::SPOT_DIRECTION, [0.0, 0.0, -1.0, 0.0]);
    recording.view(&view);
    let mut cells = Cells { colors: Vec::new(), hits: 1 };
    for k in 0..Cells::ALL {
        let [x, y] = Cells::centre(k).map(|v| v as f32);
        let cutoff = random.uniform(5.0, 80.0) as f32;
        let exponent = [0.0, 1.0, 128.0][random.below(3) as usize];
        let side = if random.below(2) == 0 { -1.0 } else { 1.0 };
        let angle = (f64::from(cutoff) + side * random.uniform(0.3, 1.0) / severity).clamp(0.0, 89.9);
        // The light hangs 64 above the window; only its place beside the vertex matters.
        let place = [(f64::from(x) + 64.0 * angle.to_radians().tan()) as f32, y, 64.0];
        light(&mut recording, gl::SPOT_CUTOFF, [cutoff, 0.0, 0.0, 0.0]);
        light(&mut recording, gl::SPOT_EXPONENT, [exponent, 0.0, 0.0, 0.0]);
        light(&mut recording, gl::POSITION, [place[0], place[1], place[2], 1.0]);
        let aside = f64::from(place[0]) - f64::from(x);
        let cosine = 64.0 / aside.hypot(64.0);
        let edge = f64::from(cutoff).to_radians().cos();
        let lit = if cosine >= edge { cosine.powf(f64::from(exponent)) * cosine } else { 0.0 };
        cells.colors.push(((cosine - edge).abs() >= 1.0 / 4194304.0).then(|| [1.0, 0.75, 0.5].map(|d| d * lit)));
        recording.call("normal", &[], &[0.0, 0.0, 1.0]).draw(gl::POINTS, has::POSITION, &[Vertex::new(x, y, 0.0)]);
    }
    Case { recording, judge: Box::new(move |frame| cells.judge(frame)) }
}

fn fog(severity: f64, seed: u64) -> Case {
    let mut random = Random::new("fog", severity, seed);
    let view = View::perspective(Cells::WINDOW, Cells::WINDOW, 0.125, 4096.0);
    let mut recording = Recording::new(Cells::WINDOW, Cells::WINDOW, 24);
    recording.view(&view).enable(gl::FOG).call("fog", &[gl::FOG_COLOR.into()], &[0.0, 0.25, 1.0, 1.0]);
    Cells::begin(&mut recording);
    let half = Cells::WINDOW as f64 / 2.0;
    let mut cells = Cells { colors: Vec::new(), hits: 1 };
    for k in 0..Cells::ALL {
        let z = 2f64.powf(random.uniform(-2.0, 11.0)) as f32;
        let [x, y] = Cells::centre(k).map(|c| ((c / half - 1.0) * f64::from(z)) as f32);
        let c = f64::from(z);
        let density = severity.powf(random.uniform(-1.0, 1.0)) as f32;
        let d = f64::from(density) * c;
        let factor = match k % 3 {
            0 => {
                // The ramp begins or ends near the fragment, and every other one runs backwards.
                let length = c / severity * random.uniform(0.5, 1.5) * if random.below(2) == 0 { 1.0 } else { -1.0 };
                let start = (c - length * random.uniform(-0.5, 1.5)) as f32;
                let end = (f64::from(start) + length) as f32;
                recording.call("fog_mode", &[gl::LINEAR.into()], &[]);
                recording.call("fog", &[gl::FOG_START.into()], &[start, 0.0, 0.0, 0.0]);
                recording.call("fog", &[gl::FOG_END.into()], &[end, 0.0, 0.0, 0.0]);
                // A ramp without length divides by zero: not defined.
                (start != end).then(|| (f64::from(end) - c) / (f64::from(end) - f64::from(start)))
            }
            mode => {
                recording.call("fog_mode", &[if mode == 1 { gl::EXP } else { gl::EXP2 }.into()], &[]);
                recording.call("fog", &[gl::FOG_DENSITY.into()], &[density, 0.0, 0.0, 0.0]);
                Some(if mode == 1 { (-d).exp() } else { (-d * d).exp() })
            }
        };
        let factor = factor.map(|f| f.clamp(0.0, 1.0));
        cells.colors.push(factor.map(|f| [f, f + (1.0 - f) * 0.25, 1.0]));
        recording.draw(gl::POINTS, has::POSITION, &[Vertex::new(x, y, -z)]);
    }
    Case { recording, judge: Box::new(move |frame| cells.judge(frame)) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn normals_follow_the_inverse_transpose() {
        let mut m = IDENTITY;
        m[0] = 2.0;
        assert_eq!(eye_normal(&m, [1.0, 1.0, 0.0]).map(|v| (v * 1e6).round()), [447214.0, 894427.0, 0.0]);
        m[0] = -1.0;
        assert_eq!(eye_normal(&m, [1.0, 0.0, 0.0]), [-1.0, 0.0, 0.0]);
    }
}
