//! A straight push as the reference to refine.

use simulation::Reference;

use crate::error::PlannerError;
use crate::iteration::PlanIteration;
use crate::refine::Refiner;
use crate::variant::Variant;

/// Share of the time that is left.
const SHARE: f64 = 0.4;

impl Refiner<'_> {
    /// Refines the straight push from start to goal: on some scenes this is faster than the refinement of any plan. The
    /// homotopy of the scene stays the one that is shown.
    pub(super) fn refine_push(&mut self, homotopy: Vec<PlanIteration>) -> Result<(), PlannerError> {
        let until = self.clock.share(self.clock.end(), SHARE);
        let task = self.problem.task();
        let reference = Reference::straight(&task.start, &task.goal, task.horizon);
        if !self.goes_on(until) || !self.evaluator.bounds().allow(&reference) {
            return Ok(());
        }
        let variant = Variant { name: "a straight push".to_owned(), ..Variant::of_scene(self.problem) };
        let Some(best) = self.best_of(&[reference], until) else { return Ok(()) };
        self.change_seed();
        let candidate = self.candidate_of(best, variant, (homotopy, 0), true);
        self.refine(candidate, until, 0.0)
    }
}
