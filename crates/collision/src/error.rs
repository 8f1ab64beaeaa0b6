//! Distances that cannot be computed.

use crate::contact::POSE;

/// A distance that could not be computed. This has not been seen for `tau >= 1e-8`.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[error("no convergence at pose {pose:?} with tau = {tau:e}: residual {residual:e}")]
pub struct DistanceError {
    /// Index of the pose in the batch.
    pub index: usize,
    /// The pose.
    pub pose: [f64; POSE],
    /// Smoothing.
    pub tau: f64,
    /// Largest relative error of `dual slack / tau` that remained.
    pub residual: f64,
}
