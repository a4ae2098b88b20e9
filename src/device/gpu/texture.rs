//! Textures on the GPU: a heap of texels that all images share, bindings as records, and the sampling code that a
//! segment needs.

use std::collections::HashMap;
use std::fmt::Write;

use bytemuck::cast_slice;

use super::adapter::Shape;
use super::buffers::Growing;
use super::source::{Options, expand, files};
use crate::draw::texture::{TexelFormat, TextureBinding, TextureImage, TextureKind, TextureLevel, Wrap};

/// What sampling of a texture slot needs: a part of the kernel's key.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct TextureClass {
    /// Kind of image.
    pub kind: TextureKind,
    /// Texel storage.
    pub format: TexelFormat,
    /// Wrap modes.
    pub wrap: [Wrap; 3],
    /// Linear magnification.
    pub mag_linear: bool,
    /// Linear minification.
    pub min_linear: bool,
    /// Mipmaps.
    pub mip_linear: Option<bool>,
}

impl TextureClass {
    /// Of a slot without a texture.
    pub const NONE: TextureClass = TextureClass {
        kind: TextureKind::D2,
        format: TexelFormat::Rgba8,
        wrap: [Wrap::Repeat; 3],
        mag_linear: false,
        min_linear: false,
        mip_linear: None,
    };

    /// Whether the level of detail decides between filters or levels, instead of blending them.
    pub fn chooses(&self) -> bool {
        self.mip_linear == Some(false) || self.mag_linear != self.min_linear
    }

    /// Of a binding.
    pub fn new(binding: &TextureBinding) -> TextureClass {
        let s = &binding.sampler;
        let single = binding.image.levels.len() <= 1;
        TextureClass {
            kind: binding.image.kind,
            format: binding.image.format,
            wrap: s.wrap,
            mag_linear: s.mag_linear,
            min_linear: s.min_linear,
            mip_linear: if single { None } else { s.mip_linear },
        }
    }
}

/// Appends the sampling code for these slots.
pub fn splice(classes: &[TextureClass], options: &Options, source: &mut String) {
    expand(files::TEXTURE, options, source);
    for slot in 0..classes.len() {
        let _ = writeln!(source, "var<private> tp_texture{slot}: TpTexture;");
    }
    source.push_str("fn texture_sample(slot: u32, coord: vec4<f32>, ddx: vec4<f32>, ddy: vec4<f32>) -> vec4<f32> {\n");
    for (slot, class) in classes.iter().enumerate() {
        let kind = match class.kind {
            TextureKind::D1 => 1,
            TextureKind::D2 => 2,
            TextureKind::D3 => 3,
            TextureKind::Cube => 4,
        };
        let [s, t, r] = class.wrap.map(|w| w as u32);
        let mip = class.mip_linear.map_or(0, |linear| 1 + linear as u32);
        let floats = class.format == TexelFormat::Rgba32f;
        let (mag, min) = (class.mag_linear, class.min_linear);
        let _ = writeln!(
            source,
            "if (slot == {slot}u) {{ return tp_sample(tp_texture{slot}, TpClass({kind}u, {floats}, vec3<u32>({s}u, {t}u, {r}u), {mag}, {min}, {mip}u), coord, ddx, ddy); }}"
        );
    }
    source.push_str("return vec4<f32>(0.0, 0.0, 0.0, 1.0);\n}\n");
}

/// Text that loads the slots' bindings, once a triangle: `//#insert TEXTURES`, itself to be expanded.
pub fn loads(classes: &[TextureClass]) -> String {
    let mut text = String::new();
    for (slot, class) in classes.iter().enumerate() {
        let border = class.wrap.iter().any(|w| matches!(w, Wrap::Clamp | Wrap::ClampToBorder));
        let at = slot * BINDING_WORDS;
        let _ = writeln!(text, "//#load tx{slot} tp_records textures + {at}u");
        if border {
            let _ = writeln!(text, "//#load tb{slot} tp_records textures + {}u", at + 8);
        }
        let _ = writeln!(
            text,
            "tp_texture{slot}.room = WORD(tx{slot}, 0);
tp_texture{slot}.halvings = WORD(tx{slot}, 1) >> 8u;
tp_texture{slot}.last = WORD(tx{slot}, 1) & 255u;
tp_texture{slot}.lod_range = vec2<f32>(bitcast<f32>(WORD(tx{slot}, 2)), bitcast<f32>(WORD(tx{slot}, 3)));
tp_texture{slot}.lod_bias = bitcast<f32>(WORD(tx{slot}, 4));
tp_texture{slot}.offset = WORD(tx{slot}, 5);
tp_texture{slot}.size = vec3<i32>(i32(WORD(tx{slot}, 6) & 0xffffu), i32(WORD(tx{slot}, 6) >> 16u), i32(WORD(tx{slot}, 7)));"
        );
        if border {
            let _ = writeln!(
                text,
                "tp_texture{slot}.border = vec4<f32>(bitcast<f32>(WORD(tb{slot}, 0)), bitcast<f32>(WORD(tb{slot}, 1)), bitcast<f32>(WORD(tb{slot}, 2)), bitcast<f32>(WORD(tb{slot}, 3)));"
            );
        }
    }
    text
}

/// Words of a texture binding's record.
pub const BINDING_WORDS: usize = 16;

/// Texels in pairs, each with its right neighbour.
fn with_neighbours(level: &TextureLevel) -> Vec<[u32; 2]> {
    let rows = level.texels.chunks_exact(level.width.max(1) as usize);
    rows.flat_map(|row| row.iter().zip(row.iter().cycle().skip(1)).map(|(&texel, &right)| [texel, right])).collect()
}

/// How an image's levels follow each other: each has half or a quarter of the room of the one before, so that a kernel need not look up where
/// one lies.
struct LevelRoom {
    /// Words that the base level may take.
    base: u32,
    /// Halvings from level to level.
    halvings: u32,
}

impl LevelRoom {
    fn new(image: &TextureImage, pairs: bool) -> LevelRoom {
        let last = image.levels.len().saturating_sub(1) as u32;
        let of_pairs = pairs && image.format == TexelFormat::Rgba8;
        let words = |level: &TextureLevel| level.texels.len() as u32 * if of_pairs { 2 } else { 1 };
        let first = image.levels.first().map_or(0, words);
        let room = |halvings: u32| LevelRoom { base: first.next_multiple_of(1 << (halvings * last)), halvings };
        // A quarter is enough as long as both sides halve; a long texture fits too, but with room for a square one.
        let fits = |r: &LevelRoom| image.levels.iter().zip(0..).all(|(l, k)| words(l) <= r.base >> (r.halvings * k));
        let [by_half, by_quarter] = [room(1), room(2)];
        if fits(&by_quarter) && by_quarter.offset(last + 1) <= by_half.offset(last + 1) { by_quarter } else { by_half }
    }

    /// Where a level begins; the twin of `tp_level_offset`.
    fn offset(&self, level: u32) -> u32 {
        let all = (self.base as u64) << self.halvings;
        let sum = all - (all >> (self.halvings * level));
        (if self.halvings == 2 { sum / 3 } else { sum }) as u32
    }
}

/// Pairs of a row of [`PairImage`]: `tp_texel_pair` of `shaders/texture.wgsl`.
const PAIR_ROW: u32 = 4096;

/// Storage of a pair.
pub const PAIR_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg32Uint;

/// Pairs of words, row after row of an image of the device's.
struct PairImage {
    texture: wgpu::Texture,
    view: wgpu::TextureView,
    /// Counts replacements.
    generation: u32,
}

impl PairImage {
    fn new(device: &wgpu::Device, rows: u32, generation: u32) -> PairImage {
        let texture = device.create_texture(&wgpu::TextureDescriptor {
            label: Some("texels"),
            size: wgpu::Extent3d { width: PAIR_ROW, height: rows, depth_or_array_layers: 1 },
            mip_level_count: 1,
            sample_count: 1,
            dimension: wgpu::TextureDimension::D2,
            format: PAIR_FORMAT,
            usage: wgpu::TextureUsages::STORAGE_BINDING | wgpu::TextureUsages::COPY_DST,
            view_formats: &[],
        });
        let view = texture.create_view(&wgpu::TextureViewDescriptor::default());
        PairImage { texture, view, generation }
    }

    /// Writes whole rows from row `first` on.
    fn write(&self, queue: &wgpu::Queue, first: u32, words: &[u32]) {
        let bytes_per_row = PAIR_ROW * 8;
        let rows = words.len() as u32 * 4 / bytes_per_row;
        let origin = wgpu::Origin3d { x: 0, y: first, z: 0 };
        let to = wgpu::TexelCopyTextureInfo { texture: &self.texture, mip_level: 0, origin, aspect: wgpu::TextureAspect::All };
        let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(bytes_per_row), rows_per_image: None };
        let size = wgpu::Extent3d { width: PAIR_ROW, height: rows, depth_or_array_layers: 1 };
        queue.write_texture(to, cast_slice(words), layout, size);
    }
}

/// Where texels lie on the device.
enum Texels {
    /// Word after word.
    Buffer(Growing),
    /// See [`Shape::texel_pairs`].
    Pairs(PairImage),
}

/// The texels of all images, cached by the images' ids.
pub struct Heap {
    texels: Texels,
    offsets: HashMap<u64, u32>,
    used: u32,
}

impl Heap {
    /// Empty.
    pub fn new(device: &wgpu::Device, shape: Shape) -> Heap {
        let texels = match shape.texel_pairs {
            true => Texels::Pairs(PairImage::new(device, 1, 0)),
            false => Texels::Buffer(Growing::new(device, "texels", wgpu::BufferUsages::STORAGE)),
        };
        Heap { texels, offsets: HashMap::new(), used: 0 }
    }

    /// Changes when the buffer or image was replaced.
    pub fn generation(&self) -> u32 {
        match &self.texels {
            Texels::Buffer(buffer) => buffer.generation,
            Texels::Pairs(image) => image.generation,
        }
    }

    /// The buffer or image.
    pub fn resource(&self) -> wgpu::BindingResource<'_> {
        match &self.texels {
            Texels::Buffer(buffer) => buffer.get().as_entire_binding(),
            Texels::Pairs(image) => wgpu::BindingResource::TextureView(&image.view),
        }
    }

    fn pairs(&self) -> bool {
        matches!(self.texels, Texels::Pairs(_))
    }

    /// Words that fit.
    fn capacity(&self) -> u64 {
        match &self.texels {
            Texels::Buffer(buffer) => buffer.get().size() / 4,
            Texels::Pairs(image) => image.texture.height() as u64 * PAIR_ROW as u64 * 2,
        }
    }

    fn reserve(&mut self, device: &wgpu::Device, words: u64) {
        match &mut self.texels {
            Texels::Buffer(buffer) => buffer.reserve(device, words * 4),
            Texels::Pairs(image) => {
                let rows = words.div_ceil(PAIR_ROW as u64 * 2) as u32;
                if rows > image.texture.height() {
                    let rows = rows.max((image.texture.height() * 2).min(device.limits().max_texture_dimension_2d));
                    *image = PairImage::new(device, rows, image.generation + 1);
                }
            }
        }
    }

    fn words(&self, image: &TextureImage) -> u32 {
        let words = LevelRoom::new(image, self.pairs()).offset(image.levels.len() as u32);
        if self.pairs() { words.next_multiple_of(PAIR_ROW * 2) } else { words }
    }

    /// Most bytes that the device binds.
    fn most_bytes(&self, device: &wgpu::Device) -> u64 {
        let limits = device.limits();
        match self.texels {
            Texels::Buffer(_) => limits.max_storage_buffer_binding_size,
            Texels::Pairs(_) => limits.max_texture_dimension_2d as u64 * PAIR_ROW as u64 * 8,
        }
    }

    /// Uploads the images of these bindings that are not there yet. False: they take more than the device binds, or than `limit` bytes.
    pub fn prepare(&mut self, device: &wgpu::Device, queue: &wgpu::Queue, bindings: &[TextureBinding], limit: u64) -> bool {
        let mut missing: Vec<&TextureImage> = Vec::new();
        for b in bindings {
            if !self.offsets.contains_key(&b.image.id) && !missing.iter().any(|m| m.id == b.image.id) {
                missing.push(&b.image);
            }
        }
        if missing.is_empty() {
            return true;
        }
        let more: u64 = missing.iter().map(|i| self.words(i) as u64).sum();
        if self.used as u64 + more > self.capacity() {
            // Start over with what this batch needs: a simple rule, rarely used, since the buffer doubles.
            self.offsets.clear();
            self.used = 0;
            missing.clear();
            for b in bindings {
                if !missing.iter().any(|m| m.id == b.image.id) {
                    missing.push(&b.image);
                }
            }
            let all: u64 = missing.iter().map(|i| self.words(i) as u64).sum();
            if all * 4 > limit.min(self.most_bytes(device)) {
                return false;
            }
            self.reserve(device, all);
        }
        for image in missing {
            self.offsets.insert(image.id, self.used);
            let room = LevelRoom::new(image, self.pairs());
            match &self.texels {
                Texels::Buffer(buffer) => {
                    for (k, level) in image.levels.iter().enumerate() {
                        let at = (self.used + room.offset(k as u32)) as u64 * 4;
                        queue.write_buffer(buffer.get(), at, cast_slice(&level.texels));
                    }
                }
                Texels::Pairs(pairs) => {
                    let mut words = vec![0; self.words(image) as usize];
                    for (k, level) in image.levels.iter().enumerate() {
                        let to = &mut words[room.offset(k as u32) as usize..];
                        if image.format == TexelFormat::Rgba8 {
                            let level = with_neighbours(level);
                            to[..level.len() * 2].copy_from_slice(level.as_flattened());
                        } else {
                            to[..level.texels.len()].copy_from_slice(&level.texels);
                        }
                    }
                    pairs.write(queue, self.used / (PAIR_ROW * 2), &words);
                }
            }
            self.used += self.words(image);
        }
        true
    }

    /// Appends the bindings' records.
    pub fn records(&self, bindings: &[TextureBinding], words: &mut Vec<u32>) {
        let start = words.len();
        words.resize(start + bindings.len() * BINDING_WORDS, 0);
        for (k, b) in bindings.iter().enumerate() {
            let room = LevelRoom::new(&b.image, self.pairs());
            let s = &b.sampler;
            let record = &mut words[start + k * BINDING_WORDS..][..BINDING_WORDS];
            record[0] = room.base;
            record[1] = (b.image.levels.len() as u32).saturating_sub(1) | room.halvings << 8;
            if let Some(base) = b.image.levels.first() {
                record[5] = self.offsets.get(&b.image.id).copied().unwrap_or(0);
                record[6] = base.width | base.height << 16;
                record[7] = base.depth;
            }
            record[2] = s.lod_range[0].to_bits();
            record[3] = s.lod_range[1].to_bits();
            record[4] = s.lod_bias.to_bits();
            for c in 0..4 {
                record[8 + c] = s.border[c].to_bits();
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An image whose levels have these sides, down to 1 in all of them.
    fn image(kind: TextureKind, sides: [u32; 3], layers: u32) -> TextureImage {
        let last = sides.iter().map(|s| s.ilog2()).max().unwrap_or(0);
        let levels = (0..=last)
            .map(|k| {
                let [width, height, depth] = sides.map(|s| (s >> k).max(1));
                TextureLevel { width, height, depth, texels: vec![0; (width * height * depth * layers) as usize].into() }
            })
            .collect();
        TextureImage { id: 0, kind, format: TexelFormat::Rgba8, levels }
    }

    #[test]
    fn levels_lie_one_behind_the_other() {
        for (kind, sides, layers, halvings) in [
            (TextureKind::D2, [256, 256, 1], 1, 2),
            (TextureKind::D2, [100, 75, 1], 1, 2),
            (TextureKind::D2, [1024, 2, 1], 1, 1),
            (TextureKind::D1, [1, 1, 1], 1, 2),
            (TextureKind::D1, [512, 1, 1], 1, 1),
            (TextureKind::D3, [32, 16, 8], 1, 2),
            (TextureKind::Cube, [64, 64, 1], 6, 2),
        ] {
            let image = image(kind, sides, layers);
            let room = LevelRoom::new(&image, false);
            assert_eq!(room.halvings, halvings, "{kind:?} {sides:?}");
            let mut end = 0;
            for (k, level) in image.levels.iter().enumerate() {
                assert!(room.offset(k as u32) >= end, "{kind:?} {sides:?} level {k}");
                end = room.offset(k as u32) + level.texels.len() as u32;
            }
        }
    }
}
