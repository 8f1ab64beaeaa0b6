//! `solve --robust` as a user runs it.

use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;

/// Plans the smallest scene; one friction is enough.
fn solve(out: &Path, arguments: &[&str]) -> (Output, Value) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    let all =
        [&["solve", "scenes/corner.toml", "--friction", "0", "--robust", "--out", out.to_str().unwrap()], arguments];
    let run = Command::new(env!("CARGO_BIN_EXE_assembly-plan")).current_dir(root).args(all.concat()).output().unwrap();
    let result = std::fs::read_to_string(out.join("result.json")).unwrap();
    (run, serde_json::from_str(&result).unwrap())
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

#[test]
fn a_plan_is_refined_until_unplanned_offsets_succeed() {
    let folder = tempfile::tempdir().unwrap();
    let (run, result) = solve(folder.path(), &[]);
    assert_eq!(run.status.code(), Some(0), "{}", text(&run.stderr));
    let robust = &result["robust"];
    assert!(robust["rate_before"].as_f64().unwrap() < 0.99, "the plain plan rests too far from the goal");
    assert!(robust["rate_after"].as_f64().unwrap() >= 0.99);
    assert_eq!((&result["status"], &robust["reached"]), (&"done".into(), &true.into()));
    assert!(robust["rounds"][0]["changes"].as_u64().unwrap() > 0);
    let cells = robust["after"].as_array().unwrap();
    let magnitudes: Vec<f64> = cells.iter().map(|cell| cell["magnitude_m"].as_f64().unwrap()).collect();
    assert_eq!(magnitudes, [0.0, 0.005, 0.01, 0.015, 0.019, 0.02]);
    assert!(text(&run.stdout).contains("success in rollouts with hard contact"));
    // The scenarios are rollouts: contacts are hard there.
    for scenario in result["scenarios"].as_array().unwrap() {
        assert!(scenario["max_penetration_m"].as_f64().unwrap() < 1e-5);
        assert!(scenario["position_error_m"].as_f64().unwrap() <= 3e-3);
    }
    for file in ["reference.csv", "scenarios.csv", "wrench.csv", "contacts.csv", "stages/5/reference.csv"] {
        assert!(folder.path().join(file).exists(), "{file}");
    }
}

#[test]
fn without_time_the_best_plan_is_kept_and_the_exit_code_says_so() {
    let folder = tempfile::tempdir().unwrap();
    let (run, result) = solve(folder.path(), &["--time-limit", "0.001", "--wanted-rate", "1"]);
    assert_eq!(run.status.code(), Some(1), "{}", text(&run.stderr));
    assert_eq!(result["status"], "the wanted rate of success is not reached");
    assert_eq!(result["robust"]["reached"], false);
    assert!(folder.path().join("reference.csv").exists());
}

#[test]
fn wrong_wishes_are_usage_errors() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..");
    for arguments in [
        ["--robust", "--wanted-rate", "1.5"],
        ["--robust", "--time-limit", "0"],
        ["--linear-solver", "mumps", "--wanted-rate=0.9"],
    ] {
        let all = [&["solve", "scenes/corner.toml"], &arguments[..]].concat();
        let run = Command::new(env!("CARGO_BIN_EXE_assembly-plan")).current_dir(&root).args(all).output().unwrap();
        assert_eq!(run.status.code(), Some(2), "{arguments:?}: {}", text(&run.stderr));
    }
}
