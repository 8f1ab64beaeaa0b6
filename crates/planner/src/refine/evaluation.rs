//! What a robust plan has to pass: random offsets of several magnitudes, the planned ones, several frictions.

use serde::{Deserialize, Serialize};
use simulation::{GraspError, Trial, TrialResult, offsets};
use task::AssemblyTask;

/// Magnitudes of the random offsets, as fractions of delta-hat. Beyond 95 % nothing is promised: the controller has no
/// margin there but the planned offsets, which are played too.
const FRACTIONS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 0.95];

/// Errors in every direction that random offsets have on top, as a fraction of delta-hat: what succeeds by a hair in one
/// simulator does not in another, and planned offsets often lie in a plane.
const SPREAD: f64 = 0.05;

/// Distance between the seeds of turns and of offsets, which must not depend on each other.
const TURN_SEED: u64 = 50;

/// Largest grasp errors to be borne: offset `delta-hat` (m) and turn (rad).
#[derive(Debug, Clone, Copy)]
pub struct GraspTolerance {
    pub delta: f64,
    pub turn: f64,
}

/// Trials of a reference, in groups of one friction and magnitude.
pub struct Evaluation {
    groups: Vec<SuccessRate>,
    /// Group by group.
    pub trials: Vec<Trial>,
}

/// Successes at one friction and magnitude.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SuccessRate {
    /// Coulomb's coefficient.
    pub friction: f64,
    /// Length of the offsets.
    pub magnitude_m: f64,
    /// Whether the offsets are the planned ones, not random ones in their hull.
    pub planned: bool,
    /// Rollouts that were made.
    pub rollouts: usize,
    /// Rollouts that succeeded.
    pub successes: usize,
}

impl Evaluation {
    /// At most `count` random offsets per friction and magnitude, each with a turn, and the planned offsets.
    pub fn new(task: &AssemblyTask, tolerance: GraspTolerance, frictions: &[f64], count: usize, seed: u64) -> Self {
        let GraspTolerance { delta, turn } = tolerance;
        let (mut groups, mut trials) = (Vec::new(), Vec::new());
        for (index, &friction) in frictions.iter().enumerate() {
            let mut add = |magnitude_m: f64, planned: bool, errors: &mut dyn Iterator<Item = GraspError>| {
                let errors = GraspError::distinct(errors);
                groups.push(SuccessRate { friction, magnitude_m, planned, rollouts: errors.len(), successes: 0 });
                trials.extend(errors.into_iter().map(|grasp| Trial { friction: index, grasp }));
            };
            for (seed, fraction) in (seed..).zip(&FRACTIONS) {
                let scaled: Vec<[f64; 3]> = task.offsets.iter().map(|offset| offset.map(|c| c * fraction)).collect();
                let spread = offsets::ball(SPREAD * delta, count, seed);
                let planned = offsets::hull(&scaled, count, seed);
                let turns = offsets::ball(turn, count, seed + TURN_SEED);
                let error = |((offset, spread), turn): (([f64; 3], &[f64; 3]), [f64; 3])| GraspError {
                    offset: std::array::from_fn(|axis| offset[axis] + spread[axis]),
                    turn,
                };
                add(fraction * delta, false, &mut planned.into_iter().zip(&spread).zip(turns).map(error));
            }
            add(delta, true, &mut task.offsets.iter().copied().map(GraspError::from));
        }
        Self { groups, trials }
    }

    /// The success rates, from the results in the order of the trials.
    pub fn rates(&self, results: &[TrialResult]) -> SuccessRates {
        let mut results = results.iter();
        let count = |group: &SuccessRate| {
            let successes = results.by_ref().take(group.rollouts).filter(|result| result.passed).count();
            SuccessRate { successes, ..group.clone() }
        };
        SuccessRates(self.groups.iter().map(count).collect())
    }
}

/// All groups of an evaluation, in the order of friction, then magnitude.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
pub struct SuccessRates(pub Vec<SuccessRate>);

impl SuccessRates {
    /// Success rate of all rollouts together.
    pub fn overall(&self) -> f64 {
        rate(&self.0)
    }

    /// Whether every planned offset succeeds at every friction.
    pub fn planned_succeed(&self) -> bool {
        self.0.iter().filter(|group| group.planned).all(|group| group.successes == group.rollouts)
    }

    /// Whether a plan is robust: every planned offset succeeds at every friction, and the wanted rate holds at each.
    pub fn satisfy(&self, wanted: f64) -> bool {
        self.planned_succeed() && self.by_friction().all(|groups| rate(groups) >= wanted)
    }

    /// Whether these are better than others: robust before not, then by the rate of all rollouts.
    pub fn are_better_than(&self, other: &Self, wanted: f64) -> bool {
        (self.satisfy(wanted), self.overall()) > (other.satisfy(wanted), other.overall())
    }

    /// The groups of each friction.
    pub fn by_friction(&self) -> impl Iterator<Item = &[SuccessRate]> {
        self.0.chunk_by(|one, other| one.friction == other.friction)
    }
}

/// Success rate of some groups together.
pub fn rate(groups: &[SuccessRate]) -> f64 {
    let rollouts: usize = groups.iter().map(|group| group.rollouts).sum();
    let successes: usize = groups.iter().map(|group| group.successes).sum();
    successes as f64 / rollouts as f64
}

#[cfg(test)]
mod tests {
    use super::*;

    fn group(friction: f64, planned: bool, successes: usize) -> SuccessRate {
        SuccessRate { friction, magnitude_m: 0.01, planned, rollouts: 10, successes }
    }

    #[test]
    fn a_rate_that_holds_on_the_average_only_is_not_robust() {
        let rates =
            SuccessRates(vec![group(0.0, true, 10), group(0.0, false, 10), group(0.1, true, 10), group(0.1, false, 7)]);
        assert!(rates.overall() > 0.9);
        assert!(!rates.satisfy(0.9), "at friction 0.1 only 85 % succeed");
        assert!(rates.satisfy(0.85));
    }

    #[test]
    fn a_planned_offset_that_fails_is_not_robust() {
        let rates = SuccessRates(vec![group(0.0, true, 9), group(0.0, false, 10)]);
        assert!(!rates.satisfy(0.5));
        assert!(SuccessRates(vec![group(0.0, true, 10), group(0.0, false, 5)]).are_better_than(&rates, 0.5));
    }
}
