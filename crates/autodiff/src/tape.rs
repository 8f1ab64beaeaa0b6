//! Tapes and their derivatives, which are tapes again.

use std::cell::RefCell;

use crate::batch::Batch;
use crate::differentiate::gradient;
use crate::expression::Expression;
use crate::graph::{Graph, Node, Operation};
use crate::program::{Instructions, Program, Workspace};

/// A function recorded once and evaluated at many points.
#[derive(Debug, Clone)]
pub struct Tape {
    input_count: usize,
    operations: Vec<Operation>,
    outputs: Vec<Node>,
    program: Program,
}

/// Nonzero first derivatives of a tape's outputs.
#[derive(Debug, Clone)]
pub struct Jacobian {
    /// Output of every nonzero.
    pub rows: Vec<usize>,
    /// Input of every nonzero.
    pub columns: Vec<usize>,
    tape: Tape,
}

/// Nonzero second derivatives of `sum multiplier_i output_i`, lower triangle.
#[derive(Debug, Clone)]
pub struct LagrangianHessian {
    /// Larger input of every nonzero.
    pub rows: Vec<usize>,
    /// Smaller input of every nonzero.
    pub columns: Vec<usize>,
    tape: Tape,
    adjoint: Tape,
}

impl Tape {
    /// Records `function` of `inputs` inputs.
    pub fn record(
        inputs: usize,
        function: impl for<'tape> FnOnce(&[Expression<'tape>]) -> Vec<Expression<'tape>>,
    ) -> Self {
        let graph = RefCell::new(Graph::default());
        let arguments: Vec<Expression> = (0..inputs).map(|index| Expression::input(&graph, index)).collect();
        let outputs: Vec<Node> = function(&arguments).iter().map(Expression::node).collect();
        drop(arguments);
        Self::new(inputs, &graph.borrow(), &outputs)
    }

    /// Number of inputs, parameters included.
    pub fn input_count(&self) -> usize {
        self.input_count
    }

    /// Number of outputs.
    pub fn output_count(&self) -> usize {
        self.outputs.len()
    }

    /// Number of arithmetic operations per point.
    pub fn operation_count(&self) -> usize {
        let free = |operation: &&Operation| !matches!(operation, Operation::Constant(_) | Operation::Input(_));
        self.operations.iter().filter(free).count()
    }

    /// Derivatives by the first `variables` inputs; the other inputs are parameters.
    pub fn jacobian(&self, variables: usize) -> Jacobian {
        let mut graph = Graph::from_operations(&self.operations);
        let one = graph.constant(1.0);
        let (mut rows, mut columns, mut nonzeros) = (Vec::new(), Vec::new(), Vec::new());
        for (row, &output) in self.outputs.iter().enumerate() {
            for (column, derivative) in gradient(&mut graph, &[(output, one)], variables).into_iter().enumerate() {
                if let Some(derivative) = derivative {
                    rows.push(row);
                    columns.push(column);
                    nonzeros.push(derivative);
                }
            }
        }
        Jacobian { rows, columns, tape: Self::new(self.input_count, &graph, &nonzeros) }
    }

    /// Second derivatives by the first `variables` inputs of the outputs weighted by multipliers, which become the last
    /// inputs of the derivative tapes.
    pub fn lagrangian_hessian(&self, variables: usize) -> LagrangianHessian {
        let mut graph = Graph::from_operations(&self.operations);
        let input_count = self.input_count + self.outputs.len();
        let seeds: Vec<(Node, Node)> =
            self.outputs.iter().zip(self.input_count..).map(|(&output, input)| (output, graph.input(input))).collect();
        let adjoints = gradient(&mut graph, &seeds, variables);
        let (zero, one) = (graph.constant(0.0), graph.constant(1.0));
        let (mut rows, mut columns, mut nonzeros) = (Vec::new(), Vec::new(), Vec::new());
        for (row, adjoint) in adjoints.iter().enumerate() {
            let Some(adjoint) = *adjoint else { continue };
            for (column, derivative) in gradient(&mut graph, &[(adjoint, one)], row + 1).into_iter().enumerate() {
                if let Some(derivative) = derivative {
                    rows.push(row);
                    columns.push(column);
                    nonzeros.push(derivative);
                }
            }
        }
        let adjoints: Vec<Node> = adjoints.into_iter().map(|adjoint| adjoint.unwrap_or(zero)).collect();
        LagrangianHessian {
            rows,
            columns,
            tape: Self::new(input_count, &graph, &nonzeros),
            adjoint: Self::new(input_count, &graph, &adjoints),
        }
    }

    /// Evaluates all outputs at all points. `inputs` may have more rows than the tape has inputs.
    ///
    /// # Panics
    /// When `inputs` or `outputs` has too few rows or their numbers of points differ.
    pub fn evaluate(&self, inputs: &Batch, outputs: &mut Batch, workspace: &mut Workspace) {
        self.evaluate_with(Instructions::best(), inputs, outputs, workspace);
    }

    /// [`Tape::evaluate`] with a given instruction set; the results are the same bits with each.
    ///
    /// # Panics
    /// As [`Tape::evaluate`].
    pub fn evaluate_with(
        &self,
        instructions: Instructions,
        inputs: &Batch,
        outputs: &mut Batch,
        workspace: &mut Workspace,
    ) {
        assert!(inputs.rows() >= self.input_count, "too few inputs");
        assert!(outputs.rows() >= self.outputs.len(), "too few outputs");
        assert_eq!(inputs.points(), outputs.points(), "different numbers of points");
        self.program.run(instructions, inputs, outputs, workspace);
    }

    /// A tape of what the outputs need of a graph.
    fn new(input_count: usize, graph: &Graph, outputs: &[Node]) -> Self {
        let all = graph.operations();
        let mut needed = vec![false; all.len()];
        outputs.iter().for_each(|&output| needed[output as usize] = true);
        // Operands have smaller numbers than their users, so that marking downwards reaches everything.
        for node in (0..all.len()).rev() {
            if needed[node] {
                all[node].operands().for_each(|operand| needed[operand as usize] = true);
            }
        }
        let mut names = vec![Node::MAX; all.len()];
        let mut operations = Vec::new();
        for node in (0..all.len()).filter(|&node| needed[node]) {
            names[node] = operations.len() as Node;
            operations.push(all[node].renamed(|operand| names[operand as usize]));
        }
        let outputs: Vec<Node> = outputs.iter().map(|&output| names[output as usize]).collect();
        let program = Program::new(&operations, &outputs);
        Self { input_count, operations, outputs, program }
    }
}

impl Jacobian {
    /// Evaluates the nonzeros.
    pub fn tape(&self) -> &Tape {
        &self.tape
    }
}

impl LagrangianHessian {
    /// Evaluates the nonzeros; inputs are those of the original tape, then one multiplier per output.
    pub fn tape(&self) -> &Tape {
        &self.tape
    }

    /// Evaluates the gradient of the weighted outputs by every differentiated input, zeros included; same inputs.
    pub fn adjoint(&self) -> &Tape {
        &self.adjoint
    }
}
