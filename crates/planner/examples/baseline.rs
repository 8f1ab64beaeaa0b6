//! What the optimal control problem is worth: beside robust plans, a straight push that is refined by the same loop for
//! the same time without solving anything. Prints a row of a Markdown table per scene; `scripts/lab baseline` makes a page
//! of it.

use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::{Duration, Instant};

use planner::{
    Choices, Event, GraspErrors, Motion, OffsetSource, PlannerError, Problem, Region, RobustnessTarget, Session,
    SimulationRequest,
};
use simulation::Reference;

/// Magnitudes of the random offsets, as fractions of delta-hat.
const FRACTIONS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 0.95];
/// Random offsets per friction and magnitude.
const OFFSETS: usize = 50;
/// Seed of the offsets, another than those of the loop.
const SEED: u64 = 7;

fn main() -> Result<(), PlannerError> {
    for scene in std::env::args().skip(1) {
        println!("{}", row(Path::new(&scene))?);
    }
    Ok(())
}

/// Success rates and forces of four references, and the times they took.
fn row(scene: &Path) -> Result<String, PlannerError> {
    let problem = Problem::load(scene, &Choices::default())?;
    let target = RobustnessTarget::default();
    let stopped = AtomicBool::new(false);
    let session = Session::new(&|_: &Event| {}, &stopped);
    let task = problem.task();
    let push = Reference::straight(&task.start, &task.goal, task.horizon);

    let begin = Instant::now();
    let plan = planner::solve(&problem, &session)?;
    let solve_time = begin.elapsed();
    let plain = plan.reference();
    let robust = planner::refine(plan, &target, &session)?;
    let robust_time = begin.elapsed();
    let same_time = RobustnessTarget { time_limit: robust_time, ..target.clone() };
    let (refined_push, pushed) = planner::refine_reference(&problem, push.clone(), &same_time, &session)?;
    let found_after = if pushed.reached { Duration::from_secs_f64(pushed.wall_s) } else { robust_time };

    let play = |reference: &Reference| played(&problem, reference, &target);
    let (push, refined_push, plain, robust) =
        (play(&push)?, play(&refined_push)?, play(&plain)?, play(&robust.reference())?);
    Ok(format!(
        "| {} | {push} | {refined_push} | {:.1} | {plain} | {:.1} | {robust} | {:.1} |",
        problem.scene().title,
        found_after.as_secs_f64(),
        solve_time.as_secs_f64(),
        robust_time.as_secs_f64()
    ))
}

/// Success rate at random offsets and the planned ones, all frictions together, and the largest contact force, as two
/// cells of a table.
fn played(problem: &Problem, reference: &Reference, target: &RobustnessTarget) -> Result<String, PlannerError> {
    let offset_magnitude = problem.offset_magnitude();
    let random = GraspErrors {
        offsets: OffsetSource::Random(OFFSETS, Region::Hull),
        magnitudes: FRACTIONS.map(|fraction| fraction * offset_magnitude).to_vec(),
        seed: SEED,
        rotation_error: 0.0,
    };
    let motions = [(Motion::Plan, reference.clone())];
    let mut rollouts = Vec::new();
    for errors in [random, GraspErrors::default()] {
        let request = SimulationRequest { errors, frictions: target.frictions.clone(), ..SimulationRequest::default() };
        let never = AtomicBool::new(false);
        let session = Session::new(&|_: &Event| {}, &never);
        rollouts.extend(planner::simulate(problem, &motions, &request, &session)?);
    }
    // Beside every rollout of the plan there is one of the push.
    rollouts.retain(|rollout| rollout.motion == Motion::Plan);
    let successes = rollouts.iter().filter(|rollout| rollout.success).count();
    let force = rollouts.iter().map(|rollout| rollout.outcome.loads.contact_force).fold(0.0, f64::max);
    Ok(format!("{:.1} | {force:.0}", 100.0 * successes as f64 / rollouts.len() as f64))
}
