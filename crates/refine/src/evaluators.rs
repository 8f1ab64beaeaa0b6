//! Evaluators of a refinement, with bounds on references and limits of forces.

use nalgebra::Vector3;
use plan::parameters::NearParameters;
use plan::{PlannerError, Problem, RobustParameters, RobustnessTarget, Session};
use simulation::{Evaluator, Reference};
use workers::Workers;

/// One for evaluations and one for the training set, with margins of contact forces, for references near one.
///
/// # Errors
/// When an arm does not reach the start.
pub fn evaluators(
    problem: &Problem,
    target: &RobustnessTarget,
    reference: &Reference,
    session: &Session,
) -> Result<[Evaluator; 2], PlannerError> {
    let evaluator = problem.evaluator(&target.frictions)?.with_workers(Workers::new(session.threads));
    let RobustParameters { near: bounds, evaluation, training, .. } = &target.parameters;
    let evaluator = near(evaluator, problem, reference, bounds);
    Ok([evaluation.force_share, training.force_share].map(|share| evaluator.clone().with_force_share(share)))
}

/// With references that stay near a plan, an earlier one and the straight path. Without this, refinement could succeed by
/// throwing the part.
fn near(evaluator: Evaluator, problem: &Problem, reference: &Reference, parameters: &NearParameters) -> Evaluator {
    let task = problem.task();
    let straight = Reference::straight(&task.start, &task.goal, task.horizon);
    let margin = parameters.margin * (problem.offset_magnitude() + problem.success().position);
    let known: Vec<&Reference> = [reference, &straight].into_iter().chain(problem.earlier()).collect();
    evaluator.near(&known, margin, parameters.haste, radius(problem))
}

/// Distance of the body's origin from its farthest corner (m).
fn radius(problem: &Problem) -> f64 {
    let corners = problem.scene().body.iter().flat_map(|part| part.shape.vertices());
    corners.map(|corner| Vector3::from(*corner).norm()).fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::AtomicBool;

    use plan::{Choices, Event};
    use scene::Scene;
    use simulation::{Disturbance, FrictionIndex, Settings, TestCase};
    use task::GraspError;

    use super::*;
    use crate::tests::corner;

    #[test]
    fn evaluations_and_training_keep_margins_of_contact_forces() {
        let file = corner();
        let with_limit = |force: f64| {
            let mut scene = Scene::load(&file).unwrap();
            scene.limits.contact_force = force;
            Problem::choose(scene, &file, &Choices::default()).unwrap()
        };
        let unlimited = with_limit(f64::INFINITY);
        let task = unlimited.task();
        let mut below = task.goal;
        below.0[2] -= 3e-3;
        let pressing = Reference::straight(&task.start, &below, task.horizon);
        let case =
            TestCase { friction: FrictionIndex(0), grasp: GraspError::default(), disturbance: Disturbance::default() };
        let rollout = unlimited.rollout(Settings::default()).unwrap();
        let force = rollout.play(&pressing, case.injection(), |_, _| {}).loads.contact_force;
        assert!(force > 0.05, "{force} N");
        let target = RobustnessTarget { frictions: vec![0.0], ..RobustnessTarget::default() };
        let interrupted = AtomicBool::new(false);
        let session = Session::new(&|_: &Event| {}, &interrupted);
        let passes = |share: f64| {
            let limited = with_limit(force / share);
            let evaluators = evaluators(&limited, &target, &pressing, &session).unwrap();
            evaluators.map(|evaluator| evaluator.evaluate(&pressing, &case).passed)
        };
        let [evaluation, training] = [target.parameters.evaluation.force_share, target.parameters.training.force_share];
        assert_eq!(passes(training - 0.02), [true, true]);
        assert_eq!(passes(training + 0.02), [true, false]);
        assert_eq!(passes(evaluation + 0.02), [false, false]);
    }
}
