//! What the parts of the model have in common that add to the constraints of every time step.

use autodiff::Tape;
use kkt::{Class, Owner};
use nlp::Bounds;

use crate::layout::Layout;

/// A part of the model that adds to the constraints of every time step: kinematics, dynamics, limits, contact.
///
/// A term declares the variables and rows that it brings, and a tape with what stands behind its inputs and outputs.
/// Everything else follows from this: indices ([`Layout`]), bounds, the labels of the linear solver, values and
/// derivatives. Outputs are added to their rows, so that a term may add to rows of another one, and need not have any
/// of its own.
pub trait StepTerm: Send + Sync {
    /// Variables that the term brings to every stage.
    fn variables(&self) -> Vec<Block> {
        Vec::new()
    }

    /// Constraint rows that the term brings to every stage. Their bounds may depend on the smoothing.
    fn rows(&self) -> Vec<Block> {
        Vec::new()
    }

    /// Takes the smoothing parameter `sigma` of the complementarity conditions.
    fn set_sigma(&mut self, _sigma: f64) {}

    /// Where the tape is evaluated.
    fn points(&self) -> Points;

    /// The equations. Inputs that are constant at every point come last: the tape is not differentiated by them.
    fn tape(&self) -> Tape;

    /// What stands behind an input at a point.
    fn source(&self, input: usize, point: &Point, layout: &Layout) -> Source;

    /// The constraint row that an output is added to at a point.
    fn row(&self, output: usize, point: &Point, layout: &Layout) -> usize;
}

/// Variables or constraint rows that a term brings to every stage of the trajectories `owners`.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// Name by which the [`Layout`] finds it.
    pub name: &'static str,
    /// Trajectories that have it.
    pub owners: Owners,
    /// What its members are in a KKT matrix: of rows, the class of their multipliers. A row whose bounds are equal is
    /// an equality, any other has the class [`Class::InequalityMultiplier`].
    pub class: Class,
    /// Whether its members belong to the contact pairs: equally many to each, those of a pair side by side.
    pub per_pair: bool,
    /// Lower and upper bound of each member.
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

/// Where a tape is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Points {
    /// At every stage of these trajectories.
    Stages(Owners),
    /// At every stage of every scenario, for every contact pair.
    Pairs,
}

/// A point at which a tape is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Point {
    /// Stage, 1 to `N`. The step that leads to it begins at the stage before.
    pub stage: usize,
    /// Trajectory.
    pub owner: Owner,
    /// Contact pair, 0 unless the points are [`Points::Pairs`].
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

/// What stands behind an input of a tape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Source {
    /// A decision variable.
    Variable(usize),
    /// A value that does not change.
    Constant(f64),
    /// A component of the contact information `W = (Phi_tau, n~_tau)` of the point's pair at the pose before the step.
    /// An input has it at all points or at none, and the points are [`Points::Pairs`].
    Contact(usize),
}
