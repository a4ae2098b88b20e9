//! The kernels against the CPU executor: the same batch, the same pixels.

use std::sync::Arc;

use bytemuck::Zeroable;

use super::{Config, GpuDevice};
use crate::device::cpu::CpuDevice;
use crate::device::{ColorFormat, DepthFormat, Device, Surface, SurfaceFormat};
use crate::draw::texture::{Sampler, TexelFormat, TextureBinding, TextureImage, TextureKind, TextureLevel, Wrap};
use crate::draw::{Batch, Clear, Draw, Step};
use crate::program::{Input, Interface, Output, Program, Stage, Varying};
use crate::raster::layout::*;

const FORMAT: SurfaceFormat =
    SurfaceFormat { color: ColorFormat::Rgba8, depth: DepthFormat::D24, stencil: true, top_first: true, samples: 1 };

/// Numbers that are the same on every run.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (self.0 >> 40) as f32 / (1u64 << 24) as f32
    }
    fn range(&mut self, a: f32, b: f32) -> f32 {
        a + (b - a) * self.next()
    }
    fn below(&mut self, n: u32) -> u32 {
        (self.next() * n as f32) as u32 % n
    }
}

/// Position and colour go through; the fragment's colour is the varying, changed by the uniform block.
fn programs() -> (Arc<Program>, Arc<Program>) {
    let vertex = "struct VertexIn { a0: vec4<f32>, a3: vec4<f32> }
struct VertexOut { position: vec4<f32>, o0: vec4<f32> }
fn vertex_main(in: VertexIn, base: u32) -> VertexOut { return VertexOut(in.a0, in.a3); }";
    let fragment = "struct FragmentIn { i0: vec4<f32> }
struct FragmentOut { color: vec4<f32> }
fn fragment_main(in: FragmentIn, base: u32) -> FragmentOut { return FragmentOut(in.i0 * uniforms[base]); }";
    let outputs = Interface { attributes: 1 | 1 << 3, outputs: vec![Output::FrontColor], ..Interface::default() };
    let inputs = Interface {
        inputs: vec![Input::Varying(0)],
        varyings: vec![Varying { front: Output::FrontColor, back: Output::FrontColor, interpolation: interpolation::PERSPECTIVE }],
        uniform_vec4: 1,
        ..Interface::default()
    };
    let vertex = Program::new(Stage::Vertex, vertex.into(), outputs).expect("a vertex program");
    let fragment = Program::new(Stage::Fragment, fragment.into(), inputs).expect("a fragment program");
    (Arc::new(vertex), Arc::new(fragment))
}

/// The first two components of the varying are texture coordinates, three times around.
fn textured() -> Arc<Program> {
    let fragment = "struct FragmentIn { i0: vec4<f32>, i1: vec4<f32>, i2: vec4<f32>, i3: vec4<f32> }
struct FragmentOut { color: vec4<f32> }
fn fragment_main(in: FragmentIn, base: u32) -> FragmentOut {
    let coord = in.i0 * 3.0 - 1.0;
    return FragmentOut(texture_sample(0u, coord, (in.i2 - in.i1) * 3.0, (in.i3 - in.i1) * 3.0));
}";
    let inputs = Interface {
        inputs: vec![Input::Varying(0), Input::Quad(0, 0), Input::Quad(0, 1), Input::Quad(0, 2)],
        varyings: vec![Varying { front: Output::FrontColor, back: Output::FrontColor, interpolation: interpolation::PERSPECTIVE }],
        texture_slots: 1,
        ..Interface::default()
    };
    Arc::new(Program::new(Stage::Fragment, fragment.into(), inputs).expect("a fragment program"))
}

fn raster_state(width: u32, height: u32) -> RasterState {
    let (w, h) = (width as f32 * 0.5, height as f32 * 0.5);
    RasterState {
        flags: raster_flags::FRONT_CCW,
        polygon_mode: [topology::TRIANGLES; 2],
        viewport_scale: [w, -h, 0.5],
        viewport_translate: [w, h, 0.5],
        scissor_max: [width as i32, height as i32],
        line_width: 1.0,
        point_size: 1.0,
        depth_range: [0.0, 1.0],
        polygon_stipple: NONE,
        ..RasterState::zeroed()
    }
}

fn fragment_state() -> FragmentState {
    FragmentState { color_mask: 15, depth_func: compare::LESS, blend_factors: [4, 5, 4, 5], ..FragmentState::zeroed() }
}

/// A batch under construction.
struct Builder {
    batch: Batch,
    programs: (Arc<Program>, Arc<Program>),
}

impl Builder {
    fn new(width: u32, height: u32) -> Builder {
        let mut batch = Batch::default();
        batch.raster_states.push(raster_state(width, height));
        batch.uniforms.push([1.0; 4]);
        let clear = Clear {
            min: [0; 2],
            max: [width as i32, height as i32],
            color: [0.1, 0.2, 0.3, 1.0],
            color_mask: 15,
            depth: Some(1.0),
            stencil: Some((3, 255)),
        };
        batch.steps.push(Step::Clear(clear));
        Builder { batch, programs: programs() }
    }

    /// A draw of primitives of one topology: 8 floats a vertex.
    fn draw(&mut self, topology: u32, vertices: &[[f32; 8]], raster: u32, fragment: FragmentState) {
        let b = &mut self.batch;
        let mut record = DrawRecord::zeroed();
        record.vertex_word = b.vertices.len() as u32;
        record.vertex_stride = 8;
        record.vertex_count = vertices.len() as u32;
        record.topology = topology;
        record.attribute_offset = [NONE; ATTRIBUTES];
        (record.attribute_offset[0], record.attribute_size[0]) = (0, 4);
        (record.attribute_offset[3], record.attribute_size[3]) = (4, 4);
        record.raster_state = raster;
        record.fragment_state = b.fragment_states.len() as u32;
        record.shaded_base = b.shaded_vec4;
        record.shaded_stride = 2;
        record.clip_distances = NONE;
        record.point_size = NONE;
        record.varying_count = 1;
        record.varyings[0] = 1 | 1 << 8 | interpolation::PERSPECTIVE << 16;
        b.shaded_vec4 += 2 * record.vertex_count;
        b.fragment_states.push(fragment);
        b.vertices.extend_from_slice(vertices.as_flattened());
        let first = b.primitives.len() as u32;
        let n = topology + 1;
        let draw = b.draws.len() as u32;
        for k in 0..record.vertex_count / n {
            let v = [k * n, k * n + 1.min(n - 1), k * n + 2.min(n - 1)];
            b.primitives.push(Primitive { v, draw_and_flags: draw | PRIM_EDGE_01 | PRIM_EDGE_12 | PRIM_EDGE_20 });
        }
        b.steps.push(Step::Primitives { first, end: b.primitives.len() as u32 });
        b.draws.push(Draw {
            record,
            first_primitive: first,
            vertex_program: self.programs.0.clone(),
            fragment_program: self.programs.1.clone(),
        });
    }
}

/// Triangles of all sizes, some off the screen.
fn soup(random: &mut Random, count: u32, size: f32, perspective: bool) -> Vec<[f32; 8]> {
    let mut vertices = Vec::new();
    for _ in 0..count {
        let (cx, cy, cz) = (random.range(-1.1, 1.1), random.range(-1.1, 1.1), random.range(-0.8, 0.8));
        let s = size * random.range(0.05, 1.0);
        for _ in 0..3 {
            let w = if perspective { random.range(0.5, 3.0) } else { 1.0 };
            let p = [cx + random.range(-s, s), cy + random.range(-s, s), cz + random.range(-0.2, 0.2)].map(|v| v * w);
            vertices.push([p[0], p[1], p[2], w, random.next(), random.next(), random.next(), random.next()]);
        }
    }
    vertices
}

/// What a surface holds.
struct Drawn {
    color: Vec<u32>,
    depth_stencil: Vec<u32>,
}

impl Drawn {
    fn of(surface: &mut dyn Surface) -> Drawn {
        let pixels = surface.pixels();
        Drawn { color: pixels.color.to_vec(), depth_stencil: pixels.depth_stencil.to_vec() }
    }
}

fn run(device: &dyn Device, batch: &Batch, size: [u32; 2], format: SurfaceFormat) -> Drawn {
    let mut surface = device.surface(size[0], size[1], format);
    surface.execute(batch.clone());
    Drawn::of(&mut *surface)
}

/// The kernels from vertices on, as a GPU runs them.
fn kernels() -> Result<GpuDevice, String> {
    GpuDevice::with(|config| config.shape.host_front = false)
}

/// The shape that GPUs have, but for arithmetic.
fn on_gpu(config: &mut Config, lanes: u32) {
    let shape = &mut config.shape;
    (shape.fine_lanes, shape.list_lanes, shape.subgroup8, shape.texel_pairs) = (lanes, 64, false, false);
}

/// Keys of triangles that the host has set up, whatever their size and number.
fn keys_by_host(config: &mut Config) {
    (config.shape.host_front, config.visible_from) = (true, 1);
    (config.visible_pixels, config.visible_area) = (u64::MAX, u64::MAX);
}

/// Every way in which the kernels are put together: who sets up, lists or keys, wide and narrow workgroups, buffers that are too small.
fn all_ways() -> Vec<(&'static str, Result<GpuDevice, String>)> {
    let with = |change: fn(&mut Config)| {
        GpuDevice::with(|config| {
            config.shape.host_front = false;
            (config.visible_from, config.direct_upto, config.soup_from) = (u32::MAX, 0, u64::MAX);
            change(config);
        })
    };
    vec![
        ("set up by the host", with(|c| c.shape.host_front = true)),
        ("set up by the host, keys", with(keys_by_host)),
        ("lists", with(|_| ())),
        ("keys", with(|c| c.visible_from = 1)),
        ("keys in little memory", with(|c| (c.visible_from, c.buffer_limit) = (1, 60_000))),
        ("lists in little memory", with(|c| c.buffer_limit = 30_000)),
        (
            "32 lanes in little memory",
            with(|c| {
                on_gpu(c, 32);
                c.buffer_limit = 30_000;
            }),
        ),
        (
            "keys, 32 lanes",
            with(|c| {
                on_gpu(c, 32);
                c.visible_from = 1;
            }),
        ),
        (
            "keys, 32 lanes in little memory",
            with(|c| {
                on_gpu(c, 32);
                (c.visible_from, c.buffer_limit) = (1, 60_000);
            }),
        ),
        ("32 lanes, as on a GPU", with(|c| on_gpu(c, 32))),
        ("64 lanes, as on a GPU", with(|c| on_gpu(c, 64))),
        (
            "32 lanes, no lists",
            with(|c| {
                on_gpu(c, 32);
                c.direct_upto = u32::MAX;
            }),
        ),
        (
            "64 lanes, no lists, in little memory",
            with(|c| {
                on_gpu(c, 64);
                (c.direct_upto, c.buffer_limit) = (200, 30_000);
            }),
        ),
        ("keys in bands of rows", with(|c| (c.visible_from, c.budget) = (1, 250_000))),
        ("keys, vertices where they are wanted", with(|c| (c.visible_from, c.soup_from) = (1, 0))),
        ("keys in bands of rows, vertices where they are wanted", with(|c| (c.visible_from, c.soup_from, c.budget) = (1, 0, 150_000))),
        (
            "keys in bands of rows, 32 lanes",
            with(|c| {
                on_gpu(c, 32);
                (c.visible_from, c.budget) = (1, 250_000);
            }),
        ),
        ("lists and vertices in slices", with(|c| c.budget = 100_000)),
        (
            "vertices in slices, no lists",
            with(|c| {
                on_gpu(c, 32);
                (c.budget, c.direct_upto) = (40_000, 100);
            }),
        ),
        ("8 lanes, no subgroups", with(|c| c.shape.subgroup8 = false)),
        ("no wide integers", with(|c| c.shape.int64 = false)),
        (
            "32 lanes, no wide integers",
            with(|c| {
                on_gpu(c, 32);
                c.shape.int64 = false;
            }),
        ),
        ("32 triangles a round", with(|c| c.shape.round_blocks = 1)),
    ]
}

/// The executors' differences: pixels whose depth differs by more than one unit, whose stencil differs, and the greatest difference of a colour byte.
fn compare_executors(batch: &Batch, size: [u32; 2], format: SurfaceFormat) {
    let Ok(gpu) = kernels() else {
        // No Vulkan at all: nothing to compare. CI has lavapipe.
        return;
    };
    compare_with(&gpu, batch, size, format);
}

fn compare_with(gpu: &GpuDevice, batch: &Batch, size: [u32; 2], format: SurfaceFormat) {
    let color = compare_clears_with(gpu, batch, size, format);
    assert!(color.iter().any(|&c| c != color[0]), "something was drawn");
}

/// The same where nothing need be drawn; returns the colour words.
fn compare_clears_with(gpu: &GpuDevice, batch: &Batch, size: [u32; 2], format: SurfaceFormat) -> Vec<u32> {
    let a = run(&CpuDevice::new(), batch, size, format);
    let b = run(gpu, batch, size, format);
    for (k, (x, y)) in a.depth_stencil.iter().zip(&b.depth_stencil).enumerate() {
        let at = [k as u32 % size[0], k as u32 / size[0]];
        if format.depth.is_float() {
            assert_eq!(x, y, "depth at {at:?}");
            continue;
        }
        assert_eq!(x >> 24, y >> 24, "stencil at {at:?}");
        assert!((x & 0xff_ffff).abs_diff(y & 0xff_ffff) <= 1, "depth at {at:?}: {x:#x} on the CPU, {y:#x} on the GPU");
    }
    let words = format.color.words();
    for (k, (x, y)) in a.color.iter().zip(&b.color).enumerate() {
        let at = [(k / words) as u32 % size[0], (k / words) as u32 / size[0]];
        for c in 0..4 {
            let (x, y) = (x >> (8 * c) & 255, y >> (8 * c) & 255);
            assert!(x.abs_diff(y) <= 1, "component {c} at {at:?}: {x} on the CPU, {y} on the GPU");
        }
    }
    a.color
}

#[test]
fn triangles_of_all_sizes_agree_in_every_pixel() {
    let size = [300, 200];
    let mut random = Random(1);
    let mut builder = Builder::new(size[0], size[1]);
    let depth = FragmentState { flags: fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE, ..fragment_state() };
    for s in [0.01, 0.1, 0.5, 3.0] {
        let vertices = soup(&mut random, 200, s, s > 0.1);
        builder.draw(topology::TRIANGLES, &vertices, 0, depth);
    }
    for (way, gpu) in all_ways() {
        let Ok(gpu) = gpu else { return };
        eprintln!("{way}");
        compare_with(&gpu, &builder.batch, size, FORMAT);
    }
}

#[test]
fn a_budget_bounds_what_lies_between_the_input_and_the_pixels() {
    let size = [300, 200];
    let mut random = Random(5);
    let depth = fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE;
    let inside = |mut v: [f32; 8]| {
        // Nothing is clipped: what clipping makes comes on top.
        v[..3].iter_mut().for_each(|x| *x = x.clamp(-0.95, 0.95));
        v
    };
    let vertices: Vec<_> = soup(&mut random, 600, 0.2, false).into_iter().map(inside).collect();
    let gpu = GpuDevice::with(|config| {
        on_gpu(config, 32);
        (config.shape.host_front, config.visible_from) = (false, 1);
    });
    let Ok(gpu) = gpu else { return };
    // Vertices one after the other, or from all over the draw: then all are shaded at once, whatever they take.
    let blend = fragment_flags::BLEND;
    for (flags, step, budgets) in [(depth, 1, [150_000, 100_000]), (blend, 1, [80_000, 40_000]), (blend, 607, [100_000, 40_000])] {
        let mut builder = Builder::new(size[0], size[1]);
        builder.draw(topology::TRIANGLES, &vertices, 0, FragmentState { flags, ..fragment_state() });
        let count = vertices.len() as u32;
        builder.batch.primitives.iter_mut().for_each(|p| p.v = p.v.map(|v| v * step % count));
        let expected = run(&CpuDevice::new(), &builder.batch, size, FORMAT);
        let draw = |budget: Option<u64>| {
            let mut surface = gpu.gpu_surface(size[0], size[1], FORMAT).expect("a surface of a usual size");
            budget.into_iter().for_each(|bytes| surface.set_budget(bytes));
            surface.execute(builder.batch.clone());
            let drawn = Drawn::of(&mut surface);
            let input = ["uniforms", "vertices", "primitives"];
            let between = surface.memory().iter().filter(|(name, _)| !input.contains(name)).map(|m| m.1).sum::<u64>();
            (drawn, between)
        };
        let (_, unbounded) = draw(None);
        for budget in budgets {
            let (drawn, between) = draw(Some(budget));
            let most = if step == 1 { budget } else { budget + count as u64 * 32 };
            assert!(between <= most && most < unbounded, "{between} bytes of {budget}, {unbounded} without a budget");
            assert!(drawn.color == expected.color && drawn.depth_stencil == expected.depth_stencil, "another picture in {budget} bytes");
        }
    }
}

#[test]
fn triangles_from_one_end_of_the_coordinates_to_the_other_agree() {
    let size = [200, 150];
    let depth = FragmentState { flags: fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE, ..fragment_state() };
    // The first pixel of a viewport of 16384 x 16384: the surface sees its end, its middle, its start.
    for first in [[-16184.0f32, -16234.0], [-8000.0, -16234.0], [-16184.0, 100.0], [0.0, 0.0]] {
        let mut random = Random(11);
        let mut builder = Builder::new(size[0], size[1]);
        let state = &mut builder.batch.raster_states[0];
        (state.viewport_scale, state.viewport_translate) = ([8192.0, 8192.0, 0.5], [first[0] + 8192.0, first[1] + 8192.0, 0.5]);
        let mut vertices = Vec::new();
        for _ in 0..60 {
            // One corner on the surface, the others at the borders of the viewport.
            let seen = [random.range(0.0, 200.0), random.range(0.0, 150.0)];
            let seen = [0, 1].map(|k| (seen[k] - first[k]) / 8192.0 - 1.0).map(|v| v.clamp(-1.0, 1.0));
            for corner in 0..3 {
                let mut border = || [-1.0, 1.0, random.range(-1.0, 1.0)][random.below(3) as usize];
                let [x, y] = if corner == 0 { seen } else { [border(), border()] };
                vertices.push([x, y, random.range(-0.9, 0.9), 1.0, random.next(), random.next(), random.next(), 1.0]);
            }
        }
        builder.draw(topology::TRIANGLES, &vertices, 0, depth);
        for (way, gpu) in all_ways() {
            let Ok(gpu) = gpu else { return };
            eprintln!("{way}");
            compare_with(&gpu, &builder.batch, size, FORMAT);
        }
    }
}

#[test]
fn equal_depths_keep_the_order_of_their_function() {
    let size = [64, 48];
    // LESS keeps the first of two equal triangles, LEQUAL the last; half of them are clipped.
    for func in [compare::LESS, compare::LEQUAL] {
        let keys = |c: &mut Config| (c.shape.host_front, c.visible_from) = (false, 1);
        let lists = |c: &mut Config| (c.shape.host_front, c.visible_from) = (false, u32::MAX);
        let mut builder = Builder::new(size[0], size[1]);
        let state = FragmentState { flags: fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE, depth_func: func, ..fragment_state() };
        let mut vertices = Vec::new();
        for k in 0..40 {
            let far = if k % 2 == 0 { 0.9 } else { 2.5 };
            let color = k as f32 / 40.0;
            for p in [[-0.8, -0.7], [far, -0.6], [0.1, 0.8]] {
                vertices.push([p[0], p[1], 0.25, 1.0, color, 1.0 - color, 0.5, 1.0]);
            }
        }
        builder.draw(topology::TRIANGLES, &vertices, 0, state);
        for gpu in [GpuDevice::with(keys), GpuDevice::with(lists), GpuDevice::with(keys_by_host)] {
            let Ok(gpu) = gpu else { return };
            compare_with(&gpu, &builder.batch, size, FORMAT);
        }
    }
}

#[test]
fn a_batch_that_does_not_fit_is_drawn_all_the_same() {
    let size = [256, 256];
    let mut random = Random(6);
    let mut builder = Builder::new(size[0], size[1]);
    let state = FragmentState { flags: fragment_flags::BLEND, ..fragment_state() };
    // Each touches nearly all bins and many are clipped: more list entries, pool and queue than the first guess.
    let vertices = soup(&mut random, 3000, 3.0, true);
    builder.draw(topology::TRIANGLES, &vertices, 0, state);
    let Ok(gpu) = GpuDevice::with(|config| (config.shape.host_front, config.buffer_limit) = (false, 100_000)) else { return };
    compare_with(&gpu, &builder.batch, size, FORMAT);
}

#[test]
fn the_stipple_runs_on_through_any_number_of_lines() {
    let size = [256, 256];
    let mut random = Random(11);
    let mut builder = Builder::new(size[0], size[1]);
    builder.batch.raster_states[0].flags |= raster_flags::LINE_STIPPLE;
    builder.batch.raster_states[0].line_stipple = 0x3c5f | 3 << 16;
    // More than the host sets up in one run, and none resets the counter.
    for _ in 0..3 {
        let mut vertices = Vec::new();
        for _ in 0..2500 {
            let (x, y) = (random.range(-0.9, 0.9), random.range(-0.9, 0.9));
            for _ in 0..2 {
                let p = [x + random.range(-0.05, 0.05), y + random.range(-0.05, 0.05), random.range(-0.8, 0.8), 1.0];
                vertices.push([p[0], p[1], p[2], p[3], random.next(), random.next(), random.next(), 1.0]);
            }
        }
        builder.draw(topology::LINES, &vertices, 0, fragment_state());
    }
    // In little memory the rest is set up again.
    for limit in [None, Some(100_000)] {
        let limited = |config: &mut Config| config.buffer_limit = limit.unwrap_or(config.buffer_limit);
        let Ok(gpu) = GpuDevice::with(limited) else { return };
        compare_with(&gpu, &builder.batch, size, FORMAT);
    }
}

#[test]
fn blended_layers_agree() {
    let size = [200, 130];
    let mut random = Random(2);
    let mut builder = Builder::new(size[0], size[1]);
    let blend = FragmentState { flags: fragment_flags::BLEND, ..fragment_state() };
    let vertices = soup(&mut random, 100, 2.0, true);
    builder.draw(topology::TRIANGLES, &vertices, 0, blend);
    compare_executors(&builder.batch, size, FORMAT);
}

#[test]
fn draws_of_any_state_in_one_segment_agree() {
    let size = [170, 150];
    let mut random = Random(3);
    for format in [FORMAT, SurfaceFormat { top_first: false, ..FORMAT }, SurfaceFormat { depth: DepthFormat::D16, ..FORMAT }] {
        let mut builder = Builder::new(size[0], size[1]);
        let mut culled = raster_state(size[0], size[1]);
        culled.flags |= raster_flags::CULL_BACK;
        culled.polygon_stipple = 0;
        culled.scissor_min = [20, 13];
        culled.scissor_max = [141, 120];
        builder.batch.raster_states.push(culled);
        builder.batch.polygon_stipples.push(std::array::from_fn(|k| 0x9c0f_3355u32.rotate_left(k as u32)));
        for k in 0..60 {
            let face = |random: &mut Random| StencilFace {
                func: random.below(8),
                reference: random.below(6),
                read_mask: 255 >> random.below(3),
                write_mask: 255 >> random.below(3),
                ops: [random.below(8), random.below(8), random.below(8)],
                reserved: 0,
            };
            let mut state = fragment_state();
            state.flags = random.below(64);
            state.depth_func = random.below(8);
            state.alpha_func = random.below(8);
            state.alpha_ref = random.next();
            state.stencil = [face(&mut random), face(&mut random)];
            state.blend_factors = std::array::from_fn(|_| random.below(15));
            state.blend_equations = std::array::from_fn(|_| random.below(5));
            state.logic_op = random.below(16);
            state.color_mask = if k % 5 == 0 { random.below(16) } else { 15 };
            state.blend_color = [0.25, 0.5, 0.75, 0.4];
            if state.flags & fragment_flags::LOGIC_OP != 0 {
                state.flags &= !fragment_flags::BLEND;
            }
            let topology = [topology::TRIANGLES, topology::LINES, topology::POINTS][random.below(3) as usize];
            let vertices = soup(&mut random, 4, 1.0, k % 2 == 0);
            let vertices = &vertices[..vertices.len() / 6 * 6];
            builder.draw(topology, vertices, k % 2, state);
        }
        compare_executors(&builder.batch, size, format);
    }
}

#[test]
fn a_surface_keeps_its_pixels_from_batch_to_batch() {
    let Ok(gpu) = kernels() else { return };
    let size = [100, 70];
    let mut random = Random(4);
    let mut first = Builder::new(size[0], size[1]);
    first.draw(topology::TRIANGLES, &soup(&mut random, 20, 1.0, false), 0, fragment_state());
    let mut second = Builder::new(size[0], size[1]);
    second.batch.steps.clear();
    let state = FragmentState { flags: fragment_flags::BLEND, ..fragment_state() };
    second.draw(topology::TRIANGLES, &soup(&mut random, 20, 1.0, false), 0, state);
    let both = |device: &dyn Device| {
        let mut surface = device.surface(size[0], size[1], FORMAT);
        surface.execute(first.batch.clone());
        surface.pixels().color[size[0] as usize * 3 + 5] = 0xff00ff00;
        surface.execute(second.batch.clone());
        Drawn::of(&mut *surface)
    };
    let (a, b) = (both(&CpuDevice::new()), both(&gpu));
    assert_eq!(a.color, b.color);
    assert_eq!(a.depth_stencil, b.depth_stencil);
}

#[test]
fn clears_of_all_kinds_before_segments_agree() {
    let size = [150, 100];
    let mut random = Random(12);
    let all =
        Clear { min: [0; 2], max: [150, 100], color: [0.7, 0.2, 0.4, 0.6], color_mask: 15, depth: Some(0.6), stencil: Some((9, 255)) };
    let (none, part) = (Clear { color_mask: 0, depth: None, stencil: None, ..all }, Clear { min: [20, 30], max: [90, 70], ..all });
    let colour = Clear { color_mask: 15, ..none };
    let depth = Clear { depth: Some(0.4), stencil: Some((1, 255)), ..none };
    let clears: [&[Clear]; 9] = [
        &[all],
        &[colour],
        &[depth],
        &[colour, depth],
        &[depth, Clear { stencil: None, ..depth }, Clear { color: [0.1; 4], ..colour }],
        &[all, part],
        &[Clear { color_mask: 5, ..all }],
        &[Clear { stencil: Some((255, 15)), ..all }, colour],
        &[part, all, Clear { color_mask: 0, stencil: None, ..part }],
    ];
    let tested = FragmentState { flags: fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE, ..fragment_state() };
    let blended = FragmentState { flags: fragment_flags::BLEND, ..fragment_state() };
    // Some tiles have no triangle, some bins neither; the last triangles show nothing at all.
    let few = |random: &mut Random| soup(random, 12, 0.3, false);
    let nothing = [[3.0, 3.0, 0.0, 1.0, 1.0, 1.0, 1.0, 1.0]; 3];
    for state in [tested, blended] {
        let mut builder = Builder::new(size[0], size[1]);
        builder.draw(topology::TRIANGLES, &few(&mut random), 0, state);
        for clears in clears {
            builder.batch.steps.extend(clears.iter().map(|&clear| Step::Clear(clear)));
            builder.draw(topology::TRIANGLES, &few(&mut random), 0, state);
        }
        for (way, gpu) in all_ways() {
            let Ok(gpu) = gpu else { return };
            eprintln!("{way}");
            compare_with(&gpu, &builder.batch, size, FORMAT);
            // Each by itself as well: what a later clear covers is seen here.
            for clears in clears {
                let mut batch = builder.batch.clone();
                batch.steps.truncate(2);
                batch.steps.extend(clears.iter().map(|&clear| Step::Clear(clear)));
                let mut last = Builder { batch, programs: builder.programs.clone() };
                last.draw(topology::TRIANGLES, &few(&mut random), 0, state);
                compare_with(&gpu, &last.batch, size, FORMAT);
                last.batch.steps.pop();
                last.draw(topology::TRIANGLES, &nothing, 0, state);
                compare_clears_with(&gpu, &last.batch, size, FORMAT);
            }
        }
    }
}

#[test]
fn every_wrap_mode_and_filter_samples_the_same_texels() {
    let size = [120, 90];
    let mut random = Random(5);
    let wraps = [Wrap::Repeat, Wrap::Clamp, Wrap::ClampToEdge, Wrap::ClampToBorder, Wrap::MirroredRepeat];
    let kinds = [TextureKind::D1, TextureKind::D2, TextureKind::D3, TextureKind::Cube];
    for case in 0..16u64 {
        let kind = kinds[case as usize % 4];
        let format = if case % 5 == 4 { TexelFormat::Rgba32f } else { TexelFormat::Rgba8 };
        let levels = (0..4)
            .map(|l| {
                let width = 8 >> l;
                let height = if kind == TextureKind::D1 { 1 } else { width };
                let depth = match kind {
                    TextureKind::D3 => width,
                    TextureKind::Cube => 6,
                    _ => 1,
                };
                let words = width * height * depth * if format == TexelFormat::Rgba8 { 1 } else { 4 };
                let texels = (0..words)
                    .map(|_| {
                        if format == TexelFormat::Rgba8 { random.below(1 << 24) | random.below(256) << 24 } else { random.next().to_bits() }
                    })
                    .collect();
                TextureLevel { width, height, depth, texels: Arc::new(texels) }
            })
            .collect();
        let sampler = Sampler {
            wrap: std::array::from_fn(|_| wraps[random.below(5) as usize]),
            mag_linear: random.below(2) == 1,
            min_linear: random.below(2) == 1,
            mip_linear: [None, Some(false), Some(true)][random.below(3) as usize],
            border: [0.25, 0.5, 0.75, 0.125],
            ..Sampler::NEAREST
        };
        let image = Arc::new(TextureImage { id: 1_000_000 + case, kind, format, levels });
        let mut builder = Builder::new(size[0], size[1]);
        builder.programs.1 = textured();
        builder.batch.textures.push(TextureBinding { image, sampler });
        let state = FragmentState { flags: fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE, ..fragment_state() };
        builder.draw(topology::TRIANGLES, &soup(&mut random, 6, 1.5, case % 2 == 0), 0, state);
        // Texels from a buffer, from an image, and from an image by keys.
        for gpu in [GpuDevice::with(|c| on_gpu(c, 32)), kernels(), GpuDevice::with(keys_by_host)] {
            let Ok(gpu) = gpu else { return };
            compare_with(&gpu, &builder.batch, size, FORMAT);
        }
    }
}

#[test]
fn batches_whose_textures_are_too_large_are_drawn_all_the_same() {
    let size = [120, 90];
    let mut random = Random(17);
    let gpu = GpuDevice::with(|config| {
        on_gpu(config, 32);
        config.texel_limit = 300;
    });
    let Ok(gpu) = gpu else { return };
    let (mut surface, mut expected) =
        (gpu.gpu_surface(size[0], size[1], FORMAT).expect("a surface of a usual size"), CpuDevice::new().surface(size[0], size[1], FORMAT));
    // Now the GPU holds them, now it does not: each batch draws on what the one before left.
    for (k, side) in [4u32, 16, 8, 32].into_iter().enumerate() {
        let texels = (0..side * side).map(|_| random.below(1 << 24) | random.below(256) << 24).collect();
        let level = TextureLevel { width: side, height: side, depth: 1, texels: Arc::new(texels) };
        let (kind, format) = (TextureKind::D2, TexelFormat::Rgba8);
        let image = Arc::new(TextureImage { id: 2_000_000 + k as u64, kind, format, levels: vec![level] });
        let sampler = Sampler { wrap: [Wrap::Repeat; 3], ..Sampler::NEAREST };
        let mut builder = Builder::new(size[0], size[1]);
        builder.programs.1 = textured();
        builder.batch.textures.push(TextureBinding { image, sampler });
        if k > 0 {
            builder.batch.steps.clear();
        }
        let flags = fragment_flags::BLEND | fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE;
        builder.draw(topology::TRIANGLES, &soup(&mut random, 20, 0.8, true), 0, FragmentState { flags, ..fragment_state() });
        surface.execute(builder.batch.clone());
        expected.execute(builder.batch);
        let [drawn, expected] = [Drawn::of(&mut surface), Drawn::of(&mut *expected)];
        assert!(drawn.color == expected.color && drawn.depth_stencil == expected.depth_stencil, "a texture of {side} x {side}");
    }
}

#[test]
fn floating_point_depths_have_the_same_bits_on_both_executors() {
    let size = [150, 110];
    let mut random = Random(29);
    let tested = fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE;
    for (name, gpu) in all_ways() {
        let Ok(gpu) = gpu else { continue };
        let all: &[u32] = if name == "lists" { &[1, 4, 16] } else { &[1] };
        for &samples in all {
            let mut builder = Builder::new(size[0], size[1]);
            let single = builder.batch.raster_states[0];
            let multisample = if samples > 1 { raster_flags::MULTISAMPLE } else { 0 };
            let flags = single.flags | raster_flags::FLOAT_DEPTH | raster_flags::OFFSET_FILL | multisample;
            // A range in which neither end is a short number.
            let [scale, translate] = [0.37, 0.41].map(|z| [single.viewport_scale[0], single.viewport_scale[1], z]);
            let [width, height, _] = [single.viewport_translate[0], single.viewport_translate[1], 0.0];
            let offset = RasterState { flags, offset_units: -3.0, offset_factor: 0.25, ..single };
            let range = RasterState {
                viewport_scale: scale,
                viewport_translate: [width, height, translate[2]],
                depth_range: [0.04, 0.78],
                ..single
            };
            builder.batch.raster_states.extend([offset, range]);
            for k in 0..6 {
                let flags = tested | if k == 3 { fragment_flags::BLEND } else { 0 };
                let state = FragmentState { flags, depth_func: [compare::LESS, compare::GEQUAL][(k == 4) as usize], ..fragment_state() };
                let vertices = if k % 2 == 0 { soup(&mut random, 60, 1.0, true) } else { soup(&mut random, 600, 0.1, false) };
                builder.draw(topology::TRIANGLES, &vertices, k % 3, state);
            }
            println!("{name}, {samples} samples");
            let format = SurfaceFormat { depth: DepthFormat::F32, stencil: false, samples, ..FORMAT };
            compare_with(&gpu, &builder.batch, size, format);
        }
    }
}

#[test]
fn samples_are_the_same_on_both_executors() {
    let size = [150, 110];
    let mut random = Random(9);
    let states = [
        0,
        fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE,
        fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE | fragment_flags::BLEND,
        fragment_flags::ALPHA_TO_COVERAGE | fragment_flags::DEPTH_TEST | fragment_flags::DEPTH_WRITE,
        fragment_flags::ALPHA_TO_COVERAGE | fragment_flags::ALPHA_TO_ONE | fragment_flags::BLEND,
        fragment_flags::STENCIL_TEST | fragment_flags::DEPTH_TEST | fragment_flags::ALPHA_TEST,
    ];
    for (name, gpu) in all_ways() {
        let Ok(gpu) = gpu else { continue };
        // All of them in one way is enough: kernels take long to build on a software driver.
        let all: &[u32] = if name == "lists" { &[2, 4, 8, 16] } else { &[4] };
        for &samples in all {
            let mut builder = Builder::new(size[0], size[1]);
            let single = builder.batch.raster_states[0];
            builder.batch.raster_states.push(RasterState { flags: single.flags | raster_flags::MULTISAMPLE, ..single });
            for (k, flags) in states.into_iter().enumerate() {
                let mut state = FragmentState { flags, alpha_func: compare::GREATER, alpha_ref: 0.3, ..fragment_state() };
                state.dropped_samples = if k == 1 { 2 } else { 0 };
                state.stencil = [StencilFace { func: compare::ALWAYS, write_mask: 255, ops: [stencil_op::INCR; 3], ..state.stencil[0] }; 2];
                let (topology, vertices) = match k % 3 {
                    0 => (topology::TRIANGLES, soup(&mut random, 30, 1.0, true)),
                    1 => (topology::TRIANGLES, soup(&mut random, 200, 0.1, false)),
                    _ => (topology::LINES, soup(&mut random, 20, 0.8, false)),
                };
                builder.draw(topology, &vertices, (k != 2) as u32, state);
            }
            let format = SurfaceFormat { samples, ..FORMAT };
            println!("{name}, {samples} samples");
            compare_with(&gpu, &builder.batch, size, format);
            // Resolved on the device, too.
            let resolved = |device: &dyn Device| {
                let mut surface = device.surface(size[0], size[1], format);
                surface.execute(builder.batch.clone());
                surface.color_pixels().color.to_vec()
            };
            assert_eq!(resolved(&CpuDevice::new()), resolved(&gpu), "{name}, {samples} samples, resolved");
        }
    }
}
