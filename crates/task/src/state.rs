//! States `(pose, twist)` as plain numbers.

/// Number of coordinates of a pose: position (m) and quaternion (w x y z).
pub const POSE: usize = 7;
/// Number of coordinates of a twist: velocity (m/s, world frame) and angular velocity (rad/s, body frame).
pub const TWIST: usize = 6;
/// Number of coordinates of a state: pose and twist.
pub const STATE: usize = POSE + TWIST;

/// A pose with zero twist.
pub fn at_rest(pose: &[f64; POSE]) -> [f64; STATE] {
    std::array::from_fn(|index| if index < POSE { pose[index] } else { 0.0 })
}

/// The pose of a state.
pub fn pose_of(state: &[f64; STATE]) -> [f64; POSE] {
    std::array::from_fn(|index| state[index])
}
