//! Rust arithmetic that records its operations.

use std::cell::RefCell;
use std::ops::{Add, AddAssign, Div, DivAssign, Mul, MulAssign, Neg, Sub, SubAssign};

use crate::graph::Graph;
use crate::operation::{Node, Unary};

/// A symbolic value: an input or an expression of inputs.
///
/// The lifetime keeps the expressions of different tapes apart:
/// ```compile_fail
/// # use autodiff::Tape;
/// Tape::record(1, |outer| {
///     Tape::record(1, |inner| vec![inner[0] * outer[0]]);
///     Vec::new()
/// });
/// ```
#[derive(Clone, Copy, Debug)]
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
        self.unary(Unary::SquareRoot)
    }

    /// Sine, in radians.
    pub fn sin(self) -> Self {
        self.unary(Unary::Sine)
    }

    /// Cosine, in radians.
    pub fn cos(self) -> Self {
        self.unary(Unary::Cosine)
    }

    /// Exponential function.
    pub fn exp(self) -> Self {
        self.unary(Unary::Exponential)
    }

    /// Natural logarithm.
    pub fn ln(self) -> Self {
        self.unary(Unary::Logarithm)
    }

    /// One divided by the expression.
    pub fn recip(self) -> Self {
        self.record(|graph| graph.reciprocal(self.node))
    }

    /// The expression times itself.
    pub fn square(self) -> Self {
        self * self
    }

    /// An integer power, by repeated squaring; the power 0 is the constant 1.
    pub fn powi(self, exponent: i32) -> Self {
        let mut power = self.constant(1.0);
        for bit in (0..u32::BITS - exponent.unsigned_abs().leading_zeros()).rev() {
            power = power.square();
            if exponent.unsigned_abs() >> bit & 1 == 1 {
                power *= self;
            }
        }
        if exponent < 0 { power.recip() } else { power }
    }

    /// A constant as an expression of the same tape.
    pub fn constant(self, value: f64) -> Self {
        self.record(|graph| graph.constant(value))
    }

    fn unary(self, function: Unary) -> Self {
        self.record(|graph| graph.unary(function, self.node))
    }

    fn record(self, operation: impl FnOnce(&mut Graph) -> Node) -> Self {
        let node = operation(&mut self.graph.borrow_mut());
        Self { graph: self.graph, node }
    }
}

macro_rules! binary_operator {
    ($operator:ident, $method:ident, $assign:ident, $assign_method:ident, $record:ident) => {
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

        impl<'tape, T> $assign<T> for Expression<'tape>
        where
            Self: $operator<T, Output = Self>,
        {
            fn $assign_method(&mut self, other: T) {
                *self = self.$method(other);
            }
        }
    };
}

binary_operator!(Add, add, AddAssign, add_assign, add);
binary_operator!(Sub, sub, SubAssign, sub_assign, subtract);
binary_operator!(Mul, mul, MulAssign, mul_assign, multiply);
binary_operator!(Div, div, DivAssign, div_assign, divide);

impl Neg for Expression<'_> {
    type Output = Self;
    fn neg(self) -> Self {
        self.record(|graph| graph.negate(self.node))
    }
}
