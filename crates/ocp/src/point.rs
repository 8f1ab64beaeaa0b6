//! Points at which the tapes of the terms are evaluated.

use kkt::Owner;

use crate::block::Owners;

/// A set of points at which a tape is evaluated.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Points {
    /// Every stage of these trajectories.
    Stages(Owners),
    /// Every contact: the pairs that have one, at every stage of every scenario.
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
    /// Number of the pair among those with a contact there; 0 unless the points are [`Points::Pairs`].
    pub slot: usize,
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
