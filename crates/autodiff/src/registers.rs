//! Register allocation: turns a graph in evaluation order into instructions on a small number of registers.

use crate::operation::{Binary, Node, Operation, Unary};

/// The function that an instruction computes. Products in sums are rounded like all others, without fused arithmetic,
/// so that every processor gives the same bits.
#[derive(Debug, Clone, Copy)]
pub enum Kernel {
    /// A function of one operand.
    Unary(Unary),
    /// A function of two operands.
    Binary(Binary),
    /// `a b + c`
    MultiplyAdd,
    /// `a b - c`
    MultiplySubtract,
    /// `c - a b`
    SubtractMultiply,
}

/// A kernel with its registers; unused operands repeat another one.
#[derive(Debug, Clone, Copy)]
pub struct Instruction {
    /// The kernel.
    pub kernel: Kernel,
    /// Registers that it reads.
    pub operands: [u32; 3],
    /// Register that it writes.
    pub to: u32,
}

/// Instructions, with the registers of constants, inputs and outputs.
#[derive(Debug, Clone, Default)]
pub struct Allocation {
    /// Constants, which the first registers hold throughout.
    pub constants: Vec<f64>,
    /// Inputs, each with the register that holds it at the start.
    pub loads: Vec<(u32, u32)>,
    /// Instructions in the order of execution.
    pub instructions: Vec<Instruction>,
    /// Register of every output at the end.
    pub stores: Vec<u32>,
    /// Number of registers.
    pub register_count: u32,
}

/// An instruction before registers are assigned.
struct Step {
    kernel: Kernel,
    operands: [Node; 3],
    operand_count: usize,
    node: Node,
}

impl Allocation {
    /// Allocates registers by linear scan: a register is free after the last use of its value.
    pub fn new(operations: &[Operation], outputs: &[Node]) -> Self {
        let steps = steps(operations, outputs);
        let mut uses = vec![0; operations.len()];
        for step in &steps {
            step.read().iter().for_each(|&operand| uses[operand as usize] += 1);
        }
        // Outputs are live until the end.
        outputs.iter().for_each(|&output| uses[output as usize] += 1);
        let mut allocation = Self::default();
        let mut registers = allocation.place_constants_and_inputs(operations);
        let mut free = Vec::new();
        for step in &steps {
            let operands = step.operands.map(|operand| registers[operand as usize]);
            for &operand in step.read() {
                uses[operand as usize] -= 1;
                let register = registers[operand as usize];
                if uses[operand as usize] == 0 && register as usize >= allocation.constants.len() {
                    free.push(register);
                }
            }
            let to = free.pop().unwrap_or_else(|| allocation.new_register());
            registers[step.node as usize] = to;
            allocation.instructions.push(Instruction { kernel: step.kernel, operands, to });
        }
        allocation.stores = outputs.iter().map(|&output| registers[output as usize]).collect();
        allocation
    }

    /// Assigns registers to constants and inputs; all other nodes have `u32::MAX`.
    fn place_constants_and_inputs(&mut self, operations: &[Operation]) -> Vec<u32> {
        let mut registers = vec![u32::MAX; operations.len()];
        for (node, operation) in operations.iter().enumerate() {
            if let Operation::Constant(bits) = operation {
                registers[node] = self.new_register();
                self.constants.push(f64::from_bits(*bits));
            }
        }
        for (node, operation) in operations.iter().enumerate() {
            if let Operation::Input(input) = operation {
                registers[node] = self.new_register();
                self.loads.push((*input, registers[node]));
            }
        }
        registers
    }

    fn new_register(&mut self) -> u32 {
        self.register_count += 1;
        self.register_count - 1
    }
}

impl Step {
    /// Nodes that it reads.
    fn read(&self) -> &[Node] {
        &self.operands[..self.operand_count]
    }

    fn new(kernel: Kernel, operands: &[Node], node: Node) -> Self {
        let all = std::array::from_fn(|index| operands[index.min(operands.len() - 1)]);
        Self { kernel, operands: all, operand_count: operands.len(), node }
    }
}

/// Arithmetic in evaluation order; a product that is used only in one sum is merged with it.
fn steps(operations: &[Operation], outputs: &[Node]) -> Vec<Step> {
    let mut uses = vec![0; operations.len()];
    operations.iter().flat_map(|operation| operation.operands()).for_each(|operand| uses[operand as usize] += 1);
    outputs.iter().for_each(|&output| uses[output as usize] += 1);
    let factors = |node: Node| match operations[node as usize] {
        Operation::Binary(Binary::Multiply, a, b) if uses[node as usize] == 1 => Some((a, b)),
        _ => None,
    };
    let mut absorbed = vec![false; operations.len()];
    let mut steps = Vec::new();
    // Backwards, because a sum determines which products are merged.
    for (node, &operation) in operations.iter().enumerate().rev() {
        if absorbed[node] {
            continue;
        }
        let name = node as Node;
        let mut with_product = |kernel, product: Node, (a, b): (Node, Node), c| {
            absorbed[product as usize] = true;
            steps.push(Step::new(kernel, &[a, b, c], name));
        };
        match operation {
            Operation::Constant(_) | Operation::Input(_) => {}
            Operation::Unary(function, a) => steps.push(Step::new(Kernel::Unary(function), &[a], name)),
            Operation::Binary(function, a, b) => match (function, factors(a), factors(b)) {
                (Binary::Add, Some(product), _) => with_product(Kernel::MultiplyAdd, a, product, b),
                (Binary::Add, None, Some(product)) => with_product(Kernel::MultiplyAdd, b, product, a),
                (Binary::Subtract, Some(product), _) => with_product(Kernel::MultiplySubtract, a, product, b),
                (Binary::Subtract, None, Some(product)) => with_product(Kernel::SubtractMultiply, b, product, a),
                _ => steps.push(Step::new(Kernel::Binary(function), &[a, b], name)),
            },
        }
    }
    steps.reverse();
    steps
}
