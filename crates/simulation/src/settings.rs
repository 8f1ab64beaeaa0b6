//! How a rollout is computed.

use std::ops::RangeInclusive;

use crate::reference::Reference;
use crate::settings_error::{SettingsError, check};

/// Time step, friction and settling time of a rollout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Time step (s), 1e-6 to 0.1. The interval between two knots is divided into equal steps that are not longer.
    /// Where the velocity changes little, up to 64 of them are taken as one, by the midpoint rule.
    pub time_step: f64,
    /// Coulomb's coefficient, 0 to 10; 0 is the frictionless contact of the paper. Friction is Anitescu's convex
    /// approximation (Optimization-based simulation of nonsmooth rigid multibody dynamics, 2006), without the gap on which
    /// bodies slide there: sticking, sliding and their forces are Coulomb's.
    pub friction: f64,
    /// How long the last reference pose is held (s), 0 to 600, rounded up to whole intervals between knots.
    pub settling_time: f64,
}

impl Default for Settings {
    fn default() -> Self {
        Self { time_step: 1e-3, friction: 0.0, settling_time: 1.0 }
    }
}

/// A quotient that exceeds a whole number by no more than this is that number: 0.033 / 0.001 is 33.
const ROUNDING: f64 = 1e-9;

impl Settings {
    /// Allowed time steps (s).
    pub const TIME_STEPS: RangeInclusive<f64> = 1e-6..=0.1;
    /// Allowed friction coefficients.
    pub const FRICTIONS: RangeInclusive<f64> = 0.0..=10.0;
    /// Allowed settling times (s).
    pub const SETTLING_TIMES: RangeInclusive<f64> = 0.0..=600.0;
    /// Allowed times between two knots of a reference (s).
    pub const KNOT_INTERVALS: RangeInclusive<f64> = 1e-6..=1e3;
    /// Largest number of time steps of one rollout, settling included: minutes of computation.
    pub const MAX_STEPS: usize = 10_000_000;

    /// Whether every field lies in its range.
    ///
    /// # Errors
    /// The first field that does not, with its value and its range.
    pub fn validate(&self) -> Result<(), SettingsError> {
        check("time_step", self.time_step, &Self::TIME_STEPS, "s")?;
        check("friction", self.friction, &Self::FRICTIONS, "")?;
        check("settling_time", self.settling_time, &Self::SETTLING_TIMES, "s")
    }

    /// Whether a rollout of a reference can be computed with these settings: every field lies in its range, and the
    /// rollout takes at most [`Settings::MAX_STEPS`] steps.
    ///
    /// # Errors
    /// The first value that is out of its range.
    pub fn validate_for(&self, reference: &Reference) -> Result<(), SettingsError> {
        self.validate()?;
        let interval = reference.time_step();
        check("time step of the reference", interval, &Self::KNOT_INTERVALS, "s")?;
        let intervals = reference.intervals() as f64 + self.settling_count(interval);
        let steps = intervals * self.step_count(interval);
        check("steps of the rollout", steps, &(0.0..=Self::MAX_STEPS as f64), "")
    }

    /// Step (s) and number of steps in an interval between two knots (s); at most [`Settings::MAX_STEPS`] steps.
    pub fn divide(&self, interval: f64) -> (f64, usize) {
        let count = self.step_count(interval).min(Self::MAX_STEPS as f64);
        (interval / count, count as usize)
    }

    /// Number of intervals between knots (s) for which the last pose is held, at most [`Settings::MAX_STEPS`].
    pub fn settling_intervals(&self, interval: f64) -> usize {
        self.settling_count(interval).min(Self::MAX_STEPS as f64) as usize
    }

    /// At least one, also when the quotient is NaN.
    fn step_count(&self, interval: f64) -> f64 {
        (interval / self.time_step - ROUNDING).ceil().max(1.0)
    }

    /// At least zero, also when the quotient is NaN.
    fn settling_count(&self, interval: f64) -> f64 {
        (self.settling_time / interval - ROUNDING).ceil().max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use task::Pose;

    use super::*;

    const REST: Pose = Pose::IDENTITY;

    #[test]
    fn fields_out_of_range_are_named_with_value_and_range() {
        let default = Settings::default();
        assert_eq!(default.validate(), Ok(()));
        for (settings, message) in [
            (Settings { time_step: 10.0, ..default }, "time_step = 10 s: must lie in [1e-6, 0.1] s"),
            (Settings { time_step: 0.0, ..default }, "time_step = 0 s: must lie in [1e-6, 0.1] s"),
            (Settings { friction: -0.5, ..default }, "friction = -0.5: must lie in [0, 10]"),
            (Settings { friction: f64::NAN, ..default }, "friction = NaN: must lie in [0, 10]"),
            (Settings { settling_time: 1e300, ..default }, "settling_time = 1e300 s: must lie in [0, 600] s"),
        ] {
            assert_eq!(settings.validate().unwrap_err().to_string(), message);
        }
    }

    #[test]
    fn rollouts_of_too_many_steps_are_refused() {
        let reference = |interval: f64| Reference::new(interval, &[REST.at_rest(); 11]);
        let finest = Settings { time_step: 1e-6, settling_time: 0.0, ..Settings::default() };
        assert_eq!(finest.validate_for(&reference(1.0)), Ok(()));
        let error = finest.validate_for(&reference(2.0)).unwrap_err().to_string();
        assert_eq!(error, "steps of the rollout = 20000000: must lie in [0, 10000000]");
        let longest = Settings { settling_time: 600.0, ..Settings::default() };
        assert_eq!(longest.validate_for(&reference(0.04)), Ok(()));
        assert!(longest.validate_for(&reference(1e-6)).is_err());
        let error = longest.validate_for(&reference(1e-300)).unwrap_err().to_string();
        assert_eq!(error, "time step of the reference = 1e-300 s: must lie in [1e-6, 1000] s");
    }

    #[test]
    fn absurd_numbers_divide_into_a_bounded_number_of_steps() {
        let absurd = [0.0, -1.0, 1e-300, 1e300, f64::INFINITY, f64::NEG_INFINITY, f64::NAN];
        for time_step in absurd {
            for interval in absurd {
                let settings = Settings { time_step, settling_time: 1e300, ..Settings::default() };
                assert!((1..=Settings::MAX_STEPS).contains(&settings.divide(interval).1));
                assert!(settings.settling_intervals(interval) <= Settings::MAX_STEPS);
            }
        }
    }

    #[test]
    fn intervals_are_divided_without_rounding_up_twice() {
        let settings = Settings::default();
        assert_eq!(settings.divide(0.033).1, 33);
        assert_eq!(settings.divide(0.0334).1, 34);
        assert_eq!(settings.settling_intervals(0.04), 25);
    }
}
