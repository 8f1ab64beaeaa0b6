//! Limits, and whether the goal can be reached within them.

use admittance::PositionRobot;
use task::{FORCE_WINDOW, Horizon, Inertia, Limits, Pose};

use crate::error::SceneError;
use crate::pose::StartPose;
use crate::robot::Robot;
use crate::table::Table;

/// Limits that are chosen leave this multiple of the speed with which the goal is reached in time.
const HASTE: f64 = 12.0;

/// Data from which limits of velocities follow where the scene does not give them.
pub struct Motion<'scene> {
    pub starts: &'scene [StartPose],
    pub goal: &'scene Pose,
    pub horizon: Horizon,
    pub inertia: &'scene Inertia,
    /// Largest distance of a point of the body from its origin (m).
    pub radius: f64,
    pub robot: Option<&'scene Robot>,
    pub position_robot: Option<&'scene PositionRobot>,
}

/// The limits that a scene gives; of velocities, else those that its arm and its limit of contact forces allow.
pub fn limits(table: &Table, motion: &Motion) -> Result<Limits, SceneError> {
    let or = |key: &str, otherwise: f64| table.find(key).map_or(Ok(otherwise), |entry| entry.number());
    let limit = |key: &str| or(key, f64::INFINITY);
    let contact_force = limit("contact_force")?;
    let [translational, rotational] = motion.fastest(contact_force);
    Ok(Limits {
        translational_velocity: or("translational_velocity", translational)?,
        rotational_velocity: or("rotational_velocity", rotational)?,
        translational_acceleration: limit("translational_acceleration")?,
        rotational_acceleration: limit("rotational_acceleration")?,
        contact_force,
        force: limit("force")?,
        torque: limit("torque")?,
    })
}

impl Motion<'_> {
    /// Velocity (m/s) and angular velocity (rad/s) that the arm allows, and at which a body that is stopped pushes
    /// within the limit of contact forces (N), as a mean over 10 ms. A robot that is commanded by position moves on for its lag.
    fn fastest(&self, contact_force: f64) -> [f64; 2] {
        let mut arm = self.robot.and_then(Robot::velocities).unwrap_or([f64::INFINITY; 2]);
        let mut speed = contact_force * FORCE_WINDOW / self.inertia.heaviest();
        if let Some(robot) = self.position_robot {
            speed = contact_force / (robot.contact_stiffness * robot.contact_loop().lag());
            arm = [0, 1].map(|part| arm[part].min(robot.limits.speed[part]));
        }
        let gentle = [speed, speed / self.radius];
        let necessary = self.necessary();
        std::array::from_fn(|part| short(arm[part].min(gentle[part].max(HASTE * necessary[part]))))
    }

    /// Smallest velocity (m/s) and angular velocity (rad/s) along an axis for the longest path to the goal.
    fn necessary(&self) -> [f64; 2] {
        let duration = self.horizon.steps as f64 * self.horizon.time_step;
        self.starts.iter().fold([0.0_f64; 2], |[velocity, angular], start| {
            let error = start.pose.error(self.goal);
            [velocity.max(error.position / duration), angular.max(error.orientation / duration)]
        })
    }
}

/// A positive number with three digits, no larger.
fn short(number: f64) -> f64 {
    if !number.is_normal() {
        return number;
    }
    let unit = 10f64.powi(2 - number.log10().floor() as i32);
    (number * unit).floor() / unit
}

/// A limit within which the goal is too far from a start.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error(
    "limits.{key} = {value}: the goal is {distance:.3} {unit} from start `{start}` along an axis, and {steps} steps of \
     {time_step} s within the limits cover {covered:.3} {unit}; allow more than {enough} {unit}/{per}, or more steps \
     in [horizon]",
    steps = horizon.steps,
    time_step = horizon.time_step
)]
pub struct OutOfReach {
    /// Key of the limit in `[limits]`.
    pub key: &'static str,
    /// The limit, in `unit` by `per`.
    pub value: f64,
    /// Name of the start.
    pub start: String,
    /// How far the goal is along the worst axis, in `unit`.
    pub distance: f64,
    /// Largest distance that the body can cover along an axis, in `unit`.
    pub covered: f64,
    /// A limit that suffices, in `unit` by `per`.
    pub enough: f64,
    /// `m` or `rad`.
    pub unit: &'static str,
    /// `s` or `s^2`.
    pub per: &'static str,
    /// Time grid.
    pub horizon: Horizon,
}

/// Translation or rotation from start to goal: its length along the worst axis, and its limits.
struct Path {
    velocity_key: &'static str,
    acceleration_key: &'static str,
    unit: &'static str,
    distance: f64,
    velocity: f64,
    acceleration: f64,
}

/// Checks that the limits of velocity and acceleration let the body get from a start to the goal.
///
/// # Errors
/// The limit that is too small.
pub fn check_reach(limits: &Limits, start: &StartPose, goal: &Pose, horizon: Horizon) -> Result<(), OutOfReach> {
    let farthest = (0..3).map(|axis| (start.pose[axis] - goal[axis]).abs()).fold(0.0, f64::max);
    let angle = start.pose.error(goal).orientation;
    let translational = Path {
        velocity_key: "translational_velocity",
        acceleration_key: "translational_acceleration",
        unit: "m",
        distance: farthest,
        velocity: limits.translational_velocity,
        acceleration: limits.translational_acceleration,
    };
    let rotational = Path {
        velocity_key: "rotational_velocity",
        acceleration_key: "rotational_acceleration",
        unit: "rad",
        // Limits are per axis, so that a rotation about a diagonal is the fastest.
        distance: angle / 3f64.sqrt(),
        velocity: limits.rotational_velocity,
        acceleration: limits.rotational_acceleration,
    };
    translational.check(&start.name, horizon)?;
    rotational.check(&start.name, horizon)
}

impl Path {
    /// Reports the velocity limit where it is too small for any acceleration, else the acceleration limit.
    fn check(&self, start: &str, horizon: Horizon) -> Result<(), OutOfReach> {
        let slowest = self.distance / (horizon.steps as f64 * horizon.time_step);
        let covered = reach(horizon, self.velocity, self.acceleration);
        let (key, value, least, per) = if self.velocity < slowest {
            (self.velocity_key, self.velocity, slowest, "s")
        } else if self.acceleration.is_finite() && covered < self.distance {
            let least = gentlest(horizon, self.velocity, self.distance);
            (self.acceleration_key, self.acceleration, least, "s^2")
        } else {
            return Ok(());
        };
        Err(OutOfReach {
            key,
            value,
            start: start.to_owned(),
            distance: self.distance,
            covered,
            enough: (1e3 * least).ceil() / 1e3,
            unit: self.unit,
            per,
            horizon,
        })
    }
}

/// Least acceleration with which an axis covers a distance from rest; at the velocity limit alone it covers it.
fn gentlest(horizon: Horizon, velocity: f64, distance: f64) -> f64 {
    let steps = horizon.steps as f64;
    let mut least = 2.0 * distance / (horizon.time_step.powi(2) * steps * (steps + 1.0));
    if velocity.is_finite() {
        let mut enough = velocity / horizon.time_step;
        for _ in 0..f64::MANTISSA_DIGITS {
            let middle = 0.5 * (least + enough);
            let limit = if reach(horizon, velocity, middle) < distance { &mut least } else { &mut enough };
            *limit = middle;
        }
    }
    least
}

/// Distance that an axis covers from rest: it accelerates in every step until it is at the velocity limit.
fn reach(horizon: Horizon, velocity: f64, acceleration: f64) -> f64 {
    let (steps, gain) = (horizon.steps as f64, horizon.time_step * acceleration);
    // `min` ignores NaN, the quotient of two limits that are not given.
    let gaining = (velocity / gain).floor().min(steps);
    let gained = if gaining > 0.0 { 0.5 * gain * gaining * (gaining + 1.0) } else { 0.0 };
    let kept = if gaining < steps { velocity * (steps - gaining) } else { 0.0 };
    (gained + kept) * horizon.time_step
}
