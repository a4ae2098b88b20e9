//! The operations of lane programs. Each is written once, as a function of one lane; [`machine`](super::machine)
//! instantiates it over groups of lanes for every SIMD level.
//!
//! The results are the same bits on every level: nothing is reassociated or fused, `min` and `max` have one written
//! rule for NaN and zeros, and the transcendental functions are ours ([`math`]).

use super::math;

/// An instruction's operand or destination: group offset << 3 | space << 1 | step.
///
/// The step is 1 where every group has its own value, 0 where one group of equal lanes serves all.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub(super) struct Operand(pub u32);

/// Which memory an operand lies in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(u32)]
pub(super) enum Space {
    Registers = 0,
    Inputs = 1,
    Outputs = 2,
    Depth = 3,
}

impl Operand {
    pub fn new(space: Space, group: u32, step: u32) -> Operand {
        Operand(group << 3 | (space as u32) << 1 | step)
    }
    #[inline(always)]
    pub fn group(self) -> usize {
        (self.0 >> 3) as usize
    }
    #[inline(always)]
    pub fn space(self) -> usize {
        (self.0 >> 1 & 3) as usize
    }
    #[inline(always)]
    pub fn step(self) -> usize {
        (self.0 & 1) as usize
    }
}

/// One instruction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Inst {
    pub op: Op,
    pub to: Operand,
    pub a: Operand,
    pub b: Operand,
    pub c: Operand,
    /// Sample: index of the call. Loop end: where to go on. Gather: component.
    pub imm: u32,
}

#[inline(always)]
pub(super) fn int(x: f32) -> i32 {
    x.to_bits() as i32
}
#[inline(always)]
pub(super) fn uint(x: f32) -> u32 {
    x.to_bits()
}
#[inline(always)]
fn bits(x: i32) -> f32 {
    f32::from_bits(x as u32)
}
#[inline(always)]
fn ubits(x: u32) -> f32 {
    f32::from_bits(x)
}
/// A boolean in a register: all ones or all zeros.
#[inline(always)]
pub(super) fn mask(x: bool) -> f32 {
    f32::from_bits(if x { !0 } else { 0 })
}
#[inline(always)]
pub(super) fn is_true(x: f32) -> bool {
    int(x) < 0
}

/// Names every operation with its function of one lane, and hands the table to the macro `$then`.
macro_rules! op_table {
    ($then:ident) => {
        $then! {
            unary {
                Copy(x) = x,
                Neg(x) = -x,
                Abs(x) = x.abs(),
                Floor(x) = x.floor(),
                Ceil(x) = x.ceil(),
                Trunc(x) = x.trunc(),
                Round(x) = x.round_ties_even(),
                Fract(x) = x - x.floor(),
                Sqrt(x) = x.sqrt(),
                InverseSqrt(x) = 1.0 / x.sqrt(),
                Saturate(x) = math::min(math::max(x, 0.0), 1.0),
                Sign(x) = if x > 0.0 { 1.0 } else if x < 0.0 { -1.0 } else { 0.0 },
                Exp2(x) = math::exp2(x),
                Log2(x) = math::log2(x),
                Exp(x) = math::exp(x),
                Log(x) = math::log(x),
                Sin(x) = math::sin(x),
                Cos(x) = math::cos(x),
                Tan(x) = math::tan(x),
                Asin(x) = math::asin(x),
                Acos(x) = math::acos(x),
                Atan(x) = math::atan(x),
                Not(x) = ubits(!uint(x)),
                NegI(x) = bits(int(x).wrapping_neg()),
                AbsI(x) = bits(int(x).wrapping_abs()),
                SignI(x) = bits(int(x).signum()),
                FloatToInt(x) = bits(x as i32),
                FloatToUint(x) = ubits(x as u32),
                IntToFloat(x) = int(x) as f32,
                UintToFloat(x) = uint(x) as f32,
                NonZero(x) = mask(uint(x) != 0),
            }
            binary {
                Add(x, y) = x + y,
                Sub(x, y) = x - y,
                Mul(x, y) = x * y,
                Div(x, y) = x / y,
                Rem(x, y) = x - y * (x / y).trunc(),
                Min(x, y) = math::min(x, y),
                Max(x, y) = math::max(x, y),
                Pow(x, y) = math::pow(x, y),
                Atan2(x, y) = math::atan2(x, y),
                Less(x, y) = mask(x < y),
                LessEqual(x, y) = mask(x <= y),
                Equal(x, y) = mask(x == y),
                NotEqual(x, y) = mask(x != y),
                AddI(x, y) = ubits(uint(x).wrapping_add(uint(y))),
                SubI(x, y) = ubits(uint(x).wrapping_sub(uint(y))),
                MulI(x, y) = ubits(uint(x).wrapping_mul(uint(y))),
                DivI(x, y) = bits(if int(y) == 0 { int(x) } else { int(x).wrapping_div(int(y)) }),
                DivU(x, y) = ubits(if uint(y) == 0 { uint(x) } else { uint(x) / uint(y) }),
                RemI(x, y) = bits(if int(y) == 0 { 0 } else { int(x).wrapping_rem(int(y)) }),
                RemU(x, y) = ubits(if uint(y) == 0 { 0 } else { uint(x) % uint(y) }),
                And(x, y) = ubits(uint(x) & uint(y)),
                Or(x, y) = ubits(uint(x) | uint(y)),
                Xor(x, y) = ubits(uint(x) ^ uint(y)),
                Shl(x, y) = ubits(uint(x) << (uint(y) & 31)),
                ShrI(x, y) = bits(int(x) >> (uint(y) & 31)),
                ShrU(x, y) = ubits(uint(x) >> (uint(y) & 31)),
                LessI(x, y) = mask(int(x) < int(y)),
                LessU(x, y) = mask(uint(x) < uint(y)),
                LessEqualI(x, y) = mask(int(x) <= int(y)),
                LessEqualU(x, y) = mask(uint(x) <= uint(y)),
                EqualI(x, y) = mask(uint(x) == uint(y)),
                NotEqualI(x, y) = mask(uint(x) != uint(y)),
                MinI(x, y) = bits(if int(x) < int(y) { int(x) } else { int(y) }),
                MaxI(x, y) = bits(if int(x) > int(y) { int(x) } else { int(y) }),
                MinU(x, y) = ubits(if uint(x) < uint(y) { uint(x) } else { uint(y) }),
                MaxU(x, y) = ubits(if uint(x) > uint(y) { uint(x) } else { uint(y) }),
            }
            ternary {
                Fma(x, y, z) = x.mul_add(y, z),
                // Rounded twice: one instruction for a product and a sum, not a fused one.
                MulAdd(x, y, z) = x * y + z,
                Select(c, x, y) = if is_true(c) { x } else { y },
            }
            special { Const, Uniform, Base, Input, Gather, Sample, Texel, CellRead, LoopEnd, Keep }
        }
    };
}

macro_rules! define_op {
    (unary { $($u:ident ($ux:ident) = $ue:expr,)* }
     binary { $($b:ident ($bx:ident, $by:ident) = $be:expr,)* }
     ternary { $($t:ident ($tx:ident, $ty:ident, $tz:ident) = $te:expr,)* }
     special { $($s:ident),* }) => {
        /// What an instruction does.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        #[repr(u8)]
        pub(super) enum Op { $($u,)* $($b,)* $($t,)* $($s,)* }

        impl Op {
            /// Operands taken from other nodes, for the operations that are functions of one lane.
            pub fn arity(self) -> usize {
                match self {
                    $(Op::$u => 1,)*
                    $(Op::$b => 2,)*
                    $(Op::$t => 3,)*
                    _ => 0,
                }
            }

            /// The value on one lane: the same functions that the machine runs over groups.
            pub fn apply(self, args: [u32; 3]) -> u32 {
                let [a, b, c] = args.map(f32::from_bits);
                let result = match self {
                    $(Op::$u => { let $ux = a; $ue })*
                    $(Op::$b => { let ($bx, $by) = (a, b); $be })*
                    $(Op::$t => { let ($tx, $ty, $tz) = (a, b, c); $te })*
                    _ => unreachable!("not a function of one lane"),
                };
                result.to_bits()
            }
        }

        /// Runs an operation that is a function of one lane over `n` groups.
        ///
        /// # Safety
        /// Each operand's memory holds `n` groups (one where its step is 0).
        #[inline(always)]
        pub(super) unsafe fn execute(inst: &Inst, bases: &[*mut Group; 4], n: usize) {
            let to = unsafe { bases[inst.to.space()].add(inst.to.group()) };
            let a = unsafe { bases[inst.a.space()].add(inst.a.group()).cast_const() };
            match inst.op {
                $(Op::$u => unsafe { unary(to, a, inst.a.step(), n, |$ux: f32| -> f32 { $ue }) },)*
                $(Op::$b => unsafe {
                    let b = bases[inst.b.space()].add(inst.b.group()).cast_const();
                    binary(to, a, inst.a.step(), b, inst.b.step(), n, |$bx: f32, $by: f32| -> f32 { $be })
                },)*
                $(Op::$t => unsafe {
                    let b = bases[inst.b.space()].add(inst.b.group()).cast_const();
                    let c = bases[inst.c.space()].add(inst.c.group()).cast_const();
                    let steps = [inst.a.step(), inst.b.step(), inst.c.step()];
                    ternary(to, [a, b, c], steps, n, |$tx: f32, $ty: f32, $tz: f32| -> f32 { $te })
                },)*
                _ => {}
            }
        }
    };
}
op_table!(define_op);

/// One SIMD register of lanes.
pub(super) type Group = [f32; super::LANES];

// SAFETY (all three): the caller promises `n` groups behind `to`, and behind each source `n` groups or one if its step is 0.
// A group is read whole before it is written, so a destination may be its own source.
#[inline(always)]
unsafe fn unary(to: *mut Group, a: *const Group, step: usize, n: usize, f: impl Fn(f32) -> f32) {
    for g in 0..n {
        let x = unsafe { *a.add(g * step) };
        let mut r = [0.0; super::LANES];
        for l in 0..super::LANES {
            r[l] = f(x[l]);
        }
        unsafe { *to.add(g) = r };
    }
}

#[inline(always)]
unsafe fn binary(to: *mut Group, a: *const Group, sa: usize, b: *const Group, sb: usize, n: usize, f: impl Fn(f32, f32) -> f32) {
    for g in 0..n {
        let (x, y) = unsafe { (*a.add(g * sa), *b.add(g * sb)) };
        let mut r = [0.0; super::LANES];
        for l in 0..super::LANES {
            r[l] = f(x[l], y[l]);
        }
        unsafe { *to.add(g) = r };
    }
}

#[inline(always)]
unsafe fn ternary(to: *mut Group, from: [*const Group; 3], steps: [usize; 3], n: usize, f: impl Fn(f32, f32, f32) -> f32) {
    for g in 0..n {
        let (x, y, z) = unsafe { (*from[0].add(g * steps[0]), *from[1].add(g * steps[1]), *from[2].add(g * steps[2])) };
        let mut r = [0.0; super::LANES];
        for l in 0..super::LANES {
            r[l] = f(x[l], y[l], z[l]);
        }
        unsafe { *to.add(g) = r };
    }
}
