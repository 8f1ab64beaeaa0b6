//! Poses `(position, quaternion w x y z)` as plain numbers.

use nalgebra::{Isometry3, Matrix3, Quaternion, Translation3, UnitQuaternion, Vector3};

/// Rotation matrix of a quaternion of any norm.
pub fn rotation_matrix(quaternion: &[f64; 4]) -> Matrix3<f64> {
    *unit_quaternion(quaternion).to_rotation_matrix().matrix()
}

/// The same pose with its quaternion scaled to unit norm.
pub fn normalised(pose: &[f64; 7]) -> [f64; 7] {
    let norm = pose[3..].iter().map(|component| component * component).sum::<f64>().sqrt();
    let mut unit = *pose;
    unit[3..].iter_mut().for_each(|component| *component /= norm);
    unit
}

/// Distance (m) between two positions and angle (rad) between two orientations.
pub fn errors(pose: &[f64; 7], goal: &[f64; 7]) -> (f64, f64) {
    let position = (Vector3::from_column_slice(&pose[..3]) - Vector3::from_column_slice(&goal[..3])).norm();
    let actual = unit_quaternion(&[pose[3], pose[4], pose[5], pose[6]]);
    let target = unit_quaternion(&[goal[3], goal[4], goal[5], goal[6]]);
    (position, actual.angle_to(&target))
}

/// A pose as an isometry, from position and quaternion w x y z of any norm.
pub fn isometry([x, y, z, w, i, j, k]: &[f64; 7]) -> Isometry3<f64> {
    Isometry3::from_parts(Translation3::new(*x, *y, *z), unit_quaternion(&[*w, *i, *j, *k]))
}

/// A pose at a fraction of the straight path between two, rotating about one axis.
pub fn interpolate(from: &Isometry3<f64>, to: &Isometry3<f64>, fraction: f64) -> Isometry3<f64> {
    let position = from.translation.vector.lerp(&to.translation.vector, fraction);
    // The scaled axis is that of the shorter rotation, also where the signs of the quaternions differ.
    let rotation = (from.rotation.inverse() * to.rotation).scaled_axis() * fraction;
    Isometry3::from_parts(position.into(), from.rotation * UnitQuaternion::from_scaled_axis(rotation))
}

fn unit_quaternion([w, x, y, z]: &[f64; 4]) -> UnitQuaternion<f64> {
    UnitQuaternion::new_normalize(Quaternion::new(*w, *x, *y, *z))
}
