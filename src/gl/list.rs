//! Display lists (5.4).
//!
//! A list is a sequence of nodes. Most commands are closures that call the method again; a whole Begin/End pair that only
//! sets attributes and vertices becomes one packed run, replayed by one copy into the batch.

use std::sync::Arc;

use super::Context;
use super::begin_end::Immediate;
use super::enums::*;
use super::state::MAX_LIST_NESTING;
use crate::draw::assembly::{Part, PrimitiveType};
use crate::draw::recorder::{Run, slots};

/// A recorded command.
pub(crate) type Command = Box<dyn Fn(&mut Context) + Send + Sync>;

/// A finished display list.
#[derive(Default)]
pub struct List {
    nodes: Vec<Node>,
}

enum Node {
    Command(Command),
    Attribute(usize, [f32; 4]),
    EdgeFlag(bool),
    Vertex([f32; 4]),
    Begin(GLenum),
    End,
    Run(PackedRun),
}

/// Everything between a Begin and its End.
pub(crate) struct PackedRun {
    pub mode: PrimitiveType,
    pub part: Part,
    pub mask: u32,
    pub data: Vec<[f32; 4]>,
    pub count: u32,
    pub edge_flags: Option<Vec<bool>>,
    /// Slots that were first set after some vertices: those take the value that is current when the list is called.
    pub leading: Vec<(usize, u32)>,
    /// Vertices before the first edge flag command: those take the edge flag that is current when the list is called.
    pub leading_edges: u32,
    /// Values that are current afterwards, for the slots in `mask` but 0.
    pub finals: Vec<(usize, [f32; 4])>,
    /// Edge flag that is current afterwards, if it was set.
    pub final_edge: Option<bool>,
}

/// The list under construction.
pub(crate) struct Builder {
    name: u32,
    /// GL_COMPILE_AND_EXECUTE
    execute: bool,
    nodes: Vec<Node>,
    /// Between a Begin and an End whose contents can still become a packed run.
    pair: Option<Pair>,
}

/// A Begin/End pair under construction.
struct Pair {
    mode: PrimitiveType,
    immediate: Immediate,
    leading: Vec<(usize, u32)>,
    leading_edges: u32,
    edge: Option<bool>,
}

/// What a context knows about lists.
#[derive(Default)]
pub(crate) struct ListState {
    pub builder: Option<Box<Builder>>,
    depth: usize,
}

impl Builder {
    /// Between a compiled Begin and its End.
    fn inside(&self) -> bool {
        self.pair.is_some()
    }

    /// Gives up packing the pair: its vertices so far become nodes.
    fn loosen(&mut self) {
        let Some(pair) = self.pair.take() else { return };
        self.nodes.push(Node::Begin(pair.mode as u32));
        let run = pair.immediate.run();
        let stride = run.mask.count_ones() as usize;
        let mut edge = None;
        for (i, vertex) in run.data.chunks_exact(stride).enumerate() {
            for (rank, slot) in slots(run.mask).enumerate().skip(1) {
                let leading = pair.leading.iter().any(|&(s, n)| s == slot && i < n as usize);
                let repeated = i > 0
                    && run.data[(i - 1) * stride + rank] == vertex[rank]
                    && !pair.leading.iter().any(|&(s, n)| s == slot && i == n as usize);
                if !leading && !repeated {
                    self.nodes.push(Node::Attribute(slot, vertex[rank]));
                }
            }
            if pair.edge.is_some() && i >= pair.leading_edges as usize && edge != Some(run.edge_flag(i as u32)) {
                edge = Some(run.edge_flag(i as u32));
                self.nodes.push(Node::EdgeFlag(run.edge_flag(i as u32)));
            }
            self.nodes.push(Node::Vertex(vertex[0]));
        }
        self.nodes.extend(pair.immediate.finals().into_iter().map(|(slot, value)| Node::Attribute(slot, value)));
        self.nodes.extend(pair.edge.map(Node::EdgeFlag));
    }
}

impl Context {
    /// Records a command into the display list under construction, if there is one. True: the command is dealt with (compiled,
    /// and executed too in GL_COMPILE_AND_EXECUTE mode), the caller returns.
    #[inline]
    pub(crate) fn compile(&mut self, command: impl Fn(&mut Context) + Send + Sync + 'static) -> bool {
        if self.lists.builder.is_none() {
            return false;
        }
        self.compile_boxed(Box::new(command));
        true
    }

    #[cold]
    fn compile_boxed(&mut self, command: Command) {
        // While the command runs there is no builder, so that what it calls is not compiled a second time.
        let Some(mut builder) = self.lists.builder.take() else { return };
        builder.loosen();
        if builder.execute {
            command(self);
        }
        builder.nodes.push(Node::Command(command));
        self.lists.builder = Some(builder);
    }

    /// Records through `record`; executes `command` too in GL_COMPILE_AND_EXECUTE mode.
    #[inline]
    fn compile_with(&mut self, record: impl FnOnce(&mut Builder), command: impl FnOnce(&mut Context)) {
        let Some(mut builder) = self.lists.builder.take() else { return };
        record(&mut builder);
        if builder.execute {
            command(self);
        }
        self.lists.builder = Some(builder);
    }

    pub(super) fn compile_begin(&mut self, mode: GLenum) {
        let record = |builder: &mut Builder| {
            let nested = builder.inside();
            builder.loosen();
            match PrimitiveType::from_gl(mode) {
                Some(mode) if !nested => {
                    let mut immediate = Immediate::default();
                    immediate.begin(mode, !0, &[[0.0; 4]; 16], true);
                    builder.pair = Some(Pair { mode, immediate, leading: Vec::new(), leading_edges: 0, edge: None });
                }
                _ => builder.nodes.push(Node::Begin(mode)),
            }
        };
        self.compile_with(record, |cx| cx.begin(mode));
    }

    pub(super) fn compile_end(&mut self) {
        let record = |builder: &mut Builder| match builder.pair.take() {
            Some(pair) => {
                let Pair { mode, immediate, leading, leading_edges, edge } = pair;
                let finals = immediate.finals();
                let leading_edges = if edge.is_some() { leading_edges } else { immediate.run().count };
                let run = immediate.run();
                let (mask, count, edge_flags) = (run.mask, run.count, run.edge_flags.map(<[bool]>::to_vec));
                let mut data = immediate.into_data();
                data.shrink_to_fit();
                let packed = PackedRun {
                    mode,
                    part: Part::default(),
                    mask,
                    data,
                    count,
                    edge_flags,
                    leading,
                    leading_edges,
                    finals,
                    final_edge: edge,
                };
                builder.nodes.push(Node::Run(packed));
            }
            None => builder.nodes.push(Node::End),
        };
        self.compile_with(record, |cx| cx.end());
    }

    pub(super) fn compile_vertex(&mut self, position: [f32; 4]) {
        let record = |builder: &mut Builder| match &mut builder.pair {
            Some(pair) => pair.immediate.vertex(position, pair.edge.unwrap_or(true)),
            None => builder.nodes.push(Node::Vertex(position)),
        };
        let [x, y, z, w] = position;
        self.compile_with(record, |cx| cx.vertex(x, y, z, w));
    }

    pub(super) fn compile_attribute(&mut self, slot: usize, value: [f32; 4]) {
        let record = |builder: &mut Builder| match &mut builder.pair {
            Some(pair) => {
                let run = pair.immediate.run();
                if run.mask & 1 << slot == 0 && run.count > 0 {
                    pair.leading.push((slot, run.count));
                }
                pair.immediate.attribute(slot, value, [0.0; 4]);
            }
            None => builder.nodes.push(Node::Attribute(slot, value)),
        };
        self.compile_with(record, |cx| cx.attribute(slot, value));
    }

    pub(super) fn compile_edge_flag(&mut self, flag: bool) {
        let record = |builder: &mut Builder| match &mut builder.pair {
            Some(pair) => {
                if pair.edge.is_none() {
                    pair.leading_edges = pair.immediate.run().count;
                }
                pair.edge = Some(flag);
                pair.immediate.start_edge_flags();
            }
            None => builder.nodes.push(Node::EdgeFlag(flag)),
        };
        self.compile_with(record, |cx| cx.edge_flag(flag));
    }

    /// Records a whole run (a vertex array) into the list under construction. The caller made sure that there is one.
    pub(super) fn compile_run(&mut self, packed: PackedRun, command: impl FnOnce(&mut Context)) {
        let record = |builder: &mut Builder| {
            builder.loosen();
            builder.nodes.push(Node::Run(packed));
        };
        self.compile_with(record, command);
    }

    /// GL_LIST_INDEX: the list under construction, or 0.
    pub(crate) fn list_index(&self) -> u32 {
        self.lists.builder.as_ref().map_or(0, |builder| builder.name)
    }

    /// GL_LIST_MODE: how it is compiled, or 0.
    pub(crate) fn list_mode(&self) -> GLenum {
        match &self.lists.builder {
            None => 0,
            Some(builder) if builder.execute => GL_COMPILE_AND_EXECUTE,
            Some(_) => GL_COMPILE,
        }
    }

    /// glNewList.
    pub fn new_list(&mut self, list: u32, mode: GLenum) {
        if self.inside_begin_end() {
            return;
        }
        if list == 0 {
            return self.set_error(GL_INVALID_VALUE, "glNewList: list 0");
        }
        if mode != GL_COMPILE && mode != GL_COMPILE_AND_EXECUTE {
            return self.set_error(GL_INVALID_ENUM, "glNewList: mode");
        }
        if self.lists.builder.is_some() {
            return self.set_error(GL_INVALID_OPERATION, "glNewList: a list is under construction");
        }
        self.lists.builder = Some(Box::new(Builder { name: list, execute: mode == GL_COMPILE_AND_EXECUTE, nodes: Vec::new(), pair: None }));
    }

    /// glEndList: the list takes the place of an older one of its name.
    pub fn end_list(&mut self) {
        if self.inside_begin_end() {
            return;
        }
        let Some(mut builder) = self.lists.builder.take() else {
            return self.set_error(GL_INVALID_OPERATION, "glEndList without glNewList");
        };
        builder.loosen();
        builder.nodes.shrink_to_fit();
        let list = Arc::new(List { nodes: builder.nodes });
        let old = self.shared().lists.define(builder.name, list);
        // Textures and other things that the old list owns are dropped outside the lock.
        drop(old);
    }

    /// glCallList.
    pub fn call_list(&mut self, list: u32) {
        if self.compile(move |cx| cx.call_list(list)) {
            return;
        }
        if self.lists.depth >= MAX_LIST_NESTING {
            return;
        }
        let Some(list) = self.shared().lists.get(list) else { return };
        self.lists.depth += 1;
        for node in &list.nodes {
            match node {
                Node::Command(command) => command(self),
                &Node::Attribute(slot, value) => self.attribute(slot, value),
                &Node::EdgeFlag(flag) => self.edge_flag(flag),
                &Node::Vertex([x, y, z, w]) => self.vertex(x, y, z, w),
                &Node::Begin(mode) => self.begin(mode),
                Node::End => self.end(),
                Node::Run(run) => self.play_run(run),
            }
        }
        self.lists.depth -= 1;
    }

    fn play_run(&mut self, packed: &PackedRun) {
        if self.inside_begin_end() {
            return;
        }
        let current = &self.state.current;
        let mut data = std::borrow::Cow::Borrowed(&packed.data[..]);
        let stride = packed.mask.count_ones() as usize;
        for &(slot, count) in &packed.leading {
            let rank = (packed.mask & ((1 << slot) - 1)).count_ones() as usize;
            let data = data.to_mut();
            for vertex in 0..count as usize {
                data[vertex * stride + rank] = current.attributes[slot];
            }
        }
        let mut edge_flags = std::borrow::Cow::Borrowed(packed.edge_flags.as_deref().unwrap_or(&[]));
        if !current.edge_flag {
            let leading = packed.leading_edges;
            let flags = edge_flags.to_mut();
            flags.resize(packed.count as usize, true);
            flags[..leading as usize].fill(false);
        }
        let run =
            Run { mask: packed.mask, data: &data, count: packed.count, edge_flags: (!edge_flags.is_empty()).then_some(&edge_flags[..]) };
        if packed.count > 0 {
            self.submit_run(packed.mode, packed.part, &run, true);
        }
        for &(slot, value) in &packed.finals {
            self.state.current.attributes[slot] = value;
        }
        if let Some(flag) = packed.final_edge {
            self.state.current.edge_flag = flag;
        }
    }

    /// glCallLists; the names are not yet offset by the list base.
    pub fn call_lists(&mut self, names: &[u32]) {
        if self.lists.builder.is_some() {
            let names = names.to_vec();
            self.compile(move |cx| cx.call_lists(&names));
            return;
        }
        for &name in names {
            self.call_list(self.state.list_base.wrapping_add(name));
        }
    }

    /// glListBase.
    pub fn list_base(&mut self, base: u32) {
        if self.compile(move |cx| cx.list_base(base)) {
            return;
        }
        if self.inside_begin_end() {
            return;
        }
        self.state.list_base = base;
    }

    /// glGenLists: the first of `range` unused names in a row, 0 if there are none.
    pub fn gen_lists(&mut self, range: i32) -> u32 {
        if self.inside_begin_end() {
            return 0;
        }
        let Ok(range) = u32::try_from(range) else {
            self.set_error(GL_INVALID_VALUE, "glGenLists: range");
            return 0;
        };
        if range == 0 {
            return 0;
        }
        self.shared().lists.generate(range)
    }

    /// glDeleteLists.
    pub fn delete_lists(&mut self, list: u32, range: i32) {
        if self.inside_begin_end() {
            return;
        }
        let Ok(range) = u32::try_from(range) else {
            return self.set_error(GL_INVALID_VALUE, "glDeleteLists: range");
        };
        if range > 0 {
            let removed = self.shared().lists.remove(list..=list.saturating_add(range - 1));
            drop(removed);
        }
    }

    /// glIsList.
    pub fn is_list(&mut self, list: u32) -> bool {
        !self.inside_begin_end() && self.shared().lists.contains(list)
    }
}
