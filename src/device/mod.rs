//! Where batches run: the embedded CPU executor or wgpu compute.

pub mod cpu;
mod cpu_stats;
mod cpu_textures;
pub mod gpu;
pub mod plane;
pub mod samples;

use std::sync::Arc;

use crate::draw::Batch;
pub use plane::{Pixels, Plane, PlaneFormat, SharedPlane, Target};

/// Storage of a colour pixel.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum ColorFormat {
    /// One word, red in the low byte.
    Rgba8,
    /// Like `Rgba8`; alpha reads as 1 whatever is written.
    Rgbx8,
    /// One word: 5 bits red (low), 6 green, 5 blue.
    Rgb565,
    /// Two words, 16 bits a component.
    Rgba16,
    /// Four words, f32.
    Rgba32f,
}

impl ColorFormat {
    /// A pixel is one word of four bytes, and is blended as such.
    pub fn is_bytes(self) -> bool {
        matches!(self, ColorFormat::Rgba8 | ColorFormat::Rgbx8)
    }

    /// Words a pixel.
    pub fn words(self) -> usize {
        match self {
            ColorFormat::Rgba8 | ColorFormat::Rgbx8 | ColorFormat::Rgb565 => 1,
            ColorFormat::Rgba16 => 2,
            ColorFormat::Rgba32f => 4,
        }
    }
}

/// Storage of depth: a word a pixel, depth in the low 24 bits, stencil in the high 8; or all of the word depth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DepthFormat {
    /// No depth buffer.
    None,
    /// 16 bits.
    D16,
    /// 24 bits.
    D24,
    /// The bits of a floating-point number from 0 to 1: in the order of the numbers. There is no room for stencil.
    F32,
}

impl DepthFormat {
    /// Bits of depth.
    pub fn bits(self) -> u32 {
        match self {
            DepthFormat::None => 0,
            DepthFormat::D16 => 16,
            DepthFormat::D24 => 24,
            DepthFormat::F32 => 32,
        }
    }

    /// Floating point.
    pub fn is_float(self) -> bool {
        self == DepthFormat::F32
    }

    /// Bits of a word that hold depth.
    pub fn mask(self) -> u32 {
        if self.is_float() { !0 } else { 0xff_ffff }
    }

    /// The greatest integer; of floating point, the number 1.
    pub fn most(self) -> f64 {
        if self.is_float() { 1.0 } else { ((1u32 << self.bits()) - 1).max(1).into() }
    }

    /// The bits of a depth, clamped and rounded to nearest.
    pub fn word(self, depth: f64) -> u32 {
        // A negative zero becomes a positive one.
        let depth = depth.clamp(0.0, 1.0) + 0.0;
        if self.is_float() { (depth as f32).to_bits() } else { (depth * self.most()).round_ties_even() as u32 }
    }

    /// The depth of a word, from 0 to 1.
    pub fn depth(self, word: u32) -> f64 {
        if self.is_float() { f32::from_bits(word).into() } else { f64::from(word & self.mask()) / self.most() }
    }
}

/// What a surface stores.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct SurfaceFormat {
    /// Colour.
    pub color: ColorFormat,
    /// Depth.
    pub depth: DepthFormat,
    /// 8 bits of stencil are there.
    pub stencil: bool,
    /// Row 0 is the top row (window surfaces); otherwise the bottom row (framebuffer objects).
    pub top_first: bool,
    /// Samples a pixel: 1, 2, 4, 8 or 16.
    pub samples: u32,
}

impl SurfaceFormat {
    /// Depth or stencil is stored.
    pub fn has_depth_stencil(self) -> bool {
        self.depth != DepthFormat::None || self.stencil
    }
}

/// Draws into planes.
pub trait Surface: Send {
    /// Where it draws.
    fn target(&self) -> &Target;
    /// Draws into other planes, of the same kind, from now on: see [`Device::retarget`].
    fn retarget(&mut self, target: Target);
    /// Runs a batch. May return before it is finished.
    fn execute(&mut self, batch: Batch);
    /// Runs a batch and then [`Surface::copy_color`].
    fn execute_and_copy(&mut self, batch: Batch, out: &mut [u8], stride: usize, bottom_up: bool) {
        self.execute(batch);
        self.copy_color(out, stride, bottom_up);
    }
    /// Waits until all batches so far are in the planes.
    fn settle(&mut self) {}
    /// The colour of each pixel as one sample, up to date: the colour plane itself where it has no more.
    fn resolved(&mut self) -> &SharedPlane;
    /// The pixels after all batches so far.
    fn pixels(&mut self) -> Pixels<'_> {
        self.settle();
        self.target().pixels()
    }
    /// The colour alone, one sample a pixel.
    fn color_pixels(&mut self) -> Pixels<'_> {
        self.settle();
        let ([width, height], format) = (self.target().size, SurfaceFormat { samples: 1, ..self.target().format });
        Pixels::of(self.resolved(), width, height, format)
    }
    /// Copies the colour, one sample a pixel, to rows of bytes, `stride` from one to the next, row 0 last where `bottom_up`. The last row
    /// in memory may end with its pixels; every other one must have room for them.
    fn copy_color(&mut self, out: &mut [u8], stride: usize, bottom_up: bool) {
        let mut plane = plane::lock(self.resolved());
        let [width, height] = plane.size.map(|n| n as usize);
        let words = width * plane.format.words();
        let lines = lines(out, stride, height, bottom_up);
        for (line, row) in lines.into_iter().zip(plane.rows().chunks_exact(words.max(1))) {
            line[..words * 4].copy_from_slice(bytemuck::cast_slice(row));
        }
    }
}

/// The first `count` rows of memory, `stride` bytes each (the last one may be shorter), in the order of a surface's rows.
fn lines(out: &mut [u8], stride: usize, count: usize, bottom_up: bool) -> Vec<&mut [u8]> {
    let mut lines: Vec<&mut [u8]> = out.chunks_mut(stride.max(1)).take(count).collect();
    if bottom_up {
        lines.reverse();
    }
    lines
}

/// Makes surfaces.
pub trait Device: Send + Sync {
    /// What it is, for GL_RENDERER and the log: "CPU, 2 threads, AVX2".
    fn name(&self) -> String;
    /// A plane of zeros.
    fn plane(&self, size: [u32; 2], samples: u32, format: PlaneFormat) -> SharedPlane;
    /// Makes every pixel of a colour plane the mean of its samples in another one of the same size and format, without a detour
    /// through rows; false where it does not, and rows have to do.
    fn resolve(&self, _from: &SharedPlane, _to: &SharedPlane) -> bool {
        false
    }
    /// What draws into planes of this device.
    fn surface_on(&self, target: Target) -> Box<dyn Surface>;
    /// Makes a surface of this device draw into other planes of it.
    fn retarget(&self, surface: &mut Box<dyn Surface>, target: Target) {
        surface.retarget(target);
    }
    /// Planes of zeros for a surface.
    fn target(&self, width: u32, height: u32, format: SurfaceFormat) -> Target {
        let size = [width, height];
        let color = self.plane(size, format.samples, PlaneFormat::Color(format.color));
        let depth_format = PlaneFormat::DepthStencil { depth: format.depth, stencil: format.stencil };
        let depth = format.has_depth_stencil().then(|| self.plane(size, format.samples, depth_format));
        Target { color, depth, size, format }
    }
    /// A new surface with zeroed planes of its own.
    fn surface(&self, width: u32, height: u32, format: SurfaceFormat) -> Box<dyn Surface> {
        self.surface_on(self.target(width, height, format))
    }
}

/// The process's device: `TEPUI_DEVICE` is `auto` (the default), `cpu` or `gpu`. Chosen once, then shared by all contexts.
///
/// `auto` takes a GPU only where there is real hardware; `gpu` takes any Vulkan adapter, and the CPU where there is none.
pub fn choose() -> Arc<dyn Device> {
    static CHOSEN: std::sync::OnceLock<Arc<dyn Device>> = std::sync::OnceLock::new();
    CHOSEN
        .get_or_init(|| {
            let wish = std::env::var("TEPUI_DEVICE").unwrap_or_default();
            let gpu_wanted = match wish.as_str() {
                "gpu" => true,
                "cpu" => false,
                _ => gpu::real_gpu_present(),
            };
            if gpu_wanted {
                match gpu::GpuDevice::new() {
                    Ok(device) => return Arc::new(device),
                    Err(e) => log::warn!(target: "tepui::device", "no GPU: {e}; drawing on the CPU"),
                }
            }
            Arc::new(cpu::CpuDevice::new())
        })
        .clone()
}
