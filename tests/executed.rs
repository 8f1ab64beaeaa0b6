//! What robots did, beside rollouts: `simulate --executed` and `report --executed`.

use serde_json::{Value, json};

use crate::report::data;
use crate::support::{Dir, list, number};

/// Columns of a log behind those of the state.
const MEASURED: &str = ",fx_n,fy_n,fz_n,tx_nm,ty_nm,tz_nm,phase";
/// At its end, the part is believed 8 mm beside the goal along x, as a part with this offset is at the goal.
const END: &str = "1.0,0.059,0,0.031,1,0,0,0,0,0,0,0,0,0";

/// A plan of the corner in `out`, and logs of a robot that follows the reference exactly: the part is where it is believed, and
/// the corner is not in its way.
fn workshop() -> Dir {
    let dir = Dir::new();
    dir.run("solve corner.toml --out out").code(0);
    dir.write("executed.csv", log(&dir, &header(&dir), 1.0, &[END]));
    dir
}

/// What the first line of a log says.
fn header(dir: &Dir) -> Value {
    let identity = dir.result("out")["made_from"]["problem"].clone();
    json!({"format": 1, "scene": "corner", "problem": identity, "dry_run_m": 0.0})
}

/// A log with a share of the rows of the plan, and rows of its rest.
fn log(dir: &Dir, header: &Value, share: f64, rest: &[&str]) -> String {
    let reference = dir.read("out/reference.csv");
    let mut lines = reference.lines();
    let mut log = format!("# {header}\n{}{MEASURED}\n", lines.next().unwrap());
    let rows: Vec<&str> = lines.collect();
    let played = &rows[..(share * rows.len() as f64) as usize];
    for (phase, rows) in [("going to the start", &rows[..1]), ("playing", played), ("resting", rest)] {
        log.extend(rows.iter().map(|row| format!("{row},1,2,3,0.1,0.2,0.3,{phase}\n")));
    }
    log
}

#[test]
fn what_a_robot_did_is_compared_with_a_rollout() {
    let dir = workshop();
    let compare = "simulate corner.toml out --executed";
    dir.run(&format!("{compare} executed.csv")).code(0).says("offset 8.0 0.0 0.0 mm").says("on average");
    let text = dir.read("executed.csv");
    dir.write("missed.csv", text.replace("0.059", "0.159"));
    dir.run(&format!("{compare} missed.csv")).code(1).says("larger than planned for").says("is closest");
    // Where the goal is, but tilted by 0.3 rad.
    dir.write("tilted.csv", text.replace("0.031,1,0,0,0,", "0.031,0.98877,0,0,0.14944,"));
    dir.run(&format!("{compare} tilted.csv")).code(1).says("larger than planned for").says("is closest");
    dir.write("stopped.csv", log(&dir, &header(&dir), 0.5, &[]));
    dir.run(&format!("{compare} stopped.csv")).code(1).says("was stopped").says("gives no reason").says("is closest");
    dir.run(&format!("{compare} executed.csv --friction 0,0.1")).code(2).says("one friction");
    // Other tools write no line above the columns.
    dir.write("bare.csv", text.split_once('\n').unwrap().1);
    dir.run(&format!("{compare} bare.csv")).code(0).says("offset 8.0 0.0 0.0 mm");
}

#[test]
fn what_a_robot_did_is_shown_beside_a_rollout() {
    let dir = workshop();
    let mut stopped = header(&dir);
    stopped["stopped"] = json!("force of 41 N <b>");
    dir.write("stopped.csv", log(&dir, &stopped, 0.5, &[]));
    dir.run("report out --executed executed.csv --executed stopped.csv").code(0);
    let page = data(&dir, "out/report.html");
    let motions = list(&page, "motions");
    let [.., executed, stopped] = motions else { panic!("{} motions", motions.len()) };
    for motion in [executed, stopped] {
        assert_eq!((motion["source"].as_str(), list(motion, "scenarios").len()), (Some("executed"), 2));
    }
    let poses = |motion: &Value, scenario: usize| list(&list(motion, "scenarios")[scenario], "poses").len() / 7;

    // With the grasp error of its end, the part of the robot ends at the goal; the rollout rests as long.
    let robot = &list(executed, "scenarios")[0];
    assert!(
        (number(robot, "offset.0") - 0.008).abs() < 1e-5 && number(robot, "errors.0") < 1e-5,
        "{}",
        robot["errors"]
    );
    assert_eq!(robot["success"], true);
    assert_eq!(poses(executed, 0), poses(executed, 1));
    assert_eq!(list(executed, "reference").len() / 7, poses(executed, 0));
    assert_eq!(list(&executed["execution"], "distances").len(), poses(executed, 0));
    assert_eq!(list(robot, "measured").len(), 6 * (poses(executed, 0) - 1));
    assert!(list(robot, "forces").is_empty(), "no log has the places of contacts");

    // A robot that was stopped is shown until then, with the reason.
    let sentences = stopped["execution"]["sentences"].to_string();
    assert!(sentences.contains("force of 41 N <b>") && sentences.contains("is closest"), "{sentences}");
    assert!(poses(stopped, 0) < poses(stopped, 1));
    assert!(number(stopped, "execution.stopped") > 0.0);
    assert_eq!(list(stopped, "scenarios")[0]["success"], false);
}

#[test]
fn logs_that_are_not_of_the_plan_are_refused() {
    let dir = workshop();
    let text = dir.read("executed.csv");
    let with = |key: &str, value: Value| {
        let mut header = header(&dir);
        header[key] = value;
        log(&dir, &header, 1.0, &[END])
    };
    let line = |number: usize| text.lines().nth(number - 1).unwrap();
    for (log, words) in [
        (with("problem", json!("other")), "name the folder of the plan that was exported"),
        (with("dry_run_m", json!(0.1)), "a dry run, 100 mm from the goal"),
        (with("format", json!(2)), "format 2, this program reads 1"),
        (text.replacen("{\"", "{", 1), "executed.csv:1: column"),
        (text.replace(",playing", ",approaching"), "no row has the phase `playing`"),
        (text.replace(line(5), &line(5).replacen("0.", "zero.", 1)), "executed.csv:5: column"),
        (
            text.replace(&format!("{}\n", line(6)), &format!("{}\n", line(4))),
            "executed.csv:6: column time_s: times must",
        ),
        (text.replace("0.031,1,0,0,0", "0.031,0.5,0,0,0"), "qw, qx, qy, qz are not a unit quaternion"),
        (text.replace(END, &END.replacen("1.0", "1e5", 1)), "the log lasts 100002 s"),
        (text.replace(",phase\n", ",state\n"), "there is no column `phase`"),
        (String::new(), "executed.csv"),
    ] {
        dir.write("executed.csv", log);
        for command in ["report out", "simulate corner.toml out"] {
            dir.run(&format!("{command} --executed executed.csv")).code(2).says(words);
        }
    }
    assert!(!dir.exists("out/report.html"));
    dir.run("report out --executed gone.csv").code(2).says("gone.csv");
    dir.run("simulate corner.toml out --random 2 --out rates").code(0);
    dir.run("report rates --executed executed.csv").code(2).says("is not the folder of a plan");
}
