//! References judged by rollouts.

use task::{AssemblyTask, Limits};

use crate::grasp::Grasp;
use crate::parallel::in_parallel;
use crate::reference::Reference;
use crate::rollout::Rollout;
use crate::settings::Settings;
use crate::success::Success;

/// One rollout that a reference has to pass.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Trial {
    /// Index into the frictions of the [`Examiner`].
    pub friction: usize,
    /// Injected error of the grasp.
    pub grasp: Grasp,
}

/// How a reference does in a trial.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Verdict {
    /// Whether it ends at the goal and no pair is pushed harder than the task's limit allows.
    pub passed: bool,
    /// Sum of the final errors in tolerances and of what the largest force exceeds its limit by, as a part of that; 0 when
    /// passed.
    pub miss: f64,
}

/// Plays references in trials.
#[derive(Debug, Clone)]
pub struct Examiner {
    rollouts: Vec<Rollout>,
    success: Success,
    limits: Limits,
}

/// Misses above this are all the same: how far away a lost part comes to rest says nothing.
const LARGEST_MISS: f64 = 60.0;

/// Part of a limit by which a motion may exceed it.
const LIMIT_SLACK: f64 = 1e-3;

impl Examiner {
    /// For a world and several friction coefficients.
    pub fn new(task: &AssemblyTask, frictions: &[f64], success: Success) -> Self {
        let rollout = |&friction: &f64| Rollout::new(task, Settings { friction, ..Settings::default() });
        Self { rollouts: frictions.iter().map(rollout).collect(), success, limits: task.limits }
    }

    /// What counts as success.
    pub fn success(&self) -> &Success {
        &self.success
    }

    /// Whether the reference keeps the task's limits of velocity and acceleration, as well as a solver's does.
    pub fn allows(&self, reference: &Reference) -> bool {
        self.limits.allow(&reference.needs(), LIMIT_SLACK)
    }

    /// Plays one trial.
    pub fn judge(&self, reference: &Reference, trial: &Trial) -> Verdict {
        let outcome = self.rollouts[trial.friction].play(reference, trial.grasp, |_, _| {});
        let excess = (outcome.max_force / self.limits.contact_force - 1.0).max(0.0);
        if outcome.is(&self.success) && excess <= LIMIT_SLACK {
            return Verdict { passed: true, miss: 0.0 };
        }
        let errors =
            outcome.position_error / self.success.position + outcome.orientation_error / self.success.orientation;
        let miss = errors + excess;
        // Also when it is not a number.
        Verdict { passed: false, miss: if miss < LARGEST_MISS { miss } else { LARGEST_MISS } }
    }

    /// Plays all trials on `jobs` threads; verdicts are in the order of the trials.
    pub fn judge_all(&self, reference: &Reference, trials: &[Trial], jobs: usize) -> Vec<Verdict> {
        in_parallel(trials.len(), jobs, |index| self.judge(reference, &trials[index]))
    }
}
