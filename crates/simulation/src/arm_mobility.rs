//! How an arm answers impulses in a step.

use nalgebra::{Cholesky, Isometry3, SMatrix};
use robot::{Jacobian, JointMatrix, JointVector, MOST_JOINTS};

use crate::least_distance::Vector6;
use crate::metric::Metric;

/// Speeds that impulses give the joints and the part of an arm with a mass matrix.
#[derive(Debug, Clone)]
pub struct ArmMobility {
    /// Of the joints (kg m^2, kg m or kg).
    pub mass: JointMatrix,
    /// Its inverse.
    pub inverse: JointMatrix,
    /// Velocity of the part's origin (world frame), and its angular velocity (body frame), per speed of each joint.
    jacobian: Jacobian,
    /// Speeds of all joints per impulse on the part.
    answer: SMatrix<f64, MOST_JOINTS, 6>,
    /// Of the apparent inertia `(J M^-1 J')^-1`.
    pub metric: Metric,
}

impl ArmMobility {
    /// `None` where the arm is singular or a value is not finite.
    pub fn new(mass: JointMatrix, jacobian: &Jacobian) -> Option<Self> {
        let inverse = Cholesky::new(mass)?.inverse();
        let answer = inverse * jacobian.transpose();
        let metric = Metric::of_mobility(&(jacobian * answer))?;
        Some(Self { mass, inverse, jacobian: *jacobian, answer, metric })
    }

    /// Scaled velocity of the part at joint speeds (rad/s or m/s).
    pub fn scaled(&self, velocity: &JointVector) -> Vector6 {
        let twist = self.jacobian * velocity;
        self.metric.scale_velocity(&twist.fixed_rows::<3>(0).into(), &twist.fixed_rows::<3>(3).into())
    }

    /// How the joints move (rad or m) when the part is moved from one pose to another nearby by impulses on it.
    pub fn correction(&self, from: &Isometry3<f64>, to: &Isometry3<f64>) -> JointVector {
        let shift = to.translation.vector - from.translation.vector;
        let rotation = (from.rotation.inverse() * to.rotation).scaled_axis();
        self.change(&self.metric.scale_velocity(&shift, &rotation))
    }

    /// The inverse while contacts hold the scaled velocity of the part in some directions, which are orthonormal.
    pub fn held(&self, directions: &[Vector6]) -> JointMatrix {
        directions.iter().fold(self.inverse, |inverse, direction| {
            // The change of joint speeds along a direction is also the component of velocity that an impulse of a joint
            // gives along it.
            let change = self.change(direction);
            inverse - change * change.transpose()
        })
    }

    /// How joint speeds (rad/s or m/s) change when impulses on the part change its scaled velocity.
    pub fn change(&self, scaled: &Vector6) -> JointVector {
        self.answer * self.metric.momentum(scaled)
    }
}
