//! Small worlds for rollouts: boxes, floors, holes, and references through upright poses.

use collision::{Pair, Polytope};
use nalgebra::{Matrix3, Vector3};
use simulation::{Reference, Rollout, TimedState};
use task::{
    AssemblyTask, ContactPair, CostWeights, GraspError, Horizon, Impedance, Inertia, Limits, Pose, State,
    TrajectoryCost,
};

/// Translational stiffness (N/m) and mass (kg) of every body.
pub const STIFFNESS: f64 = 50.0;
pub const MASS: f64 = 1.0;
/// Rotational stiffness (Nm/rad) and inertia (kg m^2) about every axis.
pub const ROTATIONAL_STIFFNESS: f64 = 5.0;
pub const INERTIA: f64 = 0.1;

/// A box with edge lengths, centred at a position (m).
pub fn block(edges: [f64; 3], position: [f64; 3]) -> Polytope {
    Polytope::from_box(edges).unwrap().placed(position, [1.0, 0.0, 0.0, 0.0])
}

/// A floor whose surface is z = 0.
pub fn floor() -> Polytope {
    block([1.0, 1.0, 0.1], [0.0, 0.0, -0.05])
}

/// The four walls and the bottom of a square hole around the z axis: rim at z = 0, bottom at z = -0.05 m.
pub fn hole(width: f64) -> Vec<Polytope> {
    const THICKNESS: f64 = 0.1;
    let side = 0.5 * (width + THICKNESS);
    vec![
        block([THICKNESS, 0.4, 0.1], [-side, 0.0, -0.05]),
        block([THICKNESS, 0.4, 0.1], [side, 0.0, -0.05]),
        block([width, THICKNESS, 0.1], [0.0, -side, -0.05]),
        block([width, THICKNESS, 0.1], [0.0, side, -0.05]),
        block([0.4, 0.4, 0.1], [0.0, 0.0, -0.1]),
    ]
}

/// A body among obstacles, with its goal at the origin. Fields that rollouts do not use are zero.
pub fn task(body: &Polytope, obstacles: &[Polytope]) -> AssemblyTask {
    let inertia = Inertia::of_body(MASS, Matrix3::identity() * INERTIA);
    let pair = |obstacle: &Polytope| ContactPair {
        body: "body".into(),
        environment: "obstacle".into(),
        shapes: Pair::new(body.clone(), obstacle.clone()),
    };
    let none = CostWeights {
        translational_velocity: 0.0,
        rotational_velocity: 0.0,
        terminal_position: 0.0,
        terminal_orientation: 0.0,
    };
    AssemblyTask {
        pairs: obstacles.iter().map(pair).collect(),
        frictions: vec![0.0],
        start: Pose([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]),
        goal: Pose([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]),
        impedance: Impedance::critically_damped(STIFFNESS, ROTATIONAL_STIFFNESS, &inertia),
        inertia,
        grasps: vec![GraspError::default()],
        horizon: Horizon { steps: 1, time_step: 0.04 },
        limits: Limits::NONE,
        cost: TrajectoryCost { reference: none, compliant: none },
    }
}

/// The state of an upright body at rest.
pub fn at_rest([x, y, z]: [f64; 3]) -> State {
    Pose([x, y, z, 1.0, 0.0, 0.0, 0.0]).at_rest()
}

/// A reference through upright poses, `seconds` from each to the next. It commands no velocity, so that damping brakes.
pub fn through(positions: &[[f64; 3]], seconds: f64) -> Reference {
    const KNOTS: usize = 25;
    let mut states = vec![at_rest(positions[0])];
    for ends in positions.windows(2) {
        let [from, to] = [ends[0], ends[1]].map(Vector3::from);
        states.extend((1..=KNOTS).map(|knot| at_rest(from.lerp(&to, knot as f64 / KNOTS as f64).into())));
    }
    Reference::new(seconds / KNOTS as f64, &states)
}

/// All states of a rollout without grasp error.
pub fn states(rollout: &Rollout, reference: &Reference) -> Vec<TimedState> {
    let mut states = Vec::new();
    rollout.play(reference, [0.0; 3], |state, _| states.push(*state));
    states
}
