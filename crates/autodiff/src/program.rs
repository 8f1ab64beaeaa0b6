//! A tape as instructions on a small file of registers, each of which holds one block of points.

use crate::batch::{BLOCK, Batch};
use crate::graph::{Node, Operation};

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
}

/// Registers that are reused from call to call.
#[derive(Debug, Clone, Default)]
pub struct Workspace {
    registers: Vec<[f64; BLOCK]>,
}

/// Instructions with registers assigned: a register is free again after the last use of its value.
#[derive(Debug, Clone)]
pub struct Program {
    constants: Vec<f64>,
    instructions: Vec<Instruction>,
    register_count: usize,
}

#[derive(Debug, Clone, Copy)]
enum Instruction {
    Load { input: u32, to: u32 },
    Add { a: u32, b: u32, to: u32 },
    Subtract { a: u32, b: u32, to: u32 },
    Multiply { a: u32, b: u32, to: u32 },
    Divide { a: u32, b: u32, to: u32 },
    Negate { a: u32, to: u32 },
    SquareRoot { a: u32, to: u32 },
    Store { from: u32, output: u32 },
}

impl Program {
    /// Assigns registers to operations that stand in evaluation order.
    pub fn new(operations: &[Operation], outputs: &[Node]) -> Self {
        let mut assignment = Assignment::new(operations, outputs);
        for (node, &operation) in operations.iter().enumerate() {
            assignment.emit(node, operation);
        }
        Self {
            constants: assignment.constants,
            instructions: assignment.instructions,
            register_count: assignment.register_count as usize,
        }
    }

    /// Runs all instructions for every block of points.
    pub fn run(&self, instructions: Instructions, inputs: &Batch, outputs: &mut Batch, workspace: &mut Workspace) {
        let registers = &mut workspace.registers;
        registers.clear();
        registers.extend(self.constants.iter().map(|&constant| [constant; BLOCK]));
        registers.resize(self.register_count, [0.0; BLOCK]);
        instructions.0.dispatch(|| {
            for block in 0..inputs.blocks() {
                self.run_block(block, inputs, outputs, registers);
            }
        });
    }

    #[inline(always)]
    fn run_block(&self, block: usize, inputs: &Batch, outputs: &mut Batch, registers: &mut [[f64; BLOCK]]) {
        for &instruction in &self.instructions {
            match instruction {
                Instruction::Load { input, to } => registers[to as usize] = *inputs.block(input as usize, block),
                Instruction::Add { a, b, to } => binary(registers, a, b, to, |x, y| x + y),
                Instruction::Subtract { a, b, to } => binary(registers, a, b, to, |x, y| x - y),
                Instruction::Multiply { a, b, to } => binary(registers, a, b, to, |x, y| x * y),
                Instruction::Divide { a, b, to } => binary(registers, a, b, to, |x, y| x / y),
                Instruction::Negate { a, to } => unary(registers, a, to, |x| -x),
                Instruction::SquareRoot { a, to } => unary(registers, a, to, f64::sqrt),
                Instruction::Store { from, output } => {
                    *outputs.block_mut(output as usize, block) = registers[from as usize];
                }
            }
        }
    }
}

#[inline(always)]
fn binary(registers: &mut [[f64; BLOCK]], a: u32, b: u32, to: u32, operation: impl Fn(f64, f64) -> f64) {
    let (left, right) = (registers[a as usize], registers[b as usize]);
    let result = &mut registers[to as usize];
    for point in 0..BLOCK {
        result[point] = operation(left[point], right[point]);
    }
}

#[inline(always)]
fn unary(registers: &mut [[f64; BLOCK]], a: u32, to: u32, operation: impl Fn(f64) -> f64) {
    let argument = registers[a as usize];
    let result = &mut registers[to as usize];
    for point in 0..BLOCK {
        result[point] = operation(argument[point]);
    }
}

/// Registers being assigned to nodes in evaluation order. Constants keep theirs, the first ones, for the whole run.
struct Assignment {
    constants: Vec<f64>,
    instructions: Vec<Instruction>,
    register_count: u32,
    registers: Vec<u32>,
    free: Vec<u32>,
    uses: Vec<u32>,
    /// Outputs that each node is stored to.
    stores: Vec<Vec<u32>>,
}

impl Assignment {
    fn new(operations: &[Operation], outputs: &[Node]) -> Self {
        let mut uses = vec![0; operations.len()];
        operations.iter().flat_map(|operation| operation.operands()).for_each(|operand| uses[operand as usize] += 1);
        let mut stores = vec![Vec::new(); operations.len()];
        for (output, &node) in outputs.iter().enumerate() {
            stores[node as usize].push(output as u32);
        }
        let mut registers = vec![u32::MAX; operations.len()];
        let mut constants = Vec::new();
        for (node, operation) in operations.iter().enumerate() {
            if let Operation::Constant(bits) = operation {
                registers[node] = constants.len() as u32;
                constants.push(f64::from_bits(*bits));
            }
        }
        let register_count = constants.len() as u32;
        Self { constants, instructions: Vec::new(), register_count, registers, free: Vec::new(), uses, stores }
    }

    fn emit(&mut self, node: usize, operation: Operation) {
        if !matches!(operation, Operation::Constant(_)) {
            let operands: Vec<Node> = operation.operands().collect();
            let sources: Vec<u32> = operands.iter().map(|&operand| self.registers[operand as usize]).collect();
            operands.iter().for_each(|&operand| self.release(operand as usize));
            let to = self.free.pop().unwrap_or_else(|| {
                self.register_count += 1;
                self.register_count - 1
            });
            self.registers[node] = to;
            self.instructions.push(instruction(operation, &sources, to));
        }
        let from = self.registers[node];
        for output in std::mem::take(&mut self.stores[node]) {
            self.instructions.push(Instruction::Store { from, output });
        }
        if self.uses[node] == 0 {
            self.reclaim(node);
        }
    }

    /// One use of a node is done.
    fn release(&mut self, node: usize) {
        self.uses[node] -= 1;
        if self.uses[node] == 0 {
            self.reclaim(node);
        }
    }

    fn reclaim(&mut self, node: usize) {
        if self.registers[node] as usize >= self.constants.len() {
            self.free.push(self.registers[node]);
        }
    }
}

fn instruction(operation: Operation, sources: &[u32], to: u32) -> Instruction {
    match operation {
        Operation::Constant(_) => unreachable!("constants are preset"),
        Operation::Input(input) => Instruction::Load { input, to },
        Operation::Add(..) => Instruction::Add { a: sources[0], b: sources[1], to },
        Operation::Subtract(..) => Instruction::Subtract { a: sources[0], b: sources[1], to },
        Operation::Multiply(..) => Instruction::Multiply { a: sources[0], b: sources[1], to },
        Operation::Divide(..) => Instruction::Divide { a: sources[0], b: sources[1], to },
        Operation::Negate(_) => Instruction::Negate { a: sources[0], to },
        Operation::SquareRoot(_) => Instruction::SquareRoot { a: sources[0], to },
    }
}
