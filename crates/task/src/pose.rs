//! Poses as plain numbers.

use std::ops::Deref;

use nalgebra::{Isometry3, Matrix3, Quaternion, Translation3, UnitQuaternion, Vector3};
use serde::{Deserialize, Serialize};

use crate::state::{State, Twist};

/// Number of coordinates of a pose.
pub const POSE: usize = 7;

/// Position (m) and quaternion (w x y z). It reads as the array of its numbers, which is what files and kernels have.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(transparent)]
#[repr(transparent)]
pub struct Pose(pub [f64; POSE]);

/// How far a pose is from another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PoseError {
    /// Distance of the positions (m).
    pub position: f64,
    /// Angle between the orientations (rad).
    pub orientation: f64,
}

impl Pose {
    /// The origin of a frame, with its axes.
    pub const IDENTITY: Self = Self([0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0]);

    /// From a position (m) and a quaternion w x y z.
    pub fn new([x, y, z]: [f64; 3], [w, i, j, k]: [f64; 4]) -> Self {
        Self([x, y, z, w, i, j, k])
    }

    /// From numbers that a user gave, with the quaternion scaled to unit norm.
    ///
    /// # Errors
    /// What a pose needs, where the numbers are none.
    pub fn given(numbers: [f64; POSE]) -> Result<Self, &'static str> {
        /// Largest number that means anything (m).
        const LARGEST: f64 = 1e6;
        let pose = Self(numbers).normalised();
        let is_pose =
            numbers.iter().all(|number| number.abs() <= LARGEST) && pose.iter().all(|number| number.is_finite());
        is_pose.then_some(pose).ok_or("a pose needs finite numbers and a quaternion that is not zero")
    }

    /// Position (m).
    pub fn position(&self) -> Vector3<f64> {
        let [x, y, z, ..] = self.0;
        Vector3::new(x, y, z)
    }

    /// Quaternion w x y z as it is.
    pub fn quaternion(&self) -> [f64; 4] {
        let [_, _, _, quaternion @ ..] = self.0;
        quaternion
    }

    /// Orientation, of a quaternion of any norm.
    pub fn orientation(&self) -> UnitQuaternion<f64> {
        let [w, x, y, z] = self.quaternion();
        UnitQuaternion::new_normalize(Quaternion::new(w, x, y, z))
    }

    /// Rotation matrix, of a quaternion of any norm.
    pub fn rotation_matrix(&self) -> Matrix3<f64> {
        *self.orientation().to_rotation_matrix().matrix()
    }

    /// The frame that has this pose, with a quaternion of any norm.
    pub fn isometry(&self) -> Isometry3<f64> {
        Isometry3::from_parts(Translation3::from(self.position()), self.orientation())
    }

    /// The same pose with its quaternion scaled to unit norm.
    pub fn normalised(&self) -> Self {
        let quaternion = self.quaternion();
        let norm = quaternion.iter().map(|component| component * component).sum::<f64>().sqrt();
        Self::new(self.position().into(), quaternion.map(|component| component / norm))
    }

    /// How far the pose is from a goal; quaternions may be of any norm.
    pub fn error(&self, goal: &Self) -> PoseError {
        PoseError {
            position: (self.position() - goal.position()).norm(),
            orientation: self.orientation().angle_to(&goal.orientation()),
        }
    }

    /// The state without a velocity.
    pub fn at_rest(&self) -> State {
        State::new(self, &Twist::ZERO)
    }
}

impl From<&Isometry3<f64>> for Pose {
    fn from(frame: &Isometry3<f64>) -> Self {
        let rotation = frame.rotation;
        Self::new(frame.translation.vector.into(), [rotation.w, rotation.i, rotation.j, rotation.k])
    }
}

impl Deref for Pose {
    type Target = [f64; POSE];

    fn deref(&self) -> &Self::Target {
        &self.0
    }
}

/// The numbers of many poses, as [`collision::Pair`] takes them.
pub fn arrays(poses: &[Pose]) -> Vec<[f64; POSE]> {
    poses.iter().map(|pose| pose.0).collect()
}

/// A pose at a fraction of the straight path between two, rotating about one axis.
pub fn interpolate(from: &Isometry3<f64>, to: &Isometry3<f64>, fraction: f64) -> Isometry3<f64> {
    let position = from.translation.vector.lerp(&to.translation.vector, fraction);
    // The scaled axis is that of the shorter rotation, also where the signs of the quaternions differ.
    let rotation = (from.rotation.inverse() * to.rotation).scaled_axis() * fraction;
    Isometry3::from_parts(position.into(), from.rotation * UnitQuaternion::from_scaled_axis(rotation))
}

/// A pose shifted in the world frame and rotated in the body frame.
pub fn moved(pose: &Isometry3<f64>, shift: &Vector3<f64>, rotation: &Vector3<f64>) -> Isometry3<f64> {
    let mut rotation = pose.rotation * UnitQuaternion::from_scaled_axis(*rotation);
    rotation.renormalize_fast();
    Isometry3::from_parts((pose.translation.vector + shift).into(), rotation)
}
