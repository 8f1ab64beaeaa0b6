//! Attempts at a problem, one after the other until a plan reaches the goal: the problem as it is and, with the
//! built-in homotopy, the same problem with slower tightening and with shorter steps. Which homotopy reaches the goal
//! differs from scene to scene, and failure shows early.

use task::HomotopySettings;

use crate::iteration::PlanIteration;
use crate::plan::{Plan, PlanStatus};
use crate::problem::Problem;
use crate::records::AttemptRecord;

/// Factor of `tau_1` and of `sigma_1` of the homotopy that tightens slowly.
const SLOW_FIRST: f64 = 4.0 / 3.0;
/// Its `kappa_tau`.
const SLOW_RATE: f64 = 0.5;
/// Homotopy steps after which a growing goal error means failure: before, smoothing itself moves the goal.
const EARLIEST_MISS: usize = 3;

/// Difference of an attempt from the problem as it is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Change {
    Nothing,
    SlowerTightening,
    ShorterSteps,
}

impl Change {
    /// All that is tried for a problem.
    pub fn all(problem: &Problem) -> &'static [Self] {
        match problem.has_default_homotopy() {
            true => &[Self::Nothing, Self::SlowerTightening, Self::ShorterSteps],
            false => &[Self::Nothing],
        }
    }

    /// The problem with this change. It keeps its identity: the plan is the same, the homotopy differs.
    pub fn of(self, problem: &Problem) -> Problem {
        match self {
            Self::Nothing => problem.clone(),
            Self::SlowerTightening => problem.with_homotopy(HomotopySettings {
                tau: SLOW_FIRST * problem.homotopy().tau,
                sigma: SLOW_FIRST * problem.homotopy().sigma,
                tau_rate: SLOW_RATE,
                ..problem.homotopy().clone()
            }),
            Self::ShorterSteps => problem.with_half_the_time_step(),
        }
    }

    /// In words.
    pub fn name(self) -> &'static str {
        match self {
            Self::Nothing => "the scene as it is",
            Self::SlowerTightening => "slower tightening of the smoothing",
            Self::ShorterSteps => "half the time step",
        }
    }
}

/// The record of an attempt whose homotopy has ended.
pub fn record(change: Change, plan: &Plan) -> AttemptRecord {
    let records = || plan.iterations.iter().map(|iteration| &iteration.record);
    AttemptRecord {
        planned: change.name().to_owned(),
        status: match is_given_up(plan) {
            true => {
                format!("given up after homotopy step {}, which led away from the goal", plan.iterations.len())
            }
            false => plan.status().to_string(),
        },
        position_error_m: plan.trajectory.worst_error().position,
        iterations: records().map(|record| record.iterations).sum(),
        wall_s: records().map(|record| record.wall_s).sum(),
    }
}

/// Whether the homotopy leads away from the goal: an error beyond the tolerance and beyond the reach of the smoothing,
/// which grows with less smoothing.
pub fn leads_away(problem: &Problem, iterations: &[PlanIteration]) -> bool {
    let [.., before, last] = iterations else { return false };
    let error = |iteration: &PlanIteration| iteration.trajectory.worst_error().position;
    let explained = problem.success().position.max(problem.task().smoothing_gap(last.record.tau));
    iterations.len() >= EARLIEST_MISS && last.record.converged && error(last) > explained.max(error(before))
}

/// Whether a plan is closer to the requirements than another one.
pub fn is_better(plan: &Plan, other: &Plan) -> bool {
    let worth = |plan: &Plan| {
        let is_planned = plan.status() == PlanStatus::Planned;
        (is_planned, plan.is_converged(), !plan.is_coarse(), !is_given_up(plan))
    };
    let error = |plan: &Plan| plan.trajectory.worst_error().position;
    worth(plan).cmp(&worth(other)).then(error(other).total_cmp(&error(plan))).is_gt()
}

/// Whether the homotopy ended before its regular number of steps, although the last of them converged.
fn is_given_up(plan: &Plan) -> bool {
    plan.stopped.is_none() && !plan.is_converged() && plan.chosen().record.converged
}
