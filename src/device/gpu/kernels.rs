//! Pipelines by key. A kernel holds only what its segment needs.

use std::collections::HashMap;
use std::fmt::Write;
use std::sync::{Arc, Mutex};

use super::adapter::{Gpu, Shape};
use super::glue::glue;
use super::source::{Options, expand, files, record_constants};
use super::texture::TextureClass;
use crate::device::ColorFormat;
use crate::program::Program;
use crate::raster::layout::blend_factor::{self, ONE_MINUS_SRC_ALPHA, SRC_ALPHA};

/// Stages that know nothing of programs and states.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[allow(missing_docs)]
pub enum Stage {
    Bin,
    Count,
    Scan,
    Emit,
    Tile,
    Active,
    /// Words of a colour pixel.
    Clear(u32),
}

/// What a fine kernel contains: bits of [`FineKey::features`].
#[allow(missing_docs)]
pub mod feature {
    /// The surface has depth or stencil, and some draw looks at it.
    pub const DEPTH_BUFFER: u32 = 1;
    pub const DEPTH_TEST: u32 = 1 << 1;
    pub const DEPTH_WRITE: u32 = 1 << 2;
    pub const STENCIL_TEST: u32 = 1 << 3;
    pub const ALPHA_TEST: u32 = 1 << 4;
    pub const BLEND: u32 = 1 << 5;
    pub const LOGIC_OP: u32 = 1 << 6;
    /// Some draw masks colour components.
    pub const COLOR_MASK: u32 = 1 << 7;
    pub const STIPPLE: u32 = 1 << 8;
    /// Some triangle needs the division by w.
    pub const PERSPECTIVE: u32 = 1 << 9;
    /// The program has to run: colour is written, or it may discard.
    pub const SHADES: u32 = 1 << 10;
    /// Colour is written.
    pub const COLOR_WRITE: u32 = 1 << 11;
    /// Draws differ in what is on: their flags are looked at.
    pub const MIXED: u32 = 1 << 12;
    /// Draws differ in the interpolation of varyings, but run the same program: each draw's record says which are perspective.
    pub const MIXED_INTERPOLATION: u32 = 1 << 13;
}

/// Blending of a segment.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum BlendKey {
    /// The same in all draws that blend: factors, equations.
    Fixed([u32; 4], [u32; 2]),
    /// Looked up for each triangle.
    Dynamic,
}

/// A fine kernel.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
pub struct FineKey {
    /// The fragment program's id.
    pub program: u64,
    /// Colour storage.
    pub color: ColorFormat,
    /// `feature::*`
    pub features: u32,
    /// How it blends.
    pub blend: BlendKey,
    /// Depth function, where all draws that test have the same.
    pub depth_func: Option<u32>,
    /// Bits of depth.
    pub depth_bits: u32,
    /// What each texture slot needs.
    pub textures: Vec<TextureClass>,
}

/// Layouts and pipelines, shared by all surfaces of a device.
pub struct Kernels {
    /// Bindings of every stage behind the front end.
    pub layout: wgpu::BindGroupLayout,
    /// The scan stage's sizes of later dispatches.
    pub indirect_layout: wgpu::BindGroupLayout,
    pipeline_layout: wgpu::PipelineLayout,
    scan_pipeline_layout: wgpu::PipelineLayout,
    constants: String,
    stages: Mutex<HashMap<Stage, Arc<wgpu::ComputePipeline>>>,
    fine: Mutex<HashMap<FineKey, Arc<wgpu::ComputePipeline>>>,
}

fn storage_entry(binding: u32, read_only: bool) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty: wgpu::BindingType::Buffer {
            ty: wgpu::BufferBindingType::Storage { read_only },
            has_dynamic_offset: false,
            min_binding_size: None,
        },
        count: None,
    }
}

impl Kernels {
    /// Layouts, no pipelines yet.
    pub fn new(gpu: &Gpu) -> Kernels {
        // uniforms, records, triangles, planes, lists, colour, depth, texels; then the parameters.
        let read_only = [true, true, true, true, false, false, false, true];
        let mut entries: Vec<_> = read_only.iter().enumerate().map(|(k, &r)| storage_entry(k as u32, r)).collect();
        entries.push(wgpu::BindGroupLayoutEntry {
            binding: 8,
            visibility: wgpu::ShaderStages::COMPUTE,
            ty: wgpu::BindingType::Buffer { ty: wgpu::BufferBindingType::Uniform, has_dynamic_offset: true, min_binding_size: None },
            count: None,
        });
        let device = &gpu.device;
        let layout = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("tepui stages"), entries: &entries });
        let indirect_layout = device
            .create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("tepui scan"), entries: &[storage_entry(0, false)] });
        let pipeline_layout = |groups: &[Option<&wgpu::BindGroupLayout>]| {
            device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor { label: None, bind_group_layouts: groups, immediate_size: 0 })
        };
        let scan_pipeline_layout = pipeline_layout(&[Some(&layout), Some(&indirect_layout)]);
        let pipeline_layout = pipeline_layout(&[Some(&layout)]);
        Kernels {
            layout,
            indirect_layout,
            pipeline_layout,
            scan_pipeline_layout,
            constants: record_constants(),
            stages: Mutex::default(),
            fine: Mutex::default(),
        }
    }

    /// A stage's pipeline.
    pub fn stage(&self, gpu: &Gpu, stage: Stage) -> Arc<wgpu::ComputePipeline> {
        let mut stages = self.stages.lock().unwrap_or_else(|e| e.into_inner());
        stages
            .entry(stage)
            .or_insert_with(|| {
                Arc::new(self.build(
                    gpu,
                    &format!("{stage:?}"),
                    &self.stage_source(gpu.shape, stage),
                    matches!(stage, Stage::Scan | Stage::Active),
                ))
            })
            .clone()
    }

    fn stage_source(&self, shape: Shape, stage: Stage) -> String {
        let mut options = Options::default();
        let mut lanes = shape.list_lanes;
        let mut extra = String::new();
        let file = match stage {
            Stage::Bin => {
                options.flag("ATOMIC_LISTS", true);
                files::BIN
            }
            Stage::Count => files::COUNT,
            Stage::Scan => {
                lanes = if lanes > 8 { 256 } else { lanes };
                files::SCAN
            }
            Stage::Emit => files::EMIT,
            Stage::Tile => files::TILE,
            Stage::Active => files::ACTIVE,
            Stage::Clear(words) => {
                let _ = writeln!(extra, "const TP_COLOR_WORDS = {words}u;");
                files::CLEAR
            }
        };
        let mut source = format!("const TP_LANES = {lanes}u;\n{extra}{}", self.constants);
        expand(files::COMMON, &options, &mut source);
        expand(file, &options, &mut source);
        source
    }

    /// The fine stage's pipeline for a key.
    pub fn fine(&self, gpu: &Gpu, key: &FineKey, program: &Program) -> Arc<wgpu::ComputePipeline> {
        let mut fine = self.fine.lock().unwrap_or_else(|e| e.into_inner());
        if let Some(pipeline) = fine.get(key) {
            return pipeline.clone();
        }
        let pipeline = Arc::new(self.build(gpu, "Fine", &self.fine_source(gpu.shape, key, program), false));
        fine.insert(key.clone(), pipeline.clone());
        pipeline
    }

    /// The text of a fine kernel.
    pub fn fine_source(&self, shape: Shape, key: &FineKey, program: &Program) -> String {
        let mut options = Options::default();
        let on = |bit: u32| key.features & bit != 0;
        for (name, bit) in [
            ("DEPTH_BUFFER", feature::DEPTH_BUFFER),
            ("DEPTH_TEST", feature::DEPTH_TEST),
            ("DEPTH_WRITE", feature::DEPTH_WRITE),
            ("STENCIL_TEST", feature::STENCIL_TEST),
            ("ALPHA_TEST", feature::ALPHA_TEST),
            ("BLEND", feature::BLEND),
            ("LOGIC_OP", feature::LOGIC_OP),
            ("COLOR_MASK", feature::COLOR_MASK),
            ("STIPPLE", feature::STIPPLE),
            ("SHADES", feature::SHADES),
            ("COLOR_WRITE", feature::COLOR_WRITE),
            ("STATE_FLAGS", feature::MIXED),
            ("MIXED_INTERPOLATION", feature::MIXED_INTERPOLATION),
        ] {
            options.flag(name, on(bit));
        }
        let writes_depth = program.writes_depth && on(feature::SHADES) && on(feature::DEPTH_TEST);
        options.flag("WRITES_DEPTH", writes_depth);
        // The stencil buffer changes where the depth test fails, but not where the program or the alpha test kills.
        options.flag("NEEDS_KILL_FIRST", on(feature::STENCIL_TEST) && (program.discards || on(feature::ALPHA_TEST)));
        options.flag("TEXTURES", on(feature::SHADES) && !key.textures.is_empty());
        let mut extra = String::new();
        let _ = writeln!(extra, "const TP_DEPTH_SCALE = {}.0;", (1u64 << key.depth_bits) - 1);
        if let Some(func) = key.depth_func {
            options.flag("DEPTH_FUNC_FIXED", true);
            let _ = writeln!(extra, "const TP_DEPTH_FUNC = {func}u;");
        }
        options.flag("SUBGROUP8", shape.subgroup8);
        options.flag("FMA64", shape.fma64);
        options.flag(
            match key.color {
                ColorFormat::Rgba8 => "COLOR_RGBA8",
                ColorFormat::Rgbx8 => "COLOR_RGBX8",
                ColorFormat::Rgb565 => "COLOR_RGB565",
                ColorFormat::Rgba16 => "COLOR_RGBA16",
                ColorFormat::Rgba32f => "COLOR_RGBA32F",
            },
            true,
        );
        options.flag(["COLOR_WORDS_1", "COLOR_WORDS_2", "", "COLOR_WORDS_4"][key.color.words() - 1], true);
        options.flag("COLOR_UNORM", key.color != ColorFormat::Rgba32f);
        options.flag("COLOR_8BIT", matches!(key.color, ColorFormat::Rgba8 | ColorFormat::Rgbx8));
        match key.blend {
            _ if !on(feature::BLEND) => {}
            BlendKey::Dynamic => {
                options.flag("BLEND_DYNAMIC", true);
                options.flag("BLEND_CONSTANT", true);
            }
            BlendKey::Fixed(f, e) => {
                options.flag("BLEND_CONSTANT", f.iter().any(|&f| f >= blend_factor::CONSTANT_COLOR));
                let eight_bits = key.color == ColorFormat::Rgba8;
                options.flag(
                    "BLEND_ALPHA",
                    eight_bits
                        && !on(feature::MIXED)
                        && f == [SRC_ALPHA, ONE_MINUS_SRC_ALPHA, SRC_ALPHA, ONE_MINUS_SRC_ALPHA]
                        && e == [0; 2],
                );
                options.flag("BLEND_UNIFORM", f[0] == f[2] && f[1] == f[3] && e[0] == e[1]);
                let _ = writeln!(extra, "const TP_BLEND_FACTORS = vec4<u32>({}u, {}u, {}u, {}u);", f[0], f[1], f[2], f[3]);
                let _ = writeln!(extra, "const TP_BLEND_EQUATIONS = vec2<u32>({}u, {}u);", e[0], e[1]);
            }
        }
        let glue = glue(program, key, shape);
        options.inserts.insert("TEXTURES", super::texture::loads(&key.textures));
        options.inserts.insert("PLANES", glue.planes);
        options.inserts.insert("DEPTH", glue.depth);
        options.inserts.insert("SHADE", glue.shade);
        let mut source = format!("const TP_LANES = {}u;\n{extra}{}", shape.fine_lanes, self.constants);
        for file in [files::COMMON, files::COLOR, files::FRAGMENT_OPS, files::BLEND] {
            expand(file, &options, &mut source);
        }
        if on(feature::SHADES) {
            if !key.textures.is_empty() {
                super::texture::splice(&key.textures, &options, &mut source);
            }
            source.push_str(&program.wgsl);
            source.push('\n');
        }
        expand(files::FINE, &options, &mut source);
        source
    }

    fn build(&self, gpu: &Gpu, name: &str, source: &str, scan: bool) -> wgpu::ComputePipeline {
        if std::env::var_os("TEPUI_DUMP_KERNELS").is_some() {
            eprintln!("// kernel {name}\n{source}");
        }
        let descriptor = wgpu::ShaderModuleDescriptor { label: Some(name), source: wgpu::ShaderSource::Wgsl(source.into()) };
        // SAFETY: the kernels index buffers by values that they or the host computed within bounds, all loops end; the
        // device keeps buffer bounds checks on (robust access), so that a mistake reads zeros instead of other memory.
        let module = unsafe { gpu.device.create_shader_module_trusted(descriptor, wgpu::ShaderRuntimeChecks::unchecked()) };
        gpu.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(name),
            layout: Some(if scan { &self.scan_pipeline_layout } else { &self.pipeline_layout }),
            module: &module,
            entry_point: Some("tp_main"),
            compilation_options: wgpu::PipelineCompilationOptions { constants: &[], zero_initialize_workgroup_memory: false },
            cache: None,
        })
    }
}
