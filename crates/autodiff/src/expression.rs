//! Ordinary Rust arithmetic that records what it does.

use std::cell::RefCell;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::graph::{Graph, Node};

/// A number that is not known yet: an input or something computed from inputs.
#[derive(Clone, Copy)]
pub struct Expression<'tape> {
    graph: &'tape RefCell<Graph>,
    node: Node,
}

impl<'tape> Expression<'tape> {
    pub(crate) fn input(graph: &'tape RefCell<Graph>, index: usize) -> Self {
        let node = graph.borrow_mut().input(index);
        Self { graph, node }
    }

    pub(crate) fn node(&self) -> Node {
        self.node
    }

    /// Square root.
    pub fn sqrt(self) -> Self {
        self.record(|graph| graph.square_root(self.node))
    }

    /// The expression times itself.
    pub fn square(self) -> Self {
        self * self
    }

    /// A number as an expression of the same tape.
    pub fn constant(self, value: f64) -> Self {
        self.record(|graph| graph.constant(value))
    }

    fn record(self, operation: impl FnOnce(&mut Graph) -> Node) -> Self {
        let node = operation(&mut self.graph.borrow_mut());
        Self { graph: self.graph, node }
    }
}

macro_rules! binary_operator {
    ($operator:ident, $method:ident, $record:ident) => {
        impl<'tape> $operator for Expression<'tape> {
            type Output = Self;
            fn $method(self, other: Self) -> Self {
                self.record(|graph| graph.$record(self.node, other.node))
            }
        }

        impl<'tape> $operator<f64> for Expression<'tape> {
            type Output = Self;
            fn $method(self, other: f64) -> Self {
                self.$method(self.constant(other))
            }
        }

        impl<'tape> $operator<Expression<'tape>> for f64 {
            type Output = Expression<'tape>;
            fn $method(self, other: Expression<'tape>) -> Expression<'tape> {
                other.constant(self).$method(other)
            }
        }
    };
}

binary_operator!(Add, add, add);
binary_operator!(Sub, sub, subtract);
binary_operator!(Mul, mul, multiply);
binary_operator!(Div, div, divide);

impl Neg for Expression<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        self.record(|graph| graph.negate(self.node))
    }
}
