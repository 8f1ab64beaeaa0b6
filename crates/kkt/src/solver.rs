//! The solver: factorisation by stages, with a general solver where that is not accurate enough.

use std::time::Instant;

use pulp::Arch;
use workers::Workers;

use crate::error::StructureError;
use crate::fallback::{Fallback, Outcome};
use crate::label::Label;
use crate::matrix::{Matrix, RowSum};
use crate::pivot::Breakdown;
use crate::report::{FallbackReason, Report};
use crate::stages::Stages;
use crate::symbolic::Symbolic;

/// Backward error above which a solution is refined.
const REFINE: f64 = 1e-11;
/// Backward error above which the general solver takes over.
const POOR: f64 = 1e-6;
/// Maximum number of steps of iterative refinement.
const REFINEMENTS: usize = 3;

/// Outcome of a factorisation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Factorisation {
    /// The matrix is regular.
    Inertia {
        /// Number of negative eigenvalues: exact unless it exceeds the number of multipliers, else a lower bound that
        /// exceeds it too.
        negative: usize,
    },
    /// The matrix is singular.
    Singular,
    /// No factors could be computed.
    Failed,
}

/// The factors that are available.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Factors {
    None,
    Stages,
    /// Of the last stages only: there were too many negative pivots to continue.
    SomeStages,
    General,
}

/// A solver for symmetric indefinite matrices of one pattern.
pub struct StageSolver {
    matrix: Matrix,
    stages: Result<(Symbolic, Stages), StructureError>,
    general: Fallback,
    factors: Factors,
    more_quality: bool,
    report: Report,
    residual: Vec<f64>,
    sums: Vec<RowSum>,
    solution: Vec<f64>,
    correction: Vec<f64>,
}

impl StageSolver {
    /// Plans the elimination of matrices with entries at the given positions (in either triangle; entries at the same
    /// position are summed). A pattern that does not match the labels is left to the general solver: see
    /// [`StageSolver::structure_error`].
    ///
    /// # Errors
    /// When labels, rows and columns do not describe a matrix.
    pub fn new(labels: &[Label], rows: &[usize], columns: &[usize]) -> Result<Self, StructureError> {
        Self::with_arch(labels, rows, columns, Arch::new(), Workers::default())
    }

    /// The same with some threads; they do not affect results.
    ///
    /// # Errors
    /// See [`StageSolver::new`].
    pub fn with_workers(
        labels: &[Label],
        rows: &[usize],
        columns: &[usize],
        workers: Workers,
    ) -> Result<Self, StructureError> {
        Self::with_arch(labels, rows, columns, Arch::new(), workers)
    }

    /// The same for a given instruction set.
    ///
    /// # Errors
    /// See [`StageSolver::new`].
    pub fn with_arch(
        labels: &[Label],
        rows: &[usize],
        columns: &[usize],
        arch: Arch,
        workers: Workers,
    ) -> Result<Self, StructureError> {
        let dimension = labels.len();
        check(dimension, rows, columns)?;
        let matrix = Matrix::new(dimension, rows, columns);
        let lower_rows = &matrix.columns.row_idx;
        let lower_columns = matrix.column_indices();
        let stages = Symbolic::new(labels, lower_rows, &lower_columns).map(|symbolic| {
            let stages = Stages::new(&symbolic, arch, workers);
            (symbolic, stages)
        });
        Ok(Self {
            matrix,
            stages,
            general: Fallback::default(),
            factors: Factors::None,
            more_quality: false,
            report: Report::default(),
            residual: vec![0.0; dimension],
            sums: vec![RowSum::default(); dimension],
            solution: vec![0.0; dimension],
            correction: vec![0.0; dimension],
        })
    }

    /// Number of rows.
    pub fn dimension(&self) -> usize {
        self.residual.len()
    }

    /// The reason why all matrices go to the general solver, if they do.
    pub fn structure_error(&self) -> Option<&StructureError> {
        self.stages.as_ref().err()
    }

    /// Statistics so far.
    pub fn report(&self) -> &Report {
        &self.report
    }

    /// Factorises the matrix with these values at the positions given to [`StageSolver::new`].
    pub fn factorise(&mut self, values: &[f64]) -> Factorisation {
        let begin = Instant::now();
        self.report.factorisations += 1;
        self.matrix.fill(values);
        let outcome = if std::mem::take(&mut self.more_quality) {
            self.general.increase_quality();
            self.factorise_generally(FallbackReason::Quality)
        } else {
            self.factorise_stages(true)
        };
        self.report.factorisation_seconds += begin.elapsed().as_secs_f64();
        outcome
    }

    /// Requests a more accurate factorisation of the next matrix.
    pub fn increase_quality(&mut self) {
        self.more_quality = true;
    }

    fn factorise_stages(&mut self, stop_early: bool) -> Factorisation {
        let Ok((symbolic, stages)) = &mut self.stages else {
            return self.factorise_generally(FallbackReason::Structure);
        };
        let found = match stages.factorise(symbolic, &self.matrix.columns.values, stop_early) {
            Ok(found) => found,
            Err(Breakdown::Uncertain) => return self.factorise_generally(FallbackReason::UncertainPivot),
            Err(Breakdown::NotFinite) => return self.factorise_generally(FallbackReason::NotFinite),
        };
        let largest = self.matrix.largest();
        if largest > 0.0 {
            self.report.element_growth = self.report.element_growth.max(stages.largest_scale() / largest);
        }
        self.report.fast_path += usize::from(!found.general);
        self.report.general_path += usize::from(found.general);
        self.report.early_exits += usize::from(!found.complete);
        self.factors = if found.complete { Factors::Stages } else { Factors::SomeStages };
        let negative = if found.complete { found.negative } else { self.dimension() };
        Factorisation::Inertia { negative }
    }

    fn factorise_generally(&mut self, reason: FallbackReason) -> Factorisation {
        self.report.fallbacks.count(reason);
        self.factors = Factors::None;
        // The general solver would fail too.
        if !self.matrix.largest().is_finite() {
            return Factorisation::Failed;
        }
        match self.general.factorise(&self.matrix) {
            Outcome::Done(negative) => {
                self.factors = Factors::General;
                Factorisation::Inertia { negative }
            }
            Outcome::Singular => Factorisation::Singular,
            Outcome::Failed => Factorisation::Failed,
        }
    }

    /// Solves in place with the last factorisation; false when it left no usable factors.
    pub fn solve(&mut self, values: &mut [f64]) -> bool {
        let begin = Instant::now();
        self.report.solves += 1;
        if self.factors == Factors::SomeStages {
            self.factorise_stages(false);
        }
        let solved = match self.factors {
            Factors::Stages => self.solve_stages(values) || self.solve_generally(values, true),
            Factors::General => self.solve_generally(values, false),
            Factors::None | Factors::SomeStages => false,
        };
        self.report.solve_seconds += begin.elapsed().as_secs_f64();
        solved
    }

    /// Solves with the factors of the stages and refines until the residual is small. If it stays large, restores the
    /// right-hand side and returns false.
    fn solve_stages(&mut self, values: &mut [f64]) -> bool {
        let Ok((symbolic, stages)) = &mut self.stages else { return false };
        stages.solve(symbolic, values, &mut self.solution);
        let mut error = self.matrix.residual(&self.solution, values, &mut self.residual, &mut self.sums);
        for _ in 0..REFINEMENTS {
            if error <= REFINE || !error.is_finite() {
                break;
            }
            self.report.refinements += 1;
            stages.solve(symbolic, &self.residual, &mut self.correction);
            for (solution, correction) in self.solution.iter_mut().zip(&self.correction) {
                *solution += correction;
            }
            let refined = self.matrix.residual(&self.solution, values, &mut self.residual, &mut self.sums);
            let stalled = refined > 0.5 * error;
            error = refined;
            if stalled {
                break;
            }
        }
        if error.is_nan() || error > POOR {
            return false;
        }
        self.report.largest_residual = self.report.largest_residual.max(error);
        values.copy_from_slice(&self.solution);
        true
    }

    fn solve_generally(&mut self, values: &mut [f64], factorise: bool) -> bool {
        if factorise {
            let outcome = self.factorise_generally(FallbackReason::Residual);
            if !matches!(outcome, Factorisation::Inertia { .. }) {
                return false;
            }
        }
        self.general.solve(&self.matrix, values)
    }
}

fn check(dimension: usize, rows: &[usize], columns: &[usize]) -> Result<(), StructureError> {
    if rows.len() != columns.len() {
        return Err(StructureError::Length { rows: rows.len(), columns: columns.len() });
    }
    for (entry, (&row, &column)) in rows.iter().zip(columns).enumerate() {
        if row.max(column) >= dimension {
            return Err(StructureError::Range { entry, row, column, dimension });
        }
    }
    Ok(())
}
