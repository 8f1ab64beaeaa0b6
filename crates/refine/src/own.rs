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
use crate::simple::{judge_simple, or_simple};

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

/// Evaluates simple motions, and refines the best of them unless it is good enough. False
/// without simple motions or time.
fn refine_unsolved(search: &mut Search, plan: &Plan, solving: Duration) -> Result<bool, PlannerError> {
    let Some(simple) = judge_simple(search, &plan.iterations, search.schedule.own())? else { return Ok(false) };
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
    // The round of the candidate replaces that of its first evaluation.
    search.found.rounds.pop();
    refine_better(search, candidate, solving)
}
