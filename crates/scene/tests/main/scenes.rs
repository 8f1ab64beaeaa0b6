//! Good and bad scene files.

use std::path::Path;

use scene::{Scene, SceneError, Source, default_homotopy, load_homotopy, resolved};
use task::{Coverage, Limits, Scenario};

use crate::support::{SCENE, assert_place, folder, parse, replaced};

/// The error of the scene after a replacement, with its line of text.
fn error(from: &str, to: &str) -> (SceneError, String) {
    let text = replaced(from, to);
    let error = parse(&text).expect_err(to);
    let line = error.line().map_or("", |line| text.lines().nth(line - 1).unwrap());
    (error.clone(), line.to_owned())
}

#[test]
fn a_small_scene_gets_the_defaults() {
    let scene = parse(SCENE).unwrap();
    assert_eq!(scene.title, "test");
    assert_eq!(scene.pairs, [(0, 0)]);
    let task = scene.task(None, None).unwrap();
    assert_eq!(task.inertia.mass(), Some(1.0));
    assert!((task.impedance.translational_damping[(2, 2)] - 2.0 * 50f64.sqrt()).abs() < 1e-12);
    assert!((task.impedance.rotational_damping[(1, 1)] - 2.0 * (5.0f64 * 0.1).sqrt()).abs() < 1e-12);
    assert_eq!(task.cost.compliant.terminal_position, 10_000.0);
    assert_eq!(task.offsets(), [[0.02 * 0.6, -0.02 * 0.8, 0.0], [0.0; 3]]);
    assert_eq!(scene.task(Some("a"), Some(0.0)).unwrap().offsets()[0], [0.0, -0.0, 0.0]);
    assert!(scene.task(Some("b"), None).unwrap_err().to_string().contains("the scene has a"));
    assert!(scene.task(None, Some(-1.0)).is_err());
}

#[test]
fn a_scene_may_leave_controller_horizon_and_directions_to_the_program() {
    let (begin, _) = SCENE.split_once("[impedance]").unwrap();
    let scene = parse(&format!("{begin}[robustness]\noffset_magnitude = 0.02\n")).unwrap();
    assert_eq!(scene.chosen.len(), 5, "{:?}", scene.chosen);
    assert_eq!((scene.impedance.translational_stiffness, scene.horizon.steps), (50.0, 99));
    assert_eq!(scene.coverage, Coverage::Disc { axis: [0.0, 0.0, 1.0] }, "across the way from the start");
    let text = resolved(&scene, &scene.starts[0], scene.offset_magnitude, &default_homotopy());
    let again = parse(&text).unwrap();
    assert_eq!((again.horizon, again.impedance), (scene.horizon, scene.impedance));
    assert_eq!((again.coverage, again.chosen), (scene.coverage, Vec::new()));
    assert_eq!(again.offset_directions, scene.offset_directions);
    assert_eq!(parse(&replaced("offset_magnitude = 0.02", "offset_magnitude = 0")).unwrap().chosen, [""; 0]);
    let certain = parse(&format!("{begin}[robustness]\noffset_magnitude = 0\n")).unwrap();
    assert_eq!(certain.task(None, None).unwrap().offsets(), [[0.0; 3]]);
}

#[test]
fn a_resolved_scene_plans_the_same_offsets_from_any_start_at_any_magnitude() {
    let (begin, _) = SCENE.split_once("[impedance]").unwrap();
    let tilted = "[[start]]\nname = \"b\"\nposition = [0.05, -0.02, 0.1]\norientation = [1, 0, 0, 0]\n";
    for (start, keys) in [
        ("a", ""),
        ("b", ""),
        ("b", "coverage = \"ball\"\n"),
        ("a", "coverage = \"disc\"\ninsertion_axis = [0.48, 0.6, 0.64]\n"),
        ("a", "insertion_axis = [0.4804, 0.6, 0.64]\n"),
    ] {
        let tilted_first = begin.replacen("[[start]]", &format!("{tilted}[[start]]"), 1);
        for starts in [format!("{begin}{tilted}"), tilted_first] {
            let scene = parse(&format!("{starts}[robustness]\noffset_magnitude = 0\n{keys}")).unwrap();
            let start = scene.start(Some(start)).unwrap();
            for magnitude in [0.0, 0.003] {
                let again = parse(&resolved(&scene, start, magnitude, &default_homotopy())).unwrap();
                assert_eq!(again.coverage, scene.coverage);
                assert_eq!(again.grasps(again.offset_magnitude).unwrap(), scene.grasps(magnitude).unwrap());
            }
        }
    }
}

#[test]
fn a_disc_and_a_ball_are_planned_with_offsets_as_long_as_the_magnitude() {
    let offsets = |coverage: &str| {
        let scene = parse(&replaced("offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]", coverage)).unwrap();
        scene.task(None, None).unwrap().offsets()
    };
    let axis = [0.48, 0.6, 0.64];
    let along = |offset: &[f64; 3]| (0..3).map(|index| offset[index] * axis[index]).sum::<f64>();
    let length = |offset: &[f64; 3]| offset.iter().map(|component| component * component).sum::<f64>().sqrt();
    let disc = offsets("insertion_axis = [0.48, 0.6, 0.64]");
    assert!(disc.iter().all(|offset| along(offset).abs() < 1e-12 && (length(offset) - 0.02).abs() < 1e-12));
    let ball = offsets("coverage = \"ball\"");
    assert_eq!(ball.len(), 6);
    assert!(ball.iter().all(|offset| (length(offset) - 0.02).abs() < 1e-12));
}

#[test]
fn an_unknown_key_names_the_nearest_valid_one() {
    let (error, line) = error("steps", "stepps");
    assert_eq!(line, "stepps = 10");
    assert_eq!(error.column(), Some(1));
    assert!(error.message().contains("`stepps`, did you mean `steps`?"), "{error}");
    assert!(error.to_string().starts_with("test.toml:23:1: "), "{error}");
    assert!(error.to_string().ends_with("^^^^^^"), "{error}");
}

#[test]
fn damping_is_resolved_in_its_shortest_form() {
    let scene = |damping: &str| parse(&replaced("[robustness]", &format!("{damping}\n[robustness]")));
    for (translational, rotational) in [
        ("14.5", "[1.0, 2.0, 3.0]"),
        ("[1.0, 2.0, 0.0]", "[[2.0, 0.5, 0.0], [0.5, 2.0, 0.0], [0.0, 0.0, 1.0]]"),
        ("[[1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 2.0]]", "[0.0, 0.0, 0.0]"),
        ("[[1.0, 0.9, 0.9], [0.9, 0.81, 0.81], [0.9, 0.81, 0.81]]", "[1.0, 1.0, 1.0]"),
    ] {
        let lines = [format!("translational_damping = {translational}"), format!("rotational_damping = {rotational}")];
        let scene = scene(&lines.join("\n")).unwrap_or_else(|error| panic!("{error}"));
        let text = resolved(&scene, &scene.starts[0], 0.01, &default_homotopy());
        assert!(lines.iter().all(|line| text.lines().any(|other| other == line)), "{text}");
        assert_eq!(parse(&text).unwrap().impedance, scene.impedance);
    }
    let long = scene("translational_damping = [[3, 0, 0], [0, 3, 0], [0, 0, 3]]").unwrap();
    assert_eq!(long.impedance, scene("translational_damping = 3").unwrap().impedance);
}

#[test]
fn limits_are_read_and_resolved() {
    let scene =
        parse(&SCENE.replace("[horizon]", "[limits]\nforce = 5\nrotational_velocity = 0.5\n[horizon]")).unwrap();
    let limits = Limits { force: 5.0, rotational_velocity: 0.5, ..Limits::NONE };
    assert_eq!(scene.task(None, None).unwrap().limits, limits);
    let text = resolved(&scene, &scene.starts[0], 0.01, &default_homotopy());
    assert_eq!(parse(&text).unwrap().limits, limits);
    let unlimited = parse(SCENE).unwrap();
    assert_eq!(unlimited.limits, Limits::NONE);
    assert!(!resolved(&unlimited, &unlimited.starts[0], 0.01, &default_homotopy()).contains("[limits]"));
}

#[test]
fn friction_is_read_and_resolved() {
    let scene = parse(&SCENE.replace("[horizon]", "[contact]\nfriction = 0.3\n[horizon]")).unwrap();
    assert_eq!(scene.task(None, None).unwrap().frictions, [0.3]);
    let text = |scene: &Scene| resolved(scene, &scene.starts[0], 0.01, &default_homotopy());
    assert_eq!(parse(&text(&scene)).unwrap().frictions, [0.3]);
    let several = parse(&SCENE.replace("[horizon]", "[contact]\nfriction = [0, 0.3]\n[horizon]")).unwrap();
    assert_eq!(parse(&text(&several)).unwrap().frictions, [0.0, 0.3]);
    let task = several.task(None, None).unwrap();
    let scenarios = task.scenarios();
    assert_eq!(scenarios.len(), 2 * task.grasps.len(), "every offset with every friction");
    assert_eq!(scenarios[task.grasps.len()], Scenario { grasp: task.grasps[0], friction: 0.3 });
    let frictionless = parse(SCENE).unwrap();
    assert_eq!(frictionless.frictions, [0.0]);
    assert!(!text(&frictionless).contains("friction = 0.0"), "that of the plan; [robustness] has a list");
}

#[test]
fn limits_that_no_plan_can_keep_are_refused() {
    // The goal is 90 mm below the start and, with the first offset, 16 mm beside it; there are 10 steps of 0.04 s.
    for (limits, words, column) in [
        ("force = 0.0", "limits.force = 0.0: must lie between 1e-9 and 1e9 N", 9),
        ("torque = -1", "limits.torque = -1: must lie between 1e-9 and 1e9 Nm", 10),
        ("contact_force = inf", "limits.contact_force = inf: must lie between 1e-9 and 1e9 N", 17),
        ("contact_forces = 1", "unknown key `contact_forces`, did you mean `contact_force`?", 1),
        ("velocity = 1", "unknown key `velocity`; valid are: translational_velocity, ", 1),
        (
            "translational_velocity = 0.2",
            "limits.translational_velocity = 0.2: the goal is 0.090 m from start `a` along an axis, and 10 steps of 0.04 s \
             within the limits cover 0.080 m; allow more than 0.225 m/s, or more steps in [horizon]",
            26,
        ),
        ("translational_acceleration = 1.0", "cover 0.088 m; allow more than 1.023 m/s^2", 30),
        (
            "translational_acceleration = 1.1\ntranslational_velocity = 0.23",
            "cover 0.072 m; allow more than 4.5 m/s^2",
            30,
        ),
    ] {
        let (error, line) = error("[goal]", &format!("[limits]\n{limits}\n[goal]"));
        assert!(error.message().contains(words), "{error}");
        assert_eq!(line, limits.lines().next().unwrap());
        assert_eq!(error.column(), Some(column), "{error}");
    }
    let turned = SCENE.replacen("orientation = [1, 0, 0, 0]", "orientation = [0, 1, 0, 0]", 1);
    let turned = |velocity: f64| parse(&format!("{turned}[limits]\nrotational_velocity = {velocity}\n"));
    assert!(turned(4.5).unwrap_err().message().contains("allow more than 4.535 rad/s"));
    assert!(turned(4.6).is_ok());
    assert!(parse(&SCENE.replace("[goal]", "[limits]\ntranslational_velocity = 0.226\n[goal]")).is_ok());
}

#[test]
fn a_scene_that_cannot_be_read_is_named() {
    let error = Scene::load(Path::new("no/such/scene.toml")).unwrap_err();
    assert!(error.to_string().starts_with("no/such/scene.toml: the scene cannot be read"));
}

#[test]
fn every_scene_and_homotopy_of_the_project_loads() {
    for entry in std::fs::read_dir(folder("scenes")).unwrap() {
        let path = entry.unwrap().path();
        let scene = Scene::load(&path).unwrap_or_else(|error| panic!("{error}"));
        assert!(scene.homotopy.is_none() && scene.warnings.is_empty(), "{}", path.display());
    }
    for entry in std::fs::read_dir(folder("configs")).unwrap() {
        load_homotopy(&entry.unwrap().path()).unwrap_or_else(|error| panic!("{error}"));
    }
}

#[test]
fn a_resolved_scene_reproduces_the_task() {
    let scene = Scene::load(&folder("scenes/clamp1.toml")).unwrap();
    let homotopy = load_homotopy(&folder("configs/homotopy_clamp_wide.toml")).unwrap();
    let start = scene.start(Some("3")).unwrap();
    let text = resolved(&scene, start, 0.003, &homotopy);
    let again = parse(&text).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(again.homotopy, Some(homotopy));
    assert_eq!(again.starts.len(), 1);
    let (one, other) = (scene.task(Some("3"), Some(0.003)).unwrap(), again.task(None, None).unwrap());
    assert_eq!((one.start, one.goal, &one.grasps), (other.start, other.goal, &other.grasps));
    assert_eq!((&one.impedance, one.horizon, one.cost), (&other.impedance, other.horizon, other.cost));
    for (pair, twin) in one.pairs.iter().zip(&other.pairs) {
        assert_eq!((&pair.body, &pair.environment), (&twin.body, &twin.environment));
        let difference = pair.shapes.exact_distance(&one.start) - twin.shapes.exact_distance(&one.start);
        assert!(difference.abs() < 1e-10);
    }
}

/// A box as twelve triangles, with one corner moved.
fn stl(corner: f64) -> String {
    let vertex = |index: usize| {
        let place = |axis: usize| if index >> axis & 1 == 1 { 20.0 } else { 0.0 };
        if index == 7 { [corner; 3] } else { [place(0), place(1), place(2)] }
    };
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let mut text = "solid part\n".to_owned();
    for [a, b, c, d] in quads {
        for triangle in [[a, b, c], [a, c, d]] {
            text += "facet normal 0 0 0\nouter loop\n";
            for [x, y, z] in triangle.map(vertex) {
                text += &format!("vertex {x} {y} {z}\n");
            }
            text += "endloop\nendfacet\n";
        }
    }
    text + "endsolid part\n"
}

#[test]
fn meshes_are_read_in_their_unit() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("scene.toml");
    let text = SCENE.replacen("box = [0.1, 0.1, 0.1]", "mesh = \"wall.stl\"\nunit = \"mm\"", 1);
    let parse = || Scene::parse(Source { file: &file, text: &text });
    assert!(parse().unwrap_err().message().contains("wall.stl"));
    std::fs::write(folder.path().join("wall.stl"), stl(20.0)).unwrap();
    let scene = parse().unwrap();
    assert_eq!(scene.environment[0].shape.normals().len(), 6);
    assert!((scene.environment[0].shape.size() - 0.02).abs() < 1e-9);
}

#[test]
fn former_names_of_keys_are_read_with_a_warning() {
    let directions = "offset_directions = [[0.6, -0.8, 0], [0, 0, 0]]";
    let scene = |error: &str, axes: &str| {
        replaced(directions, &format!("{directions}\n{error} = 0.02\n{axes} = [[0, 0, 1], [0, 0, 0]]"))
    };
    let present = parse(&scene("rotation_error", "rotation_axes")).unwrap();
    let former = parse(&scene("turn", "turn_axes")).unwrap();
    assert!(present.warnings.is_empty() && present.robustness.rotation_error == 0.02);
    assert_eq!(former.warnings.len(), 2, "{:?}", former.warnings);
    for (line, warning) in former.warnings.iter().enumerate() {
        assert!(warning.starts_with(&format!("test.toml:{}:1: `robustness.turn", 22 + line)), "{warning}");
        assert!(warning.contains("is now `robustness.rotation_"), "{warning}");
    }
    assert_eq!((&former.robustness, &former.rotation_axes), (&present.robustness, &present.rotation_axes));
    let error = parse(&replaced(directions, "turn = 0.02\nrotation_error = 0.02")).unwrap_err();
    assert_place(&error, "the former name of `rotation_error`", (21, 1));
    let error = parse(&replaced(directions, "turn = -1")).unwrap_err();
    assert_place(&error, "robustness.rotation_error", (21, 8));
}
