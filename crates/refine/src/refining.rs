//! One reference, refined and evaluated in turn.

use std::time::Instant;

use plan::{Event, PlannerError, Round};
use simulation::{Refinement, TestCase, TestResult};

use crate::candidate::{Candidate, Evaluated};
use crate::evaluation::Judgement;
use crate::keep::keep_if_best;
use crate::origin::Solved;
use crate::schedule::Deadline;
use crate::search::Search;

/// Refines a reference and evaluates it, until it is robust, given up, all perturbations have been tried, or the time is
/// over, which may be [extended](Refining::extend). It is given up at once if a smaller fraction than `least` of its first
/// evaluation succeeds. Rates of evaluations that end early vary, so that a lower one is no reason to go back.
pub fn refine<'run>(
    search: &mut Search<'run>,
    candidate: Candidate<'run>,
    until: Deadline,
    least: f64,
) -> Result<(), PlannerError> {
    let mut refining = Refining::begin(search, candidate, until);
    loop {
        refining.train(search);
        // Not limited by the share of the time: a long evaluation is one that may succeed.
        let judgement = search.judge(refining.refinement.reference(), search.schedule.end());
        let evaluated = refining.evaluated(&judgement);
        search.found.remember(evaluated.clone(), search.setting.target.parameters.comparison.latest);
        if judgement.rates.rollouts() == 0 {
            // The time is over.
            break;
        }
        search.tell_refined(&judgement);
        refining.count(&judgement);
        keep_if_best(search, evaluated, &refining.round)?;
        refining.extend(search);
        let is_finished = refining.is_finished(search, &judgement, least);
        refining.add(search, judgement.failures);
        if is_finished {
            break;
        }
    }
    refining.finish(search);
    Ok(())
}

/// A reference between training and evaluation.
struct Refining<'run> {
    solved: Solved,
    refinement: Refinement<'run>,
    round: Round,
    /// Number of the round, from 1.
    number: usize,
    until: Deadline,
    begin: Instant,
    /// Rollouts that it was chosen with.
    chosen_with: usize,
    evaluations: usize,
    /// Evaluations in a row without a better rate.
    stalled: usize,
}

impl<'run> Refining<'run> {
    /// Starts with the whole training set.
    fn begin(search: &Search<'run>, candidate: Candidate<'run>, until: Deadline) -> Self {
        let begin = Instant::now();
        let Candidate { solved, mut refinement, round } = candidate;
        search.setting.session.tell(Event::Refining { planned: &round.planned });
        search.training.update(&mut refinement, &|| search.schedule.is_over(until));
        let (number, chosen_with) = (search.found.rounds.len() + 1, round.rollouts);
        Self { solved, refinement, round, number, until, begin, chosen_with, evaluations: 0, stalled: 0 }
    }

    fn train(&mut self, search: &mut Search) {
        let until = search.schedule.training(self.until);
        search.training.improve(&mut self.refinement, &mut self.round.perturbations, &search.schedule, until);
        self.round.rollouts = self.chosen_with + self.refinement.rollouts();
        self.round.refinement_s = self.begin.elapsed().as_secs_f64();
    }

    fn evaluated(&self, judgement: &Judgement) -> Evaluated {
        let (solved, reference) = (self.solved.clone(), self.refinement.reference().clone());
        Evaluated::new(solved, reference, judgement, self.number, self.round.perturbations)
    }

    /// Takes note of how often it has succeeded.
    fn count(&mut self, judgement: &Judgement) {
        let rate = judgement.rates.overall();
        self.evaluations += 1;
        self.stalled = if self.round.rate.is_none_or(|best| rate > best) { 0 } else { self.stalled + 1 };
        self.round.rate = Some(self.round.rate.map_or(rate, |best: f64| best.max(rate)));
    }

    /// The best plan so far may exceed its share of the time while it improves or is nearly robust.
    fn extend(&mut self, search: &Search) {
        let is_best = search.found.best.as_ref().is_some_and(|best| best.round == self.number);
        if is_best && (self.stalled == 0 || search.is_nearly_robust()) && search.schedule.is_over(self.until) {
            self.until = search.schedule.own();
        }
    }

    fn is_finished(&self, search: &Search, judgement: &Judgement, least: f64) -> bool {
        let parameters = search.setting.target.parameters.training;
        let is_lost = self.evaluations == 1 && judgement.rates.overall() < least;
        let is_stalled = self.stalled == parameters.given_up;
        judgement.reached
            || is_lost
            || is_stalled
            || !search.training.may_perturb()
            || search.schedule.is_over(self.until)
    }

    /// Adds failures to the training set.
    fn add(&mut self, search: &mut Search, failures: Vec<(TestCase, TestResult)>) {
        self.round.added_cases += failures.len();
        search.training.cases.extend(failures.iter().map(|(case, _)| *case));
        self.refinement.add(failures);
    }

    fn finish(self, search: &mut Search) {
        search.training.least_failing = search.training.least_failing.min(self.refinement.failing_fraction());
        search.found.rounds.push(self.round);
    }
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use plan::{OffsetRegion, SuccessRate, SuccessRates};
    use simulation::Reference;

    use super::*;
    use crate::first::judge_first;
    use crate::tests::{in_corner, of_scene};

    #[test]
    fn what_is_nearly_robust_is_not_interrupted() {
        in_corner(Duration::from_secs(1000), |search| {
            let task = search.setting.problem.task();
            let straight = Reference::straight(&task.start, &task.goal, task.horizon);
            judge_first(search, of_scene(search), straight.clone()).unwrap();
            let (over, running) = (search.schedule.one_of(usize::MAX), search.schedule.end());
            let best = search.training.best_of(&[straight], &|| false).unwrap();
            let mut refining = Refining::begin(search, search.training.candidate(best, of_scene(search)), running);
            let mut extends = |rate: f64, number: usize, stalled: usize| {
                let rollouts = 100;
                let successes = (rate * rollouts as f64) as usize;
                let unplayed = SuccessRate::unplayed(0.0, 0.0, OffsetRegion::Hull, false);
                let group = SuccessRate { rollouts, successes, ..unplayed };
                search.found.best.as_mut().unwrap().rates = SuccessRates(vec![group]);
                (refining.number, refining.stalled) = (number, stalled);
                let mut extended = |until: Deadline| {
                    refining.until = until;
                    refining.extend(search);
                    refining.until
                };
                assert_eq!(extended(running), running, "it has time");
                extended(over) > over
            };
            let best = 1;
            assert!(extends(0.8, best, 1), "nearly robust");
            assert!(!extends(0.5, best, 1), "neither nearly robust nor better than before");
            assert!(extends(0.5, best, 0), "better than before");
            assert!(!extends(0.8, best + 1, 0), "not the best");
        });
    }
}
