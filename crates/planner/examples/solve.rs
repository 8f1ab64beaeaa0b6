//! Plans the motion of a scene file and prints the reference: `cargo run -p planner --example solve -- scenes/corner.toml`.

use std::path::Path;
use std::sync::atomic::AtomicBool;

use planner::{Choices, Event, Plan, PlannerError, Problem, Session};

fn main() -> Result<(), PlannerError> {
    let scene = std::env::args().nth(1).unwrap_or_else(|| "scenes/corner.toml".to_owned());
    let plan = plan(Path::new(&scene))?;
    println!("{}", plan.status());
    println!("time (s)  position (m)");
    for (knot, state) in plan.trajectory.reference.iter().enumerate() {
        let [x, y, z, ..] = **state;
        println!("{:8.2}  {x:.4} {y:.4} {z:.4}", knot as f64 * plan.trajectory.time_step);
    }
    Ok(())
}

/// Plans a scene with its own homotopy, from its first start, and prints progress.
///
/// # Errors
/// When the scene is wrong. A plan that misses the goal is no error: [`Plan::status`] says so.
pub fn plan(scene: &Path) -> Result<Plan, PlannerError> {
    let problem = Problem::load(scene, &Choices::default())?;
    // Another thread may set this flag to stop the solve.
    let stopped = AtomicBool::new(false);
    let observer = |event: &Event| {
        if let Event::HomotopyStep { number, most, .. } = event {
            eprintln!("homotopy step {number} of at most {most}");
        }
    };
    planner::solve(&problem, &Session::new(&observer, &stopped))
}
