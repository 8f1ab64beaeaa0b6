//! Whether the contacts of a motion are as hard as real ones.

use crate::quality::Peak;
use crate::task::AssemblyTask;
use crate::trajectory::Trajectory;

/// Overlap that counts as hard contact, as a fraction of the clearance at the goal.
const HARD: f64 = 0.1;
/// Factor between the overlaps of two homotopy iterations above which less smoothing does not help.
const STALLED: f64 = 0.9;

/// How deep the exact shapes overlap in a motion, and what that means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Overlap {
    /// By less than a tenth of the clearance at the goal.
    Hard,
    /// By more: less smoothing reduces it.
    Soft,
    /// By more than smoothing explains, and less smoothing has hardly reduced it: the steps are too long for linearised
    /// distances.
    Stalled,
    /// By more, and at the start, which no smoothing changes.
    AtStart,
    /// The goal has no clearance to compare it with.
    NoClearance,
}

impl Overlap {
    /// Of a motion planned with distances smoothed by `tau`. `before` is that of the homotopy iteration before it.
    pub fn of(task: &AssemblyTask, motion: &Trajectory, tau: f64, before: Option<&Trajectory>) -> Self {
        let Some((_, peak)) = motion.deepest_overlap() else { return Self::Hard };
        let clearance = task.clearance(&task.goal);
        if clearance <= 0.0 {
            return Self::NoClearance;
        }
        if peak.value <= HARD * clearance {
            return Self::Hard;
        }
        if peak.step == 0 {
            return Self::AtStart;
        }
        let reach = tau * task.pairs[peak.pair].shapes.row_count() as f64;
        let same_grid = before.filter(|before| before.reference.len() == motion.reference.len());
        match same_grid {
            Some(before) if peak.value > reach.max(STALLED * before.max_penetration()) => Self::Stalled,
            _ => Self::Soft,
        }
    }

    /// Factor by which an overlap (m) is deeper than hard contact allows.
    pub fn excess(task: &AssemblyTask, overlap: f64) -> f64 {
        overlap / (HARD * task.clearance(&task.goal))
    }
}

impl Trajectory {
    /// The deepest overlap of exact shapes with the index of its scenario, if any overlap.
    pub fn deepest_overlap(&self) -> Option<(usize, Peak)> {
        let peaks = self.scenarios.iter().enumerate();
        let peaks = peaks.filter_map(|(index, scenario)| Some((index, scenario.quality.penetration?)));
        peaks.max_by(|(_, one), (_, other)| one.value.total_cmp(&other.value))
    }

    /// Deepest overlap of the exact shapes in any scenario (m), 0 when there is none.
    pub fn max_penetration(&self) -> f64 {
        self.deepest_overlap().map_or(0.0, |(_, peak)| peak.value)
    }
}
