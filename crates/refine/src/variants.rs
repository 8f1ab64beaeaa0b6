//! Plans of other problems than the scene's own.

use std::time::Duration;

use plan::{Event, HomotopyRun, PlannerError, Variant};
use task::GraspError;

use crate::Refiner;
use crate::candidate::Candidate;
use crate::origin::{Origin, Solved};
use crate::portfolio::{PORTFOLIO, Recipe};
use crate::schedule::Deadline;

impl<'run> Refiner<'run> {
    /// Solves variants of the problem one after the other, each in its share of the time. One whose plan fails in fewer
    /// training cases than the best so far is refined at once, the others when all are solved, the best first.
    /// `solving` is the time that the scene's own problem took: no more are begun than can be solved in such a time.
    pub(super) fn refine_variants(&mut self, solving: Duration) -> Result<(), PlannerError> {
        let mut waiting: Vec<Candidate> = Vec::new();
        let count = self.schedule.affordable_variants(solving).min(PORTFOLIO.len());
        for (index, recipe) in PORTFOLIO.into_iter().take(count).enumerate() {
            let until = self.schedule.one_of(count - index);
            if !self.goes_on(until) {
                break;
            }
            let Some(candidate) = self.solve_variant(recipe, (index + 1, count), until)? else { continue };
            if candidate.refinement.failing_fraction() < self.least_failing {
                self.refine(candidate, until, 0.0)?;
            } else {
                waiting.push(candidate);
            }
        }
        waiting.sort_by(|one, other| one.refinement.failing_fraction().total_cmp(&other.refinement.failing_fraction()));
        let count = waiting.len();
        for (index, candidate) in waiting.into_iter().enumerate() {
            let until = self.schedule.one_of(count - index);
            if self.goes_on(until) {
                self.refine(candidate, until, 0.0)?;
            } else {
                self.rounds.push(candidate.round);
            }
        }
        Ok(())
    }

    /// Solves a variant, given by its number among all that are solved. `None` when nothing of its homotopy was finished in time.
    fn solve_variant(
        &self,
        recipe: Recipe,
        (number, count): (usize, usize),
        until: Deadline,
    ) -> Result<Option<Candidate<'run>>, PlannerError> {
        let Some(best) = &self.best else { return Ok(None) };
        let failing: Vec<GraspError> = best.failing.iter().map(|case| case.grasp).collect();
        let variant = recipe.variant(
            &Variant::of_scene(self.problem),
            &best.reference,
            &failing,
            &self.target.parameters.portfolio,
        );
        self.session.tell(Event::Variant { name: &recipe.to_string(), number, count });
        let solving = self.schedule.solving(until);
        let run = HomotopyRun { threads: self.session.threads, ..HomotopyRun::new(&variant) };
        // What has finished until then may do.
        let iterations = run.finished(self.session, || self.schedule.is_over(solving))?;
        let status = iterations.last().map_or("no homotopy step in time", |last| &last.record.status);
        self.session.tell(Event::VariantSolved { status });
        let candidate = self.candidate(Solved::new(Origin::Variant(recipe), variant, iterations), until);
        if let Some(Candidate { round, .. }) = &candidate {
            let (failing, cases) = (round.training_failures, round.training_cases);
            self.session.tell(Event::VariantTried { failing, cases });
        }
        Ok(candidate)
    }
}
