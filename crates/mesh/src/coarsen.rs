//! Pieces with fewer halfspaces that are larger by no more than a tolerance.

use crate::cell::{Bound, Cell};

/// Drops halfspaces of a cell as long as it grows by no more than `allowed` (m) beyond any of those dropped, those with
/// the least growth first. Returns the coarser cell and its growth (m).
pub fn coarsen(cell: &Cell, root: &Cell, allowed: f64, tolerance: f64) -> (Cell, f64) {
    let mut coarse = cell.clone();
    let mut dropped: Vec<Bound> = Vec::new();
    let mut growth = 0.0;
    let is_side = |bound: &Bound| root.bounds.iter().any(|side| side.is(bound));
    loop {
        // In each round at most every other facet goes, so that neighbours that are dropped know of each other.
        let mut ratings: Vec<(usize, f64)> = (0..coarse.bounds.len())
            .filter(|&at| !is_side(&coarse.bounds[at]))
            .filter_map(|at| rating(&coarse, at, root, &dropped, tolerance).map(|growth| (at, growth)))
            .filter(|(_, growth)| *growth <= allowed)
            .collect();
        ratings.sort_by(|one, other| one.1.total_cmp(&other.1));
        let mut gone: Vec<usize> = Vec::new();
        for (at, _) in ratings {
            if gone.iter().all(|&other| !touch(&coarse, at, other, tolerance)) {
                gone.push(at);
            }
        }
        // Facets that do not touch may still have a gain in common: then fewer go.
        let next = loop {
            if gone.is_empty() {
                return (coarse, growth);
            }
            let left = (0..coarse.bounds.len()).filter(|at| !gone.contains(at)).map(|at| &coarse.bounds[at]);
            let next = root.cut_by(left, tolerance);
            let removed: Vec<Bound> = gone.iter().map(|&at| coarse.bounds[at]).chain(dropped.iter().copied()).collect();
            let grown = next.map(|next| (beyond(&next, &removed), next, removed));
            match grown {
                Some((reached, next, removed)) if reached <= allowed => break (reached, next, removed),
                _ => gone.truncate(gone.len() / 2),
            }
        };
        (growth, coarse, dropped) = next;
    }
}

/// How far a cell reaches beyond planes (m).
fn beyond(cell: &Cell, bounds: &[Bound]) -> f64 {
    bounds.iter().map(|bound| bound.plane.heights(cell.corners()).1).fold(0.0, f64::max)
}

/// The growth without a bound, an upper bound from its neighbours alone.
fn rating(cell: &Cell, at: usize, root: &Cell, dropped: &[Bound], tolerance: f64) -> Option<f64> {
    let neighbors: Vec<&Bound> = (0..cell.bounds.len())
        .filter(|&other| other != at && touch(cell, at, other, tolerance))
        .map(|other| &cell.bounds[other])
        .collect();
    let gain = root.cut(&cell.bounds[at].flipped(), tolerance).and_then(|gain| gain.cut_by(neighbors, tolerance));
    // Nothing is gained when the facet is thinner than the tolerance.
    gain.map_or(Some(0.0), |gain| Some(beyond(&gain, &[&[cell.bounds[at]], dropped].concat())))
}

/// Whether two facets of a cell have a corner in common.
fn touch(cell: &Cell, one: usize, other: usize, tolerance: f64) -> bool {
    let plane = &cell.bounds[other].plane;
    cell.polygons[one].iter().any(|corner| {
        plane.height(corner) >= -tolerance
            && cell.polygons[other].iter().any(|point| (point - corner).norm() <= 4.0 * tolerance)
    })
}
