//! The programs in `examples/` do what they say.

use std::path::PathBuf;

#[allow(dead_code, reason = "its own `main` reads arguments")]
#[path = "../../examples/distances.rs"]
mod distances;
#[allow(dead_code, reason = "its own `main` reads arguments")]
#[path = "../../examples/play.rs"]
mod play;
#[allow(dead_code, reason = "its own `main` reads arguments")]
#[path = "../../examples/refine.rs"]
mod refine;
#[allow(dead_code, reason = "its own `main` reads arguments")]
#[path = "../../examples/scene_in_code.rs"]
mod scene_in_code;
#[allow(dead_code, reason = "its own `main` reads arguments")]
#[path = "../../examples/solve.rs"]
mod solve;

fn corner() -> PathBuf {
    PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/corner.toml"))
}

#[test]
fn a_scene_file_is_planned() {
    let plan = solve::plan(&corner()).unwrap();
    assert!(plan.is_converged() && plan.reaches_goal());
}

#[test]
fn a_scene_in_code_is_planned() {
    let plan = scene_in_code::plan(&scene_in_code::scene([0.1, 0.08, 0.06], 0.01)).unwrap();
    assert!(plan.reaches_goal());
    let error = scene_in_code::plan(&scene_in_code::scene([0.1, 0.08, 0.06], -1.0)).err().unwrap().to_string();
    assert!(error.contains("offset_magnitude"), "{error}");
}

#[test]
fn a_plan_becomes_robust() {
    let plan = refine::robust(&corner(), &[0.0]).unwrap();
    let report = plan.robustness.as_ref().unwrap();
    assert!(report.reached && report.rate_after >= 0.95 && report.after.by_friction().count() == 1);
}

#[test]
fn a_plan_is_played_beside_a_straight_push() {
    let rollouts = play::play(&corner(), &[[0.0; 3], [0.001, 0.0, 0.0]]).unwrap();
    let plans = rollouts.iter().filter(|rollout| rollout.motion == planner::Motion::Plan);
    assert_eq!((rollouts.len(), plans.count()), (8, 4), "two motions, offsets and frictions");
    assert!(rollouts.iter().all(|rollout| !rollout.outcome.diverged));
}

#[test]
fn distances_have_derivatives() {
    let pair = distances::peg_and_wall().unwrap();
    let pose = |height: f64| [0.0, 0.0, height, 1.0, 0.0, 0.0, 0.0];
    assert!((pair.exact_distance(&pose(0.03)) - 0.02).abs() < 1e-9);
    let distance = |height: f64| distances::distance(&pair, &pose(height), 1e-4).unwrap();
    let (step, (_, gradient)) = (1e-6, distance(0.02));
    let difference = (distance(0.02 + step).0 - distance(0.02 - step).0) / (2.0 * step);
    assert!((gradient[2] - difference).abs() < 1e-6 && gradient[2] > 0.5, "{} and {difference}", gradient[2]);
}
