//! Values and derivatives of whole small problems against an independent implementation.

use std::path::Path;

use nlp::Problem;
use ocp::Transcription;
use serde_json::Value;
use task::{Complementarity, HessianKind};

const TOLERANCE: f64 = 1e-9;

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().expect("an array").iter().map(|entry| entry.as_f64().expect("a number")).collect()
}

fn load(file: &str) -> Value {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(file);
    serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap()
}

fn transcribe(reference: &Value, hessian: HessianKind) -> Transcription {
    let name = reference["scene"].as_str().unwrap();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("../../scenes/{name}.toml"));
    let scene = scene::Scene::load(&path).unwrap();
    let mut task = scene.task(None, None).unwrap();
    task.horizon.steps = reference["steps"].as_u64().unwrap() as usize;
    task.start.0.copy_from_slice(&numbers(&reference["x0"])[..7]);
    let mut transcription = Transcription::new(&task, Complementarity::Relaxation, hessian);
    transcription.set_smoothing(reference["tau"].as_f64().unwrap(), reference["sigma"].as_f64().unwrap());
    transcription
}

fn assert_close(actual: &[f64], expected: &[f64], what: &str) {
    assert_eq!(actual.len(), expected.len(), "{what}");
    let scale = expected.iter().fold(1.0, |scale: f64, value| scale.max(value.abs()));
    for (index, (a, e)) in actual.iter().zip(expected).enumerate() {
        assert!((a - e).abs() <= TOLERANCE * scale, "{what}[{index}] = {a}, expected {e}");
    }
}

fn check(file: &str) {
    let reference = load(file);
    let x = numbers(&reference["x"]);
    let multipliers = numbers(&reference["multipliers"]);
    let direction = numbers(&reference["direction"]);
    let mut problem = transcribe(&reference, HessianKind::Exact);
    for (scenario, expected) in reference["x0_compliant"].as_array().unwrap().iter().enumerate() {
        assert_close(&problem.formulation().initial_compliant()[scenario][..], &numbers(expected), "x0_compliant");
    }
    problem.set_point(&x).unwrap();
    assert_close(&[problem.objective().unwrap()], &[reference["f"].as_f64().unwrap()], "f");
    let mut gradient = vec![0.0; x.len()];
    problem.gradient(&mut gradient).unwrap();
    assert_close(&gradient, &numbers(&reference["grad"]), "grad");
    let mut constraints = vec![0.0; multipliers.len()];
    problem.constraints(&mut constraints).unwrap();
    assert_close(&constraints, &numbers(&reference["g"]), "g");

    let pattern = problem.jacobian_pattern();
    let mut jacobian = vec![0.0; pattern.rows.len()];
    problem.jacobian(&mut jacobian).unwrap();
    let (mut forward, mut backward) = (vec![0.0; multipliers.len()], vec![0.0; x.len()]);
    for ((&row, &column), value) in pattern.rows.iter().zip(&pattern.columns).zip(&jacobian) {
        forward[row] += value * direction[column];
        backward[column] += value * multipliers[row];
    }
    assert_close(&forward, &numbers(&reference["Jd"]), "Jd");
    assert_close(&backward, &numbers(&reference["JTy"]), "JTy");
    assert_close(&hessian_times(&mut problem, &multipliers, &direction), &numbers(&reference["Hd"]), "Hd");

    let mut problem = transcribe(&reference, HessianKind::GaussNewton);
    problem.set_point(&x).unwrap();
    assert_close(&hessian_times(&mut problem, &multipliers, &direction), &numbers(&reference["GNd"]), "GNd");
}

fn hessian_times(problem: &mut Transcription, multipliers: &[f64], direction: &[f64]) -> Vec<f64> {
    let pattern = problem.hessian_pattern();
    let mut values = vec![0.0; pattern.rows.len()];
    problem.hessian(1.0, multipliers, &mut values).unwrap();
    let mut product = vec![0.0; direction.len()];
    for ((&row, &column), value) in pattern.rows.iter().zip(&pattern.columns).zip(&values) {
        assert!(row >= column, "the Hessian is given by its lower triangle");
        product[row] += value * direction[column];
        if row != column {
            product[column] += value * direction[row];
        }
    }
    product
}

#[test]
fn corner_agrees_with_the_reference_implementation() {
    check("nlp_corner_N4_tau0.0025.json");
}

#[test]
fn peg2_agrees_with_the_reference_implementation() {
    check("nlp_peg2_N3_tau0.0025.json");
}
