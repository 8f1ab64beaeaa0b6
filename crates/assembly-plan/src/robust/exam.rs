//! What a robust plan has to pass: random offsets of several magnitudes, the planned ones, several frictions.

use serde::Serialize;
use simulation::{GraspError, Trial, TrialResult, offsets};
use task::AssemblyTask;

/// Magnitudes of the random offsets, as fractions of delta-hat. Beyond 95 % nothing is promised: the controller has no
/// margin there but the planned offsets, which are played too.
const FRACTIONS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 0.95];

/// Errors in every direction that random offsets have on top, as a part of delta-hat: what succeeds by a hair in one
/// simulator does not in another, and planned offsets often lie in a plane.
const SPREAD: f64 = 0.05;

/// Turns are not to depend on offsets.
const TURN_SEED: u64 = 50;

/// Trials and how they are counted.
pub struct Exam {
    cells: Vec<Mark>,
    /// Cell by cell.
    pub trials: Vec<Trial>,
}

/// Successes at one friction and magnitude.
#[derive(Debug, Clone, Serialize)]
pub struct Mark {
    friction: f64,
    magnitude_m: f64,
    /// Whether the offsets are the planned ones, not random ones in their hull.
    planned: bool,
    rollouts: usize,
    successes: usize,
}

impl Exam {
    /// At most `count` random offsets per friction and magnitude, turned by up to `turn` (rad).
    pub fn new(task: &AssemblyTask, (delta, turn): (f64, f64), frictions: &[f64], count: usize, seed: u64) -> Self {
        let (mut cells, mut trials) = (Vec::new(), Vec::new());
        for (friction, &coefficient) in frictions.iter().enumerate() {
            let mut add = |magnitude_m: f64, planned: bool, grasps: &mut dyn Iterator<Item = GraspError>| {
                let grasps = GraspError::distinct(grasps);
                cells.push(Mark { friction: coefficient, magnitude_m, planned, rollouts: grasps.len(), successes: 0 });
                trials.extend(grasps.into_iter().map(|grasp| Trial { friction, grasp }));
            };
            for (index, fraction) in FRACTIONS.iter().enumerate() {
                let scaled: Vec<[f64; 3]> = task.offsets.iter().map(|offset| offset.map(|c| c * fraction)).collect();
                let seed = seed + index as u64;
                let errors = offsets::ball(SPREAD * delta, count, seed);
                let planned = offsets::hull(&scaled, count, seed);
                let turns = offsets::ball(turn, count, seed + TURN_SEED);
                let grasp = |((offset, error), turn): (([f64; 3], &[f64; 3]), [f64; 3])| GraspError {
                    offset: std::array::from_fn(|axis| offset[axis] + error[axis]),
                    turn,
                };
                add(fraction * delta, false, &mut planned.into_iter().zip(&errors).zip(turns).map(grasp));
            }
            add(delta, true, &mut task.offsets.iter().copied().map(GraspError::from));
        }
        Self { cells, trials }
    }

    /// The cells with their successes, from the verdicts in the order of the trials.
    pub fn marks(&self, verdicts: &[TrialResult]) -> Vec<Mark> {
        let mut verdicts = verdicts.iter();
        let count = |cell: &Mark| {
            let successes = verdicts.by_ref().take(cell.rollouts).filter(|verdict| verdict.passed).count();
            Mark { successes, ..cell.clone() }
        };
        self.cells.iter().map(count).collect()
    }
}

/// Rate of success of all rollouts together.
pub fn rate(marks: &[Mark]) -> f64 {
    let (successes, rollouts) =
        marks.iter().fold((0, 0), |(successes, rollouts), mark| (successes + mark.successes, rollouts + mark.rollouts));
    successes as f64 / rollouts as f64
}

/// One line per friction: rates by magnitude, before and after.
pub fn comparison(before: &[Mark], after: &[Mark]) -> Vec<String> {
    let pairs: Vec<(&Mark, &Mark)> = before.iter().zip(after).collect();
    let same_friction = |one: &(&Mark, &Mark), other: &(&Mark, &Mark)| one.0.friction == other.0.friction;
    let percent = |mark: &Mark| 100.0 * mark.successes as f64 / mark.rollouts as f64;
    let cell = |(before, after): &(&Mark, &Mark)| {
        let name = if after.planned { " planned" } else { "" };
        format!("{:.1} mm{name} {:.0} -> {:.0} %", 1e3 * after.magnitude_m, percent(before), percent(after))
    };
    let line = |cells: &[(&Mark, &Mark)]| {
        let cells_text: Vec<String> = cells.iter().map(cell).collect();
        format!("  friction {}: {}", cells[0].0.friction, cells_text.join(", "))
    };
    pairs.chunk_by(same_friction).map(line).collect()
}
