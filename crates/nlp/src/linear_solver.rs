//! Which linear solvers the loaded Ipopt can run.

use crate::callbacks::Session;
use crate::error::SolveError;
use crate::handle::Handle;
use crate::options::Options;
use crate::problem::{Bounds, EvaluationError, Pattern, Problem};
use crate::slot;
use crate::solution::{Control, Progress, Start};
use crate::status::SolveStatus;

/// Solvers of the HSL collection that Ipopt loads from a library of the user's.
const HSL: [&str; 3] = ["ma27", "ma57", "ma97"];
/// The solver that comes with Ipopt.
pub const MUMPS: &str = "mumps";

fn refusal(name: &str, reason: String) -> SolveError {
    SolveError::LinearSolver { name: name.to_owned(), reason }
}

/// Whether the loaded Ipopt can run a solver of the caller: it must export a function to register one.
pub fn takes_own_solver() -> bool {
    slot::exists()
}

/// Checks that a solver of the caller can run.
///
/// # Errors
/// When it cannot be registered in this Ipopt.
pub fn require_own(name: &str) -> Result<(), SolveError> {
    if takes_own_solver() {
        return Ok(());
    }
    Err(refusal(name, format!("it cannot be registered in this Ipopt {}", crate::IPOPT_VERSION)))
}

/// Checks that one of Ipopt's own linear solvers can run. No other solve may be running.
///
/// # Errors
/// When the name is unknown or the solver is not installed.
pub fn require(name: &str) -> Result<(), SolveError> {
    if name == MUMPS {
        return Ok(());
    }
    if !HSL.contains(&name) {
        return Err(refusal(name, format!("unknown; choose {MUMPS} or {}", HSL.join(", "))));
    }
    slot::vacate();
    match starts(name) {
        Ok(true) => Ok(()),
        Ok(false) => {
            let library = format!("{}hsl{}", std::env::consts::DLL_PREFIX, std::env::consts::DLL_SUFFIX);
            Err(refusal(name, format!("the HSL library {library} cannot be loaded, or does not contain it")))
        }
        Err(error) => Err(refusal(name, format!("this Ipopt cannot load it: {error}"))),
    }
}

/// Whether Ipopt begins to solve a problem of one variable with a linear solver of its own, which it looks for only then.
///
/// # Errors
/// When it does not know the solver.
fn starts(linear_solver: &str) -> Result<bool, SolveError> {
    let start = Start::Cold(vec![0.0]);
    let mut options = Options::defaults(&start, linear_solver);
    options.set("max_iter", 0);
    let handle = Handle::create(&Nothing)?;
    handle.set_options(&options)?;
    let mut observer = |_: &Progress| Control::Continue;
    let mut problem = Nothing;
    let mut session = Session::new(&mut problem, &mut observer, Pattern::default(), Pattern::default());
    let outcome = handle.solve(&mut handle.starting_iterate(&start)?, &mut session);
    Ok(outcome.status.is_success() || outcome.status == SolveStatus::IterationLimit)
}

/// A problem of one variable with nothing to minimise.
struct Nothing;

impl Problem for Nothing {
    fn variable_bounds(&self) -> Bounds {
        Bounds { lower: vec![0.0], upper: vec![1.0] }
    }
    fn constraint_bounds(&self) -> Bounds {
        Bounds::default()
    }
    fn jacobian_pattern(&self) -> Pattern {
        Pattern::default()
    }
    fn hessian_pattern(&self) -> Pattern {
        Pattern::default()
    }
    fn set_point(&mut self, _: &[f64]) -> Result<(), EvaluationError> {
        Ok(())
    }
    fn objective(&mut self) -> Result<f64, EvaluationError> {
        Ok(0.0)
    }
    fn gradient(&mut self, gradient: &mut [f64]) -> Result<(), EvaluationError> {
        gradient.fill(0.0);
        Ok(())
    }
    fn constraints(&mut self, _: &mut [f64]) -> Result<(), EvaluationError> {
        Ok(())
    }
    fn jacobian(&mut self, _: &mut [f64]) -> Result<(), EvaluationError> {
        Ok(())
    }
    fn hessian(&mut self, _: f64, _: &[f64], _: &mut [f64]) -> Result<(), EvaluationError> {
        Ok(())
    }
}
