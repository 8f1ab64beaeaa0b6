//! Strokes at the end of references.

use simulation::{Reference, Rollout, Settings, Strokes, Success};
use task::{AssemblyTask, Horizon, Limits};
use workers::Workers;

use crate::world::{block, hole, task};

const WIDTH: f64 = 0.04;

/// A block that is pushed down in a hole, from 3 cm above its goal.
fn insertion() -> (AssemblyTask, Reference) {
    let mut world = task(&block([WIDTH, WIDTH, 0.08], [0.0; 3]), &hole(WIDTH + 0.001));
    world.start[2] = 0.03;
    let push = Reference::straight(&world.start, &world.goal, Horizon { steps: 50, time_step: 0.04 });
    (world, push)
}

/// How far from the goal the block ends (m), pressed against a wall by an offset of 15 mm.
fn error(world: &AssemblyTask, reference: &Reference, friction: f64) -> f64 {
    let rollout = Rollout::new(world, Settings { friction, ..Settings::default() });
    rollout.simulate(reference, &[[0.015, 0.0, 0.0]], &Workers::default())[0].position_error
}

#[test]
fn a_block_that_walls_hold_back_reaches_its_goal_with_strokes() {
    let (world, push) = insertion();
    let reference = push.with_strokes(&Strokes::new(&world, &Success::default()).unwrap());
    let tolerance = Success::default().position;
    for friction in [0.0, 0.1, 0.3, 0.6] {
        let (plain, with_strokes) = (error(&world, &push, friction), error(&world, &reference, friction));
        assert!(with_strokes < tolerance, "friction {friction}: {with_strokes} m");
        assert_eq!(plain < tolerance, friction < 0.2, "friction {friction}: {plain} m without strokes");
    }
}

#[test]
fn strokes_keep_the_limits() {
    let (mut world, push) = insertion();
    let kept_with = |world: &AssemblyTask| {
        let strokes = Strokes::new(world, &Success::default()).unwrap();
        let reference = push.with_strokes(&strokes);
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
    let (mut world, _) = insertion();
    world.start = world.goal;
    assert_eq!(Strokes::new(&world, &Success::default()), None);
}
