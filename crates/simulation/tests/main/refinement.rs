//! References evaluated and refined.

use std::sync::atomic::{AtomicUsize, Ordering};

use nalgebra::Vector3;
use simulation::{
    Disturbance, Evaluator, FinalOscillation, FrictionIndex, Perturbation, Reference, Refinement, Rollout, Settings,
    Success, TestCase, TestResult,
};
use task::{GraspError, Horizon, Pose, StraightMotion};
use workers::Workers;

use crate::world::{STIFFNESS, at_rest, block, floor, hole, task, through};

const WIDTH: f64 = 0.04;

fn evaluator() -> Evaluator {
    let world = task(&block([WIDTH, WIDTH, 0.08], [0.0; 3]), &hole(WIDTH + 0.002));
    Evaluator::new(&world, &[0.0, 0.1], Success::default())
}

/// Straight down beside the hole: the body comes to rest on the rim.
fn beside() -> Reference {
    through(&[[0.0015, 0.0, 0.06], [0.0015, 0.0, 0.0]], 1.0)
}

fn cases() -> Vec<TestCase> {
    let offsets = [[0.0; 3], [0.0005, 0.0, 0.0], [-0.0005, 0.0, 0.0]];
    (0..2)
        .flat_map(|friction| {
            offsets.map(|offset| TestCase {
                friction: FrictionIndex(friction),
                grasp: offset.into(),
                disturbance: Disturbance::default(),
            })
        })
        .collect()
}

fn refinement(evaluator: &Evaluator, seed: u64) -> Refinement<'_> {
    let results = evaluator.evaluate_all(&beside(), &cases(), &|| false).unwrap();
    Refinement::new(evaluator, beside(), cases(), results, seed)
}

#[test]
fn what_fails_is_refined_until_it_passes() {
    let evaluator = evaluator();
    let mut refinement = refinement(&evaluator, 1);
    assert!(refinement.score().0 > 0, "the plain reference fails");
    for _ in 0..300 {
        if refinement.score().0 == 0 {
            break;
        }
        let before = refinement.score();
        let improved = refinement.improve(&|| false);
        let after = refinement.score();
        assert_eq!(improved, after.0 < before.0 || after.0 == before.0 && after.1 < before.1);
    }
    assert_eq!(refinement.score().0, 0);
    let results = evaluator.evaluate_all(refinement.reference(), &cases(), &|| false).unwrap();
    assert!(results.iter().all(|result| result.passed && result.violation == 0.0));
}

/// Changes a reference, and compares what is known of the test cases with whole rollouts of what has become of it. Returns how many
/// changes were kept.
pub fn assert_records_are_whole_rollouts(evaluator: &Evaluator, mut refinement: Refinement, changes: usize) -> usize {
    let mut improvements = 0;
    for _ in 0..changes {
        if refinement.improve(&|| false) {
            improvements += 1;
            let results = evaluator.evaluate_all(refinement.reference(), refinement.cases(), &|| false).unwrap();
            let failing = results.iter().filter(|result| !result.passed);
            assert_eq!(refinement.score(), (failing.clone().count(), failing.map(|result| result.violation).sum()));
        }
    }
    improvements
}

#[test]
fn rollouts_that_go_on_from_earlier_ones_are_like_whole_ones() {
    let evaluator = evaluator();
    let play = |seed| assert_records_are_whole_rollouts(&evaluator, refinement(&evaluator, seed), 20);
    let improvements: usize = (2..8).map(play).sum();
    assert!(improvements > 5, "{improvements}");
}

#[test]
fn references_share_the_intervals_before_a_change() {
    let reference = beside();
    let last = reference.intervals();
    assert_eq!(reference.shared_intervals(&reference), last);
    assert_eq!(reference.shared_intervals(&through(&[[0.0; 3]; 2], 2.0)), 0);
    let (mut random, success) = (fastrand::Rng::with_seed(7), Success::default());
    for _ in 0..50 {
        let perturbation = Perturbation::random(&mut random, &success);
        let changed = (0..=last).position(|knot| perturbation.weight(knot as f64 / last as f64) > 0.0);
        assert_eq!(
            reference.shared_intervals(&reference.perturbed(&perturbation)),
            changed.map_or(last, |first| first - 1)
        );
        let late = Perturbation::late(&mut random, &success);
        assert!(2 * reference.shared_intervals(&reference.perturbed(&late)) >= last, "{late:?}");
    }
}

#[test]
fn refinement_does_not_depend_on_threads_and_can_be_stopped() {
    let refine = |threads: usize, stop: bool| {
        let evaluator = evaluator().with_workers(Workers::new(threads));
        let mut refinement = refinement(&evaluator, 3);
        (0..10).for_each(|_| {
            refinement.improve(&|| stop);
        });
        refinement.reference().clone()
    };
    assert_eq!(refine(1, false), refine(3, false));
    assert_eq!(refine(1, true), beside());
}

#[test]
fn changes_that_break_a_limit_are_refused() {
    let mut world = task(&block([WIDTH, WIDTH, 0.08], [0.0; 3]), &hole(WIDTH + 0.002));
    world.limits.translational_velocity = beside().limits_kept().translational_velocity;
    let limited = Evaluator::new(&world, &[0.0, 0.1], Success::default());
    let mut refinement = refinement(&limited, 1);
    (0..100).for_each(|_| {
        refinement.improve(&|| false);
    });
    assert!(limited.bounds().allow(refinement.reference()));
    let perturbed =
        |seed| beside().perturbed(&Perturbation::random(&mut fastrand::Rng::with_seed(seed), &Success::default()));
    assert!((0..20).any(|seed| !limited.bounds().allow(&perturbed(seed))), "there is something to be refused");
}

#[test]
fn a_push_beyond_the_limit_is_no_success() {
    let case =
        TestCase { friction: FrictionIndex(0), grasp: GraspError::default(), disturbance: Disturbance::default() };
    const DEPTH: f64 = 1e-3;
    let mut world = task(&block([WIDTH, WIDTH, 0.08], [0.0; 3]), &[floor()]);
    world.goal.0[2] = 0.04;
    let pressing = through(&[[0.0, 0.0, 0.04], [0.0, 0.0, 0.04 - DEPTH]], 1.0);
    let mut evaluate = |limit: f64, share: f64| {
        world.limits.contact_force = limit;
        let evaluator = Evaluator::new(&world, &[0.0], Success::default()).with_force_share(share);
        evaluator.evaluate(&pressing, &case)
    };
    assert!(evaluate(f64::INFINITY, 1.0).passed && evaluate(f64::INFINITY, 0.1).passed);
    let force = STIFFNESS * DEPTH;
    assert!(evaluate(1.2 * force, 1.0).passed);
    assert!(!evaluate(1.2 * force, 0.8).passed, "with a margin");
    let gentle = evaluate(0.5 * force, 1.0);
    assert!(!gentle.passed && (gentle.violation - 1.0).abs() < 0.01, "{gentle:?}");
    let overshoot = gentle.overshoot.expect("the force is too large");
    assert!((overshoot.shift - Vector3::new(0.0, 0.0, 0.5 * DEPTH)).norm() < 0.02 * DEPTH, "{overshoot:?}");
    assert!(overshoot.rotation.norm() < 1e-6 && overshoot.fraction > 0.9, "{overshoot:?}");
}

#[test]
fn a_world_with_margins_has_more_friction_and_counts_that_of_other_contacts_as_if_it_reversed() {
    let case =
        TestCase { friction: FrictionIndex(0), grasp: GraspError::default(), disturbance: Disturbance::default() };
    let wall = block([0.02, WIDTH, 0.2], [-0.5 * WIDTH - 0.01, 0.0, 0.1]);
    let mut world = task(&block([WIDTH, WIDTH, 0.08], [0.0; 3]), &[floor(), wall]);
    world.goal.0[2] = 0.04;
    let pressing = through(&[[0.0, 0.0, 0.06], [-0.04, 0.0, 0.06], [-0.04, 0.0, -0.06]], 2.0);
    const FRICTION: f64 = 0.2;
    let rollout = |friction: f64| Rollout::new(&world, Settings { friction, ..Settings::default() });
    let force = |rollout: &Rollout| rollout.play(&pressing, case.injection(), |_, _| {}).loads.contact_force;
    let plain = force(&rollout(FRICTION));
    let [reversed, harder] = [1.0, 1.5].map(|factor| force(&rollout(factor * FRICTION).with_reversed_friction()));
    // The wall holds the body with 2 N when it arrives at the floor.
    assert!(reversed > plain + 0.1 && reversed < plain + 2.0 * FRICTION * 2.0, "{plain} and {reversed} N");
    assert!(harder > reversed + 0.05, "{reversed} and {harder} N");
    let mut passes = |limit: f64, margin: Option<f64>| {
        world.limits.contact_force = limit;
        let evaluator = Evaluator::new(&world, &[FRICTION], Success::default());
        let evaluator = margin.map_or(evaluator.clone(), |factor| evaluator.hardened(factor));
        evaluator.evaluate(&pressing, &case).passed
    };
    let (low, high) = (0.5 * (plain + reversed), 0.5 * (reversed + harder));
    assert!(passes(low, None) && !passes(low, Some(1.0)));
    assert!(passes(high, Some(1.0)) && !passes(high, Some(1.5)));
}

#[test]
fn a_bent_reference_keeps_its_start_and_moves_as_its_twists_say() {
    let (pose, horizon) =
        (|height| Pose([0.0, 0.0, height, 1.0, 0.0, 0.0, 0.0]), Horizon { steps: 25, time_step: 0.04 });
    let straight = Reference::straight(&pose(0.06), &pose(0.0), horizon);
    let mut random = fastrand::Rng::with_seed(5);
    for _ in 0..50 {
        let perturbation = Perturbation::random(&mut random, &Success::default());
        let bent = straight.perturbed(&perturbation);
        assert_eq!(bent.start(), straight.start());
        for pair in bent.states().windows(2) {
            let (from, to) = (&pair[0], &pair[1]);
            let moved =
                Vector3::from_column_slice(&from[..3]) + Vector3::from_column_slice(&to[7..10]) * bent.time_step();
            assert!((moved - Vector3::from_column_slice(&to[..3])).norm() < 1e-12);
            let angle = from.pose().error(&to.pose()).orientation;
            assert!((Vector3::from_column_slice(&to[10..]).norm() * bent.time_step() - angle).abs() < 1e-7);
        }
    }
}

#[test]
fn contacts_leave_the_part_of_the_way_to_the_goal_along_them() {
    let evaluator = evaluator();
    let case = cases()[0];
    let result = evaluator.evaluate(&beside(), &case);
    let (remaining, unblocked) = (result.remaining_shift, result.unblocked_shift);
    assert!(remaining.z < -0.03 && remaining.x < -1e-3, "it rests on the rim: {remaining}");
    assert!(
        (unblocked - Vector3::new(remaining.x, remaining.y, 0.0)).norm() < 5e-4,
        "of {remaining} it may slide {unblocked}"
    );
    assert!(result.violation > 1.01 * remaining.norm() / Success::default().position, "which is part of the violation");
    let hovering = through(&[[0.0015, 0.0, 0.06], [0.0015, 0.0, 0.06]], 1.0);
    let result = evaluator.evaluate(&hovering, &case);
    assert_eq!(result.unblocked_shift, result.remaining_shift, "nothing blocks what touches nothing");
}

#[test]
fn a_change_that_is_stopped_under_way_leaves_no_trace() {
    let evaluator = evaluator().with_workers(Workers::new(2));
    let mut refinement = refinement(&evaluator, 1);
    for calls in 0..100 {
        let (before, asked) = ((refinement.reference().clone(), refinement.score()), AtomicUsize::new(0));
        let is_changed = refinement.improve(&|| asked.fetch_add(1, Ordering::Relaxed) >= calls);
        let is_same = before == (refinement.reference().clone(), refinement.score());
        assert!(!is_changed && is_same, "no rollout is whole after {calls} intervals");
    }
    assert!((0..100).any(|_| refinement.improve(&|| false)), "it goes on as if nothing had been");
}

/// Straight down from 12 cm above the goal, 25 knots; on the last 4 cm the block is in the hole.
fn down() -> Reference {
    through(&[[0.0, 0.0, 0.12], [0.0; 3]], 2.0)
}

/// The same with a turn of up to 0.6 rad and a detour of up to 1 cm in free air.
fn bent_in_free_air() -> Reference {
    let mut states = down().states();
    for (knot, state) in states.iter_mut().enumerate().take(11) {
        let bend = (std::f64::consts::PI * knot as f64 / 10.0).sin().powi(2);
        state.0[0] = 0.01 * bend;
        (state.0[3], state.0[6]) = ((0.3 * bend).cos(), (0.3 * bend).sin());
    }
    Reference::new(down().time_step(), &states)
}

/// A reference that passes all test cases, simplified with the straight motion to another place.
fn simplified(reference: Reference, goal: [f64; 3], intervals: usize) -> Reference {
    let evaluator = evaluator();
    let results = |reference: &Reference| evaluator.evaluate_all(reference, &cases(), &|| false).unwrap();
    let before = results(&reference);
    assert!(before.iter().all(|result| result.passed), "{before:?}");
    let mut refinement = Refinement::new(&evaluator, reference, cases(), before.clone(), 1);
    let straight = StraightMotion::new(&down().states()[0].pose(), &at_rest(goal).pose());
    refinement.simplify(&straight, intervals, &|| false);
    let simpler = refinement.reference().clone();
    let after = results(&simpler);
    assert!(after.iter().all(|result| result.passed), "what passed still does: {after:?}");
    assert!(largest_force(&after) <= largest_force(&before), "{after:?} {before:?}");
    simpler
}

fn largest_force(results: &[TestResult]) -> f64 {
    results.iter().map(|result| result.contact_force).fold(0.0, f64::max)
}

/// The largest rotation (rad) and distance (m) from straight down.
fn departures(reference: &Reference) -> (f64, f64) {
    let straight = StraightMotion::new(&down().states()[0].pose(), &at_rest([0.0; 3]).pose());
    let departures = reference.states().into_iter().map(|state| straight.departure(&state.pose()));
    departures.fold((0.0, 0.0), |(rotation, distance), departure| {
        (departure.rotation.max(rotation), departure.distance.max(distance))
    })
}

#[test]
fn bends_in_free_air_are_taken_back() {
    let bent = bent_in_free_air();
    assert!(departures(&bent).0 > 0.59 && departures(&bent).1 > 9e-3);
    let simpler = simplified(bent, [0.0; 3], 25);
    assert!(departures(&simpler).0 < 1e-9 && departures(&simpler).1 < 1e-9, "{:?}", departures(&simpler));
}

#[test]
fn bends_that_are_needed_stay() {
    // The straight motion ends beside the hole.
    let simpler = simplified(bent_in_free_air(), [0.01, 0.0, 0.0], 25);
    assert!(simpler.positions().last().unwrap()[0] < 0.006);
}

#[test]
fn oscillations_that_no_case_needs_are_cut_off() {
    let mut world = task(&block([WIDTH, WIDTH, 0.08], [0.0; 3]), &hole(WIDTH + 0.002));
    world.start.0[2] = 0.12;
    let oscillation = FinalOscillation::new(&world, &Success::default(), 0.04).unwrap();
    let simpler = simplified(down().with_oscillation(&oscillation), [0.0; 3], down().intervals());
    assert_eq!(simpler.intervals(), down().intervals());
}
