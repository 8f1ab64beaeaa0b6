//! The plan of the scene itself, or what an earlier run has made of it.

use std::time::Duration;

use plan::{Event, Plan, PlannerError};

use crate::again::refine_best;
use crate::drafts::refine_better;
use crate::first::judge_first;
use crate::origin::{Origin, Solved};
use crate::resume::{earlier_work, restore};
use crate::search::Search;
use crate::spiral::or_spiral;

/// Evaluates the plan of the scene, and refines it, or a spiral search, unless it is good enough; margins follow later. Or resumes an
/// earlier run. `solving` is the time that the plan took.
pub fn refine_own(search: &mut Search, plan: Plan, solving: Duration) -> Result<(), PlannerError> {
    if let Some(best) = earlier_work(search)?.and_then(|checkpoint| restore(search, checkpoint, &plan)) {
        let count = plan.iterations.len();
        search.setting.session.tell(Event::Resumed { done: count, most: count, refining: true });
        search.found.best = Some(best);
        return refine_best(search, search.schedule.own());
    }
    let (last, chosen) = (plan.reference(), plan.chosen_stage());
    let solved = Solved { chosen, ..Solved::new(Origin::Scene, plan.variant, plan.iterations) };
    judge_first(search, solved.clone(), last)?;
    let until = search.schedule.own();
    if search.goes_on(until)
        && let Some(candidate) = search.candidate(solved, until)
    {
        // The round of the candidate replaces that of the first evaluation.
        search.found.rounds.clear();
        let candidate = or_spiral(search, candidate, until);
        refine_better(search, candidate, solving)?;
    }
    Ok(())
}
