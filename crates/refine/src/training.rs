//! Refinement of one reference and its evaluation, in turn.

use std::time::Instant;

use plan::{Event, PlannerError};
use simulation::{Reference, Refinement};

use crate::candidate::{Candidate, Kept};
use crate::clock::Deadline;
use crate::evaluation::{Evaluation, Judgement};
use crate::{OWN_SHARE, Refiner, SEED, SEED_STRIDE};

/// Random offsets per friction and magnitude of an evaluation. A plan that fails in 4 % of the offsets of one magnitude
/// passes 50 of them by luck in 13 of 100 cases, and 100 of them in 2.
const EVALUATION: usize = 100;
/// Misses that shrink by less than this factor are no improvement: refinement could creep until the time is over.
const CREEPING: f64 = 0.99;
/// How often a robust plan is refined in the few trials that it fails.
const POLISHES: usize = 2;
/// Evaluations in a row without a better rate after which a refinement is given up.
const GIVEN_UP: usize = 3;
/// Share of the time for changes; the rest is for the evaluation that follows.
const TRAINING_SHARE: f64 = 0.8;

impl<'run> Refiner<'run> {
    /// Refines a reference and evaluates it, until it is good enough, given up, all changes have been tried, or the time is
    /// over, which may be [extended](Self::extended). It is given up at once if a smaller fraction than `least` of the
    /// trials of its first evaluation succeeds. Rates of evaluations that end early vary, so that a lower one is no reason to
    /// go back. What is robust, but fails in some trials, is refined in these a few times more: simulators differ, and so
    /// does reality.
    pub(super) fn refine(
        &mut self,
        candidate: Candidate<'run>,
        mut until: Deadline,
        least: f64,
    ) -> Result<(), PlannerError> {
        let begin = Instant::now();
        let Candidate { variant, iterations, mut refinement, mut round, is_scenes_own } = candidate;
        self.session.tell(Event::Refining { planned: &round.planned });
        let chosen_with = round.rollouts;
        let (mut polished, mut vain) = (0, 0);
        // What failed elsewhere since it became a candidate.
        let new = self.training[refinement.trials().len()..].to_vec();
        let results = self.trainer.evaluate_all(refinement.reference(), &new, &|| self.clock.is_over(until));
        refinement.add(new.into_iter().zip(results.into_iter().flatten()));
        loop {
            self.train(&mut refinement, &mut round.changes, self.clock.share(until, TRAINING_SHARE));
            round.rollouts = chosen_with + refinement.rollouts();
            round.refinement_s = begin.elapsed().as_secs_f64();
            // Whatever the share of the time: an evaluation that takes long is one that may succeed.
            let judgement = self.judge(refinement.reference(), self.clock.end());
            let number = self.rounds.len() + 1;
            let kept = Kept {
                variant: variant.clone(),
                iterations: iterations.clone(),
                reference: refinement.reference().clone(),
                failing: judgement.failing(),
                rates: judgement.rates.clone(),
                reached: judgement.reached,
                evaluation: judgement.evaluation,
                unplayed: judgement.unplayed,
                round: number,
                chosen: round.chosen_stage,
                changes: round.changes,
                is_scenes_own,
            };
            self.remember(kept.clone());
            if judgement.rates.rollouts() == 0 {
                // The time is over.
                break;
            }
            let rate = judgement.rates.overall();
            self.session.tell(Event::Refined { rate });
            polished += usize::from(judgement.reached);
            let is_good = judgement.reached && (judgement.failures.is_empty() || polished > POLISHES);
            let is_lost = round.rate.is_none() && rate < least;
            vain = if round.rate.is_none_or(|best| rate > best) { 0 } else { vain + 1 };
            round.rate = Some(round.rate.map_or(rate, |best: f64| best.max(rate)));
            self.keep_if_best(kept, &round)?;
            until = self.extended(until, number, vain);
            let is_last = is_good || is_lost || vain == GIVEN_UP || !self.may_change() || self.clock.is_over(until);
            round.added_trials += judgement.failures.len();
            self.training.extend(judgement.failures.iter().map(|(trial, _)| *trial));
            refinement.add(judgement.failures);
            if is_last {
                break;
            }
        }
        self.least_failing = self.least_failing.min(refinement.failing_fraction());
        self.rounds.push(round);
        Ok(())
    }

    /// Until when a round goes on, after so many evaluations in a row without a better rate: what is the best so far and
    /// still becomes better, or is nearly robust, may take more than its share of the time.
    fn extended(&self, until: Deadline, round: usize, vain: usize) -> Deadline {
        let is_best = self.best.as_ref().is_some_and(|best| best.round == round);
        if is_best && (vain == 0 || self.is_nearly_robust()) && self.clock.is_over(until) {
            self.clock.share(self.clock.end(), OWN_SHARE)
        } else {
            until
        }
    }

    /// Improves until all training trials pass, it is stuck, all changes have been tried, or the time is over.
    pub(super) fn train(&mut self, refinement: &mut Refinement, changes: &mut usize, until: Deadline) {
        let (mut vain, mut last) = (0, refinement.score());
        while refinement.score().0 > 0 && vain < self.target.patience && self.may_change() && !self.clock.is_over(until)
        {
            self.tried += 1;
            *changes += usize::from(refinement.improve(&|| self.clock.is_over(until)));
            let (failing, miss) = refinement.score();
            if failing < last.0 || miss < CREEPING * last.1 {
                (vain, last) = (0, (failing, miss));
            } else {
                vain += 1;
            }
            self.session.tell(Event::Change { failing, trials: refinement.trials().len(), changes: *changes });
        }
    }

    /// Evaluates a reference at new grasp errors.
    pub(super) fn judge(&mut self, reference: &Reference, until: Deadline) -> Judgement {
        let evaluation = self.new_evaluation(EVALUATION);
        let stop = || self.clock.is_over(until);
        evaluation.judge(self.evaluator, reference, self.target.wanted_rate, &stop)
    }

    /// At most `count` random grasp errors per friction and magnitude, not played yet.
    pub(super) fn new_evaluation(&mut self, count: usize) -> Evaluation {
        self.evaluations += 1;
        let seed = SEED + SEED_STRIDE * self.evaluations;
        Evaluation::new(self.problem.task(), &self.range, &self.target.frictions, count, seed)
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use plan::{OffsetRegion, SuccessRate, SuccessRates, Variant};

    use super::*;
    use crate::tests::in_corner;

    #[test]
    fn what_is_nearly_robust_is_not_interrupted() {
        in_corner(Duration::from_secs(1000), |refiner| {
            let task = refiner.problem.task();
            let straight = Reference::straight(&task.start, &task.goal, task.horizon);
            refiner.judge_first(Variant::of_scene(refiner.problem), Vec::new(), 0, straight).unwrap();
            let (over, running) = (refiner.clock.share(refiner.clock.end(), 0.0), refiner.clock.end());
            let mut extends = |rate: f64, round: usize, vain: usize| {
                let rollouts = 100;
                let successes = (rate * rollouts as f64) as usize;
                let unplayed = SuccessRate::unplayed(0.0, 0.0, OffsetRegion::Hull, false);
                let group = SuccessRate { rollouts, successes, ..unplayed };
                refiner.best.as_mut().unwrap().rates = SuccessRates(vec![group]);
                assert_eq!(refiner.extended(running, round, vain), running, "it has time");
                refiner.extended(over, round, vain) > over
            };
            let best = 1;
            assert!(extends(0.8, best, 1), "nearly robust");
            assert!(!extends(0.5, best, 1), "neither nearly robust nor better than before");
            assert!(extends(0.5, best, 0), "better than before");
            assert!(!extends(0.8, best + 1, 0), "not the best");
        });
    }
}
