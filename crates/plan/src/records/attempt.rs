//! Results of the attempts at a problem.

use serde::{Deserialize, Serialize};

use crate::or_null;

/// Result of an attempt.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct AttemptRecord {
    /// The attempt, in words.
    pub planned: String,
    /// Its status, in words.
    pub status: String,
    /// Largest final distance of all scenarios from the goal.
    #[serde(with = "or_null")]
    pub position_error_m: f64,
    /// Iterations of the solver.
    pub iterations: usize,
    /// Wall time of the solver.
    pub wall_s: f64,
}
