//! Distances that cannot be computed.

use crate::pose_chart::POSE;

/// A distance that could not be computed. At valid poses this has not been observed for `tau >= 1e-8`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("no convergence at pose {pose:?} with tau = {tau:e}: residual {residual:e}")]
pub struct DistanceError {
    /// Index of the pose in the batch.
    pub index: usize,
    /// The pose.
    pub pose: [f64; POSE],
    /// Smoothing parameter.
    pub tau: f64,
    /// Largest remaining relative error of `dual slack / tau`.
    pub residual: f64,
}
