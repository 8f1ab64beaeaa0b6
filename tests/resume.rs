//! An interrupted or killed solve resumes where it stopped.

#![cfg(unix)]

use serde_json::{Value, json};

use crate::support::{Dir, Run, Running, list, sealed};

/// The folder of unfinished work beside `out`.
const UNFINISHED: &str = ".out.unfinished";

/// A folder with the corner scene, with enough steps that each of its homotopy steps takes a moment.
fn folder() -> Dir {
    let dir = Dir::new();
    dir.add_variant("slow.toml", &[("steps = 20\ntime_step = 0.08", "steps = 30\ntime_step = 0.053")]);
    dir
}

/// Begins a solve and sends it a signal when the first homotopy step is finished.
fn stop(dir: &Dir, line: &str, signal: &str) -> Run {
    let mut running = dir.program(line).spawn();
    running.wait_until("a checkpoint", || dir.exists(format!("{UNFINISHED}/checkpoint.json")));
    running.signal(signal);
    running.finish()
}

fn iterations(dir: &Dir, folder: &str) -> Vec<u64> {
    list(&dir.result(folder), "stages").iter().map(|stage| stage["iterations"].as_u64().unwrap()).collect()
}

#[test]
fn a_resumed_plan_is_the_uninterrupted_one() {
    let dir = folder();
    dir.run("solve slow.toml --out whole --resume").code(0).says("whole: there is no unfinished work to resume");
    assert!(!dir.exists(".whole.unfinished"), "a whole plan needs no checkpoint");

    for (signal, code) in [("TERM", Some(130)), ("INT", Some(130)), ("KILL", None)] {
        let run = stop(&dir, "solve slow.toml --out out --resume", signal);
        assert_eq!(run.code, code, "{run:?}");
        assert!(!dir.exists("out"), "{signal}: looks finished");
        assert!(dir.exists(format!("{UNFINISHED}/stages/1/reference.csv")));
        if code.is_some() {
            assert!(run.has("interrupted in homotopy step ") && run.has("the same command resumes it"));
        }

        dir.run("solve slow.toml --out out --resume")
            .code(0)
            .says("resuming after homotopy step ")
            .keeps_silent_about("homotopy step 1 of at most 5 (tau");
        assert!(!dir.exists(UNFINISHED));
        assert_eq!(iterations(&dir, "out"), iterations(&dir, "whole"));
        for file in ["reference.csv", "scenarios.csv", "contacts.csv", "stages/1/reference.csv", "resolved.toml"] {
            let of = |folder: &str| dir.bytes(format!("{folder}/{file}"));
            assert!(of("out") == of("whole"), "{signal}: {file}");
        }
        dir.remove("out");
    }
}

#[test]
fn a_coarse_homotopy_step_is_resumed_on_all_time_steps() {
    let dir = Dir::new();
    dir.add_variant("slow.toml", &[("steps = 20\ntime_step = 0.08", "steps = 80\ntime_step = 0.02")]);
    dir.add_homotopy("homotopy.toml", "iterations = 3\nfurther_iterations = 1\ncoarse_iterations = 1", "tol = 1e-2");
    dir.run("solve slow.toml --out whole").code(0);
    stop(&dir, "solve slow.toml --out out", "TERM");
    dir.run("solve slow.toml --out out --resume").code(0).says("resuming after homotopy step ");
    assert_eq!(iterations(&dir, "out"), iterations(&dir, "whole"));
    for file in ["reference.csv", "scenarios.csv", "contacts.csv", "stages/1/reference.csv"] {
        assert!(dir.bytes(format!("out/{file}")) == dir.bytes(format!("whole/{file}")), "{file}");
    }
}

#[test]
fn a_solve_that_is_interrupted_at_once_leaves_nothing_in_its_folder() {
    let dir = Dir::new();
    dir.add_scene("peg2");
    let mut running = dir.program("solve peg2.toml --out out --verbose").spawn();
    // The head of the solver's table: the first homotopy step has begun.
    running.read_until("inf_pr");
    running.signal("INT");
    running
        .finish()
        .code(130)
        .says("interrupted in homotopy step 1, of which nothing is kept; the same command begins again");
    assert!(!dir.exists("out"));
}

#[test]
fn unfinished_work_is_used_only_when_asked() {
    let dir = folder();
    stop(&dir, "solve slow.toml --out out", "INT").code(130).says("the same command with --resume resumes it");
    dir.copy(UNFINISHED, "kept");
    dir.run("solve slow.toml --out out --resume").code(0).says("resuming after homotopy step");

    dir.copy("kept", UNFINISHED);
    dir.run("solve slow.toml --out out")
        .code(0)
        .keeps_silent_about("resuming")
        .says("homotopy step 1 of at most 5 (tau");
    assert!(!dir.exists(UNFINISHED));
}

#[test]
#[ignore = "slow, a solve for each kind of damage: scripts/test and CI run it"]
fn unfinished_work_of_another_problem_or_with_damage_is_left_with_a_word() {
    let dir = folder();
    stop(&dir, "solve slow.toml --out out", "INT").code(130);
    dir.copy(UNFINISHED, "kept");
    let checkpoint = dir.bytes("kept/checkpoint.json");
    let begins_anew = |flags: &str, reason: &str| {
        dir.run(&format!("solve slow.toml --out out --resume {flags}"))
            .code(0)
            .says(&format!("the unfinished work of an earlier run is not used: {reason}"))
            .keeps_silent_about("resuming")
            .says("homotopy step 1 of at most 5 (tau");
        assert!(!dir.exists(UNFINISHED));
        dir.copy("kept", UNFINISHED);
    };
    begins_anew("--delta 0.01", "it belongs to another problem");
    dir.write(format!("{UNFINISHED}/checkpoint.json"), &checkpoint[..checkpoint.len() / 2]);
    begins_anew("", "its checkpoint is damaged");
    let table = format!("{UNFINISHED}/stages/1/scenarios.csv");
    for (from, to) in [("\n0.053,1,", "\n0.053,1,nan"), ("\n0.053,1,", "\n0.053,1,1"), ("qw", "norm")] {
        dir.write(&table, dir.read(&table).replacen(from, to, 1));
        begins_anew("", "its tables are damaged");
    }
    dir.remove(format!("{UNFINISHED}/stages/1/wrench.csv"));
    begins_anew("", "its tables are damaged");
    // A checkpoint that fits its hash may still be none of this problem.
    let changed = |change: &dyn Fn(&mut Value)| {
        let mut record = dir.json("kept/checkpoint.json")["record"].take();
        change(&mut record);
        dir.write(format!("{UNFINISHED}/checkpoint.json"), sealed(&record.to_string()));
        begins_anew("", "its checkpoint is damaged");
    };
    changed(&|record| drop(record["x"].as_array_mut().unwrap().pop()));
    changed(&|record| record["constraint_multipliers"].as_array_mut().unwrap().push(json!(0.0)));
    changed(&|record| record["iterations"] = json!([]));
    dir.run("solve slow.toml --out out --resume").code(0).says("resuming after homotopy step");
}

/// A refinement that never ends by itself: nothing ends a hundredth of a millimetre from the goal.
/// The time limit is one that no machine reaches.
const HOPELESS: &str =
    "solve corner.toml --robust --time-limit 100000 --friction 0 --position-tolerance 1e-5 --stall-limit 3 --out out";

#[test]
fn a_refinement_goes_on_where_it_stopped() {
    for (signal, code) in [("INT", Some(130)), ("KILL", None)] {
        let dir = Dir::new();
        let mut running: Running = dir.program(HOPELESS).spawn();
        running.wait_until("a refinement", || dir.exists(format!("{UNFINISHED}/refinement.json")));
        running.signal(signal);
        let run = running.finish();
        assert_eq!(run.code, code, "{run:?}");
        assert!(!dir.exists("out"), "an interrupted refinement leaves the folder as it was");
        if code.is_some() {
            assert!(run.has("interrupted while refining, at a success rate of "), "{run:?}");
            assert!(run.has("the same command with --resume resumes it"), "{run:?}");
        }
        let again = format!("{HOPELESS} --resume --max-perturbations 0");
        dir.run(&again)
            .code(1)
            .says("resuming after homotopy step 5 of at most 5 of an earlier run")
            .says("resuming the refinement of an earlier run");
        assert_eq!(dir.result("out")["status"], "the target success rate is not reached");
        assert!(!dir.exists(UNFINISHED));
    }
}

#[test]
fn a_refinement_for_another_target_is_not_used() {
    let dir = Dir::new();
    let mut running = dir.program(HOPELESS).spawn();
    running.wait_until("a refinement", || dir.exists(format!("{UNFINISHED}/refinement.json")));
    running.signal("KILL");
    running.finish();
    dir.copy(UNFINISHED, "kept");
    let end = "--resume --max-perturbations 0";
    for (from, to) in
        [("--friction 0", "--friction 0.2"), ("1e-5", "1e-4"), ("--robust", "--robust --rotation-error 0.01")]
    {
        dir.run(&format!("{} {end}", HOPELESS.replace(from, to)))
            .says("resuming after homotopy step 5 of at most 5 of an earlier run")
            .says("not used: it was refined for other requirements")
            .keeps_silent_about("resuming the refinement");
        dir.copy("kept", UNFINISHED);
    }
    let file = format!("{UNFINISHED}/refinement.json");
    let changed = dir.read(&file).replacen("\"time_step_s\":0.08", "\"time_step_s\":1e-7", 1);
    dir.write(&file, changed);
    dir.run(&format!("{HOPELESS} {end}")).code(1).says("not used: its refinement is damaged");
    dir.copy("kept", UNFINISHED);
    let whole = dir.bytes(&file);
    dir.write(&file, &whole[..whole.len() / 2]);
    dir.run(&format!("{HOPELESS} {end}")).code(1).says("not used: its refinement is damaged");
}

#[test]
fn a_refined_variant_goes_on_with_its_own_tables() {
    let dir = Dir::new();
    let line = "solve corner.toml --delta 0.03 --robust --time-limit 100000 --friction 0.5 --target-rate 1 --stall-limit 1 --position-tolerance 8e-4 --out out";
    let mut running = dir.program(line).spawn();
    // The file is written after the tables of a variant.
    let file = format!("{UNFINISHED}/refinement.json");
    let is_variant = || dir.exists(&file) && dir.json(&file)["record"]["best"]["origin"].get("Variant").is_some();
    running.wait_until("a variant is the best plan", is_variant);
    running.signal("KILL");
    running.finish();
    dir.copy(UNFINISHED, "kept");
    let best = dir.json(&file)["record"]["best"].clone();
    let again = format!("{line} --resume --max-perturbations 0");
    dir.run(&again).code(1).says("resuming the refinement of an earlier run");
    let result = dir.result("out");
    assert_eq!(result["time_step_s"], best["time_step_s"]);
    assert_eq!(list(&result, "stages").len(), list(&best, "iterations").len());
    assert_eq!(result["converged"], true);

    dir.copy("kept", UNFINISHED);
    dir.remove(format!("{UNFINISHED}/refined/{}/1/contacts.csv", best["round"]));
    dir.run(&again).code(1).says("not used: the tables of its refinement are damaged");
}

#[test]
fn a_plan_that_is_not_there_yet_is_resumed_first() {
    let dir = Dir::new();
    dir.make_folder(".out.unfinished");
    dir.run("export out --to csv").code(2).says("out: has no plan yet, a run on it has not ended").says("--resume");
}
