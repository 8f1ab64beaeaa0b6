//! Properties of kinematics and dynamics at every configuration.

use std::f64::consts::FRAC_PI_2;
use std::path::Path;
use std::sync::LazyLock;

use nalgebra::{Isometry3, Matrix3, Matrix6, Rotation3, UnitQuaternion, Vector3, Vector6};
use proptest::prelude::*;
use robot::{Arm, JointVector, MOST_JOINTS, RigidInertia};

static SIX: LazyLock<Arm> = LazyLock::new(|| arm("six"));
static SEVEN: LazyLock<Arm> = LazyLock::new(|| arm("seven"));
static GANTRY: LazyLock<Arm> = LazyLock::new(|| arm("gantry"));

fn arm(name: &str) -> Arm {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/arms").join(name).with_extension("urdf");
    let payload = RigidInertia::new(0.8, Vector3::new(0.01, 0.02, 0.03), Matrix3::from_diagonal_element(0.002));
    let arm = Arm::read(&path, "tip").unwrap();
    let rotors = vec![0.1; arm.joints().len()];
    arm.with_base(&frame([0.3, -0.2, 0.1], [0.4, 0.3, -1.2]))
        .with_grasp(&frame([0.01, 0.0, 0.04], [-0.2, 2.0, 0.3]))
        .with_payload(payload.unwrap())
        .with_rotor_inertia(&rotors)
        .unwrap()
}

fn frame(position: [f64; 3], turn: [f64; 3]) -> Isometry3<f64> {
    Isometry3::new(Vector3::from(position), Vector3::from(turn))
}

fn any_arm() -> impl Strategy<Value = &'static Arm> {
    prop_oneof![Just(&*SIX), Just(&*SEVEN), Just(&*GANTRY)]
}

/// Numbers from -1 to 1, zero beyond the last joint.
fn numbers(arm: &Arm, numbers: [f64; MOST_JOINTS]) -> JointVector {
    JointVector::from_fn(|joint, _| if joint < arm.joints().len() { numbers[joint] } else { 0.0 })
}

/// A configuration that is as far between limits, or between -3 and 3, as numbers are between -1 and 1.
fn configuration(arm: &Arm, places: [f64; MOST_JOINTS]) -> JointVector {
    let mut configuration = numbers(arm, places);
    for (position, joint) in configuration.iter_mut().zip(arm.joints()) {
        let (lower, upper) = (joint.lower.max(-3.0), joint.upper.min(3.0));
        *position = 0.5 * (lower + upper) + 0.5 * (upper - lower) * *position;
    }
    configuration
}

fn places() -> impl Strategy<Value = [f64; MOST_JOINTS]> {
    prop::array::uniform8(-0.99..0.99f64)
}

/// Velocity in the world frame and angular velocity in the body frame, from poses before and after a pose.
fn twist(before: &Isometry3<f64>, after: &Isometry3<f64>, time: f64) -> Vector6<f64> {
    let shift = (after.translation.vector - before.translation.vector) / time;
    let turn = before.rotation.rotation_to(&after.rotation);
    // The rotation vector of a turn has the same components in the frames before, between and after it.
    let turn = before.rotation.inverse_transform_vector(&turn.scaled_axis()) / time;
    Vector6::new(shift.x, shift.y, shift.z, turn.x, turn.y, turn.z)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(100))]

    #[test]
    fn the_jacobian_agrees_with_differences(arm in any_arm(), places in places(), speeds in places()) {
        let (position, velocity) = (configuration(arm, places), numbers(arm, speeds));
        let step = 1e-5;
        let [before, after] = [-step, step].map(|step| arm.pose(&(position + velocity * step)));
        let expected = twist(&before, &after, 2.0 * step);
        let actual = arm.at(&position).jacobian() * velocity;
        prop_assert!((expected - actual).amax() < 1e-8, "{expected} {actual}");
    }

    #[test]
    fn a_skeleton_is_rigid_between_joints_that_turn(
        arm in prop_oneof![Just(&*SIX), Just(&*SEVEN)],
        places in places(),
        others in places(),
    ) {
        let [one, other] = [places, others].map(|places| configuration(arm, places));
        let lengths = |configuration| -> Vec<f64> {
            arm.skeleton(configuration).windows(2).map(|ends| (ends[1] - ends[0]).norm()).collect()
        };
        prop_assert_eq!(lengths(&one).len(), arm.joints().len() + 1);
        for (one, other) in lengths(&one).iter().zip(lengths(&other)) {
            prop_assert!((one - other).abs() < 1e-12, "{one} {other}");
        }
        let tip = arm.skeleton(&one)[arm.joints().len() + 1];
        prop_assert!((tip - arm.pose(&one).translation.vector).norm() < 1e-12);
    }

    #[test]
    fn the_rate_of_the_jacobian_agrees_with_differences(arm in any_arm(), places in places(), speeds in places()) {
        let (position, velocity) = (configuration(arm, places), numbers(arm, speeds));
        let step = 1e-5;
        let [before, after] = [-step, step].map(|step| arm.at(&(position + velocity * step)).jacobian() * velocity);
        let expected = (after - before) / (2.0 * step);
        let actual = arm.at(&position).velocity_product(&velocity);
        prop_assert!((expected - actual).amax() < 1e-7, "{expected} {actual}");
    }

    #[test]
    fn required_torque_is_that_of_mass_bias_gravity_and_wrench(
        arm in any_arm(),
        places in places(),
        speeds in places(),
        accelerations in places(),
        wrench in prop::array::uniform6(-10.0..10.0f64),
    ) {
        let configured = arm.at(&configuration(arm, places));
        let (velocity, acceleration) = (numbers(arm, speeds), numbers(arm, accelerations));
        let (field, wrench) = (Vector3::new(0.0, 1.0, -9.7), Vector6::from(wrench));
        let expected = configured.mass_matrix() * acceleration + configured.bias(&velocity) + configured.gravity(&field)
            - configured.jacobian().transpose() * wrench;
        let actual = configured.required_torque(&velocity, &acceleration, &field, &wrench);
        prop_assert!((expected - actual).amax() < 1e-9 * expected.amax().max(1.0), "{expected} {actual}");
    }

    #[test]
    fn the_part_accelerates_under_a_force_as_its_apparent_inertia_says(
        arm in any_arm(),
        places in places(),
        wrench in prop::array::uniform6(-10.0..10.0f64),
    ) {
        let configured = arm.at(&configuration(arm, places));
        prop_assume!(configured.smallest_singular_value() > 0.02);
        let inertia = configured.apparent_inertia().unwrap();
        prop_assert_eq!(inertia, inertia.transpose());
        prop_assert!(inertia.symmetric_eigenvalues().min() > 0.0);
        let wrench = Vector6::from(wrench);
        let jacobian = configured.jacobian();
        let acceleration = configured.mass_matrix().lu().solve(&(jacobian.transpose() * wrench)).unwrap();
        let difference = inertia * (jacobian * acceleration) - wrench;
        prop_assert!(difference.amax() < 1e-7 * wrench.amax(), "{difference}");
    }

    #[test]
    fn inverse_kinematics_leads_back_on_the_same_branch(places in places(), shifts in places()) {
        let position = configuration(&SIX, places);
        prop_assume!(SIX.at(&position).smallest_singular_value() > 0.1);
        let near = position + numbers(&SIX, shifts) * 0.1;
        let found = SIX.inverse_kinematics(&SIX.pose(&position), &near).unwrap();
        prop_assert!((found - position).amax() < 1e-7, "{position} {found}");
    }

    #[test]
    fn a_redundant_arm_reaches_the_pose_near_where_it_was(places in places(), shifts in places()) {
        let position = configuration(&SEVEN, places.map(|place| 0.9 * place));
        prop_assume!(SEVEN.at(&position).smallest_singular_value() > 0.1);
        let near = position + numbers(&SEVEN, shifts) * 0.05;
        let found = SEVEN.inverse_kinematics(&SEVEN.pose(&position), &near).unwrap();
        let [expected, actual] = [position, found].map(|configuration| SEVEN.pose(&configuration));
        prop_assert!((expected.translation.vector - actual.translation.vector).norm() < 1e-9);
        prop_assert!(expected.rotation.angle_to(&actual.rotation) < 1e-9);
        // The shortest way is not longer than the one back, but for its curvature.
        prop_assert!((found - near).norm() < 1.2 * (position - near).norm() + 1e-9);
    }
}

/// Kinetic energy and half a second of the motion without torques and gravity, by Runge and Kutta's steps of fourth order.
fn energies(arm: &Arm, mut position: JointVector, mut velocity: JointVector) -> Vec<f64> {
    const STEP: f64 = 1e-3;
    let acceleration = |position: &JointVector, velocity: &JointVector| {
        let configured = arm.at(position);
        configured.mass_matrix().cholesky().unwrap().solve(&-configured.bias(velocity))
    };
    let mut energies = Vec::new();
    for _ in 0..500 {
        energies.push(0.5 * velocity.dot(&(arm.at(&position).mass_matrix() * velocity)));
        let (v1, a1) = (velocity, acceleration(&position, &velocity));
        let v2 = velocity + a1 * (0.5 * STEP);
        let a2 = acceleration(&(position + v1 * (0.5 * STEP)), &v2);
        let v3 = velocity + a2 * (0.5 * STEP);
        let a3 = acceleration(&(position + v2 * (0.5 * STEP)), &v3);
        let v4 = velocity + a3 * STEP;
        let a4 = acceleration(&(position + v3 * STEP), &v4);
        position += (v1 + v2 * 2.0 + v3 * 2.0 + v4) * (STEP / 6.0);
        velocity += (a1 + a2 * 2.0 + a3 * 2.0 + a4) * (STEP / 6.0);
    }
    energies
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(20))]

    #[test]
    fn an_arm_without_torques_keeps_its_kinetic_energy(arm in any_arm(), places in places(), speeds in places()) {
        let energies = energies(arm, configuration(arm, places), numbers(arm, speeds));
        let drift = energies.iter().map(|energy| (energy / energies[0] - 1.0).abs()).fold(0.0, f64::max);
        prop_assert!(drift < 1e-8, "{drift:e}");
    }
}

#[test]
fn a_wrist_with_two_axes_in_line_is_singular() {
    // The frame of the roll joint is pitched by 0.2 rad itself.
    let at = |pitch: f64, yaw: f64| JointVector::from_column_slice(&[0.1, 0.0, 0.2, yaw, pitch - 0.2, 0.4, 0.0, 0.0]);
    for step in 0..50 {
        let yaw = 0.1 * f64::from(step);
        let (free, in_line) = (GANTRY.at(&at(0.3, yaw)), GANTRY.at(&at(FRAC_PI_2, yaw)));
        assert!(free.smallest_singular_value() > 0.1 && free.apparent_inertia().is_some());
        assert!(in_line.smallest_singular_value() < 1e-12);
        assert_eq!(in_line.apparent_inertia(), None);
    }
}

#[test]
fn positions_that_are_no_numbers_are_a_failure_and_no_endless_loop() {
    let nowhere = JointVector::from_element(f64::NAN);
    let configured = SIX.at(&nowhere);
    assert_eq!(configured.smallest_singular_value(), 0.0);
    assert_eq!(configured.apparent_inertia(), None);
    assert!(SIX.inverse_kinematics(&configured.pose(), &JointVector::zeros()).is_err());
    assert!(SIX.inverse_kinematics(&SIX.pose(&JointVector::zeros()), &nowhere).is_err());
}

#[test]
fn a_rotation_of_the_grasp_turns_the_apparent_inertia() {
    let position = JointVector::from_column_slice(&[0.3, -1.2, 1.5, -0.8, -1.3, 0.4, 0.0, 0.0]);
    let turn = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, -0.8, 0.5));
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/arms/six.urdf");
    let arm = Arm::read(&path, "tip").unwrap();
    let one = arm.at(&position).apparent_inertia().unwrap();
    let turned = arm.clone().with_grasp(&Isometry3::from_parts(Vector3::zeros().into(), turn));
    let other = turned.at(&position).apparent_inertia().unwrap();
    // Forces stay in the world frame, torques are in that of the part.
    let mut change = Matrix6::identity();
    change.fixed_view_mut::<3, 3>(3, 3).copy_from(Rotation3::from(turn).matrix());
    assert!((change.transpose() * one * change - other).amax() < 1e-9);
}
