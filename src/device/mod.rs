//! Where batches run: the embedded CPU executor or wgpu compute.

pub mod cpu;
mod cpu_stats;
pub mod gpu;

use crate::draw::Batch;

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
    /// Words a pixel.
    pub fn words(self) -> usize {
        match self {
            ColorFormat::Rgba8 | ColorFormat::Rgbx8 | ColorFormat::Rgb565 => 1,
            ColorFormat::Rgba16 => 2,
            ColorFormat::Rgba32f => 4,
        }
    }
}

/// Storage of depth: a word a pixel, depth in the low 24 bits, stencil in the high 8.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum DepthFormat {
    /// No depth buffer.
    None,
    /// 16 bits.
    D16,
    /// 24 bits.
    D24,
}

impl DepthFormat {
    /// Bits of depth.
    pub fn bits(self) -> u32 {
        match self {
            DepthFormat::None => 0,
            DepthFormat::D16 => 16,
            DepthFormat::D24 => 24,
        }
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
}

/// The pixels of a surface in host memory, row 0 first.
#[derive(Clone, Debug)]
pub struct Pixels {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Storage.
    pub format: SurfaceFormat,
    /// `width * height * format.color.words()` words.
    pub color: Vec<u32>,
    /// `width * height` words (empty without depth and stencil): depth in the low 24 bits, stencil in the high 8.
    pub depth_stencil: Vec<u32>,
}

impl Pixels {
    /// Zeroed pixels.
    pub fn new(width: u32, height: u32, format: SurfaceFormat) -> Pixels {
        let n = width as usize * height as usize;
        let ds = format.depth != DepthFormat::None || format.stencil;
        Pixels { width, height, format, color: vec![0; n * format.color.words()], depth_stencil: vec![0; if ds { n } else { 0 }] }
    }
}

/// A colour, depth and stencil buffer of one size, and the device that draws on it.
pub trait Surface: Send {
    /// Runs a batch. May return before it is finished; `pixels` waits.
    fn execute(&mut self, batch: Batch);
    /// The pixels after all batches so far, to read.
    fn pixels(&mut self) -> &Pixels;
    /// The same, but only the colour need be up to date.
    fn color_pixels(&mut self) -> &Pixels {
        self.pixels()
    }
    /// Copies the colour to rows of bytes, `stride` from one to the next, row 0 last where `bottom_up`. The last row in memory may end
    /// with its pixels; every other one must have room for them.
    fn copy_color(&mut self, out: &mut [u8], stride: usize, bottom_up: bool) {
        let pixels = self.color_pixels();
        let words = pixels.width as usize * pixels.format.color.words();
        let lines = lines(out, stride, pixels.height as usize, bottom_up);
        for (line, row) in lines.into_iter().zip(pixels.color.chunks_exact(words.max(1))) {
            line[..words * 4].copy_from_slice(bytemuck::cast_slice(row));
        }
    }
    /// The same as `pixels`, to change.
    fn pixels_mut(&mut self) -> &mut Pixels;
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
    /// A new surface with zeroed pixels.
    fn surface(&self, width: u32, height: u32, format: SurfaceFormat) -> Box<dyn Surface>;
}

/// The process's device: `TEPUI_DEVICE` is `auto` (the default), `cpu` or `gpu`. Chosen once, then shared by all contexts.
///
/// `auto` takes a GPU only where there is real hardware; `gpu` takes any Vulkan adapter, and the CPU where there is none.
pub fn choose() -> std::sync::Arc<dyn Device> {
    static CHOSEN: std::sync::OnceLock<std::sync::Arc<dyn Device>> = std::sync::OnceLock::new();
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
                    Ok(device) => return std::sync::Arc::new(device),
                    Err(e) => log::warn!(target: "tepui::device", "no GPU: {e}; drawing on the CPU"),
                }
            }
            std::sync::Arc::new(cpu::CpuDevice::new())
        })
        .clone()
}
