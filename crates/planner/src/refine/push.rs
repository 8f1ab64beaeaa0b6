//! A straight push as the reference to refine.

use simulation::{Reference, Refinement};

use crate::error::PlannerError;
use crate::iteration::PlanIteration;
use crate::refine::candidate::Candidate;
use crate::refine::{FIRST_SHARE, Refiner};
use crate::robustness::Round;
use crate::variant::Variant;

impl Refiner<'_> {
    /// Refines the straight push from start to goal: on some scenes this is faster than the refinement of any plan. The
    /// homotopy of the scene stays the one that is shown.
    pub(super) fn refine_push(&mut self, homotopy: Vec<PlanIteration>) -> Result<(), PlannerError> {
        let until = self.clock.share(self.clock.end(), FIRST_SHARE);
        let task = self.problem.task();
        let reference = Reference::straight(&task.start, &task.goal, task.horizon);
        if !self.goes_on(until) || !self.evaluator.bounds().allow(&reference) {
            return Ok(());
        }
        let stop = || self.clock.is_over(until);
        let results = self.evaluator.evaluate_all(&reference, &self.training, self.session.threads, &stop);
        let Some(results) = results else { return Ok(()) };
        let variant = Variant { name: "a straight push".to_owned(), ..Variant::of_scene(self.problem) };
        let round = Round { rollouts: results.len(), ..Round::new(&variant, &homotopy, 0, &results) };
        let refinement = Refinement::new(self.evaluator, reference, self.training.clone(), results, self.seed);
        self.refine(Candidate { variant, iterations: homotopy, refinement, round, is_scenes_own: true }, until)
    }
}
