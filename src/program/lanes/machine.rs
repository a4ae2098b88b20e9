//! Runs lane programs. The loop over instructions is written once and instantiated for each SIMD level; which one
//! runs is chosen once per process (`TEPUI_SIMD=auto|avx2|scalar`), and all give the same bits.

use std::sync::OnceLock;

use super::op::{Group, Inst, Op, execute};
use super::schedule::LaneProgram;
use super::{Column4, Environment, FragmentResults, GROUPS, LANES};
use crate::draw::texture::TextureBinding;
use crate::program::Program;
use crate::raster::texture::Prepared;

/// Instruction sets that the executor is built for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Simd {
    /// What the target has at least.
    Scalar,
    /// AVX2 with FMA.
    Avx2,
}

/// The level that this process uses.
pub fn simd() -> Simd {
    static LEVEL: OnceLock<Simd> = OnceLock::new();
    *LEVEL.get_or_init(|| {
        let asked = std::env::var("TEPUI_SIMD").unwrap_or_default();
        if asked != "scalar" && avx2_available() {
            return Simd::Avx2;
        }
        if asked == "avx2" {
            log::warn!("TEPUI_SIMD=avx2: this processor has no AVX2 with FMA");
        }
        Simd::Scalar
    })
}

/// True where [`Simd::Avx2`] can run.
pub fn avx2_available() -> bool {
    #[cfg(target_arch = "x86_64")]
    {
        is_x86_feature_detected!("avx2") && is_x86_feature_detected!("fma")
    }
    #[cfg(not(target_arch = "x86_64"))]
    {
        false
    }
}

/// Rounds that a loop may take before it is given up: a shader that hangs must not hang the process.
const MAX_ROUNDS: u32 = 1 << 20;

/// Registers, kept from run to run. One a thread.
pub struct Machine {
    registers: Vec<Group>,
    level: Simd,
}

impl Default for Machine {
    fn default() -> Machine {
        Machine::with_simd(simd())
    }
}

/// What instructions reach besides registers.
struct Reach<'a> {
    program: &'a LaneProgram,
    textures: &'a [TextureBinding],
    uniforms: &'a [[f32; 4]],
    keep: &'a mut [u8; GROUPS],
    level: Simd,
}

impl Machine {
    /// A machine of a given level. Asking for one that this processor lacks gives [`Simd::Scalar`].
    pub fn with_simd(level: Simd) -> Machine {
        let level = if level == Simd::Avx2 && avx2_available() { Simd::Avx2 } else { Simd::Scalar };
        Machine { registers: Vec::new(), level }
    }

    /// Runs a vertex program over `groups` groups. `inputs[i]` is attribute slot `i` (only those that the program
    /// reads need to be filled); `outputs[0]` becomes the clip position, `outputs[1 + k]` is `program.outputs[k]`.
    pub fn run_vertex(&mut self, program: &Program, env: &Environment, inputs: &[Column4; 16], outputs: &mut [Column4], groups: usize) {
        assert!(outputs.len() > program.outputs.len() && groups <= GROUPS);
        let mut keep = [0; GROUPS];
        let mut no_depth = [[0.0; LANES]; GROUPS];
        self.run(program, env, inputs, outputs, &mut no_depth, &mut keep, groups);
    }

    /// Runs a fragment program over `groups` groups. `inputs[k]` is `program.inputs[k]`.
    pub fn run_fragment(&mut self, program: &Program, env: &Environment, inputs: &[Column4], results: &mut FragmentResults, groups: usize) {
        assert!(inputs.len() >= program.inputs.len() && groups <= GROUPS);
        results.keep = [!0; GROUPS];
        let FragmentResults { color, depth, keep } = results;
        self.run(program, env, inputs, std::slice::from_mut(color), depth, keep, groups);
    }

    fn run(
        &mut self,
        program: &Program,
        env: &Environment,
        inputs: &[Column4],
        outputs: &mut [Column4],
        depth: &mut super::Column,
        keep: &mut [u8; GROUPS],
        groups: usize,
    ) {
        let code = program.lanes();
        if self.registers.len() < code.registers as usize {
            self.registers.resize(code.registers as usize, [0.0; LANES]);
        }
        for &(bits, register) in &code.constants {
            self.registers[register as usize] = [f32::from_bits(bits); LANES];
        }
        let block = env.uniforms.get(env.base as usize..).unwrap_or_default();
        for &(word, register) in &code.uniforms {
            let value = block.get(word as usize >> 2).map_or(0.0, |v| v[word as usize & 3]);
            self.registers[register as usize] = [value; LANES];
        }
        if let Some(register) = code.base {
            self.registers[register as usize] = [f32::from_bits(env.base); LANES];
        }
        // Inputs are never written: no instruction's destination lies in their space.
        let bases = [
            self.registers.as_mut_ptr(),
            inputs.as_ptr().cast::<Group>().cast_mut(),
            outputs.as_mut_ptr().cast::<Group>(),
            depth.as_mut_ptr(),
        ];
        let mut reach = Reach { program: code, textures: env.textures, uniforms: env.uniforms, keep, level: self.level };
        // SAFETY: the scheduler gives every register operand a place below `registers`; input operands lie in the
        // columns that the program declares, output operands in its outputs (both lengths asserted above, columns hold
        // GROUPS groups each). AVX2 was detected if the level says so.
        unsafe {
            match self.level {
                #[cfg(target_arch = "x86_64")]
                Simd::Avx2 => {
                    run_avx2(&code.prologue, &bases, 1, &mut reach);
                    run_avx2(&code.body, &bases, groups, &mut reach);
                }
                _ => {
                    run_scalar(&code.prologue, &bases, 1, &mut reach);
                    run_scalar(&code.body, &bases, groups, &mut reach);
                }
            }
        }
    }
}

#[inline(never)]
unsafe fn run_scalar(code: &[Inst], bases: &[*mut Group; 4], n: usize, reach: &mut Reach) {
    unsafe { run_code(code, bases, n, reach) }
}

#[cfg(target_arch = "x86_64")]
#[target_feature(enable = "avx2,fma")]
unsafe fn run_avx2(code: &[Inst], bases: &[*mut Group; 4], n: usize, reach: &mut Reach) {
    unsafe { run_code(code, bases, n, reach) }
}

/// The interpreter.
///
/// # Safety
/// All operands of `code` lie in their memories with `n` groups.
#[inline(always)]
unsafe fn run_code(code: &[Inst], bases: &[*mut Group; 4], n: usize, reach: &mut Reach) {
    let mut at = 0;
    let mut rounds = 0;
    while let Some(inst) = code.get(at) {
        at += 1;
        match inst.op {
            Op::Gather => unsafe {
                let index = bases[inst.a.space()].add(inst.a.group()).cast_const();
                let to = bases[inst.to.space()].add(inst.to.group());
                for g in 0..n {
                    let index = *index.add(g * inst.a.step());
                    *to.add(g) = index.map(|i| reach.uniforms.get(i.to_bits() as usize).map_or(0.0, |v| v[inst.imm as usize & 3]));
                }
            },
            Op::Sample => unsafe { sample(inst, bases, n, reach) },
            Op::LoopEnd => unsafe {
                let condition = bases[inst.a.space()].add(inst.a.group()).cast_const();
                let mut any = false;
                for g in 0..n {
                    any |= (*condition.add(g * inst.a.step())).iter().any(|x| x.to_bits() != 0);
                }
                rounds += 1;
                if any && rounds < MAX_ROUNDS {
                    at = inst.imm as usize;
                }
            },
            Op::Keep => unsafe {
                let value = bases[inst.a.space()].add(inst.a.group()).cast_const();
                for g in 0..n {
                    let lanes = *value.add(g * inst.a.step());
                    reach.keep[g] = lanes.iter().enumerate().fold(0, |m, (l, x)| m | ((x.to_bits() >> 31) as u8) << l);
                }
            },
            _ => unsafe { execute(inst, bases, n) },
        }
    }
}

/// A texture sample: columns are handed to the sampler, which fills the four result columns.
///
/// # Safety
/// As `run_code`.
#[inline(always)]
unsafe fn sample(inst: &Inst, bases: &[*mut Group; 4], n: usize, reach: &mut Reach) {
    let call = &reach.program.samples[inst.imm as usize];
    let read = |o: super::op::Operand, g: usize| unsafe { *bases[o.space()].add(o.group() + g * o.step()) };
    let texture = reach.textures.get(call.slot as usize).map(|binding| Prepared::new(binding, None));
    for g in 0..n {
        let coord = call.coord.map(|o| read(o, g));
        let texel = match &texture {
            Some(texture) => match &call.gradients {
                None => texture.group(&coord, None, reach.level),
                Some(gradients) => {
                    let [ddx, ddy] = gradients.map(|v| v.map(|o| read(o, g)));
                    texture.group(&coord, Some([&ddx, &ddy]), reach.level)
                }
            },
            None => [[0.0; LANES], [0.0; LANES], [0.0; LANES], [1.0; LANES]],
        };
        for (to, value) in call.to.iter().zip(texel) {
            unsafe { *bases[to.space()].add(to.group() + g * to.step()) = value };
        }
    }
}
