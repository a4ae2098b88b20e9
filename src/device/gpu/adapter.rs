//! The Vulkan device, opened once, and the kernel shape that suits it.

use std::sync::OnceLock;

use super::visible;

/// How kernels are cut for a machine.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Shape {
    /// Lanes of the fine stage's workgroups: 64 (a pixel each), 32 (two pixels each) or 8 (a column of a tile each).
    pub fine_lanes: u32,
    /// Lanes of the workgroups of stages in which each lane works by itself.
    pub list_lanes: u32,
    /// Workgroups of 8 lanes are one subgroup, and there are integers of 64 bits: values that all lanes need are loaded by one lane each, two
    /// words at a time, and broadcast.
    pub subgroup8: bool,
    /// Workgroups of 32 lanes are one subgroup.
    pub subgroup32: bool,
    /// There are integers of 64 bits.
    pub int64: bool,
    /// The driver splits `fma`, and there are doubles to work it out with.
    pub fma64: bool,
    /// The driver may fuse products with sums.
    pub fuses: bool,
    /// There are integers and atomic minima of 64 bits, and storage buffers enough for the visible path.
    pub keys64: bool,
    /// Texels lie in an image, two words at a time, so that a texel of four bytes comes with its right neighbour: where loads from buffers go
    /// lane by lane, those from images do not.
    pub texel_pairs: bool,
    /// Blocks of 32 triangles of a bin's list that a dispatch of the fine stage of 8 lanes goes through: see [`ROUND_BLOCKS`].
    pub round_blocks: u32,
    /// Vertices, clipping and set-up are done by the Rust twins on the host: where the "GPU" is the same processor, they are faster.
    pub host_front: bool,
}

impl Shape {
    /// Loads of four words at a time in the fine stage.
    pub fn vectors(self) -> bool {
        self.fine_lanes >= 32
    }

    /// Tiles of a workgroup of the fine stage, and blocks of entries of one of the tile stage: each has a subgroup of eight lanes.
    pub fn teams(self) -> u32 {
        if self.subgroup8 { TEAMS } else { 1 }
    }

    /// A segment of fewer triangles gives the bin stage a lane for each triangle and row of bins. Where drivers run on a processor lanes that
    /// have nothing to do cost as much as others.
    pub fn few_triangles(self) -> u32 {
        if self.vectors() { 4096 } else { 16 }
    }

    /// The fine stage goes through a list in several dispatches.
    pub fn rounds(self) -> bool {
        !self.vectors()
    }
}

/// Where drivers run on a processor, a workgroup is a call that costs about a microsecond, as much as some triangles do. More than this would
/// leave threads without work at the end of a dispatch.
const TEAMS: u32 = 16;
const LIST_LANES: u32 = 256;

/// Mesa's software driver ends all loops of an invocation, together, after 65,535 iterations; a triangle takes up to ten.
const ROUND_BLOCKS: u32 = 128;

/// How an executor uses a device.
#[derive(Clone, Copy, Debug)]
pub struct Config {
    /// Kernel shape.
    pub shape: Shape,
    /// Most bytes of a buffer that grows with a batch.
    pub buffer_limit: u64,
    /// Most bytes of all that lies between a batch's input and its pixels, as far as cutting it helps.
    pub budget: u64,
    /// Most bytes of the texels that a batch samples, if the device binds as many: what has more is the CPU executor's.
    pub texel_limit: u64,
    /// Most bytes of a plane of the widest format: larger surfaces are the CPU executor's.
    pub plane_limit: u64,
    /// Triangles from which on a segment is drawn by keys, where its state and the device allow it.
    pub visible_from: u32,
    /// Most pixels of the rectangles of such triangles, on average, where the host has set them up and knows.
    pub visible_pixels: u64,
    /// Most pixels of the tiles that they touch for each of them, likewise.
    pub visible_area: u64,
    /// Triangles up to which a segment needs no lists, on a GPU.
    pub direct_upto: u32,
    /// vec4 of shaded vertices to each pixel of the surface from which on those that no two triangles share are shaded where they are wanted,
    /// by the visible path. Where memory is short they always are.
    pub soup_from: u64,
}

/// An open device.
pub struct Gpu {
    /// The device.
    pub device: wgpu::Device,
    /// Its queue.
    pub queue: wgpu::Queue,
    /// What it is.
    pub info: wgpu::AdapterInfo,
    /// What suits it.
    pub config: Config,
}

/// True where a machine may have a GPU at all: looked for in /dev, before Vulkan is loaded (which takes 100 ms).
pub fn device_files_present() -> bool {
    let any = |folder: &str, prefix: &str| {
        std::fs::read_dir(folder)
            .is_ok_and(|mut entries| entries.any(|e| e.is_ok_and(|e| e.file_name().to_string_lossy().starts_with(prefix))))
    };
    any("/dev", "nvidia") || any("/dev/dri", "renderD")
}

fn instance() -> wgpu::Instance {
    let mut descriptor = wgpu::InstanceDescriptor::new_without_display_handle();
    descriptor.backends = wgpu::Backends::VULKAN;
    descriptor.flags = if cfg!(debug_assertions) { wgpu::InstanceFlags::debugging() } else { wgpu::InstanceFlags::empty() };
    wgpu::Instance::new(descriptor)
}

fn rank(adapter: &wgpu::Adapter) -> u32 {
    match adapter.get_info().device_type {
        wgpu::DeviceType::DiscreteGpu => 0,
        wgpu::DeviceType::IntegratedGpu => 1,
        wgpu::DeviceType::VirtualGpu => 2,
        wgpu::DeviceType::Other => 3,
        wgpu::DeviceType::Cpu => 4,
    }
}

fn adapter() -> Result<wgpu::Adapter, String> {
    let adapters = pollster::block_on(instance().enumerate_adapters(wgpu::Backends::VULKAN));
    adapters.into_iter().min_by_key(rank).ok_or_else(|| "no Vulkan adapter".to_string())
}

/// Whether the best adapter is hardware. Loads Vulkan: ask [`device_files_present`] first.
pub fn hardware_adapter_present() -> bool {
    adapter().is_ok_and(|a| rank(&a) < 4)
}

/// Every tile of the surface looks at so many triangles in less time than lists of them take.
const DIRECT_UPTO: u32 = 512;

/// So many vec4 of vertices are written and read in the time that a pixel takes to shade three of its own.
const SOUP_FROM: u64 = 4;

/// Most bytes of a buffer that grows with a batch; larger batches are drawn in slices.
const BUFFER_LIMIT: u64 = 256 << 20;
/// Most bytes of all of them.
const BUDGET: u64 = 1 << 30;

fn open() -> Result<Gpu, String> {
    let adapter = adapter()?;
    let info = adapter.get_info();
    let wanted = wgpu::Features::SUBGROUP
        | wgpu::Features::SHADER_F64
        | wgpu::Features::SHADER_INT64
        | wgpu::Features::SHADER_INT64_ATOMIC_MIN_MAX
        | wgpu::Features::TIMESTAMP_QUERY
        | wgpu::Features::TIMESTAMP_QUERY_INSIDE_PASSES;
    // Where there is one memory, the host writes straight into it.
    let cpu = info.device_type == wgpu::DeviceType::Cpu;
    let wanted = if cpu { wanted | wgpu::Features::MAPPABLE_PRIMARY_BUFFERS } else { wanted };
    let features = adapter.features() & wanted;
    let descriptor = wgpu::DeviceDescriptor {
        label: Some("tepui"),
        required_features: features,
        required_limits: adapter.limits(),
        memory_hints: wgpu::MemoryHints::Performance,
        ..Default::default()
    };
    let (device, queue) = pollster::block_on(adapter.request_device(&descriptor)).map_err(|e| format!("{}: {e}", info.name))?;
    // A kernel that does not build, or a device that is lost, costs the picture, not the process.
    device.on_uncaptured_error(std::sync::Arc::new(|e| log::error!(target: "tepui::gpu", "{e}")));
    let keys = wgpu::Features::SHADER_INT64 | wgpu::Features::SHADER_INT64_ATOMIC_MIN_MAX;
    let wanted = wgpu::Features::SUBGROUP | wgpu::Features::SHADER_INT64;
    let subgroup8 = cpu && features.contains(wanted) && info.subgroup_min_size == 8 && info.subgroup_max_size == 8;
    let narrow = Shape {
        fine_lanes: 8,
        list_lanes: LIST_LANES,
        subgroup8,
        subgroup32: features.contains(wgpu::Features::SUBGROUP) && info.subgroup_min_size == 32 && info.subgroup_max_size == 32,
        int64: features.contains(wgpu::Features::SHADER_INT64),
        // Every GPU fuses; Mesa's software driver does not.
        fma64: cpu && features.contains(wgpu::Features::SHADER_F64),
        fuses: !cpu,
        keys64: features.contains(keys) && device.limits().max_storage_buffers_per_shader_stage >= 12,
        texel_pairs: cpu,
        round_blocks: ROUND_BLOCKS,
        host_front: cpu,
    };
    let wide = |fine_lanes| Shape { fine_lanes, list_lanes: 64, subgroup8: false, texel_pairs: false, ..narrow };
    let mut shape = if cpu { narrow } else { wide(32) };
    // For tests of the other shapes on one machine.
    match std::env::var("TEPUI_GPU_SHAPE").as_deref() {
        Ok("32") => shape = wide(32),
        Ok("64") => shape = wide(64),
        Ok("8") => shape = Shape { subgroup8: false, ..narrow },
        _ => {}
    }
    match std::env::var("TEPUI_GPU_FRONT").as_deref() {
        Ok("host") => shape.host_front = true,
        Ok("kernels") => shape.host_front = false,
        _ => {}
    }
    let limit = std::env::var("TEPUI_GPU_BUFFER_LIMIT").ok().and_then(|v| v.parse().ok()).unwrap_or(BUFFER_LIMIT);
    let plane_limit = device.limits().max_storage_buffer_binding_size;
    let buffer_limit = limit.min(plane_limit);
    let config = Config {
        shape,
        buffer_limit,
        budget: std::env::var("TEPUI_GPU_BUDGET").ok().and_then(|v| v.parse().ok()).unwrap_or(BUDGET),
        plane_limit,
        texel_limit: u64::MAX,
        visible_from: visible::WORTH_IT,
        visible_pixels: visible::WORTH_IT_PIXELS,
        visible_area: visible::WORTH_IT_AREA,
        direct_upto: DIRECT_UPTO,
        soup_from: SOUP_FROM,
    };
    Ok(Gpu { device, queue, info, config })
}

/// The process's device.
pub fn gpu() -> Result<&'static Gpu, String> {
    static GPU: OnceLock<Result<Gpu, String>> = OnceLock::new();
    GPU.get_or_init(open).as_ref().map_err(String::clone)
}
