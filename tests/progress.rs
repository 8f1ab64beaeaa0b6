//! What is said on the way of long work, and what a log keeps of it.

use serde_json::Value;

use crate::support::Dir;

/// The events of a log, each with its line.
fn events(dir: &Dir, log: &str) -> Vec<(String, Value)> {
    let parse = |line: &str| {
        let value: Value = serde_json::from_str(line).unwrap();
        assert!(value["elapsed_s"].as_f64().unwrap() >= 0.0);
        (value["event"].as_str().unwrap().to_owned(), value)
    };
    dir.read(log).lines().map(parse).collect()
}

fn count(events: &[(String, Value)], name: &str) -> usize {
    events.iter().filter(|(event, _)| event == name).count()
}

#[test]
fn a_log_has_every_event_and_grows() {
    let dir = Dir::new();
    dir.write("parameters.toml", "[training]\nsimple = false\n");
    dir.run("solve corner.toml --robust --robust-parameters parameters.toml --out plan --log log.jsonl").code(0);
    let solved = events(&dir, "log.jsonl");
    let result = dir.json("plan/result.json");
    assert_eq!(count(&solved, "homotopy_step"), result["stages"].as_array().unwrap().len());
    // Iterations are counted from 0, and that is one more.
    let iterations = result["iterations"].as_u64().unwrap() as usize + result["stages"].as_array().unwrap().len();
    assert!(count(&solved, "solver_iteration") >= iterations, "{} of {iterations}", count(&solved, "solver_iteration"));
    assert_eq!(count(&solved, "evaluated"), 1);

    dir.run("simulate corner.toml plan --random 100 --log log.jsonl").code(0);
    let both = events(&dir, "log.jsonl");
    let last = &both.last().unwrap().1;
    assert_eq!((&last["event"], &last["done"], &last["count"]), (&"rollouts".into(), &200.into(), &200.into()));
    assert_eq!(both[..solved.len()], solved);

    dir.run("batch corner.toml --deltas 0,0.01 --out batch --log log.jsonl").code(0);
    assert_eq!(count(&events(&dir, "log.jsonl"), "cell"), 2);
}

#[test]
fn users_choose_how_much_is_said() {
    let dir = Dir::new();
    let usual = dir.run("solve corner.toml --out usual").code(0).stderr;
    assert!(usual.contains("homotopy step 1 of at most"), "{usual}");
    assert!(!usual.contains("inf_pr") && !usual.contains('\x1b'), "{usual}");
    let verbose = dir.run("solve corner.toml --out verbose --verbose").code(0).stderr;
    assert!(verbose.contains("iter        objective   inf_pr   inf_du"), "{verbose}");
    let quiet = dir.run("solve corner.toml --out quiet --quiet").code(0).stderr;
    assert!(!quiet.contains("homotopy step"), "{quiet}");
    dir.run("solve corner.toml --quiet --verbose").code(2).says("cannot be used with");
    dir.run("solve corner.toml --out other --log no/such/log")
        .code(2)
        .says("--log no/such/log: its folder does not exist");
    assert!(!dir.exists("other/result.json"));
}
