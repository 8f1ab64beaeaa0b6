//! Grasp errors in `result.json` and in what an unfinished refinement leaves behind.

use std::fmt;

use serde::{Deserialize, Serialize};
use task::GraspError;

use crate::length::decimals;

/// A [`GraspError`].
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct GraspRecord {
    /// Offset of the part in the gripper.
    pub offset_m: [f64; 3],
    /// Its rotation error, a rotation vector.
    #[serde(default)]
    pub turn_rad: [f64; 3],
}

impl From<&GraspError> for GraspRecord {
    fn from(grasp: &GraspError) -> Self {
        Self { offset_m: grasp.offset, turn_rad: grasp.rotation }
    }
}

impl From<&GraspRecord> for GraspError {
    fn from(record: &GraspRecord) -> Self {
        Self { offset: record.offset_m, rotation: record.turn_rad }
    }
}

/// Such as `offset 1.0 0.0 -2.0 mm`, with the rotation error if there is one.
impl fmt::Display for GraspRecord {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let decimals = decimals(self.offset_m.iter().fold(0.0, |most: f64, component| most.max(component.abs())));
        let [x, y, z] = self.offset_m.map(|component| 1e3 * component);
        write!(formatter, "offset {x:.decimals$} {y:.decimals$} {z:.decimals$} mm")?;
        if self.turn_rad == [0.0; 3] {
            return Ok(());
        }
        let [x, y, z] = self.turn_rad;
        write!(formatter, " and rotation error {x:.3} {y:.3} {z:.3} rad")
    }
}
