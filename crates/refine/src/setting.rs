//! The setting of a refinement.

use plan::{Problem, RobustnessTarget, Session};
use simulation::Evaluator;

/// The constant data of a refinement: the problem, its requirements, and its evaluators.
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
