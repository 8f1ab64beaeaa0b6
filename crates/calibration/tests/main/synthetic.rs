//! Values that rollouts have been given are found in what they did.

use calibration::{CalibrationRecord, Entries, Parameter};
use nalgebra::{Isometry3, Vector3};
use task::{GraspError, Inertia};

use crate::support::{Workshop, arm_scene, estimate, found, project, test_motion, through};

fn corner() -> String {
    std::fs::read_to_string(project("scenes/corner.toml")).unwrap()
}

/// The goal shifted into free air.
fn above_goal(workshop: &Workshop) -> Isometry3<f64> {
    Isometry3::translation(0.05, 0.0, 0.05) * workshop.problem.scene().goal.isometry()
}

#[test]
fn an_arm_is_found_in_free_air() {
    let workshop = Workshop::new(&arm_scene("clamp1"));
    let mut truth = workshop.truth();
    let arm = truth.arm.as_mut().unwrap();
    arm.arm = arm.arm.clone().with_rotor_inertia(&[0.17; 6]).unwrap();
    arm.joint_friction.fill(0.9);
    arm.delay = 0.0033;
    truth.task.impedance.translational_damping *= 0.8;
    truth.task.impedance.rotational_damping *= 0.8;
    workshop.log("free.csv", &truth, &test_motion(&above_goal(&workshop)), 0.05);
    let calibration = workshop.calibrate(&["free.csv"], false);
    found(&calibration, Parameter::RotorInertia(None), 0.17, 0.01);
    found(&calibration, Parameter::JointFriction(None), 0.9, 0.05);
    found(&calibration, Parameter::Delay, 0.0033, 2e-4);
    found(&calibration, Parameter::Damping, 0.8, 0.02);
    // Errors are neither too small nor absurd.
    for estimate in &calibration.estimates {
        let (Some(error), parameter) = (estimate.standard_error, estimate.quantity.parameter) else { continue };
        let expected = match parameter {
            Parameter::RotorInertia(_) => 0.17,
            Parameter::JointFriction(_) => 0.9,
            Parameter::Delay => 0.0033,
            Parameter::Damping => 0.8,
            _ => 1.0,
        };
        let off = (estimate.value - expected).abs() / error;
        assert!(off < 5.0, "{} is {off} standard errors off", parameter.name());
    }
    let run = &calibration.runs[0];
    assert!(run.after.distance < 6e-5 && run.before.unwrap().distance > 3e-4, "{run:?}");
}

#[test]
fn friction_and_grasp_are_found_where_the_part_slides() {
    let workshop = Workshop::new(&corner());
    let goal = workshop.problem.scene().goal.isometry();
    let mut truth = workshop.truth();
    truth.friction = 0.22;
    truth.grasp = GraspError { offset: [0.004, 0.0, 0.006], rotation: [0.0; 3] };
    // Presses on the floor while it slides to the wall, and a little beyond.
    let pose = |shift: Vector3<f64>| Isometry3::translation(shift.x, shift.y, shift.z) * goal;
    let ways = [
        [0.04, 0.0, 0.03],
        [0.03, 0.01, -0.02],
        [0.0, 0.0, -0.02],
        [0.01, -0.02, -0.03],
        [-0.01, 0.0, -0.01],
        [0.004, 0.0, 0.006],
    ];
    let poses: Vec<Isometry3<f64>> = ways.map(|way| pose(way.into())).to_vec();
    workshop.log("contact.csv", &truth, &through(&poses, 1.0), 0.0);
    let calibration = workshop.calibrate(&["contact.csv"], false);
    found(&calibration, Parameter::Friction, 0.22, 0.02);
    found(&calibration, Parameter::Offset { run: 0, axis: 2 }, 0.006, 3e-4);
    let entries = Entries::new(&calibration, &workshop.problem);
    let record = CalibrationRecord::new(&calibration, &entries, &workshop.problem);
    let frictions: Vec<f64> = record.entries["robustness"]["friction"]
        .as_array()
        .unwrap()
        .iter()
        .map(|value| value.as_f64().unwrap())
        .collect();
    assert!(frictions[0] < 0.22 && frictions[frictions.len() - 1] > 0.22, "{frictions:?}");
}

#[test]
fn a_body_without_an_arm_has_another_inertia() {
    let workshop = Workshop::new(&corner());
    let mut truth = workshop.truth();
    truth.task.inertia = Inertia::of_body(1.6, nalgebra::Matrix3::from_diagonal_element(0.07));
    workshop.log("free.csv", &truth, &test_motion(&above_goal(&workshop)), 0.05);
    let calibration = workshop.calibrate(&["free.csv"], false);
    found(&calibration, Parameter::TranslationalInertia, 1.6, 0.03);
    found(&calibration, Parameter::RotationalInertia, 0.7, 0.03);
    found(&calibration, Parameter::Damping, 1.0, 0.02);

    // The copy is a scene with that inertia, and has kept its comments.
    let copy = workshop.path("copy.toml");
    let entries = Entries::new(&calibration, &workshop.problem);
    entries.write(&workshop.path("scene.toml"), &copy, false).unwrap();
    assert!(entries.write(&workshop.path("scene.toml"), &copy, false).is_err(), "nothing is replaced");
    let scene = scene::Scene::load(&copy).unwrap();
    assert!((scene.inertia.matrix()[(0, 0)] - 1.6).abs() < 0.03);
    assert!(std::fs::read_to_string(copy).unwrap().contains("# one box pushed into a corner"));
}

#[test]
fn what_a_log_does_not_tell_is_held_and_said() {
    let workshop = Workshop::new(&arm_scene("clamp1"));
    let above = above_goal(&workshop);
    // It only rests.
    workshop.log("rest.csv", &workshop.truth(), &through(&[above, above], 1.0), 0.05);
    let calibration = workshop.calibrate(&["rest.csv"], false);
    for parameter in [Parameter::RotorInertia(None), Parameter::Delay, Parameter::Damping, Parameter::Stiffness] {
        let estimate = estimate(&calibration, parameter);
        assert_eq!((estimate.value, estimate.standard_error), (estimate.quantity.before, None), "{}", parameter.name());
    }
    let entries = Entries::new(&calibration, &workshop.problem);
    assert!(entries.is_empty());
    let record = CalibrationRecord::new(&calibration, &entries, &workshop.problem);
    assert!(record.parameters.iter().all(|parameter| parameter.remark.starts_with("not identified: ")), "{record:?}");
}
