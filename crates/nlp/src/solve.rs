//! Solution of a problem by Ipopt.

#![allow(unsafe_code)]

use std::ffi::CString;
use std::panic::resume_unwind;
use std::path::Path;
use std::sync::{PoisonError, RwLock, RwLockReadGuard, RwLockWriteGuard};
use std::time::Instant;

use ipopt_sys as ipopt;

use crate::callbacks::{self, Session, Truth};
use crate::error::SolveError;
use crate::kkt_solver::LinearSystemSolver;
use crate::linear_solver;
use crate::options::{OptionValue, Options};
use crate::problem::{Bounds, Pattern, Problem};
use crate::slot::{self, Slot};
use crate::solution::{Control, Iterate, Progress, Solution, Start, Timing};
use crate::statistics;
use crate::status::SolveStatus;

/// Sequential MUMPS keeps global state, so that two simultaneous solves corrupt memory. HSL's MA57 and the caller's
/// solver are called through the same global function pointers. Solves with solvers of the caller share the lock.
static LINEAR_SOLVERS: RwLock<()> = RwLock::new(());

/// Keeps apart solves that must not run simultaneously.
enum Turn {
    Shared {
        _guard: RwLockReadGuard<'static, ()>,
    },
    Alone {
        _guard: RwLockWriteGuard<'static, ()>,
        #[cfg(feature = "mumps")]
        _mumps: std::sync::MutexGuard<'static, ()>,
    },
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
    let mut all = defaults(start, solver.option());
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

    let mut iterate = starting_iterate(start, &handle)?;
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

/// Whether Ipopt begins to solve a problem of one variable with a linear solver of its own, which it looks for only then.
///
/// # Errors
/// When it does not know the solver.
pub fn starts(problem: &mut dyn Problem, linear_solver: &str) -> Result<bool, SolveError> {
    let start = Start::Cold(vec![0.0]);
    let mut options = defaults(&start, linear_solver);
    options.set("max_iter", 0);
    let handle = Handle::create(problem)?;
    handle.set_options(&options)?;
    let mut observer = |_: &Progress| Control::Continue;
    let mut session = Session::new(problem, &mut observer, Pattern::default(), Pattern::default());
    let outcome = handle.solve(&mut starting_iterate(&start, &handle)?, &mut session);
    Ok(outcome.status.is_success() || outcome.status == SolveStatus::IterationLimit)
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
                let turn = Turn::Alone {
                    _guard: LINEAR_SOLVERS.write().unwrap_or_else(PoisonError::into_inner),
                    #[cfg(feature = "mumps")]
                    _mumps: crate::mumps::lock(),
                };
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

/// Defaults of options.
fn defaults(start: &Start, linear_solver: &str) -> Options {
    let mut options = Options::default();
    options.set("print_level", 0);
    options.set("sb", "yes");
    // A file ipopt.opt in the working directory must not change results.
    options.set("option_file_name", "");
    options.set("linear_solver", linear_solver);
    options.set("warm_start_init_point", if matches!(start, Start::Warm(_)) { "yes" } else { "no" });
    options
}

fn starting_iterate(start: &Start, handle: &Handle) -> Result<Iterate, SolveError> {
    let iterate = match start {
        Start::Warm(iterate) => iterate.clone(),
        Start::Cold(x) => Iterate {
            x: x.clone(),
            constraint_multipliers: vec![0.0; handle.constraints],
            lower_multipliers: vec![0.0; x.len()],
            upper_multipliers: vec![0.0; x.len()],
        },
    };
    let lengths = [
        (iterate.x.len(), handle.variables),
        (iterate.lower_multipliers.len(), handle.variables),
        (iterate.upper_multipliers.len(), handle.variables),
        (iterate.constraint_multipliers.len(), handle.constraints),
    ];
    match lengths.iter().find(|(actual, expected)| actual != expected) {
        Some((actual, expected)) => {
            Err(SolveError::Problem(format!("the starting point has {actual} values where {expected} are needed")))
        }
        None => Ok(iterate),
    }
}

fn violation(values: &[f64], bounds: &Bounds) -> f64 {
    let sides = values.iter().zip(bounds.lower.iter().zip(&bounds.upper));
    sides.map(|(value, (lower, upper))| (lower - value).max(value - upper)).fold(0.0, f64::max)
}

/// An Ipopt problem that is freed when dropped.
struct Handle {
    problem: ipopt::IpoptProblem,
    variables: usize,
    constraints: usize,
}

struct Outcome {
    status: SolveStatus,
    objective: f64,
    constraints: Vec<f64>,
}

impl Handle {
    fn create(problem: &dyn Problem) -> Result<Self, SolveError> {
        let (variables, constraints) = (problem.variable_bounds(), problem.constraint_bounds());
        let (jacobian, hessian) = (problem.jacobian_pattern(), problem.hessian_pattern());
        let (n, m) = (variables.lower.len(), constraints.lower.len());
        let inside = |indices: &[usize], limit| indices.iter().all(|&index| index < limit);
        let consistent = variables.upper.len() == n
            && constraints.upper.len() == m
            && jacobian.rows.len() == jacobian.columns.len()
            && hessian.rows.len() == hessian.columns.len()
            && inside(&jacobian.rows, m)
            && inside(&jacobian.columns, n)
            && inside(&hessian.rows, n)
            && hessian.rows.iter().zip(&hessian.columns).all(|(row, column)| column <= row);
        if !consistent {
            return Err(SolveError::Problem(
                "bounds or patterns do not match the numbers of variables and constraints".into(),
            ));
        }
        Self::allocate(variables, constraints, jacobian.rows.len(), hessian.rows.len())
    }

    /// For the smallest problem there is.
    fn probe() -> Result<Self, SolveError> {
        Self::allocate(Bounds { lower: vec![0.0], upper: vec![1.0] }, Bounds::default(), 0, 0)
    }

    /// For a problem with these bounds, each with as many lower as upper ones, and numbers of nonzeros.
    fn allocate(
        mut variables: Bounds,
        mut constraints: Bounds,
        jacobian_nonzeros: usize,
        hessian_nonzeros: usize,
    ) -> Result<Self, SolveError> {
        let (n, m) = (variables.lower.len(), constraints.lower.len());
        // SAFETY: the bounds have n and m values, which Ipopt copies; the callbacks have the right types.
        let handle = unsafe {
            ipopt::CreateIpoptProblem(
                n as ipopt::Index,
                variables.lower.as_mut_ptr(),
                variables.upper.as_mut_ptr(),
                m as ipopt::Index,
                constraints.lower.as_mut_ptr(),
                constraints.upper.as_mut_ptr(),
                jacobian_nonzeros as ipopt::Index,
                hessian_nonzeros as ipopt::Index,
                0,
                Some(callbacks::objective),
                Some(callbacks::constraints),
                Some(callbacks::gradient),
                Some(callbacks::jacobian),
                Some(callbacks::hessian),
            )
        };
        if handle.is_null() {
            return Err(SolveError::Problem("Ipopt rejects it".into()));
        }
        // SAFETY: the handle is valid and the callback has the right type.
        unsafe { ipopt::SetIntermediateCallback(handle, Some(callbacks::iteration)) };
        Ok(Self { problem: handle, variables: n, constraints: m })
    }

    fn set_options(&self, options: &Options) -> Result<(), SolveError> {
        for (name, value) in options.iter() {
            if !self.set_option(name, value) {
                return Err(SolveError::Option { name: name.to_owned(), value: value.clone() });
            }
        }
        Ok(())
    }

    fn set_option(&self, name: &str, value: &OptionValue) -> bool {
        let Ok(key) = CString::new(name) else { return false };
        let key = key.as_ptr().cast_mut();
        // SAFETY: the handle is valid; key and text are zero-terminated and copied by Ipopt.
        unsafe {
            match value {
                OptionValue::Integer(value) => {
                    ipopt::AddIpoptIntOption(self.problem, key, *value).into_truth()
                        || ipopt::AddIpoptNumOption(self.problem, key, f64::from(*value)).into_truth()
                }
                OptionValue::Number(value) => ipopt::AddIpoptNumOption(self.problem, key, *value).into_truth(),
                OptionValue::Text(text) => CString::new(text.as_str()).is_ok_and(|text| {
                    ipopt::AddIpoptStrOption(self.problem, key, text.as_ptr().cast_mut()).into_truth()
                }),
            }
        }
    }

    fn solve(&self, iterate: &mut Iterate, session: &mut Session) -> Outcome {
        let mut constraints = vec![0.0; self.constraints];
        let mut objective = 0.0;
        // SAFETY: all arrays have the lengths that the handle was created with; the session outlives the call.
        let status = unsafe {
            ipopt::IpoptSolve(
                self.problem,
                iterate.x.as_mut_ptr(),
                constraints.as_mut_ptr(),
                &mut objective,
                iterate.constraint_multipliers.as_mut_ptr(),
                iterate.lower_multipliers.as_mut_ptr(),
                iterate.upper_multipliers.as_mut_ptr(),
                std::ptr::from_mut(session).cast(),
            )
        };
        Outcome { status: SolveStatus::from_code(status), objective, constraints }
    }
}

impl Drop for Handle {
    fn drop(&mut self) {
        // SAFETY: the handle was created by Ipopt and is freed once.
        unsafe { ipopt::FreeIpoptProblem(self.problem) };
    }
}
