//! Sparse derivatives of a tape, themselves evaluated by tapes.

use crate::differentiate::{Gradient, forward, reverse};
use crate::graph::Graph;
use crate::operation::Node;
use crate::tape::Tape;

/// Nonzero first derivatives of a tape's outputs.
///
/// A derivative is a nonzero unless it simplifies to the constant 0. Nonzeros are ordered by rows, then by columns.
#[derive(Debug, Clone)]
pub struct Jacobian {
    /// Output of every nonzero.
    pub rows: Vec<usize>,
    /// Input of every nonzero.
    pub columns: Vec<usize>,
    tape: Tape,
}

/// Nonzero second derivatives of `sum multiplier_i output_i`, lower triangle: `rows[k] >= columns[k]`.
///
/// Nonzeros are ordered by rows, then by columns.
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
    /// Derivatives by the first `variables` inputs; the other inputs are parameters.
    pub fn jacobian(&self, variables: usize) -> Jacobian {
        Jacobian::new(self, variables)
    }

    /// Second derivatives by the first `variables` inputs of the outputs weighted by multipliers, which become the last
    /// inputs of the derivative tapes.
    pub fn lagrangian_hessian(&self, variables: usize) -> LagrangianHessian {
        LagrangianHessian::new(self, variables)
    }
}

impl Jacobian {
    /// Evaluates the nonzeros; same inputs as the original tape.
    pub fn tape(&self) -> &Tape {
        &self.tape
    }

    /// Differentiates in both modes and keeps the cheaper tape.
    pub(crate) fn new(tape: &Tape, variables: usize) -> Self {
        let mut graph = Graph::from_operations(tape.operations());
        let one = graph.constant(1.0);
        let mut other_graph = graph.clone();
        let by_rows: Vec<Gradient> =
            tape.outputs().iter().map(|&output| reverse(&mut graph, &[(output, one)], variables)).collect();
        let by_columns = forward(&mut other_graph, tape.outputs(), variables);
        let (entries, tape) =
            cheaper(tape.input_count(), (&graph, entries(by_rows)), (&other_graph, entries(by_columns)));
        Self { rows: entries.rows, columns: entries.columns, tape }
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

    /// Differentiates the adjoint, which is reverse mode, in both modes and keeps the cheaper tape.
    pub(crate) fn new(tape: &Tape, variables: usize) -> Self {
        let input_count = tape.input_count() + tape.output_count();
        let mut graph = Graph::from_operations(tape.operations());
        let multipliers = tape.input_count()..input_count;
        let seeds: Vec<(Node, Node)> =
            tape.outputs().iter().zip(multipliers).map(|(&output, input)| (output, graph.input(input))).collect();
        let mut adjoints = vec![graph.constant(0.0); variables];
        for (input, adjoint) in reverse(&mut graph, &seeds, variables) {
            adjoints[input] = adjoint;
        }
        let one = graph.constant(1.0);
        let adjoint = Tape::of_graph(input_count, &graph, &adjoints);
        let mut other_graph = graph.clone();
        // By symmetry, a row ends at its diagonal.
        let by_rows: Vec<Gradient> = adjoints
            .iter()
            .enumerate()
            .map(|(row, &adjoint)| reverse(&mut graph, &[(adjoint, one)], row + 1))
            .collect();
        let mut by_columns = forward(&mut other_graph, &adjoints, variables);
        for (row, gradient) in by_columns.iter_mut().enumerate() {
            gradient.retain(|&(column, _)| column <= row);
        }
        let (entries, tape) = cheaper(input_count, (&graph, entries(by_rows)), (&other_graph, entries(by_columns)));
        Self { rows: entries.rows, columns: entries.columns, tape, adjoint }
    }
}

/// Nonzeros of a sparse matrix of nodes.
#[derive(Default)]
struct Entries {
    rows: Vec<usize>,
    columns: Vec<usize>,
    nodes: Vec<Node>,
}

fn entries(gradients: Vec<Gradient>) -> Entries {
    let mut entries = Entries::default();
    for (row, gradient) in gradients.into_iter().enumerate() {
        for (column, node) in gradient {
            entries.rows.push(row);
            entries.columns.push(column);
            entries.nodes.push(node);
        }
    }
    entries
}

/// The sparser of two results; if they are equally sparse, the one with fewer operations.
fn cheaper(inputs: usize, one: (&Graph, Entries), other: (&Graph, Entries)) -> (Entries, Tape) {
    [one, other]
        .map(|(graph, entries)| {
            let tape = Tape::of_graph(inputs, graph, &entries.nodes);
            (entries, tape)
        })
        .into_iter()
        .min_by_key(|(entries, tape)| (entries.nodes.len(), tape.operation_count()))
        .expect("there are two")
}
