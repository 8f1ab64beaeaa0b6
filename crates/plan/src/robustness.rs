//! How robust a refined plan is and how it became so: the section `robust` of `result.json`.

use serde::{Deserialize, Serialize};
use simulation::TestResult;

use crate::iteration::PlanIteration;
use crate::parameters::RobustParameters;
use crate::records::{GraspRecord, LossRecord};
use crate::success_rates::SuccessRates;
use crate::variant::Variant;

/// Target, effort and result of a refinement.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RobustnessReport {
    /// Wanted success rate at each friction.
    #[serde(alias = "wanted_rate")]
    pub target_rate: f64,
    /// Whether it is reached at each friction, and every planned offset succeeds.
    pub reached: bool,
    /// Success rate of the plan without refinement, all rollouts together.
    pub rate_before: f64,
    /// Success rate of the refined plan.
    pub rate_after: f64,
    /// Wall time, that of the first solve included.
    pub wall_s: f64,
    /// Success rates of the plan without refinement.
    pub before: SuccessRates,
    /// Success rates of the refined plan.
    pub after: SuccessRates,
    /// Rollouts of its evaluation that were not played for lack of time; 0 where it is decided.
    #[serde(default)]
    pub unplayed: usize,
    /// A straight push in the same evaluation; `None` where there was no time to play it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub push: Option<PushReport>,
    /// The round whose plan was kept, counted from 1.
    pub kept_round: usize,
    /// Homotopy step of that round whose reference was refined, counted from 1.
    pub kept_stage: usize,
    /// Accepted perturbations of that reference.
    #[serde(alias = "kept_changes")]
    pub kept_perturbations: usize,
    /// All rounds.
    pub rounds: Vec<Round>,
    /// Parameters of the search; missing in older plans.
    #[serde(default)]
    pub parameters: RobustParameters,
    /// The worst group of rollouts of the refined plan, where some fail.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub loss: Option<LossRecord>,
}

/// How the plan of the solver does in rollouts with hard contact: the section `tested` of `result.json`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TestReport {
    /// Success rate that a robust plan would have to reach at each friction.
    #[serde(alias = "wanted_rate")]
    pub target_rate: f64,
    /// Whether every planned offset succeeds and that rate is reached at each friction. Too few rollouts to call it robust.
    pub reached: bool,
    /// Success rates of the plan.
    pub rates: SuccessRates,
    /// How a straight push does in the same rollouts.
    pub push: PushReport,
    /// Wall time of the test.
    pub wall_s: f64,
}

/// How an unplanned straight push from start to goal does in the evaluation of a plan, which ends for it as soon as it is
/// decided.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct PushReport {
    /// Whether it reaches the target of the plan.
    pub reached: bool,
    /// Its success rates.
    pub rates: SuccessRates,
}

/// One planning problem, its solution and the refinement of that.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Round {
    /// The round, in words.
    pub planned: String,
    /// Planned grasp errors.
    pub scenarios: Vec<GraspRecord>,
    /// Coulomb coefficients, each of which was planned with every grasp error.
    pub frictions: Vec<f64>,
    /// Steps of the horizon.
    pub steps: usize,
    /// Time step of the horizon.
    pub time_step_s: f64,
    /// Status of the last solve.
    pub solve_status: String,
    /// Wall time of all solves.
    pub solve_s: f64,
    /// Homotopy step whose reference passed most training cases, counted from 1; 0 without a homotopy.
    pub chosen_stage: usize,
    /// Training cases.
    #[serde(alias = "training_trials")]
    pub training_cases: usize,
    /// Training cases that failed before refinement.
    pub training_failures: usize,
    /// Wall time of the refinement.
    pub refinement_s: f64,
    /// Accepted perturbations of the reference.
    #[serde(alias = "changes")]
    pub perturbations: usize,
    /// Failing test cases of evaluations that became training cases.
    #[serde(alias = "added_trials")]
    pub added_cases: usize,
    /// Rollouts in training cases.
    pub rollouts: usize,
    /// Success rate in the best evaluation; null without any.
    pub rate: Option<f64>,
}

impl Round {
    /// A round whose homotopy has run and whose chosen reference is still to be refined; with its results in the training
    /// test cases.
    pub fn new(
        planned: String,
        variant: &Variant,
        iterations: &[PlanIteration],
        chosen: usize,
        results: &[TestResult],
    ) -> Self {
        let records = || iterations.iter().map(|iteration| &iteration.record);
        Self {
            planned,
            scenarios: variant.task.grasps.iter().map(GraspRecord::from).collect(),
            frictions: variant.task.frictions.clone(),
            steps: variant.task.horizon.steps,
            time_step_s: variant.task.horizon.time_step,
            solve_status: records().next_back().map_or_else(String::new, |record| record.status.clone()),
            solve_s: records().map(|record| record.wall_s).sum(),
            chosen_stage: chosen,
            training_cases: results.len(),
            training_failures: results.iter().filter(|result| !result.passed).count(),
            refinement_s: 0.0,
            perturbations: 0,
            added_cases: 0,
            rollouts: 0,
            rate: None,
        }
    }
}

impl RobustnessReport {
    /// Whether every planned offset succeeds at every friction.
    pub fn planned_offsets_succeed(&self) -> bool {
        self.after.planned_succeed()
    }

    /// The round whose plan was kept.
    pub fn kept(&self) -> Option<&Round> {
        self.rounds.get(self.kept_round.checked_sub(1)?)
    }
}
