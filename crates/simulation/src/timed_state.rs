//! What observers of a rollout see.

use task::{Pose, State, Twist};

use crate::body::Body;

/// State of the body at one time of a rollout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimedState {
    /// Time since the start (s).
    pub time: f64,
    /// Pose of the body, with a unit quaternion.
    pub pose: Pose,
    /// Velocity and angular velocity of the body.
    pub twist: Twist,
}

impl TimedState {
    pub(crate) fn new(time: f64, body: &Body) -> Self {
        Self { time, pose: Pose::from(&body.pose), twist: Twist::new(&body.velocity, &body.angular_velocity) }
    }

    /// Pose and twist in the order of tables and transcriptions.
    pub fn state(&self) -> State {
        State::new(&self.pose, &self.twist)
    }
}
