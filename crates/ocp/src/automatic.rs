//! Smoothing chosen from the shapes, the goal and the offsets, for those who do not want to choose it.
//!
//! Smoothing with `tau` lets parts overlap by about `n_g tau` per unit of the growth distance (`n_g` halfspaces of a pair),
//! which is called its reach here. While this is larger than the offsets, every scenario finds its way past edges that it
//! would otherwise get stuck at, or on the wrong side of; when it has become smaller than the clearance at the goal,
//! contacts are as hard as the task can tell.

use collision::Polytope;

use crate::task::AssemblyTask;

/// The first reach, in offsets. 1.2 offsets were seen to leave scenarios of a clamp on the wrong side of a wall, 4.8 never.
const OFFSETS: f64 = 4.0;
/// `sigma_1 / tau_1` of the paper's experiments.
const SIGMA_OF_TAU: f64 = 0.5;
/// A goal without clearance counts as one with this part of the thinnest part's thickness.
const LEAST_CLEARANCE: f64 = 0.01;

/// `tau_1` whose reach is four times the largest offset, and at least the thickness of the thinnest part.
pub fn first_tau(task: &AssemblyTask) -> f64 {
    let norm = |offset: &[f64; 3]| offset.iter().map(|component| component * component).sum::<f64>().sqrt();
    let offset = task.offsets.iter().map(norm).fold(0.0, f64::max);
    (OFFSETS * offset).max(thinnest(task)) / halfspaces(task)
}

/// `sigma_1` for a `tau_1`.
pub fn first_sigma(tau: f64) -> f64 {
    SIGMA_OF_TAU * tau
}

/// So many homotopy iterations bring the reach from that of `tau` below the clearance at the goal.
pub fn iterations(task: &AssemblyTask, tau: f64, tau_rate: f64) -> usize {
    let distance = |pair: &crate::ContactPair| pair.shapes.exact_distance(&task.goal);
    let clearance = task.pairs.iter().map(distance).fold(f64::INFINITY, f64::min);
    let last = clearance.max(LEAST_CLEARANCE * thinnest(task)) / halfspaces(task);
    1 + (last / tau).log(tau_rate).ceil().max(0.0) as usize
}

/// Fewest halfspaces of a pair.
fn halfspaces(task: &AssemblyTask) -> f64 {
    task.pairs.iter().map(|pair| pair.shapes.row_count()).min().unwrap_or(1) as f64
}

/// Thickness of the thinnest part (m).
fn thinnest(task: &AssemblyTask) -> f64 {
    let parts = task.pairs.iter().flat_map(|pair| [pair.shapes.body(), pair.shapes.environment()]);
    parts.map(thickness).fold(f64::INFINITY, f64::min)
}

/// Smallest distance of a facet and the vertex farthest behind it (m).
fn thickness(part: &Polytope) -> f64 {
    let depth = |(normal, offset): (&[f64; 3], &f64)| {
        let heights = part.vertices().iter().map(|vertex| (0..3).map(|axis| normal[axis] * vertex[axis]).sum());
        offset - heights.fold(f64::INFINITY, f64::min)
    };
    part.normals().iter().zip(part.offsets()).map(depth).fold(f64::INFINITY, f64::min)
}
