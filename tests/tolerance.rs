//! `tolerance` as a user runs it.

use crate::support::{Dir, list, number};

/// A plan of a scene whose body is pushed into a corner.
pub fn planned() -> Dir {
    let dir = Dir::new();
    dir.run("solve corner.toml --out plan").code(0);
    dir
}

const FEW: &str = "--cases 40 --target-rate 0.8 --friction 0,0.1 --position-tolerance 0.006";

#[test]
fn errors_and_a_map_of_a_plan_are_written_and_told() {
    let dir = planned();
    let line = format!(
        "tolerance corner.toml --plan plan --quantity offset,friction --map offset,friction --rows 0,0.3 {FEW}"
    );
    dir.run(&line)
        .code(0)
        .says("corner: largest tolerated errors (80 % of the rollouts succeed")
        .says("  offset up to ")
        .says(", planned for 20.00 mm")
        .says("\noffset by friction:\n  at 0.00: offset up to ")
        .says("written to plan; `assembly-plan report plan` shows it");
    let record = dir.json("plan/tolerance.json");
    assert_eq!(list(&record, "boundaries").len(), 2);
    for boundary in list(&record, "boundaries") {
        let [low, value, high] =
            [&boundary["interval"][0], &boundary["value"], &boundary["interval"][1]].map(serde_json::Value::as_f64);
        assert!(low.is_none_or(|low| low <= value.unwrap()), "{boundary}");
        assert!(high.is_none_or(|high| value.unwrap() <= high), "{boundary}");
        assert!(number(boundary, "successes") >= 0.8 * number(boundary, "rollouts"), "{boundary}");
    }
    assert_eq!(record["map"]["rows"].as_array().unwrap().len(), 2);
    let picture = dir.read("plan/tolerance.svg");
    assert!(
        picture.starts_with("<svg ") && picture.contains("friction") && picture.contains("offset (mm)"),
        "{picture}"
    );
    // The same on one thread, beside the first.
    dir.run(&format!("{line} --jobs 1 --out again")).code(0);
    assert_eq!(dir.json("again/tolerance.json"), record);
    // A picture of an earlier map does not stay beside what has none.
    dir.run(&format!("tolerance corner.toml --plan plan --quantity friction --no-map {FEW} --out again")).code(0);
    assert!(!dir.exists("again/tolerance.svg"));
    dir.run("solve corner.toml --out plan").code(0);
}

#[test]
fn without_a_plan_each_row_is_planned_once() {
    let dir = Dir::new();
    let line = format!(
        "tolerance corner.toml --quantity offset --map offset,friction --rows 0 --time-limit 6 {FEW} --out out"
    );
    dir.run(&line).code(0).says("written to out");
    let plans = ["out/plans/nominal/result.json", "out/plans/friction-0.0000/result.json"];
    let first = plans.map(|plan| dir.bytes(plan));
    dir.run(&line).code(0);
    assert_eq!(plans.map(|plan| dir.bytes(plan)), first, "plans are used again");
    // For another tolerance, plans are others.
    dir.run(&line.replace("0.006", "0.007")).code(0);
    let second = dir.bytes(plans[0]);
    assert_ne!(second, first[0]);
    // For other frictions, the plan is another one; a row of friction has its own.
    dir.run(&line.replace("--friction 0,0.1", "--friction 0.2")).code(0);
    assert_ne!(dir.bytes(plans[0]), second);
    let row = dir.json(plans[1]);
    assert!(list(&row["robust"], "after").iter().all(|group| number(group, "friction") == 0.0), "{row}");
}

#[test]
fn a_reference_that_misses_the_goal_tolerates_nothing() {
    let dir = planned();
    let line = "tolerance corner.toml --plan plan --quantity friction --no-map --cases 40 --position-tolerance 1e-6";
    dir.run(line).code(1).says("friction: not tolerated at any tested value");
    assert!(dir.json("plan/tolerance.json")["boundaries"][0]["value"].is_null());
    assert!(!dir.exists("plan/tolerance.svg"));
}

#[test]
fn wrong_requests_say_what_would_be_right() {
    let dir = planned();
    for (flags, message) in [
        ("--map offset", "--map takes two quantities, such as offset,clearance"),
        ("--map offset,offset", "the two quantities must differ"),
        ("--map offset,size", "[possible values: offset, rotation, hole, friction, clearance, chamfer]"),
        ("--need offset", "must be a name and a value, such as offset=2mm"),
        ("--need clearance=1mm", "`clearance` cannot be required; choose one of offset, rotation, hole, friction"),
        ("--need offset=2deg", "`deg` is no unit of offset"),
        ("--need friction=-1", "must not be negative"),
        ("--need friction=1e6", "must lie between 0 and 10"),
        ("--need rotation=100", "must lie between 0 and 1.57 rad"),
        ("--map offset,friction --rows 0.1,1e6", "--rows: friction = 1000000: must lie between 0 and 10"),
        ("--by chamfer", "--need"),
        ("--need offset=2mm --by friction", "[possible values: clearance, chamfer]"),
        (
            "--need offset=2mm --by chamfer --quantity offset --no-map --cases 20 --target-rate 0.5",
            "chamfer: the hole cannot be given a chamfer",
        ),
        ("--quantity chamfer", "chamfer: the hole cannot be given a chamfer"),
        ("--map offset,chamfer", "chamfer: the hole cannot be given a chamfer"),
        ("--target-rate 1", "rate: must be at least 0.5 and below 1"),
        ("--cases 5", "--cases"),
        ("--fit H7/g6", "--diameter"),
        ("--fit H7/p6 --diameter 0.01 --map offset,clearance", "`H7/p6` is not a fit such as H7/g6"),
        ("--fit H7/g6 --diameter 0.01 --map offset,friction", "--fit needs a map over clearance"),
        ("--start 2", "--start"),
        ("--rows 0.1 --no-map", "--no-map"),
    ] {
        let run = dir.run(&format!("tolerance corner.toml --plan plan {flags}"));
        run.code(2).says(message);
        assert!(!dir.exists("plan/tolerance.json"), "{flags}");
    }
    dir.run("tolerance corner.toml --plan nowhere").code(2).says("nowhere");
    dir.add_scene("peg1");
    dir.run("tolerance peg1.toml --plan plan").code(2).says("the plan");
}
