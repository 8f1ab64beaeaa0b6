//! The reference of an earlier plan, for a start and a goal that have been measured again.

use simulation::Reference;

use crate::error::PlannerError;
use crate::problem::Problem;

/// The reference of an earlier plan of a problem, for another one: it is moved with the goal, as whatever the body is put
/// into is, and led there from the new start. From the first contact on, the motion is the same.
///
/// # Errors
/// When the arm of the earlier problem does not reach its start.
pub fn moved(reference: &Reference, from: &Problem, to: &Problem) -> Result<Reference, PlannerError> {
    let [before, now] = [from, to].map(|problem| problem.task().goal.isometry());
    let free = from.intervals_in_free_air(reference)?;
    Ok(reference.transformed(&(now * before.inverse())).led_from(&to.task().start.isometry(), free))
}

#[cfg(test)]
mod tests {
    use simulation::Settings;
    use task::{Pose, ScenarioTrajectory};

    use super::*;
    use crate::problem::Choices;
    use crate::testing::corner;

    #[test]
    fn an_earlier_motion_is_led_from_the_new_start_to_its_first_contact() {
        let problem = Problem::load(&corner(), &Choices::default()).unwrap();
        let task = problem.task();
        let push = Reference::straight(&task.start, &task.goal, task.horizon);
        let same = moved(&push, &problem, &problem).unwrap();
        let far = |one: &Reference, other: &Reference, knot: usize| {
            let [one, other] = [one, other].map(|reference| reference.at(knot, 0.0).pose.translation.vector);
            (one - other).norm()
        };
        assert!((0..=push.intervals()).all(|knot| far(&same, &push, knot) < 1e-12));
        let mut scene = problem.scene().clone();
        for index in 0..scene.starts.len() {
            let [x, y, z, rotation @ ..] = scene.starts[index].pose.0;
            let [w, i, j, k] = rotation;
            scene.starts[index].pose = Pose::new([x + 0.003, y, z + 0.004], [w, i, j, k]);
        }
        let other = Problem::choose(scene, &corner(), &Choices::default()).unwrap();
        let led = moved(&push, &problem, &other).unwrap();
        assert!((far(&led, &push, 0) - 0.005).abs() < 1e-9);
        let contact = problem.intervals_in_free_air(&push).unwrap();
        let motions = problem.motions(&problem.world(), &push, 0.0).unwrap();
        let touches = |interval: usize| {
            let force =
                |scenario: &ScenarioTrajectory| scenario.contacts[interval].iter().any(|contact| contact.force > 0.0);
            motions.scenarios.iter().any(force)
        };
        assert!(0 < contact && contact < push.intervals(), "{contact}");
        assert_eq!((0..push.intervals()).find(|&interval| touches(interval)), Some(contact));
        assert!((contact..=push.intervals()).all(|knot| far(&led, &push, knot) < 1e-12));
        let rollout = other.rollout(Settings::default()).unwrap();
        let end = |reference: &Reference| rollout.play(reference, [0.0; 3], |_, _| {}).position_error;
        assert!((end(&led) - end(&push)).abs() < 1e-4, "{} and {} m", end(&led), end(&push));
    }
}
