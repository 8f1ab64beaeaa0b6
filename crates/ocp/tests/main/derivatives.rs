//! Derivatives of the whole problem against differences, with grasp errors, contacts and limits.

use std::path::Path;

use nalgebra::{Matrix3, Matrix6};
use nlp::{Problem, check_derivatives};
use ocp::{ActiveContacts, Formulation, Transcription};
use task::{AssemblyTask, Complementarity, GraspError, HessianKind, Inertia, Limits};

/// A deterministic number in (-1, 1).
fn noise(index: usize) -> f64 {
    (index as f64 * 12.9898).sin()
}

fn task(scene: &str, steps: usize, pairs: usize) -> AssemblyTask {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../scenes/{scene}.toml"));
    let mut task = scene::Scene::load(&path).unwrap().task(Some("2"), None).unwrap();
    task.horizon.steps = steps;
    task.pairs.truncate(pairs);
    task
}

fn check(task: &AssemblyTask) {
    check_with(Formulation::new(task, Complementarity::Relaxation));
}

fn check_with(formulation: Formulation) {
    let mut problem = Transcription::of(formulation, Complementarity::Relaxation, HessianKind::Exact);
    problem.set_smoothing(0.0025, 0.00125);
    let x: Vec<f64> = problem
        .formulation()
        .initial_guess()
        .iter()
        .enumerate()
        .map(|(index, value)| value + 0.02 * noise(index))
        .collect();
    let constraints = problem.constraint_bounds().lower.len();
    let multipliers: Vec<f64> = (0..constraints).map(|index| noise(index + 1000)).collect();
    check_derivatives(&mut problem, &x, &multipliers, 1e-6).unwrap().assert_within(1e-5);
}

#[test]
fn corner() {
    check(&task("corner", 3, 2));
}

#[test]
fn one_step() {
    check(&task("corner", 1, 2));
}

#[test]
fn no_contacts() {
    check(&task("corner", 2, 0));
}

#[test]
fn some_contacts_at_some_steps() {
    for task in [task("corner", 3, 2), AssemblyTask { frictions: vec![0.3], ..task("clamp1", 2, 3) }] {
        let contacts = ActiveContacts::from_fn(&task, |stage, scenario, pair| (stage + scenario + pair) % 2 == 0);
        check_with(Formulation::new(&task, Complementarity::Relaxation).with_contacts(contacts));
    }
}

#[test]
fn clamp_with_five_scenarios() {
    check(&task("clamp1", 2, 3));
}

#[test]
fn full_damping_matrices() {
    let mut task = task("corner", 3, 2);
    task.impedance.translational_damping = Matrix3::new(9.0, 2.0, -1.0, 2.0, 12.0, 3.0, -1.0, 3.0, 7.0);
    task.impedance.rotational_damping = Matrix3::new(1.2, 0.3, -0.2, 0.3, 0.9, 0.1, -0.2, 0.1, 1.5);
    check(&task);
    check(&AssemblyTask { limits: Limits { force: 6.0, torque: 0.7, ..Limits::NONE }, ..task });
}

/// Turns of some tenths of a radian, which no linearisation of the wrench would survive.
#[test]
fn turned_scenarios() {
    for (scene, steps, pairs) in [("corner", 3, 2), ("clamp1", 2, 3)] {
        let mut task = task(scene, steps, pairs);
        for (index, grasp) in task.grasps.iter_mut().enumerate() {
            *grasp = GraspError { rotation: std::array::from_fn(|axis| 0.5 * noise(3 * index + axis)), ..*grasp };
        }
        task.impedance.rotational_damping = Matrix3::new(1.2, 0.3, -0.2, 0.3, 0.9, 0.1, -0.2, 0.1, 1.5);
        check(&task);
        check(&AssemblyTask { limits: Limits { force: 6.0, torque: 0.7, ..Limits::NONE }, ..task });
    }
}

#[test]
fn full_inertia() {
    let mut task = task("clamp1", 2, 3);
    let factor = Matrix6::from_fn(|row, column| 0.3 * noise(7 * row + column) + f64::from(u8::from(row == column)));
    task.inertia = Inertia::from_matrix(factor * factor.transpose());
    check(&task);
}

#[test]
fn friction() {
    for (scene, steps, pairs) in [("corner", 3, 2), ("clamp1", 2, 3)] {
        check(&AssemblyTask { frictions: vec![0.3], ..task(scene, steps, pairs) });
    }
    check(&AssemblyTask { frictions: vec![0.0, 0.3], ..task("corner", 3, 2) });
}

#[test]
fn limits() {
    let all = Limits {
        translational_velocity: 0.1,
        rotational_velocity: 0.2,
        translational_acceleration: 0.3,
        rotational_acceleration: 0.4,
        contact_force: 5.0,
        force: 6.0,
        torque: 0.7,
    };
    let some = Limits { rotational_acceleration: 0.4, torque: 0.7, ..Limits::NONE };
    for limits in [all, some] {
        check(&AssemblyTask { limits, ..task("corner", 3, 2) });
        check(&AssemblyTask { limits, ..task("clamp1", 1, 1) });
    }
}

#[test]
fn only_what_is_limited_has_rows_and_bounds() {
    let unlimited = task("corner", 2, 2);
    let transcribe = |limits: Limits| {
        let task = AssemblyTask { limits, ..unlimited.clone() };
        Transcription::new(&task, Complementarity::Relaxation, HessianKind::Exact)
    };
    let finite = |values: &[f64]| values.iter().filter(|value| value.is_finite()).count();
    let none = transcribe(Limits::NONE);
    let (rows, bounds) = (none.layout().constraint_count(), finite(&none.variable_bounds().upper));
    assert_eq!((rows, bounds), (2 * (7 + 2 * (13 + 2 * 2)), 0));

    let bounded = transcribe(Limits { translational_velocity: 0.1, contact_force: 5.0, ..Limits::NONE });
    assert_eq!(bounded.layout().constraint_count(), rows);
    assert_eq!(finite(&bounded.variable_bounds().upper), 2 * (3 + 2 * (3 + 2)));

    let limited = transcribe(Limits { translational_acceleration: 0.3, torque: 0.7, ..Limits::NONE });
    assert_eq!(limited.layout().constraint_count(), rows + 2 * (3 + 2 * (3 + 3)));
    assert_eq!(finite(&limited.variable_bounds().upper), 0);
    let bounds = limited.constraint_bounds();
    for (limit, count) in [(0.3, 2 * (3 + 2 * 3)), (0.7, 2 * 2 * 3)] {
        assert_eq!(bounds.lower.iter().zip(&bounds.upper).filter(|&pair| pair == (&-limit, &limit)).count(), count);
    }
}
