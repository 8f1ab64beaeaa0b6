//! Properties of every rollout.

use collision::Polytope;
use nalgebra::Matrix3;
use proptest::prelude::*;
use simulation::{Reference, Rollout, Settings, TimedState, offsets};
use task::{GraspError, Pose, State, Twist};
use workers::Workers;

use crate::world::{at_rest, block, floor, hole, task, through};

/// Points of the body within reach of a hole's rim (m).
fn place() -> impl Strategy<Value = [f64; 3]> {
    (-0.03..0.03_f64, -0.03..0.03_f64, -0.02..0.08_f64).prop_map(Into::into)
}

/// A convex body of some centimetres around the origin.
fn shape() -> impl Strategy<Value = Polytope> {
    let vertex = proptest::array::uniform3(-0.05..0.05_f64);
    let hull = |vertices: Vec<[f64; 3]>| Polytope::from_vertices(&vertices).ok();
    proptest::collection::vec(vertex, 6..14).prop_filter_map("flat", hull)
}

/// Any quaternion but zero.
fn orientation() -> impl Strategy<Value = [f64; 4]> {
    let is_quaternion = |components: &[f64; 4]| components.iter().any(|component| component.abs() > 0.1);
    proptest::array::uniform4(-1.0..1.0_f64).prop_filter("zero quaternion", is_quaternion)
}

/// Some components of a size.
fn vector<const N: usize>(size: f64) -> impl Strategy<Value = [f64; N]>
where
    [f64; N]: std::fmt::Debug,
{
    proptest::collection::vec(-size..size, N).prop_map(|components| components.try_into().expect("N components"))
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    /// Contacts are hard; the planner's exact distance is the oracle.
    #[test]
    fn nothing_overlaps(places in proptest::collection::vec(place(), 3), friction in prop_oneof![Just(0.0), 0.0..0.6_f64]) {
        const OVERLAP: f64 = 1e-5;
        let task = task(&block([0.04, 0.04, 0.08], [0.0; 3]), &hole(0.042));
        let rollout = Rollout::new(&task, Settings { friction, ..Settings::default() });
        let mut way = vec![[0.0, 0.0, 0.06]];
        way.extend(places);
        let (mut smallest, mut count) = (f64::INFINITY, 0);
        let outcome = rollout.play(&through(&way, 0.5), [0.0; 3], |state, _| {
            count += 1;
            if count % 10 == 0 {
                let distances = task.pairs.iter().map(|pair| pair.shapes.exact_distance(&state.pose));
                smallest = distances.fold(smallest, f64::min);
            }
        });
        prop_assert!(!outcome.diverged);
        prop_assert!(outcome.max_penetration < OVERLAP, "{}", outcome.max_penetration);
        prop_assert!(smallest > -OVERLAP, "{}", smallest);
    }

    /// The impedance law of the planner accelerates the body of a rollout, also where it is displaced and turned in the
    /// gripper and the damping differs from axis to axis.
    #[test]
    fn a_free_body_is_accelerated_by_the_planned_wrench(
        (offset, rotation) in (vector(0.02), vector(0.5)),
        (start, end) in ((vector::<3>(0.1), orientation()), (vector::<3>(0.1), orientation())),
        (twist, factor) in (vector::<6>(1.0), vector::<9>(1.0)),
    ) {
        const TIME_STEP: f64 = 1e-5;
        const STEPS: usize = 400;
        let mut task = task(&block([0.04, 0.04, 0.08], [0.0; 3]), &[]);
        let factor = Matrix3::from_row_slice(&factor);
        task.impedance.rotational_damping = factor * factor.transpose();
        let knot = |(position, quaternion)| State::new(&Pose::new(position, quaternion), &Twist(twist));
        let reference = Reference::new(STEPS as f64 * TIME_STEP, &[knot(start), knot(end)]);
        let grasp = GraspError { offset, rotation };
        let settings = Settings { time_step: TIME_STEP, settling_time: 0.0, friction: 0.0 };
        let mut states: Vec<TimedState> = Vec::new();
        Rollout::new(&task, settings).play(&reference, grasp, |state, _| states.push(*state));
        let inverse = task.inertia.inverse().unwrap();
        let pairs = states.windows(2).enumerate().skip(STEPS / 2).step_by(20);
        for (step, pair) in pairs {
            let target = reference.at(0, (step + 2) as f64 / STEPS as f64).state();
            let wrench = task.impedance.wrench(&target, &pair[1].state(), &grasp.pose());
            let expected = inverse * nalgebra::Vector6::from(wrench.0);
            for axis in 0..6 {
                let found = (pair[1].state()[7 + axis] - pair[0].state()[7 + axis]) / TIME_STEP;
                let error = (found - expected[axis]).abs();
                prop_assert!(error < 1e-2 * (1.0 + expected.amax()), "{axis}: {found} {}", expected[axis]);
            }
        }
    }

    /// Edges, corners and slanted facets, at any orientation and fast.
    #[test]
    fn odd_shapes_do_not_overlap(
        (body, first, second) in (shape(), shape(), shape()),
        orientation in orientation(),
        friction in prop_oneof![Just(0.0), 0.0..0.6_f64],
    ) {
        // A corner that passes a facet may meet the one behind it within a step, no deeper than the body moves in it.
        const ROUNDING: f64 = 1e-5;
        let place = |shape: &Polytope, x| shape.placed([x, 0.0, 0.0], [1.0, 0.2, -0.3, 0.1]);
        let task = task(&body, &[place(&first, 0.03), place(&second, -0.03), floor()]);
        let rollout = Rollout::new(&task, Settings { friction, ..Settings::default() });
        let mut target = at_rest([0.01, 0.01, -0.02]);
        target.0[3..7].copy_from_slice(&orientation);
        let (mut smallest, mut fastest, mut count) = (f64::INFINITY, 0.0_f64, 0);
        let radius = body.vertices().iter().map(|vertex| nalgebra::Vector3::from(*vertex).norm()).fold(0.0, f64::max);
        let reference = Reference::new(0.3, &[at_rest([0.0, 0.0, 0.2]), target]);
        let outcome = rollout.play(&reference, [0.0; 3], |state, _| {
            count += 1;
            fastest = fastest.max(state.twist.velocity().norm() + radius * state.twist.angular_velocity().norm());
            if count % 5 == 0 {
                let distances = task.pairs.iter().map(|pair| pair.shapes.exact_distance(&state.pose));
                smallest = distances.fold(smallest, f64::min);
            }
        });
        prop_assert!(!outcome.diverged);
        let deepest = fastest * Settings::default().time_step + ROUNDING;
        prop_assert!(outcome.max_penetration < deepest, "{} of {deepest}", outcome.max_penetration);
        prop_assert!(smallest > -deepest, "{smallest} of {deepest}");
    }

    #[test]
    fn outcomes_do_not_depend_on_threads(seed in 0..1000_u64) {
        let task = task(&block([0.04, 0.04, 0.08], [0.0; 3]), &hole(0.042));
        let settings = Settings { friction: 0.2, settling_time: 0.2, ..Settings::default() };
        let rollout = Rollout::new(&task, settings);
        let offsets = offsets::ball(0.01, 5, seed);
        let reference = through(&[[0.0, 0.0, 0.06], [0.0, 0.0, 0.0]], 0.5);
        prop_assert_eq!(rollout.simulate(&reference, &offsets, &Workers::default()), rollout.simulate(&reference, &offsets, &Workers::new(3)));
    }
}
