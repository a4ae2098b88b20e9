//! The scenes T1 to T6 of the study of CPU rasterizers, rebuilt from their description: so many triangles of such a kind in such a
//! state. The models themselves were not published; what is kept is the number of triangles, their order and their size on the screen.
//!
//! | | triangles | state | here |
//! |---|---|---|---|
//! | T1 | 18 | colour with perspective, depth | a box in a corner of a room |
//! | T2 | 8,192 | colour without perspective, no depth | small triangles anywhere |
//! | T3 | 92 | bilinear texture, perspective, depth | nine boxes without bottoms on a floor |
//! | T4 | 4,096 | as T3 | a ball |
//! | T5 | 36,864 | as T3 | nine balls |
//! | T6 | 131,072 | as T3, light in the texture | a landscape in strips, near to far |

use super::scenes::{Mode, Random, Scene};

const SEED: u64 = 0x5EED_2000;

/// Hashes at 1024 x 1024.
#[cfg(test)]
const HASHES: [u64; 6] =
    [0x8aec730698389c94, 0x7ad26e36b609a96b, 0x9bd4aa7374ee4ad1, 0x045d7bfb2da5aae6, 0x0723248f27c9dc1d, 0x9ce0e778933afe2c];

/// A corner in eye space, its texture coordinates and its colour.
#[derive(Clone, Copy)]
struct Corner {
    at: [f64; 3],
    uv: [f64; 2],
    color: u32,
}

/// Makes scene `id`.
pub fn t_scene(id: u32, size: [u32; 2]) -> Result<Scene, String> {
    let mut scene = Scene::empty(size);
    let mut random = Random(SEED + id as u64);
    match id {
        1 => room(&mut scene, &mut random),
        2 => {
            scene.mode = Mode::Plain;
            (0..8192).for_each(|_| scene.soup(&mut random, 40.0));
            scene.positions.iter_mut().for_each(|p| *p = [p[0] / p[3], p[1] / p[3], p[2] / p[3], 1.0]);
        }
        3 => boxes(&mut scene, &mut random),
        4 => ball(&mut scene, &mut random, [0.0, 0.0, -2.2], 0.95),
        5 => (0..9).for_each(|k| {
            let (x, y) = ((k % 3) as f64 - 1.0, (k / 3) as f64 - 1.0);
            ball(&mut scene, &mut random, [x * 1.1, y * 1.1, -3.0 - random_unit(k)], 0.75);
        }),
        6 => landscape(&mut scene, &mut random),
        _ => return Err(format!("there is no scene T{id}: T1 to T6")),
    }
    if id < 3 {
        scene.coordinates.clear();
    }
    Ok(scene)
}

fn random_unit(k: u32) -> f64 {
    (k * 5 % 9) as f64 / 9.0
}

/// Through a camera at the origin that looks along -z, a right angle across, near 0.5, far 20.
fn vertex(scene: &mut Scene, corner: Corner) -> u32 {
    let [x, y, z] = corner.at;
    let (near, far) = (0.5, 20.0);
    let depth = (-(far + near) / (far - near)) * z - 2.0 * far * near / (far - near);
    scene.positions.push([x as f32, y as f32, depth as f32, -z as f32]);
    scene.colors.push(corner.color);
    scene.coordinates.push(corner.uv.map(|c| c as f32));
    scene.positions.len() as u32 - 1
}

fn quad(scene: &mut Scene, random: &mut Random, corners: [[f64; 3]; 4]) {
    let uv = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let [a, b, c, d] = [0, 1, 2, 3].map(|k| {
        let color = random.color() | 0xff00_0000;
        vertex(scene, Corner { at: corners[k], uv: uv[k], color })
    });
    scene.indices.extend([a, b, c, a, c, d]);
}

/// The sides of a box, the first `faces` of: top, front, left, right, back, bottom.
fn cuboid(scene: &mut Scene, random: &mut Random, low: [f64; 3], high: [f64; 3], faces: usize) {
    let p = |k: [usize; 3]| [0, 1, 2].map(|a| if k[a] == 1 { high[a] } else { low[a] });
    let sides = [
        [[0, 1, 1], [1, 1, 1], [1, 1, 0], [0, 1, 0]],
        [[0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]],
        [[0, 0, 0], [0, 0, 1], [0, 1, 1], [0, 1, 0]],
        [[1, 0, 1], [1, 0, 0], [1, 1, 0], [1, 1, 1]],
        [[1, 0, 0], [0, 0, 0], [0, 1, 0], [1, 1, 0]],
        [[0, 0, 0], [1, 0, 0], [1, 0, 1], [0, 0, 1]],
    ];
    for side in &sides[..faces] {
        quad(scene, random, side.map(p));
    }
}

/// Floor and two walls, and a box: 9 quads.
fn room(scene: &mut Scene, random: &mut Random) {
    quad(scene, random, [[-3.0, -1.5, -1.6], [3.0, -1.5, -1.6], [3.0, -1.5, -6.0], [-3.0, -1.5, -6.0]]);
    quad(scene, random, [[-6.0, -1.5, -6.0], [6.0, -1.5, -6.0], [6.0, 6.0, -6.0], [-6.0, 6.0, -6.0]]);
    quad(scene, random, [[-3.0, -1.5, -3.0], [-3.0, -1.5, -6.0], [-3.0, 3.0, -6.0], [-3.0, 3.0, -3.0]]);
    cuboid(scene, random, [-1.2, -1.5, -4.6], [1.2, 0.6, -2.6], 6);
}

/// A floor and nine boxes of five sides: 46 quads.
fn boxes(scene: &mut Scene, random: &mut Random) {
    quad(scene, random, [[-6.0, -1.2, -1.25], [6.0, -1.2, -1.25], [6.0, -1.2, -9.0], [-6.0, -1.2, -9.0]]);
    for k in 0..9 {
        let (x, z) = ((k % 3) as f64 * 2.2 - 2.2, -2.8 - (k / 3) as f64 * 2.0);
        let height = random.range(0.8, 2.8);
        cuboid(scene, random, [x - 0.8, -1.2, z - 0.7], [x + 0.8, height - 1.2, z + 0.7], 5);
    }
}

/// A point of a circle without a sine: t runs from -1 to 1 for half of it.
fn half_circle(t: f64) -> [f64; 2] {
    let d = 1.0 + t * t;
    [(1.0 - t * t) / d, 2.0 * t / d]
}

/// 64 x 32 quads, row by row.
fn ball(scene: &mut Scene, random: &mut Random, center: [f64; 3], radius: f64) {
    let first = scene.positions.len() as u32;
    for j in 0..=32 {
        // Latitude runs over half a circle, from pole to pole.
        let [around, up] = half_circle(j as f64 / 16.0 - 1.0);
        for i in 0..=64 {
            let half = half_circle((i % 32) as f64 / 16.0 - 1.0);
            let [x, z] = if i < 32 {
                half
            } else if i < 64 {
                half.map(|c| -c)
            } else {
                half_circle(-1.0)
            };
            let at = [center[0] + radius * around * x, center[1] + radius * up, center[2] + radius * around * z];
            let color = random.color() | 0xff00_0000;
            vertex(scene, Corner { at, uv: [i as f64 / 16.0, j as f64 / 16.0], color });
        }
    }
    grid(scene, first, 64, 32);
}

/// 256 x 256 quads of hills that reach from below the camera to the horizon.
fn landscape(scene: &mut Scene, random: &mut Random) {
    let first = scene.positions.len() as u32;
    for j in 0..=256 {
        let z = -1.0 - 14.0 * (j as f64 / 256.0) * (j as f64 / 256.0);
        for i in 0..=256 {
            let (u, v) = (i as f64 / 256.0, j as f64 / 256.0);
            let x = (u * 2.0 - 1.0) * -z * 1.05;
            let hill = |a: f64, b: f64| half_circle((a + b) % 2.0 - 1.0)[0];
            let y = -0.95 + 0.5 * v * (hill(u * 7.0, v * 5.0) + hill(u * 3.0, v * 11.0)) * (1.0 + 4.0 * v) + random.range(-0.004, 0.004);
            let color = random.color() | 0xff00_0000;
            vertex(scene, Corner { at: [x, y, z], uv: [u * 8.0, v * 8.0], color });
        }
    }
    grid(scene, first, 256, 256);
}

fn grid(scene: &mut Scene, first: u32, columns: u32, rows: u32) {
    for j in 0..rows {
        for i in 0..columns {
            let a = first + j * (columns + 1) + i;
            let (b, c) = (a + 1, a + columns + 1);
            scene.indices.extend([a, b, c + 1, a, c + 1, c]);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn scenes_have_the_triangles_that_the_paper_says() {
        let counts = [1, 2, 3, 4, 5, 6].map(|id| t_scene(id, [1024, 1024]).expect("a scene").triangles());
        assert_eq!(counts, [18, 8192, 92, 4096, 36864, 131072]);
    }

    #[test]
    fn scenes_are_the_same_bits_everywhere() {
        let hashes = [1, 2, 3, 4, 5, 6].map(|id| t_scene(id, [1024, 1024]).expect("a scene").hash());
        assert_eq!(hashes.map(|h| format!("{h:016x}")), HASHES.map(|h| format!("{h:016x}")));
    }
}
