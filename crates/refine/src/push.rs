//! A straight push as the reference to refine.

use plan::{PlanIteration, PlannerError, Problem, PushReport, Variant};
use simulation::{Evaluator, Reference};

use crate::Refiner;
use crate::candidate::Kept;
use crate::evaluation::{Drawn, Evaluation};
use crate::origin::{Origin, Solved};

impl Refiner<'_> {
    /// Refines the straight push from start to goal: on some scenes this is faster than the refinement of any plan. The
    /// homotopy of the scene stays the one that is shown.
    pub(super) fn refine_push(&mut self, homotopy: Vec<PlanIteration>) -> Result<(), PlannerError> {
        let until = self.schedule.push();
        let task = self.problem.task();
        let reference = Reference::straight(&task.start, &task.goal, task.horizon);
        if !self.goes_on(until) || !self.evaluator.bounds().allow(&reference) {
            return Ok(());
        }
        let solved = Solved::new(Origin::Push, Variant::of_scene(self.problem), homotopy);
        let Some(best) = self.best_of(&[reference], until) else { return Ok(()) };
        self.change_seed();
        let candidate = self.candidate_of(best, solved);
        self.refine(candidate, until, 0.0)
    }

    /// How the straight push does, unrefined, in the evaluation of a plan. `None` where the time is over.
    pub(super) fn judge_push(&self, plan: &Kept) -> Option<PushReport> {
        let Drawn { random, seed } = plan.evaluation;
        let evaluation = Evaluation::new(self.problem.task(), &self.range, &self.target.frictions, random, seed);
        let stop = || self.schedule.is_over(self.schedule.limit());
        judge_push(self.problem, self.evaluator, &evaluation, self.target.target_rate, &stop)
    }
}

/// How a straight push of a problem does in an evaluation, of which it is wanted to pass a share (0 to 1) at each friction.
/// `None` where `stop` returned true before that was decided.
pub(super) fn judge_push(
    problem: &Problem,
    evaluator: &Evaluator,
    evaluation: &Evaluation,
    wanted: f64,
    stop: &(dyn Fn() -> bool + Sync),
) -> Option<PushReport> {
    let task = problem.task();
    let push = Reference::straight(&task.start, &task.goal, task.horizon);
    let judgement = evaluation.judge(evaluator, &push, wanted, stop);
    (judgement.unplayed == 0).then_some(PushReport { reached: judgement.reached, rates: judgement.rates })
}
