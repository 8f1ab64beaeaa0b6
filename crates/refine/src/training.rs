//! Refinement of one reference and its evaluation, in turn.

use std::time::Instant;

use plan::{Event, PlannerError};
use simulation::{Reference, Refinement};

use crate::Refiner;
use crate::candidate::{Candidate, Kept};
use crate::evaluation::{Evaluation, Judgement};
use crate::schedule::Deadline;

impl<'run> Refiner<'run> {
    /// Refines a reference and evaluates it, until it is good enough, given up, all changes have been tried, or the time is
    /// over, which may be [extended](Self::extended). It is given up at once if a smaller fraction than `least` of the
    /// test cases of its first evaluation succeeds. Rates of evaluations that end early vary, so that a lower one is no reason to
    /// go back. What is robust, but fails in some test cases, is refined in these a few times more: simulators differ, and so
    /// does reality.
    pub(super) fn refine(
        &mut self,
        candidate: Candidate<'run>,
        mut until: Deadline,
        least: f64,
    ) -> Result<(), PlannerError> {
        let (begin, parameters) = (Instant::now(), self.target.parameters.training);
        let Candidate { solved, mut refinement, mut round } = candidate;
        self.session.tell(Event::Refining { planned: &round.planned });
        let chosen_with = round.rollouts;
        let (mut polished, mut vain) = (0, 0);
        // What failed elsewhere since it became a candidate.
        let new = self.training[refinement.cases().len()..].to_vec();
        let results = self.trainer.evaluate_all(refinement.reference(), &new, &|| self.schedule.is_over(until));
        refinement.add(new.into_iter().zip(results.into_iter().flatten()));
        loop {
            self.train(&mut refinement, &mut round.changes, self.schedule.training(until));
            round.rollouts = chosen_with + refinement.rollouts();
            round.refinement_s = begin.elapsed().as_secs_f64();
            // Whatever the share of the time: an evaluation that takes long is one that may succeed.
            let judgement = self.judge(refinement.reference(), self.schedule.end());
            let number = self.rounds.len() + 1;
            let kept = Kept {
                solved: solved.clone(),
                reference: refinement.reference().clone(),
                failing: judgement.failing(),
                rates: judgement.rates.clone(),
                reached: judgement.reached,
                evaluation: judgement.evaluation,
                unplayed: judgement.unplayed,
                round: number,
                changes: round.changes,
            };
            self.remember(kept.clone());
            if judgement.rates.rollouts() == 0 {
                // The time is over.
                break;
            }
            let rate = judgement.rates.overall();
            self.session.tell(Event::Refined { rate });
            polished += usize::from(judgement.reached);
            let is_good = judgement.reached && (judgement.failures.is_empty() || polished > parameters.polishes);
            let is_lost = round.rate.is_none() && rate < least;
            vain = if round.rate.is_none_or(|best| rate > best) { 0 } else { vain + 1 };
            round.rate = Some(round.rate.map_or(rate, |best: f64| best.max(rate)));
            self.keep_if_best(kept, &round)?;
            until = self.extended(until, number, vain);
            let is_last =
                is_good || is_lost || vain == parameters.given_up || !self.may_change() || self.schedule.is_over(until);
            round.added_cases += judgement.failures.len();
            self.training.extend(judgement.failures.iter().map(|(case, _)| *case));
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
        if is_best && (vain == 0 || self.is_nearly_robust()) && self.schedule.is_over(until) {
            self.schedule.own()
        } else {
            until
        }
    }

    /// Improves until all training cases pass, it is stuck, all changes have been tried, or the time is over.
    pub(super) fn train(&mut self, refinement: &mut Refinement, changes: &mut usize, until: Deadline) {
        let (mut vain, mut last) = (0, refinement.score());
        while refinement.score().0 > 0
            && vain < self.target.stall_limit
            && self.may_change()
            && !self.schedule.is_over(until)
        {
            self.tried += 1;
            *changes += usize::from(refinement.improve(&|| self.schedule.is_over(until)));
            let (failing, violation) = refinement.score();
            if failing < last.0 || violation < self.target.parameters.training.creeping * last.1 {
                (vain, last) = (0, (failing, violation));
            } else {
                vain += 1;
            }
            self.session.tell(Event::Change { failing, cases: refinement.cases().len(), changes: *changes });
        }
    }

    /// Evaluates a reference at new grasp errors.
    pub(super) fn judge(&mut self, reference: &Reference, until: Deadline) -> Judgement {
        let evaluation = self.new_evaluation(self.target.parameters.evaluation.random);
        let stop = || self.schedule.is_over(until);
        evaluation.judge(self.evaluator, reference, self.target.target_rate, &stop)
    }

    /// Where the random numbers of the latest evaluation begin.
    pub(super) fn seed_of_evaluation(&self) -> u64 {
        let seeds = self.target.parameters.seeds;
        seeds.first + seeds.stride * self.evaluations
    }

    /// At most `count` random grasp errors per friction and magnitude, not played yet.
    pub(super) fn new_evaluation(&mut self, count: usize) -> Evaluation {
        self.evaluations += 1;
        let seed = self.seed_of_evaluation();
        Evaluation::new(self.problem.task(), &self.range, &self.target.frictions, count, seed)
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use plan::{OffsetRegion, SuccessRate, SuccessRates};

    use super::*;
    use crate::tests::in_corner;

    #[test]
    fn what_is_nearly_robust_is_not_interrupted() {
        in_corner(Duration::from_secs(1000), |refiner| {
            let task = refiner.problem.task();
            let straight = Reference::straight(&task.start, &task.goal, task.horizon);
            refiner.judge_first(refiner.of_scene(), straight).unwrap();
            let (over, running) = (refiner.schedule.one_of(usize::MAX), refiner.schedule.end());
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
