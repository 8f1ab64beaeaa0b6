//! Rollouts converge as time steps get finer, or hardly depend on them, unless impacts and sticking are in the way.

use std::path::Path;

use nalgebra::Vector3;
use scene::Scene;
use simulation::{Outcome, Reference, Rollout, Settings};
use task::AssemblyTask;

use crate::world::{at_rest, block, floor, task};

/// The coarsest and the finest step differ by a factor of 16.
const TIME_STEPS: [f64; 5] = [4e-3, 2e-3, 1e-3, 5e-4, 2.5e-4];
const FINEST: f64 = 1.5625e-5;
/// Of contact forces during impacts (N).
const LARGEST_DIFFERENCE: f64 = 0.3;

/// How much the end of a rollout differs from that with the finest step, for every time step: in position (m), in
/// angle (rad), and in the largest force (N).
fn differences(world: &AssemblyTask, reference: &Reference, friction: f64, offset: [f64; 3]) -> [[f64; 3]; 5] {
    let end = |time_step: f64| {
        let settings = Settings { time_step, friction, settling_time: 0.0 };
        let outcome = Rollout::new(world, settings).play(reference, offset, |_, _| {});
        assert!(!outcome.diverged && outcome.loads.contact_force > 0.1, "it touches: {outcome:?}");
        outcome
    };
    let exact = end(FINEST);
    TIME_STEPS.map(|time_step| difference(&end(time_step), &exact))
}

fn difference(one: &Outcome, other: &Outcome) -> [f64; 3] {
    let angle = one.pose.error(&other.pose).orientation;
    let position = |outcome: &Outcome| Vector3::new(outcome.pose[0], outcome.pose[1], outcome.pose[2]);
    [(position(one) - position(other)).norm(), angle, (one.loads.contact_force - other.loads.contact_force).abs()]
}

#[test]
fn a_sliding_body_hardly_depends_on_the_time_step() {
    let world = task(&block([0.1, 0.08, 0.06], [0.0; 3]), &[floor()]);
    // Pressed down, dragged along the floor and turned, still in motion at the end.
    let knot = |index: usize| {
        let time = index as f64 / 20.0;
        let mut state = at_rest([0.1 * time * time, 0.03 * time, 0.03 - 0.02 * time]);
        (state.0[3], state.0[6]) = ((0.3 * time).cos(), (0.3 * time).sin());
        state
    };
    let reference = Reference::new(0.04, &(0..=20).map(knot).collect::<Vec<_>>());
    for friction in [0.0, 0.3] {
        let all = differences(&world, &reference, friction, [0.0; 3]);
        let small = all.iter().all(|&[position, angle, force]| position < 2e-5 && angle < 6e-5 && force < 2e-3);
        assert!(small, "friction {friction}: {all:?}");
    }
}

#[test]
fn a_peg_that_is_pushed_into_its_hole_converges() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/peg1.toml");
    let world = Scene::load(&path).unwrap().task(None, None).unwrap();
    let reference = Reference::straight(&world.start, &world.goal, world.horizon);
    // Impacts fall between steps, so that single halvings of the step gain more or less than a factor of two. How an impact
    // is shared among pairs depends on which of them touches first, so that forces have no order.
    for offset in [[0.0; 3], [0.002, 0.001, 0.0], [0.0, -0.004, 0.0]] {
        let all = differences(&world, &reference, 0.0, offset);
        let shrinks = (0..2).all(|index| all[4][index] < all[0][index] / 8.0);
        assert!(shrinks && all[4][0] < 2e-5 && all[4][2] < LARGEST_DIFFERENCE, "offset {offset:?}: {all:?}");
    }
    // Where a jammed peg sticks depends on when it began to.
    for offset in [[0.0; 3], [0.002, 0.001, 0.0], [-0.003, 0.002, 0.0], [0.0, -0.004, 0.0]] {
        let all = differences(&world, &reference, 0.3, offset);
        let largest = all.iter().map(|difference| difference[0]).fold(0.0, f64::max);
        let shrinks = largest < 6e-4 && all[4][0] < largest / 2.0;
        assert!(shrinks && all[4][0] < 2.5e-4 && all[4][2] < LARGEST_DIFFERENCE, "offset {offset:?}: {all:?}");
    }
}
