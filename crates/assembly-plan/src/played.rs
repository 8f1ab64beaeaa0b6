//! Plans that are played, with their problems.

use std::path::Path;

use planner::files::{RESOLVED, StoredPlan};
use planner::{Choices, PlannerError, Problem};

use crate::arguments::ToleranceArguments;
use crate::console::tell;

/// The problem of a plan in the given scene, which must have the plan's shapes, start and goal.
pub fn problem_of(
    scene: Option<&Path>,
    tolerance: &ToleranceArguments,
    plan: StoredPlan,
) -> Result<(StoredPlan, Problem), PlannerError> {
    let choices = Choices {
        start: Some(plan.result.start.clone()),
        offset_magnitude: Some(plan.result.delta_m),
        rotation_error: Some(plan.result.turn_rad),
        position_tolerance: tolerance.position_tolerance,
        angle_tolerance: tolerance.angle_tolerance,
        ..Choices::default()
    };
    let file = scene.map_or_else(|| plan.folder.join(RESOLVED), Path::to_owned);
    let problem = Problem::load(&file, &choices)
        .map_err(|error| PlannerError::file(&plan.folder, format!("the plan does not fit the scene: {error}")))?;
    let folder = plan.folder.display();
    if scene.is_none() {
        plan.problem()?;
    } else if !plan.require_made_for(&problem)? {
        tell!("warning: {folder}: the plan was made with other settings than {} has", file.display());
    }
    if plan.result.is_unconverged() {
        tell!("warning: {folder}: the plan did not converge");
    }
    Ok((plan, problem))
}
