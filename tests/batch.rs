//! Batches: expanded once, run in any way, never losing or repeating a cell.

#![cfg(unix)]

use std::path::{Path, PathBuf};
use std::time::SystemTime;

use serde_json::Value;

use crate::support::{Dir, Run, Running, TestCommand};

/// A folder with the corner scene, with a scene of enough steps that a homotopy step takes a moment, and with a
/// homotopy that ends too early.
fn folder() -> Dir {
    let dir = Dir::new();
    dir.add_variant("slow.toml", &[("steps = 20\ntime_step = 0.08", "steps = 40\ntime_step = 0.04")]);
    dir.add_homotopy("hasty.toml", "", "max_iter = 1");
    dir
}

fn command(dir: &Dir, arguments: &str) -> TestCommand {
    dir.program(&format!("batch {arguments}"))
}

/// Runs `batch` and expects an exit code.
#[track_caller]
fn batch(dir: &Dir, arguments: &str, code: i32) -> Run {
    command(dir, arguments).run().code(code)
}

fn begin(dir: &Dir, arguments: &str) -> Running {
    command(dir, arguments).spawn()
}

fn manifest(dir: &Dir, folder: &str) -> Vec<Value> {
    dir.read(format!("{folder}/manifest.jsonl")).lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// Folders of all cells.
fn cells(dir: &Dir, folder: &str) -> Vec<PathBuf> {
    manifest(dir, folder).iter().map(|cell| dir.path(folder).join(cell["folder"].as_str().unwrap())).collect()
}

/// The checkpoint of a cell, while it is solved.
fn checkpoint(cell: &Path) -> PathBuf {
    let name = format!(".{}.unfinished", cell.file_name().unwrap().to_str().unwrap());
    cell.with_file_name(name).join("checkpoint.json")
}

/// When the result of each cell was written; none for an unfinished cell.
fn finished(dir: &Dir, folder: &str) -> Vec<Option<SystemTime>> {
    let written = |cell: &PathBuf| cell.join("result.json").metadata().ok().map(|file| file.modified().unwrap());
    cells(dir, folder).iter().map(written).collect()
}

/// `cells.csv` without what depends on time.
fn table(dir: &Dir, folder: &str) -> Vec<Vec<String>> {
    let times = ["wall_s", "distances_s", "model_s", "linear_solver_s", "rest_s"];
    dir.table(format!("{folder}/cells.csv")).without(&times)
}

#[test]
fn a_manifest_comes_from_flags_or_a_file_and_never_changes() {
    let dir = folder();
    let flags = "expand corner.toml slow.toml --starts all --deltas 0,0.01 --homotopies homotopy.toml,hasty.toml";
    batch(&dir, &format!("{flags} --out flags"), 0);
    let written = dir.bytes("flags/manifest.jsonl");
    let lines = manifest(&dir, "flags");
    assert_eq!(lines.len(), 2 * 3 * 2 * 2);
    assert_eq!((&lines[2]["start"], &lines[2]["delta_m"]), (&"1".into(), &0.01.into()));

    let matrix = "scenes = [\"corner.toml\", \"slow.toml\"]\nstarts = \"all\"\ndeltas = [0, 0.01]\n\
                  homotopies = [\"homotopy.toml\", \"hasty.toml\"]\n";
    dir.write("matrix.toml", matrix);
    batch(&dir, "expand --matrix matrix.toml --out file", 0);
    assert_eq!(dir.bytes("file/manifest.jsonl"), written);

    batch(&dir, &format!("{flags} --out flags"), 0).says("24 cells, as flags/manifest.jsonl already says");
    batch(&dir, "expand corner.toml --deltas 0 --out flags", 2)
        .says("flags/manifest.jsonl:1: this folder belongs to another batch");
    assert_eq!(dir.bytes("flags/manifest.jsonl"), written);
}

#[test]
fn a_finished_batch_is_collected_and_not_solved_again() {
    let dir = folder();
    let line = "corner.toml --starts 1,3 --deltas 0,0.01 --jobs 2 --out runs/corner";
    batch(&dir, line, 0).says("4/4 cells planned, 0 failed");
    let solved = finished(&dir, "runs/corner");
    assert_eq!(dir.read("runs/corner/cells.csv").lines().count(), 5);
    let collected = dir.json("runs/corner/cells.json");
    assert_eq!(collected[3]["result"]["start"], "3");
    assert_eq!(collected[3]["state"], "planned");

    batch(&dir, line, 0)
        .says("nothing to do: all 4 cells are finished, 4 planned, 0 failed")
        .keeps_silent_about("written");
    assert_eq!(finished(&dir, "runs/corner"), solved);
    batch(&dir, "status runs/corner", 0).says("4 cells: 4 planned, 0 running, 0 failed, 0 to do");

    // A batch that has moved with its scenes is the same one.
    dir.make_folder("moved");
    for name in ["runs", "corner.toml", "homotopy.toml"] {
        dir.rename(name, &format!("moved/{name}"));
    }
    let moved = TestCommand::new(&dir.path("moved"), &format!("batch {line}"));
    moved.run().code(0).says("nothing to do");
}

#[test]
#[ignore = "slow, a batch that is killed again and again: scripts/test and CI run it"]
fn a_killed_batch_is_completed_by_a_rerun() {
    let dir = folder();
    let line = "slow.toml --starts all --deltas 0.01,0.02 --jobs 2 --out";
    batch(&dir, &format!("{line} whole"), 0);
    batch(&dir, "expand slow.toml --starts all --deltas 0.01,0.02 --out killed", 0);
    let mut run = begin(&dir, &format!("{line} killed"));
    let third = checkpoint(&cells(&dir, "killed")[2]);
    run.wait_until("a homotopy step of the third cell", || third.exists());
    run.signal("KILL");
    assert_eq!(run.finish().code, None);
    let before = finished(&dir, "killed");
    assert!(before.iter().any(Option::is_some) && before.iter().any(Option::is_none), "{before:?}");

    // At once: the orphans of the killed run may still be busy.
    batch(&dir, &format!("{line} killed"), 0);
    assert_eq!(table(&dir, "killed"), table(&dir, "whole"));
    for (before, after) in before.iter().zip(finished(&dir, "killed")) {
        assert!(before.is_none() || *before == after, "a finished cell was solved again");
    }
}

#[test]
fn a_terminated_batch_resumes_from_the_homotopy_step_it_had_reached() {
    let dir = folder();
    batch(&dir, "expand slow.toml --starts 1,2 --out runs", 0);
    let cell = cells(&dir, "runs")[0].clone();
    let mut run = begin(&dir, "run runs --jobs 1");
    run.wait_until("a homotopy step of the first cell", || checkpoint(&cell).exists());
    batch(&dir, "status runs", 0).says("1 running");
    run.signal("TERM");
    run.finish().code(130).says("interrupted; 2 cells left");
    assert_eq!(finished(&dir, "runs"), [None, None]);
    batch(&dir, "status runs", 0).says("2 cells: 0 planned, 0 running, 0 failed, 2 to do");

    batch(&dir, "run runs --jobs 1", 0);
    let log = dir.read(cell.join("log.txt"));
    assert!(log.contains("resuming after homotopy step"), "{log}");
}

#[test]
fn two_runs_share_a_batch() {
    let dir = folder();
    batch(&dir, "expand corner.toml --starts all --deltas 0,0.01 --out runs", 0);
    let other = begin(&dir, "run runs --jobs 1");
    let texts = [batch(&dir, "run runs --jobs 1", 0), other.finish().code(0)].map(|run| run.stderr);
    let solves = |line: &str| line.split("; ").nth(1)?.split(' ').next()?.parse::<usize>().ok();
    let lines = texts.iter().flat_map(|text| text.lines());
    let solved: usize = lines.filter(|line| line.contains(" solves in ")).filter_map(solves).sum();
    assert_eq!(solved, 6, "{texts:?}");
}

#[test]
fn failing_cells_are_named_and_stop_no_other() {
    let dir = folder();
    let line = "corner.toml --starts 1,2 --homotopies hasty.toml,homotopy.toml --out runs";
    batch(&dir, line, 1)
        .says("2/4 cells planned, 2 failed")
        .says("failed: cell 0 (corner, start 1, delta 0.02, hasty): homotopy step 5: iteration limit reached")
        .says("failed: cell 2 (corner, start 2, delta 0.02, hasty)");
    batch(&dir, line, 1).says("nothing to do: all 4 cells are finished, 2 planned, 2 failed").says("failed: cell 2");

    // Cells whose scene is gone or another one since crash; those that are finished do not care.
    batch(&dir, "expand corner.toml slow.toml --out changed", 0);
    batch(&dir, "run changed --index 0", 0);
    dir.remove("corner.toml");
    let scene = dir.read("slow.toml");
    dir.write("slow.toml", scene.replace("mass = 1.0", "mass = 2.0"));
    batch(&dir, "run changed", 1)
        .says("failed: cell 1 (slow, start 1, delta 0.02)")
        .says("is not the one of the manifest");
    batch(&dir, "status changed", 0).says("2 cells: 1 planned, 0 running, 1 failed, 0 to do");
    batch(&dir, "collect changed", 0);
    dir.write("slow.toml", scene);
    batch(&dir, "run changed", 0);
}

#[test]
fn a_task_of_an_array_solves_its_own_cells() {
    let dir = folder();
    batch(&dir, "expand corner.toml --starts all --deltas 0,0.01 --out runs", 0);
    let done = || finished(&dir, "runs").iter().map(|time| u8::from(time.is_some())).collect::<Vec<u8>>();
    batch(&dir, "run runs --index 1 --count 2", 0);
    assert_eq!(done(), [0, 1, 1, 0, 0, 0]);
    command(&dir, "run runs").env("SLURM_ARRAY_TASK_ID", "4").run().code(0);
    assert_eq!(done(), [0, 1, 1, 0, 1, 0]);
    command(&dir, "run runs").env("HQ_TASK_ID", "0").run().code(0);
    assert_eq!(done(), [1, 1, 1, 0, 1, 0]);
    // The last chunk may be shorter.
    command(&dir, "run runs --count 4").env("SLURM_ARRAY_TASK_ID", "5").run().code(0);
    assert_eq!(done(), [1, 1, 1, 0, 1, 1]);

    command(&dir, "run runs")
        .env("SLURM_ARRAY_TASK_ID", "x")
        .run()
        .code(2)
        .says("SLURM_ARRAY_TASK_ID=x: must be the number of a cell");
    batch(&dir, "run runs --index 6", 2).says("--index 6: the cells of runs/manifest.jsonl are 0 to 5");

    batch(&dir, "submit runs --slurm --count 4 -- --time=10:00", 0);
    let script = dir.read("runs/submit.sh");
    assert!(script.contains("#SBATCH --array=0-1\n") && script.contains("#SBATCH --time=10:00\n"), "{script}");
}

#[test]
fn a_plan_of_another_cell_is_not_taken_for_its_own() {
    let dir = folder();
    batch(&dir, "corner.toml --deltas 0.01,0.02 --out runs", 0);
    let found = cells(&dir, "runs");
    let [one, other] = [0, 1].map(|index| found[index].to_str().unwrap().to_owned());
    for (from, to) in [(&one, "kept"), (&other, one.as_str()), (&"kept".to_owned(), other.as_str())] {
        dir.rename(from, to);
    }
    let words = "the plan was made for start 1, offset magnitude 0.02 m, and not for this cell";
    batch(&dir, "status runs", 0).says("0 planned, 0 running, 2 failed").says(words);
    batch(&dir, "collect runs", 0);
    assert_eq!(dir.table("runs/cells.csv").column("state"), ["failed", "failed"]);
    for (from, to) in [(&one, "kept"), (&other, one.as_str()), (&"kept".to_owned(), other.as_str())] {
        dir.rename(from, to);
    }
    // A manifest that was edited is not believed either.
    let manifest = dir.read("runs/manifest.jsonl").replace("\"delta_m\":0.01", "\"delta_m\":0.03");
    dir.write("runs/manifest.jsonl", manifest);
    batch(&dir, "status runs", 0)
        .says("1 planned, 0 running, 1 failed")
        .says("offset magnitude 0.01 m, and not for this cell");
}

#[test]
fn a_cell_that_has_lost_a_file_is_no_finished_one() {
    let dir = folder();
    batch(&dir, "corner.toml --starts 1,2 --out runs", 0);
    let cell = &cells(&dir, "runs")[1];
    let lost = cell.join("stages/2/wrench.csv");
    dir.remove(&lost);
    let words = "stages/2/wrench.csv: belongs to the plan and cannot be read";
    batch(&dir, "status runs", 0)
        .says("2 cells: 1 planned, 0 running, 1 failed, 0 to do")
        .says("failed: cell 1")
        .says(words);
    batch(&dir, "collect runs", 0);
    assert_eq!(dir.table("runs/cells.csv").column("state"), ["planned", "failed"]);
    assert_eq!(dir.json("runs/cells.json")[1]["result"], Value::Null);
    batch(&dir, "run runs", 1).says("failed: cell 1").says(words);
    // A changed one neither.
    dir.remove(cell);
    batch(&dir, "run runs", 0);
    dir.write(cell.join("reference.csv"), "mine");
    batch(&dir, "status runs", 0).says("reference.csv: was changed since the plan was written");
    batch(&dir, "run runs", 1).says("was changed since the plan was written");
    assert_eq!(dir.read(cell.join("reference.csv")), "mine");
    // A file is no folder.
    dir.remove(cell);
    dir.write(cell, "");
    let words = "is a file, where the plan's folder should be; remove it";
    batch(&dir, "status runs", 0).says("1 failed").says(words);
    batch(&dir, "run runs", 1).says("failed: cell 1").says(cell.file_name().unwrap().to_str().unwrap());
}

#[test]
fn a_name_that_would_end_a_comment_of_the_script_is_refused() {
    let dir = folder();
    batch(&dir, "expand corner.toml --out runs", 0);
    for name in ["a\nrm b", "a\"b", "a\\b", "a\tb"] {
        dir.copy("runs", name);
        let refused = dir.program("batch submit --slurm").arg(name).run().code(2);
        refused.says("which Slurm cannot take; rename the folder");
        assert!(!dir.exists(Path::new(name).join("submit.sh")), "{name:?}");
    }
    // A quote of the shell is one letter among others.
    dir.copy("runs", "it's $(here)");
    dir.program("batch submit --slurm").arg("it's $(here)").run().code(0);
    let script = dir.read("it's $(here)/submit.sh");
    assert!(script.contains(r"it'\''s $(here)' --index"), "{script}");
}
