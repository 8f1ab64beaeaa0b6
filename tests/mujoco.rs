//! `simulate` against motions that MuJoCo made from the same plans; `scripts/record-mujoco` records them.

use std::path::{Path, PathBuf};
use std::process::Command;

/// A moment of a motion: time (s), position (m), quaternion, velocity (m/s), angular velocity (rad/s).
type Moment = [f64; 14];

fn moments(file: &Path) -> Vec<Moment> {
    let text = std::fs::read_to_string(file).unwrap();
    let numbers = |line: &str| line.split(',').map(|number| number.parse().unwrap()).collect::<Vec<f64>>();
    text.lines().skip(1).map(|line| numbers(line).try_into().unwrap()).collect()
}

/// The motion of a plan at its planned offset, as `simulate` makes it.
fn simulated(plan: &Path, friction: &str) -> Vec<Moment> {
    let out = tempfile::tempdir().unwrap();
    let trace = out.path().join("trace.csv");
    let run = Command::new(env!("CARGO_BIN_EXE_assembly-plan"))
        .args(["simulate".as_ref(), plan.join("resolved.toml").as_os_str(), plan.as_os_str()])
        .args(["--friction", friction, "--out", out.path().to_str().unwrap()])
        .args(["--trace".as_ref(), trace.as_os_str()])
        .output()
        .unwrap();
    assert!(run.status.success(), "{}", String::from_utf8_lossy(&run.stderr));
    moments(&trace)
}

fn plan(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/mujoco").join(name)
}

/// Largest differences between both motions of a plan: in position (m) and in the quaternion.
fn differences(name: &str, friction: &str) -> (f64, f64) {
    let ours = simulated(&plan(name), friction);
    let theirs = moments(&plan(name).join(format!("friction_{friction}.csv")));
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
    let [free, held] = ["0", "0.3"].map(|friction| simulated(&plan("sliding"), friction));
    let lags = free.iter().zip(&held).map(|(free, held)| (free[1] - held[1]).abs());
    assert!(lags.fold(0.0, f64::max) > 2e-3);
}
