//! Refinement of the best plan so far, once more.

use plan::{PlannerError, Round};
use simulation::Refinement;

use crate::candidate::{Candidate, Kept};
use crate::schedule::Deadline;
use crate::{Refiner, round};

impl Refiner<'_> {
    /// Goes on with the best plan so far, where it fails so seldom that this helps more than another plan.
    pub(super) fn refine_if_nearly_robust(&mut self) -> Result<(), PlannerError> {
        if self.is_nearly_robust() { self.refine_again() } else { Ok(()) }
    }

    /// Whether the best plan so far fails seldom.
    pub(super) fn is_nearly_robust(&self) -> bool {
        self.best.as_ref().is_some_and(|best| best.rates.overall() >= self.target.parameters.training.nearly_robust)
    }

    /// Goes on with the best plan so far as long as this helps: other changes often help where some did not, and they cost
    /// less than another problem.
    pub(super) fn refine_again(&mut self) -> Result<(), PlannerError> {
        let rate = |refiner: &Self| refiner.best.as_ref().map_or(0.0, |best| best.rates.overall());
        let (mut before, until) = (-1.0, self.schedule.end());
        while rate(self) > before && self.goes_on(until) {
            before = rate(self);
            self.refine_best(until)?;
        }
        Ok(())
    }

    /// Goes on with the best plan so far, with other changes than before.
    pub(super) fn refine_best(&mut self, until: Deadline) -> Result<(), PlannerError> {
        let Some(best) = self.best.clone().filter(|_| self.goes_on(until)) else { return Ok(()) };
        let Kept { mut solved, reference, .. } = best;
        solved.marks.is_continued |= !solved.marks.has_margins;
        let results = self.trainer.evaluate_all(&reference, &self.training, &|| self.schedule.is_over(until));
        let Some(results) = results else { return Ok(()) };
        let round = Round { rollouts: results.len(), ..round(&solved, &results) };
        self.change_seed();
        let refinement = Refinement::new(self.trainer, reference, self.training.clone(), results, self.seed);
        self.refine(Candidate { solved, refinement, round }, until, 0.0)
    }

    /// Other changes follow than before.
    pub(super) fn change_seed(&mut self) {
        self.seed = self.seed_of_evaluation();
    }
}
