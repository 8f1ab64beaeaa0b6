//! The training set, and the perturbations of references in it.

use plan::parameters::TrainingParameters;
use plan::{Event, Round};
use simulation::{FinalOscillation, Reference, Refinement, TestCase, TestResult};

use crate::candidate::{Candidate, round};
use crate::ends::{self, Best, best_end};
use crate::evaluation::{ErrorRange, Evaluation};
use crate::origin::Solved;
use crate::race::Heats;
use crate::schedule::{Deadline, Schedule};
use crate::setting::Setting;

/// Test cases that every reference is refined in, and what refinement in them has come to.
pub struct Training<'run> {
    setting: Setting<'run>,
    /// The oscillation, where dry friction may hold the body short of its goal.
    oscillation: Option<FinalOscillation>,
    /// The training set; what fails in evaluations is added.
    pub cases: Vec<TestCase>,
    /// Changes of references that were tried.
    pub tried: usize,
    /// Seed of the perturbations.
    pub seed: u64,
    /// Smallest fraction of the training set that failed after a refinement.
    pub least_failing: f64,
}

impl<'run> Training<'run> {
    /// With the first training set.
    pub fn new(setting: Setting<'run>) -> Self {
        let Setting { problem, target, .. } = setting;
        let (count, seed) = (target.parameters.training.random, target.parameters.seeds.first);
        let range = ErrorRange::new(problem, target);
        let evaluation = Evaluation::new(problem.task(), &range, &target.frictions, count, seed);
        Self {
            setting,
            oscillation: ends::final_oscillation(problem, target),
            cases: evaluation.into_training(&range),
            tried: 0,
            seed,
            least_failing: 1.0,
        }
    }

    /// Whether perturbations are requested, and not all of them have been tried.
    pub fn may_perturb(&self) -> bool {
        let target = self.setting.target;
        target.stall_limit > 0 && target.max_perturbations.is_none_or(|most| self.tried < most)
    }

    /// Results of a reference in the training set. `None` when `stop` returned true before the end.
    pub fn play(&self, reference: &Reference, stop: &(dyn Fn() -> bool + Sync)) -> Option<Vec<TestResult>> {
        self.setting.trainer.evaluate_all(reference, &self.cases, stop)
    }

    /// The refinement of a reference, which has these results in the training set.
    pub fn refinement(&self, reference: Reference, results: Vec<TestResult>) -> Refinement<'run> {
        Refinement::new(self.setting.trainer, reference, self.cases.clone(), results, self.seed)
    }

    /// The best of several references in the training set, each as it is and with a final oscillation. `None` without
    /// references, or when `stop` returned true before the end.
    pub fn best_of(&self, references: &[Reference], stop: &(dyn Fn() -> bool + Sync)) -> Option<Best> {
        self.best_of_first(self.cases.len(), references, stop)
    }

    /// The same in a number of the first test cases.
    pub fn best_of_first(
        &self,
        count: usize,
        references: &[Reference],
        stop: &(dyn Fn() -> bool + Sync),
    ) -> Option<Best> {
        let (cases, first) = (&self.cases[..count.min(self.cases.len())], self.parameters().first);
        best_end(self.setting.trainer, self.oscillation.as_ref(), references, Heats { cases, first }, stop)
    }

    /// The candidate of the best reference, which is that of the chosen homotopy step of a solved problem.
    pub fn candidate(&self, best: Best, mut solved: Solved) -> Candidate<'run> {
        let Best { winner, reference, has_oscillation } = best;
        solved.marks.has_oscillation = has_oscillation;
        let round = Round { rollouts: winner.rollouts, ..round(&solved, &winner.results) };
        Candidate { refinement: self.refinement(reference, winner.results), solved, round }
    }

    /// Adds to a refinement what has failed elsewhere since it became a candidate.
    pub fn update(&self, refinement: &mut Refinement, stop: &(dyn Fn() -> bool + Sync)) {
        let new = self.cases[refinement.cases().len()..].to_vec();
        let results = self.setting.trainer.evaluate_all(refinement.reference(), &new, stop);
        refinement.add(new.into_iter().zip(results.into_iter().flatten()));
    }

    /// Improves a reference until the whole training set passes, it stalls, all perturbations have been tried, or the
    /// time is over. `perturbations` counts accepted perturbations.
    pub fn improve(
        &mut self,
        refinement: &mut Refinement,
        perturbations: &mut usize,
        schedule: &Schedule<'_>,
        until: Deadline,
    ) {
        let Setting { target, session, .. } = self.setting;
        let (mut stalled, mut last) = (0, refinement.score());
        while refinement.score().0 > 0 && stalled < target.stall_limit && self.may_perturb() && !schedule.is_over(until)
        {
            self.tried += 1;
            *perturbations += usize::from(refinement.improve(&|| schedule.is_over(until)));
            let (failing, violation) = refinement.score();
            if failing < last.0 || violation < self.parameters().creeping * last.1 {
                (stalled, last) = (0, (failing, violation));
            } else {
                stalled += 1;
            }
            session.tell(Event::Perturbation { failing, cases: refinement.cases().len(), accepted: *perturbations });
        }
    }

    fn parameters(&self) -> TrainingParameters {
        self.setting.target.parameters.training
    }
}
