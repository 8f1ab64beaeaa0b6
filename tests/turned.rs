//! Scenarios whose part is also turned in the gripper.

use crate::support::{Dir, list, number};

/// The corner scene with a turn about another axis in each of its scenarios.
fn folder() -> Dir {
    let dir = Dir::new();
    dir.add_variant("turned.toml", &[("[robustness]", ROTATED)]);
    dir
}

const ROTATED: &str = "[robustness]\nrotation_error = 0.04\nrotation_axes = [[0, 1, 0], [0, 0, -1]]";

/// Turns (rad) of the scenarios of a plan.
fn turns(dir: &Dir, folder: &str) -> Vec<Vec<f64>> {
    let scenarios = dir.result(folder);
    let rotation = |scenario| list(scenario, "turn_rad").iter().map(|component| component.as_f64().unwrap()).collect();
    list(&scenarios, "scenarios").iter().map(rotation).collect()
}

#[test]
fn turned_scenarios_reach_the_goal() {
    let dir = folder();
    dir.run("solve turned.toml --out out").code(0).says("and rotation error 0.000 0.040 0.000 rad");
    let result = dir.result("out");
    assert_eq!(turns(&dir, "out"), [[0.0, 0.04, 0.0], [0.0, 0.0, -0.04]]);
    assert_eq!(number(&result, "turn_rad"), 0.04);
    for scenario in list(&result, "scenarios") {
        assert!(number(scenario, "orientation_error_rad") < 0.02, "contact has turned it back: {scenario}");
    }
    // The first scenario begins rotated by 0.04 rad about y, against the rotation of the believed part.
    let begin = |folder: &str| -> Vec<f64> {
        let row = &dir.table(format!("{folder}/scenarios.csv")).rows[0];
        row[5..9].iter().map(|component| component.parse().unwrap()).collect()
    };
    dir.run("solve corner.toml --out straight").code(0);
    let [straight, turned] =
        [begin("straight"), begin("out")].map(|quaternion| 2.0 * quaternion[2].atan2(quaternion[0]));
    assert!((straight - turned - 0.04).abs() < 1e-9, "{straight} {turned}");
}

#[test]
fn a_plan_with_rotated_scenarios_is_written_so_that_it_can_be_repeated_and_played() {
    let dir = folder();
    dir.run("solve turned.toml --out out").code(0);
    dir.run("solve out/resolved.toml --out again").code(0);
    let of = |folder: &str, file: &str| dir.bytes(format!("{folder}/{file}"));
    for file in ["reference.csv", "scenarios.csv", "wrench.csv", "resolved.toml"] {
        assert!(of("out", file) == of("again", file), "{file}");
    }
    for folder in ["out", "again"] {
        dir.run(&format!("simulate turned.toml {folder}")).code(0).keeps_silent_about("other settings");
    }
    let rows = dir.table("out/rollouts.csv").rows;
    let turns: Vec<&[String]> = rows.iter().filter(|row| row[3] == "plan").map(|row| &row[14..]).collect();
    assert_eq!(turns, [["0", "0.04", "0"], ["0", "0", "-0.04"]], "the planned ones are played");
    dir.run("simulate corner.toml out").code(0).says("other settings");
}

#[test]
fn rotation_errors_that_no_scenario_has_do_not_make_it_another_problem() {
    let dir = folder();
    dir.add_variant("rotation.toml", &[("[robustness]", "[robustness]\nrotation_error = 0.04")]);
    let problem = |scene: &str| {
        dir.run(&format!("solve {scene}.toml --out {scene}"));
        dir.result(scene)["made_from"]["problem"].clone()
    };
    let [corner, rotation, turned] = ["corner", "rotation", "turned"].map(problem);
    assert_eq!(corner, rotation);
    assert_ne!(corner, turned);
}

#[test]
fn the_flag_rotates_scenarios_and_evaluations_alike() {
    let dir = folder();
    dir.run("solve turned.toml --robust --friction 0 --rotation-error 0.02 --stall-limit 0 --out out");
    assert_eq!(turns(&dir, "out"), [[0.0, 0.02, 0.0], [0.0, 0.0, -0.02]]);
    let rounds = dir.result("out")["robust"]["rounds"].clone();
    assert_eq!(rounds[0]["scenarios"][0]["turn_rad"][1], 0.02);
    dir.run("simulate turned.toml out").code(0).keeps_silent_about("other settings");
}
