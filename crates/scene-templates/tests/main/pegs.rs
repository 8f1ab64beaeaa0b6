//! Generated pegs: scenes that load, with parts that are convex, apart, and as far apart as was asked for.

use std::f64::consts::TAU;

use proptest::prelude::*;
use scene::{Scene, scene_schema};
use scene_templates::{Peg, PegKey, PegSection};
use task::Pose;

use crate::parse;

/// A corner in a section (m).
type Point = [f64; 2];

fn load(peg: &Peg) -> (Scene, toml::Table) {
    let text = peg.scene().unwrap_or_else(|error| panic!("{peg:?}: {error}"));
    let scene = parse(&text).unwrap_or_else(|error| panic!("{peg:?}: {error}"));
    assert!(scene.warnings.is_empty(), "{:?}", scene.warnings);
    (scene, toml::from_str(&text).unwrap())
}

fn round(facets: usize, key: Option<PegKey>) -> Peg {
    let section = PegSection::Round { diameter: 0.008, facets, key };
    Peg { section, length: 0.04, clearance: 3e-4, chamfer: 5e-4, offset: None }
}

fn rectangular(key: Option<PegKey>) -> Peg {
    Peg { section: PegSection::Rectangular { width: 0.01, depth: 0.006, key }, ..round(8, None) }
}

fn random(seed: u64, prisms: usize, facets: usize) -> Peg {
    let section = PegSection::Random { seed, prisms, facets, diameter: 0.09 };
    Peg { section, length: 0.1, clearance: 8e-4, chamfer: 0.0, offset: None }
}

const KEY: PegKey = PegKey { width: 0.002, height: 0.001 };

fn any_peg() -> impl Strategy<Value = Peg> {
    let keys = || prop_oneof![Just(None), (0.2..0.7f64, 0.1..0.5f64).prop_map(Some)];
    let sized = |key: Option<(f64, f64)>, width: f64| {
        key.map(|(part, height)| PegKey { width: part * width, height: height * width })
    };
    let round = (4usize..9, keys())
        .prop_map(move |(facets, key)| (PegSection::Round { diameter: 0.008, facets, key: sized(key, 0.008) }, 0.008));
    let rectangular = (0.004..0.02f64, 0.005..0.02f64, keys()).prop_map(move |(width, depth, key)| {
        (PegSection::Rectangular { width, depth, key: sized(key, depth) }, width.min(depth))
    });
    let random = (any::<u64>(), 1usize..4, 0usize..3).prop_map(|(seed, prisms, more)| {
        let facets = 4 + 2 * (prisms - 1) + more;
        (PegSection::Random { seed, prisms, facets, diameter: 0.09 }, 0.09)
    });
    let sections = prop_oneof![round, rectangular, random];
    (sections, 1.0..5.0f64, 0.005..0.02f64, prop_oneof![Just(0.0), 0.005..0.03f64]).prop_map(
        |((section, width), length, clearance, chamfer)| {
            let (length, clearance, chamfer) = (length * width, clearance * width, chamfer * width);
            Peg { section, length, clearance, chamfer, offset: None }
        },
    )
}

/// The corners that a scene lists for its parts.
fn listed<'scene>(scene: &'scene toml::Table, parent: &str) -> Vec<&'scene Vec<toml::Value>> {
    let parts = scene[parent]["part"].as_array().unwrap();
    parts.iter().map(|part| part["vertices"].as_array().unwrap()).collect()
}

/// Counterclockwise corners of each part's section at the height of one of its ends.
fn sections(parts: &[scene::Part], is_top: bool) -> Vec<Vec<Point>> {
    let section = |part: &scene::Part| {
        let heights = part.shape.vertices().iter().map(|vertex| vertex[2]);
        let end = if is_top { heights.fold(f64::MIN, f64::max) } else { heights.fold(f64::MAX, f64::min) };
        let corners = part.shape.vertices().iter().filter(|vertex| (vertex[2] - end).abs() < 1e-9);
        let mut corners: Vec<Point> = corners.map(|vertex| [vertex[0], vertex[1]]).collect();
        let count = corners.len() as f64;
        let [x, y] = corners.iter().fold([0.0; 2], |[x, y], corner| [x + corner[0] / count, y + corner[1] / count]);
        corners.sort_by(|a, b| (a[1] - y).atan2(a[0] - x).total_cmp(&(b[1] - y).atan2(b[0] - x)));
        corners
    };
    parts.iter().map(section).collect()
}

/// Euclidean distance of two polygons that do not overlap.
fn distance(one: &[Point], other: &[Point]) -> f64 {
    let to_edges = |corners: &[Point], polygon: &[Point]| {
        let edges = (0..polygon.len()).map(|index| (polygon[index], polygon[(index + 1) % polygon.len()]));
        let pairs = edges.flat_map(|edge| corners.iter().map(move |corner| to_segment(*corner, edge)));
        pairs.fold(f64::INFINITY, f64::min)
    };
    to_edges(one, other).min(to_edges(other, one))
}

fn to_segment([x, y]: Point, ([x1, y1], [x2, y2]): (Point, Point)) -> f64 {
    let (dx, dy) = (x2 - x1, y2 - y1);
    let part = (((x - x1) * dx + (y - y1) * dy) / (dx * dx + dy * dy)).clamp(0.0, 1.0);
    (x - x1 - part * dx).hypot(y - y1 - part * dy)
}

/// Smallest distance with the peg moved away from its goal.
fn clearance_at(scene: &Scene, [x, y, z]: [f64; 3]) -> f64 {
    scene.task(None, None).unwrap().clearance(&Pose([x, y, z, 1.0, 0.0, 0.0, 0.0]))
}

fn around() -> impl Iterator<Item = Point> {
    (0..24).map(|index| TAU * index as f64 / 24.0).map(|angle| [angle.cos(), angle.sin()])
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(60))]

    #[test]
    fn a_generated_peg_fits_into_its_hole_with_the_gap_that_was_asked_for(peg in any_peg()) {
        // Some random sections are hard to find.
        let is_random = matches!(peg.section, PegSection::Random { .. });
        prop_assume!(!is_random || peg.scene().is_ok());
        let (scene, text) = load(&peg);
        // Each listed corner is one of a convex part; those of random walls may be too near to an edge.
        for (parent, parts) in [("body", &scene.body), ("environment", &scene.environment)] {
            for (part, corners) in parts.iter().zip(listed(&text, parent)) {
                let count = part.shape.vertices().len();
                prop_assert!(count == corners.len() || is_random && count < corners.len(), "{}", part.name);
            }
        }
        for start in &scene.starts {
            let task = scene.task(Some(&start.name), None).unwrap();
            for grasp in &task.grasps {
                prop_assert!(task.clearance(&grasp.actual(&start.pose)) > 0.0);
            }
        }
        prop_assert!(clearance_at(&scene, [0.0; 3]) > 0.0);
        // Between the shaft of the peg and the inside of every wall.
        let peg_sections = sections(&scene.body, true);
        for (wall, name) in sections(&scene.environment, false).iter().zip(&scene.environment) {
            let gap = peg_sections.iter().map(|section| distance(section, wall)).fold(f64::INFINITY, f64::min);
            prop_assert!((gap - peg.clearance).abs() < 1e-9, "{}: {gap}", name.name);
        }
        // There is no way out to any side, and in a hole that is not concave no way is shut.
        for [x, y] in around() {
            let moved = |distance: f64| clearance_at(&scene, [distance * x, distance * y, 0.0]);
            prop_assert!(moved(5.0 * peg.clearance) < 0.0, "open towards ({x}, {y})");
            prop_assert!(scene.body.len() > 1 || moved(0.9 * peg.clearance) > 0.0, "shut towards ({x}, {y})");
        }
    }
}

#[test]
fn chamfers_lead_in() {
    for peg in [round(8, None), rectangular(None), round(6, Some(KEY)), Peg { chamfer: 0.002, ..random(1, 2, 7) }] {
        let blunt = Peg { chamfer: 0.0, ..peg.clone() };
        // The lower end is half a chamfer below the upper edge of the hole.
        let clearance = |peg: &Peg, x: f64, y: f64, chamfer: f64| {
            let aside = peg.clearance + 1.3 * chamfer;
            clearance_at(&load(peg).0, [aside * x, aside * y, 0.5 * peg.length - 0.5 * chamfer])
        };
        for [x, y] in around().step_by(6) {
            assert!(clearance(&peg, x, y, peg.chamfer) > 0.0, "{peg:?}");
            assert!(clearance(&blunt, x, y, peg.chamfer) < 0.0, "{peg:?}");
        }
    }
}

#[test]
fn parts_have_names_that_say_what_they_are() {
    let names = |peg: &Peg| {
        let (scene, _) = load(peg);
        let names = |parts: &[scene::Part]| parts.iter().map(|part| part.name.clone()).collect::<Vec<_>>().join(" ");
        (names(&scene.body), names(&scene.environment))
    };
    assert_eq!(names(&round(3, None)), ("shaft".to_owned(), "wall1 wall2 wall3".to_owned()));
    let (body, environment) = names(&rectangular(Some(KEY)));
    assert_eq!(body, "shaft key");
    assert_eq!(environment, "wall1 wall2 wall3 wall4 keyway1 keyway2 keyway3 wall5");
    assert_eq!(names(&random(1, 2, 7)).0, "prism1 prism2");
}

#[test]
fn a_round_peg_is_inside_its_prism_and_the_hole_inside_the_round_hole_that_is_named() {
    let peg = round(12, None);
    let (scene, _) = load(&peg);
    let shaft = &sections(&scene.body, true)[0];
    let facet = |index: usize| (shaft[index], shaft[(index + 1) % shaft.len()]);
    let nearest = (0..shaft.len()).map(|index| to_segment([0.0; 2], facet(index))).fold(f64::INFINITY, f64::min);
    assert!((nearest - 0.004).abs() < 1e-9, "{nearest}");
    let hole = 2.0 * (nearest + peg.clearance) / (TAU / 24.0).cos();
    assert!(peg.scene().unwrap().contains(&format!("a round hole of {hole:.6} m")));
}

#[test]
fn the_same_seed_gives_the_same_file() {
    let text = |seed: u64| random(seed, 3, 8).scene().unwrap();
    assert_eq!(text(7), text(7));
    assert_ne!(text(7).replace("seed 7", ""), text(8).replace("seed 8", ""));
    let (scene, _) = load(&random(7, 3, 8));
    assert_eq!((scene.body.len(), scene.environment.len(), scene.starts.len()), (3, 8, 5));
}

#[test]
fn generated_scenes_are_valid_by_the_schema() {
    let validator = jsonschema::draft202012::new(&scene_schema()).unwrap();
    for peg in [round(8, Some(KEY)), rectangular(None), random(1, 1, 6)] {
        assert!(validator.is_valid(&serde_json::to_value(load(&peg).1).unwrap()));
    }
}

#[test]
fn sizes_that_are_not_possible_are_refused() {
    let key = |width: f64, height: f64| Some(PegKey { width, height });
    let (small, odd) = (rectangular(None), random(1, 4, 7));
    #[rustfmt::skip]
    let wrong = [
        (Peg { length: 0.0, ..small.clone() }, "length = 0: must lie between 0.001 and 1 m"),
        (Peg { length: f64::NAN, ..small.clone() }, "length = NaN"),
        (Peg { clearance: 0.2, ..small.clone() }, "clearance = 0.2: must lie between 1e-6 and 0.1 m"),
        (Peg { chamfer: -1e-3, ..small.clone() }, "chamfer = -0.001: must lie between 0 and 0.01 m, a quarter of the length"),
        (Peg { chamfer: 0.003, ..small.clone() }, "chamfer = 0.003: edges of the section would vanish"),
        (Peg { offset: Some(0.1), ..small.clone() }, "offset = 0.1: must be above 0 and at most 0.003 m"),
        (Peg { offset: Some(0.0), ..small.clone() }, "offset = 0: must be above 0"),
        (round(2, None), "facets = 2: must lie between 3 and 64"),
        (rectangular(key(0.0061, 0.001)), "key width = 0.0061: must be above 0 and at most 0.006 m"),
        (rectangular(key(0.005, 0.001)), "key width = 0.005: leaves too little of the peg's side beside the key"),
        (round(8, key(0.0075, 0.001)), "key width = 0.0075: leaves too little"),
        (rectangular(key(0.001, 1.0)), "key height = 1: must be above 0 and at most 0.006 m"),
        (random(1, 9, 30), "prisms = 9: must lie between 1 and 8"),
        (random(1, 0, 6), "prisms = 0: must lie between 1 and 8"),
        (odd, "prisms = 4: hardly any section has this many, 7 facets and these sizes"),
        (Peg { length: 0.4, chamfer: 0.08, ..random(1, 2, 8) }, "prisms = 2: hardly any section"),
    ];
    for (peg, words) in wrong {
        let error = peg.scene().expect_err(words).to_string();
        assert!(error.contains(words), "{error}");
    }
}
