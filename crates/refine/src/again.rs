//! Refinement of the best plan so far, once more.

use plan::{PlannerError, Round};

use crate::candidate::{Candidate, Evaluated, round};
use crate::refining::refine;
use crate::schedule::Deadline;
use crate::search::Search;

/// Refines the best plan so far again, if it fails so rarely that this helps more than another plan.
pub fn refine_if_nearly_robust(search: &mut Search) -> Result<(), PlannerError> {
    if search.is_nearly_robust() { refine_again(search) } else { Ok(()) }
}

/// Refines the best plan so far again as long as this helps: other perturbations often help where some did not, and
/// they cost less than another problem.
pub fn refine_again(search: &mut Search) -> Result<(), PlannerError> {
    let (mut before, until) = (-1.0, search.schedule.end());
    while search.found.rate() > before && search.goes_on(until) {
        before = search.found.rate();
        refine_best(search, until)?;
    }
    Ok(())
}

/// Refines the best plan so far again, with other perturbations than before.
pub fn refine_best(search: &mut Search, until: Deadline) -> Result<(), PlannerError> {
    let Some(best) = search.found.best.clone().filter(|_| search.goes_on(until)) else { return Ok(()) };
    let Evaluated { mut solved, reference, .. } = best;
    solved.marks.is_continued |= !solved.marks.has_margins;
    let Some(results) = search.training.play(&reference, &|| search.schedule.is_over(until)) else { return Ok(()) };
    let round = Round { rollouts: results.len(), ..round(&solved, &results) };
    search.training.seed = search.judge.seed();
    let refinement = search.training.refinement(reference, results);
    refine(search, Candidate { solved, refinement, round }, until, 0.0)
}
