//! Texture images: specification, sub-images, queries (3.8.1, 3.8.2, 6.1.4).

use std::sync::Arc;

use super::enums::*;
use super::pixel_format::{ClientImage, Groups, check, pack};
use super::texture_format::InternalFormat;
use super::texture_object::LevelImage;
use super::texture_planes::LayerPlanes;
use super::{Context, dirty};
use crate::device::DepthFormat;
use crate::draw::texture::TextureKind;

/// GL_MAX_TEXTURE_SIZE and GL_MAX_CUBE_MAP_TEXTURE_SIZE.
pub const MAX_TEXTURE_SIZE: i32 = 16384;
/// GL_MAX_3D_TEXTURE_SIZE
pub const MAX_3D_TEXTURE_SIZE: i32 = 2048;
/// Most bytes of one level; larger ones are refused with GL_OUT_OF_MEMORY and by the proxies.
const MAX_LEVEL_BYTES: u64 = 1 << 30;

/// What an image target names.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ImageTarget {
    pub kind: TextureKind,
    pub face: usize,
    pub proxy: bool,
}

impl ImageTarget {
    pub fn from_enum(target: GLenum) -> Option<ImageTarget> {
        let (kind, face, proxy) = match target {
            GL_TEXTURE_1D => (TextureKind::D1, 0, false),
            GL_TEXTURE_2D => (TextureKind::D2, 0, false),
            GL_TEXTURE_3D => (TextureKind::D3, 0, false),
            GL_TEXTURE_CUBE_MAP_POSITIVE_X..=GL_TEXTURE_CUBE_MAP_NEGATIVE_Z => {
                (TextureKind::Cube, (target - GL_TEXTURE_CUBE_MAP_POSITIVE_X) as usize, false)
            }
            GL_PROXY_TEXTURE_1D => (TextureKind::D1, 0, true),
            GL_PROXY_TEXTURE_2D => (TextureKind::D2, 0, true),
            GL_PROXY_TEXTURE_3D => (TextureKind::D3, 0, true),
            GL_PROXY_TEXTURE_CUBE_MAP => (TextureKind::Cube, 0, true),
            _ => return None,
        };
        Some(ImageTarget { kind, face, proxy })
    }

    /// Largest width, height and depth of a level without border.
    pub fn max_size(self) -> i32 {
        if self.kind == TextureKind::D3 { MAX_3D_TEXTURE_SIZE } else { MAX_TEXTURE_SIZE }
    }

    /// Dimensions that the commands for it have.
    pub fn dimensions(self) -> usize {
        match self.kind {
            TextureKind::D1 => 1,
            TextureKind::D2 | TextureKind::Cube => 2,
            TextureKind::D3 => 3,
        }
    }

    /// The target, if a command of so many dimensions takes it; level in range.
    pub fn checked(target: GLenum, level: i32, dimensions: usize, proxies: bool) -> Result<ImageTarget, GLenum> {
        let target =
            ImageTarget::from_enum(target).filter(|t| t.dimensions() == dimensions && (proxies || !t.proxy)).ok_or(GL_INVALID_ENUM)?;
        if level < 0 || level > target.max_size().ilog2() as i32 {
            return Err(GL_INVALID_VALUE);
        }
        Ok(target)
    }
}

/// What a texture image is asked to be.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ImageSpec {
    pub target: ImageTarget,
    pub level: usize,
    pub internal_format: GLenum,
    pub format: InternalFormat,
    /// Border included.
    pub size: [i32; 3],
    pub border: i32,
}

/// The answers of a proxy target (or nothing, where the last request failed).
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Proxy {
    pub size: [i32; 3],
    pub border: i32,
    pub internal_format: GLenum,
    pub format: Option<InternalFormat>,
}

impl ImageSpec {
    /// Checks the arguments that all forms of glTexImage and glCopyTexImage share. Sizes beyond the limits are left to
    /// [`ImageSpec::supported`], as they are no error for proxies.
    pub fn checked(target: ImageTarget, level: i32, internal_format: GLenum, size: [i32; 3], border: i32) -> Result<ImageSpec, GLenum> {
        let dimensions = target.dimensions();
        if size.iter().any(|&n| n < 0) || !(0..=1).contains(&border) {
            return Err(GL_INVALID_VALUE);
        }
        if size[..dimensions].iter().any(|&n| n < 2 * border) || target.kind == TextureKind::Cube && size[0] != size[1] {
            return Err(GL_INVALID_VALUE);
        }
        let format = InternalFormat::from_enum(internal_format).ok_or(GL_INVALID_VALUE)?;
        if format.is_depth() && target.kind == TextureKind::D3 {
            return Err(GL_INVALID_OPERATION);
        }
        Ok(ImageSpec { target, level: level as usize, internal_format, format, size, border })
    }

    /// Size without border: borders are accepted and dropped, as Mesa does.
    pub fn inner(&self) -> [u32; 3] {
        let dimensions = self.target.dimensions();
        std::array::from_fn(|k| if k < dimensions { (self.size[k] - 2 * self.border) as u32 } else { self.size[k].max(1) as u32 })
    }

    fn texel_count(&self) -> u64 {
        self.inner().iter().map(|&n| n as u64).product()
    }

    /// An error for sizes that this implementation does not support.
    pub fn supported(&self) -> Result<(), GLenum> {
        let largest = (self.target.max_size() >> self.level).max(1) as u32;
        if self.inner().iter().any(|&n| n > largest) {
            return Err(GL_INVALID_VALUE);
        }
        if self.texel_count() * self.format.words() as u64 * 4 > MAX_LEVEL_BYTES {
            return Err(GL_OUT_OF_MEMORY);
        }
        Ok(())
    }

    /// Texels of an image with border, the border cut off.
    pub fn store(&self, groups: Groups) -> Vec<u32> {
        let groups = if self.border > 0 { cut_border(groups, self.size.map(|n| n as usize), self.target.dimensions()) } else { groups };
        self.format.store(groups)
    }

    /// Texels of an image without data.
    fn blank(&self) -> Vec<u32> {
        let texel = if self.format.is_depth() { vec![0] } else { self.format.store(Groups::Rgba8(vec![0])) };
        let count = self.texel_count() as usize;
        match texel[..] {
            [word] => vec![word; count],
            _ => texel.repeat(count),
        }
    }
}

/// The groups within a border of one in the first `dimensions` dimensions.
fn cut_border(groups: Groups, size: [usize; 3], dimensions: usize) -> Groups {
    fn cut<T: Copy>(all: &[T], size: [usize; 3], dimensions: usize) -> Vec<T> {
        let range = |k: usize| if k < dimensions { 1..size[k] - 1 } else { 0..size[k] };
        let mut out = Vec::new();
        for z in range(2) {
            for y in range(1) {
                let row = (z * size[1] + y) * size[0];
                out.extend_from_slice(&all[row..row + size[0]][range(0)]);
            }
        }
        out
    }
    match groups {
        Groups::Rgba8(p) => Groups::Rgba8(cut(&p, size, dimensions)),
        Groups::Rgba(p) => Groups::Rgba(cut(&p, size, dimensions)),
        Groups::Depth(p) => Groups::Depth(cut(&p, size, dimensions)),
        Groups::DepthStencil(p) => Groups::DepthStencil(cut(&p, size, dimensions)),
        other => other,
    }
}

/// Format and type, as texture commands take them.
fn check_texture_format(format: GLenum, ty: GLenum) -> Result<(), GLenum> {
    if format == GL_STENCIL_INDEX {
        return Err(GL_INVALID_ENUM);
    }
    check(format, ty)
}

/// Depths, with stencils or without, go to and from depth textures, colours to and from the others (ARB_depth_texture).
fn check_base_format(format: GLenum, base: GLenum) -> Result<(), GLenum> {
    let is_depth = |format| matches!(format, GL_DEPTH_COMPONENT | GL_DEPTH_STENCIL);
    if is_depth(format) == is_depth(base) { Ok(()) } else { Err(GL_INVALID_OPERATION) }
}

/// The checks of glTexImage but for the sizes that are not supported.
fn check_image(
    dimensions: usize,
    target: GLenum,
    level: i32,
    internal_format: GLenum,
    size: [i32; 3],
    border: i32,
    format: GLenum,
    ty: GLenum,
) -> Result<ImageSpec, GLenum> {
    let target = ImageTarget::checked(target, level, dimensions, true)?;
    let spec = ImageSpec::checked(target, level, internal_format, size, border)?;
    check_texture_format(format, ty)?;
    check_base_format(format, spec.format.base)?;
    Ok(spec)
}

impl Context {
    /// glTexImage1D. `pixels`: from the client's pointer on, as [`Context::unpack_bytes`] says; None for NULL.
    pub fn tex_image_1d(
        &mut self,
        target: GLenum,
        level: i32,
        internal_format: i32,
        width: i32,
        border: i32,
        format: GLenum,
        ty: GLenum,
        pixels: Option<&[u8]>,
    ) {
        self.tex_image(1, target, level, internal_format, [width, 1, 1], border, format, ty, pixels);
    }

    /// glTexImage2D
    pub fn tex_image_2d(
        &mut self,
        target: GLenum,
        level: i32,
        internal_format: i32,
        width: i32,
        height: i32,
        border: i32,
        format: GLenum,
        ty: GLenum,
        pixels: Option<&[u8]>,
    ) {
        self.tex_image(2, target, level, internal_format, [width, height, 1], border, format, ty, pixels);
    }

    /// glTexImage3D. `pixels` as [`Context::unpack_bytes_3d`] says.
    pub fn tex_image_3d(
        &mut self,
        target: GLenum,
        level: i32,
        internal_format: i32,
        width: i32,
        height: i32,
        depth: i32,
        border: i32,
        format: GLenum,
        ty: GLenum,
        pixels: Option<&[u8]>,
    ) {
        self.tex_image(3, target, level, internal_format, [width, height, depth], border, format, ty, pixels);
    }

    fn tex_image(
        &mut self,
        dimensions: usize,
        target: GLenum,
        level: i32,
        internal_format: i32,
        size: [i32; 3],
        border: i32,
        format: GLenum,
        ty: GLenum,
        pixels: Option<&[u8]>,
    ) {
        let proxy = ImageTarget::from_enum(target).is_some_and(|t| t.proxy);
        // What is refused for its size is not read.
        let image = if proxy || size.iter().any(|&n| n > MAX_TEXTURE_SIZE + 2) {
            None
        } else {
            pixels.and_then(|bytes| ClientImage::unpack(&self.state.unpack, bytes, size, dimensions == 3, format, ty))
        };
        // A list keeps the image as it is now; glTexImage after it is compiled may change the client's memory.
        let image = image.map(Arc::new);
        let kept = image.clone();
        let run = move |cx: &mut Context, image| {
            cx.tex_image_unpacked(dimensions, target, level, internal_format as GLenum, size, border, format, ty, image)
        };
        if !proxy && self.compile(move |cx| run(cx, kept.clone())) || self.inside_begin_end() {
            return;
        }
        run(self, image);
    }

    fn tex_image_unpacked(
        &mut self,
        dimensions: usize,
        target: GLenum,
        level: i32,
        internal_format: GLenum,
        size: [i32; 3],
        border: i32,
        format: GLenum,
        ty: GLenum,
        image: Option<Arc<ClientImage>>,
    ) {
        let spec = match check_image(dimensions, target, level, internal_format, size, border, format, ty) {
            Ok(spec) => spec,
            Err(error) => return self.set_error(error, "glTexImage"),
        };
        if spec.target.proxy {
            let answer = Proxy { size, border, internal_format, format: Some(spec.format) };
            self.pixel_objects.proxies[spec.target.kind as usize] = if spec.supported().is_ok() { answer } else { Proxy::default() };
            return;
        }
        if let Err(error) = spec.supported() {
            return self.set_error(error, "glTexImage");
        }
        let texels = match image {
            Some(image) => {
                let image = Arc::try_unwrap(image).unwrap_or_else(|shared| (*shared).clone());
                spec.store(image.into_texture(&self.state.pixel))
            }
            None => spec.blank(),
        };
        self.set_texture_level(&spec, texels);
    }

    /// Puts a level into the bound texture.
    pub(crate) fn set_texture_level(&mut self, spec: &ImageSpec, texels: Vec<u32>) {
        let (size, texels) = (spec.inner(), Arc::new(texels));
        let image = LevelImage { size, internal_format: spec.internal_format, format: spec.format, texels, planes: LayerPlanes::default() };
        self.settle_texture(spec.target.kind);
        if self.fbo.draw != 0 {
            // The texture may be attached.
            self.framebuffer_changes();
        }
        self.with_texture(spec.target.kind, |object| {
            object.set_image(spec.target.face, spec.level, image);
            object.generate_mipmaps_after(spec.target.face, spec.level);
        });
        self.dirty |= dirty::TEXTURE;
    }

    /// glTexSubImage1D
    pub fn tex_sub_image_1d(&mut self, target: GLenum, level: i32, x: i32, width: i32, format: GLenum, ty: GLenum, pixels: Option<&[u8]>) {
        self.tex_sub_image(1, target, level, [x, 0, 0], [width, 1, 1], format, ty, pixels);
    }

    /// glTexSubImage2D
    pub fn tex_sub_image_2d(
        &mut self,
        target: GLenum,
        level: i32,
        x: i32,
        y: i32,
        width: i32,
        height: i32,
        format: GLenum,
        ty: GLenum,
        pixels: Option<&[u8]>,
    ) {
        self.tex_sub_image(2, target, level, [x, y, 0], [width, height, 1], format, ty, pixels);
    }

    /// glTexSubImage3D
    pub fn tex_sub_image_3d(
        &mut self,
        target: GLenum,
        level: i32,
        x: i32,
        y: i32,
        z: i32,
        width: i32,
        height: i32,
        depth: i32,
        format: GLenum,
        ty: GLenum,
        pixels: Option<&[u8]>,
    ) {
        self.tex_sub_image(3, target, level, [x, y, z], [width, height, depth], format, ty, pixels);
    }

    fn tex_sub_image(
        &mut self,
        dimensions: usize,
        target: GLenum,
        level: i32,
        offset: [i32; 3],
        size: [i32; 3],
        format: GLenum,
        ty: GLenum,
        pixels: Option<&[u8]>,
    ) {
        let image =
            pixels.and_then(|bytes| ClientImage::unpack(&self.state.unpack, bytes, size, dimensions == 3, format, ty)).map(Arc::new);
        let kept = image.clone();
        let run = move |cx: &mut Context, image: Option<Arc<ClientImage>>| {
            let result = check_texture_format(format, ty).and_then(|()| {
                let target = cx.check_sub_image(dimensions, target, level, offset, size).map(|t| (t, target));
                let (checked, target) = target?;
                check_base_format(format, cx.base_format_of(checked, level))?;
                let transfer = &cx.state.pixel;
                let groups = image.map(|image| Arc::try_unwrap(image).unwrap_or_else(|shared| (*shared).clone()).into_texture(transfer));
                cx.write_sub_image(dimensions, target, level, offset, size, groups)
            });
            if let Err(error) = result {
                cx.set_error(error, "glTexSubImage");
            }
        };
        if self.compile(move |cx| run(cx, kept.clone())) || self.inside_begin_end() {
            return;
        }
        run(self, image);
    }

    /// The checks of glTexSubImage and glCopyTexSubImage, and where to write: level, face and kind.
    pub(crate) fn check_sub_image(
        &self,
        dimensions: usize,
        target: GLenum,
        level: i32,
        offset: [i32; 3],
        size: [i32; 3],
    ) -> Result<ImageTarget, GLenum> {
        let target = ImageTarget::checked(target, level, dimensions, false)?;
        if size.iter().any(|&n| n < 0) {
            return Err(GL_INVALID_VALUE);
        }
        self.with_texture(target.kind, |object| {
            let image = object.image(target.face, level as usize).ok_or(GL_INVALID_OPERATION)?;
            let fits = (0..3).all(|k| offset[k] >= 0 && offset[k] as i64 + size[k] as i64 <= image.size[k] as i64);
            if fits { Ok(target) } else { Err(GL_INVALID_VALUE) }
        })
    }

    /// The base format of a level of a bound texture; GL_RGBA where there is none.
    pub(crate) fn base_format_of(&self, target: ImageTarget, level: i32) -> GLenum {
        self.with_texture(target.kind, |object| object.image(target.face, level as usize).map_or(GL_RGBA, |image| image.format.base))
    }

    /// Writes transferred colours (or depths) into a level; without colours only the checks are done.
    pub(crate) fn write_sub_image(
        &mut self,
        dimensions: usize,
        target: GLenum,
        level: i32,
        offset: [i32; 3],
        size: [i32; 3],
        groups: Option<Groups>,
    ) -> Result<(), GLenum> {
        let target = self.check_sub_image(dimensions, target, level, offset, size)?;
        let Some(groups) = groups else { return Ok(()) };
        if size.contains(&0) {
            return Ok(());
        }
        self.settle_texture(target.kind);
        self.with_texture(target.kind, |object| {
            let Some(image) = object.image_mut(target.face, level as usize) else { return };
            let words = image.format.words();
            let [x, y, z] = offset.map(|n| n as usize);
            let [width, height, depth] = size.map(|n| n as usize);
            let [full_width, full_height, _] = image.size.map(|n| n as usize);
            let texels = image.format.store(groups);
            // Copies first if a batch still reads the old texels.
            let out = Arc::make_mut(&mut image.texels);
            for (row, source) in texels.chunks_exact(width * words).enumerate().take(height * depth) {
                let at = (((z + row / height) * full_height + y + row % height) * full_width + x) * words;
                out[at..at + width * words].copy_from_slice(source);
            }
            object.give_to_planes(target.face, level as usize);
            object.generate_mipmaps_after(target.face, level as usize);
        });
        self.dirty |= dirty::TEXTURE;
        Ok(())
    }

    /// Bytes from the client's pointer on that glGetTexImage writes; None where it raises an error instead.
    pub fn get_tex_image_bytes(&self, target: GLenum, level: i32, format: GLenum, ty: GLenum) -> Option<usize> {
        let size = self.level_size(target, level)?;
        Some(self.state.pack.layout(size.map(|n| n as i32), true, format, ty)?.end)
    }

    /// Size of a level of a bound texture; zeros where it has no image.
    fn level_size(&self, target: GLenum, level: i32) -> Option<[u32; 3]> {
        let target = ImageTarget::from_enum(target).filter(|t| !t.proxy)?;
        let level = usize::try_from(level).ok()?;
        Some(self.with_texture(target.kind, |object| object.image(target.face, level).map_or([0; 3], |i| i.size)))
    }

    /// glGetTexImage
    pub fn get_tex_image(&mut self, target: GLenum, level: i32, format: GLenum, ty: GLenum, out: Option<&mut [u8]>) {
        if self.inside_begin_end() {
            return;
        }
        let Some(image_target) = ImageTarget::from_enum(target).filter(|t| !t.proxy) else {
            return self.set_error(GL_INVALID_ENUM, "glGetTexImage");
        };
        if let Err(error) = ImageTarget::checked(target, level, image_target.dimensions(), false) {
            return self.set_error(error, "glGetTexImage");
        }
        if matches!(format, GL_STENCIL_INDEX | GL_COLOR_INDEX) {
            return self.set_error(GL_INVALID_ENUM, "glGetTexImage");
        }
        let base = self.base_format_of(image_target, level);
        let checked = check_texture_format(format, ty).and_then(|()| check_base_format(format, base));
        // A depth texture with stencil gives its depths alone as well; one without has no stencils to give.
        let missing = format == GL_DEPTH_STENCIL && base != GL_DEPTH_STENCIL;
        if let Err(error) = checked.and(if missing { Err(GL_INVALID_OPERATION) } else { Ok(()) }) {
            return self.set_error(error, "glGetTexImage");
        }
        let Some(out) = out else { return };
        self.settle_texture(image_target.kind);
        let read = self.with_texture(image_target.kind, |object| {
            let image = object.image(image_target.face, level as usize)?;
            Some((image.size.map(|n| n as usize), image.format.read(&image.texels)))
        });
        // No pixel transfer on this way (6.1.4).
        if let Some((size, mut groups)) = read {
            if let (GL_DEPTH_COMPONENT, Groups::DepthStencil(words)) = (format, &groups) {
                groups = Groups::Depth(words.iter().map(|&w| DepthFormat::D24.depth(w)).collect());
            }
            if matches!(format, GL_LUMINANCE | GL_LUMINANCE_ALPHA) {
                // Luminance is red here, not the sum that glReadPixels makes: Mesa's reading, and the useful one.
                match &mut groups {
                    Groups::Rgba8(p) => p.iter_mut().for_each(|p| *p &= 0xff00_00ff),
                    Groups::Rgba(p) => p.iter_mut().for_each(|p| (p[1], p[2]) = (0.0, 0.0)),
                    _ => {}
                }
            }
            pack(&self.state.pack, out, size, image_target.kind == TextureKind::D3, format, ty, &groups);
        }
    }
}

#[cfg(test)]
mod tests;
