//! Robots that are commanded by position or force: values that a small simulation and MuJoCo have been given are found in logs.

use std::fs;

use calibration::{Calibration, CalibrationRecord, Entries, Estimate, Log, Parameter};
use nalgebra::{Isometry3, Vector3};
use plan::records::AdmittanceRecord;
use plan::{Choices, Problem};
use simulation::Reference;
use task::{Pose, State, Twist};

use crate::small_robot::{CRITICAL, Law, SmallRobot};
use crate::support::{Workshop, estimate, found, project, through};

/// The corner for a robot that a table says, with gains that are chosen for it, and a body of this mass (kg) and inertia (kg m^2):
/// the sensor feels what it takes to accelerate that.
fn scene(robot: &str, mass: f64, inertia: f64) -> String {
    let scene = fs::read_to_string(project("scenes/corner.toml")).unwrap();
    let replaced = ["translational_stiffness", "rotational_stiffness", "mass", "inertia"];
    let kept = scene.lines().filter(|line| !replaced.iter().any(|key| line.starts_with(key)));
    let scene: String = kept.map(|line| line.to_owned() + "\n").collect();
    let body = format!("[body]\nmass = {mass}\ninertia = [{inertia}, {inertia}, {inertia}]\n");
    scene.replace("[body]\n", &body) + "[robot]\ncontact_stiffness = 2e4\n" + robot
}

/// The same with a body that is too light to be felt.
fn light(robot: &str) -> String {
    scene(robot, 1e-2, 1e-5)
}

const POSITION: &str = "interface = \"position\"\n";
const FORCE: &str = "interface = \"force\"\nforce_mode = { translational_gain = 8e-4, rotational_gain = 0.16 }\n";

/// A robot that differs from the scene, with the law of the scene.
fn small_robot(workshop: &Workshop, law: Law, seed: u64) -> SmallRobot {
    let robot = workshop.problem.scene().position_robot.as_ref().unwrap();
    let mut random = fastrand::Rng::with_seed(seed);
    let mut between = |low: f64, high: f64| low + (high - low) * random.f64();
    SmallRobot {
        law,
        period: robot.period,
        mass: robot.gains.mass,
        damping: robot.gains.damping,
        stiffness: robot.gains.stiffness,
        bandwidth: between(9.0, 35.0),
        delay: between(0.0, 0.015),
        bias: std::array::from_fn(|axis| if axis < 3 { between(-1.5, 1.5) } else { between(-0.04, 0.04) }),
    }
}

/// A reference in free air, along and about an axis after the other and back, as smooth as those of players and somewhat faster.
fn motion(workshop: &Workshop) -> Reference {
    const TIME_STEP: f64 = 0.002;
    const STEPS: usize = 150;
    /// Steps of a rest after each way.
    const REST: usize = 30;
    let start = Isometry3::translation(0.05, 0.0, 0.05) * workshop.problem.scene().goal.isometry();
    let mut states = vec![State::new(&Pose::from(&start), &Twist::ZERO)];
    for way in 0..12 {
        let (axis, is_back) = (way / 2, way % 2 == 1);
        for step in 1..=STEPS + REST {
            let done = (step as f64 / STEPS as f64).min(1.0);
            let share = done.powi(3) * (10.0 - 15.0 * done + 6.0 * done * done);
            let rate = 30.0 * (done * (1.0 - done)).powi(2) / (STEPS as f64 * TIME_STEP);
            let (share, rate) = if is_back { (1.0 - share, -rate) } else { (share, rate) };
            let along = |size: f64, part: usize| {
                Vector3::from_fn(|row, _| if 3 * part + row == axis { size * [0.015, 0.08][part] } else { 0.0 })
            };
            let pose = start * Isometry3::new(along(share, 0), along(share, 1));
            states.push(State::new(&Pose::from(&pose), &Twist::new(&along(rate, 0), &along(rate, 1))));
        }
    }
    // The twist of a knot holds from the one before.
    let poses = states.iter().map(State::pose);
    let twists = std::iter::once(Twist::ZERO).chain(states.iter().map(State::twist));
    let led: Vec<State> = poses.zip(twists).map(|(pose, twist)| State::new(&pose, &twist)).collect();
    Reference::new(TIME_STEP, &led)
}

/// Writes the log of a dry run, with noise of 5 um and 5 urad.
fn log(workshop: &Workshop, robot: &SmallRobot, reference: &Reference, seed: u64) {
    workshop.write_log("free.csv", header(workshop, robot.law), reference, &robot.play(reference), 5e-6, seed);
}

fn header(workshop: &Workshop, law: Law) -> serde_json::Value {
    let mut header = workshop.header(0.05);
    let acts_on = if matches!(law, Law::Correction) { "commanded pose" } else { "measured pose" };
    header["spring_acts_on"] = acts_on.into();
    let robot = workshop.problem.scene().position_robot.as_ref();
    header["admittance"] = serde_json::to_value(robot.map(AdmittanceRecord::from)).unwrap();
    header
}

/// By how many standard errors parameters are off that are known; all others are named.
fn off(calibration: &Calibration, robot: &SmallRobot) -> (Vec<f64>, Vec<String>) {
    let (mut off, mut unknown) = (Vec::new(), Vec::new());
    for Estimate { quantity, value, standard_error, .. } in &calibration.estimates {
        let truth = match (quantity.parameter, robot.law) {
            (Parameter::Lag, _) => robot.lag(),
            (Parameter::Bandwidth, _) => robot.bandwidth,
            (Parameter::Gain { part }, Law::ForceMode(gain)) => gain[part],
            (Parameter::Bias { part, axis, .. }, _) => robot.bias[3 * part + axis],
            (other, _) => panic!("{}", other.name()),
        };
        match standard_error {
            Some(error) => off.push((value - truth) / error),
            None => unknown.push(quantity.parameter.name()),
        }
        // Shown by `--nocapture`, for the notebook.
        println!("{}: {truth:.5} {value:.5} +- {standard_error:.5?}", quantity.parameter.name());
    }
    (off, unknown)
}

/// Nearly all values are within two of their errors, for several seeds, and all are known; lags to within a time (s), bandwidths to
/// within a part.
#[track_caller]
fn are_found(robot: &str, [lag, bandwidth]: [f64; 2], law: impl Fn(u64) -> Law) {
    let workshop = Workshop::new(&light(robot));
    let reference = motion(&workshop);
    let (mut within, mut count) = (0, 0);
    for seed in 1..=3 {
        let robot = small_robot(&workshop, law(seed), seed);
        log(&workshop, &robot, &reference, seed);
        let calibration = workshop.calibrate(&["free.csv"], false);
        let (off, unknown) = off(&calibration, &robot);
        assert!(unknown.is_empty() && calibration.converged, "seed {seed}: {unknown:?} are not known");
        assert!(off.iter().all(|off| off.abs() < 4.0), "seed {seed}: off by {off:?} errors");
        within += off.iter().filter(|off| off.abs() <= 2.0).count();
        count += off.len();
        // Errors are not absurd either.
        found(&calibration, Parameter::Lag, robot.lag(), lag);
        found(&calibration, Parameter::Bandwidth, robot.bandwidth, bandwidth * robot.bandwidth);
        found(&calibration, Parameter::Bias { run: 0, part: 0, axis: 1 }, robot.bias[1], 0.05);
    }
    assert!(10 * within >= 9 * count, "{within} of {count} are within two errors");
}

#[test]
fn a_robot_that_takes_corrections_is_found() {
    are_found(POSITION, [1e-4, 0.03], |_| Law::Correction);
}

#[test]
fn a_robot_behind_the_controller_of_ros_is_found() {
    are_found(POSITION, [1e-4, 0.03], |_| Law::Controller);
}

#[test]
fn a_force_mode_is_found() {
    // A gain above that of the plan rings: the wrench of players damps too.
    are_found(FORCE, [1e-3, 0.3], |seed| {
        Law::ForceMode([8e-4 * (0.4 + 0.15 * seed as f64), 0.16 * (1.0 - 0.15 * seed as f64)])
    });
}

#[test]
fn entries_of_the_scene_have_the_robot_and_what_is_to_be_tolerated() {
    let workshop = Workshop::new(&light(FORCE));
    let law = Law::ForceMode([6e-4, 0.11]);
    let robot = SmallRobot { delay: 0.008, bandwidth: 15.0, ..small_robot(&workshop, law, 4) };
    log(&workshop, &robot, &motion(&workshop), 4);
    let calibration = workshop.calibrate(&["free.csv"], false);
    let entries = Entries::new(&calibration, &workshop.problem);
    let copy = workshop.path("copy.toml");
    entries.write(&workshop.path("scene.toml"), &copy, false).unwrap();
    let scene = Problem::load(&copy, &Choices::default()).unwrap().scene().clone();
    let fitted = scene.position_robot.as_ref().unwrap();
    assert!((fitted.bandwidth - 15.0).abs() < 1.5 && (fitted.lag() - robot.lag()).abs() < 2e-4, "{fitted:?}");
    let gain = fitted.force_mode.unwrap().gain;
    assert!((gain[0] / 6e-4 - 1.0).abs() < 0.03 && (gain[1] / 0.11 - 1.0).abs() < 0.03, "{gain:?}");
    let largest = |biases: &[f64]| biases.iter().fold(0.0_f64, |most, bias| most.max(bias.abs()));
    let force = scene.robustness.bias[0] - largest(&robot.bias[..3]);
    assert!((0.0..0.2).contains(&force) && scene.robustness.delay < 2e-3, "{:?}", scene.robustness);
    // In the fragment too, the table of the force mode is nested.
    assert!(entries.fragment().contains("[robot.force_mode]"), "{}", entries.fragment());
}

#[test]
fn what_a_log_of_a_robot_at_rest_does_not_tell_is_held_and_said() {
    let workshop = Workshop::new(&light(POSITION));
    let above = Isometry3::translation(0.05, 0.0, 0.05) * workshop.problem.scene().goal.isometry();
    let robot = small_robot(&workshop, Law::Correction, 5);
    log(&workshop, &robot, &through(&[above, above], 4.0), 5);
    let calibration = workshop.calibrate(&["free.csv"], false);
    for parameter in [Parameter::Lag, Parameter::Bandwidth] {
        let estimate = estimate(&calibration, parameter);
        assert_eq!((estimate.value, estimate.standard_error), (estimate.quantity.before, None), "{}", parameter.name());
    }
    // A bias moves it nevertheless.
    found(&calibration, Parameter::Bias { run: 0, part: 0, axis: 0 }, robot.bias[0], 0.05);
    let entries = Entries::new(&calibration, &workshop.problem);
    let record = CalibrationRecord::new(&calibration, &entries, &workshop.problem);
    assert!(record.parameters[0].remark.starts_with("not identified: "), "{record:?}");
    assert!(!record.entries.contains_key("robot"), "{:?}", record.entries);
}

#[test]
fn logs_of_another_interface_are_refused() {
    let [torque, position, force] = ["", POSITION, FORCE].map(|robot| match robot {
        "" => Workshop::new(&fs::read_to_string(project("scenes/corner.toml")).unwrap()),
        robot => Workshop::new(&light(robot)),
    });
    let refused = |workshop: &Workshop, header: serde_json::Value| {
        let reference = motion(workshop);
        let poses: Vec<_> = reference.states().iter().map(|state| state.pose().isometry()).collect();
        workshop.write_log("free.csv", header, &reference, &poses, 0.0, 1);
        Log::read(&workshop.path("free.csv"), workshop.problem.scene()).unwrap_err().to_string()
    };
    for (workshop, header, words) in [
        (
            &torque,
            header(&position, Law::Correction),
            "its robot has the interface `position`, and robot.interface is `torque`",
        ),
        (&position, torque.header(0.05), "its robot has the interface `torque`, and robot.interface is `position`"),
        (
            &force,
            header(&position, Law::Controller),
            "its robot has the interface `position`, and robot.interface is `force`",
        ),
    ] {
        let refusal = refused(workshop, header);
        assert!(refusal.contains(words), "{refusal}");
    }
    let mut wrong = header(&position, Law::Correction);
    wrong["spring_acts_on"] = "nothing".into();
    assert!(refused(&position, wrong).contains("commanded pose"));
}

/// The scene for which `scripts/lab record executions` plays the log.
fn recorded(robot: &str) -> Workshop {
    let urdf = project("examples/arms/six.urdf");
    let arm = fs::read_to_string(project("examples/arms/six.toml")).unwrap();
    let arm = arm.lines().filter(|line| !line.starts_with("[robot]") && !line.starts_with("base"));
    let arm: String = arm.map(|line| line.to_owned() + "\n").collect();
    let base = "base = { position = [-0.45, -0.1, -0.1] }\n";
    // The body of the stand-in.
    Workshop::new(&(scene(robot, 1.0, 1e-2) + base + &arm.replace("six.urdf", urdf.to_str().unwrap())))
}

#[test]
#[ignore = "slow, fits a log of 21 seconds: scripts/test and CI run it"]
fn the_robot_of_mujoco_is_found_from_the_log_of_its_player() {
    let logs = project("crates/calibration/tests/logs");
    let truths = fs::read_to_string(logs.join("commanded.json")).unwrap();
    let truth = &serde_json::from_str::<serde_json::Value>(&truths).unwrap()["position"];
    let workshop = recorded(&(POSITION.to_owned() + "stiffness_range = { rotational = [1.0, 50.0] }\n"));
    fs::copy(logs.join("position.csv"), workshop.path("log.csv")).unwrap();
    let calibration = workshop.calibrate(&["log.csv"], false);
    let (bandwidth, delay) = (truth["bandwidth"].as_f64().unwrap(), truth["delay"].as_f64().unwrap());
    // Its servo moves in steps of 1 ms, which makes it faster by half a step.
    let lag = delay + 2.0 * CRITICAL / (std::f64::consts::TAU * bandwidth) - 5e-4;
    let is_within = |parameter: Parameter, truth: f64, tolerance: f64| {
        found(&calibration, parameter, truth, tolerance);
        let Estimate { value, standard_error, .. } = estimate(&calibration, parameter);
        let error = standard_error.unwrap();
        assert!((value - truth).abs() <= 2.0 * error, "{}: {value} +- {error}, not {truth}", parameter.name());
    };
    is_within(Parameter::Lag, lag, 1e-3);
    for axis in 0..3 {
        is_within(Parameter::Bias { run: 0, part: 0, axis }, truth["bias"][axis].as_f64().unwrap(), 0.05);
    }
    // The motions of a player are too smooth for the bandwidth: it is held, and the delay makes up the lag.
    assert_eq!(estimate(&calibration, Parameter::Bandwidth).standard_error, None);
    let entries = Entries::new(&calibration, &workshop.problem);
    let record = CalibrationRecord::new(&calibration, &entries, &workshop.problem);
    let servo = 2.0 * CRITICAL / (std::f64::consts::TAU * 20.0);
    assert!((record.entries["robot"]["delay"].as_f64().unwrap() + servo - lag).abs() < 1e-3, "{:?}", record.entries);
    assert!(!record.entries["robot"].contains_key("bandwidth"), "{:?}", record.entries);
}
