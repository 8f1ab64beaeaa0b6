//! Rollouts of whole arms, compared with MuJoCo: `scripts/lab record motions` writes the records.

use std::path::{Path, PathBuf};

use nalgebra::{Isometry3, Matrix3, Vector3, Vector6};
use proptest::prelude::*;
use robot::gains::FrictionWrench;
use robot::{Arm, JointVector, RigidInertia};
use serde_json::Value;
use simulation::{
    ArmModel, Disturbance, Evaluator, FrictionIndex, Injection, Reference, Refinement, Rollout, Settings, Success,
    TestCase, TimedState,
};
use task::{AssemblyTask, GraspError, Impedance, Inertia, Pose, State};
use workers::Workers;

use crate::refinement::assert_records_are_whole_rollouts;
use crate::world::{at_rest, block, task};

/// A motion that MuJoCo has played.
pub struct Record {
    pub task: AssemblyTask,
    pub model: ArmModel,
    pub grasp: GraspError,
    pub friction: f64,
    pub reference: Reference,
    /// Times (s) and poses of the part.
    poses: Vec<(f64, Isometry3<f64>)>,
}

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(name)
}

impl Record {
    pub fn read(name: &str) -> Self {
        let content = content(name);
        Self::of(&content, &urdf(&content))
    }

    /// With the arm of a URDF.
    pub fn of(content: &Value, urdf: &Path) -> Self {
        let states: Vec<State> = content["reference"].as_array().unwrap().iter().map(array).map(State).collect();
        let part = block(array(&content["edges"]), [0.0; 3]);
        let floors = content["floor_height"].as_f64().map(|height| block([4.0, 4.0, 0.2], [0.0, 0.0, height - 0.1]));
        let mut task = task(&part, floors.as_slice());
        (task.start, task.goal) = (states[0].pose(), states[0].pose());
        let [translational_stiffness, rotational_stiffness] = array(&content["stiffness"]);
        let [translational, rotational] = array(&content["damping"]).map(Matrix3::from_diagonal_element);
        task.impedance = Impedance {
            translational_stiffness,
            rotational_stiffness,
            translational_damping: translational,
            rotational_damping: rotational,
        };
        let poses = content["poses"].as_array().unwrap().iter().map(|row| {
            let [time, pose @ ..]: [f64; 8] = array(row);
            (time, Pose(pose).isometry())
        });
        Self {
            model: model(content, urdf),
            task,
            grasp: GraspError { offset: array(&content["offset"]), rotation: array(&content["turn"]) },
            friction: content["friction"].as_f64().unwrap(),
            reference: Reference::new(content["knot_interval"].as_f64().unwrap(), &states),
            poses: poses.collect(),
        }
    }

    pub fn rollout(&self, time_step: f64) -> Rollout {
        let settings = Settings { time_step, friction: self.friction, settling_time: 0.0 };
        Rollout::new(&self.task, settings).with_arm(&self.model).unwrap()
    }

    /// Largest distance (m) and angle (rad) between MuJoCo and a rollout.
    fn deviation(&self, rollout: &Rollout) -> (f64, f64) {
        let states = states(rollout, &self.reference, self.grasp);
        self.poses.iter().fold((0.0, 0.0), |(distance, angle), (time, expected)| {
            let state = states.iter().find(|state| (state.time - time).abs() < 1e-9).unwrap();
            let pose = state.pose.isometry();
            (
                distance.max((pose.translation.vector - expected.translation.vector).norm()),
                angle.max(pose.rotation.angle_to(&expected.rotation)),
            )
        })
    }
}

pub fn content(name: &str) -> Value {
    let file = folder("tests/arms").join(name).with_extension("json");
    serde_json::from_slice(&std::fs::read(file).unwrap()).unwrap()
}

pub fn urdf(content: &Value) -> PathBuf {
    folder("../robot/tests/arms").join(content["arm"].as_str().unwrap()).with_extension("urdf")
}

fn model(content: &Value, urdf: &Path) -> ArmModel {
    let frame = |name: &str| {
        let ([x, y, z], [w, i, j, k]) = (array(&content[name]["position"]), array(&content[name]["orientation"]));
        Pose([x, y, z, w, i, j, k]).isometry()
    };
    let payload = &content["payload"];
    let [xx, yy, zz, xy, xz, yz] = array(&payload["inertia"]);
    let inertia = RigidInertia::new(
        payload["mass"].as_f64().unwrap(),
        Vector3::from(array(&payload["centre"])),
        Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz),
    );
    let arm = Arm::read(urdf, "tip").unwrap().with_base(&frame("base")).with_grasp(&frame("grasp"));
    let arm = arm.with_payload(inertia.unwrap()).with_rotor_inertia(&numbers(&content["rotor_inertia"])).unwrap();
    ArmModel {
        joint_friction: vec![content["joint_friction"].as_f64().unwrap(); arm.joints().len()],
        configuration: numbers(&content["configuration"]),
        control_period: content["control_period"].as_f64().unwrap(),
        delay: content["delay"].as_f64().unwrap(),
        arm,
    }
}

fn states(rollout: &Rollout, reference: &Reference, injection: impl Into<Injection>) -> Vec<TimedState> {
    let mut states = Vec::new();
    let outcome = rollout.play(reference, injection, |state, _| states.push(*state));
    assert!(!outcome.diverged);
    states
}

fn numbers(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|number| number.as_f64().unwrap()).collect()
}

fn array<const N: usize>(value: &Value) -> [f64; N] {
    numbers(value).try_into().unwrap()
}

/// Of MuJoCo in the records (s).
const THEIR_TIME_STEP: f64 = 1e-4;

#[test]
fn free_motion_is_that_of_mujoco_but_for_the_time_step() {
    for name in ["free", "delayed", "joint_friction"] {
        let record = Record::read(name);
        let even = |time_step: f64| record.rollout(time_step).with_even_steps();
        let (distance, angle) = record.deviation(&even(THEIR_TIME_STEP));
        assert!(distance < 2e-6 && angle < 1e-5, "{name}: {distance} m, {angle} rad");
        // Longer steps know only to first order that torques come late.
        let (distance, angle) = record.deviation(&record.rollout(THEIR_TIME_STEP));
        assert!(distance < 2e-5 && angle < 1e-4, "{name}: {distance} m, {angle} rad");
        let deviations = [2e-3, 1e-3, 5e-4].map(|time_step| {
            let (distance, angle) = record.deviation(&even(time_step));
            (distance / (time_step - THEIR_TIME_STEP), angle / (time_step - THEIR_TIME_STEP))
        });
        for (distance, angle) in deviations {
            assert!((0.9..1.1).contains(&(distance / deviations[2].0)), "{name}, first order: {deviations:?}");
            assert!((0.9..1.1).contains(&(angle / deviations[2].1)), "{name}, first order: {deviations:?}");
            assert!(distance < 0.07 && angle < 0.3, "{name}: {deviations:?}");
        }
    }
}

#[test]
fn an_arm_that_presses_on_a_floor_moves_as_in_mujoco() {
    // The floor of MuJoCo is soft, and friction differs while the direction of sliding does.
    for (name, allowed) in [("pressing", (1e-4, 4e-4)), ("rubbing", (6e-4, 2e-3))] {
        let record = Record::read(name);
        let (distance, angle) = record.deviation(&record.rollout(1e-3));
        assert!(distance < allowed.0 && angle < allowed.1, "{name}: {distance} m, {angle} rad");
    }
}

impl Record {
    /// A rollout, and a reference that jumps at once from the start by a distance (m) and rests for
    /// `seconds`.
    fn jump(&self, shift: Vector3<f64>, seconds: f64) -> (Rollout, Reference) {
        let states = [Vector3::zeros(), shift].map(|shift| {
            let mut state = self.reference.states()[0];
            (0..3).for_each(|axis| state.0[axis] += shift[axis]);
            state
        });
        let settings = Settings { friction: self.friction, settling_time: seconds, ..Settings::default() };
        (Rollout::new(&self.task, settings).with_arm(&self.model).unwrap(), Reference::new(1e-3, &states))
    }

    fn start(&self) -> JointVector {
        self.model.arm.configuration(&self.model.configuration).unwrap()
    }
}

#[test]
fn short_motions_are_those_of_a_body_with_the_apparent_inertia() {
    let mut record = Record::read("free");
    record.model.control_period = 1e-4;
    record.task.pairs.clear();
    let apparent = record.model.arm.at(&record.start()).apparent_inertia().unwrap();
    let task = AssemblyTask { inertia: Inertia::from_matrix(apparent), ..record.task.clone() };
    for shift in [Vector3::x(), Vector3::y(), Vector3::z()] {
        let (arm, reference) = record.jump(shift * 1e-3, 0.4);
        let body = Rollout::new(&task, Settings { time_step: 1e-4, settling_time: 0.4, ..Settings::default() });
        let expected = states(&body, &reference, [0.0; 3]);
        let actual = states(&arm, &reference, [0.0; 3]);
        let deviation = |(one, other): (&TimedState, &TimedState)| {
            (one.pose.isometry().translation.vector - other.pose.isometry().translation.vector).norm()
        };
        let largest = expected.iter().zip(&actual).map(deviation).fold(0.0, f64::max);
        assert!(largest < 1e-5, "{largest} m of 1e-3 m");
        let moved = expected[3499].pose.isometry().translation.vector - expected[0].pose.isometry().translation.vector;
        assert!(moved.norm() > 5e-4, "it moves");
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    /// Kinetic energy plus that of the springs, once the reference rests.
    #[test]
    fn energy_does_not_grow(
        shift in proptest::array::uniform3(-0.03..0.03_f64),
        joint_friction in 0.0..2.0_f64,
        friction in prop_oneof![Just(0.0), 0.0..0.5_f64],
    ) {
        let mut record = Record::read("pressing");
        record.model.joint_friction.fill(joint_friction);
        record.friction = friction;
        let (rollout, reference) = record.jump(Vector3::from(shift) - Vector3::z() * 0.02, 0.3);
        let target = reference.states()[1].pose().isometry();
        let (mut near, mut before) = (record.start(), f64::INFINITY);
        let first = 0.5 * record.task.impedance.translational_stiffness * 0.03_f64.powi(2);
        for state in states(&rollout, &reference, [0.0; 3]) {
            let pose = state.pose.isometry();
            near = record.model.arm.inverse_kinematics(&pose, &near).unwrap();
            let inertia = record.model.arm.at(&near).apparent_inertia().unwrap();
            let twist = Vector6::from(state.twist.0);
            let lag = (pose.translation.vector - target.translation.vector).norm_squared();
            let angle = (0.5 * pose.rotation.angle_to(&target.rotation)).sin().powi(2);
            let springs = 0.5 * record.task.impedance.translational_stiffness * lag
                + 2.0 * record.task.impedance.rotational_stiffness * angle;
            let energy = 0.5 * twist.dot(&(inertia * twist)) + springs;
            prop_assert!(energy < before + 2e-3 * first, "{energy} J after {before} J");
            before = energy;
        }
    }

    /// The largest error at which the arm rests along a direction: where the spring turns one of its joints.
    #[test]
    fn joint_friction_holds_what_it_can_and_no_more(direction in proptest::array::uniform3(-1.0..1.0_f64)) {
        prop_assume!(Vector3::from(direction).norm() > 0.1);
        let direction = Vector3::from(direction).normalize();
        let mut record = Record::read("joint_friction");
        let friction = [3.0, 2.5, 2.0, 1.0, 0.8, 0.6];
        record.model.joint_friction = friction.to_vec();
        let jacobian = record.model.arm.at(&record.start()).jacobian();
        let stiffness = record.task.impedance.translational_stiffness;
        let torque = jacobian.fixed_rows::<3>(0).tr_mul(&(direction * stiffness));
        let largest = (0..6).map(|joint| friction[joint] / torque[joint].abs()).fold(f64::INFINITY, f64::min);
        let bound = FrictionWrench::new(&jacobian, &friction).unwrap().deadband(stiffness, 1.0);
        prop_assert!(largest <= bound.distance);
        let moved = |shift: f64| {
            let (rollout, reference) = record.jump(direction * shift, 4.0);
            let pose = rollout.play(&reference, [0.0; 3], |_, _| {}).pose;
            (pose.isometry().translation.vector - reference.start().isometry().translation.vector).norm()
        };
        prop_assert!(moved(0.99 * largest) < 1e-9, "{}", moved(0.99 * largest));
        prop_assert!(moved(1.05 * largest) > 1e-6, "{}", moved(1.05 * largest));
    }
}

#[test]
fn an_arm_with_joint_friction_comes_to_rest_within_its_deadband() {
    let record = Record::read("joint_friction");
    let (rollout, reference) = record.jump(Vector3::new(0.02, -0.03, 0.01), 6.0);
    let states = states(&rollout, &reference, [0.0; 3]);
    let (last, earlier) = (states[6000].pose.isometry(), states[5000].pose.isometry());
    // It comes there as `exp(-4 t)` with the time (s), as stiffness and damping are.
    let crept = (last.translation.vector - earlier.translation.vector).norm();
    assert!(crept < 1e-8, "{crept} m");
    let configuration = record.model.arm.inverse_kinematics(&last, &record.start()).unwrap();
    let target = reference.states()[1].pose().isometry();
    let wrench = record.task.impedance.wrench(
        &reference.states()[1],
        &states[6000].pose.at_rest(),
        &GraspError::default().pose(),
    );
    let torque = record.model.arm.at(&configuration).jacobian().tr_mul(&Vector6::from(wrench.0));
    assert!(torque.amax() < 2.0 * (1.0 + 1e-4), "{torque}");
    assert!((last.translation.vector - target.translation.vector).norm() > 1e-3, "friction leaves an error");
}

#[test]
fn disturbances_change_what_they_name() {
    let record = Record::read("joint_friction");
    let end = |model: &ArmModel, stiffness: f64, disturbance: Disturbance| {
        let mut task = record.task.clone();
        task.impedance.translational_stiffness *= stiffness;
        task.impedance.rotational_stiffness *= stiffness;
        let rollout = Rollout::new(&task, Settings::default()).with_arm(model).unwrap();
        rollout.play(&record.reference, Injection { grasp: record.grasp, disturbance }, |_, _| {}).pose
    };
    let none = Disturbance::default();
    let base = &record.model;
    let stiff = Disturbance { stiffness: 0.25, ..none };
    assert_eq!(end(base, 1.0, stiff), end(base, 1.25, none));
    let delayed = ArmModel { delay: base.delay + 0.004, ..base.clone() };
    assert_eq!(end(base, 1.0, Disturbance { delay: 0.004, ..none }), end(&delayed, 1.0, none));
    let smooth = ArmModel { joint_friction: vec![0.0; 6], ..base.clone() };
    assert_eq!(end(base, 1.0, Disturbance { joint_friction: -1.0, ..none }), end(&smooth, 1.0, none));
    let all = [
        none,
        stiff,
        Disturbance { delay: 0.004, ..none },
        Disturbance { joint_friction: -1.0, ..none },
        Disturbance { inertia: 0.3, ..none },
    ];
    let ends = all.map(|disturbance| end(base, 1.0, disturbance));
    assert!((0..all.len()).all(|one| (0..one).all(|other| ends[one] != ends[other])));
}

#[test]
fn disturbances_of_a_free_body_are_those_of_its_inertia_and_stiffness() {
    let record = Record::read("pressing");
    let mut heavy = record.task.clone();
    heavy.inertia = Inertia::from_matrix(heavy.inertia.matrix() * 1.5);
    heavy.impedance.translational_stiffness *= 0.75;
    heavy.impedance.rotational_stiffness *= 0.75;
    let disturbance = Disturbance { inertia: 0.5, stiffness: -0.25, ..Disturbance::default() };
    let disturbed = Injection { grasp: record.grasp, disturbance };
    let expected = Rollout::new(&heavy, Settings::default()).play(&record.reference, record.grasp, |_, _| {});
    assert_eq!(Rollout::new(&record.task, Settings::default()).play(&record.reference, disturbed, |_, _| {}), expected);
}

#[test]
fn evaluations_trajectories_and_any_number_of_threads_see_the_same_arm() {
    let record = Record::read("rubbing");
    // The steps of evaluations, if the control period is no shorter.
    let settings = Settings { friction: 0.3, time_step: 2e-3, ..Settings::default() };
    let rollout = Rollout::new(&record.task, settings).with_steady(4.0).with_arm(&record.model).unwrap();
    let grasps = [[0.0; 3], [0.003, 0.0, 0.0], [0.0, -0.003, 0.002]];
    let outcomes = rollout.simulate(&record.reference, &grasps, &Workers::default());
    assert_eq!(outcomes, rollout.simulate(&record.reference, &grasps, &Workers::new(3)));
    let motions = rollout.trajectory(&record.reference, &grasps, 1e-4).scenarios;
    for (outcome, motion) in outcomes.iter().zip(&motions) {
        assert_eq!(motion.states.len(), record.reference.states().len());
        assert_eq!(motion.quality.position_error, outcome.position_error);
    }
    let success = Success::default();
    let evaluator = Evaluator::new(&record.task, &[0.3], success).with_arm(&record.model).unwrap();
    let case = |grasp: [f64; 3]| TestCase {
        friction: FrictionIndex(0),
        grasp: grasp.into(),
        disturbance: Disturbance::default(),
    };
    let results = evaluator.evaluate_all(&record.reference, &grasps.map(case), &|| false).unwrap();
    for (result, outcome) in results.iter().zip(&outcomes) {
        let shift = outcome.position_error + outcome.unblocked.norm();
        let violation = shift / success.position + outcome.orientation_error / success.orientation;
        assert_eq!(result.violation, if result.passed { 0.0 } else { violation.min(60.0) });
    }
}

#[test]
fn rollouts_of_an_arm_that_go_on_from_earlier_ones_are_like_whole_ones() {
    let record = Record::read("rubbing");
    let mut task = record.task.clone();
    task.goal.0[0] += 0.03;
    let evaluator = Evaluator::new(&task, &[0.0, 0.3], Success::default()).with_arm(&record.model).unwrap();
    let cases = [0, 1].map(|friction| TestCase {
        friction: FrictionIndex(friction),
        grasp: record.grasp,
        disturbance: Disturbance::default(),
    });
    let results = evaluator.evaluate_all(&record.reference, &cases, &|| false).unwrap();
    let refinement = Refinement::new(&evaluator, record.reference, cases.to_vec(), results, 1);
    let improvements = assert_records_are_whole_rollouts(&evaluator, refinement, 40);
    assert!(improvements > 2, "{improvements}");
}

#[test]
fn models_that_cannot_be_are_refused() {
    let record = Record::read("free");
    let refusal = |change: &dyn Fn(&mut ArmModel)| {
        let mut model = record.model.clone();
        change(&mut model);
        Rollout::new(&record.task, Settings::default()).with_arm(&model).unwrap_err().to_string()
    };
    assert_eq!(
        refusal(&|model| model.joint_friction = vec![0.5; 7]),
        "joint_friction has 7 numbers, and the arm 6 joints: give one per joint"
    );
    assert_eq!(refusal(&|model| model.joint_friction[2] = -1.0), "joint_friction = -1 Nm: must lie in [0, 10000] Nm");
    assert_eq!(refusal(&|model| model.control_period = 0.0), "control_period = 0 s: must lie in [0.0001, 0.1] s");
    assert_eq!(refusal(&|model| model.delay = f64::NAN), "delay = NaN s: must lie in [0, 0.1] s");
    assert!(refusal(&|model| model.configuration.truncate(5)).starts_with("configuration: 5 numbers for pan, lift,"));
    let coarse = Settings { time_step: 1.0, ..Settings::default() };
    assert!(Rollout::new(&record.task, coarse).with_arm(&record.model).is_err());
    let far = refusal(&|model| model.arm = model.arm.clone().with_base(&Isometry3::translation(5.0, 0.0, 0.0)));
    assert!(far.starts_with("0 % of the straight path from the goal to the start: the arm does not reach"), "{far}");
}

#[test]
fn absurd_references_and_disturbances_of_an_arm_end() {
    let record = Record::read("rubbing");
    let rollout = Rollout::new(&record.task, Settings { friction: 0.2, settling_time: 0.01, ..Settings::default() });
    let rollout = rollout.with_arm(&record.model).unwrap();
    let start = record.reference.states()[0];
    for value in [-1.0, 1e-300, 1e150, 1e300, f64::INFINITY, f64::NAN] {
        for component in 0..13 {
            let mut state = start;
            state.0[component] = value;
            rollout.play(&Reference::new(0.01, &[start, state, state]), [0.0; 3], |_, _| {});
            rollout.play(&Reference::new(0.01, &[state, start]), [0.0; 3], |_, _| {});
        }
        let none = Disturbance::default();
        for disturbance in [
            Disturbance { inertia: value, ..none },
            Disturbance { stiffness: value, ..none },
            Disturbance { delay: value, ..none },
            Disturbance { joint_friction: value, ..none },
        ] {
            let injection = Injection { disturbance, ..Injection::default() };
            let outcome = rollout.play(&Reference::new(0.01, &[start; 2]), injection, |_, _| {});
            assert_eq!(outcome.diverged, disturbance.validate().is_err(), "{disturbance:?}");
        }
    }
    let still = Reference::new(0.01, &[at_rest([9.0, 0.0, 0.0]); 2]);
    assert!(rollout.play(&still, [0.0; 3], |_, _| {}).diverged, "the arm does not reach that");
}
