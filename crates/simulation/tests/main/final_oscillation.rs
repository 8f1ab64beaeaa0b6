//! FinalOscillation at the end of references.

use simulation::{FinalOscillation, Reference, Rollout, Settings, Success};
use task::{AssemblyTask, Limits};
use workers::Workers;

use crate::world::{at_rest, block, hole, task, through};

const WIDTH: f64 = 0.04;

/// A block in a hole, 3 cm above its goal.
fn insertion() -> AssemblyTask {
    let mut world = task(&block([WIDTH, WIDTH, 0.08], [0.0; 3]), &hole(WIDTH + 0.001));
    world.start.0[2] = 0.03;
    world
}

/// How far from the goal the block ends (m).
fn error(world: &AssemblyTask, reference: &Reference, friction: f64) -> f64 {
    let rollout = Rollout::new(world, Settings { friction, ..Settings::default() });
    rollout.simulate(reference, &[[0.0; 3]], &Workers::default())[0].position_error
}

#[test]
fn a_block_that_walls_hold_back_reaches_its_goal_with_an_oscillation() {
    let world = insertion();
    // It is pressed against a wall and pushed down.
    let push = through(&[[0.0, 0.0, 0.03], [0.015, 0.0, 0.03], [0.015, 0.0, 0.0]], 1.0);
    let reference = push.with_oscillation(&FinalOscillation::new(&world, &Success::default(), f64::INFINITY).unwrap());
    let tolerance = Success::default().position;
    for friction in [0.0, 0.1, 0.3, 0.6] {
        let (plain, with_oscillation) = (error(&world, &push, friction), error(&world, &reference, friction));
        assert!(with_oscillation < tolerance, "friction {friction}: {with_oscillation} m");
        assert_eq!(plain < tolerance, friction < 0.2, "friction {friction}: {plain} m without an oscillation");
    }
}

#[test]
fn oscillations_keep_the_limits() {
    let mut world = insertion();
    let kept_with = |world: &AssemblyTask| {
        let oscillation = FinalOscillation::new(world, &Success::default(), f64::INFINITY).unwrap();
        let reference = Reference::new(0.04, &[at_rest([0.0; 3])]).with_oscillation(&oscillation);
        (reference.limits_kept(), reference.intervals())
    };
    let (free, shortest) = kept_with(&world);
    for limits in [
        Limits { translational_velocity: 0.5 * free.translational_velocity, ..Limits::NONE },
        Limits { translational_acceleration: 0.5 * free.translational_acceleration, ..Limits::NONE },
    ] {
        world.limits = limits;
        let (kept, intervals) = kept_with(&world);
        assert!(limits.allow(&kept, 0.01), "{kept:?}");
        assert!(intervals > shortest, "they take longer for that");
    }
}

#[test]
fn without_a_way_from_start_to_goal_there_are_none() {
    let mut world = insertion();
    world.start = world.goal;
    assert_eq!(FinalOscillation::new(&world, &Success::default(), f64::INFINITY), None);
}
