//! What observers of a rollout see.

use crate::body::Body;
use crate::reference::coordinates;

/// State of the body at one time of a rollout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimedState {
    /// Time since the start (s).
    pub time: f64,
    /// Pose of the body (position m, unit quaternion w x y z).
    pub pose: [f64; 7],
    /// Velocity in the world frame (m/s).
    pub velocity: [f64; 3],
    /// Angular velocity in the body frame (rad/s).
    pub angular_velocity: [f64; 3],
}

impl TimedState {
    pub(crate) fn new(time: f64, body: &Body) -> Self {
        let (velocity, angular_velocity) = (body.velocity.into(), body.angular_velocity.into());
        Self { time, pose: coordinates(&body.pose), velocity, angular_velocity }
    }

    /// Pose and twist in the order of tables and transcriptions.
    pub fn state(&self) -> [f64; 13] {
        let ([x, y, z, w, i, j, k], [vx, vy, vz], [p, q, r]) = (self.pose, self.velocity, self.angular_velocity);
        [x, y, z, w, i, j, k, vx, vy, vz, p, q, r]
    }
}
