//! What holds for any picture: shared edges are covered once; nothing changes with how a primitive is split, where the window's whole pixels
//! are, how a batch is cut, how many threads draw, or which executor; depth is monotone; clears and the scissor box are sets of pixels.

use std::sync::Arc;

use proptest::prelude::*;

use super::enums::*;
use super::{Context, ContextConfig};
use crate::device::Device;
use crate::device::cpu::CpuDevice;
use crate::device::gpu::GpuDevice;
use crate::raster::simd::Level;

/// Pixels across: a power of two, so that subpixel positions reach the rasterizer exactly.
const SIDE: usize = 64;

/// A corner on the subpixel grid.
type Point = [i32; 2];

fn context(device: Option<Arc<dyn Device>>) -> Context {
    let mut cx = Context::new(ContextConfig::default(), None);
    cx.device = device.unwrap_or_else(|| Arc::new(CpuDevice::with(1, Level::best())));
    cx.attach_window(SIDE as u32, SIDE as u32);
    cx.matrix_mode(GL_PROJECTION);
    cx.ortho(0.0, SIDE as f64, 0.0, SIDE as f64, -1.0, 1.0);
    cx.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    cx
}

/// From now on the stencil buffer counts how often each sample is hit.
fn count_hits(cx: &mut Context) {
    cx.enable(GL_STENCIL_TEST);
    cx.stencil_func(GL_ALWAYS, 0, 0xff);
    cx.stencil_op(GL_INCR, GL_INCR, GL_INCR);
}

/// Colour, depth and stencil, top row first.
fn picture(cx: &mut Context) -> (Vec<u32>, Vec<u32>) {
    cx.finish();
    assert_eq!(cx.get_error(), GL_NO_ERROR);
    let pixels = cx.window.as_mut().expect("attached").pixels();
    (pixels.color.to_vec(), pixels.depth_stencil.to_vec())
}

fn hits(cx: &mut Context) -> Vec<u32> {
    picture(cx).1.into_iter().map(|word| word >> 24).collect()
}

fn triangles(cx: &mut Context, corners: &[[Point; 3]]) {
    cx.begin(GL_TRIANGLES);
    for [x, y] in corners.as_flattened() {
        cx.vertex(*x as f32 / 256.0, *y as f32 / 256.0, 0.0, 1.0);
    }
    cx.end();
}

/// Twice the area, positive counter-clockwise.
fn area([a, b, c]: [Point; 3]) -> i64 {
    let d = |p: Point, q: Point, k: usize| i64::from(q[k]) - i64::from(p[k]);
    d(a, b, 0) * d(a, c, 1) - d(a, b, 1) * d(a, c, 0)
}

/// A triangulation of the square from 8 to 56 pixels: each pick puts a point inside a triangle.
fn mesh(picks: &[(usize, f64, f64)]) -> Vec<[Point; 3]> {
    let (low, high) = (8 * 256, 56 * 256);
    let mut mesh = vec![[[low, low], [high, low], [high, high]], [[low, low], [high, high], [low, high]]];
    for &(pick, u, v) in picks {
        let k = pick % mesh.len();
        let [a, b, c] = mesh[k];
        let (u, v) = if u + v > 1.0 { (1.0 - u, 1.0 - v) } else { (u, v) };
        let at = |i: usize| (f64::from(a[i]) + u * f64::from(b[i] - a[i]) + v * f64::from(c[i] - a[i])).round() as i32;
        let p = [at(0), at(1)];
        let parts = [[a, b, p], [b, c, p], [c, a, p]];
        if parts.iter().all(|t| area(*t) > 0) {
            mesh[k] = parts[0];
            mesh.extend_from_slice(&parts[1..]);
        }
    }
    mesh
}

/// A scene of everything that reaches the rasterizer: blended triangles that may leave the window, lines, points, with and without a depth test.
#[derive(Clone, Debug)]
struct Scene(Vec<(u32, bool, bool, [[f32; 7]; 3])>);

fn scene() -> impl Strategy<Value = Scene> {
    let vertex = (-20.0f32..84.0, -20.0f32..84.0, -1.0f32..1.0, 0.0f32..1.0, 0.0f32..1.0, 0.0f32..1.0, 0.2f32..1.0);
    let vertex = vertex.prop_map(|(x, y, z, r, g, b, a)| [x, y, z, r, g, b, a]);
    let primitive = (0u32..6, any::<bool>(), any::<bool>(), prop::array::uniform3(vertex));
    prop::collection::vec(primitive, 1..40).prop_map(Scene)
}

fn draw(cx: &mut Context, Scene(primitives): &Scene) {
    cx.blend_func(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    count_hits(cx);
    for (kind, blend, depth, vertices) in primitives {
        (if *blend { Context::enable } else { Context::disable })(cx, GL_BLEND);
        (if *depth { Context::enable } else { Context::disable })(cx, GL_DEPTH_TEST);
        cx.line_width(1.0 + (vertices[0][3] * 4.0).floor());
        cx.point_size(1.0 + (vertices[0][4] * 9.0).floor());
        let mode = match kind {
            0 => GL_POINTS,
            1 => GL_LINE_STRIP,
            _ => GL_TRIANGLES,
        };
        cx.begin(mode);
        for [x, y, z, r, g, b, a] in vertices {
            cx.color(*r, *g, *b, *a);
            cx.vertex(*x, *y, *z, 1.0);
        }
        cx.end();
    }
}

fn drawn_by(device: Option<Arc<dyn Device>>, budget: Option<usize>, scene: &Scene) -> (Vec<u32>, Vec<u32>) {
    let mut cx = context(device);
    if let Some(bytes) = budget {
        cx.recorder.set_budget(bytes);
    }
    draw(&mut cx, scene);
    picture(&mut cx)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn shared_edges_are_covered_exactly_once(picks in prop::collection::vec((0usize..1000, 0.0f64..1.0, 0.0f64..1.0), 0..200)) {
        let mut cx = context(None);
        count_hits(&mut cx);
        triangles(&mut cx, &mesh(&picks));
        for (pixel, hits) in hits(&mut cx).into_iter().enumerate() {
            let inside = (8..56).contains(&(pixel % SIDE)) && (8..56).contains(&(pixel / SIDE));
            prop_assert_eq!(hits, u32::from(inside), "pixel {}, {}", pixel % SIDE, pixel / SIDE);
        }
    }

    #[test]
    fn a_triangle_split_at_a_whole_pixel_covers_the_same(corners in prop::array::uniform3((0i32..32, 0i32..32))) {
        // Even pixels, so that the middle of an edge is a whole pixel and lies exactly on the edge.
        let [a, b, c] = corners.map(|(x, y)| [x * 512, y * 512]);
        let middle = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
        let (mut whole, mut split) = (context(None), context(None));
        for cx in [&mut whole, &mut split] {
            count_hits(cx);
        }
        triangles(&mut whole, &[[a, b, c]]);
        triangles(&mut split, &[[a, middle, c], [middle, b, c]]);
        prop_assert_eq!(hits(&mut whole), hits(&mut split));
    }

    #[test]
    fn a_picture_moves_by_whole_pixels(
        corners in prop::collection::vec(prop::array::uniform3((0i32..12288, 0i32..12288)), 1..12), by in (0i32..16, 0i32..16),
    ) {
        let corners: Vec<[Point; 3]> = corners.into_iter().map(|t| t.map(|(x, y)| [x, y])).collect();
        let moved: Vec<[Point; 3]> = corners.iter().map(|t| t.map(|p| [p[0] + by.0 * 256, p[1] + by.1 * 256])).collect();
        let [here, there] = [corners, moved].map(|corners| {
            let mut cx = context(None);
            count_hits(&mut cx);
            cx.color(1.0, 0.5, 0.25, 1.0);
            triangles(&mut cx, &corners);
            picture(&mut cx)
        });
        for y in 0..SIDE - 16 {
            for x in 0..SIDE - 16 {
                // Rows are stored top first and the picture moves up.
                let from = (y + 16) * SIDE + x;
                let to = from + by.0 as usize - by.1 as usize * SIDE;
                prop_assert_eq!((here.0[from], here.1[from]), (there.0[to], there.1[to]));
            }
        }
    }

    #[test]
    fn batch_size_threads_and_vectors_do_not_change_a_bit(scene in scene(), budget in 1usize..20_000, threads in 1usize..8) {
        let plain = drawn_by(None, None, &scene);
        let scalar: Arc<dyn Device> = Arc::new(CpuDevice::with(threads, Level::Scalar));
        prop_assert!(drawn_by(None, Some(budget), &scene) == plain, "budget {budget}");
        prop_assert!(drawn_by(Some(scalar), Some(budget), &scene) == plain, "{threads} threads, scalar, budget {budget}");
    }

    #[test]
    fn depth_is_monotone_along_rows_and_columns(z in prop::array::uniform3(-1.0f32..1.0)) {
        let mut cx = context(None);
        cx.enable(GL_DEPTH_TEST);
        cx.depth_func(GL_ALWAYS);
        cx.begin(GL_TRIANGLES);
        for ([x, y], z) in [[0.0, 0.0], [64.0, 0.0], [0.0, 64.0]].into_iter().zip(z) {
            cx.vertex(x, y, z, 1.0);
        }
        cx.end();
        let depths: Vec<u32> = picture(&mut cx).1.into_iter().map(|word| word & 0xff_ffff).collect();
        let monotone = |line: Vec<u32>| line.is_sorted() || line.iter().rev().is_sorted();
        for k in 0..SIDE {
            // Row 0 is the top row: k + 1 pixels of it lie below the long side, less those on it.
            let row: Vec<u32> = (0..k).map(|x| depths[k * SIDE + x]).collect();
            let column: Vec<u32> = (SIDE - k..SIDE).map(|y| depths[y * SIDE + SIDE - 1 - k]).collect();
            prop_assert!(monotone(row) && monotone(column), "row or column {k}");
        }
    }

    #[test]
    fn the_nearer_of_two_triangles_is_seen_whatever_the_order(scene in scene(), shuffle in 0usize..40) {
        let Scene(mut primitives) = scene;
        let depths = |primitives: &[(u32, bool, bool, [[f32; 7]; 3])]| {
            let mut cx = context(None);
            let opaque = primitives.iter().map(|(kind, .., vertices)| (*kind, false, true, *vertices)).collect();
            draw(&mut cx, &Scene(opaque));
            picture(&mut cx).1
        };
        let first = depths(&primitives);
        let by = shuffle % primitives.len();
        primitives.rotate_left(by);
        prop_assert!(depths(&primitives) == first, "depths, and how often each sample was hit");
    }

    #[test]
    fn clears_fill_the_scissor_box_and_masks_choose_what(
        clears in prop::collection::vec(((-10i32..70, -10i32..70, 0i32..70, 0i32..70), 0u32..8, any::<u8>(), any::<[bool; 4]>(), any::<u8>()), 1..12),
    ) {
        let mut cx = context(None);
        let start = picture(&mut cx);
        let (mut color, mut depth_stencil) = start;
        cx.enable(GL_SCISSOR_TEST);
        for ((x, y, width, height), buffers, value, mask, bits) in clears {
            let byte = u32::from(value);
            cx.scissor(x, y, width, height);
            cx.clear_color(value as f32 / 255.0, value as f32 / 255.0, value as f32 / 255.0, value as f32 / 255.0);
            cx.clear_depth(f64::from(value) / 255.0);
            cx.clear_stencil(i32::from(value));
            cx.color_mask(mask[0], mask[1], mask[2], mask[3]);
            cx.depth_mask(mask[0]);
            cx.stencil_mask(u32::from(bits));
            let chosen = [GL_COLOR_BUFFER_BIT, GL_DEPTH_BUFFER_BIT, GL_STENCIL_BUFFER_BIT];
            cx.clear((0..3).filter(|k| buffers >> k & 1 != 0).map(|k| chosen[k]).sum());
            for pixel in 0..SIDE * SIDE {
                let (px, py) = ((pixel % SIDE) as i32, (SIDE - 1 - pixel / SIDE) as i32);
                if px < x || py < y || px >= x + width || py >= y + height {
                    continue;
                }
                if buffers & 1 != 0 {
                    let written: u32 = (0..4).filter(|k| mask[*k]).map(|k| 0xff << (8 * k)).sum();
                    color[pixel] = color[pixel] & !written | (byte * 0x0101_0101) & written;
                }
                if buffers & 2 != 0 && mask[0] {
                    let depth = (f64::from(value) / 255.0 * 16777215.0).round() as u32;
                    depth_stencil[pixel] = depth_stencil[pixel] & 0xff00_0000 | depth;
                }
                if buffers & 4 != 0 {
                    let written = u32::from(bits) << 24;
                    depth_stencil[pixel] = depth_stencil[pixel] & !written | (byte << 24) & written;
                }
            }
        }
        prop_assert!(picture(&mut cx) == (color, depth_stencil));
    }

    #[test]
    fn a_scissor_box_cuts_the_picture_and_changes_nothing_inside(scene in scene(), corner in (0i32..64, 0i32..64), size in (0i32..64, 0i32..64)) {
        let background = picture(&mut context(None));
        let whole = drawn_by(None, None, &scene);
        let mut cx = context(None);
        cx.enable(GL_SCISSOR_TEST);
        cx.scissor(corner.0, corner.1, size.0, size.1);
        draw(&mut cx, &scene);
        let cut = picture(&mut cx);
        for pixel in 0..SIDE * SIDE {
            let (x, y) = ((pixel % SIDE) as i32, (SIDE - 1 - pixel / SIDE) as i32);
            let inside = (corner.0..corner.0 + size.0).contains(&x) && (corner.1..corner.1 + size.1).contains(&y);
            let expected = if inside { &whole } else { &background };
            prop_assert_eq!((cut.0[pixel], cut.1[pixel]), (expected.0[pixel], expected.1[pixel]), "pixel {}, {}", x, y);
        }
    }
}

proptest! {
    // Each case is several submissions; the programs are built once.
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn both_executors_draw_the_same(scene in scene()) {
        // Where there is no Vulkan device at all there is one executor, and nothing to compare.
        let Ok(gpu) = GpuDevice::new() else { return Ok(()) };
        let (cpu, gpu) = (drawn_by(None, None, &scene), drawn_by(Some(Arc::new(gpu)), None, &scene));
        for (pixel, ((c, d), (gc, gd))) in cpu.0.iter().zip(&cpu.1).zip(gpu.0.iter().zip(&gpu.1)).enumerate() {
            prop_assert_eq!(d >> 24, gd >> 24, "hits of pixel {}, {}", pixel % SIDE, pixel / SIDE);
            prop_assert!((d & 0xff_ffff).abs_diff(gd & 0xff_ffff) <= 1);
            // Where layers are blended, one unit of a source becomes more than one of the result.
            let off = (0..4).map(|k| (c >> (8 * k) & 255).abs_diff(gc >> (8 * k) & 255)).max();
            prop_assert!(off <= Some(2), "{c:08x} {gc:08x}");
        }
    }
}
