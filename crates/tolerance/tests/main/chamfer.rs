//! Scenes with a chamfer at the mouth of their hole.

use nalgebra::Vector3;
use plan::Problem;
use scene::{Part, Scene};
use scene_templates::{Peg, PegKey, PegSection};
use tolerance::chamfer::chamfered;
use tolerance::{Mouth, Quantity, ToleranceRequest, boundary};

use crate::boundaries::with_trials;
use crate::{SLOT, moved_down, problem};

const WIDTH: f64 = 0.001;

fn round() -> PegSection {
    PegSection::Round { diameter: 0.01, facets: 8, key: None }
}

fn rectangular(key: Option<PegKey>) -> PegSection {
    PegSection::Rectangular { width: 0.01, depth: 0.014, key }
}

/// The problem of a generated peg in its hole, both with a chamfer of some width (m).
fn generated(section: PegSection, chamfer: f64) -> Problem {
    let peg = Peg { section, length: 0.04, clearance: 0.0005, chamfer, offset: Some(0.001) };
    problem(&peg.scene().unwrap())
}

fn mouth(scene: &Scene) -> Option<Mouth> {
    Mouth::of(scene, &Vector3::z())
}

/// Halfspaces, in an order that does not depend on how a shape was made.
fn halfspaces(part: &Part) -> Vec<[f64; 4]> {
    let faces = part.shape.normals().iter().zip(part.shape.offsets());
    let mut all: Vec<[f64; 4]> = faces.map(|([x, y, z], offset)| [*x, *y, *z, *offset]).collect();
    let rounded = |face: &[f64; 4]| face.map(|number| (1e6 * number).round() as i64);
    all.sort_by_key(rounded);
    all
}

#[test]
fn grown_chamfers_are_those_of_generated_holes() {
    for section in [round(), rectangular(None)] {
        let (sharp, chamfer) = (generated(section.clone(), 0.0), generated(section.clone(), WIDTH));
        let found = mouth(sharp.scene()).unwrap();
        // The walls are 24 mm deep, and two fifths of the diameter thick.
        assert!(found.most > 0.0019 && found.most < 0.0045, "{section:?}: {}", found.most);
        let grown = chamfered(sharp.scene(), &found, WIDTH).unwrap();
        assert_eq!(grown.environment.len(), chamfer.scene().environment.len());
        for (one, other) in grown.environment.iter().zip(&chamfer.scene().environment) {
            assert_eq!(one.name, other.name);
            let (found, expected) = (halfspaces(one), halfspaces(other));
            assert_eq!(found.len(), expected.len(), "{}", one.name);
            for (face, known) in found.iter().flatten().zip(expected.iter().flatten()) {
                assert!((face - known).abs() < 1e-6, "{}: {found:?} {expected:?}", one.name);
            }
        }
    }
}

#[test]
fn grown_and_generated_chamfers_have_the_same_boundaries() {
    let chamfer = generated(round(), WIDTH);
    // The peg with its chamfer, and a hole without one.
    let scene = Scene { environment: generated(round(), 0.0).scene().environment.clone(), ..chamfer.scene().clone() };
    let sharp = Problem::new(scene, None, None, chamfer.homotopy().clone()).unwrap();
    let request = ToleranceRequest { cases: 60, rate: 0.9, frictions: vec![0.0, 0.1], seed: 1 };
    let offset = |problem: &Problem, width: Option<f64>| {
        with_trials(problem, request.clone(), |trials, session| {
            let nominal = trials.nominal();
            let base = width.map_or(nominal, |width| nominal.with(Quantity::Chamfer, width));
            boundary(trials, &base, Quantity::Offset, session).unwrap().unwrap()
        })
    };
    let (of_generated, of_grown, of_sharp) =
        (offset(&chamfer, None), offset(&sharp, Some(WIDTH)), offset(&sharp, None));
    assert_eq!(of_grown, of_generated);
    let [more, less] = [of_grown, of_sharp].map(|boundary| boundary.value.unwrap());
    assert!(more > less + 0.0005, "the chamfer of the hole guides the peg in: {more}, {less} without");

    let needed = with_trials(&sharp, request.clone(), |trials, session| {
        let base = trials.nominal().with(Quantity::Offset, more);
        boundary(trials, &base, Quantity::Chamfer, session).unwrap().unwrap()
    });
    let value = needed.value.unwrap();
    let step = mouth(sharp.scene()).unwrap().most / 64.0;
    assert!(value <= WIDTH + step && value > 0.0, "{value} for what {WIDTH} tolerates");
    assert!(needed.interval[1].unwrap() < value, "{needed:?}");
}

/// Four walls around a hole of 20 x 20 mm whose corners belong to two of them, and a post on the rim.
const FRAME: &str = "\
[[environment.part]]\nname = \"left\"\nbox = [0.06, 0.02, 0.04]\nposition = [0.0, 0.02, 0.0]\n\
[[environment.part]]\nname = \"right\"\nbox = [0.06, 0.02, 0.04]\nposition = [0.0, -0.02, 0.0]\n\
[[environment.part]]\nname = \"front\"\nbox = [0.02, 0.02, 0.04]\nposition = [0.02, 0.0, 0.0]\n\
[[environment.part]]\nname = \"back\"\nbox = [0.02, 0.02, 0.04]\nposition = [-0.02, 0.0, 0.0]\n\
[[environment.part]]\nname = \"post\"\nbox = [0.02, 0.004, 0.01]\nposition = [0.0, 0.013, 0.025]\n";

fn is_inside(scene: &Scene, point: &Vector3<f64>) -> bool {
    scene.environment.iter().any(|part| {
        let mut faces = part.shape.normals().iter().zip(part.shape.offsets());
        faces.all(|(normal, offset)| Vector3::from(*normal).dot(point) <= *offset)
    })
}

#[test]
fn exactly_the_frustum_is_cut_off() {
    let problem = moved_down([0.018, 0.018, 0.03], FRAME);
    let scene = problem.scene();
    let width = 0.004;
    let grown = chamfered(scene, &mouth(scene).unwrap(), width).unwrap();
    let mut rng = fastrand::Rng::with_seed(1);
    let mut removed = 0;
    for _ in 0..20_000 {
        let [x, y] = [(); 2].map(|()| 0.034 * (rng.f64() - 0.5));
        let point = Vector3::new(x, y, 0.021 - 0.01 * rng.f64());
        let depth = 0.02 - point.z;
        let is_cut = depth > 0.0 && x.abs().max(y.abs()) < 0.01 + width - depth;
        assert_eq!(is_inside(&grown, &point), is_inside(scene, &point) && !is_cut, "{point}");
        removed += usize::from(is_inside(scene, &point) && is_cut);
    }
    assert!(removed > 500, "{removed}");
    let names: Vec<&str> = grown.environment.iter().map(|part| part.name.as_str()).collect();
    assert_eq!(names[..5], ["left", "right", "front", "back", "post"], "parts stay, and pieces of corners follow");
}

#[test]
fn other_surroundings_have_no_mouth() {
    assert!(mouth(moved_down([0.018, 0.018, 0.03], FRAME).scene()).is_some());
    for (what, parts) in [
        ("a slot", SLOT.to_owned()),
        ("corners that are open", FRAME.replace("box = [0.02, 0.02, 0.04]", "box = [0.02, 0.019, 0.04]")),
        ("a rim of two heights", FRAME.replacen("box = [0.02, 0.02, 0.04]", "box = [0.02, 0.02, 0.05]", 1)),
    ] {
        assert_eq!(mouth(moved_down([0.018, 0.018, 0.03], &parts).scene()), None, "{what}");
    }
    let key = PegKey { width: 0.003, height: 0.002 };
    assert_eq!(mouth(generated(rectangular(Some(key)), 0.0).scene()), None, "a section that is not convex");
    assert_eq!(mouth(generated(round(), WIDTH).scene()), None, "a chamfer that is there");
    let tilted = Vector3::new(0.01, 0.0, 1.0).normalize();
    assert_eq!(Mouth::of(generated(round(), 0.0).scene(), &tilted), None, "sides that are not along the way out");
}

#[test]
fn chamfers_that_are_too_large_or_no_number_are_refused() {
    with_trials(&generated(round(), 0.0), ToleranceRequest::default(), |trials, _| {
        for width in [0.1, -0.001, f64::NAN] {
            let error = trials.scene_with_chamfer(width).unwrap_err().to_string();
            assert!(error.starts_with("chamfer = ") && error.contains("must lie between 0 and 0.00"), "{error}");
        }
    });
}
