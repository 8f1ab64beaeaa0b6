//! Remarks on where an arm is used.

use super::Robot;
use crate::error::SceneError;
use crate::table::Table;

/// A joint nearer to its limit (rad or m) than this needs a remark.
const NEAR_LIMIT: f64 = 0.05;
/// Smallest singular value of the Jacobian that needs no remark.
const NEAR_SINGULAR: f64 = 0.05;

/// Remarks on limits and singular postures on the straight ways between goal and starts, and on keys that the arm
/// replaces.
pub fn warnings(scene: &Table, robot: Option<&Robot>) -> Result<Vec<String>, SceneError> {
    let (table, body) = (scene.table("robot")?, scene.require_table("body")?);
    let mut warnings = Vec::new();
    if table.find("urdf").or_else(|| table.find("apparent_inertia")).is_some() {
        for entry in ["mass", "inertia"].iter().filter_map(|name| body.find(name)) {
            let message = format!("{} is not used: the robot's inertia replaces it", entry.path());
            warnings.push(entry.refuse_name(message).headline());
        }
    }
    if let (Some(robot), Some(entry)) = (robot, table.find("configuration")) {
        let remark = |message: String| entry.refuse(message).headline();
        warnings.extend(near_limit(robot).map(remark));
        warnings.extend(near_singular(robot).map(remark));
    }
    Ok(warnings)
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
            "between start and goal, the arm comes near a singular posture (smallest singular value {smallest:.3}): choose \
             another configuration or base"
        )
    })
}
