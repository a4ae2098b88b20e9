//! Where the groups of a pixel rectangle land: raster position and zoom (3.6.5, figure 3.8).

use super::Context;
use super::framebuffer::Rect;
use crate::device::DepthFormat;

/// A pixel rectangle placed on the window, cut to its visible part.
pub(crate) struct Placed {
    /// The window pixels that it covers, GL's rows.
    pub rect: Rect,
    /// The group's column of each window column.
    pub columns: Vec<usize>,
    /// The group's row of each window row.
    pub rows: Vec<usize>,
}

/// Window pixels whose centres lie in the zoomed run of `count` groups from `origin` on, within `window` pixels, and the
/// group that each falls into. A centre on the left (lower) edge of a group belongs to it.
fn run(origin: i64, zoom: f32, count: usize, window: [i32; 2]) -> (i32, Vec<usize>) {
    if zoom == 1.0 {
        let first = (window[0] as i64).max(origin);
        let last = (window[1] as i64).min(origin.saturating_add(count as i64));
        let groups = (first..last.max(first)).map(|x| (x - origin) as usize).collect();
        return (first.min(window[1] as i64) as i32, groups);
    }
    let zoom = zoom as f64;
    let far = origin as f64 + zoom * count as f64;
    let (low, high) = (far.min(origin as f64), far.max(origin as f64));
    // The first centre x + 1/2 that is not below an edge.
    let centre_from = |edge: f64| (edge - 0.5).ceil().clamp(window[0] as f64, window[1] as f64) as i32;
    let (first, last) = (centre_from(low), centre_from(high));
    let group = |x: i32| {
        // In single precision: a zoom of 1.7 is meant to put an edge where ten groups end at 17.
        let t = (x as f64 + 0.5 - origin as f64) as f32 / zoom as f32;
        let index = if zoom > 0.0 { t.floor() } else { t.ceil() - 1.0 };
        (index.max(0.0) as usize).min(count.saturating_sub(1))
    };
    if count == 0 || zoom == 0.0 || zoom.is_nan() { (first, Vec::new()) } else { (first, (first..last).map(group).collect()) }
}

impl Placed {
    /// Picks the group of every covered pixel, bottom row first.
    pub fn resample<T: Copy>(&self, groups: &[T], width: usize) -> Vec<T> {
        let mut out = Vec::with_capacity(self.columns.len() * self.rows.len());
        let straight = self.columns.windows(2).all(|pair| pair[1] == pair[0] + 1);
        for &row in &self.rows {
            let row = &groups[row * width..(row + 1) * width];
            if straight && let Some(&first) = self.columns.first() {
                out.extend_from_slice(&row[first..first + self.columns.len()]);
            } else {
                out.extend(self.columns.iter().map(|&column| row[column]));
            }
        }
        out
    }
}

impl Context {
    /// Places a rectangle of `size` groups at the raster position. None where nothing is visible: an invalid raster
    /// position, no window, all of it outside.
    pub(crate) fn place_rectangle(&self, size: [usize; 2]) -> Option<Placed> {
        let raster = &self.state.current.raster;
        if !raster.valid {
            return None;
        }
        // As Mesa: the raster position is rounded to a pixel corner first, halves away from zero.
        let origin = [raster.position[0], raster.position[1]].map(|p| p.round() as i64);
        let visible = self.scissored_window();
        let zoom = self.state.pixel.zoom;
        let (x, columns) = run(origin[0], zoom[0], size[0], [visible.min[0], visible.max[0]]);
        let (y, rows) = run(origin[1], zoom[1], size[1], [visible.min[1], visible.max[1]]);
        let rect = Rect::new(x, y, columns.len() as i32, rows.len() as i32);
        (!rect.is_empty()).then_some(Placed { rect, columns, rows })
    }

    /// Fragments of a pixel rectangle reach the window unchanged: nothing of texturing, fog and the per-fragment operations is
    /// on but the scissor and the colour mask.
    pub(crate) fn fragments_pass_unchanged(&self) -> bool {
        let s = &self.state;
        let color = &s.color_buffer;
        let textured = s.texture.units.iter().any(|unit| unit.enabled.contains(&true));
        let format = self.draw_format();
        let depth = s.depth.test && format.depth != DepthFormat::None;
        let stencil = s.stencil.test && format.stencil;
        !(textured || depth || stencil || s.fog.enabled || s.lighting.color_sum || color.alpha_test || color.blend || color.color_logic_op)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn without_zoom_groups_are_pixels() {
        assert_eq!(run(2, 1.0, 3, [0, 10]), (2, vec![0, 1, 2]));
        assert_eq!(run(-1, 1.0, 3, [0, 10]), (0, vec![1, 2]));
        assert_eq!(run(9, 1.0, 3, [0, 10]), (9, vec![0]));
        assert_eq!(run(12, 1.0, 3, [0, 10]).1, Vec::<usize>::new());
        assert_eq!(run(-5, 1.0, 3, [0, 10]).1, Vec::<usize>::new());
    }

    #[test]
    fn zoom_repeats_drops_and_mirrors_groups() {
        assert_eq!(run(1, 2.0, 2, [0, 10]), (1, vec![0, 0, 1, 1]));
        assert_eq!(run(0, 0.5, 4, [0, 10]), (0, vec![1, 3]));
        assert_eq!(run(4, -1.0, 3, [0, 10]), (1, vec![2, 1, 0]));
        assert_eq!(run(4, -2.0, 3, [0, 10]), (0, vec![1, 1, 0, 0]));
        assert_eq!(run(4, 0.0, 3, [0, 10]).1, Vec::<usize>::new());
        assert_eq!(run(4, f32::NAN, 3, [0, 10]).1, Vec::<usize>::new());
    }
}
