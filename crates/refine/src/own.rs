//! The plan of the scene itself, or what an earlier run has made of it.

use std::time::Duration;

use plan::{Event, Plan, PlannerError, Stop};

use crate::again::refine_best;
use crate::candidate::Candidate;
use crate::drafts::refine_better;
use crate::first::judge_first;
use crate::origin::{Origin, Solved};
use crate::resume::{earlier_work, restore};
use crate::search::Search;
use crate::simple::{best_simple, earlier, or_simple, simple_motions};

/// Evaluates the plan of the scene, and refines it, or a simple motion, unless it is good enough; margins follow later. Or
/// resumes an earlier run. `solving` is the time that the plan took.
pub fn refine_own(search: &mut Search, plan: Plan, solving: Duration) -> Result<(), PlannerError> {
    if let Some(best) = earlier_work(search)?.and_then(|checkpoint| restore(search, checkpoint, &plan)) {
        let count = plan.iterations.len();
        search.setting.session.tell(Event::Resumed { done: count, most: count, refining: true });
        search.found.best = Some(best);
        return refine_best(search, search.schedule.own());
    }
    if plan.stopped == Some(Stop::Unsolved) && refine_unsolved(search, &plan, solving)? {
        return Ok(());
    }
    let chosen = plan.chosen_stage();
    let solved = Solved { chosen, ..Solved::new(Origin::Scene, plan.variant, plan.iterations) };
    judge_first(search, solved.clone(), solved.reference(chosen - 1))?;
    let until = search.schedule.own();
    if search.goes_on(until)
        && let Some(candidate) = search.candidate(solved, until)
    {
        let candidate = or_simple(search, candidate, until);
        refine_first(search, candidate, solving)?;
    }
    Ok(())
}

/// Evaluates the earlier plan, or else the best simple motion, and refines the best of these unless it is good enough. False
/// where there is neither.
fn refine_unsolved(search: &mut Search, plan: &Plan, solving: Duration) -> Result<bool, PlannerError> {
    let (earlier, until) = (earlier(search), search.schedule.own());
    if let Some(earlier) = &earlier {
        let solved = Solved::new(Origin::Earlier, plan.variant.clone(), plan.iterations.clone());
        judge_first(search, solved, earlier.clone())?;
        if !search.goes_on(until) {
            return Ok(true);
        }
    }
    let Some(simple) = best_simple(search, simple_motions(search), &plan.iterations, until) else {
        return Ok(earlier.is_some());
    };
    if earlier.is_none() {
        judge_first(search, simple.solved.clone(), simple.refinement.reference().clone())?;
    }
    refine_first(search, simple, solving)?;
    Ok(true)
}

/// Refines the first candidate unless its evaluation was good enough.
fn refine_first<'run>(
    search: &mut Search<'run>,
    candidate: Candidate<'run>,
    solving: Duration,
) -> Result<(), PlannerError> {
    if !search.goes_on(search.schedule.own()) {
        return Ok(());
    }
    // The round of the candidate replaces that of the first evaluation.
    search.found.rounds.clear();
    refine_better(search, candidate, solving)
}
