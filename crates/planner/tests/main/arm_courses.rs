//! Joints of an arm along a motion of the body.

use nalgebra::{Isometry3, Vector3, Vector6};
use planner::{ArmCourse, Choices, Problem};
use robot::JointVector;
use scene::Robot;
use simulation::{Reference, Settings};
use task::{GraspError, Pose, State, Wrench};

use crate::support;

const KNOTS: usize = 21;
const TIME_STEP: f64 = 0.1;

/// With a time between two commands of the controller (s).
fn problem_with_period(control_period: f64) -> Problem {
    support::problem_of_arm(control_period, &Choices::default())
}

fn problem() -> Problem {
    problem_with_period(0.002)
}

/// States of a body that is believed to move straight from the start to the goal.
fn states(problem: &Problem, grasp: &GraspError) -> Vec<State> {
    let (start, goal) = (problem.start().pose, problem.task().goal);
    let at = |knot: usize| {
        let share = knot as f64 / (KNOTS - 1) as f64;
        let believed = Pose(std::array::from_fn(|index| start[index] + share * (goal[index] - start[index])));
        grasp.actual(&believed).at_rest()
    };
    (0..KNOTS).map(at).collect()
}

/// Power (W) of a wrench at the body while the joints move.
fn power(robot: &Robot, configuration: &JointVector, speeds: &JointVector, grasp: &GraspError, wrench: &Wrench) -> f64 {
    let step = 1e-6;
    let [before, after] = [-step, step].map(|step| robot.arm.pose(&(configuration + speeds * step)));
    // The force acts where the body is believed to be, the torque in the frame of the body.
    let velocity = (after.translation.vector - before.translation.vector) / (2.0 * step);
    let [from, to] = [before, after].map(|pose: Isometry3<f64>| pose.rotation * grasp.quaternion().inverse());
    let turning = (from.inverse() * to).scaled_axis() / (2.0 * step);
    let twist = Vector6::new(velocity.x, velocity.y, velocity.z, turning.x, turning.y, turning.z);
    twist.dot(&Vector6::from(wrench.0))
}

#[test]
fn an_arm_is_where_it_believes_the_body_to_be_and_its_torques_do_the_work_of_the_wrench() {
    let problem = problem();
    let robot = problem.scene().robot.as_ref().unwrap();
    let grasp = GraspError { offset: [0.01, -0.02, 0.005], rotation: [0.2, -0.1, 0.3] };
    let states = states(&problem, &grasp);
    let wrench = Wrench([3.0, -2.0, 5.0, 0.4, -0.3, 0.2]);
    let course = ArmCourse::new(robot, TIME_STEP, &grasp, &states, &[wrench; KNOTS - 1]).unwrap();
    let joints = robot.arm.joints().len();
    for (knot, (configuration, torque)) in course.configurations.iter().zip(&course.torques).enumerate() {
        let believed = states[knot].pose().isometry() * grasp.believed();
        let pose = robot.arm.pose(configuration);
        assert!((pose.translation.vector - believed.translation.vector).norm() < 1e-8, "knot {knot}");
        assert!(pose.rotation.angle_to(&believed.rotation) < 1e-7, "knot {knot}");
        let moving = torque - robot.arm.at(configuration).gravity(&Vector3::new(0.0, 0.0, -9.81));
        for joint in 0..joints {
            let mut speeds = JointVector::zeros();
            speeds[joint] = 1.0;
            let expected = if knot == 0 { 0.0 } else { power(robot, configuration, &speeds, &grasp, &wrench) };
            assert!(
                (moving[joint] - expected).abs() < 1e-6,
                "knot {knot}, joint {joint}: {} {expected}",
                moving[joint]
            );
        }
    }
}

#[test]
fn a_pose_out_of_reach_is_named_by_its_time() {
    let problem = problem();
    let robot = problem.scene().robot.as_ref().unwrap();
    let grasp = GraspError::default();
    let mut states = states(&problem, &grasp);
    states[3].0[2] += 5.0;
    let error = ArmCourse::new(robot, TIME_STEP, &grasp, &states, &[Wrench::ZERO; KNOTS - 1]).unwrap_err();
    assert!((error.time - 3.0 * TIME_STEP).abs() < 1e-9, "{error}");
}

/// Angle (rad) between the goal and where the arm ends that is pushed straight there.
fn angle_after_a_push(problem: &Problem) -> f64 {
    let task = problem.world();
    let reference = Reference::straight(&task.start, &task.goal, task.horizon);
    let rollout = problem.rollout(Settings::default()).unwrap();
    let outcome = rollout.play(&reference, [0.0; 3], |_, _| {});
    if outcome.diverged { f64::INFINITY } else { outcome.orientation_error }
}

#[test]
fn a_controller_that_answers_too_late_for_its_damping_is_warned_of() {
    let is_warned = |problem: &Problem| {
        let explanation = planner::check::explain(problem, problem.homotopy().tau).unwrap();
        explanation.warnings.iter().any(|warning| warning.contains("the controller answers after"))
    };
    let (quick, late) = (problem_with_period(0.002), problem_with_period(0.02));
    assert!(!is_warned(&quick) && angle_after_a_push(&quick) < 0.03, "{}", angle_after_a_push(&quick));
    assert!(is_warned(&late) && angle_after_a_push(&late) > 0.2, "{}", angle_after_a_push(&late));
}
