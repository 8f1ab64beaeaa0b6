//! What a program's own linear solver must do to run inside Ipopt.

/// What a factorisation found.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Factorisation {
    /// The matrix has so many negative eigenvalues. Where that is more than the number of constraints, any larger
    /// number will do.
    Inertia {
        /// Their number.
        negative: usize,
    },
    /// The matrix is singular.
    Singular,
    /// No factors could be computed.
    Failed,
}

/// Why a linear solver cannot take matrices of a pattern.
pub type AnalysisError = Box<dyn std::error::Error + Send + Sync>;

/// A solver for the symmetric indefinite linear systems of Ipopt's iterations.
///
/// Their rows are, in this order: the variables, the slacks of the inequality constraints, the multipliers of the
/// equality constraints, the multipliers of the inequality constraints. A constraint whose bounds are equal is an
/// equality.
pub trait KktSolver {
    /// Name in results.
    fn name(&self) -> &str;

    /// Learns the pattern of all matrices that follow: entries of either triangle, those at the same place are summed.
    ///
    /// # Errors
    /// Why it cannot solve systems of this pattern.
    fn analyse(&mut self, dimension: usize, rows: &[usize], columns: &[usize]) -> Result<(), AnalysisError>;

    /// Factorises the matrix with these numbers.
    fn factorise(&mut self, values: &[f64]) -> Factorisation;

    /// Solves in place with the last factors; false when it cannot.
    fn solve(&mut self, values: &mut [f64]) -> bool;

    /// Has the next matrix factorised with more care: Ipopt could not do with the last solution.
    fn increase_quality(&mut self);
}

/// The linear solver of a solve.
pub enum LinearSystemSolver<'solver> {
    /// One of Ipopt's own: `mumps` or, where the user has the HSL library, `ma27`, `ma57` or `ma97`.
    Named(&'solver str),
    /// The program's, where [`crate::TAKES_OWN_SOLVER`].
    Own(&'solver mut dyn KktSolver),
}
