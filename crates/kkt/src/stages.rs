//! Factorisation of all stages, backward in time, and solves with its factors. Leaves depend on nothing but the matrix, so
//! that other threads eliminate them ahead of the fronts, which depend on each other.

use std::ops::ControlFlow;
use std::sync::{Mutex, PoisonError};

use pulp::Arch;
use workers::Workers;

use crate::fronts::Fronts;
use crate::leaf::Leaf;
use crate::leaf::factors::{FactoriseLeaf, LeafFactors, LeafUpdate, LeafWork};
use crate::leaf::solve::{LeafSolution, SolveLeaf};
use crate::pivot::Breakdown;
use crate::symbolic::Symbolic;

/// Outcome of a factorisation of all stages.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Factorised {
    /// Number of negative pivots.
    pub negative: usize,
    /// Whether all stages were factorised; false when it stopped at a surplus of negative pivots.
    pub complete: bool,
    /// Whether a stage was factorised as one dense front.
    pub general: bool,
}

/// Factors of all stages.
#[derive(Debug)]
pub struct Stages {
    arch: Arch,
    workers: Workers,
    /// By stage.
    leaves: Vec<Vec<LeafPart>>,
    fronts: Fronts,
    /// Scratch of stages whose leaves are not being eliminated, the last used last.
    spare: Mutex<Vec<LeafScratch>>,
}

/// Factors of a leaf, and its part of a solution.
#[derive(Debug)]
struct LeafPart {
    factors: LeafFactors,
    solution: LeafSolution,
}

/// Scratch of the leaves of one stage, with what they add to the front.
#[derive(Debug, Default)]
struct LeafScratch {
    updates: Vec<LeafUpdate>,
    work: LeafWork,
}

impl Stages {
    /// Allocates all factors.
    pub fn new(symbolic: &Symbolic, arch: Arch, workers: Workers) -> Self {
        let part = |leaf: &Leaf| LeafPart { factors: LeafFactors::new(leaf), solution: LeafSolution::new(leaf) };
        let of_stage = |index: usize| symbolic.leaves_of(index).iter().map(part).collect();
        Self {
            arch,
            workers,
            leaves: (0..symbolic.stages.len()).map(of_stage).collect(),
            fronts: Fronts::new(symbolic, arch),
            spare: Mutex::default(),
        }
    }

    /// Largest sum of the terms of a pivot of the last factorisation.
    pub fn largest_scale(&self) -> f64 {
        self.fronts.largest_scale()
    }

    /// Factorises the matrix with these values. With `stop_early` it stops as soon as the negative pivots prove that
    /// there are more negative eigenvalues than multipliers.
    pub fn factorise(
        &mut self,
        symbolic: &Symbolic,
        values: &[f64],
        stop_early: bool,
    ) -> Result<Factorised, Breakdown> {
        let Self { arch, workers, leaves, fronts, spare } = self;
        let (mut negative, mut multipliers) = (0, 0);
        let mut remaining = symbolic.stages.len();
        let (mut breakdown, mut surplus) = (None, false);
        fronts.begin();
        let eliminate = |(index, parts): (usize, &mut Vec<LeafPart>)| {
            let mut scratch = lock(spare).pop().unwrap_or_default();
            let found = scratch.eliminate(*arch, symbolic.leaves_of(index), values, parts);
            (found, scratch)
        };
        workers.in_order(leaves.iter_mut().enumerate().rev(), eliminate, |(found, scratch)| {
            remaining -= 1;
            let of_front = found
                .and_then(|of_leaves| Ok(of_leaves + fronts.factorise(symbolic, remaining, values, &scratch.updates)?));
            lock(spare).push(scratch);
            match of_front {
                Ok(found) => negative += found,
                Err(reason) => {
                    breakdown = Some(reason);
                    return ControlFlow::Break(());
                }
            }
            multipliers += symbolic.stages[remaining].multipliers;
            // The remaining stages have at least as many negative eigenvalues as multipliers.
            surplus = stop_early && symbolic.causal && negative > multipliers;
            if surplus { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        });
        if let Some(breakdown) = breakdown {
            return Err(breakdown);
        }
        let general = !(remaining..symbolic.stages.len()).all(|stage| fronts.is_fast(stage));
        Ok(Factorised { negative, complete: !surplus, general })
    }

    /// Solves with the factors for a right-hand side.
    pub fn solve(&mut self, symbolic: &Symbolic, right: &[f64], solution: &mut [f64]) {
        let Self { arch, workers, leaves, fronts, .. } = self;
        solution.copy_from_slice(right);
        let mut remaining = symbolic.stages.len();
        let stages = leaves.iter_mut().enumerate().rev();
        let sweep_ahead = |(index, parts)| sweep(parts, *arch, symbolic.leaves_of(index), right, false);
        workers.in_order(stages, sweep_ahead, |parts| {
            remaining -= 1;
            for (leaf, part) in symbolic.leaves_of(remaining).iter().zip(parts) {
                for (value, &row) in part.solution.boundary.iter().zip(&leaf.boundary) {
                    solution[row] += value;
                }
            }
            fronts.solve_forward(symbolic, remaining, solution);
            ControlFlow::Continue(())
        });
        for index in 0..symbolic.stages.len() {
            fronts.solve_backward(symbolic, index, solution);
        }
        let of_fronts: &[f64] = solution;
        workers.each(leaves.iter_mut().enumerate(), |(index, parts)| {
            sweep(parts, *arch, symbolic.leaves_of(index), of_fronts, true);
        });
        for part in leaves.iter().flatten() {
            for (value, &row) in part.solution.pivots.iter().zip(&part.factors.rows) {
                solution[row as usize] = *value;
            }
        }
    }
}

/// One sweep of a solve through the leaves of a stage.
fn sweep<'parts>(
    parts: &'parts mut Vec<LeafPart>,
    arch: Arch,
    leaves: &[Leaf],
    values: &[f64],
    backward: bool,
) -> &'parts [LeafPart] {
    for (leaf, LeafPart { factors, solution }) in leaves.iter().zip(parts.iter_mut()) {
        arch.dispatch(SolveLeaf { leaf, factors, values, solution, backward });
    }
    parts
}

impl LeafScratch {
    /// Eliminates the leaves of a stage; returns their number of negative pivots.
    fn eliminate(
        &mut self,
        arch: Arch,
        leaves: &[Leaf],
        values: &[f64],
        parts: &mut [LeafPart],
    ) -> Result<usize, Breakdown> {
        self.updates.resize_with(leaves.len(), LeafUpdate::default);
        let work = &mut self.work;
        let mut negative = 0;
        for ((leaf, LeafPart { factors, .. }), update) in leaves.iter().zip(parts).zip(&mut self.updates) {
            negative += arch.dispatch(FactoriseLeaf { arch, leaf, values, factors, update, work })?;
        }
        Ok(negative)
    }
}

fn lock<T>(mutex: &Mutex<T>) -> std::sync::MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}
