//! Joints of the scene's arm along a plan.

use planner::files::{GraspRecord, MotionTables, ScenarioTables};
use planner::{ArmCourse, Problem};
use robot::{FollowError, Joint, JointVector};
use scene::Robot;
use task::GraspError;

use crate::model::{ArmData, JointCourse, JointData};
use crate::rounded::{ANGLE, FORCE, LENGTH, rounded};

/// Positions, speeds and torques of the joints with each grasp error, one per scenario; `None` for a scene without an
/// arm.
///
/// # Errors
/// When the arm does not reach a pose, or a joint is too slow.
pub fn courses<'grasps>(
    problem: &Problem,
    tables: &MotionTables,
    grasps: impl Iterator<Item = &'grasps GraspRecord>,
) -> Option<Result<ArmData, FollowError>> {
    let robot = problem.scene().robot.as_ref()?;
    let scenarios = tables.scenarios.iter().zip(grasps);
    let scenarios =
        scenarios.map(|(scenario, grasp)| course(robot, tables.time_step, &GraspError::from(grasp), scenario));
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

fn course(
    robot: &Robot,
    time_step: f64,
    grasp: &GraspError,
    scenario: &ScenarioTables,
) -> Result<JointCourse, FollowError> {
    let ArmCourse { configurations, torques } =
        ArmCourse::new(robot, time_step, grasp, &scenario.states, &scenario.wrenches)?;
    let speed = |step: usize| match step {
        0 => JointVector::zeros(),
        _ => (configurations[step] - configurations[step - 1]) / time_step,
    };
    let speeds: Vec<JointVector> = (0..configurations.len()).map(speed).collect();
    let joints = robot.arm.joints().len();
    let skeleton = |configuration| {
        let points = robot.arm.skeleton(configuration);
        points.iter().flat_map(|point| point.iter().map(|&coordinate| rounded(coordinate, LENGTH))).collect()
    };
    Ok(JointCourse {
        positions: by_joint(joints, &configurations, ANGLE),
        speeds: by_joint(joints, &speeds, ANGLE),
        torques: by_joint(joints, &torques, FORCE),
        skeletons: configurations.iter().map(skeleton).collect(),
    })
}

fn by_joint(joints: usize, values: &[JointVector], decimals: i32) -> Vec<Vec<f64>> {
    (0..joints).map(|joint| values.iter().map(|value| rounded(value[joint], decimals)).collect()).collect()
}
