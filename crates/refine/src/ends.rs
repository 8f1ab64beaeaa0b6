//! How references end: as they were planned, or with a final oscillation.

use plan::{Problem, RobustnessTarget, Round};
use simulation::{FinalOscillation, Reference, Refinement};

use crate::candidate::{Candidate, Kept};
use crate::origin::Solved;
use crate::race::{Winner, race};
use crate::schedule::Deadline;
use crate::{Refiner, round};

/// The best of several references in the training cases.
pub struct Best {
    /// Its index is that of the reference.
    pub winner: Winner,
    reference: Reference,
    has_oscillation: bool,
}

/// The oscillation for the references of a problem. `None` where nothing holds the body short of its goal.
pub fn final_oscillation(problem: &Problem, target: &RobustnessTarget) -> Option<FinalOscillation> {
    let holds = problem.arm().is_some_and(|arm| arm.joint_friction.iter().any(|torque| *torque > 0.0));
    let are_wanted = holds || target.largest_friction() > 0.0;
    let depth = problem.engagement().depth_m.unwrap_or(f64::INFINITY);
    if are_wanted { FinalOscillation::new(problem.task(), &problem.success(), depth) } else { None }
}

/// Whether a plan's reference is longer than its horizon.
pub fn has_oscillation(plan: &Kept) -> bool {
    plan.reference.intervals() > plan.solved.variant.task.horizon.steps
}

impl<'run> Refiner<'run> {
    /// Races some references in the training cases, each as it is and, where that keeps the limits, with a final oscillation; of
    /// equals it is the one without. `None` without references or time.
    pub(super) fn best_of(&self, references: &[Reference], until: Deadline) -> Option<Best> {
        let (mut places, mut ends) = (Vec::new(), Vec::new());
        for (index, plain) in references.iter().enumerate() {
            let with_oscillation = self.oscillation.iter().map(|oscillation| plain.with_oscillation(oscillation));
            for end in with_oscillation.filter(|end| self.trainer.bounds().including(end).allow(end)) {
                places.push((index, true));
                ends.push(end);
            }
        }
        // Of equals the later wins.
        places.extend((0..references.len()).map(|index| (index, false)));
        ends.extend_from_slice(references);
        let stop = || self.schedule.is_over(until);
        let winner = race(self.trainer, &ends, (&self.training, self.target.parameters.training.first), &stop)?;
        let (reference, (index, has_oscillation)) = (ends.swap_remove(winner.index), places[winner.index]);
        Some(Best { winner: Winner { index, ..winner }, reference, has_oscillation })
    }

    /// The candidate of the best reference, which is that of the chosen homotopy step of a solved problem.
    pub(super) fn candidate_of(&self, best: Best, mut solved: Solved) -> Candidate<'run> {
        let Best { winner, reference, has_oscillation } = best;
        solved.marks.has_oscillation = has_oscillation;
        let round = Round { rollouts: winner.rollouts, ..round(&solved, &winner.results) };
        let refinement = Refinement::new(self.trainer, reference, self.training.clone(), winner.results, self.seed);
        Candidate { solved, refinement, round }
    }
}
