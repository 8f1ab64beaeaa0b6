//! Robots that are commanded by position: their rollouts.

use admittance::{ContactLoop, Feedback, Gains, Limits, PositionRobot, Sensor};
use nalgebra::Matrix3;
use simulation::{Disturbance, Injection, Reference, Rollout, Settings};
use task::{AssemblyTask, GraspError, Horizon, Inertia, Pose};

use crate::world::{at_rest, block, floor, states, task};

/// Stiffness of the law in that of the contact, and time between two knots (s).
const SOFTNESS: f64 = 0.01;
const INTERVAL: f64 = 0.04;

/// A robot with the gains that are chosen for a contact stiffness (N/m), a period and a delay (s).
fn robot(contact_stiffness: f64, period: f64, delay: f64) -> PositionRobot {
    let of = ContactLoop { period, delay, bandwidth: 20.0, cutoff: 50.0, contact_stiffness, lever: 0.05 };
    PositionRobot {
        gains: of.gains([SOFTNESS * contact_stiffness, 50.0]).unwrap(),
        feedback: Feedback::Commanded,
        period,
        delay,
        bandwidth: 20.0,
        limits: Limits { speed: [0.25, 1.0], acceleration: [2.5, 10.0] },
        sensor: Sensor { cutoff: 50.0, noise: [0.0; 2], resolution: [0.0; 2] },
        force_mode: None,
        contact_stiffness,
        lever: 0.05,
        carried: Inertia::of_body(1.0, Matrix3::identity() * 1e-3),
    }
}

fn rollout(task: &AssemblyTask, robot: &PositionRobot) -> Rollout {
    Rollout::new(task, Settings::default()).with_position_robot(robot)
}

/// A block on a floor is pressed down: the mean force (N) between knots in the last second of many.
fn forces(robot: &PositionRobot, seconds: f64) -> Vec<f64> {
    let task = task(&block([0.1; 3], [0.0, 0.0, 0.05]), &[floor()]);
    // The reference goes 10 mm below the surface, at 10 mm/s.
    let (start, end) = (Pose(at_rest([0.0, 0.0, 0.002]).pose().0), Pose(at_rest([0.0, 0.0, -0.01]).pose().0));
    let horizon = Horizon { steps: 30, time_step: INTERVAL };
    let reference = Reference::straight(&start, &end, horizon);
    let settings = Settings { settling_time: seconds, ..Settings::default() };
    let mut of_knots = vec![(0.0, 0.0)];
    let outcome = Rollout::new(&task, settings).with_position_robot(robot).play(
        &reference,
        GraspError::default(),
        |state, impulses| {
            of_knots.push((state.time, impulses[0]));
        },
    );
    assert!(!outcome.diverged && outcome.max_penetration < 1e-6, "{outcome:?}");
    let last = of_knots[of_knots.len() - 1].0;
    // Impulses are counted from knot to knot.
    let at_knot =
        |pair: &[(f64, f64)]| (pair[1].1 < pair[0].1 && pair[0].0 > last - 1.0).then_some(pair[0].1 / INTERVAL);
    of_knots.windows(2).filter_map(at_knot).collect()
}

fn spread(forces: &[f64]) -> f64 {
    forces.iter().copied().fold(0.0, f64::max) - forces.iter().copied().fold(f64::INFINITY, f64::min)
}

#[test]
fn a_stiff_contact_ends_at_the_force_of_the_spring_without_a_limit_cycle() {
    for (period, delay) in [(0.002, 0.004), (0.008, 0.02), (0.004, 0.03)] {
        for contact_stiffness in [1e5, 1e6] {
            let robot = robot(contact_stiffness, period, delay);
            let time_constant = robot.gains.damping[0] / robot.gains.stiffness[0];
            let forces = forces(&robot, 8.0 * time_constant);
            let last = forces[forces.len() - 1];
            let spring = 0.01 * robot.gains.stiffness[0];
            assert!((last / spring - 1.0).abs() < 0.02, "{contact_stiffness} {delay}: {last} N");
            assert!(spread(&forces) < 0.02 * spring, "{contact_stiffness} {delay}: {} N", spread(&forces));
        }
    }
}

#[test]
fn too_little_damping_makes_a_limit_cycle() {
    let stable = robot(1e5, 0.008, 0.02);
    let damping = stable.gains.damping.map(|damping| 0.1 * damping);
    let weak = PositionRobot {
        gains: Gains { damping, mass: damping.map(|damping| 0.016 * damping), ..stable.gains },
        ..stable
    };
    let forces = forces(&weak, 10.0);
    assert!(spread(&forces) > 5.0, "{forces:?}");
}

#[test]
fn in_free_air_the_body_follows_its_reference_with_the_lag() {
    let robot = robot(1e5, 0.002, 0.004);
    let task = task(&block([0.1; 3], [0.0; 3]), &[]);
    let speed = 0.02;
    let (start, end) = (at_rest([0.0; 3]).pose(), at_rest([2.0 * speed, 0.0, 0.0]).pose());
    let reference = Reference::straight(&start, &end, Horizon { steps: 50, time_step: INTERVAL });
    let states = states(&rollout(&task, &robot), &reference);
    // Servo, delay, sampling and the mass of the law; nothing is measured in free air.
    let filter = 1.0 / (std::f64::consts::TAU * robot.sensor.cutoff);
    let late = robot.contact_loop().lag() - filter + robot.gains.mass[0] / robot.gains.damping[0];
    for state in states.iter().filter(|state| state.time > 0.5 && state.time < 1.99) {
        let behind = speed * state.time - state.pose[0];
        assert!((behind - speed * late).abs() < 0.15 * speed * late, "{behind} instead of {}", speed * late);
    }
    let end = states[states.len() - 1].pose[0];
    assert!((end - 2.0 * speed).abs() < 1e-4, "{end}");
}

#[test]
fn a_bias_of_the_sensor_displaces_the_body_and_an_offset_does_so_too() {
    let robot = robot(1e5, 0.002, 0.004);
    let task = task(&block([0.1; 3], [0.0; 3]), &[]);
    let still = Reference::new(INTERVAL, &vec![at_rest([0.0; 3]); 2500]);
    let disturbance = Disturbance { bias: [0.0, 2.0, 0.0, 0.0, 0.0, 0.1], ..Disturbance::default() };
    let outcome =
        rollout(&task, &robot).play(&still, Injection { grasp: GraspError::default(), disturbance }, |_, _| {});
    assert!((outcome.pose[1] - 2.0 / robot.gains.stiffness[0]).abs() < 1e-5, "{:?}", outcome.pose);
    assert!((2.0 * outcome.pose[6].asin() - 0.1 / 50.0).abs() < 1e-5, "{:?}", outcome.pose);
    let outcome = rollout(&task, &robot).play(&still, [0.0, 0.0, 0.003], |_, _| {});
    assert!((outcome.position_error - 0.003).abs() < 1e-9);
}

#[test]
fn what_cannot_be_simulated_has_diverged() {
    let task = task(&block([0.1; 3], [0.0; 3]), &[]);
    let still = Reference::new(INTERVAL, &[at_rest([0.0; 3]); 3]);
    let good = robot(1e5, 0.002, 0.004);
    for wrong in [
        PositionRobot { carried: Inertia::of_body(f64::NAN, Matrix3::identity()), ..good.clone() },
        PositionRobot { contact_stiffness: f64::NAN, ..good.clone() },
        PositionRobot { gains: Gains { damping: [f64::NAN; 2], ..good.gains }, ..good.clone() },
    ] {
        assert!(rollout(&task, &wrong).play(&still, GraspError::default(), |_, _| {}).diverged);
    }
}

#[test]
fn a_robot_that_begins_beside_its_reference_comes_back_by_the_law() {
    let task = task(&block([0.1; 3], [0.0; 3]), &[]);
    let still = Reference::new(INTERVAL, &vec![at_rest([0.0; 3]); 250]);
    let beginning = at_rest([0.0, 0.001, 0.0]).pose();
    for feedback in [Feedback::Commanded, Feedback::MeasuredPose] {
        let robot = PositionRobot { feedback, ..robot(1e5, 0.002, 0.004) };
        let time_constant = robot.gains.damping[0] / robot.gains.stiffness[0];
        let mut flanges = Vec::new();
        let rollout = rollout(&task, &robot).with_beginning(beginning);
        rollout.play(&still, GraspError::default(), |state, _| flanges.push((state.time, state.flange.unwrap())));
        let (time, flange) = *flanges.iter().find(|(time, _)| *time > time_constant).unwrap();
        let left = flange.translation.y / 0.001;
        // Late by the lag of robot and law.
        let expected = (-(time - robot.contact_loop().lag()) / time_constant).exp();
        assert!(time > 0.5 && (left / expected - 1.0).abs() < 0.02, "{feedback:?} {time}: {left}");
    }
}
