//! Wrong input, and what is said about it: exit code 2, a message that names the file, flag or key and what would be
//! right, nothing on standard output, nothing written.

#[path = "wrong_inputs/batch.rs"]
mod batch;
#[path = "wrong_inputs/check.rs"]
mod check;
#[path = "wrong_inputs/flags.rs"]
mod flags;
#[path = "wrong_inputs/homotopies.rs"]
mod homotopies;
#[path = "wrong_inputs/plans.rs"]
mod plans;
#[path = "wrong_inputs/report.rs"]
mod report;
#[path = "wrong_inputs/scenes.rs"]
mod scenes;
#[path = "wrong_inputs/simulate.rs"]
mod simulate;
#[path = "wrong_inputs/solve.rs"]
mod solve;
#[path = "wrong_inputs/starting.rs"]
mod starting;
use std::collections::VecDeque;
use std::sync::{LazyLock, Mutex};
use std::thread;

use crate::support::Dir;
use crate::support::small::SMALL;

/// A file, what is replaced in it (all of it, if empty), and by what.
type Edit = (&'static str, &'static str, &'static str);
/// A command line, changes of files, words of the message.
type Row = (&'static str, &'static [Edit], &'static str);

/// What every row starts from: a scene, its plan in `plan`, a batch in `runs`, and files that they may name.
static RIGHT: LazyLock<Dir> = LazyLock::new(|| {
    let dir = Dir::new();
    dir.write("scene.toml", SMALL);
    dir.add_homotopy("homotopy.toml", "iterations = 1\ntau = 0.0025", "tol = 1e-2\nmax_iter = 3000");
    dir.write(
        "matrix.toml",
        "scenes = [\"scene.toml\"]\nstarts = [\"a\"]\ndeltas = [0.01]\nlinear_solver = \"stage\"\n",
    );
    dir.write("offsets.csv", "x_m,y_m,z_m\n0,0,0\n0.001,0,0\n");
    dir.write("latin.toml", b"title = \"Bohr\xe4\"\n");
    dir.write("binary.toml", [0, 159, 146, 150, 10]);
    dir.make_folder("folder");
    dir.run("solve scene.toml --out plan").code(0);
    dir.run("batch expand scene.toml --out runs").code(0);
    dir
});

/// A folder with everything that is right, and some edits.
fn folder(edits: &[Edit]) -> Dir {
    let dir = Dir::new();
    dir.copy(RIGHT.folder().to_str().unwrap(), "");
    for (file, from, to) in edits {
        let text = if from.is_empty() { String::new() } else { dir.read(file) };
        assert!(text.contains(from), "{from} is not in {file}");
        let changed = text.replacen(from, to, 1);
        dir.write(file, if file.ends_with("result.json") { planner::files::sealed(changed) } else { changed });
    }
    dir
}

/// What is wrong with the refusal of a row.
fn fault(line: &str, edits: &[Edit], words: &str) -> Option<String> {
    let dir = folder(edits);
    let before = dir.snapshot("");
    let run = dir.program(line).spawn().finish_in_time();
    let fault = if run.code != Some(2) {
        format!("exit code {:?}", run.code)
    } else if !run.stdout.is_empty() {
        "something on standard output".to_owned()
    } else if run.has("panicked") || run.has("RUST_BACKTRACE") || run.has("internal error") {
        "a panic".to_owned()
    } else if !run.stderr.contains(words) {
        format!("`{words}` is missing")
    } else if run.stderr.len() > 2000 {
        format!("{} bytes of message", run.stderr.len())
    } else if dir.snapshot("") != before {
        "something was written".to_owned()
    } else {
        return None;
    };
    Some(format!("{line}\n  {edits:?}\n  {fault}\n  {}", run.stderr.trim_end()))
}

/// Runs all rows, some at a time, and lists all that go wrong.
#[track_caller]
fn refused(rows: Vec<(String, &[Edit], &str)>) {
    LazyLock::force(&RIGHT);
    let count = rows.len();
    let (rows, faults) = (Mutex::new(VecDeque::from(rows)), Mutex::new(Vec::new()));
    let next = || rows.lock().unwrap().pop_front();
    thread::scope(|scope| {
        for _ in 0..4 {
            scope.spawn(|| {
                while let Some((line, edits, words)) = next() {
                    let fault = fault(&line, edits, words);
                    faults.lock().unwrap().extend(fault);
                }
            });
        }
    });
    let mut faults = faults.into_inner().unwrap();
    faults.sort();
    assert!(faults.is_empty(), "{} of {count} go wrong:\n\n{}", faults.len(), faults.join("\n\n"));
}

#[track_caller]
fn refused_as_listed(rows: &'static [Row]) {
    refused(rows.iter().map(|(line, edits, words)| ((*line).to_owned(), *edits, *words)).collect());
}

#[test]
#[ignore = "slow, a run of the program for each row: scripts/test and CI run it"]
fn what_the_rows_change_is_right() {
    let dir = folder(&[]);
    for line in [
        "check scene.toml --delta 0.01 --tau 0.001 --pose '0.2 0 0.2 1 0 0 0' --json",
        "simulate scene.toml plan --random 2 --friction 0,0.1 --out tables",
        "simulate scene.toml plan --offsets offsets.csv --out tables",
        "batch expand scene.toml --homotopies homotopy.toml --out others",
        "batch expand --matrix matrix.toml --out more",
        "new folder/new.toml",
        "new scene.toml --force",
        "generate round --out folder/round.toml",
        "generate keyed --diameter 0.008 --out folder/keyed.toml",
        "batch status runs",
        "batch collect runs",
        "batch submit runs --slurm",
    ] {
        dir.run(line).code(0);
    }
    dir.run("solve scene.toml --homotopy homotopy.toml --out out").says("written to out");
}

#[test]
#[ignore = "slow, a run of every command for each row: scripts/test and CI run it"]
fn a_wrong_scene_is_refused_by_every_command() {
    let lines = [
        "check scene.toml",
        "solve scene.toml --out out",
        "simulate scene.toml plan",
        "batch expand scene.toml --out others",
    ];
    let rows = scenes::ROWS.iter().flat_map(|(edit, words)| {
        lines.iter().map(move |line| ((*line).to_owned(), std::slice::from_ref(edit), *words))
    });
    refused(rows.collect());
}

#[test]
fn a_wrong_homotopy_is_refused_by_every_command_that_takes_one() {
    let lines =
        ["solve scene.toml --homotopy homotopy.toml --out out", "batch expand scene.toml --homotopies homotopy.toml"];
    let rows = homotopies::ROWS.iter().flat_map(|(edit, words)| {
        lines.iter().map(move |line| ((*line).to_owned(), std::slice::from_ref(edit), *words))
    });
    refused(rows.collect());
}

#[test]
#[ignore = "slow, a run of the program for each row: scripts/test and CI run it"]
fn a_wrong_value_of_a_flag_is_refused() {
    let rows = flags::ROWS.iter().flat_map(|(line, flag, values, words)| {
        values.iter().map(move |value| {
            let words = if words.is_empty() { *flag } else { *words };
            (format!("{line} {flag}={value}"), &[][..], words)
        })
    });
    refused(rows.collect());
}

#[test]
fn wrong_words_and_files_of_solve_are_refused() {
    refused_as_listed(solve::ROWS);
}

#[test]
fn wrong_words_and_files_of_check_are_refused() {
    refused_as_listed(check::ROWS);
}

#[test]
fn wrong_words_and_files_of_simulate_are_refused() {
    refused_as_listed(simulate::ROWS);
}

#[test]
fn wrong_words_and_files_of_new_and_generate_are_refused() {
    refused_as_listed(starting::ROWS);
}

#[test]
fn wrong_plans_are_refused() {
    refused_as_listed(plans::ROWS);
}

#[test]
fn wrong_words_and_files_of_batch_are_refused() {
    refused_as_listed(batch::ROWS);
}

#[test]
fn folders_without_a_page_are_refused() {
    refused_as_listed(report::ROWS);
}
