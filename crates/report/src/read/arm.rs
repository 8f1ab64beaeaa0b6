//! Joints of the scene's arm along a motion.

use plan::{ArmCourse, Problem};
use robot::{FollowError, Joint, JointVector};
use scene::Robot;
use store::{MotionTables, ScenarioTables};
use task::GraspError;

use crate::model::{JointCourse, JointData};
use crate::rounded::{ANGLE, FORCE, LENGTH, rounded};

/// The joints of a scene's arm; none without one.
pub fn joints(problem: &Problem) -> Vec<JointData> {
    problem.scene().robot.as_ref().map_or_else(Vec::new, |robot| robot.arm.joints().iter().map(joint).collect())
}

/// Positions, speeds and torques of the joints along a motion, one list per grasp error; none for a scene without an
/// arm, and where the arm does not reach a pose or a joint is too slow, of which the plan warns.
pub fn courses(problem: &Problem, tables: &MotionTables, grasps: &[GraspError]) -> Vec<JointCourse> {
    let Some(robot) = &problem.scene().robot else { return Vec::new() };
    let scenarios = tables.scenarios.iter().zip(grasps);
    let courses: Result<Vec<JointCourse>, FollowError> =
        scenarios.map(|(scenario, grasp)| course(robot, tables.time_step, grasp, scenario)).collect();
    courses.unwrap_or_default()
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
