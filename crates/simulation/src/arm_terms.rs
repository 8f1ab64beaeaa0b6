//! Terms of an arm's equations of motion.

use nalgebra::{Isometry3, Matrix6, Vector3};
use robot::{Arm, Jacobian, JointMatrix, JointVector, MOST_JOINTS};
use task::{GraspError, Impedance, Pose, State, Twist};

use crate::arm_mobility::ArmMobility;
use crate::least_distance::Vector6;
use crate::reference::Knot;

/// The terms of the equations of motion at joint positions, for a part in its real place in the gripper.
#[derive(Debug, Clone)]
pub struct ArmTerms {
    /// Joint positions (rad or m).
    pub configuration: JointVector,
    /// Of the part.
    pub pose: Isometry3<f64>,
    /// Torques (Nm or N) of Coriolis and centrifugal forces.
    pub bias: JointVector,
    /// Torques (Nm or N) that support the arm's weight.
    pub weight: JointVector,
    /// Velocity of the point where the controller believes the part's origin (world frame), and the angular velocity in the
    /// part's frame, per speed of each joint.
    pub tracked: Jacobian,
    /// Velocity of the part's origin (world frame), and the same angular velocity.
    pub jacobian: Jacobian,
    /// In the shortest steps.
    pub mobility: ArmMobility,
}

/// Acceleration by gravity (m/s^2, world frame).
const GRAVITY: Vector3<f64> = Vector3::new(0.0, 0.0, -9.81);

impl ArmTerms {
    /// At joint positions `configuration` (rad or m) and speeds `velocity` (rad/s or m/s). `grasp` is the believed part
    /// in the frame of the part; the mass matrix is multiplied by `inertia_scale`. `None` where the arm is singular or
    /// a value is not finite.
    pub fn new(
        arm: &Arm,
        configuration: &JointVector,
        velocity: &JointVector,
        grasp: &Isometry3<f64>,
        inertia_scale: f64,
    ) -> Option<Self> {
        let configured = arm.at(configuration);
        let pose = configured.pose() * grasp.inverse();
        let mut tracked = configured.jacobian();
        let angular = grasp.rotation.to_rotation_matrix() * tracked.fixed_rows::<3>(3);
        tracked.fixed_rows_mut::<3>(3).copy_from(&angular);
        // The part's origin is not where it is believed: it moves as the part rotates.
        let lever = -(pose.rotation * grasp.translation.vector);
        let mut jacobian = tracked;
        let turning = pose.rotation.to_rotation_matrix() * angular;
        for joint in 0..MOST_JOINTS {
            let shift = turning.column(joint).cross(&lever);
            jacobian.fixed_view_mut::<3, 1>(0, joint).zip_apply(&shift, |velocity, shift| *velocity += shift);
        }
        let mobility = ArmMobility::new(configured.mass_matrix() * inertia_scale, &jacobian)?;
        let (bias, weight) = (configured.bias(velocity), configured.gravity(&GRAVITY));
        Some(Self { configuration: *configuration, pose, bias, weight, tracked, jacobian, mobility })
    }

    /// Torques (Nm or N) of the impedance law with the part `believed` at a pose and the joints at speeds `velocity` (rad/s or
    /// m/s).
    pub fn torque(
        &self,
        impedance: &Impedance,
        believed: &Isometry3<f64>,
        velocity: &JointVector,
        target: &Knot,
    ) -> JointVector {
        let state = State::new(&Pose::from(believed), &Twist((self.tracked * velocity).into()));
        let wrench = impedance.wrench(&target.state(), &state, &GraspError::default().pose());
        self.tracked.tr_mul(&Vector6::from(wrench.0))
    }

    /// An inertia, damping or stiffness of the believed part in joint space.
    pub fn of_joints(&self, matrix: &Matrix6<f64>) -> JointMatrix {
        self.tracked.tr_mul(&(matrix * self.tracked))
    }
}
