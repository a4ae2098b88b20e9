//! Graph → instructions: dead nodes are dropped, what is equal on all lanes moves to a prologue that runs on one group,
//! the rest gets registers that are reused as soon as their value is dead.

use super::GROUPS;
use super::compile::Compiled;
use super::graph::{Id, Rate, Step};
use super::op::{Inst, Op, Operand, Space};

/// A texture sample, ready to run.
#[derive(Clone, Debug)]
pub(super) struct SampleCall {
    pub slot: u32,
    pub coord: [Operand; 4],
    pub gradients: Option<[[Operand; 3]; 2]>,
    pub to: [Operand; 4],
}

/// A program for the [`Machine`](super::Machine).
#[derive(Clone, Debug, Default)]
pub struct LaneProgram {
    /// Bits and the register (group) that they are spread over.
    pub(super) constants: Vec<(u32, u32)>,
    /// Word of the uniform block and its register.
    pub(super) uniforms: Vec<(u32, u32)>,
    /// Register of the block's first vec4, if the program wants it.
    pub(super) base: Option<u32>,
    /// Runs on one group.
    pub(super) prologue: Vec<Inst>,
    /// Runs on all active groups.
    pub(super) body: Vec<Inst>,
    pub(super) samples: Vec<SampleCall>,
    /// Groups of registers.
    pub(super) registers: u32,
}

impl LaneProgram {
    /// Instructions that run for every group.
    pub fn instructions(&self) -> usize {
        self.body.len()
    }
}

struct Scheduler<'a> {
    compiled: &'a Compiled,
    program: LaneProgram,
    place: Vec<Option<Operand>>,
    /// Step at which a node is used last (`usize::MAX`: never freed).
    last_use: Vec<Option<usize>>,
    /// The nodes that are used last at each step.
    dying: Vec<Vec<Id>>,
    free: Vec<u32>,
    next: u32,
    scratch: Option<Operand>,
}

/// Allocates registers and writes the instructions.
pub(super) fn schedule(compiled: &Compiled) -> LaneProgram {
    let graph = &compiled.graph;
    let live = live_nodes(compiled);
    let last_use = last_uses(compiled, &live);
    let mut dying = vec![Vec::new(); graph.steps.len()];
    for (id, last) in last_use.iter().enumerate() {
        if let Some(list) = last.and_then(|at| dying.get_mut(at)) {
            list.push(id as Id);
        }
    }
    let mut s = Scheduler {
        compiled,
        program: LaneProgram::default(),
        place: vec![None; graph.nodes.len()],
        last_use,
        dying,
        free: Vec::new(),
        next: 0,
        scratch: None,
    };
    // What is equal on all lanes takes one group each and stays.
    for step in &graph.steps {
        if let Step::Node(id) = step
            && live[*id as usize]
            && graph.rates[*id as usize] != Rate::Lane
        {
            s.prologue(*id);
        }
    }
    let cells: Vec<Operand> = (0..graph.cells).map(|_| s.column()).collect();
    s.place_outputs(&live);
    let mut loops = Vec::new();
    for (at, step) in graph.steps.iter().enumerate() {
        match *step {
            Step::Node(id) if live[id as usize] && graph.rates[id as usize] == Rate::Lane => s.node(id, at, &cells),
            Step::Node(_) => {}
            Step::CellWrite(cell, value) => {
                let from = s.operand(value);
                s.emit(Op::Copy, cells[cell as usize], [from; 3], 0);
            }
            Step::LoopBegin => loops.push(s.program.body.len() as u32),
            Step::LoopEnd(condition) => {
                let from = s.operand(condition);
                let start = loops.pop().unwrap_or(0);
                s.emit(Op::LoopEnd, from, [from; 3], start);
            }
        }
        s.release(at);
    }
    s.finish();
    s.program.registers = s.next;
    s.program
}

/// Joins a sum with a product that only it uses: half the instructions of a matrix times a vector.
pub(super) fn combine(compiled: &mut Compiled) {
    let live = live_nodes(compiled);
    let mut uses = vec![0u32; live.len()];
    for id in (0..live.len()).filter(|id| live[*id]) {
        each_source(compiled, id as Id, |source| uses[source as usize] += 1);
    }
    let roots: Vec<Id> = compiled.outputs.iter().chain(&compiled.depth).chain(&compiled.keep).copied().collect();
    roots.into_iter().for_each(|id| uses[id as usize] += 1);
    for step in &compiled.graph.steps {
        match step {
            Step::CellWrite(_, id) | Step::LoopEnd(id) => uses[*id as usize] += 1,
            _ => {}
        }
    }
    let graph = &mut compiled.graph;
    for id in (0..live.len()).filter(|id| live[*id] && graph.rates[*id] == Rate::Lane) {
        let node = graph.nodes[id];
        if node.op != Op::Add {
            continue;
        }
        // A sum is the same either way round.
        for (product, other) in [(node.args[1], node.args[0]), (node.args[0], node.args[1])] {
            let p = graph.nodes[product as usize];
            if p.op == Op::Mul && uses[product as usize] == 1 && graph.rates[product as usize] == Rate::Lane {
                graph.nodes[id].op = Op::MulAdd;
                graph.nodes[id].args = [p.args[0], p.args[1], other];
                break;
            }
        }
    }
}

/// Nodes that results, loops or live samples need.
fn live_nodes(compiled: &Compiled) -> Vec<bool> {
    let graph = &compiled.graph;
    let mut live = vec![false; graph.nodes.len()];
    let mut stack: Vec<Id> = compiled.outputs.clone();
    stack.extend(compiled.depth);
    stack.extend(compiled.keep);
    for step in &graph.steps {
        match step {
            Step::CellWrite(_, id) | Step::LoopEnd(id) => stack.push(*id),
            _ => {}
        }
    }
    while let Some(id) = stack.pop() {
        if !std::mem::replace(&mut live[id as usize], true) {
            each_source(compiled, id, |source| stack.push(source));
        }
    }
    live
}

fn each_source(compiled: &Compiled, id: Id, mut f: impl FnMut(Id)) {
    let graph = &compiled.graph;
    let node = &graph.nodes[id as usize];
    match node.op {
        Op::Sample => {
            let sample = &graph.samples[node.imm as usize];
            sample.coord.iter().for_each(|x| f(*x));
            sample.gradients.iter().flatten().flatten().for_each(|x| f(*x));
        }
        Op::Texel | Op::Gather => f(node.args[0]),
        op => node.args[..op.arity()].iter().for_each(|x| f(*x)),
    }
}

/// The step after which each node's register is free. A value from outside of a loop lives until the loop's end.
fn last_uses(compiled: &Compiled, live: &[bool]) -> Vec<Option<usize>> {
    let graph = &compiled.graph;
    // For each step, the outermost loop that it is in: (begin, end).
    let mut enclosing: Vec<Vec<(usize, usize)>> = vec![Vec::new(); graph.steps.len()];
    let mut open = Vec::new();
    for (at, step) in graph.steps.iter().enumerate() {
        match step {
            Step::LoopBegin => open.push(at),
            Step::LoopEnd(_) => {
                if let Some(begin) = open.pop() {
                    enclosing[begin..=at].iter_mut().for_each(|e| e.push((begin, at)));
                }
            }
            _ => {}
        }
    }
    let mut defined = vec![0; graph.nodes.len()];
    for (at, step) in graph.steps.iter().enumerate() {
        if let Step::Node(id) = step {
            defined[*id as usize] = at;
        }
    }
    let mut last = vec![None; graph.nodes.len()];
    let mut using = |id: Id, at: usize| {
        let mut until = at;
        for &(begin, end) in &enclosing[at] {
            if defined[id as usize] < begin {
                until = until.max(end);
            }
        }
        let slot: &mut Option<usize> = &mut last[id as usize];
        *slot = Some(slot.map_or(until, |u| u.max(until)));
    };
    for (at, step) in graph.steps.iter().enumerate() {
        match *step {
            Step::Node(id) if live[id as usize] => each_source(compiled, id, |source| using(source, at)),
            Step::CellWrite(_, id) | Step::LoopEnd(id) => using(id, at),
            _ => {}
        }
    }
    for id in compiled.outputs.iter().chain(&compiled.depth).chain(&compiled.keep) {
        last[*id as usize] = Some(usize::MAX);
    }
    last
}

impl Scheduler<'_> {
    /// A register of one group.
    fn single(&mut self) -> u32 {
        self.next += 1;
        self.next - 1
    }

    /// A register of all groups.
    fn column(&mut self) -> Operand {
        let group = self.free.pop().unwrap_or_else(|| {
            self.next += GROUPS as u32;
            self.next - GROUPS as u32
        });
        Operand::new(Space::Registers, group, 1)
    }

    fn operand(&self, id: Id) -> Operand {
        self.place[id as usize].unwrap_or_default()
    }

    fn emit(&mut self, op: Op, to: Operand, [a, b, c]: [Operand; 3], imm: u32) {
        self.program.body.push(Inst { op, to, a, b, c, imm });
    }

    fn prologue(&mut self, id: Id) {
        let node = self.compiled.graph.nodes[id as usize];
        let register = self.single();
        let to = Operand::new(Space::Registers, register, 0);
        self.place[id as usize] = Some(to);
        match node.op {
            Op::Const => self.program.constants.push((node.imm, register)),
            Op::Uniform => self.program.uniforms.push((node.imm, register)),
            Op::Base => self.program.base = Some(register),
            op => {
                let args = node.args.map(|x| self.place.get(x as usize).copied().flatten().unwrap_or_default());
                self.program.prologue.push(Inst { op, to, a: args[0], b: args[1], c: args[2], imm: node.imm });
            }
        }
    }

    /// A result that is computed per lane and wanted once is computed in place.
    fn place_outputs(&mut self, live: &[bool]) {
        let graph = &self.compiled.graph;
        for (column, id) in self.compiled.outputs.iter().enumerate() {
            let node = &graph.nodes[*id as usize];
            let computed = graph.rates[*id as usize] == Rate::Lane && !matches!(node.op, Op::Input);
            if computed && live[*id as usize] && self.place[*id as usize].is_none() {
                self.place[*id as usize] = Some(Operand::new(Space::Outputs, (column * GROUPS) as u32, 1));
            }
        }
    }

    fn node(&mut self, id: Id, at: usize, cells: &[Operand]) {
        let graph = &self.compiled.graph;
        let node = graph.nodes[id as usize];
        if node.op == Op::Input {
            self.place[id as usize] = Some(Operand::new(Space::Inputs, node.imm * GROUPS as u32, 1));
            return;
        }
        if node.op == Op::Sample {
            self.sample(id, node.imm);
            return;
        }
        if node.op == Op::Texel {
            // Its register was given by the sample.
            return;
        }
        let args = node.args;
        let sources: [Operand; 3] = match node.op {
            Op::CellRead => [cells[args[0] as usize]; 3],
            Op::Gather => [self.operand(args[0]); 3],
            op => {
                let mut sources = [Operand::default(); 3];
                for (i, arg) in args[..op.arity()].iter().enumerate() {
                    sources[i] = self.operand(*arg);
                }
                sources
            }
        };
        // A source that dies here may give its register to the result: groups are read before they are written.
        self.release(at);
        let to = match self.place[id as usize] {
            Some(place) => place,
            None => self.column(),
        };
        self.place[id as usize] = Some(to);
        let op = if node.op == Op::CellRead { Op::Copy } else { node.op };
        self.emit(op, to, sources, node.imm);
    }

    fn sample(&mut self, id: Id, call: u32) {
        let sample = &self.compiled.graph.samples[call as usize];
        let coord = sample.coord.map(|x| self.operand(x));
        let gradients = sample.gradients.map(|g| g.map(|v| v.map(|x| self.operand(x))));
        let nodes = &self.compiled.graph.nodes;
        let mut to = [None; 4];
        for (t, node) in nodes.iter().enumerate() {
            if node.op == Op::Texel && node.args[0] == id && self.last_use[t].is_some() {
                let place = match self.place[t] {
                    Some(place) => place,
                    None => self.column(),
                };
                self.place[t] = Some(place);
                to[node.imm as usize] = Some(place);
            }
        }
        let to = to.map(|place| match place {
            Some(place) => place,
            None => match self.scratch {
                Some(scratch) => scratch,
                None => {
                    let scratch = self.column();
                    *self.scratch.insert(scratch)
                }
            },
        });
        let imm = self.program.samples.len() as u32;
        self.program.samples.push(SampleCall { slot: sample.slot, coord, gradients, to });
        self.emit(Op::Sample, to[0], [to[0]; 3], imm);
    }

    /// Frees the registers of values that are used last at this step.
    fn release(&mut self, at: usize) {
        for id in std::mem::take(&mut self.dying[at]) {
            if let Some(place) = self.place[id as usize]
                && place.space() == Space::Registers as usize
                && place.step() == 1
            {
                self.free.push(place.group() as u32);
            }
        }
    }

    /// Copies the results that lie elsewhere.
    fn finish(&mut self) {
        for (column, id) in self.compiled.outputs.iter().enumerate() {
            let to = Operand::new(Space::Outputs, (column * GROUPS) as u32, 1);
            let from = self.operand(*id);
            if from != to {
                self.emit(Op::Copy, to, [from; 3], 0);
            }
        }
        if let Some(id) = self.compiled.depth {
            let from = self.operand(id);
            self.emit(Op::Copy, Operand::new(Space::Depth, 0, 1), [from; 3], 0);
        }
        if let Some(id) = self.compiled.keep {
            let from = self.operand(id);
            self.emit(Op::Keep, from, [from; 3], 0);
        }
    }
}
