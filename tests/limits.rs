//! Limits of a scene are kept by every scenario at every step.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

/// The solver's tolerance of a violated constraint, in the units of the limits.
const TOLERANCE: f64 = 1e-4;

fn project(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap().join(name)
}

/// Solves the corner scene with limits.
fn solve(folder: &Path, limits: &str) -> Output {
    let text = std::fs::read_to_string(project("scenes/corner.toml")).unwrap();
    let homotopy = project("configs/homotopy_peg.toml");
    let text = text.replace("../configs/homotopy_peg.toml", homotopy.to_str().unwrap());
    let scene = folder.join("corner.toml");
    std::fs::write(&scene, format!("{text}\n[limits]\n{limits}\n")).unwrap();
    Command::new(env!("CARGO_BIN_EXE_assembly-plan")).arg("solve").arg(scene).arg("--out").arg(folder).output().unwrap()
}

/// Solves and expects a plan that works; returns its result.
fn plan(folder: &Path, limits: &str) -> Value {
    let run = solve(folder, limits);
    assert_eq!(run.status.code(), Some(0), "{limits}: {}", String::from_utf8_lossy(&run.stderr));
    let result: Value = serde_json::from_str(&std::fs::read_to_string(folder.join("result.json")).unwrap()).unwrap();
    assert_eq!(result["linear_solver_fallbacks"], 0);
    assert!(!result["warnings"].to_string().contains("limits"));
    result
}

/// Rows of a result table, as numbers from a column on, with the scenario (0 for the reference).
fn rows(path: &Path, first: usize) -> Vec<(String, Vec<f64>)> {
    let text = std::fs::read_to_string(path).unwrap();
    let cells = text.lines().skip(1).map(|line| line.split(',').collect::<Vec<_>>());
    let numbers = |cells: &[&str]| cells.iter().map(|cell| cell.parse().unwrap()).collect();
    cells.map(|cells| (cells[1].to_owned(), numbers(&cells[first..]))).collect()
}

fn largest<'number>(numbers: impl IntoIterator<Item = &'number f64>) -> f64 {
    numbers.into_iter().fold(0.0, |largest, number| number.abs().max(largest))
}

/// Largest components that the tables show, by the keys of `reached`.
fn reached(folder: &Path) -> Vec<(&'static str, f64)> {
    const TIME_STEP: f64 = 0.08;
    let velocities = |table: &str, first: usize| -> Vec<(String, Vec<f64>)> { rows(&folder.join(table), first) };
    let reference: Vec<(String, Vec<f64>)> =
        velocities("reference.csv", 8).into_iter().map(|(_, twist)| (String::new(), twist)).collect();
    let twists: Vec<(String, Vec<f64>)> = [reference, velocities("scenarios.csv", 9)].concat();
    let accelerations: Vec<Vec<f64>> = twists
        .windows(2)
        .filter(|pair| pair[0].0 == pair[1].0)
        .map(|pair| pair[0].1.iter().zip(&pair[1].1).map(|(one, other)| (other - one) / TIME_STEP).collect())
        .collect();
    let wrenches = rows(&folder.join("wrench.csv"), 2);
    let forces = rows(&folder.join("contacts.csv"), 4);
    vec![
        ("translational_velocity_m_s", largest(twists.iter().flat_map(|(_, twist)| &twist[..3]))),
        ("rotational_velocity_rad_s", largest(twists.iter().flat_map(|(_, twist)| &twist[3..]))),
        ("translational_acceleration_m_s2", largest(accelerations.iter().flat_map(|twist| &twist[..3]))),
        ("rotational_acceleration_rad_s2", largest(accelerations.iter().flat_map(|twist| &twist[3..]))),
        ("contact_force_n", largest(forces.iter().flat_map(|(_, force)| force))),
        ("force_n", largest(wrenches.iter().flat_map(|(_, wrench)| &wrench[..3]))),
        ("torque_nm", largest(wrenches.iter().flat_map(|(_, wrench)| &wrench[3..]))),
    ]
}

#[test]
fn every_limit_is_kept_where_it_is_active() {
    // Without limits the plan reaches 0.069 m/s, 0.138 rad/s, 1.57 m/s^2, 1.72 rad/s^2, 1.95 N, 1.89 N and 0.102 Nm.
    for (limits, keys) in [
        ("translational_velocity = 0.036", vec![("translational_velocity_m_s", 0.036)]),
        ("rotational_velocity = 0.11", vec![("rotational_velocity_rad_s", 0.11)]),
        (
            "translational_acceleration = 0.2\nrotational_acceleration = 0.3",
            vec![("translational_acceleration_m_s2", 0.2), ("rotational_acceleration_rad_s2", 0.3)],
        ),
        ("contact_force = 1.2", vec![("contact_force_n", 1.2)]),
        ("force = 1.0\ntorque = 0.02", vec![("force_n", 1.0), ("torque_nm", 0.02)]),
    ] {
        let folder = tempfile::tempdir().unwrap();
        let result = plan(folder.path(), limits);
        for (key, value) in reached(folder.path()) {
            assert!((result["reached"][key].as_f64().unwrap() - value).abs() < 1e-9, "{limits}: {key}");
            let scenarios = result["scenarios"].as_array().unwrap();
            assert!(scenarios.iter().all(|scenario| scenario["reached"][key].as_f64().unwrap() <= value + 1e-9));
            let Some(&(_, limit)) = keys.iter().find(|(limited, _)| *limited == key) else {
                assert!(result["limits"][key].is_null());
                continue;
            };
            assert_eq!(result["limits"][key], limit);
            assert!(value <= limit + TOLERANCE, "{limits}: {key} is {value}");
            assert!(value > 0.97 * limit, "{limits}: {key} is not active at {value}");
        }
    }
}

#[test]
fn limits_in_resolved_toml_repeat_the_plan() {
    let folder = tempfile::tempdir().unwrap();
    let first = plan(folder.path(), "force = 1.5\nrotational_velocity = 0.12");
    let resolved = folder.path().join("resolved.toml");
    let out = folder.path().join("again");
    let program = env!("CARGO_BIN_EXE_assembly-plan");
    let run = Command::new(program).arg("solve").arg(resolved).arg("--out").arg(&out).output().unwrap();
    assert_eq!(run.status.code(), Some(0));
    assert!(String::from_utf8(run.stdout).unwrap().contains("limits: rotational_velocity 0.1"));
    let second: Value = serde_json::from_str(&std::fs::read_to_string(out.join("result.json")).unwrap()).unwrap();
    assert_eq!(first["limits"], second["limits"]);
    assert!((first["objective"].as_f64().unwrap() - second["objective"].as_f64().unwrap()).abs() < 1e-3);
}

#[test]
fn a_goal_out_of_reach_is_wrong_input() {
    let folder = tempfile::tempdir().unwrap();
    let run = solve(folder.path(), "translational_velocity = 0.02");
    assert_eq!(run.status.code(), Some(2));
    let stderr = String::from_utf8(run.stderr).unwrap();
    for words in ["corner.toml:", "translational_velocity = 0.02", "allow more than", "more steps in [horizon]"] {
        assert!(stderr.contains(words), "{words} is missing in {stderr}");
    }
}
