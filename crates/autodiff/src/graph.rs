//! Expressions as a directed acyclic graph in which equal subexpressions are the same node.

use std::collections::HashMap;

/// Index of a node; operands come before the nodes that use them.
pub type Node = u32;

/// What a node computes. Constants are kept as bits so that operations can be compared and hashed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Operation {
    /// A number, as its bits.
    Constant(u64),
    /// The value of an input.
    Input(u32),
    /// Sum.
    Add(Node, Node),
    /// Difference.
    Subtract(Node, Node),
    /// Product.
    Multiply(Node, Node),
    /// Quotient.
    Divide(Node, Node),
    /// Negation.
    Negate(Node),
    /// Square root.
    SquareRoot(Node),
}

impl Operation {
    /// The nodes it reads.
    pub fn operands(self) -> impl Iterator<Item = Node> {
        let (first, second) = match self {
            Self::Constant(_) | Self::Input(_) => (None, None),
            Self::Negate(a) | Self::SquareRoot(a) => (Some(a), None),
            Self::Add(a, b) | Self::Subtract(a, b) | Self::Multiply(a, b) | Self::Divide(a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second)
    }

    /// The same operation with its operands renamed.
    pub fn renamed(self, name: impl Fn(Node) -> Node) -> Self {
        match self {
            Self::Constant(_) | Self::Input(_) => self,
            Self::Add(a, b) => Self::Add(name(a), name(b)),
            Self::Subtract(a, b) => Self::Subtract(name(a), name(b)),
            Self::Multiply(a, b) => Self::Multiply(name(a), name(b)),
            Self::Divide(a, b) => Self::Divide(name(a), name(b)),
            Self::Negate(a) => Self::Negate(name(a)),
            Self::SquareRoot(a) => Self::SquareRoot(name(a)),
        }
    }
}

/// A growing graph with constant folding and the identities that keep derivatives sparse.
#[derive(Debug, Default)]
pub struct Graph {
    operations: Vec<Operation>,
    nodes: HashMap<Operation, Node>,
}

impl Graph {
    /// A graph that holds the given nodes under their own numbers.
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

    /// The node of a number; the two zeros are one.
    pub fn constant(&mut self, value: f64) -> Node {
        self.intern(Operation::Constant((value + 0.0).to_bits()))
    }

    /// The number a node stands for, if it is one.
    pub fn value(&self, node: Node) -> Option<f64> {
        match self.operations[node as usize] {
            Operation::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// `a + b`
    pub fn add(&mut self, a: Node, b: Node) -> Node {
        match (self.value(a), self.value(b), self.negated(a), self.negated(b)) {
            (Some(x), Some(y), ..) => self.constant(x + y),
            (Some(0.0), ..) => b,
            (_, Some(0.0), ..) => a,
            (.., Some(c)) => self.subtract(a, c),
            (_, _, Some(c), None) => self.subtract(b, c),
            _ => self.intern(Operation::Add(a.min(b), a.max(b))),
        }
    }

    /// `a - b`
    pub fn subtract(&mut self, a: Node, b: Node) -> Node {
        match (self.value(a), self.value(b), self.negated(b)) {
            _ if a == b => self.constant(0.0),
            (Some(x), Some(y), _) => self.constant(x - y),
            (_, Some(0.0), _) => a,
            (Some(0.0), ..) => self.negate(b),
            (.., Some(c)) => self.add(a, c),
            _ => self.intern(Operation::Subtract(a, b)),
        }
    }

    /// `a b`
    pub fn multiply(&mut self, a: Node, b: Node) -> Node {
        match (self.value(a), self.value(b), self.negated(a), self.negated(b)) {
            (Some(x), Some(y), ..) => self.constant(x * y),
            (Some(0.0), ..) | (_, Some(0.0), ..) => self.constant(0.0),
            (Some(1.0), ..) => b,
            (_, Some(1.0), ..) => a,
            (Some(-1.0), ..) => self.negate(b),
            (_, Some(-1.0), ..) => self.negate(a),
            (Some(x), _, _, Some(c)) => self.scale(-x, c),
            (_, Some(y), Some(c), _) => self.scale(-y, c),
            (_, _, Some(c), Some(d)) => self.multiply(c, d),
            (_, _, Some(c), None) => self.negated_product(c, b),
            (_, _, None, Some(d)) => self.negated_product(a, d),
            _ => self.intern(Operation::Multiply(a.min(b), a.max(b))),
        }
    }

    /// `a / b`
    pub fn divide(&mut self, a: Node, b: Node) -> Node {
        match (self.value(a), self.value(b)) {
            (Some(x), Some(y)) => self.constant(x / y),
            (Some(0.0), _) => self.constant(0.0),
            (_, Some(1.0)) => a,
            _ => self.intern(Operation::Divide(a, b)),
        }
    }

    /// `-a`
    pub fn negate(&mut self, a: Node) -> Node {
        match (self.value(a), self.negated(a), self.operations[a as usize]) {
            (Some(x), ..) => self.constant(-x),
            (_, Some(c), _) => c,
            (.., Operation::Subtract(c, d)) => self.subtract(d, c),
            _ => self.intern(Operation::Negate(a)),
        }
    }

    /// The square root of `a`
    pub fn square_root(&mut self, a: Node) -> Node {
        match self.value(a) {
            Some(x) => self.constant(x.sqrt()),
            None => self.intern(Operation::SquareRoot(a)),
        }
    }

    fn scale(&mut self, factor: f64, a: Node) -> Node {
        let factor = self.constant(factor);
        self.multiply(factor, a)
    }

    fn negated_product(&mut self, a: Node, b: Node) -> Node {
        let product = self.multiply(a, b);
        self.negate(product)
    }

    /// The operand when a node is a negation.
    fn negated(&self, node: Node) -> Option<Node> {
        match self.operations[node as usize] {
            Operation::Negate(a) => Some(a),
            _ => None,
        }
    }

    fn intern(&mut self, operation: Operation) -> Node {
        *self.nodes.entry(operation).or_insert_with(|| {
            self.operations.push(operation);
            (self.operations.len() - 1) as Node
        })
    }
}
