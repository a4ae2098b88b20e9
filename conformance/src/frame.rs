//! What one scene left behind on one implementation, and the difference of two such results.

use std::path::Path;

use serde::Serialize;

use crate::flip::mean_flip;

/// The result of a scene: pixels bottom row first.
#[derive(Clone)]
pub struct Frame {
    /// Columns.
    pub width: usize,
    /// RGBA8.
    pub color: Vec<u8>,
    /// In units of the depth format; of floating point, the bits.
    pub depth: Vec<u32>,
    /// Stencil values.
    pub stencil: Vec<u8>,
    /// Text lines.
    pub text: Vec<String>,
    /// The GL error that was left, or GL_NO_ERROR.
    pub error: String,
    /// What a pixel that nothing touched looks like.
    background: ([u8; 4], u32),
}

impl Frame {
    /// A black image with this stencil buffer.
    #[cfg(test)]
    pub fn of_stencil(width: usize, stencil: Vec<u8>) -> Frame {
        let (color, depth) = (vec![0; stencil.len() * 4], vec![0; stencil.len()]);
        Frame { width, color, depth, stencil, text: Vec::new(), error: String::new(), background: ([0; 4], 0) }
    }

    /// Reads the files that the runner wrote under `prefix`.
    pub fn read(prefix: &Path) -> Result<Frame, String> {
        let file = |suffix: &str| {
            let path = prefix.with_extension(suffix);
            std::fs::read(&path).map_err(|e| format!("{}: {e}", path.display()))
        };
        let string = |suffix: &str| file(suffix).map(|b| String::from_utf8_lossy(&b).into_owned());
        let meta = string("meta")?;
        let fields: Vec<&str> = meta.split_whitespace().collect();
        let number = |i: usize| fields.get(i).and_then(|f| f.parse::<f64>().ok()).ok_or_else(|| format!("meta: {meta:?}"));
        let unorm8 = |v: f64| (v.clamp(0.0, 1.0) * 255.0).round() as u8;
        let far = match number(2)? as u32 {
            32 => (number(7)? as f32).to_bits(),
            bits => (number(7)? * ((1u64 << bits) as f64 - 1.0)).round() as u32,
        };
        Ok(Frame {
            width: number(0)? as usize,
            color: file("color")?,
            depth: file("depth")?.chunks_exact(4).map(|c| u32::from_le_bytes([c[0], c[1], c[2], c[3]])).collect(),
            stencil: file("stencil")?,
            text: string("text")?.lines().map(str::to_owned).collect(),
            error: fields.get(8).copied().unwrap_or("?").to_owned(),
            background: ([unorm8(number(3)?), unorm8(number(4)?), unorm8(number(5)?), unorm8(number(6)?)], far),
        })
    }

    fn covered(&self, pixel: usize) -> bool {
        self.color[pixel * 4..pixel * 4 + 4] != self.background.0 || self.depth[pixel] != self.background.1 || self.stencil[pixel] != 0
    }

    /// Writes the colour buffer as an opaque PNG, top row first.
    pub fn save(&self, path: &Path) -> Result<(), String> {
        save_png(path, self.width, self.color.chunks_exact(4).map(|p| [p[0], p[1], p[2]]).collect())
    }
}

fn save_png(path: &Path, width: usize, pixels: Vec<[u8; 3]>) -> Result<(), String> {
    let rows: Vec<u8> = pixels.chunks_exact(width).rev().flatten().flatten().copied().collect();
    let height = rows.len() / 3 / width;
    image::save_buffer(path, &rows, width as u32, height as u32, image::ColorType::Rgb8).map_err(|e| format!("{}: {e}", path.display()))
}

/// How two results of one scene differ.
#[derive(Clone, Debug, Default, Serialize)]
pub struct Difference {
    /// Pixels of the image.
    pub size: u64,
    /// Pixels of which a colour component differs.
    pub pixels: u64,
    /// Largest difference of a component, of 255.
    pub max: u64,
    /// Mean difference of a component, of 255.
    pub mean: f64,
    /// Mean FLIP error, 0 to 1.
    pub flip: f64,
    /// Pixels that only one of the two touched.
    pub coverage: u64,
    /// Pixels of which depth differs.
    pub depth_pixels: u64,
    /// Largest difference of depth in units of its format.
    pub depth_max: u64,
    /// Pixels of which stencil differs.
    pub stencil: u64,
    /// Text lines that differ, the GL error left at the end counted as one.
    pub text: u64,
    /// The first lines that differ: reference, test.
    pub text_sample: Vec<(String, String)>,
}

/// Compares `test` with `reference`.
pub fn compare(reference: &Frame, test: &Frame) -> Difference {
    let size = reference.depth.len().min(test.depth.len());
    let mut d = Difference { size: size as u64, ..Difference::default() };
    let mut sum = 0u64;
    for i in 0..size {
        let components = reference.color[i * 4..i * 4 + 4].iter().zip(&test.color[i * 4..i * 4 + 4]);
        let differences = components.map(|(r, t)| u64::from(r.abs_diff(*t)));
        let (largest, total) = differences.fold((0, 0), |(m, s), v| (v.max(m), s + v));
        d.pixels += u64::from(largest > 0);
        d.max = d.max.max(largest);
        sum += total;
        let depth = reference.depth[i].abs_diff(test.depth[i]);
        d.depth_pixels += u64::from(depth > 0);
        d.depth_max = d.depth_max.max(u64::from(depth));
        d.stencil += u64::from(reference.stencil[i] != test.stencil[i]);
        d.coverage += u64::from(reference.covered(i) != test.covered(i));
    }
    d.mean = sum as f64 / (size as f64 * 4.0).max(1.0);
    if d.pixels > 0 {
        d.flip = mean_flip(&reference.color, &test.color, reference.width);
    }
    let missing = "(no such line)".to_owned();
    for i in 0..reference.text.len().max(test.text.len()) {
        let (r, t) = (reference.text.get(i).unwrap_or(&missing), test.text.get(i).unwrap_or(&missing));
        if r != t {
            d.text += 1;
            d.text_sample.push((r.clone(), t.clone()));
        }
    }
    if reference.error != test.error {
        d.text += 1;
        d.text_sample.push((format!("left at the end: {}", reference.error), format!("left at the end: {}", test.error)));
    }
    d.text_sample.truncate(40);
    d
}

/// Writes the difference of the colours, sixteen times as strong as it is; alpha counts on every component.
pub fn save_difference(reference: &Frame, test: &Frame, path: &Path) -> Result<(), String> {
    let pixels = reference.color.chunks_exact(4).zip(test.color.chunks_exact(4)).map(|(r, t)| {
        let alpha = u32::from(r[3].abs_diff(t[3]));
        [0, 1, 2].map(|c| (16 * (u32::from(r[c].abs_diff(t[c])) + alpha)).min(255) as u8)
    });
    save_png(path, reference.width, pixels.collect())
}
