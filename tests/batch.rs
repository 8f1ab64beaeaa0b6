//! Batches: expanded once, run in any way, never losing or repeating a cell.

#![cfg(unix)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Output, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;
use tempfile::TempDir;

fn project(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").canonicalize().unwrap().join(name)
}

/// A folder with the corner scene and its homotopy, and one with so many steps that a stage takes a moment.
fn folder() -> TempDir {
    let folder = tempfile::tempdir().unwrap();
    let text = fs::read_to_string(project("scenes/corner.toml")).unwrap();
    let text = text.replace("../configs/homotopy_peg.toml", "homotopy.toml");
    fs::write(folder.path().join("corner.toml"), &text).unwrap();
    let slow = text.replace("steps = 20\ntime_step = 0.08", "steps = 40\ntime_step = 0.04");
    fs::write(folder.path().join("slow.toml"), slow).unwrap();
    fs::copy(project("configs/homotopy_peg.toml"), folder.path().join("homotopy.toml")).unwrap();
    let hasty = "[homotopy]\n[ipopt]\nmax_iter = 1\n";
    fs::write(folder.path().join("hasty.toml"), hasty).unwrap();
    folder
}

fn command(folder: &Path, arguments: &str) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_assembly-plan"));
    command.current_dir(folder).arg("batch").args(arguments.split(' '));
    command.env_remove("SLURM_ARRAY_TASK_ID").env_remove("HQ_TASK_ID");
    command
}

/// Runs `batch` and returns what it says on both streams.
#[track_caller]
fn batch(folder: &Path, arguments: &str, code: i32) -> String {
    said(command(folder, arguments).output().unwrap(), code)
}

#[track_caller]
fn said(output: Output, code: i32) -> String {
    let text = [output.stdout, output.stderr].concat();
    let text = String::from_utf8(text).unwrap();
    assert_eq!(output.status.code(), Some(code), "{text}");
    text
}

fn begin(folder: &Path, arguments: &str) -> Child {
    command(folder, arguments).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn().unwrap()
}

fn manifest(batch: &Path) -> Vec<Value> {
    let text = fs::read_to_string(batch.join("manifest.jsonl")).unwrap();
    text.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

/// Folders of all cells.
fn cells(batch: &Path) -> Vec<PathBuf> {
    manifest(batch).iter().map(|cell| batch.join(cell["folder"].as_str().unwrap())).collect()
}

/// When the result of each cell was written; none for an unfinished cell.
fn finished(batch: &Path) -> Vec<Option<std::time::SystemTime>> {
    let written = |cell: &PathBuf| fs::metadata(cell.join("result.json")).ok().map(|file| file.modified().unwrap());
    cells(batch).iter().map(written).collect()
}

/// `cells.csv` without what depends on time.
fn table(batch: &Path) -> Vec<Vec<String>> {
    let mut reader = csv::Reader::from_path(batch.join("cells.csv")).unwrap();
    let header = reader.headers().unwrap().clone();
    let kept =
        |column: &usize| !["wall_s", "distances_s", "model_s", "linear_solver_s", "rest_s"].contains(&&header[*column]);
    let kept: Vec<usize> = (0..header.len()).filter(kept).collect();
    reader
        .records()
        .map(Result::unwrap)
        .map(|row| kept.iter().map(|&column| row[column].to_owned()).collect())
        .collect()
}

#[track_caller]
fn wait_for(what: &str, is_so: impl Fn() -> bool) {
    let begun = Instant::now();
    while !is_so() {
        assert!(begun.elapsed() < Duration::from_secs(60), "waited in vain for {what}");
        std::thread::sleep(Duration::from_millis(2));
    }
}

fn send(signal: &str, process: &Child) {
    assert!(Command::new("kill").args([signal, &process.id().to_string()]).status().unwrap().success());
}

#[test]
fn a_manifest_comes_from_flags_or_a_file_and_never_changes() {
    let folder = folder();
    let folder = folder.path();
    let flags = "expand corner.toml slow.toml --starts all --deltas 0,0.01 --homotopies homotopy.toml,hasty.toml";
    batch(folder, &format!("{flags} --out flags"), 0);
    let written = fs::read(folder.join("flags/manifest.jsonl")).unwrap();
    let lines = manifest(&folder.join("flags"));
    assert_eq!(lines.len(), 2 * 3 * 2 * 2);
    assert_eq!((&lines[2]["start"], &lines[2]["delta_m"]), (&"1".into(), &0.01.into()));

    let matrix = "scenes = [\"corner.toml\", \"slow.toml\"]\nstarts = \"all\"\ndeltas = [0, 0.01]\n\
                  homotopies = [\"homotopy.toml\", \"hasty.toml\"]\n";
    fs::write(folder.join("matrix.toml"), matrix).unwrap();
    batch(folder, "expand --matrix matrix.toml --out file", 0);
    assert_eq!(fs::read(folder.join("file/manifest.jsonl")).unwrap(), written);

    let text = batch(folder, &format!("{flags} --out flags"), 0);
    assert!(text.contains("24 cells, as flags/manifest.jsonl already says"), "{text}");
    let text = batch(folder, "expand corner.toml --deltas 0 --out flags", 2);
    assert!(text.contains("flags/manifest.jsonl:1: this folder belongs to another batch"), "{text}");
    assert_eq!(fs::read(folder.join("flags/manifest.jsonl")).unwrap(), written);
}

#[test]
fn a_finished_batch_is_collected_and_not_solved_again() {
    let folder = folder();
    let folder = folder.path();
    let line = "corner.toml --starts 1,3 --deltas 0,0.01 --jobs 2 --out runs/corner";
    let text = batch(folder, line, 0);
    assert!(text.contains("4/4 cells done, 0 failed"), "{text}");
    let runs = folder.join("runs/corner");
    let solved = finished(&runs);
    let table = fs::read_to_string(runs.join("cells.csv")).unwrap();
    assert_eq!(table.lines().count(), 5);
    let collected: Value = serde_json::from_slice(&fs::read(runs.join("cells.json")).unwrap()).unwrap();
    assert_eq!(collected[3]["result"]["start"], "3");
    assert_eq!(collected[3]["state"], "done");

    let text = batch(folder, line, 0);
    assert!(text.contains("nothing to do: all 4 cells are finished, 4 done, 0 failed"), "{text}");
    assert!(!text.contains("written"), "{text}");
    assert_eq!(finished(&runs), solved);
    assert!(batch(folder, "status runs/corner", 0).contains("4 cells: 4 done, 0 running, 0 failed, 0 to do"));

    // A batch that has moved with its scenes is the same one.
    let moved = folder.join("moved");
    fs::create_dir(&moved).unwrap();
    for name in ["runs", "corner.toml", "homotopy.toml"] {
        fs::rename(folder.join(name), moved.join(name)).unwrap();
    }
    assert!(batch(&moved, line, 0).contains("nothing to do"));
}

#[test]
fn a_killed_batch_is_completed_by_a_rerun() {
    let folder = folder();
    let folder = folder.path();
    let line = "slow.toml --starts all --deltas 0.01,0.02 --jobs 2 --out";
    batch(folder, &format!("{line} whole"), 0);
    let killed = folder.join("killed");
    batch(folder, "expand slow.toml --starts all --deltas 0.01,0.02 --out killed", 0);
    let mut run = begin(folder, &format!("{line} killed"));
    let third = cells(&killed)[2].join("checkpoint.json");
    wait_for("a stage of the third cell", || third.exists());
    send("-KILL", &run);
    run.wait().unwrap();
    let before = finished(&killed);
    assert!(before.iter().any(Option::is_some) && before.iter().any(Option::is_none), "{before:?}");

    // At once: the orphans of the killed run may still be busy.
    batch(folder, &format!("{line} killed"), 0);
    assert_eq!(table(&killed), table(&folder.join("whole")));
    for (before, after) in before.iter().zip(finished(&killed)) {
        assert!(before.is_none() || *before == after, "a finished cell was solved again");
    }
}

#[test]
fn a_terminated_batch_goes_on_with_the_stage_it_had_reached() {
    let folder = folder();
    let folder = folder.path();
    batch(folder, "expand slow.toml --starts 1,2 --out runs", 0);
    let runs = folder.join("runs");
    let run = begin(folder, "run runs --jobs 1");
    wait_for("a stage of the first cell", || cells(&runs)[0].join("checkpoint.json").exists());
    assert!(batch(folder, "status runs", 0).contains("1 running"));
    send("-TERM", &run);
    let text = said(run.wait_with_output().unwrap(), 130);
    assert!(text.contains("interrupted with 2 cells to do"), "{text}");
    assert_eq!(finished(&runs), [None, None]);
    assert!(batch(folder, "status runs", 0).contains("2 cells: 0 done, 0 running, 0 failed, 2 to do"));

    batch(folder, "run runs --jobs 1", 0);
    let log = fs::read_to_string(cells(&runs)[0].join("log.txt")).unwrap();
    assert!(log.contains("going on after stage"), "{log}");
}

#[test]
fn two_runs_share_a_batch() {
    let folder = folder();
    let folder = folder.path();
    batch(folder, "expand corner.toml --starts all --deltas 0,0.01 --out runs", 0);
    let other = begin(folder, "run runs --jobs 1");
    let text = batch(folder, "run runs --jobs 1", 0) + &said(other.wait_with_output().unwrap(), 0);
    let solves = |line: &str| line.split("; ").nth(1)?.split(' ').next()?.parse::<usize>().ok();
    let solved: usize = text.lines().filter(|line| line.contains(" solves in ")).filter_map(solves).sum();
    assert_eq!(solved, 6, "{text}");
}

#[test]
fn failing_cells_are_named_and_stop_no_other() {
    let folder = folder();
    let folder = folder.path();
    let line = "corner.toml --starts 1,2 --homotopies hasty.toml,homotopy.toml --out runs";
    let text = batch(folder, line, 1);
    assert!(text.contains("2/4 cells done, 2 failed"), "{text}");
    assert!(text.contains("failed: cell 0 (corner, start 1, delta 0.02, hasty): stage 5: "), "{text}");
    assert!(text.contains("failed: cell 2 (corner, start 2, delta 0.02, hasty)"), "{text}");
    let text = batch(folder, line, 1);
    assert!(text.contains("nothing to do: all 4 cells are finished, 2 done, 2 failed"), "{text}");
    assert!(text.contains("failed: cell 2"), "{text}");

    // Cells whose scene is gone or another one since crash; those that are finished do not care.
    batch(folder, "expand corner.toml slow.toml --out changed", 0);
    batch(folder, "run changed --index 0", 0);
    fs::remove_file(folder.join("corner.toml")).unwrap();
    let scene = fs::read_to_string(folder.join("slow.toml")).unwrap();
    fs::write(folder.join("slow.toml"), scene.replace("mass = 1.0", "mass = 2.0")).unwrap();
    let text = batch(folder, "run changed", 1);
    assert!(text.contains("failed: cell 1 (slow, start 1, delta 0.02)"), "{text}");
    assert!(text.contains("is not the one of the manifest"), "{text}");
    assert!(batch(folder, "status changed", 0).contains("2 cells: 1 done, 0 running, 1 failed, 0 to do"));
    batch(folder, "collect changed", 0);
    fs::write(folder.join("slow.toml"), scene).unwrap();
    batch(folder, "run changed", 0);
}

#[test]
fn a_task_of_an_array_solves_its_own_cells() {
    let folder = folder();
    let folder = folder.path();
    batch(folder, "expand corner.toml --starts all --deltas 0,0.01 --out runs", 0);
    let runs = folder.join("runs");
    let done = || finished(&runs).iter().map(|time| u8::from(time.is_some())).collect::<Vec<u8>>();
    batch(folder, "run runs --index 1 --count 2", 0);
    assert_eq!(done(), [0, 1, 1, 0, 0, 0]);
    said(command(folder, "run runs").env("SLURM_ARRAY_TASK_ID", "4").output().unwrap(), 0);
    assert_eq!(done(), [0, 1, 1, 0, 1, 0]);
    said(command(folder, "run runs").env("HQ_TASK_ID", "0").output().unwrap(), 0);
    assert_eq!(done(), [1, 1, 1, 0, 1, 0]);
    // The last chunk may be shorter.
    said(command(folder, "run runs --count 4").env("SLURM_ARRAY_TASK_ID", "5").output().unwrap(), 0);
    assert_eq!(done(), [1, 1, 1, 0, 1, 1]);

    let text = said(command(folder, "run runs").env("SLURM_ARRAY_TASK_ID", "x").output().unwrap(), 2);
    assert!(text.contains("SLURM_ARRAY_TASK_ID=x: must be the number of a cell"), "{text}");
    let text = batch(folder, "run runs --index 6", 2);
    assert!(text.contains("--index 6: the cells of runs/manifest.jsonl are 0 to 5"), "{text}");

    batch(folder, "submit runs --slurm --count 4 -- --time=10:00", 0);
    let script = fs::read_to_string(runs.join("submit.sh")).unwrap();
    assert!(script.contains("#SBATCH --array=0-1\n") && script.contains("#SBATCH --time=10:00\n"), "{script}");
}

#[test]
fn wrong_input_exits_with_2_and_says_what_is_right() {
    let folder = folder();
    let folder = folder.path();
    let matrices = [
        (
            "scenes = [\"corner.toml\"]\nstart = [\"1\"]\n",
            "matrix.toml:2:1: unknown key `start`, did you mean `starts`?",
        ),
        ("scenes = [\"corner.toml\"]\nstarts = [\"9\"]\n", "matrix.toml:2:10: corner.toml: there is no start `9`"),
        ("scenes = [\"corner.toml\"]\ndeltas = [-1]\n", "matrix.toml:2:11: deltas: -1 must lie between 0 and 10 m"),
        ("scenes = []\n", "matrix.toml:1:10: at least one scene is needed"),
        ("scenes = [\"none.toml\"]\n", "none.toml: the scene cannot be read"),
        ("scenes = [\"corner.toml\"]\nstarts = 1\n", "matrix.toml:2:10: starts must be \"all\" or a list of names"),
        (
            "scenes = [\"corner.toml\"]\nlinear_solver = \"mump\"\n",
            "matrix.toml:2:17: unknown value `mump`, did you mean",
        ),
        ("scenes = [\"corner.toml\", \"corner.toml\"]\n", "are the same problem; name it once"),
    ];
    for (matrix, message) in matrices {
        fs::write(folder.join("matrix.toml"), matrix).unwrap();
        let text = batch(folder, "--matrix matrix.toml --out runs", 2);
        assert!(text.contains(message), "{text}");
        assert!(!folder.join("runs").exists(), "{matrix}");
    }
    let flags = [
        ("expand", "name scenes, or a matrix file with --matrix"),
        ("corner.toml --starts 9", "--starts: corner.toml: there is no start `9`; the scene has 1, 2, 3"),
        ("corner.toml --linear-solver mump", "'mump'"),
        ("run runs", "runs/manifest.jsonl: there is none; `assembly-plan batch expand` writes it"),
        ("run runs --count 2 --jobs 0", "--jobs"),
    ];
    for (arguments, message) in flags {
        let text = batch(folder, arguments, 2);
        assert!(text.contains(message), "{text}");
    }
    fs::create_dir(folder.join("runs")).unwrap();
    fs::write(folder.join("runs/manifest.jsonl"), "{\"index\":0}\n").unwrap();
    assert!(batch(folder, "run runs", 2).contains("runs/manifest.jsonl:1: missing field `scene`"));
}
