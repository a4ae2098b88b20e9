//! Selection (5.2): the name stack and hit records. Primitives come assembled; what is left of them after clipping and
//! culling is a hit.

use super::Context;
use super::enums::*;
use super::state::NAME_STACK_DEPTH;

/// The name stack and the records so far.
#[derive(Default)]
pub(crate) struct Selection {
    /// Where the application wants the records, as an address; `None` before glSelectBuffer.
    pub buffer: Option<(usize, usize)>,
    pub names: Vec<u32>,
    /// Least and greatest window z of the hits since the last record.
    hit: Option<[f32; 2]>,
    records: Vec<u32>,
    count: i32,
    overflow: bool,
}

impl Selection {
    /// A vertex of a hit.
    pub fn hit(&mut self, z: f32) {
        let [least, greatest] = self.hit.unwrap_or([z, z]);
        self.hit = Some([least.min(z), greatest.max(z)]);
    }

    /// Writes the record of the hits since the last one, if there were any.
    fn finish_record(&mut self) {
        let Some(range) = self.hit.take() else { return };
        let size = self.buffer.map_or(0, |(_, size)| size);
        let depths = range.map(|z| (z.clamp(0.0, 1.0) as f64 * u32::MAX as f64).round() as u32);
        self.count = self.count.saturating_add(1);
        for word in [self.names.len() as u32].into_iter().chain(depths).chain(self.names.iter().copied()) {
            if self.records.len() == size {
                self.overflow = true;
                return;
            }
            self.records.push(word);
        }
    }

    /// Starts selecting.
    pub fn start(&mut self) {
        *self = Selection { buffer: self.buffer, ..Selection::default() };
    }

    /// Ends selecting: the number of hits, -1 if they did not fit, and the records.
    pub fn finish(&mut self) -> (i32, Vec<u32>) {
        self.finish_record();
        let count = if self.overflow { -1 } else { self.count };
        let records = std::mem::take(&mut self.records);
        self.start();
        (count, records)
    }
}

impl Context {
    /// glSelectBuffer: `address` is the application's, for [`Context::render_mode`] to hand back.
    pub fn select_buffer(&mut self, size: i32, address: usize) {
        if self.inside_begin_end() {
            return;
        }
        if self.render_mode == GL_SELECT {
            return self.set_error(GL_INVALID_OPERATION, "glSelectBuffer in selection mode");
        }
        if size < 0 {
            return self.set_error(GL_INVALID_VALUE, "glSelectBuffer");
        }
        self.selection.buffer = Some((address, size as usize));
    }

    /// glGetPointerv of GL_SELECTION_BUFFER_POINTER and GL_FEEDBACK_BUFFER_POINTER: the address given, 0 before.
    pub(crate) fn result_buffer(&self, pname: GLenum) -> Option<usize> {
        match pname {
            GL_SELECTION_BUFFER_POINTER => Some(self.selection.buffer.map_or(0, |(address, _)| address)),
            GL_FEEDBACK_BUFFER_POINTER => Some(self.feedback.buffer.map_or(0, |(address, _, _)| address)),
            _ => None,
        }
    }

    /// glInitNames.
    pub fn init_names(&mut self) {
        if self.compile(|cx| cx.init_names()) || self.inside_begin_end() {
            return;
        }
        if self.render_mode == GL_SELECT {
            self.selection.finish_record();
            self.selection.names.clear();
        }
    }

    /// glLoadName.
    pub fn load_name(&mut self, name: u32) {
        if self.compile(move |cx| cx.load_name(name)) || self.inside_begin_end() || self.render_mode != GL_SELECT {
            return;
        }
        if self.selection.names.is_empty() {
            return self.set_error(GL_INVALID_OPERATION, "glLoadName on an empty name stack");
        }
        self.selection.finish_record();
        if let Some(top) = self.selection.names.last_mut() {
            *top = name;
        }
    }

    /// glPushName.
    pub fn push_name(&mut self, name: u32) {
        if self.compile(move |cx| cx.push_name(name)) || self.inside_begin_end() || self.render_mode != GL_SELECT {
            return;
        }
        self.selection.finish_record();
        if self.selection.names.len() >= NAME_STACK_DEPTH {
            return self.set_error(GL_STACK_OVERFLOW, "glPushName");
        }
        self.selection.names.push(name);
    }

    /// glPopName.
    pub fn pop_name(&mut self) {
        if self.compile(|cx| cx.pop_name()) || self.inside_begin_end() || self.render_mode != GL_SELECT {
            return;
        }
        self.selection.finish_record();
        if self.selection.names.pop().is_none() {
            self.set_error(GL_STACK_UNDERFLOW, "glPopName");
        }
    }

    /// A valid raster position is a hit, too.
    pub(crate) fn record_hit(&mut self, z: f32) {
        if self.render_mode == GL_SELECT {
            self.selection.hit(z);
        }
    }
}
