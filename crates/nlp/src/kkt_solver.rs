//! The interface of a linear solver that the caller provides.

/// Outcome of a factorisation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Factorisation {
    /// The matrix is regular.
    Inertia {
        /// Number of negative eigenvalues. If it exceeds the number of constraints, any larger value will do.
        negative: usize,
    },
    /// The matrix is singular.
    Singular,
    /// No factors could be computed.
    Failed,
}

/// The reason why a linear solver does not support a pattern.
pub type AnalysisError = Box<dyn std::error::Error + Send + Sync>;

/// A solver for the symmetric indefinite linear systems of Ipopt's iterations.
///
/// Their rows are, in this order: the variables, the slacks of the inequality constraints, the multipliers of the
/// equality constraints, the multipliers of the inequality constraints. A constraint whose bounds are equal is an
/// equality.
pub trait KktSolver {
    /// The name that results report.
    fn name(&self) -> &str;

    /// Takes the pattern of all later matrices: entries of either triangle; entries at the same position are summed.
    ///
    /// # Errors
    /// When it does not support the pattern.
    fn analyse(&mut self, dimension: usize, rows: &[usize], columns: &[usize]) -> Result<(), AnalysisError>;

    /// Factorises the matrix with these values.
    fn factorise(&mut self, values: &[f64]) -> Factorisation;

    /// Solves in place with the last factors; false when that fails.
    fn solve(&mut self, values: &mut [f64]) -> bool;

    /// Requests a more accurate factorisation of the next matrix, because the last solution was not accurate enough.
    fn increase_quality(&mut self);
}

/// The linear solver of a solve.
pub enum LinearSystemSolver<'solver> {
    /// One of Ipopt's own: `mumps` or, where the user has the HSL library, `ma27`, `ma57` or `ma97`.
    Named(&'solver str),
    /// The caller's; possible if [`crate::takes_own_solver`].
    Own(&'solver mut dyn KktSolver),
}
