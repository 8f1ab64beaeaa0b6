//! The section `robust` of `result.json`, and its summary.

use ocp::HomotopyIteration;
use serde::Serialize;
use simulation::Refinement;

use crate::robust::exam::{Mark, comparison, rate};
use crate::robust::portfolio::Variant;

/// What was wanted, what was done and what came of it.
#[derive(Debug, Serialize)]
pub struct Report {
    /// Wanted rate of success of all rollouts together.
    wanted_rate: f64,
    reached: bool,
    /// Rate of the plan that `solve` finds without refinement.
    rate_before: f64,
    rate_after: f64,
    wall_s: f64,
    before: Vec<Mark>,
    after: Vec<Mark>,
    /// The round whose plan was kept, counted from 1.
    kept_round: usize,
    rounds: Vec<Round>,
}

/// One planning problem, its solution and the refinement of that.
#[derive(Debug, Clone, Serialize)]
pub struct Round {
    /// What was planned, in words.
    pub planned: &'static str,
    pub scenarios_m: Vec<[f64; 3]>,
    pub steps: usize,
    pub time_step_s: f64,
    pub solve_status: String,
    pub solve_s: f64,
    /// Homotopy iteration whose reference passed most training trials, counted from 1.
    pub chosen_stage: usize,
    pub training_trials: usize,
    /// Training trials that failed before refinement.
    pub training_failures: usize,
    pub refinement_s: f64,
    /// Changes of the reference that were kept.
    pub changes: usize,
    /// Failing trials of exams that became training trials.
    pub added_trials: usize,
    /// In the best exam; null without any.
    pub rate: Option<f64>,
}

impl Round {
    /// A round whose homotopy, of at least one iteration, has run and whose chosen reference is still to be refined.
    pub fn new(variant: &Variant, stages: &[HomotopyIteration], chosen_stage: usize, refinement: &Refinement) -> Self {
        Self {
            planned: variant.name,
            scenarios_m: variant.task.offsets.clone(),
            steps: variant.task.horizon.steps,
            time_step_s: variant.task.horizon.time_step,
            solve_status: stages[stages.len() - 1].status.to_string(),
            solve_s: stages.iter().map(|stage| stage.timing.total).sum(),
            chosen_stage,
            training_trials: refinement.trials().len(),
            training_failures: refinement.score().0,
            refinement_s: 0.0,
            changes: 0,
            added_trials: 0,
            rate: None,
        }
    }
}

impl Report {
    /// From the marks before and after.
    pub fn new(
        wanted_rate: f64,
        wall_s: f64,
        (before, after): (Vec<Mark>, Vec<Mark>),
        kept_round: usize,
        rounds: Vec<Round>,
    ) -> Self {
        let (rate_before, rate_after) = (rate(&before), rate(&after));
        let reached = rate_after >= wanted_rate;
        Self { wanted_rate, reached, rate_before, rate_after, wall_s, before, after, kept_round, rounds }
    }

    /// Whether the wanted rate is reached.
    pub fn is_reached(&self) -> bool {
        self.reached
    }

    /// In a few lines.
    pub fn summary(&self) -> String {
        let mut lines = vec![format!(
            "success in rollouts with hard contact: {:.1} % before, {:.1} % after ({:.1} % wanted), {:.0} s; {}",
            100.0 * self.rate_before,
            100.0 * self.rate_after,
            100.0 * self.wanted_rate,
            self.wall_s,
            self.changes()
        )];
        lines.extend(comparison(&self.before, &self.after));
        lines.join("\n")
    }

    /// Where the kept reference comes from, in words.
    fn changes(&self) -> String {
        let kept = &self.rounds[self.kept_round - 1];
        match (kept.changes, self.rounds.len()) {
            (0, 1) => "the plan was left as it was".to_owned(),
            (changes, 1) => format!("{changes} changes of the reference"),
            (changes, count) => {
                format!("{changes} changes of the reference, the best of {count} problems: {}", kept.planned)
            }
        }
    }
}
