//! The accumulation buffer (4.2.4): 16-bit signed normalised components, as OSMesa's.

use super::Context;
use super::enums::*;
use super::framebuffer::{Rect, bounds, pixel_index, write_color};
use super::pixel_format::Groups;

/// An accumulation buffer, bottom row first.
pub(crate) struct AccumBuffer {
    width: usize,
    height: usize,
    values: Vec<[i16; 4]>,
}

/// The accumulation value of a clear colour's component, as Mesa converts it.
fn clear_value(value: f32) -> i16 {
    (((65535.0 * value) as i32 - 1) / 2) as i16
}

/// Rounds towards zero. Values beyond [-1, 1] are undefined (4.2.4); they wrap around, as in Mesa.
fn truncate(value: f32) -> i16 {
    value as i32 as i16
}

impl AccumBuffer {
    fn new(width: usize, height: usize) -> AccumBuffer {
        AccumBuffer { width, height, values: vec![[0; 4]; width * height] }
    }

    fn row_mut(&mut self, rect: Rect, y: i32) -> &mut [[i16; 4]] {
        let first = y as usize * self.width + rect.min[0] as usize;
        &mut self.values[first..first + rect.width()]
    }

    fn update(&mut self, rect: Rect, f: impl Fn(i16) -> i16) {
        for y in rect.min[1]..rect.max[1] {
            for value in self.row_mut(rect, y) {
                *value = value.map(&f);
            }
        }
    }
}

impl Context {
    /// The part of what is drawn to that the scissor leaves.
    pub(crate) fn scissored_window(&self) -> Rect {
        let [width, height] = self.draw_size().map(|n| n as i32);
        let window = Rect::new(0, 0, width, height);
        let scissor = &self.state.scissor;
        if scissor.test { window.and(Rect::new(scissor.x, scissor.y, scissor.width, scissor.height)) } else { window }
    }

    /// The accumulation buffer of the window's size, zeroed when it is new.
    fn accum_buffer(&mut self) -> &mut AccumBuffer {
        let [width, height] = self.window_size.map(|n| n as usize);
        if !self.pixel_objects.accum.as_ref().is_some_and(|a| a.width == width && a.height == height) {
            self.pixel_objects.accum = None;
        }
        self.pixel_objects.accum.get_or_insert_with(|| AccumBuffer::new(width, height))
    }

    /// The GL_ACCUM_BUFFER_BIT of glClear. Nothing happens where the context has no accumulation buffer.
    pub(crate) fn clear_accum_buffer(&mut self) {
        if self.config.accum_bits == 0 || self.fbo.draw != 0 {
            return;
        }
        let value = self.state.accum_clear.map(clear_value);
        let rect = self.scissored_window();
        let buffer = self.accum_buffer();
        (rect.min[1]..rect.max[1]).for_each(|y| buffer.row_mut(rect, y).fill(value));
    }

    /// glAccum
    pub fn accum(&mut self, op: GLenum, value: f32) {
        if self.compile(move |cx| cx.accum(op, value)) || self.inside_begin_end() {
            return;
        }
        if !matches!(op, GL_ACCUM | GL_LOAD | GL_ADD | GL_MULT | GL_RETURN) {
            return self.set_error(GL_INVALID_ENUM, "glAccum");
        }
        if self.config.accum_bits == 0 || self.fbo.draw != 0 || self.fbo.read != 0 {
            return self.set_error(GL_INVALID_OPERATION, "glAccum without an accumulation buffer");
        }
        if self.render_mode != GL_RENDER {
            return;
        }
        let rect = self.scissored_window();
        if rect.is_empty() {
            return;
        }
        match op {
            GL_ADD => self.accum_buffer().update(rect, |a| a.wrapping_add(truncate(value * 32767.0))),
            GL_MULT => self.accum_buffer().update(rect, |a| truncate(a as f32 * value)),
            GL_RETURN => self.return_accum(rect, value),
            _ => self.load_accum(rect, value, op == GL_ACCUM),
        }
    }

    fn load_accum(&mut self, rect: Rect, value: f32, add: bool) {
        let Some((rect, groups)) = self.read_colors(rect) else { return };
        let colors = match groups {
            Groups::Rgba8(p) => p.iter().map(|p| p.to_le_bytes().map(|c| c as f32 * (1.0 / 255.0))).collect(),
            Groups::Rgba(p) => p,
            _ => return,
        };
        let scale = value * 32767.0;
        let buffer = self.accum_buffer();
        for (row, colors) in colors.chunks_exact(rect.width().max(1)).enumerate() {
            for (accum, color) in buffer.row_mut(rect, rect.min[1] + row as i32).iter_mut().zip(colors) {
                *accum = std::array::from_fn(|k| {
                    let new = truncate(color[k] * scale);
                    if add { accum[k].wrapping_add(new) } else { new }
                });
            }
        }
    }

    fn return_accum(&mut self, rect: Rect, value: f32) {
        if !self.draws_color() {
            return;
        }
        let mask = self.state.color_buffer.color_mask.iter().enumerate().fold(0, |m, (k, &on)| m | (on as u32) << k);
        self.flush_batch();
        self.window_changed = true;
        self.accum_buffer();
        let (Some(buffer), Some(window)) = (self.pixel_objects.accum.as_mut(), self.window.as_mut()) else { return };
        let pixels = &mut window.pixels();
        let scale = value / 32767.0;
        let rect = rect.and(bounds(pixels));
        for y in rect.min[1]..rect.max[1] {
            let first = pixel_index(pixels, rect.min[0], y);
            for (x, accum) in buffer.row_mut(rect, y).iter().enumerate() {
                write_color(pixels, first + x, accum.map(|a| (a as f32 * scale).clamp(0.0, 1.0)), mask);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn clear_values_saturate() {
        assert_eq!([1.0, 0.0, -1.0, 0.2].map(clear_value), [32767, 0, -32768, 6553]);
    }

    #[test]
    fn operations_stay_inside_the_rectangle() {
        let mut buffer = AccumBuffer::new(3, 3);
        buffer.update(Rect::new(1, 1, 1, 2), |a| a + 5);
        let set: Vec<usize> = buffer.values.iter().enumerate().filter(|(_, v)| v[0] != 0).map(|(i, _)| i).collect();
        assert_eq!(set, [4, 7]);
    }
}
