//! Reverse-mode differentiation of a graph into itself.

use crate::graph::{Graph, Node, Operation};

/// Adds the derivatives of `sum seed * node` by the first `variables` inputs to the graph; `None` where the derivative
/// is zero for every input value.
pub fn gradient(graph: &mut Graph, seeds: &[(Node, Node)], variables: usize) -> Vec<Option<Node>> {
    let last = seeds.iter().map(|&(node, _)| node as usize + 1).max().unwrap_or(0);
    let mut adjoints: Vec<Option<Node>> = vec![None; last];
    for &(node, seed) in seeds {
        accumulate(graph, &mut adjoints, node, seed);
    }
    let mut gradient = vec![None; variables];
    for node in (0..last).rev() {
        let Some(adjoint) = adjoints[node] else { continue };
        match graph.operations()[node] {
            Operation::Input(index) if (index as usize) < variables => {
                gradient[index as usize] = Some(adjoint).filter(|&adjoint| graph.value(adjoint) != Some(0.0));
            }
            operation => propagate(graph, &mut adjoints, node as Node, operation, adjoint),
        }
    }
    gradient
}

/// Adds a node's adjoint times its partial derivatives to the adjoints of its operands.
fn propagate(graph: &mut Graph, adjoints: &mut [Option<Node>], node: Node, operation: Operation, adjoint: Node) {
    match operation {
        Operation::Constant(_) | Operation::Input(_) => {}
        Operation::Add(a, b) => {
            accumulate(graph, adjoints, a, adjoint);
            accumulate(graph, adjoints, b, adjoint);
        }
        Operation::Subtract(a, b) => {
            accumulate(graph, adjoints, a, adjoint);
            let negative = graph.negate(adjoint);
            accumulate(graph, adjoints, b, negative);
        }
        Operation::Multiply(a, b) => {
            let by_a = graph.multiply(adjoint, b);
            accumulate(graph, adjoints, a, by_a);
            let by_b = graph.multiply(adjoint, a);
            accumulate(graph, adjoints, b, by_b);
        }
        Operation::Divide(a, b) => {
            let by_a = graph.divide(adjoint, b);
            accumulate(graph, adjoints, a, by_a);
            let product = graph.multiply(by_a, node);
            let by_b = graph.negate(product);
            accumulate(graph, adjoints, b, by_b);
        }
        Operation::Negate(a) => {
            let negative = graph.negate(adjoint);
            accumulate(graph, adjoints, a, negative);
        }
        Operation::SquareRoot(a) => {
            let half = graph.constant(0.5);
            let scaled = graph.multiply(half, adjoint);
            let by_a = graph.divide(scaled, node);
            accumulate(graph, adjoints, a, by_a);
        }
    }
}

fn accumulate(graph: &mut Graph, adjoints: &mut [Option<Node>], node: Node, amount: Node) {
    if graph.value(node).is_some() {
        return;
    }
    let slot = &mut adjoints[node as usize];
    *slot = Some(slot.map_or(amount, |adjoint| graph.add(adjoint, amount)));
}
