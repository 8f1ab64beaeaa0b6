//! Poses that move.

use nalgebra::{Isometry3, Vector3};

/// A pose and its twist.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Motion {
    /// Position (m) and orientation, in the world frame.
    pub pose: Isometry3<f64>,
    /// Velocity (m/s, world frame).
    pub velocity: Vector3<f64>,
    /// Angular velocity (rad/s, body frame).
    pub angular_velocity: Vector3<f64>,
}

impl Motion {
    /// At rest.
    pub fn at_rest(pose: Isometry3<f64>) -> Self {
        Self { pose, velocity: Vector3::zeros(), angular_velocity: Vector3::zeros() }
    }
}
