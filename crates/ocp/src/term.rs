//! The interface of the parts of the model that add to the constraints of every time step.

use autodiff::Tape;
use kkt::{Class, Owner};
use nlp::Bounds;

use crate::layout::Layout;

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

/// Variables or constraint rows that a term adds to every stage of some trajectories.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// Name by which the [`Layout`] finds it.
    pub name: &'static str,
    /// The trajectories.
    pub owners: Owners,
    /// Class of the variables, or of the multipliers of the rows, in a KKT matrix. Inequalities have the class
    /// [`Class::InequalityMultiplier`]; rows of any other class are equalities, that is, their bounds are equal.
    pub class: Class,
    /// Whether the members belong to contact pairs: the same number to each pair, those of a pair consecutive.
    pub per_pair: bool,
    /// Lower and upper bound of each member; their number is the size of the block.
    pub bounds: Bounds,
}

/// Some of the trajectories.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Owners {
    /// The reference.
    Reference,
    /// The compliant trajectories, one per scenario.
    Scenarios,
    /// The reference and the compliant trajectories.
    All,
}

/// A set of points at which a tape is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Points {
    /// Every stage of these trajectories.
    Stages(Owners),
    /// Every contact pair at every stage of every scenario.
    Pairs,
}

/// A point at which a tape is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Point {
    /// Stage, 1 to `N`, at the end of the step.
    pub stage: usize,
    /// Trajectory.
    pub owner: Owner,
    /// Contact pair; 0 unless the points are [`Points::Pairs`].
    pub pair: usize,
}

impl Point {
    /// The scenario, from 0.
    ///
    /// # Panics
    /// When the point belongs to the reference.
    pub fn scenario(&self) -> usize {
        match self.owner {
            Owner::Scenario(scenario) => scenario,
            Owner::Reference => panic!("the reference is no scenario"),
        }
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
