//! Differentiation within a graph: derivatives are nodes that share subexpressions with the values.

use crate::graph::Graph;
use crate::operation::{Binary, Node, Operation, Unary};

/// Nonzero derivatives of one expression as pairs (input, derivative), ordered by input.
pub type Gradient = Vec<(usize, Node)>;

/// Reverse mode: derivatives of `sum seed * node` by the first `variables` inputs.
pub fn reverse(graph: &mut Graph, seeds: &[(Node, Node)], variables: usize) -> Gradient {
    let last = seeds.iter().map(|&(node, _)| node as usize + 1).max().unwrap_or(0);
    // Terms are added only when all are known, so that equal terms of opposite sign cancel.
    let mut terms: Vec<Vec<Node>> = vec![Vec::new(); last];
    seeds.iter().for_each(|&(node, seed)| terms[node as usize].push(seed));
    let mut gradient = Gradient::new();
    for node in (0..last).rev() {
        let adjoint = graph.sum(&terms[node]);
        if graph.is_zero(adjoint) {
            continue;
        }
        match graph.operations()[node] {
            Operation::Input(index) if (index as usize) < variables => gradient.push((index as usize, adjoint)),
            _ => {
                for (operand, partial) in partials(graph, node as Node) {
                    terms[operand as usize].push(graph.multiply(adjoint, partial));
                }
            }
        }
    }
    gradient.sort_unstable();
    gradient
}

/// Forward mode: derivatives of every one of `nodes` by the first `variables` inputs.
pub fn forward(graph: &mut Graph, nodes: &[Node], variables: usize) -> Vec<Gradient> {
    let needed = reachable(graph.operations(), nodes);
    let mut tangents: Vec<Gradient> = vec![Gradient::new(); needed.len()];
    for node in (0..needed.len()).filter(|&node| needed[node]) {
        tangents[node] = match graph.operations()[node] {
            Operation::Input(index) if (index as usize) < variables => vec![(index as usize, graph.constant(1.0))],
            _ => partials(graph, node as Node).into_iter().fold(Gradient::new(), |sum, (operand, partial)| {
                add_multiple(graph, sum, partial, &tangents[operand as usize])
            }),
        };
    }
    nodes.iter().map(|&node| tangents[node as usize].clone()).collect()
}

/// Marks the nodes that the given ones depend on.
pub fn reachable(operations: &[Operation], nodes: &[Node]) -> Vec<bool> {
    let mut needed = vec![false; operations.len()];
    nodes.iter().for_each(|&node| needed[node as usize] = true);
    // Operands have smaller indices than their users, so that one downward pass marks all of them.
    for node in (0..operations.len()).rev() {
        if needed[node] {
            operations[node].operands().for_each(|operand| needed[operand as usize] = true);
        }
    }
    needed
}

/// Nonconstant operands of a node, with the node's partial derivatives.
fn partials(graph: &mut Graph, node: Node) -> Vec<(Node, Node)> {
    let operation = graph.operations()[node as usize];
    let varies: Vec<bool> = operation.operands().map(|operand| graph.value(operand).is_none()).collect();
    let mut partials = Vec::with_capacity(2);
    match operation {
        Operation::Constant(_) | Operation::Input(_) => {}
        Operation::Unary(function, a) => partials.push((a, unary_partial(graph, function, a, node))),
        Operation::Binary(function, a, b) => {
            if varies[0] {
                let partial = match function {
                    Binary::Add | Binary::Subtract => graph.constant(1.0),
                    Binary::Multiply => b,
                    // Quotients with the same denominator share its reciprocal.
                    Binary::Divide => graph.reciprocal(b),
                };
                partials.push((a, partial));
            }
            if varies[1] {
                let partial = match function {
                    Binary::Add => graph.constant(1.0),
                    Binary::Subtract => graph.constant(-1.0),
                    Binary::Multiply => a,
                    Binary::Divide => {
                        let reciprocal = graph.reciprocal(b);
                        let product = graph.multiply(reciprocal, node);
                        graph.negate(product)
                    }
                };
                partials.push((b, partial));
            }
        }
    }
    partials
}

fn unary_partial(graph: &mut Graph, function: Unary, a: Node, node: Node) -> Node {
    match function {
        Unary::Negate => graph.constant(-1.0),
        Unary::SquareRoot => {
            let reciprocal = graph.reciprocal(node);
            graph.scale(0.5, reciprocal)
        }
        Unary::Sine => graph.unary(Unary::Cosine, a),
        Unary::Cosine => {
            let sine = graph.unary(Unary::Sine, a);
            graph.negate(sine)
        }
        Unary::Exponential => node,
        Unary::Logarithm => graph.reciprocal(a),
    }
}

/// `sum + factor * tangent` without zero entries.
fn add_multiple(graph: &mut Graph, sum: Gradient, factor: Node, tangent: &Gradient) -> Gradient {
    let mut result = Gradient::with_capacity(sum.len() + tangent.len());
    let mut sum = sum.into_iter().peekable();
    for &(input, derivative) in tangent {
        while let Some(before) = sum.next_if(|&(other, _)| other < input) {
            result.push(before);
        }
        let mut entry = graph.multiply(factor, derivative);
        if let Some((_, other)) = sum.next_if(|&(other, _)| other == input) {
            entry = graph.add(other, entry);
        }
        if !graph.is_zero(entry) {
            result.push((input, entry));
        }
    }
    result.extend(sum);
    result
}
