//! Which offsets a plan covers, in `result.json`.

use std::fmt;

use plan::{Millimetres, Problem};
use serde::{Deserialize, Serialize};
use simulation::offsets;
use task::Coverage;

/// Which offsets a plan covers.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct CoverageRecord {
    /// The kind of [`Coverage`].
    pub kind: CoverageKind,
    /// Axis of a disc (body frame); null without one.
    pub axis: Option<[f64; 3]>,
    /// Length up to which every offset is covered: of a disc across its axis, of a hull in the directions that the planned
    /// offsets span.
    pub radius_m: f64,
}

/// The kind of a [`Coverage`].
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
#[allow(missing_docs, reason = "named as those of a coverage")]
pub enum CoverageKind {
    #[default]
    Hull,
    Disc,
    Ball,
}

impl From<&Problem> for CoverageRecord {
    fn from(problem: &Problem) -> Self {
        let offset_magnitude = problem.offset_magnitude();
        let (kind, axis, radius_m) = match problem.scene().coverage {
            Coverage::Hull => (CoverageKind::Hull, None, offsets::worst_direction(&problem.task().offsets())),
            Coverage::Disc { axis } => (CoverageKind::Disc, Some(axis), offset_magnitude),
            Coverage::Ball => (CoverageKind::Ball, None, offset_magnitude),
        };
        Self { kind, axis, radius_m }
    }
}

/// Such as `up to 0.80 mm in any direction across the insertion`.
impl fmt::Display for CoverageRecord {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let radius = Millimetres(self.radius_m);
        match self.kind {
            CoverageKind::Hull => {
                write!(formatter, "inside the hull of the planned offsets, {radius} mm in the worst direction")
            }
            CoverageKind::Disc => write!(formatter, "up to {radius} mm in any direction across the insertion"),
            CoverageKind::Ball => write!(formatter, "up to {radius} mm in any direction"),
        }
    }
}
