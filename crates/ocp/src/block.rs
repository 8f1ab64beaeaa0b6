//! Variables and constraint rows that the terms add to every stage.

use kkt::{Class, Owner};
use nlp::Bounds;

/// Variables of the states: pose (7).
pub const POSE_VARIABLES: &str = "pose";
/// Variables of the states: twist (6); it follows the pose.
pub const TWIST_VARIABLES: &str = "twist";

/// The blocks that the terms of a transcription declare.
#[derive(Debug, Clone, PartialEq)]
pub struct Blocks {
    /// Variables.
    pub variables: Vec<Block>,
    /// Constraint rows.
    pub rows: Vec<Block>,
}

/// Variables or constraint rows that a term adds to every stage of some trajectories.
#[derive(Debug, Clone, PartialEq)]
pub struct Block {
    /// Name by which the [`crate::Layout`] finds it.
    pub name: &'static str,
    /// The trajectories.
    pub owners: Owners,
    /// Class of the variables, or of the multipliers of the rows, in a KKT matrix. Inequalities have the class
    /// [`Class::InequalityMultiplier`]; rows of any other class are equalities, that is, their bounds are equal.
    pub class: Class,
    /// Whether the members belong to contact pairs: the same number to each pair, those of a pair consecutive. Bounds are then
    /// those of a pair.
    pub per_pair: bool,
    /// Lower and upper bound of each member; their number is the size of the block, or of its part for a pair.
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

impl Owners {
    /// Whether they include a trajectory.
    pub fn include(self, owner: Owner) -> bool {
        match self {
            Self::All => true,
            Self::Reference => owner == Owner::Reference,
            Self::Scenarios => owner != Owner::Reference,
        }
    }
}
