//! Makes the plan of a scene robust and prints its success rates:
//! `cargo run -p planner --example refine -- scenes/corner.toml`.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use planner::{Choices, Event, Plan, PlannerError, Problem, RobustnessTarget, Session, interval, max_force, rate};

fn main() -> Result<(), PlannerError> {
    let scene = std::env::args().nth(1).unwrap_or_else(|| "scenes/corner.toml".to_owned());
    let plan = robust(Path::new(&scene), &[0.0, 0.1])?;
    println!("{}", plan.status());
    let Some(report) = &plan.robustness else { return Ok(()) };
    println!("before refinement {:.1} %, after it {:.1} %", 1e2 * report.rate_before, 1e2 * report.rate_after);
    for groups in report.after.by_friction() {
        let [low, high] = interval(groups).map(|rate| 1e2 * rate);
        let (friction, rate) = (groups[0].friction, 1e2 * rate(groups));
        println!("friction {friction}: {rate:.1} % (95 %: {low:.1} to {high:.1}), at most {:.1} N", max_force(groups));
    }
    Ok(())
}

/// A plan that tolerates these friction coefficients, and everything else that the scene requires.
///
/// # Errors
/// When the scene or a coefficient is wrong.
pub fn robust(scene: &Path, frictions: &[f64]) -> Result<Plan, PlannerError> {
    let problem = Problem::load(scene, &Choices::default())?;
    let stopped = AtomicBool::new(false);
    let session = Session::new(&|_: &Event| {}, &stopped);
    let own = RobustnessTarget::of(&problem.scene().robustness);
    let target = RobustnessTarget { frictions: frictions.to_vec(), target_rate: 0.95, ..own };
    planner::refine(planner::solve(&problem, &session)?, &target, &session)
}
