//! `export`: what is written, and what is refused.

use planner::Outcome;
use planner::files::PlanResult;
use serde_json::Value;

use crate::support::{Dir, project};

/// An arm for the corner scene, as the end of a scene file.
fn robot() -> String {
    let arm = std::fs::read_to_string(project("examples/arms/six.toml")).unwrap();
    let urdf = project("examples/arms/six.urdf");
    arm.replace("six.urdf", urdf.to_str().unwrap())
}

/// A plan of the corner for a free body in `out`, which always succeeds without friction.
fn plan() -> Dir {
    let dir = Dir::new();
    dir.write("easy.toml", easy(&dir));
    dir.run("solve easy.toml --robust --out out").code(0);
    dir
}

/// The corner with offsets that a plain plan brings to the goal, without friction.
fn easy(dir: &Dir) -> String {
    let key = "[robustness]\n";
    let text = dir.read("corner.toml");
    assert!(text.contains(key));
    text.replace(key, "[robustness]\nfriction = [0.0]\n")
}

/// A plan of the corner for an arm in `out`.
fn plan_of_arm() -> Dir {
    let dir = Dir::new();
    dir.write("arm.toml", easy(&dir) + &robot());
    for key in ["mass", "inertia", "translational_stiffness", "rotational_stiffness"] {
        let kept: Vec<String> =
            dir.read("arm.toml").lines().filter(|line| !line.starts_with(key)).map(str::to_owned).collect();
        dir.write("arm.toml", kept.join("\n"));
    }
    dir.run("solve arm.toml --out out").code(0);
    dir
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

#[test]
fn tables_of_a_free_body_are_those_of_the_part_in_the_world() {
    let dir = plan();
    dir.run("export out --to csv --rate 100").code(0).says("the scene has no arm");
    let (reference, trajectory) = (dir.table("out/reference.csv"), dir.table("out/export/csv/trajectory.csv"));
    assert_eq!(reference.header, trajectory.header);
    let samples = trajectory.numbers_from("px_m");
    // Knots are 0.08 s apart, samples 0.01 s.
    for (knot, row) in reference.numbers_from("px_m").iter().enumerate() {
        let distance = (0..3).map(|axis| (samples[8 * knot][axis] - row[axis]).abs()).fold(0.0, f64::max);
        assert!(distance < 1e-6, "knot {knot}: {distance}");
    }
    let document = dir.json("out/export/csv/plan.json");
    assert_eq!(document["frame"], "world");
    assert_eq!(document["arm"], Value::Null);
    assert!(dir.read("out/export/csv/README.md").contains("the world of the scene"));
}

#[test]
fn poses_of_an_arm_are_those_of_its_tool_in_its_base() {
    let dir = plan_of_arm();
    dir.run("export out --to csv").code(0);
    let (reference, trajectory) = (dir.table("out/reference.csv"), dir.table("out/export/csv/trajectory.csv"));
    let (first, tool) = (&reference.numbers_from("px_m")[0], &trajectory.numbers_from("px_m")[0]);
    // The base is at (-0.55, -0.1, -0.1) without a turn, and the tool has the part's origin.
    for (axis, base) in [-0.55, -0.1, -0.1].into_iter().enumerate() {
        assert!((tool[axis] - (first[axis] - base)).abs() < 1e-6, "{tool:?}");
    }
    // The tool is turned by half a turn about x against the part: (w x y z) becomes (x -w -z y), or its negative.
    let [w, x, y, z] = [3, 4, 5, 6];
    for (turned, own) in [(w, x), (x, w), (y, z), (z, y)] {
        assert!((tool[turned].abs() - first[own].abs()).abs() < 1e-6, "{tool:?} {first:?}");
    }

    // The base is not turned: forces stay as they are. Torques are turned, about the same point.
    let [own, carried] =
        ["out/wrench.csv", "out/export/csv/wrench.csv"].map(|file| dir.table(file).numbers_from("fx_n"));
    assert_eq!(own.len(), carried.len());
    let size = |torque: &[f64]| torque.iter().map(|component| component * component).sum::<f64>().sqrt();
    for (own, carried) in own.iter().zip(&carried) {
        let moved = (0..3).map(|axis| (own[axis] - carried[axis]).abs()).fold(0.0, f64::max);
        assert!(moved < 1e-9 && (size(&own[3..]) - size(&carried[3..])).abs() < 1e-9, "{own:?} {carried:?}");
    }

    let document = dir.json("out/export/csv/plan.json");
    let result = dir.result("out");
    let stiffness = result["gains"]["translational_stiffness_n_m"].as_f64().unwrap();
    assert!((document["tool_stiffness"][0][0].as_f64().unwrap() - stiffness).abs() < 1e-6 * stiffness);
    assert_eq!(document["arm"]["joints"].as_array().unwrap().len(), 6);
    assert_eq!(numbers(&document["arm"]["start_configuration"]).len(), 6);
    assert!(!dir.read("out/export/csv/README.md").contains("{{"), "a name in the README has no number");
}

#[test]
fn every_target_writes_its_player() {
    let dir = plan_of_arm();
    for (target, file) in [("ur-rtde", "ur_robot.py"), ("ros2", "middleware.py"), ("urscript", "plan.script")] {
        let folder = format!("out/export/{target}");
        dir.run(&format!("export out --to {target}")).code(0).says(file);
        let sums = dir.read(format!("{folder}/SHA256SUMS"));
        let names: Vec<&str> = sums.lines().filter_map(|line| line.split_once("  ")).map(|(_, name)| name).collect();
        for name in &names {
            assert!(!dir.read(format!("{folder}/{name}")).is_empty(), "{name}");
        }
        assert!(names.contains(&"plan.json") && names.contains(&"trajectory.csv") && names.contains(&"guards.py"));
        assert!(!dir.read(format!("{folder}/README.md")).contains("{{"));
        assert!(dir.exists(format!("{folder}/guards.py")));
    }
    assert!(!dir.read("out/export/urscript/plan.script").contains("{{"));
    assert!(dir.exists("out/export/urscript/receive.py"));
    dir.run("export out --to franka").code(2).says("6 joints, and these robots have 7");
}

#[test]
fn a_plan_for_positions_is_exported_with_its_law_and_not_for_torques() {
    let dir = Dir::new();
    dir.write("position.toml", easy(&dir) + "\n[robot]\ninterface = \"position\"\n");
    dir.run("solve position.toml --out out");
    dir.run("export out --to correction --anyway").code(0).says("correction_robot.py");
    let law = &dir.json("out/export/correction/plan.json")["admittance"];
    assert_eq!(law, &dir.result("out")["admittance"]);
    assert_eq!(law["interface"], "position");
    let readme = dir.read("out/export/correction/README.md");
    assert!(readme.contains("M a + D (v - v_r) + K (x - x_r) = F") && !readme.contains("{{"), "{readme}");
    assert!(dir.exists("out/export/correction/admittance.py"));
    let refused = dir.run("export out --to ros2 --anyway").code(2);
    refused.says("was made for a robot with the interface `position`: use --to csv, correction or ros2-control");
    dir.run("export out --to urscript --anyway").code(2).says("use --to csv, correction or ros2-control");
    dir.run("export out --to ros2-control --anyway").code(2).says("the plan was made without an arm");
    assert!(!dir.exists("out/export/ros2-control"));
}

/// A plan of the corner for an arm with an interface, closer to it than usual: a joint follows.
fn plan_of_commanded_arm(interface: &str) -> Dir {
    let dir = Dir::new();
    let removed = ["mass", "inertia", "translational_stiffness", "rotational_stiffness"];
    let scene = easy(&dir);
    let kept: Vec<&str> = scene.lines().filter(|line| !removed.iter().any(|key| line.starts_with(key))).collect();
    let arm = robot().replace("position = [-0.55,", "position = [-0.45,")
        + "contact_stiffness = 2e4\n"
        + "stiffness_range = { rotational = [1, 50] }\n"
        + interface;
    dir.write("arm.toml", kept.join("\n") + "\n" + &arm);
    dir.run("solve arm.toml --out out");
    dir
}

#[test]
fn parameters_of_the_admittance_controller_are_those_of_the_law() {
    let dir = plan_of_commanded_arm("interface = \"position\"\n");
    dir.run("export out --to ros2-control --anyway").code(0).says("controllers.yaml");
    let folder = "out/export/ros2-control";
    let (text, document) = (dir.read(format!("{folder}/controllers.yaml")), dir.json(format!("{folder}/plan.json")));
    let list = |key: &str| -> Vec<f64> {
        let line = text.lines().find(|line| line.trim().starts_with(&format!("{key}: ["))).unwrap();
        let inside = line.split_once('[').unwrap().1.trim_end_matches(']');
        inside.split(", ").map(|number| number.parse().unwrap()).collect()
    };
    let [mass, ratio, stiffness] = ["mass", "damping_ratio", "stiffness"].map(list);
    let law = |key: &str| numbers(&document["admittance"][key]);
    for axis in 0..6 {
        let part = axis / 3;
        assert_eq!((mass[axis], stiffness[axis]), (law("mass")[part], law("stiffness")[part]));
        let damping = 2.0 * ratio[axis] * (mass[axis] * stiffness[axis]).sqrt();
        assert!((damping - law("damping")[part]).abs() < 1e-9 * damping, "{damping}");
    }
    assert!(text.contains("update_rate: 500\n") && text.contains("tip: \"tool\"") && !text.contains("{{"), "{text}");
    assert_eq!(document["arm"]["root"], "base");
    for file in ["play.py", "admittance_robot.py", "topic_robot.py", "inbox.py", "guards.py"] {
        assert!(dir.exists(format!("{folder}/{file}")), "{file}");
    }
    assert!(!dir.read(format!("{folder}/README.md")).contains("{{"));
    // The controller has no parameter for the lever of a part that is held beside the tip.
    let arm = dir.read("arm.toml");
    let grasp = "grasp = { position = [0.0, 0.0, 0.0]";
    assert!(arm.contains(grasp));
    dir.write("arm.toml", arm.replace(grasp, "grasp = { position = [0.0, 0.0, 0.03]"));
    dir.run("solve arm.toml --out lever");
    dir.run("export lever --to ros2-control --anyway").code(2).says("30.000 mm from that of robot.tip");
    assert!(!dir.exists("lever/export"));
}

#[test]
fn a_plan_for_force_mode_has_a_script_in_force_mode() {
    let gains = "{ translational_gain = 8e-4, rotational_gain = 0.16 }";
    let dir = plan_of_commanded_arm(&format!("interface = \"force\"\nforce_mode = {gains}\n"));
    dir.run("export out --to urscript --anyway").code(0).says("plan.script");
    let script = dir.read("out/export/urscript/plan.script");
    assert!(script.contains("    force_mode(force_frame, [1, 1, 1, 1, 1, 1], force_wrench, 2, force_mode_speeds)\n"));
    assert!(script.contains("end_force_mode()") && !script.contains("direct_torque") && !script.contains("{{"));
    assert!(dir.read("out/export/urscript/README.md").contains("wrenches to force mode"));
    dir.run("export out --to ros2-control --anyway").code(2).says("use --to csv, ur-rtde or urscript");
}

#[test]
fn models_have_every_piece_and_what_moves_it() {
    for (dir, carrier) in [(plan(), "<freejoint"), (plan_of_arm(), "actuatorfrcrange")] {
        let pieces = dir.read("corner.toml").matches(".part]]").count();
        for (target, file, piece) in [
            ("mjcf", "plan.xml", "<mesh name="),
            ("sdf", "plan.sdf", "<collision name="),
            ("usd", "plan.usda", "\"PhysicsCollisionAPI\""),
        ] {
            let folder = format!("out/export/{target}");
            dir.run(&format!("export out --to {target}")).code(0).says(file);
            let text = dir.read(format!("{folder}/{file}"));
            assert_eq!(text.matches(piece).count(), pieces, "{target}");
            assert!(!text.contains("NaN") && !text.contains("inf"), "{target}");
            assert!(!dir.read(format!("{folder}/README.md")).contains("{{"));
            assert!(dir.exists(format!("{folder}/SHA256SUMS")));
        }
        assert!(dir.read("out/export/mjcf/plan.xml").contains(carrier));
        assert!(dir.exists("out/export/sdf/environment_0.obj"));
    }
}

#[test]
fn what_cannot_be_exported_is_refused() {
    let dir = plan();
    for (line, words) in [
        ("export out --to ur-rtde", "was made without an arm; add [robot]"),
        (
            "export out --to kuka",
            "[possible values: csv, ur-rtde, franka, urscript, ros2, correction, ros2-control, mjcf, sdf, usd]",
        ),
        (
            "export out --to correction",
            "was made for a robot with the interface `torque`: use --to csv, ur-rtde, franka",
        ),
        ("export out --to csv --rate 0", "between 1 and 10000 Hz"),
        ("export gone --to csv", "gone"),
        ("export out --to csv --out corner.toml", "is a file"),
    ] {
        let before = dir.snapshot("");
        dir.run(line).code(2).says(words);
        assert!(before == dir.snapshot(""), "{line}: changed something");
    }
    dir.write("out/reference.csv", dir.read("out/reference.csv") + "\n");
    dir.run("export out --to csv").code(2).says("was changed since the plan was written");
}

#[test]
fn a_plan_that_is_not_done_is_exported_only_anyway() {
    let dir = Dir::new();
    dir.run("solve corner.toml --position-tolerance 1e-6 --out out").code(1);
    dir.run("export out --to csv").code(2).says("the plan is not done");
    dir.run("export out --to csv --anyway").code(0).says("warning: the plan is not done");
}

#[test]
fn only_earlier_exports_are_replaced() {
    let dir = plan();
    dir.run("export out --to csv --out robot").code(0);
    dir.run("export out --to csv --rate 250 --out robot").code(0);
    dir.write("robot/README.md", "mine");
    let before = dir.snapshot("");
    dir.run("export out --to csv --out robot").code(2).says("is not from an earlier export");
    assert!(before == dir.snapshot(""));
    dir.make_folder("notes");
    dir.write("notes/plan.json", "{}");
    dir.run("export out --to csv --out notes").code(2).says("notes/plan.json");
    dir.write("notes/plan.json", dir.read("robot/plan.json"));
    dir.write("notes/SHA256SUMS", "mine");
    dir.run("export out --to csv --out notes").code(2).says("notes/SHA256SUMS");
}

#[test]
#[ignore = "slow, a whole solve and its rollouts: scripts/test and CI run it"]
fn a_plan_that_fails_in_rollouts_is_exported_only_anyway() {
    let dir = Dir::new();
    dir.add_scene("peg1");
    dir.run("solve peg1.toml --delta 0.02 --out out").code(0);
    dir.run("export out --to csv").code(2).says("rollouts with hard contact reach the goal").says("--robust");
    assert!(!dir.exists("out/export"));
    dir.run("export out --to csv --anyway").code(0).says("warning: at friction");
    let document = dir.json("out/export/csv/plan.json");
    assert_eq!(document["anyway"], true);
    let warnings = document["warnings"].as_array().unwrap();
    assert!(warnings.iter().any(|warning| warning == "the plan was exported with --anyway"));
    assert!(dir.read("out/export/csv/README.md").contains("**Warning: at friction"));
}

#[test]
fn former_names_in_a_result_are_read() {
    let dir = plan();
    let text = dir.read("out/result.json");
    let former = text.replace("allowed_penetration_m", "max_overlap_m");
    assert_ne!(text, former);
    let read = |text: &str| serde_json::from_str::<PlanResult>(text).unwrap().allowed_penetration_m;
    assert!(read(&text) > 0.0);
    assert_eq!(read(&former), read(&text));
    assert_eq!(serde_json::from_str::<Outcome>("\"overlapping\"").unwrap(), Outcome::Penetrating);
}

/// Text of `result.json` reaches no file; what is edited there is refused.
#[test]
fn an_edited_title_is_refused() {
    let dir = plan();
    let title = r#""scene": "corner\n  set_digital_out(0, True)""#;
    let text = dir.read("out/result.json");
    assert!(text.contains(r#""scene": "corner""#));
    let edited = text.replace(r#""scene": "corner""#, title);
    dir.write("out/result.json", &edited);
    dir.run("export out --to csv").code(2).says("out/result.json: was changed since the plan was written");
    dir.write("out/result.json", planner::files::sealed(edited));
    dir.run("export out --to csv").code(2).says("scene is `corner").says("it was changed; solve again");
    assert!(!dir.exists("out/export"));
}

/// A title that is a name of the template stays what it is.
#[test]
fn a_title_is_no_template() {
    let dir = Dir::new();
    dir.write("titled.toml", easy(&dir).replace("title = \"corner\"", "title = \"{{rates}} {{tool_stiffness}}\""));
    dir.run("solve titled.toml --robust --out out").code(0);
    dir.run("export out --to csv").code(0);
    assert!(dir.read("out/export/csv/README.md").starts_with("# Plan of `{{rates}} {{tool_stiffness}}`"));
}

/// An export that was killed at any point of its moves is finished by the next one.
#[test]
fn an_interrupted_export_is_repeated() {
    let dir = plan();
    let exported = |rate: u32, folder: &str| {
        dir.run(&format!("export out --to csv --rate {rate} --out {folder}")).code(0);
        dir.snapshot(folder)
    };
    exported(250, "other");
    let [new, old] = [250, 100].map(|rate| exported(rate, "robot"));
    let names = ["README.md", "plan.json", "trajectory.csv", "wrench.csv", "SHA256SUMS"];
    for moved in 0..=names.len() {
        // After this many moves: the sums are out, some files are in.
        assert!(exported(100, "robot") == old);
        dir.make_folder(".robot.unfinished/whole");
        dir.write(".robot.unfinished/lock", "");
        dir.write(".robot.unfinished/replaced", dir.read("robot/SHA256SUMS"));
        std::fs::remove_file(dir.path("robot/SHA256SUMS")).unwrap();
        for (index, name) in names.iter().enumerate() {
            let place = if index < moved { "robot" } else { ".robot.unfinished/whole" };
            dir.write(format!("{place}/{name}"), dir.read(format!("other/{name}")));
        }
        assert!(exported(250, "robot") == new, "after {moved} moves");
        assert!(!dir.exists(".robot.unfinished"));
    }
}
