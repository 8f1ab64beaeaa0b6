//! `simulate` against motions that MuJoCo made from the same plans; `scripts/lab record mujoco` records them.

use crate::support::{Dir, Table, project};

/// A moment of a motion: time (s), position (m), quaternion, velocity (m/s), angular velocity (rad/s).
type Moment = [f64; 14];

fn moments(table: &Table) -> Vec<Moment> {
    table.numbers_from("time_s").into_iter().map(|row| row.try_into().unwrap()).collect()
}

/// The motion of a plan at its planned offset, as `simulate` makes it.
fn simulated(plan: &str, friction: &str) -> Vec<Moment> {
    let (dir, plan) = (Dir::new(), project("tests/mujoco").join(plan));
    let flags = format!("--friction {friction} --out . --trace trace.csv");
    dir.program("simulate").arg(plan.join("resolved.toml")).arg(plan).args(&flags).run().code(0);
    moments(&dir.table("trace.csv"))
}

/// Largest differences between both motions of a plan: in position (m) and in the quaternion.
fn differences(name: &str, friction: &str) -> (f64, f64) {
    let ours = simulated(name, friction);
    let record = project("tests/mujoco").join(name).join(format!("friction_{friction}.csv"));
    let theirs = moments(&Table::parse(&std::fs::read_to_string(record).unwrap()));
    assert!(theirs.len() > 100);
    let mut largest = (0.0_f64, 0.0_f64);
    for their in &theirs {
        let our = ours.iter().find(|our| (our[0] - their[0]).abs() < 1e-6).expect("the same moments");
        let difference = |indices: std::ops::Range<usize>| {
            indices.map(|index| (our[index] - their[index]).powi(2)).sum::<f64>().sqrt()
        };
        largest = (largest.0.max(difference(1..4)), largest.1.max(difference(4..8)));
    }
    largest
}

/// The box has an uneven inertia, turns by more than 100 degrees, and its offset is 20 mm.
#[test]
fn free_motion_is_that_of_mujoco() {
    let (position, quaternion) = differences("free_motion", "0");
    assert!(position < 1e-4 && quaternion < 3e-4, "{position} m, {quaternion}");
}

/// The box is pressed down by its offset as it slides and turns; MuJoCo's contacts are a little soft.
#[test]
fn sliding_is_that_of_mujoco() {
    for (friction, position_tolerance, quaternion_tolerance) in [("0", 1e-4, 3e-4), ("0.3", 4e-4, 1e-3)] {
        let (position, quaternion) = differences("sliding", friction);
        assert!(
            position < position_tolerance && quaternion < quaternion_tolerance,
            "friction {friction}: {position} m, {quaternion}"
        );
    }
    // Friction matters, or the comparison would say nothing about it.
    let [free, held] = ["0", "0.3"].map(|friction| simulated("sliding", friction));
    let lags = free.iter().zip(&held).map(|(free, held)| (free[1] - held[1]).abs());
    assert!(lags.fold(0.0, f64::max) > 2e-3);
}
