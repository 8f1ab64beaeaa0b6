//! Positions, orientations and directions.

use task::Pose;
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
    /// With a unit quaternion.
    pub pose: Pose,
}

/// Where motions begin and end.
#[derive(Debug, Clone, Copy)]
pub struct Endpoints<'scene> {
    /// Where plans may begin, at least one.
    pub starts: &'scene [StartPose],
    /// Where all of them end.
    pub goal: &'scene Pose,
}

/// Pose of a start or goal, with a unit quaternion.
pub fn pose(table: &Table) -> Result<Pose, SceneError> {
    let position = table.require("position")?.vector()?;
    Ok(Pose::new(position, orientation(&table.require("orientation")?)?))
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

fn is_unit(norm: f64) -> bool {
    (norm - 1.0).abs() <= NORM_TOLERANCE
}
