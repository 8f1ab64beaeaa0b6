//! Whether an arm can move as a plan asks it to.

use nalgebra::{Isometry3, Quaternion, UnitQuaternion, Vector3, Vector6};
use robot::{JointPath, JointVector};
use scene::Robot;
use task::{STATE, Trajectory};

use crate::plan::Plan;

/// Joints, speeds and torques of the reference that the arm cannot have; nothing without an arm.
pub fn warnings(plan: &Plan) -> Vec<String> {
    let Some(robot) = &plan.problem.scene().robot else { return Vec::new() };
    match path(robot, &plan.trajectory) {
        Ok(path) => torque(robot, &plan.trajectory, &path).into_iter().collect(),
        Err(reason) => vec![format!(
            "the arm cannot follow the reference: {reason}; change robot.configuration or robot.base, or give [horizon] more \
             steps"
        )],
    }
}

/// Joint positions along the reference, on the branch of the goal's.
fn path(robot: &Robot, trajectory: &Trajectory) -> Result<JointPath, String> {
    let time = |index: usize| index as f64 * trajectory.time_step;
    let poses = || trajectory.reference.iter().enumerate().map(|(index, state)| (time(index), pose(state)));
    // The branch is known at the goal: backwards first, at any speed.
    let backwards: Vec<(f64, Isometry3<f64>)> =
        poses().map(|(_, pose)| pose).rev().enumerate().map(|(index, pose)| (1e3 * (index + 1) as f64, pose)).collect();
    let to_start = robot.arm.follow(&backwards, &robot.configuration).map_err(|error| error.reason.to_string())?;
    let start = to_start.configurations.last().unwrap_or(&robot.configuration);
    robot.arm.follow(&poses().collect::<Vec<_>>(), start).map_err(|error| error.to_string())
}

/// The joint whose torque, in the motions of all scenarios, exceeds its limit most: the wrench of the controller as the
/// arm feels it, gravity besides.
fn torque(robot: &Robot, trajectory: &Trajectory, path: &JointPath) -> Option<String> {
    let gravity = Vector3::new(0.0, 0.0, -9.81);
    let mut worst: Option<(f64, usize, f64, usize)> = None;
    for scenario in &trajectory.scenarios {
        for (step, wrench) in (1..).zip(&scenario.wrenches) {
            let posture = robot.arm.posture(&path.configurations[step]);
            let torques: JointVector = posture.gravity(&gravity) + posture.jacobian().tr_mul(&Vector6::from(*wrench));
            for (joint, limits) in robot.arm.joints().iter().enumerate() {
                let share = torques[joint].abs() / limits.effort;
                if share > worst.map_or(1.0, |(largest, ..)| largest) {
                    worst = Some((share, joint, torques[joint].abs(), step));
                }
            }
        }
    }
    let (_, joint, torque, step) = worst?;
    let joint = &robot.arm.joints()[joint];
    Some(format!(
        "joint `{}` would need {torque:.1} at {:.2} s, and its limit is {:.1} (Nm or N): lower impedance or \
         robustness.offset_magnitude",
        joint.name,
        step as f64 * trajectory.time_step,
        joint.effort
    ))
}

fn pose(state: &[f64; STATE]) -> Isometry3<f64> {
    let [x, y, z, w, i, j, k, ..] = *state;
    let rotation = UnitQuaternion::new_normalize(Quaternion::new(w, i, j, k));
    Isometry3::from_parts(Vector3::new(x, y, z).into(), rotation)
}
