//! Solution of a problem by Ipopt.

use std::panic::resume_unwind;
use std::path::Path;
use std::sync::{PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard};
use std::time::Instant;

use crate::callbacks::Session;
use crate::error::SolveError;
use crate::handle::{Handle, Outcome};
use crate::kkt_solver::LinearSystemSolver;
use crate::linear_solver;
use crate::options::Options;
use crate::problem::{Bounds, Problem};
use crate::slot::{self, Slot};
use crate::solution::{Control, Progress, Solution, Start, Timing};
use crate::statistics;

/// Sequential MUMPS keeps global state, so that two simultaneous solves corrupt memory. HSL's MA57 and the caller's
/// solver are called through the same global function pointers. Solves with solvers of the caller share the lock.
static LINEAR_SOLVERS: RwLock<()> = RwLock::new(());

/// Keeps apart solves that must not run simultaneously.
enum Turn {
    Shared { _guard: RwLockReadGuard<'static, ()> },
    Alone { _guard: RwLockWriteGuard<'static, ()> },
}

/// Solves `problem` from `start`. `observer` sees every iteration and may stop the solve. Solves with a linear solver
/// of the caller can run in several threads simultaneously; those with Ipopt's own solvers wait for all others.
///
/// # Errors
/// When the problem, an option or the linear solver is rejected. The outcome of a solve is the solution's status.
///
/// # Panics
/// When a function of the problem, the linear solver or the observer panics.
pub fn solve(
    problem: &mut dyn Problem,
    start: &Start,
    options: &Options,
    linear_solver: LinearSystemSolver,
    observer: &mut dyn FnMut(&Progress) -> Control,
) -> Result<Solution, SolveError> {
    let begin = Instant::now();
    let mut solver = SolverInUse::new(linear_solver)?;
    let statistics_file = tempfile::NamedTempFile::new().ok();
    let handle = Handle::create(problem)?;
    let mut all = Options::defaults(start, solver.option());
    if solver.own.is_some() {
        // Ipopt takes it for MA57 and would scale with MC19 if HSL is installed; results must not depend on that.
        all.set("linear_system_scaling", "none");
    }
    if let Some(file) = &statistics_file {
        all.set("output_file", &*file.path().to_string_lossy());
        all.set("file_print_level", 3);
        all.set("print_timing_statistics", "yes");
    }
    all.extend(options);
    handle.set_options(&all)?;

    let mut iterate = handle.starting_iterate(start)?;
    let variable_bounds = problem.variable_bounds();
    let constraint_bounds = problem.constraint_bounds();
    let patterns = (problem.jacobian_pattern(), problem.hessian_pattern());
    let mut session = Session::new(problem, observer, patterns.0, patterns.1);
    let outcome = solver.run(|| handle.solve(&mut iterate, &mut session))?;
    if let Some(panic) = session.panic {
        resume_unwind(panic);
    }
    let iterations = session.log.last().map_or(0, |last| last.iteration);
    if iterations > 0 {
        solver.require_that_it_ran()?;
    }
    let timing = Timing {
        total: begin.elapsed().as_secs_f64(),
        evaluation: session.evaluation.as_secs_f64(),
        linear_solver: solver.seconds(statistics_file.as_ref().map(|file| file.path())),
    };
    Ok(Solution {
        status: outcome.status,
        objective: outcome.objective,
        constraint_violation: violation(&iterate.x, &variable_bounds)
            .max(violation(&outcome.constraints, &constraint_bounds)),
        constraints: outcome.constraints,
        iterate,
        iterations,
        log: session.log,
        timing,
        linear_solver: solver.name,
        evaluation_error: session.evaluation_error,
    })
}

/// Checks that Ipopt takes some options and can run a linear solver of its own, before anything is solved.
///
/// # Errors
/// When it refuses an option, or the linear solver cannot run.
pub fn check(options: &Options, linear_solver: Option<&str>) -> Result<(), SolveError> {
    if let Some(name) = linear_solver {
        let _solver = SolverInUse::new(LinearSystemSolver::Named(name))?;
    }
    Handle::probe()?.set_options(options)
}

/// The linear solver of a running solve.
struct SolverInUse<'solver> {
    name: String,
    own: Option<Slot<'solver>>,
    _turn: Turn,
}

impl<'solver> SolverInUse<'solver> {
    /// Waits until the solver may run and checks that it can.
    fn new(linear_solver: LinearSystemSolver<'solver>) -> Result<Self, SolveError> {
        match linear_solver {
            LinearSystemSolver::Named(name) => {
                let turn = Turn::Alone { _guard: LINEAR_SOLVERS.write().unwrap_or_else(PoisonError::into_inner) };
                linear_solver::require(name)?;
                Ok(Self { name: name.to_owned(), own: None, _turn: turn })
            }
            LinearSystemSolver::Own(solver) => {
                let turn = Turn::Shared { _guard: LINEAR_SOLVERS.read().unwrap_or_else(PoisonError::into_inner) };
                linear_solver::require_own(solver.name())?;
                Ok(Self { name: solver.name().to_owned(), own: Some(Slot::new(solver)), _turn: turn })
            }
        }
    }

    /// Its name among Ipopt's options.
    fn option(&self) -> &str {
        if self.own.is_some() { slot::NAME } else { &self.name }
    }

    fn run(&mut self, solve: impl FnOnce() -> Outcome) -> Result<Outcome, SolveError> {
        let Some(slot) = &mut self.own else { return Ok(solve()) };
        let outcome = slot.run(solve);
        if let Some(panic) = slot.panic.take() {
            resume_unwind(panic);
        }
        match slot.refusal.take() {
            Some(reason) => Err(SolveError::LinearSolver { name: self.name.clone(), reason }),
            None => Ok(outcome),
        }
    }

    /// An Ipopt before 3.14 that is linked with HSL calls its own MA57 whatever is registered.
    fn require_that_it_ran(&self) -> Result<(), SolveError> {
        if self.own.as_ref().is_none_or(|slot| slot.was_called) {
            return Ok(());
        }
        let reason = "this Ipopt was linked with HSL and runs MA57 instead; use one that was not, or choose \"ma57\"";
        Err(SolveError::LinearSolver { name: self.name.clone(), reason: reason.to_owned() })
    }

    /// Wall seconds in factorisations and solves: measured, or read from Ipopt's statistics.
    fn seconds(&self, statistics: Option<&Path>) -> f64 {
        match &self.own {
            Some(slot) => slot.elapsed.as_secs_f64(),
            None => statistics.map_or(0.0, statistics::linear_solver_seconds),
        }
    }
}

fn violation(values: &[f64], bounds: &Bounds) -> f64 {
    let sides = values.iter().zip(bounds.lower.iter().zip(&bounds.upper));
    sides.map(|(value, (lower, upper))| (lower - value).max(value - upper)).fold(0.0, f64::max)
}
