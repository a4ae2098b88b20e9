//! Colour formats other than RGBA8: a pixel at a time.

use super::layout::*;
use crate::device::ColorFormat;

fn unorm(v: f32, most: f32) -> u32 {
    (if v > 0.0 { v.min(1.0) } else { 0.0 } * most).round_ties_even() as u32
}

/// Packs a colour into the words of a pixel.
pub fn pack(format: ColorFormat, c: [f32; 4], words: &mut [u32]) {
    match format {
        ColorFormat::Rgba8 | ColorFormat::Rgbx8 => {
            words[0] = (0..4).map(|k| unorm(c[k], 255.0) << (8 * k)).sum();
            if format == ColorFormat::Rgbx8 {
                words[0] |= 0xff00_0000;
            }
        }
        ColorFormat::Rgb565 => words[0] = unorm(c[0], 31.0) | unorm(c[1], 63.0) << 5 | unorm(c[2], 31.0) << 11,
        ColorFormat::Rgba16 => {
            words[0] = unorm(c[0], 65535.0) | unorm(c[1], 65535.0) << 16;
            words[1] = unorm(c[2], 65535.0) | unorm(c[3], 65535.0) << 16;
        }
        ColorFormat::Rgba32f => {
            for k in 0..4 {
                words[k] = c[k].to_bits();
            }
        }
    }
}

/// Unpacks the words of a pixel.
pub fn unpack(format: ColorFormat, words: &[u32]) -> [f32; 4] {
    match format {
        ColorFormat::Rgba8 | ColorFormat::Rgbx8 => {
            let mut c = std::array::from_fn(|k| (words[0] >> (8 * k) & 255) as f32 / 255.0);
            if format == ColorFormat::Rgbx8 {
                c[3] = 1.0;
            }
            c
        }
        ColorFormat::Rgb565 => {
            [(words[0] & 31) as f32 / 31.0, (words[0] >> 5 & 63) as f32 / 63.0, (words[0] >> 11 & 31) as f32 / 31.0, 1.0]
        }
        ColorFormat::Rgba16 => std::array::from_fn(|k| (words[k / 2] >> (16 * (k & 1)) & 0xffff) as f32 / 65535.0),
        ColorFormat::Rgba32f => std::array::from_fn(|k| f32::from_bits(words[k])),
    }
}

/// The bits of a pixel's words that a colour mask (as bytes of RGBA8) lets through.
pub fn mask(format: ColorFormat, bytes: u32, words: &mut [u32]) {
    let on = |k: u32| bytes >> (8 * k) & 1 != 0;
    let bits = |k: u32, b: u32| if on(k) { b } else { 0 };
    match format {
        ColorFormat::Rgba8 => words[0] = bytes,
        ColorFormat::Rgbx8 => words[0] = bytes | 0xff00_0000,
        ColorFormat::Rgb565 => words[0] = bits(0, 31) | bits(1, 63 << 5) | bits(2, 31 << 11) | 0xffff_0000,
        ColorFormat::Rgba16 => {
            words[0] = bits(0, 0xffff) | bits(1, 0xffff_0000);
            words[1] = bits(2, 0xffff) | bits(3, 0xffff_0000);
        }
        ColorFormat::Rgba32f => (0..4).for_each(|k| words[k as usize] = bits(k, !0)),
    }
}

fn factor(f: u32, s: [f32; 4], d: [f32; 4], constant: [f32; 4]) -> [f32; 4] {
    use blend_factor::*;
    let not = |c: [f32; 4]| c.map(|v| 1.0 - v);
    match f {
        ZERO => [0.0; 4],
        ONE => [1.0; 4],
        SRC_COLOR => s,
        ONE_MINUS_SRC_COLOR => not(s),
        SRC_ALPHA => [s[3]; 4],
        ONE_MINUS_SRC_ALPHA => not([s[3]; 4]),
        DST_ALPHA => [d[3]; 4],
        ONE_MINUS_DST_ALPHA => not([d[3]; 4]),
        DST_COLOR => d,
        ONE_MINUS_DST_COLOR => not(d),
        SRC_ALPHA_SATURATE => {
            let f = s[3].min(1.0 - d[3]);
            [f, f, f, 1.0]
        }
        CONSTANT_COLOR => constant,
        ONE_MINUS_CONSTANT_COLOR => not(constant),
        CONSTANT_ALPHA => [constant[3]; 4],
        _ => not([constant[3]; 4]),
    }
}

fn blend(state: &FragmentState, s: [f32; 4], d: [f32; 4]) -> [f32; 4] {
    let one = |k: usize, c: usize| {
        let a = s[c] * factor(state.blend_factors[2 * k], s, d, state.blend_color)[c];
        let b = d[c] * factor(state.blend_factors[2 * k + 1], s, d, state.blend_color)[c];
        match state.blend_equations[k] {
            blend_equation::SUBTRACT => a - b,
            blend_equation::REVERSE_SUBTRACT => b - a,
            blend_equation::MIN => s[c].min(d[c]),
            blend_equation::MAX => s[c].max(d[c]),
            _ => a + b,
        }
    };
    [one(0, 0), one(0, 1), one(0, 2), one(1, 3)]
}

/// Writes the pixels of `bits` of a row of eight.
pub fn write(state: &FragmentState, format: ColorFormat, color: &mut [u32], first: usize, bits: u32, columns: &[[f32; 8]; 4]) {
    let words = format.words();
    let mut write_mask = [0; 4];
    mask(format, super::blend::mask_bits(state.color_mask), &mut write_mask[..words]);
    for lane in (0..8).filter(|l| bits >> l & 1 != 0) {
        let at = (first + lane) * words;
        let old = &mut color[at..at + words];
        let mut s: [f32; 4] = std::array::from_fn(|c| columns[c][lane]);
        if format != ColorFormat::Rgba32f {
            s = s.map(|v| if v > 0.0 { v.min(1.0) } else { 0.0 });
        }
        if state.flags & fragment_flags::BLEND != 0 {
            s = blend(state, s, unpack(format, old));
        }
        let mut new = [0; 4];
        pack(format, s, &mut new[..words]);
        for k in 0..words {
            let mut v = new[k];
            if state.flags & fragment_flags::LOGIC_OP != 0 && format != ColorFormat::Rgba32f {
                v = logic(state.logic_op, v, old[k]);
            }
            old[k] = v & write_mask[k] | old[k] & !write_mask[k];
        }
    }
}

fn logic(op: u32, s: u32, d: u32) -> u32 {
    // The op's bits are its truth table: bit 0 for s & d ... in GL's order of the ops.
    (if op & 1 != 0 { s & d } else { 0 })
        | (if op & 2 != 0 { s & !d } else { 0 })
        | (if op & 4 != 0 { !s & d } else { 0 })
        | (if op & 8 != 0 { !s & !d } else { 0 })
}
