//! What steps need of an arm at its joint positions.

use nalgebra::{Cholesky, Isometry3, SMatrix, Vector3};
use robot::{Arm, Jacobian, JointMatrix, JointVector, MOST_JOINTS};

use crate::least_distance::Vector6;
use crate::metric::Metric;

/// An arm at joint positions whose part sits where it really does.
#[derive(Debug, Clone)]
pub struct ArmPosture {
    /// Joint positions (rad or m).
    pub configuration: JointVector,
    /// Of the part.
    pub pose: Isometry3<f64>,
    /// Torques (Nm or N) of Coriolis and centrifugal forces.
    pub bias: JointVector,
    /// Torques (Nm or N) that carry the arm.
    pub weight: JointVector,
    /// Velocity of that point (world frame), and the angular velocity in the part's frame, per speed of each joint.
    pub tracked: Jacobian,
    /// Velocity of the part's origin (world frame), and the same angular velocity.
    pub jacobian: Jacobian,
    /// Of the joints (kg m^2, kg m or kg).
    pub mass: JointMatrix,
    /// Its inverse.
    pub mobility: JointMatrix,
    /// Speeds of all joints per impulse on the part.
    pub answer: SMatrix<f64, MOST_JOINTS, 6>,
    /// Of the apparent inertia `(J M^-1 J')^-1`.
    pub metric: Metric,
}

/// Acceleration by gravity (m/s^2, world frame).
const GRAVITY: Vector3<f64> = Vector3::new(0.0, 0.0, -9.81);

impl ArmPosture {
    /// At joint positions `configuration` (rad or m) and speeds `velocity` (rad/s or m/s). With `grasp`, the believed part in
    /// the frame of the part, and the mass matrix times `heaviness`. `None` where the arm is singular or a number is none.
    pub fn new(
        arm: &Arm,
        (configuration, velocity): (&JointVector, &JointVector),
        grasp: &Isometry3<f64>,
        heaviness: f64,
    ) -> Option<Self> {
        let posture = arm.posture(configuration);
        let pose = posture.pose() * grasp.inverse();
        let mut tracked = posture.jacobian();
        let angular = grasp.rotation.to_rotation_matrix() * tracked.fixed_rows::<3>(3);
        tracked.fixed_rows_mut::<3>(3).copy_from(&angular);
        // The part's origin is not where it is believed: it moves as the part turns.
        let lever = -(pose.rotation * grasp.translation.vector);
        let mut jacobian = tracked;
        let turning = pose.rotation.to_rotation_matrix() * angular;
        for joint in 0..MOST_JOINTS {
            let shift = turning.column(joint).cross(&lever);
            jacobian.fixed_view_mut::<3, 1>(0, joint).zip_apply(&shift, |velocity, shift| *velocity += shift);
        }
        let mass = posture.mass_matrix() * heaviness;
        let mobility = Cholesky::new(mass)?.inverse();
        let answer = mobility * jacobian.transpose();
        let metric = Metric::of_mobility(&(jacobian * answer))?;
        let (bias, weight) = (posture.bias(velocity), posture.gravity(&GRAVITY));
        Some(Self {
            configuration: *configuration,
            pose,
            bias,
            weight,
            tracked,
            jacobian,
            mass,
            mobility,
            answer,
            metric,
        })
    }

    /// Scaled velocity of the part at joint speeds (rad/s or m/s).
    pub fn scaled(&self, velocity: &JointVector) -> Vector6 {
        let twist = self.jacobian * velocity;
        self.metric.scale_velocity(&twist.fixed_rows::<3>(0).into(), &twist.fixed_rows::<3>(3).into())
    }

    /// How the joints move (rad or m) when the part is moved from one pose to another nearby by impulses on it.
    pub fn correction(&self, from: &Isometry3<f64>, to: &Isometry3<f64>) -> JointVector {
        let shift = to.translation.vector - from.translation.vector;
        let turn = (from.rotation.inverse() * to.rotation).scaled_axis();
        self.change(&self.metric.scale_velocity(&shift, &turn))
    }

    /// The mobility while contacts hold the scaled velocity of the part in some directions, which are orthonormal.
    pub fn mobility_held(&self, directions: &[Vector6]) -> JointMatrix {
        directions.iter().fold(self.mobility, |mobility, direction| {
            // A direction's change of the joint speeds is also its component of the velocity that a joint's impulse gives.
            let change = self.change(direction);
            mobility - change * change.transpose()
        })
    }

    /// How joint speeds (rad/s or m/s) change when impulses on the part change its scaled velocity.
    pub fn change(&self, scaled: &Vector6) -> JointVector {
        self.answer * self.metric.momentum(scaled)
    }
}
