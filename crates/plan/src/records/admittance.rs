//! The law of a robot that is commanded by position or force.

use admittance::PositionRobot;
use serde::{Deserialize, Serialize};

/// The admittance law that executes a plan, and the robot behind it. Pairs are for translations and rotations.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AdmittanceRecord {
    /// What the robot is commanded: `position` or `force`.
    pub interface: String,
    /// Virtual mass (kg, kg m^2).
    pub mass: [f64; 2],
    /// Damping (Ns/m, Nms/rad).
    pub damping: [f64; 2],
    /// Stiffness (N/m, Nm/rad).
    pub stiffness: [f64; 2],
    /// Time between two samples of the law.
    pub period_s: f64,
    /// Time by which the motion follows the measured wrench at low frequencies.
    pub lag_s: f64,
    /// Stiffness of contacts up to which the law is stable.
    pub contact_stiffness_n_m: f64,
    /// Largest sensitivity of the loop that a contact closes.
    pub sensitivity: f64,
    /// Largest commanded speeds (m/s, rad/s).
    pub speed: [f64; 2],
    /// Largest commanded accelerations (m/s^2, rad/s^2).
    pub acceleration: [f64; 2],
    /// Cutoff frequency of the filter of the measured wrench.
    pub cutoff_hz: f64,
    /// Part of the measured wrench that is ignored (N, Nm).
    pub deadband: [f64; 2],
}

impl From<&PositionRobot> for AdmittanceRecord {
    fn from(robot: &PositionRobot) -> Self {
        let of = robot.contact_loop();
        Self {
            interface: if robot.force_mode.is_some() { "force" } else { "position" }.to_owned(),
            mass: robot.gains.mass,
            damping: robot.gains.damping,
            stiffness: robot.gains.stiffness,
            period_s: robot.period,
            lag_s: of.lag(),
            contact_stiffness_n_m: robot.contact_stiffness,
            sensitivity: of.sensitivity(&robot.gains),
            speed: robot.limits.speed,
            acceleration: robot.limits.acceleration,
            cutoff_hz: robot.sensor.cutoff,
            deadband: robot.force_mode.map_or([0.0; 2], |mode| mode.deadband),
        }
    }
}
