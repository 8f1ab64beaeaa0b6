//! Scenes that are too large, look like a mistaken unit, or have no task for what is asked.

use scene::{Scene, TaskError, default_homotopy, resolved};

use crate::support::{SCENE, folder, parse, replaced};

const START: &str = "[[start]]\nname = \"a\"\nposition = [0, 0, 0.09]\norientation = [1, 0, 0, 0]\n";
const WALL: &str = "[[environment.part]]\nname = \"wall\"\nbox = [0.1, 0.1, 0.1]\nposition = [0.1, 0.0, 0.0]\n";
const DIRECTIONS: &str = "[[0.6, -0.8, 0], [0, 0, 0]]";

fn message(text: &str) -> String {
    parse(text).unwrap_err().to_string()
}

/// The small scene with some number of walls.
fn with_walls(count: usize) -> String {
    let walls: String = (0..count).map(|wall| WALL.replace("wall", &format!("wall{wall}"))).collect();
    replaced(WALL, &walls)
}

/// The small scene with some number of offset directions.
fn with_directions(count: usize) -> String {
    replaced(DIRECTIONS, &format!("[{}]", vec!["[0, 0, 1]"; count].join(", ")))
}

/// The small scene with some number of starts.
fn with_starts(count: usize) -> String {
    let starts = (0..count).map(|start| START.replace("\"a\"", &format!("\"{start}\"")));
    replaced(START, &starts.collect::<String>())
}

#[test]
fn a_thousand_parts_starts_and_directions_are_possible_and_no_more() {
    assert!(parse(&with_walls(1000)).is_ok() && parse(&with_directions(1000)).is_ok());
    assert!(message(&with_walls(1001)).contains("environment.part has 1001 entries: it must have at most 1000"));
    assert!(message(&with_directions(1001)).contains("offset_directions has 1001 entries: it must have at most 1000"));
    let error = parse(&with_starts(1000)).unwrap().start(Some("zzz")).unwrap_err().to_string();
    assert!(error.ends_with("17, 18, 19 and 980 more"), "{error}");
    assert!(message(&with_starts(1001)).contains("start has 1001 entries: it must have at most 1000"));
}

#[test]
fn more_than_ten_thousand_pairs_need_a_choice() {
    let parts = |header: &str, count: usize| -> String {
        (0..count).map(|part| format!("[[{header}.part]]\nname = \"p{part}\"\nbox = [1, 1, 1]\n")).collect()
    };
    let body = "[[body.part]]\nname = \"shaft\"\nbox = [0.02, 0.02, 0.1]\n";
    let text = replaced(WALL, &parts("environment", 101)).replace(body, &parts("body", 100));
    assert!(message(&text).contains("100 body parts and 101 environment parts make more than 10000 pairs: list those"));
    assert_eq!(parse(&format!("{text}[contact]\npairs = [[\"p0\", \"p1\"]]\n")).unwrap().pairs, [(0, 1)]);
}

#[test]
fn a_problem_that_is_too_large_says_what_to_lower() {
    let large = with_directions(300).replace("steps = 10", "steps = 10000");
    let error = parse(&large).unwrap_err();
    assert_eq!(large.lines().nth(error.line().unwrap() - 1), Some("steps = 10000"));
    assert!(
        error.message().contains(
            "10000 steps x 300 planned offsets x 1 contact pairs make 3000000 contact forces, more than 1000000: lower \
             horizon.steps, or list fewer robustness.offset_directions or contact.pairs"
        ),
        "{error}"
    );
    assert!(parse(&large.replace("steps = 10000", "steps = 3333")).is_ok());
    let with_frictions = format!("{}[contact]\nfriction = [0, 0.3]\n", large.replace("steps = 10000", "steps = 3333"));
    assert!(parse(&with_frictions).unwrap_err().message().contains("x 2 coefficients of friction make 1999800"));
}

#[test]
fn parts_from_a_tenth_of_a_millimetre_to_ten_metres_need_no_remark() {
    for (edges, words) in [
        ("[1e-4, 1e-4, 1e-4]", None),
        ("[5, 2, 1.5]", None),
        ("[9e-5, 9e-5, 9e-5]", Some("test.toml:3:8: part `shaft` is 0.00009 m long: are these metres?")),
        ("[20, 20, 100]", Some("part `shaft` is 100 m long: are these metres?")),
    ] {
        let text = replaced("[0.02, 0.02, 0.1]", edges).replace("offset_magnitude = 0.02", "offset_magnitude = 0");
        let warnings = parse(&text).unwrap().warnings;
        assert_eq!(warnings.len(), usize::from(words.is_some()), "{warnings:?}");
        assert!(warnings.iter().all(|warning| warning.contains(words.unwrap())), "{warnings:?}");
    }
}

#[test]
fn millimetres_for_metres_are_noticed() {
    for (from, to, words) in [
        ("position = [0, 0, 0.09]", "position = [0, 0, 51]", "test.toml:11:12: start `a` is 50.898"),
        ("position = [0, 0, 0]\n", "position = [0, 40, 0]\n", "test.toml:14:12: the goal is 39.898"),
        (
            "position = [0, 0, 0.09]",
            "position = [0, 0, 2]",
            "start `a` is 1.899 m away from the environment: are these",
        ),
        ("offset_magnitude = 0.02", "offset_magnitude = 2", "an offset of 2 m is larger than the body, 0.100 m"),
        ("box = [0.02, 0.02, 0.1]", "box = [0.02, 0.02, 0.1]\nposition = [0, 0, 5]", "4.950 m away from its origin"),
    ] {
        let warnings = parse(&replaced(from, to)).unwrap().warnings;
        assert!(warnings.iter().any(|warning| warning.contains(words)), "{warnings:?}");
    }
    assert!(parse(SCENE).unwrap().warnings.is_empty());
}

#[test]
fn an_unknown_start_comes_with_those_that_there_are() {
    let scene = Scene::load(&folder("scenes/corner.toml")).unwrap();
    let error = scene.task(Some("9"), None).unwrap_err();
    assert_eq!(error.to_string(), "there is no start `9`; the scene has 1, 2, 3");
    let known = vec!["1".to_owned(), "2".to_owned(), "3".to_owned()];
    assert_eq!(error, TaskError::UnknownStart { name: "9".to_owned(), known, suggestion: None });
    let named = parse(&replaced("name = \"a\"", "name = \"above\"")).unwrap();
    let error = named.start(Some("abvoe")).unwrap_err();
    assert_eq!(error.to_string(), "there is no start `abvoe`; the scene has above; did you mean `above`?");
}

#[test]
fn an_offset_magnitude_has_the_range_of_the_scene_file() {
    let scene = parse(SCENE).unwrap();
    for (value, words) in [
        (-1.0, "the offset magnitude must not be negative, got -1"),
        (10.5, "the offset magnitude must be at most 10 m, got 10.5"),
        (1e300, "the offset magnitude must be at most 10 m, got 1e300"),
        (f64::NAN, "the offset magnitude must be a finite number, got NaN"),
        (f64::INFINITY, "the offset magnitude must be a finite number, got inf"),
        (f64::NEG_INFINITY, "the offset magnitude must be a finite number, got -inf"),
    ] {
        assert_eq!(scene.task(None, Some(value)).unwrap_err().to_string(), words);
        assert_eq!(scene.grasps(value).unwrap_err().to_string(), words);
    }
    assert_eq!(scene.task(None, Some(10.0)).unwrap().offsets()[0], [6.0, -8.0, 0.0]);
}

#[test]
fn limits_are_checked_for_the_magnitude_that_is_asked_for() {
    let limits = "[limits]\ntranslational_velocity = 0.3\n";
    let scene = parse(&format!("{SCENE}{limits}")).unwrap();
    assert!(scene.task(None, Some(0.1)).is_ok());
    let error = scene.task(None, Some(0.2)).unwrap_err();
    let TaskError::OutOfReach { magnitude, reason } = &error else { panic!("{error}") };
    assert_eq!((*magnitude, reason.key, reason.value), (0.2, "translational_velocity", 0.3));
    assert!(
        error
            .to_string()
            .starts_with("with an offset magnitude of 0.2 m, limits.translational_velocity = 0.3: the goal is 0.160 m"),
        "{error}"
    );
    let written = parse(&format!("{SCENE}{limits}").replace("magnitude = 0.02", "magnitude = 0.2")).unwrap_err();
    assert_eq!(written.message(), reason.to_string());
}

#[test]
fn extreme_scenes_within_the_ranges_are_resolved_and_read_again() {
    for (from, to) in [
        ("[[body.part]]", "[body]\nmass = 1e6\ninertia = [1e-12, 1e6, 1]\n[[body.part]]"),
        ("[[body.part]]", "[body]\nmass = 1e-6\ninertia = [[1, 0.5, 0], [0.5, 1, 0], [0, 0, 1e-9]]\n[[body.part]]"),
        ("box = [0.1, 0.1, 0.1]", "box = [1, 1e-5, 1]"),
        ("box = [0.1, 0.1, 0.1]", "box = [999, 999, 999]"),
        (
            "translational_stiffness = 50.0\nrotational_stiffness = 5.0",
            "translational_stiffness = 1e7\nrotational_stiffness = 1e-3",
        ),
        ("time_step = 0.04", "time_step = 1e-5"),
    ] {
        let scene = parse(&replaced(from, to)).unwrap_or_else(|error| panic!("{error}"));
        let text = resolved(&scene, &scene.starts[0], scene.offset_magnitude, &default_homotopy());
        let again = parse(&text).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(
            (&again.inertia, &again.impedance, again.horizon),
            (&scene.inertia, &scene.impedance, scene.horizon)
        );
    }
}
