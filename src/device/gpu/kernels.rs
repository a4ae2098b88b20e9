//! Layouts and pipelines. A pipeline is built when it is first wanted, and holds only what its segment needs.

use std::collections::HashMap;
use std::hash::Hash;
use std::sync::{Arc, Mutex};

use super::adapter::{Config, Gpu};
use super::fine::{FineKey, feature};
use super::source::record_constants;
use super::stage::{Stage, vertex_source};
use super::visible::resolve_source;
use crate::program::Program;

type Cache<K> = Mutex<HashMap<K, Arc<wgpu::ComputePipeline>>>;

/// Layouts and pipelines, shared by all surfaces of a device.
pub struct Kernels {
    /// Bindings of the front end.
    pub front_layout: wgpu::BindGroupLayout,
    /// Bindings of every stage behind the front end.
    pub layout: wgpu::BindGroupLayout,
    /// Bindings of the visible path.
    pub visible_layout: wgpu::BindGroupLayout,
    /// The sizes of later dispatches, for the stages that write them.
    pub indirect_layout: wgpu::BindGroupLayout,
    /// Kernel shape and limits.
    pub config: Config,
    /// By [`Bindings`], without and with the dispatches.
    pipeline_layouts: [[wgpu::PipelineLayout; 2]; 3],
    constants: String,
    stages: Cache<Stage>,
    vertex: Cache<u64>,
    fine: Cache<FineKey>,
    /// With the vertex program that they run, if any.
    resolve: Cache<(FineKey, Option<u64>)>,
}

/// Which layout a kernel's first bind group has.
#[derive(Clone, Copy)]
enum Bindings {
    Stages,
    Front,
    Visible,
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

/// The texels' binding, in every layout that has it.
pub const TEXELS: u32 = 7;

fn image_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    let (access, view_dimension) = (wgpu::StorageTextureAccess::ReadOnly, wgpu::TextureViewDimension::D2);
    let ty = wgpu::BindingType::StorageTexture { access, format: super::texture::PAIR_FORMAT, view_dimension };
    wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::COMPUTE, ty, count: None }
}

fn uniform_entry(binding: u32) -> wgpu::BindGroupLayoutEntry {
    wgpu::BindGroupLayoutEntry {
        binding,
        visibility: wgpu::ShaderStages::COMPUTE,
        ty: wgpu::BindingType::Buffer { ty: wgpu::BufferBindingType::Uniform, has_dynamic_offset: true, min_binding_size: None },
        count: None,
    }
}

impl Kernels {
    /// Layouts, no pipelines yet.
    pub fn new(gpu: &Gpu, config: Config) -> Kernels {
        let device = &gpu.device;
        let group = |label, read_only: &[bool], texels: bool, uniforms: u32| {
            let mut entries: Vec<_> = read_only.iter().enumerate().map(|(k, &r)| storage_entry(k as u32, r)).collect();
            if texels && config.shape.texel_pairs {
                entries[TEXELS as usize] = image_entry(TEXELS);
            }
            let storage = entries.len() as u32;
            entries.extend((storage..storage + uniforms).map(uniform_entry));
            device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some(label), entries: &entries })
        };
        // uniforms, vertices, primitives, records, shaded, triangles, planes, front; then the parameters.
        let front_layout = group("tepui front end", &[true, true, true, true, false, false, false, false], false, 1);
        // uniforms, records, triangles, planes, lists, colour, depth, texels, segments; then the parameters.
        let layout = group("tepui stages", &[true, true, true, true, false, false, false, true, true], true, 1);
        // uniforms, primitives, front records, shaded, records, colour, depth, texels, keys, queue, vertices; then two of parameters.
        let visible = [true, true, true, false, true, false, false, true, false, false, true];
        // A device that cannot take it never uses it.
        let visible_layout = match config.shape.keys64 {
            true => group("tepui visible", &visible, true, 2),
            false => group("tepui visible", &visible[..1], false, 2),
        };
        let indirect_layout = group("tepui dispatches", &[false], false, 0);
        let pipeline_layout = |first: &wgpu::BindGroupLayout, indirect: bool| {
            device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
                label: None,
                bind_group_layouts: &[Some(first), Some(&indirect_layout)][..1 + indirect as usize],
                immediate_size: 0,
            })
        };
        let pipeline_layouts = [&layout, &front_layout, &visible_layout].map(|first| [false, true].map(|i| pipeline_layout(first, i)));
        Kernels {
            front_layout,
            layout,
            visible_layout,
            indirect_layout,
            config,
            pipeline_layouts,
            constants: record_constants(),
            stages: Mutex::default(),
            vertex: Mutex::default(),
            fine: Mutex::default(),
            resolve: Mutex::default(),
        }
    }

    /// A stage's pipeline.
    pub fn stage(&self, gpu: &Gpu, stage: Stage) -> Arc<wgpu::ComputePipeline> {
        self.stage_with(gpu, stage, None)
    }

    /// The same of a stage that runs a vertex program, the one that it names.
    pub fn stage_with(&self, gpu: &Gpu, stage: Stage, soup: Option<&Program>) -> Arc<wgpu::ComputePipeline> {
        cached(&self.stages, &stage, || {
            let bindings = match stage {
                Stage::Visible(..) => Bindings::Visible,
                _ if stage.is_front() => Bindings::Front,
                _ => Bindings::Stages,
            };
            self.build(gpu, &format!("{stage:?}"), &stage.source(self.config.shape, soup, &self.constants), bindings, stage.is_indirect())
        })
    }

    /// The vertex stage's pipeline for a program.
    pub fn vertex(&self, gpu: &Gpu, program: &Program) -> Arc<wgpu::ComputePipeline> {
        cached(&self.vertex, &program.id, || {
            self.build(gpu, "Vertex", &vertex_source(self.config.shape, program, &self.constants), Bindings::Front, false)
        })
    }

    /// The fine stage's pipeline for a key.
    pub fn fine(&self, gpu: &Gpu, key: &FineKey, program: &Program) -> Arc<wgpu::ComputePipeline> {
        cached(&self.fine, key, || {
            let direct = key.features & feature::DIRECT != 0;
            self.build(gpu, "Fine", &key.source(self.config.shape, program, &self.constants), Bindings::Stages, direct)
        })
    }

    /// What shades the visible fragments of a segment with a key.
    pub fn resolve(&self, gpu: &Gpu, key: &FineKey, program: &Program, soup: Option<&Program>) -> Arc<wgpu::ComputePipeline> {
        cached(&self.resolve, &(key.clone(), soup.map(|program| program.id)), || {
            self.build(gpu, "Resolve", &resolve_source(key, self.config.shape, program, soup, &self.constants), Bindings::Visible, true)
        })
    }

    fn build(&self, gpu: &Gpu, name: &str, source: &str, bindings: Bindings, indirect: bool) -> wgpu::ComputePipeline {
        if std::env::var_os("TEPUI_DUMP_KERNELS").is_some() {
            eprintln!("// kernel {name}\n{source}");
        }
        let descriptor = wgpu::ShaderModuleDescriptor { label: Some(name), source: wgpu::ShaderSource::Wgsl(source.into()) };
        // SAFETY: the kernels index buffers by values that they or the host computed within bounds, all loops end; the
        // device keeps buffer bounds checks on (robust access), so that a mistake reads zeros instead of other memory.
        let module = unsafe { gpu.device.create_shader_module_trusted(descriptor, wgpu::ShaderRuntimeChecks::unchecked()) };
        gpu.device.create_compute_pipeline(&wgpu::ComputePipelineDescriptor {
            label: Some(name),
            layout: Some(&self.pipeline_layouts[bindings as usize][indirect as usize]),
            module: &module,
            entry_point: Some("tp_main"),
            compilation_options: wgpu::PipelineCompilationOptions { constants: &[], zero_initialize_workgroup_memory: false },
            cache: None,
        })
    }
}

fn cached<K: Clone + Eq + Hash>(cache: &Cache<K>, key: &K, build: impl FnOnce() -> wgpu::ComputePipeline) -> Arc<wgpu::ComputePipeline> {
    let mut cache = cache.lock().unwrap_or_else(|e| e.into_inner());
    if let Some(pipeline) = cache.get(key) {
        return pipeline.clone();
    }
    let pipeline = Arc::new(build());
    cache.insert(key.clone(), pipeline.clone());
    pipeline
}
