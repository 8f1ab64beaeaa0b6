//! An interrupted or killed solve goes on where it stopped.

#![cfg(unix)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::Duration;

use serde_json::Value;

fn project(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap().join(name)
}

/// The corner scene with so many steps that each of its stages takes a moment.
fn scene(folder: &Path) -> PathBuf {
    let homotopy = project("configs/homotopy_peg.toml");
    let text = fs::read_to_string(project("scenes/corner.toml")).unwrap();
    let text = text.replace("../configs/homotopy_peg.toml", homotopy.to_str().unwrap());
    let scene = folder.join("corner.toml");
    fs::write(&scene, text.replace("steps = 20\ntime_step = 0.08", "steps = 30\ntime_step = 0.053")).unwrap();
    scene
}

fn solve(scene: &Path, out: &Path, flags: &[&str]) -> Child {
    let mut command = Command::new(env!("CARGO_BIN_EXE_assembly-plan"));
    command.arg("solve").arg(scene).arg("--out").arg(out).args(flags);
    command.stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

fn finish(child: Child, code: Option<i32>) -> String {
    let Output { status, stderr, .. } = child.wait_with_output().unwrap();
    let stderr = String::from_utf8(stderr).unwrap();
    assert_eq!(status.code(), code, "{stderr}");
    stderr
}

/// Sends a signal when the first stage is finished.
fn signal_after_first_stage(child: &Child, out: &Path, signal: &str) {
    while !out.join("checkpoint.json").exists() {
        std::thread::sleep(Duration::from_millis(2));
    }
    assert!(Command::new("kill").args([signal, &child.id().to_string()]).status().unwrap().success());
}

fn result(out: &Path) -> Value {
    serde_json::from_str(&fs::read_to_string(out.join("result.json")).unwrap()).unwrap()
}

fn stage_iterations(out: &Path) -> Vec<u64> {
    let result = result(out);
    result["stages"].as_array().unwrap().iter().map(|stage| stage["iterations"].as_u64().unwrap()).collect()
}

#[test]
fn a_resumed_plan_is_the_uninterrupted_one() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path());
    let whole = folder.path().join("whole");
    finish(solve(&scene, &whole, &["--resume"]), Some(0));
    assert!(!whole.join("checkpoint.json").exists(), "a whole plan needs no checkpoint");

    for (signal, code) in [("-TERM", Some(130)), ("-KILL", None)] {
        let out = folder.path().join(signal);
        let child = solve(&scene, &out, &["--resume"]);
        signal_after_first_stage(&child, &out, signal);
        finish(child, code);
        assert!(!out.join("result.json").exists(), "{signal}: looks finished");
        assert!(out.join("stages/1/reference.csv").exists());

        let stderr = finish(solve(&scene, &out, &["--resume"]), Some(0));
        assert!(stderr.contains("going on after stage"), "{stderr}");
        assert!(!stderr.contains("stage 1/5 (tau"), "the first stage ran again: {stderr}");
        assert!(!out.join("checkpoint.json").exists());
        assert_eq!(stage_iterations(&out), stage_iterations(&whole));
        for file in ["reference.csv", "scenarios.csv", "contacts.csv", "stages/1/reference.csv", "resolved.toml"] {
            assert_eq!(fs::read(out.join(file)).unwrap(), fs::read(whole.join(file)).unwrap(), "{signal}: {file}");
        }
    }
}

#[test]
fn a_checkpoint_is_used_only_for_its_own_problem_and_when_asked() {
    let folder = tempfile::tempdir().unwrap();
    let scene = scene(folder.path());
    let out = folder.path().join("out");
    let child = solve(&scene, &out, &[]);
    signal_after_first_stage(&child, &out, "-INT");
    finish(child, Some(130));
    assert!(result(&out)["status"].as_str().unwrap().ends_with("interrupted"), "a plain solve keeps its last iterate");

    let checkpoint = fs::read(out.join("checkpoint.json")).unwrap();
    let stderr = finish(solve(&scene, &out, &["--resume", "--delta", "0.01"]), Some(0));
    assert!(!stderr.contains("going on"), "{stderr}");
    fs::write(out.join("checkpoint.json"), &checkpoint[..checkpoint.len() / 2]).unwrap();
    let stderr = finish(solve(&scene, &out, &["--resume"]), Some(0));
    assert!(!stderr.contains("going on"), "{stderr}");
    fs::write(out.join("checkpoint.json"), &checkpoint).unwrap();
    let stderr = finish(solve(&scene, &out, &["--resume"]), Some(0));
    assert!(stderr.contains("going on after stage"), "{stderr}");
}
