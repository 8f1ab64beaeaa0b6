//! States, twists and wrenches as plain numbers.

use std::ops::Deref;

use nalgebra::Vector3;
use serde::{Deserialize, Serialize};

use crate::pose::{POSE, Pose};

/// Number of coordinates of a twist or wrench.
pub const TWIST: usize = 6;
/// Number of coordinates of a state.
pub const STATE: usize = POSE + TWIST;

/// Velocity (m/s, world frame) and angular velocity (rad/s, body frame). It reads as the array of its numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(transparent)]
pub struct Twist(pub [f64; TWIST]);

/// Force (N, world frame) and torque (Nm, body frame). It reads as the array of its numbers.
#[derive(Debug, Clone, Copy, PartialEq)]
#[repr(transparent)]
pub struct Wrench(pub [f64; TWIST]);

/// Pose and twist. It reads as the array of its numbers: position (m), quaternion (w x y z), velocity (m/s, world
/// frame), angular velocity (rad/s, body frame).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
#[repr(transparent)]
pub struct State(pub [f64; STATE]);

impl Twist {
    /// Of what does not move.
    pub const ZERO: Self = Self([0.0; TWIST]);

    /// From a velocity (m/s, world frame) and an angular velocity (rad/s, body frame).
    pub fn new(velocity: &Vector3<f64>, angular_velocity: &Vector3<f64>) -> Self {
        Self(joined(velocity, angular_velocity))
    }

    /// Velocity (m/s, world frame).
    pub fn velocity(&self) -> Vector3<f64> {
        halves(&self.0).0
    }

    /// Angular velocity (rad/s, body frame).
    pub fn angular_velocity(&self) -> Vector3<f64> {
        halves(&self.0).1
    }
}

impl Wrench {
    /// No force and no torque.
    pub const ZERO: Self = Self([0.0; TWIST]);

    /// From a force (N, world frame) and a torque (Nm, body frame).
    pub fn new(force: &Vector3<f64>, torque: &Vector3<f64>) -> Self {
        Self(joined(force, torque))
    }

    /// Force (N, world frame).
    pub fn force(&self) -> Vector3<f64> {
        halves(&self.0).0
    }

    /// Torque (Nm, body frame).
    pub fn torque(&self) -> Vector3<f64> {
        halves(&self.0).1
    }
}

impl State {
    /// From a pose and a twist.
    pub fn new(pose: &Pose, twist: &Twist) -> Self {
        Self(std::array::from_fn(|index| if index < POSE { pose[index] } else { twist[index - POSE] }))
    }

    /// Position and quaternion.
    pub fn pose(&self) -> Pose {
        Pose(std::array::from_fn(|index| self[index]))
    }

    /// Velocity and angular velocity.
    pub fn twist(&self) -> Twist {
        Twist(std::array::from_fn(|index| self[POSE + index]))
    }

    /// The same state with its quaternion scaled to unit norm.
    pub fn normalised(&self) -> Self {
        Self::new(&self.pose().normalised(), &self.twist())
    }
}

macro_rules! reads_as_an_array {
    ($($name:ident of $length:ident),*) => {
        $(impl Deref for $name {
            type Target = [f64; $length];

            fn deref(&self) -> &Self::Target {
                &self.0
            }
        })*
    };
}

reads_as_an_array!(Twist of TWIST, Wrench of TWIST, State of STATE);

fn joined(one: &Vector3<f64>, other: &Vector3<f64>) -> [f64; TWIST] {
    [one.x, one.y, one.z, other.x, other.y, other.z]
}

fn halves(&[a, b, c, d, e, f]: &[f64; TWIST]) -> (Vector3<f64>, Vector3<f64>) {
    (Vector3::new(a, b, c), Vector3::new(d, e, f))
}
