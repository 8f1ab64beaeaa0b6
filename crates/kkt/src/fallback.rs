//! The general sparse solver that takes over where factorisation by stages is not accurate enough.

use feral::{FactorStatus, Solver};

use crate::matrix::Matrix;

/// Outcome of a factorisation by the general solver.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Outcome {
    /// Number of negative eigenvalues.
    Done(usize),
    Singular,
    Failed,
}

/// A multifrontal solver with delayed pivots, created on first use.
#[derive(Default)]
pub struct Fallback {
    solver: Option<Solver>,
}

impl Fallback {
    /// Factorises a matrix.
    pub fn factorise(&mut self, matrix: &Matrix) -> Outcome {
        // Sequential, so that the result does not depend on the machine's threads.
        let solver = self.solver.get_or_insert_with(|| Solver::new().with_parallel(false));
        match solver.factor(&matrix.columns, None) {
            FactorStatus::Singular => Outcome::Singular,
            FactorStatus::FatalError(_) => Outcome::Failed,
            FactorStatus::Success | FactorStatus::WrongInertia { .. } => match solver.inertia() {
                Some(inertia) if inertia.zero > 0 => Outcome::Singular,
                Some(inertia) => Outcome::Done(inertia.negative),
                None => Outcome::Failed,
            },
        }
    }

    /// Solves in place, with the solver's own refinement; false when it cannot.
    pub fn solve(&self, matrix: &Matrix, values: &mut [f64]) -> bool {
        let Some(solver) = &self.solver else { return false };
        match solver.solve_refined(&matrix.columns, values) {
            Ok(solution) => {
                values.copy_from_slice(&solution);
                true
            }
            Err(_) => false,
        }
    }

    /// Raises the pivot tolerance; false at its limit.
    pub fn increase_quality(&mut self) -> bool {
        self.solver.as_mut().is_some_and(Solver::increase_quality)
    }
}
