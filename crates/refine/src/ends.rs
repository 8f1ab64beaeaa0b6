//! How references end: as they were planned, or with a final oscillation.

use plan::{Problem, RobustnessTarget};
use simulation::{Evaluator, FinalOscillation, Reference};

use crate::race::{Heats, Winner, race};

/// The best of several references in the training set.
pub struct Best {
    /// Its index is that of the reference.
    pub winner: Winner,
    pub reference: Reference,
    pub has_oscillation: bool,
}

/// The oscillation for the references of a problem. `None` where nothing holds the body short of its goal.
pub fn final_oscillation(problem: &Problem, target: &RobustnessTarget) -> Option<FinalOscillation> {
    let holds = problem.arm().is_some_and(|arm| arm.joint_friction.iter().any(|torque| *torque > 0.0));
    let are_wanted = holds || target.largest_friction() > 0.0;
    let depth = problem.engagement().depth_m.unwrap_or(f64::INFINITY);
    if are_wanted { FinalOscillation::new(problem.task(), &problem.success(), depth) } else { None }
}

/// Races some references in a training set, each as it is and, where that keeps the limits, with a final oscillation; of equals
/// it is the one without. `None` without references, or when `stop` returned true before the end.
pub fn best_end(
    trainer: &Evaluator,
    oscillation: Option<&FinalOscillation>,
    references: &[Reference],
    heats: Heats,
    stop: &(dyn Fn() -> bool + Sync),
) -> Option<Best> {
    let (mut places, mut ends) = (Vec::new(), Vec::new());
    for (index, plain) in references.iter().enumerate() {
        let with_oscillation = oscillation.map(|oscillation| plain.with_oscillation(oscillation));
        if let Some(end) = with_oscillation.filter(|end| trainer.bounds().including(end).allow(end)) {
            places.push((index, true));
            ends.push(end);
        }
    }
    // The later of equals wins.
    places.extend((0..references.len()).map(|index| (index, false)));
    ends.extend_from_slice(references);
    let winner = race(trainer, &ends, heats, stop)?;
    let (reference, (index, has_oscillation)) = (ends.swap_remove(winner.index), places[winner.index]);
    Some(Best { winner: Winner { index, ..winner }, reference, has_oscillation })
}
