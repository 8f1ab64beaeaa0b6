//! Limits, and whether the goal can be reached within them.

use task::{Horizon, Limits, pose};
use toml::Spanned;

use crate::document::LimitsDocument;
use crate::error::{SceneError, Source};
use crate::pose::positive;

/// The limits that a scene gives.
pub fn limits(source: Source, document: &LimitsDocument) -> Result<Limits, SceneError> {
    let limit = |key: &str, value: &Option<Spanned<f64>>| match value {
        Some(value) => positive(source, &format!("limits.{key}"), value),
        None => Ok(f64::INFINITY),
    };
    Ok(Limits {
        translational_velocity: limit("translational_velocity", &document.translational_velocity)?,
        rotational_velocity: limit("rotational_velocity", &document.rotational_velocity)?,
        translational_acceleration: limit("translational_acceleration", &document.translational_acceleration)?,
        rotational_acceleration: limit("rotational_acceleration", &document.rotational_acceleration)?,
        contact_force: limit("contact_force", &document.contact_force)?,
        force: limit("force", &document.force)?,
        torque: limit("torque", &document.torque)?,
    })
}

/// One kind of motion: how far it has to go, and the limits on its way.
struct Way<'document> {
    kind: &'static str,
    unit: &'static str,
    distance: f64,
    velocity: &'document Option<Spanned<f64>>,
    acceleration: &'document Option<Spanned<f64>>,
}

/// Refuses limits of velocity and acceleration within which the goal is too far from a pose of the body at a start, which
/// has a name.
pub fn check_reach(
    source: Source,
    document: &LimitsDocument,
    (start, pose): (&str, &[f64; 7]),
    goal: &[f64; 7],
    horizon: Horizon,
) -> Result<(), SceneError> {
    let farthest = (0..3).map(|axis| (pose[axis] - goal[axis]).abs()).fold(0.0, f64::max);
    let (_, angle) = pose::errors(pose, goal);
    let translational = Way {
        kind: "translational",
        unit: "m",
        distance: farthest,
        velocity: &document.translational_velocity,
        acceleration: &document.translational_acceleration,
    };
    let rotational = Way {
        kind: "rotational",
        unit: "rad",
        // Limits are per axis, so that a turn about a diagonal is the fastest.
        distance: angle / 3f64.sqrt(),
        velocity: &document.rotational_velocity,
        acceleration: &document.rotational_acceleration,
    };
    translational.check(source, start, horizon)?;
    rotational.check(source, start, horizon)
}

impl Way<'_> {
    /// Blames the velocity where it is too small for any acceleration.
    fn check(&self, source: Source, start: &str, horizon: Horizon) -> Result<(), SceneError> {
        let value = |limit: &Option<Spanned<f64>>| limit.as_ref().map_or(f64::INFINITY, |limit| *limit.get_ref());
        let (velocity, acceleration) = (value(self.velocity), value(self.acceleration));
        let slowest = self.distance / (horizon.steps as f64 * horizon.time_step);
        let (name, limit, least) = match (self.velocity, self.acceleration) {
            (Some(limit), _) if velocity < slowest => ("velocity", limit, slowest),
            (_, Some(limit)) if reach(horizon, velocity, acceleration) < self.distance => {
                ("acceleration", limit, gentlest(horizon, velocity, self.distance))
            }
            _ => return Ok(()),
        };
        let Self { kind, unit, distance, .. } = self;
        let enough = (1e3 * least).ceil() / 1e3;
        let (power, covered) = (if name == "velocity" { "" } else { "^2" }, reach(horizon, velocity, acceleration));
        let message = format!(
            "limits.{kind}_{name} = {}: the goal is {distance:.3} {unit} from start `{start}` along an axis, and {} steps \
             of {} s within the limits cover {covered:.3} {unit}; allow more than {enough} {unit}/s{power}, or \
             more steps in [horizon]",
            limit.get_ref(),
            horizon.steps,
            horizon.time_step
        );
        Err(source.error(limit.span(), message))
    }
}

/// Least acceleration with which an axis gets that far from rest. Its velocity limit suffices when it is reached at once.
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

/// How far an axis gets from rest: it gains speed in every step until it is at the limit.
fn reach(horizon: Horizon, velocity: f64, acceleration: f64) -> f64 {
    let speeds = (1..=horizon.steps).map(|step| velocity.min(step as f64 * horizon.time_step * acceleration));
    speeds.sum::<f64>() * horizon.time_step
}
