//! Functions recorded once and evaluated at many points.

use std::cell::RefCell;

use crate::batch::Batch;
use crate::differentiate::reachable;
use crate::expression::Expression;
use crate::graph::Graph;
use crate::operation::{Node, Operation};
use crate::program::{Instructions, Program, Workspace};

/// A function recorded once and evaluated at many points.
#[derive(Debug, Clone)]
pub struct Tape {
    input_count: usize,
    operations: Vec<Operation>,
    outputs: Vec<Node>,
    program: Program,
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
        Self::of_graph(inputs, &graph.borrow(), &outputs)
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
        self.operations.iter().filter(|operation| operation.is_arithmetic()).count()
    }

    /// Evaluates all outputs at all points. `inputs` may have more rows than the tape has inputs.
    ///
    /// # Panics
    /// When `inputs` or `outputs` have too few rows, or when their numbers of points differ.
    pub fn evaluate(&self, inputs: &Batch, outputs: &mut Batch, workspace: &mut Workspace) {
        self.evaluate_with(Instructions::best(), inputs, outputs, workspace);
    }

    /// [`Tape::evaluate`] with a given instruction set; all give bit-identical results.
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

    /// A tape of the nodes of a graph that the outputs depend on.
    pub(crate) fn of_graph(input_count: usize, graph: &Graph, outputs: &[Node]) -> Self {
        let all = graph.operations();
        let needed = reachable(all, outputs);
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

    /// Nodes in evaluation order.
    pub(crate) fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// Node of every output.
    pub(crate) fn outputs(&self) -> &[Node] {
        &self.outputs
    }
}
