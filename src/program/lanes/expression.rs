//! Expressions of a naga function as nodes, scalar by scalar. Composite functions have one written order of
//! operations: `dot` is ((x + y) + z) + w of the products, `normalize` multiplies by 1 / sqrt, `mix` is a (1 - t) + b t.

use naga::{BinaryOperator as B, Expression, Handle, Literal, MathFunction as M, RelationalFunction, ScalarKind, TypeInner, UnaryOperator};

use super::compile::{Compiler, Frame, Result, Value, unsupported};
use super::graph::{Id, Kind};
use super::op::Op;

impl<'m> Compiler<'m> {
    pub(super) fn literal(&mut self, literal: &Literal) -> Result<Id> {
        Ok(match *literal {
            Literal::F32(x) => self.graph.float(x),
            Literal::AbstractFloat(x) => self.graph.float(x as f32),
            Literal::I32(x) => self.graph.constant(x as u32, Kind::Int),
            Literal::AbstractInt(x) => self.graph.constant(x as u32, Kind::Int),
            Literal::U32(x) => self.graph.constant(x, Kind::Uint),
            Literal::Bool(x) => self.graph.boolean(x),
            ref other => return unsupported(format!("literal {other:?}")),
        })
    }

    /// Everything that is not a pointer or an argument. `ty` is the type of the result.
    pub(super) fn compute(&mut self, frame: &mut Frame<'m>, expression: &'m Expression, ty: &'m TypeInner) -> Result<Value> {
        Ok(Value::Data(match expression {
            Expression::Literal(literal) => vec![self.literal(literal)?],
            Expression::ZeroValue(ty) => self.zeros(*ty)?,
            Expression::Compose { components, .. } => {
                let mut data = Vec::new();
                for c in components {
                    data.extend(self.data(frame, *c)?);
                }
                data
            }
            Expression::Splat { size, value } => vec![self.data(frame, *value)?[0]; *size as usize],
            Expression::Swizzle { size, vector, pattern } => {
                let v = self.data(frame, *vector)?;
                pattern[..*size as usize].iter().map(|c| v[*c as usize]).collect()
            }
            Expression::AccessIndex { base, index } => return self.access(frame, *base, None, *index as usize),
            Expression::Access { base, index } => {
                let index = self.data(frame, *index)?[0];
                return match self.graph.constant_bits(index) {
                    Some(k) => self.access(frame, *base, None, k as usize),
                    None => self.access(frame, *base, Some(index), 0),
                };
            }
            Expression::Load { pointer } => {
                let place = self.value(frame, *pointer)?;
                self.load(place)?
            }
            Expression::Unary { op, expr } => {
                let v = self.data(frame, *expr)?;
                v.into_iter()
                    .map(|x| {
                        let kind = self.graph.kind(x);
                        let op = match op {
                            UnaryOperator::Negate if kind == Kind::Float => Op::Neg,
                            UnaryOperator::Negate => Op::NegI,
                            UnaryOperator::LogicalNot | UnaryOperator::BitwiseNot => Op::Not,
                        };
                        self.graph.op(op, &[x], kind)
                    })
                    .collect()
            }
            Expression::Binary { op, left, right } => {
                let (left_ty, right_ty) = (self.type_of(frame, *left), self.type_of(frame, *right));
                let (l, r) = (self.data(frame, *left)?, self.data(frame, *right)?);
                self.binary(*op, (&l, left_ty), (&r, right_ty))?
            }
            Expression::Select { condition, accept, reject } => {
                let (c, a, r) = (self.data(frame, *condition)?, self.data(frame, *accept)?, self.data(frame, *reject)?);
                (0..a.len())
                    .map(|i| {
                        let kind = self.graph.kind(a[i]);
                        self.graph.op(Op::Select, &[c[if c.len() == 1 { 0 } else { i }], a[i], r[i]], kind)
                    })
                    .collect()
            }
            Expression::Relational { fun, argument } => {
                let v = self.data(frame, *argument)?;
                match fun {
                    RelationalFunction::All => vec![self.fold_bools(Op::And, &v)],
                    RelationalFunction::Any => vec![self.fold_bools(Op::Or, &v)],
                    RelationalFunction::IsNan => v.into_iter().map(|x| self.graph.op(Op::NotEqual, &[x, x], Kind::Bool)).collect(),
                    RelationalFunction::IsInf => {
                        let infinity = self.graph.float(f32::INFINITY);
                        v.into_iter()
                            .map(|x| {
                                let a = self.un(Op::Abs, x);
                                self.graph.op(Op::Equal, &[a, infinity], Kind::Bool)
                            })
                            .collect()
                    }
                }
            }
            Expression::As { expr, kind, convert } => {
                let v = self.data(frame, *expr)?;
                v.into_iter().map(|x| self.convert(x, *kind, convert.is_some())).collect()
            }
            Expression::Math { fun, arg, arg1, arg2, .. } => {
                let a = self.data(frame, *arg)?;
                let b = arg1.map(|h| self.data(frame, h)).transpose()?.unwrap_or_default();
                let c = arg2.map(|h| self.data(frame, h)).transpose()?.unwrap_or_default();
                let arg_ty = self.type_of(frame, *arg);
                self.math(*fun, &a, &b, &c, arg_ty, ty)?
            }
            other => return unsupported(format!("expression {other:?}")),
        }))
    }

    fn type_of(&self, frame: &Frame<'m>, handle: Handle<Expression>) -> &'m TypeInner {
        frame.info[handle].ty.inner_with(&self.module.types)
    }

    /// Element `index` (plus the dynamic one) of a value or a place.
    fn access(&mut self, frame: &mut Frame<'m>, base: Handle<Expression>, dynamic: Option<Id>, index: usize) -> Result<Value> {
        let value = self.value(frame, base)?;
        let inner = match self.type_of(frame, base) {
            TypeInner::Pointer { base, .. } => &self.module.types[*base].inner,
            TypeInner::ValuePointer { size: Some(_), .. } => return self.access_flat(value, 0, 1, 4, dynamic, index),
            other => other,
        };
        let (offset, stride, count) = match inner {
            TypeInner::Vector { size, .. } => (index, 1, *size as usize),
            TypeInner::Matrix { columns, rows, .. } => (index * *rows as usize, *rows as usize, *columns as usize),
            TypeInner::Array { base, size, .. } => {
                let stride = self.scalars(*base)?;
                let count = if let naga::ArraySize::Constant(n) = size { n.get() as usize } else { 0 };
                (index * stride, stride, count)
            }
            TypeInner::Struct { members, .. } => {
                let mut offset = 0;
                for m in &members[..index] {
                    offset += self.scalars(m.ty)?;
                }
                (offset, self.scalars(members[index].ty)?, 1)
            }
            other => return unsupported(format!("an element of {other:?}")),
        };
        self.access_flat(value, offset, stride, count, dynamic, index)
    }

    fn access_flat(
        &mut self,
        value: Value,
        offset: usize,
        stride: usize,
        count: usize,
        dynamic: Option<Id>,
        index: usize,
    ) -> Result<Value> {
        Ok(match value {
            Value::Data(data) => match dynamic {
                None => match data.get(offset..offset + stride) {
                    Some(part) => Value::Data(part.to_vec()),
                    None => return unsupported("an index out of range"),
                },
                Some(index) => {
                    let kind = self.graph.kind(index);
                    let mut result = data[..stride].to_vec();
                    for k in 1..count {
                        let k_id = self.graph.constant(k as u32, kind);
                        let hit = self.graph.op(Op::EqualI, &[index, k_id], Kind::Bool);
                        for (c, r) in result.iter_mut().enumerate() {
                            let kind = self.graph.kind(*r);
                            *r = self.graph.op(Op::Select, &[hit, data[k * stride + c], *r], kind);
                        }
                    }
                    Value::Data(result)
                }
            },
            Value::Place { first, dynamic: mut chain, .. } => {
                if let Some(index) = dynamic {
                    chain.push((index, stride, count));
                }
                Value::Place { first: first + offset, len: stride, dynamic: chain }
            }
            Value::Uniforms => {
                let index = match dynamic {
                    Some(id) => id,
                    None => self.graph.constant(index as u32, Kind::Uint),
                };
                Value::UniformVec4(index)
            }
            Value::UniformVec4(vec4) if dynamic.is_none() => Value::UniformScalar(vec4, index as u32),
            Value::UniformVec4(vec4) => {
                let data = self.load(Value::UniformVec4(vec4))?;
                return self.access_flat(Value::Data(data), 0, 1, 4, dynamic, 0);
            }
            Value::UniformScalar(..) => return unsupported("an element of a scalar"),
        })
    }

    fn un(&mut self, op: Op, x: Id) -> Id {
        self.graph.op(op, &[x], Kind::Float)
    }
    fn bin(&mut self, op: Op, x: Id, y: Id) -> Id {
        self.graph.op(op, &[x, y], Kind::Float)
    }
    fn fold_bools(&mut self, op: Op, v: &[Id]) -> Id {
        v[1..].iter().fold(v[0], |a, x| self.graph.op(op, &[a, *x], Kind::Bool))
    }

    fn convert(&mut self, x: Id, to: ScalarKind, convert: bool) -> Id {
        let from = self.graph.kind(x);
        let to = match to {
            ScalarKind::Float | ScalarKind::AbstractFloat => Kind::Float,
            ScalarKind::Sint | ScalarKind::AbstractInt => Kind::Int,
            ScalarKind::Uint => Kind::Uint,
            ScalarKind::Bool => Kind::Bool,
        };
        if from == to {
            return x;
        }
        if !convert {
            // Only the kind changes; the copy gives the same bits a node of that kind.
            return match self.graph.constant_bits(x) {
                Some(bits) => self.graph.constant(bits, to),
                None => self.graph.op(Op::Copy, &[x], to),
            };
        }
        match (from, to) {
            (Kind::Float, Kind::Int) => self.graph.op(Op::FloatToInt, &[x], to),
            (Kind::Float, Kind::Uint) => self.graph.op(Op::FloatToUint, &[x], to),
            (Kind::Int, Kind::Float) => self.graph.op(Op::IntToFloat, &[x], to),
            (Kind::Uint, Kind::Float) => self.graph.op(Op::UintToFloat, &[x], to),
            (Kind::Bool, Kind::Float) => {
                let one = self.graph.float(1.0);
                self.graph.op(Op::And, &[x, one], to)
            }
            (Kind::Bool, _) => {
                let one = self.graph.constant(1, to);
                self.graph.op(Op::And, &[x, one], to)
            }
            (Kind::Float, Kind::Bool) => {
                let zero = self.graph.float(0.0);
                self.graph.op(Op::NotEqual, &[x, zero], to)
            }
            (_, Kind::Bool) => self.graph.op(Op::NonZero, &[x], to),
            _ => self.graph.op(Op::Copy, &[x], to),
        }
    }

    fn binary(&mut self, op: B, (l, left): (&[Id], &TypeInner), (r, right): (&[Id], &TypeInner)) -> Result<Vec<Id>> {
        if op == B::Multiply {
            match (left, right) {
                (TypeInner::Matrix { columns, rows, .. }, TypeInner::Vector { .. }) => {
                    return Ok(self.matrix_vector(l, *columns as usize, *rows as usize, r));
                }
                (TypeInner::Vector { .. }, TypeInner::Matrix { rows, .. }) => {
                    return Ok(r.chunks(*rows as usize).map(|column| self.dot(l, column)).collect());
                }
                (TypeInner::Matrix { columns, rows, .. }, TypeInner::Matrix { rows: inner, .. }) => {
                    let (columns, rows) = (*columns as usize, *rows as usize);
                    return Ok(r.chunks(*inner as usize).flat_map(|column| self.matrix_vector(l, columns, rows, column)).collect());
                }
                _ => {}
            }
        }
        let n = l.len().max(r.len());
        let at = |v: &[Id], i: usize| v[if v.len() == 1 { 0 } else { i }];
        Ok((0..n).map(|i| self.binary_scalar(op, at(l, i), at(r, i))).collect())
    }

    fn binary_scalar(&mut self, op: B, l: Id, r: Id) -> Id {
        let kind = self.graph.kind(l);
        let pick = |float: Op, int: Op, uint: Op| match kind {
            Kind::Float => float,
            Kind::Int => int,
            _ => uint,
        };
        let (op, kind, swap) = match op {
            B::Add => (pick(Op::Add, Op::AddI, Op::AddI), kind, false),
            B::Subtract => (pick(Op::Sub, Op::SubI, Op::SubI), kind, false),
            B::Multiply => (pick(Op::Mul, Op::MulI, Op::MulI), kind, false),
            B::Divide => (pick(Op::Div, Op::DivI, Op::DivU), kind, false),
            B::Modulo => (pick(Op::Rem, Op::RemI, Op::RemU), kind, false),
            B::Equal => (pick(Op::Equal, Op::EqualI, Op::EqualI), Kind::Bool, false),
            B::NotEqual => (pick(Op::NotEqual, Op::NotEqualI, Op::NotEqualI), Kind::Bool, false),
            B::Less => (pick(Op::Less, Op::LessI, Op::LessU), Kind::Bool, false),
            B::LessEqual => (pick(Op::LessEqual, Op::LessEqualI, Op::LessEqualU), Kind::Bool, false),
            B::Greater => (pick(Op::Less, Op::LessI, Op::LessU), Kind::Bool, true),
            B::GreaterEqual => (pick(Op::LessEqual, Op::LessEqualI, Op::LessEqualU), Kind::Bool, true),
            B::And | B::LogicalAnd => (Op::And, kind, false),
            B::InclusiveOr | B::LogicalOr => (Op::Or, kind, false),
            B::ExclusiveOr => (Op::Xor, kind, false),
            B::ShiftLeft => (Op::Shl, kind, false),
            B::ShiftRight => (pick(Op::ShrU, Op::ShrI, Op::ShrU), kind, false),
        };
        let args = if swap { [r, l] } else { [l, r] };
        self.graph.op(op, &args, kind)
    }

    fn dot(&mut self, a: &[Id], b: &[Id]) -> Id {
        if self.graph.kind(a[0]) != Kind::Float {
            let kind = self.graph.kind(a[0]);
            let mut sum = self.graph.op(Op::MulI, &[a[0], b[0]], kind);
            for i in 1..a.len() {
                let product = self.graph.op(Op::MulI, &[a[i], b[i]], kind);
                sum = self.graph.op(Op::AddI, &[sum, product], kind);
            }
            return sum;
        }
        let mut sum = self.bin(Op::Mul, a[0], b[0]);
        for i in 1..a.len() {
            let product = self.bin(Op::Mul, a[i], b[i]);
            sum = self.bin(Op::Add, sum, product);
        }
        sum
    }

    /// Columns times components, added from the first to the last.
    fn matrix_vector(&mut self, m: &[Id], columns: usize, rows: usize, v: &[Id]) -> Vec<Id> {
        (0..rows)
            .map(|row| {
                let line: Vec<Id> = (0..columns).map(|c| m[c * rows + row]).collect();
                self.dot(&line, v)
            })
            .collect()
    }

    fn math(&mut self, fun: M, a: &[Id], b: &[Id], c: &[Id], arg: &TypeInner, _result: &TypeInner) -> Result<Vec<Id>> {
        let kind = self.graph.kind(a[0]);
        let pick = |float: Op, int: Op, uint: Op| match kind {
            Kind::Float => float,
            Kind::Int => int,
            _ => uint,
        };
        let each1 = |s: &mut Self, op: Op| a.iter().map(|x| s.graph.op(op, &[*x], kind)).collect();
        let each2 = |s: &mut Self, op: Op| a.iter().zip(b).map(|(x, y)| s.graph.op(op, &[*x, *y], kind)).collect();
        Ok(match fun {
            M::Abs => match kind {
                Kind::Uint => a.to_vec(),
                _ => each1(self, pick(Op::Abs, Op::AbsI, Op::AbsI)),
            },
            M::Sign => each1(self, pick(Op::Sign, Op::SignI, Op::SignI)),
            M::Min => each2(self, pick(Op::Min, Op::MinI, Op::MinU)),
            M::Max => each2(self, pick(Op::Max, Op::MaxI, Op::MaxU)),
            M::Clamp => {
                let (max, min) = (pick(Op::Max, Op::MaxI, Op::MaxU), pick(Op::Min, Op::MinI, Op::MinU));
                (0..a.len())
                    .map(|i| {
                        let low = self.graph.op(max, &[a[i], b[i]], kind);
                        self.graph.op(min, &[low, c[i]], kind)
                    })
                    .collect()
            }
            M::Saturate => each1(self, Op::Saturate),
            M::Cos => each1(self, Op::Cos),
            M::Sin => each1(self, Op::Sin),
            M::Tan => each1(self, Op::Tan),
            M::Acos => each1(self, Op::Acos),
            M::Asin => each1(self, Op::Asin),
            M::Atan => each1(self, Op::Atan),
            M::Atan2 => each2(self, Op::Atan2),
            M::Radians => self.scale(a, std::f32::consts::PI / 180.0),
            M::Degrees => self.scale(a, 180.0 / std::f32::consts::PI),
            M::Ceil => each1(self, Op::Ceil),
            M::Floor => each1(self, Op::Floor),
            M::Round => each1(self, Op::Round),
            M::Fract => each1(self, Op::Fract),
            M::Trunc => each1(self, Op::Trunc),
            M::Exp => each1(self, Op::Exp),
            M::Exp2 => each1(self, Op::Exp2),
            M::Log => each1(self, Op::Log),
            M::Log2 => each1(self, Op::Log2),
            M::Pow => each2(self, Op::Pow),
            M::Sqrt => each1(self, Op::Sqrt),
            M::InverseSqrt => each1(self, Op::InverseSqrt),
            M::Dot => vec![self.dot(a, b)],
            M::Cross => (0..3)
                .map(|i| {
                    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
                    let x = self.bin(Op::Mul, a[j], b[k]);
                    let y = self.bin(Op::Mul, a[k], b[j]);
                    self.bin(Op::Sub, x, y)
                })
                .collect(),
            M::Length => vec![self.length(a)],
            M::Distance => {
                let d: Vec<Id> = a.iter().zip(b).map(|(x, y)| self.bin(Op::Sub, *x, *y)).collect();
                vec![self.length(&d)]
            }
            M::Normalize => {
                let square = self.dot(a, a);
                let scale = self.un(Op::InverseSqrt, square);
                a.iter().map(|x| self.bin(Op::Mul, *x, scale)).collect()
            }
            M::FaceForward => {
                let d = self.dot(c, b);
                let zero = self.graph.float(0.0);
                let keep = self.graph.op(Op::Less, &[d, zero], Kind::Bool);
                a.iter()
                    .map(|x| {
                        let negative = self.un(Op::Neg, *x);
                        self.graph.op(Op::Select, &[keep, *x, negative], kind)
                    })
                    .collect()
            }
            M::Reflect => {
                let d = self.dot(b, a);
                let two = self.graph.float(2.0);
                let d2 = self.bin(Op::Mul, d, two);
                a.iter()
                    .zip(b)
                    .map(|(x, n)| {
                        let along = self.bin(Op::Mul, d2, *n);
                        self.bin(Op::Sub, *x, along)
                    })
                    .collect()
            }
            M::Refract => self.refract(a, b, c[0]),
            M::Fma => (0..a.len()).map(|i| self.graph.op(Op::Fma, &[a[i], b[i], c[i]], kind)).collect(),
            M::Mix => {
                let one = self.graph.float(1.0);
                (0..a.len())
                    .map(|i| {
                        let t = c[if c.len() == 1 { 0 } else { i }];
                        let rest = self.bin(Op::Sub, one, t);
                        let x = self.bin(Op::Mul, a[i], rest);
                        let y = self.bin(Op::Mul, b[i], t);
                        self.bin(Op::Add, x, y)
                    })
                    .collect()
            }
            M::Step => {
                let (zero, one) = (self.graph.float(0.0), self.graph.float(1.0));
                a.iter()
                    .zip(b)
                    .map(|(edge, x)| {
                        let there = self.graph.op(Op::LessEqual, &[*edge, *x], Kind::Bool);
                        self.graph.op(Op::Select, &[there, one, zero], kind)
                    })
                    .collect()
            }
            M::SmoothStep => {
                let (two, three) = (self.graph.float(2.0), self.graph.float(3.0));
                (0..a.len())
                    .map(|i| {
                        let x = self.bin(Op::Sub, c[i], a[i]);
                        let width = self.bin(Op::Sub, b[i], a[i]);
                        let t = self.bin(Op::Div, x, width);
                        let t = self.un(Op::Saturate, t);
                        let t2 = self.bin(Op::Mul, t, two);
                        let rest = self.bin(Op::Sub, three, t2);
                        let square = self.bin(Op::Mul, t, t);
                        self.bin(Op::Mul, square, rest)
                    })
                    .collect()
            }
            M::Transpose => {
                let TypeInner::Matrix { columns, rows, .. } = arg else { return unsupported("transpose of no matrix") };
                let (columns, rows) = (*columns as usize, *rows as usize);
                (0..columns * rows).map(|i| a[(i % columns) * rows + i / columns]).collect()
            }
            other => return unsupported(format!("function {other:?}")),
        })
    }

    fn scale(&mut self, a: &[Id], by: f32) -> Vec<Id> {
        let by = self.graph.float(by);
        a.iter().map(|x| self.bin(Op::Mul, *x, by)).collect()
    }

    fn length(&mut self, a: &[Id]) -> Id {
        if a.len() == 1 {
            return self.un(Op::Abs, a[0]);
        }
        let square = self.dot(a, a);
        self.un(Op::Sqrt, square)
    }

    fn refract(&mut self, incident: &[Id], normal: &[Id], eta: Id) -> Vec<Id> {
        let (zero, one) = (self.graph.float(0.0), self.graph.float(1.0));
        let d = self.dot(normal, incident);
        let dd = self.bin(Op::Mul, d, d);
        let sine = self.bin(Op::Sub, one, dd);
        let eta2 = self.bin(Op::Mul, eta, eta);
        let lost = self.bin(Op::Mul, eta2, sine);
        let k = self.bin(Op::Sub, one, lost);
        let total = self.graph.op(Op::Less, &[k, zero], Kind::Bool);
        let ed = self.bin(Op::Mul, eta, d);
        let root = self.un(Op::Sqrt, k);
        let along = self.bin(Op::Add, ed, root);
        incident
            .iter()
            .zip(normal)
            .map(|(i, n)| {
                let x = self.bin(Op::Mul, eta, *i);
                let y = self.bin(Op::Mul, along, *n);
                let bent = self.bin(Op::Sub, x, y);
                self.graph.op(Op::Select, &[total, zero, bent], Kind::Float)
            })
            .collect()
    }
}
