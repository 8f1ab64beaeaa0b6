//! Explanation of a problem before it is solved.

use plan::Engagement;
use plan::pose_clearance::PoseClearance;
use serde::Serialize;

use crate::check::clear_path::ClearPath;
use crate::check::parts::{MeshReport, PartReport};
use crate::check::penetrations::PosePenetration;

/// Explanation of a problem before it is solved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Explanation {
    /// Title of the scene.
    pub title: String,
    /// Name of the start.
    pub start: String,
    /// Offset magnitude `delta-hat`.
    pub delta_m: f64,
    /// Convex parts of the body.
    pub body: Vec<PartReport>,
    /// Convex parts of the environment.
    pub environment: Vec<PartReport>,
    /// Meshes of both, and their convex parts.
    pub meshes: Vec<MeshReport>,
    /// The tightest fit of a round part in a round hole, of meshes.
    pub fit: Option<FitReport>,
    /// How far both sides are apart along the straight path, as given and as convex parts; empty where the scene states
    /// facets or clearances of meshes, and without meshes.
    pub gaps: Vec<GapReport>,
    /// Pairs that may touch.
    pub pairs: usize,
    /// Pairs that are left out because no motion from start to goal comes near to them.
    pub culled_pairs: Vec<String>,
    /// Clearance at the goal and on the straight path back to the start.
    pub insertion: Vec<PoseClearance>,
    /// How far clearance lets the body rest from its goal in directions across the insertion that are guided; null where none
    /// is, or something stops it on one side only.
    pub farthest_rest_m: Option<f64>,
    /// Pairs that penetrate at the goal or at the start with an offset.
    pub penetrations: Vec<PosePenetration>,
    /// Whether the body gets from start to goal in clearance.
    pub path: ClearPath,
    /// Edges of the box around the body, in its frame.
    pub body_edges_m: [f64; 3],
    /// Edges of the box around the environment.
    pub environment_edges_m: [f64; 3],
    /// What guides the body at its goal, and how deep.
    pub engagement: Engagement,
    /// Largest final distance from the goal of a success.
    pub position_tolerance_m: f64,
    /// How deep exact shapes may penetrate in a plan that is done.
    pub allowed_penetration_m: f64,
    /// Why no plan can be made; null where one may be found.
    pub refusal: Option<String>,
    /// How large the optimal control problem is.
    pub size: SizeReport,
    /// Defaults that were chosen for the scene.
    pub chosen: Vec<String>,
    /// Likely mistakes.
    pub warnings: Vec<String>,
}

/// A round part in a round hole.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct FitReport {
    /// Radius of the hole.
    pub hole_radius_m: f64,
    /// Difference of the radii.
    pub gap_m: f64,
    /// Loss of gap by facets.
    pub lost_m: f64,
    /// Largest additional loss by the mesh of the hole: its flat sides lie inside the hole.
    pub mesh_lost_m: f64,
}

/// The distance of both sides at a pose of the straight path.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct GapReport {
    /// Distance from the goal.
    pub from_goal_m: f64,
    /// Between meshes and shapes as they are given, zero where they meet.
    pub given_m: f64,
    /// Between convex parts, negative where they penetrate.
    pub parts_m: f64,
}

impl From<&scene::Gap> for GapReport {
    fn from(gap: &scene::Gap) -> Self {
        Self { from_goal_m: gap.from_goal, given_m: gap.given, parts_m: gap.parts }
    }
}

/// Size of an optimal control problem, and what solving it needs on a common processor: estimates.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct SizeReport {
    /// Its steps.
    pub steps: usize,
    /// Length of a step.
    pub time_step_s: f64,
    /// Its scenarios.
    pub scenarios: usize,
    /// Its variables.
    pub variables: usize,
    /// Its constraints.
    pub constraints: usize,
    /// Time of a plain solve.
    pub seconds: f64,
    /// Memory.
    pub megabytes: f64,
}
