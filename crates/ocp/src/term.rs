//! The interface of the parts of the model that add to the constraints of every time step.

use autodiff::Tape;

use crate::block::{Block, Blocks};
use crate::layout::Layout;
use crate::point::{Point, Points};

/// A part of the model that adds to the constraints of every time step: kinematics, dynamics, limits, contact.
///
/// A term declares its variables and rows, and a tape with the sources of its inputs and the rows of its outputs.
/// Everything else follows from that: indices ([`Layout`]), bounds, the labels of the linear solver, values and
/// derivatives. Outputs are added to their rows, so that a term may add to the rows of another term and need not have
/// rows of its own.
pub trait StepTerm: Send + Sync {
    /// Variables that the term adds to every stage.
    fn variables(&self) -> Vec<Block> {
        Vec::new()
    }

    /// Constraint rows that the term adds to every stage. Their bounds may depend on `sigma`.
    fn rows(&self) -> Vec<Block> {
        Vec::new()
    }

    /// Takes the smoothing parameter `sigma` of the complementarity conditions.
    fn set_sigma(&mut self, _sigma: f64) {}

    /// The points at which the tape is evaluated.
    fn points(&self) -> Points;

    /// The equations. Inputs that are constants or the smoothing at every point come last; the tape is not differentiated
    /// by them.
    fn tape(&self) -> Tape;

    /// The source of an input at a point.
    fn source(&self, input: usize, point: &Point, layout: &Layout) -> Source;

    /// The constraint row that an output at a point is added to.
    fn row(&self, output: usize, point: &Point, layout: &Layout) -> usize;
}

/// The blocks that some terms declare, in their order.
pub fn blocks(terms: &[Box<dyn StepTerm>]) -> Blocks {
    Blocks {
        variables: terms.iter().flat_map(|term| term.variables()).collect(),
        rows: terms.iter().flat_map(|term| term.rows()).collect(),
    }
}

/// Source of an input of a tape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Source {
    /// A decision variable.
    Variable(usize),
    /// A value that does not change.
    Constant(f64),
    /// The smoothing parameter `tau` of the distances (N m). It must be the source of the input at all points.
    Smoothing,
    /// A component of the contact information `W = (Phi_tau, n~_tau, p)` of the point's pair at the pose before the step.
    /// It must be the source of the input at all points, and the points must be [`Points::Pairs`].
    Contact(usize),
}
