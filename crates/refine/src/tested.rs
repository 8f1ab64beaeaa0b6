//! The test of an unrefined plan: rollouts with hard contact, beside a straight push.

use plan::ranges::require_threads;
use plan::{Plan, PlannerError, RobustnessTarget, Session, TestReport};

use crate::evaluation::{ErrorRange, Evaluation, Wanted};
use crate::evaluators::evaluators;
use crate::push::judge_push;

/// Plays the plan of a solver, and a straight push, as [`refine`](crate::refine) would play it at first, but with fewer
/// grasp errors: enough to tell what it is worth, too few to call it robust. `None` where the plan is not whole, or the user
/// or the end of the session's time stops the test.
///
/// # Errors
/// When the target is out of range, or an arm does not reach the start.
pub fn test(plan: &Plan, target: &RobustnessTarget, session: &Session) -> Result<Option<TestReport>, PlannerError> {
    target.validate()?;
    require_threads(session.threads)?;
    if !plan.is_converged() || plan.robustness.is_some() {
        return Ok(None);
    }
    let begin = session.clock.elapsed();
    let (problem, reference, wanted) = (&plan.problem, plan.reference(), Wanted::target(target));
    let [evaluator, _] = evaluators(problem, target, &reference, session)?;
    let range = ErrorRange::new(problem, target);
    let (parameters, seeds) = (&target.parameters, target.parameters.seeds);
    let evaluation = Evaluation::new(
        problem.task(),
        &range,
        &target.frictions,
        parameters.evaluation.test_random,
        seeds.first + seeds.stride,
    );
    let stop = || session.is_interrupted() || session.is_over();
    let Some(results) = evaluator.evaluate_all(&reference, evaluation.cases(), &stop) else { return Ok(None) };
    let Some(push) = judge_push(problem, &evaluator, &evaluation, wanted, &stop) else { return Ok(None) };
    let judgement = evaluation.judgement(&results, wanted);
    let wall_s = session.clock.elapsed().saturating_sub(begin).as_secs_f64();
    Ok(Some(TestReport {
        target_rate: target.target_rate,
        reached: judgement.reached,
        rates: judgement.rates,
        push,
        wall_s,
    }))
}
