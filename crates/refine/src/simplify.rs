//! Robust plans without what they do not need.
//!
//! Refinement keeps a change for the test cases that pass because of it, whatever it does to the motion: reorientations and
//! detours in free air, an oscillation that pulls a seated part back. A robust plan is refined in the few test cases that it
//! fails, as simulators differ, and so does reality; then what no test case needs is taken back, and one evaluation decides
//! about both. A plan for an arm is refined with margins instead.

use plan::{PlannerError, Round};
use task::StraightMotion;

use crate::candidate::{Evaluated, round};
use crate::evaluation::Wanted;
use crate::keep::keep;
use crate::search::Search;

/// Refines and simplifies a robust plan for a free body. The result is kept if it succeeds as often in a new evaluation.
pub fn simplify(search: &mut Search) -> Result<(), PlannerError> {
    let target = search.setting.target;
    let parameters = target.parameters.simplification;
    let Some(robust) = search.found.best.clone().filter(|best| best.reached) else { return Ok(()) };
    let is_as_planned = robust.perturbations == 0 && !robust.has_oscillation();
    if is_as_planned || search.setting.problem.arm().is_some() || target.stall_limit == 0 {
        return Ok(());
    }
    let cases = search.judge.new_evaluation(parameters.random).cases().to_vec();
    search.training.cases.extend(cases);
    let wanted = Wanted { overall: robust.rates.overall(), ..Wanted::target(target) };
    for _ in 0..parameters.attempts {
        let Some((simpler, round)) = simpler(search, &robust) else { return Ok(()) };
        let judgement = search.judge_as(&simpler.reference, wanted, search.schedule.end());
        let rate = judgement.rates.overall();
        search.tell_refined(&judgement);
        if judgement.reached {
            search.found.rounds.push(Round { rate: Some(rate), ..round });
            let (failing, round) = (judgement.failing(), search.found.rounds.len());
            let simpler = Evaluated { failing, rates: judgement.rates, round, ..simpler };
            return keep(search, simpler, search.found.rounds.clone());
        }
        search.training.cases.extend(judgement.failures.iter().map(|(case, _)| *case));
    }
    Ok(())
}

/// A plan that fails in fewer training cases, without what none of them needs, and its round, still without a rate. `None` if
/// there is no such thing, or no time.
fn simpler(search: &mut Search, robust: &Evaluated) -> Option<(Evaluated, Round)> {
    let Search { schedule, training, .. } = search;
    let until = schedule.simplification();
    let stop = || schedule.is_over(until);
    let results = training.play(&robust.reference, &stop)?;
    let mut simpler = robust.clone();
    let task = &simpler.solved.variant.task;
    let straight = StraightMotion::new(&task.start, &task.goal);
    let mut refinement = training.refinement(simpler.reference, results.clone());
    let mut perturbations = 0;
    training.improve(&mut refinement, &mut perturbations, schedule, until);
    perturbations += refinement.simplify(&straight, task.horizon.steps, &stop);
    simpler.reference = refinement.reference().clone();
    simpler.perturbations += perturbations;
    let has_oscillation = simpler.has_oscillation();
    let marks = &mut simpler.solved.marks;
    (marks.has_oscillation, marks.is_straightened) = (marks.has_oscillation && has_oscillation, true);
    let rollouts = results.len() + refinement.rollouts();
    let round = round(&simpler.solved, &results);
    (perturbations > 0)
        .then_some((simpler, Round { rollouts, perturbations: robust.perturbations + perturbations, ..round }))
}

#[cfg(test)]
mod tests {
    use std::time::Duration;

    use simulation::Reference;
    use task::{Pose, State};

    use super::*;
    use crate::first::judge_first;
    use crate::tests::{in_corner, of_scene};

    /// A push of the corner scene, which is robust there, with an unnecessary rotation (rad) in its first half.
    fn twisted(search: &Search, rotation: f64) -> Reference {
        let task = search.setting.problem.task();
        let push = Reference::straight(&task.start, &task.goal, task.horizon);
        let steps = push.intervals();
        let twist = |(knot, state): (usize, State)| {
            let bend = (std::f64::consts::TAU * knot as f64 / steps as f64).sin().max(0.0);
            let mut pose = state.pose().isometry();
            pose.rotation *= nalgebra::UnitQuaternion::from_scaled_axis(nalgebra::Vector3::z() * rotation * bend);
            State::new(&Pose::from(&pose), &state.twist())
        };
        let states: Vec<State> = push.states().into_iter().enumerate().map(twist).collect();
        Reference::new(push.time_step(), &states)
    }

    /// Largest angle (rad) between a reference and the straight motion.
    fn rotation(search: &Search, reference: &Reference) -> f64 {
        let task = search.setting.problem.task();
        let straight = StraightMotion::new(&task.start, &task.goal);
        let angles = reference.states().into_iter().map(|state| straight.departure(&state.pose()).rotation);
        angles.fold(0.0, f64::max)
    }

    #[test]
    fn a_robust_plan_that_was_changed_is_straightened() {
        for perturbations in [0, 3] {
            in_corner(Duration::from_secs(1000), |search| {
                let reference = twisted(search, 0.3);
                assert!(rotation(search, &reference) > 0.25);
                judge_first(search, of_scene(search), reference).unwrap();
                let best = search.found.best.as_mut().unwrap();
                assert!(best.reached, "{}", best.rates.overall());
                best.perturbations = perturbations;
                simplify(search).unwrap();
                let (best, rounds) = (search.found.best.clone().unwrap(), search.found.rounds.len());
                let angle = rotation(search, &best.reference);
                match perturbations {
                    0 => assert!(angle > 0.25 && rounds == 1, "what was planned stays as it is"),
                    _ => assert!(
                        best.reached && angle < 0.16 && best.round == 2 && best.solved.marks.is_straightened,
                        "{angle} rad: {}",
                        best.solved.planned()
                    ),
                }
            });
        }
    }
}
