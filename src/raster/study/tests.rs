use super::*;
use crate::device::cpu::CpuDevice;
use crate::device::{ColorFormat, DepthFormat, Device, SurfaceFormat};
use crate::gl::enums::*;
use crate::gl::{Context, ContextConfig};

const SIZE: [u32; 2] = [200, 130];

const METHODS: [Method; 8] = [
    Method::HalfSpace,
    Method::Blocked(4),
    Method::Blocked(8),
    Method::Blocked(16),
    Method::Blocked(32),
    Method::Combined,
    Method::BySize,
    Method::Scanline,
];

/// Triangles of all sizes, some of which reach beyond the view, as the GL state machine records them.
fn scene(depth: bool) -> Batch {
    let mut cx = Context::new(ContextConfig::default(), None);
    cx.attach_window(SIZE[0], SIZE[1]);
    if depth {
        cx.enable(GL_DEPTH_TEST);
    }
    cx.clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    let mut state = 1u32;
    let mut random = || {
        state = state.wrapping_mul(1664525).wrapping_add(1013904223);
        (state >> 8) as f32 / (1 << 24) as f32
    };
    cx.begin(GL_TRIANGLES);
    for k in 0..600 {
        let (x, y, z) = (random() * 2.2 - 1.1, random() * 2.2 - 1.1, random() * 1.6 - 0.8);
        let size = [0.01, 0.05, 0.3, 2.0][k % 4];
        for _ in 0..3 {
            cx.color(random(), random(), random(), 1.0);
            let w = 1.0 + random();
            let (x, y) = (x + (random() - 0.5) * size, y + (random() - 0.5) * size);
            cx.vertex(x * w, y * w, z * w, w);
        }
    }
    cx.end();
    cx.recorder.take().expect("a batch")
}

/// The shipped executor's colour and depth.
fn shipped(batch: &Batch) -> [Vec<u32>; 2] {
    let format = SurfaceFormat { color: ColorFormat::Rgba8, depth: DepthFormat::D24, stencil: true, top_first: true, samples: 1 };
    let mut surface = CpuDevice::with(1, Level::best()).surface(SIZE[0], SIZE[1], format);
    surface.execute(batch.clone());
    let pixels = surface.pixels();
    [pixels.color.to_vec(), pixels.depth_stencil.iter().map(|d| d & 0xff_ffff).collect()]
}

#[test]
fn every_way_gives_the_shipped_pixels() {
    for depth in [true, false] {
        let batch = scene(depth);
        let expected = shipped(&batch);
        assert!(expected[0].iter().filter(|c| **c != 0).count() > 10_000);
        for (method, layout, sort) in METHODS.iter().flat_map(|m| {
            [Layout::Linear, Layout::Tiled].into_iter().flat_map(move |l| [Sort::None, Sort::Middle, Sort::Last].map(|s| (*m, l, s)))
        }) {
            // Without a depth test the last triangle wins: threads that part by triangles cannot promise that.
            let threads = if sort == Sort::Last && !depth { 1 } else { 2 };
            let way = Way { method, layout, sort };
            for level in [Level::Scalar, Level::best()] {
                let mut study = Study::new(threads, level, SIZE, way).expect("threads");
                study.frame(&batch, way).expect("a frame");
                study.frame(&batch, way).expect("another frame");
                assert!(study.pixels() == expected, "{way:?}, depth {depth}, {level:?}");
            }
        }
    }
}

#[test]
fn what_it_does_not_draw_is_an_error() {
    let way = Way { method: Method::HalfSpace, layout: Layout::Linear, sort: Sort::None };
    let mut study = Study::new(1, Level::best(), SIZE, way).expect("threads");
    assert!(study.frame(&Batch::default(), way).is_err());
    let mut blended = scene(true);
    blended.fragment_states[0].flags |= fragment_flags::BLEND;
    assert!(study.frame(&blended, way).is_err());
}
