//! What a refinement is about.

use plan::{Problem, RobustnessTarget, Session};
use simulation::Evaluator;

/// What stays the same during a refinement: whose plan it is, what it must tolerate, and what plays references.
#[derive(Clone, Copy)]
pub struct Setting<'run> {
    pub problem: &'run Problem,
    pub target: &'run RobustnessTarget,
    pub session: &'run Session<'run>,
    /// Plays evaluations.
    pub evaluator: &'run Evaluator,
    /// Plays the training set.
    pub trainer: &'run Evaluator,
}
