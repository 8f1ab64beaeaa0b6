//! Nothing that stands is destroyed: what is refused, stopped or cannot be written leaves every byte where it was.

#![cfg(unix)]

use std::thread;
use std::time::Duration;

use crate::support::{Dir, TestCommand};
use planner::files::{PlanFolder, StoredPlan};

/// A folder with a plan in `out`.
fn plan() -> Dir {
    let dir = Dir::new();
    dir.run("solve corner.toml --out out").code(0);
    dir
}

/// Runs what must be refused as wrong input with some words, and must not change anything.
#[track_caller]
fn refused(dir: &Dir, line: &str, words: &str) {
    let before = dir.snapshot("");
    dir.run(line).code(2).says(words);
    let after = dir.snapshot("");
    let names: Vec<_> = after.keys().filter(|name| before.get(*name) != after.get(*name)).collect();
    assert!(before == after, "{line}: changed, or lost something: {names:?}");
}

#[test]
fn an_older_plan_survives_a_solve_that_is_refused() {
    let dir = plan();
    dir.add_homotopy("unknown.toml", "", "no_such_option = 1");
    dir.add_homotopy("mistyped.toml", "", "max_iter = \"many\"");
    for (line, words) in [
        ("solve corner.toml --homotopy unknown.toml --out out", "no_such_option"),
        ("solve corner.toml --homotopy mistyped.toml --out out", "max_iter"),
        ("solve corner.toml --homotopy gone.toml --out out", "gone.toml"),
        ("solve corner.toml --iterations 3 --out out", "--iterations"),
        ("solve corner.toml --start 9 --out out", "there is no start `9`"),
        ("solve corner.toml --delta -1 --out out", "offset magnitude"),
        ("solve corner.toml --robust --target-rate 2 --out out", "--target-rate"),
        ("solve corner.toml --robust --friction 0,0 --out out", "friction = 0: is given twice"),
        ("solve gone.toml --out out", "gone.toml"),
    ] {
        refused(&dir, line, words);
    }
    if !dir.run("solve corner.toml --linear-solver ma27 --out hsl").has("written to") {
        refused(&dir, "solve corner.toml --linear-solver ma27 --out out", "ma27");
    }
}

#[test]
fn an_older_plan_survives_interrupts_and_kills_at_any_moment() {
    let dir = plan();
    let older = dir.snapshot("out");
    for (milliseconds, signal) in [(5, "KILL"), (40, "INT"), (80, "KILL"), (120, "INT"), (200, "KILL"), (300, "INT")] {
        let mut running = dir.program("solve corner.toml --delta 0.015 --out out").spawn();
        thread::sleep(Duration::from_millis(milliseconds));
        if running.has_ended() {
            break;
        }
        running.signal(signal);
        let code = running.finish().code;
        if code == Some(0) {
            break;
        }
        if dir.snapshot("out") != older {
            // A fast machine was just moving the newer plan in. It is whole, or the next run makes it so.
            drop(PlanFolder::claim(&dir.path("out"), &[]).unwrap());
            let plan = StoredPlan::open(&dir.path("out")).unwrap();
            assert_eq!(plan.result.delta_m, 0.015, "{signal} after {milliseconds} ms");
            break;
        }
    }
    dir.run("solve corner.toml --delta 0.015 --out out").code(0);
    assert_eq!(dir.result("out")["delta_m"], 0.015);
    assert!(!dir.exists(".out.unfinished"));
}

#[test]
fn a_plan_that_a_killed_run_was_moving_in_is_moved_in_by_the_next_one() {
    let dir = Dir::new();
    dir.add_homotopy("short.toml", "iterations = 2\nfurther_iterations = 0", "tol = 1e-2");
    dir.run("solve corner.toml --out older").code(0);
    dir.run("solve corner.toml --homotopy short.toml --out newer").code(0);
    let files: Vec<String> = dir.result("newer")["files"].as_object().unwrap().keys().cloned().collect();
    let newer = |dir: &Dir| {
        let relative =
            |name: &std::path::PathBuf, folder: &str| name.strip_prefix(dir.path(folder)).unwrap().to_owned();
        let of = |folder: &str| -> Vec<_> {
            dir.snapshot(folder).into_iter().map(|(name, content)| (relative(&name, folder), content)).collect()
        };
        assert!(of("out") == of("newer"));
        assert!(!dir.exists(".out.unfinished"));
    };
    // Killed before anything was moved, after the older result was taken out, after some files, after all but the result.
    for moved in [None, Some(0), Some(3), Some(files.len())] {
        dir.copy("older", "out");
        dir.copy("newer", ".out.unfinished/whole");
        dir.write(".out.unfinished/lock", "");
        if let Some(count) = moved {
            dir.rename("out/result.json", ".out.unfinished/replaced.json");
            for name in &files[..count] {
                dir.rename(&format!(".out.unfinished/whole/{name}"), &format!("out/{name}"));
            }
        }
        drop(PlanFolder::claim(&dir.path("out"), &[]).unwrap());
        newer(&dir);
        dir.remove("out");
    }
    // Killed when only the working folder was left.
    dir.copy("newer", "out");
    dir.copy("older/stages", ".out.unfinished/whole/stages");
    dir.copy("older/result.json", ".out.unfinished/replaced.json");
    dir.write(".out.unfinished/lock", "");
    drop(PlanFolder::claim(&dir.path("out"), &[]).unwrap());
    dir.run("solve corner.toml --homotopy short.toml --out out").code(0);
    let stages = |folder: &str| dir.snapshot(&format!("{folder}/stages")).len();
    assert_eq!(stages("out"), stages("newer"));
    assert!(!dir.exists(".out.unfinished"));
}

#[test]
fn an_older_plan_survives_a_full_disk() {
    let dir = plan();
    let older = dir.snapshot("out");
    // Files end after 4 KiB; the signal that comes with it is not what ends the program.
    for setup in ["ulimit -f 8", "trap '' XFSZ; ulimit -f 8"] {
        let run = TestCommand::in_shell(dir.folder(), setup, "solve corner.toml --delta 0.015 --out out").run();
        run.code(3).says("cannot be written");
        assert_eq!(dir.snapshot("out"), older, "{setup}");
    }
    dir.run("solve corner.toml --delta 0.015 --out out --resume").code(0);
}

#[test]
fn a_folder_that_cannot_be_made_is_said_before_anything_is_solved() {
    let dir = Dir::new();
    let before = dir.snapshot("");
    dir.run("solve corner.toml --out /proc/out")
        .code(3)
        .says("/proc/out: cannot be written")
        .keeps_silent_about("homotopy step");
    refused(&dir, "solve corner.toml --out corner.toml/out", "corner.toml/out: corner.toml is a file; name another");
    assert!(dir.snapshot("") == before);
}

#[test]
fn what_no_earlier_run_has_written_is_never_replaced() {
    for (file, content) in [
        ("stages/notes.txt", "mine"),
        ("stages/1/notes.txt", "mine"),
        ("stages/12/reference.csv", "mine"),
        ("stages", "mine"),
        ("result.json", "{\"status\": \"mine\"}"),
        ("result.json", "mine"),
        ("result.json", ""),
        ("reference.csv", "mine"),
        ("resolved.toml", "mine"),
    ] {
        let dir = Dir::new();
        dir.write(format!("out/{file}"), content);
        refused(&dir, "solve corner.toml --out out", "choose another --out");
        refused(&dir, "solve corner.toml --out out --resume", "choose another --out");
        refused(&dir, "solve corner.toml --out out --robust", "choose another --out");
    }
    let dir = Dir::new();
    dir.write("out/notes.txt", "mine");
    dir.write("out/log.txt", "mine");
    dir.run("solve corner.toml --out out").code(0);
    assert_eq!((dir.read("out/notes.txt"), dir.read("out/log.txt")), ("mine".into(), "mine".into()));
}

#[test]
fn a_plan_that_was_changed_since_is_never_replaced() {
    let dir = plan();
    for file in ["reference.csv", "resolved.toml", "stages/2/contacts.csv"] {
        let file = format!("out/{file}");
        let whole = dir.read(&file);
        dir.write(&file, format!("{whole}# mine\n"));
        refused(&dir, "solve corner.toml --out out", "was changed since the plan was written; choose another --out");
        dir.write(&file, whole);
    }
    dir.write("out/stages/1/notes.txt", "mine");
    refused(&dir, "solve corner.toml --out out", "out/stages/1/notes.txt: was not written by an earlier run");
    dir.remove("out/stages/1/notes.txt");
    // What was deleted is no loss.
    dir.remove("out/stages/2");
    dir.run("solve corner.toml --out out").code(0);
    assert!(dir.exists("out/stages/2/reference.csv"));
}

#[test]
fn inputs_are_never_replaced() {
    let dir = plan();
    refused(&dir, "solve out/resolved.toml --out out", "is an input of this run, which would replace it");
    refused(&dir, "solve ./out/../out/resolved.toml --out ./out/", "is an input of this run, which would replace it");
    dir.copy("homotopy.toml", "other/stages/1/reference.csv");
    refused(&dir, "solve corner.toml --homotopy other/stages/1/reference.csv --out other", "choose another --out");
    refused(&dir, "solve corner.toml --out corner.toml", "corner.toml: is a file; name a folder");
    refused(&dir, "solve corner.toml --out /", "cannot be the folder to write");
    dir.copy("corner.toml", "inside/resolved.toml");
    dir.copy("homotopy.toml", "inside/homotopy.toml");
    let inside = TestCommand::new(&dir.path("inside"), "solve resolved.toml --out .");
    inside.run().code(2).says("choose another --out");

    // A folder with other files may get a plan.
    let before = dir.snapshot("");
    dir.run("solve corner.toml --out .").code(0);
    let after = dir.snapshot("");
    assert!(before.iter().all(|(name, content)| after.get(name) == Some(content)));
    assert_eq!(dir.result(".")["outcome"], "planned");
}

#[test]
fn two_solves_into_one_folder_do_not_mix() {
    let dir = Dir::new();
    dir.add_scene("peg2");
    dir.run("solve corner.toml --out alone").code(0);
    let mut first = dir.program("solve peg2.toml --out out --verbose").spawn();
    // The head of the solver's table: it has the lock, and can be interrupted.
    first.read_until("inf_pr");
    for flags in ["", "--resume"] {
        dir.run(&format!("solve corner.toml --out out {flags}"))
            .code(2)
            .says("out: another run is writing into it; choose another --out, or wait");
    }
    first.signal("INT");
    first.finish().code(130);
    // Neither disturbs another one that is begun at once.
    let others = [0, 1, 2].map(|_| dir.program("solve corner.toml --out out").spawn());
    let codes = others.map(|running| running.finish().code.unwrap());
    assert!(codes.contains(&0) && codes.iter().all(|code| [0, 2].contains(code)), "{codes:?}");
    assert!(dir.bytes("out/reference.csv") == dir.bytes("alone/reference.csv"));
    dir.run("simulate corner.toml out").code(0);
}

#[test]
fn unfinished_work_that_is_not_ours_is_left_alone() {
    let dir = Dir::new();
    dir.write(".out.unfinished/notes.txt", "mine");
    refused(&dir, "solve corner.toml --out out", "is where unfinished work is kept; move it away");
    refused(&dir, "solve corner.toml --out out --resume", "is where unfinished work is kept; move it away");
}

#[test]
fn a_trace_replaces_nothing() {
    let dir = plan();
    dir.write("notes.txt", "mine");
    std::os::unix::fs::symlink("gone", dir.path("link")).unwrap();
    for trace in ["corner.toml", "out/reference.csv", "out/result.json", "notes.txt", "out", "link", "/dev/null"] {
        refused(&dir, &format!("simulate corner.toml out --trace {trace}"), "exists, and a trace replaces nothing");
    }
    for trace in ["out/rollouts.csv", "./out/success.csv"] {
        refused(&dir, &format!("simulate corner.toml out --trace {trace}"), "--trace");
    }
    dir.run("simulate corner.toml out --out tables --trace traces/new.csv").code(0);
    assert!(dir.table("traces/new.csv").header.starts_with("time_s,px_m"));
    refused(&dir, "simulate corner.toml out --trace traces/new.csv", "exists, and a trace replaces nothing");
}

#[test]
fn tables_of_a_simulation_replace_only_their_like() {
    let dir = plan();
    for file in ["rollouts.csv", "success.csv"] {
        for content in ["mine\n", "", "a,b\n1,2\n"] {
            dir.write(format!("tables/{file}"), content);
            refused(&dir, "simulate corner.toml out --out tables", "choose another --out");
        }
        dir.remove("tables");
    }
    refused(&dir, "simulate corner.toml out --out corner.toml", "corner.toml: is a file; name a folder");
    for _ in 0..2 {
        dir.run("simulate corner.toml out --out tables").code(0);
    }
}
