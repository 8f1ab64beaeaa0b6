//! What MuJoCo was given is found in the logs of a player that moved an arm there: `scripts/lab record executions` writes them.

use std::fs;

use calibration::{Calibration, CalibrationRecord, Entries, Estimate, Parameter};
use plan::{Choices, Problem};

use crate::support::{Workshop, arm_scene, estimate, found, project};

fn workshop() -> Workshop {
    let workshop = Workshop::new(&arm_scene("clamp1"));
    for name in ["free_air.csv", "contact.csv", "light.csv", "late.csv", "stiff.csv"] {
        fs::copy(project("crates/calibration/tests/logs").join(name), workshop.path(name)).unwrap();
    }
    workshop
}

#[test]
#[ignore = "slow, fits of minutes of logs: scripts/test and CI run it"]
fn the_arm_of_mujoco_is_found_from_its_logs() {
    let workshop = workshop();
    let calibration = workshop.calibrate(&["free_air.csv", "contact.csv"], false);
    found(&calibration, Parameter::RotorInertia(None), 0.14, 0.015);
    found(&calibration, Parameter::JointFriction(None), 0.8, 0.04);
    found(&calibration, Parameter::Delay, 0.004, 1e-3);
    found(&calibration, Parameter::Damping, 0.85, 0.03);
    found(&calibration, Parameter::Friction, 0.25, 0.02);
    let [x, y] = [0, 1].map(|axis| estimate(&calibration, Parameter::Offset { run: 1, axis }).value);
    assert!((x - 0.003).abs() < 1e-3 && (y + 0.003).abs() < 1e-3, "{x}, {y}");

    let copy = workshop.path("calibrated.toml");
    let entries = Entries::new(&calibration, &workshop.problem);
    entries.write(&workshop.path("scene.toml"), &copy, false).unwrap();
    let scene = Problem::load(&copy, &Choices::default()).unwrap().scene().clone();
    assert!(scene.robustness.delay >= 0.004 && scene.robustness.frictions.iter().any(|friction| *friction >= 0.25));
    assert!((scene.robot.unwrap().joint_friction[0] - 0.8).abs() < 0.1);
}

/// How many truths are within two errors of their estimates, and how many there are; a truth of what is not known counts as within.
fn within_two_errors(calibration: &Calibration, truth: &serde_json::Value) -> (usize, usize) {
    let names = [
        ("rotor_inertia", Parameter::RotorInertia(None)),
        ("joint_friction", Parameter::JointFriction(None)),
        ("delay", Parameter::Delay),
        ("stiffness", Parameter::Stiffness),
        ("damping", Parameter::Damping),
    ];
    let is_within = |&&(name, parameter): &&(&str, Parameter)| {
        let Estimate { value, standard_error, .. } = estimate(calibration, parameter);
        standard_error.is_none_or(|error| (value - truth[name].as_f64().unwrap()).abs() <= 2.0 * error)
    };
    (names.iter().filter(is_within).count(), names.len())
}

#[test]
#[ignore = "slow, fifteen fits: scripts/test and CI run it"]
fn fourteen_of_fifteen_truths_are_within_two_errors() {
    let workshop = workshop();
    let truths = fs::read_to_string(project("crates/calibration/tests/logs/truths.json")).unwrap();
    let truths: serde_json::Value = serde_json::from_str(&truths).unwrap();
    let (mut within, mut count, mut known) = (0, 0, 0);
    for (name, truth) in truths.as_object().unwrap() {
        let calibration = workshop.calibrate(&[&format!("{name}.csv")], false);
        let (own, all) = within_two_errors(&calibration, truth);
        (within, count) = (within + own, count + all);
        known += calibration.covariance.parameters.len();
    }
    assert!(count == 15 && within >= 14, "{within} of {count}");
    // Errors are not absurd either.
    assert!(known >= 14, "{known} are known");
}

#[test]
#[ignore = "slow, fits of minutes of logs: scripts/test and CI run it"]
fn runs_that_were_stopped_give_their_motion_in_free_air() {
    let workshop = workshop();
    let stop = |name: &str, rows: usize| {
        let text = fs::read_to_string(workshop.path(name)).unwrap();
        let kept: String = text.lines().take(rows).map(|line| line.to_owned() + "\n").collect();
        fs::write(workshop.path("stopped.csv"), kept).unwrap();
    };
    // The whole test of the frames, and no more than the approach.
    for (name, rows, known) in [("light.csv", 1700, 4), ("contact.csv", 400, 0)] {
        stop(name, rows);
        let calibration = workshop.calibrate(&["stopped.csv"], false);
        let entries = Entries::new(&calibration, &workshop.problem);
        let record = CalibrationRecord::new(&calibration, &entries, &workshop.problem);
        assert!(record.warnings[0].contains("until it was stopped"), "{:?}", record.warnings);
        assert!(!record.logs[0].has_contact && record.covariance.parameters.len() >= known, "{record:?}");
    }
}
