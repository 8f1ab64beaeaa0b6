//! Joints of the scene's arm along a plan.

use nalgebra::{Isometry3, Quaternion, Translation3, UnitQuaternion, Vector3, Vector6};
use planner::Problem;
use planner::files::{MotionTables, ScenarioTables};
use robot::{FollowError, Joint, JointVector};
use scene::Robot;
use task::{STATE, TWIST};

use crate::model::{ArmData, JointCourse, JointData};
use crate::rounded::{ANGLE, FORCE, rounded};

/// Gravity in the world frame (m/s^2).
const GRAVITY: Vector3<f64> = Vector3::new(0.0, 0.0, -9.81);

/// Positions, speeds and torques of the joints with each offset; `None` for a scene without an arm.
///
/// # Errors
/// When the arm does not reach a pose, or a joint is too slow.
pub fn courses(problem: &Problem, tables: &MotionTables) -> Option<Result<ArmData, FollowError>> {
    let robot = problem.scene().robot.as_ref()?;
    let scenarios = tables.scenarios.iter().map(|scenario| course(robot, tables, scenario));
    let data = |scenarios| ArmData {
        joints: robot.arm.joints().iter().map(joint).collect(),
        time_step: tables.time_step,
        scenarios,
    };
    Some(scenarios.collect::<Result<Vec<_>, _>>().map(data))
}

fn joint(joint: &Joint) -> JointData {
    let limit = |value: f64| value.is_finite().then(|| rounded(value, ANGLE));
    JointData {
        name: joint.name.clone(),
        unit: joint.kind.unit(),
        range: [limit(joint.lower), limit(joint.upper)],
        speed: limit(joint.velocity),
        torque: limit(joint.effort),
    }
}

/// The arm moves its tip to where it believes the body to be.
fn course(robot: &Robot, tables: &MotionTables, scenario: &ScenarioTables) -> Result<JointCourse, FollowError> {
    let believed = isometry(&scenario.states[0]).inverse() * isometry(&tables.reference[0]);
    let last = scenario.states.len() - 1;
    let time = |step: usize| step as f64 * tables.time_step;
    // From the end, where the scene says on which branch the arm is.
    let pose = |step: usize| (time(last - step), isometry(&scenario.states[step]) * believed);
    let backwards: Vec<(f64, Isometry3<f64>)> = (0..=last).rev().map(pose).collect();
    let mut configurations = robot.arm.follow(&backwards, &robot.configuration)?.configurations;
    configurations.reverse();

    let at_rest = [0.0; TWIST];
    let wrenches = std::iter::once(&at_rest).chain(&scenario.wrenches);
    let torques: Vec<JointVector> = configurations
        .iter()
        .zip(wrenches)
        .map(|(configuration, wrench)| torque(robot, configuration, wrench))
        .collect();
    let speed = |step: usize| match step {
        0 => JointVector::zeros(),
        _ => (configurations[step] - configurations[step - 1]) / tables.time_step,
    };
    let speeds: Vec<JointVector> = (0..=last).map(speed).collect();
    let joints = robot.arm.joints().len();
    Ok(JointCourse {
        positions: by_joint(joints, &configurations, ANGLE),
        speeds: by_joint(joints, &speeds, ANGLE),
        torques: by_joint(joints, &torques, FORCE),
    })
}

/// What the controller adds to gravity: `J' wrench`.
fn torque(robot: &Robot, configuration: &JointVector, wrench: &[f64; TWIST]) -> JointVector {
    let posture = robot.arm.posture(configuration);
    posture.gravity(&GRAVITY) + posture.jacobian().tr_mul(&Vector6::from(*wrench))
}

fn by_joint(joints: usize, values: &[JointVector], decimals: i32) -> Vec<Vec<f64>> {
    (0..joints).map(|joint| values.iter().map(|value| rounded(value[joint], decimals)).collect()).collect()
}

fn isometry(state: &[f64; STATE]) -> Isometry3<f64> {
    let rotation = UnitQuaternion::new_normalize(Quaternion::new(state[3], state[4], state[5], state[6]));
    Isometry3::from_parts(Translation3::new(state[0], state[1], state[2]), rotation)
}
