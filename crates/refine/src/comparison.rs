//! The last word: the latest references, compared in the same test cases.
//!
//! An evaluation ends as soon as it is decided, mostly after few test cases of its own. So its rate says whether a reference is
//! good enough, but hardly which of two is better.

use plan::{Event, PlannerError};
use simulation::Reference;

use crate::candidate::Kept;
use crate::evaluation::Judgement;
use crate::{Refiner, race};

impl Refiner<'_> {
    /// Takes note of a reference for the comparison.
    pub(super) fn remember(&mut self, kept: Kept) {
        if self.latest.len() == self.target.parameters.comparison.latest {
            self.latest.pop_front();
        }
        self.latest.push_back(kept);
    }

    /// Keeps the best of the latest and the best so far, unless that is robust or the time is over.
    pub(super) fn compare_latest(&mut self) -> Result<(), PlannerError> {
        let parameters = self.target.parameters.comparison;
        let Some(best) = self.best.clone().filter(|best| !best.reached) else { return Ok(()) };
        let mut compared = Vec::from(std::mem::take(&mut self.latest));
        if !compared.iter().any(|kept| (kept.round, kept.changes) == (best.round, best.changes)) {
            compared.insert(0, best);
        }
        if compared.len() < 2 {
            return Ok(());
        }
        let references: Vec<Reference> = compared.iter().map(|kept| kept.reference.clone()).collect();
        let evaluation = self.new_evaluation(parameters.random);
        let stop = || self.schedule.is_over(self.schedule.limit());
        let Some(winner) = race::race(self.evaluator, &references, (evaluation.cases(), parameters.first), &stop)
        else {
            return Ok(());
        };
        let judgement = evaluation.judgement(&winner.results, self.target.target_rate);
        let winner = compared.swap_remove(winner.index);
        self.session.tell(Event::Refined { rate: judgement.rates.overall() });
        let kept = if judgement.reached { self.decided(winner, judgement) } else { winner.judged(judgement) };
        self.keep(kept, self.rounds.clone())
    }

    /// The winner after a whole evaluation: the few test cases of the comparison decide against a reference, not for it. Where the
    /// time ends before that is decided, with the evaluation that knows most.
    fn decided(&mut self, winner: Kept, few: Judgement) -> Kept {
        let whole = self.judge(&winner.reference, self.schedule.limit());
        let played = whole.rates.rollouts();
        if whole.unplayed == 0 || played > few.rates.rollouts().max(winner.rates.rollouts()) {
            winner.judged(whole)
        } else if winner.unplayed > 0 {
            winner
        } else {
            winner.judged(Judgement { reached: false, unplayed: whole.unplayed, ..few })
        }
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use plan::parameters::ComparisonParameters;
    use plan::{OffsetRegion, SuccessRate, SuccessRates};
    use task::at_rest;

    use super::*;
    use crate::evaluation::Drawn;
    use crate::origin::Solved;
    use crate::tests::in_corner;

    /// What is kept after a comparison of a motion that stays at the start with a push to the goal.
    fn kept_in(time_limit: Duration) -> Kept {
        in_corner(time_limit, |refiner| {
            let task = refiner.problem.task();
            let solved = Solved { chosen: 1, ..refiner.of_scene() };
            let lucky = |reference: Reference, changes: usize, successes: usize| Kept {
                solved: solved.clone(),
                reference,
                rates: SuccessRates(vec![SuccessRate {
                    rollouts: 2,
                    successes,
                    ..SuccessRate::unplayed(0.0, 0.0, OffsetRegion::Hull, false)
                }]),
                reached: false,
                evaluation: Drawn::default(),
                unplayed: 0,
                failing: Vec::new(),
                round: 1,
                changes,
            };
            let resting = lucky(Reference::new(0.1, &[at_rest(&task.start); 3]), 1, 2);
            refiner.best = Some(resting.clone());
            refiner.remember(lucky(Reference::straight(&task.start, &task.goal, task.horizon), 2, 0));
            for changes in 3..refiner.target.parameters.comparison.latest + 2 {
                refiner.remember(Kept { changes, ..resting.clone() });
            }
            refiner.compare_latest().unwrap();
            refiner.take_best().unwrap()
        })
    }

    #[test]
    fn what_does_best_in_the_same_trials_is_kept_whatever_its_own_evaluation_said() {
        let kept = kept_in(Duration::from_secs(100));
        assert_eq!(kept.changes, 2);
        assert!(
            kept.rates.rollouts() > ComparisonParameters::default().first,
            "all cases of the evaluation: {}",
            kept.rates.rollouts()
        );
        assert!(kept.rates.overall() > 0.5, "{}", kept.rates.overall());
    }

    #[test]
    fn without_time_the_best_so_far_is_kept() {
        let kept = kept_in(Duration::ZERO);
        assert_eq!((kept.changes, kept.rates.rollouts()), (1, 2));
    }
}
