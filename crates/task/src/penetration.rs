//! How hard the contacts of a motion are, compared with real ones.

use crate::quality::Peak;
use crate::task::AssemblyTask;
use crate::trajectory::Trajectory;

/// Penetration that counts as hard contact, as a fraction of the clearance at the goal.
const HARD: f64 = 0.1;
/// Factor between the penetrations of two homotopy steps above which less smoothing does not help.
const STALLED: f64 = 0.9;

/// How deep the exact shapes penetrate in a motion, and the cause.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Penetration {
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

impl Penetration {
    /// The penetration in a motion planned with distances smoothed by `tau`. `before` is that of the previous homotopy
    /// step.
    pub fn of(task: &AssemblyTask, motion: &Trajectory, tau: f64, before: Option<&Trajectory>) -> Self {
        let Some((_, peak)) = motion.deepest_penetration() else { return Self::Hard };
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

    /// Factor by which a penetration (m) is deeper than hard contact allows.
    pub fn excess(task: &AssemblyTask, penetration: f64) -> f64 {
        penetration / (HARD * task.clearance(&task.goal))
    }
}

impl Trajectory {
    /// The deepest penetration of exact shapes with the index of its scenario, `None` where there is none.
    pub fn deepest_penetration(&self) -> Option<(usize, Peak)> {
        let peaks = self.scenarios.iter().enumerate();
        let peaks = peaks.filter_map(|(index, scenario)| Some((index, scenario.quality.penetration?)));
        peaks.max_by(|(_, one), (_, other)| one.value.total_cmp(&other.value))
    }

    /// Deepest penetration of the exact shapes in any scenario (m), 0 when there is none.
    pub fn max_penetration(&self) -> f64 {
        self.deepest_penetration().map_or(0.0, |(_, peak)| peak.value)
    }
}
