//! Rollouts per minute on one core: two of the repository's scenes, and a peg of 24 sides in a hole of 24 blocks; a
//! straight push and one that shifts and tilts on its way, as plans do; without and with friction. And the first scene with
//! an arm that holds the peg, without and with joint friction.
//!
//! Every rollout counts as 60 elements, so that Criterion's elements per second are rollouts per minute.

use std::hint::black_box;
use std::path::Path;
use std::time::Duration;

use collision::{Pair, Polytope};
use criterion::{Criterion, SamplingMode, Throughput, criterion_group, criterion_main};
use nalgebra::Vector3;
use robot::Arm;
use scene::Scene;
use simulation::{ArmModel, Perturbation, Reference, Rollout, Settings, Success, offsets};
use task::{AssemblyTask, ContactPair};
use workers::Workers;

const SIDES: usize = 24;
/// Number of rollouts of one measurement.
const ROLLOUTS: usize = 8;

fn load(name: &str) -> AssemblyTask {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes").join(name);
    Scene::load(&path).expect("a valid scene").task(None, None).expect("a valid task")
}

/// The hull of two copies of a polygon at two heights (m).
fn prism(polygon: &[[f64; 2]], heights: [f64; 2]) -> Polytope {
    let vertices: Vec<[f64; 3]> = heights.iter().flat_map(|&z| polygon.iter().map(move |&[x, y]| [x, y, z])).collect();
    Polytope::from_vertices(&vertices).expect("a solid")
}

/// Corner of a regular polygon whose sides have a distance (m) from the origin.
fn corner(distance: f64, index: usize) -> [f64; 2] {
    let radius = distance / (std::f64::consts::PI / SIDES as f64).cos();
    let (sine, cosine) = (std::f64::consts::TAU * index as f64 / SIDES as f64).sin_cos();
    [radius * cosine, radius * sine]
}

/// A peg with 24 sides and a hole that is 0.5 mm wider on every side; motion, inertia and impedance are those of peg1.
fn round_peg() -> AssemblyTask {
    const RADIUS: f64 = 0.03;
    let polygon: Vec<[f64; 2]> = (0..SIDES).map(|index| corner(RADIUS, index)).collect();
    let peg = prism(&polygon, [-0.05, 0.05]);
    let wall = |index: usize| {
        let [inner, outer] = [RADIUS + 5e-4, RADIUS + 0.04];
        let ends = [index, index + 1];
        let base: Vec<[f64; 2]> = ends.iter().flat_map(|&end| [corner(inner, end), corner(outer, end)]).collect();
        prism(&base, [-0.06, 0.0])
    };
    let pair = |index: usize| ContactPair {
        body: "peg".into(),
        environment: format!("wall{index}"),
        shapes: Pair::new(peg.clone(), wall(index)),
    };
    AssemblyTask { pairs: (0..SIDES).map(pair).collect(), ..load("peg1.toml") }
}

/// A straight push, and one that shifts by 3 mm and tilts by 0.05 rad for a while.
fn references(task: &AssemblyTask) -> [(&'static str, Reference); 2] {
    let straight = Reference::straight(&task.start, &task.goal, task.horizon);
    let mut perturbation = Perturbation::random(&mut fastrand::Rng::with_seed(3), &Success::default());
    (perturbation.shift, perturbation.rotation) = (Vector3::x() * 3e-3, Vector3::y() * 0.05);
    let tilted = straight.perturbed(&perturbation);
    [("straight", straight), ("tilted", tilted)]
}

fn rollouts(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("rollouts");
    group.sample_size(10).sampling_mode(SamplingMode::Flat).measurement_time(Duration::from_secs(2));
    group.throughput(Throughput::Elements(60 * ROLLOUTS as u64));
    for (name, task) in [("peg1", load("peg1.toml")), ("clamp1", load("clamp1.toml")), ("round peg", round_peg())] {
        let offsets = offsets::hull(&task.offsets(), ROLLOUTS, 1);
        for (motion, reference) in references(&task) {
            for friction in [0.0, 0.1] {
                let rollout = Rollout::new(&task, Settings { friction, ..Settings::default() });
                group.bench_function(format!("{name}, {motion}, friction {friction}"), |bencher| {
                    bencher.iter(|| rollout.simulate(black_box(&reference), &offsets, &Workers::default()));
                });
            }
        }
    }
}

/// An arm of six joints with the peg at its goal, the origin.
fn arm(joint_friction: f64) -> ArmModel {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../robot/tests/arms/six.urdf");
    let configuration = vec![0.3, -1.4, 1.9, -2.0, -1.5, 0.4];
    let arm = Arm::read(&path, "tip").expect("a valid arm").with_rotor_inertia(&[0.1; 6]).expect("six joints");
    let base = arm.pose(&arm.configuration(&configuration).expect("within limits")).inverse();
    let (arm, joint_friction) = (arm.with_base(&base), vec![joint_friction; 6]);
    ArmModel { arm, configuration, joint_friction, control_period: 2e-3, delay: 0.0 }
}

fn rollouts_of_an_arm(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("rollouts of an arm");
    group.sample_size(10).sampling_mode(SamplingMode::Flat).measurement_time(Duration::from_secs(2));
    group.throughput(Throughput::Elements(60 * ROLLOUTS as u64));
    let task = stiff(load("peg1.toml"));
    let offsets = offsets::hull(&task.offsets(), ROLLOUTS, 1);
    let reference = Reference::straight(&task.start, &task.goal, task.horizon);
    for joint_friction in [0.0, 0.5] {
        for friction in [0.0, 0.1] {
            let rollout = Rollout::new(&task, Settings { friction, ..Settings::default() });
            let rollout = rollout.with_arm(&arm(joint_friction)).expect("the arm reaches the peg");
            group.bench_function(format!("friction {friction}, joint friction {joint_friction} Nm"), |bencher| {
                bencher.iter(|| rollout.simulate(black_box(&reference), &offsets, &Workers::default()));
            });
        }
    }
}

/// With the gains that an arm of about eight times the planned inertia needs.
fn stiff(mut task: AssemblyTask) -> AssemblyTask {
    const FACTOR: f64 = 8.0;
    task.impedance.translational_stiffness *= FACTOR;
    task.impedance.rotational_stiffness *= FACTOR;
    task.impedance.translational_damping *= FACTOR;
    task.impedance.rotational_damping *= FACTOR;
    task
}

criterion_group!(benches, rollouts, rollouts_of_an_arm);
criterion_main!(benches);
