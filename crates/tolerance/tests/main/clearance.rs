//! Scenes with another clearance.

use nalgebra::Vector3;
use plan::engagement;
use proptest::prelude::*;
use tolerance::clearance::widened;

use crate::{SLOT, moved_down};

fn clearance_of(more: f64, size: [f64; 3]) -> f64 {
    let problem = moved_down(size, SLOT);
    let out = Vector3::from(problem.engagement().out);
    let scene = widened(problem.scene(), &out, more).unwrap();
    engagement(&scene.task(None, None).unwrap()).clearance_m.unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20))]

    #[test]
    fn clearance_changes_by_what_is_asked(more in -0.0019..0.004_f64, width in 0.012..0.018_f64) {
        let found = clearance_of(more, [0.02, width, 0.02]);
        prop_assert!((found - (0.02 - width + more)).abs() < 1e-5, "{found}");
    }
}

#[test]
fn lengths_along_the_insertion_and_faces_between_parts_stay() {
    // Two halves of the box, with a common face, and a slope of 45 degrees above them.
    let parts = "[[body.part]]\nname = \"half\"\nbox = [0.02, 0.018, 0.02]\nposition = [0.02, 0.0, 0.0]\n\
        [[body.part]]\nname = \"slope\"\nvertices = [[-0.01, -0.009, 0.01], [-0.01, 0.009, 0.01], [0.03, -0.009, 0.01], \
        [0.03, 0.009, 0.01], [-0.001, 0.0, 0.019], [0.021, 0.0, 0.019]]\n";
    let problem = moved_down([0.02, 0.018, 0.02], &format!("{parts}{SLOT}"));
    let scene = widened(problem.scene(), &Vector3::z(), 0.002).unwrap();
    let bounds = |part: usize, axis: usize| {
        let coordinates = scene.body[part].shape.vertices().iter().map(|vertex| vertex[axis]);
        coordinates.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], value| [low.min(value), high.max(value)])
    };
    let near =
        |[low, high]: [f64; 2], [first, second]: [f64; 2]| (low - first).abs() < 1e-9 && (high - second).abs() < 1e-9;
    assert!(near(bounds(0, 0), [-0.009, 0.01]), "the face between the halves stays: {:?}", bounds(0, 0));
    assert!(near(bounds(1, 0), [0.01, 0.029]), "{:?}", bounds(1, 0));
    assert!(near(bounds(0, 1), [-0.008, 0.008]) && near(bounds(0, 2), [-0.01, 0.01]));
    let normal = |from: &scene::Scene| from.body[2].shape.normals().to_vec();
    assert_eq!(normal(&scene).len(), normal(problem.scene()).len(), "slopes keep their angles");
}

#[test]
fn nothing_is_left_of_a_part_that_is_thinner_than_what_is_taken() {
    let problem = moved_down([0.02, 0.018, 0.02], SLOT);
    let (part, _) = widened(problem.scene(), &Vector3::z(), 0.02).unwrap_err();
    assert_eq!(part, "box");
}
