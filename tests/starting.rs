//! Scenes that the program writes are solved as they are.

use crate::support::Dir;

/// Solves a scene and expects that the plan reaches the goal.
#[track_caller]
fn solved(dir: &Dir, scene: &str) {
    dir.run(&format!("check {scene}")).code(0).keeps_silent_about("warning");
    dir.run(&format!("solve {scene} --out out")).code(0);
    assert_eq!(dir.result("out")["outcome"], "planned");
}

#[test]
#[ignore = "slow, a whole solve of a peg: scripts/test and CI run it"]
fn the_starter_scene_is_solved_as_it_is() {
    let dir = Dir::new();
    dir.run("new begun/starter.toml").code(0).says("written to begun/starter.toml");
    solved(&dir, "begun/starter.toml");
}

#[test]
fn a_file_is_replaced_only_by_force() {
    let dir = Dir::new();
    for command in ["new scene.toml", "generate rectangular --out scene.toml"] {
        dir.write("scene.toml", "my work");
        dir.run(command).code(2).says("already exists");
        assert_eq!(dir.read("scene.toml"), "my work");
        dir.run(&format!("{command} --force")).code(0);
        dir.run("check scene.toml").code(0);
    }
}

#[test]
fn a_scene_of_two_meshes_is_read_as_it_was_written() {
    let dir = Dir::new();
    let corners = "0 0 0,0 30 0,30 0 0;0 0 0,30 0 0,0 0 30;0 0 0,0 0 30,0 30 0;30 0 0,0 30 0,0 0 30";
    let tetrahedron = |height: f64| {
        let facet = |facet: &str| {
            let vertex = |vertex: &str| {
                let [x, y, z]: [f64; 3] =
                    std::array::from_fn(|axis| vertex.split(' ').nth(axis).unwrap().parse().unwrap());
                format!("vertex {x} {y} {}\n", z + height)
            };
            format!(
                "facet normal 0 0 0\nouter loop\n{}endloop\nendfacet\n",
                facet.split(',').map(vertex).collect::<String>()
            )
        };
        format!("solid part\n{}endsolid part\n", corners.split(';').map(facet).collect::<String>())
    };
    dir.write("meshes/lid.stl", tetrahedron(31.0));
    dir.write("meshes/pot.stl", tetrahedron(0.0));
    let meshes = "--body meshes/lid.stl --environment meshes/pot.stl --unit mm";
    dir.run(&format!("new scenes/pot.toml {meshes} --axis z")).code(0);
    dir.run("check scenes/pot.toml").code(0).says("pairs: 1 may touch").keeps_silent_about("penetration at");
    dir.run(&format!("new scenes/under.toml {meshes} --axis -z")).code(2).says("does not get out").says("+z");
    // A copy, or another name of the same file.
    dir.write("meshes/copy.stl", tetrahedron(0.0));
    for other in ["meshes/copy.stl", "./meshes/../meshes/pot.stl"] {
        dir.run(&format!("new scenes/twice.toml --body meshes/pot.stl --environment {other} --unit mm"))
            .code(2)
            .says(other)
            .says("the same part in the same place as the body");
        assert!(!dir.exists("scenes/twice.toml"));
    }
    dir.run(&format!("new scenes/negative.toml {meshes} --offset -1")).code(2).says("'-1' for '--offset <M>'");
}

/// OBJ (mm) of a profile in the x-z plane, swept along y.
fn swept(profile: &[[f64; 2]], [low, high]: [f64; 2]) -> String {
    let count = profile.len();
    let corners = [low, high].map(|y| profile.iter().map(move |[x, z]| format!("v {x} {y} {z}\n")).collect::<String>());
    let face = |corners: Vec<usize>| {
        format!("f {}\n", corners.iter().map(|corner| (corner + 1).to_string()).collect::<Vec<_>>().join(" "))
    };
    let sides = (0..count).map(|at| face(vec![at, at + count, (at + 1) % count + count, (at + 1) % count]));
    corners.concat()
        + &face((0..count).collect())
        + &face((count..2 * count).rev().collect())
        + &sides.collect::<String>()
}

#[test]
fn press_and_snap_fits_are_named_with_depth_and_place() {
    let dir = Dir::new();
    let groove =
        [[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [20.0, 20.0], [20.0, 8.0], [10.0, 8.0], [10.0, 20.0], [0.0, 20.0]];
    let lips = [
        [[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [19.5, 20.0]],
        [[19.5, 18.0], [20.0, 18.0], [20.0, 8.0], [10.0, 8.0]],
        [[10.0, 18.0], [10.5, 18.0], [10.5, 20.0], [0.0, 20.0]],
    ];
    let peg = |aside: f64, top: f64| {
        swept(&[[10.0 + aside, 8.1], [20.0 - aside, 8.1], [20.0 - aside, top], [10.0 + aside, top]], [2.0, 18.0])
    };
    dir.write("groove.obj", swept(&groove, [0.0, 20.0]));
    dir.write("lips.obj", swept(&lips.concat(), [0.0, 20.0]));
    dir.write("wide.obj", peg(-0.1, 30.0));
    dir.write("low.obj", peg(0.1, 17.0));
    let new = |body: &str, environment: &str| {
        dir.run(&format!("new s.toml --body {body} --environment {environment} --unit mm --axis z")).code(2)
    };
    new("wide.obj", "groove.obj").says("a press fit").says("penetrate by 0.100 mm at (").says("when assembled");
    new("low.obj", "lips.obj").says("a snap fit").says("penetrate by 0.400 mm at (").says("on the way out along +z");
    // Longer hooks than parts of this size bend are in the way all the same.
    dir.write("hooked.obj", swept(&[[8.0, 8.1], [22.0, 8.1], [22.0, 17.0], [8.0, 17.0]], [2.0, 18.0]));
    let undercut = [
        [[0.0, 0.0], [30.0, 0.0], [30.0, 20.0], [19.0, 20.0]],
        [[19.0, 18.0], [23.0, 18.0], [23.0, 8.0], [7.0, 8.0]],
        [[7.0, 18.0], [11.0, 18.0], [11.0, 20.0], [0.0, 20.0]],
    ];
    dir.write("undercut.obj", swept(&undercut.concat(), [0.0, 20.0]));
    new("hooked.obj", "undercut.obj").says("body and environment penetrate by ").says(" mm from the assembled pose");
}

#[test]
fn a_start_that_overlaps_only_when_the_body_is_turned_in_the_gripper_is_shown() {
    let dir = Dir::new();
    let corner = include_str!("../scenes/corner.toml");
    let (before, rest) = corner.split_once("orientation = ").unwrap();
    let (_, after) = rest.split_once('\n').unwrap();
    let before = before.replace("position = [0.1, 0.0, 0.08]", "position = [0.1, 0.0, 0.06]");
    let low = format!("{before}orientation = [1, 0, 0, 0]\n{after}");
    assert_ne!(low, corner);
    dir.write("scenes/low.toml", &low);
    dir.run("check scenes/low.toml").code(0).keeps_silent_about("penetration at");
    dir.write("scenes/turned.toml", low.replace("[robustness]", "[robustness]\nturn = 0.3"));
    dir.run("check scenes/turned.toml").code(0).says("at the start with offset 2, rotated about");
}

#[test]
fn a_round_peg_is_solved() {
    let dir = Dir::new();
    dir.run("generate round --facets 6 --chamfer 0.0005 --out peg.toml").code(0).says("written to peg.toml");
    solved(&dir, "peg.toml");
}

#[test]
fn a_rectangular_peg_is_solved() {
    let dir = Dir::new();
    dir.run("generate rectangular --width 0.01 --depth 0.008 --out peg.toml").code(0);
    solved(&dir, "peg.toml");
}

#[test]
#[ignore = "slow, a whole solve of a peg: scripts/test and CI run it"]
fn a_keyed_peg_is_solved() {
    let dir = Dir::new();
    dir.run("generate keyed --width 0.008 --depth 0.008 --key-width 0.003 --out peg.toml").code(0);
    solved(&dir, "peg.toml");
}

#[test]
#[ignore = "slow, a whole solve of a peg: scripts/test and CI run it"]
fn a_random_peg_is_solved() {
    let dir = Dir::new();
    dir.run("generate random --seed 2 --facets 5 --out peg.toml").code(0);
    solved(&dir, "peg.toml");
}

#[test]
fn schemas_are_printed() {
    let dir = Dir::new();
    for (line, table) in [("schema", "body"), ("schema --homotopy", "homotopy")] {
        let run = dir.run(line).code(0);
        let schema: serde_json::Value = serde_json::from_str(&run.stdout).unwrap();
        assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
        assert!(schema["properties"][table].is_object() && schema["additionalProperties"] == false);
    }
}
