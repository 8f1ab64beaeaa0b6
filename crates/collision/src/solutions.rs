//! Solutions of a pair's distance problems, kept so that derivatives at the same poses need not solve them again.

use pulp::Simd;

use crate::interior_point::{Row, Solution};
use crate::lane::{Lane, array};
use crate::pose_chart::POSE;

/// Numbers of a solution besides those of its rows: common point and growth.
const PRIMAL: usize = 4;
/// Numbers of a row: dual and reciprocal slack.
const PER_ROW: usize = 2;

/// The solutions of one pair at the poses of the last request. A request for the same poses and smoothing takes them;
/// any other request replaces them. They do not change a bit of the results.
#[derive(Debug, Clone, Default)]
pub struct Solutions {
    poses: Vec<[f64; POSE]>,
    tau: f64,
    lanes: usize,
    rows: usize,
    /// Whether a group of poses, one per lane, is kept.
    kept: Vec<bool>,
    numbers: Vec<f64>,
}

impl Solutions {
    /// Forgets everything unless it belongs to these poses, smoothing and numbers of lanes and rows.
    pub(crate) fn prepare(&mut self, poses: &[[f64; POSE]], tau: f64, lanes: usize, rows: usize) {
        if (self.tau, self.lanes, self.rows) == (tau, lanes, rows) && self.poses == poses {
            return;
        }
        let groups = poses.len().div_ceil(lanes);
        (self.tau, self.lanes, self.rows) = (tau, lanes, rows);
        self.poses.clear();
        self.poses.extend_from_slice(poses);
        self.kept.clear();
        self.kept.resize(groups, false);
        self.numbers.resize(groups * lanes * (PRIMAL + PER_ROW * rows), 0.0);
    }

    /// Keeps the solution of a group.
    #[inline(always)]
    pub(crate) fn keep<S: Simd>(&mut self, group: usize, rows: &[Row<S>], solution: &Solution<S>) {
        self.kept[group] = true;
        let (numbers, _) = S::as_mut_simd_f64s(&mut self.numbers);
        let length = PRIMAL + PER_ROW * rows.len();
        let (primal, numbers) = numbers[group * length..][..length].split_at_mut(PRIMAL);
        let [x, y, z] = solution.point;
        for (target, value) in primal.iter_mut().zip([x, y, z, solution.growth]) {
            *target = value.register();
        }
        for (target, row) in numbers.chunks_exact_mut(PER_ROW).zip(rows) {
            (target[0], target[1]) = (row.dual.register(), row.inverse_slack.register());
        }
    }

    /// The solution of a group, if it is kept; `rows` hold its halfspaces and take its duals and slacks.
    #[inline(always)]
    pub(crate) fn restore<S: Simd>(&self, simd: S, group: usize, rows: &mut [Row<S>]) -> Option<Solution<S>> {
        if !self.kept[group] {
            return None;
        }
        let (numbers, _) = S::as_simd_f64s(&self.numbers);
        let length = PRIMAL + PER_ROW * rows.len();
        let (primal, numbers) = numbers[group * length..][..length].split_at(PRIMAL);
        for (kept, row) in numbers.chunks_exact(PER_ROW).zip(rows) {
            (row.dual, row.inverse_slack) = (Lane::new(simd, kept[0]), Lane::new(simd, kept[1]));
        }
        Some(Solution {
            point: array!(|axis| Lane::new(simd, primal[axis])),
            growth: Lane::new(simd, primal[3]),
            residual: Lane::splat(simd, 0.0),
            iterations: 0,
        })
    }
}
