//! Replaces `slot` for an Ipopt in which no linear solver can be registered; nothing ever runs in it.

use std::any::Any;
use std::time::Duration;

use crate::kkt_solver::KktSolver;

/// The solver of one solve.
pub struct Slot<'solver> {
    _solver: &'solver mut dyn KktSolver,
    /// Wall time in the solver.
    pub elapsed: Duration,
    /// The reason why the solver cannot be used.
    pub refusal: Option<String>,
    /// A panic to be resumed when Ipopt has returned.
    pub panic: Option<Box<dyn Any + Send>>,
}

impl<'solver> Slot<'solver> {
    /// A slot for a solver.
    pub fn new(solver: &'solver mut dyn KktSolver) -> Self {
        Self { _solver: solver, elapsed: Duration::ZERO, refusal: None, panic: None }
    }

    /// Runs Ipopt without it.
    pub fn run<T>(&mut self, solve: impl FnOnce() -> T) -> T {
        solve()
    }
}
