//! Feedback (5.3) and the render modes. Primitives come assembled, are shaded on the host and clipped as for drawing;
//! then they are written to the feedback buffer (polygons as the triangles they consist of) or counted as hits.

use super::Context;
use super::begin_end::slot;
use super::checks::clamp01;
use super::draws::Assembled;
use super::enums::*;
use super::host_vertices::HostVertices;
use crate::program::Output;
use crate::raster::clip::{Clipper, possible};
use crate::raster::layout::*;

/// Values for the application so far.
#[derive(Default)]
pub(crate) struct Feedback {
    /// Where the application wants the values, as an address, how many fit, and their type; `None` before glFeedbackBuffer.
    pub buffer: Option<(usize, usize, GLenum)>,
    values: Vec<f32>,
    overflow: bool,
}

/// What glRenderMode hands to the application when it leaves a mode: an address and what to write there.
#[derive(Debug, PartialEq)]
pub enum Returned {
    /// Nothing.
    Nothing,
    /// Hit records for the selection buffer.
    Selection(usize, Vec<u32>),
    /// Values for the feedback buffer.
    Feedback(usize, Vec<f32>),
}

/// A vertex as feedback returns it.
#[derive(Clone, Copy)]
struct FeedbackVertex {
    window: [f32; 3],
    clip_w: f32,
    color: [f32; 4],
    tex_coord: [f32; 4],
}

impl Feedback {
    fn push(&mut self, value: f32) {
        match self.buffer {
            Some((_, size, _)) if self.values.len() < size => self.values.push(value),
            _ => self.overflow = true,
        }
    }

    fn token(&mut self, token: GLenum) {
        self.push(token as f32);
    }

    fn vertex(&mut self, v: &FeedbackVertex) {
        let Some((_, _, kind)) = self.buffer else { return };
        self.push(v.window[0]);
        self.push(v.window[1]);
        if kind != GL_2D {
            self.push(v.window[2]);
        }
        if kind == GL_4D_COLOR_TEXTURE {
            self.push(v.clip_w);
        }
        if matches!(kind, GL_3D_COLOR | GL_3D_COLOR_TEXTURE | GL_4D_COLOR_TEXTURE) {
            v.color.into_iter().for_each(|c| self.push(c));
        }
        if matches!(kind, GL_3D_COLOR_TEXTURE | GL_4D_COLOR_TEXTURE) {
            v.tex_coord.into_iter().for_each(|c| self.push(c));
        }
    }
}

impl Context {
    /// glFeedbackBuffer: `address` is the application's, for [`Context::render_mode`] to hand back.
    pub fn feedback_buffer(&mut self, size: i32, kind: GLenum, address: usize) {
        if self.inside_begin_end() {
            return;
        }
        if self.render_mode == GL_FEEDBACK {
            return self.set_error(GL_INVALID_OPERATION, "glFeedbackBuffer in feedback mode");
        }
        if size < 0 {
            return self.set_error(GL_INVALID_VALUE, "glFeedbackBuffer");
        }
        if !(GL_2D..=GL_4D_COLOR_TEXTURE).contains(&kind) {
            return self.set_error(GL_INVALID_ENUM, "glFeedbackBuffer");
        }
        self.feedback.buffer = Some((address, size as usize, kind));
    }

    /// glPassThrough.
    pub fn pass_through(&mut self, token: f32) {
        if self.compile(move |cx| cx.pass_through(token)) || self.inside_begin_end() {
            return;
        }
        if self.render_mode == GL_FEEDBACK {
            self.feedback.token(GL_PASS_THROUGH_TOKEN);
            self.feedback.push(token);
        }
    }

    /// glRenderMode: what it returns, and what the application's buffer gets.
    pub fn render_mode(&mut self, mode: GLenum) -> (i32, Returned) {
        if self.inside_begin_end() {
            return (0, Returned::Nothing);
        }
        let ready = match mode {
            GL_RENDER => true,
            GL_SELECT => self.selection.buffer.is_some(),
            GL_FEEDBACK => self.feedback.buffer.is_some(),
            _ => {
                self.set_error(GL_INVALID_ENUM, "glRenderMode");
                return (0, Returned::Nothing);
            }
        };
        if !ready {
            self.set_error(GL_INVALID_OPERATION, "glRenderMode without a buffer");
            return (0, Returned::Nothing);
        }
        let result = match self.render_mode {
            GL_SELECT => {
                let (count, records) = self.selection.finish();
                (count, Returned::Selection(self.selection.buffer.map_or(0, |(address, _)| address), records))
            }
            GL_FEEDBACK => {
                let values = std::mem::take(&mut self.feedback.values);
                let overflow = std::mem::take(&mut self.feedback.overflow);
                let count = if overflow { -1 } else { values.len() as i32 };
                (count, Returned::Feedback(self.feedback.buffer.map_or(0, |(address, _, _)| address), values))
            }
            _ => (0, Returned::Nothing),
        };
        if mode == GL_SELECT {
            self.selection.start();
        }
        self.render_mode = mode;
        result
    }

    /// A pixel rectangle or bitmap at the current raster position, in feedback mode: GL_BITMAP_TOKEN,
    /// GL_DRAW_PIXEL_TOKEN or GL_COPY_PIXEL_TOKEN. True: not in render mode, nothing is drawn.
    pub(crate) fn feedback_pixels(&mut self, token: GLenum) -> bool {
        if self.render_mode == GL_FEEDBACK && self.state.current.raster.valid {
            let raster = &self.state.current.raster;
            let [x, y, z, w] = raster.position;
            let vertex = FeedbackVertex { window: [x, y, z], clip_w: w, color: raster.color, tex_coord: raster.tex_coords[0] };
            self.feedback.token(token);
            self.feedback.vertex(&vertex);
        }
        self.render_mode != GL_RENDER
    }

    /// Primitives in selection or feedback mode.
    pub(crate) fn select_or_feedback(&mut self, assembled: &Assembled) {
        let Some(vertices) = self.shade_on_host(assembled.topology, assembled.run) else { return };
        let mut clipper = Clipper::default();
        for primitive in assembled.primitives {
            let count = match assembled.topology {
                topology::POINTS => 1,
                topology::LINES => 2,
                _ => 3,
            };
            let corners = &primitive.v[..count];
            let codes = corners.iter().map(|&v| vertices.screen[v as usize].code);
            let (or, and) = codes.fold((0, !0), |(or, and), code| (or | code, and & code));
            if !possible(or, and) || count == 1 && or != 0 {
                continue;
            }
            let edge = |k: usize| primitive.draw_and_flags & (PRIM_EDGE_01 << k) != 0;
            let polygon: [_; 3] = std::array::from_fn(|k| {
                let v = corners[k.min(count - 1)] as usize;
                (&vertices.screen[v], vertices.shaded(v), edge(k))
            });
            clipper.begin(&polygon[..count]);
            let visible = match count {
                _ if or == 0 => true,
                2 => clipper.line(or, &vertices.record, &vertices.raster_state),
                _ => clipper.polygon(or, &vertices.record, &vertices.raster_state),
            };
            if visible {
                let provoking = corners[count - 1] as usize;
                self.visible_primitive(assembled, primitive, &vertices, &clipper, provoking);
            }
        }
    }

    /// What is left of a primitive after clipping.
    fn visible_primitive(
        &mut self,
        assembled: &Assembled,
        primitive: &Primitive,
        vertices: &HostVertices,
        clipper: &Clipper,
        provoking: usize,
    ) {
        let windows: Vec<[f32; 3]> = clipper.polygon.iter().map(|v| self.to_window(clipper.pool[v.at])).collect();
        let front = self.faces_front(&windows);
        let is_polygon = assembled.topology == topology::TRIANGLES;
        let polygon = &self.state.polygon;
        let culled = polygon.cull_mode == GL_FRONT_AND_BACK || (polygon.cull_mode == GL_FRONT) == front;
        if is_polygon && polygon.cull && culled {
            return;
        }
        if self.render_mode == GL_SELECT {
            return windows.iter().for_each(|window| self.selection.hit(window[2]));
        }
        let back_color = vertices.index_of(Output::BackColor).filter(|_| is_polygon && !front);
        let color_index = back_color.or_else(|| vertices.index_of(Output::FrontColor));
        let tex_index = vertices.index_of(Output::TexCoord(0));
        let flat = self.state.lighting.shade_model == GL_FLAT;
        let current = &self.state.current.attributes;
        let texture = *self.texture_matrices[0].top();
        let corner = |k: usize| -> FeedbackVertex {
            let at = clipper.polygon[k].at;
            let shaded = &clipper.pool[at..];
            let color_source = if flat { vertices.shaded(provoking) } else { shaded };
            // A vertex that clipping made has no attributes of its own; the nearest given one stands in.
            let stride = vertices.record.shaded_stride as usize;
            let given = primitive.v[(at / stride).min(2)];
            FeedbackVertex {
                window: windows[k],
                clip_w: shaded[0][3],
                color: color_index.map_or_else(|| assembled.attribute(slot::COLOR, given, current), |i| color_source[i]).map(clamp01),
                tex_coord: tex_index.map_or_else(
                    || (texture * glam::Vec4::from(assembled.attribute(slot::TEX_COORD0, given, current))).to_array(),
                    |i| shaded[i],
                ),
            }
        };
        let corners: Vec<FeedbackVertex> = (0..windows.len()).map(corner).collect();
        let mode = if is_polygon { polygon.mode[!front as usize] } else { GL_FILL };
        let reset = primitive.draw_and_flags & PRIM_RESET_STIPPLE != 0;
        let edges: Vec<bool> = clipper.polygon.iter().map(|v| v.edge).collect();
        self.write_primitive(&corners, &edges, mode, reset);
    }

    fn write_primitive(&mut self, corners: &[FeedbackVertex], edges: &[bool], mode: GLenum, reset: bool) {
        let feedback = &mut self.feedback;
        let mut line = |a: &FeedbackVertex, b: &FeedbackVertex, reset: bool| {
            feedback.token(if reset { GL_LINE_RESET_TOKEN } else { GL_LINE_TOKEN });
            feedback.vertex(a);
            feedback.vertex(b);
        };
        match (corners, mode) {
            ([point], _) => {
                feedback.token(GL_POINT_TOKEN);
                feedback.vertex(point);
            }
            ([a, b], _) => line(a, b, reset),
            (_, GL_LINE) => {
                let mut reset = reset;
                for k in 0..corners.len() {
                    if edges[k] {
                        line(&corners[k], &corners[(k + 1) % corners.len()], reset);
                        reset = false;
                    }
                }
            }
            (_, GL_POINT) => {
                for (corner, _) in corners.iter().zip(edges).filter(|(_, edge)| **edge) {
                    feedback.token(GL_POINT_TOKEN);
                    feedback.vertex(corner);
                }
            }
            _ => {
                for k in 2..corners.len() {
                    feedback.token(GL_POLYGON_TOKEN);
                    feedback.push(3.0);
                    for corner in [&corners[0], &corners[k - 1], &corners[k]] {
                        feedback.vertex(corner);
                    }
                }
            }
        }
    }

    /// Whether a polygon in window coordinates is front-facing (2.14.1).
    fn faces_front(&self, windows: &[[f32; 3]]) -> bool {
        let mut twice_area = 0.0;
        for (k, a) in windows.iter().enumerate() {
            let b = &windows[(k + 1) % windows.len()];
            twice_area += a[0] as f64 * b[1] as f64 - b[0] as f64 * a[1] as f64;
        }
        (twice_area > 0.0) == (self.state.polygon.front_face == GL_CCW)
    }
}
