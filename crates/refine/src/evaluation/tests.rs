//! Tests of evaluations.

use plan::Choices;
use plan::parameters::Seeds;

use super::*;
use crate::tests::corner;

fn no_errors() -> ErrorRange {
    ErrorRange {
        coverage: Coverage::Hull,
        offset_magnitude: 0.0,
        rotation_error: 0.0,
        inertia: 0.0,
        stiffness: 0.0,
        delay: 0.0,
        bias: [0.0; 2],
        edge_radius: 0.0,
        evaluation: EvaluationParameters::default(),
        disturbance_seed: Seeds::default().disturbance,
    }
}

/// An evaluation of one friction: two planned offsets, then `count` random ones of one magnitude.
fn evaluation(count: usize) -> Evaluation {
    let group = |planned| SuccessRate::unplayed(0.0, 0.01, OffsetRegion::Hull, planned);
    let case =
        TestCase { friction: FrictionIndex(0), grasp: GraspError::default(), disturbance: Disturbance::default() };
    let numbers = [vec![0; 2], vec![1; count]].concat();
    let (groups, cases) = (vec![group(true), group(false)], vec![case; numbers.len()]);
    Evaluation { drawn: Drawn::default(), parameters: EvaluationParameters::default(), groups, cases, group: numbers }
}

/// What is drawn of a range in a task with two frictions: groups, and offsets of each with how they are counted.
fn drawn(range: &ErrorRange, count: usize) -> Vec<(SuccessRate, Vec<Vector3<f64>>)> {
    let problem = Problem::load(&corner(), &Choices::default()).unwrap();
    let Evaluation { groups, cases, group, .. } = Evaluation::new(problem.task(), range, &[0.0, 0.3], count, 1);
    let offsets_of = |index: usize| {
        let of_group = cases.iter().zip(&group).filter(|(_, of)| **of == index);
        of_group.map(|(case, _)| Vector3::from(case.grasp.offset)).collect()
    };
    (0..groups.len()).map(|index| (groups[index].clone(), offsets_of(index))).collect()
}

#[test]
fn a_disc_is_evaluated_inside_and_on_its_rim_with_as_many_offsets_as_a_hull() {
    let axis = [0.0, 0.0, 1.0];
    let range = ErrorRange { coverage: Coverage::Disc { axis }, offset_magnitude: 0.01, ..no_errors() };
    let groups = drawn(&range, 100);
    let names: Vec<(f64, OffsetRegion, bool, usize)> =
        groups.iter().map(|(group, offsets)| (group.friction, group.region, group.planned, offsets.len())).collect();
    let of_friction = |friction: f64| {
        let planned = (friction, OffsetRegion::Rim, true, 2);
        [(friction, OffsetRegion::Inside, false, 250), (friction, OffsetRegion::Rim, false, 250), planned]
    };
    assert_eq!(names, [of_friction(0.0), of_friction(0.3)].concat());
    for (group, offsets) in groups.iter().filter(|(group, _)| !group.planned) {
        let across = |offset: &Vector3<f64>| offset.xy().norm();
        let (least, most) = offsets
            .iter()
            .map(across)
            .fold((f64::INFINITY, 0.0_f64), |(least, most), length| (least.min(length), most.max(length)));
        assert!(most > 0.0098 && most <= 0.0105 + 1e-12, "{most}");
        assert_eq!(least > 0.0094, group.region == OffsetRegion::Rim, "{least}");
        assert!(offsets.iter().all(|offset| offset.z.abs() <= 0.0005 + 1e-12), "the spread");
        assert_eq!(group.magnitude_m, 0.01);
    }
    let training = drawn(&range, 1);
    let counts: Vec<usize> = training.iter().map(|(_, offsets)| offsets.len()).collect();
    assert_eq!(counts, [2, 3, 2, 2, 3, 2]);
}

#[test]
fn offsets_in_a_hull_are_drawn_as_in_earlier_versions() {
    // Plans of earlier versions are evaluated with the same offsets as then.
    let range = ErrorRange { offset_magnitude: 0.01, ..no_errors() };
    let groups = drawn(&range, 100);
    let magnitudes: Vec<f64> = groups.iter().map(|(group, _)| group.magnitude_m).collect();
    assert_eq!(magnitudes[..6], [0.0, 0.0025, 0.005, 0.0075, 0.0095, 0.01]);
    let sums = [
        [-2.011_066_896e-4, -1.157_222_648e-3, -3.159_207_880e-4],
        [0.257_816_654, 2.318_044_508e-3, 0.245_468_966],
        [0.528_335_143, 6.519_431_348e-4, 0.470_115_280],
        [0.719_052_698, -2.767_080_487e-4, 0.783_203_309],
        [0.990_368_947, -2.615_411_064e-3, 0.913_341_318],
        [0.02, 0.0, 0.02],
    ];
    for ((group, offsets), sum) in groups.iter().zip(sums.iter().cycle()) {
        let difference = offsets.iter().sum::<Vector3<f64>>() - Vector3::from(*sum);
        assert!(difference.norm() < 1e-9 && group.region == OffsetRegion::Hull, "{group:?}: {offsets:?}");
    }
}

#[test]
fn training_turns_the_part_as_far_as_may_be_about_axes_in_all_directions() {
    let range = ErrorRange { rotation_error: 0.02, ..no_errors() };
    let cases = evaluation(15).into_training(&range);
    let turns: Vec<Vector3<f64>> = cases.iter().map(|case| case.grasp.rotation.into()).collect();
    let (planned, random) = turns.split_at(2);
    assert_eq!(planned, [Vector3::zeros(); 2], "planned errors are as they are planned");
    assert!(random.iter().all(|rotation| (rotation.norm() - 0.02).abs() < 1e-12));
    // Any direction is near one of all of them, and not far from one of five in a row.
    for direction in range.turns(500, 1).into_iter().map(Vector3::from) {
        let nearest = |turns: &[Vector3<f64>]| {
            turns.iter().map(|rotation| rotation.angle(&direction).to_degrees()).fold(f64::INFINITY, f64::min)
        };
        assert!(nearest(random) < 60.0, "{direction:?}");
        assert!(random.chunks(5).all(|few| nearest(few) < 90.0), "{direction:?}");
    }
}

#[test]
fn evaluations_turn_the_part_as_far_as_may_be() {
    let range = ErrorRange { rotation_error: 0.02, ..no_errors() };
    assert!(range.turns(50, 3).iter().all(|rotation| (Vector3::from(*rotation).norm() - 0.02).abs() < 1e-12));
    assert_eq!(no_errors().turns(1, 3), [[0.0; 3]]);
}

#[test]
fn errors_fill_their_range() {
    let range = ErrorRange { inertia: 0.1, stiffness: 0.2, delay: 0.003, edge_radius: 1e-4, ..no_errors() };
    let mut random = Rng::with_seed(1);
    let drawn: Vec<Disturbance> = (0..200).map(|_| range.disturbance(&mut random)).collect();
    let extremes = |of: fn(&Disturbance) -> f64| {
        let values = drawn.iter().map(of);
        (values.clone().fold(f64::INFINITY, f64::min), values.fold(f64::NEG_INFINITY, f64::max))
    };
    for (of, least, most) in [
        (extremes(|drawn| drawn.inertia), -0.1, 0.1),
        (extremes(|drawn| drawn.stiffness), -0.2, 0.2),
        (extremes(|drawn| drawn.delay), 0.0, 0.003),
        (extremes(|drawn| drawn.edge_radius), 0.0, 1e-4),
    ] {
        let margin = 0.05 * (most - least);
        assert!(least <= of.0 && of.0 < least + margin && most - margin < of.1 && of.1 <= most, "{of:?}");
    }
}

fn played(groups: &[SuccessRate], counts: [(usize, usize); 2]) -> Vec<SuccessRate> {
    let count =
        |(group, (rollouts, successes)): (&SuccessRate, _)| SuccessRate { rollouts, successes, ..group.clone() };
    groups.iter().zip(counts).map(count).collect()
}

#[test]
fn an_evaluation_is_lost_when_what_is_left_cannot_save_it() {
    let evaluation = evaluation(98);
    let can_be =
        |overall, counts| evaluation.can_satisfy(&played(&evaluation.groups, counts), Wanted { each: 0.99, overall });
    assert!(can_be(0.0, [(2, 2), (10, 9)]), "one of a hundred may fail");
    assert!(!can_be(0.0, [(2, 2), (10, 8)]), "two may not");
    assert!(!can_be(0.0, [(2, 1), (0, 0)]), "every planned offset has to succeed");
    assert!(can_be(0.99, [(2, 2), (10, 9)]) && !can_be(0.995, [(2, 2), (10, 9)]), "as often as another plan");
}

/// The judgement of an evaluation of 500 random offsets after `passes` successes and then `failures`.
fn judged(wanted: Wanted, passes: usize, failures: usize) -> bool {
    let result = |passed| TestResult {
        passed,
        violation: 0.0,
        contact_force: 0.0,
        remaining_shift: Vector3::zeros(),
        unblocked_shift: Vector3::zeros(),
        remaining_rotation: Vector3::zeros(),
        overshoot: None,
    };
    let results = [vec![result(true); passes], vec![result(false); failures]].concat();
    evaluation(500).judgement(&results, wanted).reached
}

#[test]
fn an_evaluation_is_decided_once_the_rate_is_shown() {
    let wanted = |each, overall| Wanted { each, overall };
    let target = wanted(0.99, 0.0);
    assert!(judged(target, 2 + 299, 0) && !judged(target, 2 + 298, 0), "two of them are planned offsets");
    assert!(!judged(target, 2 + 299, 1), "one failure takes the whole evaluation");
    assert!(judged(target, 2 + 495, 5) && !judged(target, 2 + 494, 6), "the whole evaluation");
    assert!(
        judged(wanted(0.99, 1.0), 2 + 299, 0) && !judged(wanted(0.99, 1.0), 2 + 498, 1),
        "as often as another plan"
    );
    assert!(!judged(wanted(0.5, 0.0), 200, 0) && judged(wanted(0.5, 0.0), 240, 0), "at least some rollouts");
}
