//! Values of a lane program before they have registers: single-assignment scalar nodes, shared where they are equal,
//! folded where they are constant, in the order in which they were first wanted.

use std::collections::HashMap;

use super::op::Op;

/// A node's number.
pub(super) type Id = u32;

/// How a scalar's bits are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Kind {
    Float,
    Int,
    Uint,
    Bool,
}

/// How often a value changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Rate {
    Constant,
    /// The same on all lanes of a run.
    Uniform,
    Lane,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Node {
    pub op: Op,
    pub args: [Id; 3],
    /// Const: the bits. Uniform: vec4 << 2 | component. Input: column. Gather: component. Sample: call.
    /// Texel: component. CellRead: a number of its own, so that no two are shared.
    pub imm: u32,
}

/// A texture sample: what it reads; its results are `Texel` nodes.
#[derive(Clone, Debug)]
pub(super) struct SampleNode {
    pub slot: u32,
    pub coord: [Id; 4],
    /// Derivatives, absent where both are the constant 0.
    pub gradients: Option<[[Id; 3]; 2]>,
}

/// What happens, in order.
#[derive(Clone, Copy, Debug)]
pub(super) enum Step {
    Node(Id),
    /// A loop variable takes a value.
    CellWrite(u32, Id),
    LoopBegin,
    /// Back to the matching begin while the condition holds on any lane.
    LoopEnd(Id),
}

#[derive(Default)]
pub(super) struct Graph {
    pub nodes: Vec<Node>,
    pub kinds: Vec<Kind>,
    pub rates: Vec<Rate>,
    pub steps: Vec<Step>,
    pub samples: Vec<SampleNode>,
    pub cells: u32,
    memo: HashMap<Node, Id>,
    unshared: u32,
}

/// A point to return to.
pub(super) struct Mark {
    nodes: usize,
    steps: usize,
    samples: usize,
    cells: u32,
}

impl Graph {
    pub fn mark(&self) -> Mark {
        Mark { nodes: self.nodes.len(), steps: self.steps.len(), samples: self.samples.len(), cells: self.cells }
    }

    /// Forgets everything since `mark`.
    pub fn rewind(&mut self, mark: &Mark) {
        self.nodes.truncate(mark.nodes);
        self.kinds.truncate(mark.nodes);
        self.rates.truncate(mark.nodes);
        self.steps.truncate(mark.steps);
        self.samples.truncate(mark.samples);
        self.cells = mark.cells;
        let nodes = mark.nodes as Id;
        self.memo.retain(|_, id| *id < nodes);
    }

    pub fn constant(&mut self, bits: u32, kind: Kind) -> Id {
        // The kind is part of the identity: 1u and 1i are different nodes with equal bits.
        self.insert(Node { op: Op::Const, args: [kind as u32, 0, 0], imm: bits }, kind, Rate::Constant)
    }
    pub fn float(&mut self, x: f32) -> Id {
        self.constant(x.to_bits(), Kind::Float)
    }
    pub fn boolean(&mut self, x: bool) -> Id {
        self.constant(if x { !0 } else { 0 }, Kind::Bool)
    }
    pub fn base(&mut self) -> Id {
        self.insert(Node { op: Op::Base, args: [0; 3], imm: 0 }, Kind::Uint, Rate::Uniform)
    }
    pub fn uniform(&mut self, vec4: u32, component: u32) -> Id {
        self.insert(Node { op: Op::Uniform, args: [0; 3], imm: vec4 << 2 | component }, Kind::Float, Rate::Uniform)
    }
    /// Component of the vec4 whose number (from the start of all uniforms) is a value.
    pub fn gather(&mut self, index: Id, component: u32) -> Id {
        let rate = self.rates[index as usize].max(Rate::Uniform);
        self.insert(Node { op: Op::Gather, args: [index, 0, 0], imm: component }, Kind::Float, rate)
    }
    pub fn input(&mut self, column: u32) -> Id {
        self.insert(Node { op: Op::Input, args: [0; 3], imm: column }, Kind::Float, Rate::Lane)
    }
    pub fn sample(&mut self, sample: SampleNode) -> [Id; 4] {
        let call = self.samples.len() as u32;
        self.samples.push(sample);
        let node = self.insert(Node { op: Op::Sample, args: [0; 3], imm: call }, Kind::Float, Rate::Lane);
        std::array::from_fn(|c| self.insert(Node { op: Op::Texel, args: [node, 0, 0], imm: c as u32 }, Kind::Float, Rate::Lane))
    }
    pub fn cell(&mut self) -> u32 {
        self.cells += 1;
        self.cells - 1
    }
    pub fn cell_read(&mut self, cell: u32, kind: Kind) -> Id {
        self.unshared += 1;
        self.insert(Node { op: Op::CellRead, args: [cell, 0, 0], imm: self.unshared }, kind, Rate::Lane)
    }

    pub fn constant_bits(&self, id: Id) -> Option<u32> {
        let node = &self.nodes[id as usize];
        (node.op == Op::Const).then_some(node.imm)
    }
    pub fn kind(&self, id: Id) -> Kind {
        self.kinds[id as usize]
    }

    /// An operation on nodes, folded if it can be.
    pub fn op(&mut self, op: Op, args: &[Id], kind: Kind) -> Id {
        debug_assert_eq!(op.arity(), args.len());
        let mut full = [0; 3];
        full[..args.len()].copy_from_slice(args);
        let rate = args.iter().map(|a| self.rates[*a as usize]).max().unwrap_or(Rate::Constant);
        if rate == Rate::Constant {
            let bits = full.map(|a| self.constant_bits(a).unwrap_or(0));
            let mut values = [0; 3];
            values[..args.len()].copy_from_slice(&bits[..args.len()]);
            return self.constant(op.apply(values), kind);
        }
        if let Some(simple) = self.simplify(op, args) {
            return simple;
        }
        self.insert(Node { op, args: full, imm: 0 }, kind, rate)
    }

    /// Identities that hold for every bit pattern (so `x + 0` is not one: -0 + 0 is +0).
    fn simplify(&mut self, op: Op, args: &[Id]) -> Option<Id> {
        let one = 1.0f32.to_bits();
        let bits = |i: usize| self.constant_bits(args[i]);
        match op {
            Op::Mul if bits(0) == Some(one) => Some(args[1]),
            Op::Mul | Op::Div if bits(1) == Some(one) => Some(args[0]),
            Op::Select if bits(0).is_some() => Some(if bits(0) == Some(0) { args[2] } else { args[1] }),
            Op::Select if args[1] == args[2] => Some(args[1]),
            Op::Select if self.kind(args[1]) == Kind::Bool && bits(1) == Some(!0) => Some(self.op(Op::Or, &[args[0], args[2]], Kind::Bool)),
            Op::Select if self.kind(args[1]) == Kind::Bool && bits(2) == Some(0) => Some(self.op(Op::And, &[args[0], args[1]], Kind::Bool)),
            Op::And | Op::Or if args[0] == args[1] => Some(args[0]),
            Op::And if bits(0) == Some(0) || bits(1) == Some(!0) => Some(args[0]),
            Op::And if bits(1) == Some(0) || bits(0) == Some(!0) => Some(args[1]),
            Op::Or if bits(0) == Some(0) || bits(1) == Some(!0) => Some(args[1]),
            Op::Or if bits(1) == Some(0) || bits(0) == Some(!0) => Some(args[0]),
            Op::AddI if bits(0) == Some(0) => Some(args[1]),
            Op::AddI | Op::SubI if bits(1) == Some(0) => Some(args[0]),
            _ => None,
        }
    }

    fn insert(&mut self, node: Node, kind: Kind, rate: Rate) -> Id {
        if let Some(id) = self.memo.get(&node) {
            return *id;
        }
        let id = self.nodes.len() as Id;
        self.nodes.push(node);
        self.kinds.push(kind);
        self.rates.push(rate);
        self.steps.push(Step::Node(id));
        self.memo.insert(node, id);
        id
    }
}
