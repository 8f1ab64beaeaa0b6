//! What a step needs of an arm at its joint positions.

use nalgebra::{Cholesky, Isometry3, SMatrix, Vector3};
use robot::{Arm, Jacobian, JointMatrix, JointVector, MOST_JOINTS, Posture};

use crate::least_distance::Vector6;
use crate::metric::Metric;

/// An arm at joint positions whose part sits where it really does.
#[derive(Debug, Clone)]
pub struct ArmPosture<'arm> {
    /// With the part where the robot believes it.
    pub posture: Posture<'arm>,
    /// Of the part.
    pub pose: Isometry3<f64>,
    /// Where the controller believes the part's origin (m, world frame).
    pub believed: Vector3<f64>,
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

impl<'arm> ArmPosture<'arm> {
    /// With `grasp`, the believed part in the frame of the part, and the mass matrix times `heaviness`. `None` where the
    /// arm is singular or a number is none.
    pub fn new(arm: &'arm Arm, configuration: &JointVector, grasp: &Isometry3<f64>, heaviness: f64) -> Option<Self> {
        let posture = arm.posture(configuration);
        let believed = posture.pose();
        let pose = believed * grasp.inverse();
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
        let believed = believed.translation.vector;
        Some(Self { posture, pose, believed, tracked, jacobian, mass, mobility, answer, metric })
    }

    /// Scaled velocity of the part at joint speeds (rad/s or m/s).
    pub fn scaled(&self, velocity: &JointVector) -> Vector6 {
        let twist = self.jacobian * velocity;
        self.metric.scale_velocity(&twist.fixed_rows::<3>(0).into(), &twist.fixed_rows::<3>(3).into())
    }

    /// How the joints move (rad or m) when the part is moved to another pose nearby by impulses on it.
    pub fn correction(&self, pose: &Isometry3<f64>) -> JointVector {
        let shift = pose.translation.vector - self.pose.translation.vector;
        let turn = (self.pose.rotation.inverse() * pose.rotation).scaled_axis();
        self.change(&self.metric.scale_velocity(&shift, &turn))
    }

    /// How joint speeds (rad/s or m/s) change when impulses on the part change its scaled velocity.
    pub fn change(&self, scaled: &Vector6) -> JointVector {
        self.answer * self.metric.momentum(scaled)
    }
}
