//! A robust plan: play the plan, refine what fails, play again.
//!
//! `run` is the method. Among the homotopy steps of a solved problem it takes the one whose reference passes most of the
//! training set, with a final oscillation where that helps. Random perturbations of this reference are kept when more test
//! cases pass ([`simulation::Refinement`]). Where a spiral search for the hole passes more test cases, it is refined instead.
//! An evaluation at grasp errors outside the training set then decides; its failures join the training set. When this stalls, a straight push is refined instead, which needs no plan; then other problems are
//! solved, the promising first, and their plans are refined. The plan with the best evaluation is kept; if none is robust,
//! the latest are compared in the same test cases. With an arm, the best of several drafts replaces a plan that fails too
//! often, no push is refined, and a robust plan is refined with margins while there is time.
//!
//! Evaluations end when they are decided, homotopy steps are compared in few test cases, and every problem has its share of
//! the time.
//!
//! | file | part |
//! |---|---|
//! | `setting` | what stays the same: problem, target, session, evaluators |
//! | `schedule` | the clock and the shares of the time |
//! | `judge`, `evaluation` | evaluations, each with test cases of its own |
//! | `training` | the training set, and perturbations in it |
//! | `found` | the best plan so far, the latest ones, the rounds |
//! | `search` | all of these together |
//! | `refining` | one reference: trained, evaluated, trained again |
//! | `own`, `drafts`, `push`, `variants`, `again`, `comparison`, `simplify`, `margins` | the stages of `run` |

mod again;
mod candidate;
mod checkpoint;
mod comparison;
mod draft;
mod drafts;
mod ends;
mod evaluation;
mod evaluators;
mod first;
mod found;
mod judge;
mod keep;
mod loss;
mod margins;
mod origin;
mod own;
mod portfolio;
mod push;
mod race;
mod refining;
mod resume;
mod schedule;
mod search;
mod setting;
mod simple;
mod simplify;
mod solve;
mod tested;
mod training;
mod variants;

use std::time::Duration;

use plan::ranges::require_threads;
use plan::{Plan, PlannerError, Problem, RobustnessReport, RobustnessTarget, Session, Stop, Variant};
use simulation::Reference;

use crate::again::{refine_again, refine_best, refine_if_nearly_robust};
use crate::candidate::Evaluated;
use crate::comparison::compare_latest;
use crate::evaluation::Wanted;
use crate::evaluators::evaluators;
use crate::first::judge_first;
use crate::loss::loss;
use crate::margins::add_margins;
use crate::origin::{Origin, Solved};
use crate::own::refine_own;
use crate::push::{judge_push, refine_push};
use crate::search::Search;
use crate::setting::Setting;
use crate::simplify::simplify;
use crate::variants::refine_variants;

pub use checkpoint::{BestRecord, HomotopyRecord, RefinementCheckpoint, TestCaseRecord, WeightsRecord};
pub use evaluation::Drawn;
pub use solve::solve_robust;
pub use tested::test;

/// Makes a plan robust. With a folder in the session, the best plan so far is kept there, and the refinement of an
/// earlier run of the same problem is continued.
///
/// # Errors
/// When the target is out of range, or a linear solver or a file fails. A plan that does not reach the target is one
/// whose status says so; a plan that was interrupted, or had no time to become whole, comes back as it is.
pub fn refine(plan: Plan, target: &RobustnessTarget, session: &Session) -> Result<Plan, PlannerError> {
    target.validate()?;
    require_threads(session.threads)?;
    let is_whole = plan.is_converged() || matches!(plan.stopped, Some(Stop::Enough | Stop::Unsolved));
    if plan.stopped == Some(Stop::User) || plan.stopped.is_some() && !is_whole {
        return Ok(plan);
    }
    let mut world = plan.problem.world();
    let (problem, attempts, threads) = (plan.problem.clone(), plan.attempts.clone(), plan.threads);
    let [evaluator, trainer] = evaluators(&problem, target, &plan.reference(), session)?;
    let setting = Setting { problem: &problem, target, session, evaluator: &evaluator, trainer: &trainer };
    let mut search = Search::new(setting);
    let best = run(&mut search, plan)?;
    let report = report(&search, &best);
    // The environment is the problem's; only the time grid comes from the reference.
    world.horizon = best.reference.horizon();
    let tau = best.solved.iterations[best.solved.iterations.len() - 1].record.tau;
    // The report shows the smallest tolerated friction, not the planned one.
    let mut shown = world.clone();
    if let [friction] = &mut shown.frictions[..] {
        *friction = target.least_friction();
    }
    let trajectory = problem.motions(&shown, &best.reference, tau)?;
    let Solved { variant, iterations, .. } = best.solved;
    let is_cut = report.unplayed > 0 || !report.reached && search.schedule.is_over(search.schedule.end());
    let stopped = if session.is_interrupted() { Some(Stop::User) } else { is_cut.then_some(Stop::TimeLimit) };
    let (task, robustness, tested) = (world, Some(report), None);
    Ok(Plan { problem, attempts, variant, iterations, trajectory, task, robustness, tested, threads, stopped })
}

/// Refines any reference of a problem in the same way for the whole time limit, but solves nothing: what the optimal
/// control problem is worth shows in comparison with [`refine`].
///
/// # Errors
/// When the target is out of range.
pub fn refine_reference(
    problem: &Problem,
    reference: Reference,
    target: &RobustnessTarget,
    session: &Session,
) -> Result<(Reference, RobustnessReport), PlannerError> {
    target.validate()?;
    require_threads(session.threads)?;
    let session = Session { folder: None, ..*session };
    let [evaluator, trainer] = evaluators(problem, target, &reference, &session)?;
    let setting = Setting { problem, target, session: &session, evaluator: &evaluator, trainer: &trainer };
    let mut search = Search::new(setting);
    judge_first(&mut search, Solved::new(Origin::Given, Variant::of_scene(problem), Vec::new()), reference)?;
    let until = search.schedule.end();
    while search.goes_on(until) {
        refine_best(&mut search, until)?;
    }
    compare_latest(&mut search)?;
    let best = search.found.take_best()?;
    let report = report(&search, &best);
    Ok((best.reference, report))
}

/// Refines the plan of the scene; where that is given up, a straight push; after each of the two the best so far again, if it
/// is nearly robust; then the plans of other problems, and the best once more, while there is time. With an arm, no push is
/// refined. Where no plan is robust then, the best of the latest in a comparison is taken; a robust one is simplified, or gets
/// margins.
fn run(search: &mut Search, plan: Plan) -> Result<Evaluated, PlannerError> {
    let homotopy = plan.iterations.clone();
    let solving = homotopy.iter().map(|iteration| Duration::from_secs_f64(iteration.record.wall_s)).sum();
    refine_own(search, plan, solving)?;
    refine_if_nearly_robust(search)?;
    if search.setting.problem.arm().is_some() {
        // A straight push has never become robust with an arm.
        refine_again(search)?;
    } else {
        refine_push(search, homotopy)?;
        refine_if_nearly_robust(search)?;
    }
    refine_variants(search, solving)?;
    refine_again(search)?;
    compare_latest(search)?;
    simplify(search)?;
    add_margins(search)?;
    search.found.take_best()
}

/// Report of a refinement, and of a straight push in the same evaluation.
fn report(search: &Search, best: &Evaluated) -> RobustnessReport {
    let Setting { problem, target, evaluator, .. } = search.setting;
    let stop = || search.schedule.is_over(search.schedule.limit());
    let evaluation = search.judge.evaluation(best.evaluation);
    RobustnessReport {
        target_rate: target.target_rate,
        reached: best.reached,
        rate_before: search.found.before.overall(),
        rate_after: best.rates.overall(),
        wall_s: search.schedule.total().as_secs_f64(),
        before: search.found.before.clone(),
        after: best.rates.clone(),
        unplayed: best.unplayed,
        push: judge_push(problem, evaluator, &evaluation, Wanted::target(target), &stop),
        kept_round: best.round,
        kept_stage: best.solved.chosen,
        kept_perturbations: best.perturbations,
        rounds: search.found.rounds.clone(),
        loss: loss(problem, target, best),
        parameters: target.parameters.clone(),
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use std::sync::atomic::AtomicBool;

    use plan::{Choices, Event};

    use super::*;

    /// The file of the corner scene.
    pub(crate) fn corner() -> std::path::PathBuf {
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml")
    }

    /// The scene as it is, not solved.
    pub(crate) fn of_scene(search: &Search) -> Solved {
        Solved::new(Origin::Scene, Variant::of_scene(search.setting.problem), Vec::new())
    }

    /// Hands over a search of the corner scene without friction, before its first plan. It has no stall limit.
    pub(crate) fn in_corner<T>(time_limit: Duration, work: impl FnOnce(&mut Search) -> T) -> T {
        in_corner_for(RobustnessTarget { time_limit, stall_limit: 1, ..RobustnessTarget::default() }, work)
    }

    /// Hands over a search of the corner scene without friction, before its first plan.
    pub(crate) fn in_corner_for<T>(target: RobustnessTarget, work: impl FnOnce(&mut Search) -> T) -> T {
        let problem = Problem::load(&corner(), &Choices::default()).unwrap();
        let target = RobustnessTarget { frictions: vec![0.0], ..target };
        let evaluator = problem.evaluator(&target.frictions).unwrap();
        let interrupted = AtomicBool::new(false);
        let session = Session::new(&|_: &Event| {}, &interrupted);
        let setting = Setting {
            problem: &problem,
            target: &target,
            session: &session,
            evaluator: &evaluator,
            trainer: &evaluator,
        };
        work(&mut Search::new(setting))
    }
}
