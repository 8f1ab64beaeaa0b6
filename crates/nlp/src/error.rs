//! Errors of a solve.

use crate::options::OptionValue;

/// The reason why a solve did not start.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SolveError {
    /// Ipopt rejects an option.
    #[error("Ipopt rejects the option {name} = {value}: unknown name, or a value of the wrong type or out of range")]
    Option {
        /// Its name.
        name: String,
        /// Its value.
        value: OptionValue,
    },
    /// A linear solver cannot be used.
    #[error("linear solver \"{name}\": {reason}")]
    LinearSolver {
        /// Its name.
        name: String,
        /// The reason.
        reason: String,
    },
    /// Sizes of the problem are inconsistent.
    #[error("invalid problem: {0}")]
    Problem(String),
}
