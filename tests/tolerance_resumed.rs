//! An interrupted or killed `tolerance` resumes where it stopped.

#![cfg(unix)]

use crate::support::{Dir, Run};
use crate::tolerance::planned;

/// The folder of unfinished work beside `out`.
const UNFINISHED: &str = ".out.unfinished";
/// A run with many boundaries, of which the first ones end soon.
const LONG: &str = "tolerance corner.toml --plan plan --quantity friction,offset,rotation --map offset,friction --rows 0,0.2 \
                    --cases 100 --target-rate 0.8 --friction 0,0.1 --position-tolerance 0.006 --out out";

/// Begins the long run and sends it a signal when a boundary is finished.
fn stop(dir: &Dir, signal: &str) -> Run {
    let mut running = dir.program(LONG).spawn();
    running.wait_until("a finished boundary", || dir.exists(format!("{UNFINISHED}/tolerance.json")));
    running.signal(signal);
    running.finish()
}

#[test]
fn an_interrupted_run_goes_on_where_it_was() {
    let dir = planned();
    dir.run(&LONG.replace("--out out", "--out whole --resume")).code(0).keeps_silent_about("resuming");
    assert!(!dir.exists(".whole.unfinished"), "what is whole needs no unfinished work");
    for (signal, code) in [("INT", Some(130)), ("TERM", Some(130)), ("KILL", None)] {
        let run = stop(&dir, signal);
        assert_eq!(run.code, code, "{run:?}");
        assert!(!dir.exists("out/tolerance.json"), "{signal}: looks finished");
        if code.is_some() {
            assert!(run.has(
                "interrupted; finished boundaries and plans are kept, and the same command with --resume resumes it"
            ));
        }
        dir.run(&format!("{LONG} --resume --jobs 1")).code(0).says("resuming after ").says(" of an earlier run");
        assert!(!dir.exists(UNFINISHED));
        for file in ["tolerance.json", "tolerance.svg"] {
            assert!(dir.bytes(format!("out/{file}")) == dir.bytes(format!("whole/{file}")), "{signal}: {file}");
        }
        dir.remove("out");
    }
}

#[test]
fn unfinished_work_of_something_else_is_refused_and_stays() {
    let dir = planned();
    stop(&dir, "KILL");
    let kept = dir.bytes(format!("{UNFINISHED}/tolerance.json"));
    let refused = |line: &str, problem: &str| {
        dir.run(&format!("{line} --resume"))
            .code(2)
            .says("tolerance.json: cannot be resumed: ")
            .says(problem)
            .says("repeat the command that was interrupted, or leave out --resume to measure from the beginning");
        assert!(!dir.exists("out/tolerance.json"), "{problem}");
    };
    for (from, to, problem) in [
        ("--cases 100", "--cases 101", "it has another --cases"),
        ("--rows 0,0.2", "--rows 0,0.3", "it has another map"),
        ("0.006", "0.007", "it has another scene, start, offset or tolerance of success"),
    ] {
        refused(&LONG.replace(from, to), problem);
        assert!(dir.bytes(format!("{UNFINISHED}/tolerance.json")) == kept, "{problem}");
    }
    dir.run("solve corner.toml --robust --friction 0 --out robust").code(0);
    refused(&LONG.replace("--plan plan", "--plan robust"), "it has another plan");
    dir.write(format!("{UNFINISHED}/tolerance.json"), &kept[..kept.len() / 2]);
    refused(LONG, "its checkpoint is damaged");
    // Without the flag, it is measured from the beginning.
    dir.run(&LONG.replace("--cases 100", "--cases 40"))
        .code(0)
        .says("unfinished work of an earlier run is discarded; --resume would have continued it");
    assert!(!dir.exists(UNFINISHED));
}

#[test]
fn tasks_of_an_array_measure_what_another_run_answers_with() {
    let dir = planned();
    dir.run(&LONG.replace("--out out", "--out whole")).code(0);
    // Two of the five boundaries.
    for index in [1, 3] {
        let line = format!("{LONG} --index {index}");
        dir.run(&line)
            .code(0)
            .says(&format!("boundary {index}: "))
            .says(&format!("kept in out/boundaries/{index}.json"));
        let kept = dir.bytes(format!("out/boundaries/{index}.json"));
        dir.run(&line).code(0);
        assert!(dir.bytes(format!("out/boundaries/{index}.json")) == kept, "it is there already");
    }
    assert!(!dir.exists("out/tolerance.json"));
    dir.run(&format!("{LONG} --index 5"))
        .code(2)
        .says("index: 5 is too large: 5 boundaries are asked for, counted from 0");
    dir.run(&format!("{LONG} --index 1 --resume")).code(2);
    dir.run(&format!("{} --resume", LONG.replace("--cases 100", "--cases 101")))
        .code(2)
        .says("1.json: cannot be resumed: it has another --cases");
    // What is damaged is measured again.
    dir.write("out/boundaries/3.json", "{");
    dir.run(&format!("{LONG} --index 3")).code(0);
    dir.run(&format!("{LONG} --resume")).code(0).says("resuming after 2 finished boundaries of an earlier run");
    for file in ["tolerance.json", "tolerance.svg"] {
        assert!(dir.bytes(format!("out/{file}")) == dir.bytes(format!("whole/{file}")), "{file}");
    }
    assert!(!dir.exists("out/boundaries"), "nothing is left of what is answered");
    dir.run(&format!("{LONG} --index 0")).code(0);
    dir.run(LONG).code(0).says("unfinished work of an earlier run is discarded");
    assert!(!dir.exists("out/boundaries"));
}
