//! Warnings about a problem or a plan, each with the setting that cures it.

mod arm;
mod carried;
mod fit;
mod limits;
mod motion;
mod region;
mod sizes;
mod smoothing;
pub(crate) mod tolerance;

use nlp::{IPOPT_VERSION, takes_own_solver};
use plan::{Plan, Problem};
use task::LinearSolver;

use crate::check::penetrations;

pub use fit::is_size_on_size;

/// Warnings about a problem before it is solved.
pub fn of_problem(problem: &Problem) -> Vec<String> {
    let mut warnings = problem.scene().warnings.clone();
    warnings.extend(penetrations::warnings(problem));
    warnings.extend(fit::warning(problem));
    warnings.extend(carried::warning(problem));
    warnings.extend(tolerance::warnings(problem));
    warnings.extend(sizes::warnings(problem));
    if problem.homotopy().linear_solver == LinearSolver::Stage && !takes_own_solver() {
        warnings.push(format!(
            "this Ipopt {IPOPT_VERSION} exports no function to register linear_solver = \"stage\"; MUMPS is used, which \
             is several times slower. Build with a shared library of Ipopt 3.11 or newer (docs/guide/install.md)"
        ));
    }
    warnings
}

/// Warnings about a plan. A refined one does not depend on smoothing: its scenarios are rollouts with hard contact.
pub fn of_plan(plan: &Plan) -> Vec<String> {
    let mut warnings = limits::warnings(&plan.task.limits, &plan.trajectory.keeps());
    // A plan that was cut by the time limit has more smoothing than it would have had at the end.
    if plan.robustness.is_none() && plan.stopped.is_none() && plan.chosen().record.converged {
        warnings.extend(smoothing::warning(plan));
    }
    warnings.extend(motion::warnings(plan));
    warnings.extend(region::warning(plan));
    warnings.extend(arm::warnings(plan));
    warnings
}
