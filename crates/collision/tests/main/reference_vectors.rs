//! Distances, normals and derivatives compared with values from 60-digit arithmetic.

use std::path::Path;

use collision::{Pair, Polytope, Solutions};
use serde_json::Value;

fn numbers<const N: usize>(value: &Value) -> [f64; N] {
    let numbers: Vec<f64> = value.as_array().unwrap().iter().map(|entry| entry.as_f64().unwrap()).collect();
    numbers.try_into().unwrap()
}

fn matrix<const N: usize>(value: &Value) -> Vec<[f64; N]> {
    value.as_array().unwrap().iter().map(numbers).collect()
}

fn part(description: &Value) -> Polytope {
    let offsets: Vec<f64> = description["h"].as_array().unwrap().iter().map(|entry| entry.as_f64().unwrap()).collect();
    let polytope = Polytope::from_halfspaces(&matrix::<3>(&description["G"]), &offsets).unwrap();
    polytope.placed(numbers(&description["position"]), numbers(&description["orientation"]))
}

/// Largest difference relative to the largest reference entry.
fn error(actual: &[f64], expected: &[f64]) -> f64 {
    let scale = expected.iter().fold(0.0, |scale: f64, value| scale.max(value.abs()));
    actual.iter().zip(expected).map(|(a, e)| (a - e).abs()).fold(0.0, f64::max) / scale
}

fn check(file: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(file);
    let reference: Value = serde_json::from_str(&std::fs::read_to_string(path).unwrap()).unwrap();
    let pair = Pair::new(part(&reference["body"]), part(&reference["environment"]));
    // With a part offset, the radial component of n depends on how the rotation is extended off the unit sphere.
    let has_offset = numbers::<3>(&reference["body"]["position"]) != [0.0; 3];
    for case in reference["cases"].as_array().unwrap() {
        let tau = case["tau"].as_f64().unwrap();
        let kind = case["kind"].as_str().unwrap();
        let pose: [f64; 7] = numbers(&case["q"]);
        let what = format!("{file}, {kind}, tau = {tau:e}");

        let distance = pair.distance(&pose, tau).unwrap();
        let phi = case["phi"].as_f64().unwrap();
        let size = 0.01;
        assert!((distance.smoothed_distance - phi).abs() <= 1e-10 * phi.abs().max(size), "{what}: Phi");
        if !has_offset {
            assert!(error(&distance.contact_normal, &numbers::<7>(&case["n"])) <= 1e-10, "{what}: n");
        }
        let exact = case["exact_distance"].as_f64().unwrap();
        assert!((pair.exact_distance(&pose) - exact).abs() <= 1e-10, "{what}: exact {}", pair.exact_distance(&pose));

        let (mut values, mut jacobians, mut hessians) = ([[0.0; 7]], [[[0.0; 7]; 7]], [[[0.0; 7]; 7]]);
        let seeds = [numbers::<7>(&case["W_seed"])];
        let mut solutions = Solutions::default();
        pair.contact_jacobians(&[pose], tau, &mut solutions, &mut values, &mut jacobians).unwrap();
        pair.contact_hessians(&[pose], tau, &seeds, &mut solutions, &mut hessians).unwrap();
        assert!(error(&values[0], &numbers::<7>(&case["W"])) <= 1e-10, "{what}: W");
        let expected = matrix::<7>(&case["DW"]).concat();
        let first = error(jacobians[0].as_flattened(), &expected);
        assert!(first <= 1e-8, "{what}: DW {first:e}");
        let expected = matrix::<7>(&case["D2W_seed"]).concat();
        let second = error(hessians[0].as_flattened(), &expected);
        assert!(second <= 1e-6, "{what}: D2W {second:e}");
    }
}

#[test]
fn boxes_with_part_offsets() {
    check("box_box_offset.json");
}

#[test]
fn cubes() {
    check("cube_cube.json");
}

#[test]
fn aligned_cubes() {
    check("cube_cube_aligned.json");
}

#[test]
fn hexagonal_prism_and_wall() {
    check("hexprism_wall.json");
}
