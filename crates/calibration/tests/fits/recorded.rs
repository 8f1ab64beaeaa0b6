//! What MuJoCo was given is found in the logs of a player that moved an arm there: `scripts/record-executions` writes them.

use std::fs;

use calibration::{Entries, Parameter};
use planner::{Choices, Problem};

use crate::support::{Workshop, arm_scene, estimate, found, project};

fn workshop() -> Workshop {
    let workshop = Workshop::new(&arm_scene("clamp1"));
    for name in ["free_air.csv", "contact.csv"] {
        fs::copy(project("crates/calibration/tests/fits/logs").join(name), workshop.path(name)).unwrap();
    }
    workshop
}

#[test]
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
    assert!(scene.borne.delay >= 0.004 && scene.borne.frictions.iter().any(|friction| *friction >= 0.25));
    assert!((scene.robot.unwrap().joint_friction[0] - 0.8).abs() < 0.1);
}
