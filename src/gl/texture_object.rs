//! Texture objects (3.8.12): names, binding, and the snapshot of a complete texture that draws sample.

use std::collections::HashMap;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use super::enums::*;
use super::texture_format::InternalFormat;
use super::texture_planes::LayerPlanes;
use super::{Context, dirty};
use crate::draw::texture::{Sampler, TextureBinding, TextureImage, TextureKind, TextureLevel, Wrap};

/// One level of one face.
#[derive(Clone, Debug)]
pub(crate) struct LevelImage {
    /// Width, height, depth in texels, without borders.
    pub size: [u32; 3],
    /// GL_TEXTURE_INTERNAL_FORMAT, as it was given.
    pub internal_format: GLenum,
    /// What it stands for.
    pub format: InternalFormat,
    /// Texels as `format.texels()` says; depth and stencil as planes hold them.
    pub texels: Arc<Vec<u32>>,
    /// What framebuffers draw into, by layer.
    pub planes: LayerPlanes,
}

/// Tells a texture object from all others, also after its name was deleted, and keeps it.
#[derive(Clone, Debug, Default)]
pub struct TextureHandle(Arc<()>);

impl PartialEq for TextureHandle {
    fn eq(&self, other: &TextureHandle) -> bool {
        Arc::ptr_eq(&self.0, &other.0)
    }
}

/// A texture object.
#[derive(Clone, Debug)]
#[allow(missing_docs)]
pub struct TextureObject {
    pub(crate) kind: TextureKind,
    /// S, T, R.
    pub(crate) wrap: [GLenum; 3],
    pub(crate) min_filter: GLenum,
    pub(crate) mag_filter: GLenum,
    pub(crate) border_color: [f32; 4],
    pub(crate) priority: f32,
    pub(crate) min_lod: f32,
    pub(crate) max_lod: f32,
    pub(crate) lod_bias: f32,
    pub(crate) base_level: i32,
    pub(crate) max_level: i32,
    pub(crate) generate_mipmap: bool,
    pub(crate) depth_mode: GLenum,
    pub(crate) compare_mode: GLenum,
    pub(crate) compare_func: GLenum,
    /// By face (one but for cube maps), then by level.
    pub(crate) faces: Vec<Vec<Option<LevelImage>>>,
    /// The snapshot of the levels, once it was asked for; dropped by every change of an image. The second is true
    /// when it holds a complete set of mipmaps.
    snapshot: Option<(Arc<TextureImage>, bool)>,
    /// Attachments hold it.
    pub(crate) handle: TextureHandle,
    /// Some level has a plane.
    pub(crate) has_planes: bool,
}

/// Source of [`TextureImage::id`].
static NEXT_IMAGE: AtomicU64 = AtomicU64::new(1);

/// A number that no other texture image has.
pub(crate) fn unique_image_id() -> u64 {
    NEXT_IMAGE.fetch_add(1, Ordering::Relaxed)
}

impl TextureObject {
    pub(crate) fn new(kind: TextureKind) -> TextureObject {
        TextureObject {
            kind,
            wrap: [GL_REPEAT; 3],
            min_filter: GL_NEAREST_MIPMAP_LINEAR,
            mag_filter: GL_LINEAR,
            border_color: [0.0; 4],
            priority: 1.0,
            min_lod: -1000.0,
            max_lod: 1000.0,
            lod_bias: 0.0,
            base_level: 0,
            max_level: 1000,
            generate_mipmap: false,
            depth_mode: GL_LUMINANCE,
            compare_mode: GL_NONE,
            compare_func: GL_LEQUAL,
            faces: vec![Vec::new(); if kind == TextureKind::Cube { 6 } else { 1 }],
            snapshot: None,
            handle: TextureHandle::default(),
            has_planes: false,
        }
    }

    pub(crate) fn image(&self, face: usize, level: usize) -> Option<&LevelImage> {
        self.faces.get(face)?.get(level)?.as_ref()
    }

    /// The image, to change: the snapshot is given up.
    pub(crate) fn image_mut(&mut self, face: usize, level: usize) -> Option<&mut LevelImage> {
        self.snapshot = None;
        self.faces.get_mut(face)?.get_mut(level)?.as_mut()
    }

    pub(crate) fn set_image(&mut self, face: usize, level: usize, image: LevelImage) {
        self.snapshot = None;
        let levels = &mut self.faces[face];
        if levels.len() <= level {
            levels.resize_with(level + 1, || None);
        }
        levels[level] = Some(image);
    }

    /// Base or greatest level changed.
    pub(crate) fn levels_changed(&mut self) {
        self.snapshot = None;
    }

    fn wants_mipmaps(&self) -> bool {
        !matches!(self.min_filter, GL_NEAREST | GL_LINEAR)
    }

    /// The base level's image in all faces, if those go together (3.8.10, cube completeness).
    fn base(&self) -> Option<&LevelImage> {
        let level = usize::try_from(self.base_level).ok()?;
        let base = self.image(0, level)?;
        if base.size.contains(&0) {
            return None;
        }
        let cube = |face| self.image(face, level).is_some_and(|i| i.size == base.size && i.format == base.format);
        if self.kind == TextureKind::Cube && (base.size[0] != base.size[1] || !(1..6).all(cube)) {
            return None;
        }
        Some(base)
    }

    /// The base level is there, and the faces of a cube map go together.
    pub(crate) fn has_base(&self) -> bool {
        self.base().is_some()
    }

    /// The texels of a level of all faces, face after face.
    fn level_texels(&self, level: usize) -> Option<Arc<Vec<u32>>> {
        if self.faces.len() == 1 {
            return Some(self.image(0, level)?.texels.clone());
        }
        let mut all = Vec::new();
        for face in 0..self.faces.len() {
            all.extend_from_slice(&self.image(face, level)?.texels);
        }
        Some(Arc::new(all))
    }

    /// True when levels base to q are there with the sizes and formats that mipmapping needs.
    fn mipmap_complete(&self, base: &LevelImage) -> bool {
        let base_level = self.base_level as usize;
        let largest = base.size.into_iter().max().unwrap_or(1);
        let last = (base_level + largest.ilog2() as usize).min(self.max_level.max(0) as usize);
        if last < base_level {
            return false;
        }
        (0..self.faces.len()).all(|face| {
            (base_level..=last).all(|level| {
                let shift = (level - base_level) as u32;
                let size = base.size.map(|n| (n >> shift).max(1));
                self.image(face, level).is_some_and(|i| i.size == size && i.format == base.format)
            })
        })
    }

    /// The complete texture to sample, if it is one.
    fn snapshot(&mut self) -> Option<Arc<TextureImage>> {
        if self.snapshot.is_none() {
            let base = self.base()?;
            let mipmaps = self.mipmap_complete(base);
            let first = self.base_level as usize;
            let largest = base.size.into_iter().max().unwrap_or(1);
            let last = if mipmaps { (first + largest.ilog2() as usize).min(self.max_level as usize) } else { first };
            let mut levels = Vec::new();
            for level in first..=last {
                let [width, height, depth] = self.image(0, level)?.size;
                let depth = if self.kind == TextureKind::Cube { 6 } else { depth };
                let mut texels = self.level_texels(level)?;
                if base.format.is_depth() {
                    texels = Arc::new(base.format.sampled(&texels, self.depth_mode));
                }
                levels.push(TextureLevel { width, height, depth, texels });
            }
            let image = TextureImage { id: unique_image_id(), kind: self.kind, format: base.format.texels(), levels };
            self.snapshot = Some((Arc::new(image), mipmaps));
        }
        let (image, mipmaps) = self.snapshot.as_ref()?;
        (*mipmaps || !self.wants_mipmaps()).then(|| image.clone())
    }

    fn sampler(&self, format: InternalFormat, unit_bias: f32) -> Sampler {
        let wrap = |mode| match mode {
            GL_CLAMP => Wrap::Clamp,
            GL_CLAMP_TO_EDGE => Wrap::ClampToEdge,
            GL_CLAMP_TO_BORDER => Wrap::ClampToBorder,
            GL_MIRRORED_REPEAT => Wrap::MirroredRepeat,
            _ => Wrap::Repeat,
        };
        Sampler {
            wrap: self.wrap.map(wrap),
            mag_linear: self.mag_filter == GL_LINEAR,
            min_linear: matches!(self.min_filter, GL_LINEAR | GL_LINEAR_MIPMAP_NEAREST | GL_LINEAR_MIPMAP_LINEAR),
            mip_linear: match self.min_filter {
                GL_NEAREST | GL_LINEAR => None,
                GL_NEAREST_MIPMAP_NEAREST | GL_LINEAR_MIPMAP_NEAREST => Some(false),
                _ => Some(true),
            },
            lod_range: [self.min_lod, self.max_lod],
            lod_bias: self.lod_bias + unit_bias,
            border: format.expand(self.border_color),
        }
    }

    /// The binding that a unit with this bias has, with the base format; None for an incomplete texture.
    fn binding(&mut self, unit_bias: f32) -> Option<(TextureBinding, GLenum)> {
        let image = self.snapshot()?;
        let format = self.image(0, self.base_level as usize)?.format;
        // Depth is sampled as what GL_DEPTH_TEXTURE_MODE says.
        let format = if format.is_depth() { InternalFormat { base: self.depth_mode, ..format } } else { format };
        Some((TextureBinding { image, sampler: self.sampler(format, unit_bias) }, format.base))
    }
}

impl TextureObject {
    /// A copy without images, for the attribute stack.
    pub(crate) fn parameters(&self) -> TextureObject {
        TextureObject { faces: Vec::new(), snapshot: None, handle: TextureHandle::default(), ..*self }
    }

    /// Takes the parameters of `saved` and keeps the images.
    pub(crate) fn restore_parameters(&mut self, saved: &TextureObject) {
        let same_levels = (self.base_level, self.max_level) == (saved.base_level, saved.max_level);
        let snapshot = self.snapshot.take().filter(|_| same_levels);
        let (faces, handle, has_planes) = (std::mem::take(&mut self.faces), self.handle.clone(), self.has_planes);
        *self = TextureObject { faces, snapshot, handle, has_planes, ..*saved };
    }
}

/// The textures of a share group.
pub struct TextureTable {
    /// By name; None for names that glGenTextures gave out and nothing bound yet.
    objects: HashMap<u32, Option<TextureObject>>,
    /// Name 0, by kind.
    defaults: [TextureObject; 4],
    /// Deleted, but still attached to some framebuffer.
    attached: Vec<TextureObject>,
    /// Where to look for unused names.
    next: u32,
}

impl Default for TextureTable {
    fn default() -> TextureTable {
        let defaults = [TextureKind::D1, TextureKind::D2, TextureKind::D3, TextureKind::Cube].map(TextureObject::new);
        TextureTable { objects: HashMap::new(), defaults, attached: Vec::new(), next: 1 }
    }
}

impl TextureTable {
    /// The object of a name, the default object where another context deleted it.
    pub(crate) fn object(&mut self, kind: TextureKind, name: u32) -> &mut TextureObject {
        match self.objects.get_mut(&name) {
            Some(Some(object)) if name != 0 && object.kind == kind => object,
            _ => &mut self.defaults[kind as usize],
        }
    }

    /// The object of a name, if it is still there.
    pub(crate) fn existing(&mut self, kind: TextureKind, name: u32) -> Option<&mut TextureObject> {
        let there = name == 0 || matches!(self.objects.get(&name), Some(Some(object)) if object.kind == kind);
        there.then(|| self.object(kind, name))
    }

    /// The kind of a texture that was bound before.
    pub(crate) fn kind(&self, name: u32) -> Option<TextureKind> {
        Some(self.objects.get(&name)?.as_ref()?.kind)
    }

    /// What attachments know a texture by.
    pub(crate) fn handle(&self, name: u32) -> Option<TextureHandle> {
        Some(self.objects.get(&name)?.as_ref()?.handle.clone())
    }

    /// The object that an attachment holds.
    pub(crate) fn of_handle(&mut self, name: u32, handle: &TextureHandle) -> Option<&mut TextureObject> {
        match self.objects.get_mut(&name) {
            Some(Some(object)) if object.handle == *handle => Some(object),
            _ => self.attached.iter_mut().find(|object| object.handle == *handle),
        }
    }

    /// Frees a name. The object stays while something is attached to it.
    fn delete(&mut self, name: u32) {
        if let Some(Some(object)) = self.objects.remove(&name) {
            self.attached.push(object);
            self.drop_unused();
        }
    }

    /// Some attachments may be gone.
    pub(crate) fn drop_unused(&mut self) {
        self.attached.retain(|object| Arc::strong_count(&object.handle.0) > 1);
    }

    fn generate(&mut self) -> u32 {
        while self.next == 0 || self.objects.contains_key(&self.next) {
            self.next = self.next.wrapping_add(1);
        }
        self.objects.insert(self.next, None);
        self.next
    }
}

/// The kind that a binding target names.
pub(crate) fn kind_of(target: GLenum) -> Option<TextureKind> {
    Some(match target {
        GL_TEXTURE_1D => TextureKind::D1,
        GL_TEXTURE_2D => TextureKind::D2,
        GL_TEXTURE_3D => TextureKind::D3,
        GL_TEXTURE_CUBE_MAP => TextureKind::Cube,
        _ => return None,
    })
}

impl Context {
    /// Runs `f` on the object that the active unit binds to a kind.
    pub(crate) fn with_texture<R>(&self, kind: TextureKind, f: impl FnOnce(&mut TextureObject) -> R) -> R {
        let unit = &self.state.texture.units[self.state.texture.active];
        f(self.shared().textures.object(kind, unit.bound[kind as usize]))
    }

    /// The texture that a unit samples: of its enabled targets the highest in priority (cube map, 3D, 2D, 1D), with its
    /// base format. None where nothing is enabled, or that texture is not complete.
    pub fn texture_binding(&self, unit: usize) -> Option<(TextureBinding, GLenum)> {
        let unit = self.state.texture.units.get(unit)?;
        let kind =
            [TextureKind::Cube, TextureKind::D3, TextureKind::D2, TextureKind::D1].into_iter().find(|&k| unit.enabled[k as usize])?;
        self.shared().textures.object(kind, unit.bound[kind as usize]).binding(unit.lod_bias)
    }

    /// glGenTextures: `n` unused names, none after an error.
    pub fn gen_textures(&mut self, n: i32) -> Vec<u32> {
        if self.inside_begin_end() {
            return Vec::new();
        }
        if n < 0 {
            self.set_error(GL_INVALID_VALUE, "glGenTextures");
            return Vec::new();
        }
        let mut shared = self.shared();
        (0..n).map(|_| shared.textures.generate()).collect()
    }

    /// glDeleteTextures. `n` is the count as given, to be checked; `names` what is there. Units that have a name bound fall
    /// back to the default texture.
    pub fn delete_textures(&mut self, n: i32, names: &[u32]) {
        if self.inside_begin_end() {
            return;
        }
        if n < 0 {
            return self.set_error(GL_INVALID_VALUE, "glDeleteTextures");
        }
        for &name in names.iter().filter(|&&name| name != 0) {
            let handle = self.shared().textures.handle(name);
            if let Some(handle) = handle {
                self.detach_texture(&handle);
            }
            self.shared().textures.delete(name);
            for unit in &mut self.state.texture.units {
                unit.bound.iter_mut().filter(|bound| **bound == name).for_each(|bound| *bound = 0);
            }
        }
        self.dirty |= dirty::TEXTURE;
    }

    /// glBindTexture. A name that was never generated makes an object as well.
    pub fn bind_texture(&mut self, target: GLenum, name: u32) {
        if self.compile(move |cx| cx.bind_texture(target, name)) || self.inside_begin_end() {
            return;
        }
        let Some(kind) = kind_of(target) else { return self.set_error(GL_INVALID_ENUM, "glBindTexture") };
        if name != 0 {
            let mut shared = self.shared();
            let object = shared.textures.objects.entry(name).or_default().get_or_insert_with(|| TextureObject::new(kind));
            if object.kind != kind {
                drop(shared);
                return self.set_error(GL_INVALID_OPERATION, "glBindTexture of a texture with another dimensionality");
            }
        }
        let active = self.state.texture.active;
        self.state.texture.units[active].bound[kind as usize] = name;
        self.dirty |= dirty::TEXTURE;
    }

    /// glIsTexture: true once the name was bound.
    pub fn is_texture(&mut self, name: u32) -> bool {
        !self.inside_begin_end() && name != 0 && matches!(self.shared().textures.objects.get(&name), Some(Some(_)))
    }

    /// glPrioritizeTextures. Names that are no textures are skipped.
    pub fn prioritize_textures(&mut self, n: i32, names: &[u32], priorities: &[f32]) {
        if self.lists.builder.is_some() {
            let (names, priorities) = (names.to_vec(), priorities.to_vec());
            self.compile(move |cx| cx.prioritize_textures(n, &names, &priorities));
            return;
        }
        if self.inside_begin_end() {
            return;
        }
        if n < 0 {
            return self.set_error(GL_INVALID_VALUE, "glPrioritizeTextures");
        }
        let mut shared = self.shared();
        for (name, priority) in names.iter().zip(priorities) {
            if let Some(Some(object)) = shared.textures.objects.get_mut(name) {
                object.priority = priority.clamp(0.0, 1.0);
            }
        }
    }

    /// glAreTexturesResident: everything is. None after an error (a name that is no texture, a negative count): false and
    /// nothing written.
    pub fn are_textures_resident(&mut self, n: i32, names: &[u32]) -> Option<bool> {
        if self.inside_begin_end() {
            return None;
        }
        let shared = self.shared();
        let known = names.iter().all(|name| matches!(shared.textures.objects.get(name), Some(Some(_))));
        drop(shared);
        if n < 0 || !known {
            self.set_error(GL_INVALID_VALUE, "glAreTexturesResident");
            return None;
        }
        Some(true)
    }
}
