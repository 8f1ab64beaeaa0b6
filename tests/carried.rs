//! The arm and the gripper: where they meet the environment, the user is told.

use crate::support::{Dir, project};

/// A part of the gripper: a box with its middle at a height (m) above the frame of the tip.
fn jaw(height: f64) -> String {
    format!("\n[gripper]\n[[gripper.part]]\nname = \"jaw\"\nbox = [0.16, 0.02, 0.02]\nposition = [0, 0, {height}]\n")
}

/// The arm of the tests with a collision shape for its tool, in its file.
fn arm(dir: &Dir, collision: &str) -> String {
    let arms = project("examples/arms");
    let urdf = std::fs::read_to_string(arms.join("six.urdf")).unwrap();
    let (before, tool) = urdf.split_once("<link name=\"tool\">").unwrap();
    dir.write("arm.urdf", format!("{before}<link name=\"tool\"><collision>{collision}</collision>{tool}"));
    std::fs::read_to_string(arms.join("six.toml")).unwrap().replace("six.urdf", "arm.urdf")
}

/// The corner without what an arm has of its own.
fn corner(dir: &Dir) -> String {
    let own = ["mass", "inertia", "translational_stiffness", "rotational_stiffness"];
    let lines = dir.read("corner.toml").lines().map(str::to_owned).collect::<Vec<String>>();
    lines.into_iter().filter(|line| !own.iter().any(|key| line.starts_with(key))).collect::<Vec<String>>().join("\n")
}

#[test]
fn a_gripper_that_meets_a_wall_is_told_before_and_after_solving() {
    let dir = Dir::new();
    // The box is 0.1 m long and 1 mm away from the wall at the goal, the jaw 0.16 m long.
    dir.write("wide.toml", dir.read("corner.toml") + &jaw(0.1));
    let words = "part `jaw` of the gripper penetrates `wall` by 20.0 mm";
    dir.run("check wide.toml").code(0).says(words);
    dir.run("check wide.toml --strict").code(1).says(words);
    dir.run("solve wide.toml --out wide").code(0).says(words).says("part `jaw` of the gripper penetrates `wall` by");
    let warnings = dir.result("wide")["warnings"].to_string();
    assert!(
        warnings.contains("part `jaw` of the gripper penetrates `wall`") && warnings.contains("of scenario"),
        "{warnings}"
    );
    // The file that repeats a run has the gripper, too.
    dir.run("check wide/resolved.toml").code(0).says(words);
    dir.write("high.toml", dir.read("corner.toml") + &jaw(0.5));
    dir.run("check high.toml").code(0).keeps_silent_about("gripper");
    dir.run("solve high.toml --out high").code(0).keeps_silent_about("gripper");
}

#[test]
fn a_link_that_meets_the_floor_is_told() {
    let dir = Dir::new();
    let shape = |edge: f64| format!("<geometry><box size=\"0.02 0.02 {edge}\"/></geometry>");
    dir.write("long.toml", corner(&dir) + "\n" + &arm(&dir, &shape(0.4)));
    dir.run("check long.toml").code(0).says("link `tool` of the arm penetrates `floor` by");
    dir.write("short.toml", corner(&dir) + "\n" + &arm(&dir, &shape(0.02)));
    dir.run("check short.toml").code(0).keeps_silent_about("link `tool`");
    let lost = "<geometry><mesh filename=\"lost.stl\"/></geometry>";
    dir.write("lost.toml", corner(&dir) + "\n" + &arm(&dir, lost));
    let run = dir.run("check lost.toml").code(0).says("link `tool`").says("lost.stl");
    run.says("whether it meets the environment is not checked");
}

#[test]
fn a_gripper_without_parts_is_refused() {
    let dir = Dir::new();
    dir.write("empty.toml", dir.read("corner.toml") + "\n[gripper]\n");
    dir.run("check empty.toml").code(2).says("[gripper] has no part: add a [[gripper.part]]");
}
