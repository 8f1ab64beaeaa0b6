//! Remarks on an arm and on where it is used.

use ::robot::Joint;
use nalgebra::Vector3;
use task::Impedance;

use super::{Interface, Robot};
use crate::error::SceneError;
use crate::table::Table;

/// A joint nearer to its limit (rad or m) than this needs a remark.
const NEAR_LIMIT: f64 = 0.05;
/// Smallest singular value of the Jacobian that needs no remark.
const NEAR_SINGULAR: f64 = 0.05;
/// A joint farther from its given position (rad or m) than this needs a remark: another branch may be nearer.
const FAR_FROM_GIVEN: f64 = 0.3;
/// Gravity (m/s^2, world frame): arms stand or hang upright.
const GRAVITY: Vector3<f64> = Vector3::new(0.0, 0.0, -9.81);
/// Stiffer controllers (N/m, Nm/rad) than robots have.
const STIFFEST: [f64; 2] = [1e4, 1e3];

/// Remarks on the arm's file, on joint positions far from those given, on limits and singular configurations on the straight paths
/// between goal and starts, on gains, and on keys that the arm replaces.
pub fn warnings(scene: &Table, robot: Option<&Robot>, gains: &Impedance) -> Result<Vec<String>, SceneError> {
    let (table, body) = (scene.table("robot")?, scene.require_table("body")?);
    let mut warnings = Vec::new();
    let is_felt = Interface::read(&table)? == Interface::Torque;
    if is_felt && table.find("urdf").or_else(|| table.find("apparent_inertia")).is_some() {
        for entry in ["mass", "inertia"].iter().filter_map(|name| body.find(name)) {
            let message = format!("{} is not used: the robot's inertia replaces it", entry.path());
            warnings.push(entry.refuse_name(message).headline());
        }
    }
    if let (Some(robot), Some(entry), Some(urdf)) = (robot, table.find("configuration"), table.find("urdf")) {
        let at_file = |message: String| urdf.refuse(message).headline();
        warnings.extend(robot.arm.remarks().iter().cloned().map(at_file));
        warnings.extend(too_heavy(robot).map(at_file));
        warnings.extend(too_stiff(gains).map(at_file));
        let at_configuration = |message: String| entry.refuse(message).headline();
        warnings.extend(far_from_given(robot).map(at_configuration));
        warnings.extend(near_limit(robot).map(at_configuration));
        warnings.extend(near_singular(robot).map(at_configuration));
    }
    Ok(warnings)
}

/// Base, grasp and goal determine the arm's configuration as well as `configuration` does: a large difference is a
/// mistake in one of them.
fn far_from_given(robot: &Robot) -> Option<String> {
    let far = |(joint, found, given): (&Joint, f64, f64)| {
        // Not a comparison with `>`, which is false for what is no number.
        let is_near = (found - given).abs() <= FAR_FROM_GIVEN;
        (!is_near).then(|| format!("`{}` at {found:.3} instead of {given:.3} {}", joint.name, joint.kind.unit()))
    };
    let positions = robot.configuration.iter().zip(robot.given.iter());
    let joints = robot.arm.joints().iter().zip(positions).map(|(joint, (found, given))| (joint, *found, *given));
    let joints: Vec<String> = joints.filter_map(far).collect();
    (!joints.is_empty()).then(|| {
        format!(
            "the arm reaches the goal with {}: are these the joint positions that you mean? If not, check robot.base (the \
             frame of the URDF's root link; a controller's own base frame is often turned by half a turn), robot.grasp, \
             robot.tip, and that angles are in radians",
            joints.join(", ")
        )
    })
}

/// The joint that is the least able to hold the arm against gravity at the goal.
fn too_heavy(robot: &Robot) -> Option<String> {
    let torques = robot.arm.at(&robot.configuration).gravity(&GRAVITY);
    let loads = robot.arm.joints().iter().zip(torques.iter().map(|torque| torque.abs()));
    let (joint, torque) = loads.max_by(|(one, a), (other, b)| (a / one.effort).total_cmp(&(b / other.effort)))?;
    let holds = torque <= joint.effort;
    (!holds).then(|| {
        format!(
            "joint `{}` would need {torque:.0} to hold the arm against gravity at the goal, and its limit is {:.0} (Nm or N): \
             are masses in kilograms, and is the z axis of the world upwards?",
            joint.name, joint.effort
        )
    })
}

fn too_stiff(gains: &Impedance) -> Option<String> {
    let values = [gains.translational_stiffness, gains.rotational_stiffness];
    let is_usual = values.iter().zip(STIFFEST).all(|(value, most)| *value <= most);
    (!is_usual).then(|| {
        let [translational, rotational] = values;
        format!(
            "gains of {translational:.0} N/m and {rotational:.0} Nm/rad are stiffer than robots allow: check masses, \
             rotor_inertia and joint_friction, or give robot.stiffness_range"
        )
    })
}

fn near_limit(robot: &Robot) -> Option<String> {
    let nearest = robot.ways.iter().filter_map(|way| way.limit_distance).min_by(|a, b| a.value.total_cmp(&b.value))?;
    (nearest.value < NEAR_LIMIT).then(|| {
        let joint = &robot.arm.joints()[nearest.joint];
        format!(
            "between start and goal, joint `{}` comes within {:.3} {} of its limit: choose another configuration or base",
            joint.name,
            nearest.value,
            joint.kind.unit()
        )
    })
}

fn near_singular(robot: &Robot) -> Option<String> {
    let values = robot.ways.iter().filter_map(|way| way.singular_value);
    let (smallest, _) = values.min_by(|(a, _), (b, _)| a.total_cmp(b))?;
    (smallest < NEAR_SINGULAR).then(|| {
        format!(
            "between start and goal, the arm comes near a singular configuration (smallest singular value {smallest:.3}): choose \
             another configuration or base"
        )
    })
}
