//! Parameters of the search for a robust plan. The defaults worked best in measurements on the scenes of the project.

use serde::{Deserialize, Serialize};

use crate::error::PlannerError;
use crate::ranges::require;

/// All numbers that the search for a robust plan depends on, besides what the plan must tolerate.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct RobustParameters {
    /// Shares of the time.
    pub time: TimeShares,
    /// How references are changed.
    pub training: TrainingParameters,
    /// Evaluations.
    pub evaluation: EvaluationParameters,
    /// How far references may be led away.
    pub near: NearParameters,
    /// The final comparison.
    pub comparison: ComparisonParameters,
    /// Other problems that are solved where the plan of the scene is given up.
    pub portfolio: PortfolioParameters,
    /// The many plans from which one for an arm is taken.
    pub drafts: DraftParameters,
    /// Margins of robust plans beyond the requirements.
    pub margins: MarginParameters,
    /// How robust plans are refined in what they fail, and made simpler.
    pub simplification: SimplificationParameters,
    /// The spiral search for the hole.
    pub spiral: SpiralParameters,
    /// Seeds of random numbers.
    pub seeds: Seeds,
}

impl RobustParameters {
    /// Checks what would make the search endless or meaningless.
    ///
    /// # Errors
    /// With the first value that is out of its range.
    pub fn validate(&self) -> Result<(), PlannerError> {
        let TimeShares {
            homotopy,
            own,
            push,
            drafts,
            other_drafts,
            solving,
            training,
            margins,
            simplification,
            comparison,
        } = self.time;
        for (name, share) in [
            ("time.homotopy", homotopy),
            ("time.own", own),
            ("time.push", push),
            ("time.drafts", drafts),
            ("time.other_drafts", other_drafts),
            ("time.solving", solving),
            ("time.training", training),
            ("time.margins", margins),
            ("time.simplification", simplification),
            ("time.comparison", comparison),
            ("training.force_share", self.training.force_share),
            ("evaluation.force_share", self.evaluation.force_share),
            ("evaluation.confidence", self.evaluation.confidence),
        ] {
            require((0.0..=1.0).contains(&share), name, share, "must lie between 0 and 1")?;
        }
        for (name, count) in [
            ("training.first", self.training.first),
            ("evaluation.batch", self.evaluation.batch),
            ("comparison.first", self.comparison.first),
            ("comparison.latest", self.comparison.latest),
        ] {
            require(count > 0, name, count, "must be at least 1")?;
        }
        Ok(())
    }
}

/// Shares (0 to 1) of the remaining time when a part of the work begins.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TimeShares {
    /// The homotopy of the scene itself; with an arm, at least its first step.
    pub homotopy: f64,
    /// The first refinement of the plan of the scene itself.
    pub own: f64,
    /// The refinement of a straight push.
    pub push: f64,
    /// The solves of drafts.
    pub drafts: f64,
    /// Within this share, other drafts may take the place of one that gets stuck.
    pub other_drafts: f64,
    /// The solve of a variant, of its own time; the rest is for its refinement.
    pub solving: f64,
    /// Perturbations, of the time of a refinement; the rest is for the evaluation that follows.
    pub training: f64,
    /// The hardened environment in which a robust plan gets margins; the rest is for the evaluation that follows.
    pub margins: f64,
    /// Making a robust plan simpler; the rest is for the evaluation that follows.
    pub simplification: f64,
    /// Left for the comparison at the end, of the whole time.
    pub comparison: f64,
}

impl Default for TimeShares {
    fn default() -> Self {
        Self {
            homotopy: 0.4,
            own: 0.5,
            push: 0.4,
            drafts: 0.3,
            other_drafts: 0.4,
            solving: 0.6,
            training: 0.8,
            margins: 0.8,
            simplification: 0.5,
            comparison: 0.04,
        }
    }
}

/// How references are changed until they pass.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct TrainingParameters {
    /// Random offsets per friction and magnitude to train with at first: what fails in an evaluation is trained on next, so that
    /// one is enough. More cost more rollouts than they save.
    pub random: usize,
    /// Test cases in which all of several references are played at first, where most of them differ much.
    pub first: usize,
    /// Part of the limit of contact forces that training cases may use, less than evaluations may.
    pub force_share: f64,
    /// Misses that shrink by less than this factor are no improvement: refinement could creep until the time is over.
    pub creeping: f64,
    /// Evaluations in a row without a better rate after which a refinement is given up.
    pub given_up: usize,
    /// Success rate from which on a plan is refined rather than replaced.
    pub nearly_robust: f64,
    /// Whether a straight push and a spiral search are tried before anything is solved.
    pub simple: bool,
}

impl Default for TrainingParameters {
    fn default() -> Self {
        Self { random: 1, first: 6, force_share: 0.85, creeping: 0.99, given_up: 3, nearly_robust: 0.75, simple: true }
    }
}

/// Test cases of evaluations.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct EvaluationParameters {
    /// Random offsets per friction and magnitude. A plan that fails in 4 % of the offsets of one magnitude passes 50 of them by
    /// luck in 13 of 100 cases, and 100 of them in 2.
    pub random: usize,
    /// The same for a plan that nothing has refined: about a second of rollouts.
    pub test_random: usize,
    /// Magnitudes of the random offsets in a hull, as fractions of delta-hat. Beyond 95 % there is no guarantee: the controller
    /// has no margin there but the planned offsets, which are played too. In a disc or a ball there are as many offsets.
    pub fractions: [f64; 5],
    /// Errors in every direction that random offsets have on top, as a fraction of delta-hat: what succeeds by a hair in one
    /// simulator does not in another, and planned offsets often lie in a plane.
    pub spread: f64,
    /// Test cases that are played before it is asked whether they are enough; independent of the number of threads, so that the
    /// results are, too.
    pub batch: usize,
    /// Number of failures that is enough to train on.
    pub enough_failures: usize,
    /// Number of rollouts after which fewer failures are enough, where the plan is certain to fail: rare ones would take the
    /// whole evaluation.
    pub enough_rollouts: usize,
    /// Confidence with which random offsets alone show the target rate, so that no more are played: 0.95 takes 299 of them at each
    /// friction, without a failure, for a rate of 99 %. 1 plays all.
    pub confidence: f64,
    /// Part of the limit of contact forces that evaluations may use: largest forces in MuJoCo are a tenth larger.
    pub force_share: f64,
}

impl Default for EvaluationParameters {
    fn default() -> Self {
        Self {
            random: 100,
            test_random: 10,
            fractions: [0.0, 0.25, 0.5, 0.75, 0.95],
            spread: 0.05,
            batch: 24,
            enough_failures: 8,
            enough_rollouts: 240,
            confidence: 0.95,
            force_share: 0.9,
        }
    }
}

/// How far references may be led away: a part that is thrown may arrive as well.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct NearParameters {
    /// A refined reference leaves the box of plan and straight path by at most this multiple of the sum of delta-hat and tolerance.
    pub margin: f64,
    /// Factor of their largest speed that bounds its speed, where no limit does.
    pub haste: f64,
}

impl Default for NearParameters {
    fn default() -> Self {
        Self { margin: 2.0, haste: 4.0 }
    }
}

/// The final comparison, where no reference is robust.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct ComparisonParameters {
    /// Number of latest references that are compared.
    pub latest: usize,
    /// Random grasp errors per friction and magnitude.
    pub random: usize,
    /// Test cases in which all of them are played at first.
    pub first: usize,
}

impl Default for ComparisonParameters {
    fn default() -> Self {
        Self { latest: 8, random: 10, first: 24 }
    }
}

/// Other problems whose plans may have more margin.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct PortfolioParameters {
    /// Failing grasp errors that a variant adopts as scenarios.
    pub added_failures: usize,
    /// Factor of the grasp errors that are planned with a margin.
    pub offset_margin: f64,
    /// Factor of the weights of velocities in a slower plan.
    pub slowness: f64,
    /// Homotopy steps of a homotopy that starts from a motion.
    pub resolved_iterations: usize,
    /// Its first barrier parameter: there are no multipliers yet.
    pub resolved_barrier: f64,
}

impl Default for PortfolioParameters {
    fn default() -> Self {
        Self { added_failures: 3, offset_margin: 1.1, slowness: 10.0, resolved_iterations: 2, resolved_barrier: 1e-2 }
    }
}

/// The many plans of an arm's scene from which the best is taken. Compliant motions that shift slowly and rotate freely pass most
/// rollouts.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct DraftParameters {
    /// Fraction of the training cases in which the plan of the scene must fail.
    pub lost: f64,
    /// Success rate in the first evaluation below which refinement mostly gets stuck.
    pub promising: f64,
    /// Largest number of drafts: more would take more time to compare than to make.
    pub most: usize,
    /// Number of last homotopy steps of a draft that are tried: earlier ones hardly ever win.
    pub last: usize,
    /// Number of their first homotopy steps with half of their time steps and merged pieces.
    pub coarse_iterations: usize,
    /// Exponents of ten of the least and largest factor of the weight of the reference's translational velocity.
    pub reference_translational: [f64; 2],
    /// The same for its rotational velocity.
    pub reference_rotational: [f64; 2],
    /// The same for the translational velocity of compliant motions.
    pub compliant_translational: [f64; 2],
    /// The same for their rotational velocity.
    pub compliant_rotational: [f64; 2],
    /// Fraction of drafts with friction.
    pub with_friction: f64,
    /// Their coefficient, as a fraction of the largest that must be tolerated: more costs more, and is no better.
    pub friction: f64,
    /// Fraction of drafts that take half as long again.
    pub slower: f64,
}

impl Default for DraftParameters {
    fn default() -> Self {
        Self {
            lost: 0.5,
            promising: 0.8,
            most: 24,
            last: 2,
            coarse_iterations: 3,
            reference_translational: [-0.5, 0.7],
            reference_rotational: [-1.0, 0.3],
            compliant_translational: [0.8, 2.0],
            compliant_rotational: [-1.3, -0.3],
            with_friction: 1.0 / 3.0,
            friction: 1.0 / 3.0,
            slower: 0.5,
        }
    }
}

/// Margins of robust plans for arms beyond the requirements.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct MarginParameters {
    /// Factor applied to friction coefficients in the hardened environment.
    pub friction: f64,
}

impl Default for MarginParameters {
    fn default() -> Self {
        Self { friction: 1.1 }
    }
}

/// How robust plans are made simpler.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SimplificationParameters {
    /// Random grasp errors per friction and magnitude in which the simpler plan must succeed besides the training cases.
    pub random: usize,
    /// How often this is repeated, with the test cases that the simpler plan fails.
    pub attempts: usize,
}

impl Default for SimplificationParameters {
    fn default() -> Self {
        Self { random: 10, attempts: 2 }
    }
}

/// The spiral search for the hole, of free bodies only.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(default)]
pub struct SpiralParameters {
    /// Distance between two turns, in clearances from side to side: at 1, the hole is just found; 0 for no search.
    pub pitch: f64,
    /// Longest duration of a search that is tried (s): with large offsets and little clearance, a spiral has many turns.
    pub longest: f64,
}

impl Default for SpiralParameters {
    fn default() -> Self {
        Self { pitch: 0.5, longest: 30.0 }
    }
}

/// Seeds of random numbers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Seeds {
    /// Seed of training offsets and perturbations; evaluations have the following seeds.
    pub first: u64,
    /// Distance between the seeds of evaluations, which need one per magnitude.
    pub stride: u64,
    /// Distance between the seeds of errors of the robot and of offsets, which must not depend on each other.
    pub disturbance: u64,
}

impl Default for Seeds {
    fn default() -> Self {
        Self { first: 1, stride: 100, disturbance: 75 }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_would_never_end_is_refused() {
        assert!(RobustParameters::default().validate().is_ok());
        let mut endless = RobustParameters::default();
        endless.training.first = 0;
        assert!(endless.validate().unwrap_err().to_string().starts_with("training.first = 0: must be at least 1"));
        let mut late = RobustParameters::default();
        late.time.own = f64::NAN;
        assert!(late.validate().is_err());
    }
}
