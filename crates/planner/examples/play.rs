//! Plays a plan with hard contact and injected offsets, beside an unplanned straight push:
//! `cargo run -p planner --example play -- scenes/corner.toml`.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use planner::{
    Choices, Event, GraspErrors, Motion, OffsetSource, PlannerError, PlayedRollout, Problem, Session,
    SimulationRequest, SuccessTable,
};

fn main() -> Result<(), PlannerError> {
    let scene = std::env::args().nth(1).unwrap_or_else(|| "scenes/corner.toml".to_owned());
    let rollouts = play(Path::new(&scene), &[[0.01, 0.0, 0.0], [0.0, 0.005, 0.0], [-0.005, 0.01, 0.0]])?;
    for PlayedRollout { motion, friction, grasp, outcome, success, .. } in &rollouts {
        let [x, y, z] = grasp.offset.map(|component| 1e3 * component);
        let (error, end) = (1e3 * outcome.position_error, if *success { "reaches" } else { "misses" });
        println!("{motion}, friction {friction}, offset {x} {y} {z} mm: {end} the goal by {error:.2} mm");
    }
    for group in SuccessTable::new(&rollouts).groups() {
        println!("{}, friction {}: {} of {}", group.motion, group.friction, group.successes, group.rollouts);
    }
    Ok(())
}

/// Rollouts of the plan of a scene, and of a straight push, with some offsets (m, body frame) at two frictions.
///
/// # Errors
/// When the scene or an offset is wrong.
pub fn play(scene: &Path, offsets: &[[f64; 3]]) -> Result<Vec<PlayedRollout>, PlannerError> {
    let problem = Problem::load(scene, &Choices::default())?;
    let stopped = AtomicBool::new(false);
    let session = Session::new(&|_: &Event| {}, &stopped);
    let plan = planner::solve(&problem, &session)?;
    let errors = GraspErrors { offsets: OffsetSource::Listed(offsets.to_vec()), ..GraspErrors::default() };
    let request = SimulationRequest { errors, frictions: vec![0.0, 0.3], ..SimulationRequest::default() };
    planner::simulate(&problem, &[(Motion::Plan, plan.reference())], &request, &session)
}
