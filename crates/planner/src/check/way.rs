//! Whether the body gets from start to goal in clearance: a coarse search without offsets, oriented as the goal. At the
//! start there is room to turn.

use std::collections::{BTreeSet, VecDeque};

use serde::Serialize;
use task::AssemblyTask;

use crate::play::between;

/// Poses on the straight line.
const SAMPLES: usize = 200;
/// Cells of the grid along the way from start to goal, and poses that are looked at, at most.
const CELLS: f64 = 40.0;
const MOST_POSES: usize = 20_000;
/// Distances that are computed, about: with many pairs, fewer poses are looked at.
const MOST_DISTANCES: usize = 400_000;

/// What the search has found.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case", tag = "found")]
pub enum Way {
    /// The straight motion from start to goal touches nothing.
    Straight,
    /// Another one does not, in steps of a grid.
    OnGrid {
        /// Length of a step.
        step_m: f64,
    },
    /// None on this grid. There may be one in finer steps or with turns.
    None {
        /// Length of a step.
        step_m: f64,
        /// How near to the goal the search has come.
        nearest_m: f64,
    },
}

/// Looks for a way.
pub fn find(task: &AssemblyTask) -> Way {
    let is_free = |pose: &[f64; 7]| task.clearance(pose) >= 0.0;
    let most_poses = MOST_POSES.min(MOST_DISTANCES / task.pairs.len().max(1));
    let samples = SAMPLES.min(most_poses).max(1);
    if (0..=samples).all(|sample| is_free(&between(task, sample as f64 / samples as f64))) {
        return Way::Straight;
    }
    let path: [f64; 3] = std::array::from_fn(|axis| task.start[axis] - task.goal[axis]);
    let length = path.iter().map(|component| component * component).sum::<f64>().sqrt();
    let step_m = length / CELLS;
    let at = |cell: &[i32; 3]| -> [f64; 7] {
        let mut pose = task.goal;
        (0..3).for_each(|axis| pose[axis] += f64::from(cell[axis]) * step_m);
        pose
    };
    // From the goal outwards, where it is tight: a search that gets away has found a way.
    let is_away = |cell: &[i32; 3]| cell.iter().map(|index| index * index).sum::<i32>() as f64 >= CELLS * CELLS;
    let (mut waiting, mut known) = (VecDeque::from([[0; 3]]), BTreeSet::from([[0; 3]]));
    let mut farthest = 0.0f64;
    while let Some(cell) = waiting.pop_front() {
        if is_away(&cell) {
            return Way::OnGrid { step_m };
        }
        farthest = farthest.max(step_m * (cell.iter().map(|index| index * index).sum::<i32>() as f64).sqrt());
        for (axis, sign) in (0..3).flat_map(|axis| [(axis, -1), (axis, 1)]) {
            let mut next = cell;
            next[axis] += sign;
            if known.len() < most_poses && known.insert(next) && is_free(&at(&next)) {
                waiting.push_back(next);
            }
        }
    }
    Way::None { step_m, nearest_m: length - farthest }
}
