//! Scenes by name, so that a process of its own can be told which one to draw: `S1` to `S6`, `T1` to `T6`, `area/10` (equal
//! triangles of 10 pixels), `draws/1000/blend` (the same triangles in 1000 draws), and any of them with a mode: `S3+blend`.

use super::scenes::{Change, Mode, Random, Scene};
use super::t_scenes::t_scene;

/// Triangles of the sweep of draws: 10,000 draws of 20.
pub const DRAWN: u32 = 200_000;

/// Seeds of what is random here: this plus the number of the case.
const SEED: u64 = 0x5EED_1000;

fn named<T: Copy>(all: &[(T, &str)], name: &str) -> Result<T, String> {
    let found = all.iter().find(|(_, n)| *n == name).map(|(t, _)| *t);
    found.ok_or_else(|| format!("{name:?} is none of {}", all.iter().map(|(_, n)| *n).collect::<Vec<_>>().join(", ")))
}

fn number<T: std::str::FromStr>(text: Option<&str>, name: &str) -> Result<T, String> {
    text.and_then(|t| t.parse().ok()).ok_or_else(|| format!("{name:?} lacks a number"))
}

impl Scene {
    /// A scene by its name.
    pub fn named(name: &str, size: [u32; 2]) -> Result<Scene, String> {
        let (base, mode) = name.split_once('+').map_or((name, None), |(b, m)| (b, Some(m)));
        let parts: Vec<&str> = base.split('/').collect();
        let mut scene = match (parts[0], base.split_at_checked(1)) {
            ("area", _) => {
                let triangles = parts.get(2).map_or(Ok(100_000), |t| number(Some(t), name))?;
                Scene::layers(number(parts.get(1).copied(), name)?, triangles, size)
            }
            ("draws", _) => {
                let change = named(&Change::ALL, parts.get(2).copied().unwrap_or("none"))?;
                Scene::many_draws(number(parts.get(1).copied(), name)?, change, size)?
            }
            (_, Some(("S", id))) => Scene::new(number(Some(id), name)?, size)?,
            (_, Some(("T", id))) => t_scene(number(Some(id), name)?, size)?,
            _ => return Err(format!("there is no scene {name:?}")),
        };
        if let Some(mode) = mode {
            scene.mode = named(&Mode::ALL, mode)?;
        }
        Ok(scene)
    }

    /// Equal triangles of an area in pixels, in layers that fill the screen (CUDARaster, figure 5): flat, without depth or blending.
    pub fn layers(area: f64, triangles: u32, size: [u32; 2]) -> Scene {
        let mut scene = Scene::empty(size);
        (scene.mode, scene.flat) = (Mode::Plain, true);
        let mut random = Random(SEED + area.to_bits() % 0xffff);
        let side = (2.0 * area).sqrt();
        let [columns, rows] = size.map(|s| ((s as f64 / side).floor() as u32).max(1));
        while scene.triangles() < triangles {
            let first = scene.positions.len() as u32;
            // What a row leaves over shifts the layer, so that layers do not hit the same samples.
            let shift = [0, 1].map(|k| random.range(0.0, (size[k] as f64 - side * [columns, rows][k] as f64).max(0.0)));
            let z = random.range(-0.9, 0.9);
            for j in 0..=rows {
                for i in 0..=columns {
                    let color = random.color();
                    scene.put(shift[0] + i as f64 * side, shift[1] + j as f64 * side, z, 1.0, color);
                }
            }
            for j in 0..rows {
                for i in 0..columns {
                    let a = first + j * (columns + 1) + i;
                    let (b, c) = (a + 1, a + columns + 1);
                    scene.indices.extend([a, b, c + 1, a, c + 1, c]);
                }
            }
        }
        scene.indices.truncate(triangles as usize * 3);
        scene
    }

    /// Five by two quads of triangles of 10 pixels, with shared vertices: 20 triangles.
    fn small_patch(&mut self, random: &mut Random) {
        let edge = 20f64.sqrt();
        let first = self.positions.len() as u32;
        let [x, y] = self.size.map(|s| random.range(0.0, s as f64 - 6.0 * edge));
        let (z, w) = (random.range(-0.9, 0.8), random.range(1.0, 3.0));
        for (j, i) in (0..=2).flat_map(|j| (0..=5).map(move |i| (j, i))) {
            let color = random.color();
            self.put(x + i as f64 * edge, y + j as f64 * edge, z + 0.01 * i as f64, w + 0.1 * j as f64, color);
        }
        for (j, i) in (0..2).flat_map(|j| (0..5).map(move |i| (j, i))) {
            let a = first + j * 6 + i;
            self.indices.extend([a, a + 1, a + 7, a, a + 7, a + 6]);
        }
    }

    /// The same 200,000 triangles of 10 pixels in so many draws.
    pub fn many_draws(draws: u32, change: Change, size: [u32; 2]) -> Result<Scene, String> {
        if draws == 0 || !DRAWN.is_multiple_of(draws) {
            return Err(format!("{DRAWN} triangles do not make {draws} equal draws"));
        }
        let mut scene = Scene::empty(size);
        (scene.draws, scene.change) = (draws, change);
        let mut random = Random(SEED + 1);
        (0..DRAWN / 20).for_each(|_| scene.small_patch(&mut random));
        Ok(scene)
    }

    /// A slice of a frame of very many triangles of 1.5 pixels: 2^20 of them.
    pub fn slice(k: u32, size: [u32; 2]) -> Scene {
        let mut scene = Scene::empty(size);
        scene.patches(&mut Random(SEED + 0x100 + k as u64), 128, 64, 1.7320508075688772);
        scene
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn equal_triangles_have_the_area_they_were_asked_for() {
        let scene = Scene::named("area/12.5/1000", [1024, 768]).expect("a scene");
        let at = |k: usize| scene.positions[scene.indices[k] as usize];
        let pixels = |p: [f32; 4]| [(p[0] as f64 + 1.0) * 512.0, (p[1] as f64 + 1.0) * 384.0];
        assert_eq!(scene.triangles(), 1000);
        for t in 0..1000 {
            let [a, b, c] = [0, 1, 2].map(|k| pixels(at(3 * t + k)));
            let twice = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
            assert!((twice * 0.5 - 12.5).abs() < 0.01, "triangle {t}: {}", twice * 0.5);
        }
    }

    #[test]
    fn the_number_of_draws_does_not_change_the_triangles() {
        let one = Scene::named("draws/1", [1024, 768]).expect("a scene");
        let many = Scene::named("draws/10000/blend", [1024, 768]).expect("a scene");
        assert_eq!(one.hash(), many.hash());
        assert_eq!((many.draws, many.change), (10_000, Change::Blend));
        assert!(Scene::named("draws/3", [1024, 768]).is_err());
    }

    #[test]
    fn a_name_that_means_nothing_is_an_error() {
        for name in ["S7", "T0", "Q1", "area", "draws/10/fog", "S3+nothing", ""] {
            assert!(Scene::named(name, [1024, 768]).is_err(), "{name:?}");
        }
    }
}
