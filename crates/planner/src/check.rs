//! What a scene says, and what is odd about it, without solving it.

use ocp::{Layout, standard_terms};
use serde::Serialize;
use task::pose::without_offset;
use task::{AssemblyTask, ContactPair};

use crate::error::PlannerError;
use crate::problem::Problem;
use crate::refine::require;

/// Distances of one pair at one pose.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct PairReport {
    /// Part of the body.
    pub body: String,
    /// Part of the environment.
    pub environment: String,
    /// `Phi_tau`.
    pub smoothed_distance_m: f64,
    /// Negative where the parts overlap.
    pub exact_distance_m: f64,
    /// `n_tau`.
    pub normal: [f64; 7],
}

/// What there is to know of a problem before it is solved.
#[derive(Debug, Clone)]
pub struct Explanation {
    /// Smallest exact distance at the goal (m).
    pub goal_clearance: f64,
    /// Smallest exact distance at the start (m), without offset.
    pub start_clearance: f64,
    /// Every offset (m), and the smallest exact distance at the start with it (m).
    pub offset_clearances: Vec<([f64; 3], f64)>,
    /// Steps of the optimal control problem.
    pub steps: usize,
    /// Its scenarios.
    pub scenarios: usize,
    /// Its variables.
    pub variables: usize,
    /// Its constraints.
    pub constraints: usize,
    /// What is odd.
    pub warnings: Vec<String>,
}

/// Every pair's distances at a pose, smoothed by `tau`.
///
/// # Errors
/// When `tau` is out of its range, or a distance cannot be computed.
pub fn pair_reports(problem: &Problem, pose: &[f64; 7], tau: f64) -> Result<Vec<PairReport>, PlannerError> {
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

/// Explains a problem.
pub fn explain(problem: &Problem) -> Explanation {
    let (task, settings) = (problem.task(), problem.homotopy());
    let layout = Layout::new(task, &standard_terms(task, settings.complementarity));
    let clearance = |offset: &[f64; 3]| (*offset, task.clearance(&without_offset(&task.start, offset)));
    let mut explanation = Explanation {
        goal_clearance: task.clearance(&task.goal),
        start_clearance: task.clearance(&task.start),
        offset_clearances: task.offsets.iter().map(clearance).collect(),
        steps: layout.steps,
        scenarios: layout.scenarios,
        variables: layout.variable_count(),
        constraints: layout.constraint_count(),
        warnings: problem.warnings(),
    };
    explanation.warnings.extend(oddities(&explanation));
    explanation.warnings.extend(smoothing_oddity(task, settings.tau));
    explanation
}

fn oddities(explanation: &Explanation) -> Vec<String> {
    let overlapping = |(number, &(_, distance)): (usize, &([f64; 3], f64))| {
        (distance < 0.0).then(|| format!("with offset {number} the body overlaps the environment at the start"))
    };
    let mut warnings: Vec<String> = (1..).zip(&explanation.offset_clearances).filter_map(overlapping).collect();
    if explanation.goal_clearance < 0.0 {
        warnings.push("the body overlaps the environment at the goal; it cannot be reached".to_owned());
    }
    warnings
}

/// The first smoothing is smaller than the offset: the plan may then end in a wrong optimum. It often does not, and
/// success is not monotone in the first smoothing, so that this is no more than a hint.
fn smoothing_oddity(task: &AssemblyTask, tau: f64) -> Option<String> {
    let norm = |offset: &[f64; 3]| offset.iter().map(|component| component * component).sum::<f64>().sqrt();
    let largest = task.offsets.iter().map(norm).fold(0.0, f64::max);
    let rows = task.pairs.iter().map(|pair| pair.shapes.row_count()).min()?;
    let reach = tau * rows as f64;
    (reach < 1.5 * largest).then(|| {
        format!(
            "the first smoothing reaches {:.1} mm, the offset is {:.1} mm; if plans miss the goal, try a larger \
             homotopy.tau",
            1e3 * reach,
            1e3 * largest
        )
    })
}
