//! States of the body, and how its pose moves.

use nalgebra::{Isometry3, Vector3, Vector6};

/// Pose and twist of the body.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Body {
    /// Position (m) and orientation.
    pub pose: Isometry3<f64>,
    /// Velocity in the world frame (m/s).
    pub velocity: Vector3<f64>,
    /// Angular velocity in the body frame (rad/s).
    pub angular_velocity: Vector3<f64>,
}

impl Body {
    /// Takes over a velocity (world frame) and an angular velocity (body frame), one after the other.
    pub fn set_twist(&mut self, twist: &Vector6<f64>) {
        (self.velocity, self.angular_velocity) = (twist.fixed_rows::<3>(0).into(), twist.fixed_rows::<3>(3).into());
    }

    /// Bound on the speed (m/s) of points at most `radius` (m) from the origin.
    pub fn fastest(&self, radius: f64) -> f64 {
        self.velocity.norm() + radius * self.angular_velocity.norm()
    }

    /// Bound on how much the velocity (m/s) of such points has changed since another state.
    pub fn change(&self, before: &Self, radius: f64) -> f64 {
        let (velocity, angular) = (self.velocity - before.velocity, self.angular_velocity - before.angular_velocity);
        velocity.norm() + radius * angular.norm()
    }

    /// Pose and twist at a fraction of the step to those of `next`, which differ little.
    pub fn towards(&self, next: &Self, fraction: f64) -> Self {
        if fraction == 1.0 {
            return *next;
        }
        Self {
            pose: Isometry3::from_parts(
                self.pose.translation.vector.lerp(&next.pose.translation.vector, fraction).into(),
                self.pose.rotation.nlerp(&next.pose.rotation, fraction),
            ),
            velocity: self.velocity.lerp(&next.velocity, fraction),
            angular_velocity: self.angular_velocity.lerp(&next.angular_velocity, fraction),
        }
    }
}
