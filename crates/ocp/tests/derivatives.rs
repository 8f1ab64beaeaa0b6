//! Derivatives of the whole problem against differences, with offsets, contacts and both kinds of complementarity.

use std::path::Path;

use nlp::{Problem, check_derivatives};
use ocp::{Complementarity, HessianKind, Transcription};

/// A deterministic number in (-1, 1).
fn noise(index: usize) -> f64 {
    (index as f64 * 12.9898).sin()
}

fn check(scene: &str, steps: usize, pairs: usize) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../scenes/{scene}.toml"));
    let mut task = scene::Scene::load(&path).unwrap().task(Some("2"), None).unwrap();
    task.horizon.steps = steps;
    task.pairs.truncate(pairs);
    let mut problem = Transcription::new(&task, Complementarity::Relaxation, HessianKind::Exact);
    problem.set_smoothing(0.0025, 0.00125);
    let x: Vec<f64> =
        problem.initial_guess().iter().enumerate().map(|(index, value)| value + 0.02 * noise(index)).collect();
    let constraints = problem.constraint_bounds().lower.len();
    let multipliers: Vec<f64> = (0..constraints).map(|index| noise(index + 1000)).collect();
    check_derivatives(&mut problem, &x, &multipliers, 1e-6).unwrap().assert_within(1e-5);
}

#[test]
fn corner() {
    check("corner", 3, 2);
}

#[test]
fn one_step() {
    check("corner", 1, 2);
}

#[test]
fn no_contacts() {
    check("corner", 2, 0);
}

#[test]
fn clamp_with_five_scenarios() {
    check("clamp1", 2, 3);
}
