//! Explains a scene and finds mistakes, without solving it.

mod clear_path;
mod delay;
mod explanation;
mod oddities;
mod pairs;
mod parts;
pub(crate) mod penetrations;
pub(crate) mod refusal;
mod sliding;

use ocp::{Layout, blocks, standard_terms};
use plan::pose_clearance::along_insertion;
use plan::ranges::require;
use plan::{PlannerError, Problem};
use scene::Part;
use serde::Serialize;
use task::{ContactPair, Pose};

use crate::check::oddities::oddities;
use crate::check::penetrations::penetrations;
use crate::warnings;

pub use clear_path::ClearPath;
pub use explanation::{Explanation, FitReport, GapReport, SizeReport};
pub(crate) use oddities::{first_smoothing, rest, step};
pub use parts::{DeviationReport, MeshReport, PartReport, RoundSurface};
pub use penetrations::PosePenetration;
pub use plan::pose_clearance::{AxisClearance, PoseClearance};
pub use refusal::refusal;

/// Time of plain solves of the shipped scenes on two cores.
const SECONDS_PER_CONSTRAINT: f64 = 4e-4;
/// Their memory.
const MEGABYTES: f64 = 15.0;
const MEGABYTES_PER_CONSTRAINT: f64 = 9e-3;

/// Distances of one pair at one pose.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PairReport {
    /// Part of the body.
    pub body: String,
    /// Part of the environment.
    pub environment: String,
    /// `Phi_tau`.
    pub smoothed_distance_m: f64,
    /// Negative where the parts penetrate.
    pub exact_distance_m: f64,
    /// `n_tau`.
    pub normal: [f64; 7],
}

/// Every pair's distances at a pose, smoothed by `tau`.
///
/// # Errors
/// When `tau` is out of its range, or a distance cannot be computed.
pub fn pair_reports(problem: &Problem, pose: &Pose, tau: f64) -> Result<Vec<PairReport>, PlannerError> {
    require((1e-9..=1.0).contains(&tau), "tau", tau, "must lie between 1e-9 and 1")?;
    let report = |pair: &ContactPair| {
        let distance = pair
            .shapes
            .distance(pose, tau)
            .map_err(|source| PlannerError::Distance { pair: pair.to_string(), source })?;
        Ok(PairReport {
            body: pair.body.clone(),
            environment: pair.environment.clone(),
            smoothed_distance_m: distance.smoothed_distance,
            exact_distance_m: pair.shapes.exact_distance(pose),
            normal: distance.contact_normal,
        })
    };
    problem.task().pairs.iter().map(report).collect()
}

/// Explains a problem. Comparing meshes with their convex parts takes some seconds for large ones.
///
/// # Errors
/// When a distance at the start, smoothed by `tau`, cannot be computed.
pub fn explain(problem: &Problem, tau: f64) -> Result<Explanation, PlannerError> {
    let (scene, task) = (problem.scene(), problem.task());
    pair_reports(problem, &task.start, tau)?;
    let reports = |parts: &[Part]| parts.iter().map(PartReport::from).collect();
    let meshes = scene.body_meshes.iter().chain(&scene.environment_meshes);
    let name = |&(part, other): &(usize, usize)| format!("{}/{}", scene.body[part].name, scene.environment[other].name);
    let fit = scene.fit.zip(meshes.clone().map(|mesh| mesh.settings.facets).min());
    let path = clear_path::find(task);
    let mut explanation = Explanation {
        title: scene.title.clone(),
        start: problem.start().name.clone(),
        delta_m: problem.offset_magnitude(),
        body: reports(&scene.body),
        environment: reports(&scene.environment),
        meshes: meshes.map(MeshReport::from).collect(),
        fit: fit.map(|(fit, facets)| FitReport {
            hole_radius_m: fit.hole,
            gap_m: fit.gap,
            lost_m: fit.lost(facets),
            mesh_lost_m: fit.mesh_error,
        }),
        gaps: scene.gaps.iter().map(GapReport::from).collect(),
        pairs: task.pairs.len(),
        culled_pairs: scene.culled_pairs.iter().map(name).collect(),
        insertion: along_insertion(task),
        farthest_rest_m: problem.engagement().rest_m,
        penetrations: penetrations(task, scene.robustness.rotation_error),
        path,
        body_edges_m: parts::edges(&scene.body, &scene.body_meshes),
        environment_edges_m: parts::edges(&scene.environment, &scene.environment_meshes),
        engagement: problem.engagement().clone(),
        position_tolerance_m: problem.success().position,
        allowed_penetration_m: problem.allowed_penetration(),
        refusal: refusal(problem).or_else(|| refusal::enclosed(&path)),
        size: size(problem),
        chosen: problem.chosen(),
        warnings: warnings::of_problem(problem),
    };
    let oddities = oddities(problem, &explanation);
    explanation.warnings.extend(oddities);
    Ok(explanation)
}

fn size(problem: &Problem) -> SizeReport {
    let (task, settings) = (problem.task(), problem.homotopy());
    let layout = Layout::new(task, &blocks(&standard_terms(task, settings.complementarity)));
    let constraints = layout.constraint_count();
    SizeReport {
        steps: layout.steps,
        time_step_s: task.horizon.time_step,
        scenarios: layout.scenarios,
        variables: layout.variable_count(),
        constraints,
        seconds: SECONDS_PER_CONSTRAINT * constraints as f64,
        megabytes: MEGABYTES + MEGABYTES_PER_CONSTRAINT * constraints as f64,
    }
}
