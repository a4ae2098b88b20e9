//! glReadPixels (4.3.2), and the read side of the copies.

use super::Context;
use super::enums::*;
use super::framebuffer::{Rect, bounds, read_depth, read_stencil};
use super::framebuffer_object::Aspect;
use super::pixel_format::{Groups, check, pack};

impl Context {
    /// Colours of a rectangle before transfer, zero outside the window.
    pub(crate) fn read_padded_colors(&mut self, rect: Rect) -> Option<Groups> {
        let (inside, groups) = self.read_colors(rect)?;
        Some(match groups {
            Groups::Rgba8(p) => Groups::Rgba8(pad(p, inside, rect, 0)),
            Groups::Rgba(p) => Groups::Rgba(pad(p, inside, rect, [0.0; 4])),
            other => other,
        })
    }

    /// The same after transfer, as the copies into textures want them.
    pub(crate) fn read_transferred_colors(&mut self, rect: Rect) -> Groups {
        let blank = || Groups::Rgba8(vec![0; rect.width() * rect.height()]);
        let groups = self.read_padded_colors(rect).unwrap_or_else(blank);
        self.state.pixel.transferred_colors(groups)
    }

    /// The part of a rectangle that can be read, and its depths.
    pub(crate) fn read_depths(&mut self, rect: Rect) -> Option<(Rect, Vec<f64>)> {
        self.look_at_pixels(Aspect::Depth, |pixels| {
            let inside = rect.and(bounds(pixels));
            (inside, read_depth(pixels, inside))
        })
    }

    /// The same for its stencil values.
    pub(crate) fn read_stencils(&mut self, rect: Rect) -> Option<(Rect, Vec<u32>)> {
        self.look_at_pixels(Aspect::Stencil, |pixels| {
            let inside = rect.and(bounds(pixels));
            (inside, read_stencil(pixels, inside))
        })
    }

    /// The same for both: depth in 24 bits below the stencil.
    pub(crate) fn read_depths_and_stencils(&mut self, rect: Rect) -> Option<(Rect, Vec<u32>)> {
        let (inside, depths) = self.read_depths(rect)?;
        let (_, indices) = self.read_stencils(rect)?;
        let word = |(depth, index): (f64, u32)| (depth * 16777215.0).round() as u32 | index << 24;
        Some((inside, depths.into_iter().zip(indices).map(word).collect()))
    }

    /// glReadPixels. `out`: from the client's pointer on, as [`Context::pack_bytes`] says. Pixels outside the window are
    /// left untouched.
    pub fn read_pixels(&mut self, x: i32, y: i32, width: i32, height: i32, format: GLenum, ty: GLenum, out: Option<&mut [u8]>) {
        if self.inside_begin_end() {
            return;
        }
        let checked =
            if width < 0 || height < 0 { Err(GL_INVALID_VALUE) } else { check(format, ty).and_then(|()| self.check_readable(format)) };
        if let Err(error) = checked {
            return self.set_error(error, "glReadPixels");
        }
        let Some(out) = out else { return };
        let rect = Rect::new(x, y, width, height);
        let read = match format {
            GL_DEPTH_COMPONENT => self
                .read_depths(rect)
                .map(|(inside, depths)| (inside, Groups::Depth(depths.into_iter().map(|d| self.state.pixel.transfer_depth(d)).collect()))),
            GL_DEPTH_STENCIL => self.read_depths_and_stencils(rect).map(|(inside, words)| {
                (inside, Groups::DepthStencil(words.into_iter().map(|w| self.state.pixel.transfer_depth_stencil(w)).collect()))
            }),
            GL_STENCIL_INDEX => self.read_stencils(rect).map(|(inside, indices)| {
                (inside, Groups::Index(indices.into_iter().map(|s| self.state.pixel.transfer_stencil(s)).collect()))
            }),
            _ => self.read_colors(rect).map(|(inside, colors)| (inside, self.state.pixel.transferred_colors(colors))),
        };
        let Some((inside, groups)) = read.filter(|(inside, _)| !inside.is_empty()) else { return };
        // The rows of the client's image stay where they are: what is cut off is skipped.
        let mut store = self.state.pack.clone();
        if store.row_length == 0 {
            store.row_length = width;
        }
        let (Some(skip_pixels), Some(skip_rows)) =
            (store.skip_pixels.checked_add(inside.min[0] - x), store.skip_rows.checked_add(inside.min[1] - y))
        else {
            return;
        };
        (store.skip_pixels, store.skip_rows) = (skip_pixels, skip_rows);
        pack(&store, out, [inside.width(), inside.height(), 1], false, format, ty, &groups);
    }
}

/// Puts the groups of the inner rectangle into the outer one.
pub(crate) fn pad<T: Copy>(groups: Vec<T>, inside: Rect, outside: Rect, fill: T) -> Vec<T> {
    if inside == outside {
        return groups;
    }
    let mut out = vec![fill; outside.width() * outside.height()];
    if inside.is_empty() {
        return out;
    }
    let first = (inside.min[0] - outside.min[0]) as usize;
    for (row, source) in groups.chunks_exact(inside.width()).enumerate() {
        let y = (inside.min[1] - outside.min[1]) as usize + row;
        out[y * outside.width() + first..][..inside.width()].copy_from_slice(source);
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn copies_from_beyond_the_window_are_padded() {
        let inside = Rect::new(0, 0, 1, 2);
        let outside = Rect::new(-1, -1, 3, 4);
        assert_eq!(pad(vec![7, 8], inside, outside, 0), [0, 0, 0, 0, 7, 0, 0, 8, 0, 0, 0, 0]);
        let elsewhere = Rect::new(5, 5, 2, 1);
        assert_eq!(pad(Vec::new(), elsewhere.and(inside), elsewhere, 1), [1, 1]);
    }
}
