//! Rollouts that were made.

use std::fmt;

use simulation::{GraspError, Outcome};

use crate::plan::Plan;

/// What is played.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Motion {
    /// The reference after a homotopy iteration (counted from 1).
    Stage(usize),
    /// The plan's reference.
    Plan,
    /// Straight from start to goal, unplanned: what a plan has to beat.
    StraightPush,
}

impl fmt::Display for Motion {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        match self {
            Self::Stage(number) => formatter.pad(&format!("stage {number}")),
            Self::Plan => formatter.pad("plan"),
            Self::StraightPush => formatter.pad("straight push"),
        }
    }
}

/// One rollout and what it was.
pub struct Played<'plan> {
    pub plan: &'plan Plan,
    pub motion: Motion,
    pub friction: f64,
    /// Injected magnitude (m).
    pub magnitude: f64,
    /// Injected error of the grasp.
    pub grasp: GraspError,
    pub outcome: Outcome,
    pub success: bool,
}
