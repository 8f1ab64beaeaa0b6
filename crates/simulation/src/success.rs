//! What counts as success, and how certain a success rate is.

use std::ops::RangeInclusive;

use crate::settings_error::{SettingsError, check};

/// Largest final errors of a successful rollout.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Success {
    /// Distance from the goal (m), 1e-9 to 1000.
    pub position: f64,
    /// Angle to the goal (rad), 1e-9 to 10.
    pub orientation: f64,
}

impl Default for Success {
    fn default() -> Self {
        Self { position: 3e-3, orientation: 0.1 }
    }
}

impl Success {
    /// Allowed distances from the goal (m).
    pub const POSITIONS: RangeInclusive<f64> = 1e-9..=1e3;
    /// Allowed angles to the goal (rad). No orientation is further away than pi.
    pub const ORIENTATIONS: RangeInclusive<f64> = 1e-9..=10.0;

    /// Whether both tolerances lie in their ranges.
    ///
    /// # Errors
    /// The first tolerance that does not, with its value and its range.
    pub fn validate(&self) -> Result<(), SettingsError> {
        check("position", self.position, &Self::POSITIONS, "m")?;
        check("orientation", self.orientation, &Self::ORIENTATIONS, "rad")
    }

    /// Whether final errors (m, rad) are within the tolerances.
    pub fn reached(&self, position_error: f64, orientation_error: f64) -> bool {
        position_error <= self.position && orientation_error <= self.orientation
    }
}

/// Wilson's 95 % confidence interval of the probability of success, after `successes` in `trials`.
pub fn wilson_interval(successes: usize, trials: usize) -> [f64; 2] {
    // Quantile of the normal distribution at 97.5 %.
    const Z: f64 = 1.959_963_984_540_054;
    if trials == 0 {
        return [0.0, 1.0];
    }
    let (count, rate) = (trials as f64, successes as f64 / trials as f64);
    let center = rate + Z * Z / (2.0 * count);
    let half = Z * (rate * (1.0 - rate) / count + Z * Z / (4.0 * count * count)).sqrt();
    let scale = 1.0 + Z * Z / count;
    [((center - half) / scale).max(0.0), ((center + half) / scale).min(1.0)]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tolerances_out_of_range_are_named() {
        let default = Success::default();
        assert_eq!(default.validate(), Ok(()));
        let error = Success { position: 0.0, ..default }.validate().unwrap_err().to_string();
        assert_eq!(error, "position = 0 m: must lie in [1e-9, 1000] m");
        assert!(Success { orientation: f64::NAN, ..default }.validate().is_err());
    }

    #[test]
    fn wilson_intervals_are_those_of_the_literature() {
        for (successes, trials, low, high) in [
            (0, 10, 0.0, 0.277_533),
            (5, 10, 0.236_593, 0.763_407),
            (10, 10, 0.722_467, 1.0),
            (90, 90, 0.959_064, 1.0),
            (24, 30, 0.626_947, 0.904_952),
        ] {
            let [actual_low, actual_high] = wilson_interval(successes, trials);
            assert!((actual_low - low).abs() < 1e-5, "{successes} of {trials}: {actual_low}");
            assert!((actual_high - high).abs() < 1e-5, "{successes} of {trials}: {actual_high}");
        }
        assert_eq!(wilson_interval(0, 0), [0.0, 1.0]);
    }
}
