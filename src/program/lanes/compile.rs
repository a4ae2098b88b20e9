//! naga module → graph: functions are inlined, vectors become scalars, branches become selections. Loops whose count is
//! known are unrolled, others stay loops.

use std::collections::HashMap;

use naga::{AddressSpace, Expression, Handle, Statement, TypeInner, valid::FunctionInfo};

use super::graph::{Graph, Id, Kind, SampleNode, Step};
use super::op::Op;
use crate::program::{Program, Stage};

/// What the compiler cannot take; never the case for validated modules of our own generators.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unsupported(pub String);

pub(super) type Result<T> = std::result::Result<T, Unsupported>;

pub(super) fn unsupported<T>(what: impl Into<String>) -> Result<T> {
    Err(Unsupported(what.into()))
}

/// A compiled graph with its results.
pub(super) struct Compiled {
    pub graph: Graph,
    /// Vertex: position and outputs, 4 columns each. Fragment: colour.
    pub outputs: Vec<Id>,
    pub depth: Option<Id>,
    pub keep: Option<Id>,
}

/// The value of an expression.
#[derive(Clone, Debug)]
pub(super) enum Value {
    /// Its scalars, in order of declaration.
    Data(Vec<Id>),
    /// A place in local variables: first slot, number of scalars, and what is added at run time: (index, stride, count).
    Place { first: usize, len: usize, dynamic: Vec<(Id, usize, usize)> },
    /// The array of uniforms.
    Uniforms,
    /// A vec4 of it, by its number.
    UniformVec4(Id),
    /// A scalar of that.
    UniformScalar(Id, u32),
}

/// A scope that `break` leaves.
struct Scope {
    /// Variable slot: true on lanes that have left it.
    broken: usize,
    /// Variable slot: true on lanes that go on with the next round (loops only).
    continued: Option<usize>,
}

/// A function while it is inlined.
pub(super) struct Frame<'m> {
    pub function: &'m naga::Function,
    pub info: &'m FunctionInfo,
    arguments: Vec<Value>,
    values: HashMap<Handle<Expression>, Value>,
    locals: HashMap<Handle<naga::LocalVariable>, usize>,
    /// First slot of the result.
    result: usize,
    scopes: Vec<Scope>,
}

pub(super) struct Compiler<'m> {
    pub module: &'m naga::Module,
    info: &'m naga::valid::ModuleInfo,
    pub graph: Graph,
    /// Current value of every scalar variable.
    pub vars: Vec<Id>,
    /// Slot: the lane executes here.
    active: usize,
    /// Slot: the fragment was discarded.
    killed: usize,
    globals: HashMap<Handle<naga::GlobalVariable>, usize>,
}

/// Rounds that a loop is unrolled to at most, and nodes that this may make.
const MAX_UNROLL: usize = 64;
const MAX_UNROLL_NODES: usize = 4096;

/// Compiles a program's entry function.
pub(super) fn compile(program: &Program) -> Result<Compiled> {
    let module = &program.module;
    let name = if program.stage == Stage::Vertex { "vertex_main" } else { "fragment_main" };
    let Some((handle, function)) = module.functions.iter().find(|(_, f)| f.name.as_deref() == Some(name)) else {
        return unsupported(format!("no function {name}"));
    };
    let mut compiler =
        Compiler { module, info: &program.info, graph: Graph::default(), vars: Vec::new(), active: 0, killed: 1, globals: HashMap::new() };
    let (yes, no) = (compiler.graph.boolean(true), compiler.graph.boolean(false));
    compiler.vars.extend([yes, no]);
    for (global, variable) in module.global_variables.iter().filter(|(_, v)| v.space == AddressSpace::Private) {
        let value = match variable.init {
            Some(init) => match compiler.global_expression(init)? {
                Value::Data(data) => data,
                _ => return unsupported("a global's initial value"),
            },
            None => compiler.zeros(variable.ty)?,
        };
        compiler.globals.insert(global, compiler.vars.len());
        compiler.vars.extend(value);
    }
    let mut arguments = Vec::new();
    for argument in &function.arguments {
        match &module.types[argument.ty].inner {
            TypeInner::Struct { members, .. } => {
                let mut data = Vec::new();
                for member in members {
                    let number: u32 = match member.name.as_deref().map(|n| n.trim_start_matches(|c: char| c.is_alphabetic()).parse()) {
                        Some(Ok(n)) => n,
                        _ => return unsupported("an input without a number"),
                    };
                    for c in 0..compiler.scalars(member.ty)? as u32 {
                        data.push(compiler.graph.input(number * 4 + c));
                    }
                }
                arguments.push(Value::Data(data));
            }
            _ => arguments.push(Value::Data(vec![compiler.graph.base()])),
        }
    }
    let result = compiler.call(handle, arguments)?;
    let Some(TypeInner::Struct { members, .. }) = function.result.as_ref().map(|r| &module.types[r.ty].inner) else {
        return unsupported("the entry function returns no struct");
    };
    let (mut outputs, mut depth, mut keep) = (Vec::new(), None, None);
    let mut at = 0;
    for member in members {
        let n = compiler.scalars(member.ty)?;
        let part = &result[at..at + n];
        match (member.name.as_deref(), program.stage) {
            (Some("depth"), Stage::Fragment) => depth = Some(part[0]),
            (Some("keep"), Stage::Fragment) => keep = Some(part[0]),
            _ => outputs.extend_from_slice(part),
        }
        at += n;
    }
    let killed = compiler.vars[compiler.killed];
    if compiler.graph.constant_bits(killed) != Some(0) {
        let alive = compiler.graph.op(Op::Not, &[killed], Kind::Bool);
        keep = Some(match keep {
            Some(k) => compiler.graph.op(Op::And, &[k, alive], Kind::Bool),
            None => alive,
        });
    }
    Ok(Compiled { graph: compiler.graph, outputs, depth, keep })
}

impl<'m> Compiler<'m> {
    /// Scalars that a type flattens to.
    pub fn scalars(&self, ty: Handle<naga::Type>) -> Result<usize> {
        self.scalars_of(&self.module.types[ty].inner)
    }

    pub fn scalars_of(&self, inner: &TypeInner) -> Result<usize> {
        Ok(match inner {
            TypeInner::Scalar(_) => 1,
            TypeInner::Vector { size, .. } => *size as usize,
            TypeInner::Matrix { columns, rows, .. } => *columns as usize * *rows as usize,
            TypeInner::Array { base, size: naga::ArraySize::Constant(n), .. } => self.scalars(*base)? * n.get() as usize,
            TypeInner::Struct { members, .. } => {
                let mut n = 0;
                for m in members {
                    n += self.scalars(m.ty)?;
                }
                n
            }
            other => return unsupported(format!("a value of type {other:?}")),
        })
    }

    /// The kinds of those scalars.
    fn kinds(&self, ty: Handle<naga::Type>, out: &mut Vec<Kind>) -> Result<()> {
        let kind = |s: &naga::Scalar| match s.kind {
            naga::ScalarKind::Float | naga::ScalarKind::AbstractFloat => Kind::Float,
            naga::ScalarKind::Sint | naga::ScalarKind::AbstractInt => Kind::Int,
            naga::ScalarKind::Uint => Kind::Uint,
            naga::ScalarKind::Bool => Kind::Bool,
        };
        match &self.module.types[ty].inner {
            TypeInner::Struct { members, .. } => {
                for m in members {
                    self.kinds(m.ty, out)?;
                }
            }
            TypeInner::Array { base, size: naga::ArraySize::Constant(n), .. } => {
                for _ in 0..n.get() {
                    self.kinds(*base, out)?;
                }
            }
            TypeInner::Scalar(s) => out.push(kind(s)),
            TypeInner::Vector { size, scalar } => out.extend(std::iter::repeat_n(kind(scalar), *size as usize)),
            TypeInner::Matrix { columns, rows, scalar } => {
                out.extend(std::iter::repeat_n(kind(scalar), *columns as usize * *rows as usize))
            }
            other => return unsupported(format!("a variable of type {other:?}")),
        }
        Ok(())
    }

    /// Zeros of a type.
    pub fn zeros(&mut self, ty: Handle<naga::Type>) -> Result<Vec<Id>> {
        let mut kinds = Vec::new();
        self.kinds(ty, &mut kinds)?;
        Ok(kinds.into_iter().map(|k| self.graph.constant(0, k)).collect())
    }

    /// Inlines a call and returns its result's scalars.
    fn call(&mut self, handle: Handle<naga::Function>, arguments: Vec<Value>) -> Result<Vec<Id>> {
        let module = self.module;
        let function = &module.functions[handle];
        let result = self.vars.len();
        if let Some(r) = &function.result {
            let zeros = self.zeros(r.ty)?;
            self.vars.extend(zeros);
        }
        let result_end = self.vars.len();
        let mut frame = Frame {
            function,
            info: &self.info[handle],
            arguments,
            values: HashMap::new(),
            locals: HashMap::new(),
            result,
            scopes: Vec::new(),
        };
        for (local, variable) in function.local_variables.iter() {
            let first = self.vars.len();
            let value = match variable.init {
                Some(init) => self.data(&mut frame, init)?,
                None => self.zeros(variable.ty)?,
            };
            self.vars.extend(value);
            frame.locals.insert(local, first);
        }
        let entered = self.vars[self.active];
        self.block(&mut frame, &function.body)?;
        self.vars[self.active] = entered;
        Ok(self.vars[result..result_end].to_vec())
    }

    /// Statements in order. Where some lanes have left (break, continue, return), the rest runs under a mask.
    fn block(&mut self, frame: &mut Frame<'m>, block: &'m naga::Block) -> Result<()> {
        let statements: Vec<&'m Statement> = block.iter().collect();
        self.statements(frame, &statements)
    }

    fn statements(&mut self, frame: &mut Frame<'m>, statements: &[&'m Statement]) -> Result<()> {
        for (i, statement) in statements.iter().enumerate() {
            let before = self.vars[self.active];
            self.statement(frame, statement)?;
            let after = self.vars[self.active];
            if self.graph.constant_bits(after) == Some(0) {
                return Ok(());
            }
            if after != before && i + 1 < statements.len() {
                let old = self.vars.clone();
                self.statements(frame, &statements[i + 1..])?;
                self.merge(after, &old);
                return Ok(());
            }
        }
        Ok(())
    }

    /// Keeps the current values where `condition` holds, the `other` ones elsewhere. Variables made since are kept.
    fn merge(&mut self, condition: Id, other: &[Id]) {
        for (i, &old) in other.iter().enumerate() {
            let new = self.vars[i];
            if new != old {
                let kind = self.graph.kind(new);
                self.vars[i] = self.graph.op(Op::Select, &[condition, new, old], kind);
            }
        }
    }

    fn statement(&mut self, frame: &mut Frame<'m>, statement: &'m Statement) -> Result<()> {
        match statement {
            Statement::Emit(range) => {
                for handle in range.clone() {
                    let value = self.expression(frame, handle)?;
                    frame.values.insert(handle, value);
                }
            }
            Statement::Block(block) => self.block(frame, block)?,
            Statement::If { condition, accept, reject } => {
                let condition = self.data(frame, *condition)?[0];
                match self.graph.constant_bits(condition) {
                    Some(0) => self.block(frame, reject)?,
                    Some(_) => self.block(frame, accept)?,
                    None => {
                        let before = self.vars.clone();
                        self.block(frame, reject)?;
                        let rejected = std::mem::replace(&mut self.vars, before);
                        let len = rejected.len();
                        let known = self.vars.len();
                        self.vars.extend_from_slice(&rejected[known..]);
                        self.block(frame, accept)?;
                        self.merge(condition, &rejected[..len]);
                    }
                }
            }
            Statement::Switch { selector, cases } => self.switch(frame, *selector, cases)?,
            Statement::Loop { body, continuing, break_if } => self.repeat(frame, body, continuing, *break_if)?,
            Statement::Break => {
                let Some(scope) = frame.scopes.last() else { return unsupported("break outside of a loop") };
                let (yes, no) = (self.graph.boolean(true), self.graph.boolean(false));
                self.vars[scope.broken] = yes;
                self.vars[self.active] = no;
            }
            Statement::Continue => {
                let Some(slot) = frame.scopes.iter().rev().find_map(|s| s.continued) else {
                    return unsupported("continue outside of a loop");
                };
                let (yes, no) = (self.graph.boolean(true), self.graph.boolean(false));
                self.vars[slot] = yes;
                self.vars[self.active] = no;
            }
            Statement::Return { value } => {
                if let Some(value) = value {
                    let data = self.data(frame, *value)?;
                    self.vars[frame.result..frame.result + data.len()].copy_from_slice(&data);
                }
                self.vars[self.active] = self.graph.boolean(false);
            }
            Statement::Kill => self.vars[self.killed] = self.graph.boolean(true),
            Statement::Store { pointer, value } => {
                let value = self.data(frame, *value)?;
                let place = self.value(frame, *pointer)?;
                self.store(place, &value)?;
            }
            Statement::Call { function, arguments, result } => {
                let arguments = arguments.iter().map(|a| self.value(frame, *a)).collect::<Result<Vec<_>>>()?;
                let data = if self.module.functions[*function].name.as_deref() == Some("texture_sample") {
                    self.texture_sample(&arguments)?
                } else {
                    self.call(*function, arguments)?
                };
                if let Some(result) = result {
                    frame.values.insert(*result, Value::Data(data));
                }
            }
            other => return unsupported(format!("statement {other:?}")),
        }
        Ok(())
    }

    fn texture_sample(&mut self, arguments: &[Value]) -> Result<Vec<Id>> {
        let [Value::Data(slot), Value::Data(coord), Value::Data(ddx), Value::Data(ddy)] = arguments else {
            return unsupported("arguments of texture_sample");
        };
        let Some(slot) = self.graph.constant_bits(slot[0]) else { return unsupported("a texture slot that is not constant") };
        let zero = |id: &Id| self.graph.constant_bits(*id) == Some(0);
        let gradients = if ddx.iter().chain(ddy).all(zero) { None } else { Some([[ddx[0], ddx[1], ddx[2]], [ddy[0], ddy[1], ddy[2]]]) };
        let sample = SampleNode { slot, coord: [coord[0], coord[1], coord[2], coord[3]], gradients };
        Ok(self.graph.sample(sample).to_vec())
    }

    fn switch(&mut self, frame: &mut Frame<'m>, selector: Handle<Expression>, cases: &'m [naga::SwitchCase]) -> Result<()> {
        let selector = self.data(frame, selector)?[0];
        let kind = self.graph.kind(selector);
        let no = self.graph.boolean(false);
        let broken = self.vars.len();
        self.vars.push(no);
        frame.scopes.push(Scope { broken, continued: None });
        // Bodies in order, each with the condition that it runs; a fall-through case must be empty and joins the next.
        let mut bodies = Vec::new();
        let (mut pending, mut pending_default, mut any) = (no, false, no);
        for case in cases {
            match case.value {
                naga::SwitchValue::Default => pending_default = true,
                naga::SwitchValue::I32(v) => {
                    let v = self.graph.constant(v as u32, kind);
                    let hit = self.graph.op(Op::EqualI, &[selector, v], Kind::Bool);
                    pending = self.graph.op(Op::Or, &[pending, hit], Kind::Bool);
                    any = self.graph.op(Op::Or, &[any, hit], Kind::Bool);
                }
                naga::SwitchValue::U32(v) => {
                    let v = self.graph.constant(v, kind);
                    let hit = self.graph.op(Op::EqualI, &[selector, v], Kind::Bool);
                    pending = self.graph.op(Op::Or, &[pending, hit], Kind::Bool);
                    any = self.graph.op(Op::Or, &[any, hit], Kind::Bool);
                }
            }
            if case.fall_through {
                if case.body.iter().any(|s| !matches!(s, Statement::Block(b) if b.is_empty())) {
                    return unsupported("a case that falls through after statements");
                }
                continue;
            }
            bodies.push((pending, pending_default, &case.body));
            (pending, pending_default) = (no, false);
        }
        let none = self.graph.op(Op::Not, &[any], Kind::Bool);
        let start = self.vars.clone();
        let mut merged = start.clone();
        for (mut condition, default, body) in bodies {
            if default {
                condition = self.graph.op(Op::Or, &[condition, none], Kind::Bool);
            }
            if self.graph.constant_bits(condition) == Some(0) {
                continue;
            }
            let made = merged[start.len()..].to_vec();
            self.vars = start.clone();
            self.vars.extend(made);
            self.block(frame, body)?;
            merged.extend_from_slice(&self.vars[merged.len()..]);
            self.merge(condition, &merged.clone());
            merged = std::mem::take(&mut self.vars);
        }
        self.vars = merged;
        frame.scopes.pop();
        self.vars[self.active] = self.graph.op(Op::Or, &[self.vars[self.active], self.vars[broken]], Kind::Bool);
        Ok(())
    }

    /// One round of a loop.
    fn round(
        &mut self,
        frame: &mut Frame<'m>,
        body: &'m naga::Block,
        continuing: &'m naga::Block,
        break_if: Option<Handle<Expression>>,
    ) -> Result<()> {
        let scope = frame.scopes.last().expect("the loop's scope is on the stack");
        let (broken, continued) = (scope.broken, scope.continued.expect("a loop has one"));
        self.vars[continued] = self.graph.boolean(false);
        self.block(frame, body)?;
        let active = self.graph.op(Op::Or, &[self.vars[self.active], self.vars[continued]], Kind::Bool);
        self.vars[self.active] = active;
        if self.graph.constant_bits(active) == Some(0) {
            return Ok(());
        }
        let old = self.vars.clone();
        self.block(frame, continuing)?;
        if let Some(condition) = break_if {
            let leave = self.data(frame, condition)?[0];
            let stay = self.graph.op(Op::Not, &[leave], Kind::Bool);
            self.vars[broken] = self.graph.op(Op::Or, &[self.vars[broken], leave], Kind::Bool);
            self.vars[self.active] = self.graph.op(Op::And, &[self.vars[self.active], stay], Kind::Bool);
        }
        if self.graph.constant_bits(active).is_none() {
            self.merge(active, &old);
        }
        Ok(())
    }

    fn repeat(
        &mut self,
        frame: &mut Frame<'m>,
        body: &'m naga::Block,
        continuing: &'m naga::Block,
        break_if: Option<Handle<Expression>>,
    ) -> Result<()> {
        let no = self.graph.boolean(false);
        let (broken, continued) = (self.vars.len(), self.vars.len() + 1);
        self.vars.extend([no, no]);
        frame.scopes.push(Scope { broken, continued: Some(continued) });
        if !self.unroll(frame, body, continuing, break_if)? {
            self.real_loop(frame, body, continuing, break_if)?;
        }
        frame.scopes.pop();
        self.vars[self.active] = self.graph.op(Op::Or, &[self.vars[self.active], self.vars[broken]], Kind::Bool);
        Ok(())
    }

    /// Tries to run the loop at compile time: works while it is known after each round that all lanes agree.
    fn unroll(
        &mut self,
        frame: &mut Frame<'m>,
        body: &'m naga::Block,
        continuing: &'m naga::Block,
        break_if: Option<Handle<Expression>>,
    ) -> Result<bool> {
        let mark = self.graph.mark();
        let vars = self.vars.clone();
        let nodes = self.graph.nodes.len();
        for _ in 0..MAX_UNROLL {
            let before = self.vars[self.active];
            self.round(frame, body, continuing, break_if)?;
            let active = self.vars[self.active];
            if self.graph.constant_bits(active) == Some(0) {
                return Ok(true);
            }
            // Lanes went different ways, or too much code came of it.
            if active != before || self.graph.nodes.len() > nodes + MAX_UNROLL_NODES {
                break;
            }
        }
        self.graph.rewind(&mark);
        self.vars = vars;
        Ok(false)
    }

    fn real_loop(
        &mut self,
        frame: &mut Frame<'m>,
        body: &'m naga::Block,
        continuing: &'m naga::Block,
        break_if: Option<Handle<Expression>>,
    ) -> Result<()> {
        let count = self.vars.len();
        let start = self.vars.clone();
        let mut carried: Vec<usize> = Vec::new();
        loop {
            // Which variables the loop changes is found by trying; a variable that changes may make others change.
            let mark = self.graph.mark();
            let cells: Vec<u32> = carried.iter().map(|_| self.graph.cell()).collect();
            for (slot, cell) in carried.iter().zip(&cells) {
                self.graph.steps.push(Step::CellWrite(*cell, start[*slot]));
            }
            self.graph.steps.push(Step::LoopBegin);
            for (slot, cell) in carried.iter().zip(&cells) {
                let kind = self.graph.kind(start[*slot]);
                self.vars[*slot] = self.graph.cell_read(*cell, kind);
            }
            let entry = self.vars[..count].to_vec();
            let active = self.vars[self.active];
            self.round(frame, body, continuing, break_if)?;
            self.merge(active, &entry);
            let changed: Vec<usize> = (0..count).filter(|i| self.vars[*i] != entry[*i] && !carried.contains(i)).collect();
            if changed.is_empty() {
                for (slot, cell) in carried.iter().zip(&cells) {
                    self.graph.steps.push(Step::CellWrite(*cell, self.vars[*slot]));
                }
                self.graph.steps.push(Step::LoopEnd(self.vars[self.active]));
                for (slot, cell) in carried.iter().zip(&cells) {
                    let kind = self.graph.kind(start[*slot]);
                    self.vars[*slot] = self.graph.cell_read(*cell, kind);
                }
                self.vars.truncate(count);
                return Ok(());
            }
            self.graph.rewind(&mark);
            self.vars.truncate(count);
            self.vars.copy_from_slice(&start);
            carried.extend(changed);
        }
    }

    fn store(&mut self, place: Value, value: &[Id]) -> Result<()> {
        let Value::Place { first, len, dynamic } = place else { return unsupported("a store to something that is no variable") };
        for (offset, condition) in self.candidates(&dynamic) {
            for k in 0..len.min(value.len()) {
                let slot = first + offset + k;
                let kind = self.graph.kind(value[k]);
                self.vars[slot] = match condition {
                    Some(c) => self.graph.op(Op::Select, &[c, value[k], self.vars[slot]], kind),
                    None => value[k],
                };
            }
        }
        Ok(())
    }

    /// All places that dynamic indices can mean, with the condition of each.
    fn candidates(&mut self, dynamic: &[(Id, usize, usize)]) -> Vec<(usize, Option<Id>)> {
        let mut all = vec![(0, None)];
        for &(index, stride, count) in dynamic {
            let kind = self.graph.kind(index);
            let mut next = Vec::new();
            for (offset, condition) in all {
                for k in 0..count {
                    let k_id = self.graph.constant(k as u32, kind);
                    let hit = self.graph.op(Op::EqualI, &[index, k_id], Kind::Bool);
                    let both = match condition {
                        Some(c) => self.graph.op(Op::And, &[c, hit], Kind::Bool),
                        None => hit,
                    };
                    next.push((offset + k * stride, Some(both)));
                }
            }
            all = next;
        }
        all
    }

    pub fn load(&mut self, place: Value) -> Result<Vec<Id>> {
        match place {
            Value::Place { first, len, dynamic } => {
                let mut result: Vec<Id> = self.vars[first..first + len].to_vec();
                if dynamic.is_empty() {
                    return Ok(result);
                }
                for (offset, condition) in self.candidates(&dynamic) {
                    let Some(c) = condition else { continue };
                    for (k, r) in result.iter_mut().enumerate() {
                        let value = self.vars[first + offset + k];
                        let kind = self.graph.kind(value);
                        *r = self.graph.op(Op::Select, &[c, value, *r], kind);
                    }
                }
                Ok(result)
            }
            Value::UniformVec4(index) => Ok((0..4).map(|c| self.uniform(index, c)).collect()),
            Value::UniformScalar(index, c) => Ok(vec![self.uniform(index, c)]),
            _ => unsupported("a load from something that is no variable"),
        }
    }

    /// A uniform scalar: `base + constant` is known when the run starts, anything else is gathered.
    fn uniform(&mut self, index: Id, component: u32) -> Id {
        let node = self.graph.nodes[index as usize];
        if node.op == Op::Base {
            return self.graph.uniform(0, component);
        }
        if node.op == Op::AddI {
            for (x, y) in [(node.args[0], node.args[1]), (node.args[1], node.args[0])] {
                if self.graph.nodes[x as usize].op == Op::Base
                    && let Some(k) = self.graph.constant_bits(y)
                {
                    return self.graph.uniform(k, component);
                }
            }
        }
        self.graph.gather(index, component)
    }

    /// The scalars of an expression.
    pub fn data(&mut self, frame: &mut Frame<'m>, handle: Handle<Expression>) -> Result<Vec<Id>> {
        match self.value(frame, handle)? {
            Value::Data(data) => Ok(data),
            _ => unsupported("a pointer where a value is wanted"),
        }
    }

    /// The value of an expression: what it was when it was emitted, or of one that needs no emitting.
    pub fn value(&mut self, frame: &mut Frame<'m>, handle: Handle<Expression>) -> Result<Value> {
        if let Some(value) = frame.values.get(&handle) {
            return Ok(value.clone());
        }
        self.expression(frame, handle)
    }

    /// Pointers and arguments; the rest is [`Compiler::compute`](super::expression).
    fn expression(&mut self, frame: &mut Frame<'m>, handle: Handle<Expression>) -> Result<Value> {
        let function = frame.function;
        match &function.expressions[handle] {
            Expression::FunctionArgument(i) => match frame.arguments.get(*i as usize) {
                Some(value) => Ok(value.clone()),
                None => unsupported("a missing argument"),
            },
            Expression::LocalVariable(local) => {
                let variable = &frame.function.local_variables[*local];
                let len = self.scalars(variable.ty)?;
                Ok(Value::Place { first: frame.locals[local], len, dynamic: Vec::new() })
            }
            Expression::GlobalVariable(global) => {
                let variable = &self.module.global_variables[*global];
                match variable.space {
                    AddressSpace::Private => {
                        let len = self.scalars(variable.ty)?;
                        let first = self.globals[global];
                        Ok(Value::Place { first, len, dynamic: Vec::new() })
                    }
                    _ => Ok(Value::Uniforms),
                }
            }
            Expression::Constant(constant) => self.global_expression(self.module.constants[*constant].init),
            other => {
                let ty = frame.info[handle].ty.inner_with(&self.module.types);
                self.compute(frame, other, ty)
            }
        }
    }

    fn global_expression(&mut self, handle: Handle<Expression>) -> Result<Value> {
        match &self.module.global_expressions[handle] {
            Expression::Constant(constant) => self.global_expression(self.module.constants[*constant].init),
            Expression::Literal(literal) => Ok(Value::Data(vec![self.literal(literal)?])),
            Expression::ZeroValue(ty) => Ok(Value::Data(self.zeros(*ty)?)),
            Expression::Compose { components, .. } => {
                let mut data = Vec::new();
                for c in components {
                    if let Value::Data(d) = self.global_expression(*c)? {
                        data.extend(d);
                    }
                }
                Ok(Value::Data(data))
            }
            Expression::Splat { size, value } => match self.global_expression(*value)? {
                Value::Data(d) => Ok(Value::Data(vec![d[0]; *size as usize])),
                _ => unsupported("a splat of a pointer"),
            },
            other => unsupported(format!("global expression {other:?}")),
        }
    }
}
