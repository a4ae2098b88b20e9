//! What the pipeline promises: exact coverage, shared edges once, order, the same bits on any number of threads and any
//! SIMD level, with or without a shortcut, and no harm from any coordinate.

use std::sync::Arc;

use bytemuck::Zeroable;

use super::fine::depth;
use super::hi_z::{HiZ, Nearest, Under};
use super::layout::*;
use super::plan::Plan;
use super::simd::{Level, Portable};
use super::store::{BIN_PIXELS, BinPixels, pixel_index};
use super::tile::LocalEdges;
use crate::device::cpu::{CpuDevice, CpuSurface};
use crate::device::samples::positions;
use crate::device::{ColorFormat, DepthFormat, Device, Surface, SurfaceFormat};
use crate::draw::texture::{Sampler, TexelFormat, TextureBinding, TextureImage, TextureKind, TextureLevel, Wrap};
use crate::draw::{Batch, Clear, Draw, Step};
use crate::program::fixed::{Base, FragmentKey, UnitKey, fragment_program};
use crate::program::{Input, Interface, Output, Program, Shortcut, Stage, Varying};

struct Random(u64);

impl Random {
    fn bits(&mut self) -> u32 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 32) as u32
    }
    fn below(&mut self, n: i32) -> i32 {
        (self.bits() % n as u32) as i32
    }
    fn unit(&mut self) -> f32 {
        (self.bits() >> 8) as f32 / 16777216.0
    }
    fn signed(&mut self) -> f32 {
        self.unit() * 2.0 - 1.0
    }
}

/// A triangle with a positive area, or nothing.
fn triangle(mut x: [i32; 3], mut y: [i32; 3], flags: u32) -> Option<Triangle> {
    let area = (x[0] - x[1]) as i64 * (y[2] - y[0]) as i64 - (x[2] - x[0]) as i64 * (y[0] - y[1]) as i64;
    if area < 0 {
        x.swap(0, 1);
        y.swap(0, 1);
    }
    (area != 0).then(|| Triangle { x, y, flags, ..Triangle::default() })
}

/// Whether a triangle covers the centre of pixel (px, py), by the rule itself.
fn covers(t: &Triangle, px: i32, py: i32) -> bool {
    let bottom_up = t.flags & triangle_flags::BOTTOM_UP != 0;
    (0..3).all(|i| {
        let j = (i + 1) % 3;
        let (xi, yi, xj, yj) = (t.x[i] as i128, t.y[i] as i128, t.x[j] as i128, t.y[j] as i128);
        let (x, y) = (px as i128 * 256, py as i128 * 256);
        let e = (yi - yj) * (xi - x) - (xi - xj) * (yi - y);
        // On an edge: left ones are inside, and of the horizontal ones those at the bottom as GL sees them.
        let inclusive = yi < yj || yi == yj && (if bottom_up { xi > xj } else { xi < xj });
        e > 0 || e == 0 && inclusive
    })
}

/// Coverage of the tile at (x, y).
fn coverage(local: &LocalEdges<Portable>, x: i32, y: i32) -> u64 {
    local.rows([x, y], 0).map_or(0, |rows| rows.mask(0, 7))
}

#[test]
fn coverage_is_what_exact_arithmetic_says() {
    let mut random = Random(1);
    for round in 0..4000 {
        // From slivers within a tile to the whole coordinate range; every other one on pixel centres, where ties are.
        let size = [600, 5000, 300_000, 12_582_784][round % 4];
        let least = -size / 3;
        let mut place = || {
            let at = (random.below(size) + least) & if round % 8 < 4 { !0 } else { !0x7f };
            // Also from one end of the range to the other.
            if round % 16 < 12 { at } else { [at, least, least + size][random.below(3) as usize] }
        };
        let (x, y) = ([place(), place(), place()], [place(), place(), place()]);
        let flags = if random.bits() & 1 != 0 { triangle_flags::BOTTOM_UP } else { 0 };
        let Some(t) = triangle(x, y, flags) else { continue };
        for nth in 0..8 {
            let pixels = size / 256 + 1;
            let mut bin = [random.below(pixels) - pixels / 3, random.below(pixels) - pixels / 3];
            if nth % 2 == 0 {
                // A bin that an edge runs through.
                let (i, at) = (random.below(3) as usize, random.unit() as f64);
                bin = [t.x, t.y].map(|v| (v[i] as f64 + at * (v[(i + 1) % 3] - v[i]) as f64) as i32 >> 8);
            }
            let [bx, by] = bin.map(|first| first.max(0) & !63);
            let local = LocalEdges::new(&t, bx, by);
            let (tx, ty) = (random.below(8) * 8, random.below(8) * 8);
            let mask = coverage(&local, tx, ty);
            if size == 600 {
                let square = LocalEdges::<Portable>::new(&t, bx + tx, by + ty).square();
                assert_eq!(square, mask, "{t:?} at {}, {}", bx + tx, by + ty);
            }
            for k in 0..64 {
                let expected = covers(&t, bx + tx + k % 8, by + ty + k / 8);
                assert_eq!(mask >> k & 1 != 0, expected, "{t:?} pixel {k} of the tile at {}, {}", bx + tx, by + ty);
            }
        }
    }
}

#[test]
fn edges_that_triangles_share_are_covered_once() {
    let mut random = Random(2);
    for round in 0..300 {
        // A fan around a point inside a rectangle of 40 x 40 pixels.
        let snap = if round % 2 == 0 { !0 } else { !0x7f };
        let (cx, cy) = ((random.below(39 * 256) + 128) & snap, (random.below(39 * 256) + 128) & snap);
        let side = 40 * 256;
        let mut rim: Vec<(i32, i32)> = vec![(0, 0), (side, 0), (side, side), (0, side)];
        for k in (0..4).rev() {
            let at = random.below(side) & snap;
            rim.insert(k + 1, [(at, 0), (side, at), (side - at, side), (0, side - at)][k]);
        }
        let mut count = [0u8; 64 * 64];
        for k in 0..rim.len() {
            let (a, b) = (rim[k], rim[(k + 1) % rim.len()]);
            let Some(t) = triangle([cx, a.0, b.0], [cy, a.1, b.1], 0) else { continue };
            let local = LocalEdges::new(&t, 0, 0);
            for tile in 0..64 {
                let mask = coverage(&local, tile % 8 * 8, tile / 8 * 8);
                (0..64).for_each(|k| count[((tile / 8 * 8 + k / 8) * 64 + tile % 8 * 8 + k % 8) as usize] += (mask >> k & 1) as u8);
            }
        }
        for y in 0..64 {
            for x in 0..64 {
                // Left and (rows run down) greater y inclusive.
                let inside = (0..40).contains(&x) && (1..41).contains(&y);
                assert_eq!(count[y * 64 + x], inside as u8, "pixel {x}, {y} of fan {round}");
            }
        }
    }
}

fn program(shortcut: Shortcut) -> Arc<Program> {
    let text = "struct FragmentIn { i0: vec4<f32> } struct FragmentOut { color: vec4<f32> } \
                fn fragment_main(in: FragmentIn, base: u32) -> FragmentOut { return FragmentOut(in.i0); }";
    let varying = Varying { front: Output::FrontColor, back: Output::FrontColor, interpolation: interpolation::PERSPECTIVE };
    let interface = Interface { inputs: vec![Input::Varying(0)], varyings: vec![varying], shortcut, ..Default::default() };
    Arc::new(Program::new(Stage::Fragment, text.into(), interface).expect("a program"))
}

/// Draws shaded vertices (clip position, colour) as one draw; returns colour and depth.
fn draw(vertices: &[[[f32; 4]; 2]], topology: u32, flags: u32, threads: usize, level: Level, shortcut: Shortcut) -> (Vec<u32>, Vec<u32>) {
    draw_program(vertices, topology, flags, threads, level, program(shortcut), Vec::new())
}

/// What is drawn on: 200 x 150 pixels, scaled up (and then moved by half a pixel), with samples.
#[derive(Clone, Copy)]
struct Canvas {
    scale: u32,
    samples: u32,
}

/// Draws shaded vertices (clip position, varyings) as one draw; returns colour and depth.
fn draw_program<const STRIDE: usize>(
    vertices: &[[[f32; 4]; STRIDE]],
    topology: u32,
    flags: u32,
    threads: usize,
    level: Level,
    program: Arc<Program>,
    textures: Vec<TextureBinding>,
) -> (Vec<u32>, Vec<u32>) {
    draw_on(Canvas { scale: 1, samples: 1 }, &CpuDevice::with(threads, level), vertices, topology, flags, program, textures)
}

fn draw_on<const STRIDE: usize>(
    canvas: Canvas,
    device: &CpuDevice,
    vertices: &[[[f32; 4]; STRIDE]],
    topology: u32,
    flags: u32,
    program: Arc<Program>,
    textures: Vec<TextureBinding>,
) -> (Vec<u32>, Vec<u32>) {
    let state = if canvas.samples > 1 { raster_flags::MULTISAMPLE } else { 0 };
    draw_state(canvas, device, vertices, topology, [flags, state], &[compare::LEQUAL], program, textures)
}

/// `flags`: of the fragment state and of the raster state. `depth_funcs`: as many parts of the primitives are drawn, each with its
/// comparison, and between them the depth of a part of the surface is cleared.
fn draw_state<const STRIDE: usize>(
    canvas: Canvas,
    device: &CpuDevice,
    vertices: &[[[f32; 4]; STRIDE]],
    topology: u32,
    flags: [u32; 2],
    depth_funcs: &[u32],
    program: Arc<Program>,
    textures: Vec<TextureBinding>,
) -> (Vec<u32>, Vec<u32>) {
    let Canvas { scale, samples } = canvas;
    let (width, height) = (200 * scale, 150 * scale);
    let format = SurfaceFormat { color: ColorFormat::Rgba8, depth: DepthFormat::D24, stencil: true, top_first: true, samples };
    let mut surface = CpuSurface::new(device, device.target(width, height, format));
    let batch = batch(canvas, vertices, topology, flags, depth_funcs, program, textures);
    surface.execute_shaded(&batch, vertices.as_flattened().to_vec());
    let pixels = surface.pixels();
    (pixels.color.to_vec(), pixels.depth_stencil.to_vec())
}

/// What [`draw_state`] draws. A stencil test passes and changes nothing.
fn batch<const STRIDE: usize>(
    Canvas { scale, .. }: Canvas,
    vertices: &[[[f32; 4]; STRIDE]],
    topology: u32,
    flags: [u32; 2],
    depth_funcs: &[u32],
    program: Arc<Program>,
    textures: Vec<TextureBinding>,
) -> Batch {
    let (width, height) = (200 * scale, 150 * scale);
    let mut raster = RasterState::zeroed();
    raster.polygon_mode = [topology::TRIANGLES; 2];
    let (half_width, half_height) = (width as f32 * 0.5, height as f32 * 0.5);
    let moved = if scale > 1 { 0.5 } else { 0.0 };
    raster.viewport_scale = [half_width, -half_height, 0.5];
    raster.viewport_translate = [half_width + moved, half_height + moved, 0.5];
    raster.flags = flags[1];
    raster.scissor_max = [width as i32, height as i32];
    (raster.line_width, raster.point_size) = (3.0, 4.0);
    raster.depth_range = [0.0, 1.0];
    raster.polygon_stipple = NONE;
    let mut state = FragmentState::zeroed();
    (state.flags, state.color_mask) = (flags[0], 15);
    state.stencil = [StencilFace { func: compare::ALWAYS, ..StencilFace::zeroed() }; 2];
    let (s, d) = (blend_factor::SRC_ALPHA, blend_factor::ONE_MINUS_SRC_ALPHA);
    state.blend_factors = [s, d, s, d];
    let mut record = DrawRecord::zeroed();
    (record.vertex_count, record.topology, record.shaded_stride) = (vertices.len() as u32, topology, STRIDE as u32);
    (record.clip_distances, record.point_size, record.varying_count) = (NONE, NONE, STRIDE as u32 - 1);
    for k in 0..STRIDE - 1 {
        record.varyings[k] = ((k as u32 + 1) * 0x101) | (interpolation::PERSPECTIVE << 16);
    }
    let each = topology + 1;
    let count = vertices.len() as u32 / each;
    let parts = depth_funcs.len() as u32;
    let part = |k: u32| count * k / parts..count * (k + 1) / parts;
    let primitive = |draw: u32, k: u32| Primitive { v: std::array::from_fn(|i| k * each + (i as u32).min(topology)), draw_and_flags: draw };
    let all = Clear { min: [0; 2], max: [width as i32, height as i32], color: [0.0; 4], color_mask: 15, depth: Some(1.0), stencil: None };
    // More than a bin, and no bin whole.
    let some = Clear { min: [30, 20], max: [120, 90], color_mask: 0, depth: Some(0.9), ..all };
    let mut batch = Batch { raster_states: vec![raster], textures, ..Batch::default() };
    for (k, &depth_func) in depth_funcs.iter().enumerate() {
        let std::ops::Range { start: first, end } = part(k as u32);
        record.fragment_state = k as u32;
        let program = program.clone();
        batch.draws.push(Draw { record, first_primitive: first, vertex_program: program.clone(), fragment_program: program });
        batch.fragment_states.push(FragmentState { depth_func, ..state });
        batch.primitives.extend((first..end).map(|primitive_of| primitive(k as u32, primitive_of)));
        batch.steps.push(Step::Clear(if k == 0 { all } else { some }));
        batch.steps.push(Step::Primitives { first, end });
    }
    batch
}

fn soup(seed: u64, count: usize, reach: f32) -> Vec<[[f32; 4]; 2]> {
    let mut random = Random(seed);
    let mut vertex = || {
        let w = 0.3 + random.unit();
        let position = [random.signed() * reach * w, random.signed() * reach * w, random.signed() * w, w];
        [position, [random.unit(), random.unit(), random.unit(), random.unit()]]
    };
    (0..count).map(|_| vertex()).collect()
}

const TESTED: u32 = fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE;

#[test]
fn threads_levels_and_shortcuts_give_the_same_bits() {
    for (topology, count) in [(topology::TRIANGLES, 2400), (topology::LINES, 600), (topology::POINTS, 300)] {
        let vertices = soup(3, count, 1.3);
        for flags in [0, TESTED, fragment_flags::BLEND, TESTED | fragment_flags::BLEND] {
            let one = draw(&vertices, topology, flags, 1, Level::Scalar, Shortcut::None);
            assert!(one.0.iter().any(|&c| c != 0));
            for threads in [1, 2, 7] {
                for level in [Level::Scalar, Level::best()] {
                    for shortcut in [Shortcut::None, Shortcut::Varying(0)] {
                        let other = draw(&vertices, topology, flags, threads, level, shortcut);
                        assert!(one == other, "topology {topology}, flags {flags}, {threads} threads, {level:?}, {shortcut:?}");
                    }
                }
            }
        }
    }
}

/// Noise with mipmaps.
/// Triangles of up to some twelve pixels, over all borders of tiles and bins.
fn crumbs(seed: u64, count: usize) -> Vec<[[f32; 4]; 2]> {
    let mut random = Random(seed);
    let mut vertices = Vec::new();
    for _ in 0..count {
        let (at, z, side) = ([random.signed(), random.signed()], random.signed() * 0.9, 0.02 + 0.1 * random.unit());
        for _ in 0..3 {
            let w = 0.5 + random.unit();
            let [x, y] = [at[0] + side * random.signed(), at[1] + side * random.signed()];
            let position = [x * w, y * w, (z + 0.05 * random.signed()) * w, w];
            vertices.push([position, [random.unit(), random.unit(), random.unit(), random.unit()]]);
        }
    }
    vertices
}

#[test]
fn small_triangles_have_the_bits_of_the_general_routine() {
    let vertices = crumbs(9, 4000);
    for samples in [1, 2, 4, 16] {
        for flags in [0, TESTED, fragment_flags::BLEND, TESTED | fragment_flags::BLEND] {
            let one = |level, shortcut| {
                let device = CpuDevice::with(2, level);
                draw_on(Canvas { scale: 1, samples }, &device, &vertices, topology::TRIANGLES, flags, program(shortcut), Vec::new())
            };
            let general = one(Level::Scalar, Shortcut::None);
            for level in [Level::Scalar, Level::best()] {
                assert!(general == one(level, Shortcut::Varying(0)), "flags {flags}, {samples} samples, {level:?}");
            }
        }
    }
}

/// Triangles of all sizes in many layers, each at about one depth.
fn layers(seed: u64, count: usize) -> Vec<[[f32; 4]; 2]> {
    let mut random = Random(seed);
    let mut vertices = Vec::new();
    for k in 0..count {
        let (at, z, side) = ([random.signed(), random.signed()], random.signed() * 0.9, [0.05, 0.2, 0.6][k % 3] * (0.5 + random.unit()));
        for _ in 0..3 {
            let w = 0.5 + random.unit();
            let [x, y] = at.map(|at| at + side * random.signed());
            vertices
                .push([[x * w, y * w, (z + 0.05 * random.signed()) * w, w], [random.unit(), random.unit(), random.unit(), random.unit()]]);
        }
    }
    vertices
}

#[test]
fn what_lies_behind_is_left_out_without_a_trace() {
    use compare::*;
    let vertices = layers(11, 3000);
    for samples in [1, 2, 4] {
        let state = if samples > 1 { raster_flags::MULTISAMPLE } else { 0 };
        // Comparisons that let depths grow, between others that do not.
        for depth_funcs in [&[LEQUAL][..], &[LESS, GREATER, LESS, ALWAYS, LEQUAL], &[LESS, LESS, EQUAL, LESS]] {
            for flags in [TESTED, TESTED | fragment_flags::BLEND, fragment_flags::DEPTH_TEST] {
                let one = |level, shortcut, stencil| {
                    let device = CpuDevice::with(2, level);
                    let flags = [flags | stencil, state];
                    draw_state(
                        Canvas { scale: 1, samples },
                        &device,
                        &vertices,
                        topology::TRIANGLES,
                        flags,
                        depth_funcs,
                        program(shortcut),
                        Vec::new(),
                    )
                };
                // Under a stencil test nothing is left out.
                let all = one(Level::best(), Shortcut::Varying(0), fragment_flags::STENCIL_TEST);
                assert!(all.0.iter().any(|&c| c != 0));
                for level in [Level::Scalar, Level::best()] {
                    for shortcut in [Shortcut::None, Shortcut::Varying(0)] {
                        assert!(
                            all == one(level, shortcut, 0),
                            "{samples} samples, {depth_funcs:?}, flags {flags}, {level:?}, {shortcut:?}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn only_what_fails_at_every_sample_is_hidden() {
    const SAMPLES: u32 = 4;
    const FUNCS: [u32; 2] = [compare::LESS, compare::LEQUAL];
    let mut random = Random(12);
    let format = SurfaceFormat { color: ColorFormat::Rgba8, depth: DepthFormat::D24, stencil: true, top_first: true, samples: SAMPLES };
    let odd = [0.0, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, 1e30, -1e30, f32::MAX];
    let (mut hidden, mut seen) = ([0; 2], [0; 2]);
    let canvas = Canvas { scale: 1, samples: SAMPLES };
    let batches = FUNCS.map(|func| {
        let program = program(Shortcut::Varying(0));
        batch(canvas, &soup(1, 3, 1.0), topology::TRIANGLES, [TESTED, raster_flags::MULTISAMPLE], &[func], program, Vec::new())
    });
    for round in 0..1500 {
        let func = FUNCS[round % 2];
        let plan = Plan::new(&batches[round % 2], 0, format);
        let origin = [64 * random.below(3), 64 * random.below(3)];
        // Depths around a level, of which the plane of the triangle is somewhere near, with a stencil value that must not count.
        let level = random.unit();
        let mut words: Vec<u32> = (0..SAMPLES as usize * BIN_PIXELS)
            .map(|_| ((level * 0.9 + 0.1 * random.unit()) * 16777215.0) as u32 | random.bits() & 0xff00_0000)
            .collect();
        let slopes = [random.signed(), random.signed()].map(|s| s * [0.0, 1e-5, 1e-3][round % 3]);
        let a0 = level + 0.2 * random.signed() - (0..2).map(|k| slopes[k] * (origin[k] + 32) as f32).sum::<f32>();
        let mut planes = [[a0, slopes[0], slopes[1], 1.0], [0.0, 0.0, 1e-4 * random.signed(), 0.0]];
        if round % 8 == 0 {
            planes[0][random.below(3) as usize] = odd[random.below(odd.len() as i32) as usize];
        }
        let small = round % 5 < 2;
        let mut span = |origin: i32| {
            let first = (origin - 7 + random.below(64 + 7)).max(0);
            let last = first.max(origin) + random.below(8);
            (first as u32, if small { last.min(first + 7) } else { last + random.below(64) } as u32)
        };
        let (columns, rows) = (span(origin[0]), span(origin[1]));
        let t = Triangle { columns: columns.0 | columns.1 << 16, rows: rows.0 | rows.1 << 16, ..Triangle::default() };
        let bin = BinPixels { origin, color: &mut [], depth_stencil: &mut words };
        let mut hi_z = HiZ::default();
        // Tiles that are hidden, of those that there are.
        let mut tiles = [0u32; 8];
        if small {
            let behind = hi_z.hides::<Portable>(&plan, &t, &planes, &Under::new(&t, origin), &bin);
            tiles = [if behind { 0xff } else { 0 }; 8];
        } else {
            let near = Nearest::<Portable>::new(&plan, &t, &planes, origin);
            for (ty, tiles) in tiles.iter_mut().enumerate() {
                *tiles = !hi_z.visible::<Portable>(&plan, &planes, &near, 0xff, ty as i32, &bin) & 0xff;
            }
        }
        for (y, x) in (0..64).flat_map(|y| (0..64).step_by(8).map(move |x| (y, x))) {
            let (px, py) = (origin[0] + x, origin[1] + y);
            if py < rows.0 as i32 || py > rows.1 as i32 || px + 7 < columns.0 as i32 || px > columns.1 as i32 {
                continue;
            }
            if tiles[y as usize / 8] >> (x / 8) & 1 == 0 {
                seen[small as usize] += 1;
                continue;
            }
            hidden[small as usize] += 1;
            for (s, [dx, dy]) in positions(SAMPLES).iter().enumerate() {
                let at = std::array::from_fn(|k| (px + k as i32) as f32 + plan.centre + *dx as f32 / 16.0);
                let z = depth::<Portable>(&plan, &planes, at, [py as f32 + plan.centre + *dy as f32 / 16.0; 8]);
                for (k, z) in z.into_iter().enumerate() {
                    let inside = (columns.0 as i32..=columns.1 as i32).contains(&(px + k as i32));
                    let word = (bin.depth_stencil[s * BIN_PIXELS + pixel_index(x as u32 + k as u32, y as u32)] & 0xff_ffff) as i32;
                    let passes = if func == compare::LESS { z < word } else { z <= word };
                    assert!(!(inside && passes), "round {round}: {planes:?} at {} {py}, sample {s}: {z}, {word}", px + k as i32);
                }
            }
        }
    }
    assert!(hidden.iter().chain(&seen).all(|&n| n > 500), "hidden {hidden:?}, seen {seen:?}");
}

fn noise_texture(size: [u32; 2], filters: (bool, bool, Option<bool>), wrap: Wrap) -> TextureBinding {
    let mut random = Random(6);
    let mut level = |k: u32| {
        let [width, height] = size.map(|n| (n >> k).max(1));
        TextureLevel { width, height, depth: 1, texels: Arc::new((0..width * height).map(|_| random.bits()).collect()) }
    };
    let levels = (0..=size[0].max(size[1]).ilog2()).map(&mut level).collect();
    let image = TextureImage { id: 1, kind: TextureKind::D2, format: TexelFormat::Rgba8, levels };
    let (mag_linear, min_linear, mip_linear) = filters;
    let (lod_range, border) = ([-1000.0, 1000.0], [0.5; 4]);
    let sampler = Sampler { wrap: [wrap; 3], mag_linear, min_linear, mip_linear, lod_range, lod_bias: 0.0, border };
    TextureBinding { image: Arc::new(image), sampler }
}

#[test]
fn a_modulated_texture_has_the_bits_of_its_program() {
    let mut random = Random(7);
    // Every other triangle with a q of its own.
    let with_coordinates = |(k, [position, color]): (usize, [[f32; 4]; 2])| {
        let q = if k / 3 % 2 == 0 { 0.5 + random.unit() } else { 1.0 };
        [position, [random.signed() * 3.0, random.signed() * 9.0, 0.0, q], color]
    };
    // Large triangles, and small ones, of which many wait together.
    let mut soup: Vec<_> = soup(8, 300, 1.3).into_iter().chain(soup(9, 6000, 0.1)).enumerate().map(with_coordinates).collect();
    for vertex in soup.iter_mut().skip(300).step_by(3) {
        vertex[0][0] += vertex[0][3] * 0.5;
    }
    // With the routine of one texture, with depth and without, and with the general one.
    let blended = TESTED | fragment_flags::BLEND;
    for (flags, lod, base, filters, wrap) in [
        (TESTED, true, Base::Rgba, (true, true, Some(true)), Wrap::Repeat),
        (0, true, Base::Rgb, (true, true, Some(true)), Wrap::Clamp),
        (TESTED, true, Base::Alpha, (true, false, Some(false)), Wrap::MirroredRepeat),
        (blended, true, Base::Rgba, (false, false, Some(true)), Wrap::ClampToEdge),
        (TESTED, false, Base::Rgba, (true, true, None), Wrap::Repeat),
        (0, false, Base::Alpha, (true, true, None), Wrap::ClampToEdge),
        (TESTED, false, Base::Rgba, (true, true, None), Wrap::MirroredRepeat),
        (0, false, Base::Luminance, (false, false, None), Wrap::ClampToBorder),
        (blended, true, Base::Rgba, (true, true, Some(true)), Wrap::Repeat),
    ] {
        let mut key = FragmentKey::default();
        key.units[0] = UnitKey { enabled: true, lod, base, ..UnitKey::default() };
        let short = fragment_program(&key).program.clone();
        assert!(matches!(short.shortcut, Shortcut::Modulate(_)));
        let interface = Interface {
            inputs: short.inputs.clone(),
            varyings: short.varyings.clone(),
            texture_slots: short.texture_slots,
            ..Interface::default()
        };
        let full = Arc::new(Program::new(Stage::Fragment, short.wgsl.clone(), interface).expect("a program"));
        let texture = noise_texture([32, 8], filters, wrap);
        let run = |program: &Arc<Program>, device: &CpuDevice| {
            let canvas = Canvas { scale: 1, samples: 1 };
            draw_on(canvas, device, &soup, topology::TRIANGLES, flags, program.clone(), vec![texture.clone()])
        };
        let one = run(&full, &CpuDevice::with(2, Level::Scalar));
        assert!(one.0.iter().any(|&c| c != 0));
        for level in [Level::Scalar, Level::best()] {
            let device = CpuDevice::with(2, level);
            // The second time its texture may be unpacked.
            for program in [&full, &short, &short] {
                assert!(one == run(program, &device), "flags {flags}, {base:?}, filters {filters:?}, {wrap:?}, {level:?}");
            }
        }
    }
}

#[test]
fn colour_is_copied_to_any_rows() {
    let (width, height) = (150u32, 70u32);
    let format = SurfaceFormat { color: ColorFormat::Rgba8, depth: DepthFormat::D24, stencil: true, top_first: true, samples: 1 };
    let device = CpuDevice::with(2, Level::best());
    let mut surface = CpuSurface::new(&device, device.target(width, height, format));
    let mut random = Random(10);
    surface.pixels().color.iter_mut().for_each(|c| *c = random.bits());
    // Once from the pixels that were changed, once from the store.
    for drawn in [false, true] {
        if drawn {
            let clear = Clear { min: [3, 5], max: [90, 66], color: [1.0; 4], color_mask: 15, depth: None, stencil: None };
            surface.execute(Batch { steps: vec![Step::Clear(clear)], ..Batch::default() });
        }
        for (stride, bottom_up) in [(600, false), (600, true), (640, true)] {
            let mut out = vec![7u8; 69 * stride + 600];
            surface.copy_color(&mut out, stride, bottom_up);
            let pixels = surface.pixels();
            for y in 0..height as usize {
                let line = if bottom_up { 69 - y } else { y };
                let row: &[u8] = bytemuck::cast_slice(&pixels.color[y * 150..][..150]);
                assert!(out[line * stride..][..600] == *row, "row {y}, stride {stride}");
                assert!(out[line * stride + 600..].iter().take(stride - 600).all(|&b| b == 7));
            }
            drop(pixels);
            // A batch may copy what it has drawn.
            let clear = Clear { min: [50, 7], max: [140, 69], color: [0.5; 4], color_mask: 15, depth: None, stencil: None };
            let mut at_once = vec![7u8; out.len()];
            surface.execute_and_copy(Batch { steps: vec![Step::Clear(clear)], ..Batch::default() }, &mut at_once, stride, bottom_up);
            surface.copy_color(&mut out, stride, bottom_up);
            assert!(out == at_once, "stride {stride}");
        }
    }
}

#[test]
fn the_last_primitive_is_on_top() {
    let mut vertices = soup(4, 3000, 1.0);
    let corner = |x: f32, y: f32| [[x, y, 0.0, 1.0], [1.0, 0.0, 0.0, 1.0]];
    vertices.extend([corner(-1.0, -1.0), corner(3.0, -1.0), corner(-1.0, 3.0)]);
    let (color, _) = draw(&vertices, topology::TRIANGLES, 0, 7, Level::best(), Shortcut::Varying(0));
    assert!(color.iter().all(|&c| c == 0xff00_00ff));
}

#[test]
fn no_coordinate_does_harm() {
    let odd = [0.0, -0.0, 1.0, -1.0, 1e-38, 1e30, -1e30, f32::MAX, f32::INFINITY, f32::NEG_INFINITY, f32::NAN, 16777216.0, 1.5];
    let mut random = Random(5);
    let mut value = || odd[random.below(odd.len() as i32) as usize];
    let vertices: Vec<_> = (0..6000).map(|_| [[value(), value(), value(), value()], [value(), value(), value(), value()]]).collect();
    for topology in [topology::POINTS, topology::LINES, topology::TRIANGLES] {
        let one = draw(&vertices, topology, TESTED | fragment_flags::BLEND, 2, Level::Scalar, Shortcut::None);
        assert!(one == draw(&vertices, topology, TESTED | fragment_flags::BLEND, 1, Level::best(), Shortcut::Varying(0)));
    }
}

/// Triangles whose corners lie on the grid of subpixels, some of them long and thin.
fn on_the_grid(seed: u64, count: usize) -> Vec<[[f32; 4]; 2]> {
    let mut random = Random(seed);
    let mut vertices = Vec::new();
    for k in 0..count {
        let side = [400, 3000, 200 * 256][k % 3];
        let corner = [random.below(200 * 256 - side + 1), random.below((150 * 256 - side).max(1))];
        for _ in 0..3 {
            let [x, y] = corner.map(|c| c + random.below(side));
            let (x, y) = (x as f32 / 256.0 / 100.0 - 1.0, 1.0 - (y.min(150 * 256) as f32) / 256.0 / 75.0);
            vertices.push([[x, y, random.signed(), 1.0], [1.0; 4]]);
        }
    }
    vertices
}

#[test]
fn samples_are_covered_as_the_places_where_they_lie() {
    let device = CpuDevice::with(2, Level::best());
    for seed in 0..4 {
        let vertices = on_the_grid(seed, 6);
        let one = |canvas, shortcut| draw_on(canvas, &device, &vertices, topology::TRIANGLES, 0, program(shortcut), Vec::new()).0;
        // A sixteenth of a pixel is a pixel here, and places of samples are their centres.
        let fine = one(Canvas { scale: 16, samples: 1 }, Shortcut::Varying(0));
        for samples in [2, 4, 8, 16] {
            for shortcut in [Shortcut::None, Shortcut::Varying(0)] {
                let colors = one(Canvas { scale: 1, samples }, shortcut);
                for (s, [x, y]) in positions(samples).iter().enumerate() {
                    for pixel in 0..200 * 150 {
                        let at = [(pixel % 200 * 16 + 8 + x) as usize, (pixel / 200 * 16 + 8 + y) as usize];
                        let (sample, place) = (colors[s * 200 * 150 + pixel as usize], fine[at[1] * 3200 + at[0]]);
                        assert_eq!(sample != 0, place != 0, "sample {s} of {samples} of pixel {} {}", pixel % 200, pixel / 200);
                    }
                }
            }
        }
    }
}

#[test]
fn without_multisampling_all_samples_are_the_pixel() {
    let vertices = soup(5, 600, 1.3);
    let flags = TESTED | fragment_flags::BLEND;
    let (color, depth) = draw(&vertices, topology::TRIANGLES, flags, 2, Level::best(), Shortcut::None);
    let device = CpuDevice::with(2, Level::best());
    let canvas = Canvas { scale: 1, samples: 4 };
    let (colors, depths) =
        draw_state(canvas, &device, &vertices, topology::TRIANGLES, [flags, 0], &[compare::LEQUAL], program(Shortcut::None), Vec::new());
    for s in 0..4 {
        assert!(colors[s * color.len()..][..color.len()] == color);
        assert!(depths[s * depth.len()..][..depth.len()] == depth);
    }
}
