//! A straight push as the reference to refine.

use plan::{PlanIteration, PlannerError, Problem, PushReport, Variant};
use simulation::Evaluator;

use crate::evaluation::{Evaluation, Wanted};
use crate::origin::{Origin, Solved};
use crate::refining::refine;
use crate::search::Search;
use crate::simple::straight_push;

/// Refines the straight push from start to goal: on some scenes this is faster than the refinement of any plan. The homotopy
/// of the scene stays the one that is shown.
pub fn refine_push(search: &mut Search, homotopy: Vec<PlanIteration>) -> Result<(), PlannerError> {
    let until = search.schedule.push();
    let push = straight_push(search.setting.problem);
    if !search.goes_on(until) || !search.setting.evaluator.bounds().allow(&push) {
        return Ok(());
    }
    let solved = Solved::new(Origin::Push, Variant::of_scene(search.setting.problem), homotopy);
    let Some(best) = search.training.best_of(&[push], &|| search.schedule.is_over(until)) else { return Ok(()) };
    search.training.seed = search.judge.seed();
    let candidate = search.training.candidate(best, solved);
    refine(search, candidate, until, 0.0)
}

/// The judgement of a straight push in an evaluation. `None` where `stop`
/// returned true before it was decided.
pub fn judge_push(
    problem: &Problem,
    evaluator: &Evaluator,
    evaluation: &Evaluation,
    wanted: Wanted,
    stop: &(dyn Fn() -> bool + Sync),
) -> Option<PushReport> {
    let judgement = evaluation.judge(evaluator, &straight_push(problem), wanted, stop);
    (judgement.unplayed == 0).then_some(PushReport { reached: judgement.reached, rates: judgement.rates })
}
