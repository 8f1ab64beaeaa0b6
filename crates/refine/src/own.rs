//! The plan of the scene itself, or what an earlier run has made of it.

use std::time::Duration;

use plan::{Event, Plan, PlannerError, Stop};
use simulation::Reference;

use crate::again::refine_best;
use crate::candidate::Candidate;
use crate::drafts::refine_better;
use crate::first::judge_first;
use crate::origin::{Origin, Solved};
use crate::resume::{earlier_work, restore};
use crate::schedule::Deadline;
use crate::search::Search;
use crate::simple::{or_simple, simple_motions};

/// Evaluates the plan of the scene, and refines it, or a simple motion, unless it is good enough; margins follow later. Or resumes an
/// earlier run. `solving` is the time that the plan took.
pub fn refine_own(search: &mut Search, plan: Plan, solving: Duration) -> Result<(), PlannerError> {
    if let Some(best) = earlier_work(search)?.and_then(|checkpoint| restore(search, checkpoint, &plan)) {
        let count = plan.iterations.len();
        search.setting.session.tell(Event::Resumed { done: count, most: count, refining: true });
        search.found.best = Some(best);
        return refine_best(search, search.schedule.own());
    }
    let first = First::of(search, plan);
    judge_first(search, first.solved.clone(), first.reference.clone())?;
    let until = search.schedule.own();
    if search.goes_on(until)
        && let Some(candidate) = first.candidate(search, until)
    {
        // The round of the candidate replaces that of the first evaluation.
        search.found.rounds.clear();
        let candidate = or_simple(search, candidate, until);
        refine_better(search, candidate, solving)?;
    }
    Ok(())
}

/// What refinement begins with: the last homotopy step, or a simple motion where nothing had to be solved.
struct First {
    solved: Solved,
    reference: Reference,
}

impl First {
    fn of(search: &Search, plan: Plan) -> Self {
        let chosen = plan.chosen_stage();
        if let Some((origin, reference)) = simple_motions(search).into_iter().next()
            && plan.stopped == Some(Stop::Unsolved)
        {
            let mut variant = plan.variant;
            variant.task.horizon = reference.horizon();
            return Self { solved: Solved::new(origin, variant, plan.iterations), reference };
        }
        let solved = Solved { chosen, ..Solved::new(Origin::Scene, plan.variant, plan.iterations) };
        Self { reference: solved.reference(chosen - 1), solved }
    }

    /// The best homotopy step, or the simple motion.
    fn candidate<'run>(self, search: &Search<'run>, until: Deadline) -> Option<Candidate<'run>> {
        let Self { solved, reference } = self;
        if solved.origin == Origin::Scene {
            return search.candidate(solved, until);
        }
        let best = search.training.best_of(&[reference], &|| search.schedule.is_over(until))?;
        Some(search.training.candidate(best, solved))
    }
}
