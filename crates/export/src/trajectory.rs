//! The reference at the rate of a robot.

use plan::PlannerError;
use store::{StateRow, to_csv};
use task::{Pose, State, Twist};

use crate::frames::{Frames, ToolState};
use crate::smooth::SmoothReference;

/// Most samples of a trajectory: an hour at 1 kHz.
const MOST_SAMPLES: f64 = 3.6e6;
/// An end that is this close (in samples) before a sample is at the sample.
const ROUNDING: f64 = 1e-6;

/// States of the tool at multiples of `1 / rate` (Hz) along a reference. The last sample is at or after its end, at rest.
///
/// # Errors
/// When there are too many samples.
pub fn resample(reference: &SmoothReference, frames: &Frames, rate: f64) -> Result<Vec<ToolState>, PlannerError> {
    let samples_per_knot = reference.time_step() * rate;
    let last = (reference.duration() * rate - ROUNDING).ceil();
    if last > MOST_SAMPLES {
        let rule = format!("makes {last:.0} samples, more than {MOST_SAMPLES:.0}; choose a lower rate");
        return Err(PlannerError::value("rate", rate, &rule));
    }
    let sample = |index: usize| frames.tool_state(&reference.at(index as f64 / samples_per_knot));
    Ok((0..=last as usize).map(sample).collect())
}

/// `trajectory.csv`: samples `1 / rate` apart with the columns of `reference.csv`. Unlike there, the angular velocity is along
/// the axes of the base, as robots want it. The sign of the quaternions does not jump.
///
/// # Errors
/// When a row cannot be written, which no state causes.
pub fn trajectory_csv(states: &[ToolState], rate: f64) -> Result<Vec<u8>, PlannerError> {
    let mut before = [0.0; 4];
    let mut row = |(index, state): (usize, &ToolState)| {
        let pose = Pose::from(&state.pose);
        let mut quaternion = pose.quaternion();
        let jumps = before.iter().zip(&quaternion).map(|(one, other)| one * other).sum::<f64>() < 0.0;
        if jumps {
            quaternion = quaternion.map(|component| -component);
        }
        before = quaternion;
        let pose = Pose::new(pose.position().into(), quaternion);
        StateRow::new(index as f64 / rate, &State::new(&pose, &Twist::new(&state.velocity, &state.angular_velocity)))
    };
    to_csv(states.iter().enumerate().map(&mut row).collect::<Vec<_>>())
}
