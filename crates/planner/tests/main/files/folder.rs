//! The folder of a plan: nothing is replaced before its replacement stands, or that no earlier run has written.

use std::fs;
use std::path::Path;
use std::sync::atomic::AtomicBool;

use planner::files::{PlanFolder, StoredPlan};

use crate::files::support::{claim, plan, solve};

/// Names and contents of all files below a folder.
fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).unwrap().map(Result::unwrap) {
        let name = entry.file_name().into_string().unwrap();
        if entry.path().is_dir() {
            found.extend(contents(&entry.path()).into_iter().map(|(below, bytes)| (format!("{name}/{below}"), bytes)));
        } else {
            found.push((name, fs::read(entry.path()).unwrap()));
        }
    }
    found.sort();
    found
}

fn refusal(out: &Path, inputs: &[&Path]) -> String {
    let before = contents(out);
    let error = PlanFolder::claim(out, inputs).unwrap_err().to_string();
    assert_eq!(contents(out), before, "{error}");
    error
}

#[test]
fn a_folder_has_one_writer() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    let first = claim(&out);
    let error = PlanFolder::claim(&out, &[]).unwrap_err().to_string();
    assert!(error.contains("another run is writing"), "{error}");
    first.finish(plan()).unwrap();
    drop(claim(&out));
}

#[test]
fn nothing_but_the_plan_is_left() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("deep/out");
    claim(&out).finish(plan()).unwrap();
    let left: Vec<_> = fs::read_dir(out.parent().unwrap()).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["out"]);
}

#[test]
fn a_newer_plan_replaces_an_older_one_and_keeps_what_is_not_its_own() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    claim(&out).finish(plan()).unwrap();
    fs::write(out.join("notes.txt"), "mine").unwrap();
    let mut shorter = plan().clone();
    shorter.iterations.truncate(2);
    claim(&out).finish(&shorter).unwrap();
    assert_eq!(fs::read_to_string(out.join("notes.txt")).unwrap(), "mine");
    assert!(out.join("stages/2").exists() && !out.join("stages/3").exists(), "older iterations are gone");
    assert_eq!(StoredPlan::open(&out).unwrap().result.stages.len(), 2);
}

#[test]
fn what_no_earlier_run_has_written_is_not_replaced() {
    let folder = tempfile::tempdir().unwrap();
    for (name, words) in [
        ("stages/notes.txt", "stages/notes.txt: was not written by an earlier run"),
        ("reference.csv", "reference.csv: was not written by an earlier run"),
        ("result.json", "holds no plan that may be replaced"),
        ("stages", "stages: was not written by an earlier run"),
    ] {
        let out = folder.path().join(name.replace('/', "-"));
        let file = out.join(name);
        fs::create_dir_all(file.parent().unwrap()).unwrap();
        fs::write(file, "{}").unwrap();
        let error = refusal(&out, &[]);
        assert!(error.contains(words), "{error}");
    }
}

#[test]
fn a_plan_that_was_edited_is_not_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    claim(&out).finish(plan()).unwrap();
    let file = out.join("reference.csv");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(&file, format!("{text}\n")).unwrap();
    assert!(refusal(&out, &[]).contains("was changed since the plan was written"));
    assert!(StoredPlan::open(&out).unwrap_err().to_string().contains("was changed since the plan was written"));
    fs::remove_file(&file).unwrap();
    assert!(StoredPlan::open(&out).unwrap_err().to_string().contains("belongs to the plan and cannot be read"));
    drop(claim(&out));
}

#[test]
fn an_input_is_not_replaced() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    claim(&out).finish(plan()).unwrap();
    let error = refusal(&out, &[&out.join("resolved.toml")]);
    assert!(error.contains("is an input of this run"), "{error}");
}

#[test]
fn a_listed_file_outside_of_the_plan_is_not_removed() {
    let folder = tempfile::tempdir().unwrap();
    let out = folder.path().join("out");
    claim(&out).finish(plan()).unwrap();
    let victim = folder.path().join("victim.txt");
    fs::write(&victim, "mine").unwrap();
    let result = fs::read_to_string(out.join("result.json")).unwrap();
    fs::write(out.join("result.json"), result.replace("\"resolved.toml\"", "\"../victim.txt\"")).unwrap();
    assert!(refusal(&out, &[]).contains("which is not a file of a plan"));
    assert!(victim.exists());
}

#[test]
fn a_run_that_was_killed_while_it_moved_a_plan_in_is_completed() {
    let folder = tempfile::tempdir().unwrap();
    let (out, whole) = (folder.path().join("out"), folder.path().join("whole"));
    claim(&whole).finish(plan()).unwrap();
    let expected = contents(&whole);
    let files: Vec<&str> = expected.iter().map(|(name, _)| name.as_str()).collect();
    // After any number of files.
    for moved in [0, 1, 3, files.len() - 2] {
        let work = folder.path().join(".out.unfinished");
        for (index, (name, bytes)) in expected.iter().enumerate() {
            let is_moved = index < moved && name != "result.json";
            let file = if is_moved { out.join(name) } else { work.join("whole").join(name) };
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, bytes).unwrap();
        }
        fs::write(work.join("lock"), "").unwrap();
        drop(claim(&out));
        assert_eq!(contents(&out), expected);
        StoredPlan::open(&out).unwrap();
        fs::remove_dir_all(&out).unwrap();
        assert!(!work.exists(), "nothing unfinished is left");
    }
}

#[test]
fn unfinished_work_is_continued_and_gives_the_same_plan() {
    let folder = tempfile::tempdir().unwrap();
    let (out, never) = (folder.path().join("out"), AtomicBool::new(false));
    let first = claim(&out);
    solve(0.01, Some(&first), &never);
    drop(first);
    let second = claim(&out);
    let again = solve(0.01, Some(&second), &never);
    assert_eq!(again.trajectory.reference, plan().trajectory.reference);
    let wall =
        |plan: &planner::Plan| plan.iterations.iter().map(|iteration| iteration.record.wall_s).collect::<Vec<_>>();
    let other = solve(0.02, Some(&second), &never);
    assert_ne!(wall(&other), wall(&again), "work on another problem is discarded");
    assert!(!out.exists(), "nothing is moved in before the end");
}

#[test]
fn a_stored_plan_is_copied_unless_it_was_changed() {
    let folder = tempfile::tempdir().unwrap();
    let (out, copy) = (folder.path().join("out"), folder.path().join("copy"));
    claim(&out).finish(plan()).unwrap();
    let stored = StoredPlan::open(&out).unwrap();
    claim(&copy).copy(&stored).unwrap();
    assert_eq!(contents(&copy), contents(&out));
    let mut shorter = plan().clone();
    shorter.iterations.truncate(2);
    claim(&out).finish(&shorter).unwrap();
    let error = claim(&folder.path().join("other")).copy(&stored).unwrap_err().to_string();
    assert!(error.contains("holds another plan by now"), "{error}");
    fs::write(out.join("reference.csv"), "mine").unwrap();
    let error = claim(&folder.path().join("other")).copy(&stored).unwrap_err().to_string();
    assert!(error.contains("was changed since"), "{error}");
    assert!(!folder.path().join("other").exists());
}
