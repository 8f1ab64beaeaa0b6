//! Robust plans without what they do not need.
//!
//! Refinement keeps a change for the test cases that pass because of it, whatever it does to the motion: reorientations and
//! detours in free air, strokes that pull a seated part back. What no test case needs is taken back from a robust plan. One for
//! an arm is refined with margins instead.

use plan::{Event, PlannerError, Round};
use simulation::Refinement;
use task::StraightMotion;

use crate::candidate::Kept;
use crate::ends::has_oscillation;
use crate::{Refiner, round};

impl Refiner<'_> {
    /// Simplifies a robust plan for a free body. What comes of it is kept if it succeeds as often in a new evaluation.
    pub(super) fn simplify(&mut self) -> Result<(), PlannerError> {
        let Some(robust) = self.best.clone().filter(|best| best.reached) else { return Ok(()) };
        let is_as_planned = robust.changes == 0 && !has_oscillation(&robust);
        if is_as_planned || self.problem.arm().is_some() || self.target.stall_limit == 0 {
            return Ok(());
        }
        let cases = self.new_evaluation(self.target.parameters.simplification.random).cases().to_vec();
        self.training.extend(cases);
        for _ in 0..self.target.parameters.simplification.attempts {
            let Some((simpler, round)) = self.simpler(&robust) else { return Ok(()) };
            let judgement = self.judge(&simpler.reference, self.schedule.end());
            let rate = judgement.rates.overall();
            if judgement.rates.rollouts() > 0 {
                self.session.tell(Event::Refined { rate });
            }
            if judgement.reached && rate >= robust.rates.overall() {
                self.rounds.push(Round { rate: Some(rate), ..round });
                let (failing, round) = (judgement.failing(), self.rounds.len());
                return self.keep(Kept { failing, rates: judgement.rates, round, ..simpler }, self.rounds.clone());
            }
            self.training.extend(judgement.failures.iter().map(|(case, _)| *case));
        }
        Ok(())
    }

    /// A plan without what no training case needs, and its round, still without a rate. `None` if there is no such thing, or no
    /// time.
    fn simpler(&mut self, robust: &Kept) -> Option<(Kept, Round)> {
        let until = self.schedule.simplification();
        let stop = || self.schedule.is_over(until);
        let results = self.trainer.evaluate_all(&robust.reference, &self.training, &stop)?;
        let mut simpler = robust.clone();
        let (task, reference) = (&simpler.solved.variant.task, simpler.reference.clone());
        let straight = StraightMotion::new(&task.start, &task.goal);
        let mut refinement =
            Refinement::new(self.trainer, reference, self.training.clone(), results.clone(), self.seed);
        let changes = refinement.simplify(&straight, task.horizon.steps, &stop);
        simpler.reference = refinement.reference().clone();
        simpler.changes += changes;
        let has_oscillation = has_oscillation(&simpler);
        let marks = &mut simpler.solved.marks;
        (marks.has_oscillation, marks.is_straightened) = (marks.has_oscillation && has_oscillation, true);
        let rollouts = results.len() + refinement.rollouts();
        let round = round(&simpler.solved, &results);
        (changes > 0).then_some((simpler, Round { rollouts, changes: robust.changes + changes, ..round }))
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use simulation::Reference;

    use super::*;
    use crate::tests::in_corner;

    /// A push of the corner scene, which is robust there, with a rotation (rad) in its first half that nothing needs.
    fn twisted(refiner: &Refiner, rotation: f64) -> Reference {
        let task = refiner.problem.task();
        let push = Reference::straight(&task.start, &task.goal, task.horizon);
        let steps = push.intervals();
        let twist = |(knot, mut state): (usize, [f64; 13])| {
            let bend = (std::f64::consts::TAU * knot as f64 / steps as f64).sin().max(0.0);
            let pose = task::pose::isometry(&task::pose_of(&state));
            let turned =
                pose.rotation * nalgebra::UnitQuaternion::from_scaled_axis(nalgebra::Vector3::z() * rotation * bend);
            let quaternion = turned.into_inner().coords;
            state[3..7].copy_from_slice(&[quaternion.w, quaternion.x, quaternion.y, quaternion.z]);
            state
        };
        let states: Vec<[f64; 13]> = push.states().into_iter().enumerate().map(twist).collect();
        Reference::new(push.time_step(), &states)
    }

    /// Largest angle (rad) between a reference and the straight motion.
    fn rotation(refiner: &Refiner, reference: &Reference) -> f64 {
        let task = refiner.problem.task();
        let straight = StraightMotion::new(&task.start, &task.goal);
        let angles = reference.states().into_iter().map(|state| straight.departure(&task::pose_of(&state)).rotation);
        angles.fold(0.0, f64::max)
    }

    #[test]
    fn a_robust_plan_that_was_changed_is_straightened() {
        for changes in [0, 3] {
            in_corner(Duration::from_secs(1000), |refiner| {
                let reference = twisted(refiner, 0.3);
                assert!(rotation(refiner, &reference) > 0.25);
                refiner.judge_first(refiner.of_scene(), reference).unwrap();
                let best = refiner.best.as_mut().unwrap();
                assert!(best.reached, "{}", best.rates.overall());
                best.changes = changes;
                refiner.simplify().unwrap();
                let (best, rounds) = (refiner.best.clone().unwrap(), refiner.rounds.len());
                let angle = rotation(refiner, &best.reference);
                match changes {
                    0 => assert!(angle > 0.25 && rounds == 1, "what was planned stays as it is"),
                    _ => assert!(
                        best.reached && angle < 0.16 && best.round == 2 && best.solved.marks.is_straightened,
                        "{angle} rad: {}",
                        best.solved.planned()
                    ),
                }
            });
        }
    }
}
