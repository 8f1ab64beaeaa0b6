//! Search for a path in clearance from start to goal: without offsets, oriented as the goal. At the start there is room
//! to rotate.

use std::collections::{BTreeSet, VecDeque};

use nalgebra::Vector3;
use plan::clearance::Clearance;
use serde::Serialize;
use task::AssemblyTask;

/// Cells of the grid along the path from start to goal, and largest number of cells that are searched.
const CELLS: f64 = 40.0;
const MOST_CELLS: usize = 20_000;
/// Distances that are computed in a search, about: with many pairs, fewer cells are looked at.
const MOST_DISTANCES: usize = 2_000_000;
/// Half the diagonal of a cell, in its edges.
const HALF_DIAGONAL: f64 = 0.866_025_403_784_438_7;
/// Cells along the path of the finer grids that show whether there is no path at all.
const FINER_CELLS: [f64; 3] = [CELLS, 3.0 * CELLS, 9.0 * CELLS];

/// Result of the search.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[serde(rename_all = "snake_case", tag = "found")]
pub enum ClearPath {
    /// The straight motion from start to goal touches nothing.
    Straight,
    /// Another one does not, in steps of a grid.
    OnGrid {
        /// Length of a step.
        step_m: f64,
    },
    /// None on this grid. There may be one in finer steps or with rotations.
    None {
        /// Length of a step.
        step_m: f64,
        /// How near to the start the search has come.
        nearest_m: f64,
    },
    /// No path without rotations exists: the environment encloses the body at its goal.
    Enclosed {
        /// Largest distance from the goal that the body reaches.
        farthest_m: f64,
    },
}

/// Searches for a path.
pub fn find(task: &AssemblyTask) -> ClearPath {
    let (goal, path) = (task.goal.position(), task.start.position() - task.goal.position());
    let (length, step_m) = (path.norm(), path.norm() / CELLS);
    let mut clearance = Clearance::new(task);
    let straight = path.try_normalize(0.0).unwrap_or_default();
    if clearance.at(&goal) >= 0.0 && clearance.travel(&goal, &straight, length).is_none() {
        return ClearPath::Straight;
    }
    let mut grid = Grid { most: MOST_CELLS.min(MOST_DISTANCES / task.pairs.len().max(1)), goal, length, clearance };
    let found = grid.flood(step_m, 0.0, |offset| offset.abs().sum() == 1);
    if found.is_away {
        return ClearPath::OnGrid { step_m };
    }
    // Any path leads through cells whose centres are no deeper inside the environment than this.
    let inside = (-grid.clearance.at(&goal)).max(0.0);
    let encloses = |step: f64| {
        let search = grid.flood(step, inside + HALF_DIAGONAL * step, |_| true);
        (!search.is_away && search.is_whole).then_some(search.farthest_m)
    };
    let enclosed = FINER_CELLS.map(|cells| length / cells).into_iter().find_map(encloses);
    match enclosed {
        Some(farthest_m) => ClearPath::Enclosed { farthest_m },
        None => ClearPath::None { step_m, nearest_m: length - found.farthest_m },
    }
}

/// A grid around the goal.
struct Grid<'task> {
    /// Most cells that are looked at.
    most: usize,
    goal: Vector3<f64>,
    /// Distance from the goal (m) at which the body is out.
    length: f64,
    clearance: Clearance<'task>,
}

/// Result of a search on a grid.
struct Flood {
    /// Whether it gets as far from the goal as the start is.
    is_away: bool,
    /// Whether it has looked at all that it can reach.
    is_whole: bool,
    /// Largest distance from the goal (m).
    farthest_m: f64,
}

impl Grid<'_> {
    /// Searches from the goal outwards, where it is tight, in steps of some length (m) to the selected neighbours of a
    /// cell, as long as parts penetrate by no more than some depth (m).
    fn flood(&mut self, step: f64, penetration: f64, is_neighbour: impl Fn(&Vector3<i32>) -> bool) -> Flood {
        let sides = || -1..=1;
        let neighbours: Vec<Vector3<i32>> = sides()
            .flat_map(|x| sides().flat_map(move |y| sides().map(move |z| Vector3::new(x, y, z))))
            .filter(|offset| *offset != Vector3::zeros() && is_neighbour(offset))
            .collect();
        let (mut waiting, mut known) = (VecDeque::from([Vector3::zeros()]), BTreeSet::from([[0; 3]]));
        let (mut farthest_m, mut is_whole) = (0.0f64, true);
        while let Some(cell) = waiting.pop_front() {
            let distance = step * cell.cast::<f64>().norm();
            farthest_m = farthest_m.max(distance);
            if distance >= self.length {
                return Flood { is_away: true, is_whole, farthest_m };
            }
            for next in neighbours.iter().map(|offset| cell + offset) {
                if known.len() >= self.most {
                    is_whole = false;
                } else if known.insert(next.into())
                    && self.clearance.at(&(self.goal + next.cast::<f64>() * step)) >= -penetration
                {
                    waiting.push_back(next);
                }
            }
        }
        Flood { is_away: false, is_whole, farthest_m }
    }
}
