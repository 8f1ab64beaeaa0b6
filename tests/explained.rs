//! What `check` says of scenes that are solved and of scenes that cannot be, and what `solve` then refuses.

use crate::support::{Dir, Run, list, round};

/// A scene of a round peg, or several, in a round hole of radius 4.1 mm, with the goal at this height (m).
fn add_round_fit(dir: &Dir, pegs: &str, goal: f64) {
    dir.write("peg.obj", pegs);
    dir.write("hole.obj", round::tube(4.1, 12.0, 10.0));
    let part = |parent: &str, name: &str| {
        format!("[[{parent}.part]]\nname = \"{name}\"\nmesh = \"{name}.obj\"\nunit = \"mm\"\n")
    };
    let pose = |table: &str, z: f64| format!("{table}\nposition = [0, 0, {z}]\norientation = [1, 0, 0, 0]\n");
    let start = pose("[[start]]\nname = \"1\"", 0.03);
    let scene = part("body", "peg") + &part("environment", "hole") + &start + &pose("[goal]", goal);
    dir.write("fit.toml", scene + "[robustness]\noffset_magnitude = 0.001\n");
}

/// A scene whose box starts at these heights (m) above a floor, with two offsets of 10 mm, up and down.
fn add_box(dir: &Dir, start: f64) {
    dir.write(
        "box.toml",
        format!(
            "[[body.part]]\nname = \"box\"\nbox = [0.1, 0.08, 0.06]\n\
             [[environment.part]]\nname = \"floor\"\nbox = [0.6, 0.6, 0.1]\nposition = [0, 0, -0.05]\n\
             [[start]]\nname = \"above\"\nposition = [0, 0, {start}]\norientation = [1, 0, 0, 0]\n\
             [goal]\nposition = [0, 0, 0.031]\norientation = [1, 0, 0, 0]\n\
             [robustness]\noffset_magnitude = 0.01\noffset_directions = [[0, 0, 1], [0, 0, -1]]\n"
        ),
    );
}

/// How many lines of standard output begin like this.
fn count(run: &Run, beginning: &str) -> usize {
    run.stdout.lines().filter(|line| line.trim_start().starts_with(beginning)).count()
}

#[test]
fn round_surfaces_that_are_alike_are_one_line() {
    let dir = Dir::new();
    add_round_fit(&dir, &round::cylinders(1.0, 20.0, &[[-2.0, 0.0], [2.0, 0.0]]), 0.001);
    let run = dir.run("check fit.toml").code(0).says("2 times cylinder outside, radius 1.000 to 1.000 mm, 360 degrees");
    assert_eq!((count(&run, "2 times cylinder outside"), count(&run, "cylinder outside")), (1, 1), "{}", run.stdout);
    run.says("cylinder inside, radius 4.100 to 4.100 mm");
}

#[test]
fn flat_sides_of_a_hole_that_take_much_of_a_gap_are_warned_of() {
    let dir = Dir::new();
    add_round_fit(&dir, &round::cylinders(4.0, 20.0, &[[0.0, 0.0]]), 0.001);
    // 4.1 mm (1 - cos(pi / 24)) of a gap of 0.1 mm.
    dir.run("check fit.toml")
        .code(0)
        .says("tightest round fit: hole of radius 4.100 mm, gap 0.1000 mm")
        .says("flat sides that take up to 0.035 mm of a gap of 0.100 mm: export it with smaller chord errors");
    // Beside a gap of 1.1 mm that is nothing.
    add_round_fit(&dir, &round::cylinders(3.0, 20.0, &[[0.0, 0.0]]), 0.001);
    dir.run("check fit.toml").code(0).says("gap 1.1000 mm").keeps_silent_about("flat sides that take");
}

#[test]
fn a_round_fit_that_is_size_on_size_has_no_gap() {
    let dir = Dir::new();
    add_round_fit(&dir, &round::cylinders(1.0, 20.0, &[[0.0, 0.0]]), 0.001);
    dir.write("hole.obj", round::tube(1.0, 6.0, 10.0));
    let run = dir.run("check fit.toml").says("tightest round fit: hole of radius 1.000 mm, no gap");
    run.keeps_silent_about("larger than its hole").keeps_silent_about("%");
}

#[test]
fn a_tight_round_fit_is_read_and_keeps_its_gap() {
    let dir = Dir::new();
    // No number of facets keeps a gap of 0.01 mm, which the meshes have all around.
    add_round_fit(&dir, &round::cylinders(4.09, 20.0, &[[0.0, 0.0]]), 0.001);
    dir.run("check fit.toml").code(0).says("at the goal: meshes 0.0099 mm apart, convex parts 0.009");
}

#[test]
#[ignore = "slow, a mesh without a fit is covered in two ways: scripts/test and CI run it"]
fn a_pose_that_overlaps_is_one_line_whatever_the_number_of_pairs() {
    let dir = Dir::new();
    // A peg that is a little too large penetrates many pieces of the hole.
    add_round_fit(&dir, &round::cylinders(4.17, 20.0, &[[0.0, 0.0]]), 0.001);
    let run = dir.run("check fit.toml").code(1).says("(--json lists them)").says("a round part is 0.070 mm larger");
    assert_eq!(count(&run, "penetration at the goal"), 1, "{}", run.stdout);
    let report: serde_json::Value = serde_json::from_str(&dir.run("check fit.toml --json").code(1).stdout).unwrap();
    let penetrations = list(&report, "penetrations");
    assert!(
        penetrations.len() > 1 && penetrations.iter().all(|penetration| penetration["pose"] == "goal"),
        "{penetrations:?}"
    );
    run.says(&format!("less in {} more", penetrations.len() - 1));
}

#[test]
fn a_body_that_begins_inside_with_every_offset_is_refused() {
    let dir = Dir::new();
    add_box(&dir, 0.015);
    let words = "[[start]] \"above\": the body begins inside of the environment with every offset, 25.000 mm deep with \
                 offset 1 (box/floor); move the start";
    dir.run("check box.toml").code(1).says(words);
    dir.run("solve box.toml --out out").code(2).says(&format!("box.toml: {words}"));
    assert!(!dir.exists("out"));
}

#[test]
#[ignore = "slow, a whole solve: scripts/test and CI run it"]
fn a_body_that_begins_inside_with_some_offset_is_warned_of() {
    let dir = Dir::new();
    add_box(&dir, 0.025);
    let words = "warning: box/floor penetrate by 15.000 mm at the start with offset 1, the deepest of all pairs; move that \
                 start, or lower robustness.offset_magnitude";
    dir.run("check box.toml").code(0).says(words).keeps_silent_about("with every offset");
    let run = dir.run("solve box.toml --out out").says(words);
    assert_ne!(run.code, Some(2));
    let warnings = &dir.result("out")["warnings"];
    assert!(warnings[0].as_str().unwrap().contains("at the start with offset 1"), "{warnings}");
}

#[test]
fn offsets_that_all_lead_inside_are_said_to_be_too_large() {
    let dir = Dir::new();
    add_round_fit(&dir, &round::cylinders(3.8, 20.0, &[[0.0, 0.0]]), 0.001);
    let lowered = dir.read("fit.toml").replace("[0, 0, 0.03]", "[0, 0, 0.005]");
    dir.write("lowered.toml", lowered);
    dir.run("solve lowered.toml --out out")
        .code(2)
        .says("without an offset it is not: lower robustness.offset_magnitude");
}
