//! Expressions as a directed acyclic graph in which equal subexpressions share a node.

use std::collections::HashMap;

use crate::operation::{Binary, Node, Operation, Unary};

/// A graph that folds constants and applies the identities that keep derivatives sparse and short.
///
/// No identity changes how a result is rounded, except by overflow or underflow, so that values are those of the
/// recorded arithmetic. Only the sign of zero may change, and `0 x` is 0 for every `x`.
#[derive(Debug, Clone, Default)]
pub struct Graph {
    operations: Vec<Operation>,
    nodes: HashMap<Operation, Node>,
}

impl Graph {
    /// A graph of the given nodes, which keep their indices.
    pub fn from_operations(operations: &[Operation]) -> Self {
        let nodes = operations.iter().enumerate().map(|(node, &operation)| (operation, node as Node)).collect();
        Self { operations: operations.to_vec(), nodes }
    }

    /// All nodes, operands first.
    pub fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// The node of an input.
    pub fn input(&mut self, index: usize) -> Node {
        self.intern(Operation::Input(index as u32))
    }

    /// The node of a constant; 0 and -0 share one.
    pub fn constant(&mut self, value: f64) -> Node {
        self.intern(Operation::Constant((value + 0.0).to_bits()))
    }

    /// The value of a node, if it is a constant.
    pub fn value(&self, node: Node) -> Option<f64> {
        match self.operations[node as usize] {
            Operation::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// Whether a node is the constant zero.
    pub fn is_zero(&self, node: Node) -> bool {
        self.value(node) == Some(0.0)
    }

    /// `a + b`
    pub fn add(&mut self, a: Node, b: Node) -> Node {
        match (self.value(a), self.value(b), self.negated(a), self.negated(b)) {
            (Some(x), Some(y), ..) => self.constant(x + y),
            (Some(0.0), ..) => b,
            (_, Some(0.0), ..) => a,
            (.., Some(c)) => self.subtract(a, c),
            (_, _, Some(c), None) => self.subtract(b, c),
            _ if a == b => self.scale(2.0, a),
            _ => self.binary(Binary::Add, a.min(b), a.max(b)),
        }
    }

    /// `a - b`
    pub fn subtract(&mut self, a: Node, b: Node) -> Node {
        match (self.value(a), self.value(b), self.negated(a), self.negated(b)) {
            _ if a == b => self.constant(0.0),
            (Some(x), Some(y), ..) => self.constant(x - y),
            (_, Some(0.0), ..) => a,
            (Some(0.0), ..) => self.negate(b),
            (.., Some(c)) => self.add(a, c),
            (_, _, Some(c), None) => {
                let sum = self.add(c, b);
                self.negate(sum)
            }
            _ => self.binary(Binary::Subtract, a, b),
        }
    }

    /// `a b`
    pub fn multiply(&mut self, a: Node, b: Node) -> Node {
        match (self.value(a), self.value(b), self.negated(a), self.negated(b)) {
            (Some(x), Some(y), ..) => self.constant(x * y),
            (Some(x), ..) => self.scale(x, b),
            (_, Some(y), ..) => self.scale(y, a),
            (_, _, Some(c), Some(d)) => self.multiply(c, d),
            (_, _, Some(c), None) => self.negated_product(c, b),
            (_, _, None, Some(d)) => self.negated_product(a, d),
            _ => self.binary(Binary::Multiply, a.min(b), a.max(b)),
        }
    }

    /// `a / b`
    pub fn divide(&mut self, a: Node, b: Node) -> Node {
        match (self.value(a), self.value(b), self.negated(a), self.negated(b)) {
            (Some(x), Some(y), ..) => self.constant(x / y),
            (Some(0.0), ..) => self.constant(0.0),
            (_, Some(y), ..) if is_power_of_two(y) => self.scale(1.0 / y, a),
            (_, _, Some(c), _) => {
                let quotient = self.divide(c, b);
                self.negate(quotient)
            }
            (.., Some(d)) => {
                let quotient = self.divide(a, d);
                self.negate(quotient)
            }
            _ => self.binary(Binary::Divide, a, b),
        }
    }

    /// `1 / a`
    pub fn reciprocal(&mut self, a: Node) -> Node {
        let one = self.constant(1.0);
        self.divide(one, a)
    }

    /// `-a`
    pub fn negate(&mut self, a: Node) -> Node {
        match (self.negated(a), self.operations[a as usize]) {
            (Some(c), _) => c,
            (_, Operation::Binary(Binary::Subtract, c, d)) => self.subtract(d, c),
            _ => self.unary(Unary::Negate, a),
        }
    }

    /// A function of one node.
    pub fn unary(&mut self, function: Unary, a: Node) -> Node {
        match self.value(a) {
            Some(x) => self.constant(function.apply(x)),
            None => self.intern(Operation::Unary(function, a)),
        }
    }

    /// `factor a`
    pub fn scale(&mut self, factor: f64, a: Node) -> Node {
        if factor == 0.0 {
            return self.constant(0.0);
        }
        if factor == 1.0 {
            return a;
        }
        if factor == -1.0 {
            return self.negate(a);
        }
        match (self.negated(a), self.scaled(a)) {
            (Some(c), _) => self.scale(-factor, c),
            // One factor is a power of two, so that both products are rounded in the same way.
            (_, Some((inner, c))) if is_power_of_two(factor) || is_power_of_two(inner) => self.scale(factor * inner, c),
            _ => {
                let factor = self.constant(factor);
                if self.value(a).is_some() { self.multiply(factor, a) } else { self.product(factor, a) }
            }
        }
    }

    /// The sum of many terms, with multiples of the same node combined.
    pub fn sum(&mut self, terms: &[Node]) -> Node {
        if let &[term] = terms {
            return term;
        }
        let mut multiples: Vec<(f64, Node)> = Vec::with_capacity(terms.len());
        for &term in terms {
            let (factor, node) = self.factored(term);
            match multiples.iter_mut().find(|(_, other)| *other == node) {
                Some((sum, _)) => *sum += factor,
                None => multiples.push((factor, node)),
            }
        }
        let zero = self.constant(0.0);
        multiples.into_iter().fold(zero, |sum, (factor, node)| {
            let term = self.scale(factor, node);
            self.add(sum, term)
        })
    }

    /// A node as a factor times a node; the factor may be 1, and the node may be the constant 1.
    fn factored(&mut self, node: Node) -> (f64, Node) {
        if let Some(value) = self.value(node) {
            return (value, self.constant(1.0));
        }
        let (sign, positive) = self.negated(node).map_or((1.0, node), |positive| (-1.0, positive));
        self.scaled(positive).map_or((sign, positive), |(factor, inner)| (sign * factor, inner))
    }

    fn product(&mut self, a: Node, b: Node) -> Node {
        self.binary(Binary::Multiply, a.min(b), a.max(b))
    }

    fn negated_product(&mut self, a: Node, b: Node) -> Node {
        let product = self.multiply(a, b);
        self.negate(product)
    }

    /// The operand when a node is a negation.
    fn negated(&self, node: Node) -> Option<Node> {
        match self.operations[node as usize] {
            Operation::Unary(Unary::Negate, a) => Some(a),
            _ => None,
        }
    }

    /// Factor and operand when a node is a multiple of another.
    fn scaled(&self, node: Node) -> Option<(f64, Node)> {
        let Operation::Binary(Binary::Multiply, a, b) = self.operations[node as usize] else { return None };
        self.value(a).map(|factor| (factor, b)).or(self.value(b).map(|factor| (factor, a)))
    }

    fn binary(&mut self, function: Binary, a: Node, b: Node) -> Node {
        self.intern(Operation::Binary(function, a, b))
    }

    fn intern(&mut self, operation: Operation) -> Node {
        *self.nodes.entry(operation).or_insert_with(|| {
            self.operations.push(operation);
            (self.operations.len() - 1) as Node
        })
    }
}

/// Whether multiplication and division by a value are exact.
fn is_power_of_two(value: f64) -> bool {
    const FRACTION: u64 = (1 << 52) - 1;
    value.is_normal() && value.to_bits() & FRACTION == 0
}
