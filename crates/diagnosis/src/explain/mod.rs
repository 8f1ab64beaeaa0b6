//! Why a plan is not done, in words of its scene: which constraints are violated most, where each scenario gets stuck,
//! which constraints contradict each other, and what to try.

mod advice;
mod dependencies;
mod factorisation;
mod limits;
mod optimum;
mod residuals;
mod sensitivities;
mod stuck;
mod words;

use nlp::Iterate;
use ocp::{Formulation, Residual, Transcription};
use plan::{Cut, Plan, PlanStatus, Stop};
use serde::{Deserialize, Serialize};
use task::AssemblyTask;

pub use dependencies::DependencyRecord;
pub use limits::ActiveLimitRecord;
pub use optimum::{ConstraintRecord, optimum};
pub use plan::records::{HoldRecord, LossRecord, MotionEnd};
pub use residuals::ResidualRecord;
pub use sensitivities::{Measured, Parameter, sensitivities};
pub use stuck::StuckScenario;

/// Why a plan is not done.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct FailureExplanation {
    /// The largest violation of each kind of constraint, the largest first.
    pub residuals: Vec<ResidualRecord>,
    /// Constraints that contradict each other or depend on each other, those that contradict first.
    pub dependencies: Vec<DependencyRecord>,
    /// Where the scenarios that miss the goal get stuck.
    pub scenarios: Vec<StuckScenario>,
    /// Limits that the plan reaches.
    pub active_limits: Vec<ActiveLimitRecord>,
    /// What to try, each with the key of the scene or the flag.
    pub advice: Vec<String>,
}

/// Largest number of violations reported for a plan that did not converge.
const VIOLATIONS: usize = 3;

impl FailureExplanation {
    /// Why a plan is not done, and what to try: sentences without full stops.
    pub fn sentences(&self, converged: bool) -> Vec<String> {
        let told = if converged { 0 } else { VIOLATIONS };
        let violated = self.residuals.iter().take(told).map(|residual| format!("violated most: {residual}"));
        let contradicting = self.dependencies.iter().map(ToString::to_string);
        let stuck = self.scenarios.iter().map(ToString::to_string);
        let advice = self.advice.iter().map(|advice| format!("hint: {advice}"));
        violated.chain(contradicting).chain(stuck).chain(advice).collect()
    }
}

/// Why a plan is not done. `None` where it is, and where it was interrupted or refined: what a refined plan loses is in
/// [`RobustnessReport::loss`](plan::RobustnessReport::loss).
pub fn explanation(plan: &Plan) -> Option<FailureExplanation> {
    match plan.status() {
        PlanStatus::GoalMissed | PlanStatus::NotConverged { .. } | PlanStatus::OutOfTime(Cut::Homotopy { .. }) => {
            Some(explain(plan))
        }
        PlanStatus::Done
        | PlanStatus::Planned
        | PlanStatus::NotRobust
        | PlanStatus::Penetrating
        | PlanStatus::OutOfTime(Cut::Evaluation { .. })
        | PlanStatus::Interrupted => None,
    }
}

fn explain(plan: &Plan) -> FailureExplanation {
    let scenarios = stuck::of_plan(plan);
    let active_limits = limits::active(&plan.task.limits, &plan.variant.task.limits, &plan.trajectory);
    // Without time for the solve there is no time to search for contradictions.
    let is_cut = plan.stopped == Some(Stop::TimeLimit);
    let (residuals, dependencies) = if is_cut { None } else { constraints(plan) }.unwrap_or_default();
    let advice = advice::advice(plan, &scenarios, &active_limits);
    FailureExplanation { residuals, dependencies, scenarios, active_limits, advice }
}

/// Where the solver ended.
struct End {
    task: AssemblyTask,
    transcription: Transcription,
    point: Iterate,
    residuals: Vec<Residual>,
}

/// The constraints at the point where the solver ended. Nothing where that point is not known any more, or a distance has no
/// value there, which the solver has reported.
fn end(plan: &Plan) -> Option<End> {
    let chosen = plan.chosen();
    let (point, record, settings) = (chosen.point.as_deref()?, &chosen.record, &plan.variant.settings);
    let task = record.task(&plan.variant.task);
    let whole = Formulation::new(&task, settings.complementarity);
    let near = whole.near(&point.x);
    let point = near.point_of(&whole, point);
    let mut transcription = Transcription::of(near, settings.complementarity, settings.hessian);
    transcription.set_smoothing(record.tau, record.sigma);
    let residuals = transcription.residuals(&point).ok()?;
    Some(End { task, transcription, point, residuals })
}

/// Violated and dependent constraints where the solver ended.
fn constraints(plan: &Plan) -> Option<(Vec<ResidualRecord>, Vec<DependencyRecord>)> {
    let End { task, mut transcription, point, residuals } = end(plan)?;
    let dependencies = match plan.chosen().record.converged {
        // Constraints that are satisfied do not contradict.
        true => Vec::new(),
        false => dependencies::find(&mut transcription, &point.x, &residuals)?,
    };
    Some((residuals::largest(&task, &residuals), dependencies))
}
