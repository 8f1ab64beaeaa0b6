//! The planner's friction against motions of MuJoCo: `tests/mujoco`, which `scripts/lab record mujoco` recorded.

use std::path::Path;

use scene::Scene;
use task::{AssemblyTask, Horizon, State, Twist};

use crate::friction::played::motions;

/// So many planning steps make one step of a recorded reference.
const PARTS: usize = 4;
/// Time between two moments of the records (s).
const RECORD_STEP: f64 = 0.02;

/// Rows of a table in `tests/mujoco`, without their times.
fn table(plan: &str, name: &str) -> Vec<State> {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/mujoco").join(plan).join(name);
    let text = std::fs::read_to_string(file).unwrap();
    let row = |line: &str| {
        let numbers: Vec<f64> = line.split(',').skip(1).map(|number| number.parse().unwrap()).collect();
        State(numbers.try_into().unwrap())
    };
    text.lines().skip(1).map(row).collect()
}

/// The task of a recorded plan, on finer steps.
fn task(plan: &str, friction: f64) -> AssemblyTask {
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/mujoco").join(plan).join("resolved.toml");
    let task = Scene::load(&file).unwrap().task(None, None).unwrap();
    let Horizon { steps, time_step } = task.horizon;
    let horizon = Horizon { steps: PARTS * steps, time_step: time_step / PARTS as f64 };
    AssemblyTask { frictions: vec![friction], horizon, ..task }
}

/// How far the planned motion of a recorded reference is from that of MuJoCo, and how far it is where the planner knows no
/// friction (m).
fn deviations(plan: &str) -> [f64; 2] {
    let reference = table(plan, "reference.csv");
    let velocities = reference[1..].iter().flat_map(|state| [state.twist(); PARTS]);
    let velocities: Vec<Twist> = velocities.collect();
    let recorded = table(plan, "friction_0.3.csv");
    [0.3, 0.0].map(|friction| {
        let task = task(plan, friction);
        let every = (task.horizon.time_step / RECORD_STEP).round() as usize;
        let motion = motions(&task, velocities.clone()).pop().unwrap();
        let pairs = motion.iter().zip(recorded.iter().skip(every).step_by(every));
        assert_eq!(pairs.len(), task.horizon.steps);
        let distance =
            |(one, other): (&State, &State)| (0..3).map(|axis| (one[axis] - other[axis]).powi(2)).sum::<f64>().sqrt();
        pairs.map(distance).fold(0.0, f64::max)
    })
}

#[test]
#[ignore = "slow, a motion with friction is solved step by step: scripts/test and CI run it"]
fn a_box_slides_and_turns_as_in_mujoco() {
    let [with, without] = deviations("sliding");
    assert!(with < 1e-3 && without > 5.0 * with, "{with} m, {without} m without friction");
}

#[test]
#[ignore = "slow, a motion with friction is solved step by step: scripts/test and CI run it"]
fn a_box_sticks_as_in_mujoco() {
    let [with, without] = deviations("sticking");
    assert!(with < 2e-3 && without > 10.0 * with, "{with} m, {without} m without friction");
}
