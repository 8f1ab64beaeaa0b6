//! Operations of the nodes of a graph.

/// Index of a node; operands come before the nodes that use them.
pub type Node = u32;

/// Functions of one argument.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Unary {
    /// `-a`
    Negate,
    /// Square root.
    SquareRoot,
    /// Sine, radians.
    Sine,
    /// Cosine, radians.
    Cosine,
    /// `e^a`
    Exponential,
    /// Natural logarithm.
    Logarithm,
}

/// Functions of two arguments.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Binary {
    /// `a + b`
    Add,
    /// `a - b`
    Subtract,
    /// `a b`
    Multiply,
    /// `a / b`
    Divide,
}

impl Unary {
    /// The function's value.
    pub fn apply(self, a: f64) -> f64 {
        match self {
            Self::Negate => -a,
            Self::SquareRoot => a.sqrt(),
            Self::Sine => a.sin(),
            Self::Cosine => a.cos(),
            Self::Exponential => a.exp(),
            Self::Logarithm => a.ln(),
        }
    }
}

/// A node. Constants are stored as bits so that operations can be compared and hashed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Operation {
    /// A constant, by its bits.
    Constant(u64),
    /// The value of an input.
    Input(u32),
    /// A function of one node.
    Unary(Unary, Node),
    /// A function of two nodes.
    Binary(Binary, Node, Node),
}

impl Operation {
    /// The nodes it reads.
    pub fn operands(self) -> impl Iterator<Item = Node> {
        let (first, second) = match self {
            Self::Constant(_) | Self::Input(_) => (None, None),
            Self::Unary(_, a) => (Some(a), None),
            Self::Binary(_, a, b) => (Some(a), Some(b)),
        };
        first.into_iter().chain(second)
    }

    /// The same operation with its operands renamed.
    pub fn renamed(self, name: impl Fn(Node) -> Node) -> Self {
        match self {
            Self::Constant(_) | Self::Input(_) => self,
            Self::Unary(function, a) => Self::Unary(function, name(a)),
            Self::Binary(function, a, b) => Self::Binary(function, name(a), name(b)),
        }
    }

    /// Whether it computes something at every point.
    pub fn is_arithmetic(self) -> bool {
        matches!(self, Self::Unary(..) | Self::Binary(..))
    }
}
