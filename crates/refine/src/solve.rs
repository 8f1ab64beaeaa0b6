//! The homotopy of the scene, as far as a robust plan needs it.
//!
//! Rollouts decide about a robust plan. Once the reference of a homotopy step passes most of the training set, tighter
//! smoothing brings little that refinement does not; where a motion passes that solves nothing, nothing has to be solved.

use plan::{EarlyEnd, Plan, PlanIteration, PlannerError, Problem, RobustnessTarget, Session, Variant, solve_until};
use simulation::{Reference, TestResult};

use crate::evaluators::evaluators;
use crate::origin::reference_of;
use crate::refine;
use crate::search::Search;
use crate::setting::Setting;
use crate::simple::{earlier, simple_motions, straight_push};

/// Plans a problem and makes the plan robust.
///
/// # Errors
/// As [`plan::solve`] and [`refine`].
pub fn solve_robust(problem: &Problem, target: &RobustnessTarget, session: &Session) -> Result<Plan, PlannerError> {
    refine(solve_for(problem, target, session)?, target, session)
}

/// Plans a problem as far as refinement needs it: not at all where an earlier plan or a simple motion is nearly robust, and
/// otherwise until one of the references of the homotopy is, or its share of the time is over.
fn solve_for(problem: &Problem, target: &RobustnessTarget, session: &Session) -> Result<Plan, PlannerError> {
    target.validate()?;
    let [evaluator, trainer] = evaluators(problem, target, &straight_push(problem), session)?;
    let search = Search::new(Setting { problem, target, session, evaluator: &evaluator, trainer: &trainer });
    let earlier = earlier(&search).map(|(_, reference)| reference);
    if let Some(earlier) = earlier.filter(|earlier| first_pass(&search, earlier)) {
        return plan::unsolved(problem, &earlier, session.threads);
    }
    let mut simple: Vec<Reference> = simple_motions(&search).into_iter().map(|(_, reference)| reference).collect();
    if passes(&search, &simple)
        && let Some(any) = simple.pop()
    {
        return plan::unsolved(problem, &any, session.threads);
    }
    let is_enough = |variant: &Variant, last: &PlanIteration| passes(&search, &[reference_of(variant, last)]);
    let (until, needs_step) = (search.schedule.homotopy(), simple.is_empty());
    solve_until(problem, session, &EarlyEnd { is_enough: &is_enough, until, needs_step })
}

/// Whether one of some references passes enough of the training set to be refined rather than replaced; the first test
/// cases alone show most that do not.
fn passes(search: &Search, references: &[Reference]) -> bool {
    let all = search.training.cases.len();
    [search.setting.target.parameters.training.first, all].into_iter().all(|count| {
        let best = search.training.best_of_first(count, references, &|| search.schedule.is_over(search.schedule.end()));
        best.is_some_and(|best| are_enough(search, &best.winner.results))
    })
}

/// Whether a reference passes enough of the first test cases, as it is: an evaluation follows at once.
fn first_pass(search: &Search, reference: &Reference) -> bool {
    let cases = &search.training.cases;
    let first = &cases[..search.setting.target.parameters.training.first.min(cases.len())];
    let stop = || search.setting.session.is_interrupted();
    let results = search.setting.trainer.evaluate_all(reference, first, &stop);
    results.is_some_and(|results| are_enough(search, &results))
}

fn are_enough(search: &Search, results: &[TestResult]) -> bool {
    let passed = results.iter().filter(|result| result.passed).count();
    passed as f64 >= search.setting.target.parameters.training.nearly_robust * results.len() as f64
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use plan::{Choices, Event, Stop};

    use super::*;
    use crate::tests::corner;

    /// What the homotopy of the corner scene leaves, with simple motions or without.
    fn left(simple: bool) -> Plan {
        let problem = Problem::load(&corner(), &Choices::default()).unwrap();
        let mut target = RobustnessTarget { frictions: vec![0.0], ..RobustnessTarget::default() };
        target.parameters.training.simple = simple;
        let interrupted = AtomicBool::new(false);
        solve_for(&problem, &target, &Session::new(&|_: &Event| {}, &interrupted)).unwrap()
    }

    #[test]
    fn nothing_is_solved_where_a_straight_push_passes() {
        assert_eq!(left(true).stopped, Some(Stop::Unsolved));
    }

    #[test]
    fn the_homotopy_goes_on_while_nothing_passes() {
        let plan = left(false);
        assert!(plan.iterations.len() > 1, "{} steps", plan.iterations.len());
    }
}
