//! Positions, orientations and directions.

use nalgebra::{Isometry3, Quaternion, UnitQuaternion, Vector3};
use task::algebra::norm;
use toml::Spanned;

use crate::entry::Entry;
use crate::error::SceneError;
use crate::table::Table;

/// How far the norm of a quaternion or direction may be from 1: files are written with few digits.
pub const NORM_TOLERANCE: f64 = 1e-3;

/// A start pose with its name.
#[derive(Debug, Clone, PartialEq)]
pub struct StartPose {
    /// Unique name.
    pub name: String,
    /// Position (m) and unit quaternion (w x y z).
    pub pose: [f64; 7],
}

/// Position (m) and unit quaternion of a start or goal.
pub fn pose(table: &Table) -> Result<[f64; 7], SceneError> {
    let [x, y, z] = table.require("position")?.vector()?;
    let [w, i, j, k] = orientation(&table.require("orientation")?)?;
    Ok([x, y, z, w, i, j, k])
}

/// A unit quaternion (w x y z), scaled to exact norm.
pub fn orientation(entry: &Entry) -> Result<[f64; 4], SceneError> {
    let value = entry.quaternion()?;
    let norm = norm(&value);
    if !is_unit(norm) {
        let path = entry.path();
        return Err(entry.refuse(format!("{path}: a quaternion [w, x, y, z] has norm 1, this one has norm {norm:.4}")));
    }
    Ok(value.map(|component| component / norm))
}

/// Unit directions, or zeros for no offset; kept as written.
pub fn directions(entry: &Entry) -> Result<Vec<[f64; 3]>, SceneError> {
    let direction = |direction: Spanned<[f64; 3]>| {
        let norm = norm(direction.get_ref());
        if is_unit(norm) || *direction.get_ref() == [0.0; 3] {
            return Ok(direction.into_inner());
        }
        let path = entry.path();
        let message = format!("{path}: a direction has norm 1, or is [0, 0, 0]; this one has norm {norm:.4}");
        Err(entry.source().error(direction.span(), message))
    };
    entry.vectors()?.into_iter().map(direction).collect()
}

/// A unit direction, kept as written.
pub fn direction(entry: &Entry) -> Result<[f64; 3], SceneError> {
    let value = entry.direction()?;
    let norm = norm(&value);
    if is_unit(norm) {
        return Ok(value);
    }
    let path = entry.path();
    Err(entry.refuse(format!("{path}: a direction has norm 1; this one has norm {norm:.4}")))
}

/// From a frame to the one in which it has this position (m) and unit quaternion (w x y z).
pub fn isometry(position: &[f64; 3], &[w, x, y, z]: &[f64; 4]) -> Isometry3<f64> {
    let rotation = UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z));
    Isometry3::from_parts(Vector3::from(*position).into(), rotation)
}

/// The frame that has a pose (position m, quaternion w x y z).
pub fn of_pose(pose: &[f64; 7]) -> Isometry3<f64> {
    let [x, y, z, quaternion @ ..] = task::pose::normalised(pose);
    isometry(&[x, y, z], &quaternion)
}

/// The frame at a share (0 to 1) of the straight path between two.
pub fn between(from: &Isometry3<f64>, to: &Isometry3<f64>, share: f64) -> Isometry3<f64> {
    let rotation = from.rotation.try_slerp(&to.rotation, share, 1e-9).unwrap_or(to.rotation);
    Isometry3::from_parts(from.translation.vector.lerp(&to.translation.vector, share).into(), rotation)
}

fn is_unit(norm: f64) -> bool {
    (norm - 1.0).abs() <= NORM_TOLERANCE
}
