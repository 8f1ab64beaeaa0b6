//! What a robot that is commanded by position is like.

use std::f64::consts::TAU;
use std::fmt;

use task::Inertia;

use crate::contact_loop::{CRITICAL_BANDWIDTH, ContactLoop, LARGEST_SENSITIVITY};
use crate::gains::Gains;

/// A robot that is commanded by position, its sensor, and the law that makes it compliant. Pairs of numbers are those of
/// translations and rotations.
#[derive(Debug, Clone, PartialEq)]
pub struct PositionRobot {
    /// Gains of the admittance law.
    pub gains: Gains,
    /// What spring and damper of the law act on.
    pub feedback: Feedback,
    /// Time between two samples of the law (s).
    pub period: f64,
    /// Time from a sample to the first motion that it causes (s).
    pub delay: f64,
    /// Frequency (Hz) at which the motion is 3 dB smaller than its command.
    pub bandwidth: f64,
    /// Largest speeds and accelerations that are commanded.
    pub limits: Limits,
    /// The force-torque sensor.
    pub sensor: Sensor,
    /// The maker's force mode that the law is, if the robot is commanded a wrench.
    pub force_mode: Option<ForceMode>,
    /// Stiffness (N/m) of everything between flange and ground while parts touch: of parts, gripper, sensor and joints.
    pub contact_stiffness: f64,
    /// Distance (m) from the part's origin at which contacts push.
    pub lever: f64,
    /// Inertia of what the sensor carries.
    pub carried: Inertia,
}

/// What spring and damper of a law act on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Feedback {
    /// The commanded pose and its velocity, as in the plan: the lag of the robot does not come back into the law.
    Commanded,
    /// The spring on the measured pose, damper and mass on the commanded deviation from the reference, as in
    /// `admittance_controller` of ros2_controllers.
    MeasuredPose,
    /// The spring on the measured pose, which a force mode is commanded; the damper is that of the force mode. What moves it
    /// with the reference has the damping of the law (Ns/m, Nms/rad).
    ForceMode {
        /// Of translations and rotations.
        damping: [f64; 2],
    },
}

/// Largest speeds (m/s, rad/s) and accelerations (m/s^2, rad/s^2) of commands, each as a vector's norm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Largest speeds.
    pub speed: [f64; 2],
    /// Largest accelerations.
    pub acceleration: [f64; 2],
}

/// A force mode of a maker.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ForceMode {
    /// Speed that a difference between commanded and measured wrench causes (m/s per N, rad/s per Nm); the inverse damping.
    pub gain: [f64; 2],
    /// Part of the measured wrench that is ignored (N, Nm).
    pub deadband: [f64; 2],
}

/// A force-torque sensor at the flange. Its bias is an error of a rollout, not of the robot.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sensor {
    /// Cutoff frequency (Hz) of its first-order filter.
    pub cutoff: f64,
    /// Standard deviation (N, Nm) of every component of a sample.
    pub noise: [f64; 2],
    /// Smallest step (N, Nm) of every component; zero for none.
    pub resolution: [f64; 2],
}

/// Time (s) by which slow motions follow a servo of this bandwidth (Hz), and the other way round.
fn servo_lag(bandwidth: f64) -> f64 {
    2.0 * CRITICAL_BANDWIDTH / (TAU * bandwidth)
}

/// The law in one line, with what it is stable against.
impl fmt::Display for PositionRobot {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        let Gains { mass, damping, stiffness } = self.gains;
        let of = self.contact_loop();
        let law = if self.force_mode.is_some() { "force mode" } else { "admittance law" };
        write!(
            formatter,
            "{law} every {:.1} ms: stiffness {:.0} N/m and {:.1} Nm/rad, damping {:.0} Ns/m and {:.2} Nms/rad, virtual mass {:.2} kg \
             and {:.4} kg m^2; stable against contacts of up to {:.3e} N/m with a lag of {:.1} ms (largest sensitivity {:.2} of \
             {LARGEST_SENSITIVITY})",
            1e3 * self.period,
            stiffness[0],
            stiffness[1],
            damping[0],
            damping[1],
            mass[0],
            mass[1],
            self.contact_stiffness,
            1e3 * of.lag(),
            of.sensitivity(&self.gains),
        )
    }
}

impl PositionRobot {
    /// Time (s) by which slow motions follow their commands: delay and servo.
    pub fn lag(&self) -> f64 {
        self.delay + servo_lag(self.bandwidth)
    }

    /// With a bandwidth (Hz) and the delay that makes up this lag (s). A servo that is slower than that becomes as fast, without
    /// a delay.
    pub fn with_lag(self, lag: f64, bandwidth: f64) -> Self {
        let servo = servo_lag(bandwidth).min(lag);
        Self { delay: lag - servo, bandwidth: servo_lag(servo), ..self }
    }

    /// The loop that a contact closes.
    pub fn contact_loop(&self) -> ContactLoop {
        ContactLoop {
            period: self.period,
            delay: self.delay,
            bandwidth: self.bandwidth,
            cutoff: self.sensor.cutoff,
            contact_stiffness: self.contact_stiffness,
            lever: self.lever,
        }
    }
}
