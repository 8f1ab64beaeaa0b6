//! A tape as instructions on a small register file; a register holds one block of points.

use pulp::{Simd, WithSimd};

use crate::batch::{BLOCK, Batch};
use crate::operation::{Binary, Node, Operation, Unary};
use crate::registers::{Allocation, Instruction, Kernel};

/// The instruction set that evaluates a tape; all give bit-identical results.
#[derive(Debug, Clone, Copy)]
pub struct Instructions(pulp::Arch);

impl Instructions {
    /// The widest instruction set of this processor.
    pub fn best() -> Self {
        Self(pulp::Arch::new())
    }

    /// No vector instructions.
    pub fn scalar() -> Self {
        Self(pulp::Arch::Scalar)
    }

    /// All instruction sets of this processor, the narrowest first.
    pub fn available() -> Vec<Self> {
        let mut all = vec![pulp::Arch::Scalar];
        #[cfg(target_arch = "x86_64")]
        {
            all.extend(pulp::x86::V3::try_new().map(pulp::Arch::V3));
            all.extend(pulp::x86::V4::try_new().map(pulp::Arch::V4));
        }
        #[cfg(target_arch = "aarch64")]
        all.extend(pulp::aarch64::Neon::try_new().map(pulp::Arch::Neon));
        all.into_iter().map(Self).collect()
    }
}

/// The values of one register at one block of points, aligned for the widest vectors.
#[derive(Debug, Clone, Copy)]
#[repr(align(64))]
struct Register([f64; BLOCK]);

/// Registers that are reused from call to call.
#[derive(Debug, Clone, Default)]
pub struct Workspace {
    registers: Vec<Register>,
}

/// The instructions that are executed for every block of points.
#[derive(Debug, Clone)]
pub struct Program(Allocation);

impl Program {
    /// Compiles operations given in evaluation order.
    pub fn new(operations: &[Operation], outputs: &[Node]) -> Self {
        Self(Allocation::new(operations, outputs))
    }

    /// Runs all instructions for every block of points.
    pub fn run(&self, instructions: Instructions, inputs: &Batch, outputs: &mut Batch, workspace: &mut Workspace) {
        let registers = &mut workspace.registers;
        registers.clear();
        registers.extend(self.0.constants.iter().map(|&constant| Register([constant; BLOCK])));
        registers.resize(self.0.register_count as usize, Register([0.0; BLOCK]));
        instructions.0.dispatch(Run { program: self, inputs, outputs, registers });
    }

    #[inline(always)]
    fn load(&self, block: usize, inputs: &Batch, registers: &mut [Register]) {
        for &(input, to) in &self.0.loads {
            registers[to as usize].0 = *inputs.block(input as usize, block);
        }
        let points = inputs.points_of_block(block);
        if points < BLOCK {
            // The padding repeats a point, because arithmetic on invalid values may be slow.
            for &(_, to) in &self.0.loads {
                let register = &mut registers[to as usize].0;
                let last = register[points - 1];
                register[points..].fill(last);
            }
        }
    }

    #[inline(always)]
    fn store(&self, block: usize, registers: &[Register], outputs: &mut Batch) {
        for (output, &from) in self.0.stores.iter().enumerate() {
            *outputs.block_mut(output, block) = registers[from as usize].0;
        }
    }
}

/// A run, as a type because a closure would not be inlined into the function that enables the instruction set.
struct Run<'run> {
    program: &'run Program,
    inputs: &'run Batch,
    outputs: &'run mut Batch,
    registers: &'run mut [Register],
}

impl WithSimd for Run<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let mut file = RegisterFile { simd, registers: self.registers };
        for block in 0..self.inputs.blocks() {
            self.program.load(block, self.inputs, file.registers);
            for &instruction in &self.program.0.instructions {
                file.execute(instruction);
            }
            self.program.store(block, file.registers, self.outputs);
        }
    }
}

/// Registers with the vector instructions that work on them. Loops are written over whole vectors: the compiler's own
/// vectorisation stores values of mixed widths, and later loads have to wait for these.
struct RegisterFile<'run, S> {
    simd: S,
    registers: &'run mut [Register],
}

impl<S: Simd> RegisterFile<'_, S> {
    #[inline(always)]
    fn execute(&mut self, Instruction { kernel, operands: [a, b, c], to }: Instruction) {
        let simd = self.simd;
        match kernel {
            Kernel::MultiplyAdd => self.ternary(a, b, c, to, |x, y, z| simd.add_f64s(simd.mul_f64s(x, y), z)),
            Kernel::MultiplySubtract => self.ternary(a, b, c, to, |x, y, z| simd.sub_f64s(simd.mul_f64s(x, y), z)),
            Kernel::SubtractMultiply => self.ternary(a, b, c, to, |x, y, z| simd.sub_f64s(z, simd.mul_f64s(x, y))),
            Kernel::Binary(Binary::Add) => self.binary(a, b, to, |x, y| simd.add_f64s(x, y)),
            Kernel::Binary(Binary::Subtract) => self.binary(a, b, to, |x, y| simd.sub_f64s(x, y)),
            Kernel::Binary(Binary::Multiply) => self.binary(a, b, to, |x, y| simd.mul_f64s(x, y)),
            Kernel::Binary(Binary::Divide) => self.binary(a, b, to, |x, y| simd.div_f64s(x, y)),
            Kernel::Unary(Unary::Negate) => self.binary(a, a, to, |x, _| simd.neg_f64s(x)),
            Kernel::Unary(Unary::SquareRoot) => self.binary(a, a, to, |x, _| simd.sqrt_f64s(x)),
            Kernel::Unary(function) => self.each(a, to, function),
        }
    }

    #[inline(always)]
    fn ternary(&mut self, a: u32, b: u32, c: u32, to: u32, function: impl Fn(S::f64s, S::f64s, S::f64s) -> S::f64s) {
        for vector in 0..BLOCK / S::F64_LANES {
            let result = function(self.vector(a, vector), self.vector(b, vector), self.vector(c, vector));
            self.set_vector(to, vector, result);
        }
    }

    #[inline(always)]
    fn binary(&mut self, a: u32, b: u32, to: u32, function: impl Fn(S::f64s, S::f64s) -> S::f64s) {
        for vector in 0..BLOCK / S::F64_LANES {
            let result = function(self.vector(a, vector), self.vector(b, vector));
            self.set_vector(to, vector, result);
        }
    }

    /// Functions without vector instructions.
    fn each(&mut self, a: u32, to: u32, function: Unary) {
        self.registers[to as usize].0 = self.registers[a as usize].0.map(|value| function.apply(value));
    }

    #[inline(always)]
    fn vector(&self, register: u32, vector: usize) -> S::f64s {
        S::as_simd_f64s(&self.registers[register as usize].0).0[vector]
    }

    #[inline(always)]
    fn set_vector(&mut self, register: u32, vector: usize, value: S::f64s) {
        S::as_mut_simd_f64s(&mut self.registers[register as usize].0).0[vector] = value;
    }
}
