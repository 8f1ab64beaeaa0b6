//! States `(pose, twist)` as plain numbers.

use crate::layout::{POSE, STATE};

/// A pose with zero twist.
pub fn at_rest(pose: &[f64; POSE]) -> [f64; STATE] {
    std::array::from_fn(|index| if index < POSE { pose[index] } else { 0.0 })
}

/// The pose of a state.
pub fn pose_of(state: &[f64; STATE]) -> [f64; POSE] {
    std::array::from_fn(|index| state[index])
}
