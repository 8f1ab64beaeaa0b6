//! `solve --robust` as a user runs it.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;

/// The smallest scene.
fn corner() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/corner.toml")
}

/// One friction is enough.
fn command(out: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_assembly-plan"));
    command.arg("solve").arg(corner()).args(["--friction", "0", "--robust", "--out"]).arg(out).args(arguments);
    command
}

fn result(out: &Path) -> Value {
    serde_json::from_str(&std::fs::read_to_string(out.join("result.json")).unwrap()).unwrap()
}

fn solve(out: &Path, arguments: &[&str]) -> (Output, Value) {
    (command(out, arguments).output().unwrap(), result(out))
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

/// Nothing ends a hundredth of a millimetre from the goal, so that all problems are tried.
const HOPELESS: [&str; 4] = ["--position-tolerance", "1e-5", "--patience", "3"];

#[test]
fn where_refinement_is_stuck_other_problems_are_solved() {
    let folder = tempfile::tempdir().unwrap();
    let (run, result) = solve(folder.path(), &HOPELESS);
    assert_eq!(run.status.code(), Some(1), "{}", text(&run.stderr));
    let rounds = result["robust"]["rounds"].as_array().unwrap();
    let names: Vec<&str> = rounds.iter().map(|round| round["planned"].as_str().unwrap()).collect();
    assert_eq!((names.len(), names[0]), (10, "the scene as it is"), "{names:?}");
    for round in rounds {
        assert_eq!(round["training_failures"], round["training_trials"], "{round}");
        assert_eq!(round["rate"], 0.0, "{round}");
    }
    let find = |name: &str| &rounds[names.iter().position(|other| *other == name).unwrap()];
    assert_eq!(find("twice the time")["steps"], 40);
    assert_eq!(find("failing offsets as scenarios, from the refined plan")["scenarios_m"].as_array().unwrap().len(), 5);
    assert_eq!(find("half the time step")["time_step_s"], 0.04);
    assert_eq!(find("no offset and half offsets as scenarios")["scenarios_m"].as_array().unwrap().len(), 5);
    assert!(text(&run.stdout).contains("the best of 10 problems"), "{}", text(&run.stdout));
}

#[cfg(unix)]
#[test]
fn ctrl_c_keeps_the_best_plan_so_far() {
    use std::io::{BufRead, BufReader};
    let folder = tempfile::tempdir().unwrap();
    let mut child = command(folder.path(), &HOPELESS).stderr(std::process::Stdio::piped()).spawn().unwrap();
    let mut lines = BufReader::new(child.stderr.take().unwrap()).lines();
    assert!(lines.any(|line| line.unwrap().contains("variants of the problem")));
    assert!(Command::new("kill").args(["-INT", &child.id().to_string()]).status().unwrap().success());
    // Whoever stops reading must not stop the program.
    assert!(lines.all(|line| line.is_ok()));
    assert_eq!(child.wait().unwrap().code(), Some(130));
    let result = result(folder.path());
    assert!(result["robust"]["rounds"].as_array().unwrap().len() < 10);
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
