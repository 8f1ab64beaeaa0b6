//! What is odd about a problem or a plan, in plain words with the setting that cures it.

mod arm;
mod carried;
mod limits;
mod motion;
mod region;
mod sizes;
mod smoothing;
pub(crate) mod tolerance;

use nlp::{IPOPT_VERSION, takes_own_solver};
use task::LinearSolver;

use crate::check::overlaps;
use crate::plan::Plan;
use crate::problem::Problem;

impl Problem {
    /// What is odd about the problem before it is solved.
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = self.scene().warnings.clone();
        warnings.extend(overlaps::warnings(self));
        warnings.extend(carried::warning(self));
        warnings.extend(tolerance::warnings(self));
        warnings.extend(sizes::warnings(self));
        if self.homotopy().linear_solver == LinearSolver::Stage && !takes_own_solver() {
            warnings.push(format!(
                "this Ipopt {IPOPT_VERSION} exports no function to register linear_solver = \"stage\"; MUMPS is used, which \
                 is several times slower. Build with a shared library of Ipopt 3.11 or newer (docs/guide/install.md)"
            ));
        }
        warnings
    }
}

impl Plan {
    /// What is odd about the problem and the plan.
    pub fn warnings(&self) -> Vec<String> {
        let mut warnings = self.problem.warnings();
        warnings.extend(self.own_warnings());
        warnings
    }

    /// What is wrong with the plan. A refined one does not lean on smoothing: its scenarios are rollouts with hard
    /// contact.
    pub fn own_warnings(&self) -> Vec<String> {
        let mut warnings = limits::warnings(&self.task.limits, &self.trajectory.keeps());
        // What time has cut leans on the smoothing of its last homotopy iteration, which time would have tightened.
        if self.robustness.is_none() && self.stopped.is_none() && self.chosen().record.converged {
            warnings.extend(smoothing::warning(self));
        }
        warnings.extend(motion::warnings(self));
        warnings.extend(region::warning(self));
        warnings.extend(arm::warnings(self));
        warnings
    }
}
