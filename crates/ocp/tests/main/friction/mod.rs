//! Friction against Coulomb's law, written down a second time, against closed-form mechanics, rollouts and MuJoCo.

mod mujoco;
mod played;

use collision::{Pair, Polytope, Solutions};
use kkt::Owner;
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};
use nlp::Problem;
use ocp::{CONTACT_FORCE, Owners, Transcription, VELOCITY_DYNAMICS};
use simulation::{Reference, Rollout, Settings};
use task::{
    AssemblyTask, Complementarity, ContactPair, CostWeights, GraspError, HessianKind, Horizon, Impedance, Inertia,
    Limits, POSE, Pose, STATE, State, TWIST, TrajectoryCost, Twist,
};

use crate::friction::played::{ITERATIONS, motions};

const FRICTION: f64 = 0.3;
const STIFFNESS: f64 = 50.0;
const EDGE: f64 = 0.1;
const STEP: f64 = 0.04;
/// Steps in which the reference goes down, in which it goes sideways, and in which it rests.
const PHASES: [usize; 3] = [12, 30, 12];
/// How far the reference moves sideways where the block slides (m).
const SLIDE: f64 = 0.2;
/// Height of the start, and depth of the reference below the height at which the block touches the floor (m).
const HEIGHT: f64 = 0.01;
const DEPTH: f64 = 0.1;

/// A block above a floor whose surface is z = 0.
fn block() -> AssemblyTask {
    let floor = Polytope::from_box([1.0, 1.0, 0.1]).unwrap().placed([0.0, 0.0, -0.05], [1.0, 0.0, 0.0, 0.0]);
    let shapes = Pair::new(Polytope::from_box([EDGE; 3]).unwrap(), floor);
    let inertia = Inertia::of_body(1.0, Matrix3::identity() * 0.1);
    let weights = CostWeights {
        translational_velocity: 1.0,
        rotational_velocity: 0.1,
        terminal_position: 0.0,
        terminal_orientation: 0.0,
    };
    let start = Pose([0.0, 0.0, 0.5 * EDGE + HEIGHT, 1.0, 0.0, 0.0, 0.0]);
    AssemblyTask {
        pairs: vec![ContactPair { body: "block".into(), environment: "floor".into(), shapes }],
        frictions: vec![FRICTION],
        start,
        goal: start,
        impedance: Impedance::critically_damped(STIFFNESS, 5.0, &inertia),
        inertia,
        grasps: vec![GraspError::default()],
        horizon: Horizon { steps: PHASES.iter().sum(), time_step: STEP },
        cost: TrajectoryCost { reference: weights, compliant: weights },
        limits: Limits::NONE,
    }
}

/// Velocities of the reference after every step: down, then along x by a length (m), then zero.
fn reference_velocities(length: f64) -> Vec<Twist> {
    let down = Twist([0.0, 0.0, -(HEIGHT + DEPTH) / (PHASES[0] as f64 * STEP), 0.0, 0.0, 0.0]);
    let along = Twist([length / (PHASES[1] as f64 * STEP), 0.0, 0.0, 0.0, 0.0, 0.0]);
    [down, along, Twist::ZERO].iter().zip(PHASES).flat_map(|(twist, steps)| vec![*twist; steps]).collect()
}

/// States of the block at the end of every step, one motion per smoothing.
fn planned(task: &AssemblyTask, length: f64) -> Vec<Vec<State>> {
    motions(task, reference_velocities(length))
}

/// Positions of the block along x at the end of every step in a rollout with hard contact.
fn rolled_out(task: &AssemblyTask, length: f64) -> Vec<f64> {
    let mut states = vec![task.start.at_rest()];
    for twist in reference_velocities(length) {
        let mut pose = states[states.len() - 1].pose();
        (0..3).for_each(|axis| pose.0[axis] += STEP * twist[axis]);
        states.push(State::new(&pose, &twist));
    }
    let settings = Settings { friction: task.frictions[0], settling_time: 0.0, ..Settings::default() };
    let trajectory = Rollout::new(task, settings).trajectory(&Reference::new(STEP, &states), &[[0.0; 3]], 1e-5);
    trajectory.scenarios[0].states[1..].iter().map(|state| state[0]).collect()
}

/// Largest distances along x between planned motions and the rollout, one per smoothing.
fn deviations(task: &AssemblyTask, length: f64) -> Vec<f64> {
    let expected = rolled_out(task, length);
    let deviation = |motion: &Vec<State>| {
        motion.iter().zip(&expected).map(|(state, expected)| (state[0] - expected).abs()).fold(0.0, f64::max)
    };
    planned(task, length).iter().map(deviation).collect()
}

#[test]
fn a_block_slides_and_comes_to_rest_as_in_a_rollout() {
    let deviations = deviations(&block(), SLIDE);
    assert!(deviations[ITERATIONS - 1] < 3e-3 && deviations[ITERATIONS - 1] < 0.5 * deviations[0], "{deviations:?}");
}

#[test]
fn a_block_that_slides_steadily_lags_until_the_spring_bears_friction() {
    let motion = planned(&block(), SLIDE).remove(ITERATIONS - 1);
    let (lag, expected) = (SLIDE - motion[PHASES[0] + PHASES[1] - 1][0], FRICTION * DEPTH);
    assert!((lag - expected).abs() < 0.02 * expected, "{lag}, not {expected}");
}

#[test]
fn a_block_sticks_but_for_creeping() {
    // A spring force of two thirds of what friction holds.
    let (task, length) = (block(), 2.0 / 3.0 * FRICTION * DEPTH);
    let deviations = deviations(&task, length);
    assert!(deviations[ITERATIONS - 1] < 2e-3 && deviations[ITERATIONS - 1] < 0.5 * deviations[0], "{deviations:?}");
    let without = planned(&AssemblyTask { frictions: vec![0.0], ..task }, length);
    assert!(without[ITERATIONS - 1].last().unwrap()[0] > 0.9 * length);
}

#[test]
fn scenarios_with_frictions_of_their_own_move_as_if_alone() {
    let frictions = [0.0, FRICTION];
    let layout = |frictions: &[f64]| {
        let task = AssemblyTask { frictions: frictions.to_vec(), ..block() };
        Transcription::new(&task, Complementarity::Relaxation, HessianKind::Exact).layout().clone()
    };
    let defects = |frictions: &[f64], x: &[f64], scenario: usize| {
        velocity_defects(&AssemblyTask { frictions: frictions.to_vec(), ..block() }, x, 1e-3, scenario)
    };
    let (both, single) = (layout(&frictions), layout(&[0.0]));
    let x: Vec<f64> = (0..both.variable_count()).map(|index| 0.5 + 0.1 * noise(index)).collect();
    for (scenario, friction) in frictions.into_iter().enumerate() {
        // The reference and the variables of this scenario.
        let mut alone = vec![0.0; single.variable_count()];
        for (stage, owner) in single.stages_of(Owners::All) {
            let from = if owner == Owner::Reference { owner } else { Owner::Scenario(scenario) };
            alone[single.state(stage, owner)..][..STATE].copy_from_slice(&x[both.state(stage, from)..][..STATE]);
            if owner != Owner::Reference {
                alone[single.variable(CONTACT_FORCE, stage, owner)] = x[both.variable(CONTACT_FORCE, stage, from)];
            }
        }
        let together = defects(&frictions, &x, scenario);
        assert_eq!(together, defects(&[friction], &alone, 0));
        assert_ne!(together, defects(&[0.5], &alone, 0));
    }
}

/// A deterministic number in (-1, 1).
fn noise(index: usize) -> f64 {
    (index as f64 * 12.9898).sin()
}

/// The velocity defects of a scenario at a point of the transcription.
fn velocity_defects(task: &AssemblyTask, x: &[f64], tau: f64, scenario: usize) -> Vec<Vector6<f64>> {
    let mut problem = Transcription::new(task, Complementarity::Relaxation, HessianKind::Exact);
    problem.set_smoothing(tau, 1e-3);
    let mut values = vec![0.0; problem.layout().constraint_count()];
    problem.set_point(x).unwrap();
    problem.constraints(&mut values).unwrap();
    let row = |stage: usize| problem.layout().row(VELOCITY_DYNAMICS, stage, Owner::Scenario(scenario));
    (1..=task.horizon.steps).map(|stage| Vector6::from_column_slice(&values[row(stage)..][..TWIST])).collect()
}

#[test]
fn a_pair_adds_coulombs_wrench_at_its_contact_point_and_brakes() {
    let factor = Matrix6::from_fn(|row, column| 0.3 * noise(7 * row + column) + f64::from(u8::from(row == column)));
    let horizon = Horizon { steps: 4, time_step: STEP };
    let task = AssemblyTask { inertia: Inertia::from_matrix(factor * factor.transpose()), horizon, ..block() };
    let tau = 1e-3;
    let layout = Transcription::new(&task, Complementarity::Relaxation, HessianKind::Exact).layout().clone();
    let mut x: Vec<f64> = (0..layout.variable_count()).map(|index| 0.1 * noise(index)).collect();
    for (stage, owner) in layout.stages_of(Owners::All) {
        x[layout.state(stage, owner) + 3] += 1.0;
    }
    let (with, without) = (
        velocity_defects(&task, &x, tau, 0),
        velocity_defects(&AssemblyTask { frictions: vec![0.0], ..task.clone() }, &x, tau, 0),
    );
    let owner = Owner::Scenario(0);
    for stage in 1..=task.horizon.steps {
        let pose: Pose = match stage {
            1 => task.start,
            _ => Pose(std::array::from_fn(|index| x[layout.state(stage - 1, owner) + index])),
        };
        let twist = Vector6::from_column_slice(&x[layout.state(stage, owner) + POSE..][..TWIST]);
        let force = x[layout.variable(CONTACT_FORCE, stage, owner)];
        let mut contact = [[0.0; 10]];
        task.pairs[0].shapes.contacts(&[pose.0], tau, &mut Solutions::default(), &mut contact).unwrap();
        let rotation = pose.orientation();
        let lever = Vector3::from_column_slice(&contact[0][7..]) - pose.position();
        let normal = Vector3::from_column_slice(&contact[0][1..4]);
        let velocity = twist.fixed_rows::<3>(0) + (rotation * twist.fixed_rows::<3>(3)).cross(&lever);
        let sliding = velocity - normal.normalize() * normal.normalize().dot(&velocity);
        let creep = (33.0 * tau).hypot(1e-3);
        let expected = -sliding * (FRICTION * force * normal.norm() / sliding.norm().hypot(creep));
        let change = task.inertia.matrix() * (without[stage - 1] - with[stage - 1]) / STEP;
        let torque = rotation.inverse() * lever.cross(&expected);
        assert!((change.fixed_rows::<3>(0) - expected).norm() < 1e-10, "stage {stage}: {change} {expected}");
        assert!((change.fixed_rows::<3>(3) - torque).norm() < 1e-10, "stage {stage}: {change} {torque}");
        assert!(change.dot(&twist) * force < 0.0, "friction drives at stage {stage}");
    }
}
