//! Plans of other problems than the scene's own.

use std::time::Duration;

use plan::{Event, HomotopyRun, PlannerError, Variant};
use task::GraspError;

use crate::candidate::Candidate;
use crate::origin::{Origin, Solved};
use crate::portfolio::{PORTFOLIO, Recipe};
use crate::refining::refine;
use crate::schedule::Deadline;
use crate::search::Search;
use crate::setting::Setting;

/// Solves variants of the problem one after the other, each in its share of the time. One whose plan fails in fewer training
/// cases than the best so far is refined at once, the others when all are solved, the best first. `solving` is the time that
/// the scene's own problem took: no more are begun than can be solved in such a time.
pub fn refine_variants(search: &mut Search, solving: Duration) -> Result<(), PlannerError> {
    let mut waiting: Vec<Candidate> = Vec::new();
    let count = search.schedule.affordable_variants(solving).min(PORTFOLIO.len());
    for (index, recipe) in PORTFOLIO.into_iter().take(count).enumerate() {
        let until = search.schedule.one_of(count - index);
        if !search.goes_on(until) {
            break;
        }
        search.setting.session.tell(Event::Variant { name: &recipe.to_string(), number: index + 1, count });
        let Some(candidate) = solve_variant(search, recipe, until)? else { continue };
        if candidate.refinement.failing_fraction() < search.training.least_failing {
            refine(search, candidate, until, 0.0)?;
        } else {
            waiting.push(candidate);
        }
    }
    waiting.sort_by(|one, other| one.refinement.failing_fraction().total_cmp(&other.refinement.failing_fraction()));
    let count = waiting.len();
    for (index, candidate) in waiting.into_iter().enumerate() {
        let until = search.schedule.one_of(count - index);
        if search.goes_on(until) {
            refine(search, candidate, until, 0.0)?;
        } else {
            search.found.rounds.push(candidate.round);
        }
    }
    Ok(())
}

/// Solves a variant. `None` when no homotopy step was finished in time.
fn solve_variant<'run>(
    search: &Search<'run>,
    recipe: Recipe,
    until: Deadline,
) -> Result<Option<Candidate<'run>>, PlannerError> {
    let Setting { problem, target, session, .. } = search.setting;
    let Some(best) = &search.found.best else { return Ok(None) };
    let failing: Vec<GraspError> = best.failing.iter().map(|case| case.grasp).collect();
    let scene = Variant::of_scene(problem);
    let variant = recipe.variant(&scene, &best.reference, &failing, &target.parameters.portfolio);
    let solving = search.schedule.solving(until);
    let run = HomotopyRun { threads: session.threads, ..HomotopyRun::new(&variant) };
    // Homotopy steps that are finished by then are used.
    let iterations = run.finished(session, || search.schedule.is_over(solving))?;
    let status = iterations.last().map_or("no homotopy step in time", |last| &last.record.status);
    session.tell(Event::VariantSolved { status });
    let candidate = search.candidate(Solved::new(Origin::Variant(recipe), variant, iterations), until);
    if let Some(Candidate { round, .. }) = &candidate {
        let (failing, cases) = (round.training_failures, round.training_cases);
        session.tell(Event::VariantTried { failing, cases });
    }
    Ok(candidate)
}
