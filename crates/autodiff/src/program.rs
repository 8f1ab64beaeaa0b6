//! A tape as instructions on a small file of registers, each of which holds one block of points.

use crate::batch::{BLOCK, Batch};
use crate::operation::{Binary, Node, Operation, Unary};
use crate::registers::{Allocation, Instruction, Kernel};

/// Which vector instructions evaluate a tape; every choice gives the same bits.
#[derive(Debug, Clone, Copy)]
pub struct Instructions(pulp::Arch);

impl Instructions {
    /// The widest that this processor has.
    pub fn best() -> Self {
        Self(pulp::Arch::new())
    }

    /// None.
    pub fn scalar() -> Self {
        Self(pulp::Arch::Scalar)
    }

    /// All that this processor has, the narrowest first.
    pub fn available() -> Vec<Self> {
        let mut all = vec![Self::scalar()];
        #[cfg(target_arch = "x86_64")]
        {
            all.extend(pulp::x86::V3::try_new().map(|instructions| Self(pulp::Arch::V3(instructions))));
            all.extend(pulp::x86::V4::try_new().map(|instructions| Self(pulp::Arch::V4(instructions))));
        }
        all
    }
}

/// The values of one register at one block of points.
type Register = [f64; BLOCK];

/// Registers that are reused from call to call.
#[derive(Debug, Clone, Default)]
pub struct Workspace {
    registers: Vec<Register>,
}

/// What a tape executes for every block of points.
#[derive(Debug, Clone)]
pub struct Program(Allocation);

impl Program {
    /// Compiles operations that stand in evaluation order.
    pub fn new(operations: &[Operation], outputs: &[Node]) -> Self {
        Self(Allocation::new(operations, outputs))
    }

    /// Runs all instructions for every block of points.
    pub fn run(&self, instructions: Instructions, inputs: &Batch, outputs: &mut Batch, workspace: &mut Workspace) {
        let registers = &mut workspace.registers;
        registers.clear();
        registers.extend(self.0.constants.iter().map(|&constant| [constant; BLOCK]));
        registers.resize(self.0.register_count as usize, [0.0; BLOCK]);
        instructions.0.dispatch(
            #[inline(always)]
            || {
                for block in 0..inputs.blocks() {
                    self.load(block, inputs, registers);
                    for &instruction in &self.0.instructions {
                        execute(instruction, registers);
                    }
                    self.store(block, registers, outputs);
                }
            },
        );
    }

    #[inline(always)]
    fn load(&self, block: usize, inputs: &Batch, registers: &mut [Register]) {
        let points = inputs.points_of_block(block);
        for &(input, to) in &self.0.loads {
            let register = &mut registers[to as usize];
            *register = *inputs.block(input as usize, block);
            // The padding repeats a point, so that it takes no slow path through invalid numbers.
            let last = register[points - 1];
            register[points..].fill(last);
        }
    }

    #[inline(always)]
    fn store(&self, block: usize, registers: &[Register], outputs: &mut Batch) {
        for (output, &from) in self.0.stores.iter().enumerate() {
            *outputs.block_mut(output, block) = registers[from as usize];
        }
    }
}

#[inline(always)]
fn execute(Instruction { kernel, operands: [a, b, c], to }: Instruction, registers: &mut [Register]) {
    match kernel {
        Kernel::MultiplyAdd => ternary(registers, [a, b, c], to, |x, y, z| x * y + z),
        Kernel::MultiplySubtract => ternary(registers, [a, b, c], to, |x, y, z| x * y - z),
        Kernel::SubtractMultiply => ternary(registers, [a, b, c], to, |x, y, z| z - x * y),
        Kernel::Binary(Binary::Add) => binary(registers, [a, b], to, |x, y| x + y),
        Kernel::Binary(Binary::Subtract) => binary(registers, [a, b], to, |x, y| x - y),
        Kernel::Binary(Binary::Multiply) => binary(registers, [a, b], to, |x, y| x * y),
        Kernel::Binary(Binary::Divide) => binary(registers, [a, b], to, |x, y| x / y),
        Kernel::Unary(Unary::Negate) => unary(registers, a, to, |x| -x),
        Kernel::Unary(Unary::SquareRoot) => unary(registers, a, to, f64::sqrt),
        Kernel::Unary(Unary::Sine) => unary(registers, a, to, f64::sin),
        Kernel::Unary(Unary::Cosine) => unary(registers, a, to, f64::cos),
        Kernel::Unary(Unary::Exponential) => unary(registers, a, to, f64::exp),
        Kernel::Unary(Unary::Logarithm) => unary(registers, a, to, f64::ln),
    }
}

// The operands are copied because the result may replace one of them. Plain loops instead of iterator adapters:
// only what is inlined here is compiled for the chosen instruction set.

#[inline(always)]
fn ternary(registers: &mut [Register], operands: [u32; 3], to: u32, function: impl Fn(f64, f64, f64) -> f64) {
    let [first, second] = [registers[operands[0] as usize], registers[operands[1] as usize]];
    let third = registers[operands[2] as usize];
    let result = &mut registers[to as usize];
    for point in 0..BLOCK {
        result[point] = function(first[point], second[point], third[point]);
    }
}

#[inline(always)]
fn binary(registers: &mut [Register], operands: [u32; 2], to: u32, function: impl Fn(f64, f64) -> f64) {
    let [first, second] = [registers[operands[0] as usize], registers[operands[1] as usize]];
    let result = &mut registers[to as usize];
    for point in 0..BLOCK {
        result[point] = function(first[point], second[point]);
    }
}

#[inline(always)]
fn unary(registers: &mut [Register], operand: u32, to: u32, function: impl Fn(f64) -> f64) {
    let argument = registers[operand as usize];
    let result = &mut registers[to as usize];
    for point in 0..BLOCK {
        result[point] = function(argument[point]);
    }
}
