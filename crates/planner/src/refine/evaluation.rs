//! What a robust plan has to pass: random offsets of several magnitudes, the planned ones, several frictions.

use simulation::{GraspError, Trial, TrialResult, offsets};
use task::AssemblyTask;

use crate::success_rates::{SuccessRate, SuccessRates};

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
