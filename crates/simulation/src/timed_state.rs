//! What observers of a rollout see.

use nalgebra::Isometry3;
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
    /// Of a robot that is commanded by position or force: its flange, as the position of the believed part and the rotation of
    /// the part where it is believed. The part yields from there under forces.
    pub flange: Option<Isometry3<f64>>,
}

impl TimedState {
    pub(crate) fn new(time: f64, body: &Body) -> Self {
        Self {
            time,
            pose: Pose::from(&body.pose),
            twist: Twist::new(&body.velocity, &body.angular_velocity),
            flange: None,
        }
    }

    /// Pose and twist in the order of tables and transcriptions.
    pub fn state(&self) -> State {
        State::new(&self.pose, &self.twist)
    }
}
