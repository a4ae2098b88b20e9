//! Texture sampling (3.8.7, 3.8.8), the intrinsic `texture_sample` of programs: eight lanes at a time, exact f32 filtering.

use super::cells::{self, Cells};
use super::lod::{self, runs_on};
use super::simd::{self, Level};
use super::texture_fetch::{Fetch, linear_axis, nearest};
use std::slice::{from_mut, from_ref};

#[cfg(target_arch = "x86_64")]
use super::texture_wide::{self, Pyramid};
use crate::draw::texture::{Sampler, TexelFormat, TextureBinding, TextureImage, TextureKind, TextureLevel, Wrap};
use crate::program::lanes::{LANES, Simd};

/// A component of eight lanes.
pub type Lanes = [f32; LANES];
/// Whole numbers of eight lanes.
pub type Indices = [i32; LANES];

/// Four components of eight lanes, lane by lane.
pub type Texels = [[f32; 4]; LANES];

/// A texture that is about to be sampled often.
pub struct Prepared<'a> {
    image: &'a TextureImage,
    sampler: &'a Sampler,
    /// For the commonest filter between levels.
    #[cfg(target_arch = "x86_64")]
    pyramid: Option<Pyramid<'a>>,
    /// The first level, unpacked.
    cells: Option<&'a Cells>,
}

impl<'a> Prepared<'a> {
    /// Looks at what does not change from sample to sample. `cells` are those of the first level, where it is unpacked.
    pub fn new(binding: &'a TextureBinding, cells: Option<&'a Cells>) -> Prepared<'a> {
        let (image, sampler) = (&*binding.image, &binding.sampler);
        Prepared {
            image,
            sampler,
            #[cfg(target_arch = "x86_64")]
            pyramid: (image.format == TexelFormat::Rgba8 && image.kind == TextureKind::D2 && sampler.mag_linear && runs_on(sampler))
                .then(|| Pyramid::new(&image.levels, [sampler.wrap[0], sampler.wrap[1]]))
                .flatten(),
            cells: cells.filter(|_| cells::serves(image, sampler)),
        }
    }

    /// Samples one group of lanes: `coord` is s, t, r and an unused fourth; `gradients` the derivatives of s, t, r in x and y
    /// of the raster, absent where no level of detail is wanted.
    pub fn group(&self, coord: &[Lanes; 4], gradients: Option<[&[Lanes; 3]; 2]>, level: Simd) -> [Lanes; 4] {
        let level = if level == Simd::Scalar { Level::Scalar } else { Level::Avx2 };
        group_at(level, self, coord, gradients)
    }

    /// λ of eight lanes on a flat image, from the derivatives of s and t in x and y.
    #[inline(always)]
    pub fn flat_lambda<S: simd::Simd>(&self, gradients: [[S::F; 2]; 2]) -> S::F {
        match self.image.levels.first() {
            Some(base) => lod::flat::<S>(self.image.kind, self.sampler, base, gradients),
            None => S::f(0.0),
        }
    }

    /// Samples a flat image at s and t of groups of lanes, with λ where a level of detail is wanted.
    #[inline(always)]
    pub fn flat<S: simd::Simd>(&self, coord: [&[Lanes]; 2], lambda: Option<&[Lanes]>, to: &mut [Texels]) {
        let Some(base) = self.image.levels.first() else { return to.fill(rows(&NOTHING)) };
        if !self.wide::<S>(base, coord, &[], lambda, to) {
            for (g, to) in to.iter_mut().enumerate() {
                let position = Position { s: coord[0][g], t: coord[1][g], r: [0.0; LANES], face: [0; LANES] };
                *to = rows(&at_levels_at(S::LEVEL, self.image, self.sampler, base, &position, lambda.map(|lambda| lambda[g])));
            }
        }
    }

    /// The commonest filters, where the processor has AVX2; false for others.
    #[inline(always)]
    fn wide<S: simd::Simd>(
        &self,
        base: &TextureLevel,
        coord: [&[Lanes]; 2],
        faces: &[Indices],
        lambda: Option<&[Lanes]>,
        to: &mut [Texels],
    ) -> bool {
        let Some(lambda) = lambda else {
            #[cfg(target_arch = "x86_64")]
            if S::LEVEL == Level::Avx2
                && let Some(cells) = self.cells
            {
                // SAFETY: the level is AVX2, and the wrap modes were looked at.
                unsafe { cells.filter(wrap_modes(self.image, self.sampler), coord, to) };
                return true;
            }
            return wide_level::<S>(self.image, self.sampler, base, self.sampler.mag_linear, coord, faces, to);
        };
        #[cfg(target_arch = "x86_64")]
        if S::LEVEL == Level::Avx2
            && let Some(pyramid) = &self.pyramid
        {
            // SAFETY: the level is AVX2.
            unsafe { pyramid.trilinear(coord, lambda, to) };
            return true;
        }
        let _ = lambda;
        false
    }
}

crate::dispatch! {
    /// [`Prepared::group`] at a level.
    fn group_at = sample<'a>(texture: &Prepared<'a>, coord: &[Lanes; 4], gradients: Option<[&[Lanes; 3]; 2]>) -> [Lanes; 4]
}

#[inline(always)]
fn sample<S: simd::Simd>(texture: &Prepared, coord: &[Lanes; 4], gradients: Option<[&[Lanes; 3]; 2]>) -> [Lanes; 4] {
    let (image, sampler) = (texture.image, texture.sampler);
    let Some(base) = image.levels.first() else { return NOTHING };
    let position = match image.kind {
        TextureKind::Cube => cube_position(coord),
        _ => Position { s: coord[0], t: coord[1], r: coord[2], face: [0; LANES] },
    };
    let lambda = gradients.map(|gradients| lod::group::<S>(image, sampler, base, coord, gradients, &position));
    let mut texels = [[0.0; 4]; LANES];
    if texture.wide::<S>(base, position.coord(), &[position.face], lambda.as_ref().map(from_ref), from_mut(&mut texels)) {
        return columns::<S>(&texels);
    }
    at_levels::<S>(image, sampler, base, &position, lambda)
}

crate::dispatch! {
    /// [`at_levels`] at a level, not inlined: what is sampled by it is seldom.
    fn at_levels_at = at_levels(image: &TextureImage, sampler: &Sampler, base: &TextureLevel, position: &Position, lambda: Option<Lanes>) -> [Lanes; 4]
}

/// What an image without texels gives.
const NOTHING: [Lanes; 4] = [[0.0; LANES], [0.0; LANES], [0.0; LANES], [1.0; LANES]];

#[inline(always)]
fn rows(columns: &[Lanes; 4]) -> Texels {
    let mut rows = [[0.0; 4]; LANES];
    for (lane, row) in rows.iter_mut().enumerate() {
        for c in 0..4 {
            row[c] = columns[c][lane];
        }
    }
    rows
}

#[inline(always)]
fn columns<S: simd::Simd>(rows: &Texels) -> [Lanes; 4] {
    let mut columns = [[0.0; LANES]; 4];
    let of = S::columns(rows.each_ref());
    for c in 0..4 {
        S::store(of[c], &mut columns[c]);
    }
    columns
}

/// Wrap modes of s and t. A 1D image is a row: whatever t is, clamping it finds that row.
pub fn wrap_modes(image: &TextureImage, sampler: &Sampler) -> [Wrap; 2] {
    [sampler.wrap[0], if image.kind == TextureKind::D1 { Wrap::ClampToEdge } else { sampler.wrap[1] }]
}

/// One level, where the processor has AVX2; false for what is not common.
#[inline(always)]
fn wide_level<S: simd::Simd>(
    image: &TextureImage,
    sampler: &Sampler,
    level: &TextureLevel,
    linear: bool,
    coord: [&[Lanes]; 2],
    faces: &[Indices],
    to: &mut [Texels],
) -> bool {
    if S::LEVEL != Level::Avx2 || image.format != TexelFormat::Rgba8 || image.kind == TextureKind::D3 {
        return false;
    }
    let wrap = wrap_modes(image, sampler);
    let layers = image.kind != TextureKind::Cube || level.depth >= 6;
    #[cfg(target_arch = "x86_64")]
    if layers && texture_wide::serves(level, wrap, linear) {
        // SAFETY: the level is AVX2; a face is below 6, and 0 on other images.
        unsafe { texture_wide::sample(level, wrap, linear, coord, faces, to) };
        return true;
    }
    false
}

/// How a lane is filtered: from which level, with which filter, and how far towards the next level.
#[derive(Clone, Copy, PartialEq)]
struct Choice {
    level: usize,
    linear: bool,
    /// 0 where one level is enough.
    blend: f32,
}

/// Samples by any filter of any image.
#[inline(always)]
fn at_levels<S: simd::Simd>(
    image: &TextureImage,
    sampler: &Sampler,
    base: &TextureLevel,
    position: &Position,
    lambda: Option<Lanes>,
) -> [Lanes; 4] {
    let Some(lambda) = lambda else { return sample_level::<S>(image, sampler, base, sampler.mag_linear, position) };
    let choices = lambda.map(|lambda| choose(image, sampler, lambda));
    let first = choices[0];
    if choices.iter().all(|c| (c.level, c.linear) == (first.level, first.linear)) {
        return sample_choice::<S>(image, sampler, first, choices.map(|c| c.blend), position);
    }
    // Lanes that disagree (a quad each): every choice samples all lanes, and the lanes that made it take the result.
    let mut result = [[0.0; LANES]; 4];
    let mut done = [false; LANES];
    for lane in 0..LANES {
        if done[lane] {
            continue;
        }
        let choice = choices[lane];
        let texel = sample_choice::<S>(image, sampler, choice, choices.map(|c| c.blend), position);
        for other in lane..LANES {
            if (choices[other].level, choices[other].linear) == (choice.level, choice.linear) {
                done[other] = true;
                for c in 0..4 {
                    result[c][other] = texel[c][other];
                }
            }
        }
    }
    result
}

/// Where the lanes sample: coordinates on the image (or on a cube's face).
pub struct Position {
    /// Coordinates.
    pub s: Lanes,
    /// See `s`.
    pub t: Lanes,
    /// See `s`.
    pub r: Lanes,
    /// A cube's face.
    pub face: Indices,
}

impl Position {
    /// s and t, as one group of lanes.
    fn coord(&self) -> [&[Lanes]; 2] {
        [from_ref(&self.s), from_ref(&self.t)]
    }
}

/// Table 3.19: the face of the largest component, and the coordinates on it.
#[inline(always)]
fn cube_position(coord: &[Lanes; 4]) -> Position {
    let mut p = Position { s: [0.0; LANES], t: [0.0; LANES], r: [0.0; LANES], face: [0; LANES] };
    for lane in 0..LANES {
        let direction = [coord[0][lane], coord[1][lane], coord[2][lane]];
        let face = major_face(direction);
        let [s, t] = on_face(face, direction);
        (p.face[lane], p.s[lane], p.t[lane]) = (face as i32, s, t);
    }
    p
}

fn major_face([x, y, z]: [f32; 3]) -> usize {
    let (ax, ay, az) = (x.abs(), y.abs(), z.abs());
    if ax >= ay && ax >= az {
        usize::from(x < 0.0)
    } else if ay >= az {
        2 + usize::from(y < 0.0)
    } else {
        4 + usize::from(z < 0.0)
    }
}

/// Coordinates on a cube's face.
pub fn on_face(face: usize, [x, y, z]: [f32; 3]) -> [f32; 2] {
    let (sc, tc, ma) = match face {
        0 => (-z, -y, x),
        1 => (z, -y, x),
        2 => (x, z, y),
        3 => (x, -z, y),
        4 => (x, -y, z),
        _ => (-x, -y, z),
    };
    [0.5 * (sc / ma.abs() + 1.0), 0.5 * (tc / ma.abs() + 1.0)]
}

/// Magnification or minification, and which levels (3.8.8, 3.8.9).
#[inline(always)]
fn choose(image: &TextureImage, sampler: &Sampler, lambda: f32) -> Choice {
    let last = image.levels.len() - 1;
    // The switch-over point c: 0.5 where magnification is linear and minification takes the nearest texel of a mipmap.
    let switch = if sampler.mag_linear && !sampler.min_linear && sampler.mip_linear.is_some() { 0.5 } else { 0.0 };
    // `!(>)`: a NaN magnifies.
    if !(lambda > switch) {
        return Choice { level: 0, linear: sampler.mag_linear, blend: 0.0 };
    }
    let linear = sampler.min_linear;
    match sampler.mip_linear {
        None => Choice { level: 0, linear, blend: 0.0 },
        Some(false) => {
            let nearest = if lambda <= 0.5 { 0.0 } else { (lambda + 0.5).ceil() - 1.0 };
            Choice { level: (nearest as usize).min(last), linear, blend: 0.0 }
        }
        Some(true) => {
            let floor = lambda.floor();
            let level = (floor as usize).min(last);
            Choice { level, linear, blend: if level < last { lambda - floor } else { 0.0 } }
        }
    }
}

/// Samples all lanes at one choice's level, and blends with the next level where a lane asks for it.
#[inline(always)]
fn sample_choice<S: simd::Simd>(image: &TextureImage, sampler: &Sampler, choice: Choice, blend: Lanes, position: &Position) -> [Lanes; 4] {
    let mut near = sample_level::<S>(image, sampler, &image.levels[choice.level], choice.linear, position);
    if let Some(next) = image.levels.get(choice.level + 1)
        && blend.iter().any(|b| *b != 0.0)
    {
        let far = sample_level::<S>(image, sampler, next, choice.linear, position);
        for c in 0..4 {
            near[c] = lerp(&near[c], &far[c], &blend);
        }
    }
    near
}

#[inline(always)]
fn lerp(a: &Lanes, b: &Lanes, t: &Lanes) -> Lanes {
    std::array::from_fn(|i| a[i] + t[i] * (b[i] - a[i]))
}

/// Samples one level with one filter.
#[inline(always)]
fn sample_level<S: simd::Simd>(image: &TextureImage, sampler: &Sampler, level: &TextureLevel, linear: bool, p: &Position) -> [Lanes; 4] {
    let (w, h, d) = (level.width as i32, level.height as i32, level.depth as i32);
    let flat = image.kind == TextureKind::D1;
    let mut texels = [[0.0; 4]; LANES];
    if wide_level::<S>(image, sampler, level, linear, p.coord(), &[p.face], from_mut(&mut texels)) {
        return columns::<S>(&texels);
    }
    let fetch = Fetch { level, format: image.format, border: &sampler.border };
    if !linear {
        let x = nearest(&p.s, w, sampler.wrap[0]);
        let y = if flat { [0; LANES] } else { nearest(&p.t, h, sampler.wrap[1]) };
        let z = if image.kind == TextureKind::D3 { nearest(&p.r, d, sampler.wrap[2]) } else { p.face };
        return fetch.scaled(fetch.texels(&x, &y, &z));
    }
    let (x, fx) = linear_axis(&p.s, w, sampler.wrap[0]);
    if flat {
        let y = [0; LANES];
        return fetch.scaled(blend4(fetch.texels(&x[0], &y, &y), fetch.texels(&x[1], &y, &y), &fx));
    }
    let (y, fy) = linear_axis(&p.t, h, sampler.wrap[1]);
    let plane = |z: &Indices| {
        let low = blend4(fetch.texels(&x[0], &y[0], z), fetch.texels(&x[1], &y[0], z), &fx);
        let high = blend4(fetch.texels(&x[0], &y[1], z), fetch.texels(&x[1], &y[1], z), &fx);
        blend4(low, high, &fy)
    };
    if image.kind != TextureKind::D3 {
        return fetch.scaled(plane(&p.face));
    }
    let (z, fz) = linear_axis(&p.r, d, sampler.wrap[2]);
    fetch.scaled(blend4(plane(&z[0]), plane(&z[1]), &fz))
}

#[inline(always)]
fn blend4(a: [Lanes; 4], b: [Lanes; 4], t: &Lanes) -> [Lanes; 4] {
    [lerp(&a[0], &b[0], t), lerp(&a[1], &b[1], t), lerp(&a[2], &b[2], t), lerp(&a[3], &b[3], t)]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::program::lanes::avx2_available;
    use std::sync::Arc;

    fn binding(kind: TextureKind, sizes: &[(u32, u32)], wrap: Wrap) -> TextureBinding {
        let levels = sizes
            .iter()
            .enumerate()
            .map(|(l, &(width, height))| {
                let texels = (0..width * height).map(|i| (i * 37 + l as u32 * 91) & 255 | ((i * 11) & 255) << 8 | 0xff00_0000).collect();
                TextureLevel { width, height, depth: 1, texels: Arc::new(texels) }
            })
            .collect();
        let image = Arc::new(TextureImage { id: 1, kind, format: TexelFormat::Rgba8, levels });
        let sampler = Sampler { wrap: [wrap; 3], border: [0.25, 0.5, 0.75, 0.125], ..Sampler::NEAREST };
        TextureBinding { image, sampler }
    }

    fn at(binding: &TextureBinding, s: f32, t: f32) -> [f32; 4] {
        let texel = Prepared::new(binding, None).group(&[[s; LANES], [t; LANES], [0.0; LANES], [0.0; LANES]], None, Simd::Scalar);
        [0, 1, 2, 3].map(|c| texel[c][3])
    }

    fn red(binding: &TextureBinding, x: u32, y: u32) -> f32 {
        let level = &binding.image.levels[0];
        (level.texels[(y * level.width + x) as usize] & 255) as f32 / 255.0
    }

    #[test]
    fn a_texel_centre_gives_the_texel_under_every_filter_and_wrap() {
        for wrap in [Wrap::Repeat, Wrap::Clamp, Wrap::ClampToEdge, Wrap::ClampToBorder, Wrap::MirroredRepeat] {
            for linear in [false, true] {
                let mut b = binding(TextureKind::D2, &[(8, 4)], wrap);
                b.sampler.mag_linear = linear;
                for (x, y) in [(0, 0), (7, 3), (3, 2)] {
                    let got = at(&b, (x as f32 + 0.5) / 8.0, (y as f32 + 0.5) / 4.0);
                    assert!((got[0] - red(&b, x, y)).abs() < 1e-6, "{wrap:?} linear {linear} at {x}, {y}: {got:?}");
                }
            }
        }
    }

    #[test]
    fn coordinates_outside_wrap_as_the_mode_says() {
        let x = |wrap, s: f32| {
            let b = binding(TextureKind::D2, &[(8, 1)], wrap);
            (at(&b, s, 0.5), b)
        };
        let (got, b) = x(Wrap::Repeat, -0.0625);
        assert!((got[0] - red(&b, 7, 0)).abs() < 1e-6);
        let (got, b) = x(Wrap::ClampToEdge, 1.7);
        assert!((got[0] - red(&b, 7, 0)).abs() < 1e-6);
        let (got, b) = x(Wrap::MirroredRepeat, 1.0625);
        assert!((got[0] - red(&b, 7, 0)).abs() < 1e-6);
        let border = x(Wrap::ClampToBorder, 1.01).0;
        assert!(border.iter().zip([0.25, 0.5, 0.75, 0.125]).all(|(a, b)| (a - b).abs() < 1e-6), "{border:?}");
    }

    #[test]
    fn gl_clamp_blends_with_the_border_at_the_edge() {
        let mut b = binding(TextureKind::D2, &[(8, 8)], Wrap::Clamp);
        b.sampler.mag_linear = true;
        let got = at(&b, 0.0, 0.5 / 8.0);
        assert!((got[0] - 0.5 * (red(&b, 0, 0) + 0.25)).abs() < 1e-6, "{got:?}");
    }

    #[test]
    fn trilinear_filtering_blends_the_levels_around_lambda() {
        let mut b = binding(TextureKind::D2, &[(4, 4), (2, 2), (1, 1)], Wrap::Repeat);
        b.sampler.mip_linear = Some(true);
        let coord = [[0.1; LANES], [0.1; LANES], [0.0; LANES], [0.0; LANES]];
        let slope = 2.0f32.powf(0.5) / 4.0;
        let (dx, dy) = ([[slope; LANES], [0.0; LANES], [0.0; LANES]], [[0.0; LANES]; 3]);
        let got = Prepared::new(&b, None).group(&coord, Some([&dx, &dy]), Simd::Scalar)[0][0];
        let level = |l: usize| (b.image.levels[l].texels[0] & 255) as f32 / 255.0;
        assert!((got - 0.5 * (level(0) + level(1))).abs() < 1e-4, "{got}");
    }

    #[test]
    fn lanes_of_different_levels_each_get_their_own() {
        let mut b = binding(TextureKind::D2, &[(4, 4), (2, 2), (1, 1)], Wrap::Repeat);
        b.sampler.mip_linear = Some(false);
        let coord = [[0.1; LANES], [0.1; LANES], [0.0; LANES], [0.0; LANES]];
        let slopes: Lanes = std::array::from_fn(|i| [0.1, 0.5, 1.0, 9.0][i % 4]);
        let (dx, dy) = ([slopes, [0.0; LANES], [0.0; LANES]], [[0.0; LANES]; 3]);
        let got = Prepared::new(&b, None).group(&coord, Some([&dx, &dy]), Simd::Scalar)[0];
        for (lane, want) in [0usize, 1, 2, 2].into_iter().cycle().take(LANES).enumerate() {
            assert_eq!(got[lane], (b.image.levels[want].texels[0] & 255) as f32 * (1.0 / 255.0), "lane {lane}");
        }
    }

    #[test]
    fn cube_directions_reach_the_face_of_their_largest_component() {
        for (face, direction) in
            [[1.0, 0.1, 0.2], [-1.0, 0.1, 0.2], [0.1, 1.0, 0.2], [0.1, -1.0, 0.2], [0.1, 0.2, 1.0], [0.1, 0.2, -1.0]].iter().enumerate()
        {
            assert_eq!(major_face(*direction), face);
        }
    }

    #[test]
    fn both_simd_levels_give_the_same_bits_even_for_wild_coordinates() {
        if !avx2_available() {
            return;
        }
        let wild = [0.0, -0.0, 1e30, -1e30, f32::NAN, f32::INFINITY, 1e-30, 0.999_999_94];
        for wrap in [Wrap::Repeat, Wrap::Clamp, Wrap::ClampToEdge, Wrap::ClampToBorder, Wrap::MirroredRepeat] {
            for linear in [false, true] {
                let mut b = binding(TextureKind::D2, &[(5, 3), (2, 1), (1, 1)], wrap);
                (b.sampler.mag_linear, b.sampler.min_linear, b.sampler.mip_linear) = (linear, linear, Some(linear));
                for shift in 0..8 {
                    let rotate = |by: usize| std::array::from_fn(|i| wild[(i * by + shift) % 8]);
                    let coord = [rotate(1), rotate(3), rotate(5), rotate(7)];
                    let (dx, dy) = ([rotate(3), rotate(1), rotate(1)], [rotate(5), rotate(2), rotate(2)]);
                    let bits = |simd| Prepared::new(&b, None).group(&coord, Some([&dx, &dy]), simd).map(|c| c.map(f32::to_bits));
                    assert_eq!(bits(Simd::Scalar), bits(Simd::Avx2));
                }
            }
        }
    }
}
