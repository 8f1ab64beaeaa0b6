//! Distances between poses.

use nalgebra::Isometry3;

/// Components of a deviation: three of the position, then three of the orientation.
pub const COMPONENTS: usize = 6;

/// The position (m) and the rotation vector (rad) of one pose seen from another.
pub fn deviation(pose: &Isometry3<f64>, from: &Isometry3<f64>) -> [f64; COMPONENTS] {
    let shift = pose.translation.vector - from.translation.vector;
    let rotation = (from.rotation.inverse() * pose.rotation).scaled_axis();
    [shift.x, shift.y, shift.z, rotation.x, rotation.y, rotation.z]
}
