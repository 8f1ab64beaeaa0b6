//! Poses, twists, wrenches and gains of the tool against those of the part.

use export::Frames;
use nalgebra::{Isometry3, Matrix3, Matrix6, Translation3, UnitQuaternion, Vector3, Vector6};
use proptest::prelude::*;
use simulation::Knot;
use task::{Impedance, Pose, State, Twist, Wrench};

/// Poses within a metre, of any orientation.
fn pose() -> impl Strategy<Value = Isometry3<f64>> {
    (vector(1.0), vector(3.0)).prop_map(|(position, rotation)| {
        Isometry3::from_parts(Translation3::from(position), UnitQuaternion::from_scaled_axis(rotation))
    })
}

fn vector(size: f64) -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-size..size).prop_map(Vector3::from)
}

fn frames() -> impl Strategy<Value = Frames> {
    (pose(), pose()).prop_map(|(base, grasp)| Frames { base, grasp })
}

fn knot() -> impl Strategy<Value = Knot> {
    (pose(), vector(1.0), vector(1.0)).prop_map(|(pose, velocity, angular_velocity)| Knot {
        pose,
        velocity,
        angular_velocity,
    })
}

/// Where a part is after a short time.
fn moved(knot: &Knot, time: f64) -> Isometry3<f64> {
    let rotation = UnitQuaternion::from_scaled_axis(knot.angular_velocity * time);
    Isometry3::from_parts((knot.pose.translation.vector + knot.velocity * time).into(), knot.pose.rotation * rotation)
}

fn stacked(linear: Vector3<f64>, angular: Vector3<f64>) -> Vector6<f64> {
    Vector6::new(linear.x, linear.y, linear.z, angular.x, angular.y, angular.z)
}

/// Symmetric and positive.
fn damping() -> impl Strategy<Value = Matrix3<f64>> {
    prop::array::uniform9(-3.0..3.0).prop_map(|values| {
        let root = Matrix3::from_column_slice(&values);
        root * root.transpose() + Matrix3::identity()
    })
}

proptest! {
    /// The tool is where it holds the part.
    #[test]
    fn the_tool_holds_the_part(frames in frames(), part in pose()) {
        let held = frames.base * frames.tool(&part) * frames.grasp;
        prop_assert!((held.to_homogeneous() - part.to_homogeneous()).norm() < 1e-12);
    }

    /// The twist of the tool is the rate of its pose.
    #[test]
    fn twists_are_the_rates_of_poses(frames in frames(), knot in knot()) {
        let step = 1e-6;
        let state = frames.tool_state(&knot);
        let (before, after) = (frames.tool(&moved(&knot, -step)), frames.tool(&moved(&knot, step)));
        let velocity = (after.translation.vector - before.translation.vector) / (2.0 * step);
        let angular_velocity = (after.rotation * before.rotation.inverse()).scaled_axis() / (2.0 * step);
        prop_assert!((state.velocity - velocity).norm() < 1e-6);
        prop_assert!((state.angular_velocity - angular_velocity).norm() < 1e-6);
    }

    /// A wrench has the same power at the part and at the tool.
    #[test]
    fn wrenches_keep_their_power(frames in frames(), knot in knot(), force in vector(50.0), torque in vector(5.0)) {
        let wrench = Wrench::new(&force, &torque);
        let state = frames.tool_state(&knot);
        let at_tool = frames.tool_wrench(&knot.pose, &wrench).dot(&stacked(state.velocity, state.angular_velocity));
        let at_part = force.dot(&knot.velocity) + torque.dot(&knot.angular_velocity);
        prop_assert!((at_tool - at_part).abs() < 1e-9);
    }

    /// A force at the part turns about the tool point.
    #[test]
    fn a_force_at_the_part_has_a_moment_about_the_tool(grasp in vector(0.3), force in vector(50.0)) {
        let frames = Frames { base: Isometry3::identity(), grasp: Translation3::from(grasp).into() };
        let wrench = frames.tool_wrench(&Isometry3::identity(), &Wrench([force.x, force.y, force.z, 0.0, 0.0, 0.0]));
        let moment: Vector3<f64> = wrench.fixed_rows::<3>(3).into();
        prop_assert!((moment - grasp.cross(&force)).norm() < 1e-12);
    }

    /// For a small deviation of the tool, the gains give the wrench that the impedance law gives for the part.
    #[test]
    fn gains_are_the_law_at_the_tool(
        frames in frames(),
        goal in pose(),
        knot in knot(),
        stiffnesses in (10.0..1000.0, 1.0..100.0),
        translational_damping in damping(),
        rotational_damping in damping(),
    ) {
        let impedance = Impedance {
            translational_stiffness: stiffnesses.0,
            rotational_stiffness: stiffnesses.1,
            translational_damping,
            rotational_damping,
        };
        let small = 1e-6;
        let motion = Knot { pose: goal, ..knot };
        let state = |pose: &Isometry3<f64>, velocity: Vector3<f64>, angular: Vector3<f64>| {
            State::new(&Pose::from(pose), &Twist::new(&velocity, &angular))
        };
        let zero = Vector3::zeros();
        let reference = state(&moved(&motion, small), small * motion.velocity, small * motion.angular_velocity);
        let law = impedance.wrench(&reference, &state(&goal, zero, zero), &Pose::IDENTITY);
        let expected = frames.tool_wrench(&goal, &law) / small;

        let gains = frames.tool_gains(&goal, &impedance);
        let tool = frames.tool_state(&motion);
        let wrench = (gains.stiffness + gains.damping) * stacked(tool.velocity, tool.angular_velocity);
        prop_assert!((wrench - expected).norm() < 1e-4 * (1.0 + expected.norm()));
    }

    /// Gains are symmetric and let nothing gain energy.
    #[test]
    fn gains_are_positive(frames in frames(), goal in pose(), rotational_damping in damping()) {
        let impedance = Impedance {
            translational_stiffness: 400.0,
            rotational_stiffness: 20.0,
            translational_damping: Matrix3::identity() * 60.0,
            rotational_damping,
        };
        let gains = frames.tool_gains(&goal, &impedance);
        for matrix in [gains.stiffness, gains.damping] {
            prop_assert!((matrix - matrix.transpose()).norm() < 1e-9 * matrix.norm());
            prop_assert!(matrix.cholesky().is_some());
        }
    }
}

/// A tool whose origin is that of the part has the plan's own stiffness.
#[test]
fn a_turned_grasp_leaves_the_stiffness() {
    let rotation = UnitQuaternion::from_scaled_axis(Vector3::new(0.3, 2.0, -1.0));
    let frames =
        Frames { base: Isometry3::identity(), grasp: Isometry3::from_parts(Translation3::identity(), rotation) };
    let impedance = Impedance {
        translational_stiffness: 400.0,
        rotational_stiffness: 20.0,
        translational_damping: Matrix3::identity(),
        rotational_damping: Matrix3::identity(),
    };
    let stiffness = frames.tool_gains(&Isometry3::identity(), &impedance).stiffness;
    let expected = Matrix6::from_diagonal(&Vector6::new(400.0, 400.0, 400.0, 20.0, 20.0, 20.0));
    assert!((stiffness - expected).norm() < 1e-9, "{stiffness}");
}
