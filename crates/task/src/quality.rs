//! Measures of a scenario: final errors, contact forces, penetration, and deviation from hard contact.

use crate::pose::{self, Pose};
use crate::task::AssemblyTask;

/// Contact of one pair at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// Smoothed distance `Phi_tau` (m).
    pub distance: f64,
    /// Normal force (N), the mean over the step that ends here.
    pub force: f64,
}

/// Final errors and extremes of one scenario.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Quality {
    /// Distance of the final position from the goal (m).
    pub position_error: f64,
    /// Angle between the final orientation and the goal (rad).
    pub orientation_error: f64,
    /// Deepest penetration of the exact shapes (m), `None` when they never penetrate.
    pub penetration: Option<Peak>,
    /// Largest absolute product of a contact force and the exact distance at the end of its step (N m). It is zero for
    /// hard contact, where only shapes that touch exert forces. `None` when there is no force.
    pub complementarity: Option<Peak>,
    /// Largest contact force (N): of rollouts the mean over [`FORCE_WINDOW`](crate::FORCE_WINDOW), in plans that over a
    /// step, in which forces are constant.
    pub max_force: f64,
}

/// A largest value, with the step and the pair where it occurs.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Peak {
    /// The value, above zero.
    pub value: f64,
    /// Number of the step, 0 for the start.
    pub step: usize,
    /// Index of the pair.
    pub pair: usize,
}

impl Quality {
    /// Measures of a motion with poses at k = 0..N and contacts at k = 1..N.
    pub fn new(task: &AssemblyTask, poses: &[Pose], contacts: &[Vec<Contact>]) -> Self {
        let arrays = pose::arrays(poses);
        let distances: Vec<Vec<f64>> = task.pairs.iter().map(|pair| pair.shapes.exact_distances(&arrays)).collect();
        let penetrations = distances.iter().enumerate().flat_map(|(pair, distances)| {
            distances.iter().enumerate().map(move |(step, distance)| Peak { value: -distance, step, pair })
        });
        let products = contacts.iter().zip(1..).flat_map(|(contacts, step)| {
            contacts.iter().zip(&distances).enumerate().map(move |(pair, (contact, distances))| Peak {
                value: (contact.force * distances[step]).abs(),
                step,
                pair,
            })
        });
        let error = poses[poses.len() - 1].error(&task.goal);
        Self {
            position_error: error.position,
            orientation_error: error.orientation,
            penetration: Peak::largest(penetrations),
            complementarity: Peak::largest(products),
            max_force: contacts.iter().flatten().map(|contact| contact.force).fold(0.0, f64::max),
        }
    }
}

impl Peak {
    /// The largest of all positive values.
    pub fn largest(peaks: impl Iterator<Item = Self>) -> Option<Self> {
        peaks.filter(|peak| peak.value > 0.0).max_by(|one, other| one.value.total_cmp(&other.value))
    }
}
